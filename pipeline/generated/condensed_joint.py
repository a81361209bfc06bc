"""The condensed joint: rates, forces at rest, inertia, stop operators after a step.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

CONSTANTS = ('l', 'bending', 'bending_loss', 'steepening', 'stiffening', 'shortening', 'curvature', 'slope_by_q',
    'slope_by_tau', 'slope_by_beta', 'rotation', 'quartic_qqqq', 'quartic_qqqt', 'quartic_qqqb', 'quartic_qqtt',
    'quartic_qqtb', 'quartic_qqbb', 'quartic_qttt', 'quartic_qttb', 'quartic_qtbb', 'quartic_qbbb',
    'quartic_tttt', 'quartic_tttb', 'quartic_ttbb', 'quartic_tbbb', 'quartic_bbbb', 'mass', 'cross', 'inertia',
    'gyration', 'interior_inertia', 'rise_qq', 'rise_qt', 'rise_tt', 'rise_qb', 'rise_tb', 'rise_bb', 'weight',
    'offset', 'side_force', 'relaxation_0', 'relaxation_1', 'relaxation_2', 'strain_slope', 'viscosity', 'drag',
    'sliding_force', 'sliding_speed', 'friction_arm', 'left_a', 'left_c', 'left_e_z', 'left_e_x', 'left_l0',
    'left_elastic', 'left_hardening', 'left_hardening_slope', 'left_electric', 'left_electric_slope',
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

QUARTICS = ('qqqq', 'qqqt', 'qqqb', 'qqtt', 'qqtb', 'qqbb', 'qttt', 'qttb', 'qtbb', 'qbbb', 'tttt', 'tttb', 'ttbb',
    'tbbb', 'bbbb')

FIRST_ELEMENT = 12

DRY_LEVELS = ('sliding_force',)

AT_REST = (1.0, 1.0)

STOPS = 4

CREEPS = 2

BRANCHES = 3

PREPARE = Graph(
    {'k': 90},
    {'p': 169},
    """
