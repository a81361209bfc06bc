"""The condensed joint: rates, forces at rest, inertia, stop operators after a step.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

CONSTANTS = ('l', 'bending', 'bending_loss', 'steepening', 'stiffening', 'shortening', 'curvature', 'slope_by_q',
    'slope_by_tau', 'shortening_qq', 'shortening_qt', 'shortening_tt', 'shortening_qb', 'shortening_tb',
    'shortening_bb', 'rotation', 'quartic_qqqq', 'quartic_qqqt', 'quartic_qqtt', 'quartic_qttt', 'quartic_tttt',
    'mass', 'cross', 'inertia', 'interior_inertia', 'rise_qq', 'rise_qt', 'rise_tt', 'rise_qb', 'rise_tb',
    'rise_bb', 'weight', 'offset', 'side_force', 'relaxation_0', 'relaxation_1', 'relaxation_2', 'viscosity',
    'drag', 'sliding_force', 'sliding_speed', 'friction_arm', 'left_a', 'left_c', 'left_e_z', 'left_e_x',
    'left_l0', 'left_elastic', 'left_hardening', 'left_hardening_slope', 'left_electric', 'left_electric_slope',
    'left_maxwell_0', 'left_maxwell_1', 'left_maxwell_2', 'left_viscous', 'right_a', 'right_c', 'right_e_z',
    'right_e_x', 'right_l0', 'right_elastic', 'right_hardening', 'right_hardening_slope', 'right_electric',
    'right_electric_slope', 'right_maxwell_0', 'right_maxwell_1', 'right_maxwell_2', 'right_viscous',
    'stop_force_0', 'stop_force_1', 'stop_force_2', 'stop_force_3', 'stop_travel_0', 'stop_travel_1',
    'stop_travel_2', 'stop_travel_3', 'creep_stiffness_0', 'creep_stiffness_1', 'creep_rate_0', 'creep_rate_1',
    'slope_ratio')

TIP_CONSTANTS = (('drag', 0.02, 1.2), ('sliding_force', 0.0001, 1.2), ('sliding_speed', 0.006, 0.5))

TIP_DIMENSIONS = {'drag': (1, -1, 0, 0), 'sliding_force': (1, 1, -2, 0), 'sliding_speed': (0, 1, -1, 0)}

CORRECTIONS = ('force', 'damping', 'left', 'right', 'moment', 'stiffness', 'left_moment', 'right_moment', 'loss',
    'moment_q', 'stiffness_q', 'left_moment_q', 'right_moment_q')

STATES = 14

ELEMENT_STATES = (('creep_0', 'm'), ('creep_1', 'm'))

FIRST_STRAIN = 6

FIRST_ELEMENT = 12

DRY_LEVELS = ('sliding_force',)

AT_REST = (1.0, 1.0)

STOPS = 4

CREEPS = 2

BRANCHES = 3

PREPARE = Graph(
    {'k': 83},
    {'p': 152},
    """
