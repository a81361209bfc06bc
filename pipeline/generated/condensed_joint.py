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
    'shortening_qqtb', 'shortening_qttt', 'shortening_qttb', 'shortening_tttt', 'shortening_tttb', 'mass',
    'cross', 'inertia', 'gyration', 'interior_inertia', 'rise_qq', 'rise_qt', 'rise_tt', 'rise_qb', 'rise_tb',
    'rise_bb', 'weight', 'offset', 'side_force', 'relaxation_0', 'relaxation_1', 'relaxation_2', 'strain_slope',
    'viscosity', 'drag', 'sliding_force', 'sliding_speed', 'friction_arm', 'left_a', 'left_c', 'left_e_z',
    'left_e_x', 'left_l0', 'left_elastic', 'left_hardening', 'left_hardening_slope', 'left_electric',
    'left_electric_slope', 'left_maxwell_0', 'left_maxwell_1', 'left_maxwell_2', 'left_viscous', 'right_a',
    'right_c', 'right_e_z', 'right_e_x', 'right_l0', 'right_elastic', 'right_hardening', 'right_hardening_slope',
    'right_electric', 'right_electric_slope', 'right_maxwell_0', 'right_maxwell_1', 'right_maxwell_2',
    'right_viscous', 'stop_force_0', 'stop_force_1', 'stop_force_2', 'stop_force_3', 'stop_force_4',
    'stop_force_5', 'stop_travel_0', 'stop_travel_1', 'stop_travel_2', 'stop_travel_3', 'stop_travel_4',
    'stop_travel_5', 'creep_stiffness_0', 'creep_stiffness_1', 'creep_rate_0', 'creep_rate_1', 'slope_ratio')

TIP_CONSTANTS = (('drag', 0.02, 1.2, 'N·s²/m²'), ('sliding_force', 0.0001, 1.2, 'N'), ('sliding_speed', 0.006, 0.5, 'm/s'))

CORRECTIONS = ('force', 'damping', 'left', 'right', 'moment', 'stiffness', 'left_moment', 'right_moment', 'loss',
    'moment_q', 'stiffness_q', 'left_moment_q', 'right_moment_q')

STATES = 14

ELEMENT_STATES = (('creep_0', 'm'), ('creep_1', 'm'))

FIRST_STRAIN = 6

QUARTICS = ('qqqq', 'qqqt', 'qqqb', 'qqtt', 'qqtb', 'qqbb', 'qttt', 'qttb', 'qtbb', 'qbbb', 'tttt', 'tttb', 'ttbb',
    'tbbb', 'bbbb')

SEXTICS = ('qqqbbb', 'qqtbbb', 'qqbbbb', 'qttbbb', 'qtbbbb', 'qbbbbb', 'tttbbb', 'ttbbbb', 'tbbbbb', 'bbbbbb')

SHORTENINGS = ('qqqq', 'qqqt', 'qqqb', 'qqtt', 'qqtb', 'qttt', 'qttb', 'tttt', 'tttb')

FIRST_ELEMENT = 12

DRY_LEVELS = ('sliding_force',)

AT_REST = (1.0, 1.0)

STOPS = 6

CREEPS = 2

BRANCHES = 3

SHAPES = ((0.37142857142857144, -0.05238095238095238, 0.016666666666666666), (-0.05238095238095238,
    0.009523809523809525, -0.0035714285714285713), (0.016666666666666666, -0.0035714285714285713,
    0.0015873015873015873))

SLOPES = ((1.2, -0.1, 0.0), (-0.1, 0.13333333333333333, -0.03333333333333333), (0.0, -0.03333333333333333,
    0.01904761904761905))

BENDS = ((12.0, -6.0, 0.0), (-6.0, 4.0, 0.0), (0.0, 0.0, 0.8))

