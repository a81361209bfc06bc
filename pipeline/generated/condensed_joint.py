"""The condensed joint: rates, forces at rest, inertia, stop operators after a step.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from ..codegen.graph import Graph

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
    'stop_travel_5', 'creep_stiffness_0', 'creep_stiffness_1', 'creep_rate_0', 'creep_rate_1', 'softening',
    'softening_rate', 'slope_ratio')

TIP_CONSTANTS = (('drag', 0.02, 1.2, 'N·s²/m²'), ('sliding_force', 0.0001, 1.2, 'N'), ('sliding_speed', 0.006, 0.5, 'm/s'))

CORRECTIONS = ('force', 'damping', 'left', 'right', 'moment', 'stiffness', 'left_moment', 'right_moment', 'loss',
    'moment_q', 'stiffness_q', 'left_moment_q', 'right_moment_q')

STATES = 15

ELEMENT_STATES = (('creep_0', 'm'), ('creep_1', 'm'), ('softening', '1'))

SHAPE = range(0, 6, 2)

SHAPE_RATES = range(1, 6, 2)

FIRST_STRAIN = 6

QUARTICS = ('qqqq', 'qqqt', 'qqqb', 'qqtt', 'qqtb', 'qqbb', 'qttt', 'qttb', 'qtbb', 'qbbb', 'tttt', 'tttb', 'ttbb',
    'tbbb', 'bbbb')

SEXTICS = ('qqqbbb', 'qqtbbb', 'qqbbbb', 'qttbbb', 'qtbbbb', 'qbbbbb', 'tttbbb', 'ttbbbb', 'tbbbbb', 'bbbbbb')

SHORTENINGS = ('qqqq', 'qqqt', 'qqqb', 'qqtt', 'qqtb', 'qttt', 'qttb', 'tttt', 'tttb')

FIRST_ELEMENT = 12

SOFTENING = 14

DRY_LEVELS = ('sliding_force',)

AT_REST = (1.0, 1.0, 0.0)

STOPS = 10

STOP_ELEMENTS = (0, 1, 2, 3, 4, 5, 4, 5, 4, 5)

STOP_SHARES = (1.0, 1.0, 1.0, 1.0, 0.2777777777777778, 0.2777777777777778, 0.4444444444444444, 0.4444444444444444,
    0.2777777777777778, 0.2777777777777778)

STOP_DIRECTIONS = ((1.0, 1.0, 0.0, 0.0), (1.0, 1.0, 0.0, 0.0), (1.0, 1.0, 0.0, 0.0), (1.0, 1.0, 0.0, 0.0), (0.7745966692414834,
    0.0, -0.22063166795407502, 0.13333333333333333), (0.7745966692414834, 0.0, -0.22063166795407502,
    0.13333333333333333), (0.0, 0.0, 0.16666666666666669, -0.16666666666666669), (0.0, 0.0, 0.16666666666666669,
    -0.16666666666666669), (-0.7745966692414834, 0.0, 0.5539650012874084, 0.13333333333333333),
    (-0.7745966692414834, 0.0, 0.5539650012874084, 0.13333333333333333))

SLIPS = 4

LAYERS = 2

CREEPS = 2

BRANCHES = 3

SHAPES = ((0.37142857142857144, -0.05238095238095238, 0.016666666666666666), (-0.05238095238095238,
    0.009523809523809525, -0.0035714285714285713), (0.016666666666666666, -0.0035714285714285713,
    0.0015873015873015873))

SLOPES = ((1.2, -0.1, 0.0), (-0.1, 0.13333333333333333, -0.03333333333333333), (0.0, -0.03333333333333333,
    0.01904761904761905))

BENDS = ((12.0, -6.0, 0.0), (-6.0, 4.0, 0.0), (0.0, 0.0, 0.8))

PREPARE = Graph(
    {'k': 114},
    {'p': 196},
    """
