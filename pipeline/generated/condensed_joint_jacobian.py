"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations.condensed_joint`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 73},
    {'p': 197},
    """
input k 72; input k 0; constant 1.0; div 2 1; mul 0 3; constant -2.0; input k 2; mul 5 6; input k 33; input k 34;
input k 1; constant -6.000000000000002; constant -18.000000000000004; input k 6; mul 13 13; input k 4; mul 14 15;
mul 12 16; add 11 17; constant -0.09999999999999995; input k 3; mul 14 20; mul 19 21; add 18 22; input k 7; input k
8; constant 28.79999999999999; mul 13 15; mul 26 27; constant -22.62857142857143; mul 15 29; constant
-0.057142857142856635; mul 20 31; add 30 32; constant 36.0; mul 27 34; constant -28.799999999999976; mul 15 36;
constant 0.05714285714285722; mul 20 38; add 37 39; constant -50.400000000000006; mul 15 41; constant
-1.1428571428571423; mul 20 43; add 42 44; constant 12.000000000000004; constant 36.000000000000014; mul 16 47; add
46 48; constant 1.2; mul 21 50; add 49 51; constant -57.60000000000001; mul 27 53; constant 45.25714285714287; mul
15 55; constant 0.9142857142857138; mul 20 57; add 56 58; constant -72.00000000000001; mul 27 60; constant
57.599999999999916; mul 15 62; constant -1.7142857142857166; mul 20 64; add 63 65; constant 230.40000000000006; mul
15 67; constant 2.057142857142858; mul 20 69; add 68 70; constant -388.80000000000024; mul 15 72; constant
-7.714285714285722; mul 20 74; add 73 75; constant 259.2000000000001; mul 15 77; constant 12.34285714285715; mul 20
79; add 78 80; constant -0.9999999999999998; mul 13 82; mul 13 14; mul 15 84; mul 82 85; add 83 86; constant
-0.033333333333333326; mul 21 88; constant -2.3999999999999995; mul 27 90; constant 0.4571428571428564; mul 15 92;
constant -0.019047619047619094; mul 20 94; add 93 95; constant 4.000000000000001; constant 12.0; mul 16 98; add 97
99; constant 0.13333333333333333; mul 21 101; add 100 102; constant -14.399999999999991; mul 27 104; constant
13.714285714285717; mul 15 106; constant 0.11428571428571413; mul 20 108; add 107 109; constant -30.000000000000007;
mul 27 111; mul 13 20; sub 112 113; constant 21.59999999999998; mul 15 115; constant 0.6571428571428567; mul 20 117;
add 116 118; constant 35.20000000000001; mul 15 120; constant 2.438095238095238; mul 20 122; add 121 123; constant
72.0; mul 27 125; constant -57.59999999999995; mul 15 127; constant 0.11428571428571443; mul 20 129; add 128 130;
constant -151.20000000000002; mul 15 132; constant -3.428571428571427; mul 20 134; add 133 135; constant
-36.00000000000001; mul 27 137; constant 28.799999999999958; mul 15 139; constant -0.8571428571428583; mul 20 141;
add 140 142; constant -129.60000000000008; mul 15 144; constant -2.5714285714285743; mul 20 146; add 145 147; input
k 19; constant 2.0; input k 18; input k 17; input k 16; input k 27; input k 41; input k 36; input k 15; sub 157 2;
input k 38; input k 37; input k 39; sub 161 1; constant 8.118473726939319e-05; input k 5; mul 163 164; constant
-0.0004787100025195255; mul 164 166; constant 0.0013605442176870743; mul 164 168; constant -0.003571428571428574;
mul 164 170; constant 0.007142857142857142; mul 164 172; constant -0.0006802721088435403; mul 164 174; constant
0.0035714285714285787; mul 164 176; constant 0.014965986394557814; mul 164 178; constant -0.04285714285714284; mul
164 180; constant 0.06428571428571427; mul 164 182; constant -0.12857142857142845; mul 164 184; constant
0.2571428571428571; mul 164 186; input k 9; input k 10; input k 12; input k 11; input k 13; input k 14; input k 40;
div 2 194; input k 42; input k 43; input k 44; input k 45; input k 46; input k 47; input k 48; constant
0.029931972789115628; mul 164 203; constant -0.08571428571428567; mul 164 205; constant 0.12857142857142853; mul 164
207; constant -0.38571428571428534; mul 164 209; constant 1.0285714285714285; mul 164 211; constant
0.0027210884353741486; mul 164 213; constant -0.010714285714285721; mul 164 215; constant 0.028571428571428567; mul
164 217; constant 0.010714285714285735; mul 164 219; input k 54; input k 50; input k 49; input k 51; input k 52; sub
225 1; input k 53; div 2 227; input k 55; input k 56; input k 57; input k 58; input k 59; input k 60; input k 61;
constant -6.0; constant 4.0; input k 29; input k 62; input k 63; input k 64; input k 68; input k 69; input k 24;
input k 25; input k 21; mul 150 245; input k 26; input k 23; input k 22; input k 20; input k 28; mul 154 252; input
k 35; constant 0.8000000000000002; constant 2.400000000000001; mul 16 256; add 255 257; constant
0.01904761904761903; mul 21 259; add 258 260; constant -1.3714285714285723; mul 27 262; constant 1.3714285714285714;
mul 15 264; constant 0.007256235827664418; mul 20 266; add 265 267; constant -4.799999999999999; mul 27 269;
constant 1.3714285714285692; mul 15 271; constant -0.05714285714285729; mul 20 273; add 272 274; constant
-7.199999999999996; mul 27 276; constant 7.199999999999994; mul 15 278; constant 0.2190476190476189; mul 20 280; add
279 281; constant -45.25714285714286; mul 15 283; constant -0.11428571428571327; mul 20 285; add 284 286; constant
-28.800000000000004; mul 27 288; constant 0.00032473894907757275; mul 164 290; constant -0.0014361300075585765; mul
164 292; constant -0.0013605442176870806; mul 164 294; constant 0.8; mul 6 296; div 2 297; input k 30; input k 31;
input k 32; input k 70; input k 71; input k 65; div 2 304; input k 66; div 2 306; input k 67; div 2 308; mul 3 24;
mul 23 310; mul 3 52; mul 103 310; mul 3 23; mul 19 310; mul 3 50; mul 101 310; mul 3 19; mul 3 188; mul 3 189; mul
3 190; add 242 243; mul 245 246; mul 244 246; mul 89 310; mul 88 310; mul 3 98; mul 236 310; add 327 328; mul 6 329;
mul 3 236; mul 237 310; add 331 332; mul 6 333; mul 24 334; add 330 335; mul 25 334; mul 23 25; mul 25 103; mul 19
25; mul 25 101; mul 246 248; mul 25 89; mul 25 88; mul 25 236; mul 6 345; mul 25 237; mul 6 347; mul 24 348; add 346
349; mul 25 348; mul 254 305; mul 254 307; mul 254 309; neg 299; neg 300; neg 301; neg 302; neg 303; mul 239 254;
mul 240 254; mul 241 254; mul 3 4; mul 10 298; mul 143 364; mul 59 364; mul 289 364; mul 40 364; mul 287 364; mul 28
364; mul 282 364; mul 110 364; mul 277 364; mul 275 364; mul 270 364; mul 89 364; mul 13 150; store p 0 4; store p 1
7; store p 2 8; store p 3 9; store p 4 3; store p 5 10; store p 6 23; store p 7 24; store p 8 25; store p 9 28;
store p 10 33; store p 11 35; store p 12 40; store p 13 45; store p 14 52; store p 15 54; store p 16 59; store p 17
61; store p 18 66; store p 19 71; store p 20 76; store p 21 81; store p 22 87; store p 23 89; store p 24 91; store p
25 96; store p 26 103; store p 27 105; store p 28 110; store p 29 114; store p 30 119; store p 31 124; store p 32
126; store p 33 131; store p 34 136; store p 35 138; store p 36 143; store p 37 148; store p 38 149; store p 39 151;
store p 40 152; store p 41 153; store p 42 1; store p 43 188; store p 44 189; store p 45 190; store p 46 175; store
p 47 177; store p 48 204; store p 49 206; store p 50 208; store p 51 210; store p 52 212; store p 53 167; store p 54
214; store p 55 216; store p 56 218; store p 57 220; store p 58 181; store p 59 185; store p 60 154; store p 61 162;
store p 62 165; store p 63 169; store p 64 171; store p 65 173; store p 66 179; store p 67 183; store p 68 187;
store p 69 191; store p 70 192; store p 71 193; store p 72 158; store p 73 157; store p 74 160; store p 75 156;
store p 76 195; store p 77 159; store p 78 155; store p 79 196; store p 80 197; store p 81 198; store p 82 199;
store p 83 200; store p 84 201; store p 85 202; store p 86 226; store p 87 222; store p 88 223; store p 89 228;
store p 90 224; store p 91 221; store p 92 229; store p 93 230; store p 94 231; store p 95 232; store p 96 233;
store p 97 234; store p 98 235; store p 99 6; store p 100 238; store p 101 239; store p 102 240; store p 103 241;
store p 104 242; store p 105 243; store p 106 244; store p 107 245; store p 108 246; store p 109 247; store p 110
248; store p 111 249; store p 112 250; store p 113 251; store p 114 253; store p 115 254; store p 116 261; store p
117 263; store p 118 268; store p 119 270; store p 120 275; store p 121 277; store p 122 282; store p 123 287; store
p 124 289; store p 125 291; store p 126 293; store p 127 295; store p 128 298; store p 129 299; store p 130 300;
store p 131 301; store p 132 302; store p 133 303; store p 134 305; store p 135 307; store p 136 309; store p 137
311; store p 138 310; store p 139 312; store p 140 313; store p 141 314; store p 142 315; store p 143 316; store p
144 317; store p 145 318; store p 146 319; store p 147 320; store p 148 321; store p 149 322; store p 150 323; store
p 151 324; store p 152 325; store p 153 326; store p 154 336; store p 155 337; store p 156 338; store p 157 339;
store p 158 340; store p 159 341; store p 160 342; store p 161 343; store p 162 344; store p 163 350; store p 164
351; store p 165 352; store p 166 353; store p 167 354; store p 168 355; store p 169 356; store p 170 357; store p
171 358; store p 172 359; store p 173 360; store p 174 361; store p 175 362; store p 176 363; store p 177 365; store
p 178 366; store p 179 367; store p 180 368; store p 181 369; store p 182 370; store p 183 371; store p 184 372;
store p 185 373; store p 186 374; store p 187 375; store p 188 376; store p 189 14; store p 190 13; store p 191 364;
store p 192 84; store p 193 15; store p 194 377; store p 195 20; store p 196 252
    """,
)

