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

MEMORIES = (('creep_0', 'm'), ('creep_1', 'm'))

FIRST_MEMORY = 11

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
580; sub 55 581; input p 101; input p 102; constant -1.0; input z 0; input start 0; sub 12 587; input p 103; input
start 1; sub 10 590; mul 589 591; add 588 592; input p 104; mul 593 594; add 586 595; max 585 596; min 364 597; mul
584 598; input p 105; input z 1; input p 106; mul 593 602; add 601 603; max 585 604; min 364 605; mul 600 606; add
599 607; input p 107; input z 2; input p 108; mul 593 611; add 610 612; max 585 613; min 364 614; mul 609 615; add
608 616; input p 109; input z 3; input p 110; mul 593 620; add 619 621; max 585 622; min 364 623; mul 618 624; add
617 625; sub 583 626; input p 111; abs 0; mul 628 629; mul 0 630; input p 112; mul 0 632; mul 0 0; input p 113; add
634 635; sqrt 636; div 364 637; mul 633 638; add 631 639; sub 627 640; add 582 641; input p 114; input x 11; sub 12
644; mul 643 645; input p 115; input x 12; sub 12 648; mul 647 649; add 646 650; sub 642 651; input p 116; mul 12
653; input p 117; mul 10 655; add 654 656; input p 118; mul 0 653; input p 119; mul 42 660; add 659 661; mul 0 662;
input p 120; mul 42 664; mul 42 665; add 663 666; mul 658 667; mul 657 668; sub 652 669; input p 121; mul 12 655;
mul 10 664; add 672 673; mul 658 674; mul 674 675; add 671 676; mul 670 677; input p 122; mul 657 658; mul 674 680;
add 679 681; mul 62 175; mul 57 683; abs 10; lt 685 183; mul 186 193; mul 187 193; input p 123; mul 688 689; mul 687
690; mul 182 192; mul 187 692; add 691 693; mul 186 692; mul 687 695; add 694 696; mul 195 199; mul 687 698; add 697
699; mul 192 199; mul 200 701; add 700 702; mul 57 703; where 686 704; add 684 705; mul 464 556; sub 706 707; mul 62
573; add 708 709; mul 455 470; mul 545 553; add 711 712; add 710 713; sub 46 714; input p 124; mul 383 716; mul 454
717; add 715 718; mul 589 626; sub 719 720; mul 668 674; sub 721 722; mul 682 723; sub 678 724; mul 657 657; add 364
726; mul 658 727; mul 677 728; mul 682 682; sub 729 730; div 364 731; mul 725 732; mul 723 728; mul 670 682; sub 734
735; mul 732 736; input p 125; mul 67 738; input p 126; mul 124 740; add 739 741; input p 127; mul 128 743; add 742
744; mul 64 120; add 745 746; input p 128; mul 68 748; add 747 749; input p 129; mul 72 751; add 750 752; input p
130; mul 76 754; add 753 755; mul 80 137; add 756 757; input p 131; mul 84 759; add 758 760; mul 66 99; add 761 762;
input p 132; mul 103 764; add 763 765; mul 79 107; add 766 767; input p 133; mul 111 769; add 768 770; mul 94 168;
add 771 772; mul 112 167; add 773 774; mul 57 775; constant 0.01904761904761903; mul 67 777; input p 134; mul 128
779; add 778 780; mul 64 250; add 781 782; input p 135; mul 72 784; add 783 785; mul 80 258; add 786 787; mul 84
306; add 788 789; input p 136; mul 103 791; add 790 792; mul 168 235; add 793 794; mul 112 274; add 795 796; add 357
797; mul 215 798; mul 556 799; sub 776 800; input p 137; mul 801 802; neg 803; mul 441 468; input p 138; mul 427
806; sub 805 807; mul 533 551; mul 520 806; sub 809 810; input p 139; mul 430 812; sub 805 813; mul 523 812; sub 809
815; input p 140; mul 434 817; sub 805 818; mul 527 817; sub 809 820; input p 141; mul 645 822; input p 142; mul 649
824; store rates 0 0; store rates 1 733; store rates 2 42; store rates 3 737; store rates 4 804; store rates 5 808;
store rates 6 811; store rates 7 814; store rates 8 816; store rates 9 819; store rates 10 821; store rates 11 823;
store rates 12 825
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
1.4; sub 383 392; input p 78; input p 79; mul 393 395; add 394 396; mul 393 397; add 275 398; mul 391 399; input p
80; mul 3 401; input p 81; mul 393 403; add 275 404; mul 402 405; sub 400 406; mul 272 407; mul 272 387; mul 379
409; mul 408 410; input p 89; input p 91; input p 87; mul 294 414; input p 88; mul 288 416; input p 90; sub 417 418;
sub 415 419; sub 420 12; mul 421 421; input p 86; add 374 423; mul 288 414; add 424 425; mul 294 416; add 426 427;
mul 428 428; add 422 429; sqrt 430; mul 412 431; mul 178 432; sqrt 432; div 275 434; mul 435 435; mul 178 436; mul
436 437; sub 433 438; mul 413 439; sub 432 392; input p 92; input p 93; mul 441 443; add 442 444; mul 441 445; add
275 446; mul 440 447; input p 94; mul 7 449; input p 95; mul 441 451; add 275 452; mul 450 453; sub 448 454; mul 412
455; mul 412 436; mul 428 457; mul 456 458; add 411 459; sub 271 460; mul 270 461; sub 199 462; mul 41 463; mul 297
409; mul 408 465; mul 421 457; mul 456 467; add 466 468; sub 464 469; sub 40 470; add 0 471; div 275 284; mul 287
473; input p 124; mul 294 475; mul 474 476; mul 47 160; mul 42 478; abs 10; lt 480 168; mul 171 178; mul 172 178;
input p 123; mul 483 484; mul 482 485; mul 167 177; mul 172 487; add 486 488; mul 171 487; mul 482 490; add 489 491;
mul 180 184; mul 482 493; add 492 494; mul 177 184; mul 185 496; add 495 497; mul 42 498; where 481 499; add 479
500; mul 47 266; add 361 502; mul 200 503; mul 461 504; sub 501 505; sub 376 378; mul 297 507; add 289 295; mul 379
509; sub 508 510; mul 409 511; mul 474 512; mul 408 513; add 425 427; mul 421 515; sub 417 415; mul 428 517; add 516
518; mul 457 519; mul 474 520; mul 456 521; add 514 522; add 506 523; sub 38 524; add 477 525; input p 125; mul 52
527; input p 126; mul 109 529; add 528 530; input p 127; mul 113 532; add 531 533; mul 49 105; add 534 535; input p
128; mul 53 537; add 536 538; input p 129; mul 57 540; add 539 541; input p 130; mul 61 543; add 542 544; mul 65
122; add 545 546; input p 131; mul 69 548; add 547 549; mul 51 84; add 550 551; input p 132; mul 88 553; add 552
554; mul 64 92; add 555 556; input p 133; mul 96 558; add 557 559; mul 79 153; add 560 561; mul 97 152; add 562 563;
mul 42 564; constant 0.01904761904761903; mul 52 566; input p 134; mul 113 568; add 567 569; mul 49 235; add 570
571; input p 135; mul 57 573; add 572 574; mul 65 243; add 575 576; mul 69 318; add 577 578; input p 136; mul 88
580; add 579 581; mul 153 220; add 582 583; mul 97 259; add 584 585; add 369 586; mul 200 587; mul 461 588; sub 565
589; neg 590; sub 26 19; mul 11 30; add 592 593; input p 143; mul 47 52; mul 51 596; add 595 597; mul 52 596; mul 56
599; add 598 600; mul 49 178; mul 47 602; mul 60 603; add 601 604; mul 52 603; mul 64 606; add 605 607; mul 49 603;
mul 47 61; add 609 610; mul 68 611; add 608 612; mul 45 47; mul 83 614; add 613 615; mul 52 614; mul 87 617; add 616
618; mul 49 614; mul 47 84; add 620 621; mul 91 622; add 619 623; mul 47 96; mul 95 625; add 624 626; input p 144;
mul 119 596; add 628 629; mul 122 599; add 630 631; mul 125 603; add 632 633; mul 128 606; add 634 635; mul 131 611;
add 636 637; mul 140 614; add 638 639; mul 143 617; add 640 641; mul 146 622; add 642 643; mul 91 625; add 644 645;
mul 44 646; add 627 647; mul 42 648; le 170 168; le 168 170; add 650 651; div 275 652; mul 650 653; le 169 10; le 10
169; add 655 656; div 275 657; mul 655 658; mul 654 659; mul 172 660; mul 482 660; mul 171 662; add 661 663; mul 167
664; mul 180 662; mul 179 666; add 665 667; mul 185 660; mul 184 669; add 668 670; mul 177 669; mul 179 672; add 671
673; mul 42 674; where 166 675; add 649 676; input p 145; mul 211 599; add 678 679; mul 214 611; add 680 681; mul
223 617; add 682 683; mul 226 622; add 684 685; mul 229 625; add 686 687; input p 146; mul 243 599; add 689 690; mul
246 606; add 691 692; mul 249 611; add 693 694; mul 256 622; add 695 696; mul 226 625; add 697 698; mul 44 699; add
688 700; add 203 701; mul 200 702; mul 461 703; mul 178 297; mul 178 277; mul 287 706; mul 287 288; mul 281 473; mul
285 709; div 275 285; mul 277 711; mul 284 712; add 710 713; mul 708 714; sub 707 715; mul 274 716; mul 10 712; add
285 718; mul 287 719; mul 287 294; mul 714 721; sub 720 722; mul 292 723; add 717 724; mul 705 725; mul 178 379; mul
235 596; mul 52 599; mul 237 729; add 728 730; mul 311 603; add 731 732; mul 52 606; mul 314 734; add 733 735; mul
52 611; mul 318 737; add 736 738; mul 49 611; mul 47 69; add 740 741; mul 322 742; add 739 743; mul 209 614; add 744
745; mul 52 617; mul 211 747; add 746 748; mul 49 622; mul 47 92; add 750 751; mul 214 752; add 749 753; mul 52 625;
mul 259 755; add 754 756; mul 49 625; mul 47 97; add 758 759; mul 343 760; add 757 761; mul 47 101; mul 264 763; add
762 764; add 357 361; add 355 766; add 360 767; mul 16 768; add 765 769; mul 200 770; mul 292 716; add 771 772; mul
274 723; sub 773 774; mul 727 775; add 726 776; mul 178 382; div 275 778; mul 777 779; mul 272 780; mul 178 781; mul
178 386; mul 178 385; div 275 784; mul 781 785; mul 387 786; mul 783 787; neg 788; mul 178 789; mul 387 790; mul 388
788; sub 791 792; sub 782 793; mul 273 794; mul 399 795; mul 395 781; mul 393 797; mul 397 781; add 798 799; mul 391
800; add 796 801; mul 403 781; mul 402 803; sub 802 804; mul 272 805; mul 410 806; mul 409 775; mul 272 788; mul 379
809; sub 808 810; mul 408 811; add 807 812; mul 178 421; mul 414 723; mul 416 716; sub 815 816; mul 814 817; mul 178
428; mul 414 716; add 771 820; mul 416 723; add 821 822; mul 819 823; add 818 824; mul 178 431; div 275 826; mul 825
827; mul 412 828; mul 178 829; mul 178 435; mul 178 434; div 275 832; mul 829 833; mul 436 834; mul 831 835; neg
836; mul 178 837; mul 436 838; mul 437 836; sub 839 840; sub 830 841; mul 413 842; mul 447 843; mul 443 829; mul 441
845; mul 445 829; add 846 847; mul 440 848; add 844 849; mul 451 829; mul 450 851; sub 850 852; mul 412 853; mul 458
854; mul 457 823; mul 412 836; mul 428 857; sub 856 858; mul 456 859; add 855 860; add 813 861; mul 270 862; sub 704
863; sub 677 864; mul 41 865; mul 465 806; mul 409 725; mul 297 809; sub 868 869; mul 408 870; add 867 871; mul 467
854; mul 457 817; mul 421 857; sub 874 875; mul 456 876; add 873 877; add 872 878; sub 866 879; sub 594 880; mul 475
723; mul 474 882; mul 473 473; mul 709 884; mul 287 885; mul 287 474; mul 714 887; add 886 888; mul 476 889; sub 883
890; mul 47 646; mul 42 892; mul 178 660; mul 485 894; mul 178 662; mul 484 896; mul 482 897; add 895 898; mul 487
662; add 899 900; mul 490 894; mul 487 660; mul 482 903; add 902 904; add 901 905; mul 493 894; add 906 907; mul 42
908; where 481 909; add 893 910; mul 47 699; add 356 912; mul 200 913; mul 461 914; mul 504 862; sub 915 916; sub
911 917; mul 513 806; mul 507 725; sub 772 774; mul 297 921; add 920 922; mul 509 775; mul 379 725; add 924 925; sub
923 926; mul 409 927; mul 511 809; sub 928 929; mul 474 930; mul 512 889; sub 931 932; mul 408 933; add 919 934; mul
521 854; mul 515 817; add 820 822; mul 421 938; add 937 939; mul 517 823; sub 816 815; mul 428 942; add 941 943; add
940 944; mul 457 945; mul 519 857; sub 946 947; mul 474 948; mul 520 889; sub 949 950; mul 456 951; add 936 952; add
935 953; add 918 954; add 30 955; sub 891 956; input p 147; mul 537 596; add 958 959; mul 540 599; add 960 961; mul
543 603; add 962 963; mul 122 606; add 964 965; mul 548 611; add 966 967; mul 51 614; add 968 969; mul 553 617; add
970 971; mul 64 622; add 972 973; mul 152 625; add 974 975; mul 42 976; input p 148; mul 573 599; add 978 979; mul
243 606; add 980 981; mul 318 611; add 982 983; mul 580 617; add 984 985; mul 259 625; add 986 987; add 359 988; mul
200 989; mul 461 990; mul 588 862; sub 991 992; sub 977 993; neg 994; mul 49 51; mul 53 178; mul 56 997; add 996
998; mul 61 64; add 999 1000; mul 45 75; add 1001 1002; mul 76 178; mul 79 1004; add 1003 1005; mul 84 87; add 1006
1007; mul 52 178; mul 108 1009; add 105 1010; mul 52 1009; add 109 1012; mul 112 1013; add 1011 1014; mul 49 119;
add 1015 1016; mul 122 997; add 1017 1018; mul 61 128; add 1019 1020; mul 45 51; add 1021 1022; mul 56 1004; add
1023 1024; mul 84 143; add 1025 1026; mul 96 152; add 1027 1028; mul 44 1029; add 1008 1030; mul 42 1031; mul 211
997; mul 220 1004; add 1033 1034; mul 84 223; add 1035 1036; mul 237 1013; add 235 1038; mul 243 997; add 1039 1040;
mul 61 246; add 1041 1042; mul 211 1004; add 1043 1044; mul 96 259; add 1045 1046; mul 44 1047; add 1037 1048; add
206 1049; mul 200 1050; mul 461 1051; mul 52 1013; add 113 1053; mul 302 1054; add 567 1055; add 571 1056; mul 52
997; add 57 1058; mul 237 1059; add 1057 1060; mul 65 178; mul 314 1062; add 1061 1063; add 578 1064; mul 88 178;
mul 211 1066; add 1065 1067; mul 153 178; mul 336 1069; add 1068 1070; add 585 1071; add 368 369; add 366 1073; mul
16 1074; add 1072 1075; mul 200 1076; mul 727 1077; mul 779 1078; mul 272 1079; mul 178 1080; mul 785 1080; mul 387
1082; mul 783 1083; neg 1084; mul 178 1085; mul 387 1086; mul 388 1084; sub 1087 1088; sub 1081 1089; mul 273 1090;
mul 399 1091; mul 395 1080; mul 393 1093; mul 397 1080; add 1094 1095; mul 391 1096; add 1092 1097; mul 403 1080;
mul 402 1099; sub 1098 1100; mul 272 1101; mul 410 1102; mul 409 1077; mul 272 1084; mul 379 1105; sub 1104 1106;
mul 408 1107; add 1103 1108; mul 819 1077; mul 827 1110; mul 412 1111; mul 178 1112; mul 833 1112; mul 436 1114; mul
831 1115; neg 1116; mul 178 1117; mul 436 1118; mul 437 1116; sub 1119 1120; sub 1113 1121; mul 413 1122; mul 447
1123; mul 443 1112; mul 441 1125; mul 445 1112; add 1126 1127; mul 440 1128; add 1124 1129; mul 451 1112; mul 450
1131; sub 1130 1132; mul 412 1133; mul 458 1134; mul 457 1077; mul 412 1116; mul 428 1137; sub 1136 1138; mul 456
1139; add 1135 1140; add 1109 1141; mul 270 1142; sub 1052 1143; sub 1032 1144; mul 41 1145; mul 465 1102; mul 297
1105; mul 408 1148; sub 1147 1149; mul 467 1134; mul 421 1137; mul 456 1152; sub 1151 1153; add 1150 1154; sub 1146
1155; neg 1156; mul 47 1029; mul 42 1158; mul 47 1047; add 359 1160; mul 200 1161; mul 461 1162; mul 504 1142; sub
1163 1164; sub 1159 1165; mul 513 1102; mul 509 1077; mul 409 1168; mul 511 1105; add 1169 1170; mul 474 1171; mul
408 1172; sub 1167 1173; mul 521 1134; mul 517 1077; mul 457 1176; mul 519 1137; sub 1177 1178; mul 474 1179; mul
456 1180; add 1175 1181; add 1174 1182; add 1166 1183; neg 1184; mul 529 1009; add 527 1186; mul 532 1013; add 1187
1188; mul 49 537; add 1189 1190; mul 540 997; add 1191 1192; mul 61 122; add 1193 1194; mul 84 553; add 1195 1196;
mul 79 96; add 1197 1198; mul 42 1199; mul 568 1013; add 566 1201; mul 573 997; add 1202 1203; mul 61 243; add 1204
1205; mul 84 580; add 1206 1207; mul 96 220; add 1208 1209; add 367 1210; mul 200 1211; mul 461 1212; mul 588 1142;
sub 1213 1214; sub 1200 1215; neg 1216; store forces 0 472; store forces 1 526; store forces 2 591; store by_shape 0
881; store by_shape 2 957; store by_shape 4 995; store by_shape 1 1157; store by_shape 3 1185; store by_shape 5 1217
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
