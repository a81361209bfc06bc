"""The condensed joint: rates, forces at rest, inertia, stop operators after a step.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

CONSTANTS = ('l', 'bending', 'bending_loss', 'steepening', 'stiffening', 'curvature', 'slope_by_q', 'slope_by_tau',
    'slope_by_beta', 'rotation', 'quartic_qqqq', 'quartic_qqqt', 'quartic_qqqb', 'quartic_qqtt', 'quartic_qqtb',
    'quartic_qqbb', 'quartic_qttt', 'quartic_qttb', 'quartic_qtbb', 'quartic_qbbb', 'quartic_tttt',
    'quartic_tttb', 'quartic_ttbb', 'quartic_tbbb', 'quartic_bbbb', 'sextic_qqqbbb', 'sextic_qqtbbb',
    'sextic_qqbbbb', 'sextic_qttbbb', 'sextic_qtbbbb', 'sextic_qbbbbb', 'sextic_tttbbb', 'sextic_ttbbbb',
    'sextic_tbbbbb', 'sextic_bbbbbb', 'shortening_qqqq', 'shortening_qqqt', 'shortening_qqqb', 'shortening_qqtt',
    'shortening_qqtb', 'shortening_qqbb', 'shortening_qttt', 'shortening_qttb', 'shortening_qtbb',
    'shortening_qbbb', 'shortening_tttt', 'shortening_tttb', 'shortening_ttbb', 'shortening_tbbb',
    'shortening_bbbb', 'mass', 'cross', 'inertia', 'gyration', 'interior_inertia', 'rise_qq', 'rise_qt',
    'rise_tt', 'rise_qb', 'rise_tb', 'rise_bb', 'weight', 'offset', 'side_force', 'relaxation_0', 'relaxation_1',
    'relaxation_2', 'strain_slope', 'viscosity', 'drag', 'sliding_force', 'sliding_speed', 'friction_arm',
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
    {'k': 114},
    {'p': 194},
    """
