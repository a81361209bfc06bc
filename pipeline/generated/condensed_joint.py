"""The condensed joint: rates, forces at rest, inertia, stop operators after a step.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

CONSTANTS = ('l', 'bending', 'bending_loss', 'steepening', 'stiffening', 'shortening', 'curvature', 'slope_by_q',
    'slope_by_tau', 'slope_by_beta', 'rotation', 'quartic_qqqq', 'quartic_qqqt', 'quartic_qqqb', 'quartic_qqtt',
    'quartic_qqtb', 'quartic_qqbb', 'quartic_qttt', 'quartic_qttb', 'quartic_qtbb', 'quartic_qbbb',
    'quartic_tttt', 'quartic_tttb', 'quartic_ttbb', 'quartic_tbbb', 'quartic_bbbb', 'sextic_qqqbbb',
    'sextic_qqtbbb', 'sextic_qqbbbb', 'sextic_qttbbb', 'sextic_qtbbbb', 'sextic_qbbbbb', 'sextic_tttbbb',
    'sextic_ttbbbb', 'sextic_tbbbbb', 'sextic_bbbbbb', 'mass', 'cross', 'inertia', 'gyration', 'interior_inertia',
    'rise_qq', 'rise_qt', 'rise_tt', 'rise_qb', 'rise_tb', 'rise_bb', 'weight', 'offset', 'side_force',
    'relaxation_0', 'relaxation_1', 'relaxation_2', 'strain_slope', 'viscosity', 'drag', 'sliding_force',
    'sliding_speed', 'friction_arm', 'left_a', 'left_c', 'left_e_z', 'left_e_x', 'left_l0', 'left_elastic',
    'left_hardening', 'left_hardening_slope', 'left_electric', 'left_electric_slope', 'left_maxwell_0',
    'left_maxwell_1', 'left_maxwell_2', 'left_viscous', 'right_a', 'right_c', 'right_e_z', 'right_e_x',
    'right_l0', 'right_elastic', 'right_hardening', 'right_hardening_slope', 'right_electric',
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

SEXTICS = ('qqqbbb', 'qqtbbb', 'qqbbbb', 'qttbbb', 'qtbbbb', 'qbbbbb', 'tttbbb', 'ttbbbb', 'tbbbbb', 'bbbbbb')

FIRST_ELEMENT = 12

DRY_LEVELS = ('sliding_force',)

AT_REST = (1.0, 1.0)

STOPS = 4

CREEPS = 2

BRANCHES = 3

PREPARE = Graph(
    {'k': 100},
    {'p': 188},
    """
