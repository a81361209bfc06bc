"""The condensed joint: rates, forces at rest, inertia, stop operators after a step.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

CONSTANTS = ('l', 'bending', 'bending_loss', 'steepening', 'stiffening', 'shortening', 'curvature', 'slope_by_q',
    'slope_by_tau', 'slope_by_beta', 'shortening_qq', 'shortening_qt', 'shortening_tt', 'shortening_qb',
    'shortening_tb', 'shortening_bb', 'rotation', 'quartic_qqqq', 'quartic_qqqt', 'quartic_qqqb', 'quartic_qqtt',
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
    {'k': 96},
    {'p': 176},
    """
input k 34; input k 35; constant 1.0; input k 16; sub 3 2; input k 32; input k 44; input k 38; input k 39; input k
41; input k 36; input k 40; input k 42; input k 37; input k 33; input k 95; input k 0; div 2 16; mul 15 17; constant
0.5; constant -2.0; input k 2; mul 20 21; input k 50; input k 1; constant -6.000000000000002; constant
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
constant 2.0; input k 26; input k 25; input k 24; input k 23; input k 22; input k 21; input k 20; input k 19; input
k 18; input k 17; input k 43; input k 60; input k 55; input k 57; input k 56; input k 58; sub 180 16; constant
8.118473726939319e-05; input k 5; mul 182 183; constant -0.0004787100025195255; mul 183 185; constant
0.0013605442176870743; mul 183 187; constant -0.003571428571428574; mul 183 189; constant 0.007142857142857142; mul
183 191; constant -0.0006802721088435403; mul 183 193; constant 0.0035714285714285787; mul 183 195; constant
0.014965986394557814; mul 183 197; constant -0.04285714285714284; mul 183 199; constant 0.06428571428571427; mul 183
201; constant -0.12857142857142845; mul 183 203; constant 0.2571428571428571; mul 183 205; input k 10; input k 11;
input k 13; input k 12; input k 14; input k 15; input k 59; div 2 213; input k 61; input k 62; input k 63; input k
64; mul 19 218; constant 0.7142857142857143; sub 218 220; mul 219 221; input k 65; input k 66; input k 67; input k
49; mul 19 226; sub 226 220; mul 227 228; input k 68; constant 0.029931972789115628; mul 183 231; constant
-0.08571428571428567; mul 183 233; constant 0.12857142857142853; mul 183 235; constant -0.38571428571428534; mul 183
237; constant 1.0285714285714285; mul 183 239; constant 0.0027210884353741486; mul 183 241; constant
-0.010714285714285721; mul 183 243; constant 0.028571428571428567; mul 183 245; constant 0.010714285714285735; mul
183 247; constant 0.01904761904761903; constant 0.00032473894907757275; mul 183 250; constant
-0.0014361300075585765; mul 183 252; constant -0.0013605442176870806; mul 183 254; input k 74; input k 70; input k
69; input k 71; input k 72; sub 260 16; input k 73; div 2 262; input k 75; input k 76; input k 77; input k 78; mul
19 267; sub 267 220; mul 268 269; input k 79; input k 80; input k 81; input k 82; input k 45; input k 83; input k
54; input k 87; div 2 278; input k 84; input k 88; div 2 281; input k 85; input k 89; div 2 284; input k 86; input k
90; div 2 287; input k 51; input k 52; input k 53; mul 291 291; input k 91; input k 92; mul 3 164; input k 30; input
k 29; input k 28; input k 27; mul 6 175; constant 0.8000000000000002; constant 2.400000000000001; mul 30 302; add
301 303; mul 35 249; add 304 305; constant -1.3714285714285723; mul 42 307; constant 1.3714285714285714; mul 29 309;
constant 0.007256235827664418; mul 34 311; add 310 312; constant -4.799999999999999; mul 42 314; constant
1.3714285714285692; mul 29 316; constant -0.05714285714285729; mul 34 318; add 317 319; constant -7.199999999999996;
mul 42 321; constant 7.199999999999994; mul 29 323; constant 0.2190476190476189; mul 34 325; add 324 326; constant
-45.25714285714286; mul 29 328; constant -0.11428571428571327; mul 34 330; add 329 331; constant
-28.800000000000004; mul 42 333; input k 31; constant 0.8; mul 21 336; input k 46; input k 47; input k 48; input k
93; input k 94; mul 37 39; mul 39 118; mul 33 39; mul 39 116; mul 39 104; mul 39 103; mul 37 40; mul 40 118; mul 33
40; mul 40 116; mul 40 104; mul 40 103; store p 0 0; store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5
6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p 11 12; store p 12 13; store p 13 14;
store p 14 18; store p 15 22; store p 16 23; store p 17 17; store p 18 24; store p 19 37; store p 20 38; store p 21
39; store p 22 40; store p 23 43; store p 24 48; store p 25 50; store p 26 55; store p 27 60; store p 28 67; store p
29 69; store p 30 74; store p 31 76; store p 32 81; store p 33 86; store p 34 91; store p 35 96; store p 36 102;
store p 37 104; store p 38 106; store p 39 111; store p 40 118; store p 41 120; store p 42 125; store p 43 129;
store p 44 134; store p 45 139; store p 46 141; store p 47 146; store p 48 151; store p 49 153; store p 50 158;
store p 51 163; store p 52 165; store p 53 166; store p 54 167; store p 55 168; store p 56 169; store p 57 170;
store p 58 171; store p 59 172; store p 60 173; store p 61 174; store p 62 16; store p 63 207; store p 64 208; store
p 65 209; store p 66 194; store p 67 196; store p 68 232; store p 69 234; store p 70 236; store p 71 238; store p 72
240; store p 73 186; store p 74 242; store p 75 244; store p 76 246; store p 77 248; store p 78 200; store p 79 204;
store p 80 175; store p 81 181; store p 82 184; store p 83 188; store p 84 190; store p 85 192; store p 86 198;
store p 87 202; store p 88 206; store p 89 210; store p 90 211; store p 91 212; store p 92 179; store p 93 177;
store p 94 214; store p 95 178; store p 96 176; store p 97 215; store p 98 216; store p 99 217; store p 100 218;
store p 101 222; store p 102 223; store p 103 224; store p 104 225; store p 105 226; store p 106 229; store p 107
230; store p 108 251; store p 109 253; store p 110 255; store p 111 261; store p 112 257; store p 113 258; store p
114 263; store p 115 259; store p 116 256; store p 117 264; store p 118 265; store p 119 266; store p 120 267; store
p 121 270; store p 122 271; store p 123 272; store p 124 273; store p 125 274; store p 126 21; store p 127 275;
store p 128 276; store p 129 277; store p 130 279; store p 131 280; store p 132 282; store p 133 283; store p 134
285; store p 135 286; store p 136 288; store p 137 289; store p 138 290; store p 139 292; store p 140 293; store p
141 294; store p 142 295; store p 143 296; store p 144 297; store p 145 298; store p 146 299; store p 147 300; store
p 148 306; store p 149 308; store p 150 313; store p 151 315; store p 152 320; store p 153 322; store p 154 327;
store p 155 332; store p 156 334; store p 157 335; store p 158 337; store p 159 338; store p 160 339; store p 161
340; store p 162 341; store p 163 342; store p 164 343; store p 165 344; store p 166 345; store p 167 346; store p
168 347; store p 169 348; store p 170 349; store p 171 350; store p 172 351; store p 173 352; store p 174 353; store
p 175 354
    """,
)

RATES = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'start': 2, 'p': 176},
    {'rates': 14},
    """