input k 52; input k 53; constant 1.0; input k 9; sub 3 2; input k 50; input k 62; input k 56; input k 57; input k
59; input k 54; input k 58; input k 60; input k 55; input k 51; input k 113; input k 0; div 2 16; mul 15 17;
constant 0.5; constant -2.0; input k 2; mul 20 21; input k 68; input k 1; constant -6.000000000000002; constant
-18.000000000000004; input k 5; mul 27 27; input k 4; mul 28 29; mul 26 30; add 25 31; constant
-0.09999999999999995; input k 3; mul 28 34; mul 33 35; add 32 36; input k 6; input k 7; input k 8; constant
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
constant 3.0; input k 25; mul 164 165; input k 26; constant 2.0; mul 167 168; input k 27; mul 168 170; constant 0.8;
input k 28; input k 29; input k 30; constant 4.0; input k 10; mul 176 177; input k 11; mul 164 179; input k 12; mul
164 181; input k 13; mul 168 183; input k 14; mul 168 185; input k 15; mul 168 187; input k 16; input k 17; input k
18; input k 19; input k 61; input k 78; input k 73; input k 75; input k 74; input k 76; sub 198 16; input k 35; mul
176 200; input k 36; mul 164 202; input k 37; mul 164 204; input k 38; mul 168 206; input k 39; mul 168 208; input k
40; mul 168 210; input k 41; input k 42; input k 43; input k 44; mul 164 212; mul 168 213; input k 45; mul 176 218;
input k 46; mul 164 220; input k 47; mul 168 222; input k 48; mul 168 214; mul 164 215; mul 164 224; input k 49; mul
176 228; input k 77; div 2 230; input k 79; input k 80; input k 81; input k 82; mul 19 235; constant
0.7142857142857143; sub 235 237; mul 236 238; input k 83; input k 84; input k 85; input k 67; mul 19 243; sub 243
237; mul 244 245; input k 86; input k 92; input k 88; input k 87; input k 89; input k 90; sub 252 16; input k 91;
div 2 254; input k 93; input k 94; input k 95; input k 96; mul 19 259; sub 259 237; mul 260 261; input k 97; input k
98; input k 99; input k 100; input k 63; input k 101; input k 72; input k 105; div 2 270; input k 102; input k 106;
div 2 273; input k 103; input k 107; div 2 276; input k 104; input k 108; div 2 279; input k 69; input k 70; input k
71; mul 283 283; input k 109; input k 110; mul 3 168; mul 168 173; input k 31; mul 164 289; input k 32; mul 168 291;
input k 33; mul 164 189; mul 168 190; input k 20; mul 176 296; input k 21; mul 164 298; input k 22; mul 168 300;
input k 23; mul 6 193; constant 0.8000000000000002; constant 2.400000000000001; mul 30 305; add 304 306; constant
0.01904761904761903; mul 35 308; add 307 309; constant -1.3714285714285723; mul 42 311; constant 1.3714285714285714;
mul 29 313; constant 0.007256235827664418; mul 34 315; add 314 316; constant -4.799999999999999; mul 42 318;
constant 1.3714285714285692; mul 29 320; constant -0.05714285714285729; mul 34 322; add 321 323; constant
-7.199999999999996; mul 42 325; constant 7.199999999999994; mul 29 327; constant 0.2190476190476189; mul 34 329; add
328 330; constant -45.25714285714286; mul 29 332; constant -0.11428571428571327; mul 34 334; add 333 335; constant
-28.800000000000004; mul 42 337; mul 168 175; mul 168 293; input k 34; mul 164 341; mul 168 191; mul 164 192; mul
164 302; input k 24; mul 176 346; mul 21 172; input k 64; input k 65; input k 66; input k 111; input k 112; mul 37
39; mul 39 118; mul 7 16; mul 39 104; mul 37 40; mul 40 118; mul 11 16; mul 40 104; store p 0 0; store p 1 3; store
p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11;
store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 22; store p 16 23; store p 17 17; store p 18
24; store p 19 37; store p 20 38; store p 21 39; store p 22 40; store p 23 43; store p 24 48; store p 25 50; store p
26 55; store p 27 60; store p 28 67; store p 29 69; store p 30 74; store p 31 76; store p 32 81; store p 33 86;
store p 34 91; store p 35 96; store p 36 102; store p 37 104; store p 38 106; store p 39 111; store p 40 118; store
p 41 120; store p 42 125; store p 43 129; store p 44 134; store p 45 139; store p 46 141; store p 47 146; store p 48
151; store p 49 153; store p 50 158; store p 51 163; store p 52 166; store p 53 169; store p 54 171; store p 55 173;
store p 56 174; store p 57 175; store p 58 178; store p 59 180; store p 60 182; store p 61 184; store p 62 186;
store p 63 188; store p 64 189; store p 65 190; store p 66 191; store p 67 192; store p 68 16; store p 69 201; store
p 70 203; store p 71 205; store p 72 207; store p 73 209; store p 74 211; store p 75 212; store p 76 213; store p 77
214; store p 78 215; store p 79 193; store p 80 199; store p 81 202; store p 82 208; store p 83 216; store p 84 217;
store p 85 219; store p 86 221; store p 87 223; store p 88 224; store p 89 204; store p 90 225; store p 91 226;
store p 92 220; store p 93 227; store p 94 229; store p 95 197; store p 96 195; store p 97 231; store p 98 196;
store p 99 194; store p 100 232; store p 101 233; store p 102 234; store p 103 235; store p 104 239; store p 105
240; store p 106 241; store p 107 242; store p 108 243; store p 109 246; store p 110 247; store p 111 253; store p
112 249; store p 113 250; store p 114 255; store p 115 251; store p 116 248; store p 117 256; store p 118 257; store
p 119 258; store p 120 259; store p 121 262; store p 122 263; store p 123 264; store p 124 265; store p 125 266;
store p 126 21; store p 127 267; store p 128 268; store p 129 269; store p 130 271; store p 131 272; store p 132
274; store p 133 275; store p 134 277; store p 135 278; store p 136 280; store p 137 281; store p 138 282; store p
139 284; store p 140 285; store p 141 286; store p 142 287; store p 143 167; store p 144 288; store p 145 290; store
p 146 292; store p 147 293; store p 148 179; store p 149 185; store p 150 294; store p 151 295; store p 152 297;
store p 153 299; store p 154 301; store p 155 302; store p 156 303; store p 157 310; store p 158 312; store p 159
317; store p 160 319; store p 161 324; store p 162 326; store p 163 331; store p 164 336; store p 165 338; store p
166 170; store p 167 339; store p 168 291; store p 169 340; store p 170 342; store p 171 181; store p 172 343; store
p 173 344; store p 174 298; store p 175 345; store p 176 347; store p 177 165; store p 178 289; store p 179 341;
store p 180 348; store p 181 349; store p 182 350; store p 183 351; store p 184 352; store p 185 353; store p 186
354; store p 187 355; store p 188 356; store p 189 357; store p 190 358; store p 191 359; store p 192 360; store p
193 361
    """,
)

RATES = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'start': 2, 'p': 194},
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
261; input p 51; mul 206 263; add 262 264; mul 147 265; add 208 266; mul 145 267; input p 52; constant
0.5249999999999999; constant -0.5249999999999999; max 271 148; min 270 272; constant 0.175; abs 148; constant 0.35;
sub 275 276; max 140 277; min 274 278; sign 148; mul 279 280; mul 279 281; div 2 276; mul 282 283; sub 273 284; mul
285 285; mul 269 286; input p 53; constant 0.8999999999999999; constant -0.8999999999999999; max 290 3; min 289 291;
constant 0.3; abs 3; constant 0.6; sub 294 295; max 140 296; min 293 297; sign 3; mul 298 299; mul 298 300; div 2
295; mul 301 302; sub 292 303; mul 285 304; mul 288 305; add 287 306; input p 54; constant 2.4000000000000004;
constant -2.4000000000000004; max 310 35; min 309 311; constant 0.8; abs 35; constant 1.6; sub 314 315; max 140 316;
min 313 317; sign 35; mul 318 319; mul 318 320; div 2 315; mul 321 322; sub 312 323; mul 285 324; mul 308 325; add
307 326; input p 55; mul 304 304; mul 328 329; add 327 330; input p 56; mul 304 324; mul 332 333; add 331 334; input
p 57; mul 324 324; mul 336 337; add 335 338; mul 324 337; mul 339 340; input p 58; mul 285 286; mul 342 343; input p
59; mul 286 304; mul 345 346; add 344 347; input p 60; mul 286 324; mul 349 350; add 348 351; input p 61; mul 304
305; mul 353 354; add 352 355; input p 62; mul 305 324; mul 357 358; add 356 359; input p 63; mul 324 325; mul 361
362; add 360 363; input p 64; mul 304 329; mul 365 366; add 364 367; input p 65; mul 324 329; mul 369 370; add 368
371; input p 66; mul 324 333; mul 373 374; add 372 375; input p 67; mul 340 377; add 376 378; add 341 379; mul 145
380; constant 5.714285714285714; mul 279 382; sub 2 383; mul 381 384; add 268 385; input p 68; mul 67 387; input p
69; mul 343 389; input p 70; mul 346 391; add 390 392; input p 71; mul 350 394; add 393 395; input p 72; mul 354
397; add 396 398; input p 73; mul 358 400; add 399 401; input p 74; mul 362 403; add 402 404; input p 75; mul 366
406; add 405 407; input p 76; mul 370 409; add 408 410; input p 77; mul 374 412; add 411 413; input p 78; mul 340
415; add 414 416; mul 384 417; mul 387 418; add 388 419; input p 79; input p 80; mul 29 67; mul 3 37; add 423 424;
mul 35 53; add 425 426; mul 104 427; constant 0.25; mul 285 417; input p 81; mul 343 431; mul 346 397; add 432 433;
input p 82; mul 350 435; add 434 436; input p 83; mul 354 438; add 437 439; input p 84; mul 358 441; add 440 442;
mul 362 412; add 443 444; input p 85; mul 366 446; add 445 447; input p 86; mul 370 449; add 448 450; input p 87;
mul 374 452; add 451 453; input p 88; mul 340 455; add 454 456; mul 304 457; add 430 458; input p 89; mul 343 460;
mul 346 435; add 461 462; mul 350 403; add 463 464; mul 354 409; add 465 466; input p 90; mul 358 468; add 467 469;
input p 91; mul 362 471; add 470 472; input p 92; mul 366 474; add 473 475; mul 370 452; add 476 477; input p 93;
mul 374 479; add 478 480; input p 94; mul 340 482; add 481 483; mul 324 484; add 459 485; mul 429 486; mul 387 487;
add 428 488; add 422 489; input p 95; mul 24 491; add 490 492; input p 96; mul 38 494; sub 493 495; input p 97; mul
24 494; input p 98; sub 498 499; mul 38 491; add 500 501; sub 502 29; mul 503 503; mul 496 496; add 504 505; sqrt
506; mul 497 507; sqrt 508; div 2 509; mul 510 510; mul 497 511; mul 496 512; input p 99; constant 2.0; mul 508 515;
mul 511 515; mul 511 517; sub 516 518; mul 514 519; constant -0.3; constant 1.4; sub 508 522; max 521 523; min 293
524; input p 100; input p 101; mul 525 527; add 526 528; mul 525 529; add 2 530; mul 520 531; input p 102; mul 93
533; input p 103; input p 104; mul 523 536; add 535 537; mul 523 538; add 2 539; mul 534 540; sub 532 541; mul 497
542; input p 105; input x 6; mul 544 545; input p 106; input x 8; mul 547 548; add 546 549; input p 107; input x 10;
mul 551 552; add 550 553; constant -0.5; mul 510 555; mul 510 556; mul 510 557; mul 497 558; input p 108; input p
109; mul 523 561; add 560 562; mul 523 563; add 2 564; mul 559 565; mul 554 566; add 543 567; input p 110; mul 566
569; mul 566 570; sub 492 495; mul 503 572; add 498 501; mul 496 574; sub 573 575; mul 512 576; mul 17 577; mul 130
578; mul 503 512; mul 0 580; sub 579 581; mul 0 144; mul 420 583; constant 3.3333333333333335; mul 298 585; sub 2
586; mul 457 587; mul 387 588; add 37 589; mul 130 590; add 584 591; constant 1.25; mul 318 593; sub 2 594; mul 484
595; mul 387 596; add 53 597; input x 5; mul 598 599; add 592 600; mul 513 601; add 582 602; mul 571 603; add 568
604; mul 513 605; input p 111; add 489 607; input p 112; mul 24 609; add 608 610; input p 113; mul 38 612; add 611
613; input p 114; mul 38 609; mul 24 612; input p 115; sub 617 618; sub 616 619; sub 620 29; mul 621 621; mul 614
614; add 622 623; sqrt 624; mul 615 625; sqrt 626; div 2 627; mul 628 628; mul 615 629; mul 614 630; input p 116;
mul 515 626; mul 515 629; mul 629 634; sub 633 635; mul 632 636; sub 626 522; max 521 638; min 293 639; input p 117;
input p 118; mul 640 642; add 641 643; mul 640 644; add 2 645; mul 637 646; input p 119; mul 97 648; input p 120;
input p 121; mul 638 651; add 650 652; mul 638 653; add 2 654; mul 649 655; sub 647 656; mul 615 657; input p 122;
input x 7; mul 659 660; input p 123; input x 9; mul 662 663; add 661 664; input p 124; input x 11; mul 666 667; add
665 668; mul 555 628; mul 628 670; mul 628 671; mul 615 672; mul 561 638; add 560 674; mul 638 675; add 2 676; mul
673 677; mul 669 678; add 658 679; input p 125; mul 678 681; mul 678 682; add 610 613; mul 621 684; sub 617 616; mul
614 686; add 685 687; mul 630 688; mul 17 689; mul 130 690; mul 621 630; mul 0 692; sub 691 693; mul 601 631; add
694 695; mul 683 696; add 680 697; mul 631 698; add 606 699; sub 421 700; mul 420 701; sub 386 702; input p 126;
constant 12.0; mul 583 705; constant -6.0; mul 147 583; mul 130 150; add 708 709; mul 153 599; add 710 711; mul 707
712; add 706 713; mul 704 714; mul 583 707; constant 4.0; mul 712 717; add 716 718; mul 704 719; mul 147 720; add
715 721; add 703 722; mul 144 723; mul 580 605; mul 692 698; add 725 726; sub 724 727; sub 143 728; input p 127;
input p 128; constant -1.0; input z 0; input start 0; sub 29 734; input p 129; input start 1; sub 3 737; mul 736
738; add 735 739; input p 130; mul 740 741; add 733 742; max 732 743; min 2 744; mul 731 745; input p 131; input z
1; input p 132; mul 740 749; add 748 750; max 732 751; min 2 752; mul 747 753; add 746 754; input p 133; input z 2;
input p 134; mul 740 758; add 757 759; max 732 760; min 2 761; mul 756 762; add 755 763; input p 135; input z 3;
input p 136; mul 740 767; add 766 768; max 732 769; min 2 770; mul 765 771; add 764 772; sub 730 773; input p 137;
abs 0; mul 775 776; mul 0 777; input p 138; mul 0 779; mul 0 0; input p 139; add 781 782; sqrt 783; div 2 784; mul
780 785; add 778 786; sub 774 787; add 729 788; input p 140; input x 12; sub 29 791; mul 790 792; input p 141; input
x 13; sub 29 795; mul 794 796; add 793 797; sub 789 798; mul 0 62; mul 28 130; add 800 801; mul 47 599; add 802 803;
mul 0 804; mul 0 28; mul 31 130; add 806 807; mul 34 599; add 808 809; mul 130 810; add 805 811; mul 0 47; mul 34
130; add 813 814; mul 51 599; add 815 816; mul 599 817; add 812 818; mul 17 130; mul 130 820; mul 23 821; input p
142; mul 9 823; mul 9 824; mul 8 16; mul 10 826; mul 826 827; add 825 828; mul 3 829; mul 38 830; sub 25 831; mul
822 832; add 819 833; mul 67 834; mul 24 830; add 39 836; mul 822 837; sub 835 838; mul 22 839; sub 799 840; mul 90
841; mul 81 89; mul 150 265; mul 145 844; input p 143; mul 286 846; input p 144; mul 305 848; add 847 849; mul 325
332; add 850 851; input p 145; mul 329 853; add 852 854; input p 146; mul 333 856; add 855 857; input p 147; mul 337
859; add 858 860; mul 340 861; input p 148; mul 343 863; mul 346 353; add 864 865; input p 149; mul 350 867; add 866
868; input p 150; mul 354 870; add 869 871; input p 151; mul 358 873; add 872 874; mul 362 373; add 875 876; input p
152; mul 366 878; add 877 879; input p 153; mul 370 881; add 880 882; input p 154; mul 374 884; add 883 885; input p
155; mul 340 887; add 886 888; add 862 889; mul 145 890; mul 587 891; add 845 892; mul 590 701; sub 893 894; mul 150
720; add 895 896; mul 578 605; mul 690 698; add 898 899; add 897 900; sub 134 901; input p 156; mul 38 903; mul 17
904; add 902 905; mul 736 773; sub 906 907; mul 41 834; mul 26 838; sub 909 910; mul 22 911; mul 19 830; mul 821
913; sub 912 914; sub 908 915; mul 843 916; sub 842 917; mul 86 89; input p 157; mul 35 920; input p 158; mul 214
922; add 921 923; input p 159; mul 218 925; add 924 926; mul 155 210; add 927 928; input p 160; mul 158 930; add 929
931; input p 161; mul 162 933; add 932 934; input p 162; mul 166 936; add 935 937; mul 170 227; add 938 939; input p
163; mul 174 941; add 940 942; mul 157 189; add 943 944; input p 164; mul 193 946; add 945 947; mul 169 197; add 948
949; input p 165; mul 201 951; add 950 952; mul 184 258; add 953 954; mul 202 257; add 955 956; mul 153 265; add 957
958; mul 145 959; input p 166; mul 286 961; mul 305 332; add 962 963; input p 167; mul 325 965; add 964 966; input p
168; mul 329 968; add 967 969; input p 169; mul 333 971; add 970 972; input p 170; mul 337 974; add 973 975; mul 340
976; input p 171; mul 343 978; mul 346 867; add 979 980; mul 350 361; add 981 982; mul 354 369; add 983 984; input p
172; mul 358 986; add 985 987; input p 173; mul 362 989; add 988 990; input p 174; mul 366 992; add 991 993; mul 370
884; add 994 995; input p 175; mul 374 997; add 996 998; input p 176; mul 340 1000; add 999 1001; add 977 1002;
constant 3.0; mul 337 1004; input p 177; mul 343 1006; mul 346 846; add 1007 1008; mul 350 961; add 1009 1010; mul
328 354; add 1011 1012; mul 332 358; add 1013 1014; mul 336 362; add 1015 1016; input p 178; mul 366 1018; add 1017
1019; mul 370 968; add 1020 1021; mul 374 859; add 1022 1023; input p 179; mul 340 1025; add 1024 1026; mul 1005
1027; add 1003 1028; mul 145 1029; mul 595 1030; add 960 1031; mul 598 701; sub 1032 1033; input p 180; mul 599
1035; mul 153 720; add 1036 1037; add 1034 1038; mul 53 834; mul 22 1040; add 1039 1041; mul 919 1042; sub 918 1043;
mul 56 70; mul 79 79; sub 1045 1046; mul 89 1047; mul 916 1048; mul 841 843; sub 1049 1050; mul 59 70; mul 76 79;
sub 1052 1053; mul 89 1054; mul 1042 1055; add 1051 1056; mul 841 919; mul 916 1055; sub 1058 1059; mul 45 70; mul
76 76; sub 1061 1062; mul 89 1063; mul 1042 1064; sub 1060 1065; mul 566 603; input p 181; mul 545 1068; sub 1067
1069; mul 678 696; mul 660 1068; sub 1071 1072; input p 182; mul 548 1074; sub 1067 1075; mul 663 1074; sub 1071
1077; input p 183; mul 552 1079; sub 1067 1080; mul 667 1079; sub 1071 1082; input p 184; mul 792 1084; input p 185;
mul 796 1086; store rates 0 0; store rates 1 1044; store rates 2 130; store rates 3 1057; store rates 4 599; store
rates 5 1066; store rates 6 1070; store rates 7 1073; store rates 8 1076; store rates 9 1078; store rates 10 1081;
store rates 11 1083; store rates 12 1085; store rates 13 1087
    """,
)

