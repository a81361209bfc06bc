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
    'relaxation_1', 'relaxation_2', 'viscosity', 'drag', 'sliding_force', 'sliding_speed', 'friction_arm',
    'left_a', 'left_c', 'left_e_z', 'left_e_x', 'left_l0', 'left_elastic', 'left_hardening',
    'left_hardening_slope', 'left_electric', 'left_electric_slope', 'left_maxwell_0', 'left_maxwell_1',
    'left_maxwell_2', 'left_viscous', 'right_a', 'right_c', 'right_e_z', 'right_e_x', 'right_l0', 'right_elastic',
    'right_hardening', 'right_hardening_slope', 'right_electric', 'right_electric_slope', 'right_maxwell_0',
    'right_maxwell_1', 'right_maxwell_2', 'right_viscous', 'stop_force_0', 'stop_force_1', 'stop_force_2',
    'stop_force_3', 'stop_travel_0', 'stop_travel_1', 'stop_travel_2', 'stop_travel_3', 'creep_stiffness_0',
    'creep_stiffness_1', 'creep_rate_0', 'creep_rate_1', 'slope_ratio')

TIP_CONSTANTS = (('drag', 0.02, 1.2), ('sliding_force', 0.0001, 1.2), ('sliding_speed', 0.006, 0.5))

TIP_DIMENSIONS = {'drag': (1, -1, 0, 0), 'sliding_force': (1, 1, -2, 0), 'sliding_speed': (0, 1, -1, 0)}

CORRECTIONS = ('force', 'damping', 'left', 'right', 'moment', 'stiffness', 'left_moment', 'right_moment', 'loss',
    'moment_q', 'stiffness_q', 'left_moment_q', 'right_moment_q')

STATES = 13

ELEMENT_STATES = (('creep_0', 'm'), ('creep_1', 'm'))

FIRST_ELEMENT = 11

DRY_LEVELS = ('sliding_force',)

AT_REST = (1.0, 1.0)

STOPS = 4

CREEPS = 2

BRANCHES = 3

