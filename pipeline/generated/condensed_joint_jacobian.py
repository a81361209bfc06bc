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
sub 143 668; input p 121; input p 122; input z 0; mul 671 672; input p 123; input z 1; mul 674 675; add 673 676;
input p 124; input z 2; mul 678 679; add 677 680; input p 125; input z 3; mul 682 683; add 681 684; sub 670 685;
input p 126; abs 0; mul 687 688; mul 0 689; input p 127; mul 0 691; mul 0 0; input p 128; add 693 694; sqrt 695; div
2 696; mul 692 697; add 690 698; sub 686 699; add 669 700; input p 129; input x 12; sub 29 703; mul 702 704; input p
130; input x 13; sub 29 707; mul 706 708; add 705 709; sub 701 710; mul 0 62; mul 28 130; add 712 713; mul 47 539;
add 714 715; mul 0 716; mul 0 28; mul 31 130; add 718 719; mul 34 539; add 720 721; mul 130 722; add 717 723; mul 0
47; mul 34 130; add 725 726; mul 51 539; add 727 728; mul 539 729; add 724 730; mul 17 130; mul 130 732; mul 23 733;
input p 131; mul 9 735; mul 9 736; mul 8 16; mul 10 738; mul 738 739; add 737 740; mul 3 741; mul 38 742; sub 25
743; mul 734 744; add 731 745; mul 67 746; mul 24 742; add 39 748; mul 734 749; sub 747 750; mul 22 751; sub 711
752; mul 90 753; mul 81 89; mul 150 265; mul 145 756; abs 3; lt 758 279; input p 132; mul 276 760; input p 133; mul
283 762; add 761 763; mul 291 298; add 764 765; input p 134; mul 295 767; add 766 768; input p 135; mul 299 770; add
769 771; input p 136; mul 303 773; add 772 774; mul 306 775; input p 137; mul 309 777; mul 312 319; add 778 779;
input p 138; mul 316 781; add 780 782; input p 139; mul 320 784; add 783 785; input p 140; mul 324 787; add 786 788;
mul 328 339; add 789 790; input p 141; mul 332 792; add 791 793; input p 142; mul 336 795; add 794 796; input p 143;
mul 340 798; add 797 799; input p 144; mul 306 801; add 800 802; add 776 803; mul 145 804; where 759 805; add 757
806; mul 532 641; sub 807 808; mul 150 660; add 809 810; mul 523 545; mul 630 638; add 812 813; add 811 814; sub 134
815; input p 145; mul 38 817; mul 17 818; add 816 819; input p 146; mul 685 821; sub 820 822; mul 41 746; mul 26
750; sub 824 825; mul 22 826; mul 19 742; mul 733 828; sub 827 829; sub 823 830; mul 755 831; sub 754 832; mul 86
89; input p 147; mul 35 835; input p 148; mul 214 837; add 836 838; input p 149; mul 218 840; add 839 841; mul 155
210; add 842 843; input p 150; mul 158 845; add 844 846; input p 151; mul 162 848; add 847 849; input p 152; mul 166
851; add 850 852; mul 170 227; add 853 854; input p 153; mul 174 856; add 855 857; mul 157 189; add 858 859; input p
154; mul 193 861; add 860 862; mul 169 197; add 863 864; input p 155; mul 201 866; add 865 867; mul 184 258; add 868
869; mul 202 257; add 870 871; mul 153 265; add 872 873; mul 145 874; abs 35; lt 876 287; input p 156; mul 276 878;
mul 283 298; add 879 880; input p 157; mul 291 882; add 881 883; input p 158; mul 295 885; add 884 886; input p 159;
mul 299 888; add 887 889; input p 160; mul 303 891; add 890 892; mul 306 893; input p 161; mul 309 895; mul 312 781;
add 896 897; mul 316 327; add 898 899; mul 320 335; add 900 901; input p 162; mul 324 903; add 902 904; input p 163;
mul 328 906; add 905 907; input p 164; mul 332 909; add 908 910; mul 336 798; add 911 912; input p 165; mul 340 914;
add 913 915; input p 166; mul 306 917; add 916 918; add 894 919; constant 3.0; mul 303 921; input p 167; mul 309
923; mul 312 760; add 924 925; mul 316 878; add 926 927; mul 294 320; add 928 929; mul 298 324; add 930 931; mul 302
328; add 932 933; input p 168; mul 332 935; add 934 936; mul 336 885; add 937 938; mul 340 773; add 939 940; input p
169; mul 306 942; add 941 943; mul 922 944; add 920 945; mul 145 946; where 877 947; add 875 948; mul 538 641; sub
949 950; input p 170; mul 539 952; mul 153 660; add 953 954; add 951 955; mul 53 746; mul 22 957; add 956 958; mul
834 959; sub 833 960; mul 56 70; mul 79 79; sub 962 963; mul 89 964; mul 831 965; mul 753 755; sub 966 967; mul 59
70; mul 76 79; sub 969 970; mul 89 971; mul 959 972; add 968 973; mul 753 834; mul 831 972; sub 975 976; mul 45 70;
mul 76 76; sub 978 979; mul 89 980; mul 959 981; sub 977 982; mul 511 543; input p 171; mul 490 985; sub 984 986;
mul 618 636; mul 600 985; sub 988 989; input p 172; mul 493 991; sub 984 992; mul 603 991; sub 988 994; input p 173;
mul 497 996; sub 984 997; mul 607 996; sub 988 999; input p 174; mul 704 1001; input p 175; mul 708 1003; le 2 672;
mul 130 821; add 0 1006; lt 140 1007; and 1005 1008; constant -1.0; le 672 1010; lt 1007 140; and 1011 1012; or 1009
1013; not 1014; input p 176; mul 1007 1016; where 1015 1017; le 2 675; and 1008 1019; le 675 1010; and 1012 1021; or
1020 1022; not 1023; input p 177; mul 1007 1025; where 1024 1026; le 2 679; and 1008 1028; le 679 1010; and 1012
1030; or 1029 1031; not 1032; input p 178; mul 1007 1034; where 1033 1035; le 2 683; and 1008 1037; le 683 1010; and
1012 1039; or 1038 1040; not 1041; input p 179; mul 1007 1043; where 1042 1044; mul 41 459; mul 28 1046; mul 22
1047; mul 56 1048; mul 53 459; mul 47 1050; mul 22 1051; mul 45 1052; add 1049 1053; mul 28 53; mul 41 47; add 1055
1056; mul 22 1057; mul 59 1058; add 1059 1059; sub 1054 1060; mul 89 1061; mul 89 90; mul 67 459; mul 62 1064; mul
22 1065; mul 61 1066; mul 70 1061; add 1067 1068; mul 41 62; mul 28 67; add 1070 1071; mul 22 1072; mul 81 1073; mul
56 1073; mul 76 1052; add 1075 1076; mul 79 1058; mul 47 67; mul 53 62; add 1079 1080; mul 22 1081; mul 59 1082; add
1078 1083; sub 1077 1084; mul 76 1085; add 1074 1086; sub 1069 1087; mul 86 1082; mul 59 1073; mul 76 1058; add 1090
1091; mul 79 1048; mul 45 1082; add 1093 1094; sub 1092 1095; mul 79 1096; add 1089 1097; add 1088 1098; mul 1063
1099; sub 1062 1100; mul 753 1101; mul 100 106; mul 102 1103; mul 100 114; sub 1104 1105; mul 100 118; mul 100 1107;
sub 1106 1108; input p 180; input p 181; mul 35 1111; mul 157 1112; add 1110 1113; mul 35 1112; mul 161 1115; add
1114 1116; mul 155 459; mul 1111 1118; mul 165 1119; add 1117 1120; mul 35 1119; mul 169 1122; add 1121 1123; mul
155 1119; mul 166 1111; add 1125 1126; mul 173 1127; add 1124 1128; input p 182; add 1129 1130; mul 35 144; mul 180
1132; add 1131 1133; mul 35 1132; mul 184 1135; add 1134 1136; mul 144 155; mul 148 1111; add 1138 1139; mul 188
1140; add 1137 1141; mul 35 1140; mul 192 1143; add 1142 1144; mul 155 1140; mul 189 1111; add 1146 1147; mul 196
1148; add 1145 1149; mul 148 459; mul 144 1151; mul 155 1152; mul 201 1111; add 1153 1154; mul 200 1155; add 1150
1156; mul 148 1152; mul 144 201; add 1158 1159; mul 205 1160; add 1157 1161; input p 183; mul 224 1112; add 1163
1164; mul 227 1115; add 1165 1166; mul 230 1119; add 1167 1168; mul 233 1122; add 1169 1170; mul 236 1127; add 1171
1172; input p 184; add 1173 1174; mul 157 1132; add 1175 1176; mul 161 1135; add 1177 1178; mul 245 1140; add 1179
1180; mul 248 1143; add 1181 1182; mul 251 1148; add 1183 1184; mul 254 1152; add 1185 1186; mul 35 1152; mul 257
1188; add 1187 1189; mul 196 1155; add 1190 1191; mul 263 1160; add 1192 1193; mul 147 1194; add 1162 1195; mul 145
1196; mul 275 459; le 274 270; le 270 274; add 1199 1200; div 2 1201; mul 1199 1202; le 273 148; le 148 273; add
1204 1205; div 2 1206; mul 1204 1207; mul 144 1208; mul 1203 1209; mul 1198 1210; mul 272 1211; mul 282 1210; mul
278 1213; add 1212 1214; mul 290 1210; mul 286 1216; add 1215 1217; mul 306 1218; mul 275 1211; mul 276 1210; add
1220 1221; mul 308 1222; mul 282 1211; mul 311 1224; add 1223 1225; mul 290 1211; mul 315 1227; add 1226 1228; mul
282 1213; mul 319 1230; add 1229 1231; mul 290 1213; mul 323 1233; add 1232 1234; mul 290 1216; mul 327 1236; add
1235 1237; add 1219 1238; mul 145 1239; where 271 1240; add 1197 1241; input p 185; mul 352 1115; mul 354 1127; add
1244 1245; mul 357 1135; add 1246 1247; mul 360 1143; add 1248 1249; mul 363 1148; add 1250 1251; mul 366 1155; add
1252 1253; mul 369 1160; add 1254 1255; mul 374 1115; mul 377 1122; add 1257 1258; mul 380 1127; add 1259 1260; mul
352 1135; add 1261 1262; mul 385 1148; add 1263 1264; mul 388 1188; add 1265 1266; mul 363 1155; add 1267 1268; mul
393 1160; add 1269 1270; mul 147 1271; add 1256 1272; mul 350 1273; add 1243 1274; mul 641 1275; mul 440 459; add 63
67; add 64 1278; add 66 1279; mul 104 1280; mul 144 371; mul 148 1256; add 1282 1283; mul 395 1111; mul 155 1271;
add 1285 1286; add 1284 1287; mul 414 1115; mul 374 1122; add 1289 1290; mul 419 1127; add 1291 1292; mul 422 1143;
add 1293 1294; mul 357 1188; add 1295 1296; mul 388 1155; add 1297 1298; mul 35 1299; add 1288 1300; mul 408 1301;
mul 350 1302; add 1281 1303; mul 1277 1304; mul 447 459; sub 1305 1306; mul 451 459; div 2 1308; mul 1307 1309; mul
441 1310; mul 459 1311; mul 454 459; mul 453 459; div 2 1314; mul 1311 1315; mul 455 1316; mul 1313 1317; neg 1318;
mul 459 1319; mul 455 1320; mul 461 1318; sub 1321 1322; sub 1312 1323; mul 458 1324; mul 476 1325; le 469 465; le
465 469; add 1327 1328; div 2 1329; mul 1327 1330; le 466 468; le 468 466; add 1332 1333; div 2 1334; mul 1332 1335;
mul 1311 1336; mul 1331 1337; mul 472 1338; mul 470 1339; mul 474 1338; add 1340 1341; mul 464 1342; add 1326 1343;
mul 481 1311; mul 468 1345; mul 483 1311; add 1346 1347; mul 479 1348; sub 1344 1349; mul 441 1350; mul 506 1311;
mul 468 1352; mul 508 1311; add 1353 1354; mul 504 1355; mul 502 1316; mul 454 1357; mul 503 1316; add 1358 1359;
mul 454 1360; mul 454 503; mul 1316 1362; add 1361 1363; mul 441 1364; mul 510 1365; sub 1356 1366; mul 499 1367;
add 1351 1368; mul 514 1367; mul 511 1370; mul 515 1367; add 1371 1372; mul 543 1373; mul 441 1318; mul 447 1375;
add 456 1376; mul 0 1377; mul 519 1304; add 517 1379; mul 456 1380; mul 521 1375; add 1381 1382; mul 17 1383; mul
130 1384; sub 1378 1385; mul 456 1304; mul 440 1375; sub 1387 1388; mul 541 1389; mul 528 1275; mul 150 1271; mul
350 1392; add 28 1393; mul 130 1394; add 1391 1395; mul 153 1271; add 1299 1397; mul 350 1398; add 47 1399; mul 539
1400; add 1396 1401; mul 457 1402; add 1390 1403; add 1386 1404; mul 516 1405; add 1374 1406; add 1369 1407; mul 457
1408; mul 545 1389; add 1409 1410; mul 459 554; mul 1304 1412; mul 459 561; sub 1413 1414; mul 459 565; div 2 1416;
mul 1415 1417; mul 555 1418; mul 459 1419; mul 459 568; mul 459 567; div 2 1422; mul 1419 1423; mul 569 1424; mul
1421 1425; neg 1426; mul 459 1427; mul 569 1428; mul 574 1426; sub 1429 1430; sub 1420 1431; mul 572 1432; mul 586
1433; le 579 465; le 465 579; add 1435 1436; div 2 1437; mul 1435 1438; le 466 578; le 578 466; add 1440 1441; div 2
1442; mul 1440 1443; mul 1419 1444; mul 1439 1445; mul 582 1446; mul 580 1447; mul 584 1446; add 1448 1449; mul 577
1450; add 1434 1451; mul 591 1419; mul 578 1453; mul 593 1419; add 1454 1455; mul 589 1456; sub 1452 1457; mul 555
1458; mul 506 1419; mul 578 1460; mul 615 1419; add 1461 1462; mul 613 1463; mul 611 1424; mul 568 1465; mul 612
1424; add 1466 1467; mul 568 1468; mul 568 612; mul 1424 1470; add 1469 1471; mul 555 1472; mul 617 1473; sub 1464
1474; mul 609 1475; add 1459 1476; mul 621 1475; mul 618 1478; mul 622 1475; add 1479 1480; mul 636 1481; mul 626
1304; sub 1483 624; mul 570 1484; mul 555 1426; mul 628 1486; sub 1485 1487; mul 17 1488; mul 130 1489; mul 561
1486; add 570 1491; mul 0 1492; add 1490 1493; mul 570 1304; mul 554 1486; sub 1495 1496; mul 541 1497; mul 571
1402; add 1498 1499; add 1494 1500; mul 623 1501; add 1482 1502; add 1477 1503; mul 571 1504; mul 638 1497; add 1505
1506; add 1411 1507; mul 399 1508; sub 1276 1509; sub 1242 1510; mul 144 1511; mul 525 1408; mul 545 1377; sub 1513
1514; mul 632 1504; mul 638 1492; sub 1516 1517; add 1515 1518; sub 1512 1519; sub 1109 1520; input p 186; sub 1521
1522; mul 62 746; mul 22 1524; sub 1523 1525; mul 90 1526; add 1102 1527; mul 89 1085; mul 89 755; mul 1099 1530;
sub 1529 1531; mul 831 1532; mul 150 1194; mul 145 1534; mul 760 1211; mul 762 1213; add 1536 1537; mul 298 1216;
add 1538 1539; mul 306 1540; mul 777 1222; mul 319 1224; add 1542 1543; mul 781 1227; add 1544 1545; mul 784 1230;
add 1546 1547; mul 787 1233; add 1548 1549; mul 339 1236; add 1550 1551; add 1541 1552; mul 145 1553; where 759
1554; add 1535 1555; mul 641 1394; mul 532 1508; sub 1557 1558; sub 1556 1559; mul 523 1408; mul 545 1384; sub 1561
1562; mul 630 1504; mul 638 1489; add 1564 1565; add 1563 1566; add 1560 1567; sub 1107 1568; mul 28 746; mul 22
1570; sub 1569 1571; mul 755 1572; add 1533 1573; sub 1528 1574; mul 89 1096; mul 89 834; mul 1099 1577; sub 1576
1578; mul 959 1579; input p 187; mul 845 1112; add 1581 1582; mul 848 1115; add 1583 1584; mul 851 1119; add 1585
1586; mul 227 1122; add 1587 1588; mul 856 1127; add 1589 1590; mul 157 1140; add 1591 1592; mul 861 1143; add 1593
1594; mul 169 1148; add 1595 1596; mul 866 1152; add 1597 1598; mul 184 1188; add 1599 1600; mul 257 1155; add 1601
1602; mul 153 1194; add 1603 1604; mul 145 1605; mul 878 1211; mul 298 1213; add 1607 1608; mul 882 1216; add 1609
1610; mul 306 1611; mul 895 1222; mul 781 1224; add 1613 1614; mul 327 1227; add 1615 1616; mul 335 1230; add 1617
1618; mul 903 1233; add 1619 1620; mul 906 1236; add 1621 1622; add 1612 1623; mul 923 1222; mul 760 1224; add 1625
1626; mul 878 1227; add 1627 1628; mul 294 1230; add 1629 1630; mul 298 1233; add 1631 1632; mul 302 1236; add 1633
1634; mul 922 1635; add 1624 1636; mul 145 1637; where 877 1638; add 1606 1639; mul 641 1400; mul 538 1508; sub 1641
1642; sub 1640 1643; mul 47 746; mul 22 1645; add 1644 1646; mul 834 1647; add 1580 1648; sub 1575 1649; input c_q
0; mul 90 1651; le 140 139; le 139 140; add 1653 1654; div 2 1655; mul 1653 1656; mul 0 90; mul 1657 1658; input c_q
1; mul 1659 1660; sub 1652 1661; mul 90 93; input c_q 2; mul 1663 1664; add 1662 1665; mul 90 97; input c_q 3; mul
1667 1668; add 1666 1669; mul 90 100; add 755 1671; input c_q 4; mul 1672 1673; sub 1670 1674; mul 102 1672; input
c_q 5; mul 1676 1677; add 1675 1678; mul 93 1672; input c_q 6; mul 1680 1681; sub 1679 1682; mul 97 1672; input c_q
7; mul 1684 1685; sub 1683 1686; le 128 127; le 127 128; add 1688 1689; div 2 1690; mul 1688 1691; mul 132 1672; mul
1692 1693; input c_q 8; mul 1694 1695; add 1687 1696; mul 90 102; input c_q 9; mul 1698 1699; add 1697 1700; mul 102
1698; mul 104 1702; input c_q 10; mul 1703 1704; sub 1701 1705; mul 93 1698; input c_q 11; mul 1707 1708; add 1706
1709; mul 97 1698; input c_q 12; mul 1711 1712; add 1710 1713; add 1650 1714; mul 56 1066; mul 70 1052; add 1716
1717; mul 79 1082; add 1719 1719; sub 1718 1720; mul 89 1721; mul 89 965; mul 1099 1723; sub 1722 1724; mul 831
1725; mul 965 1572; add 1726 1727; mul 753 1532; mul 755 1526; add 1729 1730; sub 1728 1731; mul 59 1066; mul 70
1058; add 1733 1734; mul 76 1082; mul 79 1073; add 1736 1737; sub 1735 1738; mul 89 1739; mul 89 972; mul 1099 1741;
sub 1740 1742; mul 959 1743; mul 972 1647; add 1744 1745; add 1732 1746; mul 0 755; mul 1657 1748; mul 1660 1749;
mul 755 1651; sub 1750 1751; mul 93 755; mul 1664 1753; sub 1752 1754; mul 97 755; mul 1668 1756; sub 1755 1757; mul
100 755; add 965 1759; mul 1673 1760; add 1758 1761; mul 102 1760; mul 1677 1763; sub 1762 1764; mul 93 1760; mul
1681 1766; add 1765 1767; mul 97 1760; mul 1685 1769; add 1768 1770; mul 132 1760; mul 1692 1772; mul 1695 1773; sub
1771 1774; mul 102 755; mul 1699 1776; sub 1775 1777; mul 102 1776; mul 104 1779; mul 1704 1780; add 1778 1781; mul
93 1776; mul 1708 1783; sub 1782 1784; mul 97 1776; mul 1712 1786; sub 1785 1787; add 1747 1788; mul 753 1579; mul
834 1526; add 1790 1791; mul 831 1743; mul 972 1572; add 1793 1794; sub 1792 1795; mul 45 1066; mul 70 1048; add
1797 1798; mul 76 1073; add 1800 1800; sub 1799 1801; mul 89 1802; mul 89 981; mul 1099 1804; sub 1803 1805; mul 959
1806; mul 981 1647; add 1807 1808; sub 1796 1809; mul 834 1651; mul 0 834; mul 1657 1812; mul 1660 1813; sub 1811
1814; mul 93 834; mul 1664 1816; add 1815 1817; mul 97 834; mul 1668 1819; add 1818 1820; mul 100 834; add 972 1822;
mul 1673 1823; sub 1821 1824; mul 102 1823; mul 1677 1826; add 1825 1827; mul 93 1823; mul 1681 1829; sub 1828 1830;
mul 97 1823; mul 1685 1832; sub 1831 1833; mul 132 1823; mul 1692 1835; mul 1695 1836; add 1834 1837; mul 102 834;
mul 1699 1839; add 1838 1840; mul 102 1839; mul 104 1842; mul 1704 1843; sub 1841 1844; mul 93 1839; mul 1708 1846;
add 1845 1847; mul 97 1839; mul 1712 1849; add 1848 1850; add 1810 1851; mul 543 1367; mul 511 1405; add 1853 1854;
mul 636 1475; mul 618 1501; add 1856 1857; mul 100 129; mul 100 1859; add 141 1860; mul 144 399; mul 457 1862; sub
1863 525; mul 516 1864; mul 457 1865; mul 571 1862; sub 1867 632; mul 623 1868; mul 571 1869; add 1866 1870; mul 399
1871; input p 188; add 1872 1873; mul 144 1874; mul 525 1865; mul 632 1869; add 1876 1877; sub 1875 1878; add 1861
1879; sign 0; mul 687 1881; mul 0 1882; add 689 1883; mul 691 697; mul 697 698; mul 0 697; mul 1886 1887; sub 1885
1888; add 1884 1889; add 1880 1890; add 712 716; add 713 1892; add 715 1893; mul 67 1894; mul 22 1895; add 1891
1896; mul 90 1897; mul 532 1871; input p 189; add 1899 1900; mul 523 1865; mul 630 1869; add 1902 1903; add 1901
1904; sub 1859 1905; mul 41 1894; mul 22 1907; sub 1906 1908; mul 755 1909; add 1898 1910; mul 538 1871; input p
190; add 1912 1913; mul 53 1894; mul 22 1915; add 1914 1916; mul 834 1917; add 1911 1918; neg 1919; mul 965 1909;
mul 755 1897; add 1921 1922; mul 972 1917; add 1923 1924; mul 834 1897; mul 972 1909; add 1926 1927; mul 981 1917;
add 1928 1929; neg 1930; mul 511 1864; mul 618 1868; where 1015 1016; where 1024 1025; where 1033 1034; where 1042
1043; mul 26 459; div 2 14; mul 11 1939; mul 9 1940; mul 9 24; mul 5 9; mul 1942 1943; sub 1941 1944; mul 17 1945;
mul 9 9; mul 1943 1947; mul 16 1948; mul 16 17; mul 14 1943; mul 8 1940; add 1951 1952; mul 1950 1953; add 1949
1954; mul 24 1955; sub 1946 1956; mul 23 1957; mul 1938 1958; mul 9 38; mul 1943 1960; sub 9 1961; mul 17 1962; mul
38 1955; sub 1963 1964; mul 23 1965; add 31 1966; mul 1046 1967; add 1959 1968; mul 22 1969; mul 18 1955; mul 17
1971; mul 19 1955; add 1972 1973; sub 1970 1974; mul 56 1975; mul 34 1050; mul 22 1977; mul 45 1978; add 1976 1979;
mul 53 1967; mul 34 41; add 1981 1982; mul 22 1983; mul 59 1984; add 1985 1985; sub 1980 1986; mul 89 1987; mul 28
1064; mul 22 1989; mul 61 1990; mul 70 1987; add 1991 1992; mul 28 41; mul 67 1967; add 1994 1995; add 1958 1996;
mul 22 1997; mul 81 1998; mul 56 1998; mul 76 1978; add 2000 2001; mul 79 1984; mul 34 67; add 1055 2004; mul 22
2005; mul 59 2006; add 2003 2007; sub 2002 2008; mul 76 2009; add 1999 2010; sub 1993 2011; mul 86 2006; mul 59
1998; mul 76 1984; add 2014 2015; mul 79 1975; mul 45 2006; add 2017 2018; sub 2016 2019; mul 79 2020; add 2013
2021; add 2012 2022; mul 1063 2023; sub 1988 2024; mul 753 2025; sub 114 107; add 1107 2027; input p 191; mul 35
150; mul 157 2030; add 2029 2031; mul 35 2030; mul 161 2033; add 2032 2034; mul 150 1118; mul 165 2036; add 2035
2037; mul 35 2036; mul 169 2039; add 2038 2040; mul 155 2036; mul 150 166; add 2042 2043; mul 173 2044; add 2041
2045; mul 148 150; mul 188 2047; add 2046 2048; mul 35 2047; mul 192 2050; add 2049 2051; mul 155 2047; mul 150 189;
add 2053 2054; mul 196 2055; add 2052 2056; mul 150 201; mul 200 2058; add 2057 2059; input p 192; mul 224 2030; add
2061 2062; mul 227 2033; add 2063 2064; mul 230 2036; add 2065 2066; mul 233 2039; add 2067 2068; mul 236 2044; add
2069 2070; mul 245 2047; add 2071 2072; mul 248 2050; add 2073 2074; mul 251 2055; add 2075 2076; mul 196 2058; add
2077 2078; mul 147 2079; add 2060 2080; mul 145 2081; le 281 279; le 279 281; add 2083 2084; div 2 2085; mul 2083
2086; le 280 3; le 3 280; add 2088 2089; div 2 2090; mul 2088 2091; mul 2087 2092; mul 275 2093; mul 278 2094; mul
282 459; mul 2093 2096; mul 294 2097; add 2095 2098; mul 290 2093; mul 298 2100; add 2099 2101; mul 306 2102; mul
276 2093; mul 311 2104; mul 282 2094; mul 283 2093; add 2106 2107; mul 319 2108; add 2105 2109; mul 290 2094; mul
323 2111; add 2110 2112; mul 282 2097; mul 295 2093; add 2114 2115; mul 331 2116; add 2113 2117; mul 290 2097; mul
335 2119; add 2118 2120; mul 290 2100; mul 339 2122; add 2121 2123; add 2103 2124; mul 145 2125; where 271 2126; add
2082 2127; input p 193; mul 352 2033; mul 354 2044; add 2130 2131; mul 360 2050; add 2132 2133; mul 363 2055; add
2134 2135; mul 366 2058; add 2136 2137; mul 374 2033; mul 377 2039; add 2139 2140; mul 380 2044; add 2141 2142; mul
385 2055; add 2143 2144; mul 363 2058; add 2145 2146; mul 147 2147; add 2138 2148; mul 350 2149; add 2129 2150; mul
641 2151; mul 438 1945; mul 435 1962; add 2153 2154; mul 1306 2155; add 32 37; add 30 2157; add 36 2158; mul 104
2159; mul 148 2138; mul 155 2147; add 530 2162; add 2161 2163; mul 414 2033; mul 374 2039; add 2165 2166; mul 419
2044; add 2167 2168; mul 422 2050; add 2169 2170; mul 388 2058; add 2171 2172; mul 35 2173; add 2164 2174; mul 408
2175; mul 350 2176; add 2160 2177; mul 435 1945; add 2178 2179; mul 438 1962; sub 2180 2181; mul 1277 2182; add 2156
2183; mul 1309 2184; mul 441 2185; mul 459 2186; mul 1315 2186; mul 455 2188; mul 1313 2189; neg 2190; mul 459 2191;
mul 455 2192; mul 461 2190; sub 2193 2194; sub 2187 2195; mul 458 2196; mul 476 2197; mul 1336 2186; mul 1331 2199;
mul 472 2200; mul 470 2201; mul 474 2200; add 2202 2203; mul 464 2204; add 2198 2205; mul 481 2186; mul 468 2207;
mul 483 2186; add 2208 2209; mul 479 2210; sub 2206 2211; mul 441 2212; mul 506 2186; mul 468 2214; mul 508 2186;
add 2215 2216; mul 504 2217; mul 502 2188; mul 454 2219; mul 503 2188; add 2220 2221; mul 454 2222; mul 1362 2188;
add 2223 2224; mul 441 2225; mul 510 2226; sub 2218 2227; mul 499 2228; add 2213 2229; mul 514 2228; mul 511 2231;
mul 515 2228; add 2232 2233; mul 543 2234; mul 517 2155; sub 2179 2181; mul 447 2237; add 2236 2238; mul 519 2182;
mul 440 2155; add 2240 2241; sub 2239 2242; mul 456 2243; mul 441 2190; mul 521 2245; sub 2244 2246; mul 17 2247;
mul 522 1955; sub 2248 2249; mul 130 2250; mul 456 2155; mul 447 2245; sub 2252 2253; mul 0 2254; sub 2251 2255; mul
456 2182; mul 440 2245; sub 2257 2258; mul 541 2259; mul 528 2151; mul 150 2147; mul 350 2262; add 31 2263; mul 130
2264; add 2261 2265; mul 153 2147; add 2173 2267; mul 350 2268; add 34 2269; mul 539 2270; add 2266 2271; mul 457
2272; add 2260 2273; add 2256 2274; mul 516 2275; add 2235 2276; add 2230 2277; mul 457 2278; mul 545 2259; add 2279
2280; mul 549 1962; mul 552 1945; sub 2282 2283; mul 1414 2284; mul 549 1945; add 2178 2286; mul 552 1962; add 2287
2288; mul 1412 2289; add 2285 2290; mul 1417 2291; mul 555 2292; mul 459 2293; mul 1423 2293; mul 569 2295; mul 1421
2296; neg 2297; mul 459 2298; mul 569 2299; mul 574 2297; sub 2300 2301; sub 2294 2302; mul 572 2303; mul 586 2304;
mul 1444 2293; mul 1439 2306; mul 582 2307; mul 580 2308; mul 584 2307; add 2309 2310; mul 577 2311; add 2305 2312;
mul 591 2293; mul 578 2314; mul 593 2293; add 2315 2316; mul 589 2317; sub 2313 2318; mul 555 2319; mul 506 2293;
mul 578 2321; mul 615 2293; add 2322 2323; mul 613 2324; mul 611 2295; mul 568 2326; mul 612 2295; add 2327 2328;
mul 568 2329; mul 1470 2295; add 2330 2331; mul 555 2332; mul 617 2333; sub 2325 2334; mul 609 2335; add 2320 2336;
mul 621 2335; mul 618 2338; mul 622 2335; add 2339 2340; mul 636 2341; mul 624 2284; add 2286 2288; mul 561 2344;
add 2343 2345; mul 626 2289; sub 2283 2282; mul 554 2348; add 2347 2349; add 2346 2350; mul 570 2351; mul 555 2297;
mul 628 2353; sub 2352 2354; mul 17 2355; mul 629 1955; sub 2356 2357; mul 130 2358; mul 570 2284; mul 561 2353; sub
2360 2361; mul 0 2362; sub 2359 2363; mul 570 2289; mul 554 2353; sub 2365 2366; mul 541 2367; mul 571 2272; add
2368 2369; add 2364 2370; mul 623 2371; add 2342 2372; add 2337 2373; mul 571 2374; mul 638 2367; add 2375 2376; add
2281 2377; mul 399 2378; sub 2152 2379; sub 2128 2380; mul 144 2381; mul 525 2278; mul 545 2254; add 2383 2384; mul
632 2374; mul 638 2362; add 2386 2387; add 2385 2388; sub 2382 2389; sub 2028 2390; mul 742 1962; mul 16 1943; mul
16 738; mul 1953 2394; sub 2393 2395; mul 10 2396; mul 738 2397; mul 739 2396; add 2398 2399; mul 737 1943; mul 9
2401; mul 9 737; mul 1943 2403; add 2402 2404; sub 2400 2405; mul 3 2406; add 741 2407; mul 38 2408; add 2392 2409;
sub 1957 2410; mul 734 2411; mul 130 1955; mul 130 2413; mul 23 2414; mul 744 2415; sub 2412 2416; mul 67 2417; add
1570 2418; mul 742 1945; mul 24 2408; add 2420 2421; add 1965 2422; mul 734 2423; mul 749 2415; sub 2424 2425; sub
2419 2426; mul 22 2427; sub 2391 2428; mul 90 2429; add 2026 2430; mul 89 2009; mul 1530 2023; sub 2432 2433; mul
831 2434; mul 817 1962; mul 17 2436; mul 818 1955; sub 2437 2438; mul 150 2079; mul 145 2440; mul 762 2094; mul 767
2097; add 2442 2443; mul 770 2100; add 2444 2445; mul 306 2446; mul 319 2104; mul 784 2108; add 2448 2449; mul 787
2111; add 2450 2451; mul 792 2116; add 2452 2453; mul 795 2119; add 2454 2455; mul 798 2122; add 2456 2457; add 2447
2458; mul 145 2459; where 759 2460; add 2441 2461; mul 641 2264; mul 532 2378; sub 2463 2464; sub 2462 2465; mul 523
2278; mul 545 2250; add 2467 2468; mul 630 2374; mul 638 2358; add 2470 2471; add 2469 2472; add 2466 2473; add 118
2474; sub 2439 2475; mul 746 1967; mul 41 2417; add 2477 2478; mul 750 1958; mul 26 2426; add 2480 2481; sub 2479
2482; mul 22 2483; mul 19 2408; mul 742 1971; sub 2485 2486; mul 733 2487; mul 828 2414; sub 2488 2489; sub 2484
2490; sub 2476 2491; mul 755 2492; add 2435 2493; sub 2431 2494; mul 89 2020; mul 1577 2023; sub 2496 2497; mul 959
2498; input p 194; mul 845 2030; add 2500 2501; mul 848 2033; add 2502 2503; mul 851 2036; add 2504 2505; mul 227
2039; add 2506 2507; mul 856 2044; add 2508 2509; mul 157 2047; add 2510 2511; mul 861 2050; add 2512 2513; mul 169
2055; add 2514 2515; mul 257 2058; add 2516 2517; mul 153 2079; add 2518 2519; mul 145 2520; mul 298 2094; mul 885
2097; add 2522 2523; mul 888 2100; add 2524 2525; mul 306 2526; mul 781 2104; mul 335 2108; add 2528 2529; mul 903
2111; add 2530 2531; mul 909 2116; add 2532 2533; mul 798 2119; add 2534 2535; mul 914 2122; add 2536 2537; add 2527
2538; mul 760 2104; mul 294 2108; add 2540 2541; mul 298 2111; add 2542 2543; mul 935 2116; add 2544 2545; mul 885
2119; add 2546 2547; mul 773 2122; add 2548 2549; mul 922 2550; add 2539 2551; mul 145 2552; where 877 2553; add
2521 2554; mul 641 2270; mul 538 2378; sub 2556 2557; sub 2555 2558; mul 34 746; mul 53 2417; add 2560 2561; mul 22
2562; add 2559 2563; mul 834 2564; add 2499 2565; sub 2495 2566; mul 56 1990; mul 70 1978; add 2568 2569; mul 79
2006; add 2571 2571; sub 2570 2572; mul 89 2573; mul 1723 2023; sub 2574 2575; mul 831 2576; mul 965 2492; add 2577
2578; mul 753 2434; mul 755 2429; add 2580 2581; sub 2579 2582; mul 59 1990; mul 70 1984; add 2584 2585; mul 76
2006; mul 79 1998; add 2587 2588; sub 2586 2589; mul 89 2590; mul 1741 2023; sub 2591 2592; mul 959 2593; mul 972
2564; add 2594 2595; add 2583 2596; mul 753 2498; mul 834 2429; add 2598 2599; mul 831 2593; mul 972 2492; add 2601
2602; sub 2600 2603; mul 45 1990; mul 70 1975; add 2605 2606; mul 76 1998; add 2608 2608; sub 2607 2609; mul 89
2610; mul 1804 2023; sub 2611 2612; mul 959 2613; mul 981 2564; add 2614 2615; sub 2604 2616; mul 543 2228; mul 511
2275; add 2618 2619; mul 636 2335; mul 618 2371; add 2621 2622; mul 457 532; add 523 2624; mul 516 2625; mul 457
2626; mul 532 571; add 630 2628; mul 623 2629; mul 571 2630; add 2627 2631; mul 399 2632; input p 195; add 2633
2634; mul 144 2635; mul 525 2626; mul 632 2630; add 2637 2638; sub 2636 2639; sub 1859 2640; add 719 722; add 718
2642; add 721 2643; mul 459 732; mul 23 2645; mul 744 2646; add 2644 2647; mul 67 2648; mul 749 2646; sub 2649 2650;
mul 22 2651; sub 2641 2652; mul 90 2653; mul 532 2632; input p 196; add 2655 2656; mul 523 2626; mul 630 2630; add
2658 2659; add 2657 2660; add 129 2661; mul 41 2648; mul 26 2650; sub 2663 2664; mul 22 2665; mul 828 2645; sub 2666
2667; add 2662 2668; mul 755 2669; add 2654 2670; mul 538 2632; input p 197; add 2672 2673; mul 53 2648; mul 22
2675; add 2674 2676; mul 834 2677; sub 2671 2678; mul 972 2677; mul 965 2669; mul 755 2653; add 2681 2682; sub 2680
2683; mul 834 2653; mul 972 2669; add 2685 2686; mul 981 2677; sub 2687 2688; mul 511 2625; mul 618 2629; input p
198; where 1015 2692; input p 199; where 1024 2694; input p 200; where 1033 2696; input p 201; where 1042 2698; mul
34 1046; mul 22 2700; mul 56 2701; mul 51 1050; mul 22 2703; mul 45 2704; add 2702 2705; mul 34 53; mul 41 51; add
2707 2708; mul 22 2709; mul 59 2710; add 2711 2711; sub 2706 2712; mul 89 2713; mul 47 1064; mul 22 2715; mul 61
2716; mul 70 2713; add 2717 2718; add 1056 2004; mul 22 2720; mul 81 2721; mul 56 2721; mul 76 2704; add 2723 2724;
mul 79 2710; mul 51 67; mul 47 53; add 2727 2728; mul 22 2729; mul 59 2730; add 2726 2731; sub 2725 2732; mul 76
2733; add 2722 2734; sub 2719 2735; mul 86 2730; mul 59 2721; mul 76 2710; add 2738 2739; mul 79 2701; mul 45 2730;
add 2741 2742; sub 2740 2743; mul 79 2744; add 2737 2745; add 2736 2746; mul 1063 2747; sub 2714 2748; mul 753 2749;
input p 202; add 154 155; mul 157 2752; add 2751 2753; mul 35 2752; add 158 2755; mul 161 2756; add 2754 2757; mul
153 1118; mul 165 2759; add 2758 2760; mul 35 2759; add 166 2762; mul 169 2763; add 2761 2764; mul 155 2759; mul 153
166; add 2766 2767; mul 173 2768; add 2765 2769; mul 148 180; add 2770 2771; mul 181 459; mul 184 2773; add 2772
2774; mul 148 153; mul 188 2776; add 2775 2777; mul 35 2776; add 189 2779; mul 192 2780; add 2778 2781; mul 155
2776; mul 153 189; add 2783 2784; mul 196 2785; add 2782 2786; mul 153 201; mul 200 2788; add 2787 2789; mul 35 459;
mul 213 2791; add 210 2792; mul 35 2791; add 214 2794; mul 217 2795; add 2793 2796; input p 203; add 2797 2798; mul
224 2752; add 2799 2800; mul 227 2756; add 2801 2802; mul 230 2759; add 2803 2804; mul 233 2763; add 2805 2806; mul
236 2768; add 2807 2808; mul 148 157; add 2809 2810; mul 161 2773; add 2811 2812; mul 245 2776; add 2813 2814; mul
248 2780; add 2815 2816; mul 251 2785; add 2817 2818; mul 201 257; add 2819 2820; mul 196 2788; add 2821 2822; mul
147 2823; add 2790 2824; mul 145 2825; le 289 287; le 287 289; add 2827 2828; div 2 2829; mul 2827 2830; le 288 35;
le 35 288; add 2832 2833; div 2 2834; mul 2832 2835; mul 2831 2836; mul 275 2837; mul 286 2838; mul 282 2837; mul
298 2840; add 2839 2841; mul 290 459; mul 2837 2843; mul 302 2844; add 2842 2845; mul 306 2846; mul 290 2844; mul
303 2837; add 2848 2849; mul 305 2850; add 2847 2851; mul 276 2837; mul 315 2853; mul 283 2837; mul 323 2855; add
2854 2856; mul 290 2838; mul 291 2837; add 2858 2859; mul 327 2860; add 2857 2861; mul 295 2837; mul 335 2863; add
2862 2864; mul 290 2840; mul 299 2837; add 2866 2867; mul 339 2868; add 2865 2869; mul 343 2850; add 2870 2871; add
2852 2872; mul 145 2873; where 271 2874; add 2826 2875; input p 204; mul 352 2756; mul 354 2768; add 2878 2879; mul
357 2773; add 2880 2881; mul 360 2780; add 2882 2883; mul 363 2785; add 2884 2885; mul 366 2788; add 2886 2887; mul
372 2795; mul 374 2756; add 2889 2890; mul 377 2763; add 2891 2892; mul 380 2768; add 2893 2894; mul 352 2773; add
2895 2896; mul 385 2785; add 2897 2898; mul 201 388; add 2899 2900; mul 363 2788; add 2901 2902; mul 147 2903; add
2888 2904; mul 350 2905; add 2877 2906; mul 641 2907; add 52 53; add 50 2909; mul 104 2910; mul 148 2888; mul 155
2903; add 535 2913; add 2912 2914; mul 412 2795; mul 414 2756; add 2916 2917; mul 374 2763; add 2918 2919; mul 419
2768; add 2920 2921; mul 422 2780; add 2922 2923; mul 201 357; add 2924 2925; mul 388 2788; add 2926 2927; mul 35
2928; add 428 2929; add 2915 2930; mul 408 2931; mul 350 2932; add 2911 2933; mul 1277 2934; mul 1309 2935; mul 441
2936; mul 459 2937; mul 1315 2937; mul 455 2939; mul 1313 2940; neg 2941; mul 459 2942; mul 455 2943; mul 461 2941;
sub 2944 2945; sub 2938 2946; mul 458 2947; mul 476 2948; mul 1336 2937; mul 1331 2950; mul 472 2951; mul 470 2952;
mul 474 2951; add 2953 2954; mul 464 2955; add 2949 2956; mul 481 2937; mul 468 2958; mul 483 2937; add 2959 2960;
mul 479 2961; sub 2957 2962; mul 441 2963; mul 506 2937; mul 468 2965; mul 508 2937; add 2966 2967; mul 504 2968;
mul 502 2939; mul 454 2970; mul 503 2939; add 2971 2972; mul 454 2973; mul 1362 2939; add 2974 2975; mul 441 2976;
mul 510 2977; sub 2969 2978; mul 499 2979; add 2964 2980; mul 514 2979; mul 511 2982; mul 515 2979; add 2983 2984;
mul 543 2985; mul 441 2941; mul 447 2987; mul 0 2988; mul 519 2934; mul 456 2990; mul 521 2987; add 2991 2992; mul
17 2993; mul 130 2994; sub 2989 2995; mul 456 2934; mul 440 2987; sub 2997 2998; mul 541 2999; mul 528 2907; mul 150
2903; mul 350 3002; add 34 3003; mul 130 3004; add 3001 3005; mul 153 2903; add 2928 3007; mul 350 3008; add 51
3009; mul 539 3010; add 3006 3011; mul 457 3012; add 3000 3013; add 2996 3014; mul 516 3015; add 2986 3016; add 2981
3017; mul 457 3018; mul 545 2999; add 3019 3020; mul 1412 2934; mul 1417 3022; mul 555 3023; mul 459 3024; mul 1423
3024; mul 569 3026; mul 1421 3027; neg 3028; mul 459 3029; mul 569 3030; mul 574 3028; sub 3031 3032; sub 3025 3033;
mul 572 3034; mul 586 3035; mul 1444 3024; mul 1439 3037; mul 582 3038; mul 580 3039; mul 584 3038; add 3040 3041;
mul 577 3042; add 3036 3043; mul 591 3024; mul 578 3045; mul 593 3024; add 3046 3047; mul 589 3048; sub 3044 3049;
mul 555 3050; mul 506 3024; mul 578 3052; mul 615 3024; add 3053 3054; mul 613 3055; mul 611 3026; mul 568 3057; mul
612 3026; add 3058 3059; mul 568 3060; mul 1470 3026; add 3061 3062; mul 555 3063; mul 617 3064; sub 3056 3065; mul
609 3066; add 3051 3067; mul 621 3066; mul 618 3069; mul 622 3066; add 3070 3071; mul 636 3072; mul 626 2934; mul
570 3074; mul 555 3028; mul 628 3076; sub 3075 3077; mul 17 3078; mul 130 3079; mul 561 3076; mul 0 3081; add 3080
3082; mul 570 2934; mul 554 3076; sub 3084 3085; mul 541 3086; mul 571 3012; add 3087 3088; add 3083 3089; mul 623
3090; add 3073 3091; add 3068 3092; mul 571 3093; mul 638 3086; add 3094 3095; add 3021 3096; mul 399 3097; sub 2908
3098; sub 2876 3099; mul 144 3100; mul 525 3018; mul 545 2988; sub 3102 3103; mul 632 3093; mul 638 3081; sub 3105
3106; add 3104 3107; sub 3101 3108; add 1646 3109; mul 90 3110; sub 2750 3111; mul 89 2733; mul 1530 2747; sub 3113
3114; mul 831 3115; mul 150 2823; mul 145 3117; mul 298 2838; mul 770 2840; add 3119 3120; mul 773 2844; add 3121
3122; mul 306 3123; mul 775 2850; add 3124 3125; mul 781 2853; mul 787 2855; add 3127 3128; mul 339 2860; add 3129
3130; mul 795 2863; add 3131 3132; mul 798 2868; add 3133 3134; mul 801 2850; add 3135 3136; add 3126 3137; mul 145
3138; where 759 3139; add 3118 3140; mul 641 3004; mul 532 3097; sub 3142 3143; sub 3141 3144; mul 523 3018; mul 545
2994; sub 3146 3147; mul 630 3093; mul 638 3079; add 3149 3150; add 3148 3151; add 3145 3152; mul 22 2560; add 3153
3154; mul 755 3155; sub 3116 3156; sub 3112 3157; mul 89 2744; mul 1577 2747; sub 3159 3160; mul 959 3161; mul 837
2791; add 835 3163; mul 840 2795; add 3164 3165; input p 205; add 3166 3167; mul 845 2752; add 3168 3169; mul 848
2756; add 3170 3171; mul 851 2759; add 3172 3173; mul 227 2763; add 3174 3175; mul 856 2768; add 3176 3177; mul 157
2776; add 3178 3179; mul 861 2780; add 3180 3181; mul 169 2785; add 3182 3183; mul 184 201; add 3184 3185; mul 257
2788; add 3186 3187; mul 153 2823; add 3188 3189; mul 145 3190; mul 882 2838; mul 888 2840; add 3192 3193; mul 891
2844; add 3194 3195; mul 306 3196; mul 893 2850; add 3197 3198; mul 327 2853; mul 903 2855; add 3200 3201; mul 906
2860; add 3202 3203; mul 798 2863; add 3204 3205; mul 914 2868; add 3206 3207; mul 917 2850; add 3208 3209; add 3199
3210; mul 921 2844; mul 944 3212; mul 878 2853; mul 298 2855; add 3214 3215; mul 302 2860; add 3216 3217; mul 885
2863; add 3218 3219; mul 773 2868; add 3220 3221; mul 942 2850; add 3222 3223; mul 922 3224; add 3213 3225; add 3211
3226; mul 145 3227; where 877 3228; add 3191 3229; mul 641 3010; mul 538 3097; sub 3231 3232; sub 3230 3233; mul 51
746; mul 22 3235; add 3234 3236; mul 834 3237; add 3162 3238; sub 3158 3239; mul 56 2716; mul 70 2704; add 3241
3242; mul 79 2730; add 3244 3244; sub 3243 3245; mul 89 3246; mul 1723 2747; sub 3247 3248; mul 831 3249; mul 965
3155; sub 3250 3251; mul 753 3115; mul 755 3110; sub 3253 3254; sub 3252 3255; mul 59 2716; mul 70 2710; add 3257
3258; mul 76 2730; mul 79 2721; add 3260 3261; sub 3259 3262; mul 89 3263; mul 1741 2747; sub 3264 3265; mul 959
3266; mul 972 3237; add 3267 3268; add 3256 3269; mul 753 3161; mul 834 3110; sub 3271 3272; mul 831 3266; mul 972
3155; sub 3274 3275; sub 3273 3276; mul 45 2716; mul 70 2701; add 3278 3279; mul 76 2721; add 3281 3281; sub 3280
3282; mul 89 3283; mul 1804 2747; sub 3284 3285; mul 959 3286; mul 981 3237; add 3287 3288; sub 3277 3289; mul 543
2979; mul 511 3015; add 3291 3292; mul 636 3066; mul 618 3090; add 3294 3295; mul 457 538; mul 516 3297; mul 457
3298; mul 538 571; mul 623 3300; mul 571 3301; add 3299 3302; mul 532 3303; input p 206; add 3304 3305; mul 523
3298; mul 630 3301; add 3307 3308; add 3306 3309; add 728 729; add 727 3311; mul 41 3312; mul 22 3313; add 3310
3314; mul 755 3315; mul 399 3303; input p 207; add 3317 3318; mul 144 3319; mul 525 3298; mul 632 3301; add 3321
3322; sub 3320 3323; mul 67 3312; mul 22 3325; add 3324 3326; mul 90 3327; sub 3316 3328; mul 538 3303; input p 208;
add 3330 3331; mul 53 3312; mul 22 3333; add 3332 3334; mul 834 3335; sub 3329 3336; mul 755 3327; mul 965 3315; sub
3338 3339; mul 972 3335; add 3340 3341; mul 972 3315; mul 834 3327; sub 3343 3344; mul 981 3335; sub 3345 3346; mul
511 3297; mul 618 3300; mul 489 511; mul 457 3350; mul 532 3351; mul 523 3350; add 3352 3353; mul 755 3354; mul 399
3351; mul 144 3356; mul 525 3350; sub 3357 3358; mul 90 3359; sub 3355 3360; mul 538 3351; mul 834 3362; sub 3361
3363; mul 755 3359; mul 965 3354; sub 3365 3366; mul 972 3362; add 3367 3368; mul 972 3354; mul 834 3359; sub 3370
3371; mul 981 3362; sub 3372 3373; input p 209; mul 599 618; mul 571 3376; mul 532 3377; mul 630 3376; add 3378
3379; mul 755 3380; mul 399 3377; mul 144 3382; mul 632 3376; sub 3383 3384; mul 90 3385; sub 3381 3386; mul 538
3377; mul 834 3388; sub 3387 3389; mul 755 3385; mul 965 3380; sub 3391 3392; mul 972 3388; add 3393 3394; mul 972
3380; mul 834 3385; sub 3396 3397; mul 981 3388; sub 3398 3399; mul 492 511; mul 457 3401; mul 532 3402; mul 523
3401; add 3403 3404; mul 755 3405; mul 399 3402; mul 144 3407; mul 525 3401; sub 3408 3409; mul 90 3410; sub 3406
3411; mul 538 3402; mul 834 3413; sub 3412 3414; mul 755 3410; mul 965 3405; sub 3416 3417; mul 972 3413; add 3418
3419; mul 972 3405; mul 834 3410; sub 3421 3422; mul 981 3413; sub 3423 3424; input p 210; mul 602 618; mul 571
3427; mul 532 3428; mul 630 3427; add 3429 3430; mul 755 3431; mul 399 3428; mul 144 3433; mul 632 3427; sub 3434
3435; mul 90 3436; sub 3432 3437; mul 538 3428; mul 834 3439; sub 3438 3440; mul 755 3436; mul 965 3431; sub 3442
3443; mul 972 3439; add 3444 3445; mul 972 3431; mul 834 3436; sub 3447 3448; mul 981 3439; sub 3449 3450; mul 496
511; mul 457 3452; mul 532 3453; mul 523 3452; add 3454 3455; mul 755 3456; mul 399 3453; mul 144 3458; mul 525
3452; sub 3459 3460; mul 90 3461; sub 3457 3462; mul 538 3453; mul 834 3464; sub 3463 3465; mul 755 3461; mul 965
3456; sub 3467 3468; mul 972 3464; add 3469 3470; mul 972 3456; mul 834 3461; sub 3472 3473; mul 981 3464; sub 3474
3475; input p 211; mul 606 618; mul 571 3478; mul 532 3479; mul 630 3478; add 3480 3481; mul 755 3482; mul 399 3479;
mul 144 3484; mul 632 3478; sub 3485 3486; mul 90 3487; sub 3483 3488; mul 538 3479; mul 834 3490; sub 3489 3491;
mul 755 3487; mul 965 3482; sub 3493 3494; mul 972 3490; add 3495 3496; mul 972 3482; mul 834 3487; sub 3498 3499;
mul 981 3490; sub 3500 3501; mul 90 702; mul 702 755; neg 3504; mul 702 834; input p 212; mul 90 706; mul 706 755;
neg 3509; mul 706 834; input p 213; input p 214; mul 755 3513; mul 90 671; sub 3514 3515; mul 671 755; mul 965 3513;
sub 3517 3518; mul 972 3513; mul 671 834; sub 3520 3521; input p 215; mul 755 3523; mul 90 674; sub 3524 3525; mul
674 755; mul 965 3523; sub 3527 3528; mul 972 3523; mul 674 834; sub 3530 3531; input p 216; mul 755 3533; mul 90
678; sub 3534 3535; mul 678 755; mul 965 3533; sub 3537 3538; mul 972 3533; mul 678 834; sub 3540 3541; input p 217;
mul 755 3543; mul 90 682; sub 3544 3545; mul 682 755; mul 965 3543; sub 3547 3548; mul 972 3543; mul 682 834; sub
3550 3551; mul 102 109; add 92 3553; mul 100 121; sub 3554 3555; mul 478 485; mul 441 3557; mul 525 3558; mul 457
3558; mul 399 3560; mul 144 3561; sub 3559 3562; sub 3556 3563; mul 90 3564; mul 532 3560; mul 523 3558; add 3566
3567; add 121 3568; mul 755 3569; sub 3565 3570; mul 538 3560; mul 834 3572; add 3571 3573; mul 965 3569; mul 755
3564; sub 3575 3576; mul 972 3572; sub 3577 3578; mul 834 3564; mul 972 3569; sub 3580 3581; mul 981 3572; add 3582
3583; mul 102 112; add 96 3585; mul 100 124; sub 3586 3587; mul 588 595; mul 555 3589; mul 632 3590; mul 571 3590;
mul 399 3592; mul 144 3593; sub 3591 3594; sub 3588 3595; mul 90 3596; mul 532 3592; mul 630 3590; add 3598 3599;
add 124 3600; mul 755 3601; sub 3597 3602; mul 538 3592; mul 834 3604; add 3603 3605; mul 965 3601; mul 755 3596;
sub 3607 3608; mul 972 3604; sub 3609 3610; mul 834 3596; mul 972 3601; sub 3612 3613; mul 981 3604; add 3614 3615;
neg 755; neg 1659; neg 1813; neg 1753; neg 1756; neg 1672; neg 1823; neg 1763; neg 1680; neg 1829; neg 1684; neg
1832; neg 1773; neg 1776; neg 1703; neg 1843; neg 1783; neg 1786; store f 0 0; store f 1 961; store f 2 130; store f
3 974; store f 4 539; store f 5 983; store f 6 987; store f 7 990; store f 8 993; store f 9 995; store f 10 998;
store f 11 1000; store f 12 1002; store f 13 1004; store f 14 1018; store f 15 1027; store f 16 1036; store f 17
1045; store a 18 1715; store a 54 1789; store a 90 1852; store a 108 1855; store a 126 1858; store a 144 1855; store
a 162 1858; store a 180 1855; store a 198 1858; store a 216 1001; store a 234 1003; store a 1 2; store a 19 1920;
store a 55 1925; store a 91 1931; store a 109 1932; store a 127 1933; store a 145 1932; store a 163 1933; store a
181 1932; store a 199 1933; store a 253 1934; store a 271 1935; store a 289 1936; store a 307 1937; store a 20 2567;
store a 56 2597; store a 92 2617; store a 110 2620; store a 128 2623; store a 146 2620; store a 164 2623; store a
182 2620; store a 200 2623; store a 21 2679; store a 39 2; store a 57 2684; store a 93 2689; store a 111 2690; store
a 129 2691; store a 147 2690; store a 165 2691; store a 183 2690; store a 201 2691; store a 255 2693; store a 273
2695; store a 291 2697; store a 309 2699; store a 22 3240; store a 58 3270; store a 94 3290; store a 112 3293; store
a 130 3296; store a 148 3293; store a 166 3296; store a 184 3293; store a 202 3296; store a 23 3337; store a 59
3342; store a 77 2; store a 95 3347; store a 113 3348; store a 131 3349; store a 149 3348; store a 167 3349; store a
185 3348; store a 203 3349; store a 24 3364; store a 60 3369; store a 96 3374; store a 114 3375; store a 25 3390;
store a 61 3395; store a 97 3400; store a 133 3375; store a 26 3415; store a 62 3420; store a 98 3425; store a 152
3426; store a 27 3441; store a 63 3446; store a 99 3451; store a 171 3426; store a 28 3466; store a 64 3471; store a
100 3476; store a 190 3477; store a 29 3492; store a 65 3497; store a 101 3502; store a 209 3477; store a 30 3503;
store a 66 3505; store a 102 3506; store a 228 3507; store a 31 3508; store a 67 3510; store a 103 3511; store a 247
3512; store a 32 3516; store a 68 3519; store a 104 3522; store a 33 3526; store a 69 3529; store a 105 3532; store
a 34 3536; store a 70 3539; store a 106 3542; store a 35 3546; store a 71 3549; store a 107 3552; store b 2 3574;
store b 6 3579; store b 10 3584; store b 3 3606; store b 7 3611; store b 11 3616; store by_c 13 90; store by_c 39
3617; store by_c 65 834; store by_c 14 3618; store by_c 40 1749; store by_c 66 3619; store by_c 15 1663; store by_c
41 3620; store by_c 67 1816; store by_c 16 1667; store by_c 42 3621; store by_c 68 1819; store by_c 17 3622; store
by_c 43 1760; store by_c 69 3623; store by_c 18 1676; store by_c 44 3624; store by_c 70 1826; store by_c 19 3625;
store by_c 45 1766; store by_c 71 3626; store by_c 20 3627; store by_c 46 1769; store by_c 72 3628; store by_c 21
1694; store by_c 47 3629; store by_c 73 1836; store by_c 22 1698; store by_c 48 3630; store by_c 74 1839; store by_c
23 3631; store by_c 49 1780; store by_c 75 3632; store by_c 24 1707; store by_c 50 3633; store by_c 76 1846; store
by_c 25 1711; store by_c 51 3634; store by_c 77 1849
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
1.6; constant -1.6; max 234 34; min 233 235; mul 221 236; mul 232 237; add 231 238; input p 55; mul 228 228; mul 240
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
add 395 396; sqrt 397; mul 388 398; sqrt 399; div 1 400; mul 401 401; mul 388 402; mul 387 403; input p 93; constant
2.0; mul 399 406; mul 402 406; mul 402 408; sub 407 409; mul 405 410; constant 0.3; constant -0.3; constant 1.4; sub
399 414; max 413 415; min 412 416; input p 94; input p 95; mul 417 419; add 418 420; mul 417 421; add 1 422; mul 411
423; input u 0; input p 96; mul 425 426; input p 97; input p 98; mul 415 429; add 428 430; mul 415 431; add 1 432;
mul 427 433; sub 424 434; mul 388 435; input p 99; input x 6; mul 437 438; input p 100; input x 8; mul 440 441; add
439 442; input p 101; input x 10; mul 444 445; add 443 446; constant -0.5; mul 401 448; mul 401 449; mul 401 450;
mul 388 451; input p 102; input p 103; mul 415 454; add 453 455; mul 415 456; add 1 457; mul 452 458; mul 447 459;
add 436 460; input p 104; mul 459 462; mul 459 463; input x 3; sub 383 386; mul 394 466; add 389 392; mul 387 468;
sub 467 469; mul 403 470; mul 16 471; mul 465 472; input x 1; mul 394 403; mul 474 475; sub 473 476; mul 90 474; mul
345 478; mul 96 341; mul 296 480; add 36 481; mul 465 482; add 479 483; mul 99 341; add 375 485; mul 296 486; add 52
487; input x 5; mul 488 489; add 484 490; mul 404 491; add 477 492; mul 464 493; add 461 494; mul 404 495; input p
105; add 380 497; input p 106; mul 23 499; add 498 500; input p 107; mul 37 502; add 501 503; input p 108; mul 37
499; mul 23 502; input p 109; sub 507 508; sub 506 509; sub 510 28; mul 511 511; mul 504 504; add 512 513; sqrt 514;
mul 505 515; sqrt 516; div 1 517; mul 518 518; mul 505 519; mul 504 520; input p 110; mul 406 516; mul 406 519; mul
519 524; sub 523 525; mul 522 526; sub 516 414; max 413 528; min 412 529; input p 111; input p 112; mul 530 532; add
531 533; mul 530 534; add 1 535; mul 527 536; input u 1; input p 113; mul 538 539; input p 114; input p 115; mul 528
542; add 541 543; mul 528 544; add 1 545; mul 540 546; sub 537 547; mul 505 548; input p 116; input x 7; mul 550
551; input p 117; input x 9; mul 553 554; add 552 555; input p 118; input x 11; mul 557 558; add 556 559; mul 448
518; mul 518 561; mul 518 562; mul 505 563; mul 454 528; add 453 565; mul 528 566; add 1 567; mul 564 568; mul 560
569; add 549 570; input p 119; mul 569 572; mul 569 573; add 500 503; mul 511 575; sub 507 506; mul 504 577; add 576
578; mul 520 579; mul 16 580; mul 465 581; mul 511 520; mul 474 583; sub 582 584; mul 491 521; add 585 586; mul 574
587; add 571 588; mul 521 589; add 496 590; sub 346 591; mul 345 592; sub 295 593; input p 120; constant 12.0; mul
478 596; constant -6.0; mul 93 478; mul 96 465; add 599 600; mul 99 489; add 601 602; mul 598 603; add 597 604; mul
595 605; mul 478 598; constant 4.0; mul 603 608; add 607 609; mul 595 610; mul 93 611; add 606 612; add 594 613; mul
90 614; mul 90 615; mul 89 616; mul 80 88; mul 581 618; mul 89 583; add 619 620; mul 85 88; mul 488 622; mul 482
618; sub 623 624; mul 89 90; mul 345 626; add 625 627; mul 521 628; sub 621 629; mul 574 630; mul 491 631; mul 589
628; sub 632 633; mul 520 634; mul 589 618; mul 465 631; add 636 637; mul 16 638; mul 520 639; mul 577 640; add 635
641; mul 406 504; mul 406 515; div 1 644; mul 587 630; mul 573 646; mul 569 646; mul 572 648; add 647 649; mul 560
630; add 650 651; mul 564 652; mul 566 653; mul 528 653; mul 454 655; add 654 656; mul 505 630; mul 540 658; mul 544
659; sub 657 660; mul 528 659; mul 542 662; sub 661 663; le 413 528; le 528 413; add 665 666; div 1 667; mul 665
668; le 529 412; le 412 529; add 670 671; div 1 672; mul 670 673; mul 527 658; mul 534 675; mul 530 675; mul 532
677; add 676 678; mul 674 679; mul 669 680; add 664 681; mul 406 517; div 1 683; mul 518 563; mul 568 652; mul 505
686; mul 685 687; mul 518 687; mul 563 689; add 688 690; mul 518 689; mul 562 692; add 691 693; mul 406 518; mul 504
634; mul 89 589; mul 474 631; sub 697 698; mul 511 699; add 696 700; mul 579 639; add 701 702; mul 505 703; mul 536
658; mul 522 705; mul 524 706; sub 704 707; mul 519 706; neg 709; mul 406 710; add 708 711; mul 695 712; mul 519
713; add 694 714; mul 684 715; sub 682 716; mul 406 706; add 717 718; mul 505 719; mul 645 720; mul 643 721; add 642
722; sub 617 723; mul 592 622; mul 521 631; mul 472 618; mul 89 475; add 727 728; mul 404 628; sub 729 730; mul 464
731; mul 404 732; add 726 733; mul 489 734; add 725 735; mul 486 736; add 724 737; mul 465 734; mul 592 618; sub 739
740; mul 480 741; add 738 742; mul 90 478; mul 96 618; mul 99 622; sub 745 746; mul 93 626; sub 747 748; mul 595
749; mul 598 750; mul 608 750; mul 595 626; mul 598 753; sub 752 754; mul 93 755; add 751 756; mul 596 753; sub 757
758; mul 345 734; add 759 760; mul 744 761; sub 743 762; mul 592 626; mul 478 734; add 764 765; mul 343 766; add 763
767; mul 66 766; add 768 769; mul 491 732; mul 495 628; sub 771 772; mul 403 773; mul 495 618; mul 465 732; add 775
776; mul 16 777; mul 403 778; mul 468 779; sub 774 780; mul 387 406; mul 398 406; div 1 783; mul 493 731; mul 463
785; mul 459 785; mul 462 787; add 786 788; mul 447 731; add 789 790; mul 452 791; mul 456 792; mul 415 792; mul 454
794; add 793 795; mul 388 731; mul 427 797; mul 431 798; sub 796 799; mul 415 798; mul 429 801; sub 800 802; le 413
415; le 415 413; add 804 805; div 1 806; mul 804 807; le 416 412; le 412 416; add 809 810; div 1 811; mul 809 812;
mul 411 797; mul 421 814; mul 417 814; mul 419 816; add 815 817; mul 813 818; mul 808 819; add 803 820; mul 400 406;
div 1 822; mul 401 451; mul 458 791; mul 388 825; mul 824 826; mul 401 826; mul 451 828; add 827 829; mul 401 828;
mul 450 831; add 830 832; mul 401 406; mul 387 773; mul 89 495; mul 474 732; sub 836 837; mul 394 838; add 835 839;
mul 470 778; add 840 841; mul 388 842; mul 423 797; mul 405 844; mul 408 845; sub 843 846; mul 402 845; neg 848; mul
406 849; add 847 850; mul 834 851; mul 402 852; add 833 853; mul 823 854; sub 821 855; mul 406 845; add 856 857; mul
388 858; mul 784 859; mul 782 860; add 781 861; add 723 862; mul 378 863; add 770 864; sub 865 862; mul 90 94; mul
94 406; mul 296 736; mul 296 863; mul 355 870; mul 34 871; add 869 872; mul 334 873; mul 101 874; mul 868 875; mul
91 622; mul 203 877; mul 101 878; mul 868 879; mul 130 877; mul 34 881; mul 868 882; add 880 883; input p 155; mul
877 885; mul 868 886; add 884 887; mul 115 877; mul 101 889; mul 101 890; add 888 891; input p 154; mul 877 893; mul
34 894; mul 101 895; add 892 896; mul 103 877; mul 101 898; add 897 899; sub 876 900; mul 303 873; mul 34 902; mul
868 903; add 901 904; mul 369 873; mul 34 906; mul 101 907; add 905 908; mul 99 869; mul 296 741; mul 96 911; add
910 912; mul 296 766; mul 93 914; add 913 915; mul 101 871; add 916 917; mul 339 918; mul 147 919; add 909 920; mul
94 919; mul 868 922; add 921 923; mul 309 918; mul 101 925; mul 868 926; add 924 927; mul 334 918; mul 34 929; mul
868 930; add 928 931; mul 331 918; mul 101 933; mul 101 934; add 932 935; mul 298 918; mul 34 937; mul 34 938; add
936 939; mul 317 871; add 940 941; mul 94 871; add 914 943; mul 315 944; mul 147 945; add 942 946; mul 94 945; mul
868 948; add 947 949; mul 312 944; mul 101 951; mul 868 952; add 950 953; mul 309 944; mul 101 955; mul 101 956; add
954 957; mul 306 944; mul 34 959; mul 101 960; add 958 961; mul 303 944; mul 34 963; mul 34 964; add 962 965; le 219
94; le 94 219; add 967 968; div 1 969; mul 967 970; le 220 216; le 216 220; add 972 973; div 1 974; mul 972 975; abs
34; lt 977 233; input p 167; constant 3.0; mul 249 980; mul 877 981; mul 979 982; input p 161; mul 877 984; add 983
985; neg 986; where 978 987; abs 2; lt 989 225; input p 137; mul 91 618; mul 991 992; where 990 993; add 988 994;
mul 91 626; mul 254 996; neg 997; where 217 998; add 995 999; mul 222 1000; input p 157; mul 252 877; mul 1002 1003;
neg 1004; where 978 1005; mul 252 992; mul 244 1007; where 990 1008; add 1006 1009; mul 248 982; input p 163; mul
877 1012; add 1011 1013; neg 1014; where 978 1015; mul 285 992; where 990 1017; add 1016 1018; mul 273 996; neg
1020; where 217 1021; add 1019 1022; mul 236 1023; add 1010 1024; mul 252 996; mul 232 1026; neg 1027; where 217
1028; add 1025 1029; mul 236 1030; add 1001 1031; mul 244 1003; neg 1033; where 978 1034; input p 133; mul 1007
1036; where 990 1037; add 1035 1038; mul 244 982; input p 162; mul 877 1041; add 1040 1042; neg 1043; where 978
1044; input p 140; mul 992 1046; where 990 1047; add 1045 1048; mul 269 996; neg 1050; where 217 1051; add 1049
1052; mul 236 1053; add 1039 1054; mul 240 982; mul 281 877; add 1056 1057; neg 1058; where 978 1059; input p 139;
mul 992 1061; where 990 1062; add 1060 1063; mul 265 996; neg 1065; where 217 1066; add 1064 1067; mul 228 1068; add
1055 1069; mul 224 1026; neg 1071; where 217 1072; add 1070 1073; mul 228 1074; add 1032 1075; mul 221 406; input p
156; mul 1003 1078; neg 1079; where 978 1080; input p 132; mul 1007 1082; where 990 1083; add 1081 1084; mul 982
1078; mul 273 877; add 1086 1087; neg 1088; where 978 1089; input p 138; mul 992 1091; where 990 1092; add 1090
1093; mul 261 996; neg 1095; where 217 1096; add 1094 1097; mul 236 1098; add 1085 1099; mul 982 1082; mul 877 1091;
add 1101 1102; neg 1103; where 978 1104; mul 265 992; where 990 1106; add 1105 1107; mul 257 996; neg 1109; where
217 1110; add 1108 1111; mul 228 1112; add 1100 1113; mul 221 1000; add 1114 1115; mul 218 1026; neg 1117; where 217
1118; add 1116 1119; mul 1077 1120; add 1076 1121; mul 976 1122; mul 971 1123; add 966 1124; mul 96 992; mul 99 877;
sub 1126 1127; mul 93 996; sub 1128 1129; mul 209 1130; mul 147 1131; add 1125 1132; mul 94 1131; mul 868 1134; add
1133 1135; mul 142 1130; mul 101 1137; mul 868 1138; add 1136 1139; mul 203 1130; mul 34 1141; mul 868 1142; add
1140 1143; mul 200 1130; mul 868 1145; add 1144 1146; mul 197 1130; mul 101 1148; mul 101 1149; add 1147 1150; mul
194 1130; mul 34 1152; mul 101 1153; add 1151 1154; mul 191 1130; mul 101 1156; add 1155 1157; mul 107 1130; mul 34
1159; mul 34 1160; add 1158 1161; mul 103 1130; mul 34 1163; add 1162 1164; mul 92 1130; add 1165 1166; mul 151 996;
mul 147 1168; sub 1167 1169; mul 94 1168; mul 868 1171; sub 1170 1172; mul 146 996; mul 101 1174; mul 868 1175; sub
1173 1176; mul 142 996; mul 101 1178; mul 101 1179; sub 1177 1180; mul 138 996; mul 34 1182; mul 101 1183; sub 1181
1184; mul 134 996; mul 101 1186; sub 1185 1187; mul 130 996; mul 34 1189; mul 34 1190; sub 1188 1191; mul 126 996;
mul 34 1193; sub 1192 1194; mul 123 996; sub 1195 1196; mul 147 874; mul 147 878; mul 135 889; add 1199 1200; mul 94
890; add 1201 1202; mul 94 895; add 1203 1204; mul 94 898; add 1205 1206; input p 153; mul 877 1208; mul 112 1209;
add 1207 1210; mul 101 406; mul 101 1209; mul 1212 1213; add 1211 1214; mul 173 877; mul 34 1216; mul 1212 1217; add
1215 1218; input p 152; mul 877 1220; mul 1212 1221; add 1219 1222; input p 151; mul 877 1224; mul 34 1225; mul 34
1226; add 1223 1227; input p 150; mul 877 1229; mul 34 1230; add 1228 1231; mul 156 877; add 1232 1233; sub 1198
1234; mul 94 907; add 1235 1236; mul 366 873; mul 112 1238; add 1237 1239; mul 101 1238; mul 1212 1241; add 1240
1242; mul 320 873; mul 34 1244; mul 1212 1245; add 1243 1246; mul 361 873; mul 34 1248; mul 34 1249; add 1247 1250;
mul 341 871; add 1251 1252; mul 147 925; add 1253 1254; mul 135 933; add 1255 1256; mul 94 934; add 1257 1258; mul
326 918; mul 112 1260; add 1259 1261; mul 101 1260; mul 1212 1263; add 1262 1264; mul 323 918; mul 34 1266; mul 1212
1267; add 1265 1268; mul 320 918; mul 34 1270; mul 34 1271; add 1269 1272; mul 147 951; add 1273 1274; mul 135 955;
add 1275 1276; mul 94 956; add 1277 1278; mul 94 960; add 1279 1280; mul 300 944; mul 112 1282; add 1281 1283; mul
101 1282; mul 1212 1285; add 1284 1286; mul 298 944; mul 34 1288; mul 34 1289; add 1287 1290; mul 147 1137; add 1291
1292; mul 135 1148; add 1293 1294; mul 94 1149; add 1295 1296; mul 94 1153; add 1297 1298; mul 94 1156; add 1299
1300; mul 182 1130; mul 112 1302; add 1301 1303; mul 101 1302; mul 1212 1305; add 1304 1306; mul 179 1130; mul 34
1308; mul 1212 1309; add 1307 1310; mul 176 1130; mul 1212 1312; add 1311 1313; mul 173 1130; mul 34 1315; mul 34
1316; add 1314 1317; mul 170 1130; mul 34 1319; add 1318 1320; mul 167 1130; add 1321 1322; mul 147 1174; sub 1323
1324; mul 135 1178; sub 1325 1326; mul 94 1179; sub 1327 1328; mul 94 1183; sub 1329 1330; mul 94 1186; sub 1331
1332; mul 119 996; mul 112 1334; sub 1333 1335; mul 101 1334; mul 1212 1337; sub 1336 1338; mul 115 996; mul 34
1340; mul 1212 1341; sub 1339 1342; mul 111 996; mul 1212 1344; sub 1343 1345; mul 107 996; mul 34 1347; mul 34
1348; sub 1346 1349; mul 103 996; mul 34 1351; sub 1350 1352; mul 92 996; sub 1353 1354; mul 93 1355; add 1197 1356;
mul 867 1357; sub 866 1358; input p 218; input c 4; input p 14; mul 28 1362; sub 2 1363; input c 5; mul 1364 1365;
sub 1361 1366; input c 6; mul 425 1368; add 1367 1369; input c 7; mul 538 1371; add 1370 1372; input c 8; input p
15; max 1374 1375; mul 474 1362; sub 465 1377; mul 1376 1378; sub 1373 1379; mul 89 1380; mul 89 1362; add 618 1382;
mul 1376 1383; mul 474 1384; add 1381 1385; mul 1365 1383; input c 9; input c 10; mul 348 1389; mul 1364 1390; sub
1388 1391; input c 11; mul 425 1393; add 1392 1394; input c 12; mul 538 1396; add 1395 1397; mul 89 1398; add 1387
1399; mul 89 1364; mul 1390 1401; sub 1400 1402; mul 28 1403; add 1386 1404; mul 1360 1405; add 1359 1406; mul 55
69; mul 78 78; sub 1408 1409; mul 88 1410; mul 592 1411; mul 581 1411; mul 583 618; add 1413 1414; mul 482 1411; mul
58 69; mul 75 78; sub 1417 1418; mul 88 1419; mul 488 1420; sub 1416 1421; mul 90 618; mul 345 1423; sub 1422 1424;
mul 521 1425; add 1415 1426; mul 574 1427; mul 521 1428; mul 472 1411; mul 475 618; add 1430 1431; mul 404 1425; add
1432 1433; mul 464 1434; mul 404 1435; add 1429 1436; mul 465 1437; sub 1412 1438; mul 480 1439; mul 616 618; mul
505 1427; mul 540 1442; mul 544 1443; mul 587 1427; mul 573 1445; mul 569 1445; mul 572 1447; add 1446 1448; mul 560
1427; add 1449 1450; mul 564 1451; mul 566 1452; mul 528 1452; mul 454 1454; add 1453 1455; sub 1444 1456; mul 528
1443; mul 542 1458; add 1457 1459; mul 527 1442; mul 534 1461; mul 530 1461; mul 532 1463; add 1462 1464; mul 674
1465; mul 669 1466; sub 1460 1467; mul 568 1451; mul 505 1469; mul 685 1470; mul 518 1470; mul 563 1472; add 1471
1473; mul 518 1472; mul 562 1475; add 1474 1476; mul 474 1428; sub 1478 636; mul 511 1479; mul 589 1425; mul 491
1428; add 1481 1482; mul 504 1483; sub 1480 1484; mul 589 1411; mul 465 1428; add 1486 1487; mul 16 1488; mul 579
1489; sub 1485 1490; mul 505 1491; mul 536 1442; mul 522 1493; mul 524 1494; add 1492 1495; mul 519 1494; mul 406
1497; add 1496 1498; mul 695 1499; mul 519 1500; sub 1477 1501; mul 684 1502; add 1468 1503; neg 1494; mul 406 1505;
add 1504 1506; mul 505 1507; mul 645 1508; mul 643 1509; mul 520 1483; mul 520 1489; mul 577 1512; add 1511 1513;
sub 1510 1514; add 1441 1515; mul 592 1420; mul 489 1437; add 1517 1518; mul 486 1519; add 1516 1520; sub 1440 1521;
mul 99 1420; mul 96 1411; sub 1523 1524; mul 93 1423; add 1525 1526; mul 595 1527; mul 598 1528; mul 608 1528; mul
595 1423; mul 598 1531; add 1530 1532; mul 93 1533; add 1529 1534; mul 596 1531; add 1535 1536; mul 345 1437; sub
1537 1538; mul 744 1539; sub 1522 1540; mul 592 1423; mul 478 1437; add 1542 1543; mul 343 1544; sub 1541 1545; mul
66 1544; sub 1546 1547; mul 495 1411; mul 465 1435; add 1549 1550; mul 16 1551; mul 403 1552; mul 468 1553; mul 495
1425; mul 491 1435; add 1555 1556; mul 403 1557; sub 1554 1558; mul 388 1434; mul 427 1560; mul 431 1561; mul 493
1434; mul 463 1563; mul 459 1563; mul 462 1565; add 1564 1566; mul 447 1434; add 1567 1568; mul 452 1569; mul 456
1570; mul 415 1570; mul 454 1572; add 1571 1573; sub 1562 1574; mul 415 1561; mul 429 1576; add 1575 1577; mul 411
1560; mul 421 1579; mul 417 1579; mul 419 1581; add 1580 1582; mul 813 1583; mul 808 1584; sub 1578 1585; mul 458
1569; mul 388 1587; mul 824 1588; mul 401 1588; mul 451 1590; add 1589 1591; mul 401 1590; mul 450 1593; add 1592
1594; mul 474 1435; sub 1596 775; mul 394 1597; mul 387 1557; sub 1598 1599; mul 470 1552; sub 1600 1601; mul 388
1602; mul 423 1560; mul 405 1604; mul 408 1605; add 1603 1606; mul 402 1605; mul 406 1608; add 1607 1609; mul 834
1610; mul 402 1611; sub 1595 1612; mul 823 1613; add 1586 1614; neg 1605; mul 406 1616; add 1615 1617; mul 388 1618;
mul 784 1619; mul 782 1620; add 1559 1621; add 1515 1622; mul 378 1623; add 1548 1624; sub 1625 1622; mul 91 1420;
mul 203 1627; mul 101 1628; mul 868 1629; mul 130 1627; mul 34 1631; mul 868 1632; add 1630 1633; mul 885 1627; mul
868 1635; add 1634 1636; mul 115 1627; mul 101 1638; mul 101 1639; add 1637 1640; mul 893 1627; mul 34 1642; mul 101
1643; add 1641 1644; mul 103 1627; mul 101 1646; add 1645 1647; mul 296 1623; mul 355 1649; mul 34 1650; mul 296
1519; sub 1651 1652; mul 334 1653; mul 101 1654; mul 868 1655; add 1648 1656; mul 303 1653; mul 34 1658; mul 868
1659; add 1657 1660; mul 369 1653; mul 34 1662; mul 101 1663; add 1661 1664; mul 296 1439; mul 96 1666; mul 99 1652;
sub 1667 1668; mul 296 1544; mul 93 1670; sub 1669 1671; mul 101 1650; add 1672 1673; mul 339 1674; mul 147 1675;
add 1665 1676; mul 94 1675; mul 868 1678; add 1677 1679; mul 309 1674; mul 101 1681; mul 868 1682; add 1680 1683;
mul 334 1674; mul 34 1685; mul 868 1686; add 1684 1687; mul 331 1674; mul 101 1689; mul 101 1690; add 1688 1691; mul
298 1674; mul 34 1693; mul 34 1694; add 1692 1695; mul 317 1650; add 1696 1697; mul 94 1650; sub 1699 1670; mul 315
1700; mul 147 1701; add 1698 1702; mul 94 1701; mul 868 1704; add 1703 1705; mul 312 1700; mul 101 1707; mul 868
1708; add 1706 1709; mul 309 1700; mul 101 1711; mul 101 1712; add 1710 1713; mul 306 1700; mul 34 1715; mul 101
1716; add 1714 1717; mul 303 1700; mul 34 1719; mul 34 1720; add 1718 1721; mul 981 1627; mul 979 1723; mul 984
1627; add 1724 1725; where 978 1726; mul 91 1411; mul 991 1728; neg 1729; where 990 1730; add 1727 1731; mul 91
1423; mul 254 1733; where 217 1734; add 1732 1735; mul 222 1736; mul 252 1627; mul 1002 1738; where 978 1739; mul
252 1728; mul 244 1741; neg 1742; where 990 1743; add 1740 1744; mul 248 1723; mul 1012 1627; add 1746 1747; where
978 1748; mul 285 1728; neg 1750; where 990 1751; add 1749 1752; mul 273 1733; where 217 1754; add 1753 1755; mul
236 1756; add 1745 1757; mul 252 1733; mul 232 1759; where 217 1760; add 1758 1761; mul 236 1762; add 1737 1763; mul
244 1738; where 978 1765; mul 1036 1741; neg 1767; where 990 1768; add 1766 1769; mul 244 1723; mul 1041 1627; add
1771 1772; where 978 1773; mul 1046 1728; neg 1775; where 990 1776; add 1774 1777; mul 269 1733; where 217 1779; add
1778 1780; mul 236 1781; add 1770 1782; mul 240 1723; mul 281 1627; add 1784 1785; where 978 1786; mul 1061 1728;
neg 1788; where 990 1789; add 1787 1790; mul 265 1733; where 217 1792; add 1791 1793; mul 228 1794; add 1783 1795;
mul 224 1759; where 217 1797; add 1796 1798; mul 228 1799; add 1764 1800; mul 1078 1738; where 978 1802; mul 1082
1741; neg 1804; where 990 1805; add 1803 1806; mul 1078 1723; mul 273 1627; add 1808 1809; where 978 1810; mul 1091
1728; neg 1812; where 990 1813; add 1811 1814; mul 261 1733; where 217 1816; add 1815 1817; mul 236 1818; add 1807
1819; mul 1082 1723; mul 1091 1627; add 1821 1822; where 978 1823; mul 265 1728; neg 1825; where 990 1826; add 1824
1827; mul 257 1733; where 217 1829; add 1828 1830; mul 228 1831; add 1820 1832; mul 221 1736; add 1833 1834; mul 218
1759; where 217 1836; add 1835 1837; mul 1077 1838; add 1801 1839; mul 976 1840; mul 971 1841; add 1722 1842; mul 99
1627; mul 96 1728; sub 1844 1845; mul 93 1733; add 1846 1847; mul 209 1848; mul 147 1849; add 1843 1850; mul 94
1849; mul 868 1852; add 1851 1853; mul 142 1848; mul 101 1855; mul 868 1856; add 1854 1857; mul 203 1848; mul 34
1859; mul 868 1860; add 1858 1861; mul 200 1848; mul 868 1863; add 1862 1864; mul 197 1848; mul 101 1866; mul 101
1867; add 1865 1868; mul 194 1848; mul 34 1870; mul 101 1871; add 1869 1872; mul 191 1848; mul 101 1874; add 1873
1875; mul 107 1848; mul 34 1877; mul 34 1878; add 1876 1879; mul 103 1848; mul 34 1881; add 1880 1882; mul 92 1848;
add 1883 1884; mul 151 1733; mul 147 1886; add 1885 1887; mul 94 1886; mul 868 1889; add 1888 1890; mul 146 1733;
mul 101 1892; mul 868 1893; add 1891 1894; mul 142 1733; mul 101 1896; mul 101 1897; add 1895 1898; mul 138 1733;
mul 34 1900; mul 101 1901; add 1899 1902; mul 134 1733; mul 101 1904; add 1903 1905; mul 130 1733; mul 34 1907; mul
34 1908; add 1906 1909; mul 126 1733; mul 34 1911; add 1910 1912; mul 123 1733; add 1913 1914; mul 147 1628; mul 135
1638; add 1916 1917; mul 94 1639; add 1918 1919; mul 94 1643; add 1920 1921; mul 94 1646; add 1922 1923; mul 1208
1627; mul 112 1925; add 1924 1926; mul 101 1925; mul 1212 1928; add 1927 1929; mul 173 1627; mul 34 1931; mul 1212
1932; add 1930 1933; mul 1220 1627; mul 1212 1935; add 1934 1936; mul 1224 1627; mul 34 1938; mul 34 1939; add 1937
1940; mul 1229 1627; mul 34 1942; add 1941 1943; mul 156 1627; add 1944 1945; mul 147 1654; add 1946 1947; mul 94
1663; add 1948 1949; mul 366 1653; mul 112 1951; add 1950 1952; mul 101 1951; mul 1212 1954; add 1953 1955; mul 320
1653; mul 34 1957; mul 1212 1958; add 1956 1959; mul 361 1653; mul 34 1961; mul 34 1962; add 1960 1963; mul 341
1650; add 1964 1965; mul 147 1681; add 1966 1967; mul 135 1689; add 1968 1969; mul 94 1690; add 1970 1971; mul 326
1674; mul 112 1973; add 1972 1974; mul 101 1973; mul 1212 1976; add 1975 1977; mul 323 1674; mul 34 1979; mul 1212
1980; add 1978 1981; mul 320 1674; mul 34 1983; mul 34 1984; add 1982 1985; mul 147 1707; add 1986 1987; mul 135
1711; add 1988 1989; mul 94 1712; add 1990 1991; mul 94 1716; add 1992 1993; mul 300 1700; mul 112 1995; add 1994
1996; mul 101 1995; mul 1212 1998; add 1997 1999; mul 298 1700; mul 34 2001; mul 34 2002; add 2000 2003; mul 147
1855; add 2004 2005; mul 135 1866; add 2006 2007; mul 94 1867; add 2008 2009; mul 94 1871; add 2010 2011; mul 94
1874; add 2012 2013; mul 182 1848; mul 112 2015; add 2014 2016; mul 101 2015; mul 1212 2018; add 2017 2019; mul 179
1848; mul 34 2021; mul 1212 2022; add 2020 2023; mul 176 1848; mul 1212 2025; add 2024 2026; mul 173 1848; mul 34
2028; mul 34 2029; add 2027 2030; mul 170 1848; mul 34 2032; add 2031 2033; mul 167 1848; add 2034 2035; mul 147
1892; add 2036 2037; mul 135 1896; add 2038 2039; mul 94 1897; add 2040 2041; mul 94 1901; add 2042 2043; mul 94
1904; add 2044 2045; mul 119 1733; mul 112 2047; add 2046 2048; mul 101 2047; mul 1212 2050; add 2049 2051; mul 115
1733; mul 34 2053; mul 1212 2054; add 2052 2055; mul 111 1733; mul 1212 2057; add 2056 2058; mul 107 1733; mul 34
2060; mul 34 2061; add 2059 2062; mul 103 1733; mul 34 2064; add 2063 2065; mul 92 1733; add 2066 2067; mul 93 2068;
add 1915 2069; mul 867 2070; sub 1626 2071; mul 618 1380; mul 618 1362; add 1411 2074; mul 1376 2075; mul 474 2076;
add 2073 2077; mul 618 1364; mul 1390 2079; mul 1365 2075; mul 618 1398; add 2081 2082; sub 2080 2083; mul 28 2084;
sub 2078 2085; mul 1360 2086; sub 2072 2087; mul 616 622; mul 581 1420; mul 583 622; add 2090 2091; mul 44 69; mul
75 75; sub 2093 2094; mul 88 2095; mul 488 2096; mul 482 1420; sub 2097 2098; mul 90 622; mul 345 2100; add 2099
2101; mul 521 2102; sub 2092 2103; mul 574 2104; mul 491 2105; mul 589 2102; sub 2106 2107; mul 520 2108; mul 589
1420; mul 465 2105; add 2110 2111; mul 16 2112; mul 520 2113; mul 577 2114; add 2109 2115; mul 587 2104; mul 573
2117; mul 569 2117; mul 572 2119; add 2118 2120; mul 560 2104; add 2121 2122; mul 564 2123; mul 566 2124; mul 528
2124; mul 454 2126; add 2125 2127; mul 505 2104; mul 540 2129; mul 544 2130; sub 2128 2131; mul 528 2130; mul 542
2133; sub 2132 2134; mul 527 2129; mul 534 2136; mul 530 2136; mul 532 2138; add 2137 2139; mul 674 2140; mul 669
2141; add 2135 2142; mul 568 2123; mul 505 2144; mul 685 2145; mul 518 2145; mul 563 2147; add 2146 2148; mul 518
2147; mul 562 2150; add 2149 2151; mul 504 2108; mul 589 622; mul 474 2105; sub 2154 2155; mul 511 2156; add 2153
2157; mul 579 2113; add 2158 2159; mul 505 2160; mul 536 2129; mul 522 2162; mul 524 2163; sub 2161 2164; mul 519
2163; neg 2166; mul 406 2167; add 2165 2168; mul 695 2169; mul 519 2170; add 2152 2171; mul 684 2172; sub 2143 2173;
mul 406 2163; add 2174 2175; mul 505 2176; mul 645 2177; mul 643 2178; add 2116 2179; sub 2089 2180; mul 592 2096;
mul 521 2105; mul 472 1420; mul 475 622; add 2184 2185; mul 404 2102; sub 2186 2187; mul 464 2188; mul 404 2189; add
2183 2190; mul 489 2191; add 2182 2192; mul 486 2193; add 2181 2194; mul 465 2191; sub 2196 1517; mul 480 2197; add
2195 2198; mul 96 1420; mul 99 2096; sub 2200 2201; mul 93 2100; sub 2202 2203; mul 595 2204; mul 598 2205; mul 608
2205; mul 595 2100; mul 598 2208; sub 2207 2209; mul 93 2210; add 2206 2211; mul 596 2208; sub 2212 2213; mul 345
2191; add 2214 2215; mul 744 2216; sub 2199 2217; mul 592 2100; mul 478 2191; add 2219 2220; mul 343 2221; add 2218
2222; mul 66 2221; add 2223 2224; mul 491 2189; mul 495 2102; sub 2226 2227; mul 403 2228; mul 495 1420; mul 465
2189; add 2230 2231; mul 16 2232; mul 403 2233; mul 468 2234; sub 2229 2235; mul 493 2188; mul 463 2237; mul 459
2237; mul 462 2239; add 2238 2240; mul 447 2188; add 2241 2242; mul 452 2243; mul 456 2244; mul 415 2244; mul 454
2246; add 2245 2247; mul 388 2188; mul 427 2249; mul 431 2250; sub 2248 2251; mul 415 2250; mul 429 2253; sub 2252
2254; mul 411 2249; mul 421 2256; mul 417 2256; mul 419 2258; add 2257 2259; mul 813 2260; mul 808 2261; add 2255
2262; mul 458 2243; mul 388 2264; mul 824 2265; mul 401 2265; mul 451 2267; add 2266 2268; mul 401 2267; mul 450
2270; add 2269 2271; mul 387 2228; mul 495 622; mul 474 2189; sub 2274 2275; mul 394 2276; add 2273 2277; mul 470
2233; add 2278 2279; mul 388 2280; mul 423 2249; mul 405 2282; mul 408 2283; sub 2281 2284; mul 402 2283; neg 2286;
mul 406 2287; add 2285 2288; mul 834 2289; mul 402 2290; add 2272 2291; mul 823 2292; sub 2263 2293; mul 406 2283;
add 2294 2295; mul 388 2296; mul 784 2297; mul 782 2298; add 2236 2299; add 2180 2300; mul 378 2301; add 2225 2302;
sub 2303 2300; mul 296 2193; mul 296 2301; mul 355 2306; mul 34 2307; add 2305 2308; mul 334 2309; mul 101 2310; mul
868 2311; mul 91 2096; mul 203 2313; mul 101 2314; mul 868 2315; mul 130 2313; mul 34 2317; mul 868 2318; add 2316
2319; mul 885 2313; mul 868 2321; add 2320 2322; mul 115 2313; mul 101 2324; mul 101 2325; add 2323 2326; mul 893
2313; mul 34 2328; mul 101 2329; add 2327 2330; mul 103 2313; mul 101 2332; add 2331 2333; sub 2312 2334; mul 303
2309; mul 34 2336; mul 868 2337; add 2335 2338; mul 369 2309; mul 34 2340; mul 101 2341; add 2339 2342; mul 99 2305;
mul 296 2197; mul 96 2345; add 2344 2346; mul 296 2221; mul 93 2348; add 2347 2349; mul 101 2307; add 2350 2351; mul
339 2352; mul 147 2353; add 2343 2354; mul 94 2353; mul 868 2356; add 2355 2357; mul 309 2352; mul 101 2359; mul 868
2360; add 2358 2361; mul 334 2352; mul 34 2363; mul 868 2364; add 2362 2365; mul 331 2352; mul 101 2367; mul 101
2368; add 2366 2369; mul 298 2352; mul 34 2371; mul 34 2372; add 2370 2373; mul 317 2307; add 2374 2375; mul 94
2307; add 2348 2377; mul 315 2378; mul 147 2379; add 2376 2380; mul 94 2379; mul 868 2382; add 2381 2383; mul 312
2378; mul 101 2385; mul 868 2386; add 2384 2387; mul 309 2378; mul 101 2389; mul 101 2390; add 2388 2391; mul 306
2378; mul 34 2393; mul 101 2394; add 2392 2395; mul 303 2378; mul 34 2397; mul 34 2398; add 2396 2399; mul 981 2313;
mul 979 2401; mul 984 2313; add 2402 2403; neg 2404; where 978 2405; mul 991 1627; where 990 2407; add 2406 2408;
mul 91 2100; mul 254 2410; neg 2411; where 217 2412; add 2409 2413; mul 222 2414; mul 252 2313; mul 1002 2416; neg
2417; where 978 2418; where 990 1765; add 2419 2420; mul 248 2401; mul 1012 2313; add 2422 2423; neg 2424; where 978
2425; mul 285 1627; where 990 2427; add 2426 2428; mul 273 2410; neg 2430; where 217 2431; add 2429 2432; mul 236
2433; add 2421 2434; mul 252 2410; mul 232 2436; neg 2437; where 217 2438; add 2435 2439; mul 236 2440; add 2415
2441; mul 244 2416; neg 2443; where 978 2444; mul 1036 1738; where 990 2446; add 2445 2447; mul 244 2401; mul 1041
2313; add 2449 2450; neg 2451; where 978 2452; mul 1046 1627; where 990 2454; add 2453 2455; mul 269 2410; neg 2457;
where 217 2458; add 2456 2459; mul 236 2460; add 2448 2461; mul 240 2401; mul 281 2313; add 2463 2464; neg 2465;
where 978 2466; mul 1061 1627; where 990 2468; add 2467 2469; mul 265 2410; neg 2471; where 217 2472; add 2470 2473;
mul 228 2474; add 2462 2475; mul 224 2436; neg 2477; where 217 2478; add 2476 2479; mul 228 2480; add 2442 2481; mul
1078 2416; neg 2483; where 978 2484; mul 1082 1738; where 990 2486; add 2485 2487; mul 1078 2401; mul 273 2313; add
2489 2490; neg 2491; where 978 2492; where 990 1822; add 2493 2494; mul 261 2410; neg 2496; where 217 2497; add 2495
2498; mul 236 2499; add 2488 2500; mul 1082 2401; mul 1091 2313; add 2502 2503; neg 2504; where 978 2505; mul 265
1627; where 990 2507; add 2506 2508; mul 257 2410; neg 2510; where 217 2511; add 2509 2512; mul 228 2513; add 2501
2514; mul 221 2414; add 2515 2516; mul 218 2436; neg 2518; where 217 2519; add 2517 2520; mul 1077 2521; add 2482
2522; mul 976 2523; mul 971 2524; add 2400 2525; mul 96 1627; mul 99 2313; sub 2527 2528; mul 93 2410; sub 2529
2530; mul 209 2531; mul 147 2532; add 2526 2533; mul 94 2532; mul 868 2535; add 2534 2536; mul 142 2531; mul 101
2538; mul 868 2539; add 2537 2540; mul 203 2531; mul 34 2542; mul 868 2543; add 2541 2544; mul 200 2531; mul 868
2546; add 2545 2547; mul 197 2531; mul 101 2549; mul 101 2550; add 2548 2551; mul 194 2531; mul 34 2553; mul 101
2554; add 2552 2555; mul 191 2531; mul 101 2557; add 2556 2558; mul 107 2531; mul 34 2560; mul 34 2561; add 2559
2562; mul 103 2531; mul 34 2564; add 2563 2565; mul 92 2531; add 2566 2567; mul 151 2410; mul 147 2569; sub 2568
2570; mul 94 2569; mul 868 2572; sub 2571 2573; mul 146 2410; mul 101 2575; mul 868 2576; sub 2574 2577; mul 142
2410; mul 101 2579; mul 101 2580; sub 2578 2581; mul 138 2410; mul 34 2583; mul 101 2584; sub 2582 2585; mul 134
2410; mul 101 2587; sub 2586 2588; mul 130 2410; mul 34 2590; mul 34 2591; sub 2589 2592; mul 126 2410; mul 34 2594;
sub 2593 2595; mul 123 2410; sub 2596 2597; mul 147 2310; mul 147 2314; mul 135 2324; add 2600 2601; mul 94 2325;
add 2602 2603; mul 94 2329; add 2604 2605; mul 94 2332; add 2606 2607; mul 1208 2313; mul 112 2609; add 2608 2610;
mul 101 2609; mul 1212 2612; add 2611 2613; mul 173 2313; mul 34 2615; mul 1212 2616; add 2614 2617; mul 1220 2313;
mul 1212 2619; add 2618 2620; mul 1224 2313; mul 34 2622; mul 34 2623; add 2621 2624; mul 1229 2313; mul 34 2626;
add 2625 2627; mul 156 2313; add 2628 2629; sub 2599 2630; mul 94 2341; add 2631 2632; mul 366 2309; mul 112 2634;
add 2633 2635; mul 101 2634; mul 1212 2637; add 2636 2638; mul 320 2309; mul 34 2640; mul 1212 2641; add 2639 2642;
mul 361 2309; mul 34 2644; mul 34 2645; add 2643 2646; mul 341 2307; add 2647 2648; mul 147 2359; add 2649 2650; mul
135 2367; add 2651 2652; mul 94 2368; add 2653 2654; mul 326 2352; mul 112 2656; add 2655 2657; mul 101 2656; mul
1212 2659; add 2658 2660; mul 323 2352; mul 34 2662; mul 1212 2663; add 2661 2664; mul 320 2352; mul 34 2666; mul 34
2667; add 2665 2668; mul 147 2385; add 2669 2670; mul 135 2389; add 2671 2672; mul 94 2390; add 2673 2674; mul 94
2394; add 2675 2676; mul 300 2378; mul 112 2678; add 2677 2679; mul 101 2678; mul 1212 2681; add 2680 2682; mul 298
2378; mul 34 2684; mul 34 2685; add 2683 2686; mul 147 2538; add 2687 2688; mul 135 2549; add 2689 2690; mul 94
2550; add 2691 2692; mul 94 2554; add 2693 2694; mul 94 2557; add 2695 2696; mul 182 2531; mul 112 2698; add 2697
2699; mul 101 2698; mul 1212 2701; add 2700 2702; mul 179 2531; mul 34 2704; mul 1212 2705; add 2703 2706; mul 176
2531; mul 1212 2708; add 2707 2709; mul 173 2531; mul 34 2711; mul 34 2712; add 2710 2713; mul 170 2531; mul 34
2715; add 2714 2716; mul 167 2531; add 2717 2718; mul 147 2575; sub 2719 2720; mul 135 2579; sub 2721 2722; mul 94
2580; sub 2723 2724; mul 94 2584; sub 2725 2726; mul 94 2587; sub 2727 2728; mul 119 2410; mul 112 2730; sub 2729
2731; mul 101 2730; mul 1212 2733; sub 2732 2734; mul 115 2410; mul 34 2736; mul 1212 2737; sub 2735 2738; mul 111
2410; mul 1212 2740; sub 2739 2741; mul 107 2410; mul 34 2743; mul 34 2744; sub 2742 2745; mul 103 2410; mul 34
2747; sub 2746 2748; mul 92 2410; sub 2749 2750; mul 93 2751; add 2598 2752; mul 867 2753; sub 2304 2754; mul 622
1380; mul 622 1362; add 1420 2757; mul 1376 2758; mul 474 2759; add 2756 2760; mul 1365 2758; mul 622 1398; add 2762
2763; mul 622 1364; mul 1390 2765; sub 2764 2766; mul 28 2767; add 2761 2768; mul 1360 2769; add 2755 2770; mul 404
459; mul 489 2772; mul 486 2773; mul 465 2772; mul 480 2775; add 2774 2776; mul 345 2772; mul 744 2778; sub 2777
2779; mul 478 2772; mul 343 2781; add 2780 2782; mul 66 2781; add 2783 2784; mul 459 491; mul 403 2786; mul 459 465;
mul 16 2788; mul 403 2789; mul 468 2790; sub 2787 2791; mul 452 493; mul 456 2793; mul 415 2793; mul 454 2795; add
2794 2796; mul 458 493; mul 388 2798; mul 824 2799; mul 401 2799; mul 451 2801; add 2800 2802; mul 401 2801; mul 450
2804; add 2803 2805; mul 387 2786; mul 459 474; mul 394 2808; sub 2807 2809; mul 470 2789; add 2810 2811; mul 388
2812; mul 834 2813; mul 402 2814; add 2806 2815; mul 823 2816; sub 2797 2817; mul 388 2818; mul 784 2819; mul 782
2820; add 2792 2821; mul 378 2822; add 2785 2823; sub 2824 2822; mul 296 2773; mul 296 2822; mul 355 2827; mul 34
2828; add 2826 2829; mul 334 2830; mul 101 2831; mul 868 2832; mul 303 2830; mul 34 2834; mul 868 2835; add 2833
2836; mul 369 2830; mul 34 2838; mul 101 2839; add 2837 2840; mul 99 2826; mul 296 2775; mul 96 2843; add 2842 2844;
mul 296 2781; mul 93 2846; add 2845 2847; mul 101 2828; add 2848 2849; mul 339 2850; mul 147 2851; add 2841 2852;
mul 94 2851; mul 868 2854; add 2853 2855; mul 309 2850; mul 101 2857; mul 868 2858; add 2856 2859; mul 334 2850; mul
34 2861; mul 868 2862; add 2860 2863; mul 331 2850; mul 101 2865; mul 101 2866; add 2864 2867; mul 298 2850; mul 34
2869; mul 34 2870; add 2868 2871; mul 317 2828; add 2872 2873; mul 94 2828; add 2846 2875; mul 315 2876; mul 147
2877; add 2874 2878; mul 94 2877; mul 868 2880; add 2879 2881; mul 312 2876; mul 101 2883; mul 868 2884; add 2882
2885; mul 309 2876; mul 101 2887; mul 101 2888; add 2886 2889; mul 306 2876; mul 34 2891; mul 101 2892; add 2890
2893; mul 303 2876; mul 34 2895; mul 34 2896; add 2894 2897; mul 147 2831; mul 94 2839; add 2899 2900; mul 366 2830;
mul 112 2902; add 2901 2903; mul 101 2902; mul 1212 2905; add 2904 2906; mul 320 2830; mul 34 2908; mul 1212 2909;
add 2907 2910; mul 361 2830; mul 34 2912; mul 34 2913; add 2911 2914; mul 341 2828; add 2915 2916; mul 147 2857; add
2917 2918; mul 135 2865; add 2919 2920; mul 94 2866; add 2921 2922; mul 326 2850; mul 112 2924; add 2923 2925; mul
101 2924; mul 1212 2927; add 2926 2928; mul 323 2850; mul 34 2930; mul 1212 2931; add 2929 2932; mul 320 2850; mul
34 2934; mul 34 2935; add 2933 2936; mul 147 2883; add 2937 2938; mul 135 2887; add 2939 2940; mul 94 2888; add 2941
2942; mul 94 2892; add 2943 2944; mul 300 2876; mul 112 2946; add 2945 2947; mul 101 2946; mul 1212 2949; add 2948
2950; mul 298 2876; mul 34 2952; mul 34 2953; add 2951 2954; mul 93 2955; add 2898 2956; mul 867 2957; sub 2825
2958; mul 521 569; mul 489 2960; mul 486 2961; mul 491 569; mul 520 2963; mul 465 569; mul 16 2965; mul 520 2966;
mul 577 2967; add 2964 2968; mul 564 587; mul 566 2970; mul 528 2970; mul 454 2972; add 2971 2973; mul 568 587; mul
505 2975; mul 685 2976; mul 518 2976; mul 563 2978; add 2977 2979; mul 518 2978; mul 562 2981; add 2980 2982; mul
504 2963; mul 474 569; mul 511 2985; sub 2984 2986; mul 579 2966; add 2987 2988; mul 505 2989; mul 695 2990; mul 519
2991; add 2983 2992; mul 684 2993; sub 2974 2994; mul 505 2995; mul 645 2996; mul 643 2997; add 2969 2998; sub 2962
2999; mul 465 2960; mul 480 3001; add 3000 3002; mul 345 2960; mul 744 3004; sub 3003 3005; mul 478 2960; mul 343
3007; add 3006 3008; mul 66 3007; add 3009 3010; mul 378 2999; add 3011 3012; mul 296 2961; mul 296 2999; mul 355
3015; mul 34 3016; add 3014 3017; mul 334 3018; mul 101 3019; mul 868 3020; mul 303 3018; mul 34 3022; mul 868 3023;
add 3021 3024; mul 369 3018; mul 34 3026; mul 101 3027; add 3025 3028; mul 99 3014; mul 296 3001; mul 96 3031; add
3030 3032; mul 296 3007; mul 93 3034; add 3033 3035; mul 101 3016; add 3036 3037; mul 339 3038; mul 147 3039; add
3029 3040; mul 94 3039; mul 868 3042; add 3041 3043; mul 309 3038; mul 101 3045; mul 868 3046; add 3044 3047; mul
334 3038; mul 34 3049; mul 868 3050; add 3048 3051; mul 331 3038; mul 101 3053; mul 101 3054; add 3052 3055; mul 298
3038; mul 34 3057; mul 34 3058; add 3056 3059; mul 317 3016; add 3060 3061; mul 94 3016; add 3034 3063; mul 315
3064; mul 147 3065; add 3062 3066; mul 94 3065; mul 868 3068; add 3067 3069; mul 312 3064; mul 101 3071; mul 868
3072; add 3070 3073; mul 309 3064; mul 101 3075; mul 101 3076; add 3074 3077; mul 306 3064; mul 34 3079; mul 101
3080; add 3078 3081; mul 303 3064; mul 34 3083; mul 34 3084; add 3082 3085; mul 147 3019; mul 94 3027; add 3087
3088; mul 366 3018; mul 112 3090; add 3089 3091; mul 101 3090; mul 1212 3093; add 3092 3094; mul 320 3018; mul 34
3096; mul 1212 3097; add 3095 3098; mul 361 3018; mul 34 3100; mul 34 3101; add 3099 3102; mul 341 3016; add 3103
3104; mul 147 3045; add 3105 3106; mul 135 3053; add 3107 3108; mul 94 3054; add 3109 3110; mul 326 3038; mul 112
3112; add 3111 3113; mul 101 3112; mul 1212 3115; add 3114 3116; mul 323 3038; mul 34 3118; mul 1212 3119; add 3117
3120; mul 320 3038; mul 34 3122; mul 34 3123; add 3121 3124; mul 147 3071; add 3125 3126; mul 135 3075; add 3127
3128; mul 94 3076; add 3129 3130; mul 94 3080; add 3131 3132; mul 300 3064; mul 112 3134; add 3133 3135; mul 101
3134; mul 1212 3137; add 3136 3138; mul 298 3064; mul 34 3140; mul 34 3141; add 3139 3142; mul 93 3143; add 3086
3144; mul 867 3145; sub 3013 3146; mul 222 1078; mul 229 244; add 3148 3149; mul 237 1002; add 3150 3151; input p
158; mul 241 3153; add 3152 3154; input p 159; mul 245 3156; add 3155 3157; input p 160; mul 249 3159; add 3158
3160; mul 252 3161; mul 255 984; mul 258 1091; add 3163 3164; mul 262 273; add 3165 3166; mul 266 281; add 3167
3168; mul 270 1041; add 3169 3170; mul 274 1012; add 3171 3172; input p 164; mul 278 3174; add 3173 3175; input p
143; mul 282 3177; add 3176 3178; input p 165; mul 286 3180; add 3179 3181; input p 166; mul 252 3183; add 3182
3184; add 3162 3185; mul 255 979; mul 258 1082; add 3187 3188; mul 262 1078; add 3189 3190; mul 240 266; add 3191
3192; mul 244 270; add 3193 3194; mul 248 274; add 3195 3196; input p 168; mul 278 3198; add 3197 3199; mul 282
3153; add 3200 3201; input p 136; mul 286 3203; add 3202 3204; input p 169; mul 252 3206; add 3205 3207; mul 981
3208; add 3186 3209; mul 622 3210; neg 3211; where 978 3212; input p 147; mul 34 3214; input p 148; mul 160 3216;
add 3215 3217; input p 149; mul 164 3219; add 3218 3220; mul 101 156; add 3221 3222; mul 104 1229; add 3223 3224;
mul 108 1224; add 3225 3226; mul 112 1220; add 3227 3228; mul 116 173; add 3229 3230; mul 120 1208; add 3231 3232;
mul 103 135; add 3233 3234; mul 139 893; add 3235 3236; mul 115 143; add 3237 3238; mul 147 885; add 3239 3240; mul
130 204; add 3241 3242; mul 148 203; add 3243 3244; mul 99 211; add 3245 3246; mul 622 3247; sub 3213 3248; mul 222
1082; mul 229 1036; add 3250 3251; mul 237 244; add 3252 3253; input p 134; mul 241 3255; add 3254 3256; input p
135; mul 245 3258; add 3257 3259; mul 249 3203; add 3260 3261; mul 252 3262; mul 255 991; mul 258 265; add 3264
3265; mul 262 1091; add 3266 3267; mul 266 1061; add 3268 3269; mul 270 1046; add 3270 3271; mul 274 285; add 3272
3273; input p 141; mul 278 3275; add 3274 3276; input p 142; mul 282 3278; add 3277 3279; mul 286 3177; add 3280
3281; input p 144; mul 252 3283; add 3282 3284; add 3263 3285; mul 618 3286; where 990 3287; add 3249 3288; mul 96
211; mul 618 3290; add 3289 3291; mul 292 626; neg 3293; where 217 3294; add 3292 3295; mul 213 626; sub 3296 3297;
mul 1420 3210; where 978 3299; mul 1420 3247; add 3300 3301; mul 1411 3286; neg 3303; where 990 3304; add 3302 3305;
mul 1411 3290; sub 3306 3307; mul 292 1423; where 217 3309; add 3308 3310; mul 213 1423; add 3311 3312; mul 2096
3210; neg 3314; where 978 3315; mul 2096 3247; sub 3316 3317; mul 1420 3286; where 990 3319; add 3318 3320; mul 1420
3290; add 3321 3322; mul 292 2100; neg 3324; where 217 3325; add 3323 3326; mul 213 2100; sub 3327 3328; mul 610
749; constant 0.8; mul 489 622; mul 3331 3332; sub 3330 3333; mul 605 626; sub 3334 3335; constant -2.0; mul 1378
1383; le 1374 1375; le 1375 1374; add 3339 3340; div 1 3341; mul 3339 3342; mul 3338 3343; mul 3337 3344; add 3336
3345; mul 489 1420; mul 3331 3347; mul 610 1527; add 3348 3349; mul 605 1423; add 3350 3351; mul 1378 2075; mul 3343
3353; mul 3337 3354; sub 3352 3355; mul 610 2204; mul 489 2096; mul 3331 3358; sub 3357 3359; mul 605 2100; sub 3360
3361; mul 1378 2758; mul 3343 3363; mul 3337 3364; add 3362 3365; constant -2.5714285714285743; mul 152 1130; mul
3367 3368; constant -0.8571428571428583; mul 148 877; mul 3370 3371; constant 0.9142857142857138; mul 204 877; mul
3373 3374; add 3372 3375; constant 0.05714285714285722; mul 143 877; mul 3377 3378; add 3376 3379; constant
-0.11428571428571327; mul 139 877; mul 3381 3382; add 3380 3383; constant 0.2190476190476189; mul 120 877; mul 3385
3386; add 3384 3387; constant 0.11428571428571413; mul 116 877; mul 3389 3390; add 3388 3391; constant
-0.05714285714285729; mul 108 877; mul 3393 3394; add 3392 3395; input p 219; constant -0.033333333333333326; mul
101 877; mul 3398 3399; mul 3397 3400; add 3396 3401; constant 0.007256235827664418; mul 164 877; mul 3403 3404; add
3402 3405; constant 0.01904761904761903; mul 34 877; mul 3407 3408; mul 3397 3409; add 3406 3410; sub 3369 3411;
constant 2.057142857142858; mul 148 1130; mul 3413 3414; add 3412 3415; mul 204 1130; mul 3370 3417; add 3416 3418;
constant -3.428571428571427; mul 143 1130; mul 3420 3421; add 3419 3422; constant 0.11428571428571443; mul 139 1130;
mul 3424 3425; add 3423 3426; constant -0.057142857142856635; mul 131 1130; mul 3428 3429; add 3427 3430; constant
-0.09999999999999995; mul 94 1130; mul 3432 3433; mul 3397 3434; add 3431 3435; constant 2.438095238095238; mul 120
1130; mul 3437 3438; add 3436 3439; constant 0.6571428571428567; mul 116 1130; mul 3441 3442; add 3440 3443; input p
220; mul 112 1130; mul 3445 3446; sub 3444 3447; mul 108 1130; mul 3389 3449; add 3448 3450; constant
0.13333333333333333; mul 101 1130; mul 3452 3453; mul 3397 3454; add 3451 3455; constant -0.019047619047619094; mul
164 1130; mul 3457 3458; add 3456 3459; mul 34 1130; mul 3398 3461; mul 3397 3462; add 3460 3463; constant
12.34285714285715; mul 152 996; mul 3465 3466; sub 3464 3467; constant -7.714285714285722; mul 148 996; mul 3469
3470; sub 3468 3471; mul 143 996; mul 3413 3473; sub 3472 3474; constant -1.7142857142857166; mul 139 996; mul 3476
3477; sub 3475 3478; mul 131 996; mul 3373 3480; sub 3479 3481; constant 1.2; mul 94 996; mul 3483 3484; mul 3397
3485; sub 3482 3486; constant -1.1428571428571423; mul 120 996; mul 3488 3489; sub 3487 3490; mul 116 996; mul 3377
3492; sub 3491 3493; mul 108 996; mul 3428 3495; sub 3494 3496; mul 101 996; mul 3432 3498; mul 3397 3499; sub 3497
3500; mul 148 1627; mul 3370 3502; mul 204 1627; mul 3373 3504; add 3503 3505; mul 143 1627; mul 3377 3507; add 3506
3508; mul 139 1627; mul 3381 3510; add 3509 3511; mul 120 1627; mul 3385 3513; add 3512 3514; mul 116 1627; mul 3389
3516; add 3515 3517; mul 108 1627; mul 3393 3519; add 3518 3520; mul 101 1627; mul 3398 3522; mul 3397 3523; add
3521 3524; mul 164 1627; mul 3403 3526; add 3525 3527; mul 34 1627; mul 3407 3529; mul 3397 3530; add 3528 3531; mul
152 1848; mul 3367 3533; add 3532 3534; mul 148 1848; mul 3413 3536; add 3535 3537; mul 204 1848; mul 3370 3539; add
3538 3540; mul 143 1848; mul 3420 3542; add 3541 3543; mul 139 1848; mul 3424 3545; add 3544 3546; mul 131 1848; mul
3428 3548; add 3547 3549; mul 94 1848; mul 3432 3551; mul 3397 3552; add 3550 3553; mul 120 1848; mul 3437 3555; add
3554 3556; mul 116 1848; mul 3441 3558; add 3557 3559; mul 112 1848; mul 3445 3561; sub 3560 3562; mul 108 1848; mul
3389 3564; add 3563 3565; mul 101 1848; mul 3452 3567; mul 3397 3568; add 3566 3569; mul 164 1848; mul 3457 3571;
add 3570 3572; mul 34 1848; mul 3398 3574; mul 3397 3575; add 3573 3576; mul 152 1733; mul 3465 3578; add 3577 3579;
mul 148 1733; mul 3469 3581; add 3580 3582; mul 143 1733; mul 3413 3584; add 3583 3585; mul 139 1733; mul 3476 3587;
add 3586 3588; mul 131 1733; mul 3373 3590; add 3589 3591; mul 94 1733; mul 3483 3593; mul 3397 3594; add 3592 3595;
mul 120 1733; mul 3488 3597; add 3596 3598; mul 116 1733; mul 3377 3600; add 3599 3601; mul 108 1733; mul 3428 3603;
add 3602 3604; mul 101 1733; mul 3432 3606; mul 3397 3607; add 3605 3608; mul 152 2531; mul 3367 3610; mul 148 2313;
mul 3370 3612; mul 204 2313; mul 3373 3614; add 3613 3615; mul 143 2313; mul 3377 3617; add 3616 3618; mul 139 2313;
mul 3381 3620; add 3619 3621; mul 120 2313; mul 3385 3623; add 3622 3624; mul 116 2313; mul 3389 3626; add 3625
3627; mul 108 2313; mul 3393 3629; add 3628 3630; mul 101 2313; mul 3398 3632; mul 3397 3633; add 3631 3634; mul 164
2313; mul 3403 3636; add 3635 3637; mul 34 2313; mul 3407 3639; mul 3397 3640; add 3638 3641; sub 3611 3642; mul 148
2531; mul 3413 3644; add 3643 3645; mul 204 2531; mul 3370 3647; add 3646 3648; mul 143 2531; mul 3420 3650; add
3649 3651; mul 139 2531; mul 3424 3653; add 3652 3654; mul 131 2531; mul 3428 3656; add 3655 3657; mul 94 2531; mul
3432 3659; mul 3397 3660; add 3658 3661; mul 120 2531; mul 3437 3663; add 3662 3664; mul 116 2531; mul 3441 3666;
add 3665 3667; mul 112 2531; mul 3445 3669; sub 3668 3670; mul 108 2531; mul 3389 3672; add 3671 3673; mul 101 2531;
mul 3452 3675; mul 3397 3676; add 3674 3677; mul 164 2531; mul 3457 3679; add 3678 3680; mul 34 2531; mul 3398 3682;
mul 3397 3683; add 3681 3684; mul 152 2410; mul 3465 3686; sub 3685 3687; mul 148 2410; mul 3469 3689; sub 3688
3690; mul 143 2410; mul 3413 3692; sub 3691 3693; mul 139 2410; mul 3476 3695; sub 3694 3696; mul 131 2410; mul 3373
3698; sub 3697 3699; mul 94 2410; mul 3483 3701; mul 3397 3702; sub 3700 3703; mul 120 2410; mul 3488 3705; sub 3704
3706; mul 116 2410; mul 3377 3708; sub 3707 3709; mul 108 2410; mul 3428 3711; sub 3710 3712; mul 101 2410; mul 3432
3714; mul 3397 3715; sub 3713 3716; constant -129.60000000000008; mul 3368 3718; constant 28.799999999999958; mul
3371 3720; constant 45.25714285714287; mul 3374 3722; add 3721 3723; constant -28.800000000000004; mul 147 877; mul
3725 3726; mul 3445 3727; add 3724 3728; constant -28.799999999999976; mul 3378 3730; add 3729 3731; constant
-45.25714285714286; mul 3382 3733; add 3732 3734; constant 28.79999999999999; mul 135 877; mul 3736 3737; mul 3445
3738; add 3735 3739; constant 7.199999999999994; mul 3386 3741; add 3740 3742; constant 13.714285714285717; mul 3390
3744; add 3743 3745; constant -7.199999999999996; mul 112 877; mul 3747 3748; mul 3445 3749; add 3746 3750; constant
1.3714285714285692; mul 3394 3752; add 3751 3753; constant -4.799999999999999; mul 104 877; mul 3755 3756; mul 3445
3757; add 3754 3758; constant 1.3714285714285714; mul 3404 3760; add 3759 3761; constant -1.3714285714285723; mul
160 877; mul 3763 3764; mul 3445 3765; add 3762 3766; constant 2.400000000000001; mul 3408 3768; mul 3397 3769; add
3767 3770; sub 3719 3771; constant 230.40000000000006; mul 3414 3773; add 3772 3774; mul 3417 3720; add 3775 3776;
constant -36.00000000000001; mul 147 1130; mul 3778 3779; mul 3445 3780; add 3777 3781; constant
-151.20000000000002; mul 3421 3783; add 3782 3784; constant -57.59999999999995; mul 3425 3786; add 3785 3787;
constant 72.0; mul 135 1130; mul 3789 3790; mul 3445 3791; add 3788 3792; constant -22.62857142857143; mul 3429
3794; add 3793 3795; mul 127 1130; mul 3736 3797; mul 3445 3798; add 3796 3799; constant -18.000000000000004; mul
3433 3801; mul 3397 3802; add 3800 3803; constant 35.20000000000001; mul 3438 3805; add 3804 3806; constant
21.59999999999998; mul 3442 3808; add 3807 3809; constant -30.000000000000007; mul 3446 3811; mul 3445 3812; add
3810 3813; mul 3449 3744; add 3814 3815; constant -14.399999999999991; mul 104 1130; mul 3817 3818; mul 3445 3819;
add 3816 3820; mul 596 3453; mul 3397 3822; add 3821 3823; constant 0.4571428571428564; mul 3458 3825; add 3824
3826; constant -2.3999999999999995; mul 160 1130; mul 3828 3829; mul 3445 3830; add 3827 3831; input p 221; constant
-0.9999999999999998; mul 1130 3834; mul 3833 3835; add 3832 3836; constant 259.2000000000001; mul 3466 3838; sub
3837 3839; constant -388.80000000000024; mul 3470 3841; sub 3840 3842; mul 3473 3773; sub 3843 3844; constant
57.599999999999916; mul 3477 3846; sub 3845 3847; constant -72.00000000000001; mul 135 996; mul 3849 3850; mul 3445
3851; sub 3848 3852; mul 3480 3722; sub 3853 3854; constant -57.60000000000001; mul 127 996; mul 3856 3857; mul 3445
3858; sub 3855 3859; constant 36.000000000000014; mul 3484 3861; mul 3397 3862; sub 3860 3863; constant
-50.400000000000006; mul 3489 3865; sub 3864 3866; mul 3492 3730; sub 3867 3868; constant 36.0; mul 112 996; mul
3870 3871; mul 3445 3872; sub 3869 3873; mul 3495 3794; sub 3874 3875; mul 104 996; mul 3736 3877; mul 3445 3878;
sub 3876 3879; mul 3498 3801; mul 3397 3881; sub 3880 3882; mul 3502 3720; mul 3504 3722; add 3884 3885; mul 147
1627; mul 3725 3887; mul 3445 3888; add 3886 3889; mul 3507 3730; add 3890 3891; mul 3510 3733; add 3892 3893; mul
135 1627; mul 3736 3895; mul 3445 3896; add 3894 3897; mul 3513 3741; add 3898 3899; mul 3516 3744; add 3900 3901;
mul 112 1627; mul 3747 3903; mul 3445 3904; add 3902 3905; mul 3519 3752; add 3906 3907; mul 104 1627; mul 3755
3909; mul 3445 3910; add 3908 3911; mul 3526 3760; add 3912 3913; mul 160 1627; mul 3763 3915; mul 3445 3916; add
3914 3917; mul 3529 3768; mul 3397 3919; add 3918 3920; mul 3533 3718; add 3921 3922; mul 3536 3773; add 3923 3924;
mul 3539 3720; add 3925 3926; mul 147 1848; mul 3778 3928; mul 3445 3929; add 3927 3930; mul 3542 3783; add 3931
3932; mul 3545 3786; add 3933 3934; mul 135 1848; mul 3789 3936; mul 3445 3937; add 3935 3938; mul 3548 3794; add
3939 3940; mul 127 1848; mul 3736 3942; mul 3445 3943; add 3941 3944; mul 3551 3801; mul 3397 3946; add 3945 3947;
mul 3555 3805; add 3948 3949; mul 3558 3808; add 3950 3951; mul 3561 3811; mul 3445 3953; add 3952 3954; mul 3564
3744; add 3955 3956; mul 104 1848; mul 3817 3958; mul 3445 3959; add 3957 3960; mul 596 3567; mul 3397 3962; add
3961 3963; mul 3571 3825; add 3964 3965; mul 160 1848; mul 3828 3967; mul 3445 3968; add 3966 3969; mul 1848 3834;
mul 3833 3971; add 3970 3972; mul 3578 3838; add 3973 3974; mul 3581 3841; add 3975 3976; mul 3584 3773; add 3977
3978; mul 3587 3846; add 3979 3980; mul 135 1733; mul 3849 3982; mul 3445 3983; add 3981 3984; mul 3590 3722; add
3985 3986; mul 127 1733; mul 3856 3988; mul 3445 3989; add 3987 3990; mul 3593 3861; mul 3397 3992; add 3991 3993;
mul 3597 3865; add 3994 3995; mul 3600 3730; add 3996 3997; mul 112 1733; mul 3870 3999; mul 3445 4000; add 3998
4001; mul 3603 3794; add 4002 4003; mul 104 1733; mul 3736 4005; mul 3445 4006; add 4004 4007; mul 3606 3801; mul
3397 4009; add 4008 4010; mul 3610 3718; mul 3612 3720; mul 3614 3722; add 4013 4014; mul 147 2313; mul 3725 4016;
mul 3445 4017; add 4015 4018; mul 3617 3730; add 4019 4020; mul 3620 3733; add 4021 4022; mul 135 2313; mul 3736
4024; mul 3445 4025; add 4023 4026; mul 3623 3741; add 4027 4028; mul 3626 3744; add 4029 4030; mul 112 2313; mul
3747 4032; mul 3445 4033; add 4031 4034; mul 3629 3752; add 4035 4036; mul 104 2313; mul 3755 4038; mul 3445 4039;
add 4037 4040; mul 3636 3760; add 4041 4042; mul 160 2313; mul 3763 4044; mul 3445 4045; add 4043 4046; mul 3639
3768; mul 3397 4048; add 4047 4049; sub 4012 4050; mul 3644 3773; add 4051 4052; mul 3647 3720; add 4053 4054; mul
147 2531; mul 3778 4056; mul 3445 4057; add 4055 4058; mul 3650 3783; add 4059 4060; mul 3653 3786; add 4061 4062;
mul 135 2531; mul 3789 4064; mul 3445 4065; add 4063 4066; mul 3656 3794; add 4067 4068; mul 127 2531; mul 3736
4070; mul 3445 4071; add 4069 4072; mul 3659 3801; mul 3397 4074; add 4073 4075; mul 3663 3805; add 4076 4077; mul
3666 3808; add 4078 4079; mul 3669 3811; mul 3445 4081; add 4080 4082; mul 3672 3744; add 4083 4084; mul 104 2531;
mul 3817 4086; mul 3445 4087; add 4085 4088; mul 596 3675; mul 3397 4090; add 4089 4091; mul 3679 3825; add 4092
4093; mul 160 2531; mul 3828 4095; mul 3445 4096; add 4094 4097; mul 2531 3834; mul 3833 4099; add 4098 4100; mul
3686 3838; sub 4101 4102; mul 3689 3841; sub 4103 4104; mul 3692 3773; sub 4105 4106; mul 3695 3846; sub 4107 4108;
mul 135 2410; mul 3849 4110; mul 3445 4111; sub 4109 4112; mul 3698 3722; sub 4113 4114; mul 127 2410; mul 3856
4116; mul 3445 4117; sub 4115 4118; mul 3701 3861; mul 3397 4120; sub 4119 4121; mul 3705 3865; sub 4122 4123; mul
3708 3730; sub 4124 4125; mul 112 2410; mul 3870 4127; mul 3445 4128; sub 4126 4129; mul 3711 3794; sub 4130 4131;
mul 104 2410; mul 3736 4133; mul 3445 4134; sub 4132 4135; mul 3714 3801; mul 3397 4137; sub 4136 4138; constant
-0.04285714285714284; mul 148 873; mul 4140 4141; constant 0.029931972789115628; mul 204 873; mul 4143 4144; add
4142 4145; constant -0.0013605442176870806; mul 139 873; mul 4147 4148; add 4146 4149; constant
-0.003571428571428574; mul 120 873; mul 4151 4152; add 4150 4153; constant 0.0027210884353741486; mul 116 873; mul
4155 4156; add 4154 4157; constant -0.0014361300075585765; mul 108 873; mul 4159 4160; add 4158 4161; constant
0.00032473894907757275; mul 164 873; mul 4163 4164; add 4162 4165; constant -0.12857142857142845; mul 152 918; mul
4167 4168; add 4166 4169; constant 0.12857142857142853; mul 148 918; mul 4171 4172; add 4170 4173; mul 204 918; mul
4140 4175; add 4174 4176; constant 0.010714285714285735; mul 143 918; mul 4178 4179; add 4177 4180; constant
-0.0006802721088435403; mul 131 918; mul 4182 4183; add 4181 4184; constant 0.028571428571428567; mul 120 918; mul
4186 4187; add 4185 4188; constant -0.010714285714285721; mul 116 918; mul 4190 4191; add 4189 4192; mul 108 918;
mul 4155 4194; add 4193 4195; constant -0.0004787100025195255; mul 164 918; mul 4197 4198; add 4196 4199; constant
1.0285714285714285; mul 152 944; mul 4201 4202; add 4200 4203; constant -0.38571428571428534; mul 148 944; mul 4205
4206; add 4204 4207; mul 143 944; mul 4171 4209; add 4208 4210; constant -0.08571428571428567; mul 139 944; mul 4212
4213; add 4211 4214; mul 131 944; mul 4143 4216; add 4215 4217; constant 0.0035714285714285787; mul 120 944; mul
4219 4220; add 4218 4221; mul 108 944; mul 4182 4223; add 4222 4224; mul 148 1653; mul 4140 4226; mul 204 1653; mul
4143 4228; add 4227 4229; mul 139 1653; mul 4147 4231; add 4230 4232; mul 120 1653; mul 4151 4234; add 4233 4235;
mul 116 1653; mul 4155 4237; add 4236 4238; mul 108 1653; mul 4159 4240; add 4239 4241; mul 164 1653; mul 4163 4243;
add 4242 4244; mul 152 1674; mul 4167 4246; add 4245 4247; mul 148 1674; mul 4171 4249; add 4248 4250; mul 204 1674;
mul 4140 4252; add 4251 4253; mul 143 1674; mul 4178 4255; add 4254 4256; mul 131 1674; mul 4182 4258; add 4257
4259; mul 120 1674; mul 4186 4261; add 4260 4262; mul 116 1674; mul 4190 4264; add 4263 4265; mul 108 1674; mul 4155
4267; add 4266 4268; mul 164 1674; mul 4197 4270; add 4269 4271; mul 152 1700; mul 4201 4273; add 4272 4274; mul 148
1700; mul 4205 4276; add 4275 4277; mul 143 1700; mul 4171 4279; add 4278 4280; mul 139 1700; mul 4212 4282; add
4281 4283; mul 131 1700; mul 4143 4285; add 4284 4286; mul 120 1700; mul 4219 4288; add 4287 4289; mul 108 1700; mul
4182 4291; add 4290 4292; mul 148 2309; mul 4140 4294; mul 204 2309; mul 4143 4296; add 4295 4297; mul 139 2309; mul
4147 4299; add 4298 4300; mul 120 2309; mul 4151 4302; add 4301 4303; mul 116 2309; mul 4155 4305; add 4304 4306;
mul 108 2309; mul 4159 4308; add 4307 4309; mul 164 2309; mul 4163 4311; add 4310 4312; mul 152 2352; mul 4167 4314;
add 4313 4315; mul 148 2352; mul 4171 4317; add 4316 4318; mul 204 2352; mul 4140 4320; add 4319 4321; mul 143 2352;
mul 4178 4323; add 4322 4324; mul 131 2352; mul 4182 4326; add 4325 4327; mul 120 2352; mul 4186 4329; add 4328
4330; mul 116 2352; mul 4190 4332; add 4331 4333; mul 108 2352; mul 4155 4335; add 4334 4336; mul 164 2352; mul 4197
4338; add 4337 4339; mul 152 2378; mul 4201 4341; add 4340 4342; mul 148 2378; mul 4205 4344; add 4343 4345; mul 143
2378; mul 4171 4347; add 4346 4348; mul 139 2378; mul 4212 4350; add 4349 4351; mul 131 2378; mul 4143 4353; add
4352 4354; mul 120 2378; mul 4219 4356; add 4355 4357; mul 108 2378; mul 4182 4359; add 4358 4360; mul 148 2830; mul
4140 4362; mul 204 2830; mul 4143 4364; add 4363 4365; mul 139 2830; mul 4147 4367; add 4366 4368; mul 120 2830; mul
4151 4370; add 4369 4371; mul 116 2830; mul 4155 4373; add 4372 4374; mul 108 2830; mul 4159 4376; add 4375 4377;
mul 164 2830; mul 4163 4379; add 4378 4380; mul 152 2850; mul 4167 4382; add 4381 4383; mul 148 2850; mul 4171 4385;
add 4384 4386; mul 204 2850; mul 4140 4388; add 4387 4389; mul 143 2850; mul 4178 4391; add 4390 4392; mul 131 2850;
mul 4182 4394; add 4393 4395; mul 120 2850; mul 4186 4397; add 4396 4398; mul 116 2850; mul 4190 4400; add 4399
4401; mul 108 2850; mul 4155 4403; add 4402 4404; mul 164 2850; mul 4197 4406; add 4405 4407; mul 152 2876; mul 4201
4409; add 4408 4410; mul 148 2876; mul 4205 4412; add 4411 4413; mul 143 2876; mul 4171 4415; add 4414 4416; mul 139
2876; mul 4212 4418; add 4417 4419; mul 131 2876; mul 4143 4421; add 4420 4422; mul 120 2876; mul 4219 4424; add
4423 4425; mul 108 2876; mul 4182 4427; add 4426 4428; mul 148 3018; mul 4140 4430; mul 204 3018; mul 4143 4432; add
4431 4433; mul 139 3018; mul 4147 4435; add 4434 4436; mul 120 3018; mul 4151 4438; add 4437 4439; mul 116 3018; mul
4155 4441; add 4440 4442; mul 108 3018; mul 4159 4444; add 4443 4445; mul 164 3018; mul 4163 4447; add 4446 4448;
mul 152 3038; mul 4167 4450; add 4449 4451; mul 148 3038; mul 4171 4453; add 4452 4454; mul 204 3038; mul 4140 4456;
add 4455 4457; mul 143 3038; mul 4178 4459; add 4458 4460; mul 131 3038; mul 4182 4462; add 4461 4463; mul 120 3038;
mul 4186 4465; add 4464 4466; mul 116 3038; mul 4190 4468; add 4467 4469; mul 108 3038; mul 4155 4471; add 4470
4472; mul 164 3038; mul 4197 4474; add 4473 4475; mul 152 3064; mul 4201 4477; add 4476 4478; mul 148 3064; mul 4205
4480; add 4479 4481; mul 143 3064; mul 4171 4483; add 4482 4484; mul 139 3064; mul 4212 4486; add 4485 4487; mul 131
3064; mul 4143 4489; add 4488 4490; mul 120 3064; mul 4219 4492; add 4491 4493; mul 108 3064; mul 4182 4495; add
4494 4496; input p 222; mul 3780 4498; mul 3727 4498; mul 3738 4498; add 4500 4501; mul 3749 4498; add 4502 4503;
mul 3757 4498; add 4504 4505; input p 223; input p 224; mul 3400 4508; mul 4507 4509; add 4506 4510; mul 3765 4498;
add 4511 4512; mul 3409 4508; mul 4507 4514; add 4513 4515; mul 3769 4498; mul 4507 4517; add 4516 4518; sub 4499
4519; mul 3791 4498; add 4520 4521; mul 3798 4498; add 4522 4523; mul 3434 4508; mul 4507 4525; add 4524 4526; mul
3802 4498; mul 4507 4528; add 4527 4529; mul 3446 4508; sub 4530 4531; mul 3812 4498; add 4532 4533; mul 3819 4498;
add 4534 4535; mul 3454 4508; mul 4507 4537; add 4536 4538; mul 3822 4498; mul 4507 4540; add 4539 4541; mul 3830
4498; add 4542 4543; mul 3462 4508; mul 4507 4545; add 4544 4546; mul 3835 4498; mul 3397 4548; add 4547 4549; mul
3445 4548; mul 4507 4551; add 4550 4552; add 3835 4553; mul 3851 4498; sub 4554 4555; mul 3858 4498; sub 4556 4557;
mul 3485 4508; mul 4507 4559; sub 4558 4560; mul 3862 4498; mul 4507 4562; sub 4561 4563; mul 3872 4498; sub 4564
4565; mul 3878 4498; sub 4566 4567; mul 3499 4508; mul 4507 4569; sub 4568 4570; mul 3881 4498; mul 4507 4572; sub
4571 4573; mul 3888 4498; mul 3896 4498; add 4575 4576; mul 3904 4498; add 4577 4578; mul 3910 4498; add 4579 4580;
mul 3523 4508; mul 4507 4582; add 4581 4583; mul 3916 4498; add 4584 4585; mul 3530 4508; mul 4507 4587; add 4586
4588; mul 3919 4498; mul 4507 4590; add 4589 4591; mul 3929 4498; add 4592 4593; mul 3937 4498; add 4594 4595; mul
3943 4498; add 4596 4597; mul 3552 4508; mul 4507 4599; add 4598 4600; mul 3946 4498; mul 4507 4602; add 4601 4603;
mul 3561 4508; sub 4604 4605; mul 3953 4498; add 4606 4607; mul 3959 4498; add 4608 4609; mul 3568 4508; mul 4507
4611; add 4610 4612; mul 3962 4498; mul 4507 4614; add 4613 4615; mul 3968 4498; add 4616 4617; mul 3575 4508; mul
4507 4619; add 4618 4620; mul 3971 4498; mul 3397 4622; add 4621 4623; mul 3445 4622; mul 4507 4625; add 4624 4626;
add 3971 4627; mul 3983 4498; add 4628 4629; mul 3989 4498; add 4630 4631; mul 3594 4508; mul 4507 4633; add 4632
4634; mul 3992 4498; mul 4507 4636; add 4635 4637; mul 4000 4498; add 4638 4639; mul 4006 4498; add 4640 4641; mul
3607 4508; mul 4507 4643; add 4642 4644; mul 4009 4498; mul 4507 4646; add 4645 4647; mul 4057 4498; mul 4017 4498;
mul 4025 4498; add 4650 4651; mul 4033 4498; add 4652 4653; mul 4039 4498; add 4654 4655; mul 3633 4508; mul 4507
4657; add 4656 4658; mul 4045 4498; add 4659 4660; mul 3640 4508; mul 4507 4662; add 4661 4663; mul 4048 4498; mul
4507 4665; add 4664 4666; sub 4649 4667; mul 4065 4498; add 4668 4669; mul 4071 4498; add 4670 4671; mul 3660 4508;
mul 4507 4673; add 4672 4674; mul 4074 4498; mul 4507 4676; add 4675 4677; mul 3669 4508; sub 4678 4679; mul 4081
4498; add 4680 4681; mul 4087 4498; add 4682 4683; mul 3676 4508; mul 4507 4685; add 4684 4686; mul 4090 4498; mul
4507 4688; add 4687 4689; mul 4096 4498; add 4690 4691; mul 3683 4508; mul 4507 4693; add 4692 4694; mul 4099 4498;
mul 3397 4696; add 4695 4697; mul 3445 4696; mul 4507 4699; add 4698 4700; add 4099 4701; mul 4111 4498; sub 4702
4703; mul 4117 4498; sub 4704 4705; mul 3702 4508; mul 4507 4707; sub 4706 4708; mul 4120 4498; mul 4507 4710; sub
4709 4711; mul 4128 4498; sub 4712 4713; mul 4134 4498; sub 4714 4715; mul 3715 4508; mul 4507 4717; sub 4716 4718;
mul 4137 4498; mul 4507 4720; sub 4719 4721; mul 478 755; mul 611 626; sub 4723 4724; mul 341 914; add 4725 4726;
mul 211 996; sub 4727 4728; mul 94 1355; add 4729 4730; mul 611 1423; mul 478 1533; add 4732 4733; mul 341 1670; sub
4734 4735; mul 211 1733; add 4736 4737; mul 94 2068; add 4738 4739; mul 478 2210; mul 611 2100; sub 4741 4742; mul
341 2348; add 4743 4744; mul 211 2410; sub 4745 4746; mul 94 2751; add 4747 4748; mul 341 2846; mul 94 2955; add
4750 4751; mul 341 3034; mul 94 3143; add 4753 4754; mul 611 618; mul 211 992; add 4756 4757; mul 465 755; add 4758
4759; mul 341 911; add 4760 4761; mul 2 1355; add 4762 4763; mul 465 1533; mul 611 1411; mul 211 1728; add 4766
4767; sub 4765 4768; mul 341 1666; add 4769 4770; mul 2 2068; add 4771 4772; mul 611 1420; mul 211 1627; add 4774
4775; mul 465 2210; add 4776 4777; mul 341 2345; add 4778 4779; mul 2 2751; add 4780 4781; mul 341 2843; mul 2 2955;
add 4783 4784; mul 341 3031; mul 2 3143; add 4786 4787; mul 489 755; mul 611 622; mul 211 877; add 4790 4791; sub
4789 4792; mul 341 869; add 4793 4794; mul 34 1355; add 4795 4796; mul 489 1533; add 4776 4798; mul 341 1652; sub
4799 4800; mul 34 2068; add 4801 4802; mul 489 2210; mul 611 2096; mul 211 2313; add 4805 4806; sub 4804 4807; mul
341 2305; add 4808 4809; mul 34 2751; add 4810 4811; mul 341 2826; mul 34 2955; add 4813 4814; mul 341 3014; mul 34
3143; add 4816 4817; mul 7 15; mul 16 465; mul 465 4820; mul 22 4821; mul 21 89; mul 21 618; mul 25 4824; sub 4823
4825; mul 4822 4826; mul 23 4827; mul 618 4821; mul 18 4829; sub 4828 4830; mul 40 4824; mul 21 622; mul 52 4833;
sub 4832 4834; mul 66 4823; sub 4835 4836; mul 4822 4837; mul 37 4838; sub 4831 4839; mul 2 4840; mul 4819 4841; mul
4819 4842; mul 8 4841; mul 8 4844; mul 406 4845; add 4843 4846; mul 15 16; mul 580 638; input p 145; mul 37 4850;
mul 618 4851; sub 4849 4852; mul 471 777; add 4853 4854; mul 4848 4855; mul 13 4856; mul 8 8; mul 15 4855; mul 4858
4859; add 4857 4860; mul 8 37; mul 511 640; mul 502 4863; mul 16 618; mul 4850 4865; mul 504 640; mul 499 4867; add
4866 4868; sub 4864 4869; mul 502 723; add 4870 4871; mul 520 699; mul 575 640; add 4873 4874; mul 406 511; mul 721
4876; add 4875 4877; mul 499 4878; add 4872 4879; mul 387 779; mul 382 4881; sub 4880 4882; mul 394 779; mul 385
4884; sub 4883 4885; mul 385 862; sub 4886 4887; mul 403 838; mul 466 779; add 4889 4890; mul 394 406; mul 860 4892;
add 4891 4893; mul 382 4894; add 4888 4895; mul 4862 4896; add 4861 4897; mul 8 23; mul 502 4867; mul 499 4863; add
4900 4901; mul 499 723; add 4902 4903; mul 502 4878; sub 4904 4905; mul 385 4881; sub 4906 4907; mul 382 4884; add
4908 4909; mul 382 862; add 4910 4911; mul 385 4894; add 4912 4913; mul 4899 4914; add 4898 4915; mul 7 406; div 1
4917; mul 4916 4918; mul 2 4919; mul 2 4920; sub 4847 4921; mul 8 4914; mul 7 4856; sub 4923 4924; mul 13 406; div 1
4926; mul 4925 4927; mul 2 4928; mul 2 4929; add 4922 4930; input p 131; mul 8 4932; mul 8 4933; mul 9 4819; mul
4819 4935; add 4934 4936; mul 2 4937; mul 4827 4938; mul 91 3247; mul 91 3210; where 978 4941; add 4940 4942; mul
488 592; sub 4943 4944; input p 170; mul 489 4946; mul 99 611; add 4947 4948; add 4945 4949; mul 61 474; mul 27 465;
add 4951 4952; mul 46 489; add 4953 4954; mul 474 4955; mul 27 474; mul 30 465; add 4957 4958; mul 33 489; add 4959
4960; mul 465 4961; add 4956 4962; mul 46 474; mul 33 465; add 4964 4965; mul 50 489; add 4966 4967; mul 489 4968;
add 4963 4969; mul 37 4938; sub 24 4971; mul 4822 4972; add 4970 4973; mul 52 4974; mul 21 4975; add 4950 4976; mul
88 622; mul 4977 4978; mul 91 3290; mul 91 3286; where 990 4981; add 4980 4982; mul 482 592; sub 4983 4984; mul 96
611; add 4985 4986; mul 472 495; mul 581 589; add 4988 4989; add 4987 4990; sub 1380 4991; mul 16 4851; add 4992
4993; input p 122; input z 0; mul 4995 4996; input p 123; input z 1; mul 4998 4999; add 4997 5000; input p 124;
input z 2; mul 5002 5003; add 5001 5004; input p 125; input z 3; mul 5006 5007; add 5005 5008; input p 146; mul 5009
5010; sub 4994 5011; mul 40 4974; mul 23 4938; add 38 5014; mul 4822 5015; mul 25 5016; sub 5013 5017; mul 21 5018;
mul 18 4938; mul 4821 5020; sub 5019 5021; sub 5012 5022; mul 88 618; mul 5023 5024; add 4979 5025; input c 0; input
c 2; mul 425 5028; add 5027 5029; input c 3; mul 538 5031; add 5030 5032; mul 1364 1398; add 5033 5034; mul 1362
1380; sub 5035 5036; input p 16; input c 1; add 5038 5039; constant 0.0; max 5040 5041; mul 474 5042; sub 5037 5043;
mul 475 495; mul 583 589; add 5045 5046; sub 615 5047; sub 5044 5048; input p 121; sub 5050 5009; input p 126; abs
474; mul 5052 5053; mul 474 5054; input p 127; mul 474 5056; mul 474 474; input p 128; add 5058 5059; sqrt 5060; div
1 5061; mul 5057 5062; add 5055 5063; sub 5051 5064; add 5049 5065; input p 129; input x 12; sub 28 5068; mul 5067
5069; input p 130; input x 13; sub 28 5072; mul 5071 5073; add 5070 5074; sub 5066 5075; mul 66 4974; sub 5077 5016;
mul 21 5078; sub 5076 5079; mul 88 89; mul 5080 5081; sub 5026 5082; mul 78 5083; mul 58 5084; mul 75 5083; mul 55
5086; sub 5085 5087; mul 21 5088; mul 4824 5016; sub 5089 5090; mul 88 4977; mul 58 5092; mul 88 5023; mul 55 5094;
add 5093 5095; mul 80 5083; add 5096 5097; mul 21 5098; sub 5091 5099; mul 25 406; mul 78 5092; mul 78 5084; sub
5102 5103; mul 69 5083; mul 55 5105; add 5104 5106; mul 88 5080; mul 55 5108; add 5107 5109; mul 21 5110; mul 5101
5111; add 5100 5112; mul 22 5113; add 4838 5114; mul 16 5115; add 4939 5116; mul 8 5117; mul 15 4819; mul 4841 4935;
mul 9 4842; add 5120 5121; mul 5119 5122; mul 4826 5015; mul 22 5124; mul 618 5020; sub 5125 5126; mul 4837 4972;
mul 22 5128; add 5127 5129; mul 465 5130; mul 465 5131; mul 4824 4974; mul 66 5089; add 5133 5134; mul 66 5099; sub
5135 5136; mul 78 5094; mul 75 5084; add 5138 5139; mul 58 5105; sub 5140 5141; mul 58 5108; sub 5142 5143; mul 21
5144; mul 52 5145; add 5137 5146; mul 78 5086; mul 75 5092; sub 5148 5149; sub 5150 5141; sub 5151 5143; mul 21
5152; mul 52 5153; add 5147 5154; mul 40 406; mul 5111 5156; add 5155 5157; mul 22 5158; add 4827 5159; mul 37 5160;
add 5132 5161; mul 23 5115; add 5162 5163; mul 18 5110; add 5164 5165; mul 16 5110; mul 4829 4938; sub 5167 5168;
mul 17 5169; add 5166 5170; mul 4848 5171; add 5123 5172; mul 7 5173; sub 5118 5174; mul 4927 5175; mul 2 5176; mul
2 5177; add 4931 5178; mul 15 5122; mul 8 4934; mul 4841 5181; sub 5180 5182; mul 4844 4934; sub 5183 5184; mul 16
5160; mul 4838 4938; sub 5186 5187; mul 4862 5188; sub 5185 5189; mul 4899 5117; sub 5190 5191; mul 13 5173; sub
5192 5193; mul 15 5171; mul 4858 5195; sub 5194 5196; mul 4918 5197; mul 2 5198; mul 2 5199; add 5179 5200; mul 1411
4821; mul 18 5202; mul 21 1411; mul 25 5204; sub 5205 4824; mul 4822 5206; mul 23 5207; add 5203 5208; mul 21 1420;
mul 52 5210; mul 40 5204; sub 5211 5212; mul 66 4824; add 5213 5214; mul 4822 5215; mul 37 5216; sub 5209 5217; mul
2 5218; mul 4819 5219; mul 4819 5220; mul 8 5219; mul 8 5222; mul 406 5223; add 5221 5224; mul 1411 4851; mul 580
1488; sub 5226 5227; mul 471 1551; sub 5228 5229; mul 4848 5230; mul 13 5231; mul 15 5230; mul 4858 5233; add 5232
5234; mul 16 1411; mul 4850 5236; mul 504 1512; mul 499 5238; add 5237 5239; mul 511 1512; mul 502 5241; sub 5240
5242; mul 502 1515; add 5243 5244; mul 520 1479; mul 575 1512; sub 5246 5247; mul 1509 4876; add 5248 5249; mul 499
5250; add 5245 5251; mul 387 1553; mul 382 5253; add 5252 5254; mul 394 1553; mul 385 5256; add 5255 5257; mul 385
1622; sub 5258 5259; mul 403 1597; mul 466 1553; sub 5261 5262; mul 1620 4892; add 5263 5264; mul 382 5265; add 5260
5266; mul 4862 5267; add 5235 5268; mul 499 1515; mul 502 5238; mul 499 5241; add 5271 5272; sub 5270 5273; mul 502
5250; sub 5274 5275; mul 385 5253; add 5276 5277; mul 382 5256; sub 5278 5279; mul 382 1622; add 5280 5281; mul 385
5265; add 5282 5283; mul 4899 5284; add 5269 5285; mul 4918 5286; mul 2 5287; mul 2 5288; sub 5225 5289; mul 8 5284;
mul 7 5231; sub 5291 5292; mul 4927 5293; mul 2 5294; mul 2 5295; add 5290 5296; mul 4938 5207; mul 5016 5204; mul
5024 5080; mul 88 1420; mul 4977 5301; sub 5300 5302; mul 88 1411; mul 5023 5304; sub 5303 5305; mul 78 5306; mul 58
5307; add 5102 5109; sub 5308 5309; mul 75 5306; mul 55 5311; sub 5310 5312; mul 21 5313; add 5299 5314; mul 80
5306; mul 21 5316; sub 5315 5317; mul 69 5306; mul 55 5319; mul 78 5307; sub 5320 5321; mul 21 5322; mul 5101 5323;
add 5318 5324; mul 22 5325; add 5216 5326; mul 16 5327; add 5298 5328; mul 8 5329; mul 4935 5219; mul 9 5220; add
5331 5332; mul 5119 5333; mul 1411 5020; mul 5015 5206; mul 22 5336; add 5335 5337; mul 4972 5215; mul 22 5339; add
5338 5340; mul 465 5341; mul 465 5342; mul 66 5314; mul 4974 5204; sub 5344 5345; mul 66 5317; sub 5346 5347; mul 75
5307; mul 58 5319; sub 5349 5350; mul 21 5351; mul 52 5352; add 5348 5353; mul 69 5092; mul 78 5108; add 5355 5356;
mul 78 5311; add 5357 5358; sub 5359 5350; mul 21 5360; mul 52 5361; add 5354 5362; mul 5156 5323; add 5363 5364;
mul 22 5365; add 5207 5366; mul 37 5367; add 5343 5368; mul 23 5327; add 5369 5370; mul 18 5322; add 5371 5372; mul
4938 5202; mul 16 5322; add 5374 5375; mul 17 5376; add 5373 5377; mul 4848 5378; add 5334 5379; mul 7 5380; sub
5330 5381; mul 4927 5382; mul 2 5383; mul 2 5384; add 5297 5385; mul 15 5333; mul 5181 5219; sub 5387 5388; mul 4934
5222; sub 5389 5390; mul 16 5367; mul 4938 5216; sub 5392 5393; mul 4862 5394; sub 5391 5395; mul 4899 5329; sub
5396 5397; mul 13 5380; sub 5398 5399; mul 15 5378; mul 4858 5401; sub 5400 5402; mul 4918 5403; mul 2 5404; mul 2
5405; add 5386 5406; mul 25 5210; sub 4833 5408; mul 4822 5409; mul 23 5410; mul 1420 4821; mul 18 5412; sub 5411
5413; mul 40 5210; mul 21 2096; mul 52 5416; sub 5415 5417; mul 66 4833; sub 5418 5419; mul 4822 5420; mul 37 5421;
sub 5414 5422; mul 2 5423; mul 4819 5424; mul 4819 5425; mul 8 5424; mul 8 5427; mul 406 5428; add 5426 5429; mul
580 2112; mul 1420 4851; sub 5431 5432; mul 471 2232; add 5433 5434; mul 4848 5435; mul 13 5436; mul 15 5435; mul
4858 5438; add 5437 5439; mul 511 2114; mul 502 5441; mul 16 1420; mul 4850 5443; mul 504 2114; mul 499 5445; add
5444 5446; sub 5442 5447; mul 502 2180; add 5448 5449; mul 520 2156; mul 575 2114; add 5451 5452; mul 2178 4876; add
5453 5454; mul 499 5455; add 5450 5456; mul 387 2234; mul 382 5458; sub 5457 5459; mul 394 2234; mul 385 5461; sub
5460 5462; mul 385 2300; sub 5463 5464; mul 403 2276; mul 466 2234; add 5466 5467; mul 2298 4892; add 5468 5469; mul
382 5470; add 5465 5471; mul 4862 5472; add 5440 5473; mul 502 5445; mul 499 5441; add 5475 5476; mul 499 2180; add
5477 5478; mul 502 5455; sub 5479 5480; mul 385 5458; sub 5481 5482; mul 382 5461; add 5483 5484; mul 382 2300; add
5485 5486; mul 385 5470; add 5487 5488; mul 4899 5489; add 5474 5490; mul 4918 5491; mul 2 5492; mul 2 5493; sub
5430 5494; mul 8 5489; mul 7 5436; sub 5496 5497; mul 4927 5498; mul 2 5499; mul 2 5500; add 5495 5501; mul 4938
5410; add 5143 5149; mul 88 2096; mul 4977 5505; mul 5023 5301; add 5506 5507; mul 4978 5080; sub 5508 5509; mul 78
5510; mul 58 5511; add 5504 5512; mul 75 5510; mul 55 5514; sub 5513 5515; mul 21 5516; mul 5016 5210; sub 5517
5518; add 5138 5149; mul 80 5510; sub 5520 5521; mul 21 5522; add 5519 5523; mul 69 5510; mul 55 5525; mul 78 5511;
add 5357 5527; sub 5526 5528; mul 21 5529; mul 5101 5530; add 5524 5531; mul 22 5532; add 5421 5533; mul 16 5534;
add 5503 5535; mul 8 5536; mul 4935 5424; mul 9 5425; add 5538 5539; mul 5119 5540; mul 5015 5409; mul 22 5542; mul
1420 5020; sub 5543 5544; mul 4972 5420; mul 22 5546; add 5545 5547; mul 465 5548; mul 465 5549; mul 4974 5210; mul
66 5517; add 5551 5552; mul 66 5523; add 5553 5554; mul 75 5108; mul 69 5094; sub 5556 5557; mul 75 5511; add 5558
5559; mul 58 5525; sub 5560 5561; mul 21 5562; mul 52 5563; add 5555 5564; mul 78 5514; sub 5566 5561; mul 21 5567;
mul 52 5568; add 5565 5569; mul 5156 5530; add 5570 5571; mul 22 5572; add 5410 5573; mul 37 5574; add 5550 5575;
mul 23 5534; add 5576 5577; mul 18 5529; add 5578 5579; mul 16 5529; mul 4938 5412; sub 5581 5582; mul 17 5583; add
5580 5584; mul 4848 5585; add 5541 5586; mul 7 5587; sub 5537 5588; mul 4927 5589; mul 2 5590; mul 2 5591; add 5502
5592; mul 15 5540; mul 5181 5424; sub 5594 5595; mul 4934 5427; sub 5596 5597; mul 16 5574; mul 4938 5421; sub 5599
5600; mul 4862 5601; sub 5598 5602; mul 4899 5536; sub 5603 5604; mul 13 5587; sub 5605 5606; mul 15 5585; mul 4858
5608; sub 5607 5609; mul 4918 5610; mul 2 5611; mul 2 5612; add 5593 5613; mul 394 2790; mul 382 5615; mul 387 2790;
mul 385 5617; sub 5616 5618; mul 382 2822; add 5619 5620; mul 466 2790; mul 403 2808; sub 5622 5623; mul 2820 4892;
add 5624 5625; mul 385 5626; add 5621 5627; mul 8 5628; mul 471 2788; mul 4848 5630; mul 7 5631; sub 5629 5632; mul
4927 5633; mul 2 5634; mul 2 5635; mul 13 5631; mul 15 5630; mul 4858 5638; add 5637 5639; mul 382 5626; mul 382
5617; mul 385 5615; add 5642 5643; mul 385 2822; add 5644 5645; sub 5641 5646; mul 4862 5647; add 5640 5648; mul
4899 5628; add 5649 5650; mul 4918 5651; mul 2 5652; mul 2 5653; sub 5636 5654; mul 504 2967; mul 502 5656; mul 511
2967; mul 499 5658; add 5657 5659; mul 499 2999; add 5660 5661; mul 575 2967; mul 520 2985; sub 5663 5664; mul 2997
4876; add 5665 5666; mul 502 5667; sub 5662 5668; mul 8 5669; mul 580 2965; mul 4848 5671; mul 7 5672; sub 5670
5673; mul 4927 5674; mul 2 5675; mul 2 5676; mul 13 5672; mul 15 5671; mul 4858 5679; add 5678 5680; mul 502 5658;
mul 499 5656; sub 5682 5683; mul 502 2999; add 5684 5685; mul 499 5667; add 5686 5687; mul 4862 5688; add 5681 5689;
mul 4899 5669; add 5690 5691; mul 4918 5692; mul 2 5693; mul 2 5694; sub 5677 5695; mul 255 996; mul 608 5697; neg
5698; where 217 5699; mul 255 1733; mul 608 5701; where 217 5702; mul 255 2410; mul 608 5704; neg 5705; where 217
5706; mul 255 992; where 990 5708; mul 258 996; mul 980 5710; neg 5711; where 217 5712; add 5709 5713; mul 255 1728;
neg 5715; where 990 5716; mul 258 1733; mul 980 5718; where 217 5719; add 5717 5720; mul 255 1627; where 990 5722;
mul 258 2410; mul 980 5724; neg 5725; where 217 5726; add 5723 5727; mul 255 877; neg 5729; where 978 5730; mul 262
996; mul 980 5732; neg 5733; where 217 5734; add 5731 5735; where 978 5722; mul 262 1733; mul 980 5738; where 217
5739; add 5737 5740; mul 255 2313; neg 5742; where 978 5743; mul 262 2410; mul 980 5745; neg 5746; where 217 5747;
add 5744 5748; mul 258 992; mul 406 5750; where 990 5751; mul 266 996; neg 5753; mul 406 5754; where 217 5755; add
5752 5756; mul 258 1728; neg 5758; mul 406 5759; where 990 5760; mul 266 1733; mul 406 5762; where 217 5763; add
5761 5764; mul 258 1627; mul 406 5766; where 990 5767; mul 266 2410; neg 5769; mul 406 5770; where 217 5771; add
5768 5772; mul 258 877; neg 5774; where 978 5775; mul 262 992; where 990 5777; add 5776 5778; mul 270 996; neg 5780;
mul 406 5781; where 217 5782; add 5779 5783; where 978 5766; mul 262 1728; neg 5786; where 990 5787; add 5785 5788;
mul 270 1733; mul 406 5790; where 217 5791; add 5789 5792; mul 258 2313; neg 5794; where 978 5795; mul 262 1627;
where 990 5797; add 5796 5798; mul 270 2410; neg 5800; mul 406 5801; where 217 5802; add 5799 5803; mul 262 877; neg
5805; mul 406 5806; where 978 5807; mul 274 996; neg 5809; mul 406 5810; where 217 5811; add 5808 5812; mul 406
5797; where 978 5814; mul 274 1733; mul 406 5816; where 217 5817; add 5815 5818; mul 262 2313; neg 5820; mul 406
5821; where 978 5822; mul 274 2410; neg 5824; mul 406 5825; where 217 5826; add 5823 5827; mul 266 992; mul 980
5829; where 990 5830; mul 278 996; neg 5832; where 217 5833; add 5831 5834; mul 266 1728; mul 980 5836; neg 5837;
where 990 5838; mul 278 1733; where 217 5840; add 5839 5841; mul 266 1627; mul 980 5843; where 990 5844; mul 278
2410; neg 5846; where 217 5847; add 5845 5848; mul 266 877; neg 5850; where 978 5851; mul 270 992; mul 406 5853;
where 990 5854; add 5852 5855; mul 282 996; neg 5857; where 217 5858; add 5856 5859; where 978 5843; mul 270 1728;
neg 5862; mul 406 5863; where 990 5864; add 5861 5865; mul 282 1733; where 217 5867; add 5866 5868; mul 266 2313;
neg 5870; where 978 5871; mul 270 1627; mul 406 5873; where 990 5874; add 5872 5875; mul 282 2410; neg 5877; where
217 5878; add 5876 5879; mul 270 877; neg 5881; mul 406 5882; where 978 5883; mul 274 992; where 990 5885; add 5884
5886; mul 286 996; neg 5888; where 217 5889; add 5887 5890; where 978 5874; mul 274 1728; neg 5893; where 990 5894;
add 5892 5895; mul 286 1733; where 217 5897; add 5896 5898; mul 270 2313; neg 5900; mul 406 5901; where 978 5902;
mul 274 1627; where 990 5904; add 5903 5905; mul 286 2410; neg 5907; where 217 5908; add 5906 5909; mul 274 877; mul
980 5911; neg 5912; where 978 5913; neg 1026; where 217 5915; add 5914 5916; mul 980 5904; where 978 5918; where 217
1759; add 5919 5920; mul 274 2313; mul 980 5922; neg 5923; where 978 5924; neg 2436; where 217 5926; add 5925 5927;
mul 278 992; mul 608 5929; where 990 5930; mul 278 1728; mul 608 5932; neg 5933; where 990 5934; mul 278 1627; mul
608 5936; where 990 5937; mul 278 877; neg 5939; where 978 5940; mul 282 992; mul 980 5942; where 990 5943; add 5941
5944; where 978 5936; mul 282 1728; mul 980 5947; neg 5948; where 990 5949; add 5946 5950; mul 278 2313; neg 5952;
where 978 5953; mul 282 1627; mul 980 5955; where 990 5956; add 5954 5957; mul 282 877; neg 5959; mul 406 5960;
where 978 5961; mul 286 992; mul 406 5963; where 990 5964; add 5962 5965; mul 406 5955; where 978 5967; mul 286
1728; neg 5969; mul 406 5970; where 990 5971; add 5968 5972; mul 282 2313; neg 5974; mul 406 5975; where 978 5976;
mul 286 1627; mul 406 5978; where 990 5979; add 5977 5980; mul 286 877; mul 980 5982; neg 5983; where 978 5984;
where 990 1007; add 5985 5986; mul 980 5978; where 978 5988; neg 1741; where 990 5990; add 5989 5991; mul 286 2313;
mul 980 5993; neg 5994; where 978 5995; where 990 1738; add 5996 5997; mul 608 1003; neg 5999; where 978 6000; mul
608 1738; where 978 6002; mul 608 2416; neg 6004; where 978 6005; mul 255 982; neg 6007; where 978 6008; mul 222
1026; mul 980 6010; neg 6011; where 217 6012; add 6009 6013; mul 255 1723; where 978 6015; mul 222 1759; mul 980
6017; where 217 6018; add 6016 6019; mul 255 2401; neg 6021; where 978 6022; mul 222 2436; mul 980 6024; neg 6025;
where 217 6026; add 6023 6027; mul 258 982; neg 6029; where 978 6030; mul 222 1007; where 990 6032; add 6031 6033;
mul 229 1026; neg 6035; mul 406 6036; where 217 6037; add 6034 6038; mul 258 1723; where 978 6040; mul 222 1741; neg
6042; where 990 6043; add 6041 6044; mul 229 1759; mul 406 6046; where 217 6047; add 6045 6048; mul 258 2401; neg
6050; where 978 6051; mul 222 1738; where 990 6053; add 6052 6054; mul 229 2436; neg 6056; mul 406 6057; where 217
6058; add 6055 6059; mul 262 982; mul 222 1003; add 6061 6062; neg 6063; where 978 6064; mul 237 1026; neg 6066; mul
406 6067; where 217 6068; add 6065 6069; mul 262 1723; add 6053 6071; where 978 6072; mul 237 1759; mul 406 6074;
where 217 6075; add 6073 6076; mul 262 2401; mul 222 2416; add 6078 6079; neg 6080; where 978 6081; mul 237 2436;
neg 6083; mul 406 6084; where 217 6085; add 6082 6086; mul 266 982; neg 6088; where 978 6089; mul 229 1007; mul 406
6091; where 990 6092; add 6090 6093; mul 241 1026; neg 6095; where 217 6096; add 6094 6097; mul 266 1723; where 978
6099; mul 229 1741; neg 6101; mul 406 6102; where 990 6103; add 6100 6104; mul 241 1759; where 217 6106; add 6105
6107; mul 266 2401; neg 6109; where 978 6110; mul 229 1738; mul 406 6112; where 990 6113; add 6111 6114; mul 241
2436; neg 6116; where 217 6117; add 6115 6118; mul 270 982; mul 229 1003; add 6120 6121; neg 6122; where 978 6123;
mul 237 1007; where 990 6125; add 6124 6126; mul 245 1026; neg 6128; where 217 6129; add 6127 6130; mul 270 1723;
add 6112 6132; where 978 6133; mul 237 1741; neg 6135; where 990 6136; add 6134 6137; mul 245 1759; where 217 6139;
add 6138 6140; mul 270 2401; mul 229 2416; add 6142 6143; neg 6144; where 978 6145; mul 237 1738; where 990 6147;
add 6146 6148; mul 245 2436; neg 6150; where 217 6151; add 6149 6152; mul 237 1003; neg 6154; mul 406 6155; mul 274
982; sub 6156 6157; where 978 6158; mul 249 1026; neg 6160; where 217 6161; add 6159 6162; mul 274 1723; mul 406
6147; add 6164 6165; where 978 6166; mul 249 1759; where 217 6168; add 6167 6169; mul 237 2416; neg 6171; mul 406
6172; mul 274 2401; sub 6173 6174; where 978 6175; mul 249 2436; neg 6177; where 217 6178; add 6176 6179; mul 278
982; neg 6181; where 978 6182; mul 241 1007; mul 980 6184; where 990 6185; add 6183 6186; mul 278 1723; where 978
6188; mul 241 1741; mul 980 6190; neg 6191; where 990 6192; add 6189 6193; mul 278 2401; neg 6195; where 978 6196;
mul 241 1738; mul 980 6198; where 990 6199; add 6197 6200; mul 282 982; mul 241 1003; add 6202 6203; neg 6204; where
978 6205; mul 245 1007; mul 406 6207; where 990 6208; add 6206 6209; mul 282 1723; add 6198 6211; where 978 6212;
mul 245 1741; neg 6214; mul 406 6215; where 990 6216; add 6213 6217; mul 282 2401; mul 241 2416; add 6219 6220; neg
6221; where 978 6222; mul 245 1738; mul 406 6224; where 990 6225; add 6223 6226; mul 245 1003; neg 6228; mul 406
6229; mul 286 982; sub 6230 6231; where 978 6232; mul 249 1007; where 990 6234; add 6233 6235; mul 286 1723; add
6225 6237; where 978 6238; mul 249 1741; neg 6240; where 990 6241; add 6239 6242; mul 245 2416; neg 6244; mul 406
6245; mul 286 2401; sub 6246 6247; where 978 6248; mul 249 1738; where 990 6250; add 6249 6251; mul 252 982; mul 249
1003; mul 980 6254; add 6253 6255; neg 6256; where 978 6257; mul 252 1723; mul 980 6250; add 6259 6260; where 978
6261; mul 252 2401; mul 249 2416; mul 980 6264; add 6263 6265; neg 6266; where 978 6267; mul 618 5018; mul 622 4975;
sub 6269 6270; mul 89 5078; sub 6271 6272; mul 44 5092; mul 58 5094; add 6274 6275; mul 85 5083; add 6276 6277; mul
77 6278; add 6273 6279; mul 58 5086; mul 44 5084; sub 6281 6282; mul 77 6283; add 6280 6284; mul 73 5088; add 6285
6286; mul 73 5098; sub 6287 6288; mul 60 5083; mul 68 6290; add 6289 6291; mul 57 5144; add 6292 6293; mul 57 5152;
add 6294 6295; mul 44 5105; mul 75 5094; mul 75 5086; add 6298 6299; sub 6297 6300; mul 44 5108; add 6301 6302; mul
53 6303; add 6296 6304; mul 42 5110; add 6305 6306; mul 1420 4975; mul 1411 5018; sub 6308 6309; mul 618 5078; add
6310 6311; mul 85 5306; sub 6313 5520; mul 77 6314; add 6312 6315; sub 5143 5138; mul 44 5307; sub 6317 6318; mul 58
5311; add 6319 6320; mul 77 6321; add 6316 6322; mul 73 5313; add 6323 6324; mul 73 5316; sub 6325 6326; mul 60
5306; add 5096 6328; mul 68 6329; add 6327 6330; mul 57 5351; add 6331 6332; mul 57 5360; add 6333 6334; sub 5557
5556; mul 75 5311; sub 6336 6337; mul 44 5319; add 6338 6339; mul 53 6340; add 6335 6341; mul 42 5322; add 6342
6343; mul 1420 5018; mul 2096 4975; sub 6345 6346; mul 622 5078; sub 6347 6348; mul 85 5510; mul 77 6350; add 6349
6351; sub 6298 6302; mul 44 5511; sub 6353 6354; mul 58 5514; add 6355 6356; mul 77 6357; add 6352 6358; mul 73
5516; add 6359 6360; mul 73 5522; add 6361 6362; mul 60 5510; sub 6364 6276; mul 68 6365; add 6363 6366; mul 57
5562; add 6367 6368; mul 57 5567; add 6369 6370; mul 44 5525; mul 75 5514; sub 6372 6373; mul 53 6374; add 6371
6375; mul 42 5529; add 6376 6377; sub 5088 5098; sub 5313 5316; add 5516 5522; mul 16 5169; mul 16 5376; mul 16
5583; mul 474 4837; mul 474 6385; mul 348 863; mul 28 6387; add 914 6388; mul 28 6389; add 6386 6390; mul 21 6278;
mul 52 6392; mul 4823 4974; sub 6393 6394; mul 21 6283; mul 52 6396; add 6395 6397; mul 40 5089; add 6398 6399; mul
40 5099; sub 6400 6401; mul 66 406; mul 21 6290; mul 6403 6404; add 6402 6405; mul 28 6406; add 6391 6407; mul 474
5215; mul 474 6409; mul 348 1623; mul 28 6411; sub 6412 1670; mul 28 6413; add 6410 6414; mul 21 6314; mul 52 6416;
add 5133 6417; mul 21 6321; mul 52 6419; add 6418 6420; mul 40 5314; add 6421 6422; mul 40 5317; sub 6423 6424; mul
21 6329; mul 6403 6426; add 6425 6427; mul 28 6428; add 6415 6429; mul 474 5420; mul 474 6431; mul 348 2301; mul 28
6433; add 2348 6434; mul 28 6435; add 6432 6436; mul 21 6350; mul 52 6438; mul 4833 4974; sub 6439 6440; mul 21
6357; mul 52 6442; add 6441 6443; mul 40 5517; add 6444 6445; mul 40 5523; add 6446 6447; mul 21 6365; mul 6403
6449; add 6448 6450; mul 28 6451; add 6437 6452; mul 348 2822; mul 28 6454; add 2846 6455; mul 28 6456; mul 348
2999; mul 28 6458; add 3034 6459; mul 28 6460; mul 465 4837; mul 474 6462; mul 465 6385; add 6463 6464; mul 2 6387;
add 741 6466; mul 28 6467; add 6465 6468; mul 2 6389; add 6469 6470; mul 2 6406; add 6471 6472; mul 28 5158; add
6473 6474; mul 465 5215; mul 474 6476; mul 465 6409; add 6477 6478; mul 2 6411; add 1439 6480; mul 28 6481; add 6479
6482; mul 2 6413; add 6483 6484; mul 2 6428; add 6485 6486; mul 28 5365; add 6487 6488; mul 465 5420; mul 474 6490;
mul 465 6431; add 6491 6492; mul 2 6433; add 2197 6494; mul 28 6495; add 6493 6496; mul 2 6435; add 6497 6498; mul 2
6451; add 6499 6500; mul 28 5572; add 6501 6502; mul 2 6454; add 2775 6504; mul 28 6505; mul 2 6456; add 6506 6507;
mul 2 6458; add 3001 6509; mul 28 6510; mul 2 6460; add 6511 6512; mul 465 6462; mul 2 6467; add 6514 6515; mul 2
5158; add 6516 6517; mul 465 6476; mul 2 6481; add 6519 6520; mul 2 5365; add 6521 6522; mul 465 6490; mul 2 6495;
add 6524 6525; mul 2 5572; add 6526 6527; mul 2 6505; mul 2 6510; mul 489 4837; mul 474 6531; mul 489 6385; add 6532
6533; mul 34 6387; add 736 6535; mul 28 6536; add 6534 6537; mul 34 6389; add 6538 6539; mul 34 6406; add 6540 6541;
mul 66 6392; sub 6543 6440; mul 66 6396; add 6544 6545; mul 40 5145; add 6546 6547; mul 40 5153; add 6548 6549; mul
52 406; mul 21 6303; mul 6551 6552; add 6550 6553; mul 28 6554; add 6542 6555; mul 489 5215; mul 474 6557; mul 489
6409; add 6558 6559; mul 34 6411; sub 6561 1519; mul 28 6562; add 6560 6563; mul 34 6413; add 6564 6565; mul 34
6428; add 6566 6567; mul 66 6416; add 5551 6569; mul 66 6419; add 6570 6571; mul 40 5352; add 6572 6573; mul 40
5361; add 6574 6575; mul 21 6340; mul 6551 6577; add 6576 6578; mul 28 6579; add 6568 6580; mul 489 5420; mul 474
6582; mul 489 6431; add 6583 6584; mul 34 6433; add 2193 6586; mul 28 6587; add 6585 6588; mul 34 6435; add 6589
6590; mul 34 6451; add 6591 6592; mul 66 6438; mul 4974 5416; sub 6594 6595; mul 66 6442; add 6596 6597; mul 40
5563; add 6598 6599; mul 40 5568; add 6600 6601; mul 21 6374; mul 6551 6603; add 6602 6604; mul 28 6605; add 6593
6606; mul 34 6454; add 2773 6608; mul 28 6609; mul 34 6456; add 6610 6611; mul 34 6458; add 2961 6613; mul 28 6614;
mul 34 6460; add 6615 6616; mul 465 6531; mul 489 6462; add 6618 6619; mul 2 6536; add 6620 6621; mul 34 6467; add
6622 6623; mul 2 6554; add 6624 6625; mul 34 5158; add 6626 6627; mul 465 6557; mul 489 6476; add 6629 6630; mul 2
6562; add 6631 6632; mul 34 6481; add 6633 6634; mul 2 6579; add 6635 6636; mul 34 5365; add 6637 6638; mul 465
6582; mul 489 6490; add 6640 6641; mul 2 6587; add 6642 6643; mul 34 6495; add 6644 6645; mul 2 6605; add 6646 6647;
mul 34 5572; add 6648 6649; mul 2 6609; mul 34 6505; add 6651 6652; mul 2 6614; mul 34 6510; add 6654 6655; mul 489
6531; mul 34 6536; add 6657 6658; mul 34 6554; add 6659 6660; mul 489 6557; mul 34 6562; add 6662 6663; mul 34 6579;
add 6664 6665; mul 489 6582; mul 34 6587; add 6667 6668; mul 34 6605; add 6669 6670; mul 34 6609; mul 34 6614; mul
37 4865; mul 22 6674; sub 628 6675; mul 37 5236; mul 22 6677; add 1425 6678; mul 37 5443; mul 22 6680; sub 2102
6681; mul 4821 5124; mul 346 6674; sub 6683 6684; mul 4821 5128; add 6685 6686; mul 38 5158; add 6687 6688; mul 24
5113; add 6689 6690; mul 346 6677; mul 4821 5336; add 6692 6693; mul 4821 5339; add 6694 6695; mul 38 5365; add 6696
6697; mul 24 5325; add 6698 6699; mul 4821 5542; mul 346 6680; sub 6701 6702; mul 4821 5546; add 6703 6704; mul 38
5572; add 6705 6706; mul 24 5532; add 6707 6708; neg 618; neg 438; neg 551; neg 441; neg 554; neg 445; neg 558;
input p 225; mul 528 655; mul 6717 6718; add 655 6719; input p 226; mul 6718 6721; mul 348 6722; add 6720 6723; add
794 6724; mul 415 794; mul 6717 6726; add 6725 6727; mul 6721 6726; mul 348 6729; add 6728 6730; mul 528 1454; mul
6717 6732; add 1454 6733; mul 6721 6732; mul 348 6735; add 6734 6736; add 1572 6737; mul 415 1572; mul 6717 6739;
add 6738 6740; mul 6721 6739; mul 348 6742; add 6741 6743; neg 6744; mul 528 2126; mul 6717 6746; add 2126 6747; mul
6721 6746; mul 348 6749; add 6748 6750; add 2246 6751; mul 415 2246; mul 6717 6753; add 6752 6754; mul 6721 6753;
mul 348 6756; add 6755 6757; mul 415 2795; mul 6717 6759; add 2795 6760; mul 6721 6759; mul 348 6762; add 6761 6763;
mul 528 2972; mul 6717 6765; add 2972 6766; mul 6721 6765; mul 348 6768; add 6767 6769; le 5041 5040; le 5040 5041;
add 6771 6772; div 1 6773; mul 6771 6774; mul 89 474; mul 6775 6776; neg 6777; mul 474 618; mul 6775 6779; mul 474
622; mul 6775 6781; neg 6782; mul 5053 6776; neg 6784; mul 5053 6779; mul 5053 6781; neg 6787; mul 89 5062; mul 474
6789; neg 6790; mul 618 5062; mul 474 6792; mul 622 5062; mul 474 6794; neg 6795; input p 227; mul 5062 5063; mul 89
6798; mul 406 5061; div 1 6800; mul 6799 6801; mul 6797 6802; mul 618 6798; mul 6801 6804; mul 6797 6805; neg 6806;
mul 622 6798; mul 6801 6808; mul 6797 6809; mul 618 5009; mul 1411 5009; neg 6812; mul 1420 5009; le 1 4996; mul 465
5010; add 474 6816; lt 5041 6817; and 6815 6818; constant -1.0; le 4996 6820; lt 6817 5041; and 6821 6822; or 6819
6823; not 6824; input p 176; mul 465 6826; where 6825 6827; le 1 4999; and 6818 6829; le 4999 6820; and 6822 6831;
or 6830 6832; not 6833; input p 177; mul 465 6835; where 6834 6836; le 1 5003; and 6818 6838; le 5003 6820; and 6822
6840; or 6839 6841; not 6842; input p 178; mul 465 6844; where 6843 6845; le 1 5007; and 6818 6847; le 5007 6820;
and 6822 6849; or 6848 6850; not 6851; input p 179; mul 465 6853; where 6852 6854; mul 23 4894; mul 23 4881; mul 37
4884; add 6857 6858; mul 37 862; add 6859 6860; sub 6856 6861; mul 23 5253; mul 37 5256; add 6863 6864; mul 37 1622;
sub 6865 6866; mul 23 5265; add 6867 6868; mul 23 5470; mul 23 5458; mul 37 5461; add 6871 6872; mul 37 2300; add
6873 6874; sub 6870 6875; mul 23 5626; mul 23 5617; mul 37 5615; add 6878 6879; mul 37 2822; add 6880 6881; sub 6877
6882; mul 23 4884; mul 37 4881; sub 6884 6885; mul 23 862; add 6886 6887; mul 37 4894; add 6888 6889; mul 37 5253;
mul 23 5256; sub 6891 6892; mul 23 1622; add 6893 6894; mul 37 5265; add 6895 6896; mul 23 5461; mul 37 5458; sub
6898 6899; mul 23 2300; add 6900 6901; mul 37 5470; add 6902 6903; mul 23 5615; mul 37 5617; sub 6905 6906; mul 23
2822; add 6907 6908; mul 37 5626; add 6909 6910; neg 4894; neg 5265; neg 5470; neg 5626; mul 388 403; mul 842 6916;
mul 388 452; mul 825 6918; add 6917 6919; mul 388 436; mul 731 6921; add 6920 6922; mul 388 399; mul 858 6924; add
6923 6925; neg 6926; mul 1587 6918; mul 1602 6916; sub 6928 6929; mul 1434 6921; add 6930 6931; mul 1618 6924; sub
6932 6933; mul 2280 6916; mul 2264 6918; add 6935 6936; mul 2188 6921; add 6937 6938; mul 2296 6924; add 6939 6940;
neg 6941; mul 2812 6916; mul 2798 6918; add 6943 6944; mul 2818 6924; add 6945 6946; neg 6947; mul 410 844; mul 410
1604; neg 6950; mul 410 2282; neg 1581; mul 417 816; mul 417 1581; neg 6955; mul 417 2258; mul 433 797; mul 425
6958; neg 6959; mul 433 1560; mul 425 6961; mul 433 2249; mul 425 6963; neg 6964; input p 228; mul 415 801; mul 6966
6967; add 801 6968; input p 229; mul 6967 6970; mul 348 6971; add 6969 6972; neg 6973; mul 415 1576; mul 6966 6975;
add 1576 6976; mul 6970 6975; mul 348 6978; add 6977 6979; mul 415 2253; mul 6966 6981; add 2253 6982; mul 6970
6981; mul 348 6984; add 6983 6985; neg 6986; mul 459 731; mul 438 6988; mul 459 1434; mul 438 6990; neg 6991; mul
459 2188; mul 438 6993; mul 441 6988; mul 441 6990; neg 6996; mul 441 6993; mul 445 6988; mul 445 6990; neg 7000;
mul 445 6993; mul 459 787; mul 459 1565; neg 7004; mul 459 2239; mul 23 4867; mul 37 4863; add 7007 7008; mul 37
723; add 7009 7010; mul 23 4878; sub 7011 7012; mul 37 1515; mul 23 5238; mul 37 5241; add 7015 7016; sub 7014 7017;
mul 23 5250; sub 7018 7019; mul 23 5445; mul 37 5441; add 7021 7022; mul 37 2180; add 7023 7024; mul 23 5455; sub
7025 7026; mul 23 5656; mul 37 5658; add 7028 7029; mul 37 2999; add 7030 7031; mul 23 5667; sub 7032 7033; mul 23
4863; mul 37 4867; sub 7035 7036; mul 23 723; add 7037 7038; mul 37 4878; add 7039 7040; mul 37 5238; mul 23 5241;
sub 7042 7043; mul 23 1515; add 7044 7045; mul 37 5250; add 7046 7047; mul 23 5441; mul 37 5445; sub 7049 7050; mul
23 2180; add 7051 7052; mul 37 5455; add 7053 7054; mul 23 5658; mul 37 5656; sub 7056 7057; mul 23 2999; add 7058
7059; mul 37 5667; add 7060 7061; mul 505 520; mul 703 7063; mul 505 564; mul 686 7065; add 7064 7066; mul 505 549;
mul 630 7068; add 7067 7069; mul 505 516; mul 719 7071; add 7070 7072; neg 7073; mul 1469 7065; mul 1491 7063; sub
7075 7076; mul 1427 7068; add 7077 7078; mul 1507 7071; sub 7079 7080; mul 2160 7063; mul 2144 7065; add 7082 7083;
mul 2104 7068; add 7084 7085; mul 2176 7071; add 7086 7087; neg 7088; mul 2989 7063; mul 2975 7065; add 7090 7091;
mul 2995 7071; add 7092 7093; neg 7094; mul 526 705; mul 526 1493; neg 7097; mul 526 2162; neg 1463; mul 530 677;
mul 530 1463; neg 7102; mul 530 2138; mul 546 658; mul 538 7105; neg 7106; mul 546 1442; mul 538 7108; mul 546 2129;
mul 538 7110; neg 7111; input p 230; mul 528 662; mul 7113 7114; add 662 7115; input p 231; mul 7114 7117; mul 348
7118; add 7116 7119; neg 7120; mul 528 1458; mul 7113 7122; add 1458 7123; mul 7117 7122; mul 348 7125; add 7124
7126; mul 528 2133; mul 7113 7128; add 2133 7129; mul 7117 7128; mul 348 7131; add 7130 7132; neg 7133; mul 569 630;
mul 551 7135; mul 569 1427; mul 551 7137; neg 7138; mul 569 2104; mul 551 7140; mul 554 7135; mul 554 7137; neg
7143; mul 554 7140; mul 558 7135; mul 558 7137; neg 7147; mul 558 7140; mul 569 648; mul 569 1447; neg 7151; mul 569
2119; mul 618 5010; sub 7154 89; mul 4996 7155; mul 1411 5010; sub 618 7157; mul 4996 7158; mul 1420 5010; sub 7160
622; mul 4996 7161; mul 4999 7155; mul 4999 7158; mul 4999 7161; mul 5003 7155; mul 5003 7158; mul 5003 7161; mul
5007 7155; mul 5007 7158; mul 5007 7161; mul 6817 6826; mul 6826 7172; neg 7173; where 6825 7174; mul 6817 6835; mul
6835 7176; neg 7177; where 6834 7178; mul 6817 6844; mul 6844 7180; neg 7181; where 6843 7182; mul 6817 6853; mul
6853 7184; neg 7185; where 6852 7186; mul 89 5069; neg 7188; mul 618 5069; mul 622 5069; neg 7191; mul 89 5073; neg
7193; mul 618 5073; mul 622 5073; neg 7196; mul 90 1405; neg 7198; mul 90 2086; mul 90 2769; neg 7201; store by_k
100 1407; store by_k 300 2088; store by_k 500 2771; store by_k 600 2959; store by_k 700 3147; store by_k 800 2959;
store by_k 900 3147; store by_k 1000 2959; store by_k 1100 3147; store by_k 101 3298; store by_k 301 3313; store
by_k 501 3329; store by_k 102 3346; store by_k 302 3356; store by_k 502 3366; store by_k 103 3501; store by_k 303
3609; store by_k 503 3717; store by_k 104 3883; store by_k 304 4011; store by_k 504 4139; store by_k 105 4225; store
by_k 305 4293; store by_k 505 4361; store by_k 605 4429; store by_k 705 4497; store by_k 805 4429; store by_k 905
4497; store by_k 1005 4429; store by_k 1105 4497; store by_k 106 4574; store by_k 306 4648; store by_k 506 4722;
store by_k 107 4731; store by_k 307 4740; store by_k 507 4749; store by_k 607 4752; store by_k 707 4755; store by_k
807 4752; store by_k 907 4755; store by_k 1007 4752; store by_k 1107 4755; store by_k 108 4764; store by_k 308 4773;
store by_k 508 4782; store by_k 608 4785; store by_k 708 4788; store by_k 808 4785; store by_k 908 4788; store by_k
1008 4785; store by_k 1108 4788; store by_k 109 4797; store by_k 309 4803; store by_k 509 4812; store by_k 609 4815;
store by_k 709 4818; store by_k 809 4815; store by_k 909 4818; store by_k 1009 4815; store by_k 1109 4818; store
by_k 110 5201; store by_k 310 5407; store by_k 510 5614; store by_k 610 5655; store by_k 710 5696; store by_k 810
5655; store by_k 910 5696; store by_k 1010 5655; store by_k 1110 5696; store by_k 111 5700; store by_k 311 5703;
store by_k 511 5707; store by_k 112 5714; store by_k 312 5721; store by_k 512 5728; store by_k 113 5736; store by_k
313 5741; store by_k 513 5749; store by_k 114 5757; store by_k 314 5765; store by_k 514 5773; store by_k 115 5784;
store by_k 315 5793; store by_k 515 5804; store by_k 116 5813; store by_k 316 5819; store by_k 516 5828; store by_k
117 5835; store by_k 317 5842; store by_k 517 5849; store by_k 118 5860; store by_k 318 5869; store by_k 518 5880;
store by_k 119 5891; store by_k 319 5899; store by_k 519 5910; store by_k 120 5917; store by_k 320 5921; store by_k
520 5928; store by_k 121 5931; store by_k 321 5935; store by_k 521 5938; store by_k 122 5945; store by_k 322 5951;
store by_k 522 5958; store by_k 123 5966; store by_k 323 5973; store by_k 523 5981; store by_k 124 5987; store by_k
324 5992; store by_k 524 5998; store by_k 125 6001; store by_k 325 6003; store by_k 525 6006; store by_k 126 6014;
store by_k 326 6020; store by_k 526 6028; store by_k 127 6039; store by_k 327 6049; store by_k 527 6060; store by_k
128 6070; store by_k 328 6077; store by_k 528 6087; store by_k 129 6098; store by_k 329 6108; store by_k 529 6119;
store by_k 130 6131; store by_k 330 6141; store by_k 530 6153; store by_k 131 6163; store by_k 331 6170; store by_k
531 6180; store by_k 132 6187; store by_k 332 6194; store by_k 532 6201; store by_k 133 6210; store by_k 333 6218;
store by_k 533 6227; store by_k 134 6236; store by_k 334 6243; store by_k 534 6252; store by_k 135 6258; store by_k
335 6262; store by_k 535 6268; store by_k 136 6307; store by_k 336 6344; store by_k 536 6378; store by_k 137 6379;
store by_k 337 6380; store by_k 537 6381; store by_k 138 5110; store by_k 338 5322; store by_k 538 5529; store by_k
139 6382; store by_k 339 6383; store by_k 539 6384; store by_k 140 6303; store by_k 340 6340; store by_k 540 6374;
store by_k 141 6408; store by_k 341 6430; store by_k 541 6453; store by_k 641 6457; store by_k 741 6461; store by_k
841 6457; store by_k 941 6461; store by_k 1041 6457; store by_k 1141 6461; store by_k 142 6475; store by_k 342 6489;
store by_k 542 6503; store by_k 642 6508; store by_k 742 6513; store by_k 842 6508; store by_k 942 6513; store by_k
1042 6508; store by_k 1142 6513; store by_k 143 6518; store by_k 343 6523; store by_k 543 6528; store by_k 643 6529;
store by_k 743 6530; store by_k 843 6529; store by_k 943 6530; store by_k 1043 6529; store by_k 1143 6530; store
by_k 144 6556; store by_k 344 6581; store by_k 544 6607; store by_k 644 6612; store by_k 744 6617; store by_k 844
6612; store by_k 944 6617; store by_k 1044 6612; store by_k 1144 6617; store by_k 145 6628; store by_k 345 6639;
store by_k 545 6650; store by_k 645 6653; store by_k 745 6656; store by_k 845 6653; store by_k 945 6656; store by_k
1045 6653; store by_k 1145 6656; store by_k 146 6661; store by_k 346 6666; store by_k 546 6671; store by_k 646 6672;
store by_k 746 6673; store by_k 846 6672; store by_k 946 6673; store by_k 1046 6672; store by_k 1146 6673; store
by_k 147 6676; store by_k 347 6679; store by_k 547 6682; store by_k 148 6691; store by_k 348 6700; store by_k 548
6709; store by_k 149 89; store by_k 349 6710; store by_k 549 622; store by_k 650 6711; store by_k 750 6712; store
by_k 851 6713; store by_k 951 6714; store by_k 1052 6715; store by_k 1152 6716; store by_k 153 6731; store by_k 353
6745; store by_k 553 6758; store by_k 653 6764; store by_k 753 6770; store by_k 853 6764; store by_k 953 6770; store
by_k 1053 6764; store by_k 1153 6770; store by_k 154 6778; store by_k 354 6780; store by_k 554 6783; store by_k 155
6785; store by_k 355 6786; store by_k 555 6788; store by_k 156 6791; store by_k 356 6793; store by_k 556 6796; store
by_k 157 6803; store by_k 357 6807; store by_k 557 6810; store by_k 158 6811; store by_k 358 6813; store by_k 558
6814; store by_k 1458 6828; store by_k 1558 6837; store by_k 1658 6846; store by_k 1758 6855; store by_k 159 6862;
store by_k 359 6869; store by_k 559 6876; store by_k 659 6883; store by_k 859 6883; store by_k 1059 6883; store by_k
160 6890; store by_k 360 6897; store by_k 560 6904; store by_k 660 6911; store by_k 860 6911; store by_k 1060 6911;
store by_k 161 6912; store by_k 361 6913; store by_k 561 6914; store by_k 661 6915; store by_k 861 6915; store by_k
1061 6915; store by_k 162 862; store by_k 362 1622; store by_k 562 2300; store by_k 662 2822; store by_k 862 2822;
store by_k 1062 2822; store by_k 163 6927; store by_k 363 6934; store by_k 563 6942; store by_k 663 6948; store by_k
863 6948; store by_k 1063 6948; store by_k 164 6949; store by_k 364 6951; store by_k 564 6952; store by_k 165 816;
store by_k 365 6953; store by_k 565 2258; store by_k 166 6954; store by_k 366 6956; store by_k 566 6957; store by_k
167 6960; store by_k 367 6962; store by_k 567 6965; store by_k 168 6974; store by_k 368 6980; store by_k 568 6987;
store by_k 169 6989; store by_k 369 6992; store by_k 569 6994; store by_k 170 6995; store by_k 370 6997; store by_k
570 6998; store by_k 171 6999; store by_k 371 7001; store by_k 571 7002; store by_k 172 7003; store by_k 372 7005;
store by_k 572 7006; store by_k 173 7013; store by_k 373 7020; store by_k 573 7027; store by_k 773 7034; store by_k
973 7034; store by_k 1173 7034; store by_k 174 7041; store by_k 374 7048; store by_k 574 7055; store by_k 774 7062;
store by_k 974 7062; store by_k 1174 7062; store by_k 175 4878; store by_k 375 5250; store by_k 575 5455; store by_k
775 5667; store by_k 975 5667; store by_k 1175 5667; store by_k 176 723; store by_k 376 1515; store by_k 576 2180;
store by_k 776 2999; store by_k 976 2999; store by_k 1176 2999; store by_k 177 7074; store by_k 377 7081; store by_k
577 7089; store by_k 777 7095; store by_k 977 7095; store by_k 1177 7095; store by_k 178 7096; store by_k 378 7098;
store by_k 578 7099; store by_k 179 677; store by_k 379 7100; store by_k 579 2138; store by_k 180 7101; store by_k
380 7103; store by_k 580 7104; store by_k 181 7107; store by_k 381 7109; store by_k 581 7112; store by_k 182 7121;
store by_k 382 7127; store by_k 582 7134; store by_k 183 7136; store by_k 383 7139; store by_k 583 7141; store by_k
184 7142; store by_k 384 7144; store by_k 584 7145; store by_k 185 7146; store by_k 385 7148; store by_k 585 7149;
store by_k 186 7150; store by_k 386 7152; store by_k 586 7153; store by_k 187 7156; store by_k 387 7159; store by_k
587 7162; store by_k 188 7163; store by_k 388 7164; store by_k 588 7165; store by_k 189 7166; store by_k 389 7167;
store by_k 589 7168; store by_k 190 7169; store by_k 390 7170; store by_k 590 7171; store by_k 1491 7175; store by_k
1592 7179; store by_k 1693 7183; store by_k 1794 7187; store by_k 195 7189; store by_k 395 7190; store by_k 595
7192; store by_k 196 7194; store by_k 396 7195; store by_k 596 7197; store by_k 1297 5069; store by_k 1398 5073;
store by_k 199 7199; store by_k 399 7200; store by_k 599 7202
    """,
)
