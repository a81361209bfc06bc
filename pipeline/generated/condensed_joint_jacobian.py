"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 79},
    {'p': 206},
    """
input k 78; input k 0; constant 1.0; div 2 1; mul 0 3; constant -2.0; input k 2; mul 5 6; input k 33; input k 1;
constant -6.000000000000002; constant -18.000000000000004; input k 6; mul 12 12; input k 4; mul 13 14; mul 11 15;
add 10 16; constant -0.09999999999999995; input k 3; mul 13 19; mul 18 20; add 17 21; input k 7; input k 8; constant
28.79999999999999; mul 12 14; mul 25 26; constant -22.62857142857143; mul 14 28; constant -0.057142857142856635; mul
19 30; add 29 31; constant 36.0; mul 26 33; constant -28.799999999999976; mul 14 35; constant 0.05714285714285722;
mul 19 37; add 36 38; constant -50.400000000000006; mul 14 40; constant -1.1428571428571423; mul 19 42; add 41 43;
constant 12.000000000000004; constant 36.000000000000014; mul 15 46; add 45 47; constant 1.2; mul 20 49; add 48 50;
constant -57.60000000000001; mul 26 52; constant 45.25714285714287; mul 14 54; constant 0.9142857142857138; mul 19
56; add 55 57; constant -72.00000000000001; mul 26 59; constant 57.599999999999916; mul 14 61; constant
-1.7142857142857166; mul 19 63; add 62 64; constant 230.40000000000006; mul 14 66; constant 2.057142857142858; mul
19 68; add 67 69; constant -388.80000000000024; mul 14 71; constant -7.714285714285722; mul 19 73; add 72 74;
constant 259.2000000000001; mul 14 76; constant 12.34285714285715; mul 19 78; add 77 79; constant
-0.9999999999999998; mul 12 81; mul 12 13; mul 14 83; mul 81 84; add 82 85; constant -0.033333333333333326; mul 20
87; constant -2.3999999999999995; mul 26 89; constant 0.4571428571428564; mul 14 91; constant -0.019047619047619094;
mul 19 93; add 92 94; constant 4.000000000000001; constant 12.0; mul 15 97; add 96 98; constant 0.13333333333333333;
mul 20 100; add 99 101; constant -14.399999999999991; mul 26 103; constant 13.714285714285717; mul 14 105; constant
0.11428571428571413; mul 19 107; add 106 108; constant -30.000000000000007; mul 26 110; mul 12 19; sub 111 112;
constant 21.59999999999998; mul 14 114; constant 0.6571428571428567; mul 19 116; add 115 117; constant
35.20000000000001; mul 14 119; constant 2.438095238095238; mul 19 121; add 120 122; constant 72.0; mul 26 124;
constant -57.59999999999995; mul 14 126; constant 0.11428571428571443; mul 19 128; add 127 129; constant
-151.20000000000002; mul 14 131; constant -3.428571428571427; mul 19 133; add 132 134; constant -36.00000000000001;
mul 26 136; constant 28.799999999999958; mul 14 138; constant -0.8571428571428583; mul 19 140; add 139 141; constant
-129.60000000000008; mul 14 143; constant -2.5714285714285743; mul 19 145; add 144 146; input k 19; constant 2.0;
input k 18; input k 17; input k 16; input k 27; input k 43; input k 38; input k 15; sub 156 2; input k 40; input k
39; input k 41; sub 160 1; constant 8.118473726939319e-05; input k 5; mul 162 163; constant -0.0004787100025195255;
mul 163 165; constant 0.0013605442176870743; mul 163 167; constant -0.003571428571428574; mul 163 169; constant
0.007142857142857142; mul 163 171; constant -0.0006802721088435403; mul 163 173; constant 0.0035714285714285787; mul
163 175; constant 0.014965986394557814; mul 163 177; constant -0.04285714285714284; mul 163 179; constant
0.06428571428571427; mul 163 181; constant -0.12857142857142845; mul 163 183; constant 0.2571428571428571; mul 163
185; input k 9; input k 10; input k 12; input k 11; input k 13; input k 14; input k 42; div 2 193; input k 44; input
k 45; input k 46; input k 47; input k 48; input k 49; input k 50; input k 51; constant 0.029931972789115628; mul 163
203; constant -0.08571428571428567; mul 163 205; constant 0.12857142857142853; mul 163 207; constant
-0.38571428571428534; mul 163 209; constant 1.0285714285714285; mul 163 211; constant 0.0027210884353741486; mul 163
213; constant -0.010714285714285721; mul 163 215; constant 0.028571428571428567; mul 163 217; constant
0.010714285714285735; mul 163 219; input k 57; input k 53; input k 52; input k 54; input k 55; sub 225 1; input k
56; div 2 227; input k 58; input k 59; input k 60; input k 61; input k 62; input k 63; input k 64; input k 65;
constant -6.0; constant 4.0; input k 29; input k 66; input k 67; input k 68; input k 69; input k 34; input k 35;
input k 36; mul 246 246; input k 74; input k 75; input k 24; input k 25; input k 21; mul 149 251; input k 26; input
k 23; input k 22; input k 20; input k 28; mul 153 258; input k 37; constant 0.8000000000000002; constant
2.400000000000001; mul 15 262; add 261 263; constant 0.01904761904761903; mul 20 265; add 264 266; constant
-1.3714285714285723; mul 26 268; constant 1.3714285714285714; mul 14 270; constant 0.007256235827664418; mul 19 272;
add 271 273; constant -4.799999999999999; mul 26 275; constant 1.3714285714285692; mul 14 277; constant
-0.05714285714285729; mul 19 279; add 278 280; constant -7.199999999999996; mul 26 282; constant 7.199999999999994;
mul 14 284; constant 0.2190476190476189; mul 19 286; add 285 287; constant -45.25714285714286; mul 14 289; constant
-0.11428571428571327; mul 19 291; add 290 292; constant -28.800000000000004; mul 26 294; constant
0.00032473894907757275; mul 163 296; constant -0.0014361300075585765; mul 163 298; constant -0.0013605442176870806;
mul 163 300; constant 0.8; mul 6 302; div 2 303; input k 30; input k 31; input k 32; input k 76; input k 77; input k
70; div 2 310; input k 71; div 2 312; input k 72; div 2 314; input k 73; div 2 316; mul 3 23; mul 22 318; mul 3 51;
mul 102 318; mul 3 22; mul 18 318; mul 3 49; mul 100 318; mul 3 18; mul 3 187; mul 3 188; mul 3 189; add 248 249;
mul 251 252; mul 250 252; mul 88 318; mul 87 318; mul 3 97; mul 237 318; add 335 336; mul 6 337; mul 3 237; mul 238
318; add 339 340; mul 6 341; mul 23 342; add 338 343; mul 24 342; mul 22 24; mul 24 102; mul 18 24; mul 24 100; mul
252 254; mul 24 88; mul 24 87; mul 24 237; mul 6 353; mul 24 238; mul 6 355; mul 23 356; add 354 357; mul 24 356;
mul 260 311; mul 260 313; mul 260 315; mul 260 317; neg 305; neg 306; neg 307; neg 308; neg 309; mul 240 260; mul
241 260; mul 242 260; mul 243 260; mul 3 4; mul 9 304; mul 142 374; mul 58 374; mul 295 374; mul 39 374; mul 293
374; mul 27 374; mul 288 374; mul 109 374; mul 283 374; mul 281 374; mul 276 374; mul 88 374; mul 12 149; mul 149
246; store p 0 4; store p 1 7; store p 2 8; store p 3 3; store p 4 9; store p 5 22; store p 6 23; store p 7 24;
store p 8 27; store p 9 32; store p 10 34; store p 11 39; store p 12 44; store p 13 51; store p 14 53; store p 15
58; store p 16 60; store p 17 65; store p 18 70; store p 19 75; store p 20 80; store p 21 86; store p 22 88; store p
23 90; store p 24 95; store p 25 102; store p 26 104; store p 27 109; store p 28 113; store p 29 118; store p 30
123; store p 31 125; store p 32 130; store p 33 135; store p 34 137; store p 35 142; store p 36 147; store p 37 148;
store p 38 150; store p 39 151; store p 40 152; store p 41 1; store p 42 187; store p 43 188; store p 44 189; store
p 45 174; store p 46 176; store p 47 204; store p 48 206; store p 49 208; store p 50 210; store p 51 212; store p 52
166; store p 53 214; store p 54 216; store p 55 218; store p 56 220; store p 57 180; store p 58 184; store p 59 153;
store p 60 161; store p 61 164; store p 62 168; store p 63 170; store p 64 172; store p 65 178; store p 66 182;
store p 67 186; store p 68 190; store p 69 191; store p 70 192; store p 71 157; store p 72 156; store p 73 159;
store p 74 155; store p 75 194; store p 76 158; store p 77 154; store p 78 195; store p 79 196; store p 80 197;
store p 81 198; store p 82 199; store p 83 200; store p 84 201; store p 85 202; store p 86 226; store p 87 222;
store p 88 223; store p 89 228; store p 90 224; store p 91 221; store p 92 229; store p 93 230; store p 94 231;
store p 95 232; store p 96 233; store p 97 234; store p 98 235; store p 99 236; store p 100 6; store p 101 239;
store p 102 240; store p 103 241; store p 104 242; store p 105 243; store p 106 244; store p 107 245; store p 108
247; store p 109 248; store p 110 249; store p 111 250; store p 112 251; store p 113 252; store p 114 253; store p
115 254; store p 116 255; store p 117 256; store p 118 257; store p 119 259; store p 120 260; store p 121 267; store
p 122 269; store p 123 274; store p 124 276; store p 125 281; store p 126 283; store p 127 288; store p 128 293;
store p 129 295; store p 130 297; store p 131 299; store p 132 301; store p 133 304; store p 134 305; store p 135
306; store p 136 307; store p 137 308; store p 138 309; store p 139 311; store p 140 313; store p 141 315; store p
142 317; store p 143 319; store p 144 318; store p 145 320; store p 146 321; store p 147 322; store p 148 323; store
p 149 324; store p 150 325; store p 151 326; store p 152 327; store p 153 328; store p 154 329; store p 155 330;
store p 156 331; store p 157 332; store p 158 333; store p 159 334; store p 160 344; store p 161 345; store p 162
346; store p 163 347; store p 164 348; store p 165 349; store p 166 350; store p 167 351; store p 168 352; store p
169 358; store p 170 359; store p 171 360; store p 172 361; store p 173 362; store p 174 363; store p 175 364; store
p 176 365; store p 177 366; store p 178 367; store p 179 368; store p 180 369; store p 181 370; store p 182 371;
store p 183 372; store p 184 373; store p 185 375; store p 186 376; store p 187 377; store p 188 378; store p 189
379; store p 190 380; store p 191 381; store p 192 382; store p 193 383; store p 194 384; store p 195 385; store p
196 386; store p 197 13; store p 198 12; store p 199 374; store p 200 83; store p 201 14; store p 202 387; store p
203 19; store p 204 258; store p 205 388
    """,
)