JACOBIAN = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 3, 'c_q': 13, 'p': 197},
    {'f': 16, 'a': 256, 'b': 32, 'by_c': 208},
    """
input x 1; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
input p 0; input x 0; mul 11 12; sub 10 13; input c 9; constant 0.5; input c 10; mul 16 17; mul 14 18; sub 15 19;
input c 11; mul 3 21; add 20 22; input c 12; mul 7 24; add 23 25; mul 14 26; add 9 27; input c 4; input c 5; mul 14
30; sub 29 31; input c 6; mul 3 33; add 32 34; input c 7; mul 7 36; add 35 37; input c 8; input p 1; max 39 40;
input x 3; mul 0 11; sub 42 43; mul 41 44; sub 38 45; mul 11 46; sub 28 47; input p 2; input c 1; add 49 50;
constant 0.0; max 51 52; input p 3; abs 0; mul 54 55; add 53 56; mul 0 57; sub 48 58; input p 4; input p 5; input p
6; input p 7; mul 12 60; mul 63 64; input p 8; mul 10 66; add 65 67; mul 62 68; input p 9; input x 4; mul 68 71; mul
70 72; add 69 73; input p 10; mul 71 72; mul 75 76; add 74 77; input p 11; mul 68 68; mul 79 80; add 78 81; input p
12; mul 71 80; mul 83 84; add 82 85; input p 13; mul 68 80; mul 87 88; add 86 89; input p 14; mul 64 91; add 90 92;
input p 15; mul 64 71; mul 94 95; add 93 96; input p 16; mul 71 95; mul 98 99; add 97 100; input p 17; mul 64 68;
mul 102 103; add 101 104; input p 18; mul 71 103; mul 106 107; add 105 108; input p 19; mul 68 103; mul 110 111; add
109 112; input p 20; mul 64 64; mul 68 115; mul 114 116; add 113 117; input p 21; mul 64 115; mul 119 120; add 118
121; input p 22; input p 23; mul 71 124; add 123 125; input p 24; mul 71 71; mul 127 128; add 126 129; input p 25;
mul 71 128; mul 131 132; add 130 133; input p 26; mul 68 135; add 134 136; input p 27; mul 72 138; add 137 139;
input p 28; mul 76 141; add 140 142; input p 29; mul 80 144; add 143 145; input p 30; mul 84 147; add 146 148; input
p 31; mul 88 150; add 149 151; mul 62 64; add 152 153; mul 70 95; add 154 155; mul 75 99; add 156 157; input p 32;
mul 103 159; add 158 160; input p 33; mul 107 162; add 161 163; input p 34; mul 111 165; add 164 166; input p 35;
mul 115 168; add 167 169; input p 36; mul 71 115; mul 171 172; add 170 173; mul 110 116; add 174 175; input p 37;
mul 120 177; add 176 178; mul 63 179; add 122 180; mul 61 181; abs 64; constant 0.35; lt 183 184; input p 38;
constant 0.6; constant -0.6; max 188 10; min 187 189; mul 190 190; mul 190 191; mul 186 192; constant -0.35; max 194
64; min 184 195; constant 2.0; mul 196 197; input p 39; mul 191 199; mul 198 200; add 193 201; mul 196 196; input p
40; mul 190 204; mul 203 205; add 202 206; mul 196 205; mul 198 208; add 207 209; mul 197 203; input p 41; mul 211
212; mul 198 213; add 210 214; mul 61 215; where 185 216; add 182 217; input p 42; input p 43; mul 64 220; input p
44; mul 10 222; add 221 223; input p 45; mul 71 225; add 224 226; constant -0.09999999999999995; mul 68 228; input p
46; mul 76 230; add 229 231; input p 47; mul 88 233; add 232 234; constant 1.2; mul 64 236; add 235 237; input p 48;
mul 99 239; add 238 240; input p 49; mul 107 242; add 241 243; input p 50; mul 111 245; add 244 246; input p 51; mul
116 248; add 247 249; input p 52; mul 120 251; add 250 252; constant -0.033333333333333326; mul 71 254; input p 53;
mul 132 256; add 255 257; constant 0.13333333333333333; mul 68 259; add 258 260; input p 54; mul 76 262; add 261
263; input p 55; mul 84 265; add 264 266; input p 56; mul 88 268; add 267 269; mul 64 228; add 270 271; mul 99 230;
add 272 273; input p 57; mul 111 275; add 274 276; input p 58; mul 172 278; add 277 279; mul 116 245; add 280 281;
input p 59; mul 120 283; add 282 284; mul 63 285; add 253 286; add 227 287; mul 219 288; input p 60; input p 61;
constant 0.009523809523809514; mul 128 292; input p 62; mul 71 132; mul 294 295; add 293 296; mul 72 254; add 297
298; mul 71 76; mul 256 300; add 299 301; constant 0.06666666666666667; mul 80 303; add 302 304; input p 63; mul 71
84; mul 306 307; add 305 308; input p 64; mul 71 88; mul 310 311; add 309 312; input p 65; mul 68 88; mul 314 315;
add 313 316; mul 103 228; add 317 318; mul 71 107; mul 230 320; add 319 321; mul 68 111; mul 233 323; add 322 324;
mul 115 187; add 325 326; input p 66; mul 71 172; mul 328 329; add 327 330; mul 71 116; mul 278 332; add 331 333;
input p 67; mul 68 116; mul 335 336; add 334 337; mul 68 120; mul 283 339; add 338 340; input p 68; mul 64 120; mul
342 343; add 341 344; mul 64 227; mul 64 222; input p 69; mul 10 348; add 347 349; input p 70; mul 71 351; add 350
352; mul 10 353; add 346 354; mul 64 225; mul 10 351; add 356 357; input p 71; mul 71 359; add 358 360; mul 71 361;
add 355 362; mul 16 363; add 345 364; mul 219 365; add 291 366; constant 1.0; input p 72; mul 10 369; mul 10 370;
add 368 371; input p 73; mul 10 373; mul 10 374; add 368 375; sqrt 376; sqrt 372; mul 377 378; div 368 379; mul 372
380; input p 74; mul 381 382; add 367 383; input p 75; mul 10 378; mul 380 386; mul 385 387; sub 384 388; input p
76; mul 381 385; input p 77; sub 391 392; mul 382 387; add 393 394; sub 395 12; mul 396 396; mul 389 389; add 397
398; sqrt 399; mul 390 400; sqrt 401; div 368 402; mul 403 403; mul 390 404; mul 389 405; input p 78; mul 197 401;
mul 197 404; mul 404 409; sub 408 410; mul 407 411; input p 79; constant 1.4; sub 401 414; mul 413 415; add 368 416;
mul 412 417; input p 80; mul 3 419; input p 81; mul 415 421; add 368 422; mul 420 423; sub 418 424; mul 390 425;
input p 82; input x 5; mul 427 428; input p 83; input x 7; mul 430 431; add 429 432; input p 84; input x 9; mul 434
435; add 433 436; constant -0.5; mul 403 438; mul 403 439; mul 403 440; mul 390 441; mul 437 442; add 426 443; input
p 85; mul 442 445; mul 442 446; sub 383 388; mul 396 448; add 391 394; mul 389 450; sub 449 451; mul 405 452; div
368 377; mul 380 454; mul 453 455; mul 42 456; mul 396 405; mul 0 458; sub 457 459; mul 0 60; mul 289 461; mul 66
285; add 353 463; mul 219 464; mul 42 465; add 462 466; mul 406 467; add 460 468; mul 447 469; add 444 470; mul 406
471; input p 86; add 366 473; input p 87; mul 381 475; add 474 476; input p 88; mul 387 478; add 477 479; input p
89; mul 387 475; mul 381 478; input p 90; sub 483 484; sub 482 485; sub 486 12; mul 487 487; mul 480 480; add 488
489; sqrt 490; mul 481 491; sqrt 492; div 368 493; mul 494 494; mul 481 495; mul 480 496; input p 91; mul 197 492;
mul 197 495; mul 495 500; sub 499 501; mul 498 502; input p 92; sub 492 414; mul 504 505; add 368 506; mul 503 507;
input p 93; mul 7 509; input p 94; mul 505 511; add 368 512; mul 510 513; sub 508 514; mul 481 515; input p 95;
input x 6; mul 517 518; input p 96; input x 8; mul 520 521; add 519 522; input p 97; input x 10; mul 524 525; add
523 526; mul 438 494; mul 494 528; mul 494 529; mul 481 530; mul 527 531; add 516 532; input p 98; mul 531 534; mul
531 535; add 476 479; mul 487 537; sub 483 482; mul 480 539; add 538 540; mul 496 541; mul 455 542; mul 42 543; mul
487 496; mul 0 545; sub 544 546; mul 467 497; add 547 548; mul 536 549; add 533 550; mul 497 551; add 472 552; sub
290 553; mul 289 554; sub 218 555; input p 99; constant 12.0; mul 461 558; constant -6.0; mul 63 461; mul 42 66; add
561 562; mul 560 563; add 559 564; mul 557 565; mul 461 560; constant 4.0; mul 563 568; add 567 569; mul 557 570;
mul 63 571; add 566 572; add 556 573; mul 60 574; mul 458 471; mul 545 551; add 576 577; sub 575 578; sub 59 579;
input p 100; input p 101; input z 0; mul 582 583; input p 102; input z 1; mul 585 586; add 584 587; input p 103;
input z 2; mul 589 590; add 588 591; sub 581 592; add 580 593; input p 104; input x 11; sub 12 596; mul 595 597;
input p 105; input x 12; sub 12 600; mul 599 601; add 598 602; sub 594 603; input p 106; mul 12 605; input p 107;
mul 10 607; add 606 608; input p 108; mul 0 605; input p 109; mul 42 612; add 611 613; mul 0 614; input p 110; mul
42 616; mul 42 617; add 615 618; mul 610 619; mul 609 620; sub 604 621; input p 111; mul 12 607; mul 10 616; add 624
625; mul 610 626; mul 626 627; add 623 628; mul 622 629; input p 112; mul 609 610; mul 626 632; add 631 633; mul 66
179; mul 61 635; abs 10; lt 637 187; mul 190 197; mul 191 197; input p 113; mul 640 641; mul 639 642; mul 186 196;
mul 191 644; add 643 645; mul 190 644; mul 639 647; add 646 648; mul 199 203; mul 639 650; add 649 651; mul 196 203;
mul 204 653; add 652 654; mul 61 655; where 638 656; add 636 657; mul 465 554; sub 658 659; mul 66 571; add 660 661;
mul 456 471; mul 543 551; add 663 664; add 662 665; sub 46 666; input p 114; mul 387 668; mul 455 669; add 667 670;
input p 115; mul 592 672; sub 671 673; mul 620 626; sub 674 675; mul 634 676; sub 630 677; mul 609 609; add 368 679;
mul 610 680; mul 629 681; mul 634 634; sub 682 683; div 368 684; mul 678 685; mul 676 681; mul 622 634; sub 687 688;
mul 685 689; input p 116; mul 71 691; input p 117; mul 128 693; add 692 694; input p 118; mul 132 696; add 695 697;
mul 68 124; add 698 699; input p 119; mul 72 701; add 700 702; input p 120; mul 76 704; add 703 705; input p 121;
mul 80 707; add 706 708; mul 84 141; add 709 710; input p 122; mul 88 712; add 711 713; mul 70 103; add 714 715;
input p 123; mul 107 717; add 716 718; mul 83 111; add 719 720; input p 124; mul 115 722; add 721 723; mul 98 172;
add 724 725; mul 116 171; add 726 727; mul 61 728; constant 0.01904761904761903; mul 71 730; input p 125; mul 132
732; add 731 733; mul 68 254; add 734 735; input p 126; mul 76 737; add 736 738; mul 84 262; add 739 740; mul 88
310; add 741 742; input p 127; mul 107 744; add 743 745; mul 172 239; add 746 747; mul 116 278; add 748 749; add 361
750; mul 219 751; mul 554 752; sub 729 753; input p 128; mul 754 755; neg 756; mul 442 469; input p 129; mul 428
759; sub 758 760; mul 531 549; mul 518 759; sub 762 763; input p 130; mul 431 765; sub 758 766; mul 521 765; sub 762
768; input p 131; mul 435 770; sub 758 771; mul 525 770; sub 762 773; input p 132; mul 597 775; input p 133; mul 601
777; le 368 583; mul 42 672; add 0 780; lt 52 781; and 779 782; constant -1.0; le 583 784; lt 781 52; and 785 786;
or 783 787; not 788; input p 134; mul 781 790; where 789 791; le 368 586; and 782 793; le 586 784; and 786 795; or
794 796; not 797; input p 135; mul 781 799; where 798 800; le 368 590; and 782 802; le 590 784; and 786 804; or 803
805; not 806; input p 136; mul 781 808; where 807 809; mul 11 18; mul 14 811; mul 11 26; sub 812 813; mul 11 30; mul
11 815; sub 814 816; input p 137; input p 138; mul 71 819; mul 70 820; add 818 821; mul 71 820; mul 75 823; add 822
824; mul 68 197; mul 819 826; mul 79 827; add 825 828; mul 71 827; mul 83 830; add 829 831; mul 68 827; mul 80 819;
add 833 834; mul 87 835; add 832 836; input p 139; add 837 838; mul 60 71; mul 94 840; add 839 841; mul 71 840; mul
98 843; add 842 844; mul 60 68; mul 64 819; add 846 847; mul 102 848; add 845 849; mul 71 848; mul 106 851; add 850
852; mul 68 848; mul 103 819; add 854 855; mul 110 856; add 853 857; mul 64 197; mul 60 859; mul 68 860; mul 115
819; add 861 862; mul 114 863; add 858 864; mul 64 860; mul 60 115; add 866 867; mul 119 868; add 865 869; input p
140; mul 138 820; add 871 872; mul 141 823; add 873 874; mul 144 827; add 875 876; mul 147 830; add 877 878; mul 150
835; add 879 880; input p 141; add 881 882; mul 70 840; add 883 884; mul 75 843; add 885 886; mul 159 848; add 887
888; mul 162 851; add 889 890; mul 165 856; add 891 892; mul 168 860; add 893 894; mul 71 860; mul 171 896; add 895
897; mul 110 863; add 898 899; mul 177 868; add 900 901; mul 63 902; add 870 903; mul 61 904; le 195 184; le 184
195; add 906 907; div 368 908; mul 906 909; le 194 64; le 64 194; add 911 912; div 368 913; mul 911 914; mul 60 915;
mul 910 916; mul 197 917; mul 200 918; mul 198 917; mul 205 920; add 919 921; mul 208 918; mul 205 917; mul 198 924;
add 923 925; add 922 926; mul 213 918; mul 197 920; mul 212 929; mul 198 930; add 928 931; add 927 932; mul 61 933;
where 185 934; add 905 935; input p 142; mul 230 823; add 937 938; mul 233 835; add 939 940; input p 143; add 941
942; mul 239 843; add 943 944; mul 242 851; add 945 946; mul 245 856; add 947 948; mul 248 863; add 949 950; mul 251
868; add 951 952; input p 144; mul 262 823; add 954 955; mul 265 830; add 956 957; mul 268 835; add 958 959; input p
145; add 960 961; mul 230 843; add 962 963; mul 275 856; add 964 965; mul 278 896; add 966 967; mul 245 863; add 968
969; mul 283 868; add 970 971; mul 63 972; add 953 973; input p 146; add 974 975; mul 219 976; mul 554 977; mul 197
389; mul 254 820; mul 71 823; mul 256 981; add 980 982; mul 303 827; add 983 984; mul 71 830; mul 306 986; add 985
987; mul 71 835; mul 310 989; add 988 990; mul 68 835; mul 88 819; add 992 993; mul 314 994; add 991 995; mul 228
848; add 996 997; mul 71 851; mul 230 999; add 998 1000; mul 68 856; mul 111 819; add 1002 1003; mul 233 1004; add
1001 1005; mul 187 860; add 1006 1007; mul 71 896; mul 328 1009; add 1008 1010; mul 71 863; mul 278 1012; add 1011
1013; mul 68 863; mul 116 819; add 1015 1016; mul 335 1017; add 1014 1018; mul 68 868; mul 120 819; add 1020 1021;
mul 283 1022; add 1019 1023; mul 64 868; mul 60 120; add 1025 1026; mul 342 1027; add 1024 1028; mul 64 975; mul 60
227; add 1030 1031; input p 147; mul 10 1033; add 1032 1034; input p 148; mul 71 1036; add 1035 1037; mul 16 1038;
add 1029 1039; mul 219 1040; mul 979 1041; mul 197 396; sub 1042 1043; mul 197 400; div 368 1045; mul 1044 1046; mul
390 1047; mul 197 1048; mul 197 403; mul 197 402; div 368 1051; mul 1048 1052; mul 404 1053; mul 1050 1054; neg
1055; mul 197 1056; mul 404 1057; mul 409 1055; sub 1058 1059; sub 1049 1060; mul 407 1061; mul 417 1062; mul 413
1048; mul 412 1064; add 1063 1065; mul 421 1048; mul 420 1067; sub 1066 1068; mul 390 1069; mul 440 1053; mul 403
1071; mul 441 1053; add 1072 1073; mul 403 1074; mul 403 441; mul 1053 1076; add 1075 1077; mul 390 1078; mul 437
1079; sub 1070 1080; mul 390 1055; mul 396 1082; add 405 1083; mul 0 1084; mul 450 1041; add 448 1086; mul 405 1087;
mul 452 1082; add 1088 1089; mul 455 1090; mul 42 1091; sub 1085 1092; mul 405 1041; mul 389 1082; sub 1094 1095;
mul 467 1096; mul 461 977; mul 66 972; add 1033 1099; mul 219 1100; mul 42 1101; add 1098 1102; mul 406 1103; add
1097 1104; add 1093 1105; mul 447 1106; mul 445 1079; mul 442 1108; mul 446 1079; add 1109 1110; mul 469 1111; sub
1107 1112; add 1081 1113; mul 406 1114; mul 471 1096; add 1115 1116; mul 197 480; mul 1041 1118; mul 197 487; sub
1119 1120; mul 197 491; div 368 1122; mul 1121 1123; mul 481 1124; mul 197 1125; mul 197 494; mul 197 493; div 368
1128; mul 1125 1129; mul 495 1130; mul 1127 1131; neg 1132; mul 197 1133; mul 495 1134; mul 500 1132; sub 1135 1136;
sub 1126 1137; mul 498 1138; mul 507 1139; mul 504 1125; mul 503 1141; add 1140 1142; mul 511 1125; mul 510 1144;
sub 1143 1145; mul 481 1146; mul 529 1130; mul 494 1148; mul 530 1130; add 1149 1150; mul 494 1151; mul 494 530; mul
1130 1153; add 1152 1154; mul 481 1155; mul 527 1156; sub 1147 1157; mul 539 1041; sub 1159 537; mul 496 1160; mul
481 1132; mul 541 1162; sub 1161 1163; mul 455 1164; mul 42 1165; mul 487 1162; add 496 1167; mul 0 1168; add 1166
1169; mul 496 1041; mul 480 1162; sub 1171 1172; mul 467 1173; mul 497 1103; add 1174 1175; add 1170 1176; mul 536
1177; mul 534 1156; mul 531 1179; mul 535 1156; add 1180 1181; mul 549 1182; sub 1178 1183; add 1158 1184; mul 497
1185; mul 551 1173; add 1186 1187; add 1117 1188; mul 289 1189; sub 978 1190; sub 936 1191; mul 60 1192; mul 458
1114; mul 471 1084; sub 1194 1195; mul 545 1185; mul 551 1168; sub 1197 1198; add 1196 1199; sub 1193 1200; sub 817
1201; input p 149; sub 1202 1203; mul 605 620; sub 1204 1205; mul 629 1206; input p 150; mul 626 1208; mul 607 627;
add 1209 1210; mul 622 1211; add 1207 1212; input p 151; mul 626 1214; mul 607 632; add 1215 1216; mul 676 1217; mul
66 902; mul 61 1219; mul 186 917; mul 191 1221; mul 190 1221; mul 639 1223; add 1222 1224; mul 199 920; mul 639
1226; add 1225 1227; mul 203 917; mul 196 920; add 1229 1230; mul 204 1231; add 1228 1232; mul 61 1233; where 638
1234; add 1220 1235; mul 554 1101; mul 465 1189; sub 1237 1238; sub 1236 1239; mul 456 1114; mul 471 1091; sub 1241
1242; mul 543 1185; mul 551 1165; add 1244 1245; add 1243 1246; add 1240 1247; sub 815 1248; mul 607 620; sub 1249
1250; mul 634 1251; add 1218 1252; sub 1213 1253; mul 685 1254; mul 685 686; mul 197 609; mul 605 1257; mul 610
1258; mul 629 1259; mul 681 1211; add 1260 1261; mul 197 634; mul 1217 1263; sub 1262 1264; mul 1256 1265; sub 1255
1266; mul 629 685; input c_q 0; mul 1268 1269; le 52 51; le 51 52; add 1271 1272; div 368 1273; mul 1271 1274; mul 0
1268; mul 1275 1276; input c_q 1; mul 1277 1278; sub 1270 1279; mul 3 1268; input c_q 2; mul 1281 1282; add 1280
1283; mul 7 1268; input c_q 3; mul 1285 1286; add 1284 1287; mul 634 685; mul 11 1268; add 1289 1290; input c_q 4;
mul 1291 1292; sub 1288 1293; mul 14 1291; input c_q 5; mul 1295 1296; add 1294 1297; mul 3 1291; input c_q 6; mul
1299 1300; sub 1298 1301; mul 7 1291; input c_q 7; mul 1303 1304; sub 1302 1305; le 40 39; le 39 40; add 1307 1308;
div 368 1309; mul 1307 1310; mul 44 1291; mul 1311 1312; input c_q 8; mul 1313 1314; add 1306 1315; mul 14 1268;
input c_q 9; mul 1317 1318; add 1316 1319; mul 14 1317; mul 16 1321; input c_q 10; mul 1322 1323; sub 1320 1324; mul
3 1317; input c_q 11; mul 1326 1327; add 1325 1328; mul 7 1317; input c_q 12; mul 1330 1331; add 1329 1332; add 1267
1333; mul 681 1251; mul 676 1259; add 1335 1336; mul 622 1217; mul 634 1206; add 1338 1339; sub 1337 1340; mul 685
1341; mul 685 690; mul 1265 1343; sub 1342 1344; mul 0 1289; mul 1275 1346; mul 1278 1347; mul 1269 1289; sub 1348
1349; mul 3 1289; mul 1282 1351; sub 1350 1352; mul 7 1289; mul 1286 1354; sub 1353 1355; mul 681 685; mul 11 1289;
add 1357 1358; mul 1292 1359; add 1356 1360; mul 14 1359; mul 1296 1362; sub 1361 1363; mul 3 1359; mul 1300 1365;
add 1364 1366; mul 7 1359; mul 1304 1368; add 1367 1369; mul 44 1359; mul 1311 1371; mul 1314 1372; sub 1370 1373;
mul 14 1289; mul 1318 1375; sub 1374 1376; mul 14 1375; mul 16 1378; mul 1323 1379; add 1377 1380; mul 3 1375; mul
1327 1382; sub 1381 1383; mul 7 1375; mul 1331 1385; sub 1384 1386; add 1345 1387; input p 152; mul 701 820; add
1389 1390; mul 704 823; add 1391 1392; mul 707 827; add 1393 1394; mul 141 830; add 1395 1396; mul 712 835; add 1397
1398; mul 70 848; add 1399 1400; mul 717 851; add 1401 1402; mul 83 856; add 1403 1404; mul 722 860; add 1405 1406;
mul 98 896; add 1407 1408; mul 171 863; add 1409 1410; mul 61 1411; input p 153; mul 737 823; add 1413 1414; mul 262
830; add 1415 1416; mul 310 835; add 1417 1418; mul 744 851; add 1419 1420; mul 239 896; add 1421 1422; mul 278 863;
add 1423 1424; add 1036 1425; mul 219 1426; mul 554 1427; mul 752 1189; sub 1428 1429; sub 1412 1430; mul 755 1431;
neg 1432; mul 442 1106; mul 469 1079; sub 1434 1435; mul 531 1177; mul 549 1156; sub 1437 1438; mul 11 41; mul 11
1440; sign 0; mul 54 1442; mul 0 1443; add 57 1444; add 1441 1445; mul 288 406; sub 1447 458; mul 447 1448; mul 406
1449; mul 288 497; sub 1451 545; mul 536 1452; mul 497 1453; add 1450 1454; mul 289 1455; input p 154; add 1456
1457; mul 60 1458; mul 458 1449; mul 545 1453; add 1460 1461; sub 1459 1462; add 1446 1463; add 611 614; mul 610
1465; mul 609 1466; add 1464 1467; mul 629 1468; mul 465 1455; input p 155; add 1470 1471; mul 456 1449; mul 543
1453; add 1473 1474; add 1472 1475; sub 1440 1476; mul 626 1466; sub 1477 1478; mul 634 1479; add 1469 1480; mul 685
1481; neg 1482; mul 681 1479; mul 634 1468; add 1484 1485; mul 685 1486; mul 752 1455; mul 755 1488; neg 1489; mul
442 1448; mul 531 1452; where 789 790; where 798 799; where 807 808; sub 26 19; add 815 1496; input p 156; mul 66
71; mul 70 1499; add 1498 1500; mul 71 1499; mul 75 1502; add 1501 1503; mul 66 826; mul 79 1505; add 1504 1506; mul
71 1505; mul 83 1508; add 1507 1509; mul 68 1505; mul 66 80; add 1511 1512; mul 87 1513; add 1510 1514; mul 64 66;
mul 102 1516; add 1515 1517; mul 71 1516; mul 106 1519; add 1518 1520; mul 68 1516; mul 66 103; add 1522 1523; mul
110 1524; add 1521 1525; mul 66 115; mul 114 1527; add 1526 1528; input p 157; mul 138 1499; add 1530 1531; mul 141
1502; add 1532 1533; mul 144 1505; add 1534 1535; mul 147 1508; add 1536 1537; mul 150 1513; add 1538 1539; mul 159
1516; add 1540 1541; mul 162 1519; add 1542 1543; mul 165 1524; add 1544 1545; mul 110 1527; add 1546 1547; mul 63
1548; add 1529 1549; mul 61 1550; le 189 187; le 187 189; add 1552 1553; div 368 1554; mul 1552 1555; le 188 10; le
10 188; add 1557 1558; div 368 1559; mul 1557 1560; mul 1556 1561; mul 191 1562; mul 639 1562; mul 190 1564; add
1563 1565; mul 186 1566; mul 199 1564; mul 198 1568; add 1567 1569; mul 204 1562; mul 203 1571; add 1570 1572; mul
196 1571; mul 198 1574; add 1573 1575; mul 61 1576; where 185 1577; add 1551 1578; input p 158; mul 230 1502; add
1580 1581; mul 233 1513; add 1582 1583; mul 242 1519; add 1584 1585; mul 245 1524; add 1586 1587; mul 248 1527; add
1588 1589; input p 159; mul 262 1502; add 1591 1592; mul 265 1508; add 1593 1594; mul 268 1513; add 1595 1596; mul
275 1524; add 1597 1598; mul 245 1527; add 1599 1600; mul 63 1601; add 1590 1602; add 222 1603; mul 219 1604; mul
554 1605; mul 197 370; mul 380 1607; mul 380 381; mul 374 454; mul 378 1610; div 368 378; mul 370 1612; mul 377
1613; add 1611 1614; mul 1609 1615; sub 1608 1616; mul 385 1617; mul 10 1613; add 378 1619; mul 380 1620; mul 380
387; mul 1615 1622; sub 1621 1623; mul 382 1624; add 1618 1625; mul 1043 1626; mul 254 1499; mul 71 1502; mul 256
1629; add 1628 1630; mul 303 1505; add 1631 1632; mul 71 1508; mul 306 1634; add 1633 1635; mul 71 1513; mul 310
1637; add 1636 1638; mul 68 1513; mul 66 88; add 1640 1641; mul 314 1642; add 1639 1643; mul 228 1516; add 1644
1645; mul 71 1519; mul 230 1647; add 1646 1648; mul 68 1524; mul 66 111; add 1650 1651; mul 233 1652; add 1649 1653;
mul 71 1527; mul 278 1655; add 1654 1656; mul 68 1527; mul 66 116; add 1658 1659; mul 335 1660; add 1657 1661; mul
66 120; mul 283 1663; add 1662 1664; add 349 353; add 347 1666; add 352 1667; mul 16 1668; add 1665 1669; mul 219
1670; mul 382 1617; add 1671 1672; mul 385 1624; sub 1673 1674; mul 979 1675; add 1627 1676; mul 1046 1677; mul 390
1678; mul 197 1679; mul 1052 1679; mul 404 1681; mul 1050 1682; neg 1683; mul 197 1684; mul 404 1685; mul 409 1683;
sub 1686 1687; sub 1680 1688; mul 407 1689; mul 417 1690; mul 413 1679; mul 412 1692; add 1691 1693; mul 421 1679;
mul 420 1695; sub 1694 1696; mul 390 1697; mul 440 1681; mul 403 1699; mul 441 1681; add 1700 1701; mul 403 1702;
mul 1076 1681; add 1703 1704; mul 390 1705; mul 437 1706; sub 1698 1707; mul 448 1626; sub 1672 1674; mul 396 1710;
add 1709 1711; mul 450 1675; mul 389 1626; add 1713 1714; sub 1712 1715; mul 405 1716; mul 390 1683; mul 452 1718;
sub 1717 1719; mul 455 1720; mul 454 454; mul 1610 1722; mul 380 1723; mul 380 455; mul 1615 1725; add 1724 1726;
mul 453 1727; sub 1721 1728; mul 42 1729; mul 405 1626; mul 396 1718; sub 1731 1732; mul 0 1733; sub 1730 1734; mul
405 1675; mul 389 1718; sub 1736 1737; mul 467 1738; mul 461 1605; mul 66 1601; add 348 1741; mul 219 1742; mul 42
1743; add 1740 1744; mul 406 1745; add 1739 1746; add 1735 1747; mul 447 1748; mul 445 1706; mul 442 1750; mul 446
1706; add 1751 1752; mul 469 1753; sub 1749 1754; add 1708 1755; mul 406 1756; mul 471 1738; add 1757 1758; mul 475
1624; mul 478 1617; sub 1760 1761; mul 1120 1762; mul 475 1617; add 1671 1764; mul 478 1624; add 1765 1766; mul 1118
1767; add 1763 1768; mul 1123 1769; mul 481 1770; mul 197 1771; mul 1129 1771; mul 495 1773; mul 1127 1774; neg
1775; mul 197 1776; mul 495 1777; mul 500 1775; sub 1778 1779; sub 1772 1780; mul 498 1781; mul 507 1782; mul 504
1771; mul 503 1784; add 1783 1785; mul 511 1771; mul 510 1787; sub 1786 1788; mul 481 1789; mul 529 1773; mul 494
1791; mul 530 1773; add 1792 1793; mul 494 1794; mul 1153 1773; add 1795 1796; mul 481 1797; mul 527 1798; sub 1790
1799; mul 537 1762; add 1764 1766; mul 487 1802; add 1801 1803; mul 539 1767; sub 1761 1760; mul 480 1806; add 1805
1807; add 1804 1808; mul 496 1809; mul 481 1775; mul 541 1811; sub 1810 1812; mul 455 1813; mul 542 1727; sub 1814
1815; mul 42 1816; mul 496 1762; mul 487 1811; sub 1818 1819; mul 0 1820; sub 1817 1821; mul 496 1767; mul 480 1811;
sub 1823 1824; mul 467 1825; mul 497 1745; add 1826 1827; add 1822 1828; mul 536 1829; mul 534 1798; mul 531 1831;
mul 535 1798; add 1832 1833; mul 549 1834; sub 1830 1835; add 1800 1836; mul 497 1837; mul 551 1825; add 1838 1839;
add 1759 1840; mul 289 1841; sub 1606 1842; sub 1579 1843; mul 60 1844; mul 458 1756; mul 471 1733; add 1846 1847;
mul 545 1837; mul 551 1820; add 1849 1850; add 1848 1851; sub 1845 1852; sub 1497 1853; sub 1854 1250; mul 629 1855;
input p 160; mul 626 1857; mul 616 627; add 1858 1859; mul 622 1860; add 1856 1861; mul 616 632; add 1209 1863; mul
676 1864; mul 668 1624; mul 455 1866; mul 669 1727; sub 1867 1868; mul 66 1548; mul 61 1870; mul 197 1562; mul 642
1872; mul 197 1564; mul 641 1874; mul 639 1875; add 1873 1876; mul 644 1564; add 1877 1878; mul 647 1872; mul 644
1562; mul 639 1881; add 1880 1882; add 1879 1883; mul 650 1872; add 1884 1885; mul 61 1886; where 638 1887; add 1871
1888; mul 554 1743; mul 465 1841; sub 1890 1891; sub 1889 1892; mul 456 1756; mul 471 1729; add 1894 1895; mul 543
1837; mul 551 1816; add 1897 1898; add 1896 1899; add 1893 1900; add 30 1901; sub 1869 1902; mul 616 620; sub 1903
1904; mul 634 1905; add 1865 1906; sub 1862 1907; mul 685 1908; mul 607 1257; mul 610 1910; mul 629 1911; mul 681
1860; add 1912 1913; mul 1263 1864; sub 1914 1915; mul 1256 1916; sub 1909 1917; mul 681 1905; mul 676 1911; add
1919 1920; mul 622 1864; mul 634 1855; add 1922 1923; sub 1921 1924; mul 685 1925; mul 1343 1916; sub 1926 1927;
input p 161; mul 701 1499; add 1929 1930; mul 704 1502; add 1931 1932; mul 707 1505; add 1933 1934; mul 141 1508;
add 1935 1936; mul 712 1513; add 1937 1938; mul 70 1516; add 1939 1940; mul 717 1519; add 1941 1942; mul 83 1524;
add 1943 1944; mul 171 1527; add 1945 1946; mul 61 1947; input p 162; mul 737 1502; add 1949 1950; mul 262 1508; add
1951 1952; mul 310 1513; add 1953 1954; mul 744 1519; add 1955 1956; mul 278 1527; add 1957 1958; add 351 1959; mul
219 1960; mul 554 1961; mul 752 1841; sub 1962 1963; sub 1948 1964; mul 755 1965; neg 1966; mul 442 1748; mul 469
1706; sub 1968 1969; mul 531 1829; mul 549 1798; sub 1971 1972; mul 406 465; add 456 1974; mul 447 1975; mul 406
1976; mul 465 497; add 543 1978; mul 536 1979; mul 497 1980; add 1977 1981; mul 289 1982; input p 163; add 1983
1984; mul 60 1985; mul 458 1976; mul 545 1980; add 1987 1988; sub 1986 1989; sub 1440 1990; mul 0 612; mul 197 617;
add 1992 1993; mul 610 1994; mul 609 1995; sub 1991 1996; mul 629 1997; mul 465 1982; input p 164; add 1999 2000;
mul 456 1976; mul 543 1980; add 2002 2003; add 2001 2004; add 41 2005; mul 626 1995; add 2006 2007; mul 634 2008;
add 1998 2009; mul 685 2010; mul 681 2008; mul 634 1997; add 2012 2013; mul 685 2014; neg 2015; mul 752 1982; mul
755 2017; neg 2018; mul 442 1975; mul 531 1979; input p 165; where 789 2022; input p 166; where 798 2024; input p
167; where 807 2026; mul 71 197; mul 127 2028; add 124 2029; mul 71 2028; add 128 2031; mul 131 2032; add 2030 2033;
mul 68 138; add 2034 2035; mul 72 197; mul 141 2037; add 2036 2038; mul 80 147; add 2039 2040; mul 64 70; add 2041
2042; mul 95 197; mul 75 2044; add 2043 2045; mul 103 162; add 2046 2047; mul 115 171; add 2048 2049; mul 66 2050;
mul 61 2051; mul 256 2032; add 254 2053; mul 262 2037; add 2054 2055; mul 80 265; add 2056 2057; mul 230 2044; add
2058 2059; mul 115 278; add 2060 2061; mul 66 2062; add 351 2063; mul 219 2064; mul 554 2065; mul 71 2032; add 132
2067; mul 294 2068; add 731 2069; add 735 2070; mul 71 2037; add 76 2072; mul 256 2073; add 2071 2074; mul 84 197;
mul 306 2076; add 2075 2077; add 742 2078; mul 107 197; mul 230 2080; add 2079 2081; mul 172 197; mul 328 2083; add
2082 2084; add 749 2085; add 360 361; add 358 2087; mul 16 2088; add 2086 2089; mul 219 2090; mul 979 2091; mul 1046
2092; mul 390 2093; mul 197 2094; mul 1052 2094; mul 404 2096; mul 1050 2097; neg 2098; mul 197 2099; mul 404 2100;
mul 409 2098; sub 2101 2102; sub 2095 2103; mul 407 2104; mul 417 2105; mul 413 2094; mul 412 2107; add 2106 2108;
mul 421 2094; mul 420 2110; sub 2109 2111; mul 390 2112; mul 440 2096; mul 403 2114; mul 441 2096; add 2115 2116;
mul 403 2117; mul 1076 2096; add 2118 2119; mul 390 2120; mul 437 2121; sub 2113 2122; mul 390 2098; mul 396 2124;
mul 0 2125; mul 450 2091; mul 405 2127; mul 452 2124; add 2128 2129; mul 455 2130; mul 42 2131; sub 2126 2132; mul
405 2091; mul 389 2124; sub 2134 2135; mul 467 2136; mul 230 2037; mul 239 2044; add 2138 2139; mul 103 242; add
2140 2141; mul 63 2062; add 2142 2143; add 225 2144; mul 219 2145; mul 461 2146; mul 42 2065; add 2147 2148; mul 406
2149; add 2137 2150; add 2133 2151; mul 447 2152; mul 445 2121; mul 442 2154; mul 446 2121; add 2155 2156; mul 469
2157; sub 2153 2158; add 2123 2159; mul 406 2160; mul 471 2136; add 2161 2162; mul 1118 2091; mul 1123 2164; mul 481
2165; mul 197 2166; mul 1129 2166; mul 495 2168; mul 1127 2169; neg 2170; mul 197 2171; mul 495 2172; mul 500 2170;
sub 2173 2174; sub 2167 2175; mul 498 2176; mul 507 2177; mul 504 2166; mul 503 2179; add 2178 2180; mul 511 2166;
mul 510 2182; sub 2181 2183; mul 481 2184; mul 529 2168; mul 494 2186; mul 530 2168; add 2187 2188; mul 494 2189;
mul 1153 2168; add 2190 2191; mul 481 2192; mul 527 2193; sub 2185 2194; mul 539 2091; mul 496 2196; mul 481 2170;
mul 541 2198; sub 2197 2199; mul 455 2200; mul 42 2201; mul 487 2198; mul 0 2203; add 2202 2204; mul 496 2091; mul
480 2198; sub 2206 2207; mul 467 2208; mul 497 2149; add 2209 2210; add 2205 2211; mul 536 2212; mul 534 2193; mul
531 2214; mul 535 2193; add 2215 2216; mul 549 2217; sub 2213 2218; add 2195 2219; mul 497 2220; mul 551 2208; add
2221 2222; add 2163 2223; mul 465 2224; sub 2066 2225; sub 2052 2226; mul 456 2160; mul 471 2131; sub 2228 2229; mul
543 2220; mul 551 2201; add 2231 2232; add 2230 2233; add 2227 2234; mul 634 2235; mul 68 70; mul 75 2037; add 2237
2238; mul 80 83; add 2239 2240; mul 64 94; add 2241 2242; mul 98 2044; add 2243 2244; mul 103 106; add 2245 2246;
mul 63 2050; add 2247 2248; mul 61 2249; mul 554 2146; mul 289 2224; sub 2251 2252; sub 2250 2253; mul 60 2254; mul
458 2160; mul 471 2125; sub 2256 2257; mul 545 2220; mul 551 2203; sub 2259 2260; add 2258 2261; sub 2255 2262; mul
629 2263; sub 2236 2264; mul 685 2265; mul 634 2263; mul 681 2235; sub 2267 2268; mul 685 2269; mul 693 2028; add
691 2271; mul 696 2032; add 2272 2273; mul 68 701; add 2274 2275; mul 704 2037; add 2276 2277; mul 80 141; add 2278
2279; mul 103 717; add 2280 2281; mul 98 115; add 2282 2283; mul 61 2284; mul 732 2032; add 730 2286; mul 737 2037;
add 2287 2288; mul 80 262; add 2289 2290; mul 103 744; add 2291 2292; mul 115 239; add 2293 2294; add 359 2295; mul
219 2296; mul 554 2297; mul 752 2224; sub 2298 2299; sub 2285 2300; mul 755 2301; neg 2302; mul 442 2152; mul 469
2121; sub 2304 2305; mul 531 2212; mul 549 2193; sub 2307 2308; mul 427 442; mul 406 2310; mul 465 2311; mul 456
2310; add 2312 2313; mul 634 2314; mul 289 2311; mul 60 2316; mul 458 2310; sub 2317 2318; mul 629 2319; sub 2315
2320; mul 685 2321; mul 634 2319; mul 681 2314; sub 2323 2324; mul 685 2325; mul 752 2311; mul 755 2327; neg 2328;
input p 168; mul 517 531; mul 497 2331; mul 465 2332; mul 543 2331; add 2333 2334; mul 634 2335; mul 289 2332; mul
60 2337; mul 545 2331; sub 2338 2339; mul 629 2340; sub 2336 2341; mul 685 2342; mul 634 2340; mul 681 2335; sub
2344 2345; mul 685 2346; mul 752 2332; mul 755 2348; neg 2349; mul 430 442; mul 406 2351; mul 465 2352; mul 456
2351; add 2353 2354; mul 634 2355; mul 289 2352; mul 60 2357; mul 458 2351; sub 2358 2359; mul 629 2360; sub 2356
2361; mul 685 2362; mul 634 2360; mul 681 2355; sub 2364 2365; mul 685 2366; mul 752 2352; mul 755 2368; neg 2369;
input p 169; mul 520 531; mul 497 2372; mul 465 2373; mul 543 2372; add 2374 2375; mul 634 2376; mul 289 2373; mul
60 2378; mul 545 2372; sub 2379 2380; mul 629 2381; sub 2377 2382; mul 685 2383; mul 634 2381; mul 681 2376; sub
2385 2386; mul 685 2387; mul 752 2373; mul 755 2389; neg 2390; mul 434 442; mul 406 2392; mul 465 2393; mul 456
2392; add 2394 2395; mul 634 2396; mul 289 2393; mul 60 2398; mul 458 2392; sub 2399 2400; mul 629 2401; sub 2397
2402; mul 685 2403; mul 634 2401; mul 681 2396; sub 2405 2406; mul 685 2407; mul 752 2393; mul 755 2409; neg 2410;
input p 170; mul 524 531; mul 497 2413; mul 465 2414; mul 543 2413; add 2415 2416; mul 634 2417; mul 289 2414; mul
60 2419; mul 545 2413; sub 2420 2421; mul 629 2422; sub 2418 2423; mul 685 2424; mul 634 2422; mul 681 2417; sub
2426 2427; mul 685 2428; mul 752 2414; mul 755 2430; neg 2431; mul 595 629; mul 685 2433; mul 595 634; mul 685 2435;
neg 2436; input p 171; mul 599 629; mul 685 2439; mul 599 634; mul 685 2441; neg 2442; input p 172; input p 173; mul
634 2445; mul 582 629; sub 2446 2447; mul 685 2448; mul 582 634; mul 681 2445; sub 2450 2451; mul 685 2452; input p
174; mul 634 2454; mul 585 629; sub 2455 2456; mul 685 2457; mul 585 634; mul 681 2454; sub 2459 2460; mul 685 2461;
input p 175; mul 634 2463; mul 589 629; sub 2464 2465; mul 685 2466; mul 589 634; mul 681 2463; sub 2468 2469; mul
685 2470; mul 14 21; add 2 2472; mul 11 33; sub 2473 2474; mul 419 423; mul 390 2476; mul 458 2477; mul 406 2477;
mul 289 2479; mul 60 2480; sub 2478 2481; sub 2475 2482; mul 629 2483; mul 465 2479; mul 456 2477; add 2485 2486;
add 33 2487; mul 634 2488; sub 2484 2489; mul 685 2490; mul 681 2488; mul 634 2483; sub 2492 2493; mul 685 2494; mul
752 2479; mul 755 2496; mul 14 24; add 6 2498; mul 11 36; sub 2499 2500; mul 509 513; mul 481 2502; mul 545 2503;
mul 497 2503; mul 289 2505; mul 60 2506; sub 2504 2507; sub 2501 2508; mul 629 2509; mul 465 2505; mul 543 2503; add
2511 2512; add 36 2513; mul 634 2514; sub 2510 2515; mul 685 2516; mul 681 2514; mul 634 2509; sub 2518 2519; mul
685 2520; mul 752 2505; mul 755 2522; neg 1289; neg 1277; neg 1351; neg 1354; neg 1291; neg 1362; neg 1299; neg
1303; neg 1372; neg 1375; neg 1322; neg 1382; neg 1385; store f 0 0; store f 1 686; store f 2 42; store f 3 690;
store f 4 757; store f 5 761; store f 6 764; store f 7 767; store f 8 769; store f 9 772; store f 10 774; store f 11
776; store f 12 778; store f 13 792; store f 14 801; store f 15 810; store a 16 1334; store a 48 1388; store a 64
1433; store a 80 1436; store a 96 1439; store a 112 1436; store a 128 1439; store a 144 1436; store a 160 1439;
store a 176 775; store a 192 777; store a 1 368; store a 17 1483; store a 49 1487; store a 65 1490; store a 81 1491;
store a 97 1492; store a 113 1491; store a 129 1492; store a 145 1491; store a 161 1492; store a 209 1493; store a
225 1494; store a 241 1495; store a 18 1918; store a 50 1928; store a 66 1967; store a 82 1970; store a 98 1973;
store a 114 1970; store a 130 1973; store a 146 1970; store a 162 1973; store a 19 2011; store a 35 368; store a 51
2016; store a 67 2019; store a 83 2020; store a 99 2021; store a 115 2020; store a 131 2021; store a 147 2020; store
a 163 2021; store a 211 2023; store a 227 2025; store a 243 2027; store a 20 2266; store a 52 2270; store a 68 2303;
store a 84 2306; store a 100 2309; store a 116 2306; store a 132 2309; store a 148 2306; store a 164 2309; store a
21 2322; store a 53 2326; store a 69 2329; store a 85 2330; store a 22 2343; store a 54 2347; store a 70 2350; store
a 102 2330; store a 23 2363; store a 55 2367; store a 71 2370; store a 119 2371; store a 24 2384; store a 56 2388;
store a 72 2391; store a 136 2371; store a 25 2404; store a 57 2408; store a 73 2411; store a 153 2412; store a 26
2425; store a 58 2429; store a 74 2432; store a 170 2412; store a 27 2434; store a 59 2437; store a 187 2438; store
a 28 2440; store a 60 2443; store a 204 2444; store a 29 2449; store a 61 2453; store a 30 2458; store a 62 2462;
store a 31 2467; store a 63 2471; store b 2 2491; store b 6 2495; store b 8 2497; store b 3 2517; store b 7 2521;
store b 9 2523; store by_c 13 1268; store by_c 39 2524; store by_c 14 2525; store by_c 40 1347; store by_c 15 1281;
store by_c 41 2526; store by_c 16 1285; store by_c 42 2527; store by_c 17 2528; store by_c 43 1359; store by_c 18
1295; store by_c 44 2529; store by_c 19 2530; store by_c 45 1365; store by_c 20 2531; store by_c 46 1368; store by_c
21 1313; store by_c 47 2532; store by_c 22 1317; store by_c 48 2533; store by_c 23 2534; store by_c 49 1379; store
by_c 24 1326; store by_c 50 2535; store by_c 25 1330; store by_c 51 2536
    """,
)