input k 23; input k 21; input k 26; input k 27; input k 29; input k 24; input k 28; input k 30; input k 25; input k
22; constant 1.0; input k 82; input k 0; div 10 12; mul 11 13; constant -2.0; input k 2; mul 15 16; input k 37;
input k 1; constant -6.000000000000002; constant -18.000000000000004; input k 6; mul 22 22; input k 4; mul 23 24;
mul 21 25; add 20 26; constant -0.09999999999999995; input k 3; mul 23 29; mul 28 30; add 27 31; input k 7; input k
8; constant 28.79999999999999; mul 22 24; mul 35 36; constant -22.62857142857143; mul 24 38; constant
-0.057142857142856635; mul 29 40; add 39 41; constant 36.0; mul 36 43; constant -28.799999999999976; mul 24 45;
constant 0.05714285714285722; mul 29 47; add 46 48; constant -50.400000000000006; mul 24 50; constant
-1.1428571428571423; mul 29 52; add 51 53; constant 12.000000000000004; constant 36.000000000000014; mul 25 56; add
55 57; constant 1.2; mul 30 59; add 58 60; constant -57.60000000000001; mul 36 62; constant 45.25714285714287; mul
24 64; constant 0.9142857142857138; mul 29 66; add 65 67; constant -72.00000000000001; mul 36 69; constant
57.599999999999916; mul 24 71; constant -1.7142857142857166; mul 29 73; add 72 74; constant 230.40000000000006; mul
24 76; constant 2.057142857142858; mul 29 78; add 77 79; constant -388.80000000000024; mul 24 81; constant
-7.714285714285722; mul 29 83; add 82 84; constant 259.2000000000001; mul 24 86; constant 12.34285714285715; mul 29
88; add 87 89; constant -0.9999999999999998; mul 22 91; mul 22 23; mul 24 93; mul 91 94; add 92 95; constant
-0.033333333333333326; mul 30 97; constant -2.3999999999999995; mul 36 99; constant 0.4571428571428564; mul 24 101;
constant -0.019047619047619094; mul 29 103; add 102 104; constant 4.000000000000001; constant 12.0; mul 25 107; add
106 108; constant 0.13333333333333333; mul 30 110; add 109 111; constant -14.399999999999991; mul 36 113; constant
13.714285714285717; mul 24 115; constant 0.11428571428571413; mul 29 117; add 116 118; constant -30.000000000000007;
mul 36 120; mul 22 29; sub 121 122; constant 21.59999999999998; mul 24 124; constant 0.6571428571428567; mul 29 126;
add 125 127; constant 35.20000000000001; mul 24 129; constant 2.438095238095238; mul 29 131; add 130 132; constant
72.0; mul 36 134; constant -57.59999999999995; mul 24 136; constant 0.11428571428571443; mul 29 138; add 137 139;
constant -151.20000000000002; mul 24 141; constant -3.428571428571427; mul 29 143; add 142 144; constant
-36.00000000000001; mul 36 146; constant 28.799999999999958; mul 24 148; constant -0.8571428571428583; mul 29 150;
add 149 151; constant -129.60000000000008; mul 24 153; constant -2.5714285714285743; mul 29 155; add 154 156; input
k 19; input k 18; input k 17; input k 16; input k 31; input k 47; input k 42; input k 15; sub 165 10; input k 44;
input k 43; input k 45; sub 169 12; constant 8.118473726939319e-05; input k 5; mul 171 172; constant
-0.0004787100025195255; mul 172 174; constant 0.0013605442176870743; mul 172 176; constant -0.003571428571428574;
mul 172 178; constant 0.007142857142857142; mul 172 180; constant -0.0006802721088435403; mul 172 182; constant
0.0035714285714285787; mul 172 184; constant 0.014965986394557814; mul 172 186; constant -0.04285714285714284; mul
172 188; constant 0.06428571428571427; mul 172 190; constant -0.12857142857142845; mul 172 192; constant
0.2571428571428571; mul 172 194; input k 9; input k 10; input k 12; input k 11; input k 13; input k 14; input k 46;
div 10 202; input k 48; input k 49; input k 50; input k 51; input k 52; input k 53; input k 54; input k 55; constant
0.029931972789115628; mul 172 212; constant -0.08571428571428567; mul 172 214; constant 0.12857142857142853; mul 172
216; constant -0.38571428571428534; mul 172 218; constant 1.0285714285714285; mul 172 220; constant
0.0027210884353741486; mul 172 222; constant -0.010714285714285721; mul 172 224; constant 0.028571428571428567; mul
172 226; constant 0.010714285714285735; mul 172 228; input k 61; input k 57; input k 56; input k 58; input k 59; sub
234 12; input k 60; div 10 236; input k 62; input k 63; input k 64; input k 65; input k 66; input k 67; input k 68;
input k 69; input k 33; input k 70; input k 41; input k 74; div 10 249; input k 71; input k 75; div 10 252; input k
72; input k 76; div 10 255; input k 73; input k 77; div 10 258; input k 38; input k 39; input k 40; mul 262 262;
input k 78; input k 79; input k 20; input k 32; mul 162 267; constant 0.8000000000000002; constant
2.400000000000001; mul 25 270; add 269 271; constant 0.01904761904761903; mul 30 273; add 272 274; constant
-1.3714285714285723; mul 36 276; constant 1.3714285714285714; mul 24 278; constant 0.007256235827664418; mul 29 280;
add 279 281; constant -4.799999999999999; mul 36 283; constant 1.3714285714285692; mul 24 285; constant
-0.05714285714285729; mul 29 287; add 286 288; constant -7.199999999999996; mul 36 290; constant 7.199999999999994;
mul 24 292; constant 0.2190476190476189; mul 29 294; add 293 295; constant -45.25714285714286; mul 24 297; constant
-0.11428571428571327; mul 29 299; add 298 300; constant -28.800000000000004; mul 36 302; constant
0.00032473894907757275; mul 172 304; constant -0.0014361300075585765; mul 172 306; constant -0.0013605442176870806;
mul 172 308; constant 0.8; mul 16 310; input k 34; input k 35; input k 36; input k 80; input k 81; mul 32 34; mul 34
112; mul 28 34; mul 34 110; mul 34 98; mul 34 97; store p 0 0; store p 1 1; store p 2 2; store p 3 3; store p 4 4;
store p 5 5; store p 6 6; store p 7 7; store p 8 8; store p 9 9; store p 10 14; store p 11 17; store p 12 18; store
p 13 13; store p 14 19; store p 15 32; store p 16 33; store p 17 34; store p 18 37; store p 19 42; store p 20 44;
store p 21 49; store p 22 54; store p 23 61; store p 24 63; store p 25 68; store p 26 70; store p 27 75; store p 28
80; store p 29 85; store p 30 90; store p 31 96; store p 32 98; store p 33 100; store p 34 105; store p 35 112;
store p 36 114; store p 37 119; store p 38 123; store p 39 128; store p 40 133; store p 41 135; store p 42 140;
store p 43 145; store p 44 147; store p 45 152; store p 46 157; store p 47 158; store p 48 159; store p 49 160;
store p 50 161; store p 51 12; store p 52 196; store p 53 197; store p 54 198; store p 55 183; store p 56 185; store
p 57 213; store p 58 215; store p 59 217; store p 60 219; store p 61 221; store p 62 175; store p 63 223; store p 64
225; store p 65 227; store p 66 229; store p 67 189; store p 68 193; store p 69 162; store p 70 170; store p 71 173;
store p 72 177; store p 73 179; store p 74 181; store p 75 187; store p 76 191; store p 77 195; store p 78 199;
store p 79 200; store p 80 201; store p 81 166; store p 82 165; store p 83 168; store p 84 164; store p 85 203;
store p 86 167; store p 87 163; store p 88 204; store p 89 205; store p 90 206; store p 91 207; store p 92 208;
store p 93 209; store p 94 210; store p 95 211; store p 96 235; store p 97 231; store p 98 232; store p 99 237;
store p 100 233; store p 101 230; store p 102 238; store p 103 239; store p 104 240; store p 105 241; store p 106
242; store p 107 243; store p 108 244; store p 109 245; store p 110 16; store p 111 246; store p 112 247; store p
113 248; store p 114 250; store p 115 251; store p 116 253; store p 117 254; store p 118 256; store p 119 257; store
p 120 259; store p 121 260; store p 122 261; store p 123 263; store p 124 264; store p 125 265; store p 126 266;
store p 127 268; store p 128 275; store p 129 277; store p 130 282; store p 131 284; store p 132 289; store p 133
291; store p 134 296; store p 135 301; store p 136 303; store p 137 305; store p 138 307; store p 139 309; store p
140 311; store p 141 312; store p 142 313; store p 143 314; store p 144 315; store p 145 316; store p 146 317; store
p 147 318; store p 148 319; store p 149 320; store p 150 321; store p 151 322
    """,
)

RATES = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'start': 2, 'p': 152},
    {'rates': 14},
    """
