"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 114},
    {'p': 245},
    """
input k 46; input k 47; constant 1.0; input k 9; sub 3 2; input k 44; input k 56; input k 50; input k 51; input k
53; input k 48; input k 52; input k 54; input k 49; input k 45; input k 113; input k 0; div 2 16; mul 15 17;
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
input k 42; mul 26 233; input k 43; mul 184 235; input k 71; div 2 237; input k 73; input k 74; input k 111; input k
75; input k 76; mul 19 243; constant 0.7142857142857143; sub 243 245; mul 244 246; input k 77; input k 78; input k
79; input k 61; mul 19 251; sub 251 245; mul 252 253; input k 80; input k 86; input k 82; input k 81; input k 83;
input k 84; sub 260 16; input k 85; div 2 262; input k 87; input k 88; input k 89; input k 90; mul 19 267; sub 267
245; mul 268 269; input k 91; input k 92; input k 93; input k 94; input k 57; input k 95; input k 96; input k 97;
input k 98; input k 99; input k 100; input k 63; input k 64; input k 65; mul 284 284; input k 107; input k 108; mul
3 188; mul 188 192; input k 31; mul 184 290; input k 32; mul 188 292; input k 33; mul 184 207; mul 188 208; input k
20; mul 26 297; input k 21; mul 184 299; input k 22; mul 188 301; input k 23; mul 6 212; input k 66; constant 2.4;
mul 54 306; add 41 307; constant 0.019047619047619053; mul 59 309; add 308 310; constant -1.3714285714285719; mul 63
312; constant 1.371428571428571; mul 53 314; constant 0.007256235827664402; mul 58 316; add 315 317; constant
-4.799999999999996; mul 63 319; constant 1.3714285714285672; mul 53 321; constant -0.05714285714285713; mul 58 323;
add 322 324; constant -7.200000000000003; mul 63 326; constant 7.199999999999999; mul 53 328; constant
0.2190476190476187; mul 58 330; add 329 331; constant -45.25714285714285; mul 53 333; constant -0.1142857142857146;
mul 58 335; add 334 336; constant -28.80000000000001; mul 63 338; mul 188 194; mul 188 294; input k 34; mul 184 342;
mul 188 209; mul 184 210; mul 184 303; input k 24; mul 26 347; mul 21 41; input k 58; input k 59; input k 60; input
k 109; input k 110; input k 112; input k 101; div 2 356; input k 102; div 2 358; input k 103; div 2 360; input k
104; div 2 362; input k 105; div 2 364; input k 106; div 2 366; mul 17 27; mul 61 368; mul 17 88; mul 138 368; mul
17 61; add 286 287; mul 125 368; mul 17 35; mul 211 368; add 375 376; mul 21 377; mul 17 211; mul 26 368; add 379
380; mul 21 381; mul 27 382; add 378 383; mul 17 384; mul 23 382; mul 39 382; mul 23 61; mul 23 138; mul 23 125; mul
23 211; mul 21 391; mul 23 26; mul 21 393; mul 27 394; add 392 395; mul 17 396; mul 23 394; mul 39 394; mul 305 357;
mul 305 359; mul 305 361; mul 305 363; mul 305 365; mul 305 367; mul 39 61; mul 39 138; mul 39 125; mul 26 39; mul
21 409; mul 23 410; mul 39 211; mul 21 412; mul 27 410; add 413 414; mul 17 415; mul 39 410; add 349 417; neg 350;
neg 351; neg 352; neg 353; neg 354; neg 355; mul 276 305; mul 277 305; mul 278 305; mul 279 305; mul 280 305; mul
281 305; mul 17 18; mul 51 188; mul 45 46; mul 29 188; mul 23 188; mul 39 188; mul 188 284; store p 0 0; store p 1
3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p
10 11; store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 46; store p 16 47; store p 17 17;
store p 18 48; store p 19 61; store p 20 27; store p 21 23; store p 22 39; store p 23 64; store p 24 69; store p 25
71; store p 26 76; store p 27 81; store p 28 88; store p 29 90; store p 30 95; store p 31 97; store p 32 102; store
p 33 107; store p 34 112; store p 35 117; store p 36 123; store p 37 125; store p 38 127; store p 39 132; store p 40
138; store p 41 140; store p 42 145; store p 43 149; store p 44 154; store p 45 159; store p 46 161; store p 47 166;
store p 48 171; store p 49 173; store p 50 178; store p 51 183; store p 52 186; store p 53 189; store p 54 191;
store p 55 192; store p 56 193; store p 57 194; store p 58 196; store p 59 198; store p 60 200; store p 61 202;
store p 62 204; store p 63 206; store p 64 207; store p 65 208; store p 66 209; store p 67 210; store p 68 21; store
p 69 220; store p 70 222; store p 71 224; store p 72 226; store p 73 228; store p 74 229; store p 75 230; store p 76
212; store p 77 218; store p 78 16; store p 79 221; store p 80 227; store p 81 231; store p 82 232; store p 83 234;
store p 84 236; store p 85 223; store p 86 235; store p 87 216; store p 88 214; store p 89 238; store p 90 215;
store p 91 213; store p 92 239; store p 93 240; store p 94 241; store p 95 242; store p 96 243; store p 97 247;
store p 98 248; store p 99 249; store p 100 250; store p 101 251; store p 102 254; store p 103 255; store p 104 261;
store p 105 257; store p 106 258; store p 107 263; store p 108 259; store p 109 256; store p 110 264; store p 111
265; store p 112 266; store p 113 267; store p 114 270; store p 115 271; store p 116 272; store p 117 273; store p
118 274; store p 119 275; store p 120 276; store p 121 277; store p 122 278; store p 123 279; store p 124 280; store
p 125 281; store p 126 282; store p 127 283; store p 128 285; store p 129 286; store p 130 287; store p 131 288;
store p 132 187; store p 133 289; store p 134 291; store p 135 293; store p 136 294; store p 137 197; store p 138
203; store p 139 295; store p 140 296; store p 141 298; store p 142 300; store p 143 302; store p 144 303; store p
145 304; store p 146 305; store p 147 311; store p 148 313; store p 149 318; store p 150 320; store p 151 325; store
p 152 327; store p 153 332; store p 154 337; store p 155 339; store p 156 190; store p 157 340; store p 158 292;
store p 159 341; store p 160 343; store p 161 199; store p 162 344; store p 163 345; store p 164 299; store p 165
346; store p 166 348; store p 167 185; store p 168 290; store p 169 342; store p 170 349; store p 171 350; store p
172 351; store p 173 352; store p 174 353; store p 175 354; store p 176 355; store p 177 357; store p 178 359; store
p 179 361; store p 180 363; store p 181 365; store p 182 367; store p 183 369; store p 184 368; store p 185 370;
store p 186 371; store p 187 372; store p 188 373; store p 189 374; store p 190 385; store p 191 386; store p 192
387; store p 193 388; store p 194 389; store p 195 390; store p 196 397; store p 197 398; store p 198 399; store p
199 400; store p 200 401; store p 201 402; store p 202 403; store p 203 404; store p 204 405; store p 205 406; store
p 206 407; store p 207 408; store p 208 411; store p 209 416; store p 210 418; store p 211 419; store p 212 420;
store p 213 421; store p 214 422; store p 215 423; store p 216 424; store p 217 425; store p 218 426; store p 219
427; store p 220 428; store p 221 429; store p 222 430; store p 223 431; store p 224 24; store p 225 45; store p 226
52; store p 227 51; store p 228 120; store p 229 53; store p 230 432; store p 231 58; store p 232 433; store p 233
434; store p 234 15; store p 235 435; store p 236 22; store p 237 436; store p 238 252; store p 239 253; store p 240
437; store p 241 244; store p 242 246; store p 243 268; store p 244 269
    """,
)