SHAPE = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'p': 194},
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
add 158 159; input p 51; mul 104 161; add 160 162; mul 44 163; add 106 164; mul 42 165; input p 52; constant
0.5249999999999999; constant -0.5249999999999999; max 169 45; min 168 170; constant 0.175; constant 0.0; abs 45;
constant 0.35; sub 174 175; max 173 176; min 172 177; sign 45; mul 178 179; mul 178 180; constant 1.0; div 182 175;
mul 181 183; sub 171 184; mul 185 185; mul 167 186; input p 53; constant 0.8999999999999999; constant
-0.8999999999999999; max 190 10; min 189 191; constant 0.3; abs 10; constant 0.6; sub 194 195; max 173 196; min 193
197; sign 10; mul 198 199; mul 198 200; div 182 195; mul 201 202; sub 192 203; mul 185 204; mul 188 205; add 187
206; input p 54; constant 2.4000000000000004; constant -2.4000000000000004; max 210 50; min 209 211; constant 0.8;
abs 50; constant 1.6; sub 214 215; max 173 216; min 213 217; sign 50; mul 218 219; mul 218 220; div 182 215; mul 221
222; sub 212 223; mul 185 224; mul 208 225; add 207 226; input p 55; mul 204 204; mul 228 229; add 227 230; input p
56; mul 204 224; mul 232 233; add 231 234; input p 57; mul 224 224; mul 236 237; add 235 238; mul 224 237; mul 239
240; input p 58; mul 185 186; mul 242 243; input p 59; mul 186 204; mul 245 246; add 244 247; input p 60; mul 186
224; mul 249 250; add 248 251; input p 61; mul 204 205; mul 253 254; add 252 255; input p 62; mul 205 224; mul 257
258; add 256 259; input p 63; mul 224 225; mul 261 262; add 260 263; input p 64; mul 204 229; mul 265 266; add 264
267; input p 65; mul 224 229; mul 269 270; add 268 271; input p 66; mul 224 233; mul 273 274; add 272 275; input p
67; mul 240 277; add 276 278; add 241 279; mul 42 280; constant 5.714285714285714; mul 178 282; sub 182 283; mul 281
284; add 166 285; input p 12; mul 11 287; input p 6; mul 10 289; add 288 290; input p 10; mul 50 292; add 291 293;
input p 68; mul 294 295; input p 69; mul 243 297; input p 70; mul 246 299; add 298 300; input p 71; mul 250 302; add
301 303; input p 72; mul 254 305; add 304 306; input p 73; mul 258 308; add 307 309; input p 74; mul 262 311; add
310 312; input p 75; mul 266 314; add 313 315; input p 76; mul 270 317; add 316 318; input p 77; mul 274 320; add
319 321; input p 78; mul 240 323; add 322 324; mul 284 325; mul 295 326; add 296 327; input p 79; input p 97; input
p 99; constant 2.0; input p 1; mul 10 333; mul 10 334; add 182 335; sqrt 336; div 182 337; input p 2; mul 10 339;
mul 10 340; add 182 341; sqrt 342; mul 338 343; input p 96; mul 344 345; input p 98; sub 346 347; mul 10 338; input
p 95; mul 349 350; add 348 351; sub 352 11; mul 353 353; input p 80; mul 11 294; mul 11 289; input p 7; mul 10 358;
add 357 359; input p 8; mul 50 361; add 360 362; mul 10 363; add 356 364; mul 11 292; mul 10 361; add 366 367; input
p 11; mul 50 369; add 368 370; mul 50 371; add 365 372; mul 16 373; constant 0.25; mul 185 325; input p 81; mul 243
377; mul 246 305; add 378 379; input p 82; mul 250 381; add 380 382; input p 83; mul 254 384; add 383 385; input p
84; mul 258 387; add 386 388; mul 262 320; add 389 390; input p 85; mul 266 392; add 391 393; input p 86; mul 270
395; add 394 396; input p 87; mul 274 398; add 397 399; input p 88; mul 240 401; add 400 402; mul 204 403; add 376
404; input p 89; mul 243 406; mul 246 381; add 407 408; mul 250 311; add 409 410; mul 254 317; add 411 412; input p
90; mul 258 414; add 413 415; input p 91; mul 262 417; add 416 418; input p 92; mul 266 420; add 419 421; mul 270
398; add 422 423; input p 93; mul 274 425; add 424 426; input p 94; mul 240 428; add 427 429; mul 224 430; add 405
431; mul 375 432; mul 295 433; add 374 434; add 355 435; mul 344 350; add 436 437; mul 345 349; sub 438 439; mul 440
440; add 354 441; sqrt 442; mul 330 443; mul 332 444; sqrt 444; div 182 446; mul 447 447; mul 332 448; mul 448 449;
sub 445 450; mul 331 451; constant -0.3; constant 1.4; sub 444 454; max 453 455; min 193 456; input p 100; input p
101; mul 457 459; add 458 460; mul 457 461; add 182 462; mul 452 463; input p 102; mul 3 465; input p 103; input p
104; mul 455 468; add 467 469; mul 455 470; add 182 471; mul 466 472; sub 464 473; mul 330 474; mul 330 448; mul 440
476; mul 475 477; input p 114; input p 116; input p 112; mul 349 481; input p 113; mul 344 483; input p 115; sub 484
485; sub 482 486; sub 487 11; mul 488 488; input p 111; add 435 490; mul 344 481; add 491 492; mul 349 483; add 493
494; mul 495 495; add 489 496; sqrt 497; mul 479 498; mul 332 499; sqrt 499; div 182 501; mul 502 502; mul 332 503;
mul 503 504; sub 500 505; mul 480 506; sub 499 454; max 453 508; min 193 509; input p 117; input p 118; mul 510 512;
add 511 513; mul 510 514; add 182 515; mul 507 516; input p 119; mul 7 518; input p 120; input p 121; mul 508 521;
add 520 522; mul 508 523; add 182 524; mul 519 525; sub 517 526; mul 479 527; mul 479 503; mul 495 529; mul 528 530;
add 478 531; sub 329 532; mul 328 533; sub 286 534; mul 41 535; mul 353 476; mul 475 537; mul 488 529; mul 528 539;
add 538 540; sub 536 541; sub 40 542; add 0 543; mul 337 343; div 182 545; mul 338 546; input p 156; mul 349 548;
mul 547 549; mul 47 163; mul 42 551; constant 3.3333333333333335; mul 198 553; sub 182 554; input p 143; mul 186
556; input p 144; mul 205 558; add 557 559; mul 225 232; add 560 561; input p 145; mul 229 563; add 562 564; input p
146; mul 233 566; add 565 567; input p 147; mul 237 569; add 568 570; mul 240 571; input p 148; mul 243 573; mul 246
253; add 574 575; input p 149; mul 250 577; add 576 578; input p 150; mul 254 580; add 579 581; input p 151; mul 258
583; add 582 584; mul 262 273; add 585 586; input p 152; mul 266 588; add 587 589; input p 153; mul 270 591; add 590
592; input p 154; mul 274 594; add 593 595; input p 155; mul 240 597; add 596 598; add 572 599; mul 42 600; mul 555
601; add 552 602; mul 403 555; mul 295 604; add 363 605; mul 533 606; sub 603 607; sub 437 439; mul 353 609; add 346
351; mul 440 611; sub 610 612; mul 476 613; mul 547 614; mul 475 615; add 492 494; mul 488 617; sub 484 482; mul 495
619; add 618 620; mul 529 621; mul 547 622; mul 528 623; add 616 624; add 608 625; sub 38 626; add 550 627; input p
157; mul 50 629; input p 158; mul 112 631; add 630 632; input p 159; mul 116 634; add 633 635; mul 53 108; add 636
637; input p 160; mul 56 639; add 638 640; input p 161; mul 60 642; add 641 643; input p 162; mul 64 645; add 644
646; mul 68 125; add 647 648; input p 163; mul 72 650; add 649 651; mul 55 87; add 652 653; input p 164; mul 91 655;
add 654 656; mul 67 95; add 657 658; input p 165; mul 99 660; add 659 661; mul 82 156; add 662 663; mul 100 155; add
664 665; mul 51 163; add 666 667; mul 42 668; constant 1.25; mul 218 670; sub 182 671; input p 166; mul 186 673; mul
205 232; add 674 675; input p 167; mul 225 677; add 676 678; input p 168; mul 229 680; add 679 681; input p 169; mul
233 683; add 682 684; input p 170; mul 237 686; add 685 687; mul 240 688; input p 171; mul 243 690; mul 246 577; add
691 692; mul 250 261; add 693 694; mul 254 269; add 695 696; input p 172; mul 258 698; add 697 699; input p 173; mul
262 701; add 700 702; input p 174; mul 266 704; add 703 705; mul 270 594; add 706 707; input p 175; mul 274 709; add
708 710; input p 176; mul 240 712; add 711 713; add 689 714; constant 3.0; mul 237 716; input p 177; mul 243 718;
mul 246 556; add 719 720; mul 250 673; add 721 722; mul 228 254; add 723 724; mul 232 258; add 725 726; mul 236 262;
add 727 728; input p 178; mul 266 730; add 729 731; mul 270 680; add 732 733; mul 274 569; add 734 735; input p 179;
mul 240 737; add 736 738; mul 717 739; add 715 740; mul 42 741; mul 672 742; add 669 743; mul 430 672; mul 295 745;
add 371 746; mul 533 747; sub 744 748; neg 749; sub 26 19; mul 12 30; add 751 752; input p 186; mul 47 50; mul 55
755; add 754 756; mul 50 755; mul 59 758; add 757 759; mul 53 332; mul 47 761; mul 63 762; add 760 763; mul 50 762;
mul 67 765; add 764 766; mul 53 762; mul 47 64; add 768 769; mul 71 770; add 767 771; mul 45 47; mul 86 773; add 772
774; mul 50 773; mul 90 776; add 775 777; mul 53 773; mul 47 87; add 779 780; mul 94 781; add 778 782; mul 47 99;
mul 98 784; add 783 785; input p 187; mul 122 755; add 787 788; mul 125 758; add 789 790; mul 128 762; add 791 792;
mul 131 765; add 793 794; mul 134 770; add 795 796; mul 143 773; add 797 798; mul 146 776; add 799 800; mul 149 781;
add 801 802; mul 94 784; add 803 804; mul 44 805; add 786 806; mul 42 807; le 191 189; le 189 191; add 809 810; div
182 811; mul 809 812; le 190 10; le 10 190; add 814 815; div 182 816; mul 814 817; mul 813 818; constant
1.6666666666666667; le 197 193; le 193 197; add 821 822; div 182 823; mul 821 824; le 173 196; le 196 173; add 826
827; div 182 828; mul 826 829; mul 199 830; mul 825 831; mul 199 832; mul 198 833; mul 200 832; add 834 835; mul 820
836; sub 819 837; mul 185 838; mul 188 839; mul 204 332; mul 838 841; mul 228 842; add 840 843; mul 224 838; mul 232
845; add 844 846; mul 240 847; mul 186 838; mul 245 849; mul 204 839; mul 205 838; add 851 852; mul 253 853; add 850
854; mul 224 839; mul 257 856; add 855 857; mul 204 842; mul 229 838; add 859 860; mul 265 861; add 858 862; mul 224
842; mul 269 864; add 863 865; mul 224 845; mul 273 867; add 866 868; add 848 869; mul 42 870; mul 284 871; add 808
872; input p 188; mul 299 849; mul 305 853; add 875 876; mul 308 856; add 877 878; mul 314 861; add 879 880; mul 317
864; add 881 882; mul 320 867; add 883 884; mul 284 885; mul 295 886; add 874 887; mul 533 888; mul 332 353; div 182
343; mul 340 891; mul 338 892; mul 338 344; mul 334 338; mul 894 895; sub 893 896; mul 345 897; mul 338 349; mul 895
899; sub 338 900; mul 350 901; add 898 902; mul 890 903; mul 332 440; add 359 363; add 357 906; add 362 907; mul 16
908; mul 185 885; mul 403 838; mul 305 849; mul 384 853; add 912 913; mul 387 856; add 914 915; mul 392 861; add 916
917; mul 395 864; add 918 919; mul 398 867; add 920 921; mul 204 922; add 911 923; add 910 924; mul 381 849; mul 317
853; add 926 927; mul 414 856; add 928 929; mul 420 861; add 930 931; mul 398 864; add 932 933; mul 425 867; add 934
935; mul 224 936; add 925 937; mul 375 938; mul 295 939; add 909 940; mul 350 897; add 941 942; mul 345 901; sub 943
944; mul 905 945; add 904 946; mul 332 443; div 182 948; mul 947 949; mul 330 950; mul 332 951; mul 332 447; mul 332
446; div 182 954; mul 951 955; mul 448 956; mul 953 957; neg 958; mul 332 959; mul 448 960; mul 449 958; sub 961
962; sub 952 963; mul 331 964; mul 463 965; le 456 193; le 193 456; add 967 968; div 182 969; mul 967 970; le 453
455; le 455 453; add 972 973; div 182 974; mul 972 975; mul 951 976; mul 971 977; mul 459 978; mul 457 979; mul 461
978; add 980 981; mul 452 982; add 966 983; mul 468 951; mul 455 985; mul 470 951; add 986 987; mul 466 988; sub 984
989; mul 330 990; mul 477 991; mul 476 945; mul 330 958; mul 440 994; sub 993 995; mul 475 996; add 992 997; mul 332
488; mul 481 901; mul 483 897; sub 1000 1001; mul 999 1002; mul 332 495; mul 481 897; add 941 1005; mul 483 901; add
1006 1007; mul 1004 1008; add 1003 1009; mul 332 498; div 182 1011; mul 1010 1012; mul 479 1013; mul 332 1014; mul
332 502; mul 332 501; div 182 1017; mul 1014 1018; mul 503 1019; mul 1016 1020; neg 1021; mul 332 1022; mul 503
1023; mul 504 1021; sub 1024 1025; sub 1015 1026; mul 480 1027; mul 516 1028; le 509 193; le 193 509; add 1030 1031;
div 182 1032; mul 1030 1033; le 453 508; le 508 453; add 1035 1036; div 182 1037; mul 1035 1038; mul 1014 1039; mul
1034 1040; mul 512 1041; mul 510 1042; mul 514 1041; add 1043 1044; mul 507 1045; add 1029 1046; mul 521 1014; mul
508 1048; mul 523 1014; add 1049 1050; mul 519 1051; sub 1047 1052; mul 479 1053; mul 530 1054; mul 529 1008; mul
479 1021; mul 495 1057; sub 1056 1058; mul 528 1059; add 1055 1060; add 998 1061; mul 328 1062; sub 889 1063; sub
873 1064; mul 41 1065; mul 537 991; mul 476 903; mul 353 994; sub 1068 1069; mul 475 1070; add 1067 1071; mul 539
1054; mul 529 1002; mul 488 1057; sub 1074 1075; mul 528 1076; add 1073 1077; add 1072 1078; sub 1066 1079; sub 753
1080; mul 548 901; mul 547 1082; mul 338 338; mul 895 1084; mul 546 1085; mul 546 547; mul 343 895; mul 337 892; add
1088 1089; mul 1087 1090; add 1086 1091; mul 549 1092; sub 1083 1093; mul 47 805; mul 42 1095; mul 558 839; mul 563
842; add 1097 1098; mul 566 845; add 1099 1100; mul 240 1101; mul 253 849; mul 580 853; add 1103 1104; mul 583 856;
add 1105 1106; mul 588 861; add 1107 1108; mul 591 864; add 1109 1110; mul 594 867; add 1111 1112; add 1102 1113;
mul 42 1114; mul 555 1115; mul 553 832; mul 601 1117; sub 1116 1118; add 1096 1119; mul 555 922; mul 403 1117; sub
1121 1122; mul 295 1123; add 358 1124; mul 533 1125; mul 606 1062; sub 1126 1127; sub 1120 1128; mul 615 991; mul
609 903; sub 942 944; mul 353 1132; add 1131 1133; mul 611 945; mul 440 903; add 1135 1136; sub 1134 1137; mul 476
1138; mul 613 994; sub 1139 1140; mul 547 1141; mul 614 1092; sub 1142 1143; mul 475 1144; add 1130 1145; mul 623
1054; mul 617 1002; add 1005 1007; mul 488 1149; add 1148 1150; mul 619 1008; sub 1001 1000; mul 495 1153; add 1152
1154; add 1151 1155; mul 529 1156; mul 621 1057; sub 1157 1158; mul 547 1159; mul 622 1092; sub 1160 1161; mul 528
1162; add 1147 1163; add 1146 1164; add 1129 1165; add 30 1166; sub 1094 1167; input p 189; mul 639 755; add 1169
1170; mul 642 758; add 1171 1172; mul 645 762; add 1173 1174; mul 125 765; add 1175 1176; mul 650 770; add 1177
1178; mul 55 773; add 1179 1180; mul 655 776; add 1181 1182; mul 67 781; add 1183 1184; mul 155 784; add 1185 1186;
mul 51 805; add 1187 1188; mul 42 1189; mul 232 839; mul 680 842; add 1191 1192; mul 683 845; add 1193 1194; mul 240
1195; mul 577 849; mul 269 853; add 1197 1198; mul 698 856; add 1199 1200; mul 704 861; add 1201 1202; mul 594 864;
add 1203 1204; mul 709 867; add 1205 1206; add 1196 1207; mul 556 849; mul 228 853; add 1209 1210; mul 232 856; add
1211 1212; mul 730 861; add 1213 1214; mul 680 864; add 1215 1216; mul 569 867; add 1217 1218; mul 717 1219; add
1208 1220; mul 42 1221; mul 672 1222; add 1190 1223; mul 672 936; mul 295 1225; add 361 1226; mul 533 1227; mul 747
1062; sub 1228 1229; sub 1224 1230; neg 1231; input p 190; add 52 53; mul 55 1234; add 1233 1235; mul 50 1234; add
56 1237; mul 59 1238; add 1236 1239; mul 51 761; mul 63 1241; add 1240 1242; mul 50 1241; add 64 1244; mul 67 1245;
add 1243 1246; mul 53 1241; mul 51 64; add 1248 1249; mul 71 1250; add 1247 1251; mul 45 78; add 1252 1253; mul 79
332; mul 82 1255; add 1254 1256; mul 45 51; mul 86 1258; add 1257 1259; mul 50 1258; add 87 1261; mul 90 1262; add
1260 1263; mul 53 1258; mul 51 87; add 1265 1266; mul 94 1267; add 1264 1268; mul 51 99; mul 98 1270; add 1269 1271;
mul 50 332; mul 111 1273; add 108 1274; mul 50 1273; add 112 1276; mul 115 1277; add 1275 1278; input p 191; add
1279 1280; mul 122 1234; add 1281 1282; mul 125 1238; add 1283 1284; mul 128 1241; add 1285 1286; mul 131 1245; add
1287 1288; mul 134 1250; add 1289 1290; mul 45 55; add 1291 1292; mul 59 1255; add 1293 1294; mul 143 1258; add 1295
1296; mul 146 1262; add 1297 1298; mul 149 1267; add 1299 1300; mul 99 155; add 1301 1302; mul 94 1270; add 1303
1304; mul 44 1305; add 1272 1306; mul 42 1307; le 211 209; le 209 211; add 1309 1310; div 182 1311; mul 1309 1312;
le 210 50; le 50 210; add 1314 1315; div 182 1316; mul 1314 1317; mul 1313 1318; constant 0.625; le 217 213; le 213
217; add 1321 1322; div 182 1323; mul 1321 1324; le 173 216; le 216 173; add 1326 1327; div 182 1328; mul 1326 1329;
mul 219 1330; mul 1325 1331; mul 219 1332; mul 218 1333; mul 220 1332; add 1334 1335; mul 1320 1336; sub 1319 1337;
mul 185 1338; mul 208 1339; mul 204 1338; mul 232 1341; add 1340 1342; mul 224 332; mul 1338 1344; mul 236 1345; add
1343 1346; mul 240 1347; mul 224 1345; mul 237 1338; add 1349 1350; mul 239 1351; add 1348 1352; mul 186 1338; mul
249 1354; mul 205 1338; mul 257 1356; add 1355 1357; mul 224 1339; mul 225 1338; add 1359 1360; mul 261 1361; add
1358 1362; mul 229 1338; mul 269 1364; add 1363 1365; mul 224 1341; mul 233 1338; add 1367 1368; mul 273 1369; add
1366 1370; mul 277 1351; add 1371 1372; add 1353 1373; mul 42 1374; mul 284 1375; add 1308 1376; input p 192; mul
302 1354; mul 308 1356; add 1379 1380; mul 311 1361; add 1381 1382; mul 317 1364; add 1383 1384; mul 320 1369; add
1385 1386; mul 323 1351; add 1387 1388; mul 284 1389; mul 295 1390; add 1378 1391; mul 533 1392; add 370 371; add
368 1394; mul 16 1395; mul 185 1389; mul 381 1354; mul 387 1356; add 1398 1399; mul 320 1361; add 1400 1401; mul 395
1364; add 1402 1403; mul 398 1369; add 1404 1405; mul 401 1351; add 1406 1407; mul 204 1408; add 1397 1409; mul 430
1338; mul 311 1354; mul 414 1356; add 1412 1413; mul 417 1361; add 1414 1415; mul 398 1364; add 1416 1417; mul 425
1369; add 1418 1419; mul 428 1351; add 1420 1421; mul 224 1422; add 1411 1423; add 1410 1424; mul 375 1425; mul 295
1426; add 1396 1427; mul 905 1428; mul 949 1429; mul 330 1430; mul 332 1431; mul 955 1431; mul 448 1433; mul 953
1434; neg 1435; mul 332 1436; mul 448 1437; mul 449 1435; sub 1438 1439; sub 1432 1440; mul 331 1441; mul 463 1442;
mul 976 1431; mul 971 1444; mul 459 1445; mul 457 1446; mul 461 1445; add 1447 1448; mul 452 1449; add 1443 1450;
mul 468 1431; mul 455 1452; mul 470 1431; add 1453 1454; mul 466 1455; sub 1451 1456; mul 330 1457; mul 477 1458;
mul 476 1428; mul 330 1435; mul 440 1461; sub 1460 1462; mul 475 1463; add 1459 1464; mul 1004 1428; mul 1012 1466;
mul 479 1467; mul 332 1468; mul 1018 1468; mul 503 1470; mul 1016 1471; neg 1472; mul 332 1473; mul 503 1474; mul
504 1472; sub 1475 1476; sub 1469 1477; mul 480 1478; mul 516 1479; mul 1039 1468; mul 1034 1481; mul 512 1482; mul
510 1483; mul 514 1482; add 1484 1485; mul 507 1486; add 1480 1487; mul 521 1468; mul 508 1489; mul 523 1468; add
1490 1491; mul 519 1492; sub 1488 1493; mul 479 1494; mul 530 1495; mul 529 1428; mul 479 1472; mul 495 1498; sub
1497 1499; mul 528 1500; add 1496 1501; add 1465 1502; mul 328 1503; sub 1393 1504; sub 1377 1505; mul 41 1506; mul
537 1458; mul 353 1461; mul 475 1509; sub 1508 1510; mul 539 1495; mul 488 1498; mul 528 1513; sub 1512 1514; add
1511 1515; sub 1507 1516; neg 1517; mul 47 1305; mul 42 1519; mul 232 1339; mul 566 1341; add 1521 1522; mul 569
1345; add 1523 1524; mul 240 1525; mul 571 1351; add 1526 1527; mul 577 1354; mul 583 1356; add 1529 1530; mul 273
1361; add 1531 1532; mul 591 1364; add 1533 1534; mul 594 1369; add 1535 1536; mul 597 1351; add 1537 1538; add 1528
1539; mul 42 1540; mul 555 1541; add 1520 1542; mul 555 1408; mul 295 1544; add 361 1545; mul 533 1546; mul 606
1503; sub 1547 1548; sub 1543 1549; mul 615 1458; mul 611 1428; mul 476 1552; mul 613 1461; add 1553 1554; mul 547
1555; mul 475 1556; sub 1551 1557; mul 623 1495; mul 619 1428; mul 529 1560; mul 621 1498; sub 1561 1562; mul 547
1563; mul 528 1564; add 1559 1565; add 1558 1566; add 1550 1567; neg 1568; mul 631 1273; add 629 1570; mul 634 1277;
add 1571 1572; input p 193; add 1573 1574; mul 639 1234; add 1575 1576; mul 642 1238; add 1577 1578; mul 645 1241;
add 1579 1580; mul 125 1245; add 1581 1582; mul 650 1250; add 1583 1584; mul 55 1258; add 1585 1586; mul 655 1262;
add 1587 1588; mul 67 1267; add 1589 1590; mul 82 99; add 1591 1592; mul 155 1270; add 1593 1594; mul 51 1305; add
1595 1596; mul 42 1597; mul 677 1339; mul 683 1341; add 1599 1600; mul 686 1345; add 1601 1602; mul 240 1603; mul
688 1351; add 1604 1605; mul 261 1354; mul 698 1356; add 1607 1608; mul 701 1361; add 1609 1610; mul 594 1364; add
1611 1612; mul 709 1369; add 1613 1614; mul 712 1351; add 1615 1616; add 1606 1617; mul 716 1345; mul 739 1619; mul
673 1354; mul 232 1356; add 1621 1622; mul 236 1361; add 1623 1624; mul 680 1364; add 1625 1626; mul 569 1369; add
1627 1628; mul 737 1351; add 1629 1630; mul 717 1631; add 1620 1632; add 1618 1633; mul 42 1634; mul 672 1635; mul
670 1332; mul 742 1637; sub 1636 1638; add 1598 1639; mul 672 1422; mul 430 1637; sub 1641 1642; mul 295 1643; add
369 1644; mul 533 1645; mul 747 1503; sub 1646 1647; sub 1640 1648; neg 1649; store forces 0 544; store forces 1
628; store forces 2 750; store by_shape 0 1081; store by_shape 2 1168; store by_shape 4 1232; store by_shape 1 1518;
store by_shape 3 1569; store by_shape 5 1650
    """,
)

INERTIA = Graph(
    {'x': 14, 'p': 194},
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
    {'x': 14, 'z': 4, 'start': 2, 'p': 194},
    {'moved': 4},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 129; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 130; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 132; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 134; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
136; mul 11 30; add 29 31; max 1 32; min 0 33; store moved 0 16; store moved 1 22; store moved 2 28; store moved 3
34
    """,
)