input k 28; input k 29; constant 1.0; input k 10; sub 3 2; input k 26; input k 38; input k 32; input k 33; input k
35; input k 30; input k 34; input k 36; input k 31; input k 27; input k 89; input k 0; div 2 16; mul 15 17; constant
0.5; constant -2.0; input k 2; mul 20 21; input k 44; input k 1; constant -6.000000000000002; constant
-18.000000000000004; input k 6; mul 27 27; input k 4; mul 28 29; mul 26 30; add 25 31; constant
-0.09999999999999995; input k 3; mul 28 34; mul 33 35; add 32 36; input k 7; input k 8; input k 9; constant
28.79999999999999; mul 27 29; mul 41 42; constant -22.62857142857143; mul 29 44; constant -0.057142857142856635; mul
34 46; add 45 47; constant 36.0; mul 42 49; constant -28.799999999999976; mul 29 51; constant 0.05714285714285722;
mul 34 53; add 52 54; constant -50.400000000000006; mul 29 56; constant -1.1428571428571423; mul 34 58; add 57 59;
constant 12.000000000000004; constant 36.000000000000014; mul 30 62; add 61 63; constant 1.2; mul 35 65; add 64 66;
constant -57.60000000000001; mul 42 68; constant 45.25714285714287; mul 29 70; constant 0.9142857142857138; mul 34
72; add 71 73; constant -72.00000000000001; mul 42 75; constant 57.599999999999916; mul 29 77; constant
-1.7142857142857166; mul 34 79; add 78 80; constant 230.40000000000006; mul 29 82; constant 2.057142857142858; mul
34 84; add 83 85; constant -388.80000000000024; mul 29 87; constant -7.714285714285722; mul 34 89; add 88 90;
constant 259.2000000000001; mul 29 92; constant 12.34285714285715; mul 34 94; add 93 95; constant
-0.9999999999999998; mul 27 97; mul 27 28; mul 29 99; mul 97 100; add 98 101; constant -0.033333333333333326; mul 35
103; constant -2.3999999999999995; mul 42 105; constant 0.4571428571428564; mul 29 107; constant
-0.019047619047619094; mul 34 109; add 108 110; constant 4.000000000000001; constant 12.0; mul 30 113; add 112 114;
constant 0.13333333333333333; mul 35 116; add 115 117; constant -14.399999999999991; mul 42 119; constant
13.714285714285717; mul 29 121; constant 0.11428571428571413; mul 34 123; add 122 124; constant -30.000000000000007;
mul 42 126; mul 27 34; sub 127 128; constant 21.59999999999998; mul 29 130; constant 0.6571428571428567; mul 34 132;
add 131 133; constant 35.20000000000001; mul 29 135; constant 2.438095238095238; mul 34 137; add 136 138; constant
72.0; mul 42 140; constant -57.59999999999995; mul 29 142; constant 0.11428571428571443; mul 34 144; add 143 145;
constant -151.20000000000002; mul 29 147; constant -3.428571428571427; mul 34 149; add 148 150; constant
-36.00000000000001; mul 42 152; constant 28.799999999999958; mul 29 154; constant -0.8571428571428583; mul 34 156;
add 155 157; constant -129.60000000000008; mul 29 159; constant -2.5714285714285743; mul 34 161; add 160 162;
constant 4.0; mul 24 164; input k 11; mul 165 166; constant 3.0; mul 24 168; input k 12; mul 169 170; input k 13;
mul 169 172; constant 2.0; mul 24 174; input k 14; mul 175 176; input k 15; mul 175 178; input k 16; mul 175 180;
input k 17; mul 24 182; input k 18; mul 24 184; input k 19; mul 24 186; input k 20; mul 24 188; input k 37; input k
54; input k 49; input k 51; input k 50; input k 52; sub 195 16; constant -0.0006802721088435403; input k 5; mul 197
198; constant 0.0035714285714285787; mul 198 200; constant 0.029931972789115628; mul 198 202; constant
-0.08571428571428567; mul 198 204; constant 0.12857142857142853; mul 198 206; constant -0.38571428571428534; mul 198
208; constant 1.0285714285714285; mul 198 210; constant -0.0004787100025195255; mul 198 212; constant
0.0027210884353741486; mul 198 214; constant -0.010714285714285721; mul 198 216; constant 0.028571428571428567; mul
198 218; constant 0.010714285714285735; mul 198 220; constant -0.04285714285714284; mul 198 222; constant
-0.12857142857142845; mul 198 224; constant 0.00032473894907757275; mul 198 226; constant -0.0014361300075585765;
mul 198 228; constant -0.003571428571428574; mul 198 230; constant -0.0013605442176870806; mul 198 232; input k 53;
div 2 234; input k 55; input k 56; input k 57; input k 58; mul 19 239; constant 0.7142857142857143; sub 239 241; mul
240 242; input k 59; input k 60; input k 61; input k 43; mul 19 247; sub 247 241; mul 248 249; input k 62; input k
68; input k 64; input k 63; input k 65; input k 66; sub 256 16; input k 67; div 2 258; input k 69; input k 70; input
k 71; input k 72; mul 19 263; sub 263 241; mul 264 265; input k 73; input k 74; input k 75; input k 76; input k 39;
input k 77; input k 48; input k 81; div 2 274; input k 78; input k 82; div 2 277; input k 79; input k 83; div 2 280;
input k 80; input k 84; div 2 283; input k 45; input k 46; input k 47; mul 287 287; input k 85; input k 86; mul 3
174; mul 24 170; mul 24 178; mul 169 182; mul 175 184; input k 21; mul 165 296; input k 22; mul 169 298; input k 23;
mul 175 300; input k 24; mul 24 302; mul 6 190; constant 0.8000000000000002; constant 2.400000000000001; mul 30 306;
add 305 307; constant 0.01904761904761903; mul 35 309; add 308 310; constant -1.3714285714285723; mul 42 312;
constant 1.3714285714285714; mul 29 314; constant 0.007256235827664418; mul 34 316; add 315 317; constant
-4.799999999999999; mul 42 319; constant 1.3714285714285692; mul 29 321; constant -0.05714285714285729; mul 34 323;
add 322 324; constant -7.199999999999996; mul 42 326; constant 7.199999999999994; mul 29 328; constant
0.2190476190476189; mul 34 330; add 329 331; constant -45.25714285714286; mul 29 333; constant -0.11428571428571327;
mul 34 335; add 334 336; constant -28.800000000000004; mul 42 338; mul 24 172; mul 175 186; mul 169 188; mul 24 298;
mul 169 302; input k 25; mul 165 345; constant 0.8; mul 21 347; input k 40; input k 41; input k 42; input k 87;
input k 88; mul 37 39; mul 39 118; mul 7 16; mul 39 104; mul 37 40; mul 40 118; mul 11 16; mul 40 104; store p 0 0;
store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9
10; store p 10 11; store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 22; store p 16 23; store p
17 17; store p 18 24; store p 19 37; store p 20 38; store p 21 39; store p 22 40; store p 23 43; store p 24 48;
store p 25 50; store p 26 55; store p 27 60; store p 28 67; store p 29 69; store p 30 74; store p 31 76; store p 32
81; store p 33 86; store p 34 91; store p 35 96; store p 36 102; store p 37 104; store p 38 106; store p 39 111;
store p 40 118; store p 41 120; store p 42 125; store p 43 129; store p 44 134; store p 45 139; store p 46 141;
store p 47 146; store p 48 151; store p 49 153; store p 50 158; store p 51 163; store p 52 167; store p 53 171;
store p 54 173; store p 55 177; store p 56 179; store p 57 181; store p 58 183; store p 59 185; store p 60 187;
store p 61 189; store p 62 16; store p 63 199; store p 64 201; store p 65 203; store p 66 205; store p 67 207; store
p 68 209; store p 69 211; store p 70 213; store p 71 215; store p 72 217; store p 73 219; store p 74 221; store p 75
223; store p 76 225; store p 77 190; store p 78 196; store p 79 227; store p 80 229; store p 81 231; store p 82 233;
store p 83 194; store p 84 192; store p 85 235; store p 86 193; store p 87 191; store p 88 236; store p 89 237;
store p 90 238; store p 91 239; store p 92 243; store p 93 244; store p 94 245; store p 95 246; store p 96 247;
store p 97 250; store p 98 251; store p 99 257; store p 100 253; store p 101 254; store p 102 259; store p 103 255;
store p 104 252; store p 105 260; store p 106 261; store p 107 262; store p 108 263; store p 109 266; store p 110
267; store p 111 268; store p 112 269; store p 113 270; store p 114 21; store p 115 271; store p 116 272; store p
117 273; store p 118 275; store p 119 276; store p 120 278; store p 121 279; store p 122 281; store p 123 282; store
p 124 284; store p 125 285; store p 126 286; store p 127 288; store p 128 289; store p 129 290; store p 130 291;
store p 131 292; store p 132 293; store p 133 294; store p 134 295; store p 135 297; store p 136 299; store p 137
301; store p 138 303; store p 139 304; store p 140 311; store p 141 313; store p 142 318; store p 143 320; store p
144 325; store p 145 327; store p 146 332; store p 147 337; store p 148 339; store p 149 340; store p 150 341; store
p 151 342; store p 152 343; store p 153 344; store p 154 346; store p 155 348; store p 156 349; store p 157 350;
store p 158 351; store p 159 352; store p 160 353; store p 161 354; store p 162 355; store p 163 356; store p 164
357; store p 165 358; store p 166 359; store p 167 360; store p 168 361
    """,
)

RATES = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'start': 2, 'p': 169},
    {'rates': 14},
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
261; input p 51; mul 206 263; add 262 264; mul 147 265; add 208 266; mul 145 267; abs 148; constant 0.35; lt 269
270; input p 52; constant -0.35; max 273 148; min 270 274; mul 275 275; mul 275 276; mul 272 277; input p 53;
constant 0.6; constant -0.6; max 281 3; min 280 282; mul 276 283; mul 279 284; add 278 285; input p 54; constant
2.0; constant -2.0; max 289 35; min 288 290; mul 276 291; mul 287 292; add 286 293; input p 55; mul 275 283; mul 283
296; mul 295 297; add 294 298; input p 56; mul 291 296; mul 300 301; add 299 302; input p 57; mul 275 291; mul 291
305; mul 304 306; add 303 307; input p 58; mul 283 283; mul 283 310; mul 309 311; add 308 312; input p 59; mul 291
310; mul 314 315; add 313 316; input p 60; mul 283 291; mul 291 319; mul 318 320; add 317 321; input p 61; mul 291
291; mul 291 324; mul 323 325; add 322 326; where 271 327; add 268 328; input p 62; mul 67 330; input p 63; mul 162
332; input p 64; mul 174 334; add 333 335; input p 65; mul 185 337; add 336 338; input p 66; mul 193 340; add 339
341; input p 67; mul 197 343; add 342 344; input p 68; mul 202 346; add 345 347; input p 69; mul 206 349; add 348
350; input p 70; mul 218 352; input p 71; mul 162 354; add 353 355; input p 72; mul 170 357; add 356 358; input p
73; mul 174 360; add 359 361; mul 185 332; add 362 363; input p 74; mul 197 365; add 364 366; input p 75; mul 258
368; add 367 369; mul 202 343; add 370 371; input p 76; mul 206 373; add 372 374; mul 147 375; add 351 376; mul 330
377; add 331 378; input p 77; input p 78; mul 29 67; mul 3 37; add 382 383; mul 35 53; add 384 385; mul 104 386;
constant 0.25; mul 148 351; mul 155 375; add 389 390; input p 79; mul 218 392; input p 80; mul 162 394; add 393 395;
mul 170 354; add 396 397; input p 81; mul 174 399; add 398 400; input p 82; mul 193 402; add 401 403; mul 258 337;
add 404 405; mul 202 368; add 406 407; mul 35 408; add 391 409; mul 388 410; mul 330 411; add 387 412; add 381 413;
input p 83; mul 24 415; add 414 416; input p 84; mul 38 418; sub 417 419; input p 85; mul 24 418; input p 86; sub
422 423; mul 38 415; add 424 425; sub 426 29; mul 427 427; mul 420 420; add 428 429; sqrt 430; mul 421 431; sqrt
432; div 2 433; mul 434 434; mul 421 435; mul 420 436; input p 87; mul 288 432; mul 288 435; mul 435 440; sub 439
441; mul 438 442; constant 0.3; constant -0.3; constant 1.4; sub 432 446; max 445 447; min 444 448; input p 88;
input p 89; mul 449 451; add 450 452; mul 449 453; add 2 454; mul 443 455; input p 90; mul 93 457; input p 91; input
p 92; mul 447 460; add 459 461; mul 447 462; add 2 463; mul 458 464; sub 456 465; mul 421 466; input p 93; input x
6; mul 468 469; input p 94; input x 8; mul 471 472; add 470 473; input p 95; input x 10; mul 475 476; add 474 477;
constant -0.5; mul 434 479; mul 434 480; mul 434 481; mul 421 482; input p 96; input p 97; mul 447 485; add 484 486;
mul 447 487; add 2 488; mul 483 489; mul 478 490; add 467 491; input p 98; mul 490 493; mul 490 494; sub 416 419;
mul 427 496; add 422 425; mul 420 498; sub 497 499; mul 436 500; mul 17 501; mul 130 502; mul 427 436; mul 0 504;
sub 503 505; mul 0 144; mul 379 507; mul 150 375; mul 330 509; add 37 510; mul 130 511; add 508 512; mul 153 375;
add 408 514; mul 330 515; add 53 516; input x 5; mul 517 518; add 513 519; mul 437 520; add 506 521; mul 495 522;
add 492 523; mul 437 524; input p 99; add 413 526; input p 100; mul 24 528; add 527 529; input p 101; mul 38 531;
add 530 532; input p 102; mul 38 528; mul 24 531; input p 103; sub 536 537; sub 535 538; sub 539 29; mul 540 540;
mul 533 533; add 541 542; sqrt 543; mul 534 544; sqrt 545; div 2 546; mul 547 547; mul 534 548; mul 533 549; input p
104; mul 288 545; mul 288 548; mul 548 553; sub 552 554; mul 551 555; sub 545 446; max 445 557; min 444 558; input p
105; input p 106; mul 559 561; add 560 562; mul 559 563; add 2 564; mul 556 565; input p 107; mul 97 567; input p
108; input p 109; mul 557 570; add 569 571; mul 557 572; add 2 573; mul 568 574; sub 566 575; mul 534 576; input p
110; input x 7; mul 578 579; input p 111; input x 9; mul 581 582; add 580 583; input p 112; input x 11; mul 585 586;
add 584 587; mul 479 547; mul 547 589; mul 547 590; mul 534 591; mul 485 557; add 484 593; mul 557 594; add 2 595;
mul 592 596; mul 588 597; add 577 598; input p 113; mul 597 600; mul 597 601; add 529 532; mul 540 603; sub 536 535;
mul 533 605; add 604 606; mul 549 607; mul 17 608; mul 130 609; mul 540 549; mul 0 611; sub 610 612; mul 520 550;
add 613 614; mul 602 615; add 599 616; mul 550 617; add 525 618; sub 380 619; mul 379 620; sub 329 621; input p 114;
constant 12.0; mul 507 624; constant -6.0; mul 147 507; mul 130 150; add 627 628; mul 153 518; add 629 630; mul 626
631; add 625 632; mul 623 633; mul 507 626; constant 4.0; mul 631 636; add 635 637; mul 623 638; mul 147 639; add
634 640; add 622 641; mul 144 642; mul 504 524; mul 611 617; add 644 645; sub 643 646; sub 143 647; input p 115;
input p 116; constant -1.0; input z 0; input start 0; sub 29 653; input p 117; input start 1; sub 3 656; mul 655
657; add 654 658; input p 118; mul 659 660; add 652 661; max 651 662; min 2 663; mul 650 664; input p 119; input z
1; input p 120; mul 659 668; add 667 669; max 651 670; min 2 671; mul 666 672; add 665 673; input p 121; input z 2;
input p 122; mul 659 677; add 676 678; max 651 679; min 2 680; mul 675 681; add 674 682; input p 123; input z 3;
input p 124; mul 659 686; add 685 687; max 651 688; min 2 689; mul 684 690; add 683 691; sub 649 692; input p 125;
abs 0; mul 694 695; mul 0 696; input p 126; mul 0 698; mul 0 0; input p 127; add 700 701; sqrt 702; div 2 703; mul
699 704; add 697 705; sub 693 706; add 648 707; input p 128; input x 12; sub 29 710; mul 709 711; input p 129; input
x 13; sub 29 714; mul 713 715; add 712 716; sub 708 717; mul 0 62; mul 28 130; add 719 720; mul 47 518; add 721 722;
mul 0 723; mul 0 28; mul 31 130; add 725 726; mul 34 518; add 727 728; mul 130 729; add 724 730; mul 0 47; mul 34
130; add 732 733; mul 51 518; add 734 735; mul 518 736; add 731 737; mul 17 130; mul 130 739; mul 23 740; input p
130; mul 9 742; mul 9 743; mul 8 16; mul 10 745; mul 745 746; add 744 747; mul 3 748; mul 38 749; sub 25 750; mul
741 751; add 738 752; mul 67 753; mul 24 749; add 39 755; mul 741 756; sub 754 757; mul 22 758; sub 718 759; mul 90
760; mul 81 89; mul 150 265; mul 145 763; abs 3; lt 765 280; input p 131; mul 277 767; mul 284 295; add 768 769;
input p 132; mul 292 771; add 770 772; input p 133; mul 297 774; add 773 775; input p 134; mul 301 777; add 776 778;
mul 306 318; add 779 780; input p 135; mul 311 782; add 781 783; input p 136; mul 315 785; add 784 786; input p 137;
mul 320 788; add 787 789; input p 138; mul 325 791; add 790 792; where 766 793; add 764 794; mul 511 620; sub 795
796; mul 150 639; add 797 798; mul 502 524; mul 609 617; add 800 801; add 799 802; sub 134 803; input p 139; mul 38
805; mul 17 806; add 804 807; mul 655 692; sub 808 809; mul 41 753; mul 26 757; sub 811 812; mul 22 813; mul 19 749;
mul 740 815; sub 814 816; sub 810 817; mul 762 818; sub 761 819; mul 86 89; input p 140; mul 35 822; input p 141;
mul 214 824; add 823 825; input p 142; mul 218 827; add 826 828; mul 155 210; add 829 830; input p 143; mul 158 832;
add 831 833; input p 144; mul 162 835; add 834 836; input p 145; mul 166 838; add 837 839; mul 170 227; add 840 841;
input p 146; mul 174 843; add 842 844; mul 157 189; add 845 846; input p 147; mul 193 848; add 847 849; mul 169 197;
add 850 851; input p 148; mul 201 853; add 852 854; mul 184 258; add 855 856; mul 202 257; add 857 858; mul 153 265;
add 859 860; mul 145 861; abs 35; lt 863 288; input p 149; mul 277 865; mul 284 771; add 866 867; mul 292 304; add
868 869; mul 297 314; add 870 871; input p 150; mul 301 873; add 872 874; input p 151; mul 306 876; add 875 877;
input p 152; mul 311 879; add 878 880; mul 315 788; add 881 882; input p 153; mul 320 884; add 883 885; input p 154;
mul 325 887; add 886 888; where 864 889; add 862 890; mul 517 620; sub 891 892; input p 155; mul 518 894; mul 153
639; add 895 896; add 893 897; mul 53 753; mul 22 899; add 898 900; mul 821 901; sub 820 902; mul 56 70; mul 79 79;
sub 904 905; mul 89 906; mul 818 907; mul 760 762; sub 908 909; mul 59 70; mul 76 79; sub 911 912; mul 89 913; mul
901 914; add 910 915; mul 760 821; mul 818 914; sub 917 918; mul 45 70; mul 76 76; sub 920 921; mul 89 922; mul 901
923; sub 919 924; mul 490 522; input p 156; mul 469 927; sub 926 928; mul 597 615; mul 579 927; sub 930 931; input p
157; mul 472 933; sub 926 934; mul 582 933; sub 930 936; input p 158; mul 476 938; sub 926 939; mul 586 938; sub 930
941; input p 159; mul 711 943; input p 160; mul 715 945; store rates 0 0; store rates 1 903; store rates 2 130;
store rates 3 916; store rates 4 518; store rates 5 925; store rates 6 929; store rates 7 932; store rates 8 935;
store rates 9 937; store rates 10 940; store rates 11 942; store rates 12 944; store rates 13 946
    """,
)