JACOBIAN = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 206},
    {'f': 17, 'a': 289, 'b': 34, 'by_c': 221},
    """
input x 1; input c 0; input c 2; input u 0; mul 2 3; add 1 4; input c 3; input u 1; mul 6 7; add 5 8; input x 2;
input p 0; input x 0; mul 11 12; sub 10 13; input c 9; constant 0.5; input c 10; mul 16 17; mul 14 18; sub 15 19;
input c 11; mul 3 21; add 20 22; input c 12; mul 7 24; add 23 25; mul 14 26; add 9 27; input c 4; input c 5; mul 14
30; sub 29 31; input c 6; mul 3 33; add 32 34; input c 7; mul 7 36; add 35 37; input c 8; input p 1; max 39 40;
input x 3; mul 0 11; sub 42 43; mul 41 44; sub 38 45; mul 11 46; sub 28 47; input p 2; input c 1; add 49 50;
constant 0.0; max 51 52; mul 0 53; sub 48 54; input p 3; input p 4; input p 5; input p 6; mul 12 56; mul 59 60;
input p 7; mul 10 62; add 61 63; mul 58 64; input p 8; input x 4; mul 64 67; mul 66 68; add 65 69; input p 9; mul 67
68; mul 71 72; add 70 73; input p 10; mul 64 64; mul 75 76; add 74 77; input p 11; mul 67 76; mul 79 80; add 78 81;
input p 12; mul 64 76; mul 83 84; add 82 85; input p 13; mul 60 87; add 86 88; input p 14; mul 60 67; mul 90 91; add
89 92; input p 15; mul 67 91; mul 94 95; add 93 96; input p 16; mul 60 64; mul 98 99; add 97 100; input p 17; mul 67
99; mul 102 103; add 101 104; input p 18; mul 64 99; mul 106 107; add 105 108; input p 19; mul 60 60; mul 64 111;
mul 110 112; add 109 113; input p 20; mul 60 111; mul 115 116; add 114 117; input p 21; input p 22; mul 67 120; add
119 121; input p 23; mul 67 67; mul 123 124; add 122 125; input p 24; mul 67 124; mul 127 128; add 126 129; input p
25; mul 64 131; add 130 132; input p 26; mul 68 134; add 133 135; input p 27; mul 72 137; add 136 138; input p 28;
mul 76 140; add 139 141; input p 29; mul 80 143; add 142 144; input p 30; mul 84 146; add 145 147; mul 58 60; add
148 149; mul 66 91; add 150 151; mul 71 95; add 152 153; input p 31; mul 99 155; add 154 156; input p 32; mul 103
158; add 157 159; input p 33; mul 107 161; add 160 162; input p 34; mul 111 164; add 163 165; input p 35; mul 67
111; mul 167 168; add 166 169; mul 106 112; add 170 171; input p 36; mul 116 173; add 172 174; mul 59 175; add 118
176; mul 57 177; abs 60; constant 0.35; lt 179 180; input p 37; constant 0.6; constant -0.6; max 184 10; min 183
185; mul 186 186; mul 186 187; mul 182 188; constant -0.35; max 190 60; min 180 191; constant 2.0; mul 192 193;
input p 38; mul 187 195; mul 194 196; add 189 197; mul 192 192; input p 39; mul 186 200; mul 199 201; add 198 202;
mul 192 201; mul 194 204; add 203 205; mul 193 199; input p 40; mul 207 208; mul 194 209; add 206 210; mul 57 211;
where 181 212; add 178 213; input p 41; input p 42; mul 60 216; input p 43; mul 10 218; add 217 219; input p 44; mul
67 221; add 220 222; constant -0.09999999999999995; mul 64 224; input p 45; mul 72 226; add 225 227; input p 46; mul
84 229; add 228 230; constant 1.2; mul 60 232; add 231 233; input p 47; mul 95 235; add 234 236; input p 48; mul 103
238; add 237 239; input p 49; mul 107 241; add 240 242; input p 50; mul 112 244; add 243 245; input p 51; mul 116
247; add 246 248; constant -0.033333333333333326; mul 67 250; input p 52; mul 128 252; add 251 253; constant
0.13333333333333333; mul 64 255; add 254 256; input p 53; mul 72 258; add 257 259; input p 54; mul 80 261; add 260
262; input p 55; mul 84 264; add 263 265; mul 60 224; add 266 267; mul 95 226; add 268 269; input p 56; mul 107 271;
add 270 272; input p 57; mul 168 274; add 273 275; mul 112 241; add 276 277; input p 58; mul 116 279; add 278 280;
mul 59 281; add 249 282; add 223 283; mul 215 284; input p 59; input p 60; constant 0.009523809523809514; mul 124
288; input p 61; mul 67 128; mul 290 291; add 289 292; mul 68 250; add 293 294; mul 67 72; mul 252 296; add 295 297;
constant 0.06666666666666667; mul 76 299; add 298 300; input p 62; mul 67 80; mul 302 303; add 301 304; input p 63;
mul 67 84; mul 306 307; add 305 308; input p 64; mul 64 84; mul 310 311; add 309 312; mul 99 224; add 313 314; mul
67 103; mul 226 316; add 315 317; mul 64 107; mul 229 319; add 318 320; mul 111 183; add 321 322; input p 65; mul 67
168; mul 324 325; add 323 326; mul 67 112; mul 274 328; add 327 329; input p 66; mul 64 112; mul 331 332; add 330
333; mul 64 116; mul 279 335; add 334 336; input p 67; mul 60 116; mul 338 339; add 337 340; mul 60 223; mul 60 218;
input p 68; mul 10 344; add 343 345; input p 69; mul 67 347; add 346 348; mul 10 349; add 342 350; mul 60 221; mul
10 347; add 352 353; input p 70; mul 67 355; add 354 356; mul 67 357; add 351 358; mul 16 359; add 341 360; mul 215
361; add 287 362; constant 1.0; input p 71; mul 10 365; mul 10 366; add 364 367; input p 72; mul 10 369; mul 10 370;
add 364 371; sqrt 372; sqrt 368; mul 373 374; div 364 375; mul 368 376; input p 73; mul 377 378; add 363 379; input
p 74; mul 10 374; mul 376 382; mul 381 383; sub 380 384; input p 75; mul 377 381; input p 76; sub 387 388; mul 378
383; add 389 390; sub 391 12; mul 392 392; mul 385 385; add 393 394; sqrt 395; mul 386 396; sqrt 397; div 364 398;
mul 399 399; mul 386 400; mul 385 401; input p 77; mul 193 397; mul 193 400; mul 400 405; sub 404 406; mul 403 407;
constant 0.3; constant -0.3; constant 1.4; sub 397 411; max 410 412; min 409 413; input p 78; input p 79; mul 414
416; add 415 417; mul 414 418; add 364 419; mul 408 420; input p 80; mul 3 422; input p 81; mul 412 424; add 364
425; mul 423 426; sub 421 427; mul 386 428; input p 82; input x 5; mul 430 431; input p 83; input x 7; mul 433 434;
add 432 435; input p 84; input x 9; mul 437 438; add 436 439; constant -0.5; mul 399 441; mul 399 442; mul 399 443;
mul 386 444; mul 440 445; add 429 446; input p 85; mul 445 448; mul 445 449; sub 379 384; mul 392 451; add 387 390;
mul 385 453; sub 452 454; mul 401 455; div 364 373; mul 376 457; mul 456 458; mul 42 459; mul 392 401; mul 0 461;
sub 460 462; mul 0 56; mul 285 464; mul 62 281; add 349 466; mul 215 467; mul 42 468; add 465 469; mul 402 470; add
463 471; mul 450 472; add 447 473; mul 402 474; input p 86; add 362 476; input p 87; mul 377 478; add 477 479; input
p 88; mul 383 481; add 480 482; input p 89; mul 383 478; mul 377 481; input p 90; sub 486 487; sub 485 488; sub 489
12; mul 490 490; mul 483 483; add 491 492; sqrt 493; mul 484 494; sqrt 495; div 364 496; mul 497 497; mul 484 498;
mul 483 499; input p 91; mul 193 495; mul 193 498; mul 498 503; sub 502 504; mul 501 505; sub 495 411; max 410 507;
min 409 508; input p 92; input p 93; mul 509 511; add 510 512; mul 509 513; add 364 514; mul 506 515; input p 94;
mul 7 517; input p 95; mul 507 519; add 364 520; mul 518 521; sub 516 522; mul 484 523; input p 96; input x 6; mul
525 526; input p 97; input x 8; mul 528 529; add 527 530; input p 98; input x 10; mul 532 533; add 531 534; mul 441
497; mul 497 536; mul 497 537; mul 484 538; mul 535 539; add 524 540; input p 99; mul 539 542; mul 539 543; add 479
482; mul 490 545; sub 486 485; mul 483 547; add 546 548; mul 499 549; mul 458 550; mul 42 551; mul 490 499; mul 0
553; sub 552 554; mul 470 500; add 555 556; mul 544 557; add 541 558; mul 500 559; add 475 560; sub 286 561; mul 285
562; sub 214 563; input p 100; constant 12.0; mul 464 566; constant -6.0; mul 59 464; mul 42 62; add 569 570; mul
568 571; add 567 572; mul 565 573; mul 464 568; constant 4.0; mul 571 576; add 575 577; mul 565 578; mul 59 579; add
574 580; add 564 581; mul 56 582; mul 461 474; mul 553 559; add 584 585; sub 583 586; sub 55 587; input p 101; input
p 102; input z 0; mul 590 591; input p 103; input z 1; mul 593 594; add 592 595; input p 104; input z 2; mul 597
598; add 596 599; input p 105; input z 3; mul 601 602; add 600 603; sub 589 604; input p 106; abs 0; mul 606 607;
mul 0 608; input p 107; mul 0 610; mul 0 0; input p 108; add 612 613; sqrt 614; div 364 615; mul 611 616; add 609
617; sub 605 618; add 588 619; input p 109; input x 11; sub 12 622; mul 621 623; input p 110; input x 12; sub 12
626; mul 625 627; add 624 628; sub 620 629; input p 111; mul 12 631; input p 112; mul 10 633; add 632 634; input p
113; mul 0 631; input p 114; mul 42 638; add 637 639; mul 0 640; input p 115; mul 42 642; mul 42 643; add 641 644;
mul 636 645; mul 635 646; sub 630 647; input p 116; mul 12 633; mul 10 642; add 650 651; mul 636 652; mul 652 653;
add 649 654; mul 648 655; input p 117; mul 635 636; mul 652 658; add 657 659; mul 62 175; mul 57 661; abs 10; lt 663
183; mul 186 193; mul 187 193; input p 118; mul 666 667; mul 665 668; mul 182 192; mul 187 670; add 669 671; mul 186
670; mul 665 673; add 672 674; mul 195 199; mul 665 676; add 675 677; mul 192 199; mul 200 679; add 678 680; mul 57
681; where 664 682; add 662 683; mul 468 562; sub 684 685; mul 62 579; add 686 687; mul 459 474; mul 551 559; add
689 690; add 688 691; sub 46 692; input p 119; mul 383 694; mul 458 695; add 693 696; input p 120; mul 604 698; sub
697 699; mul 646 652; sub 700 701; mul 660 702; sub 656 703; mul 635 635; add 364 705; mul 636 706; mul 655 707; mul
660 660; sub 708 709; div 364 710; mul 704 711; mul 702 707; mul 648 660; sub 713 714; mul 711 715; input p 121; mul
67 717; input p 122; mul 124 719; add 718 720; input p 123; mul 128 722; add 721 723; mul 64 120; add 724 725; input
p 124; mul 68 727; add 726 728; input p 125; mul 72 730; add 729 731; input p 126; mul 76 733; add 732 734; mul 80
137; add 735 736; input p 127; mul 84 738; add 737 739; mul 66 99; add 740 741; input p 128; mul 103 743; add 742
744; mul 79 107; add 745 746; input p 129; mul 111 748; add 747 749; mul 94 168; add 750 751; mul 112 167; add 752
753; mul 57 754; constant 0.01904761904761903; mul 67 756; input p 130; mul 128 758; add 757 759; mul 64 250; add
760 761; input p 131; mul 72 763; add 762 764; mul 80 258; add 765 766; mul 84 306; add 767 768; input p 132; mul
103 770; add 769 771; mul 168 235; add 772 773; mul 112 274; add 774 775; add 357 776; mul 215 777; mul 562 778; sub
755 779; input p 133; mul 780 781; neg 782; mul 445 472; input p 134; mul 431 785; sub 784 786; mul 539 557; mul 526
785; sub 788 789; input p 135; mul 434 791; sub 784 792; mul 529 791; sub 788 794; input p 136; mul 438 796; sub 784
797; mul 533 796; sub 788 799; input p 137; mul 623 801; input p 138; mul 627 803; le 364 591; mul 42 698; add 0
806; lt 52 807; and 805 808; constant -1.0; le 591 810; lt 807 52; and 811 812; or 809 813; not 814; input p 139;
mul 807 816; where 815 817; le 364 594; and 808 819; le 594 810; and 812 821; or 820 822; not 823; input p 140; mul
807 825; where 824 826; le 364 598; and 808 828; le 598 810; and 812 830; or 829 831; not 832; input p 141; mul 807
834; where 833 835; le 364 602; and 808 837; le 602 810; and 812 839; or 838 840; not 841; input p 142; mul 807 843;
where 842 844; mul 11 18; mul 14 846; mul 11 26; sub 847 848; mul 11 30; mul 11 850; sub 849 851; input p 143; input
p 144; mul 67 854; mul 66 855; add 853 856; mul 67 855; mul 71 858; add 857 859; mul 64 193; mul 854 861; mul 75
862; add 860 863; mul 67 862; mul 79 865; add 864 866; mul 64 862; mul 76 854; add 868 869; mul 83 870; add 867 871;
input p 145; add 872 873; mul 56 67; mul 90 875; add 874 876; mul 67 875; mul 94 878; add 877 879; mul 56 64; mul 60
854; add 881 882; mul 98 883; add 880 884; mul 67 883; mul 102 886; add 885 887; mul 64 883; mul 99 854; add 889
890; mul 106 891; add 888 892; mul 60 193; mul 56 894; mul 64 895; mul 111 854; add 896 897; mul 110 898; add 893
899; mul 60 895; mul 56 111; add 901 902; mul 115 903; add 900 904; input p 146; mul 134 855; add 906 907; mul 137
858; add 908 909; mul 140 862; add 910 911; mul 143 865; add 912 913; mul 146 870; add 914 915; input p 147; add 916
917; mul 66 875; add 918 919; mul 71 878; add 920 921; mul 155 883; add 922 923; mul 158 886; add 924 925; mul 161
891; add 926 927; mul 164 895; add 928 929; mul 67 895; mul 167 931; add 930 932; mul 106 898; add 933 934; mul 173
903; add 935 936; mul 59 937; add 905 938; mul 57 939; le 191 180; le 180 191; add 941 942; div 364 943; mul 941
944; le 190 60; le 60 190; add 946 947; div 364 948; mul 946 949; mul 56 950; mul 945 951; mul 193 952; mul 196 953;
mul 194 952; mul 201 955; add 954 956; mul 204 953; mul 201 952; mul 194 959; add 958 960; add 957 961; mul 209 953;
mul 193 955; mul 208 964; mul 194 965; add 963 966; add 962 967; mul 57 968; where 181 969; add 940 970; input p
148; mul 226 858; add 972 973; mul 229 870; add 974 975; input p 149; add 976 977; mul 235 878; add 978 979; mul 238
886; add 980 981; mul 241 891; add 982 983; mul 244 898; add 984 985; mul 247 903; add 986 987; input p 150; mul 258
858; add 989 990; mul 261 865; add 991 992; mul 264 870; add 993 994; input p 151; add 995 996; mul 226 878; add 997
998; mul 271 891; add 999 1000; mul 274 931; add 1001 1002; mul 241 898; add 1003 1004; mul 279 903; add 1005 1006;
mul 59 1007; add 988 1008; input p 152; add 1009 1010; mul 215 1011; mul 562 1012; mul 193 385; mul 250 855; mul 67
858; mul 252 1016; add 1015 1017; mul 299 862; add 1018 1019; mul 67 865; mul 302 1021; add 1020 1022; mul 67 870;
mul 306 1024; add 1023 1025; mul 64 870; mul 84 854; add 1027 1028; mul 310 1029; add 1026 1030; mul 224 883; add
1031 1032; mul 67 886; mul 226 1034; add 1033 1035; mul 64 891; mul 107 854; add 1037 1038; mul 229 1039; add 1036
1040; mul 183 895; add 1041 1042; mul 67 931; mul 324 1044; add 1043 1045; mul 67 898; mul 274 1047; add 1046 1048;
mul 64 898; mul 112 854; add 1050 1051; mul 331 1052; add 1049 1053; mul 64 903; mul 116 854; add 1055 1056; mul 279
1057; add 1054 1058; mul 60 903; mul 56 116; add 1060 1061; mul 338 1062; add 1059 1063; mul 60 1010; mul 56 223;
add 1065 1066; input p 153; mul 10 1068; add 1067 1069; input p 154; mul 67 1071; add 1070 1072; mul 16 1073; add
1064 1074; mul 215 1075; mul 1014 1076; mul 193 392; sub 1077 1078; mul 193 396; div 364 1080; mul 1079 1081; mul
386 1082; mul 193 1083; mul 193 399; mul 193 398; div 364 1086; mul 1083 1087; mul 400 1088; mul 1085 1089; neg
1090; mul 193 1091; mul 400 1092; mul 405 1090; sub 1093 1094; sub 1084 1095; mul 403 1096; mul 420 1097; le 413
409; le 409 413; add 1099 1100; div 364 1101; mul 1099 1102; le 410 412; le 412 410; add 1104 1105; div 364 1106;
mul 1104 1107; mul 1083 1108; mul 1103 1109; mul 416 1110; mul 414 1111; mul 418 1110; add 1112 1113; mul 408 1114;
add 1098 1115; mul 424 1083; mul 423 1117; sub 1116 1118; mul 386 1119; mul 443 1088; mul 399 1121; mul 444 1088;
add 1122 1123; mul 399 1124; mul 399 444; mul 1088 1126; add 1125 1127; mul 386 1128; mul 440 1129; sub 1120 1130;
mul 386 1090; mul 392 1132; add 401 1133; mul 0 1134; mul 453 1076; add 451 1136; mul 401 1137; mul 455 1132; add
1138 1139; mul 458 1140; mul 42 1141; sub 1135 1142; mul 401 1076; mul 385 1132; sub 1144 1145; mul 470 1146; mul
464 1012; mul 62 1007; add 1068 1149; mul 215 1150; mul 42 1151; add 1148 1152; mul 402 1153; add 1147 1154; add
1143 1155; mul 450 1156; mul 448 1129; mul 445 1158; mul 449 1129; add 1159 1160; mul 472 1161; sub 1157 1162; add
1131 1163; mul 402 1164; mul 474 1146; add 1165 1166; mul 193 483; mul 1076 1168; mul 193 490; sub 1169 1170; mul
193 494; div 364 1172; mul 1171 1173; mul 484 1174; mul 193 1175; mul 193 497; mul 193 496; div 364 1178; mul 1175
1179; mul 498 1180; mul 1177 1181; neg 1182; mul 193 1183; mul 498 1184; mul 503 1182; sub 1185 1186; sub 1176 1187;
mul 501 1188; mul 515 1189; le 508 409; le 409 508; add 1191 1192; div 364 1193; mul 1191 1194; le 410 507; le 507
410; add 1196 1197; div 364 1198; mul 1196 1199; mul 1175 1200; mul 1195 1201; mul 511 1202; mul 509 1203; mul 513
1202; add 1204 1205; mul 506 1206; add 1190 1207; mul 519 1175; mul 518 1209; sub 1208 1210; mul 484 1211; mul 537
1180; mul 497 1213; mul 538 1180; add 1214 1215; mul 497 1216; mul 497 538; mul 1180 1218; add 1217 1219; mul 484
1220; mul 535 1221; sub 1212 1222; mul 547 1076; sub 1224 545; mul 499 1225; mul 484 1182; mul 549 1227; sub 1226
1228; mul 458 1229; mul 42 1230; mul 490 1227; add 499 1232; mul 0 1233; add 1231 1234; mul 499 1076; mul 483 1227;
sub 1236 1237; mul 470 1238; mul 500 1153; add 1239 1240; add 1235 1241; mul 544 1242; mul 542 1221; mul 539 1244;
mul 543 1221; add 1245 1246; mul 557 1247; sub 1243 1248; add 1223 1249; mul 500 1250; mul 559 1238; add 1251 1252;
add 1167 1253; mul 285 1254; sub 1013 1255; sub 971 1256; mul 56 1257; mul 461 1164; mul 474 1134; sub 1259 1260;
mul 553 1250; mul 559 1233; sub 1262 1263; add 1261 1264; sub 1258 1265; sub 852 1266; input p 155; sub 1267 1268;
mul 631 646; sub 1269 1270; mul 655 1271; input p 156; mul 652 1273; mul 633 653; add 1274 1275; mul 648 1276; add
1272 1277; input p 157; mul 652 1279; mul 633 658; add 1280 1281; mul 702 1282; mul 62 937; mul 57 1284; mul 182
952; mul 187 1286; mul 186 1286; mul 665 1288; add 1287 1289; mul 195 955; mul 665 1291; add 1290 1292; mul 199 952;
mul 192 955; add 1294 1295; mul 200 1296; add 1293 1297; mul 57 1298; where 664 1299; add 1285 1300; mul 562 1151;
mul 468 1254; sub 1302 1303; sub 1301 1304; mul 459 1164; mul 474 1141; sub 1306 1307; mul 551 1250; mul 559 1230;
add 1309 1310; add 1308 1311; add 1305 1312; sub 850 1313; mul 633 646; sub 1314 1315; mul 660 1316; add 1283 1317;
sub 1278 1318; mul 711 1319; mul 711 712; mul 193 635; mul 631 1322; mul 636 1323; mul 655 1324; mul 707 1276; add
1325 1326; mul 193 660; mul 1282 1328; sub 1327 1329; mul 1321 1330; sub 1320 1331; mul 655 711; input c_q 0; mul
1333 1334; le 52 51; le 51 52; add 1336 1337; div 364 1338; mul 1336 1339; mul 0 1333; mul 1340 1341; input c_q 1;
mul 1342 1343; sub 1335 1344; mul 3 1333; input c_q 2; mul 1346 1347; add 1345 1348; mul 7 1333; input c_q 3; mul
1350 1351; add 1349 1352; mul 660 711; mul 11 1333; add 1354 1355; input c_q 4; mul 1356 1357; sub 1353 1358; mul 14
1356; input c_q 5; mul 1360 1361; add 1359 1362; mul 3 1356; input c_q 6; mul 1364 1365; sub 1363 1366; mul 7 1356;
input c_q 7; mul 1368 1369; sub 1367 1370; le 40 39; le 39 40; add 1372 1373; div 364 1374; mul 1372 1375; mul 44
1356; mul 1376 1377; input c_q 8; mul 1378 1379; add 1371 1380; mul 14 1333; input c_q 9; mul 1382 1383; add 1381
1384; mul 14 1382; mul 16 1386; input c_q 10; mul 1387 1388; sub 1385 1389; mul 3 1382; input c_q 11; mul 1391 1392;
add 1390 1393; mul 7 1382; input c_q 12; mul 1395 1396; add 1394 1397; add 1332 1398; mul 707 1316; mul 702 1324;
add 1400 1401; mul 648 1282; mul 660 1271; add 1403 1404; sub 1402 1405; mul 711 1406; mul 711 716; mul 1330 1408;
sub 1407 1409; mul 0 1354; mul 1340 1411; mul 1343 1412; mul 1334 1354; sub 1413 1414; mul 3 1354; mul 1347 1416;
sub 1415 1417; mul 7 1354; mul 1351 1419; sub 1418 1420; mul 707 711; mul 11 1354; add 1422 1423; mul 1357 1424; add
1421 1425; mul 14 1424; mul 1361 1427; sub 1426 1428; mul 3 1424; mul 1365 1430; add 1429 1431; mul 7 1424; mul 1369
1433; add 1432 1434; mul 44 1424; mul 1376 1436; mul 1379 1437; sub 1435 1438; mul 14 1354; mul 1383 1440; sub 1439
1441; mul 14 1440; mul 16 1443; mul 1388 1444; add 1442 1445; mul 3 1440; mul 1392 1447; sub 1446 1448; mul 7 1440;
mul 1396 1450; sub 1449 1451; add 1410 1452; input p 158; mul 727 855; add 1454 1455; mul 730 858; add 1456 1457;
mul 733 862; add 1458 1459; mul 137 865; add 1460 1461; mul 738 870; add 1462 1463; mul 66 883; add 1464 1465; mul
743 886; add 1466 1467; mul 79 891; add 1468 1469; mul 748 895; add 1470 1471; mul 94 931; add 1472 1473; mul 167
898; add 1474 1475; mul 57 1476; input p 159; mul 763 858; add 1478 1479; mul 258 865; add 1480 1481; mul 306 870;
add 1482 1483; mul 770 886; add 1484 1485; mul 235 931; add 1486 1487; mul 274 898; add 1488 1489; add 1071 1490;
mul 215 1491; mul 562 1492; mul 778 1254; sub 1493 1494; sub 1477 1495; mul 781 1496; neg 1497; mul 445 1156; mul
472 1129; sub 1499 1500; mul 539 1242; mul 557 1221; sub 1502 1503; mul 11 41; mul 11 1505; add 53 1506; mul 284
402; sub 1508 461; mul 450 1509; mul 402 1510; mul 284 500; sub 1512 553; mul 544 1513; mul 500 1514; add 1511 1515;
mul 285 1516; input p 160; add 1517 1518; mul 56 1519; mul 461 1510; mul 553 1514; add 1521 1522; sub 1520 1523; add
1507 1524; sign 0; mul 606 1526; mul 0 1527; add 608 1528; mul 610 616; mul 616 617; mul 0 616; mul 1531 1532; sub
1530 1533; add 1529 1534; add 1525 1535; add 637 640; mul 636 1537; mul 635 1538; add 1536 1539; mul 655 1540; mul
468 1516; input p 161; add 1542 1543; mul 459 1510; mul 551 1514; add 1545 1546; add 1544 1547; sub 1505 1548; mul
652 1538; sub 1549 1550; mul 660 1551; add 1541 1552; mul 711 1553; neg 1554; mul 707 1551; mul 660 1540; add 1556
1557; mul 711 1558; mul 778 1516; mul 781 1560; neg 1561; mul 445 1509; mul 539 1513; where 815 816; where 824 825;
where 833 834; where 842 843; sub 26 19; add 850 1569; input p 162; mul 62 67; mul 66 1572; add 1571 1573; mul 67
1572; mul 71 1575; add 1574 1576; mul 62 861; mul 75 1578; add 1577 1579; mul 67 1578; mul 79 1581; add 1580 1582;
mul 64 1578; mul 62 76; add 1584 1585; mul 83 1586; add 1583 1587; mul 60 62; mul 98 1589; add 1588 1590; mul 67
1589; mul 102 1592; add 1591 1593; mul 64 1589; mul 62 99; add 1595 1596; mul 106 1597; add 1594 1598; mul 62 111;
mul 110 1600; add 1599 1601; input p 163; mul 134 1572; add 1603 1604; mul 137 1575; add 1605 1606; mul 140 1578;
add 1607 1608; mul 143 1581; add 1609 1610; mul 146 1586; add 1611 1612; mul 155 1589; add 1613 1614; mul 158 1592;
add 1615 1616; mul 161 1597; add 1617 1618; mul 106 1600; add 1619 1620; mul 59 1621; add 1602 1622; mul 57 1623; le
185 183; le 183 185; add 1625 1626; div 364 1627; mul 1625 1628; le 184 10; le 10 184; add 1630 1631; div 364 1632;
mul 1630 1633; mul 1629 1634; mul 187 1635; mul 665 1635; mul 186 1637; add 1636 1638; mul 182 1639; mul 195 1637;
mul 194 1641; add 1640 1642; mul 200 1635; mul 199 1644; add 1643 1645; mul 192 1644; mul 194 1647; add 1646 1648;
mul 57 1649; where 181 1650; add 1624 1651; input p 164; mul 226 1575; add 1653 1654; mul 229 1586; add 1655 1656;
mul 238 1592; add 1657 1658; mul 241 1597; add 1659 1660; mul 244 1600; add 1661 1662; input p 165; mul 258 1575;
add 1664 1665; mul 261 1581; add 1666 1667; mul 264 1586; add 1668 1669; mul 271 1597; add 1670 1671; mul 241 1600;
add 1672 1673; mul 59 1674; add 1663 1675; add 218 1676; mul 215 1677; mul 562 1678; mul 193 366; mul 376 1680; mul
376 377; mul 370 457; mul 374 1683; div 364 374; mul 366 1685; mul 373 1686; add 1684 1687; mul 1682 1688; sub 1681
1689; mul 381 1690; mul 10 1686; add 374 1692; mul 376 1693; mul 376 383; mul 1688 1695; sub 1694 1696; mul 378
1697; add 1691 1698; mul 1078 1699; mul 250 1572; mul 67 1575; mul 252 1702; add 1701 1703; mul 299 1578; add 1704
1705; mul 67 1581; mul 302 1707; add 1706 1708; mul 67 1586; mul 306 1710; add 1709 1711; mul 64 1586; mul 62 84;
add 1713 1714; mul 310 1715; add 1712 1716; mul 224 1589; add 1717 1718; mul 67 1592; mul 226 1720; add 1719 1721;
mul 64 1597; mul 62 107; add 1723 1724; mul 229 1725; add 1722 1726; mul 67 1600; mul 274 1728; add 1727 1729; mul
64 1600; mul 62 112; add 1731 1732; mul 331 1733; add 1730 1734; mul 62 116; mul 279 1736; add 1735 1737; add 345
349; add 343 1739; add 348 1740; mul 16 1741; add 1738 1742; mul 215 1743; mul 378 1690; add 1744 1745; mul 381
1697; sub 1746 1747; mul 1014 1748; add 1700 1749; mul 1081 1750; mul 386 1751; mul 193 1752; mul 1087 1752; mul 400
1754; mul 1085 1755; neg 1756; mul 193 1757; mul 400 1758; mul 405 1756; sub 1759 1760; sub 1753 1761; mul 403 1762;
mul 420 1763; mul 1108 1752; mul 1103 1765; mul 416 1766; mul 414 1767; mul 418 1766; add 1768 1769; mul 408 1770;
add 1764 1771; mul 424 1752; mul 423 1773; sub 1772 1774; mul 386 1775; mul 443 1754; mul 399 1777; mul 444 1754;
add 1778 1779; mul 399 1780; mul 1126 1754; add 1781 1782; mul 386 1783; mul 440 1784; sub 1776 1785; mul 451 1699;
sub 1745 1747; mul 392 1788; add 1787 1789; mul 453 1748; mul 385 1699; add 1791 1792; sub 1790 1793; mul 401 1794;
mul 386 1756; mul 455 1796; sub 1795 1797; mul 458 1798; mul 457 457; mul 1683 1800; mul 376 1801; mul 376 458; mul
1688 1803; add 1802 1804; mul 456 1805; sub 1799 1806; mul 42 1807; mul 401 1699; mul 392 1796; sub 1809 1810; mul 0
1811; sub 1808 1812; mul 401 1748; mul 385 1796; sub 1814 1815; mul 470 1816; mul 464 1678; mul 62 1674; add 344
1819; mul 215 1820; mul 42 1821; add 1818 1822; mul 402 1823; add 1817 1824; add 1813 1825; mul 450 1826; mul 448
1784; mul 445 1828; mul 449 1784; add 1829 1830; mul 472 1831; sub 1827 1832; add 1786 1833; mul 402 1834; mul 474
1816; add 1835 1836; mul 478 1697; mul 481 1690; sub 1838 1839; mul 1170 1840; mul 478 1690; add 1744 1842; mul 481
1697; add 1843 1844; mul 1168 1845; add 1841 1846; mul 1173 1847; mul 484 1848; mul 193 1849; mul 1179 1849; mul 498
1851; mul 1177 1852; neg 1853; mul 193 1854; mul 498 1855; mul 503 1853; sub 1856 1857; sub 1850 1858; mul 501 1859;
mul 515 1860; mul 1200 1849; mul 1195 1862; mul 511 1863; mul 509 1864; mul 513 1863; add 1865 1866; mul 506 1867;
add 1861 1868; mul 519 1849; mul 518 1870; sub 1869 1871; mul 484 1872; mul 537 1851; mul 497 1874; mul 538 1851;
add 1875 1876; mul 497 1877; mul 1218 1851; add 1878 1879; mul 484 1880; mul 535 1881; sub 1873 1882; mul 545 1840;
add 1842 1844; mul 490 1885; add 1884 1886; mul 547 1845; sub 1839 1838; mul 483 1889; add 1888 1890; add 1887 1891;
mul 499 1892; mul 484 1853; mul 549 1894; sub 1893 1895; mul 458 1896; mul 550 1805; sub 1897 1898; mul 42 1899; mul
499 1840; mul 490 1894; sub 1901 1902; mul 0 1903; sub 1900 1904; mul 499 1845; mul 483 1894; sub 1906 1907; mul 470
1908; mul 500 1823; add 1909 1910; add 1905 1911; mul 544 1912; mul 542 1881; mul 539 1914; mul 543 1881; add 1915
1916; mul 557 1917; sub 1913 1918; add 1883 1919; mul 500 1920; mul 559 1908; add 1921 1922; add 1837 1923; mul 285
1924; sub 1679 1925; sub 1652 1926; mul 56 1927; mul 461 1834; mul 474 1811; add 1929 1930; mul 553 1920; mul 559
1903; add 1932 1933; add 1931 1934; sub 1928 1935; sub 1570 1936; sub 1937 1315; mul 655 1938; input p 166; mul 652
1940; mul 642 653; add 1941 1942; mul 648 1943; add 1939 1944; mul 642 658; add 1274 1946; mul 702 1947; mul 694
1697; mul 458 1949; mul 695 1805; sub 1950 1951; mul 62 1621; mul 57 1953; mul 193 1635; mul 668 1955; mul 193 1637;
mul 667 1957; mul 665 1958; add 1956 1959; mul 670 1637; add 1960 1961; mul 673 1955; mul 670 1635; mul 665 1964;
add 1963 1965; add 1962 1966; mul 676 1955; add 1967 1968; mul 57 1969; where 664 1970; add 1954 1971; mul 562 1821;
mul 468 1924; sub 1973 1974; sub 1972 1975; mul 459 1834; mul 474 1807; add 1977 1978; mul 551 1920; mul 559 1899;
add 1980 1981; add 1979 1982; add 1976 1983; add 30 1984; sub 1952 1985; mul 642 646; sub 1986 1987; mul 660 1988;
add 1948 1989; sub 1945 1990; mul 711 1991; mul 633 1322; mul 636 1993; mul 655 1994; mul 707 1943; add 1995 1996;
mul 1328 1947; sub 1997 1998; mul 1321 1999; sub 1992 2000; mul 707 1988; mul 702 1994; add 2002 2003; mul 648 1947;
mul 660 1938; add 2005 2006; sub 2004 2007; mul 711 2008; mul 1408 1999; sub 2009 2010; input p 167; mul 727 1572;
add 2012 2013; mul 730 1575; add 2014 2015; mul 733 1578; add 2016 2017; mul 137 1581; add 2018 2019; mul 738 1586;
add 2020 2021; mul 66 1589; add 2022 2023; mul 743 1592; add 2024 2025; mul 79 1597; add 2026 2027; mul 167 1600;
add 2028 2029; mul 57 2030; input p 168; mul 763 1575; add 2032 2033; mul 258 1581; add 2034 2035; mul 306 1586; add
2036 2037; mul 770 1592; add 2038 2039; mul 274 1600; add 2040 2041; add 347 2042; mul 215 2043; mul 562 2044; mul
778 1924; sub 2045 2046; sub 2031 2047; mul 781 2048; neg 2049; mul 445 1826; mul 472 1784; sub 2051 2052; mul 539
1912; mul 557 1881; sub 2054 2055; mul 402 468; add 459 2057; mul 450 2058; mul 402 2059; mul 468 500; add 551 2061;
mul 544 2062; mul 500 2063; add 2060 2064; mul 285 2065; input p 169; add 2066 2067; mul 56 2068; mul 461 2059; mul
553 2063; add 2070 2071; sub 2069 2072; sub 1505 2073; mul 0 638; mul 193 643; add 2075 2076; mul 636 2077; mul 635
2078; sub 2074 2079; mul 655 2080; mul 468 2065; input p 170; add 2082 2083; mul 459 2059; mul 551 2063; add 2085
2086; add 2084 2087; add 41 2088; mul 652 2078; add 2089 2090; mul 660 2091; add 2081 2092; mul 711 2093; mul 707
2091; mul 660 2080; add 2095 2096; mul 711 2097; neg 2098; mul 778 2065; mul 781 2100; neg 2101; mul 445 2058; mul
539 2062; input p 171; where 815 2105; input p 172; where 824 2107; input p 173; where 833 2109; input p 174; where
842 2111; mul 67 193; mul 123 2113; add 120 2114; mul 67 2113; add 124 2116; mul 127 2117; add 2115 2118; mul 64
134; add 2119 2120; mul 68 193; mul 137 2122; add 2121 2123; mul 76 143; add 2124 2125; mul 60 66; add 2126 2127;
mul 91 193; mul 71 2129; add 2128 2130; mul 99 158; add 2131 2132; mul 111 167; add 2133 2134; mul 62 2135; mul 57
2136; mul 252 2117; add 250 2138; mul 258 2122; add 2139 2140; mul 76 261; add 2141 2142; mul 226 2129; add 2143
2144; mul 111 274; add 2145 2146; mul 62 2147; add 347 2148; mul 215 2149; mul 562 2150; mul 67 2117; add 128 2152;
mul 290 2153; add 757 2154; add 761 2155; mul 67 2122; add 72 2157; mul 252 2158; add 2156 2159; mul 80 193; mul 302
2161; add 2160 2162; add 768 2163; mul 103 193; mul 226 2165; add 2164 2166; mul 168 193; mul 324 2168; add 2167
2169; add 775 2170; add 356 357; add 354 2172; mul 16 2173; add 2171 2174; mul 215 2175; mul 1014 2176; mul 1081
2177; mul 386 2178; mul 193 2179; mul 1087 2179; mul 400 2181; mul 1085 2182; neg 2183; mul 193 2184; mul 400 2185;
mul 405 2183; sub 2186 2187; sub 2180 2188; mul 403 2189; mul 420 2190; mul 1108 2179; mul 1103 2192; mul 416 2193;
mul 414 2194; mul 418 2193; add 2195 2196; mul 408 2197; add 2191 2198; mul 424 2179; mul 423 2200; sub 2199 2201;
mul 386 2202; mul 443 2181; mul 399 2204; mul 444 2181; add 2205 2206; mul 399 2207; mul 1126 2181; add 2208 2209;
mul 386 2210; mul 440 2211; sub 2203 2212; mul 386 2183; mul 392 2214; mul 0 2215; mul 453 2176; mul 401 2217; mul
455 2214; add 2218 2219; mul 458 2220; mul 42 2221; sub 2216 2222; mul 401 2176; mul 385 2214; sub 2224 2225; mul
470 2226; mul 226 2122; mul 235 2129; add 2228 2229; mul 99 238; add 2230 2231; mul 59 2147; add 2232 2233; add 221
2234; mul 215 2235; mul 464 2236; mul 42 2150; add 2237 2238; mul 402 2239; add 2227 2240; add 2223 2241; mul 450
2242; mul 448 2211; mul 445 2244; mul 449 2211; add 2245 2246; mul 472 2247; sub 2243 2248; add 2213 2249; mul 402
2250; mul 474 2226; add 2251 2252; mul 1168 2176; mul 1173 2254; mul 484 2255; mul 193 2256; mul 1179 2256; mul 498
2258; mul 1177 2259; neg 2260; mul 193 2261; mul 498 2262; mul 503 2260; sub 2263 2264; sub 2257 2265; mul 501 2266;
mul 515 2267; mul 1200 2256; mul 1195 2269; mul 511 2270; mul 509 2271; mul 513 2270; add 2272 2273; mul 506 2274;
add 2268 2275; mul 519 2256; mul 518 2277; sub 2276 2278; mul 484 2279; mul 537 2258; mul 497 2281; mul 538 2258;
add 2282 2283; mul 497 2284; mul 1218 2258; add 2285 2286; mul 484 2287; mul 535 2288; sub 2280 2289; mul 547 2176;
mul 499 2291; mul 484 2260; mul 549 2293; sub 2292 2294; mul 458 2295; mul 42 2296; mul 490 2293; mul 0 2298; add
2297 2299; mul 499 2176; mul 483 2293; sub 2301 2302; mul 470 2303; mul 500 2239; add 2304 2305; add 2300 2306; mul
544 2307; mul 542 2288; mul 539 2309; mul 543 2288; add 2310 2311; mul 557 2312; sub 2308 2313; add 2290 2314; mul
500 2315; mul 559 2303; add 2316 2317; add 2253 2318; mul 468 2319; sub 2151 2320; sub 2137 2321; mul 459 2250; mul
474 2221; sub 2323 2324; mul 551 2315; mul 559 2296; add 2326 2327; add 2325 2328; add 2322 2329; mul 660 2330; mul
64 66; mul 71 2122; add 2332 2333; mul 76 79; add 2334 2335; mul 60 90; add 2336 2337; mul 94 2129; add 2338 2339;
mul 99 102; add 2340 2341; mul 59 2135; add 2342 2343; mul 57 2344; mul 562 2236; mul 285 2319; sub 2346 2347; sub
2345 2348; mul 56 2349; mul 461 2250; mul 474 2215; sub 2351 2352; mul 553 2315; mul 559 2298; sub 2354 2355; add
2353 2356; sub 2350 2357; mul 655 2358; sub 2331 2359; mul 711 2360; mul 660 2358; mul 707 2330; sub 2362 2363; mul
711 2364; mul 719 2113; add 717 2366; mul 722 2117; add 2367 2368; mul 64 727; add 2369 2370; mul 730 2122; add 2371
2372; mul 76 137; add 2373 2374; mul 99 743; add 2375 2376; mul 94 111; add 2377 2378; mul 57 2379; mul 758 2117;
add 756 2381; mul 763 2122; add 2382 2383; mul 76 258; add 2384 2385; mul 99 770; add 2386 2387; mul 111 235; add
2388 2389; add 355 2390; mul 215 2391; mul 562 2392; mul 778 2319; sub 2393 2394; sub 2380 2395; mul 781 2396; neg
2397; mul 445 2242; mul 472 2211; sub 2399 2400; mul 539 2307; mul 557 2288; sub 2402 2403; mul 430 445; mul 402
2405; mul 468 2406; mul 459 2405; add 2407 2408; mul 660 2409; mul 285 2406; mul 56 2411; mul 461 2405; sub 2412
2413; mul 655 2414; sub 2410 2415; mul 711 2416; mul 660 2414; mul 707 2409; sub 2418 2419; mul 711 2420; mul 778
2406; mul 781 2422; neg 2423; input p 175; mul 525 539; mul 500 2426; mul 468 2427; mul 551 2426; add 2428 2429; mul
660 2430; mul 285 2427; mul 56 2432; mul 553 2426; sub 2433 2434; mul 655 2435; sub 2431 2436; mul 711 2437; mul 660
2435; mul 707 2430; sub 2439 2440; mul 711 2441; mul 778 2427; mul 781 2443; neg 2444; mul 433 445; mul 402 2446;
mul 468 2447; mul 459 2446; add 2448 2449; mul 660 2450; mul 285 2447; mul 56 2452; mul 461 2446; sub 2453 2454; mul
655 2455; sub 2451 2456; mul 711 2457; mul 660 2455; mul 707 2450; sub 2459 2460; mul 711 2461; mul 778 2447; mul
781 2463; neg 2464; input p 176; mul 528 539; mul 500 2467; mul 468 2468; mul 551 2467; add 2469 2470; mul 660 2471;
mul 285 2468; mul 56 2473; mul 553 2467; sub 2474 2475; mul 655 2476; sub 2472 2477; mul 711 2478; mul 660 2476; mul
707 2471; sub 2480 2481; mul 711 2482; mul 778 2468; mul 781 2484; neg 2485; mul 437 445; mul 402 2487; mul 468
2488; mul 459 2487; add 2489 2490; mul 660 2491; mul 285 2488; mul 56 2493; mul 461 2487; sub 2494 2495; mul 655
2496; sub 2492 2497; mul 711 2498; mul 660 2496; mul 707 2491; sub 2500 2501; mul 711 2502; mul 778 2488; mul 781
2504; neg 2505; input p 177; mul 532 539; mul 500 2508; mul 468 2509; mul 551 2508; add 2510 2511; mul 660 2512; mul
285 2509; mul 56 2514; mul 553 2508; sub 2515 2516; mul 655 2517; sub 2513 2518; mul 711 2519; mul 660 2517; mul 707
2512; sub 2521 2522; mul 711 2523; mul 778 2509; mul 781 2525; neg 2526; mul 621 655; mul 711 2528; mul 621 660; mul
711 2530; neg 2531; input p 178; mul 625 655; mul 711 2534; mul 625 660; mul 711 2536; neg 2537; input p 179; input
p 180; mul 660 2540; mul 590 655; sub 2541 2542; mul 711 2543; mul 590 660; mul 707 2540; sub 2545 2546; mul 711
2547; input p 181; mul 660 2549; mul 593 655; sub 2550 2551; mul 711 2552; mul 593 660; mul 707 2549; sub 2554 2555;
mul 711 2556; input p 182; mul 660 2558; mul 597 655; sub 2559 2560; mul 711 2561; mul 597 660; mul 707 2558; sub
2563 2564; mul 711 2565; input p 183; mul 660 2567; mul 601 655; sub 2568 2569; mul 711 2570; mul 601 660; mul 707
2567; sub 2572 2573; mul 711 2574; mul 14 21; add 2 2576; mul 11 33; sub 2577 2578; mul 422 426; mul 386 2580; mul
461 2581; mul 402 2581; mul 285 2583; mul 56 2584; sub 2582 2585; sub 2579 2586; mul 655 2587; mul 468 2583; mul 459
2581; add 2589 2590; add 33 2591; mul 660 2592; sub 2588 2593; mul 711 2594; mul 707 2592; mul 660 2587; sub 2596
2597; mul 711 2598; mul 778 2583; mul 781 2600; mul 14 24; add 6 2602; mul 11 36; sub 2603 2604; mul 517 521; mul
484 2606; mul 553 2607; mul 500 2607; mul 285 2609; mul 56 2610; sub 2608 2611; sub 2605 2612; mul 655 2613; mul 468
2609; mul 551 2607; add 2615 2616; add 36 2617; mul 660 2618; sub 2614 2619; mul 711 2620; mul 707 2618; mul 660
2613; sub 2622 2623; mul 711 2624; mul 778 2609; mul 781 2626; neg 1354; neg 1342; neg 1416; neg 1419; neg 1356; neg
1427; neg 1364; neg 1368; neg 1437; neg 1440; neg 1387; neg 1447; neg 1450; store f 0 0; store f 1 712; store f 2
42; store f 3 716; store f 4 783; store f 5 787; store f 6 790; store f 7 793; store f 8 795; store f 9 798; store f
10 800; store f 11 802; store f 12 804; store f 13 818; store f 14 827; store f 15 836; store f 16 845; store a 17
1399; store a 51 1453; store a 68 1498; store a 85 1501; store a 102 1504; store a 119 1501; store a 136 1504; store
a 153 1501; store a 170 1504; store a 187 801; store a 204 803; store a 1 364; store a 18 1555; store a 52 1559;
store a 69 1562; store a 86 1563; store a 103 1564; store a 120 1563; store a 137 1564; store a 154 1563; store a
171 1564; store a 222 1565; store a 239 1566; store a 256 1567; store a 273 1568; store a 19 2001; store a 53 2011;
store a 70 2050; store a 87 2053; store a 104 2056; store a 121 2053; store a 138 2056; store a 155 2053; store a
172 2056; store a 20 2094; store a 37 364; store a 54 2099; store a 71 2102; store a 88 2103; store a 105 2104;
store a 122 2103; store a 139 2104; store a 156 2103; store a 173 2104; store a 224 2106; store a 241 2108; store a
258 2110; store a 275 2112; store a 21 2361; store a 55 2365; store a 72 2398; store a 89 2401; store a 106 2404;
store a 123 2401; store a 140 2404; store a 157 2401; store a 174 2404; store a 22 2417; store a 56 2421; store a 73
2424; store a 90 2425; store a 23 2438; store a 57 2442; store a 74 2445; store a 108 2425; store a 24 2458; store a
58 2462; store a 75 2465; store a 126 2466; store a 25 2479; store a 59 2483; store a 76 2486; store a 144 2466;
store a 26 2499; store a 60 2503; store a 77 2506; store a 162 2507; store a 27 2520; store a 61 2524; store a 78
2527; store a 180 2507; store a 28 2529; store a 62 2532; store a 198 2533; store a 29 2535; store a 63 2538; store
a 216 2539; store a 30 2544; store a 64 2548; store a 31 2553; store a 65 2557; store a 32 2562; store a 66 2566;
store a 33 2571; store a 67 2575; store b 2 2595; store b 6 2599; store b 8 2601; store b 3 2621; store b 7 2625;
store b 9 2627; store by_c 13 1333; store by_c 39 2628; store by_c 14 2629; store by_c 40 1412; store by_c 15 1346;
store by_c 41 2630; store by_c 16 1350; store by_c 42 2631; store by_c 17 2632; store by_c 43 1424; store by_c 18
1360; store by_c 44 2633; store by_c 19 2634; store by_c 45 1430; store by_c 20 2635; store by_c 46 1433; store by_c
21 1378; store by_c 47 2636; store by_c 22 1382; store by_c 48 2637; store by_c 23 2638; store by_c 49 1444; store
by_c 24 1391; store by_c 50 2639; store by_c 25 1395; store by_c 51 2640
    """,
)