PREPARE = Graph(
    {'k': 112},
    {'p': 187},
    """
input k 46; input k 47; constant 1.0; input k 9; sub 3 2; input k 44; input k 56; input k 50; input k 51; input k
53; input k 48; input k 52; input k 54; input k 49; input k 45; input k 111; input k 0; div 2 16; mul 15 17;
constant 0.5; constant -0.5; input k 2; mul 20 21; input k 7; mul 23 23; mul 22 24; constant 4.0; input k 6; mul 15
23; add 27 28; mul 29 29; mul 26 30; constant -12.0; mul 29 32; add 31 33; constant 12.0; add 34 35; div 2 35; mul
36 37; input k 8; mul 39 39; constant 0.8; div 2 41; mul 40 42; add 38 43; div 2 44; mul 25 45; input k 62; input k
1; constant -6.000000000000002; constant -18.000000000000004; input k 5; mul 51 51; input k 4; mul 52 53; mul 50 54;
add 49 55; constant -0.09999999999999992; input k 3; mul 52 58; mul 57 59; add 56 60; constant 28.80000000000001;
mul 51 53; mul 62 63; constant -22.628571428571426; mul 53 65; constant -0.0571428571428573; mul 58 67; add 66 68;
constant 36.0; mul 63 70; constant -28.799999999999997; mul 53 72; constant 0.05714285714285805; mul 58 74; add 73
75; constant -50.400000000000006; mul 53 77; constant -1.1428571428571421; mul 58 79; add 78 80; constant
12.000000000000004; constant 36.000000000000014; mul 54 83; add 82 84; constant 1.1999999999999995; mul 59 86; add
85 87; constant -57.60000000000002; mul 63 89; constant 45.25714285714285; mul 53 91; constant 0.9142857142857148;
mul 58 93; add 92 94; constant -72.00000000000001; mul 63 96; constant 57.59999999999996; mul 53 98; constant
-1.7142857142857146; mul 58 100; add 99 101; constant 230.40000000000006; mul 53 103; constant 2.057142857142853;
mul 58 105; add 104 106; constant -388.80000000000024; mul 53 108; constant -7.71428571428571; mul 58 110; add 109
111; constant 259.2000000000001; mul 53 113; constant 12.342857142857142; mul 58 115; add 114 116; constant
-0.9999999999999998; mul 51 118; mul 51 52; mul 53 120; mul 118 121; add 119 122; constant -0.03333333333333334; mul
59 124; constant -2.399999999999998; mul 63 126; constant 0.45714285714285574; mul 53 128; constant
-0.019047619047619042; mul 58 130; add 129 131; constant 4.000000000000001; mul 35 54; add 133 134; constant
0.13333333333333333; mul 59 136; add 135 137; constant -14.400000000000006; mul 63 139; constant 13.714285714285712;
mul 53 141; constant 0.11428571428571417; mul 58 143; add 142 144; constant -30.000000000000007; mul 63 146; mul 51
58; sub 147 148; constant 21.599999999999998; mul 53 150; constant 0.6571428571428561; mul 58 152; add 151 153;
constant 35.20000000000001; mul 53 155; constant 2.438095238095238; mul 58 157; add 156 158; constant 72.0; mul 63
160; constant -57.599999999999994; mul 53 162; constant 0.1142857142857161; mul 58 164; add 163 165; constant
-151.20000000000002; mul 53 167; constant -3.428571428571426; mul 58 169; add 168 170; constant -36.00000000000001;
mul 63 172; constant 28.79999999999998; mul 53 174; constant -0.8571428571428573; mul 58 176; add 175 177; constant
-129.60000000000008; mul 53 179; constant -2.57142857142857; mul 58 181; add 180 182; constant 3.0; input k 25; mul
184 185; input k 26; constant 2.0; mul 187 188; input k 27; mul 188 190; input k 28; input k 29; input k 30; input k
10; mul 26 195; input k 11; mul 184 197; input k 12; mul 184 199; input k 13; mul 188 201; input k 14; mul 188 203;
input k 15; mul 188 205; input k 16; input k 17; input k 18; input k 19; input k 55; input k 72; input k 67; input k
69; input k 68; input k 70; sub 216 16; input k 35; mul 26 218; input k 36; mul 184 220; input k 37; mul 184 222;
input k 38; mul 188 224; input k 39; mul 188 226; input k 40; input k 41; mul 184 228; mul 188 229; input k 42; mul
26 232; input k 43; mul 184 234; input k 71; div 2 236; input k 73; input k 74; input k 75; input k 76; mul 19 241;
constant 0.7142857142857143; sub 241 243; mul 242 244; input k 77; input k 78; input k 79; input k 61; mul 19 249;
sub 249 243; mul 250 251; input k 80; input k 86; input k 82; input k 81; input k 83; input k 84; sub 258 16; input
k 85; div 2 260; input k 87; input k 88; input k 89; input k 90; mul 19 265; sub 265 243; mul 266 267; input k 91;
input k 92; input k 93; input k 94; input k 57; input k 95; input k 66; input k 101; div 2 276; input k 96; input k
102; div 2 279; input k 97; input k 103; div 2 282; input k 98; input k 104; div 2 285; input k 99; input k 105; div
2 288; input k 100; input k 106; div 2 291; input k 63; input k 64; input k 65; mul 295 295; input k 107; input k
108; mul 3 188; mul 188 192; input k 31; mul 184 301; input k 32; mul 188 303; input k 33; mul 184 207; mul 188 208;
input k 20; mul 26 308; input k 21; mul 184 310; input k 22; mul 188 312; input k 23; mul 6 211; constant 2.4; mul
54 316; add 41 317; constant 0.019047619047619053; mul 59 319; add 318 320; constant -1.3714285714285719; mul 63
322; constant 1.371428571428571; mul 53 324; constant 0.007256235827664402; mul 58 326; add 325 327; constant
-4.799999999999996; mul 63 329; constant 1.3714285714285672; mul 53 331; constant -0.05714285714285713; mul 58 333;
add 332 334; constant -7.200000000000003; mul 63 336; constant 7.199999999999999; mul 53 338; constant
0.2190476190476187; mul 58 340; add 339 341; constant -45.25714285714285; mul 53 343; constant -0.1142857142857146;
mul 58 345; add 344 346; constant -28.80000000000001; mul 63 348; mul 188 194; mul 188 305; input k 34; mul 184 352;
mul 188 209; mul 184 210; mul 184 314; input k 24; mul 26 357; mul 21 41; input k 58; input k 59; input k 60; input
k 109; input k 110; mul 23 61; mul 23 138; mul 23 125; mul 39 61; mul 39 138; mul 39 125; store p 0 0; store p 1 3;
store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10
11; store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 46; store p 16 47; store p 17 17; store p
18 48; store p 19 61; store p 20 27; store p 21 23; store p 22 39; store p 23 64; store p 24 69; store p 25 71;
store p 26 76; store p 27 81; store p 28 88; store p 29 90; store p 30 95; store p 31 97; store p 32 102; store p 33
107; store p 34 112; store p 35 117; store p 36 123; store p 37 125; store p 38 127; store p 39 132; store p 40 138;
store p 41 140; store p 42 145; store p 43 149; store p 44 154; store p 45 159; store p 46 161; store p 47 166;
store p 48 171; store p 49 173; store p 50 178; store p 51 183; store p 52 186; store p 53 189; store p 54 191;
store p 55 192; store p 56 193; store p 57 194; store p 58 196; store p 59 198; store p 60 200; store p 61 202;
store p 62 204; store p 63 206; store p 64 207; store p 65 208; store p 66 209; store p 67 210; store p 68 21; store
p 69 219; store p 70 221; store p 71 223; store p 72 225; store p 73 227; store p 74 228; store p 75 229; store p 76
211; store p 77 217; store p 78 16; store p 79 220; store p 80 226; store p 81 230; store p 82 231; store p 83 233;
store p 84 235; store p 85 222; store p 86 234; store p 87 215; store p 88 213; store p 89 237; store p 90 214;
store p 91 212; store p 92 238; store p 93 239; store p 94 240; store p 95 241; store p 96 245; store p 97 246;
store p 98 247; store p 99 248; store p 100 249; store p 101 252; store p 102 253; store p 103 259; store p 104 255;
store p 105 256; store p 106 261; store p 107 257; store p 108 254; store p 109 262; store p 110 263; store p 111
264; store p 112 265; store p 113 268; store p 114 269; store p 115 270; store p 116 271; store p 117 272; store p
118 273; store p 119 274; store p 120 275; store p 121 277; store p 122 278; store p 123 280; store p 124 281; store
p 125 283; store p 126 284; store p 127 286; store p 128 287; store p 129 289; store p 130 290; store p 131 292;
store p 132 293; store p 133 294; store p 134 296; store p 135 297; store p 136 298; store p 137 299; store p 138
187; store p 139 300; store p 140 302; store p 141 304; store p 142 305; store p 143 197; store p 144 203; store p
145 306; store p 146 307; store p 147 309; store p 148 311; store p 149 313; store p 150 314; store p 151 315; store
p 152 321; store p 153 323; store p 154 328; store p 155 330; store p 156 335; store p 157 337; store p 158 342;
store p 159 347; store p 160 349; store p 161 190; store p 162 350; store p 163 303; store p 164 351; store p 165
353; store p 166 199; store p 167 354; store p 168 355; store p 169 310; store p 170 356; store p 171 358; store p
172 185; store p 173 301; store p 174 352; store p 175 359; store p 176 360; store p 177 361; store p 178 362; store
p 179 363; store p 180 364; store p 181 365; store p 182 366; store p 183 367; store p 184 368; store p 185 369;
store p 186 370
    """,
)

