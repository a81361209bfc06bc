"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 108},
    {'p': 234},
    """
input k 46; input k 47; constant 1.0; input k 9; sub 3 2; input k 44; input k 56; input k 50; input k 51; input k
53; input k 48; input k 52; input k 54; input k 49; input k 45; input k 107; input k 0; div 2 16; mul 15 17;
constant 0.5; constant -0.5; input k 2; mul 20 21; input k 7; mul 23 23; mul 22 24; constant 4.0; input k 6; mul 15
23; add 27 28; mul 29 29; mul 26 30; constant -12.0; mul 29 32; add 31 33; constant 12.0; add 34 35; div 2 35; mul
36 37; input k 8; mul 39 39; constant 0.8; div 2 41; mul 40 42; add 38 43; div 2 44; mul 25 45; input k 62; input k
1; constant -6.000000000000002; constant -18.000000000000004; input k 5; mul 51 51; input k 4; mul 52 53; mul 50 54;
add 49 55; constant -0.09999999999999992; input k 3; mul 52 58; mul 57 59; add 56 60; constant 28.80000000000001;
mul 51 53; mul 62 63; constant -22.628571428571426; mul 53 65; constant -0.0571428571428573; mul 58 67; add 66 68;
constant 36.0; mul 63 70; constant -28.799999999999997; mul 53 72; constant 0.05714285714285805; mul 58 74; add 73
75; constant -50.400000000000006; mul 53 77; constant -1.1428571428571421; mul 58 79; add 78 80; constant
12.000000000000004; constant 36.000000000000014; mul 54 83; add 82 84; constant 1.1999999999999995; mul 59 86; add
85 87; constant -57.60000000000002; mul 63 89; constant 45.25714285714285; mul 53 91; constant 0.9142857142857148;
mul 58 93; add 92 94; constant -72.00000000000001; mul 63 96; constant 57.59999999999996; mul 53 98; constant
-1.7142857142857146; mul 58 100; add 99 101; constant 230.40000000000006; mul 53 103; constant 2.057142857142853;
mul 58 105; add 104 106; constant -388.80000000000024; mul 53 108; constant -7.71428571428571; mul 58 110; add 109
111; constant 259.2000000000001; mul 53 113; constant 12.342857142857142; mul 58 115; add 114 116; constant
-0.9999999999999998; mul 51 118; mul 51 52; mul 53 120; mul 118 121; add 119 122; constant -0.03333333333333334; mul
59 124; constant -2.399999999999998; mul 63 126; constant 0.45714285714285574; mul 53 128; constant
-0.019047619047619042; mul 58 130; add 129 131; constant 4.000000000000001; mul 35 54; add 133 134; constant
0.13333333333333333; mul 59 136; add 135 137; constant -14.400000000000006; mul 63 139; constant 13.714285714285712;
mul 53 141; constant 0.11428571428571417; mul 58 143; add 142 144; constant -30.000000000000007; mul 63 146; mul 51
58; sub 147 148; constant 21.599999999999998; mul 53 150; constant 0.6571428571428561; mul 58 152; add 151 153;
constant 35.20000000000001; mul 53 155; constant 2.438095238095238; mul 58 157; add 156 158; constant 72.0; mul 63
160; constant -57.599999999999994; mul 53 162; constant 0.1142857142857161; mul 58 164; add 163 165; constant
-151.20000000000002; mul 53 167; constant -3.428571428571426; mul 58 169; add 168 170; constant -36.00000000000001;
mul 63 172; constant 28.79999999999998; mul 53 174; constant -0.8571428571428573; mul 58 176; add 175 177; constant
-129.60000000000008; mul 53 179; constant -2.57142857142857; mul 58 181; add 180 182; constant 3.0; input k 25; mul
184 185; input k 26; constant 2.0; mul 187 188; input k 27; mul 188 190; input k 28; input k 29; input k 30; input k
10; mul 26 195; input k 11; mul 184 197; input k 12; mul 184 199; input k 13; mul 188 201; input k 14; mul 188 203;
input k 15; mul 188 205; input k 16; input k 17; input k 18; input k 19; constant -6.0; input k 55; input k 72;
input k 67; input k 69; input k 68; input k 70; sub 217 16; input k 35; mul 26 219; input k 36; mul 184 221; input k
37; mul 184 223; input k 38; mul 188 225; input k 39; mul 188 227; input k 40; input k 41; mul 184 229; mul 188 230;
input k 42; mul 26 233; input k 43; mul 184 235; input k 71; div 2 237; input k 73; input k 74; input k 75; input k
76; mul 19 242; constant 0.7142857142857143; sub 242 244; mul 243 245; input k 77; input k 78; input k 79; input k
61; mul 19 250; sub 250 244; mul 251 252; input k 80; input k 86; input k 82; input k 81; input k 83; input k 84;
sub 259 16; input k 85; div 2 261; input k 87; input k 88; input k 89; input k 90; mul 19 266; sub 266 244; mul 267
268; input k 91; input k 92; input k 93; input k 94; input k 57; input k 95; input k 96; input k 97; input k 98;
input k 63; input k 64; input k 65; mul 281 281; input k 103; input k 104; mul 3 188; mul 188 192; input k 31; mul
184 287; input k 32; mul 188 289; input k 33; mul 184 207; mul 188 208; input k 20; mul 26 294; input k 21; mul 184
296; input k 22; mul 188 298; input k 23; mul 6 212; input k 66; constant 2.4; mul 54 303; add 41 304; constant
0.019047619047619053; mul 59 306; add 305 307; constant -1.3714285714285719; mul 63 309; constant 1.371428571428571;
mul 53 311; constant 0.007256235827664402; mul 58 313; add 312 314; constant -4.799999999999996; mul 63 316;
constant 1.3714285714285672; mul 53 318; constant -0.05714285714285713; mul 58 320; add 319 321; constant
-7.200000000000003; mul 63 323; constant 7.199999999999999; mul 53 325; constant 0.2190476190476187; mul 58 327; add
326 328; constant -45.25714285714285; mul 53 330; constant -0.1142857142857146; mul 58 332; add 331 333; constant
-28.80000000000001; mul 63 335; mul 188 194; mul 188 291; input k 34; mul 184 339; mul 188 209; mul 184 210; mul 184
300; input k 24; mul 26 344; mul 21 41; input k 58; input k 59; input k 60; input k 105; input k 106; input k 99;
div 2 352; input k 100; div 2 354; input k 101; div 2 356; input k 102; div 2 358; mul 17 27; mul 61 360; mul 17 88;
mul 138 360; mul 17 61; add 283 284; mul 125 360; mul 17 35; mul 211 360; add 367 368; mul 21 369; mul 17 211; mul
26 360; add 371 372; mul 21 373; mul 27 374; add 370 375; mul 17 376; mul 23 374; mul 39 374; mul 23 61; mul 23 138;
mul 23 125; mul 23 211; mul 21 383; mul 23 26; mul 21 385; mul 27 386; add 384 387; mul 17 388; mul 23 386; mul 39
386; mul 302 353; mul 302 355; mul 302 357; mul 302 359; mul 39 61; mul 39 138; mul 39 125; mul 26 39; mul 21 399;
mul 23 400; mul 39 211; mul 21 402; mul 27 400; add 403 404; mul 17 405; mul 39 400; add 346 407; neg 347; neg 348;
neg 349; neg 350; neg 351; mul 275 302; mul 276 302; mul 277 302; mul 278 302; mul 17 18; mul 51 188; mul 45 46; mul
29 188; mul 23 188; mul 39 188; mul 188 281; store p 0 0; store p 1 3; store p 2 4; store p 3 1; store p 4 5; store
p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p 11 12; store p 12 13; store p 13
14; store p 14 18; store p 15 46; store p 16 47; store p 17 17; store p 18 48; store p 19 61; store p 20 27; store p
21 23; store p 22 39; store p 23 64; store p 24 69; store p 25 71; store p 26 76; store p 27 81; store p 28 88;
store p 29 90; store p 30 95; store p 31 97; store p 32 102; store p 33 107; store p 34 112; store p 35 117; store p
36 123; store p 37 125; store p 38 127; store p 39 132; store p 40 138; store p 41 140; store p 42 145; store p 43
149; store p 44 154; store p 45 159; store p 46 161; store p 47 166; store p 48 171; store p 49 173; store p 50 178;
store p 51 183; store p 52 186; store p 53 189; store p 54 191; store p 55 192; store p 56 193; store p 57 194;
store p 58 196; store p 59 198; store p 60 200; store p 61 202; store p 62 204; store p 63 206; store p 64 207;
store p 65 208; store p 66 209; store p 67 210; store p 68 21; store p 69 220; store p 70 222; store p 71 224; store
p 72 226; store p 73 228; store p 74 229; store p 75 230; store p 76 212; store p 77 218; store p 78 16; store p 79
221; store p 80 227; store p 81 231; store p 82 232; store p 83 234; store p 84 236; store p 85 223; store p 86 235;
store p 87 216; store p 88 214; store p 89 238; store p 90 215; store p 91 213; store p 92 239; store p 93 240;
store p 94 241; store p 95 242; store p 96 246; store p 97 247; store p 98 248; store p 99 249; store p 100 250;
store p 101 253; store p 102 254; store p 103 260; store p 104 256; store p 105 257; store p 106 262; store p 107
258; store p 108 255; store p 109 263; store p 110 264; store p 111 265; store p 112 266; store p 113 269; store p
114 270; store p 115 271; store p 116 272; store p 117 273; store p 118 274; store p 119 275; store p 120 276; store
p 121 277; store p 122 278; store p 123 279; store p 124 280; store p 125 282; store p 126 283; store p 127 284;
store p 128 285; store p 129 187; store p 130 286; store p 131 288; store p 132 290; store p 133 291; store p 134
197; store p 135 203; store p 136 292; store p 137 293; store p 138 295; store p 139 297; store p 140 299; store p
141 300; store p 142 301; store p 143 302; store p 144 308; store p 145 310; store p 146 315; store p 147 317; store
p 148 322; store p 149 324; store p 150 329; store p 151 334; store p 152 336; store p 153 190; store p 154 337;
store p 155 289; store p 156 338; store p 157 340; store p 158 199; store p 159 341; store p 160 342; store p 161
296; store p 162 343; store p 163 345; store p 164 185; store p 165 287; store p 166 339; store p 167 346; store p
168 347; store p 169 348; store p 170 349; store p 171 350; store p 172 351; store p 173 353; store p 174 355; store
p 175 357; store p 176 359; store p 177 361; store p 178 360; store p 179 362; store p 180 363; store p 181 364;
store p 182 365; store p 183 366; store p 184 377; store p 185 378; store p 186 379; store p 187 380; store p 188
381; store p 189 382; store p 190 389; store p 191 390; store p 192 391; store p 193 392; store p 194 393; store p
195 394; store p 196 395; store p 197 396; store p 198 397; store p 199 398; store p 200 401; store p 201 406; store
p 202 408; store p 203 409; store p 204 410; store p 205 411; store p 206 412; store p 207 413; store p 208 414;
store p 209 415; store p 210 416; store p 211 417; store p 212 418; store p 213 24; store p 214 45; store p 215 52;
store p 216 51; store p 217 120; store p 218 53; store p 219 419; store p 220 58; store p 221 420; store p 222 421;
store p 223 15; store p 224 422; store p 225 22; store p 226 423; store p 227 251; store p 228 252; store p 229 424;
store p 230 243; store p 231 245; store p 232 267; store p 233 268
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 234},
    {'f': 18, 'a': 324, 'b': 36, 'by_c': 234},
    """