BY_CONSTANTS = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'p': 206},
    {'by_k': 1343},
    """
input p 116; input x 0; input p 112; mul 1 2; input x 2; input p 115; mul 4 5; add 3 6; input p 113; mul 7 8; mul 7
9; add 0 10; constant 1.0; input p 111; mul 1 13; mul 2 4; add 14 15; mul 16 16; add 12 17; mul 8 18; mul 11 19;
input p 117; mul 8 16; mul 7 22; add 21 23; mul 24 24; sub 20 25; div 12 26; mul 11 27; input p 3; input p 4; input
p 5; input p 6; mul 1 29; mul 32 33; input p 7; mul 4 35; add 34 36; mul 31 37; input p 8; input x 4; mul 37 40; mul
39 41; add 38 42; input p 9; mul 40 41; mul 44 45; add 43 46; input p 10; mul 37 37; mul 48 49; add 47 50; input p
11; mul 40 49; mul 52 53; add 51 54; input p 12; mul 37 49; mul 56 57; add 55 58; input p 13; mul 33 60; add 59 61;
input p 14; mul 33 40; mul 63 64; add 62 65; input p 15; mul 40 64; mul 67 68; add 66 69; input p 16; mul 33 37; mul
71 72; add 70 73; input p 17; mul 40 72; mul 75 76; add 74 77; input p 18; mul 37 72; mul 79 80; add 78 81; input p
19; mul 33 33; mul 37 84; mul 83 85; add 82 86; input p 20; mul 33 84; mul 88 89; add 87 90; input p 21; input p 22;
mul 40 93; add 92 94; input p 23; mul 40 40; mul 96 97; add 95 98; input p 24; mul 40 97; mul 100 101; add 99 102;
input p 25; mul 37 104; add 103 105; input p 26; mul 41 107; add 106 108; input p 27; mul 45 110; add 109 111; input
p 28; mul 49 113; add 112 114; input p 29; mul 53 116; add 115 117; input p 30; mul 57 119; add 118 120; mul 31 33;
add 121 122; mul 39 64; add 123 124; mul 44 68; add 125 126; input p 31; mul 72 128; add 127 129; input p 32; mul 76
131; add 130 132; input p 33; mul 80 134; add 133 135; input p 34; mul 84 137; add 136 138; input p 35; mul 40 84;
mul 140 141; add 139 142; mul 79 85; add 143 144; input p 36; mul 89 146; add 145 147; mul 32 148; add 91 149; mul
30 150; abs 33; constant 0.35; lt 152 153; input p 37; constant 0.6; constant -0.6; max 157 4; min 156 158; mul 159
159; mul 159 160; mul 155 161; constant -0.35; max 163 33; min 153 164; constant 2.0; mul 165 166; input p 38; mul
160 168; mul 167 169; add 162 170; mul 165 165; input p 39; mul 159 173; mul 172 174; add 171 175; mul 165 174; mul
167 177; add 176 178; mul 166 172; input p 40; mul 180 181; mul 167 182; add 179 183; mul 30 184; where 154 185; add
151 186; input p 41; input p 42; mul 33 189; input p 43; mul 4 191; add 190 192; input p 44; mul 40 194; add 193
195; constant -0.09999999999999995; mul 37 197; input p 45; mul 45 199; add 198 200; input p 46; mul 57 202; add 201
203; constant 1.2; mul 33 205; add 204 206; input p 47; mul 68 208; add 207 209; input p 48; mul 76 211; add 210
212; input p 49; mul 80 214; add 213 215; input p 50; mul 85 217; add 216 218; input p 51; mul 89 220; add 219 221;
constant -0.033333333333333326; mul 40 223; input p 52; mul 101 225; add 224 226; constant 0.13333333333333333; mul
37 228; add 227 229; input p 53; mul 45 231; add 230 232; input p 54; mul 53 234; add 233 235; input p 55; mul 57
237; add 236 238; mul 33 197; add 239 240; mul 68 199; add 241 242; input p 56; mul 80 244; add 243 245; input p 57;
mul 141 247; add 246 248; mul 85 214; add 249 250; input p 58; mul 89 252; add 251 253; mul 32 254; add 222 255; add
196 256; mul 188 257; input p 59; input p 60; constant 0.009523809523809514; mul 97 261; input p 61; mul 40 101; mul
263 264; add 262 265; mul 41 223; add 266 267; mul 40 45; mul 225 269; add 268 270; constant 0.06666666666666667;
mul 49 272; add 271 273; input p 62; mul 40 53; mul 275 276; add 274 277; input p 63; mul 40 57; mul 279 280; add
278 281; input p 64; mul 37 57; mul 283 284; add 282 285; mul 72 197; add 286 287; mul 40 76; mul 199 289; add 288
290; mul 37 80; mul 202 292; add 291 293; mul 84 156; add 294 295; input p 65; mul 40 141; mul 297 298; add 296 299;
mul 40 85; mul 247 301; add 300 302; input p 66; mul 37 85; mul 304 305; add 303 306; mul 37 89; mul 252 308; add
307 309; input p 67; mul 33 89; mul 311 312; add 310 313; constant 0.5; mul 33 196; mul 33 191; input p 68; mul 4
318; add 317 319; input p 69; mul 40 321; add 320 322; mul 4 323; add 316 324; mul 33 194; mul 4 321; add 326 327;
input p 70; mul 40 329; add 328 330; mul 40 331; add 325 332; mul 315 333; add 314 334; mul 188 335; add 260 336;
input p 71; mul 4 338; mul 4 339; add 12 340; input p 72; mul 4 342; mul 4 343; add 12 344; sqrt 345; sqrt 341; mul
346 347; div 12 348; mul 341 349; input p 73; mul 350 351; add 337 352; input p 74; mul 4 347; mul 349 355; mul 354
356; sub 353 357; input p 75; mul 350 354; input p 76; sub 360 361; mul 351 356; add 362 363; sub 364 1; mul 365
365; mul 358 358; add 366 367; sqrt 368; mul 359 369; sqrt 370; div 12 371; mul 372 372; mul 359 373; mul 358 374;
input p 77; mul 166 370; mul 166 373; mul 373 378; sub 377 379; mul 376 380; constant 0.3; constant -0.3; constant
1.4; sub 370 384; max 383 385; min 382 386; input p 78; input p 79; mul 387 389; add 388 390; mul 387 391; add 12
392; mul 381 393; input u 0; input p 80; mul 395 396; input p 81; mul 385 398; add 12 399; mul 397 400; sub 394 401;
mul 359 402; input p 82; input x 5; mul 404 405; input p 83; input x 7; mul 407 408; add 406 409; input p 84; input
x 9; mul 411 412; add 410 413; constant -0.5; mul 372 415; mul 372 416; mul 372 417; mul 359 418; mul 414 419; add
403 420; input p 85; mul 419 422; mul 419 423; input x 3; sub 352 357; mul 365 426; add 360 363; mul 358 428; sub
427 429; mul 374 430; div 12 346; mul 349 432; mul 431 433; mul 425 434; input x 1; mul 365 374; mul 436 437; sub
435 438; mul 29 436; mul 258 440; mul 35 254; add 323 442; mul 188 443; mul 425 444; add 441 445; mul 375 446; add
439 447; mul 424 448; add 421 449; mul 375 450; input p 86; add 336 452; input p 87; mul 350 454; add 453 455; input
p 88; mul 356 457; add 456 458; input p 89; mul 356 454; mul 350 457; input p 90; sub 462 463; sub 461 464; sub 465
1; mul 466 466; mul 459 459; add 467 468; sqrt 469; mul 460 470; sqrt 471; div 12 472; mul 473 473; mul 460 474; mul
459 475; input p 91; mul 166 471; mul 166 474; mul 474 479; sub 478 480; mul 477 481; sub 471 384; max 383 483; min
382 484; input p 92; input p 93; mul 485 487; add 486 488; mul 485 489; add 12 490; mul 482 491; input u 1; input p
94; mul 493 494; input p 95; mul 483 496; add 12 497; mul 495 498; sub 492 499; mul 460 500; input p 96; input x 6;
mul 502 503; input p 97; input x 8; mul 505 506; add 504 507; input p 98; input x 10; mul 509 510; add 508 511; mul
415 473; mul 473 513; mul 473 514; mul 460 515; mul 512 516; add 501 517; input p 99; mul 516 519; mul 516 520; add
455 458; mul 466 522; sub 462 461; mul 459 524; add 523 525; mul 475 526; mul 433 527; mul 425 528; mul 466 475; mul
436 530; sub 529 531; mul 446 476; add 532 533; mul 521 534; add 518 535; mul 476 536; add 451 537; sub 259 538; mul
258 539; sub 187 540; input p 100; constant 12.0; mul 440 543; constant -6.0; mul 32 440; mul 35 425; add 546 547;
mul 545 548; add 544 549; mul 542 550; mul 440 545; constant 4.0; mul 548 553; add 552 554; mul 542 555; mul 32 556;
add 551 557; add 541 558; mul 29 559; mul 29 560; mul 28 561; mul 24 27; mul 528 563; mul 28 530; add 564 565; mul
28 29; mul 258 567; mul 444 563; sub 568 569; mul 476 570; sub 566 571; mul 521 572; mul 446 573; mul 536 570; sub
574 575; mul 475 576; mul 536 563; mul 425 573; add 578 579; mul 433 580; mul 475 581; mul 524 582; add 577 583; mul
166 459; mul 166 470; div 12 586; le 383 483; le 483 383; add 588 589; div 12 590; mul 588 591; le 484 382; le 382
484; add 593 594; div 12 595; mul 593 596; mul 460 572; mul 482 598; mul 489 599; mul 485 599; mul 487 601; add 600
602; mul 597 603; mul 592 604; mul 495 598; mul 496 606; sub 605 607; mul 166 472; div 12 609; mul 473 515; mul 534
572; mul 520 612; mul 516 612; mul 519 614; add 613 615; mul 512 572; add 616 617; mul 460 618; mul 611 619; mul 473
619; mul 515 621; add 620 622; mul 473 621; mul 514 624; add 623 625; mul 166 473; mul 459 576; mul 28 536; mul 436
573; sub 629 630; mul 466 631; add 628 632; mul 526 581; add 633 634; mul 460 635; mul 491 598; mul 477 637; mul 479
638; sub 636 639; mul 474 638; neg 641; mul 166 642; add 640 643; mul 627 644; mul 474 645; add 626 646; mul 610
647; sub 608 648; mul 166 638; add 649 650; mul 460 651; mul 587 652; mul 585 653; add 584 654; sub 562 655; mul 476
573; mul 434 563; mul 28 437; add 658 659; mul 375 570; sub 660 661; mul 424 662; mul 375 663; add 657 664; mul 425
665; mul 539 563; sub 666 667; mul 443 668; add 656 669; mul 29 440; mul 35 563; mul 32 567; sub 672 673; mul 542
674; mul 545 675; mul 553 675; mul 542 567; mul 545 678; sub 677 679; mul 32 680; add 676 681; mul 543 678; sub 682
683; mul 258 665; add 684 685; mul 671 686; sub 670 687; mul 539 567; mul 440 665; add 689 690; mul 257 691; add 688
692; mul 446 663; mul 450 570; sub 694 695; mul 374 696; mul 450 563; mul 425 663; add 698 699; mul 433 700; mul 374
701; mul 428 702; sub 697 703; mul 166 358; mul 166 369; div 12 706; le 383 385; le 385 383; add 708 709; div 12
710; mul 708 711; le 386 382; le 382 386; add 713 714; div 12 715; mul 713 716; mul 359 662; mul 381 718; mul 391
719; mul 387 719; mul 389 721; add 720 722; mul 717 723; mul 712 724; mul 397 718; mul 398 726; sub 725 727; mul 166
371; div 12 729; mul 372 418; mul 448 662; mul 423 732; mul 419 732; mul 422 734; add 733 735; mul 414 662; add 736
737; mul 359 738; mul 731 739; mul 372 739; mul 418 741; add 740 742; mul 372 741; mul 417 744; add 743 745; mul 166
372; mul 358 696; mul 28 450; mul 436 663; sub 749 750; mul 365 751; add 748 752; mul 430 701; add 753 754; mul 359
755; mul 393 718; mul 376 757; mul 378 758; sub 756 759; mul 373 758; neg 761; mul 166 762; add 760 763; mul 747
764; mul 373 765; add 746 766; mul 730 767; sub 728 768; mul 166 758; add 769 770; mul 359 771; mul 707 772; mul 705
773; add 704 774; add 655 775; mul 335 776; add 693 777; sub 778 775; mul 29 33; mul 188 668; mul 35 781; mul 188
691; mul 32 783; add 782 784; mul 252 785; mul 84 786; mul 33 166; mul 33 786; mul 788 789; add 787 790; mul 214
785; mul 37 792; mul 788 793; add 791 794; mul 247 785; mul 40 796; mul 788 797; add 795 798; mul 244 785; mul 37
800; mul 37 801; add 799 802; mul 199 785; mul 40 804; mul 40 805; add 803 806; mul 197 785; add 807 808; mul 220
783; mul 84 810; add 809 811; mul 33 810; mul 788 813; add 812 814; mul 217 783; mul 37 816; mul 788 817; add 815
818; mul 214 783; mul 37 820; mul 37 821; add 819 822; mul 211 783; mul 40 824; mul 37 825; add 823 826; mul 208
783; mul 40 828; mul 40 829; add 827 830; mul 205 783; add 831 832; mul 188 776; mul 315 834; mul 40 835; mul 194
836; add 833 837; mul 4 835; add 781 839; mul 191 840; add 838 841; mul 196 835; add 842 843; mul 33 835; add 783
845; mul 189 846; add 844 847; mul 311 834; mul 89 849; add 848 850; mul 33 849; mul 84 852; add 851 853; mul 33
852; mul 788 855; add 854 856; mul 252 834; mul 37 858; mul 84 859; add 857 860; mul 33 859; mul 788 862; add 861
863; mul 304 834; mul 37 865; mul 37 866; mul 788 867; add 864 868; mul 247 834; mul 40 870; mul 37 871; mul 788
872; add 869 873; mul 297 834; mul 40 875; mul 40 876; mul 788 877; add 874 878; mul 156 834; mul 788 880; add 879
881; mul 202 834; mul 37 883; mul 37 884; mul 37 885; add 882 886; mul 199 834; mul 40 888; mul 40 889; mul 37 890;
add 887 891; mul 197 834; mul 37 893; add 892 894; le 163 33; le 33 163; add 896 897; div 12 898; mul 896 899; le
164 153; le 153 164; add 901 902; div 12 903; mul 901 904; abs 4; lt 906 156; mul 30 563; mul 173 908; mul 172 909;
mul 159 166; mul 908 911; mul 168 912; mul 167 913; add 910 914; mul 159 912; mul 160 908; add 916 917; mul 155 918;
add 915 919; where 907 920; mul 30 567; mul 167 922; mul 181 923; neg 924; mul 166 925; mul 167 926; where 154 927;
add 921 928; mul 182 922; neg 930; mul 166 931; where 154 932; add 929 933; mul 174 923; neg 935; where 154 936; add
934 937; mul 177 922; neg 939; mul 166 940; where 154 941; add 938 942; mul 165 909; where 907 944; mul 174 922; neg
946; where 154 947; add 945 948; mul 167 949; add 943 950; mul 169 922; neg 952; mul 166 953; where 154 954; add 951
955; mul 905 956; mul 900 957; add 895 958; mul 35 908; mul 32 922; sub 960 961; mul 146 962; mul 84 963; add 959
964; mul 33 963; mul 788 966; add 965 967; mul 79 962; mul 37 969; mul 788 970; add 968 971; mul 140 962; mul 40
973; mul 788 974; add 972 975; mul 137 962; mul 788 977; add 976 978; mul 134 962; mul 37 980; mul 37 981; add 979
982; mul 131 962; mul 40 984; mul 37 985; add 983 986; mul 128 962; mul 37 988; add 987 989; mul 44 962; mul 40 991;
mul 40 992; add 990 993; mul 39 962; mul 40 995; add 994 996; mul 31 962; add 997 998; mul 88 922; mul 84 1000; sub
999 1001; mul 33 1000; mul 788 1003; sub 1002 1004; mul 83 922; mul 37 1006; mul 788 1007; sub 1005 1008; mul 79
922; mul 37 1010; mul 37 1011; sub 1009 1012; mul 75 922; mul 40 1014; mul 37 1015; sub 1013 1016; mul 71 922; mul
37 1018; sub 1017 1019; mul 67 922; mul 40 1021; mul 40 1022; sub 1020 1023; mul 63 922; mul 40 1025; sub 1024 1026;
mul 60 922; sub 1027 1028; mul 84 792; mul 72 800; add 1030 1031; mul 33 801; add 1032 1033; mul 237 785; mul 49
1035; add 1034 1036; mul 37 166; mul 37 1035; mul 1038 1039; add 1037 1040; mul 234 785; mul 40 1042; mul 1038 1043;
add 1041 1044; mul 231 785; mul 40 1046; mul 40 1047; add 1045 1048; mul 228 785; add 1049 1050; mul 84 816; add
1051 1052; mul 72 820; add 1053 1054; mul 33 821; add 1055 1056; mul 33 825; add 1057 1058; mul 202 783; mul 49
1060; add 1059 1061; mul 37 1060; mul 1038 1063; add 1062 1064; mul 199 783; mul 40 1066; mul 40 1067; add 1065
1068; mul 197 783; add 1069 1070; mul 89 858; add 1071 1072; mul 85 865; add 1073 1074; mul 84 866; add 1075 1076;
mul 84 871; add 1077 1078; mul 80 883; add 1079 1080; mul 72 884; add 1081 1082; mul 33 885; add 1083 1084; mul 33
890; add 1085 1086; mul 33 893; add 1087 1088; mul 283 834; mul 57 1090; add 1089 1091; mul 37 1090; mul 49 1093;
add 1092 1094; mul 37 1093; mul 1038 1096; add 1095 1097; mul 279 834; mul 40 1099; mul 49 1100; add 1098 1101; mul
37 1100; mul 1038 1103; add 1102 1104; mul 275 834; mul 40 1106; mul 40 1107; mul 1038 1108; add 1105 1109; mul 272
834; mul 1038 1111; add 1110 1112; mul 225 834; mul 40 1114; mul 40 1115; mul 40 1116; add 1113 1117; mul 223 834;
mul 40 1119; add 1118 1120; mul 84 969; add 1121 1122; mul 72 980; add 1123 1124; mul 33 981; add 1125 1126; mul 33
985; add 1127 1128; mul 33 988; add 1129 1130; mul 119 962; mul 49 1132; add 1131 1133; mul 37 1132; mul 1038 1135;
add 1134 1136; mul 116 962; mul 40 1138; mul 1038 1139; add 1137 1140; mul 113 962; mul 1038 1142; add 1141 1143;
mul 110 962; mul 40 1145; mul 40 1146; add 1144 1147; mul 107 962; mul 40 1149; add 1148 1150; mul 104 962; add 1151
1152; mul 84 1006; sub 1153 1154; mul 72 1010; sub 1155 1156; mul 33 1011; sub 1157 1158; mul 33 1015; sub 1159
1160; mul 33 1018; sub 1161 1162; mul 56 922; mul 49 1164; sub 1163 1165; mul 37 1164; mul 1038 1167; sub 1166 1168;
mul 52 922; mul 40 1170; mul 1038 1171; sub 1169 1172; mul 48 922; mul 1038 1174; sub 1173 1175; mul 44 922; mul 40
1177; mul 40 1178; sub 1176 1179; mul 39 922; mul 40 1181; sub 1180 1182; mul 31 922; sub 1183 1184; mul 32 1185;
add 1029 1186; mul 780 1187; sub 779 1188; input p 184; input c 4; input p 0; mul 1 1192; sub 4 1193; input c 5; mul
1194 1195; sub 1191 1196; input c 6; mul 395 1198; add 1197 1199; input c 7; mul 493 1201; add 1200 1202; input c 8;
input p 1; max 1204 1205; mul 436 1192; sub 425 1207; mul 1206 1208; sub 1203 1209; mul 28 1210; mul 28 1192; add
563 1212; mul 1206 1213; mul 436 1214; add 1211 1215; mul 1195 1213; input c 9; input c 10; mul 315 1219; mul 1194
1220; sub 1218 1221; input c 11; mul 395 1223; add 1222 1224; input c 12; mul 493 1226; add 1225 1227; mul 28 1228;
add 1217 1229; mul 28 1194; mul 1220 1231; sub 1230 1232; mul 1 1233; add 1216 1234; mul 1190 1235; add 1189 1236;
mul 19 27; mul 539 1238; mul 528 1238; mul 530 563; add 1240 1241; mul 444 1238; mul 29 563; mul 258 1244; sub 1243
1245; mul 476 1246; add 1242 1247; mul 521 1248; mul 476 1249; mul 434 1238; mul 437 563; add 1251 1252; mul 375
1246; add 1253 1254; mul 424 1255; mul 375 1256; add 1250 1257; mul 425 1258; sub 1239 1259; mul 443 1260; mul 561
563; mul 460 1248; mul 495 1263; mul 496 1264; mul 482 1263; mul 489 1266; mul 485 1266; mul 487 1268; add 1267
1269; mul 597 1270; mul 592 1271; sub 1265 1272; mul 534 1248; mul 520 1274; mul 516 1274; mul 519 1276; add 1275
1277; mul 512 1248; add 1278 1279; mul 460 1280; mul 611 1281; mul 473 1281; mul 515 1283; add 1282 1284; mul 473
1283; mul 514 1286; add 1285 1287; mul 436 1249; sub 1289 578; mul 466 1290; mul 536 1246; mul 446 1249; add 1292
1293; mul 459 1294; sub 1291 1295; mul 536 1238; mul 425 1249; add 1297 1298; mul 433 1299; mul 526 1300; sub 1296
1301; mul 460 1302; mul 491 1263; mul 477 1304; mul 479 1305; add 1303 1306; mul 474 1305; mul 166 1308; add 1307
1309; mul 627 1310; mul 474 1311; sub 1288 1312; mul 610 1313; add 1273 1314; neg 1305; mul 166 1316; add 1315 1317;
mul 460 1318; mul 587 1319; mul 585 1320; mul 475 1294; mul 475 1300; mul 524 1323; add 1322 1324; sub 1321 1325;
add 1262 1326; sub 1261 1327; mul 32 1244; mul 35 1238; sub 1329 1330; mul 542 1331; mul 545 1332; mul 553 1332; mul
542 1244; mul 545 1335; add 1334 1336; mul 32 1337; add 1333 1338; mul 543 1335; add 1339 1340; mul 258 1258; sub
1341 1342; mul 671 1343; sub 1328 1344; mul 539 1244; mul 440 1258; add 1346 1347; mul 257 1348; sub 1345 1349; mul
450 1238; mul 425 1256; add 1351 1352; mul 433 1353; mul 374 1354; mul 428 1355; mul 450 1246; mul 446 1256; add
1357 1358; mul 374 1359; sub 1356 1360; mul 359 1255; mul 397 1362; mul 398 1363; mul 381 1362; mul 391 1365; mul
387 1365; mul 389 1367; add 1366 1368; mul 717 1369; mul 712 1370; sub 1364 1371; mul 448 1255; mul 423 1373; mul
419 1373; mul 422 1375; add 1374 1376; mul 414 1255; add 1377 1378; mul 359 1379; mul 731 1380; mul 372 1380; mul
418 1382; add 1381 1383; mul 372 1382; mul 417 1385; add 1384 1386; mul 436 1256; sub 1388 698; mul 365 1389; mul
358 1359; sub 1390 1391; mul 430 1354; sub 1392 1393; mul 359 1394; mul 393 1362; mul 376 1396; mul 378 1397; add
1395 1398; mul 373 1397; mul 166 1400; add 1399 1401; mul 747 1402; mul 373 1403; sub 1387 1404; mul 730 1405; add
1372 1406; neg 1397; mul 166 1408; add 1407 1409; mul 359 1410; mul 707 1411; mul 705 1412; add 1361 1413; add 1326
1414; mul 335 1415; add 1350 1416; sub 1417 1414; mul 188 1260; mul 35 1419; mul 188 1348; mul 32 1421; sub 1420
1422; mul 252 1423; mul 84 1424; mul 33 1424; mul 788 1426; add 1425 1427; mul 214 1423; mul 37 1429; mul 788 1430;
add 1428 1431; mul 247 1423; mul 40 1433; mul 788 1434; add 1432 1435; mul 244 1423; mul 37 1437; mul 37 1438; add
1436 1439; mul 199 1423; mul 40 1441; mul 40 1442; add 1440 1443; mul 197 1423; add 1444 1445; mul 220 1421; mul 84
1447; sub 1446 1448; mul 33 1447; mul 788 1450; sub 1449 1451; mul 217 1421; mul 37 1453; mul 788 1454; sub 1452
1455; mul 214 1421; mul 37 1457; mul 37 1458; sub 1456 1459; mul 211 1421; mul 40 1461; mul 37 1462; sub 1460 1463;
mul 208 1421; mul 40 1465; mul 40 1466; sub 1464 1467; mul 205 1421; sub 1468 1469; mul 188 1415; mul 315 1471; mul
40 1472; mul 194 1473; add 1470 1474; mul 4 1472; add 1419 1476; mul 191 1477; add 1475 1478; mul 196 1472; add 1479
1480; mul 33 1472; sub 1482 1421; mul 189 1483; add 1481 1484; mul 311 1471; mul 89 1486; add 1485 1487; mul 33
1486; mul 84 1489; add 1488 1490; mul 33 1489; mul 788 1492; add 1491 1493; mul 252 1471; mul 37 1495; mul 84 1496;
add 1494 1497; mul 33 1496; mul 788 1499; add 1498 1500; mul 304 1471; mul 37 1502; mul 37 1503; mul 788 1504; add
1501 1505; mul 247 1471; mul 40 1507; mul 37 1508; mul 788 1509; add 1506 1510; mul 297 1471; mul 40 1512; mul 40
1513; mul 788 1514; add 1511 1515; mul 156 1471; mul 788 1517; add 1516 1518; mul 202 1471; mul 37 1520; mul 37
1521; mul 37 1522; add 1519 1523; mul 199 1471; mul 40 1525; mul 40 1526; mul 37 1527; add 1524 1528; mul 197 1471;
mul 37 1530; add 1529 1531; mul 30 1238; mul 173 1533; mul 172 1534; mul 911 1533; mul 168 1536; mul 167 1537; add
1535 1538; mul 159 1536; mul 160 1533; add 1540 1541; mul 155 1542; add 1539 1543; neg 1544; where 907 1545; mul 30
1244; mul 167 1547; mul 181 1548; mul 166 1549; mul 167 1550; where 154 1551; add 1546 1552; mul 182 1547; mul 166
1554; where 154 1555; add 1553 1556; mul 174 1548; where 154 1558; add 1557 1559; mul 177 1547; mul 166 1561; where
154 1562; add 1560 1563; mul 165 1534; neg 1565; where 907 1566; mul 174 1547; where 154 1568; add 1567 1569; mul
167 1570; add 1564 1571; mul 169 1547; mul 166 1573; where 154 1574; add 1572 1575; mul 905 1576; mul 900 1577; add
1532 1578; mul 32 1547; mul 35 1533; sub 1580 1581; mul 146 1582; mul 84 1583; add 1579 1584; mul 33 1583; mul 788
1586; add 1585 1587; mul 79 1582; mul 37 1589; mul 788 1590; add 1588 1591; mul 140 1582; mul 40 1593; mul 788 1594;
add 1592 1595; mul 137 1582; mul 788 1597; add 1596 1598; mul 134 1582; mul 37 1600; mul 37 1601; add 1599 1602; mul
131 1582; mul 40 1604; mul 37 1605; add 1603 1606; mul 128 1582; mul 37 1608; add 1607 1609; mul 44 1582; mul 40
1611; mul 40 1612; add 1610 1613; mul 39 1582; mul 40 1615; add 1614 1616; mul 31 1582; add 1617 1618; mul 88 1547;
mul 84 1620; add 1619 1621; mul 33 1620; mul 788 1623; add 1622 1624; mul 83 1547; mul 37 1626; mul 788 1627; add
1625 1628; mul 79 1547; mul 37 1630; mul 37 1631; add 1629 1632; mul 75 1547; mul 40 1634; mul 37 1635; add 1633
1636; mul 71 1547; mul 37 1638; add 1637 1639; mul 67 1547; mul 40 1641; mul 40 1642; add 1640 1643; mul 63 1547;
mul 40 1645; add 1644 1646; mul 60 1547; add 1647 1648; mul 84 1429; mul 72 1437; add 1650 1651; mul 33 1438; add
1652 1653; mul 237 1423; mul 49 1655; add 1654 1656; mul 37 1655; mul 1038 1658; add 1657 1659; mul 234 1423; mul 40
1661; mul 1038 1662; add 1660 1663; mul 231 1423; mul 40 1665; mul 40 1666; add 1664 1667; mul 228 1423; add 1668
1669; mul 84 1453; sub 1670 1671; mul 72 1457; sub 1672 1673; mul 33 1458; sub 1674 1675; mul 33 1462; sub 1676
1677; mul 202 1421; mul 49 1679; sub 1678 1680; mul 37 1679; mul 1038 1682; sub 1681 1683; mul 199 1421; mul 40
1685; mul 40 1686; sub 1684 1687; mul 197 1421; sub 1688 1689; mul 89 1495; add 1690 1691; mul 85 1502; add 1692
1693; mul 84 1503; add 1694 1695; mul 84 1508; add 1696 1697; mul 80 1520; add 1698 1699; mul 72 1521; add 1700
1701; mul 33 1522; add 1702 1703; mul 33 1527; add 1704 1705; mul 33 1530; add 1706 1707; mul 283 1471; mul 57 1709;
add 1708 1710; mul 37 1709; mul 49 1712; add 1711 1713; mul 37 1712; mul 1038 1715; add 1714 1716; mul 279 1471; mul
40 1718; mul 49 1719; add 1717 1720; mul 37 1719; mul 1038 1722; add 1721 1723; mul 275 1471; mul 40 1725; mul 40
1726; mul 1038 1727; add 1724 1728; mul 272 1471; mul 1038 1730; add 1729 1731; mul 225 1471; mul 40 1733; mul 40
1734; mul 40 1735; add 1732 1736; mul 223 1471; mul 40 1738; add 1737 1739; mul 84 1589; add 1740 1741; mul 72 1600;
add 1742 1743; mul 33 1601; add 1744 1745; mul 33 1605; add 1746 1747; mul 33 1608; add 1748 1749; mul 119 1582; mul
49 1751; add 1750 1752; mul 37 1751; mul 1038 1754; add 1753 1755; mul 116 1582; mul 40 1757; mul 1038 1758; add
1756 1759; mul 113 1582; mul 1038 1761; add 1760 1762; mul 110 1582; mul 40 1764; mul 40 1765; add 1763 1766; mul
107 1582; mul 40 1768; add 1767 1769; mul 104 1582; add 1770 1771; mul 84 1626; add 1772 1773; mul 72 1630; add 1774
1775; mul 33 1631; add 1776 1777; mul 33 1635; add 1778 1779; mul 33 1638; add 1780 1781; mul 56 1547; mul 49 1783;
add 1782 1784; mul 37 1783; mul 1038 1786; add 1785 1787; mul 52 1547; mul 40 1789; mul 1038 1790; add 1788 1791;
mul 48 1547; mul 1038 1793; add 1792 1794; mul 44 1547; mul 40 1796; mul 40 1797; add 1795 1798; mul 39 1547; mul 40
1800; add 1799 1801; mul 31 1547; add 1802 1803; mul 32 1804; add 1649 1805; mul 780 1806; sub 1418 1807; mul 563
1210; mul 563 1192; add 1238 1810; mul 1206 1811; mul 436 1812; add 1809 1813; mul 563 1194; mul 1220 1815; mul 1195
1811; mul 563 1228; add 1817 1818; sub 1816 1819; mul 1 1820; sub 1814 1821; mul 1190 1822; sub 1808 1823; constant
0.01904761904761903; mul 40 1825; input p 130; mul 101 1827; add 1826 1828; mul 37 223; add 1829 1830; input p 131;
mul 45 1832; add 1831 1833; mul 53 231; add 1834 1835; mul 57 279; add 1836 1837; input p 132; mul 76 1839; add 1838
1840; mul 141 208; add 1841 1842; mul 85 247; add 1843 1844; add 331 1845; input p 133; mul 539 1847; mul 1846 1848;
mul 188 1846; mul 1847 1850; mul 476 1851; mul 460 1852; mul 495 1853; mul 496 1854; mul 482 1853; mul 489 1856; mul
485 1856; mul 487 1858; add 1857 1859; mul 597 1860; mul 592 1861; sub 1855 1862; mul 534 1852; mul 520 1864; mul
516 1864; mul 519 1866; add 1865 1867; mul 512 1852; add 1868 1869; mul 460 1870; mul 611 1871; mul 473 1871; mul
515 1873; add 1872 1874; mul 473 1873; mul 514 1876; add 1875 1877; mul 521 1852; mul 436 1879; mul 466 1880; mul
536 1851; mul 446 1879; add 1882 1883; mul 459 1884; sub 1881 1885; mul 425 1879; mul 433 1887; mul 526 1888; sub
1886 1889; mul 460 1890; mul 491 1853; mul 477 1892; mul 479 1893; add 1891 1894; mul 474 1893; mul 166 1896; add
1895 1897; mul 627 1898; mul 474 1899; sub 1878 1900; mul 610 1901; add 1863 1902; neg 1893; mul 166 1904; add 1903
1905; mul 460 1906; mul 587 1907; mul 585 1908; mul 475 1884; mul 475 1888; mul 524 1911; add 1910 1912; sub 1909
1913; sub 1849 1914; mul 476 1879; mul 375 1851; mul 424 1917; mul 375 1918; add 1916 1919; mul 425 1920; mul 443
1921; sub 1915 1922; mul 258 1920; mul 671 1924; add 1923 1925; mul 440 1920; mul 257 1927; sub 1926 1928; mul 425
1918; mul 433 1930; mul 374 1931; mul 428 1932; mul 450 1851; mul 446 1918; add 1934 1935; mul 374 1936; sub 1933
1937; mul 359 1917; mul 397 1939; mul 398 1940; mul 381 1939; mul 391 1942; mul 387 1942; mul 389 1944; add 1943
1945; mul 717 1946; mul 712 1947; sub 1941 1948; mul 448 1917; mul 423 1950; mul 419 1950; mul 422 1952; add 1951
1953; mul 414 1917; add 1954 1955; mul 359 1956; mul 731 1957; mul 372 1957; mul 418 1959; add 1958 1960; mul 372
1959; mul 417 1962; add 1961 1963; mul 436 1918; mul 365 1965; mul 358 1936; sub 1966 1967; mul 430 1931; sub 1968
1969; mul 359 1970; mul 393 1939; mul 376 1972; mul 378 1973; add 1971 1974; mul 373 1973; mul 166 1976; add 1975
1977; mul 747 1978; mul 373 1979; sub 1964 1980; mul 730 1981; add 1949 1982; neg 1973; mul 166 1984; add 1983 1985;
mul 359 1986; mul 707 1987; mul 705 1988; add 1938 1989; add 1914 1990; mul 335 1991; add 1929 1992; sub 1993 1990;
mul 188 1848; mul 247 1995; mul 37 1996; mul 788 1997; mul 208 1995; mul 40 1999; mul 788 2000; add 1998 2001; mul
1839 1995; mul 40 2003; mul 37 2004; add 2002 2005; input p 185; mul 37 2007; mul 788 2008; sub 2006 2009; input p
186; mul 40 2011; mul 788 2012; sub 2010 2013; input p 187; mul 788 2015; sub 2014 2016; input p 188; mul 37 2018;
mul 37 2019; sub 2017 2020; input p 189; mul 40 2022; mul 37 2023; sub 2021 2024; input p 190; mul 37 2026; sub 2025
2027; mul 188 1921; mul 35 2029; mul 188 1927; mul 32 2031; add 2030 2032; mul 252 2033; mul 84 2034; sub 2028 2035;
mul 33 2034; mul 788 2037; sub 2036 2038; mul 214 2033; mul 37 2040; mul 788 2041; sub 2039 2042; mul 247 2033; mul
40 2044; mul 788 2045; sub 2043 2046; mul 244 2033; mul 37 2048; mul 37 2049; sub 2047 2050; mul 199 2033; mul 40
2052; mul 40 2053; sub 2051 2054; mul 197 2033; sub 2055 2056; mul 220 2031; mul 84 2058; sub 2057 2059; mul 33
2058; mul 788 2061; sub 2060 2062; mul 217 2031; mul 37 2064; mul 788 2065; sub 2063 2066; mul 214 2031; mul 37
2068; mul 37 2069; sub 2067 2070; mul 211 2031; mul 40 2072; mul 37 2073; sub 2071 2074; mul 208 2031; mul 40 2076;
mul 40 2077; sub 2075 2078; mul 205 2031; sub 2079 2080; mul 188 1991; mul 315 2082; mul 40 2083; add 1995 2084; mul
194 2085; add 2081 2086; mul 4 2083; sub 2088 2029; mul 191 2089; add 2087 2090; mul 196 2083; add 2091 2092; mul 33
2083; sub 2094 2031; mul 189 2095; add 2093 2096; mul 311 2082; mul 89 2098; add 2097 2099; mul 33 2098; mul 84
2101; add 2100 2102; mul 33 2101; mul 788 2104; add 2103 2105; mul 252 2082; mul 37 2107; mul 84 2108; add 2106
2109; mul 33 2108; mul 788 2111; add 2110 2112; mul 304 2082; mul 37 2114; mul 37 2115; mul 788 2116; add 2113 2117;
mul 247 2082; mul 40 2119; mul 37 2120; mul 788 2121; add 2118 2122; mul 297 2082; mul 40 2124; mul 40 2125; mul 788
2126; add 2123 2127; mul 156 2082; mul 788 2129; add 2128 2130; mul 202 2082; mul 37 2132; mul 37 2133; mul 37 2134;
add 2131 2135; mul 199 2082; mul 40 2137; mul 40 2138; mul 37 2139; add 2136 2140; mul 197 2082; mul 37 2142; add
2141 2143; mul 84 1996; mul 33 2004; add 2145 2146; mul 279 1995; mul 49 2148; add 2147 2149; mul 37 2148; mul 1038
2151; add 2150 2152; mul 231 1995; mul 40 2154; mul 1038 2155; add 2153 2156; mul 1832 1995; mul 40 2158; mul 40
2159; add 2157 2160; mul 223 1995; add 2161 2162; mul 84 2007; sub 2163 2164; mul 72 2018; sub 2165 2166; mul 33
2019; sub 2167 2168; mul 33 2023; sub 2169 2170; mul 33 2026; sub 2171 2172; input p 191; mul 49 2174; sub 2173
2175; mul 37 2174; mul 1038 2177; sub 2176 2178; input p 192; mul 40 2180; mul 1038 2181; sub 2179 2182; input p
193; mul 1038 2184; sub 2183 2185; input p 194; mul 40 2187; mul 40 2188; sub 2186 2189; input p 195; mul 40 2191;
sub 2190 2192; input p 196; sub 2193 2194; mul 84 2040; sub 2195 2196; mul 72 2048; sub 2197 2198; mul 33 2049; sub
2199 2200; mul 237 2033; mul 49 2202; sub 2201 2203; mul 37 2202; mul 1038 2205; sub 2204 2206; mul 234 2033; mul 40
2208; mul 1038 2209; sub 2207 2210; mul 231 2033; mul 40 2212; mul 40 2213; sub 2211 2214; mul 228 2033; sub 2215
2216; mul 84 2064; sub 2217 2218; mul 72 2068; sub 2219 2220; mul 33 2069; sub 2221 2222; mul 33 2073; sub 2223
2224; mul 202 2031; mul 49 2226; sub 2225 2227; mul 37 2226; mul 1038 2229; sub 2228 2230; mul 199 2031; mul 40
2232; mul 40 2233; sub 2231 2234; mul 197 2031; sub 2235 2236; mul 89 2107; add 2237 2238; mul 85 2114; add 2239
2240; mul 84 2115; add 2241 2242; mul 84 2120; add 2243 2244; mul 80 2132; add 2245 2246; mul 72 2133; add 2247
2248; mul 33 2134; add 2249 2250; mul 33 2139; add 2251 2252; mul 33 2142; add 2253 2254; mul 283 2082; mul 57 2256;
add 2255 2257; mul 37 2256; mul 49 2259; add 2258 2260; mul 37 2259; mul 1038 2262; add 2261 2263; mul 279 2082; mul
40 2265; mul 49 2266; add 2264 2267; mul 37 2266; mul 1038 2269; add 2268 2270; mul 275 2082; mul 40 2272; mul 40
2273; mul 1038 2274; add 2271 2275; mul 272 2082; mul 1038 2277; add 2276 2278; mul 225 2082; mul 40 2280; mul 40
2281; mul 40 2282; add 2279 2283; mul 223 2082; mul 40 2285; add 2284 2286; mul 32 2287; add 2144 2288; mul 780
2289; sub 1994 2290; mul 375 419; mul 425 2292; mul 443 2293; mul 258 2292; mul 671 2295; sub 2294 2296; mul 440
2292; mul 257 2298; add 2297 2299; mul 419 446; mul 374 2301; mul 419 425; mul 433 2303; mul 374 2304; mul 428 2305;
sub 2302 2306; mul 359 448; mul 731 2308; mul 372 2308; mul 418 2310; add 2309 2311; mul 372 2310; mul 417 2313; add
2312 2314; mul 358 2301; mul 419 436; mul 365 2317; sub 2316 2318; mul 430 2304; add 2319 2320; mul 359 2321; mul
747 2322; mul 373 2323; add 2315 2324; mul 730 2325; mul 359 2326; mul 707 2327; mul 705 2328; sub 2307 2329; mul
335 2330; add 2300 2331; sub 2332 2330; mul 188 2293; mul 35 2334; mul 188 2298; mul 32 2336; add 2335 2337; mul 252
2338; mul 84 2339; mul 33 2339; mul 788 2341; add 2340 2342; mul 214 2338; mul 37 2344; mul 788 2345; add 2343 2346;
mul 247 2338; mul 40 2348; mul 788 2349; add 2347 2350; mul 244 2338; mul 37 2352; mul 37 2353; add 2351 2354; mul
199 2338; mul 40 2356; mul 40 2357; add 2355 2358; mul 197 2338; add 2359 2360; mul 220 2336; mul 84 2362; add 2361
2363; mul 33 2362; mul 788 2365; add 2364 2366; mul 217 2336; mul 37 2368; mul 788 2369; add 2367 2370; mul 214
2336; mul 37 2372; mul 37 2373; add 2371 2374; mul 211 2336; mul 40 2376; mul 37 2377; add 2375 2378; mul 208 2336;
mul 40 2380; mul 40 2381; add 2379 2382; mul 205 2336; add 2383 2384; mul 188 2330; mul 315 2386; mul 40 2387; mul
194 2388; add 2385 2389; mul 4 2387; add 2334 2391; mul 191 2392; add 2390 2393; mul 196 2387; add 2394 2395; mul 33
2387; add 2336 2397; mul 189 2398; add 2396 2399; mul 311 2386; mul 89 2401; add 2400 2402; mul 33 2401; mul 84
2404; add 2403 2405; mul 33 2404; mul 788 2407; add 2406 2408; mul 252 2386; mul 37 2410; mul 84 2411; add 2409
2412; mul 33 2411; mul 788 2414; add 2413 2415; mul 304 2386; mul 37 2417; mul 37 2418; mul 788 2419; add 2416 2420;
mul 247 2386; mul 40 2422; mul 37 2423; mul 788 2424; add 2421 2425; mul 297 2386; mul 40 2427; mul 40 2428; mul 788
2429; add 2426 2430; mul 156 2386; mul 788 2432; add 2431 2433; mul 202 2386; mul 37 2435; mul 37 2436; mul 37 2437;
add 2434 2438; mul 199 2386; mul 40 2440; mul 40 2441; mul 37 2442; add 2439 2443; mul 197 2386; mul 37 2445; add
2444 2446; mul 84 2344; mul 72 2352; add 2448 2449; mul 33 2353; add 2450 2451; mul 237 2338; mul 49 2453; add 2452
2454; mul 37 2453; mul 1038 2456; add 2455 2457; mul 234 2338; mul 40 2459; mul 1038 2460; add 2458 2461; mul 231
2338; mul 40 2463; mul 40 2464; add 2462 2465; mul 228 2338; add 2466 2467; mul 84 2368; add 2468 2469; mul 72 2372;
add 2470 2471; mul 33 2373; add 2472 2473; mul 33 2377; add 2474 2475; mul 202 2336; mul 49 2477; add 2476 2478; mul
37 2477; mul 1038 2480; add 2479 2481; mul 199 2336; mul 40 2483; mul 40 2484; add 2482 2485; mul 197 2336; add 2486
2487; mul 89 2410; add 2488 2489; mul 85 2417; add 2490 2491; mul 84 2418; add 2492 2493; mul 84 2423; add 2494
2495; mul 80 2435; add 2496 2497; mul 72 2436; add 2498 2499; mul 33 2437; add 2500 2501; mul 33 2442; add 2502
2503; mul 33 2445; add 2504 2505; mul 283 2386; mul 57 2507; add 2506 2508; mul 37 2507; mul 49 2510; add 2509 2511;
mul 37 2510; mul 1038 2513; add 2512 2514; mul 279 2386; mul 40 2516; mul 49 2517; add 2515 2518; mul 37 2517; mul
1038 2520; add 2519 2521; mul 275 2386; mul 40 2523; mul 40 2524; mul 1038 2525; add 2522 2526; mul 272 2386; mul
1038 2528; add 2527 2529; mul 225 2386; mul 40 2531; mul 40 2532; mul 40 2533; add 2530 2534; mul 223 2386; mul 40
2536; add 2535 2537; mul 32 2538; add 2447 2539; mul 780 2540; sub 2333 2541; mul 476 516; mul 425 2543; mul 443
2544; mul 446 516; mul 475 2546; mul 425 516; mul 433 2548; mul 475 2549; mul 524 2550; add 2547 2551; mul 460 534;
mul 611 2553; mul 473 2553; mul 515 2555; add 2554 2556; mul 473 2555; mul 514 2558; add 2557 2559; mul 459 2546;
mul 436 516; mul 466 2562; sub 2561 2563; mul 526 2549; add 2564 2565; mul 460 2566; mul 627 2567; mul 474 2568; add
2560 2569; mul 610 2570; mul 460 2571; mul 587 2572; mul 585 2573; sub 2552 2574; sub 2545 2575; mul 258 2543; mul
671 2577; sub 2576 2578; mul 440 2543; mul 257 2580; add 2579 2581; mul 335 2575; add 2582 2583; mul 188 2544; mul
35 2585; mul 188 2580; mul 32 2587; add 2586 2588; mul 252 2589; mul 84 2590; mul 33 2590; mul 788 2592; add 2591
2593; mul 214 2589; mul 37 2595; mul 788 2596; add 2594 2597; mul 247 2589; mul 40 2599; mul 788 2600; add 2598
2601; mul 244 2589; mul 37 2603; mul 37 2604; add 2602 2605; mul 199 2589; mul 40 2607; mul 40 2608; add 2606 2609;
mul 197 2589; add 2610 2611; mul 220 2587; mul 84 2613; add 2612 2614; mul 33 2613; mul 788 2616; add 2615 2617; mul
217 2587; mul 37 2619; mul 788 2620; add 2618 2621; mul 214 2587; mul 37 2623; mul 37 2624; add 2622 2625; mul 211
2587; mul 40 2627; mul 37 2628; add 2626 2629; mul 208 2587; mul 40 2631; mul 40 2632; add 2630 2633; mul 205 2587;
add 2634 2635; mul 188 2575; mul 315 2637; mul 40 2638; mul 194 2639; add 2636 2640; mul 4 2638; add 2585 2642; mul
191 2643; add 2641 2644; mul 196 2638; add 2645 2646; mul 33 2638; add 2587 2648; mul 189 2649; add 2647 2650; mul
311 2637; mul 89 2652; add 2651 2653; mul 33 2652; mul 84 2655; add 2654 2656; mul 33 2655; mul 788 2658; add 2657
2659; mul 252 2637; mul 37 2661; mul 84 2662; add 2660 2663; mul 33 2662; mul 788 2665; add 2664 2666; mul 304 2637;
mul 37 2668; mul 37 2669; mul 788 2670; add 2667 2671; mul 247 2637; mul 40 2673; mul 37 2674; mul 788 2675; add
2672 2676; mul 297 2637; mul 40 2678; mul 40 2679; mul 788 2680; add 2677 2681; mul 156 2637; mul 788 2683; add 2682
2684; mul 202 2637; mul 37 2686; mul 37 2687; mul 37 2688; add 2685 2689; mul 199 2637; mul 40 2691; mul 40 2692;
mul 37 2693; add 2690 2694; mul 197 2637; mul 37 2696; add 2695 2697; mul 84 2595; mul 72 2603; add 2699 2700; mul
33 2604; add 2701 2702; mul 237 2589; mul 49 2704; add 2703 2705; mul 37 2704; mul 1038 2707; add 2706 2708; mul 234
2589; mul 40 2710; mul 1038 2711; add 2709 2712; mul 231 2589; mul 40 2714; mul 40 2715; add 2713 2716; mul 228
2589; add 2717 2718; mul 84 2619; add 2719 2720; mul 72 2623; add 2721 2722; mul 33 2624; add 2723 2724; mul 33
2628; add 2725 2726; mul 202 2587; mul 49 2728; add 2727 2729; mul 37 2728; mul 1038 2731; add 2730 2732; mul 199
2587; mul 40 2734; mul 40 2735; add 2733 2736; mul 197 2587; add 2737 2738; mul 89 2661; add 2739 2740; mul 85 2668;
add 2741 2742; mul 84 2669; add 2743 2744; mul 84 2674; add 2745 2746; mul 80 2686; add 2747 2748; mul 72 2687; add
2749 2750; mul 33 2688; add 2751 2752; mul 33 2693; add 2753 2754; mul 33 2696; add 2755 2756; mul 283 2637; mul 57
2758; add 2757 2759; mul 37 2758; mul 49 2761; add 2760 2762; mul 37 2761; mul 1038 2764; add 2763 2765; mul 279
2637; mul 40 2767; mul 49 2768; add 2766 2769; mul 37 2768; mul 1038 2771; add 2770 2772; mul 275 2637; mul 40 2774;
mul 40 2775; mul 1038 2776; add 2773 2777; mul 272 2637; mul 1038 2779; add 2778 2780; mul 225 2637; mul 40 2782;
mul 40 2783; mul 40 2784; add 2781 2785; mul 223 2637; mul 40 2787; add 2786 2788; mul 32 2789; add 2698 2790; mul
780 2791; sub 2584 2792; mul 160 166; input p 118; mul 2794 2795; mul 911 2796; mul 155 165; mul 160 2798; add 2797
2799; mul 159 2798; mul 911 2801; add 2800 2802; mul 168 172; mul 911 2804; add 2803 2805; mul 165 172; mul 173
2807; add 2806 2808; mul 563 2809; where 907 2810; mul 35 148; mul 563 2812; add 2811 2813; mul 184 567; neg 2815;
where 154 2816; add 2814 2817; mul 150 567; sub 2818 2819; mul 1238 2809; neg 2821; where 907 2822; mul 1238 2812;
sub 2823 2824; mul 184 1244; where 154 2826; add 2825 2827; mul 150 1244; add 2828 2829; input p 121; mul 40 2831;
input p 122; mul 97 2833; add 2832 2834; input p 123; mul 101 2836; add 2835 2837; mul 37 93; add 2838 2839; input p
124; mul 41 2841; add 2840 2842; input p 125; mul 45 2844; add 2843 2845; input p 126; mul 49 2847; add 2846 2848;
mul 53 110; add 2849 2850; input p 127; mul 57 2852; add 2851 2853; mul 39 72; add 2854 2855; input p 128; mul 76
2857; add 2856 2858; mul 52 80; add 2859 2860; input p 129; mul 84 2862; add 2861 2863; mul 67 141; add 2864 2865;
mul 85 140; add 2866 2867; mul 1847 2868; neg 2869; mul 555 674; mul 550 567; sub 2871 2872; constant -2.0; mul 1208
1213; le 1204 1205; le 1205 1204; add 2876 2877; div 12 2878; mul 2876 2879; mul 2875 2880; mul 2874 2881; add 2873
2882; mul 555 1331; mul 550 1244; add 2884 2885; mul 1208 1811; mul 2880 2887; mul 2874 2888; sub 2886 2889;
constant 0.8; mul 30 2868; mul 539 1850; sub 2892 2893; mul 1847 2894; mul 1847 2895; mul 2891 2896; constant
-2.5714285714285743; mul 89 962; mul 2898 2899; constant 2.057142857142858; mul 85 962; mul 2901 2902; add 2900
2903; constant -0.8571428571428583; mul 141 962; mul 2905 2906; add 2904 2907; constant -3.428571428571427; mul 80
962; mul 2909 2910; add 2908 2911; constant 0.11428571428571443; mul 76 962; mul 2913 2914; add 2912 2915; constant
-0.057142857142856635; mul 68 962; mul 2917 2918; add 2916 2919; input p 197; mul 33 962; mul 197 2922; mul 2921
2923; add 2920 2924; constant 2.438095238095238; mul 57 962; mul 2926 2927; add 2925 2928; constant
0.6571428571428567; mul 53 962; mul 2930 2931; add 2929 2932; input p 198; mul 49 962; mul 2934 2935; sub 2933 2936;
constant 0.11428571428571413; mul 45 962; mul 2938 2939; add 2937 2940; mul 37 962; mul 228 2942; mul 2921 2943; add
2941 2944; constant -0.019047619047619094; mul 101 962; mul 2946 2947; add 2945 2948; mul 40 962; mul 223 2950; mul
2921 2951; add 2949 2952; constant 12.34285714285715; mul 89 922; mul 2954 2955; sub 2953 2956; constant
-7.714285714285722; mul 85 922; mul 2958 2959; sub 2957 2960; mul 80 922; mul 2901 2962; sub 2961 2963; constant
-1.7142857142857166; mul 76 922; mul 2965 2966; sub 2964 2967; constant 0.9142857142857138; mul 68 922; mul 2969
2970; sub 2968 2971; mul 33 922; mul 205 2973; mul 2921 2974; sub 2972 2975; constant -1.1428571428571423; mul 57
922; mul 2977 2978; sub 2976 2979; constant 0.05714285714285722; mul 53 922; mul 2981 2982; sub 2980 2983; mul 45
922; mul 2917 2985; sub 2984 2986; mul 37 922; mul 197 2988; mul 2921 2989; sub 2987 2990; mul 89 1582; mul 2898
2992; mul 85 1582; mul 2901 2994; add 2993 2995; mul 141 1582; mul 2905 2997; add 2996 2998; mul 80 1582; mul 2909
3000; add 2999 3001; mul 76 1582; mul 2913 3003; add 3002 3004; mul 68 1582; mul 2917 3006; add 3005 3007; mul 33
1582; mul 197 3009; mul 2921 3010; add 3008 3011; mul 57 1582; mul 2926 3013; add 3012 3014; mul 53 1582; mul 2930
3016; add 3015 3017; mul 49 1582; mul 2934 3019; sub 3018 3020; mul 45 1582; mul 2938 3022; add 3021 3023; mul 37
1582; mul 228 3025; mul 2921 3026; add 3024 3027; mul 101 1582; mul 2946 3029; add 3028 3030; mul 40 1582; mul 223
3032; mul 2921 3033; add 3031 3034; mul 89 1547; mul 2954 3036; add 3035 3037; mul 85 1547; mul 2958 3039; add 3038
3040; mul 80 1547; mul 2901 3042; add 3041 3043; mul 76 1547; mul 2965 3045; add 3044 3046; mul 68 1547; mul 2969
3048; add 3047 3049; mul 33 1547; mul 205 3051; mul 2921 3052; add 3050 3053; mul 57 1547; mul 2977 3055; add 3054
3056; mul 53 1547; mul 2981 3058; add 3057 3059; mul 45 1547; mul 2917 3061; add 3060 3062; mul 37 1547; mul 197
3064; mul 2921 3065; add 3063 3066; input p 199; mul 85 3068; mul 2905 3069; mul 141 3068; mul 2969 3071; add 3070
3072; mul 80 3068; mul 2981 3074; add 3073 3075; constant -0.11428571428571327; mul 76 3068; mul 3077 3078; add 3076
3079; constant 0.2190476190476189; mul 57 3068; mul 3081 3082; add 3080 3083; mul 53 3068; mul 2938 3085; add 3084
3086; constant -0.05714285714285729; mul 45 3068; mul 3088 3089; add 3087 3090; mul 37 3068; mul 223 3092; mul 2921
3093; add 3091 3094; constant 0.007256235827664418; mul 101 3068; mul 3096 3097; add 3095 3098; mul 40 3068; mul
1825 3100; mul 2921 3101; add 3099 3102; neg 3103; constant -129.60000000000008; mul 2899 3105; constant
230.40000000000006; mul 2902 3107; add 3106 3108; constant 28.799999999999958; mul 2906 3110; add 3109 3111;
constant -36.00000000000001; mul 84 962; mul 3113 3114; mul 2934 3115; add 3112 3116; constant -151.20000000000002;
mul 2910 3118; add 3117 3119; constant -57.59999999999995; mul 2914 3121; add 3120 3122; constant 72.0; mul 72 962;
mul 3124 3125; mul 2934 3126; add 3123 3127; constant -22.62857142857143; mul 2918 3129; add 3128 3130; constant
28.79999999999999; mul 64 962; mul 3132 3133; mul 2934 3134; add 3131 3135; constant -18.000000000000004; mul 2922
3137; mul 2921 3138; add 3136 3139; constant 35.20000000000001; mul 2927 3141; add 3140 3142; constant
21.59999999999998; mul 2931 3144; add 3143 3145; constant -30.000000000000007; mul 2935 3147; mul 2934 3148; add
3146 3149; constant 13.714285714285717; mul 2939 3151; add 3150 3152; constant -14.399999999999991; mul 41 962; mul
3154 3155; mul 2934 3156; add 3153 3157; mul 543 2942; mul 2921 3159; add 3158 3160; constant 0.4571428571428564;
mul 2947 3162; add 3161 3163; constant -2.3999999999999995; mul 97 962; mul 3165 3166; mul 2934 3167; add 3164 3168;
input p 200; constant -0.9999999999999998; mul 962 3171; mul 3170 3172; add 3169 3173; constant 259.2000000000001;
mul 2955 3175; sub 3174 3176; constant -388.80000000000024; mul 2959 3178; sub 3177 3179; mul 2962 3107; sub 3180
3181; constant 57.599999999999916; mul 2966 3183; sub 3182 3184; constant -72.00000000000001; mul 72 922; mul 3186
3187; mul 2934 3188; sub 3185 3189; constant 45.25714285714287; mul 2970 3191; sub 3190 3192; constant
-57.60000000000001; mul 64 922; mul 3194 3195; mul 2934 3196; sub 3193 3197; constant 36.000000000000014; mul 2973
3199; mul 2921 3200; sub 3198 3201; constant -50.400000000000006; mul 2978 3203; sub 3202 3204; constant
-28.799999999999976; mul 2982 3206; sub 3205 3207; constant 36.0; mul 49 922; mul 3209 3210; mul 2934 3211; sub 3208
3212; mul 2985 3129; sub 3213 3214; mul 41 922; mul 3132 3216; mul 2934 3217; sub 3215 3218; mul 2988 3137; mul 2921
3220; sub 3219 3221; mul 2992 3105; mul 2994 3107; add 3223 3224; mul 2997 3110; add 3225 3226; mul 84 1582; mul
3113 3228; mul 2934 3229; add 3227 3230; mul 3000 3118; add 3231 3232; mul 3003 3121; add 3233 3234; mul 72 1582;
mul 3124 3236; mul 2934 3237; add 3235 3238; mul 3006 3129; add 3239 3240; mul 64 1582; mul 3132 3242; mul 2934
3243; add 3241 3244; mul 3009 3137; mul 2921 3246; add 3245 3247; mul 3013 3141; add 3248 3249; mul 3016 3144; add
3250 3251; mul 3019 3147; mul 2934 3253; add 3252 3254; mul 3022 3151; add 3255 3256; mul 41 1582; mul 3154 3258;
mul 2934 3259; add 3257 3260; mul 543 3025; mul 2921 3262; add 3261 3263; mul 3029 3162; add 3264 3265; mul 97 1582;
mul 3165 3267; mul 2934 3268; add 3266 3269; mul 1582 3171; mul 3170 3271; add 3270 3272; mul 3036 3175; add 3273
3274; mul 3039 3178; add 3275 3276; mul 3042 3107; add 3277 3278; mul 3045 3183; add 3279 3280; mul 72 1547; mul
3186 3282; mul 2934 3283; add 3281 3284; mul 3048 3191; add 3285 3286; mul 64 1547; mul 3194 3288; mul 2934 3289;
add 3287 3290; mul 3051 3199; mul 2921 3292; add 3291 3293; mul 3055 3203; add 3294 3295; mul 3058 3206; add 3296
3297; mul 49 1547; mul 3209 3299; mul 2934 3300; add 3298 3301; mul 3061 3129; add 3302 3303; mul 41 1547; mul 3132
3305; mul 2934 3306; add 3304 3307; mul 3064 3137; mul 2921 3309; add 3308 3310; mul 3069 3110; mul 3071 3191; add
3312 3313; constant -28.800000000000004; mul 84 3068; mul 3315 3316; mul 2934 3317; add 3314 3318; mul 3074 3206;
add 3319 3320; constant -45.25714285714286; mul 3078 3322; add 3321 3323; mul 72 3068; mul 3132 3325; mul 2934 3326;
add 3324 3327; constant 7.199999999999994; mul 3082 3329; add 3328 3330; mul 3085 3151; add 3331 3332; constant
-7.199999999999996; mul 49 3068; mul 3334 3335; mul 2934 3336; add 3333 3337; constant 1.3714285714285692; mul 3089
3339; add 3338 3340; constant -4.799999999999999; mul 41 3068; mul 3342 3343; mul 2934 3344; add 3341 3345; constant
1.3714285714285714; mul 3097 3347; add 3346 3348; constant -1.3714285714285723; mul 97 3068; mul 3350 3351; mul 2934
3352; add 3349 3353; constant 2.400000000000001; mul 3100 3355; mul 2921 3356; add 3354 3357; neg 3358; constant
-0.12857142857142845; mul 89 785; mul 3360 3361; constant 0.12857142857142853; mul 85 785; mul 3363 3364; add 3362
3365; constant -0.04285714285714284; mul 141 785; mul 3367 3368; add 3366 3369; constant 0.010714285714285735; mul
80 785; mul 3371 3372; add 3370 3373; constant -0.0006802721088435403; mul 68 785; mul 3375 3376; add 3374 3377;
constant 0.028571428571428567; mul 57 785; mul 3379 3380; add 3378 3381; constant -0.010714285714285721; mul 53 785;
mul 3383 3384; add 3382 3385; constant 0.0027210884353741486; mul 45 785; mul 3387 3388; add 3386 3389; constant
-0.0004787100025195255; mul 101 785; mul 3391 3392; add 3390 3393; constant 1.0285714285714285; mul 89 783; mul 3395
3396; add 3394 3397; constant -0.38571428571428534; mul 85 783; mul 3399 3400; add 3398 3401; mul 80 783; mul 3363
3403; add 3402 3404; constant -0.08571428571428567; mul 76 783; mul 3406 3407; add 3405 3408; constant
0.029931972789115628; mul 68 783; mul 3410 3411; add 3409 3412; constant 0.0035714285714285787; mul 57 783; mul 3414
3415; add 3413 3416; mul 45 783; mul 3375 3418; add 3417 3419; constant 0.2571428571428571; mul 312 834; mul 3421
3422; add 3420 3423; mul 308 834; mul 3360 3425; add 3424 3426; constant 0.06428571428571427; mul 305 834; mul 3428
3429; add 3427 3430; mul 301 834; mul 3367 3432; add 3431 3433; constant 0.014965986394557814; mul 298 834; mul 3435
3436; add 3434 3437; mul 292 834; mul 3414 3439; add 3438 3440; mul 289 834; mul 3375 3442; add 3441 3443; constant
0.007142857142857142; mul 284 834; mul 3445 3446; add 3444 3447; constant -0.003571428571428574; mul 280 834; mul
3449 3450; add 3448 3451; constant 0.0013605442176870743; mul 276 834; mul 3453 3454; add 3452 3455; mul 269 834;
mul 3391 3457; add 3456 3458; constant 8.118473726939319e-05; mul 264 834; mul 3460 3461; add 3459 3462; mul 89
1423; mul 3360 3464; mul 85 1423; mul 3363 3466; add 3465 3467; mul 141 1423; mul 3367 3469; add 3468 3470; mul 80
1423; mul 3371 3472; add 3471 3473; mul 68 1423; mul 3375 3475; add 3474 3476; mul 57 1423; mul 3379 3478; add 3477
3479; mul 53 1423; mul 3383 3481; add 3480 3482; mul 45 1423; mul 3387 3484; add 3483 3485; mul 101 1423; mul 3391
3487; add 3486 3488; mul 89 1421; mul 3395 3490; sub 3489 3491; mul 85 1421; mul 3399 3493; sub 3492 3494; mul 80
1421; mul 3363 3496; sub 3495 3497; mul 76 1421; mul 3406 3499; sub 3498 3500; mul 68 1421; mul 3410 3502; sub 3501
3503; mul 57 1421; mul 3414 3505; sub 3504 3506; mul 45 1421; mul 3375 3508; sub 3507 3509; mul 312 1471; mul 3421
3511; add 3510 3512; mul 308 1471; mul 3360 3514; add 3513 3515; mul 305 1471; mul 3428 3517; add 3516 3518; mul 301
1471; mul 3367 3520; add 3519 3521; mul 298 1471; mul 3435 3523; add 3522 3524; mul 292 1471; mul 3414 3526; add
3525 3527; mul 289 1471; mul 3375 3529; add 3528 3530; mul 284 1471; mul 3445 3532; add 3531 3533; mul 280 1471; mul
3449 3535; add 3534 3536; mul 276 1471; mul 3453 3538; add 3537 3539; mul 269 1471; mul 3391 3541; add 3540 3542;
mul 264 1471; mul 3460 3544; add 3543 3545; mul 85 1995; mul 3367 3547; mul 141 1995; mul 3410 3549; add 3548 3550;
constant -0.0013605442176870806; mul 76 1995; mul 3552 3553; add 3551 3554; mul 57 1995; mul 3449 3556; add 3555
3557; mul 53 1995; mul 3387 3559; add 3558 3560; constant -0.0014361300075585765; mul 45 1995; mul 3562 3563; add
3561 3564; constant 0.00032473894907757275; mul 101 1995; mul 3566 3567; add 3565 3568; mul 89 2033; mul 3360 3570;
sub 3569 3571; mul 85 2033; mul 3363 3573; sub 3572 3574; mul 141 2033; mul 3367 3576; sub 3575 3577; mul 80 2033;
mul 3371 3579; sub 3578 3580; mul 68 2033; mul 3375 3582; sub 3581 3583; mul 57 2033; mul 3379 3585; sub 3584 3586;
mul 53 2033; mul 3383 3588; sub 3587 3589; mul 45 2033; mul 3387 3591; sub 3590 3592; mul 101 2033; mul 3391 3594;
sub 3593 3595; mul 89 2031; mul 3395 3597; sub 3596 3598; mul 85 2031; mul 3399 3600; sub 3599 3601; mul 80 2031;
mul 3363 3603; sub 3602 3604; mul 76 2031; mul 3406 3606; sub 3605 3607; mul 68 2031; mul 3410 3609; sub 3608 3610;
mul 57 2031; mul 3414 3612; sub 3611 3613; mul 45 2031; mul 3375 3615; sub 3614 3616; mul 312 2082; mul 3421 3618;
add 3617 3619; mul 308 2082; mul 3360 3621; add 3620 3622; mul 305 2082; mul 3428 3624; add 3623 3625; mul 301 2082;
mul 3367 3627; add 3626 3628; mul 298 2082; mul 3435 3630; add 3629 3631; mul 292 2082; mul 3414 3633; add 3632
3634; mul 289 2082; mul 3375 3636; add 3635 3637; mul 284 2082; mul 3445 3639; add 3638 3640; mul 280 2082; mul 3449
3642; add 3641 3643; mul 276 2082; mul 3453 3645; add 3644 3646; mul 269 2082; mul 3391 3648; add 3647 3649; mul 264
2082; mul 3460 3651; add 3650 3652; mul 89 2338; mul 3360 3654; mul 85 2338; mul 3363 3656; add 3655 3657; mul 141
2338; mul 3367 3659; add 3658 3660; mul 80 2338; mul 3371 3662; add 3661 3663; mul 68 2338; mul 3375 3665; add 3664
3666; mul 57 2338; mul 3379 3668; add 3667 3669; mul 53 2338; mul 3383 3671; add 3670 3672; mul 45 2338; mul 3387
3674; add 3673 3675; mul 101 2338; mul 3391 3677; add 3676 3678; mul 89 2336; mul 3395 3680; add 3679 3681; mul 85
2336; mul 3399 3683; add 3682 3684; mul 80 2336; mul 3363 3686; add 3685 3687; mul 76 2336; mul 3406 3689; add 3688
3690; mul 68 2336; mul 3410 3692; add 3691 3693; mul 57 2336; mul 3414 3695; add 3694 3696; mul 45 2336; mul 3375
3698; add 3697 3699; mul 312 2386; mul 3421 3701; add 3700 3702; mul 308 2386; mul 3360 3704; add 3703 3705; mul 305
2386; mul 3428 3707; add 3706 3708; mul 301 2386; mul 3367 3710; add 3709 3711; mul 298 2386; mul 3435 3713; add
3712 3714; mul 292 2386; mul 3414 3716; add 3715 3717; mul 289 2386; mul 3375 3719; add 3718 3720; mul 284 2386; mul
3445 3722; add 3721 3723; mul 280 2386; mul 3449 3725; add 3724 3726; mul 276 2386; mul 3453 3728; add 3727 3729;
mul 269 2386; mul 3391 3731; add 3730 3732; mul 264 2386; mul 3460 3734; add 3733 3735; mul 89 2589; mul 3360 3737;
mul 85 2589; mul 3363 3739; add 3738 3740; mul 141 2589; mul 3367 3742; add 3741 3743; mul 80 2589; mul 3371 3745;
add 3744 3746; mul 68 2589; mul 3375 3748; add 3747 3749; mul 57 2589; mul 3379 3751; add 3750 3752; mul 53 2589;
mul 3383 3754; add 3753 3755; mul 45 2589; mul 3387 3757; add 3756 3758; mul 101 2589; mul 3391 3760; add 3759 3761;
mul 89 2587; mul 3395 3763; add 3762 3764; mul 85 2587; mul 3399 3766; add 3765 3767; mul 80 2587; mul 3363 3769;
add 3768 3770; mul 76 2587; mul 3406 3772; add 3771 3773; mul 68 2587; mul 3410 3775; add 3774 3776; mul 57 2587;
mul 3414 3778; add 3777 3779; mul 45 2587; mul 3375 3781; add 3780 3782; mul 312 2637; mul 3421 3784; add 3783 3785;
mul 308 2637; mul 3360 3787; add 3786 3788; mul 305 2637; mul 3428 3790; add 3789 3791; mul 301 2637; mul 3367 3793;
add 3792 3794; mul 298 2637; mul 3435 3796; add 3795 3797; mul 292 2637; mul 3414 3799; add 3798 3800; mul 289 2637;
mul 3375 3802; add 3801 3803; mul 284 2637; mul 3445 3805; add 3804 3806; mul 280 2637; mul 3449 3808; add 3807
3809; mul 276 2637; mul 3453 3811; add 3810 3812; mul 269 2637; mul 3391 3814; add 3813 3815; mul 264 2637; mul 3460
3817; add 3816 3818; input p 201; mul 3115 3820; mul 3126 3820; add 3821 3822; mul 3134 3820; add 3823 3824; input p
202; input p 203; mul 2923 3827; mul 3826 3828; add 3825 3829; mul 3138 3820; mul 3826 3831; add 3830 3832; mul 2935
3827; sub 3833 3834; mul 3148 3820; add 3835 3836; mul 3156 3820; add 3837 3838; mul 2943 3827; mul 3826 3840; add
3839 3841; mul 3159 3820; mul 3826 3843; add 3842 3844; mul 3167 3820; add 3845 3846; mul 2951 3827; mul 3826 3848;
add 3847 3849; mul 3172 3820; mul 2921 3851; add 3850 3852; mul 2934 3851; mul 3826 3854; add 3853 3855; add 3172
3856; mul 3188 3820; sub 3857 3858; mul 3196 3820; sub 3859 3860; mul 2974 3827; mul 3826 3862; sub 3861 3863; mul
3200 3820; mul 3826 3865; sub 3864 3866; mul 3211 3820; sub 3867 3868; mul 3217 3820; sub 3869 3870; mul 2989 3827;
mul 3826 3872; sub 3871 3873; mul 3220 3820; mul 3826 3875; sub 3874 3876; mul 3229 3820; mul 3237 3820; add 3878
3879; mul 3243 3820; add 3880 3881; mul 3010 3827; mul 3826 3883; add 3882 3884; mul 3246 3820; mul 3826 3886; add
3885 3887; mul 3019 3827; sub 3888 3889; mul 3253 3820; add 3890 3891; mul 3259 3820; add 3892 3893; mul 3026 3827;
mul 3826 3895; add 3894 3896; mul 3262 3820; mul 3826 3898; add 3897 3899; mul 3268 3820; add 3900 3901; mul 3033
3827; mul 3826 3903; add 3902 3904; mul 3271 3820; mul 2921 3906; add 3905 3907; mul 2934 3906; mul 3826 3909; add
3908 3910; add 3271 3911; mul 3283 3820; add 3912 3913; mul 3289 3820; add 3914 3915; mul 3052 3827; mul 3826 3917;
add 3916 3918; mul 3292 3820; mul 3826 3920; add 3919 3921; mul 3300 3820; add 3922 3923; mul 3306 3820; add 3924
3925; mul 3065 3827; mul 3826 3927; add 3926 3928; mul 3309 3820; mul 3826 3930; add 3929 3931; mul 3317 3820; mul
3326 3820; add 3933 3934; mul 3336 3820; add 3935 3936; mul 3344 3820; add 3937 3938; mul 3093 3827; mul 3826 3940;
add 3939 3941; mul 3352 3820; add 3942 3943; mul 3101 3827; mul 3826 3945; add 3944 3946; mul 3356 3820; mul 3826
3948; add 3947 3949; neg 3950; mul 440 680; mul 556 567; sub 3952 3953; mul 254 783; add 3954 3955; mul 148 922; sub
3956 3957; mul 33 1185; add 3958 3959; mul 556 1244; mul 440 1337; add 3961 3962; mul 254 1421; sub 3963 3964; mul
148 1547; add 3965 3966; mul 33 1804; add 3967 3968; mul 33 2287; mul 254 2031; sub 3970 3971; mul 254 2336; mul 33
2538; add 3973 3974; mul 254 2587; mul 33 2789; add 3976 3977; mul 556 563; mul 148 908; add 3979 3980; mul 425 680;
add 3981 3982; mul 254 781; add 3983 3984; mul 4 1185; add 3985 3986; mul 425 1337; mul 556 1238; mul 148 1533; add
3989 3990; sub 3988 3991; mul 254 1419; add 3992 3993; mul 4 1804; add 3994 3995; mul 4 2287; mul 254 2029; sub 3997
3998; mul 254 2334; mul 4 2538; add 4000 4001; mul 254 2585; mul 4 2789; add 4003 4004; mul 33 846; mul 33 1483; mul
33 2095; mul 33 2398; mul 33 2649; mul 33 840; mul 4 846; add 4011 4012; mul 33 1477; mul 4 1483; add 4014 4015; mul
33 2089; mul 4 2095; add 4017 4018; mul 33 2392; mul 4 2398; add 4020 4021; mul 33 2643; mul 4 2649; add 4023 4024;
mul 4 840; mul 4 1477; mul 4 2089; mul 4 2392; mul 4 2643; mul 33 836; mul 40 846; add 4031 4032; mul 33 1473; mul
40 1483; add 4034 4035; mul 33 2085; mul 40 2095; add 4037 4038; mul 33 2388; mul 40 2398; add 4040 4041; mul 33
2639; mul 40 2649; add 4043 4044; mul 4 836; mul 40 840; add 4046 4047; mul 4 1473; mul 40 1477; add 4049 4050; mul
4 2085; mul 40 2089; add 4052 4053; mul 4 2388; mul 40 2392; add 4055 4056; mul 4 2639; mul 40 2643; add 4058 4059;
mul 40 836; mul 40 1473; mul 40 2085; mul 40 2388; mul 40 2639; mul 459 582; mul 457 4066; mul 466 582; mul 454
4068; add 4067 4069; mul 454 655; add 4070 4071; mul 475 631; mul 522 582; add 4073 4074; mul 166 466; mul 653 4076;
add 4075 4077; mul 457 4078; sub 4072 4079; mul 358 702; mul 354 4081; sub 4080 4082; mul 365 702; mul 351 4084; add
4083 4085; mul 351 775; add 4086 4087; mul 374 751; mul 426 702; add 4089 4090; mul 166 365; mul 773 4092; add 4091
4093; mul 354 4094; add 4088 4095; mul 349 4096; mul 457 4068; input p 119; mul 433 563; mul 4099 4100; mul 454
4066; add 4101 4102; sub 4098 4103; mul 457 655; add 4104 4105; mul 454 4078; add 4106 4107; mul 351 4081; sub 4108
4109; mul 354 4084; sub 4110 4111; mul 354 775; sub 4112 4113; mul 351 4094; add 4114 4115; mul 349 4116; mul 4
4117; mul 349 433; mul 527 580; mul 356 4099; mul 563 4121; sub 4120 4122; mul 431 700; add 4123 4124; mul 4119
4125; mul 349 356; mul 4116 4127; add 4126 4128; mul 349 350; mul 4096 4130; add 4129 4131; mul 346 4132; sub 4118
4133; mul 166 347; div 12 4135; mul 4134 4136; add 4097 4137; mul 4 4138; mul 4 4139; mul 432 432; mul 349 4125; mul
4141 4142; mul 347 4132; add 4143 4144; mul 166 346; div 12 4146; mul 4145 4147; mul 4 4148; mul 4 4149; sub 4140
4150; mul 454 1326; mul 459 1323; mul 457 4153; mul 466 1323; mul 454 4155; add 4154 4156; sub 4152 4157; mul 475
1290; mul 522 1323; sub 4159 4160; mul 1320 4076; add 4161 4162; mul 457 4163; sub 4158 4164; mul 358 1355; mul 354
4166; add 4165 4167; mul 365 1355; mul 351 4169; sub 4168 4170; mul 351 1414; add 4171 4172; mul 374 1389; mul 426
1355; sub 4174 4175; mul 1412 4092; add 4176 4177; mul 354 4178; add 4173 4179; mul 349 4180; mul 433 1238; mul 4099
4182; mul 454 4153; add 4183 4184; mul 457 4155; sub 4185 4186; mul 457 1326; add 4187 4188; mul 454 4163; add 4189
4190; mul 351 4166; add 4191 4192; mul 354 4169; add 4193 4194; mul 354 1414; sub 4195 4196; mul 351 4178; add 4197
4198; mul 349 4199; mul 4 4200; mul 1238 4121; mul 527 1299; sub 4202 4203; mul 431 1353; sub 4204 4205; mul 4119
4206; mul 4127 4199; add 4207 4208; mul 4130 4180; add 4209 4210; mul 346 4211; sub 4201 4212; mul 4136 4213; add
4181 4214; mul 4 4215; mul 4 4216; mul 349 4206; mul 4141 4218; mul 347 4211; add 4219 4220; mul 4147 4221; mul 4
4222; mul 4 4223; sub 4217 4224; mul 527 1887; mul 431 1930; add 4226 4227; mul 349 4228; mul 4141 4229; mul 4119
4228; mul 459 1911; mul 454 4232; mul 466 1911; mul 457 4234; sub 4233 4235; mul 457 1914; add 4236 4237; mul 475
1880; mul 522 1911; sub 4239 4240; mul 1908 4076; add 4241 4242; mul 454 4243; add 4238 4244; mul 358 1932; mul 351
4246; add 4245 4247; mul 365 1932; mul 354 4249; add 4248 4250; mul 354 1990; sub 4251 4252; mul 374 1965; mul 426
1932; sub 4254 4255; mul 1988 4092; add 4256 4257; mul 351 4258; add 4253 4259; mul 4127 4260; sub 4231 4261; mul
454 1914; mul 457 4232; mul 454 4234; add 4264 4265; sub 4263 4266; mul 457 4243; sub 4267 4268; mul 354 4246; add
4269 4270; mul 351 4249; sub 4271 4272; mul 351 1990; add 4273 4274; mul 354 4258; add 4275 4276; mul 4130 4277; sub
4262 4278; mul 347 4279; add 4230 4280; mul 4147 4281; mul 4 4282; mul 4 4283; mul 349 4277; mul 349 4260; mul 4
4286; mul 346 4279; add 4287 4288; mul 4136 4289; add 4285 4290; mul 4 4291; mul 4 4292; add 4284 4293; mul 365
2305; mul 351 4295; mul 358 2305; mul 354 4297; sub 4296 4298; mul 351 2330; add 4299 4300; mul 426 2305; mul 374
2317; sub 4302 4303; mul 2328 4092; sub 4304 4305; mul 354 4306; add 4301 4307; mul 349 4308; mul 351 4306; mul 351
4297; mul 354 4295; add 4311 4312; mul 354 2330; add 4313 4314; sub 4310 4315; mul 349 4316; mul 4 4317; mul 431
2303; mul 4119 4319; mul 4127 4316; add 4320 4321; mul 4130 4308; add 4322 4323; mul 346 4324; sub 4318 4325; mul
4136 4326; add 4309 4327; mul 4 4328; mul 4 4329; mul 349 4319; mul 4141 4331; mul 347 4324; add 4332 4333; mul 4147
4334; mul 4 4335; mul 4 4336; sub 4330 4337; mul 459 2550; mul 457 4339; mul 466 2550; mul 454 4341; add 4340 4342;
mul 454 2575; add 4343 4344; mul 522 2550; mul 475 2562; sub 4346 4347; mul 2573 4076; sub 4348 4349; mul 457 4350;
sub 4345 4351; mul 349 4352; mul 457 4341; mul 454 4339; sub 4354 4355; mul 457 2575; add 4356 4357; mul 454 4350;
add 4358 4359; mul 349 4360; mul 4 4361; mul 527 2548; mul 4119 4363; mul 4127 4360; add 4364 4365; mul 4130 4352;
add 4366 4367; mul 346 4368; sub 4362 4369; mul 4136 4370; add 4353 4371; mul 4 4372; mul 4 4373; mul 349 4363; mul
4141 4375; mul 347 4368; add 4376 4377; mul 4147 4378; mul 4 4379; mul 4 4380; sub 4374 4381; mul 180 923; neg 4383;
where 154 4384; mul 180 1548; where 154 4386; mul 908 2807; where 907 4388; mul 165 923; mul 172 922; add 4390 4391;
mul 159 4392; neg 4393; where 154 4394; add 4389 4395; mul 1533 2807; neg 4397; where 907 4398; mul 165 1548; mul
172 1547; add 4400 4401; mul 159 4402; where 154 4403; add 4399 4404; mul 172 912; where 907 4406; mul 160 923; neg
4408; where 154 4409; add 4407 4410; mul 172 1536; neg 4412; where 907 4413; mul 160 1548; where 154 4415; add 4414
4416; mul 165 918; where 907 4418; mul 161 922; neg 4420; where 154 4421; add 4419 4422; mul 165 1542; neg 4424;
where 907 4425; mul 161 1547; where 154 4427; add 4426 4428; mul 912 2794; where 907 4430; mul 1536 2794; neg 4432;
where 907 4433; input c 0; input c 2; mul 395 4436; add 4435 4437; input c 3; mul 493 4439; add 4438 4440; mul 1194
1228; add 4441 4442; mul 1192 1210; sub 4443 4444; input p 2; input c 1; add 4446 4447; constant 0.0; max 4448 4449;
mul 436 4450; sub 4445 4451; mul 437 450; mul 530 536; add 4453 4454; sub 560 4455; sub 4452 4456; input p 101;
input p 102; input z 0; mul 4459 4460; input p 103; input z 1; mul 4462 4463; add 4461 4464; input p 104; input z 2;
mul 4466 4467; add 4465 4468; input p 105; input z 3; mul 4470 4471; add 4469 4472; sub 4458 4473; input p 106; abs
436; mul 4475 4476; mul 436 4477; input p 107; mul 436 4479; mul 436 436; input p 108; add 4481 4482; sqrt 4483; div
12 4484; mul 4480 4485; add 4478 4486; sub 4474 4487; add 4457 4488; input p 109; input x 11; sub 1 4491; mul 4490
4492; input p 110; input x 12; sub 1 4495; mul 4494 4496; add 4493 4497; sub 4489 4498; mul 13 436; input p 114; mul
425 4501; add 4500 4502; mul 436 4503; mul 5 425; mul 425 4505; add 4504 4506; mul 8 4507; mul 16 4508; sub 4499
4509; mul 11 4510; mul 30 2812; mul 30 2809; where 907 4513; add 4512 4514; mul 444 539; sub 4515 4516; mul 35 556;
add 4517 4518; mul 434 450; mul 528 536; add 4520 4521; add 4519 4522; sub 1210 4523; mul 433 4121; add 4524 4525;
input p 120; mul 4473 4527; sub 4526 4528; mul 7 4508; sub 4529 4530; mul 24 4531; sub 4511 4532; mul 27 4533; mul
27 4534; mul 24 166; mul 4535 4536; mul 27 4531; sub 4537 4538; mul 7 4539; mul 16 4540; mul 11 4535; mul 18 4542;
sub 4541 4543; mul 27 4510; mul 19 4535; sub 4545 4546; mul 7 4547; mul 7 4548; add 4544 4549; mul 7 563; mul 16 28;
sub 4551 4552; mul 4507 4553; add 4550 4554; mul 19 4531; mul 24 4510; sub 4556 4557; mul 27 4558; mul 27 4559; mul
11 4560; sub 4538 4561; mul 18 4562; mul 4536 4560; sub 4564 4545; mul 7 4565; mul 16 4566; add 4563 4567; mul 19
4560; mul 7 4569; mul 7 4570; sub 4568 4571; mul 16 563; mul 7 1238; sub 4573 4574; mul 4507 4575; add 4572 4576;
neg 4569; mul 8 4553; mul 436 4579; mul 436 4580; mul 8 4540; mul 16 166; mul 8 4542; mul 4583 4584; sub 4582 4585;
mul 28 4508; sub 4586 4587; mul 1 4588; add 4581 4589; mul 8 4575; mul 436 4591; mul 436 4592; mul 8 4562; mul 4583
4594; mul 8 4566; add 4595 4596; mul 563 4508; add 4597 4598; mul 1 4599; add 4593 4600; mul 22 4539; add 4598 4602;
mul 9 4547; add 4603 4604; mul 8 4548; add 4605 4606; mul 1 4607; mul 425 4580; mul 166 4609; add 4608 4610; mul 4
4588; add 4611 4612; mul 22 4565; mul 1238 4508; sub 4614 4615; mul 9 4569; sub 4616 4617; mul 8 4570; sub 4618
4619; mul 1 4620; mul 425 4592; mul 166 4622; add 4621 4623; mul 4 4599; add 4624 4625; mul 4 4607; mul 425 4579;
mul 425 4628; add 4627 4629; mul 4 4620; mul 425 4591; mul 425 4632; add 4631 4633; input p 204; mul 356 4100; mul
4635 4636; sub 570 4637; mul 356 4182; mul 4635 4639; add 1246 4640; mul 259 4636; neg 4642; mul 259 4639; neg 563;
neg 405; neg 503; neg 408; neg 506; neg 412; neg 510; le 4449 4448; le 4448 4449; add 4652 4653; div 12 4654; mul
4652 4655; mul 28 436; mul 4656 4657; neg 4658; mul 436 563; mul 4656 4660; mul 4476 4657; neg 4662; mul 4476 4660;
mul 28 4485; mul 436 4665; neg 4666; mul 563 4485; mul 436 4668; input p 205; mul 4485 4486; mul 28 4671; mul 166
4484; div 12 4673; mul 4672 4674; mul 4670 4675; mul 563 4671; mul 4674 4677; mul 4670 4678; neg 4679; mul 563 4473;
mul 1238 4473; neg 4682; le 12 4460; mul 425 4527; add 436 4685; lt 4449 4686; and 4684 4687; constant -1.0; le 4460
4689; lt 4686 4449; and 4690 4691; or 4688 4692; not 4693; input p 139; mul 425 4695; where 4694 4696; le 12 4463;
and 4687 4698; le 4463 4689; and 4691 4700; or 4699 4701; not 4702; input p 140; mul 425 4704; where 4703 4705; le
12 4467; and 4687 4707; le 4467 4689; and 4691 4709; or 4708 4710; not 4711; input p 141; mul 425 4713; where 4712
4714; le 12 4471; and 4687 4716; le 4471 4689; and 4691 4718; or 4717 4719; not 4720; input p 142; mul 425 4722;
where 4721 4723; mul 350 4094; mul 350 4081; mul 356 4084; add 4726 4727; mul 356 775; add 4728 4729; sub 4725 4730;
mul 350 4166; mul 356 4169; add 4732 4733; mul 356 1414; sub 4734 4735; mul 350 4178; add 4736 4737; mul 350 4246;
mul 356 4249; add 4739 4740; mul 356 1990; sub 4741 4742; mul 350 4258; add 4743 4744; mul 350 4306; mul 350 4297;
mul 356 4295; add 4747 4748; mul 356 2330; add 4749 4750; sub 4746 4751; mul 350 4084; mul 356 4081; sub 4753 4754;
mul 350 775; add 4755 4756; mul 356 4094; add 4757 4758; mul 356 4166; mul 350 4169; sub 4760 4761; mul 350 1414;
add 4762 4763; mul 356 4178; add 4764 4765; mul 356 4246; mul 350 4249; sub 4767 4768; mul 350 1990; add 4769 4770;
mul 356 4258; add 4771 4772; mul 350 4295; mul 356 4297; sub 4774 4775; mul 350 2330; add 4776 4777; mul 356 4306;
add 4778 4779; neg 4094; neg 4178; neg 4258; neg 4306; mul 359 374; mul 755 4785; mul 359 419; mul 738 4787; add
4786 4788; mul 359 403; mul 662 4790; add 4789 4791; mul 359 370; mul 771 4793; add 4792 4794; neg 4795; mul 1379
4787; mul 1394 4785; sub 4797 4798; mul 1255 4790; add 4799 4800; mul 1410 4793; sub 4801 4802; mul 1956 4787; mul
1970 4785; sub 4804 4805; mul 1917 4790; add 4806 4807; mul 1986 4793; sub 4808 4809; mul 2326 4793; mul 2321 4785;
mul 448 4787; add 4812 4813; sub 4811 4814; mul 380 757; mul 380 1396; neg 4817; mul 380 1972; neg 4819; neg 1367;
neg 1944; mul 387 721; mul 387 1367; neg 4824; mul 387 1944; neg 4826; mul 400 718; mul 395 4828; neg 4829; mul 400
1362; mul 395 4831; mul 400 1939; mul 395 4833; mul 385 726; neg 4835; mul 385 1363; mul 385 1940; mul 419 662; mul
405 4839; mul 419 1255; mul 405 4841; neg 4842; mul 419 1917; mul 405 4844; neg 4845; mul 408 4839; mul 408 4841;
neg 4848; mul 408 4844; neg 4850; mul 412 4839; mul 412 4841; neg 4853; mul 412 4844; neg 4855; mul 419 734; mul 419
1375; neg 4858; mul 419 1952; neg 4860; mul 350 4066; mul 356 4068; add 4862 4863; mul 356 655; add 4864 4865; mul
350 4078; sub 4866 4867; mul 356 1326; mul 350 4153; mul 356 4155; add 4870 4871; sub 4869 4872; mul 350 4163; sub
4873 4874; mul 356 1914; mul 350 4232; mul 356 4234; add 4877 4878; sub 4876 4879; mul 350 4243; sub 4880 4881; mul
350 4339; mul 356 4341; add 4883 4884; mul 356 2575; add 4885 4886; mul 350 4350; sub 4887 4888; mul 350 4068; mul
356 4066; sub 4890 4891; mul 350 655; add 4892 4893; mul 356 4078; add 4894 4895; mul 356 4153; mul 350 4155; sub
4897 4898; mul 350 1326; add 4899 4900; mul 356 4163; add 4901 4902; mul 356 4232; mul 350 4234; sub 4904 4905; mul
350 1914; add 4906 4907; mul 356 4243; add 4908 4909; mul 350 4341; mul 356 4339; sub 4911 4912; mul 350 2575; add
4913 4914; mul 356 4350; add 4915 4916; mul 460 475; mul 635 4918; mul 460 516; mul 618 4920; add 4919 4921; mul 460
501; mul 572 4923; add 4922 4924; mul 460 471; mul 651 4926; add 4925 4927; neg 4928; mul 1280 4920; mul 1302 4918;
sub 4930 4931; mul 1248 4923; add 4932 4933; mul 1318 4926; sub 4934 4935; mul 1870 4920; mul 1890 4918; sub 4937
4938; mul 1852 4923; add 4939 4940; mul 1906 4926; sub 4941 4942; mul 2571 4926; mul 2566 4918; mul 534 4920; add
4945 4946; sub 4944 4947; mul 481 637; mul 481 1304; neg 4950; mul 481 1892; neg 4952; neg 1268; neg 1858; mul 485
601; mul 485 1268; neg 4957; mul 485 1858; neg 4959; mul 498 598; mul 493 4961; neg 4962; mul 498 1263; mul 493
4964; mul 498 1853; mul 493 4966; mul 483 606; neg 4968; mul 483 1264; mul 483 1854; mul 516 572; mul 503 4972; mul
516 1248; mul 503 4974; neg 4975; mul 516 1852; mul 503 4977; neg 4978; mul 506 4972; mul 506 4974; neg 4981; mul
506 4977; neg 4983; mul 510 4972; mul 510 4974; neg 4986; mul 510 4977; neg 4988; mul 516 614; mul 516 1276; neg
4991; mul 516 1866; neg 4993; mul 563 4527; sub 4995 28; mul 4460 4996; mul 1238 4527; sub 563 4998; mul 4460 4999;
mul 4463 4996; mul 4463 4999; mul 4467 4996; mul 4467 4999; mul 4471 4996; mul 4471 4999; mul 4686 4695; mul 4695
5007; neg 5008; where 4694 5009; mul 4686 4704; mul 4704 5011; neg 5012; where 4703 5013; mul 4686 4713; mul 4713
5015; neg 5016; where 4712 5017; mul 4686 4722; mul 4722 5019; neg 5020; where 4721 5021; mul 28 4492; neg 5023; mul
563 4492; mul 28 4496; neg 5026; mul 563 4496; mul 29 1235; neg 5029; mul 29 1822; store by_k 79 1237; store by_k
237 1824; store by_k 316 2291; store by_k 395 2542; store by_k 474 2793; store by_k 553 2542; store by_k 632 2793;
store by_k 711 2542; store by_k 790 2793; store by_k 80 2820; store by_k 238 2830; store by_k 317 2870; store by_k
81 2883; store by_k 239 2890; store by_k 318 2897; store by_k 82 2991; store by_k 240 3067; store by_k 319 3104;
store by_k 83 3222; store by_k 241 3311; store by_k 320 3359; store by_k 84 3463; store by_k 242 3546; store by_k
321 3653; store by_k 400 3736; store by_k 479 3819; store by_k 558 3736; store by_k 637 3819; store by_k 716 3736;
store by_k 795 3819; store by_k 85 3877; store by_k 243 3932; store by_k 322 3951; store by_k 86 3960; store by_k
244 3969; store by_k 323 3972; store by_k 402 3975; store by_k 481 3978; store by_k 560 3975; store by_k 639 3978;
store by_k 718 3975; store by_k 797 3978; store by_k 87 3987; store by_k 245 3996; store by_k 324 3999; store by_k
403 4002; store by_k 482 4005; store by_k 561 4002; store by_k 640 4005; store by_k 719 4002; store by_k 798 4005;
store by_k 88 4006; store by_k 246 4007; store by_k 325 4008; store by_k 404 4009; store by_k 483 4010; store by_k
562 4009; store by_k 641 4010; store by_k 720 4009; store by_k 799 4010; store by_k 89 4013; store by_k 247 4016;
store by_k 326 4019; store by_k 405 4022; store by_k 484 4025; store by_k 563 4022; store by_k 642 4025; store by_k
721 4022; store by_k 800 4025; store by_k 90 4026; store by_k 248 4027; store by_k 327 4028; store by_k 406 4029;
store by_k 485 4030; store by_k 564 4029; store by_k 643 4030; store by_k 722 4029; store by_k 801 4030; store by_k
91 4033; store by_k 249 4036; store by_k 328 4039; store by_k 407 4042; store by_k 486 4045; store by_k 565 4042;
store by_k 644 4045; store by_k 723 4042; store by_k 802 4045; store by_k 92 4048; store by_k 250 4051; store by_k
329 4054; store by_k 408 4057; store by_k 487 4060; store by_k 566 4057; store by_k 645 4060; store by_k 724 4057;
store by_k 803 4060; store by_k 93 4061; store by_k 251 4062; store by_k 330 4063; store by_k 409 4064; store by_k
488 4065; store by_k 567 4064; store by_k 646 4065; store by_k 725 4064; store by_k 804 4065; store by_k 94 4151;
store by_k 252 4225; store by_k 331 4294; store by_k 410 4338; store by_k 489 4382; store by_k 568 4338; store by_k
647 4382; store by_k 726 4338; store by_k 805 4382; store by_k 95 4385; store by_k 253 4387; store by_k 96 4396;
store by_k 254 4405; store by_k 97 4411; store by_k 255 4417; store by_k 98 4423; store by_k 256 4429; store by_k 99
4431; store by_k 257 4434; store by_k 100 4555; store by_k 258 4577; store by_k 101 4539; store by_k 259 4565; store
by_k 102 4547; store by_k 260 4578; store by_k 103 4590; store by_k 261 4601; store by_k 104 4613; store by_k 262
4626; store by_k 105 4630; store by_k 263 4634; store by_k 106 4638; store by_k 264 4641; store by_k 343 1851; store
by_k 107 4643; store by_k 265 4644; store by_k 108 28; store by_k 266 4645; store by_k 425 4646; store by_k 504
4647; store by_k 584 4648; store by_k 663 4649; store by_k 743 4650; store by_k 822 4651; store by_k 112 4659; store
by_k 270 4661; store by_k 113 4663; store by_k 271 4664; store by_k 114 4667; store by_k 272 4669; store by_k 115
4676; store by_k 273 4680; store by_k 116 4681; store by_k 274 4683; store by_k 1064 4697; store by_k 1143 4706;
store by_k 1222 4715; store by_k 1301 4724; store by_k 117 4731; store by_k 275 4738; store by_k 354 4745; store
by_k 433 4752; store by_k 591 4752; store by_k 749 4752; store by_k 118 4759; store by_k 276 4766; store by_k 355
4773; store by_k 434 4780; store by_k 592 4780; store by_k 750 4780; store by_k 119 4781; store by_k 277 4782; store
by_k 356 4783; store by_k 435 4784; store by_k 593 4784; store by_k 751 4784; store by_k 120 775; store by_k 278
1414; store by_k 357 1990; store by_k 436 2330; store by_k 594 2330; store by_k 752 2330; store by_k 121 4796; store
by_k 279 4803; store by_k 358 4810; store by_k 437 4815; store by_k 595 4815; store by_k 753 4815; store by_k 122
4816; store by_k 280 4818; store by_k 359 4820; store by_k 123 721; store by_k 281 4821; store by_k 360 4822; store
by_k 124 4823; store by_k 282 4825; store by_k 361 4827; store by_k 125 4830; store by_k 283 4832; store by_k 362
4834; store by_k 126 4836; store by_k 284 4837; store by_k 363 4838; store by_k 127 4840; store by_k 285 4843; store
by_k 364 4846; store by_k 128 4847; store by_k 286 4849; store by_k 365 4851; store by_k 129 4852; store by_k 287
4854; store by_k 366 4856; store by_k 130 4857; store by_k 288 4859; store by_k 367 4861; store by_k 131 4868; store
by_k 289 4875; store by_k 368 4882; store by_k 526 4889; store by_k 684 4889; store by_k 842 4889; store by_k 132
4896; store by_k 290 4903; store by_k 369 4910; store by_k 527 4917; store by_k 685 4917; store by_k 843 4917; store
by_k 133 4078; store by_k 291 4163; store by_k 370 4243; store by_k 528 4350; store by_k 686 4350; store by_k 844
4350; store by_k 134 655; store by_k 292 1326; store by_k 371 1914; store by_k 529 2575; store by_k 687 2575; store
by_k 845 2575; store by_k 135 4929; store by_k 293 4936; store by_k 372 4943; store by_k 530 4948; store by_k 688
4948; store by_k 846 4948; store by_k 136 4949; store by_k 294 4951; store by_k 373 4953; store by_k 137 601; store
by_k 295 4954; store by_k 374 4955; store by_k 138 4956; store by_k 296 4958; store by_k 375 4960; store by_k 139
4963; store by_k 297 4965; store by_k 376 4967; store by_k 140 4969; store by_k 298 4970; store by_k 377 4971; store
by_k 141 4973; store by_k 299 4976; store by_k 378 4979; store by_k 142 4980; store by_k 300 4982; store by_k 379
4984; store by_k 143 4985; store by_k 301 4987; store by_k 380 4989; store by_k 144 4990; store by_k 302 4992; store
by_k 381 4994; store by_k 145 4997; store by_k 303 5000; store by_k 146 5001; store by_k 304 5002; store by_k 147
5003; store by_k 305 5004; store by_k 148 5005; store by_k 306 5006; store by_k 1097 5010; store by_k 1177 5014;
store by_k 1257 5018; store by_k 1337 5022; store by_k 153 5024; store by_k 311 5025; store by_k 154 5027; store
by_k 312 5028; store by_k 945 4492; store by_k 1025 4496; store by_k 157 5030; store by_k 315 5031
    """,
)
