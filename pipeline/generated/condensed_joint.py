"""The condensed joint: rates, forces at rest and inertia.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations.condensed_joint`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

CONSTANTS = ('l', 'bending', 'bending_loss', 'steepening', 'stiffening', 'shortening', 'curvature', 'slope_by_q',
    'slope_by_tau', 'shortening_qq', 'shortening_qt', 'shortening_tt', 'shortening_qb', 'shortening_tb',
    'shortening_bb', 'rotation', 'quartic_qqqq', 'quartic_qqqt', 'quartic_qqtt', 'quartic_qttt', 'quartic_tttt',
    'mass', 'cross', 'inertia', 'rise_qq', 'rise_qt', 'rise_tt', 'weight', 'offset', 'side_force', 'relaxation_0',
    'relaxation_1', 'relaxation_2', 'viscosity', 'drag', 'friction_arm', 'left_a', 'left_c', 'left_e_z',
    'left_e_x', 'left_l0', 'left_elastic', 'left_hardening', 'left_electric', 'left_electric_slope',
    'left_maxwell_0', 'left_maxwell_1', 'left_maxwell_2', 'left_viscous', 'right_a', 'right_c', 'right_e_z',
    'right_e_x', 'right_l0', 'right_elastic', 'right_hardening', 'right_electric', 'right_electric_slope',
    'right_maxwell_0', 'right_maxwell_1', 'right_maxwell_2', 'right_viscous', 'stop_force_0', 'stop_force_1',
    'stop_force_2', 'stop_travel_0', 'stop_travel_1', 'stop_travel_2', 'creep_stiffness_0', 'creep_stiffness_1',
    'creep_rate_0', 'creep_rate_1', 'slope_ratio')

CORRECTIONS = ('force', 'damping', 'left', 'right', 'moment', 'stiffness', 'left_moment', 'right_moment', 'loss',
    'moment_q', 'stiffness_q', 'left_moment_q', 'right_moment_q')

STATES = 13

STOPS = 3

CREEPS = 2

BRANCHES = 3

PREPARE = Graph(
    {'k': 73},
    {'p': 143},
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
input k 29; input k 62; input k 35; input k 65; div 2 239; input k 63; input k 66; div 2 242; input k 64; input k
67; div 2 245; input k 68; input k 69; input k 24; input k 25; input k 21; mul 150 250; input k 26; input k 23;
input k 22; input k 20; input k 28; mul 154 257; constant 0.8000000000000002; constant 2.400000000000001; mul 16
260; add 259 261; constant 0.01904761904761903; mul 21 263; add 262 264; constant -1.3714285714285723; mul 27 266;
constant 1.3714285714285714; mul 15 268; constant 0.007256235827664418; mul 20 270; add 269 271; constant
-4.799999999999999; mul 27 273; constant 1.3714285714285692; mul 15 275; constant -0.05714285714285729; mul 20 277;
add 276 278; constant -7.199999999999996; mul 27 280; constant 7.199999999999994; mul 15 282; constant
0.2190476190476189; mul 20 284; add 283 285; constant -45.25714285714286; mul 15 287; constant -0.11428571428571327;
mul 20 289; add 288 290; constant -28.800000000000004; mul 27 292; constant 0.00032473894907757275; mul 164 294;
constant -0.0014361300075585765; mul 164 296; constant -0.0013605442176870806; mul 164 298; constant 0.8; mul 6 300;
div 2 301; input k 30; input k 31; input k 32; input k 70; input k 71; mul 23 25; mul 25 103; mul 19 25; mul 25 101;
mul 25 89; mul 25 88; store p 0 4; store p 1 7; store p 2 8; store p 3 9; store p 4 3; store p 5 10; store p 6 23;
store p 7 24; store p 8 25; store p 9 28; store p 10 33; store p 11 35; store p 12 40; store p 13 45; store p 14 52;
store p 15 54; store p 16 59; store p 17 61; store p 18 66; store p 19 71; store p 20 76; store p 21 81; store p 22
87; store p 23 89; store p 24 91; store p 25 96; store p 26 103; store p 27 105; store p 28 110; store p 29 114;
store p 30 119; store p 31 124; store p 32 126; store p 33 131; store p 34 136; store p 35 138; store p 36 143;
store p 37 148; store p 38 149; store p 39 151; store p 40 152; store p 41 153; store p 42 1; store p 43 188; store
p 44 189; store p 45 190; store p 46 175; store p 47 177; store p 48 204; store p 49 206; store p 50 208; store p 51
210; store p 52 212; store p 53 167; store p 54 214; store p 55 216; store p 56 218; store p 57 220; store p 58 181;
store p 59 185; store p 60 154; store p 61 162; store p 62 165; store p 63 169; store p 64 171; store p 65 173;
store p 66 179; store p 67 183; store p 68 187; store p 69 191; store p 70 192; store p 71 193; store p 72 158;
store p 73 157; store p 74 160; store p 75 156; store p 76 195; store p 77 159; store p 78 155; store p 79 196;
store p 80 197; store p 81 198; store p 82 199; store p 83 200; store p 84 201; store p 85 202; store p 86 226;
store p 87 222; store p 88 223; store p 89 228; store p 90 224; store p 91 221; store p 92 229; store p 93 230;
store p 94 231; store p 95 232; store p 96 233; store p 97 234; store p 98 235; store p 99 6; store p 100 236; store
p 101 237; store p 102 238; store p 103 240; store p 104 241; store p 105 243; store p 106 244; store p 107 246;
store p 108 247; store p 109 248; store p 110 249; store p 111 250; store p 112 251; store p 113 252; store p 114
253; store p 115 254; store p 116 255; store p 117 256; store p 118 258; store p 119 265; store p 120 267; store p
121 272; store p 122 274; store p 123 279; store p 124 281; store p 125 286; store p 126 291; store p 127 293; store
p 128 295; store p 129 297; store p 130 299; store p 131 302; store p 132 303; store p 133 304; store p 134 305;
store p 135 306; store p 136 307; store p 137 308; store p 138 309; store p 139 310; store p 140 311; store p 141
312; store p 142 313
    """,
)