SHAPE = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'p': 169},
    {'forces': 3, 'by_shape': 6},
    """
input p 115; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
input x 0; input p 14; mul 11 12; sub 10 13; input c 9; constant 0.5; input c 10; mul 16 17; mul 14 18; sub 15 19;
input c 11; mul 3 21; add 20 22; input c 12; mul 7 24; add 23 25; mul 14 26; add 9 27; input c 4; input c 5; mul 14
30; sub 29 31; input c 6; mul 3 33; add 32 34; input c 7; mul 7 36; add 35 37; mul 12 38; sub 28 39; input p 17;
input p 18; input p 19; input p 20; mul 11 41; mul 44 45; input p 21; mul 10 47; add 46 48; input x 4; input p 22;
mul 50 51; add 49 52; mul 43 53; input p 23; mul 50 53; mul 55 56; add 54 57; input p 24; mul 50 56; mul 59 60; add
58 61; input p 25; mul 53 53; mul 63 64; add 62 65; input p 26; mul 50 64; mul 67 68; add 66 69; input p 27; mul 53
64; mul 71 72; add 70 73; input p 28; mul 45 75; add 74 76; input p 29; mul 45 50; mul 78 79; add 77 80; input p 30;
mul 50 79; mul 82 83; add 81 84; input p 31; mul 45 53; mul 86 87; add 85 88; input p 32; mul 50 87; mul 90 91; add
89 92; input p 33; mul 53 87; mul 94 95; add 93 96; input p 34; mul 45 45; mul 53 99; mul 98 100; add 97 101; input
p 35; mul 45 99; mul 103 104; add 102 105; input p 36; input p 37; mul 50 108; add 107 109; input p 38; mul 50 50;
mul 111 112; add 110 113; input p 39; mul 50 112; mul 115 116; add 114 117; input p 40; mul 53 119; add 118 120;
input p 41; mul 56 122; add 121 123; input p 42; mul 60 125; add 124 126; input p 43; mul 64 128; add 127 129; input
p 44; mul 68 131; add 130 132; input p 45; mul 72 134; add 133 135; mul 43 45; add 136 137; mul 55 79; add 138 139;
mul 59 83; add 140 141; input p 46; mul 87 143; add 142 144; input p 47; mul 91 146; add 145 147; input p 48; mul 95
149; add 148 150; input p 49; mul 99 152; add 151 153; input p 50; mul 50 99; mul 155 156; add 154 157; mul 94 100;
add 158 159; input p 51; mul 104 161; add 160 162; mul 44 163; add 106 164; mul 42 165; abs 45; constant 0.35; lt
167 168; input p 52; constant -0.35; max 171 45; min 168 172; mul 173 173; mul 173 174; mul 170 175; input p 53;
constant 0.6; constant -0.6; max 179 10; min 178 180; mul 174 181; mul 177 182; add 176 183; input p 54; constant
2.0; constant -2.0; max 187 50; min 186 188; mul 174 189; mul 185 190; add 184 191; input p 55; mul 173 181; mul 181
194; mul 193 195; add 192 196; input p 56; mul 189 194; mul 198 199; add 197 200; input p 57; mul 173 189; mul 189
203; mul 202 204; add 201 205; input p 58; mul 181 181; mul 181 208; mul 207 209; add 206 210; input p 59; mul 189
208; mul 212 213; add 211 214; input p 60; mul 181 189; mul 189 217; mul 216 218; add 215 219; input p 61; mul 189
189; mul 189 222; mul 221 223; add 220 224; where 169 225; add 166 226; input p 12; mul 11 228; input p 6; mul 10
230; add 229 231; input p 10; mul 50 233; add 232 234; input p 62; mul 235 236; input p 63; mul 60 238; input p 64;
mul 72 240; add 239 241; input p 65; mul 83 243; add 242 244; input p 66; mul 91 246; add 245 247; input p 67; mul
95 249; add 248 250; input p 68; mul 100 252; add 251 253; input p 69; mul 104 255; add 254 256; input p 70; mul 116
258; input p 71; mul 60 260; add 259 261; input p 72; mul 68 263; add 262 264; input p 73; mul 72 266; add 265 267;
mul 83 238; add 268 269; input p 74; mul 95 271; add 270 272; input p 75; mul 156 274; add 273 275; mul 100 249; add
276 277; input p 76; mul 104 279; add 278 280; mul 44 281; add 257 282; mul 236 283; add 237 284; input p 77; input
p 85; input p 87; constant 1.0; input p 1; mul 10 290; mul 10 291; add 289 292; sqrt 293; div 289 294; input p 2;
mul 10 296; mul 10 297; add 289 298; sqrt 299; mul 295 300; input p 84; mul 301 302; input p 86; sub 303 304; mul 10
295; input p 83; mul 306 307; add 305 308; sub 309 11; mul 310 310; input p 78; mul 11 235; mul 11 230; input p 7;
mul 10 315; add 314 316; input p 8; mul 50 318; add 317 319; mul 10 320; add 313 321; mul 11 233; mul 10 318; add
323 324; input p 11; mul 50 326; add 325 327; mul 50 328; add 322 329; mul 16 330; constant 0.25; mul 45 257; mul 53
281; add 333 334; input p 79; mul 116 336; input p 80; mul 60 338; add 337 339; mul 68 260; add 340 341; input p 81;
mul 72 343; add 342 344; input p 82; mul 91 346; add 345 347; mul 156 243; add 348 349; mul 100 274; add 350 351;
mul 50 352; add 335 353; mul 332 354; mul 236 355; add 331 356; add 312 357; mul 301 307; add 358 359; mul 302 306;
sub 360 361; mul 362 362; add 311 363; sqrt 364; mul 287 365; mul 186 366; sqrt 366; div 289 368; mul 369 369; mul
186 370; mul 370 371; sub 367 372; mul 288 373; constant 0.3; constant -0.3; constant 1.4; sub 366 377; max 376 378;
min 375 379; input p 88; input p 89; mul 380 382; add 381 383; mul 380 384; add 289 385; mul 374 386; input p 90;
mul 3 388; input p 91; input p 92; mul 378 391; add 390 392; mul 378 393; add 289 394; mul 389 395; sub 387 396; mul
287 397; mul 287 370; mul 362 399; mul 398 400; input p 102; input p 104; input p 100; mul 306 404; input p 101; mul
301 406; input p 103; sub 407 408; sub 405 409; sub 410 11; mul 411 411; input p 99; add 357 413; mul 301 404; add
414 415; mul 306 406; add 416 417; mul 418 418; add 412 419; sqrt 420; mul 402 421; mul 186 422; sqrt 422; div 289
424; mul 425 425; mul 186 426; mul 426 427; sub 423 428; mul 403 429; sub 422 377; max 376 431; min 375 432; input p
105; input p 106; mul 433 435; add 434 436; mul 433 437; add 289 438; mul 430 439; input p 107; mul 7 441; input p
108; input p 109; mul 431 444; add 443 445; mul 431 446; add 289 447; mul 442 448; sub 440 449; mul 402 450; mul 402
426; mul 418 452; mul 451 453; add 401 454; sub 286 455; mul 285 456; sub 227 457; mul 41 458; mul 310 399; mul 398
460; mul 411 452; mul 451 462; add 461 463; sub 459 464; sub 40 465; add 0 466; mul 294 300; div 289 468; mul 295
469; input p 139; mul 306 471; mul 470 472; mul 47 163; mul 42 474; abs 10; lt 476 178; input p 131; mul 175 478;
mul 182 193; add 479 480; input p 132; mul 190 482; add 481 483; input p 133; mul 195 485; add 484 486; input p 134;
mul 199 488; add 487 489; mul 204 216; add 490 491; input p 135; mul 209 493; add 492 494; input p 136; mul 213 496;
add 495 497; input p 137; mul 218 499; add 498 500; input p 138; mul 223 502; add 501 503; where 477 504; add 475
505; mul 47 281; mul 236 507; add 320 508; mul 456 509; sub 506 510; sub 359 361; mul 310 512; add 303 308; mul 362
514; sub 513 515; mul 399 516; mul 470 517; mul 398 518; add 415 417; mul 411 520; sub 407 405; mul 418 522; add 521
523; mul 452 524; mul 470 525; mul 451 526; add 519 527; add 511 528; sub 38 529; add 473 530; input p 140; mul 50
532; input p 141; mul 112 534; add 533 535; input p 142; mul 116 537; add 536 538; mul 53 108; add 539 540; input p
143; mul 56 542; add 541 543; input p 144; mul 60 545; add 544 546; input p 145; mul 64 548; add 547 549; mul 68
125; add 550 551; input p 146; mul 72 553; add 552 554; mul 55 87; add 555 556; input p 147; mul 91 558; add 557
559; mul 67 95; add 560 561; input p 148; mul 99 563; add 562 564; mul 82 156; add 565 566; mul 100 155; add 567
568; mul 51 163; add 569 570; mul 42 571; abs 50; lt 573 186; input p 149; mul 175 575; mul 182 482; add 576 577;
mul 190 202; add 578 579; mul 195 212; add 580 581; input p 150; mul 199 583; add 582 584; input p 151; mul 204 586;
add 585 587; input p 152; mul 209 589; add 588 590; mul 213 499; add 591 592; input p 153; mul 218 594; add 593 595;
input p 154; mul 223 597; add 596 598; where 574 599; add 572 600; mul 51 281; add 352 602; mul 236 603; add 328
604; mul 456 605; sub 601 606; neg 607; sub 26 19; mul 12 30; add 609 610; input p 161; mul 47 50; mul 55 613; add
612 614; mul 50 613; mul 59 616; add 615 617; mul 53 186; mul 47 619; mul 63 620; add 618 621; mul 50 620; mul 67
623; add 622 624; mul 53 620; mul 47 64; add 626 627; mul 71 628; add 625 629; mul 45 47; mul 86 631; add 630 632;
mul 50 631; mul 90 634; add 633 635; mul 53 631; mul 47 87; add 637 638; mul 94 639; add 636 640; mul 47 99; mul 98
642; add 641 643; input p 162; mul 122 613; add 645 646; mul 125 616; add 647 648; mul 128 620; add 649 650; mul 131
623; add 651 652; mul 134 628; add 653 654; mul 143 631; add 655 656; mul 146 634; add 657 658; mul 149 639; add 659
660; mul 94 642; add 661 662; mul 44 663; add 644 664; mul 42 665; le 180 178; le 178 180; add 667 668; div 289 669;
mul 667 670; le 179 10; le 10 179; add 672 673; div 289 674; mul 672 675; mul 671 676; mul 174 677; mul 177 678; mul
173 677; mul 181 680; mul 194 677; add 681 682; mul 193 683; add 679 684; mul 189 680; mul 198 686; add 685 687; mul
181 186; mul 677 689; mul 181 690; mul 208 677; add 691 692; mul 207 693; add 688 694; mul 189 690; mul 212 696; add
695 697; mul 189 677; mul 189 699; mul 216 700; add 698 701; where 169 702; add 666 703; input p 163; mul 238 616;
mul 240 628; add 706 707; mul 246 634; add 708 709; mul 249 639; add 710 711; mul 252 642; add 712 713; mul 260 616;
mul 263 623; add 715 716; mul 266 628; add 717 718; mul 271 639; add 719 720; mul 249 642; add 721 722; mul 44 723;
add 714 724; mul 236 725; add 705 726; mul 456 727; mul 186 310; div 289 300; mul 297 730; mul 295 731; mul 295 301;
mul 291 295; mul 733 734; sub 732 735; mul 302 736; mul 295 306; mul 734 738; sub 295 739; mul 307 740; add 737 741;
mul 729 742; mul 186 362; add 316 320; add 314 745; add 319 746; mul 16 747; mul 45 714; mul 53 723; add 507 750;
add 749 751; mul 338 616; mul 260 623; add 753 754; mul 343 628; add 755 756; mul 346 634; add 757 758; mul 274 642;
add 759 760; mul 50 761; add 752 762; mul 332 763; mul 236 764; add 748 765; mul 307 736; add 766 767; mul 302 740;
sub 768 769; mul 744 770; add 743 771; mul 186 365; div 289 773; mul 772 774; mul 287 775; mul 186 776; mul 186 369;
mul 186 368; div 289 779; mul 776 780; mul 370 781; mul 778 782; neg 783; mul 186 784; mul 370 785; mul 371 783; sub
786 787; sub 777 788; mul 288 789; mul 386 790; le 379 375; le 375 379; add 792 793; div 289 794; mul 792 795; le
376 378; le 378 376; add 797 798; div 289 799; mul 797 800; mul 776 801; mul 796 802; mul 382 803; mul 380 804; mul
384 803; add 805 806; mul 374 807; add 791 808; mul 391 776; mul 378 810; mul 393 776; add 811 812; mul 389 813; sub
809 814; mul 287 815; mul 400 816; mul 399 770; mul 287 783; mul 362 819; sub 818 820; mul 398 821; add 817 822; mul
186 411; mul 404 740; mul 406 736; sub 825 826; mul 824 827; mul 186 418; mul 404 736; add 766 830; mul 406 740; add
831 832; mul 829 833; add 828 834; mul 186 421; div 289 836; mul 835 837; mul 402 838; mul 186 839; mul 186 425; mul
186 424; div 289 842; mul 839 843; mul 426 844; mul 841 845; neg 846; mul 186 847; mul 426 848; mul 427 846; sub 849
850; sub 840 851; mul 403 852; mul 439 853; le 432 375; le 375 432; add 855 856; div 289 857; mul 855 858; le 376
431; le 431 376; add 860 861; div 289 862; mul 860 863; mul 839 864; mul 859 865; mul 435 866; mul 433 867; mul 437
866; add 868 869; mul 430 870; add 854 871; mul 444 839; mul 431 873; mul 446 839; add 874 875; mul 442 876; sub 872
877; mul 402 878; mul 453 879; mul 452 833; mul 402 846; mul 418 882; sub 881 883; mul 451 884; add 880 885; add 823
886; mul 285 887; sub 728 888; sub 704 889; mul 41 890; mul 460 816; mul 399 742; mul 310 819; sub 893 894; mul 398
895; add 892 896; mul 462 879; mul 452 827; mul 411 882; sub 899 900; mul 451 901; add 898 902; add 897 903; sub 891
904; sub 611 905; mul 471 740; mul 470 907; mul 295 295; mul 734 909; mul 469 910; mul 469 470; mul 300 734; mul 294
731; add 913 914; mul 912 915; add 911 916; mul 472 917; sub 908 918; mul 47 663; mul 42 920; mul 193 678; mul 485
683; add 922 923; mul 488 686; add 924 925; mul 493 693; add 926 927; mul 496 696; add 928 929; mul 499 700; add 930
931; where 477 932; add 921 933; mul 47 723; mul 236 935; add 315 936; mul 456 937; mul 509 887; sub 938 939; sub
934 940; mul 518 816; mul 512 742; sub 767 769; mul 310 944; add 943 945; mul 514 770; mul 362 742; add 947 948; sub
946 949; mul 399 950; mul 516 819; sub 951 952; mul 470 953; mul 517 917; sub 954 955; mul 398 956; add 942 957; mul
526 879; mul 520 827; add 830 832; mul 411 961; add 960 962; mul 522 833; sub 826 825; mul 418 965; add 964 966; add
963 967; mul 452 968; mul 524 882; sub 969 970; mul 470 971; mul 525 917; sub 972 973; mul 451 974; add 959 975; add
958 976; add 941 977; add 30 978; sub 919 979; input p 164; mul 542 613; add 981 982; mul 545 616; add 983 984; mul
548 620; add 985 986; mul 125 623; add 987 988; mul 553 628; add 989 990; mul 55 631; add 991 992; mul 558 634; add
993 994; mul 67 639; add 995 996; mul 155 642; add 997 998; mul 51 663; add 999 1000; mul 42 1001; mul 482 678; mul
212 683; add 1003 1004; mul 583 686; add 1005 1006; mul 589 693; add 1007 1008; mul 499 696; add 1009 1010; mul 594
700; add 1011 1012; where 574 1013; add 1002 1014; mul 51 723; add 761 1016; mul 236 1017; add 318 1018; mul 456
1019; mul 605 887; sub 1020 1021; sub 1015 1022; neg 1023; input p 165; add 52 53; mul 55 1026; add 1025 1027; mul
50 1026; add 56 1029; mul 59 1030; add 1028 1031; mul 51 619; mul 63 1033; add 1032 1034; mul 50 1033; add 64 1036;
mul 67 1037; add 1035 1038; mul 53 1033; mul 51 64; add 1040 1041; mul 71 1042; add 1039 1043; mul 45 78; add 1044
1045; mul 79 186; mul 82 1047; add 1046 1048; mul 45 51; mul 86 1050; add 1049 1051; mul 50 1050; add 87 1053; mul
90 1054; add 1052 1055; mul 53 1050; mul 51 87; add 1057 1058; mul 94 1059; add 1056 1060; mul 51 99; mul 98 1062;
add 1061 1063; mul 50 186; mul 111 1065; add 108 1066; mul 50 1065; add 112 1068; mul 115 1069; add 1067 1070; input
p 166; add 1071 1072; mul 122 1026; add 1073 1074; mul 125 1030; add 1075 1076; mul 128 1033; add 1077 1078; mul 131
1037; add 1079 1080; mul 134 1042; add 1081 1082; mul 45 55; add 1083 1084; mul 59 1047; add 1085 1086; mul 143
1050; add 1087 1088; mul 146 1054; add 1089 1090; mul 149 1059; add 1091 1092; mul 99 155; add 1093 1094; mul 94
1062; add 1095 1096; mul 44 1097; add 1064 1098; mul 42 1099; le 188 186; le 186 188; add 1101 1102; div 289 1103;
mul 1101 1104; le 187 50; le 50 187; add 1106 1107; div 289 1108; mul 1106 1109; mul 1105 1110; mul 174 1111; mul
185 1112; mul 194 1111; mul 198 1114; add 1113 1115; mul 173 1111; mul 189 1117; mul 203 1111; add 1118 1119; mul
202 1120; add 1116 1121; mul 208 1111; mul 212 1123; add 1122 1124; mul 181 1111; mul 189 1126; mul 217 1111; add
1127 1128; mul 216 1129; add 1125 1130; mul 186 189; mul 1111 1132; mul 189 1133; mul 222 1111; add 1134 1135; mul
221 1136; add 1131 1137; where 169 1138; add 1100 1139; input p 167; mul 238 1030; mul 240 1042; add 1142 1143; mul
243 1047; add 1144 1145; mul 246 1054; add 1146 1147; mul 249 1059; add 1148 1149; mul 252 1062; add 1150 1151; mul
258 1069; mul 260 1030; add 1153 1154; mul 263 1037; add 1155 1156; mul 266 1042; add 1157 1158; mul 238 1047; add
1159 1160; mul 271 1059; add 1161 1162; mul 99 274; add 1163 1164; mul 249 1062; add 1165 1166; mul 44 1167; add
1152 1168; mul 236 1169; add 1141 1170; mul 456 1171; add 327 328; add 325 1173; mul 16 1174; mul 45 1152; mul 53
1167; add 602 1177; add 1176 1178; mul 336 1069; mul 338 1030; add 1180 1181; mul 260 1037; add 1182 1183; mul 343
1042; add 1184 1185; mul 346 1054; add 1186 1187; mul 99 243; add 1188 1189; mul 274 1062; add 1190 1191; mul 50
1192; add 352 1193; add 1179 1194; mul 332 1195; mul 236 1196; add 1175 1197; mul 744 1198; mul 774 1199; mul 287
1200; mul 186 1201; mul 780 1201; mul 370 1203; mul 778 1204; neg 1205; mul 186 1206; mul 370 1207; mul 371 1205;
sub 1208 1209; sub 1202 1210; mul 288 1211; mul 386 1212; mul 801 1201; mul 796 1214; mul 382 1215; mul 380 1216;
mul 384 1215; add 1217 1218; mul 374 1219; add 1213 1220; mul 391 1201; mul 378 1222; mul 393 1201; add 1223 1224;
mul 389 1225; sub 1221 1226; mul 287 1227; mul 400 1228; mul 399 1198; mul 287 1205; mul 362 1231; sub 1230 1232;
mul 398 1233; add 1229 1234; mul 829 1198; mul 837 1236; mul 402 1237; mul 186 1238; mul 843 1238; mul 426 1240; mul
841 1241; neg 1242; mul 186 1243; mul 426 1244; mul 427 1242; sub 1245 1246; sub 1239 1247; mul 403 1248; mul 439
1249; mul 864 1238; mul 859 1251; mul 435 1252; mul 433 1253; mul 437 1252; add 1254 1255; mul 430 1256; add 1250
1257; mul 444 1238; mul 431 1259; mul 446 1238; add 1260 1261; mul 442 1262; sub 1258 1263; mul 402 1264; mul 453
1265; mul 452 1198; mul 402 1242; mul 418 1268; sub 1267 1269; mul 451 1270; add 1266 1271; add 1235 1272; mul 285
1273; sub 1172 1274; sub 1140 1275; mul 41 1276; mul 460 1228; mul 310 1231; mul 398 1279; sub 1278 1280; mul 462
1265; mul 411 1268; mul 451 1283; sub 1282 1284; add 1281 1285; sub 1277 1286; neg 1287; mul 47 1097; mul 42 1289;
mul 482 1112; mul 488 1114; add 1291 1292; mul 216 1120; add 1293 1294; mul 496 1123; add 1295 1296; mul 499 1129;
add 1297 1298; mul 502 1136; add 1299 1300; where 477 1301; add 1290 1302; mul 47 1167; mul 236 1304; add 318 1305;
mul 456 1306; mul 509 1273; sub 1307 1308; sub 1303 1309; mul 518 1228; mul 514 1198; mul 399 1312; mul 516 1231;
add 1313 1314; mul 470 1315; mul 398 1316; sub 1311 1317; mul 526 1265; mul 522 1198; mul 452 1320; mul 524 1268;
sub 1321 1322; mul 470 1323; mul 451 1324; add 1319 1325; add 1318 1326; add 1310 1327; neg 1328; mul 534 1065; add
532 1330; mul 537 1069; add 1331 1332; input p 168; add 1333 1334; mul 542 1026; add 1335 1336; mul 545 1030; add
1337 1338; mul 548 1033; add 1339 1340; mul 125 1037; add 1341 1342; mul 553 1042; add 1343 1344; mul 55 1050; add
1345 1346; mul 558 1054; add 1347 1348; mul 67 1059; add 1349 1350; mul 82 99; add 1351 1352; mul 155 1062; add 1353
1354; mul 51 1097; add 1355 1356; mul 42 1357; mul 202 1112; mul 583 1114; add 1359 1360; mul 586 1120; add 1361
1362; mul 499 1123; add 1363 1364; mul 594 1129; add 1365 1366; mul 597 1136; add 1367 1368; where 574 1369; add
1358 1370; mul 51 1167; add 1192 1372; mul 236 1373; add 326 1374; mul 456 1375; mul 605 1273; sub 1376 1377; sub
1371 1378; neg 1379; store forces 0 467; store forces 1 531; store forces 2 608; store by_shape 0 906; store
by_shape 2 980; store by_shape 4 1024; store by_shape 1 1288; store by_shape 3 1329; store by_shape 5 1380
    """,
)

