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
constant -0.6; max 280 3; min 279 281; mul 275 282; mul 278 283; add 277 284; input p 54; constant 1.6; constant
-1.6; max 288 35; min 287 289; mul 275 290; mul 286 291; add 285 292; input p 55; mul 282 282; mul 294 295; add 293
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
mul 441 451; sqrt 452; div 2 453; mul 454 454; mul 441 455; mul 440 456; input p 93; constant 2.0; mul 452 459; mul
455 459; mul 455 461; sub 460 462; mul 458 463; constant 0.3; constant -0.3; constant 1.4; sub 452 467; max 466 468;
min 465 469; input p 94; input p 95; mul 470 472; add 471 473; mul 470 474; add 2 475; mul 464 476; input p 96; mul
93 478; input p 97; input p 98; mul 468 481; add 480 482; mul 468 483; add 2 484; mul 479 485; sub 477 486; mul 441
487; input p 99; input x 6; mul 489 490; input p 100; input x 8; mul 492 493; add 491 494; input p 101; input x 10;
mul 496 497; add 495 498; constant -0.5; mul 454 500; mul 454 501; mul 454 502; mul 441 503; input p 102; input p
103; mul 468 506; add 505 507; mul 468 508; add 2 509; mul 504 510; mul 499 511; add 488 512; input p 104; mul 511
514; mul 511 515; sub 436 439; mul 447 517; add 442 445; mul 440 519; sub 518 520; mul 456 521; mul 17 522; mul 130
523; mul 447 456; mul 0 525; sub 524 526; mul 0 144; mul 399 528; mul 150 395; mul 350 530; add 37 531; mul 130 532;
add 529 533; mul 153 395; add 428 535; mul 350 536; add 53 537; input x 5; mul 538 539; add 534 540; mul 457 541;
add 527 542; mul 516 543; add 513 544; mul 457 545; input p 105; add 433 547; input p 106; mul 24 549; add 548 550;
input p 107; mul 38 552; add 551 553; input p 108; mul 38 549; mul 24 552; input p 109; sub 557 558; sub 556 559;
sub 560 29; mul 561 561; mul 554 554; add 562 563; sqrt 564; mul 555 565; sqrt 566; div 2 567; mul 568 568; mul 555
569; mul 554 570; input p 110; mul 459 566; mul 459 569; mul 569 574; sub 573 575; mul 572 576; sub 566 467; max 466
578; min 465 579; input p 111; input p 112; mul 580 582; add 581 583; mul 580 584; add 2 585; mul 577 586; input p
113; mul 97 588; input p 114; input p 115; mul 578 591; add 590 592; mul 578 593; add 2 594; mul 589 595; sub 587
596; mul 555 597; input p 116; input x 7; mul 599 600; input p 117; input x 9; mul 602 603; add 601 604; input p
118; input x 11; mul 606 607; add 605 608; mul 500 568; mul 568 610; mul 568 611; mul 555 612; mul 506 578; add 505
614; mul 578 615; add 2 616; mul 613 617; mul 609 618; add 598 619; input p 119; mul 618 621; mul 618 622; add 550
553; mul 561 624; sub 557 556; mul 554 626; add 625 627; mul 570 628; mul 17 629; mul 130 630; mul 561 570; mul 0
632; sub 631 633; mul 541 571; add 634 635; mul 623 636; add 620 637; mul 571 638; add 546 639; sub 400 640; mul 399
641; sub 349 642; input p 120; constant 12.0; mul 528 645; constant -6.0; mul 147 528; mul 130 150; add 648 649; mul
153 539; add 650 651; mul 647 652; add 646 653; mul 644 654; mul 528 647; constant 4.0; mul 652 657; add 656 658;
mul 644 659; mul 147 660; add 655 661; add 643 662; mul 144 663; mul 525 545; mul 632 638; add 665 666; sub 664 667;
sub 143 668; input p 121; input p 122; constant -1.0; input z 0; input start 0; sub 29 674; input p 123; input start
1; sub 3 677; mul 676 678; add 675 679; input p 124; mul 680 681; add 673 682; max 672 683; min 2 684; mul 671 685;
input p 125; input z 1; input p 126; mul 680 689; add 688 690; max 672 691; min 2 692; mul 687 693; add 686 694;
input p 127; input z 2; input p 128; mul 680 698; add 697 699; max 672 700; min 2 701; mul 696 702; add 695 703;
input p 129; input z 3; input p 130; mul 680 707; add 706 708; max 672 709; min 2 710; mul 705 711; add 704 712; sub
670 713; input p 131; abs 0; mul 715 716; mul 0 717; input p 132; mul 0 719; mul 0 0; input p 133; add 721 722; sqrt
723; div 2 724; mul 720 725; add 718 726; sub 714 727; add 669 728; input p 134; input x 12; sub 29 731; mul 730
732; input p 135; input x 13; sub 29 735; mul 734 736; add 733 737; sub 729 738; mul 0 62; mul 28 130; add 740 741;
mul 47 539; add 742 743; mul 0 744; mul 0 28; mul 31 130; add 746 747; mul 34 539; add 748 749; mul 130 750; add 745
751; mul 0 47; mul 34 130; add 753 754; mul 51 539; add 755 756; mul 539 757; add 752 758; mul 17 130; mul 130 760;
mul 23 761; input p 136; mul 9 763; mul 9 764; mul 8 16; mul 10 766; mul 766 767; add 765 768; mul 3 769; mul 38
770; sub 25 771; mul 762 772; add 759 773; mul 67 774; mul 24 770; add 39 776; mul 762 777; sub 775 778; mul 22 779;
sub 739 780; mul 90 781; mul 81 89; mul 150 265; mul 145 784; abs 3; lt 786 279; input p 137; mul 276 788; input p
138; mul 283 790; add 789 791; mul 291 298; add 792 793; input p 139; mul 295 795; add 794 796; input p 140; mul 299
798; add 797 799; input p 141; mul 303 801; add 800 802; mul 306 803; input p 142; mul 309 805; mul 312 319; add 806
807; input p 143; mul 316 809; add 808 810; input p 144; mul 320 812; add 811 813; input p 145; mul 324 815; add 814
816; mul 328 339; add 817 818; input p 146; mul 332 820; add 819 821; input p 147; mul 336 823; add 822 824; input p
148; mul 340 826; add 825 827; input p 149; mul 306 829; add 828 830; add 804 831; mul 145 832; where 787 833; add
785 834; mul 532 641; sub 835 836; mul 150 660; add 837 838; mul 523 545; mul 630 638; add 840 841; add 839 842; sub
134 843; input p 150; mul 38 845; mul 17 846; add 844 847; mul 676 713; sub 848 849; mul 41 774; mul 26 778; sub 851
852; mul 22 853; mul 19 770; mul 761 855; sub 854 856; sub 850 857; mul 783 858; sub 782 859; mul 86 89; input p
151; mul 35 862; input p 152; mul 214 864; add 863 865; input p 153; mul 218 867; add 866 868; mul 155 210; add 869
870; input p 154; mul 158 872; add 871 873; input p 155; mul 162 875; add 874 876; input p 156; mul 166 878; add 877
879; mul 170 227; add 880 881; input p 157; mul 174 883; add 882 884; mul 157 189; add 885 886; input p 158; mul 193
888; add 887 889; mul 169 197; add 890 891; input p 159; mul 201 893; add 892 894; mul 184 258; add 895 896; mul 202
257; add 897 898; mul 153 265; add 899 900; mul 145 901; abs 35; lt 903 287; input p 160; mul 276 905; mul 283 298;
add 906 907; input p 161; mul 291 909; add 908 910; input p 162; mul 295 912; add 911 913; input p 163; mul 299 915;
add 914 916; input p 164; mul 303 918; add 917 919; mul 306 920; input p 165; mul 309 922; mul 312 809; add 923 924;
mul 316 327; add 925 926; mul 320 335; add 927 928; input p 166; mul 324 930; add 929 931; input p 167; mul 328 933;
add 932 934; input p 168; mul 332 936; add 935 937; mul 336 826; add 938 939; input p 169; mul 340 941; add 940 942;
input p 170; mul 306 944; add 943 945; add 921 946; constant 3.0; mul 303 948; input p 171; mul 309 950; mul 312
788; add 951 952; mul 316 905; add 953 954; mul 294 320; add 955 956; mul 298 324; add 957 958; mul 302 328; add 959
960; input p 172; mul 332 962; add 961 963; mul 336 912; add 964 965; mul 340 801; add 966 967; input p 173; mul 306
969; add 968 970; mul 949 971; add 947 972; mul 145 973; where 904 974; add 902 975; mul 538 641; sub 976 977; input
p 174; mul 539 979; mul 153 660; add 980 981; add 978 982; mul 53 774; mul 22 984; add 983 985; mul 861 986; sub 860
987; mul 56 70; mul 79 79; sub 989 990; mul 89 991; mul 858 992; mul 781 783; sub 993 994; mul 59 70; mul 76 79; sub
996 997; mul 89 998; mul 986 999; add 995 1000; mul 781 861; mul 858 999; sub 1002 1003; mul 45 70; mul 76 76; sub
1005 1006; mul 89 1007; mul 986 1008; sub 1004 1009; mul 511 543; input p 175; mul 490 1012; sub 1011 1013; mul 618
636; mul 600 1012; sub 1015 1016; input p 176; mul 493 1018; sub 1011 1019; mul 603 1018; sub 1015 1021; input p
177; mul 497 1023; sub 1011 1024; mul 607 1023; sub 1015 1026; input p 178; mul 732 1028; input p 179; mul 736 1030;
store rates 0 0; store rates 1 988; store rates 2 130; store rates 3 1001; store rates 4 539; store rates 5 1010;
store rates 6 1014; store rates 7 1017; store rates 8 1020; store rates 9 1022; store rates 10 1025; store rates 11
1027; store rates 12 1029; store rates 13 1031
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
constant -0.6; max 178 10; min 177 179; mul 173 180; mul 176 181; add 175 182; input p 54; constant 1.6; constant
-1.6; max 186 50; min 185 187; mul 173 188; mul 184 189; add 183 190; input p 55; mul 180 180; mul 192 193; add 191
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
257 304; input p 83; input p 91; input p 93; constant 2.0; constant 1.0; input p 1; mul 10 311; mul 10 312; add 310
313; sqrt 314; div 310 315; input p 2; mul 10 317; mul 10 318; add 310 319; sqrt 320; mul 316 321; input p 90; mul
322 323; input p 92; sub 324 325; mul 10 316; input p 89; mul 327 328; add 326 329; sub 330 11; mul 331 331; input p
84; mul 11 255; mul 11 250; input p 7; mul 10 336; add 335 337; input p 8; mul 50 339; add 338 340; mul 10 341; add
334 342; mul 11 253; mul 10 339; add 344 345; input p 11; mul 50 347; add 346 348; mul 50 349; add 343 350; mul 16
351; constant 0.25; mul 45 277; mul 53 301; add 354 355; input p 85; mul 116 357; input p 86; mul 60 359; add 358
360; mul 68 280; add 361 362; input p 87; mul 72 364; add 363 365; input p 88; mul 91 367; add 366 368; mul 156 263;
add 369 370; mul 100 294; add 371 372; mul 50 373; add 356 374; mul 353 375; mul 256 376; add 352 377; add 333 378;
mul 322 328; add 379 380; mul 323 327; sub 381 382; mul 383 383; add 332 384; sqrt 385; mul 307 386; mul 309 387;
sqrt 387; div 310 389; mul 390 390; mul 309 391; mul 391 392; sub 388 393; mul 308 394; constant 0.3; constant -0.3;
constant 1.4; sub 387 398; max 397 399; min 396 400; input p 94; input p 95; mul 401 403; add 402 404; mul 401 405;
add 310 406; mul 395 407; input p 96; mul 3 409; input p 97; input p 98; mul 399 412; add 411 413; mul 399 414; add
310 415; mul 410 416; sub 408 417; mul 307 418; mul 307 391; mul 383 420; mul 419 421; input p 108; input p 110;
input p 106; mul 327 425; input p 107; mul 322 427; input p 109; sub 428 429; sub 426 430; sub 431 11; mul 432 432;
input p 105; add 378 434; mul 322 425; add 435 436; mul 327 427; add 437 438; mul 439 439; add 433 440; sqrt 441;
mul 423 442; mul 309 443; sqrt 443; div 310 445; mul 446 446; mul 309 447; mul 447 448; sub 444 449; mul 424 450;
sub 443 398; max 397 452; min 396 453; input p 111; input p 112; mul 454 456; add 455 457; mul 454 458; add 310 459;
mul 451 460; input p 113; mul 7 462; input p 114; input p 115; mul 452 465; add 464 466; mul 452 467; add 310 468;
mul 463 469; sub 461 470; mul 423 471; mul 423 447; mul 439 473; mul 472 474; add 422 475; sub 306 476; mul 305 477;
sub 247 478; mul 41 479; mul 331 420; mul 419 481; mul 432 473; mul 472 483; add 482 484; sub 480 485; sub 40 486;
add 0 487; mul 315 321; div 310 489; mul 316 490; input p 150; mul 327 492; mul 491 493; mul 47 163; mul 42 495; abs
10; lt 497 177; input p 137; mul 174 499; input p 138; mul 181 501; add 500 502; mul 189 196; add 503 504; input p
139; mul 193 506; add 505 507; input p 140; mul 197 509; add 508 510; input p 141; mul 201 512; add 511 513; mul 204
514; input p 142; mul 207 516; mul 210 217; add 517 518; input p 143; mul 214 520; add 519 521; input p 144; mul 218
523; add 522 524; input p 145; mul 222 526; add 525 527; mul 226 237; add 528 529; input p 146; mul 230 531; add 530
532; input p 147; mul 234 534; add 533 535; input p 148; mul 238 537; add 536 538; input p 149; mul 204 540; add 539
541; add 515 542; mul 42 543; where 498 544; add 496 545; mul 47 301; mul 256 547; add 341 548; mul 477 549; sub 546
550; sub 380 382; mul 331 552; add 324 329; mul 383 554; sub 553 555; mul 420 556; mul 491 557; mul 419 558; add 436
438; mul 432 560; sub 428 426; mul 439 562; add 561 563; mul 473 564; mul 491 565; mul 472 566; add 559 567; add 551
568; sub 38 569; add 494 570; input p 151; mul 50 572; input p 152; mul 112 574; add 573 575; input p 153; mul 116
577; add 576 578; mul 53 108; add 579 580; input p 154; mul 56 582; add 581 583; input p 155; mul 60 585; add 584
586; input p 156; mul 64 588; add 587 589; mul 68 125; add 590 591; input p 157; mul 72 593; add 592 594; mul 55 87;
add 595 596; input p 158; mul 91 598; add 597 599; mul 67 95; add 600 601; input p 159; mul 99 603; add 602 604; mul
82 156; add 605 606; mul 100 155; add 607 608; mul 51 163; add 609 610; mul 42 611; abs 50; lt 613 185; input p 160;
mul 174 615; mul 181 196; add 616 617; input p 161; mul 189 619; add 618 620; input p 162; mul 193 622; add 621 623;
input p 163; mul 197 625; add 624 626; input p 164; mul 201 628; add 627 629; mul 204 630; input p 165; mul 207 632;
mul 210 520; add 633 634; mul 214 225; add 635 636; mul 218 233; add 637 638; input p 166; mul 222 640; add 639 641;
input p 167; mul 226 643; add 642 644; input p 168; mul 230 646; add 645 647; mul 234 537; add 648 649; input p 169;
mul 238 651; add 650 652; input p 170; mul 204 654; add 653 655; add 631 656; constant 3.0; mul 201 658; input p
171; mul 207 660; mul 210 499; add 661 662; mul 214 615; add 663 664; mul 192 218; add 665 666; mul 196 222; add 667
668; mul 200 226; add 669 670; input p 172; mul 230 672; add 671 673; mul 234 622; add 674 675; mul 238 512; add 676
677; input p 173; mul 204 679; add 678 680; mul 659 681; add 657 682; mul 42 683; where 614 684; add 612 685; mul 51
301; add 373 687; mul 256 688; add 349 689; mul 477 690; sub 686 691; neg 692; sub 26 19; mul 12 30; add 694 695;
input p 180; mul 47 50; mul 55 698; add 697 699; mul 50 698; mul 59 701; add 700 702; mul 53 309; mul 47 704; mul 63
705; add 703 706; mul 50 705; mul 67 708; add 707 709; mul 53 705; mul 47 64; add 711 712; mul 71 713; add 710 714;
mul 45 47; mul 86 716; add 715 717; mul 50 716; mul 90 719; add 718 720; mul 53 716; mul 47 87; add 722 723; mul 94
724; add 721 725; mul 47 99; mul 98 727; add 726 728; input p 181; mul 122 698; add 730 731; mul 125 701; add 732
733; mul 128 705; add 734 735; mul 131 708; add 736 737; mul 134 713; add 738 739; mul 143 716; add 740 741; mul 146
719; add 742 743; mul 149 724; add 744 745; mul 94 727; add 746 747; mul 44 748; add 729 749; mul 42 750; le 179
177; le 177 179; add 752 753; div 310 754; mul 752 755; le 178 10; le 10 178; add 757 758; div 310 759; mul 757 760;
mul 756 761; mul 173 762; mul 176 763; mul 180 309; mul 762 765; mul 192 766; add 764 767; mul 188 762; mul 196 769;
add 768 770; mul 204 771; mul 174 762; mul 209 773; mul 180 763; mul 181 762; add 775 776; mul 217 777; add 774 778;
mul 188 763; mul 221 780; add 779 781; mul 180 766; mul 193 762; add 783 784; mul 229 785; add 782 786; mul 188 766;
mul 233 788; add 787 789; mul 188 769; mul 237 791; add 790 792; add 772 793; mul 42 794; where 169 795; add 751
796; input p 182; mul 258 701; mul 260 713; add 799 800; mul 266 719; add 801 802; mul 269 724; add 803 804; mul 272
727; add 805 806; mul 280 701; mul 283 708; add 808 809; mul 286 713; add 810 811; mul 291 724; add 812 813; mul 269
727; add 814 815; mul 44 816; add 807 817; mul 256 818; add 798 819; mul 477 820; mul 309 331; div 310 321; mul 318
823; mul 316 824; mul 316 322; mul 312 316; mul 826 827; sub 825 828; mul 323 829; mul 316 327; mul 827 831; sub 316
832; mul 328 833; add 830 834; mul 822 835; mul 309 383; add 337 341; add 335 838; add 340 839; mul 16 840; mul 45
807; mul 53 816; add 547 843; add 842 844; mul 359 701; mul 280 708; add 846 847; mul 364 713; add 848 849; mul 367
719; add 850 851; mul 294 727; add 852 853; mul 50 854; add 845 855; mul 353 856; mul 256 857; add 841 858; mul 328
829; add 859 860; mul 323 833; sub 861 862; mul 837 863; add 836 864; mul 309 386; div 310 866; mul 865 867; mul 307
868; mul 309 869; mul 309 390; mul 309 389; div 310 872; mul 869 873; mul 391 874; mul 871 875; neg 876; mul 309
877; mul 391 878; mul 392 876; sub 879 880; sub 870 881; mul 308 882; mul 407 883; le 400 396; le 396 400; add 885
886; div 310 887; mul 885 888; le 397 399; le 399 397; add 890 891; div 310 892; mul 890 893; mul 869 894; mul 889
895; mul 403 896; mul 401 897; mul 405 896; add 898 899; mul 395 900; add 884 901; mul 412 869; mul 399 903; mul 414
869; add 904 905; mul 410 906; sub 902 907; mul 307 908; mul 421 909; mul 420 863; mul 307 876; mul 383 912; sub 911
913; mul 419 914; add 910 915; mul 309 432; mul 425 833; mul 427 829; sub 918 919; mul 917 920; mul 309 439; mul 425
829; add 859 923; mul 427 833; add 924 925; mul 922 926; add 921 927; mul 309 442; div 310 929; mul 928 930; mul 423
931; mul 309 932; mul 309 446; mul 309 445; div 310 935; mul 932 936; mul 447 937; mul 934 938; neg 939; mul 309
940; mul 447 941; mul 448 939; sub 942 943; sub 933 944; mul 424 945; mul 460 946; le 453 396; le 396 453; add 948
949; div 310 950; mul 948 951; le 397 452; le 452 397; add 953 954; div 310 955; mul 953 956; mul 932 957; mul 952
958; mul 456 959; mul 454 960; mul 458 959; add 961 962; mul 451 963; add 947 964; mul 465 932; mul 452 966; mul 467
932; add 967 968; mul 463 969; sub 965 970; mul 423 971; mul 474 972; mul 473 926; mul 423 939; mul 439 975; sub 974
976; mul 472 977; add 973 978; add 916 979; mul 305 980; sub 821 981; sub 797 982; mul 41 983; mul 481 909; mul 420
835; mul 331 912; sub 986 987; mul 419 988; add 985 989; mul 483 972; mul 473 920; mul 432 975; sub 992 993; mul 472
994; add 991 995; add 990 996; sub 984 997; sub 696 998; mul 492 833; mul 491 1000; mul 316 316; mul 827 1002; mul
490 1003; mul 490 491; mul 321 827; mul 315 824; add 1006 1007; mul 1005 1008; add 1004 1009; mul 493 1010; sub 1001
1011; mul 47 748; mul 42 1013; mul 501 763; mul 506 766; add 1015 1016; mul 509 769; add 1017 1018; mul 204 1019;
mul 217 773; mul 523 777; add 1021 1022; mul 526 780; add 1023 1024; mul 531 785; add 1025 1026; mul 534 788; add
1027 1028; mul 537 791; add 1029 1030; add 1020 1031; mul 42 1032; where 498 1033; add 1014 1034; mul 47 816; mul
256 1036; add 336 1037; mul 477 1038; mul 549 980; sub 1039 1040; sub 1035 1041; mul 558 909; mul 552 835; sub 860
862; mul 331 1045; add 1044 1046; mul 554 863; mul 383 835; add 1048 1049; sub 1047 1050; mul 420 1051; mul 556 912;
sub 1052 1053; mul 491 1054; mul 557 1010; sub 1055 1056; mul 419 1057; add 1043 1058; mul 566 972; mul 560 920; add
923 925; mul 432 1062; add 1061 1063; mul 562 926; sub 919 918; mul 439 1066; add 1065 1067; add 1064 1068; mul 473
1069; mul 564 975; sub 1070 1071; mul 491 1072; mul 565 1010; sub 1073 1074; mul 472 1075; add 1060 1076; add 1059
1077; add 1042 1078; add 30 1079; sub 1012 1080; input p 183; mul 582 698; add 1082 1083; mul 585 701; add 1084
1085; mul 588 705; add 1086 1087; mul 125 708; add 1088 1089; mul 593 713; add 1090 1091; mul 55 716; add 1092 1093;
mul 598 719; add 1094 1095; mul 67 724; add 1096 1097; mul 155 727; add 1098 1099; mul 51 748; add 1100 1101; mul 42
1102; mul 196 763; mul 622 766; add 1104 1105; mul 625 769; add 1106 1107; mul 204 1108; mul 520 773; mul 233 777;
add 1110 1111; mul 640 780; add 1112 1113; mul 646 785; add 1114 1115; mul 537 788; add 1116 1117; mul 651 791; add
1118 1119; add 1109 1120; mul 499 773; mul 192 777; add 1122 1123; mul 196 780; add 1124 1125; mul 672 785; add 1126
1127; mul 622 788; add 1128 1129; mul 512 791; add 1130 1131; mul 659 1132; add 1121 1133; mul 42 1134; where 614
1135; add 1103 1136; mul 51 816; add 854 1138; mul 256 1139; add 339 1140; mul 477 1141; mul 690 980; sub 1142 1143;
sub 1137 1144; neg 1145; input p 184; add 52 53; mul 55 1148; add 1147 1149; mul 50 1148; add 56 1151; mul 59 1152;
add 1150 1153; mul 51 704; mul 63 1155; add 1154 1156; mul 50 1155; add 64 1158; mul 67 1159; add 1157 1160; mul 53
1155; mul 51 64; add 1162 1163; mul 71 1164; add 1161 1165; mul 45 78; add 1166 1167; mul 79 309; mul 82 1169; add
1168 1170; mul 45 51; mul 86 1172; add 1171 1173; mul 50 1172; add 87 1175; mul 90 1176; add 1174 1177; mul 53 1172;
mul 51 87; add 1179 1180; mul 94 1181; add 1178 1182; mul 51 99; mul 98 1184; add 1183 1185; mul 50 309; mul 111
1187; add 108 1188; mul 50 1187; add 112 1190; mul 115 1191; add 1189 1192; input p 185; add 1193 1194; mul 122
1148; add 1195 1196; mul 125 1152; add 1197 1198; mul 128 1155; add 1199 1200; mul 131 1159; add 1201 1202; mul 134
1164; add 1203 1204; mul 45 55; add 1205 1206; mul 59 1169; add 1207 1208; mul 143 1172; add 1209 1210; mul 146
1176; add 1211 1212; mul 149 1181; add 1213 1214; mul 99 155; add 1215 1216; mul 94 1184; add 1217 1218; mul 44
1219; add 1186 1220; mul 42 1221; le 187 185; le 185 187; add 1223 1224; div 310 1225; mul 1223 1226; le 186 50; le
50 186; add 1228 1229; div 310 1230; mul 1228 1231; mul 1227 1232; mul 173 1233; mul 184 1234; mul 180 1233; mul 196
1236; add 1235 1237; mul 188 309; mul 1233 1239; mul 200 1240; add 1238 1241; mul 204 1242; mul 188 1240; mul 201
1233; add 1244 1245; mul 203 1246; add 1243 1247; mul 174 1233; mul 213 1249; mul 181 1233; mul 221 1251; add 1250
1252; mul 188 1234; mul 189 1233; add 1254 1255; mul 225 1256; add 1253 1257; mul 193 1233; mul 233 1259; add 1258
1260; mul 188 1236; mul 197 1233; add 1262 1263; mul 237 1264; add 1261 1265; mul 241 1246; add 1266 1267; add 1248
1268; mul 42 1269; where 169 1270; add 1222 1271; input p 186; mul 258 1152; mul 260 1164; add 1274 1275; mul 263
1169; add 1276 1277; mul 266 1176; add 1278 1279; mul 269 1181; add 1280 1281; mul 272 1184; add 1282 1283; mul 278
1191; mul 280 1152; add 1285 1286; mul 283 1159; add 1287 1288; mul 286 1164; add 1289 1290; mul 258 1169; add 1291
1292; mul 291 1181; add 1293 1294; mul 99 294; add 1295 1296; mul 269 1184; add 1297 1298; mul 44 1299; add 1284
1300; mul 256 1301; add 1273 1302; mul 477 1303; add 348 349; add 346 1305; mul 16 1306; mul 45 1284; mul 53 1299;
add 687 1309; add 1308 1310; mul 357 1191; mul 359 1152; add 1312 1313; mul 280 1159; add 1314 1315; mul 364 1164;
add 1316 1317; mul 367 1176; add 1318 1319; mul 99 263; add 1320 1321; mul 294 1184; add 1322 1323; mul 50 1324; add
373 1325; add 1311 1326; mul 353 1327; mul 256 1328; add 1307 1329; mul 837 1330; mul 867 1331; mul 307 1332; mul
309 1333; mul 873 1333; mul 391 1335; mul 871 1336; neg 1337; mul 309 1338; mul 391 1339; mul 392 1337; sub 1340
1341; sub 1334 1342; mul 308 1343; mul 407 1344; mul 894 1333; mul 889 1346; mul 403 1347; mul 401 1348; mul 405
1347; add 1349 1350; mul 395 1351; add 1345 1352; mul 412 1333; mul 399 1354; mul 414 1333; add 1355 1356; mul 410
1357; sub 1353 1358; mul 307 1359; mul 421 1360; mul 420 1330; mul 307 1337; mul 383 1363; sub 1362 1364; mul 419
1365; add 1361 1366; mul 922 1330; mul 930 1368; mul 423 1369; mul 309 1370; mul 936 1370; mul 447 1372; mul 934
1373; neg 1374; mul 309 1375; mul 447 1376; mul 448 1374; sub 1377 1378; sub 1371 1379; mul 424 1380; mul 460 1381;
mul 957 1370; mul 952 1383; mul 456 1384; mul 454 1385; mul 458 1384; add 1386 1387; mul 451 1388; add 1382 1389;
mul 465 1370; mul 452 1391; mul 467 1370; add 1392 1393; mul 463 1394; sub 1390 1395; mul 423 1396; mul 474 1397;
mul 473 1330; mul 423 1374; mul 439 1400; sub 1399 1401; mul 472 1402; add 1398 1403; add 1367 1404; mul 305 1405;
sub 1304 1406; sub 1272 1407; mul 41 1408; mul 481 1360; mul 331 1363; mul 419 1411; sub 1410 1412; mul 483 1397;
mul 432 1400; mul 472 1415; sub 1414 1416; add 1413 1417; sub 1409 1418; neg 1419; mul 47 1219; mul 42 1421; mul 196
1234; mul 509 1236; add 1423 1424; mul 512 1240; add 1425 1426; mul 204 1427; mul 514 1246; add 1428 1429; mul 520
1249; mul 526 1251; add 1431 1432; mul 237 1256; add 1433 1434; mul 534 1259; add 1435 1436; mul 537 1264; add 1437
1438; mul 540 1246; add 1439 1440; add 1430 1441; mul 42 1442; where 498 1443; add 1422 1444; mul 47 1299; mul 256
1446; add 339 1447; mul 477 1448; mul 549 1405; sub 1449 1450; sub 1445 1451; mul 558 1360; mul 554 1330; mul 420
1454; mul 556 1363; add 1455 1456; mul 491 1457; mul 419 1458; sub 1453 1459; mul 566 1397; mul 562 1330; mul 473
1462; mul 564 1400; sub 1463 1464; mul 491 1465; mul 472 1466; add 1461 1467; add 1460 1468; add 1452 1469; neg
1470; mul 574 1187; add 572 1472; mul 577 1191; add 1473 1474; input p 187; add 1475 1476; mul 582 1148; add 1477
1478; mul 585 1152; add 1479 1480; mul 588 1155; add 1481 1482; mul 125 1159; add 1483 1484; mul 593 1164; add 1485
1486; mul 55 1172; add 1487 1488; mul 598 1176; add 1489 1490; mul 67 1181; add 1491 1492; mul 82 99; add 1493 1494;
mul 155 1184; add 1495 1496; mul 51 1219; add 1497 1498; mul 42 1499; mul 619 1234; mul 625 1236; add 1501 1502; mul
628 1240; add 1503 1504; mul 204 1505; mul 630 1246; add 1506 1507; mul 225 1249; mul 640 1251; add 1509 1510; mul
643 1256; add 1511 1512; mul 537 1259; add 1513 1514; mul 651 1264; add 1515 1516; mul 654 1246; add 1517 1518; add
1508 1519; mul 658 1240; mul 681 1521; mul 615 1249; mul 196 1251; add 1523 1524; mul 200 1256; add 1525 1526; mul
622 1259; add 1527 1528; mul 512 1264; add 1529 1530; mul 679 1246; add 1531 1532; mul 659 1533; add 1522 1534; add
1520 1535; mul 42 1536; where 614 1537; add 1500 1538; mul 51 1299; add 1324 1540; mul 256 1541; add 347 1542; mul
477 1543; mul 690 1405; sub 1544 1545; sub 1539 1546; neg 1547; store forces 0 488; store forces 1 571; store forces
2 693; store by_shape 0 999; store by_shape 2 1081; store by_shape 4 1146; store by_shape 1 1420; store by_shape 3
1471; store by_shape 5 1548
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
