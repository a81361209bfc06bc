"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 90},
    {'p': 231},
    """
input k 28; input k 29; constant 1.0; input k 10; sub 3 2; input k 26; input k 38; input k 32; input k 33; input k
35; input k 30; input k 34; input k 36; input k 31; input k 27; input k 89; input k 0; div 2 16; mul 15 17; constant
0.5; constant -2.0; input k 2; mul 20 21; input k 44; input k 1; constant -6.000000000000002; constant
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
constant 4.0; mul 24 164; input k 11; mul 165 166; constant 3.0; mul 24 168; input k 12; mul 169 170; input k 13;
mul 169 172; constant 2.0; mul 24 174; input k 14; mul 175 176; input k 15; mul 175 178; input k 16; mul 175 180;
input k 17; mul 24 182; input k 18; mul 24 184; input k 19; mul 24 186; input k 20; mul 24 188; input k 37; input k
54; input k 49; input k 51; input k 50; input k 52; sub 195 16; constant -0.0006802721088435403; input k 5; mul 197
198; constant 0.0035714285714285787; mul 198 200; constant 0.029931972789115628; mul 198 202; constant
-0.08571428571428567; mul 198 204; constant 0.12857142857142853; mul 198 206; constant -0.38571428571428534; mul 198
208; constant 1.0285714285714285; mul 198 210; constant -0.0004787100025195255; mul 198 212; constant
0.0027210884353741486; mul 198 214; constant -0.010714285714285721; mul 198 216; constant 0.028571428571428567; mul
198 218; constant 0.010714285714285735; mul 198 220; constant -0.04285714285714284; mul 198 222; constant
-0.12857142857142845; mul 198 224; constant 0.00032473894907757275; mul 198 226; constant -0.0014361300075585765;
mul 198 228; constant -0.003571428571428574; mul 198 230; constant -0.0013605442176870806; mul 198 232; input k 53;
div 2 234; input k 55; input k 56; input k 57; input k 58; mul 19 239; constant 0.7142857142857143; sub 239 241; mul
240 242; input k 59; input k 60; input k 61; input k 43; mul 19 247; sub 247 241; mul 248 249; input k 62; input k
68; input k 64; input k 63; input k 65; input k 66; sub 256 16; input k 67; div 2 258; input k 69; input k 70; input
k 71; input k 72; mul 19 263; sub 263 241; mul 264 265; input k 73; input k 74; input k 75; input k 76; constant
-6.0; input k 39; input k 77; input k 78; input k 79; input k 80; input k 45; input k 46; input k 47; mul 279 279;
input k 85; input k 86; mul 3 174; mul 24 170; mul 24 178; mul 169 182; mul 175 184; input k 21; mul 165 288; input
k 22; mul 169 290; input k 23; mul 175 292; input k 24; mul 24 294; mul 6 190; input k 48; constant
0.8000000000000002; constant 2.400000000000001; mul 30 299; add 298 300; constant 0.01904761904761903; mul 35 302;
add 301 303; constant -1.3714285714285723; mul 42 305; constant 1.3714285714285714; mul 29 307; constant
0.007256235827664418; mul 34 309; add 308 310; constant -4.799999999999999; mul 42 312; constant 1.3714285714285692;
mul 29 314; constant -0.05714285714285729; mul 34 316; add 315 317; constant -7.199999999999996; mul 42 319;
constant 7.199999999999994; mul 29 321; constant 0.2190476190476189; mul 34 323; add 322 324; constant
-45.25714285714286; mul 29 326; constant -0.11428571428571327; mul 34 328; add 327 329; constant
-28.800000000000004; mul 42 331; mul 24 172; mul 175 186; mul 169 188; mul 24 290; mul 169 294; input k 25; mul 165
338; constant 0.8; mul 21 340; input k 40; input k 41; input k 42; input k 87; input k 88; input k 81; div 2 347;
input k 82; div 2 349; input k 83; div 2 351; input k 84; div 2 353; mul 17 38; mul 37 355; mul 17 67; mul 118 355;
mul 17 37; mul 13 16; add 281 282; mul 104 355; mul 17 113; mul 271 355; add 363 364; mul 21 365; mul 17 271; mul
164 355; add 367 368; mul 21 369; mul 38 370; add 366 371; mul 39 370; mul 40 370; mul 37 39; mul 39 118; mul 7 16;
mul 39 104; mul 39 271; mul 21 379; mul 39 164; mul 21 381; mul 38 382; add 380 383; mul 39 382; mul 40 382; mul 297
348; mul 297 350; mul 297 352; mul 297 354; mul 37 40; mul 40 118; mul 11 16; mul 40 104; mul 40 164; mul 21 395;
mul 39 396; mul 40 271; mul 21 398; mul 38 396; add 399 400; mul 40 396; add 341 402; neg 342; neg 343; neg 344; neg
345; neg 346; mul 273 297; mul 274 297; mul 275 297; mul 276 297; mul 17 18; mul 27 174; mul 174 279; store p 0 0;
store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7; store p 7 8; store p 8 9; store p 9
10; store p 10 11; store p 11 12; store p 12 13; store p 13 14; store p 14 18; store p 15 22; store p 16 23; store p
17 17; store p 18 24; store p 19 37; store p 20 38; store p 21 39; store p 22 40; store p 23 43; store p 24 48;
store p 25 50; store p 26 55; store p 27 60; store p 28 67; store p 29 69; store p 30 74; store p 31 76; store p 32
81; store p 33 86; store p 34 91; store p 35 96; store p 36 102; store p 37 104; store p 38 106; store p 39 111;
store p 40 118; store p 41 120; store p 42 125; store p 43 129; store p 44 134; store p 45 139; store p 46 141;
store p 47 146; store p 48 151; store p 49 153; store p 50 158; store p 51 163; store p 52 167; store p 53 171;
store p 54 173; store p 55 177; store p 56 179; store p 57 181; store p 58 183; store p 59 185; store p 60 187;
store p 61 189; store p 62 16; store p 63 199; store p 64 201; store p 65 203; store p 66 205; store p 67 207; store
p 68 209; store p 69 211; store p 70 213; store p 71 215; store p 72 217; store p 73 219; store p 74 221; store p 75
223; store p 76 225; store p 77 190; store p 78 196; store p 79 227; store p 80 229; store p 81 231; store p 82 233;
store p 83 194; store p 84 192; store p 85 235; store p 86 193; store p 87 191; store p 88 236; store p 89 237;
store p 90 238; store p 91 239; store p 92 243; store p 93 244; store p 94 245; store p 95 246; store p 96 247;
store p 97 250; store p 98 251; store p 99 257; store p 100 253; store p 101 254; store p 102 259; store p 103 255;
store p 104 252; store p 105 260; store p 106 261; store p 107 262; store p 108 263; store p 109 266; store p 110
267; store p 111 268; store p 112 269; store p 113 270; store p 114 21; store p 115 272; store p 116 273; store p
117 274; store p 118 275; store p 119 276; store p 120 277; store p 121 278; store p 122 280; store p 123 281; store
p 124 282; store p 125 283; store p 126 284; store p 127 285; store p 128 286; store p 129 287; store p 130 289;
store p 131 291; store p 132 293; store p 133 295; store p 134 296; store p 135 297; store p 136 304; store p 137
306; store p 138 311; store p 139 313; store p 140 318; store p 141 320; store p 142 325; store p 143 330; store p
144 332; store p 145 333; store p 146 334; store p 147 335; store p 148 336; store p 149 337; store p 150 339; store
p 151 341; store p 152 342; store p 153 343; store p 154 344; store p 155 345; store p 156 346; store p 157 348;
store p 158 350; store p 159 352; store p 160 354; store p 161 356; store p 162 355; store p 163 357; store p 164
358; store p 165 359; store p 166 360; store p 167 361; store p 168 362; store p 169 372; store p 170 373; store p
171 374; store p 172 375; store p 173 376; store p 174 377; store p 175 378; store p 176 384; store p 177 385; store
p 178 386; store p 179 387; store p 180 388; store p 181 389; store p 182 390; store p 183 391; store p 184 392;
store p 185 393; store p 186 394; store p 187 397; store p 188 401; store p 189 403; store p 190 404; store p 191
405; store p 192 406; store p 193 407; store p 194 408; store p 195 409; store p 196 410; store p 197 411; store p
198 412; store p 199 413; store p 200 292; store p 201 338; store p 202 294; store p 203 290; store p 204 188; store
p 205 186; store p 206 184; store p 207 180; store p 208 178; store p 209 172; store p 210 288; store p 211 182;
store p 212 176; store p 213 170; store p 214 166; store p 215 28; store p 216 27; store p 217 99; store p 218 29;
store p 219 414; store p 220 34; store p 221 165; store p 222 169; store p 223 175; store p 224 248; store p 225
249; store p 226 415; store p 227 240; store p 228 242; store p 229 264; store p 230 265
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 231},
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
270; input p 52; constant -0.35; max 273 148; min 270 274; mul 275 275; mul 275 276; mul 272 277; input p 53;
constant 0.6; constant -0.6; max 281 3; min 280 282; mul 276 283; mul 279 284; add 278 285; input p 54; constant
2.0; constant -2.0; max 289 35; min 288 290; mul 276 291; mul 287 292; add 286 293; input p 55; mul 275 283; mul 283
296; mul 295 297; add 294 298; input p 56; mul 291 296; mul 300 301; add 299 302; input p 57; mul 275 291; mul 291
305; mul 304 306; add 303 307; input p 58; mul 283 283; mul 283 310; mul 309 311; add 308 312; input p 59; mul 291
310; mul 314 315; add 313 316; input p 60; mul 283 291; mul 291 319; mul 318 320; add 317 321; input p 61; mul 291
291; mul 291 324; mul 323 325; add 322 326; where 271 327; add 268 328; input p 62; mul 67 330; input p 63; mul 162
332; input p 64; mul 174 334; add 333 335; input p 65; mul 185 337; add 336 338; input p 66; mul 193 340; add 339
341; input p 67; mul 197 343; add 342 344; input p 68; mul 202 346; add 345 347; input p 69; mul 206 349; add 348
350; input p 70; mul 218 352; input p 71; mul 162 354; add 353 355; input p 72; mul 170 357; add 356 358; input p
73; mul 174 360; add 359 361; mul 185 332; add 362 363; input p 74; mul 197 365; add 364 366; input p 75; mul 258
368; add 367 369; mul 202 343; add 370 371; input p 76; mul 206 373; add 372 374; mul 147 375; add 351 376; mul 330
377; add 331 378; input p 77; input p 78; mul 29 67; mul 3 37; add 382 383; mul 35 53; add 384 385; mul 104 386;
constant 0.25; mul 148 351; mul 155 375; add 389 390; input p 79; mul 218 392; input p 80; mul 162 394; add 393 395;
mul 170 354; add 396 397; input p 81; mul 174 399; add 398 400; input p 82; mul 193 402; add 401 403; mul 258 337;
add 404 405; mul 202 368; add 406 407; mul 35 408; add 391 409; mul 388 410; mul 330 411; add 387 412; add 381 413;
input p 83; mul 24 415; add 414 416; input p 84; mul 38 418; sub 417 419; input p 85; mul 24 418; input p 86; sub
422 423; mul 38 415; add 424 425; sub 426 29; mul 427 427; mul 420 420; add 428 429; sqrt 430; mul 421 431; sqrt
432; div 2 433; mul 434 434; mul 421 435; mul 420 436; input p 87; mul 288 432; mul 288 435; mul 435 440; sub 439
441; mul 438 442; constant 0.3; constant -0.3; constant 1.4; sub 432 446; max 445 447; min 444 448; input p 88;
input p 89; mul 449 451; add 450 452; mul 449 453; add 2 454; mul 443 455; input p 90; mul 93 457; input p 91; input
p 92; mul 447 460; add 459 461; mul 447 462; add 2 463; mul 458 464; sub 456 465; mul 421 466; input p 93; input x
6; mul 468 469; input p 94; input x 8; mul 471 472; add 470 473; input p 95; input x 10; mul 475 476; add 474 477;
constant -0.5; mul 434 479; mul 434 480; mul 434 481; mul 421 482; input p 96; input p 97; mul 447 485; add 484 486;
mul 447 487; add 2 488; mul 483 489; mul 478 490; add 467 491; input p 98; mul 490 493; mul 490 494; sub 416 419;
mul 427 496; add 422 425; mul 420 498; sub 497 499; mul 436 500; mul 17 501; mul 130 502; mul 427 436; mul 0 504;
sub 503 505; mul 0 144; mul 379 507; mul 150 375; mul 330 509; add 37 510; mul 130 511; add 508 512; mul 153 375;
add 408 514; mul 330 515; add 53 516; input x 5; mul 517 518; add 513 519; mul 437 520; add 506 521; mul 495 522;
add 492 523; mul 437 524; input p 99; add 413 526; input p 100; mul 24 528; add 527 529; input p 101; mul 38 531;
add 530 532; input p 102; mul 38 528; mul 24 531; input p 103; sub 536 537; sub 535 538; sub 539 29; mul 540 540;
mul 533 533; add 541 542; sqrt 543; mul 534 544; sqrt 545; div 2 546; mul 547 547; mul 534 548; mul 533 549; input p
104; mul 288 545; mul 288 548; mul 548 553; sub 552 554; mul 551 555; sub 545 446; max 445 557; min 444 558; input p
105; input p 106; mul 559 561; add 560 562; mul 559 563; add 2 564; mul 556 565; input p 107; mul 97 567; input p
108; input p 109; mul 557 570; add 569 571; mul 557 572; add 2 573; mul 568 574; sub 566 575; mul 534 576; input p
110; input x 7; mul 578 579; input p 111; input x 9; mul 581 582; add 580 583; input p 112; input x 11; mul 585 586;
add 584 587; mul 479 547; mul 547 589; mul 547 590; mul 534 591; mul 485 557; add 484 593; mul 557 594; add 2 595;
mul 592 596; mul 588 597; add 577 598; input p 113; mul 597 600; mul 597 601; add 529 532; mul 540 603; sub 536 535;
mul 533 605; add 604 606; mul 549 607; mul 17 608; mul 130 609; mul 540 549; mul 0 611; sub 610 612; mul 520 550;
add 613 614; mul 602 615; add 599 616; mul 550 617; add 525 618; sub 380 619; mul 379 620; sub 329 621; input p 114;
constant 12.0; mul 507 624; constant -6.0; mul 147 507; mul 130 150; add 627 628; mul 153 518; add 629 630; mul 626
631; add 625 632; mul 623 633; mul 507 626; constant 4.0; mul 631 636; add 635 637; mul 623 638; mul 147 639; add
634 640; add 622 641; mul 144 642; mul 504 524; mul 611 617; add 644 645; sub 643 646; sub 143 647; input p 115;
input p 116; input z 0; mul 650 651; input p 117; input z 1; mul 653 654; add 652 655; input p 118; input z 2; mul
657 658; add 656 659; input p 119; input z 3; mul 661 662; add 660 663; sub 649 664; input p 120; abs 0; mul 666
667; mul 0 668; input p 121; mul 0 670; mul 0 0; input p 122; add 672 673; sqrt 674; div 2 675; mul 671 676; add 669
677; sub 665 678; add 648 679; input p 123; input x 12; sub 29 682; mul 681 683; input p 124; input x 13; sub 29
686; mul 685 687; add 684 688; sub 680 689; mul 0 62; mul 28 130; add 691 692; mul 47 518; add 693 694; mul 0 695;
mul 0 28; mul 31 130; add 697 698; mul 34 518; add 699 700; mul 130 701; add 696 702; mul 0 47; mul 34 130; add 704
705; mul 51 518; add 706 707; mul 518 708; add 703 709; mul 17 130; mul 130 711; mul 23 712; input p 125; mul 9 714;
mul 9 715; mul 8 16; mul 10 717; mul 717 718; add 716 719; mul 3 720; mul 38 721; sub 25 722; mul 713 723; add 710
724; mul 67 725; mul 24 721; add 39 727; mul 713 728; sub 726 729; mul 22 730; sub 690 731; mul 90 732; mul 81 89;
mul 150 265; mul 145 735; abs 3; lt 737 280; input p 126; mul 277 739; mul 284 295; add 740 741; input p 127; mul
292 743; add 742 744; input p 128; mul 297 746; add 745 747; input p 129; mul 301 749; add 748 750; mul 306 318; add
751 752; input p 130; mul 311 754; add 753 755; input p 131; mul 315 757; add 756 758; input p 132; mul 320 760; add
759 761; input p 133; mul 325 763; add 762 764; where 738 765; add 736 766; mul 511 620; sub 767 768; mul 150 639;
add 769 770; mul 502 524; mul 609 617; add 772 773; add 771 774; sub 134 775; input p 134; mul 38 777; mul 17 778;
add 776 779; input p 135; mul 664 781; sub 780 782; mul 41 725; mul 26 729; sub 784 785; mul 22 786; mul 19 721; mul
712 788; sub 787 789; sub 783 790; mul 734 791; sub 733 792; mul 86 89; input p 136; mul 35 795; input p 137; mul
214 797; add 796 798; input p 138; mul 218 800; add 799 801; mul 155 210; add 802 803; input p 139; mul 158 805; add
804 806; input p 140; mul 162 808; add 807 809; input p 141; mul 166 811; add 810 812; mul 170 227; add 813 814;
input p 142; mul 174 816; add 815 817; mul 157 189; add 818 819; input p 143; mul 193 821; add 820 822; mul 169 197;
add 823 824; input p 144; mul 201 826; add 825 827; mul 184 258; add 828 829; mul 202 257; add 830 831; mul 153 265;
add 832 833; mul 145 834; abs 35; lt 836 288; input p 145; mul 277 838; mul 284 743; add 839 840; mul 292 304; add
841 842; mul 297 314; add 843 844; input p 146; mul 301 846; add 845 847; input p 147; mul 306 849; add 848 850;
input p 148; mul 311 852; add 851 853; mul 315 760; add 854 855; input p 149; mul 320 857; add 856 858; input p 150;
mul 325 860; add 859 861; where 837 862; add 835 863; mul 517 620; sub 864 865; input p 151; mul 518 867; mul 153
639; add 868 869; add 866 870; mul 53 725; mul 22 872; add 871 873; mul 794 874; sub 793 875; mul 56 70; mul 79 79;
sub 877 878; mul 89 879; mul 791 880; mul 732 734; sub 881 882; mul 59 70; mul 76 79; sub 884 885; mul 89 886; mul
874 887; add 883 888; mul 732 794; mul 791 887; sub 890 891; mul 45 70; mul 76 76; sub 893 894; mul 89 895; mul 874
896; sub 892 897; mul 490 522; input p 152; mul 469 900; sub 899 901; mul 597 615; mul 579 900; sub 903 904; input p
153; mul 472 906; sub 899 907; mul 582 906; sub 903 909; input p 154; mul 476 911; sub 899 912; mul 586 911; sub 903
914; input p 155; mul 683 916; input p 156; mul 687 918; le 2 651; mul 130 781; add 0 921; lt 140 922; and 920 923;
constant -1.0; le 651 925; lt 922 140; and 926 927; or 924 928; not 929; input p 157; mul 922 931; where 930 932; le
2 654; and 923 934; le 654 925; and 927 936; or 935 937; not 938; input p 158; mul 922 940; where 939 941; le 2 658;
and 923 943; le 658 925; and 927 945; or 944 946; not 947; input p 159; mul 922 949; where 948 950; le 2 662; and
923 952; le 662 925; and 927 954; or 953 955; not 956; input p 160; mul 922 958; where 957 959; mul 41 288; mul 28
961; mul 22 962; mul 56 963; mul 53 288; mul 47 965; mul 22 966; mul 45 967; add 964 968; mul 28 53; mul 41 47; add
970 971; mul 22 972; mul 59 973; add 974 974; sub 969 975; mul 89 976; mul 89 90; mul 67 288; mul 62 979; mul 22
980; mul 61 981; mul 70 976; add 982 983; mul 41 62; mul 28 67; add 985 986; mul 22 987; mul 81 988; mul 56 988; mul
76 967; add 990 991; mul 79 973; mul 47 67; mul 53 62; add 994 995; mul 22 996; mul 59 997; add 993 998; sub 992
999; mul 76 1000; add 989 1001; sub 984 1002; mul 86 997; mul 59 988; mul 76 973; add 1005 1006; mul 79 963; mul 45
997; add 1008 1009; sub 1007 1010; mul 79 1011; add 1004 1012; add 1003 1013; mul 978 1014; sub 977 1015; mul 732
1016; mul 100 106; mul 102 1018; mul 100 114; sub 1019 1020; mul 100 118; mul 100 1022; sub 1021 1023; input p 161;
input p 162; mul 35 1026; mul 157 1027; add 1025 1028; mul 35 1027; mul 161 1030; add 1029 1031; mul 155 288; mul
1026 1033; mul 165 1034; add 1032 1035; mul 35 1034; mul 169 1037; add 1036 1038; mul 155 1034; mul 166 1026; add
1040 1041; mul 173 1042; add 1039 1043; input p 163; add 1044 1045; mul 35 144; mul 180 1047; add 1046 1048; mul 35
1047; mul 184 1050; add 1049 1051; mul 144 155; mul 148 1026; add 1053 1054; mul 188 1055; add 1052 1056; mul 35
1055; mul 192 1058; add 1057 1059; mul 155 1055; mul 189 1026; add 1061 1062; mul 196 1063; add 1060 1064; mul 148
288; mul 144 1066; mul 155 1067; mul 201 1026; add 1068 1069; mul 200 1070; add 1065 1071; mul 148 1067; mul 144
201; add 1073 1074; mul 205 1075; add 1072 1076; input p 164; mul 224 1027; add 1078 1079; mul 227 1030; add 1080
1081; mul 230 1034; add 1082 1083; mul 233 1037; add 1084 1085; mul 236 1042; add 1086 1087; input p 165; add 1088
1089; mul 157 1047; add 1090 1091; mul 161 1050; add 1092 1093; mul 245 1055; add 1094 1095; mul 248 1058; add 1096
1097; mul 251 1063; add 1098 1099; mul 254 1067; add 1100 1101; mul 35 1067; mul 257 1103; add 1102 1104; mul 196
1070; add 1105 1106; mul 263 1075; add 1107 1108; mul 147 1109; add 1077 1110; mul 145 1111; mul 275 288; le 274
270; le 270 274; add 1114 1115; div 2 1116; mul 1114 1117; le 273 148; le 148 273; add 1119 1120; div 2 1121; mul
1119 1122; mul 144 1123; mul 1118 1124; mul 1113 1125; mul 275 1126; mul 276 1125; add 1127 1128; mul 272 1129; mul
283 1126; mul 279 1131; add 1130 1132; mul 291 1126; mul 287 1134; add 1133 1135; mul 283 1125; mul 283 1137; mul
295 1138; add 1136 1139; mul 291 1137; mul 300 1141; add 1140 1142; mul 291 1125; mul 291 1144; mul 304 1145; add
1143 1146; where 271 1147; add 1112 1148; input p 166; mul 332 1030; mul 334 1042; add 1151 1152; mul 337 1050; add
1153 1154; mul 340 1058; add 1155 1156; mul 343 1063; add 1157 1158; mul 346 1070; add 1159 1160; mul 349 1075; add
1161 1162; mul 354 1030; mul 357 1037; add 1164 1165; mul 360 1042; add 1166 1167; mul 332 1050; add 1168 1169; mul
365 1063; add 1170 1171; mul 368 1103; add 1172 1173; mul 343 1070; add 1174 1175; mul 373 1075; add 1176 1177; mul
147 1178; add 1163 1179; mul 330 1180; add 1150 1181; mul 620 1182; mul 288 420; add 63 67; add 64 1185; add 66
1186; mul 104 1187; mul 144 351; mul 148 1163; add 1189 1190; mul 375 1026; mul 155 1178; add 1192 1193; add 1191
1194; mul 394 1030; mul 354 1037; add 1196 1197; mul 399 1042; add 1198 1199; mul 402 1058; add 1200 1201; mul 337
1103; add 1202 1203; mul 368 1070; add 1204 1205; mul 35 1206; add 1195 1207; mul 388 1208; mul 330 1209; add 1188
1210; mul 1184 1211; mul 288 427; sub 1212 1213; mul 288 431; div 2 1215; mul 1214 1216; mul 421 1217; mul 288 1218;
mul 288 434; mul 288 433; div 2 1221; mul 1218 1222; mul 435 1223; mul 1220 1224; neg 1225; mul 288 1226; mul 435
1227; mul 440 1225; sub 1228 1229; sub 1219 1230; mul 438 1231; mul 455 1232; le 448 444; le 444 448; add 1234 1235;
div 2 1236; mul 1234 1237; le 445 447; le 447 445; add 1239 1240; div 2 1241; mul 1239 1242; mul 1218 1243; mul 1238
1244; mul 451 1245; mul 449 1246; mul 453 1245; add 1247 1248; mul 443 1249; add 1233 1250; mul 460 1218; mul 447
1252; mul 462 1218; add 1253 1254; mul 458 1255; sub 1251 1256; mul 421 1257; mul 485 1218; mul 447 1259; mul 487
1218; add 1260 1261; mul 483 1262; mul 481 1223; mul 434 1264; mul 482 1223; add 1265 1266; mul 434 1267; mul 434
482; mul 1223 1269; add 1268 1270; mul 421 1271; mul 489 1272; sub 1263 1273; mul 478 1274; add 1258 1275; mul 493
1274; mul 490 1277; mul 494 1274; add 1278 1279; mul 522 1280; mul 421 1225; mul 427 1282; add 436 1283; mul 0 1284;
mul 498 1211; add 496 1286; mul 436 1287; mul 500 1282; add 1288 1289; mul 17 1290; mul 130 1291; sub 1285 1292; mul
436 1211; mul 420 1282; sub 1294 1295; mul 520 1296; mul 507 1182; mul 150 1178; mul 330 1299; add 28 1300; mul 130
1301; add 1298 1302; mul 153 1178; add 1206 1304; mul 330 1305; add 47 1306; mul 518 1307; add 1303 1308; mul 437
1309; add 1297 1310; add 1293 1311; mul 495 1312; add 1281 1313; add 1276 1314; mul 437 1315; mul 524 1296; add 1316
1317; mul 288 533; mul 1211 1319; mul 288 540; sub 1320 1321; mul 288 544; div 2 1323; mul 1322 1324; mul 534 1325;
mul 288 1326; mul 288 547; mul 288 546; div 2 1329; mul 1326 1330; mul 548 1331; mul 1328 1332; neg 1333; mul 288
1334; mul 548 1335; mul 553 1333; sub 1336 1337; sub 1327 1338; mul 551 1339; mul 565 1340; le 558 444; le 444 558;
add 1342 1343; div 2 1344; mul 1342 1345; le 445 557; le 557 445; add 1347 1348; div 2 1349; mul 1347 1350; mul 1326
1351; mul 1346 1352; mul 561 1353; mul 559 1354; mul 563 1353; add 1355 1356; mul 556 1357; add 1341 1358; mul 570
1326; mul 557 1360; mul 572 1326; add 1361 1362; mul 568 1363; sub 1359 1364; mul 534 1365; mul 485 1326; mul 557
1367; mul 594 1326; add 1368 1369; mul 592 1370; mul 590 1331; mul 547 1372; mul 591 1331; add 1373 1374; mul 547
1375; mul 547 591; mul 1331 1377; add 1376 1378; mul 534 1379; mul 596 1380; sub 1371 1381; mul 588 1382; add 1366
1383; mul 600 1382; mul 597 1385; mul 601 1382; add 1386 1387; mul 615 1388; mul 605 1211; sub 1390 603; mul 549
1391; mul 534 1333; mul 607 1393; sub 1392 1394; mul 17 1395; mul 130 1396; mul 540 1393; add 549 1398; mul 0 1399;
add 1397 1400; mul 549 1211; mul 533 1393; sub 1402 1403; mul 520 1404; mul 550 1309; add 1405 1406; add 1401 1407;
mul 602 1408; add 1389 1409; add 1384 1410; mul 550 1411; mul 617 1404; add 1412 1413; add 1318 1414; mul 379 1415;
sub 1183 1416; sub 1149 1417; mul 144 1418; mul 504 1315; mul 524 1284; sub 1420 1421; mul 611 1411; mul 617 1399;
sub 1423 1424; add 1422 1425; sub 1419 1426; sub 1024 1427; input p 167; sub 1428 1429; mul 62 725; mul 22 1431; sub
1430 1432; mul 90 1433; add 1017 1434; mul 89 1000; mul 89 734; mul 1014 1437; sub 1436 1438; mul 791 1439; mul 150
1109; mul 145 1441; mul 739 1129; mul 295 1131; add 1443 1444; mul 743 1134; add 1445 1446; mul 746 1138; add 1447
1448; mul 749 1141; add 1449 1450; mul 318 1145; add 1451 1452; where 738 1453; add 1442 1454; mul 620 1301; mul 511
1415; sub 1456 1457; sub 1455 1458; mul 502 1315; mul 524 1291; sub 1460 1461; mul 609 1411; mul 617 1396; add 1463
1464; add 1462 1465; add 1459 1466; sub 1022 1467; mul 28 725; mul 22 1469; sub 1468 1470; mul 734 1471; add 1440
1472; sub 1435 1473; mul 89 1011; mul 89 794; mul 1014 1476; sub 1475 1477; mul 874 1478; input p 168; mul 805 1027;
add 1480 1481; mul 808 1030; add 1482 1483; mul 811 1034; add 1484 1485; mul 227 1037; add 1486 1487; mul 816 1042;
add 1488 1489; mul 157 1055; add 1490 1491; mul 821 1058; add 1492 1493; mul 169 1063; add 1494 1495; mul 826 1067;
add 1496 1497; mul 184 1103; add 1498 1499; mul 257 1070; add 1500 1501; mul 153 1109; add 1502 1503; mul 145 1504;
mul 838 1129; mul 743 1131; add 1506 1507; mul 304 1134; add 1508 1509; mul 314 1138; add 1510 1511; mul 846 1141;
add 1512 1513; mul 849 1145; add 1514 1515; where 837 1516; add 1505 1517; mul 620 1307; mul 517 1415; sub 1519
1520; sub 1518 1521; mul 47 725; mul 22 1523; add 1522 1524; mul 794 1525; add 1479 1526; sub 1474 1527; input c_q
0; mul 90 1529; le 140 139; le 139 140; add 1531 1532; div 2 1533; mul 1531 1534; mul 0 90; mul 1535 1536; input c_q
1; mul 1537 1538; sub 1530 1539; mul 90 93; input c_q 2; mul 1541 1542; add 1540 1543; mul 90 97; input c_q 3; mul
1545 1546; add 1544 1547; mul 90 100; add 734 1549; input c_q 4; mul 1550 1551; sub 1548 1552; mul 102 1550; input
c_q 5; mul 1554 1555; add 1553 1556; mul 93 1550; input c_q 6; mul 1558 1559; sub 1557 1560; mul 97 1550; input c_q
7; mul 1562 1563; sub 1561 1564; le 128 127; le 127 128; add 1566 1567; div 2 1568; mul 1566 1569; mul 132 1550; mul
1570 1571; input c_q 8; mul 1572 1573; add 1565 1574; mul 90 102; input c_q 9; mul 1576 1577; add 1575 1578; mul 102
1576; mul 104 1580; input c_q 10; mul 1581 1582; sub 1579 1583; mul 93 1576; input c_q 11; mul 1585 1586; add 1584
1587; mul 97 1576; input c_q 12; mul 1589 1590; add 1588 1591; add 1528 1592; mul 56 981; mul 70 967; add 1594 1595;
mul 79 997; add 1597 1597; sub 1596 1598; mul 89 1599; mul 89 880; mul 1014 1601; sub 1600 1602; mul 791 1603; mul
880 1471; add 1604 1605; mul 732 1439; mul 734 1433; add 1607 1608; sub 1606 1609; mul 59 981; mul 70 973; add 1611
1612; mul 76 997; mul 79 988; add 1614 1615; sub 1613 1616; mul 89 1617; mul 89 887; mul 1014 1619; sub 1618 1620;
mul 874 1621; mul 887 1525; add 1622 1623; add 1610 1624; mul 0 734; mul 1535 1626; mul 1538 1627; mul 734 1529; sub
1628 1629; mul 93 734; mul 1542 1631; sub 1630 1632; mul 97 734; mul 1546 1634; sub 1633 1635; mul 100 734; add 880
1637; mul 1551 1638; add 1636 1639; mul 102 1638; mul 1555 1641; sub 1640 1642; mul 93 1638; mul 1559 1644; add 1643
1645; mul 97 1638; mul 1563 1647; add 1646 1648; mul 132 1638; mul 1570 1650; mul 1573 1651; sub 1649 1652; mul 102
734; mul 1577 1654; sub 1653 1655; mul 102 1654; mul 104 1657; mul 1582 1658; add 1656 1659; mul 93 1654; mul 1586
1661; sub 1660 1662; mul 97 1654; mul 1590 1664; sub 1663 1665; add 1625 1666; mul 732 1478; mul 794 1433; add 1668
1669; mul 791 1621; mul 887 1471; add 1671 1672; sub 1670 1673; mul 45 981; mul 70 963; add 1675 1676; mul 76 988;
add 1678 1678; sub 1677 1679; mul 89 1680; mul 89 896; mul 1014 1682; sub 1681 1683; mul 874 1684; mul 896 1525; add
1685 1686; sub 1674 1687; mul 794 1529; mul 0 794; mul 1535 1690; mul 1538 1691; sub 1689 1692; mul 93 794; mul 1542
1694; add 1693 1695; mul 97 794; mul 1546 1697; add 1696 1698; mul 100 794; add 887 1700; mul 1551 1701; sub 1699
1702; mul 102 1701; mul 1555 1704; add 1703 1705; mul 93 1701; mul 1559 1707; sub 1706 1708; mul 97 1701; mul 1563
1710; sub 1709 1711; mul 132 1701; mul 1570 1713; mul 1573 1714; add 1712 1715; mul 102 794; mul 1577 1717; add 1716
1718; mul 102 1717; mul 104 1720; mul 1582 1721; sub 1719 1722; mul 93 1717; mul 1586 1724; add 1723 1725; mul 97
1717; mul 1590 1727; add 1726 1728; add 1688 1729; mul 522 1274; mul 490 1312; add 1731 1732; mul 615 1382; mul 597
1408; add 1734 1735; mul 100 129; mul 100 1737; add 141 1738; mul 144 379; mul 437 1740; sub 1741 504; mul 495 1742;
mul 437 1743; mul 550 1740; sub 1745 611; mul 602 1746; mul 550 1747; add 1744 1748; mul 379 1749; input p 169; add
1750 1751; mul 144 1752; mul 504 1743; mul 611 1747; add 1754 1755; sub 1753 1756; add 1739 1757; sign 0; mul 666
1759; mul 0 1760; add 668 1761; mul 670 676; mul 676 677; mul 0 676; mul 1764 1765; sub 1763 1766; add 1762 1767;
add 1758 1768; add 691 695; add 692 1770; add 694 1771; mul 67 1772; mul 22 1773; add 1769 1774; mul 90 1775; mul
511 1749; input p 170; add 1777 1778; mul 502 1743; mul 609 1747; add 1780 1781; add 1779 1782; sub 1737 1783; mul
41 1772; mul 22 1785; sub 1784 1786; mul 734 1787; add 1776 1788; mul 517 1749; input p 171; add 1790 1791; mul 53
1772; mul 22 1793; add 1792 1794; mul 794 1795; add 1789 1796; neg 1797; mul 880 1787; mul 734 1775; add 1799 1800;
mul 887 1795; add 1801 1802; mul 794 1775; mul 887 1787; add 1804 1805; mul 896 1795; add 1806 1807; neg 1808; mul
490 1742; mul 597 1746; where 930 931; where 939 940; where 948 949; where 957 958; mul 26 288; div 2 14; mul 11
1817; mul 9 1818; mul 9 24; mul 5 9; mul 1820 1821; sub 1819 1822; mul 17 1823; mul 9 9; mul 1821 1825; mul 16 1826;
mul 16 17; mul 14 1821; mul 8 1818; add 1829 1830; mul 1828 1831; add 1827 1832; mul 24 1833; sub 1824 1834; mul 23
1835; mul 1816 1836; mul 9 38; mul 1821 1838; sub 9 1839; mul 17 1840; mul 38 1833; sub 1841 1842; mul 23 1843; add
31 1844; mul 961 1845; add 1837 1846; mul 22 1847; mul 18 1833; mul 17 1849; mul 19 1833; add 1850 1851; sub 1848
1852; mul 56 1853; mul 34 965; mul 22 1855; mul 45 1856; add 1854 1857; mul 53 1845; mul 34 41; add 1859 1860; mul
22 1861; mul 59 1862; add 1863 1863; sub 1858 1864; mul 89 1865; mul 28 979; mul 22 1867; mul 61 1868; mul 70 1865;
add 1869 1870; mul 28 41; mul 67 1845; add 1872 1873; add 1836 1874; mul 22 1875; mul 81 1876; mul 56 1876; mul 76
1856; add 1878 1879; mul 79 1862; mul 34 67; add 970 1882; mul 22 1883; mul 59 1884; add 1881 1885; sub 1880 1886;
mul 76 1887; add 1877 1888; sub 1871 1889; mul 86 1884; mul 59 1876; mul 76 1862; add 1892 1893; mul 79 1853; mul 45
1884; add 1895 1896; sub 1894 1897; mul 79 1898; add 1891 1899; add 1890 1900; mul 978 1901; sub 1866 1902; mul 732
1903; sub 114 107; add 1022 1905; input p 172; mul 35 150; mul 157 1908; add 1907 1909; mul 35 1908; mul 161 1911;
add 1910 1912; mul 150 1033; mul 165 1914; add 1913 1915; mul 35 1914; mul 169 1917; add 1916 1918; mul 155 1914;
mul 150 166; add 1920 1921; mul 173 1922; add 1919 1923; mul 148 150; mul 188 1925; add 1924 1926; mul 35 1925; mul
192 1928; add 1927 1929; mul 155 1925; mul 150 189; add 1931 1932; mul 196 1933; add 1930 1934; mul 150 201; mul 200
1936; add 1935 1937; input p 173; mul 224 1908; add 1939 1940; mul 227 1911; add 1941 1942; mul 230 1914; add 1943
1944; mul 233 1917; add 1945 1946; mul 236 1922; add 1947 1948; mul 245 1925; add 1949 1950; mul 248 1928; add 1951
1952; mul 251 1933; add 1953 1954; mul 196 1936; add 1955 1956; mul 147 1957; add 1938 1958; mul 145 1959; le 282
280; le 280 282; add 1961 1962; div 2 1963; mul 1961 1964; le 281 3; le 3 281; add 1966 1967; div 2 1968; mul 1966
1969; mul 1965 1970; mul 276 1971; mul 279 1972; mul 275 1971; mul 283 1974; mul 296 1971; add 1975 1976; mul 295
1977; add 1973 1978; mul 291 1974; mul 300 1980; add 1979 1981; mul 283 288; mul 1971 1983; mul 283 1984; mul 310
1971; add 1985 1986; mul 309 1987; add 1982 1988; mul 291 1984; mul 314 1990; add 1989 1991; mul 291 1971; mul 291
1993; mul 318 1994; add 1992 1995; where 271 1996; add 1960 1997; input p 174; mul 332 1911; mul 334 1922; add 2000
2001; mul 340 1928; add 2002 2003; mul 343 1933; add 2004 2005; mul 346 1936; add 2006 2007; mul 354 1911; mul 357
1917; add 2009 2010; mul 360 1922; add 2011 2012; mul 365 1933; add 2013 2014; mul 343 1936; add 2015 2016; mul 147
2017; add 2008 2018; mul 330 2019; add 1999 2020; mul 620 2021; mul 418 1823; mul 415 1840; add 2023 2024; mul 1213
2025; add 32 37; add 30 2027; add 36 2028; mul 104 2029; mul 148 2008; mul 155 2017; add 509 2032; add 2031 2033;
mul 394 1911; mul 354 1917; add 2035 2036; mul 399 1922; add 2037 2038; mul 402 1928; add 2039 2040; mul 368 1936;
add 2041 2042; mul 35 2043; add 2034 2044; mul 388 2045; mul 330 2046; add 2030 2047; mul 415 1823; add 2048 2049;
mul 418 1840; sub 2050 2051; mul 1184 2052; add 2026 2053; mul 1216 2054; mul 421 2055; mul 288 2056; mul 1222 2056;
mul 435 2058; mul 1220 2059; neg 2060; mul 288 2061; mul 435 2062; mul 440 2060; sub 2063 2064; sub 2057 2065; mul
438 2066; mul 455 2067; mul 1243 2056; mul 1238 2069; mul 451 2070; mul 449 2071; mul 453 2070; add 2072 2073; mul
443 2074; add 2068 2075; mul 460 2056; mul 447 2077; mul 462 2056; add 2078 2079; mul 458 2080; sub 2076 2081; mul
421 2082; mul 485 2056; mul 447 2084; mul 487 2056; add 2085 2086; mul 483 2087; mul 481 2058; mul 434 2089; mul 482
2058; add 2090 2091; mul 434 2092; mul 1269 2058; add 2093 2094; mul 421 2095; mul 489 2096; sub 2088 2097; mul 478
2098; add 2083 2099; mul 493 2098; mul 490 2101; mul 494 2098; add 2102 2103; mul 522 2104; mul 496 2025; sub 2049
2051; mul 427 2107; add 2106 2108; mul 498 2052; mul 420 2025; add 2110 2111; sub 2109 2112; mul 436 2113; mul 421
2060; mul 500 2115; sub 2114 2116; mul 17 2117; mul 501 1833; sub 2118 2119; mul 130 2120; mul 436 2025; mul 427
2115; sub 2122 2123; mul 0 2124; sub 2121 2125; mul 436 2052; mul 420 2115; sub 2127 2128; mul 520 2129; mul 507
2021; mul 150 2017; mul 330 2132; add 31 2133; mul 130 2134; add 2131 2135; mul 153 2017; add 2043 2137; mul 330
2138; add 34 2139; mul 518 2140; add 2136 2141; mul 437 2142; add 2130 2143; add 2126 2144; mul 495 2145; add 2105
2146; add 2100 2147; mul 437 2148; mul 524 2129; add 2149 2150; mul 528 1840; mul 531 1823; sub 2152 2153; mul 1321
2154; mul 528 1823; add 2048 2156; mul 531 1840; add 2157 2158; mul 1319 2159; add 2155 2160; mul 1324 2161; mul 534
2162; mul 288 2163; mul 1330 2163; mul 548 2165; mul 1328 2166; neg 2167; mul 288 2168; mul 548 2169; mul 553 2167;
sub 2170 2171; sub 2164 2172; mul 551 2173; mul 565 2174; mul 1351 2163; mul 1346 2176; mul 561 2177; mul 559 2178;
mul 563 2177; add 2179 2180; mul 556 2181; add 2175 2182; mul 570 2163; mul 557 2184; mul 572 2163; add 2185 2186;
mul 568 2187; sub 2183 2188; mul 534 2189; mul 485 2163; mul 557 2191; mul 594 2163; add 2192 2193; mul 592 2194;
mul 590 2165; mul 547 2196; mul 591 2165; add 2197 2198; mul 547 2199; mul 1377 2165; add 2200 2201; mul 534 2202;
mul 596 2203; sub 2195 2204; mul 588 2205; add 2190 2206; mul 600 2205; mul 597 2208; mul 601 2205; add 2209 2210;
mul 615 2211; mul 603 2154; add 2156 2158; mul 540 2214; add 2213 2215; mul 605 2159; sub 2153 2152; mul 533 2218;
add 2217 2219; add 2216 2220; mul 549 2221; mul 534 2167; mul 607 2223; sub 2222 2224; mul 17 2225; mul 608 1833;
sub 2226 2227; mul 130 2228; mul 549 2154; mul 540 2223; sub 2230 2231; mul 0 2232; sub 2229 2233; mul 549 2159; mul
533 2223; sub 2235 2236; mul 520 2237; mul 550 2142; add 2238 2239; add 2234 2240; mul 602 2241; add 2212 2242; add
2207 2243; mul 550 2244; mul 617 2237; add 2245 2246; add 2151 2247; mul 379 2248; sub 2022 2249; sub 1998 2250; mul
144 2251; mul 504 2148; mul 524 2124; add 2253 2254; mul 611 2244; mul 617 2232; add 2256 2257; add 2255 2258; sub
2252 2259; sub 1906 2260; mul 721 1840; mul 16 1821; mul 16 717; mul 1831 2264; sub 2263 2265; mul 10 2266; mul 717
2267; mul 718 2266; add 2268 2269; mul 716 1821; mul 9 2271; mul 9 716; mul 1821 2273; add 2272 2274; sub 2270 2275;
mul 3 2276; add 720 2277; mul 38 2278; add 2262 2279; sub 1835 2280; mul 713 2281; mul 130 1833; mul 130 2283; mul
23 2284; mul 723 2285; sub 2282 2286; mul 67 2287; add 1469 2288; mul 721 1823; mul 24 2278; add 2290 2291; add 1843
2292; mul 713 2293; mul 728 2285; sub 2294 2295; sub 2289 2296; mul 22 2297; sub 2261 2298; mul 90 2299; add 1904
2300; mul 89 1887; mul 1437 1901; sub 2302 2303; mul 791 2304; mul 777 1840; mul 17 2306; mul 778 1833; sub 2307
2308; mul 150 1957; mul 145 2310; mul 295 1972; mul 746 1977; add 2312 2313; mul 749 1980; add 2314 2315; mul 754
1987; add 2316 2317; mul 757 1990; add 2318 2319; mul 760 1994; add 2320 2321; where 738 2322; add 2311 2323; mul
620 2134; mul 511 2248; sub 2325 2326; sub 2324 2327; mul 502 2148; mul 524 2120; add 2329 2330; mul 609 2244; mul
617 2228; add 2332 2333; add 2331 2334; add 2328 2335; add 118 2336; sub 2309 2337; mul 725 1845; mul 41 2287; add
2339 2340; mul 729 1836; mul 26 2296; add 2342 2343; sub 2341 2344; mul 22 2345; mul 19 2278; mul 721 1849; sub 2347
2348; mul 712 2349; mul 788 2284; sub 2350 2351; sub 2346 2352; sub 2338 2353; mul 734 2354; add 2305 2355; sub 2301
2356; mul 89 1898; mul 1476 1901; sub 2358 2359; mul 874 2360; input p 175; mul 805 1908; add 2362 2363; mul 808
1911; add 2364 2365; mul 811 1914; add 2366 2367; mul 227 1917; add 2368 2369; mul 816 1922; add 2370 2371; mul 157
1925; add 2372 2373; mul 821 1928; add 2374 2375; mul 169 1933; add 2376 2377; mul 257 1936; add 2378 2379; mul 153
1957; add 2380 2381; mul 145 2382; mul 743 1972; mul 314 1977; add 2384 2385; mul 846 1980; add 2386 2387; mul 852
1987; add 2388 2389; mul 760 1990; add 2390 2391; mul 857 1994; add 2392 2393; where 837 2394; add 2383 2395; mul
620 2140; mul 517 2248; sub 2397 2398; sub 2396 2399; mul 34 725; mul 53 2287; add 2401 2402; mul 22 2403; add 2400
2404; mul 794 2405; add 2361 2406; sub 2357 2407; mul 56 1868; mul 70 1856; add 2409 2410; mul 79 1884; add 2412
2412; sub 2411 2413; mul 89 2414; mul 1601 1901; sub 2415 2416; mul 791 2417; mul 880 2354; add 2418 2419; mul 732
2304; mul 734 2299; add 2421 2422; sub 2420 2423; mul 59 1868; mul 70 1862; add 2425 2426; mul 76 1884; mul 79 1876;
add 2428 2429; sub 2427 2430; mul 89 2431; mul 1619 1901; sub 2432 2433; mul 874 2434; mul 887 2405; add 2435 2436;
add 2424 2437; mul 732 2360; mul 794 2299; add 2439 2440; mul 791 2434; mul 887 2354; add 2442 2443; sub 2441 2444;
mul 45 1868; mul 70 1853; add 2446 2447; mul 76 1876; add 2449 2449; sub 2448 2450; mul 89 2451; mul 1682 1901; sub
2452 2453; mul 874 2454; mul 896 2405; add 2455 2456; sub 2445 2457; mul 522 2098; mul 490 2145; add 2459 2460; mul
615 2205; mul 597 2241; add 2462 2463; mul 437 511; add 502 2465; mul 495 2466; mul 437 2467; mul 511 550; add 609
2469; mul 602 2470; mul 550 2471; add 2468 2472; mul 379 2473; input p 176; add 2474 2475; mul 144 2476; mul 504
2467; mul 611 2471; add 2478 2479; sub 2477 2480; sub 1737 2481; add 698 701; add 697 2483; add 700 2484; mul 288
711; mul 23 2486; mul 723 2487; add 2485 2488; mul 67 2489; mul 728 2487; sub 2490 2491; mul 22 2492; sub 2482 2493;
mul 90 2494; mul 511 2473; input p 177; add 2496 2497; mul 502 2467; mul 609 2471; add 2499 2500; add 2498 2501; add
129 2502; mul 41 2489; mul 26 2491; sub 2504 2505; mul 22 2506; mul 788 2486; sub 2507 2508; add 2503 2509; mul 734
2510; add 2495 2511; mul 517 2473; input p 178; add 2513 2514; mul 53 2489; mul 22 2516; add 2515 2517; mul 794
2518; sub 2512 2519; mul 887 2518; mul 880 2510; mul 734 2494; add 2522 2523; sub 2521 2524; mul 794 2494; mul 887
2510; add 2526 2527; mul 896 2518; sub 2528 2529; mul 490 2466; mul 597 2470; input p 179; where 930 2533; input p
180; where 939 2535; input p 181; where 948 2537; input p 182; where 957 2539; mul 34 961; mul 22 2541; mul 56 2542;
mul 51 965; mul 22 2544; mul 45 2545; add 2543 2546; mul 34 53; mul 41 51; add 2548 2549; mul 22 2550; mul 59 2551;
add 2552 2552; sub 2547 2553; mul 89 2554; mul 47 979; mul 22 2556; mul 61 2557; mul 70 2554; add 2558 2559; add 971
1882; mul 22 2561; mul 81 2562; mul 56 2562; mul 76 2545; add 2564 2565; mul 79 2551; mul 51 67; mul 47 53; add 2568
2569; mul 22 2570; mul 59 2571; add 2567 2572; sub 2566 2573; mul 76 2574; add 2563 2575; sub 2560 2576; mul 86
2571; mul 59 2562; mul 76 2551; add 2579 2580; mul 79 2542; mul 45 2571; add 2582 2583; sub 2581 2584; mul 79 2585;
add 2578 2586; add 2577 2587; mul 978 2588; sub 2555 2589; mul 732 2590; input p 183; add 154 155; mul 157 2593; add
2592 2594; mul 35 2593; add 158 2596; mul 161 2597; add 2595 2598; mul 153 1033; mul 165 2600; add 2599 2601; mul 35
2600; add 166 2603; mul 169 2604; add 2602 2605; mul 155 2600; mul 153 166; add 2607 2608; mul 173 2609; add 2606
2610; mul 148 180; add 2611 2612; mul 181 288; mul 184 2614; add 2613 2615; mul 148 153; mul 188 2617; add 2616
2618; mul 35 2617; add 189 2620; mul 192 2621; add 2619 2622; mul 155 2617; mul 153 189; add 2624 2625; mul 196
2626; add 2623 2627; mul 153 201; mul 200 2629; add 2628 2630; mul 35 288; mul 213 2632; add 210 2633; mul 35 2632;
add 214 2635; mul 217 2636; add 2634 2637; input p 184; add 2638 2639; mul 224 2593; add 2640 2641; mul 227 2597;
add 2642 2643; mul 230 2600; add 2644 2645; mul 233 2604; add 2646 2647; mul 236 2609; add 2648 2649; mul 148 157;
add 2650 2651; mul 161 2614; add 2652 2653; mul 245 2617; add 2654 2655; mul 248 2621; add 2656 2657; mul 251 2626;
add 2658 2659; mul 201 257; add 2660 2661; mul 196 2629; add 2662 2663; mul 147 2664; add 2631 2665; mul 145 2666;
le 290 288; le 288 290; add 2668 2669; div 2 2670; mul 2668 2671; le 289 35; le 35 289; add 2673 2674; div 2 2675;
mul 2673 2676; mul 2672 2677; mul 276 2678; mul 287 2679; mul 296 2678; mul 300 2681; add 2680 2682; mul 275 2678;
mul 291 2684; mul 305 2678; add 2685 2686; mul 304 2687; add 2683 2688; mul 310 2678; mul 314 2690; add 2689 2691;
mul 283 2678; mul 291 2693; mul 319 2678; add 2694 2695; mul 318 2696; add 2692 2697; mul 288 291; mul 2678 2699;
mul 291 2700; mul 324 2678; add 2701 2702; mul 323 2703; add 2698 2704; where 271 2705; add 2667 2706; input p 185;
mul 332 2597; mul 334 2609; add 2709 2710; mul 337 2614; add 2711 2712; mul 340 2621; add 2713 2714; mul 343 2626;
add 2715 2716; mul 346 2629; add 2717 2718; mul 352 2636; mul 354 2597; add 2720 2721; mul 357 2604; add 2722 2723;
mul 360 2609; add 2724 2725; mul 332 2614; add 2726 2727; mul 365 2626; add 2728 2729; mul 201 368; add 2730 2731;
mul 343 2629; add 2732 2733; mul 147 2734; add 2719 2735; mul 330 2736; add 2708 2737; mul 620 2738; add 52 53; add
50 2740; mul 104 2741; mul 148 2719; mul 155 2734; add 514 2744; add 2743 2745; mul 392 2636; mul 394 2597; add 2747
2748; mul 354 2604; add 2749 2750; mul 399 2609; add 2751 2752; mul 402 2621; add 2753 2754; mul 201 337; add 2755
2756; mul 368 2629; add 2757 2758; mul 35 2759; add 408 2760; add 2746 2761; mul 388 2762; mul 330 2763; add 2742
2764; mul 1184 2765; mul 1216 2766; mul 421 2767; mul 288 2768; mul 1222 2768; mul 435 2770; mul 1220 2771; neg
2772; mul 288 2773; mul 435 2774; mul 440 2772; sub 2775 2776; sub 2769 2777; mul 438 2778; mul 455 2779; mul 1243
2768; mul 1238 2781; mul 451 2782; mul 449 2783; mul 453 2782; add 2784 2785; mul 443 2786; add 2780 2787; mul 460
2768; mul 447 2789; mul 462 2768; add 2790 2791; mul 458 2792; sub 2788 2793; mul 421 2794; mul 485 2768; mul 447
2796; mul 487 2768; add 2797 2798; mul 483 2799; mul 481 2770; mul 434 2801; mul 482 2770; add 2802 2803; mul 434
2804; mul 1269 2770; add 2805 2806; mul 421 2807; mul 489 2808; sub 2800 2809; mul 478 2810; add 2795 2811; mul 493
2810; mul 490 2813; mul 494 2810; add 2814 2815; mul 522 2816; mul 421 2772; mul 427 2818; mul 0 2819; mul 498 2765;
mul 436 2821; mul 500 2818; add 2822 2823; mul 17 2824; mul 130 2825; sub 2820 2826; mul 436 2765; mul 420 2818; sub
2828 2829; mul 520 2830; mul 507 2738; mul 150 2734; mul 330 2833; add 34 2834; mul 130 2835; add 2832 2836; mul 153
2734; add 2759 2838; mul 330 2839; add 51 2840; mul 518 2841; add 2837 2842; mul 437 2843; add 2831 2844; add 2827
2845; mul 495 2846; add 2817 2847; add 2812 2848; mul 437 2849; mul 524 2830; add 2850 2851; mul 1319 2765; mul 1324
2853; mul 534 2854; mul 288 2855; mul 1330 2855; mul 548 2857; mul 1328 2858; neg 2859; mul 288 2860; mul 548 2861;
mul 553 2859; sub 2862 2863; sub 2856 2864; mul 551 2865; mul 565 2866; mul 1351 2855; mul 1346 2868; mul 561 2869;
mul 559 2870; mul 563 2869; add 2871 2872; mul 556 2873; add 2867 2874; mul 570 2855; mul 557 2876; mul 572 2855;
add 2877 2878; mul 568 2879; sub 2875 2880; mul 534 2881; mul 485 2855; mul 557 2883; mul 594 2855; add 2884 2885;
mul 592 2886; mul 590 2857; mul 547 2888; mul 591 2857; add 2889 2890; mul 547 2891; mul 1377 2857; add 2892 2893;
mul 534 2894; mul 596 2895; sub 2887 2896; mul 588 2897; add 2882 2898; mul 600 2897; mul 597 2900; mul 601 2897;
add 2901 2902; mul 615 2903; mul 605 2765; mul 549 2905; mul 534 2859; mul 607 2907; sub 2906 2908; mul 17 2909; mul
130 2910; mul 540 2907; mul 0 2912; add 2911 2913; mul 549 2765; mul 533 2907; sub 2915 2916; mul 520 2917; mul 550
2843; add 2918 2919; add 2914 2920; mul 602 2921; add 2904 2922; add 2899 2923; mul 550 2924; mul 617 2917; add 2925
2926; add 2852 2927; mul 379 2928; sub 2739 2929; sub 2707 2930; mul 144 2931; mul 504 2849; mul 524 2819; sub 2933
2934; mul 611 2924; mul 617 2912; sub 2936 2937; add 2935 2938; sub 2932 2939; add 1524 2940; mul 90 2941; sub 2591
2942; mul 89 2574; mul 1437 2588; sub 2944 2945; mul 791 2946; mul 150 2664; mul 145 2948; mul 743 2679; mul 749
2681; add 2950 2951; mul 318 2687; add 2952 2953; mul 757 2690; add 2954 2955; mul 760 2696; add 2956 2957; mul 763
2703; add 2958 2959; where 738 2960; add 2949 2961; mul 620 2835; mul 511 2928; sub 2963 2964; sub 2962 2965; mul
502 2849; mul 524 2825; sub 2967 2968; mul 609 2924; mul 617 2910; add 2970 2971; add 2969 2972; add 2966 2973; mul
22 2401; add 2974 2975; mul 734 2976; sub 2947 2977; sub 2943 2978; mul 89 2585; mul 1476 2588; sub 2980 2981; mul
874 2982; mul 797 2632; add 795 2984; mul 800 2636; add 2985 2986; input p 186; add 2987 2988; mul 805 2593; add
2989 2990; mul 808 2597; add 2991 2992; mul 811 2600; add 2993 2994; mul 227 2604; add 2995 2996; mul 816 2609; add
2997 2998; mul 157 2617; add 2999 3000; mul 821 2621; add 3001 3002; mul 169 2626; add 3003 3004; mul 184 201; add
3005 3006; mul 257 2629; add 3007 3008; mul 153 2664; add 3009 3010; mul 145 3011; mul 304 2679; mul 846 2681; add
3013 3014; mul 849 2687; add 3015 3016; mul 760 2690; add 3017 3018; mul 857 2696; add 3019 3020; mul 860 2703; add
3021 3022; where 837 3023; add 3012 3024; mul 620 2841; mul 517 2928; sub 3026 3027; sub 3025 3028; mul 51 725; mul
22 3030; add 3029 3031; mul 794 3032; add 2983 3033; sub 2979 3034; mul 56 2557; mul 70 2545; add 3036 3037; mul 79
2571; add 3039 3039; sub 3038 3040; mul 89 3041; mul 1601 2588; sub 3042 3043; mul 791 3044; mul 880 2976; sub 3045
3046; mul 732 2946; mul 734 2941; sub 3048 3049; sub 3047 3050; mul 59 2557; mul 70 2551; add 3052 3053; mul 76
2571; mul 79 2562; add 3055 3056; sub 3054 3057; mul 89 3058; mul 1619 2588; sub 3059 3060; mul 874 3061; mul 887
3032; add 3062 3063; add 3051 3064; mul 732 2982; mul 794 2941; sub 3066 3067; mul 791 3061; mul 887 2976; sub 3069
3070; sub 3068 3071; mul 45 2557; mul 70 2542; add 3073 3074; mul 76 2562; add 3076 3076; sub 3075 3077; mul 89
3078; mul 1682 2588; sub 3079 3080; mul 874 3081; mul 896 3032; add 3082 3083; sub 3072 3084; mul 522 2810; mul 490
2846; add 3086 3087; mul 615 2897; mul 597 2921; add 3089 3090; mul 437 517; mul 495 3092; mul 437 3093; mul 517
550; mul 602 3095; mul 550 3096; add 3094 3097; mul 511 3098; input p 187; add 3099 3100; mul 502 3093; mul 609
3096; add 3102 3103; add 3101 3104; add 707 708; add 706 3106; mul 41 3107; mul 22 3108; add 3105 3109; mul 734
3110; mul 379 3098; input p 188; add 3112 3113; mul 144 3114; mul 504 3093; mul 611 3096; add 3116 3117; sub 3115
3118; mul 67 3107; mul 22 3120; add 3119 3121; mul 90 3122; sub 3111 3123; mul 517 3098; input p 189; add 3125 3126;
mul 53 3107; mul 22 3128; add 3127 3129; mul 794 3130; sub 3124 3131; mul 734 3122; mul 880 3110; sub 3133 3134; mul
887 3130; add 3135 3136; mul 887 3110; mul 794 3122; sub 3138 3139; mul 896 3130; sub 3140 3141; mul 490 3092; mul
597 3095; mul 468 490; mul 437 3145; mul 511 3146; mul 502 3145; add 3147 3148; mul 734 3149; mul 379 3146; mul 144
3151; mul 504 3145; sub 3152 3153; mul 90 3154; sub 3150 3155; mul 517 3146; mul 794 3157; sub 3156 3158; mul 734
3154; mul 880 3149; sub 3160 3161; mul 887 3157; add 3162 3163; mul 887 3149; mul 794 3154; sub 3165 3166; mul 896
3157; sub 3167 3168; input p 190; mul 578 597; mul 550 3171; mul 511 3172; mul 609 3171; add 3173 3174; mul 734
3175; mul 379 3172; mul 144 3177; mul 611 3171; sub 3178 3179; mul 90 3180; sub 3176 3181; mul 517 3172; mul 794
3183; sub 3182 3184; mul 734 3180; mul 880 3175; sub 3186 3187; mul 887 3183; add 3188 3189; mul 887 3175; mul 794
3180; sub 3191 3192; mul 896 3183; sub 3193 3194; mul 471 490; mul 437 3196; mul 511 3197; mul 502 3196; add 3198
3199; mul 734 3200; mul 379 3197; mul 144 3202; mul 504 3196; sub 3203 3204; mul 90 3205; sub 3201 3206; mul 517
3197; mul 794 3208; sub 3207 3209; mul 734 3205; mul 880 3200; sub 3211 3212; mul 887 3208; add 3213 3214; mul 887
3200; mul 794 3205; sub 3216 3217; mul 896 3208; sub 3218 3219; input p 191; mul 581 597; mul 550 3222; mul 511
3223; mul 609 3222; add 3224 3225; mul 734 3226; mul 379 3223; mul 144 3228; mul 611 3222; sub 3229 3230; mul 90
3231; sub 3227 3232; mul 517 3223; mul 794 3234; sub 3233 3235; mul 734 3231; mul 880 3226; sub 3237 3238; mul 887
3234; add 3239 3240; mul 887 3226; mul 794 3231; sub 3242 3243; mul 896 3234; sub 3244 3245; mul 475 490; mul 437
3247; mul 511 3248; mul 502 3247; add 3249 3250; mul 734 3251; mul 379 3248; mul 144 3253; mul 504 3247; sub 3254
3255; mul 90 3256; sub 3252 3257; mul 517 3248; mul 794 3259; sub 3258 3260; mul 734 3256; mul 880 3251; sub 3262
3263; mul 887 3259; add 3264 3265; mul 887 3251; mul 794 3256; sub 3267 3268; mul 896 3259; sub 3269 3270; input p
192; mul 585 597; mul 550 3273; mul 511 3274; mul 609 3273; add 3275 3276; mul 734 3277; mul 379 3274; mul 144 3279;
mul 611 3273; sub 3280 3281; mul 90 3282; sub 3278 3283; mul 517 3274; mul 794 3285; sub 3284 3286; mul 734 3282;
mul 880 3277; sub 3288 3289; mul 887 3285; add 3290 3291; mul 887 3277; mul 794 3282; sub 3293 3294; mul 896 3285;
sub 3295 3296; mul 90 681; mul 681 734; neg 3299; mul 681 794; input p 193; mul 90 685; mul 685 734; neg 3304; mul
685 794; input p 194; input p 195; mul 734 3308; mul 90 650; sub 3309 3310; mul 650 734; mul 880 3308; sub 3312
3313; mul 887 3308; mul 650 794; sub 3315 3316; input p 196; mul 734 3318; mul 90 653; sub 3319 3320; mul 653 734;
mul 880 3318; sub 3322 3323; mul 887 3318; mul 653 794; sub 3325 3326; input p 197; mul 734 3328; mul 90 657; sub
3329 3330; mul 657 734; mul 880 3328; sub 3332 3333; mul 887 3328; mul 657 794; sub 3335 3336; input p 198; mul 734
3338; mul 90 661; sub 3339 3340; mul 661 734; mul 880 3338; sub 3342 3343; mul 887 3338; mul 661 794; sub 3345 3346;
mul 102 109; add 92 3348; mul 100 121; sub 3349 3350; mul 457 464; mul 421 3352; mul 504 3353; mul 437 3353; mul 379
3355; mul 144 3356; sub 3354 3357; sub 3351 3358; mul 90 3359; mul 511 3355; mul 502 3353; add 3361 3362; add 121
3363; mul 734 3364; sub 3360 3365; mul 517 3355; mul 794 3367; add 3366 3368; mul 880 3364; mul 734 3359; sub 3370
3371; mul 887 3367; sub 3372 3373; mul 794 3359; mul 887 3364; sub 3375 3376; mul 896 3367; add 3377 3378; mul 102
112; add 96 3380; mul 100 124; sub 3381 3382; mul 567 574; mul 534 3384; mul 611 3385; mul 550 3385; mul 379 3387;
mul 144 3388; sub 3386 3389; sub 3383 3390; mul 90 3391; mul 511 3387; mul 609 3385; add 3393 3394; add 124 3395;
mul 734 3396; sub 3392 3397; mul 517 3387; mul 794 3399; add 3398 3400; mul 880 3396; mul 734 3391; sub 3402 3403;
mul 887 3399; sub 3404 3405; mul 794 3391; mul 887 3396; sub 3407 3408; mul 896 3399; add 3409 3410; neg 734; neg
1537; neg 1691; neg 1631; neg 1634; neg 1550; neg 1701; neg 1641; neg 1558; neg 1707; neg 1562; neg 1710; neg 1651;
neg 1654; neg 1581; neg 1721; neg 1661; neg 1664; store f 0 0; store f 1 876; store f 2 130; store f 3 889; store f
4 518; store f 5 898; store f 6 902; store f 7 905; store f 8 908; store f 9 910; store f 10 913; store f 11 915;
store f 12 917; store f 13 919; store f 14 933; store f 15 942; store f 16 951; store f 17 960; store a 18 1593;
store a 54 1667; store a 90 1730; store a 108 1733; store a 126 1736; store a 144 1733; store a 162 1736; store a
180 1733; store a 198 1736; store a 216 916; store a 234 918; store a 1 2; store a 19 1798; store a 55 1803; store a
91 1809; store a 109 1810; store a 127 1811; store a 145 1810; store a 163 1811; store a 181 1810; store a 199 1811;
store a 253 1812; store a 271 1813; store a 289 1814; store a 307 1815; store a 20 2408; store a 56 2438; store a 92
2458; store a 110 2461; store a 128 2464; store a 146 2461; store a 164 2464; store a 182 2461; store a 200 2464;
store a 21 2520; store a 39 2; store a 57 2525; store a 93 2530; store a 111 2531; store a 129 2532; store a 147
2531; store a 165 2532; store a 183 2531; store a 201 2532; store a 255 2534; store a 273 2536; store a 291 2538;
store a 309 2540; store a 22 3035; store a 58 3065; store a 94 3085; store a 112 3088; store a 130 3091; store a 148
3088; store a 166 3091; store a 184 3088; store a 202 3091; store a 23 3132; store a 59 3137; store a 77 2; store a
95 3142; store a 113 3143; store a 131 3144; store a 149 3143; store a 167 3144; store a 185 3143; store a 203 3144;
store a 24 3159; store a 60 3164; store a 96 3169; store a 114 3170; store a 25 3185; store a 61 3190; store a 97
3195; store a 133 3170; store a 26 3210; store a 62 3215; store a 98 3220; store a 152 3221; store a 27 3236; store
a 63 3241; store a 99 3246; store a 171 3221; store a 28 3261; store a 64 3266; store a 100 3271; store a 190 3272;
store a 29 3287; store a 65 3292; store a 101 3297; store a 209 3272; store a 30 3298; store a 66 3300; store a 102
3301; store a 228 3302; store a 31 3303; store a 67 3305; store a 103 3306; store a 247 3307; store a 32 3311; store
a 68 3314; store a 104 3317; store a 33 3321; store a 69 3324; store a 105 3327; store a 34 3331; store a 70 3334;
store a 106 3337; store a 35 3341; store a 71 3344; store a 107 3347; store b 2 3369; store b 6 3374; store b 10
3379; store b 3 3401; store b 7 3406; store b 11 3411; store by_c 13 90; store by_c 39 3412; store by_c 65 794;
store by_c 14 3413; store by_c 40 1627; store by_c 66 3414; store by_c 15 1541; store by_c 41 3415; store by_c 67
1694; store by_c 16 1545; store by_c 42 3416; store by_c 68 1697; store by_c 17 3417; store by_c 43 1638; store by_c
69 3418; store by_c 18 1554; store by_c 44 3419; store by_c 70 1704; store by_c 19 3420; store by_c 45 1644; store
by_c 71 3421; store by_c 20 3422; store by_c 46 1647; store by_c 72 3423; store by_c 21 1572; store by_c 47 3424;
store by_c 73 1714; store by_c 22 1576; store by_c 48 3425; store by_c 74 1717; store by_c 23 3426; store by_c 49
1658; store by_c 75 3427; store by_c 24 1585; store by_c 50 3428; store by_c 76 1724; store by_c 25 1589; store by_c
51 3429; store by_c 77 1727
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'p': 231},
    {'by_k': 1620},
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
constant 0.35; lt 215 216; input p 52; constant -0.35; max 219 94; min 216 220; mul 221 221; mul 221 222; mul 218
223; input p 53; constant 0.6; constant -0.6; max 227 2; min 226 228; mul 222 229; mul 225 230; add 224 231; input p
54; constant 2.0; constant -2.0; max 235 34; min 234 236; mul 222 237; mul 233 238; add 232 239; input p 55; mul 221
229; mul 229 242; mul 241 243; add 240 244; input p 56; mul 237 242; mul 246 247; add 245 248; input p 57; mul 221
237; mul 237 251; mul 250 252; add 249 253; input p 58; mul 229 229; mul 229 256; mul 255 257; add 254 258; input p
59; mul 237 256; mul 260 261; add 259 262; input p 60; mul 229 237; mul 237 265; mul 264 266; add 263 267; input p
61; mul 237 237; mul 237 270; mul 269 271; add 268 272; where 217 273; add 214 274; input p 62; mul 66 276; input p
63; mul 108 278; input p 64; mul 120 280; add 279 281; input p 65; mul 131 283; add 282 284; input p 66; mul 139
286; add 285 287; input p 67; mul 143 289; add 288 290; input p 68; mul 148 292; add 291 293; input p 69; mul 152
295; add 294 296; input p 70; mul 164 298; input p 71; mul 108 300; add 299 301; input p 72; mul 116 303; add 302
304; input p 73; mul 120 306; add 305 307; mul 131 278; add 308 309; input p 74; mul 143 311; add 310 312; input p
75; mul 204 314; add 313 315; mul 148 289; add 316 317; input p 76; mul 152 319; add 318 320; mul 93 321; add 297
322; mul 276 323; add 277 324; input p 77; input p 78; constant 0.5; mul 28 66; mul 2 36; add 329 330; mul 34 52;
add 331 332; mul 328 333; constant 0.25; mul 94 297; mul 101 321; add 336 337; input p 79; mul 164 339; input p 80;
mul 108 341; add 340 342; mul 116 300; add 343 344; input p 81; mul 120 346; add 345 347; input p 82; mul 139 349;
add 348 350; mul 204 283; add 351 352; mul 148 314; add 353 354; mul 34 355; add 338 356; mul 335 357; mul 276 358;
add 334 359; add 327 360; input p 83; mul 23 362; add 361 363; input p 84; mul 37 365; sub 364 366; input p 85; mul
23 365; input p 86; sub 369 370; mul 37 362; add 371 372; sub 373 28; mul 374 374; mul 367 367; add 375 376; sqrt
377; mul 368 378; sqrt 379; div 1 380; mul 381 381; mul 368 382; mul 367 383; input p 87; mul 234 379; mul 234 382;
mul 382 387; sub 386 388; mul 385 389; constant 0.3; constant -0.3; constant 1.4; sub 379 393; max 392 394; min 391
395; input p 88; input p 89; mul 396 398; add 397 399; mul 396 400; add 1 401; mul 390 402; input u 0; input p 90;
mul 404 405; input p 91; input p 92; mul 394 408; add 407 409; mul 394 410; add 1 411; mul 406 412; sub 403 413; mul
368 414; input p 93; input x 6; mul 416 417; input p 94; input x 8; mul 419 420; add 418 421; input p 95; input x
10; mul 423 424; add 422 425; constant -0.5; mul 381 427; mul 381 428; mul 381 429; mul 368 430; input p 96; input p
97; mul 394 433; add 432 434; mul 394 435; add 1 436; mul 431 437; mul 426 438; add 415 439; input p 98; mul 438
441; mul 438 442; input x 3; sub 363 366; mul 374 445; add 369 372; mul 367 447; sub 446 448; mul 383 449; mul 16
450; mul 444 451; input x 1; mul 374 383; mul 453 454; sub 452 455; mul 90 453; mul 325 457; mul 96 321; mul 276
459; add 36 460; mul 444 461; add 458 462; mul 99 321; add 355 464; mul 276 465; add 52 466; input x 5; mul 467 468;
add 463 469; mul 384 470; add 456 471; mul 443 472; add 440 473; mul 384 474; input p 99; add 360 476; input p 100;
mul 23 478; add 477 479; input p 101; mul 37 481; add 480 482; input p 102; mul 37 478; mul 23 481; input p 103; sub
486 487; sub 485 488; sub 489 28; mul 490 490; mul 483 483; add 491 492; sqrt 493; mul 484 494; sqrt 495; div 1 496;
mul 497 497; mul 484 498; mul 483 499; input p 104; mul 234 495; mul 234 498; mul 498 503; sub 502 504; mul 501 505;
sub 495 393; max 392 507; min 391 508; input p 105; input p 106; mul 509 511; add 510 512; mul 509 513; add 1 514;
mul 506 515; input u 1; input p 107; mul 517 518; input p 108; input p 109; mul 507 521; add 520 522; mul 507 523;
add 1 524; mul 519 525; sub 516 526; mul 484 527; input p 110; input x 7; mul 529 530; input p 111; input x 9; mul
532 533; add 531 534; input p 112; input x 11; mul 536 537; add 535 538; mul 427 497; mul 497 540; mul 497 541; mul
484 542; mul 433 507; add 432 544; mul 507 545; add 1 546; mul 543 547; mul 539 548; add 528 549; input p 113; mul
548 551; mul 548 552; add 479 482; mul 490 554; sub 486 485; mul 483 556; add 555 557; mul 499 558; mul 16 559; mul
444 560; mul 490 499; mul 453 562; sub 561 563; mul 470 500; add 564 565; mul 553 566; add 550 567; mul 500 568; add
475 569; sub 326 570; mul 325 571; sub 275 572; input p 114; constant 12.0; mul 457 575; constant -6.0; mul 93 457;
mul 96 444; add 578 579; mul 99 468; add 580 581; mul 577 582; add 576 583; mul 574 584; mul 457 577; constant 4.0;
mul 582 587; add 586 588; mul 574 589; mul 93 590; add 585 591; add 573 592; mul 90 593; mul 90 594; mul 89 595; mul
80 88; mul 560 597; mul 89 562; add 598 599; mul 85 88; mul 467 601; mul 461 597; sub 602 603; mul 89 90; mul 325
605; add 604 606; mul 500 607; sub 600 608; mul 553 609; mul 470 610; mul 568 607; sub 611 612; mul 499 613; mul 568
597; mul 444 610; add 615 616; mul 16 617; mul 499 618; mul 556 619; add 614 620; mul 234 483; mul 234 494; div 1
623; mul 566 609; mul 552 625; mul 548 625; mul 551 627; add 626 628; mul 539 609; add 629 630; mul 543 631; mul 545
632; mul 507 632; mul 433 634; add 633 635; mul 484 609; mul 519 637; mul 523 638; sub 636 639; mul 507 638; mul 521
641; sub 640 642; le 392 507; le 507 392; add 644 645; div 1 646; mul 644 647; le 508 391; le 391 508; add 649 650;
div 1 651; mul 649 652; mul 506 637; mul 513 654; mul 509 654; mul 511 656; add 655 657; mul 653 658; mul 648 659;
add 643 660; mul 234 496; div 1 662; mul 497 542; mul 547 631; mul 484 665; mul 664 666; mul 497 666; mul 542 668;
add 667 669; mul 497 668; mul 541 671; add 670 672; mul 234 497; mul 483 613; mul 89 568; mul 453 610; sub 676 677;
mul 490 678; add 675 679; mul 558 618; add 680 681; mul 484 682; mul 515 637; mul 501 684; mul 503 685; sub 683 686;
mul 498 685; neg 688; mul 234 689; add 687 690; mul 674 691; mul 498 692; add 673 693; mul 663 694; sub 661 695; mul
234 685; add 696 697; mul 484 698; mul 624 699; mul 622 700; add 621 701; sub 596 702; mul 571 601; mul 500 610; mul
451 597; mul 89 454; add 706 707; mul 384 607; sub 708 709; mul 443 710; mul 384 711; add 705 712; mul 468 713; add
704 714; mul 465 715; add 703 716; mul 444 713; mul 571 597; sub 718 719; mul 459 720; add 717 721; mul 90 457; mul
96 597; mul 99 601; sub 724 725; mul 93 605; sub 726 727; mul 574 728; mul 577 729; mul 587 729; mul 574 605; mul
577 732; sub 731 733; mul 93 734; add 730 735; mul 575 732; sub 736 737; mul 325 713; add 738 739; mul 723 740; sub
722 741; mul 571 605; mul 457 713; add 743 744; mul 323 745; add 742 746; mul 66 745; add 747 748; mul 470 711; mul
474 607; sub 750 751; mul 383 752; mul 474 597; mul 444 711; add 754 755; mul 16 756; mul 383 757; mul 447 758; sub
753 759; mul 234 367; mul 234 378; div 1 762; mul 472 710; mul 442 764; mul 438 764; mul 441 766; add 765 767; mul
426 710; add 768 769; mul 431 770; mul 435 771; mul 394 771; mul 433 773; add 772 774; mul 368 710; mul 406 776; mul
410 777; sub 775 778; mul 394 777; mul 408 780; sub 779 781; le 392 394; le 394 392; add 783 784; div 1 785; mul 783
786; le 395 391; le 391 395; add 788 789; div 1 790; mul 788 791; mul 390 776; mul 400 793; mul 396 793; mul 398
795; add 794 796; mul 792 797; mul 787 798; add 782 799; mul 234 380; div 1 801; mul 381 430; mul 437 770; mul 368
804; mul 803 805; mul 381 805; mul 430 807; add 806 808; mul 381 807; mul 429 810; add 809 811; mul 234 381; mul 367
752; mul 89 474; mul 453 711; sub 815 816; mul 374 817; add 814 818; mul 449 757; add 819 820; mul 368 821; mul 402
776; mul 385 823; mul 387 824; sub 822 825; mul 382 824; neg 827; mul 234 828; add 826 829; mul 813 830; mul 382
831; add 812 832; mul 802 833; sub 800 834; mul 234 824; add 835 836; mul 368 837; mul 763 838; mul 761 839; add 760
840; add 702 841; mul 358 842; add 749 843; sub 844 841; mul 90 94; mul 94 234; mul 276 715; mul 276 842; mul 335
849; mul 34 850; add 848 851; mul 314 852; mul 101 853; mul 847 854; mul 91 601; mul 203 856; mul 101 857; mul 847
858; mul 130 856; mul 34 860; mul 847 861; add 859 862; input p 144; mul 856 864; mul 847 865; add 863 866; mul 115
856; mul 101 868; mul 101 869; add 867 870; input p 143; mul 856 872; mul 34 873; mul 101 874; add 871 875; mul 103
856; mul 101 877; add 876 878; sub 855 879; mul 283 852; mul 34 881; mul 847 882; add 880 883; mul 349 852; mul 34
885; mul 101 886; add 884 887; mul 99 848; mul 276 720; mul 96 890; add 889 891; mul 276 745; mul 93 893; add 892
894; mul 101 850; add 895 896; mul 319 897; mul 147 898; add 888 899; mul 94 898; mul 847 901; add 900 902; mul 289
897; mul 101 904; mul 847 905; add 903 906; mul 314 897; mul 34 908; mul 847 909; add 907 910; mul 311 897; mul 101
912; mul 101 913; add 911 914; mul 278 897; mul 34 916; mul 34 917; add 915 918; mul 297 850; add 919 920; mul 94
850; add 893 922; mul 295 923; mul 147 924; add 921 925; mul 94 924; mul 847 927; add 926 928; mul 292 923; mul 101
930; mul 847 931; add 929 932; mul 289 923; mul 101 934; mul 101 935; add 933 936; mul 286 923; mul 34 938; mul 101
939; add 937 940; mul 283 923; mul 34 942; mul 34 943; add 941 944; le 219 94; le 94 219; add 946 947; div 1 948;
mul 946 949; le 220 216; le 216 220; add 951 952; div 1 953; mul 951 954; abs 34; lt 956 234; input p 147; mul 601
958; neg 959; where 957 960; abs 2; lt 962 226; mul 264 597; where 963 964; add 961 965; mul 250 605; neg 967; where
217 968; add 966 969; mul 237 970; mul 237 971; input p 146; mul 601 973; neg 974; where 957 975; input p 129; mul
597 977; where 963 978; add 976 979; mul 246 605; neg 981; where 217 982; add 980 983; mul 237 984; mul 260 601; neg
986; where 957 987; input p 128; mul 597 989; where 963 990; add 988 991; mul 241 605; neg 993; where 217 994; add
992 995; mul 229 996; add 985 997; mul 229 998; add 972 999; input p 145; mul 601 1001; neg 1002; where 957 1003;
input p 126; mul 597 1005; where 963 1006; add 1004 1007; mul 218 605; neg 1009; where 217 1010; add 1008 1011; mul
222 1012; add 1000 1013; mul 221 234; mul 250 601; neg 1016; where 957 1017; input p 127; mul 597 1019; where 963
1020; add 1018 1021; mul 233 605; neg 1023; where 217 1024; add 1022 1025; mul 237 1026; mul 601 1019; neg 1028;
where 957 1029; mul 241 597; where 963 1031; add 1030 1032; mul 225 605; neg 1034; where 217 1035; add 1033 1036;
mul 229 1037; add 1027 1038; mul 221 1012; add 1039 1040; mul 1015 1041; add 1014 1042; mul 955 1043; mul 950 1044;
add 945 1045; mul 91 597; mul 96 1047; mul 99 856; sub 1048 1049; mul 91 605; mul 93 1051; sub 1050 1052; mul 209
1053; mul 147 1054; add 1046 1055; mul 94 1054; mul 847 1057; add 1056 1058; mul 142 1053; mul 101 1060; mul 847
1061; add 1059 1062; mul 203 1053; mul 34 1064; mul 847 1065; add 1063 1066; mul 200 1053; mul 847 1068; add 1067
1069; mul 197 1053; mul 101 1071; mul 101 1072; add 1070 1073; mul 194 1053; mul 34 1075; mul 101 1076; add 1074
1077; mul 191 1053; mul 101 1079; add 1078 1080; mul 107 1053; mul 34 1082; mul 34 1083; add 1081 1084; mul 103
1053; mul 34 1086; add 1085 1087; mul 92 1053; add 1088 1089; mul 151 1051; mul 147 1091; sub 1090 1092; mul 94
1091; mul 847 1094; sub 1093 1095; mul 146 1051; mul 101 1097; mul 847 1098; sub 1096 1099; mul 142 1051; mul 101
1101; mul 101 1102; sub 1100 1103; mul 138 1051; mul 34 1105; mul 101 1106; sub 1104 1107; mul 134 1051; mul 101
1109; sub 1108 1110; mul 130 1051; mul 34 1112; mul 34 1113; sub 1111 1114; mul 126 1051; mul 34 1116; sub 1115
1117; mul 123 1051; sub 1118 1119; mul 147 853; mul 147 857; mul 135 868; add 1122 1123; mul 94 869; add 1124 1125;
mul 94 874; add 1126 1127; mul 94 877; add 1128 1129; input p 142; mul 856 1131; mul 112 1132; add 1130 1133; mul
101 234; mul 101 1132; mul 1135 1136; add 1134 1137; mul 173 856; mul 34 1139; mul 1135 1140; add 1138 1141; input p
141; mul 856 1143; mul 1135 1144; add 1142 1145; input p 140; mul 856 1147; mul 34 1148; mul 34 1149; add 1146 1150;
input p 139; mul 856 1152; mul 34 1153; add 1151 1154; mul 156 856; add 1155 1156; sub 1121 1157; mul 94 886; add
1158 1159; mul 346 852; mul 112 1161; add 1160 1162; mul 101 1161; mul 1135 1164; add 1163 1165; mul 300 852; mul 34
1167; mul 1135 1168; add 1166 1169; mul 341 852; mul 34 1171; mul 34 1172; add 1170 1173; mul 321 850; add 1174
1175; mul 147 904; add 1176 1177; mul 135 912; add 1178 1179; mul 94 913; add 1180 1181; mul 306 897; mul 112 1183;
add 1182 1184; mul 101 1183; mul 1135 1186; add 1185 1187; mul 303 897; mul 34 1189; mul 1135 1190; add 1188 1191;
mul 300 897; mul 34 1193; mul 34 1194; add 1192 1195; mul 147 930; add 1196 1197; mul 135 934; add 1198 1199; mul 94
935; add 1200 1201; mul 94 939; add 1202 1203; mul 280 923; mul 112 1205; add 1204 1206; mul 101 1205; mul 1135
1208; add 1207 1209; mul 278 923; mul 34 1211; mul 34 1212; add 1210 1213; mul 147 1060; add 1214 1215; mul 135
1071; add 1216 1217; mul 94 1072; add 1218 1219; mul 94 1076; add 1220 1221; mul 94 1079; add 1222 1223; mul 182
1053; mul 112 1225; add 1224 1226; mul 101 1225; mul 1135 1228; add 1227 1229; mul 179 1053; mul 34 1231; mul 1135
1232; add 1230 1233; mul 176 1053; mul 1135 1235; add 1234 1236; mul 173 1053; mul 34 1238; mul 34 1239; add 1237
1240; mul 170 1053; mul 34 1242; add 1241 1243; mul 167 1053; add 1244 1245; mul 147 1097; sub 1246 1247; mul 135
1101; sub 1248 1249; mul 94 1102; sub 1250 1251; mul 94 1106; sub 1252 1253; mul 94 1109; sub 1254 1255; mul 119
1051; mul 112 1257; sub 1256 1258; mul 101 1257; mul 1135 1260; sub 1259 1261; mul 115 1051; mul 34 1263; mul 1135
1264; sub 1262 1265; mul 111 1051; mul 1135 1267; sub 1266 1268; mul 107 1051; mul 34 1270; mul 34 1271; sub 1269
1272; mul 103 1051; mul 34 1274; sub 1273 1275; mul 92 1051; sub 1276 1277; mul 93 1278; add 1120 1279; mul 846
1280; sub 845 1281; input p 199; input c 4; input p 14; mul 28 1285; sub 2 1286; input c 5; mul 1287 1288; sub 1284
1289; input c 6; mul 404 1291; add 1290 1292; input c 7; mul 517 1294; add 1293 1295; input c 8; input p 15; max
1297 1298; mul 453 1285; sub 444 1300; mul 1299 1301; sub 1296 1302; mul 89 1303; mul 89 1285; add 597 1305; mul
1299 1306; mul 453 1307; add 1304 1308; mul 1288 1306; input c 9; input c 10; mul 328 1312; mul 1287 1313; sub 1311
1314; input c 11; mul 404 1316; add 1315 1317; input c 12; mul 517 1319; add 1318 1320; mul 89 1321; add 1310 1322;
mul 89 1287; mul 1313 1324; sub 1323 1325; mul 28 1326; add 1309 1327; mul 1283 1328; add 1282 1329; mul 55 69; mul
78 78; sub 1331 1332; mul 88 1333; mul 571 1334; mul 560 1334; mul 562 597; add 1336 1337; mul 461 1334; mul 58 69;
mul 75 78; sub 1340 1341; mul 88 1342; mul 467 1343; sub 1339 1344; mul 90 597; mul 325 1346; sub 1345 1347; mul 500
1348; add 1338 1349; mul 553 1350; mul 500 1351; mul 451 1334; mul 454 597; add 1353 1354; mul 384 1348; add 1355
1356; mul 443 1357; mul 384 1358; add 1352 1359; mul 444 1360; sub 1335 1361; mul 459 1362; mul 595 597; mul 484
1350; mul 519 1365; mul 523 1366; mul 566 1350; mul 552 1368; mul 548 1368; mul 551 1370; add 1369 1371; mul 539
1350; add 1372 1373; mul 543 1374; mul 545 1375; mul 507 1375; mul 433 1377; add 1376 1378; sub 1367 1379; mul 507
1366; mul 521 1381; add 1380 1382; mul 506 1365; mul 513 1384; mul 509 1384; mul 511 1386; add 1385 1387; mul 653
1388; mul 648 1389; sub 1383 1390; mul 547 1374; mul 484 1392; mul 664 1393; mul 497 1393; mul 542 1395; add 1394
1396; mul 497 1395; mul 541 1398; add 1397 1399; mul 453 1351; sub 1401 615; mul 490 1402; mul 568 1348; mul 470
1351; add 1404 1405; mul 483 1406; sub 1403 1407; mul 568 1334; mul 444 1351; add 1409 1410; mul 16 1411; mul 558
1412; sub 1408 1413; mul 484 1414; mul 515 1365; mul 501 1416; mul 503 1417; add 1415 1418; mul 498 1417; mul 234
1420; add 1419 1421; mul 674 1422; mul 498 1423; sub 1400 1424; mul 663 1425; add 1391 1426; neg 1417; mul 234 1428;
add 1427 1429; mul 484 1430; mul 624 1431; mul 622 1432; mul 499 1406; mul 499 1412; mul 556 1435; add 1434 1436;
sub 1433 1437; add 1364 1438; mul 571 1343; mul 468 1360; add 1440 1441; mul 465 1442; add 1439 1443; sub 1363 1444;
mul 99 1343; mul 96 1334; sub 1446 1447; mul 93 1346; add 1448 1449; mul 574 1450; mul 577 1451; mul 587 1451; mul
574 1346; mul 577 1454; add 1453 1455; mul 93 1456; add 1452 1457; mul 575 1454; add 1458 1459; mul 325 1360; sub
1460 1461; mul 723 1462; sub 1445 1463; mul 571 1346; mul 457 1360; add 1465 1466; mul 323 1467; sub 1464 1468; mul
66 1467; sub 1469 1470; mul 474 1334; mul 444 1358; add 1472 1473; mul 16 1474; mul 383 1475; mul 447 1476; mul 474
1348; mul 470 1358; add 1478 1479; mul 383 1480; sub 1477 1481; mul 368 1357; mul 406 1483; mul 410 1484; mul 472
1357; mul 442 1486; mul 438 1486; mul 441 1488; add 1487 1489; mul 426 1357; add 1490 1491; mul 431 1492; mul 435
1493; mul 394 1493; mul 433 1495; add 1494 1496; sub 1485 1497; mul 394 1484; mul 408 1499; add 1498 1500; mul 390
1483; mul 400 1502; mul 396 1502; mul 398 1504; add 1503 1505; mul 792 1506; mul 787 1507; sub 1501 1508; mul 437
1492; mul 368 1510; mul 803 1511; mul 381 1511; mul 430 1513; add 1512 1514; mul 381 1513; mul 429 1516; add 1515
1517; mul 453 1358; sub 1519 754; mul 374 1520; mul 367 1480; sub 1521 1522; mul 449 1475; sub 1523 1524; mul 368
1525; mul 402 1483; mul 385 1527; mul 387 1528; add 1526 1529; mul 382 1528; mul 234 1531; add 1530 1532; mul 813
1533; mul 382 1534; sub 1518 1535; mul 802 1536; add 1509 1537; neg 1528; mul 234 1539; add 1538 1540; mul 368 1541;
mul 763 1542; mul 761 1543; add 1482 1544; add 1438 1545; mul 358 1546; add 1471 1547; sub 1548 1545; mul 91 1343;
mul 203 1550; mul 101 1551; mul 847 1552; mul 130 1550; mul 34 1554; mul 847 1555; add 1553 1556; mul 864 1550; mul
847 1558; add 1557 1559; mul 115 1550; mul 101 1561; mul 101 1562; add 1560 1563; mul 872 1550; mul 34 1565; mul 101
1566; add 1564 1567; mul 103 1550; mul 101 1569; add 1568 1570; mul 276 1546; mul 335 1572; mul 34 1573; mul 276
1442; sub 1574 1575; mul 314 1576; mul 101 1577; mul 847 1578; add 1571 1579; mul 283 1576; mul 34 1581; mul 847
1582; add 1580 1583; mul 349 1576; mul 34 1585; mul 101 1586; add 1584 1587; mul 276 1362; mul 96 1589; mul 99 1575;
sub 1590 1591; mul 276 1467; mul 93 1593; sub 1592 1594; mul 101 1573; add 1595 1596; mul 319 1597; mul 147 1598;
add 1588 1599; mul 94 1598; mul 847 1601; add 1600 1602; mul 289 1597; mul 101 1604; mul 847 1605; add 1603 1606;
mul 314 1597; mul 34 1608; mul 847 1609; add 1607 1610; mul 311 1597; mul 101 1612; mul 101 1613; add 1611 1614; mul
278 1597; mul 34 1616; mul 34 1617; add 1615 1618; mul 297 1573; add 1619 1620; mul 94 1573; sub 1622 1593; mul 295
1623; mul 147 1624; add 1621 1625; mul 94 1624; mul 847 1627; add 1626 1628; mul 292 1623; mul 101 1630; mul 847
1631; add 1629 1632; mul 289 1623; mul 101 1634; mul 101 1635; add 1633 1636; mul 286 1623; mul 34 1638; mul 101
1639; add 1637 1640; mul 283 1623; mul 34 1642; mul 34 1643; add 1641 1644; mul 958 1343; where 957 1646; mul 264
1334; neg 1648; where 963 1649; add 1647 1650; mul 250 1346; where 217 1652; add 1651 1653; mul 237 1654; mul 237
1655; mul 973 1343; where 957 1657; mul 977 1334; neg 1659; where 963 1660; add 1658 1661; mul 246 1346; where 217
1663; add 1662 1664; mul 237 1665; mul 260 1343; where 957 1667; mul 989 1334; neg 1669; where 963 1670; add 1668
1671; mul 241 1346; where 217 1673; add 1672 1674; mul 229 1675; add 1666 1676; mul 229 1677; add 1656 1678; mul
1001 1343; where 957 1680; mul 1005 1334; neg 1682; where 963 1683; add 1681 1684; mul 218 1346; where 217 1686; add
1685 1687; mul 222 1688; add 1679 1689; mul 250 1343; where 957 1691; mul 1019 1334; neg 1693; where 963 1694; add
1692 1695; mul 233 1346; where 217 1697; add 1696 1698; mul 237 1699; mul 1019 1343; where 957 1701; mul 241 1334;
neg 1703; where 963 1704; add 1702 1705; mul 225 1346; where 217 1707; add 1706 1708; mul 229 1709; add 1700 1710;
mul 221 1688; add 1711 1712; mul 1015 1713; add 1690 1714; mul 955 1715; mul 950 1716; add 1645 1717; mul 99 1550;
mul 91 1334; mul 96 1720; sub 1719 1721; mul 91 1346; mul 93 1723; add 1722 1724; mul 209 1725; mul 147 1726; add
1718 1727; mul 94 1726; mul 847 1729; add 1728 1730; mul 142 1725; mul 101 1732; mul 847 1733; add 1731 1734; mul
203 1725; mul 34 1736; mul 847 1737; add 1735 1738; mul 200 1725; mul 847 1740; add 1739 1741; mul 197 1725; mul 101
1743; mul 101 1744; add 1742 1745; mul 194 1725; mul 34 1747; mul 101 1748; add 1746 1749; mul 191 1725; mul 101
1751; add 1750 1752; mul 107 1725; mul 34 1754; mul 34 1755; add 1753 1756; mul 103 1725; mul 34 1758; add 1757
1759; mul 92 1725; add 1760 1761; mul 151 1723; mul 147 1763; add 1762 1764; mul 94 1763; mul 847 1766; add 1765
1767; mul 146 1723; mul 101 1769; mul 847 1770; add 1768 1771; mul 142 1723; mul 101 1773; mul 101 1774; add 1772
1775; mul 138 1723; mul 34 1777; mul 101 1778; add 1776 1779; mul 134 1723; mul 101 1781; add 1780 1782; mul 130
1723; mul 34 1784; mul 34 1785; add 1783 1786; mul 126 1723; mul 34 1788; add 1787 1789; mul 123 1723; add 1790
1791; mul 147 1551; mul 135 1561; add 1793 1794; mul 94 1562; add 1795 1796; mul 94 1566; add 1797 1798; mul 94
1569; add 1799 1800; mul 1131 1550; mul 112 1802; add 1801 1803; mul 101 1802; mul 1135 1805; add 1804 1806; mul 173
1550; mul 34 1808; mul 1135 1809; add 1807 1810; mul 1143 1550; mul 1135 1812; add 1811 1813; mul 1147 1550; mul 34
1815; mul 34 1816; add 1814 1817; mul 1152 1550; mul 34 1819; add 1818 1820; mul 156 1550; add 1821 1822; mul 147
1577; add 1823 1824; mul 94 1586; add 1825 1826; mul 346 1576; mul 112 1828; add 1827 1829; mul 101 1828; mul 1135
1831; add 1830 1832; mul 300 1576; mul 34 1834; mul 1135 1835; add 1833 1836; mul 341 1576; mul 34 1838; mul 34
1839; add 1837 1840; mul 321 1573; add 1841 1842; mul 147 1604; add 1843 1844; mul 135 1612; add 1845 1846; mul 94
1613; add 1847 1848; mul 306 1597; mul 112 1850; add 1849 1851; mul 101 1850; mul 1135 1853; add 1852 1854; mul 303
1597; mul 34 1856; mul 1135 1857; add 1855 1858; mul 300 1597; mul 34 1860; mul 34 1861; add 1859 1862; mul 147
1630; add 1863 1864; mul 135 1634; add 1865 1866; mul 94 1635; add 1867 1868; mul 94 1639; add 1869 1870; mul 280
1623; mul 112 1872; add 1871 1873; mul 101 1872; mul 1135 1875; add 1874 1876; mul 278 1623; mul 34 1878; mul 34
1879; add 1877 1880; mul 147 1732; add 1881 1882; mul 135 1743; add 1883 1884; mul 94 1744; add 1885 1886; mul 94
1748; add 1887 1888; mul 94 1751; add 1889 1890; mul 182 1725; mul 112 1892; add 1891 1893; mul 101 1892; mul 1135
1895; add 1894 1896; mul 179 1725; mul 34 1898; mul 1135 1899; add 1897 1900; mul 176 1725; mul 1135 1902; add 1901
1903; mul 173 1725; mul 34 1905; mul 34 1906; add 1904 1907; mul 170 1725; mul 34 1909; add 1908 1910; mul 167 1725;
add 1911 1912; mul 147 1769; add 1913 1914; mul 135 1773; add 1915 1916; mul 94 1774; add 1917 1918; mul 94 1778;
add 1919 1920; mul 94 1781; add 1921 1922; mul 119 1723; mul 112 1924; add 1923 1925; mul 101 1924; mul 1135 1927;
add 1926 1928; mul 115 1723; mul 34 1930; mul 1135 1931; add 1929 1932; mul 111 1723; mul 1135 1934; add 1933 1935;
mul 107 1723; mul 34 1937; mul 34 1938; add 1936 1939; mul 103 1723; mul 34 1941; add 1940 1942; mul 92 1723; add
1943 1944; mul 93 1945; add 1792 1946; mul 846 1947; sub 1549 1948; mul 597 1303; mul 597 1285; add 1334 1951; mul
1299 1952; mul 453 1953; add 1950 1954; mul 597 1287; mul 1313 1956; mul 1288 1952; mul 597 1321; add 1958 1959; sub
1957 1960; mul 28 1961; sub 1955 1962; mul 1283 1963; sub 1949 1964; mul 595 601; mul 560 1343; mul 562 601; add
1967 1968; mul 44 69; mul 75 75; sub 1970 1971; mul 88 1972; mul 467 1973; mul 461 1343; sub 1974 1975; mul 90 601;
mul 325 1977; add 1976 1978; mul 500 1979; sub 1969 1980; mul 553 1981; mul 470 1982; mul 568 1979; sub 1983 1984;
mul 499 1985; mul 568 1343; mul 444 1982; add 1987 1988; mul 16 1989; mul 499 1990; mul 556 1991; add 1986 1992; mul
566 1981; mul 552 1994; mul 548 1994; mul 551 1996; add 1995 1997; mul 539 1981; add 1998 1999; mul 543 2000; mul
545 2001; mul 507 2001; mul 433 2003; add 2002 2004; mul 484 1981; mul 519 2006; mul 523 2007; sub 2005 2008; mul
507 2007; mul 521 2010; sub 2009 2011; mul 506 2006; mul 513 2013; mul 509 2013; mul 511 2015; add 2014 2016; mul
653 2017; mul 648 2018; add 2012 2019; mul 547 2000; mul 484 2021; mul 664 2022; mul 497 2022; mul 542 2024; add
2023 2025; mul 497 2024; mul 541 2027; add 2026 2028; mul 483 1985; mul 568 601; mul 453 1982; sub 2031 2032; mul
490 2033; add 2030 2034; mul 558 1990; add 2035 2036; mul 484 2037; mul 515 2006; mul 501 2039; mul 503 2040; sub
2038 2041; mul 498 2040; neg 2043; mul 234 2044; add 2042 2045; mul 674 2046; mul 498 2047; add 2029 2048; mul 663
2049; sub 2020 2050; mul 234 2040; add 2051 2052; mul 484 2053; mul 624 2054; mul 622 2055; add 1993 2056; sub 1966
2057; mul 571 1973; mul 500 1982; mul 451 1343; mul 454 601; add 2061 2062; mul 384 1979; sub 2063 2064; mul 443
2065; mul 384 2066; add 2060 2067; mul 468 2068; add 2059 2069; mul 465 2070; add 2058 2071; mul 444 2068; sub 2073
1440; mul 459 2074; add 2072 2075; mul 96 1343; mul 99 1973; sub 2077 2078; mul 93 1977; sub 2079 2080; mul 574
2081; mul 577 2082; mul 587 2082; mul 574 1977; mul 577 2085; sub 2084 2086; mul 93 2087; add 2083 2088; mul 575
2085; sub 2089 2090; mul 325 2068; add 2091 2092; mul 723 2093; sub 2076 2094; mul 571 1977; mul 457 2068; add 2096
2097; mul 323 2098; add 2095 2099; mul 66 2098; add 2100 2101; mul 470 2066; mul 474 1979; sub 2103 2104; mul 383
2105; mul 474 1343; mul 444 2066; add 2107 2108; mul 16 2109; mul 383 2110; mul 447 2111; sub 2106 2112; mul 472
2065; mul 442 2114; mul 438 2114; mul 441 2116; add 2115 2117; mul 426 2065; add 2118 2119; mul 431 2120; mul 435
2121; mul 394 2121; mul 433 2123; add 2122 2124; mul 368 2065; mul 406 2126; mul 410 2127; sub 2125 2128; mul 394
2127; mul 408 2130; sub 2129 2131; mul 390 2126; mul 400 2133; mul 396 2133; mul 398 2135; add 2134 2136; mul 792
2137; mul 787 2138; add 2132 2139; mul 437 2120; mul 368 2141; mul 803 2142; mul 381 2142; mul 430 2144; add 2143
2145; mul 381 2144; mul 429 2147; add 2146 2148; mul 367 2105; mul 474 601; mul 453 2066; sub 2151 2152; mul 374
2153; add 2150 2154; mul 449 2110; add 2155 2156; mul 368 2157; mul 402 2126; mul 385 2159; mul 387 2160; sub 2158
2161; mul 382 2160; neg 2163; mul 234 2164; add 2162 2165; mul 813 2166; mul 382 2167; add 2149 2168; mul 802 2169;
sub 2140 2170; mul 234 2160; add 2171 2172; mul 368 2173; mul 763 2174; mul 761 2175; add 2113 2176; add 2057 2177;
mul 358 2178; add 2102 2179; sub 2180 2177; mul 276 2070; mul 276 2178; mul 335 2183; mul 34 2184; add 2182 2185;
mul 314 2186; mul 101 2187; mul 847 2188; mul 91 1973; mul 203 2190; mul 101 2191; mul 847 2192; mul 130 2190; mul
34 2194; mul 847 2195; add 2193 2196; mul 864 2190; mul 847 2198; add 2197 2199; mul 115 2190; mul 101 2201; mul 101
2202; add 2200 2203; mul 872 2190; mul 34 2205; mul 101 2206; add 2204 2207; mul 103 2190; mul 101 2209; add 2208
2210; sub 2189 2211; mul 283 2186; mul 34 2213; mul 847 2214; add 2212 2215; mul 349 2186; mul 34 2217; mul 101
2218; add 2216 2219; mul 99 2182; mul 276 2074; mul 96 2222; add 2221 2223; mul 276 2098; mul 93 2225; add 2224
2226; mul 101 2184; add 2227 2228; mul 319 2229; mul 147 2230; add 2220 2231; mul 94 2230; mul 847 2233; add 2232
2234; mul 289 2229; mul 101 2236; mul 847 2237; add 2235 2238; mul 314 2229; mul 34 2240; mul 847 2241; add 2239
2242; mul 311 2229; mul 101 2244; mul 101 2245; add 2243 2246; mul 278 2229; mul 34 2248; mul 34 2249; add 2247
2250; mul 297 2184; add 2251 2252; mul 94 2184; add 2225 2254; mul 295 2255; mul 147 2256; add 2253 2257; mul 94
2256; mul 847 2259; add 2258 2260; mul 292 2255; mul 101 2262; mul 847 2263; add 2261 2264; mul 289 2255; mul 101
2266; mul 101 2267; add 2265 2268; mul 286 2255; mul 34 2270; mul 101 2271; add 2269 2272; mul 283 2255; mul 34
2274; mul 34 2275; add 2273 2276; mul 958 1973; neg 2278; where 957 2279; mul 264 1343; where 963 2281; add 2280
2282; mul 250 1977; neg 2284; where 217 2285; add 2283 2286; mul 237 2287; mul 237 2288; mul 973 1973; neg 2290;
where 957 2291; mul 977 1343; where 963 2293; add 2292 2294; mul 246 1977; neg 2296; where 217 2297; add 2295 2298;
mul 237 2299; mul 260 1973; neg 2301; where 957 2302; mul 989 1343; where 963 2304; add 2303 2305; mul 241 1977; neg
2307; where 217 2308; add 2306 2309; mul 229 2310; add 2300 2311; mul 229 2312; add 2289 2313; mul 1001 1973; neg
2315; where 957 2316; mul 1005 1343; where 963 2318; add 2317 2319; mul 218 1977; neg 2321; where 217 2322; add 2320
2323; mul 222 2324; add 2314 2325; mul 250 1973; neg 2327; where 957 2328; where 963 1701; add 2329 2330; mul 233
1977; neg 2332; where 217 2333; add 2331 2334; mul 237 2335; mul 1019 1973; neg 2337; where 957 2338; mul 241 1343;
where 963 2340; add 2339 2341; mul 225 1977; neg 2343; where 217 2344; add 2342 2345; mul 229 2346; add 2336 2347;
mul 221 2324; add 2348 2349; mul 1015 2350; add 2326 2351; mul 955 2352; mul 950 2353; add 2277 2354; mul 96 1550;
mul 99 2190; sub 2356 2357; mul 91 1977; mul 93 2359; sub 2358 2360; mul 209 2361; mul 147 2362; add 2355 2363; mul
94 2362; mul 847 2365; add 2364 2366; mul 142 2361; mul 101 2368; mul 847 2369; add 2367 2370; mul 203 2361; mul 34
2372; mul 847 2373; add 2371 2374; mul 200 2361; mul 847 2376; add 2375 2377; mul 197 2361; mul 101 2379; mul 101
2380; add 2378 2381; mul 194 2361; mul 34 2383; mul 101 2384; add 2382 2385; mul 191 2361; mul 101 2387; add 2386
2388; mul 107 2361; mul 34 2390; mul 34 2391; add 2389 2392; mul 103 2361; mul 34 2394; add 2393 2395; mul 92 2361;
add 2396 2397; mul 151 2359; mul 147 2399; sub 2398 2400; mul 94 2399; mul 847 2402; sub 2401 2403; mul 146 2359;
mul 101 2405; mul 847 2406; sub 2404 2407; mul 142 2359; mul 101 2409; mul 101 2410; sub 2408 2411; mul 138 2359;
mul 34 2413; mul 101 2414; sub 2412 2415; mul 134 2359; mul 101 2417; sub 2416 2418; mul 130 2359; mul 34 2420; mul
34 2421; sub 2419 2422; mul 126 2359; mul 34 2424; sub 2423 2425; mul 123 2359; sub 2426 2427; mul 147 2187; mul 147
2191; mul 135 2201; add 2430 2431; mul 94 2202; add 2432 2433; mul 94 2206; add 2434 2435; mul 94 2209; add 2436
2437; mul 1131 2190; mul 112 2439; add 2438 2440; mul 101 2439; mul 1135 2442; add 2441 2443; mul 173 2190; mul 34
2445; mul 1135 2446; add 2444 2447; mul 1143 2190; mul 1135 2449; add 2448 2450; mul 1147 2190; mul 34 2452; mul 34
2453; add 2451 2454; mul 1152 2190; mul 34 2456; add 2455 2457; mul 156 2190; add 2458 2459; sub 2429 2460; mul 94
2218; add 2461 2462; mul 346 2186; mul 112 2464; add 2463 2465; mul 101 2464; mul 1135 2467; add 2466 2468; mul 300
2186; mul 34 2470; mul 1135 2471; add 2469 2472; mul 341 2186; mul 34 2474; mul 34 2475; add 2473 2476; mul 321
2184; add 2477 2478; mul 147 2236; add 2479 2480; mul 135 2244; add 2481 2482; mul 94 2245; add 2483 2484; mul 306
2229; mul 112 2486; add 2485 2487; mul 101 2486; mul 1135 2489; add 2488 2490; mul 303 2229; mul 34 2492; mul 1135
2493; add 2491 2494; mul 300 2229; mul 34 2496; mul 34 2497; add 2495 2498; mul 147 2262; add 2499 2500; mul 135
2266; add 2501 2502; mul 94 2267; add 2503 2504; mul 94 2271; add 2505 2506; mul 280 2255; mul 112 2508; add 2507
2509; mul 101 2508; mul 1135 2511; add 2510 2512; mul 278 2255; mul 34 2514; mul 34 2515; add 2513 2516; mul 147
2368; add 2517 2518; mul 135 2379; add 2519 2520; mul 94 2380; add 2521 2522; mul 94 2384; add 2523 2524; mul 94
2387; add 2525 2526; mul 182 2361; mul 112 2528; add 2527 2529; mul 101 2528; mul 1135 2531; add 2530 2532; mul 179
2361; mul 34 2534; mul 1135 2535; add 2533 2536; mul 176 2361; mul 1135 2538; add 2537 2539; mul 173 2361; mul 34
2541; mul 34 2542; add 2540 2543; mul 170 2361; mul 34 2545; add 2544 2546; mul 167 2361; add 2547 2548; mul 147
2405; sub 2549 2550; mul 135 2409; sub 2551 2552; mul 94 2410; sub 2553 2554; mul 94 2414; sub 2555 2556; mul 94
2417; sub 2557 2558; mul 119 2359; mul 112 2560; sub 2559 2561; mul 101 2560; mul 1135 2563; sub 2562 2564; mul 115
2359; mul 34 2566; mul 1135 2567; sub 2565 2568; mul 111 2359; mul 1135 2570; sub 2569 2571; mul 107 2359; mul 34
2573; mul 34 2574; sub 2572 2575; mul 103 2359; mul 34 2577; sub 2576 2578; mul 92 2359; sub 2579 2580; mul 93 2581;
add 2428 2582; mul 846 2583; sub 2181 2584; mul 601 1303; mul 601 1285; add 1343 2587; mul 1299 2588; mul 453 2589;
add 2586 2590; mul 1288 2588; mul 601 1321; add 2592 2593; mul 601 1287; mul 1313 2595; sub 2594 2596; mul 28 2597;
add 2591 2598; mul 1283 2599; add 2585 2600; mul 384 438; mul 468 2602; mul 465 2603; mul 444 2602; mul 459 2605;
add 2604 2606; mul 325 2602; mul 723 2608; sub 2607 2609; mul 457 2602; mul 323 2611; add 2610 2612; mul 66 2611;
add 2613 2614; mul 438 470; mul 383 2616; mul 438 444; mul 16 2618; mul 383 2619; mul 447 2620; sub 2617 2621; mul
431 472; mul 435 2623; mul 394 2623; mul 433 2625; add 2624 2626; mul 437 472; mul 368 2628; mul 803 2629; mul 381
2629; mul 430 2631; add 2630 2632; mul 381 2631; mul 429 2634; add 2633 2635; mul 367 2616; mul 438 453; mul 374
2638; sub 2637 2639; mul 449 2619; add 2640 2641; mul 368 2642; mul 813 2643; mul 382 2644; add 2636 2645; mul 802
2646; sub 2627 2647; mul 368 2648; mul 763 2649; mul 761 2650; add 2622 2651; mul 358 2652; add 2615 2653; sub 2654
2652; mul 276 2603; mul 276 2652; mul 335 2657; mul 34 2658; add 2656 2659; mul 314 2660; mul 101 2661; mul 847
2662; mul 283 2660; mul 34 2664; mul 847 2665; add 2663 2666; mul 349 2660; mul 34 2668; mul 101 2669; add 2667
2670; mul 99 2656; mul 276 2605; mul 96 2673; add 2672 2674; mul 276 2611; mul 93 2676; add 2675 2677; mul 101 2658;
add 2678 2679; mul 319 2680; mul 147 2681; add 2671 2682; mul 94 2681; mul 847 2684; add 2683 2685; mul 289 2680;
mul 101 2687; mul 847 2688; add 2686 2689; mul 314 2680; mul 34 2691; mul 847 2692; add 2690 2693; mul 311 2680; mul
101 2695; mul 101 2696; add 2694 2697; mul 278 2680; mul 34 2699; mul 34 2700; add 2698 2701; mul 297 2658; add 2702
2703; mul 94 2658; add 2676 2705; mul 295 2706; mul 147 2707; add 2704 2708; mul 94 2707; mul 847 2710; add 2709
2711; mul 292 2706; mul 101 2713; mul 847 2714; add 2712 2715; mul 289 2706; mul 101 2717; mul 101 2718; add 2716
2719; mul 286 2706; mul 34 2721; mul 101 2722; add 2720 2723; mul 283 2706; mul 34 2725; mul 34 2726; add 2724 2727;
mul 147 2661; mul 94 2669; add 2729 2730; mul 346 2660; mul 112 2732; add 2731 2733; mul 101 2732; mul 1135 2735;
add 2734 2736; mul 300 2660; mul 34 2738; mul 1135 2739; add 2737 2740; mul 341 2660; mul 34 2742; mul 34 2743; add
2741 2744; mul 321 2658; add 2745 2746; mul 147 2687; add 2747 2748; mul 135 2695; add 2749 2750; mul 94 2696; add
2751 2752; mul 306 2680; mul 112 2754; add 2753 2755; mul 101 2754; mul 1135 2757; add 2756 2758; mul 303 2680; mul
34 2760; mul 1135 2761; add 2759 2762; mul 300 2680; mul 34 2764; mul 34 2765; add 2763 2766; mul 147 2713; add 2767
2768; mul 135 2717; add 2769 2770; mul 94 2718; add 2771 2772; mul 94 2722; add 2773 2774; mul 280 2706; mul 112
2776; add 2775 2777; mul 101 2776; mul 1135 2779; add 2778 2780; mul 278 2706; mul 34 2782; mul 34 2783; add 2781
2784; mul 93 2785; add 2728 2786; mul 846 2787; sub 2655 2788; mul 500 548; mul 468 2790; mul 465 2791; mul 470 548;
mul 499 2793; mul 444 548; mul 16 2795; mul 499 2796; mul 556 2797; add 2794 2798; mul 543 566; mul 545 2800; mul
507 2800; mul 433 2802; add 2801 2803; mul 547 566; mul 484 2805; mul 664 2806; mul 497 2806; mul 542 2808; add 2807
2809; mul 497 2808; mul 541 2811; add 2810 2812; mul 483 2793; mul 453 548; mul 490 2815; sub 2814 2816; mul 558
2796; add 2817 2818; mul 484 2819; mul 674 2820; mul 498 2821; add 2813 2822; mul 663 2823; sub 2804 2824; mul 484
2825; mul 624 2826; mul 622 2827; add 2799 2828; sub 2792 2829; mul 444 2790; mul 459 2831; add 2830 2832; mul 325
2790; mul 723 2834; sub 2833 2835; mul 457 2790; mul 323 2837; add 2836 2838; mul 66 2837; add 2839 2840; mul 358
2829; add 2841 2842; mul 276 2791; mul 276 2829; mul 335 2845; mul 34 2846; add 2844 2847; mul 314 2848; mul 101
2849; mul 847 2850; mul 283 2848; mul 34 2852; mul 847 2853; add 2851 2854; mul 349 2848; mul 34 2856; mul 101 2857;
add 2855 2858; mul 99 2844; mul 276 2831; mul 96 2861; add 2860 2862; mul 276 2837; mul 93 2864; add 2863 2865; mul
101 2846; add 2866 2867; mul 319 2868; mul 147 2869; add 2859 2870; mul 94 2869; mul 847 2872; add 2871 2873; mul
289 2868; mul 101 2875; mul 847 2876; add 2874 2877; mul 314 2868; mul 34 2879; mul 847 2880; add 2878 2881; mul 311
2868; mul 101 2883; mul 101 2884; add 2882 2885; mul 278 2868; mul 34 2887; mul 34 2888; add 2886 2889; mul 297
2846; add 2890 2891; mul 94 2846; add 2864 2893; mul 295 2894; mul 147 2895; add 2892 2896; mul 94 2895; mul 847
2898; add 2897 2899; mul 292 2894; mul 101 2901; mul 847 2902; add 2900 2903; mul 289 2894; mul 101 2905; mul 101
2906; add 2904 2907; mul 286 2894; mul 34 2909; mul 101 2910; add 2908 2911; mul 283 2894; mul 34 2913; mul 34 2914;
add 2912 2915; mul 147 2849; mul 94 2857; add 2917 2918; mul 346 2848; mul 112 2920; add 2919 2921; mul 101 2920;
mul 1135 2923; add 2922 2924; mul 300 2848; mul 34 2926; mul 1135 2927; add 2925 2928; mul 341 2848; mul 34 2930;
mul 34 2931; add 2929 2932; mul 321 2846; add 2933 2934; mul 147 2875; add 2935 2936; mul 135 2883; add 2937 2938;
mul 94 2884; add 2939 2940; mul 306 2868; mul 112 2942; add 2941 2943; mul 101 2942; mul 1135 2945; add 2944 2946;
mul 303 2868; mul 34 2948; mul 1135 2949; add 2947 2950; mul 300 2868; mul 34 2952; mul 34 2953; add 2951 2954; mul
147 2901; add 2955 2956; mul 135 2905; add 2957 2958; mul 94 2906; add 2959 2960; mul 94 2910; add 2961 2962; mul
280 2894; mul 112 2964; add 2963 2965; mul 101 2964; mul 1135 2967; add 2966 2968; mul 278 2894; mul 34 2970; mul 34
2971; add 2969 2972; mul 93 2973; add 2916 2974; mul 846 2975; sub 2843 2976; input p 200; mul 261 601; mul 2978
2979; neg 2980; mul 234 2981; input p 201; mul 271 601; mul 2983 2984; mul 587 2985; constant 3.0; input p 202; mul
266 601; mul 2988 2989; mul 2987 2990; add 2986 2991; sub 2982 2992; input p 203; mul 257 601; mul 2994 2995; sub
2993 2996; input p 204; mul 252 601; mul 2998 2999; mul 2987 3000; sub 2997 3001; input p 205; mul 247 601; mul 3003
3004; neg 3005; mul 234 3006; add 3002 3007; input p 206; mul 243 601; mul 3009 3010; sub 3008 3011; input p 207;
mul 238 601; mul 3013 3014; neg 3015; mul 234 3016; add 3012 3017; input p 208; mul 230 601; mul 3019 3020; sub 3018
3021; input p 209; mul 223 601; mul 3023 3024; sub 3022 3025; where 957 3026; input p 136; mul 34 3028; input p 137;
mul 160 3030; add 3029 3031; input p 138; mul 164 3033; add 3032 3034; mul 101 156; add 3035 3036; mul 104 1152; add
3037 3038; mul 108 1147; add 3039 3040; mul 112 1143; add 3041 3042; mul 116 173; add 3043 3044; mul 120 1131; add
3045 3046; mul 103 135; add 3047 3048; mul 139 872; add 3049 3050; mul 115 143; add 3051 3052; mul 147 864; add 3053
3054; mul 130 204; add 3055 3056; mul 148 203; add 3057 3058; mul 99 211; add 3059 3060; mul 601 3061; sub 3027
3062; mul 271 597; mul 2988 3064; where 963 3065; add 3063 3066; mul 266 597; mul 2978 3068; mul 234 3069; where 963
3070; add 3067 3071; mul 261 597; mul 2994 3073; mul 2987 3074; where 963 3075; add 3072 3076; input p 210; mul 257
597; mul 3078 3079; mul 587 3080; where 963 3081; add 3077 3082; mul 252 597; mul 3003 3084; where 963 3085; add
3083 3086; mul 247 597; mul 3009 3088; mul 234 3089; where 963 3090; add 3087 3091; input p 211; mul 243 597; mul
3093 3094; mul 2987 3095; where 963 3096; add 3092 3097; mul 238 597; mul 3019 3099; where 963 3100; add 3098 3101;
input p 212; mul 230 597; mul 3103 3104; mul 234 3105; where 963 3106; add 3102 3107; input p 213; mul 223 597; mul
3109 3110; where 963 3111; add 3108 3112; mul 96 211; mul 597 3114; add 3113 3115; mul 271 605; mul 2998 3117; neg
3118; where 217 3119; add 3116 3120; mul 266 605; mul 3003 3122; neg 3123; where 217 3124; add 3121 3125; mul 261
605; mul 3009 3127; neg 3128; where 217 3129; add 3126 3130; mul 257 605; mul 3093 3132; neg 3133; where 217 3134;
add 3131 3135; mul 252 605; mul 3013 3137; neg 3138; mul 234 3139; where 217 3140; add 3136 3141; mul 247 605; mul
3019 3143; neg 3144; mul 234 3145; where 217 3146; add 3142 3147; mul 243 605; mul 3103 3149; neg 3150; mul 234
3151; where 217 3152; add 3148 3153; mul 238 605; mul 3023 3155; mul 2987 3156; neg 3157; where 217 3158; add 3154
3159; mul 230 605; mul 3109 3161; mul 2987 3162; neg 3163; where 217 3164; add 3160 3165; input p 214; mul 223 605;
mul 3167 3168; mul 587 3169; neg 3170; where 217 3171; add 3166 3172; mul 213 605; sub 3173 3174; mul 271 1343; mul
2983 3176; mul 587 3177; mul 266 1343; mul 2988 3179; mul 2987 3180; add 3178 3181; mul 261 1343; mul 2978 3183; mul
234 3184; add 3182 3185; mul 257 1343; mul 2994 3187; add 3186 3188; mul 252 1343; mul 2998 3190; mul 2987 3191; add
3189 3192; mul 247 1343; mul 3003 3194; mul 234 3195; add 3193 3196; mul 243 1343; mul 3009 3198; add 3197 3199; mul
238 1343; mul 3013 3201; mul 234 3202; add 3200 3203; mul 230 1343; mul 3019 3205; add 3204 3206; mul 223 1343; mul
3023 3208; add 3207 3209; where 957 3210; mul 1343 3061; add 3211 3212; mul 271 1334; mul 2988 3214; neg 3215; where
963 3216; add 3213 3217; mul 266 1334; mul 2978 3219; neg 3220; mul 234 3221; where 963 3222; add 3218 3223; mul 261
1334; mul 2994 3225; mul 2987 3226; neg 3227; where 963 3228; add 3224 3229; mul 257 1334; mul 3078 3231; mul 587
3232; neg 3233; where 963 3234; add 3230 3235; mul 252 1334; mul 3003 3237; neg 3238; where 963 3239; add 3236 3240;
mul 247 1334; mul 3009 3242; neg 3243; mul 234 3244; where 963 3245; add 3241 3246; mul 243 1334; mul 3093 3248; mul
2987 3249; neg 3250; where 963 3251; add 3247 3252; mul 238 1334; mul 3019 3254; neg 3255; where 963 3256; add 3253
3257; mul 230 1334; mul 3103 3259; neg 3260; mul 234 3261; where 963 3262; add 3258 3263; mul 223 1334; mul 3109
3265; neg 3266; where 963 3267; add 3264 3268; mul 1334 3114; sub 3269 3270; mul 271 1346; mul 2998 3272; where 217
3273; add 3271 3274; mul 266 1346; mul 3003 3276; where 217 3277; add 3275 3278; mul 261 1346; mul 3009 3280; where
217 3281; add 3279 3282; mul 257 1346; mul 3093 3284; where 217 3285; add 3283 3286; mul 252 1346; mul 3013 3288;
mul 234 3289; where 217 3290; add 3287 3291; mul 247 1346; mul 3019 3293; mul 234 3294; where 217 3295; add 3292
3296; mul 243 1346; mul 3103 3298; mul 234 3299; where 217 3300; add 3297 3301; mul 238 1346; mul 3023 3303; mul
2987 3304; where 217 3305; add 3302 3306; mul 230 1346; mul 3109 3308; mul 2987 3309; where 217 3310; add 3307 3311;
mul 223 1346; mul 3167 3313; mul 587 3314; where 217 3315; add 3312 3316; mul 213 1346; add 3317 3318; mul 261 1973;
mul 2978 3320; neg 3321; mul 234 3322; mul 271 1973; mul 2983 3324; mul 587 3325; mul 266 1973; mul 2988 3327; mul
2987 3328; add 3326 3329; sub 3323 3330; mul 257 1973; mul 2994 3332; sub 3331 3333; mul 252 1973; mul 2998 3335;
mul 2987 3336; sub 3334 3337; mul 247 1973; mul 3003 3339; neg 3340; mul 234 3341; add 3338 3342; mul 243 1973; mul
3009 3344; sub 3343 3345; mul 238 1973; mul 3013 3347; neg 3348; mul 234 3349; add 3346 3350; mul 230 1973; mul 3019
3352; sub 3351 3353; mul 223 1973; mul 3023 3355; sub 3354 3356; where 957 3357; mul 1973 3061; sub 3358 3359; mul
2988 3176; where 963 3361; add 3360 3362; mul 2978 3179; mul 234 3364; where 963 3365; add 3363 3366; mul 2994 3183;
mul 2987 3368; where 963 3369; add 3367 3370; mul 3078 3187; mul 587 3372; where 963 3373; add 3371 3374; mul 3003
3190; where 963 3376; add 3375 3377; mul 3009 3194; mul 234 3379; where 963 3380; add 3378 3381; mul 3093 3198; mul
2987 3383; where 963 3384; add 3382 3385; mul 3019 3201; where 963 3387; add 3386 3388; mul 3103 3205; mul 234 3390;
where 963 3391; add 3389 3392; mul 3109 3208; where 963 3394; add 3393 3395; mul 1343 3114; add 3396 3397; mul 271
1977; mul 2998 3399; neg 3400; where 217 3401; add 3398 3402; mul 266 1977; mul 3003 3404; neg 3405; where 217 3406;
add 3403 3407; mul 261 1977; mul 3009 3409; neg 3410; where 217 3411; add 3408 3412; mul 257 1977; mul 3093 3414;
neg 3415; where 217 3416; add 3413 3417; mul 252 1977; mul 3013 3419; neg 3420; mul 234 3421; where 217 3422; add
3418 3423; mul 247 1977; mul 3019 3425; neg 3426; mul 234 3427; where 217 3428; add 3424 3429; mul 243 1977; mul
3103 3431; neg 3432; mul 234 3433; where 217 3434; add 3430 3435; mul 238 1977; mul 3023 3437; mul 2987 3438; neg
3439; where 217 3440; add 3436 3441; mul 230 1977; mul 3109 3443; mul 2987 3444; neg 3445; where 217 3446; add 3442
3447; mul 223 1977; mul 3167 3449; mul 587 3450; neg 3451; where 217 3452; add 3448 3453; mul 213 1977; sub 3454
3455; mul 589 728; constant 0.8; mul 468 601; mul 3458 3459; sub 3457 3460; mul 584 605; sub 3461 3462; mul 1301
1306; le 1297 1298; le 1298 1297; add 3465 3466; div 1 3467; mul 3465 3468; mul 3464 3469; mul 235 3470; add 3463
3471; mul 468 1343; mul 3458 3473; mul 589 1450; add 3474 3475; mul 584 1346; add 3476 3477; mul 1301 1952; mul 3469
3479; mul 235 3480; sub 3478 3481; mul 589 2081; mul 468 1973; mul 3458 3484; sub 3483 3485; mul 584 1977; sub 3486
3487; mul 1301 2588; mul 3469 3489; mul 235 3490; add 3488 3491; constant -2.5714285714285743; mul 152 1053; mul
3493 3494; constant -0.8571428571428583; mul 148 856; mul 3496 3497; constant 0.9142857142857138; mul 204 856; mul
3499 3500; add 3498 3501; constant 0.05714285714285722; mul 143 856; mul 3503 3504; add 3502 3505; constant
-0.11428571428571327; mul 139 856; mul 3507 3508; add 3506 3509; constant 0.2190476190476189; mul 120 856; mul 3511
3512; add 3510 3513; constant 0.11428571428571413; mul 116 856; mul 3515 3516; add 3514 3517; constant
-0.05714285714285729; mul 108 856; mul 3519 3520; add 3518 3521; input p 215; constant -0.033333333333333326; mul
101 856; mul 3524 3525; mul 3523 3526; add 3522 3527; constant 0.007256235827664418; mul 164 856; mul 3529 3530; add
3528 3531; constant 0.01904761904761903; mul 34 856; mul 3533 3534; mul 3523 3535; add 3532 3536; sub 3495 3537;
constant 2.057142857142858; mul 148 1053; mul 3539 3540; add 3538 3541; mul 204 1053; mul 3496 3543; add 3542 3544;
constant -3.428571428571427; mul 143 1053; mul 3546 3547; add 3545 3548; constant 0.11428571428571443; mul 139 1053;
mul 3550 3551; add 3549 3552; constant -0.057142857142856635; mul 131 1053; mul 3554 3555; add 3553 3556; constant
-0.09999999999999995; mul 94 1053; mul 3558 3559; mul 3523 3560; add 3557 3561; constant 2.438095238095238; mul 120
1053; mul 3563 3564; add 3562 3565; constant 0.6571428571428567; mul 116 1053; mul 3567 3568; add 3566 3569; input p
216; mul 112 1053; mul 3571 3572; sub 3570 3573; mul 108 1053; mul 3515 3575; add 3574 3576; constant
0.13333333333333333; mul 101 1053; mul 3578 3579; mul 3523 3580; add 3577 3581; constant -0.019047619047619094; mul
164 1053; mul 3583 3584; add 3582 3585; mul 34 1053; mul 3524 3587; mul 3523 3588; add 3586 3589; constant
12.34285714285715; mul 152 1051; mul 3591 3592; sub 3590 3593; constant -7.714285714285722; mul 148 1051; mul 3595
3596; sub 3594 3597; mul 143 1051; mul 3539 3599; sub 3598 3600; constant -1.7142857142857166; mul 139 1051; mul
3602 3603; sub 3601 3604; mul 131 1051; mul 3499 3606; sub 3605 3607; constant 1.2; mul 94 1051; mul 3609 3610; mul
3523 3611; sub 3608 3612; constant -1.1428571428571423; mul 120 1051; mul 3614 3615; sub 3613 3616; mul 116 1051;
mul 3503 3618; sub 3617 3619; mul 108 1051; mul 3554 3621; sub 3620 3622; mul 101 1051; mul 3558 3624; mul 3523
3625; sub 3623 3626; mul 148 1550; mul 3496 3628; mul 204 1550; mul 3499 3630; add 3629 3631; mul 143 1550; mul 3503
3633; add 3632 3634; mul 139 1550; mul 3507 3636; add 3635 3637; mul 120 1550; mul 3511 3639; add 3638 3640; mul 116
1550; mul 3515 3642; add 3641 3643; mul 108 1550; mul 3519 3645; add 3644 3646; mul 101 1550; mul 3524 3648; mul
3523 3649; add 3647 3650; mul 164 1550; mul 3529 3652; add 3651 3653; mul 34 1550; mul 3533 3655; mul 3523 3656; add
3654 3657; mul 152 1725; mul 3493 3659; add 3658 3660; mul 148 1725; mul 3539 3662; add 3661 3663; mul 204 1725; mul
3496 3665; add 3664 3666; mul 143 1725; mul 3546 3668; add 3667 3669; mul 139 1725; mul 3550 3671; add 3670 3672;
mul 131 1725; mul 3554 3674; add 3673 3675; mul 94 1725; mul 3558 3677; mul 3523 3678; add 3676 3679; mul 120 1725;
mul 3563 3681; add 3680 3682; mul 116 1725; mul 3567 3684; add 3683 3685; mul 112 1725; mul 3571 3687; sub 3686
3688; mul 108 1725; mul 3515 3690; add 3689 3691; mul 101 1725; mul 3578 3693; mul 3523 3694; add 3692 3695; mul 164
1725; mul 3583 3697; add 3696 3698; mul 34 1725; mul 3524 3700; mul 3523 3701; add 3699 3702; mul 152 1723; mul 3591
3704; add 3703 3705; mul 148 1723; mul 3595 3707; add 3706 3708; mul 143 1723; mul 3539 3710; add 3709 3711; mul 139
1723; mul 3602 3713; add 3712 3714; mul 131 1723; mul 3499 3716; add 3715 3717; mul 94 1723; mul 3609 3719; mul 3523
3720; add 3718 3721; mul 120 1723; mul 3614 3723; add 3722 3724; mul 116 1723; mul 3503 3726; add 3725 3727; mul 108
1723; mul 3554 3729; add 3728 3730; mul 101 1723; mul 3558 3732; mul 3523 3733; add 3731 3734; mul 152 2361; mul
3493 3736; mul 148 2190; mul 3496 3738; mul 204 2190; mul 3499 3740; add 3739 3741; mul 143 2190; mul 3503 3743; add
3742 3744; mul 139 2190; mul 3507 3746; add 3745 3747; mul 120 2190; mul 3511 3749; add 3748 3750; mul 116 2190; mul
3515 3752; add 3751 3753; mul 108 2190; mul 3519 3755; add 3754 3756; mul 101 2190; mul 3524 3758; mul 3523 3759;
add 3757 3760; mul 164 2190; mul 3529 3762; add 3761 3763; mul 34 2190; mul 3533 3765; mul 3523 3766; add 3764 3767;
sub 3737 3768; mul 148 2361; mul 3539 3770; add 3769 3771; mul 204 2361; mul 3496 3773; add 3772 3774; mul 143 2361;
mul 3546 3776; add 3775 3777; mul 139 2361; mul 3550 3779; add 3778 3780; mul 131 2361; mul 3554 3782; add 3781
3783; mul 94 2361; mul 3558 3785; mul 3523 3786; add 3784 3787; mul 120 2361; mul 3563 3789; add 3788 3790; mul 116
2361; mul 3567 3792; add 3791 3793; mul 112 2361; mul 3571 3795; sub 3794 3796; mul 108 2361; mul 3515 3798; add
3797 3799; mul 101 2361; mul 3578 3801; mul 3523 3802; add 3800 3803; mul 164 2361; mul 3583 3805; add 3804 3806;
mul 34 2361; mul 3524 3808; mul 3523 3809; add 3807 3810; mul 152 2359; mul 3591 3812; sub 3811 3813; mul 148 2359;
mul 3595 3815; sub 3814 3816; mul 143 2359; mul 3539 3818; sub 3817 3819; mul 139 2359; mul 3602 3821; sub 3820
3822; mul 131 2359; mul 3499 3824; sub 3823 3825; mul 94 2359; mul 3609 3827; mul 3523 3828; sub 3826 3829; mul 120
2359; mul 3614 3831; sub 3830 3832; mul 116 2359; mul 3503 3834; sub 3833 3835; mul 108 2359; mul 3554 3837; sub
3836 3838; mul 101 2359; mul 3558 3840; mul 3523 3841; sub 3839 3842; constant -129.60000000000008; mul 3494 3844;
constant 28.799999999999958; mul 3497 3846; constant 45.25714285714287; mul 3500 3848; add 3847 3849; constant
-28.800000000000004; mul 147 856; mul 3851 3852; mul 3571 3853; add 3850 3854; constant -28.799999999999976; mul
3504 3856; add 3855 3857; constant -45.25714285714286; mul 3508 3859; add 3858 3860; constant 28.79999999999999; mul
135 856; mul 3862 3863; mul 3571 3864; add 3861 3865; constant 7.199999999999994; mul 3512 3867; add 3866 3868;
constant 13.714285714285717; mul 3516 3870; add 3869 3871; constant -7.199999999999996; mul 112 856; mul 3873 3874;
mul 3571 3875; add 3872 3876; constant 1.3714285714285692; mul 3520 3878; add 3877 3879; constant
-4.799999999999999; mul 104 856; mul 3881 3882; mul 3571 3883; add 3880 3884; constant 1.3714285714285714; mul 3530
3886; add 3885 3887; constant -1.3714285714285723; mul 160 856; mul 3889 3890; mul 3571 3891; add 3888 3892;
constant 2.400000000000001; mul 3534 3894; mul 3523 3895; add 3893 3896; sub 3845 3897; constant 230.40000000000006;
mul 3540 3899; add 3898 3900; mul 3543 3846; add 3901 3902; constant -36.00000000000001; mul 147 1053; mul 3904
3905; mul 3571 3906; add 3903 3907; constant -151.20000000000002; mul 3547 3909; add 3908 3910; constant
-57.59999999999995; mul 3551 3912; add 3911 3913; constant 72.0; mul 135 1053; mul 3915 3916; mul 3571 3917; add
3914 3918; constant -22.62857142857143; mul 3555 3920; add 3919 3921; mul 127 1053; mul 3862 3923; mul 3571 3924;
add 3922 3925; constant -18.000000000000004; mul 3559 3927; mul 3523 3928; add 3926 3929; constant
35.20000000000001; mul 3564 3931; add 3930 3932; constant 21.59999999999998; mul 3568 3934; add 3933 3935; constant
-30.000000000000007; mul 3572 3937; mul 3571 3938; add 3936 3939; mul 3575 3870; add 3940 3941; constant
-14.399999999999991; mul 104 1053; mul 3943 3944; mul 3571 3945; add 3942 3946; mul 575 3579; mul 3523 3948; add
3947 3949; constant 0.4571428571428564; mul 3584 3951; add 3950 3952; constant -2.3999999999999995; mul 160 1053;
mul 3954 3955; mul 3571 3956; add 3953 3957; input p 217; constant -0.9999999999999998; mul 1053 3960; mul 3959
3961; add 3958 3962; constant 259.2000000000001; mul 3592 3964; sub 3963 3965; constant -388.80000000000024; mul
3596 3967; sub 3966 3968; mul 3599 3899; sub 3969 3970; constant 57.599999999999916; mul 3603 3972; sub 3971 3973;
constant -72.00000000000001; mul 135 1051; mul 3975 3976; mul 3571 3977; sub 3974 3978; mul 3606 3848; sub 3979
3980; constant -57.60000000000001; mul 127 1051; mul 3982 3983; mul 3571 3984; sub 3981 3985; constant
36.000000000000014; mul 3610 3987; mul 3523 3988; sub 3986 3989; constant -50.400000000000006; mul 3615 3991; sub
3990 3992; mul 3618 3856; sub 3993 3994; constant 36.0; mul 112 1051; mul 3996 3997; mul 3571 3998; sub 3995 3999;
mul 3621 3920; sub 4000 4001; mul 104 1051; mul 3862 4003; mul 3571 4004; sub 4002 4005; mul 3624 3927; mul 3523
4007; sub 4006 4008; mul 3628 3846; mul 3630 3848; add 4010 4011; mul 147 1550; mul 3851 4013; mul 3571 4014; add
4012 4015; mul 3633 3856; add 4016 4017; mul 3636 3859; add 4018 4019; mul 135 1550; mul 3862 4021; mul 3571 4022;
add 4020 4023; mul 3639 3867; add 4024 4025; mul 3642 3870; add 4026 4027; mul 112 1550; mul 3873 4029; mul 3571
4030; add 4028 4031; mul 3645 3878; add 4032 4033; mul 104 1550; mul 3881 4035; mul 3571 4036; add 4034 4037; mul
3652 3886; add 4038 4039; mul 160 1550; mul 3889 4041; mul 3571 4042; add 4040 4043; mul 3655 3894; mul 3523 4045;
add 4044 4046; mul 3659 3844; add 4047 4048; mul 3662 3899; add 4049 4050; mul 3665 3846; add 4051 4052; mul 147
1725; mul 3904 4054; mul 3571 4055; add 4053 4056; mul 3668 3909; add 4057 4058; mul 3671 3912; add 4059 4060; mul
135 1725; mul 3915 4062; mul 3571 4063; add 4061 4064; mul 3674 3920; add 4065 4066; mul 127 1725; mul 3862 4068;
mul 3571 4069; add 4067 4070; mul 3677 3927; mul 3523 4072; add 4071 4073; mul 3681 3931; add 4074 4075; mul 3684
3934; add 4076 4077; mul 3687 3937; mul 3571 4079; add 4078 4080; mul 3690 3870; add 4081 4082; mul 104 1725; mul
3943 4084; mul 3571 4085; add 4083 4086; mul 575 3693; mul 3523 4088; add 4087 4089; mul 3697 3951; add 4090 4091;
mul 160 1725; mul 3954 4093; mul 3571 4094; add 4092 4095; mul 1725 3960; mul 3959 4097; add 4096 4098; mul 3704
3964; add 4099 4100; mul 3707 3967; add 4101 4102; mul 3710 3899; add 4103 4104; mul 3713 3972; add 4105 4106; mul
135 1723; mul 3975 4108; mul 3571 4109; add 4107 4110; mul 3716 3848; add 4111 4112; mul 127 1723; mul 3982 4114;
mul 3571 4115; add 4113 4116; mul 3719 3987; mul 3523 4118; add 4117 4119; mul 3723 3991; add 4120 4121; mul 3726
3856; add 4122 4123; mul 112 1723; mul 3996 4125; mul 3571 4126; add 4124 4127; mul 3729 3920; add 4128 4129; mul
104 1723; mul 3862 4131; mul 3571 4132; add 4130 4133; mul 3732 3927; mul 3523 4135; add 4134 4136; mul 3736 3844;
mul 3738 3846; mul 3740 3848; add 4139 4140; mul 147 2190; mul 3851 4142; mul 3571 4143; add 4141 4144; mul 3743
3856; add 4145 4146; mul 3746 3859; add 4147 4148; mul 135 2190; mul 3862 4150; mul 3571 4151; add 4149 4152; mul
3749 3867; add 4153 4154; mul 3752 3870; add 4155 4156; mul 112 2190; mul 3873 4158; mul 3571 4159; add 4157 4160;
mul 3755 3878; add 4161 4162; mul 104 2190; mul 3881 4164; mul 3571 4165; add 4163 4166; mul 3762 3886; add 4167
4168; mul 160 2190; mul 3889 4170; mul 3571 4171; add 4169 4172; mul 3765 3894; mul 3523 4174; add 4173 4175; sub
4138 4176; mul 3770 3899; add 4177 4178; mul 3773 3846; add 4179 4180; mul 147 2361; mul 3904 4182; mul 3571 4183;
add 4181 4184; mul 3776 3909; add 4185 4186; mul 3779 3912; add 4187 4188; mul 135 2361; mul 3915 4190; mul 3571
4191; add 4189 4192; mul 3782 3920; add 4193 4194; mul 127 2361; mul 3862 4196; mul 3571 4197; add 4195 4198; mul
3785 3927; mul 3523 4200; add 4199 4201; mul 3789 3931; add 4202 4203; mul 3792 3934; add 4204 4205; mul 3795 3937;
mul 3571 4207; add 4206 4208; mul 3798 3870; add 4209 4210; mul 104 2361; mul 3943 4212; mul 3571 4213; add 4211
4214; mul 575 3801; mul 3523 4216; add 4215 4217; mul 3805 3951; add 4218 4219; mul 160 2361; mul 3954 4221; mul
3571 4222; add 4220 4223; mul 2361 3960; mul 3959 4225; add 4224 4226; mul 3812 3964; sub 4227 4228; mul 3815 3967;
sub 4229 4230; mul 3818 3899; sub 4231 4232; mul 3821 3972; sub 4233 4234; mul 135 2359; mul 3975 4236; mul 3571
4237; sub 4235 4238; mul 3824 3848; sub 4239 4240; mul 127 2359; mul 3982 4242; mul 3571 4243; sub 4241 4244; mul
3827 3987; mul 3523 4246; sub 4245 4247; mul 3831 3991; sub 4248 4249; mul 3834 3856; sub 4250 4251; mul 112 2359;
mul 3996 4253; mul 3571 4254; sub 4252 4255; mul 3837 3920; sub 4256 4257; mul 104 2359; mul 3862 4259; mul 3571
4260; sub 4258 4261; mul 3840 3927; mul 3523 4263; sub 4262 4264; constant -0.04285714285714284; mul 148 852; mul
4266 4267; constant 0.029931972789115628; mul 204 852; mul 4269 4270; add 4268 4271; constant
-0.0013605442176870806; mul 139 852; mul 4273 4274; add 4272 4275; constant -0.003571428571428574; mul 120 852; mul
4277 4278; add 4276 4279; constant 0.0027210884353741486; mul 116 852; mul 4281 4282; add 4280 4283; constant
-0.0014361300075585765; mul 108 852; mul 4285 4286; add 4284 4287; constant 0.00032473894907757275; mul 164 852; mul
4289 4290; add 4288 4291; constant -0.12857142857142845; mul 152 897; mul 4293 4294; add 4292 4295; constant
0.12857142857142853; mul 148 897; mul 4297 4298; add 4296 4299; mul 204 897; mul 4266 4301; add 4300 4302; constant
0.010714285714285735; mul 143 897; mul 4304 4305; add 4303 4306; constant -0.0006802721088435403; mul 131 897; mul
4308 4309; add 4307 4310; constant 0.028571428571428567; mul 120 897; mul 4312 4313; add 4311 4314; constant
-0.010714285714285721; mul 116 897; mul 4316 4317; add 4315 4318; mul 108 897; mul 4281 4320; add 4319 4321;
constant -0.0004787100025195255; mul 164 897; mul 4323 4324; add 4322 4325; constant 1.0285714285714285; mul 152
923; mul 4327 4328; add 4326 4329; constant -0.38571428571428534; mul 148 923; mul 4331 4332; add 4330 4333; mul 143
923; mul 4297 4335; add 4334 4336; constant -0.08571428571428567; mul 139 923; mul 4338 4339; add 4337 4340; mul 131
923; mul 4269 4342; add 4341 4343; constant 0.0035714285714285787; mul 120 923; mul 4345 4346; add 4344 4347; mul
108 923; mul 4308 4349; add 4348 4350; mul 148 1576; mul 4266 4352; mul 204 1576; mul 4269 4354; add 4353 4355; mul
139 1576; mul 4273 4357; add 4356 4358; mul 120 1576; mul 4277 4360; add 4359 4361; mul 116 1576; mul 4281 4363; add
4362 4364; mul 108 1576; mul 4285 4366; add 4365 4367; mul 164 1576; mul 4289 4369; add 4368 4370; mul 152 1597; mul
4293 4372; add 4371 4373; mul 148 1597; mul 4297 4375; add 4374 4376; mul 204 1597; mul 4266 4378; add 4377 4379;
mul 143 1597; mul 4304 4381; add 4380 4382; mul 131 1597; mul 4308 4384; add 4383 4385; mul 120 1597; mul 4312 4387;
add 4386 4388; mul 116 1597; mul 4316 4390; add 4389 4391; mul 108 1597; mul 4281 4393; add 4392 4394; mul 164 1597;
mul 4323 4396; add 4395 4397; mul 152 1623; mul 4327 4399; add 4398 4400; mul 148 1623; mul 4331 4402; add 4401
4403; mul 143 1623; mul 4297 4405; add 4404 4406; mul 139 1623; mul 4338 4408; add 4407 4409; mul 131 1623; mul 4269
4411; add 4410 4412; mul 120 1623; mul 4345 4414; add 4413 4415; mul 108 1623; mul 4308 4417; add 4416 4418; mul 148
2186; mul 4266 4420; mul 204 2186; mul 4269 4422; add 4421 4423; mul 139 2186; mul 4273 4425; add 4424 4426; mul 120
2186; mul 4277 4428; add 4427 4429; mul 116 2186; mul 4281 4431; add 4430 4432; mul 108 2186; mul 4285 4434; add
4433 4435; mul 164 2186; mul 4289 4437; add 4436 4438; mul 152 2229; mul 4293 4440; add 4439 4441; mul 148 2229; mul
4297 4443; add 4442 4444; mul 204 2229; mul 4266 4446; add 4445 4447; mul 143 2229; mul 4304 4449; add 4448 4450;
mul 131 2229; mul 4308 4452; add 4451 4453; mul 120 2229; mul 4312 4455; add 4454 4456; mul 116 2229; mul 4316 4458;
add 4457 4459; mul 108 2229; mul 4281 4461; add 4460 4462; mul 164 2229; mul 4323 4464; add 4463 4465; mul 152 2255;
mul 4327 4467; add 4466 4468; mul 148 2255; mul 4331 4470; add 4469 4471; mul 143 2255; mul 4297 4473; add 4472
4474; mul 139 2255; mul 4338 4476; add 4475 4477; mul 131 2255; mul 4269 4479; add 4478 4480; mul 120 2255; mul 4345
4482; add 4481 4483; mul 108 2255; mul 4308 4485; add 4484 4486; mul 148 2660; mul 4266 4488; mul 204 2660; mul 4269
4490; add 4489 4491; mul 139 2660; mul 4273 4493; add 4492 4494; mul 120 2660; mul 4277 4496; add 4495 4497; mul 116
2660; mul 4281 4499; add 4498 4500; mul 108 2660; mul 4285 4502; add 4501 4503; mul 164 2660; mul 4289 4505; add
4504 4506; mul 152 2680; mul 4293 4508; add 4507 4509; mul 148 2680; mul 4297 4511; add 4510 4512; mul 204 2680; mul
4266 4514; add 4513 4515; mul 143 2680; mul 4304 4517; add 4516 4518; mul 131 2680; mul 4308 4520; add 4519 4521;
mul 120 2680; mul 4312 4523; add 4522 4524; mul 116 2680; mul 4316 4526; add 4525 4527; mul 108 2680; mul 4281 4529;
add 4528 4530; mul 164 2680; mul 4323 4532; add 4531 4533; mul 152 2706; mul 4327 4535; add 4534 4536; mul 148 2706;
mul 4331 4538; add 4537 4539; mul 143 2706; mul 4297 4541; add 4540 4542; mul 139 2706; mul 4338 4544; add 4543
4545; mul 131 2706; mul 4269 4547; add 4546 4548; mul 120 2706; mul 4345 4550; add 4549 4551; mul 108 2706; mul 4308
4553; add 4552 4554; mul 148 2848; mul 4266 4556; mul 204 2848; mul 4269 4558; add 4557 4559; mul 139 2848; mul 4273
4561; add 4560 4562; mul 120 2848; mul 4277 4564; add 4563 4565; mul 116 2848; mul 4281 4567; add 4566 4568; mul 108
2848; mul 4285 4570; add 4569 4571; mul 164 2848; mul 4289 4573; add 4572 4574; mul 152 2868; mul 4293 4576; add
4575 4577; mul 148 2868; mul 4297 4579; add 4578 4580; mul 204 2868; mul 4266 4582; add 4581 4583; mul 143 2868; mul
4304 4585; add 4584 4586; mul 131 2868; mul 4308 4588; add 4587 4589; mul 120 2868; mul 4312 4591; add 4590 4592;
mul 116 2868; mul 4316 4594; add 4593 4595; mul 108 2868; mul 4281 4597; add 4596 4598; mul 164 2868; mul 4323 4600;
add 4599 4601; mul 152 2894; mul 4327 4603; add 4602 4604; mul 148 2894; mul 4331 4606; add 4605 4607; mul 143 2894;
mul 4297 4609; add 4608 4610; mul 139 2894; mul 4338 4612; add 4611 4613; mul 131 2894; mul 4269 4615; add 4614
4616; mul 120 2894; mul 4345 4618; add 4617 4619; mul 108 2894; mul 4308 4621; add 4620 4622; input p 218; mul 3906
4624; mul 3853 4624; mul 3864 4624; add 4626 4627; mul 3875 4624; add 4628 4629; mul 3883 4624; add 4630 4631; input
p 219; input p 220; mul 3526 4634; mul 4633 4635; add 4632 4636; mul 3891 4624; add 4637 4638; mul 3535 4634; mul
4633 4640; add 4639 4641; mul 3895 4624; mul 4633 4643; add 4642 4644; sub 4625 4645; mul 3917 4624; add 4646 4647;
mul 3924 4624; add 4648 4649; mul 3560 4634; mul 4633 4651; add 4650 4652; mul 3928 4624; mul 4633 4654; add 4653
4655; mul 3572 4634; sub 4656 4657; mul 3938 4624; add 4658 4659; mul 3945 4624; add 4660 4661; mul 3580 4634; mul
4633 4663; add 4662 4664; mul 3948 4624; mul 4633 4666; add 4665 4667; mul 3956 4624; add 4668 4669; mul 3588 4634;
mul 4633 4671; add 4670 4672; mul 3961 4624; mul 3523 4674; add 4673 4675; mul 3571 4674; mul 4633 4677; add 4676
4678; add 3961 4679; mul 3977 4624; sub 4680 4681; mul 3984 4624; sub 4682 4683; mul 3611 4634; mul 4633 4685; sub
4684 4686; mul 3988 4624; mul 4633 4688; sub 4687 4689; mul 3998 4624; sub 4690 4691; mul 4004 4624; sub 4692 4693;
mul 3625 4634; mul 4633 4695; sub 4694 4696; mul 4007 4624; mul 4633 4698; sub 4697 4699; mul 4014 4624; mul 4022
4624; add 4701 4702; mul 4030 4624; add 4703 4704; mul 4036 4624; add 4705 4706; mul 3649 4634; mul 4633 4708; add
4707 4709; mul 4042 4624; add 4710 4711; mul 3656 4634; mul 4633 4713; add 4712 4714; mul 4045 4624; mul 4633 4716;
add 4715 4717; mul 4055 4624; add 4718 4719; mul 4063 4624; add 4720 4721; mul 4069 4624; add 4722 4723; mul 3678
4634; mul 4633 4725; add 4724 4726; mul 4072 4624; mul 4633 4728; add 4727 4729; mul 3687 4634; sub 4730 4731; mul
4079 4624; add 4732 4733; mul 4085 4624; add 4734 4735; mul 3694 4634; mul 4633 4737; add 4736 4738; mul 4088 4624;
mul 4633 4740; add 4739 4741; mul 4094 4624; add 4742 4743; mul 3701 4634; mul 4633 4745; add 4744 4746; mul 4097
4624; mul 3523 4748; add 4747 4749; mul 3571 4748; mul 4633 4751; add 4750 4752; add 4097 4753; mul 4109 4624; add
4754 4755; mul 4115 4624; add 4756 4757; mul 3720 4634; mul 4633 4759; add 4758 4760; mul 4118 4624; mul 4633 4762;
add 4761 4763; mul 4126 4624; add 4764 4765; mul 4132 4624; add 4766 4767; mul 3733 4634; mul 4633 4769; add 4768
4770; mul 4135 4624; mul 4633 4772; add 4771 4773; mul 4183 4624; mul 4143 4624; mul 4151 4624; add 4776 4777; mul
4159 4624; add 4778 4779; mul 4165 4624; add 4780 4781; mul 3759 4634; mul 4633 4783; add 4782 4784; mul 4171 4624;
add 4785 4786; mul 3766 4634; mul 4633 4788; add 4787 4789; mul 4174 4624; mul 4633 4791; add 4790 4792; sub 4775
4793; mul 4191 4624; add 4794 4795; mul 4197 4624; add 4796 4797; mul 3786 4634; mul 4633 4799; add 4798 4800; mul
4200 4624; mul 4633 4802; add 4801 4803; mul 3795 4634; sub 4804 4805; mul 4207 4624; add 4806 4807; mul 4213 4624;
add 4808 4809; mul 3802 4634; mul 4633 4811; add 4810 4812; mul 4216 4624; mul 4633 4814; add 4813 4815; mul 4222
4624; add 4816 4817; mul 3809 4634; mul 4633 4819; add 4818 4820; mul 4225 4624; mul 3523 4822; add 4821 4823; mul
3571 4822; mul 4633 4825; add 4824 4826; add 4225 4827; mul 4237 4624; sub 4828 4829; mul 4243 4624; sub 4830 4831;
mul 3828 4634; mul 4633 4833; sub 4832 4834; mul 4246 4624; mul 4633 4836; sub 4835 4837; mul 4254 4624; sub 4838
4839; mul 4260 4624; sub 4840 4841; mul 3841 4634; mul 4633 4843; sub 4842 4844; mul 4263 4624; mul 4633 4846; sub
4845 4847; mul 457 734; mul 590 605; sub 4849 4850; mul 321 893; add 4851 4852; mul 211 1051; sub 4853 4854; mul 94
1278; add 4855 4856; mul 590 1346; mul 457 1456; add 4858 4859; mul 321 1593; sub 4860 4861; mul 211 1723; add 4862
4863; mul 94 1945; add 4864 4865; mul 457 2087; mul 590 1977; sub 4867 4868; mul 321 2225; add 4869 4870; mul 211
2359; sub 4871 4872; mul 94 2581; add 4873 4874; mul 321 2676; mul 94 2785; add 4876 4877; mul 321 2864; mul 94
2973; add 4879 4880; mul 590 597; mul 211 1047; add 4882 4883; mul 444 734; add 4884 4885; mul 321 890; add 4886
4887; mul 2 1278; add 4888 4889; mul 444 1456; mul 590 1334; mul 211 1720; add 4892 4893; sub 4891 4894; mul 321
1589; add 4895 4896; mul 2 1945; add 4897 4898; mul 590 1343; mul 211 1550; add 4900 4901; mul 444 2087; add 4902
4903; mul 321 2222; add 4904 4905; mul 2 2581; add 4906 4907; mul 321 2673; mul 2 2785; add 4909 4910; mul 321 2861;
mul 2 2973; add 4912 4913; mul 468 734; mul 590 601; mul 211 856; add 4916 4917; sub 4915 4918; mul 321 848; add
4919 4920; mul 34 1278; add 4921 4922; mul 468 1456; add 4902 4924; mul 321 1575; sub 4925 4926; mul 34 1945; add
4927 4928; mul 468 2087; mul 590 1973; mul 211 2190; add 4931 4932; sub 4930 4933; mul 321 2182; add 4934 4935; mul
34 2581; add 4936 4937; mul 321 2656; mul 34 2785; add 4939 4940; mul 321 2844; mul 34 2973; add 4942 4943; mul 7
15; mul 16 444; mul 444 4946; mul 22 4947; mul 21 89; mul 21 597; mul 25 4950; sub 4949 4951; mul 4948 4952; mul 23
4953; mul 597 4947; mul 18 4955; sub 4954 4956; mul 40 4950; mul 21 601; mul 52 4959; sub 4958 4960; mul 66 4949;
sub 4961 4962; mul 4948 4963; mul 37 4964; sub 4957 4965; mul 2 4966; mul 4945 4967; mul 4945 4968; mul 8 4967; mul
8 4970; mul 234 4971; add 4969 4972; mul 15 16; mul 559 617; input p 134; mul 37 4976; mul 597 4977; sub 4975 4978;
mul 450 756; add 4979 4980; mul 4974 4981; mul 13 4982; mul 8 8; mul 15 4981; mul 4984 4985; add 4983 4986; mul 8
37; mul 490 619; mul 481 4989; mul 16 597; mul 4976 4991; mul 483 619; mul 478 4993; add 4992 4994; sub 4990 4995;
mul 481 702; add 4996 4997; mul 499 678; mul 554 619; add 4999 5000; mul 234 490; mul 700 5002; add 5001 5003; mul
478 5004; add 4998 5005; mul 367 758; mul 362 5007; sub 5006 5008; mul 374 758; mul 365 5010; sub 5009 5011; mul 365
841; sub 5012 5013; mul 383 817; mul 445 758; add 5015 5016; mul 234 374; mul 839 5018; add 5017 5019; mul 362 5020;
add 5014 5021; mul 4988 5022; add 4987 5023; mul 8 23; mul 481 4993; mul 478 4989; add 5026 5027; mul 478 702; add
5028 5029; mul 481 5004; sub 5030 5031; mul 365 5007; sub 5032 5033; mul 362 5010; add 5034 5035; mul 362 841; add
5036 5037; mul 365 5020; add 5038 5039; mul 5025 5040; add 5024 5041; mul 7 234; div 1 5043; mul 5042 5044; mul 2
5045; mul 2 5046; sub 4973 5047; mul 8 5040; mul 7 4982; sub 5049 5050; mul 13 234; div 1 5052; mul 5051 5053; mul 2
5054; mul 2 5055; add 5048 5056; input p 125; mul 8 5058; mul 8 5059; mul 9 4945; mul 4945 5061; add 5060 5062; mul
2 5063; mul 4953 5064; mul 91 3061; mul 223 1001; mul 230 1019; add 5067 5068; mul 238 250; add 5069 5070; mul 243
260; add 5071 5072; mul 247 973; add 5073 5074; mul 252 958; add 5075 5076; input p 148; mul 257 5078; add 5077
5079; input p 132; mul 261 5081; add 5080 5082; input p 149; mul 266 5084; add 5083 5085; input p 150; mul 271 5087;
add 5086 5088; where 957 5089; add 5066 5090; mul 467 571; sub 5091 5092; input p 151; mul 468 5094; mul 99 590; add
5095 5096; add 5093 5097; mul 61 453; mul 27 444; add 5099 5100; mul 46 468; add 5101 5102; mul 453 5103; mul 27
453; mul 30 444; add 5105 5106; mul 33 468; add 5107 5108; mul 444 5109; add 5104 5110; mul 46 453; mul 33 444; add
5112 5113; mul 50 468; add 5114 5115; mul 468 5116; add 5111 5117; mul 37 5064; sub 24 5119; mul 4948 5120; add 5118
5121; mul 52 5122; mul 21 5123; add 5098 5124; mul 88 601; mul 5125 5126; mul 91 3114; mul 223 1005; mul 230 241;
add 5129 5130; mul 238 1019; add 5131 5132; mul 243 989; add 5133 5134; mul 247 977; add 5135 5136; mul 252 264; add
5137 5138; input p 130; mul 257 5140; add 5139 5141; input p 131; mul 261 5143; add 5142 5144; mul 266 5081; add
5145 5146; input p 133; mul 271 5148; add 5147 5149; where 963 5150; add 5128 5151; mul 461 571; sub 5152 5153; mul
96 590; add 5154 5155; mul 451 474; mul 560 568; add 5157 5158; add 5156 5159; sub 1303 5160; mul 16 4977; add 5161
5162; input p 116; input z 0; mul 5164 5165; input p 117; input z 1; mul 5167 5168; add 5166 5169; input p 118;
input z 2; mul 5171 5172; add 5170 5173; input p 119; input z 3; mul 5175 5176; add 5174 5177; input p 135; mul 5178
5179; sub 5163 5180; mul 40 5122; mul 23 5064; add 38 5183; mul 4948 5184; mul 25 5185; sub 5182 5186; mul 21 5187;
mul 18 5064; mul 4947 5189; sub 5188 5190; sub 5181 5191; mul 88 597; mul 5192 5193; add 5127 5194; input c 0; input
c 2; mul 404 5197; add 5196 5198; input c 3; mul 517 5200; add 5199 5201; mul 1287 1321; add 5202 5203; mul 1285
1303; sub 5204 5205; input p 16; input c 1; add 5207 5208; constant 0.0; max 5209 5210; mul 453 5211; sub 5206 5212;
mul 454 474; mul 562 568; add 5214 5215; sub 594 5216; sub 5213 5217; input p 115; sub 5219 5178; input p 120; abs
453; mul 5221 5222; mul 453 5223; input p 121; mul 453 5225; mul 453 453; input p 122; add 5227 5228; sqrt 5229; div
1 5230; mul 5226 5231; add 5224 5232; sub 5220 5233; add 5218 5234; input p 123; input x 12; sub 28 5237; mul 5236
5238; input p 124; input x 13; sub 28 5241; mul 5240 5242; add 5239 5243; sub 5235 5244; mul 66 5122; sub 5246 5185;
mul 21 5247; sub 5245 5248; mul 88 89; mul 5249 5250; sub 5195 5251; mul 78 5252; mul 58 5253; mul 75 5252; mul 55
5255; sub 5254 5256; mul 21 5257; mul 4950 5185; sub 5258 5259; mul 88 5125; mul 58 5261; mul 88 5192; mul 55 5263;
add 5262 5264; mul 80 5252; add 5265 5266; mul 21 5267; sub 5260 5268; mul 25 234; mul 78 5261; mul 78 5253; sub
5271 5272; mul 69 5252; mul 55 5274; add 5273 5275; mul 88 5249; mul 55 5277; add 5276 5278; mul 21 5279; mul 5270
5280; add 5269 5281; mul 22 5282; add 4964 5283; mul 16 5284; add 5065 5285; mul 8 5286; mul 15 4945; mul 4967 5061;
mul 9 4968; add 5289 5290; mul 5288 5291; mul 4952 5184; mul 22 5293; mul 597 5189; sub 5294 5295; mul 4963 5120;
mul 22 5297; add 5296 5298; mul 444 5299; mul 444 5300; mul 4950 5122; mul 66 5258; add 5302 5303; mul 66 5268; sub
5304 5305; mul 78 5263; mul 75 5253; add 5307 5308; mul 58 5274; sub 5309 5310; mul 58 5277; sub 5311 5312; mul 21
5313; mul 52 5314; add 5306 5315; mul 78 5255; mul 75 5261; sub 5317 5318; sub 5319 5310; sub 5320 5312; mul 21
5321; mul 52 5322; add 5316 5323; mul 40 234; mul 5280 5325; add 5324 5326; mul 22 5327; add 4953 5328; mul 37 5329;
add 5301 5330; mul 23 5284; add 5331 5332; mul 18 5279; add 5333 5334; mul 16 5279; mul 4955 5064; sub 5336 5337;
mul 17 5338; add 5335 5339; mul 4974 5340; add 5292 5341; mul 7 5342; sub 5287 5343; mul 5053 5344; mul 2 5345; mul
2 5346; add 5057 5347; mul 15 5291; mul 8 5060; mul 4967 5350; sub 5349 5351; mul 4970 5060; sub 5352 5353; mul 16
5329; mul 4964 5064; sub 5355 5356; mul 4988 5357; sub 5354 5358; mul 5025 5286; sub 5359 5360; mul 13 5342; sub
5361 5362; mul 15 5340; mul 4984 5364; sub 5363 5365; mul 5044 5366; mul 2 5367; mul 2 5368; add 5348 5369; mul 1334
4947; mul 18 5371; mul 21 1334; mul 25 5373; sub 5374 4950; mul 4948 5375; mul 23 5376; add 5372 5377; mul 21 1343;
mul 52 5379; mul 40 5373; sub 5380 5381; mul 66 4950; add 5382 5383; mul 4948 5384; mul 37 5385; sub 5378 5386; mul
2 5387; mul 4945 5388; mul 4945 5389; mul 8 5388; mul 8 5391; mul 234 5392; add 5390 5393; mul 1334 4977; mul 559
1411; sub 5395 5396; mul 450 1474; sub 5397 5398; mul 4974 5399; mul 13 5400; mul 15 5399; mul 4984 5402; add 5401
5403; mul 16 1334; mul 4976 5405; mul 483 1435; mul 478 5407; add 5406 5408; mul 490 1435; mul 481 5410; sub 5409
5411; mul 481 1438; add 5412 5413; mul 499 1402; mul 554 1435; sub 5415 5416; mul 1432 5002; add 5417 5418; mul 478
5419; add 5414 5420; mul 367 1476; mul 362 5422; add 5421 5423; mul 374 1476; mul 365 5425; add 5424 5426; mul 365
1545; sub 5427 5428; mul 383 1520; mul 445 1476; sub 5430 5431; mul 1543 5018; add 5432 5433; mul 362 5434; add 5429
5435; mul 4988 5436; add 5404 5437; mul 478 1438; mul 481 5407; mul 478 5410; add 5440 5441; sub 5439 5442; mul 481
5419; sub 5443 5444; mul 365 5422; add 5445 5446; mul 362 5425; sub 5447 5448; mul 362 1545; add 5449 5450; mul 365
5434; add 5451 5452; mul 5025 5453; add 5438 5454; mul 5044 5455; mul 2 5456; mul 2 5457; sub 5394 5458; mul 8 5453;
mul 7 5400; sub 5460 5461; mul 5053 5462; mul 2 5463; mul 2 5464; add 5459 5465; mul 5064 5376; mul 5185 5373; mul
5193 5249; mul 88 1343; mul 5125 5470; sub 5469 5471; mul 88 1334; mul 5192 5473; sub 5472 5474; mul 78 5475; mul 58
5476; add 5271 5278; sub 5477 5478; mul 75 5475; mul 55 5480; sub 5479 5481; mul 21 5482; add 5468 5483; mul 80
5475; mul 21 5485; sub 5484 5486; mul 69 5475; mul 55 5488; mul 78 5476; sub 5489 5490; mul 21 5491; mul 5270 5492;
add 5487 5493; mul 22 5494; add 5385 5495; mul 16 5496; add 5467 5497; mul 8 5498; mul 5061 5388; mul 9 5389; add
5500 5501; mul 5288 5502; mul 1334 5189; mul 5184 5375; mul 22 5505; add 5504 5506; mul 5120 5384; mul 22 5508; add
5507 5509; mul 444 5510; mul 444 5511; mul 66 5483; mul 5122 5373; sub 5513 5514; mul 66 5486; sub 5515 5516; mul 75
5476; mul 58 5488; sub 5518 5519; mul 21 5520; mul 52 5521; add 5517 5522; mul 69 5261; mul 78 5277; add 5524 5525;
mul 78 5480; add 5526 5527; sub 5528 5519; mul 21 5529; mul 52 5530; add 5523 5531; mul 5325 5492; add 5532 5533;
mul 22 5534; add 5376 5535; mul 37 5536; add 5512 5537; mul 23 5496; add 5538 5539; mul 18 5491; add 5540 5541; mul
5064 5371; mul 16 5491; add 5543 5544; mul 17 5545; add 5542 5546; mul 4974 5547; add 5503 5548; mul 7 5549; sub
5499 5550; mul 5053 5551; mul 2 5552; mul 2 5553; add 5466 5554; mul 15 5502; mul 5350 5388; sub 5556 5557; mul 5060
5391; sub 5558 5559; mul 16 5536; mul 5064 5385; sub 5561 5562; mul 4988 5563; sub 5560 5564; mul 5025 5498; sub
5565 5566; mul 13 5549; sub 5567 5568; mul 15 5547; mul 4984 5570; sub 5569 5571; mul 5044 5572; mul 2 5573; mul 2
5574; add 5555 5575; mul 25 5379; sub 4959 5577; mul 4948 5578; mul 23 5579; mul 1343 4947; mul 18 5581; sub 5580
5582; mul 40 5379; mul 21 1973; mul 52 5585; sub 5584 5586; mul 66 4959; sub 5587 5588; mul 4948 5589; mul 37 5590;
sub 5583 5591; mul 2 5592; mul 4945 5593; mul 4945 5594; mul 8 5593; mul 8 5596; mul 234 5597; add 5595 5598; mul
559 1989; mul 1343 4977; sub 5600 5601; mul 450 2109; add 5602 5603; mul 4974 5604; mul 13 5605; mul 15 5604; mul
4984 5607; add 5606 5608; mul 490 1991; mul 481 5610; mul 16 1343; mul 4976 5612; mul 483 1991; mul 478 5614; add
5613 5615; sub 5611 5616; mul 481 2057; add 5617 5618; mul 499 2033; mul 554 1991; add 5620 5621; mul 2055 5002; add
5622 5623; mul 478 5624; add 5619 5625; mul 367 2111; mul 362 5627; sub 5626 5628; mul 374 2111; mul 365 5630; sub
5629 5631; mul 365 2177; sub 5632 5633; mul 383 2153; mul 445 2111; add 5635 5636; mul 2175 5018; add 5637 5638; mul
362 5639; add 5634 5640; mul 4988 5641; add 5609 5642; mul 481 5614; mul 478 5610; add 5644 5645; mul 478 2057; add
5646 5647; mul 481 5624; sub 5648 5649; mul 365 5627; sub 5650 5651; mul 362 5630; add 5652 5653; mul 362 2177; add
5654 5655; mul 365 5639; add 5656 5657; mul 5025 5658; add 5643 5659; mul 5044 5660; mul 2 5661; mul 2 5662; sub
5599 5663; mul 8 5658; mul 7 5605; sub 5665 5666; mul 5053 5667; mul 2 5668; mul 2 5669; add 5664 5670; mul 5064
5579; add 5312 5318; mul 88 1973; mul 5125 5674; mul 5192 5470; add 5675 5676; mul 5126 5249; sub 5677 5678; mul 78
5679; mul 58 5680; add 5673 5681; mul 75 5679; mul 55 5683; sub 5682 5684; mul 21 5685; mul 5185 5379; sub 5686
5687; add 5307 5318; mul 80 5679; sub 5689 5690; mul 21 5691; add 5688 5692; mul 69 5679; mul 55 5694; mul 78 5680;
add 5526 5696; sub 5695 5697; mul 21 5698; mul 5270 5699; add 5693 5700; mul 22 5701; add 5590 5702; mul 16 5703;
add 5672 5704; mul 8 5705; mul 5061 5593; mul 9 5594; add 5707 5708; mul 5288 5709; mul 5184 5578; mul 22 5711; mul
1343 5189; sub 5712 5713; mul 5120 5589; mul 22 5715; add 5714 5716; mul 444 5717; mul 444 5718; mul 5122 5379; mul
66 5686; add 5720 5721; mul 66 5692; add 5722 5723; mul 75 5277; mul 69 5263; sub 5725 5726; mul 75 5680; add 5727
5728; mul 58 5694; sub 5729 5730; mul 21 5731; mul 52 5732; add 5724 5733; mul 78 5683; sub 5735 5730; mul 21 5736;
mul 52 5737; add 5734 5738; mul 5325 5699; add 5739 5740; mul 22 5741; add 5579 5742; mul 37 5743; add 5719 5744;
mul 23 5703; add 5745 5746; mul 18 5698; add 5747 5748; mul 16 5698; mul 5064 5581; sub 5750 5751; mul 17 5752; add
5749 5753; mul 4974 5754; add 5710 5755; mul 7 5756; sub 5706 5757; mul 5053 5758; mul 2 5759; mul 2 5760; add 5671
5761; mul 15 5709; mul 5350 5593; sub 5763 5764; mul 5060 5596; sub 5765 5766; mul 16 5743; mul 5064 5590; sub 5768
5769; mul 4988 5770; sub 5767 5771; mul 5025 5705; sub 5772 5773; mul 13 5756; sub 5774 5775; mul 15 5754; mul 4984
5777; sub 5776 5778; mul 5044 5779; mul 2 5780; mul 2 5781; add 5762 5782; mul 374 2620; mul 362 5784; mul 367 2620;
mul 365 5786; sub 5785 5787; mul 362 2652; add 5788 5789; mul 445 2620; mul 383 2638; sub 5791 5792; mul 2650 5018;
add 5793 5794; mul 365 5795; add 5790 5796; mul 8 5797; mul 450 2618; mul 4974 5799; mul 7 5800; sub 5798 5801; mul
5053 5802; mul 2 5803; mul 2 5804; mul 13 5800; mul 15 5799; mul 4984 5807; add 5806 5808; mul 362 5795; mul 362
5786; mul 365 5784; add 5811 5812; mul 365 2652; add 5813 5814; sub 5810 5815; mul 4988 5816; add 5809 5817; mul
5025 5797; add 5818 5819; mul 5044 5820; mul 2 5821; mul 2 5822; sub 5805 5823; mul 483 2797; mul 481 5825; mul 490
2797; mul 478 5827; add 5826 5828; mul 478 2829; add 5829 5830; mul 554 2797; mul 499 2815; sub 5832 5833; mul 2827
5002; add 5834 5835; mul 481 5836; sub 5831 5837; mul 8 5838; mul 559 2795; mul 4974 5840; mul 7 5841; sub 5839
5842; mul 5053 5843; mul 2 5844; mul 2 5845; mul 13 5841; mul 15 5840; mul 4984 5848; add 5847 5849; mul 481 5827;
mul 478 5825; sub 5851 5852; mul 481 2829; add 5853 5854; mul 478 5836; add 5855 5856; mul 4988 5857; add 5850 5858;
mul 5025 5838; add 5859 5860; mul 5044 5861; mul 2 5862; mul 2 5863; sub 5846 5864; input p 221; mul 3168 5866; neg
5867; where 217 5868; mul 3313 5866; where 217 5870; mul 3449 5866; neg 5872; where 217 5873; mul 91 3110; where 963
5875; input p 222; mul 3161 5877; neg 5878; where 217 5879; add 5876 5880; mul 91 3265; neg 5882; where 963 5883;
mul 3308 5877; where 217 5885; add 5884 5886; mul 91 3208; where 963 5888; mul 3443 5877; neg 5890; where 217 5891;
add 5889 5892; mul 91 3024; neg 5894; where 957 5895; mul 3155 5877; neg 5897; where 217 5898; add 5896 5899; where
957 5888; mul 3303 5877; where 217 5902; add 5901 5903; mul 91 3355; neg 5905; where 957 5906; mul 3437 5877; neg
5908; where 217 5909; add 5907 5910; input p 223; mul 3104 5912; where 963 5913; mul 3149 5912; neg 5915; where 217
5916; add 5914 5917; mul 3259 5912; neg 5919; where 963 5920; mul 3298 5912; where 217 5922; add 5921 5923; mul 3205
5912; where 963 5925; mul 3431 5912; neg 5927; where 217 5928; add 5926 5929; mul 91 3020; neg 5931; where 957 5932;
mul 91 3099; where 963 5934; add 5933 5935; mul 3143 5912; neg 5937; where 217 5938; add 5936 5939; mul 91 3205;
where 957 5941; mul 91 3254; neg 5943; where 963 5944; add 5942 5945; mul 3293 5912; where 217 5947; add 5946 5948;
mul 91 3352; neg 5950; where 957 5951; mul 91 3201; where 963 5953; add 5952 5954; mul 3425 5912; neg 5956; where
217 5957; add 5955 5958; mul 3014 5912; neg 5960; where 957 5961; mul 3137 5912; neg 5963; where 217 5964; add 5962
5965; mul 3201 5912; where 957 5967; mul 3288 5912; where 217 5969; add 5968 5970; mul 3347 5912; neg 5972; where
957 5973; mul 3419 5912; neg 5975; where 217 5976; add 5974 5977; mul 3094 5877; where 963 5979; mul 91 3132; neg
5981; where 217 5982; add 5980 5983; mul 3248 5877; neg 5985; where 963 5986; mul 91 3284; where 217 5988; add 5987
5989; mul 3198 5877; where 963 5991; mul 91 3414; neg 5993; where 217 5994; add 5992 5995; mul 91 3010; neg 5997;
where 957 5998; mul 3088 5912; where 963 6000; add 5999 6001; mul 91 3127; neg 6003; where 217 6004; add 6002 6005;
mul 91 3198; where 957 6007; mul 3242 5912; neg 6009; where 963 6010; add 6008 6011; mul 91 3280; where 217 6013;
add 6012 6014; mul 91 3344; neg 6016; where 957 6017; mul 3194 5912; where 963 6019; add 6018 6020; mul 91 3409; neg
6022; where 217 6023; add 6021 6024; mul 3004 5912; neg 6026; where 957 6027; mul 91 3084; where 963 6029; add 6028
6030; mul 91 3122; neg 6032; where 217 6033; add 6031 6034; where 957 6019; mul 91 3237; neg 6037; where 963 6038;
add 6036 6039; mul 91 3276; where 217 6041; add 6040 6042; mul 3339 5912; neg 6044; where 957 6045; mul 91 3190;
where 963 6047; add 6046 6048; mul 91 3404; neg 6050; where 217 6051; add 6049 6052; mul 2999 5877; neg 6054; where
957 6055; mul 91 3117; neg 6057; where 217 6058; add 6056 6059; mul 3190 5877; where 957 6061; mul 91 3272; where
217 6063; add 6062 6064; mul 3335 5877; neg 6066; where 957 6067; mul 91 3399; neg 6069; where 217 6070; add 6068
6071; mul 3079 5866; where 963 6073; mul 3231 5866; neg 6075; where 963 6076; mul 3187 5866; where 963 6078; mul 91
2995; neg 6080; where 957 6081; mul 3073 5877; where 963 6083; add 6082 6084; mul 91 3187; where 957 6086; mul 3225
5877; neg 6088; where 963 6089; add 6087 6090; mul 91 3332; neg 6092; where 957 6093; mul 3183 5877; where 963 6095;
add 6094 6096; mul 2979 5912; neg 6098; where 957 6099; mul 3068 5912; where 963 6101; add 6100 6102; mul 3183 5912;
where 957 6104; mul 3219 5912; neg 6106; where 963 6107; add 6105 6108; mul 3320 5912; neg 6110; where 957 6111; mul
3179 5912; where 963 6113; add 6112 6114; mul 2989 5877; neg 6116; where 957 6117; mul 91 3064; where 963 6119; add
6118 6120; mul 3179 5877; where 957 6122; mul 91 3214; neg 6124; where 963 6125; add 6123 6126; mul 3327 5877; neg
6128; where 957 6129; mul 91 3176; where 963 6131; add 6130 6132; mul 2984 5866; neg 6134; where 957 6135; mul 3176
5866; where 957 6137; mul 3324 5866; neg 6139; where 957 6140; mul 597 5187; mul 601 5123; sub 6142 6143; mul 89
5247; sub 6144 6145; mul 44 5261; mul 58 5263; add 6147 6148; mul 85 5252; add 6149 6150; mul 77 6151; add 6146
6152; mul 58 5255; mul 44 5253; sub 6154 6155; mul 77 6156; add 6153 6157; mul 73 5257; add 6158 6159; mul 73 5267;
sub 6160 6161; mul 60 5252; mul 68 6163; add 6162 6164; mul 57 5313; add 6165 6166; mul 57 5321; add 6167 6168; mul
44 5274; mul 75 5263; mul 75 5255; add 6171 6172; sub 6170 6173; mul 44 5277; add 6174 6175; mul 53 6176; add 6169
6177; mul 42 5279; add 6178 6179; mul 1343 5123; mul 1334 5187; sub 6181 6182; mul 597 5247; add 6183 6184; mul 85
5475; sub 6186 5689; mul 77 6187; add 6185 6188; sub 5312 5307; mul 44 5476; sub 6190 6191; mul 58 5480; add 6192
6193; mul 77 6194; add 6189 6195; mul 73 5482; add 6196 6197; mul 73 5485; sub 6198 6199; mul 60 5475; add 5265
6201; mul 68 6202; add 6200 6203; mul 57 5520; add 6204 6205; mul 57 5529; add 6206 6207; sub 5726 5725; mul 75
5480; sub 6209 6210; mul 44 5488; add 6211 6212; mul 53 6213; add 6208 6214; mul 42 5491; add 6215 6216; mul 1343
5187; mul 1973 5123; sub 6218 6219; mul 601 5247; sub 6220 6221; mul 85 5679; mul 77 6223; add 6222 6224; sub 6171
6175; mul 44 5680; sub 6226 6227; mul 58 5683; add 6228 6229; mul 77 6230; add 6225 6231; mul 73 5685; add 6232
6233; mul 73 5691; add 6234 6235; mul 60 5679; sub 6237 6149; mul 68 6238; add 6236 6239; mul 57 5731; add 6240
6241; mul 57 5736; add 6242 6243; mul 44 5694; mul 75 5683; sub 6245 6246; mul 53 6247; add 6244 6248; mul 42 5698;
add 6249 6250; sub 5257 5267; sub 5482 5485; add 5685 5691; mul 16 5338; mul 16 5545; mul 16 5752; mul 453 4963; mul
453 6258; mul 328 842; mul 28 6260; add 893 6261; mul 28 6262; add 6259 6263; mul 21 6151; mul 52 6265; mul 4949
5122; sub 6266 6267; mul 21 6156; mul 52 6269; add 6268 6270; mul 40 5258; add 6271 6272; mul 40 5268; sub 6273
6274; mul 66 234; mul 21 6163; mul 6276 6277; add 6275 6278; mul 28 6279; add 6264 6280; mul 453 5384; mul 453 6282;
mul 328 1546; mul 28 6284; sub 6285 1593; mul 28 6286; add 6283 6287; mul 21 6187; mul 52 6289; add 5302 6290; mul
21 6194; mul 52 6292; add 6291 6293; mul 40 5483; add 6294 6295; mul 40 5486; sub 6296 6297; mul 21 6202; mul 6276
6299; add 6298 6300; mul 28 6301; add 6288 6302; mul 453 5589; mul 453 6304; mul 328 2178; mul 28 6306; add 2225
6307; mul 28 6308; add 6305 6309; mul 21 6223; mul 52 6311; mul 4959 5122; sub 6312 6313; mul 21 6230; mul 52 6315;
add 6314 6316; mul 40 5686; add 6317 6318; mul 40 5692; add 6319 6320; mul 21 6238; mul 6276 6322; add 6321 6323;
mul 28 6324; add 6310 6325; mul 328 2652; mul 28 6327; add 2676 6328; mul 28 6329; mul 328 2829; mul 28 6331; add
2864 6332; mul 28 6333; mul 444 4963; mul 453 6335; mul 444 6258; add 6336 6337; mul 2 6260; add 720 6339; mul 28
6340; add 6338 6341; mul 2 6262; add 6342 6343; mul 2 6279; add 6344 6345; mul 28 5327; add 6346 6347; mul 444 5384;
mul 453 6349; mul 444 6282; add 6350 6351; mul 2 6284; add 1362 6353; mul 28 6354; add 6352 6355; mul 2 6286; add
6356 6357; mul 2 6301; add 6358 6359; mul 28 5534; add 6360 6361; mul 444 5589; mul 453 6363; mul 444 6304; add 6364
6365; mul 2 6306; add 2074 6367; mul 28 6368; add 6366 6369; mul 2 6308; add 6370 6371; mul 2 6324; add 6372 6373;
mul 28 5741; add 6374 6375; mul 2 6327; add 2605 6377; mul 28 6378; mul 2 6329; add 6379 6380; mul 2 6331; add 2831
6382; mul 28 6383; mul 2 6333; add 6384 6385; mul 444 6335; mul 2 6340; add 6387 6388; mul 2 5327; add 6389 6390;
mul 444 6349; mul 2 6354; add 6392 6393; mul 2 5534; add 6394 6395; mul 444 6363; mul 2 6368; add 6397 6398; mul 2
5741; add 6399 6400; mul 2 6378; mul 2 6383; mul 468 4963; mul 453 6404; mul 468 6258; add 6405 6406; mul 34 6260;
add 715 6408; mul 28 6409; add 6407 6410; mul 34 6262; add 6411 6412; mul 34 6279; add 6413 6414; mul 66 6265; sub
6416 6313; mul 66 6269; add 6417 6418; mul 40 5314; add 6419 6420; mul 40 5322; add 6421 6422; mul 52 234; mul 21
6176; mul 6424 6425; add 6423 6426; mul 28 6427; add 6415 6428; mul 468 5384; mul 453 6430; mul 468 6282; add 6431
6432; mul 34 6284; sub 6434 1442; mul 28 6435; add 6433 6436; mul 34 6286; add 6437 6438; mul 34 6301; add 6439
6440; mul 66 6289; add 5720 6442; mul 66 6292; add 6443 6444; mul 40 5521; add 6445 6446; mul 40 5530; add 6447
6448; mul 21 6213; mul 6424 6450; add 6449 6451; mul 28 6452; add 6441 6453; mul 468 5589; mul 453 6455; mul 468
6304; add 6456 6457; mul 34 6306; add 2070 6459; mul 28 6460; add 6458 6461; mul 34 6308; add 6462 6463; mul 34
6324; add 6464 6465; mul 66 6311; mul 5122 5585; sub 6467 6468; mul 66 6315; add 6469 6470; mul 40 5732; add 6471
6472; mul 40 5737; add 6473 6474; mul 21 6247; mul 6424 6476; add 6475 6477; mul 28 6478; add 6466 6479; mul 34
6327; add 2603 6481; mul 28 6482; mul 34 6329; add 6483 6484; mul 34 6331; add 2791 6486; mul 28 6487; mul 34 6333;
add 6488 6489; mul 444 6404; mul 468 6335; add 6491 6492; mul 2 6409; add 6493 6494; mul 34 6340; add 6495 6496; mul
2 6427; add 6497 6498; mul 34 5327; add 6499 6500; mul 444 6430; mul 468 6349; add 6502 6503; mul 2 6435; add 6504
6505; mul 34 6354; add 6506 6507; mul 2 6452; add 6508 6509; mul 34 5534; add 6510 6511; mul 444 6455; mul 468 6363;
add 6513 6514; mul 2 6460; add 6515 6516; mul 34 6368; add 6517 6518; mul 2 6478; add 6519 6520; mul 34 5741; add
6521 6522; mul 2 6482; mul 34 6378; add 6524 6525; mul 2 6487; mul 34 6383; add 6527 6528; mul 468 6404; mul 34
6409; add 6530 6531; mul 34 6427; add 6532 6533; mul 468 6430; mul 34 6435; add 6535 6536; mul 34 6452; add 6537
6538; mul 468 6455; mul 34 6460; add 6540 6541; mul 34 6478; add 6542 6543; mul 34 6482; mul 34 6487; mul 37 4991;
mul 22 6547; sub 607 6548; mul 37 5405; mul 22 6550; add 1348 6551; mul 37 5612; mul 22 6553; sub 1979 6554; mul
4947 5293; mul 326 6547; sub 6556 6557; mul 4947 5297; add 6558 6559; mul 38 5327; add 6560 6561; mul 24 5282; add
6562 6563; mul 326 6550; mul 4947 5505; add 6565 6566; mul 4947 5508; add 6567 6568; mul 38 5534; add 6569 6570; mul
24 5494; add 6571 6572; mul 4947 5711; mul 326 6553; sub 6574 6575; mul 4947 5715; add 6576 6577; mul 38 5741; add
6578 6579; mul 24 5701; add 6580 6581; neg 597; neg 417; neg 530; neg 420; neg 533; neg 424; neg 537; input p 224;
mul 507 634; mul 6590 6591; add 634 6592; input p 225; mul 6591 6594; mul 328 6595; add 6593 6596; add 773 6597; mul
394 773; mul 6590 6599; add 6598 6600; mul 6594 6599; mul 328 6602; add 6601 6603; mul 507 1377; mul 6590 6605; add
1377 6606; mul 6594 6605; mul 328 6608; add 6607 6609; add 1495 6610; mul 394 1495; mul 6590 6612; add 6611 6613;
mul 6594 6612; mul 328 6615; add 6614 6616; neg 6617; mul 507 2003; mul 6590 6619; add 2003 6620; mul 6594 6619; mul
328 6622; add 6621 6623; add 2123 6624; mul 394 2123; mul 6590 6626; add 6625 6627; mul 6594 6626; mul 328 6629; add
6628 6630; mul 394 2625; mul 6590 6632; add 2625 6633; mul 6594 6632; mul 328 6635; add 6634 6636; mul 507 2802; mul
6590 6638; add 2802 6639; mul 6594 6638; mul 328 6641; add 6640 6642; le 5210 5209; le 5209 5210; add 6644 6645; div
1 6646; mul 6644 6647; mul 89 453; mul 6648 6649; neg 6650; mul 453 597; mul 6648 6652; mul 453 601; mul 6648 6654;
neg 6655; mul 5222 6649; neg 6657; mul 5222 6652; mul 5222 6654; neg 6660; mul 89 5231; mul 453 6662; neg 6663; mul
597 5231; mul 453 6665; mul 601 5231; mul 453 6667; neg 6668; input p 226; mul 5231 5232; mul 89 6671; mul 234 5230;
div 1 6673; mul 6672 6674; mul 6670 6675; mul 597 6671; mul 6674 6677; mul 6670 6678; neg 6679; mul 601 6671; mul
6674 6681; mul 6670 6682; mul 597 5178; mul 1334 5178; neg 6685; mul 1343 5178; le 1 5165; mul 444 5179; add 453
6689; lt 5210 6690; and 6688 6691; constant -1.0; le 5165 6693; lt 6690 5210; and 6694 6695; or 6692 6696; not 6697;
input p 157; mul 444 6699; where 6698 6700; le 1 5168; and 6691 6702; le 5168 6693; and 6695 6704; or 6703 6705; not
6706; input p 158; mul 444 6708; where 6707 6709; le 1 5172; and 6691 6711; le 5172 6693; and 6695 6713; or 6712
6714; not 6715; input p 159; mul 444 6717; where 6716 6718; le 1 5176; and 6691 6720; le 5176 6693; and 6695 6722;
or 6721 6723; not 6724; input p 160; mul 444 6726; where 6725 6727; mul 23 5020; mul 23 5007; mul 37 5010; add 6730
6731; mul 37 841; add 6732 6733; sub 6729 6734; mul 23 5422; mul 37 5425; add 6736 6737; mul 37 1545; sub 6738 6739;
mul 23 5434; add 6740 6741; mul 23 5639; mul 23 5627; mul 37 5630; add 6744 6745; mul 37 2177; add 6746 6747; sub
6743 6748; mul 23 5795; mul 23 5786; mul 37 5784; add 6751 6752; mul 37 2652; add 6753 6754; sub 6750 6755; mul 23
5010; mul 37 5007; sub 6757 6758; mul 23 841; add 6759 6760; mul 37 5020; add 6761 6762; mul 37 5422; mul 23 5425;
sub 6764 6765; mul 23 1545; add 6766 6767; mul 37 5434; add 6768 6769; mul 23 5630; mul 37 5627; sub 6771 6772; mul
23 2177; add 6773 6774; mul 37 5639; add 6775 6776; mul 23 5784; mul 37 5786; sub 6778 6779; mul 23 2652; add 6780
6781; mul 37 5795; add 6782 6783; neg 5020; neg 5434; neg 5639; neg 5795; mul 368 383; mul 821 6789; mul 368 431;
mul 804 6791; add 6790 6792; mul 368 415; mul 710 6794; add 6793 6795; mul 368 379; mul 837 6797; add 6796 6798; neg
6799; mul 1510 6791; mul 1525 6789; sub 6801 6802; mul 1357 6794; add 6803 6804; mul 1541 6797; sub 6805 6806; mul
2157 6789; mul 2141 6791; add 6808 6809; mul 2065 6794; add 6810 6811; mul 2173 6797; add 6812 6813; neg 6814; mul
2642 6789; mul 2628 6791; add 6816 6817; mul 2648 6797; add 6818 6819; neg 6820; mul 389 823; mul 389 1527; neg
6823; mul 389 2159; neg 1504; mul 396 795; mul 396 1504; neg 6828; mul 396 2135; mul 412 776; mul 404 6831; neg
6832; mul 412 1483; mul 404 6834; mul 412 2126; mul 404 6836; neg 6837; input p 227; mul 394 780; mul 6839 6840; add
780 6841; input p 228; mul 6840 6843; mul 328 6844; add 6842 6845; neg 6846; mul 394 1499; mul 6839 6848; add 1499
6849; mul 6843 6848; mul 328 6851; add 6850 6852; mul 394 2130; mul 6839 6854; add 2130 6855; mul 6843 6854; mul 328
6857; add 6856 6858; neg 6859; mul 438 710; mul 417 6861; mul 438 1357; mul 417 6863; neg 6864; mul 438 2065; mul
417 6866; mul 420 6861; mul 420 6863; neg 6869; mul 420 6866; mul 424 6861; mul 424 6863; neg 6873; mul 424 6866;
mul 438 766; mul 438 1488; neg 6877; mul 438 2116; mul 23 4993; mul 37 4989; add 6880 6881; mul 37 702; add 6882
6883; mul 23 5004; sub 6884 6885; mul 37 1438; mul 23 5407; mul 37 5410; add 6888 6889; sub 6887 6890; mul 23 5419;
sub 6891 6892; mul 23 5614; mul 37 5610; add 6894 6895; mul 37 2057; add 6896 6897; mul 23 5624; sub 6898 6899; mul
23 5825; mul 37 5827; add 6901 6902; mul 37 2829; add 6903 6904; mul 23 5836; sub 6905 6906; mul 23 4989; mul 37
4993; sub 6908 6909; mul 23 702; add 6910 6911; mul 37 5004; add 6912 6913; mul 37 5407; mul 23 5410; sub 6915 6916;
mul 23 1438; add 6917 6918; mul 37 5419; add 6919 6920; mul 23 5610; mul 37 5614; sub 6922 6923; mul 23 2057; add
6924 6925; mul 37 5624; add 6926 6927; mul 23 5827; mul 37 5825; sub 6929 6930; mul 23 2829; add 6931 6932; mul 37
5836; add 6933 6934; mul 484 499; mul 682 6936; mul 484 543; mul 665 6938; add 6937 6939; mul 484 528; mul 609 6941;
add 6940 6942; mul 484 495; mul 698 6944; add 6943 6945; neg 6946; mul 1392 6938; mul 1414 6936; sub 6948 6949; mul
1350 6941; add 6950 6951; mul 1430 6944; sub 6952 6953; mul 2037 6936; mul 2021 6938; add 6955 6956; mul 1981 6941;
add 6957 6958; mul 2053 6944; add 6959 6960; neg 6961; mul 2819 6936; mul 2805 6938; add 6963 6964; mul 2825 6944;
add 6965 6966; neg 6967; mul 505 684; mul 505 1416; neg 6970; mul 505 2039; neg 1386; mul 509 656; mul 509 1386; neg
6975; mul 509 2015; mul 525 637; mul 517 6978; neg 6979; mul 525 1365; mul 517 6981; mul 525 2006; mul 517 6983; neg
6984; input p 229; mul 507 641; mul 6986 6987; add 641 6988; input p 230; mul 6987 6990; mul 328 6991; add 6989
6992; neg 6993; mul 507 1381; mul 6986 6995; add 1381 6996; mul 6990 6995; mul 328 6998; add 6997 6999; mul 507
2010; mul 6986 7001; add 2010 7002; mul 6990 7001; mul 328 7004; add 7003 7005; neg 7006; mul 548 609; mul 530 7008;
mul 548 1350; mul 530 7010; neg 7011; mul 548 1981; mul 530 7013; mul 533 7008; mul 533 7010; neg 7016; mul 533
7013; mul 537 7008; mul 537 7010; neg 7020; mul 537 7013; mul 548 627; mul 548 1370; neg 7024; mul 548 1996; mul 597
5179; sub 7027 89; mul 5165 7028; mul 1334 5179; sub 597 7030; mul 5165 7031; mul 1343 5179; sub 7033 601; mul 5165
7034; mul 5168 7028; mul 5168 7031; mul 5168 7034; mul 5172 7028; mul 5172 7031; mul 5172 7034; mul 5176 7028; mul
5176 7031; mul 5176 7034; mul 6690 6699; mul 6699 7045; neg 7046; where 6698 7047; mul 6690 6708; mul 6708 7049; neg
7050; where 6707 7051; mul 6690 6717; mul 6717 7053; neg 7054; where 6716 7055; mul 6690 6726; mul 6726 7057; neg
7058; where 6725 7059; mul 89 5238; neg 7061; mul 597 5238; mul 601 5238; neg 7064; mul 89 5242; neg 7066; mul 597
5242; mul 601 5242; neg 7069; mul 90 1328; neg 7071; mul 90 1963; mul 90 2599; neg 7074; store by_k 90 1330; store
by_k 270 1965; store by_k 450 2601; store by_k 540 2789; store by_k 630 2977; store by_k 720 2789; store by_k 810
2977; store by_k 900 2789; store by_k 990 2977; store by_k 91 3175; store by_k 271 3319; store by_k 451 3456; store
by_k 92 3472; store by_k 272 3482; store by_k 452 3492; store by_k 93 3627; store by_k 273 3735; store by_k 453
3843; store by_k 94 4009; store by_k 274 4137; store by_k 454 4265; store by_k 95 4351; store by_k 275 4419; store
by_k 455 4487; store by_k 545 4555; store by_k 635 4623; store by_k 725 4555; store by_k 815 4623; store by_k 905
4555; store by_k 995 4623; store by_k 96 4700; store by_k 276 4774; store by_k 456 4848; store by_k 97 4857; store
by_k 277 4866; store by_k 457 4875; store by_k 547 4878; store by_k 637 4881; store by_k 727 4878; store by_k 817
4881; store by_k 907 4878; store by_k 997 4881; store by_k 98 4890; store by_k 278 4899; store by_k 458 4908; store
by_k 548 4911; store by_k 638 4914; store by_k 728 4911; store by_k 818 4914; store by_k 908 4911; store by_k 998
4914; store by_k 99 4923; store by_k 279 4929; store by_k 459 4938; store by_k 549 4941; store by_k 639 4944; store
by_k 729 4941; store by_k 819 4944; store by_k 909 4941; store by_k 999 4944; store by_k 100 5370; store by_k 280
5576; store by_k 460 5783; store by_k 550 5824; store by_k 640 5865; store by_k 730 5824; store by_k 820 5865; store
by_k 910 5824; store by_k 1000 5865; store by_k 101 5869; store by_k 281 5871; store by_k 461 5874; store by_k 102
5881; store by_k 282 5887; store by_k 462 5893; store by_k 103 5900; store by_k 283 5904; store by_k 463 5911; store
by_k 104 5918; store by_k 284 5924; store by_k 464 5930; store by_k 105 5940; store by_k 285 5949; store by_k 465
5959; store by_k 106 5966; store by_k 286 5971; store by_k 466 5978; store by_k 107 5984; store by_k 287 5990; store
by_k 467 5996; store by_k 108 6006; store by_k 288 6015; store by_k 468 6025; store by_k 109 6035; store by_k 289
6043; store by_k 469 6053; store by_k 110 6060; store by_k 290 6065; store by_k 470 6072; store by_k 111 6074; store
by_k 291 6077; store by_k 471 6079; store by_k 112 6085; store by_k 292 6091; store by_k 472 6097; store by_k 113
6103; store by_k 293 6109; store by_k 473 6115; store by_k 114 6121; store by_k 294 6127; store by_k 474 6133; store
by_k 115 6136; store by_k 295 6138; store by_k 475 6141; store by_k 116 6180; store by_k 296 6217; store by_k 476
6251; store by_k 117 6252; store by_k 297 6253; store by_k 477 6254; store by_k 118 5279; store by_k 298 5491; store
by_k 478 5698; store by_k 119 6255; store by_k 299 6256; store by_k 479 6257; store by_k 120 6176; store by_k 300
6213; store by_k 480 6247; store by_k 121 6281; store by_k 301 6303; store by_k 481 6326; store by_k 571 6330; store
by_k 661 6334; store by_k 751 6330; store by_k 841 6334; store by_k 931 6330; store by_k 1021 6334; store by_k 122
6348; store by_k 302 6362; store by_k 482 6376; store by_k 572 6381; store by_k 662 6386; store by_k 752 6381; store
by_k 842 6386; store by_k 932 6381; store by_k 1022 6386; store by_k 123 6391; store by_k 303 6396; store by_k 483
6401; store by_k 573 6402; store by_k 663 6403; store by_k 753 6402; store by_k 843 6403; store by_k 933 6402; store
by_k 1023 6403; store by_k 124 6429; store by_k 304 6454; store by_k 484 6480; store by_k 574 6485; store by_k 664
6490; store by_k 754 6485; store by_k 844 6490; store by_k 934 6485; store by_k 1024 6490; store by_k 125 6501;
store by_k 305 6512; store by_k 485 6523; store by_k 575 6526; store by_k 665 6529; store by_k 755 6526; store by_k
845 6529; store by_k 935 6526; store by_k 1025 6529; store by_k 126 6534; store by_k 306 6539; store by_k 486 6544;
store by_k 576 6545; store by_k 666 6546; store by_k 756 6545; store by_k 846 6546; store by_k 936 6545; store by_k
1026 6546; store by_k 127 6549; store by_k 307 6552; store by_k 487 6555; store by_k 128 6564; store by_k 308 6573;
store by_k 488 6582; store by_k 129 89; store by_k 309 6583; store by_k 489 601; store by_k 580 6584; store by_k 670
6585; store by_k 761 6586; store by_k 851 6587; store by_k 942 6588; store by_k 1032 6589; store by_k 133 6604;
store by_k 313 6618; store by_k 493 6631; store by_k 583 6637; store by_k 673 6643; store by_k 763 6637; store by_k
853 6643; store by_k 943 6637; store by_k 1033 6643; store by_k 134 6651; store by_k 314 6653; store by_k 494 6656;
store by_k 135 6658; store by_k 315 6659; store by_k 495 6661; store by_k 136 6664; store by_k 316 6666; store by_k
496 6669; store by_k 137 6676; store by_k 317 6680; store by_k 497 6683; store by_k 138 6684; store by_k 318 6686;
store by_k 498 6687; store by_k 1308 6701; store by_k 1398 6710; store by_k 1488 6719; store by_k 1578 6728; store
by_k 139 6735; store by_k 319 6742; store by_k 499 6749; store by_k 589 6756; store by_k 769 6756; store by_k 949
6756; store by_k 140 6763; store by_k 320 6770; store by_k 500 6777; store by_k 590 6784; store by_k 770 6784; store
by_k 950 6784; store by_k 141 6785; store by_k 321 6786; store by_k 501 6787; store by_k 591 6788; store by_k 771
6788; store by_k 951 6788; store by_k 142 841; store by_k 322 1545; store by_k 502 2177; store by_k 592 2652; store
by_k 772 2652; store by_k 952 2652; store by_k 143 6800; store by_k 323 6807; store by_k 503 6815; store by_k 593
6821; store by_k 773 6821; store by_k 953 6821; store by_k 144 6822; store by_k 324 6824; store by_k 504 6825; store
by_k 145 795; store by_k 325 6826; store by_k 505 2135; store by_k 146 6827; store by_k 326 6829; store by_k 506
6830; store by_k 147 6833; store by_k 327 6835; store by_k 507 6838; store by_k 148 6847; store by_k 328 6853; store
by_k 508 6860; store by_k 149 6862; store by_k 329 6865; store by_k 509 6867; store by_k 150 6868; store by_k 330
6870; store by_k 510 6871; store by_k 151 6872; store by_k 331 6874; store by_k 511 6875; store by_k 152 6876; store
by_k 332 6878; store by_k 512 6879; store by_k 153 6886; store by_k 333 6893; store by_k 513 6900; store by_k 693
6907; store by_k 873 6907; store by_k 1053 6907; store by_k 154 6914; store by_k 334 6921; store by_k 514 6928;
store by_k 694 6935; store by_k 874 6935; store by_k 1054 6935; store by_k 155 5004; store by_k 335 5419; store by_k
515 5624; store by_k 695 5836; store by_k 875 5836; store by_k 1055 5836; store by_k 156 702; store by_k 336 1438;
store by_k 516 2057; store by_k 696 2829; store by_k 876 2829; store by_k 1056 2829; store by_k 157 6947; store by_k
337 6954; store by_k 517 6962; store by_k 697 6968; store by_k 877 6968; store by_k 1057 6968; store by_k 158 6969;
store by_k 338 6971; store by_k 518 6972; store by_k 159 656; store by_k 339 6973; store by_k 519 2015; store by_k
160 6974; store by_k 340 6976; store by_k 520 6977; store by_k 161 6980; store by_k 341 6982; store by_k 521 6985;
store by_k 162 6994; store by_k 342 7000; store by_k 522 7007; store by_k 163 7009; store by_k 343 7012; store by_k
523 7014; store by_k 164 7015; store by_k 344 7017; store by_k 524 7018; store by_k 165 7019; store by_k 345 7021;
store by_k 525 7022; store by_k 166 7023; store by_k 346 7025; store by_k 526 7026; store by_k 167 7029; store by_k
347 7032; store by_k 527 7035; store by_k 168 7036; store by_k 348 7037; store by_k 528 7038; store by_k 169 7039;
store by_k 349 7040; store by_k 529 7041; store by_k 170 7042; store by_k 350 7043; store by_k 530 7044; store by_k
1341 7048; store by_k 1432 7052; store by_k 1523 7056; store by_k 1614 7060; store by_k 175 7062; store by_k 355
7063; store by_k 535 7065; store by_k 176 7067; store by_k 356 7068; store by_k 536 7070; store by_k 1167 5238;
store by_k 1258 5242; store by_k 179 7072; store by_k 359 7073; store by_k 539 7075
    """,
)