input k 38; input k 39; constant 1.0; input k 10; sub 3 2; input k 36; input k 48; input k 42; input k 43; input k
45; input k 40; input k 44; input k 46; input k 41; input k 37; input k 99; input k 0; div 2 16; mul 15 17; constant
0.5; constant -2.0; input k 2; mul 20 21; input k 54; input k 1; constant -6.000000000000002; constant
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
constant 3.0; input k 26; mul 164 165; input k 27; constant 2.0; mul 167 168; input k 28; mul 168 170; input k 29;
input k 30; input k 31; constant 4.0; input k 11; mul 175 176; input k 12; mul 164 178; input k 13; mul 164 180;
input k 14; mul 168 182; input k 15; mul 168 184; input k 16; mul 168 186; input k 17; input k 18; input k 19; input
k 20; input k 47; input k 64; input k 59; input k 61; input k 60; input k 62; sub 197 16; constant
-0.0006802721088435403; input k 5; mul 199 200; constant 0.0035714285714285787; mul 200 202; constant
0.029931972789115628; mul 200 204; constant -0.08571428571428567; mul 200 206; constant 0.12857142857142853; mul 200
208; constant -0.38571428571428534; mul 200 210; constant 1.0285714285714285; mul 200 212; constant
-0.0004787100025195255; mul 200 214; constant 0.0027210884353741486; mul 200 216; constant -0.010714285714285721;
mul 200 218; constant 0.028571428571428567; mul 200 220; constant 0.010714285714285735; mul 200 222; constant
-0.04285714285714284; mul 200 224; constant -0.12857142857142845; mul 200 226; constant 0.00032473894907757275; mul
200 228; constant -0.0014361300075585765; mul 200 230; constant -0.003571428571428574; mul 200 232; constant
-0.0013605442176870806; mul 200 234; input k 63; div 2 236; input k 65; input k 66; input k 67; input k 68; mul 19
241; constant 0.7142857142857143; sub 241 243; mul 242 244; input k 69; input k 70; input k 71; input k 53; mul 19
249; sub 249 243; mul 250 251; input k 72; input k 78; input k 74; input k 73; input k 75; input k 76; sub 258 16;
input k 77; div 2 260; input k 79; input k 80; input k 81; input k 82; mul 19 265; sub 265 243; mul 266 267; input k
83; input k 84; input k 85; input k 86; input k 49; input k 87; input k 58; input k 91; div 2 276; input k 88; input
k 92; div 2 279; input k 89; input k 93; div 2 282; input k 90; input k 94; div 2 285; input k 55; input k 56; input
k 57; mul 289 289; input k 95; input k 96; mul 3 168; mul 168 172; input k 32; mul 164 295; input k 33; mul 168 297;
input k 34; mul 164 188; mul 168 189; input k 21; mul 175 302; input k 22; mul 164 304; input k 23; mul 168 306;
input k 24; mul 6 192; constant 0.8000000000000002; constant 2.400000000000001; mul 30 311; add 310 312; constant
0.01904761904761903; mul 35 314; add 313 315; constant -1.3714285714285723; mul 42 317; constant 1.3714285714285714;
mul 29 319; constant 0.007256235827664418; mul 34 321; add 320 322; constant -4.799999999999999; mul 42 324;
constant 1.3714285714285692; mul 29 326; constant -0.05714285714285729; mul 34 328; add 327 329; constant
-7.199999999999996; mul 42 331; constant 7.199999999999994; mul 29 333; constant 0.2190476190476189; mul 34 335; add
334 336; constant -45.25714285714286; mul 29 338; constant -0.11428571428571327; mul 34 340; add 339 341; constant
-28.800000000000004; mul 42 343; mul 168 174; mul 168 299; input k 35; mul 164 347; mul 168 190; mul 164 191; mul
164 308; input k 25; mul 175 352; constant 0.8; mul 21 354; input k 50; input k 51; input k 52; input k 97; input k
98; mul 37 39; mul 39 118; mul 7 16; mul 39 104; mul 37 40; mul 40 118; mul 11 16; mul 40 104; store p 0 0; store p
1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store
p 10 11; store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 22; store p 16 23; store p 17 17;
store p 18 24; store p 19 37; store p 20 38; store p 21 39; store p 22 40; store p 23 43; store p 24 48; store p 25
50; store p 26 55; store p 27 60; store p 28 67; store p 29 69; store p 30 74; store p 31 76; store p 32 81; store p
33 86; store p 34 91; store p 35 96; store p 36 102; store p 37 104; store p 38 106; store p 39 111; store p 40 118;
store p 41 120; store p 42 125; store p 43 129; store p 44 134; store p 45 139; store p 46 141; store p 47 146;
store p 48 151; store p 49 153; store p 50 158; store p 51 163; store p 52 166; store p 53 169; store p 54 171;
store p 55 172; store p 56 173; store p 57 174; store p 58 177; store p 59 179; store p 60 181; store p 61 183;
store p 62 185; store p 63 187; store p 64 188; store p 65 189; store p 66 190; store p 67 191; store p 68 16; store
p 69 201; store p 70 203; store p 71 205; store p 72 207; store p 73 209; store p 74 211; store p 75 213; store p 76
215; store p 77 217; store p 78 219; store p 79 221; store p 80 223; store p 81 225; store p 82 227; store p 83 192;
store p 84 198; store p 85 229; store p 86 231; store p 87 233; store p 88 235; store p 89 196; store p 90 194;
store p 91 237; store p 92 195; store p 93 193; store p 94 238; store p 95 239; store p 96 240; store p 97 241;
store p 98 245; store p 99 246; store p 100 247; store p 101 248; store p 102 249; store p 103 252; store p 104 253;
store p 105 259; store p 106 255; store p 107 256; store p 108 261; store p 109 257; store p 110 254; store p 111
262; store p 112 263; store p 113 264; store p 114 265; store p 115 268; store p 116 269; store p 117 270; store p
118 271; store p 119 272; store p 120 21; store p 121 273; store p 122 274; store p 123 275; store p 124 277; store
p 125 278; store p 126 280; store p 127 281; store p 128 283; store p 129 284; store p 130 286; store p 131 287;
store p 132 288; store p 133 290; store p 134 291; store p 135 292; store p 136 293; store p 137 167; store p 138
294; store p 139 296; store p 140 298; store p 141 299; store p 142 178; store p 143 184; store p 144 300; store p
145 301; store p 146 303; store p 147 305; store p 148 307; store p 149 308; store p 150 309; store p 151 316; store
p 152 318; store p 153 323; store p 154 325; store p 155 330; store p 156 332; store p 157 337; store p 158 342;
store p 159 344; store p 160 170; store p 161 345; store p 162 297; store p 163 346; store p 164 348; store p 165
180; store p 166 349; store p 167 350; store p 168 304; store p 169 351; store p 170 353; store p 171 165; store p
172 295; store p 173 347; store p 174 355; store p 175 356; store p 176 357; store p 177 358; store p 178 359; store
p 179 360; store p 180 361; store p 181 362; store p 182 363; store p 183 364; store p 184 365; store p 185 366;
store p 186 367; store p 187 368
    """,
)

RATES = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'start': 2, 'p': 188},
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
270; input p 52; constant -0.35; max 273 148; min 270 274; mul 275 275; mul 272 276; input p 53; constant 0.6;
constant -0.6; max 280 3; min 279 281; mul 275 282; mul 278 283; add 277 284; input p 54; constant 2.0; constant
-2.0; max 288 35; min 287 289; mul 275 290; mul 286 291; add 285 292; input p 55; mul 282 282; mul 294 295; add 293
296; input p 56; mul 282 290; mul 298 299; add 297 300; input p 57; mul 290 290; mul 302 303; add 301 304; mul 290
303; mul 305 306; input p 58; mul 275 276; mul 308 309; input p 59; mul 276 282; mul 311 312; add 310 313; input p
60; mul 276 290; mul 315 316; add 314 317; input p 61; mul 282 283; mul 319 320; add 318 321; input p 62; mul 283
290; mul 323 324; add 322 325; input p 63; mul 290 291; mul 327 328; add 326 329; input p 64; mul 282 295; mul 331
332; add 330 333; input p 65; mul 290 295; mul 335 336; add 334 337; input p 66; mul 290 299; mul 339 340; add 338
341; input p 67; mul 306 343; add 342 344; add 307 345; mul 145 346; where 271 347; add 268 348; input p 68; mul 67
350; input p 69; mul 162 352; input p 70; mul 174 354; add 353 355; input p 71; mul 185 357; add 356 358; input p
72; mul 193 360; add 359 361; input p 73; mul 197 363; add 362 364; input p 74; mul 202 366; add 365 367; input p
75; mul 206 369; add 368 370; input p 76; mul 218 372; input p 77; mul 162 374; add 373 375; input p 78; mul 170
377; add 376 378; input p 79; mul 174 380; add 379 381; mul 185 352; add 382 383; input p 80; mul 197 385; add 384
386; input p 81; mul 258 388; add 387 389; mul 202 363; add 390 391; input p 82; mul 206 393; add 392 394; mul 147
395; add 371 396; mul 350 397; add 351 398; input p 83; input p 84; mul 29 67; mul 3 37; add 402 403; mul 35 53; add
404 405; mul 104 406; constant 0.25; mul 148 371; mul 155 395; add 409 410; input p 85; mul 218 412; input p 86; mul
162 414; add 413 415; mul 170 374; add 416 417; input p 87; mul 174 419; add 418 420; input p 88; mul 193 422; add
421 423; mul 258 357; add 424 425; mul 202 388; add 426 427; mul 35 428; add 411 429; mul 408 430; mul 350 431; add
407 432; add 401 433; input p 89; mul 24 435; add 434 436; input p 90; mul 38 438; sub 437 439; input p 91; mul 24
438; input p 92; sub 442 443; mul 38 435; add 444 445; sub 446 29; mul 447 447; mul 440 440; add 448 449; sqrt 450;
mul 441 451; sqrt 452; div 2 453; mul 454 454; mul 441 455; mul 440 456; input p 93; mul 287 452; mul 287 455; mul
455 460; sub 459 461; mul 458 462; constant 0.3; constant -0.3; constant 1.4; sub 452 466; max 465 467; min 464 468;
input p 94; input p 95; mul 469 471; add 470 472; mul 469 473; add 2 474; mul 463 475; input p 96; mul 93 477; input
p 97; input p 98; mul 467 480; add 479 481; mul 467 482; add 2 483; mul 478 484; sub 476 485; mul 441 486; input p
99; input x 6; mul 488 489; input p 100; input x 8; mul 491 492; add 490 493; input p 101; input x 10; mul 495 496;
add 494 497; constant -0.5; mul 454 499; mul 454 500; mul 454 501; mul 441 502; input p 102; input p 103; mul 467
505; add 504 506; mul 467 507; add 2 508; mul 503 509; mul 498 510; add 487 511; input p 104; mul 510 513; mul 510
514; sub 436 439; mul 447 516; add 442 445; mul 440 518; sub 517 519; mul 456 520; mul 17 521; mul 130 522; mul 447
456; mul 0 524; sub 523 525; mul 0 144; mul 399 527; mul 150 395; mul 350 529; add 37 530; mul 130 531; add 528 532;
mul 153 395; add 428 534; mul 350 535; add 53 536; input x 5; mul 537 538; add 533 539; mul 457 540; add 526 541;
mul 515 542; add 512 543; mul 457 544; input p 105; add 433 546; input p 106; mul 24 548; add 547 549; input p 107;
mul 38 551; add 550 552; input p 108; mul 38 548; mul 24 551; input p 109; sub 556 557; sub 555 558; sub 559 29; mul
560 560; mul 553 553; add 561 562; sqrt 563; mul 554 564; sqrt 565; div 2 566; mul 567 567; mul 554 568; mul 553
569; input p 110; mul 287 565; mul 287 568; mul 568 573; sub 572 574; mul 571 575; sub 565 466; max 465 577; min 464
578; input p 111; input p 112; mul 579 581; add 580 582; mul 579 583; add 2 584; mul 576 585; input p 113; mul 97
587; input p 114; input p 115; mul 577 590; add 589 591; mul 577 592; add 2 593; mul 588 594; sub 586 595; mul 554
596; input p 116; input x 7; mul 598 599; input p 117; input x 9; mul 601 602; add 600 603; input p 118; input x 11;
mul 605 606; add 604 607; mul 499 567; mul 567 609; mul 567 610; mul 554 611; mul 505 577; add 504 613; mul 577 614;
add 2 615; mul 612 616; mul 608 617; add 597 618; input p 119; mul 617 620; mul 617 621; add 549 552; mul 560 623;
sub 556 555; mul 553 625; add 624 626; mul 569 627; mul 17 628; mul 130 629; mul 560 569; mul 0 631; sub 630 632;
mul 540 570; add 633 634; mul 622 635; add 619 636; mul 570 637; add 545 638; sub 400 639; mul 399 640; sub 349 641;
input p 120; constant 12.0; mul 527 644; constant -6.0; mul 147 527; mul 130 150; add 647 648; mul 153 538; add 649
650; mul 646 651; add 645 652; mul 643 653; mul 527 646; constant 4.0; mul 651 656; add 655 657; mul 643 658; mul
147 659; add 654 660; add 642 661; mul 144 662; mul 524 544; mul 631 637; add 664 665; sub 663 666; sub 143 667;
input p 121; input p 122; constant -1.0; input z 0; input start 0; sub 29 673; input p 123; input start 1; sub 3
676; mul 675 677; add 674 678; input p 124; mul 679 680; add 672 681; max 671 682; min 2 683; mul 670 684; input p
125; input z 1; input p 126; mul 679 688; add 687 689; max 671 690; min 2 691; mul 686 692; add 685 693; input p
127; input z 2; input p 128; mul 679 697; add 696 698; max 671 699; min 2 700; mul 695 701; add 694 702; input p
129; input z 3; input p 130; mul 679 706; add 705 707; max 671 708; min 2 709; mul 704 710; add 703 711; sub 669
712; input p 131; abs 0; mul 714 715; mul 0 716; input p 132; mul 0 718; mul 0 0; input p 133; add 720 721; sqrt
722; div 2 723; mul 719 724; add 717 725; sub 713 726; add 668 727; input p 134; input x 12; sub 29 730; mul 729
731; input p 135; input x 13; sub 29 734; mul 733 735; add 732 736; sub 728 737; mul 0 62; mul 28 130; add 739 740;
mul 47 538; add 741 742; mul 0 743; mul 0 28; mul 31 130; add 745 746; mul 34 538; add 747 748; mul 130 749; add 744
750; mul 0 47; mul 34 130; add 752 753; mul 51 538; add 754 755; mul 538 756; add 751 757; mul 17 130; mul 130 759;
mul 23 760; input p 136; mul 9 762; mul 9 763; mul 8 16; mul 10 765; mul 765 766; add 764 767; mul 3 768; mul 38
769; sub 25 770; mul 761 771; add 758 772; mul 67 773; mul 24 769; add 39 775; mul 761 776; sub 774 777; mul 22 778;
sub 738 779; mul 90 780; mul 81 89; mul 150 265; mul 145 783; abs 3; lt 785 279; input p 137; mul 276 787; input p
138; mul 283 789; add 788 790; mul 291 298; add 791 792; input p 139; mul 295 794; add 793 795; input p 140; mul 299
797; add 796 798; input p 141; mul 303 800; add 799 801; mul 306 802; input p 142; mul 309 804; mul 312 319; add 805
806; input p 143; mul 316 808; add 807 809; input p 144; mul 320 811; add 810 812; input p 145; mul 324 814; add 813
815; mul 328 339; add 816 817; input p 146; mul 332 819; add 818 820; input p 147; mul 336 822; add 821 823; input p
148; mul 340 825; add 824 826; input p 149; mul 306 828; add 827 829; add 803 830; mul 145 831; where 786 832; add
784 833; mul 531 640; sub 834 835; mul 150 659; add 836 837; mul 522 544; mul 629 637; add 839 840; add 838 841; sub
134 842; input p 150; mul 38 844; mul 17 845; add 843 846; mul 675 712; sub 847 848; mul 41 773; mul 26 777; sub 850
851; mul 22 852; mul 19 769; mul 760 854; sub 853 855; sub 849 856; mul 782 857; sub 781 858; mul 86 89; input p
151; mul 35 861; input p 152; mul 214 863; add 862 864; input p 153; mul 218 866; add 865 867; mul 155 210; add 868
869; input p 154; mul 158 871; add 870 872; input p 155; mul 162 874; add 873 875; input p 156; mul 166 877; add 876
878; mul 170 227; add 879 880; input p 157; mul 174 882; add 881 883; mul 157 189; add 884 885; input p 158; mul 193
887; add 886 888; mul 169 197; add 889 890; input p 159; mul 201 892; add 891 893; mul 184 258; add 894 895; mul 202
257; add 896 897; mul 153 265; add 898 899; mul 145 900; abs 35; lt 902 287; input p 160; mul 276 904; mul 283 298;
add 905 906; input p 161; mul 291 908; add 907 909; input p 162; mul 295 911; add 910 912; input p 163; mul 299 914;
add 913 915; input p 164; mul 303 917; add 916 918; mul 306 919; input p 165; mul 309 921; mul 312 808; add 922 923;
mul 316 327; add 924 925; mul 320 335; add 926 927; input p 166; mul 324 929; add 928 930; input p 167; mul 328 932;
add 931 933; input p 168; mul 332 935; add 934 936; mul 336 825; add 937 938; input p 169; mul 340 940; add 939 941;
input p 170; mul 306 943; add 942 944; add 920 945; constant 3.0; mul 303 947; input p 171; mul 309 949; mul 312
787; add 950 951; mul 316 904; add 952 953; mul 294 320; add 954 955; mul 298 324; add 956 957; mul 302 328; add 958
959; input p 172; mul 332 961; add 960 962; mul 336 911; add 963 964; mul 340 800; add 965 966; input p 173; mul 306
968; add 967 969; mul 948 970; add 946 971; mul 145 972; where 903 973; add 901 974; mul 537 640; sub 975 976; input
p 174; mul 538 978; mul 153 659; add 979 980; add 977 981; mul 53 773; mul 22 983; add 982 984; mul 860 985; sub 859
986; mul 56 70; mul 79 79; sub 988 989; mul 89 990; mul 857 991; mul 780 782; sub 992 993; mul 59 70; mul 76 79; sub
995 996; mul 89 997; mul 985 998; add 994 999; mul 780 860; mul 857 998; sub 1001 1002; mul 45 70; mul 76 76; sub
1004 1005; mul 89 1006; mul 985 1007; sub 1003 1008; mul 510 542; input p 175; mul 489 1011; sub 1010 1012; mul 617
635; mul 599 1011; sub 1014 1015; input p 176; mul 492 1017; sub 1010 1018; mul 602 1017; sub 1014 1020; input p
177; mul 496 1022; sub 1010 1023; mul 606 1022; sub 1014 1025; input p 178; mul 731 1027; input p 179; mul 735 1029;
store rates 0 0; store rates 1 987; store rates 2 130; store rates 3 1000; store rates 4 538; store rates 5 1009;
store rates 6 1013; store rates 7 1016; store rates 8 1019; store rates 9 1021; store rates 10 1024; store rates 11
1026; store rates 12 1028; store rates 13 1030
    """,
)