input x 1; input p 0; constant 1.0; input x 2; input p 1; mul 3 4; mul 3 5; add 2 6; sqrt 7; div 2 8; input p 2; mul
3 10; mul 3 11; add 2 12; sqrt 13; mul 8 14; div 2 15; mul 9 16; input p 3; mul 17 18; mul 17 19; add 1 20; input p
4; input p 5; mul 13 16; mul 23 24; mul 17 25; mul 26 26; input p 6; input x 0; mul 28 29; input p 7; mul 3 31; add
30 32; input p 8; input x 4; mul 34 35; add 33 36; mul 3 14; mul 16 38; mul 23 39; mul 17 40; add 37 41; mul 42 42;
add 27 43; mul 22 44; add 21 45; input p 9; input p 10; mul 29 48; mul 3 34; add 49 50; input p 11; mul 35 52; add
51 53; mul 54 54; mul 22 55; add 47 56; mul 46 57; mul 42 54; mul 22 59; mul 60 60; sub 58 61; input p 12; mul 29
63; mul 3 28; add 64 65; mul 35 48; add 66 67; mul 68 68; add 2 69; mul 22 70; mul 62 71; input p 13; mul 42 68; add
26 74; mul 22 75; add 73 76; mul 57 77; mul 54 68; mul 22 79; mul 60 80; sub 78 81; mul 77 82; sub 72 83; mul 60 77;
mul 46 80; sub 85 86; mul 80 87; add 84 88; div 2 89; mul 62 90; input c 0; input c 2; input u 0; mul 93 94; add 92
95; input c 3; input u 1; mul 97 98; add 96 99; input p 14; mul 29 101; sub 3 102; input c 9; constant 0.5; input c
10; mul 105 106; mul 103 107; sub 104 108; input c 11; mul 94 110; add 109 111; input c 12; mul 98 113; add 112 114;
mul 103 115; add 100 116; input c 4; input c 5; mul 103 119; sub 118 120; input c 6; mul 94 122; add 121 123; input
c 7; mul 98 125; add 124 126; input c 8; input p 15; max 128 129; input x 3; mul 0 101; sub 131 132; mul 130 133;
sub 127 134; mul 101 135; sub 117 136; input p 16; input c 1; add 138 139; constant 0.0; max 140 141; mul 0 142; sub
137 143; input p 17; input p 18; input p 19; input p 20; mul 29 145; mul 148 149; input p 21; mul 3 151; add 150
152; input p 22; mul 35 154; add 153 155; mul 147 156; input p 23; mul 35 156; mul 158 159; add 157 160; input p 24;
mul 35 159; mul 162 163; add 161 164; input p 25; mul 156 156; mul 166 167; add 165 168; input p 26; mul 35 167; mul
170 171; add 169 172; input p 27; mul 156 167; mul 174 175; add 173 176; input p 28; mul 149 178; add 177 179; input
p 29; mul 35 149; mul 181 182; add 180 183; input p 30; mul 35 182; mul 185 186; add 184 187; input p 31; mul 149
156; mul 189 190; add 188 191; input p 32; mul 35 190; mul 193 194; add 192 195; input p 33; mul 156 190; mul 197
198; add 196 199; input p 34; mul 149 149; mul 156 202; mul 201 203; add 200 204; input p 35; mul 149 202; mul 206
207; add 205 208; input p 36; input p 37; mul 35 211; add 210 212; input p 38; mul 35 35; mul 214 215; add 213 216;
input p 39; mul 35 215; mul 218 219; add 217 220; input p 40; mul 156 222; add 221 223; input p 41; mul 159 225; add
224 226; input p 42; mul 163 228; add 227 229; input p 43; mul 167 231; add 230 232; input p 44; mul 171 234; add
233 235; input p 45; mul 175 237; add 236 238; mul 147 149; add 239 240; mul 158 182; add 241 242; mul 162 186; add
243 244; input p 46; mul 190 246; add 245 247; input p 47; mul 194 249; add 248 250; input p 48; mul 198 252; add
251 253; input p 49; mul 202 255; add 254 256; input p 50; mul 35 202; mul 258 259; add 257 260; mul 197 203; add
261 262; input p 51; mul 207 264; add 263 265; mul 148 266; add 209 267; mul 146 268; abs 149; constant 0.35; lt 270
271; constant 2.0; constant -2.0; max 274 35; min 273 275; input p 52; mul 276 277; mul 276 278; mul 276 279;
constant 0.6; constant -0.6; max 282 3; min 281 283; input p 53; mul 276 285; mul 276 286; mul 284 287; add 280 288;
input p 54; mul 276 290; mul 284 291; mul 284 292; add 289 293; input p 55; mul 284 295; mul 284 296; mul 284 297;
add 294 298; constant -0.35; max 300 149; min 271 301; mul 273 302; input p 56; mul 276 304; mul 276 305; mul 303
306; add 299 307; input p 57; mul 276 309; mul 284 310; mul 303 311; add 308 312; input p 58; mul 284 314; mul 284
315; mul 303 316; add 313 317; mul 302 302; input p 59; mul 276 320; mul 319 321; add 318 322; mul 302 321; mul 303
324; add 323 325; input p 60; mul 284 327; mul 319 328; add 326 329; mul 302 328; mul 303 331; add 330 332; mul 302
319; input p 61; mul 334 335; add 333 336; mul 302 335; mul 319 338; add 337 339; mul 302 338; mul 303 341; add 340
342; mul 146 343; where 272 344; add 269 345; input p 62; input p 63; mul 149 348; input p 64; mul 3 350; add 349
351; input p 65; mul 35 353; add 352 354; constant -0.09999999999999995; mul 156 356; input p 66; mul 163 358; add
357 359; input p 67; mul 175 361; add 360 362; constant 1.2; mul 149 364; add 363 365; input p 68; mul 186 367; add
366 368; input p 69; mul 194 370; add 369 371; input p 70; mul 198 373; add 372 374; input p 71; mul 203 376; add
375 377; input p 72; mul 207 379; add 378 380; constant -0.033333333333333326; mul 35 382; input p 73; mul 219 384;
add 383 385; constant 0.13333333333333333; mul 156 387; add 386 388; input p 74; mul 163 390; add 389 391; input p
75; mul 171 393; add 392 394; input p 76; mul 175 396; add 395 397; mul 149 356; add 398 399; mul 186 358; add 400
401; input p 77; mul 198 403; add 402 404; input p 78; mul 259 406; add 405 407; mul 203 373; add 408 409; input p
79; mul 207 411; add 410 412; mul 148 413; add 381 414; add 355 415; mul 347 416; input p 80; input p 81; constant
0.009523809523809514; mul 215 420; input p 82; mul 35 219; mul 422 423; add 421 424; mul 159 382; add 425 426; mul
35 163; mul 384 428; add 427 429; constant 0.06666666666666667; mul 167 431; add 430 432; input p 83; mul 35 171;
mul 434 435; add 433 436; input p 84; mul 35 175; mul 438 439; add 437 440; input p 85; mul 156 175; mul 442 443;
add 441 444; mul 190 356; add 445 446; mul 35 194; mul 358 448; add 447 449; mul 156 198; mul 361 451; add 450 452;
mul 202 281; add 453 454; input p 86; mul 35 259; mul 456 457; add 455 458; mul 35 203; mul 406 460; add 459 461;
input p 87; mul 156 203; mul 463 464; add 462 465; mul 156 207; mul 411 467; add 466 468; input p 88; mul 149 207;
mul 470 471; add 469 472; mul 149 355; mul 149 350; input p 89; mul 3 476; add 475 477; input p 90; mul 35 479; add
478 480; mul 3 481; add 474 482; mul 149 353; mul 3 479; add 484 485; input p 91; mul 35 487; add 486 488; mul 35
489; add 483 490; mul 105 491; add 473 492; mul 347 493; add 419 494; input p 92; mul 24 496; add 495 497; input p
93; mul 39 499; sub 498 500; input p 94; mul 24 499; input p 95; sub 503 504; mul 39 496; add 505 506; sub 507 29;
mul 508 508; mul 501 501; add 509 510; sqrt 511; mul 502 512; sqrt 513; div 2 514; mul 515 515; mul 502 516; mul 501
517; input p 96; mul 273 513; mul 273 516; mul 516 521; sub 520 522; mul 519 523; constant 0.3; constant -0.3;
constant 1.4; sub 513 527; max 526 528; min 525 529; input p 97; input p 98; mul 530 532; add 531 533; mul 530 534;
add 2 535; mul 524 536; input p 99; mul 94 538; input p 100; input p 101; mul 528 541; add 540 542; mul 528 543; add
2 544; mul 539 545; sub 537 546; mul 502 547; input p 102; input x 6; mul 549 550; input p 103; input x 8; mul 552
553; add 551 554; input p 104; input x 10; mul 556 557; add 555 558; constant -0.5; mul 515 560; mul 515 561; mul
515 562; mul 502 563; input p 105; input p 106; mul 528 566; add 565 567; mul 528 568; add 2 569; mul 564 570; mul
559 571; add 548 572; input p 107; mul 571 574; mul 571 575; sub 497 500; mul 508 577; add 503 506; mul 501 579; sub
578 580; mul 517 581; mul 17 582; mul 131 583; mul 508 517; mul 0 585; sub 584 586; mul 0 145; mul 417 588; mul 151
413; add 481 590; mul 347 591; mul 131 592; add 589 593; constant 0.01904761904761903; mul 35 595; input p 108; mul
219 597; add 596 598; mul 156 382; add 599 600; input p 109; mul 163 602; add 601 603; mul 171 390; add 604 605; mul
175 438; add 606 607; input p 110; mul 194 609; add 608 610; mul 259 367; add 611 612; mul 203 406; add 613 614; mul
154 413; add 615 616; add 489 617; mul 347 618; input x 5; mul 619 620; add 594 621; mul 518 622; add 587 623; mul
576 624; add 573 625; mul 518 626; input p 111; add 494 628; input p 112; mul 24 630; add 629 631; input p 113; mul
39 633; add 632 634; input p 114; mul 39 630; mul 24 633; input p 115; sub 638 639; sub 637 640; sub 641 29; mul 642
642; mul 635 635; add 643 644; sqrt 645; mul 636 646; sqrt 647; div 2 648; mul 649 649; mul 636 650; mul 635 651;
input p 116; mul 273 647; mul 273 650; mul 650 655; sub 654 656; mul 653 657; sub 647 527; max 526 659; min 525 660;
input p 117; input p 118; mul 661 663; add 662 664; mul 661 665; add 2 666; mul 658 667; input p 119; mul 98 669;
input p 120; input p 121; mul 659 672; add 671 673; mul 659 674; add 2 675; mul 670 676; sub 668 677; mul 636 678;
input p 122; input x 7; mul 680 681; input p 123; input x 9; mul 683 684; add 682 685; input p 124; input x 11; mul
687 688; add 686 689; mul 560 649; mul 649 691; mul 649 692; mul 636 693; mul 566 659; add 565 695; mul 659 696; add
2 697; mul 694 698; mul 690 699; add 679 700; input p 125; mul 699 702; mul 699 703; add 631 634; mul 642 705; sub
638 637; mul 635 707; add 706 708; mul 651 709; mul 17 710; mul 131 711; mul 642 651; mul 0 713; sub 712 714; mul
622 652; add 715 716; mul 704 717; add 701 718; mul 652 719; add 627 720; sub 418 721; mul 417 722; sub 346 723;
input p 126; constant 12.0; mul 588 726; constant -6.0; mul 148 588; mul 131 151; add 729 730; mul 154 620; add 731
732; mul 728 733; add 727 734; mul 725 735; mul 588 728; constant 4.0; mul 733 738; add 737 739; mul 725 740; mul
148 741; add 736 742; add 724 743; mul 145 744; mul 585 626; mul 713 719; add 746 747; sub 745 748; sub 144 749;
input p 127; input p 128; constant -1.0; input z 0; input start 0; sub 29 755; input p 129; input start 1; sub 3
758; mul 757 759; add 756 760; input p 130; mul 761 762; add 754 763; max 753 764; min 2 765; mul 752 766; input p
131; input z 1; input p 132; mul 761 770; add 769 771; max 753 772; min 2 773; mul 768 774; add 767 775; input p
133; input z 2; input p 134; mul 761 779; add 778 780; max 753 781; min 2 782; mul 777 783; add 776 784; input p
135; input z 3; input p 136; mul 761 788; add 787 789; max 753 790; min 2 791; mul 786 792; add 785 793; sub 751
794; input p 137; abs 0; mul 796 797; mul 0 798; input p 138; mul 0 800; mul 0 0; input p 139; add 802 803; sqrt
804; div 2 805; mul 801 806; add 799 807; sub 795 808; add 750 809; input p 140; input x 12; sub 29 812; mul 811
813; input p 141; input x 13; sub 29 816; mul 815 817; add 814 818; sub 810 819; mul 0 63; mul 28 131; add 821 822;
mul 48 620; add 823 824; mul 0 825; mul 0 28; mul 31 131; add 827 828; mul 34 620; add 829 830; mul 131 831; add 826
832; mul 0 48; mul 34 131; add 834 835; mul 52 620; add 836 837; mul 620 838; add 833 839; mul 17 24; mul 17 841;
mul 3 17; input p 142; div 2 7; mul 844 845; mul 3 3; sub 7 847; div 2 848; mul 10 849; add 846 850; mul 843 851;
mul 39 852; sub 842 853; mul 23 854; mul 131 131; mul 855 856; add 840 857; mul 68 858; mul 24 852; mul 17 39; mul
17 861; add 860 862; mul 23 863; mul 856 864; sub 859 865; mul 22 866; sub 820 867; mul 91 868; mul 82 90; mul 151
266; mul 146 871; abs 3; lt 873 281; input p 143; mul 276 875; mul 276 876; mul 276 877; mul 273 284; input p 144;
mul 276 880; mul 276 881; mul 879 882; add 878 883; mul 284 284; input p 145; mul 276 886; mul 885 887; add 884 888;
mul 284 887; mul 879 890; add 889 891; mul 284 885; input p 146; mul 893 894; add 892 895; mul 284 894; mul 885 897;
add 896 898; mul 284 897; mul 879 900; add 899 901; mul 287 302; add 902 903; mul 284 302; mul 291 905; add 904 906;
mul 292 302; add 907 908; mul 284 905; mul 295 910; add 909 911; mul 296 905; add 912 913; mul 297 302; add 914 915;
mul 310 319; add 916 917; mul 284 319; mul 314 919; add 918 920; mul 315 319; add 921 922; mul 327 334; add 923 924;
mul 146 925; where 874 926; add 872 927; mul 592 722; sub 928 929; mul 151 741; add 930 931; mul 583 626; mul 711
719; add 933 934; add 932 935; sub 135 936; input p 147; mul 39 938; mul 17 939; add 937 940; mul 757 794; sub 941
942; mul 42 858; mul 26 865; sub 944 945; mul 22 946; mul 19 852; mul 856 948; sub 947 949; sub 943 950; mul 870
951; sub 869 952; mul 87 90; input p 148; mul 35 955; input p 149; mul 215 957; add 956 958; input p 150; mul 219
960; add 959 961; mul 156 211; add 962 963; input p 151; mul 159 965; add 964 966; input p 152; mul 163 968; add 967
969; input p 153; mul 167 971; add 970 972; mul 171 228; add 973 974; input p 154; mul 175 976; add 975 977; mul 158
190; add 978 979; input p 155; mul 194 981; add 980 982; mul 170 198; add 983 984; input p 156; mul 202 986; add 985
987; mul 185 259; add 988 989; mul 203 258; add 990 991; mul 154 266; add 992 993; mul 146 994; abs 35; lt 996 273;
mul 276 276; mul 276 998; input p 157; mul 999 1000; mul 276 1000; mul 998 1002; add 1001 1003; mul 273 276; mul 276
1002; mul 1005 1006; add 1004 1007; mul 276 284; mul 276 1009; mul 875 1010; add 1008 1011; mul 876 1009; add 1012
1013; mul 284 877; add 1014 1015; mul 276 885; mul 880 1017; add 1016 1018; mul 881 885; add 1019 1020; mul 886 893;
add 1021 1022; mul 276 302; mul 276 1024; mul 277 1025; add 1023 1026; mul 278 1024; add 1027 1028; mul 279 302; add
1029 1030; mul 276 905; mul 285 1032; add 1031 1033; mul 286 905; add 1034 1035; mul 290 910; add 1036 1037; mul 276
319; mul 304 1039; add 1038 1040; mul 305 319; add 1041 1042; mul 309 919; add 1043 1044; mul 320 334; add 1045
1046; mul 146 1047; where 997 1048; add 995 1049; mul 619 722; sub 1050 1051; input p 158; mul 620 1053; mul 154
741; add 1054 1055; add 1052 1056; mul 54 858; mul 22 1058; add 1057 1059; mul 954 1060; sub 953 1061; mul 57 71;
mul 80 80; sub 1063 1064; mul 90 1065; mul 951 1066; mul 868 870; sub 1067 1068; mul 60 71; mul 77 80; sub 1070
1071; mul 90 1072; mul 1060 1073; add 1069 1074; mul 868 954; mul 951 1073; sub 1076 1077; mul 46 71; mul 77 77; sub
1079 1080; mul 90 1081; mul 1060 1082; sub 1078 1083; mul 571 624; input p 159; mul 550 1086; sub 1085 1087; mul 699
717; mul 681 1086; sub 1089 1090; input p 160; mul 553 1092; sub 1085 1093; mul 684 1092; sub 1089 1095; input p
161; mul 557 1097; sub 1085 1098; mul 688 1097; sub 1089 1100; input p 162; mul 813 1102; input p 163; mul 817 1104;
store rates 0 0; store rates 1 1062; store rates 2 131; store rates 3 1075; store rates 4 620; store rates 5 1084;
store rates 6 1088; store rates 7 1091; store rates 8 1094; store rates 9 1096; store rates 10 1099; store rates 11
1101; store rates 12 1103; store rates 13 1105
    """,
)

SHAPE = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'p': 176},
    {'forces': 3, 'by_shape': 6},
    """
