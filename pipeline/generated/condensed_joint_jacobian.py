"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 79},
    {'p': 206},
    """
input k 78; input k 0; constant 1.0; div 2 1; mul 0 3; constant -2.0; input k 2; mul 5 6; input k 33; input k 1;
constant -6.000000000000002; constant -18.000000000000004; input k 6; mul 12 12; input k 4; mul 13 14; mul 11 15;
add 10 16; constant -0.09999999999999995; input k 3; mul 13 19; mul 18 20; add 17 21; input k 7; input k 8; constant
28.79999999999999; mul 12 14; mul 25 26; constant -22.62857142857143; mul 14 28; constant -0.057142857142856635; mul
19 30; add 29 31; constant 36.0; mul 26 33; constant -28.799999999999976; mul 14 35; constant 0.05714285714285722;
mul 19 37; add 36 38; constant -50.400000000000006; mul 14 40; constant -1.1428571428571423; mul 19 42; add 41 43;
constant 12.000000000000004; constant 36.000000000000014; mul 15 46; add 45 47; constant 1.2; mul 20 49; add 48 50;
constant -57.60000000000001; mul 26 52; constant 45.25714285714287; mul 14 54; constant 0.9142857142857138; mul 19
56; add 55 57; constant -72.00000000000001; mul 26 59; constant 57.599999999999916; mul 14 61; constant
-1.7142857142857166; mul 19 63; add 62 64; constant 230.40000000000006; mul 14 66; constant 2.057142857142858; mul
19 68; add 67 69; constant -388.80000000000024; mul 14 71; constant -7.714285714285722; mul 19 73; add 72 74;
constant 259.2000000000001; mul 14 76; constant 12.34285714285715; mul 19 78; add 77 79; constant
-0.9999999999999998; mul 12 81; mul 12 13; mul 14 83; mul 81 84; add 82 85; constant -0.033333333333333326; mul 20
87; constant -2.3999999999999995; mul 26 89; constant 0.4571428571428564; mul 14 91; constant -0.019047619047619094;
mul 19 93; add 92 94; constant 4.000000000000001; constant 12.0; mul 15 97; add 96 98; constant 0.13333333333333333;
mul 20 100; add 99 101; constant -14.399999999999991; mul 26 103; constant 13.714285714285717; mul 14 105; constant
0.11428571428571413; mul 19 107; add 106 108; constant -30.000000000000007; mul 26 110; mul 12 19; sub 111 112;
constant 21.59999999999998; mul 14 114; constant 0.6571428571428567; mul 19 116; add 115 117; constant
35.20000000000001; mul 14 119; constant 2.438095238095238; mul 19 121; add 120 122; constant 72.0; mul 26 124;
constant -57.59999999999995; mul 14 126; constant 0.11428571428571443; mul 19 128; add 127 129; constant
-151.20000000000002; mul 14 131; constant -3.428571428571427; mul 19 133; add 132 134; constant -36.00000000000001;
mul 26 136; constant 28.799999999999958; mul 14 138; constant -0.8571428571428583; mul 19 140; add 139 141; constant
-129.60000000000008; mul 14 143; constant -2.5714285714285743; mul 19 145; add 144 146; input k 19; constant 2.0;
input k 18; input k 17; input k 16; input k 27; input k 43; input k 38; input k 15; sub 156 2; input k 40; input k
39; input k 41; sub 160 1; constant 8.118473726939319e-05; input k 5; mul 162 163; constant -0.0004787100025195255;
mul 163 165; constant 0.0013605442176870743; mul 163 167; constant -0.003571428571428574; mul 163 169; constant
0.007142857142857142; mul 163 171; constant -0.0006802721088435403; mul 163 173; constant 0.0035714285714285787; mul
163 175; constant 0.014965986394557814; mul 163 177; constant -0.04285714285714284; mul 163 179; constant
0.06428571428571427; mul 163 181; constant -0.12857142857142845; mul 163 183; constant 0.2571428571428571; mul 163
185; input k 9; input k 10; input k 12; input k 11; input k 13; input k 14; input k 42; div 2 193; input k 44; input
k 45; input k 46; input k 47; input k 48; input k 49; input k 50; input k 51; constant 0.029931972789115628; mul 163
203; constant -0.08571428571428567; mul 163 205; constant 0.12857142857142853; mul 163 207; constant
-0.38571428571428534; mul 163 209; constant 1.0285714285714285; mul 163 211; constant 0.0027210884353741486; mul 163
213; constant -0.010714285714285721; mul 163 215; constant 0.028571428571428567; mul 163 217; constant
0.010714285714285735; mul 163 219; input k 57; input k 53; input k 52; input k 54; input k 55; sub 225 1; input k
56; div 2 227; input k 58; input k 59; input k 60; input k 61; input k 62; input k 63; input k 64; input k 65;
constant -6.0; constant 4.0; input k 29; input k 66; input k 67; input k 68; input k 69; input k 34; input k 35;
input k 36; mul 246 246; input k 74; input k 75; input k 24; input k 25; input k 21; mul 149 251; input k 26; input
k 23; input k 22; input k 20; input k 28; mul 153 258; input k 37; constant 0.8000000000000002; constant
2.400000000000001; mul 15 262; add 261 263; constant 0.01904761904761903; mul 20 265; add 264 266; constant
-1.3714285714285723; mul 26 268; constant 1.3714285714285714; mul 14 270; constant 0.007256235827664418; mul 19 272;
add 271 273; constant -4.799999999999999; mul 26 275; constant 1.3714285714285692; mul 14 277; constant
-0.05714285714285729; mul 19 279; add 278 280; constant -7.199999999999996; mul 26 282; constant 7.199999999999994;
mul 14 284; constant 0.2190476190476189; mul 19 286; add 285 287; constant -45.25714285714286; mul 14 289; constant
-0.11428571428571327; mul 19 291; add 290 292; constant -28.800000000000004; mul 26 294; constant
0.00032473894907757275; mul 163 296; constant -0.0014361300075585765; mul 163 298; constant -0.0013605442176870806;
mul 163 300; constant 0.8; mul 6 302; div 2 303; input k 30; input k 31; input k 32; input k 76; input k 77; input k
70; div 2 310; input k 71; div 2 312; input k 72; div 2 314; input k 73; div 2 316; mul 3 23; mul 22 318; mul 3 51;
mul 102 318; mul 3 22; mul 18 318; mul 3 49; mul 100 318; mul 3 18; mul 3 187; mul 3 188; mul 3 189; add 248 249;
mul 251 252; mul 250 252; mul 88 318; mul 87 318; mul 3 97; mul 237 318; add 335 336; mul 6 337; mul 3 237; mul 238
318; add 339 340; mul 6 341; mul 23 342; add 338 343; mul 24 342; mul 22 24; mul 24 102; mul 18 24; mul 24 100; mul
252 254; mul 24 88; mul 24 87; mul 24 237; mul 6 353; mul 24 238; mul 6 355; mul 23 356; add 354 357; mul 24 356;
mul 260 311; mul 260 313; mul 260 315; mul 260 317; neg 305; neg 306; neg 307; neg 308; neg 309; mul 240 260; mul
241 260; mul 242 260; mul 243 260; mul 3 4; mul 9 304; mul 142 374; mul 58 374; mul 295 374; mul 39 374; mul 293
374; mul 27 374; mul 288 374; mul 109 374; mul 283 374; mul 281 374; mul 276 374; mul 88 374; mul 12 149; mul 149
246; store p 0 4; store p 1 7; store p 2 8; store p 3 3; store p 4 9; store p 5 22; store p 6 23; store p 7 24;
store p 8 27; store p 9 32; store p 10 34; store p 11 39; store p 12 44; store p 13 51; store p 14 53; store p 15
58; store p 16 60; store p 17 65; store p 18 70; store p 19 75; store p 20 80; store p 21 86; store p 22 88; store p
23 90; store p 24 95; store p 25 102; store p 26 104; store p 27 109; store p 28 113; store p 29 118; store p 30
123; store p 31 125; store p 32 130; store p 33 135; store p 34 137; store p 35 142; store p 36 147; store p 37 148;
store p 38 150; store p 39 151; store p 40 152; store p 41 1; store p 42 187; store p 43 188; store p 44 189; store
p 45 174; store p 46 176; store p 47 204; store p 48 206; store p 49 208; store p 50 210; store p 51 212; store p 52
166; store p 53 214; store p 54 216; store p 55 218; store p 56 220; store p 57 180; store p 58 184; store p 59 153;
store p 60 161; store p 61 164; store p 62 168; store p 63 170; store p 64 172; store p 65 178; store p 66 182;
store p 67 186; store p 68 190; store p 69 191; store p 70 192; store p 71 157; store p 72 156; store p 73 159;
store p 74 155; store p 75 194; store p 76 158; store p 77 154; store p 78 195; store p 79 196; store p 80 197;
store p 81 198; store p 82 199; store p 83 200; store p 84 201; store p 85 202; store p 86 226; store p 87 222;
store p 88 223; store p 89 228; store p 90 224; store p 91 221; store p 92 229; store p 93 230; store p 94 231;
store p 95 232; store p 96 233; store p 97 234; store p 98 235; store p 99 236; store p 100 6; store p 101 239;
store p 102 240; store p 103 241; store p 104 242; store p 105 243; store p 106 244; store p 107 245; store p 108
247; store p 109 248; store p 110 249; store p 111 250; store p 112 251; store p 113 252; store p 114 253; store p
115 254; store p 116 255; store p 117 256; store p 118 257; store p 119 259; store p 120 260; store p 121 267; store
p 122 269; store p 123 274; store p 124 276; store p 125 281; store p 126 283; store p 127 288; store p 128 293;
store p 129 295; store p 130 297; store p 131 299; store p 132 301; store p 133 304; store p 134 305; store p 135
306; store p 136 307; store p 137 308; store p 138 309; store p 139 311; store p 140 313; store p 141 315; store p
142 317; store p 143 319; store p 144 318; store p 145 320; store p 146 321; store p 147 322; store p 148 323; store
p 149 324; store p 150 325; store p 151 326; store p 152 327; store p 153 328; store p 154 329; store p 155 330;
store p 156 331; store p 157 332; store p 158 333; store p 159 334; store p 160 344; store p 161 345; store p 162
346; store p 163 347; store p 164 348; store p 165 349; store p 166 350; store p 167 351; store p 168 352; store p
169 358; store p 170 359; store p 171 360; store p 172 361; store p 173 362; store p 174 363; store p 175 364; store
p 176 365; store p 177 366; store p 178 367; store p 179 368; store p 180 369; store p 181 370; store p 182 371;
store p 183 372; store p 184 373; store p 185 375; store p 186 376; store p 187 377; store p 188 378; store p 189
379; store p 190 380; store p 191 381; store p 192 382; store p 193 383; store p 194 384; store p 195 385; store p
196 386; store p 197 13; store p 198 12; store p 199 374; store p 200 83; store p 201 14; store p 202 387; store p
203 19; store p 204 258; store p 205 388
    """,
)