input x 1; input p 0; constant 1.0; input x 2; input p 1; mul 3 4; mul 3 5; add 2 6; sqrt 7; div 2 8; input p 2; mul
3 10; mul 3 11; add 2 12; sqrt 13; mul 8 14; div 2 15; mul 9 16; input p 3; mul 17 18; mul 17 19; add 1 20; input p
4; input p 5; mul 9 14; mul 17 24; mul 23 25; mul 26 26; input p 6; input x 0; mul 28 29; input p 7; mul 3 31; add
30 32; input p 8; input x 4; mul 34 35; add 33 36; mul 3 9; mul 17 38; mul 23 39; add 37 40; mul 41 41; add 27 42;
mul 22 43; add 21 44; input p 9; input p 10; mul 29 47; mul 3 34; add 48 49; input p 11; mul 35 51; add 50 52; mul
53 53; mul 22 54; add 46 55; mul 45 56; mul 41 53; mul 22 58; mul 59 59; sub 57 60; input p 12; mul 29 62; mul 3 28;
add 63 64; mul 35 47; add 65 66; mul 67 67; add 2 68; mul 22 69; mul 61 70; input p 13; mul 41 67; add 26 73; mul 22
74; add 72 75; mul 56 76; mul 53 67; mul 22 78; mul 59 79; sub 77 80; mul 76 81; sub 71 82; mul 59 76; mul 45 79;
sub 84 85; mul 79 86; add 83 87; div 2 88; mul 61 89; input c 0; input c 2; input u 0; mul 92 93; add 91 94; input c
3; input u 1; mul 96 97; add 95 98; input p 14; mul 29 100; sub 3 101; input c 9; constant 0.5; input c 10; mul 104
105; mul 102 106; sub 103 107; input c 11; mul 93 109; add 108 110; input c 12; mul 97 112; add 111 113; mul 102
114; add 99 115; input c 4; input c 5; mul 102 118; sub 117 119; input c 6; mul 93 121; add 120 122; input c 7; mul
97 124; add 123 125; input c 8; input p 15; max 127 128; input x 3; mul 0 100; sub 130 131; mul 129 132; sub 126
133; mul 100 134; sub 116 135; input p 16; input c 1; add 137 138; constant 0.0; max 139 140; mul 0 141; sub 136
142; input p 17; input p 18; input p 19; input p 20; mul 29 144; mul 147 148; input p 21; mul 3 150; add 149 151;
input p 22; mul 35 153; add 152 154; mul 146 155; input p 23; mul 35 155; mul 157 158; add 156 159; input p 24; mul
35 158; mul 161 162; add 160 163; input p 25; mul 155 155; mul 165 166; add 164 167; input p 26; mul 35 166; mul 169
170; add 168 171; input p 27; mul 155 166; mul 173 174; add 172 175; input p 28; mul 148 177; add 176 178; input p
29; mul 35 148; mul 180 181; add 179 182; input p 30; mul 35 181; mul 184 185; add 183 186; input p 31; mul 148 155;
mul 188 189; add 187 190; input p 32; mul 35 189; mul 192 193; add 191 194; input p 33; mul 155 189; mul 196 197;
add 195 198; input p 34; mul 148 148; mul 155 201; mul 200 202; add 199 203; input p 35; mul 148 201; mul 205 206;
add 204 207; input p 36; input p 37; mul 35 210; add 209 211; input p 38; mul 35 35; mul 213 214; add 212 215; input
p 39; mul 35 214; mul 217 218; add 216 219; input p 40; mul 155 221; add 220 222; input p 41; mul 158 224; add 223
225; input p 42; mul 162 227; add 226 228; input p 43; mul 166 230; add 229 231; input p 44; mul 170 233; add 232
234; input p 45; mul 174 236; add 235 237; mul 146 148; add 238 239; mul 157 181; add 240 241; mul 161 185; add 242
243; input p 46; mul 189 245; add 244 246; input p 47; mul 193 248; add 247 249; input p 48; mul 197 251; add 250
252; input p 49; mul 201 254; add 253 255; input p 50; mul 35 201; mul 257 258; add 256 259; mul 196 202; add 260
261; input p 51; mul 206 263; add 262 264; mul 147 265; add 208 266; input p 52; constant 0.5249999999999999;
constant -0.5249999999999999; max 270 148; min 269 271; constant 0.35; sub 272 273; max 140 274; mul 275 275;
constant -0.35; sub 277 272; max 140 278; mul 279 279; sub 276 280; div 2 273; mul 281 282; sub 272 283; mul 284
284; mul 268 285; input p 53; constant 0.8999999999999999; constant -0.8999999999999999; max 289 3; min 288 290;
constant 0.6; sub 291 292; max 140 293; mul 294 294; constant -0.6; sub 296 291; max 140 297; mul 298 298; sub 295
299; div 2 292; mul 300 301; sub 291 302; mul 284 303; mul 287 304; add 286 305; input p 54; constant
2.4000000000000004; constant -2.4000000000000004; max 309 35; min 308 310; constant 1.6; sub 311 312; max 140 313;
mul 314 314; constant -1.6; sub 316 311; max 140 317; mul 318 318; sub 315 319; div 2 312; mul 320 321; sub 311 322;
mul 284 323; mul 307 324; add 306 325; input p 55; mul 303 303; mul 327 328; add 326 329; input p 56; mul 303 323;
mul 331 332; add 330 333; input p 57; mul 323 323; mul 335 336; add 334 337; mul 323 336; mul 338 339; input p 58;
mul 284 285; mul 341 342; input p 59; mul 285 303; mul 344 345; add 343 346; input p 60; mul 285 323; mul 348 349;
add 347 350; input p 61; mul 303 304; mul 352 353; add 351 354; input p 62; mul 304 323; mul 356 357; add 355 358;
input p 63; mul 323 324; mul 360 361; add 359 362; input p 64; mul 303 328; mul 364 365; add 363 366; input p 65;
mul 323 328; mul 368 369; add 367 370; input p 66; mul 323 332; mul 372 373; add 371 374; input p 67; mul 339 376;
add 375 377; add 340 378; constant 5.714285714285714; add 275 279; mul 380 381; sub 2 382; mul 379 383; add 267 384;
mul 145 385; input p 68; constant 12.0; mul 0 144; mul 388 389; constant -6.0; mul 147 389; mul 130 150; add 392
393; input x 5; mul 153 395; add 394 396; mul 391 397; add 390 398; mul 387 399; mul 389 391; constant 4.0; mul 397
402; add 401 403; mul 387 404; mul 147 405; add 400 406; add 386 407; mul 144 408; input p 69; mul 342 410; input p
70; mul 345 412; add 411 413; input p 71; mul 349 415; add 414 416; input p 72; mul 353 418; add 417 419; input p
73; mul 357 421; add 420 422; input p 74; mul 365 424; add 423 425; input p 75; mul 369 427; add 426 428; mul 383
429; add 67 430; input p 76; input p 77; mul 29 67; mul 3 37; add 434 435; mul 35 53; add 436 437; mul 104 438;
input p 78; constant 0.25; mul 284 429; input p 79; mul 342 443; mul 345 418; add 444 445; input p 80; mul 349 447;
add 446 448; input p 81; mul 353 450; add 449 451; input p 82; mul 357 453; add 452 454; input p 83; mul 365 456;
add 455 457; input p 84; mul 369 459; add 458 460; mul 303 461; add 442 462; input p 85; mul 342 464; mul 345 447;
add 465 466; mul 353 427; add 467 468; input p 86; mul 365 470; add 469 471; mul 323 472; add 463 473; mul 441 474;
mul 440 475; add 439 476; add 433 477; input p 87; mul 24 479; add 478 480; input p 88; mul 38 482; sub 481 483;
input p 89; mul 24 482; input p 90; sub 486 487; mul 38 479; add 488 489; sub 490 29; mul 491 491; mul 484 484; add
492 493; sqrt 494; mul 485 495; sqrt 496; div 2 497; mul 498 498; mul 485 499; mul 484 500; input p 91; constant
2.0; mul 496 503; mul 499 503; mul 499 505; sub 504 506; mul 502 507; constant 0.3; constant -0.3; constant 1.4; sub
496 511; max 510 512; min 509 513; input p 92; input p 93; mul 514 516; add 515 517; mul 514 518; add 2 519; mul 508
520; input p 94; mul 93 522; input p 95; input p 96; mul 512 525; add 524 526; mul 512 527; add 2 528; mul 523 529;
sub 521 530; mul 485 531; input p 97; input x 6; mul 533 534; input p 98; input x 8; mul 536 537; add 535 538; input
p 99; input x 10; mul 540 541; add 539 542; constant -0.5; mul 498 544; mul 498 545; mul 498 546; mul 485 547; input
p 100; input p 101; mul 512 550; add 549 551; mul 512 552; add 2 553; mul 548 554; mul 543 555; add 532 556; input p
102; mul 555 558; mul 555 559; sub 480 483; mul 491 561; add 486 489; mul 484 563; sub 562 564; mul 500 565; mul 17
566; mul 130 567; mul 491 500; mul 0 569; sub 568 570; mul 0 431; constant 3.3333333333333335; add 294 298; mul 573
574; sub 2 575; mul 461 576; mul 440 577; add 37 578; mul 130 579; add 572 580; constant 1.25; add 314 318; mul 582
583; sub 2 584; mul 472 585; mul 440 586; add 53 587; mul 395 588; add 581 589; mul 501 590; add 571 591; mul 560
592; add 557 593; mul 501 594; input p 103; add 477 596; input p 104; mul 24 598; add 597 599; input p 105; mul 38
601; add 600 602; input p 106; mul 38 598; mul 24 601; input p 107; sub 606 607; sub 605 608; sub 609 29; mul 610
610; mul 603 603; add 611 612; sqrt 613; mul 604 614; sqrt 615; div 2 616; mul 617 617; mul 604 618; mul 603 619;
input p 108; mul 503 615; mul 503 618; mul 618 623; sub 622 624; mul 621 625; sub 615 511; max 510 627; min 509 628;
input p 109; input p 110; mul 629 631; add 630 632; mul 629 633; add 2 634; mul 626 635; input p 111; mul 97 637;
input p 112; input p 113; mul 627 640; add 639 641; mul 627 642; add 2 643; mul 638 644; sub 636 645; mul 604 646;
input p 114; input x 7; mul 648 649; input p 115; input x 9; mul 651 652; add 650 653; input p 116; input x 11; mul
655 656; add 654 657; mul 544 617; mul 617 659; mul 617 660; mul 604 661; mul 550 627; add 549 663; mul 627 664; add
2 665; mul 662 666; mul 658 667; add 647 668; input p 117; mul 667 670; mul 667 671; add 599 602; mul 610 673; sub
606 605; mul 603 675; add 674 676; mul 619 677; mul 17 678; mul 130 679; mul 610 619; mul 0 681; sub 680 682; mul
590 620; add 683 684; mul 672 685; add 669 686; mul 620 687; add 595 688; sub 432 689; mul 431 690; sub 409 691; mul
569 594; mul 681 687; add 693 694; sub 692 695; sub 143 696; input p 118; input p 119; input z 0; mul 699 700; input
p 120; input z 1; mul 702 703; add 701 704; input p 121; input z 2; mul 706 707; add 705 708; input p 122; input z
3; mul 710 711; add 709 712; sub 698 713; input p 123; abs 0; mul 715 716; mul 0 717; input p 124; mul 0 719; mul 0
0; input p 125; add 721 722; sqrt 723; div 2 724; mul 720 725; add 718 726; sub 714 727; add 697 728; input p 126;
input x 12; sub 29 731; mul 730 732; input p 127; input x 13; sub 29 735; mul 734 736; add 733 737; sub 729 738; mul
0 62; mul 28 130; add 740 741; mul 47 395; add 742 743; mul 0 744; mul 0 28; mul 31 130; add 746 747; mul 34 395;
add 748 749; mul 130 750; add 745 751; mul 0 47; mul 34 130; add 753 754; mul 51 395; add 755 756; mul 395 757; add
752 758; mul 17 130; mul 130 760; mul 23 761; input p 128; mul 9 763; mul 9 764; mul 8 16; mul 10 766; mul 766 767;
add 765 768; mul 3 769; mul 38 770; sub 25 771; mul 762 772; add 759 773; mul 67 774; mul 24 770; add 39 776; mul
762 777; sub 775 778; mul 22 779; sub 739 780; mul 90 781; mul 81 89; mul 150 265; input p 129; mul 285 785; input p
130; mul 304 787; add 786 788; mul 324 331; add 789 790; input p 131; mul 328 792; add 791 793; input p 132; mul 332
795; add 794 796; input p 133; mul 336 798; add 797 799; mul 339 800; input p 134; mul 342 802; mul 345 352; add 803
804; input p 135; mul 349 806; add 805 807; input p 136; mul 353 809; add 808 810; input p 137; mul 357 812; add 811
813; mul 361 372; add 814 815; input p 138; mul 365 817; add 816 818; input p 139; mul 369 820; add 819 821; input p
140; mul 373 823; add 822 824; input p 141; mul 339 826; add 825 827; add 801 828; mul 576 829; add 784 830; mul 145
831; mul 579 690; sub 832 833; mul 150 405; add 834 835; mul 567 594; mul 679 687; add 837 838; add 836 839; sub 134
840; input p 142; mul 38 842; mul 17 843; add 841 844; input p 143; mul 713 846; sub 845 847; mul 41 774; mul 26
778; sub 849 850; mul 22 851; mul 19 770; mul 761 853; sub 852 854; sub 848 855; mul 783 856; sub 782 857; mul 86
89; input p 144; mul 35 860; input p 145; mul 214 862; add 861 863; input p 146; mul 218 865; add 864 866; mul 155
210; add 867 868; input p 147; mul 158 870; add 869 871; input p 148; mul 162 873; add 872 874; input p 149; mul 166
876; add 875 877; mul 170 227; add 878 879; input p 150; mul 174 881; add 880 882; mul 157 189; add 883 884; input p
151; mul 193 886; add 885 887; mul 169 197; add 888 889; input p 152; mul 201 891; add 890 892; mul 184 258; add 893
894; mul 202 257; add 895 896; mul 153 265; add 897 898; input p 153; mul 285 900; mul 304 331; add 901 902; input p
154; mul 324 904; add 903 905; input p 155; mul 328 907; add 906 908; input p 156; mul 332 910; add 909 911; input p
157; mul 336 913; add 912 914; mul 339 915; input p 158; mul 342 917; mul 345 806; add 918 919; mul 349 360; add 920
921; mul 353 368; add 922 923; input p 159; mul 357 925; add 924 926; input p 160; mul 361 928; add 927 929; input p
161; mul 365 931; add 930 932; mul 369 823; add 933 934; input p 162; mul 373 936; add 935 937; input p 163; mul 339
939; add 938 940; add 916 941; constant 3.0; mul 336 943; input p 164; mul 342 945; mul 345 785; add 946 947; mul
349 900; add 948 949; mul 327 353; add 950 951; mul 331 357; add 952 953; mul 335 361; add 954 955; input p 165; mul
365 957; add 956 958; mul 369 907; add 959 960; mul 373 798; add 961 962; input p 166; mul 339 964; add 963 965; mul
944 966; add 942 967; mul 585 968; add 899 969; mul 145 970; mul 588 690; sub 971 972; input p 167; mul 395 974; mul
153 405; add 975 976; add 973 977; mul 53 774; mul 22 979; add 978 980; mul 859 981; sub 858 982; mul 56 70; mul 79
79; sub 984 985; mul 89 986; mul 856 987; mul 781 783; sub 988 989; mul 59 70; mul 76 79; sub 991 992; mul 89 993;
mul 981 994; add 990 995; mul 781 859; mul 856 994; sub 997 998; mul 45 70; mul 76 76; sub 1000 1001; mul 89 1002;
mul 981 1003; sub 999 1004; mul 555 592; input p 168; mul 534 1007; sub 1006 1008; mul 667 685; mul 649 1007; sub
1010 1011; input p 169; mul 537 1013; sub 1006 1014; mul 652 1013; sub 1010 1016; input p 170; mul 541 1018; sub
1006 1019; mul 656 1018; sub 1010 1021; input p 171; mul 732 1023; input p 172; mul 736 1025; le 2 700; mul 130 846;
add 0 1028; lt 140 1029; and 1027 1030; constant -1.0; le 700 1032; lt 1029 140; and 1033 1034; or 1031 1035; not
1036; input p 173; mul 1029 1038; where 1037 1039; le 2 703; and 1030 1041; le 703 1032; and 1034 1043; or 1042
1044; not 1045; input p 174; mul 1029 1047; where 1046 1048; le 2 707; and 1030 1050; le 707 1032; and 1034 1052; or
1051 1053; not 1054; input p 175; mul 1029 1056; where 1055 1057; le 2 711; and 1030 1059; le 711 1032; and 1034
1061; or 1060 1062; not 1063; input p 176; mul 1029 1065; where 1064 1066; mul 41 503; mul 28 1068; mul 22 1069; mul
56 1070; mul 53 503; mul 47 1072; mul 22 1073; mul 45 1074; add 1071 1075; mul 28 53; mul 41 47; add 1077 1078; mul
22 1079; mul 59 1080; add 1081 1081; sub 1076 1082; mul 89 1083; mul 89 90; mul 67 503; mul 62 1086; mul 22 1087;
mul 61 1088; mul 70 1083; add 1089 1090; mul 41 62; mul 28 67; add 1092 1093; mul 22 1094; mul 81 1095; mul 56 1095;
mul 76 1074; add 1097 1098; mul 79 1080; mul 47 67; mul 53 62; add 1101 1102; mul 22 1103; mul 59 1104; add 1100
1105; sub 1099 1106; mul 76 1107; add 1096 1108; sub 1091 1109; mul 86 1104; mul 59 1095; mul 76 1080; add 1112
1113; mul 79 1070; mul 45 1104; add 1115 1116; sub 1114 1117; mul 79 1118; add 1111 1119; add 1110 1120; mul 1085
1121; sub 1084 1122; mul 781 1123; mul 100 106; mul 102 1125; mul 100 114; sub 1126 1127; mul 100 118; mul 100 1129;
sub 1128 1130; input p 177; input p 178; mul 35 1133; mul 157 1134; add 1132 1135; mul 35 1134; mul 161 1137; add
1136 1138; mul 155 503; mul 1133 1140; mul 165 1141; add 1139 1142; mul 35 1141; mul 169 1144; add 1143 1145; mul
155 1141; mul 166 1133; add 1147 1148; mul 173 1149; add 1146 1150; input p 179; add 1151 1152; mul 35 144; mul 180
1154; add 1153 1155; mul 35 1154; mul 184 1157; add 1156 1158; mul 144 155; mul 148 1133; add 1160 1161; mul 188
1162; add 1159 1163; mul 35 1162; mul 192 1165; add 1164 1166; mul 155 1162; mul 189 1133; add 1168 1169; mul 196
1170; add 1167 1171; mul 148 503; mul 144 1173; mul 155 1174; mul 201 1133; add 1175 1176; mul 200 1177; add 1172
1178; mul 148 1174; mul 144 201; add 1180 1181; mul 205 1182; add 1179 1183; input p 180; mul 224 1134; add 1185
1186; mul 227 1137; add 1187 1188; mul 230 1141; add 1189 1190; mul 233 1144; add 1191 1192; mul 236 1149; add 1193
1194; input p 181; add 1195 1196; mul 157 1154; add 1197 1198; mul 161 1157; add 1199 1200; mul 245 1162; add 1201
1202; mul 248 1165; add 1203 1204; mul 251 1170; add 1205 1206; mul 254 1174; add 1207 1208; mul 35 1174; mul 257
1210; add 1209 1211; mul 196 1177; add 1212 1213; mul 263 1182; add 1214 1215; mul 147 1216; add 1184 1217; mul 284
503; le 271 269; le 269 271; add 1220 1221; div 2 1222; mul 1220 1223; le 270 148; le 148 270; add 1225 1226; div 2
1227; mul 1225 1228; mul 144 1229; mul 1224 1230; constant 2.857142857142857; mul 275 503; le 140 274; le 274 140;
add 1234 1235; div 2 1236; mul 1234 1237; mul 1231 1238; mul 1233 1239; mul 279 503; le 140 278; le 278 140; add
1242 1243; div 2 1244; mul 1242 1245; mul 1231 1246; mul 1241 1247; add 1240 1248; mul 1232 1249; sub 1231 1250; mul
1219 1251; mul 268 1252; mul 303 1251; mul 287 1254; add 1253 1255; mul 323 1251; mul 307 1257; add 1256 1258; mul
339 1259; mul 284 1252; mul 285 1251; add 1261 1262; mul 341 1263; mul 303 1252; mul 344 1265; add 1264 1266; mul
323 1252; mul 348 1268; add 1267 1269; mul 303 1254; mul 352 1271; add 1270 1272; mul 323 1254; mul 356 1274; add
1273 1275; mul 323 1257; mul 360 1277; add 1276 1278; add 1260 1279; mul 383 1280; sub 1239 1247; mul 380 1282; mul
379 1283; sub 1281 1284; add 1218 1285; mul 145 1286; mul 144 1287; mul 410 1263; mul 412 1265; add 1289 1290; mul
415 1268; add 1291 1292; mul 418 1271; add 1293 1294; mul 421 1274; add 1295 1296; mul 383 1297; mul 429 1283; sub
1298 1299; add 62 1300; mul 690 1301; mul 484 503; add 63 67; add 64 1304; add 66 1305; mul 104 1306; mul 429 1251;
mul 284 1297; add 1308 1309; mul 443 1263; mul 418 1265; add 1311 1312; mul 447 1268; add 1313 1314; mul 450 1271;
add 1315 1316; mul 453 1274; add 1317 1318; mul 303 1319; add 1310 1320; mul 464 1263; mul 447 1265; add 1322 1323;
mul 427 1271; add 1324 1325; mul 323 1326; add 1321 1327; mul 441 1328; mul 440 1329; add 1307 1330; mul 1303 1331;
mul 491 503; sub 1332 1333; mul 495 503; div 2 1335; mul 1334 1336; mul 485 1337; mul 503 1338; mul 498 503; mul 497
503; div 2 1341; mul 1338 1342; mul 499 1343; mul 1340 1344; neg 1345; mul 503 1346; mul 499 1347; mul 505 1345; sub
1348 1349; sub 1339 1350; mul 502 1351; mul 520 1352; le 513 509; le 509 513; add 1354 1355; div 2 1356; mul 1354
1357; le 510 512; le 512 510; add 1359 1360; div 2 1361; mul 1359 1362; mul 1338 1363; mul 1358 1364; mul 516 1365;
mul 514 1366; mul 518 1365; add 1367 1368; mul 508 1369; add 1353 1370; mul 525 1338; mul 512 1372; mul 527 1338;
add 1373 1374; mul 523 1375; sub 1371 1376; mul 485 1377; mul 550 1338; mul 512 1379; mul 552 1338; add 1380 1381;
mul 548 1382; mul 546 1343; mul 498 1384; mul 547 1343; add 1385 1386; mul 498 1387; mul 498 547; mul 1343 1389; add
1388 1390; mul 485 1391; mul 554 1392; sub 1383 1393; mul 543 1394; add 1378 1395; mul 558 1394; mul 555 1397; mul
559 1394; add 1398 1399; mul 592 1400; mul 485 1345; mul 491 1402; add 500 1403; mul 0 1404; mul 563 1331; add 561
1406; mul 500 1407; mul 565 1402; add 1408 1409; mul 17 1410; mul 130 1411; sub 1405 1412; mul 500 1331; mul 484
1402; sub 1414 1415; mul 590 1416; mul 0 1301; mul 576 1319; mul 440 1419; add 28 1420; mul 130 1421; add 1418 1422;
mul 585 1326; mul 440 1424; add 47 1425; mul 395 1426; add 1423 1427; mul 501 1428; add 1417 1429; add 1413 1430;
mul 560 1431; add 1401 1432; add 1396 1433; mul 501 1434; mul 594 1416; add 1435 1436; mul 503 603; mul 1331 1438;
mul 503 610; sub 1439 1440; mul 503 614; div 2 1442; mul 1441 1443; mul 604 1444; mul 503 1445; mul 503 617; mul 503
616; div 2 1448; mul 1445 1449; mul 618 1450; mul 1447 1451; neg 1452; mul 503 1453; mul 618 1454; mul 623 1452; sub
1455 1456; sub 1446 1457; mul 621 1458; mul 635 1459; le 628 509; le 509 628; add 1461 1462; div 2 1463; mul 1461
1464; le 510 627; le 627 510; add 1466 1467; div 2 1468; mul 1466 1469; mul 1445 1470; mul 1465 1471; mul 631 1472;
mul 629 1473; mul 633 1472; add 1474 1475; mul 626 1476; add 1460 1477; mul 640 1445; mul 627 1479; mul 642 1445;
add 1480 1481; mul 638 1482; sub 1478 1483; mul 604 1484; mul 550 1445; mul 627 1486; mul 664 1445; add 1487 1488;
mul 662 1489; mul 660 1450; mul 617 1491; mul 661 1450; add 1492 1493; mul 617 1494; mul 617 661; mul 1450 1496; add
1495 1497; mul 604 1498; mul 666 1499; sub 1490 1500; mul 658 1501; add 1485 1502; mul 670 1501; mul 667 1504; mul
671 1501; add 1505 1506; mul 685 1507; mul 675 1331; sub 1509 673; mul 619 1510; mul 604 1452; mul 677 1512; sub
1511 1513; mul 17 1514; mul 130 1515; mul 610 1512; add 619 1517; mul 0 1518; add 1516 1519; mul 619 1331; mul 603
1512; sub 1521 1522; mul 590 1523; mul 620 1428; add 1524 1525; add 1520 1526; mul 672 1527; add 1508 1528; add 1503
1529; mul 620 1530; mul 687 1523; add 1531 1532; add 1437 1533; mul 431 1534; sub 1302 1535; sub 1288 1536; mul 569
1434; mul 594 1404; sub 1538 1539; mul 681 1530; mul 687 1518; sub 1541 1542; add 1540 1543; sub 1537 1544; sub 1131
1545; input p 182; sub 1546 1547; mul 62 774; mul 22 1549; sub 1548 1550; mul 90 1551; add 1124 1552; mul 89 1107;
mul 89 783; mul 1121 1555; sub 1554 1556; mul 856 1557; mul 150 1216; mul 785 1252; mul 787 1254; add 1560 1561; mul
331 1257; add 1562 1563; mul 339 1564; mul 802 1263; mul 352 1265; add 1566 1567; mul 806 1268; add 1568 1569; mul
809 1271; add 1570 1571; mul 812 1274; add 1572 1573; mul 372 1277; add 1574 1575; add 1565 1576; mul 576 1577; add
1559 1578; mul 145 1579; mul 690 1421; mul 579 1534; sub 1581 1582; sub 1580 1583; mul 567 1434; mul 594 1411; sub
1585 1586; mul 679 1530; mul 687 1515; add 1588 1589; add 1587 1590; add 1584 1591; sub 1129 1592; mul 28 774; mul
22 1594; sub 1593 1595; mul 783 1596; add 1558 1597; sub 1553 1598; mul 89 1118; mul 89 859; mul 1121 1601; sub 1600
1602; mul 981 1603; input p 183; mul 870 1134; add 1605 1606; mul 873 1137; add 1607 1608; mul 876 1141; add 1609
1610; mul 227 1144; add 1611 1612; mul 881 1149; add 1613 1614; mul 157 1162; add 1615 1616; mul 886 1165; add 1617
1618; mul 169 1170; add 1619 1620; mul 891 1174; add 1621 1622; mul 184 1210; add 1623 1624; mul 257 1177; add 1625
1626; mul 153 1216; add 1627 1628; mul 900 1252; mul 331 1254; add 1630 1631; mul 904 1257; add 1632 1633; mul 339
1634; mul 917 1263; mul 806 1265; add 1636 1637; mul 360 1268; add 1638 1639; mul 368 1271; add 1640 1641; mul 925
1274; add 1642 1643; mul 928 1277; add 1644 1645; add 1635 1646; mul 945 1263; mul 785 1265; add 1648 1649; mul 900
1268; add 1650 1651; mul 327 1271; add 1652 1653; mul 331 1274; add 1654 1655; mul 335 1277; add 1656 1657; mul 944
1658; add 1647 1659; mul 585 1660; add 1629 1661; mul 145 1662; mul 690 1426; mul 588 1534; sub 1664 1665; sub 1663
1666; mul 47 774; mul 22 1668; add 1667 1669; mul 859 1670; add 1604 1671; sub 1599 1672; input c_q 0; mul 90 1674;
le 140 139; le 139 140; add 1676 1677; div 2 1678; mul 1676 1679; mul 0 90; mul 1680 1681; input c_q 1; mul 1682
1683; sub 1675 1684; mul 90 93; input c_q 2; mul 1686 1687; add 1685 1688; mul 90 97; input c_q 3; mul 1690 1691;
add 1689 1692; mul 90 100; add 783 1694; input c_q 4; mul 1695 1696; sub 1693 1697; mul 102 1695; input c_q 5; mul
1699 1700; add 1698 1701; mul 93 1695; input c_q 6; mul 1703 1704; sub 1702 1705; mul 97 1695; input c_q 7; mul 1707
1708; sub 1706 1709; le 128 127; le 127 128; add 1711 1712; div 2 1713; mul 1711 1714; mul 132 1695; mul 1715 1716;
input c_q 8; mul 1717 1718; add 1710 1719; mul 90 102; input c_q 9; mul 1721 1722; add 1720 1723; mul 102 1721; mul
104 1725; input c_q 10; mul 1726 1727; sub 1724 1728; mul 93 1721; input c_q 11; mul 1730 1731; add 1729 1732; mul
97 1721; input c_q 12; mul 1734 1735; add 1733 1736; add 1673 1737; mul 56 1088; mul 70 1074; add 1739 1740; mul 79
1104; add 1742 1742; sub 1741 1743; mul 89 1744; mul 89 987; mul 1121 1746; sub 1745 1747; mul 856 1748; mul 987
1596; add 1749 1750; mul 781 1557; mul 783 1551; add 1752 1753; sub 1751 1754; mul 59 1088; mul 70 1080; add 1756
1757; mul 76 1104; mul 79 1095; add 1759 1760; sub 1758 1761; mul 89 1762; mul 89 994; mul 1121 1764; sub 1763 1765;
mul 981 1766; mul 994 1670; add 1767 1768; add 1755 1769; mul 0 783; mul 1680 1771; mul 1683 1772; mul 783 1674; sub
1773 1774; mul 93 783; mul 1687 1776; sub 1775 1777; mul 97 783; mul 1691 1779; sub 1778 1780; mul 100 783; add 987
1782; mul 1696 1783; add 1781 1784; mul 102 1783; mul 1700 1786; sub 1785 1787; mul 93 1783; mul 1704 1789; add 1788
1790; mul 97 1783; mul 1708 1792; add 1791 1793; mul 132 1783; mul 1715 1795; mul 1718 1796; sub 1794 1797; mul 102
783; mul 1722 1799; sub 1798 1800; mul 102 1799; mul 104 1802; mul 1727 1803; add 1801 1804; mul 93 1799; mul 1731
1806; sub 1805 1807; mul 97 1799; mul 1735 1809; sub 1808 1810; add 1770 1811; mul 781 1603; mul 859 1551; add 1813
1814; mul 856 1766; mul 994 1596; add 1816 1817; sub 1815 1818; mul 45 1088; mul 70 1070; add 1820 1821; mul 76
1095; add 1823 1823; sub 1822 1824; mul 89 1825; mul 89 1003; mul 1121 1827; sub 1826 1828; mul 981 1829; mul 1003
1670; add 1830 1831; sub 1819 1832; mul 859 1674; mul 0 859; mul 1680 1835; mul 1683 1836; sub 1834 1837; mul 93
859; mul 1687 1839; add 1838 1840; mul 97 859; mul 1691 1842; add 1841 1843; mul 100 859; add 994 1845; mul 1696
1846; sub 1844 1847; mul 102 1846; mul 1700 1849; add 1848 1850; mul 93 1846; mul 1704 1852; sub 1851 1853; mul 97
1846; mul 1708 1855; sub 1854 1856; mul 132 1846; mul 1715 1858; mul 1718 1859; add 1857 1860; mul 102 859; mul 1722
1862; add 1861 1863; mul 102 1862; mul 104 1865; mul 1727 1866; sub 1864 1867; mul 93 1862; mul 1731 1869; add 1868
1870; mul 97 1862; mul 1735 1872; add 1871 1873; add 1833 1874; mul 592 1394; mul 555 1431; add 1876 1877; mul 685
1501; mul 667 1527; add 1879 1880; mul 100 129; mul 100 1882; add 141 1883; input p 184; mul 431 501; sub 1886 569;
mul 560 1887; mul 501 1888; mul 431 620; sub 1890 681; mul 672 1891; mul 620 1892; add 1889 1893; mul 431 1894; add
1885 1895; mul 569 1888; mul 681 1892; add 1897 1898; sub 1896 1899; add 1884 1900; sign 0; mul 715 1902; mul 0
1903; add 717 1904; mul 719 725; mul 725 726; mul 0 725; mul 1907 1908; sub 1906 1909; add 1905 1910; add 1901 1911;
add 740 744; add 741 1913; add 743 1914; mul 67 1915; mul 22 1916; add 1912 1917; mul 90 1918; mul 579 1894; input p
185; add 1920 1921; mul 567 1888; mul 679 1892; add 1923 1924; add 1922 1925; sub 1882 1926; mul 41 1915; mul 22
1928; sub 1927 1929; mul 783 1930; add 1919 1931; mul 588 1894; input p 186; add 1933 1934; mul 53 1915; mul 22
1936; add 1935 1937; mul 859 1938; add 1932 1939; neg 1940; mul 987 1930; mul 783 1918; add 1942 1943; mul 994 1938;
add 1944 1945; mul 859 1918; mul 994 1930; add 1947 1948; mul 1003 1938; add 1949 1950; neg 1951; mul 555 1887; mul
667 1891; where 1037 1038; where 1046 1047; where 1055 1056; where 1064 1065; mul 26 503; div 2 14; mul 11 1960; mul
9 1961; mul 9 24; mul 5 9; mul 1963 1964; sub 1962 1965; mul 17 1966; mul 9 9; mul 1964 1968; mul 16 1969; mul 16
17; mul 14 1964; mul 8 1961; add 1972 1973; mul 1971 1974; add 1970 1975; mul 24 1976; sub 1967 1977; mul 23 1978;
mul 1959 1979; mul 9 38; mul 1964 1981; sub 9 1982; mul 17 1983; mul 38 1976; sub 1984 1985; mul 23 1986; add 31
1987; mul 1068 1988; add 1980 1989; mul 22 1990; mul 18 1976; mul 17 1992; mul 19 1976; add 1993 1994; sub 1991
1995; mul 56 1996; mul 34 1072; mul 22 1998; mul 45 1999; add 1997 2000; mul 53 1988; mul 34 41; add 2002 2003; mul
22 2004; mul 59 2005; add 2006 2006; sub 2001 2007; mul 89 2008; mul 28 1086; mul 22 2010; mul 61 2011; mul 70 2008;
add 2012 2013; mul 28 41; mul 67 1988; add 2015 2016; add 1979 2017; mul 22 2018; mul 81 2019; mul 56 2019; mul 76
1999; add 2021 2022; mul 79 2005; mul 34 67; add 1077 2025; mul 22 2026; mul 59 2027; add 2024 2028; sub 2023 2029;
mul 76 2030; add 2020 2031; sub 2014 2032; mul 86 2027; mul 59 2019; mul 76 2005; add 2035 2036; mul 79 1996; mul 45
2027; add 2038 2039; sub 2037 2040; mul 79 2041; add 2034 2042; add 2033 2043; mul 1085 2044; sub 2009 2045; mul 781
2046; sub 114 107; add 1129 2048; input p 187; mul 35 150; mul 157 2051; add 2050 2052; mul 35 2051; mul 161 2054;
add 2053 2055; mul 150 1140; mul 165 2057; add 2056 2058; mul 35 2057; mul 169 2060; add 2059 2061; mul 155 2057;
mul 150 166; add 2063 2064; mul 173 2065; add 2062 2066; mul 148 150; mul 188 2068; add 2067 2069; mul 35 2068; mul
192 2071; add 2070 2072; mul 155 2068; mul 150 189; add 2074 2075; mul 196 2076; add 2073 2077; mul 150 201; mul 200
2079; add 2078 2080; input p 188; mul 224 2051; add 2082 2083; mul 227 2054; add 2084 2085; mul 230 2057; add 2086
2087; mul 233 2060; add 2088 2089; mul 236 2065; add 2090 2091; mul 245 2068; add 2092 2093; mul 248 2071; add 2094
2095; mul 251 2076; add 2096 2097; mul 196 2079; add 2098 2099; mul 147 2100; add 2081 2101; le 290 288; le 288 290;
add 2103 2104; div 2 2105; mul 2103 2106; le 289 3; le 3 289; add 2108 2109; div 2 2110; mul 2108 2111; mul 2107
2112; constant 1.6666666666666667; mul 294 503; le 140 293; le 293 140; add 2116 2117; div 2 2118; mul 2116 2119;
mul 2113 2120; mul 2115 2121; mul 298 503; le 140 297; le 297 140; add 2124 2125; div 2 2126; mul 2124 2127; mul
2113 2128; mul 2123 2129; add 2122 2130; mul 2114 2131; sub 2113 2132; mul 284 2133; mul 287 2134; mul 303 503; mul
2133 2136; mul 327 2137; add 2135 2138; mul 323 2133; mul 331 2140; add 2139 2141; mul 339 2142; mul 285 2133; mul
344 2144; mul 303 2134; mul 304 2133; add 2146 2147; mul 352 2148; add 2145 2149; mul 323 2134; mul 356 2151; add
2150 2152; mul 303 2137; mul 328 2133; add 2154 2155; mul 364 2156; add 2153 2157; mul 323 2137; mul 368 2159; add
2158 2160; mul 323 2140; mul 372 2162; add 2161 2163; add 2143 2164; mul 383 2165; add 2102 2166; mul 145 2167; mul
144 2168; mul 412 2144; mul 418 2148; add 2170 2171; mul 421 2151; add 2172 2173; mul 424 2156; add 2174 2175; mul
427 2159; add 2176 2177; mul 383 2178; add 28 2179; mul 690 2180; mul 482 1966; mul 479 1983; add 2182 2183; mul
1333 2184; add 32 37; add 30 2186; add 36 2187; mul 104 2188; mul 284 2178; mul 461 2133; mul 418 2144; mul 450
2148; add 2192 2193; mul 453 2151; add 2194 2195; mul 456 2156; add 2196 2197; mul 459 2159; add 2198 2199; mul 303
2200; add 2191 2201; add 2190 2202; mul 447 2144; mul 427 2148; add 2204 2205; mul 470 2156; add 2206 2207; mul 323
2208; add 2203 2209; mul 441 2210; mul 440 2211; add 2189 2212; mul 479 1966; add 2213 2214; mul 482 1983; sub 2215
2216; mul 1303 2217; add 2185 2218; mul 1336 2219; mul 485 2220; mul 503 2221; mul 1342 2221; mul 499 2223; mul 1340
2224; neg 2225; mul 503 2226; mul 499 2227; mul 505 2225; sub 2228 2229; sub 2222 2230; mul 502 2231; mul 520 2232;
mul 1363 2221; mul 1358 2234; mul 516 2235; mul 514 2236; mul 518 2235; add 2237 2238; mul 508 2239; add 2233 2240;
mul 525 2221; mul 512 2242; mul 527 2221; add 2243 2244; mul 523 2245; sub 2241 2246; mul 485 2247; mul 550 2221;
mul 512 2249; mul 552 2221; add 2250 2251; mul 548 2252; mul 546 2223; mul 498 2254; mul 547 2223; add 2255 2256;
mul 498 2257; mul 1389 2223; add 2258 2259; mul 485 2260; mul 554 2261; sub 2253 2262; mul 543 2263; add 2248 2264;
mul 558 2263; mul 555 2266; mul 559 2263; add 2267 2268; mul 592 2269; mul 561 2184; sub 2214 2216; mul 491 2272;
add 2271 2273; mul 563 2217; mul 484 2184; add 2275 2276; sub 2274 2277; mul 500 2278; mul 485 2225; mul 565 2280;
sub 2279 2281; mul 17 2282; mul 566 1976; sub 2283 2284; mul 130 2285; mul 500 2184; mul 491 2280; sub 2287 2288;
mul 0 2289; sub 2286 2290; mul 500 2217; mul 484 2280; sub 2292 2293; mul 590 2294; mul 0 2180; mul 576 2200; sub
2121 2129; mul 573 2298; mul 461 2299; sub 2297 2300; mul 440 2301; add 31 2302; mul 130 2303; add 2296 2304; mul
585 2208; mul 440 2306; add 34 2307; mul 395 2308; add 2305 2309; mul 501 2310; add 2295 2311; add 2291 2312; mul
560 2313; add 2270 2314; add 2265 2315; mul 501 2316; mul 594 2294; add 2317 2318; mul 598 1983; mul 601 1966; sub
2320 2321; mul 1440 2322; mul 598 1966; add 2213 2324; mul 601 1983; add 2325 2326; mul 1438 2327; add 2323 2328;
mul 1443 2329; mul 604 2330; mul 503 2331; mul 1449 2331; mul 618 2333; mul 1447 2334; neg 2335; mul 503 2336; mul
618 2337; mul 623 2335; sub 2338 2339; sub 2332 2340; mul 621 2341; mul 635 2342; mul 1470 2331; mul 1465 2344; mul
631 2345; mul 629 2346; mul 633 2345; add 2347 2348; mul 626 2349; add 2343 2350; mul 640 2331; mul 627 2352; mul
642 2331; add 2353 2354; mul 638 2355; sub 2351 2356; mul 604 2357; mul 550 2331; mul 627 2359; mul 664 2331; add
2360 2361; mul 662 2362; mul 660 2333; mul 617 2364; mul 661 2333; add 2365 2366; mul 617 2367; mul 1496 2333; add
2368 2369; mul 604 2370; mul 666 2371; sub 2363 2372; mul 658 2373; add 2358 2374; mul 670 2373; mul 667 2376; mul
671 2373; add 2377 2378; mul 685 2379; mul 673 2322; add 2324 2326; mul 610 2382; add 2381 2383; mul 675 2327; sub
2321 2320; mul 603 2386; add 2385 2387; add 2384 2388; mul 619 2389; mul 604 2335; mul 677 2391; sub 2390 2392; mul
17 2393; mul 678 1976; sub 2394 2395; mul 130 2396; mul 619 2322; mul 610 2391; sub 2398 2399; mul 0 2400; sub 2397
2401; mul 619 2327; mul 603 2391; sub 2403 2404; mul 590 2405; mul 620 2310; add 2406 2407; add 2402 2408; mul 672
2409; add 2380 2410; add 2375 2411; mul 620 2412; mul 687 2405; add 2413 2414; add 2319 2415; mul 431 2416; sub 2181
2417; sub 2169 2418; mul 569 2316; mul 594 2289; add 2420 2421; mul 681 2412; mul 687 2400; add 2423 2424; add 2422
2425; sub 2419 2426; sub 2049 2427; mul 770 1983; mul 16 1964; mul 16 766; mul 1974 2431; sub 2430 2432; mul 10
2433; mul 766 2434; mul 767 2433; add 2435 2436; mul 765 1964; mul 9 2438; mul 9 765; mul 1964 2440; add 2439 2441;
sub 2437 2442; mul 3 2443; add 769 2444; mul 38 2445; add 2429 2446; sub 1978 2447; mul 762 2448; mul 130 1976; mul
130 2450; mul 23 2451; mul 772 2452; sub 2449 2453; mul 67 2454; add 1594 2455; mul 770 1966; mul 24 2445; add 2457
2458; add 1986 2459; mul 762 2460; mul 777 2452; sub 2461 2462; sub 2456 2463; mul 22 2464; sub 2428 2465; mul 90
2466; add 2047 2467; mul 89 2030; mul 1555 2044; sub 2469 2470; mul 856 2471; mul 842 1983; mul 17 2473; mul 843
1976; sub 2474 2475; mul 150 2100; mul 787 2134; mul 792 2137; add 2478 2479; mul 795 2140; add 2480 2481; mul 339
2482; mul 352 2144; mul 809 2148; add 2484 2485; mul 812 2151; add 2486 2487; mul 817 2156; add 2488 2489; mul 820
2159; add 2490 2491; mul 823 2162; add 2492 2493; add 2483 2494; mul 576 2495; mul 829 2299; sub 2496 2497; add 2477
2498; mul 145 2499; mul 690 2303; mul 579 2416; sub 2501 2502; sub 2500 2503; mul 567 2316; mul 594 2285; add 2505
2506; mul 679 2412; mul 687 2396; add 2508 2509; add 2507 2510; add 2504 2511; add 118 2512; sub 2476 2513; mul 774
1988; mul 41 2454; add 2515 2516; mul 778 1979; mul 26 2463; add 2518 2519; sub 2517 2520; mul 22 2521; mul 19 2445;
mul 770 1992; sub 2523 2524; mul 761 2525; mul 853 2451; sub 2526 2527; sub 2522 2528; sub 2514 2529; mul 783 2530;
add 2472 2531; sub 2468 2532; mul 89 2041; mul 1601 2044; sub 2534 2535; mul 981 2536; input p 189; mul 870 2051;
add 2538 2539; mul 873 2054; add 2540 2541; mul 876 2057; add 2542 2543; mul 227 2060; add 2544 2545; mul 881 2065;
add 2546 2547; mul 157 2068; add 2548 2549; mul 886 2071; add 2550 2551; mul 169 2076; add 2552 2553; mul 257 2079;
add 2554 2555; mul 153 2100; add 2556 2557; mul 331 2134; mul 907 2137; add 2559 2560; mul 910 2140; add 2561 2562;
mul 339 2563; mul 806 2144; mul 368 2148; add 2565 2566; mul 925 2151; add 2567 2568; mul 931 2156; add 2569 2570;
mul 823 2159; add 2571 2572; mul 936 2162; add 2573 2574; add 2564 2575; mul 785 2144; mul 327 2148; add 2577 2578;
mul 331 2151; add 2579 2580; mul 957 2156; add 2581 2582; mul 907 2159; add 2583 2584; mul 798 2162; add 2585 2586;
mul 944 2587; add 2576 2588; mul 585 2589; add 2558 2590; mul 145 2591; mul 690 2308; mul 588 2416; sub 2593 2594;
sub 2592 2595; mul 34 774; mul 53 2454; add 2597 2598; mul 22 2599; add 2596 2600; mul 859 2601; add 2537 2602; sub
2533 2603; mul 56 2011; mul 70 1999; add 2605 2606; mul 79 2027; add 2608 2608; sub 2607 2609; mul 89 2610; mul 1746
2044; sub 2611 2612; mul 856 2613; mul 987 2530; add 2614 2615; mul 781 2471; mul 783 2466; add 2617 2618; sub 2616
2619; mul 59 2011; mul 70 2005; add 2621 2622; mul 76 2027; mul 79 2019; add 2624 2625; sub 2623 2626; mul 89 2627;
mul 1764 2044; sub 2628 2629; mul 981 2630; mul 994 2601; add 2631 2632; add 2620 2633; mul 781 2536; mul 859 2466;
add 2635 2636; mul 856 2630; mul 994 2530; add 2638 2639; sub 2637 2640; mul 45 2011; mul 70 1996; add 2642 2643;
mul 76 2019; add 2645 2645; sub 2644 2646; mul 89 2647; mul 1827 2044; sub 2648 2649; mul 981 2650; mul 1003 2601;
add 2651 2652; sub 2641 2653; mul 592 2263; mul 555 2313; add 2655 2656; mul 685 2373; mul 667 2409; add 2658 2659;
input p 190; mul 501 579; add 567 2662; mul 560 2663; mul 501 2664; mul 579 620; add 679 2666; mul 672 2667; mul 620
2668; add 2665 2669; mul 431 2670; add 2661 2671; mul 569 2664; mul 681 2668; add 2673 2674; sub 2672 2675; sub 1882
2676; add 747 750; add 746 2678; add 749 2679; mul 503 760; mul 23 2681; mul 772 2682; add 2680 2683; mul 67 2684;
mul 777 2682; sub 2685 2686; mul 22 2687; sub 2677 2688; mul 90 2689; mul 579 2670; input p 191; add 2691 2692; mul
567 2664; mul 679 2668; add 2694 2695; add 2693 2696; add 129 2697; mul 41 2684; mul 26 2686; sub 2699 2700; mul 22
2701; mul 853 2681; sub 2702 2703; add 2698 2704; mul 783 2705; add 2690 2706; mul 588 2670; input p 192; add 2708
2709; mul 53 2684; mul 22 2711; add 2710 2712; mul 859 2713; sub 2707 2714; mul 994 2713; mul 987 2705; mul 783
2689; add 2717 2718; sub 2716 2719; mul 859 2689; mul 994 2705; add 2721 2722; mul 1003 2713; sub 2723 2724; mul 555
2663; mul 667 2667; input p 193; where 1037 2728; input p 194; where 1046 2730; input p 195; where 1055 2732; input
p 196; where 1064 2734; mul 34 1068; mul 22 2736; mul 56 2737; mul 51 1072; mul 22 2739; mul 45 2740; add 2738 2741;
mul 34 53; mul 41 51; add 2743 2744; mul 22 2745; mul 59 2746; add 2747 2747; sub 2742 2748; mul 89 2749; mul 47
1086; mul 22 2751; mul 61 2752; mul 70 2749; add 2753 2754; add 1078 2025; mul 22 2756; mul 81 2757; mul 56 2757;
mul 76 2740; add 2759 2760; mul 79 2746; mul 51 67; mul 47 53; add 2763 2764; mul 22 2765; mul 59 2766; add 2762
2767; sub 2761 2768; mul 76 2769; add 2758 2770; sub 2755 2771; mul 86 2766; mul 59 2757; mul 76 2746; add 2774
2775; mul 79 2737; mul 45 2766; add 2777 2778; sub 2776 2779; mul 79 2780; add 2773 2781; add 2772 2782; mul 1085
2783; sub 2750 2784; mul 781 2785; input p 197; add 154 155; mul 157 2788; add 2787 2789; mul 35 2788; add 158 2791;
mul 161 2792; add 2790 2793; mul 153 1140; mul 165 2795; add 2794 2796; mul 35 2795; add 166 2798; mul 169 2799; add
2797 2800; mul 155 2795; mul 153 166; add 2802 2803; mul 173 2804; add 2801 2805; mul 148 180; add 2806 2807; mul
181 503; mul 184 2809; add 2808 2810; mul 148 153; mul 188 2812; add 2811 2813; mul 35 2812; add 189 2815; mul 192
2816; add 2814 2817; mul 155 2812; mul 153 189; add 2819 2820; mul 196 2821; add 2818 2822; mul 153 201; mul 200
2824; add 2823 2825; mul 35 503; mul 213 2827; add 210 2828; mul 35 2827; add 214 2830; mul 217 2831; add 2829 2832;
input p 198; add 2833 2834; mul 224 2788; add 2835 2836; mul 227 2792; add 2837 2838; mul 230 2795; add 2839 2840;
mul 233 2799; add 2841 2842; mul 236 2804; add 2843 2844; mul 148 157; add 2845 2846; mul 161 2809; add 2847 2848;
mul 245 2812; add 2849 2850; mul 248 2816; add 2851 2852; mul 251 2821; add 2853 2854; mul 201 257; add 2855 2856;
mul 196 2824; add 2857 2858; mul 147 2859; add 2826 2860; le 310 308; le 308 310; add 2862 2863; div 2 2864; mul
2862 2865; le 309 35; le 35 309; add 2867 2868; div 2 2869; mul 2867 2870; mul 2866 2871; constant 0.625; mul 314
503; le 140 313; le 313 140; add 2875 2876; div 2 2877; mul 2875 2878; mul 2872 2879; mul 2874 2880; mul 318 503; le
140 317; le 317 140; add 2883 2884; div 2 2885; mul 2883 2886; mul 2872 2887; mul 2882 2888; add 2881 2889; mul 2873
2890; sub 2872 2891; mul 284 2892; mul 307 2893; mul 303 2892; mul 331 2895; add 2894 2896; mul 323 503; mul 2892
2898; mul 335 2899; add 2897 2900; mul 339 2901; mul 323 2899; mul 336 2892; add 2903 2904; mul 338 2905; add 2902
2906; mul 285 2892; mul 348 2908; mul 304 2892; mul 356 2910; add 2909 2911; mul 323 2893; mul 324 2892; add 2913
2914; mul 360 2915; add 2912 2916; mul 328 2892; mul 368 2918; add 2917 2919; mul 323 2895; mul 332 2892; add 2921
2922; mul 372 2923; add 2920 2924; mul 376 2905; add 2925 2926; add 2907 2927; mul 383 2928; add 2861 2929; mul 145
2930; mul 144 2931; mul 415 2908; mul 421 2910; add 2933 2934; mul 427 2918; add 2935 2936; mul 383 2937; add 47
2938; mul 690 2939; add 52 53; add 50 2941; mul 104 2942; mul 284 2937; mul 447 2908; mul 453 2910; add 2945 2946;
mul 459 2918; add 2947 2948; mul 303 2949; add 2944 2950; mul 472 2892; add 2951 2952; mul 441 2953; mul 440 2954;
add 2943 2955; mul 1303 2956; mul 1336 2957; mul 485 2958; mul 503 2959; mul 1342 2959; mul 499 2961; mul 1340 2962;
neg 2963; mul 503 2964; mul 499 2965; mul 505 2963; sub 2966 2967; sub 2960 2968; mul 502 2969; mul 520 2970; mul
1363 2959; mul 1358 2972; mul 516 2973; mul 514 2974; mul 518 2973; add 2975 2976; mul 508 2977; add 2971 2978; mul
525 2959; mul 512 2980; mul 527 2959; add 2981 2982; mul 523 2983; sub 2979 2984; mul 485 2985; mul 550 2959; mul
512 2987; mul 552 2959; add 2988 2989; mul 548 2990; mul 546 2961; mul 498 2992; mul 547 2961; add 2993 2994; mul
498 2995; mul 1389 2961; add 2996 2997; mul 485 2998; mul 554 2999; sub 2991 3000; mul 543 3001; add 2986 3002; mul
558 3001; mul 555 3004; mul 559 3001; add 3005 3006; mul 592 3007; mul 485 2963; mul 491 3009; mul 0 3010; mul 563
2956; mul 500 3012; mul 565 3009; add 3013 3014; mul 17 3015; mul 130 3016; sub 3011 3017; mul 500 2956; mul 484
3009; sub 3019 3020; mul 590 3021; mul 0 2939; mul 576 2949; mul 440 3024; add 34 3025; mul 130 3026; add 3023 3027;
sub 2880 2888; mul 582 3029; mul 472 3030; mul 440 3031; sub 51 3032; mul 395 3033; add 3028 3034; mul 501 3035; add
3022 3036; add 3018 3037; mul 560 3038; add 3008 3039; add 3003 3040; mul 501 3041; mul 594 3021; add 3042 3043; mul
1438 2956; mul 1443 3045; mul 604 3046; mul 503 3047; mul 1449 3047; mul 618 3049; mul 1447 3050; neg 3051; mul 503
3052; mul 618 3053; mul 623 3051; sub 3054 3055; sub 3048 3056; mul 621 3057; mul 635 3058; mul 1470 3047; mul 1465
3060; mul 631 3061; mul 629 3062; mul 633 3061; add 3063 3064; mul 626 3065; add 3059 3066; mul 640 3047; mul 627
3068; mul 642 3047; add 3069 3070; mul 638 3071; sub 3067 3072; mul 604 3073; mul 550 3047; mul 627 3075; mul 664
3047; add 3076 3077; mul 662 3078; mul 660 3049; mul 617 3080; mul 661 3049; add 3081 3082; mul 617 3083; mul 1496
3049; add 3084 3085; mul 604 3086; mul 666 3087; sub 3079 3088; mul 658 3089; add 3074 3090; mul 670 3089; mul 667
3092; mul 671 3089; add 3093 3094; mul 685 3095; mul 675 2956; mul 619 3097; mul 604 3051; mul 677 3099; sub 3098
3100; mul 17 3101; mul 130 3102; mul 610 3099; mul 0 3104; add 3103 3105; mul 619 2956; mul 603 3099; sub 3107 3108;
mul 590 3109; mul 620 3035; add 3110 3111; add 3106 3112; mul 672 3113; add 3096 3114; add 3091 3115; mul 620 3116;
mul 687 3109; add 3117 3118; add 3044 3119; mul 431 3120; sub 2940 3121; sub 2932 3122; mul 569 3041; mul 594 3010;
sub 3124 3125; mul 681 3116; mul 687 3104; sub 3127 3128; add 3126 3129; sub 3123 3130; add 1669 3131; mul 90 3132;
sub 2786 3133; mul 89 2769; mul 1555 2783; sub 3135 3136; mul 856 3137; mul 150 2859; mul 331 2893; mul 795 2895;
add 3140 3141; mul 798 2899; add 3142 3143; mul 339 3144; mul 800 2905; add 3145 3146; mul 806 2908; mul 812 2910;
add 3148 3149; mul 372 2915; add 3150 3151; mul 820 2918; add 3152 3153; mul 823 2923; add 3154 3155; mul 826 2905;
add 3156 3157; add 3147 3158; mul 576 3159; add 3139 3160; mul 145 3161; mul 690 3026; mul 579 3120; sub 3163 3164;
sub 3162 3165; mul 567 3041; mul 594 3016; sub 3167 3168; mul 679 3116; mul 687 3102; add 3170 3171; add 3169 3172;
add 3166 3173; mul 22 2597; add 3174 3175; mul 783 3176; sub 3138 3177; sub 3134 3178; mul 89 2780; mul 1601 2783;
sub 3180 3181; mul 981 3182; mul 862 2827; add 860 3184; mul 865 2831; add 3185 3186; input p 199; add 3187 3188;
mul 870 2788; add 3189 3190; mul 873 2792; add 3191 3192; mul 876 2795; add 3193 3194; mul 227 2799; add 3195 3196;
mul 881 2804; add 3197 3198; mul 157 2812; add 3199 3200; mul 886 2816; add 3201 3202; mul 169 2821; add 3203 3204;
mul 184 201; add 3205 3206; mul 257 2824; add 3207 3208; mul 153 2859; add 3209 3210; mul 904 2893; mul 910 2895;
add 3212 3213; mul 913 2899; add 3214 3215; mul 339 3216; mul 915 2905; add 3217 3218; mul 360 2908; mul 925 2910;
add 3220 3221; mul 928 2915; add 3222 3223; mul 823 2918; add 3224 3225; mul 936 2923; add 3226 3227; mul 939 2905;
add 3228 3229; add 3219 3230; mul 943 2899; mul 966 3232; mul 900 2908; mul 331 2910; add 3234 3235; mul 335 2915;
add 3236 3237; mul 907 2918; add 3238 3239; mul 798 2923; add 3240 3241; mul 964 2905; add 3242 3243; mul 944 3244;
add 3233 3245; add 3231 3246; mul 585 3247; mul 968 3030; sub 3248 3249; add 3211 3250; mul 145 3251; mul 690 3033;
mul 588 3120; sub 3253 3254; sub 3252 3255; mul 51 774; mul 22 3257; add 3256 3258; mul 859 3259; add 3183 3260; sub
3179 3261; mul 56 2752; mul 70 2740; add 3263 3264; mul 79 2766; add 3266 3266; sub 3265 3267; mul 89 3268; mul 1746
2783; sub 3269 3270; mul 856 3271; mul 987 3176; sub 3272 3273; mul 781 3137; mul 783 3132; sub 3275 3276; sub 3274
3277; mul 59 2752; mul 70 2746; add 3279 3280; mul 76 2766; mul 79 2757; add 3282 3283; sub 3281 3284; mul 89 3285;
mul 1764 2783; sub 3286 3287; mul 981 3288; mul 994 3259; add 3289 3290; add 3278 3291; mul 781 3182; mul 859 3132;
sub 3293 3294; mul 856 3288; mul 994 3176; sub 3296 3297; sub 3295 3298; mul 45 2752; mul 70 2737; add 3300 3301;
mul 76 2757; add 3303 3303; sub 3302 3304; mul 89 3305; mul 1827 2783; sub 3306 3307; mul 981 3308; mul 1003 3259;
add 3309 3310; sub 3299 3311; mul 592 3001; mul 555 3038; add 3313 3314; mul 685 3089; mul 667 3113; add 3316 3317;
mul 501 588; mul 560 3319; mul 501 3320; mul 588 620; mul 672 3322; mul 620 3323; add 3321 3324; mul 579 3325; input
p 200; add 3326 3327; mul 567 3320; mul 679 3323; add 3329 3330; add 3328 3331; add 756 757; add 755 3333; mul 41
3334; mul 22 3335; add 3332 3336; mul 783 3337; input p 201; mul 431 3325; add 3339 3340; mul 569 3320; mul 681
3323; add 3342 3343; sub 3341 3344; mul 67 3334; mul 22 3346; add 3345 3347; mul 90 3348; sub 3338 3349; mul 588
3325; input p 202; add 3351 3352; mul 53 3334; mul 22 3354; add 3353 3355; mul 859 3356; sub 3350 3357; mul 783
3348; mul 987 3337; sub 3359 3360; mul 994 3356; add 3361 3362; mul 994 3337; mul 859 3348; sub 3364 3365; mul 1003
3356; sub 3366 3367; mul 555 3319; mul 667 3322; mul 533 555; mul 501 3371; mul 579 3372; mul 567 3371; add 3373
3374; mul 783 3375; mul 431 3372; mul 569 3371; sub 3377 3378; mul 90 3379; sub 3376 3380; mul 588 3372; mul 859
3382; sub 3381 3383; mul 783 3379; mul 987 3375; sub 3385 3386; mul 994 3382; add 3387 3388; mul 994 3375; mul 859
3379; sub 3390 3391; mul 1003 3382; sub 3392 3393; input p 203; mul 648 667; mul 620 3396; mul 579 3397; mul 679
3396; add 3398 3399; mul 783 3400; mul 431 3397; mul 681 3396; sub 3402 3403; mul 90 3404; sub 3401 3405; mul 588
3397; mul 859 3407; sub 3406 3408; mul 783 3404; mul 987 3400; sub 3410 3411; mul 994 3407; add 3412 3413; mul 994
3400; mul 859 3404; sub 3415 3416; mul 1003 3407; sub 3417 3418; mul 536 555; mul 501 3420; mul 579 3421; mul 567
3420; add 3422 3423; mul 783 3424; mul 431 3421; mul 569 3420; sub 3426 3427; mul 90 3428; sub 3425 3429; mul 588
3421; mul 859 3431; sub 3430 3432; mul 783 3428; mul 987 3424; sub 3434 3435; mul 994 3431; add 3436 3437; mul 994
3424; mul 859 3428; sub 3439 3440; mul 1003 3431; sub 3441 3442; input p 204; mul 651 667; mul 620 3445; mul 579
3446; mul 679 3445; add 3447 3448; mul 783 3449; mul 431 3446; mul 681 3445; sub 3451 3452; mul 90 3453; sub 3450
3454; mul 588 3446; mul 859 3456; sub 3455 3457; mul 783 3453; mul 987 3449; sub 3459 3460; mul 994 3456; add 3461
3462; mul 994 3449; mul 859 3453; sub 3464 3465; mul 1003 3456; sub 3466 3467; mul 540 555; mul 501 3469; mul 579
3470; mul 567 3469; add 3471 3472; mul 783 3473; mul 431 3470; mul 569 3469; sub 3475 3476; mul 90 3477; sub 3474
3478; mul 588 3470; mul 859 3480; sub 3479 3481; mul 783 3477; mul 987 3473; sub 3483 3484; mul 994 3480; add 3485
3486; mul 994 3473; mul 859 3477; sub 3488 3489; mul 1003 3480; sub 3490 3491; input p 205; mul 655 667; mul 620
3494; mul 579 3495; mul 679 3494; add 3496 3497; mul 783 3498; mul 431 3495; mul 681 3494; sub 3500 3501; mul 90
3502; sub 3499 3503; mul 588 3495; mul 859 3505; sub 3504 3506; mul 783 3502; mul 987 3498; sub 3508 3509; mul 994
3505; add 3510 3511; mul 994 3498; mul 859 3502; sub 3513 3514; mul 1003 3505; sub 3515 3516; mul 90 730; mul 730
783; neg 3519; mul 730 859; input p 206; mul 90 734; mul 734 783; neg 3524; mul 734 859; input p 207; input p 208;
mul 783 3528; mul 90 699; sub 3529 3530; mul 699 783; mul 987 3528; sub 3532 3533; mul 994 3528; mul 699 859; sub
3535 3536; input p 209; mul 783 3538; mul 90 702; sub 3539 3540; mul 702 783; mul 987 3538; sub 3542 3543; mul 994
3538; mul 702 859; sub 3545 3546; input p 210; mul 783 3548; mul 90 706; sub 3549 3550; mul 706 783; mul 987 3548;
sub 3552 3553; mul 994 3548; mul 706 859; sub 3555 3556; input p 211; mul 783 3558; mul 90 710; sub 3559 3560; mul
710 783; mul 987 3558; sub 3562 3563; mul 994 3558; mul 710 859; sub 3565 3566; mul 102 109; add 92 3568; mul 100
121; sub 3569 3570; mul 522 529; mul 485 3572; mul 569 3573; mul 501 3573; mul 431 3575; sub 3574 3576; sub 3571
3577; mul 90 3578; mul 579 3575; mul 567 3573; add 3580 3581; add 121 3582; mul 783 3583; sub 3579 3584; mul 588
3575; mul 859 3586; add 3585 3587; mul 987 3583; mul 783 3578; sub 3589 3590; mul 994 3586; sub 3591 3592; mul 859
3578; mul 994 3583; sub 3594 3595; mul 1003 3586; add 3596 3597; mul 102 112; add 96 3599; mul 100 124; sub 3600
3601; mul 637 644; mul 604 3603; mul 681 3604; mul 620 3604; mul 431 3606; sub 3605 3607; sub 3602 3608; mul 90
3609; mul 579 3606; mul 679 3604; add 3611 3612; add 124 3613; mul 783 3614; sub 3610 3615; mul 588 3606; mul 859
3617; add 3616 3618; mul 987 3614; mul 783 3609; sub 3620 3621; mul 994 3617; sub 3622 3623; mul 859 3609; mul 994
3614; sub 3625 3626; mul 1003 3617; add 3627 3628; neg 783; neg 1682; neg 1836; neg 1776; neg 1779; neg 1695; neg
1846; neg 1786; neg 1703; neg 1852; neg 1707; neg 1855; neg 1796; neg 1799; neg 1726; neg 1866; neg 1806; neg 1809;
store f 0 0; store f 1 983; store f 2 130; store f 3 996; store f 4 395; store f 5 1005; store f 6 1009; store f 7
1012; store f 8 1015; store f 9 1017; store f 10 1020; store f 11 1022; store f 12 1024; store f 13 1026; store f 14
1040; store f 15 1049; store f 16 1058; store f 17 1067; store a 18 1738; store a 54 1812; store a 90 1875; store a
108 1878; store a 126 1881; store a 144 1878; store a 162 1881; store a 180 1878; store a 198 1881; store a 216
1023; store a 234 1025; store a 1 2; store a 19 1941; store a 55 1946; store a 91 1952; store a 109 1953; store a
127 1954; store a 145 1953; store a 163 1954; store a 181 1953; store a 199 1954; store a 253 1955; store a 271
1956; store a 289 1957; store a 307 1958; store a 20 2604; store a 56 2634; store a 92 2654; store a 110 2657; store
a 128 2660; store a 146 2657; store a 164 2660; store a 182 2657; store a 200 2660; store a 21 2715; store a 39 2;
store a 57 2720; store a 93 2725; store a 111 2726; store a 129 2727; store a 147 2726; store a 165 2727; store a
183 2726; store a 201 2727; store a 255 2729; store a 273 2731; store a 291 2733; store a 309 2735; store a 22 3262;
store a 58 3292; store a 94 3312; store a 112 3315; store a 130 3318; store a 148 3315; store a 166 3318; store a
184 3315; store a 202 3318; store a 23 3358; store a 59 3363; store a 77 2; store a 95 3368; store a 113 3369; store
a 131 3370; store a 149 3369; store a 167 3370; store a 185 3369; store a 203 3370; store a 24 3384; store a 60
3389; store a 96 3394; store a 114 3395; store a 25 3409; store a 61 3414; store a 97 3419; store a 133 3395; store
a 26 3433; store a 62 3438; store a 98 3443; store a 152 3444; store a 27 3458; store a 63 3463; store a 99 3468;
store a 171 3444; store a 28 3482; store a 64 3487; store a 100 3492; store a 190 3493; store a 29 3507; store a 65
3512; store a 101 3517; store a 209 3493; store a 30 3518; store a 66 3520; store a 102 3521; store a 228 3522;
store a 31 3523; store a 67 3525; store a 103 3526; store a 247 3527; store a 32 3531; store a 68 3534; store a 104
3537; store a 33 3541; store a 69 3544; store a 105 3547; store a 34 3551; store a 70 3554; store a 106 3557; store
a 35 3561; store a 71 3564; store a 107 3567; store b 2 3588; store b 6 3593; store b 10 3598; store b 3 3619; store
b 7 3624; store b 11 3629; store by_c 13 90; store by_c 39 3630; store by_c 65 859; store by_c 14 3631; store by_c
40 1772; store by_c 66 3632; store by_c 15 1686; store by_c 41 3633; store by_c 67 1839; store by_c 16 1690; store
by_c 42 3634; store by_c 68 1842; store by_c 17 3635; store by_c 43 1783; store by_c 69 3636; store by_c 18 1699;
store by_c 44 3637; store by_c 70 1849; store by_c 19 3638; store by_c 45 1789; store by_c 71 3639; store by_c 20
3640; store by_c 46 1792; store by_c 72 3641; store by_c 21 1717; store by_c 47 3642; store by_c 73 1859; store by_c
22 1721; store by_c 48 3643; store by_c 74 1862; store by_c 23 3644; store by_c 49 1803; store by_c 75 3645; store
by_c 24 1730; store by_c 50 3646; store by_c 76 1869; store by_c 25 1734; store by_c 51 3647; store by_c 77 1872
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'p': 234},
    {'by_k': 1944},
    """
constant 0.5249999999999999; constant -0.5249999999999999; input x 0; input p 17; mul 2 3; max 1 4; min 0 5;
constant 0.0; constant 0.35; sub 6 8; max 7 9; mul 10 10; constant -0.35; sub 12 6; max 7 13; mul 14 14; sub 11 15;
constant 1.0; div 17 8; mul 16 18; sub 6 19; mul 20 20; mul 20 21; input p 85; mul 22 23; constant
0.8999999999999999; constant -0.8999999999999999; input x 2; max 26 27; min 25 28; constant 0.6; sub 29 30; max 7
31; mul 32 32; constant -0.6; sub 34 29; max 7 35; mul 36 36; sub 33 37; div 17 30; mul 38 39; sub 29 40; mul 21 41;
input p 80; mul 42 43; add 24 44; mul 20 41; mul 41 46; input p 75; mul 47 48; add 45 49; mul 41 41; mul 41 51;
input p 86; mul 52 53; add 50 54; constant 1.25; constant 2.4000000000000004; constant -2.4000000000000004; input x
4; max 58 59; min 57 60; constant 1.6; sub 61 62; max 7 63; constant -1.6; sub 65 61; max 7 66; add 64 67; mul 56
68; sub 17 69; mul 55 70; input p 76; input p 77; constant 0.5; input p 12; mul 2 75; input p 6; mul 27 77; add 76
78; input p 10; mul 59 80; add 79 81; mul 2 82; mul 2 77; input p 7; mul 27 85; add 84 86; input p 8; mul 59 88; add
87 89; mul 27 90; add 83 91; mul 2 80; mul 27 88; add 93 94; input p 11; mul 59 96; add 95 97; mul 59 98; add 92 99;
mul 74 100; input p 78; constant 0.25; input p 69; mul 22 104; input p 70; mul 42 106; add 105 107; mul 64 64; mul
67 67; sub 109 110; div 17 62; mul 111 112; sub 61 113; mul 21 114; input p 71; mul 115 116; add 108 117; input p
72; mul 47 119; add 118 120; mul 46 114; input p 73; mul 122 123; add 121 124; input p 74; mul 52 126; add 125 127;
mul 51 114; mul 48 129; add 128 130; mul 20 131; input p 79; mul 22 133; mul 42 119; add 134 135; mul 43 115; add
136 137; input p 81; mul 47 139; add 138 140; input p 82; mul 122 142; add 141 143; input p 83; mul 52 145; add 144
146; input p 84; mul 129 148; add 147 149; mul 41 150; add 132 151; mul 55 114; add 152 153; mul 103 154; mul 102
155; add 101 156; add 73 157; input p 1; mul 27 159; mul 27 160; add 17 161; sqrt 162; div 17 163; input p 2; mul 27
165; mul 27 166; add 17 167; sqrt 168; mul 164 169; input p 87; mul 170 171; add 158 172; mul 27 164; input p 88;
mul 174 175; sub 173 176; input p 89; mul 170 175; input p 90; sub 179 180; mul 171 174; add 181 182; sub 183 2; mul
184 184; mul 177 177; add 185 186; sqrt 187; mul 178 188; sqrt 189; div 17 190; mul 191 191; mul 178 192; mul 177
193; input p 91; constant 2.0; mul 189 196; mul 192 196; mul 192 198; sub 197 199; mul 195 200; constant 0.3;
constant -0.3; constant 1.4; sub 189 204; max 203 205; min 202 206; input p 92; input p 93; mul 207 209; add 208
210; mul 207 211; add 17 212; mul 201 213; input u 0; input p 94; mul 215 216; input p 95; input p 96; mul 205 219;
add 218 220; mul 205 221; add 17 222; mul 217 223; sub 214 224; mul 178 225; input p 97; input x 6; mul 227 228;
input p 98; input x 8; mul 230 231; add 229 232; input p 99; input x 10; mul 234 235; add 233 236; constant -0.5;
mul 191 238; mul 191 239; mul 191 240; mul 178 241; input p 100; input p 101; mul 205 244; add 243 245; mul 205 246;
add 17 247; mul 242 248; mul 237 249; add 226 250; input p 102; mul 249 252; mul 249 253; input x 3; mul 163 169;
div 17 256; mul 164 257; sub 172 176; mul 184 259; add 179 182; mul 177 261; sub 260 262; mul 193 263; mul 258 264;
mul 255 265; input x 1; mul 184 193; mul 267 268; sub 266 269; constant 5.714285714285714; add 10 14; mul 271 272;
sub 17 273; mul 131 274; add 82 275; mul 267 276; constant 3.3333333333333335; add 32 36; mul 278 279; sub 17 280;
mul 150 281; mul 102 282; add 90 283; mul 255 284; add 277 285; input x 5; mul 71 102; add 98 288; mul 287 289; add
286 290; mul 194 291; add 270 292; mul 254 293; add 251 294; mul 194 295; input p 103; add 157 297; input p 104; mul
170 299; add 298 300; input p 105; mul 174 302; add 301 303; input p 106; mul 174 299; mul 170 302; input p 107; sub
307 308; sub 306 309; sub 310 2; mul 311 311; mul 304 304; add 312 313; sqrt 314; mul 305 315; sqrt 316; div 17 317;
mul 318 318; mul 305 319; mul 304 320; input p 108; mul 196 316; mul 196 319; mul 319 324; sub 323 325; mul 322 326;
sub 316 204; max 203 328; min 202 329; input p 109; input p 110; mul 330 332; add 331 333; mul 330 334; add 17 335;
mul 327 336; input u 1; input p 111; mul 338 339; input p 112; input p 113; mul 328 342; add 341 343; mul 328 344;
add 17 345; mul 340 346; sub 337 347; mul 305 348; input p 114; input x 7; mul 350 351; input p 115; input x 9; mul
353 354; add 352 355; input p 116; input x 11; mul 357 358; add 356 359; mul 238 318; mul 318 361; mul 318 362; mul
305 363; mul 244 328; add 243 365; mul 328 366; add 17 367; mul 364 368; mul 360 369; add 349 370; input p 117; mul
369 372; mul 369 373; add 300 303; mul 311 375; sub 307 306; mul 304 377; add 376 378; mul 320 379; mul 258 380; mul
255 381; mul 311 320; mul 267 383; sub 382 384; mul 291 321; add 385 386; mul 374 387; add 371 388; mul 321 389; add
296 390; sub 72 391; input p 4; input p 5; mul 174 258; mul 394 395; add 90 396; mul 98 397; mul 393 398; input p
13; mul 170 258; mul 394 401; mul 82 397; add 402 403; mul 393 404; add 400 405; mul 399 406; input p 0; input p 3;
mul 258 409; mul 258 410; add 408 411; mul 402 402; mul 397 397; add 413 414; mul 393 415; add 412 416; mul 82 98;
mul 393 418; mul 417 419; sub 407 420; input p 9; mul 98 98; mul 393 423; add 422 424; mul 417 425; mul 399 399; sub
426 427; mul 82 82; add 17 429; mul 393 430; mul 428 431; mul 406 425; mul 399 419; sub 433 434; mul 406 435; sub
432 436; mul 419 421; add 437 438; div 17 439; mul 421 440; mul 392 441; mul 435 440; mul 381 443; mul 428 440; mul
383 445; add 444 446; mul 289 441; mul 284 443; sub 448 449; mul 276 445; add 450 451; mul 321 452; sub 447 453; mul
374 454; mul 321 455; mul 265 443; mul 268 445; add 457 458; mul 194 452; sub 459 460; mul 254 461; mul 194 462; add
456 463; mul 287 464; add 442 465; mul 71 466; mul 291 455; mul 389 452; sub 468 469; mul 320 470; mul 389 443; mul
255 455; add 472 473; mul 258 474; mul 320 475; mul 377 476; add 471 477; mul 196 304; mul 196 315; div 17 480; mul
387 454; mul 373 482; mul 369 482; mul 372 484; add 483 485; mul 360 454; add 486 487; mul 364 488; mul 366 489; mul
328 489; mul 244 491; add 490 492; mul 305 454; mul 340 494; mul 344 495; sub 493 496; mul 328 495; mul 342 498; sub
497 499; le 203 328; le 328 203; add 501 502; div 17 503; mul 501 504; le 329 202; le 202 329; add 506 507; div 17
508; mul 506 509; mul 327 494; mul 334 511; mul 330 511; mul 332 513; add 512 514; mul 510 515; mul 505 516; add 500
517; mul 196 317; div 17 519; mul 318 363; mul 368 488; mul 305 522; mul 521 523; mul 318 523; mul 363 525; add 524
526; mul 318 525; mul 362 528; add 527 529; mul 196 318; mul 304 470; mul 389 445; mul 267 455; sub 533 534; mul 311
535; add 532 536; mul 379 475; add 537 538; mul 305 539; mul 336 494; mul 322 541; mul 324 542; sub 540 543; mul 319
542; neg 545; mul 196 546; add 544 547; mul 531 548; mul 319 549; add 530 550; mul 520 551; sub 518 552; mul 196
542; add 553 554; mul 305 555; mul 481 556; mul 479 557; add 478 558; sub 467 559; mul 255 464; mul 392 443; sub 561
562; mul 282 563; add 560 564; mul 291 462; mul 295 452; sub 566 567; mul 193 568; mul 295 443; mul 255 462; add 570
571; mul 258 572; mul 193 573; mul 261 574; sub 569 575; mul 177 196; mul 188 196; div 17 578; mul 293 461; mul 253
580; mul 249 580; mul 252 582; add 581 583; mul 237 461; add 584 585; mul 242 586; mul 246 587; mul 205 587; mul 244
589; add 588 590; mul 178 461; mul 217 592; mul 221 593; sub 591 594; mul 205 593; mul 219 596; sub 595 597; le 203
205; le 205 203; add 599 600; div 17 601; mul 599 602; le 206 202; le 202 206; add 604 605; div 17 606; mul 604 607;
mul 201 592; mul 211 609; mul 207 609; mul 209 611; add 610 612; mul 608 613; mul 603 614; add 598 615; mul 190 196;
div 17 617; mul 191 241; mul 248 586; mul 178 620; mul 619 621; mul 191 621; mul 241 623; add 622 624; mul 191 623;
mul 240 626; add 625 627; mul 191 196; mul 177 568; mul 295 445; mul 267 462; sub 631 632; mul 184 633; add 630 634;
mul 263 573; add 635 636; mul 178 637; mul 213 592; mul 195 639; mul 198 640; sub 638 641; mul 192 640; neg 643; mul
196 644; add 642 645; mul 629 646; mul 192 647; add 628 648; mul 618 649; sub 616 650; mul 196 640; add 651 652; mul
178 653; mul 579 654; mul 577 655; add 576 656; add 559 657; mul 155 658; add 565 659; mul 3 4; le 1 4; le 4 1; add
662 663; div 17 664; mul 662 665; le 5 0; le 0 5; add 667 668; div 17 669; mul 667 670; mul 102 658; mul 103 672;
mul 131 673; mul 102 563; mul 281 675; mul 41 673; add 676 677; mul 142 678; mul 392 445; mul 267 464; add 680 681;
mul 274 682; mul 20 673; add 683 684; mul 123 685; add 679 686; mul 114 687; mul 102 466; mul 70 689; mul 114 673;
add 690 691; mul 48 692; mul 139 678; add 693 694; mul 119 685; add 695 696; mul 41 697; add 688 698; mul 41 699;
add 674 700; mul 23 692; mul 133 678; add 702 703; mul 104 685; add 704 705; mul 21 706; add 701 707; mul 20 196;
mul 43 678; mul 116 685; add 710 711; mul 114 712; mul 43 692; mul 119 678; add 714 715; mul 106 685; add 716 717;
mul 41 718; add 713 719; mul 20 706; add 720 721; mul 709 722; add 708 723; le 7 13; le 13 7; add 725 726; div 17
727; mul 725 728; mul 14 196; constant 2.857142857142857; mul 724 731; mul 730 732; mul 131 682; mul 271 734; sub
733 735; mul 729 736; sub 724 737; le 7 9; le 9 7; add 739 740; div 17 741; mul 739 742; mul 10 196; mul 732 744;
add 735 745; mul 743 746; sub 738 747; mul 671 748; mul 666 749; mul 661 750; sub 660 751; sub 752 657; input p 18;
input p 19; input p 20; mul 4 756; input p 21; mul 27 758; add 757 759; input p 22; mul 59 761; add 760 762; mul 755
763; input p 23; mul 59 763; mul 765 766; add 764 767; input p 24; mul 59 766; mul 769 770; add 768 771; input p 25;
mul 763 763; mul 773 774; add 772 775; input p 26; mul 59 774; mul 777 778; add 776 779; input p 27; mul 763 774;
mul 781 782; add 780 783; input p 28; mul 4 785; add 784 786; input p 29; mul 4 59; mul 788 789; add 787 790; input
p 30; mul 59 789; mul 792 793; add 791 794; input p 31; mul 4 763; mul 796 797; add 795 798; input p 32; mul 59 797;
mul 800 801; add 799 802; input p 33; mul 763 797; mul 804 805; add 803 806; input p 34; mul 4 4; mul 763 809; mul
808 810; add 807 811; input p 35; mul 4 809; mul 813 814; add 812 815; input p 36; input p 37; mul 59 818; add 817
819; input p 38; mul 59 59; mul 821 822; add 820 823; input p 39; mul 59 822; mul 825 826; add 824 827; input p 40;
mul 763 829; add 828 830; input p 41; mul 766 832; add 831 833; input p 42; mul 770 835; add 834 836; input p 43;
mul 774 838; add 837 839; input p 44; mul 778 841; add 840 842; input p 45; mul 782 844; add 843 845; mul 4 755; add
846 847; mul 765 789; add 848 849; mul 769 793; add 850 851; input p 46; mul 797 853; add 852 854; input p 47; mul
801 856; add 855 857; input p 48; mul 805 859; add 858 860; input p 49; mul 809 862; add 861 863; input p 50; mul 59
809; mul 865 866; add 864 867; mul 804 810; add 868 869; input p 51; mul 814 871; add 870 872; mul 756 873; add 816
874; input p 52; mul 21 876; input p 53; mul 46 878; add 877 879; input p 54; mul 20 114; mul 881 882; add 880 883;
input p 55; mul 51 885; add 884 886; input p 56; mul 41 114; mul 888 889; add 887 890; input p 57; mul 114 114; mul
892 893; add 891 894; mul 114 893; mul 895 896; input p 58; mul 22 898; input p 59; mul 42 900; add 899 901; input p
60; mul 115 903; add 902 904; input p 61; mul 47 906; add 905 907; input p 62; mul 122 909; add 908 910; input p 63;
mul 114 882; mul 912 913; add 911 914; input p 64; mul 52 916; add 915 917; input p 65; mul 129 919; add 918 920;
input p 66; mul 114 889; mul 922 923; add 921 924; input p 67; mul 896 926; add 925 927; add 897 928; mul 274 929;
add 875 930; mul 754 931; input p 68; constant 12.0; mul 3 267; mul 934 935; constant -6.0; mul 756 935; mul 255
758; add 938 939; mul 287 761; add 940 941; mul 937 942; add 936 943; mul 933 944; mul 935 937; constant 4.0; mul
942 947; add 946 948; mul 933 949; mul 756 950; add 945 951; add 932 952; mul 3 953; mul 3 954; mul 445 955; add 753
956; mul 3 935; mul 443 758; mul 441 761; sub 959 960; mul 3 445; mul 756 962; sub 961 963; mul 933 964; mul 937
965; mul 947 965; mul 933 962; mul 937 968; sub 967 969; mul 756 970; add 966 971; mul 934 968; sub 972 973; mul 958
974; sub 957 975; input p 134; mul 443 754; mul 281 978; mul 977 979; input p 164; constant 3.0; mul 893 982; mul
441 754; mul 70 984; mul 983 985; mul 981 986; input p 158; mul 985 988; add 987 989; sub 980 990; mul 754 962; mul
274 992; mul 898 993; sub 991 994; mul 21 995; mul 896 979; mul 888 997; input p 154; mul 896 985; mul 999 1000; sub
998 1001; mul 922 979; mul 892 986; input p 160; mul 985 1005; add 1004 1006; sub 1003 1007; mul 912 993; sub 1008
1009; mul 114 1010; add 1002 1011; mul 896 993; mul 881 1013; sub 1012 1014; mul 114 1015; add 996 1016; input p
130; mul 997 1018; mul 888 1000; sub 1019 1020; input p 137; mul 979 1022; mul 888 986; input p 159; mul 985 1025;
add 1024 1026; sub 1023 1027; mul 909 993; sub 1028 1029; mul 114 1030; add 1021 1031; input p 136; mul 979 1033;
mul 885 986; mul 919 985; add 1035 1036; sub 1034 1037; mul 906 993; sub 1038 1039; mul 41 1040; add 1032 1041; mul
878 1013; sub 1042 1043; mul 41 1044; add 1017 1045; input p 129; mul 997 1047; input p 153; mul 1000 1049; sub 1048
1050; input p 135; mul 979 1052; mul 986 1049; mul 912 985; add 1054 1055; sub 1053 1056; mul 903 993; sub 1057
1058; mul 114 1059; add 1051 1060; mul 906 979; mul 986 1047; mul 985 1052; add 1063 1064; sub 1062 1065; mul 900
993; sub 1066 1067; mul 41 1068; add 1061 1069; mul 20 995; add 1070 1071; mul 876 1013; sub 1072 1073; mul 709
1074; add 1046 1075; mul 929 992; mul 271 1077; mul 731 1076; mul 730 1079; add 1078 1080; mul 729 1081; sub 1076
1082; mul 744 1079; sub 1078 1084; mul 743 1085; add 1083 1086; mul 671 1087; mul 666 1088; mul 661 1089; sub 976
1090; mul 758 978; mul 761 984; sub 1092 1093; mul 756 992; sub 1094 1095; mul 871 1096; mul 809 1097; mul 4 196;
mul 865 984; mul 763 1100; mul 1099 1101; mul 792 984; mul 59 1103; mul 1099 1104; add 1102 1105; input p 152; mul
984 1107; mul 1099 1108; add 1106 1109; mul 777 984; mul 763 1111; mul 763 1112; add 1110 1113; input p 151; mul 984
1115; mul 59 1116; mul 763 1117; add 1114 1118; mul 765 984; mul 763 1120; add 1119 1121; sub 1098 1122; mul 4 1097;
mul 1099 1124; add 1123 1125; mul 804 1096; mul 763 1127; mul 1099 1128; add 1126 1129; mul 865 1096; mul 59 1131;
mul 1099 1132; add 1130 1133; mul 862 1096; mul 1099 1135; add 1134 1136; mul 859 1096; mul 763 1138; mul 763 1139;
add 1137 1140; mul 856 1096; mul 59 1142; mul 763 1143; add 1141 1144; mul 853 1096; mul 763 1146; add 1145 1147;
mul 769 1096; mul 59 1149; mul 59 1150; add 1148 1151; mul 765 1096; mul 59 1153; add 1152 1154; mul 755 1096; add
1155 1156; mul 813 992; mul 809 1158; sub 1157 1159; mul 4 1158; mul 1099 1161; sub 1160 1162; mul 808 992; mul 763
1164; mul 1099 1165; sub 1163 1166; mul 804 992; mul 763 1168; mul 763 1169; sub 1167 1170; mul 800 992; mul 59
1172; mul 763 1173; sub 1171 1174; mul 796 992; mul 763 1176; sub 1175 1177; mul 792 992; mul 59 1179; mul 59 1180;
sub 1178 1181; mul 788 992; mul 59 1183; sub 1182 1184; mul 785 992; sub 1185 1186; mul 809 1127; mul 809 1100; mul
797 1111; add 1189 1190; mul 4 1112; add 1191 1192; mul 4 1117; add 1193 1194; mul 4 1120; add 1195 1196; input p
150; mul 984 1198; mul 774 1199; add 1197 1200; mul 196 763; mul 763 1199; mul 1202 1203; add 1201 1204; mul 835
984; mul 59 1206; mul 1202 1207; add 1205 1208; input p 149; mul 984 1210; mul 1202 1211; add 1209 1212; input p
148; mul 984 1214; mul 59 1215; mul 59 1216; add 1213 1217; input p 147; mul 984 1219; mul 59 1220; add 1218 1221;
mul 818 984; add 1222 1223; sub 1188 1224; mul 797 1138; add 1225 1226; mul 4 1139; add 1227 1228; mul 4 1143; add
1229 1230; mul 4 1146; add 1231 1232; mul 844 1096; mul 774 1234; add 1233 1235; mul 763 1234; mul 1202 1237; add
1236 1238; mul 841 1096; mul 59 1240; mul 1202 1241; add 1239 1242; mul 838 1096; mul 1202 1244; add 1243 1245; mul
835 1096; mul 59 1247; mul 59 1248; add 1246 1249; mul 832 1096; mul 59 1251; add 1250 1252; mul 829 1096; add 1253
1254; mul 809 1164; sub 1255 1256; mul 797 1168; sub 1257 1258; mul 4 1169; sub 1259 1260; mul 4 1173; sub 1261
1262; mul 4 1176; sub 1263 1264; mul 781 992; mul 774 1266; sub 1265 1267; mul 763 1266; mul 1202 1269; sub 1268
1270; mul 777 992; mul 59 1272; mul 1202 1273; sub 1271 1274; mul 773 992; mul 1202 1276; sub 1275 1277; mul 769
992; mul 59 1279; mul 59 1280; sub 1278 1281; mul 765 992; mul 59 1283; sub 1282 1284; mul 755 992; sub 1285 1286;
mul 756 1287; add 1187 1288; mul 661 1289; sub 1091 1290; input p 212; input c 4; input p 14; mul 2 1294; sub 27
1295; input c 5; mul 1296 1297; sub 1293 1298; input c 6; mul 215 1300; add 1299 1301; input c 7; mul 338 1303; add
1302 1304; input c 8; input p 15; max 1306 1307; mul 267 1294; sub 255 1309; mul 1308 1310; sub 1305 1311; mul 445
1312; mul 445 1294; add 443 1314; mul 1308 1315; mul 267 1316; add 1313 1317; mul 1297 1315; input c 9; input c 10;
mul 74 1321; mul 1296 1322; sub 1320 1323; input c 11; mul 215 1325; add 1324 1326; input c 12; mul 338 1328; add
1327 1329; mul 445 1330; add 1319 1331; mul 445 1296; mul 1322 1333; sub 1332 1334; mul 2 1335; add 1318 1336; mul
1292 1337; add 1291 1338; mul 425 431; mul 419 419; sub 1340 1341; mul 440 1342; mul 392 1343; mul 381 1343; mul 383
443; add 1345 1346; mul 284 1343; mul 399 431; mul 406 419; sub 1349 1350; mul 440 1351; mul 289 1352; sub 1348
1353; mul 276 443; sub 1354 1355; mul 321 1356; add 1347 1357; mul 374 1358; mul 321 1359; mul 265 1343; mul 268
443; add 1361 1362; mul 194 1356; add 1363 1364; mul 254 1365; mul 194 1366; add 1360 1367; mul 255 1368; sub 1344
1369; mul 282 1370; mul 305 1358; mul 340 1372; mul 344 1373; mul 387 1358; mul 373 1375; mul 369 1375; mul 372
1377; add 1376 1378; mul 360 1358; add 1379 1380; mul 364 1381; mul 366 1382; mul 328 1382; mul 244 1384; add 1383
1385; sub 1374 1386; mul 328 1373; mul 342 1388; add 1387 1389; mul 327 1372; mul 334 1391; mul 330 1391; mul 332
1393; add 1392 1394; mul 510 1395; mul 505 1396; sub 1390 1397; mul 368 1381; mul 305 1399; mul 521 1400; mul 318
1400; mul 363 1402; add 1401 1403; mul 318 1402; mul 362 1405; add 1404 1406; mul 267 1359; sub 1408 472; mul 311
1409; mul 389 1356; mul 291 1359; add 1411 1412; mul 304 1413; sub 1410 1414; mul 389 1343; mul 255 1359; add 1416
1417; mul 258 1418; mul 379 1419; sub 1415 1420; mul 305 1421; mul 336 1372; mul 322 1423; mul 324 1424; add 1422
1425; mul 319 1424; mul 196 1427; add 1426 1428; mul 531 1429; mul 319 1430; sub 1407 1431; mul 520 1432; add 1398
1433; neg 1424; mul 196 1435; add 1434 1436; mul 305 1437; mul 481 1438; mul 479 1439; mul 320 1413; mul 320 1419;
mul 377 1442; add 1441 1443; sub 1440 1444; mul 392 1352; mul 287 1368; add 1446 1447; mul 71 1448; add 1445 1449;
sub 1371 1450; mul 295 1343; mul 255 1366; add 1452 1453; mul 258 1454; mul 193 1455; mul 261 1456; mul 295 1356;
mul 291 1366; add 1458 1459; mul 193 1460; sub 1457 1461; mul 178 1365; mul 217 1463; mul 221 1464; mul 293 1365;
mul 253 1466; mul 249 1466; mul 252 1468; add 1467 1469; mul 237 1365; add 1470 1471; mul 242 1472; mul 246 1473;
mul 205 1473; mul 244 1475; add 1474 1476; sub 1465 1477; mul 205 1464; mul 219 1479; add 1478 1480; mul 201 1463;
mul 211 1482; mul 207 1482; mul 209 1484; add 1483 1485; mul 608 1486; mul 603 1487; sub 1481 1488; mul 248 1472;
mul 178 1490; mul 619 1491; mul 191 1491; mul 241 1493; add 1492 1494; mul 191 1493; mul 240 1496; add 1495 1497;
mul 267 1366; sub 1499 570; mul 184 1500; mul 177 1460; sub 1501 1502; mul 263 1455; sub 1503 1504; mul 178 1505;
mul 213 1463; mul 195 1507; mul 198 1508; add 1506 1509; mul 192 1508; mul 196 1511; add 1510 1512; mul 629 1513;
mul 192 1514; sub 1498 1515; mul 618 1516; add 1489 1517; neg 1508; mul 196 1519; add 1518 1520; mul 178 1521; mul
579 1522; mul 577 1523; add 1462 1524; add 1445 1525; mul 155 1526; add 1451 1527; mul 102 1526; mul 103 1529; mul
131 1530; mul 102 1370; mul 281 1532; mul 41 1530; add 1533 1534; mul 142 1535; mul 20 1530; mul 267 1368; add 562
1538; mul 274 1539; sub 1537 1540; mul 123 1541; add 1536 1542; mul 114 1543; mul 114 1530; mul 102 1448; mul 70
1546; sub 1545 1547; mul 48 1548; mul 139 1535; add 1549 1550; mul 119 1541; add 1551 1552; mul 41 1553; add 1544
1554; mul 41 1555; add 1531 1556; mul 23 1548; mul 133 1535; add 1558 1559; mul 104 1541; add 1560 1561; mul 21
1562; add 1557 1563; mul 43 1535; mul 116 1541; add 1565 1566; mul 114 1567; mul 43 1548; mul 119 1535; add 1569
1570; mul 106 1541; add 1571 1572; mul 41 1573; add 1568 1574; mul 20 1562; add 1575 1576; mul 709 1577; add 1564
1578; mul 131 1539; mul 271 1580; mul 731 1579; mul 730 1582; add 1581 1583; mul 729 1584; sub 1579 1585; mul 744
1582; sub 1581 1587; mul 743 1588; add 1586 1589; mul 671 1590; mul 666 1591; mul 661 1592; sub 1528 1593; sub 1594
1525; mul 443 955; sub 1595 1596; mul 761 1352; mul 758 1343; sub 1598 1599; mul 3 443; mul 756 1601; add 1600 1602;
mul 933 1603; mul 937 1604; mul 947 1604; mul 933 1601; mul 937 1607; add 1606 1608; mul 756 1609; add 1605 1610;
mul 934 1607; add 1611 1612; mul 958 1613; sub 1597 1614; mul 754 1352; mul 70 1616; mul 983 1617; mul 981 1618; mul
988 1617; add 1619 1620; mul 754 1343; mul 281 1622; mul 977 1623; sub 1621 1624; mul 754 1601; mul 274 1626; mul
898 1627; add 1625 1628; mul 21 1629; mul 896 1617; mul 999 1631; mul 896 1623; mul 888 1633; sub 1632 1634; mul 892
1618; mul 1005 1617; add 1636 1637; mul 922 1623; sub 1638 1639; mul 912 1627; add 1640 1641; mul 114 1642; add 1635
1643; mul 896 1627; mul 881 1645; add 1644 1646; mul 114 1647; add 1630 1648; mul 888 1631; mul 1018 1633; sub 1650
1651; mul 888 1618; mul 1025 1617; add 1653 1654; mul 1022 1623; sub 1655 1656; mul 909 1627; add 1657 1658; mul 114
1659; add 1652 1660; mul 885 1618; mul 919 1617; add 1662 1663; mul 1033 1623; sub 1664 1665; mul 906 1627; add 1666
1667; mul 41 1668; add 1661 1669; mul 878 1645; add 1670 1671; mul 41 1672; add 1649 1673; mul 1049 1631; mul 1047
1633; sub 1675 1676; mul 1049 1618; mul 912 1617; add 1678 1679; mul 1052 1623; sub 1680 1681; mul 903 1627; add
1682 1683; mul 114 1684; add 1677 1685; mul 1047 1618; mul 1052 1617; add 1687 1688; mul 906 1623; sub 1689 1690;
mul 900 1627; add 1691 1692; mul 41 1693; add 1686 1694; mul 20 1629; add 1695 1696; mul 876 1645; add 1697 1698;
mul 709 1699; add 1674 1700; mul 731 1701; mul 730 1702; mul 929 1626; mul 271 1704; sub 1703 1705; mul 729 1706;
sub 1701 1707; mul 744 1702; add 1705 1709; mul 743 1710; sub 1708 1711; mul 671 1712; mul 666 1713; mul 661 1714;
sub 1615 1715; mul 865 1616; mul 763 1717; mul 1099 1718; mul 792 1616; mul 59 1720; mul 1099 1721; add 1719 1722;
mul 1107 1616; mul 1099 1724; add 1723 1725; mul 777 1616; mul 763 1727; mul 763 1728; add 1726 1729; mul 1115 1616;
mul 59 1731; mul 763 1732; add 1730 1733; mul 765 1616; mul 763 1735; add 1734 1736; mul 761 1616; mul 758 1622; sub
1738 1739; mul 756 1626; add 1740 1741; mul 871 1742; mul 809 1743; add 1737 1744; mul 4 1743; mul 1099 1746; add
1745 1747; mul 804 1742; mul 763 1749; mul 1099 1750; add 1748 1751; mul 865 1742; mul 59 1753; mul 1099 1754; add
1752 1755; mul 862 1742; mul 1099 1757; add 1756 1758; mul 859 1742; mul 763 1760; mul 763 1761; add 1759 1762; mul
856 1742; mul 59 1764; mul 763 1765; add 1763 1766; mul 853 1742; mul 763 1768; add 1767 1769; mul 769 1742; mul 59
1771; mul 59 1772; add 1770 1773; mul 765 1742; mul 59 1775; add 1774 1776; mul 755 1742; add 1777 1778; mul 813
1626; mul 809 1780; add 1779 1781; mul 4 1780; mul 1099 1783; add 1782 1784; mul 808 1626; mul 763 1786; mul 1099
1787; add 1785 1788; mul 804 1626; mul 763 1790; mul 763 1791; add 1789 1792; mul 800 1626; mul 59 1794; mul 763
1795; add 1793 1796; mul 796 1626; mul 763 1798; add 1797 1799; mul 792 1626; mul 59 1801; mul 59 1802; add 1800
1803; mul 788 1626; mul 59 1805; add 1804 1806; mul 785 1626; add 1807 1808; mul 809 1717; mul 797 1727; add 1810
1811; mul 4 1728; add 1812 1813; mul 4 1732; add 1814 1815; mul 4 1735; add 1816 1817; mul 1198 1616; mul 774 1819;
add 1818 1820; mul 763 1819; mul 1202 1822; add 1821 1823; mul 835 1616; mul 59 1825; mul 1202 1826; add 1824 1827;
mul 1210 1616; mul 1202 1829; add 1828 1830; mul 1214 1616; mul 59 1832; mul 59 1833; add 1831 1834; mul 1219 1616;
mul 59 1836; add 1835 1837; mul 818 1616; add 1838 1839; mul 809 1749; add 1840 1841; mul 797 1760; add 1842 1843;
mul 4 1761; add 1844 1845; mul 4 1765; add 1846 1847; mul 4 1768; add 1848 1849; mul 844 1742; mul 774 1851; add
1850 1852; mul 763 1851; mul 1202 1854; add 1853 1855; mul 841 1742; mul 59 1857; mul 1202 1858; add 1856 1859; mul
838 1742; mul 1202 1861; add 1860 1862; mul 835 1742; mul 59 1864; mul 59 1865; add 1863 1866; mul 832 1742; mul 59
1868; add 1867 1869; mul 829 1742; add 1870 1871; mul 809 1786; add 1872 1873; mul 797 1790; add 1874 1875; mul 4
1791; add 1876 1877; mul 4 1795; add 1878 1879; mul 4 1798; add 1880 1881; mul 781 1626; mul 774 1883; add 1882
1884; mul 763 1883; mul 1202 1886; add 1885 1887; mul 777 1626; mul 59 1889; mul 1202 1890; add 1888 1891; mul 773
1626; mul 1202 1893; add 1892 1894; mul 769 1626; mul 59 1896; mul 59 1897; add 1895 1898; mul 765 1626; mul 59
1900; add 1899 1901; mul 755 1626; add 1902 1903; mul 756 1904; add 1809 1905; mul 661 1906; sub 1716 1907; mul 443
1312; mul 443 1294; add 1343 1910; mul 1308 1911; mul 267 1912; add 1909 1913; mul 443 1296; mul 1322 1915; mul 1297
1911; mul 443 1330; add 1917 1918; sub 1916 1919; mul 2 1920; sub 1914 1921; mul 1292 1922; sub 1908 1923; mul 417
431; mul 406 406; sub 1925 1926; mul 440 1927; mul 392 1928; mul 381 1352; mul 383 441; add 1930 1931; mul 289 1928;
mul 284 1352; sub 1933 1934; mul 276 441; add 1935 1936; mul 321 1937; sub 1932 1938; mul 374 1939; mul 321 1940;
mul 265 1352; mul 268 441; add 1942 1943; mul 194 1937; sub 1944 1945; mul 254 1946; mul 194 1947; add 1941 1948;
mul 287 1949; add 1929 1950; mul 71 1951; mul 291 1940; mul 389 1937; sub 1953 1954; mul 320 1955; mul 389 1352; mul
255 1940; add 1957 1958; mul 258 1959; mul 320 1960; mul 377 1961; add 1956 1962; mul 387 1939; mul 373 1964; mul
369 1964; mul 372 1966; add 1965 1967; mul 360 1939; add 1968 1969; mul 364 1970; mul 366 1971; mul 328 1971; mul
244 1973; add 1972 1974; mul 305 1939; mul 340 1976; mul 344 1977; sub 1975 1978; mul 328 1977; mul 342 1980; sub
1979 1981; mul 327 1976; mul 334 1983; mul 330 1983; mul 332 1985; add 1984 1986; mul 510 1987; mul 505 1988; add
1982 1989; mul 368 1970; mul 305 1991; mul 521 1992; mul 318 1992; mul 363 1994; add 1993 1995; mul 318 1994; mul
362 1997; add 1996 1998; mul 304 1955; mul 389 441; mul 267 1940; sub 2001 2002; mul 311 2003; add 2000 2004; mul
379 1960; add 2005 2006; mul 305 2007; mul 336 1976; mul 322 2009; mul 324 2010; sub 2008 2011; mul 319 2010; neg
2013; mul 196 2014; add 2012 2015; mul 531 2016; mul 319 2017; add 1999 2018; mul 520 2019; sub 1990 2020; mul 196
2010; add 2021 2022; mul 305 2023; mul 481 2024; mul 479 2025; add 1963 2026; sub 1952 2027; mul 255 1949; sub 2029
1446; mul 282 2030; add 2028 2031; mul 291 1947; mul 295 1937; sub 2033 2034; mul 193 2035; mul 295 1352; mul 255
1947; add 2037 2038; mul 258 2039; mul 193 2040; mul 261 2041; sub 2036 2042; mul 293 1946; mul 253 2044; mul 249
2044; mul 252 2046; add 2045 2047; mul 237 1946; add 2048 2049; mul 242 2050; mul 246 2051; mul 205 2051; mul 244
2053; add 2052 2054; mul 178 1946; mul 217 2056; mul 221 2057; sub 2055 2058; mul 205 2057; mul 219 2060; sub 2059
2061; mul 201 2056; mul 211 2063; mul 207 2063; mul 209 2065; add 2064 2066; mul 608 2067; mul 603 2068; add 2062
2069; mul 248 2050; mul 178 2071; mul 619 2072; mul 191 2072; mul 241 2074; add 2073 2075; mul 191 2074; mul 240
2077; add 2076 2078; mul 177 2035; mul 295 441; mul 267 1947; sub 2081 2082; mul 184 2083; add 2080 2084; mul 263
2040; add 2085 2086; mul 178 2087; mul 213 2056; mul 195 2089; mul 198 2090; sub 2088 2091; mul 192 2090; neg 2093;
mul 196 2094; add 2092 2095; mul 629 2096; mul 192 2097; add 2079 2098; mul 618 2099; sub 2070 2100; mul 196 2090;
add 2101 2102; mul 178 2103; mul 579 2104; mul 577 2105; add 2043 2106; add 2027 2107; mul 155 2108; add 2032 2109;
mul 102 2108; mul 103 2111; mul 131 2112; mul 102 2030; mul 281 2114; mul 41 2112; add 2115 2116; mul 142 2117; mul
267 1949; add 442 2119; mul 274 2120; mul 20 2112; add 2121 2122; mul 123 2123; add 2118 2124; mul 114 2125; mul 102
1951; mul 70 2127; mul 114 2112; add 2128 2129; mul 48 2130; mul 139 2117; add 2131 2132; mul 119 2123; add 2133
2134; mul 41 2135; add 2126 2136; mul 41 2137; add 2113 2138; mul 23 2130; mul 133 2117; add 2140 2141; mul 104
2123; add 2142 2143; mul 21 2144; add 2139 2145; mul 43 2117; mul 116 2123; add 2147 2148; mul 114 2149; mul 43
2130; mul 119 2117; add 2151 2152; mul 106 2123; add 2153 2154; mul 41 2155; add 2150 2156; mul 20 2144; add 2157
2158; mul 709 2159; add 2146 2160; mul 731 2161; mul 730 2162; mul 131 2120; mul 271 2164; sub 2163 2165; mul 729
2166; sub 2161 2167; mul 744 2162; add 2165 2169; mul 743 2170; sub 2168 2171; mul 671 2172; mul 666 2173; mul 661
2174; sub 2110 2175; sub 2176 2107; mul 441 955; add 2177 2178; mul 758 1352; mul 761 1928; sub 2180 2181; mul 3
441; mul 756 2183; sub 2182 2184; mul 933 2185; mul 937 2186; mul 947 2186; mul 933 2183; mul 937 2189; sub 2188
2190; mul 756 2191; add 2187 2192; mul 934 2189; sub 2193 2194; mul 958 2195; sub 2179 2196; mul 281 1616; mul 977
2198; mul 754 1928; mul 70 2200; mul 983 2201; mul 981 2202; mul 988 2201; add 2203 2204; sub 2199 2205; mul 754
2183; mul 274 2207; mul 898 2208; sub 2206 2209; mul 21 2210; mul 896 2198; mul 888 2212; mul 896 2201; mul 999
2214; sub 2213 2215; mul 922 2198; mul 892 2202; mul 1005 2201; add 2218 2219; sub 2217 2220; mul 912 2208; sub 2221
2222; mul 114 2223; add 2216 2224; mul 896 2208; mul 881 2226; sub 2225 2227; mul 114 2228; add 2211 2229; mul 1018
2212; mul 888 2214; sub 2231 2232; mul 1022 2198; mul 888 2202; mul 1025 2201; add 2235 2236; sub 2234 2237; mul 909
2208; sub 2238 2239; mul 114 2240; add 2233 2241; mul 1033 2198; mul 885 2202; mul 919 2201; add 2244 2245; sub 2243
2246; mul 906 2208; sub 2247 2248; mul 41 2249; add 2242 2250; mul 878 2226; sub 2251 2252; mul 41 2253; add 2230
2254; mul 1047 2212; mul 1049 2214; sub 2256 2257; mul 1052 2198; mul 1049 2202; mul 912 2201; add 2260 2261; sub
2259 2262; mul 903 2208; sub 2263 2264; mul 114 2265; add 2258 2266; mul 906 2198; mul 1047 2202; mul 1052 2201; add
2269 2270; sub 2268 2271; mul 900 2208; sub 2272 2273; mul 41 2274; add 2267 2275; mul 20 2210; add 2276 2277; mul
876 2226; sub 2278 2279; mul 709 2280; add 2255 2281; mul 929 2207; mul 271 2283; mul 731 2282; mul 730 2285; add
2284 2286; mul 729 2287; sub 2282 2288; mul 744 2285; sub 2284 2290; mul 743 2291; add 2289 2292; mul 671 2293; mul
666 2294; mul 661 2295; sub 2197 2296; mul 758 1616; mul 761 2200; sub 2298 2299; mul 756 2207; sub 2300 2301; mul
871 2302; mul 809 2303; mul 865 2200; mul 763 2305; mul 1099 2306; mul 792 2200; mul 59 2308; mul 1099 2309; add
2307 2310; mul 1107 2200; mul 1099 2312; add 2311 2313; mul 777 2200; mul 763 2315; mul 763 2316; add 2314 2317; mul
1115 2200; mul 59 2319; mul 763 2320; add 2318 2321; mul 765 2200; mul 763 2323; add 2322 2324; sub 2304 2325; mul 4
2303; mul 1099 2327; add 2326 2328; mul 804 2302; mul 763 2330; mul 1099 2331; add 2329 2332; mul 865 2302; mul 59
2334; mul 1099 2335; add 2333 2336; mul 862 2302; mul 1099 2338; add 2337 2339; mul 859 2302; mul 763 2341; mul 763
2342; add 2340 2343; mul 856 2302; mul 59 2345; mul 763 2346; add 2344 2347; mul 853 2302; mul 763 2349; add 2348
2350; mul 769 2302; mul 59 2352; mul 59 2353; add 2351 2354; mul 765 2302; mul 59 2356; add 2355 2357; mul 755 2302;
add 2358 2359; mul 813 2207; mul 809 2361; sub 2360 2362; mul 4 2361; mul 1099 2364; sub 2363 2365; mul 808 2207;
mul 763 2367; mul 1099 2368; sub 2366 2369; mul 804 2207; mul 763 2371; mul 763 2372; sub 2370 2373; mul 800 2207;
mul 59 2375; mul 763 2376; sub 2374 2377; mul 796 2207; mul 763 2379; sub 2378 2380; mul 792 2207; mul 59 2382; mul
59 2383; sub 2381 2384; mul 788 2207; mul 59 2386; sub 2385 2387; mul 785 2207; sub 2388 2389; mul 809 2330; mul 809
2305; mul 797 2315; add 2392 2393; mul 4 2316; add 2394 2395; mul 4 2320; add 2396 2397; mul 4 2323; add 2398 2399;
mul 1198 2200; mul 774 2401; add 2400 2402; mul 763 2401; mul 1202 2404; add 2403 2405; mul 835 2200; mul 59 2407;
mul 1202 2408; add 2406 2409; mul 1210 2200; mul 1202 2411; add 2410 2412; mul 1214 2200; mul 59 2414; mul 59 2415;
add 2413 2416; mul 1219 2200; mul 59 2418; add 2417 2419; mul 818 2200; add 2420 2421; sub 2391 2422; mul 797 2341;
add 2423 2424; mul 4 2342; add 2425 2426; mul 4 2346; add 2427 2428; mul 4 2349; add 2429 2430; mul 844 2302; mul
774 2432; add 2431 2433; mul 763 2432; mul 1202 2435; add 2434 2436; mul 841 2302; mul 59 2438; mul 1202 2439; add
2437 2440; mul 838 2302; mul 1202 2442; add 2441 2443; mul 835 2302; mul 59 2445; mul 59 2446; add 2444 2447; mul
832 2302; mul 59 2449; add 2448 2450; mul 829 2302; add 2451 2452; mul 809 2367; sub 2453 2454; mul 797 2371; sub
2455 2456; mul 4 2372; sub 2457 2458; mul 4 2376; sub 2459 2460; mul 4 2379; sub 2461 2462; mul 781 2207; mul 774
2464; sub 2463 2465; mul 763 2464; mul 1202 2467; sub 2466 2468; mul 777 2207; mul 59 2470; mul 1202 2471; sub 2469
2472; mul 773 2207; mul 1202 2474; sub 2473 2475; mul 769 2207; mul 59 2477; mul 59 2478; sub 2476 2479; mul 765
2207; mul 59 2481; sub 2480 2482; mul 755 2207; sub 2483 2484; mul 756 2485; add 2390 2486; mul 661 2487; sub 2297
2488; mul 441 1312; mul 441 1294; add 1352 2491; mul 1308 2492; mul 267 2493; add 2490 2494; mul 1297 2492; mul 441
1330; add 2496 2497; mul 441 1296; mul 1322 2499; sub 2498 2500; mul 2 2501; add 2495 2502; mul 1292 2503; add 2489
2504; mul 194 249; mul 287 2506; mul 71 2507; mul 255 2506; mul 282 2509; add 2508 2510; mul 249 291; mul 193 2512;
mul 249 255; mul 258 2514; mul 193 2515; mul 261 2516; sub 2513 2517; mul 242 293; mul 246 2519; mul 205 2519; mul
244 2521; add 2520 2522; mul 248 293; mul 178 2524; mul 619 2525; mul 191 2525; mul 241 2527; add 2526 2528; mul 191
2527; mul 240 2530; add 2529 2531; mul 177 2512; mul 249 267; mul 184 2534; sub 2533 2535; mul 263 2515; add 2536
2537; mul 178 2538; mul 629 2539; mul 192 2540; add 2532 2541; mul 618 2542; sub 2523 2543; mul 178 2544; mul 579
2545; mul 577 2546; add 2518 2547; mul 155 2548; add 2511 2549; mul 102 2548; mul 103 2551; mul 131 2552; mul 102
2509; mul 281 2554; mul 41 2552; add 2555 2556; mul 142 2557; mul 267 2506; mul 274 2559; mul 20 2552; add 2560
2561; mul 123 2562; add 2558 2563; mul 114 2564; mul 102 2507; mul 70 2566; mul 114 2552; add 2567 2568; mul 48
2569; mul 139 2557; add 2570 2571; mul 119 2562; add 2572 2573; mul 41 2574; add 2565 2575; mul 41 2576; add 2553
2577; mul 23 2569; mul 133 2557; add 2579 2580; mul 104 2562; add 2581 2582; mul 21 2583; add 2578 2584; mul 43
2557; mul 116 2562; add 2586 2587; mul 114 2588; mul 43 2569; mul 119 2557; add 2590 2591; mul 106 2562; add 2592
2593; mul 41 2594; add 2589 2595; mul 20 2583; add 2596 2597; mul 709 2598; add 2585 2599; mul 731 2600; mul 730
2601; mul 131 2559; mul 271 2603; sub 2602 2604; mul 729 2605; sub 2600 2606; mul 744 2601; add 2604 2608; mul 743
2609; sub 2607 2610; mul 671 2611; mul 666 2612; mul 661 2613; sub 2550 2614; sub 2615 2548; mul 321 369; mul 287
2617; mul 71 2618; mul 291 369; mul 320 2620; mul 255 369; mul 258 2622; mul 320 2623; mul 377 2624; add 2621 2625;
mul 364 387; mul 366 2627; mul 328 2627; mul 244 2629; add 2628 2630; mul 368 387; mul 305 2632; mul 521 2633; mul
318 2633; mul 363 2635; add 2634 2636; mul 318 2635; mul 362 2638; add 2637 2639; mul 304 2620; mul 267 369; mul 311
2642; sub 2641 2643; mul 379 2623; add 2644 2645; mul 305 2646; mul 531 2647; mul 319 2648; add 2640 2649; mul 520
2650; sub 2631 2651; mul 305 2652; mul 481 2653; mul 479 2654; add 2626 2655; sub 2619 2656; mul 255 2617; mul 282
2658; add 2657 2659; mul 155 2656; add 2660 2661; mul 102 2656; mul 103 2663; mul 131 2664; mul 102 2658; mul 281
2666; mul 41 2664; add 2667 2668; mul 142 2669; mul 267 2617; mul 274 2671; mul 20 2664; add 2672 2673; mul 123
2674; add 2670 2675; mul 114 2676; mul 102 2618; mul 70 2678; mul 114 2664; add 2679 2680; mul 48 2681; mul 139
2669; add 2682 2683; mul 119 2674; add 2684 2685; mul 41 2686; add 2677 2687; mul 41 2688; add 2665 2689; mul 23
2681; mul 133 2669; add 2691 2692; mul 104 2674; add 2693 2694; mul 21 2695; add 2690 2696; mul 43 2669; mul 116
2674; add 2698 2699; mul 114 2700; mul 43 2681; mul 119 2669; add 2702 2703; mul 106 2674; add 2704 2705; mul 41
2706; add 2701 2707; mul 20 2695; add 2708 2709; mul 709 2710; add 2697 2711; mul 731 2712; mul 730 2713; mul 131
2671; mul 271 2715; sub 2714 2716; mul 729 2717; sub 2712 2718; mul 744 2713; add 2716 2720; mul 743 2721; sub 2719
2722; mul 671 2723; mul 666 2724; mul 661 2725; sub 2662 2726; mul 758 873; mul 21 1047; mul 46 1018; add 2729 2730;
mul 882 888; add 2731 2732; input p 131; mul 51 2734; add 2733 2735; input p 132; mul 889 2737; add 2736 2738; input
p 133; mul 893 2740; add 2739 2741; mul 896 2742; mul 22 977; mul 42 906; add 2744 2745; mul 115 1052; add 2746
2747; mul 47 1033; add 2748 2749; mul 122 1022; add 2750 2751; mul 913 922; add 2752 2753; input p 138; mul 52 2755;
add 2754 2756; input p 139; mul 129 2758; add 2757 2759; input p 140; mul 923 2761; add 2760 2762; input p 141; mul
896 2764; add 2763 2765; add 2743 2766; mul 281 2767; add 2728 2768; mul 443 2769; input p 144; mul 59 2771; input p
145; mul 822 2773; add 2772 2774; input p 146; mul 826 2776; add 2775 2777; mul 763 818; add 2778 2779; mul 766
1219; add 2780 2781; mul 770 1214; add 2782 2783; mul 774 1210; add 2784 2785; mul 778 835; add 2786 2787; mul 782
1198; add 2788 2789; mul 765 797; add 2790 2791; mul 801 1115; add 2792 2793; mul 777 805; add 2794 2795; mul 809
1107; add 2796 2797; mul 792 866; add 2798 2799; mul 810 865; add 2800 2801; mul 761 873; add 2802 2803; mul 21
1049; mul 46 888; add 2805 2806; mul 882 999; add 2807 2808; input p 155; mul 51 2810; add 2809 2811; input p 156;
mul 889 2813; add 2812 2814; input p 157; mul 893 2816; add 2815 2817; mul 896 2818; mul 22 988; mul 42 1052; add
2820 2821; mul 115 912; add 2822 2823; mul 47 919; add 2824 2825; mul 122 1025; add 2826 2827; mul 913 1005; add
2828 2829; input p 161; mul 52 2831; add 2830 2832; mul 129 2761; add 2833 2834; input p 162; mul 923 2836; add 2835
2837; input p 163; mul 896 2839; add 2838 2840; add 2819 2841; mul 22 981; mul 42 1047; add 2843 2844; mul 115 1049;
add 2845 2846; mul 47 885; add 2847 2848; mul 122 888; add 2849 2850; mul 892 913; add 2851 2852; input p 165; mul
52 2854; add 2853 2855; mul 129 2810; add 2856 2857; mul 923 2740; add 2858 2859; input p 166; mul 896 2861; add
2860 2862; mul 983 2863; add 2842 2864; mul 70 2865; add 2804 2866; mul 441 2867; sub 2770 2868; mul 931 962; sub
2869 2870; mul 1352 2867; mul 1343 2769; sub 2872 2873; mul 931 1601; add 2874 2875; mul 1352 2769; mul 1928 2867;
sub 2877 2878; mul 931 2183; sub 2879 2880; mul 949 964; constant 0.8; mul 287 441; mul 2883 2884; sub 2882 2885;
mul 944 962; sub 2886 2887; input p 213; input p 214; mul 1310 1315; le 1306 1307; le 1307 1306; add 2892 2893; div
17 2894; mul 2892 2895; mul 2891 2896; mul 2890 2897; mul 2889 2898; mul 238 2899; add 2888 2900; mul 287 1352; mul
2883 2902; mul 949 1603; add 2903 2904; mul 944 1601; add 2905 2906; mul 1310 1911; mul 2896 2908; mul 2890 2909;
mul 2889 2910; mul 238 2911; sub 2907 2912; mul 949 2185; mul 287 1928; mul 2883 2915; sub 2914 2916; mul 944 2183;
sub 2917 2918; mul 1310 2492; mul 2896 2920; mul 2890 2921; mul 2889 2922; mul 238 2923; add 2919 2924; constant
-2.57142857142857; mul 814 1096; mul 2926 2927; constant -0.8571428571428573; mul 810 984; mul 2929 2930; constant
0.9142857142857148; mul 866 984; mul 2932 2933; add 2931 2934; constant 0.05714285714285805; mul 805 984; mul 2936
2937; add 2935 2938; constant -0.1142857142857146; mul 801 984; mul 2940 2941; add 2939 2942; constant
0.2190476190476187; mul 782 984; mul 2944 2945; add 2943 2946; constant 0.11428571428571417; mul 778 984; mul 2948
2949; add 2947 2950; constant -0.05714285714285713; mul 770 984; mul 2952 2953; add 2951 2954; input p 215; constant
-0.03333333333333334; mul 763 984; mul 2957 2958; mul 2956 2959; add 2955 2960; constant 0.007256235827664402; mul
826 984; mul 2962 2963; add 2961 2964; constant 0.019047619047619053; mul 59 984; mul 2966 2967; mul 2956 2968; add
2965 2969; sub 2928 2970; constant 2.057142857142853; mul 810 1096; mul 2972 2973; add 2971 2974; mul 866 1096; mul
2929 2976; add 2975 2977; constant -3.428571428571426; mul 805 1096; mul 2979 2980; add 2978 2981; constant
0.1142857142857161; mul 801 1096; mul 2983 2984; add 2982 2985; constant -0.0571428571428573; mul 793 1096; mul 2987
2988; add 2986 2989; constant -0.09999999999999992; mul 4 1096; mul 2991 2992; mul 2956 2993; add 2990 2994;
constant 2.438095238095238; mul 782 1096; mul 2996 2997; add 2995 2998; constant 0.6571428571428561; mul 778 1096;
mul 3000 3001; add 2999 3002; input p 216; mul 774 1096; mul 3004 3005; sub 3003 3006; mul 770 1096; mul 2948 3008;
add 3007 3009; constant 0.13333333333333333; mul 763 1096; mul 3011 3012; mul 2956 3013; add 3010 3014; constant
-0.019047619047619042; mul 826 1096; mul 3016 3017; add 3015 3018; mul 59 1096; mul 2957 3020; mul 2956 3021; add
3019 3022; constant 12.342857142857142; mul 814 992; mul 3024 3025; sub 3023 3026; constant -7.71428571428571; mul
810 992; mul 3028 3029; sub 3027 3030; mul 805 992; mul 2972 3032; sub 3031 3033; constant -1.7142857142857146; mul
801 992; mul 3035 3036; sub 3034 3037; mul 793 992; mul 2932 3039; sub 3038 3040; constant 1.1999999999999995; mul 4
992; mul 3042 3043; mul 2956 3044; sub 3041 3045; constant -1.1428571428571421; mul 782 992; mul 3047 3048; sub 3046
3049; mul 778 992; mul 2936 3051; sub 3050 3052; mul 770 992; mul 2987 3054; sub 3053 3055; mul 763 992; mul 2991
3057; mul 2956 3058; sub 3056 3059; mul 810 1616; mul 2929 3061; mul 866 1616; mul 2932 3063; add 3062 3064; mul 805
1616; mul 2936 3066; add 3065 3067; mul 801 1616; mul 2940 3069; add 3068 3070; mul 782 1616; mul 2944 3072; add
3071 3073; mul 778 1616; mul 2948 3075; add 3074 3076; mul 770 1616; mul 2952 3078; add 3077 3079; mul 763 1616; mul
2957 3081; mul 2956 3082; add 3080 3083; mul 826 1616; mul 2962 3085; add 3084 3086; mul 59 1616; mul 2966 3088; mul
2956 3089; add 3087 3090; mul 814 1742; mul 2926 3092; add 3091 3093; mul 810 1742; mul 2972 3095; add 3094 3096;
mul 866 1742; mul 2929 3098; add 3097 3099; mul 805 1742; mul 2979 3101; add 3100 3102; mul 801 1742; mul 2983 3104;
add 3103 3105; mul 793 1742; mul 2987 3107; add 3106 3108; mul 4 1742; mul 2991 3110; mul 2956 3111; add 3109 3112;
mul 782 1742; mul 2996 3114; add 3113 3115; mul 778 1742; mul 3000 3117; add 3116 3118; mul 774 1742; mul 3004 3120;
sub 3119 3121; mul 770 1742; mul 2948 3123; add 3122 3124; mul 763 1742; mul 3011 3126; mul 2956 3127; add 3125
3128; mul 826 1742; mul 3016 3130; add 3129 3131; mul 59 1742; mul 2957 3133; mul 2956 3134; add 3132 3135; mul 814
1626; mul 3024 3137; add 3136 3138; mul 810 1626; mul 3028 3140; add 3139 3141; mul 805 1626; mul 2972 3143; add
3142 3144; mul 801 1626; mul 3035 3146; add 3145 3147; mul 793 1626; mul 2932 3149; add 3148 3150; mul 4 1626; mul
3042 3152; mul 2956 3153; add 3151 3154; mul 782 1626; mul 3047 3156; add 3155 3157; mul 778 1626; mul 2936 3159;
add 3158 3160; mul 770 1626; mul 2987 3162; add 3161 3163; mul 763 1626; mul 2991 3165; mul 2956 3166; add 3164
3167; mul 814 2302; mul 2926 3169; mul 810 2200; mul 2929 3171; mul 866 2200; mul 2932 3173; add 3172 3174; mul 805
2200; mul 2936 3176; add 3175 3177; mul 801 2200; mul 2940 3179; add 3178 3180; mul 782 2200; mul 2944 3182; add
3181 3183; mul 778 2200; mul 2948 3185; add 3184 3186; mul 770 2200; mul 2952 3188; add 3187 3189; mul 763 2200; mul
2957 3191; mul 2956 3192; add 3190 3193; mul 826 2200; mul 2962 3195; add 3194 3196; mul 59 2200; mul 2966 3198; mul
2956 3199; add 3197 3200; sub 3170 3201; mul 810 2302; mul 2972 3203; add 3202 3204; mul 866 2302; mul 2929 3206;
add 3205 3207; mul 805 2302; mul 2979 3209; add 3208 3210; mul 801 2302; mul 2983 3212; add 3211 3213; mul 793 2302;
mul 2987 3215; add 3214 3216; mul 4 2302; mul 2991 3218; mul 2956 3219; add 3217 3220; mul 782 2302; mul 2996 3222;
add 3221 3223; mul 778 2302; mul 3000 3225; add 3224 3226; mul 774 2302; mul 3004 3228; sub 3227 3229; mul 770 2302;
mul 2948 3231; add 3230 3232; mul 763 2302; mul 3011 3234; mul 2956 3235; add 3233 3236; mul 826 2302; mul 3016
3238; add 3237 3239; mul 59 2302; mul 2957 3241; mul 2956 3242; add 3240 3243; mul 814 2207; mul 3024 3245; sub 3244
3246; mul 810 2207; mul 3028 3248; sub 3247 3249; mul 805 2207; mul 2972 3251; sub 3250 3252; mul 801 2207; mul 3035
3254; sub 3253 3255; mul 793 2207; mul 2932 3257; sub 3256 3258; mul 4 2207; mul 3042 3260; mul 2956 3261; sub 3259
3262; mul 782 2207; mul 3047 3264; sub 3263 3265; mul 778 2207; mul 2936 3267; sub 3266 3268; mul 770 2207; mul 2987
3270; sub 3269 3271; mul 763 2207; mul 2991 3273; mul 2956 3274; sub 3272 3275; constant -129.60000000000008; mul
2927 3277; constant 28.79999999999998; mul 2930 3279; constant 45.25714285714285; mul 2933 3281; add 3280 3282;
constant -28.80000000000001; mul 809 984; mul 3284 3285; mul 3004 3286; add 3283 3287; constant -28.799999999999997;
mul 2937 3289; add 3288 3290; constant -45.25714285714285; mul 2941 3292; add 3291 3293; constant 28.80000000000001;
mul 797 984; mul 3295 3296; mul 3004 3297; add 3294 3298; constant 7.199999999999999; mul 2945 3300; add 3299 3301;
constant 13.714285714285712; mul 2949 3303; add 3302 3304; constant -7.200000000000003; mul 774 984; mul 3306 3307;
mul 3004 3308; add 3305 3309; constant 1.3714285714285672; mul 2953 3311; add 3310 3312; constant
-4.799999999999996; mul 766 984; mul 3314 3315; mul 3004 3316; add 3313 3317; constant 1.371428571428571; mul 2963
3319; add 3318 3320; constant -1.3714285714285719; mul 822 984; mul 3322 3323; mul 3004 3324; add 3321 3325;
constant 2.4; mul 2967 3327; mul 2956 3328; add 3326 3329; sub 3278 3330; constant 230.40000000000006; mul 2973
3332; add 3331 3333; mul 2976 3279; add 3334 3335; constant -36.00000000000001; mul 809 1096; mul 3337 3338; mul
3004 3339; add 3336 3340; constant -151.20000000000002; mul 2980 3342; add 3341 3343; constant -57.599999999999994;
mul 2984 3345; add 3344 3346; constant 72.0; mul 797 1096; mul 3348 3349; mul 3004 3350; add 3347 3351; constant
-22.628571428571426; mul 2988 3353; add 3352 3354; mul 789 1096; mul 3295 3356; mul 3004 3357; add 3355 3358;
constant -18.000000000000004; mul 2992 3360; mul 2956 3361; add 3359 3362; constant 35.20000000000001; mul 2997
3364; add 3363 3365; constant 21.599999999999998; mul 3001 3367; add 3366 3368; constant -30.000000000000007; mul
3005 3370; mul 3004 3371; add 3369 3372; mul 3008 3303; add 3373 3374; constant -14.400000000000006; mul 766 1096;
mul 3376 3377; mul 3004 3378; add 3375 3379; mul 934 3012; mul 2956 3381; add 3380 3382; constant
0.45714285714285574; mul 3017 3384; add 3383 3385; constant -2.399999999999998; mul 822 1096; mul 3387 3388; mul
3004 3389; add 3386 3390; input p 217; constant -0.9999999999999998; mul 1096 3393; mul 3392 3394; add 3391 3395;
constant 259.2000000000001; mul 3025 3397; sub 3396 3398; constant -388.80000000000024; mul 3029 3400; sub 3399
3401; mul 3032 3332; sub 3402 3403; constant 57.59999999999996; mul 3036 3405; sub 3404 3406; constant
-72.00000000000001; mul 797 992; mul 3408 3409; mul 3004 3410; sub 3407 3411; mul 3039 3281; sub 3412 3413; constant
-57.60000000000002; mul 789 992; mul 3415 3416; mul 3004 3417; sub 3414 3418; constant 36.000000000000014; mul 3043
3420; mul 2956 3421; sub 3419 3422; constant -50.400000000000006; mul 3048 3424; sub 3423 3425; mul 3051 3289; sub
3426 3427; constant 36.0; mul 774 992; mul 3429 3430; mul 3004 3431; sub 3428 3432; mul 3054 3353; sub 3433 3434;
mul 766 992; mul 3295 3436; mul 3004 3437; sub 3435 3438; mul 3057 3360; mul 2956 3440; sub 3439 3441; mul 3061
3279; mul 3063 3281; add 3443 3444; mul 809 1616; mul 3284 3446; mul 3004 3447; add 3445 3448; mul 3066 3289; add
3449 3450; mul 3069 3292; add 3451 3452; mul 797 1616; mul 3295 3454; mul 3004 3455; add 3453 3456; mul 3072 3300;
add 3457 3458; mul 3075 3303; add 3459 3460; mul 774 1616; mul 3306 3462; mul 3004 3463; add 3461 3464; mul 3078
3311; add 3465 3466; mul 766 1616; mul 3314 3468; mul 3004 3469; add 3467 3470; mul 3085 3319; add 3471 3472; mul
822 1616; mul 3322 3474; mul 3004 3475; add 3473 3476; mul 3088 3327; mul 2956 3478; add 3477 3479; mul 3092 3277;
add 3480 3481; mul 3095 3332; add 3482 3483; mul 3098 3279; add 3484 3485; mul 809 1742; mul 3337 3487; mul 3004
3488; add 3486 3489; mul 3101 3342; add 3490 3491; mul 3104 3345; add 3492 3493; mul 797 1742; mul 3348 3495; mul
3004 3496; add 3494 3497; mul 3107 3353; add 3498 3499; mul 789 1742; mul 3295 3501; mul 3004 3502; add 3500 3503;
mul 3110 3360; mul 2956 3505; add 3504 3506; mul 3114 3364; add 3507 3508; mul 3117 3367; add 3509 3510; mul 3120
3370; mul 3004 3512; add 3511 3513; mul 3123 3303; add 3514 3515; mul 766 1742; mul 3376 3517; mul 3004 3518; add
3516 3519; mul 934 3126; mul 2956 3521; add 3520 3522; mul 3130 3384; add 3523 3524; mul 822 1742; mul 3387 3526;
mul 3004 3527; add 3525 3528; mul 1742 3393; mul 3392 3530; add 3529 3531; mul 3137 3397; add 3532 3533; mul 3140
3400; add 3534 3535; mul 3143 3332; add 3536 3537; mul 3146 3405; add 3538 3539; mul 797 1626; mul 3408 3541; mul
3004 3542; add 3540 3543; mul 3149 3281; add 3544 3545; mul 789 1626; mul 3415 3547; mul 3004 3548; add 3546 3549;
mul 3152 3420; mul 2956 3551; add 3550 3552; mul 3156 3424; add 3553 3554; mul 3159 3289; add 3555 3556; mul 774
1626; mul 3429 3558; mul 3004 3559; add 3557 3560; mul 3162 3353; add 3561 3562; mul 766 1626; mul 3295 3564; mul
3004 3565; add 3563 3566; mul 3165 3360; mul 2956 3568; add 3567 3569; mul 3169 3277; mul 3171 3279; mul 3173 3281;
add 3572 3573; mul 809 2200; mul 3284 3575; mul 3004 3576; add 3574 3577; mul 3176 3289; add 3578 3579; mul 3179
3292; add 3580 3581; mul 797 2200; mul 3295 3583; mul 3004 3584; add 3582 3585; mul 3182 3300; add 3586 3587; mul
3185 3303; add 3588 3589; mul 774 2200; mul 3306 3591; mul 3004 3592; add 3590 3593; mul 3188 3311; add 3594 3595;
mul 766 2200; mul 3314 3597; mul 3004 3598; add 3596 3599; mul 3195 3319; add 3600 3601; mul 822 2200; mul 3322
3603; mul 3004 3604; add 3602 3605; mul 3198 3327; mul 2956 3607; add 3606 3608; sub 3571 3609; mul 3203 3332; add
3610 3611; mul 3206 3279; add 3612 3613; mul 809 2302; mul 3337 3615; mul 3004 3616; add 3614 3617; mul 3209 3342;
add 3618 3619; mul 3212 3345; add 3620 3621; mul 797 2302; mul 3348 3623; mul 3004 3624; add 3622 3625; mul 3215
3353; add 3626 3627; mul 789 2302; mul 3295 3629; mul 3004 3630; add 3628 3631; mul 3218 3360; mul 2956 3633; add
3632 3634; mul 3222 3364; add 3635 3636; mul 3225 3367; add 3637 3638; mul 3228 3370; mul 3004 3640; add 3639 3641;
mul 3231 3303; add 3642 3643; mul 766 2302; mul 3376 3645; mul 3004 3646; add 3644 3647; mul 934 3234; mul 2956
3649; add 3648 3650; mul 3238 3384; add 3651 3652; mul 822 2302; mul 3387 3654; mul 3004 3655; add 3653 3656; mul
2302 3393; mul 3392 3658; add 3657 3659; mul 3245 3397; sub 3660 3661; mul 3248 3400; sub 3662 3663; mul 3251 3332;
sub 3664 3665; mul 3254 3405; sub 3666 3667; mul 797 2207; mul 3408 3669; mul 3004 3670; sub 3668 3671; mul 3257
3281; sub 3672 3673; mul 789 2207; mul 3415 3675; mul 3004 3676; sub 3674 3677; mul 3260 3420; mul 2956 3679; sub
3678 3680; mul 3264 3424; sub 3681 3682; mul 3267 3289; sub 3683 3684; mul 774 2207; mul 3429 3686; mul 3004 3687;
sub 3685 3688; mul 3270 3353; sub 3689 3690; mul 766 2207; mul 3295 3692; mul 3004 3693; sub 3691 3694; mul 3273
3360; mul 2956 3696; sub 3695 3697; input p 218; mul 3339 3699; mul 3286 3699; mul 3297 3699; add 3701 3702; mul
3308 3699; add 3703 3704; mul 3316 3699; add 3705 3706; input p 219; input p 220; mul 2959 3709; mul 3708 3710; add
3707 3711; mul 3324 3699; add 3712 3713; mul 2968 3709; mul 3708 3715; add 3714 3716; mul 3328 3699; mul 3708 3718;
add 3717 3719; sub 3700 3720; mul 3350 3699; add 3721 3722; mul 3357 3699; add 3723 3724; mul 2993 3709; mul 3708
3726; add 3725 3727; mul 3361 3699; mul 3708 3729; add 3728 3730; mul 3005 3709; sub 3731 3732; mul 3371 3699; add
3733 3734; mul 3378 3699; add 3735 3736; mul 3013 3709; mul 3708 3738; add 3737 3739; mul 3381 3699; mul 3708 3741;
add 3740 3742; mul 3389 3699; add 3743 3744; mul 3021 3709; mul 3708 3746; add 3745 3747; mul 3394 3699; mul 2956
3749; add 3748 3750; mul 3004 3749; mul 3708 3752; add 3751 3753; add 3394 3754; mul 3410 3699; sub 3755 3756; mul
3417 3699; sub 3757 3758; mul 3044 3709; mul 3708 3760; sub 3759 3761; mul 3421 3699; mul 3708 3763; sub 3762 3764;
mul 3431 3699; sub 3765 3766; mul 3437 3699; sub 3767 3768; mul 3058 3709; mul 3708 3770; sub 3769 3771; mul 3440
3699; mul 3708 3773; sub 3772 3774; mul 3447 3699; mul 3455 3699; add 3776 3777; mul 3463 3699; add 3778 3779; mul
3469 3699; add 3780 3781; mul 3082 3709; mul 3708 3783; add 3782 3784; mul 3475 3699; add 3785 3786; mul 3089 3709;
mul 3708 3788; add 3787 3789; mul 3478 3699; mul 3708 3791; add 3790 3792; mul 3488 3699; add 3793 3794; mul 3496
3699; add 3795 3796; mul 3502 3699; add 3797 3798; mul 3111 3709; mul 3708 3800; add 3799 3801; mul 3505 3699; mul
3708 3803; add 3802 3804; mul 3120 3709; sub 3805 3806; mul 3512 3699; add 3807 3808; mul 3518 3699; add 3809 3810;
mul 3127 3709; mul 3708 3812; add 3811 3813; mul 3521 3699; mul 3708 3815; add 3814 3816; mul 3527 3699; add 3817
3818; mul 3134 3709; mul 3708 3820; add 3819 3821; mul 3530 3699; mul 2956 3823; add 3822 3824; mul 3004 3823; mul
3708 3826; add 3825 3827; add 3530 3828; mul 3542 3699; add 3829 3830; mul 3548 3699; add 3831 3832; mul 3153 3709;
mul 3708 3834; add 3833 3835; mul 3551 3699; mul 3708 3837; add 3836 3838; mul 3559 3699; add 3839 3840; mul 3565
3699; add 3841 3842; mul 3166 3709; mul 3708 3844; add 3843 3845; mul 3568 3699; mul 3708 3847; add 3846 3848; mul
3616 3699; mul 3576 3699; mul 3584 3699; add 3851 3852; mul 3592 3699; add 3853 3854; mul 3598 3699; add 3855 3856;
mul 3192 3709; mul 3708 3858; add 3857 3859; mul 3604 3699; add 3860 3861; mul 3199 3709; mul 3708 3863; add 3862
3864; mul 3607 3699; mul 3708 3866; add 3865 3867; sub 3850 3868; mul 3624 3699; add 3869 3870; mul 3630 3699; add
3871 3872; mul 3219 3709; mul 3708 3874; add 3873 3875; mul 3633 3699; mul 3708 3877; add 3876 3878; mul 3228 3709;
sub 3879 3880; mul 3640 3699; add 3881 3882; mul 3646 3699; add 3883 3884; mul 3235 3709; mul 3708 3886; add 3885
3887; mul 3649 3699; mul 3708 3889; add 3888 3890; mul 3655 3699; add 3891 3892; mul 3242 3709; mul 3708 3894; add
3893 3895; mul 3658 3699; mul 2956 3897; add 3896 3898; mul 3004 3897; mul 3708 3900; add 3899 3901; add 3658 3902;
mul 3670 3699; sub 3903 3904; mul 3676 3699; sub 3905 3906; mul 3261 3709; mul 3708 3908; sub 3907 3909; mul 3679
3699; mul 3708 3911; sub 3910 3912; mul 3687 3699; sub 3913 3914; mul 3693 3699; sub 3915 3916; mul 3274 3709; mul
3708 3918; sub 3917 3919; mul 3696 3699; mul 3708 3921; sub 3920 3922; mul 935 970; mul 950 962; sub 3924 3925; mul
873 992; sub 3926 3927; mul 4 1287; add 3928 3929; input p 221; mul 2897 3931; input p 222; constant
0.3333333333333333; mul 3932 3934; mul 3933 3935; sub 3932 3936; add 3930 3937; mul 950 1601; mul 935 1609; add 3939
3940; mul 873 1626; add 3941 3942; mul 4 1904; add 3943 3944; mul 2909 3931; mul 3934 3946; mul 3933 3947; sub 3948
3946; add 3945 3949; mul 935 2191; mul 950 2183; sub 3951 3952; mul 873 2207; sub 3953 3954; mul 4 2485; add 3955
3956; mul 2921 3931; mul 3934 3958; mul 3933 3959; sub 3958 3960; add 3957 3961; mul 443 950; mul 873 978; add 3963
3964; mul 255 970; add 3965 3966; mul 27 1287; add 3967 3968; input p 223; mul 3937 3970; add 3969 3971; input p
224; input p 225; mul 2898 3974; mul 3973 3975; add 3972 3976; mul 255 1609; mul 950 1343; mul 873 1622; add 3979
3980; sub 3978 3981; mul 27 1904; add 3982 3983; mul 3949 3970; add 3984 3985; mul 2910 3974; mul 3973 3987; sub
3986 3988; mul 950 1352; mul 873 1616; add 3990 3991; mul 255 2191; add 3992 3993; mul 27 2485; add 3994 3995; mul
3961 3970; add 3996 3997; mul 2922 3974; mul 3973 3999; add 3998 4000; mul 287 970; mul 441 950; mul 873 984; add
4003 4004; sub 4002 4005; mul 59 1287; add 4006 4007; input p 226; mul 56 3932; mul 4009 4010; sub 4008 4011; mul
287 1609; add 3992 4013; mul 59 1904; add 4014 4015; mul 56 3946; mul 4009 4017; add 4016 4018; mul 287 2191; mul
950 1928; mul 873 2200; add 4021 4022; sub 4020 4023; mul 59 2485; add 4024 4025; mul 56 3958; mul 4009 4027; sub
4026 4028; mul 163 257; mul 255 258; mul 255 4031; mul 394 4032; mul 393 445; mul 393 443; mul 402 4035; sub 4034
4036; mul 4033 4037; mul 170 4038; mul 443 4032; mul 410 4040; sub 4039 4041; mul 397 4035; mul 393 441; mul 98
4044; sub 4043 4045; mul 82 4034; sub 4046 4047; mul 4033 4048; mul 174 4049; sub 4042 4050; mul 27 4051; mul 4030
4052; mul 4030 4053; mul 164 4052; mul 164 4055; mul 196 4056; add 4054 4057; mul 257 258; mul 380 474; input p 142;
mul 174 4061; mul 443 4062; sub 4060 4063; mul 264 572; add 4064 4065; mul 4059 4066; mul 169 4067; mul 164 164; mul
257 4066; mul 4069 4070; add 4068 4071; mul 164 174; mul 311 476; mul 302 4074; mul 258 443; mul 4061 4076; mul 304
476; mul 299 4078; add 4077 4079; sub 4075 4080; mul 302 559; add 4081 4082; mul 320 535; mul 375 476; add 4084
4085; mul 196 311; mul 557 4087; add 4086 4088; mul 299 4089; add 4083 4090; mul 177 574; mul 171 4092; sub 4091
4093; mul 184 574; mul 175 4095; sub 4094 4096; mul 175 657; sub 4097 4098; mul 193 633; mul 259 574; add 4100 4101;
mul 184 196; mul 655 4103; add 4102 4104; mul 171 4105; add 4099 4106; mul 4073 4107; add 4072 4108; mul 164 170;
mul 302 4078; mul 299 4074; add 4111 4112; mul 299 559; add 4113 4114; mul 302 4089; sub 4115 4116; mul 175 4092;
sub 4117 4118; mul 171 4095; add 4119 4120; mul 171 657; add 4121 4122; mul 175 4105; add 4123 4124; mul 4110 4125;
add 4109 4126; mul 163 196; div 17 4128; mul 4127 4129; mul 27 4130; mul 27 4131; sub 4058 4132; mul 164 4125; mul
163 4067; sub 4134 4135; mul 169 196; div 17 4137; mul 4136 4138; mul 27 4139; mul 27 4140; add 4133 4141; input p
128; mul 164 4143; mul 164 4144; mul 165 4030; mul 4030 4146; add 4145 4147; mul 27 4148; mul 4038 4149; mul 754
2867; mul 289 392; sub 4151 4152; input p 167; mul 287 4154; mul 761 950; add 4155 4156; add 4153 4157; mul 75 267;
mul 77 255; add 4159 4160; mul 80 287; add 4161 4162; mul 267 4163; mul 77 267; mul 85 255; add 4165 4166; mul 88
287; add 4167 4168; mul 255 4169; add 4164 4170; mul 80 267; mul 88 255; add 4172 4173; mul 96 287; add 4174 4175;
mul 287 4176; add 4171 4177; mul 174 4149; sub 401 4179; mul 4033 4180; add 4178 4181; mul 98 4182; mul 393 4183;
add 4158 4184; mul 440 441; mul 4185 4186; mul 754 2769; mul 284 392; sub 4188 4189; mul 758 950; add 4190 4191; mul
265 295; mul 381 389; add 4193 4194; add 4192 4195; sub 1312 4196; mul 258 4062; add 4197 4198; input p 119; input z
0; mul 4200 4201; input p 120; input z 1; mul 4203 4204; add 4202 4205; input p 121; input z 2; mul 4207 4208; add
4206 4209; input p 122; input z 3; mul 4211 4212; add 4210 4213; input p 143; mul 4214 4215; sub 4199 4216; mul 397
4182; mul 170 4149; add 395 4219; mul 4033 4220; mul 402 4221; sub 4218 4222; mul 393 4223; mul 410 4149; mul 4032
4225; sub 4224 4226; sub 4217 4227; mul 440 443; mul 4228 4229; add 4187 4230; input c 0; input c 2; mul 215 4233;
add 4232 4234; input c 3; mul 338 4236; add 4235 4237; mul 1296 1330; add 4238 4239; mul 1294 1312; sub 4240 4241;
input p 16; input c 1; add 4243 4244; max 4245 7; mul 267 4246; sub 4242 4247; mul 276 392; sub 954 4249; mul 268
295; mul 383 389; add 4251 4252; sub 4250 4253; sub 4248 4254; input p 118; sub 4256 4214; input p 123; abs 267; mul
4258 4259; mul 267 4260; input p 124; mul 267 4262; mul 267 267; input p 125; add 4264 4265; sqrt 4266; div 17 4267;
mul 4263 4268; add 4261 4269; sub 4257 4270; add 4255 4271; input p 126; input x 12; sub 2 4274; mul 4273 4275;
input p 127; input x 13; sub 2 4278; mul 4277 4279; add 4276 4280; sub 4272 4281; mul 82 4182; sub 4283 4221; mul
393 4284; sub 4282 4285; mul 440 445; mul 4286 4287; sub 4231 4288; mul 419 4289; mul 399 4290; mul 406 4289; mul
425 4292; sub 4291 4293; mul 393 4294; mul 4035 4221; sub 4295 4296; mul 440 4185; mul 399 4298; mul 440 4228; mul
425 4300; add 4299 4301; mul 435 4289; add 4302 4303; mul 393 4304; sub 4297 4305; mul 196 402; mul 419 4298; mul
419 4290; sub 4308 4309; mul 431 4289; mul 425 4311; add 4310 4312; mul 440 4286; mul 425 4314; add 4313 4315; mul
393 4316; mul 4307 4317; add 4306 4318; mul 394 4319; add 4049 4320; mul 258 4321; add 4150 4322; mul 164 4323; mul
257 4030; mul 4052 4146; mul 165 4053; add 4326 4327; mul 4325 4328; mul 4037 4220; mul 394 4330; mul 443 4225; sub
4331 4332; mul 4048 4180; mul 394 4334; add 4333 4335; mul 255 4336; mul 255 4337; mul 4035 4182; mul 82 4295; add
4339 4340; mul 82 4305; sub 4341 4342; mul 419 4300; mul 406 4290; add 4344 4345; mul 399 4311; sub 4346 4347; mul
399 4314; sub 4348 4349; mul 393 4350; mul 98 4351; add 4343 4352; mul 419 4292; mul 406 4298; sub 4354 4355; sub
4356 4347; sub 4357 4349; mul 393 4358; mul 98 4359; add 4353 4360; mul 196 397; mul 4317 4362; add 4361 4363; mul
394 4364; add 4038 4365; mul 174 4366; add 4338 4367; mul 170 4321; add 4368 4369; mul 410 4316; add 4370 4371; mul
258 4316; mul 4040 4149; sub 4373 4374; mul 409 4375; add 4372 4376; mul 4059 4377; add 4329 4378; mul 163 4379; sub
4324 4380; mul 4138 4381; mul 27 4382; mul 27 4383; add 4142 4384; mul 257 4328; mul 164 4145; mul 4052 4387; sub
4386 4388; mul 4055 4145; sub 4389 4390; mul 258 4366; mul 4049 4149; sub 4392 4393; mul 4073 4394; sub 4391 4395;
mul 4110 4323; sub 4396 4397; mul 169 4379; sub 4398 4399; mul 257 4377; mul 4069 4401; sub 4400 4402; mul 4129
4403; mul 27 4404; mul 27 4405; add 4385 4406; mul 1343 4032; mul 410 4408; mul 393 1343; mul 402 4410; sub 4411
4035; mul 4033 4412; mul 170 4413; add 4409 4414; mul 393 1352; mul 98 4416; mul 397 4410; sub 4417 4418; mul 82
4035; add 4419 4420; mul 4033 4421; mul 174 4422; sub 4415 4423; mul 27 4424; mul 4030 4425; mul 4030 4426; mul 164
4425; mul 164 4428; mul 196 4429; add 4427 4430; mul 1343 4062; mul 380 1418; sub 4432 4433; mul 264 1454; sub 4434
4435; mul 4059 4436; mul 169 4437; mul 257 4436; mul 4069 4439; add 4438 4440; mul 258 1343; mul 4061 4442; mul 304
1442; mul 299 4444; add 4443 4445; mul 311 1442; mul 302 4447; sub 4446 4448; mul 302 1445; add 4449 4450; mul 320
1409; mul 375 1442; sub 4452 4453; mul 1439 4087; add 4454 4455; mul 299 4456; add 4451 4457; mul 177 1456; mul 171
4459; add 4458 4460; mul 184 1456; mul 175 4462; add 4461 4463; mul 175 1525; sub 4464 4465; mul 193 1500; mul 259
1456; sub 4467 4468; mul 1523 4103; add 4469 4470; mul 171 4471; add 4466 4472; mul 4073 4473; add 4441 4474; mul
299 1445; mul 302 4444; mul 299 4447; add 4477 4478; sub 4476 4479; mul 302 4456; sub 4480 4481; mul 175 4459; add
4482 4483; mul 171 4462; sub 4484 4485; mul 171 1525; add 4486 4487; mul 175 4471; add 4488 4489; mul 4110 4490; add
4475 4491; mul 4129 4492; mul 27 4493; mul 27 4494; sub 4431 4495; mul 164 4490; mul 163 4437; sub 4497 4498; mul
4138 4499; mul 27 4500; mul 27 4501; add 4496 4502; mul 4149 4413; mul 4221 4410; mul 4229 4286; mul 440 1352; mul
4185 4507; sub 4506 4508; mul 440 1343; mul 4228 4510; sub 4509 4511; mul 419 4512; mul 399 4513; add 4308 4315; sub
4514 4515; mul 406 4512; mul 425 4517; sub 4516 4518; mul 393 4519; add 4505 4520; mul 435 4512; mul 393 4522; sub
4521 4523; mul 431 4512; mul 425 4525; mul 419 4513; sub 4526 4527; mul 393 4528; mul 4307 4529; add 4524 4530; mul
394 4531; add 4422 4532; mul 258 4533; add 4504 4534; mul 164 4535; mul 4146 4425; mul 165 4426; add 4537 4538; mul
4325 4539; mul 1343 4225; mul 4220 4412; mul 394 4542; add 4541 4543; mul 4180 4421; mul 394 4545; add 4544 4546;
mul 255 4547; mul 255 4548; mul 82 4520; mul 4182 4410; sub 4550 4551; mul 82 4523; sub 4552 4553; mul 406 4513; mul
399 4525; sub 4555 4556; mul 393 4557; mul 98 4558; add 4554 4559; mul 431 4298; mul 419 4314; add 4561 4562; mul
419 4517; add 4563 4564; sub 4565 4556; mul 393 4566; mul 98 4567; add 4560 4568; mul 4362 4529; add 4569 4570; mul
394 4571; add 4413 4572; mul 174 4573; add 4549 4574; mul 170 4533; add 4575 4576; mul 410 4528; add 4577 4578; mul
4149 4408; mul 258 4528; add 4580 4581; mul 409 4582; add 4579 4583; mul 4059 4584; add 4540 4585; mul 163 4586; sub
4536 4587; mul 4138 4588; mul 27 4589; mul 27 4590; add 4503 4591; mul 257 4539; mul 4387 4425; sub 4593 4594; mul
4145 4428; sub 4595 4596; mul 258 4573; mul 4149 4422; sub 4598 4599; mul 4073 4600; sub 4597 4601; mul 4110 4535;
sub 4602 4603; mul 169 4586; sub 4604 4605; mul 257 4584; mul 4069 4607; sub 4606 4608; mul 4129 4609; mul 27 4610;
mul 27 4611; add 4592 4612; mul 402 4416; sub 4044 4614; mul 4033 4615; mul 170 4616; mul 1352 4032; mul 410 4618;
sub 4617 4619; mul 397 4416; mul 393 1928; mul 98 4622; sub 4621 4623; mul 82 4044; sub 4624 4625; mul 4033 4626;
mul 174 4627; sub 4620 4628; mul 27 4629; mul 4030 4630; mul 4030 4631; mul 164 4630; mul 164 4633; mul 196 4634;
add 4632 4635; mul 380 1959; mul 1352 4062; sub 4637 4638; mul 264 2039; add 4639 4640; mul 4059 4641; mul 169 4642;
mul 257 4641; mul 4069 4644; add 4643 4645; mul 311 1961; mul 302 4647; mul 258 1352; mul 4061 4649; mul 304 1961;
mul 299 4651; add 4650 4652; sub 4648 4653; mul 302 2027; add 4654 4655; mul 320 2003; mul 375 1961; add 4657 4658;
mul 2025 4087; add 4659 4660; mul 299 4661; add 4656 4662; mul 177 2041; mul 171 4664; sub 4663 4665; mul 184 2041;
mul 175 4667; sub 4666 4668; mul 175 2107; sub 4669 4670; mul 193 2083; mul 259 2041; add 4672 4673; mul 2105 4103;
add 4674 4675; mul 171 4676; add 4671 4677; mul 4073 4678; add 4646 4679; mul 302 4651; mul 299 4647; add 4681 4682;
mul 299 2027; add 4683 4684; mul 302 4661; sub 4685 4686; mul 175 4664; sub 4687 4688; mul 171 4667; add 4689 4690;
mul 171 2107; add 4691 4692; mul 175 4676; add 4693 4694; mul 4110 4695; add 4680 4696; mul 4129 4697; mul 27 4698;
mul 27 4699; sub 4636 4700; mul 164 4695; mul 163 4642; sub 4702 4703; mul 4138 4704; mul 27 4705; mul 27 4706; add
4701 4707; mul 4149 4616; add 4349 4355; mul 440 1928; mul 4185 4711; mul 4228 4507; add 4712 4713; mul 4186 4286;
sub 4714 4715; mul 419 4716; mul 399 4717; add 4710 4718; mul 406 4716; mul 425 4720; sub 4719 4721; mul 393 4722;
mul 4221 4416; sub 4723 4724; add 4344 4355; mul 435 4716; sub 4726 4727; mul 393 4728; add 4725 4729; mul 431 4716;
mul 425 4731; mul 419 4717; add 4563 4733; sub 4732 4734; mul 393 4735; mul 4307 4736; add 4730 4737; mul 394 4738;
add 4627 4739; mul 258 4740; add 4709 4741; mul 164 4742; mul 4146 4630; mul 165 4631; add 4744 4745; mul 4325 4746;
mul 4220 4615; mul 394 4748; mul 1352 4225; sub 4749 4750; mul 4180 4626; mul 394 4752; add 4751 4753; mul 255 4754;
mul 255 4755; mul 4182 4416; mul 82 4723; add 4757 4758; mul 82 4729; add 4759 4760; mul 406 4314; mul 431 4300; sub
4762 4763; mul 406 4717; add 4764 4765; mul 399 4731; sub 4766 4767; mul 393 4768; mul 98 4769; add 4761 4770; mul
419 4720; sub 4772 4767; mul 393 4773; mul 98 4774; add 4771 4775; mul 4362 4736; add 4776 4777; mul 394 4778; add
4616 4779; mul 174 4780; add 4756 4781; mul 170 4740; add 4782 4783; mul 410 4735; add 4784 4785; mul 258 4735; mul
4149 4618; sub 4787 4788; mul 409 4789; add 4786 4790; mul 4059 4791; add 4747 4792; mul 163 4793; sub 4743 4794;
mul 4138 4795; mul 27 4796; mul 27 4797; add 4708 4798; mul 257 4746; mul 4387 4630; sub 4800 4801; mul 4145 4633;
sub 4802 4803; mul 258 4780; mul 4149 4627; sub 4805 4806; mul 4073 4807; sub 4804 4808; mul 4110 4742; sub 4809
4810; mul 169 4793; sub 4811 4812; mul 257 4791; mul 4069 4814; sub 4813 4815; mul 4129 4816; mul 27 4817; mul 27
4818; add 4799 4819; mul 184 2516; mul 171 4821; mul 177 2516; mul 175 4823; sub 4822 4824; mul 171 2548; add 4825
4826; mul 259 2516; mul 193 2534; sub 4828 4829; mul 2546 4103; add 4830 4831; mul 175 4832; add 4827 4833; mul 164
4834; mul 264 2514; mul 4059 4836; mul 163 4837; sub 4835 4838; mul 4138 4839; mul 27 4840; mul 27 4841; mul 169
4837; mul 257 4836; mul 4069 4844; add 4843 4845; mul 171 4832; mul 171 4823; mul 175 4821; add 4848 4849; mul 175
2548; add 4850 4851; sub 4847 4852; mul 4073 4853; add 4846 4854; mul 4110 4834; add 4855 4856; mul 4129 4857; mul
27 4858; mul 27 4859; sub 4842 4860; mul 304 2624; mul 302 4862; mul 311 2624; mul 299 4864; add 4863 4865; mul 299
2656; add 4866 4867; mul 375 2624; mul 320 2642; sub 4869 4870; mul 2654 4087; add 4871 4872; mul 302 4873; sub 4868
4874; mul 164 4875; mul 380 2622; mul 4059 4877; mul 163 4878; sub 4876 4879; mul 4138 4880; mul 27 4881; mul 27
4882; mul 169 4878; mul 257 4877; mul 4069 4885; add 4884 4886; mul 302 4864; mul 299 4862; sub 4888 4889; mul 302
2656; add 4890 4891; mul 299 4873; add 4892 4893; mul 4073 4894; add 4887 4895; mul 4110 4875; add 4896 4897; mul
4129 4898; mul 27 4899; mul 27 4900; sub 4883 4901; mul 22 993; mul 947 4903; neg 4904; mul 22 1627; mul 947 4906;
mul 22 2208; mul 947 4908; neg 4909; mul 22 979; mul 42 993; mul 982 4912; sub 4911 4913; mul 42 1627; mul 982 4915;
mul 22 1623; sub 4916 4917; mul 22 2198; mul 42 2208; mul 982 4920; sub 4919 4921; mul 22 985; mul 115 993; mul 982
4924; add 4923 4925; neg 4926; mul 22 1617; mul 115 1627; mul 982 4929; add 4928 4930; mul 22 2201; mul 115 2208;
mul 982 4933; add 4932 4934; neg 4935; mul 42 979; mul 196 4937; mul 47 993; neg 4939; mul 196 4940; add 4938 4941;
mul 42 1623; neg 4943; mul 196 4944; mul 47 1627; mul 196 4946; add 4945 4947; mul 42 2198; mul 196 4949; mul 47
2208; neg 4951; mul 196 4952; add 4950 4953; mul 115 979; mul 42 985; sub 4955 4956; mul 122 993; neg 4958; mul 196
4959; add 4957 4960; mul 42 1617; mul 115 1623; sub 4962 4963; mul 122 1627; mul 196 4965; add 4964 4966; mul 115
2198; mul 42 2201; sub 4968 4969; mul 122 2208; neg 4971; mul 196 4972; add 4970 4973; mul 115 985; neg 4975; mul
196 4976; mul 913 993; neg 4978; mul 196 4979; add 4977 4980; mul 115 1617; mul 196 4982; mul 913 1627; mul 196
4984; add 4983 4985; mul 115 2201; neg 4987; mul 196 4988; mul 913 2208; neg 4990; mul 196 4991; add 4989 4992; mul
47 979; mul 982 4994; mul 52 993; sub 4995 4996; mul 52 1627; mul 47 1623; mul 982 4999; sub 4998 5000; mul 47 2198;
mul 982 5002; mul 52 2208; sub 5003 5004; mul 122 979; mul 196 5006; mul 47 985; sub 5007 5008; mul 129 993; sub
5009 5010; mul 47 1617; mul 122 1623; neg 5013; mul 196 5014; add 5012 5015; mul 129 1627; add 5016 5017; mul 122
2198; mul 196 5019; mul 47 2201; sub 5020 5021; mul 129 2208; sub 5022 5023; mul 122 985; neg 5025; mul 196 5026;
mul 913 979; add 5027 5028; mul 923 993; sub 5029 5030; mul 122 1617; mul 196 5032; mul 913 1623; sub 5033 5034; mul
923 1627; add 5035 5036; mul 122 2201; neg 5038; mul 196 5039; mul 913 2198; add 5040 5041; mul 923 2208; sub 5042
5043; mul 913 985; mul 982 5045; add 1013 5046; neg 5047; mul 913 1617; mul 982 5049; add 1645 5050; mul 913 2201;
mul 982 5052; add 2226 5053; neg 5054; mul 52 979; mul 947 5056; mul 52 1623; mul 947 5058; neg 5059; mul 52 2198;
mul 947 5061; mul 129 979; mul 982 5063; mul 52 985; sub 5064 5065; mul 52 1617; mul 129 1623; mul 982 5068; sub
5067 5069; mul 129 2198; mul 982 5071; mul 52 2201; sub 5072 5073; mul 129 985; neg 5075; mul 196 5076; mul 923 979;
mul 196 5078; add 5077 5079; mul 129 1617; mul 196 5081; mul 923 1623; neg 5083; mul 196 5084; add 5082 5085; mul
129 2201; neg 5087; mul 196 5088; mul 923 2198; mul 196 5090; add 5089 5091; mul 923 985; mul 982 5093; sub 997
5094; mul 923 1617; mul 982 5096; sub 5097 1633; mul 923 2201; mul 982 5099; sub 2212 5100; mul 947 1000; neg 5102;
mul 947 1631; mul 947 2214; neg 5105; mul 22 986; mul 21 1013; mul 982 5108; add 5107 5109; neg 5110; mul 22 1618;
mul 21 1645; mul 982 5113; add 5112 5114; mul 22 2202; mul 21 2226; mul 982 5117; add 5116 5118; neg 5119; mul 21
997; mul 42 986; sub 5121 5122; mul 46 1013; neg 5124; mul 196 5125; add 5123 5126; mul 42 1618; mul 21 1633; sub
5128 5129; mul 46 1645; mul 196 5131; add 5130 5132; mul 21 2212; mul 42 2202; sub 5134 5135; mul 46 2226; neg 5137;
mul 196 5138; add 5136 5139; mul 882 1013; neg 5141; mul 196 5142; mul 115 986; mul 21 1000; add 5144 5145; sub 5143
5146; mul 115 1618; mul 21 1631; add 5148 5149; mul 882 1645; mul 196 5151; add 5150 5152; mul 882 2226; neg 5154;
mul 196 5155; mul 115 2202; mul 21 2214; add 5157 5158; sub 5156 5159; mul 46 997; mul 196 5161; mul 47 986; sub
5162 5163; mul 51 1013; sub 5164 5165; mul 47 1618; mul 46 1633; neg 5168; mul 196 5169; add 5167 5170; mul 51 1645;
add 5171 5172; mul 46 2212; mul 196 5174; mul 47 2202; sub 5175 5176; mul 51 2226; sub 5177 5178; mul 882 997; mul
122 986; mul 46 1000; add 5181 5182; sub 5180 5183; mul 889 1013; sub 5184 5185; mul 122 1618; mul 46 1631; add 5187
5188; mul 882 1633; sub 5189 5190; mul 889 1645; add 5191 5192; mul 882 2212; mul 122 2202; mul 46 2214; add 5195
5196; sub 5194 5197; mul 889 2226; sub 5198 5199; mul 882 1000; neg 5201; mul 196 5202; mul 913 986; sub 5203 5204;
mul 893 1013; sub 5205 5206; mul 913 1618; mul 882 1631; mul 196 5209; add 5208 5210; mul 893 1645; add 5211 5212;
mul 882 2214; neg 5214; mul 196 5215; mul 913 2202; sub 5216 5217; mul 893 2226; sub 5218 5219; mul 51 997; mul 982
5221; mul 52 986; sub 5222 5223; mul 52 1618; mul 51 1633; mul 982 5226; sub 5225 5227; mul 51 2212; mul 982 5229;
mul 52 2202; sub 5230 5231; mul 889 997; mul 196 5233; mul 129 986; mul 51 1000; add 5235 5236; sub 5234 5237; mul
129 1618; mul 51 1631; add 5239 5240; mul 889 1633; neg 5242; mul 196 5243; add 5241 5244; mul 889 2212; mul 196
5246; mul 129 2202; mul 51 2214; add 5248 5249; sub 5247 5250; mul 889 1000; neg 5252; mul 196 5253; mul 923 986;
sub 5254 5255; mul 893 997; add 5256 5257; mul 923 1618; mul 889 1631; mul 196 5260; add 5259 5261; mul 893 1633;
sub 5262 5263; mul 889 2214; neg 5265; mul 196 5266; mul 923 2202; sub 5267 5268; mul 893 2212; add 5269 5270; mul
896 986; mul 893 1000; mul 982 5273; add 5272 5274; neg 5275; mul 896 1618; mul 893 1631; mul 982 5278; add 5277
5279; mul 896 2202; mul 893 2214; mul 982 5282; add 5281 5283; neg 5284; mul 22 685; mul 947 5286; mul 22 1541; mul
947 5288; mul 22 2123; mul 947 5290; mul 22 2562; mul 947 5292; mul 22 2674; mul 947 5294; mul 22 678; mul 42 685;
mul 982 5297; add 5296 5298; mul 22 1535; mul 42 1541; mul 982 5301; add 5300 5302; mul 22 2117; mul 42 2123; mul
982 5305; add 5304 5306; mul 22 2557; mul 42 2562; mul 982 5309; add 5308 5310; mul 22 2669; mul 42 2674; mul 982
5313; add 5312 5314; mul 22 692; mul 115 685; mul 982 5317; add 5316 5318; mul 22 1548; mul 115 1541; mul 982 5321;
add 5320 5322; mul 22 2130; mul 115 2123; mul 982 5325; add 5324 5326; mul 22 2569; mul 115 2562; mul 982 5329; add
5328 5330; mul 22 2681; mul 115 2674; mul 982 5333; add 5332 5334; mul 42 678; mul 196 5336; mul 47 685; mul 196
5338; add 5337 5339; mul 42 1535; mul 196 5341; mul 47 1541; mul 196 5343; add 5342 5344; mul 42 2117; mul 196 5346;
mul 47 2123; mul 196 5348; add 5347 5349; mul 42 2557; mul 196 5351; mul 47 2562; mul 196 5353; add 5352 5354; mul
42 2669; mul 196 5356; mul 47 2674; mul 196 5358; add 5357 5359; mul 42 692; mul 115 678; add 5361 5362; mul 122
685; mul 196 5364; add 5363 5365; mul 42 1548; mul 115 1535; add 5367 5368; mul 122 1541; mul 196 5370; add 5369
5371; mul 42 2130; mul 115 2117; add 5373 5374; mul 122 2123; mul 196 5376; add 5375 5377; mul 42 2569; mul 115
2557; add 5379 5380; mul 122 2562; mul 196 5382; add 5381 5383; mul 42 2681; mul 115 2669; add 5385 5386; mul 122
2674; mul 196 5388; add 5387 5389; mul 47 678; mul 982 5391; mul 52 685; add 5392 5393; mul 47 1535; mul 982 5395;
mul 52 1541; add 5396 5397; mul 47 2117; mul 982 5399; mul 52 2123; add 5400 5401; mul 47 2557; mul 982 5403; mul 52
2562; add 5404 5405; mul 47 2669; mul 982 5407; mul 52 2674; add 5408 5409; mul 47 692; mul 122 678; mul 196 5412;
add 5411 5413; mul 129 685; add 5414 5415; mul 47 1548; mul 122 1535; mul 196 5418; add 5417 5419; mul 129 1541; add
5420 5421; mul 47 2130; mul 122 2117; mul 196 5424; add 5423 5425; mul 129 2123; add 5426 5427; mul 47 2569; mul 122
2557; mul 196 5430; add 5429 5431; mul 129 2562; add 5432 5433; mul 47 2681; mul 122 2669; mul 196 5436; add 5435
5437; mul 129 2674; add 5438 5439; mul 52 678; mul 947 5441; mul 52 1535; mul 947 5443; mul 52 2117; mul 947 5445;
mul 52 2557; mul 947 5447; mul 52 2669; mul 947 5449; mul 52 692; mul 129 678; mul 982 5452; add 5451 5453; mul 52
1548; mul 129 1535; mul 982 5456; add 5455 5457; mul 52 2130; mul 129 2117; mul 982 5460; add 5459 5461; mul 52
2569; mul 129 2557; mul 982 5464; add 5463 5465; mul 52 2681; mul 129 2669; mul 982 5468; add 5467 5469; mul 443
4223; mul 441 4183; sub 5471 5472; mul 445 4284; sub 5473 5474; mul 417 4298; mul 399 4300; add 5476 5477; mul 421
4289; add 5478 5479; mul 418 5480; add 5475 5481; mul 399 4292; mul 417 4290; sub 5483 5484; mul 418 5485; add 5482
5486; mul 404 4294; add 5487 5488; mul 404 4304; sub 5489 5490; mul 428 4289; mul 430 5492; add 5491 5493; mul 398
4350; add 5494 5495; mul 398 4358; add 5496 5497; mul 417 4311; mul 406 4300; mul 406 4292; add 5500 5501; sub 5499
5502; mul 417 4314; add 5503 5504; mul 423 5505; add 5498 5506; mul 415 4316; add 5507 5508; mul 1352 4183; mul 1343
4223; sub 5510 5511; mul 443 4284; add 5512 5513; mul 421 4512; sub 5515 4726; mul 418 5516; add 5514 5517; sub 4349
4344; mul 417 4513; sub 5519 5520; mul 399 4517; add 5521 5522; mul 418 5523; add 5518 5524; mul 404 4519; add 5525
5526; mul 404 4522; sub 5527 5528; mul 428 4512; add 4302 5530; mul 430 5531; add 5529 5532; mul 398 4557; add 5533
5534; mul 398 4566; add 5535 5536; sub 4763 4762; mul 406 4517; sub 5538 5539; mul 417 4525; add 5540 5541; mul 423
5542; add 5537 5543; mul 415 4528; add 5544 5545; mul 1352 4223; mul 1928 4183; sub 5547 5548; mul 441 4284; sub
5549 5550; mul 421 4716; mul 418 5552; add 5551 5553; sub 5500 5504; mul 417 4717; sub 5555 5556; mul 399 4720; add
5557 5558; mul 418 5559; add 5554 5560; mul 404 4722; add 5561 5562; mul 404 4728; add 5563 5564; mul 428 4716; sub
5566 5478; mul 430 5567; add 5565 5568; mul 398 4768; add 5569 5570; mul 398 4773; add 5571 5572; mul 417 4731; mul
406 4720; sub 5574 5575; mul 423 5576; add 5573 5577; mul 415 4735; add 5578 5579; sub 4294 4304; sub 4519 4522; add
4722 4728; mul 258 4375; mul 258 4582; mul 258 4789; mul 267 4048; mul 267 5587; mul 74 658; mul 2 5589; add 682
5590; mul 2 5591; add 5588 5592; mul 393 5480; mul 98 5594; mul 4034 4182; sub 5595 5596; mul 393 5485; mul 98 5598;
add 5597 5599; mul 397 4295; add 5600 5601; mul 397 4305; sub 5602 5603; mul 82 196; mul 393 5492; mul 5605 5606;
add 5604 5607; mul 2 5608; add 5593 5609; mul 267 4421; mul 267 5611; mul 74 1526; mul 2 5613; sub 5614 1539; mul 2
5615; add 5612 5616; mul 393 5516; mul 98 5618; add 4339 5619; mul 393 5523; mul 98 5621; add 5620 5622; mul 397
4520; add 5623 5624; mul 397 4523; sub 5625 5626; mul 393 5531; mul 5605 5628; add 5627 5629; mul 2 5630; add 5617
5631; mul 267 4626; mul 267 5633; mul 74 2108; mul 2 5635; add 2120 5636; mul 2 5637; add 5634 5638; mul 393 5552;
mul 98 5640; mul 4044 4182; sub 5641 5642; mul 393 5559; mul 98 5644; add 5643 5645; mul 397 4723; add 5646 5647;
mul 397 4729; add 5648 5649; mul 393 5567; mul 5605 5651; add 5650 5652; mul 2 5653; add 5639 5654; mul 74 2548; mul
2 5656; add 2559 5657; mul 2 5658; mul 74 2656; mul 2 5660; add 2671 5661; mul 2 5662; mul 255 4048; mul 267 5664;
mul 255 5587; add 5665 5666; mul 27 5589; add 563 5668; mul 2 5669; add 5667 5670; mul 27 5591; add 5671 5672; mul
27 5608; add 5673 5674; mul 2 4364; add 5675 5676; mul 255 4421; mul 267 5678; mul 255 5611; add 5679 5680; mul 27
5613; add 1370 5682; mul 2 5683; add 5681 5684; mul 27 5615; add 5685 5686; mul 27 5630; add 5687 5688; mul 2 4571;
add 5689 5690; mul 255 4626; mul 267 5692; mul 255 5633; add 5693 5694; mul 27 5635; add 2030 5696; mul 2 5697; add
5695 5698; mul 27 5637; add 5699 5700; mul 27 5653; add 5701 5702; mul 2 4778; add 5703 5704; mul 27 5656; add 2509
5706; mul 2 5707; mul 27 5658; add 5708 5709; mul 27 5660; add 2658 5711; mul 2 5712; mul 27 5662; add 5713 5714;
mul 255 5664; mul 27 5669; add 5716 5717; mul 27 4364; add 5718 5719; mul 255 5678; mul 27 5683; add 5721 5722; mul
27 4571; add 5723 5724; mul 255 5692; mul 27 5697; add 5726 5727; mul 27 4778; add 5728 5729; mul 27 5707; mul 27
5712; mul 287 4048; mul 267 5733; mul 287 5587; add 5734 5735; mul 59 5589; add 466 5737; mul 2 5738; add 5736 5739;
mul 59 5591; add 5740 5741; mul 59 5608; add 5742 5743; mul 82 5594; sub 5745 5642; mul 82 5598; add 5746 5747; mul
397 4351; add 5748 5749; mul 397 4359; add 5750 5751; mul 98 196; mul 393 5505; mul 5753 5754; add 5752 5755; mul 2
5756; add 5744 5757; mul 287 4421; mul 267 5759; mul 287 5611; add 5760 5761; mul 59 5613; sub 5763 1448; mul 2
5764; add 5762 5765; mul 59 5615; add 5766 5767; mul 59 5630; add 5768 5769; mul 82 5618; add 4757 5771; mul 82
5621; add 5772 5773; mul 397 4558; add 5774 5775; mul 397 4567; add 5776 5777; mul 393 5542; mul 5753 5779; add 5778
5780; mul 2 5781; add 5770 5782; mul 287 4626; mul 267 5784; mul 287 5633; add 5785 5786; mul 59 5635; add 1951
5788; mul 2 5789; add 5787 5790; mul 59 5637; add 5791 5792; mul 59 5653; add 5793 5794; mul 82 5640; mul 4182 4622;
sub 5796 5797; mul 82 5644; add 5798 5799; mul 397 4769; add 5800 5801; mul 397 4774; add 5802 5803; mul 393 5576;
mul 5753 5805; add 5804 5806; mul 2 5807; add 5795 5808; mul 59 5656; add 2507 5810; mul 2 5811; mul 59 5658; add
5812 5813; mul 59 5660; add 2618 5815; mul 2 5816; mul 59 5662; add 5817 5818; mul 255 5733; mul 287 5664; add 5820
5821; mul 27 5738; add 5822 5823; mul 59 5669; add 5824 5825; mul 27 5756; add 5826 5827; mul 59 4364; add 5828
5829; mul 255 5759; mul 287 5678; add 5831 5832; mul 27 5764; add 5833 5834; mul 59 5683; add 5835 5836; mul 27
5781; add 5837 5838; mul 59 4571; add 5839 5840; mul 255 5784; mul 287 5692; add 5842 5843; mul 27 5789; add 5844
5845; mul 59 5697; add 5846 5847; mul 27 5807; add 5848 5849; mul 59 4778; add 5850 5851; mul 27 5811; mul 59 5707;
add 5853 5854; mul 27 5816; mul 59 5712; add 5856 5857; mul 287 5733; mul 59 5738; add 5859 5860; mul 59 5756; add
5861 5862; mul 287 5759; mul 59 5764; add 5864 5865; mul 59 5781; add 5866 5867; mul 287 5784; mul 59 5789; add 5869
5870; mul 59 5807; add 5871 5872; mul 59 5811; mul 59 5816; mul 174 4076; mul 394 5876; sub 452 5877; mul 174 4442;
mul 394 5879; add 1356 5880; mul 174 4649; mul 394 5882; sub 1937 5883; mul 4032 4330; mul 72 5876; sub 5885 5886;
mul 4032 4334; add 5887 5888; mul 395 4364; add 5889 5890; mul 401 4319; add 5891 5892; mul 72 5879; mul 4032 4542;
add 5894 5895; mul 4032 4545; add 5896 5897; mul 395 4571; add 5898 5899; mul 401 4531; add 5900 5901; mul 4032
4748; mul 72 5882; sub 5903 5904; mul 4032 4752; add 5905 5906; mul 395 4778; add 5907 5908; mul 401 4738; add 5909
5910; neg 443; neg 228; neg 351; neg 231; neg 354; neg 235; neg 358; input p 227; mul 328 491; mul 5919 5920; add
491 5921; input p 228; mul 5920 5923; mul 74 5924; add 5922 5925; add 589 5926; mul 205 589; mul 5919 5928; add 5927
5929; mul 5923 5928; mul 74 5931; add 5930 5932; mul 328 1384; mul 5919 5934; add 1384 5935; mul 5923 5934; mul 74
5937; add 5936 5938; add 1475 5939; mul 205 1475; mul 5919 5941; add 5940 5942; mul 5923 5941; mul 74 5944; add 5943
5945; neg 5946; mul 328 1973; mul 5919 5948; add 1973 5949; mul 5923 5948; mul 74 5951; add 5950 5952; add 2053
5953; mul 205 2053; mul 5919 5955; add 5954 5956; mul 5923 5955; mul 74 5958; add 5957 5959; mul 205 2521; mul 5919
5961; add 2521 5962; mul 5923 5961; mul 74 5964; add 5963 5965; mul 328 2629; mul 5919 5967; add 2629 5968; mul 5923
5967; mul 74 5970; add 5969 5971; le 7 4245; le 4245 7; add 5973 5974; div 17 5975; mul 5973 5976; mul 267 445; mul
5977 5978; neg 5979; mul 267 443; mul 5977 5981; mul 267 441; mul 5977 5983; neg 5984; mul 4259 5978; neg 5986; mul
4259 5981; mul 4259 5983; neg 5989; mul 445 4268; mul 267 5991; neg 5992; mul 443 4268; mul 267 5994; mul 441 4268;
mul 267 5996; neg 5997; input p 229; mul 4268 4269; mul 445 6000; mul 196 4267; div 17 6002; mul 6001 6003; mul 5999
6004; mul 443 6000; mul 6003 6006; mul 5999 6007; neg 6008; mul 441 6000; mul 6003 6010; mul 5999 6011; mul 443
4214; mul 1343 4214; neg 6014; mul 1352 4214; le 17 4201; mul 255 4215; add 267 6018; lt 7 6019; and 6017 6020;
constant -1.0; le 4201 6022; lt 6019 7; and 6023 6024; or 6021 6025; not 6026; input p 173; mul 255 6028; where 6027
6029; le 17 4204; and 6020 6031; le 4204 6022; and 6024 6033; or 6032 6034; not 6035; input p 174; mul 255 6037;
where 6036 6038; le 17 4208; and 6020 6040; le 4208 6022; and 6024 6042; or 6041 6043; not 6044; input p 175; mul
255 6046; where 6045 6047; le 17 4212; and 6020 6049; le 4212 6022; and 6024 6051; or 6050 6052; not 6053; input p
176; mul 255 6055; where 6054 6056; mul 170 4105; mul 170 4092; mul 174 4095; add 6059 6060; mul 174 657; add 6061
6062; sub 6058 6063; mul 170 4459; mul 174 4462; add 6065 6066; mul 174 1525; sub 6067 6068; mul 170 4471; add 6069
6070; mul 170 4676; mul 170 4664; mul 174 4667; add 6073 6074; mul 174 2107; add 6075 6076; sub 6072 6077; mul 170
4832; mul 170 4823; mul 174 4821; add 6080 6081; mul 174 2548; add 6082 6083; sub 6079 6084; mul 170 4095; mul 174
4092; sub 6086 6087; mul 170 657; add 6088 6089; mul 174 4105; add 6090 6091; mul 174 4459; mul 170 4462; sub 6093
6094; mul 170 1525; add 6095 6096; mul 174 4471; add 6097 6098; mul 170 4667; mul 174 4664; sub 6100 6101; mul 170
2107; add 6102 6103; mul 174 4676; add 6104 6105; mul 170 4821; mul 174 4823; sub 6107 6108; mul 170 2548; add 6109
6110; mul 174 4832; add 6111 6112; neg 4105; neg 4471; neg 4676; neg 4832; mul 178 193; mul 637 6118; mul 178 242;
mul 620 6120; add 6119 6121; mul 178 226; mul 461 6123; add 6122 6124; mul 178 189; mul 653 6126; add 6125 6127; neg
6128; mul 1490 6120; mul 1505 6118; sub 6130 6131; mul 1365 6123; add 6132 6133; mul 1521 6126; sub 6134 6135; mul
2087 6118; mul 2071 6120; add 6137 6138; mul 1946 6123; add 6139 6140; mul 2103 6126; add 6141 6142; neg 6143; mul
2538 6118; mul 2524 6120; add 6145 6146; mul 2544 6126; add 6147 6148; neg 6149; mul 200 639; mul 200 1507; neg
6152; mul 200 2089; neg 1484; mul 207 611; mul 207 1484; neg 6157; mul 207 2065; mul 223 592; mul 215 6160; neg
6161; mul 223 1463; mul 215 6163; mul 223 2056; mul 215 6165; neg 6166; input p 230; mul 205 596; mul 6168 6169; add
596 6170; input p 231; mul 6169 6172; mul 74 6173; add 6171 6174; neg 6175; mul 205 1479; mul 6168 6177; add 1479
6178; mul 6172 6177; mul 74 6180; add 6179 6181; mul 205 2060; mul 6168 6183; add 2060 6184; mul 6172 6183; mul 74
6186; add 6185 6187; neg 6188; mul 249 461; mul 228 6190; mul 249 1365; mul 228 6192; neg 6193; mul 249 1946; mul
228 6195; mul 231 6190; mul 231 6192; neg 6198; mul 231 6195; mul 235 6190; mul 235 6192; neg 6202; mul 235 6195;
mul 249 582; mul 249 1468; neg 6206; mul 249 2046; mul 170 4078; mul 174 4074; add 6209 6210; mul 174 559; add 6211
6212; mul 170 4089; sub 6213 6214; mul 174 1445; mul 170 4444; mul 174 4447; add 6217 6218; sub 6216 6219; mul 170
4456; sub 6220 6221; mul 170 4651; mul 174 4647; add 6223 6224; mul 174 2027; add 6225 6226; mul 170 4661; sub 6227
6228; mul 170 4862; mul 174 4864; add 6230 6231; mul 174 2656; add 6232 6233; mul 170 4873; sub 6234 6235; mul 170
4074; mul 174 4078; sub 6237 6238; mul 170 559; add 6239 6240; mul 174 4089; add 6241 6242; mul 174 4444; mul 170
4447; sub 6244 6245; mul 170 1445; add 6246 6247; mul 174 4456; add 6248 6249; mul 170 4647; mul 174 4651; sub 6251
6252; mul 170 2027; add 6253 6254; mul 174 4661; add 6255 6256; mul 170 4864; mul 174 4862; sub 6258 6259; mul 170
2656; add 6260 6261; mul 174 4873; add 6262 6263; mul 305 320; mul 539 6265; mul 305 364; mul 522 6267; add 6266
6268; mul 305 349; mul 454 6270; add 6269 6271; mul 305 316; mul 555 6273; add 6272 6274; neg 6275; mul 1399 6267;
mul 1421 6265; sub 6277 6278; mul 1358 6270; add 6279 6280; mul 1437 6273; sub 6281 6282; mul 2007 6265; mul 1991
6267; add 6284 6285; mul 1939 6270; add 6286 6287; mul 2023 6273; add 6288 6289; neg 6290; mul 2646 6265; mul 2632
6267; add 6292 6293; mul 2652 6273; add 6294 6295; neg 6296; mul 326 541; mul 326 1423; neg 6299; mul 326 2009; neg
1393; mul 330 513; mul 330 1393; neg 6304; mul 330 1985; mul 346 494; mul 338 6307; neg 6308; mul 346 1372; mul 338
6310; mul 346 1976; mul 338 6312; neg 6313; input p 232; mul 328 498; mul 6315 6316; add 498 6317; input p 233; mul
6316 6319; mul 74 6320; add 6318 6321; neg 6322; mul 328 1388; mul 6315 6324; add 1388 6325; mul 6319 6324; mul 74
6327; add 6326 6328; mul 328 1980; mul 6315 6330; add 1980 6331; mul 6319 6330; mul 74 6333; add 6332 6334; neg
6335; mul 369 454; mul 351 6337; mul 369 1358; mul 351 6339; neg 6340; mul 369 1939; mul 351 6342; mul 354 6337; mul
354 6339; neg 6345; mul 354 6342; mul 358 6337; mul 358 6339; neg 6349; mul 358 6342; mul 369 484; mul 369 1377; neg
6353; mul 369 1966; mul 443 4215; sub 6356 445; mul 4201 6357; mul 1343 4215; sub 443 6359; mul 4201 6360; mul 1352
4215; sub 6362 441; mul 4201 6363; mul 4204 6357; mul 4204 6360; mul 4204 6363; mul 4208 6357; mul 4208 6360; mul
4208 6363; mul 4212 6357; mul 4212 6360; mul 4212 6363; mul 6019 6028; mul 6028 6374; neg 6375; where 6027 6376; mul
6019 6037; mul 6037 6378; neg 6379; where 6036 6380; mul 6019 6046; mul 6046 6382; neg 6383; where 6045 6384; mul
6019 6055; mul 6055 6386; neg 6387; where 6054 6388; mul 445 4275; neg 6390; mul 443 4275; mul 441 4275; neg 6393;
mul 445 4279; neg 6395; mul 443 4279; mul 441 4279; neg 6398; mul 758 3937; mul 3 1337; sub 6400 6401; mul 758 3949;
mul 3 1922; add 6403 6404; mul 758 3961; mul 3 2503; sub 6406 6407; store by_k 108 1339; store by_k 324 1924; store
by_k 540 2505; store by_k 648 2616; store by_k 756 2727; store by_k 864 2616; store by_k 972 2727; store by_k 1080
2616; store by_k 1188 2727; store by_k 109 2871; store by_k 325 2876; store by_k 541 2881; store by_k 110 2901;
store by_k 326 2913; store by_k 542 2925; store by_k 111 3060; store by_k 327 3168; store by_k 543 3276; store by_k
112 3442; store by_k 328 3570; store by_k 544 3698; store by_k 113 3775; store by_k 329 3849; store by_k 545 3923;
store by_k 114 3938; store by_k 330 3950; store by_k 546 3962; store by_k 115 3977; store by_k 331 3989; store by_k
547 4001; store by_k 116 4012; store by_k 332 4019; store by_k 548 4029; store by_k 117 4407; store by_k 333 4613;
store by_k 549 4820; store by_k 657 4861; store by_k 765 4902; store by_k 873 4861; store by_k 981 4902; store by_k
1089 4861; store by_k 1197 4902; store by_k 118 4905; store by_k 334 4907; store by_k 550 4910; store by_k 119 4914;
store by_k 335 4918; store by_k 551 4922; store by_k 120 4927; store by_k 336 4931; store by_k 552 4936; store by_k
121 4942; store by_k 337 4948; store by_k 553 4954; store by_k 122 4961; store by_k 338 4967; store by_k 554 4974;
store by_k 123 4981; store by_k 339 4986; store by_k 555 4993; store by_k 124 4997; store by_k 340 5001; store by_k
556 5005; store by_k 125 5011; store by_k 341 5018; store by_k 557 5024; store by_k 126 5031; store by_k 342 5037;
store by_k 558 5044; store by_k 127 5048; store by_k 343 5051; store by_k 559 5055; store by_k 128 5057; store by_k
344 5060; store by_k 560 5062; store by_k 129 5066; store by_k 345 5070; store by_k 561 5074; store by_k 130 5080;
store by_k 346 5086; store by_k 562 5092; store by_k 131 5095; store by_k 347 5098; store by_k 563 5101; store by_k
132 5103; store by_k 348 5104; store by_k 564 5106; store by_k 133 5111; store by_k 349 5115; store by_k 565 5120;
store by_k 134 5127; store by_k 350 5133; store by_k 566 5140; store by_k 135 5147; store by_k 351 5153; store by_k
567 5160; store by_k 136 5166; store by_k 352 5173; store by_k 568 5179; store by_k 137 5186; store by_k 353 5193;
store by_k 569 5200; store by_k 138 5207; store by_k 354 5213; store by_k 570 5220; store by_k 139 5224; store by_k
355 5228; store by_k 571 5232; store by_k 140 5238; store by_k 356 5245; store by_k 572 5251; store by_k 141 5258;
store by_k 357 5264; store by_k 573 5271; store by_k 142 5276; store by_k 358 5280; store by_k 574 5285; store by_k
143 5287; store by_k 359 5289; store by_k 575 5291; store by_k 683 5293; store by_k 791 5295; store by_k 899 5293;
store by_k 1007 5295; store by_k 1115 5293; store by_k 1223 5295; store by_k 144 5299; store by_k 360 5303; store
by_k 576 5307; store by_k 684 5311; store by_k 792 5315; store by_k 900 5311; store by_k 1008 5315; store by_k 1116
5311; store by_k 1224 5315; store by_k 145 5319; store by_k 361 5323; store by_k 577 5327; store by_k 685 5331;
store by_k 793 5335; store by_k 901 5331; store by_k 1009 5335; store by_k 1117 5331; store by_k 1225 5335; store
by_k 146 5340; store by_k 362 5345; store by_k 578 5350; store by_k 686 5355; store by_k 794 5360; store by_k 902
5355; store by_k 1010 5360; store by_k 1118 5355; store by_k 1226 5360; store by_k 147 5366; store by_k 363 5372;
store by_k 579 5378; store by_k 687 5384; store by_k 795 5390; store by_k 903 5384; store by_k 1011 5390; store by_k
1119 5384; store by_k 1227 5390; store by_k 148 5394; store by_k 364 5398; store by_k 580 5402; store by_k 688 5406;
store by_k 796 5410; store by_k 904 5406; store by_k 1012 5410; store by_k 1120 5406; store by_k 1228 5410; store
by_k 149 5416; store by_k 365 5422; store by_k 581 5428; store by_k 689 5434; store by_k 797 5440; store by_k 905
5434; store by_k 1013 5440; store by_k 1121 5434; store by_k 1229 5440; store by_k 150 5442; store by_k 366 5444;
store by_k 582 5446; store by_k 690 5448; store by_k 798 5450; store by_k 906 5448; store by_k 1014 5450; store by_k
1122 5448; store by_k 1230 5450; store by_k 151 5454; store by_k 367 5458; store by_k 583 5462; store by_k 691 5466;
store by_k 799 5470; store by_k 907 5466; store by_k 1015 5470; store by_k 1123 5466; store by_k 1231 5470; store
by_k 152 5509; store by_k 368 5546; store by_k 584 5580; store by_k 153 5581; store by_k 369 5582; store by_k 585
5583; store by_k 154 4316; store by_k 370 4528; store by_k 586 4735; store by_k 155 5584; store by_k 371 5585; store
by_k 587 5586; store by_k 156 5505; store by_k 372 5542; store by_k 588 5576; store by_k 157 5610; store by_k 373
5632; store by_k 589 5655; store by_k 697 5659; store by_k 805 5663; store by_k 913 5659; store by_k 1021 5663;
store by_k 1129 5659; store by_k 1237 5663; store by_k 158 5677; store by_k 374 5691; store by_k 590 5705; store
by_k 698 5710; store by_k 806 5715; store by_k 914 5710; store by_k 1022 5715; store by_k 1130 5710; store by_k 1238
5715; store by_k 159 5720; store by_k 375 5725; store by_k 591 5730; store by_k 699 5731; store by_k 807 5732; store
by_k 915 5731; store by_k 1023 5732; store by_k 1131 5731; store by_k 1239 5732; store by_k 160 5758; store by_k 376
5783; store by_k 592 5809; store by_k 700 5814; store by_k 808 5819; store by_k 916 5814; store by_k 1024 5819;
store by_k 1132 5814; store by_k 1240 5819; store by_k 161 5830; store by_k 377 5841; store by_k 593 5852; store
by_k 701 5855; store by_k 809 5858; store by_k 917 5855; store by_k 1025 5858; store by_k 1133 5855; store by_k 1241
5858; store by_k 162 5863; store by_k 378 5868; store by_k 594 5873; store by_k 702 5874; store by_k 810 5875; store
by_k 918 5874; store by_k 1026 5875; store by_k 1134 5874; store by_k 1242 5875; store by_k 163 5878; store by_k 379
5881; store by_k 595 5884; store by_k 164 5893; store by_k 380 5902; store by_k 596 5911; store by_k 165 445; store
by_k 381 5912; store by_k 597 441; store by_k 706 5913; store by_k 814 5914; store by_k 923 5915; store by_k 1031
5916; store by_k 1140 5917; store by_k 1248 5918; store by_k 169 5933; store by_k 385 5947; store by_k 601 5960;
store by_k 709 5966; store by_k 817 5972; store by_k 925 5966; store by_k 1033 5972; store by_k 1141 5966; store
by_k 1249 5972; store by_k 170 5980; store by_k 386 5982; store by_k 602 5985; store by_k 171 5987; store by_k 387
5988; store by_k 603 5990; store by_k 172 5993; store by_k 388 5995; store by_k 604 5998; store by_k 173 6005; store
by_k 389 6009; store by_k 605 6012; store by_k 174 6013; store by_k 390 6015; store by_k 606 6016; store by_k 1578
6030; store by_k 1686 6039; store by_k 1794 6048; store by_k 1902 6057; store by_k 175 6064; store by_k 391 6071;
store by_k 607 6078; store by_k 715 6085; store by_k 931 6085; store by_k 1147 6085; store by_k 176 6092; store by_k
392 6099; store by_k 608 6106; store by_k 716 6113; store by_k 932 6113; store by_k 1148 6113; store by_k 177 6114;
store by_k 393 6115; store by_k 609 6116; store by_k 717 6117; store by_k 933 6117; store by_k 1149 6117; store by_k
178 657; store by_k 394 1525; store by_k 610 2107; store by_k 718 2548; store by_k 934 2548; store by_k 1150 2548;
store by_k 179 6129; store by_k 395 6136; store by_k 611 6144; store by_k 719 6150; store by_k 935 6150; store by_k
1151 6150; store by_k 180 6151; store by_k 396 6153; store by_k 612 6154; store by_k 181 611; store by_k 397 6155;
store by_k 613 2065; store by_k 182 6156; store by_k 398 6158; store by_k 614 6159; store by_k 183 6162; store by_k
399 6164; store by_k 615 6167; store by_k 184 6176; store by_k 400 6182; store by_k 616 6189; store by_k 185 6191;
store by_k 401 6194; store by_k 617 6196; store by_k 186 6197; store by_k 402 6199; store by_k 618 6200; store by_k
187 6201; store by_k 403 6203; store by_k 619 6204; store by_k 188 6205; store by_k 404 6207; store by_k 620 6208;
store by_k 189 6215; store by_k 405 6222; store by_k 621 6229; store by_k 837 6236; store by_k 1053 6236; store by_k
1269 6236; store by_k 190 6243; store by_k 406 6250; store by_k 622 6257; store by_k 838 6264; store by_k 1054 6264;
store by_k 1270 6264; store by_k 191 4089; store by_k 407 4456; store by_k 623 4661; store by_k 839 4873; store by_k
1055 4873; store by_k 1271 4873; store by_k 192 559; store by_k 408 1445; store by_k 624 2027; store by_k 840 2656;
store by_k 1056 2656; store by_k 1272 2656; store by_k 193 6276; store by_k 409 6283; store by_k 625 6291; store
by_k 841 6297; store by_k 1057 6297; store by_k 1273 6297; store by_k 194 6298; store by_k 410 6300; store by_k 626
6301; store by_k 195 513; store by_k 411 6302; store by_k 627 1985; store by_k 196 6303; store by_k 412 6305; store
by_k 628 6306; store by_k 197 6309; store by_k 413 6311; store by_k 629 6314; store by_k 198 6323; store by_k 414
6329; store by_k 630 6336; store by_k 199 6338; store by_k 415 6341; store by_k 631 6343; store by_k 200 6344; store
by_k 416 6346; store by_k 632 6347; store by_k 201 6348; store by_k 417 6350; store by_k 633 6351; store by_k 202
6352; store by_k 418 6354; store by_k 634 6355; store by_k 203 6358; store by_k 419 6361; store by_k 635 6364; store
by_k 204 6365; store by_k 420 6366; store by_k 636 6367; store by_k 205 6368; store by_k 421 6369; store by_k 637
6370; store by_k 206 6371; store by_k 422 6372; store by_k 638 6373; store by_k 1611 6377; store by_k 1720 6381;
store by_k 1829 6385; store by_k 1938 6389; store by_k 211 6391; store by_k 427 6392; store by_k 643 6394; store
by_k 212 6396; store by_k 428 6397; store by_k 644 6399; store by_k 1401 4275; store by_k 1510 4279; store by_k 215
6402; store by_k 431 6405; store by_k 647 6408
    """,
)