input x 1; input p 0; input p 1; input p 2; input x 0; mul 3 4; input p 3; input x 2; mul 6 7; add 5 8; input p 4;
input x 4; mul 10 11; add 9 12; mul 13 13; mul 2 14; add 1 15; input p 5; input p 6; mul 4 18; mul 7 10; add 19 20;
input p 7; mul 11 22; add 21 23; mul 24 24; mul 2 25; add 17 26; mul 16 27; mul 13 24; mul 2 29; mul 30 30; sub 28
31; constant 1.0; input p 8; mul 4 34; mul 3 7; add 35 36; mul 11 18; add 37 38; mul 39 39; mul 2 40; add 2 41; mul
32 42; input p 9; mul 13 39; mul 2 45; add 44 46; mul 27 47; mul 24 39; mul 2 49; mul 30 50; sub 48 51; mul 47 52;
sub 43 53; mul 30 47; mul 16 50; sub 55 56; mul 50 57; add 54 58; div 33 59; mul 32 60; input c 0; input c 2; input
u 0; mul 63 64; add 62 65; input c 3; input u 1; mul 67 68; add 66 69; input p 10; mul 4 71; sub 7 72; input c 9;
constant 0.5; input c 10; mul 75 76; mul 73 77; sub 74 78; input c 11; mul 64 80; add 79 81; input c 12; mul 68 83;
add 82 84; mul 73 85; add 70 86; input c 4; input c 5; mul 73 89; sub 88 90; input c 6; mul 64 92; add 91 93; input
c 7; mul 68 95; add 94 96; input c 8; input p 11; max 98 99; input x 3; mul 0 71; sub 101 102; mul 100 103; sub 97
104; mul 71 105; sub 87 106; input p 12; input c 1; add 108 109; constant 0.0; max 110 111; mul 0 112; sub 107 113;
input p 13; input p 14; input p 15; input p 16; mul 4 115; mul 118 119; input p 17; mul 7 121; add 120 122; mul 117
123; input p 18; mul 11 123; mul 125 126; add 124 127; input p 19; mul 11 126; mul 129 130; add 128 131; input p 20;
mul 123 123; mul 133 134; add 132 135; input p 21; mul 11 134; mul 137 138; add 136 139; input p 22; mul 123 134;
mul 141 142; add 140 143; input p 23; mul 119 145; add 144 146; input p 24; mul 11 119; mul 148 149; add 147 150;
input p 25; mul 11 149; mul 152 153; add 151 154; input p 26; mul 119 123; mul 156 157; add 155 158; input p 27; mul
11 157; mul 160 161; add 159 162; input p 28; mul 123 157; mul 164 165; add 163 166; input p 29; mul 119 119; mul
123 169; mul 168 170; add 167 171; input p 30; mul 119 169; mul 173 174; add 172 175; input p 31; input p 32; mul 11
178; add 177 179; input p 33; mul 11 11; mul 181 182; add 180 183; input p 34; mul 11 182; mul 185 186; add 184 187;
input p 35; mul 123 189; add 188 190; input p 36; mul 126 192; add 191 193; input p 37; mul 130 195; add 194 196;
input p 38; mul 134 198; add 197 199; input p 39; mul 138 201; add 200 202; input p 40; mul 142 204; add 203 205;
mul 117 119; add 206 207; mul 125 149; add 208 209; mul 129 153; add 210 211; input p 41; mul 157 213; add 212 214;
input p 42; mul 161 216; add 215 217; input p 43; mul 165 219; add 218 220; input p 44; mul 169 222; add 221 223;
input p 45; mul 11 169; mul 225 226; add 224 227; mul 164 170; add 228 229; input p 46; mul 174 231; add 230 232;
mul 118 233; add 176 234; mul 116 235; abs 119; constant 0.35; lt 237 238; input p 47; constant 0.6; constant -0.6;
max 242 7; min 241 243; mul 244 244; mul 244 245; mul 240 246; constant -0.35; max 248 119; min 238 249; constant
2.0; mul 250 251; input p 48; mul 245 253; mul 252 254; add 247 255; mul 250 250; input p 49; mul 244 258; mul 257
259; add 256 260; mul 250 259; mul 252 262; add 261 263; mul 251 257; input p 50; mul 265 266; mul 252 267; add 264
268; mul 116 269; where 239 270; add 236 271; input p 51; input p 52; mul 119 274; input p 53; mul 7 276; add 275
277; input p 54; mul 11 279; add 278 280; constant -0.09999999999999995; mul 123 282; input p 55; mul 130 284; add
283 285; input p 56; mul 142 287; add 286 288; constant 1.2; mul 119 290; add 289 291; input p 57; mul 153 293; add
292 294; input p 58; mul 161 296; add 295 297; input p 59; mul 165 299; add 298 300; input p 60; mul 170 302; add
301 303; input p 61; mul 174 305; add 304 306; constant -0.033333333333333326; mul 11 308; input p 62; mul 186 310;
add 309 311; constant 0.13333333333333333; mul 123 313; add 312 314; input p 63; mul 130 316; add 315 317; input p
64; mul 138 319; add 318 320; input p 65; mul 142 322; add 321 323; mul 119 282; add 324 325; mul 153 284; add 326
327; input p 66; mul 165 329; add 328 330; input p 67; mul 226 332; add 331 333; mul 170 299; add 334 335; input p
68; mul 174 337; add 336 338; mul 118 339; add 307 340; add 281 341; mul 273 342; input p 69; input p 70; constant
0.009523809523809514; mul 182 346; input p 71; mul 11 186; mul 348 349; add 347 350; mul 126 308; add 351 352; mul
11 130; mul 310 354; add 353 355; constant 0.06666666666666667; mul 134 357; add 356 358; input p 72; mul 11 138;
mul 360 361; add 359 362; input p 73; mul 11 142; mul 364 365; add 363 366; input p 74; mul 123 142; mul 368 369;
add 367 370; mul 157 282; add 371 372; mul 11 161; mul 284 374; add 373 375; mul 123 165; mul 287 377; add 376 378;
mul 169 241; add 379 380; input p 75; mul 11 226; mul 382 383; add 381 384; mul 11 170; mul 332 386; add 385 387;
input p 76; mul 123 170; mul 389 390; add 388 391; mul 123 174; mul 337 393; add 392 394; input p 77; mul 119 174;
mul 396 397; add 395 398; mul 119 281; mul 119 276; input p 78; mul 7 402; add 401 403; input p 79; mul 11 405; add
404 406; mul 7 407; add 400 408; mul 119 279; mul 7 405; add 410 411; input p 80; mul 11 413; add 412 414; mul 11
415; add 409 416; mul 75 417; add 399 418; mul 273 419; add 345 420; input p 81; mul 7 422; mul 7 423; add 33 424;
input p 82; mul 7 426; mul 7 427; add 33 428; sqrt 429; sqrt 425; mul 430 431; div 33 432; mul 425 433; input p 83;
mul 434 435; add 421 436; input p 84; mul 7 431; mul 433 439; mul 438 440; sub 437 441; input p 85; mul 434 438;
input p 86; sub 444 445; mul 435 440; add 446 447; sub 448 4; mul 449 449; mul 442 442; add 450 451; sqrt 452; mul
443 453; sqrt 454; div 33 455; mul 456 456; mul 443 457; mul 442 458; input p 87; mul 251 454; mul 251 457; mul 457
462; sub 461 463; mul 460 464; constant 0.3; constant -0.3; constant 1.4; sub 454 468; max 467 469; min 466 470;
input p 88; input p 89; mul 471 473; add 472 474; mul 471 475; add 33 476; mul 465 477; input p 90; mul 64 479;
input p 91; mul 469 481; add 33 482; mul 480 483; sub 478 484; mul 443 485; input p 92; input x 6; mul 487 488;
input p 93; input x 8; mul 490 491; add 489 492; input p 94; input x 10; mul 494 495; add 493 496; constant -0.5;
mul 456 498; mul 456 499; mul 456 500; mul 443 501; mul 497 502; add 486 503; input p 95; mul 502 505; mul 502 506;
sub 436 441; mul 449 508; add 444 447; mul 442 510; sub 509 511; mul 458 512; div 33 430; mul 433 514; mul 513 515;
mul 101 516; mul 449 458; mul 0 518; sub 517 519; mul 0 115; mul 343 521; mul 121 339; add 407 523; mul 273 524; mul
101 525; add 522 526; mul 459 527; add 520 528; mul 507 529; add 504 530; mul 459 531; input p 96; add 420 533;
input p 97; mul 434 535; add 534 536; input p 98; mul 440 538; add 537 539; input p 99; mul 440 535; mul 434 538;
input p 100; sub 543 544; sub 542 545; sub 546 4; mul 547 547; mul 540 540; add 548 549; sqrt 550; mul 541 551; sqrt
552; div 33 553; mul 554 554; mul 541 555; mul 540 556; input p 101; mul 251 552; mul 251 555; mul 555 560; sub 559
561; mul 558 562; sub 552 468; max 467 564; min 466 565; input p 102; input p 103; mul 566 568; add 567 569; mul 566
570; add 33 571; mul 563 572; input p 104; mul 68 574; input p 105; mul 564 576; add 33 577; mul 575 578; sub 573
579; mul 541 580; input p 106; input x 7; mul 582 583; input p 107; input x 9; mul 585 586; add 584 587; input p
108; input x 11; mul 589 590; add 588 591; mul 498 554; mul 554 593; mul 554 594; mul 541 595; mul 592 596; add 581
597; input p 109; mul 596 599; mul 596 600; add 536 539; mul 547 602; sub 543 542; mul 540 604; add 603 605; mul 556
606; mul 515 607; mul 101 608; mul 547 556; mul 0 610; sub 609 611; mul 527 557; add 612 613; mul 601 614; add 598
615; mul 557 616; add 532 617; sub 344 618; mul 343 619; sub 272 620; input p 110; constant 12.0; mul 521 623;
constant -6.0; mul 118 521; mul 101 121; add 626 627; mul 625 628; add 624 629; mul 622 630; mul 521 625; constant
4.0; mul 628 633; add 632 634; mul 622 635; mul 118 636; add 631 637; add 621 638; mul 115 639; mul 518 531; mul 610
616; add 641 642; sub 640 643; sub 114 644; input p 111; input p 112; constant -1.0; input z 0; input start 0; sub 4
650; input p 113; input start 1; sub 7 653; mul 652 654; add 651 655; input p 114; mul 656 657; add 649 658; max 648
659; min 33 660; mul 647 661; input p 115; input z 1; input p 116; mul 656 665; add 664 666; max 648 667; min 33
668; mul 663 669; add 662 670; input p 117; input z 2; input p 118; mul 656 674; add 673 675; max 648 676; min 33
677; mul 672 678; add 671 679; input p 119; input z 3; input p 120; mul 656 683; add 682 684; max 648 685; min 33
686; mul 681 687; add 680 688; sub 646 689; input p 121; abs 0; mul 691 692; mul 0 693; input p 122; mul 0 695; mul
0 0; input p 123; add 697 698; sqrt 699; div 33 700; mul 696 701; add 694 702; sub 690 703; add 645 704; input p
124; input x 12; sub 4 707; mul 706 708; input p 125; input x 13; sub 4 711; mul 710 712; add 709 713; sub 705 714;
mul 0 34; mul 3 101; add 716 717; input x 5; mul 18 719; add 718 720; mul 0 721; mul 0 3; mul 6 101; add 723 724;
mul 10 719; add 725 726; mul 101 727; add 722 728; mul 0 18; mul 10 101; add 730 731; mul 22 719; add 732 733; mul
719 734; add 729 735; mul 2 736; mul 39 737; sub 715 738; mul 61 739; mul 52 60; mul 121 233; mul 116 742; abs 7; lt
744 241; mul 244 251; mul 245 251; input p 126; mul 747 748; mul 746 749; mul 240 250; mul 245 751; add 750 752; mul
244 751; mul 746 754; add 753 755; mul 253 257; mul 746 757; add 756 758; mul 250 257; mul 258 760; add 759 761; mul
116 762; where 745 763; add 743 764; mul 525 619; sub 765 766; mul 121 636; add 767 768; mul 516 531; mul 608 616;
add 770 771; add 769 772; sub 105 773; input p 127; mul 440 775; mul 515 776; add 774 777; mul 652 689; sub 778 779;
mul 13 737; sub 780 781; mul 741 782; sub 740 783; mul 57 60; input p 128; mul 11 786; input p 129; mul 182 788; add
787 789; input p 130; mul 186 791; add 790 792; mul 123 178; add 793 794; input p 131; mul 126 796; add 795 797;
input p 132; mul 130 799; add 798 800; input p 133; mul 134 802; add 801 803; mul 138 195; add 804 805; input p 134;
mul 142 807; add 806 808; mul 125 157; add 809 810; input p 135; mul 161 812; add 811 813; mul 137 165; add 814 815;
input p 136; mul 169 817; add 816 818; mul 152 226; add 819 820; mul 170 225; add 821 822; mul 116 823; constant
0.01904761904761903; mul 11 825; input p 137; mul 186 827; add 826 828; mul 123 308; add 829 830; input p 138; mul
130 832; add 831 833; mul 138 316; add 834 835; mul 142 364; add 836 837; input p 139; mul 161 839; add 838 840; mul
226 293; add 841 842; mul 170 332; add 843 844; add 415 845; mul 273 846; mul 619 847; sub 824 848; input p 140; mul
719 850; add 849 851; mul 24 737; add 852 853; mul 785 854; sub 784 855; mul 27 42; mul 50 50; sub 857 858; mul 60
859; mul 782 860; mul 739 741; sub 861 862; mul 30 42; mul 47 50; sub 864 865; mul 60 866; mul 854 867; add 863 868;
mul 739 785; mul 782 867; sub 870 871; mul 16 42; mul 47 47; sub 873 874; mul 60 875; mul 854 876; sub 872 877; mul
502 529; input p 141; mul 488 880; sub 879 881; mul 596 614; mul 583 880; sub 883 884; input p 142; mul 491 886; sub
879 887; mul 586 886; sub 883 889; input p 143; mul 495 891; sub 879 892; mul 590 891; sub 883 894; input p 144; mul
708 896; input p 145; mul 712 898; store rates 0 0; store rates 1 856; store rates 2 101; store rates 3 869; store
rates 4 719; store rates 5 878; store rates 6 882; store rates 7 885; store rates 8 888; store rates 9 890; store
rates 10 893; store rates 11 895; store rates 12 897; store rates 13 899
    """,
)

SHAPE = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'p': 152},
    {'forces': 3, 'by_shape': 6},
    """