JACOBIAN = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 206},
    {'f': 17, 'a': 289, 'b': 34, 'by_c': 221},
    """
input x 1; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
input p 0; input x 0; mul 11 12; sub 10 13; input c 9; constant 0.5; input c 10; mul 16 17; mul 14 18; sub 15 19;
input c 11; mul 3 21; add 20 22; input c 12; mul 7 24; add 23 25; mul 14 26; add 9 27; input c 4; input c 5; mul 14
30; sub 29 31; input c 6; mul 3 33; add 32 34; input c 7; mul 7 36; add 35 37; input c 8; input p 1; max 39 40;
input x 3; mul 0 11; sub 42 43; mul 41 44; sub 38 45; mul 11 46; sub 28 47; input p 2; input c 1; add 49 50;
constant 0.0; max 51 52; mul 0 53; sub 48 54; input p 3; input p 4; input p 5; input p 6; mul 12 56; mul 59 60;
input p 7; mul 10 62; add 61 63; mul 58 64; input p 8; input x 4; mul 64 67; mul 66 68; add 65 69; input p 9; mul 67
68; mul 71 72; add 70 73; input p 10; mul 64 64; mul 75 76; add 74 77; input p 11; mul 67 76; mul 79 80; add 78 81;
input p 12; mul 64 76; mul 83 84; add 82 85; input p 13; mul 60 87; add 86 88; input p 14; mul 60 67; mul 90 91; add
89 92; input p 15; mul 67 91; mul 94 95; add 93 96; input p 16; mul 60 64; mul 98 99; add 97 100; input p 17; mul 67
99; mul 102 103; add 101 104; input p 18; mul 64 99; mul 106 107; add 105 108; input p 19; mul 60 60; mul 64 111;
mul 110 112; add 109 113; input p 20; mul 60 111; mul 115 116; add 114 117; input p 21; input p 22; mul 67 120; add
119 121; input p 23; mul 67 67; mul 123 124; add 122 125; input p 24; mul 67 124; mul 127 128; add 126 129; input p
25; mul 64 131; add 130 132; input p 26; mul 68 134; add 133 135; input p 27; mul 72 137; add 136 138; input p 28;
mul 76 140; add 139 141; input p 29; mul 80 143; add 142 144; input p 30; mul 84 146; add 145 147; mul 58 60; add
148 149; mul 66 91; add 150 151; mul 71 95; add 152 153; input p 31; mul 99 155; add 154 156; input p 32; mul 103
158; add 157 159; input p 33; mul 107 161; add 160 162; input p 34; mul 111 164; add 163 165; input p 35; mul 67
111; mul 167 168; add 166 169; mul 106 112; add 170 171; input p 36; mul 116 173; add 172 174; mul 59 175; add 118
176; mul 57 177; abs 60; constant 0.35; lt 179 180; input p 37; constant 0.6; constant -0.6; max 184 10; min 183
185; mul 186 186; mul 186 187; mul 182 188; constant -0.35; max 190 60; min 180 191; constant 2.0; mul 192 193;
input p 38; mul 187 195; mul 194 196; add 189 197; mul 192 192; input p 39; mul 186 200; mul 199 201; add 198 202;
mul 192 201; mul 194 204; add 203 205; mul 193 199; input p 40; mul 207 208; mul 194 209; add 206 210; mul 57 211;
where 181 212; add 178 213; input p 41; input p 42; mul 60 216; input p 43; mul 10 218; add 217 219; input p 44; mul
67 221; add 220 222; constant -0.09999999999999995; mul 64 224; input p 45; mul 72 226; add 225 227; input p 46; mul
84 229; add 228 230; constant 1.2; mul 60 232; add 231 233; input p 47; mul 95 235; add 234 236; input p 48; mul 103
238; add 237 239; input p 49; mul 107 241; add 240 242; input p 50; mul 112 244; add 243 245; input p 51; mul 116
247; add 246 248; constant -0.033333333333333326; mul 67 250; input p 52; mul 128 252; add 251 253; constant
0.13333333333333333; mul 64 255; add 254 256; input p 53; mul 72 258; add 257 259; input p 54; mul 80 261; add 260
262; input p 55; mul 84 264; add 263 265; mul 60 224; add 266 267; mul 95 226; add 268 269; input p 56; mul 107 271;
add 270 272; input p 57; mul 168 274; add 273 275; mul 112 241; add 276 277; input p 58; mul 116 279; add 278 280;
mul 59 281; add 249 282; add 223 283; mul 215 284; input p 59; input p 60; constant 0.009523809523809514; mul 124
288; input p 61; mul 67 128; mul 290 291; add 289 292; mul 68 250; add 293 294; mul 67 72; mul 252 296; add 295 297;
constant 0.06666666666666667; mul 76 299; add 298 300; input p 62; mul 67 80; mul 302 303; add 301 304; input p 63;
mul 67 84; mul 306 307; add 305 308; input p 64; mul 64 84; mul 310 311; add 309 312; mul 99 224; add 313 314; mul
67 103; mul 226 316; add 315 317; mul 64 107; mul 229 319; add 318 320; mul 111 183; add 321 322; input p 65; mul 67
168; mul 324 325; add 323 326; mul 67 112; mul 274 328; add 327 329; input p 66; mul 64 112; mul 331 332; add 330
333; mul 64 116; mul 279 335; add 334 336; input p 67; mul 60 116; mul 338 339; add 337 340; mul 60 223; mul 60 218;
input p 68; mul 10 344; add 343 345; input p 69; mul 67 347; add 346 348; mul 10 349; add 342 350; mul 60 221; mul
10 347; add 352 353; input p 70; mul 67 355; add 354 356; mul 67 357; add 351 358; mul 16 359; add 341 360; mul 215
361; add 287 362; constant 1.0; input p 71; mul 10 365; mul 10 366; add 364 367; input p 72; mul 10 369; mul 10 370;
add 364 371; sqrt 372; sqrt 368; mul 373 374; div 364 375; mul 368 376; input p 73; mul 377 378; add 363 379; input
p 74; mul 10 374; mul 376 382; mul 381 383; sub 380 384; input p 75; mul 377 381; input p 76; sub 387 388; mul 378
383; add 389 390; sub 391 12; mul 392 392; mul 385 385; add 393 394; sqrt 395; mul 386 396; sqrt 397; div 364 398;
mul 399 399; mul 386 400; mul 385 401; input p 77; mul 193 397; mul 193 400; mul 400 405; sub 404 406; mul 403 407;
constant 1.4; sub 397 409; input p 78; input p 79; mul 410 412; add 411 413; mul 410 414; add 364 415; mul 408 416;
input p 80; mul 3 418; input p 81; mul 410 420; add 364 421; mul 419 422; sub 417 423; mul 386 424; input p 82;
input x 5; mul 426 427; input p 83; input x 7; mul 429 430; add 428 431; input p 84; input x 9; mul 433 434; add 432
435; constant -0.5; mul 399 437; mul 399 438; mul 399 439; mul 386 440; mul 436 441; add 425 442; input p 85; mul
441 444; mul 441 445; sub 379 384; mul 392 447; add 387 390; mul 385 449; sub 448 450; mul 401 451; div 364 373; mul
376 453; mul 452 454; mul 42 455; mul 392 401; mul 0 457; sub 456 458; mul 0 56; mul 285 460; mul 62 281; add 349
462; mul 215 463; mul 42 464; add 461 465; mul 402 466; add 459 467; mul 446 468; add 443 469; mul 402 470; input p
86; add 362 472; input p 87; mul 377 474; add 473 475; input p 88; mul 383 477; add 476 478; input p 89; mul 383
474; mul 377 477; input p 90; sub 482 483; sub 481 484; sub 485 12; mul 486 486; mul 479 479; add 487 488; sqrt 489;
mul 480 490; sqrt 491; div 364 492; mul 493 493; mul 480 494; mul 479 495; input p 91; mul 193 491; mul 193 494; mul
494 499; sub 498 500; mul 497 501; sub 491 409; input p 92; input p 93; mul 503 505; add 504 506; mul 503 507; add
364 508; mul 502 509; input p 94; mul 7 511; input p 95; mul 503 513; add 364 514; mul 512 515; sub 510 516; mul 480
517; input p 96; input x 6; mul 519 520; input p 97; input x 8; mul 522 523; add 521 524; input p 98; input x 10;
mul 526 527; add 525 528; mul 437 493; mul 493 530; mul 493 531; mul 480 532; mul 529 533; add 518 534; input p 99;
mul 533 536; mul 533 537; add 475 478; mul 486 539; sub 482 481; mul 479 541; add 540 542; mul 495 543; mul 454 544;
mul 42 545; mul 486 495; mul 0 547; sub 546 548; mul 466 496; add 549 550; mul 538 551; add 535 552; mul 496 553;
add 471 554; sub 286 555; mul 285 556; sub 214 557; input p 100; constant 12.0; mul 460 560; constant -6.0; mul 59
460; mul 42 62; add 563 564; mul 562 565; add 561 566; mul 559 567; mul 460 562; constant 4.0; mul 565 570; add 569
571; mul 559 572; mul 59 573; add 568 574; add 558 575; mul 56 576; mul 457 470; mul 547 553; add 578 579; sub 577
580; sub 55 581; input p 101; input p 102; input z 0; mul 584 585; input p 103; input z 1; mul 587 588; add 586 589;
input p 104; input z 2; mul 591 592; add 590 593; input p 105; input z 3; mul 595 596; add 594 597; sub 583 598;
input p 106; abs 0; mul 600 601; mul 0 602; input p 107; mul 0 604; mul 0 0; input p 108; add 606 607; sqrt 608; div
364 609; mul 605 610; add 603 611; sub 599 612; add 582 613; input p 109; input x 11; sub 12 616; mul 615 617; input
p 110; input x 12; sub 12 620; mul 619 621; add 618 622; sub 614 623; input p 111; mul 12 625; input p 112; mul 10
627; add 626 628; input p 113; mul 0 625; input p 114; mul 42 632; add 631 633; mul 0 634; input p 115; mul 42 636;
mul 42 637; add 635 638; mul 630 639; mul 629 640; sub 624 641; input p 116; mul 12 627; mul 10 636; add 644 645;
mul 630 646; mul 646 647; add 643 648; mul 642 649; input p 117; mul 629 630; mul 646 652; add 651 653; mul 62 175;
mul 57 655; abs 10; lt 657 183; mul 186 193; mul 187 193; input p 118; mul 660 661; mul 659 662; mul 182 192; mul
187 664; add 663 665; mul 186 664; mul 659 667; add 666 668; mul 195 199; mul 659 670; add 669 671; mul 192 199; mul
200 673; add 672 674; mul 57 675; where 658 676; add 656 677; mul 464 556; sub 678 679; mul 62 573; add 680 681; mul
455 470; mul 545 553; add 683 684; add 682 685; sub 46 686; input p 119; mul 383 688; mul 454 689; add 687 690;
input p 120; mul 598 692; sub 691 693; mul 640 646; sub 694 695; mul 654 696; sub 650 697; mul 629 629; add 364 699;
mul 630 700; mul 649 701; mul 654 654; sub 702 703; div 364 704; mul 698 705; mul 696 701; mul 642 654; sub 707 708;
mul 705 709; input p 121; mul 67 711; input p 122; mul 124 713; add 712 714; input p 123; mul 128 716; add 715 717;
mul 64 120; add 718 719; input p 124; mul 68 721; add 720 722; input p 125; mul 72 724; add 723 725; input p 126;
mul 76 727; add 726 728; mul 80 137; add 729 730; input p 127; mul 84 732; add 731 733; mul 66 99; add 734 735;
input p 128; mul 103 737; add 736 738; mul 79 107; add 739 740; input p 129; mul 111 742; add 741 743; mul 94 168;
add 744 745; mul 112 167; add 746 747; mul 57 748; constant 0.01904761904761903; mul 67 750; input p 130; mul 128
752; add 751 753; mul 64 250; add 754 755; input p 131; mul 72 757; add 756 758; mul 80 258; add 759 760; mul 84
306; add 761 762; input p 132; mul 103 764; add 763 765; mul 168 235; add 766 767; mul 112 274; add 768 769; add 357
770; mul 215 771; mul 556 772; sub 749 773; input p 133; mul 774 775; neg 776; mul 441 468; input p 134; mul 427
779; sub 778 780; mul 533 551; mul 520 779; sub 782 783; input p 135; mul 430 785; sub 778 786; mul 523 785; sub 782
788; input p 136; mul 434 790; sub 778 791; mul 527 790; sub 782 793; input p 137; mul 617 795; input p 138; mul 621
797; le 364 585; mul 42 692; add 0 800; lt 52 801; and 799 802; constant -1.0; le 585 804; lt 801 52; and 805 806;
or 803 807; not 808; input p 139; mul 801 810; where 809 811; le 364 588; and 802 813; le 588 804; and 806 815; or
814 816; not 817; input p 140; mul 801 819; where 818 820; le 364 592; and 802 822; le 592 804; and 806 824; or 823
825; not 826; input p 141; mul 801 828; where 827 829; le 364 596; and 802 831; le 596 804; and 806 833; or 832 834;
not 835; input p 142; mul 801 837; where 836 838; mul 11 18; mul 14 840; mul 11 26; sub 841 842; mul 11 30; mul 11
844; sub 843 845; input p 143; input p 144; mul 67 848; mul 66 849; add 847 850; mul 67 849; mul 71 852; add 851
853; mul 64 193; mul 848 855; mul 75 856; add 854 857; mul 67 856; mul 79 859; add 858 860; mul 64 856; mul 76 848;
add 862 863; mul 83 864; add 861 865; input p 145; add 866 867; mul 56 67; mul 90 869; add 868 870; mul 67 869; mul
94 872; add 871 873; mul 56 64; mul 60 848; add 875 876; mul 98 877; add 874 878; mul 67 877; mul 102 880; add 879
881; mul 64 877; mul 99 848; add 883 884; mul 106 885; add 882 886; mul 60 193; mul 56 888; mul 64 889; mul 111 848;
add 890 891; mul 110 892; add 887 893; mul 60 889; mul 56 111; add 895 896; mul 115 897; add 894 898; input p 146;
mul 134 849; add 900 901; mul 137 852; add 902 903; mul 140 856; add 904 905; mul 143 859; add 906 907; mul 146 864;
add 908 909; input p 147; add 910 911; mul 66 869; add 912 913; mul 71 872; add 914 915; mul 155 877; add 916 917;
mul 158 880; add 918 919; mul 161 885; add 920 921; mul 164 889; add 922 923; mul 67 889; mul 167 925; add 924 926;
mul 106 892; add 927 928; mul 173 897; add 929 930; mul 59 931; add 899 932; mul 57 933; le 191 180; le 180 191; add
935 936; div 364 937; mul 935 938; le 190 60; le 60 190; add 940 941; div 364 942; mul 940 943; mul 56 944; mul 939
945; mul 193 946; mul 196 947; mul 194 946; mul 201 949; add 948 950; mul 204 947; mul 201 946; mul 194 953; add 952
954; add 951 955; mul 209 947; mul 193 949; mul 208 958; mul 194 959; add 957 960; add 956 961; mul 57 962; where
181 963; add 934 964; input p 148; mul 226 852; add 966 967; mul 229 864; add 968 969; input p 149; add 970 971; mul
235 872; add 972 973; mul 238 880; add 974 975; mul 241 885; add 976 977; mul 244 892; add 978 979; mul 247 897; add
980 981; input p 150; mul 258 852; add 983 984; mul 261 859; add 985 986; mul 264 864; add 987 988; input p 151; add
989 990; mul 226 872; add 991 992; mul 271 885; add 993 994; mul 274 925; add 995 996; mul 241 892; add 997 998; mul
279 897; add 999 1000; mul 59 1001; add 982 1002; input p 152; add 1003 1004; mul 215 1005; mul 556 1006; mul 193
385; mul 250 849; mul 67 852; mul 252 1010; add 1009 1011; mul 299 856; add 1012 1013; mul 67 859; mul 302 1015; add
1014 1016; mul 67 864; mul 306 1018; add 1017 1019; mul 64 864; mul 84 848; add 1021 1022; mul 310 1023; add 1020
1024; mul 224 877; add 1025 1026; mul 67 880; mul 226 1028; add 1027 1029; mul 64 885; mul 107 848; add 1031 1032;
mul 229 1033; add 1030 1034; mul 183 889; add 1035 1036; mul 67 925; mul 324 1038; add 1037 1039; mul 67 892; mul
274 1041; add 1040 1042; mul 64 892; mul 112 848; add 1044 1045; mul 331 1046; add 1043 1047; mul 64 897; mul 116
848; add 1049 1050; mul 279 1051; add 1048 1052; mul 60 897; mul 56 116; add 1054 1055; mul 338 1056; add 1053 1057;
mul 60 1004; mul 56 223; add 1059 1060; input p 153; mul 10 1062; add 1061 1063; input p 154; mul 67 1065; add 1064
1066; mul 16 1067; add 1058 1068; mul 215 1069; mul 1008 1070; mul 193 392; sub 1071 1072; mul 193 396; div 364
1074; mul 1073 1075; mul 386 1076; mul 193 1077; mul 193 399; mul 193 398; div 364 1080; mul 1077 1081; mul 400
1082; mul 1079 1083; neg 1084; mul 193 1085; mul 400 1086; mul 405 1084; sub 1087 1088; sub 1078 1089; mul 403 1090;
mul 416 1091; mul 412 1077; mul 410 1093; mul 414 1077; add 1094 1095; mul 408 1096; add 1092 1097; mul 420 1077;
mul 419 1099; sub 1098 1100; mul 386 1101; mul 439 1082; mul 399 1103; mul 440 1082; add 1104 1105; mul 399 1106;
mul 399 440; mul 1082 1108; add 1107 1109; mul 386 1110; mul 436 1111; sub 1102 1112; mul 386 1084; mul 392 1114;
add 401 1115; mul 0 1116; mul 449 1070; add 447 1118; mul 401 1119; mul 451 1114; add 1120 1121; mul 454 1122; mul
42 1123; sub 1117 1124; mul 401 1070; mul 385 1114; sub 1126 1127; mul 466 1128; mul 460 1006; mul 62 1001; add 1062
1131; mul 215 1132; mul 42 1133; add 1130 1134; mul 402 1135; add 1129 1136; add 1125 1137; mul 446 1138; mul 444
1111; mul 441 1140; mul 445 1111; add 1141 1142; mul 468 1143; sub 1139 1144; add 1113 1145; mul 402 1146; mul 470
1128; add 1147 1148; mul 193 479; mul 1070 1150; mul 193 486; sub 1151 1152; mul 193 490; div 364 1154; mul 1153
1155; mul 480 1156; mul 193 1157; mul 193 493; mul 193 492; div 364 1160; mul 1157 1161; mul 494 1162; mul 1159
1163; neg 1164; mul 193 1165; mul 494 1166; mul 499 1164; sub 1167 1168; sub 1158 1169; mul 497 1170; mul 509 1171;
mul 505 1157; mul 503 1173; mul 507 1157; add 1174 1175; mul 502 1176; add 1172 1177; mul 513 1157; mul 512 1179;
sub 1178 1180; mul 480 1181; mul 531 1162; mul 493 1183; mul 532 1162; add 1184 1185; mul 493 1186; mul 493 532; mul
1162 1188; add 1187 1189; mul 480 1190; mul 529 1191; sub 1182 1192; mul 541 1070; sub 1194 539; mul 495 1195; mul
480 1164; mul 543 1197; sub 1196 1198; mul 454 1199; mul 42 1200; mul 486 1197; add 495 1202; mul 0 1203; add 1201
1204; mul 495 1070; mul 479 1197; sub 1206 1207; mul 466 1208; mul 496 1135; add 1209 1210; add 1205 1211; mul 538
1212; mul 536 1191; mul 533 1214; mul 537 1191; add 1215 1216; mul 551 1217; sub 1213 1218; add 1193 1219; mul 496
1220; mul 553 1208; add 1221 1222; add 1149 1223; mul 285 1224; sub 1007 1225; sub 965 1226; mul 56 1227; mul 457
1146; mul 470 1116; sub 1229 1230; mul 547 1220; mul 553 1203; sub 1232 1233; add 1231 1234; sub 1228 1235; sub 846
1236; input p 155; sub 1237 1238; mul 625 640; sub 1239 1240; mul 649 1241; input p 156; mul 646 1243; mul 627 647;
add 1244 1245; mul 642 1246; add 1242 1247; input p 157; mul 646 1249; mul 627 652; add 1250 1251; mul 696 1252; mul
62 931; mul 57 1254; mul 182 946; mul 187 1256; mul 186 1256; mul 659 1258; add 1257 1259; mul 195 949; mul 659
1261; add 1260 1262; mul 199 946; mul 192 949; add 1264 1265; mul 200 1266; add 1263 1267; mul 57 1268; where 658
1269; add 1255 1270; mul 556 1133; mul 464 1224; sub 1272 1273; sub 1271 1274; mul 455 1146; mul 470 1123; sub 1276
1277; mul 545 1220; mul 553 1200; add 1279 1280; add 1278 1281; add 1275 1282; sub 844 1283; mul 627 640; sub 1284
1285; mul 654 1286; add 1253 1287; sub 1248 1288; mul 705 1289; mul 705 706; mul 193 629; mul 625 1292; mul 630
1293; mul 649 1294; mul 701 1246; add 1295 1296; mul 193 654; mul 1252 1298; sub 1297 1299; mul 1291 1300; sub 1290
1301; mul 649 705; input c_q 0; mul 1303 1304; le 52 51; le 51 52; add 1306 1307; div 364 1308; mul 1306 1309; mul 0
1303; mul 1310 1311; input c_q 1; mul 1312 1313; sub 1305 1314; mul 3 1303; input c_q 2; mul 1316 1317; add 1315
1318; mul 7 1303; input c_q 3; mul 1320 1321; add 1319 1322; mul 654 705; mul 11 1303; add 1324 1325; input c_q 4;
mul 1326 1327; sub 1323 1328; mul 14 1326; input c_q 5; mul 1330 1331; add 1329 1332; mul 3 1326; input c_q 6; mul
1334 1335; sub 1333 1336; mul 7 1326; input c_q 7; mul 1338 1339; sub 1337 1340; le 40 39; le 39 40; add 1342 1343;
div 364 1344; mul 1342 1345; mul 44 1326; mul 1346 1347; input c_q 8; mul 1348 1349; add 1341 1350; mul 14 1303;
input c_q 9; mul 1352 1353; add 1351 1354; mul 14 1352; mul 16 1356; input c_q 10; mul 1357 1358; sub 1355 1359; mul
3 1352; input c_q 11; mul 1361 1362; add 1360 1363; mul 7 1352; input c_q 12; mul 1365 1366; add 1364 1367; add 1302
1368; mul 701 1286; mul 696 1294; add 1370 1371; mul 642 1252; mul 654 1241; add 1373 1374; sub 1372 1375; mul 705
1376; mul 705 710; mul 1300 1378; sub 1377 1379; mul 0 1324; mul 1310 1381; mul 1313 1382; mul 1304 1324; sub 1383
1384; mul 3 1324; mul 1317 1386; sub 1385 1387; mul 7 1324; mul 1321 1389; sub 1388 1390; mul 701 705; mul 11 1324;
add 1392 1393; mul 1327 1394; add 1391 1395; mul 14 1394; mul 1331 1397; sub 1396 1398; mul 3 1394; mul 1335 1400;
add 1399 1401; mul 7 1394; mul 1339 1403; add 1402 1404; mul 44 1394; mul 1346 1406; mul 1349 1407; sub 1405 1408;
mul 14 1324; mul 1353 1410; sub 1409 1411; mul 14 1410; mul 16 1413; mul 1358 1414; add 1412 1415; mul 3 1410; mul
1362 1417; sub 1416 1418; mul 7 1410; mul 1366 1420; sub 1419 1421; add 1380 1422; input p 158; mul 721 849; add
1424 1425; mul 724 852; add 1426 1427; mul 727 856; add 1428 1429; mul 137 859; add 1430 1431; mul 732 864; add 1432
1433; mul 66 877; add 1434 1435; mul 737 880; add 1436 1437; mul 79 885; add 1438 1439; mul 742 889; add 1440 1441;
mul 94 925; add 1442 1443; mul 167 892; add 1444 1445; mul 57 1446; input p 159; mul 757 852; add 1448 1449; mul 258
859; add 1450 1451; mul 306 864; add 1452 1453; mul 764 880; add 1454 1455; mul 235 925; add 1456 1457; mul 274 892;
add 1458 1459; add 1065 1460; mul 215 1461; mul 556 1462; mul 772 1224; sub 1463 1464; sub 1447 1465; mul 775 1466;
neg 1467; mul 441 1138; mul 468 1111; sub 1469 1470; mul 533 1212; mul 551 1191; sub 1472 1473; mul 11 41; mul 11
1475; add 53 1476; mul 284 402; sub 1478 457; mul 446 1479; mul 402 1480; mul 284 496; sub 1482 547; mul 538 1483;
mul 496 1484; add 1481 1485; mul 285 1486; input p 160; add 1487 1488; mul 56 1489; mul 457 1480; mul 547 1484; add
1491 1492; sub 1490 1493; add 1477 1494; sign 0; mul 600 1496; mul 0 1497; add 602 1498; mul 604 610; mul 610 611;
mul 0 610; mul 1501 1502; sub 1500 1503; add 1499 1504; add 1495 1505; add 631 634; mul 630 1507; mul 629 1508; add
1506 1509; mul 649 1510; mul 464 1486; input p 161; add 1512 1513; mul 455 1480; mul 545 1484; add 1515 1516; add
1514 1517; sub 1475 1518; mul 646 1508; sub 1519 1520; mul 654 1521; add 1511 1522; mul 705 1523; neg 1524; mul 701
1521; mul 654 1510; add 1526 1527; mul 705 1528; mul 772 1486; mul 775 1530; neg 1531; mul 441 1479; mul 533 1483;
where 809 810; where 818 819; where 827 828; where 836 837; sub 26 19; add 844 1539; input p 162; mul 62 67; mul 66
1542; add 1541 1543; mul 67 1542; mul 71 1545; add 1544 1546; mul 62 855; mul 75 1548; add 1547 1549; mul 67 1548;
mul 79 1551; add 1550 1552; mul 64 1548; mul 62 76; add 1554 1555; mul 83 1556; add 1553 1557; mul 60 62; mul 98
1559; add 1558 1560; mul 67 1559; mul 102 1562; add 1561 1563; mul 64 1559; mul 62 99; add 1565 1566; mul 106 1567;
add 1564 1568; mul 62 111; mul 110 1570; add 1569 1571; input p 163; mul 134 1542; add 1573 1574; mul 137 1545; add
1575 1576; mul 140 1548; add 1577 1578; mul 143 1551; add 1579 1580; mul 146 1556; add 1581 1582; mul 155 1559; add
1583 1584; mul 158 1562; add 1585 1586; mul 161 1567; add 1587 1588; mul 106 1570; add 1589 1590; mul 59 1591; add
1572 1592; mul 57 1593; le 185 183; le 183 185; add 1595 1596; div 364 1597; mul 1595 1598; le 184 10; le 10 184;
add 1600 1601; div 364 1602; mul 1600 1603; mul 1599 1604; mul 187 1605; mul 659 1605; mul 186 1607; add 1606 1608;
mul 182 1609; mul 195 1607; mul 194 1611; add 1610 1612; mul 200 1605; mul 199 1614; add 1613 1615; mul 192 1614;
mul 194 1617; add 1616 1618; mul 57 1619; where 181 1620; add 1594 1621; input p 164; mul 226 1545; add 1623 1624;
mul 229 1556; add 1625 1626; mul 238 1562; add 1627 1628; mul 241 1567; add 1629 1630; mul 244 1570; add 1631 1632;
input p 165; mul 258 1545; add 1634 1635; mul 261 1551; add 1636 1637; mul 264 1556; add 1638 1639; mul 271 1567;
add 1640 1641; mul 241 1570; add 1642 1643; mul 59 1644; add 1633 1645; add 218 1646; mul 215 1647; mul 556 1648;
mul 193 366; mul 376 1650; mul 376 377; mul 370 453; mul 374 1653; div 364 374; mul 366 1655; mul 373 1656; add 1654
1657; mul 1652 1658; sub 1651 1659; mul 381 1660; mul 10 1656; add 374 1662; mul 376 1663; mul 376 383; mul 1658
1665; sub 1664 1666; mul 378 1667; add 1661 1668; mul 1072 1669; mul 250 1542; mul 67 1545; mul 252 1672; add 1671
1673; mul 299 1548; add 1674 1675; mul 67 1551; mul 302 1677; add 1676 1678; mul 67 1556; mul 306 1680; add 1679
1681; mul 64 1556; mul 62 84; add 1683 1684; mul 310 1685; add 1682 1686; mul 224 1559; add 1687 1688; mul 67 1562;
mul 226 1690; add 1689 1691; mul 64 1567; mul 62 107; add 1693 1694; mul 229 1695; add 1692 1696; mul 67 1570; mul
274 1698; add 1697 1699; mul 64 1570; mul 62 112; add 1701 1702; mul 331 1703; add 1700 1704; mul 62 116; mul 279
1706; add 1705 1707; add 345 349; add 343 1709; add 348 1710; mul 16 1711; add 1708 1712; mul 215 1713; mul 378
1660; add 1714 1715; mul 381 1667; sub 1716 1717; mul 1008 1718; add 1670 1719; mul 1075 1720; mul 386 1721; mul 193
1722; mul 1081 1722; mul 400 1724; mul 1079 1725; neg 1726; mul 193 1727; mul 400 1728; mul 405 1726; sub 1729 1730;
sub 1723 1731; mul 403 1732; mul 416 1733; mul 412 1722; mul 410 1735; mul 414 1722; add 1736 1737; mul 408 1738;
add 1734 1739; mul 420 1722; mul 419 1741; sub 1740 1742; mul 386 1743; mul 439 1724; mul 399 1745; mul 440 1724;
add 1746 1747; mul 399 1748; mul 1108 1724; add 1749 1750; mul 386 1751; mul 436 1752; sub 1744 1753; mul 447 1669;
sub 1715 1717; mul 392 1756; add 1755 1757; mul 449 1718; mul 385 1669; add 1759 1760; sub 1758 1761; mul 401 1762;
mul 386 1726; mul 451 1764; sub 1763 1765; mul 454 1766; mul 453 453; mul 1653 1768; mul 376 1769; mul 376 454; mul
1658 1771; add 1770 1772; mul 452 1773; sub 1767 1774; mul 42 1775; mul 401 1669; mul 392 1764; sub 1777 1778; mul 0
1779; sub 1776 1780; mul 401 1718; mul 385 1764; sub 1782 1783; mul 466 1784; mul 460 1648; mul 62 1644; add 344
1787; mul 215 1788; mul 42 1789; add 1786 1790; mul 402 1791; add 1785 1792; add 1781 1793; mul 446 1794; mul 444
1752; mul 441 1796; mul 445 1752; add 1797 1798; mul 468 1799; sub 1795 1800; add 1754 1801; mul 402 1802; mul 470
1784; add 1803 1804; mul 474 1667; mul 477 1660; sub 1806 1807; mul 1152 1808; mul 474 1660; add 1714 1810; mul 477
1667; add 1811 1812; mul 1150 1813; add 1809 1814; mul 1155 1815; mul 480 1816; mul 193 1817; mul 1161 1817; mul 494
1819; mul 1159 1820; neg 1821; mul 193 1822; mul 494 1823; mul 499 1821; sub 1824 1825; sub 1818 1826; mul 497 1827;
mul 509 1828; mul 505 1817; mul 503 1830; mul 507 1817; add 1831 1832; mul 502 1833; add 1829 1834; mul 513 1817;
mul 512 1836; sub 1835 1837; mul 480 1838; mul 531 1819; mul 493 1840; mul 532 1819; add 1841 1842; mul 493 1843;
mul 1188 1819; add 1844 1845; mul 480 1846; mul 529 1847; sub 1839 1848; mul 539 1808; add 1810 1812; mul 486 1851;
add 1850 1852; mul 541 1813; sub 1807 1806; mul 479 1855; add 1854 1856; add 1853 1857; mul 495 1858; mul 480 1821;
mul 543 1860; sub 1859 1861; mul 454 1862; mul 544 1773; sub 1863 1864; mul 42 1865; mul 495 1808; mul 486 1860; sub
1867 1868; mul 0 1869; sub 1866 1870; mul 495 1813; mul 479 1860; sub 1872 1873; mul 466 1874; mul 496 1791; add
1875 1876; add 1871 1877; mul 538 1878; mul 536 1847; mul 533 1880; mul 537 1847; add 1881 1882; mul 551 1883; sub
1879 1884; add 1849 1885; mul 496 1886; mul 553 1874; add 1887 1888; add 1805 1889; mul 285 1890; sub 1649 1891; sub
1622 1892; mul 56 1893; mul 457 1802; mul 470 1779; add 1895 1896; mul 547 1886; mul 553 1869; add 1898 1899; add
1897 1900; sub 1894 1901; sub 1540 1902; sub 1903 1285; mul 649 1904; input p 166; mul 646 1906; mul 636 647; add
1907 1908; mul 642 1909; add 1905 1910; mul 636 652; add 1244 1912; mul 696 1913; mul 688 1667; mul 454 1915; mul
689 1773; sub 1916 1917; mul 62 1591; mul 57 1919; mul 193 1605; mul 662 1921; mul 193 1607; mul 661 1923; mul 659
1924; add 1922 1925; mul 664 1607; add 1926 1927; mul 667 1921; mul 664 1605; mul 659 1930; add 1929 1931; add 1928
1932; mul 670 1921; add 1933 1934; mul 57 1935; where 658 1936; add 1920 1937; mul 556 1789; mul 464 1890; sub 1939
1940; sub 1938 1941; mul 455 1802; mul 470 1775; add 1943 1944; mul 545 1886; mul 553 1865; add 1946 1947; add 1945
1948; add 1942 1949; add 30 1950; sub 1918 1951; mul 636 640; sub 1952 1953; mul 654 1954; add 1914 1955; sub 1911
1956; mul 705 1957; mul 627 1292; mul 630 1959; mul 649 1960; mul 701 1909; add 1961 1962; mul 1298 1913; sub 1963
1964; mul 1291 1965; sub 1958 1966; mul 701 1954; mul 696 1960; add 1968 1969; mul 642 1913; mul 654 1904; add 1971
1972; sub 1970 1973; mul 705 1974; mul 1378 1965; sub 1975 1976; input p 167; mul 721 1542; add 1978 1979; mul 724
1545; add 1980 1981; mul 727 1548; add 1982 1983; mul 137 1551; add 1984 1985; mul 732 1556; add 1986 1987; mul 66
1559; add 1988 1989; mul 737 1562; add 1990 1991; mul 79 1567; add 1992 1993; mul 167 1570; add 1994 1995; mul 57
1996; input p 168; mul 757 1545; add 1998 1999; mul 258 1551; add 2000 2001; mul 306 1556; add 2002 2003; mul 764
1562; add 2004 2005; mul 274 1570; add 2006 2007; add 347 2008; mul 215 2009; mul 556 2010; mul 772 1890; sub 2011
2012; sub 1997 2013; mul 775 2014; neg 2015; mul 441 1794; mul 468 1752; sub 2017 2018; mul 533 1878; mul 551 1847;
sub 2020 2021; mul 402 464; add 455 2023; mul 446 2024; mul 402 2025; mul 464 496; add 545 2027; mul 538 2028; mul
496 2029; add 2026 2030; mul 285 2031; input p 169; add 2032 2033; mul 56 2034; mul 457 2025; mul 547 2029; add 2036
2037; sub 2035 2038; sub 1475 2039; mul 0 632; mul 193 637; add 2041 2042; mul 630 2043; mul 629 2044; sub 2040
2045; mul 649 2046; mul 464 2031; input p 170; add 2048 2049; mul 455 2025; mul 545 2029; add 2051 2052; add 2050
2053; add 41 2054; mul 646 2044; add 2055 2056; mul 654 2057; add 2047 2058; mul 705 2059; mul 701 2057; mul 654
2046; add 2061 2062; mul 705 2063; neg 2064; mul 772 2031; mul 775 2066; neg 2067; mul 441 2024; mul 533 2028; input
p 171; where 809 2071; input p 172; where 818 2073; input p 173; where 827 2075; input p 174; where 836 2077; mul 67
193; mul 123 2079; add 120 2080; mul 67 2079; add 124 2082; mul 127 2083; add 2081 2084; mul 64 134; add 2085 2086;
mul 68 193; mul 137 2088; add 2087 2089; mul 76 143; add 2090 2091; mul 60 66; add 2092 2093; mul 91 193; mul 71
2095; add 2094 2096; mul 99 158; add 2097 2098; mul 111 167; add 2099 2100; mul 62 2101; mul 57 2102; mul 252 2083;
add 250 2104; mul 258 2088; add 2105 2106; mul 76 261; add 2107 2108; mul 226 2095; add 2109 2110; mul 111 274; add
2111 2112; mul 62 2113; add 347 2114; mul 215 2115; mul 556 2116; mul 67 2083; add 128 2118; mul 290 2119; add 751
2120; add 755 2121; mul 67 2088; add 72 2123; mul 252 2124; add 2122 2125; mul 80 193; mul 302 2127; add 2126 2128;
add 762 2129; mul 103 193; mul 226 2131; add 2130 2132; mul 168 193; mul 324 2134; add 2133 2135; add 769 2136; add
356 357; add 354 2138; mul 16 2139; add 2137 2140; mul 215 2141; mul 1008 2142; mul 1075 2143; mul 386 2144; mul 193
2145; mul 1081 2145; mul 400 2147; mul 1079 2148; neg 2149; mul 193 2150; mul 400 2151; mul 405 2149; sub 2152 2153;
sub 2146 2154; mul 403 2155; mul 416 2156; mul 412 2145; mul 410 2158; mul 414 2145; add 2159 2160; mul 408 2161;
add 2157 2162; mul 420 2145; mul 419 2164; sub 2163 2165; mul 386 2166; mul 439 2147; mul 399 2168; mul 440 2147;
add 2169 2170; mul 399 2171; mul 1108 2147; add 2172 2173; mul 386 2174; mul 436 2175; sub 2167 2176; mul 386 2149;
mul 392 2178; mul 0 2179; mul 449 2142; mul 401 2181; mul 451 2178; add 2182 2183; mul 454 2184; mul 42 2185; sub
2180 2186; mul 401 2142; mul 385 2178; sub 2188 2189; mul 466 2190; mul 226 2088; mul 235 2095; add 2192 2193; mul
99 238; add 2194 2195; mul 59 2113; add 2196 2197; add 221 2198; mul 215 2199; mul 460 2200; mul 42 2116; add 2201
2202; mul 402 2203; add 2191 2204; add 2187 2205; mul 446 2206; mul 444 2175; mul 441 2208; mul 445 2175; add 2209
2210; mul 468 2211; sub 2207 2212; add 2177 2213; mul 402 2214; mul 470 2190; add 2215 2216; mul 1150 2142; mul 1155
2218; mul 480 2219; mul 193 2220; mul 1161 2220; mul 494 2222; mul 1159 2223; neg 2224; mul 193 2225; mul 494 2226;
mul 499 2224; sub 2227 2228; sub 2221 2229; mul 497 2230; mul 509 2231; mul 505 2220; mul 503 2233; mul 507 2220;
add 2234 2235; mul 502 2236; add 2232 2237; mul 513 2220; mul 512 2239; sub 2238 2240; mul 480 2241; mul 531 2222;
mul 493 2243; mul 532 2222; add 2244 2245; mul 493 2246; mul 1188 2222; add 2247 2248; mul 480 2249; mul 529 2250;
sub 2242 2251; mul 541 2142; mul 495 2253; mul 480 2224; mul 543 2255; sub 2254 2256; mul 454 2257; mul 42 2258; mul
486 2255; mul 0 2260; add 2259 2261; mul 495 2142; mul 479 2255; sub 2263 2264; mul 466 2265; mul 496 2203; add 2266
2267; add 2262 2268; mul 538 2269; mul 536 2250; mul 533 2271; mul 537 2250; add 2272 2273; mul 551 2274; sub 2270
2275; add 2252 2276; mul 496 2277; mul 553 2265; add 2278 2279; add 2217 2280; mul 464 2281; sub 2117 2282; sub 2103
2283; mul 455 2214; mul 470 2185; sub 2285 2286; mul 545 2277; mul 553 2258; add 2288 2289; add 2287 2290; add 2284
2291; mul 654 2292; mul 64 66; mul 71 2088; add 2294 2295; mul 76 79; add 2296 2297; mul 60 90; add 2298 2299; mul
94 2095; add 2300 2301; mul 99 102; add 2302 2303; mul 59 2101; add 2304 2305; mul 57 2306; mul 556 2200; mul 285
2281; sub 2308 2309; sub 2307 2310; mul 56 2311; mul 457 2214; mul 470 2179; sub 2313 2314; mul 547 2277; mul 553
2260; sub 2316 2317; add 2315 2318; sub 2312 2319; mul 649 2320; sub 2293 2321; mul 705 2322; mul 654 2320; mul 701
2292; sub 2324 2325; mul 705 2326; mul 713 2079; add 711 2328; mul 716 2083; add 2329 2330; mul 64 721; add 2331
2332; mul 724 2088; add 2333 2334; mul 76 137; add 2335 2336; mul 99 737; add 2337 2338; mul 94 111; add 2339 2340;
mul 57 2341; mul 752 2083; add 750 2343; mul 757 2088; add 2344 2345; mul 76 258; add 2346 2347; mul 99 764; add
2348 2349; mul 111 235; add 2350 2351; add 355 2352; mul 215 2353; mul 556 2354; mul 772 2281; sub 2355 2356; sub
2342 2357; mul 775 2358; neg 2359; mul 441 2206; mul 468 2175; sub 2361 2362; mul 533 2269; mul 551 2250; sub 2364
2365; mul 426 441; mul 402 2367; mul 464 2368; mul 455 2367; add 2369 2370; mul 654 2371; mul 285 2368; mul 56 2373;
mul 457 2367; sub 2374 2375; mul 649 2376; sub 2372 2377; mul 705 2378; mul 654 2376; mul 701 2371; sub 2380 2381;
mul 705 2382; mul 772 2368; mul 775 2384; neg 2385; input p 175; mul 519 533; mul 496 2388; mul 464 2389; mul 545
2388; add 2390 2391; mul 654 2392; mul 285 2389; mul 56 2394; mul 547 2388; sub 2395 2396; mul 649 2397; sub 2393
2398; mul 705 2399; mul 654 2397; mul 701 2392; sub 2401 2402; mul 705 2403; mul 772 2389; mul 775 2405; neg 2406;
mul 429 441; mul 402 2408; mul 464 2409; mul 455 2408; add 2410 2411; mul 654 2412; mul 285 2409; mul 56 2414; mul
457 2408; sub 2415 2416; mul 649 2417; sub 2413 2418; mul 705 2419; mul 654 2417; mul 701 2412; sub 2421 2422; mul
705 2423; mul 772 2409; mul 775 2425; neg 2426; input p 176; mul 522 533; mul 496 2429; mul 464 2430; mul 545 2429;
add 2431 2432; mul 654 2433; mul 285 2430; mul 56 2435; mul 547 2429; sub 2436 2437; mul 649 2438; sub 2434 2439;
mul 705 2440; mul 654 2438; mul 701 2433; sub 2442 2443; mul 705 2444; mul 772 2430; mul 775 2446; neg 2447; mul 433
441; mul 402 2449; mul 464 2450; mul 455 2449; add 2451 2452; mul 654 2453; mul 285 2450; mul 56 2455; mul 457 2449;
sub 2456 2457; mul 649 2458; sub 2454 2459; mul 705 2460; mul 654 2458; mul 701 2453; sub 2462 2463; mul 705 2464;
mul 772 2450; mul 775 2466; neg 2467; input p 177; mul 526 533; mul 496 2470; mul 464 2471; mul 545 2470; add 2472
2473; mul 654 2474; mul 285 2471; mul 56 2476; mul 547 2470; sub 2477 2478; mul 649 2479; sub 2475 2480; mul 705
2481; mul 654 2479; mul 701 2474; sub 2483 2484; mul 705 2485; mul 772 2471; mul 775 2487; neg 2488; mul 615 649;
mul 705 2490; mul 615 654; mul 705 2492; neg 2493; input p 178; mul 619 649; mul 705 2496; mul 619 654; mul 705
2498; neg 2499; input p 179; input p 180; mul 654 2502; mul 584 649; sub 2503 2504; mul 705 2505; mul 584 654; mul
701 2502; sub 2507 2508; mul 705 2509; input p 181; mul 654 2511; mul 587 649; sub 2512 2513; mul 705 2514; mul 587
654; mul 701 2511; sub 2516 2517; mul 705 2518; input p 182; mul 654 2520; mul 591 649; sub 2521 2522; mul 705 2523;
mul 591 654; mul 701 2520; sub 2525 2526; mul 705 2527; input p 183; mul 654 2529; mul 595 649; sub 2530 2531; mul
705 2532; mul 595 654; mul 701 2529; sub 2534 2535; mul 705 2536; mul 14 21; add 2 2538; mul 11 33; sub 2539 2540;
mul 418 422; mul 386 2542; mul 457 2543; mul 402 2543; mul 285 2545; mul 56 2546; sub 2544 2547; sub 2541 2548; mul
649 2549; mul 464 2545; mul 455 2543; add 2551 2552; add 33 2553; mul 654 2554; sub 2550 2555; mul 705 2556; mul 701
2554; mul 654 2549; sub 2558 2559; mul 705 2560; mul 772 2545; mul 775 2562; mul 14 24; add 6 2564; mul 11 36; sub
2565 2566; mul 511 515; mul 480 2568; mul 547 2569; mul 496 2569; mul 285 2571; mul 56 2572; sub 2570 2573; sub 2567
2574; mul 649 2575; mul 464 2571; mul 545 2569; add 2577 2578; add 36 2579; mul 654 2580; sub 2576 2581; mul 705
2582; mul 701 2580; mul 654 2575; sub 2584 2585; mul 705 2586; mul 772 2571; mul 775 2588; neg 1324; neg 1312; neg
1386; neg 1389; neg 1326; neg 1397; neg 1334; neg 1338; neg 1407; neg 1410; neg 1357; neg 1417; neg 1420; store f 0
0; store f 1 706; store f 2 42; store f 3 710; store f 4 777; store f 5 781; store f 6 784; store f 7 787; store f 8
789; store f 9 792; store f 10 794; store f 11 796; store f 12 798; store f 13 812; store f 14 821; store f 15 830;
store f 16 839; store a 17 1369; store a 51 1423; store a 68 1468; store a 85 1471; store a 102 1474; store a 119
1471; store a 136 1474; store a 153 1471; store a 170 1474; store a 187 795; store a 204 797; store a 1 364; store a
18 1525; store a 52 1529; store a 69 1532; store a 86 1533; store a 103 1534; store a 120 1533; store a 137 1534;
store a 154 1533; store a 171 1534; store a 222 1535; store a 239 1536; store a 256 1537; store a 273 1538; store a
19 1967; store a 53 1977; store a 70 2016; store a 87 2019; store a 104 2022; store a 121 2019; store a 138 2022;
store a 155 2019; store a 172 2022; store a 20 2060; store a 37 364; store a 54 2065; store a 71 2068; store a 88
2069; store a 105 2070; store a 122 2069; store a 139 2070; store a 156 2069; store a 173 2070; store a 224 2072;
store a 241 2074; store a 258 2076; store a 275 2078; store a 21 2323; store a 55 2327; store a 72 2360; store a 89
2363; store a 106 2366; store a 123 2363; store a 140 2366; store a 157 2363; store a 174 2366; store a 22 2379;
store a 56 2383; store a 73 2386; store a 90 2387; store a 23 2400; store a 57 2404; store a 74 2407; store a 108
2387; store a 24 2420; store a 58 2424; store a 75 2427; store a 126 2428; store a 25 2441; store a 59 2445; store a
76 2448; store a 144 2428; store a 26 2461; store a 60 2465; store a 77 2468; store a 162 2469; store a 27 2482;
store a 61 2486; store a 78 2489; store a 180 2469; store a 28 2491; store a 62 2494; store a 198 2495; store a 29
2497; store a 63 2500; store a 216 2501; store a 30 2506; store a 64 2510; store a 31 2515; store a 65 2519; store a
32 2524; store a 66 2528; store a 33 2533; store a 67 2537; store b 2 2557; store b 6 2561; store b 8 2563; store b
3 2583; store b 7 2587; store b 9 2589; store by_c 13 1303; store by_c 39 2590; store by_c 14 2591; store by_c 40
1382; store by_c 15 1316; store by_c 41 2592; store by_c 16 1320; store by_c 42 2593; store by_c 17 2594; store by_c
43 1394; store by_c 18 1330; store by_c 44 2595; store by_c 19 2596; store by_c 45 1400; store by_c 20 2597; store
by_c 46 1403; store by_c 21 1348; store by_c 47 2598; store by_c 22 1352; store by_c 48 2599; store by_c 23 2600;
store by_c 49 1414; store by_c 24 1361; store by_c 50 2601; store by_c 25 1365; store by_c 51 2602
    """,
)