PREPARE = Graph(
    {'k': 79},
    {'p': 149},
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
56; div 2 227; input k 58; input k 59; input k 60; input k 61; input k 62; input k 63; input k 64; input k 65; input
k 29; input k 66; input k 37; input k 70; div 2 240; input k 67; input k 71; div 2 243; input k 68; input k 72; div
2 246; input k 69; input k 73; div 2 249; input k 34; input k 35; input k 36; mul 253 253; input k 74; input k 75;
input k 24; input k 25; input k 21; mul 149 258; input k 26; input k 23; input k 22; input k 20; input k 28; mul 153
265; constant 0.8000000000000002; constant 2.400000000000001; mul 15 268; add 267 269; constant 0.01904761904761903;
mul 20 271; add 270 272; constant -1.3714285714285723; mul 26 274; constant 1.3714285714285714; mul 14 276; constant
0.007256235827664418; mul 19 278; add 277 279; constant -4.799999999999999; mul 26 281; constant 1.3714285714285692;
mul 14 283; constant -0.05714285714285729; mul 19 285; add 284 286; constant -7.199999999999996; mul 26 288;
constant 7.199999999999994; mul 14 290; constant 0.2190476190476189; mul 19 292; add 291 293; constant
-45.25714285714286; mul 14 295; constant -0.11428571428571327; mul 19 297; add 296 298; constant
-28.800000000000004; mul 26 300; constant 0.00032473894907757275; mul 163 302; constant -0.0014361300075585765; mul
163 304; constant -0.0013605442176870806; mul 163 306; constant 0.8; mul 6 308; div 2 309; input k 30; input k 31;
input k 32; input k 76; input k 77; mul 22 24; mul 24 102; mul 18 24; mul 24 100; mul 24 88; mul 24 87; store p 0 4;
store p 1 7; store p 2 8; store p 3 3; store p 4 9; store p 5 22; store p 6 23; store p 7 24; store p 8 27; store p
9 32; store p 10 34; store p 11 39; store p 12 44; store p 13 51; store p 14 53; store p 15 58; store p 16 60; store
p 17 65; store p 18 70; store p 19 75; store p 20 80; store p 21 86; store p 22 88; store p 23 90; store p 24 95;
store p 25 102; store p 26 104; store p 27 109; store p 28 113; store p 29 118; store p 30 123; store p 31 125;
store p 32 130; store p 33 135; store p 34 137; store p 35 142; store p 36 147; store p 37 148; store p 38 150;
store p 39 151; store p 40 152; store p 41 1; store p 42 187; store p 43 188; store p 44 189; store p 45 174; store
p 46 176; store p 47 204; store p 48 206; store p 49 208; store p 50 210; store p 51 212; store p 52 166; store p 53
214; store p 54 216; store p 55 218; store p 56 220; store p 57 180; store p 58 184; store p 59 153; store p 60 161;
store p 61 164; store p 62 168; store p 63 170; store p 64 172; store p 65 178; store p 66 182; store p 67 186;
store p 68 190; store p 69 191; store p 70 192; store p 71 157; store p 72 156; store p 73 159; store p 74 155;
store p 75 194; store p 76 158; store p 77 154; store p 78 195; store p 79 196; store p 80 197; store p 81 198;
store p 82 199; store p 83 200; store p 84 201; store p 85 202; store p 86 226; store p 87 222; store p 88 223;
store p 89 228; store p 90 224; store p 91 221; store p 92 229; store p 93 230; store p 94 231; store p 95 232;
store p 96 233; store p 97 234; store p 98 235; store p 99 236; store p 100 6; store p 101 237; store p 102 238;
store p 103 239; store p 104 241; store p 105 242; store p 106 244; store p 107 245; store p 108 247; store p 109
248; store p 110 250; store p 111 251; store p 112 252; store p 113 254; store p 114 255; store p 115 256; store p
116 257; store p 117 258; store p 118 259; store p 119 260; store p 120 261; store p 121 262; store p 122 263; store
p 123 264; store p 124 266; store p 125 273; store p 126 275; store p 127 280; store p 128 282; store p 129 287;
store p 130 289; store p 131 294; store p 132 299; store p 133 301; store p 134 303; store p 135 305; store p 136
307; store p 137 310; store p 138 311; store p 139 312; store p 140 313; store p 141 314; store p 142 315; store p
143 316; store p 144 317; store p 145 318; store p 146 319; store p 147 320; store p 148 321
    """,
)

RATES = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'start': 2, 'p': 149},
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
constant 0.3; constant -0.3; constant 1.4; sub 397 411; max 410 412; min 409 413; input p 78; input p 79; mul 414
416; add 415 417; mul 414 418; add 364 419; mul 408 420; input p 80; mul 3 422; input p 81; mul 412 424; add 364
425; mul 423 426; sub 421 427; mul 386 428; input p 82; input x 5; mul 430 431; input p 83; input x 7; mul 433 434;
add 432 435; input p 84; input x 9; mul 437 438; add 436 439; constant -0.5; mul 399 441; mul 399 442; mul 399 443;
mul 386 444; mul 440 445; add 429 446; input p 85; mul 445 448; mul 445 449; sub 379 384; mul 392 451; add 387 390;
mul 385 453; sub 452 454; mul 401 455; div 364 373; mul 376 457; mul 456 458; mul 42 459; mul 392 401; mul 0 461;
sub 460 462; mul 0 56; mul 285 464; mul 62 281; add 349 466; mul 215 467; mul 42 468; add 465 469; mul 402 470; add
463 471; mul 450 472; add 447 473; mul 402 474; input p 86; add 362 476; input p 87; mul 377 478; add 477 479; input
p 88; mul 383 481; add 480 482; input p 89; mul 383 478; mul 377 481; input p 90; sub 486 487; sub 485 488; sub 489
12; mul 490 490; mul 483 483; add 491 492; sqrt 493; mul 484 494; sqrt 495; div 364 496; mul 497 497; mul 484 498;
mul 483 499; input p 91; mul 193 495; mul 193 498; mul 498 503; sub 502 504; mul 501 505; sub 495 411; max 410 507;
min 409 508; input p 92; input p 93; mul 509 511; add 510 512; mul 509 513; add 364 514; mul 506 515; input p 94;
mul 7 517; input p 95; mul 507 519; add 364 520; mul 518 521; sub 516 522; mul 484 523; input p 96; input x 6; mul
525 526; input p 97; input x 8; mul 528 529; add 527 530; input p 98; input x 10; mul 532 533; add 531 534; mul 441
497; mul 497 536; mul 497 537; mul 484 538; mul 535 539; add 524 540; input p 99; mul 539 542; mul 539 543; add 479
482; mul 490 545; sub 486 485; mul 483 547; add 546 548; mul 499 549; mul 458 550; mul 42 551; mul 490 499; mul 0
553; sub 552 554; mul 470 500; add 555 556; mul 544 557; add 541 558; mul 500 559; add 475 560; sub 286 561; mul 285
562; sub 214 563; input p 100; constant 12.0; mul 464 566; constant -6.0; mul 59 464; mul 42 62; add 569 570; mul
568 571; add 567 572; mul 565 573; mul 464 568; constant 4.0; mul 571 576; add 575 577; mul 565 578; mul 59 579; add
574 580; add 564 581; mul 56 582; mul 461 474; mul 553 559; add 584 585; sub 583 586; sub 55 587; input p 101; input
p 102; constant -1.0; input z 0; input start 0; sub 12 593; input p 103; input start 1; sub 10 596; mul 595 597; add
594 598; input p 104; mul 599 600; add 592 601; max 591 602; min 364 603; mul 590 604; input p 105; input z 1; input
p 106; mul 599 608; add 607 609; max 591 610; min 364 611; mul 606 612; add 605 613; input p 107; input z 2; input p
108; mul 599 617; add 616 618; max 591 619; min 364 620; mul 615 621; add 614 622; input p 109; input z 3; input p
110; mul 599 626; add 625 627; max 591 628; min 364 629; mul 624 630; add 623 631; sub 589 632; input p 111; abs 0;
mul 634 635; mul 0 636; input p 112; mul 0 638; mul 0 0; input p 113; add 640 641; sqrt 642; div 364 643; mul 639
644; add 637 645; sub 633 646; add 588 647; input p 114; input x 11; sub 12 650; mul 649 651; input p 115; input x
12; sub 12 654; mul 653 655; add 652 656; sub 648 657; input p 116; mul 12 659; input p 117; mul 10 661; add 660
662; input p 118; mul 0 659; input p 119; mul 42 666; add 665 667; mul 0 668; input p 120; mul 42 670; mul 42 671;
add 669 672; mul 664 673; mul 663 674; sub 658 675; input p 121; mul 12 661; mul 10 670; add 678 679; mul 664 680;
mul 680 681; add 677 682; mul 676 683; input p 122; mul 663 664; mul 680 686; add 685 687; mul 62 175; mul 57 689;
abs 10; lt 691 183; mul 186 193; mul 187 193; input p 123; mul 694 695; mul 693 696; mul 182 192; mul 187 698; add
697 699; mul 186 698; mul 693 701; add 700 702; mul 195 199; mul 693 704; add 703 705; mul 192 199; mul 200 707; add
706 708; mul 57 709; where 692 710; add 690 711; mul 468 562; sub 712 713; mul 62 579; add 714 715; mul 459 474; mul
551 559; add 717 718; add 716 719; sub 46 720; input p 124; mul 383 722; mul 458 723; add 721 724; mul 595 632; sub
725 726; mul 674 680; sub 727 728; mul 688 729; sub 684 730; mul 663 663; add 364 732; mul 664 733; mul 683 734; mul
688 688; sub 735 736; div 364 737; mul 731 738; mul 729 734; mul 676 688; sub 740 741; mul 738 742; input p 125; mul
67 744; input p 126; mul 124 746; add 745 747; input p 127; mul 128 749; add 748 750; mul 64 120; add 751 752; input
p 128; mul 68 754; add 753 755; input p 129; mul 72 757; add 756 758; input p 130; mul 76 760; add 759 761; mul 80
137; add 762 763; input p 131; mul 84 765; add 764 766; mul 66 99; add 767 768; input p 132; mul 103 770; add 769
771; mul 79 107; add 772 773; input p 133; mul 111 775; add 774 776; mul 94 168; add 777 778; mul 112 167; add 779
780; mul 57 781; constant 0.01904761904761903; mul 67 783; input p 134; mul 128 785; add 784 786; mul 64 250; add
787 788; input p 135; mul 72 790; add 789 791; mul 80 258; add 792 793; mul 84 306; add 794 795; input p 136; mul
103 797; add 796 798; mul 168 235; add 799 800; mul 112 274; add 801 802; add 357 803; mul 215 804; mul 562 805; sub
782 806; input p 137; mul 807 808; neg 809; mul 445 472; input p 138; mul 431 812; sub 811 813; mul 539 557; mul 526
812; sub 815 816; input p 139; mul 434 818; sub 811 819; mul 529 818; sub 815 821; input p 140; mul 438 823; sub 811
824; mul 533 823; sub 815 826; input p 141; mul 651 828; input p 142; mul 655 830; store rates 0 0; store rates 1
739; store rates 2 42; store rates 3 743; store rates 4 810; store rates 5 814; store rates 6 817; store rates 7
820; store rates 8 822; store rates 9 825; store rates 10 827; store rates 11 829; store rates 12 831
    """,
)