input p 111; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
input x 0; input p 10; mul 11 12; sub 10 13; input c 9; constant 0.5; input c 10; mul 16 17; mul 14 18; sub 15 19;
input c 11; mul 3 21; add 20 22; input c 12; mul 7 24; add 23 25; mul 14 26; add 9 27; input c 4; input c 5; mul 14
30; sub 29 31; input c 6; mul 3 33; add 32 34; input c 7; mul 7 36; add 35 37; mul 12 38; sub 28 39; input p 13;
input p 14; input p 15; input p 16; mul 11 41; mul 44 45; input p 17; mul 10 47; add 46 48; mul 43 49; input p 18;
input x 4; mul 49 52; mul 51 53; add 50 54; input p 19; mul 52 53; mul 56 57; add 55 58; input p 20; mul 49 49; mul
60 61; add 59 62; input p 21; mul 52 61; mul 64 65; add 63 66; input p 22; mul 49 61; mul 68 69; add 67 70; input p
23; mul 45 72; add 71 73; input p 24; mul 45 52; mul 75 76; add 74 77; input p 25; mul 52 76; mul 79 80; add 78 81;
input p 26; mul 45 49; mul 83 84; add 82 85; input p 27; mul 52 84; mul 87 88; add 86 89; input p 28; mul 49 84; mul
91 92; add 90 93; input p 29; mul 45 45; mul 49 96; mul 95 97; add 94 98; input p 30; mul 45 96; mul 100 101; add 99
102; input p 31; input p 32; mul 52 105; add 104 106; input p 33; mul 52 52; mul 108 109; add 107 110; input p 34;
mul 52 109; mul 112 113; add 111 114; input p 35; mul 49 116; add 115 117; input p 36; mul 53 119; add 118 120;
input p 37; mul 57 122; add 121 123; input p 38; mul 61 125; add 124 126; input p 39; mul 65 128; add 127 129; input
p 40; mul 69 131; add 130 132; mul 43 45; add 133 134; mul 51 76; add 135 136; mul 56 80; add 137 138; input p 41;
mul 84 140; add 139 141; input p 42; mul 88 143; add 142 144; input p 43; mul 92 146; add 145 147; input p 44; mul
96 149; add 148 150; input p 45; mul 52 96; mul 152 153; add 151 154; mul 91 97; add 155 156; input p 46; mul 101
158; add 157 159; mul 44 160; add 103 161; mul 42 162; abs 45; constant 0.35; lt 164 165; input p 47; constant 0.6;
constant -0.6; max 169 10; min 168 170; mul 171 171; mul 171 172; mul 167 173; constant -0.35; max 175 45; min 165
176; constant 2.0; mul 177 178; input p 48; mul 172 180; mul 179 181; add 174 182; mul 177 177; input p 49; mul 171
185; mul 184 186; add 183 187; mul 177 186; mul 179 189; add 188 190; mul 178 184; input p 50; mul 192 193; mul 179
194; add 191 195; mul 42 196; where 166 197; add 163 198; input p 51; input p 52; mul 45 201; input p 53; mul 10
203; add 202 204; input p 54; mul 52 206; add 205 207; constant -0.09999999999999995; mul 49 209; input p 55; mul 57
211; add 210 212; input p 56; mul 69 214; add 213 215; constant 1.2; mul 45 217; add 216 218; input p 57; mul 80
220; add 219 221; input p 58; mul 88 223; add 222 224; input p 59; mul 92 226; add 225 227; input p 60; mul 97 229;
add 228 230; input p 61; mul 101 232; add 231 233; constant -0.033333333333333326; mul 52 235; input p 62; mul 113
237; add 236 238; constant 0.13333333333333333; mul 49 240; add 239 241; input p 63; mul 57 243; add 242 244; input
p 64; mul 65 246; add 245 247; input p 65; mul 69 249; add 248 250; mul 45 209; add 251 252; mul 80 211; add 253
254; input p 66; mul 92 256; add 255 257; input p 67; mul 153 259; add 258 260; mul 97 226; add 261 262; input p 68;
mul 101 264; add 263 265; mul 44 266; add 234 267; add 208 268; mul 200 269; input p 69; input p 85; input p 87;
input p 84; constant 1.0; input p 81; mul 10 276; mul 10 277; add 275 278; input p 82; mul 10 280; mul 10 281; add
275 282; sqrt 283; sqrt 279; mul 284 285; div 275 286; mul 279 287; mul 274 288; input p 86; sub 289 290; input p
83; mul 10 285; mul 287 293; mul 292 294; add 291 295; sub 296 11; mul 297 297; input p 70; constant
0.009523809523809514; mul 109 300; input p 71; mul 52 113; mul 302 303; add 301 304; mul 53 235; add 305 306; mul 52
57; mul 237 308; add 307 309; constant 0.06666666666666667; mul 61 311; add 310 312; input p 72; mul 52 65; mul 314
315; add 313 316; input p 73; mul 52 69; mul 318 319; add 317 320; input p 74; mul 49 69; mul 322 323; add 321 324;
mul 84 209; add 325 326; mul 52 88; mul 211 328; add 327 329; mul 49 92; mul 214 331; add 330 332; mul 96 168; add
333 334; input p 75; mul 52 153; mul 336 337; add 335 338; mul 52 97; mul 259 340; add 339 341; input p 76; mul 49
97; mul 343 344; add 342 345; mul 49 101; mul 264 347; add 346 348; input p 77; mul 45 101; mul 350 351; add 349
352; mul 45 208; mul 45 203; input p 78; mul 10 356; add 355 357; input p 79; mul 52 359; add 358 360; mul 10 361;
add 354 362; mul 45 206; mul 10 359; add 364 365; input p 80; mul 52 367; add 366 368; mul 52 369; add 363 370; mul
16 371; add 353 372; mul 200 373; add 299 374; mul 288 292; add 375 376; mul 274 294; sub 377 378; mul 379 379; add
298 380; sqrt 381; mul 272 382; mul 178 383; sqrt 383; div 275 385; mul 386 386; mul 178 387; mul 387 388; sub 384
389; mul 273 390; constant 0.3; constant -0.3; constant 1.4; sub 383 394; max 393 395; min 392 396; input p 88;
input p 89; mul 397 399; add 398 400; mul 397 401; add 275 402; mul 391 403; input p 90; mul 3 405; input p 91; mul
395 407; add 275 408; mul 406 409; sub 404 410; mul 272 411; mul 272 387; mul 379 413; mul 412 414; input p 99;
input p 101; input p 97; mul 294 418; input p 98; mul 288 420; input p 100; sub 421 422; sub 419 423; sub 424 11;
mul 425 425; input p 96; add 374 427; mul 288 418; add 428 429; mul 294 420; add 430 431; mul 432 432; add 426 433;
sqrt 434; mul 416 435; mul 178 436; sqrt 436; div 275 438; mul 439 439; mul 178 440; mul 440 441; sub 437 442; mul
417 443; sub 436 394; max 393 445; min 392 446; input p 102; input p 103; mul 447 449; add 448 450; mul 447 451; add
275 452; mul 444 453; input p 104; mul 7 455; input p 105; mul 445 457; add 275 458; mul 456 459; sub 454 460; mul
416 461; mul 416 440; mul 432 463; mul 462 464; add 415 465; sub 271 466; mul 270 467; sub 199 468; mul 41 469; mul
297 413; mul 412 471; mul 425 463; mul 462 473; add 472 474; sub 470 475; sub 40 476; add 0 477; div 275 284; mul
287 479; input p 127; mul 294 481; mul 480 482; mul 47 160; mul 42 484; abs 10; lt 486 168; mul 171 178; mul 172
178; input p 126; mul 489 490; mul 488 491; mul 167 177; mul 172 493; add 492 494; mul 171 493; mul 488 496; add 495
497; mul 180 184; mul 488 499; add 498 500; mul 177 184; mul 185 502; add 501 503; mul 42 504; where 487 505; add
485 506; mul 47 266; add 361 508; mul 200 509; mul 467 510; sub 507 511; sub 376 378; mul 297 513; add 289 295; mul
379 515; sub 514 516; mul 413 517; mul 480 518; mul 412 519; add 429 431; mul 425 521; sub 421 419; mul 432 523; add
522 524; mul 463 525; mul 480 526; mul 462 527; add 520 528; add 512 529; sub 38 530; add 483 531; input p 128; mul
52 533; input p 129; mul 109 535; add 534 536; input p 130; mul 113 538; add 537 539; mul 49 105; add 540 541; input
p 131; mul 53 543; add 542 544; input p 132; mul 57 546; add 545 547; input p 133; mul 61 549; add 548 550; mul 65
122; add 551 552; input p 134; mul 69 554; add 553 555; mul 51 84; add 556 557; input p 135; mul 88 559; add 558
560; mul 64 92; add 561 562; input p 136; mul 96 564; add 563 565; mul 79 153; add 566 567; mul 97 152; add 568 569;
mul 42 570; constant 0.01904761904761903; mul 52 572; input p 137; mul 113 574; add 573 575; mul 49 235; add 576
577; input p 138; mul 57 579; add 578 580; mul 65 243; add 581 582; mul 69 318; add 583 584; input p 139; mul 88
586; add 585 587; mul 153 220; add 588 589; mul 97 259; add 590 591; add 369 592; mul 200 593; mul 467 594; sub 571
595; neg 596; sub 26 19; mul 12 30; add 598 599; input p 146; mul 47 52; mul 51 602; add 601 603; mul 52 602; mul 56
605; add 604 606; mul 49 178; mul 47 608; mul 60 609; add 607 610; mul 52 609; mul 64 612; add 611 613; mul 49 609;
mul 47 61; add 615 616; mul 68 617; add 614 618; mul 45 47; mul 83 620; add 619 621; mul 52 620; mul 87 623; add 622
624; mul 49 620; mul 47 84; add 626 627; mul 91 628; add 625 629; mul 47 96; mul 95 631; add 630 632; input p 147;
mul 119 602; add 634 635; mul 122 605; add 636 637; mul 125 609; add 638 639; mul 128 612; add 640 641; mul 131 617;
add 642 643; mul 140 620; add 644 645; mul 143 623; add 646 647; mul 146 628; add 648 649; mul 91 631; add 650 651;
mul 44 652; add 633 653; mul 42 654; le 170 168; le 168 170; add 656 657; div 275 658; mul 656 659; le 169 10; le 10
169; add 661 662; div 275 663; mul 661 664; mul 660 665; mul 172 666; mul 488 666; mul 171 668; add 667 669; mul 167
670; mul 180 668; mul 179 672; add 671 673; mul 185 666; mul 184 675; add 674 676; mul 177 675; mul 179 678; add 677
679; mul 42 680; where 166 681; add 655 682; input p 148; mul 211 605; add 684 685; mul 214 617; add 686 687; mul
223 623; add 688 689; mul 226 628; add 690 691; mul 229 631; add 692 693; input p 149; mul 243 605; add 695 696; mul
246 612; add 697 698; mul 249 617; add 699 700; mul 256 628; add 701 702; mul 226 631; add 703 704; mul 44 705; add
694 706; add 203 707; mul 200 708; mul 467 709; mul 178 297; mul 178 277; mul 287 712; mul 287 288; mul 281 479; mul
285 715; div 275 285; mul 277 717; mul 284 718; add 716 719; mul 714 720; sub 713 721; mul 274 722; mul 10 718; add
285 724; mul 287 725; mul 287 294; mul 720 727; sub 726 728; mul 292 729; add 723 730; mul 711 731; mul 178 379; mul
235 602; mul 52 605; mul 237 735; add 734 736; mul 311 609; add 737 738; mul 52 612; mul 314 740; add 739 741; mul
52 617; mul 318 743; add 742 744; mul 49 617; mul 47 69; add 746 747; mul 322 748; add 745 749; mul 209 620; add 750
751; mul 52 623; mul 211 753; add 752 754; mul 49 628; mul 47 92; add 756 757; mul 214 758; add 755 759; mul 52 631;
mul 259 761; add 760 762; mul 49 631; mul 47 97; add 764 765; mul 343 766; add 763 767; mul 47 101; mul 264 769; add
768 770; add 357 361; add 355 772; add 360 773; mul 16 774; add 771 775; mul 200 776; mul 292 722; add 777 778; mul
274 729; sub 779 780; mul 733 781; add 732 782; mul 178 382; div 275 784; mul 783 785; mul 272 786; mul 178 787; mul
178 386; mul 178 385; div 275 790; mul 787 791; mul 387 792; mul 789 793; neg 794; mul 178 795; mul 387 796; mul 388
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
986; input p 150; mul 543 602; add 988 989; mul 546 605; add 990 991; mul 549 609; add 992 993; mul 122 612; add 994
995; mul 554 617; add 996 997; mul 51 620; add 998 999; mul 559 623; add 1000 1001; mul 64 628; add 1002 1003; mul
152 631; add 1004 1005; mul 42 1006; input p 151; mul 579 605; add 1008 1009; mul 243 612; add 1010 1011; mul 318
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
    {'x': 14, 'p': 152},
    {'mass': 6},
    """
input p 1; input x 0; input p 8; mul 1 2; input p 2; input x 2; mul 4 5; add 3 6; input x 4; input p 6; mul 8 9; add
7 10; mul 11 11; mul 0 12; add 0 13; input p 9; mul 1 4; input p 3; mul 5 17; add 16 18; input p 4; mul 8 20; add 19
21; mul 11 22; mul 0 23; add 15 24; input p 0; mul 22 22; mul 0 27; add 26 28; mul 1 9; mul 5 20; add 30 31; input p
7; mul 8 33; add 32 34; mul 11 35; mul 0 36; mul 22 35; mul 0 38; input p 5; mul 35 35; mul 0 41; add 40 42; store
mass 0 14; store mass 1 25; store mass 2 29; store mass 3 37; store mass 4 39; store mass 5 43
    """,
)

STOP_MOVE = Graph(
    {'x': 14, 'z': 4, 'start': 2, 'p': 152},
    {'moved': 4},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 113; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 114; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 116; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 118; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
120; mul 11 30; add 29 31; max 1 32; min 0 33; store moved 0 16; store moved 1 22; store moved 2 28; store moved 3
34
    """,
)