input k 46; input k 47; constant 1.0; input k 9; sub 3 2; input k 44; input k 56; input k 50; input k 51; input k
53; input k 48; input k 52; input k 54; input k 49; input k 45; input k 113; input k 0; div 2 16; mul 15 17;
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
26 232; input k 43; mul 184 234; input k 71; div 2 236; input k 73; input k 74; input k 111; input k 75; input k 76;
mul 19 242; constant 0.7142857142857143; sub 242 244; mul 243 245; input k 77; input k 78; input k 79; input k 61;
mul 19 250; sub 250 244; mul 251 252; input k 80; input k 86; input k 82; input k 81; input k 83; input k 84; sub
259 16; input k 85; div 2 261; input k 87; input k 88; input k 89; input k 90; mul 19 266; sub 266 244; mul 267 268;
input k 91; input k 92; input k 93; input k 94; input k 57; input k 95; input k 66; input k 101; div 2 277; input k
96; input k 102; div 2 280; input k 97; input k 103; div 2 283; input k 98; input k 104; div 2 286; constant
0.2777777777777778; input k 99; mul 288 289; constant -0.22063166795407502; mul 16 291; mul 16 136; input k 105; div
2 294; input k 100; mul 288 296; input k 106; div 2 298; constant 0.5539650012874084; mul 16 300; input k 63; input
k 64; input k 65; mul 304 304; input k 107; input k 108; mul 3 188; mul 188 192; input k 31; mul 184 310; input k
32; mul 188 312; input k 33; mul 184 207; mul 188 208; input k 20; mul 26 317; input k 21; mul 184 319; input k 22;
mul 188 321; input k 23; mul 6 211; constant 0.4444444444444444; mul 289 325; constant 0.16666666666666669; mul 16
327; constant -0.16666666666666669; mul 16 329; mul 296 325; constant 2.4; mul 54 332; add 41 333; constant
0.019047619047619053; mul 59 335; add 334 336; constant -1.3714285714285719; mul 63 338; constant 1.371428571428571;
mul 53 340; constant 0.007256235827664402; mul 58 342; add 341 343; constant -4.799999999999996; mul 63 345;
constant 1.3714285714285672; mul 53 347; constant -0.05714285714285713; mul 58 349; add 348 350; constant
-7.200000000000003; mul 63 352; constant 7.199999999999999; mul 53 354; constant 0.2190476190476187; mul 58 356; add
355 357; constant -45.25714285714285; mul 53 359; constant -0.1142857142857146; mul 58 361; add 360 362; constant
-28.80000000000001; mul 63 364; mul 188 194; mul 188 314; input k 34; mul 184 368; mul 188 209; mul 184 210; mul 184
323; input k 24; mul 26 373; mul 21 41; input k 58; input k 59; input k 60; input k 109; input k 110; input k 112;
mul 23 61; mul 23 138; mul 23 125; mul 39 61; mul 39 138; mul 39 125; store p 0 0; store p 1 3; store p 2 4; store p
3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p 11 12;
store p 12 13; store p 13 14; store p 14 18; store p 15 46; store p 16 47; store p 17 17; store p 18 48; store p 19
61; store p 20 27; store p 21 23; store p 22 39; store p 23 64; store p 24 69; store p 25 71; store p 26 76; store p
27 81; store p 28 88; store p 29 90; store p 30 95; store p 31 97; store p 32 102; store p 33 107; store p 34 112;
store p 35 117; store p 36 123; store p 37 125; store p 38 127; store p 39 132; store p 40 138; store p 41 140;
store p 42 145; store p 43 149; store p 44 154; store p 45 159; store p 46 161; store p 47 166; store p 48 171;
store p 49 173; store p 50 178; store p 51 183; store p 52 186; store p 53 189; store p 54 191; store p 55 192;
store p 56 193; store p 57 194; store p 58 196; store p 59 198; store p 60 200; store p 61 202; store p 62 204;
store p 63 206; store p 64 207; store p 65 208; store p 66 209; store p 67 210; store p 68 21; store p 69 219; store
p 70 221; store p 71 223; store p 72 225; store p 73 227; store p 74 228; store p 75 229; store p 76 211; store p 77
217; store p 78 16; store p 79 220; store p 80 226; store p 81 230; store p 82 231; store p 83 233; store p 84 235;
store p 85 222; store p 86 234; store p 87 215; store p 88 213; store p 89 237; store p 90 214; store p 91 212;
store p 92 238; store p 93 239; store p 94 240; store p 95 241; store p 96 242; store p 97 246; store p 98 247;
store p 99 248; store p 100 249; store p 101 250; store p 102 253; store p 103 254; store p 104 260; store p 105
256; store p 106 257; store p 107 262; store p 108 258; store p 109 255; store p 110 263; store p 111 264; store p
112 265; store p 113 266; store p 114 269; store p 115 270; store p 116 271; store p 117 272; store p 118 273; store
p 119 274; store p 120 275; store p 121 276; store p 122 278; store p 123 279; store p 124 281; store p 125 282;
store p 126 284; store p 127 285; store p 128 287; store p 129 290; store p 130 292; store p 131 293; store p 132
295; store p 133 297; store p 134 299; store p 135 301; store p 136 302; store p 137 303; store p 138 305; store p
139 306; store p 140 307; store p 141 308; store p 142 187; store p 143 309; store p 144 311; store p 145 313; store
p 146 314; store p 147 197; store p 148 203; store p 149 315; store p 150 316; store p 151 318; store p 152 320;
store p 153 322; store p 154 323; store p 155 324; store p 156 328; store p 157 326; store p 158 330; store p 159
331; store p 160 337; store p 161 339; store p 162 344; store p 163 346; store p 164 351; store p 165 353; store p
166 358; store p 167 363; store p 168 365; store p 169 190; store p 170 366; store p 171 312; store p 172 367; store
p 173 369; store p 174 199; store p 175 370; store p 176 371; store p 177 319; store p 178 372; store p 179 374;
store p 180 185; store p 181 310; store p 182 368; store p 183 375; store p 184 376; store p 185 377; store p 186
378; store p 187 379; store p 188 380; store p 189 381; store p 190 382; store p 191 383; store p 192 384; store p
193 385; store p 194 386; store p 195 387
    """,
)

RATES = Graph(
    {'x': 15, 'u': 2, 'c': 13, 'z': 10, 'start': 3, 'p': 196},
    {'rates': 15},
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
520; input p 94; input x 14; mul 522 523; sub 2 524; mul 521 525; input p 95; mul 93 527; input p 96; input p 97;
mul 512 530; add 529 531; mul 512 532; add 2 533; mul 528 534; sub 526 535; mul 485 536; input p 98; input x 6; mul
538 539; input p 99; input x 8; mul 541 542; add 540 543; input p 100; input x 10; mul 545 546; add 544 547;
constant -0.5; mul 498 549; mul 498 550; mul 498 551; mul 485 552; input p 101; input p 102; mul 512 555; add 554
556; mul 512 557; add 2 558; mul 553 559; mul 548 560; add 537 561; input p 103; mul 560 563; mul 560 564; sub 480
483; mul 491 566; add 486 489; mul 484 568; sub 567 569; mul 500 570; mul 17 571; mul 130 572; mul 491 500; mul 0
574; sub 573 575; mul 0 431; constant 3.3333333333333335; add 294 298; mul 578 579; sub 2 580; mul 461 581; mul 440
582; add 37 583; mul 130 584; add 577 585; constant 1.25; add 314 318; mul 587 588; sub 2 589; mul 472 590; mul 440
591; add 53 592; mul 395 593; add 586 594; mul 501 595; add 576 596; mul 565 597; add 562 598; mul 501 599; input p
104; add 477 601; input p 105; mul 24 603; add 602 604; input p 106; mul 38 606; add 605 607; input p 107; mul 38
603; mul 24 606; input p 108; sub 611 612; sub 610 613; sub 614 29; mul 615 615; mul 608 608; add 616 617; sqrt 618;
mul 609 619; sqrt 620; div 2 621; mul 622 622; mul 609 623; mul 608 624; input p 109; mul 503 620; mul 503 623; mul
623 628; sub 627 629; mul 626 630; sub 620 511; max 510 632; min 509 633; input p 110; input p 111; mul 634 636; add
635 637; mul 634 638; add 2 639; mul 631 640; mul 525 641; input p 112; mul 97 643; input p 113; input p 114; mul
632 646; add 645 647; mul 632 648; add 2 649; mul 644 650; sub 642 651; mul 609 652; input p 115; input x 7; mul 654
655; input p 116; input x 9; mul 657 658; add 656 659; input p 117; input x 11; mul 661 662; add 660 663; mul 549
622; mul 622 665; mul 622 666; mul 609 667; mul 555 632; add 554 669; mul 632 670; add 2 671; mul 668 672; mul 664
673; add 653 674; input p 118; mul 673 676; mul 673 677; add 604 607; mul 615 679; sub 611 610; mul 608 681; add 680
682; mul 624 683; mul 17 684; mul 130 685; mul 615 624; mul 0 687; sub 686 688; mul 595 625; add 689 690; mul 678
691; add 675 692; mul 625 693; add 600 694; sub 432 695; mul 431 696; sub 409 697; mul 574 599; mul 687 693; add 699
700; sub 698 701; sub 143 702; input p 119; input p 120; constant -1.0; input z 0; input start 0; sub 29 708; input
p 121; input start 1; sub 3 711; mul 710 712; add 709 713; input p 122; mul 714 715; add 707 716; max 706 717; min 2
718; mul 705 719; input p 123; input z 1; input p 124; mul 714 723; add 722 724; max 706 725; min 2 726; mul 721
727; add 720 728; input p 125; input z 2; input p 126; mul 714 732; add 731 733; max 706 734; min 2 735; mul 730
736; add 729 737; input p 127; input z 3; input p 128; mul 714 741; add 740 742; max 706 743; min 2 744; mul 739
745; add 738 746; constant 0.7745966692414834; input p 129; input z 4; mul 709 748; input p 130; mul 712 752; add
751 753; input p 131; input start 2; sub 35 756; mul 755 757; add 754 758; input p 132; mul 759 760; add 750 761;
max 706 762; min 2 763; mul 749 764; mul 748 765; add 747 766; input p 133; input z 5; input p 134; mul 759 770; add
769 771; max 706 772; min 2 773; mul 768 774; mul 748 775; add 767 776; constant -0.7745966692414834; input z 8; mul
709 778; input p 135; mul 712 781; add 780 782; add 758 783; mul 760 784; add 779 785; max 706 786; min 2 787; mul
749 788; mul 778 789; add 777 790; input z 9; mul 770 784; add 792 793; max 706 794; min 2 795; mul 768 796; mul 778
797; add 791 798; sub 704 799; input p 136; abs 0; mul 801 802; mul 0 803; input p 137; mul 0 805; mul 0 0; input p
138; add 807 808; sqrt 809; div 2 810; mul 806 811; add 804 812; sub 800 813; add 703 814; input p 139; input x 12;
sub 29 817; mul 816 818; input p 140; input x 13; sub 29 821; mul 820 822; add 819 823; sub 815 824; mul 0 62; mul
28 130; add 826 827; mul 47 395; add 828 829; mul 0 830; mul 0 28; mul 31 130; add 832 833; mul 34 395; add 834 835;
mul 130 836; add 831 837; mul 0 47; mul 34 130; add 839 840; mul 51 395; add 841 842; mul 395 843; add 838 844; mul
17 130; mul 130 846; mul 23 847; input p 141; mul 9 849; mul 9 850; mul 8 16; mul 10 852; mul 852 853; add 851 854;
mul 3 855; mul 38 856; sub 25 857; mul 848 858; add 845 859; mul 67 860; mul 24 856; add 39 862; mul 848 863; sub
861 864; mul 22 865; sub 825 866; mul 90 867; mul 81 89; mul 150 265; input p 142; mul 285 871; input p 143; mul 304
873; add 872 874; mul 324 331; add 875 876; input p 144; mul 328 878; add 877 879; input p 145; mul 332 881; add 880
882; input p 146; mul 336 884; add 883 885; mul 339 886; input p 147; mul 342 888; mul 345 352; add 889 890; input p
148; mul 349 892; add 891 893; input p 149; mul 353 895; add 894 896; input p 150; mul 357 898; add 897 899; mul 361
372; add 900 901; input p 151; mul 365 903; add 902 904; input p 152; mul 369 906; add 905 907; input p 153; mul 373
909; add 908 910; input p 154; mul 339 912; add 911 913; add 887 914; mul 581 915; add 870 916; mul 145 917; mul 584
696; sub 918 919; mul 150 405; add 920 921; mul 572 599; mul 685 693; add 923 924; add 922 925; sub 134 926; input p
155; mul 38 928; mul 17 929; add 927 930; mul 710 720; mul 710 728; add 932 933; mul 710 737; add 934 935; mul 710
746; add 936 937; mul 752 765; add 938 939; mul 752 775; add 940 941; input p 156; input p 157; input z 6; mul 712
943; input p 158; mul 757 947; add 946 948; mul 760 949; add 945 950; max 706 951; min 2 952; mul 944 953; mul 943
954; add 942 955; input p 159; input z 7; mul 770 949; add 958 959; max 706 960; min 2 961; mul 957 962; mul 943
963; add 956 964; mul 781 789; add 965 966; mul 781 797; add 967 968; sub 931 969; mul 41 860; mul 26 864; sub 971
972; mul 22 973; mul 19 856; mul 847 975; sub 974 976; sub 970 977; mul 869 978; sub 868 979; mul 86 89; input p
160; mul 35 982; input p 161; mul 214 984; add 983 985; input p 162; mul 218 987; add 986 988; mul 155 210; add 989
990; input p 163; mul 158 992; add 991 993; input p 164; mul 162 995; add 994 996; input p 165; mul 166 998; add 997
999; mul 170 227; add 1000 1001; input p 166; mul 174 1003; add 1002 1004; mul 157 189; add 1005 1006; input p 167;
mul 193 1008; add 1007 1009; mul 169 197; add 1010 1011; input p 168; mul 201 1013; add 1012 1014; mul 184 258; add
1015 1016; mul 202 257; add 1017 1018; mul 153 265; add 1019 1020; input p 169; mul 285 1022; mul 304 331; add 1023
1024; input p 170; mul 324 1026; add 1025 1027; input p 171; mul 328 1029; add 1028 1030; input p 172; mul 332 1032;
add 1031 1033; input p 173; mul 336 1035; add 1034 1036; mul 339 1037; input p 174; mul 342 1039; mul 345 892; add
1040 1041; mul 349 360; add 1042 1043; mul 353 368; add 1044 1045; input p 175; mul 357 1047; add 1046 1048; input p
176; mul 361 1050; add 1049 1051; input p 177; mul 365 1053; add 1052 1054; mul 369 909; add 1055 1056; input p 178;
mul 373 1058; add 1057 1059; input p 179; mul 339 1061; add 1060 1062; add 1038 1063; constant 3.0; mul 336 1065;
input p 180; mul 342 1067; mul 345 871; add 1068 1069; mul 349 1022; add 1070 1071; mul 327 353; add 1072 1073; mul
331 357; add 1074 1075; mul 335 361; add 1076 1077; input p 181; mul 365 1079; add 1078 1080; mul 369 1029; add 1081
1082; mul 373 884; add 1083 1084; input p 182; mul 339 1086; add 1085 1087; mul 1066 1088; add 1064 1089; mul 590
1090; add 1021 1091; mul 145 1092; mul 593 696; sub 1093 1094; input p 183; mul 395 1096; mul 153 405; add 1097
1098; add 1095 1099; mul 755 765; mul 755 775; add 1101 1102; mul 947 954; add 1103 1104; mul 947 963; add 1105
1106; mul 755 789; add 1107 1108; mul 755 797; add 1109 1110; add 1100 1111; mul 53 860; mul 22 1113; add 1112 1114;
mul 981 1115; sub 980 1116; mul 56 70; mul 79 79; sub 1118 1119; mul 89 1120; mul 978 1121; mul 867 869; sub 1122
1123; mul 59 70; mul 76 79; sub 1125 1126; mul 89 1127; mul 1115 1128; add 1124 1129; mul 867 981; mul 978 1128; sub
1131 1132; mul 45 70; mul 76 76; sub 1134 1135; mul 89 1136; mul 1115 1137; sub 1133 1138; mul 560 597; input p 184;
mul 539 1141; sub 1140 1142; mul 673 691; mul 655 1141; sub 1144 1145; input p 185; mul 542 1147; sub 1140 1148; mul
658 1147; sub 1144 1150; input p 186; mul 546 1152; sub 1140 1153; mul 662 1152; sub 1144 1155; input p 187; mul 818
1157; input p 188; mul 822 1159; input p 189; sub 2 523; mul 1161 1162; store rates 0 0; store rates 1 1117; store
rates 2 130; store rates 3 1130; store rates 4 395; store rates 5 1139; store rates 6 1143; store rates 7 1146;
store rates 8 1149; store rates 9 1151; store rates 10 1154; store rates 11 1156; store rates 12 1158; store rates
13 1160; store rates 14 1163
    """,
)