RATES = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 6, 'start': 2, 'p': 187},
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
261; input p 51; mul 206 263; add 262 264; mul 147 265; add 208 266; input p 52; constant 0.5249999999999999;
constant -0.5249999999999999; max 270 148; min 269 271; constant 0.35; sub 272 273; max 140 274; mul 275 275;
constant -0.35; sub 277 272; max 140 278; mul 279 279; sub 276 280; div 2 273; mul 281 282; sub 272 283; mul 284
284; mul 268 285; input p 53; constant 0.8999999999999999; constant -0.8999999999999999; max 289 3; min 288 290;
constant 0.6; sub 291 292; max 140 293; mul 294 294; constant -0.6; sub 296 291; max 140 297; mul 298 298; sub 295
299; div 2 292; mul 300 301; sub 291 302; mul 284 303; mul 287 304; add 286 305; input p 54; constant
2.4000000000000004; constant -2.4000000000000004; max 309 35; min 308 310; constant 1.6; sub 311 312; max 140 313;
mul 314 314; constant -1.6; sub 316 311; max 140 317; mul 318 318; sub 315 319; div 2 312; mul 320 321; sub 311 322;
mul 284 323; mul 307 324; add 306 325; input p 55; mul 303 303; mul 327 328; add 326 329; input p 56; mul 303 323;
mul 331 332; add 330 333; input p 57; mul 323 323; mul 335 336; add 334 337; mul 323 336; mul 338 339; input p 58;
mul 284 285; mul 341 342; input p 59; mul 285 303; mul 344 345; add 343 346; input p 60; mul 285 323; mul 348 349;
add 347 350; input p 61; mul 303 304; mul 352 353; add 351 354; input p 62; mul 304 323; mul 356 357; add 355 358;
input p 63; mul 323 324; mul 360 361; add 359 362; input p 64; mul 303 328; mul 364 365; add 363 366; input p 65;
mul 323 328; mul 368 369; add 367 370; input p 66; mul 323 332; mul 372 373; add 371 374; input p 67; mul 339 376;
add 375 377; add 340 378; constant 5.714285714285714; add 275 279; mul 380 381; sub 2 382; mul 379 383; add 267 384;
mul 145 385; input p 68; constant 12.0; mul 0 144; mul 388 389; constant -6.0; mul 147 389; mul 130 150; add 392
393; input x 5; mul 153 395; add 394 396; mul 391 397; add 390 398; mul 387 399; mul 389 391; constant 4.0; mul 397
402; add 401 403; mul 387 404; mul 147 405; add 400 406; add 386 407; mul 144 408; input p 69; mul 342 410; input p
70; mul 345 412; add 411 413; input p 71; mul 349 415; add 414 416; input p 72; mul 353 418; add 417 419; input p
73; mul 357 421; add 420 422; input p 74; mul 365 424; add 423 425; input p 75; mul 369 427; add 426 428; mul 383
429; add 67 430; input p 76; input p 77; mul 29 67; mul 3 37; add 434 435; mul 35 53; add 436 437; mul 104 438;
input p 78; constant 0.25; mul 284 429; input p 79; mul 342 443; mul 345 418; add 444 445; input p 80; mul 349 447;
add 446 448; input p 81; mul 353 450; add 449 451; input p 82; mul 357 453; add 452 454; input p 83; mul 365 456;
add 455 457; input p 84; mul 369 459; add 458 460; mul 303 461; add 442 462; input p 85; mul 342 464; mul 345 447;
add 465 466; mul 353 427; add 467 468; input p 86; mul 365 470; add 469 471; mul 323 472; add 463 473; mul 441 474;
mul 440 475; add 439 476; add 433 477; input p 87; mul 24 479; add 478 480; input p 88; mul 38 482; sub 481 483;
input p 89; mul 24 482; input p 90; sub 486 487; mul 38 479; add 488 489; sub 490 29; mul 491 491; mul 484 484; add
492 493; sqrt 494; mul 485 495; sqrt 496; div 2 497; mul 498 498; mul 485 499; mul 484 500; input p 91; constant
2.0; mul 496 503; mul 499 503; mul 499 505; sub 504 506; mul 502 507; constant 0.3; constant -0.3; constant 1.4; sub
496 511; max 510 512; min 509 513; input p 92; input p 93; mul 514 516; add 515 517; mul 514 518; add 2 519; mul 508
520; input p 94; mul 93 522; input p 95; input p 96; mul 512 525; add 524 526; mul 512 527; add 2 528; mul 523 529;
sub 521 530; mul 485 531; input p 97; input x 6; mul 533 534; input p 98; input x 8; mul 536 537; add 535 538; input
p 99; input x 10; mul 540 541; add 539 542; constant -0.5; mul 498 544; mul 498 545; mul 498 546; mul 485 547; input
p 100; input p 101; mul 512 550; add 549 551; mul 512 552; add 2 553; mul 548 554; mul 543 555; add 532 556; input p
102; mul 555 558; mul 555 559; sub 480 483; mul 491 561; add 486 489; mul 484 563; sub 562 564; mul 500 565; mul 17
566; mul 130 567; mul 491 500; mul 0 569; sub 568 570; mul 0 431; constant 3.3333333333333335; add 294 298; mul 573
574; sub 2 575; mul 461 576; mul 440 577; add 37 578; mul 130 579; add 572 580; constant 1.25; add 314 318; mul 582
583; sub 2 584; mul 472 585; mul 440 586; add 53 587; mul 395 588; add 581 589; mul 501 590; add 571 591; mul 560
592; add 557 593; mul 501 594; input p 103; add 477 596; input p 104; mul 24 598; add 597 599; input p 105; mul 38
601; add 600 602; input p 106; mul 38 598; mul 24 601; input p 107; sub 606 607; sub 605 608; sub 609 29; mul 610
610; mul 603 603; add 611 612; sqrt 613; mul 604 614; sqrt 615; div 2 616; mul 617 617; mul 604 618; mul 603 619;
input p 108; mul 503 615; mul 503 618; mul 618 623; sub 622 624; mul 621 625; sub 615 511; max 510 627; min 509 628;
input p 109; input p 110; mul 629 631; add 630 632; mul 629 633; add 2 634; mul 626 635; input p 111; mul 97 637;
input p 112; input p 113; mul 627 640; add 639 641; mul 627 642; add 2 643; mul 638 644; sub 636 645; mul 604 646;
input p 114; input x 7; mul 648 649; input p 115; input x 9; mul 651 652; add 650 653; input p 116; input x 11; mul
655 656; add 654 657; mul 544 617; mul 617 659; mul 617 660; mul 604 661; mul 550 627; add 549 663; mul 627 664; add
2 665; mul 662 666; mul 658 667; add 647 668; input p 117; mul 667 670; mul 667 671; add 599 602; mul 610 673; sub
606 605; mul 603 675; add 674 676; mul 619 677; mul 17 678; mul 130 679; mul 610 619; mul 0 681; sub 680 682; mul
590 620; add 683 684; mul 672 685; add 669 686; mul 620 687; add 595 688; sub 432 689; mul 431 690; sub 409 691; mul
569 594; mul 681 687; add 693 694; sub 692 695; sub 143 696; input p 118; input p 119; constant -1.0; input z 0;
input start 0; sub 29 702; input p 120; input start 1; sub 3 705; mul 704 706; add 703 707; input p 121; mul 708
709; add 701 710; max 700 711; min 2 712; mul 699 713; input p 122; input z 1; input p 123; mul 708 717; add 716
718; max 700 719; min 2 720; mul 715 721; add 714 722; input p 124; input z 2; input p 125; mul 708 726; add 725
727; max 700 728; min 2 729; mul 724 730; add 723 731; input p 126; input z 3; input p 127; mul 708 735; add 734
736; max 700 737; min 2 738; mul 733 739; add 732 740; input p 128; input z 4; input p 129; mul 708 744; add 743
745; max 700 746; min 2 747; mul 742 748; add 741 749; input p 130; input z 5; input p 131; mul 708 753; add 752
754; max 700 755; min 2 756; mul 751 757; add 750 758; sub 698 759; input p 132; abs 0; mul 761 762; mul 0 763;
input p 133; mul 0 765; mul 0 0; input p 134; add 767 768; sqrt 769; div 2 770; mul 766 771; add 764 772; sub 760
773; add 697 774; input p 135; input x 12; sub 29 777; mul 776 778; input p 136; input x 13; sub 29 781; mul 780
782; add 779 783; sub 775 784; mul 0 62; mul 28 130; add 786 787; mul 47 395; add 788 789; mul 0 790; mul 0 28; mul
31 130; add 792 793; mul 34 395; add 794 795; mul 130 796; add 791 797; mul 0 47; mul 34 130; add 799 800; mul 51
395; add 801 802; mul 395 803; add 798 804; mul 17 130; mul 130 806; mul 23 807; input p 137; mul 9 809; mul 9 810;
mul 8 16; mul 10 812; mul 812 813; add 811 814; mul 3 815; mul 38 816; sub 25 817; mul 808 818; add 805 819; mul 67
820; mul 24 816; add 39 822; mul 808 823; sub 821 824; mul 22 825; sub 785 826; mul 90 827; mul 81 89; mul 150 265;
input p 138; mul 285 831; input p 139; mul 304 833; add 832 834; mul 324 331; add 835 836; input p 140; mul 328 838;
add 837 839; input p 141; mul 332 841; add 840 842; input p 142; mul 336 844; add 843 845; mul 339 846; input p 143;
mul 342 848; mul 345 352; add 849 850; input p 144; mul 349 852; add 851 853; input p 145; mul 353 855; add 854 856;
input p 146; mul 357 858; add 857 859; mul 361 372; add 860 861; input p 147; mul 365 863; add 862 864; input p 148;
mul 369 866; add 865 867; input p 149; mul 373 869; add 868 870; input p 150; mul 339 872; add 871 873; add 847 874;
mul 576 875; add 830 876; mul 145 877; mul 579 690; sub 878 879; mul 150 405; add 880 881; mul 567 594; mul 679 687;
add 883 884; add 882 885; sub 134 886; input p 151; mul 38 888; mul 17 889; add 887 890; mul 704 759; sub 891 892;
mul 41 820; mul 26 824; sub 894 895; mul 22 896; mul 19 816; mul 807 898; sub 897 899; sub 893 900; mul 829 901; sub
828 902; mul 86 89; input p 152; mul 35 905; input p 153; mul 214 907; add 906 908; input p 154; mul 218 910; add
909 911; mul 155 210; add 912 913; input p 155; mul 158 915; add 914 916; input p 156; mul 162 918; add 917 919;
input p 157; mul 166 921; add 920 922; mul 170 227; add 923 924; input p 158; mul 174 926; add 925 927; mul 157 189;
add 928 929; input p 159; mul 193 931; add 930 932; mul 169 197; add 933 934; input p 160; mul 201 936; add 935 937;
mul 184 258; add 938 939; mul 202 257; add 940 941; mul 153 265; add 942 943; input p 161; mul 285 945; mul 304 331;
add 946 947; input p 162; mul 324 949; add 948 950; input p 163; mul 328 952; add 951 953; input p 164; mul 332 955;
add 954 956; input p 165; mul 336 958; add 957 959; mul 339 960; input p 166; mul 342 962; mul 345 852; add 963 964;
mul 349 360; add 965 966; mul 353 368; add 967 968; input p 167; mul 357 970; add 969 971; input p 168; mul 361 973;
add 972 974; input p 169; mul 365 976; add 975 977; mul 369 869; add 978 979; input p 170; mul 373 981; add 980 982;
input p 171; mul 339 984; add 983 985; add 961 986; constant 3.0; mul 336 988; input p 172; mul 342 990; mul 345
831; add 991 992; mul 349 945; add 993 994; mul 327 353; add 995 996; mul 331 357; add 997 998; mul 335 361; add 999
1000; input p 173; mul 365 1002; add 1001 1003; mul 369 952; add 1004 1005; mul 373 844; add 1006 1007; input p 174;
mul 339 1009; add 1008 1010; mul 989 1011; add 987 1012; mul 585 1013; add 944 1014; mul 145 1015; mul 588 690; sub
1016 1017; input p 175; mul 395 1019; mul 153 405; add 1020 1021; add 1018 1022; mul 53 820; mul 22 1024; add 1023
1025; mul 904 1026; sub 903 1027; mul 56 70; mul 79 79; sub 1029 1030; mul 89 1031; mul 901 1032; mul 827 829; sub
1033 1034; mul 59 70; mul 76 79; sub 1036 1037; mul 89 1038; mul 1026 1039; add 1035 1040; mul 827 904; mul 901
1039; sub 1042 1043; mul 45 70; mul 76 76; sub 1045 1046; mul 89 1047; mul 1026 1048; sub 1044 1049; mul 555 592;
input p 176; mul 534 1052; sub 1051 1053; mul 667 685; mul 649 1052; sub 1055 1056; input p 177; mul 537 1058; sub
1051 1059; mul 652 1058; sub 1055 1061; input p 178; mul 541 1063; sub 1051 1064; mul 656 1063; sub 1055 1066; input
p 179; mul 778 1068; input p 180; mul 782 1070; store rates 0 0; store rates 1 1028; store rates 2 130; store rates
3 1041; store rates 4 395; store rates 5 1050; store rates 6 1054; store rates 7 1057; store rates 8 1060; store
rates 9 1062; store rates 10 1065; store rates 11 1067; store rates 12 1069; store rates 13 1071
    """,
)

REST_FORCES = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'p': 187},
    {'forces': 3, 'by_shape': 6},
    """
