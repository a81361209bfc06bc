"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 96},
    {'p': 227},
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
19 267; sub 267 220; mul 268 269; input k 79; input k 80; input k 81; input k 82; constant -6.0; constant 4.0; input
k 45; input k 83; input k 84; input k 85; input k 86; input k 51; input k 52; input k 53; mul 284 284; input k 91;
input k 92; mul 3 168; input k 30; input k 29; input k 28; input k 27; mul 6 175; input k 54; constant
0.8000000000000002; constant 2.400000000000001; mul 30 296; add 295 297; mul 35 249; add 298 299; constant
-1.3714285714285723; mul 42 301; constant 1.3714285714285714; mul 29 303; constant 0.007256235827664418; mul 34 305;
add 304 306; constant -4.799999999999999; mul 42 308; constant 1.3714285714285692; mul 29 310; constant
-0.05714285714285729; mul 34 312; add 311 313; constant -7.199999999999996; mul 42 315; constant 7.199999999999994;
mul 29 317; constant 0.2190476190476189; mul 34 319; add 318 320; constant -45.25714285714286; mul 29 322; constant
-0.11428571428571327; mul 34 324; add 323 325; constant -28.800000000000004; mul 42 327; input k 31; constant 0.8;
mul 21 330; input k 46; input k 47; input k 48; input k 93; input k 94; input k 87; div 2 337; input k 88; div 2
339; input k 89; div 2 341; input k 90; div 2 343; mul 17 38; mul 37 345; mul 17 67; mul 118 345; mul 17 37; mul 33
345; mul 17 65; mul 116 345; mul 17 33; mul 17 207; mul 17 208; mul 17 209; mul 103 345; add 286 287; mul 104 345;
mul 17 113; mul 275 345; add 360 361; mul 21 362; mul 17 275; mul 276 345; add 364 365; mul 21 366; mul 38 367; add
363 368; mul 39 367; mul 40 367; mul 37 39; mul 39 118; mul 33 39; mul 39 116; mul 39 103; mul 39 104; mul 39 275;
mul 21 378; mul 39 276; mul 21 380; mul 38 381; add 379 382; mul 39 381; mul 40 381; mul 294 338; mul 294 340; mul
294 342; mul 294 344; mul 37 40; mul 40 118; mul 33 40; mul 40 116; mul 40 103; mul 40 104; mul 40 276; mul 21 396;
mul 39 397; mul 40 275; mul 21 399; mul 38 397; add 400 401; mul 40 397; add 331 403; neg 332; neg 333; neg 334; neg
335; neg 336; mul 278 294; mul 279 294; mul 280 294; mul 281 294; mul 17 18; mul 27 168; mul 168 284; store p 0 0;
store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9
10; store p 10 11; store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 22; store p 16 23; store p
17 17; store p 18 24; store p 19 37; store p 20 38; store p 21 39; store p 22 40; store p 23 43; store p 24 48;
store p 25 50; store p 26 55; store p 27 60; store p 28 67; store p 29 69; store p 30 74; store p 31 76; store p 32
81; store p 33 86; store p 34 91; store p 35 96; store p 36 102; store p 37 104; store p 38 106; store p 39 111;
store p 40 118; store p 41 120; store p 42 125; store p 43 129; store p 44 134; store p 45 139; store p 46 141;
store p 47 146; store p 48 151; store p 49 153; store p 50 158; store p 51 163; store p 52 164; store p 53 165;
store p 54 166; store p 55 167; store p 56 169; store p 57 170; store p 58 171; store p 59 172; store p 60 173;
store p 61 174; store p 62 16; store p 63 207; store p 64 208; store p 65 209; store p 66 194; store p 67 196; store
p 68 232; store p 69 234; store p 70 236; store p 71 238; store p 72 240; store p 73 186; store p 74 242; store p 75
244; store p 76 246; store p 77 248; store p 78 200; store p 79 204; store p 80 175; store p 81 181; store p 82 184;
store p 83 188; store p 84 190; store p 85 192; store p 86 198; store p 87 202; store p 88 206; store p 89 210;
store p 90 211; store p 91 212; store p 92 179; store p 93 177; store p 94 214; store p 95 178; store p 96 176;
store p 97 215; store p 98 216; store p 99 217; store p 100 218; store p 101 222; store p 102 223; store p 103 224;
store p 104 225; store p 105 226; store p 106 229; store p 107 230; store p 108 251; store p 109 253; store p 110
255; store p 111 261; store p 112 257; store p 113 258; store p 114 263; store p 115 259; store p 116 256; store p
117 264; store p 118 265; store p 119 266; store p 120 267; store p 121 270; store p 122 271; store p 123 272; store
p 124 273; store p 125 274; store p 126 21; store p 127 277; store p 128 278; store p 129 279; store p 130 280;
store p 131 281; store p 132 282; store p 133 283; store p 134 285; store p 135 286; store p 136 287; store p 137
288; store p 138 289; store p 139 290; store p 140 291; store p 141 292; store p 142 293; store p 143 294; store p
144 300; store p 145 302; store p 146 307; store p 147 309; store p 148 314; store p 149 316; store p 150 321; store
p 151 326; store p 152 328; store p 153 329; store p 154 331; store p 155 332; store p 156 333; store p 157 334;
store p 158 335; store p 159 336; store p 160 338; store p 161 340; store p 162 342; store p 163 344; store p 164
346; store p 165 345; store p 166 347; store p 167 348; store p 168 349; store p 169 350; store p 170 351; store p
171 352; store p 172 353; store p 173 354; store p 174 355; store p 175 356; store p 176 357; store p 177 358; store
p 178 359; store p 179 369; store p 180 370; store p 181 371; store p 182 372; store p 183 373; store p 184 374;
store p 185 375; store p 186 376; store p 187 377; store p 188 383; store p 189 384; store p 190 385; store p 191
386; store p 192 387; store p 193 388; store p 194 389; store p 195 390; store p 196 391; store p 197 392; store p
198 393; store p 199 394; store p 200 395; store p 201 398; store p 202 402; store p 203 404; store p 204 405; store
p 205 406; store p 206 407; store p 207 408; store p 208 409; store p 209 410; store p 210 411; store p 211 412;
store p 212 413; store p 213 414; store p 214 28; store p 215 27; store p 216 99; store p 217 29; store p 218 415;
store p 219 34; store p 220 227; store p 221 228; store p 222 416; store p 223 219; store p 224 221; store p 225
268; store p 226 269
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 227},
    {'f': 18, 'a': 324, 'b': 36, 'by_c': 234},
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
input p 127; input p 128; input z 0; mul 753 754; input p 129; input z 1; mul 756 757; add 755 758; input p 130;
input z 2; mul 760 761; add 759 762; input p 131; input z 3; mul 764 765; add 763 766; sub 752 767; input p 132; abs
0; mul 769 770; mul 0 771; input p 133; mul 0 773; mul 0 0; input p 134; add 775 776; sqrt 777; div 2 778; mul 774
779; add 772 780; sub 768 781; add 751 782; input p 135; input x 12; sub 29 785; mul 784 786; input p 136; input x
13; sub 29 789; mul 788 790; add 787 791; sub 783 792; mul 0 63; mul 28 131; add 794 795; mul 48 621; add 796 797;
mul 0 798; mul 0 28; mul 31 131; add 800 801; mul 34 621; add 802 803; mul 131 804; add 799 805; mul 0 48; mul 34
131; add 807 808; mul 52 621; add 809 810; mul 621 811; add 806 812; mul 17 24; mul 17 814; mul 3 17; input p 137;
div 2 7; mul 817 818; mul 3 3; sub 7 820; div 2 821; mul 10 822; add 819 823; mul 816 824; mul 39 825; sub 815 826;
mul 23 827; mul 131 131; mul 828 829; add 813 830; mul 68 831; mul 24 825; mul 17 39; mul 17 834; add 833 835; mul
23 836; mul 829 837; sub 832 838; mul 22 839; sub 793 840; mul 91 841; mul 82 90; mul 151 266; mul 146 844; abs 3;
lt 846 281; input p 138; mul 276 848; mul 276 849; mul 276 850; mul 284 303; input p 139; mul 276 853; mul 276 854;
mul 852 855; add 851 856; mul 284 284; input p 140; mul 276 859; mul 858 860; add 857 861; mul 284 860; mul 852 863;
add 862 864; mul 284 858; input p 141; mul 866 867; add 865 868; mul 284 867; mul 858 870; add 869 871; mul 284 870;
mul 852 873; add 872 874; mul 287 302; add 875 876; mul 284 302; mul 291 878; add 877 879; mul 292 302; add 880 881;
mul 284 878; mul 295 883; add 882 884; mul 296 878; add 885 886; mul 297 302; add 887 888; mul 311 320; add 889 890;
mul 284 320; mul 315 892; add 891 893; mul 316 320; add 894 895; mul 328 335; add 896 897; mul 146 898; where 847
899; add 845 900; mul 593 723; sub 901 902; mul 151 742; add 903 904; mul 584 627; mul 712 720; add 906 907; add 905
908; sub 135 909; input p 142; mul 39 911; mul 17 912; add 910 913; input p 143; mul 767 915; sub 914 916; mul 42
831; mul 26 838; sub 918 919; mul 22 920; mul 19 825; mul 829 922; sub 921 923; sub 917 924; mul 843 925; sub 842
926; mul 87 90; input p 144; mul 35 929; input p 145; mul 215 931; add 930 932; input p 146; mul 219 934; add 933
935; mul 156 211; add 936 937; input p 147; mul 159 939; add 938 940; input p 148; mul 163 942; add 941 943; input p
149; mul 167 945; add 944 946; mul 171 228; add 947 948; input p 150; mul 175 950; add 949 951; mul 158 190; add 952
953; input p 151; mul 194 955; add 954 956; mul 170 198; add 957 958; input p 152; mul 202 960; add 959 961; mul 185
259; add 962 963; mul 203 258; add 964 965; mul 154 266; add 966 967; mul 146 968; abs 35; lt 970 273; mul 276 276;
mul 276 972; input p 153; mul 973 974; mul 276 974; mul 972 976; add 975 977; mul 276 303; mul 276 976; mul 979 980;
add 978 981; mul 276 284; mul 276 983; mul 848 984; add 982 985; mul 849 983; add 986 987; mul 284 850; add 988 989;
mul 276 858; mul 853 991; add 990 992; mul 854 858; add 993 994; mul 859 866; add 995 996; mul 276 302; mul 276 998;
mul 277 999; add 997 1000; mul 278 998; add 1001 1002; mul 279 302; add 1003 1004; mul 276 878; mul 285 1006; add
1005 1007; mul 286 878; add 1008 1009; mul 290 883; add 1010 1011; mul 276 320; mul 305 1013; add 1012 1014; mul 306
320; add 1015 1016; mul 310 892; add 1017 1018; mul 321 335; add 1019 1020; mul 146 1021; where 971 1022; add 969
1023; mul 620 723; sub 1024 1025; input p 154; mul 621 1027; mul 154 742; add 1028 1029; add 1026 1030; mul 54 831;
mul 22 1032; add 1031 1033; mul 928 1034; sub 927 1035; mul 57 71; mul 80 80; sub 1037 1038; mul 90 1039; mul 925
1040; mul 841 843; sub 1041 1042; mul 60 71; mul 77 80; sub 1044 1045; mul 90 1046; mul 1034 1047; add 1043 1048;
mul 841 928; mul 925 1047; sub 1050 1051; mul 46 71; mul 77 77; sub 1053 1054; mul 90 1055; mul 1034 1056; sub 1052
1057; mul 572 625; input p 155; mul 551 1060; sub 1059 1061; mul 700 718; mul 682 1060; sub 1063 1064; input p 156;
mul 554 1066; sub 1059 1067; mul 685 1066; sub 1063 1069; input p 157; mul 558 1071; sub 1059 1072; mul 689 1071;
sub 1063 1074; input p 158; mul 786 1076; input p 159; mul 790 1078; le 2 754; mul 131 915; add 0 1081; lt 141 1082;
and 1080 1083; constant -1.0; le 754 1085; lt 1082 141; and 1086 1087; or 1084 1088; not 1089; input p 160; mul 1082
1091; where 1090 1092; le 2 757; and 1083 1094; le 757 1085; and 1087 1096; or 1095 1097; not 1098; input p 161; mul
1082 1100; where 1099 1101; le 2 761; and 1083 1103; le 761 1085; and 1087 1105; or 1104 1106; not 1107; input p
162; mul 1082 1109; where 1108 1110; le 2 765; and 1083 1112; le 765 1085; and 1087 1114; or 1113 1115; not 1116;
input p 163; mul 1082 1118; where 1117 1119; mul 42 303; mul 28 1121; mul 22 1122; mul 57 1123; mul 54 303; mul 48
1125; mul 22 1126; mul 46 1127; add 1124 1128; mul 28 54; mul 42 48; add 1130 1131; mul 22 1132; mul 60 1133; add
1134 1134; sub 1129 1135; mul 90 1136; mul 90 91; mul 68 303; mul 63 1139; mul 22 1140; mul 62 1141; mul 71 1136;
add 1142 1143; mul 42 63; mul 28 68; add 1145 1146; mul 22 1147; mul 82 1148; mul 57 1148; mul 77 1127; add 1150
1151; mul 80 1133; mul 48 68; mul 54 63; add 1154 1155; mul 22 1156; mul 60 1157; add 1153 1158; sub 1152 1159; mul
77 1160; add 1149 1161; sub 1144 1162; mul 87 1157; mul 60 1148; mul 77 1133; add 1165 1166; mul 80 1123; mul 46
1157; add 1168 1169; sub 1167 1170; mul 80 1171; add 1164 1172; add 1163 1173; mul 1138 1174; sub 1137 1175; mul 841
1176; mul 101 107; mul 103 1178; mul 101 115; sub 1179 1180; mul 101 119; mul 101 1182; sub 1181 1183; input p 164;
input p 165; mul 35 1186; mul 158 1187; add 1185 1188; mul 35 1187; mul 162 1190; add 1189 1191; mul 156 303; mul
1186 1193; mul 166 1194; add 1192 1195; mul 35 1194; mul 170 1197; add 1196 1198; mul 156 1194; mul 167 1186; add
1200 1201; mul 174 1202; add 1199 1203; input p 166; add 1204 1205; mul 35 145; mul 181 1207; add 1206 1208; mul 35
1207; mul 185 1210; add 1209 1211; mul 145 156; mul 149 1186; add 1213 1214; mul 189 1215; add 1212 1216; mul 35
1215; mul 193 1218; add 1217 1219; mul 156 1215; mul 190 1186; add 1221 1222; mul 197 1223; add 1220 1224; mul 149
303; mul 145 1226; mul 156 1227; mul 202 1186; add 1228 1229; mul 201 1230; add 1225 1231; mul 149 1227; mul 145
202; add 1233 1234; mul 206 1235; add 1232 1236; input p 167; mul 225 1187; add 1238 1239; mul 228 1190; add 1240
1241; mul 231 1194; add 1242 1243; mul 234 1197; add 1244 1245; mul 237 1202; add 1246 1247; input p 168; add 1248
1249; mul 158 1207; add 1250 1251; mul 162 1210; add 1252 1253; mul 246 1215; add 1254 1255; mul 249 1218; add 1256
1257; mul 252 1223; add 1258 1259; mul 255 1227; add 1260 1261; mul 35 1227; mul 258 1263; add 1262 1264; mul 197
1230; add 1265 1266; mul 264 1235; add 1267 1268; mul 148 1269; add 1237 1270; mul 146 1271; le 301 271; le 271 301;
add 1273 1274; div 2 1275; mul 1273 1276; le 300 149; le 149 300; add 1278 1279; div 2 1280; mul 1278 1281; mul 145
1282; mul 1277 1283; mul 303 1284; mul 307 1285; mul 312 1285; add 1286 1287; mul 317 1285; add 1288 1289; mul 304
1284; mul 322 1291; add 1290 1292; mul 325 1285; mul 322 1284; mul 304 1295; add 1294 1296; add 1293 1297; mul 329
1291; add 1298 1299; mul 332 1285; mul 329 1284; mul 304 1302; add 1301 1303; add 1300 1304; mul 302 1291; mul 320
1284; add 1306 1307; mul 336 1308; add 1305 1309; mul 339 1291; mul 336 1284; mul 320 1312; add 1311 1313; add 1310
1314; mul 342 1285; mul 339 1284; mul 302 1312; add 1317 1318; mul 304 1319; add 1316 1320; add 1315 1321; mul 146
1322; where 272 1323; add 1272 1324; input p 169; mul 359 1190; add 1326 1327; mul 362 1202; add 1328 1329; input p
170; add 1330 1331; mul 368 1210; add 1332 1333; mul 371 1218; add 1334 1335; mul 374 1223; add 1336 1337; mul 377
1230; add 1338 1339; mul 380 1235; add 1340 1341; input p 171; mul 391 1190; add 1343 1344; mul 394 1197; add 1345
1346; mul 397 1202; add 1347 1348; input p 172; add 1349 1350; mul 359 1210; add 1351 1352; mul 404 1223; add 1353
1354; mul 407 1263; add 1355 1356; mul 374 1230; add 1357 1358; mul 412 1235; add 1359 1360; mul 148 1361; add 1342
1362; input p 173; add 1363 1364; mul 348 1365; mul 723 1366; mul 303 502; mul 383 1187; mul 35 1190; mul 385 1370;
add 1369 1371; mul 432 1194; add 1372 1373; mul 35 1197; mul 435 1375; add 1374 1376; mul 35 1202; mul 439 1378; add
1377 1379; mul 156 1202; mul 175 1186; add 1381 1382; mul 443 1383; add 1380 1384; mul 357 1215; add 1385 1386; mul
35 1218; mul 359 1388; add 1387 1389; mul 156 1223; mul 198 1186; add 1391 1392; mul 362 1393; add 1390 1394; mul
281 1227; add 1395 1396; mul 35 1263; mul 457 1398; add 1397 1399; mul 35 1230; mul 407 1401; add 1400 1402; mul 156
1230; mul 203 1186; add 1404 1405; mul 464 1406; add 1403 1407; mul 156 1235; mul 207 1186; add 1409 1410; mul 412
1411; add 1408 1412; mul 149 1235; mul 145 207; add 1414 1415; mul 471 1416; add 1413 1417; mul 149 1364; mul 145
356; add 1419 1420; input p 174; mul 3 1422; add 1421 1423; input p 175; mul 35 1425; add 1424 1426; mul 105 1427;
add 1418 1428; mul 348 1429; mul 1368 1430; mul 303 509; sub 1431 1432; mul 303 513; div 2 1434; mul 1433 1435; mul
503 1436; mul 303 1437; mul 303 516; mul 303 515; div 2 1440; mul 1437 1441; mul 517 1442; mul 1439 1443; neg 1444;
mul 303 1445; mul 517 1446; mul 522 1444; sub 1447 1448; sub 1438 1449; mul 520 1450; mul 537 1451; le 530 526; le
526 530; add 1453 1454; div 2 1455; mul 1453 1456; le 527 529; le 529 527; add 1458 1459; div 2 1460; mul 1458 1461;
mul 1437 1462; mul 1457 1463; mul 533 1464; mul 531 1465; mul 535 1464; add 1466 1467; mul 525 1468; add 1452 1469;
mul 542 1437; mul 529 1471; mul 544 1437; add 1472 1473; mul 540 1474; sub 1470 1475; mul 503 1476; mul 566 1437;
mul 529 1478; mul 568 1437; add 1479 1480; mul 564 1481; mul 563 1442; mul 516 1483; mul 564 1442; add 1484 1485;
mul 516 1486; mul 516 564; mul 1442 1488; add 1487 1489; mul 570 1490; sub 1482 1491; mul 503 1492; mul 560 1493;
add 1477 1494; mul 575 1493; mul 572 1496; mul 576 1493; add 1497 1498; mul 625 1499; mul 503 1444; mul 509 1501;
add 518 1502; mul 0 1503; mul 580 1430; add 578 1505; mul 518 1506; mul 582 1501; add 1507 1508; mul 17 1509; mul
131 1510; sub 1504 1511; mul 518 1430; mul 502 1501; sub 1513 1514; mul 623 1515; mul 589 1366; mul 151 1361; add
1422 1518; mul 348 1519; mul 131 1520; add 1517 1521; input p 176; mul 603 1190; add 1523 1524; mul 391 1197; add
1525 1526; mul 439 1202; add 1527 1528; mul 610 1218; add 1529 1530; mul 368 1263; add 1531 1532; mul 407 1230; add
1533 1534; mul 154 1361; add 1535 1536; add 1425 1537; mul 348 1538; mul 621 1539; add 1522 1540; mul 519 1541; add
1516 1542; add 1512 1543; mul 577 1544; add 1500 1545; add 1495 1546; mul 519 1547; mul 627 1515; add 1548 1549; mul
303 636; mul 1430 1551; mul 303 643; sub 1552 1553; mul 303 647; div 2 1555; mul 1554 1556; mul 637 1557; mul 303
1558; mul 303 650; mul 303 649; div 2 1561; mul 1558 1562; mul 651 1563; mul 1560 1564; neg 1565; mul 303 1566; mul
651 1567; mul 656 1565; sub 1568 1569; sub 1559 1570; mul 654 1571; mul 668 1572; le 661 526; le 526 661; add 1574
1575; div 2 1576; mul 1574 1577; le 527 660; le 660 527; add 1579 1580; div 2 1581; mul 1579 1582; mul 1558 1583;
mul 1578 1584; mul 664 1585; mul 662 1586; mul 666 1585; add 1587 1588; mul 659 1589; add 1573 1590; mul 673 1558;
mul 660 1592; mul 675 1558; add 1593 1594; mul 671 1595; sub 1591 1596; mul 637 1597; mul 566 1558; mul 660 1599;
mul 696 1558; add 1600 1601; mul 694 1602; mul 693 1563; mul 650 1604; mul 694 1563; add 1605 1606; mul 650 1607;
mul 650 694; mul 1563 1609; add 1608 1610; mul 698 1611; sub 1603 1612; mul 637 1613; mul 691 1614; add 1598 1615;
mul 703 1614; mul 700 1617; mul 704 1614; add 1618 1619; mul 718 1620; mul 708 1430; sub 1622 706; mul 652 1623; mul
637 1565; mul 710 1625; sub 1624 1626; mul 17 1627; mul 131 1628; mul 643 1625; add 652 1630; mul 0 1631; add 1629
1632; mul 652 1430; mul 636 1625; sub 1634 1635; mul 623 1636; mul 653 1541; add 1637 1638; add 1633 1639; mul 705
1640; add 1621 1641; add 1616 1642; mul 653 1643; mul 720 1636; add 1644 1645; add 1550 1646; mul 418 1647; sub 1367
1648; sub 1325 1649; mul 145 1650; mul 586 1547; mul 627 1503; sub 1652 1653; mul 714 1643; mul 720 1631; sub 1655
1656; add 1654 1657; sub 1651 1658; sub 1184 1659; input p 177; sub 1660 1661; mul 63 831; mul 22 1663; sub 1662
1664; mul 91 1665; add 1177 1666; mul 90 1160; mul 90 843; mul 1174 1669; sub 1668 1670; mul 925 1671; mul 151 1269;
mul 146 1673; mul 287 1284; mul 284 1284; mul 291 1676; add 1675 1677; mul 292 1284; add 1678 1679; mul 284 1676;
mul 295 1681; add 1680 1682; mul 296 1676; add 1683 1684; mul 297 1284; add 1685 1686; mul 311 1291; add 1687 1688;
mul 284 1291; mul 315 1690; add 1689 1691; mul 316 1291; add 1692 1693; mul 328 1308; add 1694 1695; mul 146 1696;
where 847 1697; add 1674 1698; mul 723 1520; mul 593 1647; sub 1700 1701; sub 1699 1702; mul 584 1547; mul 627 1510;
sub 1704 1705; mul 712 1643; mul 720 1628; add 1707 1708; add 1706 1709; add 1703 1710; sub 1182 1711; mul 28 831;
mul 22 1713; sub 1712 1714; mul 843 1715; add 1672 1716; sub 1667 1717; mul 90 1171; mul 90 928; mul 1174 1720; sub
1719 1721; mul 1034 1722; input p 178; mul 939 1187; add 1724 1725; mul 942 1190; add 1726 1727; mul 945 1194; add
1728 1729; mul 228 1197; add 1730 1731; mul 950 1202; add 1732 1733; mul 158 1215; add 1734 1735; mul 955 1218; add
1736 1737; mul 170 1223; add 1738 1739; mul 960 1227; add 1740 1741; mul 185 1263; add 1742 1743; mul 258 1230; add
1744 1745; mul 154 1269; add 1746 1747; mul 146 1748; mul 276 1284; mul 276 1750; mul 277 1751; mul 278 1750; add
1752 1753; mul 279 1284; add 1754 1755; mul 276 1676; mul 285 1757; add 1756 1758; mul 286 1676; add 1759 1760; mul
290 1681; add 1761 1762; mul 276 1291; mul 305 1764; add 1763 1765; mul 306 1291; add 1766 1767; mul 310 1690; add
1768 1769; mul 321 1308; add 1770 1771; mul 146 1772; where 971 1773; add 1749 1774; mul 723 1539; mul 620 1647; sub
1776 1777; sub 1775 1778; mul 48 831; mul 22 1780; add 1779 1781; mul 928 1782; add 1723 1783; sub 1718 1784; input
c_q 0; mul 91 1786; le 141 140; le 140 141; add 1788 1789; div 2 1790; mul 1788 1791; mul 0 91; mul 1792 1793; input
c_q 1; mul 1794 1795; sub 1787 1796; mul 91 94; input c_q 2; mul 1798 1799; add 1797 1800; mul 91 98; input c_q 3;
mul 1802 1803; add 1801 1804; mul 91 101; add 843 1806; input c_q 4; mul 1807 1808; sub 1805 1809; mul 103 1807;
input c_q 5; mul 1811 1812; add 1810 1813; mul 94 1807; input c_q 6; mul 1815 1816; sub 1814 1817; mul 98 1807;
input c_q 7; mul 1819 1820; sub 1818 1821; le 129 128; le 128 129; add 1823 1824; div 2 1825; mul 1823 1826; mul 133
1807; mul 1827 1828; input c_q 8; mul 1829 1830; add 1822 1831; mul 91 103; input c_q 9; mul 1833 1834; add 1832
1835; mul 103 1833; mul 105 1837; input c_q 10; mul 1838 1839; sub 1836 1840; mul 94 1833; input c_q 11; mul 1842
1843; add 1841 1844; mul 98 1833; input c_q 12; mul 1846 1847; add 1845 1848; add 1785 1849; mul 57 1141; mul 71
1127; add 1851 1852; mul 80 1157; add 1854 1854; sub 1853 1855; mul 90 1856; mul 90 1040; mul 1174 1858; sub 1857
1859; mul 925 1860; mul 1040 1715; add 1861 1862; mul 841 1671; mul 843 1665; add 1864 1865; sub 1863 1866; mul 60
1141; mul 71 1133; add 1868 1869; mul 77 1157; mul 80 1148; add 1871 1872; sub 1870 1873; mul 90 1874; mul 90 1047;
mul 1174 1876; sub 1875 1877; mul 1034 1878; mul 1047 1782; add 1879 1880; add 1867 1881; mul 0 843; mul 1792 1883;
mul 1795 1884; mul 843 1786; sub 1885 1886; mul 94 843; mul 1799 1888; sub 1887 1889; mul 98 843; mul 1803 1891; sub
1890 1892; mul 101 843; add 1040 1894; mul 1808 1895; add 1893 1896; mul 103 1895; mul 1812 1898; sub 1897 1899; mul
94 1895; mul 1816 1901; add 1900 1902; mul 98 1895; mul 1820 1904; add 1903 1905; mul 133 1895; mul 1827 1907; mul
1830 1908; sub 1906 1909; mul 103 843; mul 1834 1911; sub 1910 1912; mul 103 1911; mul 105 1914; mul 1839 1915; add
1913 1916; mul 94 1911; mul 1843 1918; sub 1917 1919; mul 98 1911; mul 1847 1921; sub 1920 1922; add 1882 1923; mul
841 1722; mul 928 1665; add 1925 1926; mul 925 1878; mul 1047 1715; add 1928 1929; sub 1927 1930; mul 46 1141; mul
71 1123; add 1932 1933; mul 77 1148; add 1935 1935; sub 1934 1936; mul 90 1937; mul 90 1056; mul 1174 1939; sub 1938
1940; mul 1034 1941; mul 1056 1782; add 1942 1943; sub 1931 1944; mul 928 1786; mul 0 928; mul 1792 1947; mul 1795
1948; sub 1946 1949; mul 94 928; mul 1799 1951; add 1950 1952; mul 98 928; mul 1803 1954; add 1953 1955; mul 101
928; add 1047 1957; mul 1808 1958; sub 1956 1959; mul 103 1958; mul 1812 1961; add 1960 1962; mul 94 1958; mul 1816
1964; sub 1963 1965; mul 98 1958; mul 1820 1967; sub 1966 1968; mul 133 1958; mul 1827 1970; mul 1830 1971; add 1969
1972; mul 103 928; mul 1834 1974; add 1973 1975; mul 103 1974; mul 105 1977; mul 1839 1978; sub 1976 1979; mul 94
1974; mul 1843 1981; add 1980 1982; mul 98 1974; mul 1847 1984; add 1983 1985; add 1945 1986; mul 625 1493; mul 572
1544; add 1988 1989; mul 718 1614; mul 700 1640; add 1991 1992; mul 101 130; mul 101 1994; add 142 1995; mul 417
519; sub 1997 586; mul 577 1998; mul 519 1999; mul 417 653; sub 2001 714; mul 705 2002; mul 653 2003; add 2000 2004;
mul 418 2005; input p 179; add 2006 2007; mul 145 2008; mul 586 1999; mul 714 2003; add 2010 2011; sub 2009 2012;
add 1996 2013; sign 0; mul 769 2015; mul 0 2016; add 771 2017; mul 773 779; mul 779 780; mul 0 779; mul 2020 2021;
sub 2019 2022; add 2018 2023; add 2014 2024; add 794 798; add 795 2026; add 797 2027; mul 68 2028; mul 22 2029; add
2025 2030; mul 91 2031; mul 593 2005; input p 180; add 2033 2034; mul 584 1999; mul 712 2003; add 2036 2037; add
2035 2038; sub 1994 2039; mul 42 2028; mul 22 2041; sub 2040 2042; mul 843 2043; add 2032 2044; mul 620 2005; input
p 181; add 2046 2047; mul 54 2028; mul 22 2049; add 2048 2050; mul 928 2051; add 2045 2052; neg 2053; mul 1040 2043;
mul 843 2031; add 2055 2056; mul 1047 2051; add 2057 2058; mul 928 2031; mul 1047 2043; add 2060 2061; mul 1056
2051; add 2062 2063; neg 2064; mul 572 1998; mul 700 2002; where 1090 1091; where 1099 1100; where 1108 1109; where
1117 1118; mul 26 303; mul 11 303; mul 16 2073; mul 16 24; mul 5 9; mul 14 2076; div 2 14; mul 11 2078; mul 8 2079;
add 2077 2080; mul 2075 2081; sub 2074 2082; mul 23 2083; mul 17 2084; mul 9 9; mul 2076 2086; mul 16 2087; mul 16
17; mul 2081 2089; add 2088 2090; mul 25 2091; sub 2085 2092; mul 2072 2093; mul 3 2079; add 14 2095; mul 16 2096;
mul 16 39; mul 2081 2098; sub 2097 2099; mul 23 2100; mul 17 2101; mul 40 2091; sub 2102 2103; add 31 2104; mul 1121
2105; add 2094 2106; mul 22 2107; mul 18 2091; mul 17 2109; mul 19 2091; add 2110 2111; sub 2108 2112; mul 57 2113;
mul 34 1125; mul 22 2115; mul 46 2116; add 2114 2117; mul 54 2105; mul 34 42; add 2119 2120; mul 22 2121; mul 60
2122; add 2123 2123; sub 2118 2124; mul 90 2125; mul 28 1139; mul 22 2127; mul 62 2128; mul 71 2125; add 2129 2130;
mul 28 42; mul 68 2105; add 2132 2133; add 2093 2134; mul 22 2135; mul 82 2136; mul 57 2136; mul 77 2116; add 2138
2139; mul 80 2122; mul 34 68; add 1130 2142; mul 22 2143; mul 60 2144; add 2141 2145; sub 2140 2146; mul 77 2147;
add 2137 2148; sub 2131 2149; mul 87 2144; mul 60 2136; mul 77 2122; add 2152 2153; mul 80 2113; mul 46 2144; add
2155 2156; sub 2154 2157; mul 80 2158; add 2151 2159; add 2150 2160; mul 1138 2161; sub 2126 2162; mul 841 2163; sub
115 108; add 1182 2165; input p 182; mul 35 151; mul 158 2168; add 2167 2169; mul 35 2168; mul 162 2171; add 2170
2172; mul 151 1193; mul 166 2174; add 2173 2175; mul 35 2174; mul 170 2177; add 2176 2178; mul 156 2174; mul 151
167; add 2180 2181; mul 174 2182; add 2179 2183; mul 149 151; mul 189 2185; add 2184 2186; mul 35 2185; mul 193
2188; add 2187 2189; mul 156 2185; mul 151 190; add 2191 2192; mul 197 2193; add 2190 2194; mul 151 202; mul 201
2196; add 2195 2197; input p 183; mul 225 2168; add 2199 2200; mul 228 2171; add 2201 2202; mul 231 2174; add 2203
2204; mul 234 2177; add 2205 2206; mul 237 2182; add 2207 2208; mul 246 2185; add 2209 2210; mul 249 2188; add 2211
2212; mul 252 2193; add 2213 2214; mul 197 2196; add 2215 2216; mul 148 2217; add 2198 2218; mul 146 2219; le 283
281; le 281 283; add 2221 2222; div 2 2223; mul 2221 2224; le 282 3; le 3 282; add 2226 2227; div 2 2228; mul 2226
2229; mul 2225 2230; mul 287 2231; mul 292 2231; mul 291 2231; mul 284 2234; add 2233 2235; add 2232 2236; mul 297
2231; mul 296 2231; mul 295 2231; mul 284 2240; add 2239 2241; mul 284 2242; add 2238 2243; add 2237 2244; mul 311
2231; mul 304 2246; add 2245 2247; mul 316 2231; mul 315 2231; mul 284 2250; add 2249 2251; mul 304 2252; add 2248
2253; mul 328 2231; mul 320 2255; add 2254 2256; mul 302 2255; mul 304 2258; add 2257 2259; mul 146 2260; where 272
2261; add 2220 2262; input p 184; mul 359 2171; add 2264 2265; mul 362 2182; add 2266 2267; mul 371 2188; add 2268
2269; mul 374 2193; add 2270 2271; mul 377 2196; add 2272 2273; input p 185; mul 391 2171; add 2275 2276; mul 394
2177; add 2277 2278; mul 397 2182; add 2279 2280; mul 404 2193; add 2281 2282; mul 374 2196; add 2283 2284; mul 148
2285; add 2274 2286; add 351 2287; mul 348 2288; mul 723 2289; mul 500 2083; mul 497 2100; add 2291 2292; mul 1432
2293; mul 383 2168; mul 35 2171; mul 385 2296; add 2295 2297; mul 432 2174; add 2298 2299; mul 35 2177; mul 435
2301; add 2300 2302; mul 35 2182; mul 439 2304; add 2303 2305; mul 156 2182; mul 151 175; add 2307 2308; mul 443
2309; add 2306 2310; mul 357 2185; add 2311 2312; mul 35 2188; mul 359 2314; add 2313 2315; mul 156 2193; mul 151
198; add 2317 2318; mul 362 2319; add 2316 2320; mul 35 2196; mul 407 2322; add 2321 2323; mul 156 2196; mul 151
203; add 2325 2326; mul 464 2327; add 2324 2328; mul 151 207; mul 412 2330; add 2329 2331; add 478 482; add 476
2333; add 481 2334; mul 105 2335; add 2332 2336; mul 348 2337; mul 497 2083; add 2338 2339; mul 500 2100; sub 2340
2341; mul 1368 2342; add 2294 2343; mul 1435 2344; mul 503 2345; mul 303 2346; mul 1441 2346; mul 517 2348; mul 1439
2349; neg 2350; mul 303 2351; mul 517 2352; mul 522 2350; sub 2353 2354; sub 2347 2355; mul 520 2356; mul 537 2357;
mul 1462 2346; mul 1457 2359; mul 533 2360; mul 531 2361; mul 535 2360; add 2362 2363; mul 525 2364; add 2358 2365;
mul 542 2346; mul 529 2367; mul 544 2346; add 2368 2369; mul 540 2370; sub 2366 2371; mul 503 2372; mul 566 2346;
mul 529 2374; mul 568 2346; add 2375 2376; mul 564 2377; mul 563 2348; mul 516 2379; mul 564 2348; add 2380 2381;
mul 516 2382; mul 1488 2348; add 2383 2384; mul 570 2385; sub 2378 2386; mul 503 2387; mul 560 2388; add 2373 2389;
mul 575 2388; mul 572 2391; mul 576 2388; add 2392 2393; mul 625 2394; mul 578 2293; sub 2339 2341; mul 509 2397;
add 2396 2398; mul 580 2342; mul 502 2293; add 2400 2401; sub 2399 2402; mul 518 2403; mul 503 2350; mul 582 2405;
sub 2404 2406; mul 17 2407; mul 583 2091; sub 2408 2409; mul 131 2410; mul 518 2293; mul 509 2405; sub 2412 2413;
mul 0 2414; sub 2411 2415; mul 518 2342; mul 502 2405; sub 2417 2418; mul 623 2419; mul 589 2289; mul 151 2285; add
477 2422; mul 348 2423; mul 131 2424; add 2421 2425; input p 186; mul 603 2171; add 2427 2428; mul 391 2177; add
2429 2430; mul 439 2182; add 2431 2432; mul 610 2188; add 2433 2434; mul 407 2196; add 2435 2436; mul 154 2285; add
2437 2438; add 480 2439; mul 348 2440; mul 621 2441; add 2426 2442; mul 519 2443; add 2420 2444; add 2416 2445; mul
577 2446; add 2395 2447; add 2390 2448; mul 519 2449; mul 627 2419; add 2450 2451; mul 631 2100; mul 634 2083; sub
2453 2454; mul 1553 2455; mul 631 2083; add 2338 2457; mul 634 2100; add 2458 2459; mul 1551 2460; add 2456 2461;
mul 1556 2462; mul 637 2463; mul 303 2464; mul 1562 2464; mul 651 2466; mul 1560 2467; neg 2468; mul 303 2469; mul
651 2470; mul 656 2468; sub 2471 2472; sub 2465 2473; mul 654 2474; mul 668 2475; mul 1583 2464; mul 1578 2477; mul
664 2478; mul 662 2479; mul 666 2478; add 2480 2481; mul 659 2482; add 2476 2483; mul 673 2464; mul 660 2485; mul
675 2464; add 2486 2487; mul 671 2488; sub 2484 2489; mul 637 2490; mul 566 2464; mul 660 2492; mul 696 2464; add
2493 2494; mul 694 2495; mul 693 2466; mul 650 2497; mul 694 2466; add 2498 2499; mul 650 2500; mul 1609 2466; add
2501 2502; mul 698 2503; sub 2496 2504; mul 637 2505; mul 691 2506; add 2491 2507; mul 703 2506; mul 700 2509; mul
704 2506; add 2510 2511; mul 718 2512; mul 706 2455; add 2457 2459; mul 643 2515; add 2514 2516; mul 708 2460; sub
2454 2453; mul 636 2519; add 2518 2520; add 2517 2521; mul 652 2522; mul 637 2468; mul 710 2524; sub 2523 2525; mul
17 2526; mul 711 2091; sub 2527 2528; mul 131 2529; mul 652 2455; mul 643 2524; sub 2531 2532; mul 0 2533; sub 2530
2534; mul 652 2460; mul 636 2524; sub 2536 2537; mul 623 2538; mul 653 2443; add 2539 2540; add 2535 2541; mul 705
2542; add 2513 2543; add 2508 2544; mul 653 2545; mul 720 2538; add 2546 2547; add 2452 2548; mul 418 2549; sub 2290
2550; sub 2263 2551; mul 145 2552; mul 586 2449; mul 627 2414; add 2554 2555; mul 714 2545; mul 720 2533; add 2557
2558; add 2556 2559; sub 2553 2560; sub 2166 2561; mul 17 2083; mul 24 2091; sub 2563 2564; mul 17 2565; mul 814
2091; sub 2566 2567; mul 825 2100; mul 3 2091; sub 17 2570; mul 824 2571; mul 818 819; mul 5 303; mul 2573 2574; mul
822 823; mul 3 303; sub 2574 2577; mul 2576 2578; add 2575 2579; mul 816 2580; sub 2572 2581; mul 39 2582; add 2569
2583; sub 2568 2584; mul 23 2585; mul 829 2586; mul 68 2587; add 1713 2588; mul 825 2083; mul 24 2582; add 2590
2591; mul 17 2100; mul 39 2091; sub 2593 2594; mul 17 2595; mul 834 2091; sub 2596 2597; add 2592 2598; mul 23 2599;
mul 829 2600; sub 2589 2601; mul 22 2602; sub 2562 2603; mul 91 2604; add 2164 2605; mul 90 2147; mul 1669 2161; sub
2607 2608; mul 925 2609; mul 911 2100; mul 17 2611; mul 912 2091; sub 2612 2613; mul 151 2217; mul 146 2615; mul 303
2231; mul 855 2617; mul 852 2231; mul 860 2619; add 2618 2620; mul 863 2617; mul 860 2231; mul 852 2623; add 2622
2624; add 2621 2625; mul 284 2619; mul 858 2231; add 2627 2628; mul 867 2629; add 2626 2630; mul 870 2619; mul 867
2231; mul 858 2633; add 2632 2634; add 2631 2635; mul 873 2617; mul 870 2231; mul 284 2633; add 2638 2639; mul 852
2640; add 2637 2641; add 2636 2642; mul 302 2231; mul 291 2644; add 2643 2645; mul 302 2234; add 2646 2647; mul 284
2644; mul 878 2231; add 2649 2650; mul 295 2651; add 2648 2652; mul 296 2644; mul 878 2240; add 2654 2655; add 2653
2656; mul 302 2242; add 2657 2658; mul 320 2231; mul 315 2660; add 2659 2661; mul 320 2250; add 2662 2663; mul 146
2664; where 847 2665; add 2616 2666; mul 723 2424; mul 593 2549; sub 2668 2669; sub 2667 2670; mul 584 2449; mul 627
2410; add 2672 2673; mul 712 2545; mul 720 2529; add 2675 2676; add 2674 2677; add 2671 2678; add 119 2679; sub 2614
2680; mul 831 2105; mul 42 2587; add 2682 2683; mul 838 2093; mul 26 2601; add 2685 2686; sub 2684 2687; mul 22
2688; mul 19 2582; mul 825 2109; sub 2690 2691; mul 829 2692; sub 2689 2693; sub 2681 2694; mul 843 2695; add 2610
2696; sub 2606 2697; mul 90 2158; mul 1720 2161; sub 2699 2700; mul 1034 2701; input p 187; mul 939 2168; add 2703
2704; mul 942 2171; add 2705 2706; mul 945 2174; add 2707 2708; mul 228 2177; add 2709 2710; mul 950 2182; add 2711
2712; mul 158 2185; add 2713 2714; mul 955 2188; add 2715 2716; mul 170 2193; add 2717 2718; mul 258 2196; add 2719
2720; mul 154 2217; add 2721 2722; mul 146 2723; mul 276 2231; mul 276 2725; mul 848 2726; mul 849 2725; add 2727
2728; mul 850 2231; add 2729 2730; mul 276 2619; mul 853 2732; add 2731 2733; mul 854 2619; add 2734 2735; mul 859
2629; add 2736 2737; mul 276 2644; mul 285 2739; add 2738 2740; mul 286 2644; add 2741 2742; mul 290 2651; add 2743
2744; mul 310 2660; add 2745 2746; mul 146 2747; where 971 2748; add 2724 2749; mul 723 2441; mul 620 2549; sub 2751
2752; sub 2750 2753; mul 34 831; mul 54 2587; add 2755 2756; mul 22 2757; add 2754 2758; mul 928 2759; add 2702
2760; sub 2698 2761; mul 57 2128; mul 71 2116; add 2763 2764; mul 80 2144; add 2766 2766; sub 2765 2767; mul 90
2768; mul 1858 2161; sub 2769 2770; mul 925 2771; mul 1040 2695; add 2772 2773; mul 841 2609; mul 843 2604; add 2775
2776; sub 2774 2777; mul 60 2128; mul 71 2122; add 2779 2780; mul 77 2144; mul 80 2136; add 2782 2783; sub 2781
2784; mul 90 2785; mul 1876 2161; sub 2786 2787; mul 1034 2788; mul 1047 2759; add 2789 2790; add 2778 2791; mul 841
2701; mul 928 2604; add 2793 2794; mul 925 2788; mul 1047 2695; add 2796 2797; sub 2795 2798; mul 46 2128; mul 71
2113; add 2800 2801; mul 77 2136; add 2803 2803; sub 2802 2804; mul 90 2805; mul 1939 2161; sub 2806 2807; mul 1034
2808; mul 1056 2759; add 2809 2810; sub 2799 2811; mul 625 2388; mul 572 2446; add 2813 2814; mul 718 2506; mul 700
2542; add 2816 2817; mul 519 593; add 584 2819; mul 577 2820; mul 519 2821; mul 593 653; add 712 2823; mul 705 2824;
mul 653 2825; add 2822 2826; mul 418 2827; input p 188; add 2828 2829; mul 145 2830; mul 586 2821; mul 714 2825; add
2832 2833; sub 2831 2834; sub 1994 2835; add 801 804; add 800 2837; add 803 2838; mul 131 303; mul 828 2840; add
2839 2841; mul 68 2842; mul 837 2840; sub 2843 2844; mul 22 2845; sub 2836 2846; mul 91 2847; mul 593 2827; input p
189; add 2849 2850; mul 584 2821; mul 712 2825; add 2852 2853; add 2851 2854; add 130 2855; mul 42 2842; mul 26
2844; sub 2857 2858; mul 22 2859; mul 922 2840; sub 2860 2861; add 2856 2862; mul 843 2863; add 2848 2864; mul 620
2827; input p 190; add 2866 2867; mul 54 2842; mul 22 2869; add 2868 2870; mul 928 2871; sub 2865 2872; mul 1047
2871; mul 1040 2863; mul 843 2847; add 2875 2876; sub 2874 2877; mul 928 2847; mul 1047 2863; add 2879 2880; mul
1056 2871; sub 2881 2882; mul 572 2820; mul 700 2824; input p 191; where 1090 2886; input p 192; where 1099 2888;
input p 193; where 1108 2890; input p 194; where 1117 2892; mul 34 1121; mul 22 2894; mul 57 2895; mul 52 1125; mul
22 2897; mul 46 2898; add 2896 2899; mul 34 54; mul 42 52; add 2901 2902; mul 22 2903; mul 60 2904; add 2905 2905;
sub 2900 2906; mul 90 2907; mul 48 1139; mul 22 2909; mul 62 2910; mul 71 2907; add 2911 2912; add 1131 2142; mul 22
2914; mul 82 2915; mul 57 2915; mul 77 2898; add 2917 2918; mul 80 2904; mul 52 68; mul 48 54; add 2921 2922; mul 22
2923; mul 60 2924; add 2920 2925; sub 2919 2926; mul 77 2927; add 2916 2928; sub 2913 2929; mul 87 2924; mul 60
2915; mul 77 2904; add 2932 2933; mul 80 2895; mul 46 2924; add 2935 2936; sub 2934 2937; mul 80 2938; add 2931
2939; add 2930 2940; mul 1138 2941; sub 2908 2942; mul 841 2943; input p 195; add 155 156; mul 158 2946; add 2945
2947; mul 35 2946; add 159 2949; mul 162 2950; add 2948 2951; mul 154 1193; mul 166 2953; add 2952 2954; mul 35
2953; add 167 2956; mul 170 2957; add 2955 2958; mul 156 2953; mul 154 167; add 2960 2961; mul 174 2962; add 2959
2963; mul 149 181; add 2964 2965; mul 182 303; mul 185 2967; add 2966 2968; mul 149 154; mul 189 2970; add 2969
2971; mul 35 2970; add 190 2973; mul 193 2974; add 2972 2975; mul 156 2970; mul 154 190; add 2977 2978; mul 197
2979; add 2976 2980; mul 154 202; mul 201 2982; add 2981 2983; mul 35 303; mul 214 2985; add 211 2986; mul 35 2985;
add 215 2988; mul 218 2989; add 2987 2990; input p 196; add 2991 2992; mul 225 2946; add 2993 2994; mul 228 2950;
add 2995 2996; mul 231 2953; add 2997 2998; mul 234 2957; add 2999 3000; mul 237 2962; add 3001 3002; mul 149 158;
add 3003 3004; mul 162 2967; add 3005 3006; mul 246 2970; add 3007 3008; mul 249 2974; add 3009 3010; mul 252 2979;
add 3011 3012; mul 202 258; add 3013 3014; mul 197 2982; add 3015 3016; mul 148 3017; add 2984 3018; mul 146 3019;
le 275 273; le 273 275; add 3021 3022; div 2 3023; mul 3021 3024; le 274 35; le 35 274; add 3026 3027; div 2 3028;
mul 3026 3029; mul 3025 3030; mul 279 3031; mul 278 3031; mul 277 3031; mul 276 3034; add 3033 3035; mul 276 3036;
add 3032 3037; mul 286 3031; mul 285 3031; mul 276 3040; add 3039 3041; mul 284 3042; add 3038 3043; mul 290 3031;
mul 284 3045; mul 284 3046; add 3044 3047; mul 306 3031; mul 305 3031; mul 276 3050; add 3049 3051; mul 304 3052;
add 3048 3053; mul 310 3031; mul 284 3055; mul 304 3056; add 3054 3057; mul 321 3031; mul 320 3059; add 3058 3060;
mul 302 3059; mul 304 3062; add 3061 3063; mul 146 3064; where 272 3065; add 3020 3066; input p 197; mul 359 2950;
add 3068 3069; mul 362 2962; add 3070 3071; mul 368 2967; add 3072 3073; mul 371 2974; add 3074 3075; mul 374 2979;
add 3076 3077; mul 377 2982; add 3078 3079; mul 385 2989; add 383 3081; input p 198; add 3082 3083; mul 391 2950;
add 3084 3085; mul 394 2957; add 3086 3087; mul 397 2962; add 3088 3089; mul 359 2967; add 3090 3091; mul 404 2979;
add 3092 3093; mul 202 407; add 3094 3095; mul 374 2982; add 3096 3097; mul 148 3098; add 3080 3099; add 354 3100;
mul 348 3101; mul 723 3102; mul 35 2989; add 219 3104; mul 423 3105; add 597 3106; mul 383 2946; add 3107 3108; mul
35 2950; add 163 3110; mul 385 3111; add 3109 3112; mul 432 2953; add 3113 3114; mul 35 2957; add 171 3116; mul 435
3117; add 3115 3118; mul 35 2962; add 175 3120; mul 439 3121; add 3119 3122; mul 156 2962; mul 154 175; add 3124
3125; mul 443 3126; add 3123 3127; mul 357 2970; add 3128 3129; mul 35 2974; add 194 3131; mul 359 3132; add 3130
3133; mul 156 2979; mul 154 198; add 3135 3136; mul 362 3137; add 3134 3138; mul 259 303; mul 457 3140; add 3139
3141; mul 35 2982; add 203 3143; mul 407 3144; add 3142 3145; mul 156 2982; mul 154 203; add 3147 3148; mul 464
3149; add 3146 3150; mul 154 207; mul 412 3152; add 3151 3153; add 489 490; add 487 3155; mul 105 3156; add 3154
3157; mul 348 3158; mul 1368 3159; mul 1435 3160; mul 503 3161; mul 303 3162; mul 1441 3162; mul 517 3164; mul 1439
3165; neg 3166; mul 303 3167; mul 517 3168; mul 522 3166; sub 3169 3170; sub 3163 3171; mul 520 3172; mul 537 3173;
mul 1462 3162; mul 1457 3175; mul 533 3176; mul 531 3177; mul 535 3176; add 3178 3179; mul 525 3180; add 3174 3181;
mul 542 3162; mul 529 3183; mul 544 3162; add 3184 3185; mul 540 3186; sub 3182 3187; mul 503 3188; mul 566 3162;
mul 529 3190; mul 568 3162; add 3191 3192; mul 564 3193; mul 563 3164; mul 516 3195; mul 564 3164; add 3196 3197;
mul 516 3198; mul 1488 3164; add 3199 3200; mul 570 3201; sub 3194 3202; mul 503 3203; mul 560 3204; add 3189 3205;
mul 575 3204; mul 572 3207; mul 576 3204; add 3208 3209; mul 625 3210; mul 503 3166; mul 509 3212; mul 0 3213; mul
580 3159; mul 518 3215; mul 582 3212; add 3216 3217; mul 17 3218; mul 131 3219; sub 3214 3220; mul 518 3159; mul 502
3212; sub 3222 3223; mul 623 3224; mul 589 3102; mul 151 3098; add 480 3227; mul 348 3228; mul 131 3229; add 3226
3230; mul 598 2989; add 596 3232; input p 199; add 3233 3234; mul 603 2950; add 3235 3236; mul 391 2957; add 3237
3238; mul 439 2962; add 3239 3240; mul 610 2974; add 3241 3242; mul 202 368; add 3243 3244; mul 407 2982; add 3245
3246; mul 154 3098; add 3247 3248; add 488 3249; mul 348 3250; mul 621 3251; add 3231 3252; mul 519 3253; add 3225
3254; add 3221 3255; mul 577 3256; add 3211 3257; add 3206 3258; mul 519 3259; mul 627 3224; add 3260 3261; mul 1551
3159; mul 1556 3263; mul 637 3264; mul 303 3265; mul 1562 3265; mul 651 3267; mul 1560 3268; neg 3269; mul 303 3270;
mul 651 3271; mul 656 3269; sub 3272 3273; sub 3266 3274; mul 654 3275; mul 668 3276; mul 1583 3265; mul 1578 3278;
mul 664 3279; mul 662 3280; mul 666 3279; add 3281 3282; mul 659 3283; add 3277 3284; mul 673 3265; mul 660 3286;
mul 675 3265; add 3287 3288; mul 671 3289; sub 3285 3290; mul 637 3291; mul 566 3265; mul 660 3293; mul 696 3265;
add 3294 3295; mul 694 3296; mul 693 3267; mul 650 3298; mul 694 3267; add 3299 3300; mul 650 3301; mul 1609 3267;
add 3302 3303; mul 698 3304; sub 3297 3305; mul 637 3306; mul 691 3307; add 3292 3308; mul 703 3307; mul 700 3310;
mul 704 3307; add 3311 3312; mul 718 3313; mul 708 3159; mul 652 3315; mul 637 3269; mul 710 3317; sub 3316 3318;
mul 17 3319; mul 131 3320; mul 643 3317; mul 0 3322; add 3321 3323; mul 652 3159; mul 636 3317; sub 3325 3326; mul
623 3327; mul 653 3253; add 3328 3329; add 3324 3330; mul 705 3331; add 3314 3332; add 3309 3333; mul 653 3334; mul
720 3327; add 3335 3336; add 3262 3337; mul 418 3338; sub 3103 3339; sub 3067 3340; mul 145 3341; mul 586 3259; mul
627 3213; sub 3343 3344; mul 714 3334; mul 720 3322; sub 3346 3347; add 3345 3348; sub 3342 3349; add 1781 3350; mul
91 3351; sub 2944 3352; mul 90 2927; mul 1669 2941; sub 3354 3355; mul 925 3356; mul 151 3017; mul 146 3358; mul 850
3031; mul 849 3031; mul 848 3031; mul 276 3362; add 3361 3363; mul 276 3364; add 3360 3365; mul 854 3031; mul 853
3031; mul 276 3368; add 3367 3369; mul 852 3370; add 3366 3371; mul 859 3031; mul 858 3373; add 3372 3374; mul 284
3373; mul 852 3376; add 3375 3377; mul 302 3042; add 3378 3379; mul 878 3045; add 3380 3381; mul 302 3046; add 3382
3383; mul 320 3055; add 3384 3385; mul 146 3386; where 847 3387; add 3359 3388; mul 723 3229; mul 593 3338; sub 3390
3391; sub 3389 3392; mul 584 3259; mul 627 3219; sub 3394 3395; mul 712 3334; mul 720 3320; add 3397 3398; add 3396
3399; add 3393 3400; mul 22 2755; add 3401 3402; mul 843 3403; sub 3357 3404; sub 3353 3405; mul 90 2938; mul 1720
2941; sub 3407 3408; mul 1034 3409; mul 931 2985; add 929 3411; mul 934 2989; add 3412 3413; input p 200; add 3414
3415; mul 939 2946; add 3416 3417; mul 942 2950; add 3418 3419; mul 945 2953; add 3420 3421; mul 228 2957; add 3422
3423; mul 950 2962; add 3424 3425; mul 158 2970; add 3426 3427; mul 955 2974; add 3428 3429; mul 170 2979; add 3430
3431; mul 185 202; add 3432 3433; mul 258 2982; add 3434 3435; mul 154 3017; add 3436 3437; mul 146 3438; mul 979
3031; mul 276 3440; mul 972 3031; add 3441 3442; mul 974 3443; mul 976 3440; mul 974 3031; mul 972 3446; add 3445
3447; add 3444 3448; mul 303 3031; mul 980 3450; mul 976 3031; mul 276 3446; add 3452 3453; mul 979 3454; add 3451
3455; add 3449 3456; mul 284 3031; mul 276 3458; mul 983 3031; add 3459 3460; mul 848 3461; add 3457 3462; mul 849
3458; mul 983 3362; add 3464 3465; add 3463 3466; mul 284 3364; add 3467 3468; mul 858 3031; mul 853 3470; add 3469
3471; mul 858 3368; add 3472 3473; mul 302 3031; mul 276 3475; mul 998 3031; add 3476 3477; mul 277 3478; add 3474
3479; mul 278 3475; mul 998 3034; add 3481 3482; add 3480 3483; mul 302 3036; add 3484 3485; mul 878 3031; mul 285
3487; add 3486 3488; mul 878 3040; add 3489 3490; mul 320 3031; mul 305 3492; add 3491 3493; mul 320 3050; add 3494
3495; mul 146 3496; where 971 3497; add 3439 3498; mul 723 3251; mul 620 3338; sub 3500 3501; sub 3499 3502; mul 52
831; mul 22 3504; add 3503 3505; mul 928 3506; add 3410 3507; sub 3406 3508; mul 57 2910; mul 71 2898; add 3510
3511; mul 80 2924; add 3513 3513; sub 3512 3514; mul 90 3515; mul 1858 2941; sub 3516 3517; mul 925 3518; mul 1040
3403; sub 3519 3520; mul 841 3356; mul 843 3351; sub 3522 3523; sub 3521 3524; mul 60 2910; mul 71 2904; add 3526
3527; mul 77 2924; mul 80 2915; add 3529 3530; sub 3528 3531; mul 90 3532; mul 1876 2941; sub 3533 3534; mul 1034
3535; mul 1047 3506; add 3536 3537; add 3525 3538; mul 841 3409; mul 928 3351; sub 3540 3541; mul 925 3535; mul 1047
3403; sub 3543 3544; sub 3542 3545; mul 46 2910; mul 71 2895; add 3547 3548; mul 77 2915; add 3550 3550; sub 3549
3551; mul 90 3552; mul 1939 2941; sub 3553 3554; mul 1034 3555; mul 1056 3506; add 3556 3557; sub 3546 3558; mul 625
3204; mul 572 3256; add 3560 3561; mul 718 3307; mul 700 3331; add 3563 3564; mul 519 620; mul 577 3566; mul 519
3567; mul 620 653; mul 705 3569; mul 653 3570; add 3568 3571; mul 593 3572; input p 201; add 3573 3574; mul 584
3567; mul 712 3570; add 3576 3577; add 3575 3578; add 810 811; add 809 3580; mul 42 3581; mul 22 3582; add 3579
3583; mul 843 3584; mul 418 3572; input p 202; add 3586 3587; mul 145 3588; mul 586 3567; mul 714 3570; add 3590
3591; sub 3589 3592; mul 68 3581; mul 22 3594; add 3593 3595; mul 91 3596; sub 3585 3597; mul 620 3572; input p 203;
add 3599 3600; mul 54 3581; mul 22 3602; add 3601 3603; mul 928 3604; sub 3598 3605; mul 843 3596; mul 1040 3584;
sub 3607 3608; mul 1047 3604; add 3609 3610; mul 1047 3584; mul 928 3596; sub 3612 3613; mul 1056 3604; sub 3614
3615; mul 572 3566; mul 700 3569; mul 550 572; mul 519 3619; mul 593 3620; mul 584 3619; add 3621 3622; mul 843
3623; mul 418 3620; mul 145 3625; mul 586 3619; sub 3626 3627; mul 91 3628; sub 3624 3629; mul 620 3620; mul 928
3631; sub 3630 3632; mul 843 3628; mul 1040 3623; sub 3634 3635; mul 1047 3631; add 3636 3637; mul 1047 3623; mul
928 3628; sub 3639 3640; mul 1056 3631; sub 3641 3642; input p 204; mul 681 700; mul 653 3645; mul 593 3646; mul 712
3645; add 3647 3648; mul 843 3649; mul 418 3646; mul 145 3651; mul 714 3645; sub 3652 3653; mul 91 3654; sub 3650
3655; mul 620 3646; mul 928 3657; sub 3656 3658; mul 843 3654; mul 1040 3649; sub 3660 3661; mul 1047 3657; add 3662
3663; mul 1047 3649; mul 928 3654; sub 3665 3666; mul 1056 3657; sub 3667 3668; mul 553 572; mul 519 3670; mul 593
3671; mul 584 3670; add 3672 3673; mul 843 3674; mul 418 3671; mul 145 3676; mul 586 3670; sub 3677 3678; mul 91
3679; sub 3675 3680; mul 620 3671; mul 928 3682; sub 3681 3683; mul 843 3679; mul 1040 3674; sub 3685 3686; mul 1047
3682; add 3687 3688; mul 1047 3674; mul 928 3679; sub 3690 3691; mul 1056 3682; sub 3692 3693; input p 205; mul 684
700; mul 653 3696; mul 593 3697; mul 712 3696; add 3698 3699; mul 843 3700; mul 418 3697; mul 145 3702; mul 714
3696; sub 3703 3704; mul 91 3705; sub 3701 3706; mul 620 3697; mul 928 3708; sub 3707 3709; mul 843 3705; mul 1040
3700; sub 3711 3712; mul 1047 3708; add 3713 3714; mul 1047 3700; mul 928 3705; sub 3716 3717; mul 1056 3708; sub
3718 3719; mul 557 572; mul 519 3721; mul 593 3722; mul 584 3721; add 3723 3724; mul 843 3725; mul 418 3722; mul 145
3727; mul 586 3721; sub 3728 3729; mul 91 3730; sub 3726 3731; mul 620 3722; mul 928 3733; sub 3732 3734; mul 843
3730; mul 1040 3725; sub 3736 3737; mul 1047 3733; add 3738 3739; mul 1047 3725; mul 928 3730; sub 3741 3742; mul
1056 3733; sub 3743 3744; input p 206; mul 688 700; mul 653 3747; mul 593 3748; mul 712 3747; add 3749 3750; mul 843
3751; mul 418 3748; mul 145 3753; mul 714 3747; sub 3754 3755; mul 91 3756; sub 3752 3757; mul 620 3748; mul 928
3759; sub 3758 3760; mul 843 3756; mul 1040 3751; sub 3762 3763; mul 1047 3759; add 3764 3765; mul 1047 3751; mul
928 3756; sub 3767 3768; mul 1056 3759; sub 3769 3770; mul 91 784; mul 784 843; neg 3773; mul 784 928; input p 207;
mul 91 788; mul 788 843; neg 3778; mul 788 928; input p 208; input p 209; mul 843 3782; mul 91 753; sub 3783 3784;
mul 753 843; mul 1040 3782; sub 3786 3787; mul 1047 3782; mul 753 928; sub 3789 3790; input p 210; mul 843 3792; mul
91 756; sub 3793 3794; mul 756 843; mul 1040 3792; sub 3796 3797; mul 1047 3792; mul 756 928; sub 3799 3800; input p
211; mul 843 3802; mul 91 760; sub 3803 3804; mul 760 843; mul 1040 3802; sub 3806 3807; mul 1047 3802; mul 760 928;
sub 3809 3810; input p 212; mul 843 3812; mul 91 764; sub 3813 3814; mul 764 843; mul 1040 3812; sub 3816 3817; mul
1047 3812; mul 764 928; sub 3819 3820; mul 103 110; add 93 3822; mul 101 122; sub 3823 3824; mul 539 546; mul 503
3826; mul 586 3827; mul 519 3827; mul 418 3829; mul 145 3830; sub 3828 3831; sub 3825 3832; mul 91 3833; mul 593
3829; mul 584 3827; add 3835 3836; add 122 3837; mul 843 3838; sub 3834 3839; mul 620 3829; mul 928 3841; add 3840
3842; mul 1040 3838; mul 843 3833; sub 3844 3845; mul 1047 3841; sub 3846 3847; mul 928 3833; mul 1047 3838; sub
3849 3850; mul 1056 3841; add 3851 3852; mul 103 113; add 97 3854; mul 101 125; sub 3855 3856; mul 670 677; mul 637
3858; mul 714 3859; mul 653 3859; mul 418 3861; mul 145 3862; sub 3860 3863; sub 3857 3864; mul 91 3865; mul 593
3861; mul 712 3859; add 3867 3868; add 125 3869; mul 843 3870; sub 3866 3871; mul 620 3861; mul 928 3873; add 3872
3874; mul 1040 3870; mul 843 3865; sub 3876 3877; mul 1047 3873; sub 3878 3879; mul 928 3865; mul 1047 3870; sub
3881 3882; mul 1056 3873; add 3883 3884; neg 843; neg 1794; neg 1948; neg 1888; neg 1891; neg 1807; neg 1958; neg
1898; neg 1815; neg 1964; neg 1819; neg 1967; neg 1908; neg 1911; neg 1838; neg 1978; neg 1918; neg 1921; store f 0
0; store f 1 1036; store f 2 131; store f 3 1049; store f 4 621; store f 5 1058; store f 6 1062; store f 7 1065;
store f 8 1068; store f 9 1070; store f 10 1073; store f 11 1075; store f 12 1077; store f 13 1079; store f 14 1093;
store f 15 1102; store f 16 1111; store f 17 1120; store a 18 1850; store a 54 1924; store a 90 1987; store a 108
1990; store a 126 1993; store a 144 1990; store a 162 1993; store a 180 1990; store a 198 1993; store a 216 1076;
store a 234 1078; store a 1 2; store a 19 2054; store a 55 2059; store a 91 2065; store a 109 2066; store a 127
2067; store a 145 2066; store a 163 2067; store a 181 2066; store a 199 2067; store a 253 2068; store a 271 2069;
store a 289 2070; store a 307 2071; store a 20 2762; store a 56 2792; store a 92 2812; store a 110 2815; store a 128
2818; store a 146 2815; store a 164 2818; store a 182 2815; store a 200 2818; store a 21 2873; store a 39 2; store a
57 2878; store a 93 2883; store a 111 2884; store a 129 2885; store a 147 2884; store a 165 2885; store a 183 2884;
store a 201 2885; store a 255 2887; store a 273 2889; store a 291 2891; store a 309 2893; store a 22 3509; store a
58 3539; store a 94 3559; store a 112 3562; store a 130 3565; store a 148 3562; store a 166 3565; store a 184 3562;
store a 202 3565; store a 23 3606; store a 59 3611; store a 77 2; store a 95 3616; store a 113 3617; store a 131
3618; store a 149 3617; store a 167 3618; store a 185 3617; store a 203 3618; store a 24 3633; store a 60 3638;
store a 96 3643; store a 114 3644; store a 25 3659; store a 61 3664; store a 97 3669; store a 133 3644; store a 26
3684; store a 62 3689; store a 98 3694; store a 152 3695; store a 27 3710; store a 63 3715; store a 99 3720; store a
171 3695; store a 28 3735; store a 64 3740; store a 100 3745; store a 190 3746; store a 29 3761; store a 65 3766;
store a 101 3771; store a 209 3746; store a 30 3772; store a 66 3774; store a 102 3775; store a 228 3776; store a 31
3777; store a 67 3779; store a 103 3780; store a 247 3781; store a 32 3785; store a 68 3788; store a 104 3791; store
a 33 3795; store a 69 3798; store a 105 3801; store a 34 3805; store a 70 3808; store a 106 3811; store a 35 3815;
store a 71 3818; store a 107 3821; store b 2 3843; store b 6 3848; store b 10 3853; store b 3 3875; store b 7 3880;
store b 11 3885; store by_c 13 91; store by_c 39 3886; store by_c 65 928; store by_c 14 3887; store by_c 40 1884;
store by_c 66 3888; store by_c 15 1798; store by_c 41 3889; store by_c 67 1951; store by_c 16 1802; store by_c 42
3890; store by_c 68 1954; store by_c 17 3891; store by_c 43 1895; store by_c 69 3892; store by_c 18 1811; store by_c
44 3893; store by_c 70 1961; store by_c 19 3894; store by_c 45 1901; store by_c 71 3895; store by_c 20 3896; store
by_c 46 1904; store by_c 72 3897; store by_c 21 1829; store by_c 47 3898; store by_c 73 1971; store by_c 22 1833;
store by_c 48 3899; store by_c 74 1974; store by_c 23 3900; store by_c 49 1915; store by_c 75 3901; store by_c 24
1842; store by_c 50 3902; store by_c 76 1981; store by_c 25 1846; store by_c 51 3903; store by_c 77 1984
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'p': 227},
    {'by_k': 1728},
    """
input p 0; constant 1.0; input x 2; input p 1; mul 2 3; mul 2 4; add 1 5; sqrt 6; div 1 7; input p 2; mul 2 9; mul 2
10; add 1 11; sqrt 12; mul 7 13; div 1 14; mul 8 15; input p 3; mul 16 17; mul 16 18; add 0 19; input p 4; input p
5; mul 12 15; mul 22 23; mul 16 24; mul 25 25; input p 6; input x 0; mul 27 28; input p 7; mul 2 30; add 29 31;
input p 8; input x 4; mul 33 34; add 32 35; mul 2 13; mul 15 37; mul 22 38; mul 16 39; add 36 40; mul 41 41; add 26
42; mul 21 43; add 20 44; input p 9; input p 10; mul 28 47; mul 2 33; add 48 49; input p 11; mul 34 51; add 50 52;
mul 53 53; mul 21 54; add 46 55; mul 45 56; mul 41 53; mul 21 58; mul 59 59; sub 57 60; input p 12; mul 28 62; mul 2
27; add 63 64; mul 34 47; add 65 66; mul 67 67; add 1 68; mul 21 69; mul 61 70; input p 13; mul 41 67; add 25 73;
mul 21 74; add 72 75; mul 56 76; mul 53 67; mul 21 78; mul 59 79; sub 77 80; mul 76 81; sub 71 82; mul 59 76; mul 45
79; sub 84 85; mul 79 86; add 83 87; div 1 88; mul 61 89; input p 17; input p 18; input p 19; input p 20; mul 28 91;
mul 94 95; input p 21; mul 2 97; add 96 98; input p 22; mul 34 100; add 99 101; mul 93 102; input p 23; mul 34 102;
mul 104 105; add 103 106; input p 24; mul 34 105; mul 108 109; add 107 110; input p 25; mul 102 102; mul 112 113;
add 111 114; input p 26; mul 34 113; mul 116 117; add 115 118; input p 27; mul 102 113; mul 120 121; add 119 122;
input p 28; mul 95 124; add 123 125; input p 29; mul 34 95; mul 127 128; add 126 129; input p 30; mul 34 128; mul
131 132; add 130 133; input p 31; mul 95 102; mul 135 136; add 134 137; input p 32; mul 34 136; mul 139 140; add 138
141; input p 33; mul 102 136; mul 143 144; add 142 145; input p 34; mul 95 95; mul 102 148; mul 147 149; add 146
150; input p 35; mul 95 148; mul 152 153; add 151 154; input p 36; input p 37; mul 34 157; add 156 158; input p 38;
mul 34 34; mul 160 161; add 159 162; input p 39; mul 34 161; mul 164 165; add 163 166; input p 40; mul 102 168; add
167 169; input p 41; mul 105 171; add 170 172; input p 42; mul 109 174; add 173 175; input p 43; mul 113 177; add
176 178; input p 44; mul 117 180; add 179 181; input p 45; mul 121 183; add 182 184; mul 93 95; add 185 186; mul 104
128; add 187 188; mul 108 132; add 189 190; input p 46; mul 136 192; add 191 193; input p 47; mul 140 195; add 194
196; input p 48; mul 144 198; add 197 199; input p 49; mul 148 201; add 200 202; input p 50; mul 34 148; mul 204
205; add 203 206; mul 143 149; add 207 208; input p 51; mul 153 210; add 209 211; mul 94 212; add 155 213; mul 92
214; abs 95; constant 0.35; lt 216 217; constant 1.6; constant -1.6; max 220 34; min 219 221; input p 52; mul 222
223; mul 222 224; mul 222 225; constant 0.6; constant -0.6; max 228 2; min 227 229; input p 53; mul 222 231; mul 222
232; mul 230 233; add 226 234; input p 54; mul 222 236; mul 230 237; mul 230 238; add 235 239; input p 55; mul 230
241; mul 230 242; mul 230 243; add 240 244; constant -0.35; max 246 95; min 217 247; constant 2.0; mul 248 249;
input p 56; mul 222 251; mul 222 252; mul 250 253; add 245 254; input p 57; mul 222 256; mul 230 257; mul 250 258;
add 255 259; input p 58; mul 230 261; mul 230 262; mul 250 263; add 260 264; mul 248 248; input p 59; mul 222 267;
mul 266 268; add 265 269; mul 248 268; mul 250 271; add 270 272; input p 60; mul 230 274; mul 266 275; add 273 276;
mul 248 275; mul 250 278; add 277 279; mul 248 266; input p 61; mul 281 282; add 280 283; mul 248 282; mul 266 285;
add 284 286; mul 248 285; mul 250 288; add 287 289; mul 92 290; where 218 291; add 215 292; input p 62; input p 63;
mul 95 295; input p 64; mul 2 297; add 296 298; input p 65; mul 34 300; add 299 301; constant -0.09999999999999995;
mul 102 303; input p 66; mul 109 305; add 304 306; input p 67; mul 121 308; add 307 309; constant 1.2; mul 95 311;
add 310 312; input p 68; mul 132 314; add 313 315; input p 69; mul 140 317; add 316 318; input p 70; mul 144 320;
add 319 321; input p 71; mul 149 323; add 322 324; input p 72; mul 153 326; add 325 327; constant
-0.033333333333333326; mul 34 329; input p 73; mul 165 331; add 330 332; constant 0.13333333333333333; mul 102 334;
add 333 335; input p 74; mul 109 337; add 336 338; input p 75; mul 117 340; add 339 341; input p 76; mul 121 343;
add 342 344; mul 95 303; add 345 346; mul 132 305; add 347 348; input p 77; mul 144 350; add 349 351; input p 78;
mul 205 353; add 352 354; mul 149 320; add 355 356; input p 79; mul 153 358; add 357 359; mul 94 360; add 328 361;
add 302 362; mul 294 363; input p 80; input p 81; constant 0.009523809523809514; mul 161 367; input p 82; mul 34
165; mul 369 370; add 368 371; mul 105 329; add 372 373; mul 34 109; mul 331 375; add 374 376; constant
0.06666666666666667; mul 113 378; add 377 379; input p 83; mul 34 117; mul 381 382; add 380 383; input p 84; mul 34
121; mul 385 386; add 384 387; input p 85; mul 102 121; mul 389 390; add 388 391; mul 136 303; add 392 393; mul 34
140; mul 305 395; add 394 396; mul 102 144; mul 308 398; add 397 399; mul 148 227; add 400 401; input p 86; mul 34
205; mul 403 404; add 402 405; mul 34 149; mul 353 407; add 406 408; input p 87; mul 102 149; mul 410 411; add 409
412; mul 102 153; mul 358 414; add 413 415; input p 88; mul 95 153; mul 417 418; add 416 419; constant 0.5; mul 95
302; mul 95 297; input p 89; mul 2 424; add 423 425; input p 90; mul 34 427; add 426 428; mul 2 429; add 422 430;
mul 95 300; mul 2 427; add 432 433; input p 91; mul 34 435; add 434 436; mul 34 437; add 431 438; mul 421 439; add
420 440; mul 294 441; add 366 442; input p 92; mul 23 444; add 443 445; input p 93; mul 38 447; sub 446 448; input p
94; mul 23 447; input p 95; sub 451 452; mul 38 444; add 453 454; sub 455 28; mul 456 456; mul 449 449; add 457 458;
sqrt 459; mul 450 460; sqrt 461; div 1 462; mul 463 463; mul 450 464; mul 449 465; input p 96; mul 249 461; mul 249
464; mul 464 469; sub 468 470; mul 467 471; constant 0.3; constant -0.3; constant 1.4; sub 461 475; max 474 476; min
473 477; input p 97; input p 98; mul 478 480; add 479 481; mul 478 482; add 1 483; mul 472 484; input u 0; input p
99; mul 486 487; input p 100; input p 101; mul 476 490; add 489 491; mul 476 492; add 1 493; mul 488 494; sub 485
495; mul 450 496; input p 102; input x 6; mul 498 499; input p 103; input x 8; mul 501 502; add 500 503; input p
104; input x 10; mul 505 506; add 504 507; constant -0.5; mul 463 509; mul 463 510; mul 463 511; input p 105; input
p 106; mul 476 514; add 513 515; mul 476 516; add 1 517; mul 512 518; mul 450 519; mul 508 520; add 497 521; input p
107; mul 520 523; mul 520 524; input x 3; sub 445 448; mul 456 527; add 451 454; mul 449 529; sub 528 530; mul 465
531; mul 16 532; mul 526 533; input x 1; mul 456 465; mul 535 536; sub 534 537; mul 91 535; mul 364 539; mul 97 360;
add 429 541; mul 294 542; mul 526 543; add 540 544; constant 0.01904761904761903; mul 34 546; input p 108; mul 165
548; add 547 549; mul 102 329; add 550 551; input p 109; mul 109 553; add 552 554; mul 117 337; add 555 556; mul 121
385; add 557 558; input p 110; mul 140 560; add 559 561; mul 205 314; add 562 563; mul 149 353; add 564 565; mul 100
360; add 566 567; add 437 568; mul 294 569; input x 5; mul 570 571; add 545 572; mul 466 573; add 538 574; mul 525
575; add 522 576; mul 466 577; input p 111; add 442 579; input p 112; mul 23 581; add 580 582; input p 113; mul 38
584; add 583 585; input p 114; mul 38 581; mul 23 584; input p 115; sub 589 590; sub 588 591; sub 592 28; mul 593
593; mul 586 586; add 594 595; sqrt 596; mul 587 597; sqrt 598; div 1 599; mul 600 600; mul 587 601; mul 586 602;
input p 116; mul 249 598; mul 249 601; mul 601 606; sub 605 607; mul 604 608; sub 598 475; max 474 610; min 473 611;
input p 117; input p 118; mul 612 614; add 613 615; mul 612 616; add 1 617; mul 609 618; input u 1; input p 119; mul
620 621; input p 120; input p 121; mul 610 624; add 623 625; mul 610 626; add 1 627; mul 622 628; sub 619 629; mul
587 630; input p 122; input x 7; mul 632 633; input p 123; input x 9; mul 635 636; add 634 637; input p 124; input x
11; mul 639 640; add 638 641; mul 509 600; mul 600 643; mul 600 644; mul 514 610; add 513 646; mul 610 647; add 1
648; mul 645 649; mul 587 650; mul 642 651; add 631 652; input p 125; mul 651 654; mul 651 655; add 582 585; mul 593
657; sub 589 588; mul 586 659; add 658 660; mul 602 661; mul 16 662; mul 526 663; mul 593 602; mul 535 665; sub 664
666; mul 573 603; add 667 668; mul 656 669; add 653 670; mul 603 671; add 578 672; sub 365 673; mul 364 674; sub 293
675; input p 126; constant 12.0; mul 539 678; constant -6.0; mul 94 539; mul 97 526; add 681 682; mul 100 571; add
683 684; mul 680 685; add 679 686; mul 677 687; mul 539 680; constant 4.0; mul 685 690; add 689 691; mul 677 692;
mul 94 693; add 688 694; add 676 695; mul 91 696; mul 91 697; mul 90 698; mul 81 89; mul 663 700; mul 90 665; add
701 702; mul 86 89; mul 570 704; mul 543 700; sub 705 706; mul 90 91; mul 364 708; add 707 709; mul 603 710; sub 703
711; mul 656 712; mul 573 713; mul 671 710; sub 714 715; mul 602 716; mul 671 700; mul 526 713; add 718 719; mul 16
720; mul 602 721; mul 659 722; add 717 723; mul 249 586; mul 249 597; div 1 726; mul 669 712; mul 655 728; mul 651
728; mul 654 730; add 729 731; mul 642 712; add 732 733; mul 587 734; mul 645 735; mul 647 736; mul 610 736; mul 514
738; add 737 739; mul 587 712; mul 622 741; mul 626 742; sub 740 743; mul 610 742; mul 624 745; sub 744 746; le 474
610; le 610 474; add 748 749; div 1 750; mul 748 751; le 611 473; le 473 611; add 753 754; div 1 755; mul 753 756;
mul 609 741; mul 616 758; mul 612 758; mul 614 760; add 759 761; mul 757 762; mul 752 763; add 747 764; mul 249 599;
div 1 766; mul 600 645; mul 649 735; mul 768 769; mul 600 769; mul 645 771; add 770 772; mul 600 771; mul 644 774;
add 773 775; mul 249 600; mul 586 716; mul 90 671; mul 535 713; sub 779 780; mul 593 781; add 778 782; mul 661 721;
add 783 784; mul 587 785; mul 618 741; mul 604 787; mul 606 788; sub 786 789; mul 601 788; neg 791; mul 249 792; add
790 793; mul 777 794; mul 601 795; add 776 796; mul 767 797; sub 765 798; mul 249 788; add 799 800; mul 587 801; mul
727 802; mul 725 803; add 724 804; sub 699 805; mul 674 704; mul 603 713; mul 533 700; mul 90 536; add 809 810; mul
466 710; sub 811 812; mul 525 813; mul 466 814; add 808 815; mul 571 816; add 807 817; mul 569 818; add 806 819; mul
526 816; mul 674 700; sub 821 822; mul 542 823; add 820 824; mul 91 539; mul 97 700; mul 100 704; sub 827 828; mul
94 708; sub 829 830; mul 677 831; mul 680 832; mul 690 832; mul 677 708; mul 680 835; sub 834 836; mul 94 837; add
833 838; mul 678 835; sub 839 840; mul 364 816; add 841 842; mul 826 843; sub 825 844; mul 674 708; mul 539 816; add
846 847; mul 363 848; add 845 849; mul 573 814; mul 577 710; sub 851 852; mul 465 853; mul 577 700; mul 526 814; add
855 856; mul 16 857; mul 465 858; mul 529 859; sub 854 860; mul 249 449; mul 249 460; div 1 863; mul 575 813; mul
524 865; mul 520 865; mul 523 867; add 866 868; mul 508 813; add 869 870; mul 450 871; mul 512 872; mul 516 873; mul
476 873; mul 514 875; add 874 876; mul 450 813; mul 488 878; mul 492 879; sub 877 880; mul 476 879; mul 490 882; sub
881 883; le 474 476; le 476 474; add 885 886; div 1 887; mul 885 888; le 477 473; le 473 477; add 890 891; div 1
892; mul 890 893; mul 472 878; mul 482 895; mul 478 895; mul 480 897; add 896 898; mul 894 899; mul 889 900; add 884
901; mul 249 462; div 1 903; mul 463 512; mul 518 872; mul 905 906; mul 463 906; mul 512 908; add 907 909; mul 463
908; mul 511 911; add 910 912; mul 249 463; mul 449 853; mul 90 577; mul 535 814; sub 916 917; mul 456 918; add 915
919; mul 531 858; add 920 921; mul 450 922; mul 484 878; mul 467 924; mul 469 925; sub 923 926; mul 464 925; neg
928; mul 249 929; add 927 930; mul 914 931; mul 464 932; add 913 933; mul 904 934; sub 902 935; mul 249 925; add 936
937; mul 450 938; mul 864 939; mul 862 940; add 861 941; add 805 942; mul 441 943; add 850 944; sub 945 942; mul 91
95; mul 95 249; mul 294 818; mul 353 949; mul 102 950; mul 948 951; mul 92 704; mul 204 953; mul 102 954; mul 948
955; mul 131 953; mul 34 957; mul 948 958; add 956 959; input p 152; mul 953 961; mul 948 962; add 960 963; mul 116
953; mul 102 965; mul 102 966; add 964 967; input p 151; mul 953 969; mul 34 970; mul 102 971; add 968 972; mul 104
953; mul 102 974; add 973 975; sub 952 976; mul 314 949; mul 34 978; mul 948 979; add 977 980; mul 560 949; mul 34
982; mul 102 983; add 981 984; mul 100 949; mul 294 823; mul 97 987; add 986 988; mul 294 848; mul 94 990; add 989
991; mul 358 992; mul 148 993; add 985 994; mul 95 993; mul 948 996; add 995 997; mul 320 992; mul 102 999; mul 948
1000; add 998 1001; mul 353 992; mul 34 1003; mul 948 1004; add 1002 1005; mul 350 992; mul 102 1007; mul 102 1008;
add 1006 1009; mul 305 992; mul 34 1011; mul 34 1012; add 1010 1013; mul 303 992; add 1014 1015; mul 326 990; mul
148 1017; add 1016 1018; mul 95 1017; mul 948 1020; add 1019 1021; mul 323 990; mul 102 1023; mul 948 1024; add 1022
1025; mul 320 990; mul 102 1027; mul 102 1028; add 1026 1029; mul 317 990; mul 34 1031; mul 102 1032; add 1030 1033;
mul 314 990; mul 34 1035; mul 34 1036; add 1034 1037; mul 311 990; add 1038 1039; mul 294 943; mul 421 1041; mul 34
1042; add 949 1043; mul 300 1044; add 1040 1045; mul 2 1042; add 987 1047; mul 297 1048; add 1046 1049; mul 302
1042; add 1050 1051; mul 95 1042; add 990 1053; mul 295 1054; add 1052 1055; mul 417 1041; mul 153 1057; add 1056
1058; mul 95 1057; mul 148 1060; add 1059 1061; mul 95 1060; mul 948 1063; add 1062 1064; mul 358 1041; mul 102
1066; mul 148 1067; add 1065 1068; mul 95 1067; mul 948 1070; add 1069 1071; mul 410 1041; mul 102 1073; mul 102
1074; mul 948 1075; add 1072 1076; mul 353 1041; mul 34 1078; mul 102 1079; mul 948 1080; add 1077 1081; mul 403
1041; mul 34 1083; mul 34 1084; mul 948 1085; add 1082 1086; mul 227 1041; mul 948 1088; add 1087 1089; mul 308
1041; mul 102 1091; mul 102 1092; mul 102 1093; add 1090 1094; mul 305 1041; mul 34 1096; mul 34 1097; mul 102 1098;
add 1095 1099; mul 303 1041; mul 102 1101; add 1100 1102; le 246 95; le 95 246; add 1104 1105; div 1 1106; mul 1104
1107; le 247 217; le 217 247; add 1109 1110; div 1 1111; mul 1109 1112; abs 34; lt 1114 219; mul 267 953; mul 266
1116; mul 252 953; mul 251 953; mul 222 1119; add 1118 1120; mul 250 1121; add 1117 1122; mul 232 953; mul 231 953;
mul 222 1125; add 1124 1126; mul 230 1127; add 1123 1128; mul 225 953; add 1129 1130; mul 224 953; mul 223 953; mul
222 1133; add 1132 1134; mul 222 1135; add 1131 1136; neg 1137; where 1115 1138; abs 2; lt 1140 227; mul 92 700; mul
274 1142; mul 266 1143; where 1141 1144; add 1139 1145; mul 262 1142; mul 261 1142; mul 230 1148; add 1147 1149; mul
250 1150; where 1141 1151; add 1146 1152; mul 256 953; mul 230 1154; neg 1155; where 1115 1156; mul 257 1142; where
1141 1158; add 1157 1159; mul 250 1160; add 1153 1161; mul 243 1142; where 1141 1163; add 1162 1164; mul 242 1142;
mul 241 1142; mul 230 1167; add 1166 1168; mul 230 1169; where 1141 1170; add 1165 1171; mul 238 1142; where 1141
1173; add 1172 1174; mul 236 953; mul 230 1176; neg 1177; where 1115 1178; mul 237 1142; where 1141 1180; add 1179
1181; mul 230 1182; add 1175 1183; mul 233 1142; where 1141 1185; add 1184 1186; mul 92 708; mul 250 1188; mul 285
1189; neg 1190; where 218 1191; add 1187 1192; mul 288 1188; neg 1194; mul 249 1195; where 218 1196; add 1193 1197;
mul 248 1189; mul 266 1188; add 1199 1200; mul 282 1201; neg 1202; where 218 1203; add 1198 1204; mul 282 1188; mul
266 1206; neg 1207; where 218 1208; add 1205 1209; mul 285 1188; mul 248 1206; add 1211 1212; mul 250 1213; neg
1214; where 218 1215; add 1210 1216; mul 275 1189; neg 1218; where 218 1219; add 1217 1220; mul 278 1188; neg 1222;
mul 249 1223; where 218 1224; add 1221 1225; mul 248 1143; where 1141 1227; mul 275 1188; neg 1229; where 218 1230;
add 1228 1231; mul 250 1232; add 1226 1233; mul 268 1189; neg 1235; where 218 1236; add 1234 1237; mul 271 1188; neg
1239; mul 249 1240; where 218 1241; add 1238 1242; mul 248 1116; neg 1244; where 1115 1245; mul 268 1188; neg 1247;
where 218 1248; add 1246 1249; mul 250 1250; add 1243 1251; mul 263 1188; neg 1253; mul 249 1254; where 218 1255;
add 1252 1256; mul 258 1188; neg 1258; mul 249 1259; where 218 1260; add 1257 1261; mul 253 1188; neg 1263; mul 249
1264; where 218 1265; add 1262 1266; mul 1113 1267; mul 1108 1268; add 1103 1269; mul 97 1142; mul 100 953; sub 1271
1272; mul 94 1188; sub 1273 1274; mul 210 1275; mul 148 1276; add 1270 1277; mul 95 1276; mul 948 1279; add 1278
1280; mul 143 1275; mul 102 1282; mul 948 1283; add 1281 1284; mul 204 1275; mul 34 1286; mul 948 1287; add 1285
1288; mul 201 1275; mul 948 1290; add 1289 1291; mul 198 1275; mul 102 1293; mul 102 1294; add 1292 1295; mul 195
1275; mul 34 1297; mul 102 1298; add 1296 1299; mul 192 1275; mul 102 1301; add 1300 1302; mul 108 1275; mul 34
1304; mul 34 1305; add 1303 1306; mul 104 1275; mul 34 1308; add 1307 1309; mul 93 1275; add 1310 1311; mul 152
1188; mul 148 1313; sub 1312 1314; mul 95 1313; mul 948 1316; sub 1315 1317; mul 147 1188; mul 102 1319; mul 948
1320; sub 1318 1321; mul 143 1188; mul 102 1323; mul 102 1324; sub 1322 1325; mul 139 1188; mul 34 1327; mul 102
1328; sub 1326 1329; mul 135 1188; mul 102 1331; sub 1330 1332; mul 131 1188; mul 34 1334; mul 34 1335; sub 1333
1336; mul 127 1188; mul 34 1338; sub 1337 1339; mul 124 1188; sub 1340 1341; mul 148 950; mul 148 954; mul 136 965;
add 1344 1345; mul 95 966; add 1346 1347; mul 95 971; add 1348 1349; mul 95 974; add 1350 1351; input p 150; mul 953
1353; mul 113 1354; add 1352 1355; mul 102 249; mul 102 1354; mul 1357 1358; add 1356 1359; mul 174 953; mul 34
1361; mul 1357 1362; add 1360 1363; input p 149; mul 953 1365; mul 1357 1366; add 1364 1367; input p 148; mul 953
1369; mul 34 1370; mul 34 1371; add 1368 1372; input p 147; mul 953 1374; mul 34 1375; add 1373 1376; mul 157 953;
add 1377 1378; sub 1343 1379; mul 95 983; add 1380 1381; mul 385 949; mul 113 1383; add 1382 1384; mul 102 1383; mul
1357 1386; add 1385 1387; mul 337 949; mul 34 1389; mul 1357 1390; add 1388 1391; mul 553 949; mul 34 1393; mul 34
1394; add 1392 1395; mul 329 949; add 1396 1397; mul 148 999; add 1398 1399; mul 136 1007; add 1400 1401; mul 95
1008; add 1402 1403; mul 343 992; mul 113 1405; add 1404 1406; mul 102 1405; mul 1357 1408; add 1407 1409; mul 340
992; mul 34 1411; mul 1357 1412; add 1410 1413; mul 337 992; mul 34 1415; mul 34 1416; add 1414 1417; mul 334 992;
add 1418 1419; mul 148 1023; add 1420 1421; mul 136 1027; add 1422 1423; mul 95 1028; add 1424 1425; mul 95 1032;
add 1426 1427; mul 308 990; mul 113 1429; add 1428 1430; mul 102 1429; mul 1357 1432; add 1431 1433; mul 305 990;
mul 34 1435; mul 34 1436; add 1434 1437; mul 303 990; add 1438 1439; mul 153 1066; add 1440 1441; mul 149 1073; add
1442 1443; mul 148 1074; add 1444 1445; mul 148 1079; add 1446 1447; mul 144 1091; add 1448 1449; mul 136 1092; add
1450 1451; mul 95 1093; add 1452 1453; mul 95 1098; add 1454 1455; mul 95 1101; add 1456 1457; mul 389 1041; mul 121
1459; add 1458 1460; mul 102 1459; mul 113 1462; add 1461 1463; mul 102 1462; mul 1357 1465; add 1464 1466; mul 385
1041; mul 34 1468; mul 113 1469; add 1467 1470; mul 102 1469; mul 1357 1472; add 1471 1473; mul 381 1041; mul 34
1475; mul 34 1476; mul 1357 1477; add 1474 1478; mul 378 1041; mul 1357 1480; add 1479 1481; mul 331 1041; mul 34
1483; mul 34 1484; mul 34 1485; add 1482 1486; mul 329 1041; mul 34 1488; add 1487 1489; mul 148 1282; add 1490
1491; mul 136 1293; add 1492 1493; mul 95 1294; add 1494 1495; mul 95 1298; add 1496 1497; mul 95 1301; add 1498
1499; mul 183 1275; mul 113 1501; add 1500 1502; mul 102 1501; mul 1357 1504; add 1503 1505; mul 180 1275; mul 34
1507; mul 1357 1508; add 1506 1509; mul 177 1275; mul 1357 1511; add 1510 1512; mul 174 1275; mul 34 1514; mul 34
1515; add 1513 1516; mul 171 1275; mul 34 1518; add 1517 1519; mul 168 1275; add 1520 1521; mul 148 1319; sub 1522
1523; mul 136 1323; sub 1524 1525; mul 95 1324; sub 1526 1527; mul 95 1328; sub 1528 1529; mul 95 1331; sub 1530
1531; mul 120 1188; mul 113 1533; sub 1532 1534; mul 102 1533; mul 1357 1536; sub 1535 1537; mul 116 1188; mul 34
1539; mul 1357 1540; sub 1538 1541; mul 112 1188; mul 1357 1543; sub 1542 1544; mul 108 1188; mul 34 1546; mul 34
1547; sub 1545 1548; mul 104 1188; mul 34 1550; sub 1549 1551; mul 93 1188; sub 1552 1553; mul 94 1554; add 1342
1555; mul 947 1556; sub 946 1557; input p 213; input c 4; input p 14; mul 28 1561; sub 2 1562; input c 5; mul 1563
1564; sub 1560 1565; input c 6; mul 486 1567; add 1566 1568; input c 7; mul 620 1570; add 1569 1571; input c 8;
input p 15; max 1573 1574; mul 535 1561; sub 526 1576; mul 1575 1577; sub 1572 1578; mul 90 1579; mul 90 1561; add
700 1581; mul 1575 1582; mul 535 1583; add 1580 1584; mul 1564 1582; input c 9; input c 10; mul 421 1588; mul 1563
1589; sub 1587 1590; input c 11; mul 486 1592; add 1591 1593; input c 12; mul 620 1595; add 1594 1596; mul 90 1597;
add 1586 1598; mul 90 1563; mul 1589 1600; sub 1599 1601; mul 28 1602; add 1585 1603; mul 1559 1604; add 1558 1605;
mul 56 70; mul 79 79; sub 1607 1608; mul 89 1609; mul 674 1610; mul 663 1610; mul 665 700; add 1612 1613; mul 543
1610; mul 59 70; mul 76 79; sub 1616 1617; mul 89 1618; mul 570 1619; sub 1615 1620; mul 91 700; mul 364 1622; sub
1621 1623; mul 603 1624; add 1614 1625; mul 656 1626; mul 603 1627; mul 533 1610; mul 536 700; add 1629 1630; mul
466 1624; add 1631 1632; mul 525 1633; mul 466 1634; add 1628 1635; mul 526 1636; sub 1611 1637; mul 542 1638; mul
698 700; mul 587 1626; mul 622 1641; mul 626 1642; mul 669 1626; mul 655 1644; mul 651 1644; mul 654 1646; add 1645
1647; mul 642 1626; add 1648 1649; mul 587 1650; mul 645 1651; mul 647 1652; mul 610 1652; mul 514 1654; add 1653
1655; sub 1643 1656; mul 610 1642; mul 624 1658; add 1657 1659; mul 609 1641; mul 616 1661; mul 612 1661; mul 614
1663; add 1662 1664; mul 757 1665; mul 752 1666; sub 1660 1667; mul 649 1651; mul 768 1669; mul 600 1669; mul 645
1671; add 1670 1672; mul 600 1671; mul 644 1674; add 1673 1675; mul 535 1627; sub 1677 718; mul 593 1678; mul 671
1624; mul 573 1627; add 1680 1681; mul 586 1682; sub 1679 1683; mul 671 1610; mul 526 1627; add 1685 1686; mul 16
1687; mul 661 1688; sub 1684 1689; mul 587 1690; mul 618 1641; mul 604 1692; mul 606 1693; add 1691 1694; mul 601
1693; mul 249 1696; add 1695 1697; mul 777 1698; mul 601 1699; sub 1676 1700; mul 767 1701; add 1668 1702; neg 1693;
mul 249 1704; add 1703 1705; mul 587 1706; mul 727 1707; mul 725 1708; mul 602 1682; mul 602 1688; mul 659 1711; add
1710 1712; sub 1709 1713; add 1640 1714; mul 674 1619; mul 571 1636; add 1716 1717; mul 569 1718; add 1715 1719; sub
1639 1720; mul 100 1619; mul 97 1610; sub 1722 1723; mul 94 1622; add 1724 1725; mul 677 1726; mul 680 1727; mul 690
1727; mul 677 1622; mul 680 1730; add 1729 1731; mul 94 1732; add 1728 1733; mul 678 1730; add 1734 1735; mul 364
1636; sub 1736 1737; mul 826 1738; sub 1721 1739; mul 674 1622; mul 539 1636; add 1741 1742; mul 363 1743; sub 1740
1744; mul 577 1610; mul 526 1634; add 1746 1747; mul 16 1748; mul 465 1749; mul 529 1750; mul 577 1624; mul 573
1634; add 1752 1753; mul 465 1754; sub 1751 1755; mul 450 1633; mul 488 1757; mul 492 1758; mul 575 1633; mul 524
1760; mul 520 1760; mul 523 1762; add 1761 1763; mul 508 1633; add 1764 1765; mul 450 1766; mul 512 1767; mul 516
1768; mul 476 1768; mul 514 1770; add 1769 1771; sub 1759 1772; mul 476 1758; mul 490 1774; add 1773 1775; mul 472
1757; mul 482 1777; mul 478 1777; mul 480 1779; add 1778 1780; mul 894 1781; mul 889 1782; sub 1776 1783; mul 518
1767; mul 905 1785; mul 463 1785; mul 512 1787; add 1786 1788; mul 463 1787; mul 511 1790; add 1789 1791; mul 535
1634; sub 1793 855; mul 456 1794; mul 449 1754; sub 1795 1796; mul 531 1749; sub 1797 1798; mul 450 1799; mul 484
1757; mul 467 1801; mul 469 1802; add 1800 1803; mul 464 1802; mul 249 1805; add 1804 1806; mul 914 1807; mul 464
1808; sub 1792 1809; mul 904 1810; add 1784 1811; neg 1802; mul 249 1813; add 1812 1814; mul 450 1815; mul 864 1816;
mul 862 1817; add 1756 1818; add 1714 1819; mul 441 1820; add 1745 1821; sub 1822 1819; mul 92 1619; mul 204 1824;
mul 102 1825; mul 948 1826; mul 131 1824; mul 34 1828; mul 948 1829; add 1827 1830; mul 961 1824; mul 948 1832; add
1831 1833; mul 116 1824; mul 102 1835; mul 102 1836; add 1834 1837; mul 969 1824; mul 34 1839; mul 102 1840; add
1838 1841; mul 104 1824; mul 102 1843; add 1842 1844; mul 294 1718; mul 353 1846; mul 102 1847; mul 948 1848; sub
1845 1849; mul 314 1846; mul 34 1851; mul 948 1852; sub 1850 1853; mul 560 1846; mul 34 1855; mul 102 1856; sub 1854
1857; mul 294 1638; mul 97 1859; mul 100 1846; sub 1860 1861; mul 294 1743; mul 94 1863; sub 1862 1864; mul 358
1865; mul 148 1866; add 1858 1867; mul 95 1866; mul 948 1869; add 1868 1870; mul 320 1865; mul 102 1872; mul 948
1873; add 1871 1874; mul 353 1865; mul 34 1876; mul 948 1877; add 1875 1878; mul 350 1865; mul 102 1880; mul 102
1881; add 1879 1882; mul 305 1865; mul 34 1884; mul 34 1885; add 1883 1886; mul 303 1865; add 1887 1888; mul 326
1863; mul 148 1890; sub 1889 1891; mul 95 1890; mul 948 1893; sub 1892 1894; mul 323 1863; mul 102 1896; mul 948
1897; sub 1895 1898; mul 320 1863; mul 102 1900; mul 102 1901; sub 1899 1902; mul 317 1863; mul 34 1904; mul 102
1905; sub 1903 1906; mul 314 1863; mul 34 1908; mul 34 1909; sub 1907 1910; mul 311 1863; sub 1911 1912; mul 294
1820; mul 421 1914; mul 34 1915; sub 1916 1846; mul 300 1917; add 1913 1918; mul 2 1915; add 1859 1920; mul 297
1921; add 1919 1922; mul 302 1915; add 1923 1924; mul 95 1915; sub 1926 1863; mul 295 1927; add 1925 1928; mul 417
1914; mul 153 1930; add 1929 1931; mul 95 1930; mul 148 1933; add 1932 1934; mul 95 1933; mul 948 1936; add 1935
1937; mul 358 1914; mul 102 1939; mul 148 1940; add 1938 1941; mul 95 1940; mul 948 1943; add 1942 1944; mul 410
1914; mul 102 1946; mul 102 1947; mul 948 1948; add 1945 1949; mul 353 1914; mul 34 1951; mul 102 1952; mul 948
1953; add 1950 1954; mul 403 1914; mul 34 1956; mul 34 1957; mul 948 1958; add 1955 1959; mul 227 1914; mul 948
1961; add 1960 1962; mul 308 1914; mul 102 1964; mul 102 1965; mul 102 1966; add 1963 1967; mul 305 1914; mul 34
1969; mul 34 1970; mul 102 1971; add 1968 1972; mul 303 1914; mul 102 1974; add 1973 1975; mul 267 1824; mul 266
1977; mul 252 1824; mul 251 1824; mul 222 1980; add 1979 1981; mul 250 1982; add 1978 1983; mul 232 1824; mul 231
1824; mul 222 1986; add 1985 1987; mul 230 1988; add 1984 1989; mul 225 1824; add 1990 1991; mul 224 1824; mul 223
1824; mul 222 1994; add 1993 1995; mul 222 1996; add 1992 1997; where 1115 1998; mul 92 1610; mul 274 2000; mul 266
2001; neg 2002; where 1141 2003; add 1999 2004; mul 262 2000; mul 261 2000; mul 230 2007; add 2006 2008; mul 250
2009; neg 2010; where 1141 2011; add 2005 2012; mul 256 1824; mul 230 2014; where 1115 2015; mul 257 2000; neg 2017;
where 1141 2018; add 2016 2019; mul 250 2020; add 2013 2021; mul 243 2000; neg 2023; where 1141 2024; add 2022 2025;
mul 242 2000; mul 241 2000; mul 230 2028; add 2027 2029; mul 230 2030; neg 2031; where 1141 2032; add 2026 2033; mul
238 2000; neg 2035; where 1141 2036; add 2034 2037; mul 236 1824; mul 230 2039; where 1115 2040; mul 237 2000; neg
2042; where 1141 2043; add 2041 2044; mul 230 2045; add 2038 2046; mul 233 2000; neg 2048; where 1141 2049; add 2047
2050; mul 92 1622; mul 250 2052; mul 285 2053; where 218 2054; add 2051 2055; mul 288 2052; mul 249 2057; where 218
2058; add 2056 2059; mul 248 2053; mul 266 2052; add 2061 2062; mul 282 2063; where 218 2064; add 2060 2065; mul 282
2052; mul 266 2067; where 218 2068; add 2066 2069; mul 285 2052; mul 248 2067; add 2071 2072; mul 250 2073; where
218 2074; add 2070 2075; mul 275 2053; where 218 2077; add 2076 2078; mul 278 2052; mul 249 2080; where 218 2081;
add 2079 2082; mul 248 2001; neg 2084; where 1141 2085; mul 275 2052; where 218 2087; add 2086 2088; mul 250 2089;
add 2083 2090; mul 268 2053; where 218 2092; add 2091 2093; mul 271 2052; mul 249 2095; where 218 2096; add 2094
2097; mul 248 1977; where 1115 2099; mul 268 2052; where 218 2101; add 2100 2102; mul 250 2103; add 2098 2104; mul
263 2052; mul 249 2106; where 218 2107; add 2105 2108; mul 258 2052; mul 249 2110; where 218 2111; add 2109 2112;
mul 253 2052; mul 249 2114; where 218 2115; add 2113 2116; mul 1113 2117; mul 1108 2118; add 1976 2119; mul 100
1824; mul 97 2000; sub 2121 2122; mul 94 2052; add 2123 2124; mul 210 2125; mul 148 2126; add 2120 2127; mul 95
2126; mul 948 2129; add 2128 2130; mul 143 2125; mul 102 2132; mul 948 2133; add 2131 2134; mul 204 2125; mul 34
2136; mul 948 2137; add 2135 2138; mul 201 2125; mul 948 2140; add 2139 2141; mul 198 2125; mul 102 2143; mul 102
2144; add 2142 2145; mul 195 2125; mul 34 2147; mul 102 2148; add 2146 2149; mul 192 2125; mul 102 2151; add 2150
2152; mul 108 2125; mul 34 2154; mul 34 2155; add 2153 2156; mul 104 2125; mul 34 2158; add 2157 2159; mul 93 2125;
add 2160 2161; mul 152 2052; mul 148 2163; add 2162 2164; mul 95 2163; mul 948 2166; add 2165 2167; mul 147 2052;
mul 102 2169; mul 948 2170; add 2168 2171; mul 143 2052; mul 102 2173; mul 102 2174; add 2172 2175; mul 139 2052;
mul 34 2177; mul 102 2178; add 2176 2179; mul 135 2052; mul 102 2181; add 2180 2182; mul 131 2052; mul 34 2184; mul
34 2185; add 2183 2186; mul 127 2052; mul 34 2188; add 2187 2189; mul 124 2052; add 2190 2191; mul 148 1825; mul 136
1835; add 2193 2194; mul 95 1836; add 2195 2196; mul 95 1840; add 2197 2198; mul 95 1843; add 2199 2200; mul 1353
1824; mul 113 2202; add 2201 2203; mul 102 2202; mul 1357 2205; add 2204 2206; mul 174 1824; mul 34 2208; mul 1357
2209; add 2207 2210; mul 1365 1824; mul 1357 2212; add 2211 2213; mul 1369 1824; mul 34 2215; mul 34 2216; add 2214
2217; mul 1374 1824; mul 34 2219; add 2218 2220; mul 157 1824; add 2221 2222; mul 148 1847; sub 2223 2224; mul 95
1856; sub 2225 2226; mul 385 1846; mul 113 2228; sub 2227 2229; mul 102 2228; mul 1357 2231; sub 2230 2232; mul 337
1846; mul 34 2234; mul 1357 2235; sub 2233 2236; mul 553 1846; mul 34 2238; mul 34 2239; sub 2237 2240; mul 329
1846; sub 2241 2242; mul 148 1872; add 2243 2244; mul 136 1880; add 2245 2246; mul 95 1881; add 2247 2248; mul 343
1865; mul 113 2250; add 2249 2251; mul 102 2250; mul 1357 2253; add 2252 2254; mul 340 1865; mul 34 2256; mul 1357
2257; add 2255 2258; mul 337 1865; mul 34 2260; mul 34 2261; add 2259 2262; mul 334 1865; add 2263 2264; mul 148
1896; sub 2265 2266; mul 136 1900; sub 2267 2268; mul 95 1901; sub 2269 2270; mul 95 1905; sub 2271 2272; mul 308
1863; mul 113 2274; sub 2273 2275; mul 102 2274; mul 1357 2277; sub 2276 2278; mul 305 1863; mul 34 2280; mul 34
2281; sub 2279 2282; mul 303 1863; sub 2283 2284; mul 153 1939; add 2285 2286; mul 149 1946; add 2287 2288; mul 148
1947; add 2289 2290; mul 148 1952; add 2291 2292; mul 144 1964; add 2293 2294; mul 136 1965; add 2295 2296; mul 95
1966; add 2297 2298; mul 95 1971; add 2299 2300; mul 95 1974; add 2301 2302; mul 389 1914; mul 121 2304; add 2303
2305; mul 102 2304; mul 113 2307; add 2306 2308; mul 102 2307; mul 1357 2310; add 2309 2311; mul 385 1914; mul 34
2313; mul 113 2314; add 2312 2315; mul 102 2314; mul 1357 2317; add 2316 2318; mul 381 1914; mul 34 2320; mul 34
2321; mul 1357 2322; add 2319 2323; mul 378 1914; mul 1357 2325; add 2324 2326; mul 331 1914; mul 34 2328; mul 34
2329; mul 34 2330; add 2327 2331; mul 329 1914; mul 34 2333; add 2332 2334; mul 148 2132; add 2335 2336; mul 136
2143; add 2337 2338; mul 95 2144; add 2339 2340; mul 95 2148; add 2341 2342; mul 95 2151; add 2343 2344; mul 183
2125; mul 113 2346; add 2345 2347; mul 102 2346; mul 1357 2349; add 2348 2350; mul 180 2125; mul 34 2352; mul 1357
2353; add 2351 2354; mul 177 2125; mul 1357 2356; add 2355 2357; mul 174 2125; mul 34 2359; mul 34 2360; add 2358
2361; mul 171 2125; mul 34 2363; add 2362 2364; mul 168 2125; add 2365 2366; mul 148 2169; add 2367 2368; mul 136
2173; add 2369 2370; mul 95 2174; add 2371 2372; mul 95 2178; add 2373 2374; mul 95 2181; add 2375 2376; mul 120
2052; mul 113 2378; add 2377 2379; mul 102 2378; mul 1357 2381; add 2380 2382; mul 116 2052; mul 34 2384; mul 1357
2385; add 2383 2386; mul 112 2052; mul 1357 2388; add 2387 2389; mul 108 2052; mul 34 2391; mul 34 2392; add 2390
2393; mul 104 2052; mul 34 2395; add 2394 2396; mul 93 2052; add 2397 2398; mul 94 2399; add 2192 2400; mul 947
2401; sub 1823 2402; mul 700 1579; mul 700 1561; add 1610 2405; mul 1575 2406; mul 535 2407; add 2404 2408; mul 700
1563; mul 1589 2410; mul 1564 2406; mul 700 1597; add 2412 2413; sub 2411 2414; mul 28 2415; sub 2409 2416; mul 1559
2417; sub 2403 2418; mul 698 704; mul 663 1619; mul 665 704; add 2421 2422; mul 45 70; mul 76 76; sub 2424 2425; mul
89 2426; mul 570 2427; mul 543 1619; sub 2428 2429; mul 91 704; mul 364 2431; add 2430 2432; mul 603 2433; sub 2423
2434; mul 656 2435; mul 573 2436; mul 671 2433; sub 2437 2438; mul 602 2439; mul 671 1619; mul 526 2436; add 2441
2442; mul 16 2443; mul 602 2444; mul 659 2445; add 2440 2446; mul 669 2435; mul 655 2448; mul 651 2448; mul 654
2450; add 2449 2451; mul 642 2435; add 2452 2453; mul 587 2454; mul 645 2455; mul 647 2456; mul 610 2456; mul 514
2458; add 2457 2459; mul 587 2435; mul 622 2461; mul 626 2462; sub 2460 2463; mul 610 2462; mul 624 2465; sub 2464
2466; mul 609 2461; mul 616 2468; mul 612 2468; mul 614 2470; add 2469 2471; mul 757 2472; mul 752 2473; add 2467
2474; mul 649 2455; mul 768 2476; mul 600 2476; mul 645 2478; add 2477 2479; mul 600 2478; mul 644 2481; add 2480
2482; mul 586 2439; mul 671 704; mul 535 2436; sub 2485 2486; mul 593 2487; add 2484 2488; mul 661 2444; add 2489
2490; mul 587 2491; mul 618 2461; mul 604 2493; mul 606 2494; sub 2492 2495; mul 601 2494; neg 2497; mul 249 2498;
add 2496 2499; mul 777 2500; mul 601 2501; add 2483 2502; mul 767 2503; sub 2475 2504; mul 249 2494; add 2505 2506;
mul 587 2507; mul 727 2508; mul 725 2509; add 2447 2510; sub 2420 2511; mul 674 2427; mul 603 2436; mul 533 1619;
mul 536 704; add 2515 2516; mul 466 2433; sub 2517 2518; mul 525 2519; mul 466 2520; add 2514 2521; mul 571 2522;
add 2513 2523; mul 569 2524; add 2512 2525; mul 526 2522; sub 2527 1716; mul 542 2528; add 2526 2529; mul 97 1619;
mul 100 2427; sub 2531 2532; mul 94 2431; sub 2533 2534; mul 677 2535; mul 680 2536; mul 690 2536; mul 677 2431; mul
680 2539; sub 2538 2540; mul 94 2541; add 2537 2542; mul 678 2539; sub 2543 2544; mul 364 2522; add 2545 2546; mul
826 2547; sub 2530 2548; mul 674 2431; mul 539 2522; add 2550 2551; mul 363 2552; add 2549 2553; mul 573 2520; mul
577 2433; sub 2555 2556; mul 465 2557; mul 577 1619; mul 526 2520; add 2559 2560; mul 16 2561; mul 465 2562; mul 529
2563; sub 2558 2564; mul 575 2519; mul 524 2566; mul 520 2566; mul 523 2568; add 2567 2569; mul 508 2519; add 2570
2571; mul 450 2572; mul 512 2573; mul 516 2574; mul 476 2574; mul 514 2576; add 2575 2577; mul 450 2519; mul 488
2579; mul 492 2580; sub 2578 2581; mul 476 2580; mul 490 2583; sub 2582 2584; mul 472 2579; mul 482 2586; mul 478
2586; mul 480 2588; add 2587 2589; mul 894 2590; mul 889 2591; add 2585 2592; mul 518 2573; mul 905 2594; mul 463
2594; mul 512 2596; add 2595 2597; mul 463 2596; mul 511 2599; add 2598 2600; mul 449 2557; mul 577 704; mul 535
2520; sub 2603 2604; mul 456 2605; add 2602 2606; mul 531 2562; add 2607 2608; mul 450 2609; mul 484 2579; mul 467
2611; mul 469 2612; sub 2610 2613; mul 464 2612; neg 2615; mul 249 2616; add 2614 2617; mul 914 2618; mul 464 2619;
add 2601 2620; mul 904 2621; sub 2593 2622; mul 249 2612; add 2623 2624; mul 450 2625; mul 864 2626; mul 862 2627;
add 2565 2628; add 2511 2629; mul 441 2630; add 2554 2631; sub 2632 2629; mul 294 2524; mul 353 2634; mul 102 2635;
mul 948 2636; mul 92 2427; mul 204 2638; mul 102 2639; mul 948 2640; mul 131 2638; mul 34 2642; mul 948 2643; add
2641 2644; mul 961 2638; mul 948 2646; add 2645 2647; mul 116 2638; mul 102 2649; mul 102 2650; add 2648 2651; mul
969 2638; mul 34 2653; mul 102 2654; add 2652 2655; mul 104 2638; mul 102 2657; add 2656 2658; sub 2637 2659; mul
314 2634; mul 34 2661; mul 948 2662; add 2660 2663; mul 560 2634; mul 34 2665; mul 102 2666; add 2664 2667; mul 100
2634; mul 294 2528; mul 97 2670; add 2669 2671; mul 294 2552; mul 94 2673; add 2672 2674; mul 358 2675; mul 148
2676; add 2668 2677; mul 95 2676; mul 948 2679; add 2678 2680; mul 320 2675; mul 102 2682; mul 948 2683; add 2681
2684; mul 353 2675; mul 34 2686; mul 948 2687; add 2685 2688; mul 350 2675; mul 102 2690; mul 102 2691; add 2689
2692; mul 305 2675; mul 34 2694; mul 34 2695; add 2693 2696; mul 303 2675; add 2697 2698; mul 326 2673; mul 148
2700; add 2699 2701; mul 95 2700; mul 948 2703; add 2702 2704; mul 323 2673; mul 102 2706; mul 948 2707; add 2705
2708; mul 320 2673; mul 102 2710; mul 102 2711; add 2709 2712; mul 317 2673; mul 34 2714; mul 102 2715; add 2713
2716; mul 314 2673; mul 34 2718; mul 34 2719; add 2717 2720; mul 311 2673; add 2721 2722; mul 294 2630; mul 421
2724; mul 34 2725; add 2634 2726; mul 300 2727; add 2723 2728; mul 2 2725; add 2670 2730; mul 297 2731; add 2729
2732; mul 302 2725; add 2733 2734; mul 95 2725; add 2673 2736; mul 295 2737; add 2735 2738; mul 417 2724; mul 153
2740; add 2739 2741; mul 95 2740; mul 148 2743; add 2742 2744; mul 95 2743; mul 948 2746; add 2745 2747; mul 358
2724; mul 102 2749; mul 148 2750; add 2748 2751; mul 95 2750; mul 948 2753; add 2752 2754; mul 410 2724; mul 102
2756; mul 102 2757; mul 948 2758; add 2755 2759; mul 353 2724; mul 34 2761; mul 102 2762; mul 948 2763; add 2760
2764; mul 403 2724; mul 34 2766; mul 34 2767; mul 948 2768; add 2765 2769; mul 227 2724; mul 948 2771; add 2770
2772; mul 308 2724; mul 102 2774; mul 102 2775; mul 102 2776; add 2773 2777; mul 305 2724; mul 34 2779; mul 34 2780;
mul 102 2781; add 2778 2782; mul 303 2724; mul 102 2784; add 2783 2785; mul 267 2638; mul 266 2787; mul 252 2638;
mul 251 2638; mul 222 2790; add 2789 2791; mul 250 2792; add 2788 2793; mul 232 2638; mul 231 2638; mul 222 2796;
add 2795 2797; mul 230 2798; add 2794 2799; mul 225 2638; add 2800 2801; mul 224 2638; mul 223 2638; mul 222 2804;
add 2803 2805; mul 222 2806; add 2802 2807; neg 2808; where 1115 2809; mul 274 1824; mul 266 2811; where 1141 2812;
add 2810 2813; mul 262 1824; mul 261 1824; mul 230 2816; add 2815 2817; mul 250 2818; where 1141 2819; add 2814
2820; mul 256 2638; mul 230 2822; neg 2823; where 1115 2824; mul 257 1824; where 1141 2826; add 2825 2827; mul 250
2828; add 2821 2829; mul 243 1824; where 1141 2831; add 2830 2832; mul 242 1824; mul 241 1824; mul 230 2835; add
2834 2836; mul 230 2837; where 1141 2838; add 2833 2839; mul 238 1824; where 1141 2841; add 2840 2842; mul 236 2638;
mul 230 2844; neg 2845; where 1115 2846; mul 237 1824; where 1141 2848; add 2847 2849; mul 230 2850; add 2843 2851;
mul 233 1824; where 1141 2853; add 2852 2854; mul 92 2431; mul 250 2856; mul 285 2857; neg 2858; where 218 2859; add
2855 2860; mul 288 2856; neg 2862; mul 249 2863; where 218 2864; add 2861 2865; mul 248 2857; mul 266 2856; add 2867
2868; mul 282 2869; neg 2870; where 218 2871; add 2866 2872; mul 282 2856; mul 266 2874; neg 2875; where 218 2876;
add 2873 2877; mul 285 2856; mul 248 2874; add 2879 2880; mul 250 2881; neg 2882; where 218 2883; add 2878 2884; mul
275 2857; neg 2886; where 218 2887; add 2885 2888; mul 278 2856; neg 2890; mul 249 2891; where 218 2892; add 2889
2893; mul 248 2811; where 1141 2895; mul 275 2856; neg 2897; where 218 2898; add 2896 2899; mul 250 2900; add 2894
2901; mul 268 2857; neg 2903; where 218 2904; add 2902 2905; mul 271 2856; neg 2907; mul 249 2908; where 218 2909;
add 2906 2910; mul 248 2787; neg 2912; where 1115 2913; mul 268 2856; neg 2915; where 218 2916; add 2914 2917; mul
250 2918; add 2911 2919; mul 263 2856; neg 2921; mul 249 2922; where 218 2923; add 2920 2924; mul 258 2856; neg
2926; mul 249 2927; where 218 2928; add 2925 2929; mul 253 2856; neg 2931; mul 249 2932; where 218 2933; add 2930
2934; mul 1113 2935; mul 1108 2936; add 2786 2937; mul 97 1824; mul 100 2638; sub 2939 2940; mul 94 2856; sub 2941
2942; mul 210 2943; mul 148 2944; add 2938 2945; mul 95 2944; mul 948 2947; add 2946 2948; mul 143 2943; mul 102
2950; mul 948 2951; add 2949 2952; mul 204 2943; mul 34 2954; mul 948 2955; add 2953 2956; mul 201 2943; mul 948
2958; add 2957 2959; mul 198 2943; mul 102 2961; mul 102 2962; add 2960 2963; mul 195 2943; mul 34 2965; mul 102
2966; add 2964 2967; mul 192 2943; mul 102 2969; add 2968 2970; mul 108 2943; mul 34 2972; mul 34 2973; add 2971
2974; mul 104 2943; mul 34 2976; add 2975 2977; mul 93 2943; add 2978 2979; mul 152 2856; mul 148 2981; sub 2980
2982; mul 95 2981; mul 948 2984; sub 2983 2985; mul 147 2856; mul 102 2987; mul 948 2988; sub 2986 2989; mul 143
2856; mul 102 2991; mul 102 2992; sub 2990 2993; mul 139 2856; mul 34 2995; mul 102 2996; sub 2994 2997; mul 135
2856; mul 102 2999; sub 2998 3000; mul 131 2856; mul 34 3002; mul 34 3003; sub 3001 3004; mul 127 2856; mul 34 3006;
sub 3005 3007; mul 124 2856; sub 3008 3009; mul 148 2635; mul 148 2639; mul 136 2649; add 3012 3013; mul 95 2650;
add 3014 3015; mul 95 2654; add 3016 3017; mul 95 2657; add 3018 3019; mul 1353 2638; mul 113 3021; add 3020 3022;
mul 102 3021; mul 1357 3024; add 3023 3025; mul 174 2638; mul 34 3027; mul 1357 3028; add 3026 3029; mul 1365 2638;
mul 1357 3031; add 3030 3032; mul 1369 2638; mul 34 3034; mul 34 3035; add 3033 3036; mul 1374 2638; mul 34 3038;
add 3037 3039; mul 157 2638; add 3040 3041; sub 3011 3042; mul 95 2666; add 3043 3044; mul 385 2634; mul 113 3046;
add 3045 3047; mul 102 3046; mul 1357 3049; add 3048 3050; mul 337 2634; mul 34 3052; mul 1357 3053; add 3051 3054;
mul 553 2634; mul 34 3056; mul 34 3057; add 3055 3058; mul 329 2634; add 3059 3060; mul 148 2682; add 3061 3062; mul
136 2690; add 3063 3064; mul 95 2691; add 3065 3066; mul 343 2675; mul 113 3068; add 3067 3069; mul 102 3068; mul
1357 3071; add 3070 3072; mul 340 2675; mul 34 3074; mul 1357 3075; add 3073 3076; mul 337 2675; mul 34 3078; mul 34
3079; add 3077 3080; mul 334 2675; add 3081 3082; mul 148 2706; add 3083 3084; mul 136 2710; add 3085 3086; mul 95
2711; add 3087 3088; mul 95 2715; add 3089 3090; mul 308 2673; mul 113 3092; add 3091 3093; mul 102 3092; mul 1357
3095; add 3094 3096; mul 305 2673; mul 34 3098; mul 34 3099; add 3097 3100; mul 303 2673; add 3101 3102; mul 153
2749; add 3103 3104; mul 149 2756; add 3105 3106; mul 148 2757; add 3107 3108; mul 148 2762; add 3109 3110; mul 144
2774; add 3111 3112; mul 136 2775; add 3113 3114; mul 95 2776; add 3115 3116; mul 95 2781; add 3117 3118; mul 95
2784; add 3119 3120; mul 389 2724; mul 121 3122; add 3121 3123; mul 102 3122; mul 113 3125; add 3124 3126; mul 102
3125; mul 1357 3128; add 3127 3129; mul 385 2724; mul 34 3131; mul 113 3132; add 3130 3133; mul 102 3132; mul 1357
3135; add 3134 3136; mul 381 2724; mul 34 3138; mul 34 3139; mul 1357 3140; add 3137 3141; mul 378 2724; mul 1357
3143; add 3142 3144; mul 331 2724; mul 34 3146; mul 34 3147; mul 34 3148; add 3145 3149; mul 329 2724; mul 34 3151;
add 3150 3152; mul 148 2950; add 3153 3154; mul 136 2961; add 3155 3156; mul 95 2962; add 3157 3158; mul 95 2966;
add 3159 3160; mul 95 2969; add 3161 3162; mul 183 2943; mul 113 3164; add 3163 3165; mul 102 3164; mul 1357 3167;
add 3166 3168; mul 180 2943; mul 34 3170; mul 1357 3171; add 3169 3172; mul 177 2943; mul 1357 3174; add 3173 3175;
mul 174 2943; mul 34 3177; mul 34 3178; add 3176 3179; mul 171 2943; mul 34 3181; add 3180 3182; mul 168 2943; add
3183 3184; mul 148 2987; sub 3185 3186; mul 136 2991; sub 3187 3188; mul 95 2992; sub 3189 3190; mul 95 2996; sub
3191 3192; mul 95 2999; sub 3193 3194; mul 120 2856; mul 113 3196; sub 3195 3197; mul 102 3196; mul 1357 3199; sub
3198 3200; mul 116 2856; mul 34 3202; mul 1357 3203; sub 3201 3204; mul 112 2856; mul 1357 3206; sub 3205 3207; mul
108 2856; mul 34 3209; mul 34 3210; sub 3208 3211; mul 104 2856; mul 34 3213; sub 3212 3214; mul 93 2856; sub 3215
3216; mul 94 3217; add 3010 3218; mul 947 3219; sub 2633 3220; mul 704 1579; mul 704 1561; add 1619 3223; mul 1575
3224; mul 535 3225; add 3222 3226; mul 1564 3224; mul 704 1597; add 3228 3229; mul 704 1563; mul 1589 3231; sub 3230
3232; mul 28 3233; add 3227 3234; mul 1559 3235; add 3221 3236; mul 466 520; mul 571 3238; mul 569 3239; mul 526
3238; mul 542 3241; add 3240 3242; mul 364 3238; mul 826 3244; sub 3243 3245; mul 539 3238; mul 363 3247; add 3246
3248; mul 520 573; mul 465 3250; mul 520 526; mul 16 3252; mul 465 3253; mul 529 3254; sub 3251 3255; mul 450 575;
mul 512 3257; mul 516 3258; mul 476 3258; mul 514 3260; add 3259 3261; mul 518 3257; mul 905 3263; mul 463 3263; mul
512 3265; add 3264 3266; mul 463 3265; mul 511 3268; add 3267 3269; mul 449 3250; mul 520 535; mul 456 3272; sub
3271 3273; mul 531 3253; add 3274 3275; mul 450 3276; mul 914 3277; mul 464 3278; add 3270 3279; mul 904 3280; sub
3262 3281; mul 450 3282; mul 864 3283; mul 862 3284; add 3256 3285; mul 441 3286; add 3249 3287; sub 3288 3286; mul
294 3239; mul 353 3290; mul 102 3291; mul 948 3292; mul 314 3290; mul 34 3294; mul 948 3295; add 3293 3296; mul 560
3290; mul 34 3298; mul 102 3299; add 3297 3300; mul 100 3290; mul 294 3241; mul 97 3303; add 3302 3304; mul 294
3247; mul 94 3306; add 3305 3307; mul 358 3308; mul 148 3309; add 3301 3310; mul 95 3309; mul 948 3312; add 3311
3313; mul 320 3308; mul 102 3315; mul 948 3316; add 3314 3317; mul 353 3308; mul 34 3319; mul 948 3320; add 3318
3321; mul 350 3308; mul 102 3323; mul 102 3324; add 3322 3325; mul 305 3308; mul 34 3327; mul 34 3328; add 3326
3329; mul 303 3308; add 3330 3331; mul 326 3306; mul 148 3333; add 3332 3334; mul 95 3333; mul 948 3336; add 3335
3337; mul 323 3306; mul 102 3339; mul 948 3340; add 3338 3341; mul 320 3306; mul 102 3343; mul 102 3344; add 3342
3345; mul 317 3306; mul 34 3347; mul 102 3348; add 3346 3349; mul 314 3306; mul 34 3351; mul 34 3352; add 3350 3353;
mul 311 3306; add 3354 3355; mul 294 3286; mul 421 3357; mul 34 3358; add 3290 3359; mul 300 3360; add 3356 3361;
mul 2 3358; add 3303 3363; mul 297 3364; add 3362 3365; mul 302 3358; add 3366 3367; mul 95 3358; add 3306 3369; mul
295 3370; add 3368 3371; mul 417 3357; mul 153 3373; add 3372 3374; mul 95 3373; mul 148 3376; add 3375 3377; mul 95
3376; mul 948 3379; add 3378 3380; mul 358 3357; mul 102 3382; mul 148 3383; add 3381 3384; mul 95 3383; mul 948
3386; add 3385 3387; mul 410 3357; mul 102 3389; mul 102 3390; mul 948 3391; add 3388 3392; mul 353 3357; mul 34
3394; mul 102 3395; mul 948 3396; add 3393 3397; mul 403 3357; mul 34 3399; mul 34 3400; mul 948 3401; add 3398
3402; mul 227 3357; mul 948 3404; add 3403 3405; mul 308 3357; mul 102 3407; mul 102 3408; mul 102 3409; add 3406
3410; mul 305 3357; mul 34 3412; mul 34 3413; mul 102 3414; add 3411 3415; mul 303 3357; mul 102 3417; add 3416
3418; mul 148 3291; mul 95 3299; add 3420 3421; mul 385 3290; mul 113 3423; add 3422 3424; mul 102 3423; mul 1357
3426; add 3425 3427; mul 337 3290; mul 34 3429; mul 1357 3430; add 3428 3431; mul 553 3290; mul 34 3433; mul 34
3434; add 3432 3435; mul 329 3290; add 3436 3437; mul 148 3315; add 3438 3439; mul 136 3323; add 3440 3441; mul 95
3324; add 3442 3443; mul 343 3308; mul 113 3445; add 3444 3446; mul 102 3445; mul 1357 3448; add 3447 3449; mul 340
3308; mul 34 3451; mul 1357 3452; add 3450 3453; mul 337 3308; mul 34 3455; mul 34 3456; add 3454 3457; mul 334
3308; add 3458 3459; mul 148 3339; add 3460 3461; mul 136 3343; add 3462 3463; mul 95 3344; add 3464 3465; mul 95
3348; add 3466 3467; mul 308 3306; mul 113 3469; add 3468 3470; mul 102 3469; mul 1357 3472; add 3471 3473; mul 305
3306; mul 34 3475; mul 34 3476; add 3474 3477; mul 303 3306; add 3478 3479; mul 153 3382; add 3480 3481; mul 149
3389; add 3482 3483; mul 148 3390; add 3484 3485; mul 148 3395; add 3486 3487; mul 144 3407; add 3488 3489; mul 136
3408; add 3490 3491; mul 95 3409; add 3492 3493; mul 95 3414; add 3494 3495; mul 95 3417; add 3496 3497; mul 389
3357; mul 121 3499; add 3498 3500; mul 102 3499; mul 113 3502; add 3501 3503; mul 102 3502; mul 1357 3505; add 3504
3506; mul 385 3357; mul 34 3508; mul 113 3509; add 3507 3510; mul 102 3509; mul 1357 3512; add 3511 3513; mul 381
3357; mul 34 3515; mul 34 3516; mul 1357 3517; add 3514 3518; mul 378 3357; mul 1357 3520; add 3519 3521; mul 331
3357; mul 34 3523; mul 34 3524; mul 34 3525; add 3522 3526; mul 329 3357; mul 34 3528; add 3527 3529; mul 94 3530;
add 3419 3531; mul 947 3532; sub 3289 3533; mul 603 651; mul 571 3535; mul 569 3536; mul 573 651; mul 602 3538; mul
526 651; mul 16 3540; mul 602 3541; mul 659 3542; add 3539 3543; mul 587 669; mul 645 3545; mul 647 3546; mul 610
3546; mul 514 3548; add 3547 3549; mul 649 3545; mul 768 3551; mul 600 3551; mul 645 3553; add 3552 3554; mul 600
3553; mul 644 3556; add 3555 3557; mul 586 3538; mul 535 651; mul 593 3560; sub 3559 3561; mul 661 3541; add 3562
3563; mul 587 3564; mul 777 3565; mul 601 3566; add 3558 3567; mul 767 3568; sub 3550 3569; mul 587 3570; mul 727
3571; mul 725 3572; add 3544 3573; sub 3537 3574; mul 526 3535; mul 542 3576; add 3575 3577; mul 364 3535; mul 826
3579; sub 3578 3580; mul 539 3535; mul 363 3582; add 3581 3583; mul 441 3574; add 3584 3585; mul 294 3536; mul 353
3587; mul 102 3588; mul 948 3589; mul 314 3587; mul 34 3591; mul 948 3592; add 3590 3593; mul 560 3587; mul 34 3595;
mul 102 3596; add 3594 3597; mul 100 3587; mul 294 3576; mul 97 3600; add 3599 3601; mul 294 3582; mul 94 3603; add
3602 3604; mul 358 3605; mul 148 3606; add 3598 3607; mul 95 3606; mul 948 3609; add 3608 3610; mul 320 3605; mul
102 3612; mul 948 3613; add 3611 3614; mul 353 3605; mul 34 3616; mul 948 3617; add 3615 3618; mul 350 3605; mul 102
3620; mul 102 3621; add 3619 3622; mul 305 3605; mul 34 3624; mul 34 3625; add 3623 3626; mul 303 3605; add 3627
3628; mul 326 3603; mul 148 3630; add 3629 3631; mul 95 3630; mul 948 3633; add 3632 3634; mul 323 3603; mul 102
3636; mul 948 3637; add 3635 3638; mul 320 3603; mul 102 3640; mul 102 3641; add 3639 3642; mul 317 3603; mul 34
3644; mul 102 3645; add 3643 3646; mul 314 3603; mul 34 3648; mul 34 3649; add 3647 3650; mul 311 3603; add 3651
3652; mul 294 3574; mul 421 3654; mul 34 3655; add 3587 3656; mul 300 3657; add 3653 3658; mul 2 3655; add 3600
3660; mul 297 3661; add 3659 3662; mul 302 3655; add 3663 3664; mul 95 3655; add 3603 3666; mul 295 3667; add 3665
3668; mul 417 3654; mul 153 3670; add 3669 3671; mul 95 3670; mul 148 3673; add 3672 3674; mul 95 3673; mul 948
3676; add 3675 3677; mul 358 3654; mul 102 3679; mul 148 3680; add 3678 3681; mul 95 3680; mul 948 3683; add 3682
3684; mul 410 3654; mul 102 3686; mul 102 3687; mul 948 3688; add 3685 3689; mul 353 3654; mul 34 3691; mul 102
3692; mul 948 3693; add 3690 3694; mul 403 3654; mul 34 3696; mul 34 3697; mul 948 3698; add 3695 3699; mul 227
3654; mul 948 3701; add 3700 3702; mul 308 3654; mul 102 3704; mul 102 3705; mul 102 3706; add 3703 3707; mul 305
3654; mul 34 3709; mul 34 3710; mul 102 3711; add 3708 3712; mul 303 3654; mul 102 3714; add 3713 3715; mul 148
3588; mul 95 3596; add 3717 3718; mul 385 3587; mul 113 3720; add 3719 3721; mul 102 3720; mul 1357 3723; add 3722
3724; mul 337 3587; mul 34 3726; mul 1357 3727; add 3725 3728; mul 553 3587; mul 34 3730; mul 34 3731; add 3729
3732; mul 329 3587; add 3733 3734; mul 148 3612; add 3735 3736; mul 136 3620; add 3737 3738; mul 95 3621; add 3739
3740; mul 343 3605; mul 113 3742; add 3741 3743; mul 102 3742; mul 1357 3745; add 3744 3746; mul 340 3605; mul 34
3748; mul 1357 3749; add 3747 3750; mul 337 3605; mul 34 3752; mul 34 3753; add 3751 3754; mul 334 3605; add 3755
3756; mul 148 3636; add 3757 3758; mul 136 3640; add 3759 3760; mul 95 3641; add 3761 3762; mul 95 3645; add 3763
3764; mul 308 3603; mul 113 3766; add 3765 3767; mul 102 3766; mul 1357 3769; add 3768 3770; mul 305 3603; mul 34
3772; mul 34 3773; add 3771 3774; mul 303 3603; add 3775 3776; mul 153 3679; add 3777 3778; mul 149 3686; add 3779
3780; mul 148 3687; add 3781 3782; mul 148 3692; add 3783 3784; mul 144 3704; add 3785 3786; mul 136 3705; add 3787
3788; mul 95 3706; add 3789 3790; mul 95 3711; add 3791 3792; mul 95 3714; add 3793 3794; mul 389 3654; mul 121
3796; add 3795 3797; mul 102 3796; mul 113 3799; add 3798 3800; mul 102 3799; mul 1357 3802; add 3801 3803; mul 385
3654; mul 34 3805; mul 113 3806; add 3804 3807; mul 102 3806; mul 1357 3809; add 3808 3810; mul 381 3654; mul 34
3812; mul 34 3813; mul 1357 3814; add 3811 3815; mul 378 3654; mul 1357 3817; add 3816 3818; mul 331 3654; mul 34
3820; mul 34 3821; mul 34 3822; add 3819 3823; mul 329 3654; mul 34 3825; add 3824 3826; mul 94 3827; add 3716 3828;
mul 947 3829; sub 3586 3830; mul 222 222; mul 222 3832; input p 153; mul 3833 3834; mul 222 3834; mul 3832 3836; add
3835 3837; mul 222 249; mul 222 3836; mul 3839 3840; add 3838 3841; input p 138; mul 222 230; mul 222 3844; mul 3843
3845; add 3842 3846; mul 222 3843; mul 3844 3848; add 3847 3849; mul 222 3848; mul 230 3851; add 3850 3852; input p
139; mul 230 230; mul 222 3855; mul 3854 3856; add 3853 3857; mul 222 3854; mul 3855 3859; add 3858 3860; input p
140; mul 230 3855; mul 3862 3863; add 3861 3864; mul 222 248; mul 222 3866; mul 223 3867; add 3865 3868; mul 224
3866; add 3869 3870; mul 225 248; add 3871 3872; mul 230 248; mul 222 3874; mul 231 3875; add 3873 3876; mul 232
3874; add 3877 3878; mul 230 3874; mul 236 3880; add 3879 3881; mul 222 266; mul 251 3883; add 3882 3884; mul 252
266; add 3885 3886; mul 230 266; mul 256 3888; add 3887 3889; mul 267 281; add 3890 3891; mul 704 3892; neg 3893;
where 1115 3894; input p 144; mul 34 3896; input p 145; mul 161 3898; add 3897 3899; input p 146; mul 165 3901; add
3900 3902; mul 102 157; add 3903 3904; mul 105 1374; add 3905 3906; mul 109 1369; add 3907 3908; mul 113 1365; add
3909 3910; mul 117 174; add 3911 3912; mul 121 1353; add 3913 3914; mul 104 136; add 3915 3916; mul 140 969; add
3917 3918; mul 116 144; add 3919 3920; mul 148 961; add 3921 3922; mul 131 205; add 3923 3924; mul 149 204; add 3925
3926; mul 100 212; add 3927 3928; mul 704 3929; sub 3895 3930; mul 222 3851; mul 230 249; mul 222 3859; mul 3933
3934; add 3932 3935; mul 222 3862; mul 3855 3937; add 3936 3938; mul 230 3937; mul 3933 3940; add 3939 3941; input p
141; mul 3863 3943; add 3942 3944; mul 230 3943; mul 3855 3946; add 3945 3947; mul 230 3946; mul 3933 3949; add 3948
3950; mul 233 248; add 3951 3952; mul 237 3874; add 3953 3954; mul 238 248; add 3955 3956; mul 241 3880; add 3957
3958; mul 242 3874; add 3959 3960; mul 243 248; add 3961 3962; mul 257 266; add 3963 3964; mul 261 3888; add 3965
3966; mul 262 266; add 3967 3968; mul 274 281; add 3969 3970; mul 700 3971; where 1141 3972; add 3931 3973; mul 97
212; mul 700 3975; add 3974 3976; mul 290 708; neg 3978; where 218 3979; add 3977 3980; mul 214 708; sub 3981 3982;
mul 1619 3892; where 1115 3984; mul 1619 3929; add 3985 3986; mul 1610 3971; neg 3988; where 1141 3989; add 3987
3990; mul 1610 3975; sub 3991 3992; mul 290 1622; where 218 3994; add 3993 3995; mul 214 1622; add 3996 3997; mul
2427 3892; neg 3999; where 1115 4000; mul 2427 3929; sub 4001 4002; mul 1619 3971; where 1141 4004; add 4003 4005;
mul 1619 3975; add 4006 4007; mul 290 2431; neg 4009; where 218 4010; add 4008 4011; mul 214 2431; sub 4012 4013;
mul 692 831; constant 0.8; mul 571 704; mul 4016 4017; sub 4015 4018; mul 687 708; sub 4019 4020; constant -2.0; mul
1577 1582; le 1573 1574; le 1574 1573; add 4024 4025; div 1 4026; mul 4024 4027; mul 4023 4028; mul 4022 4029; add
4021 4030; mul 571 1619; mul 4016 4032; mul 692 1726; add 4033 4034; mul 687 1622; add 4035 4036; mul 1577 2406; mul
4028 4038; mul 4022 4039; sub 4037 4040; mul 692 2535; mul 571 2427; mul 4016 4043; sub 4042 4044; mul 687 2431; sub
4045 4046; mul 1577 3224; mul 4028 4048; mul 4022 4049; add 4047 4050; constant -2.5714285714285743; mul 153 1275;
mul 4052 4053; constant -0.8571428571428583; mul 149 953; mul 4055 4056; constant 0.9142857142857138; mul 205 953;
mul 4058 4059; add 4057 4060; constant 0.05714285714285722; mul 144 953; mul 4062 4063; add 4061 4064; constant
-0.11428571428571327; mul 140 953; mul 4066 4067; add 4065 4068; constant 0.2190476190476189; mul 121 953; mul 4070
4071; add 4069 4072; constant 0.11428571428571413; mul 117 953; mul 4074 4075; add 4073 4076; constant
-0.05714285714285729; mul 109 953; mul 4078 4079; add 4077 4080; input p 214; mul 102 953; mul 329 4083; mul 4082
4084; add 4081 4085; constant 0.007256235827664418; mul 165 953; mul 4087 4088; add 4086 4089; mul 34 953; mul 546
4091; mul 4082 4092; add 4090 4093; sub 4054 4094; constant 2.057142857142858; mul 149 1275; mul 4096 4097; add 4095
4098; mul 205 1275; mul 4055 4100; add 4099 4101; constant -3.428571428571427; mul 144 1275; mul 4103 4104; add 4102
4105; constant 0.11428571428571443; mul 140 1275; mul 4107 4108; add 4106 4109; constant -0.057142857142856635; mul
132 1275; mul 4111 4112; add 4110 4113; mul 95 1275; mul 303 4115; mul 4082 4116; add 4114 4117; constant
2.438095238095238; mul 121 1275; mul 4119 4120; add 4118 4121; constant 0.6571428571428567; mul 117 1275; mul 4123
4124; add 4122 4125; input p 215; mul 113 1275; mul 4127 4128; sub 4126 4129; mul 109 1275; mul 4074 4131; add 4130
4132; mul 102 1275; mul 334 4134; mul 4082 4135; add 4133 4136; constant -0.019047619047619094; mul 165 1275; mul
4138 4139; add 4137 4140; mul 34 1275; mul 329 4142; mul 4082 4143; add 4141 4144; constant 12.34285714285715; mul
153 1188; mul 4146 4147; sub 4145 4148; constant -7.714285714285722; mul 149 1188; mul 4150 4151; sub 4149 4152; mul
144 1188; mul 4096 4154; sub 4153 4155; constant -1.7142857142857166; mul 140 1188; mul 4157 4158; sub 4156 4159;
mul 132 1188; mul 4058 4161; sub 4160 4162; mul 95 1188; mul 311 4164; mul 4082 4165; sub 4163 4166; constant
-1.1428571428571423; mul 121 1188; mul 4168 4169; sub 4167 4170; mul 117 1188; mul 4062 4172; sub 4171 4173; mul 109
1188; mul 4111 4175; sub 4174 4176; mul 102 1188; mul 303 4178; mul 4082 4179; sub 4177 4180; mul 149 1824; mul 4055
4182; mul 205 1824; mul 4058 4184; add 4183 4185; mul 144 1824; mul 4062 4187; add 4186 4188; mul 140 1824; mul 4066
4190; add 4189 4191; mul 121 1824; mul 4070 4193; add 4192 4194; mul 117 1824; mul 4074 4196; add 4195 4197; mul 109
1824; mul 4078 4199; add 4198 4200; mul 102 1824; mul 329 4202; mul 4082 4203; add 4201 4204; mul 165 1824; mul 4087
4206; add 4205 4207; mul 34 1824; mul 546 4209; mul 4082 4210; add 4208 4211; mul 153 2125; mul 4052 4213; add 4212
4214; mul 149 2125; mul 4096 4216; add 4215 4217; mul 205 2125; mul 4055 4219; add 4218 4220; mul 144 2125; mul 4103
4222; add 4221 4223; mul 140 2125; mul 4107 4225; add 4224 4226; mul 132 2125; mul 4111 4228; add 4227 4229; mul 95
2125; mul 303 4231; mul 4082 4232; add 4230 4233; mul 121 2125; mul 4119 4235; add 4234 4236; mul 117 2125; mul 4123
4238; add 4237 4239; mul 113 2125; mul 4127 4241; sub 4240 4242; mul 109 2125; mul 4074 4244; add 4243 4245; mul 102
2125; mul 334 4247; mul 4082 4248; add 4246 4249; mul 165 2125; mul 4138 4251; add 4250 4252; mul 34 2125; mul 329
4254; mul 4082 4255; add 4253 4256; mul 153 2052; mul 4146 4258; add 4257 4259; mul 149 2052; mul 4150 4261; add
4260 4262; mul 144 2052; mul 4096 4264; add 4263 4265; mul 140 2052; mul 4157 4267; add 4266 4268; mul 132 2052; mul
4058 4270; add 4269 4271; mul 95 2052; mul 311 4273; mul 4082 4274; add 4272 4275; mul 121 2052; mul 4168 4277; add
4276 4278; mul 117 2052; mul 4062 4280; add 4279 4281; mul 109 2052; mul 4111 4283; add 4282 4284; mul 102 2052; mul
303 4286; mul 4082 4287; add 4285 4288; mul 153 2943; mul 4052 4290; mul 149 2638; mul 4055 4292; mul 205 2638; mul
4058 4294; add 4293 4295; mul 144 2638; mul 4062 4297; add 4296 4298; mul 140 2638; mul 4066 4300; add 4299 4301;
mul 121 2638; mul 4070 4303; add 4302 4304; mul 117 2638; mul 4074 4306; add 4305 4307; mul 109 2638; mul 4078 4309;
add 4308 4310; mul 102 2638; mul 329 4312; mul 4082 4313; add 4311 4314; mul 165 2638; mul 4087 4316; add 4315 4317;
mul 34 2638; mul 546 4319; mul 4082 4320; add 4318 4321; sub 4291 4322; mul 149 2943; mul 4096 4324; add 4323 4325;
mul 205 2943; mul 4055 4327; add 4326 4328; mul 144 2943; mul 4103 4330; add 4329 4331; mul 140 2943; mul 4107 4333;
add 4332 4334; mul 132 2943; mul 4111 4336; add 4335 4337; mul 95 2943; mul 303 4339; mul 4082 4340; add 4338 4341;
mul 121 2943; mul 4119 4343; add 4342 4344; mul 117 2943; mul 4123 4346; add 4345 4347; mul 113 2943; mul 4127 4349;
sub 4348 4350; mul 109 2943; mul 4074 4352; add 4351 4353; mul 102 2943; mul 334 4355; mul 4082 4356; add 4354 4357;
mul 165 2943; mul 4138 4359; add 4358 4360; mul 34 2943; mul 329 4362; mul 4082 4363; add 4361 4364; mul 153 2856;
mul 4146 4366; sub 4365 4367; mul 149 2856; mul 4150 4369; sub 4368 4370; mul 144 2856; mul 4096 4372; sub 4371
4373; mul 140 2856; mul 4157 4375; sub 4374 4376; mul 132 2856; mul 4058 4378; sub 4377 4379; mul 95 2856; mul 311
4381; mul 4082 4382; sub 4380 4383; mul 121 2856; mul 4168 4385; sub 4384 4386; mul 117 2856; mul 4062 4388; sub
4387 4389; mul 109 2856; mul 4111 4391; sub 4390 4392; mul 102 2856; mul 303 4394; mul 4082 4395; sub 4393 4396;
constant -129.60000000000008; mul 4053 4398; constant 28.799999999999958; mul 4056 4400; constant 45.25714285714287;
mul 4059 4402; add 4401 4403; constant -28.800000000000004; mul 148 953; mul 4405 4406; mul 4127 4407; add 4404
4408; constant -28.799999999999976; mul 4063 4410; add 4409 4411; constant -45.25714285714286; mul 4067 4413; add
4412 4414; constant 28.79999999999999; mul 136 953; mul 4416 4417; mul 4127 4418; add 4415 4419; constant
7.199999999999994; mul 4071 4421; add 4420 4422; constant 13.714285714285717; mul 4075 4424; add 4423 4425; constant
-7.199999999999996; mul 113 953; mul 4427 4428; mul 4127 4429; add 4426 4430; constant 1.3714285714285692; mul 4079
4432; add 4431 4433; constant -4.799999999999999; mul 105 953; mul 4435 4436; mul 4127 4437; add 4434 4438; constant
1.3714285714285714; mul 4088 4440; add 4439 4441; constant -1.3714285714285723; mul 161 953; mul 4443 4444; mul 4127
4445; add 4442 4446; constant 2.400000000000001; mul 4091 4448; mul 4082 4449; add 4447 4450; sub 4399 4451;
constant 230.40000000000006; mul 4097 4453; add 4452 4454; mul 4100 4400; add 4455 4456; constant
-36.00000000000001; mul 148 1275; mul 4458 4459; mul 4127 4460; add 4457 4461; constant -151.20000000000002; mul
4104 4463; add 4462 4464; constant -57.59999999999995; mul 4108 4466; add 4465 4467; constant 72.0; mul 136 1275;
mul 4469 4470; mul 4127 4471; add 4468 4472; constant -22.62857142857143; mul 4112 4474; add 4473 4475; mul 128
1275; mul 4416 4477; mul 4127 4478; add 4476 4479; constant -18.000000000000004; mul 4115 4481; mul 4082 4482; add
4480 4483; constant 35.20000000000001; mul 4120 4485; add 4484 4486; constant 21.59999999999998; mul 4124 4488; add
4487 4489; constant -30.000000000000007; mul 4128 4491; mul 4127 4492; add 4490 4493; mul 4131 4424; add 4494 4495;
constant -14.399999999999991; mul 105 1275; mul 4497 4498; mul 4127 4499; add 4496 4500; mul 678 4134; mul 4082
4502; add 4501 4503; constant 0.4571428571428564; mul 4139 4505; add 4504 4506; constant -2.3999999999999995; mul
161 1275; mul 4508 4509; mul 4127 4510; add 4507 4511; input p 216; constant -0.9999999999999998; mul 1275 4514; mul
4513 4515; add 4512 4516; constant 259.2000000000001; mul 4147 4518; sub 4517 4519; constant -388.80000000000024;
mul 4151 4521; sub 4520 4522; mul 4154 4453; sub 4523 4524; constant 57.599999999999916; mul 4158 4526; sub 4525
4527; constant -72.00000000000001; mul 136 1188; mul 4529 4530; mul 4127 4531; sub 4528 4532; mul 4161 4402; sub
4533 4534; constant -57.60000000000001; mul 128 1188; mul 4536 4537; mul 4127 4538; sub 4535 4539; constant
36.000000000000014; mul 4164 4541; mul 4082 4542; sub 4540 4543; constant -50.400000000000006; mul 4169 4545; sub
4544 4546; mul 4172 4410; sub 4547 4548; constant 36.0; mul 113 1188; mul 4550 4551; mul 4127 4552; sub 4549 4553;
mul 4175 4474; sub 4554 4555; mul 105 1188; mul 4416 4557; mul 4127 4558; sub 4556 4559; mul 4178 4481; mul 4082
4561; sub 4560 4562; mul 4182 4400; mul 4184 4402; add 4564 4565; mul 148 1824; mul 4405 4567; mul 4127 4568; add
4566 4569; mul 4187 4410; add 4570 4571; mul 4190 4413; add 4572 4573; mul 136 1824; mul 4416 4575; mul 4127 4576;
add 4574 4577; mul 4193 4421; add 4578 4579; mul 4196 4424; add 4580 4581; mul 113 1824; mul 4427 4583; mul 4127
4584; add 4582 4585; mul 4199 4432; add 4586 4587; mul 105 1824; mul 4435 4589; mul 4127 4590; add 4588 4591; mul
4206 4440; add 4592 4593; mul 161 1824; mul 4443 4595; mul 4127 4596; add 4594 4597; mul 4209 4448; mul 4082 4599;
add 4598 4600; mul 4213 4398; add 4601 4602; mul 4216 4453; add 4603 4604; mul 4219 4400; add 4605 4606; mul 148
2125; mul 4458 4608; mul 4127 4609; add 4607 4610; mul 4222 4463; add 4611 4612; mul 4225 4466; add 4613 4614; mul
136 2125; mul 4469 4616; mul 4127 4617; add 4615 4618; mul 4228 4474; add 4619 4620; mul 128 2125; mul 4416 4622;
mul 4127 4623; add 4621 4624; mul 4231 4481; mul 4082 4626; add 4625 4627; mul 4235 4485; add 4628 4629; mul 4238
4488; add 4630 4631; mul 4241 4491; mul 4127 4633; add 4632 4634; mul 4244 4424; add 4635 4636; mul 105 2125; mul
4497 4638; mul 4127 4639; add 4637 4640; mul 678 4247; mul 4082 4642; add 4641 4643; mul 4251 4505; add 4644 4645;
mul 161 2125; mul 4508 4647; mul 4127 4648; add 4646 4649; mul 2125 4514; mul 4513 4651; add 4650 4652; mul 4258
4518; add 4653 4654; mul 4261 4521; add 4655 4656; mul 4264 4453; add 4657 4658; mul 4267 4526; add 4659 4660; mul
136 2052; mul 4529 4662; mul 4127 4663; add 4661 4664; mul 4270 4402; add 4665 4666; mul 128 2052; mul 4536 4668;
mul 4127 4669; add 4667 4670; mul 4273 4541; mul 4082 4672; add 4671 4673; mul 4277 4545; add 4674 4675; mul 4280
4410; add 4676 4677; mul 113 2052; mul 4550 4679; mul 4127 4680; add 4678 4681; mul 4283 4474; add 4682 4683; mul
105 2052; mul 4416 4685; mul 4127 4686; add 4684 4687; mul 4286 4481; mul 4082 4689; add 4688 4690; mul 4290 4398;
mul 4292 4400; mul 4294 4402; add 4693 4694; mul 148 2638; mul 4405 4696; mul 4127 4697; add 4695 4698; mul 4297
4410; add 4699 4700; mul 4300 4413; add 4701 4702; mul 136 2638; mul 4416 4704; mul 4127 4705; add 4703 4706; mul
4303 4421; add 4707 4708; mul 4306 4424; add 4709 4710; mul 113 2638; mul 4427 4712; mul 4127 4713; add 4711 4714;
mul 4309 4432; add 4715 4716; mul 105 2638; mul 4435 4718; mul 4127 4719; add 4717 4720; mul 4316 4440; add 4721
4722; mul 161 2638; mul 4443 4724; mul 4127 4725; add 4723 4726; mul 4319 4448; mul 4082 4728; add 4727 4729; sub
4692 4730; mul 4324 4453; add 4731 4732; mul 4327 4400; add 4733 4734; mul 148 2943; mul 4458 4736; mul 4127 4737;
add 4735 4738; mul 4330 4463; add 4739 4740; mul 4333 4466; add 4741 4742; mul 136 2943; mul 4469 4744; mul 4127
4745; add 4743 4746; mul 4336 4474; add 4747 4748; mul 128 2943; mul 4416 4750; mul 4127 4751; add 4749 4752; mul
4339 4481; mul 4082 4754; add 4753 4755; mul 4343 4485; add 4756 4757; mul 4346 4488; add 4758 4759; mul 4349 4491;
mul 4127 4761; add 4760 4762; mul 4352 4424; add 4763 4764; mul 105 2943; mul 4497 4766; mul 4127 4767; add 4765
4768; mul 678 4355; mul 4082 4770; add 4769 4771; mul 4359 4505; add 4772 4773; mul 161 2943; mul 4508 4775; mul
4127 4776; add 4774 4777; mul 2943 4514; mul 4513 4779; add 4778 4780; mul 4366 4518; sub 4781 4782; mul 4369 4521;
sub 4783 4784; mul 4372 4453; sub 4785 4786; mul 4375 4526; sub 4787 4788; mul 136 2856; mul 4529 4790; mul 4127
4791; sub 4789 4792; mul 4378 4402; sub 4793 4794; mul 128 2856; mul 4536 4796; mul 4127 4797; sub 4795 4798; mul
4381 4541; mul 4082 4800; sub 4799 4801; mul 4385 4545; sub 4802 4803; mul 4388 4410; sub 4804 4805; mul 113 2856;
mul 4550 4807; mul 4127 4808; sub 4806 4809; mul 4391 4474; sub 4810 4811; mul 105 2856; mul 4416 4813; mul 4127
4814; sub 4812 4815; mul 4394 4481; mul 4082 4817; sub 4816 4818; constant -0.04285714285714284; mul 149 949; mul
4820 4821; constant 0.029931972789115628; mul 205 949; mul 4823 4824; add 4822 4825; constant
-0.0013605442176870806; mul 140 949; mul 4827 4828; add 4826 4829; constant -0.003571428571428574; mul 121 949; mul
4831 4832; add 4830 4833; constant 0.0027210884353741486; mul 117 949; mul 4835 4836; add 4834 4837; constant
-0.0014361300075585765; mul 109 949; mul 4839 4840; add 4838 4841; constant 0.00032473894907757275; mul 165 949; mul
4843 4844; add 4842 4845; constant -0.12857142857142845; mul 153 992; mul 4847 4848; add 4846 4849; constant
0.12857142857142853; mul 149 992; mul 4851 4852; add 4850 4853; mul 205 992; mul 4820 4855; add 4854 4856; constant
0.010714285714285735; mul 144 992; mul 4858 4859; add 4857 4860; constant -0.0006802721088435403; mul 132 992; mul
4862 4863; add 4861 4864; constant 0.028571428571428567; mul 121 992; mul 4866 4867; add 4865 4868; constant
-0.010714285714285721; mul 117 992; mul 4870 4871; add 4869 4872; mul 109 992; mul 4835 4874; add 4873 4875;
constant -0.0004787100025195255; mul 165 992; mul 4877 4878; add 4876 4879; constant 1.0285714285714285; mul 153
990; mul 4881 4882; add 4880 4883; constant -0.38571428571428534; mul 149 990; mul 4885 4886; add 4884 4887; mul 144
990; mul 4851 4889; add 4888 4890; constant -0.08571428571428567; mul 140 990; mul 4892 4893; add 4891 4894; mul 132
990; mul 4823 4896; add 4895 4897; constant 0.0035714285714285787; mul 121 990; mul 4899 4900; add 4898 4901; mul
109 990; mul 4862 4903; add 4902 4904; constant 0.2571428571428571; mul 418 1041; mul 4906 4907; add 4905 4908; mul
414 1041; mul 4847 4910; add 4909 4911; constant 0.06428571428571427; mul 411 1041; mul 4913 4914; add 4912 4915;
mul 407 1041; mul 4820 4917; add 4916 4918; constant 0.014965986394557814; mul 404 1041; mul 4920 4921; add 4919
4922; mul 398 1041; mul 4899 4924; add 4923 4925; mul 395 1041; mul 4862 4927; add 4926 4928; constant
0.007142857142857142; mul 390 1041; mul 4930 4931; add 4929 4932; mul 386 1041; mul 4831 4934; add 4933 4935;
constant 0.0013605442176870743; mul 382 1041; mul 4937 4938; add 4936 4939; mul 375 1041; mul 4877 4941; add 4940
4942; constant 8.118473726939319e-05; mul 370 1041; mul 4944 4945; add 4943 4946; mul 153 1865; mul 4847 4948; mul
149 1846; mul 4820 4950; mul 205 1846; mul 4823 4952; add 4951 4953; mul 140 1846; mul 4827 4955; add 4954 4956; mul
121 1846; mul 4831 4958; add 4957 4959; mul 117 1846; mul 4835 4961; add 4960 4962; mul 109 1846; mul 4839 4964; add
4963 4965; mul 165 1846; mul 4843 4967; add 4966 4968; sub 4949 4969; mul 149 1865; mul 4851 4971; add 4970 4972;
mul 205 1865; mul 4820 4974; add 4973 4975; mul 144 1865; mul 4858 4977; add 4976 4978; mul 132 1865; mul 4862 4980;
add 4979 4981; mul 121 1865; mul 4866 4983; add 4982 4984; mul 117 1865; mul 4870 4986; add 4985 4987; mul 109 1865;
mul 4835 4989; add 4988 4990; mul 165 1865; mul 4877 4992; add 4991 4993; mul 153 1863; mul 4881 4995; sub 4994
4996; mul 149 1863; mul 4885 4998; sub 4997 4999; mul 144 1863; mul 4851 5001; sub 5000 5002; mul 140 1863; mul 4892
5004; sub 5003 5005; mul 132 1863; mul 4823 5007; sub 5006 5008; mul 121 1863; mul 4899 5010; sub 5009 5011; mul 109
1863; mul 4862 5013; sub 5012 5014; mul 418 1914; mul 4906 5016; add 5015 5017; mul 414 1914; mul 4847 5019; add
5018 5020; mul 411 1914; mul 4913 5022; add 5021 5023; mul 407 1914; mul 4820 5025; add 5024 5026; mul 404 1914; mul
4920 5028; add 5027 5029; mul 398 1914; mul 4899 5031; add 5030 5032; mul 395 1914; mul 4862 5034; add 5033 5035;
mul 390 1914; mul 4930 5037; add 5036 5038; mul 386 1914; mul 4831 5040; add 5039 5041; mul 382 1914; mul 4937 5043;
add 5042 5044; mul 375 1914; mul 4877 5046; add 5045 5047; mul 370 1914; mul 4944 5049; add 5048 5050; mul 149 2634;
mul 4820 5052; mul 205 2634; mul 4823 5054; add 5053 5055; mul 140 2634; mul 4827 5057; add 5056 5058; mul 121 2634;
mul 4831 5060; add 5059 5061; mul 117 2634; mul 4835 5063; add 5062 5064; mul 109 2634; mul 4839 5066; add 5065
5067; mul 165 2634; mul 4843 5069; add 5068 5070; mul 153 2675; mul 4847 5072; add 5071 5073; mul 149 2675; mul 4851
5075; add 5074 5076; mul 205 2675; mul 4820 5078; add 5077 5079; mul 144 2675; mul 4858 5081; add 5080 5082; mul 132
2675; mul 4862 5084; add 5083 5085; mul 121 2675; mul 4866 5087; add 5086 5088; mul 117 2675; mul 4870 5090; add
5089 5091; mul 109 2675; mul 4835 5093; add 5092 5094; mul 165 2675; mul 4877 5096; add 5095 5097; mul 153 2673; mul
4881 5099; add 5098 5100; mul 149 2673; mul 4885 5102; add 5101 5103; mul 144 2673; mul 4851 5105; add 5104 5106;
mul 140 2673; mul 4892 5108; add 5107 5109; mul 132 2673; mul 4823 5111; add 5110 5112; mul 121 2673; mul 4899 5114;
add 5113 5115; mul 109 2673; mul 4862 5117; add 5116 5118; mul 418 2724; mul 4906 5120; add 5119 5121; mul 414 2724;
mul 4847 5123; add 5122 5124; mul 411 2724; mul 4913 5126; add 5125 5127; mul 407 2724; mul 4820 5129; add 5128
5130; mul 404 2724; mul 4920 5132; add 5131 5133; mul 398 2724; mul 4899 5135; add 5134 5136; mul 395 2724; mul 4862
5138; add 5137 5139; mul 390 2724; mul 4930 5141; add 5140 5142; mul 386 2724; mul 4831 5144; add 5143 5145; mul 382
2724; mul 4937 5147; add 5146 5148; mul 375 2724; mul 4877 5150; add 5149 5151; mul 370 2724; mul 4944 5153; add
5152 5154; mul 149 3290; mul 4820 5156; mul 205 3290; mul 4823 5158; add 5157 5159; mul 140 3290; mul 4827 5161; add
5160 5162; mul 121 3290; mul 4831 5164; add 5163 5165; mul 117 3290; mul 4835 5167; add 5166 5168; mul 109 3290; mul
4839 5170; add 5169 5171; mul 165 3290; mul 4843 5173; add 5172 5174; mul 153 3308; mul 4847 5176; add 5175 5177;
mul 149 3308; mul 4851 5179; add 5178 5180; mul 205 3308; mul 4820 5182; add 5181 5183; mul 144 3308; mul 4858 5185;
add 5184 5186; mul 132 3308; mul 4862 5188; add 5187 5189; mul 121 3308; mul 4866 5191; add 5190 5192; mul 117 3308;
mul 4870 5194; add 5193 5195; mul 109 3308; mul 4835 5197; add 5196 5198; mul 165 3308; mul 4877 5200; add 5199
5201; mul 153 3306; mul 4881 5203; add 5202 5204; mul 149 3306; mul 4885 5206; add 5205 5207; mul 144 3306; mul 4851
5209; add 5208 5210; mul 140 3306; mul 4892 5212; add 5211 5213; mul 132 3306; mul 4823 5215; add 5214 5216; mul 121
3306; mul 4899 5218; add 5217 5219; mul 109 3306; mul 4862 5221; add 5220 5222; mul 418 3357; mul 4906 5224; add
5223 5225; mul 414 3357; mul 4847 5227; add 5226 5228; mul 411 3357; mul 4913 5230; add 5229 5231; mul 407 3357; mul
4820 5233; add 5232 5234; mul 404 3357; mul 4920 5236; add 5235 5237; mul 398 3357; mul 4899 5239; add 5238 5240;
mul 395 3357; mul 4862 5242; add 5241 5243; mul 390 3357; mul 4930 5245; add 5244 5246; mul 386 3357; mul 4831 5248;
add 5247 5249; mul 382 3357; mul 4937 5251; add 5250 5252; mul 375 3357; mul 4877 5254; add 5253 5255; mul 370 3357;
mul 4944 5257; add 5256 5258; mul 149 3587; mul 4820 5260; mul 205 3587; mul 4823 5262; add 5261 5263; mul 140 3587;
mul 4827 5265; add 5264 5266; mul 121 3587; mul 4831 5268; add 5267 5269; mul 117 3587; mul 4835 5271; add 5270
5272; mul 109 3587; mul 4839 5274; add 5273 5275; mul 165 3587; mul 4843 5277; add 5276 5278; mul 153 3605; mul 4847
5280; add 5279 5281; mul 149 3605; mul 4851 5283; add 5282 5284; mul 205 3605; mul 4820 5286; add 5285 5287; mul 144
3605; mul 4858 5289; add 5288 5290; mul 132 3605; mul 4862 5292; add 5291 5293; mul 121 3605; mul 4866 5295; add
5294 5296; mul 117 3605; mul 4870 5298; add 5297 5299; mul 109 3605; mul 4835 5301; add 5300 5302; mul 165 3605; mul
4877 5304; add 5303 5305; mul 153 3603; mul 4881 5307; add 5306 5308; mul 149 3603; mul 4885 5310; add 5309 5311;
mul 144 3603; mul 4851 5313; add 5312 5314; mul 140 3603; mul 4892 5316; add 5315 5317; mul 132 3603; mul 4823 5319;
add 5318 5320; mul 121 3603; mul 4899 5322; add 5321 5323; mul 109 3603; mul 4862 5325; add 5324 5326; mul 418 3654;
mul 4906 5328; add 5327 5329; mul 414 3654; mul 4847 5331; add 5330 5332; mul 411 3654; mul 4913 5334; add 5333
5335; mul 407 3654; mul 4820 5337; add 5336 5338; mul 404 3654; mul 4920 5340; add 5339 5341; mul 398 3654; mul 4899
5343; add 5342 5344; mul 395 3654; mul 4862 5346; add 5345 5347; mul 390 3654; mul 4930 5349; add 5348 5350; mul 386
3654; mul 4831 5352; add 5351 5353; mul 382 3654; mul 4937 5355; add 5354 5356; mul 375 3654; mul 4877 5358; add
5357 5359; mul 370 3654; mul 4944 5361; add 5360 5362; input p 217; mul 4460 5364; mul 4407 5364; mul 4418 5364; add
5366 5367; mul 4429 5364; add 5368 5369; mul 4437 5364; add 5370 5371; input p 218; input p 219; mul 4084 5374; mul
5373 5375; add 5372 5376; mul 4445 5364; add 5377 5378; mul 4092 5374; mul 5373 5380; add 5379 5381; mul 4449 5364;
mul 5373 5383; add 5382 5384; sub 5365 5385; mul 4471 5364; add 5386 5387; mul 4478 5364; add 5388 5389; mul 4116
5374; mul 5373 5391; add 5390 5392; mul 4482 5364; mul 5373 5394; add 5393 5395; mul 4128 5374; sub 5396 5397; mul
4492 5364; add 5398 5399; mul 4499 5364; add 5400 5401; mul 4135 5374; mul 5373 5403; add 5402 5404; mul 4502 5364;
mul 5373 5406; add 5405 5407; mul 4510 5364; add 5408 5409; mul 4143 5374; mul 5373 5411; add 5410 5412; mul 4515
5364; mul 4082 5414; add 5413 5415; mul 4127 5414; mul 5373 5417; add 5416 5418; add 4515 5419; mul 4531 5364; sub
5420 5421; mul 4538 5364; sub 5422 5423; mul 4165 5374; mul 5373 5425; sub 5424 5426; mul 4542 5364; mul 5373 5428;
sub 5427 5429; mul 4552 5364; sub 5430 5431; mul 4558 5364; sub 5432 5433; mul 4179 5374; mul 5373 5435; sub 5434
5436; mul 4561 5364; mul 5373 5438; sub 5437 5439; mul 4568 5364; mul 4576 5364; add 5441 5442; mul 4584 5364; add
5443 5444; mul 4590 5364; add 5445 5446; mul 4203 5374; mul 5373 5448; add 5447 5449; mul 4596 5364; add 5450 5451;
mul 4210 5374; mul 5373 5453; add 5452 5454; mul 4599 5364; mul 5373 5456; add 5455 5457; mul 4609 5364; add 5458
5459; mul 4617 5364; add 5460 5461; mul 4623 5364; add 5462 5463; mul 4232 5374; mul 5373 5465; add 5464 5466; mul
4626 5364; mul 5373 5468; add 5467 5469; mul 4241 5374; sub 5470 5471; mul 4633 5364; add 5472 5473; mul 4639 5364;
add 5474 5475; mul 4248 5374; mul 5373 5477; add 5476 5478; mul 4642 5364; mul 5373 5480; add 5479 5481; mul 4648
5364; add 5482 5483; mul 4255 5374; mul 5373 5485; add 5484 5486; mul 4651 5364; mul 4082 5488; add 5487 5489; mul
4127 5488; mul 5373 5491; add 5490 5492; add 4651 5493; mul 4663 5364; add 5494 5495; mul 4669 5364; add 5496 5497;
mul 4274 5374; mul 5373 5499; add 5498 5500; mul 4672 5364; mul 5373 5502; add 5501 5503; mul 4680 5364; add 5504
5505; mul 4686 5364; add 5506 5507; mul 4287 5374; mul 5373 5509; add 5508 5510; mul 4689 5364; mul 5373 5512; add
5511 5513; mul 4737 5364; mul 4697 5364; mul 4705 5364; add 5516 5517; mul 4713 5364; add 5518 5519; mul 4719 5364;
add 5520 5521; mul 4313 5374; mul 5373 5523; add 5522 5524; mul 4725 5364; add 5525 5526; mul 4320 5374; mul 5373
5528; add 5527 5529; mul 4728 5364; mul 5373 5531; add 5530 5532; sub 5515 5533; mul 4745 5364; add 5534 5535; mul
4751 5364; add 5536 5537; mul 4340 5374; mul 5373 5539; add 5538 5540; mul 4754 5364; mul 5373 5542; add 5541 5543;
mul 4349 5374; sub 5544 5545; mul 4761 5364; add 5546 5547; mul 4767 5364; add 5548 5549; mul 4356 5374; mul 5373
5551; add 5550 5552; mul 4770 5364; mul 5373 5554; add 5553 5555; mul 4776 5364; add 5556 5557; mul 4363 5374; mul
5373 5559; add 5558 5560; mul 4779 5364; mul 4082 5562; add 5561 5563; mul 4127 5562; mul 5373 5565; add 5564 5566;
add 4779 5567; mul 4791 5364; sub 5568 5569; mul 4797 5364; sub 5570 5571; mul 4382 5374; mul 5373 5573; sub 5572
5574; mul 4800 5364; mul 5373 5576; sub 5575 5577; mul 4808 5364; sub 5578 5579; mul 4814 5364; sub 5580 5581; mul
4395 5374; mul 5373 5583; sub 5582 5584; mul 4817 5364; mul 5373 5586; sub 5585 5587; mul 539 837; mul 693 708; sub
5589 5590; mul 360 990; add 5591 5592; mul 212 1188; sub 5593 5594; mul 95 1554; add 5595 5596; mul 693 1622; mul
539 1732; add 5598 5599; mul 360 1863; sub 5600 5601; mul 212 2052; add 5602 5603; mul 95 2399; add 5604 5605; mul
539 2541; mul 693 2431; sub 5607 5608; mul 360 2673; add 5609 5610; mul 212 2856; sub 5611 5612; mul 95 3217; add
5613 5614; mul 360 3306; mul 95 3530; add 5616 5617; mul 360 3603; mul 95 3827; add 5619 5620; mul 693 700; mul 212
1142; add 5622 5623; mul 526 837; add 5624 5625; mul 360 987; add 5626 5627; mul 2 1554; add 5628 5629; mul 526
1732; mul 693 1610; mul 212 2000; add 5632 5633; sub 5631 5634; mul 360 1859; add 5635 5636; mul 2 2399; add 5637
5638; mul 693 1619; mul 212 1824; add 5640 5641; mul 526 2541; add 5642 5643; mul 360 2670; add 5644 5645; mul 2
3217; add 5646 5647; mul 360 3303; mul 2 3530; add 5649 5650; mul 360 3600; mul 2 3827; add 5652 5653; mul 571 837;
mul 693 704; mul 212 953; add 5656 5657; sub 5655 5658; mul 360 949; add 5659 5660; mul 34 1554; add 5661 5662; mul
571 1732; add 5642 5664; mul 360 1846; sub 5665 5666; mul 34 2399; add 5667 5668; mul 571 2541; mul 693 2427; mul
212 2638; add 5671 5672; sub 5670 5673; mul 360 2634; add 5674 5675; mul 34 3217; add 5676 5677; mul 360 3290; mul
34 3530; add 5679 5680; mul 360 3587; mul 34 3827; add 5682 5683; mul 95 1054; mul 95 1927; mul 95 2737; mul 95
3370; mul 95 3667; mul 95 1048; mul 2 1054; add 5690 5691; mul 95 1921; mul 2 1927; add 5693 5694; mul 95 2731; mul
2 2737; add 5696 5697; mul 95 3364; mul 2 3370; add 5699 5700; mul 95 3661; mul 2 3667; add 5702 5703; mul 2 1048;
mul 2 1921; mul 2 2731; mul 2 3364; mul 2 3661; mul 95 1044; mul 34 1054; add 5710 5711; mul 95 1917; mul 34 1927;
add 5713 5714; mul 95 2727; mul 34 2737; add 5716 5717; mul 95 3360; mul 34 3370; add 5719 5720; mul 95 3657; mul 34
3667; add 5722 5723; mul 2 1044; mul 34 1048; add 5725 5726; mul 2 1917; mul 34 1921; add 5728 5729; mul 2 2727; mul
34 2731; add 5731 5732; mul 2 3360; mul 34 3364; add 5734 5735; mul 2 3657; mul 34 3661; add 5737 5738; mul 34 1044;
mul 34 1917; mul 34 2727; mul 34 3360; mul 34 3657; mul 2 2; sub 6 5745; div 1 5746; mul 2 16; mul 526 526; mul 21
90; mul 21 700; mul 25 5751; sub 5750 5752; mul 5749 5753; mul 22 5754; mul 23 5755; mul 700 5749; mul 18 5757; sub
5756 5758; mul 41 5751; mul 21 704; mul 53 5761; sub 5760 5762; mul 67 5750; sub 5763 5764; mul 5749 5765; mul 22
5766; mul 38 5767; sub 5759 5768; mul 5748 5769; mul 5747 5770; mul 9 5747; mul 5747 5772; mul 5770 5773; div 1 6;
input p 137; mul 5775 5776; mul 5775 5777; mul 5770 5778; add 5774 5779; mul 2 5780; mul 2 5781; sub 5771 5782; mul
5770 5775; mul 249 5784; add 5783 5785; mul 8 8; mul 662 720; input p 142; mul 38 5789; mul 700 5790; sub 5788 5791;
mul 532 857; add 5792 5793; mul 15 5794; mul 5787 5795; mul 15 16; mul 5794 5797; mul 15 38; mul 593 722; mul 584
5800; mul 16 700; mul 5789 5802; mul 586 722; mul 581 5804; add 5803 5805; sub 5801 5806; mul 584 805; add 5807
5808; mul 602 781; mul 657 722; add 5810 5811; mul 249 593; mul 803 5813; add 5812 5814; mul 581 5815; add 5809
5816; mul 449 859; mul 444 5818; sub 5817 5819; mul 456 859; mul 447 5821; sub 5820 5822; mul 447 942; sub 5823
5824; mul 465 918; mul 527 859; add 5826 5827; mul 249 456; mul 940 5829; add 5828 5830; mul 444 5831; add 5825
5832; mul 5799 5833; add 5798 5834; mul 15 23; mul 584 5804; mul 581 5800; add 5837 5838; mul 581 805; add 5839
5840; mul 584 5815; sub 5841 5842; mul 447 5818; sub 5843 5844; mul 444 5821; add 5845 5846; mul 444 942; add 5847
5848; mul 447 5831; add 5849 5850; mul 5836 5851; add 5835 5852; mul 13 5853; add 5796 5854; mul 7 249; div 1 5856;
mul 5855 5857; mul 2 5858; mul 2 5859; sub 5786 5860; mul 15 5851; mul 15 5833; mul 2 5863; mul 7 5853; sub 5864
5865; mul 13 249; div 1 5867; mul 5866 5868; add 5862 5869; mul 2 5870; mul 2 5871; add 5861 5872; add 5772 5777;
mul 5748 5874; mul 5755 5875; mul 16 5767; mul 16 5877; add 5876 5878; mul 92 3929; mul 92 3892; where 1115 5881;
add 5880 5882; mul 570 674; sub 5883 5884; input p 154; mul 571 5886; mul 100 693; add 5887 5888; add 5885 5889; mul
62 535; mul 27 526; add 5891 5892; mul 47 571; add 5893 5894; mul 535 5895; mul 27 535; mul 30 526; add 5897 5898;
mul 33 571; add 5899 5900; mul 526 5901; add 5896 5902; mul 47 535; mul 33 526; add 5904 5905; mul 51 571; add 5906
5907; mul 571 5908; add 5903 5909; mul 16 23; mul 16 5911; mul 38 5875; sub 5912 5913; mul 22 5914; mul 5749 5915;
add 5910 5916; mul 53 5917; mul 21 5918; add 5890 5919; mul 89 704; mul 5920 5921; mul 92 3975; mul 92 3971; where
1141 5924; add 5923 5925; mul 543 674; sub 5926 5927; mul 97 693; add 5928 5929; mul 533 577; mul 663 671; add 5931
5932; add 5930 5933; sub 1579 5934; mul 16 5790; add 5935 5936; input p 128; input z 0; mul 5938 5939; input p 129;
input z 1; mul 5941 5942; add 5940 5943; input p 130; input z 2; mul 5945 5946; add 5944 5947; input p 131; input z
3; mul 5949 5950; add 5948 5951; input p 143; mul 5952 5953; sub 5937 5954; mul 41 5917; mul 23 5875; mul 16 38; mul
16 5958; add 5957 5959; mul 22 5960; mul 5749 5961; mul 25 5962; sub 5956 5963; mul 21 5964; mul 18 5875; mul 5749
5966; sub 5965 5967; sub 5955 5968; mul 89 700; mul 5969 5970; add 5922 5971; input c 0; input c 2; mul 486 5974;
add 5973 5975; input c 3; mul 620 5977; add 5976 5978; mul 1563 1597; add 5979 5980; mul 1561 1579; sub 5981 5982;
input p 16; input c 1; add 5984 5985; constant 0.0; max 5986 5987; mul 535 5988; sub 5983 5989; mul 536 577; mul 665
671; add 5991 5992; sub 697 5993; sub 5990 5994; input p 127; sub 5996 5952; input p 132; abs 535; mul 5998 5999;
mul 535 6000; input p 133; mul 535 6002; mul 535 535; input p 134; add 6004 6005; sqrt 6006; div 1 6007; mul 6003
6008; add 6001 6009; sub 5997 6010; add 5995 6011; input p 135; input x 12; sub 28 6014; mul 6013 6015; input p 136;
input x 13; sub 28 6018; mul 6017 6019; add 6016 6020; sub 6012 6021; mul 67 5917; sub 6023 5962; mul 21 6024; sub
6022 6025; mul 89 90; mul 6026 6027; sub 5972 6028; mul 79 6029; mul 59 6030; mul 76 6029; mul 56 6032; sub 6031
6033; mul 21 6034; mul 5751 5962; sub 6035 6036; mul 89 5920; mul 59 6038; mul 89 5969; mul 56 6040; add 6039 6041;
mul 81 6029; add 6042 6043; mul 21 6044; sub 6037 6045; mul 25 249; mul 79 6038; mul 79 6030; sub 6048 6049; mul 70
6029; mul 56 6051; add 6050 6052; mul 89 6026; mul 56 6054; add 6053 6055; mul 21 6056; mul 6047 6057; add 6046
6058; mul 16 6059; mul 22 6060; add 5879 6061; mul 15 6062; mul 16 5755; mul 16 6064; mul 5767 5875; sub 6065 6066;
mul 5751 5917; mul 67 6035; add 6068 6069; mul 67 6045; sub 6070 6071; mul 79 6040; mul 76 6030; add 6073 6074; mul
59 6051; sub 6075 6076; mul 59 6054; sub 6077 6078; mul 21 6079; mul 53 6080; add 6072 6081; mul 79 6032; mul 76
6038; sub 6083 6084; sub 6085 6076; sub 6086 6078; mul 21 6087; mul 53 6088; add 6082 6089; mul 41 249; mul 6057
6091; add 6090 6092; mul 16 6093; mul 22 6094; add 6067 6095; mul 15 6096; mul 2 6097; mul 5799 6096; mul 5836 6062;
add 6099 6100; mul 5755 5958; mul 5757 5875; mul 17 6103; sub 6102 6104; mul 38 6064; add 6105 6106; mul 5769 5874;
mul 2 6108; add 6107 6109; mul 5767 5911; add 6110 6111; mul 23 5877; add 6112 6113; mul 39 6093; add 6114 6115; mul
24 6059; add 6116 6117; mul 18 6056; add 6118 6119; mul 16 6056; mul 17 6121; add 6120 6122; mul 5797 6123; add 6101
6124; mul 7 6125; sub 6098 6126; mul 5868 6127; add 6063 6128; mul 2 6129; mul 2 6130; add 5873 6131; mul 13 6125;
mul 15 6123; mul 5787 6134; add 6133 6135; mul 5857 6136; mul 2 6137; mul 2 6138; sub 6132 6139; mul 1610 5749; mul
18 6141; mul 21 1610; mul 25 6143; sub 6144 5751; mul 5749 6145; mul 22 6146; mul 23 6147; add 6142 6148; mul 21
1619; mul 53 6150; mul 41 6143; sub 6151 6152; mul 67 5751; add 6153 6154; mul 5749 6155; mul 22 6156; mul 38 6157;
sub 6149 6158; mul 5748 6159; mul 5747 6160; mul 5773 6160; mul 5778 6160; add 6162 6163; mul 2 6164; mul 2 6165;
sub 6161 6166; mul 5775 6160; mul 249 6168; add 6167 6169; mul 1610 5790; mul 662 1687; sub 6171 6172; mul 532 1748;
sub 6173 6174; mul 15 6175; mul 5787 6176; mul 5797 6175; mul 16 1610; mul 5789 6179; mul 586 1711; mul 581 6181;
add 6180 6182; mul 593 1711; mul 584 6184; sub 6183 6185; mul 584 1714; add 6186 6187; mul 602 1678; mul 657 1711;
sub 6189 6190; mul 1708 5813; add 6191 6192; mul 581 6193; add 6188 6194; mul 449 1750; mul 444 6196; add 6195 6197;
mul 456 1750; mul 447 6199; add 6198 6200; mul 447 1819; sub 6201 6202; mul 465 1794; mul 527 1750; sub 6204 6205;
mul 1817 5829; add 6206 6207; mul 444 6208; add 6203 6209; mul 5799 6210; add 6178 6211; mul 581 1714; mul 584 6181;
mul 581 6184; add 6214 6215; sub 6213 6216; mul 584 6193; sub 6217 6218; mul 447 6196; add 6219 6220; mul 444 6199;
sub 6221 6222; mul 444 1819; add 6223 6224; mul 447 6208; add 6225 6226; mul 5836 6227; add 6212 6228; mul 13 6229;
add 6177 6230; mul 5857 6231; mul 2 6232; mul 2 6233; sub 6170 6234; mul 15 6227; mul 15 6210; mul 2 6237; mul 7
6229; sub 6238 6239; mul 5868 6240; add 6236 6241; mul 2 6242; mul 2 6243; add 6235 6244; mul 5875 6147; mul 16
6157; mul 16 6247; add 6246 6248; mul 5962 6143; mul 5970 6026; mul 89 1619; mul 5920 6252; sub 6251 6253; mul 89
1610; mul 5969 6255; sub 6254 6256; mul 79 6257; mul 59 6258; add 6048 6055; sub 6259 6260; mul 76 6257; mul 56
6262; sub 6261 6263; mul 21 6264; add 6250 6265; mul 81 6257; mul 21 6267; sub 6266 6268; mul 70 6257; mul 56 6270;
mul 79 6258; sub 6271 6272; mul 21 6273; mul 6047 6274; add 6269 6275; mul 16 6276; mul 22 6277; add 6249 6278; mul
15 6279; mul 16 6147; mul 16 6281; mul 5875 6157; sub 6282 6283; mul 67 6265; mul 5917 6143; sub 6285 6286; mul 67
6268; sub 6287 6288; mul 76 6258; mul 59 6270; sub 6290 6291; mul 21 6292; mul 53 6293; add 6289 6294; mul 70 6038;
mul 79 6054; add 6296 6297; mul 79 6262; add 6298 6299; sub 6300 6291; mul 21 6301; mul 53 6302; add 6295 6303; mul
6091 6274; add 6304 6305; mul 16 6306; mul 22 6307; add 6284 6308; mul 15 6309; mul 2 6310; mul 5799 6309; mul 5836
6279; add 6312 6313; mul 5875 6141; mul 17 6315; mul 5958 6147; add 6316 6317; mul 38 6281; add 6318 6319; mul 5874
6159; mul 2 6321; add 6320 6322; mul 5911 6157; add 6323 6324; mul 23 6247; add 6325 6326; mul 39 6306; add 6327
6328; mul 24 6276; add 6329 6330; mul 18 6273; add 6331 6332; mul 16 6273; mul 17 6334; add 6333 6335; mul 5797
6336; add 6314 6337; mul 7 6338; sub 6311 6339; mul 5868 6340; add 6280 6341; mul 2 6342; mul 2 6343; add 6245 6344;
mul 13 6338; mul 15 6336; mul 5787 6347; add 6346 6348; mul 5857 6349; mul 2 6350; mul 2 6351; sub 6345 6352; mul 25
6150; sub 5761 6354; mul 5749 6355; mul 22 6356; mul 23 6357; mul 1619 5749; mul 18 6359; sub 6358 6360; mul 41
6150; mul 21 2427; mul 53 6363; sub 6362 6364; mul 67 5761; sub 6365 6366; mul 5749 6367; mul 22 6368; mul 38 6369;
sub 6361 6370; mul 5748 6371; mul 5747 6372; mul 5773 6372; mul 5778 6372; add 6374 6375; mul 2 6376; mul 2 6377;
sub 6373 6378; mul 5775 6372; mul 249 6380; add 6379 6381; mul 662 2443; mul 1619 5790; sub 6383 6384; mul 532 2561;
add 6385 6386; mul 15 6387; mul 5787 6388; mul 5797 6387; mul 593 2445; mul 584 6391; mul 16 1619; mul 5789 6393;
mul 586 2445; mul 581 6395; add 6394 6396; sub 6392 6397; mul 584 2511; add 6398 6399; mul 602 2487; mul 657 2445;
add 6401 6402; mul 2509 5813; add 6403 6404; mul 581 6405; add 6400 6406; mul 449 2563; mul 444 6408; sub 6407 6409;
mul 456 2563; mul 447 6411; sub 6410 6412; mul 447 2629; sub 6413 6414; mul 465 2605; mul 527 2563; add 6416 6417;
mul 2627 5829; add 6418 6419; mul 444 6420; add 6415 6421; mul 5799 6422; add 6390 6423; mul 584 6395; mul 581 6391;
add 6425 6426; mul 581 2511; add 6427 6428; mul 584 6405; sub 6429 6430; mul 447 6408; sub 6431 6432; mul 444 6411;
add 6433 6434; mul 444 2629; add 6435 6436; mul 447 6420; add 6437 6438; mul 5836 6439; add 6424 6440; mul 13 6441;
add 6389 6442; mul 5857 6443; mul 2 6444; mul 2 6445; sub 6382 6446; mul 15 6439; mul 15 6422; mul 2 6449; mul 7
6441; sub 6450 6451; mul 5868 6452; add 6448 6453; mul 2 6454; mul 2 6455; add 6447 6456; mul 5875 6357; mul 16
6369; mul 16 6459; add 6458 6460; add 6078 6084; mul 89 2427; mul 5920 6463; mul 5969 6252; add 6464 6465; mul 5921
6026; sub 6466 6467; mul 79 6468; mul 59 6469; add 6462 6470; mul 76 6468; mul 56 6472; sub 6471 6473; mul 21 6474;
mul 5962 6150; sub 6475 6476; add 6073 6084; mul 81 6468; sub 6478 6479; mul 21 6480; add 6477 6481; mul 70 6468;
mul 56 6483; mul 79 6469; add 6298 6485; sub 6484 6486; mul 21 6487; mul 6047 6488; add 6482 6489; mul 16 6490; mul
22 6491; add 6461 6492; mul 15 6493; mul 16 6357; mul 16 6495; mul 5875 6369; sub 6496 6497; mul 5917 6150; mul 67
6475; add 6499 6500; mul 67 6481; add 6501 6502; mul 76 6054; mul 70 6040; sub 6504 6505; mul 76 6469; add 6506
6507; mul 59 6483; sub 6508 6509; mul 21 6510; mul 53 6511; add 6503 6512; mul 79 6472; sub 6514 6509; mul 21 6515;
mul 53 6516; add 6513 6517; mul 6091 6488; add 6518 6519; mul 16 6520; mul 22 6521; add 6498 6522; mul 15 6523; mul
2 6524; mul 5799 6523; mul 5836 6493; add 6526 6527; mul 5958 6357; mul 5875 6359; mul 17 6530; sub 6529 6531; mul
38 6495; add 6532 6533; mul 5874 6371; mul 2 6535; add 6534 6536; mul 5911 6369; add 6537 6538; mul 23 6459; add
6539 6540; mul 39 6520; add 6541 6542; mul 24 6490; add 6543 6544; mul 18 6487; add 6545 6546; mul 16 6487; mul 17
6548; add 6547 6549; mul 5797 6550; add 6528 6551; mul 7 6552; sub 6525 6553; mul 5868 6554; add 6494 6555; mul 2
6556; mul 2 6557; add 6457 6558; mul 13 6552; mul 15 6550; mul 5787 6561; add 6560 6562; mul 5857 6563; mul 2 6564;
mul 2 6565; sub 6559 6566; mul 456 3254; mul 444 6568; mul 449 3254; mul 447 6570; sub 6569 6571; mul 444 3286; add
6572 6573; mul 527 3254; mul 465 3272; sub 6575 6576; mul 3284 5829; add 6577 6578; mul 447 6579; add 6574 6580; mul
15 6581; mul 444 6579; mul 444 6570; mul 447 6568; add 6584 6585; mul 447 3286; add 6586 6587; sub 6583 6588; mul 15
6589; mul 2 6590; mul 532 3252; mul 5797 6592; mul 5799 6589; add 6593 6594; mul 5836 6581; add 6595 6596; mul 7
6597; sub 6591 6598; mul 5868 6599; add 6582 6600; mul 2 6601; mul 2 6602; mul 15 6592; mul 5787 6604; mul 13 6597;
add 6605 6606; mul 5857 6607; mul 2 6608; mul 2 6609; sub 6603 6610; mul 586 3542; mul 584 6612; mul 593 3542; mul
581 6614; add 6613 6615; mul 581 3574; add 6616 6617; mul 657 3542; mul 602 3560; sub 6619 6620; mul 3572 5813; add
6621 6622; mul 584 6623; sub 6618 6624; mul 15 6625; mul 584 6614; mul 581 6612; sub 6627 6628; mul 584 3574; add
6629 6630; mul 581 6623; add 6631 6632; mul 15 6633; mul 2 6634; mul 662 3540; mul 5797 6636; mul 5799 6633; add
6637 6638; mul 5836 6625; add 6639 6640; mul 7 6641; sub 6635 6642; mul 5868 6643; add 6626 6644; mul 2 6645; mul 2
6646; mul 15 6636; mul 5787 6648; mul 13 6641; add 6649 6650; mul 5857 6651; mul 2 6652; mul 2 6653; sub 6647 6654;
mul 248 1201; mul 281 1188; add 6656 6657; neg 6658; where 218 6659; mul 248 2063; mul 281 2052; add 6661 6662;
where 218 6663; mul 248 2869; mul 281 2856; add 6665 6666; neg 6667; where 218 6668; mul 281 1142; where 1141 6670;
mul 230 1201; neg 6672; where 218 6673; add 6671 6674; mul 281 2000; neg 6676; where 1141 6677; mul 230 2063; where
218 6679; add 6678 6680; mul 281 1824; where 1141 6682; mul 230 2869; neg 6684; where 218 6685; add 6683 6686; mul
281 953; neg 6688; where 1115 6689; mul 222 1201; neg 6691; where 218 6692; add 6690 6693; where 1115 6682; mul 222
2063; where 218 6696; add 6695 6697; mul 281 2638; neg 6699; where 1115 6700; mul 222 2869; neg 6702; where 218
6703; add 6701 6704; mul 1142 3888; where 1141 6706; mul 266 1142; where 1141 6708; mul 230 1189; neg 6710; where
218 6711; add 6709 6712; mul 230 6713; add 6707 6714; mul 2000 3888; neg 6716; where 1141 6717; mul 266 2000; neg
6719; where 1141 6720; mul 230 2053; where 218 6722; add 6721 6723; mul 230 6724; add 6718 6725; mul 1824 3888;
where 1141 6727; mul 266 1824; where 1141 6729; mul 230 2857; neg 6731; where 218 6732; add 6730 6733; mul 230 6734;
add 6728 6735; mul 953 3888; neg 6737; where 1115 6738; mul 222 6713; add 6739 6740; where 1115 6727; mul 222 6724;
add 6742 6743; mul 2638 3888; neg 6745; where 1115 6746; mul 222 6734; add 6747 6748; mul 953 3883; neg 6750; where
1115 6751; mul 266 953; neg 6753; where 1115 6754; mul 222 1189; neg 6756; where 218 6757; add 6755 6758; mul 222
6759; add 6752 6760; mul 1824 3883; where 1115 6762; where 1115 6729; mul 222 2053; where 218 6765; add 6764 6766;
mul 222 6767; add 6763 6768; mul 2638 3883; neg 6770; where 1115 6771; mul 266 2638; neg 6773; where 1115 6774; mul
222 2857; neg 6776; where 218 6777; add 6775 6778; mul 222 6779; add 6772 6780; mul 1142 3880; where 1141 6782; mul
1142 3874; where 1141 6784; mul 248 1142; where 1141 6786; mul 230 1188; neg 6788; where 218 6789; add 6787 6790;
mul 230 6791; add 6785 6792; mul 230 6793; add 6783 6794; mul 2000 3880; neg 6796; where 1141 6797; mul 2000 3874;
neg 6799; where 1141 6800; mul 248 2000; neg 6802; where 1141 6803; mul 230 2052; where 218 6805; add 6804 6806; mul
230 6807; add 6801 6808; mul 230 6809; add 6798 6810; mul 1824 3880; where 1141 6812; mul 1824 3874; where 1141
6814; mul 248 1824; where 1141 6816; mul 230 2856; neg 6818; where 218 6819; add 6817 6820; mul 230 6821; add 6815
6822; mul 230 6823; add 6813 6824; mul 953 3880; neg 6826; where 1115 6827; mul 222 6793; add 6828 6829; where 1115
6812; mul 222 6809; add 6831 6832; mul 2638 3880; neg 6834; where 1115 6835; mul 222 6823; add 6836 6837; mul 953
3875; neg 6839; where 1115 6840; mul 953 3874; neg 6842; where 1115 6843; mul 222 6791; add 6844 6845; mul 222 6846;
add 6841 6847; mul 1824 3875; where 1115 6849; where 1115 6814; mul 222 6807; add 6851 6852; mul 222 6853; add 6850
6854; mul 2638 3875; neg 6856; where 1115 6857; mul 2638 3874; neg 6859; where 1115 6860; mul 222 6821; add 6861
6862; mul 222 6863; add 6858 6864; mul 953 3867; neg 6866; where 1115 6867; mul 953 3866; neg 6869; where 1115 6870;
mul 248 953; neg 6872; where 1115 6873; mul 222 1188; neg 6875; where 218 6876; add 6874 6877; mul 222 6878; add
6871 6879; mul 222 6880; add 6868 6881; mul 1824 3867; where 1115 6883; mul 1824 3866; where 1115 6885; where 1115
6816; mul 222 2052; where 218 6888; add 6887 6889; mul 222 6890; add 6886 6891; mul 222 6892; add 6884 6893; mul
2638 3867; neg 6895; where 1115 6896; mul 2638 3866; neg 6898; where 1115 6899; mul 248 2638; neg 6901; where 1115
6902; mul 222 2856; neg 6904; where 218 6905; add 6903 6906; mul 222 6907; add 6900 6908; mul 222 6909; add 6897
6910; mul 1142 3933; mul 230 6912; mul 1142 3855; add 6913 6914; mul 230 6915; mul 1142 3863; add 6916 6917; where
1141 6918; mul 2000 3933; mul 230 6920; mul 2000 3855; add 6921 6922; mul 230 6923; mul 2000 3863; add 6924 6925;
neg 6926; where 1141 6927; mul 1824 3933; mul 230 6929; mul 1824 3855; add 6930 6931; mul 230 6932; mul 1824 3863;
add 6933 6934; where 1141 6935; mul 953 3863; neg 6937; where 1115 6938; mul 222 6915; where 1141 6940; add 6939
6941; where 1115 6934; mul 222 6923; neg 6944; where 1141 6945; add 6943 6946; mul 2638 3863; neg 6948; where 1115
6949; mul 222 6932; where 1141 6951; add 6950 6952; mul 953 3856; neg 6954; where 1115 6955; mul 953 3855; neg 6957;
where 1115 6958; mul 222 6912; where 1141 6960; add 6959 6961; mul 222 6962; add 6956 6963; mul 1824 3856; where
1115 6965; where 1115 6931; mul 222 6920; neg 6968; where 1141 6969; add 6967 6970; mul 222 6971; add 6966 6972; mul
2638 3856; neg 6974; where 1115 6975; mul 2638 3855; neg 6977; where 1115 6978; mul 222 6929; where 1141 6980; add
6979 6981; mul 222 6982; add 6976 6983; mul 953 3845; neg 6985; where 1115 6986; mul 953 3844; neg 6988; where 1115
6989; mul 230 953; neg 6991; where 1115 6992; mul 222 1142; where 1141 6994; add 6993 6995; mul 222 6996; add 6990
6997; mul 222 6998; add 6987 6999; mul 1824 3845; where 1115 7001; mul 1824 3844; where 1115 7003; mul 230 1824;
where 1115 7005; mul 222 2000; neg 7007; where 1141 7008; add 7006 7009; mul 222 7010; add 7004 7011; mul 222 7012;
add 7002 7013; mul 2638 3845; neg 7015; where 1115 7016; mul 2638 3844; neg 7018; where 1115 7019; mul 230 2638; neg
7021; where 1115 7022; mul 222 1824; where 1141 7024; add 7023 7025; mul 222 7026; add 7020 7027; mul 222 7028; add
7017 7029; mul 953 3839; mul 222 7031; mul 953 3832; add 7032 7033; mul 222 7034; mul 953 3833; add 7035 7036; neg
7037; where 1115 7038; mul 1824 3839; mul 222 7040; mul 1824 3832; add 7041 7042; mul 222 7043; mul 1824 3833; add
7044 7045; where 1115 7046; mul 2638 3839; mul 222 7048; mul 2638 3832; add 7049 7050; mul 222 7051; mul 2638 3833;
add 7052 7053; neg 7054; where 1115 7055; mul 700 5964; mul 704 5918; sub 7057 7058; mul 90 6024; sub 7059 7060; mul
45 6038; mul 59 6040; add 7062 7063; mul 86 6029; add 7064 7065; mul 78 7066; add 7061 7067; mul 59 6032; mul 45
6030; sub 7069 7070; mul 78 7071; add 7068 7072; mul 74 6034; add 7073 7074; mul 74 6044; sub 7075 7076; mul 61
6029; mul 69 7078; add 7077 7079; mul 58 6079; add 7080 7081; mul 58 6087; add 7082 7083; mul 45 6051; mul 76 6040;
mul 76 6032; add 7086 7087; sub 7085 7088; mul 45 6054; add 7089 7090; mul 54 7091; add 7084 7092; mul 43 6056; add
7093 7094; mul 1619 5918; mul 1610 5964; sub 7096 7097; mul 700 6024; add 7098 7099; mul 86 6257; sub 7101 6478; mul
78 7102; add 7100 7103; sub 6078 6073; mul 45 6258; sub 7105 7106; mul 59 6262; add 7107 7108; mul 78 7109; add 7104
7110; mul 74 6264; add 7111 7112; mul 74 6267; sub 7113 7114; mul 61 6257; add 6042 7116; mul 69 7117; add 7115
7118; mul 58 6292; add 7119 7120; mul 58 6301; add 7121 7122; sub 6505 6504; mul 76 6262; sub 7124 7125; mul 45
6270; add 7126 7127; mul 54 7128; add 7123 7129; mul 43 6273; add 7130 7131; mul 1619 5964; mul 2427 5918; sub 7133
7134; mul 704 6024; sub 7135 7136; mul 86 6468; mul 78 7138; add 7137 7139; sub 7086 7090; mul 45 6469; sub 7141
7142; mul 59 6472; add 7143 7144; mul 78 7145; add 7140 7146; mul 74 6474; add 7147 7148; mul 74 6480; add 7149
7150; mul 61 6468; sub 7152 7064; mul 69 7153; add 7151 7154; mul 58 6510; add 7155 7156; mul 58 6515; add 7157
7158; mul 45 6483; mul 76 6472; sub 7160 7161; mul 54 7162; add 7159 7163; mul 43 6487; add 7164 7165; sub 6034
6044; sub 6264 6267; add 6474 6480; mul 16 6121; mul 16 6103; sub 7170 7171; mul 16 6315; mul 16 6334; add 7173
7174; mul 16 6548; mul 16 6530; sub 7176 7177; mul 535 5765; mul 535 7179; mul 21 7066; mul 53 7181; mul 5750 5917;
sub 7182 7183; mul 21 7071; mul 53 7185; add 7184 7186; mul 41 6035; add 7187 7188; mul 41 6045; sub 7189 7190; mul
67 249; mul 21 7078; mul 7192 7193; add 7191 7194; mul 28 7195; add 7180 7196; mul 535 6155; mul 535 7198; mul 21
7102; mul 53 7200; add 6068 7201; mul 21 7109; mul 53 7203; add 7202 7204; mul 41 6265; add 7205 7206; mul 41 6268;
sub 7207 7208; mul 21 7117; mul 7192 7210; add 7209 7211; mul 28 7212; add 7199 7213; mul 535 6367; mul 535 7215;
mul 21 7138; mul 53 7217; mul 5761 5917; sub 7218 7219; mul 21 7145; mul 53 7221; add 7220 7222; mul 41 6475; add
7223 7224; mul 41 6481; add 7225 7226; mul 21 7153; mul 7192 7228; add 7227 7229; mul 28 7230; add 7216 7231; mul
526 5765; mul 535 7233; mul 526 7179; add 7234 7235; mul 2 7195; add 7236 7237; mul 28 6093; add 7238 7239; mul 526
6155; mul 535 7241; mul 526 7198; add 7242 7243; mul 2 7212; add 7244 7245; mul 28 6306; add 7246 7247; mul 526
6367; mul 535 7249; mul 526 7215; add 7250 7251; mul 2 7230; add 7252 7253; mul 28 6520; add 7254 7255; mul 526
7233; mul 2 6093; add 7257 7258; mul 526 7241; mul 2 6306; add 7260 7261; mul 526 7249; mul 2 6520; add 7263 7264;
mul 571 5765; mul 535 7266; mul 571 7179; add 7267 7268; mul 34 7195; add 7269 7270; mul 67 7181; sub 7272 7219; mul
67 7185; add 7273 7274; mul 41 6080; add 7275 7276; mul 41 6088; add 7277 7278; mul 53 249; mul 21 7091; mul 7280
7281; add 7279 7282; mul 28 7283; add 7271 7284; mul 571 6155; mul 535 7286; mul 571 7198; add 7287 7288; mul 34
7212; add 7289 7290; mul 67 7200; add 6499 7292; mul 67 7203; add 7293 7294; mul 41 6293; add 7295 7296; mul 41
6302; add 7297 7298; mul 21 7128; mul 7280 7300; add 7299 7301; mul 28 7302; add 7291 7303; mul 571 6367; mul 535
7305; mul 571 7215; add 7306 7307; mul 34 7230; add 7308 7309; mul 67 7217; mul 5917 6363; sub 7311 7312; mul 67
7221; add 7313 7314; mul 41 6511; add 7315 7316; mul 41 6516; add 7317 7318; mul 21 7162; mul 7280 7320; add 7319
7321; mul 28 7322; add 7310 7323; mul 526 7266; mul 571 7233; add 7325 7326; mul 2 7283; add 7327 7328; mul 34 6093;
add 7329 7330; mul 526 7286; mul 571 7241; add 7332 7333; mul 2 7302; add 7334 7335; mul 34 6306; add 7336 7337; mul
526 7305; mul 571 7249; add 7339 7340; mul 2 7322; add 7341 7342; mul 34 6520; add 7343 7344; mul 571 7266; mul 34
7283; add 7346 7347; mul 571 7286; mul 34 7302; add 7349 7350; mul 571 7305; mul 34 7322; add 7352 7353; mul 38
5802; mul 22 7355; sub 710 7356; mul 38 6179; mul 22 7358; add 1624 7359; mul 38 6393; mul 22 7361; sub 2433 7362;
mul 5754 5960; mul 365 7355; sub 7364 7365; mul 5766 5914; add 7366 7367; mul 38 6094; add 7368 7369; mul 23 6060;
add 7370 7371; mul 365 7358; mul 5960 6146; add 7373 7374; mul 5914 6156; add 7375 7376; mul 38 6307; add 7377 7378;
mul 23 6277; add 7379 7380; mul 5960 6356; mul 365 7361; sub 7382 7383; mul 5914 6368; add 7384 7385; mul 38 6521;
add 7386 7387; mul 23 6491; add 7388 7389; neg 700; neg 499; neg 633; neg 502; neg 636; neg 506; neg 640; input p
220; mul 610 738; mul 7398 7399; add 738 7400; input p 221; mul 7399 7402; mul 421 7403; add 7401 7404; add 875
7405; mul 476 875; mul 7398 7407; add 7406 7408; mul 7402 7407; mul 421 7410; add 7409 7411; mul 610 1654; mul 7398
7413; add 1654 7414; mul 7402 7413; mul 421 7416; add 7415 7417; add 1770 7418; mul 476 1770; mul 7398 7420; add
7419 7421; mul 7402 7420; mul 421 7423; add 7422 7424; neg 7425; mul 610 2458; mul 7398 7427; add 2458 7428; mul
7402 7427; mul 421 7430; add 7429 7431; add 2576 7432; mul 476 2576; mul 7398 7434; add 7433 7435; mul 7402 7434;
mul 421 7437; add 7436 7438; mul 476 3260; mul 7398 7440; add 3260 7441; mul 7402 7440; mul 421 7443; add 7442 7444;
mul 610 3548; mul 7398 7446; add 3548 7447; mul 7402 7446; mul 421 7449; add 7448 7450; le 5987 5986; le 5986 5987;
add 7452 7453; div 1 7454; mul 7452 7455; mul 90 535; mul 7456 7457; neg 7458; mul 535 700; mul 7456 7460; mul 535
704; mul 7456 7462; neg 7463; mul 5999 7457; neg 7465; mul 5999 7460; mul 5999 7462; neg 7468; mul 90 6008; mul 535
7470; neg 7471; mul 700 6008; mul 535 7473; mul 704 6008; mul 535 7475; neg 7476; input p 222; mul 6008 6009; mul 90
7479; mul 249 6007; div 1 7481; mul 7480 7482; mul 7478 7483; mul 700 7479; mul 7482 7485; mul 7478 7486; neg 7487;
mul 704 7479; mul 7482 7489; mul 7478 7490; mul 700 5952; mul 1610 5952; neg 7493; mul 1619 5952; le 1 5939; mul 526
5953; add 535 7497; lt 5987 7498; and 7496 7499; constant -1.0; le 5939 7501; lt 7498 5987; and 7502 7503; or 7500
7504; not 7505; input p 160; mul 526 7507; where 7506 7508; le 1 5942; and 7499 7510; le 5942 7501; and 7503 7512;
or 7511 7513; not 7514; input p 161; mul 526 7516; where 7515 7517; le 1 5946; and 7499 7519; le 5946 7501; and 7503
7521; or 7520 7522; not 7523; input p 162; mul 526 7525; where 7524 7526; le 1 5950; and 7499 7528; le 5950 7501;
and 7503 7530; or 7529 7531; not 7532; input p 163; mul 526 7534; where 7533 7535; mul 23 5831; mul 23 5818; mul 38
5821; add 7538 7539; mul 38 942; add 7540 7541; sub 7537 7542; mul 23 6196; mul 38 6199; add 7544 7545; mul 38 1819;
sub 7546 7547; mul 23 6208; add 7548 7549; mul 23 6420; mul 23 6408; mul 38 6411; add 7552 7553; mul 38 2629; add
7554 7555; sub 7551 7556; mul 23 6579; mul 23 6570; mul 38 6568; add 7559 7560; mul 38 3286; add 7561 7562; sub 7558
7563; mul 23 5821; mul 38 5818; sub 7565 7566; mul 23 942; add 7567 7568; mul 38 5831; add 7569 7570; mul 38 6196;
mul 23 6199; sub 7572 7573; mul 23 1819; add 7574 7575; mul 38 6208; add 7576 7577; mul 23 6411; mul 38 6408; sub
7579 7580; mul 23 2629; add 7581 7582; mul 38 6420; add 7583 7584; mul 23 6568; mul 38 6570; sub 7586 7587; mul 23
3286; add 7588 7589; mul 38 6579; add 7590 7591; neg 5831; neg 6208; neg 6420; neg 6579; mul 450 465; mul 922 7597;
mul 450 520; mul 871 7599; add 7598 7600; mul 450 497; mul 813 7602; add 7601 7603; mul 450 461; mul 938 7605; add
7604 7606; neg 7607; mul 1766 7599; mul 1799 7597; sub 7609 7610; mul 1633 7602; add 7611 7612; mul 1815 7605; sub
7613 7614; mul 2609 7597; mul 2572 7599; add 7616 7617; mul 2519 7602; add 7618 7619; mul 2625 7605; add 7620 7621;
neg 7622; mul 3276 7597; mul 575 7599; add 7624 7625; mul 3282 7605; add 7626 7627; neg 7628; mul 471 924; mul 471
1801; neg 7631; mul 471 2611; neg 1779; mul 478 897; mul 478 1779; neg 7636; mul 478 2588; mul 494 878; mul 486
7639; neg 7640; mul 494 1757; mul 486 7642; mul 494 2579; mul 486 7644; neg 7645; input p 223; mul 476 882; mul 7647
7648; add 882 7649; input p 224; mul 7648 7651; mul 421 7652; add 7650 7653; neg 7654; mul 476 1774; mul 7647 7656;
add 1774 7657; mul 7651 7656; mul 421 7659; add 7658 7660; mul 476 2583; mul 7647 7662; add 2583 7663; mul 7651
7662; mul 421 7665; add 7664 7666; neg 7667; mul 520 813; mul 499 7669; mul 520 1633; mul 499 7671; neg 7672; mul
520 2519; mul 499 7674; mul 502 7669; mul 502 7671; neg 7677; mul 502 7674; mul 506 7669; mul 506 7671; neg 7681;
mul 506 7674; mul 520 867; mul 520 1762; neg 7685; mul 520 2568; mul 23 5804; mul 38 5800; add 7688 7689; mul 38
805; add 7690 7691; mul 23 5815; sub 7692 7693; mul 38 1714; mul 23 6181; mul 38 6184; add 7696 7697; sub 7695 7698;
mul 23 6193; sub 7699 7700; mul 23 6395; mul 38 6391; add 7702 7703; mul 38 2511; add 7704 7705; mul 23 6405; sub
7706 7707; mul 23 6612; mul 38 6614; add 7709 7710; mul 38 3574; add 7711 7712; mul 23 6623; sub 7713 7714; mul 23
5800; mul 38 5804; sub 7716 7717; mul 23 805; add 7718 7719; mul 38 5815; add 7720 7721; mul 38 6181; mul 23 6184;
sub 7723 7724; mul 23 1714; add 7725 7726; mul 38 6193; add 7727 7728; mul 23 6391; mul 38 6395; sub 7730 7731; mul
23 2511; add 7732 7733; mul 38 6405; add 7734 7735; mul 23 6614; mul 38 6612; sub 7737 7738; mul 23 3574; add 7739
7740; mul 38 6623; add 7741 7742; mul 587 602; mul 785 7744; mul 587 651; mul 734 7746; add 7745 7747; mul 587 631;
mul 712 7749; add 7748 7750; mul 587 598; mul 801 7752; add 7751 7753; neg 7754; mul 1650 7746; mul 1690 7744; sub
7756 7757; mul 1626 7749; add 7758 7759; mul 1706 7752; sub 7760 7761; mul 2491 7744; mul 2454 7746; add 7763 7764;
mul 2435 7749; add 7765 7766; mul 2507 7752; add 7767 7768; neg 7769; mul 3564 7744; mul 669 7746; add 7771 7772;
mul 3570 7752; add 7773 7774; neg 7775; mul 608 787; mul 608 1692; neg 7778; mul 608 2493; neg 1663; mul 612 760;
mul 612 1663; neg 7783; mul 612 2470; mul 628 741; mul 620 7786; neg 7787; mul 628 1641; mul 620 7789; mul 628 2461;
mul 620 7791; neg 7792; input p 225; mul 610 745; mul 7794 7795; add 745 7796; input p 226; mul 7795 7798; mul 421
7799; add 7797 7800; neg 7801; mul 610 1658; mul 7794 7803; add 1658 7804; mul 7798 7803; mul 421 7806; add 7805
7807; mul 610 2465; mul 7794 7809; add 2465 7810; mul 7798 7809; mul 421 7812; add 7811 7813; neg 7814; mul 651 712;
mul 633 7816; mul 651 1626; mul 633 7818; neg 7819; mul 651 2435; mul 633 7821; mul 636 7816; mul 636 7818; neg
7824; mul 636 7821; mul 640 7816; mul 640 7818; neg 7828; mul 640 7821; mul 651 730; mul 651 1646; neg 7832; mul 651
2450; mul 700 5953; sub 7835 90; mul 5939 7836; mul 1610 5953; sub 700 7838; mul 5939 7839; mul 1619 5953; sub 7841
704; mul 5939 7842; mul 5942 7836; mul 5942 7839; mul 5942 7842; mul 5946 7836; mul 5946 7839; mul 5946 7842; mul
5950 7836; mul 5950 7839; mul 5950 7842; mul 7498 7507; mul 7507 7853; neg 7854; where 7506 7855; mul 7498 7516; mul
7516 7857; neg 7858; where 7515 7859; mul 7498 7525; mul 7525 7861; neg 7862; where 7524 7863; mul 7498 7534; mul
7534 7865; neg 7866; where 7533 7867; mul 90 6015; neg 7869; mul 700 6015; mul 704 6015; neg 7872; mul 90 6019; neg
7874; mul 700 6019; mul 704 6019; neg 7877; mul 91 1604; neg 7879; mul 91 2417; mul 91 3235; neg 7882; store by_k 96
1606; store by_k 288 2419; store by_k 480 3237; store by_k 576 3534; store by_k 672 3831; store by_k 768 3534; store
by_k 864 3831; store by_k 960 3534; store by_k 1056 3831; store by_k 97 3983; store by_k 289 3998; store by_k 481
4014; store by_k 98 4031; store by_k 290 4041; store by_k 482 4051; store by_k 99 4181; store by_k 291 4289; store
by_k 483 4397; store by_k 100 4563; store by_k 292 4691; store by_k 484 4819; store by_k 101 4947; store by_k 293
5051; store by_k 485 5155; store by_k 581 5259; store by_k 677 5363; store by_k 773 5259; store by_k 869 5363; store
by_k 965 5259; store by_k 1061 5363; store by_k 102 5440; store by_k 294 5514; store by_k 486 5588; store by_k 103
5597; store by_k 295 5606; store by_k 487 5615; store by_k 583 5618; store by_k 679 5621; store by_k 775 5618; store
by_k 871 5621; store by_k 967 5618; store by_k 1063 5621; store by_k 104 5630; store by_k 296 5639; store by_k 488
5648; store by_k 584 5651; store by_k 680 5654; store by_k 776 5651; store by_k 872 5654; store by_k 968 5651; store
by_k 1064 5654; store by_k 105 5663; store by_k 297 5669; store by_k 489 5678; store by_k 585 5681; store by_k 681
5684; store by_k 777 5681; store by_k 873 5684; store by_k 969 5681; store by_k 1065 5684; store by_k 106 5685;
store by_k 298 5686; store by_k 490 5687; store by_k 586 5688; store by_k 682 5689; store by_k 778 5688; store by_k
874 5689; store by_k 970 5688; store by_k 1066 5689; store by_k 107 5692; store by_k 299 5695; store by_k 491 5698;
store by_k 587 5701; store by_k 683 5704; store by_k 779 5701; store by_k 875 5704; store by_k 971 5701; store by_k
1067 5704; store by_k 108 5705; store by_k 300 5706; store by_k 492 5707; store by_k 588 5708; store by_k 684 5709;
store by_k 780 5708; store by_k 876 5709; store by_k 972 5708; store by_k 1068 5709; store by_k 109 5712; store by_k
301 5715; store by_k 493 5718; store by_k 589 5721; store by_k 685 5724; store by_k 781 5721; store by_k 877 5724;
store by_k 973 5721; store by_k 1069 5724; store by_k 110 5727; store by_k 302 5730; store by_k 494 5733; store by_k
590 5736; store by_k 686 5739; store by_k 782 5736; store by_k 878 5739; store by_k 974 5736; store by_k 1070 5739;
store by_k 111 5740; store by_k 303 5741; store by_k 495 5742; store by_k 591 5743; store by_k 687 5744; store by_k
783 5743; store by_k 879 5744; store by_k 975 5743; store by_k 1071 5744; store by_k 112 6140; store by_k 304 6353;
store by_k 496 6567; store by_k 592 6611; store by_k 688 6655; store by_k 784 6611; store by_k 880 6655; store by_k
976 6611; store by_k 1072 6655; store by_k 113 6660; store by_k 305 6664; store by_k 497 6669; store by_k 114 6675;
store by_k 306 6681; store by_k 498 6687; store by_k 115 6694; store by_k 307 6698; store by_k 499 6705; store by_k
116 6715; store by_k 308 6726; store by_k 500 6736; store by_k 117 6741; store by_k 309 6744; store by_k 501 6749;
store by_k 118 6761; store by_k 310 6769; store by_k 502 6781; store by_k 119 6795; store by_k 311 6811; store by_k
503 6825; store by_k 120 6830; store by_k 312 6833; store by_k 504 6838; store by_k 121 6848; store by_k 313 6855;
store by_k 505 6865; store by_k 122 6882; store by_k 314 6894; store by_k 506 6911; store by_k 123 6919; store by_k
315 6928; store by_k 507 6936; store by_k 124 6942; store by_k 316 6947; store by_k 508 6953; store by_k 125 6964;
store by_k 317 6973; store by_k 509 6984; store by_k 126 7000; store by_k 318 7014; store by_k 510 7030; store by_k
127 7039; store by_k 319 7047; store by_k 511 7056; store by_k 128 7095; store by_k 320 7132; store by_k 512 7166;
store by_k 129 7167; store by_k 321 7168; store by_k 513 7169; store by_k 130 6056; store by_k 322 6273; store by_k
514 6487; store by_k 131 7172; store by_k 323 7175; store by_k 515 7178; store by_k 132 7091; store by_k 324 7128;
store by_k 516 7162; store by_k 133 7197; store by_k 325 7214; store by_k 517 7232; store by_k 134 7240; store by_k
326 7248; store by_k 518 7256; store by_k 135 7259; store by_k 327 7262; store by_k 519 7265; store by_k 136 7285;
store by_k 328 7304; store by_k 520 7324; store by_k 137 7331; store by_k 329 7338; store by_k 521 7345; store by_k
138 7348; store by_k 330 7351; store by_k 522 7354; store by_k 139 7357; store by_k 331 7360; store by_k 523 7363;
store by_k 140 7372; store by_k 332 7381; store by_k 524 7390; store by_k 141 90; store by_k 333 7391; store by_k
525 704; store by_k 622 7392; store by_k 718 7393; store by_k 815 7394; store by_k 911 7395; store by_k 1008 7396;
store by_k 1104 7397; store by_k 145 7412; store by_k 337 7426; store by_k 529 7439; store by_k 625 7445; store by_k
721 7451; store by_k 817 7445; store by_k 913 7451; store by_k 1009 7445; store by_k 1105 7451; store by_k 146 7459;
store by_k 338 7461; store by_k 530 7464; store by_k 147 7466; store by_k 339 7467; store by_k 531 7469; store by_k
148 7472; store by_k 340 7474; store by_k 532 7477; store by_k 149 7484; store by_k 341 7488; store by_k 533 7491;
store by_k 150 7492; store by_k 342 7494; store by_k 534 7495; store by_k 1398 7509; store by_k 1494 7518; store
by_k 1590 7527; store by_k 1686 7536; store by_k 151 7543; store by_k 343 7550; store by_k 535 7557; store by_k 631
7564; store by_k 823 7564; store by_k 1015 7564; store by_k 152 7571; store by_k 344 7578; store by_k 536 7585;
store by_k 632 7592; store by_k 824 7592; store by_k 1016 7592; store by_k 153 7593; store by_k 345 7594; store by_k
537 7595; store by_k 633 7596; store by_k 825 7596; store by_k 1017 7596; store by_k 154 942; store by_k 346 1819;
store by_k 538 2629; store by_k 634 3286; store by_k 826 3286; store by_k 1018 3286; store by_k 155 7608; store by_k
347 7615; store by_k 539 7623; store by_k 635 7629; store by_k 827 7629; store by_k 1019 7629; store by_k 156 7630;
store by_k 348 7632; store by_k 540 7633; store by_k 157 897; store by_k 349 7634; store by_k 541 2588; store by_k
158 7635; store by_k 350 7637; store by_k 542 7638; store by_k 159 7641; store by_k 351 7643; store by_k 543 7646;
store by_k 160 7655; store by_k 352 7661; store by_k 544 7668; store by_k 161 7670; store by_k 353 7673; store by_k
545 7675; store by_k 162 7676; store by_k 354 7678; store by_k 546 7679; store by_k 163 7680; store by_k 355 7682;
store by_k 547 7683; store by_k 164 7684; store by_k 356 7686; store by_k 548 7687; store by_k 165 7694; store by_k
357 7701; store by_k 549 7708; store by_k 741 7715; store by_k 933 7715; store by_k 1125 7715; store by_k 166 7722;
store by_k 358 7729; store by_k 550 7736; store by_k 742 7743; store by_k 934 7743; store by_k 1126 7743; store by_k
167 5815; store by_k 359 6193; store by_k 551 6405; store by_k 743 6623; store by_k 935 6623; store by_k 1127 6623;
store by_k 168 805; store by_k 360 1714; store by_k 552 2511; store by_k 744 3574; store by_k 936 3574; store by_k
1128 3574; store by_k 169 7755; store by_k 361 7762; store by_k 553 7770; store by_k 745 7776; store by_k 937 7776;
store by_k 1129 7776; store by_k 170 7777; store by_k 362 7779; store by_k 554 7780; store by_k 171 760; store by_k
363 7781; store by_k 555 2470; store by_k 172 7782; store by_k 364 7784; store by_k 556 7785; store by_k 173 7788;
store by_k 365 7790; store by_k 557 7793; store by_k 174 7802; store by_k 366 7808; store by_k 558 7815; store by_k
175 7817; store by_k 367 7820; store by_k 559 7822; store by_k 176 7823; store by_k 368 7825; store by_k 560 7826;
store by_k 177 7827; store by_k 369 7829; store by_k 561 7830; store by_k 178 7831; store by_k 370 7833; store by_k
562 7834; store by_k 179 7837; store by_k 371 7840; store by_k 563 7843; store by_k 180 7844; store by_k 372 7845;
store by_k 564 7846; store by_k 181 7847; store by_k 373 7848; store by_k 565 7849; store by_k 182 7850; store by_k
374 7851; store by_k 566 7852; store by_k 1431 7856; store by_k 1528 7860; store by_k 1625 7864; store by_k 1722
7868; store by_k 187 7870; store by_k 379 7871; store by_k 571 7873; store by_k 188 7875; store by_k 380 7876; store
by_k 572 7878; store by_k 1245 6015; store by_k 1342 6019; store by_k 191 7880; store by_k 383 7881; store by_k 575
7883
    """,
)
