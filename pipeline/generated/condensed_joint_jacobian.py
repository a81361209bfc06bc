"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 114},
    {'p': 238},
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
98; input k 99; input k 100; constant -6.0; input k 63; input k 101; input k 102; input k 103; input k 104; input k
69; input k 70; input k 71; mul 275 275; input k 109; input k 110; mul 3 168; mul 168 173; input k 31; mul 164 281;
input k 32; mul 168 283; input k 33; mul 164 189; mul 168 190; input k 20; mul 176 288; input k 21; mul 164 290;
input k 22; mul 168 292; input k 23; mul 6 193; input k 72; constant 0.8000000000000002; constant 2.400000000000001;
mul 30 298; add 297 299; constant 0.01904761904761903; mul 35 301; add 300 302; constant -1.3714285714285723; mul 42
304; constant 1.3714285714285714; mul 29 306; constant 0.007256235827664418; mul 34 308; add 307 309; constant
-4.799999999999999; mul 42 311; constant 1.3714285714285692; mul 29 313; constant -0.05714285714285729; mul 34 315;
add 314 316; constant -7.199999999999996; mul 42 318; constant 7.199999999999994; mul 29 320; constant
0.2190476190476189; mul 34 322; add 321 323; constant -45.25714285714286; mul 29 325; constant -0.11428571428571327;
mul 34 327; add 326 328; constant -28.800000000000004; mul 42 330; mul 168 175; mul 168 285; input k 34; mul 164
334; mul 168 191; mul 164 192; mul 164 294; input k 24; mul 176 339; mul 21 172; input k 64; input k 65; input k 66;
input k 111; input k 112; input k 105; div 2 347; input k 106; div 2 349; input k 107; div 2 351; input k 108; div 2
353; mul 17 38; mul 37 355; mul 17 67; mul 118 355; mul 17 37; mul 13 16; add 277 278; mul 104 355; mul 17 113; mul
267 355; add 363 364; mul 21 365; mul 17 267; mul 176 355; add 367 368; mul 21 369; mul 38 370; add 366 371; mul 39
370; mul 40 370; mul 37 39; mul 39 118; mul 7 16; mul 39 104; mul 39 267; mul 21 379; mul 39 176; mul 21 381; mul 38
382; add 380 383; mul 39 382; mul 40 382; mul 296 348; mul 296 350; mul 296 352; mul 296 354; mul 37 40; mul 40 118;
mul 11 16; mul 40 104; mul 40 176; mul 21 395; mul 39 396; mul 40 267; mul 21 398; mul 38 396; add 399 400; mul 40
396; add 341 402; neg 342; neg 343; neg 344; neg 345; neg 346; mul 269 296; mul 270 296; mul 271 296; mul 272 296;
mul 17 18; mul 27 168; mul 168 275; store p 0 0; store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6;
store p 6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p 11 12; store p 12 13; store p 13 14;
store p 14 18; store p 15 22; store p 16 23; store p 17 17; store p 18 24; store p 19 37; store p 20 38; store p 21
39; store p 22 40; store p 23 43; store p 24 48; store p 25 50; store p 26 55; store p 27 60; store p 28 67; store p
29 69; store p 30 74; store p 31 76; store p 32 81; store p 33 86; store p 34 91; store p 35 96; store p 36 102;
store p 37 104; store p 38 106; store p 39 111; store p 40 118; store p 41 120; store p 42 125; store p 43 129;
store p 44 134; store p 45 139; store p 46 141; store p 47 146; store p 48 151; store p 49 153; store p 50 158;
store p 51 163; store p 52 166; store p 53 169; store p 54 171; store p 55 173; store p 56 174; store p 57 175;
store p 58 178; store p 59 180; store p 60 182; store p 61 184; store p 62 186; store p 63 188; store p 64 189;
store p 65 190; store p 66 191; store p 67 192; store p 68 16; store p 69 201; store p 70 203; store p 71 205; store
p 72 207; store p 73 209; store p 74 211; store p 75 212; store p 76 213; store p 77 214; store p 78 215; store p 79
193; store p 80 199; store p 81 202; store p 82 208; store p 83 216; store p 84 217; store p 85 219; store p 86 221;
store p 87 223; store p 88 224; store p 89 204; store p 90 225; store p 91 226; store p 92 220; store p 93 227;
store p 94 229; store p 95 197; store p 96 195; store p 97 231; store p 98 196; store p 99 194; store p 100 232;
store p 101 233; store p 102 234; store p 103 235; store p 104 239; store p 105 240; store p 106 241; store p 107
242; store p 108 243; store p 109 246; store p 110 247; store p 111 253; store p 112 249; store p 113 250; store p
114 255; store p 115 251; store p 116 248; store p 117 256; store p 118 257; store p 119 258; store p 120 259; store
p 121 262; store p 122 263; store p 123 264; store p 124 265; store p 125 266; store p 126 21; store p 127 268;
store p 128 269; store p 129 270; store p 130 271; store p 131 272; store p 132 273; store p 133 274; store p 134
276; store p 135 277; store p 136 278; store p 137 279; store p 138 167; store p 139 280; store p 140 282; store p
141 284; store p 142 285; store p 143 179; store p 144 185; store p 145 286; store p 146 287; store p 147 289; store
p 148 291; store p 149 293; store p 150 294; store p 151 295; store p 152 296; store p 153 303; store p 154 305;
store p 155 310; store p 156 312; store p 157 317; store p 158 319; store p 159 324; store p 160 329; store p 161
331; store p 162 170; store p 163 332; store p 164 283; store p 165 333; store p 166 335; store p 167 181; store p
168 336; store p 169 337; store p 170 290; store p 171 338; store p 172 340; store p 173 165; store p 174 281; store
p 175 334; store p 176 341; store p 177 342; store p 178 343; store p 179 344; store p 180 345; store p 181 346;
store p 182 348; store p 183 350; store p 184 352; store p 185 354; store p 186 356; store p 187 355; store p 188
357; store p 189 358; store p 190 359; store p 191 360; store p 192 361; store p 193 362; store p 194 372; store p
195 373; store p 196 374; store p 197 375; store p 198 376; store p 199 377; store p 200 378; store p 201 384; store
p 202 385; store p 203 386; store p 204 387; store p 205 388; store p 206 389; store p 207 390; store p 208 391;
store p 209 392; store p 210 393; store p 211 394; store p 212 397; store p 213 401; store p 214 403; store p 215
404; store p 216 405; store p 217 406; store p 218 407; store p 219 408; store p 220 409; store p 221 410; store p
222 411; store p 223 412; store p 224 413; store p 225 28; store p 226 27; store p 227 99; store p 228 29; store p
229 414; store p 230 34; store p 231 244; store p 232 245; store p 233 415; store p 234 236; store p 235 238; store
p 236 260; store p 237 261
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 238},
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
input p 128; input z 0; mul 731 732; input p 129; input z 1; mul 734 735; add 733 736; input p 130; input z 2; mul
738 739; add 737 740; input p 131; input z 3; mul 742 743; add 741 744; sub 730 745; input p 132; abs 0; mul 747
748; mul 0 749; input p 133; mul 0 751; mul 0 0; input p 134; add 753 754; sqrt 755; div 2 756; mul 752 757; add 750
758; sub 746 759; add 729 760; input p 135; input x 12; sub 29 763; mul 762 764; input p 136; input x 13; sub 29
767; mul 766 768; add 765 769; sub 761 770; mul 0 62; mul 28 130; add 772 773; mul 47 599; add 774 775; mul 0 776;
mul 0 28; mul 31 130; add 778 779; mul 34 599; add 780 781; mul 130 782; add 777 783; mul 0 47; mul 34 130; add 785
786; mul 51 599; add 787 788; mul 599 789; add 784 790; mul 17 130; mul 130 792; mul 23 793; input p 137; mul 9 795;
mul 9 796; mul 8 16; mul 10 798; mul 798 799; add 797 800; mul 3 801; mul 38 802; sub 25 803; mul 794 804; add 791
805; mul 67 806; mul 24 802; add 39 808; mul 794 809; sub 807 810; mul 22 811; sub 771 812; mul 90 813; mul 81 89;
mul 150 265; mul 145 816; input p 138; mul 286 818; input p 139; mul 305 820; add 819 821; mul 325 332; add 822 823;
input p 140; mul 329 825; add 824 826; input p 141; mul 333 828; add 827 829; input p 142; mul 337 831; add 830 832;
mul 340 833; input p 143; mul 343 835; mul 346 353; add 836 837; input p 144; mul 350 839; add 838 840; input p 145;
mul 354 842; add 841 843; input p 146; mul 358 845; add 844 846; mul 362 373; add 847 848; input p 147; mul 366 850;
add 849 851; input p 148; mul 370 853; add 852 854; input p 149; mul 374 856; add 855 857; input p 150; mul 340 859;
add 858 860; add 834 861; mul 145 862; mul 587 863; add 817 864; mul 590 701; sub 865 866; mul 150 720; add 867 868;
mul 578 605; mul 690 698; add 870 871; add 869 872; sub 134 873; input p 151; mul 38 875; mul 17 876; add 874 877;
input p 152; mul 745 879; sub 878 880; mul 41 806; mul 26 810; sub 882 883; mul 22 884; mul 19 802; mul 793 886; sub
885 887; sub 881 888; mul 815 889; sub 814 890; mul 86 89; input p 153; mul 35 893; input p 154; mul 214 895; add
894 896; input p 155; mul 218 898; add 897 899; mul 155 210; add 900 901; input p 156; mul 158 903; add 902 904;
input p 157; mul 162 906; add 905 907; input p 158; mul 166 909; add 908 910; mul 170 227; add 911 912; input p 159;
mul 174 914; add 913 915; mul 157 189; add 916 917; input p 160; mul 193 919; add 918 920; mul 169 197; add 921 922;
input p 161; mul 201 924; add 923 925; mul 184 258; add 926 927; mul 202 257; add 928 929; mul 153 265; add 930 931;
mul 145 932; input p 162; mul 286 934; mul 305 332; add 935 936; input p 163; mul 325 938; add 937 939; input p 164;
mul 329 941; add 940 942; input p 165; mul 333 944; add 943 945; input p 166; mul 337 947; add 946 948; mul 340 949;
input p 167; mul 343 951; mul 346 839; add 952 953; mul 350 361; add 954 955; mul 354 369; add 956 957; input p 168;
mul 358 959; add 958 960; input p 169; mul 362 962; add 961 963; input p 170; mul 366 965; add 964 966; mul 370 856;
add 967 968; input p 171; mul 374 970; add 969 971; input p 172; mul 340 973; add 972 974; add 950 975; constant
3.0; mul 337 977; input p 173; mul 343 979; mul 346 818; add 980 981; mul 350 934; add 982 983; mul 328 354; add 984
985; mul 332 358; add 986 987; mul 336 362; add 988 989; input p 174; mul 366 991; add 990 992; mul 370 941; add 993
994; mul 374 831; add 995 996; input p 175; mul 340 998; add 997 999; mul 978 1000; add 976 1001; mul 145 1002; mul
595 1003; add 933 1004; mul 598 701; sub 1005 1006; input p 176; mul 599 1008; mul 153 720; add 1009 1010; add 1007
1011; mul 53 806; mul 22 1013; add 1012 1014; mul 892 1015; sub 891 1016; mul 56 70; mul 79 79; sub 1018 1019; mul
89 1020; mul 889 1021; mul 813 815; sub 1022 1023; mul 59 70; mul 76 79; sub 1025 1026; mul 89 1027; mul 1015 1028;
add 1024 1029; mul 813 892; mul 889 1028; sub 1031 1032; mul 45 70; mul 76 76; sub 1034 1035; mul 89 1036; mul 1015
1037; sub 1033 1038; mul 566 603; input p 177; mul 545 1041; sub 1040 1042; mul 678 696; mul 660 1041; sub 1044
1045; input p 178; mul 548 1047; sub 1040 1048; mul 663 1047; sub 1044 1050; input p 179; mul 552 1052; sub 1040
1053; mul 667 1052; sub 1044 1055; input p 180; mul 764 1057; input p 181; mul 768 1059; le 2 732; mul 130 879; add
0 1062; lt 140 1063; and 1061 1064; constant -1.0; le 732 1066; lt 1063 140; and 1067 1068; or 1065 1069; not 1070;
input p 182; mul 1063 1072; where 1071 1073; le 2 735; and 1064 1075; le 735 1066; and 1068 1077; or 1076 1078; not
1079; input p 183; mul 1063 1081; where 1080 1082; le 2 739; and 1064 1084; le 739 1066; and 1068 1086; or 1085
1087; not 1088; input p 184; mul 1063 1090; where 1089 1091; le 2 743; and 1064 1093; le 743 1066; and 1068 1095; or
1094 1096; not 1097; input p 185; mul 1063 1099; where 1098 1100; mul 41 515; mul 28 1102; mul 22 1103; mul 56 1104;
mul 53 515; mul 47 1106; mul 22 1107; mul 45 1108; add 1105 1109; mul 28 53; mul 41 47; add 1111 1112; mul 22 1113;
mul 59 1114; add 1115 1115; sub 1110 1116; mul 89 1117; mul 89 90; mul 67 515; mul 62 1120; mul 22 1121; mul 61
1122; mul 70 1117; add 1123 1124; mul 41 62; mul 28 67; add 1126 1127; mul 22 1128; mul 81 1129; mul 56 1129; mul 76
1108; add 1131 1132; mul 79 1114; mul 47 67; mul 53 62; add 1135 1136; mul 22 1137; mul 59 1138; add 1134 1139; sub
1133 1140; mul 76 1141; add 1130 1142; sub 1125 1143; mul 86 1138; mul 59 1129; mul 76 1114; add 1146 1147; mul 79
1104; mul 45 1138; add 1149 1150; sub 1148 1151; mul 79 1152; add 1145 1153; add 1144 1154; mul 1119 1155; sub 1118
1156; mul 813 1157; mul 100 106; mul 102 1159; mul 100 114; sub 1160 1161; mul 100 118; mul 100 1163; sub 1162 1164;
input p 186; input p 187; mul 35 1167; mul 157 1168; add 1166 1169; mul 35 1168; mul 161 1171; add 1170 1172; mul
155 515; mul 1167 1174; mul 165 1175; add 1173 1176; mul 35 1175; mul 169 1178; add 1177 1179; mul 155 1175; mul 166
1167; add 1181 1182; mul 173 1183; add 1180 1184; input p 188; add 1185 1186; mul 35 144; mul 180 1188; add 1187
1189; mul 35 1188; mul 184 1191; add 1190 1192; mul 144 155; mul 148 1167; add 1194 1195; mul 188 1196; add 1193
1197; mul 35 1196; mul 192 1199; add 1198 1200; mul 155 1196; mul 189 1167; add 1202 1203; mul 196 1204; add 1201
1205; mul 148 515; mul 144 1207; mul 155 1208; mul 201 1167; add 1209 1210; mul 200 1211; add 1206 1212; mul 148
1208; mul 144 201; add 1214 1215; mul 205 1216; add 1213 1217; input p 189; mul 224 1168; add 1219 1220; mul 227
1171; add 1221 1222; mul 230 1175; add 1223 1224; mul 233 1178; add 1225 1226; mul 236 1183; add 1227 1228; input p
190; add 1229 1230; mul 157 1188; add 1231 1232; mul 161 1191; add 1233 1234; mul 245 1196; add 1235 1236; mul 248
1199; add 1237 1238; mul 251 1204; add 1239 1240; mul 254 1208; add 1241 1242; mul 35 1208; mul 257 1244; add 1243
1245; mul 196 1211; add 1246 1247; mul 263 1216; add 1248 1249; mul 147 1250; add 1218 1251; mul 145 1252; mul 285
515; le 272 270; le 270 272; add 1255 1256; div 2 1257; mul 1255 1258; le 271 148; le 148 271; add 1260 1261; div 2
1262; mul 1260 1263; mul 144 1264; mul 1259 1265; constant 2.857142857142857; le 278 274; le 274 278; add 1268 1269;
div 2 1270; mul 1268 1271; le 140 277; le 277 140; add 1273 1274; div 2 1275; mul 1273 1276; mul 144 280; mul 1277
1278; mul 1272 1279; mul 280 1280; mul 279 1281; mul 281 1280; add 1282 1283; mul 1267 1284; sub 1266 1285; mul 1254
1286; mul 269 1287; mul 304 1286; mul 288 1289; add 1288 1290; mul 324 1286; mul 308 1292; add 1291 1293; mul 340
1294; mul 285 1287; mul 286 1286; add 1296 1297; mul 342 1298; mul 304 1287; mul 345 1300; add 1299 1301; mul 324
1287; mul 349 1303; add 1302 1304; mul 304 1289; mul 353 1306; add 1305 1307; mul 324 1289; mul 357 1309; add 1308
1310; mul 324 1292; mul 361 1312; add 1311 1313; add 1295 1314; mul 145 1315; mul 384 1316; mul 382 1280; mul 381
1318; sub 1317 1319; add 1253 1320; input p 191; mul 389 1298; mul 391 1300; add 1323 1324; mul 394 1303; add 1325
1326; mul 397 1306; add 1327 1328; mul 400 1309; add 1329 1330; mul 403 1312; add 1331 1332; mul 384 1333; mul 417
1318; sub 1334 1335; mul 387 1336; add 1322 1337; mul 701 1338; mul 496 515; add 63 67; add 64 1341; add 66 1342;
mul 104 1343; mul 417 1286; mul 285 1333; add 1345 1346; mul 431 1298; mul 397 1300; add 1348 1349; mul 435 1303;
add 1350 1351; mul 438 1306; add 1352 1353; mul 441 1309; add 1354 1355; mul 412 1312; add 1356 1357; mul 304 1358;
add 1347 1359; mul 460 1298; mul 435 1300; add 1361 1362; mul 403 1303; add 1363 1364; mul 409 1306; add 1365 1366;
mul 468 1309; add 1367 1368; mul 471 1312; add 1369 1370; mul 324 1371; add 1360 1372; mul 429 1373; mul 387 1374;
add 1344 1375; mul 1340 1376; mul 503 515; sub 1377 1378; mul 507 515; div 2 1380; mul 1379 1381; mul 497 1382; mul
515 1383; mul 510 515; mul 509 515; div 2 1386; mul 1383 1387; mul 511 1388; mul 1385 1389; neg 1390; mul 515 1391;
mul 511 1392; mul 517 1390; sub 1393 1394; sub 1384 1395; mul 514 1396; mul 531 1397; le 524 293; le 293 524; add
1399 1400; div 2 1401; mul 1399 1402; le 521 523; le 523 521; add 1404 1405; div 2 1406; mul 1404 1407; mul 1383
1408; mul 1403 1409; mul 527 1410; mul 525 1411; mul 529 1410; add 1412 1413; mul 520 1414; add 1398 1415; mul 536
1383; mul 523 1417; mul 538 1383; add 1418 1419; mul 534 1420; sub 1416 1421; mul 497 1422; mul 561 1383; mul 523
1424; mul 563 1383; add 1425 1426; mul 559 1427; mul 557 1388; mul 510 1429; mul 558 1388; add 1430 1431; mul 510
1432; mul 510 558; mul 1388 1434; add 1433 1435; mul 497 1436; mul 565 1437; sub 1428 1438; mul 554 1439; add 1423
1440; mul 569 1439; mul 566 1442; mul 570 1439; add 1443 1444; mul 603 1445; mul 497 1390; mul 503 1447; add 512
1448; mul 0 1449; mul 574 1376; add 572 1451; mul 512 1452; mul 576 1447; add 1453 1454; mul 17 1455; mul 130 1456;
sub 1450 1457; mul 512 1376; mul 496 1447; sub 1459 1460; mul 601 1461; mul 583 1338; mul 587 1358; mul 387 1464;
add 28 1465; mul 130 1466; add 1463 1467; mul 595 1371; mul 387 1469; add 47 1470; mul 599 1471; add 1468 1472; mul
513 1473; add 1462 1474; add 1458 1475; mul 571 1476; add 1446 1477; add 1441 1478; mul 513 1479; mul 605 1461; add
1480 1481; mul 515 614; mul 1376 1483; mul 515 621; sub 1484 1485; mul 515 625; div 2 1487; mul 1486 1488; mul 615
1489; mul 515 1490; mul 515 628; mul 515 627; div 2 1493; mul 1490 1494; mul 629 1495; mul 1492 1496; neg 1497; mul
515 1498; mul 629 1499; mul 634 1497; sub 1500 1501; sub 1491 1502; mul 632 1503; mul 646 1504; le 639 293; le 293
639; add 1506 1507; div 2 1508; mul 1506 1509; le 521 638; le 638 521; add 1511 1512; div 2 1513; mul 1511 1514; mul
1490 1515; mul 1510 1516; mul 642 1517; mul 640 1518; mul 644 1517; add 1519 1520; mul 637 1521; add 1505 1522; mul
651 1490; mul 638 1524; mul 653 1490; add 1525 1526; mul 649 1527; sub 1523 1528; mul 615 1529; mul 561 1490; mul
638 1531; mul 675 1490; add 1532 1533; mul 673 1534; mul 671 1495; mul 628 1536; mul 672 1495; add 1537 1538; mul
628 1539; mul 628 672; mul 1495 1541; add 1540 1542; mul 615 1543; mul 677 1544; sub 1535 1545; mul 669 1546; add
1530 1547; mul 681 1546; mul 678 1549; mul 682 1546; add 1550 1551; mul 696 1552; mul 686 1376; sub 1554 684; mul
630 1555; mul 615 1497; mul 688 1557; sub 1556 1558; mul 17 1559; mul 130 1560; mul 621 1557; add 630 1562; mul 0
1563; add 1561 1564; mul 630 1376; mul 614 1557; sub 1566 1567; mul 601 1568; mul 631 1473; add 1569 1570; add 1565
1571; mul 683 1572; add 1553 1573; add 1548 1574; mul 631 1575; mul 698 1568; add 1576 1577; add 1482 1578; mul 420
1579; sub 1339 1580; sub 1321 1581; mul 144 1582; mul 580 1479; mul 605 1449; sub 1584 1585; mul 692 1575; mul 698
1563; sub 1587 1588; add 1586 1589; sub 1583 1590; sub 1165 1591; input p 192; sub 1592 1593; mul 62 806; mul 22
1595; sub 1594 1596; mul 90 1597; add 1158 1598; mul 89 1141; mul 89 815; mul 1155 1601; sub 1600 1602; mul 889
1603; mul 150 1250; mul 145 1605; mul 818 1287; mul 820 1289; add 1607 1608; mul 332 1292; add 1609 1610; mul 340
1611; mul 835 1298; mul 353 1300; add 1613 1614; mul 839 1303; add 1615 1616; mul 842 1306; add 1617 1618; mul 845
1309; add 1619 1620; mul 373 1312; add 1621 1622; add 1612 1623; mul 145 1624; mul 587 1625; add 1606 1626; mul 701
1466; mul 590 1579; sub 1628 1629; sub 1627 1630; mul 578 1479; mul 605 1456; sub 1632 1633; mul 690 1575; mul 698
1560; add 1635 1636; add 1634 1637; add 1631 1638; sub 1163 1639; mul 28 806; mul 22 1641; sub 1640 1642; mul 815
1643; add 1604 1644; sub 1599 1645; mul 89 1152; mul 89 892; mul 1155 1648; sub 1647 1649; mul 1015 1650; input p
193; mul 903 1168; add 1652 1653; mul 906 1171; add 1654 1655; mul 909 1175; add 1656 1657; mul 227 1178; add 1658
1659; mul 914 1183; add 1660 1661; mul 157 1196; add 1662 1663; mul 919 1199; add 1664 1665; mul 169 1204; add 1666
1667; mul 924 1208; add 1668 1669; mul 184 1244; add 1670 1671; mul 257 1211; add 1672 1673; mul 153 1250; add 1674
1675; mul 145 1676; mul 934 1287; mul 332 1289; add 1678 1679; mul 938 1292; add 1680 1681; mul 340 1682; mul 951
1298; mul 839 1300; add 1684 1685; mul 361 1303; add 1686 1687; mul 369 1306; add 1688 1689; mul 959 1309; add 1690
1691; mul 962 1312; add 1692 1693; add 1683 1694; mul 979 1298; mul 818 1300; add 1696 1697; mul 934 1303; add 1698
1699; mul 328 1306; add 1700 1701; mul 332 1309; add 1702 1703; mul 336 1312; add 1704 1705; mul 978 1706; add 1695
1707; mul 145 1708; mul 595 1709; add 1677 1710; mul 701 1471; mul 598 1579; sub 1712 1713; sub 1711 1714; mul 47
806; mul 22 1716; add 1715 1717; mul 892 1718; add 1651 1719; sub 1646 1720; input c_q 0; mul 90 1722; le 140 139;
le 139 140; add 1724 1725; div 2 1726; mul 1724 1727; mul 0 90; mul 1728 1729; input c_q 1; mul 1730 1731; sub 1723
1732; mul 90 93; input c_q 2; mul 1734 1735; add 1733 1736; mul 90 97; input c_q 3; mul 1738 1739; add 1737 1740;
mul 90 100; add 815 1742; input c_q 4; mul 1743 1744; sub 1741 1745; mul 102 1743; input c_q 5; mul 1747 1748; add
1746 1749; mul 93 1743; input c_q 6; mul 1751 1752; sub 1750 1753; mul 97 1743; input c_q 7; mul 1755 1756; sub 1754
1757; le 128 127; le 127 128; add 1759 1760; div 2 1761; mul 1759 1762; mul 132 1743; mul 1763 1764; input c_q 8;
mul 1765 1766; add 1758 1767; mul 90 102; input c_q 9; mul 1769 1770; add 1768 1771; mul 102 1769; mul 104 1773;
input c_q 10; mul 1774 1775; sub 1772 1776; mul 93 1769; input c_q 11; mul 1778 1779; add 1777 1780; mul 97 1769;
input c_q 12; mul 1782 1783; add 1781 1784; add 1721 1785; mul 56 1122; mul 70 1108; add 1787 1788; mul 79 1138; add
1790 1790; sub 1789 1791; mul 89 1792; mul 89 1021; mul 1155 1794; sub 1793 1795; mul 889 1796; mul 1021 1643; add
1797 1798; mul 813 1603; mul 815 1597; add 1800 1801; sub 1799 1802; mul 59 1122; mul 70 1114; add 1804 1805; mul 76
1138; mul 79 1129; add 1807 1808; sub 1806 1809; mul 89 1810; mul 89 1028; mul 1155 1812; sub 1811 1813; mul 1015
1814; mul 1028 1718; add 1815 1816; add 1803 1817; mul 0 815; mul 1728 1819; mul 1731 1820; mul 815 1722; sub 1821
1822; mul 93 815; mul 1735 1824; sub 1823 1825; mul 97 815; mul 1739 1827; sub 1826 1828; mul 100 815; add 1021
1830; mul 1744 1831; add 1829 1832; mul 102 1831; mul 1748 1834; sub 1833 1835; mul 93 1831; mul 1752 1837; add 1836
1838; mul 97 1831; mul 1756 1840; add 1839 1841; mul 132 1831; mul 1763 1843; mul 1766 1844; sub 1842 1845; mul 102
815; mul 1770 1847; sub 1846 1848; mul 102 1847; mul 104 1850; mul 1775 1851; add 1849 1852; mul 93 1847; mul 1779
1854; sub 1853 1855; mul 97 1847; mul 1783 1857; sub 1856 1858; add 1818 1859; mul 813 1650; mul 892 1597; add 1861
1862; mul 889 1814; mul 1028 1643; add 1864 1865; sub 1863 1866; mul 45 1122; mul 70 1104; add 1868 1869; mul 76
1129; add 1871 1871; sub 1870 1872; mul 89 1873; mul 89 1037; mul 1155 1875; sub 1874 1876; mul 1015 1877; mul 1037
1718; add 1878 1879; sub 1867 1880; mul 892 1722; mul 0 892; mul 1728 1883; mul 1731 1884; sub 1882 1885; mul 93
892; mul 1735 1887; add 1886 1888; mul 97 892; mul 1739 1890; add 1889 1891; mul 100 892; add 1028 1893; mul 1744
1894; sub 1892 1895; mul 102 1894; mul 1748 1897; add 1896 1898; mul 93 1894; mul 1752 1900; sub 1899 1901; mul 97
1894; mul 1756 1903; sub 1902 1904; mul 132 1894; mul 1763 1906; mul 1766 1907; add 1905 1908; mul 102 892; mul 1770
1910; add 1909 1911; mul 102 1910; mul 104 1913; mul 1775 1914; sub 1912 1915; mul 93 1910; mul 1779 1917; add 1916
1918; mul 97 1910; mul 1783 1920; add 1919 1921; add 1881 1922; mul 603 1439; mul 566 1476; add 1924 1925; mul 696
1546; mul 678 1572; add 1927 1928; mul 100 129; mul 100 1930; add 141 1931; mul 144 420; mul 513 1933; sub 1934 580;
mul 571 1935; mul 513 1936; mul 631 1933; sub 1938 692; mul 683 1939; mul 631 1940; add 1937 1941; mul 420 1942;
input p 194; add 1943 1944; mul 144 1945; mul 580 1936; mul 692 1940; add 1947 1948; sub 1946 1949; add 1932 1950;
sign 0; mul 747 1952; mul 0 1953; add 749 1954; mul 751 757; mul 757 758; mul 0 757; mul 1957 1958; sub 1956 1959;
add 1955 1960; add 1951 1961; add 772 776; add 773 1963; add 775 1964; mul 67 1965; mul 22 1966; add 1962 1967; mul
90 1968; mul 590 1942; input p 195; add 1970 1971; mul 578 1936; mul 690 1940; add 1973 1974; add 1972 1975; sub
1930 1976; mul 41 1965; mul 22 1978; sub 1977 1979; mul 815 1980; add 1969 1981; mul 598 1942; input p 196; add 1983
1984; mul 53 1965; mul 22 1986; add 1985 1987; mul 892 1988; add 1982 1989; neg 1990; mul 1021 1980; mul 815 1968;
add 1992 1993; mul 1028 1988; add 1994 1995; mul 892 1968; mul 1028 1980; add 1997 1998; mul 1037 1988; add 1999
2000; neg 2001; mul 566 1935; mul 678 1939; where 1071 1072; where 1080 1081; where 1089 1090; where 1098 1099; mul
26 515; div 2 14; mul 11 2010; mul 9 2011; mul 9 24; mul 5 9; mul 2013 2014; sub 2012 2015; mul 17 2016; mul 9 9;
mul 2014 2018; mul 16 2019; mul 16 17; mul 14 2014; mul 8 2011; add 2022 2023; mul 2021 2024; add 2020 2025; mul 24
2026; sub 2017 2027; mul 23 2028; mul 2009 2029; mul 9 38; mul 2014 2031; sub 9 2032; mul 17 2033; mul 38 2026; sub
2034 2035; mul 23 2036; add 31 2037; mul 1102 2038; add 2030 2039; mul 22 2040; mul 18 2026; mul 17 2042; mul 19
2026; add 2043 2044; sub 2041 2045; mul 56 2046; mul 34 1106; mul 22 2048; mul 45 2049; add 2047 2050; mul 53 2038;
mul 34 41; add 2052 2053; mul 22 2054; mul 59 2055; add 2056 2056; sub 2051 2057; mul 89 2058; mul 28 1120; mul 22
2060; mul 61 2061; mul 70 2058; add 2062 2063; mul 28 41; mul 67 2038; add 2065 2066; add 2029 2067; mul 22 2068;
mul 81 2069; mul 56 2069; mul 76 2049; add 2071 2072; mul 79 2055; mul 34 67; add 1111 2075; mul 22 2076; mul 59
2077; add 2074 2078; sub 2073 2079; mul 76 2080; add 2070 2081; sub 2064 2082; mul 86 2077; mul 59 2069; mul 76
2055; add 2085 2086; mul 79 2046; mul 45 2077; add 2088 2089; sub 2087 2090; mul 79 2091; add 2084 2092; add 2083
2093; mul 1119 2094; sub 2059 2095; mul 813 2096; sub 114 107; add 1163 2098; input p 197; mul 35 150; mul 157 2101;
add 2100 2102; mul 35 2101; mul 161 2104; add 2103 2105; mul 150 1174; mul 165 2107; add 2106 2108; mul 35 2107; mul
169 2110; add 2109 2111; mul 155 2107; mul 150 166; add 2113 2114; mul 173 2115; add 2112 2116; mul 148 150; mul 188
2118; add 2117 2119; mul 35 2118; mul 192 2121; add 2120 2122; mul 155 2118; mul 150 189; add 2124 2125; mul 196
2126; add 2123 2127; mul 150 201; mul 200 2129; add 2128 2130; input p 198; mul 224 2101; add 2132 2133; mul 227
2104; add 2134 2135; mul 230 2107; add 2136 2137; mul 233 2110; add 2138 2139; mul 236 2115; add 2140 2141; mul 245
2118; add 2142 2143; mul 248 2121; add 2144 2145; mul 251 2126; add 2146 2147; mul 196 2129; add 2148 2149; mul 147
2150; add 2131 2151; mul 145 2152; le 291 289; le 289 291; add 2154 2155; div 2 2156; mul 2154 2157; le 290 3; le 3
290; add 2159 2160; div 2 2161; mul 2159 2162; mul 2158 2163; constant 1.6666666666666667; le 297 293; le 293 297;
add 2166 2167; div 2 2168; mul 2166 2169; le 140 296; le 296 140; add 2171 2172; div 2 2173; mul 2171 2174; mul 299
2175; mul 2170 2176; mul 299 2177; mul 298 2178; mul 300 2177; add 2179 2180; mul 2165 2181; sub 2164 2182; mul 285
2183; mul 288 2184; mul 304 515; mul 2183 2186; mul 328 2187; add 2185 2188; mul 324 2183; mul 332 2190; add 2189
2191; mul 340 2192; mul 286 2183; mul 345 2194; mul 304 2184; mul 305 2183; add 2196 2197; mul 353 2198; add 2195
2199; mul 324 2184; mul 357 2201; add 2200 2202; mul 304 2187; mul 329 2183; add 2204 2205; mul 365 2206; add 2203
2207; mul 324 2187; mul 369 2209; add 2208 2210; mul 324 2190; mul 373 2212; add 2211 2213; add 2193 2214; mul 145
2215; mul 384 2216; add 2153 2217; input p 199; mul 391 2194; mul 397 2198; add 2220 2221; mul 400 2201; add 2222
2223; mul 406 2206; add 2224 2225; mul 409 2209; add 2226 2227; mul 412 2212; add 2228 2229; mul 384 2230; mul 387
2231; add 2219 2232; mul 701 2233; mul 494 2016; mul 491 2033; add 2235 2236; mul 1378 2237; add 32 37; add 30 2239;
add 36 2240; mul 104 2241; mul 285 2230; mul 457 2183; mul 397 2194; mul 438 2198; add 2245 2246; mul 441 2201; add
2247 2248; mul 446 2206; add 2249 2250; mul 449 2209; add 2251 2252; mul 452 2212; add 2253 2254; mul 304 2255; add
2244 2256; add 2243 2257; mul 435 2194; mul 409 2198; add 2259 2260; mul 468 2201; add 2261 2262; mul 474 2206; add
2263 2264; mul 452 2209; add 2265 2266; mul 479 2212; add 2267 2268; mul 324 2269; add 2258 2270; mul 429 2271; mul
387 2272; add 2242 2273; mul 491 2016; add 2274 2275; mul 494 2033; sub 2276 2277; mul 1340 2278; add 2238 2279; mul
1381 2280; mul 497 2281; mul 515 2282; mul 1387 2282; mul 511 2284; mul 1385 2285; neg 2286; mul 515 2287; mul 511
2288; mul 517 2286; sub 2289 2290; sub 2283 2291; mul 514 2292; mul 531 2293; mul 1408 2282; mul 1403 2295; mul 527
2296; mul 525 2297; mul 529 2296; add 2298 2299; mul 520 2300; add 2294 2301; mul 536 2282; mul 523 2303; mul 538
2282; add 2304 2305; mul 534 2306; sub 2302 2307; mul 497 2308; mul 561 2282; mul 523 2310; mul 563 2282; add 2311
2312; mul 559 2313; mul 557 2284; mul 510 2315; mul 558 2284; add 2316 2317; mul 510 2318; mul 1434 2284; add 2319
2320; mul 497 2321; mul 565 2322; sub 2314 2323; mul 554 2324; add 2309 2325; mul 569 2324; mul 566 2327; mul 570
2324; add 2328 2329; mul 603 2330; mul 572 2237; sub 2275 2277; mul 503 2333; add 2332 2334; mul 574 2278; mul 496
2237; add 2336 2337; sub 2335 2338; mul 512 2339; mul 497 2286; mul 576 2341; sub 2340 2342; mul 17 2343; mul 577
2026; sub 2344 2345; mul 130 2346; mul 512 2237; mul 503 2341; sub 2348 2349; mul 0 2350; sub 2347 2351; mul 512
2278; mul 496 2341; sub 2353 2354; mul 601 2355; mul 583 2233; mul 587 2255; mul 585 2177; mul 457 2359; sub 2358
2360; mul 387 2361; add 31 2362; mul 130 2363; add 2357 2364; mul 595 2269; mul 387 2366; add 34 2367; mul 599 2368;
add 2365 2369; mul 513 2370; add 2356 2371; add 2352 2372; mul 571 2373; add 2331 2374; add 2326 2375; mul 513 2376;
mul 605 2355; add 2377 2378; mul 609 2033; mul 612 2016; sub 2380 2381; mul 1485 2382; mul 609 2016; add 2274 2384;
mul 612 2033; add 2385 2386; mul 1483 2387; add 2383 2388; mul 1488 2389; mul 615 2390; mul 515 2391; mul 1494 2391;
mul 629 2393; mul 1492 2394; neg 2395; mul 515 2396; mul 629 2397; mul 634 2395; sub 2398 2399; sub 2392 2400; mul
632 2401; mul 646 2402; mul 1515 2391; mul 1510 2404; mul 642 2405; mul 640 2406; mul 644 2405; add 2407 2408; mul
637 2409; add 2403 2410; mul 651 2391; mul 638 2412; mul 653 2391; add 2413 2414; mul 649 2415; sub 2411 2416; mul
615 2417; mul 561 2391; mul 638 2419; mul 675 2391; add 2420 2421; mul 673 2422; mul 671 2393; mul 628 2424; mul 672
2393; add 2425 2426; mul 628 2427; mul 1541 2393; add 2428 2429; mul 615 2430; mul 677 2431; sub 2423 2432; mul 669
2433; add 2418 2434; mul 681 2433; mul 678 2436; mul 682 2433; add 2437 2438; mul 696 2439; mul 684 2382; add 2384
2386; mul 621 2442; add 2441 2443; mul 686 2387; sub 2381 2380; mul 614 2446; add 2445 2447; add 2444 2448; mul 630
2449; mul 615 2395; mul 688 2451; sub 2450 2452; mul 17 2453; mul 689 2026; sub 2454 2455; mul 130 2456; mul 630
2382; mul 621 2451; sub 2458 2459; mul 0 2460; sub 2457 2461; mul 630 2387; mul 614 2451; sub 2463 2464; mul 601
2465; mul 631 2370; add 2466 2467; add 2462 2468; mul 683 2469; add 2440 2470; add 2435 2471; mul 631 2472; mul 698
2465; add 2473 2474; add 2379 2475; mul 420 2476; sub 2234 2477; sub 2218 2478; mul 144 2479; mul 580 2376; mul 605
2350; add 2481 2482; mul 692 2472; mul 698 2460; add 2484 2485; add 2483 2486; sub 2480 2487; sub 2099 2488; mul 802
2033; mul 16 2014; mul 16 798; mul 2024 2492; sub 2491 2493; mul 10 2494; mul 798 2495; mul 799 2494; add 2496 2497;
mul 797 2014; mul 9 2499; mul 9 797; mul 2014 2501; add 2500 2502; sub 2498 2503; mul 3 2504; add 801 2505; mul 38
2506; add 2490 2507; sub 2028 2508; mul 794 2509; mul 130 2026; mul 130 2511; mul 23 2512; mul 804 2513; sub 2510
2514; mul 67 2515; add 1641 2516; mul 802 2016; mul 24 2506; add 2518 2519; add 2036 2520; mul 794 2521; mul 809
2513; sub 2522 2523; sub 2517 2524; mul 22 2525; sub 2489 2526; mul 90 2527; add 2097 2528; mul 89 2080; mul 1601
2094; sub 2530 2531; mul 889 2532; mul 875 2033; mul 17 2534; mul 876 2026; sub 2535 2536; mul 150 2150; mul 145
2538; mul 820 2184; mul 825 2187; add 2540 2541; mul 828 2190; add 2542 2543; mul 340 2544; mul 353 2194; mul 842
2198; add 2546 2547; mul 845 2201; add 2548 2549; mul 850 2206; add 2550 2551; mul 853 2209; add 2552 2553; mul 856
2212; add 2554 2555; add 2545 2556; mul 145 2557; mul 587 2558; mul 863 2359; sub 2559 2560; add 2539 2561; mul 701
2363; mul 590 2476; sub 2563 2564; sub 2562 2565; mul 578 2376; mul 605 2346; add 2567 2568; mul 690 2472; mul 698
2456; add 2570 2571; add 2569 2572; add 2566 2573; add 118 2574; sub 2537 2575; mul 806 2038; mul 41 2515; add 2577
2578; mul 810 2029; mul 26 2524; add 2580 2581; sub 2579 2582; mul 22 2583; mul 19 2506; mul 802 2042; sub 2585
2586; mul 793 2587; mul 886 2512; sub 2588 2589; sub 2584 2590; sub 2576 2591; mul 815 2592; add 2533 2593; sub 2529
2594; mul 89 2091; mul 1648 2094; sub 2596 2597; mul 1015 2598; input p 200; mul 903 2101; add 2600 2601; mul 906
2104; add 2602 2603; mul 909 2107; add 2604 2605; mul 227 2110; add 2606 2607; mul 914 2115; add 2608 2609; mul 157
2118; add 2610 2611; mul 919 2121; add 2612 2613; mul 169 2126; add 2614 2615; mul 257 2129; add 2616 2617; mul 153
2150; add 2618 2619; mul 145 2620; mul 332 2184; mul 941 2187; add 2622 2623; mul 944 2190; add 2624 2625; mul 340
2626; mul 839 2194; mul 369 2198; add 2628 2629; mul 959 2201; add 2630 2631; mul 965 2206; add 2632 2633; mul 856
2209; add 2634 2635; mul 970 2212; add 2636 2637; add 2627 2638; mul 818 2194; mul 328 2198; add 2640 2641; mul 332
2201; add 2642 2643; mul 991 2206; add 2644 2645; mul 941 2209; add 2646 2647; mul 831 2212; add 2648 2649; mul 978
2650; add 2639 2651; mul 145 2652; mul 595 2653; add 2621 2654; mul 701 2368; mul 598 2476; sub 2656 2657; sub 2655
2658; mul 34 806; mul 53 2515; add 2660 2661; mul 22 2662; add 2659 2663; mul 892 2664; add 2599 2665; sub 2595
2666; mul 56 2061; mul 70 2049; add 2668 2669; mul 79 2077; add 2671 2671; sub 2670 2672; mul 89 2673; mul 1794
2094; sub 2674 2675; mul 889 2676; mul 1021 2592; add 2677 2678; mul 813 2532; mul 815 2527; add 2680 2681; sub 2679
2682; mul 59 2061; mul 70 2055; add 2684 2685; mul 76 2077; mul 79 2069; add 2687 2688; sub 2686 2689; mul 89 2690;
mul 1812 2094; sub 2691 2692; mul 1015 2693; mul 1028 2664; add 2694 2695; add 2683 2696; mul 813 2598; mul 892
2527; add 2698 2699; mul 889 2693; mul 1028 2592; add 2701 2702; sub 2700 2703; mul 45 2061; mul 70 2046; add 2705
2706; mul 76 2069; add 2708 2708; sub 2707 2709; mul 89 2710; mul 1875 2094; sub 2711 2712; mul 1015 2713; mul 1037
2664; add 2714 2715; sub 2704 2716; mul 603 2324; mul 566 2373; add 2718 2719; mul 696 2433; mul 678 2469; add 2721
2722; mul 513 590; add 578 2724; mul 571 2725; mul 513 2726; mul 590 631; add 690 2728; mul 683 2729; mul 631 2730;
add 2727 2731; mul 420 2732; input p 201; add 2733 2734; mul 144 2735; mul 580 2726; mul 692 2730; add 2737 2738;
sub 2736 2739; sub 1930 2740; add 779 782; add 778 2742; add 781 2743; mul 515 792; mul 23 2745; mul 804 2746; add
2744 2747; mul 67 2748; mul 809 2746; sub 2749 2750; mul 22 2751; sub 2741 2752; mul 90 2753; mul 590 2732; input p
202; add 2755 2756; mul 578 2726; mul 690 2730; add 2758 2759; add 2757 2760; add 129 2761; mul 41 2748; mul 26
2750; sub 2763 2764; mul 22 2765; mul 886 2745; sub 2766 2767; add 2762 2768; mul 815 2769; add 2754 2770; mul 598
2732; input p 203; add 2772 2773; mul 53 2748; mul 22 2775; add 2774 2776; mul 892 2777; sub 2771 2778; mul 1028
2777; mul 1021 2769; mul 815 2753; add 2781 2782; sub 2780 2783; mul 892 2753; mul 1028 2769; add 2785 2786; mul
1037 2777; sub 2787 2788; mul 566 2725; mul 678 2729; input p 204; where 1071 2792; input p 205; where 1080 2794;
input p 206; where 1089 2796; input p 207; where 1098 2798; mul 34 1102; mul 22 2800; mul 56 2801; mul 51 1106; mul
22 2803; mul 45 2804; add 2802 2805; mul 34 53; mul 41 51; add 2807 2808; mul 22 2809; mul 59 2810; add 2811 2811;
sub 2806 2812; mul 89 2813; mul 47 1120; mul 22 2815; mul 61 2816; mul 70 2813; add 2817 2818; add 1112 2075; mul 22
2820; mul 81 2821; mul 56 2821; mul 76 2804; add 2823 2824; mul 79 2810; mul 51 67; mul 47 53; add 2827 2828; mul 22
2829; mul 59 2830; add 2826 2831; sub 2825 2832; mul 76 2833; add 2822 2834; sub 2819 2835; mul 86 2830; mul 59
2821; mul 76 2810; add 2838 2839; mul 79 2801; mul 45 2830; add 2841 2842; sub 2840 2843; mul 79 2844; add 2837
2845; add 2836 2846; mul 1119 2847; sub 2814 2848; mul 813 2849; input p 208; add 154 155; mul 157 2852; add 2851
2853; mul 35 2852; add 158 2855; mul 161 2856; add 2854 2857; mul 153 1174; mul 165 2859; add 2858 2860; mul 35
2859; add 166 2862; mul 169 2863; add 2861 2864; mul 155 2859; mul 153 166; add 2866 2867; mul 173 2868; add 2865
2869; mul 148 180; add 2870 2871; mul 181 515; mul 184 2873; add 2872 2874; mul 148 153; mul 188 2876; add 2875
2877; mul 35 2876; add 189 2879; mul 192 2880; add 2878 2881; mul 155 2876; mul 153 189; add 2883 2884; mul 196
2885; add 2882 2886; mul 153 201; mul 200 2888; add 2887 2889; mul 35 515; mul 213 2891; add 210 2892; mul 35 2891;
add 214 2894; mul 217 2895; add 2893 2896; input p 209; add 2897 2898; mul 224 2852; add 2899 2900; mul 227 2856;
add 2901 2902; mul 230 2859; add 2903 2904; mul 233 2863; add 2905 2906; mul 236 2868; add 2907 2908; mul 148 157;
add 2909 2910; mul 161 2873; add 2911 2912; mul 245 2876; add 2913 2914; mul 248 2880; add 2915 2916; mul 251 2885;
add 2917 2918; mul 201 257; add 2919 2920; mul 196 2888; add 2921 2922; mul 147 2923; add 2890 2924; mul 145 2925;
le 311 309; le 309 311; add 2927 2928; div 2 2929; mul 2927 2930; le 310 35; le 35 310; add 2932 2933; div 2 2934;
mul 2932 2935; mul 2931 2936; constant 0.625; le 317 313; le 313 317; add 2939 2940; div 2 2941; mul 2939 2942; le
140 316; le 316 140; add 2944 2945; div 2 2946; mul 2944 2947; mul 319 2948; mul 2943 2949; mul 319 2950; mul 318
2951; mul 320 2950; add 2952 2953; mul 2938 2954; sub 2937 2955; mul 285 2956; mul 308 2957; mul 304 2956; mul 332
2959; add 2958 2960; mul 324 515; mul 2956 2962; mul 336 2963; add 2961 2964; mul 340 2965; mul 324 2963; mul 337
2956; add 2967 2968; mul 339 2969; add 2966 2970; mul 286 2956; mul 349 2972; mul 305 2956; mul 357 2974; add 2973
2975; mul 324 2957; mul 325 2956; add 2977 2978; mul 361 2979; add 2976 2980; mul 329 2956; mul 369 2982; add 2981
2983; mul 324 2959; mul 333 2956; add 2985 2986; mul 373 2987; add 2984 2988; mul 377 2969; add 2989 2990; add 2971
2991; mul 145 2992; mul 384 2993; add 2926 2994; input p 210; mul 394 2972; mul 400 2974; add 2997 2998; mul 403
2979; add 2999 3000; mul 409 2982; add 3001 3002; mul 412 2987; add 3003 3004; mul 415 2969; add 3005 3006; mul 384
3007; mul 387 3008; add 2996 3009; mul 701 3010; add 52 53; add 50 3012; mul 104 3013; mul 285 3007; mul 435 2972;
mul 441 2974; add 3016 3017; mul 412 2979; add 3018 3019; mul 449 2982; add 3020 3021; mul 452 2987; add 3022 3023;
mul 455 2969; add 3024 3025; mul 304 3026; add 3015 3027; mul 484 2956; mul 403 2972; mul 468 2974; add 3030 3031;
mul 471 2979; add 3032 3033; mul 452 2982; add 3034 3035; mul 479 2987; add 3036 3037; mul 482 2969; add 3038 3039;
mul 324 3040; add 3029 3041; add 3028 3042; mul 429 3043; mul 387 3044; add 3014 3045; mul 1340 3046; mul 1381 3047;
mul 497 3048; mul 515 3049; mul 1387 3049; mul 511 3051; mul 1385 3052; neg 3053; mul 515 3054; mul 511 3055; mul
517 3053; sub 3056 3057; sub 3050 3058; mul 514 3059; mul 531 3060; mul 1408 3049; mul 1403 3062; mul 527 3063; mul
525 3064; mul 529 3063; add 3065 3066; mul 520 3067; add 3061 3068; mul 536 3049; mul 523 3070; mul 538 3049; add
3071 3072; mul 534 3073; sub 3069 3074; mul 497 3075; mul 561 3049; mul 523 3077; mul 563 3049; add 3078 3079; mul
559 3080; mul 557 3051; mul 510 3082; mul 558 3051; add 3083 3084; mul 510 3085; mul 1434 3051; add 3086 3087; mul
497 3088; mul 565 3089; sub 3081 3090; mul 554 3091; add 3076 3092; mul 569 3091; mul 566 3094; mul 570 3091; add
3095 3096; mul 603 3097; mul 497 3053; mul 503 3099; mul 0 3100; mul 574 3046; mul 512 3102; mul 576 3099; add 3103
3104; mul 17 3105; mul 130 3106; sub 3101 3107; mul 512 3046; mul 496 3099; sub 3109 3110; mul 601 3111; mul 583
3010; mul 587 3026; mul 387 3114; add 34 3115; mul 130 3116; add 3113 3117; mul 595 3040; mul 593 2950; mul 484
3120; sub 3119 3121; mul 387 3122; add 51 3123; mul 599 3124; add 3118 3125; mul 513 3126; add 3112 3127; add 3108
3128; mul 571 3129; add 3098 3130; add 3093 3131; mul 513 3132; mul 605 3111; add 3133 3134; mul 1483 3046; mul 1488
3136; mul 615 3137; mul 515 3138; mul 1494 3138; mul 629 3140; mul 1492 3141; neg 3142; mul 515 3143; mul 629 3144;
mul 634 3142; sub 3145 3146; sub 3139 3147; mul 632 3148; mul 646 3149; mul 1515 3138; mul 1510 3151; mul 642 3152;
mul 640 3153; mul 644 3152; add 3154 3155; mul 637 3156; add 3150 3157; mul 651 3138; mul 638 3159; mul 653 3138;
add 3160 3161; mul 649 3162; sub 3158 3163; mul 615 3164; mul 561 3138; mul 638 3166; mul 675 3138; add 3167 3168;
mul 673 3169; mul 671 3140; mul 628 3171; mul 672 3140; add 3172 3173; mul 628 3174; mul 1541 3140; add 3175 3176;
mul 615 3177; mul 677 3178; sub 3170 3179; mul 669 3180; add 3165 3181; mul 681 3180; mul 678 3183; mul 682 3180;
add 3184 3185; mul 696 3186; mul 686 3046; mul 630 3188; mul 615 3142; mul 688 3190; sub 3189 3191; mul 17 3192; mul
130 3193; mul 621 3190; mul 0 3195; add 3194 3196; mul 630 3046; mul 614 3190; sub 3198 3199; mul 601 3200; mul 631
3126; add 3201 3202; add 3197 3203; mul 683 3204; add 3187 3205; add 3182 3206; mul 631 3207; mul 698 3200; add 3208
3209; add 3135 3210; mul 420 3211; sub 3011 3212; sub 2995 3213; mul 144 3214; mul 580 3132; mul 605 3100; sub 3216
3217; mul 692 3207; mul 698 3195; sub 3219 3220; add 3218 3221; sub 3215 3222; add 1717 3223; mul 90 3224; sub 2850
3225; mul 89 2833; mul 1601 2847; sub 3227 3228; mul 889 3229; mul 150 2923; mul 145 3231; mul 332 2957; mul 828
2959; add 3233 3234; mul 831 2963; add 3235 3236; mul 340 3237; mul 833 2969; add 3238 3239; mul 839 2972; mul 845
2974; add 3241 3242; mul 373 2979; add 3243 3244; mul 853 2982; add 3245 3246; mul 856 2987; add 3247 3248; mul 859
2969; add 3249 3250; add 3240 3251; mul 145 3252; mul 587 3253; add 3232 3254; mul 701 3116; mul 590 3211; sub 3256
3257; sub 3255 3258; mul 578 3132; mul 605 3106; sub 3260 3261; mul 690 3207; mul 698 3193; add 3263 3264; add 3262
3265; add 3259 3266; mul 22 2660; add 3267 3268; mul 815 3269; sub 3230 3270; sub 3226 3271; mul 89 2844; mul 1648
2847; sub 3273 3274; mul 1015 3275; mul 895 2891; add 893 3277; mul 898 2895; add 3278 3279; input p 211; add 3280
3281; mul 903 2852; add 3282 3283; mul 906 2856; add 3284 3285; mul 909 2859; add 3286 3287; mul 227 2863; add 3288
3289; mul 914 2868; add 3290 3291; mul 157 2876; add 3292 3293; mul 919 2880; add 3294 3295; mul 169 2885; add 3296
3297; mul 184 201; add 3298 3299; mul 257 2888; add 3300 3301; mul 153 2923; add 3302 3303; mul 145 3304; mul 938
2957; mul 944 2959; add 3306 3307; mul 947 2963; add 3308 3309; mul 340 3310; mul 949 2969; add 3311 3312; mul 361
2972; mul 959 2974; add 3314 3315; mul 962 2979; add 3316 3317; mul 856 2982; add 3318 3319; mul 970 2987; add 3320
3321; mul 973 2969; add 3322 3323; add 3313 3324; mul 977 2963; mul 1000 3326; mul 934 2972; mul 332 2974; add 3328
3329; mul 336 2979; add 3330 3331; mul 941 2982; add 3332 3333; mul 831 2987; add 3334 3335; mul 998 2969; add 3336
3337; mul 978 3338; add 3327 3339; add 3325 3340; mul 145 3341; mul 595 3342; mul 1003 3120; sub 3343 3344; add 3305
3345; mul 701 3124; mul 598 3211; sub 3347 3348; sub 3346 3349; mul 51 806; mul 22 3351; add 3350 3352; mul 892
3353; add 3276 3354; sub 3272 3355; mul 56 2816; mul 70 2804; add 3357 3358; mul 79 2830; add 3360 3360; sub 3359
3361; mul 89 3362; mul 1794 2847; sub 3363 3364; mul 889 3365; mul 1021 3269; sub 3366 3367; mul 813 3229; mul 815
3224; sub 3369 3370; sub 3368 3371; mul 59 2816; mul 70 2810; add 3373 3374; mul 76 2830; mul 79 2821; add 3376
3377; sub 3375 3378; mul 89 3379; mul 1812 2847; sub 3380 3381; mul 1015 3382; mul 1028 3353; add 3383 3384; add
3372 3385; mul 813 3275; mul 892 3224; sub 3387 3388; mul 889 3382; mul 1028 3269; sub 3390 3391; sub 3389 3392; mul
45 2816; mul 70 2801; add 3394 3395; mul 76 2821; add 3397 3397; sub 3396 3398; mul 89 3399; mul 1875 2847; sub 3400
3401; mul 1015 3402; mul 1037 3353; add 3403 3404; sub 3393 3405; mul 603 3091; mul 566 3129; add 3407 3408; mul 696
3180; mul 678 3204; add 3410 3411; mul 513 598; mul 571 3413; mul 513 3414; mul 598 631; mul 683 3416; mul 631 3417;
add 3415 3418; mul 590 3419; input p 212; add 3420 3421; mul 578 3414; mul 690 3417; add 3423 3424; add 3422 3425;
add 788 789; add 787 3427; mul 41 3428; mul 22 3429; add 3426 3430; mul 815 3431; mul 420 3419; input p 213; add
3433 3434; mul 144 3435; mul 580 3414; mul 692 3417; add 3437 3438; sub 3436 3439; mul 67 3428; mul 22 3441; add
3440 3442; mul 90 3443; sub 3432 3444; mul 598 3419; input p 214; add 3446 3447; mul 53 3428; mul 22 3449; add 3448
3450; mul 892 3451; sub 3445 3452; mul 815 3443; mul 1021 3431; sub 3454 3455; mul 1028 3451; add 3456 3457; mul
1028 3431; mul 892 3443; sub 3459 3460; mul 1037 3451; sub 3461 3462; mul 566 3413; mul 678 3416; mul 544 566; mul
513 3466; mul 590 3467; mul 578 3466; add 3468 3469; mul 815 3470; mul 420 3467; mul 144 3472; mul 580 3466; sub
3473 3474; mul 90 3475; sub 3471 3476; mul 598 3467; mul 892 3478; sub 3477 3479; mul 815 3475; mul 1021 3470; sub
3481 3482; mul 1028 3478; add 3483 3484; mul 1028 3470; mul 892 3475; sub 3486 3487; mul 1037 3478; sub 3488 3489;
input p 215; mul 659 678; mul 631 3492; mul 590 3493; mul 690 3492; add 3494 3495; mul 815 3496; mul 420 3493; mul
144 3498; mul 692 3492; sub 3499 3500; mul 90 3501; sub 3497 3502; mul 598 3493; mul 892 3504; sub 3503 3505; mul
815 3501; mul 1021 3496; sub 3507 3508; mul 1028 3504; add 3509 3510; mul 1028 3496; mul 892 3501; sub 3512 3513;
mul 1037 3504; sub 3514 3515; mul 547 566; mul 513 3517; mul 590 3518; mul 578 3517; add 3519 3520; mul 815 3521;
mul 420 3518; mul 144 3523; mul 580 3517; sub 3524 3525; mul 90 3526; sub 3522 3527; mul 598 3518; mul 892 3529; sub
3528 3530; mul 815 3526; mul 1021 3521; sub 3532 3533; mul 1028 3529; add 3534 3535; mul 1028 3521; mul 892 3526;
sub 3537 3538; mul 1037 3529; sub 3539 3540; input p 216; mul 662 678; mul 631 3543; mul 590 3544; mul 690 3543; add
3545 3546; mul 815 3547; mul 420 3544; mul 144 3549; mul 692 3543; sub 3550 3551; mul 90 3552; sub 3548 3553; mul
598 3544; mul 892 3555; sub 3554 3556; mul 815 3552; mul 1021 3547; sub 3558 3559; mul 1028 3555; add 3560 3561; mul
1028 3547; mul 892 3552; sub 3563 3564; mul 1037 3555; sub 3565 3566; mul 551 566; mul 513 3568; mul 590 3569; mul
578 3568; add 3570 3571; mul 815 3572; mul 420 3569; mul 144 3574; mul 580 3568; sub 3575 3576; mul 90 3577; sub
3573 3578; mul 598 3569; mul 892 3580; sub 3579 3581; mul 815 3577; mul 1021 3572; sub 3583 3584; mul 1028 3580; add
3585 3586; mul 1028 3572; mul 892 3577; sub 3588 3589; mul 1037 3580; sub 3590 3591; input p 217; mul 666 678; mul
631 3594; mul 590 3595; mul 690 3594; add 3596 3597; mul 815 3598; mul 420 3595; mul 144 3600; mul 692 3594; sub
3601 3602; mul 90 3603; sub 3599 3604; mul 598 3595; mul 892 3606; sub 3605 3607; mul 815 3603; mul 1021 3598; sub
3609 3610; mul 1028 3606; add 3611 3612; mul 1028 3598; mul 892 3603; sub 3614 3615; mul 1037 3606; sub 3616 3617;
mul 90 762; mul 762 815; neg 3620; mul 762 892; input p 218; mul 90 766; mul 766 815; neg 3625; mul 766 892; input p
219; input p 220; mul 815 3629; mul 90 731; sub 3630 3631; mul 731 815; mul 1021 3629; sub 3633 3634; mul 1028 3629;
mul 731 892; sub 3636 3637; input p 221; mul 815 3639; mul 90 734; sub 3640 3641; mul 734 815; mul 1021 3639; sub
3643 3644; mul 1028 3639; mul 734 892; sub 3646 3647; input p 222; mul 815 3649; mul 90 738; sub 3650 3651; mul 738
815; mul 1021 3649; sub 3653 3654; mul 1028 3649; mul 738 892; sub 3656 3657; input p 223; mul 815 3659; mul 90 742;
sub 3660 3661; mul 742 815; mul 1021 3659; sub 3663 3664; mul 1028 3659; mul 742 892; sub 3666 3667; mul 102 109;
add 92 3669; mul 100 121; sub 3670 3671; mul 533 540; mul 497 3673; mul 580 3674; mul 513 3674; mul 420 3676; mul
144 3677; sub 3675 3678; sub 3672 3679; mul 90 3680; mul 590 3676; mul 578 3674; add 3682 3683; add 121 3684; mul
815 3685; sub 3681 3686; mul 598 3676; mul 892 3688; add 3687 3689; mul 1021 3685; mul 815 3680; sub 3691 3692; mul
1028 3688; sub 3693 3694; mul 892 3680; mul 1028 3685; sub 3696 3697; mul 1037 3688; add 3698 3699; mul 102 112; add
96 3701; mul 100 124; sub 3702 3703; mul 648 655; mul 615 3705; mul 692 3706; mul 631 3706; mul 420 3708; mul 144
3709; sub 3707 3710; sub 3704 3711; mul 90 3712; mul 590 3708; mul 690 3706; add 3714 3715; add 124 3716; mul 815
3717; sub 3713 3718; mul 598 3708; mul 892 3720; add 3719 3721; mul 1021 3717; mul 815 3712; sub 3723 3724; mul 1028
3720; sub 3725 3726; mul 892 3712; mul 1028 3717; sub 3728 3729; mul 1037 3720; add 3730 3731; neg 815; neg 1730;
neg 1884; neg 1824; neg 1827; neg 1743; neg 1894; neg 1834; neg 1751; neg 1900; neg 1755; neg 1903; neg 1844; neg
1847; neg 1774; neg 1914; neg 1854; neg 1857; store f 0 0; store f 1 1017; store f 2 130; store f 3 1030; store f 4
599; store f 5 1039; store f 6 1043; store f 7 1046; store f 8 1049; store f 9 1051; store f 10 1054; store f 11
1056; store f 12 1058; store f 13 1060; store f 14 1074; store f 15 1083; store f 16 1092; store f 17 1101; store a
18 1786; store a 54 1860; store a 90 1923; store a 108 1926; store a 126 1929; store a 144 1926; store a 162 1929;
store a 180 1926; store a 198 1929; store a 216 1057; store a 234 1059; store a 1 2; store a 19 1991; store a 55
1996; store a 91 2002; store a 109 2003; store a 127 2004; store a 145 2003; store a 163 2004; store a 181 2003;
store a 199 2004; store a 253 2005; store a 271 2006; store a 289 2007; store a 307 2008; store a 20 2667; store a
56 2697; store a 92 2717; store a 110 2720; store a 128 2723; store a 146 2720; store a 164 2723; store a 182 2720;
store a 200 2723; store a 21 2779; store a 39 2; store a 57 2784; store a 93 2789; store a 111 2790; store a 129
2791; store a 147 2790; store a 165 2791; store a 183 2790; store a 201 2791; store a 255 2793; store a 273 2795;
store a 291 2797; store a 309 2799; store a 22 3356; store a 58 3386; store a 94 3406; store a 112 3409; store a 130
3412; store a 148 3409; store a 166 3412; store a 184 3409; store a 202 3412; store a 23 3453; store a 59 3458;
store a 77 2; store a 95 3463; store a 113 3464; store a 131 3465; store a 149 3464; store a 167 3465; store a 185
3464; store a 203 3465; store a 24 3480; store a 60 3485; store a 96 3490; store a 114 3491; store a 25 3506; store
a 61 3511; store a 97 3516; store a 133 3491; store a 26 3531; store a 62 3536; store a 98 3541; store a 152 3542;
store a 27 3557; store a 63 3562; store a 99 3567; store a 171 3542; store a 28 3582; store a 64 3587; store a 100
3592; store a 190 3593; store a 29 3608; store a 65 3613; store a 101 3618; store a 209 3593; store a 30 3619; store
a 66 3621; store a 102 3622; store a 228 3623; store a 31 3624; store a 67 3626; store a 103 3627; store a 247 3628;
store a 32 3632; store a 68 3635; store a 104 3638; store a 33 3642; store a 69 3645; store a 105 3648; store a 34
3652; store a 70 3655; store a 106 3658; store a 35 3662; store a 71 3665; store a 107 3668; store b 2 3690; store b
6 3695; store b 10 3700; store b 3 3722; store b 7 3727; store b 11 3732; store by_c 13 90; store by_c 39 3733;
store by_c 65 892; store by_c 14 3734; store by_c 40 1820; store by_c 66 3735; store by_c 15 1734; store by_c 41
3736; store by_c 67 1887; store by_c 16 1738; store by_c 42 3737; store by_c 68 1890; store by_c 17 3738; store by_c
43 1831; store by_c 69 3739; store by_c 18 1747; store by_c 44 3740; store by_c 70 1897; store by_c 19 3741; store
by_c 45 1837; store by_c 71 3742; store by_c 20 3743; store by_c 46 1840; store by_c 72 3744; store by_c 21 1765;
store by_c 47 3745; store by_c 73 1907; store by_c 22 1769; store by_c 48 3746; store by_c 74 1910; store by_c 23
3747; store by_c 49 1851; store by_c 75 3748; store by_c 24 1778; store by_c 50 3749; store by_c 76 1917; store by_c
25 1782; store by_c 51 3750; store by_c 77 1920
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'p': 238},
    {'by_k': 2052},
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
205; mul 142 148; add 206 207; input p 51; mul 152 209; add 208 210; mul 93 211; add 154 212; mul 91 213; input p
52; constant 0.5249999999999999; constant -0.5249999999999999; max 217 94; min 216 218; constant 0.175; constant
0.0; abs 94; constant 0.35; sub 222 223; max 221 224; min 220 225; sign 94; mul 226 227; mul 226 228; div 1 223; mul
229 230; sub 219 231; mul 232 232; mul 215 233; input p 53; constant 0.8999999999999999; constant
-0.8999999999999999; max 237 2; min 236 238; constant 0.3; abs 2; constant 0.6; sub 241 242; max 221 243; min 240
244; sign 2; mul 245 246; mul 245 247; div 1 242; mul 248 249; sub 239 250; mul 232 251; mul 235 252; add 234 253;
input p 54; constant 2.4000000000000004; constant -2.4000000000000004; max 257 34; min 256 258; constant 0.8; abs
34; constant 1.6; sub 261 262; max 221 263; min 260 264; sign 34; mul 265 266; mul 265 267; div 1 262; mul 268 269;
sub 259 270; mul 232 271; mul 255 272; add 254 273; input p 55; mul 251 251; mul 275 276; add 274 277; input p 56;
mul 251 271; mul 279 280; add 278 281; input p 57; mul 271 271; mul 283 284; add 282 285; mul 271 284; mul 286 287;
input p 58; mul 232 233; mul 289 290; input p 59; mul 233 251; mul 292 293; add 291 294; input p 60; mul 233 271;
mul 296 297; add 295 298; input p 61; mul 251 252; mul 300 301; add 299 302; input p 62; mul 252 271; mul 304 305;
add 303 306; input p 63; mul 271 272; mul 308 309; add 307 310; input p 64; mul 251 276; mul 312 313; add 311 314;
input p 65; mul 271 276; mul 316 317; add 315 318; input p 66; mul 271 280; mul 320 321; add 319 322; input p 67;
mul 287 324; add 323 325; add 288 326; mul 91 327; constant 5.714285714285714; mul 226 329; sub 1 330; mul 328 331;
add 214 332; input p 68; mul 66 334; input p 69; mul 290 336; input p 70; mul 293 338; add 337 339; input p 71; mul
297 341; add 340 342; input p 72; mul 301 344; add 343 345; input p 73; mul 305 347; add 346 348; input p 74; mul
309 350; add 349 351; input p 75; mul 313 353; add 352 354; input p 76; mul 317 356; add 355 357; input p 77; mul
321 359; add 358 360; input p 78; mul 287 362; add 361 363; mul 331 364; mul 334 365; add 335 366; input p 79; input
p 80; constant 0.5; mul 28 66; mul 2 36; add 371 372; mul 34 52; add 373 374; mul 370 375; constant 0.25; mul 232
364; input p 81; mul 290 379; mul 293 344; add 380 381; input p 82; mul 297 383; add 382 384; input p 83; mul 301
386; add 385 387; input p 84; mul 305 389; add 388 390; mul 309 359; add 391 392; input p 85; mul 313 394; add 393
395; input p 86; mul 317 397; add 396 398; input p 87; mul 321 400; add 399 401; input p 88; mul 287 403; add 402
404; mul 251 405; add 378 406; input p 89; mul 290 408; mul 293 383; add 409 410; mul 297 350; add 411 412; mul 301
356; add 413 414; input p 90; mul 305 416; add 415 417; input p 91; mul 309 419; add 418 420; input p 92; mul 313
422; add 421 423; mul 317 400; add 424 425; input p 93; mul 321 427; add 426 428; input p 94; mul 287 430; add 429
431; mul 271 432; add 407 433; mul 377 434; mul 334 435; add 376 436; add 369 437; input p 95; mul 23 439; add 438
440; input p 96; mul 37 442; sub 441 443; input p 97; mul 23 442; input p 98; sub 446 447; mul 37 439; add 448 449;
sub 450 28; mul 451 451; mul 444 444; add 452 453; sqrt 454; mul 445 455; sqrt 456; div 1 457; mul 458 458; mul 445
459; mul 444 460; input p 99; constant 2.0; mul 456 463; mul 459 463; mul 459 465; sub 464 466; mul 462 467;
constant -0.3; constant 1.4; sub 456 470; max 469 471; min 240 472; input p 100; input p 101; mul 473 475; add 474
476; mul 473 477; add 1 478; mul 468 479; input u 0; input p 102; mul 481 482; input p 103; input p 104; mul 471
485; add 484 486; mul 471 487; add 1 488; mul 483 489; sub 480 490; mul 445 491; input p 105; input x 6; mul 493
494; input p 106; input x 8; mul 496 497; add 495 498; input p 107; input x 10; mul 500 501; add 499 502; constant
-0.5; mul 458 504; mul 458 505; mul 458 506; mul 445 507; input p 108; input p 109; mul 471 510; add 509 511; mul
471 512; add 1 513; mul 508 514; mul 503 515; add 492 516; input p 110; mul 515 518; mul 515 519; input x 3; sub 440
443; mul 451 522; add 446 449; mul 444 524; sub 523 525; mul 460 526; mul 16 527; mul 521 528; input x 1; mul 451
460; mul 530 531; sub 529 532; mul 90 530; mul 367 534; constant 3.3333333333333335; mul 245 536; sub 1 537; mul 405
538; mul 334 539; add 36 540; mul 521 541; add 535 542; constant 1.25; mul 265 544; sub 1 545; mul 432 546; mul 334
547; add 52 548; input x 5; mul 549 550; add 543 551; mul 461 552; add 533 553; mul 520 554; add 517 555; mul 461
556; input p 111; add 437 558; input p 112; mul 23 560; add 559 561; input p 113; mul 37 563; add 562 564; input p
114; mul 37 560; mul 23 563; input p 115; sub 568 569; sub 567 570; sub 571 28; mul 572 572; mul 565 565; add 573
574; sqrt 575; mul 566 576; sqrt 577; div 1 578; mul 579 579; mul 566 580; mul 565 581; input p 116; mul 463 577;
mul 463 580; mul 580 585; sub 584 586; mul 583 587; sub 577 470; max 469 589; min 240 590; input p 117; input p 118;
mul 591 593; add 592 594; mul 591 595; add 1 596; mul 588 597; input u 1; input p 119; mul 599 600; input p 120;
input p 121; mul 589 603; add 602 604; mul 589 605; add 1 606; mul 601 607; sub 598 608; mul 566 609; input p 122;
input x 7; mul 611 612; input p 123; input x 9; mul 614 615; add 613 616; input p 124; input x 11; mul 618 619; add
617 620; mul 504 579; mul 579 622; mul 579 623; mul 566 624; mul 510 589; add 509 626; mul 589 627; add 1 628; mul
625 629; mul 621 630; add 610 631; input p 125; mul 630 633; mul 630 634; add 561 564; mul 572 636; sub 568 567; mul
565 638; add 637 639; mul 581 640; mul 16 641; mul 521 642; mul 572 581; mul 530 644; sub 643 645; mul 552 582; add
646 647; mul 635 648; add 632 649; mul 582 650; add 557 651; sub 368 652; mul 367 653; sub 333 654; input p 126;
constant 12.0; mul 534 657; constant -6.0; mul 93 534; mul 96 521; add 660 661; mul 99 550; add 662 663; mul 659
664; add 658 665; mul 656 666; mul 534 659; constant 4.0; mul 664 669; add 668 670; mul 656 671; mul 93 672; add 667
673; add 655 674; mul 90 675; mul 90 676; mul 89 677; mul 80 88; mul 642 679; mul 89 644; add 680 681; mul 85 88;
mul 549 683; mul 541 679; sub 684 685; mul 89 90; mul 367 687; add 686 688; mul 582 689; sub 682 690; mul 635 691;
mul 552 692; mul 650 689; sub 693 694; mul 581 695; mul 650 679; mul 521 692; add 697 698; mul 16 699; mul 581 700;
mul 638 701; add 696 702; mul 463 565; mul 463 576; div 1 705; mul 648 691; mul 634 707; mul 630 707; mul 633 709;
add 708 710; mul 621 691; add 711 712; mul 625 713; mul 627 714; mul 589 714; mul 510 716; add 715 717; mul 566 691;
mul 601 719; mul 605 720; sub 718 721; mul 589 720; mul 603 723; sub 722 724; le 469 589; le 589 469; add 726 727;
div 1 728; mul 726 729; le 590 240; le 240 590; add 731 732; div 1 733; mul 731 734; mul 588 719; mul 595 736; mul
591 736; mul 593 738; add 737 739; mul 735 740; mul 730 741; add 725 742; mul 463 578; div 1 744; mul 579 624; mul
629 713; mul 566 747; mul 746 748; mul 579 748; mul 624 750; add 749 751; mul 579 750; mul 623 753; add 752 754; mul
463 579; mul 565 695; mul 89 650; mul 530 692; sub 758 759; mul 572 760; add 757 761; mul 640 700; add 762 763; mul
566 764; mul 597 719; mul 583 766; mul 585 767; sub 765 768; mul 580 767; neg 770; mul 463 771; add 769 772; mul 756
773; mul 580 774; add 755 775; mul 745 776; sub 743 777; mul 463 767; add 778 779; mul 566 780; mul 706 781; mul 704
782; add 703 783; sub 678 784; mul 653 683; mul 582 692; mul 528 679; mul 89 531; add 788 789; mul 461 689; sub 790
791; mul 520 792; mul 461 793; add 787 794; mul 550 795; add 786 796; mul 547 797; add 785 798; mul 521 795; mul 653
679; sub 800 801; mul 539 802; add 799 803; mul 90 534; mul 96 679; mul 99 683; sub 806 807; mul 93 687; sub 808
809; mul 656 810; mul 659 811; mul 669 811; mul 656 687; mul 659 814; sub 813 815; mul 93 816; add 812 817; mul 657
814; sub 818 819; mul 367 795; add 820 821; mul 805 822; sub 804 823; mul 653 687; mul 534 795; add 825 826; mul 365
827; add 824 828; mul 66 827; add 829 830; mul 552 793; mul 556 689; sub 832 833; mul 460 834; mul 556 679; mul 521
793; add 836 837; mul 16 838; mul 460 839; mul 524 840; sub 835 841; mul 444 463; mul 455 463; div 1 844; mul 554
792; mul 519 846; mul 515 846; mul 518 848; add 847 849; mul 503 792; add 850 851; mul 508 852; mul 512 853; mul 471
853; mul 510 855; add 854 856; mul 445 792; mul 483 858; mul 487 859; sub 857 860; mul 471 859; mul 485 862; sub 861
863; le 469 471; le 471 469; add 865 866; div 1 867; mul 865 868; le 472 240; le 240 472; add 870 871; div 1 872;
mul 870 873; mul 468 858; mul 477 875; mul 473 875; mul 475 877; add 876 878; mul 874 879; mul 869 880; add 864 881;
mul 457 463; div 1 883; mul 458 507; mul 514 852; mul 445 886; mul 885 887; mul 458 887; mul 507 889; add 888 890;
mul 458 889; mul 506 892; add 891 893; mul 458 463; mul 444 834; mul 89 556; mul 530 793; sub 897 898; mul 451 899;
add 896 900; mul 526 839; add 901 902; mul 445 903; mul 479 858; mul 462 905; mul 465 906; sub 904 907; mul 459 906;
neg 909; mul 463 910; add 908 911; mul 895 912; mul 459 913; add 894 914; mul 884 915; sub 882 916; mul 463 906; add
917 918; mul 445 919; mul 845 920; mul 843 921; add 842 922; add 784 923; mul 435 924; add 831 925; sub 926 923; mul
90 94; le 217 94; le 94 217; add 929 930; div 1 931; mul 929 932; le 218 216; le 216 218; add 934 935; div 1 936;
mul 934 937; mul 334 924; mul 377 939; mul 364 940; input p 143; mul 538 679; mul 91 943; mul 942 944; input p 173;
constant 3.0; mul 284 947; mul 546 683; mul 91 949; mul 948 950; mul 946 951; input p 167; mul 950 953; add 952 954;
sub 945 955; mul 334 797; mul 546 957; mul 271 940; add 958 959; mul 408 960; add 956 961; mul 334 802; mul 538 963;
mul 251 940; add 964 965; mul 379 966; add 962 967; mul 334 827; mul 331 969; mul 232 940; add 970 971; mul 336 972;
add 968 973; mul 331 687; mul 91 975; mul 289 976; sub 974 977; mul 233 978; add 941 979; mul 287 944; mul 279 981;
input p 163; mul 287 950; mul 983 984; sub 982 985; mul 320 944; mul 283 951; input p 169; mul 950 989; add 988 990;
sub 987 991; mul 419 960; add 992 993; mul 359 966; add 994 995; mul 350 972; add 996 997; mul 308 976; sub 998 999;
mul 271 1000; add 986 1001; mul 287 976; mul 255 1003; sub 1002 1004; mul 271 1005; add 980 1006; input p 139; mul
981 1008; mul 279 984; sub 1009 1010; input p 146; mul 944 1012; mul 279 951; input p 168; mul 950 1015; add 1014
1016; sub 1013 1017; mul 416 960; add 1018 1019; mul 389 966; add 1020 1021; mul 347 972; add 1022 1023; mul 304
976; sub 1024 1025; mul 271 1026; add 1011 1027; input p 145; mul 944 1029; mul 275 951; mul 316 950; add 1031 1032;
sub 1030 1033; mul 356 960; add 1034 1035; mul 386 966; add 1036 1037; mul 344 972; add 1038 1039; mul 300 976; sub
1040 1041; mul 251 1042; add 1028 1043; mul 235 1003; sub 1044 1045; mul 251 1046; add 1007 1047; mul 232 463; input
p 138; mul 981 1050; input p 162; mul 984 1052; sub 1051 1053; input p 144; mul 944 1055; mul 951 1052; mul 308 950;
add 1057 1058; sub 1056 1059; mul 350 960; add 1060 1061; mul 383 966; add 1062 1063; mul 341 972; add 1064 1065;
mul 296 976; sub 1066 1067; mul 271 1068; add 1054 1069; mul 300 944; mul 951 1050; mul 950 1055; add 1072 1073; sub
1071 1074; mul 383 960; add 1075 1076; mul 344 966; add 1077 1078; mul 338 972; add 1079 1080; mul 292 976; sub 1081
1082; mul 251 1083; add 1070 1084; mul 232 978; add 1085 1086; mul 215 1003; sub 1087 1088; mul 1049 1089; add 1048
1090; mul 938 1091; mul 933 1092; mul 94 463; mul 91 683; mul 203 1095; mul 101 1096; mul 1094 1097; mul 130 1095;
mul 34 1099; mul 1094 1100; add 1098 1101; input p 161; mul 1095 1103; mul 1094 1104; add 1102 1105; mul 115 1095;
mul 101 1107; mul 101 1108; add 1106 1109; input p 160; mul 1095 1111; mul 34 1112; mul 101 1113; add 1110 1114; mul
103 1095; mul 101 1116; add 1115 1117; le 221 224; le 224 221; add 1119 1120; div 1 1121; mul 1119 1122; le 225 220;
le 220 225; add 1124 1125; div 1 1126; mul 1124 1127; mul 364 969; mul 328 687; sub 1129 1130; mul 329 1131;
constant 2.857142857142857; mul 1091 1133; mul 228 1134; add 1132 1135; mul 226 1134; mul 227 1137; add 1136 1138;
mul 1128 1139; mul 1123 1140; mul 227 1141; add 1118 1142; sub 1093 1143; mul 91 679; mul 96 1145; mul 99 1095; sub
1146 1147; mul 91 687; mul 93 1149; sub 1148 1150; mul 209 1151; mul 147 1152; add 1144 1153; mul 94 1152; mul 1094
1155; add 1154 1156; mul 142 1151; mul 101 1158; mul 1094 1159; add 1157 1160; mul 203 1151; mul 34 1162; mul 1094
1163; add 1161 1164; mul 200 1151; mul 1094 1166; add 1165 1167; mul 197 1151; mul 101 1169; mul 101 1170; add 1168
1171; mul 194 1151; mul 34 1173; mul 101 1174; add 1172 1175; mul 191 1151; mul 101 1177; add 1176 1178; mul 107
1151; mul 34 1180; mul 34 1181; add 1179 1182; mul 103 1151; mul 34 1184; add 1183 1185; mul 92 1151; add 1186 1187;
mul 151 1149; mul 147 1189; sub 1188 1190; mul 94 1189; mul 1094 1192; sub 1191 1193; mul 146 1149; mul 101 1195;
mul 1094 1196; sub 1194 1197; mul 142 1149; mul 101 1199; mul 101 1200; sub 1198 1201; mul 138 1149; mul 34 1203;
mul 101 1204; sub 1202 1205; mul 134 1149; mul 101 1207; sub 1206 1208; mul 130 1149; mul 34 1210; mul 34 1211; sub
1209 1212; mul 126 1149; mul 34 1214; sub 1213 1215; mul 123 1149; sub 1216 1217; mul 147 1158; mul 147 1096; mul
135 1107; add 1220 1221; mul 94 1108; add 1222 1223; mul 94 1113; add 1224 1225; mul 94 1116; add 1226 1227; input p
159; mul 1095 1229; mul 112 1230; add 1228 1231; mul 101 463; mul 101 1230; mul 1233 1234; add 1232 1235; mul 173
1095; mul 34 1237; mul 1233 1238; add 1236 1239; input p 158; mul 1095 1241; mul 1233 1242; add 1240 1243; input p
157; mul 1095 1245; mul 34 1246; mul 34 1247; add 1244 1248; input p 156; mul 1095 1250; mul 34 1251; add 1249 1252;
mul 156 1095; add 1253 1254; sub 1219 1255; mul 135 1169; add 1256 1257; mul 94 1170; add 1258 1259; mul 94 1174;
add 1260 1261; mul 94 1177; add 1262 1263; mul 182 1151; mul 112 1265; add 1264 1266; mul 101 1265; mul 1233 1268;
add 1267 1269; mul 179 1151; mul 34 1271; mul 1233 1272; add 1270 1273; mul 176 1151; mul 1233 1275; add 1274 1276;
mul 173 1151; mul 34 1278; mul 34 1279; add 1277 1280; mul 170 1151; mul 34 1282; add 1281 1283; mul 167 1151; add
1284 1285; mul 147 1195; sub 1286 1287; mul 135 1199; sub 1288 1289; mul 94 1200; sub 1290 1291; mul 94 1204; sub
1292 1293; mul 94 1207; sub 1294 1295; mul 119 1149; mul 112 1297; sub 1296 1298; mul 101 1297; mul 1233 1300; sub
1299 1301; mul 115 1149; mul 34 1303; mul 1233 1304; sub 1302 1305; mul 111 1149; mul 1233 1307; sub 1306 1308; mul
107 1149; mul 34 1310; mul 34 1311; sub 1309 1312; mul 103 1149; mul 34 1314; sub 1313 1315; mul 92 1149; sub 1316
1317; mul 93 1318; add 1218 1319; mul 928 1320; sub 927 1321; input p 224; input c 4; input p 14; mul 28 1325; sub 2
1326; input c 5; mul 1327 1328; sub 1324 1329; input c 6; mul 481 1331; add 1330 1332; input c 7; mul 599 1334; add
1333 1335; input c 8; input p 15; max 1337 1338; mul 530 1325; sub 521 1340; mul 1339 1341; sub 1336 1342; mul 89
1343; mul 89 1325; add 679 1345; mul 1339 1346; mul 530 1347; add 1344 1348; mul 1328 1346; input c 9; input c 10;
mul 370 1352; mul 1327 1353; sub 1351 1354; input c 11; mul 481 1356; add 1355 1357; input c 12; mul 599 1359; add
1358 1360; mul 89 1361; add 1350 1362; mul 89 1327; mul 1353 1364; sub 1363 1365; mul 28 1366; add 1349 1367; mul
1323 1368; add 1322 1369; mul 55 69; mul 78 78; sub 1371 1372; mul 88 1373; mul 653 1374; mul 642 1374; mul 644 679;
add 1376 1377; mul 541 1374; mul 58 69; mul 75 78; sub 1380 1381; mul 88 1382; mul 549 1383; sub 1379 1384; mul 90
679; mul 367 1386; sub 1385 1387; mul 582 1388; add 1378 1389; mul 635 1390; mul 582 1391; mul 528 1374; mul 531
679; add 1393 1394; mul 461 1388; add 1395 1396; mul 520 1397; mul 461 1398; add 1392 1399; mul 521 1400; sub 1375
1401; mul 539 1402; mul 677 679; mul 566 1390; mul 601 1405; mul 605 1406; mul 648 1390; mul 634 1408; mul 630 1408;
mul 633 1410; add 1409 1411; mul 621 1390; add 1412 1413; mul 625 1414; mul 627 1415; mul 589 1415; mul 510 1417;
add 1416 1418; sub 1407 1419; mul 589 1406; mul 603 1421; add 1420 1422; mul 588 1405; mul 595 1424; mul 591 1424;
mul 593 1426; add 1425 1427; mul 735 1428; mul 730 1429; sub 1423 1430; mul 629 1414; mul 566 1432; mul 746 1433;
mul 579 1433; mul 624 1435; add 1434 1436; mul 579 1435; mul 623 1438; add 1437 1439; mul 530 1391; sub 1441 697;
mul 572 1442; mul 650 1388; mul 552 1391; add 1444 1445; mul 565 1446; sub 1443 1447; mul 650 1374; mul 521 1391;
add 1449 1450; mul 16 1451; mul 640 1452; sub 1448 1453; mul 566 1454; mul 597 1405; mul 583 1456; mul 585 1457; add
1455 1458; mul 580 1457; mul 463 1460; add 1459 1461; mul 756 1462; mul 580 1463; sub 1440 1464; mul 745 1465; add
1431 1466; neg 1457; mul 463 1468; add 1467 1469; mul 566 1470; mul 706 1471; mul 704 1472; mul 581 1446; mul 581
1452; mul 638 1475; add 1474 1476; sub 1473 1477; add 1404 1478; mul 653 1383; mul 550 1400; add 1480 1481; mul 547
1482; add 1479 1483; sub 1403 1484; mul 99 1383; mul 96 1374; sub 1486 1487; mul 93 1386; add 1488 1489; mul 656
1490; mul 659 1491; mul 669 1491; mul 656 1386; mul 659 1494; add 1493 1495; mul 93 1496; add 1492 1497; mul 657
1494; add 1498 1499; mul 367 1400; sub 1500 1501; mul 805 1502; sub 1485 1503; mul 653 1386; mul 534 1400; add 1505
1506; mul 365 1507; sub 1504 1508; mul 66 1507; sub 1509 1510; mul 556 1374; mul 521 1398; add 1512 1513; mul 16
1514; mul 460 1515; mul 524 1516; mul 556 1388; mul 552 1398; add 1518 1519; mul 460 1520; sub 1517 1521; mul 445
1397; mul 483 1523; mul 487 1524; mul 554 1397; mul 519 1526; mul 515 1526; mul 518 1528; add 1527 1529; mul 503
1397; add 1530 1531; mul 508 1532; mul 512 1533; mul 471 1533; mul 510 1535; add 1534 1536; sub 1525 1537; mul 471
1524; mul 485 1539; add 1538 1540; mul 468 1523; mul 477 1542; mul 473 1542; mul 475 1544; add 1543 1545; mul 874
1546; mul 869 1547; sub 1541 1548; mul 514 1532; mul 445 1550; mul 885 1551; mul 458 1551; mul 507 1553; add 1552
1554; mul 458 1553; mul 506 1556; add 1555 1557; mul 530 1398; sub 1559 836; mul 451 1560; mul 444 1520; sub 1561
1562; mul 526 1515; sub 1563 1564; mul 445 1565; mul 479 1523; mul 462 1567; mul 465 1568; add 1566 1569; mul 459
1568; mul 463 1571; add 1570 1572; mul 895 1573; mul 459 1574; sub 1558 1575; mul 884 1576; add 1549 1577; neg 1568;
mul 463 1579; add 1578 1580; mul 445 1581; mul 845 1582; mul 843 1583; add 1522 1584; add 1478 1585; mul 435 1586;
add 1511 1587; sub 1588 1585; mul 91 1383; mul 203 1590; mul 101 1591; mul 1094 1592; mul 130 1590; mul 34 1594; mul
1094 1595; add 1593 1596; mul 1103 1590; mul 1094 1598; add 1597 1599; mul 115 1590; mul 101 1601; mul 101 1602; add
1600 1603; mul 1111 1590; mul 34 1605; mul 101 1606; add 1604 1607; mul 103 1590; mul 101 1609; add 1608 1610; mul
328 1386; mul 334 1507; mul 364 1613; sub 1612 1614; mul 329 1615; mul 334 1586; mul 377 1617; mul 364 1618; mul 546
1383; mul 91 1620; mul 948 1621; mul 946 1622; mul 953 1621; add 1623 1624; mul 538 1374; mul 91 1626; mul 942 1627;
sub 1625 1628; mul 271 1618; mul 334 1482; mul 546 1631; sub 1630 1632; mul 408 1633; add 1629 1634; mul 334 1402;
mul 538 1636; mul 251 1618; add 1637 1638; mul 379 1639; add 1635 1640; mul 232 1618; mul 331 1613; sub 1642 1643;
mul 336 1644; add 1641 1645; mul 331 1386; mul 91 1647; mul 289 1648; add 1646 1649; mul 233 1650; add 1619 1651;
mul 287 1621; mul 983 1653; mul 287 1627; mul 279 1655; sub 1654 1656; mul 283 1622; mul 989 1621; add 1658 1659;
mul 320 1627; sub 1660 1661; mul 419 1633; add 1662 1663; mul 359 1639; add 1664 1665; mul 350 1644; add 1666 1667;
mul 308 1648; add 1668 1669; mul 271 1670; add 1657 1671; mul 287 1648; mul 255 1673; add 1672 1674; mul 271 1675;
add 1652 1676; mul 279 1653; mul 1008 1655; sub 1678 1679; mul 279 1622; mul 1015 1621; add 1681 1682; mul 1012
1627; sub 1683 1684; mul 416 1633; add 1685 1686; mul 389 1639; add 1687 1688; mul 347 1644; add 1689 1690; mul 304
1648; add 1691 1692; mul 271 1693; add 1680 1694; mul 275 1622; mul 316 1621; add 1696 1697; mul 1029 1627; sub 1698
1699; mul 356 1633; add 1700 1701; mul 386 1639; add 1702 1703; mul 344 1644; add 1704 1705; mul 300 1648; add 1706
1707; mul 251 1708; add 1695 1709; mul 235 1673; add 1710 1711; mul 251 1712; add 1677 1713; mul 1052 1653; mul 1050
1655; sub 1715 1716; mul 1052 1622; mul 308 1621; add 1718 1719; mul 1055 1627; sub 1720 1721; mul 350 1633; add
1722 1723; mul 383 1639; add 1724 1725; mul 341 1644; add 1726 1727; mul 296 1648; add 1728 1729; mul 271 1730; add
1717 1731; mul 1050 1622; mul 1055 1621; add 1733 1734; mul 300 1627; sub 1735 1736; mul 383 1633; add 1737 1738;
mul 344 1639; add 1739 1740; mul 338 1644; add 1741 1742; mul 292 1648; add 1743 1744; mul 251 1745; add 1732 1746;
mul 232 1650; add 1747 1748; mul 215 1673; add 1749 1750; mul 1049 1751; add 1714 1752; mul 1133 1753; mul 228 1754;
add 1616 1755; mul 226 1754; mul 227 1757; add 1756 1758; mul 1128 1759; mul 1123 1760; mul 227 1761; sub 1611 1762;
mul 938 1753; mul 933 1764; add 1763 1765; mul 99 1590; mul 91 1374; mul 96 1768; sub 1767 1769; mul 91 1386; mul 93
1771; add 1770 1772; mul 209 1773; mul 147 1774; add 1766 1775; mul 94 1774; mul 1094 1777; add 1776 1778; mul 142
1773; mul 101 1780; mul 1094 1781; add 1779 1782; mul 203 1773; mul 34 1784; mul 1094 1785; add 1783 1786; mul 200
1773; mul 1094 1788; add 1787 1789; mul 197 1773; mul 101 1791; mul 101 1792; add 1790 1793; mul 194 1773; mul 34
1795; mul 101 1796; add 1794 1797; mul 191 1773; mul 101 1799; add 1798 1800; mul 107 1773; mul 34 1802; mul 34
1803; add 1801 1804; mul 103 1773; mul 34 1806; add 1805 1807; mul 92 1773; add 1808 1809; mul 151 1771; mul 147
1811; add 1810 1812; mul 94 1811; mul 1094 1814; add 1813 1815; mul 146 1771; mul 101 1817; mul 1094 1818; add 1816
1819; mul 142 1771; mul 101 1821; mul 101 1822; add 1820 1823; mul 138 1771; mul 34 1825; mul 101 1826; add 1824
1827; mul 134 1771; mul 101 1829; add 1828 1830; mul 130 1771; mul 34 1832; mul 34 1833; add 1831 1834; mul 126
1771; mul 34 1836; add 1835 1837; mul 123 1771; add 1838 1839; mul 147 1591; mul 135 1601; add 1841 1842; mul 94
1602; add 1843 1844; mul 94 1606; add 1845 1846; mul 94 1609; add 1847 1848; mul 1229 1590; mul 112 1850; add 1849
1851; mul 101 1850; mul 1233 1853; add 1852 1854; mul 173 1590; mul 34 1856; mul 1233 1857; add 1855 1858; mul 1241
1590; mul 1233 1860; add 1859 1861; mul 1245 1590; mul 34 1863; mul 34 1864; add 1862 1865; mul 1250 1590; mul 34
1867; add 1866 1868; mul 156 1590; add 1869 1870; mul 147 1780; add 1871 1872; mul 135 1791; add 1873 1874; mul 94
1792; add 1875 1876; mul 94 1796; add 1877 1878; mul 94 1799; add 1879 1880; mul 182 1773; mul 112 1882; add 1881
1883; mul 101 1882; mul 1233 1885; add 1884 1886; mul 179 1773; mul 34 1888; mul 1233 1889; add 1887 1890; mul 176
1773; mul 1233 1892; add 1891 1893; mul 173 1773; mul 34 1895; mul 34 1896; add 1894 1897; mul 170 1773; mul 34
1899; add 1898 1900; mul 167 1773; add 1901 1902; mul 147 1817; add 1903 1904; mul 135 1821; add 1905 1906; mul 94
1822; add 1907 1908; mul 94 1826; add 1909 1910; mul 94 1829; add 1911 1912; mul 119 1771; mul 112 1914; add 1913
1915; mul 101 1914; mul 1233 1917; add 1916 1918; mul 115 1771; mul 34 1920; mul 1233 1921; add 1919 1922; mul 111
1771; mul 1233 1924; add 1923 1925; mul 107 1771; mul 34 1927; mul 34 1928; add 1926 1929; mul 103 1771; mul 34
1931; add 1930 1932; mul 92 1771; add 1933 1934; mul 93 1935; add 1840 1936; mul 928 1937; sub 1589 1938; mul 679
1343; mul 679 1325; add 1374 1941; mul 1339 1942; mul 530 1943; add 1940 1944; mul 679 1327; mul 1353 1946; mul 1328
1942; mul 679 1361; add 1948 1949; sub 1947 1950; mul 28 1951; sub 1945 1952; mul 1323 1953; sub 1939 1954; mul 677
683; mul 642 1383; mul 644 683; add 1957 1958; mul 44 69; mul 75 75; sub 1960 1961; mul 88 1962; mul 549 1963; mul
541 1383; sub 1964 1965; mul 90 683; mul 367 1967; add 1966 1968; mul 582 1969; sub 1959 1970; mul 635 1971; mul 552
1972; mul 650 1969; sub 1973 1974; mul 581 1975; mul 650 1383; mul 521 1972; add 1977 1978; mul 16 1979; mul 581
1980; mul 638 1981; add 1976 1982; mul 648 1971; mul 634 1984; mul 630 1984; mul 633 1986; add 1985 1987; mul 621
1971; add 1988 1989; mul 625 1990; mul 627 1991; mul 589 1991; mul 510 1993; add 1992 1994; mul 566 1971; mul 601
1996; mul 605 1997; sub 1995 1998; mul 589 1997; mul 603 2000; sub 1999 2001; mul 588 1996; mul 595 2003; mul 591
2003; mul 593 2005; add 2004 2006; mul 735 2007; mul 730 2008; add 2002 2009; mul 629 1990; mul 566 2011; mul 746
2012; mul 579 2012; mul 624 2014; add 2013 2015; mul 579 2014; mul 623 2017; add 2016 2018; mul 565 1975; mul 650
683; mul 530 1972; sub 2021 2022; mul 572 2023; add 2020 2024; mul 640 1980; add 2025 2026; mul 566 2027; mul 597
1996; mul 583 2029; mul 585 2030; sub 2028 2031; mul 580 2030; neg 2033; mul 463 2034; add 2032 2035; mul 756 2036;
mul 580 2037; add 2019 2038; mul 745 2039; sub 2010 2040; mul 463 2030; add 2041 2042; mul 566 2043; mul 706 2044;
mul 704 2045; add 1983 2046; sub 1956 2047; mul 653 1963; mul 582 1972; mul 528 1383; mul 531 683; add 2051 2052;
mul 461 1969; sub 2053 2054; mul 520 2055; mul 461 2056; add 2050 2057; mul 550 2058; add 2049 2059; mul 547 2060;
add 2048 2061; mul 521 2058; sub 2063 1480; mul 539 2064; add 2062 2065; mul 96 1383; mul 99 1963; sub 2067 2068;
mul 93 1967; sub 2069 2070; mul 656 2071; mul 659 2072; mul 669 2072; mul 656 1967; mul 659 2075; sub 2074 2076; mul
93 2077; add 2073 2078; mul 657 2075; sub 2079 2080; mul 367 2058; add 2081 2082; mul 805 2083; sub 2066 2084; mul
653 1967; mul 534 2058; add 2086 2087; mul 365 2088; add 2085 2089; mul 66 2088; add 2090 2091; mul 552 2056; mul
556 1969; sub 2093 2094; mul 460 2095; mul 556 1383; mul 521 2056; add 2097 2098; mul 16 2099; mul 460 2100; mul 524
2101; sub 2096 2102; mul 554 2055; mul 519 2104; mul 515 2104; mul 518 2106; add 2105 2107; mul 503 2055; add 2108
2109; mul 508 2110; mul 512 2111; mul 471 2111; mul 510 2113; add 2112 2114; mul 445 2055; mul 483 2116; mul 487
2117; sub 2115 2118; mul 471 2117; mul 485 2120; sub 2119 2121; mul 468 2116; mul 477 2123; mul 473 2123; mul 475
2125; add 2124 2126; mul 874 2127; mul 869 2128; add 2122 2129; mul 514 2110; mul 445 2131; mul 885 2132; mul 458
2132; mul 507 2134; add 2133 2135; mul 458 2134; mul 506 2137; add 2136 2138; mul 444 2095; mul 556 683; mul 530
2056; sub 2141 2142; mul 451 2143; add 2140 2144; mul 526 2100; add 2145 2146; mul 445 2147; mul 479 2116; mul 462
2149; mul 465 2150; sub 2148 2151; mul 459 2150; neg 2153; mul 463 2154; add 2152 2155; mul 895 2156; mul 459 2157;
add 2139 2158; mul 884 2159; sub 2130 2160; mul 463 2150; add 2161 2162; mul 445 2163; mul 845 2164; mul 843 2165;
add 2103 2166; add 2047 2167; mul 435 2168; add 2092 2169; sub 2170 2167; mul 334 2168; mul 377 2172; mul 364 2173;
mul 538 1383; mul 91 2175; mul 942 2176; mul 546 1963; mul 91 2178; mul 948 2179; mul 946 2180; mul 953 2179; add
2181 2182; sub 2177 2183; mul 334 2060; mul 546 2185; mul 271 2173; add 2186 2187; mul 408 2188; add 2184 2189; mul
334 2064; mul 538 2191; mul 251 2173; add 2192 2193; mul 379 2194; add 2190 2195; mul 334 2088; mul 331 2197; mul
232 2173; add 2198 2199; mul 336 2200; add 2196 2201; mul 331 1967; mul 91 2203; mul 289 2204; sub 2202 2205; mul
233 2206; add 2174 2207; mul 287 2176; mul 279 2209; mul 287 2179; mul 983 2211; sub 2210 2212; mul 320 2176; mul
283 2180; mul 989 2179; add 2215 2216; sub 2214 2217; mul 419 2188; add 2218 2219; mul 359 2194; add 2220 2221; mul
350 2200; add 2222 2223; mul 308 2204; sub 2224 2225; mul 271 2226; add 2213 2227; mul 287 2204; mul 255 2229; sub
2228 2230; mul 271 2231; add 2208 2232; mul 1008 2209; mul 279 2211; sub 2234 2235; mul 1012 2176; mul 279 2180; mul
1015 2179; add 2238 2239; sub 2237 2240; mul 416 2188; add 2241 2242; mul 389 2194; add 2243 2244; mul 347 2200; add
2245 2246; mul 304 2204; sub 2247 2248; mul 271 2249; add 2236 2250; mul 1029 2176; mul 275 2180; mul 316 2179; add
2253 2254; sub 2252 2255; mul 356 2188; add 2256 2257; mul 386 2194; add 2258 2259; mul 344 2200; add 2260 2261; mul
300 2204; sub 2262 2263; mul 251 2264; add 2251 2265; mul 235 2229; sub 2266 2267; mul 251 2268; add 2233 2269; mul
1050 2209; mul 1052 2211; sub 2271 2272; mul 1055 2176; mul 1052 2180; mul 308 2179; add 2275 2276; sub 2274 2277;
mul 350 2188; add 2278 2279; mul 383 2194; add 2280 2281; mul 341 2200; add 2282 2283; mul 296 2204; sub 2284 2285;
mul 271 2286; add 2273 2287; mul 300 2176; mul 1050 2180; mul 1055 2179; add 2290 2291; sub 2289 2292; mul 383 2188;
add 2293 2294; mul 344 2194; add 2295 2296; mul 338 2200; add 2297 2298; mul 292 2204; sub 2299 2300; mul 251 2301;
add 2288 2302; mul 232 2206; add 2303 2304; mul 215 2229; sub 2305 2306; mul 1049 2307; add 2270 2308; mul 938 2309;
mul 933 2310; mul 91 1963; mul 203 2312; mul 101 2313; mul 1094 2314; mul 130 2312; mul 34 2316; mul 1094 2317; add
2315 2318; mul 1103 2312; mul 1094 2320; add 2319 2321; mul 115 2312; mul 101 2323; mul 101 2324; add 2322 2325; mul
1111 2312; mul 34 2327; mul 101 2328; add 2326 2329; mul 103 2312; mul 101 2331; add 2330 2332; mul 364 2197; mul
328 1967; sub 2334 2335; mul 329 2336; mul 1133 2309; mul 228 2338; add 2337 2339; mul 226 2338; mul 227 2341; add
2340 2342; mul 1128 2343; mul 1123 2344; mul 227 2345; add 2333 2346; sub 2311 2347; mul 96 1590; mul 99 2312; sub
2349 2350; mul 91 1967; mul 93 2352; sub 2351 2353; mul 209 2354; mul 147 2355; add 2348 2356; mul 94 2355; mul 1094
2358; add 2357 2359; mul 142 2354; mul 101 2361; mul 1094 2362; add 2360 2363; mul 203 2354; mul 34 2365; mul 1094
2366; add 2364 2367; mul 200 2354; mul 1094 2369; add 2368 2370; mul 197 2354; mul 101 2372; mul 101 2373; add 2371
2374; mul 194 2354; mul 34 2376; mul 101 2377; add 2375 2378; mul 191 2354; mul 101 2380; add 2379 2381; mul 107
2354; mul 34 2383; mul 34 2384; add 2382 2385; mul 103 2354; mul 34 2387; add 2386 2388; mul 92 2354; add 2389 2390;
mul 151 2352; mul 147 2392; sub 2391 2393; mul 94 2392; mul 1094 2395; sub 2394 2396; mul 146 2352; mul 101 2398;
mul 1094 2399; sub 2397 2400; mul 142 2352; mul 101 2402; mul 101 2403; sub 2401 2404; mul 138 2352; mul 34 2406;
mul 101 2407; sub 2405 2408; mul 134 2352; mul 101 2410; sub 2409 2411; mul 130 2352; mul 34 2413; mul 34 2414; sub
2412 2415; mul 126 2352; mul 34 2417; sub 2416 2418; mul 123 2352; sub 2419 2420; mul 147 2361; mul 147 2313; mul
135 2323; add 2423 2424; mul 94 2324; add 2425 2426; mul 94 2328; add 2427 2428; mul 94 2331; add 2429 2430; mul
1229 2312; mul 112 2432; add 2431 2433; mul 101 2432; mul 1233 2435; add 2434 2436; mul 173 2312; mul 34 2438; mul
1233 2439; add 2437 2440; mul 1241 2312; mul 1233 2442; add 2441 2443; mul 1245 2312; mul 34 2445; mul 34 2446; add
2444 2447; mul 1250 2312; mul 34 2449; add 2448 2450; mul 156 2312; add 2451 2452; sub 2422 2453; mul 135 2372; add
2454 2455; mul 94 2373; add 2456 2457; mul 94 2377; add 2458 2459; mul 94 2380; add 2460 2461; mul 182 2354; mul 112
2463; add 2462 2464; mul 101 2463; mul 1233 2466; add 2465 2467; mul 179 2354; mul 34 2469; mul 1233 2470; add 2468
2471; mul 176 2354; mul 1233 2473; add 2472 2474; mul 173 2354; mul 34 2476; mul 34 2477; add 2475 2478; mul 170
2354; mul 34 2480; add 2479 2481; mul 167 2354; add 2482 2483; mul 147 2398; sub 2484 2485; mul 135 2402; sub 2486
2487; mul 94 2403; sub 2488 2489; mul 94 2407; sub 2490 2491; mul 94 2410; sub 2492 2493; mul 119 2352; mul 112
2495; sub 2494 2496; mul 101 2495; mul 1233 2498; sub 2497 2499; mul 115 2352; mul 34 2501; mul 1233 2502; sub 2500
2503; mul 111 2352; mul 1233 2505; sub 2504 2506; mul 107 2352; mul 34 2508; mul 34 2509; sub 2507 2510; mul 103
2352; mul 34 2512; sub 2511 2513; mul 92 2352; sub 2514 2515; mul 93 2516; add 2421 2517; mul 928 2518; sub 2171
2519; mul 683 1343; mul 683 1325; add 1383 2522; mul 1339 2523; mul 530 2524; add 2521 2525; mul 1328 2523; mul 683
1361; add 2527 2528; mul 683 1327; mul 1353 2530; sub 2529 2531; mul 28 2532; add 2526 2533; mul 1323 2534; add 2520
2535; mul 461 515; mul 550 2537; mul 547 2538; mul 521 2537; mul 539 2540; add 2539 2541; mul 367 2537; mul 805
2543; sub 2542 2544; mul 534 2537; mul 365 2546; add 2545 2547; mul 66 2546; add 2548 2549; mul 515 552; mul 460
2551; mul 515 521; mul 16 2553; mul 460 2554; mul 524 2555; sub 2552 2556; mul 508 554; mul 512 2558; mul 471 2558;
mul 510 2560; add 2559 2561; mul 514 554; mul 445 2563; mul 885 2564; mul 458 2564; mul 507 2566; add 2565 2567; mul
458 2566; mul 506 2569; add 2568 2570; mul 444 2551; mul 515 530; mul 451 2573; sub 2572 2574; mul 526 2554; add
2575 2576; mul 445 2577; mul 895 2578; mul 459 2579; add 2571 2580; mul 884 2581; sub 2562 2582; mul 445 2583; mul
845 2584; mul 843 2585; add 2557 2586; mul 435 2587; add 2550 2588; sub 2589 2587; mul 334 2587; mul 377 2591; mul
364 2592; mul 334 2538; mul 546 2594; mul 271 2592; add 2595 2596; mul 408 2597; mul 334 2540; mul 538 2599; mul 251
2592; add 2600 2601; mul 379 2602; add 2598 2603; mul 334 2546; mul 331 2605; mul 232 2592; add 2606 2607; mul 336
2608; add 2604 2609; mul 233 2610; add 2593 2611; mul 419 2597; mul 359 2602; add 2613 2614; mul 350 2608; add 2615
2616; mul 271 2617; mul 271 2618; add 2612 2619; mul 416 2597; mul 389 2602; add 2621 2622; mul 347 2608; add 2623
2624; mul 271 2625; mul 356 2597; mul 386 2602; add 2627 2628; mul 344 2608; add 2629 2630; mul 251 2631; add 2626
2632; mul 251 2633; add 2620 2634; mul 350 2597; mul 383 2602; add 2636 2637; mul 341 2608; add 2638 2639; mul 271
2640; mul 383 2597; mul 344 2602; add 2642 2643; mul 338 2608; add 2644 2645; mul 251 2646; add 2641 2647; mul 232
2610; add 2648 2649; mul 1049 2650; add 2635 2651; mul 938 2652; mul 933 2653; mul 364 2605; mul 329 2655; mul 1133
2652; mul 228 2657; add 2656 2658; mul 226 2657; mul 227 2660; add 2659 2661; mul 1128 2662; mul 1123 2663; mul 227
2664; sub 2654 2665; mul 928 2666; sub 2590 2667; mul 582 630; mul 550 2669; mul 547 2670; mul 552 630; mul 581
2672; mul 521 630; mul 16 2674; mul 581 2675; mul 638 2676; add 2673 2677; mul 625 648; mul 627 2679; mul 589 2679;
mul 510 2681; add 2680 2682; mul 629 648; mul 566 2684; mul 746 2685; mul 579 2685; mul 624 2687; add 2686 2688; mul
579 2687; mul 623 2690; add 2689 2691; mul 565 2672; mul 530 630; mul 572 2694; sub 2693 2695; mul 640 2675; add
2696 2697; mul 566 2698; mul 756 2699; mul 580 2700; add 2692 2701; mul 745 2702; sub 2683 2703; mul 566 2704; mul
706 2705; mul 704 2706; add 2678 2707; sub 2671 2708; mul 521 2669; mul 539 2710; add 2709 2711; mul 367 2669; mul
805 2713; sub 2712 2714; mul 534 2669; mul 365 2716; add 2715 2717; mul 66 2716; add 2718 2719; mul 435 2708; add
2720 2721; mul 334 2708; mul 377 2723; mul 364 2724; mul 334 2670; mul 546 2726; mul 271 2724; add 2727 2728; mul
408 2729; mul 334 2710; mul 538 2731; mul 251 2724; add 2732 2733; mul 379 2734; add 2730 2735; mul 334 2716; mul
331 2737; mul 232 2724; add 2738 2739; mul 336 2740; add 2736 2741; mul 233 2742; add 2725 2743; mul 419 2729; mul
359 2734; add 2745 2746; mul 350 2740; add 2747 2748; mul 271 2749; mul 271 2750; add 2744 2751; mul 416 2729; mul
389 2734; add 2753 2754; mul 347 2740; add 2755 2756; mul 271 2757; mul 356 2729; mul 386 2734; add 2759 2760; mul
344 2740; add 2761 2762; mul 251 2763; add 2758 2764; mul 251 2765; add 2752 2766; mul 350 2729; mul 383 2734; add
2768 2769; mul 341 2740; add 2770 2771; mul 271 2772; mul 383 2729; mul 344 2734; add 2774 2775; mul 338 2740; add
2776 2777; mul 251 2778; add 2773 2779; mul 232 2742; add 2780 2781; mul 1049 2782; add 2767 2783; mul 938 2784; mul
933 2785; mul 364 2737; mul 329 2787; mul 1133 2784; mul 228 2789; add 2788 2790; mul 226 2789; mul 227 2792; add
2791 2793; mul 1128 2794; mul 1123 2795; mul 227 2796; sub 2786 2797; mul 928 2798; sub 2722 2799; mul 233 1050; mul
252 1008; add 2801 2802; mul 272 279; add 2803 2804; input p 140; mul 276 2806; add 2805 2807; input p 141; mul 280
2809; add 2808 2810; input p 142; mul 284 2812; add 2811 2813; mul 287 2814; mul 290 942; mul 293 300; add 2816
2817; mul 297 1055; add 2818 2819; mul 301 1029; add 2820 2821; mul 305 1012; add 2822 2823; mul 309 320; add 2824
2825; input p 147; mul 313 2827; add 2826 2828; input p 148; mul 317 2830; add 2829 2831; input p 149; mul 321 2833;
add 2832 2834; input p 150; mul 287 2836; add 2835 2837; add 2815 2838; mul 943 2839; mul 233 1052; mul 252 279; add
2841 2842; mul 272 983; add 2843 2844; input p 164; mul 276 2846; add 2845 2847; input p 165; mul 280 2849; add 2848
2850; input p 166; mul 284 2852; add 2851 2853; mul 287 2854; mul 290 953; mul 293 1055; add 2856 2857; mul 297 308;
add 2858 2859; mul 301 316; add 2860 2861; mul 305 1015; add 2862 2863; mul 309 989; add 2864 2865; input p 170; mul
313 2867; add 2866 2868; mul 317 2833; add 2869 2870; input p 171; mul 321 2872; add 2871 2873; input p 172; mul 287
2875; add 2874 2876; add 2855 2877; mul 290 946; mul 293 1050; add 2879 2880; mul 297 1052; add 2881 2882; mul 275
301; add 2883 2884; mul 279 305; add 2885 2886; mul 283 309; add 2887 2888; input p 174; mul 313 2890; add 2889
2891; mul 317 2846; add 2892 2893; mul 321 2812; add 2894 2895; input p 175; mul 287 2897; add 2896 2898; mul 948
2899; add 2878 2900; mul 949 2901; input p 153; mul 34 2903; input p 154; mul 160 2905; add 2904 2906; input p 155;
mul 164 2908; add 2907 2909; mul 101 156; add 2910 2911; mul 104 1250; add 2912 2913; mul 108 1245; add 2914 2915;
mul 112 1241; add 2916 2917; mul 116 173; add 2918 2919; mul 120 1229; add 2920 2921; mul 103 135; add 2922 2923;
mul 139 1111; add 2924 2925; mul 115 143; add 2926 2927; mul 147 1103; add 2928 2929; mul 130 204; add 2930 2931;
mul 148 203; add 2932 2933; mul 99 211; add 2934 2935; mul 683 2936; add 2902 2937; sub 2840 2938; mul 96 211; mul
679 2940; add 2939 2941; mul 327 975; sub 2942 2943; mul 213 687; sub 2944 2945; mul 1620 2901; mul 1383 2936; add
2947 2948; mul 1626 2839; sub 2949 2950; mul 1374 2940; sub 2951 2952; mul 327 1647; add 2953 2954; mul 213 1386;
add 2955 2956; mul 2175 2839; mul 2178 2901; mul 1963 2936; add 2959 2960; sub 2958 2961; mul 1383 2940; add 2962
2963; mul 327 2203; sub 2964 2965; mul 213 1967; sub 2966 2967; mul 671 810; mul 550 683; mul 260 2970; sub 2969
2971; mul 666 687; sub 2972 2973; constant -2.0; mul 1341 1346; le 1337 1338; le 1338 1337; add 2977 2978; div 1
2979; mul 2977 2980; mul 2976 2981; mul 2975 2982; add 2974 2983; mul 550 1383; mul 260 2985; mul 671 1490; add 2986
2987; mul 666 1386; add 2988 2989; mul 1341 1942; mul 2981 2991; mul 2975 2992; sub 2990 2993; mul 671 2071; mul 550
1963; mul 260 2996; sub 2995 2997; mul 666 1967; sub 2998 2999; mul 1341 2523; mul 2981 3001; mul 2975 3002; add
3000 3003; constant -2.5714285714285743; mul 152 1151; mul 3005 3006; constant -0.8571428571428583; mul 148 1095;
mul 3008 3009; constant 0.9142857142857138; mul 204 1095; mul 3011 3012; add 3010 3013; constant
0.05714285714285722; mul 143 1095; mul 3015 3016; add 3014 3017; constant -0.11428571428571327; mul 139 1095; mul
3019 3020; add 3018 3021; constant 0.2190476190476189; mul 120 1095; mul 3023 3024; add 3022 3025; constant
0.11428571428571413; mul 116 1095; mul 3027 3028; add 3026 3029; constant -0.05714285714285729; mul 108 1095; mul
3031 3032; add 3030 3033; input p 225; constant -0.033333333333333326; mul 101 1095; mul 3036 3037; mul 3035 3038;
add 3034 3039; constant 0.007256235827664418; mul 164 1095; mul 3041 3042; add 3040 3043; constant
0.01904761904761903; mul 34 1095; mul 3045 3046; mul 3035 3047; add 3044 3048; sub 3007 3049; constant
2.057142857142858; mul 148 1151; mul 3051 3052; add 3050 3053; mul 204 1151; mul 3008 3055; add 3054 3056; constant
-3.428571428571427; mul 143 1151; mul 3058 3059; add 3057 3060; constant 0.11428571428571443; mul 139 1151; mul 3062
3063; add 3061 3064; constant -0.057142857142856635; mul 131 1151; mul 3066 3067; add 3065 3068; constant
-0.09999999999999995; mul 94 1151; mul 3070 3071; mul 3035 3072; add 3069 3073; constant 2.438095238095238; mul 120
1151; mul 3075 3076; add 3074 3077; constant 0.6571428571428567; mul 116 1151; mul 3079 3080; add 3078 3081; input p
226; mul 112 1151; mul 3083 3084; sub 3082 3085; mul 108 1151; mul 3027 3087; add 3086 3088; constant
0.13333333333333333; mul 101 1151; mul 3090 3091; mul 3035 3092; add 3089 3093; constant -0.019047619047619094; mul
164 1151; mul 3095 3096; add 3094 3097; mul 34 1151; mul 3036 3099; mul 3035 3100; add 3098 3101; constant
12.34285714285715; mul 152 1149; mul 3103 3104; sub 3102 3105; constant -7.714285714285722; mul 148 1149; mul 3107
3108; sub 3106 3109; mul 143 1149; mul 3051 3111; sub 3110 3112; constant -1.7142857142857166; mul 139 1149; mul
3114 3115; sub 3113 3116; mul 131 1149; mul 3011 3118; sub 3117 3119; constant 1.2; mul 94 1149; mul 3121 3122; mul
3035 3123; sub 3120 3124; constant -1.1428571428571423; mul 120 1149; mul 3126 3127; sub 3125 3128; mul 116 1149;
mul 3015 3130; sub 3129 3131; mul 108 1149; mul 3066 3133; sub 3132 3134; mul 101 1149; mul 3070 3136; mul 3035
3137; sub 3135 3138; mul 148 1590; mul 3008 3140; mul 204 1590; mul 3011 3142; add 3141 3143; mul 143 1590; mul 3015
3145; add 3144 3146; mul 139 1590; mul 3019 3148; add 3147 3149; mul 120 1590; mul 3023 3151; add 3150 3152; mul 116
1590; mul 3027 3154; add 3153 3155; mul 108 1590; mul 3031 3157; add 3156 3158; mul 101 1590; mul 3036 3160; mul
3035 3161; add 3159 3162; mul 164 1590; mul 3041 3164; add 3163 3165; mul 34 1590; mul 3045 3167; mul 3035 3168; add
3166 3169; mul 152 1773; mul 3005 3171; add 3170 3172; mul 148 1773; mul 3051 3174; add 3173 3175; mul 204 1773; mul
3008 3177; add 3176 3178; mul 143 1773; mul 3058 3180; add 3179 3181; mul 139 1773; mul 3062 3183; add 3182 3184;
mul 131 1773; mul 3066 3186; add 3185 3187; mul 94 1773; mul 3070 3189; mul 3035 3190; add 3188 3191; mul 120 1773;
mul 3075 3193; add 3192 3194; mul 116 1773; mul 3079 3196; add 3195 3197; mul 112 1773; mul 3083 3199; sub 3198
3200; mul 108 1773; mul 3027 3202; add 3201 3203; mul 101 1773; mul 3090 3205; mul 3035 3206; add 3204 3207; mul 164
1773; mul 3095 3209; add 3208 3210; mul 34 1773; mul 3036 3212; mul 3035 3213; add 3211 3214; mul 152 1771; mul 3103
3216; add 3215 3217; mul 148 1771; mul 3107 3219; add 3218 3220; mul 143 1771; mul 3051 3222; add 3221 3223; mul 139
1771; mul 3114 3225; add 3224 3226; mul 131 1771; mul 3011 3228; add 3227 3229; mul 94 1771; mul 3121 3231; mul 3035
3232; add 3230 3233; mul 120 1771; mul 3126 3235; add 3234 3236; mul 116 1771; mul 3015 3238; add 3237 3239; mul 108
1771; mul 3066 3241; add 3240 3242; mul 101 1771; mul 3070 3244; mul 3035 3245; add 3243 3246; mul 152 2354; mul
3005 3248; mul 148 2312; mul 3008 3250; mul 204 2312; mul 3011 3252; add 3251 3253; mul 143 2312; mul 3015 3255; add
3254 3256; mul 139 2312; mul 3019 3258; add 3257 3259; mul 120 2312; mul 3023 3261; add 3260 3262; mul 116 2312; mul
3027 3264; add 3263 3265; mul 108 2312; mul 3031 3267; add 3266 3268; mul 101 2312; mul 3036 3270; mul 3035 3271;
add 3269 3272; mul 164 2312; mul 3041 3274; add 3273 3275; mul 34 2312; mul 3045 3277; mul 3035 3278; add 3276 3279;
sub 3249 3280; mul 148 2354; mul 3051 3282; add 3281 3283; mul 204 2354; mul 3008 3285; add 3284 3286; mul 143 2354;
mul 3058 3288; add 3287 3289; mul 139 2354; mul 3062 3291; add 3290 3292; mul 131 2354; mul 3066 3294; add 3293
3295; mul 94 2354; mul 3070 3297; mul 3035 3298; add 3296 3299; mul 120 2354; mul 3075 3301; add 3300 3302; mul 116
2354; mul 3079 3304; add 3303 3305; mul 112 2354; mul 3083 3307; sub 3306 3308; mul 108 2354; mul 3027 3310; add
3309 3311; mul 101 2354; mul 3090 3313; mul 3035 3314; add 3312 3315; mul 164 2354; mul 3095 3317; add 3316 3318;
mul 34 2354; mul 3036 3320; mul 3035 3321; add 3319 3322; mul 152 2352; mul 3103 3324; sub 3323 3325; mul 148 2352;
mul 3107 3327; sub 3326 3328; mul 143 2352; mul 3051 3330; sub 3329 3331; mul 139 2352; mul 3114 3333; sub 3332
3334; mul 131 2352; mul 3011 3336; sub 3335 3337; mul 94 2352; mul 3121 3339; mul 3035 3340; sub 3338 3341; mul 120
2352; mul 3126 3343; sub 3342 3344; mul 116 2352; mul 3015 3346; sub 3345 3347; mul 108 2352; mul 3066 3349; sub
3348 3350; mul 101 2352; mul 3070 3352; mul 3035 3353; sub 3351 3354; constant -129.60000000000008; mul 3006 3356;
constant 28.799999999999958; mul 3009 3358; constant 45.25714285714287; mul 3012 3360; add 3359 3361; constant
-28.800000000000004; mul 147 1095; mul 3363 3364; mul 3083 3365; add 3362 3366; constant -28.799999999999976; mul
3016 3368; add 3367 3369; constant -45.25714285714286; mul 3020 3371; add 3370 3372; constant 28.79999999999999; mul
135 1095; mul 3374 3375; mul 3083 3376; add 3373 3377; constant 7.199999999999994; mul 3024 3379; add 3378 3380;
constant 13.714285714285717; mul 3028 3382; add 3381 3383; constant -7.199999999999996; mul 112 1095; mul 3385 3386;
mul 3083 3387; add 3384 3388; constant 1.3714285714285692; mul 3032 3390; add 3389 3391; constant
-4.799999999999999; mul 104 1095; mul 3393 3394; mul 3083 3395; add 3392 3396; constant 1.3714285714285714; mul 3042
3398; add 3397 3399; constant -1.3714285714285723; mul 160 1095; mul 3401 3402; mul 3083 3403; add 3400 3404;
constant 2.400000000000001; mul 3046 3406; mul 3035 3407; add 3405 3408; sub 3357 3409; constant 230.40000000000006;
mul 3052 3411; add 3410 3412; mul 3055 3358; add 3413 3414; constant -36.00000000000001; mul 147 1151; mul 3416
3417; mul 3083 3418; add 3415 3419; constant -151.20000000000002; mul 3059 3421; add 3420 3422; constant
-57.59999999999995; mul 3063 3424; add 3423 3425; constant 72.0; mul 135 1151; mul 3427 3428; mul 3083 3429; add
3426 3430; constant -22.62857142857143; mul 3067 3432; add 3431 3433; mul 127 1151; mul 3374 3435; mul 3083 3436;
add 3434 3437; constant -18.000000000000004; mul 3071 3439; mul 3035 3440; add 3438 3441; constant
35.20000000000001; mul 3076 3443; add 3442 3444; constant 21.59999999999998; mul 3080 3446; add 3445 3447; constant
-30.000000000000007; mul 3084 3449; mul 3083 3450; add 3448 3451; mul 3087 3382; add 3452 3453; constant
-14.399999999999991; mul 104 1151; mul 3455 3456; mul 3083 3457; add 3454 3458; mul 657 3091; mul 3035 3460; add
3459 3461; constant 0.4571428571428564; mul 3096 3463; add 3462 3464; constant -2.3999999999999995; mul 160 1151;
mul 3466 3467; mul 3083 3468; add 3465 3469; input p 227; constant -0.9999999999999998; mul 1151 3472; mul 3471
3473; add 3470 3474; constant 259.2000000000001; mul 3104 3476; sub 3475 3477; constant -388.80000000000024; mul
3108 3479; sub 3478 3480; mul 3111 3411; sub 3481 3482; constant 57.599999999999916; mul 3115 3484; sub 3483 3485;
constant -72.00000000000001; mul 135 1149; mul 3487 3488; mul 3083 3489; sub 3486 3490; mul 3118 3360; sub 3491
3492; constant -57.60000000000001; mul 127 1149; mul 3494 3495; mul 3083 3496; sub 3493 3497; constant
36.000000000000014; mul 3122 3499; mul 3035 3500; sub 3498 3501; constant -50.400000000000006; mul 3127 3503; sub
3502 3504; mul 3130 3368; sub 3505 3506; constant 36.0; mul 112 1149; mul 3508 3509; mul 3083 3510; sub 3507 3511;
mul 3133 3432; sub 3512 3513; mul 104 1149; mul 3374 3515; mul 3083 3516; sub 3514 3517; mul 3136 3439; mul 3035
3519; sub 3518 3520; mul 3140 3358; mul 3142 3360; add 3522 3523; mul 147 1590; mul 3363 3525; mul 3083 3526; add
3524 3527; mul 3145 3368; add 3528 3529; mul 3148 3371; add 3530 3531; mul 135 1590; mul 3374 3533; mul 3083 3534;
add 3532 3535; mul 3151 3379; add 3536 3537; mul 3154 3382; add 3538 3539; mul 112 1590; mul 3385 3541; mul 3083
3542; add 3540 3543; mul 3157 3390; add 3544 3545; mul 104 1590; mul 3393 3547; mul 3083 3548; add 3546 3549; mul
3164 3398; add 3550 3551; mul 160 1590; mul 3401 3553; mul 3083 3554; add 3552 3555; mul 3167 3406; mul 3035 3557;
add 3556 3558; mul 3171 3356; add 3559 3560; mul 3174 3411; add 3561 3562; mul 3177 3358; add 3563 3564; mul 147
1773; mul 3416 3566; mul 3083 3567; add 3565 3568; mul 3180 3421; add 3569 3570; mul 3183 3424; add 3571 3572; mul
135 1773; mul 3427 3574; mul 3083 3575; add 3573 3576; mul 3186 3432; add 3577 3578; mul 127 1773; mul 3374 3580;
mul 3083 3581; add 3579 3582; mul 3189 3439; mul 3035 3584; add 3583 3585; mul 3193 3443; add 3586 3587; mul 3196
3446; add 3588 3589; mul 3199 3449; mul 3083 3591; add 3590 3592; mul 3202 3382; add 3593 3594; mul 104 1773; mul
3455 3596; mul 3083 3597; add 3595 3598; mul 657 3205; mul 3035 3600; add 3599 3601; mul 3209 3463; add 3602 3603;
mul 160 1773; mul 3466 3605; mul 3083 3606; add 3604 3607; mul 1773 3472; mul 3471 3609; add 3608 3610; mul 3216
3476; add 3611 3612; mul 3219 3479; add 3613 3614; mul 3222 3411; add 3615 3616; mul 3225 3484; add 3617 3618; mul
135 1771; mul 3487 3620; mul 3083 3621; add 3619 3622; mul 3228 3360; add 3623 3624; mul 127 1771; mul 3494 3626;
mul 3083 3627; add 3625 3628; mul 3231 3499; mul 3035 3630; add 3629 3631; mul 3235 3503; add 3632 3633; mul 3238
3368; add 3634 3635; mul 112 1771; mul 3508 3637; mul 3083 3638; add 3636 3639; mul 3241 3432; add 3640 3641; mul
104 1771; mul 3374 3643; mul 3083 3644; add 3642 3645; mul 3244 3439; mul 3035 3647; add 3646 3648; mul 3248 3356;
mul 3250 3358; mul 3252 3360; add 3651 3652; mul 147 2312; mul 3363 3654; mul 3083 3655; add 3653 3656; mul 3255
3368; add 3657 3658; mul 3258 3371; add 3659 3660; mul 135 2312; mul 3374 3662; mul 3083 3663; add 3661 3664; mul
3261 3379; add 3665 3666; mul 3264 3382; add 3667 3668; mul 112 2312; mul 3385 3670; mul 3083 3671; add 3669 3672;
mul 3267 3390; add 3673 3674; mul 104 2312; mul 3393 3676; mul 3083 3677; add 3675 3678; mul 3274 3398; add 3679
3680; mul 160 2312; mul 3401 3682; mul 3083 3683; add 3681 3684; mul 3277 3406; mul 3035 3686; add 3685 3687; sub
3650 3688; mul 3282 3411; add 3689 3690; mul 3285 3358; add 3691 3692; mul 147 2354; mul 3416 3694; mul 3083 3695;
add 3693 3696; mul 3288 3421; add 3697 3698; mul 3291 3424; add 3699 3700; mul 135 2354; mul 3427 3702; mul 3083
3703; add 3701 3704; mul 3294 3432; add 3705 3706; mul 127 2354; mul 3374 3708; mul 3083 3709; add 3707 3710; mul
3297 3439; mul 3035 3712; add 3711 3713; mul 3301 3443; add 3714 3715; mul 3304 3446; add 3716 3717; mul 3307 3449;
mul 3083 3719; add 3718 3720; mul 3310 3382; add 3721 3722; mul 104 2354; mul 3455 3724; mul 3083 3725; add 3723
3726; mul 657 3313; mul 3035 3728; add 3727 3729; mul 3317 3463; add 3730 3731; mul 160 2354; mul 3466 3733; mul
3083 3734; add 3732 3735; mul 2354 3472; mul 3471 3737; add 3736 3738; mul 3324 3476; sub 3739 3740; mul 3327 3479;
sub 3741 3742; mul 3330 3411; sub 3743 3744; mul 3333 3484; sub 3745 3746; mul 135 2352; mul 3487 3748; mul 3083
3749; sub 3747 3750; mul 3336 3360; sub 3751 3752; mul 127 2352; mul 3494 3754; mul 3083 3755; sub 3753 3756; mul
3339 3499; mul 3035 3758; sub 3757 3759; mul 3343 3503; sub 3760 3761; mul 3346 3368; sub 3762 3763; mul 112 2352;
mul 3508 3765; mul 3083 3766; sub 3764 3767; mul 3349 3432; sub 3768 3769; mul 104 2352; mul 3374 3771; mul 3083
3772; sub 3770 3773; mul 3352 3439; mul 3035 3775; sub 3774 3776; input p 228; mul 3418 3778; mul 3365 3778; mul
3376 3778; add 3780 3781; mul 3387 3778; add 3782 3783; mul 3395 3778; add 3784 3785; input p 229; input p 230; mul
3038 3788; mul 3787 3789; add 3786 3790; mul 3403 3778; add 3791 3792; mul 3047 3788; mul 3787 3794; add 3793 3795;
mul 3407 3778; mul 3787 3797; add 3796 3798; sub 3779 3799; mul 3429 3778; add 3800 3801; mul 3436 3778; add 3802
3803; mul 3072 3788; mul 3787 3805; add 3804 3806; mul 3440 3778; mul 3787 3808; add 3807 3809; mul 3084 3788; sub
3810 3811; mul 3450 3778; add 3812 3813; mul 3457 3778; add 3814 3815; mul 3092 3788; mul 3787 3817; add 3816 3818;
mul 3460 3778; mul 3787 3820; add 3819 3821; mul 3468 3778; add 3822 3823; mul 3100 3788; mul 3787 3825; add 3824
3826; mul 3473 3778; mul 3035 3828; add 3827 3829; mul 3083 3828; mul 3787 3831; add 3830 3832; add 3473 3833; mul
3489 3778; sub 3834 3835; mul 3496 3778; sub 3836 3837; mul 3123 3788; mul 3787 3839; sub 3838 3840; mul 3500 3778;
mul 3787 3842; sub 3841 3843; mul 3510 3778; sub 3844 3845; mul 3516 3778; sub 3846 3847; mul 3137 3788; mul 3787
3849; sub 3848 3850; mul 3519 3778; mul 3787 3852; sub 3851 3853; mul 3526 3778; mul 3534 3778; add 3855 3856; mul
3542 3778; add 3857 3858; mul 3548 3778; add 3859 3860; mul 3161 3788; mul 3787 3862; add 3861 3863; mul 3554 3778;
add 3864 3865; mul 3168 3788; mul 3787 3867; add 3866 3868; mul 3557 3778; mul 3787 3870; add 3869 3871; mul 3567
3778; add 3872 3873; mul 3575 3778; add 3874 3875; mul 3581 3778; add 3876 3877; mul 3190 3788; mul 3787 3879; add
3878 3880; mul 3584 3778; mul 3787 3882; add 3881 3883; mul 3199 3788; sub 3884 3885; mul 3591 3778; add 3886 3887;
mul 3597 3778; add 3888 3889; mul 3206 3788; mul 3787 3891; add 3890 3892; mul 3600 3778; mul 3787 3894; add 3893
3895; mul 3606 3778; add 3896 3897; mul 3213 3788; mul 3787 3899; add 3898 3900; mul 3609 3778; mul 3035 3902; add
3901 3903; mul 3083 3902; mul 3787 3905; add 3904 3906; add 3609 3907; mul 3621 3778; add 3908 3909; mul 3627 3778;
add 3910 3911; mul 3232 3788; mul 3787 3913; add 3912 3914; mul 3630 3778; mul 3787 3916; add 3915 3917; mul 3638
3778; add 3918 3919; mul 3644 3778; add 3920 3921; mul 3245 3788; mul 3787 3923; add 3922 3924; mul 3647 3778; mul
3787 3926; add 3925 3927; mul 3695 3778; mul 3655 3778; mul 3663 3778; add 3930 3931; mul 3671 3778; add 3932 3933;
mul 3677 3778; add 3934 3935; mul 3271 3788; mul 3787 3937; add 3936 3938; mul 3683 3778; add 3939 3940; mul 3278
3788; mul 3787 3942; add 3941 3943; mul 3686 3778; mul 3787 3945; add 3944 3946; sub 3929 3947; mul 3703 3778; add
3948 3949; mul 3709 3778; add 3950 3951; mul 3298 3788; mul 3787 3953; add 3952 3954; mul 3712 3778; mul 3787 3956;
add 3955 3957; mul 3307 3788; sub 3958 3959; mul 3719 3778; add 3960 3961; mul 3725 3778; add 3962 3963; mul 3314
3788; mul 3787 3965; add 3964 3966; mul 3728 3778; mul 3787 3968; add 3967 3969; mul 3734 3778; add 3970 3971; mul
3321 3788; mul 3787 3973; add 3972 3974; mul 3737 3778; mul 3035 3976; add 3975 3977; mul 3083 3976; mul 3787 3979;
add 3978 3980; add 3737 3981; mul 3749 3778; sub 3982 3983; mul 3755 3778; sub 3984 3985; mul 3340 3788; mul 3787
3987; sub 3986 3988; mul 3758 3778; mul 3787 3990; sub 3989 3991; mul 3766 3778; sub 3992 3993; mul 3772 3778; sub
3994 3995; mul 3353 3788; mul 3787 3997; sub 3996 3998; mul 3775 3778; mul 3787 4000; sub 3999 4001; mul 534 816;
mul 672 687; sub 4003 4004; mul 211 1149; sub 4005 4006; mul 94 1318; add 4007 4008; mul 672 1386; mul 534 1496; add
4010 4011; mul 211 1771; add 4012 4013; mul 94 1935; add 4014 4015; mul 534 2077; mul 672 1967; sub 4017 4018; mul
211 2352; sub 4019 4020; mul 94 2516; add 4021 4022; mul 672 679; mul 211 1145; add 4024 4025; mul 521 816; add 4026
4027; mul 2 1318; add 4028 4029; mul 521 1496; mul 672 1374; mul 211 1768; add 4032 4033; sub 4031 4034; mul 2 1935;
add 4035 4036; mul 672 1383; mul 211 1590; add 4038 4039; mul 521 2077; add 4040 4041; mul 2 2516; add 4042 4043;
mul 550 816; mul 672 683; mul 211 1095; add 4046 4047; sub 4045 4048; mul 34 1318; add 4049 4050; mul 550 1496; add
4040 4052; mul 34 1935; add 4053 4054; mul 550 2077; mul 672 1963; mul 211 2312; add 4057 4058; sub 4056 4059; mul
34 2516; add 4060 4061; mul 7 15; mul 16 521; mul 521 4064; mul 22 4065; mul 21 89; mul 21 679; mul 25 4068; sub
4067 4069; mul 4066 4070; mul 23 4071; mul 679 4065; mul 18 4073; sub 4072 4074; mul 40 4068; mul 21 683; mul 52
4077; sub 4076 4078; mul 66 4067; sub 4079 4080; mul 4066 4081; mul 37 4082; sub 4075 4083; mul 2 4084; mul 4063
4085; mul 4063 4086; mul 8 4085; mul 8 4088; mul 463 4089; add 4087 4090; mul 15 16; mul 641 699; input p 151; mul
37 4094; mul 679 4095; sub 4093 4096; mul 527 838; add 4097 4098; mul 4092 4099; mul 13 4100; mul 8 8; mul 15 4099;
mul 4102 4103; add 4101 4104; mul 8 37; mul 572 701; mul 563 4107; mul 16 679; mul 4094 4109; mul 565 701; mul 560
4111; add 4110 4112; sub 4108 4113; mul 563 784; add 4114 4115; mul 581 760; mul 636 701; add 4117 4118; mul 463
572; mul 782 4120; add 4119 4121; mul 560 4122; add 4116 4123; mul 444 840; mul 439 4125; sub 4124 4126; mul 451
840; mul 442 4128; sub 4127 4129; mul 442 923; sub 4130 4131; mul 460 899; mul 522 840; add 4133 4134; mul 451 463;
mul 921 4136; add 4135 4137; mul 439 4138; add 4132 4139; mul 4106 4140; add 4105 4141; mul 8 23; mul 563 4111; mul
560 4107; add 4144 4145; mul 560 784; add 4146 4147; mul 563 4122; sub 4148 4149; mul 442 4125; sub 4150 4151; mul
439 4128; add 4152 4153; mul 439 923; add 4154 4155; mul 442 4138; add 4156 4157; mul 4143 4158; add 4142 4159; mul
7 463; div 1 4161; mul 4160 4162; mul 2 4163; mul 2 4164; sub 4091 4165; mul 8 4158; mul 7 4100; sub 4167 4168; mul
13 463; div 1 4170; mul 4169 4171; mul 2 4172; mul 2 4173; add 4166 4174; input p 137; mul 8 4176; mul 8 4177; mul 9
4063; mul 4063 4179; add 4178 4180; mul 2 4181; mul 4071 4182; mul 91 2936; mul 91 2901; mul 546 4185; add 4184
4186; mul 549 653; sub 4187 4188; input p 176; mul 550 4190; mul 99 672; add 4191 4192; add 4189 4193; mul 61 530;
mul 27 521; add 4195 4196; mul 46 550; add 4197 4198; mul 530 4199; mul 27 530; mul 30 521; add 4201 4202; mul 33
550; add 4203 4204; mul 521 4205; add 4200 4206; mul 46 530; mul 33 521; add 4208 4209; mul 50 550; add 4210 4211;
mul 550 4212; add 4207 4213; mul 37 4182; sub 24 4215; mul 4066 4216; add 4214 4217; mul 52 4218; mul 21 4219; add
4194 4220; mul 88 683; mul 4221 4222; mul 91 2940; mul 91 2839; mul 538 4225; add 4224 4226; mul 541 653; sub 4227
4228; mul 96 672; add 4229 4230; mul 528 556; mul 642 650; add 4232 4233; add 4231 4234; sub 1343 4235; mul 16 4095;
add 4236 4237; input p 128; input z 0; mul 4239 4240; input p 129; input z 1; mul 4242 4243; add 4241 4244; input p
130; input z 2; mul 4246 4247; add 4245 4248; input p 131; input z 3; mul 4250 4251; add 4249 4252; input p 152; mul
4253 4254; sub 4238 4255; mul 40 4218; mul 23 4182; add 38 4258; mul 4066 4259; mul 25 4260; sub 4257 4261; mul 21
4262; mul 18 4182; mul 4065 4264; sub 4263 4265; sub 4256 4266; mul 88 679; mul 4267 4268; add 4223 4269; input c 0;
input c 2; mul 481 4272; add 4271 4273; input c 3; mul 599 4275; add 4274 4276; mul 1327 1361; add 4277 4278; mul
1325 1343; sub 4279 4280; input p 16; input c 1; add 4282 4283; max 4284 221; mul 530 4285; sub 4281 4286; mul 531
556; mul 644 650; add 4288 4289; sub 676 4290; sub 4287 4291; input p 127; sub 4293 4253; input p 132; abs 530; mul
4295 4296; mul 530 4297; input p 133; mul 530 4299; mul 530 530; input p 134; add 4301 4302; sqrt 4303; div 1 4304;
mul 4300 4305; add 4298 4306; sub 4294 4307; add 4292 4308; input p 135; input x 12; sub 28 4311; mul 4310 4312;
input p 136; input x 13; sub 28 4315; mul 4314 4316; add 4313 4317; sub 4309 4318; mul 66 4218; sub 4320 4260; mul
21 4321; sub 4319 4322; mul 88 89; mul 4323 4324; sub 4270 4325; mul 78 4326; mul 58 4327; mul 75 4326; mul 55 4329;
sub 4328 4330; mul 21 4331; mul 4068 4260; sub 4332 4333; mul 88 4221; mul 58 4335; mul 88 4267; mul 55 4337; add
4336 4338; mul 80 4326; add 4339 4340; mul 21 4341; sub 4334 4342; mul 25 463; mul 78 4335; mul 78 4327; sub 4345
4346; mul 69 4326; mul 55 4348; add 4347 4349; mul 88 4323; mul 55 4351; add 4350 4352; mul 21 4353; mul 4344 4354;
add 4343 4355; mul 22 4356; add 4082 4357; mul 16 4358; add 4183 4359; mul 8 4360; mul 15 4063; mul 4085 4179; mul 9
4086; add 4363 4364; mul 4362 4365; mul 4070 4259; mul 22 4367; mul 679 4264; sub 4368 4369; mul 4081 4216; mul 22
4371; add 4370 4372; mul 521 4373; mul 521 4374; mul 4068 4218; mul 66 4332; add 4376 4377; mul 66 4342; sub 4378
4379; mul 78 4337; mul 75 4327; add 4381 4382; mul 58 4348; sub 4383 4384; mul 58 4351; sub 4385 4386; mul 21 4387;
mul 52 4388; add 4380 4389; mul 78 4329; mul 75 4335; sub 4391 4392; sub 4393 4384; sub 4394 4386; mul 21 4395; mul
52 4396; add 4390 4397; mul 40 463; mul 4354 4399; add 4398 4400; mul 22 4401; add 4071 4402; mul 37 4403; add 4375
4404; mul 23 4358; add 4405 4406; mul 18 4353; add 4407 4408; mul 16 4353; mul 4073 4182; sub 4410 4411; mul 17
4412; add 4409 4413; mul 4092 4414; add 4366 4415; mul 7 4416; sub 4361 4417; mul 4171 4418; mul 2 4419; mul 2 4420;
add 4175 4421; mul 15 4365; mul 8 4178; mul 4085 4424; sub 4423 4425; mul 4088 4178; sub 4426 4427; mul 16 4403; mul
4082 4182; sub 4429 4430; mul 4106 4431; sub 4428 4432; mul 4143 4360; sub 4433 4434; mul 13 4416; sub 4435 4436;
mul 15 4414; mul 4102 4438; sub 4437 4439; mul 4162 4440; mul 2 4441; mul 2 4442; add 4422 4443; mul 1374 4065; mul
18 4445; mul 21 1374; mul 25 4447; sub 4448 4068; mul 4066 4449; mul 23 4450; add 4446 4451; mul 21 1383; mul 52
4453; mul 40 4447; sub 4454 4455; mul 66 4068; add 4456 4457; mul 4066 4458; mul 37 4459; sub 4452 4460; mul 2 4461;
mul 4063 4462; mul 4063 4463; mul 8 4462; mul 8 4465; mul 463 4466; add 4464 4467; mul 1374 4095; mul 641 1451; sub
4469 4470; mul 527 1514; sub 4471 4472; mul 4092 4473; mul 13 4474; mul 15 4473; mul 4102 4476; add 4475 4477; mul
16 1374; mul 4094 4479; mul 565 1475; mul 560 4481; add 4480 4482; mul 572 1475; mul 563 4484; sub 4483 4485; mul
563 1478; add 4486 4487; mul 581 1442; mul 636 1475; sub 4489 4490; mul 1472 4120; add 4491 4492; mul 560 4493; add
4488 4494; mul 444 1516; mul 439 4496; add 4495 4497; mul 451 1516; mul 442 4499; add 4498 4500; mul 442 1585; sub
4501 4502; mul 460 1560; mul 522 1516; sub 4504 4505; mul 1583 4136; add 4506 4507; mul 439 4508; add 4503 4509; mul
4106 4510; add 4478 4511; mul 560 1478; mul 563 4481; mul 560 4484; add 4514 4515; sub 4513 4516; mul 563 4493; sub
4517 4518; mul 442 4496; add 4519 4520; mul 439 4499; sub 4521 4522; mul 439 1585; add 4523 4524; mul 442 4508; add
4525 4526; mul 4143 4527; add 4512 4528; mul 4162 4529; mul 2 4530; mul 2 4531; sub 4468 4532; mul 8 4527; mul 7
4474; sub 4534 4535; mul 4171 4536; mul 2 4537; mul 2 4538; add 4533 4539; mul 4182 4450; mul 4260 4447; mul 4268
4323; mul 88 1383; mul 4221 4544; sub 4543 4545; mul 88 1374; mul 4267 4547; sub 4546 4548; mul 78 4549; mul 58
4550; add 4345 4352; sub 4551 4552; mul 75 4549; mul 55 4554; sub 4553 4555; mul 21 4556; add 4542 4557; mul 80
4549; mul 21 4559; sub 4558 4560; mul 69 4549; mul 55 4562; mul 78 4550; sub 4563 4564; mul 21 4565; mul 4344 4566;
add 4561 4567; mul 22 4568; add 4459 4569; mul 16 4570; add 4541 4571; mul 8 4572; mul 4179 4462; mul 9 4463; add
4574 4575; mul 4362 4576; mul 1374 4264; mul 4259 4449; mul 22 4579; add 4578 4580; mul 4216 4458; mul 22 4582; add
4581 4583; mul 521 4584; mul 521 4585; mul 66 4557; mul 4218 4447; sub 4587 4588; mul 66 4560; sub 4589 4590; mul 75
4550; mul 58 4562; sub 4592 4593; mul 21 4594; mul 52 4595; add 4591 4596; mul 69 4335; mul 78 4351; add 4598 4599;
mul 78 4554; add 4600 4601; sub 4602 4593; mul 21 4603; mul 52 4604; add 4597 4605; mul 4399 4566; add 4606 4607;
mul 22 4608; add 4450 4609; mul 37 4610; add 4586 4611; mul 23 4570; add 4612 4613; mul 18 4565; add 4614 4615; mul
4182 4445; mul 16 4565; add 4617 4618; mul 17 4619; add 4616 4620; mul 4092 4621; add 4577 4622; mul 7 4623; sub
4573 4624; mul 4171 4625; mul 2 4626; mul 2 4627; add 4540 4628; mul 15 4576; mul 4424 4462; sub 4630 4631; mul 4178
4465; sub 4632 4633; mul 16 4610; mul 4182 4459; sub 4635 4636; mul 4106 4637; sub 4634 4638; mul 4143 4572; sub
4639 4640; mul 13 4623; sub 4641 4642; mul 15 4621; mul 4102 4644; sub 4643 4645; mul 4162 4646; mul 2 4647; mul 2
4648; add 4629 4649; mul 25 4453; sub 4077 4651; mul 4066 4652; mul 23 4653; mul 1383 4065; mul 18 4655; sub 4654
4656; mul 40 4453; mul 21 1963; mul 52 4659; sub 4658 4660; mul 66 4077; sub 4661 4662; mul 4066 4663; mul 37 4664;
sub 4657 4665; mul 2 4666; mul 4063 4667; mul 4063 4668; mul 8 4667; mul 8 4670; mul 463 4671; add 4669 4672; mul
641 1979; mul 1383 4095; sub 4674 4675; mul 527 2099; add 4676 4677; mul 4092 4678; mul 13 4679; mul 15 4678; mul
4102 4681; add 4680 4682; mul 572 1981; mul 563 4684; mul 16 1383; mul 4094 4686; mul 565 1981; mul 560 4688; add
4687 4689; sub 4685 4690; mul 563 2047; add 4691 4692; mul 581 2023; mul 636 1981; add 4694 4695; mul 2045 4120; add
4696 4697; mul 560 4698; add 4693 4699; mul 444 2101; mul 439 4701; sub 4700 4702; mul 451 2101; mul 442 4704; sub
4703 4705; mul 442 2167; sub 4706 4707; mul 460 2143; mul 522 2101; add 4709 4710; mul 2165 4136; add 4711 4712; mul
439 4713; add 4708 4714; mul 4106 4715; add 4683 4716; mul 563 4688; mul 560 4684; add 4718 4719; mul 560 2047; add
4720 4721; mul 563 4698; sub 4722 4723; mul 442 4701; sub 4724 4725; mul 439 4704; add 4726 4727; mul 439 2167; add
4728 4729; mul 442 4713; add 4730 4731; mul 4143 4732; add 4717 4733; mul 4162 4734; mul 2 4735; mul 2 4736; sub
4673 4737; mul 8 4732; mul 7 4679; sub 4739 4740; mul 4171 4741; mul 2 4742; mul 2 4743; add 4738 4744; mul 4182
4653; add 4386 4392; mul 88 1963; mul 4221 4748; mul 4267 4544; add 4749 4750; mul 4222 4323; sub 4751 4752; mul 78
4753; mul 58 4754; add 4747 4755; mul 75 4753; mul 55 4757; sub 4756 4758; mul 21 4759; mul 4260 4453; sub 4760
4761; add 4381 4392; mul 80 4753; sub 4763 4764; mul 21 4765; add 4762 4766; mul 69 4753; mul 55 4768; mul 78 4754;
add 4600 4770; sub 4769 4771; mul 21 4772; mul 4344 4773; add 4767 4774; mul 22 4775; add 4664 4776; mul 16 4777;
add 4746 4778; mul 8 4779; mul 4179 4667; mul 9 4668; add 4781 4782; mul 4362 4783; mul 4259 4652; mul 22 4785; mul
1383 4264; sub 4786 4787; mul 4216 4663; mul 22 4789; add 4788 4790; mul 521 4791; mul 521 4792; mul 4218 4453; mul
66 4760; add 4794 4795; mul 66 4766; add 4796 4797; mul 75 4351; mul 69 4337; sub 4799 4800; mul 75 4754; add 4801
4802; mul 58 4768; sub 4803 4804; mul 21 4805; mul 52 4806; add 4798 4807; mul 78 4757; sub 4809 4804; mul 21 4810;
mul 52 4811; add 4808 4812; mul 4399 4773; add 4813 4814; mul 22 4815; add 4653 4816; mul 37 4817; add 4793 4818;
mul 23 4777; add 4819 4820; mul 18 4772; add 4821 4822; mul 16 4772; mul 4182 4655; sub 4824 4825; mul 17 4826; add
4823 4827; mul 4092 4828; add 4784 4829; mul 7 4830; sub 4780 4831; mul 4171 4832; mul 2 4833; mul 2 4834; add 4745
4835; mul 15 4783; mul 4424 4667; sub 4837 4838; mul 4178 4670; sub 4839 4840; mul 16 4817; mul 4182 4664; sub 4842
4843; mul 4106 4844; sub 4841 4845; mul 4143 4779; sub 4846 4847; mul 13 4830; sub 4848 4849; mul 15 4828; mul 4102
4851; sub 4850 4852; mul 4162 4853; mul 2 4854; mul 2 4855; add 4836 4856; mul 451 2555; mul 439 4858; mul 444 2555;
mul 442 4860; sub 4859 4861; mul 439 2587; add 4862 4863; mul 522 2555; mul 460 2573; sub 4865 4866; mul 2585 4136;
add 4867 4868; mul 442 4869; add 4864 4870; mul 8 4871; mul 527 2553; mul 4092 4873; mul 7 4874; sub 4872 4875; mul
4171 4876; mul 2 4877; mul 2 4878; mul 13 4874; mul 15 4873; mul 4102 4881; add 4880 4882; mul 439 4869; mul 439
4860; mul 442 4858; add 4885 4886; mul 442 2587; add 4887 4888; sub 4884 4889; mul 4106 4890; add 4883 4891; mul
4143 4871; add 4892 4893; mul 4162 4894; mul 2 4895; mul 2 4896; sub 4879 4897; mul 565 2676; mul 563 4899; mul 572
2676; mul 560 4901; add 4900 4902; mul 560 2708; add 4903 4904; mul 636 2676; mul 581 2694; sub 4906 4907; mul 2706
4120; add 4908 4909; mul 563 4910; sub 4905 4911; mul 8 4912; mul 641 2674; mul 4092 4914; mul 7 4915; sub 4913
4916; mul 4171 4917; mul 2 4918; mul 2 4919; mul 13 4915; mul 15 4914; mul 4102 4922; add 4921 4923; mul 563 4901;
mul 560 4899; sub 4925 4926; mul 563 2708; add 4927 4928; mul 560 4910; add 4929 4930; mul 4106 4931; add 4924 4932;
mul 4143 4912; add 4933 4934; mul 4162 4935; mul 2 4936; mul 2 4937; sub 4920 4938; mul 290 976; mul 669 4940; neg
4941; mul 290 1648; mul 669 4943; mul 290 2204; mul 669 4945; neg 4946; mul 290 944; mul 293 976; mul 947 4949; sub
4948 4950; mul 293 1648; mul 947 4952; mul 290 1627; sub 4953 4954; mul 290 2176; mul 293 2204; mul 947 4957; sub
4956 4958; mul 290 950; mul 297 976; mul 947 4961; add 4960 4962; neg 4963; mul 290 1621; mul 297 1648; mul 947
4966; add 4965 4967; mul 290 2179; mul 297 2204; mul 947 4970; add 4969 4971; neg 4972; mul 293 944; mul 463 4974;
mul 301 976; neg 4976; mul 463 4977; add 4975 4978; mul 293 1627; neg 4980; mul 463 4981; mul 301 1648; mul 463
4983; add 4982 4984; mul 293 2176; mul 463 4986; mul 301 2204; neg 4988; mul 463 4989; add 4987 4990; mul 297 944;
mul 293 950; sub 4992 4993; mul 305 976; neg 4995; mul 463 4996; add 4994 4997; mul 293 1621; mul 297 1627; sub 4999
5000; mul 305 1648; mul 463 5002; add 5001 5003; mul 297 2176; mul 293 2179; sub 5005 5006; mul 305 2204; neg 5008;
mul 463 5009; add 5007 5010; mul 297 950; neg 5012; mul 463 5013; mul 309 976; neg 5015; mul 463 5016; add 5014
5017; mul 297 1621; mul 463 5019; mul 309 1648; mul 463 5021; add 5020 5022; mul 297 2179; neg 5024; mul 463 5025;
mul 309 2204; neg 5027; mul 463 5028; add 5026 5029; mul 301 944; mul 947 5031; mul 313 976; sub 5032 5033; mul 313
1648; mul 301 1627; mul 947 5036; sub 5035 5037; mul 301 2176; mul 947 5039; mul 313 2204; sub 5040 5041; mul 305
944; mul 463 5043; mul 301 950; sub 5044 5045; mul 317 976; sub 5046 5047; mul 301 1621; mul 305 1627; neg 5050; mul
463 5051; add 5049 5052; mul 317 1648; add 5053 5054; mul 305 2176; mul 463 5056; mul 301 2179; sub 5057 5058; mul
317 2204; sub 5059 5060; mul 305 950; neg 5062; mul 463 5063; mul 309 944; add 5064 5065; mul 321 976; sub 5066
5067; mul 305 1621; mul 463 5069; mul 309 1627; sub 5070 5071; mul 321 1648; add 5072 5073; mul 305 2179; neg 5075;
mul 463 5076; mul 309 2176; add 5077 5078; mul 321 2204; sub 5079 5080; mul 309 950; mul 947 5082; add 1003 5083;
neg 5084; mul 309 1621; mul 947 5086; add 1673 5087; mul 309 2179; mul 947 5089; add 2229 5090; neg 5091; mul 313
944; mul 669 5093; mul 313 1627; mul 669 5095; neg 5096; mul 313 2176; mul 669 5098; mul 317 944; mul 947 5100; mul
313 950; sub 5101 5102; mul 313 1621; mul 317 1627; mul 947 5105; sub 5104 5106; mul 317 2176; mul 947 5108; mul 313
2179; sub 5109 5110; mul 317 950; neg 5112; mul 463 5113; mul 321 944; mul 463 5115; add 5114 5116; mul 317 1621;
mul 463 5118; mul 321 1627; neg 5120; mul 463 5121; add 5119 5122; mul 317 2179; neg 5124; mul 463 5125; mul 321
2176; mul 463 5127; add 5126 5128; mul 321 950; mul 947 5130; sub 981 5131; mul 321 1621; mul 947 5133; sub 5134
1655; mul 321 2179; mul 947 5136; sub 2209 5137; mul 669 984; neg 5139; mul 669 1653; mul 669 2211; neg 5142; mul
290 951; mul 233 1003; mul 947 5145; add 5144 5146; neg 5147; mul 290 1622; mul 233 1673; mul 947 5150; add 5149
5151; mul 290 2180; mul 233 2229; mul 947 5154; add 5153 5155; neg 5156; mul 233 981; mul 293 951; sub 5158 5159;
mul 252 1003; neg 5161; mul 463 5162; add 5160 5163; mul 293 1622; mul 233 1655; sub 5165 5166; mul 252 1673; mul
463 5168; add 5167 5169; mul 233 2209; mul 293 2180; sub 5171 5172; mul 252 2229; neg 5174; mul 463 5175; add 5173
5176; mul 272 1003; neg 5178; mul 463 5179; mul 297 951; mul 233 984; add 5181 5182; sub 5180 5183; mul 297 1622;
mul 233 1653; add 5185 5186; mul 272 1673; mul 463 5188; add 5187 5189; mul 272 2229; neg 5191; mul 463 5192; mul
297 2180; mul 233 2211; add 5194 5195; sub 5193 5196; mul 252 981; mul 463 5198; mul 301 951; sub 5199 5200; mul 276
1003; sub 5201 5202; mul 301 1622; mul 252 1655; neg 5205; mul 463 5206; add 5204 5207; mul 276 1673; add 5208 5209;
mul 252 2209; mul 463 5211; mul 301 2180; sub 5212 5213; mul 276 2229; sub 5214 5215; mul 272 981; mul 305 951; mul
252 984; add 5218 5219; sub 5217 5220; mul 280 1003; sub 5221 5222; mul 305 1622; mul 252 1653; add 5224 5225; mul
272 1655; sub 5226 5227; mul 280 1673; add 5228 5229; mul 272 2209; mul 305 2180; mul 252 2211; add 5232 5233; sub
5231 5234; mul 280 2229; sub 5235 5236; mul 272 984; neg 5238; mul 463 5239; mul 309 951; sub 5240 5241; mul 284
1003; sub 5242 5243; mul 309 1622; mul 272 1653; mul 463 5246; add 5245 5247; mul 284 1673; add 5248 5249; mul 272
2211; neg 5251; mul 463 5252; mul 309 2180; sub 5253 5254; mul 284 2229; sub 5255 5256; mul 276 981; mul 947 5258;
mul 313 951; sub 5259 5260; mul 313 1622; mul 276 1655; mul 947 5263; sub 5262 5264; mul 276 2209; mul 947 5266; mul
313 2180; sub 5267 5268; mul 280 981; mul 463 5270; mul 317 951; mul 276 984; add 5272 5273; sub 5271 5274; mul 317
1622; mul 276 1653; add 5276 5277; mul 280 1655; neg 5279; mul 463 5280; add 5278 5281; mul 280 2209; mul 463 5283;
mul 317 2180; mul 276 2211; add 5285 5286; sub 5284 5287; mul 280 984; neg 5289; mul 463 5290; mul 321 951; sub 5291
5292; mul 284 981; add 5293 5294; mul 321 1622; mul 280 1653; mul 463 5297; add 5296 5298; mul 284 1655; sub 5299
5300; mul 280 2211; neg 5302; mul 463 5303; mul 321 2180; sub 5304 5305; mul 284 2209; add 5306 5307; mul 287 951;
mul 284 984; mul 947 5310; add 5309 5311; neg 5312; mul 287 1622; mul 284 1653; mul 947 5315; add 5314 5316; mul 287
2180; mul 284 2211; mul 947 5319; add 5318 5320; neg 5321; mul 290 972; mul 669 5323; mul 290 1644; mul 669 5325;
mul 290 2200; mul 669 5327; mul 290 2608; mul 669 5329; mul 290 2740; mul 669 5331; mul 290 966; mul 293 972; mul
947 5334; add 5333 5335; mul 290 1639; mul 293 1644; mul 947 5338; add 5337 5339; mul 290 2194; mul 293 2200; mul
947 5342; add 5341 5343; mul 290 2602; mul 293 2608; mul 947 5346; add 5345 5347; mul 290 2734; mul 293 2740; mul
947 5350; add 5349 5351; mul 290 960; mul 297 972; mul 947 5354; add 5353 5355; mul 290 1633; mul 297 1644; mul 947
5358; add 5357 5359; mul 290 2188; mul 297 2200; mul 947 5362; add 5361 5363; mul 290 2597; mul 297 2608; mul 947
5366; add 5365 5367; mul 290 2729; mul 297 2740; mul 947 5370; add 5369 5371; mul 293 966; mul 463 5373; mul 301
972; mul 463 5375; add 5374 5376; mul 293 1639; mul 463 5378; mul 301 1644; mul 463 5380; add 5379 5381; mul 293
2194; mul 463 5383; mul 301 2200; mul 463 5385; add 5384 5386; mul 293 2602; mul 463 5388; mul 301 2608; mul 463
5390; add 5389 5391; mul 293 2734; mul 463 5393; mul 301 2740; mul 463 5395; add 5394 5396; mul 293 960; mul 297
966; add 5398 5399; mul 305 972; mul 463 5401; add 5400 5402; mul 293 1633; mul 297 1639; add 5404 5405; mul 305
1644; mul 463 5407; add 5406 5408; mul 293 2188; mul 297 2194; add 5410 5411; mul 305 2200; mul 463 5413; add 5412
5414; mul 293 2597; mul 297 2602; add 5416 5417; mul 305 2608; mul 463 5419; add 5418 5420; mul 293 2729; mul 297
2734; add 5422 5423; mul 305 2740; mul 463 5425; add 5424 5426; mul 297 960; mul 463 5428; mul 309 972; mul 463
5430; add 5429 5431; mul 297 1633; mul 463 5433; mul 309 1644; mul 463 5435; add 5434 5436; mul 297 2188; mul 463
5438; mul 309 2200; mul 463 5440; add 5439 5441; mul 297 2597; mul 463 5443; mul 309 2608; mul 463 5445; add 5444
5446; mul 297 2729; mul 463 5448; mul 309 2740; mul 463 5450; add 5449 5451; mul 301 966; mul 947 5453; mul 313 972;
add 5454 5455; mul 301 1639; mul 947 5457; mul 313 1644; add 5458 5459; mul 301 2194; mul 947 5461; mul 313 2200;
add 5462 5463; mul 301 2602; mul 947 5465; mul 313 2608; add 5466 5467; mul 301 2734; mul 947 5469; mul 313 2740;
add 5470 5471; mul 301 960; mul 305 966; mul 463 5474; add 5473 5475; mul 317 972; add 5476 5477; mul 301 1633; mul
305 1639; mul 463 5480; add 5479 5481; mul 317 1644; add 5482 5483; mul 301 2188; mul 305 2194; mul 463 5486; add
5485 5487; mul 317 2200; add 5488 5489; mul 301 2597; mul 305 2602; mul 463 5492; add 5491 5493; mul 317 2608; add
5494 5495; mul 301 2729; mul 305 2734; mul 463 5498; add 5497 5499; mul 317 2740; add 5500 5501; mul 305 960; mul
463 5503; mul 309 966; add 5504 5505; mul 321 972; add 5506 5507; mul 305 1633; mul 463 5509; mul 309 1639; add 5510
5511; mul 321 1644; add 5512 5513; mul 305 2188; mul 463 5515; mul 309 2194; add 5516 5517; mul 321 2200; add 5518
5519; mul 305 2597; mul 463 5521; mul 309 2602; add 5522 5523; mul 321 2608; add 5524 5525; mul 305 2729; mul 463
5527; mul 309 2734; add 5528 5529; mul 321 2740; add 5530 5531; mul 309 960; mul 947 5533; mul 287 972; add 5534
5535; mul 309 1633; mul 947 5537; mul 287 1644; add 5538 5539; mul 309 2188; mul 947 5541; mul 287 2200; add 5542
5543; mul 309 2597; mul 947 5545; mul 287 2608; add 5546 5547; mul 309 2729; mul 947 5549; mul 287 2740; add 5550
5551; mul 313 966; mul 669 5553; mul 313 1639; mul 669 5555; mul 313 2194; mul 669 5557; mul 313 2602; mul 669 5559;
mul 313 2734; mul 669 5561; mul 313 960; mul 317 966; mul 947 5564; add 5563 5565; mul 313 1633; mul 317 1639; mul
947 5568; add 5567 5569; mul 313 2188; mul 317 2194; mul 947 5572; add 5571 5573; mul 313 2597; mul 317 2602; mul
947 5576; add 5575 5577; mul 313 2729; mul 317 2734; mul 947 5580; add 5579 5581; mul 317 960; mul 463 5583; mul 321
966; mul 463 5585; add 5584 5586; mul 317 1633; mul 463 5588; mul 321 1639; mul 463 5590; add 5589 5591; mul 317
2188; mul 463 5593; mul 321 2194; mul 463 5595; add 5594 5596; mul 317 2597; mul 463 5598; mul 321 2602; mul 463
5600; add 5599 5601; mul 317 2729; mul 463 5603; mul 321 2734; mul 463 5605; add 5604 5606; mul 321 960; mul 947
5608; mul 287 966; add 5609 5610; mul 321 1633; mul 947 5612; mul 287 1639; add 5613 5614; mul 321 2188; mul 947
5616; mul 287 2194; add 5617 5618; mul 321 2597; mul 947 5620; mul 287 2602; add 5621 5622; mul 321 2729; mul 947
5624; mul 287 2734; add 5625 5626; mul 287 960; mul 669 5628; mul 287 1633; mul 669 5630; mul 287 2188; mul 669
5632; mul 287 2597; mul 669 5634; mul 287 2729; mul 669 5636; mul 679 4262; mul 683 4219; sub 5638 5639; mul 89
4321; sub 5640 5641; mul 44 4335; mul 58 4337; add 5643 5644; mul 85 4326; add 5645 5646; mul 77 5647; add 5642
5648; mul 58 4329; mul 44 4327; sub 5650 5651; mul 77 5652; add 5649 5653; mul 73 4331; add 5654 5655; mul 73 4341;
sub 5656 5657; mul 60 4326; mul 68 5659; add 5658 5660; mul 57 4387; add 5661 5662; mul 57 4395; add 5663 5664; mul
44 4348; mul 75 4337; mul 75 4329; add 5667 5668; sub 5666 5669; mul 44 4351; add 5670 5671; mul 53 5672; add 5665
5673; mul 42 4353; add 5674 5675; mul 1383 4219; mul 1374 4262; sub 5677 5678; mul 679 4321; add 5679 5680; mul 85
4549; sub 5682 4763; mul 77 5683; add 5681 5684; sub 4386 4381; mul 44 4550; sub 5686 5687; mul 58 4554; add 5688
5689; mul 77 5690; add 5685 5691; mul 73 4556; add 5692 5693; mul 73 4559; sub 5694 5695; mul 60 4549; add 4339
5697; mul 68 5698; add 5696 5699; mul 57 4594; add 5700 5701; mul 57 4603; add 5702 5703; sub 4800 4799; mul 75
4554; sub 5705 5706; mul 44 4562; add 5707 5708; mul 53 5709; add 5704 5710; mul 42 4565; add 5711 5712; mul 1383
4262; mul 1963 4219; sub 5714 5715; mul 683 4321; sub 5716 5717; mul 85 4753; mul 77 5719; add 5718 5720; sub 5667
5671; mul 44 4754; sub 5722 5723; mul 58 4757; add 5724 5725; mul 77 5726; add 5721 5727; mul 73 4759; add 5728
5729; mul 73 4765; add 5730 5731; mul 60 4753; sub 5733 5645; mul 68 5734; add 5732 5735; mul 57 4805; add 5736
5737; mul 57 4810; add 5738 5739; mul 44 4768; mul 75 4757; sub 5741 5742; mul 53 5743; add 5740 5744; mul 42 4772;
add 5745 5746; sub 4331 4341; sub 4556 4559; add 4759 4765; mul 16 4412; mul 16 4619; mul 16 4826; mul 530 4081; mul
530 5754; mul 370 924; mul 28 5756; add 969 5757; mul 28 5758; add 5755 5759; mul 21 5647; mul 52 5761; mul 4067
4218; sub 5762 5763; mul 21 5652; mul 52 5765; add 5764 5766; mul 40 4332; add 5767 5768; mul 40 4342; sub 5769
5770; mul 66 463; mul 21 5659; mul 5772 5773; add 5771 5774; mul 28 5775; add 5760 5776; mul 530 4458; mul 530 5778;
mul 370 1586; mul 28 5780; sub 5781 1613; mul 28 5782; add 5779 5783; mul 21 5683; mul 52 5785; add 4376 5786; mul
21 5690; mul 52 5788; add 5787 5789; mul 40 4557; add 5790 5791; mul 40 4560; sub 5792 5793; mul 21 5698; mul 5772
5795; add 5794 5796; mul 28 5797; add 5784 5798; mul 530 4663; mul 530 5800; mul 370 2168; mul 28 5802; add 2197
5803; mul 28 5804; add 5801 5805; mul 21 5719; mul 52 5807; mul 4077 4218; sub 5808 5809; mul 21 5726; mul 52 5811;
add 5810 5812; mul 40 4760; add 5813 5814; mul 40 4766; add 5815 5816; mul 21 5734; mul 5772 5818; add 5817 5819;
mul 28 5820; add 5806 5821; mul 370 2587; mul 28 5823; add 2605 5824; mul 28 5825; mul 370 2708; mul 28 5827; add
2737 5828; mul 28 5829; mul 521 4081; mul 530 5831; mul 521 5754; add 5832 5833; mul 2 5756; add 802 5835; mul 28
5836; add 5834 5837; mul 2 5758; add 5838 5839; mul 2 5775; add 5840 5841; mul 28 4401; add 5842 5843; mul 521 4458;
mul 530 5845; mul 521 5778; add 5846 5847; mul 2 5780; add 1402 5849; mul 28 5850; add 5848 5851; mul 2 5782; add
5852 5853; mul 2 5797; add 5854 5855; mul 28 4608; add 5856 5857; mul 521 4663; mul 530 5859; mul 521 5800; add 5860
5861; mul 2 5802; add 2064 5863; mul 28 5864; add 5862 5865; mul 2 5804; add 5866 5867; mul 2 5820; add 5868 5869;
mul 28 4815; add 5870 5871; mul 2 5823; add 2540 5873; mul 28 5874; mul 2 5825; add 5875 5876; mul 2 5827; add 2710
5878; mul 28 5879; mul 2 5829; add 5880 5881; mul 521 5831; mul 2 5836; add 5883 5884; mul 2 4401; add 5885 5886;
mul 521 5845; mul 2 5850; add 5888 5889; mul 2 4608; add 5890 5891; mul 521 5859; mul 2 5864; add 5893 5894; mul 2
4815; add 5895 5896; mul 2 5874; mul 2 5879; mul 550 4081; mul 530 5900; mul 550 5754; add 5901 5902; mul 34 5756;
add 797 5904; mul 28 5905; add 5903 5906; mul 34 5758; add 5907 5908; mul 34 5775; add 5909 5910; mul 66 5761; sub
5912 5809; mul 66 5765; add 5913 5914; mul 40 4388; add 5915 5916; mul 40 4396; add 5917 5918; mul 52 463; mul 21
5672; mul 5920 5921; add 5919 5922; mul 28 5923; add 5911 5924; mul 550 4458; mul 530 5926; mul 550 5778; add 5927
5928; mul 34 5780; sub 5930 1482; mul 28 5931; add 5929 5932; mul 34 5782; add 5933 5934; mul 34 5797; add 5935
5936; mul 66 5785; add 4794 5938; mul 66 5788; add 5939 5940; mul 40 4595; add 5941 5942; mul 40 4604; add 5943
5944; mul 21 5709; mul 5920 5946; add 5945 5947; mul 28 5948; add 5937 5949; mul 550 4663; mul 530 5951; mul 550
5800; add 5952 5953; mul 34 5802; add 2060 5955; mul 28 5956; add 5954 5957; mul 34 5804; add 5958 5959; mul 34
5820; add 5960 5961; mul 66 5807; mul 4218 4659; sub 5963 5964; mul 66 5811; add 5965 5966; mul 40 4806; add 5967
5968; mul 40 4811; add 5969 5970; mul 21 5743; mul 5920 5972; add 5971 5973; mul 28 5974; add 5962 5975; mul 34
5823; add 2538 5977; mul 28 5978; mul 34 5825; add 5979 5980; mul 34 5827; add 2670 5982; mul 28 5983; mul 34 5829;
add 5984 5985; mul 521 5900; mul 550 5831; add 5987 5988; mul 2 5905; add 5989 5990; mul 34 5836; add 5991 5992; mul
2 5923; add 5993 5994; mul 34 4401; add 5995 5996; mul 521 5926; mul 550 5845; add 5998 5999; mul 2 5931; add 6000
6001; mul 34 5850; add 6002 6003; mul 2 5948; add 6004 6005; mul 34 4608; add 6006 6007; mul 521 5951; mul 550 5859;
add 6009 6010; mul 2 5956; add 6011 6012; mul 34 5864; add 6013 6014; mul 2 5974; add 6015 6016; mul 34 4815; add
6017 6018; mul 2 5978; mul 34 5874; add 6020 6021; mul 2 5983; mul 34 5879; add 6023 6024; mul 550 5900; mul 34
5905; add 6026 6027; mul 34 5923; add 6028 6029; mul 550 5926; mul 34 5931; add 6031 6032; mul 34 5948; add 6033
6034; mul 550 5951; mul 34 5956; add 6036 6037; mul 34 5974; add 6038 6039; mul 34 5978; mul 34 5983; mul 37 4109;
mul 22 6043; sub 689 6044; mul 37 4479; mul 22 6046; add 1388 6047; mul 37 4686; mul 22 6049; sub 1969 6050; mul
4065 4367; mul 368 6043; sub 6052 6053; mul 4065 4371; add 6054 6055; mul 38 4401; add 6056 6057; mul 24 4356; add
6058 6059; mul 368 6046; mul 4065 4579; add 6061 6062; mul 4065 4582; add 6063 6064; mul 38 4608; add 6065 6066; mul
24 4568; add 6067 6068; mul 4065 4785; mul 368 6049; sub 6070 6071; mul 4065 4789; add 6072 6073; mul 38 4815; add
6074 6075; mul 24 4775; add 6076 6077; neg 679; neg 494; neg 612; neg 497; neg 615; neg 501; neg 619; input p 231;
mul 589 716; mul 6086 6087; add 716 6088; input p 232; mul 6087 6090; mul 370 6091; add 6089 6092; add 855 6093; mul
471 855; mul 6086 6095; add 6094 6096; mul 6090 6095; mul 370 6098; add 6097 6099; mul 589 1417; mul 6086 6101; add
1417 6102; mul 6090 6101; mul 370 6104; add 6103 6105; add 1535 6106; mul 471 1535; mul 6086 6108; add 6107 6109;
mul 6090 6108; mul 370 6111; add 6110 6112; neg 6113; mul 589 1993; mul 6086 6115; add 1993 6116; mul 6090 6115; mul
370 6118; add 6117 6119; add 2113 6120; mul 471 2113; mul 6086 6122; add 6121 6123; mul 6090 6122; mul 370 6125; add
6124 6126; mul 471 2560; mul 6086 6128; add 2560 6129; mul 6090 6128; mul 370 6131; add 6130 6132; mul 589 2681; mul
6086 6134; add 2681 6135; mul 6090 6134; mul 370 6137; add 6136 6138; le 221 4284; le 4284 221; add 6140 6141; div 1
6142; mul 6140 6143; mul 89 530; mul 6144 6145; neg 6146; mul 530 679; mul 6144 6148; mul 530 683; mul 6144 6150;
neg 6151; mul 4296 6145; neg 6153; mul 4296 6148; mul 4296 6150; neg 6156; mul 89 4305; mul 530 6158; neg 6159; mul
679 4305; mul 530 6161; mul 683 4305; mul 530 6163; neg 6164; input p 233; mul 4305 4306; mul 89 6167; mul 463 4304;
div 1 6169; mul 6168 6170; mul 6166 6171; mul 679 6167; mul 6170 6173; mul 6166 6174; neg 6175; mul 683 6167; mul
6170 6177; mul 6166 6178; mul 679 4253; mul 1374 4253; neg 6181; mul 1383 4253; le 1 4240; mul 521 4254; add 530
6185; lt 221 6186; and 6184 6187; constant -1.0; le 4240 6189; lt 6186 221; and 6190 6191; or 6188 6192; not 6193;
input p 182; mul 521 6195; where 6194 6196; le 1 4243; and 6187 6198; le 4243 6189; and 6191 6200; or 6199 6201; not
6202; input p 183; mul 521 6204; where 6203 6205; le 1 4247; and 6187 6207; le 4247 6189; and 6191 6209; or 6208
6210; not 6211; input p 184; mul 521 6213; where 6212 6214; le 1 4251; and 6187 6216; le 4251 6189; and 6191 6218;
or 6217 6219; not 6220; input p 185; mul 521 6222; where 6221 6223; mul 23 4138; mul 23 4125; mul 37 4128; add 6226
6227; mul 37 923; add 6228 6229; sub 6225 6230; mul 23 4496; mul 37 4499; add 6232 6233; mul 37 1585; sub 6234 6235;
mul 23 4508; add 6236 6237; mul 23 4713; mul 23 4701; mul 37 4704; add 6240 6241; mul 37 2167; add 6242 6243; sub
6239 6244; mul 23 4869; mul 23 4860; mul 37 4858; add 6247 6248; mul 37 2587; add 6249 6250; sub 6246 6251; mul 23
4128; mul 37 4125; sub 6253 6254; mul 23 923; add 6255 6256; mul 37 4138; add 6257 6258; mul 37 4496; mul 23 4499;
sub 6260 6261; mul 23 1585; add 6262 6263; mul 37 4508; add 6264 6265; mul 23 4704; mul 37 4701; sub 6267 6268; mul
23 2167; add 6269 6270; mul 37 4713; add 6271 6272; mul 23 4858; mul 37 4860; sub 6274 6275; mul 23 2587; add 6276
6277; mul 37 4869; add 6278 6279; neg 4138; neg 4508; neg 4713; neg 4869; mul 445 460; mul 903 6285; mul 445 508;
mul 886 6287; add 6286 6288; mul 445 492; mul 792 6290; add 6289 6291; mul 445 456; mul 919 6293; add 6292 6294; neg
6295; mul 1550 6287; mul 1565 6285; sub 6297 6298; mul 1397 6290; add 6299 6300; mul 1581 6293; sub 6301 6302; mul
2147 6285; mul 2131 6287; add 6304 6305; mul 2055 6290; add 6306 6307; mul 2163 6293; add 6308 6309; neg 6310; mul
2577 6285; mul 2563 6287; add 6312 6313; mul 2583 6293; add 6314 6315; neg 6316; mul 467 905; mul 467 1567; neg
6319; mul 467 2149; neg 1544; mul 473 877; mul 473 1544; neg 6324; mul 473 2125; mul 489 858; mul 481 6327; neg
6328; mul 489 1523; mul 481 6330; mul 489 2116; mul 481 6332; neg 6333; input p 234; mul 471 862; mul 6335 6336; add
862 6337; input p 235; mul 6336 6339; mul 370 6340; add 6338 6341; neg 6342; mul 471 1539; mul 6335 6344; add 1539
6345; mul 6339 6344; mul 370 6347; add 6346 6348; mul 471 2120; mul 6335 6350; add 2120 6351; mul 6339 6350; mul 370
6353; add 6352 6354; neg 6355; mul 515 792; mul 494 6357; mul 515 1397; mul 494 6359; neg 6360; mul 515 2055; mul
494 6362; mul 497 6357; mul 497 6359; neg 6365; mul 497 6362; mul 501 6357; mul 501 6359; neg 6369; mul 501 6362;
mul 515 848; mul 515 1528; neg 6373; mul 515 2106; mul 23 4111; mul 37 4107; add 6376 6377; mul 37 784; add 6378
6379; mul 23 4122; sub 6380 6381; mul 37 1478; mul 23 4481; mul 37 4484; add 6384 6385; sub 6383 6386; mul 23 4493;
sub 6387 6388; mul 23 4688; mul 37 4684; add 6390 6391; mul 37 2047; add 6392 6393; mul 23 4698; sub 6394 6395; mul
23 4899; mul 37 4901; add 6397 6398; mul 37 2708; add 6399 6400; mul 23 4910; sub 6401 6402; mul 23 4107; mul 37
4111; sub 6404 6405; mul 23 784; add 6406 6407; mul 37 4122; add 6408 6409; mul 37 4481; mul 23 4484; sub 6411 6412;
mul 23 1478; add 6413 6414; mul 37 4493; add 6415 6416; mul 23 4684; mul 37 4688; sub 6418 6419; mul 23 2047; add
6420 6421; mul 37 4698; add 6422 6423; mul 23 4901; mul 37 4899; sub 6425 6426; mul 23 2708; add 6427 6428; mul 37
4910; add 6429 6430; mul 566 581; mul 764 6432; mul 566 625; mul 747 6434; add 6433 6435; mul 566 610; mul 691 6437;
add 6436 6438; mul 566 577; mul 780 6440; add 6439 6441; neg 6442; mul 1432 6434; mul 1454 6432; sub 6444 6445; mul
1390 6437; add 6446 6447; mul 1470 6440; sub 6448 6449; mul 2027 6432; mul 2011 6434; add 6451 6452; mul 1971 6437;
add 6453 6454; mul 2043 6440; add 6455 6456; neg 6457; mul 2698 6432; mul 2684 6434; add 6459 6460; mul 2704 6440;
add 6461 6462; neg 6463; mul 587 766; mul 587 1456; neg 6466; mul 587 2029; neg 1426; mul 591 738; mul 591 1426; neg
6471; mul 591 2005; mul 607 719; mul 599 6474; neg 6475; mul 607 1405; mul 599 6477; mul 607 1996; mul 599 6479; neg
6480; input p 236; mul 589 723; mul 6482 6483; add 723 6484; input p 237; mul 6483 6486; mul 370 6487; add 6485
6488; neg 6489; mul 589 1421; mul 6482 6491; add 1421 6492; mul 6486 6491; mul 370 6494; add 6493 6495; mul 589
2000; mul 6482 6497; add 2000 6498; mul 6486 6497; mul 370 6500; add 6499 6501; neg 6502; mul 630 691; mul 612 6504;
mul 630 1390; mul 612 6506; neg 6507; mul 630 1971; mul 612 6509; mul 615 6504; mul 615 6506; neg 6512; mul 615
6509; mul 619 6504; mul 619 6506; neg 6516; mul 619 6509; mul 630 709; mul 630 1410; neg 6520; mul 630 1986; mul 679
4254; sub 6523 89; mul 4240 6524; mul 1374 4254; sub 679 6526; mul 4240 6527; mul 1383 4254; sub 6529 683; mul 4240
6530; mul 4243 6524; mul 4243 6527; mul 4243 6530; mul 4247 6524; mul 4247 6527; mul 4247 6530; mul 4251 6524; mul
4251 6527; mul 4251 6530; mul 6186 6195; mul 6195 6541; neg 6542; where 6194 6543; mul 6186 6204; mul 6204 6545; neg
6546; where 6203 6547; mul 6186 6213; mul 6213 6549; neg 6550; where 6212 6551; mul 6186 6222; mul 6222 6553; neg
6554; where 6221 6555; mul 89 4312; neg 6557; mul 679 4312; mul 683 4312; neg 6560; mul 89 4316; neg 6562; mul 679
4316; mul 683 4316; neg 6565; mul 90 1368; neg 6567; mul 90 1953; mul 90 2534; neg 6570; store by_k 114 1370; store
by_k 342 1955; store by_k 570 2536; store by_k 684 2668; store by_k 798 2800; store by_k 912 2668; store by_k 1026
2800; store by_k 1140 2668; store by_k 1254 2800; store by_k 115 2946; store by_k 343 2957; store by_k 571 2968;
store by_k 116 2984; store by_k 344 2994; store by_k 572 3004; store by_k 117 3139; store by_k 345 3247; store by_k
573 3355; store by_k 118 3521; store by_k 346 3649; store by_k 574 3777; store by_k 119 3854; store by_k 347 3928;
store by_k 575 4002; store by_k 120 4009; store by_k 348 4016; store by_k 576 4023; store by_k 121 4030; store by_k
349 4037; store by_k 577 4044; store by_k 122 4051; store by_k 350 4055; store by_k 578 4062; store by_k 123 4444;
store by_k 351 4650; store by_k 579 4857; store by_k 693 4898; store by_k 807 4939; store by_k 921 4898; store by_k
1035 4939; store by_k 1149 4898; store by_k 1263 4939; store by_k 124 4942; store by_k 352 4944; store by_k 580
4947; store by_k 125 4951; store by_k 353 4955; store by_k 581 4959; store by_k 126 4964; store by_k 354 4968; store
by_k 582 4973; store by_k 127 4979; store by_k 355 4985; store by_k 583 4991; store by_k 128 4998; store by_k 356
5004; store by_k 584 5011; store by_k 129 5018; store by_k 357 5023; store by_k 585 5030; store by_k 130 5034; store
by_k 358 5038; store by_k 586 5042; store by_k 131 5048; store by_k 359 5055; store by_k 587 5061; store by_k 132
5068; store by_k 360 5074; store by_k 588 5081; store by_k 133 5085; store by_k 361 5088; store by_k 589 5092; store
by_k 134 5094; store by_k 362 5097; store by_k 590 5099; store by_k 135 5103; store by_k 363 5107; store by_k 591
5111; store by_k 136 5117; store by_k 364 5123; store by_k 592 5129; store by_k 137 5132; store by_k 365 5135; store
by_k 593 5138; store by_k 138 5140; store by_k 366 5141; store by_k 594 5143; store by_k 139 5148; store by_k 367
5152; store by_k 595 5157; store by_k 140 5164; store by_k 368 5170; store by_k 596 5177; store by_k 141 5184; store
by_k 369 5190; store by_k 597 5197; store by_k 142 5203; store by_k 370 5210; store by_k 598 5216; store by_k 143
5223; store by_k 371 5230; store by_k 599 5237; store by_k 144 5244; store by_k 372 5250; store by_k 600 5257; store
by_k 145 5261; store by_k 373 5265; store by_k 601 5269; store by_k 146 5275; store by_k 374 5282; store by_k 602
5288; store by_k 147 5295; store by_k 375 5301; store by_k 603 5308; store by_k 148 5313; store by_k 376 5317; store
by_k 604 5322; store by_k 149 5324; store by_k 377 5326; store by_k 605 5328; store by_k 719 5330; store by_k 833
5332; store by_k 947 5330; store by_k 1061 5332; store by_k 1175 5330; store by_k 1289 5332; store by_k 150 5336;
store by_k 378 5340; store by_k 606 5344; store by_k 720 5348; store by_k 834 5352; store by_k 948 5348; store by_k
1062 5352; store by_k 1176 5348; store by_k 1290 5352; store by_k 151 5356; store by_k 379 5360; store by_k 607
5364; store by_k 721 5368; store by_k 835 5372; store by_k 949 5368; store by_k 1063 5372; store by_k 1177 5368;
store by_k 1291 5372; store by_k 152 5377; store by_k 380 5382; store by_k 608 5387; store by_k 722 5392; store by_k
836 5397; store by_k 950 5392; store by_k 1064 5397; store by_k 1178 5392; store by_k 1292 5397; store by_k 153
5403; store by_k 381 5409; store by_k 609 5415; store by_k 723 5421; store by_k 837 5427; store by_k 951 5421; store
by_k 1065 5427; store by_k 1179 5421; store by_k 1293 5427; store by_k 154 5432; store by_k 382 5437; store by_k 610
5442; store by_k 724 5447; store by_k 838 5452; store by_k 952 5447; store by_k 1066 5452; store by_k 1180 5447;
store by_k 1294 5452; store by_k 155 5456; store by_k 383 5460; store by_k 611 5464; store by_k 725 5468; store by_k
839 5472; store by_k 953 5468; store by_k 1067 5472; store by_k 1181 5468; store by_k 1295 5472; store by_k 156
5478; store by_k 384 5484; store by_k 612 5490; store by_k 726 5496; store by_k 840 5502; store by_k 954 5496; store
by_k 1068 5502; store by_k 1182 5496; store by_k 1296 5502; store by_k 157 5508; store by_k 385 5514; store by_k 613
5520; store by_k 727 5526; store by_k 841 5532; store by_k 955 5526; store by_k 1069 5532; store by_k 1183 5526;
store by_k 1297 5532; store by_k 158 5536; store by_k 386 5540; store by_k 614 5544; store by_k 728 5548; store by_k
842 5552; store by_k 956 5548; store by_k 1070 5552; store by_k 1184 5548; store by_k 1298 5552; store by_k 159
5554; store by_k 387 5556; store by_k 615 5558; store by_k 729 5560; store by_k 843 5562; store by_k 957 5560; store
by_k 1071 5562; store by_k 1185 5560; store by_k 1299 5562; store by_k 160 5566; store by_k 388 5570; store by_k 616
5574; store by_k 730 5578; store by_k 844 5582; store by_k 958 5578; store by_k 1072 5582; store by_k 1186 5578;
store by_k 1300 5582; store by_k 161 5587; store by_k 389 5592; store by_k 617 5597; store by_k 731 5602; store by_k
845 5607; store by_k 959 5602; store by_k 1073 5607; store by_k 1187 5602; store by_k 1301 5607; store by_k 162
5611; store by_k 390 5615; store by_k 618 5619; store by_k 732 5623; store by_k 846 5627; store by_k 960 5623; store
by_k 1074 5627; store by_k 1188 5623; store by_k 1302 5627; store by_k 163 5629; store by_k 391 5631; store by_k 619
5633; store by_k 733 5635; store by_k 847 5637; store by_k 961 5635; store by_k 1075 5637; store by_k 1189 5635;
store by_k 1303 5637; store by_k 164 5676; store by_k 392 5713; store by_k 620 5747; store by_k 165 5748; store by_k
393 5749; store by_k 621 5750; store by_k 166 4353; store by_k 394 4565; store by_k 622 4772; store by_k 167 5751;
store by_k 395 5752; store by_k 623 5753; store by_k 168 5672; store by_k 396 5709; store by_k 624 5743; store by_k
169 5777; store by_k 397 5799; store by_k 625 5822; store by_k 739 5826; store by_k 853 5830; store by_k 967 5826;
store by_k 1081 5830; store by_k 1195 5826; store by_k 1309 5830; store by_k 170 5844; store by_k 398 5858; store
by_k 626 5872; store by_k 740 5877; store by_k 854 5882; store by_k 968 5877; store by_k 1082 5882; store by_k 1196
5877; store by_k 1310 5882; store by_k 171 5887; store by_k 399 5892; store by_k 627 5897; store by_k 741 5898;
store by_k 855 5899; store by_k 969 5898; store by_k 1083 5899; store by_k 1197 5898; store by_k 1311 5899; store
by_k 172 5925; store by_k 400 5950; store by_k 628 5976; store by_k 742 5981; store by_k 856 5986; store by_k 970
5981; store by_k 1084 5986; store by_k 1198 5981; store by_k 1312 5986; store by_k 173 5997; store by_k 401 6008;
store by_k 629 6019; store by_k 743 6022; store by_k 857 6025; store by_k 971 6022; store by_k 1085 6025; store by_k
1199 6022; store by_k 1313 6025; store by_k 174 6030; store by_k 402 6035; store by_k 630 6040; store by_k 744 6041;
store by_k 858 6042; store by_k 972 6041; store by_k 1086 6042; store by_k 1200 6041; store by_k 1314 6042; store
by_k 175 6045; store by_k 403 6048; store by_k 631 6051; store by_k 176 6060; store by_k 404 6069; store by_k 632
6078; store by_k 177 89; store by_k 405 6079; store by_k 633 683; store by_k 748 6080; store by_k 862 6081; store
by_k 977 6082; store by_k 1091 6083; store by_k 1206 6084; store by_k 1320 6085; store by_k 181 6100; store by_k 409
6114; store by_k 637 6127; store by_k 751 6133; store by_k 865 6139; store by_k 979 6133; store by_k 1093 6139;
store by_k 1207 6133; store by_k 1321 6139; store by_k 182 6147; store by_k 410 6149; store by_k 638 6152; store
by_k 183 6154; store by_k 411 6155; store by_k 639 6157; store by_k 184 6160; store by_k 412 6162; store by_k 640
6165; store by_k 185 6172; store by_k 413 6176; store by_k 641 6179; store by_k 186 6180; store by_k 414 6182; store
by_k 642 6183; store by_k 1668 6197; store by_k 1782 6206; store by_k 1896 6215; store by_k 2010 6224; store by_k
187 6231; store by_k 415 6238; store by_k 643 6245; store by_k 757 6252; store by_k 985 6252; store by_k 1213 6252;
store by_k 188 6259; store by_k 416 6266; store by_k 644 6273; store by_k 758 6280; store by_k 986 6280; store by_k
1214 6280; store by_k 189 6281; store by_k 417 6282; store by_k 645 6283; store by_k 759 6284; store by_k 987 6284;
store by_k 1215 6284; store by_k 190 923; store by_k 418 1585; store by_k 646 2167; store by_k 760 2587; store by_k
988 2587; store by_k 1216 2587; store by_k 191 6296; store by_k 419 6303; store by_k 647 6311; store by_k 761 6317;
store by_k 989 6317; store by_k 1217 6317; store by_k 192 6318; store by_k 420 6320; store by_k 648 6321; store by_k
193 877; store by_k 421 6322; store by_k 649 2125; store by_k 194 6323; store by_k 422 6325; store by_k 650 6326;
store by_k 195 6329; store by_k 423 6331; store by_k 651 6334; store by_k 196 6343; store by_k 424 6349; store by_k
652 6356; store by_k 197 6358; store by_k 425 6361; store by_k 653 6363; store by_k 198 6364; store by_k 426 6366;
store by_k 654 6367; store by_k 199 6368; store by_k 427 6370; store by_k 655 6371; store by_k 200 6372; store by_k
428 6374; store by_k 656 6375; store by_k 201 6382; store by_k 429 6389; store by_k 657 6396; store by_k 885 6403;
store by_k 1113 6403; store by_k 1341 6403; store by_k 202 6410; store by_k 430 6417; store by_k 658 6424; store
by_k 886 6431; store by_k 1114 6431; store by_k 1342 6431; store by_k 203 4122; store by_k 431 4493; store by_k 659
4698; store by_k 887 4910; store by_k 1115 4910; store by_k 1343 4910; store by_k 204 784; store by_k 432 1478;
store by_k 660 2047; store by_k 888 2708; store by_k 1116 2708; store by_k 1344 2708; store by_k 205 6443; store
by_k 433 6450; store by_k 661 6458; store by_k 889 6464; store by_k 1117 6464; store by_k 1345 6464; store by_k 206
6465; store by_k 434 6467; store by_k 662 6468; store by_k 207 738; store by_k 435 6469; store by_k 663 2005; store
by_k 208 6470; store by_k 436 6472; store by_k 664 6473; store by_k 209 6476; store by_k 437 6478; store by_k 665
6481; store by_k 210 6490; store by_k 438 6496; store by_k 666 6503; store by_k 211 6505; store by_k 439 6508; store
by_k 667 6510; store by_k 212 6511; store by_k 440 6513; store by_k 668 6514; store by_k 213 6515; store by_k 441
6517; store by_k 669 6518; store by_k 214 6519; store by_k 442 6521; store by_k 670 6522; store by_k 215 6525; store
by_k 443 6528; store by_k 671 6531; store by_k 216 6532; store by_k 444 6533; store by_k 672 6534; store by_k 217
6535; store by_k 445 6536; store by_k 673 6537; store by_k 218 6538; store by_k 446 6539; store by_k 674 6540; store
by_k 1701 6544; store by_k 1816 6548; store by_k 1931 6552; store by_k 2046 6556; store by_k 223 6558; store by_k
451 6559; store by_k 679 6561; store by_k 224 6563; store by_k 452 6564; store by_k 680 6566; store by_k 1479 4312;
store by_k 1594 4316; store by_k 227 6568; store by_k 455 6569; store by_k 683 6571
    """,
)