INERTIA = Graph(
    {'x': 14, 'p': 169},
    {'mass': 6},
    """
input p 4; constant 1.0; input x 0; input p 12; mul 2 3; input x 2; input p 6; mul 5 6; add 4 7; input x 4; input p
10; mul 9 10; add 8 11; mul 12 12; add 1 13; mul 0 14; input p 13; input p 5; input p 1; mul 5 18; mul 5 19; add 1
20; sqrt 21; div 1 22; input p 2; mul 5 24; mul 5 25; add 1 26; sqrt 27; mul 22 28; div 1 29; mul 23 30; mul 23 28;
mul 31 32; mul 17 33; mul 2 6; input p 7; mul 5 36; add 35 37; input p 8; mul 9 39; add 38 40; mul 5 23; mul 31 42;
mul 17 43; add 41 44; mul 12 45; add 34 46; mul 0 47; add 16 48; input p 0; input p 3; mul 31 51; mul 31 52; add 50
53; mul 34 34; mul 45 45; add 55 56; mul 0 57; add 54 58; mul 2 10; mul 5 39; add 60 61; input p 11; mul 9 63; add
62 64; mul 12 65; mul 0 66; mul 45 65; mul 0 68; input p 9; mul 65 65; mul 0 71; add 70 72; store mass 0 15; store
mass 1 49; store mass 2 59; store mass 3 67; store mass 4 69; store mass 5 73
    """,
)

STOP_MOVE = Graph(
    {'x': 14, 'z': 4, 'start': 2, 'p': 169},
    {'moved': 4},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 117; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 118; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 120; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 122; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
124; mul 11 30; add 29 31; max 1 32; min 0 33; store moved 0 16; store moved 1 22; store moved 2 28; store moved 3
34
    """,
)