JACOBIAN = Graph(
    {'x': 15, 'u': 2, 'c': 13, 'z': 6, 'c_q': 13, 'p': 245},
    {'f': 21, 'a': 441, 'b': 42, 'by_c': 273},
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
520; input p 94; input x 14; mul 522 523; sub 2 524; mul 521 525; input p 95; mul 93 527; input p 96; input p 97;
mul 512 530; add 529 531; mul 512 532; add 2 533; mul 528 534; sub 526 535; mul 485 536; input p 98; input x 6; mul
538 539; input p 99; input x 8; mul 541 542; add 540 543; input p 100; input x 10; mul 545 546; add 544 547;
constant -0.5; mul 498 549; mul 498 550; mul 498 551; mul 485 552; input p 101; input p 102; mul 512 555; add 554
556; mul 512 557; add 2 558; mul 553 559; mul 548 560; add 537 561; input p 103; mul 560 563; mul 560 564; sub 480
483; mul 491 566; add 486 489; mul 484 568; sub 567 569; mul 500 570; mul 17 571; mul 130 572; mul 491 500; mul 0
574; sub 573 575; mul 0 431; constant 3.3333333333333335; add 294 298; mul 578 579; sub 2 580; mul 461 581; mul 440
582; add 37 583; mul 130 584; add 577 585; constant 1.25; add 314 318; mul 587 588; sub 2 589; mul 472 590; mul 440
591; add 53 592; mul 395 593; add 586 594; mul 501 595; add 576 596; mul 565 597; add 562 598; mul 501 599; input p
104; add 477 601; input p 105; mul 24 603; add 602 604; input p 106; mul 38 606; add 605 607; input p 107; mul 38
603; mul 24 606; input p 108; sub 611 612; sub 610 613; sub 614 29; mul 615 615; mul 608 608; add 616 617; sqrt 618;
mul 609 619; sqrt 620; div 2 621; mul 622 622; mul 609 623; mul 608 624; input p 109; mul 503 620; mul 503 623; mul
623 628; sub 627 629; mul 626 630; sub 620 511; max 510 632; min 509 633; input p 110; input p 111; mul 634 636; add
635 637; mul 634 638; add 2 639; mul 631 640; mul 525 641; input p 112; mul 97 643; input p 113; input p 114; mul
632 646; add 645 647; mul 632 648; add 2 649; mul 644 650; sub 642 651; mul 609 652; input p 115; input x 7; mul 654
655; input p 116; input x 9; mul 657 658; add 656 659; input p 117; input x 11; mul 661 662; add 660 663; mul 549
622; mul 622 665; mul 622 666; mul 609 667; mul 555 632; add 554 669; mul 632 670; add 2 671; mul 668 672; mul 664
673; add 653 674; input p 118; mul 673 676; mul 673 677; add 604 607; mul 615 679; sub 611 610; mul 608 681; add 680
682; mul 624 683; mul 17 684; mul 130 685; mul 615 624; mul 0 687; sub 686 688; mul 595 625; add 689 690; mul 678
691; add 675 692; mul 625 693; add 600 694; sub 432 695; mul 431 696; sub 409 697; mul 574 599; mul 687 693; add 699
700; sub 698 701; sub 143 702; input p 119; input p 120; input z 0; mul 705 706; input p 121; input z 1; mul 708
709; add 707 710; input p 122; input z 2; mul 712 713; add 711 714; input p 123; input z 3; mul 716 717; add 715
718; input p 124; input z 4; mul 720 721; add 719 722; input p 125; input z 5; mul 724 725; add 723 726; sub 704
727; input p 126; abs 0; mul 729 730; mul 0 731; input p 127; mul 0 733; mul 0 0; input p 128; add 735 736; sqrt
737; div 2 738; mul 734 739; add 732 740; sub 728 741; add 703 742; input p 129; input x 12; sub 29 745; mul 744
746; input p 130; input x 13; sub 29 749; mul 748 750; add 747 751; sub 743 752; mul 0 62; mul 28 130; add 754 755;
mul 47 395; add 756 757; mul 0 758; mul 0 28; mul 31 130; add 760 761; mul 34 395; add 762 763; mul 130 764; add 759
765; mul 0 47; mul 34 130; add 767 768; mul 51 395; add 769 770; mul 395 771; add 766 772; mul 17 130; mul 130 774;
mul 23 775; input p 131; mul 9 777; mul 9 778; mul 8 16; mul 10 780; mul 780 781; add 779 782; mul 3 783; mul 38
784; sub 25 785; mul 776 786; add 773 787; mul 67 788; mul 24 784; add 39 790; mul 776 791; sub 789 792; mul 22 793;
sub 753 794; mul 90 795; mul 81 89; mul 150 265; input p 132; mul 285 799; input p 133; mul 304 801; add 800 802;
mul 324 331; add 803 804; input p 134; mul 328 806; add 805 807; input p 135; mul 332 809; add 808 810; input p 136;
mul 336 812; add 811 813; mul 339 814; input p 137; mul 342 816; mul 345 352; add 817 818; input p 138; mul 349 820;
add 819 821; input p 139; mul 353 823; add 822 824; input p 140; mul 357 826; add 825 827; mul 361 372; add 828 829;
input p 141; mul 365 831; add 830 832; input p 142; mul 369 834; add 833 835; input p 143; mul 373 837; add 836 838;
input p 144; mul 339 840; add 839 841; add 815 842; mul 581 843; add 798 844; mul 145 845; mul 584 696; sub 846 847;
mul 150 405; add 848 849; mul 572 599; mul 685 693; add 851 852; add 850 853; sub 134 854; input p 145; mul 38 856;
mul 17 857; add 855 858; input p 146; mul 727 860; sub 859 861; mul 41 788; mul 26 792; sub 863 864; mul 22 865; mul
19 784; mul 775 867; sub 866 868; sub 862 869; mul 797 870; sub 796 871; mul 86 89; input p 147; mul 35 874; input p
148; mul 214 876; add 875 877; input p 149; mul 218 879; add 878 880; mul 155 210; add 881 882; input p 150; mul 158
884; add 883 885; input p 151; mul 162 887; add 886 888; input p 152; mul 166 890; add 889 891; mul 170 227; add 892
893; input p 153; mul 174 895; add 894 896; mul 157 189; add 897 898; input p 154; mul 193 900; add 899 901; mul 169
197; add 902 903; input p 155; mul 201 905; add 904 906; mul 184 258; add 907 908; mul 202 257; add 909 910; mul 153
265; add 911 912; input p 156; mul 285 914; mul 304 331; add 915 916; input p 157; mul 324 918; add 917 919; input p
158; mul 328 921; add 920 922; input p 159; mul 332 924; add 923 925; input p 160; mul 336 927; add 926 928; mul 339
929; input p 161; mul 342 931; mul 345 820; add 932 933; mul 349 360; add 934 935; mul 353 368; add 936 937; input p
162; mul 357 939; add 938 940; input p 163; mul 361 942; add 941 943; input p 164; mul 365 945; add 944 946; mul 369
837; add 947 948; input p 165; mul 373 950; add 949 951; input p 166; mul 339 953; add 952 954; add 930 955;
constant 3.0; mul 336 957; input p 167; mul 342 959; mul 345 799; add 960 961; mul 349 914; add 962 963; mul 327
353; add 964 965; mul 331 357; add 966 967; mul 335 361; add 968 969; input p 168; mul 365 971; add 970 972; mul 369
921; add 973 974; mul 373 812; add 975 976; input p 169; mul 339 978; add 977 979; mul 958 980; add 956 981; mul 590
982; add 913 983; mul 145 984; mul 593 696; sub 985 986; input p 170; mul 395 988; mul 153 405; add 989 990; add 987
991; mul 53 788; mul 22 993; add 992 994; mul 873 995; sub 872 996; mul 56 70; mul 79 79; sub 998 999; mul 89 1000;
mul 870 1001; mul 795 797; sub 1002 1003; mul 59 70; mul 76 79; sub 1005 1006; mul 89 1007; mul 995 1008; add 1004
1009; mul 795 873; mul 870 1008; sub 1011 1012; mul 45 70; mul 76 76; sub 1014 1015; mul 89 1016; mul 995 1017; sub
1013 1018; mul 560 597; input p 171; mul 539 1021; sub 1020 1022; mul 673 691; mul 655 1021; sub 1024 1025; input p
172; mul 542 1027; sub 1020 1028; mul 658 1027; sub 1024 1030; input p 173; mul 546 1032; sub 1020 1033; mul 662
1032; sub 1024 1035; input p 174; mul 746 1037; input p 175; mul 750 1039; input p 176; sub 2 523; mul 1041 1042; le
2 706; mul 130 860; add 0 1045; lt 140 1046; and 1044 1047; constant -1.0; le 706 1049; lt 1046 140; and 1050 1051;
or 1048 1052; not 1053; input p 177; mul 1046 1055; where 1054 1056; le 2 709; and 1047 1058; le 709 1049; and 1051
1060; or 1059 1061; not 1062; input p 178; mul 1046 1064; where 1063 1065; le 2 713; and 1047 1067; le 713 1049; and
1051 1069; or 1068 1070; not 1071; input p 179; mul 1046 1073; where 1072 1074; le 2 717; and 1047 1076; le 717
1049; and 1051 1078; or 1077 1079; not 1080; input p 180; mul 1046 1082; where 1081 1083; le 2 721; and 1047 1085;
le 721 1049; and 1051 1087; or 1086 1088; not 1089; input p 181; mul 1046 1091; where 1090 1092; le 2 725; and 1047
1094; le 725 1049; and 1051 1096; or 1095 1097; not 1098; input p 182; mul 1046 1100; where 1099 1101; mul 41 503;
mul 28 1103; mul 22 1104; mul 56 1105; mul 53 503; mul 47 1107; mul 22 1108; mul 45 1109; add 1106 1110; mul 28 53;
mul 41 47; add 1112 1113; mul 22 1114; mul 59 1115; add 1116 1116; sub 1111 1117; mul 89 1118; mul 89 90; mul 67
503; mul 62 1121; mul 22 1122; mul 61 1123; mul 70 1118; add 1124 1125; mul 41 62; mul 28 67; add 1127 1128; mul 22
1129; mul 81 1130; mul 56 1130; mul 76 1109; add 1132 1133; mul 79 1115; mul 47 67; mul 53 62; add 1136 1137; mul 22
1138; mul 59 1139; add 1135 1140; sub 1134 1141; mul 76 1142; add 1131 1143; sub 1126 1144; mul 86 1139; mul 59
1130; mul 76 1115; add 1147 1148; mul 79 1105; mul 45 1139; add 1150 1151; sub 1149 1152; mul 79 1153; add 1146
1154; add 1145 1155; mul 1120 1156; sub 1119 1157; mul 795 1158; mul 100 106; mul 102 1160; mul 100 114; sub 1161
1162; mul 100 118; mul 100 1164; sub 1163 1165; input p 183; input p 184; mul 35 1168; mul 157 1169; add 1167 1170;
mul 35 1169; mul 161 1172; add 1171 1173; mul 155 503; mul 1168 1175; mul 165 1176; add 1174 1177; mul 35 1176; mul
169 1179; add 1178 1180; mul 155 1176; mul 166 1168; add 1182 1183; mul 173 1184; add 1181 1185; input p 185; add
1186 1187; mul 35 144; mul 180 1189; add 1188 1190; mul 35 1189; mul 184 1192; add 1191 1193; mul 144 155; mul 148
1168; add 1195 1196; mul 188 1197; add 1194 1198; mul 35 1197; mul 192 1200; add 1199 1201; mul 155 1197; mul 189
1168; add 1203 1204; mul 196 1205; add 1202 1206; mul 148 503; mul 144 1208; mul 155 1209; mul 201 1168; add 1210
1211; mul 200 1212; add 1207 1213; mul 148 1209; mul 144 201; add 1215 1216; mul 205 1217; add 1214 1218; input p
186; mul 224 1169; add 1220 1221; mul 227 1172; add 1222 1223; mul 230 1176; add 1224 1225; mul 233 1179; add 1226
1227; mul 236 1184; add 1228 1229; input p 187; add 1230 1231; mul 157 1189; add 1232 1233; mul 161 1192; add 1234
1235; mul 245 1197; add 1236 1237; mul 248 1200; add 1238 1239; mul 251 1205; add 1240 1241; mul 254 1209; add 1242
1243; mul 35 1209; mul 257 1245; add 1244 1246; mul 196 1212; add 1247 1248; mul 263 1217; add 1249 1250; mul 147
1251; add 1219 1252; mul 284 503; le 271 269; le 269 271; add 1255 1256; div 2 1257; mul 1255 1258; le 270 148; le
148 270; add 1260 1261; div 2 1262; mul 1260 1263; mul 144 1264; mul 1259 1265; constant 2.857142857142857; mul 275
503; le 140 274; le 274 140; add 1269 1270; div 2 1271; mul 1269 1272; mul 1266 1273; mul 1268 1274; mul 279 503; le
140 278; le 278 140; add 1277 1278; div 2 1279; mul 1277 1280; mul 1266 1281; mul 1276 1282; add 1275 1283; mul 1267
1284; sub 1266 1285; mul 1254 1286; mul 268 1287; mul 303 1286; mul 287 1289; add 1288 1290; mul 323 1286; mul 307
1292; add 1291 1293; mul 339 1294; mul 284 1287; mul 285 1286; add 1296 1297; mul 341 1298; mul 303 1287; mul 344
1300; add 1299 1301; mul 323 1287; mul 348 1303; add 1302 1304; mul 303 1289; mul 352 1306; add 1305 1307; mul 323
1289; mul 356 1309; add 1308 1310; mul 323 1292; mul 360 1312; add 1311 1313; add 1295 1314; mul 383 1315; sub 1274
1282; mul 380 1317; mul 379 1318; sub 1316 1319; add 1253 1320; mul 145 1321; mul 144 1322; mul 410 1298; mul 412
1300; add 1324 1325; mul 415 1303; add 1326 1327; mul 418 1306; add 1328 1329; mul 421 1309; add 1330 1331; mul 383
1332; mul 429 1318; sub 1333 1334; add 62 1335; mul 696 1336; mul 484 503; add 63 67; add 64 1339; add 66 1340; mul
104 1341; mul 429 1286; mul 284 1332; add 1343 1344; mul 443 1298; mul 418 1300; add 1346 1347; mul 447 1303; add
1348 1349; mul 450 1306; add 1350 1351; mul 453 1309; add 1352 1353; mul 303 1354; add 1345 1355; mul 464 1298; mul
447 1300; add 1357 1358; mul 427 1306; add 1359 1360; mul 323 1361; add 1356 1362; mul 441 1363; mul 440 1364; add
1342 1365; mul 1338 1366; mul 491 503; sub 1367 1368; mul 495 503; div 2 1370; mul 1369 1371; mul 485 1372; mul 503
1373; mul 498 503; mul 497 503; div 2 1376; mul 1373 1377; mul 499 1378; mul 1375 1379; neg 1380; mul 503 1381; mul
499 1382; mul 505 1380; sub 1383 1384; sub 1374 1385; mul 502 1386; mul 520 1387; le 513 509; le 509 513; add 1389
1390; div 2 1391; mul 1389 1392; le 510 512; le 512 510; add 1394 1395; div 2 1396; mul 1394 1397; mul 1373 1398;
mul 1393 1399; mul 516 1400; mul 514 1401; mul 518 1400; add 1402 1403; mul 508 1404; add 1388 1405; mul 525 1406;
mul 530 1373; mul 512 1408; mul 532 1373; add 1409 1410; mul 528 1411; sub 1407 1412; mul 485 1413; mul 555 1373;
mul 512 1415; mul 557 1373; add 1416 1417; mul 553 1418; mul 551 1378; mul 498 1420; mul 552 1378; add 1421 1422;
mul 498 1423; mul 498 552; mul 1378 1425; add 1424 1426; mul 485 1427; mul 559 1428; sub 1419 1429; mul 548 1430;
add 1414 1431; mul 563 1430; mul 560 1433; mul 564 1430; add 1434 1435; mul 597 1436; mul 485 1380; mul 491 1438;
add 500 1439; mul 0 1440; mul 568 1366; add 566 1442; mul 500 1443; mul 570 1438; add 1444 1445; mul 17 1446; mul
130 1447; sub 1441 1448; mul 500 1366; mul 484 1438; sub 1450 1451; mul 595 1452; mul 0 1336; mul 581 1354; mul 440
1455; add 28 1456; mul 130 1457; add 1454 1458; mul 590 1361; mul 440 1460; add 47 1461; mul 395 1462; add 1459
1463; mul 501 1464; add 1453 1465; add 1449 1466; mul 565 1467; add 1437 1468; add 1432 1469; mul 501 1470; mul 599
1452; add 1471 1472; mul 503 608; mul 1366 1474; mul 503 615; sub 1475 1476; mul 503 619; div 2 1478; mul 1477 1479;
mul 609 1480; mul 503 1481; mul 503 622; mul 503 621; div 2 1484; mul 1481 1485; mul 623 1486; mul 1483 1487; neg
1488; mul 503 1489; mul 623 1490; mul 628 1488; sub 1491 1492; sub 1482 1493; mul 626 1494; mul 640 1495; le 633
509; le 509 633; add 1497 1498; div 2 1499; mul 1497 1500; le 510 632; le 632 510; add 1502 1503; div 2 1504; mul
1502 1505; mul 1481 1506; mul 1501 1507; mul 636 1508; mul 634 1509; mul 638 1508; add 1510 1511; mul 631 1512; add
1496 1513; mul 525 1514; mul 646 1481; mul 632 1516; mul 648 1481; add 1517 1518; mul 644 1519; sub 1515 1520; mul
609 1521; mul 555 1481; mul 632 1523; mul 670 1481; add 1524 1525; mul 668 1526; mul 666 1486; mul 622 1528; mul 667
1486; add 1529 1530; mul 622 1531; mul 622 667; mul 1486 1533; add 1532 1534; mul 609 1535; mul 672 1536; sub 1527
1537; mul 664 1538; add 1522 1539; mul 676 1538; mul 673 1541; mul 677 1538; add 1542 1543; mul 691 1544; mul 681
1366; sub 1546 679; mul 624 1547; mul 609 1488; mul 683 1549; sub 1548 1550; mul 17 1551; mul 130 1552; mul 615
1549; add 624 1554; mul 0 1555; add 1553 1556; mul 624 1366; mul 608 1549; sub 1558 1559; mul 595 1560; mul 625
1464; add 1561 1562; add 1557 1563; mul 678 1564; add 1545 1565; add 1540 1566; mul 625 1567; mul 693 1560; add 1568
1569; add 1473 1570; mul 431 1571; sub 1337 1572; sub 1323 1573; mul 574 1470; mul 599 1440; sub 1575 1576; mul 687
1567; mul 693 1555; sub 1578 1579; add 1577 1580; sub 1574 1581; sub 1166 1582; input p 188; sub 1583 1584; mul 62
788; mul 22 1586; sub 1585 1587; mul 90 1588; add 1159 1589; mul 89 1142; mul 89 797; mul 1156 1592; sub 1591 1593;
mul 870 1594; mul 150 1251; mul 799 1287; mul 801 1289; add 1597 1598; mul 331 1292; add 1599 1600; mul 339 1601;
mul 816 1298; mul 352 1300; add 1603 1604; mul 820 1303; add 1605 1606; mul 823 1306; add 1607 1608; mul 826 1309;
add 1609 1610; mul 372 1312; add 1611 1612; add 1602 1613; mul 581 1614; add 1596 1615; mul 145 1616; mul 696 1457;
mul 584 1571; sub 1618 1619; sub 1617 1620; mul 572 1470; mul 599 1447; sub 1622 1623; mul 685 1567; mul 693 1552;
add 1625 1626; add 1624 1627; add 1621 1628; sub 1164 1629; mul 28 788; mul 22 1631; sub 1630 1632; mul 797 1633;
add 1595 1634; sub 1590 1635; mul 89 1153; mul 89 873; mul 1156 1638; sub 1637 1639; mul 995 1640; input p 189; mul
884 1169; add 1642 1643; mul 887 1172; add 1644 1645; mul 890 1176; add 1646 1647; mul 227 1179; add 1648 1649; mul
895 1184; add 1650 1651; mul 157 1197; add 1652 1653; mul 900 1200; add 1654 1655; mul 169 1205; add 1656 1657; mul
905 1209; add 1658 1659; mul 184 1245; add 1660 1661; mul 257 1212; add 1662 1663; mul 153 1251; add 1664 1665; mul
914 1287; mul 331 1289; add 1667 1668; mul 918 1292; add 1669 1670; mul 339 1671; mul 931 1298; mul 820 1300; add
1673 1674; mul 360 1303; add 1675 1676; mul 368 1306; add 1677 1678; mul 939 1309; add 1679 1680; mul 942 1312; add
1681 1682; add 1672 1683; mul 959 1298; mul 799 1300; add 1685 1686; mul 914 1303; add 1687 1688; mul 327 1306; add
1689 1690; mul 331 1309; add 1691 1692; mul 335 1312; add 1693 1694; mul 958 1695; add 1684 1696; mul 590 1697; add
1666 1698; mul 145 1699; mul 696 1462; mul 593 1571; sub 1701 1702; sub 1700 1703; mul 47 788; mul 22 1705; add 1704
1706; mul 873 1707; add 1641 1708; sub 1636 1709; input c_q 0; mul 90 1711; le 140 139; le 139 140; add 1713 1714;
div 2 1715; mul 1713 1716; mul 0 90; mul 1717 1718; input c_q 1; mul 1719 1720; sub 1712 1721; mul 90 93; input c_q
2; mul 1723 1724; add 1722 1725; mul 90 97; input c_q 3; mul 1727 1728; add 1726 1729; mul 90 100; add 797 1731;
input c_q 4; mul 1732 1733; sub 1730 1734; mul 102 1732; input c_q 5; mul 1736 1737; add 1735 1738; mul 93 1732;
input c_q 6; mul 1740 1741; sub 1739 1742; mul 97 1732; input c_q 7; mul 1744 1745; sub 1743 1746; le 128 127; le
127 128; add 1748 1749; div 2 1750; mul 1748 1751; mul 132 1732; mul 1752 1753; input c_q 8; mul 1754 1755; add 1747
1756; mul 90 102; input c_q 9; mul 1758 1759; add 1757 1760; mul 102 1758; mul 104 1762; input c_q 10; mul 1763
1764; sub 1761 1765; mul 93 1758; input c_q 11; mul 1767 1768; add 1766 1769; mul 97 1758; input c_q 12; mul 1771
1772; add 1770 1773; add 1710 1774; mul 56 1123; mul 70 1109; add 1776 1777; mul 79 1139; add 1779 1779; sub 1778
1780; mul 89 1781; mul 89 1001; mul 1156 1783; sub 1782 1784; mul 870 1785; mul 1001 1633; add 1786 1787; mul 795
1594; mul 797 1588; add 1789 1790; sub 1788 1791; mul 59 1123; mul 70 1115; add 1793 1794; mul 76 1139; mul 79 1130;
add 1796 1797; sub 1795 1798; mul 89 1799; mul 89 1008; mul 1156 1801; sub 1800 1802; mul 995 1803; mul 1008 1707;
add 1804 1805; add 1792 1806; mul 0 797; mul 1717 1808; mul 1720 1809; mul 797 1711; sub 1810 1811; mul 93 797; mul
1724 1813; sub 1812 1814; mul 97 797; mul 1728 1816; sub 1815 1817; mul 100 797; add 1001 1819; mul 1733 1820; add
1818 1821; mul 102 1820; mul 1737 1823; sub 1822 1824; mul 93 1820; mul 1741 1826; add 1825 1827; mul 97 1820; mul
1745 1829; add 1828 1830; mul 132 1820; mul 1752 1832; mul 1755 1833; sub 1831 1834; mul 102 797; mul 1759 1836; sub
1835 1837; mul 102 1836; mul 104 1839; mul 1764 1840; add 1838 1841; mul 93 1836; mul 1768 1843; sub 1842 1844; mul
97 1836; mul 1772 1846; sub 1845 1847; add 1807 1848; mul 795 1640; mul 873 1588; add 1850 1851; mul 870 1803; mul
1008 1633; add 1853 1854; sub 1852 1855; mul 45 1123; mul 70 1105; add 1857 1858; mul 76 1130; add 1860 1860; sub
1859 1861; mul 89 1862; mul 89 1017; mul 1156 1864; sub 1863 1865; mul 995 1866; mul 1017 1707; add 1867 1868; sub
1856 1869; mul 873 1711; mul 0 873; mul 1717 1872; mul 1720 1873; sub 1871 1874; mul 93 873; mul 1724 1876; add 1875
1877; mul 97 873; mul 1728 1879; add 1878 1880; mul 100 873; add 1008 1882; mul 1733 1883; sub 1881 1884; mul 102
1883; mul 1737 1886; add 1885 1887; mul 93 1883; mul 1741 1889; sub 1888 1890; mul 97 1883; mul 1745 1892; sub 1891
1893; mul 132 1883; mul 1752 1895; mul 1755 1896; add 1894 1897; mul 102 873; mul 1759 1899; add 1898 1900; mul 102
1899; mul 104 1902; mul 1764 1903; sub 1901 1904; mul 93 1899; mul 1768 1906; add 1905 1907; mul 97 1899; mul 1772
1909; add 1908 1910; add 1870 1911; mul 597 1430; mul 560 1467; add 1913 1914; mul 691 1538; mul 673 1564; add 1916
1917; mul 100 129; mul 100 1919; add 141 1920; input p 190; mul 431 501; sub 1923 574; mul 565 1924; mul 501 1925;
mul 431 625; sub 1927 687; mul 678 1928; mul 625 1929; add 1926 1930; mul 431 1931; add 1922 1932; mul 574 1925; mul
687 1929; add 1934 1935; sub 1933 1936; add 1921 1937; sign 0; mul 729 1939; mul 0 1940; add 731 1941; mul 733 739;
mul 739 740; mul 0 739; mul 1944 1945; sub 1943 1946; add 1942 1947; add 1938 1948; add 754 758; add 755 1950; add
757 1951; mul 67 1952; mul 22 1953; add 1949 1954; mul 90 1955; mul 584 1931; input p 191; add 1957 1958; mul 572
1925; mul 685 1929; add 1960 1961; add 1959 1962; sub 1919 1963; mul 41 1952; mul 22 1965; sub 1964 1966; mul 797
1967; add 1956 1968; mul 593 1931; input p 192; add 1970 1971; mul 53 1952; mul 22 1973; add 1972 1974; mul 873
1975; add 1969 1976; neg 1977; mul 1001 1967; mul 797 1955; add 1979 1980; mul 1008 1975; add 1981 1982; mul 873
1955; mul 1008 1967; add 1984 1985; mul 1017 1975; add 1986 1987; neg 1988; mul 560 1924; mul 673 1928; where 1054
1055; where 1063 1064; where 1072 1073; where 1081 1082; where 1090 1091; where 1099 1100; mul 26 503; div 2 14; mul
11 1999; mul 9 2000; mul 9 24; mul 5 9; mul 2002 2003; sub 2001 2004; mul 17 2005; mul 9 9; mul 2003 2007; mul 16
2008; mul 16 17; mul 14 2003; mul 8 2000; add 2011 2012; mul 2010 2013; add 2009 2014; mul 24 2015; sub 2006 2016;
mul 23 2017; mul 1998 2018; mul 9 38; mul 2003 2020; sub 9 2021; mul 17 2022; mul 38 2015; sub 2023 2024; mul 23
2025; add 31 2026; mul 1103 2027; add 2019 2028; mul 22 2029; mul 18 2015; mul 17 2031; mul 19 2015; add 2032 2033;
sub 2030 2034; mul 56 2035; mul 34 1107; mul 22 2037; mul 45 2038; add 2036 2039; mul 53 2027; mul 34 41; add 2041
2042; mul 22 2043; mul 59 2044; add 2045 2045; sub 2040 2046; mul 89 2047; mul 28 1121; mul 22 2049; mul 61 2050;
mul 70 2047; add 2051 2052; mul 28 41; mul 67 2027; add 2054 2055; add 2018 2056; mul 22 2057; mul 81 2058; mul 56
2058; mul 76 2038; add 2060 2061; mul 79 2044; mul 34 67; add 1112 2064; mul 22 2065; mul 59 2066; add 2063 2067;
sub 2062 2068; mul 76 2069; add 2059 2070; sub 2053 2071; mul 86 2066; mul 59 2058; mul 76 2044; add 2074 2075; mul
79 2035; mul 45 2066; add 2077 2078; sub 2076 2079; mul 79 2080; add 2073 2081; add 2072 2082; mul 1120 2083; sub
2048 2084; mul 795 2085; sub 114 107; add 1164 2087; input p 193; mul 35 150; mul 157 2090; add 2089 2091; mul 35
2090; mul 161 2093; add 2092 2094; mul 150 1175; mul 165 2096; add 2095 2097; mul 35 2096; mul 169 2099; add 2098
2100; mul 155 2096; mul 150 166; add 2102 2103; mul 173 2104; add 2101 2105; mul 148 150; mul 188 2107; add 2106
2108; mul 35 2107; mul 192 2110; add 2109 2111; mul 155 2107; mul 150 189; add 2113 2114; mul 196 2115; add 2112
2116; mul 150 201; mul 200 2118; add 2117 2119; input p 194; mul 224 2090; add 2121 2122; mul 227 2093; add 2123
2124; mul 230 2096; add 2125 2126; mul 233 2099; add 2127 2128; mul 236 2104; add 2129 2130; mul 245 2107; add 2131
2132; mul 248 2110; add 2133 2134; mul 251 2115; add 2135 2136; mul 196 2118; add 2137 2138; mul 147 2139; add 2120
2140; le 290 288; le 288 290; add 2142 2143; div 2 2144; mul 2142 2145; le 289 3; le 3 289; add 2147 2148; div 2
2149; mul 2147 2150; mul 2146 2151; constant 1.6666666666666667; mul 294 503; le 140 293; le 293 140; add 2155 2156;
div 2 2157; mul 2155 2158; mul 2152 2159; mul 2154 2160; mul 298 503; le 140 297; le 297 140; add 2163 2164; div 2
2165; mul 2163 2166; mul 2152 2167; mul 2162 2168; add 2161 2169; mul 2153 2170; sub 2152 2171; mul 284 2172; mul
287 2173; mul 303 503; mul 2172 2175; mul 327 2176; add 2174 2177; mul 323 2172; mul 331 2179; add 2178 2180; mul
339 2181; mul 285 2172; mul 344 2183; mul 303 2173; mul 304 2172; add 2185 2186; mul 352 2187; add 2184 2188; mul
323 2173; mul 356 2190; add 2189 2191; mul 303 2176; mul 328 2172; add 2193 2194; mul 364 2195; add 2192 2196; mul
323 2176; mul 368 2198; add 2197 2199; mul 323 2179; mul 372 2201; add 2200 2202; add 2182 2203; mul 383 2204; add
2141 2205; mul 145 2206; mul 144 2207; mul 412 2183; mul 418 2187; add 2209 2210; mul 421 2190; add 2211 2212; mul
424 2195; add 2213 2214; mul 427 2198; add 2215 2216; mul 383 2217; add 28 2218; mul 696 2219; mul 482 2005; mul 479
2022; add 2221 2222; mul 1368 2223; add 32 37; add 30 2225; add 36 2226; mul 104 2227; mul 284 2217; mul 461 2172;
mul 418 2183; mul 450 2187; add 2231 2232; mul 453 2190; add 2233 2234; mul 456 2195; add 2235 2236; mul 459 2198;
add 2237 2238; mul 303 2239; add 2230 2240; add 2229 2241; mul 447 2183; mul 427 2187; add 2243 2244; mul 470 2195;
add 2245 2246; mul 323 2247; add 2242 2248; mul 441 2249; mul 440 2250; add 2228 2251; mul 479 2005; add 2252 2253;
mul 482 2022; sub 2254 2255; mul 1338 2256; add 2224 2257; mul 1371 2258; mul 485 2259; mul 503 2260; mul 1377 2260;
mul 499 2262; mul 1375 2263; neg 2264; mul 503 2265; mul 499 2266; mul 505 2264; sub 2267 2268; sub 2261 2269; mul
502 2270; mul 520 2271; mul 1398 2260; mul 1393 2273; mul 516 2274; mul 514 2275; mul 518 2274; add 2276 2277; mul
508 2278; add 2272 2279; mul 525 2280; mul 530 2260; mul 512 2282; mul 532 2260; add 2283 2284; mul 528 2285; sub
2281 2286; mul 485 2287; mul 555 2260; mul 512 2289; mul 557 2260; add 2290 2291; mul 553 2292; mul 551 2262; mul
498 2294; mul 552 2262; add 2295 2296; mul 498 2297; mul 1425 2262; add 2298 2299; mul 485 2300; mul 559 2301; sub
2293 2302; mul 548 2303; add 2288 2304; mul 563 2303; mul 560 2306; mul 564 2303; add 2307 2308; mul 597 2309; mul
566 2223; sub 2253 2255; mul 491 2312; add 2311 2313; mul 568 2256; mul 484 2223; add 2315 2316; sub 2314 2317; mul
500 2318; mul 485 2264; mul 570 2320; sub 2319 2321; mul 17 2322; mul 571 2015; sub 2323 2324; mul 130 2325; mul 500
2223; mul 491 2320; sub 2327 2328; mul 0 2329; sub 2326 2330; mul 500 2256; mul 484 2320; sub 2332 2333; mul 595
2334; mul 0 2219; mul 581 2239; sub 2160 2168; mul 578 2338; mul 461 2339; sub 2337 2340; mul 440 2341; add 31 2342;
mul 130 2343; add 2336 2344; mul 590 2247; mul 440 2346; add 34 2347; mul 395 2348; add 2345 2349; mul 501 2350; add
2335 2351; add 2331 2352; mul 565 2353; add 2310 2354; add 2305 2355; mul 501 2356; mul 599 2334; add 2357 2358; mul
603 2022; mul 606 2005; sub 2360 2361; mul 1476 2362; mul 603 2005; add 2252 2364; mul 606 2022; add 2365 2366; mul
1474 2367; add 2363 2368; mul 1479 2369; mul 609 2370; mul 503 2371; mul 1485 2371; mul 623 2373; mul 1483 2374; neg
2375; mul 503 2376; mul 623 2377; mul 628 2375; sub 2378 2379; sub 2372 2380; mul 626 2381; mul 640 2382; mul 1506
2371; mul 1501 2384; mul 636 2385; mul 634 2386; mul 638 2385; add 2387 2388; mul 631 2389; add 2383 2390; mul 525
2391; mul 646 2371; mul 632 2393; mul 648 2371; add 2394 2395; mul 644 2396; sub 2392 2397; mul 609 2398; mul 555
2371; mul 632 2400; mul 670 2371; add 2401 2402; mul 668 2403; mul 666 2373; mul 622 2405; mul 667 2373; add 2406
2407; mul 622 2408; mul 1533 2373; add 2409 2410; mul 609 2411; mul 672 2412; sub 2404 2413; mul 664 2414; add 2399
2415; mul 676 2414; mul 673 2417; mul 677 2414; add 2418 2419; mul 691 2420; mul 679 2362; add 2364 2366; mul 615
2423; add 2422 2424; mul 681 2367; sub 2361 2360; mul 608 2427; add 2426 2428; add 2425 2429; mul 624 2430; mul 609
2375; mul 683 2432; sub 2431 2433; mul 17 2434; mul 684 2015; sub 2435 2436; mul 130 2437; mul 624 2362; mul 615
2432; sub 2439 2440; mul 0 2441; sub 2438 2442; mul 624 2367; mul 608 2432; sub 2444 2445; mul 595 2446; mul 625
2350; add 2447 2448; add 2443 2449; mul 678 2450; add 2421 2451; add 2416 2452; mul 625 2453; mul 693 2446; add 2454
2455; add 2359 2456; mul 431 2457; sub 2220 2458; sub 2208 2459; mul 574 2356; mul 599 2329; add 2461 2462; mul 687
2453; mul 693 2441; add 2464 2465; add 2463 2466; sub 2460 2467; sub 2088 2468; mul 784 2022; mul 16 2003; mul 16
780; mul 2013 2472; sub 2471 2473; mul 10 2474; mul 780 2475; mul 781 2474; add 2476 2477; mul 779 2003; mul 9 2479;
mul 9 779; mul 2003 2481; add 2480 2482; sub 2478 2483; mul 3 2484; add 783 2485; mul 38 2486; add 2470 2487; sub
2017 2488; mul 776 2489; mul 130 2015; mul 130 2491; mul 23 2492; mul 786 2493; sub 2490 2494; mul 67 2495; add 1631
2496; mul 784 2005; mul 24 2486; add 2498 2499; add 2025 2500; mul 776 2501; mul 791 2493; sub 2502 2503; sub 2497
2504; mul 22 2505; sub 2469 2506; mul 90 2507; add 2086 2508; mul 89 2069; mul 1592 2083; sub 2510 2511; mul 870
2512; mul 856 2022; mul 17 2514; mul 857 2015; sub 2515 2516; mul 150 2139; mul 801 2173; mul 806 2176; add 2519
2520; mul 809 2179; add 2521 2522; mul 339 2523; mul 352 2183; mul 823 2187; add 2525 2526; mul 826 2190; add 2527
2528; mul 831 2195; add 2529 2530; mul 834 2198; add 2531 2532; mul 837 2201; add 2533 2534; add 2524 2535; mul 581
2536; mul 843 2339; sub 2537 2538; add 2518 2539; mul 145 2540; mul 696 2343; mul 584 2457; sub 2542 2543; sub 2541
2544; mul 572 2356; mul 599 2325; add 2546 2547; mul 685 2453; mul 693 2437; add 2549 2550; add 2548 2551; add 2545
2552; add 118 2553; sub 2517 2554; mul 788 2027; mul 41 2495; add 2556 2557; mul 792 2018; mul 26 2504; add 2559
2560; sub 2558 2561; mul 22 2562; mul 19 2486; mul 784 2031; sub 2564 2565; mul 775 2566; mul 867 2492; sub 2567
2568; sub 2563 2569; sub 2555 2570; mul 797 2571; add 2513 2572; sub 2509 2573; mul 89 2080; mul 1638 2083; sub 2575
2576; mul 995 2577; input p 195; mul 884 2090; add 2579 2580; mul 887 2093; add 2581 2582; mul 890 2096; add 2583
2584; mul 227 2099; add 2585 2586; mul 895 2104; add 2587 2588; mul 157 2107; add 2589 2590; mul 900 2110; add 2591
2592; mul 169 2115; add 2593 2594; mul 257 2118; add 2595 2596; mul 153 2139; add 2597 2598; mul 331 2173; mul 921
2176; add 2600 2601; mul 924 2179; add 2602 2603; mul 339 2604; mul 820 2183; mul 368 2187; add 2606 2607; mul 939
2190; add 2608 2609; mul 945 2195; add 2610 2611; mul 837 2198; add 2612 2613; mul 950 2201; add 2614 2615; add 2605
2616; mul 799 2183; mul 327 2187; add 2618 2619; mul 331 2190; add 2620 2621; mul 971 2195; add 2622 2623; mul 921
2198; add 2624 2625; mul 812 2201; add 2626 2627; mul 958 2628; add 2617 2629; mul 590 2630; add 2599 2631; mul 145
2632; mul 696 2348; mul 593 2457; sub 2634 2635; sub 2633 2636; mul 34 788; mul 53 2495; add 2638 2639; mul 22 2640;
add 2637 2641; mul 873 2642; add 2578 2643; sub 2574 2644; mul 56 2050; mul 70 2038; add 2646 2647; mul 79 2066; add
2649 2649; sub 2648 2650; mul 89 2651; mul 1783 2083; sub 2652 2653; mul 870 2654; mul 1001 2571; add 2655 2656; mul
795 2512; mul 797 2507; add 2658 2659; sub 2657 2660; mul 59 2050; mul 70 2044; add 2662 2663; mul 76 2066; mul 79
2058; add 2665 2666; sub 2664 2667; mul 89 2668; mul 1801 2083; sub 2669 2670; mul 995 2671; mul 1008 2642; add 2672
2673; add 2661 2674; mul 795 2577; mul 873 2507; add 2676 2677; mul 870 2671; mul 1008 2571; add 2679 2680; sub 2678
2681; mul 45 2050; mul 70 2035; add 2683 2684; mul 76 2058; add 2686 2686; sub 2685 2687; mul 89 2688; mul 1864
2083; sub 2689 2690; mul 995 2691; mul 1017 2642; add 2692 2693; sub 2682 2694; mul 597 2303; mul 560 2353; add 2696
2697; mul 691 2414; mul 673 2450; add 2699 2700; input p 196; mul 501 584; add 572 2703; mul 565 2704; mul 501 2705;
mul 584 625; add 685 2707; mul 678 2708; mul 625 2709; add 2706 2710; mul 431 2711; add 2702 2712; mul 574 2705; mul
687 2709; add 2714 2715; sub 2713 2716; sub 1919 2717; add 761 764; add 760 2719; add 763 2720; mul 503 774; mul 23
2722; mul 786 2723; add 2721 2724; mul 67 2725; mul 791 2723; sub 2726 2727; mul 22 2728; sub 2718 2729; mul 90
2730; mul 584 2711; input p 197; add 2732 2733; mul 572 2705; mul 685 2709; add 2735 2736; add 2734 2737; add 129
2738; mul 41 2725; mul 26 2727; sub 2740 2741; mul 22 2742; mul 867 2722; sub 2743 2744; add 2739 2745; mul 797
2746; add 2731 2747; mul 593 2711; input p 198; add 2749 2750; mul 53 2725; mul 22 2752; add 2751 2753; mul 873
2754; sub 2748 2755; mul 1008 2754; mul 1001 2746; mul 797 2730; add 2758 2759; sub 2757 2760; mul 873 2730; mul
1008 2746; add 2762 2763; mul 1017 2754; sub 2764 2765; mul 560 2704; mul 673 2708; input p 199; where 1054 2769;
input p 200; where 1063 2771; input p 201; where 1072 2773; input p 202; where 1081 2775; input p 203; where 1090
2777; input p 204; where 1099 2779; mul 34 1103; mul 22 2781; mul 56 2782; mul 51 1107; mul 22 2784; mul 45 2785;
add 2783 2786; mul 34 53; mul 41 51; add 2788 2789; mul 22 2790; mul 59 2791; add 2792 2792; sub 2787 2793; mul 89
2794; mul 47 1121; mul 22 2796; mul 61 2797; mul 70 2794; add 2798 2799; add 1113 2064; mul 22 2801; mul 81 2802;
mul 56 2802; mul 76 2785; add 2804 2805; mul 79 2791; mul 51 67; mul 47 53; add 2808 2809; mul 22 2810; mul 59 2811;
add 2807 2812; sub 2806 2813; mul 76 2814; add 2803 2815; sub 2800 2816; mul 86 2811; mul 59 2802; mul 76 2791; add
2819 2820; mul 79 2782; mul 45 2811; add 2822 2823; sub 2821 2824; mul 79 2825; add 2818 2826; add 2817 2827; mul
1120 2828; sub 2795 2829; mul 795 2830; input p 205; add 154 155; mul 157 2833; add 2832 2834; mul 35 2833; add 158
2836; mul 161 2837; add 2835 2838; mul 153 1175; mul 165 2840; add 2839 2841; mul 35 2840; add 166 2843; mul 169
2844; add 2842 2845; mul 155 2840; mul 153 166; add 2847 2848; mul 173 2849; add 2846 2850; mul 148 180; add 2851
2852; mul 181 503; mul 184 2854; add 2853 2855; mul 148 153; mul 188 2857; add 2856 2858; mul 35 2857; add 189 2860;
mul 192 2861; add 2859 2862; mul 155 2857; mul 153 189; add 2864 2865; mul 196 2866; add 2863 2867; mul 153 201; mul
200 2869; add 2868 2870; mul 35 503; mul 213 2872; add 210 2873; mul 35 2872; add 214 2875; mul 217 2876; add 2874
2877; input p 206; add 2878 2879; mul 224 2833; add 2880 2881; mul 227 2837; add 2882 2883; mul 230 2840; add 2884
2885; mul 233 2844; add 2886 2887; mul 236 2849; add 2888 2889; mul 148 157; add 2890 2891; mul 161 2854; add 2892
2893; mul 245 2857; add 2894 2895; mul 248 2861; add 2896 2897; mul 251 2866; add 2898 2899; mul 201 257; add 2900
2901; mul 196 2869; add 2902 2903; mul 147 2904; add 2871 2905; le 310 308; le 308 310; add 2907 2908; div 2 2909;
mul 2907 2910; le 309 35; le 35 309; add 2912 2913; div 2 2914; mul 2912 2915; mul 2911 2916; constant 0.625; mul
314 503; le 140 313; le 313 140; add 2920 2921; div 2 2922; mul 2920 2923; mul 2917 2924; mul 2919 2925; mul 318
503; le 140 317; le 317 140; add 2928 2929; div 2 2930; mul 2928 2931; mul 2917 2932; mul 2927 2933; add 2926 2934;
mul 2918 2935; sub 2917 2936; mul 284 2937; mul 307 2938; mul 303 2937; mul 331 2940; add 2939 2941; mul 323 503;
mul 2937 2943; mul 335 2944; add 2942 2945; mul 339 2946; mul 323 2944; mul 336 2937; add 2948 2949; mul 338 2950;
add 2947 2951; mul 285 2937; mul 348 2953; mul 304 2937; mul 356 2955; add 2954 2956; mul 323 2938; mul 324 2937;
add 2958 2959; mul 360 2960; add 2957 2961; mul 328 2937; mul 368 2963; add 2962 2964; mul 323 2940; mul 332 2937;
add 2966 2967; mul 372 2968; add 2965 2969; mul 376 2950; add 2970 2971; add 2952 2972; mul 383 2973; add 2906 2974;
mul 145 2975; mul 144 2976; mul 415 2953; mul 421 2955; add 2978 2979; mul 427 2963; add 2980 2981; mul 383 2982;
add 47 2983; mul 696 2984; add 52 53; add 50 2986; mul 104 2987; mul 284 2982; mul 447 2953; mul 453 2955; add 2990
2991; mul 459 2963; add 2992 2993; mul 303 2994; add 2989 2995; mul 472 2937; add 2996 2997; mul 441 2998; mul 440
2999; add 2988 3000; mul 1338 3001; mul 1371 3002; mul 485 3003; mul 503 3004; mul 1377 3004; mul 499 3006; mul 1375
3007; neg 3008; mul 503 3009; mul 499 3010; mul 505 3008; sub 3011 3012; sub 3005 3013; mul 502 3014; mul 520 3015;
mul 1398 3004; mul 1393 3017; mul 516 3018; mul 514 3019; mul 518 3018; add 3020 3021; mul 508 3022; add 3016 3023;
mul 525 3024; mul 530 3004; mul 512 3026; mul 532 3004; add 3027 3028; mul 528 3029; sub 3025 3030; mul 485 3031;
mul 555 3004; mul 512 3033; mul 557 3004; add 3034 3035; mul 553 3036; mul 551 3006; mul 498 3038; mul 552 3006; add
3039 3040; mul 498 3041; mul 1425 3006; add 3042 3043; mul 485 3044; mul 559 3045; sub 3037 3046; mul 548 3047; add
3032 3048; mul 563 3047; mul 560 3050; mul 564 3047; add 3051 3052; mul 597 3053; mul 485 3008; mul 491 3055; mul 0
3056; mul 568 3001; mul 500 3058; mul 570 3055; add 3059 3060; mul 17 3061; mul 130 3062; sub 3057 3063; mul 500
3001; mul 484 3055; sub 3065 3066; mul 595 3067; mul 0 2984; mul 581 2994; mul 440 3070; add 34 3071; mul 130 3072;
add 3069 3073; sub 2925 2933; mul 587 3075; mul 472 3076; mul 440 3077; sub 51 3078; mul 395 3079; add 3074 3080;
mul 501 3081; add 3068 3082; add 3064 3083; mul 565 3084; add 3054 3085; add 3049 3086; mul 501 3087; mul 599 3067;
add 3088 3089; mul 1474 3001; mul 1479 3091; mul 609 3092; mul 503 3093; mul 1485 3093; mul 623 3095; mul 1483 3096;
neg 3097; mul 503 3098; mul 623 3099; mul 628 3097; sub 3100 3101; sub 3094 3102; mul 626 3103; mul 640 3104; mul
1506 3093; mul 1501 3106; mul 636 3107; mul 634 3108; mul 638 3107; add 3109 3110; mul 631 3111; add 3105 3112; mul
525 3113; mul 646 3093; mul 632 3115; mul 648 3093; add 3116 3117; mul 644 3118; sub 3114 3119; mul 609 3120; mul
555 3093; mul 632 3122; mul 670 3093; add 3123 3124; mul 668 3125; mul 666 3095; mul 622 3127; mul 667 3095; add
3128 3129; mul 622 3130; mul 1533 3095; add 3131 3132; mul 609 3133; mul 672 3134; sub 3126 3135; mul 664 3136; add
3121 3137; mul 676 3136; mul 673 3139; mul 677 3136; add 3140 3141; mul 691 3142; mul 681 3001; mul 624 3144; mul
609 3097; mul 683 3146; sub 3145 3147; mul 17 3148; mul 130 3149; mul 615 3146; mul 0 3151; add 3150 3152; mul 624
3001; mul 608 3146; sub 3154 3155; mul 595 3156; mul 625 3081; add 3157 3158; add 3153 3159; mul 678 3160; add 3143
3161; add 3138 3162; mul 625 3163; mul 693 3156; add 3164 3165; add 3090 3166; mul 431 3167; sub 2985 3168; sub 2977
3169; mul 574 3087; mul 599 3056; sub 3171 3172; mul 687 3163; mul 693 3151; sub 3174 3175; add 3173 3176; sub 3170
3177; add 1706 3178; mul 90 3179; sub 2831 3180; mul 89 2814; mul 1592 2828; sub 3182 3183; mul 870 3184; mul 150
2904; mul 331 2938; mul 809 2940; add 3187 3188; mul 812 2944; add 3189 3190; mul 339 3191; mul 814 2950; add 3192
3193; mul 820 2953; mul 826 2955; add 3195 3196; mul 372 2960; add 3197 3198; mul 834 2963; add 3199 3200; mul 837
2968; add 3201 3202; mul 840 2950; add 3203 3204; add 3194 3205; mul 581 3206; add 3186 3207; mul 145 3208; mul 696
3072; mul 584 3167; sub 3210 3211; sub 3209 3212; mul 572 3087; mul 599 3062; sub 3214 3215; mul 685 3163; mul 693
3149; add 3217 3218; add 3216 3219; add 3213 3220; mul 22 2638; add 3221 3222; mul 797 3223; sub 3185 3224; sub 3181
3225; mul 89 2825; mul 1638 2828; sub 3227 3228; mul 995 3229; mul 876 2872; add 874 3231; mul 879 2876; add 3232
3233; input p 207; add 3234 3235; mul 884 2833; add 3236 3237; mul 887 2837; add 3238 3239; mul 890 2840; add 3240
3241; mul 227 2844; add 3242 3243; mul 895 2849; add 3244 3245; mul 157 2857; add 3246 3247; mul 900 2861; add 3248
3249; mul 169 2866; add 3250 3251; mul 184 201; add 3252 3253; mul 257 2869; add 3254 3255; mul 153 2904; add 3256
3257; mul 918 2938; mul 924 2940; add 3259 3260; mul 927 2944; add 3261 3262; mul 339 3263; mul 929 2950; add 3264
3265; mul 360 2953; mul 939 2955; add 3267 3268; mul 942 2960; add 3269 3270; mul 837 2963; add 3271 3272; mul 950
2968; add 3273 3274; mul 953 2950; add 3275 3276; add 3266 3277; mul 957 2944; mul 980 3279; mul 914 2953; mul 331
2955; add 3281 3282; mul 335 2960; add 3283 3284; mul 921 2963; add 3285 3286; mul 812 2968; add 3287 3288; mul 978
2950; add 3289 3290; mul 958 3291; add 3280 3292; add 3278 3293; mul 590 3294; mul 982 3076; sub 3295 3296; add 3258
3297; mul 145 3298; mul 696 3079; mul 593 3167; sub 3300 3301; sub 3299 3302; mul 51 788; mul 22 3304; add 3303
3305; mul 873 3306; add 3230 3307; sub 3226 3308; mul 56 2797; mul 70 2785; add 3310 3311; mul 79 2811; add 3313
3313; sub 3312 3314; mul 89 3315; mul 1783 2828; sub 3316 3317; mul 870 3318; mul 1001 3223; sub 3319 3320; mul 795
3184; mul 797 3179; sub 3322 3323; sub 3321 3324; mul 59 2797; mul 70 2791; add 3326 3327; mul 76 2811; mul 79 2802;
add 3329 3330; sub 3328 3331; mul 89 3332; mul 1801 2828; sub 3333 3334; mul 995 3335; mul 1008 3306; add 3336 3337;
add 3325 3338; mul 795 3229; mul 873 3179; sub 3340 3341; mul 870 3335; mul 1008 3223; sub 3343 3344; sub 3342 3345;
mul 45 2797; mul 70 2782; add 3347 3348; mul 76 2802; add 3350 3350; sub 3349 3351; mul 89 3352; mul 1864 2828; sub
3353 3354; mul 995 3355; mul 1017 3306; add 3356 3357; sub 3346 3358; mul 597 3047; mul 560 3084; add 3360 3361; mul
691 3136; mul 673 3160; add 3363 3364; mul 501 593; mul 565 3366; mul 501 3367; mul 593 625; mul 678 3369; mul 625
3370; add 3368 3371; mul 584 3372; input p 208; add 3373 3374; mul 572 3367; mul 685 3370; add 3376 3377; add 3375
3378; add 770 771; add 769 3380; mul 41 3381; mul 22 3382; add 3379 3383; mul 797 3384; input p 209; mul 431 3372;
add 3386 3387; mul 574 3367; mul 687 3370; add 3389 3390; sub 3388 3391; mul 67 3381; mul 22 3393; add 3392 3394;
mul 90 3395; sub 3385 3396; mul 593 3372; input p 210; add 3398 3399; mul 53 3381; mul 22 3401; add 3400 3402; mul
873 3403; sub 3397 3404; mul 797 3395; mul 1001 3384; sub 3406 3407; mul 1008 3403; add 3408 3409; mul 1008 3384;
mul 873 3395; sub 3411 3412; mul 1017 3403; sub 3413 3414; mul 560 3366; mul 673 3369; mul 538 560; mul 501 3418;
mul 584 3419; mul 572 3418; add 3420 3421; mul 797 3422; mul 431 3419; mul 574 3418; sub 3424 3425; mul 90 3426; sub
3423 3427; mul 593 3419; mul 873 3429; sub 3428 3430; mul 797 3426; mul 1001 3422; sub 3432 3433; mul 1008 3429; add
3434 3435; mul 1008 3422; mul 873 3426; sub 3437 3438; mul 1017 3429; sub 3439 3440; input p 211; mul 654 673; mul
625 3443; mul 584 3444; mul 685 3443; add 3445 3446; mul 797 3447; mul 431 3444; mul 687 3443; sub 3449 3450; mul 90
3451; sub 3448 3452; mul 593 3444; mul 873 3454; sub 3453 3455; mul 797 3451; mul 1001 3447; sub 3457 3458; mul 1008
3454; add 3459 3460; mul 1008 3447; mul 873 3451; sub 3462 3463; mul 1017 3454; sub 3464 3465; mul 541 560; mul 501
3467; mul 584 3468; mul 572 3467; add 3469 3470; mul 797 3471; mul 431 3468; mul 574 3467; sub 3473 3474; mul 90
3475; sub 3472 3476; mul 593 3468; mul 873 3478; sub 3477 3479; mul 797 3475; mul 1001 3471; sub 3481 3482; mul 1008
3478; add 3483 3484; mul 1008 3471; mul 873 3475; sub 3486 3487; mul 1017 3478; sub 3488 3489; input p 212; mul 657
673; mul 625 3492; mul 584 3493; mul 685 3492; add 3494 3495; mul 797 3496; mul 431 3493; mul 687 3492; sub 3498
3499; mul 90 3500; sub 3497 3501; mul 593 3493; mul 873 3503; sub 3502 3504; mul 797 3500; mul 1001 3496; sub 3506
3507; mul 1008 3503; add 3508 3509; mul 1008 3496; mul 873 3500; sub 3511 3512; mul 1017 3503; sub 3513 3514; mul
545 560; mul 501 3516; mul 584 3517; mul 572 3516; add 3518 3519; mul 797 3520; mul 431 3517; mul 574 3516; sub 3522
3523; mul 90 3524; sub 3521 3525; mul 593 3517; mul 873 3527; sub 3526 3528; mul 797 3524; mul 1001 3520; sub 3530
3531; mul 1008 3527; add 3532 3533; mul 1008 3520; mul 873 3524; sub 3535 3536; mul 1017 3527; sub 3537 3538; input
p 213; mul 661 673; mul 625 3541; mul 584 3542; mul 685 3541; add 3543 3544; mul 797 3545; mul 431 3542; mul 687
3541; sub 3547 3548; mul 90 3549; sub 3546 3550; mul 593 3542; mul 873 3552; sub 3551 3553; mul 797 3549; mul 1001
3545; sub 3555 3556; mul 1008 3552; add 3557 3558; mul 1008 3545; mul 873 3549; sub 3560 3561; mul 1017 3552; sub
3562 3563; mul 90 744; mul 744 797; neg 3566; mul 744 873; input p 214; mul 90 748; mul 748 797; neg 3571; mul 748
873; input p 215; mul 521 522; mul 485 3575; mul 501 3576; mul 522 641; mul 609 3578; mul 625 3579; add 3577 3580;
mul 593 3581; mul 873 3582; mul 574 3576; mul 687 3579; add 3584 3585; mul 431 3581; sub 3586 3587; mul 90 3588; mul
584 3581; mul 572 3576; mul 685 3579; add 3591 3592; add 3590 3593; mul 797 3594; add 3589 3595; sub 3583 3596; mul
1001 3594; mul 797 3588; add 3598 3599; mul 1008 3582; sub 3600 3601; mul 1017 3582; mul 873 3588; mul 1008 3594;
add 3604 3605; sub 3603 3606; input p 216; input p 217; mul 797 3609; mul 90 705; sub 3610 3611; mul 705 797; mul
1001 3609; sub 3613 3614; mul 1008 3609; mul 705 873; sub 3616 3617; input p 218; mul 797 3619; mul 90 708; sub 3620
3621; mul 708 797; mul 1001 3619; sub 3623 3624; mul 1008 3619; mul 708 873; sub 3626 3627; input p 219; mul 797
3629; mul 90 712; sub 3630 3631; mul 712 797; mul 1001 3629; sub 3633 3634; mul 1008 3629; mul 712 873; sub 3636
3637; input p 220; mul 797 3639; mul 90 716; sub 3640 3641; mul 716 797; mul 1001 3639; sub 3643 3644; mul 1008
3639; mul 716 873; sub 3646 3647; input p 221; mul 797 3649; mul 90 720; sub 3650 3651; mul 720 797; mul 1001 3649;
sub 3653 3654; mul 1008 3649; mul 720 873; sub 3656 3657; input p 222; mul 797 3659; mul 90 724; sub 3660 3661; mul
724 797; mul 1001 3659; sub 3663 3664; mul 1008 3659; mul 724 873; sub 3666 3667; mul 102 109; add 92 3669; mul 100
121; sub 3670 3671; mul 527 534; mul 485 3673; mul 574 3674; mul 501 3674; mul 431 3676; sub 3675 3677; sub 3672
3678; mul 90 3679; mul 584 3676; mul 572 3674; add 3681 3682; add 121 3683; mul 797 3684; sub 3680 3685; mul 593
3676; mul 873 3687; add 3686 3688; mul 1001 3684; mul 797 3679; sub 3690 3691; mul 1008 3687; sub 3692 3693; mul 873
3679; mul 1008 3684; sub 3695 3696; mul 1017 3687; add 3697 3698; mul 102 112; add 96 3700; mul 100 124; sub 3701
3702; mul 643 650; mul 609 3704; mul 687 3705; mul 625 3705; mul 431 3707; sub 3706 3708; sub 3703 3709; mul 90
3710; mul 584 3707; mul 685 3705; add 3712 3713; add 124 3714; mul 797 3715; sub 3711 3716; mul 593 3707; mul 873
3718; add 3717 3719; mul 1001 3715; mul 797 3710; sub 3721 3722; mul 1008 3718; sub 3723 3724; mul 873 3710; mul
1008 3715; sub 3726 3727; mul 1017 3718; add 3728 3729; neg 797; neg 1719; neg 1873; neg 1813; neg 1816; neg 1732;
neg 1883; neg 1823; neg 1740; neg 1889; neg 1744; neg 1892; neg 1833; neg 1836; neg 1763; neg 1903; neg 1843; neg
1846; store f 0 0; store f 1 997; store f 2 130; store f 3 1010; store f 4 395; store f 5 1019; store f 6 1023;
store f 7 1026; store f 8 1029; store f 9 1031; store f 10 1034; store f 11 1036; store f 12 1038; store f 13 1040;
store f 14 1043; store f 15 1057; store f 16 1066; store f 17 1075; store f 18 1084; store f 19 1093; store f 20
1102; store a 21 1775; store a 63 1849; store a 105 1912; store a 126 1915; store a 147 1918; store a 168 1915;
store a 189 1918; store a 210 1915; store a 231 1918; store a 252 1037; store a 273 1039; store a 1 2; store a 22
1978; store a 64 1983; store a 106 1989; store a 127 1990; store a 148 1991; store a 169 1990; store a 190 1991;
store a 211 1990; store a 232 1991; store a 316 1992; store a 337 1993; store a 358 1994; store a 379 1995; store a
400 1996; store a 421 1997; store a 23 2645; store a 65 2675; store a 107 2695; store a 128 2698; store a 149 2701;
store a 170 2698; store a 191 2701; store a 212 2698; store a 233 2701; store a 24 2756; store a 45 2; store a 66
2761; store a 108 2766; store a 129 2767; store a 150 2768; store a 171 2767; store a 192 2768; store a 213 2767;
store a 234 2768; store a 318 2770; store a 339 2772; store a 360 2774; store a 381 2776; store a 402 2778; store a
423 2780; store a 25 3309; store a 67 3339; store a 109 3359; store a 130 3362; store a 151 3365; store a 172 3362;
store a 193 3365; store a 214 3362; store a 235 3365; store a 26 3405; store a 68 3410; store a 89 2; store a 110
3415; store a 131 3416; store a 152 3417; store a 173 3416; store a 194 3417; store a 215 3416; store a 236 3417;
store a 27 3431; store a 69 3436; store a 111 3441; store a 132 3442; store a 28 3456; store a 70 3461; store a 112
3466; store a 154 3442; store a 29 3480; store a 71 3485; store a 113 3490; store a 176 3491; store a 30 3505; store
a 72 3510; store a 114 3515; store a 198 3491; store a 31 3529; store a 73 3534; store a 115 3539; store a 220 3540;
store a 32 3554; store a 74 3559; store a 116 3564; store a 242 3540; store a 33 3565; store a 75 3567; store a 117
3568; store a 264 3569; store a 34 3570; store a 76 3572; store a 118 3573; store a 286 3574; store a 35 3597; store
a 77 3602; store a 119 3607; store a 308 3608; store a 36 3612; store a 78 3615; store a 120 3618; store a 37 3622;
store a 79 3625; store a 121 3628; store a 38 3632; store a 80 3635; store a 122 3638; store a 39 3642; store a 81
3645; store a 123 3648; store a 40 3652; store a 82 3655; store a 124 3658; store a 41 3662; store a 83 3665; store
a 125 3668; store b 2 3689; store b 6 3694; store b 10 3699; store b 3 3720; store b 7 3725; store b 11 3730; store
by_c 13 90; store by_c 39 3731; store by_c 65 873; store by_c 14 3732; store by_c 40 1809; store by_c 66 3733; store
by_c 15 1723; store by_c 41 3734; store by_c 67 1876; store by_c 16 1727; store by_c 42 3735; store by_c 68 1879;
store by_c 17 3736; store by_c 43 1820; store by_c 69 3737; store by_c 18 1736; store by_c 44 3738; store by_c 70
1886; store by_c 19 3739; store by_c 45 1826; store by_c 71 3740; store by_c 20 3741; store by_c 46 1829; store by_c
72 3742; store by_c 21 1754; store by_c 47 3743; store by_c 73 1896; store by_c 22 1758; store by_c 48 3744; store
by_c 74 1899; store by_c 23 3745; store by_c 49 1840; store by_c 75 3746; store by_c 24 1767; store by_c 50 3747;
store by_c 76 1906; store by_c 25 1771; store by_c 51 3748; store by_c 77 1909
    """,
)

BY_CONSTANTS = Graph(
    {'x': 15, 'u': 2, 'c': 13, 'z': 6, 'p': 245},
    {'by_k': 2394},
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
210; mul 207 211; add 17 212; mul 201 213; input p 94; input x 14; mul 215 216; sub 17 217; mul 214 218; input u 0;
input p 95; mul 220 221; input p 96; input p 97; mul 205 224; add 223 225; mul 205 226; add 17 227; mul 222 228; sub
219 229; mul 178 230; input p 98; input x 6; mul 232 233; input p 99; input x 8; mul 235 236; add 234 237; input p
100; input x 10; mul 239 240; add 238 241; constant -0.5; mul 191 243; mul 191 244; mul 191 245; mul 178 246; input
p 101; input p 102; mul 205 249; add 248 250; mul 205 251; add 17 252; mul 247 253; mul 242 254; add 231 255; input
p 103; mul 254 257; mul 254 258; input x 3; mul 163 169; div 17 261; mul 164 262; sub 172 176; mul 184 264; add 179
182; mul 177 266; sub 265 267; mul 193 268; mul 263 269; mul 260 270; input x 1; mul 184 193; mul 272 273; sub 271
274; constant 5.714285714285714; add 10 14; mul 276 277; sub 17 278; mul 131 279; add 82 280; mul 272 281; constant
3.3333333333333335; add 32 36; mul 283 284; sub 17 285; mul 150 286; mul 102 287; add 90 288; mul 260 289; add 282
290; input x 5; mul 71 102; add 98 293; mul 292 294; add 291 295; mul 194 296; add 275 297; mul 259 298; add 256
299; mul 194 300; input p 104; add 157 302; input p 105; mul 170 304; add 303 305; input p 106; mul 174 307; add 306
308; input p 107; mul 174 304; mul 170 307; input p 108; sub 312 313; sub 311 314; sub 315 2; mul 316 316; mul 309
309; add 317 318; sqrt 319; mul 310 320; sqrt 321; div 17 322; mul 323 323; mul 310 324; mul 309 325; input p 109;
mul 196 321; mul 196 324; mul 324 329; sub 328 330; mul 327 331; sub 321 204; max 203 333; min 202 334; input p 110;
input p 111; mul 335 337; add 336 338; mul 335 339; add 17 340; mul 332 341; mul 218 342; input u 1; input p 112;
mul 344 345; input p 113; input p 114; mul 333 348; add 347 349; mul 333 350; add 17 351; mul 346 352; sub 343 353;
mul 310 354; input p 115; input x 7; mul 356 357; input p 116; input x 9; mul 359 360; add 358 361; input p 117;
input x 11; mul 363 364; add 362 365; mul 243 323; mul 323 367; mul 323 368; mul 310 369; mul 249 333; add 248 371;
mul 333 372; add 17 373; mul 370 374; mul 366 375; add 355 376; input p 118; mul 375 378; mul 375 379; add 305 308;
mul 316 381; sub 312 311; mul 309 383; add 382 384; mul 325 385; mul 263 386; mul 260 387; mul 316 325; mul 272 389;
sub 388 390; mul 296 326; add 391 392; mul 380 393; add 377 394; mul 326 395; add 301 396; sub 72 397; input p 4;
input p 5; mul 174 263; mul 400 401; add 90 402; mul 98 403; mul 399 404; input p 13; mul 170 263; mul 400 407; mul
82 403; add 408 409; mul 399 410; add 406 411; mul 405 412; input p 0; input p 3; mul 263 415; mul 263 416; add 414
417; mul 408 408; mul 403 403; add 419 420; mul 399 421; add 418 422; mul 82 98; mul 399 424; mul 423 425; sub 413
426; input p 9; mul 98 98; mul 399 429; add 428 430; mul 423 431; mul 405 405; sub 432 433; mul 82 82; add 17 435;
mul 399 436; mul 434 437; mul 412 431; mul 405 425; sub 439 440; mul 412 441; sub 438 442; mul 425 427; add 443 444;
div 17 445; mul 427 446; mul 398 447; mul 441 446; mul 387 449; mul 434 446; mul 389 451; add 450 452; mul 294 447;
mul 289 449; sub 454 455; mul 281 451; add 456 457; mul 326 458; sub 453 459; mul 380 460; mul 326 461; mul 270 449;
mul 273 451; add 463 464; mul 194 458; sub 465 466; mul 259 467; mul 194 468; add 462 469; mul 292 470; add 448 471;
mul 71 472; mul 296 461; mul 395 458; sub 474 475; mul 325 476; mul 395 449; mul 260 461; add 478 479; mul 263 480;
mul 325 481; mul 383 482; add 477 483; mul 196 309; mul 196 320; div 17 486; mul 393 460; mul 379 488; mul 375 488;
mul 378 490; add 489 491; mul 366 460; add 492 493; mul 370 494; mul 372 495; mul 333 495; mul 249 497; add 496 498;
mul 310 460; mul 346 500; mul 350 501; sub 499 502; mul 333 501; mul 348 504; sub 503 505; le 203 333; le 333 203;
add 507 508; div 17 509; mul 507 510; le 334 202; le 202 334; add 512 513; div 17 514; mul 512 515; mul 218 500; mul
332 517; mul 339 518; mul 335 518; mul 337 520; add 519 521; mul 516 522; mul 511 523; add 506 524; mul 196 322; div
17 526; mul 323 369; mul 374 494; mul 310 529; mul 528 530; mul 323 530; mul 369 532; add 531 533; mul 323 532; mul
368 535; add 534 536; mul 196 323; mul 309 476; mul 395 451; mul 272 461; sub 540 541; mul 316 542; add 539 543; mul
385 481; add 544 545; mul 310 546; mul 341 517; mul 327 548; mul 329 549; sub 547 550; mul 324 549; neg 552; mul 196
553; add 551 554; mul 538 555; mul 324 556; add 537 557; mul 527 558; sub 525 559; mul 196 549; add 560 561; mul 310
562; mul 487 563; mul 485 564; add 484 565; sub 473 566; mul 260 470; mul 398 449; sub 568 569; mul 287 570; add 567
571; mul 296 468; mul 300 458; sub 573 574; mul 193 575; mul 300 449; mul 260 468; add 577 578; mul 263 579; mul 193
580; mul 266 581; sub 576 582; mul 177 196; mul 188 196; div 17 585; mul 298 467; mul 258 587; mul 254 587; mul 257
589; add 588 590; mul 242 467; add 591 592; mul 247 593; mul 251 594; mul 205 594; mul 249 596; add 595 597; mul 178
467; mul 222 599; mul 226 600; sub 598 601; mul 205 600; mul 224 603; sub 602 604; le 203 205; le 205 203; add 606
607; div 17 608; mul 606 609; le 206 202; le 202 206; add 611 612; div 17 613; mul 611 614; mul 218 599; mul 201
616; mul 211 617; mul 207 617; mul 209 619; add 618 620; mul 615 621; mul 610 622; add 605 623; mul 190 196; div 17
625; mul 191 246; mul 253 593; mul 178 628; mul 627 629; mul 191 629; mul 246 631; add 630 632; mul 191 631; mul 245
634; add 633 635; mul 191 196; mul 177 575; mul 300 451; mul 272 468; sub 639 640; mul 184 641; add 638 642; mul 268
580; add 643 644; mul 178 645; mul 213 616; mul 195 647; mul 198 648; sub 646 649; mul 192 648; neg 651; mul 196
652; add 650 653; mul 637 654; mul 192 655; add 636 656; mul 626 657; sub 624 658; mul 196 648; add 659 660; mul 178
661; mul 586 662; mul 584 663; add 583 664; add 566 665; mul 155 666; add 572 667; mul 3 4; le 1 4; le 4 1; add 670
671; div 17 672; mul 670 673; le 5 0; le 0 5; add 675 676; div 17 677; mul 675 678; mul 102 666; mul 103 680; mul
131 681; mul 102 570; mul 286 683; mul 41 681; add 684 685; mul 142 686; mul 398 451; mul 272 470; add 688 689; mul
279 690; mul 20 681; add 691 692; mul 123 693; add 687 694; mul 114 695; mul 102 472; mul 70 697; mul 114 681; add
698 699; mul 48 700; mul 139 686; add 701 702; mul 119 693; add 703 704; mul 41 705; add 696 706; mul 41 707; add
682 708; mul 23 700; mul 133 686; add 710 711; mul 104 693; add 712 713; mul 21 714; add 709 715; mul 20 196; mul 43
686; mul 116 693; add 718 719; mul 114 720; mul 43 700; mul 119 686; add 722 723; mul 106 693; add 724 725; mul 41
726; add 721 727; mul 20 714; add 728 729; mul 717 730; add 716 731; le 7 13; le 13 7; add 733 734; div 17 735; mul
733 736; mul 14 196; constant 2.857142857142857; mul 732 739; mul 738 740; mul 131 690; mul 276 742; sub 741 743;
mul 737 744; sub 732 745; le 7 9; le 9 7; add 747 748; div 17 749; mul 747 750; mul 10 196; mul 740 752; add 743
753; mul 751 754; sub 746 755; mul 679 756; mul 674 757; mul 669 758; sub 668 759; sub 760 665; input p 18; input p
19; input p 20; mul 4 764; input p 21; mul 27 766; add 765 767; input p 22; mul 59 769; add 768 770; mul 763 771;
input p 23; mul 59 771; mul 773 774; add 772 775; input p 24; mul 59 774; mul 777 778; add 776 779; input p 25; mul
771 771; mul 781 782; add 780 783; input p 26; mul 59 782; mul 785 786; add 784 787; input p 27; mul 771 782; mul
789 790; add 788 791; input p 28; mul 4 793; add 792 794; input p 29; mul 4 59; mul 796 797; add 795 798; input p
30; mul 59 797; mul 800 801; add 799 802; input p 31; mul 4 771; mul 804 805; add 803 806; input p 32; mul 59 805;
mul 808 809; add 807 810; input p 33; mul 771 805; mul 812 813; add 811 814; input p 34; mul 4 4; mul 771 817; mul
816 818; add 815 819; input p 35; mul 4 817; mul 821 822; add 820 823; input p 36; input p 37; mul 59 826; add 825
827; input p 38; mul 59 59; mul 829 830; add 828 831; input p 39; mul 59 830; mul 833 834; add 832 835; input p 40;
mul 771 837; add 836 838; input p 41; mul 774 840; add 839 841; input p 42; mul 778 843; add 842 844; input p 43;
mul 782 846; add 845 847; input p 44; mul 786 849; add 848 850; input p 45; mul 790 852; add 851 853; mul 4 763; add
854 855; mul 773 797; add 856 857; mul 777 801; add 858 859; input p 46; mul 805 861; add 860 862; input p 47; mul
809 864; add 863 865; input p 48; mul 813 867; add 866 868; input p 49; mul 817 870; add 869 871; input p 50; mul 59
817; mul 873 874; add 872 875; mul 812 818; add 876 877; input p 51; mul 822 879; add 878 880; mul 764 881; add 824
882; input p 52; mul 21 884; input p 53; mul 46 886; add 885 887; input p 54; mul 20 114; mul 889 890; add 888 891;
input p 55; mul 51 893; add 892 894; input p 56; mul 41 114; mul 896 897; add 895 898; input p 57; mul 114 114; mul
900 901; add 899 902; mul 114 901; mul 903 904; input p 58; mul 22 906; input p 59; mul 42 908; add 907 909; input p
60; mul 115 911; add 910 912; input p 61; mul 47 914; add 913 915; input p 62; mul 122 917; add 916 918; input p 63;
mul 114 890; mul 920 921; add 919 922; input p 64; mul 52 924; add 923 925; input p 65; mul 129 927; add 926 928;
input p 66; mul 114 897; mul 930 931; add 929 932; input p 67; mul 904 934; add 933 935; add 905 936; mul 279 937;
add 883 938; mul 762 939; input p 68; constant 12.0; mul 3 272; mul 942 943; constant -6.0; mul 764 943; mul 260
766; add 946 947; mul 292 769; add 948 949; mul 945 950; add 944 951; mul 941 952; mul 943 945; constant 4.0; mul
950 955; add 954 956; mul 941 957; mul 764 958; add 953 959; add 940 960; mul 3 961; mul 3 962; mul 451 963; add 761
964; mul 3 943; mul 449 766; mul 447 769; sub 967 968; mul 3 451; mul 764 970; sub 969 971; mul 941 972; mul 945
973; mul 955 973; mul 941 970; mul 945 976; sub 975 977; mul 764 978; add 974 979; mul 942 976; sub 980 981; mul 966
982; sub 965 983; input p 137; mul 449 762; mul 286 986; mul 985 987; input p 167; constant 3.0; mul 901 990; mul
447 762; mul 70 992; mul 991 993; mul 989 994; input p 161; mul 993 996; add 995 997; sub 988 998; mul 762 970; mul
279 1000; mul 906 1001; sub 999 1002; mul 21 1003; mul 904 987; mul 896 1005; input p 157; mul 904 993; mul 1007
1008; sub 1006 1009; mul 930 987; mul 900 994; input p 163; mul 993 1013; add 1012 1014; sub 1011 1015; mul 920
1001; sub 1016 1017; mul 114 1018; add 1010 1019; mul 904 1001; mul 889 1021; sub 1020 1022; mul 114 1023; add 1004
1024; input p 133; mul 1005 1026; mul 896 1008; sub 1027 1028; input p 140; mul 987 1030; mul 896 994; input p 162;
mul 993 1033; add 1032 1034; sub 1031 1035; mul 917 1001; sub 1036 1037; mul 114 1038; add 1029 1039; input p 139;
mul 987 1041; mul 893 994; mul 927 993; add 1043 1044; sub 1042 1045; mul 914 1001; sub 1046 1047; mul 41 1048; add
1040 1049; mul 886 1021; sub 1050 1051; mul 41 1052; add 1025 1053; input p 132; mul 1005 1055; input p 156; mul
1008 1057; sub 1056 1058; input p 138; mul 987 1060; mul 994 1057; mul 920 993; add 1062 1063; sub 1061 1064; mul
911 1001; sub 1065 1066; mul 114 1067; add 1059 1068; mul 914 987; mul 994 1055; mul 993 1060; add 1071 1072; sub
1070 1073; mul 908 1001; sub 1074 1075; mul 41 1076; add 1069 1077; mul 20 1003; add 1078 1079; mul 884 1021; sub
1080 1081; mul 717 1082; add 1054 1083; mul 937 1000; mul 276 1085; mul 739 1084; mul 738 1087; add 1086 1088; mul
737 1089; sub 1084 1090; mul 752 1087; sub 1086 1092; mul 751 1093; add 1091 1094; mul 679 1095; mul 674 1096; mul
669 1097; sub 984 1098; mul 766 986; mul 769 992; sub 1100 1101; mul 764 1000; sub 1102 1103; mul 879 1104; mul 817
1105; mul 4 196; mul 873 992; mul 771 1108; mul 1107 1109; mul 800 992; mul 59 1111; mul 1107 1112; add 1110 1113;
input p 155; mul 992 1115; mul 1107 1116; add 1114 1117; mul 785 992; mul 771 1119; mul 771 1120; add 1118 1121;
input p 154; mul 992 1123; mul 59 1124; mul 771 1125; add 1122 1126; mul 773 992; mul 771 1128; add 1127 1129; sub
1106 1130; mul 4 1105; mul 1107 1132; add 1131 1133; mul 812 1104; mul 771 1135; mul 1107 1136; add 1134 1137; mul
873 1104; mul 59 1139; mul 1107 1140; add 1138 1141; mul 870 1104; mul 1107 1143; add 1142 1144; mul 867 1104; mul
771 1146; mul 771 1147; add 1145 1148; mul 864 1104; mul 59 1150; mul 771 1151; add 1149 1152; mul 861 1104; mul 771
1154; add 1153 1155; mul 777 1104; mul 59 1157; mul 59 1158; add 1156 1159; mul 773 1104; mul 59 1161; add 1160
1162; mul 763 1104; add 1163 1164; mul 821 1000; mul 817 1166; sub 1165 1167; mul 4 1166; mul 1107 1169; sub 1168
1170; mul 816 1000; mul 771 1172; mul 1107 1173; sub 1171 1174; mul 812 1000; mul 771 1176; mul 771 1177; sub 1175
1178; mul 808 1000; mul 59 1180; mul 771 1181; sub 1179 1182; mul 804 1000; mul 771 1184; sub 1183 1185; mul 800
1000; mul 59 1187; mul 59 1188; sub 1186 1189; mul 796 1000; mul 59 1191; sub 1190 1192; mul 793 1000; sub 1193
1194; mul 817 1135; mul 817 1108; mul 805 1119; add 1197 1198; mul 4 1120; add 1199 1200; mul 4 1125; add 1201 1202;
mul 4 1128; add 1203 1204; input p 153; mul 992 1206; mul 782 1207; add 1205 1208; mul 196 771; mul 771 1207; mul
1210 1211; add 1209 1212; mul 843 992; mul 59 1214; mul 1210 1215; add 1213 1216; input p 152; mul 992 1218; mul
1210 1219; add 1217 1220; input p 151; mul 992 1222; mul 59 1223; mul 59 1224; add 1221 1225; input p 150; mul 992
1227; mul 59 1228; add 1226 1229; mul 826 992; add 1230 1231; sub 1196 1232; mul 805 1146; add 1233 1234; mul 4
1147; add 1235 1236; mul 4 1151; add 1237 1238; mul 4 1154; add 1239 1240; mul 852 1104; mul 782 1242; add 1241
1243; mul 771 1242; mul 1210 1245; add 1244 1246; mul 849 1104; mul 59 1248; mul 1210 1249; add 1247 1250; mul 846
1104; mul 1210 1252; add 1251 1253; mul 843 1104; mul 59 1255; mul 59 1256; add 1254 1257; mul 840 1104; mul 59
1259; add 1258 1260; mul 837 1104; add 1261 1262; mul 817 1172; sub 1263 1264; mul 805 1176; sub 1265 1266; mul 4
1177; sub 1267 1268; mul 4 1181; sub 1269 1270; mul 4 1184; sub 1271 1272; mul 789 1000; mul 782 1274; sub 1273
1275; mul 771 1274; mul 1210 1277; sub 1276 1278; mul 785 1000; mul 59 1280; mul 1210 1281; sub 1279 1282; mul 781
1000; mul 1210 1284; sub 1283 1285; mul 777 1000; mul 59 1287; mul 59 1288; sub 1286 1289; mul 773 1000; mul 59
1291; sub 1290 1292; mul 763 1000; sub 1293 1294; mul 764 1295; add 1195 1296; mul 669 1297; sub 1099 1298; input p
223; input c 4; input p 14; mul 2 1302; sub 27 1303; input c 5; mul 1304 1305; sub 1301 1306; input c 6; mul 220
1308; add 1307 1309; input c 7; mul 344 1311; add 1310 1312; input c 8; input p 15; max 1314 1315; mul 272 1302; sub
260 1317; mul 1316 1318; sub 1313 1319; mul 451 1320; mul 451 1302; add 449 1322; mul 1316 1323; mul 272 1324; add
1321 1325; mul 1305 1323; input c 9; input c 10; mul 74 1329; mul 1304 1330; sub 1328 1331; input c 11; mul 220
1333; add 1332 1334; input c 12; mul 344 1336; add 1335 1337; mul 451 1338; add 1327 1339; mul 451 1304; mul 1330
1341; sub 1340 1342; mul 2 1343; add 1326 1344; mul 1300 1345; add 1299 1346; mul 431 437; mul 425 425; sub 1348
1349; mul 446 1350; mul 398 1351; mul 387 1351; mul 389 449; add 1353 1354; mul 289 1351; mul 405 437; mul 412 425;
sub 1357 1358; mul 446 1359; mul 294 1360; sub 1356 1361; mul 281 449; sub 1362 1363; mul 326 1364; add 1355 1365;
mul 380 1366; mul 326 1367; mul 270 1351; mul 273 449; add 1369 1370; mul 194 1364; add 1371 1372; mul 259 1373; mul
194 1374; add 1368 1375; mul 260 1376; sub 1352 1377; mul 287 1378; mul 310 1366; mul 346 1380; mul 350 1381; mul
393 1366; mul 379 1383; mul 375 1383; mul 378 1385; add 1384 1386; mul 366 1366; add 1387 1388; mul 370 1389; mul
372 1390; mul 333 1390; mul 249 1392; add 1391 1393; sub 1382 1394; mul 333 1381; mul 348 1396; add 1395 1397; mul
218 1380; mul 332 1399; mul 339 1400; mul 335 1400; mul 337 1402; add 1401 1403; mul 516 1404; mul 511 1405; sub
1398 1406; mul 374 1389; mul 310 1408; mul 528 1409; mul 323 1409; mul 369 1411; add 1410 1412; mul 323 1411; mul
368 1414; add 1413 1415; mul 272 1367; sub 1417 478; mul 316 1418; mul 395 1364; mul 296 1367; add 1420 1421; mul
309 1422; sub 1419 1423; mul 395 1351; mul 260 1367; add 1425 1426; mul 263 1427; mul 385 1428; sub 1424 1429; mul
310 1430; mul 341 1399; mul 327 1432; mul 329 1433; add 1431 1434; mul 324 1433; mul 196 1436; add 1435 1437; mul
538 1438; mul 324 1439; sub 1416 1440; mul 527 1441; add 1407 1442; neg 1433; mul 196 1444; add 1443 1445; mul 310
1446; mul 487 1447; mul 485 1448; mul 325 1422; mul 325 1428; mul 383 1451; add 1450 1452; sub 1449 1453; mul 398
1360; mul 292 1376; add 1455 1456; mul 71 1457; add 1454 1458; sub 1379 1459; mul 300 1351; mul 260 1374; add 1461
1462; mul 263 1463; mul 193 1464; mul 266 1465; mul 300 1364; mul 296 1374; add 1467 1468; mul 193 1469; sub 1466
1470; mul 178 1373; mul 222 1472; mul 226 1473; mul 298 1373; mul 258 1475; mul 254 1475; mul 257 1477; add 1476
1478; mul 242 1373; add 1479 1480; mul 247 1481; mul 251 1482; mul 205 1482; mul 249 1484; add 1483 1485; sub 1474
1486; mul 205 1473; mul 224 1488; add 1487 1489; mul 218 1472; mul 201 1491; mul 211 1492; mul 207 1492; mul 209
1494; add 1493 1495; mul 615 1496; mul 610 1497; sub 1490 1498; mul 253 1481; mul 178 1500; mul 627 1501; mul 191
1501; mul 246 1503; add 1502 1504; mul 191 1503; mul 245 1506; add 1505 1507; mul 272 1374; sub 1509 577; mul 184
1510; mul 177 1469; sub 1511 1512; mul 268 1464; sub 1513 1514; mul 178 1515; mul 213 1491; mul 195 1517; mul 198
1518; add 1516 1519; mul 192 1518; mul 196 1521; add 1520 1522; mul 637 1523; mul 192 1524; sub 1508 1525; mul 626
1526; add 1499 1527; neg 1518; mul 196 1529; add 1528 1530; mul 178 1531; mul 586 1532; mul 584 1533; add 1471 1534;
add 1454 1535; mul 155 1536; add 1460 1537; mul 102 1536; mul 103 1539; mul 131 1540; mul 102 1378; mul 286 1542;
mul 41 1540; add 1543 1544; mul 142 1545; mul 20 1540; mul 272 1376; add 569 1548; mul 279 1549; sub 1547 1550; mul
123 1551; add 1546 1552; mul 114 1553; mul 114 1540; mul 102 1457; mul 70 1556; sub 1555 1557; mul 48 1558; mul 139
1545; add 1559 1560; mul 119 1551; add 1561 1562; mul 41 1563; add 1554 1564; mul 41 1565; add 1541 1566; mul 23
1558; mul 133 1545; add 1568 1569; mul 104 1551; add 1570 1571; mul 21 1572; add 1567 1573; mul 43 1545; mul 116
1551; add 1575 1576; mul 114 1577; mul 43 1558; mul 119 1545; add 1579 1580; mul 106 1551; add 1581 1582; mul 41
1583; add 1578 1584; mul 20 1572; add 1585 1586; mul 717 1587; add 1574 1588; mul 131 1549; mul 276 1590; mul 739
1589; mul 738 1592; add 1591 1593; mul 737 1594; sub 1589 1595; mul 752 1592; sub 1591 1597; mul 751 1598; add 1596
1599; mul 679 1600; mul 674 1601; mul 669 1602; sub 1538 1603; sub 1604 1535; mul 449 963; sub 1605 1606; mul 769
1360; mul 766 1351; sub 1608 1609; mul 3 449; mul 764 1611; add 1610 1612; mul 941 1613; mul 945 1614; mul 955 1614;
mul 941 1611; mul 945 1617; add 1616 1618; mul 764 1619; add 1615 1620; mul 942 1617; add 1621 1622; mul 966 1623;
sub 1607 1624; mul 762 1360; mul 70 1626; mul 991 1627; mul 989 1628; mul 996 1627; add 1629 1630; mul 762 1351; mul
286 1632; mul 985 1633; sub 1631 1634; mul 762 1611; mul 279 1636; mul 906 1637; add 1635 1638; mul 21 1639; mul 904
1627; mul 1007 1641; mul 904 1633; mul 896 1643; sub 1642 1644; mul 900 1628; mul 1013 1627; add 1646 1647; mul 930
1633; sub 1648 1649; mul 920 1637; add 1650 1651; mul 114 1652; add 1645 1653; mul 904 1637; mul 889 1655; add 1654
1656; mul 114 1657; add 1640 1658; mul 896 1641; mul 1026 1643; sub 1660 1661; mul 896 1628; mul 1033 1627; add 1663
1664; mul 1030 1633; sub 1665 1666; mul 917 1637; add 1667 1668; mul 114 1669; add 1662 1670; mul 893 1628; mul 927
1627; add 1672 1673; mul 1041 1633; sub 1674 1675; mul 914 1637; add 1676 1677; mul 41 1678; add 1671 1679; mul 886
1655; add 1680 1681; mul 41 1682; add 1659 1683; mul 1057 1641; mul 1055 1643; sub 1685 1686; mul 1057 1628; mul 920
1627; add 1688 1689; mul 1060 1633; sub 1690 1691; mul 911 1637; add 1692 1693; mul 114 1694; add 1687 1695; mul
1055 1628; mul 1060 1627; add 1697 1698; mul 914 1633; sub 1699 1700; mul 908 1637; add 1701 1702; mul 41 1703; add
1696 1704; mul 20 1639; add 1705 1706; mul 884 1655; add 1707 1708; mul 717 1709; add 1684 1710; mul 739 1711; mul
738 1712; mul 937 1636; mul 276 1714; sub 1713 1715; mul 737 1716; sub 1711 1717; mul 752 1712; add 1715 1719; mul
751 1720; sub 1718 1721; mul 679 1722; mul 674 1723; mul 669 1724; sub 1625 1725; mul 873 1626; mul 771 1727; mul
1107 1728; mul 800 1626; mul 59 1730; mul 1107 1731; add 1729 1732; mul 1115 1626; mul 1107 1734; add 1733 1735; mul
785 1626; mul 771 1737; mul 771 1738; add 1736 1739; mul 1123 1626; mul 59 1741; mul 771 1742; add 1740 1743; mul
773 1626; mul 771 1745; add 1744 1746; mul 769 1626; mul 766 1632; sub 1748 1749; mul 764 1636; add 1750 1751; mul
879 1752; mul 817 1753; add 1747 1754; mul 4 1753; mul 1107 1756; add 1755 1757; mul 812 1752; mul 771 1759; mul
1107 1760; add 1758 1761; mul 873 1752; mul 59 1763; mul 1107 1764; add 1762 1765; mul 870 1752; mul 1107 1767; add
1766 1768; mul 867 1752; mul 771 1770; mul 771 1771; add 1769 1772; mul 864 1752; mul 59 1774; mul 771 1775; add
1773 1776; mul 861 1752; mul 771 1778; add 1777 1779; mul 777 1752; mul 59 1781; mul 59 1782; add 1780 1783; mul 773
1752; mul 59 1785; add 1784 1786; mul 763 1752; add 1787 1788; mul 821 1636; mul 817 1790; add 1789 1791; mul 4
1790; mul 1107 1793; add 1792 1794; mul 816 1636; mul 771 1796; mul 1107 1797; add 1795 1798; mul 812 1636; mul 771
1800; mul 771 1801; add 1799 1802; mul 808 1636; mul 59 1804; mul 771 1805; add 1803 1806; mul 804 1636; mul 771
1808; add 1807 1809; mul 800 1636; mul 59 1811; mul 59 1812; add 1810 1813; mul 796 1636; mul 59 1815; add 1814
1816; mul 793 1636; add 1817 1818; mul 817 1727; mul 805 1737; add 1820 1821; mul 4 1738; add 1822 1823; mul 4 1742;
add 1824 1825; mul 4 1745; add 1826 1827; mul 1206 1626; mul 782 1829; add 1828 1830; mul 771 1829; mul 1210 1832;
add 1831 1833; mul 843 1626; mul 59 1835; mul 1210 1836; add 1834 1837; mul 1218 1626; mul 1210 1839; add 1838 1840;
mul 1222 1626; mul 59 1842; mul 59 1843; add 1841 1844; mul 1227 1626; mul 59 1846; add 1845 1847; mul 826 1626; add
1848 1849; mul 817 1759; add 1850 1851; mul 805 1770; add 1852 1853; mul 4 1771; add 1854 1855; mul 4 1775; add 1856
1857; mul 4 1778; add 1858 1859; mul 852 1752; mul 782 1861; add 1860 1862; mul 771 1861; mul 1210 1864; add 1863
1865; mul 849 1752; mul 59 1867; mul 1210 1868; add 1866 1869; mul 846 1752; mul 1210 1871; add 1870 1872; mul 843
1752; mul 59 1874; mul 59 1875; add 1873 1876; mul 840 1752; mul 59 1878; add 1877 1879; mul 837 1752; add 1880
1881; mul 817 1796; add 1882 1883; mul 805 1800; add 1884 1885; mul 4 1801; add 1886 1887; mul 4 1805; add 1888
1889; mul 4 1808; add 1890 1891; mul 789 1636; mul 782 1893; add 1892 1894; mul 771 1893; mul 1210 1896; add 1895
1897; mul 785 1636; mul 59 1899; mul 1210 1900; add 1898 1901; mul 781 1636; mul 1210 1903; add 1902 1904; mul 777
1636; mul 59 1906; mul 59 1907; add 1905 1908; mul 773 1636; mul 59 1910; add 1909 1911; mul 763 1636; add 1912
1913; mul 764 1914; add 1819 1915; mul 669 1916; sub 1726 1917; mul 449 1320; mul 449 1302; add 1351 1920; mul 1316
1921; mul 272 1922; add 1919 1923; mul 449 1304; mul 1330 1925; mul 1305 1921; mul 449 1338; add 1927 1928; sub 1926
1929; mul 2 1930; sub 1924 1931; mul 1300 1932; sub 1918 1933; mul 423 437; mul 412 412; sub 1935 1936; mul 446
1937; mul 398 1938; mul 387 1360; mul 389 447; add 1940 1941; mul 294 1938; mul 289 1360; sub 1943 1944; mul 281
447; add 1945 1946; mul 326 1947; sub 1942 1948; mul 380 1949; mul 326 1950; mul 270 1360; mul 273 447; add 1952
1953; mul 194 1947; sub 1954 1955; mul 259 1956; mul 194 1957; add 1951 1958; mul 292 1959; add 1939 1960; mul 71
1961; mul 296 1950; mul 395 1947; sub 1963 1964; mul 325 1965; mul 395 1360; mul 260 1950; add 1967 1968; mul 263
1969; mul 325 1970; mul 383 1971; add 1966 1972; mul 393 1949; mul 379 1974; mul 375 1974; mul 378 1976; add 1975
1977; mul 366 1949; add 1978 1979; mul 370 1980; mul 372 1981; mul 333 1981; mul 249 1983; add 1982 1984; mul 310
1949; mul 346 1986; mul 350 1987; sub 1985 1988; mul 333 1987; mul 348 1990; sub 1989 1991; mul 218 1986; mul 332
1993; mul 339 1994; mul 335 1994; mul 337 1996; add 1995 1997; mul 516 1998; mul 511 1999; add 1992 2000; mul 374
1980; mul 310 2002; mul 528 2003; mul 323 2003; mul 369 2005; add 2004 2006; mul 323 2005; mul 368 2008; add 2007
2009; mul 309 1965; mul 395 447; mul 272 1950; sub 2012 2013; mul 316 2014; add 2011 2015; mul 385 1970; add 2016
2017; mul 310 2018; mul 341 1993; mul 327 2020; mul 329 2021; sub 2019 2022; mul 324 2021; neg 2024; mul 196 2025;
add 2023 2026; mul 538 2027; mul 324 2028; add 2010 2029; mul 527 2030; sub 2001 2031; mul 196 2021; add 2032 2033;
mul 310 2034; mul 487 2035; mul 485 2036; add 1973 2037; sub 1962 2038; mul 260 1959; sub 2040 1455; mul 287 2041;
add 2039 2042; mul 296 1957; mul 300 1947; sub 2044 2045; mul 193 2046; mul 300 1360; mul 260 1957; add 2048 2049;
mul 263 2050; mul 193 2051; mul 266 2052; sub 2047 2053; mul 298 1956; mul 258 2055; mul 254 2055; mul 257 2057; add
2056 2058; mul 242 1956; add 2059 2060; mul 247 2061; mul 251 2062; mul 205 2062; mul 249 2064; add 2063 2065; mul
178 1956; mul 222 2067; mul 226 2068; sub 2066 2069; mul 205 2068; mul 224 2071; sub 2070 2072; mul 218 2067; mul
201 2074; mul 211 2075; mul 207 2075; mul 209 2077; add 2076 2078; mul 615 2079; mul 610 2080; add 2073 2081; mul
253 2061; mul 178 2083; mul 627 2084; mul 191 2084; mul 246 2086; add 2085 2087; mul 191 2086; mul 245 2089; add
2088 2090; mul 177 2046; mul 300 447; mul 272 1957; sub 2093 2094; mul 184 2095; add 2092 2096; mul 268 2051; add
2097 2098; mul 178 2099; mul 213 2074; mul 195 2101; mul 198 2102; sub 2100 2103; mul 192 2102; neg 2105; mul 196
2106; add 2104 2107; mul 637 2108; mul 192 2109; add 2091 2110; mul 626 2111; sub 2082 2112; mul 196 2102; add 2113
2114; mul 178 2115; mul 586 2116; mul 584 2117; add 2054 2118; add 2038 2119; mul 155 2120; add 2043 2121; mul 102
2120; mul 103 2123; mul 131 2124; mul 102 2041; mul 286 2126; mul 41 2124; add 2127 2128; mul 142 2129; mul 272
1959; add 448 2131; mul 279 2132; mul 20 2124; add 2133 2134; mul 123 2135; add 2130 2136; mul 114 2137; mul 102
1961; mul 70 2139; mul 114 2124; add 2140 2141; mul 48 2142; mul 139 2129; add 2143 2144; mul 119 2135; add 2145
2146; mul 41 2147; add 2138 2148; mul 41 2149; add 2125 2150; mul 23 2142; mul 133 2129; add 2152 2153; mul 104
2135; add 2154 2155; mul 21 2156; add 2151 2157; mul 43 2129; mul 116 2135; add 2159 2160; mul 114 2161; mul 43
2142; mul 119 2129; add 2163 2164; mul 106 2135; add 2165 2166; mul 41 2167; add 2162 2168; mul 20 2156; add 2169
2170; mul 717 2171; add 2158 2172; mul 739 2173; mul 738 2174; mul 131 2132; mul 276 2176; sub 2175 2177; mul 737
2178; sub 2173 2179; mul 752 2174; add 2177 2181; mul 751 2182; sub 2180 2183; mul 679 2184; mul 674 2185; mul 669
2186; sub 2122 2187; sub 2188 2119; mul 447 963; add 2189 2190; mul 766 1360; mul 769 1938; sub 2192 2193; mul 3
447; mul 764 2195; sub 2194 2196; mul 941 2197; mul 945 2198; mul 955 2198; mul 941 2195; mul 945 2201; sub 2200
2202; mul 764 2203; add 2199 2204; mul 942 2201; sub 2205 2206; mul 966 2207; sub 2191 2208; mul 286 1626; mul 985
2210; mul 762 1938; mul 70 2212; mul 991 2213; mul 989 2214; mul 996 2213; add 2215 2216; sub 2211 2217; mul 762
2195; mul 279 2219; mul 906 2220; sub 2218 2221; mul 21 2222; mul 904 2210; mul 896 2224; mul 904 2213; mul 1007
2226; sub 2225 2227; mul 930 2210; mul 900 2214; mul 1013 2213; add 2230 2231; sub 2229 2232; mul 920 2220; sub 2233
2234; mul 114 2235; add 2228 2236; mul 904 2220; mul 889 2238; sub 2237 2239; mul 114 2240; add 2223 2241; mul 1026
2224; mul 896 2226; sub 2243 2244; mul 1030 2210; mul 896 2214; mul 1033 2213; add 2247 2248; sub 2246 2249; mul 917
2220; sub 2250 2251; mul 114 2252; add 2245 2253; mul 1041 2210; mul 893 2214; mul 927 2213; add 2256 2257; sub 2255
2258; mul 914 2220; sub 2259 2260; mul 41 2261; add 2254 2262; mul 886 2238; sub 2263 2264; mul 41 2265; add 2242
2266; mul 1055 2224; mul 1057 2226; sub 2268 2269; mul 1060 2210; mul 1057 2214; mul 920 2213; add 2272 2273; sub
2271 2274; mul 911 2220; sub 2275 2276; mul 114 2277; add 2270 2278; mul 914 2210; mul 1055 2214; mul 1060 2213; add
2281 2282; sub 2280 2283; mul 908 2220; sub 2284 2285; mul 41 2286; add 2279 2287; mul 20 2222; add 2288 2289; mul
884 2238; sub 2290 2291; mul 717 2292; add 2267 2293; mul 937 2219; mul 276 2295; mul 739 2294; mul 738 2297; add
2296 2298; mul 737 2299; sub 2294 2300; mul 752 2297; sub 2296 2302; mul 751 2303; add 2301 2304; mul 679 2305; mul
674 2306; mul 669 2307; sub 2209 2308; mul 766 1626; mul 769 2212; sub 2310 2311; mul 764 2219; sub 2312 2313; mul
879 2314; mul 817 2315; mul 873 2212; mul 771 2317; mul 1107 2318; mul 800 2212; mul 59 2320; mul 1107 2321; add
2319 2322; mul 1115 2212; mul 1107 2324; add 2323 2325; mul 785 2212; mul 771 2327; mul 771 2328; add 2326 2329; mul
1123 2212; mul 59 2331; mul 771 2332; add 2330 2333; mul 773 2212; mul 771 2335; add 2334 2336; sub 2316 2337; mul 4
2315; mul 1107 2339; add 2338 2340; mul 812 2314; mul 771 2342; mul 1107 2343; add 2341 2344; mul 873 2314; mul 59
2346; mul 1107 2347; add 2345 2348; mul 870 2314; mul 1107 2350; add 2349 2351; mul 867 2314; mul 771 2353; mul 771
2354; add 2352 2355; mul 864 2314; mul 59 2357; mul 771 2358; add 2356 2359; mul 861 2314; mul 771 2361; add 2360
2362; mul 777 2314; mul 59 2364; mul 59 2365; add 2363 2366; mul 773 2314; mul 59 2368; add 2367 2369; mul 763 2314;
add 2370 2371; mul 821 2219; mul 817 2373; sub 2372 2374; mul 4 2373; mul 1107 2376; sub 2375 2377; mul 816 2219;
mul 771 2379; mul 1107 2380; sub 2378 2381; mul 812 2219; mul 771 2383; mul 771 2384; sub 2382 2385; mul 808 2219;
mul 59 2387; mul 771 2388; sub 2386 2389; mul 804 2219; mul 771 2391; sub 2390 2392; mul 800 2219; mul 59 2394; mul
59 2395; sub 2393 2396; mul 796 2219; mul 59 2398; sub 2397 2399; mul 793 2219; sub 2400 2401; mul 817 2342; mul 817
2317; mul 805 2327; add 2404 2405; mul 4 2328; add 2406 2407; mul 4 2332; add 2408 2409; mul 4 2335; add 2410 2411;
mul 1206 2212; mul 782 2413; add 2412 2414; mul 771 2413; mul 1210 2416; add 2415 2417; mul 843 2212; mul 59 2419;
mul 1210 2420; add 2418 2421; mul 1218 2212; mul 1210 2423; add 2422 2424; mul 1222 2212; mul 59 2426; mul 59 2427;
add 2425 2428; mul 1227 2212; mul 59 2430; add 2429 2431; mul 826 2212; add 2432 2433; sub 2403 2434; mul 805 2353;
add 2435 2436; mul 4 2354; add 2437 2438; mul 4 2358; add 2439 2440; mul 4 2361; add 2441 2442; mul 852 2314; mul
782 2444; add 2443 2445; mul 771 2444; mul 1210 2447; add 2446 2448; mul 849 2314; mul 59 2450; mul 1210 2451; add
2449 2452; mul 846 2314; mul 1210 2454; add 2453 2455; mul 843 2314; mul 59 2457; mul 59 2458; add 2456 2459; mul
840 2314; mul 59 2461; add 2460 2462; mul 837 2314; add 2463 2464; mul 817 2379; sub 2465 2466; mul 805 2383; sub
2467 2468; mul 4 2384; sub 2469 2470; mul 4 2388; sub 2471 2472; mul 4 2391; sub 2473 2474; mul 789 2219; mul 782
2476; sub 2475 2477; mul 771 2476; mul 1210 2479; sub 2478 2480; mul 785 2219; mul 59 2482; mul 1210 2483; sub 2481
2484; mul 781 2219; mul 1210 2486; sub 2485 2487; mul 777 2219; mul 59 2489; mul 59 2490; sub 2488 2491; mul 773
2219; mul 59 2493; sub 2492 2494; mul 763 2219; sub 2495 2496; mul 764 2497; add 2402 2498; mul 669 2499; sub 2309
2500; mul 447 1320; mul 447 1302; add 1360 2503; mul 1316 2504; mul 272 2505; add 2502 2506; mul 1305 2504; mul 447
1338; add 2508 2509; mul 447 1304; mul 1330 2511; sub 2510 2512; mul 2 2513; add 2507 2514; mul 1300 2515; add 2501
2516; mul 194 254; mul 292 2518; mul 71 2519; mul 260 2518; mul 287 2521; add 2520 2522; mul 254 296; mul 193 2524;
mul 254 260; mul 263 2526; mul 193 2527; mul 266 2528; sub 2525 2529; mul 247 298; mul 251 2531; mul 205 2531; mul
249 2533; add 2532 2534; mul 253 298; mul 178 2536; mul 627 2537; mul 191 2537; mul 246 2539; add 2538 2540; mul 191
2539; mul 245 2542; add 2541 2543; mul 177 2524; mul 254 272; mul 184 2546; sub 2545 2547; mul 268 2527; add 2548
2549; mul 178 2550; mul 637 2551; mul 192 2552; add 2544 2553; mul 626 2554; sub 2535 2555; mul 178 2556; mul 586
2557; mul 584 2558; add 2530 2559; mul 155 2560; add 2523 2561; mul 102 2560; mul 103 2563; mul 131 2564; mul 102
2521; mul 286 2566; mul 41 2564; add 2567 2568; mul 142 2569; mul 272 2518; mul 279 2571; mul 20 2564; add 2572
2573; mul 123 2574; add 2570 2575; mul 114 2576; mul 102 2519; mul 70 2578; mul 114 2564; add 2579 2580; mul 48
2581; mul 139 2569; add 2582 2583; mul 119 2574; add 2584 2585; mul 41 2586; add 2577 2587; mul 41 2588; add 2565
2589; mul 23 2581; mul 133 2569; add 2591 2592; mul 104 2574; add 2593 2594; mul 21 2595; add 2590 2596; mul 43
2569; mul 116 2574; add 2598 2599; mul 114 2600; mul 43 2581; mul 119 2569; add 2602 2603; mul 106 2574; add 2604
2605; mul 41 2606; add 2601 2607; mul 20 2595; add 2608 2609; mul 717 2610; add 2597 2611; mul 739 2612; mul 738
2613; mul 131 2571; mul 276 2615; sub 2614 2616; mul 737 2617; sub 2612 2618; mul 752 2613; add 2616 2620; mul 751
2621; sub 2619 2622; mul 679 2623; mul 674 2624; mul 669 2625; sub 2562 2626; sub 2627 2560; mul 326 375; mul 292
2629; mul 71 2630; mul 296 375; mul 325 2632; mul 260 375; mul 263 2634; mul 325 2635; mul 383 2636; add 2633 2637;
mul 370 393; mul 372 2639; mul 333 2639; mul 249 2641; add 2640 2642; mul 374 393; mul 310 2644; mul 528 2645; mul
323 2645; mul 369 2647; add 2646 2648; mul 323 2647; mul 368 2650; add 2649 2651; mul 309 2632; mul 272 375; mul 316
2654; sub 2653 2655; mul 385 2635; add 2656 2657; mul 310 2658; mul 538 2659; mul 324 2660; add 2652 2661; mul 527
2662; sub 2643 2663; mul 310 2664; mul 487 2665; mul 485 2666; add 2638 2667; sub 2631 2668; mul 260 2629; mul 287
2670; add 2669 2671; mul 155 2668; add 2672 2673; mul 102 2668; mul 103 2675; mul 131 2676; mul 102 2670; mul 286
2678; mul 41 2676; add 2679 2680; mul 142 2681; mul 272 2629; mul 279 2683; mul 20 2676; add 2684 2685; mul 123
2686; add 2682 2687; mul 114 2688; mul 102 2630; mul 70 2690; mul 114 2676; add 2691 2692; mul 48 2693; mul 139
2681; add 2694 2695; mul 119 2686; add 2696 2697; mul 41 2698; add 2689 2699; mul 41 2700; add 2677 2701; mul 23
2693; mul 133 2681; add 2703 2704; mul 104 2686; add 2705 2706; mul 21 2707; add 2702 2708; mul 43 2681; mul 116
2686; add 2710 2711; mul 114 2712; mul 43 2693; mul 119 2681; add 2714 2715; mul 106 2686; add 2716 2717; mul 41
2718; add 2713 2719; mul 20 2707; add 2720 2721; mul 717 2722; add 2709 2723; mul 739 2724; mul 738 2725; mul 131
2683; mul 276 2727; sub 2726 2728; mul 737 2729; sub 2724 2730; mul 752 2725; add 2728 2732; mul 751 2733; sub 2731
2734; mul 679 2735; mul 674 2736; mul 669 2737; sub 2674 2738; mul 766 881; mul 21 1055; mul 46 1026; add 2741 2742;
mul 890 896; add 2743 2744; input p 134; mul 51 2746; add 2745 2747; input p 135; mul 897 2749; add 2748 2750; input
p 136; mul 901 2752; add 2751 2753; mul 904 2754; mul 22 985; mul 42 914; add 2756 2757; mul 115 1060; add 2758
2759; mul 47 1041; add 2760 2761; mul 122 1030; add 2762 2763; mul 921 930; add 2764 2765; input p 141; mul 52 2767;
add 2766 2768; input p 142; mul 129 2770; add 2769 2771; input p 143; mul 931 2773; add 2772 2774; input p 144; mul
904 2776; add 2775 2777; add 2755 2778; mul 286 2779; add 2740 2780; mul 449 2781; input p 147; mul 59 2783; input p
148; mul 830 2785; add 2784 2786; input p 149; mul 834 2788; add 2787 2789; mul 771 826; add 2790 2791; mul 774
1227; add 2792 2793; mul 778 1222; add 2794 2795; mul 782 1218; add 2796 2797; mul 786 843; add 2798 2799; mul 790
1206; add 2800 2801; mul 773 805; add 2802 2803; mul 809 1123; add 2804 2805; mul 785 813; add 2806 2807; mul 817
1115; add 2808 2809; mul 800 874; add 2810 2811; mul 818 873; add 2812 2813; mul 769 881; add 2814 2815; mul 21
1057; mul 46 896; add 2817 2818; mul 890 1007; add 2819 2820; input p 158; mul 51 2822; add 2821 2823; input p 159;
mul 897 2825; add 2824 2826; input p 160; mul 901 2828; add 2827 2829; mul 904 2830; mul 22 996; mul 42 1060; add
2832 2833; mul 115 920; add 2834 2835; mul 47 927; add 2836 2837; mul 122 1033; add 2838 2839; mul 921 1013; add
2840 2841; input p 164; mul 52 2843; add 2842 2844; mul 129 2773; add 2845 2846; input p 165; mul 931 2848; add 2847
2849; input p 166; mul 904 2851; add 2850 2852; add 2831 2853; mul 22 989; mul 42 1055; add 2855 2856; mul 115 1057;
add 2857 2858; mul 47 893; add 2859 2860; mul 122 896; add 2861 2862; mul 900 921; add 2863 2864; input p 168; mul
52 2866; add 2865 2867; mul 129 2822; add 2868 2869; mul 931 2752; add 2870 2871; input p 169; mul 904 2873; add
2872 2874; mul 991 2875; add 2854 2876; mul 70 2877; add 2816 2878; mul 447 2879; sub 2782 2880; mul 939 970; sub
2881 2882; mul 1360 2879; mul 1351 2781; sub 2884 2885; mul 939 1611; add 2886 2887; mul 1360 2781; mul 1938 2879;
sub 2889 2890; mul 939 2195; sub 2891 2892; mul 957 972; constant 0.8; mul 292 447; mul 2895 2896; sub 2894 2897;
mul 952 970; sub 2898 2899; input p 224; input p 225; mul 1318 1323; le 1314 1315; le 1315 1314; add 2904 2905; div
17 2906; mul 2904 2907; mul 2903 2908; mul 2902 2909; mul 2901 2910; mul 243 2911; add 2900 2912; mul 292 1360; mul
2895 2914; mul 957 1613; add 2915 2916; mul 952 1611; add 2917 2918; mul 1318 1921; mul 2908 2920; mul 2902 2921;
mul 2901 2922; mul 243 2923; sub 2919 2924; mul 957 2197; mul 292 1938; mul 2895 2927; sub 2926 2928; mul 952 2195;
sub 2929 2930; mul 1318 2504; mul 2908 2932; mul 2902 2933; mul 2901 2934; mul 243 2935; add 2931 2936; constant
-2.57142857142857; mul 822 1104; mul 2938 2939; constant -0.8571428571428573; mul 818 992; mul 2941 2942; constant
0.9142857142857148; mul 874 992; mul 2944 2945; add 2943 2946; constant 0.05714285714285805; mul 813 992; mul 2948
2949; add 2947 2950; constant -0.1142857142857146; mul 809 992; mul 2952 2953; add 2951 2954; constant
0.2190476190476187; mul 790 992; mul 2956 2957; add 2955 2958; constant 0.11428571428571417; mul 786 992; mul 2960
2961; add 2959 2962; constant -0.05714285714285713; mul 778 992; mul 2964 2965; add 2963 2966; input p 226; constant
-0.03333333333333334; mul 771 992; mul 2969 2970; mul 2968 2971; add 2967 2972; constant 0.007256235827664402; mul
834 992; mul 2974 2975; add 2973 2976; constant 0.019047619047619053; mul 59 992; mul 2978 2979; mul 2968 2980; add
2977 2981; sub 2940 2982; constant 2.057142857142853; mul 818 1104; mul 2984 2985; add 2983 2986; mul 874 1104; mul
2941 2988; add 2987 2989; constant -3.428571428571426; mul 813 1104; mul 2991 2992; add 2990 2993; constant
0.1142857142857161; mul 809 1104; mul 2995 2996; add 2994 2997; constant -0.0571428571428573; mul 801 1104; mul 2999
3000; add 2998 3001; constant -0.09999999999999992; mul 4 1104; mul 3003 3004; mul 2968 3005; add 3002 3006;
constant 2.438095238095238; mul 790 1104; mul 3008 3009; add 3007 3010; constant 0.6571428571428561; mul 786 1104;
mul 3012 3013; add 3011 3014; input p 227; mul 782 1104; mul 3016 3017; sub 3015 3018; mul 778 1104; mul 2960 3020;
add 3019 3021; constant 0.13333333333333333; mul 771 1104; mul 3023 3024; mul 2968 3025; add 3022 3026; constant
-0.019047619047619042; mul 834 1104; mul 3028 3029; add 3027 3030; mul 59 1104; mul 2969 3032; mul 2968 3033; add
3031 3034; constant 12.342857142857142; mul 822 1000; mul 3036 3037; sub 3035 3038; constant -7.71428571428571; mul
818 1000; mul 3040 3041; sub 3039 3042; mul 813 1000; mul 2984 3044; sub 3043 3045; constant -1.7142857142857146;
mul 809 1000; mul 3047 3048; sub 3046 3049; mul 801 1000; mul 2944 3051; sub 3050 3052; constant 1.1999999999999995;
mul 4 1000; mul 3054 3055; mul 2968 3056; sub 3053 3057; constant -1.1428571428571421; mul 790 1000; mul 3059 3060;
sub 3058 3061; mul 786 1000; mul 2948 3063; sub 3062 3064; mul 778 1000; mul 2999 3066; sub 3065 3067; mul 771 1000;
mul 3003 3069; mul 2968 3070; sub 3068 3071; mul 818 1626; mul 2941 3073; mul 874 1626; mul 2944 3075; add 3074
3076; mul 813 1626; mul 2948 3078; add 3077 3079; mul 809 1626; mul 2952 3081; add 3080 3082; mul 790 1626; mul 2956
3084; add 3083 3085; mul 786 1626; mul 2960 3087; add 3086 3088; mul 778 1626; mul 2964 3090; add 3089 3091; mul 771
1626; mul 2969 3093; mul 2968 3094; add 3092 3095; mul 834 1626; mul 2974 3097; add 3096 3098; mul 59 1626; mul 2978
3100; mul 2968 3101; add 3099 3102; mul 822 1752; mul 2938 3104; add 3103 3105; mul 818 1752; mul 2984 3107; add
3106 3108; mul 874 1752; mul 2941 3110; add 3109 3111; mul 813 1752; mul 2991 3113; add 3112 3114; mul 809 1752; mul
2995 3116; add 3115 3117; mul 801 1752; mul 2999 3119; add 3118 3120; mul 4 1752; mul 3003 3122; mul 2968 3123; add
3121 3124; mul 790 1752; mul 3008 3126; add 3125 3127; mul 786 1752; mul 3012 3129; add 3128 3130; mul 782 1752; mul
3016 3132; sub 3131 3133; mul 778 1752; mul 2960 3135; add 3134 3136; mul 771 1752; mul 3023 3138; mul 2968 3139;
add 3137 3140; mul 834 1752; mul 3028 3142; add 3141 3143; mul 59 1752; mul 2969 3145; mul 2968 3146; add 3144 3147;
mul 822 1636; mul 3036 3149; add 3148 3150; mul 818 1636; mul 3040 3152; add 3151 3153; mul 813 1636; mul 2984 3155;
add 3154 3156; mul 809 1636; mul 3047 3158; add 3157 3159; mul 801 1636; mul 2944 3161; add 3160 3162; mul 4 1636;
mul 3054 3164; mul 2968 3165; add 3163 3166; mul 790 1636; mul 3059 3168; add 3167 3169; mul 786 1636; mul 2948
3171; add 3170 3172; mul 778 1636; mul 2999 3174; add 3173 3175; mul 771 1636; mul 3003 3177; mul 2968 3178; add
3176 3179; mul 822 2314; mul 2938 3181; mul 818 2212; mul 2941 3183; mul 874 2212; mul 2944 3185; add 3184 3186; mul
813 2212; mul 2948 3188; add 3187 3189; mul 809 2212; mul 2952 3191; add 3190 3192; mul 790 2212; mul 2956 3194; add
3193 3195; mul 786 2212; mul 2960 3197; add 3196 3198; mul 778 2212; mul 2964 3200; add 3199 3201; mul 771 2212; mul
2969 3203; mul 2968 3204; add 3202 3205; mul 834 2212; mul 2974 3207; add 3206 3208; mul 59 2212; mul 2978 3210; mul
2968 3211; add 3209 3212; sub 3182 3213; mul 818 2314; mul 2984 3215; add 3214 3216; mul 874 2314; mul 2941 3218;
add 3217 3219; mul 813 2314; mul 2991 3221; add 3220 3222; mul 809 2314; mul 2995 3224; add 3223 3225; mul 801 2314;
mul 2999 3227; add 3226 3228; mul 4 2314; mul 3003 3230; mul 2968 3231; add 3229 3232; mul 790 2314; mul 3008 3234;
add 3233 3235; mul 786 2314; mul 3012 3237; add 3236 3238; mul 782 2314; mul 3016 3240; sub 3239 3241; mul 778 2314;
mul 2960 3243; add 3242 3244; mul 771 2314; mul 3023 3246; mul 2968 3247; add 3245 3248; mul 834 2314; mul 3028
3250; add 3249 3251; mul 59 2314; mul 2969 3253; mul 2968 3254; add 3252 3255; mul 822 2219; mul 3036 3257; sub 3256
3258; mul 818 2219; mul 3040 3260; sub 3259 3261; mul 813 2219; mul 2984 3263; sub 3262 3264; mul 809 2219; mul 3047
3266; sub 3265 3267; mul 801 2219; mul 2944 3269; sub 3268 3270; mul 4 2219; mul 3054 3272; mul 2968 3273; sub 3271
3274; mul 790 2219; mul 3059 3276; sub 3275 3277; mul 786 2219; mul 2948 3279; sub 3278 3280; mul 778 2219; mul 2999
3282; sub 3281 3283; mul 771 2219; mul 3003 3285; mul 2968 3286; sub 3284 3287; constant -129.60000000000008; mul
2939 3289; constant 28.79999999999998; mul 2942 3291; constant 45.25714285714285; mul 2945 3293; add 3292 3294;
constant -28.80000000000001; mul 817 992; mul 3296 3297; mul 3016 3298; add 3295 3299; constant -28.799999999999997;
mul 2949 3301; add 3300 3302; constant -45.25714285714285; mul 2953 3304; add 3303 3305; constant 28.80000000000001;
mul 805 992; mul 3307 3308; mul 3016 3309; add 3306 3310; constant 7.199999999999999; mul 2957 3312; add 3311 3313;
constant 13.714285714285712; mul 2961 3315; add 3314 3316; constant -7.200000000000003; mul 782 992; mul 3318 3319;
mul 3016 3320; add 3317 3321; constant 1.3714285714285672; mul 2965 3323; add 3322 3324; constant
-4.799999999999996; mul 774 992; mul 3326 3327; mul 3016 3328; add 3325 3329; constant 1.371428571428571; mul 2975
3331; add 3330 3332; constant -1.3714285714285719; mul 830 992; mul 3334 3335; mul 3016 3336; add 3333 3337;
constant 2.4; mul 2979 3339; mul 2968 3340; add 3338 3341; sub 3290 3342; constant 230.40000000000006; mul 2985
3344; add 3343 3345; mul 2988 3291; add 3346 3347; constant -36.00000000000001; mul 817 1104; mul 3349 3350; mul
3016 3351; add 3348 3352; constant -151.20000000000002; mul 2992 3354; add 3353 3355; constant -57.599999999999994;
mul 2996 3357; add 3356 3358; constant 72.0; mul 805 1104; mul 3360 3361; mul 3016 3362; add 3359 3363; constant
-22.628571428571426; mul 3000 3365; add 3364 3366; mul 797 1104; mul 3307 3368; mul 3016 3369; add 3367 3370;
constant -18.000000000000004; mul 3004 3372; mul 2968 3373; add 3371 3374; constant 35.20000000000001; mul 3009
3376; add 3375 3377; constant 21.599999999999998; mul 3013 3379; add 3378 3380; constant -30.000000000000007; mul
3017 3382; mul 3016 3383; add 3381 3384; mul 3020 3315; add 3385 3386; constant -14.400000000000006; mul 774 1104;
mul 3388 3389; mul 3016 3390; add 3387 3391; mul 942 3024; mul 2968 3393; add 3392 3394; constant
0.45714285714285574; mul 3029 3396; add 3395 3397; constant -2.399999999999998; mul 830 1104; mul 3399 3400; mul
3016 3401; add 3398 3402; input p 228; constant -0.9999999999999998; mul 1104 3405; mul 3404 3406; add 3403 3407;
constant 259.2000000000001; mul 3037 3409; sub 3408 3410; constant -388.80000000000024; mul 3041 3412; sub 3411
3413; mul 3044 3344; sub 3414 3415; constant 57.59999999999996; mul 3048 3417; sub 3416 3418; constant
-72.00000000000001; mul 805 1000; mul 3420 3421; mul 3016 3422; sub 3419 3423; mul 3051 3293; sub 3424 3425;
constant -57.60000000000002; mul 797 1000; mul 3427 3428; mul 3016 3429; sub 3426 3430; constant 36.000000000000014;
mul 3055 3432; mul 2968 3433; sub 3431 3434; constant -50.400000000000006; mul 3060 3436; sub 3435 3437; mul 3063
3301; sub 3438 3439; constant 36.0; mul 782 1000; mul 3441 3442; mul 3016 3443; sub 3440 3444; mul 3066 3365; sub
3445 3446; mul 774 1000; mul 3307 3448; mul 3016 3449; sub 3447 3450; mul 3069 3372; mul 2968 3452; sub 3451 3453;
mul 3073 3291; mul 3075 3293; add 3455 3456; mul 817 1626; mul 3296 3458; mul 3016 3459; add 3457 3460; mul 3078
3301; add 3461 3462; mul 3081 3304; add 3463 3464; mul 805 1626; mul 3307 3466; mul 3016 3467; add 3465 3468; mul
3084 3312; add 3469 3470; mul 3087 3315; add 3471 3472; mul 782 1626; mul 3318 3474; mul 3016 3475; add 3473 3476;
mul 3090 3323; add 3477 3478; mul 774 1626; mul 3326 3480; mul 3016 3481; add 3479 3482; mul 3097 3331; add 3483
3484; mul 830 1626; mul 3334 3486; mul 3016 3487; add 3485 3488; mul 3100 3339; mul 2968 3490; add 3489 3491; mul
3104 3289; add 3492 3493; mul 3107 3344; add 3494 3495; mul 3110 3291; add 3496 3497; mul 817 1752; mul 3349 3499;
mul 3016 3500; add 3498 3501; mul 3113 3354; add 3502 3503; mul 3116 3357; add 3504 3505; mul 805 1752; mul 3360
3507; mul 3016 3508; add 3506 3509; mul 3119 3365; add 3510 3511; mul 797 1752; mul 3307 3513; mul 3016 3514; add
3512 3515; mul 3122 3372; mul 2968 3517; add 3516 3518; mul 3126 3376; add 3519 3520; mul 3129 3379; add 3521 3522;
mul 3132 3382; mul 3016 3524; add 3523 3525; mul 3135 3315; add 3526 3527; mul 774 1752; mul 3388 3529; mul 3016
3530; add 3528 3531; mul 942 3138; mul 2968 3533; add 3532 3534; mul 3142 3396; add 3535 3536; mul 830 1752; mul
3399 3538; mul 3016 3539; add 3537 3540; mul 1752 3405; mul 3404 3542; add 3541 3543; mul 3149 3409; add 3544 3545;
mul 3152 3412; add 3546 3547; mul 3155 3344; add 3548 3549; mul 3158 3417; add 3550 3551; mul 805 1636; mul 3420
3553; mul 3016 3554; add 3552 3555; mul 3161 3293; add 3556 3557; mul 797 1636; mul 3427 3559; mul 3016 3560; add
3558 3561; mul 3164 3432; mul 2968 3563; add 3562 3564; mul 3168 3436; add 3565 3566; mul 3171 3301; add 3567 3568;
mul 782 1636; mul 3441 3570; mul 3016 3571; add 3569 3572; mul 3174 3365; add 3573 3574; mul 774 1636; mul 3307
3576; mul 3016 3577; add 3575 3578; mul 3177 3372; mul 2968 3580; add 3579 3581; mul 3181 3289; mul 3183 3291; mul
3185 3293; add 3584 3585; mul 817 2212; mul 3296 3587; mul 3016 3588; add 3586 3589; mul 3188 3301; add 3590 3591;
mul 3191 3304; add 3592 3593; mul 805 2212; mul 3307 3595; mul 3016 3596; add 3594 3597; mul 3194 3312; add 3598
3599; mul 3197 3315; add 3600 3601; mul 782 2212; mul 3318 3603; mul 3016 3604; add 3602 3605; mul 3200 3323; add
3606 3607; mul 774 2212; mul 3326 3609; mul 3016 3610; add 3608 3611; mul 3207 3331; add 3612 3613; mul 830 2212;
mul 3334 3615; mul 3016 3616; add 3614 3617; mul 3210 3339; mul 2968 3619; add 3618 3620; sub 3583 3621; mul 3215
3344; add 3622 3623; mul 3218 3291; add 3624 3625; mul 817 2314; mul 3349 3627; mul 3016 3628; add 3626 3629; mul
3221 3354; add 3630 3631; mul 3224 3357; add 3632 3633; mul 805 2314; mul 3360 3635; mul 3016 3636; add 3634 3637;
mul 3227 3365; add 3638 3639; mul 797 2314; mul 3307 3641; mul 3016 3642; add 3640 3643; mul 3230 3372; mul 2968
3645; add 3644 3646; mul 3234 3376; add 3647 3648; mul 3237 3379; add 3649 3650; mul 3240 3382; mul 3016 3652; add
3651 3653; mul 3243 3315; add 3654 3655; mul 774 2314; mul 3388 3657; mul 3016 3658; add 3656 3659; mul 942 3246;
mul 2968 3661; add 3660 3662; mul 3250 3396; add 3663 3664; mul 830 2314; mul 3399 3666; mul 3016 3667; add 3665
3668; mul 2314 3405; mul 3404 3670; add 3669 3671; mul 3257 3409; sub 3672 3673; mul 3260 3412; sub 3674 3675; mul
3263 3344; sub 3676 3677; mul 3266 3417; sub 3678 3679; mul 805 2219; mul 3420 3681; mul 3016 3682; sub 3680 3683;
mul 3269 3293; sub 3684 3685; mul 797 2219; mul 3427 3687; mul 3016 3688; sub 3686 3689; mul 3272 3432; mul 2968
3691; sub 3690 3692; mul 3276 3436; sub 3693 3694; mul 3279 3301; sub 3695 3696; mul 782 2219; mul 3441 3698; mul
3016 3699; sub 3697 3700; mul 3282 3365; sub 3701 3702; mul 774 2219; mul 3307 3704; mul 3016 3705; sub 3703 3706;
mul 3285 3372; mul 2968 3708; sub 3707 3709; input p 229; mul 3351 3711; mul 3298 3711; mul 3309 3711; add 3713
3714; mul 3320 3711; add 3715 3716; mul 3328 3711; add 3717 3718; input p 230; input p 231; mul 2971 3721; mul 3720
3722; add 3719 3723; mul 3336 3711; add 3724 3725; mul 2980 3721; mul 3720 3727; add 3726 3728; mul 3340 3711; mul
3720 3730; add 3729 3731; sub 3712 3732; mul 3362 3711; add 3733 3734; mul 3369 3711; add 3735 3736; mul 3005 3721;
mul 3720 3738; add 3737 3739; mul 3373 3711; mul 3720 3741; add 3740 3742; mul 3017 3721; sub 3743 3744; mul 3383
3711; add 3745 3746; mul 3390 3711; add 3747 3748; mul 3025 3721; mul 3720 3750; add 3749 3751; mul 3393 3711; mul
3720 3753; add 3752 3754; mul 3401 3711; add 3755 3756; mul 3033 3721; mul 3720 3758; add 3757 3759; mul 3406 3711;
mul 2968 3761; add 3760 3762; mul 3016 3761; mul 3720 3764; add 3763 3765; add 3406 3766; mul 3422 3711; sub 3767
3768; mul 3429 3711; sub 3769 3770; mul 3056 3721; mul 3720 3772; sub 3771 3773; mul 3433 3711; mul 3720 3775; sub
3774 3776; mul 3443 3711; sub 3777 3778; mul 3449 3711; sub 3779 3780; mul 3070 3721; mul 3720 3782; sub 3781 3783;
mul 3452 3711; mul 3720 3785; sub 3784 3786; mul 3459 3711; mul 3467 3711; add 3788 3789; mul 3475 3711; add 3790
3791; mul 3481 3711; add 3792 3793; mul 3094 3721; mul 3720 3795; add 3794 3796; mul 3487 3711; add 3797 3798; mul
3101 3721; mul 3720 3800; add 3799 3801; mul 3490 3711; mul 3720 3803; add 3802 3804; mul 3500 3711; add 3805 3806;
mul 3508 3711; add 3807 3808; mul 3514 3711; add 3809 3810; mul 3123 3721; mul 3720 3812; add 3811 3813; mul 3517
3711; mul 3720 3815; add 3814 3816; mul 3132 3721; sub 3817 3818; mul 3524 3711; add 3819 3820; mul 3530 3711; add
3821 3822; mul 3139 3721; mul 3720 3824; add 3823 3825; mul 3533 3711; mul 3720 3827; add 3826 3828; mul 3539 3711;
add 3829 3830; mul 3146 3721; mul 3720 3832; add 3831 3833; mul 3542 3711; mul 2968 3835; add 3834 3836; mul 3016
3835; mul 3720 3838; add 3837 3839; add 3542 3840; mul 3554 3711; add 3841 3842; mul 3560 3711; add 3843 3844; mul
3165 3721; mul 3720 3846; add 3845 3847; mul 3563 3711; mul 3720 3849; add 3848 3850; mul 3571 3711; add 3851 3852;
mul 3577 3711; add 3853 3854; mul 3178 3721; mul 3720 3856; add 3855 3857; mul 3580 3711; mul 3720 3859; add 3858
3860; mul 3628 3711; mul 3588 3711; mul 3596 3711; add 3863 3864; mul 3604 3711; add 3865 3866; mul 3610 3711; add
3867 3868; mul 3204 3721; mul 3720 3870; add 3869 3871; mul 3616 3711; add 3872 3873; mul 3211 3721; mul 3720 3875;
add 3874 3876; mul 3619 3711; mul 3720 3878; add 3877 3879; sub 3862 3880; mul 3636 3711; add 3881 3882; mul 3642
3711; add 3883 3884; mul 3231 3721; mul 3720 3886; add 3885 3887; mul 3645 3711; mul 3720 3889; add 3888 3890; mul
3240 3721; sub 3891 3892; mul 3652 3711; add 3893 3894; mul 3658 3711; add 3895 3896; mul 3247 3721; mul 3720 3898;
add 3897 3899; mul 3661 3711; mul 3720 3901; add 3900 3902; mul 3667 3711; add 3903 3904; mul 3254 3721; mul 3720
3906; add 3905 3907; mul 3670 3711; mul 2968 3909; add 3908 3910; mul 3016 3909; mul 3720 3912; add 3911 3913; add
3670 3914; mul 3682 3711; sub 3915 3916; mul 3688 3711; sub 3917 3918; mul 3273 3721; mul 3720 3920; sub 3919 3921;
mul 3691 3711; mul 3720 3923; sub 3922 3924; mul 3699 3711; sub 3925 3926; mul 3705 3711; sub 3927 3928; mul 3286
3721; mul 3720 3930; sub 3929 3931; mul 3708 3711; mul 3720 3933; sub 3932 3934; mul 943 978; mul 958 970; sub 3936
3937; mul 881 1000; sub 3938 3939; mul 4 1295; add 3940 3941; input p 232; mul 2909 3943; input p 233; constant
0.3333333333333333; mul 3944 3946; mul 3945 3947; sub 3944 3948; add 3942 3949; mul 958 1611; mul 943 1619; add 3951
3952; mul 881 1636; add 3953 3954; mul 4 1914; add 3955 3956; mul 2921 3943; mul 3946 3958; mul 3945 3959; sub 3960
3958; add 3957 3961; mul 943 2203; mul 958 2195; sub 3963 3964; mul 881 2219; sub 3965 3966; mul 4 2497; add 3967
3968; mul 2933 3943; mul 3946 3970; mul 3945 3971; sub 3970 3972; add 3969 3973; mul 449 958; mul 881 986; add 3975
3976; mul 260 978; add 3977 3978; mul 27 1295; add 3979 3980; input p 234; mul 3949 3982; add 3981 3983; input p
235; input p 236; mul 2910 3986; mul 3985 3987; add 3984 3988; mul 260 1619; mul 958 1351; mul 881 1632; add 3991
3992; sub 3990 3993; mul 27 1914; add 3994 3995; mul 3961 3982; add 3996 3997; mul 2922 3986; mul 3985 3999; sub
3998 4000; mul 958 1360; mul 881 1626; add 4002 4003; mul 260 2203; add 4004 4005; mul 27 2497; add 4006 4007; mul
3973 3982; add 4008 4009; mul 2934 3986; mul 3985 4011; add 4010 4012; mul 292 978; mul 447 958; mul 881 992; add
4015 4016; sub 4014 4017; mul 59 1295; add 4018 4019; input p 237; mul 56 3944; mul 4021 4022; sub 4020 4023; mul
292 1619; add 4004 4025; mul 59 1914; add 4026 4027; mul 56 3958; mul 4021 4029; add 4028 4030; mul 292 2203; mul
958 1938; mul 881 2212; add 4033 4034; sub 4032 4035; mul 59 2497; add 4036 4037; mul 56 3970; mul 4021 4039; sub
4038 4040; mul 163 262; mul 260 263; mul 260 4043; mul 400 4044; mul 399 451; mul 399 449; mul 408 4047; sub 4046
4048; mul 4045 4049; mul 170 4050; mul 449 4044; mul 416 4052; sub 4051 4053; mul 403 4047; mul 399 447; mul 98
4056; sub 4055 4057; mul 82 4046; sub 4058 4059; mul 4045 4060; mul 174 4061; sub 4054 4062; mul 27 4063; mul 4042
4064; mul 4042 4065; mul 164 4064; mul 164 4067; mul 196 4068; add 4066 4069; mul 262 263; mul 386 480; input p 145;
mul 174 4073; mul 449 4074; sub 4072 4075; mul 269 579; add 4076 4077; mul 4071 4078; mul 169 4079; mul 164 164; mul
262 4078; mul 4081 4082; add 4080 4083; mul 164 174; mul 316 482; mul 307 4086; mul 263 449; mul 4073 4088; mul 309
482; mul 304 4090; add 4089 4091; sub 4087 4092; mul 307 566; add 4093 4094; mul 325 542; mul 381 482; add 4096
4097; mul 196 316; mul 564 4099; add 4098 4100; mul 304 4101; add 4095 4102; mul 177 581; mul 171 4104; sub 4103
4105; mul 184 581; mul 175 4107; sub 4106 4108; mul 175 665; sub 4109 4110; mul 193 641; mul 264 581; add 4112 4113;
mul 184 196; mul 663 4115; add 4114 4116; mul 171 4117; add 4111 4118; mul 4085 4119; add 4084 4120; mul 164 170;
mul 307 4090; mul 304 4086; add 4123 4124; mul 304 566; add 4125 4126; mul 307 4101; sub 4127 4128; mul 175 4104;
sub 4129 4130; mul 171 4107; add 4131 4132; mul 171 665; add 4133 4134; mul 175 4117; add 4135 4136; mul 4122 4137;
add 4121 4138; mul 163 196; div 17 4140; mul 4139 4141; mul 27 4142; mul 27 4143; sub 4070 4144; mul 164 4137; mul
163 4079; sub 4146 4147; mul 169 196; div 17 4149; mul 4148 4150; mul 27 4151; mul 27 4152; add 4145 4153; input p
131; mul 164 4155; mul 164 4156; mul 165 4042; mul 4042 4158; add 4157 4159; mul 27 4160; mul 4050 4161; mul 762
2879; mul 294 398; sub 4163 4164; input p 170; mul 292 4166; mul 769 958; add 4167 4168; add 4165 4169; mul 75 272;
mul 77 260; add 4171 4172; mul 80 292; add 4173 4174; mul 272 4175; mul 77 272; mul 85 260; add 4177 4178; mul 88
292; add 4179 4180; mul 260 4181; add 4176 4182; mul 80 272; mul 88 260; add 4184 4185; mul 96 292; add 4186 4187;
mul 292 4188; add 4183 4189; mul 174 4161; sub 407 4191; mul 4045 4192; add 4190 4193; mul 98 4194; mul 399 4195;
add 4170 4196; mul 446 447; mul 4197 4198; mul 762 2781; mul 289 398; sub 4200 4201; mul 766 958; add 4202 4203; mul
270 300; mul 387 395; add 4205 4206; add 4204 4207; sub 1320 4208; mul 263 4074; add 4209 4210; input p 120; input z
0; mul 4212 4213; input p 121; input z 1; mul 4215 4216; add 4214 4217; input p 122; input z 2; mul 4219 4220; add
4218 4221; input p 123; input z 3; mul 4223 4224; add 4222 4225; input p 124; input z 4; mul 4227 4228; add 4226
4229; input p 125; input z 5; mul 4231 4232; add 4230 4233; input p 146; mul 4234 4235; sub 4211 4236; mul 403 4194;
mul 170 4161; add 401 4239; mul 4045 4240; mul 408 4241; sub 4238 4242; mul 399 4243; mul 416 4161; mul 4044 4245;
sub 4244 4246; sub 4237 4247; mul 446 449; mul 4248 4249; add 4199 4250; input c 0; input c 2; mul 220 4253; add
4252 4254; input c 3; mul 344 4256; add 4255 4257; mul 1304 1338; add 4258 4259; mul 1302 1320; sub 4260 4261; input
p 16; input c 1; add 4263 4264; max 4265 7; mul 272 4266; sub 4262 4267; mul 281 398; sub 962 4269; mul 273 300; mul
389 395; add 4271 4272; sub 4270 4273; sub 4268 4274; input p 119; sub 4276 4234; input p 126; abs 272; mul 4278
4279; mul 272 4280; input p 127; mul 272 4282; mul 272 272; input p 128; add 4284 4285; sqrt 4286; div 17 4287; mul
4283 4288; add 4281 4289; sub 4277 4290; add 4275 4291; input p 129; input x 12; sub 2 4294; mul 4293 4295; input p
130; input x 13; sub 2 4298; mul 4297 4299; add 4296 4300; sub 4292 4301; mul 82 4194; sub 4303 4241; mul 399 4304;
sub 4302 4305; mul 446 451; mul 4306 4307; sub 4251 4308; mul 425 4309; mul 405 4310; mul 412 4309; mul 431 4312;
sub 4311 4313; mul 399 4314; mul 4047 4241; sub 4315 4316; mul 446 4197; mul 405 4318; mul 446 4248; mul 431 4320;
add 4319 4321; mul 441 4309; add 4322 4323; mul 399 4324; sub 4317 4325; mul 196 408; mul 425 4318; mul 425 4310;
sub 4328 4329; mul 437 4309; mul 431 4331; add 4330 4332; mul 446 4306; mul 431 4334; add 4333 4335; mul 399 4336;
mul 4327 4337; add 4326 4338; mul 400 4339; add 4061 4340; mul 263 4341; add 4162 4342; mul 164 4343; mul 262 4042;
mul 4064 4158; mul 165 4065; add 4346 4347; mul 4345 4348; mul 4049 4240; mul 400 4350; mul 449 4245; sub 4351 4352;
mul 4060 4192; mul 400 4354; add 4353 4355; mul 260 4356; mul 260 4357; mul 4047 4194; mul 82 4315; add 4359 4360;
mul 82 4325; sub 4361 4362; mul 425 4320; mul 412 4310; add 4364 4365; mul 405 4331; sub 4366 4367; mul 405 4334;
sub 4368 4369; mul 399 4370; mul 98 4371; add 4363 4372; mul 425 4312; mul 412 4318; sub 4374 4375; sub 4376 4367;
sub 4377 4369; mul 399 4378; mul 98 4379; add 4373 4380; mul 196 403; mul 4337 4382; add 4381 4383; mul 400 4384;
add 4050 4385; mul 174 4386; add 4358 4387; mul 170 4341; add 4388 4389; mul 416 4336; add 4390 4391; mul 263 4336;
mul 4052 4161; sub 4393 4394; mul 415 4395; add 4392 4396; mul 4071 4397; add 4349 4398; mul 163 4399; sub 4344
4400; mul 4150 4401; mul 27 4402; mul 27 4403; add 4154 4404; mul 262 4348; mul 164 4157; mul 4064 4407; sub 4406
4408; mul 4067 4157; sub 4409 4410; mul 263 4386; mul 4061 4161; sub 4412 4413; mul 4085 4414; sub 4411 4415; mul
4122 4343; sub 4416 4417; mul 169 4399; sub 4418 4419; mul 262 4397; mul 4081 4421; sub 4420 4422; mul 4141 4423;
mul 27 4424; mul 27 4425; add 4405 4426; mul 1351 4044; mul 416 4428; mul 399 1351; mul 408 4430; sub 4431 4047; mul
4045 4432; mul 170 4433; add 4429 4434; mul 399 1360; mul 98 4436; mul 403 4430; sub 4437 4438; mul 82 4047; add
4439 4440; mul 4045 4441; mul 174 4442; sub 4435 4443; mul 27 4444; mul 4042 4445; mul 4042 4446; mul 164 4445; mul
164 4448; mul 196 4449; add 4447 4450; mul 1351 4074; mul 386 1427; sub 4452 4453; mul 269 1463; sub 4454 4455; mul
4071 4456; mul 169 4457; mul 262 4456; mul 4081 4459; add 4458 4460; mul 263 1351; mul 4073 4462; mul 309 1451; mul
304 4464; add 4463 4465; mul 316 1451; mul 307 4467; sub 4466 4468; mul 307 1454; add 4469 4470; mul 325 1418; mul
381 1451; sub 4472 4473; mul 1448 4099; add 4474 4475; mul 304 4476; add 4471 4477; mul 177 1465; mul 171 4479; add
4478 4480; mul 184 1465; mul 175 4482; add 4481 4483; mul 175 1535; sub 4484 4485; mul 193 1510; mul 264 1465; sub
4487 4488; mul 1533 4115; add 4489 4490; mul 171 4491; add 4486 4492; mul 4085 4493; add 4461 4494; mul 304 1454;
mul 307 4464; mul 304 4467; add 4497 4498; sub 4496 4499; mul 307 4476; sub 4500 4501; mul 175 4479; add 4502 4503;
mul 171 4482; sub 4504 4505; mul 171 1535; add 4506 4507; mul 175 4491; add 4508 4509; mul 4122 4510; add 4495 4511;
mul 4141 4512; mul 27 4513; mul 27 4514; sub 4451 4515; mul 164 4510; mul 163 4457; sub 4517 4518; mul 4150 4519;
mul 27 4520; mul 27 4521; add 4516 4522; mul 4161 4433; mul 4241 4430; mul 4249 4306; mul 446 1360; mul 4197 4527;
sub 4526 4528; mul 446 1351; mul 4248 4530; sub 4529 4531; mul 425 4532; mul 405 4533; add 4328 4335; sub 4534 4535;
mul 412 4532; mul 431 4537; sub 4536 4538; mul 399 4539; add 4525 4540; mul 441 4532; mul 399 4542; sub 4541 4543;
mul 437 4532; mul 431 4545; mul 425 4533; sub 4546 4547; mul 399 4548; mul 4327 4549; add 4544 4550; mul 400 4551;
add 4442 4552; mul 263 4553; add 4524 4554; mul 164 4555; mul 4158 4445; mul 165 4446; add 4557 4558; mul 4345 4559;
mul 1351 4245; mul 4240 4432; mul 400 4562; add 4561 4563; mul 4192 4441; mul 400 4565; add 4564 4566; mul 260 4567;
mul 260 4568; mul 82 4540; mul 4194 4430; sub 4570 4571; mul 82 4543; sub 4572 4573; mul 412 4533; mul 405 4545; sub
4575 4576; mul 399 4577; mul 98 4578; add 4574 4579; mul 437 4318; mul 425 4334; add 4581 4582; mul 425 4537; add
4583 4584; sub 4585 4576; mul 399 4586; mul 98 4587; add 4580 4588; mul 4382 4549; add 4589 4590; mul 400 4591; add
4433 4592; mul 174 4593; add 4569 4594; mul 170 4553; add 4595 4596; mul 416 4548; add 4597 4598; mul 4161 4428; mul
263 4548; add 4600 4601; mul 415 4602; add 4599 4603; mul 4071 4604; add 4560 4605; mul 163 4606; sub 4556 4607; mul
4150 4608; mul 27 4609; mul 27 4610; add 4523 4611; mul 262 4559; mul 4407 4445; sub 4613 4614; mul 4157 4448; sub
4615 4616; mul 263 4593; mul 4161 4442; sub 4618 4619; mul 4085 4620; sub 4617 4621; mul 4122 4555; sub 4622 4623;
mul 169 4606; sub 4624 4625; mul 262 4604; mul 4081 4627; sub 4626 4628; mul 4141 4629; mul 27 4630; mul 27 4631;
add 4612 4632; mul 408 4436; sub 4056 4634; mul 4045 4635; mul 170 4636; mul 1360 4044; mul 416 4638; sub 4637 4639;
mul 403 4436; mul 399 1938; mul 98 4642; sub 4641 4643; mul 82 4056; sub 4644 4645; mul 4045 4646; mul 174 4647; sub
4640 4648; mul 27 4649; mul 4042 4650; mul 4042 4651; mul 164 4650; mul 164 4653; mul 196 4654; add 4652 4655; mul
386 1969; mul 1360 4074; sub 4657 4658; mul 269 2050; add 4659 4660; mul 4071 4661; mul 169 4662; mul 262 4661; mul
4081 4664; add 4663 4665; mul 316 1971; mul 307 4667; mul 263 1360; mul 4073 4669; mul 309 1971; mul 304 4671; add
4670 4672; sub 4668 4673; mul 307 2038; add 4674 4675; mul 325 2014; mul 381 1971; add 4677 4678; mul 2036 4099; add
4679 4680; mul 304 4681; add 4676 4682; mul 177 2052; mul 171 4684; sub 4683 4685; mul 184 2052; mul 175 4687; sub
4686 4688; mul 175 2119; sub 4689 4690; mul 193 2095; mul 264 2052; add 4692 4693; mul 2117 4115; add 4694 4695; mul
171 4696; add 4691 4697; mul 4085 4698; add 4666 4699; mul 307 4671; mul 304 4667; add 4701 4702; mul 304 2038; add
4703 4704; mul 307 4681; sub 4705 4706; mul 175 4684; sub 4707 4708; mul 171 4687; add 4709 4710; mul 171 2119; add
4711 4712; mul 175 4696; add 4713 4714; mul 4122 4715; add 4700 4716; mul 4141 4717; mul 27 4718; mul 27 4719; sub
4656 4720; mul 164 4715; mul 163 4662; sub 4722 4723; mul 4150 4724; mul 27 4725; mul 27 4726; add 4721 4727; mul
4161 4636; add 4369 4375; mul 446 1938; mul 4197 4731; mul 4248 4527; add 4732 4733; mul 4198 4306; sub 4734 4735;
mul 425 4736; mul 405 4737; add 4730 4738; mul 412 4736; mul 431 4740; sub 4739 4741; mul 399 4742; mul 4241 4436;
sub 4743 4744; add 4364 4375; mul 441 4736; sub 4746 4747; mul 399 4748; add 4745 4749; mul 437 4736; mul 431 4751;
mul 425 4737; add 4583 4753; sub 4752 4754; mul 399 4755; mul 4327 4756; add 4750 4757; mul 400 4758; add 4647 4759;
mul 263 4760; add 4729 4761; mul 164 4762; mul 4158 4650; mul 165 4651; add 4764 4765; mul 4345 4766; mul 4240 4635;
mul 400 4768; mul 1360 4245; sub 4769 4770; mul 4192 4646; mul 400 4772; add 4771 4773; mul 260 4774; mul 260 4775;
mul 4194 4436; mul 82 4743; add 4777 4778; mul 82 4749; add 4779 4780; mul 412 4334; mul 437 4320; sub 4782 4783;
mul 412 4737; add 4784 4785; mul 405 4751; sub 4786 4787; mul 399 4788; mul 98 4789; add 4781 4790; mul 425 4740;
sub 4792 4787; mul 399 4793; mul 98 4794; add 4791 4795; mul 4382 4756; add 4796 4797; mul 400 4798; add 4636 4799;
mul 174 4800; add 4776 4801; mul 170 4760; add 4802 4803; mul 416 4755; add 4804 4805; mul 263 4755; mul 4161 4638;
sub 4807 4808; mul 415 4809; add 4806 4810; mul 4071 4811; add 4767 4812; mul 163 4813; sub 4763 4814; mul 4150
4815; mul 27 4816; mul 27 4817; add 4728 4818; mul 262 4766; mul 4407 4650; sub 4820 4821; mul 4157 4653; sub 4822
4823; mul 263 4800; mul 4161 4647; sub 4825 4826; mul 4085 4827; sub 4824 4828; mul 4122 4762; sub 4829 4830; mul
169 4813; sub 4831 4832; mul 262 4811; mul 4081 4834; sub 4833 4835; mul 4141 4836; mul 27 4837; mul 27 4838; add
4819 4839; mul 184 2528; mul 171 4841; mul 177 2528; mul 175 4843; sub 4842 4844; mul 171 2560; add 4845 4846; mul
264 2528; mul 193 2546; sub 4848 4849; mul 2558 4115; add 4850 4851; mul 175 4852; add 4847 4853; mul 164 4854; mul
269 2526; mul 4071 4856; mul 163 4857; sub 4855 4858; mul 4150 4859; mul 27 4860; mul 27 4861; mul 169 4857; mul 262
4856; mul 4081 4864; add 4863 4865; mul 171 4852; mul 171 4843; mul 175 4841; add 4868 4869; mul 175 2560; add 4870
4871; sub 4867 4872; mul 4085 4873; add 4866 4874; mul 4122 4854; add 4875 4876; mul 4141 4877; mul 27 4878; mul 27
4879; sub 4862 4880; mul 309 2636; mul 307 4882; mul 316 2636; mul 304 4884; add 4883 4885; mul 304 2668; add 4886
4887; mul 381 2636; mul 325 2654; sub 4889 4890; mul 2666 4099; add 4891 4892; mul 307 4893; sub 4888 4894; mul 164
4895; mul 386 2634; mul 4071 4897; mul 163 4898; sub 4896 4899; mul 4150 4900; mul 27 4901; mul 27 4902; mul 169
4898; mul 262 4897; mul 4081 4905; add 4904 4906; mul 307 4884; mul 304 4882; sub 4908 4909; mul 307 2668; add 4910
4911; mul 304 4893; add 4912 4913; mul 4085 4914; add 4907 4915; mul 4122 4895; add 4916 4917; mul 4141 4918; mul 27
4919; mul 27 4920; sub 4903 4921; mul 22 1001; mul 955 4923; neg 4924; mul 22 1637; mul 955 4926; mul 22 2220; mul
955 4928; neg 4929; mul 22 987; mul 42 1001; mul 990 4932; sub 4931 4933; mul 42 1637; mul 990 4935; mul 22 1633;
sub 4936 4937; mul 22 2210; mul 42 2220; mul 990 4940; sub 4939 4941; mul 22 993; mul 115 1001; mul 990 4944; add
4943 4945; neg 4946; mul 22 1627; mul 115 1637; mul 990 4949; add 4948 4950; mul 22 2213; mul 115 2220; mul 990
4953; add 4952 4954; neg 4955; mul 42 987; mul 196 4957; mul 47 1001; neg 4959; mul 196 4960; add 4958 4961; mul 42
1633; neg 4963; mul 196 4964; mul 47 1637; mul 196 4966; add 4965 4967; mul 42 2210; mul 196 4969; mul 47 2220; neg
4971; mul 196 4972; add 4970 4973; mul 115 987; mul 42 993; sub 4975 4976; mul 122 1001; neg 4978; mul 196 4979; add
4977 4980; mul 42 1627; mul 115 1633; sub 4982 4983; mul 122 1637; mul 196 4985; add 4984 4986; mul 115 2210; mul 42
2213; sub 4988 4989; mul 122 2220; neg 4991; mul 196 4992; add 4990 4993; mul 115 993; neg 4995; mul 196 4996; mul
921 1001; neg 4998; mul 196 4999; add 4997 5000; mul 115 1627; mul 196 5002; mul 921 1637; mul 196 5004; add 5003
5005; mul 115 2213; neg 5007; mul 196 5008; mul 921 2220; neg 5010; mul 196 5011; add 5009 5012; mul 47 987; mul 990
5014; mul 52 1001; sub 5015 5016; mul 52 1637; mul 47 1633; mul 990 5019; sub 5018 5020; mul 47 2210; mul 990 5022;
mul 52 2220; sub 5023 5024; mul 122 987; mul 196 5026; mul 47 993; sub 5027 5028; mul 129 1001; sub 5029 5030; mul
47 1627; mul 122 1633; neg 5033; mul 196 5034; add 5032 5035; mul 129 1637; add 5036 5037; mul 122 2210; mul 196
5039; mul 47 2213; sub 5040 5041; mul 129 2220; sub 5042 5043; mul 122 993; neg 5045; mul 196 5046; mul 921 987; add
5047 5048; mul 931 1001; sub 5049 5050; mul 122 1627; mul 196 5052; mul 921 1633; sub 5053 5054; mul 931 1637; add
5055 5056; mul 122 2213; neg 5058; mul 196 5059; mul 921 2210; add 5060 5061; mul 931 2220; sub 5062 5063; mul 921
993; mul 990 5065; add 1021 5066; neg 5067; mul 921 1627; mul 990 5069; add 1655 5070; mul 921 2213; mul 990 5072;
add 2238 5073; neg 5074; mul 52 987; mul 955 5076; mul 52 1633; mul 955 5078; neg 5079; mul 52 2210; mul 955 5081;
mul 129 987; mul 990 5083; mul 52 993; sub 5084 5085; mul 52 1627; mul 129 1633; mul 990 5088; sub 5087 5089; mul
129 2210; mul 990 5091; mul 52 2213; sub 5092 5093; mul 129 993; neg 5095; mul 196 5096; mul 931 987; mul 196 5098;
add 5097 5099; mul 129 1627; mul 196 5101; mul 931 1633; neg 5103; mul 196 5104; add 5102 5105; mul 129 2213; neg
5107; mul 196 5108; mul 931 2210; mul 196 5110; add 5109 5111; mul 931 993; mul 990 5113; sub 1005 5114; mul 931
1627; mul 990 5116; sub 5117 1643; mul 931 2213; mul 990 5119; sub 2224 5120; mul 955 1008; neg 5122; mul 955 1641;
mul 955 2226; neg 5125; mul 22 994; mul 21 1021; mul 990 5128; add 5127 5129; neg 5130; mul 22 1628; mul 21 1655;
mul 990 5133; add 5132 5134; mul 22 2214; mul 21 2238; mul 990 5137; add 5136 5138; neg 5139; mul 21 1005; mul 42
994; sub 5141 5142; mul 46 1021; neg 5144; mul 196 5145; add 5143 5146; mul 42 1628; mul 21 1643; sub 5148 5149; mul
46 1655; mul 196 5151; add 5150 5152; mul 21 2224; mul 42 2214; sub 5154 5155; mul 46 2238; neg 5157; mul 196 5158;
add 5156 5159; mul 890 1021; neg 5161; mul 196 5162; mul 115 994; mul 21 1008; add 5164 5165; sub 5163 5166; mul 115
1628; mul 21 1641; add 5168 5169; mul 890 1655; mul 196 5171; add 5170 5172; mul 890 2238; neg 5174; mul 196 5175;
mul 115 2214; mul 21 2226; add 5177 5178; sub 5176 5179; mul 46 1005; mul 196 5181; mul 47 994; sub 5182 5183; mul
51 1021; sub 5184 5185; mul 47 1628; mul 46 1643; neg 5188; mul 196 5189; add 5187 5190; mul 51 1655; add 5191 5192;
mul 46 2224; mul 196 5194; mul 47 2214; sub 5195 5196; mul 51 2238; sub 5197 5198; mul 890 1005; mul 122 994; mul 46
1008; add 5201 5202; sub 5200 5203; mul 897 1021; sub 5204 5205; mul 122 1628; mul 46 1641; add 5207 5208; mul 890
1643; sub 5209 5210; mul 897 1655; add 5211 5212; mul 890 2224; mul 122 2214; mul 46 2226; add 5215 5216; sub 5214
5217; mul 897 2238; sub 5218 5219; mul 890 1008; neg 5221; mul 196 5222; mul 921 994; sub 5223 5224; mul 901 1021;
sub 5225 5226; mul 921 1628; mul 890 1641; mul 196 5229; add 5228 5230; mul 901 1655; add 5231 5232; mul 890 2226;
neg 5234; mul 196 5235; mul 921 2214; sub 5236 5237; mul 901 2238; sub 5238 5239; mul 51 1005; mul 990 5241; mul 52
994; sub 5242 5243; mul 52 1628; mul 51 1643; mul 990 5246; sub 5245 5247; mul 51 2224; mul 990 5249; mul 52 2214;
sub 5250 5251; mul 897 1005; mul 196 5253; mul 129 994; mul 51 1008; add 5255 5256; sub 5254 5257; mul 129 1628; mul
51 1641; add 5259 5260; mul 897 1643; neg 5262; mul 196 5263; add 5261 5264; mul 897 2224; mul 196 5266; mul 129
2214; mul 51 2226; add 5268 5269; sub 5267 5270; mul 897 1008; neg 5272; mul 196 5273; mul 931 994; sub 5274 5275;
mul 901 1005; add 5276 5277; mul 931 1628; mul 897 1641; mul 196 5280; add 5279 5281; mul 901 1643; sub 5282 5283;
mul 897 2226; neg 5285; mul 196 5286; mul 931 2214; sub 5287 5288; mul 901 2224; add 5289 5290; mul 904 994; mul 901
1008; mul 990 5293; add 5292 5294; neg 5295; mul 904 1628; mul 901 1641; mul 990 5298; add 5297 5299; mul 904 2214;
mul 901 2226; mul 990 5302; add 5301 5303; neg 5304; mul 22 693; mul 955 5306; mul 22 1551; mul 955 5308; mul 22
2135; mul 955 5310; mul 22 2574; mul 955 5312; mul 22 2686; mul 955 5314; mul 22 686; mul 42 693; mul 990 5317; add
5316 5318; mul 22 1545; mul 42 1551; mul 990 5321; add 5320 5322; mul 22 2129; mul 42 2135; mul 990 5325; add 5324
5326; mul 22 2569; mul 42 2574; mul 990 5329; add 5328 5330; mul 22 2681; mul 42 2686; mul 990 5333; add 5332 5334;
mul 22 700; mul 115 693; mul 990 5337; add 5336 5338; mul 22 1558; mul 115 1551; mul 990 5341; add 5340 5342; mul 22
2142; mul 115 2135; mul 990 5345; add 5344 5346; mul 22 2581; mul 115 2574; mul 990 5349; add 5348 5350; mul 22
2693; mul 115 2686; mul 990 5353; add 5352 5354; mul 42 686; mul 196 5356; mul 47 693; mul 196 5358; add 5357 5359;
mul 42 1545; mul 196 5361; mul 47 1551; mul 196 5363; add 5362 5364; mul 42 2129; mul 196 5366; mul 47 2135; mul 196
5368; add 5367 5369; mul 42 2569; mul 196 5371; mul 47 2574; mul 196 5373; add 5372 5374; mul 42 2681; mul 196 5376;
mul 47 2686; mul 196 5378; add 5377 5379; mul 42 700; mul 115 686; add 5381 5382; mul 122 693; mul 196 5384; add
5383 5385; mul 42 1558; mul 115 1545; add 5387 5388; mul 122 1551; mul 196 5390; add 5389 5391; mul 42 2142; mul 115
2129; add 5393 5394; mul 122 2135; mul 196 5396; add 5395 5397; mul 42 2581; mul 115 2569; add 5399 5400; mul 122
2574; mul 196 5402; add 5401 5403; mul 42 2693; mul 115 2681; add 5405 5406; mul 122 2686; mul 196 5408; add 5407
5409; mul 47 686; mul 990 5411; mul 52 693; add 5412 5413; mul 47 1545; mul 990 5415; mul 52 1551; add 5416 5417;
mul 47 2129; mul 990 5419; mul 52 2135; add 5420 5421; mul 47 2569; mul 990 5423; mul 52 2574; add 5424 5425; mul 47
2681; mul 990 5427; mul 52 2686; add 5428 5429; mul 47 700; mul 122 686; mul 196 5432; add 5431 5433; mul 129 693;
add 5434 5435; mul 47 1558; mul 122 1545; mul 196 5438; add 5437 5439; mul 129 1551; add 5440 5441; mul 47 2142; mul
122 2129; mul 196 5444; add 5443 5445; mul 129 2135; add 5446 5447; mul 47 2581; mul 122 2569; mul 196 5450; add
5449 5451; mul 129 2574; add 5452 5453; mul 47 2693; mul 122 2681; mul 196 5456; add 5455 5457; mul 129 2686; add
5458 5459; mul 52 686; mul 955 5461; mul 52 1545; mul 955 5463; mul 52 2129; mul 955 5465; mul 52 2569; mul 955
5467; mul 52 2681; mul 955 5469; mul 52 700; mul 129 686; mul 990 5472; add 5471 5473; mul 52 1558; mul 129 1545;
mul 990 5476; add 5475 5477; mul 52 2142; mul 129 2129; mul 990 5480; add 5479 5481; mul 52 2581; mul 129 2569; mul
990 5484; add 5483 5485; mul 52 2693; mul 129 2681; mul 990 5488; add 5487 5489; mul 449 4243; mul 447 4195; sub
5491 5492; mul 451 4304; sub 5493 5494; mul 423 4318; mul 405 4320; add 5496 5497; mul 427 4309; add 5498 5499; mul
424 5500; add 5495 5501; mul 405 4312; mul 423 4310; sub 5503 5504; mul 424 5505; add 5502 5506; mul 410 4314; add
5507 5508; mul 410 4324; sub 5509 5510; mul 434 4309; mul 436 5512; add 5511 5513; mul 404 4370; add 5514 5515; mul
404 4378; add 5516 5517; mul 423 4331; mul 412 4320; mul 412 4312; add 5520 5521; sub 5519 5522; mul 423 4334; add
5523 5524; mul 429 5525; add 5518 5526; mul 421 4336; add 5527 5528; mul 1360 4195; mul 1351 4243; sub 5530 5531;
mul 449 4304; add 5532 5533; mul 427 4532; sub 5535 4746; mul 424 5536; add 5534 5537; sub 4369 4364; mul 423 4533;
sub 5539 5540; mul 405 4537; add 5541 5542; mul 424 5543; add 5538 5544; mul 410 4539; add 5545 5546; mul 410 4542;
sub 5547 5548; mul 434 4532; add 4322 5550; mul 436 5551; add 5549 5552; mul 404 4577; add 5553 5554; mul 404 4586;
add 5555 5556; sub 4783 4782; mul 412 4537; sub 5558 5559; mul 423 4545; add 5560 5561; mul 429 5562; add 5557 5563;
mul 421 4548; add 5564 5565; mul 1360 4243; mul 1938 4195; sub 5567 5568; mul 447 4304; sub 5569 5570; mul 427 4736;
mul 424 5572; add 5571 5573; sub 5520 5524; mul 423 4737; sub 5575 5576; mul 405 4740; add 5577 5578; mul 424 5579;
add 5574 5580; mul 410 4742; add 5581 5582; mul 410 4748; add 5583 5584; mul 434 4736; sub 5586 5498; mul 436 5587;
add 5585 5588; mul 404 4788; add 5589 5590; mul 404 4793; add 5591 5592; mul 423 4751; mul 412 4740; sub 5594 5595;
mul 429 5596; add 5593 5597; mul 421 4755; add 5598 5599; sub 4314 4324; sub 4539 4542; add 4742 4748; mul 263 4395;
mul 263 4602; mul 263 4809; mul 272 4060; mul 272 5607; mul 74 666; mul 2 5609; add 690 5610; mul 2 5611; add 5608
5612; mul 399 5500; mul 98 5614; mul 4046 4194; sub 5615 5616; mul 399 5505; mul 98 5618; add 5617 5619; mul 403
4315; add 5620 5621; mul 403 4325; sub 5622 5623; mul 82 196; mul 399 5512; mul 5625 5626; add 5624 5627; mul 2
5628; add 5613 5629; mul 272 4441; mul 272 5631; mul 74 1536; mul 2 5633; sub 5634 1549; mul 2 5635; add 5632 5636;
mul 399 5536; mul 98 5638; add 4359 5639; mul 399 5543; mul 98 5641; add 5640 5642; mul 403 4540; add 5643 5644; mul
403 4543; sub 5645 5646; mul 399 5551; mul 5625 5648; add 5647 5649; mul 2 5650; add 5637 5651; mul 272 4646; mul
272 5653; mul 74 2120; mul 2 5655; add 2132 5656; mul 2 5657; add 5654 5658; mul 399 5572; mul 98 5660; mul 4056
4194; sub 5661 5662; mul 399 5579; mul 98 5664; add 5663 5665; mul 403 4743; add 5666 5667; mul 403 4749; add 5668
5669; mul 399 5587; mul 5625 5671; add 5670 5672; mul 2 5673; add 5659 5674; mul 74 2560; mul 2 5676; add 2571 5677;
mul 2 5678; mul 74 2668; mul 2 5680; add 2683 5681; mul 2 5682; mul 260 4060; mul 272 5684; mul 260 5607; add 5685
5686; mul 27 5609; add 570 5688; mul 2 5689; add 5687 5690; mul 27 5611; add 5691 5692; mul 27 5628; add 5693 5694;
mul 2 4384; add 5695 5696; mul 260 4441; mul 272 5698; mul 260 5631; add 5699 5700; mul 27 5633; add 1378 5702; mul
2 5703; add 5701 5704; mul 27 5635; add 5705 5706; mul 27 5650; add 5707 5708; mul 2 4591; add 5709 5710; mul 260
4646; mul 272 5712; mul 260 5653; add 5713 5714; mul 27 5655; add 2041 5716; mul 2 5717; add 5715 5718; mul 27 5657;
add 5719 5720; mul 27 5673; add 5721 5722; mul 2 4798; add 5723 5724; mul 27 5676; add 2521 5726; mul 2 5727; mul 27
5678; add 5728 5729; mul 27 5680; add 2670 5731; mul 2 5732; mul 27 5682; add 5733 5734; mul 260 5684; mul 27 5689;
add 5736 5737; mul 27 4384; add 5738 5739; mul 260 5698; mul 27 5703; add 5741 5742; mul 27 4591; add 5743 5744; mul
260 5712; mul 27 5717; add 5746 5747; mul 27 4798; add 5748 5749; mul 27 5727; mul 27 5732; mul 292 4060; mul 272
5753; mul 292 5607; add 5754 5755; mul 59 5609; add 472 5757; mul 2 5758; add 5756 5759; mul 59 5611; add 5760 5761;
mul 59 5628; add 5762 5763; mul 82 5614; sub 5765 5662; mul 82 5618; add 5766 5767; mul 403 4371; add 5768 5769; mul
403 4379; add 5770 5771; mul 98 196; mul 399 5525; mul 5773 5774; add 5772 5775; mul 2 5776; add 5764 5777; mul 292
4441; mul 272 5779; mul 292 5631; add 5780 5781; mul 59 5633; sub 5783 1457; mul 2 5784; add 5782 5785; mul 59 5635;
add 5786 5787; mul 59 5650; add 5788 5789; mul 82 5638; add 4777 5791; mul 82 5641; add 5792 5793; mul 403 4578; add
5794 5795; mul 403 4587; add 5796 5797; mul 399 5562; mul 5773 5799; add 5798 5800; mul 2 5801; add 5790 5802; mul
292 4646; mul 272 5804; mul 292 5653; add 5805 5806; mul 59 5655; add 1961 5808; mul 2 5809; add 5807 5810; mul 59
5657; add 5811 5812; mul 59 5673; add 5813 5814; mul 82 5660; mul 4194 4642; sub 5816 5817; mul 82 5664; add 5818
5819; mul 403 4789; add 5820 5821; mul 403 4794; add 5822 5823; mul 399 5596; mul 5773 5825; add 5824 5826; mul 2
5827; add 5815 5828; mul 59 5676; add 2519 5830; mul 2 5831; mul 59 5678; add 5832 5833; mul 59 5680; add 2630 5835;
mul 2 5836; mul 59 5682; add 5837 5838; mul 260 5753; mul 292 5684; add 5840 5841; mul 27 5758; add 5842 5843; mul
59 5689; add 5844 5845; mul 27 5776; add 5846 5847; mul 59 4384; add 5848 5849; mul 260 5779; mul 292 5698; add 5851
5852; mul 27 5784; add 5853 5854; mul 59 5703; add 5855 5856; mul 27 5801; add 5857 5858; mul 59 4591; add 5859
5860; mul 260 5804; mul 292 5712; add 5862 5863; mul 27 5809; add 5864 5865; mul 59 5717; add 5866 5867; mul 27
5827; add 5868 5869; mul 59 4798; add 5870 5871; mul 27 5831; mul 59 5727; add 5873 5874; mul 27 5836; mul 59 5732;
add 5876 5877; mul 292 5753; mul 59 5758; add 5879 5880; mul 59 5776; add 5881 5882; mul 292 5779; mul 59 5784; add
5884 5885; mul 59 5801; add 5886 5887; mul 292 5804; mul 59 5809; add 5889 5890; mul 59 5827; add 5891 5892; mul 59
5831; mul 59 5836; mul 174 4088; mul 400 5896; sub 458 5897; mul 174 4462; mul 400 5899; add 1364 5900; mul 174
4669; mul 400 5902; sub 1947 5903; mul 4044 4350; mul 72 5896; sub 5905 5906; mul 4044 4354; add 5907 5908; mul 401
4384; add 5909 5910; mul 407 4339; add 5911 5912; mul 72 5899; mul 4044 4562; add 5914 5915; mul 4044 4565; add 5916
5917; mul 401 4591; add 5918 5919; mul 407 4551; add 5920 5921; mul 4044 4768; mul 72 5902; sub 5923 5924; mul 4044
4772; add 5925 5926; mul 401 4798; add 5927 5928; mul 407 4758; add 5929 5930; neg 449; neg 233; neg 357; neg 236;
neg 360; neg 240; neg 364; input p 238; mul 333 497; mul 5939 5940; add 497 5941; input p 239; mul 5940 5943; mul 74
5944; add 5942 5945; add 596 5946; mul 205 596; mul 5939 5948; add 5947 5949; mul 5943 5948; mul 74 5951; add 5950
5952; mul 333 1392; mul 5939 5954; add 1392 5955; mul 5943 5954; mul 74 5957; add 5956 5958; add 1484 5959; mul 205
1484; mul 5939 5961; add 5960 5962; mul 5943 5961; mul 74 5964; add 5963 5965; neg 5966; mul 333 1983; mul 5939
5968; add 1983 5969; mul 5943 5968; mul 74 5971; add 5970 5972; add 2064 5973; mul 205 2064; mul 5939 5975; add 5974
5976; mul 5943 5975; mul 74 5978; add 5977 5979; mul 205 2533; mul 5939 5981; add 2533 5982; mul 5943 5981; mul 74
5984; add 5983 5985; mul 333 2641; mul 5939 5987; add 2641 5988; mul 5943 5987; mul 74 5990; add 5989 5991; le 7
4265; le 4265 7; add 5993 5994; div 17 5995; mul 5993 5996; mul 272 451; mul 5997 5998; neg 5999; mul 272 449; mul
5997 6001; mul 272 447; mul 5997 6003; neg 6004; mul 4279 5998; neg 6006; mul 4279 6001; mul 4279 6003; neg 6009;
mul 451 4288; mul 272 6011; neg 6012; mul 449 4288; mul 272 6014; mul 447 4288; mul 272 6016; neg 6017; input p 240;
mul 4288 4289; mul 451 6020; mul 196 4287; div 17 6022; mul 6021 6023; mul 6019 6024; mul 449 6020; mul 6023 6026;
mul 6019 6027; neg 6028; mul 447 6020; mul 6023 6030; mul 6019 6031; mul 449 4234; mul 1351 4234; neg 6034; mul 1360
4234; le 17 4213; mul 260 4235; add 272 6038; lt 7 6039; and 6037 6040; constant -1.0; le 4213 6042; lt 6039 7; and
6043 6044; or 6041 6045; not 6046; input p 177; mul 260 6048; where 6047 6049; le 17 4216; and 6040 6051; le 4216
6042; and 6044 6053; or 6052 6054; not 6055; input p 178; mul 260 6057; where 6056 6058; le 17 4220; and 6040 6060;
le 4220 6042; and 6044 6062; or 6061 6063; not 6064; input p 179; mul 260 6066; where 6065 6067; le 17 4224; and
6040 6069; le 4224 6042; and 6044 6071; or 6070 6072; not 6073; input p 180; mul 260 6075; where 6074 6076; le 17
4228; and 6040 6078; le 4228 6042; and 6044 6080; or 6079 6081; not 6082; input p 181; mul 260 6084; where 6083
6085; le 17 4232; and 6040 6087; le 4232 6042; and 6044 6089; or 6088 6090; not 6091; input p 182; mul 260 6093;
where 6092 6094; mul 170 4117; mul 170 4104; mul 174 4107; add 6097 6098; mul 174 665; add 6099 6100; sub 6096 6101;
mul 170 4479; mul 174 4482; add 6103 6104; mul 174 1535; sub 6105 6106; mul 170 4491; add 6107 6108; mul 170 4696;
mul 170 4684; mul 174 4687; add 6111 6112; mul 174 2119; add 6113 6114; sub 6110 6115; mul 170 4852; mul 170 4843;
mul 174 4841; add 6118 6119; mul 174 2560; add 6120 6121; sub 6117 6122; mul 170 4107; mul 174 4104; sub 6124 6125;
mul 170 665; add 6126 6127; mul 174 4117; add 6128 6129; mul 174 4479; mul 170 4482; sub 6131 6132; mul 170 1535;
add 6133 6134; mul 174 4491; add 6135 6136; mul 170 4687; mul 174 4684; sub 6138 6139; mul 170 2119; add 6140 6141;
mul 174 4696; add 6142 6143; mul 170 4841; mul 174 4843; sub 6145 6146; mul 170 2560; add 6147 6148; mul 174 4852;
add 6149 6150; neg 4117; neg 4491; neg 4696; neg 4852; mul 178 193; mul 645 6156; mul 178 247; mul 628 6158; add
6157 6159; mul 178 231; mul 467 6161; add 6160 6162; mul 178 189; mul 661 6164; add 6163 6165; neg 6166; mul 1500
6158; mul 1515 6156; sub 6168 6169; mul 1373 6161; add 6170 6171; mul 1531 6164; sub 6172 6173; mul 2099 6156; mul
2083 6158; add 6175 6176; mul 1956 6161; add 6177 6178; mul 2115 6164; add 6179 6180; neg 6181; mul 2550 6156; mul
2536 6158; add 6183 6184; mul 2556 6164; add 6185 6186; neg 6187; mul 200 647; mul 200 1517; neg 6190; mul 200 2101;
neg 1494; mul 207 619; mul 207 1494; neg 6195; mul 207 2077; mul 228 599; mul 220 6198; neg 6199; mul 228 1472; mul
220 6201; mul 228 2067; mul 220 6203; neg 6204; input p 241; mul 205 603; mul 6206 6207; add 603 6208; input p 242;
mul 6207 6210; mul 74 6211; add 6209 6212; neg 6213; mul 205 1488; mul 6206 6215; add 1488 6216; mul 6210 6215; mul
74 6218; add 6217 6219; mul 205 2071; mul 6206 6221; add 2071 6222; mul 6210 6221; mul 74 6224; add 6223 6225; neg
6226; mul 254 467; mul 233 6228; mul 254 1373; mul 233 6230; neg 6231; mul 254 1956; mul 233 6233; mul 236 6228; mul
236 6230; neg 6236; mul 236 6233; mul 240 6228; mul 240 6230; neg 6240; mul 240 6233; mul 254 589; mul 254 1477; neg
6244; mul 254 2057; mul 170 4090; mul 174 4086; add 6247 6248; mul 174 566; add 6249 6250; mul 170 4101; sub 6251
6252; mul 174 1454; mul 170 4464; mul 174 4467; add 6255 6256; sub 6254 6257; mul 170 4476; sub 6258 6259; mul 170
4671; mul 174 4667; add 6261 6262; mul 174 2038; add 6263 6264; mul 170 4681; sub 6265 6266; mul 170 4882; mul 174
4884; add 6268 6269; mul 174 2668; add 6270 6271; mul 170 4893; sub 6272 6273; mul 170 4086; mul 174 4090; sub 6275
6276; mul 170 566; add 6277 6278; mul 174 4101; add 6279 6280; mul 174 4464; mul 170 4467; sub 6282 6283; mul 170
1454; add 6284 6285; mul 174 4476; add 6286 6287; mul 170 4667; mul 174 4671; sub 6289 6290; mul 170 2038; add 6291
6292; mul 174 4681; add 6293 6294; mul 170 4884; mul 174 4882; sub 6296 6297; mul 170 2668; add 6298 6299; mul 174
4893; add 6300 6301; mul 310 325; mul 546 6303; mul 310 370; mul 529 6305; add 6304 6306; mul 310 355; mul 460 6308;
add 6307 6309; mul 310 321; mul 562 6311; add 6310 6312; neg 6313; mul 1408 6305; mul 1430 6303; sub 6315 6316; mul
1366 6308; add 6317 6318; mul 1446 6311; sub 6319 6320; mul 2018 6303; mul 2002 6305; add 6322 6323; mul 1949 6308;
add 6324 6325; mul 2034 6311; add 6326 6327; neg 6328; mul 2658 6303; mul 2644 6305; add 6330 6331; mul 2664 6311;
add 6332 6333; neg 6334; mul 331 548; mul 331 1432; neg 6337; mul 331 2020; neg 1402; mul 335 520; mul 335 1402; neg
6342; mul 335 1996; mul 352 500; mul 344 6345; neg 6346; mul 352 1380; mul 344 6348; mul 352 1986; mul 344 6350; neg
6351; input p 243; mul 333 504; mul 6353 6354; add 504 6355; input p 244; mul 6354 6357; mul 74 6358; add 6356 6359;
neg 6360; mul 333 1396; mul 6353 6362; add 1396 6363; mul 6357 6362; mul 74 6365; add 6364 6366; mul 333 1990; mul
6353 6368; add 1990 6369; mul 6357 6368; mul 74 6371; add 6370 6372; neg 6373; mul 375 460; mul 357 6375; mul 375
1366; mul 357 6377; neg 6378; mul 375 1949; mul 357 6380; mul 360 6375; mul 360 6377; neg 6383; mul 360 6380; mul
364 6375; mul 364 6377; neg 6387; mul 364 6380; mul 375 490; mul 375 1385; neg 6391; mul 375 1976; mul 449 4235; sub
6394 451; mul 4213 6395; mul 1351 4235; sub 449 6397; mul 4213 6398; mul 1360 4235; sub 6400 447; mul 4213 6401; mul
4216 6395; mul 4216 6398; mul 4216 6401; mul 4220 6395; mul 4220 6398; mul 4220 6401; mul 4224 6395; mul 4224 6398;
mul 4224 6401; mul 4228 6395; mul 4228 6398; mul 4228 6401; mul 4232 6395; mul 4232 6398; mul 4232 6401; mul 6039
6048; mul 6048 6418; neg 6419; where 6047 6420; mul 6039 6057; mul 6057 6422; neg 6423; where 6056 6424; mul 6039
6066; mul 6066 6426; neg 6427; where 6065 6428; mul 6039 6075; mul 6075 6430; neg 6431; where 6074 6432; mul 6039
6084; mul 6084 6434; neg 6435; where 6083 6436; mul 6039 6093; mul 6093 6438; neg 6439; where 6092 6440; mul 451
4295; neg 6442; mul 449 4295; mul 447 4295; neg 6445; mul 451 4299; neg 6447; mul 449 4299; mul 447 4299; neg 6450;
mul 342 500; mul 216 6452; mul 214 599; mul 216 6454; add 6453 6455; neg 6456; mul 342 1380; mul 216 6458; mul 214
1472; mul 216 6460; add 6459 6461; mul 342 1986; mul 216 6463; mul 214 2067; mul 216 6465; add 6464 6466; neg 6467;
sub 17 216; mul 766 3949; mul 3 1345; sub 6470 6471; mul 766 3961; mul 3 1932; add 6473 6474; mul 766 3973; mul 3
2515; sub 6476 6477; store by_k 114 1347; store by_k 342 1934; store by_k 570 2517; store by_k 684 2628; store by_k
798 2739; store by_k 912 2628; store by_k 1026 2739; store by_k 1140 2628; store by_k 1254 2739; store by_k 115
2883; store by_k 343 2888; store by_k 571 2893; store by_k 116 2913; store by_k 344 2925; store by_k 572 2937; store
by_k 117 3072; store by_k 345 3180; store by_k 573 3288; store by_k 118 3454; store by_k 346 3582; store by_k 574
3710; store by_k 119 3787; store by_k 347 3861; store by_k 575 3935; store by_k 120 3950; store by_k 348 3962; store
by_k 576 3974; store by_k 121 3989; store by_k 349 4001; store by_k 577 4013; store by_k 122 4024; store by_k 350
4031; store by_k 578 4041; store by_k 123 4427; store by_k 351 4633; store by_k 579 4840; store by_k 693 4881; store
by_k 807 4922; store by_k 921 4881; store by_k 1035 4922; store by_k 1149 4881; store by_k 1263 4922; store by_k 124
4925; store by_k 352 4927; store by_k 580 4930; store by_k 125 4934; store by_k 353 4938; store by_k 581 4942; store
by_k 126 4947; store by_k 354 4951; store by_k 582 4956; store by_k 127 4962; store by_k 355 4968; store by_k 583
4974; store by_k 128 4981; store by_k 356 4987; store by_k 584 4994; store by_k 129 5001; store by_k 357 5006; store
by_k 585 5013; store by_k 130 5017; store by_k 358 5021; store by_k 586 5025; store by_k 131 5031; store by_k 359
5038; store by_k 587 5044; store by_k 132 5051; store by_k 360 5057; store by_k 588 5064; store by_k 133 5068; store
by_k 361 5071; store by_k 589 5075; store by_k 134 5077; store by_k 362 5080; store by_k 590 5082; store by_k 135
5086; store by_k 363 5090; store by_k 591 5094; store by_k 136 5100; store by_k 364 5106; store by_k 592 5112; store
by_k 137 5115; store by_k 365 5118; store by_k 593 5121; store by_k 138 5123; store by_k 366 5124; store by_k 594
5126; store by_k 139 5131; store by_k 367 5135; store by_k 595 5140; store by_k 140 5147; store by_k 368 5153; store
by_k 596 5160; store by_k 141 5167; store by_k 369 5173; store by_k 597 5180; store by_k 142 5186; store by_k 370
5193; store by_k 598 5199; store by_k 143 5206; store by_k 371 5213; store by_k 599 5220; store by_k 144 5227; store
by_k 372 5233; store by_k 600 5240; store by_k 145 5244; store by_k 373 5248; store by_k 601 5252; store by_k 146
5258; store by_k 374 5265; store by_k 602 5271; store by_k 147 5278; store by_k 375 5284; store by_k 603 5291; store
by_k 148 5296; store by_k 376 5300; store by_k 604 5305; store by_k 149 5307; store by_k 377 5309; store by_k 605
5311; store by_k 719 5313; store by_k 833 5315; store by_k 947 5313; store by_k 1061 5315; store by_k 1175 5313;
store by_k 1289 5315; store by_k 150 5319; store by_k 378 5323; store by_k 606 5327; store by_k 720 5331; store by_k
834 5335; store by_k 948 5331; store by_k 1062 5335; store by_k 1176 5331; store by_k 1290 5335; store by_k 151
5339; store by_k 379 5343; store by_k 607 5347; store by_k 721 5351; store by_k 835 5355; store by_k 949 5351; store
by_k 1063 5355; store by_k 1177 5351; store by_k 1291 5355; store by_k 152 5360; store by_k 380 5365; store by_k 608
5370; store by_k 722 5375; store by_k 836 5380; store by_k 950 5375; store by_k 1064 5380; store by_k 1178 5375;
store by_k 1292 5380; store by_k 153 5386; store by_k 381 5392; store by_k 609 5398; store by_k 723 5404; store by_k
837 5410; store by_k 951 5404; store by_k 1065 5410; store by_k 1179 5404; store by_k 1293 5410; store by_k 154
5414; store by_k 382 5418; store by_k 610 5422; store by_k 724 5426; store by_k 838 5430; store by_k 952 5426; store
by_k 1066 5430; store by_k 1180 5426; store by_k 1294 5430; store by_k 155 5436; store by_k 383 5442; store by_k 611
5448; store by_k 725 5454; store by_k 839 5460; store by_k 953 5454; store by_k 1067 5460; store by_k 1181 5454;
store by_k 1295 5460; store by_k 156 5462; store by_k 384 5464; store by_k 612 5466; store by_k 726 5468; store by_k
840 5470; store by_k 954 5468; store by_k 1068 5470; store by_k 1182 5468; store by_k 1296 5470; store by_k 157
5474; store by_k 385 5478; store by_k 613 5482; store by_k 727 5486; store by_k 841 5490; store by_k 955 5486; store
by_k 1069 5490; store by_k 1183 5486; store by_k 1297 5490; store by_k 158 5529; store by_k 386 5566; store by_k 614
5600; store by_k 159 5601; store by_k 387 5602; store by_k 615 5603; store by_k 160 4336; store by_k 388 4548; store
by_k 616 4755; store by_k 161 5604; store by_k 389 5605; store by_k 617 5606; store by_k 162 5525; store by_k 390
5562; store by_k 618 5596; store by_k 163 5630; store by_k 391 5652; store by_k 619 5675; store by_k 733 5679; store
by_k 847 5683; store by_k 961 5679; store by_k 1075 5683; store by_k 1189 5679; store by_k 1303 5683; store by_k 164
5697; store by_k 392 5711; store by_k 620 5725; store by_k 734 5730; store by_k 848 5735; store by_k 962 5730; store
by_k 1076 5735; store by_k 1190 5730; store by_k 1304 5735; store by_k 165 5740; store by_k 393 5745; store by_k 621
5750; store by_k 735 5751; store by_k 849 5752; store by_k 963 5751; store by_k 1077 5752; store by_k 1191 5751;
store by_k 1305 5752; store by_k 166 5778; store by_k 394 5803; store by_k 622 5829; store by_k 736 5834; store by_k
850 5839; store by_k 964 5834; store by_k 1078 5839; store by_k 1192 5834; store by_k 1306 5839; store by_k 167
5850; store by_k 395 5861; store by_k 623 5872; store by_k 737 5875; store by_k 851 5878; store by_k 965 5875; store
by_k 1079 5878; store by_k 1193 5875; store by_k 1307 5878; store by_k 168 5883; store by_k 396 5888; store by_k 624
5893; store by_k 738 5894; store by_k 852 5895; store by_k 966 5894; store by_k 1080 5895; store by_k 1194 5894;
store by_k 1308 5895; store by_k 169 5898; store by_k 397 5901; store by_k 625 5904; store by_k 170 5913; store by_k
398 5922; store by_k 626 5931; store by_k 171 451; store by_k 399 5932; store by_k 627 447; store by_k 742 5933;
store by_k 856 5934; store by_k 971 5935; store by_k 1085 5936; store by_k 1200 5937; store by_k 1314 5938; store
by_k 175 5953; store by_k 403 5967; store by_k 631 5980; store by_k 745 5986; store by_k 859 5992; store by_k 973
5986; store by_k 1087 5992; store by_k 1201 5986; store by_k 1315 5992; store by_k 176 6000; store by_k 404 6002;
store by_k 632 6005; store by_k 177 6007; store by_k 405 6008; store by_k 633 6010; store by_k 178 6013; store by_k
406 6015; store by_k 634 6018; store by_k 179 6025; store by_k 407 6029; store by_k 635 6032; store by_k 180 6033;
store by_k 408 6035; store by_k 636 6036; store by_k 1776 6050; store by_k 1890 6059; store by_k 2004 6068; store
by_k 2118 6077; store by_k 2232 6086; store by_k 2346 6095; store by_k 181 6102; store by_k 409 6109; store by_k 637
6116; store by_k 751 6123; store by_k 979 6123; store by_k 1207 6123; store by_k 182 6130; store by_k 410 6137;
store by_k 638 6144; store by_k 752 6151; store by_k 980 6151; store by_k 1208 6151; store by_k 183 6152; store by_k
411 6153; store by_k 639 6154; store by_k 753 6155; store by_k 981 6155; store by_k 1209 6155; store by_k 184 665;
store by_k 412 1535; store by_k 640 2119; store by_k 754 2560; store by_k 982 2560; store by_k 1210 2560; store by_k
185 6167; store by_k 413 6174; store by_k 641 6182; store by_k 755 6188; store by_k 983 6188; store by_k 1211 6188;
store by_k 186 6189; store by_k 414 6191; store by_k 642 6192; store by_k 187 619; store by_k 415 6193; store by_k
643 2077; store by_k 188 6194; store by_k 416 6196; store by_k 644 6197; store by_k 189 6200; store by_k 417 6202;
store by_k 645 6205; store by_k 190 6214; store by_k 418 6220; store by_k 646 6227; store by_k 191 6229; store by_k
419 6232; store by_k 647 6234; store by_k 192 6235; store by_k 420 6237; store by_k 648 6238; store by_k 193 6239;
store by_k 421 6241; store by_k 649 6242; store by_k 194 6243; store by_k 422 6245; store by_k 650 6246; store by_k
195 6253; store by_k 423 6260; store by_k 651 6267; store by_k 879 6274; store by_k 1107 6274; store by_k 1335 6274;
store by_k 196 6281; store by_k 424 6288; store by_k 652 6295; store by_k 880 6302; store by_k 1108 6302; store by_k
1336 6302; store by_k 197 4101; store by_k 425 4476; store by_k 653 4681; store by_k 881 4893; store by_k 1109 4893;
store by_k 1337 4893; store by_k 198 566; store by_k 426 1454; store by_k 654 2038; store by_k 882 2668; store by_k
1110 2668; store by_k 1338 2668; store by_k 199 6314; store by_k 427 6321; store by_k 655 6329; store by_k 883 6335;
store by_k 1111 6335; store by_k 1339 6335; store by_k 200 6336; store by_k 428 6338; store by_k 656 6339; store
by_k 201 520; store by_k 429 6340; store by_k 657 1996; store by_k 202 6341; store by_k 430 6343; store by_k 658
6344; store by_k 203 6347; store by_k 431 6349; store by_k 659 6352; store by_k 204 6361; store by_k 432 6367; store
by_k 660 6374; store by_k 205 6376; store by_k 433 6379; store by_k 661 6381; store by_k 206 6382; store by_k 434
6384; store by_k 662 6385; store by_k 207 6386; store by_k 435 6388; store by_k 663 6389; store by_k 208 6390; store
by_k 436 6392; store by_k 664 6393; store by_k 209 6396; store by_k 437 6399; store by_k 665 6402; store by_k 210
6403; store by_k 438 6404; store by_k 666 6405; store by_k 211 6406; store by_k 439 6407; store by_k 667 6408; store
by_k 212 6409; store by_k 440 6410; store by_k 668 6411; store by_k 213 6412; store by_k 441 6413; store by_k 669
6414; store by_k 214 6415; store by_k 442 6416; store by_k 670 6417; store by_k 1811 6421; store by_k 1926 6425;
store by_k 2041 6429; store by_k 2156 6433; store by_k 2271 6437; store by_k 2386 6441; store by_k 221 6443; store
by_k 449 6444; store by_k 677 6446; store by_k 222 6448; store by_k 450 6449; store by_k 678 6451; store by_k 1477
4295; store by_k 1592 4299; store by_k 225 6457; store by_k 453 6462; store by_k 681 6468; store by_k 1708 6469;
store by_k 227 6472; store by_k 455 6475; store by_k 683 6478
    """,
)