BY_CONSTANTS = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'p': 206},
    {'by_k': 1343},
    """
input p 116; input x 0; input p 112; mul 1 2; input x 2; input p 115; mul 4 5; add 3 6; input p 113; mul 7 8; mul 7
9; add 0 10; constant 1.0; input p 111; mul 1 13; mul 2 4; add 14 15; mul 16 16; add 12 17; mul 8 18; mul 11 19;
input p 117; mul 8 16; mul 7 22; add 21 23; mul 24 24; sub 20 25; div 12 26; mul 11 27; input p 3; input p 4; input
p 5; input p 6; mul 1 29; mul 32 33; input p 7; mul 4 35; add 34 36; mul 31 37; input p 8; input x 4; mul 37 40; mul
39 41; add 38 42; input p 9; mul 40 41; mul 44 45; add 43 46; input p 10; mul 37 37; mul 48 49; add 47 50; input p
11; mul 40 49; mul 52 53; add 51 54; input p 12; mul 37 49; mul 56 57; add 55 58; input p 13; mul 33 60; add 59 61;
input p 14; mul 33 40; mul 63 64; add 62 65; input p 15; mul 40 64; mul 67 68; add 66 69; input p 16; mul 33 37; mul
71 72; add 70 73; input p 17; mul 40 72; mul 75 76; add 74 77; input p 18; mul 37 72; mul 79 80; add 78 81; input p
19; mul 33 33; mul 37 84; mul 83 85; add 82 86; input p 20; mul 33 84; mul 88 89; add 87 90; input p 21; input p 22;
mul 40 93; add 92 94; input p 23; mul 40 40; mul 96 97; add 95 98; input p 24; mul 40 97; mul 100 101; add 99 102;
input p 25; mul 37 104; add 103 105; input p 26; mul 41 107; add 106 108; input p 27; mul 45 110; add 109 111; input
p 28; mul 49 113; add 112 114; input p 29; mul 53 116; add 115 117; input p 30; mul 57 119; add 118 120; mul 31 33;
add 121 122; mul 39 64; add 123 124; mul 44 68; add 125 126; input p 31; mul 72 128; add 127 129; input p 32; mul 76
131; add 130 132; input p 33; mul 80 134; add 133 135; input p 34; mul 84 137; add 136 138; input p 35; mul 40 84;
mul 140 141; add 139 142; mul 79 85; add 143 144; input p 36; mul 89 146; add 145 147; mul 32 148; add 91 149; mul
30 150; abs 33; constant 0.35; lt 152 153; input p 37; constant 0.6; constant -0.6; max 157 4; min 156 158; mul 159
159; mul 159 160; mul 155 161; constant -0.35; max 163 33; min 153 164; constant 2.0; mul 165 166; input p 38; mul
160 168; mul 167 169; add 162 170; mul 165 165; input p 39; mul 159 173; mul 172 174; add 171 175; mul 165 174; mul
167 177; add 176 178; mul 166 172; input p 40; mul 180 181; mul 167 182; add 179 183; mul 30 184; where 154 185; add
151 186; input p 41; input p 42; mul 33 189; input p 43; mul 4 191; add 190 192; input p 44; mul 40 194; add 193
195; constant -0.09999999999999995; mul 37 197; input p 45; mul 45 199; add 198 200; input p 46; mul 57 202; add 201
203; constant 1.2; mul 33 205; add 204 206; input p 47; mul 68 208; add 207 209; input p 48; mul 76 211; add 210
212; input p 49; mul 80 214; add 213 215; input p 50; mul 85 217; add 216 218; input p 51; mul 89 220; add 219 221;
constant -0.033333333333333326; mul 40 223; input p 52; mul 101 225; add 224 226; constant 0.13333333333333333; mul
37 228; add 227 229; input p 53; mul 45 231; add 230 232; input p 54; mul 53 234; add 233 235; input p 55; mul 57
237; add 236 238; mul 33 197; add 239 240; mul 68 199; add 241 242; input p 56; mul 80 244; add 243 245; input p 57;
mul 141 247; add 246 248; mul 85 214; add 249 250; input p 58; mul 89 252; add 251 253; mul 32 254; add 222 255; add
196 256; mul 188 257; input p 59; input p 60; constant 0.009523809523809514; mul 97 261; input p 61; mul 40 101; mul
263 264; add 262 265; mul 41 223; add 266 267; mul 40 45; mul 225 269; add 268 270; constant 0.06666666666666667;
mul 49 272; add 271 273; input p 62; mul 40 53; mul 275 276; add 274 277; input p 63; mul 40 57; mul 279 280; add
278 281; input p 64; mul 37 57; mul 283 284; add 282 285; mul 72 197; add 286 287; mul 40 76; mul 199 289; add 288
290; mul 37 80; mul 202 292; add 291 293; mul 84 156; add 294 295; input p 65; mul 40 141; mul 297 298; add 296 299;
mul 40 85; mul 247 301; add 300 302; input p 66; mul 37 85; mul 304 305; add 303 306; mul 37 89; mul 252 308; add
307 309; input p 67; mul 33 89; mul 311 312; add 310 313; constant 0.5; mul 33 196; mul 33 191; input p 68; mul 4
318; add 317 319; input p 69; mul 40 321; add 320 322; mul 4 323; add 316 324; mul 33 194; mul 4 321; add 326 327;
input p 70; mul 40 329; add 328 330; mul 40 331; add 325 332; mul 315 333; add 314 334; mul 188 335; add 260 336;
input p 71; mul 4 338; mul 4 339; add 12 340; input p 72; mul 4 342; mul 4 343; add 12 344; sqrt 345; sqrt 341; mul
346 347; div 12 348; mul 341 349; input p 73; mul 350 351; add 337 352; input p 74; mul 4 347; mul 349 355; mul 354
356; sub 353 357; input p 75; mul 350 354; input p 76; sub 360 361; mul 351 356; add 362 363; sub 364 1; mul 365
365; mul 358 358; add 366 367; sqrt 368; mul 359 369; sqrt 370; div 12 371; mul 372 372; mul 359 373; mul 358 374;
input p 77; mul 166 370; mul 166 373; mul 373 378; sub 377 379; mul 376 380; constant 1.4; sub 370 382; input p 78;
input p 79; mul 383 385; add 384 386; mul 383 387; add 12 388; mul 381 389; input u 0; input p 80; mul 391 392;
input p 81; mul 383 394; add 12 395; mul 393 396; sub 390 397; mul 359 398; input p 82; input x 5; mul 400 401;
input p 83; input x 7; mul 403 404; add 402 405; input p 84; input x 9; mul 407 408; add 406 409; constant -0.5; mul
372 411; mul 372 412; mul 372 413; mul 359 414; mul 410 415; add 399 416; input p 85; mul 415 418; mul 415 419;
input x 3; sub 352 357; mul 365 422; add 360 363; mul 358 424; sub 423 425; mul 374 426; div 12 346; mul 349 428;
mul 427 429; mul 421 430; input x 1; mul 365 374; mul 432 433; sub 431 434; mul 29 432; mul 258 436; mul 35 254; add
323 438; mul 188 439; mul 421 440; add 437 441; mul 375 442; add 435 443; mul 420 444; add 417 445; mul 375 446;
input p 86; add 336 448; input p 87; mul 350 450; add 449 451; input p 88; mul 356 453; add 452 454; input p 89; mul
356 450; mul 350 453; input p 90; sub 458 459; sub 457 460; sub 461 1; mul 462 462; mul 455 455; add 463 464; sqrt
465; mul 456 466; sqrt 467; div 12 468; mul 469 469; mul 456 470; mul 455 471; input p 91; mul 166 467; mul 166 470;
mul 470 475; sub 474 476; mul 473 477; sub 467 382; input p 92; input p 93; mul 479 481; add 480 482; mul 479 483;
add 12 484; mul 478 485; input u 1; input p 94; mul 487 488; input p 95; mul 479 490; add 12 491; mul 489 492; sub
486 493; mul 456 494; input p 96; input x 6; mul 496 497; input p 97; input x 8; mul 499 500; add 498 501; input p
98; input x 10; mul 503 504; add 502 505; mul 411 469; mul 469 507; mul 469 508; mul 456 509; mul 506 510; add 495
511; input p 99; mul 510 513; mul 510 514; add 451 454; mul 462 516; sub 458 457; mul 455 518; add 517 519; mul 471
520; mul 429 521; mul 421 522; mul 462 471; mul 432 524; sub 523 525; mul 442 472; add 526 527; mul 515 528; add 512
529; mul 472 530; add 447 531; sub 259 532; mul 258 533; sub 187 534; input p 100; constant 12.0; mul 436 537;
constant -6.0; mul 32 436; mul 35 421; add 540 541; mul 539 542; add 538 543; mul 536 544; mul 436 539; constant
4.0; mul 542 547; add 546 548; mul 536 549; mul 32 550; add 545 551; add 535 552; mul 29 553; mul 29 554; mul 28
555; mul 24 27; mul 522 557; mul 28 524; add 558 559; mul 28 29; mul 258 561; mul 440 557; sub 562 563; mul 472 564;
sub 560 565; mul 515 566; mul 442 567; mul 530 564; sub 568 569; mul 471 570; mul 530 557; mul 421 567; add 572 573;
mul 429 574; mul 471 575; mul 518 576; add 571 577; mul 166 455; mul 166 466; div 12 580; mul 456 566; mul 478 582;
mul 483 583; mul 489 582; mul 490 585; sub 584 586; mul 479 583; mul 481 588; add 587 589; mul 166 468; div 12 591;
mul 469 509; mul 528 566; mul 514 594; mul 510 594; mul 513 596; add 595 597; mul 506 566; add 598 599; mul 456 600;
mul 593 601; mul 469 601; mul 509 603; add 602 604; mul 469 603; mul 508 606; add 605 607; mul 166 469; mul 455 570;
mul 28 530; mul 432 567; sub 611 612; mul 462 613; add 610 614; mul 520 575; add 615 616; mul 456 617; mul 485 582;
mul 473 619; mul 475 620; sub 618 621; mul 470 620; neg 623; mul 166 624; add 622 625; mul 609 626; mul 470 627; add
608 628; mul 592 629; sub 590 630; mul 166 620; add 631 632; mul 456 633; mul 581 634; mul 579 635; add 578 636; sub
556 637; mul 472 567; mul 430 557; mul 28 433; add 640 641; mul 375 564; sub 642 643; mul 420 644; mul 375 645; add
639 646; mul 421 647; mul 533 557; sub 648 649; mul 439 650; add 638 651; mul 29 436; mul 35 557; mul 32 561; sub
654 655; mul 536 656; mul 539 657; mul 547 657; mul 536 561; mul 539 660; sub 659 661; mul 32 662; add 658 663; mul
537 660; sub 664 665; mul 258 647; add 666 667; mul 653 668; sub 652 669; mul 533 561; mul 436 647; add 671 672; mul
257 673; add 670 674; mul 442 645; mul 446 564; sub 676 677; mul 374 678; mul 446 557; mul 421 645; add 680 681; mul
429 682; mul 374 683; mul 424 684; sub 679 685; mul 166 358; mul 166 369; div 12 688; mul 359 644; mul 381 690; mul
387 691; mul 393 690; mul 394 693; sub 692 694; mul 383 691; mul 385 696; add 695 697; mul 166 371; div 12 699; mul
372 414; mul 444 644; mul 419 702; mul 415 702; mul 418 704; add 703 705; mul 410 644; add 706 707; mul 359 708; mul
701 709; mul 372 709; mul 414 711; add 710 712; mul 372 711; mul 413 714; add 713 715; mul 166 372; mul 358 678; mul
28 446; mul 432 645; sub 719 720; mul 365 721; add 718 722; mul 426 683; add 723 724; mul 359 725; mul 389 690; mul
376 727; mul 378 728; sub 726 729; mul 373 728; neg 731; mul 166 732; add 730 733; mul 717 734; mul 373 735; add 716
736; mul 700 737; sub 698 738; mul 166 728; add 739 740; mul 359 741; mul 689 742; mul 687 743; add 686 744; add 637
745; mul 335 746; add 675 747; sub 748 745; mul 29 33; mul 188 650; mul 35 751; mul 188 673; mul 32 753; add 752
754; mul 252 755; mul 84 756; mul 33 166; mul 33 756; mul 758 759; add 757 760; mul 214 755; mul 37 762; mul 758
763; add 761 764; mul 247 755; mul 40 766; mul 758 767; add 765 768; mul 244 755; mul 37 770; mul 37 771; add 769
772; mul 199 755; mul 40 774; mul 40 775; add 773 776; mul 197 755; add 777 778; mul 220 753; mul 84 780; add 779
781; mul 33 780; mul 758 783; add 782 784; mul 217 753; mul 37 786; mul 758 787; add 785 788; mul 214 753; mul 37
790; mul 37 791; add 789 792; mul 211 753; mul 40 794; mul 37 795; add 793 796; mul 208 753; mul 40 798; mul 40 799;
add 797 800; mul 205 753; add 801 802; mul 188 746; mul 315 804; mul 40 805; mul 194 806; add 803 807; mul 4 805;
add 751 809; mul 191 810; add 808 811; mul 196 805; add 812 813; mul 33 805; add 753 815; mul 189 816; add 814 817;
mul 311 804; mul 89 819; add 818 820; mul 33 819; mul 84 822; add 821 823; mul 33 822; mul 758 825; add 824 826; mul
252 804; mul 37 828; mul 84 829; add 827 830; mul 33 829; mul 758 832; add 831 833; mul 304 804; mul 37 835; mul 37
836; mul 758 837; add 834 838; mul 247 804; mul 40 840; mul 37 841; mul 758 842; add 839 843; mul 297 804; mul 40
845; mul 40 846; mul 758 847; add 844 848; mul 156 804; mul 758 850; add 849 851; mul 202 804; mul 37 853; mul 37
854; mul 37 855; add 852 856; mul 199 804; mul 40 858; mul 40 859; mul 37 860; add 857 861; mul 197 804; mul 37 863;
add 862 864; le 163 33; le 33 163; add 866 867; div 12 868; mul 866 869; le 164 153; le 153 164; add 871 872; div 12
873; mul 871 874; abs 4; lt 876 156; mul 30 557; mul 173 878; mul 172 879; mul 159 166; mul 878 881; mul 168 882;
mul 167 883; add 880 884; mul 159 882; mul 160 878; add 886 887; mul 155 888; add 885 889; where 877 890; mul 30
561; mul 167 892; mul 181 893; neg 894; mul 166 895; mul 167 896; where 154 897; add 891 898; mul 182 892; neg 900;
mul 166 901; where 154 902; add 899 903; mul 174 893; neg 905; where 154 906; add 904 907; mul 177 892; neg 909; mul
166 910; where 154 911; add 908 912; mul 165 879; where 877 914; mul 174 892; neg 916; where 154 917; add 915 918;
mul 167 919; add 913 920; mul 169 892; neg 922; mul 166 923; where 154 924; add 921 925; mul 875 926; mul 870 927;
add 865 928; mul 35 878; mul 32 892; sub 930 931; mul 146 932; mul 84 933; add 929 934; mul 33 933; mul 758 936; add
935 937; mul 79 932; mul 37 939; mul 758 940; add 938 941; mul 140 932; mul 40 943; mul 758 944; add 942 945; mul
137 932; mul 758 947; add 946 948; mul 134 932; mul 37 950; mul 37 951; add 949 952; mul 131 932; mul 40 954; mul 37
955; add 953 956; mul 128 932; mul 37 958; add 957 959; mul 44 932; mul 40 961; mul 40 962; add 960 963; mul 39 932;
mul 40 965; add 964 966; mul 31 932; add 967 968; mul 88 892; mul 84 970; sub 969 971; mul 33 970; mul 758 973; sub
972 974; mul 83 892; mul 37 976; mul 758 977; sub 975 978; mul 79 892; mul 37 980; mul 37 981; sub 979 982; mul 75
892; mul 40 984; mul 37 985; sub 983 986; mul 71 892; mul 37 988; sub 987 989; mul 67 892; mul 40 991; mul 40 992;
sub 990 993; mul 63 892; mul 40 995; sub 994 996; mul 60 892; sub 997 998; mul 84 762; mul 72 770; add 1000 1001;
mul 33 771; add 1002 1003; mul 237 755; mul 49 1005; add 1004 1006; mul 37 166; mul 37 1005; mul 1008 1009; add 1007
1010; mul 234 755; mul 40 1012; mul 1008 1013; add 1011 1014; mul 231 755; mul 40 1016; mul 40 1017; add 1015 1018;
mul 228 755; add 1019 1020; mul 84 786; add 1021 1022; mul 72 790; add 1023 1024; mul 33 791; add 1025 1026; mul 33
795; add 1027 1028; mul 202 753; mul 49 1030; add 1029 1031; mul 37 1030; mul 1008 1033; add 1032 1034; mul 199 753;
mul 40 1036; mul 40 1037; add 1035 1038; mul 197 753; add 1039 1040; mul 89 828; add 1041 1042; mul 85 835; add 1043
1044; mul 84 836; add 1045 1046; mul 84 841; add 1047 1048; mul 80 853; add 1049 1050; mul 72 854; add 1051 1052;
mul 33 855; add 1053 1054; mul 33 860; add 1055 1056; mul 33 863; add 1057 1058; mul 283 804; mul 57 1060; add 1059
1061; mul 37 1060; mul 49 1063; add 1062 1064; mul 37 1063; mul 1008 1066; add 1065 1067; mul 279 804; mul 40 1069;
mul 49 1070; add 1068 1071; mul 37 1070; mul 1008 1073; add 1072 1074; mul 275 804; mul 40 1076; mul 40 1077; mul
1008 1078; add 1075 1079; mul 272 804; mul 1008 1081; add 1080 1082; mul 225 804; mul 40 1084; mul 40 1085; mul 40
1086; add 1083 1087; mul 223 804; mul 40 1089; add 1088 1090; mul 84 939; add 1091 1092; mul 72 950; add 1093 1094;
mul 33 951; add 1095 1096; mul 33 955; add 1097 1098; mul 33 958; add 1099 1100; mul 119 932; mul 49 1102; add 1101
1103; mul 37 1102; mul 1008 1105; add 1104 1106; mul 116 932; mul 40 1108; mul 1008 1109; add 1107 1110; mul 113
932; mul 1008 1112; add 1111 1113; mul 110 932; mul 40 1115; mul 40 1116; add 1114 1117; mul 107 932; mul 40 1119;
add 1118 1120; mul 104 932; add 1121 1122; mul 84 976; sub 1123 1124; mul 72 980; sub 1125 1126; mul 33 981; sub
1127 1128; mul 33 985; sub 1129 1130; mul 33 988; sub 1131 1132; mul 56 892; mul 49 1134; sub 1133 1135; mul 37
1134; mul 1008 1137; sub 1136 1138; mul 52 892; mul 40 1140; mul 1008 1141; sub 1139 1142; mul 48 892; mul 1008
1144; sub 1143 1145; mul 44 892; mul 40 1147; mul 40 1148; sub 1146 1149; mul 39 892; mul 40 1151; sub 1150 1152;
mul 31 892; sub 1153 1154; mul 32 1155; add 999 1156; mul 750 1157; sub 749 1158; input p 184; input c 4; input p 0;
mul 1 1162; sub 4 1163; input c 5; mul 1164 1165; sub 1161 1166; input c 6; mul 391 1168; add 1167 1169; input c 7;
mul 487 1171; add 1170 1172; input c 8; input p 1; max 1174 1175; mul 432 1162; sub 421 1177; mul 1176 1178; sub
1173 1179; mul 28 1180; mul 28 1162; add 557 1182; mul 1176 1183; mul 432 1184; add 1181 1185; mul 1165 1183; input
c 9; input c 10; mul 315 1189; mul 1164 1190; sub 1188 1191; input c 11; mul 391 1193; add 1192 1194; input c 12;
mul 487 1196; add 1195 1197; mul 28 1198; add 1187 1199; mul 28 1164; mul 1190 1201; sub 1200 1202; mul 1 1203; add
1186 1204; mul 1160 1205; add 1159 1206; mul 19 27; mul 533 1208; mul 522 1208; mul 524 557; add 1210 1211; mul 440
1208; mul 29 557; mul 258 1214; sub 1213 1215; mul 472 1216; add 1212 1217; mul 515 1218; mul 472 1219; mul 430
1208; mul 433 557; add 1221 1222; mul 375 1216; add 1223 1224; mul 420 1225; mul 375 1226; add 1220 1227; mul 421
1228; sub 1209 1229; mul 439 1230; mul 555 557; mul 456 1218; mul 489 1233; mul 490 1234; mul 478 1233; mul 483
1236; sub 1235 1237; mul 479 1236; mul 481 1239; sub 1238 1240; mul 528 1218; mul 514 1242; mul 510 1242; mul 513
1244; add 1243 1245; mul 506 1218; add 1246 1247; mul 456 1248; mul 593 1249; mul 469 1249; mul 509 1251; add 1250
1252; mul 469 1251; mul 508 1254; add 1253 1255; mul 432 1219; sub 1257 572; mul 462 1258; mul 530 1216; mul 442
1219; add 1260 1261; mul 455 1262; sub 1259 1263; mul 530 1208; mul 421 1219; add 1265 1266; mul 429 1267; mul 520
1268; sub 1264 1269; mul 456 1270; mul 485 1233; mul 473 1272; mul 475 1273; add 1271 1274; mul 470 1273; mul 166
1276; add 1275 1277; mul 609 1278; mul 470 1279; sub 1256 1280; mul 592 1281; add 1241 1282; neg 1273; mul 166 1284;
add 1283 1285; mul 456 1286; mul 581 1287; mul 579 1288; mul 471 1262; mul 471 1268; mul 518 1291; add 1290 1292;
sub 1289 1293; add 1232 1294; sub 1231 1295; mul 32 1214; mul 35 1208; sub 1297 1298; mul 536 1299; mul 539 1300;
mul 547 1300; mul 536 1214; mul 539 1303; add 1302 1304; mul 32 1305; add 1301 1306; mul 537 1303; add 1307 1308;
mul 258 1228; sub 1309 1310; mul 653 1311; sub 1296 1312; mul 533 1214; mul 436 1228; add 1314 1315; mul 257 1316;
sub 1313 1317; mul 446 1208; mul 421 1226; add 1319 1320; mul 429 1321; mul 374 1322; mul 424 1323; mul 446 1216;
mul 442 1226; add 1325 1326; mul 374 1327; sub 1324 1328; mul 359 1225; mul 393 1330; mul 394 1331; mul 381 1330;
mul 387 1333; sub 1332 1334; mul 383 1333; mul 385 1336; sub 1335 1337; mul 444 1225; mul 419 1339; mul 415 1339;
mul 418 1341; add 1340 1342; mul 410 1225; add 1343 1344; mul 359 1345; mul 701 1346; mul 372 1346; mul 414 1348;
add 1347 1349; mul 372 1348; mul 413 1351; add 1350 1352; mul 432 1226; sub 1354 680; mul 365 1355; mul 358 1327;
sub 1356 1357; mul 426 1322; sub 1358 1359; mul 359 1360; mul 389 1330; mul 376 1362; mul 378 1363; add 1361 1364;
mul 373 1363; mul 166 1366; add 1365 1367; mul 717 1368; mul 373 1369; sub 1353 1370; mul 700 1371; add 1338 1372;
neg 1363; mul 166 1374; add 1373 1375; mul 359 1376; mul 689 1377; mul 687 1378; add 1329 1379; add 1294 1380; mul
335 1381; add 1318 1382; sub 1383 1380; mul 188 1230; mul 35 1385; mul 188 1316; mul 32 1387; sub 1386 1388; mul 252
1389; mul 84 1390; mul 33 1390; mul 758 1392; add 1391 1393; mul 214 1389; mul 37 1395; mul 758 1396; add 1394 1397;
mul 247 1389; mul 40 1399; mul 758 1400; add 1398 1401; mul 244 1389; mul 37 1403; mul 37 1404; add 1402 1405; mul
199 1389; mul 40 1407; mul 40 1408; add 1406 1409; mul 197 1389; add 1410 1411; mul 220 1387; mul 84 1413; sub 1412
1414; mul 33 1413; mul 758 1416; sub 1415 1417; mul 217 1387; mul 37 1419; mul 758 1420; sub 1418 1421; mul 214
1387; mul 37 1423; mul 37 1424; sub 1422 1425; mul 211 1387; mul 40 1427; mul 37 1428; sub 1426 1429; mul 208 1387;
mul 40 1431; mul 40 1432; sub 1430 1433; mul 205 1387; sub 1434 1435; mul 188 1381; mul 315 1437; mul 40 1438; mul
194 1439; add 1436 1440; mul 4 1438; add 1385 1442; mul 191 1443; add 1441 1444; mul 196 1438; add 1445 1446; mul 33
1438; sub 1448 1387; mul 189 1449; add 1447 1450; mul 311 1437; mul 89 1452; add 1451 1453; mul 33 1452; mul 84
1455; add 1454 1456; mul 33 1455; mul 758 1458; add 1457 1459; mul 252 1437; mul 37 1461; mul 84 1462; add 1460
1463; mul 33 1462; mul 758 1465; add 1464 1466; mul 304 1437; mul 37 1468; mul 37 1469; mul 758 1470; add 1467 1471;
mul 247 1437; mul 40 1473; mul 37 1474; mul 758 1475; add 1472 1476; mul 297 1437; mul 40 1478; mul 40 1479; mul 758
1480; add 1477 1481; mul 156 1437; mul 758 1483; add 1482 1484; mul 202 1437; mul 37 1486; mul 37 1487; mul 37 1488;
add 1485 1489; mul 199 1437; mul 40 1491; mul 40 1492; mul 37 1493; add 1490 1494; mul 197 1437; mul 37 1496; add
1495 1497; mul 30 1208; mul 173 1499; mul 172 1500; mul 881 1499; mul 168 1502; mul 167 1503; add 1501 1504; mul 159
1502; mul 160 1499; add 1506 1507; mul 155 1508; add 1505 1509; neg 1510; where 877 1511; mul 30 1214; mul 167 1513;
mul 181 1514; mul 166 1515; mul 167 1516; where 154 1517; add 1512 1518; mul 182 1513; mul 166 1520; where 154 1521;
add 1519 1522; mul 174 1514; where 154 1524; add 1523 1525; mul 177 1513; mul 166 1527; where 154 1528; add 1526
1529; mul 165 1500; neg 1531; where 877 1532; mul 174 1513; where 154 1534; add 1533 1535; mul 167 1536; add 1530
1537; mul 169 1513; mul 166 1539; where 154 1540; add 1538 1541; mul 875 1542; mul 870 1543; add 1498 1544; mul 32
1513; mul 35 1499; sub 1546 1547; mul 146 1548; mul 84 1549; add 1545 1550; mul 33 1549; mul 758 1552; add 1551
1553; mul 79 1548; mul 37 1555; mul 758 1556; add 1554 1557; mul 140 1548; mul 40 1559; mul 758 1560; add 1558 1561;
mul 137 1548; mul 758 1563; add 1562 1564; mul 134 1548; mul 37 1566; mul 37 1567; add 1565 1568; mul 131 1548; mul
40 1570; mul 37 1571; add 1569 1572; mul 128 1548; mul 37 1574; add 1573 1575; mul 44 1548; mul 40 1577; mul 40
1578; add 1576 1579; mul 39 1548; mul 40 1581; add 1580 1582; mul 31 1548; add 1583 1584; mul 88 1513; mul 84 1586;
add 1585 1587; mul 33 1586; mul 758 1589; add 1588 1590; mul 83 1513; mul 37 1592; mul 758 1593; add 1591 1594; mul
79 1513; mul 37 1596; mul 37 1597; add 1595 1598; mul 75 1513; mul 40 1600; mul 37 1601; add 1599 1602; mul 71 1513;
mul 37 1604; add 1603 1605; mul 67 1513; mul 40 1607; mul 40 1608; add 1606 1609; mul 63 1513; mul 40 1611; add 1610
1612; mul 60 1513; add 1613 1614; mul 84 1395; mul 72 1403; add 1616 1617; mul 33 1404; add 1618 1619; mul 237 1389;
mul 49 1621; add 1620 1622; mul 37 1621; mul 1008 1624; add 1623 1625; mul 234 1389; mul 40 1627; mul 1008 1628; add
1626 1629; mul 231 1389; mul 40 1631; mul 40 1632; add 1630 1633; mul 228 1389; add 1634 1635; mul 84 1419; sub 1636
1637; mul 72 1423; sub 1638 1639; mul 33 1424; sub 1640 1641; mul 33 1428; sub 1642 1643; mul 202 1387; mul 49 1645;
sub 1644 1646; mul 37 1645; mul 1008 1648; sub 1647 1649; mul 199 1387; mul 40 1651; mul 40 1652; sub 1650 1653; mul
197 1387; sub 1654 1655; mul 89 1461; add 1656 1657; mul 85 1468; add 1658 1659; mul 84 1469; add 1660 1661; mul 84
1474; add 1662 1663; mul 80 1486; add 1664 1665; mul 72 1487; add 1666 1667; mul 33 1488; add 1668 1669; mul 33
1493; add 1670 1671; mul 33 1496; add 1672 1673; mul 283 1437; mul 57 1675; add 1674 1676; mul 37 1675; mul 49 1678;
add 1677 1679; mul 37 1678; mul 1008 1681; add 1680 1682; mul 279 1437; mul 40 1684; mul 49 1685; add 1683 1686; mul
37 1685; mul 1008 1688; add 1687 1689; mul 275 1437; mul 40 1691; mul 40 1692; mul 1008 1693; add 1690 1694; mul 272
1437; mul 1008 1696; add 1695 1697; mul 225 1437; mul 40 1699; mul 40 1700; mul 40 1701; add 1698 1702; mul 223
1437; mul 40 1704; add 1703 1705; mul 84 1555; add 1706 1707; mul 72 1566; add 1708 1709; mul 33 1567; add 1710
1711; mul 33 1571; add 1712 1713; mul 33 1574; add 1714 1715; mul 119 1548; mul 49 1717; add 1716 1718; mul 37 1717;
mul 1008 1720; add 1719 1721; mul 116 1548; mul 40 1723; mul 1008 1724; add 1722 1725; mul 113 1548; mul 1008 1727;
add 1726 1728; mul 110 1548; mul 40 1730; mul 40 1731; add 1729 1732; mul 107 1548; mul 40 1734; add 1733 1735; mul
104 1548; add 1736 1737; mul 84 1592; add 1738 1739; mul 72 1596; add 1740 1741; mul 33 1597; add 1742 1743; mul 33
1601; add 1744 1745; mul 33 1604; add 1746 1747; mul 56 1513; mul 49 1749; add 1748 1750; mul 37 1749; mul 1008
1752; add 1751 1753; mul 52 1513; mul 40 1755; mul 1008 1756; add 1754 1757; mul 48 1513; mul 1008 1759; add 1758
1760; mul 44 1513; mul 40 1762; mul 40 1763; add 1761 1764; mul 39 1513; mul 40 1766; add 1765 1767; mul 31 1513;
add 1768 1769; mul 32 1770; add 1615 1771; mul 750 1772; sub 1384 1773; mul 557 1180; mul 557 1162; add 1208 1776;
mul 1176 1777; mul 432 1778; add 1775 1779; mul 557 1164; mul 1190 1781; mul 1165 1777; mul 557 1198; add 1783 1784;
sub 1782 1785; mul 1 1786; sub 1780 1787; mul 1160 1788; sub 1774 1789; constant 0.01904761904761903; mul 40 1791;
input p 130; mul 101 1793; add 1792 1794; mul 37 223; add 1795 1796; input p 131; mul 45 1798; add 1797 1799; mul 53
231; add 1800 1801; mul 57 279; add 1802 1803; input p 132; mul 76 1805; add 1804 1806; mul 141 208; add 1807 1808;
mul 85 247; add 1809 1810; add 331 1811; input p 133; mul 533 1813; mul 1812 1814; mul 188 1812; mul 1813 1816; mul
472 1817; mul 456 1818; mul 489 1819; mul 490 1820; mul 478 1819; mul 483 1822; sub 1821 1823; mul 479 1822; mul 481
1825; sub 1824 1826; mul 528 1818; mul 514 1828; mul 510 1828; mul 513 1830; add 1829 1831; mul 506 1818; add 1832
1833; mul 456 1834; mul 593 1835; mul 469 1835; mul 509 1837; add 1836 1838; mul 469 1837; mul 508 1840; add 1839
1841; mul 515 1818; mul 432 1843; mul 462 1844; mul 530 1817; mul 442 1843; add 1846 1847; mul 455 1848; sub 1845
1849; mul 421 1843; mul 429 1851; mul 520 1852; sub 1850 1853; mul 456 1854; mul 485 1819; mul 473 1856; mul 475
1857; add 1855 1858; mul 470 1857; mul 166 1860; add 1859 1861; mul 609 1862; mul 470 1863; sub 1842 1864; mul 592
1865; add 1827 1866; neg 1857; mul 166 1868; add 1867 1869; mul 456 1870; mul 581 1871; mul 579 1872; mul 471 1848;
mul 471 1852; mul 518 1875; add 1874 1876; sub 1873 1877; sub 1815 1878; mul 472 1843; mul 375 1817; mul 420 1881;
mul 375 1882; add 1880 1883; mul 421 1884; mul 439 1885; sub 1879 1886; mul 258 1884; mul 653 1888; add 1887 1889;
mul 436 1884; mul 257 1891; sub 1890 1892; mul 421 1882; mul 429 1894; mul 374 1895; mul 424 1896; mul 446 1817; mul
442 1882; add 1898 1899; mul 374 1900; sub 1897 1901; mul 359 1881; mul 393 1903; mul 394 1904; mul 381 1903; mul
387 1906; sub 1905 1907; mul 383 1906; mul 385 1909; sub 1908 1910; mul 444 1881; mul 419 1912; mul 415 1912; mul
418 1914; add 1913 1915; mul 410 1881; add 1916 1917; mul 359 1918; mul 701 1919; mul 372 1919; mul 414 1921; add
1920 1922; mul 372 1921; mul 413 1924; add 1923 1925; mul 432 1882; mul 365 1927; mul 358 1900; sub 1928 1929; mul
426 1895; sub 1930 1931; mul 359 1932; mul 389 1903; mul 376 1934; mul 378 1935; add 1933 1936; mul 373 1935; mul
166 1938; add 1937 1939; mul 717 1940; mul 373 1941; sub 1926 1942; mul 700 1943; add 1911 1944; neg 1935; mul 166
1946; add 1945 1947; mul 359 1948; mul 689 1949; mul 687 1950; add 1902 1951; add 1878 1952; mul 335 1953; add 1893
1954; sub 1955 1952; mul 188 1814; mul 247 1957; mul 37 1958; mul 758 1959; mul 208 1957; mul 40 1961; mul 758 1962;
add 1960 1963; mul 1805 1957; mul 40 1965; mul 37 1966; add 1964 1967; input p 185; mul 37 1969; mul 758 1970; sub
1968 1971; input p 186; mul 40 1973; mul 758 1974; sub 1972 1975; input p 187; mul 758 1977; sub 1976 1978; input p
188; mul 37 1980; mul 37 1981; sub 1979 1982; input p 189; mul 40 1984; mul 37 1985; sub 1983 1986; input p 190; mul
37 1988; sub 1987 1989; mul 188 1885; mul 35 1991; mul 188 1891; mul 32 1993; add 1992 1994; mul 252 1995; mul 84
1996; sub 1990 1997; mul 33 1996; mul 758 1999; sub 1998 2000; mul 214 1995; mul 37 2002; mul 758 2003; sub 2001
2004; mul 247 1995; mul 40 2006; mul 758 2007; sub 2005 2008; mul 244 1995; mul 37 2010; mul 37 2011; sub 2009 2012;
mul 199 1995; mul 40 2014; mul 40 2015; sub 2013 2016; mul 197 1995; sub 2017 2018; mul 220 1993; mul 84 2020; sub
2019 2021; mul 33 2020; mul 758 2023; sub 2022 2024; mul 217 1993; mul 37 2026; mul 758 2027; sub 2025 2028; mul 214
1993; mul 37 2030; mul 37 2031; sub 2029 2032; mul 211 1993; mul 40 2034; mul 37 2035; sub 2033 2036; mul 208 1993;
mul 40 2038; mul 40 2039; sub 2037 2040; mul 205 1993; sub 2041 2042; mul 188 1953; mul 315 2044; mul 40 2045; add
1957 2046; mul 194 2047; add 2043 2048; mul 4 2045; sub 2050 1991; mul 191 2051; add 2049 2052; mul 196 2045; add
2053 2054; mul 33 2045; sub 2056 1993; mul 189 2057; add 2055 2058; mul 311 2044; mul 89 2060; add 2059 2061; mul 33
2060; mul 84 2063; add 2062 2064; mul 33 2063; mul 758 2066; add 2065 2067; mul 252 2044; mul 37 2069; mul 84 2070;
add 2068 2071; mul 33 2070; mul 758 2073; add 2072 2074; mul 304 2044; mul 37 2076; mul 37 2077; mul 758 2078; add
2075 2079; mul 247 2044; mul 40 2081; mul 37 2082; mul 758 2083; add 2080 2084; mul 297 2044; mul 40 2086; mul 40
2087; mul 758 2088; add 2085 2089; mul 156 2044; mul 758 2091; add 2090 2092; mul 202 2044; mul 37 2094; mul 37
2095; mul 37 2096; add 2093 2097; mul 199 2044; mul 40 2099; mul 40 2100; mul 37 2101; add 2098 2102; mul 197 2044;
mul 37 2104; add 2103 2105; mul 84 1958; mul 33 1966; add 2107 2108; mul 279 1957; mul 49 2110; add 2109 2111; mul
37 2110; mul 1008 2113; add 2112 2114; mul 231 1957; mul 40 2116; mul 1008 2117; add 2115 2118; mul 1798 1957; mul
40 2120; mul 40 2121; add 2119 2122; mul 223 1957; add 2123 2124; mul 84 1969; sub 2125 2126; mul 72 1980; sub 2127
2128; mul 33 1981; sub 2129 2130; mul 33 1985; sub 2131 2132; mul 33 1988; sub 2133 2134; input p 191; mul 49 2136;
sub 2135 2137; mul 37 2136; mul 1008 2139; sub 2138 2140; input p 192; mul 40 2142; mul 1008 2143; sub 2141 2144;
input p 193; mul 1008 2146; sub 2145 2147; input p 194; mul 40 2149; mul 40 2150; sub 2148 2151; input p 195; mul 40
2153; sub 2152 2154; input p 196; sub 2155 2156; mul 84 2002; sub 2157 2158; mul 72 2010; sub 2159 2160; mul 33
2011; sub 2161 2162; mul 237 1995; mul 49 2164; sub 2163 2165; mul 37 2164; mul 1008 2167; sub 2166 2168; mul 234
1995; mul 40 2170; mul 1008 2171; sub 2169 2172; mul 231 1995; mul 40 2174; mul 40 2175; sub 2173 2176; mul 228
1995; sub 2177 2178; mul 84 2026; sub 2179 2180; mul 72 2030; sub 2181 2182; mul 33 2031; sub 2183 2184; mul 33
2035; sub 2185 2186; mul 202 1993; mul 49 2188; sub 2187 2189; mul 37 2188; mul 1008 2191; sub 2190 2192; mul 199
1993; mul 40 2194; mul 40 2195; sub 2193 2196; mul 197 1993; sub 2197 2198; mul 89 2069; add 2199 2200; mul 85 2076;
add 2201 2202; mul 84 2077; add 2203 2204; mul 84 2082; add 2205 2206; mul 80 2094; add 2207 2208; mul 72 2095; add
2209 2210; mul 33 2096; add 2211 2212; mul 33 2101; add 2213 2214; mul 33 2104; add 2215 2216; mul 283 2044; mul 57
2218; add 2217 2219; mul 37 2218; mul 49 2221; add 2220 2222; mul 37 2221; mul 1008 2224; add 2223 2225; mul 279
2044; mul 40 2227; mul 49 2228; add 2226 2229; mul 37 2228; mul 1008 2231; add 2230 2232; mul 275 2044; mul 40 2234;
mul 40 2235; mul 1008 2236; add 2233 2237; mul 272 2044; mul 1008 2239; add 2238 2240; mul 225 2044; mul 40 2242;
mul 40 2243; mul 40 2244; add 2241 2245; mul 223 2044; mul 40 2247; add 2246 2248; mul 32 2249; add 2106 2250; mul
750 2251; sub 1956 2252; mul 375 415; mul 421 2254; mul 439 2255; mul 258 2254; mul 653 2257; sub 2256 2258; mul 436
2254; mul 257 2260; add 2259 2261; mul 415 442; mul 374 2263; mul 415 421; mul 429 2265; mul 374 2266; mul 424 2267;
sub 2264 2268; mul 359 444; mul 701 2270; mul 372 2270; mul 414 2272; add 2271 2273; mul 372 2272; mul 413 2275; add
2274 2276; mul 358 2263; mul 415 432; mul 365 2279; sub 2278 2280; mul 426 2266; add 2281 2282; mul 359 2283; mul
717 2284; mul 373 2285; add 2277 2286; mul 700 2287; mul 359 2288; mul 689 2289; mul 687 2290; sub 2269 2291; mul
335 2292; add 2262 2293; sub 2294 2292; mul 188 2255; mul 35 2296; mul 188 2260; mul 32 2298; add 2297 2299; mul 252
2300; mul 84 2301; mul 33 2301; mul 758 2303; add 2302 2304; mul 214 2300; mul 37 2306; mul 758 2307; add 2305 2308;
mul 247 2300; mul 40 2310; mul 758 2311; add 2309 2312; mul 244 2300; mul 37 2314; mul 37 2315; add 2313 2316; mul
199 2300; mul 40 2318; mul 40 2319; add 2317 2320; mul 197 2300; add 2321 2322; mul 220 2298; mul 84 2324; add 2323
2325; mul 33 2324; mul 758 2327; add 2326 2328; mul 217 2298; mul 37 2330; mul 758 2331; add 2329 2332; mul 214
2298; mul 37 2334; mul 37 2335; add 2333 2336; mul 211 2298; mul 40 2338; mul 37 2339; add 2337 2340; mul 208 2298;
mul 40 2342; mul 40 2343; add 2341 2344; mul 205 2298; add 2345 2346; mul 188 2292; mul 315 2348; mul 40 2349; mul
194 2350; add 2347 2351; mul 4 2349; add 2296 2353; mul 191 2354; add 2352 2355; mul 196 2349; add 2356 2357; mul 33
2349; add 2298 2359; mul 189 2360; add 2358 2361; mul 311 2348; mul 89 2363; add 2362 2364; mul 33 2363; mul 84
2366; add 2365 2367; mul 33 2366; mul 758 2369; add 2368 2370; mul 252 2348; mul 37 2372; mul 84 2373; add 2371
2374; mul 33 2373; mul 758 2376; add 2375 2377; mul 304 2348; mul 37 2379; mul 37 2380; mul 758 2381; add 2378 2382;
mul 247 2348; mul 40 2384; mul 37 2385; mul 758 2386; add 2383 2387; mul 297 2348; mul 40 2389; mul 40 2390; mul 758
2391; add 2388 2392; mul 156 2348; mul 758 2394; add 2393 2395; mul 202 2348; mul 37 2397; mul 37 2398; mul 37 2399;
add 2396 2400; mul 199 2348; mul 40 2402; mul 40 2403; mul 37 2404; add 2401 2405; mul 197 2348; mul 37 2407; add
2406 2408; mul 84 2306; mul 72 2314; add 2410 2411; mul 33 2315; add 2412 2413; mul 237 2300; mul 49 2415; add 2414
2416; mul 37 2415; mul 1008 2418; add 2417 2419; mul 234 2300; mul 40 2421; mul 1008 2422; add 2420 2423; mul 231
2300; mul 40 2425; mul 40 2426; add 2424 2427; mul 228 2300; add 2428 2429; mul 84 2330; add 2430 2431; mul 72 2334;
add 2432 2433; mul 33 2335; add 2434 2435; mul 33 2339; add 2436 2437; mul 202 2298; mul 49 2439; add 2438 2440; mul
37 2439; mul 1008 2442; add 2441 2443; mul 199 2298; mul 40 2445; mul 40 2446; add 2444 2447; mul 197 2298; add 2448
2449; mul 89 2372; add 2450 2451; mul 85 2379; add 2452 2453; mul 84 2380; add 2454 2455; mul 84 2385; add 2456
2457; mul 80 2397; add 2458 2459; mul 72 2398; add 2460 2461; mul 33 2399; add 2462 2463; mul 33 2404; add 2464
2465; mul 33 2407; add 2466 2467; mul 283 2348; mul 57 2469; add 2468 2470; mul 37 2469; mul 49 2472; add 2471 2473;
mul 37 2472; mul 1008 2475; add 2474 2476; mul 279 2348; mul 40 2478; mul 49 2479; add 2477 2480; mul 37 2479; mul
1008 2482; add 2481 2483; mul 275 2348; mul 40 2485; mul 40 2486; mul 1008 2487; add 2484 2488; mul 272 2348; mul
1008 2490; add 2489 2491; mul 225 2348; mul 40 2493; mul 40 2494; mul 40 2495; add 2492 2496; mul 223 2348; mul 40
2498; add 2497 2499; mul 32 2500; add 2409 2501; mul 750 2502; sub 2295 2503; mul 472 510; mul 421 2505; mul 439
2506; mul 442 510; mul 471 2508; mul 421 510; mul 429 2510; mul 471 2511; mul 518 2512; add 2509 2513; mul 456 528;
mul 593 2515; mul 469 2515; mul 509 2517; add 2516 2518; mul 469 2517; mul 508 2520; add 2519 2521; mul 455 2508;
mul 432 510; mul 462 2524; sub 2523 2525; mul 520 2511; add 2526 2527; mul 456 2528; mul 609 2529; mul 470 2530; add
2522 2531; mul 592 2532; mul 456 2533; mul 581 2534; mul 579 2535; sub 2514 2536; sub 2507 2537; mul 258 2505; mul
653 2539; sub 2538 2540; mul 436 2505; mul 257 2542; add 2541 2543; mul 335 2537; add 2544 2545; mul 188 2506; mul
35 2547; mul 188 2542; mul 32 2549; add 2548 2550; mul 252 2551; mul 84 2552; mul 33 2552; mul 758 2554; add 2553
2555; mul 214 2551; mul 37 2557; mul 758 2558; add 2556 2559; mul 247 2551; mul 40 2561; mul 758 2562; add 2560
2563; mul 244 2551; mul 37 2565; mul 37 2566; add 2564 2567; mul 199 2551; mul 40 2569; mul 40 2570; add 2568 2571;
mul 197 2551; add 2572 2573; mul 220 2549; mul 84 2575; add 2574 2576; mul 33 2575; mul 758 2578; add 2577 2579; mul
217 2549; mul 37 2581; mul 758 2582; add 2580 2583; mul 214 2549; mul 37 2585; mul 37 2586; add 2584 2587; mul 211
2549; mul 40 2589; mul 37 2590; add 2588 2591; mul 208 2549; mul 40 2593; mul 40 2594; add 2592 2595; mul 205 2549;
add 2596 2597; mul 188 2537; mul 315 2599; mul 40 2600; mul 194 2601; add 2598 2602; mul 4 2600; add 2547 2604; mul
191 2605; add 2603 2606; mul 196 2600; add 2607 2608; mul 33 2600; add 2549 2610; mul 189 2611; add 2609 2612; mul
311 2599; mul 89 2614; add 2613 2615; mul 33 2614; mul 84 2617; add 2616 2618; mul 33 2617; mul 758 2620; add 2619
2621; mul 252 2599; mul 37 2623; mul 84 2624; add 2622 2625; mul 33 2624; mul 758 2627; add 2626 2628; mul 304 2599;
mul 37 2630; mul 37 2631; mul 758 2632; add 2629 2633; mul 247 2599; mul 40 2635; mul 37 2636; mul 758 2637; add
2634 2638; mul 297 2599; mul 40 2640; mul 40 2641; mul 758 2642; add 2639 2643; mul 156 2599; mul 758 2645; add 2644
2646; mul 202 2599; mul 37 2648; mul 37 2649; mul 37 2650; add 2647 2651; mul 199 2599; mul 40 2653; mul 40 2654;
mul 37 2655; add 2652 2656; mul 197 2599; mul 37 2658; add 2657 2659; mul 84 2557; mul 72 2565; add 2661 2662; mul
33 2566; add 2663 2664; mul 237 2551; mul 49 2666; add 2665 2667; mul 37 2666; mul 1008 2669; add 2668 2670; mul 234
2551; mul 40 2672; mul 1008 2673; add 2671 2674; mul 231 2551; mul 40 2676; mul 40 2677; add 2675 2678; mul 228
2551; add 2679 2680; mul 84 2581; add 2681 2682; mul 72 2585; add 2683 2684; mul 33 2586; add 2685 2686; mul 33
2590; add 2687 2688; mul 202 2549; mul 49 2690; add 2689 2691; mul 37 2690; mul 1008 2693; add 2692 2694; mul 199
2549; mul 40 2696; mul 40 2697; add 2695 2698; mul 197 2549; add 2699 2700; mul 89 2623; add 2701 2702; mul 85 2630;
add 2703 2704; mul 84 2631; add 2705 2706; mul 84 2636; add 2707 2708; mul 80 2648; add 2709 2710; mul 72 2649; add
2711 2712; mul 33 2650; add 2713 2714; mul 33 2655; add 2715 2716; mul 33 2658; add 2717 2718; mul 283 2599; mul 57
2720; add 2719 2721; mul 37 2720; mul 49 2723; add 2722 2724; mul 37 2723; mul 1008 2726; add 2725 2727; mul 279
2599; mul 40 2729; mul 49 2730; add 2728 2731; mul 37 2730; mul 1008 2733; add 2732 2734; mul 275 2599; mul 40 2736;
mul 40 2737; mul 1008 2738; add 2735 2739; mul 272 2599; mul 1008 2741; add 2740 2742; mul 225 2599; mul 40 2744;
mul 40 2745; mul 40 2746; add 2743 2747; mul 223 2599; mul 40 2749; add 2748 2750; mul 32 2751; add 2660 2752; mul
750 2753; sub 2546 2754; mul 160 166; input p 118; mul 2756 2757; mul 881 2758; mul 155 165; mul 160 2760; add 2759
2761; mul 159 2760; mul 881 2763; add 2762 2764; mul 168 172; mul 881 2766; add 2765 2767; mul 165 172; mul 173
2769; add 2768 2770; mul 557 2771; where 877 2772; mul 35 148; mul 557 2774; add 2773 2775; mul 184 561; neg 2777;
where 154 2778; add 2776 2779; mul 150 561; sub 2780 2781; mul 1208 2771; neg 2783; where 877 2784; mul 1208 2774;
sub 2785 2786; mul 184 1214; where 154 2788; add 2787 2789; mul 150 1214; add 2790 2791; input p 121; mul 40 2793;
input p 122; mul 97 2795; add 2794 2796; input p 123; mul 101 2798; add 2797 2799; mul 37 93; add 2800 2801; input p
124; mul 41 2803; add 2802 2804; input p 125; mul 45 2806; add 2805 2807; input p 126; mul 49 2809; add 2808 2810;
mul 53 110; add 2811 2812; input p 127; mul 57 2814; add 2813 2815; mul 39 72; add 2816 2817; input p 128; mul 76
2819; add 2818 2820; mul 52 80; add 2821 2822; input p 129; mul 84 2824; add 2823 2825; mul 67 141; add 2826 2827;
mul 85 140; add 2828 2829; mul 1813 2830; neg 2831; mul 549 656; mul 544 561; sub 2833 2834; constant -2.0; mul 1178
1183; le 1174 1175; le 1175 1174; add 2838 2839; div 12 2840; mul 2838 2841; mul 2837 2842; mul 2836 2843; add 2835
2844; mul 549 1299; mul 544 1214; add 2846 2847; mul 1178 1777; mul 2842 2849; mul 2836 2850; sub 2848 2851;
constant 0.8; mul 30 2830; mul 533 1816; sub 2854 2855; mul 1813 2856; mul 1813 2857; mul 2853 2858; constant
-2.5714285714285743; mul 89 932; mul 2860 2861; constant 2.057142857142858; mul 85 932; mul 2863 2864; add 2862
2865; constant -0.8571428571428583; mul 141 932; mul 2867 2868; add 2866 2869; constant -3.428571428571427; mul 80
932; mul 2871 2872; add 2870 2873; constant 0.11428571428571443; mul 76 932; mul 2875 2876; add 2874 2877; constant
-0.057142857142856635; mul 68 932; mul 2879 2880; add 2878 2881; input p 197; mul 33 932; mul 197 2884; mul 2883
2885; add 2882 2886; constant 2.438095238095238; mul 57 932; mul 2888 2889; add 2887 2890; constant
0.6571428571428567; mul 53 932; mul 2892 2893; add 2891 2894; input p 198; mul 49 932; mul 2896 2897; sub 2895 2898;
constant 0.11428571428571413; mul 45 932; mul 2900 2901; add 2899 2902; mul 37 932; mul 228 2904; mul 2883 2905; add
2903 2906; constant -0.019047619047619094; mul 101 932; mul 2908 2909; add 2907 2910; mul 40 932; mul 223 2912; mul
2883 2913; add 2911 2914; constant 12.34285714285715; mul 89 892; mul 2916 2917; sub 2915 2918; constant
-7.714285714285722; mul 85 892; mul 2920 2921; sub 2919 2922; mul 80 892; mul 2863 2924; sub 2923 2925; constant
-1.7142857142857166; mul 76 892; mul 2927 2928; sub 2926 2929; constant 0.9142857142857138; mul 68 892; mul 2931
2932; sub 2930 2933; mul 33 892; mul 205 2935; mul 2883 2936; sub 2934 2937; constant -1.1428571428571423; mul 57
892; mul 2939 2940; sub 2938 2941; constant 0.05714285714285722; mul 53 892; mul 2943 2944; sub 2942 2945; mul 45
892; mul 2879 2947; sub 2946 2948; mul 37 892; mul 197 2950; mul 2883 2951; sub 2949 2952; mul 89 1548; mul 2860
2954; mul 85 1548; mul 2863 2956; add 2955 2957; mul 141 1548; mul 2867 2959; add 2958 2960; mul 80 1548; mul 2871
2962; add 2961 2963; mul 76 1548; mul 2875 2965; add 2964 2966; mul 68 1548; mul 2879 2968; add 2967 2969; mul 33
1548; mul 197 2971; mul 2883 2972; add 2970 2973; mul 57 1548; mul 2888 2975; add 2974 2976; mul 53 1548; mul 2892
2978; add 2977 2979; mul 49 1548; mul 2896 2981; sub 2980 2982; mul 45 1548; mul 2900 2984; add 2983 2985; mul 37
1548; mul 228 2987; mul 2883 2988; add 2986 2989; mul 101 1548; mul 2908 2991; add 2990 2992; mul 40 1548; mul 223
2994; mul 2883 2995; add 2993 2996; mul 89 1513; mul 2916 2998; add 2997 2999; mul 85 1513; mul 2920 3001; add 3000
3002; mul 80 1513; mul 2863 3004; add 3003 3005; mul 76 1513; mul 2927 3007; add 3006 3008; mul 68 1513; mul 2931
3010; add 3009 3011; mul 33 1513; mul 205 3013; mul 2883 3014; add 3012 3015; mul 57 1513; mul 2939 3017; add 3016
3018; mul 53 1513; mul 2943 3020; add 3019 3021; mul 45 1513; mul 2879 3023; add 3022 3024; mul 37 1513; mul 197
3026; mul 2883 3027; add 3025 3028; input p 199; mul 85 3030; mul 2867 3031; mul 141 3030; mul 2931 3033; add 3032
3034; mul 80 3030; mul 2943 3036; add 3035 3037; constant -0.11428571428571327; mul 76 3030; mul 3039 3040; add 3038
3041; constant 0.2190476190476189; mul 57 3030; mul 3043 3044; add 3042 3045; mul 53 3030; mul 2900 3047; add 3046
3048; constant -0.05714285714285729; mul 45 3030; mul 3050 3051; add 3049 3052; mul 37 3030; mul 223 3054; mul 2883
3055; add 3053 3056; constant 0.007256235827664418; mul 101 3030; mul 3058 3059; add 3057 3060; mul 40 3030; mul
1791 3062; mul 2883 3063; add 3061 3064; neg 3065; constant -129.60000000000008; mul 2861 3067; constant
230.40000000000006; mul 2864 3069; add 3068 3070; constant 28.799999999999958; mul 2868 3072; add 3071 3073;
constant -36.00000000000001; mul 84 932; mul 3075 3076; mul 2896 3077; add 3074 3078; constant -151.20000000000002;
mul 2872 3080; add 3079 3081; constant -57.59999999999995; mul 2876 3083; add 3082 3084; constant 72.0; mul 72 932;
mul 3086 3087; mul 2896 3088; add 3085 3089; constant -22.62857142857143; mul 2880 3091; add 3090 3092; constant
28.79999999999999; mul 64 932; mul 3094 3095; mul 2896 3096; add 3093 3097; constant -18.000000000000004; mul 2884
3099; mul 2883 3100; add 3098 3101; constant 35.20000000000001; mul 2889 3103; add 3102 3104; constant
21.59999999999998; mul 2893 3106; add 3105 3107; constant -30.000000000000007; mul 2897 3109; mul 2896 3110; add
3108 3111; constant 13.714285714285717; mul 2901 3113; add 3112 3114; constant -14.399999999999991; mul 41 932; mul
3116 3117; mul 2896 3118; add 3115 3119; mul 537 2904; mul 2883 3121; add 3120 3122; constant 0.4571428571428564;
mul 2909 3124; add 3123 3125; constant -2.3999999999999995; mul 97 932; mul 3127 3128; mul 2896 3129; add 3126 3130;
input p 200; constant -0.9999999999999998; mul 932 3133; mul 3132 3134; add 3131 3135; constant 259.2000000000001;
mul 2917 3137; sub 3136 3138; constant -388.80000000000024; mul 2921 3140; sub 3139 3141; mul 2924 3069; sub 3142
3143; constant 57.599999999999916; mul 2928 3145; sub 3144 3146; constant -72.00000000000001; mul 72 892; mul 3148
3149; mul 2896 3150; sub 3147 3151; constant 45.25714285714287; mul 2932 3153; sub 3152 3154; constant
-57.60000000000001; mul 64 892; mul 3156 3157; mul 2896 3158; sub 3155 3159; constant 36.000000000000014; mul 2935
3161; mul 2883 3162; sub 3160 3163; constant -50.400000000000006; mul 2940 3165; sub 3164 3166; constant
-28.799999999999976; mul 2944 3168; sub 3167 3169; constant 36.0; mul 49 892; mul 3171 3172; mul 2896 3173; sub 3170
3174; mul 2947 3091; sub 3175 3176; mul 41 892; mul 3094 3178; mul 2896 3179; sub 3177 3180; mul 2950 3099; mul 2883
3182; sub 3181 3183; mul 2954 3067; mul 2956 3069; add 3185 3186; mul 2959 3072; add 3187 3188; mul 84 1548; mul
3075 3190; mul 2896 3191; add 3189 3192; mul 2962 3080; add 3193 3194; mul 2965 3083; add 3195 3196; mul 72 1548;
mul 3086 3198; mul 2896 3199; add 3197 3200; mul 2968 3091; add 3201 3202; mul 64 1548; mul 3094 3204; mul 2896
3205; add 3203 3206; mul 2971 3099; mul 2883 3208; add 3207 3209; mul 2975 3103; add 3210 3211; mul 2978 3106; add
3212 3213; mul 2981 3109; mul 2896 3215; add 3214 3216; mul 2984 3113; add 3217 3218; mul 41 1548; mul 3116 3220;
mul 2896 3221; add 3219 3222; mul 537 2987; mul 2883 3224; add 3223 3225; mul 2991 3124; add 3226 3227; mul 97 1548;
mul 3127 3229; mul 2896 3230; add 3228 3231; mul 1548 3133; mul 3132 3233; add 3232 3234; mul 2998 3137; add 3235
3236; mul 3001 3140; add 3237 3238; mul 3004 3069; add 3239 3240; mul 3007 3145; add 3241 3242; mul 72 1513; mul
3148 3244; mul 2896 3245; add 3243 3246; mul 3010 3153; add 3247 3248; mul 64 1513; mul 3156 3250; mul 2896 3251;
add 3249 3252; mul 3013 3161; mul 2883 3254; add 3253 3255; mul 3017 3165; add 3256 3257; mul 3020 3168; add 3258
3259; mul 49 1513; mul 3171 3261; mul 2896 3262; add 3260 3263; mul 3023 3091; add 3264 3265; mul 41 1513; mul 3094
3267; mul 2896 3268; add 3266 3269; mul 3026 3099; mul 2883 3271; add 3270 3272; mul 3031 3072; mul 3033 3153; add
3274 3275; constant -28.800000000000004; mul 84 3030; mul 3277 3278; mul 2896 3279; add 3276 3280; mul 3036 3168;
add 3281 3282; constant -45.25714285714286; mul 3040 3284; add 3283 3285; mul 72 3030; mul 3094 3287; mul 2896 3288;
add 3286 3289; constant 7.199999999999994; mul 3044 3291; add 3290 3292; mul 3047 3113; add 3293 3294; constant
-7.199999999999996; mul 49 3030; mul 3296 3297; mul 2896 3298; add 3295 3299; constant 1.3714285714285692; mul 3051
3301; add 3300 3302; constant -4.799999999999999; mul 41 3030; mul 3304 3305; mul 2896 3306; add 3303 3307; constant
1.3714285714285714; mul 3059 3309; add 3308 3310; constant -1.3714285714285723; mul 97 3030; mul 3312 3313; mul 2896
3314; add 3311 3315; constant 2.400000000000001; mul 3062 3317; mul 2883 3318; add 3316 3319; neg 3320; constant
-0.12857142857142845; mul 89 755; mul 3322 3323; constant 0.12857142857142853; mul 85 755; mul 3325 3326; add 3324
3327; constant -0.04285714285714284; mul 141 755; mul 3329 3330; add 3328 3331; constant 0.010714285714285735; mul
80 755; mul 3333 3334; add 3332 3335; constant -0.0006802721088435403; mul 68 755; mul 3337 3338; add 3336 3339;
constant 0.028571428571428567; mul 57 755; mul 3341 3342; add 3340 3343; constant -0.010714285714285721; mul 53 755;
mul 3345 3346; add 3344 3347; constant 0.0027210884353741486; mul 45 755; mul 3349 3350; add 3348 3351; constant
-0.0004787100025195255; mul 101 755; mul 3353 3354; add 3352 3355; constant 1.0285714285714285; mul 89 753; mul 3357
3358; add 3356 3359; constant -0.38571428571428534; mul 85 753; mul 3361 3362; add 3360 3363; mul 80 753; mul 3325
3365; add 3364 3366; constant -0.08571428571428567; mul 76 753; mul 3368 3369; add 3367 3370; constant
0.029931972789115628; mul 68 753; mul 3372 3373; add 3371 3374; constant 0.0035714285714285787; mul 57 753; mul 3376
3377; add 3375 3378; mul 45 753; mul 3337 3380; add 3379 3381; constant 0.2571428571428571; mul 312 804; mul 3383
3384; add 3382 3385; mul 308 804; mul 3322 3387; add 3386 3388; constant 0.06428571428571427; mul 305 804; mul 3390
3391; add 3389 3392; mul 301 804; mul 3329 3394; add 3393 3395; constant 0.014965986394557814; mul 298 804; mul 3397
3398; add 3396 3399; mul 292 804; mul 3376 3401; add 3400 3402; mul 289 804; mul 3337 3404; add 3403 3405; constant
0.007142857142857142; mul 284 804; mul 3407 3408; add 3406 3409; constant -0.003571428571428574; mul 280 804; mul
3411 3412; add 3410 3413; constant 0.0013605442176870743; mul 276 804; mul 3415 3416; add 3414 3417; mul 269 804;
mul 3353 3419; add 3418 3420; constant 8.118473726939319e-05; mul 264 804; mul 3422 3423; add 3421 3424; mul 89
1389; mul 3322 3426; mul 85 1389; mul 3325 3428; add 3427 3429; mul 141 1389; mul 3329 3431; add 3430 3432; mul 80
1389; mul 3333 3434; add 3433 3435; mul 68 1389; mul 3337 3437; add 3436 3438; mul 57 1389; mul 3341 3440; add 3439
3441; mul 53 1389; mul 3345 3443; add 3442 3444; mul 45 1389; mul 3349 3446; add 3445 3447; mul 101 1389; mul 3353
3449; add 3448 3450; mul 89 1387; mul 3357 3452; sub 3451 3453; mul 85 1387; mul 3361 3455; sub 3454 3456; mul 80
1387; mul 3325 3458; sub 3457 3459; mul 76 1387; mul 3368 3461; sub 3460 3462; mul 68 1387; mul 3372 3464; sub 3463
3465; mul 57 1387; mul 3376 3467; sub 3466 3468; mul 45 1387; mul 3337 3470; sub 3469 3471; mul 312 1437; mul 3383
3473; add 3472 3474; mul 308 1437; mul 3322 3476; add 3475 3477; mul 305 1437; mul 3390 3479; add 3478 3480; mul 301
1437; mul 3329 3482; add 3481 3483; mul 298 1437; mul 3397 3485; add 3484 3486; mul 292 1437; mul 3376 3488; add
3487 3489; mul 289 1437; mul 3337 3491; add 3490 3492; mul 284 1437; mul 3407 3494; add 3493 3495; mul 280 1437; mul
3411 3497; add 3496 3498; mul 276 1437; mul 3415 3500; add 3499 3501; mul 269 1437; mul 3353 3503; add 3502 3504;
mul 264 1437; mul 3422 3506; add 3505 3507; mul 85 1957; mul 3329 3509; mul 141 1957; mul 3372 3511; add 3510 3512;
constant -0.0013605442176870806; mul 76 1957; mul 3514 3515; add 3513 3516; mul 57 1957; mul 3411 3518; add 3517
3519; mul 53 1957; mul 3349 3521; add 3520 3522; constant -0.0014361300075585765; mul 45 1957; mul 3524 3525; add
3523 3526; constant 0.00032473894907757275; mul 101 1957; mul 3528 3529; add 3527 3530; mul 89 1995; mul 3322 3532;
sub 3531 3533; mul 85 1995; mul 3325 3535; sub 3534 3536; mul 141 1995; mul 3329 3538; sub 3537 3539; mul 80 1995;
mul 3333 3541; sub 3540 3542; mul 68 1995; mul 3337 3544; sub 3543 3545; mul 57 1995; mul 3341 3547; sub 3546 3548;
mul 53 1995; mul 3345 3550; sub 3549 3551; mul 45 1995; mul 3349 3553; sub 3552 3554; mul 101 1995; mul 3353 3556;
sub 3555 3557; mul 89 1993; mul 3357 3559; sub 3558 3560; mul 85 1993; mul 3361 3562; sub 3561 3563; mul 80 1993;
mul 3325 3565; sub 3564 3566; mul 76 1993; mul 3368 3568; sub 3567 3569; mul 68 1993; mul 3372 3571; sub 3570 3572;
mul 57 1993; mul 3376 3574; sub 3573 3575; mul 45 1993; mul 3337 3577; sub 3576 3578; mul 312 2044; mul 3383 3580;
add 3579 3581; mul 308 2044; mul 3322 3583; add 3582 3584; mul 305 2044; mul 3390 3586; add 3585 3587; mul 301 2044;
mul 3329 3589; add 3588 3590; mul 298 2044; mul 3397 3592; add 3591 3593; mul 292 2044; mul 3376 3595; add 3594
3596; mul 289 2044; mul 3337 3598; add 3597 3599; mul 284 2044; mul 3407 3601; add 3600 3602; mul 280 2044; mul 3411
3604; add 3603 3605; mul 276 2044; mul 3415 3607; add 3606 3608; mul 269 2044; mul 3353 3610; add 3609 3611; mul 264
2044; mul 3422 3613; add 3612 3614; mul 89 2300; mul 3322 3616; mul 85 2300; mul 3325 3618; add 3617 3619; mul 141
2300; mul 3329 3621; add 3620 3622; mul 80 2300; mul 3333 3624; add 3623 3625; mul 68 2300; mul 3337 3627; add 3626
3628; mul 57 2300; mul 3341 3630; add 3629 3631; mul 53 2300; mul 3345 3633; add 3632 3634; mul 45 2300; mul 3349
3636; add 3635 3637; mul 101 2300; mul 3353 3639; add 3638 3640; mul 89 2298; mul 3357 3642; add 3641 3643; mul 85
2298; mul 3361 3645; add 3644 3646; mul 80 2298; mul 3325 3648; add 3647 3649; mul 76 2298; mul 3368 3651; add 3650
3652; mul 68 2298; mul 3372 3654; add 3653 3655; mul 57 2298; mul 3376 3657; add 3656 3658; mul 45 2298; mul 3337
3660; add 3659 3661; mul 312 2348; mul 3383 3663; add 3662 3664; mul 308 2348; mul 3322 3666; add 3665 3667; mul 305
2348; mul 3390 3669; add 3668 3670; mul 301 2348; mul 3329 3672; add 3671 3673; mul 298 2348; mul 3397 3675; add
3674 3676; mul 292 2348; mul 3376 3678; add 3677 3679; mul 289 2348; mul 3337 3681; add 3680 3682; mul 284 2348; mul
3407 3684; add 3683 3685; mul 280 2348; mul 3411 3687; add 3686 3688; mul 276 2348; mul 3415 3690; add 3689 3691;
mul 269 2348; mul 3353 3693; add 3692 3694; mul 264 2348; mul 3422 3696; add 3695 3697; mul 89 2551; mul 3322 3699;
mul 85 2551; mul 3325 3701; add 3700 3702; mul 141 2551; mul 3329 3704; add 3703 3705; mul 80 2551; mul 3333 3707;
add 3706 3708; mul 68 2551; mul 3337 3710; add 3709 3711; mul 57 2551; mul 3341 3713; add 3712 3714; mul 53 2551;
mul 3345 3716; add 3715 3717; mul 45 2551; mul 3349 3719; add 3718 3720; mul 101 2551; mul 3353 3722; add 3721 3723;
mul 89 2549; mul 3357 3725; add 3724 3726; mul 85 2549; mul 3361 3728; add 3727 3729; mul 80 2549; mul 3325 3731;
add 3730 3732; mul 76 2549; mul 3368 3734; add 3733 3735; mul 68 2549; mul 3372 3737; add 3736 3738; mul 57 2549;
mul 3376 3740; add 3739 3741; mul 45 2549; mul 3337 3743; add 3742 3744; mul 312 2599; mul 3383 3746; add 3745 3747;
mul 308 2599; mul 3322 3749; add 3748 3750; mul 305 2599; mul 3390 3752; add 3751 3753; mul 301 2599; mul 3329 3755;
add 3754 3756; mul 298 2599; mul 3397 3758; add 3757 3759; mul 292 2599; mul 3376 3761; add 3760 3762; mul 289 2599;
mul 3337 3764; add 3763 3765; mul 284 2599; mul 3407 3767; add 3766 3768; mul 280 2599; mul 3411 3770; add 3769
3771; mul 276 2599; mul 3415 3773; add 3772 3774; mul 269 2599; mul 3353 3776; add 3775 3777; mul 264 2599; mul 3422
3779; add 3778 3780; input p 201; mul 3077 3782; mul 3088 3782; add 3783 3784; mul 3096 3782; add 3785 3786; input p
202; input p 203; mul 2885 3789; mul 3788 3790; add 3787 3791; mul 3100 3782; mul 3788 3793; add 3792 3794; mul 2897
3789; sub 3795 3796; mul 3110 3782; add 3797 3798; mul 3118 3782; add 3799 3800; mul 2905 3789; mul 3788 3802; add
3801 3803; mul 3121 3782; mul 3788 3805; add 3804 3806; mul 3129 3782; add 3807 3808; mul 2913 3789; mul 3788 3810;
add 3809 3811; mul 3134 3782; mul 2883 3813; add 3812 3814; mul 2896 3813; mul 3788 3816; add 3815 3817; add 3134
3818; mul 3150 3782; sub 3819 3820; mul 3158 3782; sub 3821 3822; mul 2936 3789; mul 3788 3824; sub 3823 3825; mul
3162 3782; mul 3788 3827; sub 3826 3828; mul 3173 3782; sub 3829 3830; mul 3179 3782; sub 3831 3832; mul 2951 3789;
mul 3788 3834; sub 3833 3835; mul 3182 3782; mul 3788 3837; sub 3836 3838; mul 3191 3782; mul 3199 3782; add 3840
3841; mul 3205 3782; add 3842 3843; mul 2972 3789; mul 3788 3845; add 3844 3846; mul 3208 3782; mul 3788 3848; add
3847 3849; mul 2981 3789; sub 3850 3851; mul 3215 3782; add 3852 3853; mul 3221 3782; add 3854 3855; mul 2988 3789;
mul 3788 3857; add 3856 3858; mul 3224 3782; mul 3788 3860; add 3859 3861; mul 3230 3782; add 3862 3863; mul 2995
3789; mul 3788 3865; add 3864 3866; mul 3233 3782; mul 2883 3868; add 3867 3869; mul 2896 3868; mul 3788 3871; add
3870 3872; add 3233 3873; mul 3245 3782; add 3874 3875; mul 3251 3782; add 3876 3877; mul 3014 3789; mul 3788 3879;
add 3878 3880; mul 3254 3782; mul 3788 3882; add 3881 3883; mul 3262 3782; add 3884 3885; mul 3268 3782; add 3886
3887; mul 3027 3789; mul 3788 3889; add 3888 3890; mul 3271 3782; mul 3788 3892; add 3891 3893; mul 3279 3782; mul
3288 3782; add 3895 3896; mul 3298 3782; add 3897 3898; mul 3306 3782; add 3899 3900; mul 3055 3789; mul 3788 3902;
add 3901 3903; mul 3314 3782; add 3904 3905; mul 3063 3789; mul 3788 3907; add 3906 3908; mul 3318 3782; mul 3788
3910; add 3909 3911; neg 3912; mul 436 662; mul 550 561; sub 3914 3915; mul 254 753; add 3916 3917; mul 148 892; sub
3918 3919; mul 33 1155; add 3920 3921; mul 550 1214; mul 436 1305; add 3923 3924; mul 254 1387; sub 3925 3926; mul
148 1513; add 3927 3928; mul 33 1770; add 3929 3930; mul 33 2249; mul 254 1993; sub 3932 3933; mul 254 2298; mul 33
2500; add 3935 3936; mul 254 2549; mul 33 2751; add 3938 3939; mul 550 557; mul 148 878; add 3941 3942; mul 421 662;
add 3943 3944; mul 254 751; add 3945 3946; mul 4 1155; add 3947 3948; mul 421 1305; mul 550 1208; mul 148 1499; add
3951 3952; sub 3950 3953; mul 254 1385; add 3954 3955; mul 4 1770; add 3956 3957; mul 4 2249; mul 254 1991; sub 3959
3960; mul 254 2296; mul 4 2500; add 3962 3963; mul 254 2547; mul 4 2751; add 3965 3966; mul 33 816; mul 33 1449; mul
33 2057; mul 33 2360; mul 33 2611; mul 33 810; mul 4 816; add 3973 3974; mul 33 1443; mul 4 1449; add 3976 3977; mul
33 2051; mul 4 2057; add 3979 3980; mul 33 2354; mul 4 2360; add 3982 3983; mul 33 2605; mul 4 2611; add 3985 3986;
mul 4 810; mul 4 1443; mul 4 2051; mul 4 2354; mul 4 2605; mul 33 806; mul 40 816; add 3993 3994; mul 33 1439; mul
40 1449; add 3996 3997; mul 33 2047; mul 40 2057; add 3999 4000; mul 33 2350; mul 40 2360; add 4002 4003; mul 33
2601; mul 40 2611; add 4005 4006; mul 4 806; mul 40 810; add 4008 4009; mul 4 1439; mul 40 1443; add 4011 4012; mul
4 2047; mul 40 2051; add 4014 4015; mul 4 2350; mul 40 2354; add 4017 4018; mul 4 2601; mul 40 2605; add 4020 4021;
mul 40 806; mul 40 1439; mul 40 2047; mul 40 2350; mul 40 2601; mul 455 576; mul 453 4028; mul 462 576; mul 450
4030; add 4029 4031; mul 450 637; add 4032 4033; mul 471 613; mul 516 576; add 4035 4036; mul 166 462; mul 635 4038;
add 4037 4039; mul 453 4040; sub 4034 4041; mul 358 684; mul 354 4043; sub 4042 4044; mul 365 684; mul 351 4046; add
4045 4047; mul 351 745; add 4048 4049; mul 374 721; mul 422 684; add 4051 4052; mul 166 365; mul 743 4054; add 4053
4055; mul 354 4056; add 4050 4057; mul 349 4058; mul 453 4030; input p 119; mul 429 557; mul 4061 4062; mul 450
4028; add 4063 4064; sub 4060 4065; mul 453 637; add 4066 4067; mul 450 4040; add 4068 4069; mul 351 4043; sub 4070
4071; mul 354 4046; sub 4072 4073; mul 354 745; sub 4074 4075; mul 351 4056; add 4076 4077; mul 349 4078; mul 4
4079; mul 349 429; mul 521 574; mul 356 4061; mul 557 4083; sub 4082 4084; mul 427 682; add 4085 4086; mul 4081
4087; mul 349 356; mul 4078 4089; add 4088 4090; mul 349 350; mul 4058 4092; add 4091 4093; mul 346 4094; sub 4080
4095; mul 166 347; div 12 4097; mul 4096 4098; add 4059 4099; mul 4 4100; mul 4 4101; mul 428 428; mul 349 4087; mul
4103 4104; mul 347 4094; add 4105 4106; mul 166 346; div 12 4108; mul 4107 4109; mul 4 4110; mul 4 4111; sub 4102
4112; mul 450 1294; mul 455 1291; mul 453 4115; mul 462 1291; mul 450 4117; add 4116 4118; sub 4114 4119; mul 471
1258; mul 516 1291; sub 4121 4122; mul 1288 4038; add 4123 4124; mul 453 4125; sub 4120 4126; mul 358 1323; mul 354
4128; add 4127 4129; mul 365 1323; mul 351 4131; sub 4130 4132; mul 351 1380; add 4133 4134; mul 374 1355; mul 422
1323; sub 4136 4137; mul 1378 4054; add 4138 4139; mul 354 4140; add 4135 4141; mul 349 4142; mul 429 1208; mul 4061
4144; mul 450 4115; add 4145 4146; mul 453 4117; sub 4147 4148; mul 453 1294; add 4149 4150; mul 450 4125; add 4151
4152; mul 351 4128; add 4153 4154; mul 354 4131; add 4155 4156; mul 354 1380; sub 4157 4158; mul 351 4140; add 4159
4160; mul 349 4161; mul 4 4162; mul 1208 4083; mul 521 1267; sub 4164 4165; mul 427 1321; sub 4166 4167; mul 4081
4168; mul 4089 4161; add 4169 4170; mul 4092 4142; add 4171 4172; mul 346 4173; sub 4163 4174; mul 4098 4175; add
4143 4176; mul 4 4177; mul 4 4178; mul 349 4168; mul 4103 4180; mul 347 4173; add 4181 4182; mul 4109 4183; mul 4
4184; mul 4 4185; sub 4179 4186; mul 521 1851; mul 427 1894; add 4188 4189; mul 349 4190; mul 4103 4191; mul 4081
4190; mul 455 1875; mul 450 4194; mul 462 1875; mul 453 4196; sub 4195 4197; mul 453 1878; add 4198 4199; mul 471
1844; mul 516 1875; sub 4201 4202; mul 1872 4038; add 4203 4204; mul 450 4205; add 4200 4206; mul 358 1896; mul 351
4208; add 4207 4209; mul 365 1896; mul 354 4211; add 4210 4212; mul 354 1952; sub 4213 4214; mul 374 1927; mul 422
1896; sub 4216 4217; mul 1950 4054; add 4218 4219; mul 351 4220; add 4215 4221; mul 4089 4222; sub 4193 4223; mul
450 1878; mul 453 4194; mul 450 4196; add 4226 4227; sub 4225 4228; mul 453 4205; sub 4229 4230; mul 354 4208; add
4231 4232; mul 351 4211; sub 4233 4234; mul 351 1952; add 4235 4236; mul 354 4220; add 4237 4238; mul 4092 4239; sub
4224 4240; mul 347 4241; add 4192 4242; mul 4109 4243; mul 4 4244; mul 4 4245; mul 349 4239; mul 349 4222; mul 4
4248; mul 346 4241; add 4249 4250; mul 4098 4251; add 4247 4252; mul 4 4253; mul 4 4254; add 4246 4255; mul 365
2267; mul 351 4257; mul 358 2267; mul 354 4259; sub 4258 4260; mul 351 2292; add 4261 4262; mul 422 2267; mul 374
2279; sub 4264 4265; mul 2290 4054; sub 4266 4267; mul 354 4268; add 4263 4269; mul 349 4270; mul 351 4268; mul 351
4259; mul 354 4257; add 4273 4274; mul 354 2292; add 4275 4276; sub 4272 4277; mul 349 4278; mul 4 4279; mul 427
2265; mul 4081 4281; mul 4089 4278; add 4282 4283; mul 4092 4270; add 4284 4285; mul 346 4286; sub 4280 4287; mul
4098 4288; add 4271 4289; mul 4 4290; mul 4 4291; mul 349 4281; mul 4103 4293; mul 347 4286; add 4294 4295; mul 4109
4296; mul 4 4297; mul 4 4298; sub 4292 4299; mul 455 2512; mul 453 4301; mul 462 2512; mul 450 4303; add 4302 4304;
mul 450 2537; add 4305 4306; mul 516 2512; mul 471 2524; sub 4308 4309; mul 2535 4038; sub 4310 4311; mul 453 4312;
sub 4307 4313; mul 349 4314; mul 453 4303; mul 450 4301; sub 4316 4317; mul 453 2537; add 4318 4319; mul 450 4312;
add 4320 4321; mul 349 4322; mul 4 4323; mul 521 2510; mul 4081 4325; mul 4089 4322; add 4326 4327; mul 4092 4314;
add 4328 4329; mul 346 4330; sub 4324 4331; mul 4098 4332; add 4315 4333; mul 4 4334; mul 4 4335; mul 349 4325; mul
4103 4337; mul 347 4330; add 4338 4339; mul 4109 4340; mul 4 4341; mul 4 4342; sub 4336 4343; mul 180 893; neg 4345;
where 154 4346; mul 180 1514; where 154 4348; mul 878 2769; where 877 4350; mul 165 893; mul 172 892; add 4352 4353;
mul 159 4354; neg 4355; where 154 4356; add 4351 4357; mul 1499 2769; neg 4359; where 877 4360; mul 165 1514; mul
172 1513; add 4362 4363; mul 159 4364; where 154 4365; add 4361 4366; mul 172 882; where 877 4368; mul 160 893; neg
4370; where 154 4371; add 4369 4372; mul 172 1502; neg 4374; where 877 4375; mul 160 1514; where 154 4377; add 4376
4378; mul 165 888; where 877 4380; mul 161 892; neg 4382; where 154 4383; add 4381 4384; mul 165 1508; neg 4386;
where 877 4387; mul 161 1513; where 154 4389; add 4388 4390; mul 882 2756; where 877 4392; mul 1502 2756; neg 4394;
where 877 4395; input c 0; input c 2; mul 391 4398; add 4397 4399; input c 3; mul 487 4401; add 4400 4402; mul 1164
1198; add 4403 4404; mul 1162 1180; sub 4405 4406; input p 2; input c 1; add 4408 4409; constant 0.0; max 4410 4411;
mul 432 4412; sub 4407 4413; mul 433 446; mul 524 530; add 4415 4416; sub 554 4417; sub 4414 4418; input p 101;
input p 102; input z 0; mul 4421 4422; input p 103; input z 1; mul 4424 4425; add 4423 4426; input p 104; input z 2;
mul 4428 4429; add 4427 4430; input p 105; input z 3; mul 4432 4433; add 4431 4434; sub 4420 4435; input p 106; abs
432; mul 4437 4438; mul 432 4439; input p 107; mul 432 4441; mul 432 432; input p 108; add 4443 4444; sqrt 4445; div
12 4446; mul 4442 4447; add 4440 4448; sub 4436 4449; add 4419 4450; input p 109; input x 11; sub 1 4453; mul 4452
4454; input p 110; input x 12; sub 1 4457; mul 4456 4458; add 4455 4459; sub 4451 4460; mul 13 432; input p 114; mul
421 4463; add 4462 4464; mul 432 4465; mul 5 421; mul 421 4467; add 4466 4468; mul 8 4469; mul 16 4470; sub 4461
4471; mul 11 4472; mul 30 2774; mul 30 2771; where 877 4475; add 4474 4476; mul 440 533; sub 4477 4478; mul 35 550;
add 4479 4480; mul 430 446; mul 522 530; add 4482 4483; add 4481 4484; sub 1180 4485; mul 429 4083; add 4486 4487;
input p 120; mul 4435 4489; sub 4488 4490; mul 7 4470; sub 4491 4492; mul 24 4493; sub 4473 4494; mul 27 4495; mul
27 4496; mul 24 166; mul 4497 4498; mul 27 4493; sub 4499 4500; mul 7 4501; mul 16 4502; mul 11 4497; mul 18 4504;
sub 4503 4505; mul 27 4472; mul 19 4497; sub 4507 4508; mul 7 4509; mul 7 4510; add 4506 4511; mul 7 557; mul 16 28;
sub 4513 4514; mul 4469 4515; add 4512 4516; mul 19 4493; mul 24 4472; sub 4518 4519; mul 27 4520; mul 27 4521; mul
11 4522; sub 4500 4523; mul 18 4524; mul 4498 4522; sub 4526 4507; mul 7 4527; mul 16 4528; add 4525 4529; mul 19
4522; mul 7 4531; mul 7 4532; sub 4530 4533; mul 16 557; mul 7 1208; sub 4535 4536; mul 4469 4537; add 4534 4538;
neg 4531; mul 8 4515; mul 432 4541; mul 432 4542; mul 8 4502; mul 16 166; mul 8 4504; mul 4545 4546; sub 4544 4547;
mul 28 4470; sub 4548 4549; mul 1 4550; add 4543 4551; mul 8 4537; mul 432 4553; mul 432 4554; mul 8 4524; mul 4545
4556; mul 8 4528; add 4557 4558; mul 557 4470; add 4559 4560; mul 1 4561; add 4555 4562; mul 22 4501; add 4560 4564;
mul 9 4509; add 4565 4566; mul 8 4510; add 4567 4568; mul 1 4569; mul 421 4542; mul 166 4571; add 4570 4572; mul 4
4550; add 4573 4574; mul 22 4527; mul 1208 4470; sub 4576 4577; mul 9 4531; sub 4578 4579; mul 8 4532; sub 4580
4581; mul 1 4582; mul 421 4554; mul 166 4584; add 4583 4585; mul 4 4561; add 4586 4587; mul 4 4569; mul 421 4541;
mul 421 4590; add 4589 4591; mul 4 4582; mul 421 4553; mul 421 4594; add 4593 4595; input p 204; mul 356 4062; mul
4597 4598; sub 564 4599; mul 356 4144; mul 4597 4601; add 1216 4602; mul 259 4598; neg 4604; mul 259 4601; neg 557;
neg 401; neg 497; neg 404; neg 500; neg 408; neg 504; le 4411 4410; le 4410 4411; add 4614 4615; div 12 4616; mul
4614 4617; mul 28 432; mul 4618 4619; neg 4620; mul 432 557; mul 4618 4622; mul 4438 4619; neg 4624; mul 4438 4622;
mul 28 4447; mul 432 4627; neg 4628; mul 557 4447; mul 432 4630; input p 205; mul 4447 4448; mul 28 4633; mul 166
4446; div 12 4635; mul 4634 4636; mul 4632 4637; mul 557 4633; mul 4636 4639; mul 4632 4640; neg 4641; mul 557 4435;
mul 1208 4435; neg 4644; le 12 4422; mul 421 4489; add 432 4647; lt 4411 4648; and 4646 4649; constant -1.0; le 4422
4651; lt 4648 4411; and 4652 4653; or 4650 4654; not 4655; input p 139; mul 421 4657; where 4656 4658; le 12 4425;
and 4649 4660; le 4425 4651; and 4653 4662; or 4661 4663; not 4664; input p 140; mul 421 4666; where 4665 4667; le
12 4429; and 4649 4669; le 4429 4651; and 4653 4671; or 4670 4672; not 4673; input p 141; mul 421 4675; where 4674
4676; le 12 4433; and 4649 4678; le 4433 4651; and 4653 4680; or 4679 4681; not 4682; input p 142; mul 421 4684;
where 4683 4685; mul 350 4056; mul 350 4043; mul 356 4046; add 4688 4689; mul 356 745; add 4690 4691; sub 4687 4692;
mul 350 4128; mul 356 4131; add 4694 4695; mul 356 1380; sub 4696 4697; mul 350 4140; add 4698 4699; mul 350 4208;
mul 356 4211; add 4701 4702; mul 356 1952; sub 4703 4704; mul 350 4220; add 4705 4706; mul 350 4268; mul 350 4259;
mul 356 4257; add 4709 4710; mul 356 2292; add 4711 4712; sub 4708 4713; mul 350 4046; mul 356 4043; sub 4715 4716;
mul 350 745; add 4717 4718; mul 356 4056; add 4719 4720; mul 356 4128; mul 350 4131; sub 4722 4723; mul 350 1380;
add 4724 4725; mul 356 4140; add 4726 4727; mul 356 4208; mul 350 4211; sub 4729 4730; mul 350 1952; add 4731 4732;
mul 356 4220; add 4733 4734; mul 350 4257; mul 356 4259; sub 4736 4737; mul 350 2292; add 4738 4739; mul 356 4268;
add 4740 4741; neg 4056; neg 4140; neg 4220; neg 4268; mul 359 374; mul 725 4747; mul 359 415; mul 708 4749; add
4748 4750; mul 359 399; mul 644 4752; add 4751 4753; mul 359 370; mul 741 4755; add 4754 4756; neg 4757; mul 1345
4749; mul 1360 4747; sub 4759 4760; mul 1225 4752; add 4761 4762; mul 1376 4755; sub 4763 4764; mul 1918 4749; mul
1932 4747; sub 4766 4767; mul 1881 4752; add 4768 4769; mul 1948 4755; sub 4770 4771; mul 2288 4755; mul 2283 4747;
mul 444 4749; add 4774 4775; sub 4773 4776; mul 380 727; mul 380 1362; neg 4779; mul 380 1934; neg 4781; neg 1336;
neg 1909; mul 383 696; mul 383 1336; neg 4786; mul 383 1909; neg 4788; mul 396 690; mul 391 4790; neg 4791; mul 396
1330; mul 391 4793; mul 396 1903; mul 391 4795; mul 383 693; neg 4797; mul 383 1331; mul 383 1904; mul 415 644; mul
401 4801; mul 415 1225; mul 401 4803; neg 4804; mul 415 1881; mul 401 4806; neg 4807; mul 404 4801; mul 404 4803;
neg 4810; mul 404 4806; neg 4812; mul 408 4801; mul 408 4803; neg 4815; mul 408 4806; neg 4817; mul 415 704; mul 415
1341; neg 4820; mul 415 1914; neg 4822; mul 350 4028; mul 356 4030; add 4824 4825; mul 356 637; add 4826 4827; mul
350 4040; sub 4828 4829; mul 356 1294; mul 350 4115; mul 356 4117; add 4832 4833; sub 4831 4834; mul 350 4125; sub
4835 4836; mul 356 1878; mul 350 4194; mul 356 4196; add 4839 4840; sub 4838 4841; mul 350 4205; sub 4842 4843; mul
350 4301; mul 356 4303; add 4845 4846; mul 356 2537; add 4847 4848; mul 350 4312; sub 4849 4850; mul 350 4030; mul
356 4028; sub 4852 4853; mul 350 637; add 4854 4855; mul 356 4040; add 4856 4857; mul 356 4115; mul 350 4117; sub
4859 4860; mul 350 1294; add 4861 4862; mul 356 4125; add 4863 4864; mul 356 4194; mul 350 4196; sub 4866 4867; mul
350 1878; add 4868 4869; mul 356 4205; add 4870 4871; mul 350 4303; mul 356 4301; sub 4873 4874; mul 350 2537; add
4875 4876; mul 356 4312; add 4877 4878; mul 456 471; mul 617 4880; mul 456 510; mul 600 4882; add 4881 4883; mul 456
495; mul 566 4885; add 4884 4886; mul 456 467; mul 633 4888; add 4887 4889; neg 4890; mul 1248 4882; mul 1270 4880;
sub 4892 4893; mul 1218 4885; add 4894 4895; mul 1286 4888; sub 4896 4897; mul 1834 4882; mul 1854 4880; sub 4899
4900; mul 1818 4885; add 4901 4902; mul 1870 4888; sub 4903 4904; mul 2533 4888; mul 2528 4880; mul 528 4882; add
4907 4908; sub 4906 4909; mul 477 619; mul 477 1272; neg 4912; mul 477 1856; neg 4914; neg 1239; neg 1825; mul 479
588; mul 479 1239; neg 4919; mul 479 1825; neg 4921; mul 492 582; mul 487 4923; neg 4924; mul 492 1233; mul 487
4926; mul 492 1819; mul 487 4928; mul 479 585; neg 4930; mul 479 1234; mul 479 1820; mul 510 566; mul 497 4934; mul
510 1218; mul 497 4936; neg 4937; mul 510 1818; mul 497 4939; neg 4940; mul 500 4934; mul 500 4936; neg 4943; mul
500 4939; neg 4945; mul 504 4934; mul 504 4936; neg 4948; mul 504 4939; neg 4950; mul 510 596; mul 510 1244; neg
4953; mul 510 1830; neg 4955; mul 557 4489; sub 4957 28; mul 4422 4958; mul 1208 4489; sub 557 4960; mul 4422 4961;
mul 4425 4958; mul 4425 4961; mul 4429 4958; mul 4429 4961; mul 4433 4958; mul 4433 4961; mul 4648 4657; mul 4657
4969; neg 4970; where 4656 4971; mul 4648 4666; mul 4666 4973; neg 4974; where 4665 4975; mul 4648 4675; mul 4675
4977; neg 4978; where 4674 4979; mul 4648 4684; mul 4684 4981; neg 4982; where 4683 4983; mul 28 4454; neg 4985; mul
557 4454; mul 28 4458; neg 4988; mul 557 4458; mul 29 1205; neg 4991; mul 29 1788; store by_k 79 1207; store by_k
237 1790; store by_k 316 2253; store by_k 395 2504; store by_k 474 2755; store by_k 553 2504; store by_k 632 2755;
store by_k 711 2504; store by_k 790 2755; store by_k 80 2782; store by_k 238 2792; store by_k 317 2832; store by_k
81 2845; store by_k 239 2852; store by_k 318 2859; store by_k 82 2953; store by_k 240 3029; store by_k 319 3066;
store by_k 83 3184; store by_k 241 3273; store by_k 320 3321; store by_k 84 3425; store by_k 242 3508; store by_k
321 3615; store by_k 400 3698; store by_k 479 3781; store by_k 558 3698; store by_k 637 3781; store by_k 716 3698;
store by_k 795 3781; store by_k 85 3839; store by_k 243 3894; store by_k 322 3913; store by_k 86 3922; store by_k
244 3931; store by_k 323 3934; store by_k 402 3937; store by_k 481 3940; store by_k 560 3937; store by_k 639 3940;
store by_k 718 3937; store by_k 797 3940; store by_k 87 3949; store by_k 245 3958; store by_k 324 3961; store by_k
403 3964; store by_k 482 3967; store by_k 561 3964; store by_k 640 3967; store by_k 719 3964; store by_k 798 3967;
store by_k 88 3968; store by_k 246 3969; store by_k 325 3970; store by_k 404 3971; store by_k 483 3972; store by_k
562 3971; store by_k 641 3972; store by_k 720 3971; store by_k 799 3972; store by_k 89 3975; store by_k 247 3978;
store by_k 326 3981; store by_k 405 3984; store by_k 484 3987; store by_k 563 3984; store by_k 642 3987; store by_k
721 3984; store by_k 800 3987; store by_k 90 3988; store by_k 248 3989; store by_k 327 3990; store by_k 406 3991;
store by_k 485 3992; store by_k 564 3991; store by_k 643 3992; store by_k 722 3991; store by_k 801 3992; store by_k
91 3995; store by_k 249 3998; store by_k 328 4001; store by_k 407 4004; store by_k 486 4007; store by_k 565 4004;
store by_k 644 4007; store by_k 723 4004; store by_k 802 4007; store by_k 92 4010; store by_k 250 4013; store by_k
329 4016; store by_k 408 4019; store by_k 487 4022; store by_k 566 4019; store by_k 645 4022; store by_k 724 4019;
store by_k 803 4022; store by_k 93 4023; store by_k 251 4024; store by_k 330 4025; store by_k 409 4026; store by_k
488 4027; store by_k 567 4026; store by_k 646 4027; store by_k 725 4026; store by_k 804 4027; store by_k 94 4113;
store by_k 252 4187; store by_k 331 4256; store by_k 410 4300; store by_k 489 4344; store by_k 568 4300; store by_k
647 4344; store by_k 726 4300; store by_k 805 4344; store by_k 95 4347; store by_k 253 4349; store by_k 96 4358;
store by_k 254 4367; store by_k 97 4373; store by_k 255 4379; store by_k 98 4385; store by_k 256 4391; store by_k 99
4393; store by_k 257 4396; store by_k 100 4517; store by_k 258 4539; store by_k 101 4501; store by_k 259 4527; store
by_k 102 4509; store by_k 260 4540; store by_k 103 4552; store by_k 261 4563; store by_k 104 4575; store by_k 262
4588; store by_k 105 4592; store by_k 263 4596; store by_k 106 4600; store by_k 264 4603; store by_k 343 1817; store
by_k 107 4605; store by_k 265 4606; store by_k 108 28; store by_k 266 4607; store by_k 425 4608; store by_k 504
4609; store by_k 584 4610; store by_k 663 4611; store by_k 743 4612; store by_k 822 4613; store by_k 112 4621; store
by_k 270 4623; store by_k 113 4625; store by_k 271 4626; store by_k 114 4629; store by_k 272 4631; store by_k 115
4638; store by_k 273 4642; store by_k 116 4643; store by_k 274 4645; store by_k 1064 4659; store by_k 1143 4668;
store by_k 1222 4677; store by_k 1301 4686; store by_k 117 4693; store by_k 275 4700; store by_k 354 4707; store
by_k 433 4714; store by_k 591 4714; store by_k 749 4714; store by_k 118 4721; store by_k 276 4728; store by_k 355
4735; store by_k 434 4742; store by_k 592 4742; store by_k 750 4742; store by_k 119 4743; store by_k 277 4744; store
by_k 356 4745; store by_k 435 4746; store by_k 593 4746; store by_k 751 4746; store by_k 120 745; store by_k 278
1380; store by_k 357 1952; store by_k 436 2292; store by_k 594 2292; store by_k 752 2292; store by_k 121 4758; store
by_k 279 4765; store by_k 358 4772; store by_k 437 4777; store by_k 595 4777; store by_k 753 4777; store by_k 122
4778; store by_k 280 4780; store by_k 359 4782; store by_k 123 696; store by_k 281 4783; store by_k 360 4784; store
by_k 124 4785; store by_k 282 4787; store by_k 361 4789; store by_k 125 4792; store by_k 283 4794; store by_k 362
4796; store by_k 126 4798; store by_k 284 4799; store by_k 363 4800; store by_k 127 4802; store by_k 285 4805; store
by_k 364 4808; store by_k 128 4809; store by_k 286 4811; store by_k 365 4813; store by_k 129 4814; store by_k 287
4816; store by_k 366 4818; store by_k 130 4819; store by_k 288 4821; store by_k 367 4823; store by_k 131 4830; store
by_k 289 4837; store by_k 368 4844; store by_k 526 4851; store by_k 684 4851; store by_k 842 4851; store by_k 132
4858; store by_k 290 4865; store by_k 369 4872; store by_k 527 4879; store by_k 685 4879; store by_k 843 4879; store
by_k 133 4040; store by_k 291 4125; store by_k 370 4205; store by_k 528 4312; store by_k 686 4312; store by_k 844
4312; store by_k 134 637; store by_k 292 1294; store by_k 371 1878; store by_k 529 2537; store by_k 687 2537; store
by_k 845 2537; store by_k 135 4891; store by_k 293 4898; store by_k 372 4905; store by_k 530 4910; store by_k 688
4910; store by_k 846 4910; store by_k 136 4911; store by_k 294 4913; store by_k 373 4915; store by_k 137 588; store
by_k 295 4916; store by_k 374 4917; store by_k 138 4918; store by_k 296 4920; store by_k 375 4922; store by_k 139
4925; store by_k 297 4927; store by_k 376 4929; store by_k 140 4931; store by_k 298 4932; store by_k 377 4933; store
by_k 141 4935; store by_k 299 4938; store by_k 378 4941; store by_k 142 4942; store by_k 300 4944; store by_k 379
4946; store by_k 143 4947; store by_k 301 4949; store by_k 380 4951; store by_k 144 4952; store by_k 302 4954; store
by_k 381 4956; store by_k 145 4959; store by_k 303 4962; store by_k 146 4963; store by_k 304 4964; store by_k 147
4965; store by_k 305 4966; store by_k 148 4967; store by_k 306 4968; store by_k 1097 4972; store by_k 1177 4976;
store by_k 1257 4980; store by_k 1337 4984; store by_k 153 4986; store by_k 311 4987; store by_k 154 4989; store
by_k 312 4990; store by_k 945 4454; store by_k 1025 4458; store by_k 157 4992; store by_k 315 4993
    """,
)
