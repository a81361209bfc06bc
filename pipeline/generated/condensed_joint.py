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
add 155 157; constant -129.60000000000008; mul 29 159; constant -2.5714285714285743; mul 34 161; add 160 162; input
k 26; input k 25; input k 24; input k 23; constant 2.0; input k 22; input k 21; input k 20; input k 19; input k 18;
input k 17; input k 43; input k 60; input k 55; input k 57; input k 56; input k 58; sub 180 16; constant
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
90; div 2 287; input k 51; input k 52; input k 53; mul 291 291; input k 91; input k 92; mul 3 168; input k 30; input
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
store p 51 163; store p 52 164; store p 53 165; store p 54 166; store p 55 167; store p 56 169; store p 57 170;
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
271; constant 1.6; constant -1.6; max 274 35; min 273 275; input p 52; mul 276 277; mul 276 278; mul 276 279;
constant 0.6; constant -0.6; max 282 3; min 281 283; input p 53; mul 276 285; mul 276 286; mul 284 287; add 280 288;
input p 54; mul 276 290; mul 284 291; mul 284 292; add 289 293; input p 55; mul 284 295; mul 284 296; mul 284 297;
add 294 298; constant -0.35; max 300 149; min 271 301; constant 2.0; mul 302 303; input p 56; mul 276 305; mul 276
306; mul 304 307; add 299 308; input p 57; mul 276 310; mul 284 311; mul 304 312; add 309 313; input p 58; mul 284
315; mul 284 316; mul 304 317; add 314 318; mul 302 302; input p 59; mul 276 321; mul 320 322; add 319 323; mul 302
322; mul 304 325; add 324 326; input p 60; mul 284 328; mul 320 329; add 327 330; mul 302 329; mul 304 332; add 331
333; mul 302 320; input p 61; mul 335 336; add 334 337; mul 302 336; mul 320 339; add 338 340; mul 302 339; mul 304
342; add 341 343; mul 146 344; where 272 345; add 269 346; input p 62; input p 63; mul 149 349; input p 64; mul 3
351; add 350 352; input p 65; mul 35 354; add 353 355; constant -0.09999999999999995; mul 156 357; input p 66; mul
163 359; add 358 360; input p 67; mul 175 362; add 361 363; constant 1.2; mul 149 365; add 364 366; input p 68; mul
186 368; add 367 369; input p 69; mul 194 371; add 370 372; input p 70; mul 198 374; add 373 375; input p 71; mul
203 377; add 376 378; input p 72; mul 207 380; add 379 381; constant -0.033333333333333326; mul 35 383; input p 73;
mul 219 385; add 384 386; constant 0.13333333333333333; mul 156 388; add 387 389; input p 74; mul 163 391; add 390
392; input p 75; mul 171 394; add 393 395; input p 76; mul 175 397; add 396 398; mul 149 357; add 399 400; mul 186
359; add 401 402; input p 77; mul 198 404; add 403 405; input p 78; mul 259 407; add 406 408; mul 203 374; add 409
410; input p 79; mul 207 412; add 411 413; mul 148 414; add 382 415; add 356 416; mul 348 417; input p 80; input p
81; constant 0.009523809523809514; mul 215 421; input p 82; mul 35 219; mul 423 424; add 422 425; mul 159 383; add
426 427; mul 35 163; mul 385 429; add 428 430; constant 0.06666666666666667; mul 167 432; add 431 433; input p 83;
mul 35 171; mul 435 436; add 434 437; input p 84; mul 35 175; mul 439 440; add 438 441; input p 85; mul 156 175; mul
443 444; add 442 445; mul 190 357; add 446 447; mul 35 194; mul 359 449; add 448 450; mul 156 198; mul 362 452; add
451 453; mul 202 281; add 454 455; input p 86; mul 35 259; mul 457 458; add 456 459; mul 35 203; mul 407 461; add
460 462; input p 87; mul 156 203; mul 464 465; add 463 466; mul 156 207; mul 412 468; add 467 469; input p 88; mul
149 207; mul 471 472; add 470 473; mul 149 356; mul 149 351; input p 89; mul 3 477; add 476 478; input p 90; mul 35
480; add 479 481; mul 3 482; add 475 483; mul 149 354; mul 3 480; add 485 486; input p 91; mul 35 488; add 487 489;
mul 35 490; add 484 491; mul 105 492; add 474 493; mul 348 494; add 420 495; input p 92; mul 24 497; add 496 498;
input p 93; mul 39 500; sub 499 501; input p 94; mul 24 500; input p 95; sub 504 505; mul 39 497; add 506 507; sub
508 29; mul 509 509; mul 502 502; add 510 511; sqrt 512; mul 503 513; sqrt 514; div 2 515; mul 516 516; mul 503 517;
mul 502 518; input p 96; mul 303 514; mul 303 517; mul 517 522; sub 521 523; mul 520 524; constant 0.3; constant
-0.3; constant 1.4; sub 514 528; max 527 529; min 526 530; input p 97; input p 98; mul 531 533; add 532 534; mul 531
535; add 2 536; mul 525 537; input p 99; mul 94 539; input p 100; input p 101; mul 529 542; add 541 543; mul 529
544; add 2 545; mul 540 546; sub 538 547; mul 503 548; input p 102; input x 6; mul 550 551; input p 103; input x 8;
mul 553 554; add 552 555; input p 104; input x 10; mul 557 558; add 556 559; constant -0.5; mul 516 561; mul 516
562; mul 516 563; input p 105; input p 106; mul 529 566; add 565 567; mul 529 568; add 2 569; mul 564 570; mul 503
571; mul 560 572; add 549 573; input p 107; mul 572 575; mul 572 576; sub 498 501; mul 509 578; add 504 507; mul 502
580; sub 579 581; mul 518 582; mul 17 583; mul 131 584; mul 509 518; mul 0 586; sub 585 587; mul 0 145; mul 418 589;
mul 151 414; add 482 591; mul 348 592; mul 131 593; add 590 594; constant 0.01904761904761903; mul 35 596; input p
108; mul 219 598; add 597 599; mul 156 383; add 600 601; input p 109; mul 163 603; add 602 604; mul 171 391; add 605
606; mul 175 439; add 607 608; input p 110; mul 194 610; add 609 611; mul 259 368; add 612 613; mul 203 407; add 614
615; mul 154 414; add 616 617; add 490 618; mul 348 619; input x 5; mul 620 621; add 595 622; mul 519 623; add 588
624; mul 577 625; add 574 626; mul 519 627; input p 111; add 495 629; input p 112; mul 24 631; add 630 632; input p
113; mul 39 634; add 633 635; input p 114; mul 39 631; mul 24 634; input p 115; sub 639 640; sub 638 641; sub 642
29; mul 643 643; mul 636 636; add 644 645; sqrt 646; mul 637 647; sqrt 648; div 2 649; mul 650 650; mul 637 651; mul
636 652; input p 116; mul 303 648; mul 303 651; mul 651 656; sub 655 657; mul 654 658; sub 648 528; max 527 660; min
526 661; input p 117; input p 118; mul 662 664; add 663 665; mul 662 666; add 2 667; mul 659 668; input p 119; mul
98 670; input p 120; input p 121; mul 660 673; add 672 674; mul 660 675; add 2 676; mul 671 677; sub 669 678; mul
637 679; input p 122; input x 7; mul 681 682; input p 123; input x 9; mul 684 685; add 683 686; input p 124; input x
11; mul 688 689; add 687 690; mul 561 650; mul 650 692; mul 650 693; mul 566 660; add 565 695; mul 660 696; add 2
697; mul 694 698; mul 637 699; mul 691 700; add 680 701; input p 125; mul 700 703; mul 700 704; add 632 635; mul 643
706; sub 639 638; mul 636 708; add 707 709; mul 652 710; mul 17 711; mul 131 712; mul 643 652; mul 0 714; sub 713
715; mul 623 653; add 716 717; mul 705 718; add 702 719; mul 653 720; add 628 721; sub 419 722; mul 418 723; sub 347
724; input p 126; constant 12.0; mul 589 727; constant -6.0; mul 148 589; mul 131 151; add 730 731; mul 154 621; add
732 733; mul 729 734; add 728 735; mul 726 736; mul 589 729; constant 4.0; mul 734 739; add 738 740; mul 726 741;
mul 148 742; add 737 743; add 725 744; mul 145 745; mul 586 627; mul 714 720; add 747 748; sub 746 749; sub 144 750;
input p 127; input p 128; constant -1.0; input z 0; input start 0; sub 29 756; input p 129; input start 1; sub 3
759; mul 758 760; add 757 761; input p 130; mul 762 763; add 755 764; max 754 765; min 2 766; mul 753 767; input p
131; input z 1; input p 132; mul 762 771; add 770 772; max 754 773; min 2 774; mul 769 775; add 768 776; input p
133; input z 2; input p 134; mul 762 780; add 779 781; max 754 782; min 2 783; mul 778 784; add 777 785; input p
135; input z 3; input p 136; mul 762 789; add 788 790; max 754 791; min 2 792; mul 787 793; add 786 794; sub 752
795; input p 137; abs 0; mul 797 798; mul 0 799; input p 138; mul 0 801; mul 0 0; input p 139; add 803 804; sqrt
805; div 2 806; mul 802 807; add 800 808; sub 796 809; add 751 810; input p 140; input x 12; sub 29 813; mul 812
814; input p 141; input x 13; sub 29 817; mul 816 818; add 815 819; sub 811 820; mul 0 63; mul 28 131; add 822 823;
mul 48 621; add 824 825; mul 0 826; mul 0 28; mul 31 131; add 828 829; mul 34 621; add 830 831; mul 131 832; add 827
833; mul 0 48; mul 34 131; add 835 836; mul 52 621; add 837 838; mul 621 839; add 834 840; mul 17 24; mul 17 842;
mul 3 17; input p 142; div 2 7; mul 845 846; mul 3 3; sub 7 848; div 2 849; mul 10 850; add 847 851; mul 844 852;
mul 39 853; sub 843 854; mul 23 855; mul 131 131; mul 856 857; add 841 858; mul 68 859; mul 24 853; mul 17 39; mul
17 862; add 861 863; mul 23 864; mul 857 865; sub 860 866; mul 22 867; sub 821 868; mul 91 869; mul 82 90; mul 151
266; mul 146 872; abs 3; lt 874 281; input p 143; mul 276 876; mul 276 877; mul 276 878; mul 284 303; input p 144;
mul 276 881; mul 276 882; mul 880 883; add 879 884; mul 284 284; input p 145; mul 276 887; mul 886 888; add 885 889;
mul 284 888; mul 880 891; add 890 892; mul 284 886; input p 146; mul 894 895; add 893 896; mul 284 895; mul 886 898;
add 897 899; mul 284 898; mul 880 901; add 900 902; mul 287 302; add 903 904; mul 284 302; mul 291 906; add 905 907;
mul 292 302; add 908 909; mul 284 906; mul 295 911; add 910 912; mul 296 906; add 913 914; mul 297 302; add 915 916;
mul 311 320; add 917 918; mul 284 320; mul 315 920; add 919 921; mul 316 320; add 922 923; mul 328 335; add 924 925;
mul 146 926; where 875 927; add 873 928; mul 593 723; sub 929 930; mul 151 742; add 931 932; mul 584 627; mul 712
720; add 934 935; add 933 936; sub 135 937; input p 147; mul 39 939; mul 17 940; add 938 941; mul 758 795; sub 942
943; mul 42 859; mul 26 866; sub 945 946; mul 22 947; mul 19 853; mul 857 949; sub 948 950; sub 944 951; mul 871
952; sub 870 953; mul 87 90; input p 148; mul 35 956; input p 149; mul 215 958; add 957 959; input p 150; mul 219
961; add 960 962; mul 156 211; add 963 964; input p 151; mul 159 966; add 965 967; input p 152; mul 163 969; add 968
970; input p 153; mul 167 972; add 971 973; mul 171 228; add 974 975; input p 154; mul 175 977; add 976 978; mul 158
190; add 979 980; input p 155; mul 194 982; add 981 983; mul 170 198; add 984 985; input p 156; mul 202 987; add 986
988; mul 185 259; add 989 990; mul 203 258; add 991 992; mul 154 266; add 993 994; mul 146 995; abs 35; lt 997 273;
mul 276 276; mul 276 999; input p 157; mul 1000 1001; mul 276 1001; mul 999 1003; add 1002 1004; mul 276 303; mul
276 1003; mul 1006 1007; add 1005 1008; mul 276 284; mul 276 1010; mul 876 1011; add 1009 1012; mul 877 1010; add
1013 1014; mul 284 878; add 1015 1016; mul 276 886; mul 881 1018; add 1017 1019; mul 882 886; add 1020 1021; mul 887
894; add 1022 1023; mul 276 302; mul 276 1025; mul 277 1026; add 1024 1027; mul 278 1025; add 1028 1029; mul 279
302; add 1030 1031; mul 276 906; mul 285 1033; add 1032 1034; mul 286 906; add 1035 1036; mul 290 911; add 1037
1038; mul 276 320; mul 305 1040; add 1039 1041; mul 306 320; add 1042 1043; mul 310 920; add 1044 1045; mul 321 335;
add 1046 1047; mul 146 1048; where 998 1049; add 996 1050; mul 620 723; sub 1051 1052; input p 158; mul 621 1054;
mul 154 742; add 1055 1056; add 1053 1057; mul 54 859; mul 22 1059; add 1058 1060; mul 955 1061; sub 954 1062; mul
57 71; mul 80 80; sub 1064 1065; mul 90 1066; mul 952 1067; mul 869 871; sub 1068 1069; mul 60 71; mul 77 80; sub
1071 1072; mul 90 1073; mul 1061 1074; add 1070 1075; mul 869 955; mul 952 1074; sub 1077 1078; mul 46 71; mul 77
77; sub 1080 1081; mul 90 1082; mul 1061 1083; sub 1079 1084; mul 572 625; input p 159; mul 551 1087; sub 1086 1088;
mul 700 718; mul 682 1087; sub 1090 1091; input p 160; mul 554 1093; sub 1086 1094; mul 685 1093; sub 1090 1096;
input p 161; mul 558 1098; sub 1086 1099; mul 689 1098; sub 1090 1101; input p 162; mul 814 1103; input p 163; mul
818 1105; store rates 0 0; store rates 1 1063; store rates 2 131; store rates 3 1076; store rates 4 621; store rates
5 1085; store rates 6 1089; store rates 7 1092; store rates 8 1095; store rates 9 1097; store rates 10 1100; store
rates 11 1102; store rates 12 1104; store rates 13 1106
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
167 168; constant 1.6; constant -1.6; max 171 50; min 170 172; input p 52; mul 173 174; mul 173 175; mul 173 176;
constant 0.6; constant -0.6; max 179 10; min 178 180; input p 53; mul 173 182; mul 173 183; mul 181 184; add 177
185; input p 54; mul 173 187; mul 181 188; mul 181 189; add 186 190; input p 55; mul 181 192; mul 181 193; mul 181
194; add 191 195; constant -0.35; max 197 45; min 168 198; constant 2.0; mul 199 200; input p 56; mul 173 202; mul
173 203; mul 201 204; add 196 205; input p 57; mul 173 207; mul 181 208; mul 201 209; add 206 210; input p 58; mul
181 212; mul 181 213; mul 201 214; add 211 215; mul 199 199; input p 59; mul 173 218; mul 217 219; add 216 220; mul
199 219; mul 201 222; add 221 223; input p 60; mul 181 225; mul 217 226; add 224 227; mul 199 226; mul 201 229; add
228 230; mul 199 217; input p 61; mul 232 233; add 231 234; mul 199 233; mul 217 236; add 235 237; mul 199 236; mul
201 239; add 238 240; mul 42 241; where 169 242; add 166 243; input p 62; input p 63; mul 45 246; input p 64; mul 10
248; add 247 249; input p 65; mul 50 251; add 250 252; constant -0.09999999999999995; mul 53 254; input p 66; mul 60
256; add 255 257; input p 67; mul 72 259; add 258 260; constant 1.2; mul 45 262; add 261 263; input p 68; mul 83
265; add 264 266; input p 69; mul 91 268; add 267 269; input p 70; mul 95 271; add 270 272; input p 71; mul 100 274;
add 273 275; input p 72; mul 104 277; add 276 278; constant -0.033333333333333326; mul 50 280; input p 73; mul 116
282; add 281 283; constant 0.13333333333333333; mul 53 285; add 284 286; input p 74; mul 60 288; add 287 289; input
p 75; mul 68 291; add 290 292; input p 76; mul 72 294; add 293 295; mul 45 254; add 296 297; mul 83 256; add 298
299; input p 77; mul 95 301; add 300 302; input p 78; mul 156 304; add 303 305; mul 100 271; add 306 307; input p
79; mul 104 309; add 308 310; mul 44 311; add 279 312; add 253 313; mul 245 314; input p 80; input p 94; input p 96;
constant 1.0; input p 2; mul 10 320; mul 10 321; add 319 322; input p 1; mul 10 324; mul 10 325; add 319 326; sqrt
327; sqrt 323; mul 328 329; div 319 330; mul 323 331; input p 93; mul 332 333; input p 95; sub 334 335; mul 10 329;
mul 331 337; input p 92; mul 338 339; add 336 340; sub 341 11; mul 342 342; input p 81; constant
0.009523809523809514; mul 112 345; input p 82; mul 50 116; mul 347 348; add 346 349; mul 56 280; add 350 351; mul 50
60; mul 282 353; add 352 354; constant 0.06666666666666667; mul 64 356; add 355 357; input p 83; mul 50 68; mul 359
360; add 358 361; input p 84; mul 50 72; mul 363 364; add 362 365; input p 85; mul 53 72; mul 367 368; add 366 369;
mul 87 254; add 370 371; mul 50 91; mul 256 373; add 372 374; mul 53 95; mul 259 376; add 375 377; mul 99 178; add
378 379; input p 86; mul 50 156; mul 381 382; add 380 383; mul 50 100; mul 304 385; add 384 386; input p 87; mul 53
100; mul 388 389; add 387 390; mul 53 104; mul 309 392; add 391 393; input p 88; mul 45 104; mul 395 396; add 394
397; mul 45 253; mul 45 248; input p 89; mul 10 401; add 400 402; input p 90; mul 50 404; add 403 405; mul 10 406;
add 399 407; mul 45 251; mul 10 404; add 409 410; input p 91; mul 50 412; add 411 413; mul 50 414; add 408 415; mul
16 416; add 398 417; mul 245 418; add 344 419; mul 332 339; add 420 421; mul 333 338; sub 422 423; mul 424 424; add
343 425; sqrt 426; mul 317 427; mul 200 428; sqrt 428; div 319 430; mul 431 431; mul 200 432; mul 432 433; sub 429
434; mul 318 435; constant 0.3; constant -0.3; constant 1.4; sub 428 439; max 438 440; min 437 441; input p 97;
input p 98; mul 442 444; add 443 445; mul 442 446; add 319 447; mul 436 448; input p 99; mul 3 450; input p 100;
input p 101; mul 440 453; add 452 454; mul 440 455; add 319 456; mul 451 457; sub 449 458; mul 317 459; mul 317 432;
mul 424 461; mul 460 462; input p 114; input p 116; input p 112; mul 338 466; input p 113; mul 332 468; input p 115;
sub 469 470; sub 467 471; sub 472 11; mul 473 473; input p 111; add 419 475; mul 332 466; add 476 477; mul 338 468;
add 478 479; mul 480 480; add 474 481; sqrt 482; mul 464 483; mul 200 484; sqrt 484; div 319 486; mul 487 487; mul
200 488; mul 488 489; sub 485 490; mul 465 491; sub 484 439; max 438 493; min 437 494; input p 117; input p 118; mul
495 497; add 496 498; mul 495 499; add 319 500; mul 492 501; input p 119; mul 7 503; input p 120; input p 121; mul
493 506; add 505 507; mul 493 508; add 319 509; mul 504 510; sub 502 511; mul 464 512; mul 464 488; mul 480 514; mul
513 515; add 463 516; sub 316 517; mul 315 518; sub 244 519; mul 41 520; mul 342 461; mul 460 522; mul 473 514; mul
513 524; add 523 525; sub 521 526; sub 40 527; add 0 528; div 319 328; mul 331 530; input p 147; mul 338 532; mul
531 533; mul 47 163; mul 42 535; abs 10; lt 537 178; input p 143; mul 173 539; mul 173 540; mul 173 541; mul 181
200; input p 144; mul 173 544; mul 173 545; mul 543 546; add 542 547; mul 181 181; input p 145; mul 173 550; mul 549
551; add 548 552; mul 181 551; mul 543 554; add 553 555; mul 181 549; input p 146; mul 557 558; add 556 559; mul 181
558; mul 549 561; add 560 562; mul 181 561; mul 543 564; add 563 565; mul 184 199; add 566 567; mul 181 199; mul 188
569; add 568 570; mul 189 199; add 571 572; mul 181 569; mul 192 574; add 573 575; mul 193 569; add 576 577; mul 194
199; add 578 579; mul 208 217; add 580 581; mul 181 217; mul 212 583; add 582 584; mul 213 217; add 585 586; mul 225
232; add 587 588; mul 42 589; where 538 590; add 536 591; mul 47 311; add 406 593; mul 245 594; mul 518 595; sub 592
596; sub 421 423; mul 342 598; add 334 340; mul 424 600; sub 599 601; mul 461 602; mul 531 603; mul 460 604; add 477
479; mul 473 606; sub 469 467; mul 480 608; add 607 609; mul 514 610; mul 531 611; mul 513 612; add 605 613; add 597
614; sub 38 615; add 534 616; input p 148; mul 50 618; input p 149; mul 112 620; add 619 621; input p 150; mul 116
623; add 622 624; mul 53 108; add 625 626; input p 151; mul 56 628; add 627 629; input p 152; mul 60 631; add 630
632; input p 153; mul 64 634; add 633 635; mul 68 125; add 636 637; input p 154; mul 72 639; add 638 640; mul 55 87;
add 641 642; input p 155; mul 91 644; add 643 645; mul 67 95; add 646 647; input p 156; mul 99 649; add 648 650; mul
82 156; add 651 652; mul 100 155; add 653 654; mul 51 163; add 655 656; mul 42 657; abs 50; lt 659 170; mul 173 173;
mul 173 661; input p 157; mul 662 663; mul 173 663; mul 661 665; add 664 666; mul 173 200; mul 173 665; mul 668 669;
add 667 670; mul 173 181; mul 173 672; mul 539 673; add 671 674; mul 540 672; add 675 676; mul 181 541; add 677 678;
mul 173 549; mul 544 680; add 679 681; mul 545 549; add 682 683; mul 550 557; add 684 685; mul 173 199; mul 173 687;
mul 174 688; add 686 689; mul 175 687; add 690 691; mul 176 199; add 692 693; mul 173 569; mul 182 695; add 694 696;
mul 183 569; add 697 698; mul 187 574; add 699 700; mul 173 217; mul 202 702; add 701 703; mul 203 217; add 704 705;
mul 207 583; add 706 707; mul 218 232; add 708 709; mul 42 710; where 660 711; add 658 712; constant
0.01904761904761903; mul 50 714; input p 108; mul 116 716; add 715 717; mul 53 280; add 718 719; input p 109; mul 60
721; add 720 722; mul 68 288; add 723 724; mul 72 363; add 725 726; input p 110; mul 91 728; add 727 729; mul 156
265; add 730 731; mul 100 304; add 732 733; mul 51 311; add 734 735; add 414 736; mul 245 737; mul 518 738; sub 713
739; neg 740; sub 26 19; mul 12 30; add 742 743; input p 164; mul 47 50; mul 55 746; add 745 747; mul 50 746; mul 59
749; add 748 750; mul 53 200; mul 47 752; mul 63 753; add 751 754; mul 50 753; mul 67 756; add 755 757; mul 53 753;
mul 47 64; add 759 760; mul 71 761; add 758 762; mul 45 47; mul 86 764; add 763 765; mul 50 764; mul 90 767; add 766
768; mul 53 764; mul 47 87; add 770 771; mul 94 772; add 769 773; mul 47 99; mul 98 775; add 774 776; input p 165;
mul 122 746; add 778 779; mul 125 749; add 780 781; mul 128 753; add 782 783; mul 131 756; add 784 785; mul 134 761;
add 786 787; mul 143 764; add 788 789; mul 146 767; add 790 791; mul 149 772; add 792 793; mul 94 775; add 794 795;
mul 44 796; add 777 797; mul 42 798; le 180 178; le 178 180; add 800 801; div 319 802; mul 800 803; le 179 10; le 10
179; add 805 806; div 319 807; mul 805 808; mul 804 809; mul 184 810; mul 189 810; mul 188 810; mul 181 813; add 812
814; add 811 815; mul 194 810; mul 193 810; mul 192 810; mul 181 819; add 818 820; mul 181 821; add 817 822; add 816
823; mul 208 810; mul 201 825; add 824 826; mul 213 810; mul 212 810; mul 181 829; add 828 830; mul 201 831; add 827
832; mul 225 810; mul 217 834; add 833 835; mul 199 834; mul 201 837; add 836 838; mul 42 839; where 169 840; add
799 841; input p 166; mul 256 749; add 843 844; mul 259 761; add 845 846; mul 268 767; add 847 848; mul 271 772; add
849 850; mul 274 775; add 851 852; input p 167; mul 288 749; add 854 855; mul 291 756; add 856 857; mul 294 761; add
858 859; mul 301 772; add 860 861; mul 271 775; add 862 863; mul 44 864; add 853 865; add 248 866; mul 245 867; mul
518 868; mul 200 342; mul 200 321; mul 331 871; mul 331 332; mul 325 530; mul 329 874; div 319 329; mul 321 876; mul
328 877; add 875 878; mul 873 879; sub 872 880; mul 333 881; mul 10 877; add 329 883; mul 331 884; mul 331 338; mul
879 886; sub 885 887; mul 339 888; add 882 889; mul 870 890; mul 200 424; mul 280 746; mul 50 749; mul 282 894; add
893 895; mul 356 753; add 896 897; mul 50 756; mul 359 899; add 898 900; mul 50 761; mul 363 902; add 901 903; mul
53 761; mul 47 72; add 905 906; mul 367 907; add 904 908; mul 254 764; add 909 910; mul 50 767; mul 256 912; add 911
913; mul 53 772; mul 47 95; add 915 916; mul 259 917; add 914 918; mul 50 775; mul 304 920; add 919 921; mul 53 775;
mul 47 100; add 923 924; mul 388 925; add 922 926; mul 47 104; mul 309 928; add 927 929; add 402 406; add 400 931;
add 405 932; mul 16 933; add 930 934; mul 245 935; mul 339 881; add 936 937; mul 333 888; sub 938 939; mul 892 940;
add 891 941; mul 200 427; div 319 943; mul 942 944; mul 317 945; mul 200 946; mul 200 431; mul 200 430; div 319 949;
mul 946 950; mul 432 951; mul 948 952; neg 953; mul 200 954; mul 432 955; mul 433 953; sub 956 957; sub 947 958; mul
318 959; mul 448 960; le 441 437; le 437 441; add 962 963; div 319 964; mul 962 965; le 438 440; le 440 438; add 967
968; div 319 969; mul 967 970; mul 946 971; mul 966 972; mul 444 973; mul 442 974; mul 446 973; add 975 976; mul 436
977; add 961 978; mul 453 946; mul 440 980; mul 455 946; add 981 982; mul 451 983; sub 979 984; mul 317 985; mul 462
986; mul 461 940; mul 317 953; mul 424 989; sub 988 990; mul 460 991; add 987 992; mul 200 473; mul 466 888; mul 468
881; sub 995 996; mul 994 997; mul 200 480; mul 466 881; add 936 1000; mul 468 888; add 1001 1002; mul 999 1003; add
998 1004; mul 200 483; div 319 1006; mul 1005 1007; mul 464 1008; mul 200 1009; mul 200 487; mul 200 486; div 319
1012; mul 1009 1013; mul 488 1014; mul 1011 1015; neg 1016; mul 200 1017; mul 488 1018; mul 489 1016; sub 1019 1020;
sub 1010 1021; mul 465 1022; mul 501 1023; le 494 437; le 437 494; add 1025 1026; div 319 1027; mul 1025 1028; le
438 493; le 493 438; add 1030 1031; div 319 1032; mul 1030 1033; mul 1009 1034; mul 1029 1035; mul 497 1036; mul 495
1037; mul 499 1036; add 1038 1039; mul 492 1040; add 1024 1041; mul 506 1009; mul 493 1043; mul 508 1009; add 1044
1045; mul 504 1046; sub 1042 1047; mul 464 1048; mul 515 1049; mul 514 1003; mul 464 1016; mul 480 1052; sub 1051
1053; mul 513 1054; add 1050 1055; add 993 1056; mul 315 1057; sub 869 1058; sub 842 1059; mul 41 1060; mul 522 986;
mul 461 890; mul 342 989; sub 1063 1064; mul 460 1065; add 1062 1066; mul 524 1049; mul 514 997; mul 473 1052; sub
1069 1070; mul 513 1071; add 1068 1072; add 1067 1073; sub 1061 1074; sub 744 1075; mul 532 888; mul 531 1077; mul
530 530; mul 874 1079; mul 331 1080; mul 331 531; mul 879 1082; add 1081 1083; mul 533 1084; sub 1078 1085; mul 47
796; mul 42 1087; mul 200 810; mul 546 1089; mul 543 810; mul 551 1091; add 1090 1092; mul 554 1089; mul 551 810;
mul 543 1095; add 1094 1096; add 1093 1097; mul 181 1091; mul 549 810; add 1099 1100; mul 558 1101; add 1098 1102;
mul 561 1091; mul 558 810; mul 549 1105; add 1104 1106; add 1103 1107; mul 564 1089; mul 561 810; mul 181 1105; add
1110 1111; mul 543 1112; add 1109 1113; add 1108 1114; mul 199 810; mul 188 1116; add 1115 1117; mul 199 813; add
1118 1119; mul 181 1116; mul 569 810; add 1121 1122; mul 192 1123; add 1120 1124; mul 193 1116; mul 569 819; add
1126 1127; add 1125 1128; mul 199 821; add 1129 1130; mul 217 810; mul 212 1132; add 1131 1133; mul 217 829; add
1134 1135; mul 42 1136; where 538 1137; add 1088 1138; mul 47 864; add 401 1140; mul 245 1141; mul 518 1142; mul 595
1057; sub 1143 1144; sub 1139 1145; mul 604 986; mul 598 890; sub 937 939; mul 342 1149; add 1148 1150; mul 600 940;
mul 424 890; add 1152 1153; sub 1151 1154; mul 461 1155; mul 602 989; sub 1156 1157; mul 531 1158; mul 603 1084; sub
1159 1160; mul 460 1161; add 1147 1162; mul 612 1049; mul 606 997; add 1000 1002; mul 473 1166; add 1165 1167; mul
608 1003; sub 996 995; mul 480 1170; add 1169 1171; add 1168 1172; mul 514 1173; mul 610 1052; sub 1174 1175; mul
531 1176; mul 611 1084; sub 1177 1178; mul 513 1179; add 1164 1180; add 1163 1181; add 1146 1182; add 30 1183; sub
1086 1184; input p 168; mul 628 746; add 1186 1187; mul 631 749; add 1188 1189; mul 634 753; add 1190 1191; mul 125
756; add 1192 1193; mul 639 761; add 1194 1195; mul 55 764; add 1196 1197; mul 644 767; add 1198 1199; mul 67 772;
add 1200 1201; mul 155 775; add 1202 1203; mul 51 796; add 1204 1205; mul 42 1206; mul 173 810; mul 173 1208; mul
539 1209; mul 540 1208; add 1210 1211; mul 541 810; add 1212 1213; mul 173 1091; mul 544 1215; add 1214 1216; mul
545 1091; add 1217 1218; mul 550 1101; add 1219 1220; mul 173 1116; mul 182 1222; add 1221 1223; mul 183 1116; add
1224 1225; mul 187 1123; add 1226 1227; mul 207 1132; add 1228 1229; mul 42 1230; where 660 1231; add 1207 1232;
input p 169; mul 721 749; add 1234 1235; mul 288 756; add 1236 1237; mul 363 761; add 1238 1239; mul 728 767; add
1240 1241; mul 304 775; add 1242 1243; mul 51 864; add 1244 1245; add 404 1246; mul 245 1247; mul 518 1248; mul 738
1057; sub 1249 1250; sub 1233 1251; neg 1252; input p 170; add 52 53; mul 55 1255; add 1254 1256; mul 50 1255; add
56 1258; mul 59 1259; add 1257 1260; mul 51 752; mul 63 1262; add 1261 1263; mul 50 1262; add 64 1265; mul 67 1266;
add 1264 1267; mul 53 1262; mul 51 64; add 1269 1270; mul 71 1271; add 1268 1272; mul 45 78; add 1273 1274; mul 79
200; mul 82 1276; add 1275 1277; mul 45 51; mul 86 1279; add 1278 1280; mul 50 1279; add 87 1282; mul 90 1283; add
1281 1284; mul 53 1279; mul 51 87; add 1286 1287; mul 94 1288; add 1285 1289; mul 51 99; mul 98 1291; add 1290 1292;
mul 50 200; mul 111 1294; add 108 1295; mul 50 1294; add 112 1297; mul 115 1298; add 1296 1299; input p 171; add
1300 1301; mul 122 1255; add 1302 1303; mul 125 1259; add 1304 1305; mul 128 1262; add 1306 1307; mul 131 1266; add
1308 1309; mul 134 1271; add 1310 1311; mul 45 55; add 1312 1313; mul 59 1276; add 1314 1315; mul 143 1279; add 1316
1317; mul 146 1283; add 1318 1319; mul 149 1288; add 1320 1321; mul 99 155; add 1322 1323; mul 94 1291; add 1324
1325; mul 44 1326; add 1293 1327; mul 42 1328; le 172 170; le 170 172; add 1330 1331; div 319 1332; mul 1330 1333;
le 171 50; le 50 171; add 1335 1336; div 319 1337; mul 1335 1338; mul 1334 1339; mul 176 1340; mul 175 1340; mul 174
1340; mul 173 1343; add 1342 1344; mul 173 1345; add 1341 1346; mul 183 1340; mul 182 1340; mul 173 1349; add 1348
1350; mul 181 1351; add 1347 1352; mul 187 1340; mul 181 1354; mul 181 1355; add 1353 1356; mul 203 1340; mul 202
1340; mul 173 1359; add 1358 1360; mul 201 1361; add 1357 1362; mul 207 1340; mul 181 1364; mul 201 1365; add 1363
1366; mul 218 1340; mul 217 1368; add 1367 1369; mul 199 1368; mul 201 1371; add 1370 1372; mul 42 1373; where 169
1374; add 1329 1375; input p 172; mul 256 1259; add 1377 1378; mul 259 1271; add 1379 1380; mul 265 1276; add 1381
1382; mul 268 1283; add 1383 1384; mul 271 1288; add 1385 1386; mul 274 1291; add 1387 1388; mul 282 1298; add 280
1390; input p 173; add 1391 1392; mul 288 1259; add 1393 1394; mul 291 1266; add 1395 1396; mul 294 1271; add 1397
1398; mul 256 1276; add 1399 1400; mul 301 1288; add 1401 1402; mul 99 304; add 1403 1404; mul 271 1291; add 1405
1406; mul 44 1407; add 1389 1408; add 251 1409; mul 245 1410; mul 518 1411; mul 50 1298; add 116 1413; mul 347 1414;
add 715 1415; mul 280 1255; add 1416 1417; mul 50 1259; add 60 1419; mul 282 1420; add 1418 1421; mul 356 1262; add
1422 1423; mul 50 1266; add 68 1425; mul 359 1426; add 1424 1427; mul 50 1271; add 72 1429; mul 363 1430; add 1428
1431; mul 53 1271; mul 51 72; add 1433 1434; mul 367 1435; add 1432 1436; mul 254 1279; add 1437 1438; mul 50 1283;
add 91 1440; mul 256 1441; add 1439 1442; mul 53 1288; mul 51 95; add 1444 1445; mul 259 1446; add 1443 1447; mul
156 200; mul 381 1449; add 1448 1450; mul 50 1291; add 100 1452; mul 304 1453; add 1451 1454; mul 53 1291; mul 51
100; add 1456 1457; mul 388 1458; add 1455 1459; mul 51 104; mul 309 1461; add 1460 1462; add 413 414; add 411 1464;
mul 16 1465; add 1463 1466; mul 245 1467; mul 892 1468; mul 944 1469; mul 317 1470; mul 200 1471; mul 950 1471; mul
432 1473; mul 948 1474; neg 1475; mul 200 1476; mul 432 1477; mul 433 1475; sub 1478 1479; sub 1472 1480; mul 318
1481; mul 448 1482; mul 971 1471; mul 966 1484; mul 444 1485; mul 442 1486; mul 446 1485; add 1487 1488; mul 436
1489; add 1483 1490; mul 453 1471; mul 440 1492; mul 455 1471; add 1493 1494; mul 451 1495; sub 1491 1496; mul 317
1497; mul 462 1498; mul 461 1468; mul 317 1475; mul 424 1501; sub 1500 1502; mul 460 1503; add 1499 1504; mul 999
1468; mul 1007 1506; mul 464 1507; mul 200 1508; mul 1013 1508; mul 488 1510; mul 1011 1511; neg 1512; mul 200 1513;
mul 488 1514; mul 489 1512; sub 1515 1516; sub 1509 1517; mul 465 1518; mul 501 1519; mul 1034 1508; mul 1029 1521;
mul 497 1522; mul 495 1523; mul 499 1522; add 1524 1525; mul 492 1526; add 1520 1527; mul 506 1508; mul 493 1529;
mul 508 1508; add 1530 1531; mul 504 1532; sub 1528 1533; mul 464 1534; mul 515 1535; mul 514 1468; mul 464 1512;
mul 480 1538; sub 1537 1539; mul 513 1540; add 1536 1541; add 1505 1542; mul 315 1543; sub 1412 1544; sub 1376 1545;
mul 41 1546; mul 522 1498; mul 342 1501; mul 460 1549; sub 1548 1550; mul 524 1535; mul 473 1538; mul 513 1553; sub
1552 1554; add 1551 1555; sub 1547 1556; neg 1557; mul 47 1326; mul 42 1559; mul 541 1340; mul 540 1340; mul 539
1340; mul 173 1563; add 1562 1564; mul 173 1565; add 1561 1566; mul 545 1340; mul 544 1340; mul 173 1569; add 1568
1570; mul 543 1571; add 1567 1572; mul 550 1340; mul 549 1574; add 1573 1575; mul 181 1574; mul 543 1577; add 1576
1578; mul 199 1351; add 1579 1580; mul 569 1354; add 1581 1582; mul 199 1355; add 1583 1584; mul 217 1364; add 1585
1586; mul 42 1587; where 538 1588; add 1560 1589; mul 47 1407; add 404 1591; mul 245 1592; mul 518 1593; mul 595
1543; sub 1594 1595; sub 1590 1596; mul 604 1498; mul 600 1468; mul 461 1599; mul 602 1501; add 1600 1601; mul 531
1602; mul 460 1603; sub 1598 1604; mul 612 1535; mul 608 1468; mul 514 1607; mul 610 1538; sub 1608 1609; mul 531
1610; mul 513 1611; add 1606 1612; add 1605 1613; add 1597 1614; neg 1615; mul 620 1294; add 618 1617; mul 623 1298;
add 1618 1619; input p 174; add 1620 1621; mul 628 1255; add 1622 1623; mul 631 1259; add 1624 1625; mul 634 1262;
add 1626 1627; mul 125 1266; add 1628 1629; mul 639 1271; add 1630 1631; mul 55 1279; add 1632 1633; mul 644 1283;
add 1634 1635; mul 67 1288; add 1636 1637; mul 82 99; add 1638 1639; mul 155 1291; add 1640 1641; mul 51 1326; add
1642 1643; mul 42 1644; mul 668 1340; mul 173 1646; mul 661 1340; add 1647 1648; mul 663 1649; mul 665 1646; mul 663
1340; mul 661 1652; add 1651 1653; add 1650 1654; mul 200 1340; mul 669 1656; mul 665 1340; mul 173 1652; add 1658
1659; mul 668 1660; add 1657 1661; add 1655 1662; mul 181 1340; mul 173 1664; mul 672 1340; add 1665 1666; mul 539
1667; add 1663 1668; mul 540 1664; mul 672 1563; add 1670 1671; add 1669 1672; mul 181 1565; add 1673 1674; mul 549
1340; mul 544 1676; add 1675 1677; mul 549 1569; add 1678 1679; mul 199 1340; mul 173 1681; mul 687 1340; add 1682
1683; mul 174 1684; add 1680 1685; mul 175 1681; mul 687 1343; add 1687 1688; add 1686 1689; mul 199 1345; add 1690
1691; mul 569 1340; mul 182 1693; add 1692 1694; mul 569 1349; add 1695 1696; mul 217 1340; mul 202 1698; add 1697
1699; mul 217 1359; add 1700 1701; mul 42 1702; where 660 1703; add 1645 1704; mul 716 1298; add 714 1706; input p
175; add 1707 1708; mul 721 1259; add 1709 1710; mul 288 1266; add 1711 1712; mul 363 1271; add 1713 1714; mul 728
1283; add 1715 1716; mul 99 265; add 1717 1718; mul 304 1291; add 1719 1720; mul 51 1407; add 1721 1722; add 412
1723; mul 245 1724; mul 518 1725; mul 738 1543; sub 1726 1727; sub 1705 1728; neg 1729; store forces 0 529; store
forces 1 617; store forces 2 741; store by_shape 0 1076; store by_shape 2 1185; store by_shape 4 1253; store
by_shape 1 1558; store by_shape 3 1616; store by_shape 5 1730
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