input p 127; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
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
167 168; constant 2.0; constant -2.0; max 171 50; min 170 172; input p 52; mul 173 174; mul 173 175; mul 173 176;
constant 0.6; constant -0.6; max 179 10; min 178 180; input p 53; mul 173 182; mul 173 183; mul 181 184; add 177
185; input p 54; mul 173 187; mul 181 188; mul 181 189; add 186 190; input p 55; mul 181 192; mul 181 193; mul 181
194; add 191 195; constant -0.35; max 197 45; min 168 198; mul 170 199; input p 56; mul 173 201; mul 173 202; mul
200 203; add 196 204; input p 57; mul 173 206; mul 181 207; mul 200 208; add 205 209; input p 58; mul 181 211; mul
181 212; mul 200 213; add 210 214; mul 199 199; input p 59; mul 173 217; mul 216 218; add 215 219; mul 199 218; mul
200 221; add 220 222; input p 60; mul 181 224; mul 216 225; add 223 226; mul 199 225; mul 200 228; add 227 229; mul
199 216; input p 61; mul 231 232; add 230 233; mul 199 232; mul 216 235; add 234 236; mul 199 235; mul 200 238; add
237 239; mul 42 240; where 169 241; add 166 242; input p 62; input p 63; mul 45 245; input p 64; mul 10 247; add 246
248; input p 65; mul 50 250; add 249 251; constant -0.09999999999999995; mul 53 253; input p 66; mul 60 255; add 254
256; input p 67; mul 72 258; add 257 259; constant 1.2; mul 45 261; add 260 262; input p 68; mul 83 264; add 263
265; input p 69; mul 91 267; add 266 268; input p 70; mul 95 270; add 269 271; input p 71; mul 100 273; add 272 274;
input p 72; mul 104 276; add 275 277; constant -0.033333333333333326; mul 50 279; input p 73; mul 116 281; add 280
282; constant 0.13333333333333333; mul 53 284; add 283 285; input p 74; mul 60 287; add 286 288; input p 75; mul 68
290; add 289 291; input p 76; mul 72 293; add 292 294; mul 45 253; add 295 296; mul 83 255; add 297 298; input p 77;
mul 95 300; add 299 301; input p 78; mul 156 303; add 302 304; mul 100 270; add 305 306; input p 79; mul 104 308;
add 307 309; mul 44 310; add 278 311; add 252 312; mul 244 313; input p 80; input p 94; input p 96; constant 1.0;
input p 2; mul 10 319; mul 10 320; add 318 321; input p 1; mul 10 323; mul 10 324; add 318 325; sqrt 326; sqrt 322;
mul 327 328; div 318 329; mul 322 330; input p 93; mul 331 332; input p 95; sub 333 334; mul 10 328; mul 330 336;
input p 92; mul 337 338; add 335 339; sub 340 11; mul 341 341; input p 81; constant 0.009523809523809514; mul 112
344; input p 82; mul 50 116; mul 346 347; add 345 348; mul 56 279; add 349 350; mul 50 60; mul 281 352; add 351 353;
constant 0.06666666666666667; mul 64 355; add 354 356; input p 83; mul 50 68; mul 358 359; add 357 360; input p 84;
mul 50 72; mul 362 363; add 361 364; input p 85; mul 53 72; mul 366 367; add 365 368; mul 87 253; add 369 370; mul
50 91; mul 255 372; add 371 373; mul 53 95; mul 258 375; add 374 376; mul 99 178; add 377 378; input p 86; mul 50
156; mul 380 381; add 379 382; mul 50 100; mul 303 384; add 383 385; input p 87; mul 53 100; mul 387 388; add 386
389; mul 53 104; mul 308 391; add 390 392; input p 88; mul 45 104; mul 394 395; add 393 396; mul 45 252; mul 45 247;
input p 89; mul 10 400; add 399 401; input p 90; mul 50 403; add 402 404; mul 10 405; add 398 406; mul 45 250; mul
10 403; add 408 409; input p 91; mul 50 411; add 410 412; mul 50 413; add 407 414; mul 16 415; add 397 416; mul 244
417; add 343 418; mul 331 338; add 419 420; mul 332 337; sub 421 422; mul 423 423; add 342 424; sqrt 425; mul 316
426; mul 170 427; sqrt 427; div 318 429; mul 430 430; mul 170 431; mul 431 432; sub 428 433; mul 317 434; constant
0.3; constant -0.3; constant 1.4; sub 427 438; max 437 439; min 436 440; input p 97; input p 98; mul 441 443; add
442 444; mul 441 445; add 318 446; mul 435 447; input p 99; mul 3 449; input p 100; input p 101; mul 439 452; add
451 453; mul 439 454; add 318 455; mul 450 456; sub 448 457; mul 316 458; mul 316 431; mul 423 460; mul 459 461;
input p 114; input p 116; input p 112; mul 337 465; input p 113; mul 331 467; input p 115; sub 468 469; sub 466 470;
sub 471 11; mul 472 472; input p 111; add 418 474; mul 331 465; add 475 476; mul 337 467; add 477 478; mul 479 479;
add 473 480; sqrt 481; mul 463 482; mul 170 483; sqrt 483; div 318 485; mul 486 486; mul 170 487; mul 487 488; sub
484 489; mul 464 490; sub 483 438; max 437 492; min 436 493; input p 117; input p 118; mul 494 496; add 495 497; mul
494 498; add 318 499; mul 491 500; input p 119; mul 7 502; input p 120; input p 121; mul 492 505; add 504 506; mul
492 507; add 318 508; mul 503 509; sub 501 510; mul 463 511; mul 463 487; mul 479 513; mul 512 514; add 462 515; sub
315 516; mul 314 517; sub 243 518; mul 41 519; mul 341 460; mul 459 521; mul 472 513; mul 512 523; add 522 524; sub
520 525; sub 40 526; add 0 527; div 318 327; mul 330 529; input p 147; mul 337 531; mul 530 532; mul 47 163; mul 42
534; abs 10; lt 536 178; input p 143; mul 173 538; mul 173 539; mul 173 540; mul 170 181; input p 144; mul 173 543;
mul 173 544; mul 542 545; add 541 546; mul 181 181; input p 145; mul 173 549; mul 548 550; add 547 551; mul 181 550;
mul 542 553; add 552 554; mul 181 548; input p 146; mul 556 557; add 555 558; mul 181 557; mul 548 560; add 559 561;
mul 181 560; mul 542 563; add 562 564; mul 184 199; add 565 566; mul 181 199; mul 188 568; add 567 569; mul 189 199;
add 570 571; mul 181 568; mul 192 573; add 572 574; mul 193 568; add 575 576; mul 194 199; add 577 578; mul 207 216;
add 579 580; mul 181 216; mul 211 582; add 581 583; mul 212 216; add 584 585; mul 224 231; add 586 587; mul 42 588;
where 537 589; add 535 590; mul 47 310; add 405 592; mul 244 593; mul 517 594; sub 591 595; sub 420 422; mul 341
597; add 333 339; mul 423 599; sub 598 600; mul 460 601; mul 530 602; mul 459 603; add 476 478; mul 472 605; sub 468
466; mul 479 607; add 606 608; mul 513 609; mul 530 610; mul 512 611; add 604 612; add 596 613; sub 38 614; add 533
615; input p 148; mul 50 617; input p 149; mul 112 619; add 618 620; input p 150; mul 116 622; add 621 623; mul 53
108; add 624 625; input p 151; mul 56 627; add 626 628; input p 152; mul 60 630; add 629 631; input p 153; mul 64
633; add 632 634; mul 68 125; add 635 636; input p 154; mul 72 638; add 637 639; mul 55 87; add 640 641; input p
155; mul 91 643; add 642 644; mul 67 95; add 645 646; input p 156; mul 99 648; add 647 649; mul 82 156; add 650 651;
mul 100 155; add 652 653; mul 51 163; add 654 655; mul 42 656; abs 50; lt 658 170; mul 173 173; mul 173 660; input p
157; mul 661 662; mul 173 662; mul 660 664; add 663 665; mul 170 173; mul 173 664; mul 667 668; add 666 669; mul 173
181; mul 173 671; mul 538 672; add 670 673; mul 539 671; add 674 675; mul 181 540; add 676 677; mul 173 548; mul 543
679; add 678 680; mul 544 548; add 681 682; mul 549 556; add 683 684; mul 173 199; mul 173 686; mul 174 687; add 685
688; mul 175 686; add 689 690; mul 176 199; add 691 692; mul 173 568; mul 182 694; add 693 695; mul 183 568; add 696
697; mul 187 573; add 698 699; mul 173 216; mul 201 701; add 700 702; mul 202 216; add 703 704; mul 206 582; add 705
706; mul 217 231; add 707 708; mul 42 709; where 659 710; add 657 711; constant 0.01904761904761903; mul 50 713;
input p 108; mul 116 715; add 714 716; mul 53 279; add 717 718; input p 109; mul 60 720; add 719 721; mul 68 287;
add 722 723; mul 72 362; add 724 725; input p 110; mul 91 727; add 726 728; mul 156 264; add 729 730; mul 100 303;
add 731 732; mul 51 310; add 733 734; add 413 735; mul 244 736; mul 517 737; sub 712 738; neg 739; sub 26 19; mul 12
30; add 741 742; input p 164; mul 47 50; mul 55 745; add 744 746; mul 50 745; mul 59 748; add 747 749; mul 53 170;
mul 47 751; mul 63 752; add 750 753; mul 50 752; mul 67 755; add 754 756; mul 53 752; mul 47 64; add 758 759; mul 71
760; add 757 761; mul 45 47; mul 86 763; add 762 764; mul 50 763; mul 90 766; add 765 767; mul 53 763; mul 47 87;
add 769 770; mul 94 771; add 768 772; mul 47 99; mul 98 774; add 773 775; input p 165; mul 122 745; add 777 778; mul
125 748; add 779 780; mul 128 752; add 781 782; mul 131 755; add 783 784; mul 134 760; add 785 786; mul 143 763; add
787 788; mul 146 766; add 789 790; mul 149 771; add 791 792; mul 94 774; add 793 794; mul 44 795; add 776 796; mul
42 797; le 180 178; le 178 180; add 799 800; div 318 801; mul 799 802; le 179 10; le 10 179; add 804 805; div 318
806; mul 804 807; mul 803 808; mul 184 809; mul 189 809; mul 188 809; mul 181 812; add 811 813; add 810 814; mul 194
809; mul 193 809; mul 192 809; mul 181 818; add 817 819; mul 181 820; add 816 821; add 815 822; mul 207 809; mul 200
824; add 823 825; mul 212 809; mul 211 809; mul 181 828; add 827 829; mul 200 830; add 826 831; mul 224 809; mul 216
833; add 832 834; mul 199 833; mul 200 836; add 835 837; mul 42 838; where 169 839; add 798 840; input p 166; mul
255 748; add 842 843; mul 258 760; add 844 845; mul 267 766; add 846 847; mul 270 771; add 848 849; mul 273 774; add
850 851; input p 167; mul 287 748; add 853 854; mul 290 755; add 855 856; mul 293 760; add 857 858; mul 300 771; add
859 860; mul 270 774; add 861 862; mul 44 863; add 852 864; add 247 865; mul 244 866; mul 517 867; mul 170 341; mul
170 320; mul 330 870; mul 330 331; mul 324 529; mul 328 873; div 318 328; mul 320 875; mul 327 876; add 874 877; mul
872 878; sub 871 879; mul 332 880; mul 10 876; add 328 882; mul 330 883; mul 330 337; mul 878 885; sub 884 886; mul
338 887; add 881 888; mul 869 889; mul 170 423; mul 279 745; mul 50 748; mul 281 893; add 892 894; mul 355 752; add
895 896; mul 50 755; mul 358 898; add 897 899; mul 50 760; mul 362 901; add 900 902; mul 53 760; mul 47 72; add 904
905; mul 366 906; add 903 907; mul 253 763; add 908 909; mul 50 766; mul 255 911; add 910 912; mul 53 771; mul 47
95; add 914 915; mul 258 916; add 913 917; mul 50 774; mul 303 919; add 918 920; mul 53 774; mul 47 100; add 922
923; mul 387 924; add 921 925; mul 47 104; mul 308 927; add 926 928; add 401 405; add 399 930; add 404 931; mul 16
932; add 929 933; mul 244 934; mul 338 880; add 935 936; mul 332 887; sub 937 938; mul 891 939; add 890 940; mul 170
426; div 318 942; mul 941 943; mul 316 944; mul 170 945; mul 170 430; mul 170 429; div 318 948; mul 945 949; mul 431
950; mul 947 951; neg 952; mul 170 953; mul 431 954; mul 432 952; sub 955 956; sub 946 957; mul 317 958; mul 447
959; le 440 436; le 436 440; add 961 962; div 318 963; mul 961 964; le 437 439; le 439 437; add 966 967; div 318
968; mul 966 969; mul 945 970; mul 965 971; mul 443 972; mul 441 973; mul 445 972; add 974 975; mul 435 976; add 960
977; mul 452 945; mul 439 979; mul 454 945; add 980 981; mul 450 982; sub 978 983; mul 316 984; mul 461 985; mul 460
939; mul 316 952; mul 423 988; sub 987 989; mul 459 990; add 986 991; mul 170 472; mul 465 887; mul 467 880; sub 994
995; mul 993 996; mul 170 479; mul 465 880; add 935 999; mul 467 887; add 1000 1001; mul 998 1002; add 997 1003; mul
170 482; div 318 1005; mul 1004 1006; mul 463 1007; mul 170 1008; mul 170 486; mul 170 485; div 318 1011; mul 1008
1012; mul 487 1013; mul 1010 1014; neg 1015; mul 170 1016; mul 487 1017; mul 488 1015; sub 1018 1019; sub 1009 1020;
mul 464 1021; mul 500 1022; le 493 436; le 436 493; add 1024 1025; div 318 1026; mul 1024 1027; le 437 492; le 492
437; add 1029 1030; div 318 1031; mul 1029 1032; mul 1008 1033; mul 1028 1034; mul 496 1035; mul 494 1036; mul 498
1035; add 1037 1038; mul 491 1039; add 1023 1040; mul 505 1008; mul 492 1042; mul 507 1008; add 1043 1044; mul 503
1045; sub 1041 1046; mul 463 1047; mul 514 1048; mul 513 1002; mul 463 1015; mul 479 1051; sub 1050 1052; mul 512
1053; add 1049 1054; add 992 1055; mul 314 1056; sub 868 1057; sub 841 1058; mul 41 1059; mul 521 985; mul 460 889;
mul 341 988; sub 1062 1063; mul 459 1064; add 1061 1065; mul 523 1048; mul 513 996; mul 472 1051; sub 1068 1069; mul
512 1070; add 1067 1071; add 1066 1072; sub 1060 1073; sub 743 1074; mul 531 887; mul 530 1076; mul 529 529; mul 873
1078; mul 330 1079; mul 330 530; mul 878 1081; add 1080 1082; mul 532 1083; sub 1077 1084; mul 47 795; mul 42 1086;
mul 170 809; mul 545 1088; mul 542 809; mul 550 1090; add 1089 1091; mul 553 1088; mul 550 809; mul 542 1094; add
1093 1095; add 1092 1096; mul 181 1090; mul 548 809; add 1098 1099; mul 557 1100; add 1097 1101; mul 560 1090; mul
557 809; mul 548 1104; add 1103 1105; add 1102 1106; mul 563 1088; mul 560 809; mul 181 1104; add 1109 1110; mul 542
1111; add 1108 1112; add 1107 1113; mul 199 809; mul 188 1115; add 1114 1116; mul 199 812; add 1117 1118; mul 181
1115; mul 568 809; add 1120 1121; mul 192 1122; add 1119 1123; mul 193 1115; mul 568 818; add 1125 1126; add 1124
1127; mul 199 820; add 1128 1129; mul 216 809; mul 211 1131; add 1130 1132; mul 216 828; add 1133 1134; mul 42 1135;
where 537 1136; add 1087 1137; mul 47 863; add 400 1139; mul 244 1140; mul 517 1141; mul 594 1056; sub 1142 1143;
sub 1138 1144; mul 603 985; mul 597 889; sub 936 938; mul 341 1148; add 1147 1149; mul 599 939; mul 423 889; add
1151 1152; sub 1150 1153; mul 460 1154; mul 601 988; sub 1155 1156; mul 530 1157; mul 602 1083; sub 1158 1159; mul
459 1160; add 1146 1161; mul 611 1048; mul 605 996; add 999 1001; mul 472 1165; add 1164 1166; mul 607 1002; sub 995
994; mul 479 1169; add 1168 1170; add 1167 1171; mul 513 1172; mul 609 1051; sub 1173 1174; mul 530 1175; mul 610
1083; sub 1176 1177; mul 512 1178; add 1163 1179; add 1162 1180; add 1145 1181; add 30 1182; sub 1085 1183; input p
168; mul 627 745; add 1185 1186; mul 630 748; add 1187 1188; mul 633 752; add 1189 1190; mul 125 755; add 1191 1192;
mul 638 760; add 1193 1194; mul 55 763; add 1195 1196; mul 643 766; add 1197 1198; mul 67 771; add 1199 1200; mul
155 774; add 1201 1202; mul 51 795; add 1203 1204; mul 42 1205; mul 173 809; mul 173 1207; mul 538 1208; mul 539
1207; add 1209 1210; mul 540 809; add 1211 1212; mul 173 1090; mul 543 1214; add 1213 1215; mul 544 1090; add 1216
1217; mul 549 1100; add 1218 1219; mul 173 1115; mul 182 1221; add 1220 1222; mul 183 1115; add 1223 1224; mul 187
1122; add 1225 1226; mul 206 1131; add 1227 1228; mul 42 1229; where 659 1230; add 1206 1231; input p 169; mul 720
748; add 1233 1234; mul 287 755; add 1235 1236; mul 362 760; add 1237 1238; mul 727 766; add 1239 1240; mul 303 774;
add 1241 1242; mul 51 863; add 1243 1244; add 403 1245; mul 244 1246; mul 517 1247; mul 737 1056; sub 1248 1249; sub
1232 1250; neg 1251; input p 170; add 52 53; mul 55 1254; add 1253 1255; mul 50 1254; add 56 1257; mul 59 1258; add
1256 1259; mul 51 751; mul 63 1261; add 1260 1262; mul 50 1261; add 64 1264; mul 67 1265; add 1263 1266; mul 53
1261; mul 51 64; add 1268 1269; mul 71 1270; add 1267 1271; mul 45 78; add 1272 1273; mul 79 170; mul 82 1275; add
1274 1276; mul 45 51; mul 86 1278; add 1277 1279; mul 50 1278; add 87 1281; mul 90 1282; add 1280 1283; mul 53 1278;
mul 51 87; add 1285 1286; mul 94 1287; add 1284 1288; mul 51 99; mul 98 1290; add 1289 1291; mul 50 170; mul 111
1293; add 108 1294; mul 50 1293; add 112 1296; mul 115 1297; add 1295 1298; input p 171; add 1299 1300; mul 122
1254; add 1301 1302; mul 125 1258; add 1303 1304; mul 128 1261; add 1305 1306; mul 131 1265; add 1307 1308; mul 134
1270; add 1309 1310; mul 45 55; add 1311 1312; mul 59 1275; add 1313 1314; mul 143 1278; add 1315 1316; mul 146
1282; add 1317 1318; mul 149 1287; add 1319 1320; mul 99 155; add 1321 1322; mul 94 1290; add 1323 1324; mul 44
1325; add 1292 1326; mul 42 1327; le 172 170; le 170 172; add 1329 1330; div 318 1331; mul 1329 1332; le 171 50; le
50 171; add 1334 1335; div 318 1336; mul 1334 1337; mul 1333 1338; mul 176 1339; mul 175 1339; mul 174 1339; mul 173
1342; add 1341 1343; mul 173 1344; add 1340 1345; mul 183 1339; mul 182 1339; mul 173 1348; add 1347 1349; mul 181
1350; add 1346 1351; mul 187 1339; mul 181 1353; mul 181 1354; add 1352 1355; mul 202 1339; mul 201 1339; mul 173
1358; add 1357 1359; mul 200 1360; add 1356 1361; mul 206 1339; mul 181 1363; mul 200 1364; add 1362 1365; mul 217
1339; mul 216 1367; add 1366 1368; mul 199 1367; mul 200 1370; add 1369 1371; mul 42 1372; where 169 1373; add 1328
1374; input p 172; mul 255 1258; add 1376 1377; mul 258 1270; add 1378 1379; mul 264 1275; add 1380 1381; mul 267
1282; add 1382 1383; mul 270 1287; add 1384 1385; mul 273 1290; add 1386 1387; mul 281 1297; add 279 1389; input p
173; add 1390 1391; mul 287 1258; add 1392 1393; mul 290 1265; add 1394 1395; mul 293 1270; add 1396 1397; mul 255
1275; add 1398 1399; mul 300 1287; add 1400 1401; mul 99 303; add 1402 1403; mul 270 1290; add 1404 1405; mul 44
1406; add 1388 1407; add 250 1408; mul 244 1409; mul 517 1410; mul 50 1297; add 116 1412; mul 346 1413; add 714
1414; mul 279 1254; add 1415 1416; mul 50 1258; add 60 1418; mul 281 1419; add 1417 1420; mul 355 1261; add 1421
1422; mul 50 1265; add 68 1424; mul 358 1425; add 1423 1426; mul 50 1270; add 72 1428; mul 362 1429; add 1427 1430;
mul 53 1270; mul 51 72; add 1432 1433; mul 366 1434; add 1431 1435; mul 253 1278; add 1436 1437; mul 50 1282; add 91
1439; mul 255 1440; add 1438 1441; mul 53 1287; mul 51 95; add 1443 1444; mul 258 1445; add 1442 1446; mul 156 170;
mul 380 1448; add 1447 1449; mul 50 1290; add 100 1451; mul 303 1452; add 1450 1453; mul 53 1290; mul 51 100; add
1455 1456; mul 387 1457; add 1454 1458; mul 51 104; mul 308 1460; add 1459 1461; add 412 413; add 410 1463; mul 16
1464; add 1462 1465; mul 244 1466; mul 891 1467; mul 943 1468; mul 316 1469; mul 170 1470; mul 949 1470; mul 431
1472; mul 947 1473; neg 1474; mul 170 1475; mul 431 1476; mul 432 1474; sub 1477 1478; sub 1471 1479; mul 317 1480;
mul 447 1481; mul 970 1470; mul 965 1483; mul 443 1484; mul 441 1485; mul 445 1484; add 1486 1487; mul 435 1488; add
1482 1489; mul 452 1470; mul 439 1491; mul 454 1470; add 1492 1493; mul 450 1494; sub 1490 1495; mul 316 1496; mul
461 1497; mul 460 1467; mul 316 1474; mul 423 1500; sub 1499 1501; mul 459 1502; add 1498 1503; mul 998 1467; mul
1006 1505; mul 463 1506; mul 170 1507; mul 1012 1507; mul 487 1509; mul 1010 1510; neg 1511; mul 170 1512; mul 487
1513; mul 488 1511; sub 1514 1515; sub 1508 1516; mul 464 1517; mul 500 1518; mul 1033 1507; mul 1028 1520; mul 496
1521; mul 494 1522; mul 498 1521; add 1523 1524; mul 491 1525; add 1519 1526; mul 505 1507; mul 492 1528; mul 507
1507; add 1529 1530; mul 503 1531; sub 1527 1532; mul 463 1533; mul 514 1534; mul 513 1467; mul 463 1511; mul 479
1537; sub 1536 1538; mul 512 1539; add 1535 1540; add 1504 1541; mul 314 1542; sub 1411 1543; sub 1375 1544; mul 41
1545; mul 521 1497; mul 341 1500; mul 459 1548; sub 1547 1549; mul 523 1534; mul 472 1537; mul 512 1552; sub 1551
1553; add 1550 1554; sub 1546 1555; neg 1556; mul 47 1325; mul 42 1558; mul 540 1339; mul 539 1339; mul 538 1339;
mul 173 1562; add 1561 1563; mul 173 1564; add 1560 1565; mul 544 1339; mul 543 1339; mul 173 1568; add 1567 1569;
mul 542 1570; add 1566 1571; mul 549 1339; mul 548 1573; add 1572 1574; mul 181 1573; mul 542 1576; add 1575 1577;
mul 199 1350; add 1578 1579; mul 568 1353; add 1580 1581; mul 199 1354; add 1582 1583; mul 216 1363; add 1584 1585;
mul 42 1586; where 537 1587; add 1559 1588; mul 47 1406; add 403 1590; mul 244 1591; mul 517 1592; mul 594 1542; sub
1593 1594; sub 1589 1595; mul 603 1497; mul 599 1467; mul 460 1598; mul 601 1500; add 1599 1600; mul 530 1601; mul
459 1602; sub 1597 1603; mul 611 1534; mul 607 1467; mul 513 1606; mul 609 1537; sub 1607 1608; mul 530 1609; mul
512 1610; add 1605 1611; add 1604 1612; add 1596 1613; neg 1614; mul 619 1293; add 617 1616; mul 622 1297; add 1617
1618; input p 174; add 1619 1620; mul 627 1254; add 1621 1622; mul 630 1258; add 1623 1624; mul 633 1261; add 1625
1626; mul 125 1265; add 1627 1628; mul 638 1270; add 1629 1630; mul 55 1278; add 1631 1632; mul 643 1282; add 1633
1634; mul 67 1287; add 1635 1636; mul 82 99; add 1637 1638; mul 155 1290; add 1639 1640; mul 51 1325; add 1641 1642;
mul 42 1643; mul 667 1339; mul 173 1645; mul 660 1339; add 1646 1647; mul 662 1648; mul 664 1645; mul 662 1339; mul
660 1651; add 1650 1652; add 1649 1653; mul 170 1339; mul 668 1655; mul 664 1339; mul 173 1651; add 1657 1658; mul
667 1659; add 1656 1660; add 1654 1661; mul 181 1339; mul 173 1663; mul 671 1339; add 1664 1665; mul 538 1666; add
1662 1667; mul 539 1663; mul 671 1562; add 1669 1670; add 1668 1671; mul 181 1564; add 1672 1673; mul 548 1339; mul
543 1675; add 1674 1676; mul 548 1568; add 1677 1678; mul 199 1339; mul 173 1680; mul 686 1339; add 1681 1682; mul
174 1683; add 1679 1684; mul 175 1680; mul 686 1342; add 1686 1687; add 1685 1688; mul 199 1344; add 1689 1690; mul
568 1339; mul 182 1692; add 1691 1693; mul 568 1348; add 1694 1695; mul 216 1339; mul 201 1697; add 1696 1698; mul
216 1358; add 1699 1700; mul 42 1701; where 659 1702; add 1644 1703; mul 715 1297; add 713 1705; input p 175; add
1706 1707; mul 720 1258; add 1708 1709; mul 287 1265; add 1710 1711; mul 362 1270; add 1712 1713; mul 727 1282; add
1714 1715; mul 99 264; add 1716 1717; mul 303 1290; add 1718 1719; mul 51 1406; add 1720 1721; add 411 1722; mul 244
1723; mul 517 1724; mul 737 1542; sub 1725 1726; sub 1704 1727; neg 1728; store forces 0 528; store forces 1 616;
store forces 2 740; store by_shape 0 1075; store by_shape 2 1184; store by_shape 4 1252; store by_shape 1 1557;
store by_shape 3 1615; store by_shape 5 1729
    """,
)

INERTIA = Graph(
    {'x': 14, 'p': 176},
    {'mass': 6},
    """