input p 118; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
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
add 158 159; input p 51; mul 104 161; add 160 162; mul 44 163; add 106 164; input p 52; constant 0.5249999999999999;
constant -0.5249999999999999; max 168 45; min 167 169; constant 0.0; constant 0.35; sub 170 172; max 171 173; mul
174 174; constant -0.35; sub 176 170; max 171 177; mul 178 178; sub 175 179; constant 1.0; div 181 172; mul 180 182;
sub 170 183; mul 184 184; mul 166 185; input p 53; constant 0.8999999999999999; constant -0.8999999999999999; max
189 10; min 188 190; constant 0.6; sub 191 192; max 171 193; mul 194 194; constant -0.6; sub 196 191; max 171 197;
mul 198 198; sub 195 199; div 181 192; mul 200 201; sub 191 202; mul 184 203; mul 187 204; add 186 205; input p 54;
constant 2.4000000000000004; constant -2.4000000000000004; max 209 50; min 208 210; constant 1.6; sub 211 212; max
171 213; mul 214 214; constant -1.6; sub 216 211; max 171 217; mul 218 218; sub 215 219; div 181 212; mul 220 221;
sub 211 222; mul 184 223; mul 207 224; add 206 225; input p 55; mul 203 203; mul 227 228; add 226 229; input p 56;
mul 203 223; mul 231 232; add 230 233; input p 57; mul 223 223; mul 235 236; add 234 237; mul 223 236; mul 238 239;
input p 58; mul 184 185; mul 241 242; input p 59; mul 185 203; mul 244 245; add 243 246; input p 60; mul 185 223;
mul 248 249; add 247 250; input p 61; mul 203 204; mul 252 253; add 251 254; input p 62; mul 204 223; mul 256 257;
add 255 258; input p 63; mul 223 224; mul 260 261; add 259 262; input p 64; mul 203 228; mul 264 265; add 263 266;
input p 65; mul 223 228; mul 268 269; add 267 270; input p 66; mul 223 232; mul 272 273; add 271 274; input p 67;
mul 239 276; add 275 277; add 240 278; constant 5.714285714285714; add 174 178; mul 280 281; sub 181 282; mul 279
283; add 165 284; mul 42 285; mul 41 286; input p 12; mul 11 288; input p 6; mul 10 290; add 289 291; input p 10;
mul 50 293; add 292 294; input p 69; mul 242 296; input p 70; mul 245 298; add 297 299; input p 71; mul 249 301; add
300 302; input p 72; mul 253 304; add 303 305; input p 73; mul 257 307; add 306 308; input p 74; mul 265 310; add
309 311; input p 75; mul 269 313; add 312 314; mul 283 315; add 295 316; input p 76; input p 89; input p 91;
constant 2.0; input p 1; mul 10 322; mul 10 323; add 181 324; sqrt 325; div 181 326; input p 2; mul 10 328; mul 10
329; add 181 330; sqrt 331; mul 327 332; input p 88; mul 333 334; input p 90; sub 335 336; mul 10 327; input p 87;
mul 338 339; add 337 340; sub 341 11; mul 342 342; input p 77; mul 11 295; mul 11 290; input p 7; mul 10 347; add
346 348; input p 8; mul 50 350; add 349 351; mul 10 352; add 345 353; mul 11 293; mul 10 350; add 355 356; input p
11; mul 50 358; add 357 359; mul 50 360; add 354 361; mul 16 362; input p 78; constant 0.25; mul 184 315; input p
79; mul 242 367; mul 245 304; add 368 369; input p 80; mul 249 371; add 370 372; input p 81; mul 253 374; add 373
375; input p 82; mul 257 377; add 376 378; input p 83; mul 265 380; add 379 381; input p 84; mul 269 383; add 382
384; mul 203 385; add 366 386; input p 85; mul 242 388; mul 245 371; add 389 390; mul 253 313; add 391 392; input p
86; mul 265 394; add 393 395; mul 223 396; add 387 397; mul 365 398; mul 364 399; add 363 400; add 344 401; mul 333
339; add 402 403; mul 334 338; sub 404 405; mul 406 406; add 343 407; sqrt 408; mul 319 409; mul 321 410; sqrt 410;
div 181 412; mul 413 413; mul 321 414; mul 414 415; sub 411 416; mul 320 417; constant 0.3; constant -0.3; constant
1.4; sub 410 421; max 420 422; min 419 423; input p 92; input p 93; mul 424 426; add 425 427; mul 424 428; add 181
429; mul 418 430; input p 94; mul 3 432; input p 95; input p 96; mul 422 435; add 434 436; mul 422 437; add 181 438;
mul 433 439; sub 431 440; mul 319 441; mul 319 414; mul 406 443; mul 442 444; input p 106; input p 108; input p 104;
mul 338 448; input p 105; mul 333 450; input p 107; sub 451 452; sub 449 453; sub 454 11; mul 455 455; input p 103;
add 401 457; mul 333 448; add 458 459; mul 338 450; add 460 461; mul 462 462; add 456 463; sqrt 464; mul 446 465;
mul 321 466; sqrt 466; div 181 468; mul 469 469; mul 321 470; mul 470 471; sub 467 472; mul 447 473; sub 466 421;
max 420 475; min 419 476; input p 109; input p 110; mul 477 479; add 478 480; mul 477 481; add 181 482; mul 474 483;
input p 111; mul 7 485; input p 112; input p 113; mul 475 488; add 487 489; mul 475 490; add 181 491; mul 486 492;
sub 484 493; mul 446 494; mul 446 470; mul 462 496; mul 495 497; add 445 498; sub 318 499; mul 317 500; sub 287 501;
mul 342 443; mul 442 503; mul 455 496; mul 495 505; add 504 506; sub 502 507; sub 40 508; add 0 509; mul 326 332;
div 181 511; mul 327 512; input p 151; mul 338 514; mul 513 515; mul 47 163; constant 3.3333333333333335; add 194
198; mul 518 519; sub 181 520; input p 138; mul 185 522; input p 139; mul 204 524; add 523 525; mul 224 231; add 526
527; input p 140; mul 228 529; add 528 530; input p 141; mul 232 532; add 531 533; input p 142; mul 236 535; add 534
536; mul 239 537; input p 143; mul 242 539; mul 245 252; add 540 541; input p 144; mul 249 543; add 542 544; input p
145; mul 253 546; add 545 547; input p 146; mul 257 549; add 548 550; mul 261 272; add 551 552; input p 147; mul 265
554; add 553 555; input p 148; mul 269 557; add 556 558; input p 149; mul 273 560; add 559 561; input p 150; mul 239
563; add 562 564; add 538 565; mul 521 566; add 517 567; mul 42 568; mul 385 521; mul 364 570; add 352 571; mul 500
572; sub 569 573; sub 403 405; mul 342 575; add 335 340; mul 406 577; sub 576 578; mul 443 579; mul 513 580; mul 442
581; add 459 461; mul 455 583; sub 451 449; mul 462 585; add 584 586; mul 496 587; mul 513 588; mul 495 589; add 582
590; add 574 591; sub 38 592; add 516 593; input p 152; mul 50 595; input p 153; mul 112 597; add 596 598; input p
154; mul 116 600; add 599 601; mul 53 108; add 602 603; input p 155; mul 56 605; add 604 606; input p 156; mul 60
608; add 607 609; input p 157; mul 64 611; add 610 612; mul 68 125; add 613 614; input p 158; mul 72 616; add 615
617; mul 55 87; add 618 619; input p 159; mul 91 621; add 620 622; mul 67 95; add 623 624; input p 160; mul 99 626;
add 625 627; mul 82 156; add 628 629; mul 100 155; add 630 631; mul 51 163; add 632 633; constant 1.25; add 214 218;
mul 635 636; sub 181 637; input p 161; mul 185 639; mul 204 231; add 640 641; input p 162; mul 224 643; add 642 644;
input p 163; mul 228 646; add 645 647; input p 164; mul 232 649; add 648 650; input p 165; mul 236 652; add 651 653;
mul 239 654; input p 166; mul 242 656; mul 245 543; add 657 658; mul 249 260; add 659 660; mul 253 268; add 661 662;
input p 167; mul 257 664; add 663 665; input p 168; mul 261 667; add 666 668; input p 169; mul 265 670; add 669 671;
mul 269 560; add 672 673; input p 170; mul 273 675; add 674 676; input p 171; mul 239 678; add 677 679; add 655 680;
constant 3.0; mul 236 682; input p 172; mul 242 684; mul 245 522; add 685 686; mul 249 639; add 687 688; mul 227
253; add 689 690; mul 231 257; add 691 692; mul 235 261; add 693 694; input p 173; mul 265 696; add 695 697; mul 269
646; add 698 699; mul 273 535; add 700 701; input p 174; mul 239 703; add 702 704; mul 683 705; add 681 706; mul 638
707; add 634 708; mul 42 709; mul 396 638; mul 364 711; add 360 712; mul 500 713; sub 710 714; neg 715; sub 26 19;
mul 12 30; add 717 718; input p 181; mul 47 50; mul 55 721; add 720 722; mul 50 721; mul 59 724; add 723 725; mul 53
321; mul 47 727; mul 63 728; add 726 729; mul 50 728; mul 67 731; add 730 732; mul 53 728; mul 47 64; add 734 735;
mul 71 736; add 733 737; mul 45 47; mul 86 739; add 738 740; mul 50 739; mul 90 742; add 741 743; mul 53 739; mul 47
87; add 745 746; mul 94 747; add 744 748; mul 47 99; mul 98 750; add 749 751; input p 182; mul 122 721; add 753 754;
mul 125 724; add 755 756; mul 128 728; add 757 758; mul 131 731; add 759 760; mul 134 736; add 761 762; mul 143 739;
add 763 764; mul 146 742; add 765 766; mul 149 747; add 767 768; mul 94 750; add 769 770; mul 44 771; add 752 772;
le 190 188; le 188 190; add 774 775; div 181 776; mul 774 777; le 189 10; le 10 189; add 779 780; div 181 781; mul
779 782; mul 778 783; constant 1.6666666666666667; mul 194 321; le 171 193; le 193 171; add 787 788; div 181 789;
mul 787 790; mul 784 791; mul 786 792; mul 198 321; le 171 197; le 197 171; add 795 796; div 181 797; mul 795 798;
mul 784 799; mul 794 800; add 793 801; mul 785 802; sub 784 803; mul 184 804; mul 187 805; mul 203 321; mul 804 807;
mul 227 808; add 806 809; mul 223 804; mul 231 811; add 810 812; mul 239 813; mul 185 804; mul 244 815; mul 203 805;
mul 204 804; add 817 818; mul 252 819; add 816 820; mul 223 805; mul 256 822; add 821 823; mul 203 808; mul 228 804;
add 825 826; mul 264 827; add 824 828; mul 223 808; mul 268 830; add 829 831; mul 223 811; mul 272 833; add 832 834;
add 814 835; mul 283 836; add 773 837; mul 42 838; mul 41 839; mul 298 815; mul 304 819; add 841 842; mul 307 822;
add 843 844; mul 310 827; add 845 846; mul 313 830; add 847 848; mul 283 849; add 290 850; mul 500 851; mul 321 342;
div 181 332; mul 329 854; mul 327 855; mul 327 333; mul 323 327; mul 857 858; sub 856 859; mul 334 860; mul 327 338;
mul 858 862; sub 327 863; mul 339 864; add 861 865; mul 853 866; mul 321 406; add 348 352; add 346 869; add 351 870;
mul 16 871; mul 184 849; mul 385 804; mul 304 815; mul 374 819; add 875 876; mul 377 822; add 877 878; mul 380 827;
add 879 880; mul 383 830; add 881 882; mul 203 883; add 874 884; add 873 885; mul 371 815; mul 313 819; add 887 888;
mul 394 827; add 889 890; mul 223 891; add 886 892; mul 365 893; mul 364 894; add 872 895; mul 339 860; add 896 897;
mul 334 864; sub 898 899; mul 868 900; add 867 901; mul 321 409; div 181 903; mul 902 904; mul 319 905; mul 321 906;
mul 321 413; mul 321 412; div 181 909; mul 906 910; mul 414 911; mul 908 912; neg 913; mul 321 914; mul 414 915; mul
415 913; sub 916 917; sub 907 918; mul 320 919; mul 430 920; le 423 419; le 419 423; add 922 923; div 181 924; mul
922 925; le 420 422; le 422 420; add 927 928; div 181 929; mul 927 930; mul 906 931; mul 926 932; mul 426 933; mul
424 934; mul 428 933; add 935 936; mul 418 937; add 921 938; mul 435 906; mul 422 940; mul 437 906; add 941 942; mul
433 943; sub 939 944; mul 319 945; mul 444 946; mul 443 900; mul 319 913; mul 406 949; sub 948 950; mul 442 951; add
947 952; mul 321 455; mul 448 864; mul 450 860; sub 955 956; mul 954 957; mul 321 462; mul 448 860; add 896 960; mul
450 864; add 961 962; mul 959 963; add 958 964; mul 321 465; div 181 966; mul 965 967; mul 446 968; mul 321 969; mul
321 469; mul 321 468; div 181 972; mul 969 973; mul 470 974; mul 971 975; neg 976; mul 321 977; mul 470 978; mul 471
976; sub 979 980; sub 970 981; mul 447 982; mul 483 983; le 476 419; le 419 476; add 985 986; div 181 987; mul 985
988; le 420 475; le 475 420; add 990 991; div 181 992; mul 990 993; mul 969 994; mul 989 995; mul 479 996; mul 477
997; mul 481 996; add 998 999; mul 474 1000; add 984 1001; mul 488 969; mul 475 1003; mul 490 969; add 1004 1005;
mul 486 1006; sub 1002 1007; mul 446 1008; mul 497 1009; mul 496 963; mul 446 976; mul 462 1012; sub 1011 1013; mul
495 1014; add 1010 1015; add 953 1016; mul 317 1017; sub 852 1018; sub 840 1019; mul 503 946; mul 443 866; mul 342
949; sub 1022 1023; mul 442 1024; add 1021 1025; mul 505 1009; mul 496 957; mul 455 1012; sub 1028 1029; mul 495
1030; add 1027 1031; add 1026 1032; sub 1020 1033; sub 719 1034; mul 514 864; mul 513 1036; mul 327 327; mul 858
1038; mul 512 1039; mul 512 513; mul 332 858; mul 326 855; add 1042 1043; mul 1041 1044; add 1040 1045; mul 515
1046; sub 1037 1047; mul 47 771; mul 524 805; mul 529 808; add 1050 1051; mul 532 811; add 1052 1053; mul 239 1054;
mul 252 815; mul 546 819; add 1056 1057; mul 549 822; add 1058 1059; mul 554 827; add 1060 1061; mul 557 830; add
1062 1063; mul 560 833; add 1064 1065; add 1055 1066; mul 521 1067; sub 792 800; mul 518 1069; mul 566 1070; sub
1068 1071; add 1049 1072; mul 42 1073; mul 521 883; mul 385 1070; sub 1075 1076; mul 364 1077; add 347 1078; mul 500
1079; mul 572 1017; sub 1080 1081; sub 1074 1082; mul 581 946; mul 575 866; sub 897 899; mul 342 1086; add 1085
1087; mul 577 900; mul 406 866; add 1089 1090; sub 1088 1091; mul 443 1092; mul 579 949; sub 1093 1094; mul 513
1095; mul 580 1046; sub 1096 1097; mul 442 1098; add 1084 1099; mul 589 1009; mul 583 957; add 960 962; mul 455
1103; add 1102 1104; mul 585 963; sub 956 955; mul 462 1107; add 1106 1108; add 1105 1109; mul 496 1110; mul 587
1012; sub 1111 1112; mul 513 1113; mul 588 1046; sub 1114 1115; mul 495 1116; add 1101 1117; add 1100 1118; add 1083
1119; add 30 1120; sub 1048 1121; input p 183; mul 605 721; add 1123 1124; mul 608 724; add 1125 1126; mul 611 728;
add 1127 1128; mul 125 731; add 1129 1130; mul 616 736; add 1131 1132; mul 55 739; add 1133 1134; mul 621 742; add
1135 1136; mul 67 747; add 1137 1138; mul 155 750; add 1139 1140; mul 51 771; add 1141 1142; mul 231 805; mul 646
808; add 1144 1145; mul 649 811; add 1146 1147; mul 239 1148; mul 543 815; mul 268 819; add 1150 1151; mul 664 822;
add 1152 1153; mul 670 827; add 1154 1155; mul 560 830; add 1156 1157; mul 675 833; add 1158 1159; add 1149 1160;
mul 522 815; mul 227 819; add 1162 1163; mul 231 822; add 1164 1165; mul 696 827; add 1166 1167; mul 646 830; add
1168 1169; mul 535 833; add 1170 1171; mul 683 1172; add 1161 1173; mul 638 1174; add 1143 1175; mul 42 1176; mul
638 891; mul 364 1178; add 350 1179; mul 500 1180; mul 713 1017; sub 1181 1182; sub 1177 1183; neg 1184; input p
184; add 52 53; mul 55 1187; add 1186 1188; mul 50 1187; add 56 1190; mul 59 1191; add 1189 1192; mul 51 727; mul 63
1194; add 1193 1195; mul 50 1194; add 64 1197; mul 67 1198; add 1196 1199; mul 53 1194; mul 51 64; add 1201 1202;
mul 71 1203; add 1200 1204; mul 45 78; add 1205 1206; mul 79 321; mul 82 1208; add 1207 1209; mul 45 51; mul 86
1211; add 1210 1212; mul 50 1211; add 87 1214; mul 90 1215; add 1213 1216; mul 53 1211; mul 51 87; add 1218 1219;
mul 94 1220; add 1217 1221; mul 51 99; mul 98 1223; add 1222 1224; mul 50 321; mul 111 1226; add 108 1227; mul 50
1226; add 112 1229; mul 115 1230; add 1228 1231; input p 185; add 1232 1233; mul 122 1187; add 1234 1235; mul 125
1191; add 1236 1237; mul 128 1194; add 1238 1239; mul 131 1198; add 1240 1241; mul 134 1203; add 1242 1243; mul 45
55; add 1244 1245; mul 59 1208; add 1246 1247; mul 143 1211; add 1248 1249; mul 146 1215; add 1250 1251; mul 149
1220; add 1252 1253; mul 99 155; add 1254 1255; mul 94 1223; add 1256 1257; mul 44 1258; add 1225 1259; le 210 208;
le 208 210; add 1261 1262; div 181 1263; mul 1261 1264; le 209 50; le 50 209; add 1266 1267; div 181 1268; mul 1266
1269; mul 1265 1270; constant 0.625; mul 214 321; le 171 213; le 213 171; add 1274 1275; div 181 1276; mul 1274
1277; mul 1271 1278; mul 1273 1279; mul 218 321; le 171 217; le 217 171; add 1282 1283; div 181 1284; mul 1282 1285;
mul 1271 1286; mul 1281 1287; add 1280 1288; mul 1272 1289; sub 1271 1290; mul 184 1291; mul 207 1292; mul 203 1291;
mul 231 1294; add 1293 1295; mul 223 321; mul 1291 1297; mul 235 1298; add 1296 1299; mul 239 1300; mul 223 1298;
mul 236 1291; add 1302 1303; mul 238 1304; add 1301 1305; mul 185 1291; mul 248 1307; mul 204 1291; mul 256 1309;
add 1308 1310; mul 223 1292; mul 224 1291; add 1312 1313; mul 260 1314; add 1311 1315; mul 228 1291; mul 268 1317;
add 1316 1318; mul 223 1294; mul 232 1291; add 1320 1321; mul 272 1322; add 1319 1323; mul 276 1304; add 1324 1325;
add 1306 1326; mul 283 1327; add 1260 1328; mul 42 1329; mul 41 1330; mul 301 1307; mul 307 1309; add 1332 1333; mul
313 1317; add 1334 1335; mul 283 1336; add 293 1337; mul 500 1338; add 359 360; add 357 1340; mul 16 1341; mul 184
1336; mul 371 1307; mul 377 1309; add 1344 1345; mul 383 1317; add 1346 1347; mul 203 1348; add 1343 1349; mul 396
1291; add 1350 1351; mul 365 1352; mul 364 1353; add 1342 1354; mul 868 1355; mul 904 1356; mul 319 1357; mul 321
1358; mul 910 1358; mul 414 1360; mul 908 1361; neg 1362; mul 321 1363; mul 414 1364; mul 415 1362; sub 1365 1366;
sub 1359 1367; mul 320 1368; mul 430 1369; mul 931 1358; mul 926 1371; mul 426 1372; mul 424 1373; mul 428 1372; add
1374 1375; mul 418 1376; add 1370 1377; mul 435 1358; mul 422 1379; mul 437 1358; add 1380 1381; mul 433 1382; sub
1378 1383; mul 319 1384; mul 444 1385; mul 443 1355; mul 319 1362; mul 406 1388; sub 1387 1389; mul 442 1390; add
1386 1391; mul 959 1355; mul 967 1393; mul 446 1394; mul 321 1395; mul 973 1395; mul 470 1397; mul 971 1398; neg
1399; mul 321 1400; mul 470 1401; mul 471 1399; sub 1402 1403; sub 1396 1404; mul 447 1405; mul 483 1406; mul 994
1395; mul 989 1408; mul 479 1409; mul 477 1410; mul 481 1409; add 1411 1412; mul 474 1413; add 1407 1414; mul 488
1395; mul 475 1416; mul 490 1395; add 1417 1418; mul 486 1419; sub 1415 1420; mul 446 1421; mul 497 1422; mul 496
1355; mul 446 1399; mul 462 1425; sub 1424 1426; mul 495 1427; add 1423 1428; add 1392 1429; mul 317 1430; sub 1339
1431; sub 1331 1432; mul 503 1385; mul 342 1388; mul 442 1435; sub 1434 1436; mul 505 1422; mul 455 1425; mul 495
1439; sub 1438 1440; add 1437 1441; sub 1433 1442; neg 1443; mul 47 1258; mul 231 1292; mul 532 1294; add 1446 1447;
mul 535 1298; add 1448 1449; mul 239 1450; mul 537 1304; add 1451 1452; mul 543 1307; mul 549 1309; add 1454 1455;
mul 272 1314; add 1456 1457; mul 557 1317; add 1458 1459; mul 560 1322; add 1460 1461; mul 563 1304; add 1462 1463;
add 1453 1464; mul 521 1465; add 1445 1466; mul 42 1467; mul 521 1348; mul 364 1469; add 350 1470; mul 500 1471; mul
572 1430; sub 1472 1473; sub 1468 1474; mul 581 1385; mul 577 1355; mul 443 1477; mul 579 1388; add 1478 1479; mul
513 1480; mul 442 1481; sub 1476 1482; mul 589 1422; mul 585 1355; mul 496 1485; mul 587 1425; sub 1486 1487; mul
513 1488; mul 495 1489; add 1484 1490; add 1483 1491; add 1475 1492; neg 1493; mul 597 1226; add 595 1495; mul 600
1230; add 1496 1497; input p 186; add 1498 1499; mul 605 1187; add 1500 1501; mul 608 1191; add 1502 1503; mul 611
1194; add 1504 1505; mul 125 1198; add 1506 1507; mul 616 1203; add 1508 1509; mul 55 1211; add 1510 1511; mul 621
1215; add 1512 1513; mul 67 1220; add 1514 1515; mul 82 99; add 1516 1517; mul 155 1223; add 1518 1519; mul 51 1258;
add 1520 1521; mul 643 1292; mul 649 1294; add 1523 1524; mul 652 1298; add 1525 1526; mul 239 1527; mul 654 1304;
add 1528 1529; mul 260 1307; mul 664 1309; add 1531 1532; mul 667 1314; add 1533 1534; mul 560 1317; add 1535 1536;
mul 675 1322; add 1537 1538; mul 678 1304; add 1539 1540; add 1530 1541; mul 682 1298; mul 705 1543; mul 639 1307;
mul 231 1309; add 1545 1546; mul 235 1314; add 1547 1548; mul 646 1317; add 1549 1550; mul 535 1322; add 1551 1552;
mul 703 1304; add 1553 1554; mul 683 1555; add 1544 1556; add 1542 1557; mul 638 1558; sub 1279 1287; mul 635 1560;
mul 707 1561; sub 1559 1562; add 1522 1563; mul 42 1564; mul 396 1561; mul 364 1566; sub 358 1567; mul 500 1568; mul
713 1430; sub 1569 1570; sub 1565 1571; neg 1572; store forces 0 510; store forces 1 594; store forces 2 716; store
by_shape 0 1035; store by_shape 2 1122; store by_shape 4 1185; store by_shape 1 1444; store by_shape 3 1494; store
by_shape 5 1573
    """,
)

INERTIA = Graph(
    {'x': 14, 'p': 187},
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
    {'x': 14, 'z': 6, 'start': 2, 'p': 187},
    {'moved': 6},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 120; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 121; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 123; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 125; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
127; mul 11 30; add 29 31; max 1 32; min 0 33; input z 4; input p 129; mul 11 36; add 35 37; max 1 38; min 0 39;
input z 5; input p 131; mul 11 42; add 41 43; max 1 44; min 0 45; store moved 0 16; store moved 1 22; store moved 2
28; store moved 3 34; store moved 4 40; store moved 5 46
    """,
)

