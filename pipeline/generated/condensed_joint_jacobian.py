"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 100},
    {'p': 232},
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
83; input k 84; input k 85; input k 86; constant -6.0; input k 49; input k 87; input k 88; input k 89; input k 90;
input k 55; input k 56; input k 57; mul 281 281; input k 95; input k 96; mul 3 168; mul 168 172; input k 32; mul 164
287; input k 33; mul 168 289; input k 34; mul 164 188; mul 168 189; input k 21; mul 175 294; input k 22; mul 164
296; input k 23; mul 168 298; input k 24; mul 6 192; input k 58; constant 0.8000000000000002; constant
2.400000000000001; mul 30 304; add 303 305; constant 0.01904761904761903; mul 35 307; add 306 308; constant
-1.3714285714285723; mul 42 310; constant 1.3714285714285714; mul 29 312; constant 0.007256235827664418; mul 34 314;
add 313 315; constant -4.799999999999999; mul 42 317; constant 1.3714285714285692; mul 29 319; constant
-0.05714285714285729; mul 34 321; add 320 322; constant -7.199999999999996; mul 42 324; constant 7.199999999999994;
mul 29 326; constant 0.2190476190476189; mul 34 328; add 327 329; constant -45.25714285714286; mul 29 331; constant
-0.11428571428571327; mul 34 333; add 332 334; constant -28.800000000000004; mul 42 336; mul 168 174; mul 168 291;
input k 35; mul 164 340; mul 168 190; mul 164 191; mul 164 300; input k 25; mul 175 345; constant 0.8; mul 21 347;
input k 50; input k 51; input k 52; input k 97; input k 98; input k 91; div 2 354; input k 92; div 2 356; input k
93; div 2 358; input k 94; div 2 360; mul 17 38; mul 37 362; mul 17 67; mul 118 362; mul 17 37; mul 13 16; add 283
284; mul 104 362; mul 17 113; mul 273 362; add 370 371; mul 21 372; mul 17 273; mul 175 362; add 374 375; mul 21
376; mul 38 377; add 373 378; mul 39 377; mul 40 377; mul 37 39; mul 39 118; mul 7 16; mul 39 104; mul 39 273; mul
21 386; mul 39 175; mul 21 388; mul 38 389; add 387 390; mul 39 389; mul 40 389; mul 302 355; mul 302 357; mul 302
359; mul 302 361; mul 37 40; mul 40 118; mul 11 16; mul 40 104; mul 40 175; mul 21 402; mul 39 403; mul 40 273; mul
21 405; mul 38 403; add 406 407; mul 40 403; add 348 409; neg 349; neg 350; neg 351; neg 352; neg 353; mul 275 302;
mul 276 302; mul 277 302; mul 278 302; mul 17 18; mul 27 168; mul 168 281; store p 0 0; store p 1 3; store p 2 4;
store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p
11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 22; store p 16 23; store p 17 17; store p 18 24;
store p 19 37; store p 20 38; store p 21 39; store p 22 40; store p 23 43; store p 24 48; store p 25 50; store p 26
55; store p 27 60; store p 28 67; store p 29 69; store p 30 74; store p 31 76; store p 32 81; store p 33 86; store p
34 91; store p 35 96; store p 36 102; store p 37 104; store p 38 106; store p 39 111; store p 40 118; store p 41
120; store p 42 125; store p 43 129; store p 44 134; store p 45 139; store p 46 141; store p 47 146; store p 48 151;
store p 49 153; store p 50 158; store p 51 163; store p 52 166; store p 53 169; store p 54 171; store p 55 172;
store p 56 173; store p 57 174; store p 58 177; store p 59 179; store p 60 181; store p 61 183; store p 62 185;
store p 63 187; store p 64 188; store p 65 189; store p 66 190; store p 67 191; store p 68 16; store p 69 201; store
p 70 203; store p 71 205; store p 72 207; store p 73 209; store p 74 211; store p 75 213; store p 76 215; store p 77
217; store p 78 219; store p 79 221; store p 80 223; store p 81 225; store p 82 227; store p 83 192; store p 84 198;
store p 85 229; store p 86 231; store p 87 233; store p 88 235; store p 89 196; store p 90 194; store p 91 237;
store p 92 195; store p 93 193; store p 94 238; store p 95 239; store p 96 240; store p 97 241; store p 98 245;
store p 99 246; store p 100 247; store p 101 248; store p 102 249; store p 103 252; store p 104 253; store p 105
259; store p 106 255; store p 107 256; store p 108 261; store p 109 257; store p 110 254; store p 111 262; store p
112 263; store p 113 264; store p 114 265; store p 115 268; store p 116 269; store p 117 270; store p 118 271; store
p 119 272; store p 120 21; store p 121 274; store p 122 275; store p 123 276; store p 124 277; store p 125 278;
store p 126 279; store p 127 280; store p 128 282; store p 129 283; store p 130 284; store p 131 285; store p 132
167; store p 133 286; store p 134 288; store p 135 290; store p 136 291; store p 137 178; store p 138 184; store p
139 292; store p 140 293; store p 141 295; store p 142 297; store p 143 299; store p 144 300; store p 145 301; store
p 146 302; store p 147 309; store p 148 311; store p 149 316; store p 150 318; store p 151 323; store p 152 325;
store p 153 330; store p 154 335; store p 155 337; store p 156 170; store p 157 338; store p 158 289; store p 159
339; store p 160 341; store p 161 180; store p 162 342; store p 163 343; store p 164 296; store p 165 344; store p
166 346; store p 167 165; store p 168 287; store p 169 340; store p 170 348; store p 171 349; store p 172 350; store
p 173 351; store p 174 352; store p 175 353; store p 176 355; store p 177 357; store p 178 359; store p 179 361;
store p 180 363; store p 181 362; store p 182 364; store p 183 365; store p 184 366; store p 185 367; store p 186
368; store p 187 369; store p 188 379; store p 189 380; store p 190 381; store p 191 382; store p 192 383; store p
193 384; store p 194 385; store p 195 391; store p 196 392; store p 197 393; store p 198 394; store p 199 395; store
p 200 396; store p 201 397; store p 202 398; store p 203 399; store p 204 400; store p 205 401; store p 206 404;
store p 207 408; store p 208 410; store p 209 411; store p 210 412; store p 211 413; store p 212 414; store p 213
415; store p 214 416; store p 215 417; store p 216 418; store p 217 419; store p 218 420; store p 219 28; store p
220 27; store p 221 99; store p 222 29; store p 223 421; store p 224 34; store p 225 250; store p 226 251; store p
227 422; store p 228 242; store p 229 244; store p 230 266; store p 231 267
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 232},
    {'f': 18, 'a': 324, 'b': 36, 'by_c': 234},
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
input p 121; input p 122; input z 0; mul 670 671; input p 123; input z 1; mul 673 674; add 672 675; input p 124;
input z 2; mul 677 678; add 676 679; input p 125; input z 3; mul 681 682; add 680 683; sub 669 684; input p 126; abs
0; mul 686 687; mul 0 688; input p 127; mul 0 690; mul 0 0; input p 128; add 692 693; sqrt 694; div 2 695; mul 691
696; add 689 697; sub 685 698; add 668 699; input p 129; input x 12; sub 29 702; mul 701 703; input p 130; input x
13; sub 29 706; mul 705 707; add 704 708; sub 700 709; mul 0 62; mul 28 130; add 711 712; mul 47 538; add 713 714;
mul 0 715; mul 0 28; mul 31 130; add 717 718; mul 34 538; add 719 720; mul 130 721; add 716 722; mul 0 47; mul 34
130; add 724 725; mul 51 538; add 726 727; mul 538 728; add 723 729; mul 17 130; mul 130 731; mul 23 732; input p
131; mul 9 734; mul 9 735; mul 8 16; mul 10 737; mul 737 738; add 736 739; mul 3 740; mul 38 741; sub 25 742; mul
733 743; add 730 744; mul 67 745; mul 24 741; add 39 747; mul 733 748; sub 746 749; mul 22 750; sub 710 751; mul 90
752; mul 81 89; mul 150 265; mul 145 755; abs 3; lt 757 279; input p 132; mul 276 759; input p 133; mul 283 761; add
760 762; mul 291 298; add 763 764; input p 134; mul 295 766; add 765 767; input p 135; mul 299 769; add 768 770;
input p 136; mul 303 772; add 771 773; mul 306 774; input p 137; mul 309 776; mul 312 319; add 777 778; input p 138;
mul 316 780; add 779 781; input p 139; mul 320 783; add 782 784; input p 140; mul 324 786; add 785 787; mul 328 339;
add 788 789; input p 141; mul 332 791; add 790 792; input p 142; mul 336 794; add 793 795; input p 143; mul 340 797;
add 796 798; input p 144; mul 306 800; add 799 801; add 775 802; mul 145 803; where 758 804; add 756 805; mul 531
640; sub 806 807; mul 150 659; add 808 809; mul 522 544; mul 629 637; add 811 812; add 810 813; sub 134 814; input p
145; mul 38 816; mul 17 817; add 815 818; input p 146; mul 684 820; sub 819 821; mul 41 745; mul 26 749; sub 823
824; mul 22 825; mul 19 741; mul 732 827; sub 826 828; sub 822 829; mul 754 830; sub 753 831; mul 86 89; input p
147; mul 35 834; input p 148; mul 214 836; add 835 837; input p 149; mul 218 839; add 838 840; mul 155 210; add 841
842; input p 150; mul 158 844; add 843 845; input p 151; mul 162 847; add 846 848; input p 152; mul 166 850; add 849
851; mul 170 227; add 852 853; input p 153; mul 174 855; add 854 856; mul 157 189; add 857 858; input p 154; mul 193
860; add 859 861; mul 169 197; add 862 863; input p 155; mul 201 865; add 864 866; mul 184 258; add 867 868; mul 202
257; add 869 870; mul 153 265; add 871 872; mul 145 873; abs 35; lt 875 287; input p 156; mul 276 877; mul 283 298;
add 878 879; input p 157; mul 291 881; add 880 882; input p 158; mul 295 884; add 883 885; input p 159; mul 299 887;
add 886 888; input p 160; mul 303 890; add 889 891; mul 306 892; input p 161; mul 309 894; mul 312 780; add 895 896;
mul 316 327; add 897 898; mul 320 335; add 899 900; input p 162; mul 324 902; add 901 903; input p 163; mul 328 905;
add 904 906; input p 164; mul 332 908; add 907 909; mul 336 797; add 910 911; input p 165; mul 340 913; add 912 914;
input p 166; mul 306 916; add 915 917; add 893 918; constant 3.0; mul 303 920; input p 167; mul 309 922; mul 312
759; add 923 924; mul 316 877; add 925 926; mul 294 320; add 927 928; mul 298 324; add 929 930; mul 302 328; add 931
932; input p 168; mul 332 934; add 933 935; mul 336 884; add 936 937; mul 340 772; add 938 939; input p 169; mul 306
941; add 940 942; mul 921 943; add 919 944; mul 145 945; where 876 946; add 874 947; mul 537 640; sub 948 949; input
p 170; mul 538 951; mul 153 659; add 952 953; add 950 954; mul 53 745; mul 22 956; add 955 957; mul 833 958; sub 832
959; mul 56 70; mul 79 79; sub 961 962; mul 89 963; mul 830 964; mul 752 754; sub 965 966; mul 59 70; mul 76 79; sub
968 969; mul 89 970; mul 958 971; add 967 972; mul 752 833; mul 830 971; sub 974 975; mul 45 70; mul 76 76; sub 977
978; mul 89 979; mul 958 980; sub 976 981; mul 510 542; input p 171; mul 489 984; sub 983 985; mul 617 635; mul 599
984; sub 987 988; input p 172; mul 492 990; sub 983 991; mul 602 990; sub 987 993; input p 173; mul 496 995; sub 983
996; mul 606 995; sub 987 998; input p 174; mul 703 1000; input p 175; mul 707 1002; le 2 671; mul 130 820; add 0
1005; lt 140 1006; and 1004 1007; constant -1.0; le 671 1009; lt 1006 140; and 1010 1011; or 1008 1012; not 1013;
input p 176; mul 1006 1015; where 1014 1016; le 2 674; and 1007 1018; le 674 1009; and 1011 1020; or 1019 1021; not
1022; input p 177; mul 1006 1024; where 1023 1025; le 2 678; and 1007 1027; le 678 1009; and 1011 1029; or 1028
1030; not 1031; input p 178; mul 1006 1033; where 1032 1034; le 2 682; and 1007 1036; le 682 1009; and 1011 1038; or
1037 1039; not 1040; input p 179; mul 1006 1042; where 1041 1043; mul 41 287; mul 28 1045; mul 22 1046; mul 56 1047;
mul 53 287; mul 47 1049; mul 22 1050; mul 45 1051; add 1048 1052; mul 28 53; mul 41 47; add 1054 1055; mul 22 1056;
mul 59 1057; add 1058 1058; sub 1053 1059; mul 89 1060; mul 89 90; mul 67 287; mul 62 1063; mul 22 1064; mul 61
1065; mul 70 1060; add 1066 1067; mul 41 62; mul 28 67; add 1069 1070; mul 22 1071; mul 81 1072; mul 56 1072; mul 76
1051; add 1074 1075; mul 79 1057; mul 47 67; mul 53 62; add 1078 1079; mul 22 1080; mul 59 1081; add 1077 1082; sub
1076 1083; mul 76 1084; add 1073 1085; sub 1068 1086; mul 86 1081; mul 59 1072; mul 76 1057; add 1089 1090; mul 79
1047; mul 45 1081; add 1092 1093; sub 1091 1094; mul 79 1095; add 1088 1096; add 1087 1097; mul 1062 1098; sub 1061
1099; mul 752 1100; mul 100 106; mul 102 1102; mul 100 114; sub 1103 1104; mul 100 118; mul 100 1106; sub 1105 1107;
input p 180; input p 181; mul 35 1110; mul 157 1111; add 1109 1112; mul 35 1111; mul 161 1114; add 1113 1115; mul
155 287; mul 1110 1117; mul 165 1118; add 1116 1119; mul 35 1118; mul 169 1121; add 1120 1122; mul 155 1118; mul 166
1110; add 1124 1125; mul 173 1126; add 1123 1127; input p 182; add 1128 1129; mul 35 144; mul 180 1131; add 1130
1132; mul 35 1131; mul 184 1134; add 1133 1135; mul 144 155; mul 148 1110; add 1137 1138; mul 188 1139; add 1136
1140; mul 35 1139; mul 192 1142; add 1141 1143; mul 155 1139; mul 189 1110; add 1145 1146; mul 196 1147; add 1144
1148; mul 148 287; mul 144 1150; mul 155 1151; mul 201 1110; add 1152 1153; mul 200 1154; add 1149 1155; mul 148
1151; mul 144 201; add 1157 1158; mul 205 1159; add 1156 1160; input p 183; mul 224 1111; add 1162 1163; mul 227
1114; add 1164 1165; mul 230 1118; add 1166 1167; mul 233 1121; add 1168 1169; mul 236 1126; add 1170 1171; input p
184; add 1172 1173; mul 157 1131; add 1174 1175; mul 161 1134; add 1176 1177; mul 245 1139; add 1178 1179; mul 248
1142; add 1180 1181; mul 251 1147; add 1182 1183; mul 254 1151; add 1184 1185; mul 35 1151; mul 257 1187; add 1186
1188; mul 196 1154; add 1189 1190; mul 263 1159; add 1191 1192; mul 147 1193; add 1161 1194; mul 145 1195; mul 275
287; le 274 270; le 270 274; add 1198 1199; div 2 1200; mul 1198 1201; le 273 148; le 148 273; add 1203 1204; div 2
1205; mul 1203 1206; mul 144 1207; mul 1202 1208; mul 1197 1209; mul 272 1210; mul 282 1209; mul 278 1212; add 1211
1213; mul 290 1209; mul 286 1215; add 1214 1216; mul 306 1217; mul 275 1210; mul 276 1209; add 1219 1220; mul 308
1221; mul 282 1210; mul 311 1223; add 1222 1224; mul 290 1210; mul 315 1226; add 1225 1227; mul 282 1212; mul 319
1229; add 1228 1230; mul 290 1212; mul 323 1232; add 1231 1233; mul 290 1215; mul 327 1235; add 1234 1236; add 1218
1237; mul 145 1238; where 271 1239; add 1196 1240; input p 185; mul 352 1114; mul 354 1126; add 1243 1244; mul 357
1134; add 1245 1246; mul 360 1142; add 1247 1248; mul 363 1147; add 1249 1250; mul 366 1154; add 1251 1252; mul 369
1159; add 1253 1254; mul 374 1114; mul 377 1121; add 1256 1257; mul 380 1126; add 1258 1259; mul 352 1134; add 1260
1261; mul 385 1147; add 1262 1263; mul 388 1187; add 1264 1265; mul 363 1154; add 1266 1267; mul 393 1159; add 1268
1269; mul 147 1270; add 1255 1271; mul 350 1272; add 1242 1273; mul 640 1274; mul 287 440; add 63 67; add 64 1277;
add 66 1278; mul 104 1279; mul 144 371; mul 148 1255; add 1281 1282; mul 395 1110; mul 155 1270; add 1284 1285; add
1283 1286; mul 414 1114; mul 374 1121; add 1288 1289; mul 419 1126; add 1290 1291; mul 422 1142; add 1292 1293; mul
357 1187; add 1294 1295; mul 388 1154; add 1296 1297; mul 35 1298; add 1287 1299; mul 408 1300; mul 350 1301; add
1280 1302; mul 1276 1303; mul 287 447; sub 1304 1305; mul 287 451; div 2 1307; mul 1306 1308; mul 441 1309; mul 287
1310; mul 287 454; mul 287 453; div 2 1313; mul 1310 1314; mul 455 1315; mul 1312 1316; neg 1317; mul 287 1318; mul
455 1319; mul 460 1317; sub 1320 1321; sub 1311 1322; mul 458 1323; mul 475 1324; le 468 464; le 464 468; add 1326
1327; div 2 1328; mul 1326 1329; le 465 467; le 467 465; add 1331 1332; div 2 1333; mul 1331 1334; mul 1310 1335;
mul 1330 1336; mul 471 1337; mul 469 1338; mul 473 1337; add 1339 1340; mul 463 1341; add 1325 1342; mul 480 1310;
mul 467 1344; mul 482 1310; add 1345 1346; mul 478 1347; sub 1343 1348; mul 441 1349; mul 505 1310; mul 467 1351;
mul 507 1310; add 1352 1353; mul 503 1354; mul 501 1315; mul 454 1356; mul 502 1315; add 1357 1358; mul 454 1359;
mul 454 502; mul 1315 1361; add 1360 1362; mul 441 1363; mul 509 1364; sub 1355 1365; mul 498 1366; add 1350 1367;
mul 513 1366; mul 510 1369; mul 514 1366; add 1370 1371; mul 542 1372; mul 441 1317; mul 447 1374; add 456 1375; mul
0 1376; mul 518 1303; add 516 1378; mul 456 1379; mul 520 1374; add 1380 1381; mul 17 1382; mul 130 1383; sub 1377
1384; mul 456 1303; mul 440 1374; sub 1386 1387; mul 540 1388; mul 527 1274; mul 150 1270; mul 350 1391; add 28
1392; mul 130 1393; add 1390 1394; mul 153 1270; add 1298 1396; mul 350 1397; add 47 1398; mul 538 1399; add 1395
1400; mul 457 1401; add 1389 1402; add 1385 1403; mul 515 1404; add 1373 1405; add 1368 1406; mul 457 1407; mul 544
1388; add 1408 1409; mul 287 553; mul 1303 1411; mul 287 560; sub 1412 1413; mul 287 564; div 2 1415; mul 1414 1416;
mul 554 1417; mul 287 1418; mul 287 567; mul 287 566; div 2 1421; mul 1418 1422; mul 568 1423; mul 1420 1424; neg
1425; mul 287 1426; mul 568 1427; mul 573 1425; sub 1428 1429; sub 1419 1430; mul 571 1431; mul 585 1432; le 578
464; le 464 578; add 1434 1435; div 2 1436; mul 1434 1437; le 465 577; le 577 465; add 1439 1440; div 2 1441; mul
1439 1442; mul 1418 1443; mul 1438 1444; mul 581 1445; mul 579 1446; mul 583 1445; add 1447 1448; mul 576 1449; add
1433 1450; mul 590 1418; mul 577 1452; mul 592 1418; add 1453 1454; mul 588 1455; sub 1451 1456; mul 554 1457; mul
505 1418; mul 577 1459; mul 614 1418; add 1460 1461; mul 612 1462; mul 610 1423; mul 567 1464; mul 611 1423; add
1465 1466; mul 567 1467; mul 567 611; mul 1423 1469; add 1468 1470; mul 554 1471; mul 616 1472; sub 1463 1473; mul
608 1474; add 1458 1475; mul 620 1474; mul 617 1477; mul 621 1474; add 1478 1479; mul 635 1480; mul 625 1303; sub
1482 623; mul 569 1483; mul 554 1425; mul 627 1485; sub 1484 1486; mul 17 1487; mul 130 1488; mul 560 1485; add 569
1490; mul 0 1491; add 1489 1492; mul 569 1303; mul 553 1485; sub 1494 1495; mul 540 1496; mul 570 1401; add 1497
1498; add 1493 1499; mul 622 1500; add 1481 1501; add 1476 1502; mul 570 1503; mul 637 1496; add 1504 1505; add 1410
1506; mul 399 1507; sub 1275 1508; sub 1241 1509; mul 144 1510; mul 524 1407; mul 544 1376; sub 1512 1513; mul 631
1503; mul 637 1491; sub 1515 1516; add 1514 1517; sub 1511 1518; sub 1108 1519; input p 186; sub 1520 1521; mul 62
745; mul 22 1523; sub 1522 1524; mul 90 1525; add 1101 1526; mul 89 1084; mul 89 754; mul 1098 1529; sub 1528 1530;
mul 830 1531; mul 150 1193; mul 145 1533; mul 759 1210; mul 761 1212; add 1535 1536; mul 298 1215; add 1537 1538;
mul 306 1539; mul 776 1221; mul 319 1223; add 1541 1542; mul 780 1226; add 1543 1544; mul 783 1229; add 1545 1546;
mul 786 1232; add 1547 1548; mul 339 1235; add 1549 1550; add 1540 1551; mul 145 1552; where 758 1553; add 1534
1554; mul 640 1393; mul 531 1507; sub 1556 1557; sub 1555 1558; mul 522 1407; mul 544 1383; sub 1560 1561; mul 629
1503; mul 637 1488; add 1563 1564; add 1562 1565; add 1559 1566; sub 1106 1567; mul 28 745; mul 22 1569; sub 1568
1570; mul 754 1571; add 1532 1572; sub 1527 1573; mul 89 1095; mul 89 833; mul 1098 1576; sub 1575 1577; mul 958
1578; input p 187; mul 844 1111; add 1580 1581; mul 847 1114; add 1582 1583; mul 850 1118; add 1584 1585; mul 227
1121; add 1586 1587; mul 855 1126; add 1588 1589; mul 157 1139; add 1590 1591; mul 860 1142; add 1592 1593; mul 169
1147; add 1594 1595; mul 865 1151; add 1596 1597; mul 184 1187; add 1598 1599; mul 257 1154; add 1600 1601; mul 153
1193; add 1602 1603; mul 145 1604; mul 877 1210; mul 298 1212; add 1606 1607; mul 881 1215; add 1608 1609; mul 306
1610; mul 894 1221; mul 780 1223; add 1612 1613; mul 327 1226; add 1614 1615; mul 335 1229; add 1616 1617; mul 902
1232; add 1618 1619; mul 905 1235; add 1620 1621; add 1611 1622; mul 922 1221; mul 759 1223; add 1624 1625; mul 877
1226; add 1626 1627; mul 294 1229; add 1628 1629; mul 298 1232; add 1630 1631; mul 302 1235; add 1632 1633; mul 921
1634; add 1623 1635; mul 145 1636; where 876 1637; add 1605 1638; mul 640 1399; mul 537 1507; sub 1640 1641; sub
1639 1642; mul 47 745; mul 22 1644; add 1643 1645; mul 833 1646; add 1579 1647; sub 1574 1648; input c_q 0; mul 90
1650; le 140 139; le 139 140; add 1652 1653; div 2 1654; mul 1652 1655; mul 0 90; mul 1656 1657; input c_q 1; mul
1658 1659; sub 1651 1660; mul 90 93; input c_q 2; mul 1662 1663; add 1661 1664; mul 90 97; input c_q 3; mul 1666
1667; add 1665 1668; mul 90 100; add 754 1670; input c_q 4; mul 1671 1672; sub 1669 1673; mul 102 1671; input c_q 5;
mul 1675 1676; add 1674 1677; mul 93 1671; input c_q 6; mul 1679 1680; sub 1678 1681; mul 97 1671; input c_q 7; mul
1683 1684; sub 1682 1685; le 128 127; le 127 128; add 1687 1688; div 2 1689; mul 1687 1690; mul 132 1671; mul 1691
1692; input c_q 8; mul 1693 1694; add 1686 1695; mul 90 102; input c_q 9; mul 1697 1698; add 1696 1699; mul 102
1697; mul 104 1701; input c_q 10; mul 1702 1703; sub 1700 1704; mul 93 1697; input c_q 11; mul 1706 1707; add 1705
1708; mul 97 1697; input c_q 12; mul 1710 1711; add 1709 1712; add 1649 1713; mul 56 1065; mul 70 1051; add 1715
1716; mul 79 1081; add 1718 1718; sub 1717 1719; mul 89 1720; mul 89 964; mul 1098 1722; sub 1721 1723; mul 830
1724; mul 964 1571; add 1725 1726; mul 752 1531; mul 754 1525; add 1728 1729; sub 1727 1730; mul 59 1065; mul 70
1057; add 1732 1733; mul 76 1081; mul 79 1072; add 1735 1736; sub 1734 1737; mul 89 1738; mul 89 971; mul 1098 1740;
sub 1739 1741; mul 958 1742; mul 971 1646; add 1743 1744; add 1731 1745; mul 0 754; mul 1656 1747; mul 1659 1748;
mul 754 1650; sub 1749 1750; mul 93 754; mul 1663 1752; sub 1751 1753; mul 97 754; mul 1667 1755; sub 1754 1756; mul
100 754; add 964 1758; mul 1672 1759; add 1757 1760; mul 102 1759; mul 1676 1762; sub 1761 1763; mul 93 1759; mul
1680 1765; add 1764 1766; mul 97 1759; mul 1684 1768; add 1767 1769; mul 132 1759; mul 1691 1771; mul 1694 1772; sub
1770 1773; mul 102 754; mul 1698 1775; sub 1774 1776; mul 102 1775; mul 104 1778; mul 1703 1779; add 1777 1780; mul
93 1775; mul 1707 1782; sub 1781 1783; mul 97 1775; mul 1711 1785; sub 1784 1786; add 1746 1787; mul 752 1578; mul
833 1525; add 1789 1790; mul 830 1742; mul 971 1571; add 1792 1793; sub 1791 1794; mul 45 1065; mul 70 1047; add
1796 1797; mul 76 1072; add 1799 1799; sub 1798 1800; mul 89 1801; mul 89 980; mul 1098 1803; sub 1802 1804; mul 958
1805; mul 980 1646; add 1806 1807; sub 1795 1808; mul 833 1650; mul 0 833; mul 1656 1811; mul 1659 1812; sub 1810
1813; mul 93 833; mul 1663 1815; add 1814 1816; mul 97 833; mul 1667 1818; add 1817 1819; mul 100 833; add 971 1821;
mul 1672 1822; sub 1820 1823; mul 102 1822; mul 1676 1825; add 1824 1826; mul 93 1822; mul 1680 1828; sub 1827 1829;
mul 97 1822; mul 1684 1831; sub 1830 1832; mul 132 1822; mul 1691 1834; mul 1694 1835; add 1833 1836; mul 102 833;
mul 1698 1838; add 1837 1839; mul 102 1838; mul 104 1841; mul 1703 1842; sub 1840 1843; mul 93 1838; mul 1707 1845;
add 1844 1846; mul 97 1838; mul 1711 1848; add 1847 1849; add 1809 1850; mul 542 1366; mul 510 1404; add 1852 1853;
mul 635 1474; mul 617 1500; add 1855 1856; mul 100 129; mul 100 1858; add 141 1859; mul 144 399; mul 457 1861; sub
1862 524; mul 515 1863; mul 457 1864; mul 570 1861; sub 1866 631; mul 622 1867; mul 570 1868; add 1865 1869; mul 399
1870; input p 188; add 1871 1872; mul 144 1873; mul 524 1864; mul 631 1868; add 1875 1876; sub 1874 1877; add 1860
1878; sign 0; mul 686 1880; mul 0 1881; add 688 1882; mul 690 696; mul 696 697; mul 0 696; mul 1885 1886; sub 1884
1887; add 1883 1888; add 1879 1889; add 711 715; add 712 1891; add 714 1892; mul 67 1893; mul 22 1894; add 1890
1895; mul 90 1896; mul 531 1870; input p 189; add 1898 1899; mul 522 1864; mul 629 1868; add 1901 1902; add 1900
1903; sub 1858 1904; mul 41 1893; mul 22 1906; sub 1905 1907; mul 754 1908; add 1897 1909; mul 537 1870; input p
190; add 1911 1912; mul 53 1893; mul 22 1914; add 1913 1915; mul 833 1916; add 1910 1917; neg 1918; mul 964 1908;
mul 754 1896; add 1920 1921; mul 971 1916; add 1922 1923; mul 833 1896; mul 971 1908; add 1925 1926; mul 980 1916;
add 1927 1928; neg 1929; mul 510 1863; mul 617 1867; where 1014 1015; where 1023 1024; where 1032 1033; where 1041
1042; mul 26 287; div 2 14; mul 11 1938; mul 9 1939; mul 9 24; mul 5 9; mul 1941 1942; sub 1940 1943; mul 17 1944;
mul 9 9; mul 1942 1946; mul 16 1947; mul 16 17; mul 14 1942; mul 8 1939; add 1950 1951; mul 1949 1952; add 1948
1953; mul 24 1954; sub 1945 1955; mul 23 1956; mul 1937 1957; mul 9 38; mul 1942 1959; sub 9 1960; mul 17 1961; mul
38 1954; sub 1962 1963; mul 23 1964; add 31 1965; mul 1045 1966; add 1958 1967; mul 22 1968; mul 18 1954; mul 17
1970; mul 19 1954; add 1971 1972; sub 1969 1973; mul 56 1974; mul 34 1049; mul 22 1976; mul 45 1977; add 1975 1978;
mul 53 1966; mul 34 41; add 1980 1981; mul 22 1982; mul 59 1983; add 1984 1984; sub 1979 1985; mul 89 1986; mul 28
1063; mul 22 1988; mul 61 1989; mul 70 1986; add 1990 1991; mul 28 41; mul 67 1966; add 1993 1994; add 1957 1995;
mul 22 1996; mul 81 1997; mul 56 1997; mul 76 1977; add 1999 2000; mul 79 1983; mul 34 67; add 1054 2003; mul 22
2004; mul 59 2005; add 2002 2006; sub 2001 2007; mul 76 2008; add 1998 2009; sub 1992 2010; mul 86 2005; mul 59
1997; mul 76 1983; add 2013 2014; mul 79 1974; mul 45 2005; add 2016 2017; sub 2015 2018; mul 79 2019; add 2012
2020; add 2011 2021; mul 1062 2022; sub 1987 2023; mul 752 2024; sub 114 107; add 1106 2026; input p 191; mul 35
150; mul 157 2029; add 2028 2030; mul 35 2029; mul 161 2032; add 2031 2033; mul 150 1117; mul 165 2035; add 2034
2036; mul 35 2035; mul 169 2038; add 2037 2039; mul 155 2035; mul 150 166; add 2041 2042; mul 173 2043; add 2040
2044; mul 148 150; mul 188 2046; add 2045 2047; mul 35 2046; mul 192 2049; add 2048 2050; mul 155 2046; mul 150 189;
add 2052 2053; mul 196 2054; add 2051 2055; mul 150 201; mul 200 2057; add 2056 2058; input p 192; mul 224 2029; add
2060 2061; mul 227 2032; add 2062 2063; mul 230 2035; add 2064 2065; mul 233 2038; add 2066 2067; mul 236 2043; add
2068 2069; mul 245 2046; add 2070 2071; mul 248 2049; add 2072 2073; mul 251 2054; add 2074 2075; mul 196 2057; add
2076 2077; mul 147 2078; add 2059 2079; mul 145 2080; le 281 279; le 279 281; add 2082 2083; div 2 2084; mul 2082
2085; le 280 3; le 3 280; add 2087 2088; div 2 2089; mul 2087 2090; mul 2086 2091; mul 275 2092; mul 278 2093; mul
282 287; mul 2092 2095; mul 294 2096; add 2094 2097; mul 290 2092; mul 298 2099; add 2098 2100; mul 306 2101; mul
276 2092; mul 311 2103; mul 282 2093; mul 283 2092; add 2105 2106; mul 319 2107; add 2104 2108; mul 290 2093; mul
323 2110; add 2109 2111; mul 282 2096; mul 295 2092; add 2113 2114; mul 331 2115; add 2112 2116; mul 290 2096; mul
335 2118; add 2117 2119; mul 290 2099; mul 339 2121; add 2120 2122; add 2102 2123; mul 145 2124; where 271 2125; add
2081 2126; input p 193; mul 352 2032; mul 354 2043; add 2129 2130; mul 360 2049; add 2131 2132; mul 363 2054; add
2133 2134; mul 366 2057; add 2135 2136; mul 374 2032; mul 377 2038; add 2138 2139; mul 380 2043; add 2140 2141; mul
385 2054; add 2142 2143; mul 363 2057; add 2144 2145; mul 147 2146; add 2137 2147; mul 350 2148; add 2128 2149; mul
640 2150; mul 438 1944; mul 435 1961; add 2152 2153; mul 1305 2154; add 32 37; add 30 2156; add 36 2157; mul 104
2158; mul 148 2137; mul 155 2146; add 529 2161; add 2160 2162; mul 414 2032; mul 374 2038; add 2164 2165; mul 419
2043; add 2166 2167; mul 422 2049; add 2168 2169; mul 388 2057; add 2170 2171; mul 35 2172; add 2163 2173; mul 408
2174; mul 350 2175; add 2159 2176; mul 435 1944; add 2177 2178; mul 438 1961; sub 2179 2180; mul 1276 2181; add 2155
2182; mul 1308 2183; mul 441 2184; mul 287 2185; mul 1314 2185; mul 455 2187; mul 1312 2188; neg 2189; mul 287 2190;
mul 455 2191; mul 460 2189; sub 2192 2193; sub 2186 2194; mul 458 2195; mul 475 2196; mul 1335 2185; mul 1330 2198;
mul 471 2199; mul 469 2200; mul 473 2199; add 2201 2202; mul 463 2203; add 2197 2204; mul 480 2185; mul 467 2206;
mul 482 2185; add 2207 2208; mul 478 2209; sub 2205 2210; mul 441 2211; mul 505 2185; mul 467 2213; mul 507 2185;
add 2214 2215; mul 503 2216; mul 501 2187; mul 454 2218; mul 502 2187; add 2219 2220; mul 454 2221; mul 1361 2187;
add 2222 2223; mul 441 2224; mul 509 2225; sub 2217 2226; mul 498 2227; add 2212 2228; mul 513 2227; mul 510 2230;
mul 514 2227; add 2231 2232; mul 542 2233; mul 516 2154; sub 2178 2180; mul 447 2236; add 2235 2237; mul 518 2181;
mul 440 2154; add 2239 2240; sub 2238 2241; mul 456 2242; mul 441 2189; mul 520 2244; sub 2243 2245; mul 17 2246;
mul 521 1954; sub 2247 2248; mul 130 2249; mul 456 2154; mul 447 2244; sub 2251 2252; mul 0 2253; sub 2250 2254; mul
456 2181; mul 440 2244; sub 2256 2257; mul 540 2258; mul 527 2150; mul 150 2146; mul 350 2261; add 31 2262; mul 130
2263; add 2260 2264; mul 153 2146; add 2172 2266; mul 350 2267; add 34 2268; mul 538 2269; add 2265 2270; mul 457
2271; add 2259 2272; add 2255 2273; mul 515 2274; add 2234 2275; add 2229 2276; mul 457 2277; mul 544 2258; add 2278
2279; mul 548 1961; mul 551 1944; sub 2281 2282; mul 1413 2283; mul 548 1944; add 2177 2285; mul 551 1961; add 2286
2287; mul 1411 2288; add 2284 2289; mul 1416 2290; mul 554 2291; mul 287 2292; mul 1422 2292; mul 568 2294; mul 1420
2295; neg 2296; mul 287 2297; mul 568 2298; mul 573 2296; sub 2299 2300; sub 2293 2301; mul 571 2302; mul 585 2303;
mul 1443 2292; mul 1438 2305; mul 581 2306; mul 579 2307; mul 583 2306; add 2308 2309; mul 576 2310; add 2304 2311;
mul 590 2292; mul 577 2313; mul 592 2292; add 2314 2315; mul 588 2316; sub 2312 2317; mul 554 2318; mul 505 2292;
mul 577 2320; mul 614 2292; add 2321 2322; mul 612 2323; mul 610 2294; mul 567 2325; mul 611 2294; add 2326 2327;
mul 567 2328; mul 1469 2294; add 2329 2330; mul 554 2331; mul 616 2332; sub 2324 2333; mul 608 2334; add 2319 2335;
mul 620 2334; mul 617 2337; mul 621 2334; add 2338 2339; mul 635 2340; mul 623 2283; add 2285 2287; mul 560 2343;
add 2342 2344; mul 625 2288; sub 2282 2281; mul 553 2347; add 2346 2348; add 2345 2349; mul 569 2350; mul 554 2296;
mul 627 2352; sub 2351 2353; mul 17 2354; mul 628 1954; sub 2355 2356; mul 130 2357; mul 569 2283; mul 560 2352; sub
2359 2360; mul 0 2361; sub 2358 2362; mul 569 2288; mul 553 2352; sub 2364 2365; mul 540 2366; mul 570 2271; add
2367 2368; add 2363 2369; mul 622 2370; add 2341 2371; add 2336 2372; mul 570 2373; mul 637 2366; add 2374 2375; add
2280 2376; mul 399 2377; sub 2151 2378; sub 2127 2379; mul 144 2380; mul 524 2277; mul 544 2253; add 2382 2383; mul
631 2373; mul 637 2361; add 2385 2386; add 2384 2387; sub 2381 2388; sub 2027 2389; mul 741 1961; mul 16 1942; mul
16 737; mul 1952 2393; sub 2392 2394; mul 10 2395; mul 737 2396; mul 738 2395; add 2397 2398; mul 736 1942; mul 9
2400; mul 9 736; mul 1942 2402; add 2401 2403; sub 2399 2404; mul 3 2405; add 740 2406; mul 38 2407; add 2391 2408;
sub 1956 2409; mul 733 2410; mul 130 1954; mul 130 2412; mul 23 2413; mul 743 2414; sub 2411 2415; mul 67 2416; add
1569 2417; mul 741 1944; mul 24 2407; add 2419 2420; add 1964 2421; mul 733 2422; mul 748 2414; sub 2423 2424; sub
2418 2425; mul 22 2426; sub 2390 2427; mul 90 2428; add 2025 2429; mul 89 2008; mul 1529 2022; sub 2431 2432; mul
830 2433; mul 816 1961; mul 17 2435; mul 817 1954; sub 2436 2437; mul 150 2078; mul 145 2439; mul 761 2093; mul 766
2096; add 2441 2442; mul 769 2099; add 2443 2444; mul 306 2445; mul 319 2103; mul 783 2107; add 2447 2448; mul 786
2110; add 2449 2450; mul 791 2115; add 2451 2452; mul 794 2118; add 2453 2454; mul 797 2121; add 2455 2456; add 2446
2457; mul 145 2458; where 758 2459; add 2440 2460; mul 640 2263; mul 531 2377; sub 2462 2463; sub 2461 2464; mul 522
2277; mul 544 2249; add 2466 2467; mul 629 2373; mul 637 2357; add 2469 2470; add 2468 2471; add 2465 2472; add 118
2473; sub 2438 2474; mul 745 1966; mul 41 2416; add 2476 2477; mul 749 1957; mul 26 2425; add 2479 2480; sub 2478
2481; mul 22 2482; mul 19 2407; mul 741 1970; sub 2484 2485; mul 732 2486; mul 827 2413; sub 2487 2488; sub 2483
2489; sub 2475 2490; mul 754 2491; add 2434 2492; sub 2430 2493; mul 89 2019; mul 1576 2022; sub 2495 2496; mul 958
2497; input p 194; mul 844 2029; add 2499 2500; mul 847 2032; add 2501 2502; mul 850 2035; add 2503 2504; mul 227
2038; add 2505 2506; mul 855 2043; add 2507 2508; mul 157 2046; add 2509 2510; mul 860 2049; add 2511 2512; mul 169
2054; add 2513 2514; mul 257 2057; add 2515 2516; mul 153 2078; add 2517 2518; mul 145 2519; mul 298 2093; mul 884
2096; add 2521 2522; mul 887 2099; add 2523 2524; mul 306 2525; mul 780 2103; mul 335 2107; add 2527 2528; mul 902
2110; add 2529 2530; mul 908 2115; add 2531 2532; mul 797 2118; add 2533 2534; mul 913 2121; add 2535 2536; add 2526
2537; mul 759 2103; mul 294 2107; add 2539 2540; mul 298 2110; add 2541 2542; mul 934 2115; add 2543 2544; mul 884
2118; add 2545 2546; mul 772 2121; add 2547 2548; mul 921 2549; add 2538 2550; mul 145 2551; where 876 2552; add
2520 2553; mul 640 2269; mul 537 2377; sub 2555 2556; sub 2554 2557; mul 34 745; mul 53 2416; add 2559 2560; mul 22
2561; add 2558 2562; mul 833 2563; add 2498 2564; sub 2494 2565; mul 56 1989; mul 70 1977; add 2567 2568; mul 79
2005; add 2570 2570; sub 2569 2571; mul 89 2572; mul 1722 2022; sub 2573 2574; mul 830 2575; mul 964 2491; add 2576
2577; mul 752 2433; mul 754 2428; add 2579 2580; sub 2578 2581; mul 59 1989; mul 70 1983; add 2583 2584; mul 76
2005; mul 79 1997; add 2586 2587; sub 2585 2588; mul 89 2589; mul 1740 2022; sub 2590 2591; mul 958 2592; mul 971
2563; add 2593 2594; add 2582 2595; mul 752 2497; mul 833 2428; add 2597 2598; mul 830 2592; mul 971 2491; add 2600
2601; sub 2599 2602; mul 45 1989; mul 70 1974; add 2604 2605; mul 76 1997; add 2607 2607; sub 2606 2608; mul 89
2609; mul 1803 2022; sub 2610 2611; mul 958 2612; mul 980 2563; add 2613 2614; sub 2603 2615; mul 542 2227; mul 510
2274; add 2617 2618; mul 635 2334; mul 617 2370; add 2620 2621; mul 457 531; add 522 2623; mul 515 2624; mul 457
2625; mul 531 570; add 629 2627; mul 622 2628; mul 570 2629; add 2626 2630; mul 399 2631; input p 195; add 2632
2633; mul 144 2634; mul 524 2625; mul 631 2629; add 2636 2637; sub 2635 2638; sub 1858 2639; add 718 721; add 717
2641; add 720 2642; mul 287 731; mul 23 2644; mul 743 2645; add 2643 2646; mul 67 2647; mul 748 2645; sub 2648 2649;
mul 22 2650; sub 2640 2651; mul 90 2652; mul 531 2631; input p 196; add 2654 2655; mul 522 2625; mul 629 2629; add
2657 2658; add 2656 2659; add 129 2660; mul 41 2647; mul 26 2649; sub 2662 2663; mul 22 2664; mul 827 2644; sub 2665
2666; add 2661 2667; mul 754 2668; add 2653 2669; mul 537 2631; input p 197; add 2671 2672; mul 53 2647; mul 22
2674; add 2673 2675; mul 833 2676; sub 2670 2677; mul 971 2676; mul 964 2668; mul 754 2652; add 2680 2681; sub 2679
2682; mul 833 2652; mul 971 2668; add 2684 2685; mul 980 2676; sub 2686 2687; mul 510 2624; mul 617 2628; input p
198; where 1014 2691; input p 199; where 1023 2693; input p 200; where 1032 2695; input p 201; where 1041 2697; mul
34 1045; mul 22 2699; mul 56 2700; mul 51 1049; mul 22 2702; mul 45 2703; add 2701 2704; mul 34 53; mul 41 51; add
2706 2707; mul 22 2708; mul 59 2709; add 2710 2710; sub 2705 2711; mul 89 2712; mul 47 1063; mul 22 2714; mul 61
2715; mul 70 2712; add 2716 2717; add 1055 2003; mul 22 2719; mul 81 2720; mul 56 2720; mul 76 2703; add 2722 2723;
mul 79 2709; mul 51 67; mul 47 53; add 2726 2727; mul 22 2728; mul 59 2729; add 2725 2730; sub 2724 2731; mul 76
2732; add 2721 2733; sub 2718 2734; mul 86 2729; mul 59 2720; mul 76 2709; add 2737 2738; mul 79 2700; mul 45 2729;
add 2740 2741; sub 2739 2742; mul 79 2743; add 2736 2744; add 2735 2745; mul 1062 2746; sub 2713 2747; mul 752 2748;
input p 202; add 154 155; mul 157 2751; add 2750 2752; mul 35 2751; add 158 2754; mul 161 2755; add 2753 2756; mul
153 1117; mul 165 2758; add 2757 2759; mul 35 2758; add 166 2761; mul 169 2762; add 2760 2763; mul 155 2758; mul 153
166; add 2765 2766; mul 173 2767; add 2764 2768; mul 148 180; add 2769 2770; mul 181 287; mul 184 2772; add 2771
2773; mul 148 153; mul 188 2775; add 2774 2776; mul 35 2775; add 189 2778; mul 192 2779; add 2777 2780; mul 155
2775; mul 153 189; add 2782 2783; mul 196 2784; add 2781 2785; mul 153 201; mul 200 2787; add 2786 2788; mul 35 287;
mul 213 2790; add 210 2791; mul 35 2790; add 214 2793; mul 217 2794; add 2792 2795; input p 203; add 2796 2797; mul
224 2751; add 2798 2799; mul 227 2755; add 2800 2801; mul 230 2758; add 2802 2803; mul 233 2762; add 2804 2805; mul
236 2767; add 2806 2807; mul 148 157; add 2808 2809; mul 161 2772; add 2810 2811; mul 245 2775; add 2812 2813; mul
248 2779; add 2814 2815; mul 251 2784; add 2816 2817; mul 201 257; add 2818 2819; mul 196 2787; add 2820 2821; mul
147 2822; add 2789 2823; mul 145 2824; le 289 287; le 287 289; add 2826 2827; div 2 2828; mul 2826 2829; le 288 35;
le 35 288; add 2831 2832; div 2 2833; mul 2831 2834; mul 2830 2835; mul 275 2836; mul 286 2837; mul 282 2836; mul
298 2839; add 2838 2840; mul 287 290; mul 2836 2842; mul 302 2843; add 2841 2844; mul 306 2845; mul 290 2843; mul
303 2836; add 2847 2848; mul 305 2849; add 2846 2850; mul 276 2836; mul 315 2852; mul 283 2836; mul 323 2854; add
2853 2855; mul 290 2837; mul 291 2836; add 2857 2858; mul 327 2859; add 2856 2860; mul 295 2836; mul 335 2862; add
2861 2863; mul 290 2839; mul 299 2836; add 2865 2866; mul 339 2867; add 2864 2868; mul 343 2849; add 2869 2870; add
2851 2871; mul 145 2872; where 271 2873; add 2825 2874; input p 204; mul 352 2755; mul 354 2767; add 2877 2878; mul
357 2772; add 2879 2880; mul 360 2779; add 2881 2882; mul 363 2784; add 2883 2884; mul 366 2787; add 2885 2886; mul
372 2794; mul 374 2755; add 2888 2889; mul 377 2762; add 2890 2891; mul 380 2767; add 2892 2893; mul 352 2772; add
2894 2895; mul 385 2784; add 2896 2897; mul 201 388; add 2898 2899; mul 363 2787; add 2900 2901; mul 147 2902; add
2887 2903; mul 350 2904; add 2876 2905; mul 640 2906; add 52 53; add 50 2908; mul 104 2909; mul 148 2887; mul 155
2902; add 534 2912; add 2911 2913; mul 412 2794; mul 414 2755; add 2915 2916; mul 374 2762; add 2917 2918; mul 419
2767; add 2919 2920; mul 422 2779; add 2921 2922; mul 201 357; add 2923 2924; mul 388 2787; add 2925 2926; mul 35
2927; add 428 2928; add 2914 2929; mul 408 2930; mul 350 2931; add 2910 2932; mul 1276 2933; mul 1308 2934; mul 441
2935; mul 287 2936; mul 1314 2936; mul 455 2938; mul 1312 2939; neg 2940; mul 287 2941; mul 455 2942; mul 460 2940;
sub 2943 2944; sub 2937 2945; mul 458 2946; mul 475 2947; mul 1335 2936; mul 1330 2949; mul 471 2950; mul 469 2951;
mul 473 2950; add 2952 2953; mul 463 2954; add 2948 2955; mul 480 2936; mul 467 2957; mul 482 2936; add 2958 2959;
mul 478 2960; sub 2956 2961; mul 441 2962; mul 505 2936; mul 467 2964; mul 507 2936; add 2965 2966; mul 503 2967;
mul 501 2938; mul 454 2969; mul 502 2938; add 2970 2971; mul 454 2972; mul 1361 2938; add 2973 2974; mul 441 2975;
mul 509 2976; sub 2968 2977; mul 498 2978; add 2963 2979; mul 513 2978; mul 510 2981; mul 514 2978; add 2982 2983;
mul 542 2984; mul 441 2940; mul 447 2986; mul 0 2987; mul 518 2933; mul 456 2989; mul 520 2986; add 2990 2991; mul
17 2992; mul 130 2993; sub 2988 2994; mul 456 2933; mul 440 2986; sub 2996 2997; mul 540 2998; mul 527 2906; mul 150
2902; mul 350 3001; add 34 3002; mul 130 3003; add 3000 3004; mul 153 2902; add 2927 3006; mul 350 3007; add 51
3008; mul 538 3009; add 3005 3010; mul 457 3011; add 2999 3012; add 2995 3013; mul 515 3014; add 2985 3015; add 2980
3016; mul 457 3017; mul 544 2998; add 3018 3019; mul 1411 2933; mul 1416 3021; mul 554 3022; mul 287 3023; mul 1422
3023; mul 568 3025; mul 1420 3026; neg 3027; mul 287 3028; mul 568 3029; mul 573 3027; sub 3030 3031; sub 3024 3032;
mul 571 3033; mul 585 3034; mul 1443 3023; mul 1438 3036; mul 581 3037; mul 579 3038; mul 583 3037; add 3039 3040;
mul 576 3041; add 3035 3042; mul 590 3023; mul 577 3044; mul 592 3023; add 3045 3046; mul 588 3047; sub 3043 3048;
mul 554 3049; mul 505 3023; mul 577 3051; mul 614 3023; add 3052 3053; mul 612 3054; mul 610 3025; mul 567 3056; mul
611 3025; add 3057 3058; mul 567 3059; mul 1469 3025; add 3060 3061; mul 554 3062; mul 616 3063; sub 3055 3064; mul
608 3065; add 3050 3066; mul 620 3065; mul 617 3068; mul 621 3065; add 3069 3070; mul 635 3071; mul 625 2933; mul
569 3073; mul 554 3027; mul 627 3075; sub 3074 3076; mul 17 3077; mul 130 3078; mul 560 3075; mul 0 3080; add 3079
3081; mul 569 2933; mul 553 3075; sub 3083 3084; mul 540 3085; mul 570 3011; add 3086 3087; add 3082 3088; mul 622
3089; add 3072 3090; add 3067 3091; mul 570 3092; mul 637 3085; add 3093 3094; add 3020 3095; mul 399 3096; sub 2907
3097; sub 2875 3098; mul 144 3099; mul 524 3017; mul 544 2987; sub 3101 3102; mul 631 3092; mul 637 3080; sub 3104
3105; add 3103 3106; sub 3100 3107; add 1645 3108; mul 90 3109; sub 2749 3110; mul 89 2732; mul 1529 2746; sub 3112
3113; mul 830 3114; mul 150 2822; mul 145 3116; mul 298 2837; mul 769 2839; add 3118 3119; mul 772 2843; add 3120
3121; mul 306 3122; mul 774 2849; add 3123 3124; mul 780 2852; mul 786 2854; add 3126 3127; mul 339 2859; add 3128
3129; mul 794 2862; add 3130 3131; mul 797 2867; add 3132 3133; mul 800 2849; add 3134 3135; add 3125 3136; mul 145
3137; where 758 3138; add 3117 3139; mul 640 3003; mul 531 3096; sub 3141 3142; sub 3140 3143; mul 522 3017; mul 544
2993; sub 3145 3146; mul 629 3092; mul 637 3078; add 3148 3149; add 3147 3150; add 3144 3151; mul 22 2559; add 3152
3153; mul 754 3154; sub 3115 3155; sub 3111 3156; mul 89 2743; mul 1576 2746; sub 3158 3159; mul 958 3160; mul 836
2790; add 834 3162; mul 839 2794; add 3163 3164; input p 205; add 3165 3166; mul 844 2751; add 3167 3168; mul 847
2755; add 3169 3170; mul 850 2758; add 3171 3172; mul 227 2762; add 3173 3174; mul 855 2767; add 3175 3176; mul 157
2775; add 3177 3178; mul 860 2779; add 3179 3180; mul 169 2784; add 3181 3182; mul 184 201; add 3183 3184; mul 257
2787; add 3185 3186; mul 153 2822; add 3187 3188; mul 145 3189; mul 881 2837; mul 887 2839; add 3191 3192; mul 890
2843; add 3193 3194; mul 306 3195; mul 892 2849; add 3196 3197; mul 327 2852; mul 902 2854; add 3199 3200; mul 905
2859; add 3201 3202; mul 797 2862; add 3203 3204; mul 913 2867; add 3205 3206; mul 916 2849; add 3207 3208; add 3198
3209; mul 920 2843; mul 943 3211; mul 877 2852; mul 298 2854; add 3213 3214; mul 302 2859; add 3215 3216; mul 884
2862; add 3217 3218; mul 772 2867; add 3219 3220; mul 941 2849; add 3221 3222; mul 921 3223; add 3212 3224; add 3210
3225; mul 145 3226; where 876 3227; add 3190 3228; mul 640 3009; mul 537 3096; sub 3230 3231; sub 3229 3232; mul 51
745; mul 22 3234; add 3233 3235; mul 833 3236; add 3161 3237; sub 3157 3238; mul 56 2715; mul 70 2703; add 3240
3241; mul 79 2729; add 3243 3243; sub 3242 3244; mul 89 3245; mul 1722 2746; sub 3246 3247; mul 830 3248; mul 964
3154; sub 3249 3250; mul 752 3114; mul 754 3109; sub 3252 3253; sub 3251 3254; mul 59 2715; mul 70 2709; add 3256
3257; mul 76 2729; mul 79 2720; add 3259 3260; sub 3258 3261; mul 89 3262; mul 1740 2746; sub 3263 3264; mul 958
3265; mul 971 3236; add 3266 3267; add 3255 3268; mul 752 3160; mul 833 3109; sub 3270 3271; mul 830 3265; mul 971
3154; sub 3273 3274; sub 3272 3275; mul 45 2715; mul 70 2700; add 3277 3278; mul 76 2720; add 3280 3280; sub 3279
3281; mul 89 3282; mul 1803 2746; sub 3283 3284; mul 958 3285; mul 980 3236; add 3286 3287; sub 3276 3288; mul 542
2978; mul 510 3014; add 3290 3291; mul 635 3065; mul 617 3089; add 3293 3294; mul 457 537; mul 515 3296; mul 457
3297; mul 537 570; mul 622 3299; mul 570 3300; add 3298 3301; mul 531 3302; input p 206; add 3303 3304; mul 522
3297; mul 629 3300; add 3306 3307; add 3305 3308; add 727 728; add 726 3310; mul 41 3311; mul 22 3312; add 3309
3313; mul 754 3314; mul 399 3302; input p 207; add 3316 3317; mul 144 3318; mul 524 3297; mul 631 3300; add 3320
3321; sub 3319 3322; mul 67 3311; mul 22 3324; add 3323 3325; mul 90 3326; sub 3315 3327; mul 537 3302; input p 208;
add 3329 3330; mul 53 3311; mul 22 3332; add 3331 3333; mul 833 3334; sub 3328 3335; mul 754 3326; mul 964 3314; sub
3337 3338; mul 971 3334; add 3339 3340; mul 971 3314; mul 833 3326; sub 3342 3343; mul 980 3334; sub 3344 3345; mul
510 3296; mul 617 3299; mul 488 510; mul 457 3349; mul 531 3350; mul 522 3349; add 3351 3352; mul 754 3353; mul 399
3350; mul 144 3355; mul 524 3349; sub 3356 3357; mul 90 3358; sub 3354 3359; mul 537 3350; mul 833 3361; sub 3360
3362; mul 754 3358; mul 964 3353; sub 3364 3365; mul 971 3361; add 3366 3367; mul 971 3353; mul 833 3358; sub 3369
3370; mul 980 3361; sub 3371 3372; input p 209; mul 598 617; mul 570 3375; mul 531 3376; mul 629 3375; add 3377
3378; mul 754 3379; mul 399 3376; mul 144 3381; mul 631 3375; sub 3382 3383; mul 90 3384; sub 3380 3385; mul 537
3376; mul 833 3387; sub 3386 3388; mul 754 3384; mul 964 3379; sub 3390 3391; mul 971 3387; add 3392 3393; mul 971
3379; mul 833 3384; sub 3395 3396; mul 980 3387; sub 3397 3398; mul 491 510; mul 457 3400; mul 531 3401; mul 522
3400; add 3402 3403; mul 754 3404; mul 399 3401; mul 144 3406; mul 524 3400; sub 3407 3408; mul 90 3409; sub 3405
3410; mul 537 3401; mul 833 3412; sub 3411 3413; mul 754 3409; mul 964 3404; sub 3415 3416; mul 971 3412; add 3417
3418; mul 971 3404; mul 833 3409; sub 3420 3421; mul 980 3412; sub 3422 3423; input p 210; mul 601 617; mul 570
3426; mul 531 3427; mul 629 3426; add 3428 3429; mul 754 3430; mul 399 3427; mul 144 3432; mul 631 3426; sub 3433
3434; mul 90 3435; sub 3431 3436; mul 537 3427; mul 833 3438; sub 3437 3439; mul 754 3435; mul 964 3430; sub 3441
3442; mul 971 3438; add 3443 3444; mul 971 3430; mul 833 3435; sub 3446 3447; mul 980 3438; sub 3448 3449; mul 495
510; mul 457 3451; mul 531 3452; mul 522 3451; add 3453 3454; mul 754 3455; mul 399 3452; mul 144 3457; mul 524
3451; sub 3458 3459; mul 90 3460; sub 3456 3461; mul 537 3452; mul 833 3463; sub 3462 3464; mul 754 3460; mul 964
3455; sub 3466 3467; mul 971 3463; add 3468 3469; mul 971 3455; mul 833 3460; sub 3471 3472; mul 980 3463; sub 3473
3474; input p 211; mul 605 617; mul 570 3477; mul 531 3478; mul 629 3477; add 3479 3480; mul 754 3481; mul 399 3478;
mul 144 3483; mul 631 3477; sub 3484 3485; mul 90 3486; sub 3482 3487; mul 537 3478; mul 833 3489; sub 3488 3490;
mul 754 3486; mul 964 3481; sub 3492 3493; mul 971 3489; add 3494 3495; mul 971 3481; mul 833 3486; sub 3497 3498;
mul 980 3489; sub 3499 3500; mul 90 701; mul 701 754; neg 3503; mul 701 833; input p 212; mul 90 705; mul 705 754;
neg 3508; mul 705 833; input p 213; input p 214; mul 754 3512; mul 90 670; sub 3513 3514; mul 670 754; mul 964 3512;
sub 3516 3517; mul 971 3512; mul 670 833; sub 3519 3520; input p 215; mul 754 3522; mul 90 673; sub 3523 3524; mul
673 754; mul 964 3522; sub 3526 3527; mul 971 3522; mul 673 833; sub 3529 3530; input p 216; mul 754 3532; mul 90
677; sub 3533 3534; mul 677 754; mul 964 3532; sub 3536 3537; mul 971 3532; mul 677 833; sub 3539 3540; input p 217;
mul 754 3542; mul 90 681; sub 3543 3544; mul 681 754; mul 964 3542; sub 3546 3547; mul 971 3542; mul 681 833; sub
3549 3550; mul 102 109; add 92 3552; mul 100 121; sub 3553 3554; mul 477 484; mul 441 3556; mul 524 3557; mul 457
3557; mul 399 3559; mul 144 3560; sub 3558 3561; sub 3555 3562; mul 90 3563; mul 531 3559; mul 522 3557; add 3565
3566; add 121 3567; mul 754 3568; sub 3564 3569; mul 537 3559; mul 833 3571; add 3570 3572; mul 964 3568; mul 754
3563; sub 3574 3575; mul 971 3571; sub 3576 3577; mul 833 3563; mul 971 3568; sub 3579 3580; mul 980 3571; add 3581
3582; mul 102 112; add 96 3584; mul 100 124; sub 3585 3586; mul 587 594; mul 554 3588; mul 631 3589; mul 570 3589;
mul 399 3591; mul 144 3592; sub 3590 3593; sub 3587 3594; mul 90 3595; mul 531 3591; mul 629 3589; add 3597 3598;
add 124 3599; mul 754 3600; sub 3596 3601; mul 537 3591; mul 833 3603; add 3602 3604; mul 964 3600; mul 754 3595;
sub 3606 3607; mul 971 3603; sub 3608 3609; mul 833 3595; mul 971 3600; sub 3611 3612; mul 980 3603; add 3613 3614;
neg 754; neg 1658; neg 1812; neg 1752; neg 1755; neg 1671; neg 1822; neg 1762; neg 1679; neg 1828; neg 1683; neg
1831; neg 1772; neg 1775; neg 1702; neg 1842; neg 1782; neg 1785; store f 0 0; store f 1 960; store f 2 130; store f
3 973; store f 4 538; store f 5 982; store f 6 986; store f 7 989; store f 8 992; store f 9 994; store f 10 997;
store f 11 999; store f 12 1001; store f 13 1003; store f 14 1017; store f 15 1026; store f 16 1035; store f 17
1044; store a 18 1714; store a 54 1788; store a 90 1851; store a 108 1854; store a 126 1857; store a 144 1854; store
a 162 1857; store a 180 1854; store a 198 1857; store a 216 1000; store a 234 1002; store a 1 2; store a 19 1919;
store a 55 1924; store a 91 1930; store a 109 1931; store a 127 1932; store a 145 1931; store a 163 1932; store a
181 1931; store a 199 1932; store a 253 1933; store a 271 1934; store a 289 1935; store a 307 1936; store a 20 2566;
store a 56 2596; store a 92 2616; store a 110 2619; store a 128 2622; store a 146 2619; store a 164 2622; store a
182 2619; store a 200 2622; store a 21 2678; store a 39 2; store a 57 2683; store a 93 2688; store a 111 2689; store
a 129 2690; store a 147 2689; store a 165 2690; store a 183 2689; store a 201 2690; store a 255 2692; store a 273
2694; store a 291 2696; store a 309 2698; store a 22 3239; store a 58 3269; store a 94 3289; store a 112 3292; store
a 130 3295; store a 148 3292; store a 166 3295; store a 184 3292; store a 202 3295; store a 23 3336; store a 59
3341; store a 77 2; store a 95 3346; store a 113 3347; store a 131 3348; store a 149 3347; store a 167 3348; store a
185 3347; store a 203 3348; store a 24 3363; store a 60 3368; store a 96 3373; store a 114 3374; store a 25 3389;
store a 61 3394; store a 97 3399; store a 133 3374; store a 26 3414; store a 62 3419; store a 98 3424; store a 152
3425; store a 27 3440; store a 63 3445; store a 99 3450; store a 171 3425; store a 28 3465; store a 64 3470; store a
100 3475; store a 190 3476; store a 29 3491; store a 65 3496; store a 101 3501; store a 209 3476; store a 30 3502;
store a 66 3504; store a 102 3505; store a 228 3506; store a 31 3507; store a 67 3509; store a 103 3510; store a 247
3511; store a 32 3515; store a 68 3518; store a 104 3521; store a 33 3525; store a 69 3528; store a 105 3531; store
a 34 3535; store a 70 3538; store a 106 3541; store a 35 3545; store a 71 3548; store a 107 3551; store b 2 3573;
store b 6 3578; store b 10 3583; store b 3 3605; store b 7 3610; store b 11 3615; store by_c 13 90; store by_c 39
3616; store by_c 65 833; store by_c 14 3617; store by_c 40 1748; store by_c 66 3618; store by_c 15 1662; store by_c
41 3619; store by_c 67 1815; store by_c 16 1666; store by_c 42 3620; store by_c 68 1818; store by_c 17 3621; store
by_c 43 1759; store by_c 69 3622; store by_c 18 1675; store by_c 44 3623; store by_c 70 1825; store by_c 19 3624;
store by_c 45 1765; store by_c 71 3625; store by_c 20 3626; store by_c 46 1768; store by_c 72 3627; store by_c 21
1693; store by_c 47 3628; store by_c 73 1835; store by_c 22 1697; store by_c 48 3629; store by_c 74 1838; store by_c
23 3630; store by_c 49 1779; store by_c 75 3631; store by_c 24 1706; store by_c 50 3632; store by_c 76 1845; store
by_c 25 1710; store by_c 51 3633; store by_c 77 1848
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'p': 232},
    {'by_k': 1800},
    """
input p 0; constant 1.0; input x 2; input p 1; mul 2 3; mul 2 4; add 1 5; sqrt 6; div 1 7; input p 2; mul 2 9; mul 2
10; add 1 11; sqrt 12; mul 7 13; div 1 14; mul 8 15; input p 3; mul 16 17; mul 16 18; add 0 19; input p 4; input p
5; mul 8 13; mul 16 23; mul 22 24; mul 25 25; input p 6; input x 0; mul 27 28; input p 7; mul 2 30; add 29 31; input
p 8; input x 4; mul 33 34; add 32 35; mul 2 8; mul 16 37; mul 22 38; add 36 39; mul 40 40; add 26 41; mul 21 42; add
20 43; input p 9; input p 10; mul 28 46; mul 2 33; add 47 48; input p 11; mul 34 50; add 49 51; mul 52 52; mul 21
53; add 45 54; mul 44 55; mul 40 52; mul 21 57; mul 58 58; sub 56 59; input p 12; mul 28 61; mul 2 27; add 62 63;
mul 34 46; add 64 65; mul 66 66; add 1 67; mul 21 68; mul 60 69; input p 13; mul 40 66; add 25 72; mul 21 73; add 71
74; mul 55 75; mul 52 66; mul 21 77; mul 58 78; sub 76 79; mul 75 80; sub 70 81; mul 58 75; mul 44 78; sub 83 84;
mul 78 85; add 82 86; div 1 87; mul 60 88; input p 17; input p 18; input p 19; input p 20; mul 28 90; mul 93 94;
input p 21; mul 2 96; add 95 97; input p 22; mul 34 99; add 98 100; mul 92 101; input p 23; mul 34 101; mul 103 104;
add 102 105; input p 24; mul 34 104; mul 107 108; add 106 109; input p 25; mul 101 101; mul 111 112; add 110 113;
input p 26; mul 34 112; mul 115 116; add 114 117; input p 27; mul 101 112; mul 119 120; add 118 121; input p 28; mul
94 123; add 122 124; input p 29; mul 34 94; mul 126 127; add 125 128; input p 30; mul 34 127; mul 130 131; add 129
132; input p 31; mul 94 101; mul 134 135; add 133 136; input p 32; mul 34 135; mul 138 139; add 137 140; input p 33;
mul 101 135; mul 142 143; add 141 144; input p 34; mul 94 94; mul 101 147; mul 146 148; add 145 149; input p 35; mul
94 147; mul 151 152; add 150 153; input p 36; input p 37; mul 34 156; add 155 157; input p 38; mul 34 34; mul 159
160; add 158 161; input p 39; mul 34 160; mul 163 164; add 162 165; input p 40; mul 101 167; add 166 168; input p
41; mul 104 170; add 169 171; input p 42; mul 108 173; add 172 174; input p 43; mul 112 176; add 175 177; input p
44; mul 116 179; add 178 180; input p 45; mul 120 182; add 181 183; mul 92 94; add 184 185; mul 103 127; add 186
187; mul 107 131; add 188 189; input p 46; mul 135 191; add 190 192; input p 47; mul 139 194; add 193 195; input p
48; mul 143 197; add 196 198; input p 49; mul 147 200; add 199 201; input p 50; mul 34 147; mul 203 204; add 202
205; mul 142 148; add 206 207; input p 51; mul 152 209; add 208 210; mul 93 211; add 154 212; mul 91 213; abs 94;
constant 0.35; lt 215 216; input p 52; constant -0.35; max 219 94; min 216 220; mul 221 221; mul 218 222; input p
53; constant 0.6; constant -0.6; max 226 2; min 225 227; mul 221 228; mul 224 229; add 223 230; input p 54; constant
2.0; constant -2.0; max 234 34; min 233 235; mul 221 236; mul 232 237; add 231 238; input p 55; mul 228 228; mul 240
241; add 239 242; input p 56; mul 228 236; mul 244 245; add 243 246; input p 57; mul 236 236; mul 248 249; add 247
250; mul 236 249; mul 251 252; input p 58; mul 221 222; mul 254 255; input p 59; mul 222 228; mul 257 258; add 256
259; input p 60; mul 222 236; mul 261 262; add 260 263; input p 61; mul 228 229; mul 265 266; add 264 267; input p
62; mul 229 236; mul 269 270; add 268 271; input p 63; mul 236 237; mul 273 274; add 272 275; input p 64; mul 228
241; mul 277 278; add 276 279; input p 65; mul 236 241; mul 281 282; add 280 283; input p 66; mul 236 245; mul 285
286; add 284 287; input p 67; mul 252 289; add 288 290; add 253 291; mul 91 292; where 217 293; add 214 294; input p
68; mul 66 296; input p 69; mul 108 298; input p 70; mul 120 300; add 299 301; input p 71; mul 131 303; add 302 304;
input p 72; mul 139 306; add 305 307; input p 73; mul 143 309; add 308 310; input p 74; mul 148 312; add 311 313;
input p 75; mul 152 315; add 314 316; input p 76; mul 164 318; input p 77; mul 108 320; add 319 321; input p 78; mul
116 323; add 322 324; input p 79; mul 120 326; add 325 327; mul 131 298; add 328 329; input p 80; mul 143 331; add
330 332; input p 81; mul 204 334; add 333 335; mul 148 309; add 336 337; input p 82; mul 152 339; add 338 340; mul
93 341; add 317 342; mul 296 343; add 297 344; input p 83; input p 84; constant 0.5; mul 28 66; mul 2 36; add 349
350; mul 34 52; add 351 352; mul 348 353; constant 0.25; mul 94 317; mul 101 341; add 356 357; input p 85; mul 164
359; input p 86; mul 108 361; add 360 362; mul 116 320; add 363 364; input p 87; mul 120 366; add 365 367; input p
88; mul 139 369; add 368 370; mul 204 303; add 371 372; mul 148 334; add 373 374; mul 34 375; add 358 376; mul 355
377; mul 296 378; add 354 379; add 347 380; input p 89; mul 23 382; add 381 383; input p 90; mul 37 385; sub 384
386; input p 91; mul 23 385; input p 92; sub 389 390; mul 37 382; add 391 392; sub 393 28; mul 394 394; mul 387 387;
add 395 396; sqrt 397; mul 388 398; sqrt 399; div 1 400; mul 401 401; mul 388 402; mul 387 403; input p 93; mul 233
399; mul 233 402; mul 402 407; sub 406 408; mul 405 409; constant 0.3; constant -0.3; constant 1.4; sub 399 413; max
412 414; min 411 415; input p 94; input p 95; mul 416 418; add 417 419; mul 416 420; add 1 421; mul 410 422; input u
0; input p 96; mul 424 425; input p 97; input p 98; mul 414 428; add 427 429; mul 414 430; add 1 431; mul 426 432;
sub 423 433; mul 388 434; input p 99; input x 6; mul 436 437; input p 100; input x 8; mul 439 440; add 438 441;
input p 101; input x 10; mul 443 444; add 442 445; constant -0.5; mul 401 447; mul 401 448; mul 401 449; mul 388
450; input p 102; input p 103; mul 414 453; add 452 454; mul 414 455; add 1 456; mul 451 457; mul 446 458; add 435
459; input p 104; mul 458 461; mul 458 462; input x 3; sub 383 386; mul 394 465; add 389 392; mul 387 467; sub 466
468; mul 403 469; mul 16 470; mul 464 471; input x 1; mul 394 403; mul 473 474; sub 472 475; mul 90 473; mul 345
477; mul 96 341; mul 296 479; add 36 480; mul 464 481; add 478 482; mul 99 341; add 375 484; mul 296 485; add 52
486; input x 5; mul 487 488; add 483 489; mul 404 490; add 476 491; mul 463 492; add 460 493; mul 404 494; input p
105; add 380 496; input p 106; mul 23 498; add 497 499; input p 107; mul 37 501; add 500 502; input p 108; mul 37
498; mul 23 501; input p 109; sub 506 507; sub 505 508; sub 509 28; mul 510 510; mul 503 503; add 511 512; sqrt 513;
mul 504 514; sqrt 515; div 1 516; mul 517 517; mul 504 518; mul 503 519; input p 110; mul 233 515; mul 233 518; mul
518 523; sub 522 524; mul 521 525; sub 515 413; max 412 527; min 411 528; input p 111; input p 112; mul 529 531; add
530 532; mul 529 533; add 1 534; mul 526 535; input u 1; input p 113; mul 537 538; input p 114; input p 115; mul 527
541; add 540 542; mul 527 543; add 1 544; mul 539 545; sub 536 546; mul 504 547; input p 116; input x 7; mul 549
550; input p 117; input x 9; mul 552 553; add 551 554; input p 118; input x 11; mul 556 557; add 555 558; mul 447
517; mul 517 560; mul 517 561; mul 504 562; mul 453 527; add 452 564; mul 527 565; add 1 566; mul 563 567; mul 559
568; add 548 569; input p 119; mul 568 571; mul 568 572; add 499 502; mul 510 574; sub 506 505; mul 503 576; add 575
577; mul 519 578; mul 16 579; mul 464 580; mul 510 519; mul 473 582; sub 581 583; mul 490 520; add 584 585; mul 573
586; add 570 587; mul 520 588; add 495 589; sub 346 590; mul 345 591; sub 295 592; input p 120; constant 12.0; mul
477 595; constant -6.0; mul 93 477; mul 96 464; add 598 599; mul 99 488; add 600 601; mul 597 602; add 596 603; mul
594 604; mul 477 597; constant 4.0; mul 602 607; add 606 608; mul 594 609; mul 93 610; add 605 611; add 593 612; mul
90 613; mul 90 614; mul 89 615; mul 80 88; mul 580 617; mul 89 582; add 618 619; mul 85 88; mul 487 621; mul 481
617; sub 622 623; mul 89 90; mul 345 625; add 624 626; mul 520 627; sub 620 628; mul 573 629; mul 490 630; mul 588
627; sub 631 632; mul 519 633; mul 588 617; mul 464 630; add 635 636; mul 16 637; mul 519 638; mul 576 639; add 634
640; mul 233 503; mul 233 514; div 1 643; mul 586 629; mul 572 645; mul 568 645; mul 571 647; add 646 648; mul 559
629; add 649 650; mul 563 651; mul 565 652; mul 527 652; mul 453 654; add 653 655; mul 504 629; mul 539 657; mul 543
658; sub 656 659; mul 527 658; mul 541 661; sub 660 662; le 412 527; le 527 412; add 664 665; div 1 666; mul 664
667; le 528 411; le 411 528; add 669 670; div 1 671; mul 669 672; mul 526 657; mul 533 674; mul 529 674; mul 531
676; add 675 677; mul 673 678; mul 668 679; add 663 680; mul 233 516; div 1 682; mul 517 562; mul 567 651; mul 504
685; mul 684 686; mul 517 686; mul 562 688; add 687 689; mul 517 688; mul 561 691; add 690 692; mul 233 517; mul 503
633; mul 89 588; mul 473 630; sub 696 697; mul 510 698; add 695 699; mul 578 638; add 700 701; mul 504 702; mul 535
657; mul 521 704; mul 523 705; sub 703 706; mul 518 705; neg 708; mul 233 709; add 707 710; mul 694 711; mul 518
712; add 693 713; mul 683 714; sub 681 715; mul 233 705; add 716 717; mul 504 718; mul 644 719; mul 642 720; add 641
721; sub 616 722; mul 591 621; mul 520 630; mul 471 617; mul 89 474; add 726 727; mul 404 627; sub 728 729; mul 463
730; mul 404 731; add 725 732; mul 488 733; add 724 734; mul 485 735; add 723 736; mul 464 733; mul 591 617; sub 738
739; mul 479 740; add 737 741; mul 90 477; mul 96 617; mul 99 621; sub 744 745; mul 93 625; sub 746 747; mul 594
748; mul 597 749; mul 607 749; mul 594 625; mul 597 752; sub 751 753; mul 93 754; add 750 755; mul 595 752; sub 756
757; mul 345 733; add 758 759; mul 743 760; sub 742 761; mul 591 625; mul 477 733; add 763 764; mul 343 765; add 762
766; mul 66 765; add 767 768; mul 490 731; mul 494 627; sub 770 771; mul 403 772; mul 494 617; mul 464 731; add 774
775; mul 16 776; mul 403 777; mul 467 778; sub 773 779; mul 233 387; mul 233 398; div 1 782; mul 492 730; mul 462
784; mul 458 784; mul 461 786; add 785 787; mul 446 730; add 788 789; mul 451 790; mul 455 791; mul 414 791; mul 453
793; add 792 794; mul 388 730; mul 426 796; mul 430 797; sub 795 798; mul 414 797; mul 428 800; sub 799 801; le 412
414; le 414 412; add 803 804; div 1 805; mul 803 806; le 415 411; le 411 415; add 808 809; div 1 810; mul 808 811;
mul 410 796; mul 420 813; mul 416 813; mul 418 815; add 814 816; mul 812 817; mul 807 818; add 802 819; mul 233 400;
div 1 821; mul 401 450; mul 457 790; mul 388 824; mul 823 825; mul 401 825; mul 450 827; add 826 828; mul 401 827;
mul 449 830; add 829 831; mul 233 401; mul 387 772; mul 89 494; mul 473 731; sub 835 836; mul 394 837; add 834 838;
mul 469 777; add 839 840; mul 388 841; mul 422 796; mul 405 843; mul 407 844; sub 842 845; mul 402 844; neg 847; mul
233 848; add 846 849; mul 833 850; mul 402 851; add 832 852; mul 822 853; sub 820 854; mul 233 844; add 855 856; mul
388 857; mul 783 858; mul 781 859; add 780 860; add 722 861; mul 378 862; add 769 863; sub 864 861; mul 90 94; mul
94 233; mul 296 735; mul 296 862; mul 355 869; mul 34 870; add 868 871; mul 334 872; mul 101 873; mul 867 874; mul
91 621; mul 203 876; mul 101 877; mul 867 878; mul 130 876; mul 34 880; mul 867 881; add 879 882; input p 155; mul
876 884; mul 867 885; add 883 886; mul 115 876; mul 101 888; mul 101 889; add 887 890; input p 154; mul 876 892; mul
34 893; mul 101 894; add 891 895; mul 103 876; mul 101 897; add 896 898; sub 875 899; mul 303 872; mul 34 901; mul
867 902; add 900 903; mul 369 872; mul 34 905; mul 101 906; add 904 907; mul 99 868; mul 296 740; mul 96 910; add
909 911; mul 296 765; mul 93 913; add 912 914; mul 101 870; add 915 916; mul 339 917; mul 147 918; add 908 919; mul
94 918; mul 867 921; add 920 922; mul 309 917; mul 101 924; mul 867 925; add 923 926; mul 334 917; mul 34 928; mul
867 929; add 927 930; mul 331 917; mul 101 932; mul 101 933; add 931 934; mul 298 917; mul 34 936; mul 34 937; add
935 938; mul 317 870; add 939 940; mul 94 870; add 913 942; mul 315 943; mul 147 944; add 941 945; mul 94 944; mul
867 947; add 946 948; mul 312 943; mul 101 950; mul 867 951; add 949 952; mul 309 943; mul 101 954; mul 101 955; add
953 956; mul 306 943; mul 34 958; mul 101 959; add 957 960; mul 303 943; mul 34 962; mul 34 963; add 961 964; le 219
94; le 94 219; add 966 967; div 1 968; mul 966 969; le 220 216; le 216 220; add 971 972; div 1 973; mul 971 974; abs
34; lt 976 233; input p 167; constant 3.0; mul 249 979; mul 876 980; mul 978 981; input p 161; mul 876 983; add 982
984; neg 985; where 977 986; abs 2; lt 988 225; input p 137; mul 91 617; mul 990 991; where 989 992; add 987 993;
mul 91 625; mul 254 995; neg 996; where 217 997; add 994 998; mul 222 999; input p 157; mul 252 876; mul 1001 1002;
neg 1003; where 977 1004; mul 252 991; mul 244 1006; where 989 1007; add 1005 1008; mul 248 981; input p 163; mul
876 1011; add 1010 1012; neg 1013; where 977 1014; mul 285 991; where 989 1016; add 1015 1017; mul 273 995; neg
1019; where 217 1020; add 1018 1021; mul 236 1022; add 1009 1023; mul 252 995; mul 232 1025; neg 1026; where 217
1027; add 1024 1028; mul 236 1029; add 1000 1030; mul 244 1002; neg 1032; where 977 1033; input p 133; mul 1006
1035; where 989 1036; add 1034 1037; mul 244 981; input p 162; mul 876 1040; add 1039 1041; neg 1042; where 977
1043; input p 140; mul 991 1045; where 989 1046; add 1044 1047; mul 269 995; neg 1049; where 217 1050; add 1048
1051; mul 236 1052; add 1038 1053; mul 240 981; mul 281 876; add 1055 1056; neg 1057; where 977 1058; input p 139;
mul 991 1060; where 989 1061; add 1059 1062; mul 265 995; neg 1064; where 217 1065; add 1063 1066; mul 228 1067; add
1054 1068; mul 224 1025; neg 1070; where 217 1071; add 1069 1072; mul 228 1073; add 1031 1074; mul 221 233; input p
156; mul 1002 1077; neg 1078; where 977 1079; input p 132; mul 1006 1081; where 989 1082; add 1080 1083; mul 981
1077; mul 273 876; add 1085 1086; neg 1087; where 977 1088; input p 138; mul 991 1090; where 989 1091; add 1089
1092; mul 261 995; neg 1094; where 217 1095; add 1093 1096; mul 236 1097; add 1084 1098; mul 981 1081; mul 876 1090;
add 1100 1101; neg 1102; where 977 1103; mul 265 991; where 989 1105; add 1104 1106; mul 257 995; neg 1108; where
217 1109; add 1107 1110; mul 228 1111; add 1099 1112; mul 221 999; add 1113 1114; mul 218 1025; neg 1116; where 217
1117; add 1115 1118; mul 1076 1119; add 1075 1120; mul 975 1121; mul 970 1122; add 965 1123; mul 96 991; mul 99 876;
sub 1125 1126; mul 93 995; sub 1127 1128; mul 209 1129; mul 147 1130; add 1124 1131; mul 94 1130; mul 867 1133; add
1132 1134; mul 142 1129; mul 101 1136; mul 867 1137; add 1135 1138; mul 203 1129; mul 34 1140; mul 867 1141; add
1139 1142; mul 200 1129; mul 867 1144; add 1143 1145; mul 197 1129; mul 101 1147; mul 101 1148; add 1146 1149; mul
194 1129; mul 34 1151; mul 101 1152; add 1150 1153; mul 191 1129; mul 101 1155; add 1154 1156; mul 107 1129; mul 34
1158; mul 34 1159; add 1157 1160; mul 103 1129; mul 34 1162; add 1161 1163; mul 92 1129; add 1164 1165; mul 151 995;
mul 147 1167; sub 1166 1168; mul 94 1167; mul 867 1170; sub 1169 1171; mul 146 995; mul 101 1173; mul 867 1174; sub
1172 1175; mul 142 995; mul 101 1177; mul 101 1178; sub 1176 1179; mul 138 995; mul 34 1181; mul 101 1182; sub 1180
1183; mul 134 995; mul 101 1185; sub 1184 1186; mul 130 995; mul 34 1188; mul 34 1189; sub 1187 1190; mul 126 995;
mul 34 1192; sub 1191 1193; mul 123 995; sub 1194 1195; mul 147 873; mul 147 877; mul 135 888; add 1198 1199; mul 94
889; add 1200 1201; mul 94 894; add 1202 1203; mul 94 897; add 1204 1205; input p 153; mul 876 1207; mul 112 1208;
add 1206 1209; mul 101 233; mul 101 1208; mul 1211 1212; add 1210 1213; mul 173 876; mul 34 1215; mul 1211 1216; add
1214 1217; input p 152; mul 876 1219; mul 1211 1220; add 1218 1221; input p 151; mul 876 1223; mul 34 1224; mul 34
1225; add 1222 1226; input p 150; mul 876 1228; mul 34 1229; add 1227 1230; mul 156 876; add 1231 1232; sub 1197
1233; mul 94 906; add 1234 1235; mul 366 872; mul 112 1237; add 1236 1238; mul 101 1237; mul 1211 1240; add 1239
1241; mul 320 872; mul 34 1243; mul 1211 1244; add 1242 1245; mul 361 872; mul 34 1247; mul 34 1248; add 1246 1249;
mul 341 870; add 1250 1251; mul 147 924; add 1252 1253; mul 135 932; add 1254 1255; mul 94 933; add 1256 1257; mul
326 917; mul 112 1259; add 1258 1260; mul 101 1259; mul 1211 1262; add 1261 1263; mul 323 917; mul 34 1265; mul 1211
1266; add 1264 1267; mul 320 917; mul 34 1269; mul 34 1270; add 1268 1271; mul 147 950; add 1272 1273; mul 135 954;
add 1274 1275; mul 94 955; add 1276 1277; mul 94 959; add 1278 1279; mul 300 943; mul 112 1281; add 1280 1282; mul
101 1281; mul 1211 1284; add 1283 1285; mul 298 943; mul 34 1287; mul 34 1288; add 1286 1289; mul 147 1136; add 1290
1291; mul 135 1147; add 1292 1293; mul 94 1148; add 1294 1295; mul 94 1152; add 1296 1297; mul 94 1155; add 1298
1299; mul 182 1129; mul 112 1301; add 1300 1302; mul 101 1301; mul 1211 1304; add 1303 1305; mul 179 1129; mul 34
1307; mul 1211 1308; add 1306 1309; mul 176 1129; mul 1211 1311; add 1310 1312; mul 173 1129; mul 34 1314; mul 34
1315; add 1313 1316; mul 170 1129; mul 34 1318; add 1317 1319; mul 167 1129; add 1320 1321; mul 147 1173; sub 1322
1323; mul 135 1177; sub 1324 1325; mul 94 1178; sub 1326 1327; mul 94 1182; sub 1328 1329; mul 94 1185; sub 1330
1331; mul 119 995; mul 112 1333; sub 1332 1334; mul 101 1333; mul 1211 1336; sub 1335 1337; mul 115 995; mul 34
1339; mul 1211 1340; sub 1338 1341; mul 111 995; mul 1211 1343; sub 1342 1344; mul 107 995; mul 34 1346; mul 34
1347; sub 1345 1348; mul 103 995; mul 34 1350; sub 1349 1351; mul 92 995; sub 1352 1353; mul 93 1354; add 1196 1355;
mul 866 1356; sub 865 1357; input p 218; input c 4; input p 14; mul 28 1361; sub 2 1362; input c 5; mul 1363 1364;
sub 1360 1365; input c 6; mul 424 1367; add 1366 1368; input c 7; mul 537 1370; add 1369 1371; input c 8; input p
15; max 1373 1374; mul 473 1361; sub 464 1376; mul 1375 1377; sub 1372 1378; mul 89 1379; mul 89 1361; add 617 1381;
mul 1375 1382; mul 473 1383; add 1380 1384; mul 1364 1382; input c 9; input c 10; mul 348 1388; mul 1363 1389; sub
1387 1390; input c 11; mul 424 1392; add 1391 1393; input c 12; mul 537 1395; add 1394 1396; mul 89 1397; add 1386
1398; mul 89 1363; mul 1389 1400; sub 1399 1401; mul 28 1402; add 1385 1403; mul 1359 1404; add 1358 1405; mul 55
69; mul 78 78; sub 1407 1408; mul 88 1409; mul 591 1410; mul 580 1410; mul 582 617; add 1412 1413; mul 481 1410; mul
58 69; mul 75 78; sub 1416 1417; mul 88 1418; mul 487 1419; sub 1415 1420; mul 90 617; mul 345 1422; sub 1421 1423;
mul 520 1424; add 1414 1425; mul 573 1426; mul 520 1427; mul 471 1410; mul 474 617; add 1429 1430; mul 404 1424; add
1431 1432; mul 463 1433; mul 404 1434; add 1428 1435; mul 464 1436; sub 1411 1437; mul 479 1438; mul 615 617; mul
504 1426; mul 539 1441; mul 543 1442; mul 586 1426; mul 572 1444; mul 568 1444; mul 571 1446; add 1445 1447; mul 559
1426; add 1448 1449; mul 563 1450; mul 565 1451; mul 527 1451; mul 453 1453; add 1452 1454; sub 1443 1455; mul 527
1442; mul 541 1457; add 1456 1458; mul 526 1441; mul 533 1460; mul 529 1460; mul 531 1462; add 1461 1463; mul 673
1464; mul 668 1465; sub 1459 1466; mul 567 1450; mul 504 1468; mul 684 1469; mul 517 1469; mul 562 1471; add 1470
1472; mul 517 1471; mul 561 1474; add 1473 1475; mul 473 1427; sub 1477 635; mul 510 1478; mul 588 1424; mul 490
1427; add 1480 1481; mul 503 1482; sub 1479 1483; mul 588 1410; mul 464 1427; add 1485 1486; mul 16 1487; mul 578
1488; sub 1484 1489; mul 504 1490; mul 535 1441; mul 521 1492; mul 523 1493; add 1491 1494; mul 518 1493; mul 233
1496; add 1495 1497; mul 694 1498; mul 518 1499; sub 1476 1500; mul 683 1501; add 1467 1502; neg 1493; mul 233 1504;
add 1503 1505; mul 504 1506; mul 644 1507; mul 642 1508; mul 519 1482; mul 519 1488; mul 576 1511; add 1510 1512;
sub 1509 1513; add 1440 1514; mul 591 1419; mul 488 1436; add 1516 1517; mul 485 1518; add 1515 1519; sub 1439 1520;
mul 99 1419; mul 96 1410; sub 1522 1523; mul 93 1422; add 1524 1525; mul 594 1526; mul 597 1527; mul 607 1527; mul
594 1422; mul 597 1530; add 1529 1531; mul 93 1532; add 1528 1533; mul 595 1530; add 1534 1535; mul 345 1436; sub
1536 1537; mul 743 1538; sub 1521 1539; mul 591 1422; mul 477 1436; add 1541 1542; mul 343 1543; sub 1540 1544; mul
66 1543; sub 1545 1546; mul 494 1410; mul 464 1434; add 1548 1549; mul 16 1550; mul 403 1551; mul 467 1552; mul 494
1424; mul 490 1434; add 1554 1555; mul 403 1556; sub 1553 1557; mul 388 1433; mul 426 1559; mul 430 1560; mul 492
1433; mul 462 1562; mul 458 1562; mul 461 1564; add 1563 1565; mul 446 1433; add 1566 1567; mul 451 1568; mul 455
1569; mul 414 1569; mul 453 1571; add 1570 1572; sub 1561 1573; mul 414 1560; mul 428 1575; add 1574 1576; mul 410
1559; mul 420 1578; mul 416 1578; mul 418 1580; add 1579 1581; mul 812 1582; mul 807 1583; sub 1577 1584; mul 457
1568; mul 388 1586; mul 823 1587; mul 401 1587; mul 450 1589; add 1588 1590; mul 401 1589; mul 449 1592; add 1591
1593; mul 473 1434; sub 1595 774; mul 394 1596; mul 387 1556; sub 1597 1598; mul 469 1551; sub 1599 1600; mul 388
1601; mul 422 1559; mul 405 1603; mul 407 1604; add 1602 1605; mul 402 1604; mul 233 1607; add 1606 1608; mul 833
1609; mul 402 1610; sub 1594 1611; mul 822 1612; add 1585 1613; neg 1604; mul 233 1615; add 1614 1616; mul 388 1617;
mul 783 1618; mul 781 1619; add 1558 1620; add 1514 1621; mul 378 1622; add 1547 1623; sub 1624 1621; mul 91 1419;
mul 203 1626; mul 101 1627; mul 867 1628; mul 130 1626; mul 34 1630; mul 867 1631; add 1629 1632; mul 884 1626; mul
867 1634; add 1633 1635; mul 115 1626; mul 101 1637; mul 101 1638; add 1636 1639; mul 892 1626; mul 34 1641; mul 101
1642; add 1640 1643; mul 103 1626; mul 101 1645; add 1644 1646; mul 296 1622; mul 355 1648; mul 34 1649; mul 296
1518; sub 1650 1651; mul 334 1652; mul 101 1653; mul 867 1654; add 1647 1655; mul 303 1652; mul 34 1657; mul 867
1658; add 1656 1659; mul 369 1652; mul 34 1661; mul 101 1662; add 1660 1663; mul 296 1438; mul 96 1665; mul 99 1651;
sub 1666 1667; mul 296 1543; mul 93 1669; sub 1668 1670; mul 101 1649; add 1671 1672; mul 339 1673; mul 147 1674;
add 1664 1675; mul 94 1674; mul 867 1677; add 1676 1678; mul 309 1673; mul 101 1680; mul 867 1681; add 1679 1682;
mul 334 1673; mul 34 1684; mul 867 1685; add 1683 1686; mul 331 1673; mul 101 1688; mul 101 1689; add 1687 1690; mul
298 1673; mul 34 1692; mul 34 1693; add 1691 1694; mul 317 1649; add 1695 1696; mul 94 1649; sub 1698 1669; mul 315
1699; mul 147 1700; add 1697 1701; mul 94 1700; mul 867 1703; add 1702 1704; mul 312 1699; mul 101 1706; mul 867
1707; add 1705 1708; mul 309 1699; mul 101 1710; mul 101 1711; add 1709 1712; mul 306 1699; mul 34 1714; mul 101
1715; add 1713 1716; mul 303 1699; mul 34 1718; mul 34 1719; add 1717 1720; mul 980 1626; mul 978 1722; mul 983
1626; add 1723 1724; where 977 1725; mul 91 1410; mul 990 1727; neg 1728; where 989 1729; add 1726 1730; mul 91
1422; mul 254 1732; where 217 1733; add 1731 1734; mul 222 1735; mul 252 1626; mul 1001 1737; where 977 1738; mul
252 1727; mul 244 1740; neg 1741; where 989 1742; add 1739 1743; mul 248 1722; mul 1011 1626; add 1745 1746; where
977 1747; mul 285 1727; neg 1749; where 989 1750; add 1748 1751; mul 273 1732; where 217 1753; add 1752 1754; mul
236 1755; add 1744 1756; mul 252 1732; mul 232 1758; where 217 1759; add 1757 1760; mul 236 1761; add 1736 1762; mul
244 1737; where 977 1764; mul 1035 1740; neg 1766; where 989 1767; add 1765 1768; mul 244 1722; mul 1040 1626; add
1770 1771; where 977 1772; mul 1045 1727; neg 1774; where 989 1775; add 1773 1776; mul 269 1732; where 217 1778; add
1777 1779; mul 236 1780; add 1769 1781; mul 240 1722; mul 281 1626; add 1783 1784; where 977 1785; mul 1060 1727;
neg 1787; where 989 1788; add 1786 1789; mul 265 1732; where 217 1791; add 1790 1792; mul 228 1793; add 1782 1794;
mul 224 1758; where 217 1796; add 1795 1797; mul 228 1798; add 1763 1799; mul 1077 1737; where 977 1801; mul 1081
1740; neg 1803; where 989 1804; add 1802 1805; mul 1077 1722; mul 273 1626; add 1807 1808; where 977 1809; mul 1090
1727; neg 1811; where 989 1812; add 1810 1813; mul 261 1732; where 217 1815; add 1814 1816; mul 236 1817; add 1806
1818; mul 1081 1722; mul 1090 1626; add 1820 1821; where 977 1822; mul 265 1727; neg 1824; where 989 1825; add 1823
1826; mul 257 1732; where 217 1828; add 1827 1829; mul 228 1830; add 1819 1831; mul 221 1735; add 1832 1833; mul 218
1758; where 217 1835; add 1834 1836; mul 1076 1837; add 1800 1838; mul 975 1839; mul 970 1840; add 1721 1841; mul 99
1626; mul 96 1727; sub 1843 1844; mul 93 1732; add 1845 1846; mul 209 1847; mul 147 1848; add 1842 1849; mul 94
1848; mul 867 1851; add 1850 1852; mul 142 1847; mul 101 1854; mul 867 1855; add 1853 1856; mul 203 1847; mul 34
1858; mul 867 1859; add 1857 1860; mul 200 1847; mul 867 1862; add 1861 1863; mul 197 1847; mul 101 1865; mul 101
1866; add 1864 1867; mul 194 1847; mul 34 1869; mul 101 1870; add 1868 1871; mul 191 1847; mul 101 1873; add 1872
1874; mul 107 1847; mul 34 1876; mul 34 1877; add 1875 1878; mul 103 1847; mul 34 1880; add 1879 1881; mul 92 1847;
add 1882 1883; mul 151 1732; mul 147 1885; add 1884 1886; mul 94 1885; mul 867 1888; add 1887 1889; mul 146 1732;
mul 101 1891; mul 867 1892; add 1890 1893; mul 142 1732; mul 101 1895; mul 101 1896; add 1894 1897; mul 138 1732;
mul 34 1899; mul 101 1900; add 1898 1901; mul 134 1732; mul 101 1903; add 1902 1904; mul 130 1732; mul 34 1906; mul
34 1907; add 1905 1908; mul 126 1732; mul 34 1910; add 1909 1911; mul 123 1732; add 1912 1913; mul 147 1627; mul 135
1637; add 1915 1916; mul 94 1638; add 1917 1918; mul 94 1642; add 1919 1920; mul 94 1645; add 1921 1922; mul 1207
1626; mul 112 1924; add 1923 1925; mul 101 1924; mul 1211 1927; add 1926 1928; mul 173 1626; mul 34 1930; mul 1211
1931; add 1929 1932; mul 1219 1626; mul 1211 1934; add 1933 1935; mul 1223 1626; mul 34 1937; mul 34 1938; add 1936
1939; mul 1228 1626; mul 34 1941; add 1940 1942; mul 156 1626; add 1943 1944; mul 147 1653; add 1945 1946; mul 94
1662; add 1947 1948; mul 366 1652; mul 112 1950; add 1949 1951; mul 101 1950; mul 1211 1953; add 1952 1954; mul 320
1652; mul 34 1956; mul 1211 1957; add 1955 1958; mul 361 1652; mul 34 1960; mul 34 1961; add 1959 1962; mul 341
1649; add 1963 1964; mul 147 1680; add 1965 1966; mul 135 1688; add 1967 1968; mul 94 1689; add 1969 1970; mul 326
1673; mul 112 1972; add 1971 1973; mul 101 1972; mul 1211 1975; add 1974 1976; mul 323 1673; mul 34 1978; mul 1211
1979; add 1977 1980; mul 320 1673; mul 34 1982; mul 34 1983; add 1981 1984; mul 147 1706; add 1985 1986; mul 135
1710; add 1987 1988; mul 94 1711; add 1989 1990; mul 94 1715; add 1991 1992; mul 300 1699; mul 112 1994; add 1993
1995; mul 101 1994; mul 1211 1997; add 1996 1998; mul 298 1699; mul 34 2000; mul 34 2001; add 1999 2002; mul 147
1854; add 2003 2004; mul 135 1865; add 2005 2006; mul 94 1866; add 2007 2008; mul 94 1870; add 2009 2010; mul 94
1873; add 2011 2012; mul 182 1847; mul 112 2014; add 2013 2015; mul 101 2014; mul 1211 2017; add 2016 2018; mul 179
1847; mul 34 2020; mul 1211 2021; add 2019 2022; mul 176 1847; mul 1211 2024; add 2023 2025; mul 173 1847; mul 34
2027; mul 34 2028; add 2026 2029; mul 170 1847; mul 34 2031; add 2030 2032; mul 167 1847; add 2033 2034; mul 147
1891; add 2035 2036; mul 135 1895; add 2037 2038; mul 94 1896; add 2039 2040; mul 94 1900; add 2041 2042; mul 94
1903; add 2043 2044; mul 119 1732; mul 112 2046; add 2045 2047; mul 101 2046; mul 1211 2049; add 2048 2050; mul 115
1732; mul 34 2052; mul 1211 2053; add 2051 2054; mul 111 1732; mul 1211 2056; add 2055 2057; mul 107 1732; mul 34
2059; mul 34 2060; add 2058 2061; mul 103 1732; mul 34 2063; add 2062 2064; mul 92 1732; add 2065 2066; mul 93 2067;
add 1914 2068; mul 866 2069; sub 1625 2070; mul 617 1379; mul 617 1361; add 1410 2073; mul 1375 2074; mul 473 2075;
add 2072 2076; mul 617 1363; mul 1389 2078; mul 1364 2074; mul 617 1397; add 2080 2081; sub 2079 2082; mul 28 2083;
sub 2077 2084; mul 1359 2085; sub 2071 2086; mul 615 621; mul 580 1419; mul 582 621; add 2089 2090; mul 44 69; mul
75 75; sub 2092 2093; mul 88 2094; mul 487 2095; mul 481 1419; sub 2096 2097; mul 90 621; mul 345 2099; add 2098
2100; mul 520 2101; sub 2091 2102; mul 573 2103; mul 490 2104; mul 588 2101; sub 2105 2106; mul 519 2107; mul 588
1419; mul 464 2104; add 2109 2110; mul 16 2111; mul 519 2112; mul 576 2113; add 2108 2114; mul 586 2103; mul 572
2116; mul 568 2116; mul 571 2118; add 2117 2119; mul 559 2103; add 2120 2121; mul 563 2122; mul 565 2123; mul 527
2123; mul 453 2125; add 2124 2126; mul 504 2103; mul 539 2128; mul 543 2129; sub 2127 2130; mul 527 2129; mul 541
2132; sub 2131 2133; mul 526 2128; mul 533 2135; mul 529 2135; mul 531 2137; add 2136 2138; mul 673 2139; mul 668
2140; add 2134 2141; mul 567 2122; mul 504 2143; mul 684 2144; mul 517 2144; mul 562 2146; add 2145 2147; mul 517
2146; mul 561 2149; add 2148 2150; mul 503 2107; mul 588 621; mul 473 2104; sub 2153 2154; mul 510 2155; add 2152
2156; mul 578 2112; add 2157 2158; mul 504 2159; mul 535 2128; mul 521 2161; mul 523 2162; sub 2160 2163; mul 518
2162; neg 2165; mul 233 2166; add 2164 2167; mul 694 2168; mul 518 2169; add 2151 2170; mul 683 2171; sub 2142 2172;
mul 233 2162; add 2173 2174; mul 504 2175; mul 644 2176; mul 642 2177; add 2115 2178; sub 2088 2179; mul 591 2095;
mul 520 2104; mul 471 1419; mul 474 621; add 2183 2184; mul 404 2101; sub 2185 2186; mul 463 2187; mul 404 2188; add
2182 2189; mul 488 2190; add 2181 2191; mul 485 2192; add 2180 2193; mul 464 2190; sub 2195 1516; mul 479 2196; add
2194 2197; mul 96 1419; mul 99 2095; sub 2199 2200; mul 93 2099; sub 2201 2202; mul 594 2203; mul 597 2204; mul 607
2204; mul 594 2099; mul 597 2207; sub 2206 2208; mul 93 2209; add 2205 2210; mul 595 2207; sub 2211 2212; mul 345
2190; add 2213 2214; mul 743 2215; sub 2198 2216; mul 591 2099; mul 477 2190; add 2218 2219; mul 343 2220; add 2217
2221; mul 66 2220; add 2222 2223; mul 490 2188; mul 494 2101; sub 2225 2226; mul 403 2227; mul 494 1419; mul 464
2188; add 2229 2230; mul 16 2231; mul 403 2232; mul 467 2233; sub 2228 2234; mul 492 2187; mul 462 2236; mul 458
2236; mul 461 2238; add 2237 2239; mul 446 2187; add 2240 2241; mul 451 2242; mul 455 2243; mul 414 2243; mul 453
2245; add 2244 2246; mul 388 2187; mul 426 2248; mul 430 2249; sub 2247 2250; mul 414 2249; mul 428 2252; sub 2251
2253; mul 410 2248; mul 420 2255; mul 416 2255; mul 418 2257; add 2256 2258; mul 812 2259; mul 807 2260; add 2254
2261; mul 457 2242; mul 388 2263; mul 823 2264; mul 401 2264; mul 450 2266; add 2265 2267; mul 401 2266; mul 449
2269; add 2268 2270; mul 387 2227; mul 494 621; mul 473 2188; sub 2273 2274; mul 394 2275; add 2272 2276; mul 469
2232; add 2277 2278; mul 388 2279; mul 422 2248; mul 405 2281; mul 407 2282; sub 2280 2283; mul 402 2282; neg 2285;
mul 233 2286; add 2284 2287; mul 833 2288; mul 402 2289; add 2271 2290; mul 822 2291; sub 2262 2292; mul 233 2282;
add 2293 2294; mul 388 2295; mul 783 2296; mul 781 2297; add 2235 2298; add 2179 2299; mul 378 2300; add 2224 2301;
sub 2302 2299; mul 296 2192; mul 296 2300; mul 355 2305; mul 34 2306; add 2304 2307; mul 334 2308; mul 101 2309; mul
867 2310; mul 91 2095; mul 203 2312; mul 101 2313; mul 867 2314; mul 130 2312; mul 34 2316; mul 867 2317; add 2315
2318; mul 884 2312; mul 867 2320; add 2319 2321; mul 115 2312; mul 101 2323; mul 101 2324; add 2322 2325; mul 892
2312; mul 34 2327; mul 101 2328; add 2326 2329; mul 103 2312; mul 101 2331; add 2330 2332; sub 2311 2333; mul 303
2308; mul 34 2335; mul 867 2336; add 2334 2337; mul 369 2308; mul 34 2339; mul 101 2340; add 2338 2341; mul 99 2304;
mul 296 2196; mul 96 2344; add 2343 2345; mul 296 2220; mul 93 2347; add 2346 2348; mul 101 2306; add 2349 2350; mul
339 2351; mul 147 2352; add 2342 2353; mul 94 2352; mul 867 2355; add 2354 2356; mul 309 2351; mul 101 2358; mul 867
2359; add 2357 2360; mul 334 2351; mul 34 2362; mul 867 2363; add 2361 2364; mul 331 2351; mul 101 2366; mul 101
2367; add 2365 2368; mul 298 2351; mul 34 2370; mul 34 2371; add 2369 2372; mul 317 2306; add 2373 2374; mul 94
2306; add 2347 2376; mul 315 2377; mul 147 2378; add 2375 2379; mul 94 2378; mul 867 2381; add 2380 2382; mul 312
2377; mul 101 2384; mul 867 2385; add 2383 2386; mul 309 2377; mul 101 2388; mul 101 2389; add 2387 2390; mul 306
2377; mul 34 2392; mul 101 2393; add 2391 2394; mul 303 2377; mul 34 2396; mul 34 2397; add 2395 2398; mul 980 2312;
mul 978 2400; mul 983 2312; add 2401 2402; neg 2403; where 977 2404; mul 990 1626; where 989 2406; add 2405 2407;
mul 91 2099; mul 254 2409; neg 2410; where 217 2411; add 2408 2412; mul 222 2413; mul 252 2312; mul 1001 2415; neg
2416; where 977 2417; where 989 1764; add 2418 2419; mul 248 2400; mul 1011 2312; add 2421 2422; neg 2423; where 977
2424; mul 285 1626; where 989 2426; add 2425 2427; mul 273 2409; neg 2429; where 217 2430; add 2428 2431; mul 236
2432; add 2420 2433; mul 252 2409; mul 232 2435; neg 2436; where 217 2437; add 2434 2438; mul 236 2439; add 2414
2440; mul 244 2415; neg 2442; where 977 2443; mul 1035 1737; where 989 2445; add 2444 2446; mul 244 2400; mul 1040
2312; add 2448 2449; neg 2450; where 977 2451; mul 1045 1626; where 989 2453; add 2452 2454; mul 269 2409; neg 2456;
where 217 2457; add 2455 2458; mul 236 2459; add 2447 2460; mul 240 2400; mul 281 2312; add 2462 2463; neg 2464;
where 977 2465; mul 1060 1626; where 989 2467; add 2466 2468; mul 265 2409; neg 2470; where 217 2471; add 2469 2472;
mul 228 2473; add 2461 2474; mul 224 2435; neg 2476; where 217 2477; add 2475 2478; mul 228 2479; add 2441 2480; mul
1077 2415; neg 2482; where 977 2483; mul 1081 1737; where 989 2485; add 2484 2486; mul 1077 2400; mul 273 2312; add
2488 2489; neg 2490; where 977 2491; where 989 1821; add 2492 2493; mul 261 2409; neg 2495; where 217 2496; add 2494
2497; mul 236 2498; add 2487 2499; mul 1081 2400; mul 1090 2312; add 2501 2502; neg 2503; where 977 2504; mul 265
1626; where 989 2506; add 2505 2507; mul 257 2409; neg 2509; where 217 2510; add 2508 2511; mul 228 2512; add 2500
2513; mul 221 2413; add 2514 2515; mul 218 2435; neg 2517; where 217 2518; add 2516 2519; mul 1076 2520; add 2481
2521; mul 975 2522; mul 970 2523; add 2399 2524; mul 96 1626; mul 99 2312; sub 2526 2527; mul 93 2409; sub 2528
2529; mul 209 2530; mul 147 2531; add 2525 2532; mul 94 2531; mul 867 2534; add 2533 2535; mul 142 2530; mul 101
2537; mul 867 2538; add 2536 2539; mul 203 2530; mul 34 2541; mul 867 2542; add 2540 2543; mul 200 2530; mul 867
2545; add 2544 2546; mul 197 2530; mul 101 2548; mul 101 2549; add 2547 2550; mul 194 2530; mul 34 2552; mul 101
2553; add 2551 2554; mul 191 2530; mul 101 2556; add 2555 2557; mul 107 2530; mul 34 2559; mul 34 2560; add 2558
2561; mul 103 2530; mul 34 2563; add 2562 2564; mul 92 2530; add 2565 2566; mul 151 2409; mul 147 2568; sub 2567
2569; mul 94 2568; mul 867 2571; sub 2570 2572; mul 146 2409; mul 101 2574; mul 867 2575; sub 2573 2576; mul 142
2409; mul 101 2578; mul 101 2579; sub 2577 2580; mul 138 2409; mul 34 2582; mul 101 2583; sub 2581 2584; mul 134
2409; mul 101 2586; sub 2585 2587; mul 130 2409; mul 34 2589; mul 34 2590; sub 2588 2591; mul 126 2409; mul 34 2593;
sub 2592 2594; mul 123 2409; sub 2595 2596; mul 147 2309; mul 147 2313; mul 135 2323; add 2599 2600; mul 94 2324;
add 2601 2602; mul 94 2328; add 2603 2604; mul 94 2331; add 2605 2606; mul 1207 2312; mul 112 2608; add 2607 2609;
mul 101 2608; mul 1211 2611; add 2610 2612; mul 173 2312; mul 34 2614; mul 1211 2615; add 2613 2616; mul 1219 2312;
mul 1211 2618; add 2617 2619; mul 1223 2312; mul 34 2621; mul 34 2622; add 2620 2623; mul 1228 2312; mul 34 2625;
add 2624 2626; mul 156 2312; add 2627 2628; sub 2598 2629; mul 94 2340; add 2630 2631; mul 366 2308; mul 112 2633;
add 2632 2634; mul 101 2633; mul 1211 2636; add 2635 2637; mul 320 2308; mul 34 2639; mul 1211 2640; add 2638 2641;
mul 361 2308; mul 34 2643; mul 34 2644; add 2642 2645; mul 341 2306; add 2646 2647; mul 147 2358; add 2648 2649; mul
135 2366; add 2650 2651; mul 94 2367; add 2652 2653; mul 326 2351; mul 112 2655; add 2654 2656; mul 101 2655; mul
1211 2658; add 2657 2659; mul 323 2351; mul 34 2661; mul 1211 2662; add 2660 2663; mul 320 2351; mul 34 2665; mul 34
2666; add 2664 2667; mul 147 2384; add 2668 2669; mul 135 2388; add 2670 2671; mul 94 2389; add 2672 2673; mul 94
2393; add 2674 2675; mul 300 2377; mul 112 2677; add 2676 2678; mul 101 2677; mul 1211 2680; add 2679 2681; mul 298
2377; mul 34 2683; mul 34 2684; add 2682 2685; mul 147 2537; add 2686 2687; mul 135 2548; add 2688 2689; mul 94
2549; add 2690 2691; mul 94 2553; add 2692 2693; mul 94 2556; add 2694 2695; mul 182 2530; mul 112 2697; add 2696
2698; mul 101 2697; mul 1211 2700; add 2699 2701; mul 179 2530; mul 34 2703; mul 1211 2704; add 2702 2705; mul 176
2530; mul 1211 2707; add 2706 2708; mul 173 2530; mul 34 2710; mul 34 2711; add 2709 2712; mul 170 2530; mul 34
2714; add 2713 2715; mul 167 2530; add 2716 2717; mul 147 2574; sub 2718 2719; mul 135 2578; sub 2720 2721; mul 94
2579; sub 2722 2723; mul 94 2583; sub 2724 2725; mul 94 2586; sub 2726 2727; mul 119 2409; mul 112 2729; sub 2728
2730; mul 101 2729; mul 1211 2732; sub 2731 2733; mul 115 2409; mul 34 2735; mul 1211 2736; sub 2734 2737; mul 111
2409; mul 1211 2739; sub 2738 2740; mul 107 2409; mul 34 2742; mul 34 2743; sub 2741 2744; mul 103 2409; mul 34
2746; sub 2745 2747; mul 92 2409; sub 2748 2749; mul 93 2750; add 2597 2751; mul 866 2752; sub 2303 2753; mul 621
1379; mul 621 1361; add 1419 2756; mul 1375 2757; mul 473 2758; add 2755 2759; mul 1364 2757; mul 621 1397; add 2761
2762; mul 621 1363; mul 1389 2764; sub 2763 2765; mul 28 2766; add 2760 2767; mul 1359 2768; add 2754 2769; mul 404
458; mul 488 2771; mul 485 2772; mul 464 2771; mul 479 2774; add 2773 2775; mul 345 2771; mul 743 2777; sub 2776
2778; mul 477 2771; mul 343 2780; add 2779 2781; mul 66 2780; add 2782 2783; mul 458 490; mul 403 2785; mul 458 464;
mul 16 2787; mul 403 2788; mul 467 2789; sub 2786 2790; mul 451 492; mul 455 2792; mul 414 2792; mul 453 2794; add
2793 2795; mul 457 492; mul 388 2797; mul 823 2798; mul 401 2798; mul 450 2800; add 2799 2801; mul 401 2800; mul 449
2803; add 2802 2804; mul 387 2785; mul 458 473; mul 394 2807; sub 2806 2808; mul 469 2788; add 2809 2810; mul 388
2811; mul 833 2812; mul 402 2813; add 2805 2814; mul 822 2815; sub 2796 2816; mul 388 2817; mul 783 2818; mul 781
2819; add 2791 2820; mul 378 2821; add 2784 2822; sub 2823 2821; mul 296 2772; mul 296 2821; mul 355 2826; mul 34
2827; add 2825 2828; mul 334 2829; mul 101 2830; mul 867 2831; mul 303 2829; mul 34 2833; mul 867 2834; add 2832
2835; mul 369 2829; mul 34 2837; mul 101 2838; add 2836 2839; mul 99 2825; mul 296 2774; mul 96 2842; add 2841 2843;
mul 296 2780; mul 93 2845; add 2844 2846; mul 101 2827; add 2847 2848; mul 339 2849; mul 147 2850; add 2840 2851;
mul 94 2850; mul 867 2853; add 2852 2854; mul 309 2849; mul 101 2856; mul 867 2857; add 2855 2858; mul 334 2849; mul
34 2860; mul 867 2861; add 2859 2862; mul 331 2849; mul 101 2864; mul 101 2865; add 2863 2866; mul 298 2849; mul 34
2868; mul 34 2869; add 2867 2870; mul 317 2827; add 2871 2872; mul 94 2827; add 2845 2874; mul 315 2875; mul 147
2876; add 2873 2877; mul 94 2876; mul 867 2879; add 2878 2880; mul 312 2875; mul 101 2882; mul 867 2883; add 2881
2884; mul 309 2875; mul 101 2886; mul 101 2887; add 2885 2888; mul 306 2875; mul 34 2890; mul 101 2891; add 2889
2892; mul 303 2875; mul 34 2894; mul 34 2895; add 2893 2896; mul 147 2830; mul 94 2838; add 2898 2899; mul 366 2829;
mul 112 2901; add 2900 2902; mul 101 2901; mul 1211 2904; add 2903 2905; mul 320 2829; mul 34 2907; mul 1211 2908;
add 2906 2909; mul 361 2829; mul 34 2911; mul 34 2912; add 2910 2913; mul 341 2827; add 2914 2915; mul 147 2856; add
2916 2917; mul 135 2864; add 2918 2919; mul 94 2865; add 2920 2921; mul 326 2849; mul 112 2923; add 2922 2924; mul
101 2923; mul 1211 2926; add 2925 2927; mul 323 2849; mul 34 2929; mul 1211 2930; add 2928 2931; mul 320 2849; mul
34 2933; mul 34 2934; add 2932 2935; mul 147 2882; add 2936 2937; mul 135 2886; add 2938 2939; mul 94 2887; add 2940
2941; mul 94 2891; add 2942 2943; mul 300 2875; mul 112 2945; add 2944 2946; mul 101 2945; mul 1211 2948; add 2947
2949; mul 298 2875; mul 34 2951; mul 34 2952; add 2950 2953; mul 93 2954; add 2897 2955; mul 866 2956; sub 2824
2957; mul 520 568; mul 488 2959; mul 485 2960; mul 490 568; mul 519 2962; mul 464 568; mul 16 2964; mul 519 2965;
mul 576 2966; add 2963 2967; mul 563 586; mul 565 2969; mul 527 2969; mul 453 2971; add 2970 2972; mul 567 586; mul
504 2974; mul 684 2975; mul 517 2975; mul 562 2977; add 2976 2978; mul 517 2977; mul 561 2980; add 2979 2981; mul
503 2962; mul 473 568; mul 510 2984; sub 2983 2985; mul 578 2965; add 2986 2987; mul 504 2988; mul 694 2989; mul 518
2990; add 2982 2991; mul 683 2992; sub 2973 2993; mul 504 2994; mul 644 2995; mul 642 2996; add 2968 2997; sub 2961
2998; mul 464 2959; mul 479 3000; add 2999 3001; mul 345 2959; mul 743 3003; sub 3002 3004; mul 477 2959; mul 343
3006; add 3005 3007; mul 66 3006; add 3008 3009; mul 378 2998; add 3010 3011; mul 296 2960; mul 296 2998; mul 355
3014; mul 34 3015; add 3013 3016; mul 334 3017; mul 101 3018; mul 867 3019; mul 303 3017; mul 34 3021; mul 867 3022;
add 3020 3023; mul 369 3017; mul 34 3025; mul 101 3026; add 3024 3027; mul 99 3013; mul 296 3000; mul 96 3030; add
3029 3031; mul 296 3006; mul 93 3033; add 3032 3034; mul 101 3015; add 3035 3036; mul 339 3037; mul 147 3038; add
3028 3039; mul 94 3038; mul 867 3041; add 3040 3042; mul 309 3037; mul 101 3044; mul 867 3045; add 3043 3046; mul
334 3037; mul 34 3048; mul 867 3049; add 3047 3050; mul 331 3037; mul 101 3052; mul 101 3053; add 3051 3054; mul 298
3037; mul 34 3056; mul 34 3057; add 3055 3058; mul 317 3015; add 3059 3060; mul 94 3015; add 3033 3062; mul 315
3063; mul 147 3064; add 3061 3065; mul 94 3064; mul 867 3067; add 3066 3068; mul 312 3063; mul 101 3070; mul 867
3071; add 3069 3072; mul 309 3063; mul 101 3074; mul 101 3075; add 3073 3076; mul 306 3063; mul 34 3078; mul 101
3079; add 3077 3080; mul 303 3063; mul 34 3082; mul 34 3083; add 3081 3084; mul 147 3018; mul 94 3026; add 3086
3087; mul 366 3017; mul 112 3089; add 3088 3090; mul 101 3089; mul 1211 3092; add 3091 3093; mul 320 3017; mul 34
3095; mul 1211 3096; add 3094 3097; mul 361 3017; mul 34 3099; mul 34 3100; add 3098 3101; mul 341 3015; add 3102
3103; mul 147 3044; add 3104 3105; mul 135 3052; add 3106 3107; mul 94 3053; add 3108 3109; mul 326 3037; mul 112
3111; add 3110 3112; mul 101 3111; mul 1211 3114; add 3113 3115; mul 323 3037; mul 34 3117; mul 1211 3118; add 3116
3119; mul 320 3037; mul 34 3121; mul 34 3122; add 3120 3123; mul 147 3070; add 3124 3125; mul 135 3074; add 3126
3127; mul 94 3075; add 3128 3129; mul 94 3079; add 3130 3131; mul 300 3063; mul 112 3133; add 3132 3134; mul 101
3133; mul 1211 3136; add 3135 3137; mul 298 3063; mul 34 3139; mul 34 3140; add 3138 3141; mul 93 3142; add 3085
3143; mul 866 3144; sub 3012 3145; mul 222 1077; mul 229 244; add 3147 3148; mul 237 1001; add 3149 3150; input p
158; mul 241 3152; add 3151 3153; input p 159; mul 245 3155; add 3154 3156; input p 160; mul 249 3158; add 3157
3159; mul 252 3160; mul 255 983; mul 258 1090; add 3162 3163; mul 262 273; add 3164 3165; mul 266 281; add 3166
3167; mul 270 1040; add 3168 3169; mul 274 1011; add 3170 3171; input p 164; mul 278 3173; add 3172 3174; input p
143; mul 282 3176; add 3175 3177; input p 165; mul 286 3179; add 3178 3180; input p 166; mul 252 3182; add 3181
3183; add 3161 3184; mul 255 978; mul 258 1081; add 3186 3187; mul 262 1077; add 3188 3189; mul 240 266; add 3190
3191; mul 244 270; add 3192 3193; mul 248 274; add 3194 3195; input p 168; mul 278 3197; add 3196 3198; mul 282
3152; add 3199 3200; input p 136; mul 286 3202; add 3201 3203; input p 169; mul 252 3205; add 3204 3206; mul 980
3207; add 3185 3208; mul 621 3209; neg 3210; where 977 3211; input p 147; mul 34 3213; input p 148; mul 160 3215;
add 3214 3216; input p 149; mul 164 3218; add 3217 3219; mul 101 156; add 3220 3221; mul 104 1228; add 3222 3223;
mul 108 1223; add 3224 3225; mul 112 1219; add 3226 3227; mul 116 173; add 3228 3229; mul 120 1207; add 3230 3231;
mul 103 135; add 3232 3233; mul 139 892; add 3234 3235; mul 115 143; add 3236 3237; mul 147 884; add 3238 3239; mul
130 204; add 3240 3241; mul 148 203; add 3242 3243; mul 99 211; add 3244 3245; mul 621 3246; sub 3212 3247; mul 222
1081; mul 229 1035; add 3249 3250; mul 237 244; add 3251 3252; input p 134; mul 241 3254; add 3253 3255; input p
135; mul 245 3257; add 3256 3258; mul 249 3202; add 3259 3260; mul 252 3261; mul 255 990; mul 258 265; add 3263
3264; mul 262 1090; add 3265 3266; mul 266 1060; add 3267 3268; mul 270 1045; add 3269 3270; mul 274 285; add 3271
3272; input p 141; mul 278 3274; add 3273 3275; input p 142; mul 282 3277; add 3276 3278; mul 286 3176; add 3279
3280; input p 144; mul 252 3282; add 3281 3283; add 3262 3284; mul 617 3285; where 989 3286; add 3248 3287; mul 96
211; mul 617 3289; add 3288 3290; mul 292 625; neg 3292; where 217 3293; add 3291 3294; mul 213 625; sub 3295 3296;
mul 1419 3209; where 977 3298; mul 1419 3246; add 3299 3300; mul 1410 3285; neg 3302; where 989 3303; add 3301 3304;
mul 1410 3289; sub 3305 3306; mul 292 1422; where 217 3308; add 3307 3309; mul 213 1422; add 3310 3311; mul 2095
3209; neg 3313; where 977 3314; mul 2095 3246; sub 3315 3316; mul 1419 3285; where 989 3318; add 3317 3319; mul 1419
3289; add 3320 3321; mul 292 2099; neg 3323; where 217 3324; add 3322 3325; mul 213 2099; sub 3326 3327; mul 609
748; constant 0.8; mul 488 621; mul 3330 3331; sub 3329 3332; mul 604 625; sub 3333 3334; mul 1377 1382; le 1373
1374; le 1374 1373; add 3337 3338; div 1 3339; mul 3337 3340; mul 3336 3341; mul 234 3342; add 3335 3343; mul 488
1419; mul 3330 3345; mul 609 1526; add 3346 3347; mul 604 1422; add 3348 3349; mul 1377 2074; mul 3341 3351; mul 234
3352; sub 3350 3353; mul 609 2203; mul 488 2095; mul 3330 3356; sub 3355 3357; mul 604 2099; sub 3358 3359; mul 1377
2757; mul 3341 3361; mul 234 3362; add 3360 3363; constant -2.5714285714285743; mul 152 1129; mul 3365 3366;
constant -0.8571428571428583; mul 148 876; mul 3368 3369; constant 0.9142857142857138; mul 204 876; mul 3371 3372;
add 3370 3373; constant 0.05714285714285722; mul 143 876; mul 3375 3376; add 3374 3377; constant
-0.11428571428571327; mul 139 876; mul 3379 3380; add 3378 3381; constant 0.2190476190476189; mul 120 876; mul 3383
3384; add 3382 3385; constant 0.11428571428571413; mul 116 876; mul 3387 3388; add 3386 3389; constant
-0.05714285714285729; mul 108 876; mul 3391 3392; add 3390 3393; input p 219; constant -0.033333333333333326; mul
101 876; mul 3396 3397; mul 3395 3398; add 3394 3399; constant 0.007256235827664418; mul 164 876; mul 3401 3402; add
3400 3403; constant 0.01904761904761903; mul 34 876; mul 3405 3406; mul 3395 3407; add 3404 3408; sub 3367 3409;
constant 2.057142857142858; mul 148 1129; mul 3411 3412; add 3410 3413; mul 204 1129; mul 3368 3415; add 3414 3416;
constant -3.428571428571427; mul 143 1129; mul 3418 3419; add 3417 3420; constant 0.11428571428571443; mul 139 1129;
mul 3422 3423; add 3421 3424; constant -0.057142857142856635; mul 131 1129; mul 3426 3427; add 3425 3428; constant
-0.09999999999999995; mul 94 1129; mul 3430 3431; mul 3395 3432; add 3429 3433; constant 2.438095238095238; mul 120
1129; mul 3435 3436; add 3434 3437; constant 0.6571428571428567; mul 116 1129; mul 3439 3440; add 3438 3441; input p
220; mul 112 1129; mul 3443 3444; sub 3442 3445; mul 108 1129; mul 3387 3447; add 3446 3448; constant
0.13333333333333333; mul 101 1129; mul 3450 3451; mul 3395 3452; add 3449 3453; constant -0.019047619047619094; mul
164 1129; mul 3455 3456; add 3454 3457; mul 34 1129; mul 3396 3459; mul 3395 3460; add 3458 3461; constant
12.34285714285715; mul 152 995; mul 3463 3464; sub 3462 3465; constant -7.714285714285722; mul 148 995; mul 3467
3468; sub 3466 3469; mul 143 995; mul 3411 3471; sub 3470 3472; constant -1.7142857142857166; mul 139 995; mul 3474
3475; sub 3473 3476; mul 131 995; mul 3371 3478; sub 3477 3479; constant 1.2; mul 94 995; mul 3481 3482; mul 3395
3483; sub 3480 3484; constant -1.1428571428571423; mul 120 995; mul 3486 3487; sub 3485 3488; mul 116 995; mul 3375
3490; sub 3489 3491; mul 108 995; mul 3426 3493; sub 3492 3494; mul 101 995; mul 3430 3496; mul 3395 3497; sub 3495
3498; mul 148 1626; mul 3368 3500; mul 204 1626; mul 3371 3502; add 3501 3503; mul 143 1626; mul 3375 3505; add 3504
3506; mul 139 1626; mul 3379 3508; add 3507 3509; mul 120 1626; mul 3383 3511; add 3510 3512; mul 116 1626; mul 3387
3514; add 3513 3515; mul 108 1626; mul 3391 3517; add 3516 3518; mul 101 1626; mul 3396 3520; mul 3395 3521; add
3519 3522; mul 164 1626; mul 3401 3524; add 3523 3525; mul 34 1626; mul 3405 3527; mul 3395 3528; add 3526 3529; mul
152 1847; mul 3365 3531; add 3530 3532; mul 148 1847; mul 3411 3534; add 3533 3535; mul 204 1847; mul 3368 3537; add
3536 3538; mul 143 1847; mul 3418 3540; add 3539 3541; mul 139 1847; mul 3422 3543; add 3542 3544; mul 131 1847; mul
3426 3546; add 3545 3547; mul 94 1847; mul 3430 3549; mul 3395 3550; add 3548 3551; mul 120 1847; mul 3435 3553; add
3552 3554; mul 116 1847; mul 3439 3556; add 3555 3557; mul 112 1847; mul 3443 3559; sub 3558 3560; mul 108 1847; mul
3387 3562; add 3561 3563; mul 101 1847; mul 3450 3565; mul 3395 3566; add 3564 3567; mul 164 1847; mul 3455 3569;
add 3568 3570; mul 34 1847; mul 3396 3572; mul 3395 3573; add 3571 3574; mul 152 1732; mul 3463 3576; add 3575 3577;
mul 148 1732; mul 3467 3579; add 3578 3580; mul 143 1732; mul 3411 3582; add 3581 3583; mul 139 1732; mul 3474 3585;
add 3584 3586; mul 131 1732; mul 3371 3588; add 3587 3589; mul 94 1732; mul 3481 3591; mul 3395 3592; add 3590 3593;
mul 120 1732; mul 3486 3595; add 3594 3596; mul 116 1732; mul 3375 3598; add 3597 3599; mul 108 1732; mul 3426 3601;
add 3600 3602; mul 101 1732; mul 3430 3604; mul 3395 3605; add 3603 3606; mul 152 2530; mul 3365 3608; mul 148 2312;
mul 3368 3610; mul 204 2312; mul 3371 3612; add 3611 3613; mul 143 2312; mul 3375 3615; add 3614 3616; mul 139 2312;
mul 3379 3618; add 3617 3619; mul 120 2312; mul 3383 3621; add 3620 3622; mul 116 2312; mul 3387 3624; add 3623
3625; mul 108 2312; mul 3391 3627; add 3626 3628; mul 101 2312; mul 3396 3630; mul 3395 3631; add 3629 3632; mul 164
2312; mul 3401 3634; add 3633 3635; mul 34 2312; mul 3405 3637; mul 3395 3638; add 3636 3639; sub 3609 3640; mul 148
2530; mul 3411 3642; add 3641 3643; mul 204 2530; mul 3368 3645; add 3644 3646; mul 143 2530; mul 3418 3648; add
3647 3649; mul 139 2530; mul 3422 3651; add 3650 3652; mul 131 2530; mul 3426 3654; add 3653 3655; mul 94 2530; mul
3430 3657; mul 3395 3658; add 3656 3659; mul 120 2530; mul 3435 3661; add 3660 3662; mul 116 2530; mul 3439 3664;
add 3663 3665; mul 112 2530; mul 3443 3667; sub 3666 3668; mul 108 2530; mul 3387 3670; add 3669 3671; mul 101 2530;
mul 3450 3673; mul 3395 3674; add 3672 3675; mul 164 2530; mul 3455 3677; add 3676 3678; mul 34 2530; mul 3396 3680;
mul 3395 3681; add 3679 3682; mul 152 2409; mul 3463 3684; sub 3683 3685; mul 148 2409; mul 3467 3687; sub 3686
3688; mul 143 2409; mul 3411 3690; sub 3689 3691; mul 139 2409; mul 3474 3693; sub 3692 3694; mul 131 2409; mul 3371
3696; sub 3695 3697; mul 94 2409; mul 3481 3699; mul 3395 3700; sub 3698 3701; mul 120 2409; mul 3486 3703; sub 3702
3704; mul 116 2409; mul 3375 3706; sub 3705 3707; mul 108 2409; mul 3426 3709; sub 3708 3710; mul 101 2409; mul 3430
3712; mul 3395 3713; sub 3711 3714; constant -129.60000000000008; mul 3366 3716; constant 28.799999999999958; mul
3369 3718; constant 45.25714285714287; mul 3372 3720; add 3719 3721; constant -28.800000000000004; mul 147 876; mul
3723 3724; mul 3443 3725; add 3722 3726; constant -28.799999999999976; mul 3376 3728; add 3727 3729; constant
-45.25714285714286; mul 3380 3731; add 3730 3732; constant 28.79999999999999; mul 135 876; mul 3734 3735; mul 3443
3736; add 3733 3737; constant 7.199999999999994; mul 3384 3739; add 3738 3740; constant 13.714285714285717; mul 3388
3742; add 3741 3743; constant -7.199999999999996; mul 112 876; mul 3745 3746; mul 3443 3747; add 3744 3748; constant
1.3714285714285692; mul 3392 3750; add 3749 3751; constant -4.799999999999999; mul 104 876; mul 3753 3754; mul 3443
3755; add 3752 3756; constant 1.3714285714285714; mul 3402 3758; add 3757 3759; constant -1.3714285714285723; mul
160 876; mul 3761 3762; mul 3443 3763; add 3760 3764; constant 2.400000000000001; mul 3406 3766; mul 3395 3767; add
3765 3768; sub 3717 3769; constant 230.40000000000006; mul 3412 3771; add 3770 3772; mul 3415 3718; add 3773 3774;
constant -36.00000000000001; mul 147 1129; mul 3776 3777; mul 3443 3778; add 3775 3779; constant
-151.20000000000002; mul 3419 3781; add 3780 3782; constant -57.59999999999995; mul 3423 3784; add 3783 3785;
constant 72.0; mul 135 1129; mul 3787 3788; mul 3443 3789; add 3786 3790; constant -22.62857142857143; mul 3427
3792; add 3791 3793; mul 127 1129; mul 3734 3795; mul 3443 3796; add 3794 3797; constant -18.000000000000004; mul
3431 3799; mul 3395 3800; add 3798 3801; constant 35.20000000000001; mul 3436 3803; add 3802 3804; constant
21.59999999999998; mul 3440 3806; add 3805 3807; constant -30.000000000000007; mul 3444 3809; mul 3443 3810; add
3808 3811; mul 3447 3742; add 3812 3813; constant -14.399999999999991; mul 104 1129; mul 3815 3816; mul 3443 3817;
add 3814 3818; mul 595 3451; mul 3395 3820; add 3819 3821; constant 0.4571428571428564; mul 3456 3823; add 3822
3824; constant -2.3999999999999995; mul 160 1129; mul 3826 3827; mul 3443 3828; add 3825 3829; input p 221; constant
-0.9999999999999998; mul 1129 3832; mul 3831 3833; add 3830 3834; constant 259.2000000000001; mul 3464 3836; sub
3835 3837; constant -388.80000000000024; mul 3468 3839; sub 3838 3840; mul 3471 3771; sub 3841 3842; constant
57.599999999999916; mul 3475 3844; sub 3843 3845; constant -72.00000000000001; mul 135 995; mul 3847 3848; mul 3443
3849; sub 3846 3850; mul 3478 3720; sub 3851 3852; constant -57.60000000000001; mul 127 995; mul 3854 3855; mul 3443
3856; sub 3853 3857; constant 36.000000000000014; mul 3482 3859; mul 3395 3860; sub 3858 3861; constant
-50.400000000000006; mul 3487 3863; sub 3862 3864; mul 3490 3728; sub 3865 3866; constant 36.0; mul 112 995; mul
3868 3869; mul 3443 3870; sub 3867 3871; mul 3493 3792; sub 3872 3873; mul 104 995; mul 3734 3875; mul 3443 3876;
sub 3874 3877; mul 3496 3799; mul 3395 3879; sub 3878 3880; mul 3500 3718; mul 3502 3720; add 3882 3883; mul 147
1626; mul 3723 3885; mul 3443 3886; add 3884 3887; mul 3505 3728; add 3888 3889; mul 3508 3731; add 3890 3891; mul
135 1626; mul 3734 3893; mul 3443 3894; add 3892 3895; mul 3511 3739; add 3896 3897; mul 3514 3742; add 3898 3899;
mul 112 1626; mul 3745 3901; mul 3443 3902; add 3900 3903; mul 3517 3750; add 3904 3905; mul 104 1626; mul 3753
3907; mul 3443 3908; add 3906 3909; mul 3524 3758; add 3910 3911; mul 160 1626; mul 3761 3913; mul 3443 3914; add
3912 3915; mul 3527 3766; mul 3395 3917; add 3916 3918; mul 3531 3716; add 3919 3920; mul 3534 3771; add 3921 3922;
mul 3537 3718; add 3923 3924; mul 147 1847; mul 3776 3926; mul 3443 3927; add 3925 3928; mul 3540 3781; add 3929
3930; mul 3543 3784; add 3931 3932; mul 135 1847; mul 3787 3934; mul 3443 3935; add 3933 3936; mul 3546 3792; add
3937 3938; mul 127 1847; mul 3734 3940; mul 3443 3941; add 3939 3942; mul 3549 3799; mul 3395 3944; add 3943 3945;
mul 3553 3803; add 3946 3947; mul 3556 3806; add 3948 3949; mul 3559 3809; mul 3443 3951; add 3950 3952; mul 3562
3742; add 3953 3954; mul 104 1847; mul 3815 3956; mul 3443 3957; add 3955 3958; mul 595 3565; mul 3395 3960; add
3959 3961; mul 3569 3823; add 3962 3963; mul 160 1847; mul 3826 3965; mul 3443 3966; add 3964 3967; mul 1847 3832;
mul 3831 3969; add 3968 3970; mul 3576 3836; add 3971 3972; mul 3579 3839; add 3973 3974; mul 3582 3771; add 3975
3976; mul 3585 3844; add 3977 3978; mul 135 1732; mul 3847 3980; mul 3443 3981; add 3979 3982; mul 3588 3720; add
3983 3984; mul 127 1732; mul 3854 3986; mul 3443 3987; add 3985 3988; mul 3591 3859; mul 3395 3990; add 3989 3991;
mul 3595 3863; add 3992 3993; mul 3598 3728; add 3994 3995; mul 112 1732; mul 3868 3997; mul 3443 3998; add 3996
3999; mul 3601 3792; add 4000 4001; mul 104 1732; mul 3734 4003; mul 3443 4004; add 4002 4005; mul 3604 3799; mul
3395 4007; add 4006 4008; mul 3608 3716; mul 3610 3718; mul 3612 3720; add 4011 4012; mul 147 2312; mul 3723 4014;
mul 3443 4015; add 4013 4016; mul 3615 3728; add 4017 4018; mul 3618 3731; add 4019 4020; mul 135 2312; mul 3734
4022; mul 3443 4023; add 4021 4024; mul 3621 3739; add 4025 4026; mul 3624 3742; add 4027 4028; mul 112 2312; mul
3745 4030; mul 3443 4031; add 4029 4032; mul 3627 3750; add 4033 4034; mul 104 2312; mul 3753 4036; mul 3443 4037;
add 4035 4038; mul 3634 3758; add 4039 4040; mul 160 2312; mul 3761 4042; mul 3443 4043; add 4041 4044; mul 3637
3766; mul 3395 4046; add 4045 4047; sub 4010 4048; mul 3642 3771; add 4049 4050; mul 3645 3718; add 4051 4052; mul
147 2530; mul 3776 4054; mul 3443 4055; add 4053 4056; mul 3648 3781; add 4057 4058; mul 3651 3784; add 4059 4060;
mul 135 2530; mul 3787 4062; mul 3443 4063; add 4061 4064; mul 3654 3792; add 4065 4066; mul 127 2530; mul 3734
4068; mul 3443 4069; add 4067 4070; mul 3657 3799; mul 3395 4072; add 4071 4073; mul 3661 3803; add 4074 4075; mul
3664 3806; add 4076 4077; mul 3667 3809; mul 3443 4079; add 4078 4080; mul 3670 3742; add 4081 4082; mul 104 2530;
mul 3815 4084; mul 3443 4085; add 4083 4086; mul 595 3673; mul 3395 4088; add 4087 4089; mul 3677 3823; add 4090
4091; mul 160 2530; mul 3826 4093; mul 3443 4094; add 4092 4095; mul 2530 3832; mul 3831 4097; add 4096 4098; mul
3684 3836; sub 4099 4100; mul 3687 3839; sub 4101 4102; mul 3690 3771; sub 4103 4104; mul 3693 3844; sub 4105 4106;
mul 135 2409; mul 3847 4108; mul 3443 4109; sub 4107 4110; mul 3696 3720; sub 4111 4112; mul 127 2409; mul 3854
4114; mul 3443 4115; sub 4113 4116; mul 3699 3859; mul 3395 4118; sub 4117 4119; mul 3703 3863; sub 4120 4121; mul
3706 3728; sub 4122 4123; mul 112 2409; mul 3868 4125; mul 3443 4126; sub 4124 4127; mul 3709 3792; sub 4128 4129;
mul 104 2409; mul 3734 4131; mul 3443 4132; sub 4130 4133; mul 3712 3799; mul 3395 4135; sub 4134 4136; constant
-0.04285714285714284; mul 148 872; mul 4138 4139; constant 0.029931972789115628; mul 204 872; mul 4141 4142; add
4140 4143; constant -0.0013605442176870806; mul 139 872; mul 4145 4146; add 4144 4147; constant
-0.003571428571428574; mul 120 872; mul 4149 4150; add 4148 4151; constant 0.0027210884353741486; mul 116 872; mul
4153 4154; add 4152 4155; constant -0.0014361300075585765; mul 108 872; mul 4157 4158; add 4156 4159; constant
0.00032473894907757275; mul 164 872; mul 4161 4162; add 4160 4163; constant -0.12857142857142845; mul 152 917; mul
4165 4166; add 4164 4167; constant 0.12857142857142853; mul 148 917; mul 4169 4170; add 4168 4171; mul 204 917; mul
4138 4173; add 4172 4174; constant 0.010714285714285735; mul 143 917; mul 4176 4177; add 4175 4178; constant
-0.0006802721088435403; mul 131 917; mul 4180 4181; add 4179 4182; constant 0.028571428571428567; mul 120 917; mul
4184 4185; add 4183 4186; constant -0.010714285714285721; mul 116 917; mul 4188 4189; add 4187 4190; mul 108 917;
mul 4153 4192; add 4191 4193; constant -0.0004787100025195255; mul 164 917; mul 4195 4196; add 4194 4197; constant
1.0285714285714285; mul 152 943; mul 4199 4200; add 4198 4201; constant -0.38571428571428534; mul 148 943; mul 4203
4204; add 4202 4205; mul 143 943; mul 4169 4207; add 4206 4208; constant -0.08571428571428567; mul 139 943; mul 4210
4211; add 4209 4212; mul 131 943; mul 4141 4214; add 4213 4215; constant 0.0035714285714285787; mul 120 943; mul
4217 4218; add 4216 4219; mul 108 943; mul 4180 4221; add 4220 4222; mul 148 1652; mul 4138 4224; mul 204 1652; mul
4141 4226; add 4225 4227; mul 139 1652; mul 4145 4229; add 4228 4230; mul 120 1652; mul 4149 4232; add 4231 4233;
mul 116 1652; mul 4153 4235; add 4234 4236; mul 108 1652; mul 4157 4238; add 4237 4239; mul 164 1652; mul 4161 4241;
add 4240 4242; mul 152 1673; mul 4165 4244; add 4243 4245; mul 148 1673; mul 4169 4247; add 4246 4248; mul 204 1673;
mul 4138 4250; add 4249 4251; mul 143 1673; mul 4176 4253; add 4252 4254; mul 131 1673; mul 4180 4256; add 4255
4257; mul 120 1673; mul 4184 4259; add 4258 4260; mul 116 1673; mul 4188 4262; add 4261 4263; mul 108 1673; mul 4153
4265; add 4264 4266; mul 164 1673; mul 4195 4268; add 4267 4269; mul 152 1699; mul 4199 4271; add 4270 4272; mul 148
1699; mul 4203 4274; add 4273 4275; mul 143 1699; mul 4169 4277; add 4276 4278; mul 139 1699; mul 4210 4280; add
4279 4281; mul 131 1699; mul 4141 4283; add 4282 4284; mul 120 1699; mul 4217 4286; add 4285 4287; mul 108 1699; mul
4180 4289; add 4288 4290; mul 148 2308; mul 4138 4292; mul 204 2308; mul 4141 4294; add 4293 4295; mul 139 2308; mul
4145 4297; add 4296 4298; mul 120 2308; mul 4149 4300; add 4299 4301; mul 116 2308; mul 4153 4303; add 4302 4304;
mul 108 2308; mul 4157 4306; add 4305 4307; mul 164 2308; mul 4161 4309; add 4308 4310; mul 152 2351; mul 4165 4312;
add 4311 4313; mul 148 2351; mul 4169 4315; add 4314 4316; mul 204 2351; mul 4138 4318; add 4317 4319; mul 143 2351;
mul 4176 4321; add 4320 4322; mul 131 2351; mul 4180 4324; add 4323 4325; mul 120 2351; mul 4184 4327; add 4326
4328; mul 116 2351; mul 4188 4330; add 4329 4331; mul 108 2351; mul 4153 4333; add 4332 4334; mul 164 2351; mul 4195
4336; add 4335 4337; mul 152 2377; mul 4199 4339; add 4338 4340; mul 148 2377; mul 4203 4342; add 4341 4343; mul 143
2377; mul 4169 4345; add 4344 4346; mul 139 2377; mul 4210 4348; add 4347 4349; mul 131 2377; mul 4141 4351; add
4350 4352; mul 120 2377; mul 4217 4354; add 4353 4355; mul 108 2377; mul 4180 4357; add 4356 4358; mul 148 2829; mul
4138 4360; mul 204 2829; mul 4141 4362; add 4361 4363; mul 139 2829; mul 4145 4365; add 4364 4366; mul 120 2829; mul
4149 4368; add 4367 4369; mul 116 2829; mul 4153 4371; add 4370 4372; mul 108 2829; mul 4157 4374; add 4373 4375;
mul 164 2829; mul 4161 4377; add 4376 4378; mul 152 2849; mul 4165 4380; add 4379 4381; mul 148 2849; mul 4169 4383;
add 4382 4384; mul 204 2849; mul 4138 4386; add 4385 4387; mul 143 2849; mul 4176 4389; add 4388 4390; mul 131 2849;
mul 4180 4392; add 4391 4393; mul 120 2849; mul 4184 4395; add 4394 4396; mul 116 2849; mul 4188 4398; add 4397
4399; mul 108 2849; mul 4153 4401; add 4400 4402; mul 164 2849; mul 4195 4404; add 4403 4405; mul 152 2875; mul 4199
4407; add 4406 4408; mul 148 2875; mul 4203 4410; add 4409 4411; mul 143 2875; mul 4169 4413; add 4412 4414; mul 139
2875; mul 4210 4416; add 4415 4417; mul 131 2875; mul 4141 4419; add 4418 4420; mul 120 2875; mul 4217 4422; add
4421 4423; mul 108 2875; mul 4180 4425; add 4424 4426; mul 148 3017; mul 4138 4428; mul 204 3017; mul 4141 4430; add
4429 4431; mul 139 3017; mul 4145 4433; add 4432 4434; mul 120 3017; mul 4149 4436; add 4435 4437; mul 116 3017; mul
4153 4439; add 4438 4440; mul 108 3017; mul 4157 4442; add 4441 4443; mul 164 3017; mul 4161 4445; add 4444 4446;
mul 152 3037; mul 4165 4448; add 4447 4449; mul 148 3037; mul 4169 4451; add 4450 4452; mul 204 3037; mul 4138 4454;
add 4453 4455; mul 143 3037; mul 4176 4457; add 4456 4458; mul 131 3037; mul 4180 4460; add 4459 4461; mul 120 3037;
mul 4184 4463; add 4462 4464; mul 116 3037; mul 4188 4466; add 4465 4467; mul 108 3037; mul 4153 4469; add 4468
4470; mul 164 3037; mul 4195 4472; add 4471 4473; mul 152 3063; mul 4199 4475; add 4474 4476; mul 148 3063; mul 4203
4478; add 4477 4479; mul 143 3063; mul 4169 4481; add 4480 4482; mul 139 3063; mul 4210 4484; add 4483 4485; mul 131
3063; mul 4141 4487; add 4486 4488; mul 120 3063; mul 4217 4490; add 4489 4491; mul 108 3063; mul 4180 4493; add
4492 4494; input p 222; mul 3778 4496; mul 3725 4496; mul 3736 4496; add 4498 4499; mul 3747 4496; add 4500 4501;
mul 3755 4496; add 4502 4503; input p 223; input p 224; mul 3398 4506; mul 4505 4507; add 4504 4508; mul 3763 4496;
add 4509 4510; mul 3407 4506; mul 4505 4512; add 4511 4513; mul 3767 4496; mul 4505 4515; add 4514 4516; sub 4497
4517; mul 3789 4496; add 4518 4519; mul 3796 4496; add 4520 4521; mul 3432 4506; mul 4505 4523; add 4522 4524; mul
3800 4496; mul 4505 4526; add 4525 4527; mul 3444 4506; sub 4528 4529; mul 3810 4496; add 4530 4531; mul 3817 4496;
add 4532 4533; mul 3452 4506; mul 4505 4535; add 4534 4536; mul 3820 4496; mul 4505 4538; add 4537 4539; mul 3828
4496; add 4540 4541; mul 3460 4506; mul 4505 4543; add 4542 4544; mul 3833 4496; mul 3395 4546; add 4545 4547; mul
3443 4546; mul 4505 4549; add 4548 4550; add 3833 4551; mul 3849 4496; sub 4552 4553; mul 3856 4496; sub 4554 4555;
mul 3483 4506; mul 4505 4557; sub 4556 4558; mul 3860 4496; mul 4505 4560; sub 4559 4561; mul 3870 4496; sub 4562
4563; mul 3876 4496; sub 4564 4565; mul 3497 4506; mul 4505 4567; sub 4566 4568; mul 3879 4496; mul 4505 4570; sub
4569 4571; mul 3886 4496; mul 3894 4496; add 4573 4574; mul 3902 4496; add 4575 4576; mul 3908 4496; add 4577 4578;
mul 3521 4506; mul 4505 4580; add 4579 4581; mul 3914 4496; add 4582 4583; mul 3528 4506; mul 4505 4585; add 4584
4586; mul 3917 4496; mul 4505 4588; add 4587 4589; mul 3927 4496; add 4590 4591; mul 3935 4496; add 4592 4593; mul
3941 4496; add 4594 4595; mul 3550 4506; mul 4505 4597; add 4596 4598; mul 3944 4496; mul 4505 4600; add 4599 4601;
mul 3559 4506; sub 4602 4603; mul 3951 4496; add 4604 4605; mul 3957 4496; add 4606 4607; mul 3566 4506; mul 4505
4609; add 4608 4610; mul 3960 4496; mul 4505 4612; add 4611 4613; mul 3966 4496; add 4614 4615; mul 3573 4506; mul
4505 4617; add 4616 4618; mul 3969 4496; mul 3395 4620; add 4619 4621; mul 3443 4620; mul 4505 4623; add 4622 4624;
add 3969 4625; mul 3981 4496; add 4626 4627; mul 3987 4496; add 4628 4629; mul 3592 4506; mul 4505 4631; add 4630
4632; mul 3990 4496; mul 4505 4634; add 4633 4635; mul 3998 4496; add 4636 4637; mul 4004 4496; add 4638 4639; mul
3605 4506; mul 4505 4641; add 4640 4642; mul 4007 4496; mul 4505 4644; add 4643 4645; mul 4055 4496; mul 4015 4496;
mul 4023 4496; add 4648 4649; mul 4031 4496; add 4650 4651; mul 4037 4496; add 4652 4653; mul 3631 4506; mul 4505
4655; add 4654 4656; mul 4043 4496; add 4657 4658; mul 3638 4506; mul 4505 4660; add 4659 4661; mul 4046 4496; mul
4505 4663; add 4662 4664; sub 4647 4665; mul 4063 4496; add 4666 4667; mul 4069 4496; add 4668 4669; mul 3658 4506;
mul 4505 4671; add 4670 4672; mul 4072 4496; mul 4505 4674; add 4673 4675; mul 3667 4506; sub 4676 4677; mul 4079
4496; add 4678 4679; mul 4085 4496; add 4680 4681; mul 3674 4506; mul 4505 4683; add 4682 4684; mul 4088 4496; mul
4505 4686; add 4685 4687; mul 4094 4496; add 4688 4689; mul 3681 4506; mul 4505 4691; add 4690 4692; mul 4097 4496;
mul 3395 4694; add 4693 4695; mul 3443 4694; mul 4505 4697; add 4696 4698; add 4097 4699; mul 4109 4496; sub 4700
4701; mul 4115 4496; sub 4702 4703; mul 3700 4506; mul 4505 4705; sub 4704 4706; mul 4118 4496; mul 4505 4708; sub
4707 4709; mul 4126 4496; sub 4710 4711; mul 4132 4496; sub 4712 4713; mul 3713 4506; mul 4505 4715; sub 4714 4716;
mul 4135 4496; mul 4505 4718; sub 4717 4719; mul 477 754; mul 610 625; sub 4721 4722; mul 341 913; add 4723 4724;
mul 211 995; sub 4725 4726; mul 94 1354; add 4727 4728; mul 610 1422; mul 477 1532; add 4730 4731; mul 341 1669; sub
4732 4733; mul 211 1732; add 4734 4735; mul 94 2067; add 4736 4737; mul 477 2209; mul 610 2099; sub 4739 4740; mul
341 2347; add 4741 4742; mul 211 2409; sub 4743 4744; mul 94 2750; add 4745 4746; mul 341 2845; mul 94 2954; add
4748 4749; mul 341 3033; mul 94 3142; add 4751 4752; mul 610 617; mul 211 991; add 4754 4755; mul 464 754; add 4756
4757; mul 341 910; add 4758 4759; mul 2 1354; add 4760 4761; mul 464 1532; mul 610 1410; mul 211 1727; add 4764
4765; sub 4763 4766; mul 341 1665; add 4767 4768; mul 2 2067; add 4769 4770; mul 610 1419; mul 211 1626; add 4772
4773; mul 464 2209; add 4774 4775; mul 341 2344; add 4776 4777; mul 2 2750; add 4778 4779; mul 341 2842; mul 2 2954;
add 4781 4782; mul 341 3030; mul 2 3142; add 4784 4785; mul 488 754; mul 610 621; mul 211 876; add 4788 4789; sub
4787 4790; mul 341 868; add 4791 4792; mul 34 1354; add 4793 4794; mul 488 1532; add 4774 4796; mul 341 1651; sub
4797 4798; mul 34 2067; add 4799 4800; mul 488 2209; mul 610 2095; mul 211 2312; add 4803 4804; sub 4802 4805; mul
341 2304; add 4806 4807; mul 34 2750; add 4808 4809; mul 341 2825; mul 34 2954; add 4811 4812; mul 341 3013; mul 34
3142; add 4814 4815; mul 7 15; mul 16 464; mul 464 4818; mul 22 4819; mul 21 89; mul 21 617; mul 25 4822; sub 4821
4823; mul 4820 4824; mul 23 4825; mul 617 4819; mul 18 4827; sub 4826 4828; mul 40 4822; mul 21 621; mul 52 4831;
sub 4830 4832; mul 66 4821; sub 4833 4834; mul 4820 4835; mul 37 4836; sub 4829 4837; mul 2 4838; mul 4817 4839; mul
4817 4840; mul 8 4839; mul 8 4842; mul 233 4843; add 4841 4844; mul 15 16; mul 579 637; input p 145; mul 37 4848;
mul 617 4849; sub 4847 4850; mul 470 776; add 4851 4852; mul 4846 4853; mul 13 4854; mul 8 8; mul 15 4853; mul 4856
4857; add 4855 4858; mul 8 37; mul 510 639; mul 501 4861; mul 16 617; mul 4848 4863; mul 503 639; mul 498 4865; add
4864 4866; sub 4862 4867; mul 501 722; add 4868 4869; mul 519 698; mul 574 639; add 4871 4872; mul 233 510; mul 720
4874; add 4873 4875; mul 498 4876; add 4870 4877; mul 387 778; mul 382 4879; sub 4878 4880; mul 394 778; mul 385
4882; sub 4881 4883; mul 385 861; sub 4884 4885; mul 403 837; mul 465 778; add 4887 4888; mul 233 394; mul 859 4890;
add 4889 4891; mul 382 4892; add 4886 4893; mul 4860 4894; add 4859 4895; mul 8 23; mul 501 4865; mul 498 4861; add
4898 4899; mul 498 722; add 4900 4901; mul 501 4876; sub 4902 4903; mul 385 4879; sub 4904 4905; mul 382 4882; add
4906 4907; mul 382 861; add 4908 4909; mul 385 4892; add 4910 4911; mul 4897 4912; add 4896 4913; mul 7 233; div 1
4915; mul 4914 4916; mul 2 4917; mul 2 4918; sub 4845 4919; mul 8 4912; mul 7 4854; sub 4921 4922; mul 13 233; div 1
4924; mul 4923 4925; mul 2 4926; mul 2 4927; add 4920 4928; input p 131; mul 8 4930; mul 8 4931; mul 9 4817; mul
4817 4933; add 4932 4934; mul 2 4935; mul 4825 4936; mul 91 3246; mul 91 3209; where 977 4939; add 4938 4940; mul
487 591; sub 4941 4942; input p 170; mul 488 4944; mul 99 610; add 4945 4946; add 4943 4947; mul 61 473; mul 27 464;
add 4949 4950; mul 46 488; add 4951 4952; mul 473 4953; mul 27 473; mul 30 464; add 4955 4956; mul 33 488; add 4957
4958; mul 464 4959; add 4954 4960; mul 46 473; mul 33 464; add 4962 4963; mul 50 488; add 4964 4965; mul 488 4966;
add 4961 4967; mul 37 4936; sub 24 4969; mul 4820 4970; add 4968 4971; mul 52 4972; mul 21 4973; add 4948 4974; mul
88 621; mul 4975 4976; mul 91 3289; mul 91 3285; where 989 4979; add 4978 4980; mul 481 591; sub 4981 4982; mul 96
610; add 4983 4984; mul 471 494; mul 580 588; add 4986 4987; add 4985 4988; sub 1379 4989; mul 16 4849; add 4990
4991; input p 122; input z 0; mul 4993 4994; input p 123; input z 1; mul 4996 4997; add 4995 4998; input p 124;
input z 2; mul 5000 5001; add 4999 5002; input p 125; input z 3; mul 5004 5005; add 5003 5006; input p 146; mul 5007
5008; sub 4992 5009; mul 40 4972; mul 23 4936; add 38 5012; mul 4820 5013; mul 25 5014; sub 5011 5015; mul 21 5016;
mul 18 4936; mul 4819 5018; sub 5017 5019; sub 5010 5020; mul 88 617; mul 5021 5022; add 4977 5023; input c 0; input
c 2; mul 424 5026; add 5025 5027; input c 3; mul 537 5029; add 5028 5030; mul 1363 1397; add 5031 5032; mul 1361
1379; sub 5033 5034; input p 16; input c 1; add 5036 5037; constant 0.0; max 5038 5039; mul 473 5040; sub 5035 5041;
mul 474 494; mul 582 588; add 5043 5044; sub 614 5045; sub 5042 5046; input p 121; sub 5048 5007; input p 126; abs
473; mul 5050 5051; mul 473 5052; input p 127; mul 473 5054; mul 473 473; input p 128; add 5056 5057; sqrt 5058; div
1 5059; mul 5055 5060; add 5053 5061; sub 5049 5062; add 5047 5063; input p 129; input x 12; sub 28 5066; mul 5065
5067; input p 130; input x 13; sub 28 5070; mul 5069 5071; add 5068 5072; sub 5064 5073; mul 66 4972; sub 5075 5014;
mul 21 5076; sub 5074 5077; mul 88 89; mul 5078 5079; sub 5024 5080; mul 78 5081; mul 58 5082; mul 75 5081; mul 55
5084; sub 5083 5085; mul 21 5086; mul 4822 5014; sub 5087 5088; mul 88 4975; mul 58 5090; mul 88 5021; mul 55 5092;
add 5091 5093; mul 80 5081; add 5094 5095; mul 21 5096; sub 5089 5097; mul 25 233; mul 78 5090; mul 78 5082; sub
5100 5101; mul 69 5081; mul 55 5103; add 5102 5104; mul 88 5078; mul 55 5106; add 5105 5107; mul 21 5108; mul 5099
5109; add 5098 5110; mul 22 5111; add 4836 5112; mul 16 5113; add 4937 5114; mul 8 5115; mul 15 4817; mul 4839 4933;
mul 9 4840; add 5118 5119; mul 5117 5120; mul 4824 5013; mul 22 5122; mul 617 5018; sub 5123 5124; mul 4835 4970;
mul 22 5126; add 5125 5127; mul 464 5128; mul 464 5129; mul 4822 4972; mul 66 5087; add 5131 5132; mul 66 5097; sub
5133 5134; mul 78 5092; mul 75 5082; add 5136 5137; mul 58 5103; sub 5138 5139; mul 58 5106; sub 5140 5141; mul 21
5142; mul 52 5143; add 5135 5144; mul 78 5084; mul 75 5090; sub 5146 5147; sub 5148 5139; sub 5149 5141; mul 21
5150; mul 52 5151; add 5145 5152; mul 40 233; mul 5109 5154; add 5153 5155; mul 22 5156; add 4825 5157; mul 37 5158;
add 5130 5159; mul 23 5113; add 5160 5161; mul 18 5108; add 5162 5163; mul 16 5108; mul 4827 4936; sub 5165 5166;
mul 17 5167; add 5164 5168; mul 4846 5169; add 5121 5170; mul 7 5171; sub 5116 5172; mul 4925 5173; mul 2 5174; mul
2 5175; add 4929 5176; mul 15 5120; mul 8 4932; mul 4839 5179; sub 5178 5180; mul 4842 4932; sub 5181 5182; mul 16
5158; mul 4836 4936; sub 5184 5185; mul 4860 5186; sub 5183 5187; mul 4897 5115; sub 5188 5189; mul 13 5171; sub
5190 5191; mul 15 5169; mul 4856 5193; sub 5192 5194; mul 4916 5195; mul 2 5196; mul 2 5197; add 5177 5198; mul 1410
4819; mul 18 5200; mul 21 1410; mul 25 5202; sub 5203 4822; mul 4820 5204; mul 23 5205; add 5201 5206; mul 21 1419;
mul 52 5208; mul 40 5202; sub 5209 5210; mul 66 4822; add 5211 5212; mul 4820 5213; mul 37 5214; sub 5207 5215; mul
2 5216; mul 4817 5217; mul 4817 5218; mul 8 5217; mul 8 5220; mul 233 5221; add 5219 5222; mul 1410 4849; mul 579
1487; sub 5224 5225; mul 470 1550; sub 5226 5227; mul 4846 5228; mul 13 5229; mul 15 5228; mul 4856 5231; add 5230
5232; mul 16 1410; mul 4848 5234; mul 503 1511; mul 498 5236; add 5235 5237; mul 510 1511; mul 501 5239; sub 5238
5240; mul 501 1514; add 5241 5242; mul 519 1478; mul 574 1511; sub 5244 5245; mul 1508 4874; add 5246 5247; mul 498
5248; add 5243 5249; mul 387 1552; mul 382 5251; add 5250 5252; mul 394 1552; mul 385 5254; add 5253 5255; mul 385
1621; sub 5256 5257; mul 403 1596; mul 465 1552; sub 5259 5260; mul 1619 4890; add 5261 5262; mul 382 5263; add 5258
5264; mul 4860 5265; add 5233 5266; mul 498 1514; mul 501 5236; mul 498 5239; add 5269 5270; sub 5268 5271; mul 501
5248; sub 5272 5273; mul 385 5251; add 5274 5275; mul 382 5254; sub 5276 5277; mul 382 1621; add 5278 5279; mul 385
5263; add 5280 5281; mul 4897 5282; add 5267 5283; mul 4916 5284; mul 2 5285; mul 2 5286; sub 5223 5287; mul 8 5282;
mul 7 5229; sub 5289 5290; mul 4925 5291; mul 2 5292; mul 2 5293; add 5288 5294; mul 4936 5205; mul 5014 5202; mul
5022 5078; mul 88 1419; mul 4975 5299; sub 5298 5300; mul 88 1410; mul 5021 5302; sub 5301 5303; mul 78 5304; mul 58
5305; add 5100 5107; sub 5306 5307; mul 75 5304; mul 55 5309; sub 5308 5310; mul 21 5311; add 5297 5312; mul 80
5304; mul 21 5314; sub 5313 5315; mul 69 5304; mul 55 5317; mul 78 5305; sub 5318 5319; mul 21 5320; mul 5099 5321;
add 5316 5322; mul 22 5323; add 5214 5324; mul 16 5325; add 5296 5326; mul 8 5327; mul 4933 5217; mul 9 5218; add
5329 5330; mul 5117 5331; mul 1410 5018; mul 5013 5204; mul 22 5334; add 5333 5335; mul 4970 5213; mul 22 5337; add
5336 5338; mul 464 5339; mul 464 5340; mul 66 5312; mul 4972 5202; sub 5342 5343; mul 66 5315; sub 5344 5345; mul 75
5305; mul 58 5317; sub 5347 5348; mul 21 5349; mul 52 5350; add 5346 5351; mul 69 5090; mul 78 5106; add 5353 5354;
mul 78 5309; add 5355 5356; sub 5357 5348; mul 21 5358; mul 52 5359; add 5352 5360; mul 5154 5321; add 5361 5362;
mul 22 5363; add 5205 5364; mul 37 5365; add 5341 5366; mul 23 5325; add 5367 5368; mul 18 5320; add 5369 5370; mul
4936 5200; mul 16 5320; add 5372 5373; mul 17 5374; add 5371 5375; mul 4846 5376; add 5332 5377; mul 7 5378; sub
5328 5379; mul 4925 5380; mul 2 5381; mul 2 5382; add 5295 5383; mul 15 5331; mul 5179 5217; sub 5385 5386; mul 4932
5220; sub 5387 5388; mul 16 5365; mul 4936 5214; sub 5390 5391; mul 4860 5392; sub 5389 5393; mul 4897 5327; sub
5394 5395; mul 13 5378; sub 5396 5397; mul 15 5376; mul 4856 5399; sub 5398 5400; mul 4916 5401; mul 2 5402; mul 2
5403; add 5384 5404; mul 25 5208; sub 4831 5406; mul 4820 5407; mul 23 5408; mul 1419 4819; mul 18 5410; sub 5409
5411; mul 40 5208; mul 21 2095; mul 52 5414; sub 5413 5415; mul 66 4831; sub 5416 5417; mul 4820 5418; mul 37 5419;
sub 5412 5420; mul 2 5421; mul 4817 5422; mul 4817 5423; mul 8 5422; mul 8 5425; mul 233 5426; add 5424 5427; mul
579 2111; mul 1419 4849; sub 5429 5430; mul 470 2231; add 5431 5432; mul 4846 5433; mul 13 5434; mul 15 5433; mul
4856 5436; add 5435 5437; mul 510 2113; mul 501 5439; mul 16 1419; mul 4848 5441; mul 503 2113; mul 498 5443; add
5442 5444; sub 5440 5445; mul 501 2179; add 5446 5447; mul 519 2155; mul 574 2113; add 5449 5450; mul 2177 4874; add
5451 5452; mul 498 5453; add 5448 5454; mul 387 2233; mul 382 5456; sub 5455 5457; mul 394 2233; mul 385 5459; sub
5458 5460; mul 385 2299; sub 5461 5462; mul 403 2275; mul 465 2233; add 5464 5465; mul 2297 4890; add 5466 5467; mul
382 5468; add 5463 5469; mul 4860 5470; add 5438 5471; mul 501 5443; mul 498 5439; add 5473 5474; mul 498 2179; add
5475 5476; mul 501 5453; sub 5477 5478; mul 385 5456; sub 5479 5480; mul 382 5459; add 5481 5482; mul 382 2299; add
5483 5484; mul 385 5468; add 5485 5486; mul 4897 5487; add 5472 5488; mul 4916 5489; mul 2 5490; mul 2 5491; sub
5428 5492; mul 8 5487; mul 7 5434; sub 5494 5495; mul 4925 5496; mul 2 5497; mul 2 5498; add 5493 5499; mul 4936
5408; add 5141 5147; mul 88 2095; mul 4975 5503; mul 5021 5299; add 5504 5505; mul 4976 5078; sub 5506 5507; mul 78
5508; mul 58 5509; add 5502 5510; mul 75 5508; mul 55 5512; sub 5511 5513; mul 21 5514; mul 5014 5208; sub 5515
5516; add 5136 5147; mul 80 5508; sub 5518 5519; mul 21 5520; add 5517 5521; mul 69 5508; mul 55 5523; mul 78 5509;
add 5355 5525; sub 5524 5526; mul 21 5527; mul 5099 5528; add 5522 5529; mul 22 5530; add 5419 5531; mul 16 5532;
add 5501 5533; mul 8 5534; mul 4933 5422; mul 9 5423; add 5536 5537; mul 5117 5538; mul 5013 5407; mul 22 5540; mul
1419 5018; sub 5541 5542; mul 4970 5418; mul 22 5544; add 5543 5545; mul 464 5546; mul 464 5547; mul 4972 5208; mul
66 5515; add 5549 5550; mul 66 5521; add 5551 5552; mul 75 5106; mul 69 5092; sub 5554 5555; mul 75 5509; add 5556
5557; mul 58 5523; sub 5558 5559; mul 21 5560; mul 52 5561; add 5553 5562; mul 78 5512; sub 5564 5559; mul 21 5565;
mul 52 5566; add 5563 5567; mul 5154 5528; add 5568 5569; mul 22 5570; add 5408 5571; mul 37 5572; add 5548 5573;
mul 23 5532; add 5574 5575; mul 18 5527; add 5576 5577; mul 16 5527; mul 4936 5410; sub 5579 5580; mul 17 5581; add
5578 5582; mul 4846 5583; add 5539 5584; mul 7 5585; sub 5535 5586; mul 4925 5587; mul 2 5588; mul 2 5589; add 5500
5590; mul 15 5538; mul 5179 5422; sub 5592 5593; mul 4932 5425; sub 5594 5595; mul 16 5572; mul 4936 5419; sub 5597
5598; mul 4860 5599; sub 5596 5600; mul 4897 5534; sub 5601 5602; mul 13 5585; sub 5603 5604; mul 15 5583; mul 4856
5606; sub 5605 5607; mul 4916 5608; mul 2 5609; mul 2 5610; add 5591 5611; mul 394 2789; mul 382 5613; mul 387 2789;
mul 385 5615; sub 5614 5616; mul 382 2821; add 5617 5618; mul 465 2789; mul 403 2807; sub 5620 5621; mul 2819 4890;
add 5622 5623; mul 385 5624; add 5619 5625; mul 8 5626; mul 470 2787; mul 4846 5628; mul 7 5629; sub 5627 5630; mul
4925 5631; mul 2 5632; mul 2 5633; mul 13 5629; mul 15 5628; mul 4856 5636; add 5635 5637; mul 382 5624; mul 382
5615; mul 385 5613; add 5640 5641; mul 385 2821; add 5642 5643; sub 5639 5644; mul 4860 5645; add 5638 5646; mul
4897 5626; add 5647 5648; mul 4916 5649; mul 2 5650; mul 2 5651; sub 5634 5652; mul 503 2966; mul 501 5654; mul 510
2966; mul 498 5656; add 5655 5657; mul 498 2998; add 5658 5659; mul 574 2966; mul 519 2984; sub 5661 5662; mul 2996
4874; add 5663 5664; mul 501 5665; sub 5660 5666; mul 8 5667; mul 579 2964; mul 4846 5669; mul 7 5670; sub 5668
5671; mul 4925 5672; mul 2 5673; mul 2 5674; mul 13 5670; mul 15 5669; mul 4856 5677; add 5676 5678; mul 501 5656;
mul 498 5654; sub 5680 5681; mul 501 2998; add 5682 5683; mul 498 5665; add 5684 5685; mul 4860 5686; add 5679 5687;
mul 4897 5667; add 5688 5689; mul 4916 5690; mul 2 5691; mul 2 5692; sub 5675 5693; mul 255 995; mul 607 5695; neg
5696; where 217 5697; mul 255 1732; mul 607 5699; where 217 5700; mul 255 2409; mul 607 5702; neg 5703; where 217
5704; mul 255 991; where 989 5706; mul 258 995; mul 979 5708; neg 5709; where 217 5710; add 5707 5711; mul 255 1727;
neg 5713; where 989 5714; mul 258 1732; mul 979 5716; where 217 5717; add 5715 5718; mul 255 1626; where 989 5720;
mul 258 2409; mul 979 5722; neg 5723; where 217 5724; add 5721 5725; mul 255 876; neg 5727; where 977 5728; mul 262
995; mul 979 5730; neg 5731; where 217 5732; add 5729 5733; where 977 5720; mul 262 1732; mul 979 5736; where 217
5737; add 5735 5738; mul 255 2312; neg 5740; where 977 5741; mul 262 2409; mul 979 5743; neg 5744; where 217 5745;
add 5742 5746; mul 258 991; mul 233 5748; where 989 5749; mul 266 995; neg 5751; mul 233 5752; where 217 5753; add
5750 5754; mul 258 1727; neg 5756; mul 233 5757; where 989 5758; mul 266 1732; mul 233 5760; where 217 5761; add
5759 5762; mul 258 1626; mul 233 5764; where 989 5765; mul 266 2409; neg 5767; mul 233 5768; where 217 5769; add
5766 5770; mul 258 876; neg 5772; where 977 5773; mul 262 991; where 989 5775; add 5774 5776; mul 270 995; neg 5778;
mul 233 5779; where 217 5780; add 5777 5781; where 977 5764; mul 262 1727; neg 5784; where 989 5785; add 5783 5786;
mul 270 1732; mul 233 5788; where 217 5789; add 5787 5790; mul 258 2312; neg 5792; where 977 5793; mul 262 1626;
where 989 5795; add 5794 5796; mul 270 2409; neg 5798; mul 233 5799; where 217 5800; add 5797 5801; mul 262 876; neg
5803; mul 233 5804; where 977 5805; mul 274 995; neg 5807; mul 233 5808; where 217 5809; add 5806 5810; mul 233
5795; where 977 5812; mul 274 1732; mul 233 5814; where 217 5815; add 5813 5816; mul 262 2312; neg 5818; mul 233
5819; where 977 5820; mul 274 2409; neg 5822; mul 233 5823; where 217 5824; add 5821 5825; mul 266 991; mul 979
5827; where 989 5828; mul 278 995; neg 5830; where 217 5831; add 5829 5832; mul 266 1727; mul 979 5834; neg 5835;
where 989 5836; mul 278 1732; where 217 5838; add 5837 5839; mul 266 1626; mul 979 5841; where 989 5842; mul 278
2409; neg 5844; where 217 5845; add 5843 5846; mul 266 876; neg 5848; where 977 5849; mul 270 991; mul 233 5851;
where 989 5852; add 5850 5853; mul 282 995; neg 5855; where 217 5856; add 5854 5857; where 977 5841; mul 270 1727;
neg 5860; mul 233 5861; where 989 5862; add 5859 5863; mul 282 1732; where 217 5865; add 5864 5866; mul 266 2312;
neg 5868; where 977 5869; mul 270 1626; mul 233 5871; where 989 5872; add 5870 5873; mul 282 2409; neg 5875; where
217 5876; add 5874 5877; mul 270 876; neg 5879; mul 233 5880; where 977 5881; mul 274 991; where 989 5883; add 5882
5884; mul 286 995; neg 5886; where 217 5887; add 5885 5888; where 977 5872; mul 274 1727; neg 5891; where 989 5892;
add 5890 5893; mul 286 1732; where 217 5895; add 5894 5896; mul 270 2312; neg 5898; mul 233 5899; where 977 5900;
mul 274 1626; where 989 5902; add 5901 5903; mul 286 2409; neg 5905; where 217 5906; add 5904 5907; mul 274 876; mul
979 5909; neg 5910; where 977 5911; neg 1025; where 217 5913; add 5912 5914; mul 979 5902; where 977 5916; where 217
1758; add 5917 5918; mul 274 2312; mul 979 5920; neg 5921; where 977 5922; neg 2435; where 217 5924; add 5923 5925;
mul 278 991; mul 607 5927; where 989 5928; mul 278 1727; mul 607 5930; neg 5931; where 989 5932; mul 278 1626; mul
607 5934; where 989 5935; mul 278 876; neg 5937; where 977 5938; mul 282 991; mul 979 5940; where 989 5941; add 5939
5942; where 977 5934; mul 282 1727; mul 979 5945; neg 5946; where 989 5947; add 5944 5948; mul 278 2312; neg 5950;
where 977 5951; mul 282 1626; mul 979 5953; where 989 5954; add 5952 5955; mul 282 876; neg 5957; mul 233 5958;
where 977 5959; mul 286 991; mul 233 5961; where 989 5962; add 5960 5963; mul 233 5953; where 977 5965; mul 286
1727; neg 5967; mul 233 5968; where 989 5969; add 5966 5970; mul 282 2312; neg 5972; mul 233 5973; where 977 5974;
mul 286 1626; mul 233 5976; where 989 5977; add 5975 5978; mul 286 876; mul 979 5980; neg 5981; where 977 5982;
where 989 1006; add 5983 5984; mul 979 5976; where 977 5986; neg 1740; where 989 5988; add 5987 5989; mul 286 2312;
mul 979 5991; neg 5992; where 977 5993; where 989 1737; add 5994 5995; mul 607 1002; neg 5997; where 977 5998; mul
607 1737; where 977 6000; mul 607 2415; neg 6002; where 977 6003; mul 255 981; neg 6005; where 977 6006; mul 222
1025; mul 979 6008; neg 6009; where 217 6010; add 6007 6011; mul 255 1722; where 977 6013; mul 222 1758; mul 979
6015; where 217 6016; add 6014 6017; mul 255 2400; neg 6019; where 977 6020; mul 222 2435; mul 979 6022; neg 6023;
where 217 6024; add 6021 6025; mul 258 981; neg 6027; where 977 6028; mul 222 1006; where 989 6030; add 6029 6031;
mul 229 1025; neg 6033; mul 233 6034; where 217 6035; add 6032 6036; mul 258 1722; where 977 6038; mul 222 1740; neg
6040; where 989 6041; add 6039 6042; mul 229 1758; mul 233 6044; where 217 6045; add 6043 6046; mul 258 2400; neg
6048; where 977 6049; mul 222 1737; where 989 6051; add 6050 6052; mul 229 2435; neg 6054; mul 233 6055; where 217
6056; add 6053 6057; mul 262 981; mul 222 1002; add 6059 6060; neg 6061; where 977 6062; mul 237 1025; neg 6064; mul
233 6065; where 217 6066; add 6063 6067; mul 262 1722; add 6051 6069; where 977 6070; mul 237 1758; mul 233 6072;
where 217 6073; add 6071 6074; mul 262 2400; mul 222 2415; add 6076 6077; neg 6078; where 977 6079; mul 237 2435;
neg 6081; mul 233 6082; where 217 6083; add 6080 6084; mul 266 981; neg 6086; where 977 6087; mul 229 1006; mul 233
6089; where 989 6090; add 6088 6091; mul 241 1025; neg 6093; where 217 6094; add 6092 6095; mul 266 1722; where 977
6097; mul 229 1740; neg 6099; mul 233 6100; where 989 6101; add 6098 6102; mul 241 1758; where 217 6104; add 6103
6105; mul 266 2400; neg 6107; where 977 6108; mul 229 1737; mul 233 6110; where 989 6111; add 6109 6112; mul 241
2435; neg 6114; where 217 6115; add 6113 6116; mul 270 981; mul 229 1002; add 6118 6119; neg 6120; where 977 6121;
mul 237 1006; where 989 6123; add 6122 6124; mul 245 1025; neg 6126; where 217 6127; add 6125 6128; mul 270 1722;
add 6110 6130; where 977 6131; mul 237 1740; neg 6133; where 989 6134; add 6132 6135; mul 245 1758; where 217 6137;
add 6136 6138; mul 270 2400; mul 229 2415; add 6140 6141; neg 6142; where 977 6143; mul 237 1737; where 989 6145;
add 6144 6146; mul 245 2435; neg 6148; where 217 6149; add 6147 6150; mul 237 1002; neg 6152; mul 233 6153; mul 274
981; sub 6154 6155; where 977 6156; mul 249 1025; neg 6158; where 217 6159; add 6157 6160; mul 274 1722; mul 233
6145; add 6162 6163; where 977 6164; mul 249 1758; where 217 6166; add 6165 6167; mul 237 2415; neg 6169; mul 233
6170; mul 274 2400; sub 6171 6172; where 977 6173; mul 249 2435; neg 6175; where 217 6176; add 6174 6177; mul 278
981; neg 6179; where 977 6180; mul 241 1006; mul 979 6182; where 989 6183; add 6181 6184; mul 278 1722; where 977
6186; mul 241 1740; mul 979 6188; neg 6189; where 989 6190; add 6187 6191; mul 278 2400; neg 6193; where 977 6194;
mul 241 1737; mul 979 6196; where 989 6197; add 6195 6198; mul 282 981; mul 241 1002; add 6200 6201; neg 6202; where
977 6203; mul 245 1006; mul 233 6205; where 989 6206; add 6204 6207; mul 282 1722; add 6196 6209; where 977 6210;
mul 245 1740; neg 6212; mul 233 6213; where 989 6214; add 6211 6215; mul 282 2400; mul 241 2415; add 6217 6218; neg
6219; where 977 6220; mul 245 1737; mul 233 6222; where 989 6223; add 6221 6224; mul 245 1002; neg 6226; mul 233
6227; mul 286 981; sub 6228 6229; where 977 6230; mul 249 1006; where 989 6232; add 6231 6233; mul 286 1722; add
6223 6235; where 977 6236; mul 249 1740; neg 6238; where 989 6239; add 6237 6240; mul 245 2415; neg 6242; mul 233
6243; mul 286 2400; sub 6244 6245; where 977 6246; mul 249 1737; where 989 6248; add 6247 6249; mul 252 981; mul 249
1002; mul 979 6252; add 6251 6253; neg 6254; where 977 6255; mul 252 1722; mul 979 6248; add 6257 6258; where 977
6259; mul 252 2400; mul 249 2415; mul 979 6262; add 6261 6263; neg 6264; where 977 6265; mul 617 5016; mul 621 4973;
sub 6267 6268; mul 89 5076; sub 6269 6270; mul 44 5090; mul 58 5092; add 6272 6273; mul 85 5081; add 6274 6275; mul
77 6276; add 6271 6277; mul 58 5084; mul 44 5082; sub 6279 6280; mul 77 6281; add 6278 6282; mul 73 5086; add 6283
6284; mul 73 5096; sub 6285 6286; mul 60 5081; mul 68 6288; add 6287 6289; mul 57 5142; add 6290 6291; mul 57 5150;
add 6292 6293; mul 44 5103; mul 75 5092; mul 75 5084; add 6296 6297; sub 6295 6298; mul 44 5106; add 6299 6300; mul
53 6301; add 6294 6302; mul 42 5108; add 6303 6304; mul 1419 4973; mul 1410 5016; sub 6306 6307; mul 617 5076; add
6308 6309; mul 85 5304; sub 6311 5518; mul 77 6312; add 6310 6313; sub 5141 5136; mul 44 5305; sub 6315 6316; mul 58
5309; add 6317 6318; mul 77 6319; add 6314 6320; mul 73 5311; add 6321 6322; mul 73 5314; sub 6323 6324; mul 60
5304; add 5094 6326; mul 68 6327; add 6325 6328; mul 57 5349; add 6329 6330; mul 57 5358; add 6331 6332; sub 5555
5554; mul 75 5309; sub 6334 6335; mul 44 5317; add 6336 6337; mul 53 6338; add 6333 6339; mul 42 5320; add 6340
6341; mul 1419 5016; mul 2095 4973; sub 6343 6344; mul 621 5076; sub 6345 6346; mul 85 5508; mul 77 6348; add 6347
6349; sub 6296 6300; mul 44 5509; sub 6351 6352; mul 58 5512; add 6353 6354; mul 77 6355; add 6350 6356; mul 73
5514; add 6357 6358; mul 73 5520; add 6359 6360; mul 60 5508; sub 6362 6274; mul 68 6363; add 6361 6364; mul 57
5560; add 6365 6366; mul 57 5565; add 6367 6368; mul 44 5523; mul 75 5512; sub 6370 6371; mul 53 6372; add 6369
6373; mul 42 5527; add 6374 6375; sub 5086 5096; sub 5311 5314; add 5514 5520; mul 16 5167; mul 16 5374; mul 16
5581; mul 473 4835; mul 473 6383; mul 348 862; mul 28 6385; add 913 6386; mul 28 6387; add 6384 6388; mul 21 6276;
mul 52 6390; mul 4821 4972; sub 6391 6392; mul 21 6281; mul 52 6394; add 6393 6395; mul 40 5087; add 6396 6397; mul
40 5097; sub 6398 6399; mul 66 233; mul 21 6288; mul 6401 6402; add 6400 6403; mul 28 6404; add 6389 6405; mul 473
5213; mul 473 6407; mul 348 1622; mul 28 6409; sub 6410 1669; mul 28 6411; add 6408 6412; mul 21 6312; mul 52 6414;
add 5131 6415; mul 21 6319; mul 52 6417; add 6416 6418; mul 40 5312; add 6419 6420; mul 40 5315; sub 6421 6422; mul
21 6327; mul 6401 6424; add 6423 6425; mul 28 6426; add 6413 6427; mul 473 5418; mul 473 6429; mul 348 2300; mul 28
6431; add 2347 6432; mul 28 6433; add 6430 6434; mul 21 6348; mul 52 6436; mul 4831 4972; sub 6437 6438; mul 21
6355; mul 52 6440; add 6439 6441; mul 40 5515; add 6442 6443; mul 40 5521; add 6444 6445; mul 21 6363; mul 6401
6447; add 6446 6448; mul 28 6449; add 6435 6450; mul 348 2821; mul 28 6452; add 2845 6453; mul 28 6454; mul 348
2998; mul 28 6456; add 3033 6457; mul 28 6458; mul 464 4835; mul 473 6460; mul 464 6383; add 6461 6462; mul 2 6385;
add 740 6464; mul 28 6465; add 6463 6466; mul 2 6387; add 6467 6468; mul 2 6404; add 6469 6470; mul 28 5156; add
6471 6472; mul 464 5213; mul 473 6474; mul 464 6407; add 6475 6476; mul 2 6409; add 1438 6478; mul 28 6479; add 6477
6480; mul 2 6411; add 6481 6482; mul 2 6426; add 6483 6484; mul 28 5363; add 6485 6486; mul 464 5418; mul 473 6488;
mul 464 6429; add 6489 6490; mul 2 6431; add 2196 6492; mul 28 6493; add 6491 6494; mul 2 6433; add 6495 6496; mul 2
6449; add 6497 6498; mul 28 5570; add 6499 6500; mul 2 6452; add 2774 6502; mul 28 6503; mul 2 6454; add 6504 6505;
mul 2 6456; add 3000 6507; mul 28 6508; mul 2 6458; add 6509 6510; mul 464 6460; mul 2 6465; add 6512 6513; mul 2
5156; add 6514 6515; mul 464 6474; mul 2 6479; add 6517 6518; mul 2 5363; add 6519 6520; mul 464 6488; mul 2 6493;
add 6522 6523; mul 2 5570; add 6524 6525; mul 2 6503; mul 2 6508; mul 488 4835; mul 473 6529; mul 488 6383; add 6530
6531; mul 34 6385; add 735 6533; mul 28 6534; add 6532 6535; mul 34 6387; add 6536 6537; mul 34 6404; add 6538 6539;
mul 66 6390; sub 6541 6438; mul 66 6394; add 6542 6543; mul 40 5143; add 6544 6545; mul 40 5151; add 6546 6547; mul
52 233; mul 21 6301; mul 6549 6550; add 6548 6551; mul 28 6552; add 6540 6553; mul 488 5213; mul 473 6555; mul 488
6407; add 6556 6557; mul 34 6409; sub 6559 1518; mul 28 6560; add 6558 6561; mul 34 6411; add 6562 6563; mul 34
6426; add 6564 6565; mul 66 6414; add 5549 6567; mul 66 6417; add 6568 6569; mul 40 5350; add 6570 6571; mul 40
5359; add 6572 6573; mul 21 6338; mul 6549 6575; add 6574 6576; mul 28 6577; add 6566 6578; mul 488 5418; mul 473
6580; mul 488 6429; add 6581 6582; mul 34 6431; add 2192 6584; mul 28 6585; add 6583 6586; mul 34 6433; add 6587
6588; mul 34 6449; add 6589 6590; mul 66 6436; mul 4972 5414; sub 6592 6593; mul 66 6440; add 6594 6595; mul 40
5561; add 6596 6597; mul 40 5566; add 6598 6599; mul 21 6372; mul 6549 6601; add 6600 6602; mul 28 6603; add 6591
6604; mul 34 6452; add 2772 6606; mul 28 6607; mul 34 6454; add 6608 6609; mul 34 6456; add 2960 6611; mul 28 6612;
mul 34 6458; add 6613 6614; mul 464 6529; mul 488 6460; add 6616 6617; mul 2 6534; add 6618 6619; mul 34 6465; add
6620 6621; mul 2 6552; add 6622 6623; mul 34 5156; add 6624 6625; mul 464 6555; mul 488 6474; add 6627 6628; mul 2
6560; add 6629 6630; mul 34 6479; add 6631 6632; mul 2 6577; add 6633 6634; mul 34 5363; add 6635 6636; mul 464
6580; mul 488 6488; add 6638 6639; mul 2 6585; add 6640 6641; mul 34 6493; add 6642 6643; mul 2 6603; add 6644 6645;
mul 34 5570; add 6646 6647; mul 2 6607; mul 34 6503; add 6649 6650; mul 2 6612; mul 34 6508; add 6652 6653; mul 488
6529; mul 34 6534; add 6655 6656; mul 34 6552; add 6657 6658; mul 488 6555; mul 34 6560; add 6660 6661; mul 34 6577;
add 6662 6663; mul 488 6580; mul 34 6585; add 6665 6666; mul 34 6603; add 6667 6668; mul 34 6607; mul 34 6612; mul
37 4863; mul 22 6672; sub 627 6673; mul 37 5234; mul 22 6675; add 1424 6676; mul 37 5441; mul 22 6678; sub 2101
6679; mul 4819 5122; mul 346 6672; sub 6681 6682; mul 4819 5126; add 6683 6684; mul 38 5156; add 6685 6686; mul 24
5111; add 6687 6688; mul 346 6675; mul 4819 5334; add 6690 6691; mul 4819 5337; add 6692 6693; mul 38 5363; add 6694
6695; mul 24 5323; add 6696 6697; mul 4819 5540; mul 346 6678; sub 6699 6700; mul 4819 5544; add 6701 6702; mul 38
5570; add 6703 6704; mul 24 5530; add 6705 6706; neg 617; neg 437; neg 550; neg 440; neg 553; neg 444; neg 557;
input p 225; mul 527 654; mul 6715 6716; add 654 6717; input p 226; mul 6716 6719; mul 348 6720; add 6718 6721; add
793 6722; mul 414 793; mul 6715 6724; add 6723 6725; mul 6719 6724; mul 348 6727; add 6726 6728; mul 527 1453; mul
6715 6730; add 1453 6731; mul 6719 6730; mul 348 6733; add 6732 6734; add 1571 6735; mul 414 1571; mul 6715 6737;
add 6736 6738; mul 6719 6737; mul 348 6740; add 6739 6741; neg 6742; mul 527 2125; mul 6715 6744; add 2125 6745; mul
6719 6744; mul 348 6747; add 6746 6748; add 2245 6749; mul 414 2245; mul 6715 6751; add 6750 6752; mul 6719 6751;
mul 348 6754; add 6753 6755; mul 414 2794; mul 6715 6757; add 2794 6758; mul 6719 6757; mul 348 6760; add 6759 6761;
mul 527 2971; mul 6715 6763; add 2971 6764; mul 6719 6763; mul 348 6766; add 6765 6767; le 5039 5038; le 5038 5039;
add 6769 6770; div 1 6771; mul 6769 6772; mul 89 473; mul 6773 6774; neg 6775; mul 473 617; mul 6773 6777; mul 473
621; mul 6773 6779; neg 6780; mul 5051 6774; neg 6782; mul 5051 6777; mul 5051 6779; neg 6785; mul 89 5060; mul 473
6787; neg 6788; mul 617 5060; mul 473 6790; mul 621 5060; mul 473 6792; neg 6793; input p 227; mul 5060 5061; mul 89
6796; mul 233 5059; div 1 6798; mul 6797 6799; mul 6795 6800; mul 617 6796; mul 6799 6802; mul 6795 6803; neg 6804;
mul 621 6796; mul 6799 6806; mul 6795 6807; mul 617 5007; mul 1410 5007; neg 6810; mul 1419 5007; le 1 4994; mul 464
5008; add 473 6814; lt 5039 6815; and 6813 6816; constant -1.0; le 4994 6818; lt 6815 5039; and 6819 6820; or 6817
6821; not 6822; input p 176; mul 464 6824; where 6823 6825; le 1 4997; and 6816 6827; le 4997 6818; and 6820 6829;
or 6828 6830; not 6831; input p 177; mul 464 6833; where 6832 6834; le 1 5001; and 6816 6836; le 5001 6818; and 6820
6838; or 6837 6839; not 6840; input p 178; mul 464 6842; where 6841 6843; le 1 5005; and 6816 6845; le 5005 6818;
and 6820 6847; or 6846 6848; not 6849; input p 179; mul 464 6851; where 6850 6852; mul 23 4892; mul 23 4879; mul 37
4882; add 6855 6856; mul 37 861; add 6857 6858; sub 6854 6859; mul 23 5251; mul 37 5254; add 6861 6862; mul 37 1621;
sub 6863 6864; mul 23 5263; add 6865 6866; mul 23 5468; mul 23 5456; mul 37 5459; add 6869 6870; mul 37 2299; add
6871 6872; sub 6868 6873; mul 23 5624; mul 23 5615; mul 37 5613; add 6876 6877; mul 37 2821; add 6878 6879; sub 6875
6880; mul 23 4882; mul 37 4879; sub 6882 6883; mul 23 861; add 6884 6885; mul 37 4892; add 6886 6887; mul 37 5251;
mul 23 5254; sub 6889 6890; mul 23 1621; add 6891 6892; mul 37 5263; add 6893 6894; mul 23 5459; mul 37 5456; sub
6896 6897; mul 23 2299; add 6898 6899; mul 37 5468; add 6900 6901; mul 23 5613; mul 37 5615; sub 6903 6904; mul 23
2821; add 6905 6906; mul 37 5624; add 6907 6908; neg 4892; neg 5263; neg 5468; neg 5624; mul 388 403; mul 841 6914;
mul 388 451; mul 824 6916; add 6915 6917; mul 388 435; mul 730 6919; add 6918 6920; mul 388 399; mul 857 6922; add
6921 6923; neg 6924; mul 1586 6916; mul 1601 6914; sub 6926 6927; mul 1433 6919; add 6928 6929; mul 1617 6922; sub
6930 6931; mul 2279 6914; mul 2263 6916; add 6933 6934; mul 2187 6919; add 6935 6936; mul 2295 6922; add 6937 6938;
neg 6939; mul 2811 6914; mul 2797 6916; add 6941 6942; mul 2817 6922; add 6943 6944; neg 6945; mul 409 843; mul 409
1603; neg 6948; mul 409 2281; neg 1580; mul 416 815; mul 416 1580; neg 6953; mul 416 2257; mul 432 796; mul 424
6956; neg 6957; mul 432 1559; mul 424 6959; mul 432 2248; mul 424 6961; neg 6962; input p 228; mul 414 800; mul 6964
6965; add 800 6966; input p 229; mul 6965 6968; mul 348 6969; add 6967 6970; neg 6971; mul 414 1575; mul 6964 6973;
add 1575 6974; mul 6968 6973; mul 348 6976; add 6975 6977; mul 414 2252; mul 6964 6979; add 2252 6980; mul 6968
6979; mul 348 6982; add 6981 6983; neg 6984; mul 458 730; mul 437 6986; mul 458 1433; mul 437 6988; neg 6989; mul
458 2187; mul 437 6991; mul 440 6986; mul 440 6988; neg 6994; mul 440 6991; mul 444 6986; mul 444 6988; neg 6998;
mul 444 6991; mul 458 786; mul 458 1564; neg 7002; mul 458 2238; mul 23 4865; mul 37 4861; add 7005 7006; mul 37
722; add 7007 7008; mul 23 4876; sub 7009 7010; mul 37 1514; mul 23 5236; mul 37 5239; add 7013 7014; sub 7012 7015;
mul 23 5248; sub 7016 7017; mul 23 5443; mul 37 5439; add 7019 7020; mul 37 2179; add 7021 7022; mul 23 5453; sub
7023 7024; mul 23 5654; mul 37 5656; add 7026 7027; mul 37 2998; add 7028 7029; mul 23 5665; sub 7030 7031; mul 23
4861; mul 37 4865; sub 7033 7034; mul 23 722; add 7035 7036; mul 37 4876; add 7037 7038; mul 37 5236; mul 23 5239;
sub 7040 7041; mul 23 1514; add 7042 7043; mul 37 5248; add 7044 7045; mul 23 5439; mul 37 5443; sub 7047 7048; mul
23 2179; add 7049 7050; mul 37 5453; add 7051 7052; mul 23 5656; mul 37 5654; sub 7054 7055; mul 23 2998; add 7056
7057; mul 37 5665; add 7058 7059; mul 504 519; mul 702 7061; mul 504 563; mul 685 7063; add 7062 7064; mul 504 548;
mul 629 7066; add 7065 7067; mul 504 515; mul 718 7069; add 7068 7070; neg 7071; mul 1468 7063; mul 1490 7061; sub
7073 7074; mul 1426 7066; add 7075 7076; mul 1506 7069; sub 7077 7078; mul 2159 7061; mul 2143 7063; add 7080 7081;
mul 2103 7066; add 7082 7083; mul 2175 7069; add 7084 7085; neg 7086; mul 2988 7061; mul 2974 7063; add 7088 7089;
mul 2994 7069; add 7090 7091; neg 7092; mul 525 704; mul 525 1492; neg 7095; mul 525 2161; neg 1462; mul 529 676;
mul 529 1462; neg 7100; mul 529 2137; mul 545 657; mul 537 7103; neg 7104; mul 545 1441; mul 537 7106; mul 545 2128;
mul 537 7108; neg 7109; input p 230; mul 527 661; mul 7111 7112; add 661 7113; input p 231; mul 7112 7115; mul 348
7116; add 7114 7117; neg 7118; mul 527 1457; mul 7111 7120; add 1457 7121; mul 7115 7120; mul 348 7123; add 7122
7124; mul 527 2132; mul 7111 7126; add 2132 7127; mul 7115 7126; mul 348 7129; add 7128 7130; neg 7131; mul 568 629;
mul 550 7133; mul 568 1426; mul 550 7135; neg 7136; mul 568 2103; mul 550 7138; mul 553 7133; mul 553 7135; neg
7141; mul 553 7138; mul 557 7133; mul 557 7135; neg 7145; mul 557 7138; mul 568 647; mul 568 1446; neg 7149; mul 568
2118; mul 617 5008; sub 7152 89; mul 4994 7153; mul 1410 5008; sub 617 7155; mul 4994 7156; mul 1419 5008; sub 7158
621; mul 4994 7159; mul 4997 7153; mul 4997 7156; mul 4997 7159; mul 5001 7153; mul 5001 7156; mul 5001 7159; mul
5005 7153; mul 5005 7156; mul 5005 7159; mul 6815 6824; mul 6824 7170; neg 7171; where 6823 7172; mul 6815 6833; mul
6833 7174; neg 7175; where 6832 7176; mul 6815 6842; mul 6842 7178; neg 7179; where 6841 7180; mul 6815 6851; mul
6851 7182; neg 7183; where 6850 7184; mul 89 5067; neg 7186; mul 617 5067; mul 621 5067; neg 7189; mul 89 5071; neg
7191; mul 617 5071; mul 621 5071; neg 7194; mul 90 1404; neg 7196; mul 90 2085; mul 90 2768; neg 7199; store by_k
100 1406; store by_k 300 2087; store by_k 500 2770; store by_k 600 2958; store by_k 700 3146; store by_k 800 2958;
store by_k 900 3146; store by_k 1000 2958; store by_k 1100 3146; store by_k 101 3297; store by_k 301 3312; store
by_k 501 3328; store by_k 102 3344; store by_k 302 3354; store by_k 502 3364; store by_k 103 3499; store by_k 303
3607; store by_k 503 3715; store by_k 104 3881; store by_k 304 4009; store by_k 504 4137; store by_k 105 4223; store
by_k 305 4291; store by_k 505 4359; store by_k 605 4427; store by_k 705 4495; store by_k 805 4427; store by_k 905
4495; store by_k 1005 4427; store by_k 1105 4495; store by_k 106 4572; store by_k 306 4646; store by_k 506 4720;
store by_k 107 4729; store by_k 307 4738; store by_k 507 4747; store by_k 607 4750; store by_k 707 4753; store by_k
807 4750; store by_k 907 4753; store by_k 1007 4750; store by_k 1107 4753; store by_k 108 4762; store by_k 308 4771;
store by_k 508 4780; store by_k 608 4783; store by_k 708 4786; store by_k 808 4783; store by_k 908 4786; store by_k
1008 4783; store by_k 1108 4786; store by_k 109 4795; store by_k 309 4801; store by_k 509 4810; store by_k 609 4813;
store by_k 709 4816; store by_k 809 4813; store by_k 909 4816; store by_k 1009 4813; store by_k 1109 4816; store
by_k 110 5199; store by_k 310 5405; store by_k 510 5612; store by_k 610 5653; store by_k 710 5694; store by_k 810
5653; store by_k 910 5694; store by_k 1010 5653; store by_k 1110 5694; store by_k 111 5698; store by_k 311 5701;
store by_k 511 5705; store by_k 112 5712; store by_k 312 5719; store by_k 512 5726; store by_k 113 5734; store by_k
313 5739; store by_k 513 5747; store by_k 114 5755; store by_k 314 5763; store by_k 514 5771; store by_k 115 5782;
store by_k 315 5791; store by_k 515 5802; store by_k 116 5811; store by_k 316 5817; store by_k 516 5826; store by_k
117 5833; store by_k 317 5840; store by_k 517 5847; store by_k 118 5858; store by_k 318 5867; store by_k 518 5878;
store by_k 119 5889; store by_k 319 5897; store by_k 519 5908; store by_k 120 5915; store by_k 320 5919; store by_k
520 5926; store by_k 121 5929; store by_k 321 5933; store by_k 521 5936; store by_k 122 5943; store by_k 322 5949;
store by_k 522 5956; store by_k 123 5964; store by_k 323 5971; store by_k 523 5979; store by_k 124 5985; store by_k
324 5990; store by_k 524 5996; store by_k 125 5999; store by_k 325 6001; store by_k 525 6004; store by_k 126 6012;
store by_k 326 6018; store by_k 526 6026; store by_k 127 6037; store by_k 327 6047; store by_k 527 6058; store by_k
128 6068; store by_k 328 6075; store by_k 528 6085; store by_k 129 6096; store by_k 329 6106; store by_k 529 6117;
store by_k 130 6129; store by_k 330 6139; store by_k 530 6151; store by_k 131 6161; store by_k 331 6168; store by_k
531 6178; store by_k 132 6185; store by_k 332 6192; store by_k 532 6199; store by_k 133 6208; store by_k 333 6216;
store by_k 533 6225; store by_k 134 6234; store by_k 334 6241; store by_k 534 6250; store by_k 135 6256; store by_k
335 6260; store by_k 535 6266; store by_k 136 6305; store by_k 336 6342; store by_k 536 6376; store by_k 137 6377;
store by_k 337 6378; store by_k 537 6379; store by_k 138 5108; store by_k 338 5320; store by_k 538 5527; store by_k
139 6380; store by_k 339 6381; store by_k 539 6382; store by_k 140 6301; store by_k 340 6338; store by_k 540 6372;
store by_k 141 6406; store by_k 341 6428; store by_k 541 6451; store by_k 641 6455; store by_k 741 6459; store by_k
841 6455; store by_k 941 6459; store by_k 1041 6455; store by_k 1141 6459; store by_k 142 6473; store by_k 342 6487;
store by_k 542 6501; store by_k 642 6506; store by_k 742 6511; store by_k 842 6506; store by_k 942 6511; store by_k
1042 6506; store by_k 1142 6511; store by_k 143 6516; store by_k 343 6521; store by_k 543 6526; store by_k 643 6527;
store by_k 743 6528; store by_k 843 6527; store by_k 943 6528; store by_k 1043 6527; store by_k 1143 6528; store
by_k 144 6554; store by_k 344 6579; store by_k 544 6605; store by_k 644 6610; store by_k 744 6615; store by_k 844
6610; store by_k 944 6615; store by_k 1044 6610; store by_k 1144 6615; store by_k 145 6626; store by_k 345 6637;
store by_k 545 6648; store by_k 645 6651; store by_k 745 6654; store by_k 845 6651; store by_k 945 6654; store by_k
1045 6651; store by_k 1145 6654; store by_k 146 6659; store by_k 346 6664; store by_k 546 6669; store by_k 646 6670;
store by_k 746 6671; store by_k 846 6670; store by_k 946 6671; store by_k 1046 6670; store by_k 1146 6671; store
by_k 147 6674; store by_k 347 6677; store by_k 547 6680; store by_k 148 6689; store by_k 348 6698; store by_k 548
6707; store by_k 149 89; store by_k 349 6708; store by_k 549 621; store by_k 650 6709; store by_k 750 6710; store
by_k 851 6711; store by_k 951 6712; store by_k 1052 6713; store by_k 1152 6714; store by_k 153 6729; store by_k 353
6743; store by_k 553 6756; store by_k 653 6762; store by_k 753 6768; store by_k 853 6762; store by_k 953 6768; store
by_k 1053 6762; store by_k 1153 6768; store by_k 154 6776; store by_k 354 6778; store by_k 554 6781; store by_k 155
6783; store by_k 355 6784; store by_k 555 6786; store by_k 156 6789; store by_k 356 6791; store by_k 556 6794; store
by_k 157 6801; store by_k 357 6805; store by_k 557 6808; store by_k 158 6809; store by_k 358 6811; store by_k 558
6812; store by_k 1458 6826; store by_k 1558 6835; store by_k 1658 6844; store by_k 1758 6853; store by_k 159 6860;
store by_k 359 6867; store by_k 559 6874; store by_k 659 6881; store by_k 859 6881; store by_k 1059 6881; store by_k
160 6888; store by_k 360 6895; store by_k 560 6902; store by_k 660 6909; store by_k 860 6909; store by_k 1060 6909;
store by_k 161 6910; store by_k 361 6911; store by_k 561 6912; store by_k 661 6913; store by_k 861 6913; store by_k
1061 6913; store by_k 162 861; store by_k 362 1621; store by_k 562 2299; store by_k 662 2821; store by_k 862 2821;
store by_k 1062 2821; store by_k 163 6925; store by_k 363 6932; store by_k 563 6940; store by_k 663 6946; store by_k
863 6946; store by_k 1063 6946; store by_k 164 6947; store by_k 364 6949; store by_k 564 6950; store by_k 165 815;
store by_k 365 6951; store by_k 565 2257; store by_k 166 6952; store by_k 366 6954; store by_k 566 6955; store by_k
167 6958; store by_k 367 6960; store by_k 567 6963; store by_k 168 6972; store by_k 368 6978; store by_k 568 6985;
store by_k 169 6987; store by_k 369 6990; store by_k 569 6992; store by_k 170 6993; store by_k 370 6995; store by_k
570 6996; store by_k 171 6997; store by_k 371 6999; store by_k 571 7000; store by_k 172 7001; store by_k 372 7003;
store by_k 572 7004; store by_k 173 7011; store by_k 373 7018; store by_k 573 7025; store by_k 773 7032; store by_k
973 7032; store by_k 1173 7032; store by_k 174 7039; store by_k 374 7046; store by_k 574 7053; store by_k 774 7060;
store by_k 974 7060; store by_k 1174 7060; store by_k 175 4876; store by_k 375 5248; store by_k 575 5453; store by_k
775 5665; store by_k 975 5665; store by_k 1175 5665; store by_k 176 722; store by_k 376 1514; store by_k 576 2179;
store by_k 776 2998; store by_k 976 2998; store by_k 1176 2998; store by_k 177 7072; store by_k 377 7079; store by_k
577 7087; store by_k 777 7093; store by_k 977 7093; store by_k 1177 7093; store by_k 178 7094; store by_k 378 7096;
store by_k 578 7097; store by_k 179 676; store by_k 379 7098; store by_k 579 2137; store by_k 180 7099; store by_k
380 7101; store by_k 580 7102; store by_k 181 7105; store by_k 381 7107; store by_k 581 7110; store by_k 182 7119;
store by_k 382 7125; store by_k 582 7132; store by_k 183 7134; store by_k 383 7137; store by_k 583 7139; store by_k
184 7140; store by_k 384 7142; store by_k 584 7143; store by_k 185 7144; store by_k 385 7146; store by_k 585 7147;
store by_k 186 7148; store by_k 386 7150; store by_k 586 7151; store by_k 187 7154; store by_k 387 7157; store by_k
587 7160; store by_k 188 7161; store by_k 388 7162; store by_k 588 7163; store by_k 189 7164; store by_k 389 7165;
store by_k 589 7166; store by_k 190 7167; store by_k 390 7168; store by_k 590 7169; store by_k 1491 7173; store by_k
1592 7177; store by_k 1693 7181; store by_k 1794 7185; store by_k 195 7187; store by_k 395 7188; store by_k 595
7190; store by_k 196 7192; store by_k 396 7193; store by_k 596 7195; store by_k 1297 5067; store by_k 1398 5071;
store by_k 199 7197; store by_k 399 7198; store by_k 599 7200
    """,
)
