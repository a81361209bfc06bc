"""The condensed joint: rates, forces at rest, inertia, stop operators after a step.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
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
    'stop_force_2', 'stop_force_3', 'stop_travel_0', 'stop_travel_1', 'stop_travel_2', 'stop_travel_3',
    'creep_stiffness_0', 'creep_stiffness_1', 'creep_rate_0', 'creep_rate_1', 'slope_ratio')

TIP_CONSTANTS = (('drag', 0.02, 1.2),)

TIP_DIMENSIONS = {'drag': (1, -1, 0, 0)}

CORRECTIONS = ('force', 'damping', 'left', 'right', 'moment', 'stiffness', 'left_moment', 'right_moment', 'loss',
    'moment_q', 'stiffness_q', 'left_moment_q', 'right_moment_q')

STATES = 13

MEMORIES = (('creep_0', 'm'), ('creep_1', 'm'))

FIRST_MEMORY = 11

AT_REST = (1.0, 1.0)

STOPS = 4

CREEPS = 2

BRANCHES = 3

PREPARE = Graph(
    {'k': 75},
    {'p': 145},
    """
input k 74; input k 0; constant 1.0; div 2 1; mul 0 3; constant -2.0; input k 2; mul 5 6; input k 33; input k 1;
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
input k 18; input k 17; input k 16; input k 27; input k 41; input k 36; input k 15; sub 156 2; input k 38; input k
37; input k 39; sub 160 1; constant 8.118473726939319e-05; input k 5; mul 162 163; constant -0.0004787100025195255;
mul 163 165; constant 0.0013605442176870743; mul 163 167; constant -0.003571428571428574; mul 163 169; constant
0.007142857142857142; mul 163 171; constant -0.0006802721088435403; mul 163 173; constant 0.0035714285714285787; mul
163 175; constant 0.014965986394557814; mul 163 177; constant -0.04285714285714284; mul 163 179; constant
0.06428571428571427; mul 163 181; constant -0.12857142857142845; mul 163 183; constant 0.2571428571428571; mul 163
185; input k 9; input k 10; input k 12; input k 11; input k 13; input k 14; input k 40; div 2 193; input k 42; input
k 43; input k 44; input k 45; input k 46; input k 47; input k 48; constant 0.029931972789115628; mul 163 202;
constant -0.08571428571428567; mul 163 204; constant 0.12857142857142853; mul 163 206; constant
-0.38571428571428534; mul 163 208; constant 1.0285714285714285; mul 163 210; constant 0.0027210884353741486; mul 163
212; constant -0.010714285714285721; mul 163 214; constant 0.028571428571428567; mul 163 216; constant
0.010714285714285735; mul 163 218; input k 54; input k 50; input k 49; input k 51; input k 52; sub 224 1; input k
53; div 2 226; input k 55; input k 56; input k 57; input k 58; input k 59; input k 60; input k 61; input k 29; input
k 62; input k 35; input k 66; div 2 238; input k 63; input k 67; div 2 241; input k 64; input k 68; div 2 244; input
k 65; input k 69; div 2 247; input k 34; input k 70; input k 71; input k 24; input k 25; input k 21; mul 149 253;
input k 26; input k 23; input k 22; input k 20; input k 28; mul 153 260; constant 0.8000000000000002; constant
2.400000000000001; mul 15 263; add 262 264; constant 0.01904761904761903; mul 20 266; add 265 267; constant
-1.3714285714285723; mul 26 269; constant 1.3714285714285714; mul 14 271; constant 0.007256235827664418; mul 19 273;
add 272 274; constant -4.799999999999999; mul 26 276; constant 1.3714285714285692; mul 14 278; constant
-0.05714285714285729; mul 19 280; add 279 281; constant -7.199999999999996; mul 26 283; constant 7.199999999999994;
mul 14 285; constant 0.2190476190476189; mul 19 287; add 286 288; constant -45.25714285714286; mul 14 290; constant
-0.11428571428571327; mul 19 292; add 291 293; constant -28.800000000000004; mul 26 295; constant
0.00032473894907757275; mul 163 297; constant -0.0014361300075585765; mul 163 299; constant -0.0013605442176870806;
mul 163 301; constant 0.8; mul 6 303; div 2 304; input k 30; input k 31; input k 32; input k 72; input k 73; mul 22
24; mul 24 102; mul 18 24; mul 24 100; mul 24 88; mul 24 87; store p 0 4; store p 1 7; store p 2 8; store p 3 3;
store p 4 9; store p 5 22; store p 6 23; store p 7 24; store p 8 27; store p 9 32; store p 10 34; store p 11 39;
store p 12 44; store p 13 51; store p 14 53; store p 15 58; store p 16 60; store p 17 65; store p 18 70; store p 19
75; store p 20 80; store p 21 86; store p 22 88; store p 23 90; store p 24 95; store p 25 102; store p 26 104; store
p 27 109; store p 28 113; store p 29 118; store p 30 123; store p 31 125; store p 32 130; store p 33 135; store p 34
137; store p 35 142; store p 36 147; store p 37 148; store p 38 150; store p 39 151; store p 40 152; store p 41 1;
store p 42 187; store p 43 188; store p 44 189; store p 45 174; store p 46 176; store p 47 203; store p 48 205;
store p 49 207; store p 50 209; store p 51 211; store p 52 166; store p 53 213; store p 54 215; store p 55 217;
store p 56 219; store p 57 180; store p 58 184; store p 59 153; store p 60 161; store p 61 164; store p 62 168;
store p 63 170; store p 64 172; store p 65 178; store p 66 182; store p 67 186; store p 68 190; store p 69 191;
store p 70 192; store p 71 157; store p 72 156; store p 73 159; store p 74 155; store p 75 194; store p 76 158;
store p 77 154; store p 78 195; store p 79 196; store p 80 197; store p 81 198; store p 82 199; store p 83 200;
store p 84 201; store p 85 225; store p 86 221; store p 87 222; store p 88 227; store p 89 223; store p 90 220;
store p 91 228; store p 92 229; store p 93 230; store p 94 231; store p 95 232; store p 96 233; store p 97 234;
store p 98 6; store p 99 235; store p 100 236; store p 101 237; store p 102 239; store p 103 240; store p 104 242;
store p 105 243; store p 106 245; store p 107 246; store p 108 248; store p 109 249; store p 110 250; store p 111
251; store p 112 252; store p 113 253; store p 114 254; store p 115 255; store p 116 256; store p 117 257; store p
118 258; store p 119 259; store p 120 261; store p 121 268; store p 122 270; store p 123 275; store p 124 277; store
p 125 282; store p 126 284; store p 127 289; store p 128 294; store p 129 296; store p 130 298; store p 131 300;
store p 132 302; store p 133 305; store p 134 306; store p 135 307; store p 136 308; store p 137 309; store p 138
310; store p 139 311; store p 140 312; store p 141 313; store p 142 314; store p 143 315; store p 144 316
    """,
)

RATES = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'start': 2, 'p': 145},
    {'rates': 13},
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
input p 78; constant 1.4; sub 397 410; mul 409 411; add 364 412; mul 408 413; input p 79; mul 3 415; input p 80; mul
411 417; add 364 418; mul 416 419; sub 414 420; mul 386 421; input p 81; input x 5; mul 423 424; input p 82; input x
7; mul 426 427; add 425 428; input p 83; input x 9; mul 430 431; add 429 432; constant -0.5; mul 399 434; mul 399
435; mul 399 436; mul 386 437; mul 433 438; add 422 439; input p 84; mul 438 441; mul 438 442; sub 379 384; mul 392
444; add 387 390; mul 385 446; sub 445 447; mul 401 448; div 364 373; mul 376 450; mul 449 451; mul 42 452; mul 392
401; mul 0 454; sub 453 455; mul 0 56; mul 285 457; mul 62 281; add 349 459; mul 215 460; mul 42 461; add 458 462;
mul 402 463; add 456 464; mul 443 465; add 440 466; mul 402 467; input p 85; add 362 469; input p 86; mul 377 471;
add 470 472; input p 87; mul 383 474; add 473 475; input p 88; mul 383 471; mul 377 474; input p 89; sub 479 480;
sub 478 481; sub 482 12; mul 483 483; mul 476 476; add 484 485; sqrt 486; mul 477 487; sqrt 488; div 364 489; mul
490 490; mul 477 491; mul 476 492; input p 90; mul 193 488; mul 193 491; mul 491 496; sub 495 497; mul 494 498;
input p 91; sub 488 410; mul 500 501; add 364 502; mul 499 503; input p 92; mul 7 505; input p 93; mul 501 507; add
364 508; mul 506 509; sub 504 510; mul 477 511; input p 94; input x 6; mul 513 514; input p 95; input x 8; mul 516
517; add 515 518; input p 96; input x 10; mul 520 521; add 519 522; mul 434 490; mul 490 524; mul 490 525; mul 477
526; mul 523 527; add 512 528; input p 97; mul 527 530; mul 527 531; add 472 475; mul 483 533; sub 479 478; mul 476
535; add 534 536; mul 492 537; mul 451 538; mul 42 539; mul 483 492; mul 0 541; sub 540 542; mul 463 493; add 543
544; mul 532 545; add 529 546; mul 493 547; add 468 548; sub 286 549; mul 285 550; sub 214 551; input p 98; constant
12.0; mul 457 554; constant -6.0; mul 59 457; mul 42 62; add 557 558; mul 556 559; add 555 560; mul 553 561; mul 457
556; constant 4.0; mul 559 564; add 563 565; mul 553 566; mul 59 567; add 562 568; add 552 569; mul 56 570; mul 454
467; mul 541 547; add 572 573; sub 571 574; sub 55 575; input p 99; input p 100; constant -1.0; input z 0; input
start 0; sub 12 581; input p 101; input start 1; sub 10 584; mul 583 585; add 582 586; input p 102; mul 587 588; add
580 589; max 579 590; min 364 591; mul 578 592; input p 103; input z 1; input p 104; mul 587 596; add 595 597; max
579 598; min 364 599; mul 594 600; add 593 601; input p 105; input z 2; input p 106; mul 587 605; add 604 606; max
579 607; min 364 608; mul 603 609; add 602 610; input p 107; input z 3; input p 108; mul 587 614; add 613 615; max
579 616; min 364 617; mul 612 618; add 611 619; sub 577 620; input p 109; abs 0; mul 622 623; mul 0 624; sub 621
625; add 576 626; input p 110; input x 11; sub 12 629; mul 628 630; input p 111; input x 12; sub 12 633; mul 632
634; add 631 635; sub 627 636; input p 112; mul 12 638; input p 113; mul 10 640; add 639 641; input p 114; mul 0
638; input p 115; mul 42 645; add 644 646; mul 0 647; input p 116; mul 42 649; mul 42 650; add 648 651; mul 643 652;
mul 642 653; sub 637 654; input p 117; mul 12 640; mul 10 649; add 657 658; mul 643 659; mul 659 660; add 656 661;
mul 655 662; input p 118; mul 642 643; mul 659 665; add 664 666; mul 62 175; mul 57 668; abs 10; lt 670 183; mul 186
193; mul 187 193; input p 119; mul 673 674; mul 672 675; mul 182 192; mul 187 677; add 676 678; mul 186 677; mul 672
680; add 679 681; mul 195 199; mul 672 683; add 682 684; mul 192 199; mul 200 686; add 685 687; mul 57 688; where
671 689; add 669 690; mul 461 550; sub 691 692; mul 62 567; add 693 694; mul 452 467; mul 539 547; add 696 697; add
695 698; sub 46 699; input p 120; mul 383 701; mul 451 702; add 700 703; mul 583 620; sub 704 705; mul 653 659; sub
706 707; mul 667 708; sub 663 709; mul 642 642; add 364 711; mul 643 712; mul 662 713; mul 667 667; sub 714 715; div
364 716; mul 710 717; mul 708 713; mul 655 667; sub 719 720; mul 717 721; input p 121; mul 67 723; input p 122; mul
124 725; add 724 726; input p 123; mul 128 728; add 727 729; mul 64 120; add 730 731; input p 124; mul 68 733; add
732 734; input p 125; mul 72 736; add 735 737; input p 126; mul 76 739; add 738 740; mul 80 137; add 741 742; input
p 127; mul 84 744; add 743 745; mul 66 99; add 746 747; input p 128; mul 103 749; add 748 750; mul 79 107; add 751
752; input p 129; mul 111 754; add 753 755; mul 94 168; add 756 757; mul 112 167; add 758 759; mul 57 760; constant
0.01904761904761903; mul 67 762; input p 130; mul 128 764; add 763 765; mul 64 250; add 766 767; input p 131; mul 72
769; add 768 770; mul 80 258; add 771 772; mul 84 306; add 773 774; input p 132; mul 103 776; add 775 777; mul 168
235; add 778 779; mul 112 274; add 780 781; add 357 782; mul 215 783; mul 550 784; sub 761 785; input p 133; mul 786
787; neg 788; mul 438 465; input p 134; mul 424 791; sub 790 792; mul 527 545; mul 514 791; sub 794 795; input p
135; mul 427 797; sub 790 798; mul 517 797; sub 794 800; input p 136; mul 431 802; sub 790 803; mul 521 802; sub 794
805; input p 137; mul 630 807; input p 138; mul 634 809; store rates 0 0; store rates 1 718; store rates 2 42; store
rates 3 722; store rates 4 789; store rates 5 793; store rates 6 796; store rates 7 799; store rates 8 801; store
rates 9 804; store rates 10 806; store rates 11 808; store rates 12 810
    """,
)