input p 4; constant 1.0; input x 0; input p 12; mul 2 3; input x 2; input p 6; mul 5 6; add 4 7; input x 4; input p
10; mul 9 10; add 8 11; mul 12 12; add 1 13; mul 0 14; input p 13; input p 1; mul 5 17; mul 5 18; add 1 19; sqrt 20;
div 1 21; input p 2; mul 5 23; mul 5 24; add 1 25; sqrt 26; mul 21 27; div 1 28; mul 22 29; input p 5; mul 26 29;
mul 31 32; mul 30 33; mul 2 6; input p 7; mul 5 36; add 35 37; input p 8; mul 9 39; add 38 40; mul 5 27; mul 29 42;
mul 31 43; mul 30 44; add 41 45; mul 12 46; add 34 47; mul 0 48; add 16 49; input p 0; input p 3; mul 30 52; mul 30
53; add 51 54; mul 34 34; mul 46 46; add 56 57; mul 0 58; add 55 59; mul 2 10; mul 5 39; add 61 62; input p 11; mul
9 64; add 63 65; mul 12 66; mul 0 67; mul 46 66; mul 0 69; input p 9; mul 66 66; mul 0 72; add 71 73; store mass 0
15; store mass 1 50; store mass 2 60; store mass 3 68; store mass 4 70; store mass 5 74
    """,
)

STOP_MOVE = Graph(
    {'x': 14, 'z': 4, 'start': 2, 'p': 176},
    {'moved': 4},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 129; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 130; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 132; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 134; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
136; mul 11 30; add 29 31; max 1 32; min 0 33; store moved 0 16; store moved 1 22; store moved 2 28; store moved 3
34
    """,
)