REST_FORCES = Graph(
    {'x': 15, 'u': 2, 'c': 13, 'p': 196},
    {'forces': 3, 'by_shape': 6},
    """
input p 119; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
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
429; mul 418 430; input p 94; input x 14; mul 432 433; sub 181 434; mul 431 435; input p 95; mul 3 437; input p 96;
input p 97; mul 422 440; add 439 441; mul 422 442; add 181 443; mul 438 444; sub 436 445; mul 319 446; mul 319 414;
mul 406 448; mul 447 449; input p 107; input p 109; input p 105; mul 338 453; input p 106; mul 333 455; input p 108;
sub 456 457; sub 454 458; sub 459 11; mul 460 460; input p 104; add 401 462; mul 333 453; add 463 464; mul 338 455;
add 465 466; mul 467 467; add 461 468; sqrt 469; mul 451 470; mul 321 471; sqrt 471; div 181 473; mul 474 474; mul
321 475; mul 475 476; sub 472 477; mul 452 478; sub 471 421; max 420 480; min 419 481; input p 110; input p 111; mul
482 484; add 483 485; mul 482 486; add 181 487; mul 479 488; mul 435 489; input p 112; mul 7 491; input p 113; input
p 114; mul 480 494; add 493 495; mul 480 496; add 181 497; mul 492 498; sub 490 499; mul 451 500; mul 451 475; mul
467 502; mul 501 503; add 450 504; sub 318 505; mul 317 506; sub 287 507; mul 342 448; mul 447 509; mul 460 502; mul
501 511; add 510 512; sub 508 513; sub 40 514; add 0 515; mul 326 332; div 181 517; mul 327 518; input p 155; mul
338 520; mul 519 521; mul 47 163; constant 3.3333333333333335; add 194 198; mul 524 525; sub 181 526; input p 142;
mul 185 528; input p 143; mul 204 530; add 529 531; mul 224 231; add 532 533; input p 144; mul 228 535; add 534 536;
input p 145; mul 232 538; add 537 539; input p 146; mul 236 541; add 540 542; mul 239 543; input p 147; mul 242 545;
mul 245 252; add 546 547; input p 148; mul 249 549; add 548 550; input p 149; mul 253 552; add 551 553; input p 150;
mul 257 555; add 554 556; mul 261 272; add 557 558; input p 151; mul 265 560; add 559 561; input p 152; mul 269 563;
add 562 564; input p 153; mul 273 566; add 565 567; input p 154; mul 239 569; add 568 570; add 544 571; mul 527 572;
add 523 573; mul 42 574; mul 385 527; mul 364 576; add 352 577; mul 506 578; sub 575 579; sub 403 405; mul 342 581;
add 335 340; mul 406 583; sub 582 584; mul 448 585; mul 519 586; mul 447 587; add 464 466; mul 460 589; sub 456 454;
mul 467 591; add 590 592; mul 502 593; mul 519 594; mul 501 595; add 588 596; add 580 597; sub 38 598; add 522 599;
input p 160; mul 50 601; input p 161; mul 112 603; add 602 604; input p 162; mul 116 606; add 605 607; mul 53 108;
add 608 609; input p 163; mul 56 611; add 610 612; input p 164; mul 60 614; add 613 615; input p 165; mul 64 617;
add 616 618; mul 68 125; add 619 620; input p 166; mul 72 622; add 621 623; mul 55 87; add 624 625; input p 167; mul
91 627; add 626 628; mul 67 95; add 629 630; input p 168; mul 99 632; add 631 633; mul 82 156; add 634 635; mul 100
155; add 636 637; mul 51 163; add 638 639; constant 1.25; add 214 218; mul 641 642; sub 181 643; input p 169; mul
185 645; mul 204 231; add 646 647; input p 170; mul 224 649; add 648 650; input p 171; mul 228 652; add 651 653;
input p 172; mul 232 655; add 654 656; input p 173; mul 236 658; add 657 659; mul 239 660; input p 174; mul 242 662;
mul 245 549; add 663 664; mul 249 260; add 665 666; mul 253 268; add 667 668; input p 175; mul 257 670; add 669 671;
input p 176; mul 261 673; add 672 674; input p 177; mul 265 676; add 675 677; mul 269 566; add 678 679; input p 178;
mul 273 681; add 680 682; input p 179; mul 239 684; add 683 685; add 661 686; constant 3.0; mul 236 688; input p
180; mul 242 690; mul 245 528; add 691 692; mul 249 645; add 693 694; mul 227 253; add 695 696; mul 231 257; add 697
698; mul 235 261; add 699 700; input p 181; mul 265 702; add 701 703; mul 269 652; add 704 705; mul 273 541; add 706
707; input p 182; mul 239 709; add 708 710; mul 689 711; add 687 712; mul 644 713; add 640 714; mul 42 715; mul 396
644; mul 364 717; add 360 718; mul 506 719; sub 716 720; neg 721; sub 26 19; mul 12 30; add 723 724; input p 190;
mul 47 50; mul 55 727; add 726 728; mul 50 727; mul 59 730; add 729 731; mul 53 321; mul 47 733; mul 63 734; add 732
735; mul 50 734; mul 67 737; add 736 738; mul 53 734; mul 47 64; add 740 741; mul 71 742; add 739 743; mul 45 47;
mul 86 745; add 744 746; mul 50 745; mul 90 748; add 747 749; mul 53 745; mul 47 87; add 751 752; mul 94 753; add
750 754; mul 47 99; mul 98 756; add 755 757; input p 191; mul 122 727; add 759 760; mul 125 730; add 761 762; mul
128 734; add 763 764; mul 131 737; add 765 766; mul 134 742; add 767 768; mul 143 745; add 769 770; mul 146 748; add
771 772; mul 149 753; add 773 774; mul 94 756; add 775 776; mul 44 777; add 758 778; le 190 188; le 188 190; add 780
781; div 181 782; mul 780 783; le 189 10; le 10 189; add 785 786; div 181 787; mul 785 788; mul 784 789; constant
1.6666666666666667; mul 194 321; le 171 193; le 193 171; add 793 794; div 181 795; mul 793 796; mul 790 797; mul 792
798; mul 198 321; le 171 197; le 197 171; add 801 802; div 181 803; mul 801 804; mul 790 805; mul 800 806; add 799
807; mul 791 808; sub 790 809; mul 184 810; mul 187 811; mul 203 321; mul 810 813; mul 227 814; add 812 815; mul 223
810; mul 231 817; add 816 818; mul 239 819; mul 185 810; mul 244 821; mul 203 811; mul 204 810; add 823 824; mul 252
825; add 822 826; mul 223 811; mul 256 828; add 827 829; mul 203 814; mul 228 810; add 831 832; mul 264 833; add 830
834; mul 223 814; mul 268 836; add 835 837; mul 223 817; mul 272 839; add 838 840; add 820 841; mul 283 842; add 779
843; mul 42 844; mul 41 845; mul 298 821; mul 304 825; add 847 848; mul 307 828; add 849 850; mul 310 833; add 851
852; mul 313 836; add 853 854; mul 283 855; add 290 856; mul 506 857; mul 321 342; div 181 332; mul 329 860; mul 327
861; mul 327 333; mul 323 327; mul 863 864; sub 862 865; mul 334 866; mul 327 338; mul 864 868; sub 327 869; mul 339
870; add 867 871; mul 859 872; mul 321 406; add 348 352; add 346 875; add 351 876; mul 16 877; mul 184 855; mul 385
810; mul 304 821; mul 374 825; add 881 882; mul 377 828; add 883 884; mul 380 833; add 885 886; mul 383 836; add 887
888; mul 203 889; add 880 890; add 879 891; mul 371 821; mul 313 825; add 893 894; mul 394 833; add 895 896; mul 223
897; add 892 898; mul 365 899; mul 364 900; add 878 901; mul 339 866; add 902 903; mul 334 870; sub 904 905; mul 874
906; add 873 907; mul 321 409; div 181 909; mul 908 910; mul 319 911; mul 321 912; mul 321 413; mul 321 412; div 181
915; mul 912 916; mul 414 917; mul 914 918; neg 919; mul 321 920; mul 414 921; mul 415 919; sub 922 923; sub 913
924; mul 320 925; mul 430 926; le 423 419; le 419 423; add 928 929; div 181 930; mul 928 931; le 420 422; le 422
420; add 933 934; div 181 935; mul 933 936; mul 912 937; mul 932 938; mul 426 939; mul 424 940; mul 428 939; add 941
942; mul 418 943; add 927 944; mul 435 945; mul 440 912; mul 422 947; mul 442 912; add 948 949; mul 438 950; sub 946
951; mul 319 952; mul 449 953; mul 448 906; mul 319 919; mul 406 956; sub 955 957; mul 447 958; add 954 959; mul 321
460; mul 453 870; mul 455 866; sub 962 963; mul 961 964; mul 321 467; mul 453 866; add 902 967; mul 455 870; add 968
969; mul 966 970; add 965 971; mul 321 470; div 181 973; mul 972 974; mul 451 975; mul 321 976; mul 321 474; mul 321
473; div 181 979; mul 976 980; mul 475 981; mul 978 982; neg 983; mul 321 984; mul 475 985; mul 476 983; sub 986
987; sub 977 988; mul 452 989; mul 488 990; le 481 419; le 419 481; add 992 993; div 181 994; mul 992 995; le 420
480; le 480 420; add 997 998; div 181 999; mul 997 1000; mul 976 1001; mul 996 1002; mul 484 1003; mul 482 1004; mul
486 1003; add 1005 1006; mul 479 1007; add 991 1008; mul 435 1009; mul 494 976; mul 480 1011; mul 496 976; add 1012
1013; mul 492 1014; sub 1010 1015; mul 451 1016; mul 503 1017; mul 502 970; mul 451 983; mul 467 1020; sub 1019
1021; mul 501 1022; add 1018 1023; add 960 1024; mul 317 1025; sub 858 1026; sub 846 1027; mul 509 953; mul 448 872;
mul 342 956; sub 1030 1031; mul 447 1032; add 1029 1033; mul 511 1017; mul 502 964; mul 460 1020; sub 1036 1037; mul
501 1038; add 1035 1039; add 1034 1040; sub 1028 1041; sub 725 1042; mul 520 870; mul 519 1044; mul 327 327; mul 864
1046; mul 518 1047; mul 518 519; mul 332 864; mul 326 861; add 1050 1051; mul 1049 1052; add 1048 1053; mul 521
1054; sub 1045 1055; mul 47 777; mul 530 811; mul 535 814; add 1058 1059; mul 538 817; add 1060 1061; mul 239 1062;
mul 252 821; mul 552 825; add 1064 1065; mul 555 828; add 1066 1067; mul 560 833; add 1068 1069; mul 563 836; add
1070 1071; mul 566 839; add 1072 1073; add 1063 1074; mul 527 1075; sub 798 806; mul 524 1077; mul 572 1078; sub
1076 1079; add 1057 1080; mul 42 1081; mul 527 889; mul 385 1078; sub 1083 1084; mul 364 1085; add 347 1086; mul 506
1087; mul 578 1025; sub 1088 1089; sub 1082 1090; mul 587 953; mul 581 872; sub 903 905; mul 342 1094; add 1093
1095; mul 583 906; mul 406 872; add 1097 1098; sub 1096 1099; mul 448 1100; mul 585 956; sub 1101 1102; mul 519
1103; mul 586 1054; sub 1104 1105; mul 447 1106; add 1092 1107; mul 595 1017; mul 589 964; add 967 969; mul 460
1111; add 1110 1112; mul 591 970; sub 963 962; mul 467 1115; add 1114 1116; add 1113 1117; mul 502 1118; mul 593
1020; sub 1119 1120; mul 519 1121; mul 594 1054; sub 1122 1123; mul 501 1124; add 1109 1125; add 1108 1126; add 1091
1127; add 30 1128; sub 1056 1129; input p 192; mul 611 727; add 1131 1132; mul 614 730; add 1133 1134; mul 617 734;
add 1135 1136; mul 125 737; add 1137 1138; mul 622 742; add 1139 1140; mul 55 745; add 1141 1142; mul 627 748; add
1143 1144; mul 67 753; add 1145 1146; mul 155 756; add 1147 1148; mul 51 777; add 1149 1150; mul 231 811; mul 652
814; add 1152 1153; mul 655 817; add 1154 1155; mul 239 1156; mul 549 821; mul 268 825; add 1158 1159; mul 670 828;
add 1160 1161; mul 676 833; add 1162 1163; mul 566 836; add 1164 1165; mul 681 839; add 1166 1167; add 1157 1168;
mul 528 821; mul 227 825; add 1170 1171; mul 231 828; add 1172 1173; mul 702 833; add 1174 1175; mul 652 836; add
1176 1177; mul 541 839; add 1178 1179; mul 689 1180; add 1169 1181; mul 644 1182; add 1151 1183; mul 42 1184; mul
644 897; mul 364 1186; add 350 1187; mul 506 1188; mul 719 1025; sub 1189 1190; sub 1185 1191; neg 1192; input p
193; add 52 53; mul 55 1195; add 1194 1196; mul 50 1195; add 56 1198; mul 59 1199; add 1197 1200; mul 51 733; mul 63
1202; add 1201 1203; mul 50 1202; add 64 1205; mul 67 1206; add 1204 1207; mul 53 1202; mul 51 64; add 1209 1210;
mul 71 1211; add 1208 1212; mul 45 78; add 1213 1214; mul 79 321; mul 82 1216; add 1215 1217; mul 45 51; mul 86
1219; add 1218 1220; mul 50 1219; add 87 1222; mul 90 1223; add 1221 1224; mul 53 1219; mul 51 87; add 1226 1227;
mul 94 1228; add 1225 1229; mul 51 99; mul 98 1231; add 1230 1232; mul 50 321; mul 111 1234; add 108 1235; mul 50
1234; add 112 1237; mul 115 1238; add 1236 1239; input p 194; add 1240 1241; mul 122 1195; add 1242 1243; mul 125
1199; add 1244 1245; mul 128 1202; add 1246 1247; mul 131 1206; add 1248 1249; mul 134 1211; add 1250 1251; mul 45
55; add 1252 1253; mul 59 1216; add 1254 1255; mul 143 1219; add 1256 1257; mul 146 1223; add 1258 1259; mul 149
1228; add 1260 1261; mul 99 155; add 1262 1263; mul 94 1231; add 1264 1265; mul 44 1266; add 1233 1267; le 210 208;
le 208 210; add 1269 1270; div 181 1271; mul 1269 1272; le 209 50; le 50 209; add 1274 1275; div 181 1276; mul 1274
1277; mul 1273 1278; constant 0.625; mul 214 321; le 171 213; le 213 171; add 1282 1283; div 181 1284; mul 1282
1285; mul 1279 1286; mul 1281 1287; mul 218 321; le 171 217; le 217 171; add 1290 1291; div 181 1292; mul 1290 1293;
mul 1279 1294; mul 1289 1295; add 1288 1296; mul 1280 1297; sub 1279 1298; mul 184 1299; mul 207 1300; mul 203 1299;
mul 231 1302; add 1301 1303; mul 223 321; mul 1299 1305; mul 235 1306; add 1304 1307; mul 239 1308; mul 223 1306;
mul 236 1299; add 1310 1311; mul 238 1312; add 1309 1313; mul 185 1299; mul 248 1315; mul 204 1299; mul 256 1317;
add 1316 1318; mul 223 1300; mul 224 1299; add 1320 1321; mul 260 1322; add 1319 1323; mul 228 1299; mul 268 1325;
add 1324 1326; mul 223 1302; mul 232 1299; add 1328 1329; mul 272 1330; add 1327 1331; mul 276 1312; add 1332 1333;
add 1314 1334; mul 283 1335; add 1268 1336; mul 42 1337; mul 41 1338; mul 301 1315; mul 307 1317; add 1340 1341; mul
313 1325; add 1342 1343; mul 283 1344; add 293 1345; mul 506 1346; add 359 360; add 357 1348; mul 16 1349; mul 184
1344; mul 371 1315; mul 377 1317; add 1352 1353; mul 383 1325; add 1354 1355; mul 203 1356; add 1351 1357; mul 396
1299; add 1358 1359; mul 365 1360; mul 364 1361; add 1350 1362; mul 874 1363; mul 910 1364; mul 319 1365; mul 321
1366; mul 916 1366; mul 414 1368; mul 914 1369; neg 1370; mul 321 1371; mul 414 1372; mul 415 1370; sub 1373 1374;
sub 1367 1375; mul 320 1376; mul 430 1377; mul 937 1366; mul 932 1379; mul 426 1380; mul 424 1381; mul 428 1380; add
1382 1383; mul 418 1384; add 1378 1385; mul 435 1386; mul 440 1366; mul 422 1388; mul 442 1366; add 1389 1390; mul
438 1391; sub 1387 1392; mul 319 1393; mul 449 1394; mul 448 1363; mul 319 1370; mul 406 1397; sub 1396 1398; mul
447 1399; add 1395 1400; mul 966 1363; mul 974 1402; mul 451 1403; mul 321 1404; mul 980 1404; mul 475 1406; mul 978
1407; neg 1408; mul 321 1409; mul 475 1410; mul 476 1408; sub 1411 1412; sub 1405 1413; mul 452 1414; mul 488 1415;
mul 1001 1404; mul 996 1417; mul 484 1418; mul 482 1419; mul 486 1418; add 1420 1421; mul 479 1422; add 1416 1423;
mul 435 1424; mul 494 1404; mul 480 1426; mul 496 1404; add 1427 1428; mul 492 1429; sub 1425 1430; mul 451 1431;
mul 503 1432; mul 502 1363; mul 451 1408; mul 467 1435; sub 1434 1436; mul 501 1437; add 1433 1438; add 1401 1439;
mul 317 1440; sub 1347 1441; sub 1339 1442; mul 509 1394; mul 342 1397; mul 447 1445; sub 1444 1446; mul 511 1432;
mul 460 1435; mul 501 1449; sub 1448 1450; add 1447 1451; sub 1443 1452; neg 1453; mul 47 1266; mul 231 1300; mul
538 1302; add 1456 1457; mul 541 1306; add 1458 1459; mul 239 1460; mul 543 1312; add 1461 1462; mul 549 1315; mul
555 1317; add 1464 1465; mul 272 1322; add 1466 1467; mul 563 1325; add 1468 1469; mul 566 1330; add 1470 1471; mul
569 1312; add 1472 1473; add 1463 1474; mul 527 1475; add 1455 1476; mul 42 1477; mul 527 1356; mul 364 1479; add
350 1480; mul 506 1481; mul 578 1440; sub 1482 1483; sub 1478 1484; mul 587 1394; mul 583 1363; mul 448 1487; mul
585 1397; add 1488 1489; mul 519 1490; mul 447 1491; sub 1486 1492; mul 595 1432; mul 591 1363; mul 502 1495; mul
593 1435; sub 1496 1497; mul 519 1498; mul 501 1499; add 1494 1500; add 1493 1501; add 1485 1502; neg 1503; mul 603
1234; add 601 1505; mul 606 1238; add 1506 1507; input p 195; add 1508 1509; mul 611 1195; add 1510 1511; mul 614
1199; add 1512 1513; mul 617 1202; add 1514 1515; mul 125 1206; add 1516 1517; mul 622 1211; add 1518 1519; mul 55
1219; add 1520 1521; mul 627 1223; add 1522 1523; mul 67 1228; add 1524 1525; mul 82 99; add 1526 1527; mul 155
1231; add 1528 1529; mul 51 1266; add 1530 1531; mul 649 1300; mul 655 1302; add 1533 1534; mul 658 1306; add 1535
1536; mul 239 1537; mul 660 1312; add 1538 1539; mul 260 1315; mul 670 1317; add 1541 1542; mul 673 1322; add 1543
1544; mul 566 1325; add 1545 1546; mul 681 1330; add 1547 1548; mul 684 1312; add 1549 1550; add 1540 1551; mul 688
1306; mul 711 1553; mul 645 1315; mul 231 1317; add 1555 1556; mul 235 1322; add 1557 1558; mul 652 1325; add 1559
1560; mul 541 1330; add 1561 1562; mul 709 1312; add 1563 1564; mul 689 1565; add 1554 1566; add 1552 1567; mul 644
1568; sub 1287 1295; mul 641 1570; mul 713 1571; sub 1569 1572; add 1532 1573; mul 42 1574; mul 396 1571; mul 364
1576; sub 358 1577; mul 506 1578; mul 719 1440; sub 1579 1580; sub 1575 1581; neg 1582; store forces 0 516; store
forces 1 600; store forces 2 722; store by_shape 0 1043; store by_shape 2 1130; store by_shape 4 1193; store
by_shape 1 1454; store by_shape 3 1504; store by_shape 5 1583
    """,
)