SHAPE = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'p': 188},
    {'forces': 3, 'by_shape': 6},
    """
input p 121; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
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
167 168; input p 52; constant -0.35; max 171 45; min 168 172; mul 173 173; mul 170 174; input p 53; constant 0.6;
constant -0.6; max 178 10; min 177 179; mul 173 180; mul 176 181; add 175 182; input p 54; constant 2.0; constant
-2.0; max 186 50; min 185 187; mul 173 188; mul 184 189; add 183 190; input p 55; mul 180 180; mul 192 193; add 191
194; input p 56; mul 180 188; mul 196 197; add 195 198; input p 57; mul 188 188; mul 200 201; add 199 202; mul 188
201; mul 203 204; input p 58; mul 173 174; mul 206 207; input p 59; mul 174 180; mul 209 210; add 208 211; input p
60; mul 174 188; mul 213 214; add 212 215; input p 61; mul 180 181; mul 217 218; add 216 219; input p 62; mul 181
188; mul 221 222; add 220 223; input p 63; mul 188 189; mul 225 226; add 224 227; input p 64; mul 180 193; mul 229
230; add 228 231; input p 65; mul 188 193; mul 233 234; add 232 235; input p 66; mul 188 197; mul 237 238; add 236
239; input p 67; mul 204 241; add 240 242; add 205 243; mul 42 244; where 169 245; add 166 246; input p 12; mul 11
248; input p 6; mul 10 250; add 249 251; input p 10; mul 50 253; add 252 254; input p 68; mul 255 256; input p 69;
mul 60 258; input p 70; mul 72 260; add 259 261; input p 71; mul 83 263; add 262 264; input p 72; mul 91 266; add
265 267; input p 73; mul 95 269; add 268 270; input p 74; mul 100 272; add 271 273; input p 75; mul 104 275; add 274
276; input p 76; mul 116 278; input p 77; mul 60 280; add 279 281; input p 78; mul 68 283; add 282 284; input p 79;
mul 72 286; add 285 287; mul 83 258; add 288 289; input p 80; mul 95 291; add 290 292; input p 81; mul 156 294; add
293 295; mul 100 269; add 296 297; input p 82; mul 104 299; add 298 300; mul 44 301; add 277 302; mul 256 303; add
257 304; input p 83; input p 91; input p 93; constant 1.0; input p 1; mul 10 310; mul 10 311; add 309 312; sqrt 313;
div 309 314; input p 2; mul 10 316; mul 10 317; add 309 318; sqrt 319; mul 315 320; input p 90; mul 321 322; input p
92; sub 323 324; mul 10 315; input p 89; mul 326 327; add 325 328; sub 329 11; mul 330 330; input p 84; mul 11 255;
mul 11 250; input p 7; mul 10 335; add 334 336; input p 8; mul 50 338; add 337 339; mul 10 340; add 333 341; mul 11
253; mul 10 338; add 343 344; input p 11; mul 50 346; add 345 347; mul 50 348; add 342 349; mul 16 350; constant
0.25; mul 45 277; mul 53 301; add 353 354; input p 85; mul 116 356; input p 86; mul 60 358; add 357 359; mul 68 280;
add 360 361; input p 87; mul 72 363; add 362 364; input p 88; mul 91 366; add 365 367; mul 156 263; add 368 369; mul
100 294; add 370 371; mul 50 372; add 355 373; mul 352 374; mul 256 375; add 351 376; add 332 377; mul 321 327; add
378 379; mul 322 326; sub 380 381; mul 382 382; add 331 383; sqrt 384; mul 307 385; mul 185 386; sqrt 386; div 309
388; mul 389 389; mul 185 390; mul 390 391; sub 387 392; mul 308 393; constant 0.3; constant -0.3; constant 1.4; sub
386 397; max 396 398; min 395 399; input p 94; input p 95; mul 400 402; add 401 403; mul 400 404; add 309 405; mul
394 406; input p 96; mul 3 408; input p 97; input p 98; mul 398 411; add 410 412; mul 398 413; add 309 414; mul 409
415; sub 407 416; mul 307 417; mul 307 390; mul 382 419; mul 418 420; input p 108; input p 110; input p 106; mul 326
424; input p 107; mul 321 426; input p 109; sub 427 428; sub 425 429; sub 430 11; mul 431 431; input p 105; add 377
433; mul 321 424; add 434 435; mul 326 426; add 436 437; mul 438 438; add 432 439; sqrt 440; mul 422 441; mul 185
442; sqrt 442; div 309 444; mul 445 445; mul 185 446; mul 446 447; sub 443 448; mul 423 449; sub 442 397; max 396
451; min 395 452; input p 111; input p 112; mul 453 455; add 454 456; mul 453 457; add 309 458; mul 450 459; input p
113; mul 7 461; input p 114; input p 115; mul 451 464; add 463 465; mul 451 466; add 309 467; mul 462 468; sub 460
469; mul 422 470; mul 422 446; mul 438 472; mul 471 473; add 421 474; sub 306 475; mul 305 476; sub 247 477; mul 41
478; mul 330 419; mul 418 480; mul 431 472; mul 471 482; add 481 483; sub 479 484; sub 40 485; add 0 486; mul 314
320; div 309 488; mul 315 489; input p 150; mul 326 491; mul 490 492; mul 47 163; mul 42 494; abs 10; lt 496 177;
input p 137; mul 174 498; input p 138; mul 181 500; add 499 501; mul 189 196; add 502 503; input p 139; mul 193 505;
add 504 506; input p 140; mul 197 508; add 507 509; input p 141; mul 201 511; add 510 512; mul 204 513; input p 142;
mul 207 515; mul 210 217; add 516 517; input p 143; mul 214 519; add 518 520; input p 144; mul 218 522; add 521 523;
input p 145; mul 222 525; add 524 526; mul 226 237; add 527 528; input p 146; mul 230 530; add 529 531; input p 147;
mul 234 533; add 532 534; input p 148; mul 238 536; add 535 537; input p 149; mul 204 539; add 538 540; add 514 541;
mul 42 542; where 497 543; add 495 544; mul 47 301; mul 256 546; add 340 547; mul 476 548; sub 545 549; sub 379 381;
mul 330 551; add 323 328; mul 382 553; sub 552 554; mul 419 555; mul 490 556; mul 418 557; add 435 437; mul 431 559;
sub 427 425; mul 438 561; add 560 562; mul 472 563; mul 490 564; mul 471 565; add 558 566; add 550 567; sub 38 568;
add 493 569; input p 151; mul 50 571; input p 152; mul 112 573; add 572 574; input p 153; mul 116 576; add 575 577;
mul 53 108; add 578 579; input p 154; mul 56 581; add 580 582; input p 155; mul 60 584; add 583 585; input p 156;
mul 64 587; add 586 588; mul 68 125; add 589 590; input p 157; mul 72 592; add 591 593; mul 55 87; add 594 595;
input p 158; mul 91 597; add 596 598; mul 67 95; add 599 600; input p 159; mul 99 602; add 601 603; mul 82 156; add
604 605; mul 100 155; add 606 607; mul 51 163; add 608 609; mul 42 610; abs 50; lt 612 185; input p 160; mul 174
614; mul 181 196; add 615 616; input p 161; mul 189 618; add 617 619; input p 162; mul 193 621; add 620 622; input p
163; mul 197 624; add 623 625; input p 164; mul 201 627; add 626 628; mul 204 629; input p 165; mul 207 631; mul 210
519; add 632 633; mul 214 225; add 634 635; mul 218 233; add 636 637; input p 166; mul 222 639; add 638 640; input p
167; mul 226 642; add 641 643; input p 168; mul 230 645; add 644 646; mul 234 536; add 647 648; input p 169; mul 238
650; add 649 651; input p 170; mul 204 653; add 652 654; add 630 655; constant 3.0; mul 201 657; input p 171; mul
207 659; mul 210 498; add 660 661; mul 214 614; add 662 663; mul 192 218; add 664 665; mul 196 222; add 666 667; mul
200 226; add 668 669; input p 172; mul 230 671; add 670 672; mul 234 621; add 673 674; mul 238 511; add 675 676;
input p 173; mul 204 678; add 677 679; mul 658 680; add 656 681; mul 42 682; where 613 683; add 611 684; mul 51 301;
add 372 686; mul 256 687; add 348 688; mul 476 689; sub 685 690; neg 691; sub 26 19; mul 12 30; add 693 694; input p
180; mul 47 50; mul 55 697; add 696 698; mul 50 697; mul 59 700; add 699 701; mul 53 185; mul 47 703; mul 63 704;
add 702 705; mul 50 704; mul 67 707; add 706 708; mul 53 704; mul 47 64; add 710 711; mul 71 712; add 709 713; mul
45 47; mul 86 715; add 714 716; mul 50 715; mul 90 718; add 717 719; mul 53 715; mul 47 87; add 721 722; mul 94 723;
add 720 724; mul 47 99; mul 98 726; add 725 727; input p 181; mul 122 697; add 729 730; mul 125 700; add 731 732;
mul 128 704; add 733 734; mul 131 707; add 735 736; mul 134 712; add 737 738; mul 143 715; add 739 740; mul 146 718;
add 741 742; mul 149 723; add 743 744; mul 94 726; add 745 746; mul 44 747; add 728 748; mul 42 749; le 179 177; le
177 179; add 751 752; div 309 753; mul 751 754; le 178 10; le 10 178; add 756 757; div 309 758; mul 756 759; mul 755
760; mul 173 761; mul 176 762; mul 180 185; mul 761 764; mul 192 765; add 763 766; mul 188 761; mul 196 768; add 767
769; mul 204 770; mul 174 761; mul 209 772; mul 180 762; mul 181 761; add 774 775; mul 217 776; add 773 777; mul 188
762; mul 221 779; add 778 780; mul 180 765; mul 193 761; add 782 783; mul 229 784; add 781 785; mul 188 765; mul 233
787; add 786 788; mul 188 768; mul 237 790; add 789 791; add 771 792; mul 42 793; where 169 794; add 750 795; input
p 182; mul 258 700; mul 260 712; add 798 799; mul 266 718; add 800 801; mul 269 723; add 802 803; mul 272 726; add
804 805; mul 280 700; mul 283 707; add 807 808; mul 286 712; add 809 810; mul 291 723; add 811 812; mul 269 726; add
813 814; mul 44 815; add 806 816; mul 256 817; add 797 818; mul 476 819; mul 185 330; div 309 320; mul 317 822; mul
315 823; mul 315 321; mul 311 315; mul 825 826; sub 824 827; mul 322 828; mul 315 326; mul 826 830; sub 315 831; mul
327 832; add 829 833; mul 821 834; mul 185 382; add 336 340; add 334 837; add 339 838; mul 16 839; mul 45 806; mul
53 815; add 546 842; add 841 843; mul 358 700; mul 280 707; add 845 846; mul 363 712; add 847 848; mul 366 718; add
849 850; mul 294 726; add 851 852; mul 50 853; add 844 854; mul 352 855; mul 256 856; add 840 857; mul 327 828; add
858 859; mul 322 832; sub 860 861; mul 836 862; add 835 863; mul 185 385; div 309 865; mul 864 866; mul 307 867; mul
185 868; mul 185 389; mul 185 388; div 309 871; mul 868 872; mul 390 873; mul 870 874; neg 875; mul 185 876; mul 390
877; mul 391 875; sub 878 879; sub 869 880; mul 308 881; mul 406 882; le 399 395; le 395 399; add 884 885; div 309
886; mul 884 887; le 396 398; le 398 396; add 889 890; div 309 891; mul 889 892; mul 868 893; mul 888 894; mul 402
895; mul 400 896; mul 404 895; add 897 898; mul 394 899; add 883 900; mul 411 868; mul 398 902; mul 413 868; add 903
904; mul 409 905; sub 901 906; mul 307 907; mul 420 908; mul 419 862; mul 307 875; mul 382 911; sub 910 912; mul 418
913; add 909 914; mul 185 431; mul 424 832; mul 426 828; sub 917 918; mul 916 919; mul 185 438; mul 424 828; add 858
922; mul 426 832; add 923 924; mul 921 925; add 920 926; mul 185 441; div 309 928; mul 927 929; mul 422 930; mul 185
931; mul 185 445; mul 185 444; div 309 934; mul 931 935; mul 446 936; mul 933 937; neg 938; mul 185 939; mul 446
940; mul 447 938; sub 941 942; sub 932 943; mul 423 944; mul 459 945; le 452 395; le 395 452; add 947 948; div 309
949; mul 947 950; le 396 451; le 451 396; add 952 953; div 309 954; mul 952 955; mul 931 956; mul 951 957; mul 455
958; mul 453 959; mul 457 958; add 960 961; mul 450 962; add 946 963; mul 464 931; mul 451 965; mul 466 931; add 966
967; mul 462 968; sub 964 969; mul 422 970; mul 473 971; mul 472 925; mul 422 938; mul 438 974; sub 973 975; mul 471
976; add 972 977; add 915 978; mul 305 979; sub 820 980; sub 796 981; mul 41 982; mul 480 908; mul 419 834; mul 330
911; sub 985 986; mul 418 987; add 984 988; mul 482 971; mul 472 919; mul 431 974; sub 991 992; mul 471 993; add 990
994; add 989 995; sub 983 996; sub 695 997; mul 491 832; mul 490 999; mul 315 315; mul 826 1001; mul 489 1002; mul
489 490; mul 320 826; mul 314 823; add 1005 1006; mul 1004 1007; add 1003 1008; mul 492 1009; sub 1000 1010; mul 47
747; mul 42 1012; mul 500 762; mul 505 765; add 1014 1015; mul 508 768; add 1016 1017; mul 204 1018; mul 217 772;
mul 522 776; add 1020 1021; mul 525 779; add 1022 1023; mul 530 784; add 1024 1025; mul 533 787; add 1026 1027; mul
536 790; add 1028 1029; add 1019 1030; mul 42 1031; where 497 1032; add 1013 1033; mul 47 815; mul 256 1035; add 335
1036; mul 476 1037; mul 548 979; sub 1038 1039; sub 1034 1040; mul 557 908; mul 551 834; sub 859 861; mul 330 1044;
add 1043 1045; mul 553 862; mul 382 834; add 1047 1048; sub 1046 1049; mul 419 1050; mul 555 911; sub 1051 1052; mul
490 1053; mul 556 1009; sub 1054 1055; mul 418 1056; add 1042 1057; mul 565 971; mul 559 919; add 922 924; mul 431
1061; add 1060 1062; mul 561 925; sub 918 917; mul 438 1065; add 1064 1066; add 1063 1067; mul 472 1068; mul 563
974; sub 1069 1070; mul 490 1071; mul 564 1009; sub 1072 1073; mul 471 1074; add 1059 1075; add 1058 1076; add 1041
1077; add 30 1078; sub 1011 1079; input p 183; mul 581 697; add 1081 1082; mul 584 700; add 1083 1084; mul 587 704;
add 1085 1086; mul 125 707; add 1087 1088; mul 592 712; add 1089 1090; mul 55 715; add 1091 1092; mul 597 718; add
1093 1094; mul 67 723; add 1095 1096; mul 155 726; add 1097 1098; mul 51 747; add 1099 1100; mul 42 1101; mul 196
762; mul 621 765; add 1103 1104; mul 624 768; add 1105 1106; mul 204 1107; mul 519 772; mul 233 776; add 1109 1110;
mul 639 779; add 1111 1112; mul 645 784; add 1113 1114; mul 536 787; add 1115 1116; mul 650 790; add 1117 1118; add
1108 1119; mul 498 772; mul 192 776; add 1121 1122; mul 196 779; add 1123 1124; mul 671 784; add 1125 1126; mul 621
787; add 1127 1128; mul 511 790; add 1129 1130; mul 658 1131; add 1120 1132; mul 42 1133; where 613 1134; add 1102
1135; mul 51 815; add 853 1137; mul 256 1138; add 338 1139; mul 476 1140; mul 689 979; sub 1141 1142; sub 1136 1143;
neg 1144; input p 184; add 52 53; mul 55 1147; add 1146 1148; mul 50 1147; add 56 1150; mul 59 1151; add 1149 1152;
mul 51 703; mul 63 1154; add 1153 1155; mul 50 1154; add 64 1157; mul 67 1158; add 1156 1159; mul 53 1154; mul 51
64; add 1161 1162; mul 71 1163; add 1160 1164; mul 45 78; add 1165 1166; mul 79 185; mul 82 1168; add 1167 1169; mul
45 51; mul 86 1171; add 1170 1172; mul 50 1171; add 87 1174; mul 90 1175; add 1173 1176; mul 53 1171; mul 51 87; add
1178 1179; mul 94 1180; add 1177 1181; mul 51 99; mul 98 1183; add 1182 1184; mul 50 185; mul 111 1186; add 108
1187; mul 50 1186; add 112 1189; mul 115 1190; add 1188 1191; input p 185; add 1192 1193; mul 122 1147; add 1194
1195; mul 125 1151; add 1196 1197; mul 128 1154; add 1198 1199; mul 131 1158; add 1200 1201; mul 134 1163; add 1202
1203; mul 45 55; add 1204 1205; mul 59 1168; add 1206 1207; mul 143 1171; add 1208 1209; mul 146 1175; add 1210
1211; mul 149 1180; add 1212 1213; mul 99 155; add 1214 1215; mul 94 1183; add 1216 1217; mul 44 1218; add 1185
1219; mul 42 1220; le 187 185; le 185 187; add 1222 1223; div 309 1224; mul 1222 1225; le 186 50; le 50 186; add
1227 1228; div 309 1229; mul 1227 1230; mul 1226 1231; mul 173 1232; mul 184 1233; mul 180 1232; mul 196 1235; add
1234 1236; mul 185 188; mul 1232 1238; mul 200 1239; add 1237 1240; mul 204 1241; mul 188 1239; mul 201 1232; add
1243 1244; mul 203 1245; add 1242 1246; mul 174 1232; mul 213 1248; mul 181 1232; mul 221 1250; add 1249 1251; mul
188 1233; mul 189 1232; add 1253 1254; mul 225 1255; add 1252 1256; mul 193 1232; mul 233 1258; add 1257 1259; mul
188 1235; mul 197 1232; add 1261 1262; mul 237 1263; add 1260 1264; mul 241 1245; add 1265 1266; add 1247 1267; mul
42 1268; where 169 1269; add 1221 1270; input p 186; mul 258 1151; mul 260 1163; add 1273 1274; mul 263 1168; add
1275 1276; mul 266 1175; add 1277 1278; mul 269 1180; add 1279 1280; mul 272 1183; add 1281 1282; mul 278 1190; mul
280 1151; add 1284 1285; mul 283 1158; add 1286 1287; mul 286 1163; add 1288 1289; mul 258 1168; add 1290 1291; mul
291 1180; add 1292 1293; mul 99 294; add 1294 1295; mul 269 1183; add 1296 1297; mul 44 1298; add 1283 1299; mul 256
1300; add 1272 1301; mul 476 1302; add 347 348; add 345 1304; mul 16 1305; mul 45 1283; mul 53 1298; add 686 1308;
add 1307 1309; mul 356 1190; mul 358 1151; add 1311 1312; mul 280 1158; add 1313 1314; mul 363 1163; add 1315 1316;
mul 366 1175; add 1317 1318; mul 99 263; add 1319 1320; mul 294 1183; add 1321 1322; mul 50 1323; add 372 1324; add
1310 1325; mul 352 1326; mul 256 1327; add 1306 1328; mul 836 1329; mul 866 1330; mul 307 1331; mul 185 1332; mul
872 1332; mul 390 1334; mul 870 1335; neg 1336; mul 185 1337; mul 390 1338; mul 391 1336; sub 1339 1340; sub 1333
1341; mul 308 1342; mul 406 1343; mul 893 1332; mul 888 1345; mul 402 1346; mul 400 1347; mul 404 1346; add 1348
1349; mul 394 1350; add 1344 1351; mul 411 1332; mul 398 1353; mul 413 1332; add 1354 1355; mul 409 1356; sub 1352
1357; mul 307 1358; mul 420 1359; mul 419 1329; mul 307 1336; mul 382 1362; sub 1361 1363; mul 418 1364; add 1360
1365; mul 921 1329; mul 929 1367; mul 422 1368; mul 185 1369; mul 935 1369; mul 446 1371; mul 933 1372; neg 1373;
mul 185 1374; mul 446 1375; mul 447 1373; sub 1376 1377; sub 1370 1378; mul 423 1379; mul 459 1380; mul 956 1369;
mul 951 1382; mul 455 1383; mul 453 1384; mul 457 1383; add 1385 1386; mul 450 1387; add 1381 1388; mul 464 1369;
mul 451 1390; mul 466 1369; add 1391 1392; mul 462 1393; sub 1389 1394; mul 422 1395; mul 473 1396; mul 472 1329;
mul 422 1373; mul 438 1399; sub 1398 1400; mul 471 1401; add 1397 1402; add 1366 1403; mul 305 1404; sub 1303 1405;
sub 1271 1406; mul 41 1407; mul 480 1359; mul 330 1362; mul 418 1410; sub 1409 1411; mul 482 1396; mul 431 1399; mul
471 1414; sub 1413 1415; add 1412 1416; sub 1408 1417; neg 1418; mul 47 1218; mul 42 1420; mul 196 1233; mul 508
1235; add 1422 1423; mul 511 1239; add 1424 1425; mul 204 1426; mul 513 1245; add 1427 1428; mul 519 1248; mul 525
1250; add 1430 1431; mul 237 1255; add 1432 1433; mul 533 1258; add 1434 1435; mul 536 1263; add 1436 1437; mul 539
1245; add 1438 1439; add 1429 1440; mul 42 1441; where 497 1442; add 1421 1443; mul 47 1298; mul 256 1445; add 338
1446; mul 476 1447; mul 548 1404; sub 1448 1449; sub 1444 1450; mul 557 1359; mul 553 1329; mul 419 1453; mul 555
1362; add 1454 1455; mul 490 1456; mul 418 1457; sub 1452 1458; mul 565 1396; mul 561 1329; mul 472 1461; mul 563
1399; sub 1462 1463; mul 490 1464; mul 471 1465; add 1460 1466; add 1459 1467; add 1451 1468; neg 1469; mul 573
1186; add 571 1471; mul 576 1190; add 1472 1473; input p 187; add 1474 1475; mul 581 1147; add 1476 1477; mul 584
1151; add 1478 1479; mul 587 1154; add 1480 1481; mul 125 1158; add 1482 1483; mul 592 1163; add 1484 1485; mul 55
1171; add 1486 1487; mul 597 1175; add 1488 1489; mul 67 1180; add 1490 1491; mul 82 99; add 1492 1493; mul 155
1183; add 1494 1495; mul 51 1218; add 1496 1497; mul 42 1498; mul 618 1233; mul 624 1235; add 1500 1501; mul 627
1239; add 1502 1503; mul 204 1504; mul 629 1245; add 1505 1506; mul 225 1248; mul 639 1250; add 1508 1509; mul 642
1255; add 1510 1511; mul 536 1258; add 1512 1513; mul 650 1263; add 1514 1515; mul 653 1245; add 1516 1517; add 1507
1518; mul 657 1239; mul 680 1520; mul 614 1248; mul 196 1250; add 1522 1523; mul 200 1255; add 1524 1525; mul 621
1258; add 1526 1527; mul 511 1263; add 1528 1529; mul 678 1245; add 1530 1531; mul 658 1532; add 1521 1533; add 1519
1534; mul 42 1535; where 613 1536; add 1499 1537; mul 51 1298; add 1323 1539; mul 256 1540; add 346 1541; mul 476
1542; mul 689 1404; sub 1543 1544; sub 1538 1545; neg 1546; store forces 0 487; store forces 1 570; store forces 2
692; store by_shape 0 998; store by_shape 2 1080; store by_shape 4 1145; store by_shape 1 1419; store by_shape 3
1470; store by_shape 5 1547
    """,
)

INERTIA = Graph(
    {'x': 14, 'p': 188},
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
    {'x': 14, 'z': 4, 'start': 2, 'p': 188},
    {'moved': 4},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 123; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 124; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 126; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 128; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
130; mul 11 30; add 29 31; max 1 32; min 0 33; store moved 0 16; store moved 1 22; store moved 2 28; store moved 3
34
    """,
)
