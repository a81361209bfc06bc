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
19 267; sub 267 220; mul 268 269; input k 79; input k 80; input k 81; input k 82; constant -6.0; constant 4.0; input
k 45; input k 83; input k 84; input k 85; input k 86; input k 51; input k 52; input k 53; mul 284 284; input k 91;
input k 92; mul 3 164; input k 30; input k 29; input k 28; input k 27; mul 6 175; input k 54; constant
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
335; neg 336; mul 278 294; mul 279 294; mul 280 294; mul 281 294; mul 17 18; mul 27 164; mul 164 284; store p 0 0;
store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9
10; store p 10 11; store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 22; store p 16 23; store p
17 17; store p 18 24; store p 19 37; store p 20 38; store p 21 39; store p 22 40; store p 23 43; store p 24 48;
store p 25 50; store p 26 55; store p 27 60; store p 28 67; store p 29 69; store p 30 74; store p 31 76; store p 32
81; store p 33 86; store p 34 91; store p 35 96; store p 36 102; store p 37 104; store p 38 106; store p 39 111;
store p 40 118; store p 41 120; store p 42 125; store p 43 129; store p 44 134; store p 45 139; store p 46 141;
store p 47 146; store p 48 151; store p 49 153; store p 50 158; store p 51 163; store p 52 165; store p 53 166;
store p 54 167; store p 55 168; store p 56 169; store p 57 170; store p 58 171; store p 59 172; store p 60 173;
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
input p 127; input p 128; input z 0; mul 752 753; input p 129; input z 1; mul 755 756; add 754 757; input p 130;
input z 2; mul 759 760; add 758 761; input p 131; input z 3; mul 763 764; add 762 765; sub 751 766; input p 132; abs
0; mul 768 769; mul 0 770; input p 133; mul 0 772; mul 0 0; input p 134; add 774 775; sqrt 776; div 2 777; mul 773
778; add 771 779; sub 767 780; add 750 781; input p 135; input x 12; sub 29 784; mul 783 785; input p 136; input x
13; sub 29 788; mul 787 789; add 786 790; sub 782 791; mul 0 63; mul 28 131; add 793 794; mul 48 620; add 795 796;
mul 0 797; mul 0 28; mul 31 131; add 799 800; mul 34 620; add 801 802; mul 131 803; add 798 804; mul 0 48; mul 34
131; add 806 807; mul 52 620; add 808 809; mul 620 810; add 805 811; mul 17 24; mul 17 813; mul 3 17; input p 137;
div 2 7; mul 816 817; mul 3 3; sub 7 819; div 2 820; mul 10 821; add 818 822; mul 815 823; mul 39 824; sub 814 825;
mul 23 826; mul 131 131; mul 827 828; add 812 829; mul 68 830; mul 24 824; mul 17 39; mul 17 833; add 832 834; mul
23 835; mul 828 836; sub 831 837; mul 22 838; sub 792 839; mul 91 840; mul 82 90; mul 151 266; mul 146 843; abs 3;
lt 845 281; input p 138; mul 276 847; mul 276 848; mul 276 849; mul 273 284; input p 139; mul 276 852; mul 276 853;
mul 851 854; add 850 855; mul 284 284; input p 140; mul 276 858; mul 857 859; add 856 860; mul 284 859; mul 851 862;
add 861 863; mul 284 857; input p 141; mul 865 866; add 864 867; mul 284 866; mul 857 869; add 868 870; mul 284 869;
mul 851 872; add 871 873; mul 287 302; add 874 875; mul 284 302; mul 291 877; add 876 878; mul 292 302; add 879 880;
mul 284 877; mul 295 882; add 881 883; mul 296 877; add 884 885; mul 297 302; add 886 887; mul 310 319; add 888 889;
mul 284 319; mul 314 891; add 890 892; mul 315 319; add 893 894; mul 327 334; add 895 896; mul 146 897; where 846
898; add 844 899; mul 592 722; sub 900 901; mul 151 741; add 902 903; mul 583 626; mul 711 719; add 905 906; add 904
907; sub 135 908; input p 142; mul 39 910; mul 17 911; add 909 912; input p 143; mul 766 914; sub 913 915; mul 42
830; mul 26 837; sub 917 918; mul 22 919; mul 19 824; mul 828 921; sub 920 922; sub 916 923; mul 842 924; sub 841
925; mul 87 90; input p 144; mul 35 928; input p 145; mul 215 930; add 929 931; input p 146; mul 219 933; add 932
934; mul 156 211; add 935 936; input p 147; mul 159 938; add 937 939; input p 148; mul 163 941; add 940 942; input p
149; mul 167 944; add 943 945; mul 171 228; add 946 947; input p 150; mul 175 949; add 948 950; mul 158 190; add 951
952; input p 151; mul 194 954; add 953 955; mul 170 198; add 956 957; input p 152; mul 202 959; add 958 960; mul 185
259; add 961 962; mul 203 258; add 963 964; mul 154 266; add 965 966; mul 146 967; abs 35; lt 969 273; mul 276 276;
mul 276 971; input p 153; mul 972 973; mul 276 973; mul 971 975; add 974 976; mul 273 276; mul 276 975; mul 978 979;
add 977 980; mul 276 284; mul 276 982; mul 847 983; add 981 984; mul 848 982; add 985 986; mul 284 849; add 987 988;
mul 276 857; mul 852 990; add 989 991; mul 853 857; add 992 993; mul 858 865; add 994 995; mul 276 302; mul 276 997;
mul 277 998; add 996 999; mul 278 997; add 1000 1001; mul 279 302; add 1002 1003; mul 276 877; mul 285 1005; add
1004 1006; mul 286 877; add 1007 1008; mul 290 882; add 1009 1010; mul 276 319; mul 304 1012; add 1011 1013; mul 305
319; add 1014 1015; mul 309 891; add 1016 1017; mul 320 334; add 1018 1019; mul 146 1020; where 970 1021; add 968
1022; mul 619 722; sub 1023 1024; input p 154; mul 620 1026; mul 154 741; add 1027 1028; add 1025 1029; mul 54 830;
mul 22 1031; add 1030 1032; mul 927 1033; sub 926 1034; mul 57 71; mul 80 80; sub 1036 1037; mul 90 1038; mul 924
1039; mul 840 842; sub 1040 1041; mul 60 71; mul 77 80; sub 1043 1044; mul 90 1045; mul 1033 1046; add 1042 1047;
mul 840 927; mul 924 1046; sub 1049 1050; mul 46 71; mul 77 77; sub 1052 1053; mul 90 1054; mul 1033 1055; sub 1051
1056; mul 571 624; input p 155; mul 550 1059; sub 1058 1060; mul 699 717; mul 681 1059; sub 1062 1063; input p 156;
mul 553 1065; sub 1058 1066; mul 684 1065; sub 1062 1068; input p 157; mul 557 1070; sub 1058 1071; mul 688 1070;
sub 1062 1073; input p 158; mul 785 1075; input p 159; mul 789 1077; le 2 753; mul 131 914; add 0 1080; lt 141 1081;
and 1079 1082; constant -1.0; le 753 1084; lt 1081 141; and 1085 1086; or 1083 1087; not 1088; input p 160; mul 1081
1090; where 1089 1091; le 2 756; and 1082 1093; le 756 1084; and 1086 1095; or 1094 1096; not 1097; input p 161; mul
1081 1099; where 1098 1100; le 2 760; and 1082 1102; le 760 1084; and 1086 1104; or 1103 1105; not 1106; input p
162; mul 1081 1108; where 1107 1109; le 2 764; and 1082 1111; le 764 1084; and 1086 1113; or 1112 1114; not 1115;
input p 163; mul 1081 1117; where 1116 1118; mul 42 273; mul 28 1120; mul 22 1121; mul 57 1122; mul 54 273; mul 48
1124; mul 22 1125; mul 46 1126; add 1123 1127; mul 28 54; mul 42 48; add 1129 1130; mul 22 1131; mul 60 1132; add
1133 1133; sub 1128 1134; mul 90 1135; mul 90 91; mul 68 273; mul 63 1138; mul 22 1139; mul 62 1140; mul 71 1135;
add 1141 1142; mul 42 63; mul 28 68; add 1144 1145; mul 22 1146; mul 82 1147; mul 57 1147; mul 77 1126; add 1149
1150; mul 80 1132; mul 48 68; mul 54 63; add 1153 1154; mul 22 1155; mul 60 1156; add 1152 1157; sub 1151 1158; mul
77 1159; add 1148 1160; sub 1143 1161; mul 87 1156; mul 60 1147; mul 77 1132; add 1164 1165; mul 80 1122; mul 46
1156; add 1167 1168; sub 1166 1169; mul 80 1170; add 1163 1171; add 1162 1172; mul 1137 1173; sub 1136 1174; mul 840
1175; mul 101 107; mul 103 1177; mul 101 115; sub 1178 1179; mul 101 119; mul 101 1181; sub 1180 1182; input p 164;
input p 165; mul 35 1185; mul 158 1186; add 1184 1187; mul 35 1186; mul 162 1189; add 1188 1190; mul 156 273; mul
1185 1192; mul 166 1193; add 1191 1194; mul 35 1193; mul 170 1196; add 1195 1197; mul 156 1193; mul 167 1185; add
1199 1200; mul 174 1201; add 1198 1202; input p 166; add 1203 1204; mul 35 145; mul 181 1206; add 1205 1207; mul 35
1206; mul 185 1209; add 1208 1210; mul 145 156; mul 149 1185; add 1212 1213; mul 189 1214; add 1211 1215; mul 35
1214; mul 193 1217; add 1216 1218; mul 156 1214; mul 190 1185; add 1220 1221; mul 197 1222; add 1219 1223; mul 149
273; mul 145 1225; mul 156 1226; mul 202 1185; add 1227 1228; mul 201 1229; add 1224 1230; mul 149 1226; mul 145
202; add 1232 1233; mul 206 1234; add 1231 1235; input p 167; mul 225 1186; add 1237 1238; mul 228 1189; add 1239
1240; mul 231 1193; add 1241 1242; mul 234 1196; add 1243 1244; mul 237 1201; add 1245 1246; input p 168; add 1247
1248; mul 158 1206; add 1249 1250; mul 162 1209; add 1251 1252; mul 246 1214; add 1253 1254; mul 249 1217; add 1255
1256; mul 252 1222; add 1257 1258; mul 255 1226; add 1259 1260; mul 35 1226; mul 258 1262; add 1261 1263; mul 197
1229; add 1264 1265; mul 264 1234; add 1266 1267; mul 148 1268; add 1236 1269; mul 146 1270; le 301 271; le 271 301;
add 1272 1273; div 2 1274; mul 1272 1275; le 300 149; le 149 300; add 1277 1278; div 2 1279; mul 1277 1280; mul 145
1281; mul 1276 1282; mul 273 1283; mul 306 1284; mul 311 1284; add 1285 1286; mul 316 1284; add 1287 1288; mul 303
1283; mul 321 1290; add 1289 1291; mul 324 1284; mul 321 1283; mul 303 1294; add 1293 1295; add 1292 1296; mul 328
1290; add 1297 1298; mul 331 1284; mul 328 1283; mul 303 1301; add 1300 1302; add 1299 1303; mul 302 1290; mul 319
1283; add 1305 1306; mul 335 1307; add 1304 1308; mul 338 1290; mul 335 1283; mul 319 1311; add 1310 1312; add 1309
1313; mul 341 1284; mul 338 1283; mul 302 1311; add 1316 1317; mul 303 1318; add 1315 1319; add 1314 1320; mul 146
1321; where 272 1322; add 1271 1323; input p 169; mul 358 1189; add 1325 1326; mul 361 1201; add 1327 1328; input p
170; add 1329 1330; mul 367 1209; add 1331 1332; mul 370 1217; add 1333 1334; mul 373 1222; add 1335 1336; mul 376
1229; add 1337 1338; mul 379 1234; add 1339 1340; input p 171; mul 390 1189; add 1342 1343; mul 393 1196; add 1344
1345; mul 396 1201; add 1346 1347; input p 172; add 1348 1349; mul 358 1209; add 1350 1351; mul 403 1222; add 1352
1353; mul 406 1262; add 1354 1355; mul 373 1229; add 1356 1357; mul 411 1234; add 1358 1359; mul 148 1360; add 1341
1361; input p 173; add 1362 1363; mul 347 1364; mul 722 1365; mul 273 501; mul 382 1186; mul 35 1189; mul 384 1369;
add 1368 1370; mul 431 1193; add 1371 1372; mul 35 1196; mul 434 1374; add 1373 1375; mul 35 1201; mul 438 1377; add
1376 1378; mul 156 1201; mul 175 1185; add 1380 1381; mul 442 1382; add 1379 1383; mul 356 1214; add 1384 1385; mul
35 1217; mul 358 1387; add 1386 1388; mul 156 1222; mul 198 1185; add 1390 1391; mul 361 1392; add 1389 1393; mul
281 1226; add 1394 1395; mul 35 1262; mul 456 1397; add 1396 1398; mul 35 1229; mul 406 1400; add 1399 1401; mul 156
1229; mul 203 1185; add 1403 1404; mul 463 1405; add 1402 1406; mul 156 1234; mul 207 1185; add 1408 1409; mul 411
1410; add 1407 1411; mul 149 1234; mul 145 207; add 1413 1414; mul 470 1415; add 1412 1416; mul 149 1363; mul 145
355; add 1418 1419; input p 174; mul 3 1421; add 1420 1422; input p 175; mul 35 1424; add 1423 1425; mul 105 1426;
add 1417 1427; mul 347 1428; mul 1367 1429; mul 273 508; sub 1430 1431; mul 273 512; div 2 1433; mul 1432 1434; mul
502 1435; mul 273 1436; mul 273 515; mul 273 514; div 2 1439; mul 1436 1440; mul 516 1441; mul 1438 1442; neg 1443;
mul 273 1444; mul 516 1445; mul 521 1443; sub 1446 1447; sub 1437 1448; mul 519 1449; mul 536 1450; le 529 525; le
525 529; add 1452 1453; div 2 1454; mul 1452 1455; le 526 528; le 528 526; add 1457 1458; div 2 1459; mul 1457 1460;
mul 1436 1461; mul 1456 1462; mul 532 1463; mul 530 1464; mul 534 1463; add 1465 1466; mul 524 1467; add 1451 1468;
mul 541 1436; mul 528 1470; mul 543 1436; add 1471 1472; mul 539 1473; sub 1469 1474; mul 502 1475; mul 566 1436;
mul 528 1477; mul 568 1436; add 1478 1479; mul 564 1480; mul 562 1441; mul 515 1482; mul 563 1441; add 1483 1484;
mul 515 1485; mul 515 563; mul 1441 1487; add 1486 1488; mul 502 1489; mul 570 1490; sub 1481 1491; mul 559 1492;
add 1476 1493; mul 574 1492; mul 571 1495; mul 575 1492; add 1496 1497; mul 624 1498; mul 502 1443; mul 508 1500;
add 517 1501; mul 0 1502; mul 579 1429; add 577 1504; mul 517 1505; mul 581 1500; add 1506 1507; mul 17 1508; mul
131 1509; sub 1503 1510; mul 517 1429; mul 501 1500; sub 1512 1513; mul 622 1514; mul 588 1365; mul 151 1360; add
1421 1517; mul 347 1518; mul 131 1519; add 1516 1520; input p 176; mul 602 1189; add 1522 1523; mul 390 1196; add
1524 1525; mul 438 1201; add 1526 1527; mul 609 1217; add 1528 1529; mul 367 1262; add 1530 1531; mul 406 1229; add
1532 1533; mul 154 1360; add 1534 1535; add 1424 1536; mul 347 1537; mul 620 1538; add 1521 1539; mul 518 1540; add
1515 1541; add 1511 1542; mul 576 1543; add 1499 1544; add 1494 1545; mul 518 1546; mul 626 1514; add 1547 1548; mul
273 635; mul 1429 1550; mul 273 642; sub 1551 1552; mul 273 646; div 2 1554; mul 1553 1555; mul 636 1556; mul 273
1557; mul 273 649; mul 273 648; div 2 1560; mul 1557 1561; mul 650 1562; mul 1559 1563; neg 1564; mul 273 1565; mul
650 1566; mul 655 1564; sub 1567 1568; sub 1558 1569; mul 653 1570; mul 667 1571; le 660 525; le 525 660; add 1573
1574; div 2 1575; mul 1573 1576; le 526 659; le 659 526; add 1578 1579; div 2 1580; mul 1578 1581; mul 1557 1582;
mul 1577 1583; mul 663 1584; mul 661 1585; mul 665 1584; add 1586 1587; mul 658 1588; add 1572 1589; mul 672 1557;
mul 659 1591; mul 674 1557; add 1592 1593; mul 670 1594; sub 1590 1595; mul 636 1596; mul 566 1557; mul 659 1598;
mul 696 1557; add 1599 1600; mul 694 1601; mul 692 1562; mul 649 1603; mul 693 1562; add 1604 1605; mul 649 1606;
mul 649 693; mul 1562 1608; add 1607 1609; mul 636 1610; mul 698 1611; sub 1602 1612; mul 690 1613; add 1597 1614;
mul 702 1613; mul 699 1616; mul 703 1613; add 1617 1618; mul 717 1619; mul 707 1429; sub 1621 705; mul 651 1622; mul
636 1564; mul 709 1624; sub 1623 1625; mul 17 1626; mul 131 1627; mul 642 1624; add 651 1629; mul 0 1630; add 1628
1631; mul 651 1429; mul 635 1624; sub 1633 1634; mul 622 1635; mul 652 1540; add 1636 1637; add 1632 1638; mul 704
1639; add 1620 1640; add 1615 1641; mul 652 1642; mul 719 1635; add 1643 1644; add 1549 1645; mul 417 1646; sub 1366
1647; sub 1324 1648; mul 145 1649; mul 585 1546; mul 626 1502; sub 1651 1652; mul 713 1642; mul 719 1630; sub 1654
1655; add 1653 1656; sub 1650 1657; sub 1183 1658; input p 177; sub 1659 1660; mul 63 830; mul 22 1662; sub 1661
1663; mul 91 1664; add 1176 1665; mul 90 1159; mul 90 842; mul 1173 1668; sub 1667 1669; mul 924 1670; mul 151 1268;
mul 146 1672; mul 287 1283; mul 284 1283; mul 291 1675; add 1674 1676; mul 292 1283; add 1677 1678; mul 284 1675;
mul 295 1680; add 1679 1681; mul 296 1675; add 1682 1683; mul 297 1283; add 1684 1685; mul 310 1290; add 1686 1687;
mul 284 1290; mul 314 1689; add 1688 1690; mul 315 1290; add 1691 1692; mul 327 1307; add 1693 1694; mul 146 1695;
where 846 1696; add 1673 1697; mul 722 1519; mul 592 1646; sub 1699 1700; sub 1698 1701; mul 583 1546; mul 626 1509;
sub 1703 1704; mul 711 1642; mul 719 1627; add 1706 1707; add 1705 1708; add 1702 1709; sub 1181 1710; mul 28 830;
mul 22 1712; sub 1711 1713; mul 842 1714; add 1671 1715; sub 1666 1716; mul 90 1170; mul 90 927; mul 1173 1719; sub
1718 1720; mul 1033 1721; input p 178; mul 938 1186; add 1723 1724; mul 941 1189; add 1725 1726; mul 944 1193; add
1727 1728; mul 228 1196; add 1729 1730; mul 949 1201; add 1731 1732; mul 158 1214; add 1733 1734; mul 954 1217; add
1735 1736; mul 170 1222; add 1737 1738; mul 959 1226; add 1739 1740; mul 185 1262; add 1741 1742; mul 258 1229; add
1743 1744; mul 154 1268; add 1745 1746; mul 146 1747; mul 276 1283; mul 276 1749; mul 277 1750; mul 278 1749; add
1751 1752; mul 279 1283; add 1753 1754; mul 276 1675; mul 285 1756; add 1755 1757; mul 286 1675; add 1758 1759; mul
290 1680; add 1760 1761; mul 276 1290; mul 304 1763; add 1762 1764; mul 305 1290; add 1765 1766; mul 309 1689; add
1767 1768; mul 320 1307; add 1769 1770; mul 146 1771; where 970 1772; add 1748 1773; mul 722 1538; mul 619 1646; sub
1775 1776; sub 1774 1777; mul 48 830; mul 22 1779; add 1778 1780; mul 927 1781; add 1722 1782; sub 1717 1783; input
c_q 0; mul 91 1785; le 141 140; le 140 141; add 1787 1788; div 2 1789; mul 1787 1790; mul 0 91; mul 1791 1792; input
c_q 1; mul 1793 1794; sub 1786 1795; mul 91 94; input c_q 2; mul 1797 1798; add 1796 1799; mul 91 98; input c_q 3;
mul 1801 1802; add 1800 1803; mul 91 101; add 842 1805; input c_q 4; mul 1806 1807; sub 1804 1808; mul 103 1806;
input c_q 5; mul 1810 1811; add 1809 1812; mul 94 1806; input c_q 6; mul 1814 1815; sub 1813 1816; mul 98 1806;
input c_q 7; mul 1818 1819; sub 1817 1820; le 129 128; le 128 129; add 1822 1823; div 2 1824; mul 1822 1825; mul 133
1806; mul 1826 1827; input c_q 8; mul 1828 1829; add 1821 1830; mul 91 103; input c_q 9; mul 1832 1833; add 1831
1834; mul 103 1832; mul 105 1836; input c_q 10; mul 1837 1838; sub 1835 1839; mul 94 1832; input c_q 11; mul 1841
1842; add 1840 1843; mul 98 1832; input c_q 12; mul 1845 1846; add 1844 1847; add 1784 1848; mul 57 1140; mul 71
1126; add 1850 1851; mul 80 1156; add 1853 1853; sub 1852 1854; mul 90 1855; mul 90 1039; mul 1173 1857; sub 1856
1858; mul 924 1859; mul 1039 1714; add 1860 1861; mul 840 1670; mul 842 1664; add 1863 1864; sub 1862 1865; mul 60
1140; mul 71 1132; add 1867 1868; mul 77 1156; mul 80 1147; add 1870 1871; sub 1869 1872; mul 90 1873; mul 90 1046;
mul 1173 1875; sub 1874 1876; mul 1033 1877; mul 1046 1781; add 1878 1879; add 1866 1880; mul 0 842; mul 1791 1882;
mul 1794 1883; mul 842 1785; sub 1884 1885; mul 94 842; mul 1798 1887; sub 1886 1888; mul 98 842; mul 1802 1890; sub
1889 1891; mul 101 842; add 1039 1893; mul 1807 1894; add 1892 1895; mul 103 1894; mul 1811 1897; sub 1896 1898; mul
94 1894; mul 1815 1900; add 1899 1901; mul 98 1894; mul 1819 1903; add 1902 1904; mul 133 1894; mul 1826 1906; mul
1829 1907; sub 1905 1908; mul 103 842; mul 1833 1910; sub 1909 1911; mul 103 1910; mul 105 1913; mul 1838 1914; add
1912 1915; mul 94 1910; mul 1842 1917; sub 1916 1918; mul 98 1910; mul 1846 1920; sub 1919 1921; add 1881 1922; mul
840 1721; mul 927 1664; add 1924 1925; mul 924 1877; mul 1046 1714; add 1927 1928; sub 1926 1929; mul 46 1140; mul
71 1122; add 1931 1932; mul 77 1147; add 1934 1934; sub 1933 1935; mul 90 1936; mul 90 1055; mul 1173 1938; sub 1937
1939; mul 1033 1940; mul 1055 1781; add 1941 1942; sub 1930 1943; mul 927 1785; mul 0 927; mul 1791 1946; mul 1794
1947; sub 1945 1948; mul 94 927; mul 1798 1950; add 1949 1951; mul 98 927; mul 1802 1953; add 1952 1954; mul 101
927; add 1046 1956; mul 1807 1957; sub 1955 1958; mul 103 1957; mul 1811 1960; add 1959 1961; mul 94 1957; mul 1815
1963; sub 1962 1964; mul 98 1957; mul 1819 1966; sub 1965 1967; mul 133 1957; mul 1826 1969; mul 1829 1970; add 1968
1971; mul 103 927; mul 1833 1973; add 1972 1974; mul 103 1973; mul 105 1976; mul 1838 1977; sub 1975 1978; mul 94
1973; mul 1842 1980; add 1979 1981; mul 98 1973; mul 1846 1983; add 1982 1984; add 1944 1985; mul 624 1492; mul 571
1543; add 1987 1988; mul 717 1613; mul 699 1639; add 1990 1991; mul 101 130; mul 101 1993; add 142 1994; mul 416
518; sub 1996 585; mul 576 1997; mul 518 1998; mul 416 652; sub 2000 713; mul 704 2001; mul 652 2002; add 1999 2003;
mul 417 2004; input p 179; add 2005 2006; mul 145 2007; mul 585 1998; mul 713 2002; add 2009 2010; sub 2008 2011;
add 1995 2012; sign 0; mul 768 2014; mul 0 2015; add 770 2016; mul 772 778; mul 778 779; mul 0 778; mul 2019 2020;
sub 2018 2021; add 2017 2022; add 2013 2023; add 793 797; add 794 2025; add 796 2026; mul 68 2027; mul 22 2028; add
2024 2029; mul 91 2030; mul 592 2004; input p 180; add 2032 2033; mul 583 1998; mul 711 2002; add 2035 2036; add
2034 2037; sub 1993 2038; mul 42 2027; mul 22 2040; sub 2039 2041; mul 842 2042; add 2031 2043; mul 619 2004; input
p 181; add 2045 2046; mul 54 2027; mul 22 2048; add 2047 2049; mul 927 2050; add 2044 2051; neg 2052; mul 1039 2042;
mul 842 2030; add 2054 2055; mul 1046 2050; add 2056 2057; mul 927 2030; mul 1046 2042; add 2059 2060; mul 1055
2050; add 2061 2062; neg 2063; mul 571 1997; mul 699 2001; where 1089 1090; where 1098 1099; where 1107 1108; where
1116 1117; mul 26 273; mul 11 273; mul 16 2072; mul 16 24; mul 5 9; mul 14 2075; div 2 14; mul 11 2077; mul 8 2078;
add 2076 2079; mul 2074 2080; sub 2073 2081; mul 23 2082; mul 17 2083; mul 9 9; mul 2075 2085; mul 16 2086; mul 16
17; mul 2080 2088; add 2087 2089; mul 25 2090; sub 2084 2091; mul 2071 2092; mul 3 2078; add 14 2094; mul 16 2095;
mul 16 39; mul 2080 2097; sub 2096 2098; mul 23 2099; mul 17 2100; mul 40 2090; sub 2101 2102; add 31 2103; mul 1120
2104; add 2093 2105; mul 22 2106; mul 18 2090; mul 17 2108; mul 19 2090; add 2109 2110; sub 2107 2111; mul 57 2112;
mul 34 1124; mul 22 2114; mul 46 2115; add 2113 2116; mul 54 2104; mul 34 42; add 2118 2119; mul 22 2120; mul 60
2121; add 2122 2122; sub 2117 2123; mul 90 2124; mul 28 1138; mul 22 2126; mul 62 2127; mul 71 2124; add 2128 2129;
mul 28 42; mul 68 2104; add 2131 2132; add 2092 2133; mul 22 2134; mul 82 2135; mul 57 2135; mul 77 2115; add 2137
2138; mul 80 2121; mul 34 68; add 1129 2141; mul 22 2142; mul 60 2143; add 2140 2144; sub 2139 2145; mul 77 2146;
add 2136 2147; sub 2130 2148; mul 87 2143; mul 60 2135; mul 77 2121; add 2151 2152; mul 80 2112; mul 46 2143; add
2154 2155; sub 2153 2156; mul 80 2157; add 2150 2158; add 2149 2159; mul 1137 2160; sub 2125 2161; mul 840 2162; sub
115 108; add 1181 2164; input p 182; mul 35 151; mul 158 2167; add 2166 2168; mul 35 2167; mul 162 2170; add 2169
2171; mul 151 1192; mul 166 2173; add 2172 2174; mul 35 2173; mul 170 2176; add 2175 2177; mul 156 2173; mul 151
167; add 2179 2180; mul 174 2181; add 2178 2182; mul 149 151; mul 189 2184; add 2183 2185; mul 35 2184; mul 193
2187; add 2186 2188; mul 156 2184; mul 151 190; add 2190 2191; mul 197 2192; add 2189 2193; mul 151 202; mul 201
2195; add 2194 2196; input p 183; mul 225 2167; add 2198 2199; mul 228 2170; add 2200 2201; mul 231 2173; add 2202
2203; mul 234 2176; add 2204 2205; mul 237 2181; add 2206 2207; mul 246 2184; add 2208 2209; mul 249 2187; add 2210
2211; mul 252 2192; add 2212 2213; mul 197 2195; add 2214 2215; mul 148 2216; add 2197 2217; mul 146 2218; le 283
281; le 281 283; add 2220 2221; div 2 2222; mul 2220 2223; le 282 3; le 3 282; add 2225 2226; div 2 2227; mul 2225
2228; mul 2224 2229; mul 287 2230; mul 292 2230; mul 291 2230; mul 284 2233; add 2232 2234; add 2231 2235; mul 297
2230; mul 296 2230; mul 295 2230; mul 284 2239; add 2238 2240; mul 284 2241; add 2237 2242; add 2236 2243; mul 310
2230; mul 303 2245; add 2244 2246; mul 315 2230; mul 314 2230; mul 284 2249; add 2248 2250; mul 303 2251; add 2247
2252; mul 327 2230; mul 319 2254; add 2253 2255; mul 302 2254; mul 303 2257; add 2256 2258; mul 146 2259; where 272
2260; add 2219 2261; input p 184; mul 358 2170; add 2263 2264; mul 361 2181; add 2265 2266; mul 370 2187; add 2267
2268; mul 373 2192; add 2269 2270; mul 376 2195; add 2271 2272; input p 185; mul 390 2170; add 2274 2275; mul 393
2176; add 2276 2277; mul 396 2181; add 2278 2279; mul 403 2192; add 2280 2281; mul 373 2195; add 2282 2283; mul 148
2284; add 2273 2285; add 350 2286; mul 347 2287; mul 722 2288; mul 499 2082; mul 496 2099; add 2290 2291; mul 1431
2292; mul 382 2167; mul 35 2170; mul 384 2295; add 2294 2296; mul 431 2173; add 2297 2298; mul 35 2176; mul 434
2300; add 2299 2301; mul 35 2181; mul 438 2303; add 2302 2304; mul 156 2181; mul 151 175; add 2306 2307; mul 442
2308; add 2305 2309; mul 356 2184; add 2310 2311; mul 35 2187; mul 358 2313; add 2312 2314; mul 156 2192; mul 151
198; add 2316 2317; mul 361 2318; add 2315 2319; mul 35 2195; mul 406 2321; add 2320 2322; mul 156 2195; mul 151
203; add 2324 2325; mul 463 2326; add 2323 2327; mul 151 207; mul 411 2329; add 2328 2330; add 477 481; add 475
2332; add 480 2333; mul 105 2334; add 2331 2335; mul 347 2336; mul 496 2082; add 2337 2338; mul 499 2099; sub 2339
2340; mul 1367 2341; add 2293 2342; mul 1434 2343; mul 502 2344; mul 273 2345; mul 1440 2345; mul 516 2347; mul 1438
2348; neg 2349; mul 273 2350; mul 516 2351; mul 521 2349; sub 2352 2353; sub 2346 2354; mul 519 2355; mul 536 2356;
mul 1461 2345; mul 1456 2358; mul 532 2359; mul 530 2360; mul 534 2359; add 2361 2362; mul 524 2363; add 2357 2364;
mul 541 2345; mul 528 2366; mul 543 2345; add 2367 2368; mul 539 2369; sub 2365 2370; mul 502 2371; mul 566 2345;
mul 528 2373; mul 568 2345; add 2374 2375; mul 564 2376; mul 562 2347; mul 515 2378; mul 563 2347; add 2379 2380;
mul 515 2381; mul 1487 2347; add 2382 2383; mul 502 2384; mul 570 2385; sub 2377 2386; mul 559 2387; add 2372 2388;
mul 574 2387; mul 571 2390; mul 575 2387; add 2391 2392; mul 624 2393; mul 577 2292; sub 2338 2340; mul 508 2396;
add 2395 2397; mul 579 2341; mul 501 2292; add 2399 2400; sub 2398 2401; mul 517 2402; mul 502 2349; mul 581 2404;
sub 2403 2405; mul 17 2406; mul 582 2090; sub 2407 2408; mul 131 2409; mul 517 2292; mul 508 2404; sub 2411 2412;
mul 0 2413; sub 2410 2414; mul 517 2341; mul 501 2404; sub 2416 2417; mul 622 2418; mul 588 2288; mul 151 2284; add
476 2421; mul 347 2422; mul 131 2423; add 2420 2424; input p 186; mul 602 2170; add 2426 2427; mul 390 2176; add
2428 2429; mul 438 2181; add 2430 2431; mul 609 2187; add 2432 2433; mul 406 2195; add 2434 2435; mul 154 2284; add
2436 2437; add 479 2438; mul 347 2439; mul 620 2440; add 2425 2441; mul 518 2442; add 2419 2443; add 2415 2444; mul
576 2445; add 2394 2446; add 2389 2447; mul 518 2448; mul 626 2418; add 2449 2450; mul 630 2099; mul 633 2082; sub
2452 2453; mul 1552 2454; mul 630 2082; add 2337 2456; mul 633 2099; add 2457 2458; mul 1550 2459; add 2455 2460;
mul 1555 2461; mul 636 2462; mul 273 2463; mul 1561 2463; mul 650 2465; mul 1559 2466; neg 2467; mul 273 2468; mul
650 2469; mul 655 2467; sub 2470 2471; sub 2464 2472; mul 653 2473; mul 667 2474; mul 1582 2463; mul 1577 2476; mul
663 2477; mul 661 2478; mul 665 2477; add 2479 2480; mul 658 2481; add 2475 2482; mul 672 2463; mul 659 2484; mul
674 2463; add 2485 2486; mul 670 2487; sub 2483 2488; mul 636 2489; mul 566 2463; mul 659 2491; mul 696 2463; add
2492 2493; mul 694 2494; mul 692 2465; mul 649 2496; mul 693 2465; add 2497 2498; mul 649 2499; mul 1608 2465; add
2500 2501; mul 636 2502; mul 698 2503; sub 2495 2504; mul 690 2505; add 2490 2506; mul 702 2505; mul 699 2508; mul
703 2505; add 2509 2510; mul 717 2511; mul 705 2454; add 2456 2458; mul 642 2514; add 2513 2515; mul 707 2459; sub
2453 2452; mul 635 2518; add 2517 2519; add 2516 2520; mul 651 2521; mul 636 2467; mul 709 2523; sub 2522 2524; mul
17 2525; mul 710 2090; sub 2526 2527; mul 131 2528; mul 651 2454; mul 642 2523; sub 2530 2531; mul 0 2532; sub 2529
2533; mul 651 2459; mul 635 2523; sub 2535 2536; mul 622 2537; mul 652 2442; add 2538 2539; add 2534 2540; mul 704
2541; add 2512 2542; add 2507 2543; mul 652 2544; mul 719 2537; add 2545 2546; add 2451 2547; mul 417 2548; sub 2289
2549; sub 2262 2550; mul 145 2551; mul 585 2448; mul 626 2413; add 2553 2554; mul 713 2544; mul 719 2532; add 2556
2557; add 2555 2558; sub 2552 2559; sub 2165 2560; mul 17 2082; mul 24 2090; sub 2562 2563; mul 17 2564; mul 813
2090; sub 2565 2566; mul 824 2099; mul 3 2090; sub 17 2569; mul 823 2570; mul 817 818; mul 5 273; mul 2572 2573; mul
821 822; mul 3 273; sub 2573 2576; mul 2575 2577; add 2574 2578; mul 815 2579; sub 2571 2580; mul 39 2581; add 2568
2582; sub 2567 2583; mul 23 2584; mul 828 2585; mul 68 2586; add 1712 2587; mul 824 2082; mul 24 2581; add 2589
2590; mul 17 2099; mul 39 2090; sub 2592 2593; mul 17 2594; mul 833 2090; sub 2595 2596; add 2591 2597; mul 23 2598;
mul 828 2599; sub 2588 2600; mul 22 2601; sub 2561 2602; mul 91 2603; add 2163 2604; mul 90 2146; mul 1668 2160; sub
2606 2607; mul 924 2608; mul 910 2099; mul 17 2610; mul 911 2090; sub 2611 2612; mul 151 2216; mul 146 2614; mul 273
2230; mul 854 2616; mul 851 2230; mul 859 2618; add 2617 2619; mul 862 2616; mul 859 2230; mul 851 2622; add 2621
2623; add 2620 2624; mul 284 2618; mul 857 2230; add 2626 2627; mul 866 2628; add 2625 2629; mul 869 2618; mul 866
2230; mul 857 2632; add 2631 2633; add 2630 2634; mul 872 2616; mul 869 2230; mul 284 2632; add 2637 2638; mul 851
2639; add 2636 2640; add 2635 2641; mul 302 2230; mul 291 2643; add 2642 2644; mul 302 2233; add 2645 2646; mul 284
2643; mul 877 2230; add 2648 2649; mul 295 2650; add 2647 2651; mul 296 2643; mul 877 2239; add 2653 2654; add 2652
2655; mul 302 2241; add 2656 2657; mul 319 2230; mul 314 2659; add 2658 2660; mul 319 2249; add 2661 2662; mul 146
2663; where 846 2664; add 2615 2665; mul 722 2423; mul 592 2548; sub 2667 2668; sub 2666 2669; mul 583 2448; mul 626
2409; add 2671 2672; mul 711 2544; mul 719 2528; add 2674 2675; add 2673 2676; add 2670 2677; add 119 2678; sub 2613
2679; mul 830 2104; mul 42 2586; add 2681 2682; mul 837 2092; mul 26 2600; add 2684 2685; sub 2683 2686; mul 22
2687; mul 19 2581; mul 824 2108; sub 2689 2690; mul 828 2691; sub 2688 2692; sub 2680 2693; mul 842 2694; add 2609
2695; sub 2605 2696; mul 90 2157; mul 1719 2160; sub 2698 2699; mul 1033 2700; input p 187; mul 938 2167; add 2702
2703; mul 941 2170; add 2704 2705; mul 944 2173; add 2706 2707; mul 228 2176; add 2708 2709; mul 949 2181; add 2710
2711; mul 158 2184; add 2712 2713; mul 954 2187; add 2714 2715; mul 170 2192; add 2716 2717; mul 258 2195; add 2718
2719; mul 154 2216; add 2720 2721; mul 146 2722; mul 276 2230; mul 276 2724; mul 847 2725; mul 848 2724; add 2726
2727; mul 849 2230; add 2728 2729; mul 276 2618; mul 852 2731; add 2730 2732; mul 853 2618; add 2733 2734; mul 858
2628; add 2735 2736; mul 276 2643; mul 285 2738; add 2737 2739; mul 286 2643; add 2740 2741; mul 290 2650; add 2742
2743; mul 309 2659; add 2744 2745; mul 146 2746; where 970 2747; add 2723 2748; mul 722 2440; mul 619 2548; sub 2750
2751; sub 2749 2752; mul 34 830; mul 54 2586; add 2754 2755; mul 22 2756; add 2753 2757; mul 927 2758; add 2701
2759; sub 2697 2760; mul 57 2127; mul 71 2115; add 2762 2763; mul 80 2143; add 2765 2765; sub 2764 2766; mul 90
2767; mul 1857 2160; sub 2768 2769; mul 924 2770; mul 1039 2694; add 2771 2772; mul 840 2608; mul 842 2603; add 2774
2775; sub 2773 2776; mul 60 2127; mul 71 2121; add 2778 2779; mul 77 2143; mul 80 2135; add 2781 2782; sub 2780
2783; mul 90 2784; mul 1875 2160; sub 2785 2786; mul 1033 2787; mul 1046 2758; add 2788 2789; add 2777 2790; mul 840
2700; mul 927 2603; add 2792 2793; mul 924 2787; mul 1046 2694; add 2795 2796; sub 2794 2797; mul 46 2127; mul 71
2112; add 2799 2800; mul 77 2135; add 2802 2802; sub 2801 2803; mul 90 2804; mul 1938 2160; sub 2805 2806; mul 1033
2807; mul 1055 2758; add 2808 2809; sub 2798 2810; mul 624 2387; mul 571 2445; add 2812 2813; mul 717 2505; mul 699
2541; add 2815 2816; mul 518 592; add 583 2818; mul 576 2819; mul 518 2820; mul 592 652; add 711 2822; mul 704 2823;
mul 652 2824; add 2821 2825; mul 417 2826; input p 188; add 2827 2828; mul 145 2829; mul 585 2820; mul 713 2824; add
2831 2832; sub 2830 2833; sub 1993 2834; add 800 803; add 799 2836; add 802 2837; mul 131 273; mul 827 2839; add
2838 2840; mul 68 2841; mul 836 2839; sub 2842 2843; mul 22 2844; sub 2835 2845; mul 91 2846; mul 592 2826; input p
189; add 2848 2849; mul 583 2820; mul 711 2824; add 2851 2852; add 2850 2853; add 130 2854; mul 42 2841; mul 26
2843; sub 2856 2857; mul 22 2858; mul 921 2839; sub 2859 2860; add 2855 2861; mul 842 2862; add 2847 2863; mul 619
2826; input p 190; add 2865 2866; mul 54 2841; mul 22 2868; add 2867 2869; mul 927 2870; sub 2864 2871; mul 1046
2870; mul 1039 2862; mul 842 2846; add 2874 2875; sub 2873 2876; mul 927 2846; mul 1046 2862; add 2878 2879; mul
1055 2870; sub 2880 2881; mul 571 2819; mul 699 2823; input p 191; where 1089 2885; input p 192; where 1098 2887;
input p 193; where 1107 2889; input p 194; where 1116 2891; mul 34 1120; mul 22 2893; mul 57 2894; mul 52 1124; mul
22 2896; mul 46 2897; add 2895 2898; mul 34 54; mul 42 52; add 2900 2901; mul 22 2902; mul 60 2903; add 2904 2904;
sub 2899 2905; mul 90 2906; mul 48 1138; mul 22 2908; mul 62 2909; mul 71 2906; add 2910 2911; add 1130 2141; mul 22
2913; mul 82 2914; mul 57 2914; mul 77 2897; add 2916 2917; mul 80 2903; mul 52 68; mul 48 54; add 2920 2921; mul 22
2922; mul 60 2923; add 2919 2924; sub 2918 2925; mul 77 2926; add 2915 2927; sub 2912 2928; mul 87 2923; mul 60
2914; mul 77 2903; add 2931 2932; mul 80 2894; mul 46 2923; add 2934 2935; sub 2933 2936; mul 80 2937; add 2930
2938; add 2929 2939; mul 1137 2940; sub 2907 2941; mul 840 2942; input p 195; add 155 156; mul 158 2945; add 2944
2946; mul 35 2945; add 159 2948; mul 162 2949; add 2947 2950; mul 154 1192; mul 166 2952; add 2951 2953; mul 35
2952; add 167 2955; mul 170 2956; add 2954 2957; mul 156 2952; mul 154 167; add 2959 2960; mul 174 2961; add 2958
2962; mul 149 181; add 2963 2964; mul 182 273; mul 185 2966; add 2965 2967; mul 149 154; mul 189 2969; add 2968
2970; mul 35 2969; add 190 2972; mul 193 2973; add 2971 2974; mul 156 2969; mul 154 190; add 2976 2977; mul 197
2978; add 2975 2979; mul 154 202; mul 201 2981; add 2980 2982; mul 35 273; mul 214 2984; add 211 2985; mul 35 2984;
add 215 2987; mul 218 2988; add 2986 2989; input p 196; add 2990 2991; mul 225 2945; add 2992 2993; mul 228 2949;
add 2994 2995; mul 231 2952; add 2996 2997; mul 234 2956; add 2998 2999; mul 237 2961; add 3000 3001; mul 149 158;
add 3002 3003; mul 162 2966; add 3004 3005; mul 246 2969; add 3006 3007; mul 249 2973; add 3008 3009; mul 252 2978;
add 3010 3011; mul 202 258; add 3012 3013; mul 197 2981; add 3014 3015; mul 148 3016; add 2983 3017; mul 146 3018;
le 275 273; le 273 275; add 3020 3021; div 2 3022; mul 3020 3023; le 274 35; le 35 274; add 3025 3026; div 2 3027;
mul 3025 3028; mul 3024 3029; mul 279 3030; mul 278 3030; mul 277 3030; mul 276 3033; add 3032 3034; mul 276 3035;
add 3031 3036; mul 286 3030; mul 285 3030; mul 276 3039; add 3038 3040; mul 284 3041; add 3037 3042; mul 290 3030;
mul 284 3044; mul 284 3045; add 3043 3046; mul 305 3030; mul 304 3030; mul 276 3049; add 3048 3050; mul 303 3051;
add 3047 3052; mul 309 3030; mul 284 3054; mul 303 3055; add 3053 3056; mul 320 3030; mul 319 3058; add 3057 3059;
mul 302 3058; mul 303 3061; add 3060 3062; mul 146 3063; where 272 3064; add 3019 3065; input p 197; mul 358 2949;
add 3067 3068; mul 361 2961; add 3069 3070; mul 367 2966; add 3071 3072; mul 370 2973; add 3073 3074; mul 373 2978;
add 3075 3076; mul 376 2981; add 3077 3078; mul 384 2988; add 382 3080; input p 198; add 3081 3082; mul 390 2949;
add 3083 3084; mul 393 2956; add 3085 3086; mul 396 2961; add 3087 3088; mul 358 2966; add 3089 3090; mul 403 2978;
add 3091 3092; mul 202 406; add 3093 3094; mul 373 2981; add 3095 3096; mul 148 3097; add 3079 3098; add 353 3099;
mul 347 3100; mul 722 3101; mul 35 2988; add 219 3103; mul 422 3104; add 596 3105; mul 382 2945; add 3106 3107; mul
35 2949; add 163 3109; mul 384 3110; add 3108 3111; mul 431 2952; add 3112 3113; mul 35 2956; add 171 3115; mul 434
3116; add 3114 3117; mul 35 2961; add 175 3119; mul 438 3120; add 3118 3121; mul 156 2961; mul 154 175; add 3123
3124; mul 442 3125; add 3122 3126; mul 356 2969; add 3127 3128; mul 35 2973; add 194 3130; mul 358 3131; add 3129
3132; mul 156 2978; mul 154 198; add 3134 3135; mul 361 3136; add 3133 3137; mul 259 273; mul 456 3139; add 3138
3140; mul 35 2981; add 203 3142; mul 406 3143; add 3141 3144; mul 156 2981; mul 154 203; add 3146 3147; mul 463
3148; add 3145 3149; mul 154 207; mul 411 3151; add 3150 3152; add 488 489; add 486 3154; mul 105 3155; add 3153
3156; mul 347 3157; mul 1367 3158; mul 1434 3159; mul 502 3160; mul 273 3161; mul 1440 3161; mul 516 3163; mul 1438
3164; neg 3165; mul 273 3166; mul 516 3167; mul 521 3165; sub 3168 3169; sub 3162 3170; mul 519 3171; mul 536 3172;
mul 1461 3161; mul 1456 3174; mul 532 3175; mul 530 3176; mul 534 3175; add 3177 3178; mul 524 3179; add 3173 3180;
mul 541 3161; mul 528 3182; mul 543 3161; add 3183 3184; mul 539 3185; sub 3181 3186; mul 502 3187; mul 566 3161;
mul 528 3189; mul 568 3161; add 3190 3191; mul 564 3192; mul 562 3163; mul 515 3194; mul 563 3163; add 3195 3196;
mul 515 3197; mul 1487 3163; add 3198 3199; mul 502 3200; mul 570 3201; sub 3193 3202; mul 559 3203; add 3188 3204;
mul 574 3203; mul 571 3206; mul 575 3203; add 3207 3208; mul 624 3209; mul 502 3165; mul 508 3211; mul 0 3212; mul
579 3158; mul 517 3214; mul 581 3211; add 3215 3216; mul 17 3217; mul 131 3218; sub 3213 3219; mul 517 3158; mul 501
3211; sub 3221 3222; mul 622 3223; mul 588 3101; mul 151 3097; add 479 3226; mul 347 3227; mul 131 3228; add 3225
3229; mul 597 2988; add 595 3231; input p 199; add 3232 3233; mul 602 2949; add 3234 3235; mul 390 2956; add 3236
3237; mul 438 2961; add 3238 3239; mul 609 2973; add 3240 3241; mul 202 367; add 3242 3243; mul 406 2981; add 3244
3245; mul 154 3097; add 3246 3247; add 487 3248; mul 347 3249; mul 620 3250; add 3230 3251; mul 518 3252; add 3224
3253; add 3220 3254; mul 576 3255; add 3210 3256; add 3205 3257; mul 518 3258; mul 626 3223; add 3259 3260; mul 1550
3158; mul 1555 3262; mul 636 3263; mul 273 3264; mul 1561 3264; mul 650 3266; mul 1559 3267; neg 3268; mul 273 3269;
mul 650 3270; mul 655 3268; sub 3271 3272; sub 3265 3273; mul 653 3274; mul 667 3275; mul 1582 3264; mul 1577 3277;
mul 663 3278; mul 661 3279; mul 665 3278; add 3280 3281; mul 658 3282; add 3276 3283; mul 672 3264; mul 659 3285;
mul 674 3264; add 3286 3287; mul 670 3288; sub 3284 3289; mul 636 3290; mul 566 3264; mul 659 3292; mul 696 3264;
add 3293 3294; mul 694 3295; mul 692 3266; mul 649 3297; mul 693 3266; add 3298 3299; mul 649 3300; mul 1608 3266;
add 3301 3302; mul 636 3303; mul 698 3304; sub 3296 3305; mul 690 3306; add 3291 3307; mul 702 3306; mul 699 3309;
mul 703 3306; add 3310 3311; mul 717 3312; mul 707 3158; mul 651 3314; mul 636 3268; mul 709 3316; sub 3315 3317;
mul 17 3318; mul 131 3319; mul 642 3316; mul 0 3321; add 3320 3322; mul 651 3158; mul 635 3316; sub 3324 3325; mul
622 3326; mul 652 3252; add 3327 3328; add 3323 3329; mul 704 3330; add 3313 3331; add 3308 3332; mul 652 3333; mul
719 3326; add 3334 3335; add 3261 3336; mul 417 3337; sub 3102 3338; sub 3066 3339; mul 145 3340; mul 585 3258; mul
626 3212; sub 3342 3343; mul 713 3333; mul 719 3321; sub 3345 3346; add 3344 3347; sub 3341 3348; add 1780 3349; mul
91 3350; sub 2943 3351; mul 90 2926; mul 1668 2940; sub 3353 3354; mul 924 3355; mul 151 3016; mul 146 3357; mul 849
3030; mul 848 3030; mul 847 3030; mul 276 3361; add 3360 3362; mul 276 3363; add 3359 3364; mul 853 3030; mul 852
3030; mul 276 3367; add 3366 3368; mul 851 3369; add 3365 3370; mul 858 3030; mul 857 3372; add 3371 3373; mul 284
3372; mul 851 3375; add 3374 3376; mul 302 3041; add 3377 3378; mul 877 3044; add 3379 3380; mul 302 3045; add 3381
3382; mul 319 3054; add 3383 3384; mul 146 3385; where 846 3386; add 3358 3387; mul 722 3228; mul 592 3337; sub 3389
3390; sub 3388 3391; mul 583 3258; mul 626 3218; sub 3393 3394; mul 711 3333; mul 719 3319; add 3396 3397; add 3395
3398; add 3392 3399; mul 22 2754; add 3400 3401; mul 842 3402; sub 3356 3403; sub 3352 3404; mul 90 2937; mul 1719
2940; sub 3406 3407; mul 1033 3408; mul 930 2984; add 928 3410; mul 933 2988; add 3411 3412; input p 200; add 3413
3414; mul 938 2945; add 3415 3416; mul 941 2949; add 3417 3418; mul 944 2952; add 3419 3420; mul 228 2956; add 3421
3422; mul 949 2961; add 3423 3424; mul 158 2969; add 3425 3426; mul 954 2973; add 3427 3428; mul 170 2978; add 3429
3430; mul 185 202; add 3431 3432; mul 258 2981; add 3433 3434; mul 154 3016; add 3435 3436; mul 146 3437; mul 978
3030; mul 276 3439; mul 971 3030; add 3440 3441; mul 973 3442; mul 975 3439; mul 973 3030; mul 971 3445; add 3444
3446; add 3443 3447; mul 273 3030; mul 979 3449; mul 975 3030; mul 276 3445; add 3451 3452; mul 978 3453; add 3450
3454; add 3448 3455; mul 284 3030; mul 276 3457; mul 982 3030; add 3458 3459; mul 847 3460; add 3456 3461; mul 848
3457; mul 982 3361; add 3463 3464; add 3462 3465; mul 284 3363; add 3466 3467; mul 857 3030; mul 852 3469; add 3468
3470; mul 857 3367; add 3471 3472; mul 302 3030; mul 276 3474; mul 997 3030; add 3475 3476; mul 277 3477; add 3473
3478; mul 278 3474; mul 997 3033; add 3480 3481; add 3479 3482; mul 302 3035; add 3483 3484; mul 877 3030; mul 285
3486; add 3485 3487; mul 877 3039; add 3488 3489; mul 319 3030; mul 304 3491; add 3490 3492; mul 319 3049; add 3493
3494; mul 146 3495; where 970 3496; add 3438 3497; mul 722 3250; mul 619 3337; sub 3499 3500; sub 3498 3501; mul 52
830; mul 22 3503; add 3502 3504; mul 927 3505; add 3409 3506; sub 3405 3507; mul 57 2909; mul 71 2897; add 3509
3510; mul 80 2923; add 3512 3512; sub 3511 3513; mul 90 3514; mul 1857 2940; sub 3515 3516; mul 924 3517; mul 1039
3402; sub 3518 3519; mul 840 3355; mul 842 3350; sub 3521 3522; sub 3520 3523; mul 60 2909; mul 71 2903; add 3525
3526; mul 77 2923; mul 80 2914; add 3528 3529; sub 3527 3530; mul 90 3531; mul 1875 2940; sub 3532 3533; mul 1033
3534; mul 1046 3505; add 3535 3536; add 3524 3537; mul 840 3408; mul 927 3350; sub 3539 3540; mul 924 3534; mul 1046
3402; sub 3542 3543; sub 3541 3544; mul 46 2909; mul 71 2894; add 3546 3547; mul 77 2914; add 3549 3549; sub 3548
3550; mul 90 3551; mul 1938 2940; sub 3552 3553; mul 1033 3554; mul 1055 3505; add 3555 3556; sub 3545 3557; mul 624
3203; mul 571 3255; add 3559 3560; mul 717 3306; mul 699 3330; add 3562 3563; mul 518 619; mul 576 3565; mul 518
3566; mul 619 652; mul 704 3568; mul 652 3569; add 3567 3570; mul 592 3571; input p 201; add 3572 3573; mul 583
3566; mul 711 3569; add 3575 3576; add 3574 3577; add 809 810; add 808 3579; mul 42 3580; mul 22 3581; add 3578
3582; mul 842 3583; mul 417 3571; input p 202; add 3585 3586; mul 145 3587; mul 585 3566; mul 713 3569; add 3589
3590; sub 3588 3591; mul 68 3580; mul 22 3593; add 3592 3594; mul 91 3595; sub 3584 3596; mul 619 3571; input p 203;
add 3598 3599; mul 54 3580; mul 22 3601; add 3600 3602; mul 927 3603; sub 3597 3604; mul 842 3595; mul 1039 3583;
sub 3606 3607; mul 1046 3603; add 3608 3609; mul 1046 3583; mul 927 3595; sub 3611 3612; mul 1055 3603; sub 3613
3614; mul 571 3565; mul 699 3568; mul 549 571; mul 518 3618; mul 592 3619; mul 583 3618; add 3620 3621; mul 842
3622; mul 417 3619; mul 145 3624; mul 585 3618; sub 3625 3626; mul 91 3627; sub 3623 3628; mul 619 3619; mul 927
3630; sub 3629 3631; mul 842 3627; mul 1039 3622; sub 3633 3634; mul 1046 3630; add 3635 3636; mul 1046 3622; mul
927 3627; sub 3638 3639; mul 1055 3630; sub 3640 3641; input p 204; mul 680 699; mul 652 3644; mul 592 3645; mul 711
3644; add 3646 3647; mul 842 3648; mul 417 3645; mul 145 3650; mul 713 3644; sub 3651 3652; mul 91 3653; sub 3649
3654; mul 619 3645; mul 927 3656; sub 3655 3657; mul 842 3653; mul 1039 3648; sub 3659 3660; mul 1046 3656; add 3661
3662; mul 1046 3648; mul 927 3653; sub 3664 3665; mul 1055 3656; sub 3666 3667; mul 552 571; mul 518 3669; mul 592
3670; mul 583 3669; add 3671 3672; mul 842 3673; mul 417 3670; mul 145 3675; mul 585 3669; sub 3676 3677; mul 91
3678; sub 3674 3679; mul 619 3670; mul 927 3681; sub 3680 3682; mul 842 3678; mul 1039 3673; sub 3684 3685; mul 1046
3681; add 3686 3687; mul 1046 3673; mul 927 3678; sub 3689 3690; mul 1055 3681; sub 3691 3692; input p 205; mul 683
699; mul 652 3695; mul 592 3696; mul 711 3695; add 3697 3698; mul 842 3699; mul 417 3696; mul 145 3701; mul 713
3695; sub 3702 3703; mul 91 3704; sub 3700 3705; mul 619 3696; mul 927 3707; sub 3706 3708; mul 842 3704; mul 1039
3699; sub 3710 3711; mul 1046 3707; add 3712 3713; mul 1046 3699; mul 927 3704; sub 3715 3716; mul 1055 3707; sub
3717 3718; mul 556 571; mul 518 3720; mul 592 3721; mul 583 3720; add 3722 3723; mul 842 3724; mul 417 3721; mul 145
3726; mul 585 3720; sub 3727 3728; mul 91 3729; sub 3725 3730; mul 619 3721; mul 927 3732; sub 3731 3733; mul 842
3729; mul 1039 3724; sub 3735 3736; mul 1046 3732; add 3737 3738; mul 1046 3724; mul 927 3729; sub 3740 3741; mul
1055 3732; sub 3742 3743; input p 206; mul 687 699; mul 652 3746; mul 592 3747; mul 711 3746; add 3748 3749; mul 842
3750; mul 417 3747; mul 145 3752; mul 713 3746; sub 3753 3754; mul 91 3755; sub 3751 3756; mul 619 3747; mul 927
3758; sub 3757 3759; mul 842 3755; mul 1039 3750; sub 3761 3762; mul 1046 3758; add 3763 3764; mul 1046 3750; mul
927 3755; sub 3766 3767; mul 1055 3758; sub 3768 3769; mul 91 783; mul 783 842; neg 3772; mul 783 927; input p 207;
mul 91 787; mul 787 842; neg 3777; mul 787 927; input p 208; input p 209; mul 842 3781; mul 91 752; sub 3782 3783;
mul 752 842; mul 1039 3781; sub 3785 3786; mul 1046 3781; mul 752 927; sub 3788 3789; input p 210; mul 842 3791; mul
91 755; sub 3792 3793; mul 755 842; mul 1039 3791; sub 3795 3796; mul 1046 3791; mul 755 927; sub 3798 3799; input p
211; mul 842 3801; mul 91 759; sub 3802 3803; mul 759 842; mul 1039 3801; sub 3805 3806; mul 1046 3801; mul 759 927;
sub 3808 3809; input p 212; mul 842 3811; mul 91 763; sub 3812 3813; mul 763 842; mul 1039 3811; sub 3815 3816; mul
1046 3811; mul 763 927; sub 3818 3819; mul 103 110; add 93 3821; mul 101 122; sub 3822 3823; mul 538 545; mul 502
3825; mul 585 3826; mul 518 3826; mul 417 3828; mul 145 3829; sub 3827 3830; sub 3824 3831; mul 91 3832; mul 592
3828; mul 583 3826; add 3834 3835; add 122 3836; mul 842 3837; sub 3833 3838; mul 619 3828; mul 927 3840; add 3839
3841; mul 1039 3837; mul 842 3832; sub 3843 3844; mul 1046 3840; sub 3845 3846; mul 927 3832; mul 1046 3837; sub
3848 3849; mul 1055 3840; add 3850 3851; mul 103 113; add 97 3853; mul 101 125; sub 3854 3855; mul 669 676; mul 636
3857; mul 713 3858; mul 652 3858; mul 417 3860; mul 145 3861; sub 3859 3862; sub 3856 3863; mul 91 3864; mul 592
3860; mul 711 3858; add 3866 3867; add 125 3868; mul 842 3869; sub 3865 3870; mul 619 3860; mul 927 3872; add 3871
3873; mul 1039 3869; mul 842 3864; sub 3875 3876; mul 1046 3872; sub 3877 3878; mul 927 3864; mul 1046 3869; sub
3880 3881; mul 1055 3872; add 3882 3883; neg 842; neg 1793; neg 1947; neg 1887; neg 1890; neg 1806; neg 1957; neg
1897; neg 1814; neg 1963; neg 1818; neg 1966; neg 1907; neg 1910; neg 1837; neg 1977; neg 1917; neg 1920; store f 0
0; store f 1 1035; store f 2 131; store f 3 1048; store f 4 620; store f 5 1057; store f 6 1061; store f 7 1064;
store f 8 1067; store f 9 1069; store f 10 1072; store f 11 1074; store f 12 1076; store f 13 1078; store f 14 1092;
store f 15 1101; store f 16 1110; store f 17 1119; store a 18 1849; store a 54 1923; store a 90 1986; store a 108
1989; store a 126 1992; store a 144 1989; store a 162 1992; store a 180 1989; store a 198 1992; store a 216 1075;
store a 234 1077; store a 1 2; store a 19 2053; store a 55 2058; store a 91 2064; store a 109 2065; store a 127
2066; store a 145 2065; store a 163 2066; store a 181 2065; store a 199 2066; store a 253 2067; store a 271 2068;
store a 289 2069; store a 307 2070; store a 20 2761; store a 56 2791; store a 92 2811; store a 110 2814; store a 128
2817; store a 146 2814; store a 164 2817; store a 182 2814; store a 200 2817; store a 21 2872; store a 39 2; store a
57 2877; store a 93 2882; store a 111 2883; store a 129 2884; store a 147 2883; store a 165 2884; store a 183 2883;
store a 201 2884; store a 255 2886; store a 273 2888; store a 291 2890; store a 309 2892; store a 22 3508; store a
58 3538; store a 94 3558; store a 112 3561; store a 130 3564; store a 148 3561; store a 166 3564; store a 184 3561;
store a 202 3564; store a 23 3605; store a 59 3610; store a 77 2; store a 95 3615; store a 113 3616; store a 131
3617; store a 149 3616; store a 167 3617; store a 185 3616; store a 203 3617; store a 24 3632; store a 60 3637;
store a 96 3642; store a 114 3643; store a 25 3658; store a 61 3663; store a 97 3668; store a 133 3643; store a 26
3683; store a 62 3688; store a 98 3693; store a 152 3694; store a 27 3709; store a 63 3714; store a 99 3719; store a
171 3694; store a 28 3734; store a 64 3739; store a 100 3744; store a 190 3745; store a 29 3760; store a 65 3765;
store a 101 3770; store a 209 3745; store a 30 3771; store a 66 3773; store a 102 3774; store a 228 3775; store a 31
3776; store a 67 3778; store a 103 3779; store a 247 3780; store a 32 3784; store a 68 3787; store a 104 3790; store
a 33 3794; store a 69 3797; store a 105 3800; store a 34 3804; store a 70 3807; store a 106 3810; store a 35 3814;
store a 71 3817; store a 107 3820; store b 2 3842; store b 6 3847; store b 10 3852; store b 3 3874; store b 7 3879;
store b 11 3884; store by_c 13 91; store by_c 39 3885; store by_c 65 927; store by_c 14 3886; store by_c 40 1883;
store by_c 66 3887; store by_c 15 1797; store by_c 41 3888; store by_c 67 1950; store by_c 16 1801; store by_c 42
3889; store by_c 68 1953; store by_c 17 3890; store by_c 43 1894; store by_c 69 3891; store by_c 18 1810; store by_c
44 3892; store by_c 70 1960; store by_c 19 3893; store by_c 45 1900; store by_c 71 3894; store by_c 20 3895; store
by_c 46 1903; store by_c 72 3896; store by_c 21 1828; store by_c 47 3897; store by_c 73 1970; store by_c 22 1832;
store by_c 48 3898; store by_c 74 1973; store by_c 23 3899; store by_c 49 1914; store by_c 75 3900; store by_c 24
1841; store by_c 50 3901; store by_c 76 1980; store by_c 25 1845; store by_c 51 3902; store by_c 77 1983
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
214; abs 95; constant 0.35; lt 216 217; constant 2.0; constant -2.0; max 220 34; min 219 221; input p 52; mul 222
223; mul 222 224; mul 222 225; constant 0.6; constant -0.6; max 228 2; min 227 229; input p 53; mul 222 231; mul 222
232; mul 230 233; add 226 234; input p 54; mul 222 236; mul 230 237; mul 230 238; add 235 239; input p 55; mul 230
241; mul 230 242; mul 230 243; add 240 244; constant -0.35; max 246 95; min 217 247; mul 219 248; input p 56; mul
222 250; mul 222 251; mul 249 252; add 245 253; input p 57; mul 222 255; mul 230 256; mul 249 257; add 254 258;
input p 58; mul 230 260; mul 230 261; mul 249 262; add 259 263; mul 248 248; input p 59; mul 222 266; mul 265 267;
add 264 268; mul 248 267; mul 249 270; add 269 271; input p 60; mul 230 273; mul 265 274; add 272 275; mul 248 274;
mul 249 277; add 276 278; mul 248 265; input p 61; mul 280 281; add 279 282; mul 248 281; mul 265 284; add 283 285;
mul 248 284; mul 249 287; add 286 288; mul 92 289; where 218 290; add 215 291; input p 62; input p 63; mul 95 294;
input p 64; mul 2 296; add 295 297; input p 65; mul 34 299; add 298 300; constant -0.09999999999999995; mul 102 302;
input p 66; mul 109 304; add 303 305; input p 67; mul 121 307; add 306 308; constant 1.2; mul 95 310; add 309 311;
input p 68; mul 132 313; add 312 314; input p 69; mul 140 316; add 315 317; input p 70; mul 144 319; add 318 320;
input p 71; mul 149 322; add 321 323; input p 72; mul 153 325; add 324 326; constant -0.033333333333333326; mul 34
328; input p 73; mul 165 330; add 329 331; constant 0.13333333333333333; mul 102 333; add 332 334; input p 74; mul
109 336; add 335 337; input p 75; mul 117 339; add 338 340; input p 76; mul 121 342; add 341 343; mul 95 302; add
344 345; mul 132 304; add 346 347; input p 77; mul 144 349; add 348 350; input p 78; mul 205 352; add 351 353; mul
149 319; add 354 355; input p 79; mul 153 357; add 356 358; mul 94 359; add 327 360; add 301 361; mul 293 362; input
p 80; input p 81; constant 0.009523809523809514; mul 161 366; input p 82; mul 34 165; mul 368 369; add 367 370; mul
105 328; add 371 372; mul 34 109; mul 330 374; add 373 375; constant 0.06666666666666667; mul 113 377; add 376 378;
input p 83; mul 34 117; mul 380 381; add 379 382; input p 84; mul 34 121; mul 384 385; add 383 386; input p 85; mul
102 121; mul 388 389; add 387 390; mul 136 302; add 391 392; mul 34 140; mul 304 394; add 393 395; mul 102 144; mul
307 397; add 396 398; mul 148 227; add 399 400; input p 86; mul 34 205; mul 402 403; add 401 404; mul 34 149; mul
352 406; add 405 407; input p 87; mul 102 149; mul 409 410; add 408 411; mul 102 153; mul 357 413; add 412 414;
input p 88; mul 95 153; mul 416 417; add 415 418; constant 0.5; mul 95 301; mul 95 296; input p 89; mul 2 423; add
422 424; input p 90; mul 34 426; add 425 427; mul 2 428; add 421 429; mul 95 299; mul 2 426; add 431 432; input p
91; mul 34 434; add 433 435; mul 34 436; add 430 437; mul 420 438; add 419 439; mul 293 440; add 365 441; input p
92; mul 23 443; add 442 444; input p 93; mul 38 446; sub 445 447; input p 94; mul 23 446; input p 95; sub 450 451;
mul 38 443; add 452 453; sub 454 28; mul 455 455; mul 448 448; add 456 457; sqrt 458; mul 449 459; sqrt 460; div 1
461; mul 462 462; mul 449 463; mul 448 464; input p 96; mul 219 460; mul 219 463; mul 463 468; sub 467 469; mul 466
470; constant 0.3; constant -0.3; constant 1.4; sub 460 474; max 473 475; min 472 476; input p 97; input p 98; mul
477 479; add 478 480; mul 477 481; add 1 482; mul 471 483; input u 0; input p 99; mul 485 486; input p 100; input p
101; mul 475 489; add 488 490; mul 475 491; add 1 492; mul 487 493; sub 484 494; mul 449 495; input p 102; input x
6; mul 497 498; input p 103; input x 8; mul 500 501; add 499 502; input p 104; input x 10; mul 504 505; add 503 506;
constant -0.5; mul 462 508; mul 462 509; mul 462 510; mul 449 511; input p 105; input p 106; mul 475 514; add 513
515; mul 475 516; add 1 517; mul 512 518; mul 507 519; add 496 520; input p 107; mul 519 522; mul 519 523; input x
3; sub 444 447; mul 455 526; add 450 453; mul 448 528; sub 527 529; mul 464 530; mul 16 531; mul 525 532; input x 1;
mul 455 464; mul 534 535; sub 533 536; mul 91 534; mul 363 538; mul 97 359; add 428 540; mul 293 541; mul 525 542;
add 539 543; constant 0.01904761904761903; mul 34 545; input p 108; mul 165 547; add 546 548; mul 102 328; add 549
550; input p 109; mul 109 552; add 551 553; mul 117 336; add 554 555; mul 121 384; add 556 557; input p 110; mul 140
559; add 558 560; mul 205 313; add 561 562; mul 149 352; add 563 564; mul 100 359; add 565 566; add 436 567; mul 293
568; input x 5; mul 569 570; add 544 571; mul 465 572; add 537 573; mul 524 574; add 521 575; mul 465 576; input p
111; add 441 578; input p 112; mul 23 580; add 579 581; input p 113; mul 38 583; add 582 584; input p 114; mul 38
580; mul 23 583; input p 115; sub 588 589; sub 587 590; sub 591 28; mul 592 592; mul 585 585; add 593 594; sqrt 595;
mul 586 596; sqrt 597; div 1 598; mul 599 599; mul 586 600; mul 585 601; input p 116; mul 219 597; mul 219 600; mul
600 605; sub 604 606; mul 603 607; sub 597 474; max 473 609; min 472 610; input p 117; input p 118; mul 611 613; add
612 614; mul 611 615; add 1 616; mul 608 617; input u 1; input p 119; mul 619 620; input p 120; input p 121; mul 609
623; add 622 624; mul 609 625; add 1 626; mul 621 627; sub 618 628; mul 586 629; input p 122; input x 7; mul 631
632; input p 123; input x 9; mul 634 635; add 633 636; input p 124; input x 11; mul 638 639; add 637 640; mul 508
599; mul 599 642; mul 599 643; mul 586 644; mul 514 609; add 513 646; mul 609 647; add 1 648; mul 645 649; mul 641
650; add 630 651; input p 125; mul 650 653; mul 650 654; add 581 584; mul 592 656; sub 588 587; mul 585 658; add 657
659; mul 601 660; mul 16 661; mul 525 662; mul 592 601; mul 534 664; sub 663 665; mul 572 602; add 666 667; mul 655
668; add 652 669; mul 602 670; add 577 671; sub 364 672; mul 363 673; sub 292 674; input p 126; constant 12.0; mul
538 677; constant -6.0; mul 94 538; mul 97 525; add 680 681; mul 100 570; add 682 683; mul 679 684; add 678 685; mul
676 686; mul 538 679; constant 4.0; mul 684 689; add 688 690; mul 676 691; mul 94 692; add 687 693; add 675 694; mul
91 695; mul 91 696; mul 90 697; mul 81 89; mul 662 699; mul 90 664; add 700 701; mul 86 89; mul 569 703; mul 542
699; sub 704 705; mul 90 91; mul 363 707; add 706 708; mul 602 709; sub 702 710; mul 655 711; mul 572 712; mul 670
709; sub 713 714; mul 601 715; mul 670 699; mul 525 712; add 717 718; mul 16 719; mul 601 720; mul 658 721; add 716
722; mul 219 585; mul 219 596; div 1 725; mul 668 711; mul 654 727; mul 650 727; mul 653 729; add 728 730; mul 641
711; add 731 732; mul 645 733; mul 647 734; mul 609 734; mul 514 736; add 735 737; mul 586 711; mul 621 739; mul 625
740; sub 738 741; mul 609 740; mul 623 743; sub 742 744; le 473 609; le 609 473; add 746 747; div 1 748; mul 746
749; le 610 472; le 472 610; add 751 752; div 1 753; mul 751 754; mul 608 739; mul 615 756; mul 611 756; mul 613
758; add 757 759; mul 755 760; mul 750 761; add 745 762; mul 219 598; div 1 764; mul 599 644; mul 649 733; mul 586
767; mul 766 768; mul 599 768; mul 644 770; add 769 771; mul 599 770; mul 643 773; add 772 774; mul 219 599; mul 585
715; mul 90 670; mul 534 712; sub 778 779; mul 592 780; add 777 781; mul 660 720; add 782 783; mul 586 784; mul 617
739; mul 603 786; mul 605 787; sub 785 788; mul 600 787; neg 790; mul 219 791; add 789 792; mul 776 793; mul 600
794; add 775 795; mul 765 796; sub 763 797; mul 219 787; add 798 799; mul 586 800; mul 726 801; mul 724 802; add 723
803; sub 698 804; mul 673 703; mul 602 712; mul 532 699; mul 90 535; add 808 809; mul 465 709; sub 810 811; mul 524
812; mul 465 813; add 807 814; mul 570 815; add 806 816; mul 568 817; add 805 818; mul 525 815; mul 673 699; sub 820
821; mul 541 822; add 819 823; mul 91 538; mul 97 699; mul 100 703; sub 826 827; mul 94 707; sub 828 829; mul 676
830; mul 679 831; mul 689 831; mul 676 707; mul 679 834; sub 833 835; mul 94 836; add 832 837; mul 677 834; sub 838
839; mul 363 815; add 840 841; mul 825 842; sub 824 843; mul 673 707; mul 538 815; add 845 846; mul 362 847; add 844
848; mul 572 813; mul 576 709; sub 850 851; mul 464 852; mul 576 699; mul 525 813; add 854 855; mul 16 856; mul 464
857; mul 528 858; sub 853 859; mul 219 448; mul 219 459; div 1 862; mul 574 812; mul 523 864; mul 519 864; mul 522
866; add 865 867; mul 507 812; add 868 869; mul 512 870; mul 516 871; mul 475 871; mul 514 873; add 872 874; mul 449
812; mul 487 876; mul 491 877; sub 875 878; mul 475 877; mul 489 880; sub 879 881; le 473 475; le 475 473; add 883
884; div 1 885; mul 883 886; le 476 472; le 472 476; add 888 889; div 1 890; mul 888 891; mul 471 876; mul 481 893;
mul 477 893; mul 479 895; add 894 896; mul 892 897; mul 887 898; add 882 899; mul 219 461; div 1 901; mul 462 511;
mul 518 870; mul 449 904; mul 903 905; mul 462 905; mul 511 907; add 906 908; mul 462 907; mul 510 910; add 909 911;
mul 219 462; mul 448 852; mul 90 576; mul 534 813; sub 915 916; mul 455 917; add 914 918; mul 530 857; add 919 920;
mul 449 921; mul 483 876; mul 466 923; mul 468 924; sub 922 925; mul 463 924; neg 927; mul 219 928; add 926 929; mul
913 930; mul 463 931; add 912 932; mul 902 933; sub 900 934; mul 219 924; add 935 936; mul 449 937; mul 863 938; mul
861 939; add 860 940; add 804 941; mul 440 942; add 849 943; sub 944 941; mul 91 95; mul 95 219; mul 293 817; mul
352 948; mul 102 949; mul 947 950; mul 92 703; mul 204 952; mul 102 953; mul 947 954; mul 131 952; mul 34 956; mul
947 957; add 955 958; input p 152; mul 952 960; mul 947 961; add 959 962; mul 116 952; mul 102 964; mul 102 965; add
963 966; input p 151; mul 952 968; mul 34 969; mul 102 970; add 967 971; mul 104 952; mul 102 973; add 972 974; sub
951 975; mul 313 948; mul 34 977; mul 947 978; add 976 979; mul 559 948; mul 34 981; mul 102 982; add 980 983; mul
100 948; mul 293 822; mul 97 986; add 985 987; mul 293 847; mul 94 989; add 988 990; mul 357 991; mul 148 992; add
984 993; mul 95 992; mul 947 995; add 994 996; mul 319 991; mul 102 998; mul 947 999; add 997 1000; mul 352 991; mul
34 1002; mul 947 1003; add 1001 1004; mul 349 991; mul 102 1006; mul 102 1007; add 1005 1008; mul 304 991; mul 34
1010; mul 34 1011; add 1009 1012; mul 302 991; add 1013 1014; mul 325 989; mul 148 1016; add 1015 1017; mul 95 1016;
mul 947 1019; add 1018 1020; mul 322 989; mul 102 1022; mul 947 1023; add 1021 1024; mul 319 989; mul 102 1026; mul
102 1027; add 1025 1028; mul 316 989; mul 34 1030; mul 102 1031; add 1029 1032; mul 313 989; mul 34 1034; mul 34
1035; add 1033 1036; mul 310 989; add 1037 1038; mul 293 942; mul 420 1040; mul 34 1041; add 948 1042; mul 299 1043;
add 1039 1044; mul 2 1041; add 986 1046; mul 296 1047; add 1045 1048; mul 301 1041; add 1049 1050; mul 95 1041; add
989 1052; mul 294 1053; add 1051 1054; mul 416 1040; mul 153 1056; add 1055 1057; mul 95 1056; mul 148 1059; add
1058 1060; mul 95 1059; mul 947 1062; add 1061 1063; mul 357 1040; mul 102 1065; mul 148 1066; add 1064 1067; mul 95
1066; mul 947 1069; add 1068 1070; mul 409 1040; mul 102 1072; mul 102 1073; mul 947 1074; add 1071 1075; mul 352
1040; mul 34 1077; mul 102 1078; mul 947 1079; add 1076 1080; mul 402 1040; mul 34 1082; mul 34 1083; mul 947 1084;
add 1081 1085; mul 227 1040; mul 947 1087; add 1086 1088; mul 307 1040; mul 102 1090; mul 102 1091; mul 102 1092;
add 1089 1093; mul 304 1040; mul 34 1095; mul 34 1096; mul 102 1097; add 1094 1098; mul 302 1040; mul 102 1100; add
1099 1101; le 246 95; le 95 246; add 1103 1104; div 1 1105; mul 1103 1106; le 247 217; le 217 247; add 1108 1109;
div 1 1110; mul 1108 1111; abs 34; lt 1113 219; mul 266 952; mul 265 1115; mul 251 952; mul 250 952; mul 222 1118;
add 1117 1119; mul 249 1120; add 1116 1121; mul 232 952; mul 231 952; mul 222 1124; add 1123 1125; mul 230 1126; add
1122 1127; mul 225 952; add 1128 1129; mul 224 952; mul 223 952; mul 222 1132; add 1131 1133; mul 222 1134; add 1130
1135; neg 1136; where 1114 1137; abs 2; lt 1139 227; mul 92 699; mul 273 1141; mul 265 1142; where 1140 1143; add
1138 1144; mul 261 1141; mul 260 1141; mul 230 1147; add 1146 1148; mul 249 1149; where 1140 1150; add 1145 1151;
mul 255 952; mul 230 1153; neg 1154; where 1114 1155; mul 256 1141; where 1140 1157; add 1156 1158; mul 249 1159;
add 1152 1160; mul 243 1141; where 1140 1162; add 1161 1163; mul 242 1141; mul 241 1141; mul 230 1166; add 1165
1167; mul 230 1168; where 1140 1169; add 1164 1170; mul 238 1141; where 1140 1172; add 1171 1173; mul 236 952; mul
230 1175; neg 1176; where 1114 1177; mul 237 1141; where 1140 1179; add 1178 1180; mul 230 1181; add 1174 1182; mul
233 1141; where 1140 1184; add 1183 1185; mul 92 707; mul 249 1187; mul 284 1188; neg 1189; where 218 1190; add 1186
1191; mul 287 1187; neg 1193; mul 219 1194; where 218 1195; add 1192 1196; mul 248 1188; mul 265 1187; add 1198
1199; mul 281 1200; neg 1201; where 218 1202; add 1197 1203; mul 281 1187; mul 265 1205; neg 1206; where 218 1207;
add 1204 1208; mul 284 1187; mul 248 1205; add 1210 1211; mul 249 1212; neg 1213; where 218 1214; add 1209 1215; mul
274 1188; neg 1217; where 218 1218; add 1216 1219; mul 277 1187; neg 1221; mul 219 1222; where 218 1223; add 1220
1224; mul 248 1142; where 1140 1226; mul 274 1187; neg 1228; where 218 1229; add 1227 1230; mul 249 1231; add 1225
1232; mul 267 1188; neg 1234; where 218 1235; add 1233 1236; mul 270 1187; neg 1238; mul 219 1239; where 218 1240;
add 1237 1241; mul 248 1115; neg 1243; where 1114 1244; mul 267 1187; neg 1246; where 218 1247; add 1245 1248; mul
249 1249; add 1242 1250; mul 262 1187; neg 1252; mul 219 1253; where 218 1254; add 1251 1255; mul 257 1187; neg
1257; mul 219 1258; where 218 1259; add 1256 1260; mul 252 1187; neg 1262; mul 219 1263; where 218 1264; add 1261
1265; mul 1112 1266; mul 1107 1267; add 1102 1268; mul 97 1141; mul 100 952; sub 1270 1271; mul 94 1187; sub 1272
1273; mul 210 1274; mul 148 1275; add 1269 1276; mul 95 1275; mul 947 1278; add 1277 1279; mul 143 1274; mul 102
1281; mul 947 1282; add 1280 1283; mul 204 1274; mul 34 1285; mul 947 1286; add 1284 1287; mul 201 1274; mul 947
1289; add 1288 1290; mul 198 1274; mul 102 1292; mul 102 1293; add 1291 1294; mul 195 1274; mul 34 1296; mul 102
1297; add 1295 1298; mul 192 1274; mul 102 1300; add 1299 1301; mul 108 1274; mul 34 1303; mul 34 1304; add 1302
1305; mul 104 1274; mul 34 1307; add 1306 1308; mul 93 1274; add 1309 1310; mul 152 1187; mul 148 1312; sub 1311
1313; mul 95 1312; mul 947 1315; sub 1314 1316; mul 147 1187; mul 102 1318; mul 947 1319; sub 1317 1320; mul 143
1187; mul 102 1322; mul 102 1323; sub 1321 1324; mul 139 1187; mul 34 1326; mul 102 1327; sub 1325 1328; mul 135
1187; mul 102 1330; sub 1329 1331; mul 131 1187; mul 34 1333; mul 34 1334; sub 1332 1335; mul 127 1187; mul 34 1337;
sub 1336 1338; mul 124 1187; sub 1339 1340; mul 148 949; mul 148 953; mul 136 964; add 1343 1344; mul 95 965; add
1345 1346; mul 95 970; add 1347 1348; mul 95 973; add 1349 1350; input p 150; mul 952 1352; mul 113 1353; add 1351
1354; mul 102 219; mul 102 1353; mul 1356 1357; add 1355 1358; mul 174 952; mul 34 1360; mul 1356 1361; add 1359
1362; input p 149; mul 952 1364; mul 1356 1365; add 1363 1366; input p 148; mul 952 1368; mul 34 1369; mul 34 1370;
add 1367 1371; input p 147; mul 952 1373; mul 34 1374; add 1372 1375; mul 157 952; add 1376 1377; sub 1342 1378; mul
95 982; add 1379 1380; mul 384 948; mul 113 1382; add 1381 1383; mul 102 1382; mul 1356 1385; add 1384 1386; mul 336
948; mul 34 1388; mul 1356 1389; add 1387 1390; mul 552 948; mul 34 1392; mul 34 1393; add 1391 1394; mul 328 948;
add 1395 1396; mul 148 998; add 1397 1398; mul 136 1006; add 1399 1400; mul 95 1007; add 1401 1402; mul 342 991; mul
113 1404; add 1403 1405; mul 102 1404; mul 1356 1407; add 1406 1408; mul 339 991; mul 34 1410; mul 1356 1411; add
1409 1412; mul 336 991; mul 34 1414; mul 34 1415; add 1413 1416; mul 333 991; add 1417 1418; mul 148 1022; add 1419
1420; mul 136 1026; add 1421 1422; mul 95 1027; add 1423 1424; mul 95 1031; add 1425 1426; mul 307 989; mul 113
1428; add 1427 1429; mul 102 1428; mul 1356 1431; add 1430 1432; mul 304 989; mul 34 1434; mul 34 1435; add 1433
1436; mul 302 989; add 1437 1438; mul 153 1065; add 1439 1440; mul 149 1072; add 1441 1442; mul 148 1073; add 1443
1444; mul 148 1078; add 1445 1446; mul 144 1090; add 1447 1448; mul 136 1091; add 1449 1450; mul 95 1092; add 1451
1452; mul 95 1097; add 1453 1454; mul 95 1100; add 1455 1456; mul 388 1040; mul 121 1458; add 1457 1459; mul 102
1458; mul 113 1461; add 1460 1462; mul 102 1461; mul 1356 1464; add 1463 1465; mul 384 1040; mul 34 1467; mul 113
1468; add 1466 1469; mul 102 1468; mul 1356 1471; add 1470 1472; mul 380 1040; mul 34 1474; mul 34 1475; mul 1356
1476; add 1473 1477; mul 377 1040; mul 1356 1479; add 1478 1480; mul 330 1040; mul 34 1482; mul 34 1483; mul 34
1484; add 1481 1485; mul 328 1040; mul 34 1487; add 1486 1488; mul 148 1281; add 1489 1490; mul 136 1292; add 1491
1492; mul 95 1293; add 1493 1494; mul 95 1297; add 1495 1496; mul 95 1300; add 1497 1498; mul 183 1274; mul 113
1500; add 1499 1501; mul 102 1500; mul 1356 1503; add 1502 1504; mul 180 1274; mul 34 1506; mul 1356 1507; add 1505
1508; mul 177 1274; mul 1356 1510; add 1509 1511; mul 174 1274; mul 34 1513; mul 34 1514; add 1512 1515; mul 171
1274; mul 34 1517; add 1516 1518; mul 168 1274; add 1519 1520; mul 148 1318; sub 1521 1522; mul 136 1322; sub 1523
1524; mul 95 1323; sub 1525 1526; mul 95 1327; sub 1527 1528; mul 95 1330; sub 1529 1530; mul 120 1187; mul 113
1532; sub 1531 1533; mul 102 1532; mul 1356 1535; sub 1534 1536; mul 116 1187; mul 34 1538; mul 1356 1539; sub 1537
1540; mul 112 1187; mul 1356 1542; sub 1541 1543; mul 108 1187; mul 34 1545; mul 34 1546; sub 1544 1547; mul 104
1187; mul 34 1549; sub 1548 1550; mul 93 1187; sub 1551 1552; mul 94 1553; add 1341 1554; mul 946 1555; sub 945
1556; input p 213; input c 4; input p 14; mul 28 1560; sub 2 1561; input c 5; mul 1562 1563; sub 1559 1564; input c
6; mul 485 1566; add 1565 1567; input c 7; mul 619 1569; add 1568 1570; input c 8; input p 15; max 1572 1573; mul
534 1560; sub 525 1575; mul 1574 1576; sub 1571 1577; mul 90 1578; mul 90 1560; add 699 1580; mul 1574 1581; mul 534
1582; add 1579 1583; mul 1563 1581; input c 9; input c 10; mul 420 1587; mul 1562 1588; sub 1586 1589; input c 11;
mul 485 1591; add 1590 1592; input c 12; mul 619 1594; add 1593 1595; mul 90 1596; add 1585 1597; mul 90 1562; mul
1588 1599; sub 1598 1600; mul 28 1601; add 1584 1602; mul 1558 1603; add 1557 1604; mul 56 70; mul 79 79; sub 1606
1607; mul 89 1608; mul 673 1609; mul 662 1609; mul 664 699; add 1611 1612; mul 542 1609; mul 59 70; mul 76 79; sub
1615 1616; mul 89 1617; mul 569 1618; sub 1614 1619; mul 91 699; mul 363 1621; sub 1620 1622; mul 602 1623; add 1613
1624; mul 655 1625; mul 602 1626; mul 532 1609; mul 535 699; add 1628 1629; mul 465 1623; add 1630 1631; mul 524
1632; mul 465 1633; add 1627 1634; mul 525 1635; sub 1610 1636; mul 541 1637; mul 697 699; mul 586 1625; mul 621
1640; mul 625 1641; mul 668 1625; mul 654 1643; mul 650 1643; mul 653 1645; add 1644 1646; mul 641 1625; add 1647
1648; mul 645 1649; mul 647 1650; mul 609 1650; mul 514 1652; add 1651 1653; sub 1642 1654; mul 609 1641; mul 623
1656; add 1655 1657; mul 608 1640; mul 615 1659; mul 611 1659; mul 613 1661; add 1660 1662; mul 755 1663; mul 750
1664; sub 1658 1665; mul 649 1649; mul 586 1667; mul 766 1668; mul 599 1668; mul 644 1670; add 1669 1671; mul 599
1670; mul 643 1673; add 1672 1674; mul 534 1626; sub 1676 717; mul 592 1677; mul 670 1623; mul 572 1626; add 1679
1680; mul 585 1681; sub 1678 1682; mul 670 1609; mul 525 1626; add 1684 1685; mul 16 1686; mul 660 1687; sub 1683
1688; mul 586 1689; mul 617 1640; mul 603 1691; mul 605 1692; add 1690 1693; mul 600 1692; mul 219 1695; add 1694
1696; mul 776 1697; mul 600 1698; sub 1675 1699; mul 765 1700; add 1666 1701; neg 1692; mul 219 1703; add 1702 1704;
mul 586 1705; mul 726 1706; mul 724 1707; mul 601 1681; mul 601 1687; mul 658 1710; add 1709 1711; sub 1708 1712;
add 1639 1713; mul 673 1618; mul 570 1635; add 1715 1716; mul 568 1717; add 1714 1718; sub 1638 1719; mul 100 1618;
mul 97 1609; sub 1721 1722; mul 94 1621; add 1723 1724; mul 676 1725; mul 679 1726; mul 689 1726; mul 676 1621; mul
679 1729; add 1728 1730; mul 94 1731; add 1727 1732; mul 677 1729; add 1733 1734; mul 363 1635; sub 1735 1736; mul
825 1737; sub 1720 1738; mul 673 1621; mul 538 1635; add 1740 1741; mul 362 1742; sub 1739 1743; mul 576 1609; mul
525 1633; add 1745 1746; mul 16 1747; mul 464 1748; mul 528 1749; mul 576 1623; mul 572 1633; add 1751 1752; mul 464
1753; sub 1750 1754; mul 449 1632; mul 487 1756; mul 491 1757; mul 574 1632; mul 523 1759; mul 519 1759; mul 522
1761; add 1760 1762; mul 507 1632; add 1763 1764; mul 512 1765; mul 516 1766; mul 475 1766; mul 514 1768; add 1767
1769; sub 1758 1770; mul 475 1757; mul 489 1772; add 1771 1773; mul 471 1756; mul 481 1775; mul 477 1775; mul 479
1777; add 1776 1778; mul 892 1779; mul 887 1780; sub 1774 1781; mul 518 1765; mul 449 1783; mul 903 1784; mul 462
1784; mul 511 1786; add 1785 1787; mul 462 1786; mul 510 1789; add 1788 1790; mul 534 1633; sub 1792 854; mul 455
1793; mul 448 1753; sub 1794 1795; mul 530 1748; sub 1796 1797; mul 449 1798; mul 483 1756; mul 466 1800; mul 468
1801; add 1799 1802; mul 463 1801; mul 219 1804; add 1803 1805; mul 913 1806; mul 463 1807; sub 1791 1808; mul 902
1809; add 1782 1810; neg 1801; mul 219 1812; add 1811 1813; mul 449 1814; mul 863 1815; mul 861 1816; add 1755 1817;
add 1713 1818; mul 440 1819; add 1744 1820; sub 1821 1818; mul 92 1618; mul 204 1823; mul 102 1824; mul 947 1825;
mul 131 1823; mul 34 1827; mul 947 1828; add 1826 1829; mul 960 1823; mul 947 1831; add 1830 1832; mul 116 1823; mul
102 1834; mul 102 1835; add 1833 1836; mul 968 1823; mul 34 1838; mul 102 1839; add 1837 1840; mul 104 1823; mul 102
1842; add 1841 1843; mul 293 1717; mul 352 1845; mul 102 1846; mul 947 1847; sub 1844 1848; mul 313 1845; mul 34
1850; mul 947 1851; sub 1849 1852; mul 559 1845; mul 34 1854; mul 102 1855; sub 1853 1856; mul 293 1637; mul 97
1858; mul 100 1845; sub 1859 1860; mul 293 1742; mul 94 1862; sub 1861 1863; mul 357 1864; mul 148 1865; add 1857
1866; mul 95 1865; mul 947 1868; add 1867 1869; mul 319 1864; mul 102 1871; mul 947 1872; add 1870 1873; mul 352
1864; mul 34 1875; mul 947 1876; add 1874 1877; mul 349 1864; mul 102 1879; mul 102 1880; add 1878 1881; mul 304
1864; mul 34 1883; mul 34 1884; add 1882 1885; mul 302 1864; add 1886 1887; mul 325 1862; mul 148 1889; sub 1888
1890; mul 95 1889; mul 947 1892; sub 1891 1893; mul 322 1862; mul 102 1895; mul 947 1896; sub 1894 1897; mul 319
1862; mul 102 1899; mul 102 1900; sub 1898 1901; mul 316 1862; mul 34 1903; mul 102 1904; sub 1902 1905; mul 313
1862; mul 34 1907; mul 34 1908; sub 1906 1909; mul 310 1862; sub 1910 1911; mul 293 1819; mul 420 1913; mul 34 1914;
sub 1915 1845; mul 299 1916; add 1912 1917; mul 2 1914; add 1858 1919; mul 296 1920; add 1918 1921; mul 301 1914;
add 1922 1923; mul 95 1914; sub 1925 1862; mul 294 1926; add 1924 1927; mul 416 1913; mul 153 1929; add 1928 1930;
mul 95 1929; mul 148 1932; add 1931 1933; mul 95 1932; mul 947 1935; add 1934 1936; mul 357 1913; mul 102 1938; mul
148 1939; add 1937 1940; mul 95 1939; mul 947 1942; add 1941 1943; mul 409 1913; mul 102 1945; mul 102 1946; mul 947
1947; add 1944 1948; mul 352 1913; mul 34 1950; mul 102 1951; mul 947 1952; add 1949 1953; mul 402 1913; mul 34
1955; mul 34 1956; mul 947 1957; add 1954 1958; mul 227 1913; mul 947 1960; add 1959 1961; mul 307 1913; mul 102
1963; mul 102 1964; mul 102 1965; add 1962 1966; mul 304 1913; mul 34 1968; mul 34 1969; mul 102 1970; add 1967
1971; mul 302 1913; mul 102 1973; add 1972 1974; mul 266 1823; mul 265 1976; mul 251 1823; mul 250 1823; mul 222
1979; add 1978 1980; mul 249 1981; add 1977 1982; mul 232 1823; mul 231 1823; mul 222 1985; add 1984 1986; mul 230
1987; add 1983 1988; mul 225 1823; add 1989 1990; mul 224 1823; mul 223 1823; mul 222 1993; add 1992 1994; mul 222
1995; add 1991 1996; where 1114 1997; mul 92 1609; mul 273 1999; mul 265 2000; neg 2001; where 1140 2002; add 1998
2003; mul 261 1999; mul 260 1999; mul 230 2006; add 2005 2007; mul 249 2008; neg 2009; where 1140 2010; add 2004
2011; mul 255 1823; mul 230 2013; where 1114 2014; mul 256 1999; neg 2016; where 1140 2017; add 2015 2018; mul 249
2019; add 2012 2020; mul 243 1999; neg 2022; where 1140 2023; add 2021 2024; mul 242 1999; mul 241 1999; mul 230
2027; add 2026 2028; mul 230 2029; neg 2030; where 1140 2031; add 2025 2032; mul 238 1999; neg 2034; where 1140
2035; add 2033 2036; mul 236 1823; mul 230 2038; where 1114 2039; mul 237 1999; neg 2041; where 1140 2042; add 2040
2043; mul 230 2044; add 2037 2045; mul 233 1999; neg 2047; where 1140 2048; add 2046 2049; mul 92 1621; mul 249
2051; mul 284 2052; where 218 2053; add 2050 2054; mul 287 2051; mul 219 2056; where 218 2057; add 2055 2058; mul
248 2052; mul 265 2051; add 2060 2061; mul 281 2062; where 218 2063; add 2059 2064; mul 281 2051; mul 265 2066;
where 218 2067; add 2065 2068; mul 284 2051; mul 248 2066; add 2070 2071; mul 249 2072; where 218 2073; add 2069
2074; mul 274 2052; where 218 2076; add 2075 2077; mul 277 2051; mul 219 2079; where 218 2080; add 2078 2081; mul
248 2000; neg 2083; where 1140 2084; mul 274 2051; where 218 2086; add 2085 2087; mul 249 2088; add 2082 2089; mul
267 2052; where 218 2091; add 2090 2092; mul 270 2051; mul 219 2094; where 218 2095; add 2093 2096; mul 248 1976;
where 1114 2098; mul 267 2051; where 218 2100; add 2099 2101; mul 249 2102; add 2097 2103; mul 262 2051; mul 219
2105; where 218 2106; add 2104 2107; mul 257 2051; mul 219 2109; where 218 2110; add 2108 2111; mul 252 2051; mul
219 2113; where 218 2114; add 2112 2115; mul 1112 2116; mul 1107 2117; add 1975 2118; mul 100 1823; mul 97 1999; sub
2120 2121; mul 94 2051; add 2122 2123; mul 210 2124; mul 148 2125; add 2119 2126; mul 95 2125; mul 947 2128; add
2127 2129; mul 143 2124; mul 102 2131; mul 947 2132; add 2130 2133; mul 204 2124; mul 34 2135; mul 947 2136; add
2134 2137; mul 201 2124; mul 947 2139; add 2138 2140; mul 198 2124; mul 102 2142; mul 102 2143; add 2141 2144; mul
195 2124; mul 34 2146; mul 102 2147; add 2145 2148; mul 192 2124; mul 102 2150; add 2149 2151; mul 108 2124; mul 34
2153; mul 34 2154; add 2152 2155; mul 104 2124; mul 34 2157; add 2156 2158; mul 93 2124; add 2159 2160; mul 152
2051; mul 148 2162; add 2161 2163; mul 95 2162; mul 947 2165; add 2164 2166; mul 147 2051; mul 102 2168; mul 947
2169; add 2167 2170; mul 143 2051; mul 102 2172; mul 102 2173; add 2171 2174; mul 139 2051; mul 34 2176; mul 102
2177; add 2175 2178; mul 135 2051; mul 102 2180; add 2179 2181; mul 131 2051; mul 34 2183; mul 34 2184; add 2182
2185; mul 127 2051; mul 34 2187; add 2186 2188; mul 124 2051; add 2189 2190; mul 148 1824; mul 136 1834; add 2192
2193; mul 95 1835; add 2194 2195; mul 95 1839; add 2196 2197; mul 95 1842; add 2198 2199; mul 1352 1823; mul 113
2201; add 2200 2202; mul 102 2201; mul 1356 2204; add 2203 2205; mul 174 1823; mul 34 2207; mul 1356 2208; add 2206
2209; mul 1364 1823; mul 1356 2211; add 2210 2212; mul 1368 1823; mul 34 2214; mul 34 2215; add 2213 2216; mul 1373
1823; mul 34 2218; add 2217 2219; mul 157 1823; add 2220 2221; mul 148 1846; sub 2222 2223; mul 95 1855; sub 2224
2225; mul 384 1845; mul 113 2227; sub 2226 2228; mul 102 2227; mul 1356 2230; sub 2229 2231; mul 336 1845; mul 34
2233; mul 1356 2234; sub 2232 2235; mul 552 1845; mul 34 2237; mul 34 2238; sub 2236 2239; mul 328 1845; sub 2240
2241; mul 148 1871; add 2242 2243; mul 136 1879; add 2244 2245; mul 95 1880; add 2246 2247; mul 342 1864; mul 113
2249; add 2248 2250; mul 102 2249; mul 1356 2252; add 2251 2253; mul 339 1864; mul 34 2255; mul 1356 2256; add 2254
2257; mul 336 1864; mul 34 2259; mul 34 2260; add 2258 2261; mul 333 1864; add 2262 2263; mul 148 1895; sub 2264
2265; mul 136 1899; sub 2266 2267; mul 95 1900; sub 2268 2269; mul 95 1904; sub 2270 2271; mul 307 1862; mul 113
2273; sub 2272 2274; mul 102 2273; mul 1356 2276; sub 2275 2277; mul 304 1862; mul 34 2279; mul 34 2280; sub 2278
2281; mul 302 1862; sub 2282 2283; mul 153 1938; add 2284 2285; mul 149 1945; add 2286 2287; mul 148 1946; add 2288
2289; mul 148 1951; add 2290 2291; mul 144 1963; add 2292 2293; mul 136 1964; add 2294 2295; mul 95 1965; add 2296
2297; mul 95 1970; add 2298 2299; mul 95 1973; add 2300 2301; mul 388 1913; mul 121 2303; add 2302 2304; mul 102
2303; mul 113 2306; add 2305 2307; mul 102 2306; mul 1356 2309; add 2308 2310; mul 384 1913; mul 34 2312; mul 113
2313; add 2311 2314; mul 102 2313; mul 1356 2316; add 2315 2317; mul 380 1913; mul 34 2319; mul 34 2320; mul 1356
2321; add 2318 2322; mul 377 1913; mul 1356 2324; add 2323 2325; mul 330 1913; mul 34 2327; mul 34 2328; mul 34
2329; add 2326 2330; mul 328 1913; mul 34 2332; add 2331 2333; mul 148 2131; add 2334 2335; mul 136 2142; add 2336
2337; mul 95 2143; add 2338 2339; mul 95 2147; add 2340 2341; mul 95 2150; add 2342 2343; mul 183 2124; mul 113
2345; add 2344 2346; mul 102 2345; mul 1356 2348; add 2347 2349; mul 180 2124; mul 34 2351; mul 1356 2352; add 2350
2353; mul 177 2124; mul 1356 2355; add 2354 2356; mul 174 2124; mul 34 2358; mul 34 2359; add 2357 2360; mul 171
2124; mul 34 2362; add 2361 2363; mul 168 2124; add 2364 2365; mul 148 2168; add 2366 2367; mul 136 2172; add 2368
2369; mul 95 2173; add 2370 2371; mul 95 2177; add 2372 2373; mul 95 2180; add 2374 2375; mul 120 2051; mul 113
2377; add 2376 2378; mul 102 2377; mul 1356 2380; add 2379 2381; mul 116 2051; mul 34 2383; mul 1356 2384; add 2382
2385; mul 112 2051; mul 1356 2387; add 2386 2388; mul 108 2051; mul 34 2390; mul 34 2391; add 2389 2392; mul 104
2051; mul 34 2394; add 2393 2395; mul 93 2051; add 2396 2397; mul 94 2398; add 2191 2399; mul 946 2400; sub 1822
2401; mul 699 1578; mul 699 1560; add 1609 2404; mul 1574 2405; mul 534 2406; add 2403 2407; mul 699 1562; mul 1588
2409; mul 1563 2405; mul 699 1596; add 2411 2412; sub 2410 2413; mul 28 2414; sub 2408 2415; mul 1558 2416; sub 2402
2417; mul 697 703; mul 662 1618; mul 664 703; add 2420 2421; mul 45 70; mul 76 76; sub 2423 2424; mul 89 2425; mul
569 2426; mul 542 1618; sub 2427 2428; mul 91 703; mul 363 2430; add 2429 2431; mul 602 2432; sub 2422 2433; mul 655
2434; mul 572 2435; mul 670 2432; sub 2436 2437; mul 601 2438; mul 670 1618; mul 525 2435; add 2440 2441; mul 16
2442; mul 601 2443; mul 658 2444; add 2439 2445; mul 668 2434; mul 654 2447; mul 650 2447; mul 653 2449; add 2448
2450; mul 641 2434; add 2451 2452; mul 645 2453; mul 647 2454; mul 609 2454; mul 514 2456; add 2455 2457; mul 586
2434; mul 621 2459; mul 625 2460; sub 2458 2461; mul 609 2460; mul 623 2463; sub 2462 2464; mul 608 2459; mul 615
2466; mul 611 2466; mul 613 2468; add 2467 2469; mul 755 2470; mul 750 2471; add 2465 2472; mul 649 2453; mul 586
2474; mul 766 2475; mul 599 2475; mul 644 2477; add 2476 2478; mul 599 2477; mul 643 2480; add 2479 2481; mul 585
2438; mul 670 703; mul 534 2435; sub 2484 2485; mul 592 2486; add 2483 2487; mul 660 2443; add 2488 2489; mul 586
2490; mul 617 2459; mul 603 2492; mul 605 2493; sub 2491 2494; mul 600 2493; neg 2496; mul 219 2497; add 2495 2498;
mul 776 2499; mul 600 2500; add 2482 2501; mul 765 2502; sub 2473 2503; mul 219 2493; add 2504 2505; mul 586 2506;
mul 726 2507; mul 724 2508; add 2446 2509; sub 2419 2510; mul 673 2426; mul 602 2435; mul 532 1618; mul 535 703; add
2514 2515; mul 465 2432; sub 2516 2517; mul 524 2518; mul 465 2519; add 2513 2520; mul 570 2521; add 2512 2522; mul
568 2523; add 2511 2524; mul 525 2521; sub 2526 1715; mul 541 2527; add 2525 2528; mul 97 1618; mul 100 2426; sub
2530 2531; mul 94 2430; sub 2532 2533; mul 676 2534; mul 679 2535; mul 689 2535; mul 676 2430; mul 679 2538; sub
2537 2539; mul 94 2540; add 2536 2541; mul 677 2538; sub 2542 2543; mul 363 2521; add 2544 2545; mul 825 2546; sub
2529 2547; mul 673 2430; mul 538 2521; add 2549 2550; mul 362 2551; add 2548 2552; mul 572 2519; mul 576 2432; sub
2554 2555; mul 464 2556; mul 576 1618; mul 525 2519; add 2558 2559; mul 16 2560; mul 464 2561; mul 528 2562; sub
2557 2563; mul 574 2518; mul 523 2565; mul 519 2565; mul 522 2567; add 2566 2568; mul 507 2518; add 2569 2570; mul
512 2571; mul 516 2572; mul 475 2572; mul 514 2574; add 2573 2575; mul 449 2518; mul 487 2577; mul 491 2578; sub
2576 2579; mul 475 2578; mul 489 2581; sub 2580 2582; mul 471 2577; mul 481 2584; mul 477 2584; mul 479 2586; add
2585 2587; mul 892 2588; mul 887 2589; add 2583 2590; mul 518 2571; mul 449 2592; mul 903 2593; mul 462 2593; mul
511 2595; add 2594 2596; mul 462 2595; mul 510 2598; add 2597 2599; mul 448 2556; mul 576 703; mul 534 2519; sub
2602 2603; mul 455 2604; add 2601 2605; mul 530 2561; add 2606 2607; mul 449 2608; mul 483 2577; mul 466 2610; mul
468 2611; sub 2609 2612; mul 463 2611; neg 2614; mul 219 2615; add 2613 2616; mul 913 2617; mul 463 2618; add 2600
2619; mul 902 2620; sub 2591 2621; mul 219 2611; add 2622 2623; mul 449 2624; mul 863 2625; mul 861 2626; add 2564
2627; add 2510 2628; mul 440 2629; add 2553 2630; sub 2631 2628; mul 293 2523; mul 352 2633; mul 102 2634; mul 947
2635; mul 92 2426; mul 204 2637; mul 102 2638; mul 947 2639; mul 131 2637; mul 34 2641; mul 947 2642; add 2640 2643;
mul 960 2637; mul 947 2645; add 2644 2646; mul 116 2637; mul 102 2648; mul 102 2649; add 2647 2650; mul 968 2637;
mul 34 2652; mul 102 2653; add 2651 2654; mul 104 2637; mul 102 2656; add 2655 2657; sub 2636 2658; mul 313 2633;
mul 34 2660; mul 947 2661; add 2659 2662; mul 559 2633; mul 34 2664; mul 102 2665; add 2663 2666; mul 100 2633; mul
293 2527; mul 97 2669; add 2668 2670; mul 293 2551; mul 94 2672; add 2671 2673; mul 357 2674; mul 148 2675; add 2667
2676; mul 95 2675; mul 947 2678; add 2677 2679; mul 319 2674; mul 102 2681; mul 947 2682; add 2680 2683; mul 352
2674; mul 34 2685; mul 947 2686; add 2684 2687; mul 349 2674; mul 102 2689; mul 102 2690; add 2688 2691; mul 304
2674; mul 34 2693; mul 34 2694; add 2692 2695; mul 302 2674; add 2696 2697; mul 325 2672; mul 148 2699; add 2698
2700; mul 95 2699; mul 947 2702; add 2701 2703; mul 322 2672; mul 102 2705; mul 947 2706; add 2704 2707; mul 319
2672; mul 102 2709; mul 102 2710; add 2708 2711; mul 316 2672; mul 34 2713; mul 102 2714; add 2712 2715; mul 313
2672; mul 34 2717; mul 34 2718; add 2716 2719; mul 310 2672; add 2720 2721; mul 293 2629; mul 420 2723; mul 34 2724;
add 2633 2725; mul 299 2726; add 2722 2727; mul 2 2724; add 2669 2729; mul 296 2730; add 2728 2731; mul 301 2724;
add 2732 2733; mul 95 2724; add 2672 2735; mul 294 2736; add 2734 2737; mul 416 2723; mul 153 2739; add 2738 2740;
mul 95 2739; mul 148 2742; add 2741 2743; mul 95 2742; mul 947 2745; add 2744 2746; mul 357 2723; mul 102 2748; mul
148 2749; add 2747 2750; mul 95 2749; mul 947 2752; add 2751 2753; mul 409 2723; mul 102 2755; mul 102 2756; mul 947
2757; add 2754 2758; mul 352 2723; mul 34 2760; mul 102 2761; mul 947 2762; add 2759 2763; mul 402 2723; mul 34
2765; mul 34 2766; mul 947 2767; add 2764 2768; mul 227 2723; mul 947 2770; add 2769 2771; mul 307 2723; mul 102
2773; mul 102 2774; mul 102 2775; add 2772 2776; mul 304 2723; mul 34 2778; mul 34 2779; mul 102 2780; add 2777
2781; mul 302 2723; mul 102 2783; add 2782 2784; mul 266 2637; mul 265 2786; mul 251 2637; mul 250 2637; mul 222
2789; add 2788 2790; mul 249 2791; add 2787 2792; mul 232 2637; mul 231 2637; mul 222 2795; add 2794 2796; mul 230
2797; add 2793 2798; mul 225 2637; add 2799 2800; mul 224 2637; mul 223 2637; mul 222 2803; add 2802 2804; mul 222
2805; add 2801 2806; neg 2807; where 1114 2808; mul 273 1823; mul 265 2810; where 1140 2811; add 2809 2812; mul 261
1823; mul 260 1823; mul 230 2815; add 2814 2816; mul 249 2817; where 1140 2818; add 2813 2819; mul 255 2637; mul 230
2821; neg 2822; where 1114 2823; mul 256 1823; where 1140 2825; add 2824 2826; mul 249 2827; add 2820 2828; mul 243
1823; where 1140 2830; add 2829 2831; mul 242 1823; mul 241 1823; mul 230 2834; add 2833 2835; mul 230 2836; where
1140 2837; add 2832 2838; mul 238 1823; where 1140 2840; add 2839 2841; mul 236 2637; mul 230 2843; neg 2844; where
1114 2845; mul 237 1823; where 1140 2847; add 2846 2848; mul 230 2849; add 2842 2850; mul 233 1823; where 1140 2852;
add 2851 2853; mul 92 2430; mul 249 2855; mul 284 2856; neg 2857; where 218 2858; add 2854 2859; mul 287 2855; neg
2861; mul 219 2862; where 218 2863; add 2860 2864; mul 248 2856; mul 265 2855; add 2866 2867; mul 281 2868; neg
2869; where 218 2870; add 2865 2871; mul 281 2855; mul 265 2873; neg 2874; where 218 2875; add 2872 2876; mul 284
2855; mul 248 2873; add 2878 2879; mul 249 2880; neg 2881; where 218 2882; add 2877 2883; mul 274 2856; neg 2885;
where 218 2886; add 2884 2887; mul 277 2855; neg 2889; mul 219 2890; where 218 2891; add 2888 2892; mul 248 2810;
where 1140 2894; mul 274 2855; neg 2896; where 218 2897; add 2895 2898; mul 249 2899; add 2893 2900; mul 267 2856;
neg 2902; where 218 2903; add 2901 2904; mul 270 2855; neg 2906; mul 219 2907; where 218 2908; add 2905 2909; mul
248 2786; neg 2911; where 1114 2912; mul 267 2855; neg 2914; where 218 2915; add 2913 2916; mul 249 2917; add 2910
2918; mul 262 2855; neg 2920; mul 219 2921; where 218 2922; add 2919 2923; mul 257 2855; neg 2925; mul 219 2926;
where 218 2927; add 2924 2928; mul 252 2855; neg 2930; mul 219 2931; where 218 2932; add 2929 2933; mul 1112 2934;
mul 1107 2935; add 2785 2936; mul 97 1823; mul 100 2637; sub 2938 2939; mul 94 2855; sub 2940 2941; mul 210 2942;
mul 148 2943; add 2937 2944; mul 95 2943; mul 947 2946; add 2945 2947; mul 143 2942; mul 102 2949; mul 947 2950; add
2948 2951; mul 204 2942; mul 34 2953; mul 947 2954; add 2952 2955; mul 201 2942; mul 947 2957; add 2956 2958; mul
198 2942; mul 102 2960; mul 102 2961; add 2959 2962; mul 195 2942; mul 34 2964; mul 102 2965; add 2963 2966; mul 192
2942; mul 102 2968; add 2967 2969; mul 108 2942; mul 34 2971; mul 34 2972; add 2970 2973; mul 104 2942; mul 34 2975;
add 2974 2976; mul 93 2942; add 2977 2978; mul 152 2855; mul 148 2980; sub 2979 2981; mul 95 2980; mul 947 2983; sub
2982 2984; mul 147 2855; mul 102 2986; mul 947 2987; sub 2985 2988; mul 143 2855; mul 102 2990; mul 102 2991; sub
2989 2992; mul 139 2855; mul 34 2994; mul 102 2995; sub 2993 2996; mul 135 2855; mul 102 2998; sub 2997 2999; mul
131 2855; mul 34 3001; mul 34 3002; sub 3000 3003; mul 127 2855; mul 34 3005; sub 3004 3006; mul 124 2855; sub 3007
3008; mul 148 2634; mul 148 2638; mul 136 2648; add 3011 3012; mul 95 2649; add 3013 3014; mul 95 2653; add 3015
3016; mul 95 2656; add 3017 3018; mul 1352 2637; mul 113 3020; add 3019 3021; mul 102 3020; mul 1356 3023; add 3022
3024; mul 174 2637; mul 34 3026; mul 1356 3027; add 3025 3028; mul 1364 2637; mul 1356 3030; add 3029 3031; mul 1368
2637; mul 34 3033; mul 34 3034; add 3032 3035; mul 1373 2637; mul 34 3037; add 3036 3038; mul 157 2637; add 3039
3040; sub 3010 3041; mul 95 2665; add 3042 3043; mul 384 2633; mul 113 3045; add 3044 3046; mul 102 3045; mul 1356
3048; add 3047 3049; mul 336 2633; mul 34 3051; mul 1356 3052; add 3050 3053; mul 552 2633; mul 34 3055; mul 34
3056; add 3054 3057; mul 328 2633; add 3058 3059; mul 148 2681; add 3060 3061; mul 136 2689; add 3062 3063; mul 95
2690; add 3064 3065; mul 342 2674; mul 113 3067; add 3066 3068; mul 102 3067; mul 1356 3070; add 3069 3071; mul 339
2674; mul 34 3073; mul 1356 3074; add 3072 3075; mul 336 2674; mul 34 3077; mul 34 3078; add 3076 3079; mul 333
2674; add 3080 3081; mul 148 2705; add 3082 3083; mul 136 2709; add 3084 3085; mul 95 2710; add 3086 3087; mul 95
2714; add 3088 3089; mul 307 2672; mul 113 3091; add 3090 3092; mul 102 3091; mul 1356 3094; add 3093 3095; mul 304
2672; mul 34 3097; mul 34 3098; add 3096 3099; mul 302 2672; add 3100 3101; mul 153 2748; add 3102 3103; mul 149
2755; add 3104 3105; mul 148 2756; add 3106 3107; mul 148 2761; add 3108 3109; mul 144 2773; add 3110 3111; mul 136
2774; add 3112 3113; mul 95 2775; add 3114 3115; mul 95 2780; add 3116 3117; mul 95 2783; add 3118 3119; mul 388
2723; mul 121 3121; add 3120 3122; mul 102 3121; mul 113 3124; add 3123 3125; mul 102 3124; mul 1356 3127; add 3126
3128; mul 384 2723; mul 34 3130; mul 113 3131; add 3129 3132; mul 102 3131; mul 1356 3134; add 3133 3135; mul 380
2723; mul 34 3137; mul 34 3138; mul 1356 3139; add 3136 3140; mul 377 2723; mul 1356 3142; add 3141 3143; mul 330
2723; mul 34 3145; mul 34 3146; mul 34 3147; add 3144 3148; mul 328 2723; mul 34 3150; add 3149 3151; mul 148 2949;
add 3152 3153; mul 136 2960; add 3154 3155; mul 95 2961; add 3156 3157; mul 95 2965; add 3158 3159; mul 95 2968; add
3160 3161; mul 183 2942; mul 113 3163; add 3162 3164; mul 102 3163; mul 1356 3166; add 3165 3167; mul 180 2942; mul
34 3169; mul 1356 3170; add 3168 3171; mul 177 2942; mul 1356 3173; add 3172 3174; mul 174 2942; mul 34 3176; mul 34
3177; add 3175 3178; mul 171 2942; mul 34 3180; add 3179 3181; mul 168 2942; add 3182 3183; mul 148 2986; sub 3184
3185; mul 136 2990; sub 3186 3187; mul 95 2991; sub 3188 3189; mul 95 2995; sub 3190 3191; mul 95 2998; sub 3192
3193; mul 120 2855; mul 113 3195; sub 3194 3196; mul 102 3195; mul 1356 3198; sub 3197 3199; mul 116 2855; mul 34
3201; mul 1356 3202; sub 3200 3203; mul 112 2855; mul 1356 3205; sub 3204 3206; mul 108 2855; mul 34 3208; mul 34
3209; sub 3207 3210; mul 104 2855; mul 34 3212; sub 3211 3213; mul 93 2855; sub 3214 3215; mul 94 3216; add 3009
3217; mul 946 3218; sub 2632 3219; mul 703 1578; mul 703 1560; add 1618 3222; mul 1574 3223; mul 534 3224; add 3221
3225; mul 1563 3223; mul 703 1596; add 3227 3228; mul 703 1562; mul 1588 3230; sub 3229 3231; mul 28 3232; add 3226
3233; mul 1558 3234; add 3220 3235; mul 465 519; mul 570 3237; mul 568 3238; mul 525 3237; mul 541 3240; add 3239
3241; mul 363 3237; mul 825 3243; sub 3242 3244; mul 538 3237; mul 362 3246; add 3245 3247; mul 519 572; mul 464
3249; mul 519 525; mul 16 3251; mul 464 3252; mul 528 3253; sub 3250 3254; mul 512 574; mul 516 3256; mul 475 3256;
mul 514 3258; add 3257 3259; mul 518 574; mul 449 3261; mul 903 3262; mul 462 3262; mul 511 3264; add 3263 3265; mul
462 3264; mul 510 3267; add 3266 3268; mul 448 3249; mul 519 534; mul 455 3271; sub 3270 3272; mul 530 3252; add
3273 3274; mul 449 3275; mul 913 3276; mul 463 3277; add 3269 3278; mul 902 3279; sub 3260 3280; mul 449 3281; mul
863 3282; mul 861 3283; add 3255 3284; mul 440 3285; add 3248 3286; sub 3287 3285; mul 293 3238; mul 352 3289; mul
102 3290; mul 947 3291; mul 313 3289; mul 34 3293; mul 947 3294; add 3292 3295; mul 559 3289; mul 34 3297; mul 102
3298; add 3296 3299; mul 100 3289; mul 293 3240; mul 97 3302; add 3301 3303; mul 293 3246; mul 94 3305; add 3304
3306; mul 357 3307; mul 148 3308; add 3300 3309; mul 95 3308; mul 947 3311; add 3310 3312; mul 319 3307; mul 102
3314; mul 947 3315; add 3313 3316; mul 352 3307; mul 34 3318; mul 947 3319; add 3317 3320; mul 349 3307; mul 102
3322; mul 102 3323; add 3321 3324; mul 304 3307; mul 34 3326; mul 34 3327; add 3325 3328; mul 302 3307; add 3329
3330; mul 325 3305; mul 148 3332; add 3331 3333; mul 95 3332; mul 947 3335; add 3334 3336; mul 322 3305; mul 102
3338; mul 947 3339; add 3337 3340; mul 319 3305; mul 102 3342; mul 102 3343; add 3341 3344; mul 316 3305; mul 34
3346; mul 102 3347; add 3345 3348; mul 313 3305; mul 34 3350; mul 34 3351; add 3349 3352; mul 310 3305; add 3353
3354; mul 293 3285; mul 420 3356; mul 34 3357; add 3289 3358; mul 299 3359; add 3355 3360; mul 2 3357; add 3302
3362; mul 296 3363; add 3361 3364; mul 301 3357; add 3365 3366; mul 95 3357; add 3305 3368; mul 294 3369; add 3367
3370; mul 416 3356; mul 153 3372; add 3371 3373; mul 95 3372; mul 148 3375; add 3374 3376; mul 95 3375; mul 947
3378; add 3377 3379; mul 357 3356; mul 102 3381; mul 148 3382; add 3380 3383; mul 95 3382; mul 947 3385; add 3384
3386; mul 409 3356; mul 102 3388; mul 102 3389; mul 947 3390; add 3387 3391; mul 352 3356; mul 34 3393; mul 102
3394; mul 947 3395; add 3392 3396; mul 402 3356; mul 34 3398; mul 34 3399; mul 947 3400; add 3397 3401; mul 227
3356; mul 947 3403; add 3402 3404; mul 307 3356; mul 102 3406; mul 102 3407; mul 102 3408; add 3405 3409; mul 304
3356; mul 34 3411; mul 34 3412; mul 102 3413; add 3410 3414; mul 302 3356; mul 102 3416; add 3415 3417; mul 148
3290; mul 95 3298; add 3419 3420; mul 384 3289; mul 113 3422; add 3421 3423; mul 102 3422; mul 1356 3425; add 3424
3426; mul 336 3289; mul 34 3428; mul 1356 3429; add 3427 3430; mul 552 3289; mul 34 3432; mul 34 3433; add 3431
3434; mul 328 3289; add 3435 3436; mul 148 3314; add 3437 3438; mul 136 3322; add 3439 3440; mul 95 3323; add 3441
3442; mul 342 3307; mul 113 3444; add 3443 3445; mul 102 3444; mul 1356 3447; add 3446 3448; mul 339 3307; mul 34
3450; mul 1356 3451; add 3449 3452; mul 336 3307; mul 34 3454; mul 34 3455; add 3453 3456; mul 333 3307; add 3457
3458; mul 148 3338; add 3459 3460; mul 136 3342; add 3461 3462; mul 95 3343; add 3463 3464; mul 95 3347; add 3465
3466; mul 307 3305; mul 113 3468; add 3467 3469; mul 102 3468; mul 1356 3471; add 3470 3472; mul 304 3305; mul 34
3474; mul 34 3475; add 3473 3476; mul 302 3305; add 3477 3478; mul 153 3381; add 3479 3480; mul 149 3388; add 3481
3482; mul 148 3389; add 3483 3484; mul 148 3394; add 3485 3486; mul 144 3406; add 3487 3488; mul 136 3407; add 3489
3490; mul 95 3408; add 3491 3492; mul 95 3413; add 3493 3494; mul 95 3416; add 3495 3496; mul 388 3356; mul 121
3498; add 3497 3499; mul 102 3498; mul 113 3501; add 3500 3502; mul 102 3501; mul 1356 3504; add 3503 3505; mul 384
3356; mul 34 3507; mul 113 3508; add 3506 3509; mul 102 3508; mul 1356 3511; add 3510 3512; mul 380 3356; mul 34
3514; mul 34 3515; mul 1356 3516; add 3513 3517; mul 377 3356; mul 1356 3519; add 3518 3520; mul 330 3356; mul 34
3522; mul 34 3523; mul 34 3524; add 3521 3525; mul 328 3356; mul 34 3527; add 3526 3528; mul 94 3529; add 3418 3530;
mul 946 3531; sub 3288 3532; mul 602 650; mul 570 3534; mul 568 3535; mul 572 650; mul 601 3537; mul 525 650; mul 16
3539; mul 601 3540; mul 658 3541; add 3538 3542; mul 645 668; mul 647 3544; mul 609 3544; mul 514 3546; add 3545
3547; mul 649 668; mul 586 3549; mul 766 3550; mul 599 3550; mul 644 3552; add 3551 3553; mul 599 3552; mul 643
3555; add 3554 3556; mul 585 3537; mul 534 650; mul 592 3559; sub 3558 3560; mul 660 3540; add 3561 3562; mul 586
3563; mul 776 3564; mul 600 3565; add 3557 3566; mul 765 3567; sub 3548 3568; mul 586 3569; mul 726 3570; mul 724
3571; add 3543 3572; sub 3536 3573; mul 525 3534; mul 541 3575; add 3574 3576; mul 363 3534; mul 825 3578; sub 3577
3579; mul 538 3534; mul 362 3581; add 3580 3582; mul 440 3573; add 3583 3584; mul 293 3535; mul 352 3586; mul 102
3587; mul 947 3588; mul 313 3586; mul 34 3590; mul 947 3591; add 3589 3592; mul 559 3586; mul 34 3594; mul 102 3595;
add 3593 3596; mul 100 3586; mul 293 3575; mul 97 3599; add 3598 3600; mul 293 3581; mul 94 3602; add 3601 3603; mul
357 3604; mul 148 3605; add 3597 3606; mul 95 3605; mul 947 3608; add 3607 3609; mul 319 3604; mul 102 3611; mul 947
3612; add 3610 3613; mul 352 3604; mul 34 3615; mul 947 3616; add 3614 3617; mul 349 3604; mul 102 3619; mul 102
3620; add 3618 3621; mul 304 3604; mul 34 3623; mul 34 3624; add 3622 3625; mul 302 3604; add 3626 3627; mul 325
3602; mul 148 3629; add 3628 3630; mul 95 3629; mul 947 3632; add 3631 3633; mul 322 3602; mul 102 3635; mul 947
3636; add 3634 3637; mul 319 3602; mul 102 3639; mul 102 3640; add 3638 3641; mul 316 3602; mul 34 3643; mul 102
3644; add 3642 3645; mul 313 3602; mul 34 3647; mul 34 3648; add 3646 3649; mul 310 3602; add 3650 3651; mul 293
3573; mul 420 3653; mul 34 3654; add 3586 3655; mul 299 3656; add 3652 3657; mul 2 3654; add 3599 3659; mul 296
3660; add 3658 3661; mul 301 3654; add 3662 3663; mul 95 3654; add 3602 3665; mul 294 3666; add 3664 3667; mul 416
3653; mul 153 3669; add 3668 3670; mul 95 3669; mul 148 3672; add 3671 3673; mul 95 3672; mul 947 3675; add 3674
3676; mul 357 3653; mul 102 3678; mul 148 3679; add 3677 3680; mul 95 3679; mul 947 3682; add 3681 3683; mul 409
3653; mul 102 3685; mul 102 3686; mul 947 3687; add 3684 3688; mul 352 3653; mul 34 3690; mul 102 3691; mul 947
3692; add 3689 3693; mul 402 3653; mul 34 3695; mul 34 3696; mul 947 3697; add 3694 3698; mul 227 3653; mul 947
3700; add 3699 3701; mul 307 3653; mul 102 3703; mul 102 3704; mul 102 3705; add 3702 3706; mul 304 3653; mul 34
3708; mul 34 3709; mul 102 3710; add 3707 3711; mul 302 3653; mul 102 3713; add 3712 3714; mul 148 3587; mul 95
3595; add 3716 3717; mul 384 3586; mul 113 3719; add 3718 3720; mul 102 3719; mul 1356 3722; add 3721 3723; mul 336
3586; mul 34 3725; mul 1356 3726; add 3724 3727; mul 552 3586; mul 34 3729; mul 34 3730; add 3728 3731; mul 328
3586; add 3732 3733; mul 148 3611; add 3734 3735; mul 136 3619; add 3736 3737; mul 95 3620; add 3738 3739; mul 342
3604; mul 113 3741; add 3740 3742; mul 102 3741; mul 1356 3744; add 3743 3745; mul 339 3604; mul 34 3747; mul 1356
3748; add 3746 3749; mul 336 3604; mul 34 3751; mul 34 3752; add 3750 3753; mul 333 3604; add 3754 3755; mul 148
3635; add 3756 3757; mul 136 3639; add 3758 3759; mul 95 3640; add 3760 3761; mul 95 3644; add 3762 3763; mul 307
3602; mul 113 3765; add 3764 3766; mul 102 3765; mul 1356 3768; add 3767 3769; mul 304 3602; mul 34 3771; mul 34
3772; add 3770 3773; mul 302 3602; add 3774 3775; mul 153 3678; add 3776 3777; mul 149 3685; add 3778 3779; mul 148
3686; add 3780 3781; mul 148 3691; add 3782 3783; mul 144 3703; add 3784 3785; mul 136 3704; add 3786 3787; mul 95
3705; add 3788 3789; mul 95 3710; add 3790 3791; mul 95 3713; add 3792 3793; mul 388 3653; mul 121 3795; add 3794
3796; mul 102 3795; mul 113 3798; add 3797 3799; mul 102 3798; mul 1356 3801; add 3800 3802; mul 384 3653; mul 34
3804; mul 113 3805; add 3803 3806; mul 102 3805; mul 1356 3808; add 3807 3809; mul 380 3653; mul 34 3811; mul 34
3812; mul 1356 3813; add 3810 3814; mul 377 3653; mul 1356 3816; add 3815 3817; mul 330 3653; mul 34 3819; mul 34
3820; mul 34 3821; add 3818 3822; mul 328 3653; mul 34 3824; add 3823 3825; mul 94 3826; add 3715 3827; mul 946
3828; sub 3585 3829; mul 222 222; mul 222 3831; input p 153; mul 3832 3833; mul 222 3833; mul 3831 3835; add 3834
3836; mul 219 222; mul 222 3835; mul 3838 3839; add 3837 3840; input p 138; mul 222 230; mul 222 3843; mul 3842
3844; add 3841 3845; mul 222 3842; mul 3843 3847; add 3846 3848; mul 222 3847; mul 230 3850; add 3849 3851; input p
139; mul 230 230; mul 222 3854; mul 3853 3855; add 3852 3856; mul 222 3853; mul 3854 3858; add 3857 3859; input p
140; mul 230 3854; mul 3861 3862; add 3860 3863; mul 222 248; mul 222 3865; mul 223 3866; add 3864 3867; mul 224
3865; add 3868 3869; mul 225 248; add 3870 3871; mul 230 248; mul 222 3873; mul 231 3874; add 3872 3875; mul 232
3873; add 3876 3877; mul 230 3873; mul 236 3879; add 3878 3880; mul 222 265; mul 250 3882; add 3881 3883; mul 251
265; add 3884 3885; mul 230 265; mul 255 3887; add 3886 3888; mul 266 280; add 3889 3890; mul 703 3891; neg 3892;
where 1114 3893; input p 144; mul 34 3895; input p 145; mul 161 3897; add 3896 3898; input p 146; mul 165 3900; add
3899 3901; mul 102 157; add 3902 3903; mul 105 1373; add 3904 3905; mul 109 1368; add 3906 3907; mul 113 1364; add
3908 3909; mul 117 174; add 3910 3911; mul 121 1352; add 3912 3913; mul 104 136; add 3914 3915; mul 140 968; add
3916 3917; mul 116 144; add 3918 3919; mul 148 960; add 3920 3921; mul 131 205; add 3922 3923; mul 149 204; add 3924
3925; mul 100 212; add 3926 3927; mul 703 3928; sub 3894 3929; mul 222 3850; mul 219 230; mul 222 3858; mul 3932
3933; add 3931 3934; mul 222 3861; mul 3854 3936; add 3935 3937; mul 230 3936; mul 3932 3939; add 3938 3940; input p
141; mul 3862 3942; add 3941 3943; mul 230 3942; mul 3854 3945; add 3944 3946; mul 230 3945; mul 3932 3948; add 3947
3949; mul 233 248; add 3950 3951; mul 237 3873; add 3952 3953; mul 238 248; add 3954 3955; mul 241 3879; add 3956
3957; mul 242 3873; add 3958 3959; mul 243 248; add 3960 3961; mul 256 265; add 3962 3963; mul 260 3887; add 3964
3965; mul 261 265; add 3966 3967; mul 273 280; add 3968 3969; mul 699 3970; where 1140 3971; add 3930 3972; mul 97
212; mul 699 3974; add 3973 3975; mul 289 707; neg 3977; where 218 3978; add 3976 3979; mul 214 707; sub 3980 3981;
mul 1618 3891; where 1114 3983; mul 1618 3928; add 3984 3985; mul 1609 3970; neg 3987; where 1140 3988; add 3986
3989; mul 1609 3974; sub 3990 3991; mul 289 1621; where 218 3993; add 3992 3994; mul 214 1621; add 3995 3996; mul
2426 3891; neg 3998; where 1114 3999; mul 2426 3928; sub 4000 4001; mul 1618 3970; where 1140 4003; add 4002 4004;
mul 1618 3974; add 4005 4006; mul 289 2430; neg 4008; where 218 4009; add 4007 4010; mul 214 2430; sub 4011 4012;
mul 691 830; constant 0.8; mul 570 703; mul 4015 4016; sub 4014 4017; mul 686 707; sub 4018 4019; mul 1576 1581; le
1572 1573; le 1573 1572; add 4022 4023; div 1 4024; mul 4022 4025; mul 4021 4026; mul 220 4027; add 4020 4028; mul
570 1618; mul 4015 4030; mul 691 1725; add 4031 4032; mul 686 1621; add 4033 4034; mul 1576 2405; mul 4026 4036; mul
220 4037; sub 4035 4038; mul 691 2534; mul 570 2426; mul 4015 4041; sub 4040 4042; mul 686 2430; sub 4043 4044; mul
1576 3223; mul 4026 4046; mul 220 4047; add 4045 4048; constant -2.5714285714285743; mul 153 1274; mul 4050 4051;
constant -0.8571428571428583; mul 149 952; mul 4053 4054; constant 0.9142857142857138; mul 205 952; mul 4056 4057;
add 4055 4058; constant 0.05714285714285722; mul 144 952; mul 4060 4061; add 4059 4062; constant
-0.11428571428571327; mul 140 952; mul 4064 4065; add 4063 4066; constant 0.2190476190476189; mul 121 952; mul 4068
4069; add 4067 4070; constant 0.11428571428571413; mul 117 952; mul 4072 4073; add 4071 4074; constant
-0.05714285714285729; mul 109 952; mul 4076 4077; add 4075 4078; input p 214; mul 102 952; mul 328 4081; mul 4080
4082; add 4079 4083; constant 0.007256235827664418; mul 165 952; mul 4085 4086; add 4084 4087; mul 34 952; mul 545
4089; mul 4080 4090; add 4088 4091; sub 4052 4092; constant 2.057142857142858; mul 149 1274; mul 4094 4095; add 4093
4096; mul 205 1274; mul 4053 4098; add 4097 4099; constant -3.428571428571427; mul 144 1274; mul 4101 4102; add 4100
4103; constant 0.11428571428571443; mul 140 1274; mul 4105 4106; add 4104 4107; constant -0.057142857142856635; mul
132 1274; mul 4109 4110; add 4108 4111; mul 95 1274; mul 302 4113; mul 4080 4114; add 4112 4115; constant
2.438095238095238; mul 121 1274; mul 4117 4118; add 4116 4119; constant 0.6571428571428567; mul 117 1274; mul 4121
4122; add 4120 4123; input p 215; mul 113 1274; mul 4125 4126; sub 4124 4127; mul 109 1274; mul 4072 4129; add 4128
4130; mul 102 1274; mul 333 4132; mul 4080 4133; add 4131 4134; constant -0.019047619047619094; mul 165 1274; mul
4136 4137; add 4135 4138; mul 34 1274; mul 328 4140; mul 4080 4141; add 4139 4142; constant 12.34285714285715; mul
153 1187; mul 4144 4145; sub 4143 4146; constant -7.714285714285722; mul 149 1187; mul 4148 4149; sub 4147 4150; mul
144 1187; mul 4094 4152; sub 4151 4153; constant -1.7142857142857166; mul 140 1187; mul 4155 4156; sub 4154 4157;
mul 132 1187; mul 4056 4159; sub 4158 4160; mul 95 1187; mul 310 4162; mul 4080 4163; sub 4161 4164; constant
-1.1428571428571423; mul 121 1187; mul 4166 4167; sub 4165 4168; mul 117 1187; mul 4060 4170; sub 4169 4171; mul 109
1187; mul 4109 4173; sub 4172 4174; mul 102 1187; mul 302 4176; mul 4080 4177; sub 4175 4178; mul 149 1823; mul 4053
4180; mul 205 1823; mul 4056 4182; add 4181 4183; mul 144 1823; mul 4060 4185; add 4184 4186; mul 140 1823; mul 4064
4188; add 4187 4189; mul 121 1823; mul 4068 4191; add 4190 4192; mul 117 1823; mul 4072 4194; add 4193 4195; mul 109
1823; mul 4076 4197; add 4196 4198; mul 102 1823; mul 328 4200; mul 4080 4201; add 4199 4202; mul 165 1823; mul 4085
4204; add 4203 4205; mul 34 1823; mul 545 4207; mul 4080 4208; add 4206 4209; mul 153 2124; mul 4050 4211; add 4210
4212; mul 149 2124; mul 4094 4214; add 4213 4215; mul 205 2124; mul 4053 4217; add 4216 4218; mul 144 2124; mul 4101
4220; add 4219 4221; mul 140 2124; mul 4105 4223; add 4222 4224; mul 132 2124; mul 4109 4226; add 4225 4227; mul 95
2124; mul 302 4229; mul 4080 4230; add 4228 4231; mul 121 2124; mul 4117 4233; add 4232 4234; mul 117 2124; mul 4121
4236; add 4235 4237; mul 113 2124; mul 4125 4239; sub 4238 4240; mul 109 2124; mul 4072 4242; add 4241 4243; mul 102
2124; mul 333 4245; mul 4080 4246; add 4244 4247; mul 165 2124; mul 4136 4249; add 4248 4250; mul 34 2124; mul 328
4252; mul 4080 4253; add 4251 4254; mul 153 2051; mul 4144 4256; add 4255 4257; mul 149 2051; mul 4148 4259; add
4258 4260; mul 144 2051; mul 4094 4262; add 4261 4263; mul 140 2051; mul 4155 4265; add 4264 4266; mul 132 2051; mul
4056 4268; add 4267 4269; mul 95 2051; mul 310 4271; mul 4080 4272; add 4270 4273; mul 121 2051; mul 4166 4275; add
4274 4276; mul 117 2051; mul 4060 4278; add 4277 4279; mul 109 2051; mul 4109 4281; add 4280 4282; mul 102 2051; mul
302 4284; mul 4080 4285; add 4283 4286; mul 153 2942; mul 4050 4288; mul 149 2637; mul 4053 4290; mul 205 2637; mul
4056 4292; add 4291 4293; mul 144 2637; mul 4060 4295; add 4294 4296; mul 140 2637; mul 4064 4298; add 4297 4299;
mul 121 2637; mul 4068 4301; add 4300 4302; mul 117 2637; mul 4072 4304; add 4303 4305; mul 109 2637; mul 4076 4307;
add 4306 4308; mul 102 2637; mul 328 4310; mul 4080 4311; add 4309 4312; mul 165 2637; mul 4085 4314; add 4313 4315;
mul 34 2637; mul 545 4317; mul 4080 4318; add 4316 4319; sub 4289 4320; mul 149 2942; mul 4094 4322; add 4321 4323;
mul 205 2942; mul 4053 4325; add 4324 4326; mul 144 2942; mul 4101 4328; add 4327 4329; mul 140 2942; mul 4105 4331;
add 4330 4332; mul 132 2942; mul 4109 4334; add 4333 4335; mul 95 2942; mul 302 4337; mul 4080 4338; add 4336 4339;
mul 121 2942; mul 4117 4341; add 4340 4342; mul 117 2942; mul 4121 4344; add 4343 4345; mul 113 2942; mul 4125 4347;
sub 4346 4348; mul 109 2942; mul 4072 4350; add 4349 4351; mul 102 2942; mul 333 4353; mul 4080 4354; add 4352 4355;
mul 165 2942; mul 4136 4357; add 4356 4358; mul 34 2942; mul 328 4360; mul 4080 4361; add 4359 4362; mul 153 2855;
mul 4144 4364; sub 4363 4365; mul 149 2855; mul 4148 4367; sub 4366 4368; mul 144 2855; mul 4094 4370; sub 4369
4371; mul 140 2855; mul 4155 4373; sub 4372 4374; mul 132 2855; mul 4056 4376; sub 4375 4377; mul 95 2855; mul 310
4379; mul 4080 4380; sub 4378 4381; mul 121 2855; mul 4166 4383; sub 4382 4384; mul 117 2855; mul 4060 4386; sub
4385 4387; mul 109 2855; mul 4109 4389; sub 4388 4390; mul 102 2855; mul 302 4392; mul 4080 4393; sub 4391 4394;
constant -129.60000000000008; mul 4051 4396; constant 28.799999999999958; mul 4054 4398; constant 45.25714285714287;
mul 4057 4400; add 4399 4401; constant -28.800000000000004; mul 148 952; mul 4403 4404; mul 4125 4405; add 4402
4406; constant -28.799999999999976; mul 4061 4408; add 4407 4409; constant -45.25714285714286; mul 4065 4411; add
4410 4412; constant 28.79999999999999; mul 136 952; mul 4414 4415; mul 4125 4416; add 4413 4417; constant
7.199999999999994; mul 4069 4419; add 4418 4420; constant 13.714285714285717; mul 4073 4422; add 4421 4423; constant
-7.199999999999996; mul 113 952; mul 4425 4426; mul 4125 4427; add 4424 4428; constant 1.3714285714285692; mul 4077
4430; add 4429 4431; constant -4.799999999999999; mul 105 952; mul 4433 4434; mul 4125 4435; add 4432 4436; constant
1.3714285714285714; mul 4086 4438; add 4437 4439; constant -1.3714285714285723; mul 161 952; mul 4441 4442; mul 4125
4443; add 4440 4444; constant 2.400000000000001; mul 4089 4446; mul 4080 4447; add 4445 4448; sub 4397 4449;
constant 230.40000000000006; mul 4095 4451; add 4450 4452; mul 4098 4398; add 4453 4454; constant
-36.00000000000001; mul 148 1274; mul 4456 4457; mul 4125 4458; add 4455 4459; constant -151.20000000000002; mul
4102 4461; add 4460 4462; constant -57.59999999999995; mul 4106 4464; add 4463 4465; constant 72.0; mul 136 1274;
mul 4467 4468; mul 4125 4469; add 4466 4470; constant -22.62857142857143; mul 4110 4472; add 4471 4473; mul 128
1274; mul 4414 4475; mul 4125 4476; add 4474 4477; constant -18.000000000000004; mul 4113 4479; mul 4080 4480; add
4478 4481; constant 35.20000000000001; mul 4118 4483; add 4482 4484; constant 21.59999999999998; mul 4122 4486; add
4485 4487; constant -30.000000000000007; mul 4126 4489; mul 4125 4490; add 4488 4491; mul 4129 4422; add 4492 4493;
constant -14.399999999999991; mul 105 1274; mul 4495 4496; mul 4125 4497; add 4494 4498; mul 677 4132; mul 4080
4500; add 4499 4501; constant 0.4571428571428564; mul 4137 4503; add 4502 4504; constant -2.3999999999999995; mul
161 1274; mul 4506 4507; mul 4125 4508; add 4505 4509; input p 216; constant -0.9999999999999998; mul 1274 4512; mul
4511 4513; add 4510 4514; constant 259.2000000000001; mul 4145 4516; sub 4515 4517; constant -388.80000000000024;
mul 4149 4519; sub 4518 4520; mul 4152 4451; sub 4521 4522; constant 57.599999999999916; mul 4156 4524; sub 4523
4525; constant -72.00000000000001; mul 136 1187; mul 4527 4528; mul 4125 4529; sub 4526 4530; mul 4159 4400; sub
4531 4532; constant -57.60000000000001; mul 128 1187; mul 4534 4535; mul 4125 4536; sub 4533 4537; constant
36.000000000000014; mul 4162 4539; mul 4080 4540; sub 4538 4541; constant -50.400000000000006; mul 4167 4543; sub
4542 4544; mul 4170 4408; sub 4545 4546; constant 36.0; mul 113 1187; mul 4548 4549; mul 4125 4550; sub 4547 4551;
mul 4173 4472; sub 4552 4553; mul 105 1187; mul 4414 4555; mul 4125 4556; sub 4554 4557; mul 4176 4479; mul 4080
4559; sub 4558 4560; mul 4180 4398; mul 4182 4400; add 4562 4563; mul 148 1823; mul 4403 4565; mul 4125 4566; add
4564 4567; mul 4185 4408; add 4568 4569; mul 4188 4411; add 4570 4571; mul 136 1823; mul 4414 4573; mul 4125 4574;
add 4572 4575; mul 4191 4419; add 4576 4577; mul 4194 4422; add 4578 4579; mul 113 1823; mul 4425 4581; mul 4125
4582; add 4580 4583; mul 4197 4430; add 4584 4585; mul 105 1823; mul 4433 4587; mul 4125 4588; add 4586 4589; mul
4204 4438; add 4590 4591; mul 161 1823; mul 4441 4593; mul 4125 4594; add 4592 4595; mul 4207 4446; mul 4080 4597;
add 4596 4598; mul 4211 4396; add 4599 4600; mul 4214 4451; add 4601 4602; mul 4217 4398; add 4603 4604; mul 148
2124; mul 4456 4606; mul 4125 4607; add 4605 4608; mul 4220 4461; add 4609 4610; mul 4223 4464; add 4611 4612; mul
136 2124; mul 4467 4614; mul 4125 4615; add 4613 4616; mul 4226 4472; add 4617 4618; mul 128 2124; mul 4414 4620;
mul 4125 4621; add 4619 4622; mul 4229 4479; mul 4080 4624; add 4623 4625; mul 4233 4483; add 4626 4627; mul 4236
4486; add 4628 4629; mul 4239 4489; mul 4125 4631; add 4630 4632; mul 4242 4422; add 4633 4634; mul 105 2124; mul
4495 4636; mul 4125 4637; add 4635 4638; mul 677 4245; mul 4080 4640; add 4639 4641; mul 4249 4503; add 4642 4643;
mul 161 2124; mul 4506 4645; mul 4125 4646; add 4644 4647; mul 2124 4512; mul 4511 4649; add 4648 4650; mul 4256
4516; add 4651 4652; mul 4259 4519; add 4653 4654; mul 4262 4451; add 4655 4656; mul 4265 4524; add 4657 4658; mul
136 2051; mul 4527 4660; mul 4125 4661; add 4659 4662; mul 4268 4400; add 4663 4664; mul 128 2051; mul 4534 4666;
mul 4125 4667; add 4665 4668; mul 4271 4539; mul 4080 4670; add 4669 4671; mul 4275 4543; add 4672 4673; mul 4278
4408; add 4674 4675; mul 113 2051; mul 4548 4677; mul 4125 4678; add 4676 4679; mul 4281 4472; add 4680 4681; mul
105 2051; mul 4414 4683; mul 4125 4684; add 4682 4685; mul 4284 4479; mul 4080 4687; add 4686 4688; mul 4288 4396;
mul 4290 4398; mul 4292 4400; add 4691 4692; mul 148 2637; mul 4403 4694; mul 4125 4695; add 4693 4696; mul 4295
4408; add 4697 4698; mul 4298 4411; add 4699 4700; mul 136 2637; mul 4414 4702; mul 4125 4703; add 4701 4704; mul
4301 4419; add 4705 4706; mul 4304 4422; add 4707 4708; mul 113 2637; mul 4425 4710; mul 4125 4711; add 4709 4712;
mul 4307 4430; add 4713 4714; mul 105 2637; mul 4433 4716; mul 4125 4717; add 4715 4718; mul 4314 4438; add 4719
4720; mul 161 2637; mul 4441 4722; mul 4125 4723; add 4721 4724; mul 4317 4446; mul 4080 4726; add 4725 4727; sub
4690 4728; mul 4322 4451; add 4729 4730; mul 4325 4398; add 4731 4732; mul 148 2942; mul 4456 4734; mul 4125 4735;
add 4733 4736; mul 4328 4461; add 4737 4738; mul 4331 4464; add 4739 4740; mul 136 2942; mul 4467 4742; mul 4125
4743; add 4741 4744; mul 4334 4472; add 4745 4746; mul 128 2942; mul 4414 4748; mul 4125 4749; add 4747 4750; mul
4337 4479; mul 4080 4752; add 4751 4753; mul 4341 4483; add 4754 4755; mul 4344 4486; add 4756 4757; mul 4347 4489;
mul 4125 4759; add 4758 4760; mul 4350 4422; add 4761 4762; mul 105 2942; mul 4495 4764; mul 4125 4765; add 4763
4766; mul 677 4353; mul 4080 4768; add 4767 4769; mul 4357 4503; add 4770 4771; mul 161 2942; mul 4506 4773; mul
4125 4774; add 4772 4775; mul 2942 4512; mul 4511 4777; add 4776 4778; mul 4364 4516; sub 4779 4780; mul 4367 4519;
sub 4781 4782; mul 4370 4451; sub 4783 4784; mul 4373 4524; sub 4785 4786; mul 136 2855; mul 4527 4788; mul 4125
4789; sub 4787 4790; mul 4376 4400; sub 4791 4792; mul 128 2855; mul 4534 4794; mul 4125 4795; sub 4793 4796; mul
4379 4539; mul 4080 4798; sub 4797 4799; mul 4383 4543; sub 4800 4801; mul 4386 4408; sub 4802 4803; mul 113 2855;
mul 4548 4805; mul 4125 4806; sub 4804 4807; mul 4389 4472; sub 4808 4809; mul 105 2855; mul 4414 4811; mul 4125
4812; sub 4810 4813; mul 4392 4479; mul 4080 4815; sub 4814 4816; constant -0.04285714285714284; mul 149 948; mul
4818 4819; constant 0.029931972789115628; mul 205 948; mul 4821 4822; add 4820 4823; constant
-0.0013605442176870806; mul 140 948; mul 4825 4826; add 4824 4827; constant -0.003571428571428574; mul 121 948; mul
4829 4830; add 4828 4831; constant 0.0027210884353741486; mul 117 948; mul 4833 4834; add 4832 4835; constant
-0.0014361300075585765; mul 109 948; mul 4837 4838; add 4836 4839; constant 0.00032473894907757275; mul 165 948; mul
4841 4842; add 4840 4843; constant -0.12857142857142845; mul 153 991; mul 4845 4846; add 4844 4847; constant
0.12857142857142853; mul 149 991; mul 4849 4850; add 4848 4851; mul 205 991; mul 4818 4853; add 4852 4854; constant
0.010714285714285735; mul 144 991; mul 4856 4857; add 4855 4858; constant -0.0006802721088435403; mul 132 991; mul
4860 4861; add 4859 4862; constant 0.028571428571428567; mul 121 991; mul 4864 4865; add 4863 4866; constant
-0.010714285714285721; mul 117 991; mul 4868 4869; add 4867 4870; mul 109 991; mul 4833 4872; add 4871 4873;
constant -0.0004787100025195255; mul 165 991; mul 4875 4876; add 4874 4877; constant 1.0285714285714285; mul 153
989; mul 4879 4880; add 4878 4881; constant -0.38571428571428534; mul 149 989; mul 4883 4884; add 4882 4885; mul 144
989; mul 4849 4887; add 4886 4888; constant -0.08571428571428567; mul 140 989; mul 4890 4891; add 4889 4892; mul 132
989; mul 4821 4894; add 4893 4895; constant 0.0035714285714285787; mul 121 989; mul 4897 4898; add 4896 4899; mul
109 989; mul 4860 4901; add 4900 4902; constant 0.2571428571428571; mul 417 1040; mul 4904 4905; add 4903 4906; mul
413 1040; mul 4845 4908; add 4907 4909; constant 0.06428571428571427; mul 410 1040; mul 4911 4912; add 4910 4913;
mul 406 1040; mul 4818 4915; add 4914 4916; constant 0.014965986394557814; mul 403 1040; mul 4918 4919; add 4917
4920; mul 397 1040; mul 4897 4922; add 4921 4923; mul 394 1040; mul 4860 4925; add 4924 4926; constant
0.007142857142857142; mul 389 1040; mul 4928 4929; add 4927 4930; mul 385 1040; mul 4829 4932; add 4931 4933;
constant 0.0013605442176870743; mul 381 1040; mul 4935 4936; add 4934 4937; mul 374 1040; mul 4875 4939; add 4938
4940; constant 8.118473726939319e-05; mul 369 1040; mul 4942 4943; add 4941 4944; mul 153 1864; mul 4845 4946; mul
149 1845; mul 4818 4948; mul 205 1845; mul 4821 4950; add 4949 4951; mul 140 1845; mul 4825 4953; add 4952 4954; mul
121 1845; mul 4829 4956; add 4955 4957; mul 117 1845; mul 4833 4959; add 4958 4960; mul 109 1845; mul 4837 4962; add
4961 4963; mul 165 1845; mul 4841 4965; add 4964 4966; sub 4947 4967; mul 149 1864; mul 4849 4969; add 4968 4970;
mul 205 1864; mul 4818 4972; add 4971 4973; mul 144 1864; mul 4856 4975; add 4974 4976; mul 132 1864; mul 4860 4978;
add 4977 4979; mul 121 1864; mul 4864 4981; add 4980 4982; mul 117 1864; mul 4868 4984; add 4983 4985; mul 109 1864;
mul 4833 4987; add 4986 4988; mul 165 1864; mul 4875 4990; add 4989 4991; mul 153 1862; mul 4879 4993; sub 4992
4994; mul 149 1862; mul 4883 4996; sub 4995 4997; mul 144 1862; mul 4849 4999; sub 4998 5000; mul 140 1862; mul 4890
5002; sub 5001 5003; mul 132 1862; mul 4821 5005; sub 5004 5006; mul 121 1862; mul 4897 5008; sub 5007 5009; mul 109
1862; mul 4860 5011; sub 5010 5012; mul 417 1913; mul 4904 5014; add 5013 5015; mul 413 1913; mul 4845 5017; add
5016 5018; mul 410 1913; mul 4911 5020; add 5019 5021; mul 406 1913; mul 4818 5023; add 5022 5024; mul 403 1913; mul
4918 5026; add 5025 5027; mul 397 1913; mul 4897 5029; add 5028 5030; mul 394 1913; mul 4860 5032; add 5031 5033;
mul 389 1913; mul 4928 5035; add 5034 5036; mul 385 1913; mul 4829 5038; add 5037 5039; mul 381 1913; mul 4935 5041;
add 5040 5042; mul 374 1913; mul 4875 5044; add 5043 5045; mul 369 1913; mul 4942 5047; add 5046 5048; mul 149 2633;
mul 4818 5050; mul 205 2633; mul 4821 5052; add 5051 5053; mul 140 2633; mul 4825 5055; add 5054 5056; mul 121 2633;
mul 4829 5058; add 5057 5059; mul 117 2633; mul 4833 5061; add 5060 5062; mul 109 2633; mul 4837 5064; add 5063
5065; mul 165 2633; mul 4841 5067; add 5066 5068; mul 153 2674; mul 4845 5070; add 5069 5071; mul 149 2674; mul 4849
5073; add 5072 5074; mul 205 2674; mul 4818 5076; add 5075 5077; mul 144 2674; mul 4856 5079; add 5078 5080; mul 132
2674; mul 4860 5082; add 5081 5083; mul 121 2674; mul 4864 5085; add 5084 5086; mul 117 2674; mul 4868 5088; add
5087 5089; mul 109 2674; mul 4833 5091; add 5090 5092; mul 165 2674; mul 4875 5094; add 5093 5095; mul 153 2672; mul
4879 5097; add 5096 5098; mul 149 2672; mul 4883 5100; add 5099 5101; mul 144 2672; mul 4849 5103; add 5102 5104;
mul 140 2672; mul 4890 5106; add 5105 5107; mul 132 2672; mul 4821 5109; add 5108 5110; mul 121 2672; mul 4897 5112;
add 5111 5113; mul 109 2672; mul 4860 5115; add 5114 5116; mul 417 2723; mul 4904 5118; add 5117 5119; mul 413 2723;
mul 4845 5121; add 5120 5122; mul 410 2723; mul 4911 5124; add 5123 5125; mul 406 2723; mul 4818 5127; add 5126
5128; mul 403 2723; mul 4918 5130; add 5129 5131; mul 397 2723; mul 4897 5133; add 5132 5134; mul 394 2723; mul 4860
5136; add 5135 5137; mul 389 2723; mul 4928 5139; add 5138 5140; mul 385 2723; mul 4829 5142; add 5141 5143; mul 381
2723; mul 4935 5145; add 5144 5146; mul 374 2723; mul 4875 5148; add 5147 5149; mul 369 2723; mul 4942 5151; add
5150 5152; mul 149 3289; mul 4818 5154; mul 205 3289; mul 4821 5156; add 5155 5157; mul 140 3289; mul 4825 5159; add
5158 5160; mul 121 3289; mul 4829 5162; add 5161 5163; mul 117 3289; mul 4833 5165; add 5164 5166; mul 109 3289; mul
4837 5168; add 5167 5169; mul 165 3289; mul 4841 5171; add 5170 5172; mul 153 3307; mul 4845 5174; add 5173 5175;
mul 149 3307; mul 4849 5177; add 5176 5178; mul 205 3307; mul 4818 5180; add 5179 5181; mul 144 3307; mul 4856 5183;
add 5182 5184; mul 132 3307; mul 4860 5186; add 5185 5187; mul 121 3307; mul 4864 5189; add 5188 5190; mul 117 3307;
mul 4868 5192; add 5191 5193; mul 109 3307; mul 4833 5195; add 5194 5196; mul 165 3307; mul 4875 5198; add 5197
5199; mul 153 3305; mul 4879 5201; add 5200 5202; mul 149 3305; mul 4883 5204; add 5203 5205; mul 144 3305; mul 4849
5207; add 5206 5208; mul 140 3305; mul 4890 5210; add 5209 5211; mul 132 3305; mul 4821 5213; add 5212 5214; mul 121
3305; mul 4897 5216; add 5215 5217; mul 109 3305; mul 4860 5219; add 5218 5220; mul 417 3356; mul 4904 5222; add
5221 5223; mul 413 3356; mul 4845 5225; add 5224 5226; mul 410 3356; mul 4911 5228; add 5227 5229; mul 406 3356; mul
4818 5231; add 5230 5232; mul 403 3356; mul 4918 5234; add 5233 5235; mul 397 3356; mul 4897 5237; add 5236 5238;
mul 394 3356; mul 4860 5240; add 5239 5241; mul 389 3356; mul 4928 5243; add 5242 5244; mul 385 3356; mul 4829 5246;
add 5245 5247; mul 381 3356; mul 4935 5249; add 5248 5250; mul 374 3356; mul 4875 5252; add 5251 5253; mul 369 3356;
mul 4942 5255; add 5254 5256; mul 149 3586; mul 4818 5258; mul 205 3586; mul 4821 5260; add 5259 5261; mul 140 3586;
mul 4825 5263; add 5262 5264; mul 121 3586; mul 4829 5266; add 5265 5267; mul 117 3586; mul 4833 5269; add 5268
5270; mul 109 3586; mul 4837 5272; add 5271 5273; mul 165 3586; mul 4841 5275; add 5274 5276; mul 153 3604; mul 4845
5278; add 5277 5279; mul 149 3604; mul 4849 5281; add 5280 5282; mul 205 3604; mul 4818 5284; add 5283 5285; mul 144
3604; mul 4856 5287; add 5286 5288; mul 132 3604; mul 4860 5290; add 5289 5291; mul 121 3604; mul 4864 5293; add
5292 5294; mul 117 3604; mul 4868 5296; add 5295 5297; mul 109 3604; mul 4833 5299; add 5298 5300; mul 165 3604; mul
4875 5302; add 5301 5303; mul 153 3602; mul 4879 5305; add 5304 5306; mul 149 3602; mul 4883 5308; add 5307 5309;
mul 144 3602; mul 4849 5311; add 5310 5312; mul 140 3602; mul 4890 5314; add 5313 5315; mul 132 3602; mul 4821 5317;
add 5316 5318; mul 121 3602; mul 4897 5320; add 5319 5321; mul 109 3602; mul 4860 5323; add 5322 5324; mul 417 3653;
mul 4904 5326; add 5325 5327; mul 413 3653; mul 4845 5329; add 5328 5330; mul 410 3653; mul 4911 5332; add 5331
5333; mul 406 3653; mul 4818 5335; add 5334 5336; mul 403 3653; mul 4918 5338; add 5337 5339; mul 397 3653; mul 4897
5341; add 5340 5342; mul 394 3653; mul 4860 5344; add 5343 5345; mul 389 3653; mul 4928 5347; add 5346 5348; mul 385
3653; mul 4829 5350; add 5349 5351; mul 381 3653; mul 4935 5353; add 5352 5354; mul 374 3653; mul 4875 5356; add
5355 5357; mul 369 3653; mul 4942 5359; add 5358 5360; input p 217; mul 4458 5362; mul 4405 5362; mul 4416 5362; add
5364 5365; mul 4427 5362; add 5366 5367; mul 4435 5362; add 5368 5369; input p 218; input p 219; mul 4082 5372; mul
5371 5373; add 5370 5374; mul 4443 5362; add 5375 5376; mul 4090 5372; mul 5371 5378; add 5377 5379; mul 4447 5362;
mul 5371 5381; add 5380 5382; sub 5363 5383; mul 4469 5362; add 5384 5385; mul 4476 5362; add 5386 5387; mul 4114
5372; mul 5371 5389; add 5388 5390; mul 4480 5362; mul 5371 5392; add 5391 5393; mul 4126 5372; sub 5394 5395; mul
4490 5362; add 5396 5397; mul 4497 5362; add 5398 5399; mul 4133 5372; mul 5371 5401; add 5400 5402; mul 4500 5362;
mul 5371 5404; add 5403 5405; mul 4508 5362; add 5406 5407; mul 4141 5372; mul 5371 5409; add 5408 5410; mul 4513
5362; mul 4080 5412; add 5411 5413; mul 4125 5412; mul 5371 5415; add 5414 5416; add 4513 5417; mul 4529 5362; sub
5418 5419; mul 4536 5362; sub 5420 5421; mul 4163 5372; mul 5371 5423; sub 5422 5424; mul 4540 5362; mul 5371 5426;
sub 5425 5427; mul 4550 5362; sub 5428 5429; mul 4556 5362; sub 5430 5431; mul 4177 5372; mul 5371 5433; sub 5432
5434; mul 4559 5362; mul 5371 5436; sub 5435 5437; mul 4566 5362; mul 4574 5362; add 5439 5440; mul 4582 5362; add
5441 5442; mul 4588 5362; add 5443 5444; mul 4201 5372; mul 5371 5446; add 5445 5447; mul 4594 5362; add 5448 5449;
mul 4208 5372; mul 5371 5451; add 5450 5452; mul 4597 5362; mul 5371 5454; add 5453 5455; mul 4607 5362; add 5456
5457; mul 4615 5362; add 5458 5459; mul 4621 5362; add 5460 5461; mul 4230 5372; mul 5371 5463; add 5462 5464; mul
4624 5362; mul 5371 5466; add 5465 5467; mul 4239 5372; sub 5468 5469; mul 4631 5362; add 5470 5471; mul 4637 5362;
add 5472 5473; mul 4246 5372; mul 5371 5475; add 5474 5476; mul 4640 5362; mul 5371 5478; add 5477 5479; mul 4646
5362; add 5480 5481; mul 4253 5372; mul 5371 5483; add 5482 5484; mul 4649 5362; mul 4080 5486; add 5485 5487; mul
4125 5486; mul 5371 5489; add 5488 5490; add 4649 5491; mul 4661 5362; add 5492 5493; mul 4667 5362; add 5494 5495;
mul 4272 5372; mul 5371 5497; add 5496 5498; mul 4670 5362; mul 5371 5500; add 5499 5501; mul 4678 5362; add 5502
5503; mul 4684 5362; add 5504 5505; mul 4285 5372; mul 5371 5507; add 5506 5508; mul 4687 5362; mul 5371 5510; add
5509 5511; mul 4735 5362; mul 4695 5362; mul 4703 5362; add 5514 5515; mul 4711 5362; add 5516 5517; mul 4717 5362;
add 5518 5519; mul 4311 5372; mul 5371 5521; add 5520 5522; mul 4723 5362; add 5523 5524; mul 4318 5372; mul 5371
5526; add 5525 5527; mul 4726 5362; mul 5371 5529; add 5528 5530; sub 5513 5531; mul 4743 5362; add 5532 5533; mul
4749 5362; add 5534 5535; mul 4338 5372; mul 5371 5537; add 5536 5538; mul 4752 5362; mul 5371 5540; add 5539 5541;
mul 4347 5372; sub 5542 5543; mul 4759 5362; add 5544 5545; mul 4765 5362; add 5546 5547; mul 4354 5372; mul 5371
5549; add 5548 5550; mul 4768 5362; mul 5371 5552; add 5551 5553; mul 4774 5362; add 5554 5555; mul 4361 5372; mul
5371 5557; add 5556 5558; mul 4777 5362; mul 4080 5560; add 5559 5561; mul 4125 5560; mul 5371 5563; add 5562 5564;
add 4777 5565; mul 4789 5362; sub 5566 5567; mul 4795 5362; sub 5568 5569; mul 4380 5372; mul 5371 5571; sub 5570
5572; mul 4798 5362; mul 5371 5574; sub 5573 5575; mul 4806 5362; sub 5576 5577; mul 4812 5362; sub 5578 5579; mul
4393 5372; mul 5371 5581; sub 5580 5582; mul 4815 5362; mul 5371 5584; sub 5583 5585; mul 538 836; mul 692 707; sub
5587 5588; mul 359 989; add 5589 5590; mul 212 1187; sub 5591 5592; mul 95 1553; add 5593 5594; mul 692 1621; mul
538 1731; add 5596 5597; mul 359 1862; sub 5598 5599; mul 212 2051; add 5600 5601; mul 95 2398; add 5602 5603; mul
538 2540; mul 692 2430; sub 5605 5606; mul 359 2672; add 5607 5608; mul 212 2855; sub 5609 5610; mul 95 3216; add
5611 5612; mul 359 3305; mul 95 3529; add 5614 5615; mul 359 3602; mul 95 3826; add 5617 5618; mul 692 699; mul 212
1141; add 5620 5621; mul 525 836; add 5622 5623; mul 359 986; add 5624 5625; mul 2 1553; add 5626 5627; mul 525
1731; mul 692 1609; mul 212 1999; add 5630 5631; sub 5629 5632; mul 359 1858; add 5633 5634; mul 2 2398; add 5635
5636; mul 692 1618; mul 212 1823; add 5638 5639; mul 525 2540; add 5640 5641; mul 359 2669; add 5642 5643; mul 2
3216; add 5644 5645; mul 359 3302; mul 2 3529; add 5647 5648; mul 359 3599; mul 2 3826; add 5650 5651; mul 570 836;
mul 692 703; mul 212 952; add 5654 5655; sub 5653 5656; mul 359 948; add 5657 5658; mul 34 1553; add 5659 5660; mul
570 1731; add 5640 5662; mul 359 1845; sub 5663 5664; mul 34 2398; add 5665 5666; mul 570 2540; mul 692 2426; mul
212 2637; add 5669 5670; sub 5668 5671; mul 359 2633; add 5672 5673; mul 34 3216; add 5674 5675; mul 359 3289; mul
34 3529; add 5677 5678; mul 359 3586; mul 34 3826; add 5680 5681; mul 95 1053; mul 95 1926; mul 95 2736; mul 95
3369; mul 95 3666; mul 95 1047; mul 2 1053; add 5688 5689; mul 95 1920; mul 2 1926; add 5691 5692; mul 95 2730; mul
2 2736; add 5694 5695; mul 95 3363; mul 2 3369; add 5697 5698; mul 95 3660; mul 2 3666; add 5700 5701; mul 2 1047;
mul 2 1920; mul 2 2730; mul 2 3363; mul 2 3660; mul 95 1043; mul 34 1053; add 5708 5709; mul 95 1916; mul 34 1926;
add 5711 5712; mul 95 2726; mul 34 2736; add 5714 5715; mul 95 3359; mul 34 3369; add 5717 5718; mul 95 3656; mul 34
3666; add 5720 5721; mul 2 1043; mul 34 1047; add 5723 5724; mul 2 1916; mul 34 1920; add 5726 5727; mul 2 2726; mul
34 2730; add 5729 5730; mul 2 3359; mul 34 3363; add 5732 5733; mul 2 3656; mul 34 3660; add 5735 5736; mul 34 1043;
mul 34 1916; mul 34 2726; mul 34 3359; mul 34 3656; mul 2 2; sub 6 5743; div 1 5744; mul 2 16; mul 525 525; mul 21
90; mul 21 699; mul 25 5749; sub 5748 5750; mul 5747 5751; mul 22 5752; mul 23 5753; mul 699 5747; mul 18 5755; sub
5754 5756; mul 41 5749; mul 21 703; mul 53 5759; sub 5758 5760; mul 67 5748; sub 5761 5762; mul 5747 5763; mul 22
5764; mul 38 5765; sub 5757 5766; mul 5746 5767; mul 5745 5768; mul 9 5745; mul 5745 5770; mul 5768 5771; div 1 6;
input p 137; mul 5773 5774; mul 5773 5775; mul 5768 5776; add 5772 5777; mul 2 5778; mul 2 5779; sub 5769 5780; mul
5768 5773; mul 219 5782; add 5781 5783; mul 8 8; mul 661 719; input p 142; mul 38 5787; mul 699 5788; sub 5786 5789;
mul 531 856; add 5790 5791; mul 15 5792; mul 5785 5793; mul 15 16; mul 5792 5795; mul 15 38; mul 592 721; mul 583
5798; mul 16 699; mul 5787 5800; mul 585 721; mul 580 5802; add 5801 5803; sub 5799 5804; mul 583 804; add 5805
5806; mul 601 780; mul 656 721; add 5808 5809; mul 219 592; mul 802 5811; add 5810 5812; mul 580 5813; add 5807
5814; mul 448 858; mul 443 5816; sub 5815 5817; mul 455 858; mul 446 5819; sub 5818 5820; mul 446 941; sub 5821
5822; mul 464 917; mul 526 858; add 5824 5825; mul 219 455; mul 939 5827; add 5826 5828; mul 443 5829; add 5823
5830; mul 5797 5831; add 5796 5832; mul 15 23; mul 583 5802; mul 580 5798; add 5835 5836; mul 580 804; add 5837
5838; mul 583 5813; sub 5839 5840; mul 446 5816; sub 5841 5842; mul 443 5819; add 5843 5844; mul 443 941; add 5845
5846; mul 446 5829; add 5847 5848; mul 5834 5849; add 5833 5850; mul 13 5851; add 5794 5852; mul 7 219; div 1 5854;
mul 5853 5855; mul 2 5856; mul 2 5857; sub 5784 5858; mul 15 5849; mul 15 5831; mul 2 5861; mul 7 5851; sub 5862
5863; mul 13 219; div 1 5865; mul 5864 5866; add 5860 5867; mul 2 5868; mul 2 5869; add 5859 5870; add 5770 5775;
mul 5746 5872; mul 5753 5873; mul 16 5765; mul 16 5875; add 5874 5876; mul 92 3928; mul 92 3891; where 1114 5879;
add 5878 5880; mul 569 673; sub 5881 5882; input p 154; mul 570 5884; mul 100 692; add 5885 5886; add 5883 5887; mul
62 534; mul 27 525; add 5889 5890; mul 47 570; add 5891 5892; mul 534 5893; mul 27 534; mul 30 525; add 5895 5896;
mul 33 570; add 5897 5898; mul 525 5899; add 5894 5900; mul 47 534; mul 33 525; add 5902 5903; mul 51 570; add 5904
5905; mul 570 5906; add 5901 5907; mul 16 23; mul 16 5909; mul 38 5873; sub 5910 5911; mul 22 5912; mul 5747 5913;
add 5908 5914; mul 53 5915; mul 21 5916; add 5888 5917; mul 89 703; mul 5918 5919; mul 92 3974; mul 92 3970; where
1140 5922; add 5921 5923; mul 542 673; sub 5924 5925; mul 97 692; add 5926 5927; mul 532 576; mul 662 670; add 5929
5930; add 5928 5931; sub 1578 5932; mul 16 5788; add 5933 5934; input p 128; input z 0; mul 5936 5937; input p 129;
input z 1; mul 5939 5940; add 5938 5941; input p 130; input z 2; mul 5943 5944; add 5942 5945; input p 131; input z
3; mul 5947 5948; add 5946 5949; input p 143; mul 5950 5951; sub 5935 5952; mul 41 5915; mul 23 5873; mul 16 38; mul
16 5956; add 5955 5957; mul 22 5958; mul 5747 5959; mul 25 5960; sub 5954 5961; mul 21 5962; mul 18 5873; mul 5747
5964; sub 5963 5965; sub 5953 5966; mul 89 699; mul 5967 5968; add 5920 5969; input c 0; input c 2; mul 485 5972;
add 5971 5973; input c 3; mul 619 5975; add 5974 5976; mul 1562 1596; add 5977 5978; mul 1560 1578; sub 5979 5980;
input p 16; input c 1; add 5982 5983; constant 0.0; max 5984 5985; mul 534 5986; sub 5981 5987; mul 535 576; mul 664
670; add 5989 5990; sub 696 5991; sub 5988 5992; input p 127; sub 5994 5950; input p 132; abs 534; mul 5996 5997;
mul 534 5998; input p 133; mul 534 6000; mul 534 534; input p 134; add 6002 6003; sqrt 6004; div 1 6005; mul 6001
6006; add 5999 6007; sub 5995 6008; add 5993 6009; input p 135; input x 12; sub 28 6012; mul 6011 6013; input p 136;
input x 13; sub 28 6016; mul 6015 6017; add 6014 6018; sub 6010 6019; mul 67 5915; sub 6021 5960; mul 21 6022; sub
6020 6023; mul 89 90; mul 6024 6025; sub 5970 6026; mul 79 6027; mul 59 6028; mul 76 6027; mul 56 6030; sub 6029
6031; mul 21 6032; mul 5749 5960; sub 6033 6034; mul 89 5918; mul 59 6036; mul 89 5967; mul 56 6038; add 6037 6039;
mul 81 6027; add 6040 6041; mul 21 6042; sub 6035 6043; mul 25 219; mul 79 6036; mul 79 6028; sub 6046 6047; mul 70
6027; mul 56 6049; add 6048 6050; mul 89 6024; mul 56 6052; add 6051 6053; mul 21 6054; mul 6045 6055; add 6044
6056; mul 16 6057; mul 22 6058; add 5877 6059; mul 15 6060; mul 16 5753; mul 16 6062; mul 5765 5873; sub 6063 6064;
mul 5749 5915; mul 67 6033; add 6066 6067; mul 67 6043; sub 6068 6069; mul 79 6038; mul 76 6028; add 6071 6072; mul
59 6049; sub 6073 6074; mul 59 6052; sub 6075 6076; mul 21 6077; mul 53 6078; add 6070 6079; mul 79 6030; mul 76
6036; sub 6081 6082; sub 6083 6074; sub 6084 6076; mul 21 6085; mul 53 6086; add 6080 6087; mul 41 219; mul 6055
6089; add 6088 6090; mul 16 6091; mul 22 6092; add 6065 6093; mul 15 6094; mul 2 6095; mul 5797 6094; mul 5834 6060;
add 6097 6098; mul 5753 5956; mul 5755 5873; mul 17 6101; sub 6100 6102; mul 38 6062; add 6103 6104; mul 5767 5872;
mul 2 6106; add 6105 6107; mul 5765 5909; add 6108 6109; mul 23 5875; add 6110 6111; mul 39 6091; add 6112 6113; mul
24 6057; add 6114 6115; mul 18 6054; add 6116 6117; mul 16 6054; mul 17 6119; add 6118 6120; mul 5795 6121; add 6099
6122; mul 7 6123; sub 6096 6124; mul 5866 6125; add 6061 6126; mul 2 6127; mul 2 6128; add 5871 6129; mul 13 6123;
mul 15 6121; mul 5785 6132; add 6131 6133; mul 5855 6134; mul 2 6135; mul 2 6136; sub 6130 6137; mul 1609 5747; mul
18 6139; mul 21 1609; mul 25 6141; sub 6142 5749; mul 5747 6143; mul 22 6144; mul 23 6145; add 6140 6146; mul 21
1618; mul 53 6148; mul 41 6141; sub 6149 6150; mul 67 5749; add 6151 6152; mul 5747 6153; mul 22 6154; mul 38 6155;
sub 6147 6156; mul 5746 6157; mul 5745 6158; mul 5771 6158; mul 5776 6158; add 6160 6161; mul 2 6162; mul 2 6163;
sub 6159 6164; mul 5773 6158; mul 219 6166; add 6165 6167; mul 1609 5788; mul 661 1686; sub 6169 6170; mul 531 1747;
sub 6171 6172; mul 15 6173; mul 5785 6174; mul 5795 6173; mul 16 1609; mul 5787 6177; mul 585 1710; mul 580 6179;
add 6178 6180; mul 592 1710; mul 583 6182; sub 6181 6183; mul 583 1713; add 6184 6185; mul 601 1677; mul 656 1710;
sub 6187 6188; mul 1707 5811; add 6189 6190; mul 580 6191; add 6186 6192; mul 448 1749; mul 443 6194; add 6193 6195;
mul 455 1749; mul 446 6197; add 6196 6198; mul 446 1818; sub 6199 6200; mul 464 1793; mul 526 1749; sub 6202 6203;
mul 1816 5827; add 6204 6205; mul 443 6206; add 6201 6207; mul 5797 6208; add 6176 6209; mul 580 1713; mul 583 6179;
mul 580 6182; add 6212 6213; sub 6211 6214; mul 583 6191; sub 6215 6216; mul 446 6194; add 6217 6218; mul 443 6197;
sub 6219 6220; mul 443 1818; add 6221 6222; mul 446 6206; add 6223 6224; mul 5834 6225; add 6210 6226; mul 13 6227;
add 6175 6228; mul 5855 6229; mul 2 6230; mul 2 6231; sub 6168 6232; mul 15 6225; mul 15 6208; mul 2 6235; mul 7
6227; sub 6236 6237; mul 5866 6238; add 6234 6239; mul 2 6240; mul 2 6241; add 6233 6242; mul 5873 6145; mul 16
6155; mul 16 6245; add 6244 6246; mul 5960 6141; mul 5968 6024; mul 89 1618; mul 5918 6250; sub 6249 6251; mul 89
1609; mul 5967 6253; sub 6252 6254; mul 79 6255; mul 59 6256; add 6046 6053; sub 6257 6258; mul 76 6255; mul 56
6260; sub 6259 6261; mul 21 6262; add 6248 6263; mul 81 6255; mul 21 6265; sub 6264 6266; mul 70 6255; mul 56 6268;
mul 79 6256; sub 6269 6270; mul 21 6271; mul 6045 6272; add 6267 6273; mul 16 6274; mul 22 6275; add 6247 6276; mul
15 6277; mul 16 6145; mul 16 6279; mul 5873 6155; sub 6280 6281; mul 67 6263; mul 5915 6141; sub 6283 6284; mul 67
6266; sub 6285 6286; mul 76 6256; mul 59 6268; sub 6288 6289; mul 21 6290; mul 53 6291; add 6287 6292; mul 70 6036;
mul 79 6052; add 6294 6295; mul 79 6260; add 6296 6297; sub 6298 6289; mul 21 6299; mul 53 6300; add 6293 6301; mul
6089 6272; add 6302 6303; mul 16 6304; mul 22 6305; add 6282 6306; mul 15 6307; mul 2 6308; mul 5797 6307; mul 5834
6277; add 6310 6311; mul 5873 6139; mul 17 6313; mul 5956 6145; add 6314 6315; mul 38 6279; add 6316 6317; mul 5872
6157; mul 2 6319; add 6318 6320; mul 5909 6155; add 6321 6322; mul 23 6245; add 6323 6324; mul 39 6304; add 6325
6326; mul 24 6274; add 6327 6328; mul 18 6271; add 6329 6330; mul 16 6271; mul 17 6332; add 6331 6333; mul 5795
6334; add 6312 6335; mul 7 6336; sub 6309 6337; mul 5866 6338; add 6278 6339; mul 2 6340; mul 2 6341; add 6243 6342;
mul 13 6336; mul 15 6334; mul 5785 6345; add 6344 6346; mul 5855 6347; mul 2 6348; mul 2 6349; sub 6343 6350; mul 25
6148; sub 5759 6352; mul 5747 6353; mul 22 6354; mul 23 6355; mul 1618 5747; mul 18 6357; sub 6356 6358; mul 41
6148; mul 21 2426; mul 53 6361; sub 6360 6362; mul 67 5759; sub 6363 6364; mul 5747 6365; mul 22 6366; mul 38 6367;
sub 6359 6368; mul 5746 6369; mul 5745 6370; mul 5771 6370; mul 5776 6370; add 6372 6373; mul 2 6374; mul 2 6375;
sub 6371 6376; mul 5773 6370; mul 219 6378; add 6377 6379; mul 661 2442; mul 1618 5788; sub 6381 6382; mul 531 2560;
add 6383 6384; mul 15 6385; mul 5785 6386; mul 5795 6385; mul 592 2444; mul 583 6389; mul 16 1618; mul 5787 6391;
mul 585 2444; mul 580 6393; add 6392 6394; sub 6390 6395; mul 583 2510; add 6396 6397; mul 601 2486; mul 656 2444;
add 6399 6400; mul 2508 5811; add 6401 6402; mul 580 6403; add 6398 6404; mul 448 2562; mul 443 6406; sub 6405 6407;
mul 455 2562; mul 446 6409; sub 6408 6410; mul 446 2628; sub 6411 6412; mul 464 2604; mul 526 2562; add 6414 6415;
mul 2626 5827; add 6416 6417; mul 443 6418; add 6413 6419; mul 5797 6420; add 6388 6421; mul 583 6393; mul 580 6389;
add 6423 6424; mul 580 2510; add 6425 6426; mul 583 6403; sub 6427 6428; mul 446 6406; sub 6429 6430; mul 443 6409;
add 6431 6432; mul 443 2628; add 6433 6434; mul 446 6418; add 6435 6436; mul 5834 6437; add 6422 6438; mul 13 6439;
add 6387 6440; mul 5855 6441; mul 2 6442; mul 2 6443; sub 6380 6444; mul 15 6437; mul 15 6420; mul 2 6447; mul 7
6439; sub 6448 6449; mul 5866 6450; add 6446 6451; mul 2 6452; mul 2 6453; add 6445 6454; mul 5873 6355; mul 16
6367; mul 16 6457; add 6456 6458; add 6076 6082; mul 89 2426; mul 5918 6461; mul 5967 6250; add 6462 6463; mul 5919
6024; sub 6464 6465; mul 79 6466; mul 59 6467; add 6460 6468; mul 76 6466; mul 56 6470; sub 6469 6471; mul 21 6472;
mul 5960 6148; sub 6473 6474; add 6071 6082; mul 81 6466; sub 6476 6477; mul 21 6478; add 6475 6479; mul 70 6466;
mul 56 6481; mul 79 6467; add 6296 6483; sub 6482 6484; mul 21 6485; mul 6045 6486; add 6480 6487; mul 16 6488; mul
22 6489; add 6459 6490; mul 15 6491; mul 16 6355; mul 16 6493; mul 5873 6367; sub 6494 6495; mul 5915 6148; mul 67
6473; add 6497 6498; mul 67 6479; add 6499 6500; mul 76 6052; mul 70 6038; sub 6502 6503; mul 76 6467; add 6504
6505; mul 59 6481; sub 6506 6507; mul 21 6508; mul 53 6509; add 6501 6510; mul 79 6470; sub 6512 6507; mul 21 6513;
mul 53 6514; add 6511 6515; mul 6089 6486; add 6516 6517; mul 16 6518; mul 22 6519; add 6496 6520; mul 15 6521; mul
2 6522; mul 5797 6521; mul 5834 6491; add 6524 6525; mul 5956 6355; mul 5873 6357; mul 17 6528; sub 6527 6529; mul
38 6493; add 6530 6531; mul 5872 6369; mul 2 6533; add 6532 6534; mul 5909 6367; add 6535 6536; mul 23 6457; add
6537 6538; mul 39 6518; add 6539 6540; mul 24 6488; add 6541 6542; mul 18 6485; add 6543 6544; mul 16 6485; mul 17
6546; add 6545 6547; mul 5795 6548; add 6526 6549; mul 7 6550; sub 6523 6551; mul 5866 6552; add 6492 6553; mul 2
6554; mul 2 6555; add 6455 6556; mul 13 6550; mul 15 6548; mul 5785 6559; add 6558 6560; mul 5855 6561; mul 2 6562;
mul 2 6563; sub 6557 6564; mul 455 3253; mul 443 6566; mul 448 3253; mul 446 6568; sub 6567 6569; mul 443 3285; add
6570 6571; mul 526 3253; mul 464 3271; sub 6573 6574; mul 3283 5827; add 6575 6576; mul 446 6577; add 6572 6578; mul
15 6579; mul 443 6577; mul 443 6568; mul 446 6566; add 6582 6583; mul 446 3285; add 6584 6585; sub 6581 6586; mul 15
6587; mul 2 6588; mul 531 3251; mul 5795 6590; mul 5797 6587; add 6591 6592; mul 5834 6579; add 6593 6594; mul 7
6595; sub 6589 6596; mul 5866 6597; add 6580 6598; mul 2 6599; mul 2 6600; mul 15 6590; mul 5785 6602; mul 13 6595;
add 6603 6604; mul 5855 6605; mul 2 6606; mul 2 6607; sub 6601 6608; mul 585 3541; mul 583 6610; mul 592 3541; mul
580 6612; add 6611 6613; mul 580 3573; add 6614 6615; mul 656 3541; mul 601 3559; sub 6617 6618; mul 3571 5811; add
6619 6620; mul 583 6621; sub 6616 6622; mul 15 6623; mul 583 6612; mul 580 6610; sub 6625 6626; mul 583 3573; add
6627 6628; mul 580 6621; add 6629 6630; mul 15 6631; mul 2 6632; mul 661 3539; mul 5795 6634; mul 5797 6631; add
6635 6636; mul 5834 6623; add 6637 6638; mul 7 6639; sub 6633 6640; mul 5866 6641; add 6624 6642; mul 2 6643; mul 2
6644; mul 15 6634; mul 5785 6646; mul 13 6639; add 6647 6648; mul 5855 6649; mul 2 6650; mul 2 6651; sub 6645 6652;
mul 248 1200; mul 280 1187; add 6654 6655; neg 6656; where 218 6657; mul 248 2062; mul 280 2051; add 6659 6660;
where 218 6661; mul 248 2868; mul 280 2855; add 6663 6664; neg 6665; where 218 6666; mul 280 1141; where 1140 6668;
mul 230 1200; neg 6670; where 218 6671; add 6669 6672; mul 280 1999; neg 6674; where 1140 6675; mul 230 2062; where
218 6677; add 6676 6678; mul 280 1823; where 1140 6680; mul 230 2868; neg 6682; where 218 6683; add 6681 6684; mul
280 952; neg 6686; where 1114 6687; mul 222 1200; neg 6689; where 218 6690; add 6688 6691; where 1114 6680; mul 222
2062; where 218 6694; add 6693 6695; mul 280 2637; neg 6697; where 1114 6698; mul 222 2868; neg 6700; where 218
6701; add 6699 6702; mul 1141 3887; where 1140 6704; mul 265 1141; where 1140 6706; mul 230 1188; neg 6708; where
218 6709; add 6707 6710; mul 230 6711; add 6705 6712; mul 1999 3887; neg 6714; where 1140 6715; mul 265 1999; neg
6717; where 1140 6718; mul 230 2052; where 218 6720; add 6719 6721; mul 230 6722; add 6716 6723; mul 1823 3887;
where 1140 6725; mul 265 1823; where 1140 6727; mul 230 2856; neg 6729; where 218 6730; add 6728 6731; mul 230 6732;
add 6726 6733; mul 952 3887; neg 6735; where 1114 6736; mul 222 6711; add 6737 6738; where 1114 6725; mul 222 6722;
add 6740 6741; mul 2637 3887; neg 6743; where 1114 6744; mul 222 6732; add 6745 6746; mul 952 3882; neg 6748; where
1114 6749; mul 265 952; neg 6751; where 1114 6752; mul 222 1188; neg 6754; where 218 6755; add 6753 6756; mul 222
6757; add 6750 6758; mul 1823 3882; where 1114 6760; where 1114 6727; mul 222 2052; where 218 6763; add 6762 6764;
mul 222 6765; add 6761 6766; mul 2637 3882; neg 6768; where 1114 6769; mul 265 2637; neg 6771; where 1114 6772; mul
222 2856; neg 6774; where 218 6775; add 6773 6776; mul 222 6777; add 6770 6778; mul 1141 3879; where 1140 6780; mul
1141 3873; where 1140 6782; mul 248 1141; where 1140 6784; mul 230 1187; neg 6786; where 218 6787; add 6785 6788;
mul 230 6789; add 6783 6790; mul 230 6791; add 6781 6792; mul 1999 3879; neg 6794; where 1140 6795; mul 1999 3873;
neg 6797; where 1140 6798; mul 248 1999; neg 6800; where 1140 6801; mul 230 2051; where 218 6803; add 6802 6804; mul
230 6805; add 6799 6806; mul 230 6807; add 6796 6808; mul 1823 3879; where 1140 6810; mul 1823 3873; where 1140
6812; mul 248 1823; where 1140 6814; mul 230 2855; neg 6816; where 218 6817; add 6815 6818; mul 230 6819; add 6813
6820; mul 230 6821; add 6811 6822; mul 952 3879; neg 6824; where 1114 6825; mul 222 6791; add 6826 6827; where 1114
6810; mul 222 6807; add 6829 6830; mul 2637 3879; neg 6832; where 1114 6833; mul 222 6821; add 6834 6835; mul 952
3874; neg 6837; where 1114 6838; mul 952 3873; neg 6840; where 1114 6841; mul 222 6789; add 6842 6843; mul 222 6844;
add 6839 6845; mul 1823 3874; where 1114 6847; where 1114 6812; mul 222 6805; add 6849 6850; mul 222 6851; add 6848
6852; mul 2637 3874; neg 6854; where 1114 6855; mul 2637 3873; neg 6857; where 1114 6858; mul 222 6819; add 6859
6860; mul 222 6861; add 6856 6862; mul 952 3866; neg 6864; where 1114 6865; mul 952 3865; neg 6867; where 1114 6868;
mul 248 952; neg 6870; where 1114 6871; mul 222 1187; neg 6873; where 218 6874; add 6872 6875; mul 222 6876; add
6869 6877; mul 222 6878; add 6866 6879; mul 1823 3866; where 1114 6881; mul 1823 3865; where 1114 6883; where 1114
6814; mul 222 2051; where 218 6886; add 6885 6887; mul 222 6888; add 6884 6889; mul 222 6890; add 6882 6891; mul
2637 3866; neg 6893; where 1114 6894; mul 2637 3865; neg 6896; where 1114 6897; mul 248 2637; neg 6899; where 1114
6900; mul 222 2855; neg 6902; where 218 6903; add 6901 6904; mul 222 6905; add 6898 6906; mul 222 6907; add 6895
6908; mul 1141 3932; mul 230 6910; mul 1141 3854; add 6911 6912; mul 230 6913; mul 1141 3862; add 6914 6915; where
1140 6916; mul 1999 3932; mul 230 6918; mul 1999 3854; add 6919 6920; mul 230 6921; mul 1999 3862; add 6922 6923;
neg 6924; where 1140 6925; mul 1823 3932; mul 230 6927; mul 1823 3854; add 6928 6929; mul 230 6930; mul 1823 3862;
add 6931 6932; where 1140 6933; mul 952 3862; neg 6935; where 1114 6936; mul 222 6913; where 1140 6938; add 6937
6939; where 1114 6932; mul 222 6921; neg 6942; where 1140 6943; add 6941 6944; mul 2637 3862; neg 6946; where 1114
6947; mul 222 6930; where 1140 6949; add 6948 6950; mul 952 3855; neg 6952; where 1114 6953; mul 952 3854; neg 6955;
where 1114 6956; mul 222 6910; where 1140 6958; add 6957 6959; mul 222 6960; add 6954 6961; mul 1823 3855; where
1114 6963; where 1114 6929; mul 222 6918; neg 6966; where 1140 6967; add 6965 6968; mul 222 6969; add 6964 6970; mul
2637 3855; neg 6972; where 1114 6973; mul 2637 3854; neg 6975; where 1114 6976; mul 222 6927; where 1140 6978; add
6977 6979; mul 222 6980; add 6974 6981; mul 952 3844; neg 6983; where 1114 6984; mul 952 3843; neg 6986; where 1114
6987; mul 230 952; neg 6989; where 1114 6990; mul 222 1141; where 1140 6992; add 6991 6993; mul 222 6994; add 6988
6995; mul 222 6996; add 6985 6997; mul 1823 3844; where 1114 6999; mul 1823 3843; where 1114 7001; mul 230 1823;
where 1114 7003; mul 222 1999; neg 7005; where 1140 7006; add 7004 7007; mul 222 7008; add 7002 7009; mul 222 7010;
add 7000 7011; mul 2637 3844; neg 7013; where 1114 7014; mul 2637 3843; neg 7016; where 1114 7017; mul 230 2637; neg
7019; where 1114 7020; mul 222 1823; where 1140 7022; add 7021 7023; mul 222 7024; add 7018 7025; mul 222 7026; add
7015 7027; mul 952 3838; mul 222 7029; mul 952 3831; add 7030 7031; mul 222 7032; mul 952 3832; add 7033 7034; neg
7035; where 1114 7036; mul 1823 3838; mul 222 7038; mul 1823 3831; add 7039 7040; mul 222 7041; mul 1823 3832; add
7042 7043; where 1114 7044; mul 2637 3838; mul 222 7046; mul 2637 3831; add 7047 7048; mul 222 7049; mul 2637 3832;
add 7050 7051; neg 7052; where 1114 7053; mul 699 5962; mul 703 5916; sub 7055 7056; mul 90 6022; sub 7057 7058; mul
45 6036; mul 59 6038; add 7060 7061; mul 86 6027; add 7062 7063; mul 78 7064; add 7059 7065; mul 59 6030; mul 45
6028; sub 7067 7068; mul 78 7069; add 7066 7070; mul 74 6032; add 7071 7072; mul 74 6042; sub 7073 7074; mul 61
6027; mul 69 7076; add 7075 7077; mul 58 6077; add 7078 7079; mul 58 6085; add 7080 7081; mul 45 6049; mul 76 6038;
mul 76 6030; add 7084 7085; sub 7083 7086; mul 45 6052; add 7087 7088; mul 54 7089; add 7082 7090; mul 43 6054; add
7091 7092; mul 1618 5916; mul 1609 5962; sub 7094 7095; mul 699 6022; add 7096 7097; mul 86 6255; sub 7099 6476; mul
78 7100; add 7098 7101; sub 6076 6071; mul 45 6256; sub 7103 7104; mul 59 6260; add 7105 7106; mul 78 7107; add 7102
7108; mul 74 6262; add 7109 7110; mul 74 6265; sub 7111 7112; mul 61 6255; add 6040 7114; mul 69 7115; add 7113
7116; mul 58 6290; add 7117 7118; mul 58 6299; add 7119 7120; sub 6503 6502; mul 76 6260; sub 7122 7123; mul 45
6268; add 7124 7125; mul 54 7126; add 7121 7127; mul 43 6271; add 7128 7129; mul 1618 5962; mul 2426 5916; sub 7131
7132; mul 703 6022; sub 7133 7134; mul 86 6466; mul 78 7136; add 7135 7137; sub 7084 7088; mul 45 6467; sub 7139
7140; mul 59 6470; add 7141 7142; mul 78 7143; add 7138 7144; mul 74 6472; add 7145 7146; mul 74 6478; add 7147
7148; mul 61 6466; sub 7150 7062; mul 69 7151; add 7149 7152; mul 58 6508; add 7153 7154; mul 58 6513; add 7155
7156; mul 45 6481; mul 76 6470; sub 7158 7159; mul 54 7160; add 7157 7161; mul 43 6485; add 7162 7163; sub 6032
6042; sub 6262 6265; add 6472 6478; mul 16 6119; mul 16 6101; sub 7168 7169; mul 16 6313; mul 16 6332; add 7171
7172; mul 16 6546; mul 16 6528; sub 7174 7175; mul 534 5763; mul 534 7177; mul 21 7064; mul 53 7179; mul 5748 5915;
sub 7180 7181; mul 21 7069; mul 53 7183; add 7182 7184; mul 41 6033; add 7185 7186; mul 41 6043; sub 7187 7188; mul
67 219; mul 21 7076; mul 7190 7191; add 7189 7192; mul 28 7193; add 7178 7194; mul 534 6153; mul 534 7196; mul 21
7100; mul 53 7198; add 6066 7199; mul 21 7107; mul 53 7201; add 7200 7202; mul 41 6263; add 7203 7204; mul 41 6266;
sub 7205 7206; mul 21 7115; mul 7190 7208; add 7207 7209; mul 28 7210; add 7197 7211; mul 534 6365; mul 534 7213;
mul 21 7136; mul 53 7215; mul 5759 5915; sub 7216 7217; mul 21 7143; mul 53 7219; add 7218 7220; mul 41 6473; add
7221 7222; mul 41 6479; add 7223 7224; mul 21 7151; mul 7190 7226; add 7225 7227; mul 28 7228; add 7214 7229; mul
525 5763; mul 534 7231; mul 525 7177; add 7232 7233; mul 2 7193; add 7234 7235; mul 28 6091; add 7236 7237; mul 525
6153; mul 534 7239; mul 525 7196; add 7240 7241; mul 2 7210; add 7242 7243; mul 28 6304; add 7244 7245; mul 525
6365; mul 534 7247; mul 525 7213; add 7248 7249; mul 2 7228; add 7250 7251; mul 28 6518; add 7252 7253; mul 525
7231; mul 2 6091; add 7255 7256; mul 525 7239; mul 2 6304; add 7258 7259; mul 525 7247; mul 2 6518; add 7261 7262;
mul 570 5763; mul 534 7264; mul 570 7177; add 7265 7266; mul 34 7193; add 7267 7268; mul 67 7179; sub 7270 7217; mul
67 7183; add 7271 7272; mul 41 6078; add 7273 7274; mul 41 6086; add 7275 7276; mul 53 219; mul 21 7089; mul 7278
7279; add 7277 7280; mul 28 7281; add 7269 7282; mul 570 6153; mul 534 7284; mul 570 7196; add 7285 7286; mul 34
7210; add 7287 7288; mul 67 7198; add 6497 7290; mul 67 7201; add 7291 7292; mul 41 6291; add 7293 7294; mul 41
6300; add 7295 7296; mul 21 7126; mul 7278 7298; add 7297 7299; mul 28 7300; add 7289 7301; mul 570 6365; mul 534
7303; mul 570 7213; add 7304 7305; mul 34 7228; add 7306 7307; mul 67 7215; mul 5915 6361; sub 7309 7310; mul 67
7219; add 7311 7312; mul 41 6509; add 7313 7314; mul 41 6514; add 7315 7316; mul 21 7160; mul 7278 7318; add 7317
7319; mul 28 7320; add 7308 7321; mul 525 7264; mul 570 7231; add 7323 7324; mul 2 7281; add 7325 7326; mul 34 6091;
add 7327 7328; mul 525 7284; mul 570 7239; add 7330 7331; mul 2 7300; add 7332 7333; mul 34 6304; add 7334 7335; mul
525 7303; mul 570 7247; add 7337 7338; mul 2 7320; add 7339 7340; mul 34 6518; add 7341 7342; mul 570 7264; mul 34
7281; add 7344 7345; mul 570 7284; mul 34 7300; add 7347 7348; mul 570 7303; mul 34 7320; add 7350 7351; mul 38
5800; mul 22 7353; sub 709 7354; mul 38 6177; mul 22 7356; add 1623 7357; mul 38 6391; mul 22 7359; sub 2432 7360;
mul 5752 5958; mul 364 7353; sub 7362 7363; mul 5764 5912; add 7364 7365; mul 38 6092; add 7366 7367; mul 23 6058;
add 7368 7369; mul 364 7356; mul 5958 6144; add 7371 7372; mul 5912 6154; add 7373 7374; mul 38 6305; add 7375 7376;
mul 23 6275; add 7377 7378; mul 5958 6354; mul 364 7359; sub 7380 7381; mul 5912 6366; add 7382 7383; mul 38 6519;
add 7384 7385; mul 23 6489; add 7386 7387; neg 699; neg 498; neg 632; neg 501; neg 635; neg 505; neg 639; input p
220; mul 609 736; mul 7396 7397; add 736 7398; input p 221; mul 7397 7400; mul 420 7401; add 7399 7402; add 873
7403; mul 475 873; mul 7396 7405; add 7404 7406; mul 7400 7405; mul 420 7408; add 7407 7409; mul 609 1652; mul 7396
7411; add 1652 7412; mul 7400 7411; mul 420 7414; add 7413 7415; add 1768 7416; mul 475 1768; mul 7396 7418; add
7417 7419; mul 7400 7418; mul 420 7421; add 7420 7422; neg 7423; mul 609 2456; mul 7396 7425; add 2456 7426; mul
7400 7425; mul 420 7428; add 7427 7429; add 2574 7430; mul 475 2574; mul 7396 7432; add 7431 7433; mul 7400 7432;
mul 420 7435; add 7434 7436; mul 475 3258; mul 7396 7438; add 3258 7439; mul 7400 7438; mul 420 7441; add 7440 7442;
mul 609 3546; mul 7396 7444; add 3546 7445; mul 7400 7444; mul 420 7447; add 7446 7448; le 5985 5984; le 5984 5985;
add 7450 7451; div 1 7452; mul 7450 7453; mul 90 534; mul 7454 7455; neg 7456; mul 534 699; mul 7454 7458; mul 534
703; mul 7454 7460; neg 7461; mul 5997 7455; neg 7463; mul 5997 7458; mul 5997 7460; neg 7466; mul 90 6006; mul 534
7468; neg 7469; mul 699 6006; mul 534 7471; mul 703 6006; mul 534 7473; neg 7474; input p 222; mul 6006 6007; mul 90
7477; mul 219 6005; div 1 7479; mul 7478 7480; mul 7476 7481; mul 699 7477; mul 7480 7483; mul 7476 7484; neg 7485;
mul 703 7477; mul 7480 7487; mul 7476 7488; mul 699 5950; mul 1609 5950; neg 7491; mul 1618 5950; le 1 5937; mul 525
5951; add 534 7495; lt 5985 7496; and 7494 7497; constant -1.0; le 5937 7499; lt 7496 5985; and 7500 7501; or 7498
7502; not 7503; input p 160; mul 525 7505; where 7504 7506; le 1 5940; and 7497 7508; le 5940 7499; and 7501 7510;
or 7509 7511; not 7512; input p 161; mul 525 7514; where 7513 7515; le 1 5944; and 7497 7517; le 5944 7499; and 7501
7519; or 7518 7520; not 7521; input p 162; mul 525 7523; where 7522 7524; le 1 5948; and 7497 7526; le 5948 7499;
and 7501 7528; or 7527 7529; not 7530; input p 163; mul 525 7532; where 7531 7533; mul 23 5829; mul 23 5816; mul 38
5819; add 7536 7537; mul 38 941; add 7538 7539; sub 7535 7540; mul 23 6194; mul 38 6197; add 7542 7543; mul 38 1818;
sub 7544 7545; mul 23 6206; add 7546 7547; mul 23 6418; mul 23 6406; mul 38 6409; add 7550 7551; mul 38 2628; add
7552 7553; sub 7549 7554; mul 23 6577; mul 23 6568; mul 38 6566; add 7557 7558; mul 38 3285; add 7559 7560; sub 7556
7561; mul 23 5819; mul 38 5816; sub 7563 7564; mul 23 941; add 7565 7566; mul 38 5829; add 7567 7568; mul 38 6194;
mul 23 6197; sub 7570 7571; mul 23 1818; add 7572 7573; mul 38 6206; add 7574 7575; mul 23 6409; mul 38 6406; sub
7577 7578; mul 23 2628; add 7579 7580; mul 38 6418; add 7581 7582; mul 23 6566; mul 38 6568; sub 7584 7585; mul 23
3285; add 7586 7587; mul 38 6577; add 7588 7589; neg 5829; neg 6206; neg 6418; neg 6577; mul 449 464; mul 921 7595;
mul 449 512; mul 904 7597; add 7596 7598; mul 449 496; mul 812 7600; add 7599 7601; mul 449 460; mul 937 7603; add
7602 7604; neg 7605; mul 1783 7597; mul 1798 7595; sub 7607 7608; mul 1632 7600; add 7609 7610; mul 1814 7603; sub
7611 7612; mul 2608 7595; mul 2592 7597; add 7614 7615; mul 2518 7600; add 7616 7617; mul 2624 7603; add 7618 7619;
neg 7620; mul 3275 7595; mul 3261 7597; add 7622 7623; mul 3281 7603; add 7624 7625; neg 7626; mul 470 923; mul 470
1800; neg 7629; mul 470 2610; neg 1777; mul 477 895; mul 477 1777; neg 7634; mul 477 2586; mul 493 876; mul 485
7637; neg 7638; mul 493 1756; mul 485 7640; mul 493 2577; mul 485 7642; neg 7643; input p 223; mul 475 880; mul 7645
7646; add 880 7647; input p 224; mul 7646 7649; mul 420 7650; add 7648 7651; neg 7652; mul 475 1772; mul 7645 7654;
add 1772 7655; mul 7649 7654; mul 420 7657; add 7656 7658; mul 475 2581; mul 7645 7660; add 2581 7661; mul 7649
7660; mul 420 7663; add 7662 7664; neg 7665; mul 519 812; mul 498 7667; mul 519 1632; mul 498 7669; neg 7670; mul
519 2518; mul 498 7672; mul 501 7667; mul 501 7669; neg 7675; mul 501 7672; mul 505 7667; mul 505 7669; neg 7679;
mul 505 7672; mul 519 866; mul 519 1761; neg 7683; mul 519 2567; mul 23 5802; mul 38 5798; add 7686 7687; mul 38
804; add 7688 7689; mul 23 5813; sub 7690 7691; mul 38 1713; mul 23 6179; mul 38 6182; add 7694 7695; sub 7693 7696;
mul 23 6191; sub 7697 7698; mul 23 6393; mul 38 6389; add 7700 7701; mul 38 2510; add 7702 7703; mul 23 6403; sub
7704 7705; mul 23 6610; mul 38 6612; add 7707 7708; mul 38 3573; add 7709 7710; mul 23 6621; sub 7711 7712; mul 23
5798; mul 38 5802; sub 7714 7715; mul 23 804; add 7716 7717; mul 38 5813; add 7718 7719; mul 38 6179; mul 23 6182;
sub 7721 7722; mul 23 1713; add 7723 7724; mul 38 6191; add 7725 7726; mul 23 6389; mul 38 6393; sub 7728 7729; mul
23 2510; add 7730 7731; mul 38 6403; add 7732 7733; mul 23 6612; mul 38 6610; sub 7735 7736; mul 23 3573; add 7737
7738; mul 38 6621; add 7739 7740; mul 586 601; mul 784 7742; mul 586 645; mul 767 7744; add 7743 7745; mul 586 630;
mul 711 7747; add 7746 7748; mul 586 597; mul 800 7750; add 7749 7751; neg 7752; mul 1667 7744; mul 1689 7742; sub
7754 7755; mul 1625 7747; add 7756 7757; mul 1705 7750; sub 7758 7759; mul 2490 7742; mul 2474 7744; add 7761 7762;
mul 2434 7747; add 7763 7764; mul 2506 7750; add 7765 7766; neg 7767; mul 3563 7742; mul 3549 7744; add 7769 7770;
mul 3569 7750; add 7771 7772; neg 7773; mul 607 786; mul 607 1691; neg 7776; mul 607 2492; neg 1661; mul 611 758;
mul 611 1661; neg 7781; mul 611 2468; mul 627 739; mul 619 7784; neg 7785; mul 627 1640; mul 619 7787; mul 627 2459;
mul 619 7789; neg 7790; input p 225; mul 609 743; mul 7792 7793; add 743 7794; input p 226; mul 7793 7796; mul 420
7797; add 7795 7798; neg 7799; mul 609 1656; mul 7792 7801; add 1656 7802; mul 7796 7801; mul 420 7804; add 7803
7805; mul 609 2463; mul 7792 7807; add 2463 7808; mul 7796 7807; mul 420 7810; add 7809 7811; neg 7812; mul 650 711;
mul 632 7814; mul 650 1625; mul 632 7816; neg 7817; mul 650 2434; mul 632 7819; mul 635 7814; mul 635 7816; neg
7822; mul 635 7819; mul 639 7814; mul 639 7816; neg 7826; mul 639 7819; mul 650 729; mul 650 1645; neg 7830; mul 650
2449; mul 699 5951; sub 7833 90; mul 5937 7834; mul 1609 5951; sub 699 7836; mul 5937 7837; mul 1618 5951; sub 7839
703; mul 5937 7840; mul 5940 7834; mul 5940 7837; mul 5940 7840; mul 5944 7834; mul 5944 7837; mul 5944 7840; mul
5948 7834; mul 5948 7837; mul 5948 7840; mul 7496 7505; mul 7505 7851; neg 7852; where 7504 7853; mul 7496 7514; mul
7514 7855; neg 7856; where 7513 7857; mul 7496 7523; mul 7523 7859; neg 7860; where 7522 7861; mul 7496 7532; mul
7532 7863; neg 7864; where 7531 7865; mul 90 6013; neg 7867; mul 699 6013; mul 703 6013; neg 7870; mul 90 6017; neg
7872; mul 699 6017; mul 703 6017; neg 7875; mul 91 1603; neg 7877; mul 91 2416; mul 91 3234; neg 7880; store by_k 96
1605; store by_k 288 2418; store by_k 480 3236; store by_k 576 3533; store by_k 672 3830; store by_k 768 3533; store
by_k 864 3830; store by_k 960 3533; store by_k 1056 3830; store by_k 97 3982; store by_k 289 3997; store by_k 481
4013; store by_k 98 4029; store by_k 290 4039; store by_k 482 4049; store by_k 99 4179; store by_k 291 4287; store
by_k 483 4395; store by_k 100 4561; store by_k 292 4689; store by_k 484 4817; store by_k 101 4945; store by_k 293
5049; store by_k 485 5153; store by_k 581 5257; store by_k 677 5361; store by_k 773 5257; store by_k 869 5361; store
by_k 965 5257; store by_k 1061 5361; store by_k 102 5438; store by_k 294 5512; store by_k 486 5586; store by_k 103
5595; store by_k 295 5604; store by_k 487 5613; store by_k 583 5616; store by_k 679 5619; store by_k 775 5616; store
by_k 871 5619; store by_k 967 5616; store by_k 1063 5619; store by_k 104 5628; store by_k 296 5637; store by_k 488
5646; store by_k 584 5649; store by_k 680 5652; store by_k 776 5649; store by_k 872 5652; store by_k 968 5649; store
by_k 1064 5652; store by_k 105 5661; store by_k 297 5667; store by_k 489 5676; store by_k 585 5679; store by_k 681
5682; store by_k 777 5679; store by_k 873 5682; store by_k 969 5679; store by_k 1065 5682; store by_k 106 5683;
store by_k 298 5684; store by_k 490 5685; store by_k 586 5686; store by_k 682 5687; store by_k 778 5686; store by_k
874 5687; store by_k 970 5686; store by_k 1066 5687; store by_k 107 5690; store by_k 299 5693; store by_k 491 5696;
store by_k 587 5699; store by_k 683 5702; store by_k 779 5699; store by_k 875 5702; store by_k 971 5699; store by_k
1067 5702; store by_k 108 5703; store by_k 300 5704; store by_k 492 5705; store by_k 588 5706; store by_k 684 5707;
store by_k 780 5706; store by_k 876 5707; store by_k 972 5706; store by_k 1068 5707; store by_k 109 5710; store by_k
301 5713; store by_k 493 5716; store by_k 589 5719; store by_k 685 5722; store by_k 781 5719; store by_k 877 5722;
store by_k 973 5719; store by_k 1069 5722; store by_k 110 5725; store by_k 302 5728; store by_k 494 5731; store by_k
590 5734; store by_k 686 5737; store by_k 782 5734; store by_k 878 5737; store by_k 974 5734; store by_k 1070 5737;
store by_k 111 5738; store by_k 303 5739; store by_k 495 5740; store by_k 591 5741; store by_k 687 5742; store by_k
783 5741; store by_k 879 5742; store by_k 975 5741; store by_k 1071 5742; store by_k 112 6138; store by_k 304 6351;
store by_k 496 6565; store by_k 592 6609; store by_k 688 6653; store by_k 784 6609; store by_k 880 6653; store by_k
976 6609; store by_k 1072 6653; store by_k 113 6658; store by_k 305 6662; store by_k 497 6667; store by_k 114 6673;
store by_k 306 6679; store by_k 498 6685; store by_k 115 6692; store by_k 307 6696; store by_k 499 6703; store by_k
116 6713; store by_k 308 6724; store by_k 500 6734; store by_k 117 6739; store by_k 309 6742; store by_k 501 6747;
store by_k 118 6759; store by_k 310 6767; store by_k 502 6779; store by_k 119 6793; store by_k 311 6809; store by_k
503 6823; store by_k 120 6828; store by_k 312 6831; store by_k 504 6836; store by_k 121 6846; store by_k 313 6853;
store by_k 505 6863; store by_k 122 6880; store by_k 314 6892; store by_k 506 6909; store by_k 123 6917; store by_k
315 6926; store by_k 507 6934; store by_k 124 6940; store by_k 316 6945; store by_k 508 6951; store by_k 125 6962;
store by_k 317 6971; store by_k 509 6982; store by_k 126 6998; store by_k 318 7012; store by_k 510 7028; store by_k
127 7037; store by_k 319 7045; store by_k 511 7054; store by_k 128 7093; store by_k 320 7130; store by_k 512 7164;
store by_k 129 7165; store by_k 321 7166; store by_k 513 7167; store by_k 130 6054; store by_k 322 6271; store by_k
514 6485; store by_k 131 7170; store by_k 323 7173; store by_k 515 7176; store by_k 132 7089; store by_k 324 7126;
store by_k 516 7160; store by_k 133 7195; store by_k 325 7212; store by_k 517 7230; store by_k 134 7238; store by_k
326 7246; store by_k 518 7254; store by_k 135 7257; store by_k 327 7260; store by_k 519 7263; store by_k 136 7283;
store by_k 328 7302; store by_k 520 7322; store by_k 137 7329; store by_k 329 7336; store by_k 521 7343; store by_k
138 7346; store by_k 330 7349; store by_k 522 7352; store by_k 139 7355; store by_k 331 7358; store by_k 523 7361;
store by_k 140 7370; store by_k 332 7379; store by_k 524 7388; store by_k 141 90; store by_k 333 7389; store by_k
525 703; store by_k 622 7390; store by_k 718 7391; store by_k 815 7392; store by_k 911 7393; store by_k 1008 7394;
store by_k 1104 7395; store by_k 145 7410; store by_k 337 7424; store by_k 529 7437; store by_k 625 7443; store by_k
721 7449; store by_k 817 7443; store by_k 913 7449; store by_k 1009 7443; store by_k 1105 7449; store by_k 146 7457;
store by_k 338 7459; store by_k 530 7462; store by_k 147 7464; store by_k 339 7465; store by_k 531 7467; store by_k
148 7470; store by_k 340 7472; store by_k 532 7475; store by_k 149 7482; store by_k 341 7486; store by_k 533 7489;
store by_k 150 7490; store by_k 342 7492; store by_k 534 7493; store by_k 1398 7507; store by_k 1494 7516; store
by_k 1590 7525; store by_k 1686 7534; store by_k 151 7541; store by_k 343 7548; store by_k 535 7555; store by_k 631
7562; store by_k 823 7562; store by_k 1015 7562; store by_k 152 7569; store by_k 344 7576; store by_k 536 7583;
store by_k 632 7590; store by_k 824 7590; store by_k 1016 7590; store by_k 153 7591; store by_k 345 7592; store by_k
537 7593; store by_k 633 7594; store by_k 825 7594; store by_k 1017 7594; store by_k 154 941; store by_k 346 1818;
store by_k 538 2628; store by_k 634 3285; store by_k 826 3285; store by_k 1018 3285; store by_k 155 7606; store by_k
347 7613; store by_k 539 7621; store by_k 635 7627; store by_k 827 7627; store by_k 1019 7627; store by_k 156 7628;
store by_k 348 7630; store by_k 540 7631; store by_k 157 895; store by_k 349 7632; store by_k 541 2586; store by_k
158 7633; store by_k 350 7635; store by_k 542 7636; store by_k 159 7639; store by_k 351 7641; store by_k 543 7644;
store by_k 160 7653; store by_k 352 7659; store by_k 544 7666; store by_k 161 7668; store by_k 353 7671; store by_k
545 7673; store by_k 162 7674; store by_k 354 7676; store by_k 546 7677; store by_k 163 7678; store by_k 355 7680;
store by_k 547 7681; store by_k 164 7682; store by_k 356 7684; store by_k 548 7685; store by_k 165 7692; store by_k
357 7699; store by_k 549 7706; store by_k 741 7713; store by_k 933 7713; store by_k 1125 7713; store by_k 166 7720;
store by_k 358 7727; store by_k 550 7734; store by_k 742 7741; store by_k 934 7741; store by_k 1126 7741; store by_k
167 5813; store by_k 359 6191; store by_k 551 6403; store by_k 743 6621; store by_k 935 6621; store by_k 1127 6621;
store by_k 168 804; store by_k 360 1713; store by_k 552 2510; store by_k 744 3573; store by_k 936 3573; store by_k
1128 3573; store by_k 169 7753; store by_k 361 7760; store by_k 553 7768; store by_k 745 7774; store by_k 937 7774;
store by_k 1129 7774; store by_k 170 7775; store by_k 362 7777; store by_k 554 7778; store by_k 171 758; store by_k
363 7779; store by_k 555 2468; store by_k 172 7780; store by_k 364 7782; store by_k 556 7783; store by_k 173 7786;
store by_k 365 7788; store by_k 557 7791; store by_k 174 7800; store by_k 366 7806; store by_k 558 7813; store by_k
175 7815; store by_k 367 7818; store by_k 559 7820; store by_k 176 7821; store by_k 368 7823; store by_k 560 7824;
store by_k 177 7825; store by_k 369 7827; store by_k 561 7828; store by_k 178 7829; store by_k 370 7831; store by_k
562 7832; store by_k 179 7835; store by_k 371 7838; store by_k 563 7841; store by_k 180 7842; store by_k 372 7843;
store by_k 564 7844; store by_k 181 7845; store by_k 373 7846; store by_k 565 7847; store by_k 182 7848; store by_k
374 7849; store by_k 566 7850; store by_k 1431 7854; store by_k 1528 7858; store by_k 1625 7862; store by_k 1722
7866; store by_k 187 7868; store by_k 379 7869; store by_k 571 7871; store by_k 188 7873; store by_k 380 7874; store
by_k 572 7876; store by_k 1245 6013; store by_k 1342 6017; store by_k 191 7878; store by_k 383 7879; store by_k 575
7881
    """,
)