UPRIGHT = Graph(
    {'k': 112},
    {'load': 1},
    """
input k 55; input k 72; input k 67; input k 69; sub 2 3; mul 4 4; input k 70; input k 0; sub 6 7; input k 68; add 8
9; mul 10 10; add 5 11; sqrt 12; input k 71; constant 1.0; div 15 14; mul 13 16; constant 2.0; mul 17 18; sqrt 17;
div 15 20; mul 21 21; mul 18 22; mul 22 23; sub 19 24; mul 1 25; input k 73; input k 74; constant 0.3; constant
-0.3; constant 1.4; sub 17 31; max 30 32; min 29 33; mul 28 34; add 27 35; mul 34 36; add 15 37; mul 26 38; mul 16
39; mul 16 22; mul 10 41; mul 40 42; input k 86; input k 81; input k 83; sub 45 46; mul 47 47; input k 84; sub 49 7;
input k 82; add 50 51; mul 52 52; add 48 53; sqrt 54; input k 85; div 15 56; mul 55 57; mul 18 58; sqrt 58; div 15
60; mul 61 61; mul 18 62; mul 62 63; sub 59 64; mul 44 65; input k 87; input k 88; sub 58 31; max 30 69; min 29 70;
mul 68 71; add 67 72; mul 71 73; add 15 74; mul 66 75; mul 57 76; mul 57 62; mul 52 78; mul 77 79; add 43 80; sub 0
81; store load 0 82
    """,
)