INERTIA = Graph(
    {'x': 15, 'p': 196},
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
    {'x': 15, 'z': 10, 'start': 3, 'p': 196},
    {'moved': 10},
    """
constant 1.0; constant -1.0; input z 0; input x 0; input start 0; sub 3 4; input p 121; input x 2; input start 1;
sub 7 8; mul 6 9; add 5 10; input p 122; mul 11 12; add 2 13; max 1 14; min 0 15; input z 1; input p 124; mul 11 18;
add 17 19; max 1 20; min 0 21; input z 2; input p 126; mul 11 24; add 23 25; max 1 26; min 0 27; input z 3; input p
128; mul 11 30; add 29 31; max 1 32; min 0 33; input z 4; constant 0.7745966692414834; mul 5 36; input p 130; mul 9
38; add 37 39; input p 131; input x 4; input start 2; sub 42 43; mul 41 44; add 40 45; input p 132; mul 46 47; add
35 48; max 1 49; min 0 50; input z 5; input p 134; mul 46 53; add 52 54; max 1 55; min 0 56; input z 6; input p 156;
mul 9 59; input p 158; mul 44 61; add 60 62; mul 47 63; add 58 64; max 1 65; min 0 66; input z 7; mul 53 63; add 68
69; max 1 70; min 0 71; input z 8; constant -0.7745966692414834; mul 5 74; input p 135; mul 9 76; add 75 77; add 45
78; mul 47 79; add 73 80; max 1 81; min 0 82; input z 9; mul 53 79; add 84 85; max 1 86; min 0 87; store moved 0 16;
store moved 1 22; store moved 2 28; store moved 3 34; store moved 4 51; store moved 5 57; store moved 6 67; store
moved 7 72; store moved 8 83; store moved 9 88
    """,
)

UPRIGHT = Graph(
    {'k': 114},
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