RATES = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 3, 'start': 2, 'p': 143},
    {'rates': 13},
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
input p 100; input p 101; constant -1.0; input z 0; input start 0; sub 12 585; input p 102; input start 1; sub 10
588; mul 587 589; add 586 590; input p 103; mul 591 592; add 584 593; max 583 594; min 368 595; mul 582 596; input p
104; input z 1; input p 105; mul 591 600; add 599 601; max 583 602; min 368 603; mul 598 604; add 597 605; input p
106; input z 2; input p 107; mul 591 609; add 608 610; max 583 611; min 368 612; mul 607 613; add 606 614; sub 581
615; add 580 616; input p 108; input x 11; sub 12 619; mul 618 620; input p 109; input x 12; sub 12 623; mul 622
624; add 621 625; sub 617 626; input p 110; mul 12 628; input p 111; mul 10 630; add 629 631; input p 112; mul 0
628; input p 113; mul 42 635; add 634 636; mul 0 637; input p 114; mul 42 639; mul 42 640; add 638 641; mul 633 642;
mul 632 643; sub 627 644; input p 115; mul 12 630; mul 10 639; add 647 648; mul 633 649; mul 649 650; add 646 651;
mul 645 652; input p 116; mul 632 633; mul 649 655; add 654 656; mul 66 179; mul 61 658; abs 10; lt 660 187; mul 190
197; mul 191 197; input p 117; mul 663 664; mul 662 665; mul 186 196; mul 191 667; add 666 668; mul 190 667; mul 662
670; add 669 671; mul 199 203; mul 662 673; add 672 674; mul 196 203; mul 204 676; add 675 677; mul 61 678; where
661 679; add 659 680; mul 465 554; sub 681 682; mul 66 571; add 683 684; mul 456 471; mul 543 551; add 686 687; add
685 688; sub 46 689; input p 118; mul 387 691; mul 455 692; add 690 693; mul 587 615; sub 694 695; mul 643 649; sub
696 697; mul 657 698; sub 653 699; mul 632 632; add 368 701; mul 633 702; mul 652 703; mul 657 657; sub 704 705; div
368 706; mul 700 707; mul 698 703; mul 645 657; sub 709 710; mul 707 711; input p 119; mul 71 713; input p 120; mul
128 715; add 714 716; input p 121; mul 132 718; add 717 719; mul 68 124; add 720 721; input p 122; mul 72 723; add
722 724; input p 123; mul 76 726; add 725 727; input p 124; mul 80 729; add 728 730; mul 84 141; add 731 732; input
p 125; mul 88 734; add 733 735; mul 70 103; add 736 737; input p 126; mul 107 739; add 738 740; mul 83 111; add 741
742; input p 127; mul 115 744; add 743 745; mul 98 172; add 746 747; mul 116 171; add 748 749; mul 61 750; constant
0.01904761904761903; mul 71 752; input p 128; mul 132 754; add 753 755; mul 68 254; add 756 757; input p 129; mul 76
759; add 758 760; mul 84 262; add 761 762; mul 88 310; add 763 764; input p 130; mul 107 766; add 765 767; mul 172
239; add 768 769; mul 116 278; add 770 771; add 361 772; mul 219 773; mul 554 774; sub 751 775; input p 131; mul 776
777; neg 778; mul 442 469; input p 132; mul 428 781; sub 780 782; mul 531 549; mul 518 781; sub 784 785; input p
133; mul 431 787; sub 780 788; mul 521 787; sub 784 790; input p 134; mul 435 792; sub 780 793; mul 525 792; sub 784
795; input p 135; mul 620 797; input p 136; mul 624 799; store rates 0 0; store rates 1 708; store rates 2 42; store
rates 3 712; store rates 4 779; store rates 5 783; store rates 6 786; store rates 7 789; store rates 8 791; store
rates 9 794; store rates 10 796; store rates 11 798; store rates 12 800
    """,
)

SHAPE = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'p': 143},
    {'forces': 3, 'by_shape': 6},
    """