SHAPE = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'p': 149},
    {'forces': 3, 'by_shape': 6},
    """
input p 101; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
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
382; mul 178 383; sqrt 383; div 275 385; mul 386 386; mul 178 387; mul 387 388; sub 384 389; mul 273 390; constant
0.3; constant -0.3; constant 1.4; sub 383 394; max 393 395; min 392 396; input p 78; input p 79; mul 397 399; add
398 400; mul 397 401; add 275 402; mul 391 403; input p 80; mul 3 405; input p 81; mul 395 407; add 275 408; mul 406
409; sub 404 410; mul 272 411; mul 272 387; mul 379 413; mul 412 414; input p 89; input p 91; input p 87; mul 294
418; input p 88; mul 288 420; input p 90; sub 421 422; sub 419 423; sub 424 12; mul 425 425; input p 86; add 374
427; mul 288 418; add 428 429; mul 294 420; add 430 431; mul 432 432; add 426 433; sqrt 434; mul 416 435; mul 178
436; sqrt 436; div 275 438; mul 439 439; mul 178 440; mul 440 441; sub 437 442; mul 417 443; sub 436 394; max 393
445; min 392 446; input p 92; input p 93; mul 447 449; add 448 450; mul 447 451; add 275 452; mul 444 453; input p
94; mul 7 455; input p 95; mul 445 457; add 275 458; mul 456 459; sub 454 460; mul 416 461; mul 416 440; mul 432
463; mul 462 464; add 415 465; sub 271 466; mul 270 467; sub 199 468; mul 41 469; mul 297 413; mul 412 471; mul 425
463; mul 462 473; add 472 474; sub 470 475; sub 40 476; add 0 477; div 275 284; mul 287 479; input p 124; mul 294
481; mul 480 482; mul 47 160; mul 42 484; abs 10; lt 486 168; mul 171 178; mul 172 178; input p 123; mul 489 490;
mul 488 491; mul 167 177; mul 172 493; add 492 494; mul 171 493; mul 488 496; add 495 497; mul 180 184; mul 488 499;
add 498 500; mul 177 184; mul 185 502; add 501 503; mul 42 504; where 487 505; add 485 506; mul 47 266; add 361 508;
mul 200 509; mul 467 510; sub 507 511; sub 376 378; mul 297 513; add 289 295; mul 379 515; sub 514 516; mul 413 517;
mul 480 518; mul 412 519; add 429 431; mul 425 521; sub 421 419; mul 432 523; add 522 524; mul 463 525; mul 480 526;
mul 462 527; add 520 528; add 512 529; sub 38 530; add 483 531; input p 125; mul 52 533; input p 126; mul 109 535;
add 534 536; input p 127; mul 113 538; add 537 539; mul 49 105; add 540 541; input p 128; mul 53 543; add 542 544;
input p 129; mul 57 546; add 545 547; input p 130; mul 61 549; add 548 550; mul 65 122; add 551 552; input p 131;
mul 69 554; add 553 555; mul 51 84; add 556 557; input p 132; mul 88 559; add 558 560; mul 64 92; add 561 562; input
p 133; mul 96 564; add 563 565; mul 79 153; add 566 567; mul 97 152; add 568 569; mul 42 570; constant
0.01904761904761903; mul 52 572; input p 134; mul 113 574; add 573 575; mul 49 235; add 576 577; input p 135; mul 57
579; add 578 580; mul 65 243; add 581 582; mul 69 318; add 583 584; input p 136; mul 88 586; add 585 587; mul 153
220; add 588 589; mul 97 259; add 590 591; add 369 592; mul 200 593; mul 467 594; sub 571 595; neg 596; sub 26 19;
mul 11 30; add 598 599; input p 143; mul 47 52; mul 51 602; add 601 603; mul 52 602; mul 56 605; add 604 606; mul 49
178; mul 47 608; mul 60 609; add 607 610; mul 52 609; mul 64 612; add 611 613; mul 49 609; mul 47 61; add 615 616;
mul 68 617; add 614 618; mul 45 47; mul 83 620; add 619 621; mul 52 620; mul 87 623; add 622 624; mul 49 620; mul 47
84; add 626 627; mul 91 628; add 625 629; mul 47 96; mul 95 631; add 630 632; input p 144; mul 119 602; add 634 635;
mul 122 605; add 636 637; mul 125 609; add 638 639; mul 128 612; add 640 641; mul 131 617; add 642 643; mul 140 620;
add 644 645; mul 143 623; add 646 647; mul 146 628; add 648 649; mul 91 631; add 650 651; mul 44 652; add 633 653;
mul 42 654; le 170 168; le 168 170; add 656 657; div 275 658; mul 656 659; le 169 10; le 10 169; add 661 662; div
275 663; mul 661 664; mul 660 665; mul 172 666; mul 488 666; mul 171 668; add 667 669; mul 167 670; mul 180 668; mul
179 672; add 671 673; mul 185 666; mul 184 675; add 674 676; mul 177 675; mul 179 678; add 677 679; mul 42 680;
where 166 681; add 655 682; input p 145; mul 211 605; add 684 685; mul 214 617; add 686 687; mul 223 623; add 688
689; mul 226 628; add 690 691; mul 229 631; add 692 693; input p 146; mul 243 605; add 695 696; mul 246 612; add 697
698; mul 249 617; add 699 700; mul 256 628; add 701 702; mul 226 631; add 703 704; mul 44 705; add 694 706; add 203
707; mul 200 708; mul 467 709; mul 178 297; mul 178 277; mul 287 712; mul 287 288; mul 281 479; mul 285 715; div 275
285; mul 277 717; mul 284 718; add 716 719; mul 714 720; sub 713 721; mul 274 722; mul 10 718; add 285 724; mul 287
725; mul 287 294; mul 720 727; sub 726 728; mul 292 729; add 723 730; mul 711 731; mul 178 379; mul 235 602; mul 52
605; mul 237 735; add 734 736; mul 311 609; add 737 738; mul 52 612; mul 314 740; add 739 741; mul 52 617; mul 318
743; add 742 744; mul 49 617; mul 47 69; add 746 747; mul 322 748; add 745 749; mul 209 620; add 750 751; mul 52
623; mul 211 753; add 752 754; mul 49 628; mul 47 92; add 756 757; mul 214 758; add 755 759; mul 52 631; mul 259
761; add 760 762; mul 49 631; mul 47 97; add 764 765; mul 343 766; add 763 767; mul 47 101; mul 264 769; add 768
770; add 357 361; add 355 772; add 360 773; mul 16 774; add 771 775; mul 200 776; mul 292 722; add 777 778; mul 274
729; sub 779 780; mul 733 781; add 732 782; mul 178 382; div 275 784; mul 783 785; mul 272 786; mul 178 787; mul 178
386; mul 178 385; div 275 790; mul 787 791; mul 387 792; mul 789 793; neg 794; mul 178 795; mul 387 796; mul 388
794; sub 797 798; sub 788 799; mul 273 800; mul 403 801; le 396 392; le 392 396; add 803 804; div 275 805; mul 803
806; le 393 395; le 395 393; add 808 809; div 275 810; mul 808 811; mul 787 812; mul 807 813; mul 399 814; mul 397
815; mul 401 814; add 816 817; mul 391 818; add 802 819; mul 407 787; mul 406 821; sub 820 822; mul 272 823; mul 414
824; mul 413 781; mul 272 794; mul 379 827; sub 826 828; mul 412 829; add 825 830; mul 178 425; mul 418 729; mul 420
722; sub 833 834; mul 832 835; mul 178 432; mul 418 722; add 777 838; mul 420 729; add 839 840; mul 837 841; add 836
842; mul 178 435; div 275 844; mul 843 845; mul 416 846; mul 178 847; mul 178 439; mul 178 438; div 275 850; mul 847
851; mul 440 852; mul 849 853; neg 854; mul 178 855; mul 440 856; mul 441 854; sub 857 858; sub 848 859; mul 417
860; mul 453 861; le 446 392; le 392 446; add 863 864; div 275 865; mul 863 866; le 393 445; le 445 393; add 868
869; div 275 870; mul 868 871; mul 847 872; mul 867 873; mul 449 874; mul 447 875; mul 451 874; add 876 877; mul 444
878; add 862 879; mul 457 847; mul 456 881; sub 880 882; mul 416 883; mul 464 884; mul 463 841; mul 416 854; mul 432
887; sub 886 888; mul 462 889; add 885 890; add 831 891; mul 270 892; sub 710 893; sub 683 894; mul 41 895; mul 471
824; mul 413 731; mul 297 827; sub 898 899; mul 412 900; add 897 901; mul 473 884; mul 463 835; mul 425 887; sub 904
905; mul 462 906; add 903 907; add 902 908; sub 896 909; sub 600 910; mul 481 729; mul 480 912; mul 479 479; mul 715
914; mul 287 915; mul 287 480; mul 720 917; add 916 918; mul 482 919; sub 913 920; mul 47 652; mul 42 922; mul 178
666; mul 491 924; mul 178 668; mul 490 926; mul 488 927; add 925 928; mul 493 668; add 929 930; mul 496 924; mul 493
666; mul 488 933; add 932 934; add 931 935; mul 499 924; add 936 937; mul 42 938; where 487 939; add 923 940; mul 47
705; add 356 942; mul 200 943; mul 467 944; mul 510 892; sub 945 946; sub 941 947; mul 519 824; mul 513 731; sub 778
780; mul 297 951; add 950 952; mul 515 781; mul 379 731; add 954 955; sub 953 956; mul 413 957; mul 517 827; sub 958
959; mul 480 960; mul 518 919; sub 961 962; mul 412 963; add 949 964; mul 527 884; mul 521 835; add 838 840; mul 425
968; add 967 969; mul 523 841; sub 834 833; mul 432 972; add 971 973; add 970 974; mul 463 975; mul 525 887; sub 976
977; mul 480 978; mul 526 919; sub 979 980; mul 462 981; add 966 982; add 965 983; add 948 984; add 30 985; sub 921
986; input p 147; mul 543 602; add 988 989; mul 546 605; add 990 991; mul 549 609; add 992 993; mul 122 612; add 994
995; mul 554 617; add 996 997; mul 51 620; add 998 999; mul 559 623; add 1000 1001; mul 64 628; add 1002 1003; mul
152 631; add 1004 1005; mul 42 1006; input p 148; mul 579 605; add 1008 1009; mul 243 612; add 1010 1011; mul 318
617; add 1012 1013; mul 586 623; add 1014 1015; mul 259 631; add 1016 1017; add 359 1018; mul 200 1019; mul 467
1020; mul 594 892; sub 1021 1022; sub 1007 1023; neg 1024; mul 49 51; mul 53 178; mul 56 1027; add 1026 1028; mul 61
64; add 1029 1030; mul 45 75; add 1031 1032; mul 76 178; mul 79 1034; add 1033 1035; mul 84 87; add 1036 1037; mul
52 178; mul 108 1039; add 105 1040; mul 52 1039; add 109 1042; mul 112 1043; add 1041 1044; mul 49 119; add 1045
1046; mul 122 1027; add 1047 1048; mul 61 128; add 1049 1050; mul 45 51; add 1051 1052; mul 56 1034; add 1053 1054;
mul 84 143; add 1055 1056; mul 96 152; add 1057 1058; mul 44 1059; add 1038 1060; mul 42 1061; mul 211 1027; mul 220
1034; add 1063 1064; mul 84 223; add 1065 1066; mul 237 1043; add 235 1068; mul 243 1027; add 1069 1070; mul 61 246;
add 1071 1072; mul 211 1034; add 1073 1074; mul 96 259; add 1075 1076; mul 44 1077; add 1067 1078; add 206 1079; mul
200 1080; mul 467 1081; mul 52 1043; add 113 1083; mul 302 1084; add 573 1085; add 577 1086; mul 52 1027; add 57
1088; mul 237 1089; add 1087 1090; mul 65 178; mul 314 1092; add 1091 1093; add 584 1094; mul 88 178; mul 211 1096;
add 1095 1097; mul 153 178; mul 336 1099; add 1098 1100; add 591 1101; add 368 369; add 366 1103; mul 16 1104; add
1102 1105; mul 200 1106; mul 733 1107; mul 785 1108; mul 272 1109; mul 178 1110; mul 791 1110; mul 387 1112; mul 789
1113; neg 1114; mul 178 1115; mul 387 1116; mul 388 1114; sub 1117 1118; sub 1111 1119; mul 273 1120; mul 403 1121;
mul 812 1110; mul 807 1123; mul 399 1124; mul 397 1125; mul 401 1124; add 1126 1127; mul 391 1128; add 1122 1129;
mul 407 1110; mul 406 1131; sub 1130 1132; mul 272 1133; mul 414 1134; mul 413 1107; mul 272 1114; mul 379 1137; sub
1136 1138; mul 412 1139; add 1135 1140; mul 837 1107; mul 845 1142; mul 416 1143; mul 178 1144; mul 851 1144; mul
440 1146; mul 849 1147; neg 1148; mul 178 1149; mul 440 1150; mul 441 1148; sub 1151 1152; sub 1145 1153; mul 417
1154; mul 453 1155; mul 872 1144; mul 867 1157; mul 449 1158; mul 447 1159; mul 451 1158; add 1160 1161; mul 444
1162; add 1156 1163; mul 457 1144; mul 456 1165; sub 1164 1166; mul 416 1167; mul 464 1168; mul 463 1107; mul 416
1148; mul 432 1171; sub 1170 1172; mul 462 1173; add 1169 1174; add 1141 1175; mul 270 1176; sub 1082 1177; sub 1062
1178; mul 41 1179; mul 471 1134; mul 297 1137; mul 412 1182; sub 1181 1183; mul 473 1168; mul 425 1171; mul 462
1186; sub 1185 1187; add 1184 1188; sub 1180 1189; neg 1190; mul 47 1059; mul 42 1192; mul 47 1077; add 359 1194;
mul 200 1195; mul 467 1196; mul 510 1176; sub 1197 1198; sub 1193 1199; mul 519 1134; mul 515 1107; mul 413 1202;
mul 517 1137; add 1203 1204; mul 480 1205; mul 412 1206; sub 1201 1207; mul 527 1168; mul 523 1107; mul 463 1210;
mul 525 1171; sub 1211 1212; mul 480 1213; mul 462 1214; add 1209 1215; add 1208 1216; add 1200 1217; neg 1218; mul
535 1039; add 533 1220; mul 538 1043; add 1221 1222; mul 49 543; add 1223 1224; mul 546 1027; add 1225 1226; mul 61
122; add 1227 1228; mul 84 559; add 1229 1230; mul 79 96; add 1231 1232; mul 42 1233; mul 574 1043; add 572 1235;
mul 579 1027; add 1236 1237; mul 61 243; add 1238 1239; mul 84 586; add 1240 1241; mul 96 220; add 1242 1243; add
367 1244; mul 200 1245; mul 467 1246; mul 594 1176; sub 1247 1248; sub 1234 1249; neg 1250; store forces 0 478;
store forces 1 532; store forces 2 597; store by_shape 0 911; store by_shape 2 987; store by_shape 4 1025; store
by_shape 1 1191; store by_shape 3 1219; store by_shape 5 1251
    """,
)

INERTIA = Graph(
    {'x': 13, 'p': 149},
    {'mass': 3},
    """
input p 118; constant 1.0; input x 0; input p 116; mul 2 3; input x 2; input p 117; mul 5 6; add 4 7; mul 8 8; add 1
9; mul 0 10; input p 122; mul 2 6; input p 120; mul 5 14; add 13 15; mul 0 8; mul 16 17; add 12 18; input p 121; mul
0 16; mul 16 21; add 20 22; store mass 0 11; store mass 1 19; store mass 2 23
    """,
)

STOP_MOVE = Graph(
    {'x': 13, 'z': 4, 'start': 2, 'p': 149},
    {'moved': 4},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 103; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 104; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 106; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 108; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
110; mul 11 30; add 29 31; max 1 32; min 0 33; store moved 0 16; store moved 1 22; store moved 2 28; store moved 3
34
    """,
)
