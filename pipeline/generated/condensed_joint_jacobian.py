"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 112},
    {'p': 242},
    """
input k 46; input k 47; constant 1.0; input k 9; sub 3 2; input k 44; input k 56; input k 50; input k 51; input k
53; input k 48; input k 52; input k 54; input k 49; input k 45; input k 111; input k 0; div 2 16; mul 15 17;
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
input k 99; input k 100; input k 63; input k 64; input k 65; mul 283 283; input k 107; input k 108; mul 3 188; mul
188 192; input k 31; mul 184 289; input k 32; mul 188 291; input k 33; mul 184 207; mul 188 208; input k 20; mul 26
296; input k 21; mul 184 298; input k 22; mul 188 300; input k 23; mul 6 212; input k 66; constant 2.4; mul 54 305;
add 41 306; constant 0.019047619047619053; mul 59 308; add 307 309; constant -1.3714285714285719; mul 63 311;
constant 1.371428571428571; mul 53 313; constant 0.007256235827664402; mul 58 315; add 314 316; constant
-4.799999999999996; mul 63 318; constant 1.3714285714285672; mul 53 320; constant -0.05714285714285713; mul 58 322;
add 321 323; constant -7.200000000000003; mul 63 325; constant 7.199999999999999; mul 53 327; constant
0.2190476190476187; mul 58 329; add 328 330; constant -45.25714285714285; mul 53 332; constant -0.1142857142857146;
mul 58 334; add 333 335; constant -28.80000000000001; mul 63 337; mul 188 194; mul 188 293; input k 34; mul 184 341;
mul 188 209; mul 184 210; mul 184 302; input k 24; mul 26 346; mul 21 41; input k 58; input k 59; input k 60; input
k 109; input k 110; input k 101; div 2 354; input k 102; div 2 356; input k 103; div 2 358; input k 104; div 2 360;
input k 105; div 2 362; input k 106; div 2 364; mul 17 27; mul 61 366; mul 17 88; mul 138 366; mul 17 61; add 285
286; mul 125 366; mul 17 35; mul 211 366; add 373 374; mul 21 375; mul 17 211; mul 26 366; add 377 378; mul 21 379;
mul 27 380; add 376 381; mul 17 382; mul 23 380; mul 39 380; mul 23 61; mul 23 138; mul 23 125; mul 23 211; mul 21
389; mul 23 26; mul 21 391; mul 27 392; add 390 393; mul 17 394; mul 23 392; mul 39 392; mul 304 355; mul 304 357;
mul 304 359; mul 304 361; mul 304 363; mul 304 365; mul 39 61; mul 39 138; mul 39 125; mul 26 39; mul 21 407; mul 23
408; mul 39 211; mul 21 410; mul 27 408; add 411 412; mul 17 413; mul 39 408; add 348 415; neg 349; neg 350; neg
351; neg 352; neg 353; mul 275 304; mul 276 304; mul 277 304; mul 278 304; mul 279 304; mul 280 304; mul 17 18; mul
51 188; mul 45 46; mul 29 188; mul 23 188; mul 39 188; mul 188 283; store p 0 0; store p 1 3; store p 2 4; store p 3
1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p 11 12;
store p 12 13; store p 13 14; store p 14 18; store p 15 46; store p 16 47; store p 17 17; store p 18 48; store p 19
61; store p 20 27; store p 21 23; store p 22 39; store p 23 64; store p 24 69; store p 25 71; store p 26 76; store p
27 81; store p 28 88; store p 29 90; store p 30 95; store p 31 97; store p 32 102; store p 33 107; store p 34 112;
store p 35 117; store p 36 123; store p 37 125; store p 38 127; store p 39 132; store p 40 138; store p 41 140;
store p 42 145; store p 43 149; store p 44 154; store p 45 159; store p 46 161; store p 47 166; store p 48 171;
store p 49 173; store p 50 178; store p 51 183; store p 52 186; store p 53 189; store p 54 191; store p 55 192;
store p 56 193; store p 57 194; store p 58 196; store p 59 198; store p 60 200; store p 61 202; store p 62 204;
store p 63 206; store p 64 207; store p 65 208; store p 66 209; store p 67 210; store p 68 21; store p 69 220; store
p 70 222; store p 71 224; store p 72 226; store p 73 228; store p 74 229; store p 75 230; store p 76 212; store p 77
218; store p 78 16; store p 79 221; store p 80 227; store p 81 231; store p 82 232; store p 83 234; store p 84 236;
store p 85 223; store p 86 235; store p 87 216; store p 88 214; store p 89 238; store p 90 215; store p 91 213;
store p 92 239; store p 93 240; store p 94 241; store p 95 242; store p 96 246; store p 97 247; store p 98 248;
store p 99 249; store p 100 250; store p 101 253; store p 102 254; store p 103 260; store p 104 256; store p 105
257; store p 106 262; store p 107 258; store p 108 255; store p 109 263; store p 110 264; store p 111 265; store p
112 266; store p 113 269; store p 114 270; store p 115 271; store p 116 272; store p 117 273; store p 118 274; store
p 119 275; store p 120 276; store p 121 277; store p 122 278; store p 123 279; store p 124 280; store p 125 281;
store p 126 282; store p 127 284; store p 128 285; store p 129 286; store p 130 287; store p 131 187; store p 132
288; store p 133 290; store p 134 292; store p 135 293; store p 136 197; store p 137 203; store p 138 294; store p
139 295; store p 140 297; store p 141 299; store p 142 301; store p 143 302; store p 144 303; store p 145 304; store
p 146 310; store p 147 312; store p 148 317; store p 149 319; store p 150 324; store p 151 326; store p 152 331;
store p 153 336; store p 154 338; store p 155 190; store p 156 339; store p 157 291; store p 158 340; store p 159
342; store p 160 199; store p 161 343; store p 162 344; store p 163 298; store p 164 345; store p 165 347; store p
166 185; store p 167 289; store p 168 341; store p 169 348; store p 170 349; store p 171 350; store p 172 351; store
p 173 352; store p 174 353; store p 175 355; store p 176 357; store p 177 359; store p 178 361; store p 179 363;
store p 180 365; store p 181 367; store p 182 366; store p 183 368; store p 184 369; store p 185 370; store p 186
371; store p 187 372; store p 188 383; store p 189 384; store p 190 385; store p 191 386; store p 192 387; store p
193 388; store p 194 395; store p 195 396; store p 196 397; store p 197 398; store p 198 399; store p 199 400; store
p 200 401; store p 201 402; store p 202 403; store p 203 404; store p 204 405; store p 205 406; store p 206 409;
store p 207 414; store p 208 416; store p 209 417; store p 210 418; store p 211 419; store p 212 420; store p 213
421; store p 214 422; store p 215 423; store p 216 424; store p 217 425; store p 218 426; store p 219 427; store p
220 428; store p 221 24; store p 222 45; store p 223 52; store p 224 51; store p 225 120; store p 226 53; store p
227 429; store p 228 58; store p 229 430; store p 230 431; store p 231 15; store p 232 432; store p 233 22; store p
234 433; store p 235 251; store p 236 252; store p 237 434; store p 238 243; store p 239 245; store p 240 267; store
p 241 268
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 6, 'c_q': 13, 'p': 242},
    {'f': 20, 'a': 400, 'b': 40, 'by_c': 260},
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
3; mul 710 711; add 709 712; input p 123; input z 4; mul 714 715; add 713 716; input p 124; input z 5; mul 718 719;
add 717 720; sub 698 721; input p 125; abs 0; mul 723 724; mul 0 725; input p 126; mul 0 727; mul 0 0; input p 127;
add 729 730; sqrt 731; div 2 732; mul 728 733; add 726 734; sub 722 735; add 697 736; input p 128; input x 12; sub
29 739; mul 738 740; input p 129; input x 13; sub 29 743; mul 742 744; add 741 745; sub 737 746; mul 0 62; mul 28
130; add 748 749; mul 47 395; add 750 751; mul 0 752; mul 0 28; mul 31 130; add 754 755; mul 34 395; add 756 757;
mul 130 758; add 753 759; mul 0 47; mul 34 130; add 761 762; mul 51 395; add 763 764; mul 395 765; add 760 766; mul
17 130; mul 130 768; mul 23 769; input p 130; mul 9 771; mul 9 772; mul 8 16; mul 10 774; mul 774 775; add 773 776;
mul 3 777; mul 38 778; sub 25 779; mul 770 780; add 767 781; mul 67 782; mul 24 778; add 39 784; mul 770 785; sub
783 786; mul 22 787; sub 747 788; mul 90 789; mul 81 89; mul 150 265; input p 131; mul 285 793; input p 132; mul 304
795; add 794 796; mul 324 331; add 797 798; input p 133; mul 328 800; add 799 801; input p 134; mul 332 803; add 802
804; input p 135; mul 336 806; add 805 807; mul 339 808; input p 136; mul 342 810; mul 345 352; add 811 812; input p
137; mul 349 814; add 813 815; input p 138; mul 353 817; add 816 818; input p 139; mul 357 820; add 819 821; mul 361
372; add 822 823; input p 140; mul 365 825; add 824 826; input p 141; mul 369 828; add 827 829; input p 142; mul 373
831; add 830 832; input p 143; mul 339 834; add 833 835; add 809 836; mul 576 837; add 792 838; mul 145 839; mul 579
690; sub 840 841; mul 150 405; add 842 843; mul 567 594; mul 679 687; add 845 846; add 844 847; sub 134 848; input p
144; mul 38 850; mul 17 851; add 849 852; input p 145; mul 721 854; sub 853 855; mul 41 782; mul 26 786; sub 857
858; mul 22 859; mul 19 778; mul 769 861; sub 860 862; sub 856 863; mul 791 864; sub 790 865; mul 86 89; input p
146; mul 35 868; input p 147; mul 214 870; add 869 871; input p 148; mul 218 873; add 872 874; mul 155 210; add 875
876; input p 149; mul 158 878; add 877 879; input p 150; mul 162 881; add 880 882; input p 151; mul 166 884; add 883
885; mul 170 227; add 886 887; input p 152; mul 174 889; add 888 890; mul 157 189; add 891 892; input p 153; mul 193
894; add 893 895; mul 169 197; add 896 897; input p 154; mul 201 899; add 898 900; mul 184 258; add 901 902; mul 202
257; add 903 904; mul 153 265; add 905 906; input p 155; mul 285 908; mul 304 331; add 909 910; input p 156; mul 324
912; add 911 913; input p 157; mul 328 915; add 914 916; input p 158; mul 332 918; add 917 919; input p 159; mul 336
921; add 920 922; mul 339 923; input p 160; mul 342 925; mul 345 814; add 926 927; mul 349 360; add 928 929; mul 353
368; add 930 931; input p 161; mul 357 933; add 932 934; input p 162; mul 361 936; add 935 937; input p 163; mul 365
939; add 938 940; mul 369 831; add 941 942; input p 164; mul 373 944; add 943 945; input p 165; mul 339 947; add 946
948; add 924 949; constant 3.0; mul 336 951; input p 166; mul 342 953; mul 345 793; add 954 955; mul 349 908; add
956 957; mul 327 353; add 958 959; mul 331 357; add 960 961; mul 335 361; add 962 963; input p 167; mul 365 965; add
964 966; mul 369 915; add 967 968; mul 373 806; add 969 970; input p 168; mul 339 972; add 971 973; mul 952 974; add
950 975; mul 585 976; add 907 977; mul 145 978; mul 588 690; sub 979 980; input p 169; mul 395 982; mul 153 405; add
983 984; add 981 985; mul 53 782; mul 22 987; add 986 988; mul 867 989; sub 866 990; mul 56 70; mul 79 79; sub 992
993; mul 89 994; mul 864 995; mul 789 791; sub 996 997; mul 59 70; mul 76 79; sub 999 1000; mul 89 1001; mul 989
1002; add 998 1003; mul 789 867; mul 864 1002; sub 1005 1006; mul 45 70; mul 76 76; sub 1008 1009; mul 89 1010; mul
989 1011; sub 1007 1012; mul 555 592; input p 170; mul 534 1015; sub 1014 1016; mul 667 685; mul 649 1015; sub 1018
1019; input p 171; mul 537 1021; sub 1014 1022; mul 652 1021; sub 1018 1024; input p 172; mul 541 1026; sub 1014
1027; mul 656 1026; sub 1018 1029; input p 173; mul 740 1031; input p 174; mul 744 1033; le 2 700; mul 130 854; add
0 1036; lt 140 1037; and 1035 1038; constant -1.0; le 700 1040; lt 1037 140; and 1041 1042; or 1039 1043; not 1044;
input p 175; mul 1037 1046; where 1045 1047; le 2 703; and 1038 1049; le 703 1040; and 1042 1051; or 1050 1052; not
1053; input p 176; mul 1037 1055; where 1054 1056; le 2 707; and 1038 1058; le 707 1040; and 1042 1060; or 1059
1061; not 1062; input p 177; mul 1037 1064; where 1063 1065; le 2 711; and 1038 1067; le 711 1040; and 1042 1069; or
1068 1070; not 1071; input p 178; mul 1037 1073; where 1072 1074; le 2 715; and 1038 1076; le 715 1040; and 1042
1078; or 1077 1079; not 1080; input p 179; mul 1037 1082; where 1081 1083; le 2 719; and 1038 1085; le 719 1040; and
1042 1087; or 1086 1088; not 1089; input p 180; mul 1037 1091; where 1090 1092; mul 41 503; mul 28 1094; mul 22
1095; mul 56 1096; mul 53 503; mul 47 1098; mul 22 1099; mul 45 1100; add 1097 1101; mul 28 53; mul 41 47; add 1103
1104; mul 22 1105; mul 59 1106; add 1107 1107; sub 1102 1108; mul 89 1109; mul 89 90; mul 67 503; mul 62 1112; mul
22 1113; mul 61 1114; mul 70 1109; add 1115 1116; mul 41 62; mul 28 67; add 1118 1119; mul 22 1120; mul 81 1121; mul
56 1121; mul 76 1100; add 1123 1124; mul 79 1106; mul 47 67; mul 53 62; add 1127 1128; mul 22 1129; mul 59 1130; add
1126 1131; sub 1125 1132; mul 76 1133; add 1122 1134; sub 1117 1135; mul 86 1130; mul 59 1121; mul 76 1106; add 1138
1139; mul 79 1096; mul 45 1130; add 1141 1142; sub 1140 1143; mul 79 1144; add 1137 1145; add 1136 1146; mul 1111
1147; sub 1110 1148; mul 789 1149; mul 100 106; mul 102 1151; mul 100 114; sub 1152 1153; mul 100 118; mul 100 1155;
sub 1154 1156; input p 181; input p 182; mul 35 1159; mul 157 1160; add 1158 1161; mul 35 1160; mul 161 1163; add
1162 1164; mul 155 503; mul 1159 1166; mul 165 1167; add 1165 1168; mul 35 1167; mul 169 1170; add 1169 1171; mul
155 1167; mul 166 1159; add 1173 1174; mul 173 1175; add 1172 1176; input p 183; add 1177 1178; mul 35 144; mul 180
1180; add 1179 1181; mul 35 1180; mul 184 1183; add 1182 1184; mul 144 155; mul 148 1159; add 1186 1187; mul 188
1188; add 1185 1189; mul 35 1188; mul 192 1191; add 1190 1192; mul 155 1188; mul 189 1159; add 1194 1195; mul 196
1196; add 1193 1197; mul 148 503; mul 144 1199; mul 155 1200; mul 201 1159; add 1201 1202; mul 200 1203; add 1198
1204; mul 148 1200; mul 144 201; add 1206 1207; mul 205 1208; add 1205 1209; input p 184; mul 224 1160; add 1211
1212; mul 227 1163; add 1213 1214; mul 230 1167; add 1215 1216; mul 233 1170; add 1217 1218; mul 236 1175; add 1219
1220; input p 185; add 1221 1222; mul 157 1180; add 1223 1224; mul 161 1183; add 1225 1226; mul 245 1188; add 1227
1228; mul 248 1191; add 1229 1230; mul 251 1196; add 1231 1232; mul 254 1200; add 1233 1234; mul 35 1200; mul 257
1236; add 1235 1237; mul 196 1203; add 1238 1239; mul 263 1208; add 1240 1241; mul 147 1242; add 1210 1243; mul 284
503; le 271 269; le 269 271; add 1246 1247; div 2 1248; mul 1246 1249; le 270 148; le 148 270; add 1251 1252; div 2
1253; mul 1251 1254; mul 144 1255; mul 1250 1256; constant 2.857142857142857; mul 275 503; le 140 274; le 274 140;
add 1260 1261; div 2 1262; mul 1260 1263; mul 1257 1264; mul 1259 1265; mul 279 503; le 140 278; le 278 140; add
1268 1269; div 2 1270; mul 1268 1271; mul 1257 1272; mul 1267 1273; add 1266 1274; mul 1258 1275; sub 1257 1276; mul
1245 1277; mul 268 1278; mul 303 1277; mul 287 1280; add 1279 1281; mul 323 1277; mul 307 1283; add 1282 1284; mul
339 1285; mul 284 1278; mul 285 1277; add 1287 1288; mul 341 1289; mul 303 1278; mul 344 1291; add 1290 1292; mul
323 1278; mul 348 1294; add 1293 1295; mul 303 1280; mul 352 1297; add 1296 1298; mul 323 1280; mul 356 1300; add
1299 1301; mul 323 1283; mul 360 1303; add 1302 1304; add 1286 1305; mul 383 1306; sub 1265 1273; mul 380 1308; mul
379 1309; sub 1307 1310; add 1244 1311; mul 145 1312; mul 144 1313; mul 410 1289; mul 412 1291; add 1315 1316; mul
415 1294; add 1317 1318; mul 418 1297; add 1319 1320; mul 421 1300; add 1321 1322; mul 383 1323; mul 429 1309; sub
1324 1325; add 62 1326; mul 690 1327; mul 484 503; add 63 67; add 64 1330; add 66 1331; mul 104 1332; mul 429 1277;
mul 284 1323; add 1334 1335; mul 443 1289; mul 418 1291; add 1337 1338; mul 447 1294; add 1339 1340; mul 450 1297;
add 1341 1342; mul 453 1300; add 1343 1344; mul 303 1345; add 1336 1346; mul 464 1289; mul 447 1291; add 1348 1349;
mul 427 1297; add 1350 1351; mul 323 1352; add 1347 1353; mul 441 1354; mul 440 1355; add 1333 1356; mul 1329 1357;
mul 491 503; sub 1358 1359; mul 495 503; div 2 1361; mul 1360 1362; mul 485 1363; mul 503 1364; mul 498 503; mul 497
503; div 2 1367; mul 1364 1368; mul 499 1369; mul 1366 1370; neg 1371; mul 503 1372; mul 499 1373; mul 505 1371; sub
1374 1375; sub 1365 1376; mul 502 1377; mul 520 1378; le 513 509; le 509 513; add 1380 1381; div 2 1382; mul 1380
1383; le 510 512; le 512 510; add 1385 1386; div 2 1387; mul 1385 1388; mul 1364 1389; mul 1384 1390; mul 516 1391;
mul 514 1392; mul 518 1391; add 1393 1394; mul 508 1395; add 1379 1396; mul 525 1364; mul 512 1398; mul 527 1364;
add 1399 1400; mul 523 1401; sub 1397 1402; mul 485 1403; mul 550 1364; mul 512 1405; mul 552 1364; add 1406 1407;
mul 548 1408; mul 546 1369; mul 498 1410; mul 547 1369; add 1411 1412; mul 498 1413; mul 498 547; mul 1369 1415; add
1414 1416; mul 485 1417; mul 554 1418; sub 1409 1419; mul 543 1420; add 1404 1421; mul 558 1420; mul 555 1423; mul
559 1420; add 1424 1425; mul 592 1426; mul 485 1371; mul 491 1428; add 500 1429; mul 0 1430; mul 563 1357; add 561
1432; mul 500 1433; mul 565 1428; add 1434 1435; mul 17 1436; mul 130 1437; sub 1431 1438; mul 500 1357; mul 484
1428; sub 1440 1441; mul 590 1442; mul 0 1327; mul 576 1345; mul 440 1445; add 28 1446; mul 130 1447; add 1444 1448;
mul 585 1352; mul 440 1450; add 47 1451; mul 395 1452; add 1449 1453; mul 501 1454; add 1443 1455; add 1439 1456;
mul 560 1457; add 1427 1458; add 1422 1459; mul 501 1460; mul 594 1442; add 1461 1462; mul 503 603; mul 1357 1464;
mul 503 610; sub 1465 1466; mul 503 614; div 2 1468; mul 1467 1469; mul 604 1470; mul 503 1471; mul 503 617; mul 503
616; div 2 1474; mul 1471 1475; mul 618 1476; mul 1473 1477; neg 1478; mul 503 1479; mul 618 1480; mul 623 1478; sub
1481 1482; sub 1472 1483; mul 621 1484; mul 635 1485; le 628 509; le 509 628; add 1487 1488; div 2 1489; mul 1487
1490; le 510 627; le 627 510; add 1492 1493; div 2 1494; mul 1492 1495; mul 1471 1496; mul 1491 1497; mul 631 1498;
mul 629 1499; mul 633 1498; add 1500 1501; mul 626 1502; add 1486 1503; mul 640 1471; mul 627 1505; mul 642 1471;
add 1506 1507; mul 638 1508; sub 1504 1509; mul 604 1510; mul 550 1471; mul 627 1512; mul 664 1471; add 1513 1514;
mul 662 1515; mul 660 1476; mul 617 1517; mul 661 1476; add 1518 1519; mul 617 1520; mul 617 661; mul 1476 1522; add
1521 1523; mul 604 1524; mul 666 1525; sub 1516 1526; mul 658 1527; add 1511 1528; mul 670 1527; mul 667 1530; mul
671 1527; add 1531 1532; mul 685 1533; mul 675 1357; sub 1535 673; mul 619 1536; mul 604 1478; mul 677 1538; sub
1537 1539; mul 17 1540; mul 130 1541; mul 610 1538; add 619 1543; mul 0 1544; add 1542 1545; mul 619 1357; mul 603
1538; sub 1547 1548; mul 590 1549; mul 620 1454; add 1550 1551; add 1546 1552; mul 672 1553; add 1534 1554; add 1529
1555; mul 620 1556; mul 687 1549; add 1557 1558; add 1463 1559; mul 431 1560; sub 1328 1561; sub 1314 1562; mul 569
1460; mul 594 1430; sub 1564 1565; mul 681 1556; mul 687 1544; sub 1567 1568; add 1566 1569; sub 1563 1570; sub 1157
1571; input p 186; sub 1572 1573; mul 62 782; mul 22 1575; sub 1574 1576; mul 90 1577; add 1150 1578; mul 89 1133;
mul 89 791; mul 1147 1581; sub 1580 1582; mul 864 1583; mul 150 1242; mul 793 1278; mul 795 1280; add 1586 1587; mul
331 1283; add 1588 1589; mul 339 1590; mul 810 1289; mul 352 1291; add 1592 1593; mul 814 1294; add 1594 1595; mul
817 1297; add 1596 1597; mul 820 1300; add 1598 1599; mul 372 1303; add 1600 1601; add 1591 1602; mul 576 1603; add
1585 1604; mul 145 1605; mul 690 1447; mul 579 1560; sub 1607 1608; sub 1606 1609; mul 567 1460; mul 594 1437; sub
1611 1612; mul 679 1556; mul 687 1541; add 1614 1615; add 1613 1616; add 1610 1617; sub 1155 1618; mul 28 782; mul
22 1620; sub 1619 1621; mul 791 1622; add 1584 1623; sub 1579 1624; mul 89 1144; mul 89 867; mul 1147 1627; sub 1626
1628; mul 989 1629; input p 187; mul 878 1160; add 1631 1632; mul 881 1163; add 1633 1634; mul 884 1167; add 1635
1636; mul 227 1170; add 1637 1638; mul 889 1175; add 1639 1640; mul 157 1188; add 1641 1642; mul 894 1191; add 1643
1644; mul 169 1196; add 1645 1646; mul 899 1200; add 1647 1648; mul 184 1236; add 1649 1650; mul 257 1203; add 1651
1652; mul 153 1242; add 1653 1654; mul 908 1278; mul 331 1280; add 1656 1657; mul 912 1283; add 1658 1659; mul 339
1660; mul 925 1289; mul 814 1291; add 1662 1663; mul 360 1294; add 1664 1665; mul 368 1297; add 1666 1667; mul 933
1300; add 1668 1669; mul 936 1303; add 1670 1671; add 1661 1672; mul 953 1289; mul 793 1291; add 1674 1675; mul 908
1294; add 1676 1677; mul 327 1297; add 1678 1679; mul 331 1300; add 1680 1681; mul 335 1303; add 1682 1683; mul 952
1684; add 1673 1685; mul 585 1686; add 1655 1687; mul 145 1688; mul 690 1452; mul 588 1560; sub 1690 1691; sub 1689
1692; mul 47 782; mul 22 1694; add 1693 1695; mul 867 1696; add 1630 1697; sub 1625 1698; input c_q 0; mul 90 1700;
le 140 139; le 139 140; add 1702 1703; div 2 1704; mul 1702 1705; mul 0 90; mul 1706 1707; input c_q 1; mul 1708
1709; sub 1701 1710; mul 90 93; input c_q 2; mul 1712 1713; add 1711 1714; mul 90 97; input c_q 3; mul 1716 1717;
add 1715 1718; mul 90 100; add 791 1720; input c_q 4; mul 1721 1722; sub 1719 1723; mul 102 1721; input c_q 5; mul
1725 1726; add 1724 1727; mul 93 1721; input c_q 6; mul 1729 1730; sub 1728 1731; mul 97 1721; input c_q 7; mul 1733
1734; sub 1732 1735; le 128 127; le 127 128; add 1737 1738; div 2 1739; mul 1737 1740; mul 132 1721; mul 1741 1742;
input c_q 8; mul 1743 1744; add 1736 1745; mul 90 102; input c_q 9; mul 1747 1748; add 1746 1749; mul 102 1747; mul
104 1751; input c_q 10; mul 1752 1753; sub 1750 1754; mul 93 1747; input c_q 11; mul 1756 1757; add 1755 1758; mul
97 1747; input c_q 12; mul 1760 1761; add 1759 1762; add 1699 1763; mul 56 1114; mul 70 1100; add 1765 1766; mul 79
1130; add 1768 1768; sub 1767 1769; mul 89 1770; mul 89 995; mul 1147 1772; sub 1771 1773; mul 864 1774; mul 995
1622; add 1775 1776; mul 789 1583; mul 791 1577; add 1778 1779; sub 1777 1780; mul 59 1114; mul 70 1106; add 1782
1783; mul 76 1130; mul 79 1121; add 1785 1786; sub 1784 1787; mul 89 1788; mul 89 1002; mul 1147 1790; sub 1789
1791; mul 989 1792; mul 1002 1696; add 1793 1794; add 1781 1795; mul 0 791; mul 1706 1797; mul 1709 1798; mul 791
1700; sub 1799 1800; mul 93 791; mul 1713 1802; sub 1801 1803; mul 97 791; mul 1717 1805; sub 1804 1806; mul 100
791; add 995 1808; mul 1722 1809; add 1807 1810; mul 102 1809; mul 1726 1812; sub 1811 1813; mul 93 1809; mul 1730
1815; add 1814 1816; mul 97 1809; mul 1734 1818; add 1817 1819; mul 132 1809; mul 1741 1821; mul 1744 1822; sub 1820
1823; mul 102 791; mul 1748 1825; sub 1824 1826; mul 102 1825; mul 104 1828; mul 1753 1829; add 1827 1830; mul 93
1825; mul 1757 1832; sub 1831 1833; mul 97 1825; mul 1761 1835; sub 1834 1836; add 1796 1837; mul 789 1629; mul 867
1577; add 1839 1840; mul 864 1792; mul 1002 1622; add 1842 1843; sub 1841 1844; mul 45 1114; mul 70 1096; add 1846
1847; mul 76 1121; add 1849 1849; sub 1848 1850; mul 89 1851; mul 89 1011; mul 1147 1853; sub 1852 1854; mul 989
1855; mul 1011 1696; add 1856 1857; sub 1845 1858; mul 867 1700; mul 0 867; mul 1706 1861; mul 1709 1862; sub 1860
1863; mul 93 867; mul 1713 1865; add 1864 1866; mul 97 867; mul 1717 1868; add 1867 1869; mul 100 867; add 1002
1871; mul 1722 1872; sub 1870 1873; mul 102 1872; mul 1726 1875; add 1874 1876; mul 93 1872; mul 1730 1878; sub 1877
1879; mul 97 1872; mul 1734 1881; sub 1880 1882; mul 132 1872; mul 1741 1884; mul 1744 1885; add 1883 1886; mul 102
867; mul 1748 1888; add 1887 1889; mul 102 1888; mul 104 1891; mul 1753 1892; sub 1890 1893; mul 93 1888; mul 1757
1895; add 1894 1896; mul 97 1888; mul 1761 1898; add 1897 1899; add 1859 1900; mul 592 1420; mul 555 1457; add 1902
1903; mul 685 1527; mul 667 1553; add 1905 1906; mul 100 129; mul 100 1908; add 141 1909; input p 188; mul 431 501;
sub 1912 569; mul 560 1913; mul 501 1914; mul 431 620; sub 1916 681; mul 672 1917; mul 620 1918; add 1915 1919; mul
431 1920; add 1911 1921; mul 569 1914; mul 681 1918; add 1923 1924; sub 1922 1925; add 1910 1926; sign 0; mul 723
1928; mul 0 1929; add 725 1930; mul 727 733; mul 733 734; mul 0 733; mul 1933 1934; sub 1932 1935; add 1931 1936;
add 1927 1937; add 748 752; add 749 1939; add 751 1940; mul 67 1941; mul 22 1942; add 1938 1943; mul 90 1944; mul
579 1920; input p 189; add 1946 1947; mul 567 1914; mul 679 1918; add 1949 1950; add 1948 1951; sub 1908 1952; mul
41 1941; mul 22 1954; sub 1953 1955; mul 791 1956; add 1945 1957; mul 588 1920; input p 190; add 1959 1960; mul 53
1941; mul 22 1962; add 1961 1963; mul 867 1964; add 1958 1965; neg 1966; mul 995 1956; mul 791 1944; add 1968 1969;
mul 1002 1964; add 1970 1971; mul 867 1944; mul 1002 1956; add 1973 1974; mul 1011 1964; add 1975 1976; neg 1977;
mul 555 1913; mul 667 1917; where 1045 1046; where 1054 1055; where 1063 1064; where 1072 1073; where 1081 1082;
where 1090 1091; mul 26 503; div 2 14; mul 11 1988; mul 9 1989; mul 9 24; mul 5 9; mul 1991 1992; sub 1990 1993; mul
17 1994; mul 9 9; mul 1992 1996; mul 16 1997; mul 16 17; mul 14 1992; mul 8 1989; add 2000 2001; mul 1999 2002; add
1998 2003; mul 24 2004; sub 1995 2005; mul 23 2006; mul 1987 2007; mul 9 38; mul 1992 2009; sub 9 2010; mul 17 2011;
mul 38 2004; sub 2012 2013; mul 23 2014; add 31 2015; mul 1094 2016; add 2008 2017; mul 22 2018; mul 18 2004; mul 17
2020; mul 19 2004; add 2021 2022; sub 2019 2023; mul 56 2024; mul 34 1098; mul 22 2026; mul 45 2027; add 2025 2028;
mul 53 2016; mul 34 41; add 2030 2031; mul 22 2032; mul 59 2033; add 2034 2034; sub 2029 2035; mul 89 2036; mul 28
1112; mul 22 2038; mul 61 2039; mul 70 2036; add 2040 2041; mul 28 41; mul 67 2016; add 2043 2044; add 2007 2045;
mul 22 2046; mul 81 2047; mul 56 2047; mul 76 2027; add 2049 2050; mul 79 2033; mul 34 67; add 1103 2053; mul 22
2054; mul 59 2055; add 2052 2056; sub 2051 2057; mul 76 2058; add 2048 2059; sub 2042 2060; mul 86 2055; mul 59
2047; mul 76 2033; add 2063 2064; mul 79 2024; mul 45 2055; add 2066 2067; sub 2065 2068; mul 79 2069; add 2062
2070; add 2061 2071; mul 1111 2072; sub 2037 2073; mul 789 2074; sub 114 107; add 1155 2076; input p 191; mul 35
150; mul 157 2079; add 2078 2080; mul 35 2079; mul 161 2082; add 2081 2083; mul 150 1166; mul 165 2085; add 2084
2086; mul 35 2085; mul 169 2088; add 2087 2089; mul 155 2085; mul 150 166; add 2091 2092; mul 173 2093; add 2090
2094; mul 148 150; mul 188 2096; add 2095 2097; mul 35 2096; mul 192 2099; add 2098 2100; mul 155 2096; mul 150 189;
add 2102 2103; mul 196 2104; add 2101 2105; mul 150 201; mul 200 2107; add 2106 2108; input p 192; mul 224 2079; add
2110 2111; mul 227 2082; add 2112 2113; mul 230 2085; add 2114 2115; mul 233 2088; add 2116 2117; mul 236 2093; add
2118 2119; mul 245 2096; add 2120 2121; mul 248 2099; add 2122 2123; mul 251 2104; add 2124 2125; mul 196 2107; add
2126 2127; mul 147 2128; add 2109 2129; le 290 288; le 288 290; add 2131 2132; div 2 2133; mul 2131 2134; le 289 3;
le 3 289; add 2136 2137; div 2 2138; mul 2136 2139; mul 2135 2140; constant 1.6666666666666667; mul 294 503; le 140
293; le 293 140; add 2144 2145; div 2 2146; mul 2144 2147; mul 2141 2148; mul 2143 2149; mul 298 503; le 140 297; le
297 140; add 2152 2153; div 2 2154; mul 2152 2155; mul 2141 2156; mul 2151 2157; add 2150 2158; mul 2142 2159; sub
2141 2160; mul 284 2161; mul 287 2162; mul 303 503; mul 2161 2164; mul 327 2165; add 2163 2166; mul 323 2161; mul
331 2168; add 2167 2169; mul 339 2170; mul 285 2161; mul 344 2172; mul 303 2162; mul 304 2161; add 2174 2175; mul
352 2176; add 2173 2177; mul 323 2162; mul 356 2179; add 2178 2180; mul 303 2165; mul 328 2161; add 2182 2183; mul
364 2184; add 2181 2185; mul 323 2165; mul 368 2187; add 2186 2188; mul 323 2168; mul 372 2190; add 2189 2191; add
2171 2192; mul 383 2193; add 2130 2194; mul 145 2195; mul 144 2196; mul 412 2172; mul 418 2176; add 2198 2199; mul
421 2179; add 2200 2201; mul 424 2184; add 2202 2203; mul 427 2187; add 2204 2205; mul 383 2206; add 28 2207; mul
690 2208; mul 482 1994; mul 479 2011; add 2210 2211; mul 1359 2212; add 32 37; add 30 2214; add 36 2215; mul 104
2216; mul 284 2206; mul 461 2161; mul 418 2172; mul 450 2176; add 2220 2221; mul 453 2179; add 2222 2223; mul 456
2184; add 2224 2225; mul 459 2187; add 2226 2227; mul 303 2228; add 2219 2229; add 2218 2230; mul 447 2172; mul 427
2176; add 2232 2233; mul 470 2184; add 2234 2235; mul 323 2236; add 2231 2237; mul 441 2238; mul 440 2239; add 2217
2240; mul 479 1994; add 2241 2242; mul 482 2011; sub 2243 2244; mul 1329 2245; add 2213 2246; mul 1362 2247; mul 485
2248; mul 503 2249; mul 1368 2249; mul 499 2251; mul 1366 2252; neg 2253; mul 503 2254; mul 499 2255; mul 505 2253;
sub 2256 2257; sub 2250 2258; mul 502 2259; mul 520 2260; mul 1389 2249; mul 1384 2262; mul 516 2263; mul 514 2264;
mul 518 2263; add 2265 2266; mul 508 2267; add 2261 2268; mul 525 2249; mul 512 2270; mul 527 2249; add 2271 2272;
mul 523 2273; sub 2269 2274; mul 485 2275; mul 550 2249; mul 512 2277; mul 552 2249; add 2278 2279; mul 548 2280;
mul 546 2251; mul 498 2282; mul 547 2251; add 2283 2284; mul 498 2285; mul 1415 2251; add 2286 2287; mul 485 2288;
mul 554 2289; sub 2281 2290; mul 543 2291; add 2276 2292; mul 558 2291; mul 555 2294; mul 559 2291; add 2295 2296;
mul 592 2297; mul 561 2212; sub 2242 2244; mul 491 2300; add 2299 2301; mul 563 2245; mul 484 2212; add 2303 2304;
sub 2302 2305; mul 500 2306; mul 485 2253; mul 565 2308; sub 2307 2309; mul 17 2310; mul 566 2004; sub 2311 2312;
mul 130 2313; mul 500 2212; mul 491 2308; sub 2315 2316; mul 0 2317; sub 2314 2318; mul 500 2245; mul 484 2308; sub
2320 2321; mul 590 2322; mul 0 2208; mul 576 2228; sub 2149 2157; mul 573 2326; mul 461 2327; sub 2325 2328; mul 440
2329; add 31 2330; mul 130 2331; add 2324 2332; mul 585 2236; mul 440 2334; add 34 2335; mul 395 2336; add 2333
2337; mul 501 2338; add 2323 2339; add 2319 2340; mul 560 2341; add 2298 2342; add 2293 2343; mul 501 2344; mul 594
2322; add 2345 2346; mul 598 2011; mul 601 1994; sub 2348 2349; mul 1466 2350; mul 598 1994; add 2241 2352; mul 601
2011; add 2353 2354; mul 1464 2355; add 2351 2356; mul 1469 2357; mul 604 2358; mul 503 2359; mul 1475 2359; mul 618
2361; mul 1473 2362; neg 2363; mul 503 2364; mul 618 2365; mul 623 2363; sub 2366 2367; sub 2360 2368; mul 621 2369;
mul 635 2370; mul 1496 2359; mul 1491 2372; mul 631 2373; mul 629 2374; mul 633 2373; add 2375 2376; mul 626 2377;
add 2371 2378; mul 640 2359; mul 627 2380; mul 642 2359; add 2381 2382; mul 638 2383; sub 2379 2384; mul 604 2385;
mul 550 2359; mul 627 2387; mul 664 2359; add 2388 2389; mul 662 2390; mul 660 2361; mul 617 2392; mul 661 2361; add
2393 2394; mul 617 2395; mul 1522 2361; add 2396 2397; mul 604 2398; mul 666 2399; sub 2391 2400; mul 658 2401; add
2386 2402; mul 670 2401; mul 667 2404; mul 671 2401; add 2405 2406; mul 685 2407; mul 673 2350; add 2352 2354; mul
610 2410; add 2409 2411; mul 675 2355; sub 2349 2348; mul 603 2414; add 2413 2415; add 2412 2416; mul 619 2417; mul
604 2363; mul 677 2419; sub 2418 2420; mul 17 2421; mul 678 2004; sub 2422 2423; mul 130 2424; mul 619 2350; mul 610
2419; sub 2426 2427; mul 0 2428; sub 2425 2429; mul 619 2355; mul 603 2419; sub 2431 2432; mul 590 2433; mul 620
2338; add 2434 2435; add 2430 2436; mul 672 2437; add 2408 2438; add 2403 2439; mul 620 2440; mul 687 2433; add 2441
2442; add 2347 2443; mul 431 2444; sub 2209 2445; sub 2197 2446; mul 569 2344; mul 594 2317; add 2448 2449; mul 681
2440; mul 687 2428; add 2451 2452; add 2450 2453; sub 2447 2454; sub 2077 2455; mul 778 2011; mul 16 1992; mul 16
774; mul 2002 2459; sub 2458 2460; mul 10 2461; mul 774 2462; mul 775 2461; add 2463 2464; mul 773 1992; mul 9 2466;
mul 9 773; mul 1992 2468; add 2467 2469; sub 2465 2470; mul 3 2471; add 777 2472; mul 38 2473; add 2457 2474; sub
2006 2475; mul 770 2476; mul 130 2004; mul 130 2478; mul 23 2479; mul 780 2480; sub 2477 2481; mul 67 2482; add 1620
2483; mul 778 1994; mul 24 2473; add 2485 2486; add 2014 2487; mul 770 2488; mul 785 2480; sub 2489 2490; sub 2484
2491; mul 22 2492; sub 2456 2493; mul 90 2494; add 2075 2495; mul 89 2058; mul 1581 2072; sub 2497 2498; mul 864
2499; mul 850 2011; mul 17 2501; mul 851 2004; sub 2502 2503; mul 150 2128; mul 795 2162; mul 800 2165; add 2506
2507; mul 803 2168; add 2508 2509; mul 339 2510; mul 352 2172; mul 817 2176; add 2512 2513; mul 820 2179; add 2514
2515; mul 825 2184; add 2516 2517; mul 828 2187; add 2518 2519; mul 831 2190; add 2520 2521; add 2511 2522; mul 576
2523; mul 837 2327; sub 2524 2525; add 2505 2526; mul 145 2527; mul 690 2331; mul 579 2444; sub 2529 2530; sub 2528
2531; mul 567 2344; mul 594 2313; add 2533 2534; mul 679 2440; mul 687 2424; add 2536 2537; add 2535 2538; add 2532
2539; add 118 2540; sub 2504 2541; mul 782 2016; mul 41 2482; add 2543 2544; mul 786 2007; mul 26 2491; add 2546
2547; sub 2545 2548; mul 22 2549; mul 19 2473; mul 778 2020; sub 2551 2552; mul 769 2553; mul 861 2479; sub 2554
2555; sub 2550 2556; sub 2542 2557; mul 791 2558; add 2500 2559; sub 2496 2560; mul 89 2069; mul 1627 2072; sub 2562
2563; mul 989 2564; input p 193; mul 878 2079; add 2566 2567; mul 881 2082; add 2568 2569; mul 884 2085; add 2570
2571; mul 227 2088; add 2572 2573; mul 889 2093; add 2574 2575; mul 157 2096; add 2576 2577; mul 894 2099; add 2578
2579; mul 169 2104; add 2580 2581; mul 257 2107; add 2582 2583; mul 153 2128; add 2584 2585; mul 331 2162; mul 915
2165; add 2587 2588; mul 918 2168; add 2589 2590; mul 339 2591; mul 814 2172; mul 368 2176; add 2593 2594; mul 933
2179; add 2595 2596; mul 939 2184; add 2597 2598; mul 831 2187; add 2599 2600; mul 944 2190; add 2601 2602; add 2592
2603; mul 793 2172; mul 327 2176; add 2605 2606; mul 331 2179; add 2607 2608; mul 965 2184; add 2609 2610; mul 915
2187; add 2611 2612; mul 806 2190; add 2613 2614; mul 952 2615; add 2604 2616; mul 585 2617; add 2586 2618; mul 145
2619; mul 690 2336; mul 588 2444; sub 2621 2622; sub 2620 2623; mul 34 782; mul 53 2482; add 2625 2626; mul 22 2627;
add 2624 2628; mul 867 2629; add 2565 2630; sub 2561 2631; mul 56 2039; mul 70 2027; add 2633 2634; mul 79 2055; add
2636 2636; sub 2635 2637; mul 89 2638; mul 1772 2072; sub 2639 2640; mul 864 2641; mul 995 2558; add 2642 2643; mul
789 2499; mul 791 2494; add 2645 2646; sub 2644 2647; mul 59 2039; mul 70 2033; add 2649 2650; mul 76 2055; mul 79
2047; add 2652 2653; sub 2651 2654; mul 89 2655; mul 1790 2072; sub 2656 2657; mul 989 2658; mul 1002 2629; add 2659
2660; add 2648 2661; mul 789 2564; mul 867 2494; add 2663 2664; mul 864 2658; mul 1002 2558; add 2666 2667; sub 2665
2668; mul 45 2039; mul 70 2024; add 2670 2671; mul 76 2047; add 2673 2673; sub 2672 2674; mul 89 2675; mul 1853
2072; sub 2676 2677; mul 989 2678; mul 1011 2629; add 2679 2680; sub 2669 2681; mul 592 2291; mul 555 2341; add 2683
2684; mul 685 2401; mul 667 2437; add 2686 2687; input p 194; mul 501 579; add 567 2690; mul 560 2691; mul 501 2692;
mul 579 620; add 679 2694; mul 672 2695; mul 620 2696; add 2693 2697; mul 431 2698; add 2689 2699; mul 569 2692; mul
681 2696; add 2701 2702; sub 2700 2703; sub 1908 2704; add 755 758; add 754 2706; add 757 2707; mul 503 768; mul 23
2709; mul 780 2710; add 2708 2711; mul 67 2712; mul 785 2710; sub 2713 2714; mul 22 2715; sub 2705 2716; mul 90
2717; mul 579 2698; input p 195; add 2719 2720; mul 567 2692; mul 679 2696; add 2722 2723; add 2721 2724; add 129
2725; mul 41 2712; mul 26 2714; sub 2727 2728; mul 22 2729; mul 861 2709; sub 2730 2731; add 2726 2732; mul 791
2733; add 2718 2734; mul 588 2698; input p 196; add 2736 2737; mul 53 2712; mul 22 2739; add 2738 2740; mul 867
2741; sub 2735 2742; mul 1002 2741; mul 995 2733; mul 791 2717; add 2745 2746; sub 2744 2747; mul 867 2717; mul 1002
2733; add 2749 2750; mul 1011 2741; sub 2751 2752; mul 555 2691; mul 667 2695; input p 197; where 1045 2756; input p
198; where 1054 2758; input p 199; where 1063 2760; input p 200; where 1072 2762; input p 201; where 1081 2764;
input p 202; where 1090 2766; mul 34 1094; mul 22 2768; mul 56 2769; mul 51 1098; mul 22 2771; mul 45 2772; add 2770
2773; mul 34 53; mul 41 51; add 2775 2776; mul 22 2777; mul 59 2778; add 2779 2779; sub 2774 2780; mul 89 2781; mul
47 1112; mul 22 2783; mul 61 2784; mul 70 2781; add 2785 2786; add 1104 2053; mul 22 2788; mul 81 2789; mul 56 2789;
mul 76 2772; add 2791 2792; mul 79 2778; mul 51 67; mul 47 53; add 2795 2796; mul 22 2797; mul 59 2798; add 2794
2799; sub 2793 2800; mul 76 2801; add 2790 2802; sub 2787 2803; mul 86 2798; mul 59 2789; mul 76 2778; add 2806
2807; mul 79 2769; mul 45 2798; add 2809 2810; sub 2808 2811; mul 79 2812; add 2805 2813; add 2804 2814; mul 1111
2815; sub 2782 2816; mul 789 2817; input p 203; add 154 155; mul 157 2820; add 2819 2821; mul 35 2820; add 158 2823;
mul 161 2824; add 2822 2825; mul 153 1166; mul 165 2827; add 2826 2828; mul 35 2827; add 166 2830; mul 169 2831; add
2829 2832; mul 155 2827; mul 153 166; add 2834 2835; mul 173 2836; add 2833 2837; mul 148 180; add 2838 2839; mul
181 503; mul 184 2841; add 2840 2842; mul 148 153; mul 188 2844; add 2843 2845; mul 35 2844; add 189 2847; mul 192
2848; add 2846 2849; mul 155 2844; mul 153 189; add 2851 2852; mul 196 2853; add 2850 2854; mul 153 201; mul 200
2856; add 2855 2857; mul 35 503; mul 213 2859; add 210 2860; mul 35 2859; add 214 2862; mul 217 2863; add 2861 2864;
input p 204; add 2865 2866; mul 224 2820; add 2867 2868; mul 227 2824; add 2869 2870; mul 230 2827; add 2871 2872;
mul 233 2831; add 2873 2874; mul 236 2836; add 2875 2876; mul 148 157; add 2877 2878; mul 161 2841; add 2879 2880;
mul 245 2844; add 2881 2882; mul 248 2848; add 2883 2884; mul 251 2853; add 2885 2886; mul 201 257; add 2887 2888;
mul 196 2856; add 2889 2890; mul 147 2891; add 2858 2892; le 310 308; le 308 310; add 2894 2895; div 2 2896; mul
2894 2897; le 309 35; le 35 309; add 2899 2900; div 2 2901; mul 2899 2902; mul 2898 2903; constant 0.625; mul 314
503; le 140 313; le 313 140; add 2907 2908; div 2 2909; mul 2907 2910; mul 2904 2911; mul 2906 2912; mul 318 503; le
140 317; le 317 140; add 2915 2916; div 2 2917; mul 2915 2918; mul 2904 2919; mul 2914 2920; add 2913 2921; mul 2905
2922; sub 2904 2923; mul 284 2924; mul 307 2925; mul 303 2924; mul 331 2927; add 2926 2928; mul 323 503; mul 2924
2930; mul 335 2931; add 2929 2932; mul 339 2933; mul 323 2931; mul 336 2924; add 2935 2936; mul 338 2937; add 2934
2938; mul 285 2924; mul 348 2940; mul 304 2924; mul 356 2942; add 2941 2943; mul 323 2925; mul 324 2924; add 2945
2946; mul 360 2947; add 2944 2948; mul 328 2924; mul 368 2950; add 2949 2951; mul 323 2927; mul 332 2924; add 2953
2954; mul 372 2955; add 2952 2956; mul 376 2937; add 2957 2958; add 2939 2959; mul 383 2960; add 2893 2961; mul 145
2962; mul 144 2963; mul 415 2940; mul 421 2942; add 2965 2966; mul 427 2950; add 2967 2968; mul 383 2969; add 47
2970; mul 690 2971; add 52 53; add 50 2973; mul 104 2974; mul 284 2969; mul 447 2940; mul 453 2942; add 2977 2978;
mul 459 2950; add 2979 2980; mul 303 2981; add 2976 2982; mul 472 2924; add 2983 2984; mul 441 2985; mul 440 2986;
add 2975 2987; mul 1329 2988; mul 1362 2989; mul 485 2990; mul 503 2991; mul 1368 2991; mul 499 2993; mul 1366 2994;
neg 2995; mul 503 2996; mul 499 2997; mul 505 2995; sub 2998 2999; sub 2992 3000; mul 502 3001; mul 520 3002; mul
1389 2991; mul 1384 3004; mul 516 3005; mul 514 3006; mul 518 3005; add 3007 3008; mul 508 3009; add 3003 3010; mul
525 2991; mul 512 3012; mul 527 2991; add 3013 3014; mul 523 3015; sub 3011 3016; mul 485 3017; mul 550 2991; mul
512 3019; mul 552 2991; add 3020 3021; mul 548 3022; mul 546 2993; mul 498 3024; mul 547 2993; add 3025 3026; mul
498 3027; mul 1415 2993; add 3028 3029; mul 485 3030; mul 554 3031; sub 3023 3032; mul 543 3033; add 3018 3034; mul
558 3033; mul 555 3036; mul 559 3033; add 3037 3038; mul 592 3039; mul 485 2995; mul 491 3041; mul 0 3042; mul 563
2988; mul 500 3044; mul 565 3041; add 3045 3046; mul 17 3047; mul 130 3048; sub 3043 3049; mul 500 2988; mul 484
3041; sub 3051 3052; mul 590 3053; mul 0 2971; mul 576 2981; mul 440 3056; add 34 3057; mul 130 3058; add 3055 3059;
sub 2912 2920; mul 582 3061; mul 472 3062; mul 440 3063; sub 51 3064; mul 395 3065; add 3060 3066; mul 501 3067; add
3054 3068; add 3050 3069; mul 560 3070; add 3040 3071; add 3035 3072; mul 501 3073; mul 594 3053; add 3074 3075; mul
1464 2988; mul 1469 3077; mul 604 3078; mul 503 3079; mul 1475 3079; mul 618 3081; mul 1473 3082; neg 3083; mul 503
3084; mul 618 3085; mul 623 3083; sub 3086 3087; sub 3080 3088; mul 621 3089; mul 635 3090; mul 1496 3079; mul 1491
3092; mul 631 3093; mul 629 3094; mul 633 3093; add 3095 3096; mul 626 3097; add 3091 3098; mul 640 3079; mul 627
3100; mul 642 3079; add 3101 3102; mul 638 3103; sub 3099 3104; mul 604 3105; mul 550 3079; mul 627 3107; mul 664
3079; add 3108 3109; mul 662 3110; mul 660 3081; mul 617 3112; mul 661 3081; add 3113 3114; mul 617 3115; mul 1522
3081; add 3116 3117; mul 604 3118; mul 666 3119; sub 3111 3120; mul 658 3121; add 3106 3122; mul 670 3121; mul 667
3124; mul 671 3121; add 3125 3126; mul 685 3127; mul 675 2988; mul 619 3129; mul 604 3083; mul 677 3131; sub 3130
3132; mul 17 3133; mul 130 3134; mul 610 3131; mul 0 3136; add 3135 3137; mul 619 2988; mul 603 3131; sub 3139 3140;
mul 590 3141; mul 620 3067; add 3142 3143; add 3138 3144; mul 672 3145; add 3128 3146; add 3123 3147; mul 620 3148;
mul 687 3141; add 3149 3150; add 3076 3151; mul 431 3152; sub 2972 3153; sub 2964 3154; mul 569 3073; mul 594 3042;
sub 3156 3157; mul 681 3148; mul 687 3136; sub 3159 3160; add 3158 3161; sub 3155 3162; add 1695 3163; mul 90 3164;
sub 2818 3165; mul 89 2801; mul 1581 2815; sub 3167 3168; mul 864 3169; mul 150 2891; mul 331 2925; mul 803 2927;
add 3172 3173; mul 806 2931; add 3174 3175; mul 339 3176; mul 808 2937; add 3177 3178; mul 814 2940; mul 820 2942;
add 3180 3181; mul 372 2947; add 3182 3183; mul 828 2950; add 3184 3185; mul 831 2955; add 3186 3187; mul 834 2937;
add 3188 3189; add 3179 3190; mul 576 3191; add 3171 3192; mul 145 3193; mul 690 3058; mul 579 3152; sub 3195 3196;
sub 3194 3197; mul 567 3073; mul 594 3048; sub 3199 3200; mul 679 3148; mul 687 3134; add 3202 3203; add 3201 3204;
add 3198 3205; mul 22 2625; add 3206 3207; mul 791 3208; sub 3170 3209; sub 3166 3210; mul 89 2812; mul 1627 2815;
sub 3212 3213; mul 989 3214; mul 870 2859; add 868 3216; mul 873 2863; add 3217 3218; input p 205; add 3219 3220;
mul 878 2820; add 3221 3222; mul 881 2824; add 3223 3224; mul 884 2827; add 3225 3226; mul 227 2831; add 3227 3228;
mul 889 2836; add 3229 3230; mul 157 2844; add 3231 3232; mul 894 2848; add 3233 3234; mul 169 2853; add 3235 3236;
mul 184 201; add 3237 3238; mul 257 2856; add 3239 3240; mul 153 2891; add 3241 3242; mul 912 2925; mul 918 2927;
add 3244 3245; mul 921 2931; add 3246 3247; mul 339 3248; mul 923 2937; add 3249 3250; mul 360 2940; mul 933 2942;
add 3252 3253; mul 936 2947; add 3254 3255; mul 831 2950; add 3256 3257; mul 944 2955; add 3258 3259; mul 947 2937;
add 3260 3261; add 3251 3262; mul 951 2931; mul 974 3264; mul 908 2940; mul 331 2942; add 3266 3267; mul 335 2947;
add 3268 3269; mul 915 2950; add 3270 3271; mul 806 2955; add 3272 3273; mul 972 2937; add 3274 3275; mul 952 3276;
add 3265 3277; add 3263 3278; mul 585 3279; mul 976 3062; sub 3280 3281; add 3243 3282; mul 145 3283; mul 690 3065;
mul 588 3152; sub 3285 3286; sub 3284 3287; mul 51 782; mul 22 3289; add 3288 3290; mul 867 3291; add 3215 3292; sub
3211 3293; mul 56 2784; mul 70 2772; add 3295 3296; mul 79 2798; add 3298 3298; sub 3297 3299; mul 89 3300; mul 1772
2815; sub 3301 3302; mul 864 3303; mul 995 3208; sub 3304 3305; mul 789 3169; mul 791 3164; sub 3307 3308; sub 3306
3309; mul 59 2784; mul 70 2778; add 3311 3312; mul 76 2798; mul 79 2789; add 3314 3315; sub 3313 3316; mul 89 3317;
mul 1790 2815; sub 3318 3319; mul 989 3320; mul 1002 3291; add 3321 3322; add 3310 3323; mul 789 3214; mul 867 3164;
sub 3325 3326; mul 864 3320; mul 1002 3208; sub 3328 3329; sub 3327 3330; mul 45 2784; mul 70 2769; add 3332 3333;
mul 76 2789; add 3335 3335; sub 3334 3336; mul 89 3337; mul 1853 2815; sub 3338 3339; mul 989 3340; mul 1011 3291;
add 3341 3342; sub 3331 3343; mul 592 3033; mul 555 3070; add 3345 3346; mul 685 3121; mul 667 3145; add 3348 3349;
mul 501 588; mul 560 3351; mul 501 3352; mul 588 620; mul 672 3354; mul 620 3355; add 3353 3356; mul 579 3357; input
p 206; add 3358 3359; mul 567 3352; mul 679 3355; add 3361 3362; add 3360 3363; add 764 765; add 763 3365; mul 41
3366; mul 22 3367; add 3364 3368; mul 791 3369; input p 207; mul 431 3357; add 3371 3372; mul 569 3352; mul 681
3355; add 3374 3375; sub 3373 3376; mul 67 3366; mul 22 3378; add 3377 3379; mul 90 3380; sub 3370 3381; mul 588
3357; input p 208; add 3383 3384; mul 53 3366; mul 22 3386; add 3385 3387; mul 867 3388; sub 3382 3389; mul 791
3380; mul 995 3369; sub 3391 3392; mul 1002 3388; add 3393 3394; mul 1002 3369; mul 867 3380; sub 3396 3397; mul
1011 3388; sub 3398 3399; mul 555 3351; mul 667 3354; mul 533 555; mul 501 3403; mul 579 3404; mul 567 3403; add
3405 3406; mul 791 3407; mul 431 3404; mul 569 3403; sub 3409 3410; mul 90 3411; sub 3408 3412; mul 588 3404; mul
867 3414; sub 3413 3415; mul 791 3411; mul 995 3407; sub 3417 3418; mul 1002 3414; add 3419 3420; mul 1002 3407; mul
867 3411; sub 3422 3423; mul 1011 3414; sub 3424 3425; input p 209; mul 648 667; mul 620 3428; mul 579 3429; mul 679
3428; add 3430 3431; mul 791 3432; mul 431 3429; mul 681 3428; sub 3434 3435; mul 90 3436; sub 3433 3437; mul 588
3429; mul 867 3439; sub 3438 3440; mul 791 3436; mul 995 3432; sub 3442 3443; mul 1002 3439; add 3444 3445; mul 1002
3432; mul 867 3436; sub 3447 3448; mul 1011 3439; sub 3449 3450; mul 536 555; mul 501 3452; mul 579 3453; mul 567
3452; add 3454 3455; mul 791 3456; mul 431 3453; mul 569 3452; sub 3458 3459; mul 90 3460; sub 3457 3461; mul 588
3453; mul 867 3463; sub 3462 3464; mul 791 3460; mul 995 3456; sub 3466 3467; mul 1002 3463; add 3468 3469; mul 1002
3456; mul 867 3460; sub 3471 3472; mul 1011 3463; sub 3473 3474; input p 210; mul 651 667; mul 620 3477; mul 579
3478; mul 679 3477; add 3479 3480; mul 791 3481; mul 431 3478; mul 681 3477; sub 3483 3484; mul 90 3485; sub 3482
3486; mul 588 3478; mul 867 3488; sub 3487 3489; mul 791 3485; mul 995 3481; sub 3491 3492; mul 1002 3488; add 3493
3494; mul 1002 3481; mul 867 3485; sub 3496 3497; mul 1011 3488; sub 3498 3499; mul 540 555; mul 501 3501; mul 579
3502; mul 567 3501; add 3503 3504; mul 791 3505; mul 431 3502; mul 569 3501; sub 3507 3508; mul 90 3509; sub 3506
3510; mul 588 3502; mul 867 3512; sub 3511 3513; mul 791 3509; mul 995 3505; sub 3515 3516; mul 1002 3512; add 3517
3518; mul 1002 3505; mul 867 3509; sub 3520 3521; mul 1011 3512; sub 3522 3523; input p 211; mul 655 667; mul 620
3526; mul 579 3527; mul 679 3526; add 3528 3529; mul 791 3530; mul 431 3527; mul 681 3526; sub 3532 3533; mul 90
3534; sub 3531 3535; mul 588 3527; mul 867 3537; sub 3536 3538; mul 791 3534; mul 995 3530; sub 3540 3541; mul 1002
3537; add 3542 3543; mul 1002 3530; mul 867 3534; sub 3545 3546; mul 1011 3537; sub 3547 3548; mul 90 738; mul 738
791; neg 3551; mul 738 867; input p 212; mul 90 742; mul 742 791; neg 3556; mul 742 867; input p 213; input p 214;
mul 791 3560; mul 90 699; sub 3561 3562; mul 699 791; mul 995 3560; sub 3564 3565; mul 1002 3560; mul 699 867; sub
3567 3568; input p 215; mul 791 3570; mul 90 702; sub 3571 3572; mul 702 791; mul 995 3570; sub 3574 3575; mul 1002
3570; mul 702 867; sub 3577 3578; input p 216; mul 791 3580; mul 90 706; sub 3581 3582; mul 706 791; mul 995 3580;
sub 3584 3585; mul 1002 3580; mul 706 867; sub 3587 3588; input p 217; mul 791 3590; mul 90 710; sub 3591 3592; mul
710 791; mul 995 3590; sub 3594 3595; mul 1002 3590; mul 710 867; sub 3597 3598; input p 218; mul 791 3600; mul 90
714; sub 3601 3602; mul 714 791; mul 995 3600; sub 3604 3605; mul 1002 3600; mul 714 867; sub 3607 3608; input p
219; mul 791 3610; mul 90 718; sub 3611 3612; mul 718 791; mul 995 3610; sub 3614 3615; mul 1002 3610; mul 718 867;
sub 3617 3618; mul 102 109; add 92 3620; mul 100 121; sub 3621 3622; mul 522 529; mul 485 3624; mul 569 3625; mul
501 3625; mul 431 3627; sub 3626 3628; sub 3623 3629; mul 90 3630; mul 579 3627; mul 567 3625; add 3632 3633; add
121 3634; mul 791 3635; sub 3631 3636; mul 588 3627; mul 867 3638; add 3637 3639; mul 995 3635; mul 791 3630; sub
3641 3642; mul 1002 3638; sub 3643 3644; mul 867 3630; mul 1002 3635; sub 3646 3647; mul 1011 3638; add 3648 3649;
mul 102 112; add 96 3651; mul 100 124; sub 3652 3653; mul 637 644; mul 604 3655; mul 681 3656; mul 620 3656; mul 431
3658; sub 3657 3659; sub 3654 3660; mul 90 3661; mul 579 3658; mul 679 3656; add 3663 3664; add 124 3665; mul 791
3666; sub 3662 3667; mul 588 3658; mul 867 3669; add 3668 3670; mul 995 3666; mul 791 3661; sub 3672 3673; mul 1002
3669; sub 3674 3675; mul 867 3661; mul 1002 3666; sub 3677 3678; mul 1011 3669; add 3679 3680; neg 791; neg 1708;
neg 1862; neg 1802; neg 1805; neg 1721; neg 1872; neg 1812; neg 1729; neg 1878; neg 1733; neg 1881; neg 1822; neg
1825; neg 1752; neg 1892; neg 1832; neg 1835; store f 0 0; store f 1 991; store f 2 130; store f 3 1004; store f 4
395; store f 5 1013; store f 6 1017; store f 7 1020; store f 8 1023; store f 9 1025; store f 10 1028; store f 11
1030; store f 12 1032; store f 13 1034; store f 14 1048; store f 15 1057; store f 16 1066; store f 17 1075; store f
18 1084; store f 19 1093; store a 20 1764; store a 60 1838; store a 100 1901; store a 120 1904; store a 140 1907;
store a 160 1904; store a 180 1907; store a 200 1904; store a 220 1907; store a 240 1031; store a 260 1033; store a
1 2; store a 21 1967; store a 61 1972; store a 101 1978; store a 121 1979; store a 141 1980; store a 161 1979; store
a 181 1980; store a 201 1979; store a 221 1980; store a 281 1981; store a 301 1982; store a 321 1983; store a 341
1984; store a 361 1985; store a 381 1986; store a 22 2632; store a 62 2662; store a 102 2682; store a 122 2685;
store a 142 2688; store a 162 2685; store a 182 2688; store a 202 2685; store a 222 2688; store a 23 2743; store a
43 2; store a 63 2748; store a 103 2753; store a 123 2754; store a 143 2755; store a 163 2754; store a 183 2755;
store a 203 2754; store a 223 2755; store a 283 2757; store a 303 2759; store a 323 2761; store a 343 2763; store a
363 2765; store a 383 2767; store a 24 3294; store a 64 3324; store a 104 3344; store a 124 3347; store a 144 3350;
store a 164 3347; store a 184 3350; store a 204 3347; store a 224 3350; store a 25 3390; store a 65 3395; store a 85
2; store a 105 3400; store a 125 3401; store a 145 3402; store a 165 3401; store a 185 3402; store a 205 3401; store
a 225 3402; store a 26 3416; store a 66 3421; store a 106 3426; store a 126 3427; store a 27 3441; store a 67 3446;
store a 107 3451; store a 147 3427; store a 28 3465; store a 68 3470; store a 108 3475; store a 168 3476; store a 29
3490; store a 69 3495; store a 109 3500; store a 189 3476; store a 30 3514; store a 70 3519; store a 110 3524; store
a 210 3525; store a 31 3539; store a 71 3544; store a 111 3549; store a 231 3525; store a 32 3550; store a 72 3552;
store a 112 3553; store a 252 3554; store a 33 3555; store a 73 3557; store a 113 3558; store a 273 3559; store a 34
3563; store a 74 3566; store a 114 3569; store a 35 3573; store a 75 3576; store a 115 3579; store a 36 3583; store
a 76 3586; store a 116 3589; store a 37 3593; store a 77 3596; store a 117 3599; store a 38 3603; store a 78 3606;
store a 118 3609; store a 39 3613; store a 79 3616; store a 119 3619; store b 2 3640; store b 6 3645; store b 10
3650; store b 3 3671; store b 7 3676; store b 11 3681; store by_c 13 90; store by_c 39 3682; store by_c 65 867;
store by_c 14 3683; store by_c 40 1798; store by_c 66 3684; store by_c 15 1712; store by_c 41 3685; store by_c 67
1865; store by_c 16 1716; store by_c 42 3686; store by_c 68 1868; store by_c 17 3687; store by_c 43 1809; store by_c
69 3688; store by_c 18 1725; store by_c 44 3689; store by_c 70 1875; store by_c 19 3690; store by_c 45 1815; store
by_c 71 3691; store by_c 20 3692; store by_c 46 1818; store by_c 72 3693; store by_c 21 1743; store by_c 47 3694;
store by_c 73 1885; store by_c 22 1747; store by_c 48 3695; store by_c 74 1888; store by_c 23 3696; store by_c 49
1829; store by_c 75 3697; store by_c 24 1756; store by_c 50 3698; store by_c 76 1895; store by_c 25 1760; store by_c
51 3699; store by_c 77 1898
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 6, 'p': 242},
    {'by_k': 2240},
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
974; sub 957 975; input p 136; mul 443 754; mul 281 978; mul 977 979; input p 166; constant 3.0; mul 893 982; mul
441 754; mul 70 984; mul 983 985; mul 981 986; input p 160; mul 985 988; add 987 989; sub 980 990; mul 754 962; mul
274 992; mul 898 993; sub 991 994; mul 21 995; mul 896 979; mul 888 997; input p 156; mul 896 985; mul 999 1000; sub
998 1001; mul 922 979; mul 892 986; input p 162; mul 985 1005; add 1004 1006; sub 1003 1007; mul 912 993; sub 1008
1009; mul 114 1010; add 1002 1011; mul 896 993; mul 881 1013; sub 1012 1014; mul 114 1015; add 996 1016; input p
132; mul 997 1018; mul 888 1000; sub 1019 1020; input p 139; mul 979 1022; mul 888 986; input p 161; mul 985 1025;
add 1024 1026; sub 1023 1027; mul 909 993; sub 1028 1029; mul 114 1030; add 1021 1031; input p 138; mul 979 1033;
mul 885 986; mul 919 985; add 1035 1036; sub 1034 1037; mul 906 993; sub 1038 1039; mul 41 1040; add 1032 1041; mul
878 1013; sub 1042 1043; mul 41 1044; add 1017 1045; input p 131; mul 997 1047; input p 155; mul 1000 1049; sub 1048
1050; input p 137; mul 979 1052; mul 986 1049; mul 912 985; add 1054 1055; sub 1053 1056; mul 903 993; sub 1057
1058; mul 114 1059; add 1051 1060; mul 906 979; mul 986 1047; mul 985 1052; add 1063 1064; sub 1062 1065; mul 900
993; sub 1066 1067; mul 41 1068; add 1061 1069; mul 20 995; add 1070 1071; mul 876 1013; sub 1072 1073; mul 709
1074; add 1046 1075; mul 929 992; mul 271 1077; mul 731 1076; mul 730 1079; add 1078 1080; mul 729 1081; sub 1076
1082; mul 744 1079; sub 1078 1084; mul 743 1085; add 1083 1086; mul 671 1087; mul 666 1088; mul 661 1089; sub 976
1090; mul 758 978; mul 761 984; sub 1092 1093; mul 756 992; sub 1094 1095; mul 871 1096; mul 809 1097; mul 4 196;
mul 865 984; mul 763 1100; mul 1099 1101; mul 792 984; mul 59 1103; mul 1099 1104; add 1102 1105; input p 154; mul
984 1107; mul 1099 1108; add 1106 1109; mul 777 984; mul 763 1111; mul 763 1112; add 1110 1113; input p 153; mul 984
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
152; mul 984 1198; mul 774 1199; add 1197 1200; mul 196 763; mul 763 1199; mul 1202 1203; add 1201 1204; mul 835
984; mul 59 1206; mul 1202 1207; add 1205 1208; input p 151; mul 984 1210; mul 1202 1211; add 1209 1212; input p
150; mul 984 1214; mul 59 1215; mul 59 1216; add 1213 1217; input p 149; mul 984 1219; mul 59 1220; add 1218 1221;
mul 818 984; add 1222 1223; sub 1188 1224; mul 797 1138; add 1225 1226; mul 4 1139; add 1227 1228; mul 4 1143; add
1229 1230; mul 4 1146; add 1231 1232; mul 844 1096; mul 774 1234; add 1233 1235; mul 763 1234; mul 1202 1237; add
1236 1238; mul 841 1096; mul 59 1240; mul 1202 1241; add 1239 1242; mul 838 1096; mul 1202 1244; add 1243 1245; mul
835 1096; mul 59 1247; mul 59 1248; add 1246 1249; mul 832 1096; mul 59 1251; add 1250 1252; mul 829 1096; add 1253
1254; mul 809 1164; sub 1255 1256; mul 797 1168; sub 1257 1258; mul 4 1169; sub 1259 1260; mul 4 1173; sub 1261
1262; mul 4 1176; sub 1263 1264; mul 781 992; mul 774 1266; sub 1265 1267; mul 763 1266; mul 1202 1269; sub 1268
1270; mul 777 992; mul 59 1272; mul 1202 1273; sub 1271 1274; mul 773 992; mul 1202 1276; sub 1275 1277; mul 769
992; mul 59 1279; mul 59 1280; sub 1278 1281; mul 765 992; mul 59 1283; sub 1282 1284; mul 755 992; sub 1285 1286;
mul 756 1287; add 1187 1288; mul 661 1289; sub 1091 1290; input p 220; input c 4; input p 14; mul 2 1294; sub 27
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
mul 882 888; add 2731 2732; input p 133; mul 51 2734; add 2733 2735; input p 134; mul 889 2737; add 2736 2738; input
p 135; mul 893 2740; add 2739 2741; mul 896 2742; mul 22 977; mul 42 906; add 2744 2745; mul 115 1052; add 2746
2747; mul 47 1033; add 2748 2749; mul 122 1022; add 2750 2751; mul 913 922; add 2752 2753; input p 140; mul 52 2755;
add 2754 2756; input p 141; mul 129 2758; add 2757 2759; input p 142; mul 923 2761; add 2760 2762; input p 143; mul
896 2764; add 2763 2765; add 2743 2766; mul 281 2767; add 2728 2768; mul 443 2769; input p 146; mul 59 2771; input p
147; mul 822 2773; add 2772 2774; input p 148; mul 826 2776; add 2775 2777; mul 763 818; add 2778 2779; mul 766
1219; add 2780 2781; mul 770 1214; add 2782 2783; mul 774 1210; add 2784 2785; mul 778 835; add 2786 2787; mul 782
1198; add 2788 2789; mul 765 797; add 2790 2791; mul 801 1115; add 2792 2793; mul 777 805; add 2794 2795; mul 809
1107; add 2796 2797; mul 792 866; add 2798 2799; mul 810 865; add 2800 2801; mul 761 873; add 2802 2803; mul 21
1049; mul 46 888; add 2805 2806; mul 882 999; add 2807 2808; input p 157; mul 51 2810; add 2809 2811; input p 158;
mul 889 2813; add 2812 2814; input p 159; mul 893 2816; add 2815 2817; mul 896 2818; mul 22 988; mul 42 1052; add
2820 2821; mul 115 912; add 2822 2823; mul 47 919; add 2824 2825; mul 122 1025; add 2826 2827; mul 913 1005; add
2828 2829; input p 163; mul 52 2831; add 2830 2832; mul 129 2761; add 2833 2834; input p 164; mul 923 2836; add 2835
2837; input p 165; mul 896 2839; add 2838 2840; add 2819 2841; mul 22 981; mul 42 1047; add 2843 2844; mul 115 1049;
add 2845 2846; mul 47 885; add 2847 2848; mul 122 888; add 2849 2850; mul 892 913; add 2851 2852; input p 167; mul
52 2854; add 2853 2855; mul 129 2810; add 2856 2857; mul 923 2740; add 2858 2859; input p 168; mul 896 2861; add
2860 2862; mul 983 2863; add 2842 2864; mul 70 2865; add 2804 2866; mul 441 2867; sub 2770 2868; mul 931 962; sub
2869 2870; mul 1352 2867; mul 1343 2769; sub 2872 2873; mul 931 1601; add 2874 2875; mul 1352 2769; mul 1928 2867;
sub 2877 2878; mul 931 2183; sub 2879 2880; mul 949 964; constant 0.8; mul 287 441; mul 2883 2884; sub 2882 2885;
mul 944 962; sub 2886 2887; input p 221; input p 222; mul 1310 1315; le 1306 1307; le 1307 1306; add 2892 2893; div
17 2894; mul 2892 2895; mul 2891 2896; mul 2890 2897; mul 2889 2898; mul 238 2899; add 2888 2900; mul 287 1352; mul
2883 2902; mul 949 1603; add 2903 2904; mul 944 1601; add 2905 2906; mul 1310 1911; mul 2896 2908; mul 2890 2909;
mul 2889 2910; mul 238 2911; sub 2907 2912; mul 949 2185; mul 287 1928; mul 2883 2915; sub 2914 2916; mul 944 2183;
sub 2917 2918; mul 1310 2492; mul 2896 2920; mul 2890 2921; mul 2889 2922; mul 238 2923; add 2919 2924; constant
-2.57142857142857; mul 814 1096; mul 2926 2927; constant -0.8571428571428573; mul 810 984; mul 2929 2930; constant
0.9142857142857148; mul 866 984; mul 2932 2933; add 2931 2934; constant 0.05714285714285805; mul 805 984; mul 2936
2937; add 2935 2938; constant -0.1142857142857146; mul 801 984; mul 2940 2941; add 2939 2942; constant
0.2190476190476187; mul 782 984; mul 2944 2945; add 2943 2946; constant 0.11428571428571417; mul 778 984; mul 2948
2949; add 2947 2950; constant -0.05714285714285713; mul 770 984; mul 2952 2953; add 2951 2954; input p 223; constant
-0.03333333333333334; mul 763 984; mul 2957 2958; mul 2956 2959; add 2955 2960; constant 0.007256235827664402; mul
826 984; mul 2962 2963; add 2961 2964; constant 0.019047619047619053; mul 59 984; mul 2966 2967; mul 2956 2968; add
2965 2969; sub 2928 2970; constant 2.057142857142853; mul 810 1096; mul 2972 2973; add 2971 2974; mul 866 1096; mul
2929 2976; add 2975 2977; constant -3.428571428571426; mul 805 1096; mul 2979 2980; add 2978 2981; constant
0.1142857142857161; mul 801 1096; mul 2983 2984; add 2982 2985; constant -0.0571428571428573; mul 793 1096; mul 2987
2988; add 2986 2989; constant -0.09999999999999992; mul 4 1096; mul 2991 2992; mul 2956 2993; add 2990 2994;
constant 2.438095238095238; mul 782 1096; mul 2996 2997; add 2995 2998; constant 0.6571428571428561; mul 778 1096;
mul 3000 3001; add 2999 3002; input p 224; mul 774 1096; mul 3004 3005; sub 3003 3006; mul 770 1096; mul 2948 3008;
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
3004 3389; add 3386 3390; input p 225; constant -0.9999999999999998; mul 1096 3393; mul 3392 3394; add 3391 3395;
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
3360; mul 2956 3696; sub 3695 3697; input p 226; mul 3339 3699; mul 3286 3699; mul 3297 3699; add 3701 3702; mul
3308 3699; add 3703 3704; mul 3316 3699; add 3705 3706; input p 227; input p 228; mul 2959 3709; mul 3708 3710; add
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
873 992; sub 3926 3927; mul 4 1287; add 3928 3929; input p 229; mul 2897 3931; input p 230; constant
0.3333333333333333; mul 3932 3934; mul 3933 3935; sub 3932 3936; add 3930 3937; mul 950 1601; mul 935 1609; add 3939
3940; mul 873 1626; add 3941 3942; mul 4 1904; add 3943 3944; mul 2909 3931; mul 3934 3946; mul 3933 3947; sub 3948
3946; add 3945 3949; mul 935 2191; mul 950 2183; sub 3951 3952; mul 873 2207; sub 3953 3954; mul 4 2485; add 3955
3956; mul 2921 3931; mul 3934 3958; mul 3933 3959; sub 3958 3960; add 3957 3961; mul 443 950; mul 873 978; add 3963
3964; mul 255 970; add 3965 3966; mul 27 1287; add 3967 3968; input p 231; mul 3937 3970; add 3969 3971; input p
232; input p 233; mul 2898 3974; mul 3973 3975; add 3972 3976; mul 255 1609; mul 950 1343; mul 873 1622; add 3979
3980; sub 3978 3981; mul 27 1904; add 3982 3983; mul 3949 3970; add 3984 3985; mul 2910 3974; mul 3973 3987; sub
3986 3988; mul 950 1352; mul 873 1616; add 3990 3991; mul 255 2191; add 3992 3993; mul 27 2485; add 3994 3995; mul
3961 3970; add 3996 3997; mul 2922 3974; mul 3973 3999; add 3998 4000; mul 287 970; mul 441 950; mul 873 984; add
4003 4004; sub 4002 4005; mul 59 1287; add 4006 4007; input p 234; mul 56 3932; mul 4009 4010; sub 4008 4011; mul
287 1609; add 3992 4013; mul 59 1904; add 4014 4015; mul 56 3946; mul 4009 4017; add 4016 4018; mul 287 2191; mul
950 1928; mul 873 2200; add 4021 4022; sub 4020 4023; mul 59 2485; add 4024 4025; mul 56 3958; mul 4009 4027; sub
4026 4028; mul 163 257; mul 255 258; mul 255 4031; mul 394 4032; mul 393 445; mul 393 443; mul 402 4035; sub 4034
4036; mul 4033 4037; mul 170 4038; mul 443 4032; mul 410 4040; sub 4039 4041; mul 397 4035; mul 393 441; mul 98
4044; sub 4043 4045; mul 82 4034; sub 4046 4047; mul 4033 4048; mul 174 4049; sub 4042 4050; mul 27 4051; mul 4030
4052; mul 4030 4053; mul 164 4052; mul 164 4055; mul 196 4056; add 4054 4057; mul 257 258; mul 380 474; input p 144;
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
130; mul 164 4143; mul 164 4144; mul 165 4030; mul 4030 4146; add 4145 4147; mul 27 4148; mul 4038 4149; mul 754
2867; mul 289 392; sub 4151 4152; input p 169; mul 287 4154; mul 761 950; add 4155 4156; add 4153 4157; mul 75 267;
mul 77 255; add 4159 4160; mul 80 287; add 4161 4162; mul 267 4163; mul 77 267; mul 85 255; add 4165 4166; mul 88
287; add 4167 4168; mul 255 4169; add 4164 4170; mul 80 267; mul 88 255; add 4172 4173; mul 96 287; add 4174 4175;
mul 287 4176; add 4171 4177; mul 174 4149; sub 401 4179; mul 4033 4180; add 4178 4181; mul 98 4182; mul 393 4183;
add 4158 4184; mul 440 441; mul 4185 4186; mul 754 2769; mul 284 392; sub 4188 4189; mul 758 950; add 4190 4191; mul
265 295; mul 381 389; add 4193 4194; add 4192 4195; sub 1312 4196; mul 258 4062; add 4197 4198; input p 119; input z
0; mul 4200 4201; input p 120; input z 1; mul 4203 4204; add 4202 4205; input p 121; input z 2; mul 4207 4208; add
4206 4209; input p 122; input z 3; mul 4211 4212; add 4210 4213; input p 123; input z 4; mul 4215 4216; add 4214
4217; input p 124; input z 5; mul 4219 4220; add 4218 4221; input p 145; mul 4222 4223; sub 4199 4224; mul 397 4182;
mul 170 4149; add 395 4227; mul 4033 4228; mul 402 4229; sub 4226 4230; mul 393 4231; mul 410 4149; mul 4032 4233;
sub 4232 4234; sub 4225 4235; mul 440 443; mul 4236 4237; add 4187 4238; input c 0; input c 2; mul 215 4241; add
4240 4242; input c 3; mul 338 4244; add 4243 4245; mul 1296 1330; add 4246 4247; mul 1294 1312; sub 4248 4249; input
p 16; input c 1; add 4251 4252; max 4253 7; mul 267 4254; sub 4250 4255; mul 276 392; sub 954 4257; mul 268 295; mul
383 389; add 4259 4260; sub 4258 4261; sub 4256 4262; input p 118; sub 4264 4222; input p 125; abs 267; mul 4266
4267; mul 267 4268; input p 126; mul 267 4270; mul 267 267; input p 127; add 4272 4273; sqrt 4274; div 17 4275; mul
4271 4276; add 4269 4277; sub 4265 4278; add 4263 4279; input p 128; input x 12; sub 2 4282; mul 4281 4283; input p
129; input x 13; sub 2 4286; mul 4285 4287; add 4284 4288; sub 4280 4289; mul 82 4182; sub 4291 4229; mul 393 4292;
sub 4290 4293; mul 440 445; mul 4294 4295; sub 4239 4296; mul 419 4297; mul 399 4298; mul 406 4297; mul 425 4300;
sub 4299 4301; mul 393 4302; mul 4035 4229; sub 4303 4304; mul 440 4185; mul 399 4306; mul 440 4236; mul 425 4308;
add 4307 4309; mul 435 4297; add 4310 4311; mul 393 4312; sub 4305 4313; mul 196 402; mul 419 4306; mul 419 4298;
sub 4316 4317; mul 431 4297; mul 425 4319; add 4318 4320; mul 440 4294; mul 425 4322; add 4321 4323; mul 393 4324;
mul 4315 4325; add 4314 4326; mul 394 4327; add 4049 4328; mul 258 4329; add 4150 4330; mul 164 4331; mul 257 4030;
mul 4052 4146; mul 165 4053; add 4334 4335; mul 4333 4336; mul 4037 4228; mul 394 4338; mul 443 4233; sub 4339 4340;
mul 4048 4180; mul 394 4342; add 4341 4343; mul 255 4344; mul 255 4345; mul 4035 4182; mul 82 4303; add 4347 4348;
mul 82 4313; sub 4349 4350; mul 419 4308; mul 406 4298; add 4352 4353; mul 399 4319; sub 4354 4355; mul 399 4322;
sub 4356 4357; mul 393 4358; mul 98 4359; add 4351 4360; mul 419 4300; mul 406 4306; sub 4362 4363; sub 4364 4355;
sub 4365 4357; mul 393 4366; mul 98 4367; add 4361 4368; mul 196 397; mul 4325 4370; add 4369 4371; mul 394 4372;
add 4038 4373; mul 174 4374; add 4346 4375; mul 170 4329; add 4376 4377; mul 410 4324; add 4378 4379; mul 258 4324;
mul 4040 4149; sub 4381 4382; mul 409 4383; add 4380 4384; mul 4059 4385; add 4337 4386; mul 163 4387; sub 4332
4388; mul 4138 4389; mul 27 4390; mul 27 4391; add 4142 4392; mul 257 4336; mul 164 4145; mul 4052 4395; sub 4394
4396; mul 4055 4145; sub 4397 4398; mul 258 4374; mul 4049 4149; sub 4400 4401; mul 4073 4402; sub 4399 4403; mul
4110 4331; sub 4404 4405; mul 169 4387; sub 4406 4407; mul 257 4385; mul 4069 4409; sub 4408 4410; mul 4129 4411;
mul 27 4412; mul 27 4413; add 4393 4414; mul 1343 4032; mul 410 4416; mul 393 1343; mul 402 4418; sub 4419 4035; mul
4033 4420; mul 170 4421; add 4417 4422; mul 393 1352; mul 98 4424; mul 397 4418; sub 4425 4426; mul 82 4035; add
4427 4428; mul 4033 4429; mul 174 4430; sub 4423 4431; mul 27 4432; mul 4030 4433; mul 4030 4434; mul 164 4433; mul
164 4436; mul 196 4437; add 4435 4438; mul 1343 4062; mul 380 1418; sub 4440 4441; mul 264 1454; sub 4442 4443; mul
4059 4444; mul 169 4445; mul 257 4444; mul 4069 4447; add 4446 4448; mul 258 1343; mul 4061 4450; mul 304 1442; mul
299 4452; add 4451 4453; mul 311 1442; mul 302 4455; sub 4454 4456; mul 302 1445; add 4457 4458; mul 320 1409; mul
375 1442; sub 4460 4461; mul 1439 4087; add 4462 4463; mul 299 4464; add 4459 4465; mul 177 1456; mul 171 4467; add
4466 4468; mul 184 1456; mul 175 4470; add 4469 4471; mul 175 1525; sub 4472 4473; mul 193 1500; mul 259 1456; sub
4475 4476; mul 1523 4103; add 4477 4478; mul 171 4479; add 4474 4480; mul 4073 4481; add 4449 4482; mul 299 1445;
mul 302 4452; mul 299 4455; add 4485 4486; sub 4484 4487; mul 302 4464; sub 4488 4489; mul 175 4467; add 4490 4491;
mul 171 4470; sub 4492 4493; mul 171 1525; add 4494 4495; mul 175 4479; add 4496 4497; mul 4110 4498; add 4483 4499;
mul 4129 4500; mul 27 4501; mul 27 4502; sub 4439 4503; mul 164 4498; mul 163 4445; sub 4505 4506; mul 4138 4507;
mul 27 4508; mul 27 4509; add 4504 4510; mul 4149 4421; mul 4229 4418; mul 4237 4294; mul 440 1352; mul 4185 4515;
sub 4514 4516; mul 440 1343; mul 4236 4518; sub 4517 4519; mul 419 4520; mul 399 4521; add 4316 4323; sub 4522 4523;
mul 406 4520; mul 425 4525; sub 4524 4526; mul 393 4527; add 4513 4528; mul 435 4520; mul 393 4530; sub 4529 4531;
mul 431 4520; mul 425 4533; mul 419 4521; sub 4534 4535; mul 393 4536; mul 4315 4537; add 4532 4538; mul 394 4539;
add 4430 4540; mul 258 4541; add 4512 4542; mul 164 4543; mul 4146 4433; mul 165 4434; add 4545 4546; mul 4333 4547;
mul 1343 4233; mul 4228 4420; mul 394 4550; add 4549 4551; mul 4180 4429; mul 394 4553; add 4552 4554; mul 255 4555;
mul 255 4556; mul 82 4528; mul 4182 4418; sub 4558 4559; mul 82 4531; sub 4560 4561; mul 406 4521; mul 399 4533; sub
4563 4564; mul 393 4565; mul 98 4566; add 4562 4567; mul 431 4306; mul 419 4322; add 4569 4570; mul 419 4525; add
4571 4572; sub 4573 4564; mul 393 4574; mul 98 4575; add 4568 4576; mul 4370 4537; add 4577 4578; mul 394 4579; add
4421 4580; mul 174 4581; add 4557 4582; mul 170 4541; add 4583 4584; mul 410 4536; add 4585 4586; mul 4149 4416; mul
258 4536; add 4588 4589; mul 409 4590; add 4587 4591; mul 4059 4592; add 4548 4593; mul 163 4594; sub 4544 4595; mul
4138 4596; mul 27 4597; mul 27 4598; add 4511 4599; mul 257 4547; mul 4395 4433; sub 4601 4602; mul 4145 4436; sub
4603 4604; mul 258 4581; mul 4149 4430; sub 4606 4607; mul 4073 4608; sub 4605 4609; mul 4110 4543; sub 4610 4611;
mul 169 4594; sub 4612 4613; mul 257 4592; mul 4069 4615; sub 4614 4616; mul 4129 4617; mul 27 4618; mul 27 4619;
add 4600 4620; mul 402 4424; sub 4044 4622; mul 4033 4623; mul 170 4624; mul 1352 4032; mul 410 4626; sub 4625 4627;
mul 397 4424; mul 393 1928; mul 98 4630; sub 4629 4631; mul 82 4044; sub 4632 4633; mul 4033 4634; mul 174 4635; sub
4628 4636; mul 27 4637; mul 4030 4638; mul 4030 4639; mul 164 4638; mul 164 4641; mul 196 4642; add 4640 4643; mul
380 1959; mul 1352 4062; sub 4645 4646; mul 264 2039; add 4647 4648; mul 4059 4649; mul 169 4650; mul 257 4649; mul
4069 4652; add 4651 4653; mul 311 1961; mul 302 4655; mul 258 1352; mul 4061 4657; mul 304 1961; mul 299 4659; add
4658 4660; sub 4656 4661; mul 302 2027; add 4662 4663; mul 320 2003; mul 375 1961; add 4665 4666; mul 2025 4087; add
4667 4668; mul 299 4669; add 4664 4670; mul 177 2041; mul 171 4672; sub 4671 4673; mul 184 2041; mul 175 4675; sub
4674 4676; mul 175 2107; sub 4677 4678; mul 193 2083; mul 259 2041; add 4680 4681; mul 2105 4103; add 4682 4683; mul
171 4684; add 4679 4685; mul 4073 4686; add 4654 4687; mul 302 4659; mul 299 4655; add 4689 4690; mul 299 2027; add
4691 4692; mul 302 4669; sub 4693 4694; mul 175 4672; sub 4695 4696; mul 171 4675; add 4697 4698; mul 171 2107; add
4699 4700; mul 175 4684; add 4701 4702; mul 4110 4703; add 4688 4704; mul 4129 4705; mul 27 4706; mul 27 4707; sub
4644 4708; mul 164 4703; mul 163 4650; sub 4710 4711; mul 4138 4712; mul 27 4713; mul 27 4714; add 4709 4715; mul
4149 4624; add 4357 4363; mul 440 1928; mul 4185 4719; mul 4236 4515; add 4720 4721; mul 4186 4294; sub 4722 4723;
mul 419 4724; mul 399 4725; add 4718 4726; mul 406 4724; mul 425 4728; sub 4727 4729; mul 393 4730; mul 4229 4424;
sub 4731 4732; add 4352 4363; mul 435 4724; sub 4734 4735; mul 393 4736; add 4733 4737; mul 431 4724; mul 425 4739;
mul 419 4725; add 4571 4741; sub 4740 4742; mul 393 4743; mul 4315 4744; add 4738 4745; mul 394 4746; add 4635 4747;
mul 258 4748; add 4717 4749; mul 164 4750; mul 4146 4638; mul 165 4639; add 4752 4753; mul 4333 4754; mul 4228 4623;
mul 394 4756; mul 1352 4233; sub 4757 4758; mul 4180 4634; mul 394 4760; add 4759 4761; mul 255 4762; mul 255 4763;
mul 4182 4424; mul 82 4731; add 4765 4766; mul 82 4737; add 4767 4768; mul 406 4322; mul 431 4308; sub 4770 4771;
mul 406 4725; add 4772 4773; mul 399 4739; sub 4774 4775; mul 393 4776; mul 98 4777; add 4769 4778; mul 419 4728;
sub 4780 4775; mul 393 4781; mul 98 4782; add 4779 4783; mul 4370 4744; add 4784 4785; mul 394 4786; add 4624 4787;
mul 174 4788; add 4764 4789; mul 170 4748; add 4790 4791; mul 410 4743; add 4792 4793; mul 258 4743; mul 4149 4626;
sub 4795 4796; mul 409 4797; add 4794 4798; mul 4059 4799; add 4755 4800; mul 163 4801; sub 4751 4802; mul 4138
4803; mul 27 4804; mul 27 4805; add 4716 4806; mul 257 4754; mul 4395 4638; sub 4808 4809; mul 4145 4641; sub 4810
4811; mul 258 4788; mul 4149 4635; sub 4813 4814; mul 4073 4815; sub 4812 4816; mul 4110 4750; sub 4817 4818; mul
169 4801; sub 4819 4820; mul 257 4799; mul 4069 4822; sub 4821 4823; mul 4129 4824; mul 27 4825; mul 27 4826; add
4807 4827; mul 184 2516; mul 171 4829; mul 177 2516; mul 175 4831; sub 4830 4832; mul 171 2548; add 4833 4834; mul
259 2516; mul 193 2534; sub 4836 4837; mul 2546 4103; add 4838 4839; mul 175 4840; add 4835 4841; mul 164 4842; mul
264 2514; mul 4059 4844; mul 163 4845; sub 4843 4846; mul 4138 4847; mul 27 4848; mul 27 4849; mul 169 4845; mul 257
4844; mul 4069 4852; add 4851 4853; mul 171 4840; mul 171 4831; mul 175 4829; add 4856 4857; mul 175 2548; add 4858
4859; sub 4855 4860; mul 4073 4861; add 4854 4862; mul 4110 4842; add 4863 4864; mul 4129 4865; mul 27 4866; mul 27
4867; sub 4850 4868; mul 304 2624; mul 302 4870; mul 311 2624; mul 299 4872; add 4871 4873; mul 299 2656; add 4874
4875; mul 375 2624; mul 320 2642; sub 4877 4878; mul 2654 4087; add 4879 4880; mul 302 4881; sub 4876 4882; mul 164
4883; mul 380 2622; mul 4059 4885; mul 163 4886; sub 4884 4887; mul 4138 4888; mul 27 4889; mul 27 4890; mul 169
4886; mul 257 4885; mul 4069 4893; add 4892 4894; mul 302 4872; mul 299 4870; sub 4896 4897; mul 302 2656; add 4898
4899; mul 299 4881; add 4900 4901; mul 4073 4902; add 4895 4903; mul 4110 4883; add 4904 4905; mul 4129 4906; mul 27
4907; mul 27 4908; sub 4891 4909; mul 22 993; mul 947 4911; neg 4912; mul 22 1627; mul 947 4914; mul 22 2208; mul
947 4916; neg 4917; mul 22 979; mul 42 993; mul 982 4920; sub 4919 4921; mul 42 1627; mul 982 4923; mul 22 1623; sub
4924 4925; mul 22 2198; mul 42 2208; mul 982 4928; sub 4927 4929; mul 22 985; mul 115 993; mul 982 4932; add 4931
4933; neg 4934; mul 22 1617; mul 115 1627; mul 982 4937; add 4936 4938; mul 22 2201; mul 115 2208; mul 982 4941; add
4940 4942; neg 4943; mul 42 979; mul 196 4945; mul 47 993; neg 4947; mul 196 4948; add 4946 4949; mul 42 1623; neg
4951; mul 196 4952; mul 47 1627; mul 196 4954; add 4953 4955; mul 42 2198; mul 196 4957; mul 47 2208; neg 4959; mul
196 4960; add 4958 4961; mul 115 979; mul 42 985; sub 4963 4964; mul 122 993; neg 4966; mul 196 4967; add 4965 4968;
mul 42 1617; mul 115 1623; sub 4970 4971; mul 122 1627; mul 196 4973; add 4972 4974; mul 115 2198; mul 42 2201; sub
4976 4977; mul 122 2208; neg 4979; mul 196 4980; add 4978 4981; mul 115 985; neg 4983; mul 196 4984; mul 913 993;
neg 4986; mul 196 4987; add 4985 4988; mul 115 1617; mul 196 4990; mul 913 1627; mul 196 4992; add 4991 4993; mul
115 2201; neg 4995; mul 196 4996; mul 913 2208; neg 4998; mul 196 4999; add 4997 5000; mul 47 979; mul 982 5002; mul
52 993; sub 5003 5004; mul 52 1627; mul 47 1623; mul 982 5007; sub 5006 5008; mul 47 2198; mul 982 5010; mul 52
2208; sub 5011 5012; mul 122 979; mul 196 5014; mul 47 985; sub 5015 5016; mul 129 993; sub 5017 5018; mul 47 1617;
mul 122 1623; neg 5021; mul 196 5022; add 5020 5023; mul 129 1627; add 5024 5025; mul 122 2198; mul 196 5027; mul 47
2201; sub 5028 5029; mul 129 2208; sub 5030 5031; mul 122 985; neg 5033; mul 196 5034; mul 913 979; add 5035 5036;
mul 923 993; sub 5037 5038; mul 122 1617; mul 196 5040; mul 913 1623; sub 5041 5042; mul 923 1627; add 5043 5044;
mul 122 2201; neg 5046; mul 196 5047; mul 913 2198; add 5048 5049; mul 923 2208; sub 5050 5051; mul 913 985; mul 982
5053; add 1013 5054; neg 5055; mul 913 1617; mul 982 5057; add 1645 5058; mul 913 2201; mul 982 5060; add 2226 5061;
neg 5062; mul 52 979; mul 947 5064; mul 52 1623; mul 947 5066; neg 5067; mul 52 2198; mul 947 5069; mul 129 979; mul
982 5071; mul 52 985; sub 5072 5073; mul 52 1617; mul 129 1623; mul 982 5076; sub 5075 5077; mul 129 2198; mul 982
5079; mul 52 2201; sub 5080 5081; mul 129 985; neg 5083; mul 196 5084; mul 923 979; mul 196 5086; add 5085 5087; mul
129 1617; mul 196 5089; mul 923 1623; neg 5091; mul 196 5092; add 5090 5093; mul 129 2201; neg 5095; mul 196 5096;
mul 923 2198; mul 196 5098; add 5097 5099; mul 923 985; mul 982 5101; sub 997 5102; mul 923 1617; mul 982 5104; sub
5105 1633; mul 923 2201; mul 982 5107; sub 2212 5108; mul 947 1000; neg 5110; mul 947 1631; mul 947 2214; neg 5113;
mul 22 986; mul 21 1013; mul 982 5116; add 5115 5117; neg 5118; mul 22 1618; mul 21 1645; mul 982 5121; add 5120
5122; mul 22 2202; mul 21 2226; mul 982 5125; add 5124 5126; neg 5127; mul 21 997; mul 42 986; sub 5129 5130; mul 46
1013; neg 5132; mul 196 5133; add 5131 5134; mul 42 1618; mul 21 1633; sub 5136 5137; mul 46 1645; mul 196 5139; add
5138 5140; mul 21 2212; mul 42 2202; sub 5142 5143; mul 46 2226; neg 5145; mul 196 5146; add 5144 5147; mul 882
1013; neg 5149; mul 196 5150; mul 115 986; mul 21 1000; add 5152 5153; sub 5151 5154; mul 115 1618; mul 21 1631; add
5156 5157; mul 882 1645; mul 196 5159; add 5158 5160; mul 882 2226; neg 5162; mul 196 5163; mul 115 2202; mul 21
2214; add 5165 5166; sub 5164 5167; mul 46 997; mul 196 5169; mul 47 986; sub 5170 5171; mul 51 1013; sub 5172 5173;
mul 47 1618; mul 46 1633; neg 5176; mul 196 5177; add 5175 5178; mul 51 1645; add 5179 5180; mul 46 2212; mul 196
5182; mul 47 2202; sub 5183 5184; mul 51 2226; sub 5185 5186; mul 882 997; mul 122 986; mul 46 1000; add 5189 5190;
sub 5188 5191; mul 889 1013; sub 5192 5193; mul 122 1618; mul 46 1631; add 5195 5196; mul 882 1633; sub 5197 5198;
mul 889 1645; add 5199 5200; mul 882 2212; mul 122 2202; mul 46 2214; add 5203 5204; sub 5202 5205; mul 889 2226;
sub 5206 5207; mul 882 1000; neg 5209; mul 196 5210; mul 913 986; sub 5211 5212; mul 893 1013; sub 5213 5214; mul
913 1618; mul 882 1631; mul 196 5217; add 5216 5218; mul 893 1645; add 5219 5220; mul 882 2214; neg 5222; mul 196
5223; mul 913 2202; sub 5224 5225; mul 893 2226; sub 5226 5227; mul 51 997; mul 982 5229; mul 52 986; sub 5230 5231;
mul 52 1618; mul 51 1633; mul 982 5234; sub 5233 5235; mul 51 2212; mul 982 5237; mul 52 2202; sub 5238 5239; mul
889 997; mul 196 5241; mul 129 986; mul 51 1000; add 5243 5244; sub 5242 5245; mul 129 1618; mul 51 1631; add 5247
5248; mul 889 1633; neg 5250; mul 196 5251; add 5249 5252; mul 889 2212; mul 196 5254; mul 129 2202; mul 51 2214;
add 5256 5257; sub 5255 5258; mul 889 1000; neg 5260; mul 196 5261; mul 923 986; sub 5262 5263; mul 893 997; add
5264 5265; mul 923 1618; mul 889 1631; mul 196 5268; add 5267 5269; mul 893 1633; sub 5270 5271; mul 889 2214; neg
5273; mul 196 5274; mul 923 2202; sub 5275 5276; mul 893 2212; add 5277 5278; mul 896 986; mul 893 1000; mul 982
5281; add 5280 5282; neg 5283; mul 896 1618; mul 893 1631; mul 982 5286; add 5285 5287; mul 896 2202; mul 893 2214;
mul 982 5290; add 5289 5291; neg 5292; mul 22 685; mul 947 5294; mul 22 1541; mul 947 5296; mul 22 2123; mul 947
5298; mul 22 2562; mul 947 5300; mul 22 2674; mul 947 5302; mul 22 678; mul 42 685; mul 982 5305; add 5304 5306; mul
22 1535; mul 42 1541; mul 982 5309; add 5308 5310; mul 22 2117; mul 42 2123; mul 982 5313; add 5312 5314; mul 22
2557; mul 42 2562; mul 982 5317; add 5316 5318; mul 22 2669; mul 42 2674; mul 982 5321; add 5320 5322; mul 22 692;
mul 115 685; mul 982 5325; add 5324 5326; mul 22 1548; mul 115 1541; mul 982 5329; add 5328 5330; mul 22 2130; mul
115 2123; mul 982 5333; add 5332 5334; mul 22 2569; mul 115 2562; mul 982 5337; add 5336 5338; mul 22 2681; mul 115
2674; mul 982 5341; add 5340 5342; mul 42 678; mul 196 5344; mul 47 685; mul 196 5346; add 5345 5347; mul 42 1535;
mul 196 5349; mul 47 1541; mul 196 5351; add 5350 5352; mul 42 2117; mul 196 5354; mul 47 2123; mul 196 5356; add
5355 5357; mul 42 2557; mul 196 5359; mul 47 2562; mul 196 5361; add 5360 5362; mul 42 2669; mul 196 5364; mul 47
2674; mul 196 5366; add 5365 5367; mul 42 692; mul 115 678; add 5369 5370; mul 122 685; mul 196 5372; add 5371 5373;
mul 42 1548; mul 115 1535; add 5375 5376; mul 122 1541; mul 196 5378; add 5377 5379; mul 42 2130; mul 115 2117; add
5381 5382; mul 122 2123; mul 196 5384; add 5383 5385; mul 42 2569; mul 115 2557; add 5387 5388; mul 122 2562; mul
196 5390; add 5389 5391; mul 42 2681; mul 115 2669; add 5393 5394; mul 122 2674; mul 196 5396; add 5395 5397; mul 47
678; mul 982 5399; mul 52 685; add 5400 5401; mul 47 1535; mul 982 5403; mul 52 1541; add 5404 5405; mul 47 2117;
mul 982 5407; mul 52 2123; add 5408 5409; mul 47 2557; mul 982 5411; mul 52 2562; add 5412 5413; mul 47 2669; mul
982 5415; mul 52 2674; add 5416 5417; mul 47 692; mul 122 678; mul 196 5420; add 5419 5421; mul 129 685; add 5422
5423; mul 47 1548; mul 122 1535; mul 196 5426; add 5425 5427; mul 129 1541; add 5428 5429; mul 47 2130; mul 122
2117; mul 196 5432; add 5431 5433; mul 129 2123; add 5434 5435; mul 47 2569; mul 122 2557; mul 196 5438; add 5437
5439; mul 129 2562; add 5440 5441; mul 47 2681; mul 122 2669; mul 196 5444; add 5443 5445; mul 129 2674; add 5446
5447; mul 52 678; mul 947 5449; mul 52 1535; mul 947 5451; mul 52 2117; mul 947 5453; mul 52 2557; mul 947 5455; mul
52 2669; mul 947 5457; mul 52 692; mul 129 678; mul 982 5460; add 5459 5461; mul 52 1548; mul 129 1535; mul 982
5464; add 5463 5465; mul 52 2130; mul 129 2117; mul 982 5468; add 5467 5469; mul 52 2569; mul 129 2557; mul 982
5472; add 5471 5473; mul 52 2681; mul 129 2669; mul 982 5476; add 5475 5477; mul 443 4231; mul 441 4183; sub 5479
5480; mul 445 4292; sub 5481 5482; mul 417 4306; mul 399 4308; add 5484 5485; mul 421 4297; add 5486 5487; mul 418
5488; add 5483 5489; mul 399 4300; mul 417 4298; sub 5491 5492; mul 418 5493; add 5490 5494; mul 404 4302; add 5495
5496; mul 404 4312; sub 5497 5498; mul 428 4297; mul 430 5500; add 5499 5501; mul 398 4358; add 5502 5503; mul 398
4366; add 5504 5505; mul 417 4319; mul 406 4308; mul 406 4300; add 5508 5509; sub 5507 5510; mul 417 4322; add 5511
5512; mul 423 5513; add 5506 5514; mul 415 4324; add 5515 5516; mul 1352 4183; mul 1343 4231; sub 5518 5519; mul 443
4292; add 5520 5521; mul 421 4520; sub 5523 4734; mul 418 5524; add 5522 5525; sub 4357 4352; mul 417 4521; sub 5527
5528; mul 399 4525; add 5529 5530; mul 418 5531; add 5526 5532; mul 404 4527; add 5533 5534; mul 404 4530; sub 5535
5536; mul 428 4520; add 4310 5538; mul 430 5539; add 5537 5540; mul 398 4565; add 5541 5542; mul 398 4574; add 5543
5544; sub 4771 4770; mul 406 4525; sub 5546 5547; mul 417 4533; add 5548 5549; mul 423 5550; add 5545 5551; mul 415
4536; add 5552 5553; mul 1352 4231; mul 1928 4183; sub 5555 5556; mul 441 4292; sub 5557 5558; mul 421 4724; mul 418
5560; add 5559 5561; sub 5508 5512; mul 417 4725; sub 5563 5564; mul 399 4728; add 5565 5566; mul 418 5567; add 5562
5568; mul 404 4730; add 5569 5570; mul 404 4736; add 5571 5572; mul 428 4724; sub 5574 5486; mul 430 5575; add 5573
5576; mul 398 4776; add 5577 5578; mul 398 4781; add 5579 5580; mul 417 4739; mul 406 4728; sub 5582 5583; mul 423
5584; add 5581 5585; mul 415 4743; add 5586 5587; sub 4302 4312; sub 4527 4530; add 4730 4736; mul 258 4383; mul 258
4590; mul 258 4797; mul 267 4048; mul 267 5595; mul 74 658; mul 2 5597; add 682 5598; mul 2 5599; add 5596 5600; mul
393 5488; mul 98 5602; mul 4034 4182; sub 5603 5604; mul 393 5493; mul 98 5606; add 5605 5607; mul 397 4303; add
5608 5609; mul 397 4313; sub 5610 5611; mul 82 196; mul 393 5500; mul 5613 5614; add 5612 5615; mul 2 5616; add 5601
5617; mul 267 4429; mul 267 5619; mul 74 1526; mul 2 5621; sub 5622 1539; mul 2 5623; add 5620 5624; mul 393 5524;
mul 98 5626; add 4347 5627; mul 393 5531; mul 98 5629; add 5628 5630; mul 397 4528; add 5631 5632; mul 397 4531; sub
5633 5634; mul 393 5539; mul 5613 5636; add 5635 5637; mul 2 5638; add 5625 5639; mul 267 4634; mul 267 5641; mul 74
2108; mul 2 5643; add 2120 5644; mul 2 5645; add 5642 5646; mul 393 5560; mul 98 5648; mul 4044 4182; sub 5649 5650;
mul 393 5567; mul 98 5652; add 5651 5653; mul 397 4731; add 5654 5655; mul 397 4737; add 5656 5657; mul 393 5575;
mul 5613 5659; add 5658 5660; mul 2 5661; add 5647 5662; mul 74 2548; mul 2 5664; add 2559 5665; mul 2 5666; mul 74
2656; mul 2 5668; add 2671 5669; mul 2 5670; mul 255 4048; mul 267 5672; mul 255 5595; add 5673 5674; mul 27 5597;
add 563 5676; mul 2 5677; add 5675 5678; mul 27 5599; add 5679 5680; mul 27 5616; add 5681 5682; mul 2 4372; add
5683 5684; mul 255 4429; mul 267 5686; mul 255 5619; add 5687 5688; mul 27 5621; add 1370 5690; mul 2 5691; add 5689
5692; mul 27 5623; add 5693 5694; mul 27 5638; add 5695 5696; mul 2 4579; add 5697 5698; mul 255 4634; mul 267 5700;
mul 255 5641; add 5701 5702; mul 27 5643; add 2030 5704; mul 2 5705; add 5703 5706; mul 27 5645; add 5707 5708; mul
27 5661; add 5709 5710; mul 2 4786; add 5711 5712; mul 27 5664; add 2509 5714; mul 2 5715; mul 27 5666; add 5716
5717; mul 27 5668; add 2658 5719; mul 2 5720; mul 27 5670; add 5721 5722; mul 255 5672; mul 27 5677; add 5724 5725;
mul 27 4372; add 5726 5727; mul 255 5686; mul 27 5691; add 5729 5730; mul 27 4579; add 5731 5732; mul 255 5700; mul
27 5705; add 5734 5735; mul 27 4786; add 5736 5737; mul 27 5715; mul 27 5720; mul 287 4048; mul 267 5741; mul 287
5595; add 5742 5743; mul 59 5597; add 466 5745; mul 2 5746; add 5744 5747; mul 59 5599; add 5748 5749; mul 59 5616;
add 5750 5751; mul 82 5602; sub 5753 5650; mul 82 5606; add 5754 5755; mul 397 4359; add 5756 5757; mul 397 4367;
add 5758 5759; mul 98 196; mul 393 5513; mul 5761 5762; add 5760 5763; mul 2 5764; add 5752 5765; mul 287 4429; mul
267 5767; mul 287 5619; add 5768 5769; mul 59 5621; sub 5771 1448; mul 2 5772; add 5770 5773; mul 59 5623; add 5774
5775; mul 59 5638; add 5776 5777; mul 82 5626; add 4765 5779; mul 82 5629; add 5780 5781; mul 397 4566; add 5782
5783; mul 397 4575; add 5784 5785; mul 393 5550; mul 5761 5787; add 5786 5788; mul 2 5789; add 5778 5790; mul 287
4634; mul 267 5792; mul 287 5641; add 5793 5794; mul 59 5643; add 1951 5796; mul 2 5797; add 5795 5798; mul 59 5645;
add 5799 5800; mul 59 5661; add 5801 5802; mul 82 5648; mul 4182 4630; sub 5804 5805; mul 82 5652; add 5806 5807;
mul 397 4777; add 5808 5809; mul 397 4782; add 5810 5811; mul 393 5584; mul 5761 5813; add 5812 5814; mul 2 5815;
add 5803 5816; mul 59 5664; add 2507 5818; mul 2 5819; mul 59 5666; add 5820 5821; mul 59 5668; add 2618 5823; mul 2
5824; mul 59 5670; add 5825 5826; mul 255 5741; mul 287 5672; add 5828 5829; mul 27 5746; add 5830 5831; mul 59
5677; add 5832 5833; mul 27 5764; add 5834 5835; mul 59 4372; add 5836 5837; mul 255 5767; mul 287 5686; add 5839
5840; mul 27 5772; add 5841 5842; mul 59 5691; add 5843 5844; mul 27 5789; add 5845 5846; mul 59 4579; add 5847
5848; mul 255 5792; mul 287 5700; add 5850 5851; mul 27 5797; add 5852 5853; mul 59 5705; add 5854 5855; mul 27
5815; add 5856 5857; mul 59 4786; add 5858 5859; mul 27 5819; mul 59 5715; add 5861 5862; mul 27 5824; mul 59 5720;
add 5864 5865; mul 287 5741; mul 59 5746; add 5867 5868; mul 59 5764; add 5869 5870; mul 287 5767; mul 59 5772; add
5872 5873; mul 59 5789; add 5874 5875; mul 287 5792; mul 59 5797; add 5877 5878; mul 59 5815; add 5879 5880; mul 59
5819; mul 59 5824; mul 174 4076; mul 394 5884; sub 452 5885; mul 174 4450; mul 394 5887; add 1356 5888; mul 174
4657; mul 394 5890; sub 1937 5891; mul 4032 4338; mul 72 5884; sub 5893 5894; mul 4032 4342; add 5895 5896; mul 395
4372; add 5897 5898; mul 401 4327; add 5899 5900; mul 72 5887; mul 4032 4550; add 5902 5903; mul 4032 4553; add 5904
5905; mul 395 4579; add 5906 5907; mul 401 4539; add 5908 5909; mul 4032 4756; mul 72 5890; sub 5911 5912; mul 4032
4760; add 5913 5914; mul 395 4786; add 5915 5916; mul 401 4746; add 5917 5918; neg 443; neg 228; neg 351; neg 231;
neg 354; neg 235; neg 358; input p 235; mul 328 491; mul 5927 5928; add 491 5929; input p 236; mul 5928 5931; mul 74
5932; add 5930 5933; add 589 5934; mul 205 589; mul 5927 5936; add 5935 5937; mul 5931 5936; mul 74 5939; add 5938
5940; mul 328 1384; mul 5927 5942; add 1384 5943; mul 5931 5942; mul 74 5945; add 5944 5946; add 1475 5947; mul 205
1475; mul 5927 5949; add 5948 5950; mul 5931 5949; mul 74 5952; add 5951 5953; neg 5954; mul 328 1973; mul 5927
5956; add 1973 5957; mul 5931 5956; mul 74 5959; add 5958 5960; add 2053 5961; mul 205 2053; mul 5927 5963; add 5962
5964; mul 5931 5963; mul 74 5966; add 5965 5967; mul 205 2521; mul 5927 5969; add 2521 5970; mul 5931 5969; mul 74
5972; add 5971 5973; mul 328 2629; mul 5927 5975; add 2629 5976; mul 5931 5975; mul 74 5978; add 5977 5979; le 7
4253; le 4253 7; add 5981 5982; div 17 5983; mul 5981 5984; mul 267 445; mul 5985 5986; neg 5987; mul 267 443; mul
5985 5989; mul 267 441; mul 5985 5991; neg 5992; mul 4267 5986; neg 5994; mul 4267 5989; mul 4267 5991; neg 5997;
mul 445 4276; mul 267 5999; neg 6000; mul 443 4276; mul 267 6002; mul 441 4276; mul 267 6004; neg 6005; input p 237;
mul 4276 4277; mul 445 6008; mul 196 4275; div 17 6010; mul 6009 6011; mul 6007 6012; mul 443 6008; mul 6011 6014;
mul 6007 6015; neg 6016; mul 441 6008; mul 6011 6018; mul 6007 6019; mul 443 4222; mul 1343 4222; neg 6022; mul 1352
4222; le 17 4201; mul 255 4223; add 267 6026; lt 7 6027; and 6025 6028; constant -1.0; le 4201 6030; lt 6027 7; and
6031 6032; or 6029 6033; not 6034; input p 175; mul 255 6036; where 6035 6037; le 17 4204; and 6028 6039; le 4204
6030; and 6032 6041; or 6040 6042; not 6043; input p 176; mul 255 6045; where 6044 6046; le 17 4208; and 6028 6048;
le 4208 6030; and 6032 6050; or 6049 6051; not 6052; input p 177; mul 255 6054; where 6053 6055; le 17 4212; and
6028 6057; le 4212 6030; and 6032 6059; or 6058 6060; not 6061; input p 178; mul 255 6063; where 6062 6064; le 17
4216; and 6028 6066; le 4216 6030; and 6032 6068; or 6067 6069; not 6070; input p 179; mul 255 6072; where 6071
6073; le 17 4220; and 6028 6075; le 4220 6030; and 6032 6077; or 6076 6078; not 6079; input p 180; mul 255 6081;
where 6080 6082; mul 170 4105; mul 170 4092; mul 174 4095; add 6085 6086; mul 174 657; add 6087 6088; sub 6084 6089;
mul 170 4467; mul 174 4470; add 6091 6092; mul 174 1525; sub 6093 6094; mul 170 4479; add 6095 6096; mul 170 4684;
mul 170 4672; mul 174 4675; add 6099 6100; mul 174 2107; add 6101 6102; sub 6098 6103; mul 170 4840; mul 170 4831;
mul 174 4829; add 6106 6107; mul 174 2548; add 6108 6109; sub 6105 6110; mul 170 4095; mul 174 4092; sub 6112 6113;
mul 170 657; add 6114 6115; mul 174 4105; add 6116 6117; mul 174 4467; mul 170 4470; sub 6119 6120; mul 170 1525;
add 6121 6122; mul 174 4479; add 6123 6124; mul 170 4675; mul 174 4672; sub 6126 6127; mul 170 2107; add 6128 6129;
mul 174 4684; add 6130 6131; mul 170 4829; mul 174 4831; sub 6133 6134; mul 170 2548; add 6135 6136; mul 174 4840;
add 6137 6138; neg 4105; neg 4479; neg 4684; neg 4840; mul 178 193; mul 637 6144; mul 178 242; mul 620 6146; add
6145 6147; mul 178 226; mul 461 6149; add 6148 6150; mul 178 189; mul 653 6152; add 6151 6153; neg 6154; mul 1490
6146; mul 1505 6144; sub 6156 6157; mul 1365 6149; add 6158 6159; mul 1521 6152; sub 6160 6161; mul 2087 6144; mul
2071 6146; add 6163 6164; mul 1946 6149; add 6165 6166; mul 2103 6152; add 6167 6168; neg 6169; mul 2538 6144; mul
2524 6146; add 6171 6172; mul 2544 6152; add 6173 6174; neg 6175; mul 200 639; mul 200 1507; neg 6178; mul 200 2089;
neg 1484; mul 207 611; mul 207 1484; neg 6183; mul 207 2065; mul 223 592; mul 215 6186; neg 6187; mul 223 1463; mul
215 6189; mul 223 2056; mul 215 6191; neg 6192; input p 238; mul 205 596; mul 6194 6195; add 596 6196; input p 239;
mul 6195 6198; mul 74 6199; add 6197 6200; neg 6201; mul 205 1479; mul 6194 6203; add 1479 6204; mul 6198 6203; mul
74 6206; add 6205 6207; mul 205 2060; mul 6194 6209; add 2060 6210; mul 6198 6209; mul 74 6212; add 6211 6213; neg
6214; mul 249 461; mul 228 6216; mul 249 1365; mul 228 6218; neg 6219; mul 249 1946; mul 228 6221; mul 231 6216; mul
231 6218; neg 6224; mul 231 6221; mul 235 6216; mul 235 6218; neg 6228; mul 235 6221; mul 249 582; mul 249 1468; neg
6232; mul 249 2046; mul 170 4078; mul 174 4074; add 6235 6236; mul 174 559; add 6237 6238; mul 170 4089; sub 6239
6240; mul 174 1445; mul 170 4452; mul 174 4455; add 6243 6244; sub 6242 6245; mul 170 4464; sub 6246 6247; mul 170
4659; mul 174 4655; add 6249 6250; mul 174 2027; add 6251 6252; mul 170 4669; sub 6253 6254; mul 170 4870; mul 174
4872; add 6256 6257; mul 174 2656; add 6258 6259; mul 170 4881; sub 6260 6261; mul 170 4074; mul 174 4078; sub 6263
6264; mul 170 559; add 6265 6266; mul 174 4089; add 6267 6268; mul 174 4452; mul 170 4455; sub 6270 6271; mul 170
1445; add 6272 6273; mul 174 4464; add 6274 6275; mul 170 4655; mul 174 4659; sub 6277 6278; mul 170 2027; add 6279
6280; mul 174 4669; add 6281 6282; mul 170 4872; mul 174 4870; sub 6284 6285; mul 170 2656; add 6286 6287; mul 174
4881; add 6288 6289; mul 305 320; mul 539 6291; mul 305 364; mul 522 6293; add 6292 6294; mul 305 349; mul 454 6296;
add 6295 6297; mul 305 316; mul 555 6299; add 6298 6300; neg 6301; mul 1399 6293; mul 1421 6291; sub 6303 6304; mul
1358 6296; add 6305 6306; mul 1437 6299; sub 6307 6308; mul 2007 6291; mul 1991 6293; add 6310 6311; mul 1939 6296;
add 6312 6313; mul 2023 6299; add 6314 6315; neg 6316; mul 2646 6291; mul 2632 6293; add 6318 6319; mul 2652 6299;
add 6320 6321; neg 6322; mul 326 541; mul 326 1423; neg 6325; mul 326 2009; neg 1393; mul 330 513; mul 330 1393; neg
6330; mul 330 1985; mul 346 494; mul 338 6333; neg 6334; mul 346 1372; mul 338 6336; mul 346 1976; mul 338 6338; neg
6339; input p 240; mul 328 498; mul 6341 6342; add 498 6343; input p 241; mul 6342 6345; mul 74 6346; add 6344 6347;
neg 6348; mul 328 1388; mul 6341 6350; add 1388 6351; mul 6345 6350; mul 74 6353; add 6352 6354; mul 328 1980; mul
6341 6356; add 1980 6357; mul 6345 6356; mul 74 6359; add 6358 6360; neg 6361; mul 369 454; mul 351 6363; mul 369
1358; mul 351 6365; neg 6366; mul 369 1939; mul 351 6368; mul 354 6363; mul 354 6365; neg 6371; mul 354 6368; mul
358 6363; mul 358 6365; neg 6375; mul 358 6368; mul 369 484; mul 369 1377; neg 6379; mul 369 1966; mul 443 4223; sub
6382 445; mul 4201 6383; mul 1343 4223; sub 443 6385; mul 4201 6386; mul 1352 4223; sub 6388 441; mul 4201 6389; mul
4204 6383; mul 4204 6386; mul 4204 6389; mul 4208 6383; mul 4208 6386; mul 4208 6389; mul 4212 6383; mul 4212 6386;
mul 4212 6389; mul 4216 6383; mul 4216 6386; mul 4216 6389; mul 4220 6383; mul 4220 6386; mul 4220 6389; mul 6027
6036; mul 6036 6406; neg 6407; where 6035 6408; mul 6027 6045; mul 6045 6410; neg 6411; where 6044 6412; mul 6027
6054; mul 6054 6414; neg 6415; where 6053 6416; mul 6027 6063; mul 6063 6418; neg 6419; where 6062 6420; mul 6027
6072; mul 6072 6422; neg 6423; where 6071 6424; mul 6027 6081; mul 6081 6426; neg 6427; where 6080 6428; mul 445
4283; neg 6430; mul 443 4283; mul 441 4283; neg 6433; mul 445 4287; neg 6435; mul 443 4287; mul 441 4287; neg 6438;
mul 758 3937; mul 3 1337; sub 6440 6441; mul 758 3949; mul 3 1922; add 6443 6444; mul 758 3961; mul 3 2503; sub 6446
6447; store by_k 112 1339; store by_k 336 1924; store by_k 560 2505; store by_k 672 2616; store by_k 784 2727; store
by_k 896 2616; store by_k 1008 2727; store by_k 1120 2616; store by_k 1232 2727; store by_k 113 2871; store by_k 337
2876; store by_k 561 2881; store by_k 114 2901; store by_k 338 2913; store by_k 562 2925; store by_k 115 3060; store
by_k 339 3168; store by_k 563 3276; store by_k 116 3442; store by_k 340 3570; store by_k 564 3698; store by_k 117
3775; store by_k 341 3849; store by_k 565 3923; store by_k 118 3938; store by_k 342 3950; store by_k 566 3962; store
by_k 119 3977; store by_k 343 3989; store by_k 567 4001; store by_k 120 4012; store by_k 344 4019; store by_k 568
4029; store by_k 121 4415; store by_k 345 4621; store by_k 569 4828; store by_k 681 4869; store by_k 793 4910; store
by_k 905 4869; store by_k 1017 4910; store by_k 1129 4869; store by_k 1241 4910; store by_k 122 4913; store by_k 346
4915; store by_k 570 4918; store by_k 123 4922; store by_k 347 4926; store by_k 571 4930; store by_k 124 4935; store
by_k 348 4939; store by_k 572 4944; store by_k 125 4950; store by_k 349 4956; store by_k 573 4962; store by_k 126
4969; store by_k 350 4975; store by_k 574 4982; store by_k 127 4989; store by_k 351 4994; store by_k 575 5001; store
by_k 128 5005; store by_k 352 5009; store by_k 576 5013; store by_k 129 5019; store by_k 353 5026; store by_k 577
5032; store by_k 130 5039; store by_k 354 5045; store by_k 578 5052; store by_k 131 5056; store by_k 355 5059; store
by_k 579 5063; store by_k 132 5065; store by_k 356 5068; store by_k 580 5070; store by_k 133 5074; store by_k 357
5078; store by_k 581 5082; store by_k 134 5088; store by_k 358 5094; store by_k 582 5100; store by_k 135 5103; store
by_k 359 5106; store by_k 583 5109; store by_k 136 5111; store by_k 360 5112; store by_k 584 5114; store by_k 137
5119; store by_k 361 5123; store by_k 585 5128; store by_k 138 5135; store by_k 362 5141; store by_k 586 5148; store
by_k 139 5155; store by_k 363 5161; store by_k 587 5168; store by_k 140 5174; store by_k 364 5181; store by_k 588
5187; store by_k 141 5194; store by_k 365 5201; store by_k 589 5208; store by_k 142 5215; store by_k 366 5221; store
by_k 590 5228; store by_k 143 5232; store by_k 367 5236; store by_k 591 5240; store by_k 144 5246; store by_k 368
5253; store by_k 592 5259; store by_k 145 5266; store by_k 369 5272; store by_k 593 5279; store by_k 146 5284; store
by_k 370 5288; store by_k 594 5293; store by_k 147 5295; store by_k 371 5297; store by_k 595 5299; store by_k 707
5301; store by_k 819 5303; store by_k 931 5301; store by_k 1043 5303; store by_k 1155 5301; store by_k 1267 5303;
store by_k 148 5307; store by_k 372 5311; store by_k 596 5315; store by_k 708 5319; store by_k 820 5323; store by_k
932 5319; store by_k 1044 5323; store by_k 1156 5319; store by_k 1268 5323; store by_k 149 5327; store by_k 373
5331; store by_k 597 5335; store by_k 709 5339; store by_k 821 5343; store by_k 933 5339; store by_k 1045 5343;
store by_k 1157 5339; store by_k 1269 5343; store by_k 150 5348; store by_k 374 5353; store by_k 598 5358; store
by_k 710 5363; store by_k 822 5368; store by_k 934 5363; store by_k 1046 5368; store by_k 1158 5363; store by_k 1270
5368; store by_k 151 5374; store by_k 375 5380; store by_k 599 5386; store by_k 711 5392; store by_k 823 5398; store
by_k 935 5392; store by_k 1047 5398; store by_k 1159 5392; store by_k 1271 5398; store by_k 152 5402; store by_k 376
5406; store by_k 600 5410; store by_k 712 5414; store by_k 824 5418; store by_k 936 5414; store by_k 1048 5418;
store by_k 1160 5414; store by_k 1272 5418; store by_k 153 5424; store by_k 377 5430; store by_k 601 5436; store
by_k 713 5442; store by_k 825 5448; store by_k 937 5442; store by_k 1049 5448; store by_k 1161 5442; store by_k 1273
5448; store by_k 154 5450; store by_k 378 5452; store by_k 602 5454; store by_k 714 5456; store by_k 826 5458; store
by_k 938 5456; store by_k 1050 5458; store by_k 1162 5456; store by_k 1274 5458; store by_k 155 5462; store by_k 379
5466; store by_k 603 5470; store by_k 715 5474; store by_k 827 5478; store by_k 939 5474; store by_k 1051 5478;
store by_k 1163 5474; store by_k 1275 5478; store by_k 156 5517; store by_k 380 5554; store by_k 604 5588; store
by_k 157 5589; store by_k 381 5590; store by_k 605 5591; store by_k 158 4324; store by_k 382 4536; store by_k 606
4743; store by_k 159 5592; store by_k 383 5593; store by_k 607 5594; store by_k 160 5513; store by_k 384 5550; store
by_k 608 5584; store by_k 161 5618; store by_k 385 5640; store by_k 609 5663; store by_k 721 5667; store by_k 833
5671; store by_k 945 5667; store by_k 1057 5671; store by_k 1169 5667; store by_k 1281 5671; store by_k 162 5685;
store by_k 386 5699; store by_k 610 5713; store by_k 722 5718; store by_k 834 5723; store by_k 946 5718; store by_k
1058 5723; store by_k 1170 5718; store by_k 1282 5723; store by_k 163 5728; store by_k 387 5733; store by_k 611
5738; store by_k 723 5739; store by_k 835 5740; store by_k 947 5739; store by_k 1059 5740; store by_k 1171 5739;
store by_k 1283 5740; store by_k 164 5766; store by_k 388 5791; store by_k 612 5817; store by_k 724 5822; store by_k
836 5827; store by_k 948 5822; store by_k 1060 5827; store by_k 1172 5822; store by_k 1284 5827; store by_k 165
5838; store by_k 389 5849; store by_k 613 5860; store by_k 725 5863; store by_k 837 5866; store by_k 949 5863; store
by_k 1061 5866; store by_k 1173 5863; store by_k 1285 5866; store by_k 166 5871; store by_k 390 5876; store by_k 614
5881; store by_k 726 5882; store by_k 838 5883; store by_k 950 5882; store by_k 1062 5883; store by_k 1174 5882;
store by_k 1286 5883; store by_k 167 5886; store by_k 391 5889; store by_k 615 5892; store by_k 168 5901; store by_k
392 5910; store by_k 616 5919; store by_k 169 445; store by_k 393 5920; store by_k 617 441; store by_k 730 5921;
store by_k 842 5922; store by_k 955 5923; store by_k 1067 5924; store by_k 1180 5925; store by_k 1292 5926; store
by_k 173 5941; store by_k 397 5955; store by_k 621 5968; store by_k 733 5974; store by_k 845 5980; store by_k 957
5974; store by_k 1069 5980; store by_k 1181 5974; store by_k 1293 5980; store by_k 174 5988; store by_k 398 5990;
store by_k 622 5993; store by_k 175 5995; store by_k 399 5996; store by_k 623 5998; store by_k 176 6001; store by_k
400 6003; store by_k 624 6006; store by_k 177 6013; store by_k 401 6017; store by_k 625 6020; store by_k 178 6021;
store by_k 402 6023; store by_k 626 6024; store by_k 1634 6038; store by_k 1746 6047; store by_k 1858 6056; store
by_k 1970 6065; store by_k 2082 6074; store by_k 2194 6083; store by_k 179 6090; store by_k 403 6097; store by_k 627
6104; store by_k 739 6111; store by_k 963 6111; store by_k 1187 6111; store by_k 180 6118; store by_k 404 6125;
store by_k 628 6132; store by_k 740 6139; store by_k 964 6139; store by_k 1188 6139; store by_k 181 6140; store by_k
405 6141; store by_k 629 6142; store by_k 741 6143; store by_k 965 6143; store by_k 1189 6143; store by_k 182 657;
store by_k 406 1525; store by_k 630 2107; store by_k 742 2548; store by_k 966 2548; store by_k 1190 2548; store by_k
183 6155; store by_k 407 6162; store by_k 631 6170; store by_k 743 6176; store by_k 967 6176; store by_k 1191 6176;
store by_k 184 6177; store by_k 408 6179; store by_k 632 6180; store by_k 185 611; store by_k 409 6181; store by_k
633 2065; store by_k 186 6182; store by_k 410 6184; store by_k 634 6185; store by_k 187 6188; store by_k 411 6190;
store by_k 635 6193; store by_k 188 6202; store by_k 412 6208; store by_k 636 6215; store by_k 189 6217; store by_k
413 6220; store by_k 637 6222; store by_k 190 6223; store by_k 414 6225; store by_k 638 6226; store by_k 191 6227;
store by_k 415 6229; store by_k 639 6230; store by_k 192 6231; store by_k 416 6233; store by_k 640 6234; store by_k
193 6241; store by_k 417 6248; store by_k 641 6255; store by_k 865 6262; store by_k 1089 6262; store by_k 1313 6262;
store by_k 194 6269; store by_k 418 6276; store by_k 642 6283; store by_k 866 6290; store by_k 1090 6290; store by_k
1314 6290; store by_k 195 4089; store by_k 419 4464; store by_k 643 4669; store by_k 867 4881; store by_k 1091 4881;
store by_k 1315 4881; store by_k 196 559; store by_k 420 1445; store by_k 644 2027; store by_k 868 2656; store by_k
1092 2656; store by_k 1316 2656; store by_k 197 6302; store by_k 421 6309; store by_k 645 6317; store by_k 869 6323;
store by_k 1093 6323; store by_k 1317 6323; store by_k 198 6324; store by_k 422 6326; store by_k 646 6327; store
by_k 199 513; store by_k 423 6328; store by_k 647 1985; store by_k 200 6329; store by_k 424 6331; store by_k 648
6332; store by_k 201 6335; store by_k 425 6337; store by_k 649 6340; store by_k 202 6349; store by_k 426 6355; store
by_k 650 6362; store by_k 203 6364; store by_k 427 6367; store by_k 651 6369; store by_k 204 6370; store by_k 428
6372; store by_k 652 6373; store by_k 205 6374; store by_k 429 6376; store by_k 653 6377; store by_k 206 6378; store
by_k 430 6380; store by_k 654 6381; store by_k 207 6384; store by_k 431 6387; store by_k 655 6390; store by_k 208
6391; store by_k 432 6392; store by_k 656 6393; store by_k 209 6394; store by_k 433 6395; store by_k 657 6396; store
by_k 210 6397; store by_k 434 6398; store by_k 658 6399; store by_k 211 6400; store by_k 435 6401; store by_k 659
6402; store by_k 212 6403; store by_k 436 6404; store by_k 660 6405; store by_k 1669 6409; store by_k 1782 6413;
store by_k 1895 6417; store by_k 2008 6421; store by_k 2121 6425; store by_k 2234 6429; store by_k 219 6431; store
by_k 443 6432; store by_k 667 6434; store by_k 220 6436; store by_k 444 6437; store by_k 668 6439; store by_k 1453
4283; store by_k 1566 4287; store by_k 223 6442; store by_k 447 6445; store by_k 671 6448
    """,
)