input p 100; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
input p 0; input x 0; mul 11 12; sub 10 13; input c 9; constant 0.5; input c 10; mul 16 17; mul 14 18; sub 15 19;
input c 11; mul 3 21; add 20 22; input c 12; mul 7 24; add 23 25; mul 14 26; add 9 27; input c 4; input c 5; mul 14
30; sub 29 31; input c 6; mul 3 33; add 32 34; input c 7; mul 7 36; add 35 37; mul 11 38; sub 28 39; input p 4;
input p 5; input p 6; input p 7; mul 12 41; mul 44 45; input p 8; mul 10 47; add 46 48; mul 43 49; input p 9; input
x 4; mul 49 52; mul 51 53; add 50 54; input p 10; mul 52 53; mul 56 57; add 55 58; input p 11; mul 49 49; mul 60 61;
add 59 62; input p 12; mul 52 61; mul 64 65; add 63 66; input p 13; mul 49 61; mul 68 69; add 67 70; input p 14; mul
45 72; add 71 73; input p 15; mul 45 52; mul 75 76; add 74 77; input p 16; mul 52 76; mul 79 80; add 78 81; input p
17; mul 45 49; mul 83 84; add 82 85; input p 18; mul 52 84; mul 87 88; add 86 89; input p 19; mul 49 84; mul 91 92;
add 90 93; input p 20; mul 45 45; mul 49 96; mul 95 97; add 94 98; input p 21; mul 45 96; mul 100 101; add 99 102;
input p 22; input p 23; mul 52 105; add 104 106; input p 24; mul 52 52; mul 108 109; add 107 110; input p 25; mul 52
109; mul 112 113; add 111 114; input p 26; mul 49 116; add 115 117; input p 27; mul 53 119; add 118 120; input p 28;
mul 57 122; add 121 123; input p 29; mul 61 125; add 124 126; input p 30; mul 65 128; add 127 129; input p 31; mul
69 131; add 130 132; mul 43 45; add 133 134; mul 51 76; add 135 136; mul 56 80; add 137 138; input p 32; mul 84 140;
add 139 141; input p 33; mul 88 143; add 142 144; input p 34; mul 92 146; add 145 147; input p 35; mul 96 149; add
148 150; input p 36; mul 52 96; mul 152 153; add 151 154; mul 91 97; add 155 156; input p 37; mul 101 158; add 157
159; mul 44 160; add 103 161; mul 42 162; abs 45; constant 0.35; lt 164 165; input p 38; constant 0.6; constant
-0.6; max 169 10; min 168 170; mul 171 171; mul 171 172; mul 167 173; constant -0.35; max 175 45; min 165 176;
constant 2.0; mul 177 178; input p 39; mul 172 180; mul 179 181; add 174 182; mul 177 177; input p 40; mul 171 185;
mul 184 186; add 183 187; mul 177 186; mul 179 189; add 188 190; mul 178 184; input p 41; mul 192 193; mul 179 194;
add 191 195; mul 42 196; where 166 197; add 163 198; input p 42; input p 43; mul 45 201; input p 44; mul 10 203; add
202 204; input p 45; mul 52 206; add 205 207; constant -0.09999999999999995; mul 49 209; input p 46; mul 57 211; add
210 212; input p 47; mul 69 214; add 213 215; constant 1.2; mul 45 217; add 216 218; input p 48; mul 80 220; add 219
221; input p 49; mul 88 223; add 222 224; input p 50; mul 92 226; add 225 227; input p 51; mul 97 229; add 228 230;
input p 52; mul 101 232; add 231 233; constant -0.033333333333333326; mul 52 235; input p 53; mul 113 237; add 236
238; constant 0.13333333333333333; mul 49 240; add 239 241; input p 54; mul 57 243; add 242 244; input p 55; mul 65
246; add 245 247; input p 56; mul 69 249; add 248 250; mul 45 209; add 251 252; mul 80 211; add 253 254; input p 57;
mul 92 256; add 255 257; input p 58; mul 153 259; add 258 260; mul 97 226; add 261 262; input p 59; mul 101 264; add
263 265; mul 44 266; add 234 267; add 208 268; mul 200 269; input p 60; input p 76; input p 78; input p 75; constant
1.0; input p 72; mul 10 276; mul 10 277; add 275 278; input p 73; mul 10 280; mul 10 281; add 275 282; sqrt 283;
sqrt 279; mul 284 285; div 275 286; mul 279 287; mul 274 288; input p 77; sub 289 290; input p 74; mul 10 285; mul
287 293; mul 292 294; add 291 295; sub 296 12; mul 297 297; input p 61; constant 0.009523809523809514; mul 109 300;
input p 62; mul 52 113; mul 302 303; add 301 304; mul 53 235; add 305 306; mul 52 57; mul 237 308; add 307 309;
constant 0.06666666666666667; mul 61 311; add 310 312; input p 63; mul 52 65; mul 314 315; add 313 316; input p 64;
mul 52 69; mul 318 319; add 317 320; input p 65; mul 49 69; mul 322 323; add 321 324; mul 84 209; add 325 326; mul
52 88; mul 211 328; add 327 329; mul 49 92; mul 214 331; add 330 332; mul 96 168; add 333 334; input p 66; mul 52
153; mul 336 337; add 335 338; mul 52 97; mul 259 340; add 339 341; input p 67; mul 49 97; mul 343 344; add 342 345;
mul 49 101; mul 264 347; add 346 348; input p 68; mul 45 101; mul 350 351; add 349 352; mul 45 208; mul 45 203;
input p 69; mul 10 356; add 355 357; input p 70; mul 52 359; add 358 360; mul 10 361; add 354 362; mul 45 206; mul
10 359; add 364 365; input p 71; mul 52 367; add 366 368; mul 52 369; add 363 370; mul 16 371; add 353 372; mul 200
373; add 299 374; mul 288 292; add 375 376; mul 274 294; sub 377 378; mul 379 379; add 298 380; sqrt 381; mul 272
382; mul 178 383; sqrt 383; div 275 385; mul 386 386; mul 178 387; mul 387 388; sub 384 389; mul 273 390; input p
79; constant 1.4; sub 383 393; mul 392 394; add 275 395; mul 391 396; input p 80; mul 3 398; input p 81; mul 394
400; add 275 401; mul 399 402; sub 397 403; mul 272 404; mul 272 387; mul 379 406; mul 405 407; input p 89; input p
91; input p 87; mul 294 411; input p 88; mul 288 413; input p 90; sub 414 415; sub 412 416; sub 417 12; mul 418 418;
input p 86; add 374 420; mul 288 411; add 421 422; mul 294 413; add 423 424; mul 425 425; add 419 426; sqrt 427; mul
409 428; mul 178 429; sqrt 429; div 275 431; mul 432 432; mul 178 433; mul 433 434; sub 430 435; mul 410 436; input
p 92; sub 429 393; mul 438 439; add 275 440; mul 437 441; input p 93; mul 7 443; input p 94; mul 439 445; add 275
446; mul 444 447; sub 442 448; mul 409 449; mul 409 433; mul 425 451; mul 450 452; add 408 453; sub 271 454; mul 270
455; sub 199 456; mul 41 457; mul 297 406; mul 405 459; mul 418 451; mul 450 461; add 460 462; sub 458 463; sub 40
464; add 0 465; div 275 284; mul 287 467; input p 118; mul 294 469; mul 468 470; mul 47 160; mul 42 472; abs 10; lt
474 168; mul 171 178; mul 172 178; input p 117; mul 477 478; mul 476 479; mul 167 177; mul 172 481; add 480 482; mul
171 481; mul 476 484; add 483 485; mul 180 184; mul 476 487; add 486 488; mul 177 184; mul 185 490; add 489 491; mul
42 492; where 475 493; add 473 494; mul 47 266; add 361 496; mul 200 497; mul 455 498; sub 495 499; sub 376 378; mul
297 501; add 289 295; mul 379 503; sub 502 504; mul 406 505; mul 468 506; mul 405 507; add 422 424; mul 418 509; sub
414 412; mul 425 511; add 510 512; mul 451 513; mul 468 514; mul 450 515; add 508 516; add 500 517; sub 38 518; add
471 519; input p 119; mul 52 521; input p 120; mul 109 523; add 522 524; input p 121; mul 113 526; add 525 527; mul
49 105; add 528 529; input p 122; mul 53 531; add 530 532; input p 123; mul 57 534; add 533 535; input p 124; mul 61
537; add 536 538; mul 65 122; add 539 540; input p 125; mul 69 542; add 541 543; mul 51 84; add 544 545; input p
126; mul 88 547; add 546 548; mul 64 92; add 549 550; input p 127; mul 96 552; add 551 553; mul 79 153; add 554 555;
mul 97 152; add 556 557; mul 42 558; constant 0.01904761904761903; mul 52 560; input p 128; mul 113 562; add 561
563; mul 49 235; add 564 565; input p 129; mul 57 567; add 566 568; mul 65 243; add 569 570; mul 69 318; add 571
572; input p 130; mul 88 574; add 573 575; mul 153 220; add 576 577; mul 97 259; add 578 579; add 369 580; mul 200
581; mul 455 582; sub 559 583; neg 584; sub 26 19; mul 11 30; add 586 587; input p 137; mul 47 52; mul 51 590; add
589 591; mul 52 590; mul 56 593; add 592 594; mul 49 178; mul 47 596; mul 60 597; add 595 598; mul 52 597; mul 64
600; add 599 601; mul 49 597; mul 47 61; add 603 604; mul 68 605; add 602 606; mul 45 47; mul 83 608; add 607 609;
mul 52 608; mul 87 611; add 610 612; mul 49 608; mul 47 84; add 614 615; mul 91 616; add 613 617; mul 47 96; mul 95
619; add 618 620; input p 138; mul 119 590; add 622 623; mul 122 593; add 624 625; mul 125 597; add 626 627; mul 128
600; add 628 629; mul 131 605; add 630 631; mul 140 608; add 632 633; mul 143 611; add 634 635; mul 146 616; add 636
637; mul 91 619; add 638 639; mul 44 640; add 621 641; mul 42 642; le 170 168; le 168 170; add 644 645; div 275 646;
mul 644 647; le 169 10; le 10 169; add 649 650; div 275 651; mul 649 652; mul 648 653; mul 172 654; mul 476 654; mul
171 656; add 655 657; mul 167 658; mul 180 656; mul 179 660; add 659 661; mul 185 654; mul 184 663; add 662 664; mul
177 663; mul 179 666; add 665 667; mul 42 668; where 166 669; add 643 670; input p 139; mul 211 593; add 672 673;
mul 214 605; add 674 675; mul 223 611; add 676 677; mul 226 616; add 678 679; mul 229 619; add 680 681; input p 140;
mul 243 593; add 683 684; mul 246 600; add 685 686; mul 249 605; add 687 688; mul 256 616; add 689 690; mul 226 619;
add 691 692; mul 44 693; add 682 694; add 203 695; mul 200 696; mul 455 697; mul 178 297; mul 178 277; mul 287 700;
mul 287 288; mul 281 467; mul 285 703; div 275 285; mul 277 705; mul 284 706; add 704 707; mul 702 708; sub 701 709;
mul 274 710; mul 10 706; add 285 712; mul 287 713; mul 287 294; mul 708 715; sub 714 716; mul 292 717; add 711 718;
mul 699 719; mul 178 379; mul 235 590; mul 52 593; mul 237 723; add 722 724; mul 311 597; add 725 726; mul 52 600;
mul 314 728; add 727 729; mul 52 605; mul 318 731; add 730 732; mul 49 605; mul 47 69; add 734 735; mul 322 736; add
733 737; mul 209 608; add 738 739; mul 52 611; mul 211 741; add 740 742; mul 49 616; mul 47 92; add 744 745; mul 214
746; add 743 747; mul 52 619; mul 259 749; add 748 750; mul 49 619; mul 47 97; add 752 753; mul 343 754; add 751
755; mul 47 101; mul 264 757; add 756 758; add 357 361; add 355 760; add 360 761; mul 16 762; add 759 763; mul 200
764; mul 292 710; add 765 766; mul 274 717; sub 767 768; mul 721 769; add 720 770; mul 178 382; div 275 772; mul 771
773; mul 272 774; mul 178 775; mul 178 386; mul 178 385; div 275 778; mul 775 779; mul 387 780; mul 777 781; neg
782; mul 178 783; mul 387 784; mul 388 782; sub 785 786; sub 776 787; mul 273 788; mul 396 789; mul 392 775; mul 391
791; add 790 792; mul 400 775; mul 399 794; sub 793 795; mul 272 796; mul 407 797; mul 406 769; mul 272 782; mul 379
800; sub 799 801; mul 405 802; add 798 803; mul 178 418; mul 411 717; mul 413 710; sub 806 807; mul 805 808; mul 178
425; mul 411 710; add 765 811; mul 413 717; add 812 813; mul 810 814; add 809 815; mul 178 428; div 275 817; mul 816
818; mul 409 819; mul 178 820; mul 178 432; mul 178 431; div 275 823; mul 820 824; mul 433 825; mul 822 826; neg
827; mul 178 828; mul 433 829; mul 434 827; sub 830 831; sub 821 832; mul 410 833; mul 441 834; mul 438 820; mul 437
836; add 835 837; mul 445 820; mul 444 839; sub 838 840; mul 409 841; mul 452 842; mul 451 814; mul 409 827; mul 425
845; sub 844 846; mul 450 847; add 843 848; add 804 849; mul 270 850; sub 698 851; sub 671 852; mul 41 853; mul 459
797; mul 406 719; mul 297 800; sub 856 857; mul 405 858; add 855 859; mul 461 842; mul 451 808; mul 418 845; sub 862
863; mul 450 864; add 861 865; add 860 866; sub 854 867; sub 588 868; mul 469 717; mul 468 870; mul 467 467; mul 703
872; mul 287 873; mul 287 468; mul 708 875; add 874 876; mul 470 877; sub 871 878; mul 47 640; mul 42 880; mul 178
654; mul 479 882; mul 178 656; mul 478 884; mul 476 885; add 883 886; mul 481 656; add 887 888; mul 484 882; mul 481
654; mul 476 891; add 890 892; add 889 893; mul 487 882; add 894 895; mul 42 896; where 475 897; add 881 898; mul 47
693; add 356 900; mul 200 901; mul 455 902; mul 498 850; sub 903 904; sub 899 905; mul 507 797; mul 501 719; sub 766
768; mul 297 909; add 908 910; mul 503 769; mul 379 719; add 912 913; sub 911 914; mul 406 915; mul 505 800; sub 916
917; mul 468 918; mul 506 877; sub 919 920; mul 405 921; add 907 922; mul 515 842; mul 509 808; add 811 813; mul 418
926; add 925 927; mul 511 814; sub 807 806; mul 425 930; add 929 931; add 928 932; mul 451 933; mul 513 845; sub 934
935; mul 468 936; mul 514 877; sub 937 938; mul 450 939; add 924 940; add 923 941; add 906 942; add 30 943; sub 879
944; input p 141; mul 531 590; add 946 947; mul 534 593; add 948 949; mul 537 597; add 950 951; mul 122 600; add 952
953; mul 542 605; add 954 955; mul 51 608; add 956 957; mul 547 611; add 958 959; mul 64 616; add 960 961; mul 152
619; add 962 963; mul 42 964; input p 142; mul 567 593; add 966 967; mul 243 600; add 968 969; mul 318 605; add 970
971; mul 574 611; add 972 973; mul 259 619; add 974 975; add 359 976; mul 200 977; mul 455 978; mul 582 850; sub 979
980; sub 965 981; neg 982; mul 49 51; mul 53 178; mul 56 985; add 984 986; mul 61 64; add 987 988; mul 45 75; add
989 990; mul 76 178; mul 79 992; add 991 993; mul 84 87; add 994 995; mul 52 178; mul 108 997; add 105 998; mul 52
997; add 109 1000; mul 112 1001; add 999 1002; mul 49 119; add 1003 1004; mul 122 985; add 1005 1006; mul 61 128;
add 1007 1008; mul 45 51; add 1009 1010; mul 56 992; add 1011 1012; mul 84 143; add 1013 1014; mul 96 152; add 1015
1016; mul 44 1017; add 996 1018; mul 42 1019; mul 211 985; mul 220 992; add 1021 1022; mul 84 223; add 1023 1024;
mul 237 1001; add 235 1026; mul 243 985; add 1027 1028; mul 61 246; add 1029 1030; mul 211 992; add 1031 1032; mul
96 259; add 1033 1034; mul 44 1035; add 1025 1036; add 206 1037; mul 200 1038; mul 455 1039; mul 52 1001; add 113
1041; mul 302 1042; add 561 1043; add 565 1044; mul 52 985; add 57 1046; mul 237 1047; add 1045 1048; mul 65 178;
mul 314 1050; add 1049 1051; add 572 1052; mul 88 178; mul 211 1054; add 1053 1055; mul 153 178; mul 336 1057; add
1056 1058; add 579 1059; add 368 369; add 366 1061; mul 16 1062; add 1060 1063; mul 200 1064; mul 721 1065; mul 773
1066; mul 272 1067; mul 178 1068; mul 779 1068; mul 387 1070; mul 777 1071; neg 1072; mul 178 1073; mul 387 1074;
mul 388 1072; sub 1075 1076; sub 1069 1077; mul 273 1078; mul 396 1079; mul 392 1068; mul 391 1081; add 1080 1082;
mul 400 1068; mul 399 1084; sub 1083 1085; mul 272 1086; mul 407 1087; mul 406 1065; mul 272 1072; mul 379 1090; sub
1089 1091; mul 405 1092; add 1088 1093; mul 810 1065; mul 818 1095; mul 409 1096; mul 178 1097; mul 824 1097; mul
433 1099; mul 822 1100; neg 1101; mul 178 1102; mul 433 1103; mul 434 1101; sub 1104 1105; sub 1098 1106; mul 410
1107; mul 441 1108; mul 438 1097; mul 437 1110; add 1109 1111; mul 445 1097; mul 444 1113; sub 1112 1114; mul 409
1115; mul 452 1116; mul 451 1065; mul 409 1101; mul 425 1119; sub 1118 1120; mul 450 1121; add 1117 1122; add 1094
1123; mul 270 1124; sub 1040 1125; sub 1020 1126; mul 41 1127; mul 459 1087; mul 297 1090; mul 405 1130; sub 1129
1131; mul 461 1116; mul 418 1119; mul 450 1134; sub 1133 1135; add 1132 1136; sub 1128 1137; neg 1138; mul 47 1017;
mul 42 1140; mul 47 1035; add 359 1142; mul 200 1143; mul 455 1144; mul 498 1124; sub 1145 1146; sub 1141 1147; mul
507 1087; mul 503 1065; mul 406 1150; mul 505 1090; add 1151 1152; mul 468 1153; mul 405 1154; sub 1149 1155; mul
515 1116; mul 511 1065; mul 451 1158; mul 513 1119; sub 1159 1160; mul 468 1161; mul 450 1162; add 1157 1163; add
1156 1164; add 1148 1165; neg 1166; mul 523 997; add 521 1168; mul 526 1001; add 1169 1170; mul 49 531; add 1171
1172; mul 534 985; add 1173 1174; mul 61 122; add 1175 1176; mul 84 547; add 1177 1178; mul 79 96; add 1179 1180;
mul 42 1181; mul 562 1001; add 560 1183; mul 567 985; add 1184 1185; mul 61 243; add 1186 1187; mul 84 574; add 1188
1189; mul 96 220; add 1190 1191; add 367 1192; mul 200 1193; mul 455 1194; mul 582 1124; sub 1195 1196; sub 1182
1197; neg 1198; store forces 0 466; store forces 1 520; store forces 2 585; store by_shape 0 869; store by_shape 2
945; store by_shape 4 983; store by_shape 1 1139; store by_shape 3 1167; store by_shape 5 1199
    """,
)

INERTIA = Graph(
    {'x': 13, 'p': 143},
    {'mass': 3},
    """
input p 112; constant 1.0; input x 0; input p 110; mul 2 3; input x 2; input p 111; mul 5 6; add 4 7; mul 8 8; add 1
9; mul 0 10; input p 116; mul 2 6; input p 114; mul 5 14; add 13 15; mul 0 8; mul 16 17; add 12 18; input p 115; mul
0 16; mul 16 21; add 20 22; store mass 0 11; store mass 1 19; store mass 2 23
    """,
)