SHAPE = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'p': 145},
    {'forces': 3, 'by_shape': 6},
    """
input p 99; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
input p 0; input x 0; mul 11 12; sub 10 13; input c 9; constant 0.5; input c 10; mul 16 17; mul 14 18; sub 15 19;
input c 11; mul 3 21; add 20 22; input c 12; mul 7 24; add 23 25; mul 14 26; add 9 27; input c 4; input c 5; mul 14
30; sub 29 31; input c 6; mul 3 33; add 32 34; input c 7; mul 7 36; add 35 37; mul 11 38; sub 28 39; input p 3;
input p 4; input p 5; input p 6; mul 12 41; mul 44 45; input p 7; mul 10 47; add 46 48; mul 43 49; input p 8; input
x 4; mul 49 52; mul 51 53; add 50 54; input p 9; mul 52 53; mul 56 57; add 55 58; input p 10; mul 49 49; mul 60 61;
add 59 62; input p 11; mul 52 61; mul 64 65; add 63 66; input p 12; mul 49 61; mul 68 69; add 67 70; input p 13; mul
45 72; add 71 73; input p 14; mul 45 52; mul 75 76; add 74 77; input p 15; mul 52 76; mul 79 80; add 78 81; input p
16; mul 45 49; mul 83 84; add 82 85; input p 17; mul 52 84; mul 87 88; add 86 89; input p 18; mul 49 84; mul 91 92;
add 90 93; input p 19; mul 45 45; mul 49 96; mul 95 97; add 94 98; input p 20; mul 45 96; mul 100 101; add 99 102;
input p 21; input p 22; mul 52 105; add 104 106; input p 23; mul 52 52; mul 108 109; add 107 110; input p 24; mul 52
109; mul 112 113; add 111 114; input p 25; mul 49 116; add 115 117; input p 26; mul 53 119; add 118 120; input p 27;
mul 57 122; add 121 123; input p 28; mul 61 125; add 124 126; input p 29; mul 65 128; add 127 129; input p 30; mul
69 131; add 130 132; mul 43 45; add 133 134; mul 51 76; add 135 136; mul 56 80; add 137 138; input p 31; mul 84 140;
add 139 141; input p 32; mul 88 143; add 142 144; input p 33; mul 92 146; add 145 147; input p 34; mul 96 149; add
148 150; input p 35; mul 52 96; mul 152 153; add 151 154; mul 91 97; add 155 156; input p 36; mul 101 158; add 157
159; mul 44 160; add 103 161; mul 42 162; abs 45; constant 0.35; lt 164 165; input p 37; constant 0.6; constant
-0.6; max 169 10; min 168 170; mul 171 171; mul 171 172; mul 167 173; constant -0.35; max 175 45; min 165 176;
constant 2.0; mul 177 178; input p 38; mul 172 180; mul 179 181; add 174 182; mul 177 177; input p 39; mul 171 185;
mul 184 186; add 183 187; mul 177 186; mul 179 189; add 188 190; mul 178 184; input p 40; mul 192 193; mul 179 194;
add 191 195; mul 42 196; where 166 197; add 163 198; input p 41; input p 42; mul 45 201; input p 43; mul 10 203; add
202 204; input p 44; mul 52 206; add 205 207; constant -0.09999999999999995; mul 49 209; input p 45; mul 57 211; add
210 212; input p 46; mul 69 214; add 213 215; constant 1.2; mul 45 217; add 216 218; input p 47; mul 80 220; add 219
221; input p 48; mul 88 223; add 222 224; input p 49; mul 92 226; add 225 227; input p 50; mul 97 229; add 228 230;
input p 51; mul 101 232; add 231 233; constant -0.033333333333333326; mul 52 235; input p 52; mul 113 237; add 236
238; constant 0.13333333333333333; mul 49 240; add 239 241; input p 53; mul 57 243; add 242 244; input p 54; mul 65
246; add 245 247; input p 55; mul 69 249; add 248 250; mul 45 209; add 251 252; mul 80 211; add 253 254; input p 56;
mul 92 256; add 255 257; input p 57; mul 153 259; add 258 260; mul 97 226; add 261 262; input p 58; mul 101 264; add
263 265; mul 44 266; add 234 267; add 208 268; mul 200 269; input p 59; input p 75; input p 77; input p 74; constant
1.0; input p 71; mul 10 276; mul 10 277; add 275 278; input p 72; mul 10 280; mul 10 281; add 275 282; sqrt 283;
sqrt 279; mul 284 285; div 275 286; mul 279 287; mul 274 288; input p 76; sub 289 290; input p 73; mul 10 285; mul
287 293; mul 292 294; add 291 295; sub 296 12; mul 297 297; input p 60; constant 0.009523809523809514; mul 109 300;
input p 61; mul 52 113; mul 302 303; add 301 304; mul 53 235; add 305 306; mul 52 57; mul 237 308; add 307 309;
constant 0.06666666666666667; mul 61 311; add 310 312; input p 62; mul 52 65; mul 314 315; add 313 316; input p 63;
mul 52 69; mul 318 319; add 317 320; input p 64; mul 49 69; mul 322 323; add 321 324; mul 84 209; add 325 326; mul
52 88; mul 211 328; add 327 329; mul 49 92; mul 214 331; add 330 332; mul 96 168; add 333 334; input p 65; mul 52
153; mul 336 337; add 335 338; mul 52 97; mul 259 340; add 339 341; input p 66; mul 49 97; mul 343 344; add 342 345;
mul 49 101; mul 264 347; add 346 348; input p 67; mul 45 101; mul 350 351; add 349 352; mul 45 208; mul 45 203;
input p 68; mul 10 356; add 355 357; input p 69; mul 52 359; add 358 360; mul 10 361; add 354 362; mul 45 206; mul
10 359; add 364 365; input p 70; mul 52 367; add 366 368; mul 52 369; add 363 370; mul 16 371; add 353 372; mul 200
373; add 299 374; mul 288 292; add 375 376; mul 274 294; sub 377 378; mul 379 379; add 298 380; sqrt 381; mul 272
382; mul 178 383; sqrt 383; div 275 385; mul 386 386; mul 178 387; mul 387 388; sub 384 389; mul 273 390; input p
78; constant 1.4; sub 383 393; mul 392 394; add 275 395; mul 391 396; input p 79; mul 3 398; input p 80; mul 394
400; add 275 401; mul 399 402; sub 397 403; mul 272 404; mul 272 387; mul 379 406; mul 405 407; input p 88; input p
90; input p 86; mul 294 411; input p 87; mul 288 413; input p 89; sub 414 415; sub 412 416; sub 417 12; mul 418 418;
input p 85; add 374 420; mul 288 411; add 421 422; mul 294 413; add 423 424; mul 425 425; add 419 426; sqrt 427; mul
409 428; mul 178 429; sqrt 429; div 275 431; mul 432 432; mul 178 433; mul 433 434; sub 430 435; mul 410 436; input
p 91; sub 429 393; mul 438 439; add 275 440; mul 437 441; input p 92; mul 7 443; input p 93; mul 439 445; add 275
446; mul 444 447; sub 442 448; mul 409 449; mul 409 433; mul 425 451; mul 450 452; add 408 453; sub 271 454; mul 270
455; sub 199 456; mul 41 457; mul 297 406; mul 405 459; mul 418 451; mul 450 461; add 460 462; sub 458 463; sub 40
464; add 0 465; div 275 284; mul 287 467; input p 120; mul 294 469; mul 468 470; mul 47 160; mul 42 472; abs 10; lt
474 168; mul 171 178; mul 172 178; input p 119; mul 477 478; mul 476 479; mul 167 177; mul 172 481; add 480 482; mul
171 481; mul 476 484; add 483 485; mul 180 184; mul 476 487; add 486 488; mul 177 184; mul 185 490; add 489 491; mul
42 492; where 475 493; add 473 494; mul 47 266; add 361 496; mul 200 497; mul 455 498; sub 495 499; sub 376 378; mul
297 501; add 289 295; mul 379 503; sub 502 504; mul 406 505; mul 468 506; mul 405 507; add 422 424; mul 418 509; sub
414 412; mul 425 511; add 510 512; mul 451 513; mul 468 514; mul 450 515; add 508 516; add 500 517; sub 38 518; add
471 519; input p 121; mul 52 521; input p 122; mul 109 523; add 522 524; input p 123; mul 113 526; add 525 527; mul
49 105; add 528 529; input p 124; mul 53 531; add 530 532; input p 125; mul 57 534; add 533 535; input p 126; mul 61
537; add 536 538; mul 65 122; add 539 540; input p 127; mul 69 542; add 541 543; mul 51 84; add 544 545; input p
128; mul 88 547; add 546 548; mul 64 92; add 549 550; input p 129; mul 96 552; add 551 553; mul 79 153; add 554 555;
mul 97 152; add 556 557; mul 42 558; constant 0.01904761904761903; mul 52 560; input p 130; mul 113 562; add 561
563; mul 49 235; add 564 565; input p 131; mul 57 567; add 566 568; mul 65 243; add 569 570; mul 69 318; add 571
572; input p 132; mul 88 574; add 573 575; mul 153 220; add 576 577; mul 97 259; add 578 579; add 369 580; mul 200
581; mul 455 582; sub 559 583; neg 584; sub 26 19; mul 11 30; add 586 587; input p 139; mul 47 52; mul 51 590; add
589 591; mul 52 590; mul 56 593; add 592 594; mul 49 178; mul 47 596; mul 60 597; add 595 598; mul 52 597; mul 64
600; add 599 601; mul 49 597; mul 47 61; add 603 604; mul 68 605; add 602 606; mul 45 47; mul 83 608; add 607 609;
mul 52 608; mul 87 611; add 610 612; mul 49 608; mul 47 84; add 614 615; mul 91 616; add 613 617; mul 47 96; mul 95
619; add 618 620; input p 140; mul 119 590; add 622 623; mul 122 593; add 624 625; mul 125 597; add 626 627; mul 128
600; add 628 629; mul 131 605; add 630 631; mul 140 608; add 632 633; mul 143 611; add 634 635; mul 146 616; add 636
637; mul 91 619; add 638 639; mul 44 640; add 621 641; mul 42 642; le 170 168; le 168 170; add 644 645; div 275 646;
mul 644 647; le 169 10; le 10 169; add 649 650; div 275 651; mul 649 652; mul 648 653; mul 172 654; mul 476 654; mul
171 656; add 655 657; mul 167 658; mul 180 656; mul 179 660; add 659 661; mul 185 654; mul 184 663; add 662 664; mul
177 663; mul 179 666; add 665 667; mul 42 668; where 166 669; add 643 670; input p 141; mul 211 593; add 672 673;
mul 214 605; add 674 675; mul 223 611; add 676 677; mul 226 616; add 678 679; mul 229 619; add 680 681; input p 142;
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
944; input p 143; mul 531 590; add 946 947; mul 534 593; add 948 949; mul 537 597; add 950 951; mul 122 600; add 952
953; mul 542 605; add 954 955; mul 51 608; add 956 957; mul 547 611; add 958 959; mul 64 616; add 960 961; mul 152
619; add 962 963; mul 42 964; input p 144; mul 567 593; add 966 967; mul 243 600; add 968 969; mul 318 605; add 970
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
    {'x': 13, 'p': 145},
    {'mass': 3},
    """
input p 114; constant 1.0; input x 0; input p 112; mul 2 3; input x 2; input p 113; mul 5 6; add 4 7; mul 8 8; add 1
9; mul 0 10; input p 118; mul 2 6; input p 116; mul 5 14; add 13 15; mul 0 8; mul 16 17; add 12 18; input p 117; mul
0 16; mul 16 21; add 20 22; store mass 0 11; store mass 1 19; store mass 2 23
    """,
)

STOP_MOVE = Graph(
    {'x': 13, 'z': 4, 'start': 2, 'p': 145},
    {'moved': 4},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 101; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 102; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 104; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 106; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
108; mul 11 30; add 29 31; max 1 32; min 0 33; store moved 0 16; store moved 1 22; store moved 2 28; store moved 3
34
    """,
)