BY_CONSTANTS = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 3, 'p': 197},
    {'by_k': 1168},
    """
input p 111; input x 0; input p 107; mul 1 2; input x 2; input p 110; mul 4 5; add 3 6; input p 108; mul 7 8; mul 7
9; add 0 10; constant 1.0; input p 106; mul 1 13; mul 2 4; add 14 15; mul 16 16; add 12 17; mul 8 18; mul 11 19;
input p 112; mul 8 16; mul 7 22; add 21 23; mul 24 24; sub 20 25; div 12 26; mul 11 27; input p 4; input p 5; input
p 6; input p 7; mul 1 29; mul 32 33; input p 8; mul 4 35; add 34 36; mul 31 37; input p 9; input x 4; mul 37 40; mul
39 41; add 38 42; input p 10; mul 40 41; mul 44 45; add 43 46; input p 11; mul 37 37; mul 48 49; add 47 50; input p
12; mul 40 49; mul 52 53; add 51 54; input p 13; mul 37 49; mul 56 57; add 55 58; input p 14; mul 33 60; add 59 61;
input p 15; mul 33 40; mul 63 64; add 62 65; input p 16; mul 40 64; mul 67 68; add 66 69; input p 17; mul 33 37; mul
71 72; add 70 73; input p 18; mul 40 72; mul 75 76; add 74 77; input p 19; mul 37 72; mul 79 80; add 78 81; input p
20; mul 33 33; mul 37 84; mul 83 85; add 82 86; input p 21; mul 33 84; mul 88 89; add 87 90; input p 22; input p 23;
mul 40 93; add 92 94; input p 24; mul 40 40; mul 96 97; add 95 98; input p 25; mul 40 97; mul 100 101; add 99 102;
input p 26; mul 37 104; add 103 105; input p 27; mul 41 107; add 106 108; input p 28; mul 45 110; add 109 111; input
p 29; mul 49 113; add 112 114; input p 30; mul 53 116; add 115 117; input p 31; mul 57 119; add 118 120; mul 31 33;
add 121 122; mul 39 64; add 123 124; mul 44 68; add 125 126; input p 32; mul 72 128; add 127 129; input p 33; mul 76
131; add 130 132; input p 34; mul 80 134; add 133 135; input p 35; mul 84 137; add 136 138; input p 36; mul 40 84;
mul 140 141; add 139 142; mul 79 85; add 143 144; input p 37; mul 89 146; add 145 147; mul 32 148; add 91 149; mul
30 150; abs 33; constant 0.35; lt 152 153; input p 38; constant 0.6; constant -0.6; max 157 4; min 156 158; mul 159
159; mul 159 160; mul 155 161; constant -0.35; max 163 33; min 153 164; constant 2.0; mul 165 166; input p 39; mul
160 168; mul 167 169; add 162 170; mul 165 165; input p 40; mul 159 173; mul 172 174; add 171 175; mul 165 174; mul
167 177; add 176 178; mul 166 172; input p 41; mul 180 181; mul 167 182; add 179 183; mul 30 184; where 154 185; add
151 186; input p 42; input p 43; mul 33 189; input p 44; mul 4 191; add 190 192; input p 45; mul 40 194; add 193
195; constant -0.09999999999999995; mul 37 197; input p 46; mul 45 199; add 198 200; input p 47; mul 57 202; add 201
203; constant 1.2; mul 33 205; add 204 206; input p 48; mul 68 208; add 207 209; input p 49; mul 76 211; add 210
212; input p 50; mul 80 214; add 213 215; input p 51; mul 85 217; add 216 218; input p 52; mul 89 220; add 219 221;
constant -0.033333333333333326; mul 40 223; input p 53; mul 101 225; add 224 226; constant 0.13333333333333333; mul
37 228; add 227 229; input p 54; mul 45 231; add 230 232; input p 55; mul 53 234; add 233 235; input p 56; mul 57
237; add 236 238; mul 33 197; add 239 240; mul 68 199; add 241 242; input p 57; mul 80 244; add 243 245; input p 58;
mul 141 247; add 246 248; mul 85 214; add 249 250; input p 59; mul 89 252; add 251 253; mul 32 254; add 222 255; add
196 256; mul 188 257; input p 60; input p 61; constant 0.009523809523809514; mul 97 261; input p 62; mul 40 101; mul
263 264; add 262 265; mul 41 223; add 266 267; mul 40 45; mul 225 269; add 268 270; constant 0.06666666666666667;
mul 49 272; add 271 273; input p 63; mul 40 53; mul 275 276; add 274 277; input p 64; mul 40 57; mul 279 280; add
278 281; input p 65; mul 37 57; mul 283 284; add 282 285; mul 72 197; add 286 287; mul 40 76; mul 199 289; add 288
290; mul 37 80; mul 202 292; add 291 293; mul 84 156; add 294 295; input p 66; mul 40 141; mul 297 298; add 296 299;
mul 40 85; mul 247 301; add 300 302; input p 67; mul 37 85; mul 304 305; add 303 306; mul 37 89; mul 252 308; add
307 309; input p 68; mul 33 89; mul 311 312; add 310 313; constant 0.5; mul 33 196; mul 33 191; input p 69; mul 4
318; add 317 319; input p 70; mul 40 321; add 320 322; mul 4 323; add 316 324; mul 33 194; mul 4 321; add 326 327;
input p 71; mul 40 329; add 328 330; mul 40 331; add 325 332; mul 315 333; add 314 334; mul 188 335; add 260 336;
input p 72; mul 4 338; mul 4 339; add 12 340; input p 73; mul 4 342; mul 4 343; add 12 344; sqrt 345; sqrt 341; mul
346 347; div 12 348; mul 341 349; input p 74; mul 350 351; add 337 352; input p 75; mul 4 347; mul 349 355; mul 354
356; sub 353 357; input p 76; mul 350 354; input p 77; sub 360 361; mul 351 356; add 362 363; sub 364 1; mul 365
365; mul 358 358; add 366 367; sqrt 368; mul 359 369; sqrt 370; div 12 371; mul 372 372; mul 359 373; mul 358 374;
input p 78; mul 166 370; mul 166 373; mul 373 378; sub 377 379; mul 376 380; input p 79; constant 1.4; sub 370 383;
mul 382 384; add 12 385; mul 381 386; input u 0; input p 80; mul 388 389; input p 81; mul 384 391; add 12 392; mul
390 393; sub 387 394; mul 359 395; input p 82; input x 5; mul 397 398; input p 83; input x 7; mul 400 401; add 399
402; input p 84; input x 9; mul 404 405; add 403 406; constant -0.5; mul 372 408; mul 372 409; mul 372 410; mul 359
411; mul 407 412; add 396 413; input p 85; mul 412 415; mul 412 416; input x 3; sub 352 357; mul 365 419; add 360
363; mul 358 421; sub 420 422; mul 374 423; div 12 346; mul 349 425; mul 424 426; mul 418 427; input x 1; mul 365
374; mul 429 430; sub 428 431; mul 29 429; mul 258 433; mul 35 254; add 323 435; mul 188 436; mul 418 437; add 434
438; mul 375 439; add 432 440; mul 417 441; add 414 442; mul 375 443; input p 86; add 336 445; input p 87; mul 350
447; add 446 448; input p 88; mul 356 450; add 449 451; input p 89; mul 356 447; mul 350 450; input p 90; sub 455
456; sub 454 457; sub 458 1; mul 459 459; mul 452 452; add 460 461; sqrt 462; mul 453 463; sqrt 464; div 12 465; mul
466 466; mul 453 467; mul 452 468; input p 91; mul 166 464; mul 166 467; mul 467 472; sub 471 473; mul 470 474;
input p 92; sub 464 383; mul 476 477; add 12 478; mul 475 479; input u 1; input p 93; mul 481 482; input p 94; mul
477 484; add 12 485; mul 483 486; sub 480 487; mul 453 488; input p 95; input x 6; mul 490 491; input p 96; input x
8; mul 493 494; add 492 495; input p 97; input x 10; mul 497 498; add 496 499; mul 408 466; mul 466 501; mul 466
502; mul 453 503; mul 500 504; add 489 505; input p 98; mul 504 507; mul 504 508; add 448 451; mul 459 510; sub 455
454; mul 452 512; add 511 513; mul 468 514; mul 426 515; mul 418 516; mul 459 468; mul 429 518; sub 517 519; mul 439
469; add 520 521; mul 509 522; add 506 523; mul 469 524; add 444 525; sub 259 526; mul 258 527; sub 187 528; input p
99; constant 12.0; mul 433 531; constant -6.0; mul 32 433; mul 35 418; add 534 535; mul 533 536; add 532 537; mul
530 538; mul 433 533; constant 4.0; mul 536 541; add 540 542; mul 530 543; mul 32 544; add 539 545; add 529 546; mul
29 547; mul 29 548; mul 28 549; mul 24 27; mul 516 551; mul 28 518; add 552 553; mul 28 29; mul 258 555; mul 437
551; sub 556 557; mul 469 558; sub 554 559; mul 509 560; mul 439 561; mul 524 558; sub 562 563; mul 468 564; mul 524
551; mul 418 561; add 566 567; mul 426 568; mul 468 569; mul 512 570; add 565 571; mul 166 452; mul 166 463; div 12
574; mul 453 560; mul 475 576; mul 476 577; mul 483 576; mul 484 579; sub 578 580; mul 166 465; div 12 582; mul 466
503; mul 522 560; mul 508 585; mul 504 585; mul 507 587; add 586 588; mul 500 560; add 589 590; mul 453 591; mul 584
592; mul 466 592; mul 503 594; add 593 595; mul 466 594; mul 502 597; add 596 598; mul 166 466; mul 452 564; mul 28
524; mul 429 561; sub 602 603; mul 459 604; add 601 605; mul 514 569; add 606 607; mul 453 608; mul 479 576; mul 470
610; mul 472 611; sub 609 612; mul 467 611; neg 614; mul 166 615; add 613 616; mul 600 617; mul 467 618; add 599
619; mul 583 620; sub 581 621; mul 166 611; add 622 623; mul 453 624; mul 575 625; mul 573 626; add 572 627; sub 550
628; mul 469 561; mul 427 551; mul 28 430; add 631 632; mul 375 558; sub 633 634; mul 417 635; mul 375 636; add 630
637; mul 418 638; mul 527 551; sub 639 640; mul 436 641; add 629 642; mul 29 433; mul 35 551; mul 32 555; sub 645
646; mul 530 647; mul 533 648; mul 541 648; mul 530 555; mul 533 651; sub 650 652; mul 32 653; add 649 654; mul 531
651; sub 655 656; mul 258 638; add 657 658; mul 644 659; sub 643 660; mul 527 555; mul 433 638; add 662 663; mul 257
664; add 661 665; mul 439 636; mul 443 558; sub 667 668; mul 374 669; mul 443 551; mul 418 636; add 671 672; mul 426
673; mul 374 674; mul 421 675; sub 670 676; mul 166 358; mul 166 369; div 12 679; mul 359 635; mul 381 681; mul 382
682; mul 390 681; mul 391 684; sub 683 685; mul 166 371; div 12 687; mul 372 411; mul 441 635; mul 416 690; mul 412
690; mul 415 692; add 691 693; mul 407 635; add 694 695; mul 359 696; mul 689 697; mul 372 697; mul 411 699; add 698
700; mul 372 699; mul 410 702; add 701 703; mul 166 372; mul 358 669; mul 28 443; mul 429 636; sub 707 708; mul 365
709; add 706 710; mul 423 674; add 711 712; mul 359 713; mul 386 681; mul 376 715; mul 378 716; sub 714 717; mul 373
716; neg 719; mul 166 720; add 718 721; mul 705 722; mul 373 723; add 704 724; mul 688 725; sub 686 726; mul 166
716; add 727 728; mul 359 729; mul 680 730; mul 678 731; add 677 732; add 628 733; mul 335 734; add 666 735; sub 736
733; mul 29 33; mul 188 641; mul 35 739; mul 188 664; mul 32 741; add 740 742; mul 252 743; mul 84 744; mul 33 166;
mul 33 744; mul 746 747; add 745 748; mul 214 743; mul 37 750; mul 746 751; add 749 752; mul 247 743; mul 40 754;
mul 746 755; add 753 756; mul 244 743; mul 37 758; mul 37 759; add 757 760; mul 199 743; mul 40 762; mul 40 763; add
761 764; mul 197 743; add 765 766; mul 220 741; mul 84 768; add 767 769; mul 33 768; mul 746 771; add 770 772; mul
217 741; mul 37 774; mul 746 775; add 773 776; mul 214 741; mul 37 778; mul 37 779; add 777 780; mul 211 741; mul 40
782; mul 37 783; add 781 784; mul 208 741; mul 40 786; mul 40 787; add 785 788; mul 205 741; add 789 790; mul 188
734; mul 315 792; mul 40 793; mul 194 794; add 791 795; mul 4 793; add 739 797; mul 191 798; add 796 799; mul 196
793; add 800 801; mul 33 793; add 741 803; mul 189 804; add 802 805; mul 311 792; mul 89 807; add 806 808; mul 33
807; mul 84 810; add 809 811; mul 33 810; mul 746 813; add 812 814; mul 252 792; mul 37 816; mul 84 817; add 815
818; mul 33 817; mul 746 820; add 819 821; mul 304 792; mul 37 823; mul 37 824; mul 746 825; add 822 826; mul 247
792; mul 40 828; mul 37 829; mul 746 830; add 827 831; mul 297 792; mul 40 833; mul 40 834; mul 746 835; add 832
836; mul 156 792; mul 746 838; add 837 839; mul 202 792; mul 37 841; mul 37 842; mul 37 843; add 840 844; mul 199
792; mul 40 846; mul 40 847; mul 37 848; add 845 849; mul 197 792; mul 37 851; add 850 852; le 163 33; le 33 163;
add 854 855; div 12 856; mul 854 857; le 164 153; le 153 164; add 859 860; div 12 861; mul 859 862; abs 4; lt 864
156; mul 30 551; mul 173 866; mul 172 867; mul 159 166; mul 866 869; mul 168 870; mul 167 871; add 868 872; mul 159
870; mul 160 866; add 874 875; mul 155 876; add 873 877; where 865 878; mul 30 555; mul 167 880; mul 181 881; neg
882; mul 166 883; mul 167 884; where 154 885; add 879 886; mul 182 880; neg 888; mul 166 889; where 154 890; add 887
891; mul 174 881; neg 893; where 154 894; add 892 895; mul 177 880; neg 897; mul 166 898; where 154 899; add 896
900; mul 165 867; where 865 902; mul 174 880; neg 904; where 154 905; add 903 906; mul 167 907; add 901 908; mul 169
880; neg 910; mul 166 911; where 154 912; add 909 913; mul 863 914; mul 858 915; add 853 916; mul 35 866; mul 32
880; sub 918 919; mul 146 920; mul 84 921; add 917 922; mul 33 921; mul 746 924; add 923 925; mul 79 920; mul 37
927; mul 746 928; add 926 929; mul 140 920; mul 40 931; mul 746 932; add 930 933; mul 137 920; mul 746 935; add 934
936; mul 134 920; mul 37 938; mul 37 939; add 937 940; mul 131 920; mul 40 942; mul 37 943; add 941 944; mul 128
920; mul 37 946; add 945 947; mul 44 920; mul 40 949; mul 40 950; add 948 951; mul 39 920; mul 40 953; add 952 954;
mul 31 920; add 955 956; mul 88 880; mul 84 958; sub 957 959; mul 33 958; mul 746 961; sub 960 962; mul 83 880; mul
37 964; mul 746 965; sub 963 966; mul 79 880; mul 37 968; mul 37 969; sub 967 970; mul 75 880; mul 40 972; mul 37
973; sub 971 974; mul 71 880; mul 37 976; sub 975 977; mul 67 880; mul 40 979; mul 40 980; sub 978 981; mul 63 880;
mul 40 983; sub 982 984; mul 60 880; sub 985 986; mul 84 750; mul 72 758; add 988 989; mul 33 759; add 990 991; mul
237 743; mul 49 993; add 992 994; mul 37 166; mul 37 993; mul 996 997; add 995 998; mul 234 743; mul 40 1000; mul
996 1001; add 999 1002; mul 231 743; mul 40 1004; mul 40 1005; add 1003 1006; mul 228 743; add 1007 1008; mul 84
774; add 1009 1010; mul 72 778; add 1011 1012; mul 33 779; add 1013 1014; mul 33 783; add 1015 1016; mul 202 741;
mul 49 1018; add 1017 1019; mul 37 1018; mul 996 1021; add 1020 1022; mul 199 741; mul 40 1024; mul 40 1025; add
1023 1026; mul 197 741; add 1027 1028; mul 89 816; add 1029 1030; mul 85 823; add 1031 1032; mul 84 824; add 1033
1034; mul 84 829; add 1035 1036; mul 80 841; add 1037 1038; mul 72 842; add 1039 1040; mul 33 843; add 1041 1042;
mul 33 848; add 1043 1044; mul 33 851; add 1045 1046; mul 283 792; mul 57 1048; add 1047 1049; mul 37 1048; mul 49
1051; add 1050 1052; mul 37 1051; mul 996 1054; add 1053 1055; mul 279 792; mul 40 1057; mul 49 1058; add 1056 1059;
mul 37 1058; mul 996 1061; add 1060 1062; mul 275 792; mul 40 1064; mul 40 1065; mul 996 1066; add 1063 1067; mul
272 792; mul 996 1069; add 1068 1070; mul 225 792; mul 40 1072; mul 40 1073; mul 40 1074; add 1071 1075; mul 223
792; mul 40 1077; add 1076 1078; mul 84 927; add 1079 1080; mul 72 938; add 1081 1082; mul 33 939; add 1083 1084;
mul 33 943; add 1085 1086; mul 33 946; add 1087 1088; mul 119 920; mul 49 1090; add 1089 1091; mul 37 1090; mul 996
1093; add 1092 1094; mul 116 920; mul 40 1096; mul 996 1097; add 1095 1098; mul 113 920; mul 996 1100; add 1099
1101; mul 110 920; mul 40 1103; mul 40 1104; add 1102 1105; mul 107 920; mul 40 1107; add 1106 1108; mul 104 920;
add 1109 1110; mul 84 964; sub 1111 1112; mul 72 968; sub 1113 1114; mul 33 969; sub 1115 1116; mul 33 973; sub 1117
1118; mul 33 976; sub 1119 1120; mul 56 880; mul 49 1122; sub 1121 1123; mul 37 1122; mul 996 1125; sub 1124 1126;
mul 52 880; mul 40 1128; mul 996 1129; sub 1127 1130; mul 48 880; mul 996 1132; sub 1131 1133; mul 44 880; mul 40
1135; mul 40 1136; sub 1134 1137; mul 39 880; mul 40 1139; sub 1138 1140; mul 31 880; sub 1141 1142; mul 32 1143;
add 987 1144; mul 738 1145; sub 737 1146; input p 176; input c 4; input p 0; mul 1 1150; sub 4 1151; input c 5; mul
1152 1153; sub 1149 1154; input c 6; mul 388 1156; add 1155 1157; input c 7; mul 481 1159; add 1158 1160; input c 8;
input p 1; max 1162 1163; mul 429 1150; sub 418 1165; mul 1164 1166; sub 1161 1167; mul 28 1168; mul 28 1150; add
551 1170; mul 1164 1171; mul 429 1172; add 1169 1173; mul 1153 1171; input c 9; input c 10; mul 315 1177; mul 1152
1178; sub 1176 1179; input c 11; mul 388 1181; add 1180 1182; input c 12; mul 481 1184; add 1183 1185; mul 28 1186;
add 1175 1187; mul 28 1152; mul 1178 1189; sub 1188 1190; mul 1 1191; add 1174 1192; mul 1148 1193; add 1147 1194;
mul 19 27; mul 527 1196; mul 516 1196; mul 518 551; add 1198 1199; mul 437 1196; mul 29 551; mul 258 1202; sub 1201
1203; mul 469 1204; add 1200 1205; mul 509 1206; mul 469 1207; mul 427 1196; mul 430 551; add 1209 1210; mul 375
1204; add 1211 1212; mul 417 1213; mul 375 1214; add 1208 1215; mul 418 1216; sub 1197 1217; mul 436 1218; mul 549
551; mul 453 1206; mul 483 1221; mul 484 1222; mul 475 1221; mul 476 1224; sub 1223 1225; mul 522 1206; mul 508
1227; mul 504 1227; mul 507 1229; add 1228 1230; mul 500 1206; add 1231 1232; mul 453 1233; mul 584 1234; mul 466
1234; mul 503 1236; add 1235 1237; mul 466 1236; mul 502 1239; add 1238 1240; mul 429 1207; sub 1242 566; mul 459
1243; mul 524 1204; mul 439 1207; add 1245 1246; mul 452 1247; sub 1244 1248; mul 524 1196; mul 418 1207; add 1250
1251; mul 426 1252; mul 514 1253; sub 1249 1254; mul 453 1255; mul 479 1221; mul 470 1257; mul 472 1258; add 1256
1259; mul 467 1258; mul 166 1261; add 1260 1262; mul 600 1263; mul 467 1264; sub 1241 1265; mul 583 1266; add 1226
1267; neg 1258; mul 166 1269; add 1268 1270; mul 453 1271; mul 575 1272; mul 573 1273; mul 468 1247; mul 468 1253;
mul 512 1276; add 1275 1277; sub 1274 1278; add 1220 1279; sub 1219 1280; mul 32 1202; mul 35 1196; sub 1282 1283;
mul 530 1284; mul 533 1285; mul 541 1285; mul 530 1202; mul 533 1288; add 1287 1289; mul 32 1290; add 1286 1291; mul
531 1288; add 1292 1293; mul 258 1216; sub 1294 1295; mul 644 1296; sub 1281 1297; mul 527 1202; mul 433 1216; add
1299 1300; mul 257 1301; sub 1298 1302; mul 443 1196; mul 418 1214; add 1304 1305; mul 426 1306; mul 374 1307; mul
421 1308; mul 443 1204; mul 439 1214; add 1310 1311; mul 374 1312; sub 1309 1313; mul 359 1213; mul 390 1315; mul
391 1316; mul 381 1315; mul 382 1318; sub 1317 1319; mul 441 1213; mul 416 1321; mul 412 1321; mul 415 1323; add
1322 1324; mul 407 1213; add 1325 1326; mul 359 1327; mul 689 1328; mul 372 1328; mul 411 1330; add 1329 1331; mul
372 1330; mul 410 1333; add 1332 1334; mul 429 1214; sub 1336 671; mul 365 1337; mul 358 1312; sub 1338 1339; mul
423 1307; sub 1340 1341; mul 359 1342; mul 386 1315; mul 376 1344; mul 378 1345; add 1343 1346; mul 373 1345; mul
166 1348; add 1347 1349; mul 705 1350; mul 373 1351; sub 1335 1352; mul 688 1353; add 1320 1354; neg 1345; mul 166
1356; add 1355 1357; mul 359 1358; mul 680 1359; mul 678 1360; add 1314 1361; add 1279 1362; mul 335 1363; add 1303
1364; sub 1365 1362; mul 188 1218; mul 35 1367; mul 188 1301; mul 32 1369; sub 1368 1370; mul 252 1371; mul 84 1372;
mul 33 1372; mul 746 1374; add 1373 1375; mul 214 1371; mul 37 1377; mul 746 1378; add 1376 1379; mul 247 1371; mul
40 1381; mul 746 1382; add 1380 1383; mul 244 1371; mul 37 1385; mul 37 1386; add 1384 1387; mul 199 1371; mul 40
1389; mul 40 1390; add 1388 1391; mul 197 1371; add 1392 1393; mul 220 1369; mul 84 1395; sub 1394 1396; mul 33
1395; mul 746 1398; sub 1397 1399; mul 217 1369; mul 37 1401; mul 746 1402; sub 1400 1403; mul 214 1369; mul 37
1405; mul 37 1406; sub 1404 1407; mul 211 1369; mul 40 1409; mul 37 1410; sub 1408 1411; mul 208 1369; mul 40 1413;
mul 40 1414; sub 1412 1415; mul 205 1369; sub 1416 1417; mul 188 1363; mul 315 1419; mul 40 1420; mul 194 1421; add
1418 1422; mul 4 1420; add 1367 1424; mul 191 1425; add 1423 1426; mul 196 1420; add 1427 1428; mul 33 1420; sub
1430 1369; mul 189 1431; add 1429 1432; mul 311 1419; mul 89 1434; add 1433 1435; mul 33 1434; mul 84 1437; add 1436
1438; mul 33 1437; mul 746 1440; add 1439 1441; mul 252 1419; mul 37 1443; mul 84 1444; add 1442 1445; mul 33 1444;
mul 746 1447; add 1446 1448; mul 304 1419; mul 37 1450; mul 37 1451; mul 746 1452; add 1449 1453; mul 247 1419; mul
40 1455; mul 37 1456; mul 746 1457; add 1454 1458; mul 297 1419; mul 40 1460; mul 40 1461; mul 746 1462; add 1459
1463; mul 156 1419; mul 746 1465; add 1464 1466; mul 202 1419; mul 37 1468; mul 37 1469; mul 37 1470; add 1467 1471;
mul 199 1419; mul 40 1473; mul 40 1474; mul 37 1475; add 1472 1476; mul 197 1419; mul 37 1478; add 1477 1479; mul 30
1196; mul 173 1481; mul 172 1482; mul 869 1481; mul 168 1484; mul 167 1485; add 1483 1486; mul 159 1484; mul 160
1481; add 1488 1489; mul 155 1490; add 1487 1491; neg 1492; where 865 1493; mul 30 1202; mul 167 1495; mul 181 1496;
mul 166 1497; mul 167 1498; where 154 1499; add 1494 1500; mul 182 1495; mul 166 1502; where 154 1503; add 1501
1504; mul 174 1496; where 154 1506; add 1505 1507; mul 177 1495; mul 166 1509; where 154 1510; add 1508 1511; mul
165 1482; neg 1513; where 865 1514; mul 174 1495; where 154 1516; add 1515 1517; mul 167 1518; add 1512 1519; mul
169 1495; mul 166 1521; where 154 1522; add 1520 1523; mul 863 1524; mul 858 1525; add 1480 1526; mul 32 1495; mul
35 1481; sub 1528 1529; mul 146 1530; mul 84 1531; add 1527 1532; mul 33 1531; mul 746 1534; add 1533 1535; mul 79
1530; mul 37 1537; mul 746 1538; add 1536 1539; mul 140 1530; mul 40 1541; mul 746 1542; add 1540 1543; mul 137
1530; mul 746 1545; add 1544 1546; mul 134 1530; mul 37 1548; mul 37 1549; add 1547 1550; mul 131 1530; mul 40 1552;
mul 37 1553; add 1551 1554; mul 128 1530; mul 37 1556; add 1555 1557; mul 44 1530; mul 40 1559; mul 40 1560; add
1558 1561; mul 39 1530; mul 40 1563; add 1562 1564; mul 31 1530; add 1565 1566; mul 88 1495; mul 84 1568; add 1567
1569; mul 33 1568; mul 746 1571; add 1570 1572; mul 83 1495; mul 37 1574; mul 746 1575; add 1573 1576; mul 79 1495;
mul 37 1578; mul 37 1579; add 1577 1580; mul 75 1495; mul 40 1582; mul 37 1583; add 1581 1584; mul 71 1495; mul 37
1586; add 1585 1587; mul 67 1495; mul 40 1589; mul 40 1590; add 1588 1591; mul 63 1495; mul 40 1593; add 1592 1594;
mul 60 1495; add 1595 1596; mul 84 1377; mul 72 1385; add 1598 1599; mul 33 1386; add 1600 1601; mul 237 1371; mul
49 1603; add 1602 1604; mul 37 1603; mul 996 1606; add 1605 1607; mul 234 1371; mul 40 1609; mul 996 1610; add 1608
1611; mul 231 1371; mul 40 1613; mul 40 1614; add 1612 1615; mul 228 1371; add 1616 1617; mul 84 1401; sub 1618
1619; mul 72 1405; sub 1620 1621; mul 33 1406; sub 1622 1623; mul 33 1410; sub 1624 1625; mul 202 1369; mul 49 1627;
sub 1626 1628; mul 37 1627; mul 996 1630; sub 1629 1631; mul 199 1369; mul 40 1633; mul 40 1634; sub 1632 1635; mul
197 1369; sub 1636 1637; mul 89 1443; add 1638 1639; mul 85 1450; add 1640 1641; mul 84 1451; add 1642 1643; mul 84
1456; add 1644 1645; mul 80 1468; add 1646 1647; mul 72 1469; add 1648 1649; mul 33 1470; add 1650 1651; mul 33
1475; add 1652 1653; mul 33 1478; add 1654 1655; mul 283 1419; mul 57 1657; add 1656 1658; mul 37 1657; mul 49 1660;
add 1659 1661; mul 37 1660; mul 996 1663; add 1662 1664; mul 279 1419; mul 40 1666; mul 49 1667; add 1665 1668; mul
37 1667; mul 996 1670; add 1669 1671; mul 275 1419; mul 40 1673; mul 40 1674; mul 996 1675; add 1672 1676; mul 272
1419; mul 996 1678; add 1677 1679; mul 225 1419; mul 40 1681; mul 40 1682; mul 40 1683; add 1680 1684; mul 223 1419;
mul 40 1686; add 1685 1687; mul 84 1537; add 1688 1689; mul 72 1548; add 1690 1691; mul 33 1549; add 1692 1693; mul
33 1553; add 1694 1695; mul 33 1556; add 1696 1697; mul 119 1530; mul 49 1699; add 1698 1700; mul 37 1699; mul 996
1702; add 1701 1703; mul 116 1530; mul 40 1705; mul 996 1706; add 1704 1707; mul 113 1530; mul 996 1709; add 1708
1710; mul 110 1530; mul 40 1712; mul 40 1713; add 1711 1714; mul 107 1530; mul 40 1716; add 1715 1717; mul 104 1530;
add 1718 1719; mul 84 1574; add 1720 1721; mul 72 1578; add 1722 1723; mul 33 1579; add 1724 1725; mul 33 1583; add
1726 1727; mul 33 1586; add 1728 1729; mul 56 1495; mul 49 1731; add 1730 1732; mul 37 1731; mul 996 1734; add 1733
1735; mul 52 1495; mul 40 1737; mul 996 1738; add 1736 1739; mul 48 1495; mul 996 1741; add 1740 1742; mul 44 1495;
mul 40 1744; mul 40 1745; add 1743 1746; mul 39 1495; mul 40 1748; add 1747 1749; mul 31 1495; add 1750 1751; mul 32
1752; add 1597 1753; mul 738 1754; sub 1366 1755; mul 551 1168; mul 551 1150; add 1196 1758; mul 1164 1759; mul 429
1760; add 1757 1761; mul 551 1152; mul 1178 1763; mul 1153 1759; mul 551 1186; add 1765 1766; sub 1764 1767; mul 1
1768; sub 1762 1769; mul 1148 1770; sub 1756 1771; constant 0.01904761904761903; mul 40 1773; input p 125; mul 101
1775; add 1774 1776; mul 37 223; add 1777 1778; input p 126; mul 45 1780; add 1779 1781; mul 53 231; add 1782 1783;
mul 57 279; add 1784 1785; input p 127; mul 76 1787; add 1786 1788; mul 141 208; add 1789 1790; mul 85 247; add 1791
1792; add 331 1793; input p 128; mul 527 1795; mul 1794 1796; mul 188 1794; mul 1795 1798; mul 469 1799; mul 453
1800; mul 483 1801; mul 484 1802; mul 475 1801; mul 476 1804; sub 1803 1805; mul 522 1800; mul 508 1807; mul 504
1807; mul 507 1809; add 1808 1810; mul 500 1800; add 1811 1812; mul 453 1813; mul 584 1814; mul 466 1814; mul 503
1816; add 1815 1817; mul 466 1816; mul 502 1819; add 1818 1820; mul 509 1800; mul 429 1822; mul 459 1823; mul 524
1799; mul 439 1822; add 1825 1826; mul 452 1827; sub 1824 1828; mul 418 1822; mul 426 1830; mul 514 1831; sub 1829
1832; mul 453 1833; mul 479 1801; mul 470 1835; mul 472 1836; add 1834 1837; mul 467 1836; mul 166 1839; add 1838
1840; mul 600 1841; mul 467 1842; sub 1821 1843; mul 583 1844; add 1806 1845; neg 1836; mul 166 1847; add 1846 1848;
mul 453 1849; mul 575 1850; mul 573 1851; mul 468 1827; mul 468 1831; mul 512 1854; add 1853 1855; sub 1852 1856;
sub 1797 1857; mul 469 1822; mul 375 1799; mul 417 1860; mul 375 1861; add 1859 1862; mul 418 1863; mul 436 1864;
sub 1858 1865; mul 258 1863; mul 644 1867; add 1866 1868; mul 433 1863; mul 257 1870; sub 1869 1871; mul 418 1861;
mul 426 1873; mul 374 1874; mul 421 1875; mul 443 1799; mul 439 1861; add 1877 1878; mul 374 1879; sub 1876 1880;
mul 359 1860; mul 390 1882; mul 391 1883; mul 381 1882; mul 382 1885; sub 1884 1886; mul 441 1860; mul 416 1888; mul
412 1888; mul 415 1890; add 1889 1891; mul 407 1860; add 1892 1893; mul 359 1894; mul 689 1895; mul 372 1895; mul
411 1897; add 1896 1898; mul 372 1897; mul 410 1900; add 1899 1901; mul 429 1861; mul 365 1903; mul 358 1879; sub
1904 1905; mul 423 1874; sub 1906 1907; mul 359 1908; mul 386 1882; mul 376 1910; mul 378 1911; add 1909 1912; mul
373 1911; mul 166 1914; add 1913 1915; mul 705 1916; mul 373 1917; sub 1902 1918; mul 688 1919; add 1887 1920; neg
1911; mul 166 1922; add 1921 1923; mul 359 1924; mul 680 1925; mul 678 1926; add 1881 1927; add 1857 1928; mul 335
1929; add 1872 1930; sub 1931 1928; mul 188 1796; mul 247 1933; mul 37 1934; mul 746 1935; mul 208 1933; mul 40
1937; mul 746 1938; add 1936 1939; mul 1787 1933; mul 40 1941; mul 37 1942; add 1940 1943; input p 177; mul 37 1945;
mul 746 1946; sub 1944 1947; input p 178; mul 40 1949; mul 746 1950; sub 1948 1951; input p 179; mul 746 1953; sub
1952 1954; input p 180; mul 37 1956; mul 37 1957; sub 1955 1958; input p 181; mul 40 1960; mul 37 1961; sub 1959
1962; input p 182; mul 37 1964; sub 1963 1965; mul 188 1864; mul 35 1967; mul 188 1870; mul 32 1969; add 1968 1970;
mul 252 1971; mul 84 1972; sub 1966 1973; mul 33 1972; mul 746 1975; sub 1974 1976; mul 214 1971; mul 37 1978; mul
746 1979; sub 1977 1980; mul 247 1971; mul 40 1982; mul 746 1983; sub 1981 1984; mul 244 1971; mul 37 1986; mul 37
1987; sub 1985 1988; mul 199 1971; mul 40 1990; mul 40 1991; sub 1989 1992; mul 197 1971; sub 1993 1994; mul 220
1969; mul 84 1996; sub 1995 1997; mul 33 1996; mul 746 1999; sub 1998 2000; mul 217 1969; mul 37 2002; mul 746 2003;
sub 2001 2004; mul 214 1969; mul 37 2006; mul 37 2007; sub 2005 2008; mul 211 1969; mul 40 2010; mul 37 2011; sub
2009 2012; mul 208 1969; mul 40 2014; mul 40 2015; sub 2013 2016; mul 205 1969; sub 2017 2018; mul 188 1929; mul 315
2020; mul 40 2021; add 1933 2022; mul 194 2023; add 2019 2024; mul 4 2021; sub 2026 1967; mul 191 2027; add 2025
2028; mul 196 2021; add 2029 2030; mul 33 2021; sub 2032 1969; mul 189 2033; add 2031 2034; mul 311 2020; mul 89
2036; add 2035 2037; mul 33 2036; mul 84 2039; add 2038 2040; mul 33 2039; mul 746 2042; add 2041 2043; mul 252
2020; mul 37 2045; mul 84 2046; add 2044 2047; mul 33 2046; mul 746 2049; add 2048 2050; mul 304 2020; mul 37 2052;
mul 37 2053; mul 746 2054; add 2051 2055; mul 247 2020; mul 40 2057; mul 37 2058; mul 746 2059; add 2056 2060; mul
297 2020; mul 40 2062; mul 40 2063; mul 746 2064; add 2061 2065; mul 156 2020; mul 746 2067; add 2066 2068; mul 202
2020; mul 37 2070; mul 37 2071; mul 37 2072; add 2069 2073; mul 199 2020; mul 40 2075; mul 40 2076; mul 37 2077; add
2074 2078; mul 197 2020; mul 37 2080; add 2079 2081; mul 84 1934; mul 33 1942; add 2083 2084; mul 279 1933; mul 49
2086; add 2085 2087; mul 37 2086; mul 996 2089; add 2088 2090; mul 231 1933; mul 40 2092; mul 996 2093; add 2091
2094; mul 1780 1933; mul 40 2096; mul 40 2097; add 2095 2098; mul 223 1933; add 2099 2100; mul 84 1945; sub 2101
2102; mul 72 1956; sub 2103 2104; mul 33 1957; sub 2105 2106; mul 33 1961; sub 2107 2108; mul 33 1964; sub 2109
2110; input p 183; mul 49 2112; sub 2111 2113; mul 37 2112; mul 996 2115; sub 2114 2116; input p 184; mul 40 2118;
mul 996 2119; sub 2117 2120; input p 185; mul 996 2122; sub 2121 2123; input p 186; mul 40 2125; mul 40 2126; sub
2124 2127; input p 187; mul 40 2129; sub 2128 2130; input p 188; sub 2131 2132; mul 84 1978; sub 2133 2134; mul 72
1986; sub 2135 2136; mul 33 1987; sub 2137 2138; mul 237 1971; mul 49 2140; sub 2139 2141; mul 37 2140; mul 996
2143; sub 2142 2144; mul 234 1971; mul 40 2146; mul 996 2147; sub 2145 2148; mul 231 1971; mul 40 2150; mul 40 2151;
sub 2149 2152; mul 228 1971; sub 2153 2154; mul 84 2002; sub 2155 2156; mul 72 2006; sub 2157 2158; mul 33 2007; sub
2159 2160; mul 33 2011; sub 2161 2162; mul 202 1969; mul 49 2164; sub 2163 2165; mul 37 2164; mul 996 2167; sub 2166
2168; mul 199 1969; mul 40 2170; mul 40 2171; sub 2169 2172; mul 197 1969; sub 2173 2174; mul 89 2045; add 2175
2176; mul 85 2052; add 2177 2178; mul 84 2053; add 2179 2180; mul 84 2058; add 2181 2182; mul 80 2070; add 2183
2184; mul 72 2071; add 2185 2186; mul 33 2072; add 2187 2188; mul 33 2077; add 2189 2190; mul 33 2080; add 2191
2192; mul 283 2020; mul 57 2194; add 2193 2195; mul 37 2194; mul 49 2197; add 2196 2198; mul 37 2197; mul 996 2200;
add 2199 2201; mul 279 2020; mul 40 2203; mul 49 2204; add 2202 2205; mul 37 2204; mul 996 2207; add 2206 2208; mul
275 2020; mul 40 2210; mul 40 2211; mul 996 2212; add 2209 2213; mul 272 2020; mul 996 2215; add 2214 2216; mul 225
2020; mul 40 2218; mul 40 2219; mul 40 2220; add 2217 2221; mul 223 2020; mul 40 2223; add 2222 2224; mul 32 2225;
add 2082 2226; mul 738 2227; sub 1932 2228; mul 375 412; mul 418 2230; mul 436 2231; mul 258 2230; mul 644 2233; sub
2232 2234; mul 433 2230; mul 257 2236; add 2235 2237; mul 412 439; mul 374 2239; mul 412 418; mul 426 2241; mul 374
2242; mul 421 2243; sub 2240 2244; mul 359 441; mul 689 2246; mul 372 2246; mul 411 2248; add 2247 2249; mul 372
2248; mul 410 2251; add 2250 2252; mul 358 2239; mul 412 429; mul 365 2255; sub 2254 2256; mul 423 2242; add 2257
2258; mul 359 2259; mul 705 2260; mul 373 2261; add 2253 2262; mul 688 2263; mul 359 2264; mul 680 2265; mul 678
2266; sub 2245 2267; mul 335 2268; add 2238 2269; sub 2270 2268; mul 188 2231; mul 35 2272; mul 188 2236; mul 32
2274; add 2273 2275; mul 252 2276; mul 84 2277; mul 33 2277; mul 746 2279; add 2278 2280; mul 214 2276; mul 37 2282;
mul 746 2283; add 2281 2284; mul 247 2276; mul 40 2286; mul 746 2287; add 2285 2288; mul 244 2276; mul 37 2290; mul
37 2291; add 2289 2292; mul 199 2276; mul 40 2294; mul 40 2295; add 2293 2296; mul 197 2276; add 2297 2298; mul 220
2274; mul 84 2300; add 2299 2301; mul 33 2300; mul 746 2303; add 2302 2304; mul 217 2274; mul 37 2306; mul 746 2307;
add 2305 2308; mul 214 2274; mul 37 2310; mul 37 2311; add 2309 2312; mul 211 2274; mul 40 2314; mul 37 2315; add
2313 2316; mul 208 2274; mul 40 2318; mul 40 2319; add 2317 2320; mul 205 2274; add 2321 2322; mul 188 2268; mul 315
2324; mul 40 2325; mul 194 2326; add 2323 2327; mul 4 2325; add 2272 2329; mul 191 2330; add 2328 2331; mul 196
2325; add 2332 2333; mul 33 2325; add 2274 2335; mul 189 2336; add 2334 2337; mul 311 2324; mul 89 2339; add 2338
2340; mul 33 2339; mul 84 2342; add 2341 2343; mul 33 2342; mul 746 2345; add 2344 2346; mul 252 2324; mul 37 2348;
mul 84 2349; add 2347 2350; mul 33 2349; mul 746 2352; add 2351 2353; mul 304 2324; mul 37 2355; mul 37 2356; mul
746 2357; add 2354 2358; mul 247 2324; mul 40 2360; mul 37 2361; mul 746 2362; add 2359 2363; mul 297 2324; mul 40
2365; mul 40 2366; mul 746 2367; add 2364 2368; mul 156 2324; mul 746 2370; add 2369 2371; mul 202 2324; mul 37
2373; mul 37 2374; mul 37 2375; add 2372 2376; mul 199 2324; mul 40 2378; mul 40 2379; mul 37 2380; add 2377 2381;
mul 197 2324; mul 37 2383; add 2382 2384; mul 84 2282; mul 72 2290; add 2386 2387; mul 33 2291; add 2388 2389; mul
237 2276; mul 49 2391; add 2390 2392; mul 37 2391; mul 996 2394; add 2393 2395; mul 234 2276; mul 40 2397; mul 996
2398; add 2396 2399; mul 231 2276; mul 40 2401; mul 40 2402; add 2400 2403; mul 228 2276; add 2404 2405; mul 84
2306; add 2406 2407; mul 72 2310; add 2408 2409; mul 33 2311; add 2410 2411; mul 33 2315; add 2412 2413; mul 202
2274; mul 49 2415; add 2414 2416; mul 37 2415; mul 996 2418; add 2417 2419; mul 199 2274; mul 40 2421; mul 40 2422;
add 2420 2423; mul 197 2274; add 2424 2425; mul 89 2348; add 2426 2427; mul 85 2355; add 2428 2429; mul 84 2356; add
2430 2431; mul 84 2361; add 2432 2433; mul 80 2373; add 2434 2435; mul 72 2374; add 2436 2437; mul 33 2375; add 2438
2439; mul 33 2380; add 2440 2441; mul 33 2383; add 2442 2443; mul 283 2324; mul 57 2445; add 2444 2446; mul 37 2445;
mul 49 2448; add 2447 2449; mul 37 2448; mul 996 2451; add 2450 2452; mul 279 2324; mul 40 2454; mul 49 2455; add
2453 2456; mul 37 2455; mul 996 2458; add 2457 2459; mul 275 2324; mul 40 2461; mul 40 2462; mul 996 2463; add 2460
2464; mul 272 2324; mul 996 2466; add 2465 2467; mul 225 2324; mul 40 2469; mul 40 2470; mul 40 2471; add 2468 2472;
mul 223 2324; mul 40 2474; add 2473 2475; mul 32 2476; add 2385 2477; mul 738 2478; sub 2271 2479; mul 469 504; mul
418 2481; mul 436 2482; mul 439 504; mul 468 2484; mul 418 504; mul 426 2486; mul 468 2487; mul 512 2488; add 2485
2489; mul 453 522; mul 584 2491; mul 466 2491; mul 503 2493; add 2492 2494; mul 466 2493; mul 502 2496; add 2495
2497; mul 452 2484; mul 429 504; mul 459 2500; sub 2499 2501; mul 514 2487; add 2502 2503; mul 453 2504; mul 600
2505; mul 467 2506; add 2498 2507; mul 583 2508; mul 453 2509; mul 575 2510; mul 573 2511; sub 2490 2512; sub 2483
2513; mul 258 2481; mul 644 2515; sub 2514 2516; mul 433 2481; mul 257 2518; add 2517 2519; mul 335 2513; add 2520
2521; mul 188 2482; mul 35 2523; mul 188 2518; mul 32 2525; add 2524 2526; mul 252 2527; mul 84 2528; mul 33 2528;
mul 746 2530; add 2529 2531; mul 214 2527; mul 37 2533; mul 746 2534; add 2532 2535; mul 247 2527; mul 40 2537; mul
746 2538; add 2536 2539; mul 244 2527; mul 37 2541; mul 37 2542; add 2540 2543; mul 199 2527; mul 40 2545; mul 40
2546; add 2544 2547; mul 197 2527; add 2548 2549; mul 220 2525; mul 84 2551; add 2550 2552; mul 33 2551; mul 746
2554; add 2553 2555; mul 217 2525; mul 37 2557; mul 746 2558; add 2556 2559; mul 214 2525; mul 37 2561; mul 37 2562;
add 2560 2563; mul 211 2525; mul 40 2565; mul 37 2566; add 2564 2567; mul 208 2525; mul 40 2569; mul 40 2570; add
2568 2571; mul 205 2525; add 2572 2573; mul 188 2513; mul 315 2575; mul 40 2576; mul 194 2577; add 2574 2578; mul 4
2576; add 2523 2580; mul 191 2581; add 2579 2582; mul 196 2576; add 2583 2584; mul 33 2576; add 2525 2586; mul 189
2587; add 2585 2588; mul 311 2575; mul 89 2590; add 2589 2591; mul 33 2590; mul 84 2593; add 2592 2594; mul 33 2593;
mul 746 2596; add 2595 2597; mul 252 2575; mul 37 2599; mul 84 2600; add 2598 2601; mul 33 2600; mul 746 2603; add
2602 2604; mul 304 2575; mul 37 2606; mul 37 2607; mul 746 2608; add 2605 2609; mul 247 2575; mul 40 2611; mul 37
2612; mul 746 2613; add 2610 2614; mul 297 2575; mul 40 2616; mul 40 2617; mul 746 2618; add 2615 2619; mul 156
2575; mul 746 2621; add 2620 2622; mul 202 2575; mul 37 2624; mul 37 2625; mul 37 2626; add 2623 2627; mul 199 2575;
mul 40 2629; mul 40 2630; mul 37 2631; add 2628 2632; mul 197 2575; mul 37 2634; add 2633 2635; mul 84 2533; mul 72
2541; add 2637 2638; mul 33 2542; add 2639 2640; mul 237 2527; mul 49 2642; add 2641 2643; mul 37 2642; mul 996
2645; add 2644 2646; mul 234 2527; mul 40 2648; mul 996 2649; add 2647 2650; mul 231 2527; mul 40 2652; mul 40 2653;
add 2651 2654; mul 228 2527; add 2655 2656; mul 84 2557; add 2657 2658; mul 72 2561; add 2659 2660; mul 33 2562; add
2661 2662; mul 33 2566; add 2663 2664; mul 202 2525; mul 49 2666; add 2665 2667; mul 37 2666; mul 996 2669; add 2668
2670; mul 199 2525; mul 40 2672; mul 40 2673; add 2671 2674; mul 197 2525; add 2675 2676; mul 89 2599; add 2677
2678; mul 85 2606; add 2679 2680; mul 84 2607; add 2681 2682; mul 84 2612; add 2683 2684; mul 80 2624; add 2685
2686; mul 72 2625; add 2687 2688; mul 33 2626; add 2689 2690; mul 33 2631; add 2691 2692; mul 33 2634; add 2693
2694; mul 283 2575; mul 57 2696; add 2695 2697; mul 37 2696; mul 49 2699; add 2698 2700; mul 37 2699; mul 996 2702;
add 2701 2703; mul 279 2575; mul 40 2705; mul 49 2706; add 2704 2707; mul 37 2706; mul 996 2709; add 2708 2710; mul
275 2575; mul 40 2712; mul 40 2713; mul 996 2714; add 2711 2715; mul 272 2575; mul 996 2717; add 2716 2718; mul 225
2575; mul 40 2720; mul 40 2721; mul 40 2722; add 2719 2723; mul 223 2575; mul 40 2725; add 2724 2726; mul 32 2727;
add 2636 2728; mul 738 2729; sub 2522 2730; mul 160 166; input p 113; mul 2732 2733; mul 869 2734; mul 155 165; mul
160 2736; add 2735 2737; mul 159 2736; mul 869 2739; add 2738 2740; mul 168 172; mul 869 2742; add 2741 2743; mul
165 172; mul 173 2745; add 2744 2746; mul 551 2747; where 865 2748; mul 35 148; mul 551 2750; add 2749 2751; mul 184
555; neg 2753; where 154 2754; add 2752 2755; mul 150 555; sub 2756 2757; mul 1196 2747; neg 2759; where 865 2760;
mul 1196 2750; sub 2761 2762; mul 184 1202; where 154 2764; add 2763 2765; mul 150 1202; add 2766 2767; input p 116;
mul 40 2769; input p 117; mul 97 2771; add 2770 2772; input p 118; mul 101 2774; add 2773 2775; mul 37 93; add 2776
2777; input p 119; mul 41 2779; add 2778 2780; input p 120; mul 45 2782; add 2781 2783; input p 121; mul 49 2785;
add 2784 2786; mul 53 110; add 2787 2788; input p 122; mul 57 2790; add 2789 2791; mul 39 72; add 2792 2793; input p
123; mul 76 2795; add 2794 2796; mul 52 80; add 2797 2798; input p 124; mul 84 2800; add 2799 2801; mul 67 141; add
2802 2803; mul 85 140; add 2804 2805; mul 1795 2806; neg 2807; mul 543 647; mul 538 555; sub 2809 2810; constant
-2.0; mul 1166 1171; le 1162 1163; le 1163 1162; add 2814 2815; div 12 2816; mul 2814 2817; mul 2813 2818; mul 2812
2819; add 2811 2820; mul 543 1284; mul 538 1202; add 2822 2823; mul 1166 1759; mul 2818 2825; mul 2812 2826; sub
2824 2827; constant 0.8; mul 30 2806; mul 527 1798; sub 2830 2831; mul 1795 2832; mul 1795 2833; mul 2829 2834;
constant -2.5714285714285743; mul 89 920; mul 2836 2837; constant 2.057142857142858; mul 85 920; mul 2839 2840; add
2838 2841; constant -0.8571428571428583; mul 141 920; mul 2843 2844; add 2842 2845; constant -3.428571428571427; mul
80 920; mul 2847 2848; add 2846 2849; constant 0.11428571428571443; mul 76 920; mul 2851 2852; add 2850 2853;
constant -0.057142857142856635; mul 68 920; mul 2855 2856; add 2854 2857; input p 189; mul 33 920; mul 197 2860; mul
2859 2861; add 2858 2862; constant 2.438095238095238; mul 57 920; mul 2864 2865; add 2863 2866; constant
0.6571428571428567; mul 53 920; mul 2868 2869; add 2867 2870; input p 190; mul 49 920; mul 2872 2873; sub 2871 2874;
constant 0.11428571428571413; mul 45 920; mul 2876 2877; add 2875 2878; mul 37 920; mul 228 2880; mul 2859 2881; add
2879 2882; constant -0.019047619047619094; mul 101 920; mul 2884 2885; add 2883 2886; mul 40 920; mul 223 2888; mul
2859 2889; add 2887 2890; constant 12.34285714285715; mul 89 880; mul 2892 2893; sub 2891 2894; constant
-7.714285714285722; mul 85 880; mul 2896 2897; sub 2895 2898; mul 80 880; mul 2839 2900; sub 2899 2901; constant
-1.7142857142857166; mul 76 880; mul 2903 2904; sub 2902 2905; constant 0.9142857142857138; mul 68 880; mul 2907
2908; sub 2906 2909; mul 33 880; mul 205 2911; mul 2859 2912; sub 2910 2913; constant -1.1428571428571423; mul 57
880; mul 2915 2916; sub 2914 2917; constant 0.05714285714285722; mul 53 880; mul 2919 2920; sub 2918 2921; mul 45
880; mul 2855 2923; sub 2922 2924; mul 37 880; mul 197 2926; mul 2859 2927; sub 2925 2928; mul 89 1530; mul 2836
2930; mul 85 1530; mul 2839 2932; add 2931 2933; mul 141 1530; mul 2843 2935; add 2934 2936; mul 80 1530; mul 2847
2938; add 2937 2939; mul 76 1530; mul 2851 2941; add 2940 2942; mul 68 1530; mul 2855 2944; add 2943 2945; mul 33
1530; mul 197 2947; mul 2859 2948; add 2946 2949; mul 57 1530; mul 2864 2951; add 2950 2952; mul 53 1530; mul 2868
2954; add 2953 2955; mul 49 1530; mul 2872 2957; sub 2956 2958; mul 45 1530; mul 2876 2960; add 2959 2961; mul 37
1530; mul 228 2963; mul 2859 2964; add 2962 2965; mul 101 1530; mul 2884 2967; add 2966 2968; mul 40 1530; mul 223
2970; mul 2859 2971; add 2969 2972; mul 89 1495; mul 2892 2974; add 2973 2975; mul 85 1495; mul 2896 2977; add 2976
2978; mul 80 1495; mul 2839 2980; add 2979 2981; mul 76 1495; mul 2903 2983; add 2982 2984; mul 68 1495; mul 2907
2986; add 2985 2987; mul 33 1495; mul 205 2989; mul 2859 2990; add 2988 2991; mul 57 1495; mul 2915 2993; add 2992
2994; mul 53 1495; mul 2919 2996; add 2995 2997; mul 45 1495; mul 2855 2999; add 2998 3000; mul 37 1495; mul 197
3002; mul 2859 3003; add 3001 3004; input p 191; mul 85 3006; mul 2843 3007; mul 141 3006; mul 2907 3009; add 3008
3010; mul 80 3006; mul 2919 3012; add 3011 3013; constant -0.11428571428571327; mul 76 3006; mul 3015 3016; add 3014
3017; constant 0.2190476190476189; mul 57 3006; mul 3019 3020; add 3018 3021; mul 53 3006; mul 2876 3023; add 3022
3024; constant -0.05714285714285729; mul 45 3006; mul 3026 3027; add 3025 3028; mul 37 3006; mul 223 3030; mul 2859
3031; add 3029 3032; constant 0.007256235827664418; mul 101 3006; mul 3034 3035; add 3033 3036; mul 40 3006; mul
1773 3038; mul 2859 3039; add 3037 3040; neg 3041; constant -129.60000000000008; mul 2837 3043; constant
230.40000000000006; mul 2840 3045; add 3044 3046; constant 28.799999999999958; mul 2844 3048; add 3047 3049;
constant -36.00000000000001; mul 84 920; mul 3051 3052; mul 2872 3053; add 3050 3054; constant -151.20000000000002;
mul 2848 3056; add 3055 3057; constant -57.59999999999995; mul 2852 3059; add 3058 3060; constant 72.0; mul 72 920;
mul 3062 3063; mul 2872 3064; add 3061 3065; constant -22.62857142857143; mul 2856 3067; add 3066 3068; constant
28.79999999999999; mul 64 920; mul 3070 3071; mul 2872 3072; add 3069 3073; constant -18.000000000000004; mul 2860
3075; mul 2859 3076; add 3074 3077; constant 35.20000000000001; mul 2865 3079; add 3078 3080; constant
21.59999999999998; mul 2869 3082; add 3081 3083; constant -30.000000000000007; mul 2873 3085; mul 2872 3086; add
3084 3087; constant 13.714285714285717; mul 2877 3089; add 3088 3090; constant -14.399999999999991; mul 41 920; mul
3092 3093; mul 2872 3094; add 3091 3095; mul 531 2880; mul 2859 3097; add 3096 3098; constant 0.4571428571428564;
mul 2885 3100; add 3099 3101; constant -2.3999999999999995; mul 97 920; mul 3103 3104; mul 2872 3105; add 3102 3106;
input p 192; constant -0.9999999999999998; mul 920 3109; mul 3108 3110; add 3107 3111; constant 259.2000000000001;
mul 2893 3113; sub 3112 3114; constant -388.80000000000024; mul 2897 3116; sub 3115 3117; mul 2900 3045; sub 3118
3119; constant 57.599999999999916; mul 2904 3121; sub 3120 3122; constant -72.00000000000001; mul 72 880; mul 3124
3125; mul 2872 3126; sub 3123 3127; constant 45.25714285714287; mul 2908 3129; sub 3128 3130; constant
-57.60000000000001; mul 64 880; mul 3132 3133; mul 2872 3134; sub 3131 3135; constant 36.000000000000014; mul 2911
3137; mul 2859 3138; sub 3136 3139; constant -50.400000000000006; mul 2916 3141; sub 3140 3142; constant
-28.799999999999976; mul 2920 3144; sub 3143 3145; constant 36.0; mul 49 880; mul 3147 3148; mul 2872 3149; sub 3146
3150; mul 2923 3067; sub 3151 3152; mul 41 880; mul 3070 3154; mul 2872 3155; sub 3153 3156; mul 2926 3075; mul 2859
3158; sub 3157 3159; mul 2930 3043; mul 2932 3045; add 3161 3162; mul 2935 3048; add 3163 3164; mul 84 1530; mul
3051 3166; mul 2872 3167; add 3165 3168; mul 2938 3056; add 3169 3170; mul 2941 3059; add 3171 3172; mul 72 1530;
mul 3062 3174; mul 2872 3175; add 3173 3176; mul 2944 3067; add 3177 3178; mul 64 1530; mul 3070 3180; mul 2872
3181; add 3179 3182; mul 2947 3075; mul 2859 3184; add 3183 3185; mul 2951 3079; add 3186 3187; mul 2954 3082; add
3188 3189; mul 2957 3085; mul 2872 3191; add 3190 3192; mul 2960 3089; add 3193 3194; mul 41 1530; mul 3092 3196;
mul 2872 3197; add 3195 3198; mul 531 2963; mul 2859 3200; add 3199 3201; mul 2967 3100; add 3202 3203; mul 97 1530;
mul 3103 3205; mul 2872 3206; add 3204 3207; mul 1530 3109; mul 3108 3209; add 3208 3210; mul 2974 3113; add 3211
3212; mul 2977 3116; add 3213 3214; mul 2980 3045; add 3215 3216; mul 2983 3121; add 3217 3218; mul 72 1495; mul
3124 3220; mul 2872 3221; add 3219 3222; mul 2986 3129; add 3223 3224; mul 64 1495; mul 3132 3226; mul 2872 3227;
add 3225 3228; mul 2989 3137; mul 2859 3230; add 3229 3231; mul 2993 3141; add 3232 3233; mul 2996 3144; add 3234
3235; mul 49 1495; mul 3147 3237; mul 2872 3238; add 3236 3239; mul 2999 3067; add 3240 3241; mul 41 1495; mul 3070
3243; mul 2872 3244; add 3242 3245; mul 3002 3075; mul 2859 3247; add 3246 3248; mul 3007 3048; mul 3009 3129; add
3250 3251; constant -28.800000000000004; mul 84 3006; mul 3253 3254; mul 2872 3255; add 3252 3256; mul 3012 3144;
add 3257 3258; constant -45.25714285714286; mul 3016 3260; add 3259 3261; mul 72 3006; mul 3070 3263; mul 2872 3264;
add 3262 3265; constant 7.199999999999994; mul 3020 3267; add 3266 3268; mul 3023 3089; add 3269 3270; constant
-7.199999999999996; mul 49 3006; mul 3272 3273; mul 2872 3274; add 3271 3275; constant 1.3714285714285692; mul 3027
3277; add 3276 3278; constant -4.799999999999999; mul 41 3006; mul 3280 3281; mul 2872 3282; add 3279 3283; constant
1.3714285714285714; mul 3035 3285; add 3284 3286; constant -1.3714285714285723; mul 97 3006; mul 3288 3289; mul 2872
3290; add 3287 3291; constant 2.400000000000001; mul 3038 3293; mul 2859 3294; add 3292 3295; neg 3296; constant
-0.12857142857142845; mul 89 743; mul 3298 3299; constant 0.12857142857142853; mul 85 743; mul 3301 3302; add 3300
3303; constant -0.04285714285714284; mul 141 743; mul 3305 3306; add 3304 3307; constant 0.010714285714285735; mul
80 743; mul 3309 3310; add 3308 3311; constant -0.0006802721088435403; mul 68 743; mul 3313 3314; add 3312 3315;
constant 0.028571428571428567; mul 57 743; mul 3317 3318; add 3316 3319; constant -0.010714285714285721; mul 53 743;
mul 3321 3322; add 3320 3323; constant 0.0027210884353741486; mul 45 743; mul 3325 3326; add 3324 3327; constant
-0.0004787100025195255; mul 101 743; mul 3329 3330; add 3328 3331; constant 1.0285714285714285; mul 89 741; mul 3333
3334; add 3332 3335; constant -0.38571428571428534; mul 85 741; mul 3337 3338; add 3336 3339; mul 80 741; mul 3301
3341; add 3340 3342; constant -0.08571428571428567; mul 76 741; mul 3344 3345; add 3343 3346; constant
0.029931972789115628; mul 68 741; mul 3348 3349; add 3347 3350; constant 0.0035714285714285787; mul 57 741; mul 3352
3353; add 3351 3354; mul 45 741; mul 3313 3356; add 3355 3357; constant 0.2571428571428571; mul 312 792; mul 3359
3360; add 3358 3361; mul 308 792; mul 3298 3363; add 3362 3364; constant 0.06428571428571427; mul 305 792; mul 3366
3367; add 3365 3368; mul 301 792; mul 3305 3370; add 3369 3371; constant 0.014965986394557814; mul 298 792; mul 3373
3374; add 3372 3375; mul 292 792; mul 3352 3377; add 3376 3378; mul 289 792; mul 3313 3380; add 3379 3381; constant
0.007142857142857142; mul 284 792; mul 3383 3384; add 3382 3385; constant -0.003571428571428574; mul 280 792; mul
3387 3388; add 3386 3389; constant 0.0013605442176870743; mul 276 792; mul 3391 3392; add 3390 3393; mul 269 792;
mul 3329 3395; add 3394 3396; constant 8.118473726939319e-05; mul 264 792; mul 3398 3399; add 3397 3400; mul 89
1371; mul 3298 3402; mul 85 1371; mul 3301 3404; add 3403 3405; mul 141 1371; mul 3305 3407; add 3406 3408; mul 80
1371; mul 3309 3410; add 3409 3411; mul 68 1371; mul 3313 3413; add 3412 3414; mul 57 1371; mul 3317 3416; add 3415
3417; mul 53 1371; mul 3321 3419; add 3418 3420; mul 45 1371; mul 3325 3422; add 3421 3423; mul 101 1371; mul 3329
3425; add 3424 3426; mul 89 1369; mul 3333 3428; sub 3427 3429; mul 85 1369; mul 3337 3431; sub 3430 3432; mul 80
1369; mul 3301 3434; sub 3433 3435; mul 76 1369; mul 3344 3437; sub 3436 3438; mul 68 1369; mul 3348 3440; sub 3439
3441; mul 57 1369; mul 3352 3443; sub 3442 3444; mul 45 1369; mul 3313 3446; sub 3445 3447; mul 312 1419; mul 3359
3449; add 3448 3450; mul 308 1419; mul 3298 3452; add 3451 3453; mul 305 1419; mul 3366 3455; add 3454 3456; mul 301
1419; mul 3305 3458; add 3457 3459; mul 298 1419; mul 3373 3461; add 3460 3462; mul 292 1419; mul 3352 3464; add
3463 3465; mul 289 1419; mul 3313 3467; add 3466 3468; mul 284 1419; mul 3383 3470; add 3469 3471; mul 280 1419; mul
3387 3473; add 3472 3474; mul 276 1419; mul 3391 3476; add 3475 3477; mul 269 1419; mul 3329 3479; add 3478 3480;
mul 264 1419; mul 3398 3482; add 3481 3483; mul 85 1933; mul 3305 3485; mul 141 1933; mul 3348 3487; add 3486 3488;
constant -0.0013605442176870806; mul 76 1933; mul 3490 3491; add 3489 3492; mul 57 1933; mul 3387 3494; add 3493
3495; mul 53 1933; mul 3325 3497; add 3496 3498; constant -0.0014361300075585765; mul 45 1933; mul 3500 3501; add
3499 3502; constant 0.00032473894907757275; mul 101 1933; mul 3504 3505; add 3503 3506; mul 89 1971; mul 3298 3508;
sub 3507 3509; mul 85 1971; mul 3301 3511; sub 3510 3512; mul 141 1971; mul 3305 3514; sub 3513 3515; mul 80 1971;
mul 3309 3517; sub 3516 3518; mul 68 1971; mul 3313 3520; sub 3519 3521; mul 57 1971; mul 3317 3523; sub 3522 3524;
mul 53 1971; mul 3321 3526; sub 3525 3527; mul 45 1971; mul 3325 3529; sub 3528 3530; mul 101 1971; mul 3329 3532;
sub 3531 3533; mul 89 1969; mul 3333 3535; sub 3534 3536; mul 85 1969; mul 3337 3538; sub 3537 3539; mul 80 1969;
mul 3301 3541; sub 3540 3542; mul 76 1969; mul 3344 3544; sub 3543 3545; mul 68 1969; mul 3348 3547; sub 3546 3548;
mul 57 1969; mul 3352 3550; sub 3549 3551; mul 45 1969; mul 3313 3553; sub 3552 3554; mul 312 2020; mul 3359 3556;
add 3555 3557; mul 308 2020; mul 3298 3559; add 3558 3560; mul 305 2020; mul 3366 3562; add 3561 3563; mul 301 2020;
mul 3305 3565; add 3564 3566; mul 298 2020; mul 3373 3568; add 3567 3569; mul 292 2020; mul 3352 3571; add 3570
3572; mul 289 2020; mul 3313 3574; add 3573 3575; mul 284 2020; mul 3383 3577; add 3576 3578; mul 280 2020; mul 3387
3580; add 3579 3581; mul 276 2020; mul 3391 3583; add 3582 3584; mul 269 2020; mul 3329 3586; add 3585 3587; mul 264
2020; mul 3398 3589; add 3588 3590; mul 89 2276; mul 3298 3592; mul 85 2276; mul 3301 3594; add 3593 3595; mul 141
2276; mul 3305 3597; add 3596 3598; mul 80 2276; mul 3309 3600; add 3599 3601; mul 68 2276; mul 3313 3603; add 3602
3604; mul 57 2276; mul 3317 3606; add 3605 3607; mul 53 2276; mul 3321 3609; add 3608 3610; mul 45 2276; mul 3325
3612; add 3611 3613; mul 101 2276; mul 3329 3615; add 3614 3616; mul 89 2274; mul 3333 3618; add 3617 3619; mul 85
2274; mul 3337 3621; add 3620 3622; mul 80 2274; mul 3301 3624; add 3623 3625; mul 76 2274; mul 3344 3627; add 3626
3628; mul 68 2274; mul 3348 3630; add 3629 3631; mul 57 2274; mul 3352 3633; add 3632 3634; mul 45 2274; mul 3313
3636; add 3635 3637; mul 312 2324; mul 3359 3639; add 3638 3640; mul 308 2324; mul 3298 3642; add 3641 3643; mul 305
2324; mul 3366 3645; add 3644 3646; mul 301 2324; mul 3305 3648; add 3647 3649; mul 298 2324; mul 3373 3651; add
3650 3652; mul 292 2324; mul 3352 3654; add 3653 3655; mul 289 2324; mul 3313 3657; add 3656 3658; mul 284 2324; mul
3383 3660; add 3659 3661; mul 280 2324; mul 3387 3663; add 3662 3664; mul 276 2324; mul 3391 3666; add 3665 3667;
mul 269 2324; mul 3329 3669; add 3668 3670; mul 264 2324; mul 3398 3672; add 3671 3673; mul 89 2527; mul 3298 3675;
mul 85 2527; mul 3301 3677; add 3676 3678; mul 141 2527; mul 3305 3680; add 3679 3681; mul 80 2527; mul 3309 3683;
add 3682 3684; mul 68 2527; mul 3313 3686; add 3685 3687; mul 57 2527; mul 3317 3689; add 3688 3690; mul 53 2527;
mul 3321 3692; add 3691 3693; mul 45 2527; mul 3325 3695; add 3694 3696; mul 101 2527; mul 3329 3698; add 3697 3699;
mul 89 2525; mul 3333 3701; add 3700 3702; mul 85 2525; mul 3337 3704; add 3703 3705; mul 80 2525; mul 3301 3707;
add 3706 3708; mul 76 2525; mul 3344 3710; add 3709 3711; mul 68 2525; mul 3348 3713; add 3712 3714; mul 57 2525;
mul 3352 3716; add 3715 3717; mul 45 2525; mul 3313 3719; add 3718 3720; mul 312 2575; mul 3359 3722; add 3721 3723;
mul 308 2575; mul 3298 3725; add 3724 3726; mul 305 2575; mul 3366 3728; add 3727 3729; mul 301 2575; mul 3305 3731;
add 3730 3732; mul 298 2575; mul 3373 3734; add 3733 3735; mul 292 2575; mul 3352 3737; add 3736 3738; mul 289 2575;
mul 3313 3740; add 3739 3741; mul 284 2575; mul 3383 3743; add 3742 3744; mul 280 2575; mul 3387 3746; add 3745
3747; mul 276 2575; mul 3391 3749; add 3748 3750; mul 269 2575; mul 3329 3752; add 3751 3753; mul 264 2575; mul 3398
3755; add 3754 3756; input p 193; mul 3053 3758; mul 3064 3758; add 3759 3760; mul 3072 3758; add 3761 3762; input p
194; input p 195; mul 2861 3765; mul 3764 3766; add 3763 3767; mul 3076 3758; mul 3764 3769; add 3768 3770; mul 2873
3765; sub 3771 3772; mul 3086 3758; add 3773 3774; mul 3094 3758; add 3775 3776; mul 2881 3765; mul 3764 3778; add
3777 3779; mul 3097 3758; mul 3764 3781; add 3780 3782; mul 3105 3758; add 3783 3784; mul 2889 3765; mul 3764 3786;
add 3785 3787; mul 3110 3758; mul 2859 3789; add 3788 3790; mul 2872 3789; mul 3764 3792; add 3791 3793; add 3110
3794; mul 3126 3758; sub 3795 3796; mul 3134 3758; sub 3797 3798; mul 2912 3765; mul 3764 3800; sub 3799 3801; mul
3138 3758; mul 3764 3803; sub 3802 3804; mul 3149 3758; sub 3805 3806; mul 3155 3758; sub 3807 3808; mul 2927 3765;
mul 3764 3810; sub 3809 3811; mul 3158 3758; mul 3764 3813; sub 3812 3814; mul 3167 3758; mul 3175 3758; add 3816
3817; mul 3181 3758; add 3818 3819; mul 2948 3765; mul 3764 3821; add 3820 3822; mul 3184 3758; mul 3764 3824; add
3823 3825; mul 2957 3765; sub 3826 3827; mul 3191 3758; add 3828 3829; mul 3197 3758; add 3830 3831; mul 2964 3765;
mul 3764 3833; add 3832 3834; mul 3200 3758; mul 3764 3836; add 3835 3837; mul 3206 3758; add 3838 3839; mul 2971
3765; mul 3764 3841; add 3840 3842; mul 3209 3758; mul 2859 3844; add 3843 3845; mul 2872 3844; mul 3764 3847; add
3846 3848; add 3209 3849; mul 3221 3758; add 3850 3851; mul 3227 3758; add 3852 3853; mul 2990 3765; mul 3764 3855;
add 3854 3856; mul 3230 3758; mul 3764 3858; add 3857 3859; mul 3238 3758; add 3860 3861; mul 3244 3758; add 3862
3863; mul 3003 3765; mul 3764 3865; add 3864 3866; mul 3247 3758; mul 3764 3868; add 3867 3869; mul 3255 3758; mul
3264 3758; add 3871 3872; mul 3274 3758; add 3873 3874; mul 3282 3758; add 3875 3876; mul 3031 3765; mul 3764 3878;
add 3877 3879; mul 3290 3758; add 3880 3881; mul 3039 3765; mul 3764 3883; add 3882 3884; mul 3294 3758; mul 3764
3886; add 3885 3887; neg 3888; mul 433 653; mul 544 555; sub 3890 3891; mul 254 741; add 3892 3893; mul 148 880; sub
3894 3895; mul 33 1143; add 3896 3897; mul 544 1202; mul 433 1290; add 3899 3900; mul 254 1369; sub 3901 3902; mul
148 1495; add 3903 3904; mul 33 1752; add 3905 3906; mul 33 2225; mul 254 1969; sub 3908 3909; mul 254 2274; mul 33
2476; add 3911 3912; mul 254 2525; mul 33 2727; add 3914 3915; mul 544 551; mul 148 866; add 3917 3918; mul 418 653;
add 3919 3920; mul 254 739; add 3921 3922; mul 4 1143; add 3923 3924; mul 418 1290; mul 544 1196; mul 148 1481; add
3927 3928; sub 3926 3929; mul 254 1367; add 3930 3931; mul 4 1752; add 3932 3933; mul 4 2225; mul 254 1967; sub 3935
3936; mul 254 2272; mul 4 2476; add 3938 3939; mul 254 2523; mul 4 2727; add 3941 3942; mul 33 804; mul 33 1431; mul
33 2033; mul 33 2336; mul 33 2587; mul 33 798; mul 4 804; add 3949 3950; mul 33 1425; mul 4 1431; add 3952 3953; mul
33 2027; mul 4 2033; add 3955 3956; mul 33 2330; mul 4 2336; add 3958 3959; mul 33 2581; mul 4 2587; add 3961 3962;
mul 4 798; mul 4 1425; mul 4 2027; mul 4 2330; mul 4 2581; mul 33 794; mul 40 804; add 3969 3970; mul 33 1421; mul
40 1431; add 3972 3973; mul 33 2023; mul 40 2033; add 3975 3976; mul 33 2326; mul 40 2336; add 3978 3979; mul 33
2577; mul 40 2587; add 3981 3982; mul 4 794; mul 40 798; add 3984 3985; mul 4 1421; mul 40 1425; add 3987 3988; mul
4 2023; mul 40 2027; add 3990 3991; mul 4 2326; mul 40 2330; add 3993 3994; mul 4 2577; mul 40 2581; add 3996 3997;
mul 40 794; mul 40 1421; mul 40 2023; mul 40 2326; mul 40 2577; mul 452 570; mul 450 4004; mul 459 570; mul 447
4006; add 4005 4007; mul 447 628; add 4008 4009; mul 468 604; mul 510 570; add 4011 4012; mul 166 459; mul 626 4014;
add 4013 4015; mul 450 4016; sub 4010 4017; mul 358 675; mul 354 4019; sub 4018 4020; mul 365 675; mul 351 4022; add
4021 4023; mul 351 733; add 4024 4025; mul 374 709; mul 419 675; add 4027 4028; mul 166 365; mul 731 4030; add 4029
4031; mul 354 4032; add 4026 4033; mul 349 4034; mul 450 4006; input p 114; mul 426 551; mul 4037 4038; mul 447
4004; add 4039 4040; sub 4036 4041; mul 450 628; add 4042 4043; mul 447 4016; add 4044 4045; mul 351 4019; sub 4046
4047; mul 354 4022; sub 4048 4049; mul 354 733; sub 4050 4051; mul 351 4032; add 4052 4053; mul 349 4054; mul 4
4055; mul 349 426; mul 515 568; mul 356 4037; mul 551 4059; sub 4058 4060; mul 424 673; add 4061 4062; mul 4057
4063; mul 349 356; mul 4054 4065; add 4064 4066; mul 349 350; mul 4034 4068; add 4067 4069; mul 346 4070; sub 4056
4071; mul 166 347; div 12 4073; mul 4072 4074; add 4035 4075; mul 4 4076; mul 4 4077; mul 425 425; mul 349 4063; mul
4079 4080; mul 347 4070; add 4081 4082; mul 166 346; div 12 4084; mul 4083 4085; mul 4 4086; mul 4 4087; sub 4078
4088; mul 447 1279; mul 452 1276; mul 450 4091; mul 459 1276; mul 447 4093; add 4092 4094; sub 4090 4095; mul 468
1243; mul 510 1276; sub 4097 4098; mul 1273 4014; add 4099 4100; mul 450 4101; sub 4096 4102; mul 358 1308; mul 354
4104; add 4103 4105; mul 365 1308; mul 351 4107; sub 4106 4108; mul 351 1362; add 4109 4110; mul 374 1337; mul 419
1308; sub 4112 4113; mul 1360 4030; add 4114 4115; mul 354 4116; add 4111 4117; mul 349 4118; mul 426 1196; mul 4037
4120; mul 447 4091; add 4121 4122; mul 450 4093; sub 4123 4124; mul 450 1279; add 4125 4126; mul 447 4101; add 4127
4128; mul 351 4104; add 4129 4130; mul 354 4107; add 4131 4132; mul 354 1362; sub 4133 4134; mul 351 4116; add 4135
4136; mul 349 4137; mul 4 4138; mul 1196 4059; mul 515 1252; sub 4140 4141; mul 424 1306; sub 4142 4143; mul 4057
4144; mul 4065 4137; add 4145 4146; mul 4068 4118; add 4147 4148; mul 346 4149; sub 4139 4150; mul 4074 4151; add
4119 4152; mul 4 4153; mul 4 4154; mul 349 4144; mul 4079 4156; mul 347 4149; add 4157 4158; mul 4085 4159; mul 4
4160; mul 4 4161; sub 4155 4162; mul 515 1830; mul 424 1873; add 4164 4165; mul 349 4166; mul 4079 4167; mul 4057
4166; mul 452 1854; mul 447 4170; mul 459 1854; mul 450 4172; sub 4171 4173; mul 450 1857; add 4174 4175; mul 468
1823; mul 510 1854; sub 4177 4178; mul 1851 4014; add 4179 4180; mul 447 4181; add 4176 4182; mul 358 1875; mul 351
4184; add 4183 4185; mul 365 1875; mul 354 4187; add 4186 4188; mul 354 1928; sub 4189 4190; mul 374 1903; mul 419
1875; sub 4192 4193; mul 1926 4030; add 4194 4195; mul 351 4196; add 4191 4197; mul 4065 4198; sub 4169 4199; mul
447 1857; mul 450 4170; mul 447 4172; add 4202 4203; sub 4201 4204; mul 450 4181; sub 4205 4206; mul 354 4184; add
4207 4208; mul 351 4187; sub 4209 4210; mul 351 1928; add 4211 4212; mul 354 4196; add 4213 4214; mul 4068 4215; sub
4200 4216; mul 347 4217; add 4168 4218; mul 4085 4219; mul 4 4220; mul 4 4221; mul 349 4215; mul 349 4198; mul 4
4224; mul 346 4217; add 4225 4226; mul 4074 4227; add 4223 4228; mul 4 4229; mul 4 4230; add 4222 4231; mul 365
2243; mul 351 4233; mul 358 2243; mul 354 4235; sub 4234 4236; mul 351 2268; add 4237 4238; mul 419 2243; mul 374
2255; sub 4240 4241; mul 2266 4030; sub 4242 4243; mul 354 4244; add 4239 4245; mul 349 4246; mul 351 4244; mul 351
4235; mul 354 4233; add 4249 4250; mul 354 2268; add 4251 4252; sub 4248 4253; mul 349 4254; mul 4 4255; mul 424
2241; mul 4057 4257; mul 4065 4254; add 4258 4259; mul 4068 4246; add 4260 4261; mul 346 4262; sub 4256 4263; mul
4074 4264; add 4247 4265; mul 4 4266; mul 4 4267; mul 349 4257; mul 4079 4269; mul 347 4262; add 4270 4271; mul 4085
4272; mul 4 4273; mul 4 4274; sub 4268 4275; mul 452 2488; mul 450 4277; mul 459 2488; mul 447 4279; add 4278 4280;
mul 447 2513; add 4281 4282; mul 510 2488; mul 468 2500; sub 4284 4285; mul 2511 4014; sub 4286 4287; mul 450 4288;
sub 4283 4289; mul 349 4290; mul 450 4279; mul 447 4277; sub 4292 4293; mul 450 2513; add 4294 4295; mul 447 4288;
add 4296 4297; mul 349 4298; mul 4 4299; mul 515 2486; mul 4057 4301; mul 4065 4298; add 4302 4303; mul 4068 4290;
add 4304 4305; mul 346 4306; sub 4300 4307; mul 4074 4308; add 4291 4309; mul 4 4310; mul 4 4311; mul 349 4301; mul
4079 4313; mul 347 4306; add 4314 4315; mul 4085 4316; mul 4 4317; mul 4 4318; sub 4312 4319; mul 180 881; neg 4321;
where 154 4322; mul 180 1496; where 154 4324; mul 866 2745; where 865 4326; mul 165 881; mul 172 880; add 4328 4329;
mul 159 4330; neg 4331; where 154 4332; add 4327 4333; mul 1481 2745; neg 4335; where 865 4336; mul 165 1496; mul
172 1495; add 4338 4339; mul 159 4340; where 154 4341; add 4337 4342; mul 172 870; where 865 4344; mul 160 881; neg
4346; where 154 4347; add 4345 4348; mul 172 1484; neg 4350; where 865 4351; mul 160 1496; where 154 4353; add 4352
4354; mul 165 876; where 865 4356; mul 161 880; neg 4358; where 154 4359; add 4357 4360; mul 165 1490; neg 4362;
where 865 4363; mul 161 1495; where 154 4365; add 4364 4366; mul 870 2732; where 865 4368; mul 1484 2732; neg 4370;
where 865 4371; input c 0; input c 2; mul 388 4374; add 4373 4375; input c 3; mul 481 4377; add 4376 4378; mul 1152
1186; add 4379 4380; mul 1150 1168; sub 4381 4382; input p 2; input c 1; add 4384 4385; constant 0.0; max 4386 4387;
input p 3; abs 429; mul 4389 4390; add 4388 4391; mul 429 4392; sub 4383 4393; mul 430 443; mul 518 524; add 4395
4396; sub 548 4397; sub 4394 4398; input p 100; input p 101; input z 0; mul 4401 4402; input p 102; input z 1; mul
4404 4405; add 4403 4406; input p 103; input z 2; mul 4408 4409; add 4407 4410; sub 4400 4411; add 4399 4412; input
p 104; input x 11; sub 1 4415; mul 4414 4416; input p 105; input x 12; sub 1 4419; mul 4418 4420; add 4417 4421; sub
4413 4422; mul 13 429; input p 109; mul 418 4425; add 4424 4426; mul 429 4427; mul 5 418; mul 418 4429; add 4428
4430; mul 8 4431; mul 16 4432; sub 4423 4433; mul 11 4434; mul 30 2750; mul 30 2747; where 865 4437; add 4436 4438;
mul 437 527; sub 4439 4440; mul 35 544; add 4441 4442; mul 427 443; mul 516 524; add 4444 4445; add 4443 4446; sub
1168 4447; mul 426 4059; add 4448 4449; input p 115; mul 4411 4451; sub 4450 4452; mul 7 4432; sub 4453 4454; mul 24
4455; sub 4435 4456; mul 27 4457; mul 27 4458; mul 24 166; mul 4459 4460; mul 27 4455; sub 4461 4462; mul 7 4463;
mul 16 4464; mul 11 4459; mul 18 4466; sub 4465 4467; mul 27 4434; mul 19 4459; sub 4469 4470; mul 7 4471; mul 7
4472; add 4468 4473; mul 7 551; mul 16 28; sub 4475 4476; mul 4431 4477; add 4474 4478; mul 19 4455; mul 24 4434;
sub 4480 4481; mul 27 4482; mul 27 4483; mul 11 4484; sub 4462 4485; mul 18 4486; mul 4460 4484; sub 4488 4469; mul
7 4489; mul 16 4490; add 4487 4491; mul 19 4484; mul 7 4493; mul 7 4494; sub 4492 4495; mul 16 551; mul 7 1196; sub
4497 4498; mul 4431 4499; add 4496 4500; neg 4493; mul 8 4477; mul 429 4503; mul 429 4504; mul 8 4464; mul 16 166;
mul 8 4466; mul 4507 4508; sub 4506 4509; mul 28 4432; sub 4510 4511; mul 1 4512; add 4505 4513; mul 8 4499; mul 429
4515; mul 429 4516; mul 8 4486; mul 4507 4518; mul 8 4490; add 4519 4520; mul 551 4432; add 4521 4522; mul 1 4523;
add 4517 4524; mul 22 4463; add 4522 4526; mul 9 4471; add 4527 4528; mul 8 4472; add 4529 4530; mul 1 4531; mul 418
4504; mul 166 4533; add 4532 4534; mul 4 4512; add 4535 4536; mul 22 4489; mul 1196 4432; sub 4538 4539; mul 9 4493;
sub 4540 4541; mul 8 4494; sub 4542 4543; mul 1 4544; mul 418 4516; mul 166 4546; add 4545 4547; mul 4 4523; add
4548 4549; mul 4 4531; mul 418 4503; mul 418 4552; add 4551 4553; mul 4 4544; mul 418 4515; mul 418 4556; add 4555
4557; input p 196; mul 356 4038; mul 4559 4560; sub 558 4561; mul 356 4120; mul 4559 4563; add 1204 4564; mul 259
4560; neg 4566; mul 259 4563; neg 551; neg 398; neg 491; neg 401; neg 494; neg 405; neg 498; le 4387 4386; le 4386
4387; add 4576 4577; div 12 4578; mul 4576 4579; mul 28 429; mul 4580 4581; neg 4582; mul 429 551; mul 4580 4584;
mul 4390 4581; neg 4586; mul 4390 4584; mul 551 4411; mul 1196 4411; neg 4590; le 12 4402; mul 418 4451; add 429
4593; lt 4387 4594; and 4592 4595; constant -1.0; le 4402 4597; lt 4594 4387; and 4598 4599; or 4596 4600; not 4601;
input p 134; mul 418 4603; where 4602 4604; le 12 4405; and 4595 4606; le 4405 4597; and 4599 4608; or 4607 4609;
not 4610; input p 135; mul 418 4612; where 4611 4613; le 12 4409; and 4595 4615; le 4409 4597; and 4599 4617; or
4616 4618; not 4619; input p 136; mul 418 4621; where 4620 4622; mul 350 4032; mul 350 4019; mul 356 4022; add 4625
4626; mul 356 733; add 4627 4628; sub 4624 4629; mul 350 4104; mul 356 4107; add 4631 4632; mul 356 1362; sub 4633
4634; mul 350 4116; add 4635 4636; mul 350 4184; mul 356 4187; add 4638 4639; mul 356 1928; sub 4640 4641; mul 350
4196; add 4642 4643; mul 350 4244; mul 350 4235; mul 356 4233; add 4646 4647; mul 356 2268; add 4648 4649; sub 4645
4650; mul 350 4022; mul 356 4019; sub 4652 4653; mul 350 733; add 4654 4655; mul 356 4032; add 4656 4657; mul 356
4104; mul 350 4107; sub 4659 4660; mul 350 1362; add 4661 4662; mul 356 4116; add 4663 4664; mul 356 4184; mul 350
4187; sub 4666 4667; mul 350 1928; add 4668 4669; mul 356 4196; add 4670 4671; mul 350 4233; mul 356 4235; sub 4673
4674; mul 350 2268; add 4675 4676; mul 356 4244; add 4677 4678; neg 4032; neg 4116; neg 4196; neg 4244; mul 359 374;
mul 713 4684; mul 359 412; mul 696 4686; add 4685 4687; mul 359 396; mul 635 4689; add 4688 4690; mul 359 370; mul
729 4692; add 4691 4693; neg 4694; mul 1327 4686; mul 1342 4684; sub 4696 4697; mul 1213 4689; add 4698 4699; mul
1358 4692; sub 4700 4701; mul 1894 4686; mul 1908 4684; sub 4703 4704; mul 1860 4689; add 4705 4706; mul 1924 4692;
sub 4707 4708; mul 2264 4692; mul 2259 4684; mul 441 4686; add 4711 4712; sub 4710 4713; mul 380 715; mul 380 1344;
neg 4716; mul 380 1910; neg 4718; mul 384 682; mul 384 1318; neg 4721; mul 384 1885; neg 4723; mul 393 681; mul 388
4725; neg 4726; mul 393 1315; mul 388 4728; mul 393 1882; mul 388 4730; mul 384 684; neg 4732; mul 384 1316; mul 384
1883; mul 412 635; mul 398 4736; mul 412 1213; mul 398 4738; neg 4739; mul 412 1860; mul 398 4741; neg 4742; mul 401
4736; mul 401 4738; neg 4745; mul 401 4741; neg 4747; mul 405 4736; mul 405 4738; neg 4750; mul 405 4741; neg 4752;
mul 412 692; mul 412 1323; neg 4755; mul 412 1890; neg 4757; mul 350 4004; mul 356 4006; add 4759 4760; mul 356 628;
add 4761 4762; mul 350 4016; sub 4763 4764; mul 356 1279; mul 350 4091; mul 356 4093; add 4767 4768; sub 4766 4769;
mul 350 4101; sub 4770 4771; mul 356 1857; mul 350 4170; mul 356 4172; add 4774 4775; sub 4773 4776; mul 350 4181;
sub 4777 4778; mul 350 4277; mul 356 4279; add 4780 4781; mul 356 2513; add 4782 4783; mul 350 4288; sub 4784 4785;
mul 350 4006; mul 356 4004; sub 4787 4788; mul 350 628; add 4789 4790; mul 356 4016; add 4791 4792; mul 356 4091;
mul 350 4093; sub 4794 4795; mul 350 1279; add 4796 4797; mul 356 4101; add 4798 4799; mul 356 4170; mul 350 4172;
sub 4801 4802; mul 350 1857; add 4803 4804; mul 356 4181; add 4805 4806; mul 350 4279; mul 356 4277; sub 4808 4809;
mul 350 2513; add 4810 4811; mul 356 4288; add 4812 4813; mul 453 468; mul 608 4815; mul 453 504; mul 591 4817; add
4816 4818; mul 453 489; mul 560 4820; add 4819 4821; mul 453 464; mul 624 4823; add 4822 4824; neg 4825; mul 1233
4817; mul 1255 4815; sub 4827 4828; mul 1206 4820; add 4829 4830; mul 1271 4823; sub 4831 4832; mul 1813 4817; mul
1833 4815; sub 4834 4835; mul 1800 4820; add 4836 4837; mul 1849 4823; sub 4838 4839; mul 2509 4823; mul 2504 4815;
mul 522 4817; add 4842 4843; sub 4841 4844; mul 474 610; mul 474 1257; neg 4847; mul 474 1835; neg 4849; mul 477
577; mul 477 1224; neg 4852; mul 477 1804; neg 4854; mul 486 576; mul 481 4856; neg 4857; mul 486 1221; mul 481
4859; mul 486 1801; mul 481 4861; mul 477 579; neg 4863; mul 477 1222; mul 477 1802; mul 504 560; mul 491 4867; mul
504 1206; mul 491 4869; neg 4870; mul 504 1800; mul 491 4872; neg 4873; mul 494 4867; mul 494 4869; neg 4876; mul
494 4872; neg 4878; mul 498 4867; mul 498 4869; neg 4881; mul 498 4872; neg 4883; mul 504 587; mul 504 1229; neg
4886; mul 504 1809; neg 4888; mul 551 4451; sub 4890 28; mul 4402 4891; mul 1196 4451; sub 551 4893; mul 4402 4894;
mul 4405 4891; mul 4405 4894; mul 4409 4891; mul 4409 4894; mul 4594 4603; mul 4603 4900; neg 4901; where 4602 4902;
mul 4594 4612; mul 4612 4904; neg 4905; where 4611 4906; mul 4594 4621; mul 4621 4908; neg 4909; where 4620 4910;
mul 28 4416; neg 4912; mul 551 4416; mul 28 4420; neg 4915; mul 551 4420; mul 29 1193; neg 4918; mul 29 1770; store
by_k 73 1195; store by_k 219 1772; store by_k 292 2229; store by_k 365 2480; store by_k 438 2731; store by_k 511
2480; store by_k 584 2731; store by_k 657 2480; store by_k 730 2731; store by_k 74 2758; store by_k 220 2768; store
by_k 293 2808; store by_k 75 2821; store by_k 221 2828; store by_k 294 2835; store by_k 76 2929; store by_k 222
3005; store by_k 295 3042; store by_k 77 3160; store by_k 223 3249; store by_k 296 3297; store by_k 78 3401; store
by_k 224 3484; store by_k 297 3591; store by_k 370 3674; store by_k 443 3757; store by_k 516 3674; store by_k 589
3757; store by_k 662 3674; store by_k 735 3757; store by_k 79 3815; store by_k 225 3870; store by_k 298 3889; store
by_k 80 3898; store by_k 226 3907; store by_k 299 3910; store by_k 372 3913; store by_k 445 3916; store by_k 518
3913; store by_k 591 3916; store by_k 664 3913; store by_k 737 3916; store by_k 81 3925; store by_k 227 3934; store
by_k 300 3937; store by_k 373 3940; store by_k 446 3943; store by_k 519 3940; store by_k 592 3943; store by_k 665
3940; store by_k 738 3943; store by_k 82 3944; store by_k 228 3945; store by_k 301 3946; store by_k 374 3947; store
by_k 447 3948; store by_k 520 3947; store by_k 593 3948; store by_k 666 3947; store by_k 739 3948; store by_k 83
3951; store by_k 229 3954; store by_k 302 3957; store by_k 375 3960; store by_k 448 3963; store by_k 521 3960; store
by_k 594 3963; store by_k 667 3960; store by_k 740 3963; store by_k 84 3964; store by_k 230 3965; store by_k 303
3966; store by_k 376 3967; store by_k 449 3968; store by_k 522 3967; store by_k 595 3968; store by_k 668 3967; store
by_k 741 3968; store by_k 85 3971; store by_k 231 3974; store by_k 304 3977; store by_k 377 3980; store by_k 450
3983; store by_k 523 3980; store by_k 596 3983; store by_k 669 3980; store by_k 742 3983; store by_k 86 3986; store
by_k 232 3989; store by_k 305 3992; store by_k 378 3995; store by_k 451 3998; store by_k 524 3995; store by_k 597
3998; store by_k 670 3995; store by_k 743 3998; store by_k 87 3999; store by_k 233 4000; store by_k 306 4001; store
by_k 379 4002; store by_k 452 4003; store by_k 525 4002; store by_k 598 4003; store by_k 671 4002; store by_k 744
4003; store by_k 88 4089; store by_k 234 4163; store by_k 307 4232; store by_k 380 4276; store by_k 453 4320; store
by_k 526 4276; store by_k 599 4320; store by_k 672 4276; store by_k 745 4320; store by_k 89 4323; store by_k 235
4325; store by_k 90 4334; store by_k 236 4343; store by_k 91 4349; store by_k 237 4355; store by_k 92 4361; store
by_k 238 4367; store by_k 93 4369; store by_k 239 4372; store by_k 94 4479; store by_k 240 4501; store by_k 95 4463;
store by_k 241 4489; store by_k 96 4471; store by_k 242 4502; store by_k 97 4514; store by_k 243 4525; store by_k 98
4537; store by_k 244 4550; store by_k 99 4554; store by_k 245 4558; store by_k 100 4562; store by_k 246 4565; store
by_k 319 1799; store by_k 101 4567; store by_k 247 4568; store by_k 102 28; store by_k 248 4569; store by_k 395
4570; store by_k 468 4571; store by_k 542 4572; store by_k 615 4573; store by_k 689 4574; store by_k 762 4575; store
by_k 106 4583; store by_k 252 4585; store by_k 107 4587; store by_k 253 4588; store by_k 108 4589; store by_k 254
4591; store by_k 984 4605; store by_k 1057 4614; store by_k 1130 4623; store by_k 109 4630; store by_k 255 4637;
store by_k 328 4644; store by_k 401 4651; store by_k 547 4651; store by_k 693 4651; store by_k 110 4658; store by_k
256 4665; store by_k 329 4672; store by_k 402 4679; store by_k 548 4679; store by_k 694 4679; store by_k 111 4680;
store by_k 257 4681; store by_k 330 4682; store by_k 403 4683; store by_k 549 4683; store by_k 695 4683; store by_k
112 733; store by_k 258 1362; store by_k 331 1928; store by_k 404 2268; store by_k 550 2268; store by_k 696 2268;
store by_k 113 4695; store by_k 259 4702; store by_k 332 4709; store by_k 405 4714; store by_k 551 4714; store by_k
697 4714; store by_k 114 4715; store by_k 260 4717; store by_k 333 4719; store by_k 115 4720; store by_k 261 4722;
store by_k 334 4724; store by_k 116 4727; store by_k 262 4729; store by_k 335 4731; store by_k 117 4733; store by_k
263 4734; store by_k 336 4735; store by_k 118 4737; store by_k 264 4740; store by_k 337 4743; store by_k 119 4744;
store by_k 265 4746; store by_k 338 4748; store by_k 120 4749; store by_k 266 4751; store by_k 339 4753; store by_k
121 4754; store by_k 267 4756; store by_k 340 4758; store by_k 122 4765; store by_k 268 4772; store by_k 341 4779;
store by_k 487 4786; store by_k 633 4786; store by_k 779 4786; store by_k 123 4793; store by_k 269 4800; store by_k
342 4807; store by_k 488 4814; store by_k 634 4814; store by_k 780 4814; store by_k 124 4016; store by_k 270 4101;
store by_k 343 4181; store by_k 489 4288; store by_k 635 4288; store by_k 781 4288; store by_k 125 628; store by_k
271 1279; store by_k 344 1857; store by_k 490 2513; store by_k 636 2513; store by_k 782 2513; store by_k 126 4826;
store by_k 272 4833; store by_k 345 4840; store by_k 491 4845; store by_k 637 4845; store by_k 783 4845; store by_k
127 4846; store by_k 273 4848; store by_k 346 4850; store by_k 128 4851; store by_k 274 4853; store by_k 347 4855;
store by_k 129 4858; store by_k 275 4860; store by_k 348 4862; store by_k 130 4864; store by_k 276 4865; store by_k
349 4866; store by_k 131 4868; store by_k 277 4871; store by_k 350 4874; store by_k 132 4875; store by_k 278 4877;
store by_k 351 4879; store by_k 133 4880; store by_k 279 4882; store by_k 352 4884; store by_k 134 4885; store by_k
280 4887; store by_k 353 4889; store by_k 135 4892; store by_k 281 4895; store by_k 136 4896; store by_k 282 4897;
store by_k 137 4898; store by_k 283 4899; store by_k 1014 4903; store by_k 1088 4907; store by_k 1162 4911; store
by_k 141 4913; store by_k 287 4914; store by_k 142 4916; store by_k 288 4917; store by_k 873 4416; store by_k 947
4420; store by_k 145 4919; store by_k 291 4920
    """,
)
