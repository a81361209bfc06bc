"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 75},
    {'p': 201},
    """
input k 74; input k 0; constant 1.0; div 2 1; mul 0 3; constant -2.0; input k 2; mul 5 6; input k 33; input k 1;
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
input k 18; input k 17; input k 16; input k 27; input k 41; input k 36; input k 15; sub 156 2; input k 38; input k
37; input k 39; sub 160 1; constant 8.118473726939319e-05; input k 5; mul 162 163; constant -0.0004787100025195255;
mul 163 165; constant 0.0013605442176870743; mul 163 167; constant -0.003571428571428574; mul 163 169; constant
0.007142857142857142; mul 163 171; constant -0.0006802721088435403; mul 163 173; constant 0.0035714285714285787; mul
163 175; constant 0.014965986394557814; mul 163 177; constant -0.04285714285714284; mul 163 179; constant
0.06428571428571427; mul 163 181; constant -0.12857142857142845; mul 163 183; constant 0.2571428571428571; mul 163
185; input k 9; input k 10; input k 12; input k 11; input k 13; input k 14; input k 40; div 2 193; input k 42; input
k 43; input k 44; input k 45; input k 46; input k 47; input k 48; constant 0.029931972789115628; mul 163 202;
constant -0.08571428571428567; mul 163 204; constant 0.12857142857142853; mul 163 206; constant
-0.38571428571428534; mul 163 208; constant 1.0285714285714285; mul 163 210; constant 0.0027210884353741486; mul 163
212; constant -0.010714285714285721; mul 163 214; constant 0.028571428571428567; mul 163 216; constant
0.010714285714285735; mul 163 218; input k 54; input k 50; input k 49; input k 51; input k 52; sub 224 1; input k
53; div 2 226; input k 55; input k 56; input k 57; input k 58; input k 59; input k 60; input k 61; constant -6.0;
constant 4.0; input k 29; input k 62; input k 63; input k 64; input k 65; input k 34; input k 70; input k 71; input
k 24; input k 25; input k 21; mul 149 246; input k 26; input k 23; input k 22; input k 20; input k 28; mul 153 253;
input k 35; constant 0.8000000000000002; constant 2.400000000000001; mul 15 257; add 256 258; constant
0.01904761904761903; mul 20 260; add 259 261; constant -1.3714285714285723; mul 26 263; constant 1.3714285714285714;
mul 14 265; constant 0.007256235827664418; mul 19 267; add 266 268; constant -4.799999999999999; mul 26 270;
constant 1.3714285714285692; mul 14 272; constant -0.05714285714285729; mul 19 274; add 273 275; constant
-7.199999999999996; mul 26 277; constant 7.199999999999994; mul 14 279; constant 0.2190476190476189; mul 19 281; add
280 282; constant -45.25714285714286; mul 14 284; constant -0.11428571428571327; mul 19 286; add 285 287; constant
-28.800000000000004; mul 26 289; constant 0.00032473894907757275; mul 163 291; constant -0.0014361300075585765; mul
163 293; constant -0.0013605442176870806; mul 163 295; constant 0.8; mul 6 297; div 2 298; input k 30; input k 31;
input k 32; input k 72; input k 73; input k 66; div 2 305; input k 67; div 2 307; input k 68; div 2 309; input k 69;
div 2 311; mul 3 23; mul 22 313; mul 3 51; mul 102 313; mul 3 22; mul 18 313; mul 3 49; mul 100 313; mul 3 18; mul 3
187; mul 3 188; mul 3 189; add 243 244; mul 246 247; mul 245 247; mul 88 313; mul 87 313; mul 3 97; mul 235 313; add
330 331; mul 6 332; mul 3 235; mul 236 313; add 334 335; mul 6 336; mul 23 337; add 333 338; mul 24 337; mul 22 24;
mul 24 102; mul 18 24; mul 24 100; mul 247 249; mul 24 88; mul 24 87; mul 24 235; mul 6 348; mul 24 236; mul 6 350;
mul 23 351; add 349 352; mul 24 351; mul 255 306; mul 255 308; mul 255 310; mul 255 312; neg 300; neg 301; neg 302;
neg 303; neg 304; mul 238 255; mul 239 255; mul 240 255; mul 241 255; mul 3 4; mul 9 299; mul 142 369; mul 58 369;
mul 290 369; mul 39 369; mul 288 369; mul 27 369; mul 283 369; mul 109 369; mul 278 369; mul 276 369; mul 271 369;
mul 88 369; mul 12 149; store p 0 4; store p 1 7; store p 2 8; store p 3 3; store p 4 9; store p 5 22; store p 6 23;
store p 7 24; store p 8 27; store p 9 32; store p 10 34; store p 11 39; store p 12 44; store p 13 51; store p 14 53;
store p 15 58; store p 16 60; store p 17 65; store p 18 70; store p 19 75; store p 20 80; store p 21 86; store p 22
88; store p 23 90; store p 24 95; store p 25 102; store p 26 104; store p 27 109; store p 28 113; store p 29 118;
store p 30 123; store p 31 125; store p 32 130; store p 33 135; store p 34 137; store p 35 142; store p 36 147;
store p 37 148; store p 38 150; store p 39 151; store p 40 152; store p 41 1; store p 42 187; store p 43 188; store
p 44 189; store p 45 174; store p 46 176; store p 47 203; store p 48 205; store p 49 207; store p 50 209; store p 51
211; store p 52 166; store p 53 213; store p 54 215; store p 55 217; store p 56 219; store p 57 180; store p 58 184;
store p 59 153; store p 60 161; store p 61 164; store p 62 168; store p 63 170; store p 64 172; store p 65 178;
store p 66 182; store p 67 186; store p 68 190; store p 69 191; store p 70 192; store p 71 157; store p 72 156;
store p 73 159; store p 74 155; store p 75 194; store p 76 158; store p 77 154; store p 78 195; store p 79 196;
store p 80 197; store p 81 198; store p 82 199; store p 83 200; store p 84 201; store p 85 225; store p 86 221;
store p 87 222; store p 88 227; store p 89 223; store p 90 220; store p 91 228; store p 92 229; store p 93 230;
store p 94 231; store p 95 232; store p 96 233; store p 97 234; store p 98 6; store p 99 237; store p 100 238; store
p 101 239; store p 102 240; store p 103 241; store p 104 242; store p 105 243; store p 106 244; store p 107 245;
store p 108 246; store p 109 247; store p 110 248; store p 111 249; store p 112 250; store p 113 251; store p 114
252; store p 115 254; store p 116 255; store p 117 262; store p 118 264; store p 119 269; store p 120 271; store p
121 276; store p 122 278; store p 123 283; store p 124 288; store p 125 290; store p 126 292; store p 127 294; store
p 128 296; store p 129 299; store p 130 300; store p 131 301; store p 132 302; store p 133 303; store p 134 304;
store p 135 306; store p 136 308; store p 137 310; store p 138 312; store p 139 314; store p 140 313; store p 141
315; store p 142 316; store p 143 317; store p 144 318; store p 145 319; store p 146 320; store p 147 321; store p
148 322; store p 149 323; store p 150 324; store p 151 325; store p 152 326; store p 153 327; store p 154 328; store
p 155 329; store p 156 339; store p 157 340; store p 158 341; store p 159 342; store p 160 343; store p 161 344;
store p 162 345; store p 163 346; store p 164 347; store p 165 353; store p 166 354; store p 167 355; store p 168
356; store p 169 357; store p 170 358; store p 171 359; store p 172 360; store p 173 361; store p 174 362; store p
175 363; store p 176 364; store p 177 365; store p 178 366; store p 179 367; store p 180 368; store p 181 370; store
p 182 371; store p 183 372; store p 184 373; store p 185 374; store p 186 375; store p 187 376; store p 188 377;
store p 189 378; store p 190 379; store p 191 380; store p 192 381; store p 193 13; store p 194 12; store p 195 369;
store p 196 83; store p 197 14; store p 198 382; store p 199 19; store p 200 253
    """,
)

JACOBIAN = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 201},
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
input p 78; constant 1.4; sub 397 410; mul 409 411; add 364 412; mul 408 413; input p 79; mul 3 415; input p 80; mul
411 417; add 364 418; mul 416 419; sub 414 420; mul 386 421; input p 81; input x 5; mul 423 424; input p 82; input x
7; mul 426 427; add 425 428; input p 83; input x 9; mul 430 431; add 429 432; constant -0.5; mul 399 434; mul 399
435; mul 399 436; mul 386 437; mul 433 438; add 422 439; input p 84; mul 438 441; mul 438 442; sub 379 384; mul 392
444; add 387 390; mul 385 446; sub 445 447; mul 401 448; div 364 373; mul 376 450; mul 449 451; mul 42 452; mul 392
401; mul 0 454; sub 453 455; mul 0 56; mul 285 457; mul 62 281; add 349 459; mul 215 460; mul 42 461; add 458 462;
mul 402 463; add 456 464; mul 443 465; add 440 466; mul 402 467; input p 85; add 362 469; input p 86; mul 377 471;
add 470 472; input p 87; mul 383 474; add 473 475; input p 88; mul 383 471; mul 377 474; input p 89; sub 479 480;
sub 478 481; sub 482 12; mul 483 483; mul 476 476; add 484 485; sqrt 486; mul 477 487; sqrt 488; div 364 489; mul
490 490; mul 477 491; mul 476 492; input p 90; mul 193 488; mul 193 491; mul 491 496; sub 495 497; mul 494 498;
input p 91; sub 488 410; mul 500 501; add 364 502; mul 499 503; input p 92; mul 7 505; input p 93; mul 501 507; add
364 508; mul 506 509; sub 504 510; mul 477 511; input p 94; input x 6; mul 513 514; input p 95; input x 8; mul 516
517; add 515 518; input p 96; input x 10; mul 520 521; add 519 522; mul 434 490; mul 490 524; mul 490 525; mul 477
526; mul 523 527; add 512 528; input p 97; mul 527 530; mul 527 531; add 472 475; mul 483 533; sub 479 478; mul 476
535; add 534 536; mul 492 537; mul 451 538; mul 42 539; mul 483 492; mul 0 541; sub 540 542; mul 463 493; add 543
544; mul 532 545; add 529 546; mul 493 547; add 468 548; sub 286 549; mul 285 550; sub 214 551; input p 98; constant
12.0; mul 457 554; constant -6.0; mul 59 457; mul 42 62; add 557 558; mul 556 559; add 555 560; mul 553 561; mul 457
556; constant 4.0; mul 559 564; add 563 565; mul 553 566; mul 59 567; add 562 568; add 552 569; mul 56 570; mul 454
467; mul 541 547; add 572 573; sub 571 574; sub 55 575; input p 99; input p 100; input z 0; mul 578 579; input p
101; input z 1; mul 581 582; add 580 583; input p 102; input z 2; mul 585 586; add 584 587; input p 103; input z 3;
mul 589 590; add 588 591; sub 577 592; input p 104; abs 0; mul 594 595; mul 0 596; sub 593 597; add 576 598; input p
105; input x 11; sub 12 601; mul 600 602; input p 106; input x 12; sub 12 605; mul 604 606; add 603 607; sub 599
608; input p 107; mul 12 610; input p 108; mul 10 612; add 611 613; input p 109; mul 0 610; input p 110; mul 42 617;
add 616 618; mul 0 619; input p 111; mul 42 621; mul 42 622; add 620 623; mul 615 624; mul 614 625; sub 609 626;
input p 112; mul 12 612; mul 10 621; add 629 630; mul 615 631; mul 631 632; add 628 633; mul 627 634; input p 113;
mul 614 615; mul 631 637; add 636 638; mul 62 175; mul 57 640; abs 10; lt 642 183; mul 186 193; mul 187 193; input p
114; mul 645 646; mul 644 647; mul 182 192; mul 187 649; add 648 650; mul 186 649; mul 644 652; add 651 653; mul 195
199; mul 644 655; add 654 656; mul 192 199; mul 200 658; add 657 659; mul 57 660; where 643 661; add 641 662; mul
461 550; sub 663 664; mul 62 567; add 665 666; mul 452 467; mul 539 547; add 668 669; add 667 670; sub 46 671; input
p 115; mul 383 673; mul 451 674; add 672 675; input p 116; mul 592 677; sub 676 678; mul 625 631; sub 679 680; mul
639 681; sub 635 682; mul 614 614; add 364 684; mul 615 685; mul 634 686; mul 639 639; sub 687 688; div 364 689; mul
683 690; mul 681 686; mul 627 639; sub 692 693; mul 690 694; input p 117; mul 67 696; input p 118; mul 124 698; add
697 699; input p 119; mul 128 701; add 700 702; mul 64 120; add 703 704; input p 120; mul 68 706; add 705 707; input
p 121; mul 72 709; add 708 710; input p 122; mul 76 712; add 711 713; mul 80 137; add 714 715; input p 123; mul 84
717; add 716 718; mul 66 99; add 719 720; input p 124; mul 103 722; add 721 723; mul 79 107; add 724 725; input p
125; mul 111 727; add 726 728; mul 94 168; add 729 730; mul 112 167; add 731 732; mul 57 733; constant
0.01904761904761903; mul 67 735; input p 126; mul 128 737; add 736 738; mul 64 250; add 739 740; input p 127; mul 72
742; add 741 743; mul 80 258; add 744 745; mul 84 306; add 746 747; input p 128; mul 103 749; add 748 750; mul 168
235; add 751 752; mul 112 274; add 753 754; add 357 755; mul 215 756; mul 550 757; sub 734 758; input p 129; mul 759
760; neg 761; mul 438 465; input p 130; mul 424 764; sub 763 765; mul 527 545; mul 514 764; sub 767 768; input p
131; mul 427 770; sub 763 771; mul 517 770; sub 767 773; input p 132; mul 431 775; sub 763 776; mul 521 775; sub 767
778; input p 133; mul 602 780; input p 134; mul 606 782; le 364 579; mul 42 677; add 0 785; lt 52 786; and 784 787;
constant -1.0; le 579 789; lt 786 52; and 790 791; or 788 792; not 793; input p 135; mul 786 795; where 794 796; le
364 582; and 787 798; le 582 789; and 791 800; or 799 801; not 802; input p 136; mul 786 804; where 803 805; le 364
586; and 787 807; le 586 789; and 791 809; or 808 810; not 811; input p 137; mul 786 813; where 812 814; le 364 590;
and 787 816; le 590 789; and 791 818; or 817 819; not 820; input p 138; mul 786 822; where 821 823; mul 11 18; mul
14 825; mul 11 26; sub 826 827; mul 11 30; mul 11 829; sub 828 830; input p 139; input p 140; mul 67 833; mul 66
834; add 832 835; mul 67 834; mul 71 837; add 836 838; mul 64 193; mul 833 840; mul 75 841; add 839 842; mul 67 841;
mul 79 844; add 843 845; mul 64 841; mul 76 833; add 847 848; mul 83 849; add 846 850; input p 141; add 851 852; mul
56 67; mul 90 854; add 853 855; mul 67 854; mul 94 857; add 856 858; mul 56 64; mul 60 833; add 860 861; mul 98 862;
add 859 863; mul 67 862; mul 102 865; add 864 866; mul 64 862; mul 99 833; add 868 869; mul 106 870; add 867 871;
mul 60 193; mul 56 873; mul 64 874; mul 111 833; add 875 876; mul 110 877; add 872 878; mul 60 874; mul 56 111; add
880 881; mul 115 882; add 879 883; input p 142; mul 134 834; add 885 886; mul 137 837; add 887 888; mul 140 841; add
889 890; mul 143 844; add 891 892; mul 146 849; add 893 894; input p 143; add 895 896; mul 66 854; add 897 898; mul
71 857; add 899 900; mul 155 862; add 901 902; mul 158 865; add 903 904; mul 161 870; add 905 906; mul 164 874; add
907 908; mul 67 874; mul 167 910; add 909 911; mul 106 877; add 912 913; mul 173 882; add 914 915; mul 59 916; add
884 917; mul 57 918; le 191 180; le 180 191; add 920 921; div 364 922; mul 920 923; le 190 60; le 60 190; add 925
926; div 364 927; mul 925 928; mul 56 929; mul 924 930; mul 193 931; mul 196 932; mul 194 931; mul 201 934; add 933
935; mul 204 932; mul 201 931; mul 194 938; add 937 939; add 936 940; mul 209 932; mul 193 934; mul 208 943; mul 194
944; add 942 945; add 941 946; mul 57 947; where 181 948; add 919 949; input p 144; mul 226 837; add 951 952; mul
229 849; add 953 954; input p 145; add 955 956; mul 235 857; add 957 958; mul 238 865; add 959 960; mul 241 870; add
961 962; mul 244 877; add 963 964; mul 247 882; add 965 966; input p 146; mul 258 837; add 968 969; mul 261 844; add
970 971; mul 264 849; add 972 973; input p 147; add 974 975; mul 226 857; add 976 977; mul 271 870; add 978 979; mul
274 910; add 980 981; mul 241 877; add 982 983; mul 279 882; add 984 985; mul 59 986; add 967 987; input p 148; add
988 989; mul 215 990; mul 550 991; mul 193 385; mul 250 834; mul 67 837; mul 252 995; add 994 996; mul 299 841; add
997 998; mul 67 844; mul 302 1000; add 999 1001; mul 67 849; mul 306 1003; add 1002 1004; mul 64 849; mul 84 833;
add 1006 1007; mul 310 1008; add 1005 1009; mul 224 862; add 1010 1011; mul 67 865; mul 226 1013; add 1012 1014; mul
64 870; mul 107 833; add 1016 1017; mul 229 1018; add 1015 1019; mul 183 874; add 1020 1021; mul 67 910; mul 324
1023; add 1022 1024; mul 67 877; mul 274 1026; add 1025 1027; mul 64 877; mul 112 833; add 1029 1030; mul 331 1031;
add 1028 1032; mul 64 882; mul 116 833; add 1034 1035; mul 279 1036; add 1033 1037; mul 60 882; mul 56 116; add 1039
1040; mul 338 1041; add 1038 1042; mul 60 989; mul 56 223; add 1044 1045; input p 149; mul 10 1047; add 1046 1048;
input p 150; mul 67 1050; add 1049 1051; mul 16 1052; add 1043 1053; mul 215 1054; mul 993 1055; mul 193 392; sub
1056 1057; mul 193 396; div 364 1059; mul 1058 1060; mul 386 1061; mul 193 1062; mul 193 399; mul 193 398; div 364
1065; mul 1062 1066; mul 400 1067; mul 1064 1068; neg 1069; mul 193 1070; mul 400 1071; mul 405 1069; sub 1072 1073;
sub 1063 1074; mul 403 1075; mul 413 1076; mul 409 1062; mul 408 1078; add 1077 1079; mul 417 1062; mul 416 1081;
sub 1080 1082; mul 386 1083; mul 436 1067; mul 399 1085; mul 437 1067; add 1086 1087; mul 399 1088; mul 399 437; mul
1067 1090; add 1089 1091; mul 386 1092; mul 433 1093; sub 1084 1094; mul 386 1069; mul 392 1096; add 401 1097; mul 0
1098; mul 446 1055; add 444 1100; mul 401 1101; mul 448 1096; add 1102 1103; mul 451 1104; mul 42 1105; sub 1099
1106; mul 401 1055; mul 385 1096; sub 1108 1109; mul 463 1110; mul 457 991; mul 62 986; add 1047 1113; mul 215 1114;
mul 42 1115; add 1112 1116; mul 402 1117; add 1111 1118; add 1107 1119; mul 443 1120; mul 441 1093; mul 438 1122;
mul 442 1093; add 1123 1124; mul 465 1125; sub 1121 1126; add 1095 1127; mul 402 1128; mul 467 1110; add 1129 1130;
mul 193 476; mul 1055 1132; mul 193 483; sub 1133 1134; mul 193 487; div 364 1136; mul 1135 1137; mul 477 1138; mul
193 1139; mul 193 490; mul 193 489; div 364 1142; mul 1139 1143; mul 491 1144; mul 1141 1145; neg 1146; mul 193
1147; mul 491 1148; mul 496 1146; sub 1149 1150; sub 1140 1151; mul 494 1152; mul 503 1153; mul 500 1139; mul 499
1155; add 1154 1156; mul 507 1139; mul 506 1158; sub 1157 1159; mul 477 1160; mul 525 1144; mul 490 1162; mul 526
1144; add 1163 1164; mul 490 1165; mul 490 526; mul 1144 1167; add 1166 1168; mul 477 1169; mul 523 1170; sub 1161
1171; mul 535 1055; sub 1173 533; mul 492 1174; mul 477 1146; mul 537 1176; sub 1175 1177; mul 451 1178; mul 42
1179; mul 483 1176; add 492 1181; mul 0 1182; add 1180 1183; mul 492 1055; mul 476 1176; sub 1185 1186; mul 463
1187; mul 493 1117; add 1188 1189; add 1184 1190; mul 532 1191; mul 530 1170; mul 527 1193; mul 531 1170; add 1194
1195; mul 545 1196; sub 1192 1197; add 1172 1198; mul 493 1199; mul 547 1187; add 1200 1201; add 1131 1202; mul 285
1203; sub 992 1204; sub 950 1205; mul 56 1206; mul 454 1128; mul 467 1098; sub 1208 1209; mul 541 1199; mul 547
1182; sub 1211 1212; add 1210 1213; sub 1207 1214; sub 831 1215; input p 151; sub 1216 1217; mul 610 625; sub 1218
1219; mul 634 1220; input p 152; mul 631 1222; mul 612 632; add 1223 1224; mul 627 1225; add 1221 1226; input p 153;
mul 631 1228; mul 612 637; add 1229 1230; mul 681 1231; mul 62 916; mul 57 1233; mul 182 931; mul 187 1235; mul 186
1235; mul 644 1237; add 1236 1238; mul 195 934; mul 644 1240; add 1239 1241; mul 199 931; mul 192 934; add 1243
1244; mul 200 1245; add 1242 1246; mul 57 1247; where 643 1248; add 1234 1249; mul 550 1115; mul 461 1203; sub 1251
1252; sub 1250 1253; mul 452 1128; mul 467 1105; sub 1255 1256; mul 539 1199; mul 547 1179; add 1258 1259; add 1257
1260; add 1254 1261; sub 829 1262; mul 612 625; sub 1263 1264; mul 639 1265; add 1232 1266; sub 1227 1267; mul 690
1268; mul 690 691; mul 193 614; mul 610 1271; mul 615 1272; mul 634 1273; mul 686 1225; add 1274 1275; mul 193 639;
mul 1231 1277; sub 1276 1278; mul 1270 1279; sub 1269 1280; mul 634 690; input c_q 0; mul 1282 1283; le 52 51; le 51
52; add 1285 1286; div 364 1287; mul 1285 1288; mul 0 1282; mul 1289 1290; input c_q 1; mul 1291 1292; sub 1284
1293; mul 3 1282; input c_q 2; mul 1295 1296; add 1294 1297; mul 7 1282; input c_q 3; mul 1299 1300; add 1298 1301;
mul 639 690; mul 11 1282; add 1303 1304; input c_q 4; mul 1305 1306; sub 1302 1307; mul 14 1305; input c_q 5; mul
1309 1310; add 1308 1311; mul 3 1305; input c_q 6; mul 1313 1314; sub 1312 1315; mul 7 1305; input c_q 7; mul 1317
1318; sub 1316 1319; le 40 39; le 39 40; add 1321 1322; div 364 1323; mul 1321 1324; mul 44 1305; mul 1325 1326;
input c_q 8; mul 1327 1328; add 1320 1329; mul 14 1282; input c_q 9; mul 1331 1332; add 1330 1333; mul 14 1331; mul
16 1335; input c_q 10; mul 1336 1337; sub 1334 1338; mul 3 1331; input c_q 11; mul 1340 1341; add 1339 1342; mul 7
1331; input c_q 12; mul 1344 1345; add 1343 1346; add 1281 1347; mul 686 1265; mul 681 1273; add 1349 1350; mul 627
1231; mul 639 1220; add 1352 1353; sub 1351 1354; mul 690 1355; mul 690 695; mul 1279 1357; sub 1356 1358; mul 0
1303; mul 1289 1360; mul 1292 1361; mul 1283 1303; sub 1362 1363; mul 3 1303; mul 1296 1365; sub 1364 1366; mul 7
1303; mul 1300 1368; sub 1367 1369; mul 686 690; mul 11 1303; add 1371 1372; mul 1306 1373; add 1370 1374; mul 14
1373; mul 1310 1376; sub 1375 1377; mul 3 1373; mul 1314 1379; add 1378 1380; mul 7 1373; mul 1318 1382; add 1381
1383; mul 44 1373; mul 1325 1385; mul 1328 1386; sub 1384 1387; mul 14 1303; mul 1332 1389; sub 1388 1390; mul 14
1389; mul 16 1392; mul 1337 1393; add 1391 1394; mul 3 1389; mul 1341 1396; sub 1395 1397; mul 7 1389; mul 1345
1399; sub 1398 1400; add 1359 1401; input p 154; mul 706 834; add 1403 1404; mul 709 837; add 1405 1406; mul 712
841; add 1407 1408; mul 137 844; add 1409 1410; mul 717 849; add 1411 1412; mul 66 862; add 1413 1414; mul 722 865;
add 1415 1416; mul 79 870; add 1417 1418; mul 727 874; add 1419 1420; mul 94 910; add 1421 1422; mul 167 877; add
1423 1424; mul 57 1425; input p 155; mul 742 837; add 1427 1428; mul 258 844; add 1429 1430; mul 306 849; add 1431
1432; mul 749 865; add 1433 1434; mul 235 910; add 1435 1436; mul 274 877; add 1437 1438; add 1050 1439; mul 215
1440; mul 550 1441; mul 757 1203; sub 1442 1443; sub 1426 1444; mul 760 1445; neg 1446; mul 438 1120; mul 465 1093;
sub 1448 1449; mul 527 1191; mul 545 1170; sub 1451 1452; mul 11 41; mul 11 1454; add 53 1455; mul 284 402; sub 1457
454; mul 443 1458; mul 402 1459; mul 284 493; sub 1461 541; mul 532 1462; mul 493 1463; add 1460 1464; mul 285 1465;
input p 156; add 1466 1467; mul 56 1468; mul 454 1459; mul 541 1463; add 1470 1471; sub 1469 1472; add 1456 1473;
sign 0; mul 594 1475; mul 0 1476; add 596 1477; add 1474 1478; add 616 619; mul 615 1480; mul 614 1481; add 1479
1482; mul 634 1483; mul 461 1465; input p 157; add 1485 1486; mul 452 1459; mul 539 1463; add 1488 1489; add 1487
1490; sub 1454 1491; mul 631 1481; sub 1492 1493; mul 639 1494; add 1484 1495; mul 690 1496; neg 1497; mul 686 1494;
mul 639 1483; add 1499 1500; mul 690 1501; mul 757 1465; mul 760 1503; neg 1504; mul 438 1458; mul 527 1462; where
794 795; where 803 804; where 812 813; where 821 822; sub 26 19; add 829 1512; input p 158; mul 62 67; mul 66 1515;
add 1514 1516; mul 67 1515; mul 71 1518; add 1517 1519; mul 62 840; mul 75 1521; add 1520 1522; mul 67 1521; mul 79
1524; add 1523 1525; mul 64 1521; mul 62 76; add 1527 1528; mul 83 1529; add 1526 1530; mul 60 62; mul 98 1532; add
1531 1533; mul 67 1532; mul 102 1535; add 1534 1536; mul 64 1532; mul 62 99; add 1538 1539; mul 106 1540; add 1537
1541; mul 62 111; mul 110 1543; add 1542 1544; input p 159; mul 134 1515; add 1546 1547; mul 137 1518; add 1548
1549; mul 140 1521; add 1550 1551; mul 143 1524; add 1552 1553; mul 146 1529; add 1554 1555; mul 155 1532; add 1556
1557; mul 158 1535; add 1558 1559; mul 161 1540; add 1560 1561; mul 106 1543; add 1562 1563; mul 59 1564; add 1545
1565; mul 57 1566; le 185 183; le 183 185; add 1568 1569; div 364 1570; mul 1568 1571; le 184 10; le 10 184; add
1573 1574; div 364 1575; mul 1573 1576; mul 1572 1577; mul 187 1578; mul 644 1578; mul 186 1580; add 1579 1581; mul
182 1582; mul 195 1580; mul 194 1584; add 1583 1585; mul 200 1578; mul 199 1587; add 1586 1588; mul 192 1587; mul
194 1590; add 1589 1591; mul 57 1592; where 181 1593; add 1567 1594; input p 160; mul 226 1518; add 1596 1597; mul
229 1529; add 1598 1599; mul 238 1535; add 1600 1601; mul 241 1540; add 1602 1603; mul 244 1543; add 1604 1605;
input p 161; mul 258 1518; add 1607 1608; mul 261 1524; add 1609 1610; mul 264 1529; add 1611 1612; mul 271 1540;
add 1613 1614; mul 241 1543; add 1615 1616; mul 59 1617; add 1606 1618; add 218 1619; mul 215 1620; mul 550 1621;
mul 193 366; mul 376 1623; mul 376 377; mul 370 450; mul 374 1626; div 364 374; mul 366 1628; mul 373 1629; add 1627
1630; mul 1625 1631; sub 1624 1632; mul 381 1633; mul 10 1629; add 374 1635; mul 376 1636; mul 376 383; mul 1631
1638; sub 1637 1639; mul 378 1640; add 1634 1641; mul 1057 1642; mul 250 1515; mul 67 1518; mul 252 1645; add 1644
1646; mul 299 1521; add 1647 1648; mul 67 1524; mul 302 1650; add 1649 1651; mul 67 1529; mul 306 1653; add 1652
1654; mul 64 1529; mul 62 84; add 1656 1657; mul 310 1658; add 1655 1659; mul 224 1532; add 1660 1661; mul 67 1535;
mul 226 1663; add 1662 1664; mul 64 1540; mul 62 107; add 1666 1667; mul 229 1668; add 1665 1669; mul 67 1543; mul
274 1671; add 1670 1672; mul 64 1543; mul 62 112; add 1674 1675; mul 331 1676; add 1673 1677; mul 62 116; mul 279
1679; add 1678 1680; add 345 349; add 343 1682; add 348 1683; mul 16 1684; add 1681 1685; mul 215 1686; mul 378
1633; add 1687 1688; mul 381 1640; sub 1689 1690; mul 993 1691; add 1643 1692; mul 1060 1693; mul 386 1694; mul 193
1695; mul 1066 1695; mul 400 1697; mul 1064 1698; neg 1699; mul 193 1700; mul 400 1701; mul 405 1699; sub 1702 1703;
sub 1696 1704; mul 403 1705; mul 413 1706; mul 409 1695; mul 408 1708; add 1707 1709; mul 417 1695; mul 416 1711;
sub 1710 1712; mul 386 1713; mul 436 1697; mul 399 1715; mul 437 1697; add 1716 1717; mul 399 1718; mul 1090 1697;
add 1719 1720; mul 386 1721; mul 433 1722; sub 1714 1723; mul 444 1642; sub 1688 1690; mul 392 1726; add 1725 1727;
mul 446 1691; mul 385 1642; add 1729 1730; sub 1728 1731; mul 401 1732; mul 386 1699; mul 448 1734; sub 1733 1735;
mul 451 1736; mul 450 450; mul 1626 1738; mul 376 1739; mul 376 451; mul 1631 1741; add 1740 1742; mul 449 1743; sub
1737 1744; mul 42 1745; mul 401 1642; mul 392 1734; sub 1747 1748; mul 0 1749; sub 1746 1750; mul 401 1691; mul 385
1734; sub 1752 1753; mul 463 1754; mul 457 1621; mul 62 1617; add 344 1757; mul 215 1758; mul 42 1759; add 1756
1760; mul 402 1761; add 1755 1762; add 1751 1763; mul 443 1764; mul 441 1722; mul 438 1766; mul 442 1722; add 1767
1768; mul 465 1769; sub 1765 1770; add 1724 1771; mul 402 1772; mul 467 1754; add 1773 1774; mul 471 1640; mul 474
1633; sub 1776 1777; mul 1134 1778; mul 471 1633; add 1687 1780; mul 474 1640; add 1781 1782; mul 1132 1783; add
1779 1784; mul 1137 1785; mul 477 1786; mul 193 1787; mul 1143 1787; mul 491 1789; mul 1141 1790; neg 1791; mul 193
1792; mul 491 1793; mul 496 1791; sub 1794 1795; sub 1788 1796; mul 494 1797; mul 503 1798; mul 500 1787; mul 499
1800; add 1799 1801; mul 507 1787; mul 506 1803; sub 1802 1804; mul 477 1805; mul 525 1789; mul 490 1807; mul 526
1789; add 1808 1809; mul 490 1810; mul 1167 1789; add 1811 1812; mul 477 1813; mul 523 1814; sub 1806 1815; mul 533
1778; add 1780 1782; mul 483 1818; add 1817 1819; mul 535 1783; sub 1777 1776; mul 476 1822; add 1821 1823; add 1820
1824; mul 492 1825; mul 477 1791; mul 537 1827; sub 1826 1828; mul 451 1829; mul 538 1743; sub 1830 1831; mul 42
1832; mul 492 1778; mul 483 1827; sub 1834 1835; mul 0 1836; sub 1833 1837; mul 492 1783; mul 476 1827; sub 1839
1840; mul 463 1841; mul 493 1761; add 1842 1843; add 1838 1844; mul 532 1845; mul 530 1814; mul 527 1847; mul 531
1814; add 1848 1849; mul 545 1850; sub 1846 1851; add 1816 1852; mul 493 1853; mul 547 1841; add 1854 1855; add 1775
1856; mul 285 1857; sub 1622 1858; sub 1595 1859; mul 56 1860; mul 454 1772; mul 467 1749; add 1862 1863; mul 541
1853; mul 547 1836; add 1865 1866; add 1864 1867; sub 1861 1868; sub 1513 1869; sub 1870 1264; mul 634 1871; input p
162; mul 631 1873; mul 621 632; add 1874 1875; mul 627 1876; add 1872 1877; mul 621 637; add 1223 1879; mul 681
1880; mul 673 1640; mul 451 1882; mul 674 1743; sub 1883 1884; mul 62 1564; mul 57 1886; mul 193 1578; mul 647 1888;
mul 193 1580; mul 646 1890; mul 644 1891; add 1889 1892; mul 649 1580; add 1893 1894; mul 652 1888; mul 649 1578;
mul 644 1897; add 1896 1898; add 1895 1899; mul 655 1888; add 1900 1901; mul 57 1902; where 643 1903; add 1887 1904;
mul 550 1759; mul 461 1857; sub 1906 1907; sub 1905 1908; mul 452 1772; mul 467 1745; add 1910 1911; mul 539 1853;
mul 547 1832; add 1913 1914; add 1912 1915; add 1909 1916; add 30 1917; sub 1885 1918; mul 621 625; sub 1919 1920;
mul 639 1921; add 1881 1922; sub 1878 1923; mul 690 1924; mul 612 1271; mul 615 1926; mul 634 1927; mul 686 1876;
add 1928 1929; mul 1277 1880; sub 1930 1931; mul 1270 1932; sub 1925 1933; mul 686 1921; mul 681 1927; add 1935
1936; mul 627 1880; mul 639 1871; add 1938 1939; sub 1937 1940; mul 690 1941; mul 1357 1932; sub 1942 1943; input p
163; mul 706 1515; add 1945 1946; mul 709 1518; add 1947 1948; mul 712 1521; add 1949 1950; mul 137 1524; add 1951
1952; mul 717 1529; add 1953 1954; mul 66 1532; add 1955 1956; mul 722 1535; add 1957 1958; mul 79 1540; add 1959
1960; mul 167 1543; add 1961 1962; mul 57 1963; input p 164; mul 742 1518; add 1965 1966; mul 258 1524; add 1967
1968; mul 306 1529; add 1969 1970; mul 749 1535; add 1971 1972; mul 274 1543; add 1973 1974; add 347 1975; mul 215
1976; mul 550 1977; mul 757 1857; sub 1978 1979; sub 1964 1980; mul 760 1981; neg 1982; mul 438 1764; mul 465 1722;
sub 1984 1985; mul 527 1845; mul 545 1814; sub 1987 1988; mul 402 461; add 452 1990; mul 443 1991; mul 402 1992; mul
461 493; add 539 1994; mul 532 1995; mul 493 1996; add 1993 1997; mul 285 1998; input p 165; add 1999 2000; mul 56
2001; mul 454 1992; mul 541 1996; add 2003 2004; sub 2002 2005; sub 1454 2006; mul 0 617; mul 193 622; add 2008
2009; mul 615 2010; mul 614 2011; sub 2007 2012; mul 634 2013; mul 461 1998; input p 166; add 2015 2016; mul 452
1992; mul 539 1996; add 2018 2019; add 2017 2020; add 41 2021; mul 631 2011; add 2022 2023; mul 639 2024; add 2014
2025; mul 690 2026; mul 686 2024; mul 639 2013; add 2028 2029; mul 690 2030; neg 2031; mul 757 1998; mul 760 2033;
neg 2034; mul 438 1991; mul 527 1995; input p 167; where 794 2038; input p 168; where 803 2040; input p 169; where
812 2042; input p 170; where 821 2044; mul 67 193; mul 123 2046; add 120 2047; mul 67 2046; add 124 2049; mul 127
2050; add 2048 2051; mul 64 134; add 2052 2053; mul 68 193; mul 137 2055; add 2054 2056; mul 76 143; add 2057 2058;
mul 60 66; add 2059 2060; mul 91 193; mul 71 2062; add 2061 2063; mul 99 158; add 2064 2065; mul 111 167; add 2066
2067; mul 62 2068; mul 57 2069; mul 252 2050; add 250 2071; mul 258 2055; add 2072 2073; mul 76 261; add 2074 2075;
mul 226 2062; add 2076 2077; mul 111 274; add 2078 2079; mul 62 2080; add 347 2081; mul 215 2082; mul 550 2083; mul
67 2050; add 128 2085; mul 290 2086; add 736 2087; add 740 2088; mul 67 2055; add 72 2090; mul 252 2091; add 2089
2092; mul 80 193; mul 302 2094; add 2093 2095; add 747 2096; mul 103 193; mul 226 2098; add 2097 2099; mul 168 193;
mul 324 2101; add 2100 2102; add 754 2103; add 356 357; add 354 2105; mul 16 2106; add 2104 2107; mul 215 2108; mul
993 2109; mul 1060 2110; mul 386 2111; mul 193 2112; mul 1066 2112; mul 400 2114; mul 1064 2115; neg 2116; mul 193
2117; mul 400 2118; mul 405 2116; sub 2119 2120; sub 2113 2121; mul 403 2122; mul 413 2123; mul 409 2112; mul 408
2125; add 2124 2126; mul 417 2112; mul 416 2128; sub 2127 2129; mul 386 2130; mul 436 2114; mul 399 2132; mul 437
2114; add 2133 2134; mul 399 2135; mul 1090 2114; add 2136 2137; mul 386 2138; mul 433 2139; sub 2131 2140; mul 386
2116; mul 392 2142; mul 0 2143; mul 446 2109; mul 401 2145; mul 448 2142; add 2146 2147; mul 451 2148; mul 42 2149;
sub 2144 2150; mul 401 2109; mul 385 2142; sub 2152 2153; mul 463 2154; mul 226 2055; mul 235 2062; add 2156 2157;
mul 99 238; add 2158 2159; mul 59 2080; add 2160 2161; add 221 2162; mul 215 2163; mul 457 2164; mul 42 2083; add
2165 2166; mul 402 2167; add 2155 2168; add 2151 2169; mul 443 2170; mul 441 2139; mul 438 2172; mul 442 2139; add
2173 2174; mul 465 2175; sub 2171 2176; add 2141 2177; mul 402 2178; mul 467 2154; add 2179 2180; mul 1132 2109; mul
1137 2182; mul 477 2183; mul 193 2184; mul 1143 2184; mul 491 2186; mul 1141 2187; neg 2188; mul 193 2189; mul 491
2190; mul 496 2188; sub 2191 2192; sub 2185 2193; mul 494 2194; mul 503 2195; mul 500 2184; mul 499 2197; add 2196
2198; mul 507 2184; mul 506 2200; sub 2199 2201; mul 477 2202; mul 525 2186; mul 490 2204; mul 526 2186; add 2205
2206; mul 490 2207; mul 1167 2186; add 2208 2209; mul 477 2210; mul 523 2211; sub 2203 2212; mul 535 2109; mul 492
2214; mul 477 2188; mul 537 2216; sub 2215 2217; mul 451 2218; mul 42 2219; mul 483 2216; mul 0 2221; add 2220 2222;
mul 492 2109; mul 476 2216; sub 2224 2225; mul 463 2226; mul 493 2167; add 2227 2228; add 2223 2229; mul 532 2230;
mul 530 2211; mul 527 2232; mul 531 2211; add 2233 2234; mul 545 2235; sub 2231 2236; add 2213 2237; mul 493 2238;
mul 547 2226; add 2239 2240; add 2181 2241; mul 461 2242; sub 2084 2243; sub 2070 2244; mul 452 2178; mul 467 2149;
sub 2246 2247; mul 539 2238; mul 547 2219; add 2249 2250; add 2248 2251; add 2245 2252; mul 639 2253; mul 64 66; mul
71 2055; add 2255 2256; mul 76 79; add 2257 2258; mul 60 90; add 2259 2260; mul 94 2062; add 2261 2262; mul 99 102;
add 2263 2264; mul 59 2068; add 2265 2266; mul 57 2267; mul 550 2164; mul 285 2242; sub 2269 2270; sub 2268 2271;
mul 56 2272; mul 454 2178; mul 467 2143; sub 2274 2275; mul 541 2238; mul 547 2221; sub 2277 2278; add 2276 2279;
sub 2273 2280; mul 634 2281; sub 2254 2282; mul 690 2283; mul 639 2281; mul 686 2253; sub 2285 2286; mul 690 2287;
mul 698 2046; add 696 2289; mul 701 2050; add 2290 2291; mul 64 706; add 2292 2293; mul 709 2055; add 2294 2295; mul
76 137; add 2296 2297; mul 99 722; add 2298 2299; mul 94 111; add 2300 2301; mul 57 2302; mul 737 2050; add 735
2304; mul 742 2055; add 2305 2306; mul 76 258; add 2307 2308; mul 99 749; add 2309 2310; mul 111 235; add 2311 2312;
add 355 2313; mul 215 2314; mul 550 2315; mul 757 2242; sub 2316 2317; sub 2303 2318; mul 760 2319; neg 2320; mul
438 2170; mul 465 2139; sub 2322 2323; mul 527 2230; mul 545 2211; sub 2325 2326; mul 423 438; mul 402 2328; mul 461
2329; mul 452 2328; add 2330 2331; mul 639 2332; mul 285 2329; mul 56 2334; mul 454 2328; sub 2335 2336; mul 634
2337; sub 2333 2338; mul 690 2339; mul 639 2337; mul 686 2332; sub 2341 2342; mul 690 2343; mul 757 2329; mul 760
2345; neg 2346; input p 171; mul 513 527; mul 493 2349; mul 461 2350; mul 539 2349; add 2351 2352; mul 639 2353; mul
285 2350; mul 56 2355; mul 541 2349; sub 2356 2357; mul 634 2358; sub 2354 2359; mul 690 2360; mul 639 2358; mul 686
2353; sub 2362 2363; mul 690 2364; mul 757 2350; mul 760 2366; neg 2367; mul 426 438; mul 402 2369; mul 461 2370;
mul 452 2369; add 2371 2372; mul 639 2373; mul 285 2370; mul 56 2375; mul 454 2369; sub 2376 2377; mul 634 2378; sub
2374 2379; mul 690 2380; mul 639 2378; mul 686 2373; sub 2382 2383; mul 690 2384; mul 757 2370; mul 760 2386; neg
2387; input p 172; mul 516 527; mul 493 2390; mul 461 2391; mul 539 2390; add 2392 2393; mul 639 2394; mul 285 2391;
mul 56 2396; mul 541 2390; sub 2397 2398; mul 634 2399; sub 2395 2400; mul 690 2401; mul 639 2399; mul 686 2394; sub
2403 2404; mul 690 2405; mul 757 2391; mul 760 2407; neg 2408; mul 430 438; mul 402 2410; mul 461 2411; mul 452
2410; add 2412 2413; mul 639 2414; mul 285 2411; mul 56 2416; mul 454 2410; sub 2417 2418; mul 634 2419; sub 2415
2420; mul 690 2421; mul 639 2419; mul 686 2414; sub 2423 2424; mul 690 2425; mul 757 2411; mul 760 2427; neg 2428;
input p 173; mul 520 527; mul 493 2431; mul 461 2432; mul 539 2431; add 2433 2434; mul 639 2435; mul 285 2432; mul
56 2437; mul 541 2431; sub 2438 2439; mul 634 2440; sub 2436 2441; mul 690 2442; mul 639 2440; mul 686 2435; sub
2444 2445; mul 690 2446; mul 757 2432; mul 760 2448; neg 2449; mul 600 634; mul 690 2451; mul 600 639; mul 690 2453;
neg 2454; input p 174; mul 604 634; mul 690 2457; mul 604 639; mul 690 2459; neg 2460; input p 175; input p 176; mul
639 2463; mul 578 634; sub 2464 2465; mul 690 2466; mul 578 639; mul 686 2463; sub 2468 2469; mul 690 2470; input p
177; mul 639 2472; mul 581 634; sub 2473 2474; mul 690 2475; mul 581 639; mul 686 2472; sub 2477 2478; mul 690 2479;
input p 178; mul 639 2481; mul 585 634; sub 2482 2483; mul 690 2484; mul 585 639; mul 686 2481; sub 2486 2487; mul
690 2488; input p 179; mul 639 2490; mul 589 634; sub 2491 2492; mul 690 2493; mul 589 639; mul 686 2490; sub 2495
2496; mul 690 2497; mul 14 21; add 2 2499; mul 11 33; sub 2500 2501; mul 415 419; mul 386 2503; mul 454 2504; mul
402 2504; mul 285 2506; mul 56 2507; sub 2505 2508; sub 2502 2509; mul 634 2510; mul 461 2506; mul 452 2504; add
2512 2513; add 33 2514; mul 639 2515; sub 2511 2516; mul 690 2517; mul 686 2515; mul 639 2510; sub 2519 2520; mul
690 2521; mul 757 2506; mul 760 2523; mul 14 24; add 6 2525; mul 11 36; sub 2526 2527; mul 505 509; mul 477 2529;
mul 541 2530; mul 493 2530; mul 285 2532; mul 56 2533; sub 2531 2534; sub 2528 2535; mul 634 2536; mul 461 2532; mul
539 2530; add 2538 2539; add 36 2540; mul 639 2541; sub 2537 2542; mul 690 2543; mul 686 2541; mul 639 2536; sub
2545 2546; mul 690 2547; mul 757 2532; mul 760 2549; neg 1303; neg 1291; neg 1365; neg 1368; neg 1305; neg 1376; neg
1313; neg 1317; neg 1386; neg 1389; neg 1336; neg 1396; neg 1399; store f 0 0; store f 1 691; store f 2 42; store f
3 695; store f 4 762; store f 5 766; store f 6 769; store f 7 772; store f 8 774; store f 9 777; store f 10 779;
store f 11 781; store f 12 783; store f 13 797; store f 14 806; store f 15 815; store f 16 824; store a 17 1348;
store a 51 1402; store a 68 1447; store a 85 1450; store a 102 1453; store a 119 1450; store a 136 1453; store a 153
1450; store a 170 1453; store a 187 780; store a 204 782; store a 1 364; store a 18 1498; store a 52 1502; store a
69 1505; store a 86 1506; store a 103 1507; store a 120 1506; store a 137 1507; store a 154 1506; store a 171 1507;
store a 222 1508; store a 239 1509; store a 256 1510; store a 273 1511; store a 19 1934; store a 53 1944; store a 70
1983; store a 87 1986; store a 104 1989; store a 121 1986; store a 138 1989; store a 155 1986; store a 172 1989;
store a 20 2027; store a 37 364; store a 54 2032; store a 71 2035; store a 88 2036; store a 105 2037; store a 122
2036; store a 139 2037; store a 156 2036; store a 173 2037; store a 224 2039; store a 241 2041; store a 258 2043;
store a 275 2045; store a 21 2284; store a 55 2288; store a 72 2321; store a 89 2324; store a 106 2327; store a 123
2324; store a 140 2327; store a 157 2324; store a 174 2327; store a 22 2340; store a 56 2344; store a 73 2347; store
a 90 2348; store a 23 2361; store a 57 2365; store a 74 2368; store a 108 2348; store a 24 2381; store a 58 2385;
store a 75 2388; store a 126 2389; store a 25 2402; store a 59 2406; store a 76 2409; store a 144 2389; store a 26
2422; store a 60 2426; store a 77 2429; store a 162 2430; store a 27 2443; store a 61 2447; store a 78 2450; store a
180 2430; store a 28 2452; store a 62 2455; store a 198 2456; store a 29 2458; store a 63 2461; store a 216 2462;
store a 30 2467; store a 64 2471; store a 31 2476; store a 65 2480; store a 32 2485; store a 66 2489; store a 33
2494; store a 67 2498; store b 2 2518; store b 6 2522; store b 8 2524; store b 3 2544; store b 7 2548; store b 9
2550; store by_c 13 1282; store by_c 39 2551; store by_c 14 2552; store by_c 40 1361; store by_c 15 1295; store by_c
41 2553; store by_c 16 1299; store by_c 42 2554; store by_c 17 2555; store by_c 43 1373; store by_c 18 1309; store
by_c 44 2556; store by_c 19 2557; store by_c 45 1379; store by_c 20 2558; store by_c 46 1382; store by_c 21 1327;
store by_c 47 2559; store by_c 22 1331; store by_c 48 2560; store by_c 23 2561; store by_c 49 1393; store by_c 24
1340; store by_c 50 2562; store by_c 25 1344; store by_c 51 2563
    """,
)

BY_CONSTANTS = Graph(
    {'x': 13, 'u': 2, 'c': 13, 'z': 4, 'p': 201},
    {'by_k': 1275},
    """
input p 112; input x 0; input p 108; mul 1 2; input x 2; input p 111; mul 4 5; add 3 6; input p 109; mul 7 8; mul 7
9; add 0 10; constant 1.0; input p 107; mul 1 13; mul 2 4; add 14 15; mul 16 16; add 12 17; mul 8 18; mul 11 19;
input p 113; mul 8 16; mul 7 22; add 21 23; mul 24 24; sub 20 25; div 12 26; mul 11 27; input p 3; input p 4; input
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
input p 77; mul 166 370; mul 166 373; mul 373 378; sub 377 379; mul 376 380; input p 78; constant 1.4; sub 370 383;
mul 382 384; add 12 385; mul 381 386; input u 0; input p 79; mul 388 389; input p 80; mul 384 391; add 12 392; mul
390 393; sub 387 394; mul 359 395; input p 81; input x 5; mul 397 398; input p 82; input x 7; mul 400 401; add 399
402; input p 83; input x 9; mul 404 405; add 403 406; constant -0.5; mul 372 408; mul 372 409; mul 372 410; mul 359
411; mul 407 412; add 396 413; input p 84; mul 412 415; mul 412 416; input x 3; sub 352 357; mul 365 419; add 360
363; mul 358 421; sub 420 422; mul 374 423; div 12 346; mul 349 425; mul 424 426; mul 418 427; input x 1; mul 365
374; mul 429 430; sub 428 431; mul 29 429; mul 258 433; mul 35 254; add 323 435; mul 188 436; mul 418 437; add 434
438; mul 375 439; add 432 440; mul 417 441; add 414 442; mul 375 443; input p 85; add 336 445; input p 86; mul 350
447; add 446 448; input p 87; mul 356 450; add 449 451; input p 88; mul 356 447; mul 350 450; input p 89; sub 455
456; sub 454 457; sub 458 1; mul 459 459; mul 452 452; add 460 461; sqrt 462; mul 453 463; sqrt 464; div 12 465; mul
466 466; mul 453 467; mul 452 468; input p 90; mul 166 464; mul 166 467; mul 467 472; sub 471 473; mul 470 474;
input p 91; sub 464 383; mul 476 477; add 12 478; mul 475 479; input u 1; input p 92; mul 481 482; input p 93; mul
477 484; add 12 485; mul 483 486; sub 480 487; mul 453 488; input p 94; input x 6; mul 490 491; input p 95; input x
8; mul 493 494; add 492 495; input p 96; input x 10; mul 497 498; add 496 499; mul 408 466; mul 466 501; mul 466
502; mul 453 503; mul 500 504; add 489 505; input p 97; mul 504 507; mul 504 508; add 448 451; mul 459 510; sub 455
454; mul 452 512; add 511 513; mul 468 514; mul 426 515; mul 418 516; mul 459 468; mul 429 518; sub 517 519; mul 439
469; add 520 521; mul 509 522; add 506 523; mul 469 524; add 444 525; sub 259 526; mul 258 527; sub 187 528; input p
98; constant 12.0; mul 433 531; constant -6.0; mul 32 433; mul 35 418; add 534 535; mul 533 536; add 532 537; mul
530 538; mul 433 533; constant 4.0; mul 536 541; add 540 542; mul 530 543; mul 32 544; add 539 545; add 529 546; mul
29 547; mul 29 548; mul 28 549; mul 24 27; mul 516 551; mul 28 518; add 552 553; mul 28 29; mul 258 555; mul 437
551; sub 556 557; mul 469 558; sub 554 559; mul 509 560; mul 439 561; mul 524 558; sub 562 563; mul 468 564; mul 524
551; mul 418 561; add 566 567; mul 426 568; mul 468 569; mul 512 570; add 565 571; mul 166 452; mul 166 463; div 12
574; mul 453 560; mul 475 576; mul 476 577; mul 483 576; mul 484 579; sub 578 580; mul 166 465; div 12 582; mul 466
503; mul 522 560; mul 508 585; mul 504 585; mul 507 587; add 586 588; mul 500 560; add 589 590; mul 453 591; mul 584
592; mul 466 592; mul 503 594; add 593 595; mul 466 594; mul 502 597; add 596 598; mul 166 466; mul 452 564; mul 28
524; mul 429 561; sub 602 603; mul 459 604; add 601 605; mul 514 569; add 606 607; mul 453 608; mul 479 576; mul 470
610; mul 472 611; sub 609 612; mul 467 611; neg 614; mul 166 615; add 613 616; mul 600 617; mul 467 618; add 599
619; mul 583 620; sub 581 621; mul 166 611; add 622 623; mul 453 624; mul 575 625; mul 573 626; add 572 627; sub 550
628; mul 469 561; mul 427 551; mul 28 430; add 631 632; mul 375 558; sub 633 634; mul 417 635; mul 375 636; add 630
637; mul 418 638; mul 527 551; sub 639 640; mul 436 641; add 629 642; mul 29 433; mul 35 551; mul 32 555; sub 645
646; mul 530 647; mul 533 648; mul 541 648; mul 530 555; mul 533 651; sub 650 652; mul 32 653; add 649 654; mul 531
651; sub 655 656; mul 258 638; add 657 658; mul 644 659; sub 643 660; mul 527 555; mul 433 638; add 662 663; mul 257
664; add 661 665; mul 439 636; mul 443 558; sub 667 668; mul 374 669; mul 443 551; mul 418 636; add 671 672; mul 426
673; mul 374 674; mul 421 675; sub 670 676; mul 166 358; mul 166 369; div 12 679; mul 359 635; mul 381 681; mul 382
682; mul 390 681; mul 391 684; sub 683 685; mul 166 371; div 12 687; mul 372 411; mul 441 635; mul 416 690; mul 412
690; mul 415 692; add 691 693; mul 407 635; add 694 695; mul 359 696; mul 689 697; mul 372 697; mul 411 699; add 698
700; mul 372 699; mul 410 702; add 701 703; mul 166 372; mul 358 669; mul 28 443; mul 429 636; sub 707 708; mul 365
709; add 706 710; mul 423 674; add 711 712; mul 359 713; mul 386 681; mul 376 715; mul 378 716; sub 714 717; mul 373
716; neg 719; mul 166 720; add 718 721; mul 705 722; mul 373 723; add 704 724; mul 688 725; sub 686 726; mul 166
716; add 727 728; mul 359 729; mul 680 730; mul 678 731; add 677 732; add 628 733; mul 335 734; add 666 735; sub 736
733; mul 29 33; mul 188 641; mul 35 739; mul 188 664; mul 32 741; add 740 742; mul 252 743; mul 84 744; mul 33 166;
mul 33 744; mul 746 747; add 745 748; mul 214 743; mul 37 750; mul 746 751; add 749 752; mul 247 743; mul 40 754;
mul 746 755; add 753 756; mul 244 743; mul 37 758; mul 37 759; add 757 760; mul 199 743; mul 40 762; mul 40 763; add
761 764; mul 197 743; add 765 766; mul 220 741; mul 84 768; add 767 769; mul 33 768; mul 746 771; add 770 772; mul
217 741; mul 37 774; mul 746 775; add 773 776; mul 214 741; mul 37 778; mul 37 779; add 777 780; mul 211 741; mul 40
782; mul 37 783; add 781 784; mul 208 741; mul 40 786; mul 40 787; add 785 788; mul 205 741; add 789 790; mul 188
734; mul 315 792; mul 40 793; mul 194 794; add 791 795; mul 4 793; add 739 797; mul 191 798; add 796 799; mul 196
793; add 800 801; mul 33 793; add 741 803; mul 189 804; add 802 805; mul 311 792; mul 89 807; add 806 808; mul 33
807; mul 84 810; add 809 811; mul 33 810; mul 746 813; add 812 814; mul 252 792; mul 37 816; mul 84 817; add 815
818; mul 33 817; mul 746 820; add 819 821; mul 304 792; mul 37 823; mul 37 824; mul 746 825; add 822 826; mul 247
792; mul 40 828; mul 37 829; mul 746 830; add 827 831; mul 297 792; mul 40 833; mul 40 834; mul 746 835; add 832
836; mul 156 792; mul 746 838; add 837 839; mul 202 792; mul 37 841; mul 37 842; mul 37 843; add 840 844; mul 199
792; mul 40 846; mul 40 847; mul 37 848; add 845 849; mul 197 792; mul 37 851; add 850 852; le 163 33; le 33 163;
add 854 855; div 12 856; mul 854 857; le 164 153; le 153 164; add 859 860; div 12 861; mul 859 862; abs 4; lt 864
156; mul 30 551; mul 173 866; mul 172 867; mul 159 166; mul 866 869; mul 168 870; mul 167 871; add 868 872; mul 159
870; mul 160 866; add 874 875; mul 155 876; add 873 877; where 865 878; mul 30 555; mul 167 880; mul 181 881; neg
882; mul 166 883; mul 167 884; where 154 885; add 879 886; mul 182 880; neg 888; mul 166 889; where 154 890; add 887
891; mul 174 881; neg 893; where 154 894; add 892 895; mul 177 880; neg 897; mul 166 898; where 154 899; add 896
900; mul 165 867; where 865 902; mul 174 880; neg 904; where 154 905; add 903 906; mul 167 907; add 901 908; mul 169
880; neg 910; mul 166 911; where 154 912; add 909 913; mul 863 914; mul 858 915; add 853 916; mul 35 866; mul 32
880; sub 918 919; mul 146 920; mul 84 921; add 917 922; mul 33 921; mul 746 924; add 923 925; mul 79 920; mul 37
927; mul 746 928; add 926 929; mul 140 920; mul 40 931; mul 746 932; add 930 933; mul 137 920; mul 746 935; add 934
936; mul 134 920; mul 37 938; mul 37 939; add 937 940; mul 131 920; mul 40 942; mul 37 943; add 941 944; mul 128
920; mul 37 946; add 945 947; mul 44 920; mul 40 949; mul 40 950; add 948 951; mul 39 920; mul 40 953; add 952 954;
mul 31 920; add 955 956; mul 88 880; mul 84 958; sub 957 959; mul 33 958; mul 746 961; sub 960 962; mul 83 880; mul
37 964; mul 746 965; sub 963 966; mul 79 880; mul 37 968; mul 37 969; sub 967 970; mul 75 880; mul 40 972; mul 37
973; sub 971 974; mul 71 880; mul 37 976; sub 975 977; mul 67 880; mul 40 979; mul 40 980; sub 978 981; mul 63 880;
mul 40 983; sub 982 984; mul 60 880; sub 985 986; mul 84 750; mul 72 758; add 988 989; mul 33 759; add 990 991; mul
237 743; mul 49 993; add 992 994; mul 37 166; mul 37 993; mul 996 997; add 995 998; mul 234 743; mul 40 1000; mul
996 1001; add 999 1002; mul 231 743; mul 40 1004; mul 40 1005; add 1003 1006; mul 228 743; add 1007 1008; mul 84
774; add 1009 1010; mul 72 778; add 1011 1012; mul 33 779; add 1013 1014; mul 33 783; add 1015 1016; mul 202 741;
mul 49 1018; add 1017 1019; mul 37 1018; mul 996 1021; add 1020 1022; mul 199 741; mul 40 1024; mul 40 1025; add
1023 1026; mul 197 741; add 1027 1028; mul 89 816; add 1029 1030; mul 85 823; add 1031 1032; mul 84 824; add 1033
1034; mul 84 829; add 1035 1036; mul 80 841; add 1037 1038; mul 72 842; add 1039 1040; mul 33 843; add 1041 1042;
mul 33 848; add 1043 1044; mul 33 851; add 1045 1046; mul 283 792; mul 57 1048; add 1047 1049; mul 37 1048; mul 49
1051; add 1050 1052; mul 37 1051; mul 996 1054; add 1053 1055; mul 279 792; mul 40 1057; mul 49 1058; add 1056 1059;
mul 37 1058; mul 996 1061; add 1060 1062; mul 275 792; mul 40 1064; mul 40 1065; mul 996 1066; add 1063 1067; mul
272 792; mul 996 1069; add 1068 1070; mul 225 792; mul 40 1072; mul 40 1073; mul 40 1074; add 1071 1075; mul 223
792; mul 40 1077; add 1076 1078; mul 84 927; add 1079 1080; mul 72 938; add 1081 1082; mul 33 939; add 1083 1084;
mul 33 943; add 1085 1086; mul 33 946; add 1087 1088; mul 119 920; mul 49 1090; add 1089 1091; mul 37 1090; mul 996
1093; add 1092 1094; mul 116 920; mul 40 1096; mul 996 1097; add 1095 1098; mul 113 920; mul 996 1100; add 1099
1101; mul 110 920; mul 40 1103; mul 40 1104; add 1102 1105; mul 107 920; mul 40 1107; add 1106 1108; mul 104 920;
add 1109 1110; mul 84 964; sub 1111 1112; mul 72 968; sub 1113 1114; mul 33 969; sub 1115 1116; mul 33 973; sub 1117
1118; mul 33 976; sub 1119 1120; mul 56 880; mul 49 1122; sub 1121 1123; mul 37 1122; mul 996 1125; sub 1124 1126;
mul 52 880; mul 40 1128; mul 996 1129; sub 1127 1130; mul 48 880; mul 996 1132; sub 1131 1133; mul 44 880; mul 40
1135; mul 40 1136; sub 1134 1137; mul 39 880; mul 40 1139; sub 1138 1140; mul 31 880; sub 1141 1142; mul 32 1143;
add 987 1144; mul 738 1145; sub 737 1146; input p 180; input c 4; input p 0; mul 1 1150; sub 4 1151; input c 5; mul
1152 1153; sub 1149 1154; input c 6; mul 388 1156; add 1155 1157; input c 7; mul 481 1159; add 1158 1160; input c 8;
input p 1; max 1162 1163; mul 429 1150; sub 418 1165; mul 1164 1166; sub 1161 1167; mul 28 1168; mul 28 1150; add
551 1170; mul 1164 1171; mul 429 1172; add 1169 1173; mul 1153 1171; input c 9; input c 10; mul 315 1177; mul 1152
1178; sub 1176 1179; input c 11; mul 388 1181; add 1180 1182; input c 12; mul 481 1184; add 1183 1185; mul 28 1186;
add 1175 1187; mul 28 1152; mul 1178 1189; sub 1188 1190; mul 1 1191; add 1174 1192; mul 1148 1193; add 1147 1194;
mul 19 27; mul 527 1196; mul 516 1196; mul 518 551; add 1198 1199; mul 437 1196; mul 29 551; mul 258 1202; sub 1201
1203; mul 469 1204; add 1200 1205; mul 509 1206; mul 469 1207; mul 427 1196; mul 430 551; add 1209 1210; mul 375
1204; add 1211 1212; mul 417 1213; mul 375 1214; add 1208 1215; mul 418 1216; sub 1197 1217; mul 436 1218; mul 549
551; mul 453 1206; mul 483 1221; mul 484 1222; mul 475 1221; mul 476 1224; sub 1223 1225; mul 522 1206; mul 508
1227; mul 504 1227; mul 507 1229; add 1228 1230; mul 500 1206; add 1231 1232; mul 453 1233; mul 584 1234; mul 466
1234; mul 503 1236; add 1235 1237; mul 466 1236; mul 502 1239; add 1238 1240; mul 429 1207; sub 1242 566; mul 459
1243; mul 524 1204; mul 439 1207; add 1245 1246; mul 452 1247; sub 1244 1248; mul 524 1196; mul 418 1207; add 1250
1251; mul 426 1252; mul 514 1253; sub 1249 1254; mul 453 1255; mul 479 1221; mul 470 1257; mul 472 1258; add 1256
1259; mul 467 1258; mul 166 1261; add 1260 1262; mul 600 1263; mul 467 1264; sub 1241 1265; mul 583 1266; add 1226
1267; neg 1258; mul 166 1269; add 1268 1270; mul 453 1271; mul 575 1272; mul 573 1273; mul 468 1247; mul 468 1253;
mul 512 1276; add 1275 1277; sub 1274 1278; add 1220 1279; sub 1219 1280; mul 32 1202; mul 35 1196; sub 1282 1283;
mul 530 1284; mul 533 1285; mul 541 1285; mul 530 1202; mul 533 1288; add 1287 1289; mul 32 1290; add 1286 1291; mul
531 1288; add 1292 1293; mul 258 1216; sub 1294 1295; mul 644 1296; sub 1281 1297; mul 527 1202; mul 433 1216; add
1299 1300; mul 257 1301; sub 1298 1302; mul 443 1196; mul 418 1214; add 1304 1305; mul 426 1306; mul 374 1307; mul
421 1308; mul 443 1204; mul 439 1214; add 1310 1311; mul 374 1312; sub 1309 1313; mul 359 1213; mul 390 1315; mul
391 1316; mul 381 1315; mul 382 1318; sub 1317 1319; mul 441 1213; mul 416 1321; mul 412 1321; mul 415 1323; add
1322 1324; mul 407 1213; add 1325 1326; mul 359 1327; mul 689 1328; mul 372 1328; mul 411 1330; add 1329 1331; mul
372 1330; mul 410 1333; add 1332 1334; mul 429 1214; sub 1336 671; mul 365 1337; mul 358 1312; sub 1338 1339; mul
423 1307; sub 1340 1341; mul 359 1342; mul 386 1315; mul 376 1344; mul 378 1345; add 1343 1346; mul 373 1345; mul
166 1348; add 1347 1349; mul 705 1350; mul 373 1351; sub 1335 1352; mul 688 1353; add 1320 1354; neg 1345; mul 166
1356; add 1355 1357; mul 359 1358; mul 680 1359; mul 678 1360; add 1314 1361; add 1279 1362; mul 335 1363; add 1303
1364; sub 1365 1362; mul 188 1218; mul 35 1367; mul 188 1301; mul 32 1369; sub 1368 1370; mul 252 1371; mul 84 1372;
mul 33 1372; mul 746 1374; add 1373 1375; mul 214 1371; mul 37 1377; mul 746 1378; add 1376 1379; mul 247 1371; mul
40 1381; mul 746 1382; add 1380 1383; mul 244 1371; mul 37 1385; mul 37 1386; add 1384 1387; mul 199 1371; mul 40
1389; mul 40 1390; add 1388 1391; mul 197 1371; add 1392 1393; mul 220 1369; mul 84 1395; sub 1394 1396; mul 33
1395; mul 746 1398; sub 1397 1399; mul 217 1369; mul 37 1401; mul 746 1402; sub 1400 1403; mul 214 1369; mul 37
1405; mul 37 1406; sub 1404 1407; mul 211 1369; mul 40 1409; mul 37 1410; sub 1408 1411; mul 208 1369; mul 40 1413;
mul 40 1414; sub 1412 1415; mul 205 1369; sub 1416 1417; mul 188 1363; mul 315 1419; mul 40 1420; mul 194 1421; add
1418 1422; mul 4 1420; add 1367 1424; mul 191 1425; add 1423 1426; mul 196 1420; add 1427 1428; mul 33 1420; sub
1430 1369; mul 189 1431; add 1429 1432; mul 311 1419; mul 89 1434; add 1433 1435; mul 33 1434; mul 84 1437; add 1436
1438; mul 33 1437; mul 746 1440; add 1439 1441; mul 252 1419; mul 37 1443; mul 84 1444; add 1442 1445; mul 33 1444;
mul 746 1447; add 1446 1448; mul 304 1419; mul 37 1450; mul 37 1451; mul 746 1452; add 1449 1453; mul 247 1419; mul
40 1455; mul 37 1456; mul 746 1457; add 1454 1458; mul 297 1419; mul 40 1460; mul 40 1461; mul 746 1462; add 1459
1463; mul 156 1419; mul 746 1465; add 1464 1466; mul 202 1419; mul 37 1468; mul 37 1469; mul 37 1470; add 1467 1471;
mul 199 1419; mul 40 1473; mul 40 1474; mul 37 1475; add 1472 1476; mul 197 1419; mul 37 1478; add 1477 1479; mul 30
1196; mul 173 1481; mul 172 1482; mul 869 1481; mul 168 1484; mul 167 1485; add 1483 1486; mul 159 1484; mul 160
1481; add 1488 1489; mul 155 1490; add 1487 1491; neg 1492; where 865 1493; mul 30 1202; mul 167 1495; mul 181 1496;
mul 166 1497; mul 167 1498; where 154 1499; add 1494 1500; mul 182 1495; mul 166 1502; where 154 1503; add 1501
1504; mul 174 1496; where 154 1506; add 1505 1507; mul 177 1495; mul 166 1509; where 154 1510; add 1508 1511; mul
165 1482; neg 1513; where 865 1514; mul 174 1495; where 154 1516; add 1515 1517; mul 167 1518; add 1512 1519; mul
169 1495; mul 166 1521; where 154 1522; add 1520 1523; mul 863 1524; mul 858 1525; add 1480 1526; mul 32 1495; mul
35 1481; sub 1528 1529; mul 146 1530; mul 84 1531; add 1527 1532; mul 33 1531; mul 746 1534; add 1533 1535; mul 79
1530; mul 37 1537; mul 746 1538; add 1536 1539; mul 140 1530; mul 40 1541; mul 746 1542; add 1540 1543; mul 137
1530; mul 746 1545; add 1544 1546; mul 134 1530; mul 37 1548; mul 37 1549; add 1547 1550; mul 131 1530; mul 40 1552;
mul 37 1553; add 1551 1554; mul 128 1530; mul 37 1556; add 1555 1557; mul 44 1530; mul 40 1559; mul 40 1560; add
1558 1561; mul 39 1530; mul 40 1563; add 1562 1564; mul 31 1530; add 1565 1566; mul 88 1495; mul 84 1568; add 1567
1569; mul 33 1568; mul 746 1571; add 1570 1572; mul 83 1495; mul 37 1574; mul 746 1575; add 1573 1576; mul 79 1495;
mul 37 1578; mul 37 1579; add 1577 1580; mul 75 1495; mul 40 1582; mul 37 1583; add 1581 1584; mul 71 1495; mul 37
1586; add 1585 1587; mul 67 1495; mul 40 1589; mul 40 1590; add 1588 1591; mul 63 1495; mul 40 1593; add 1592 1594;
mul 60 1495; add 1595 1596; mul 84 1377; mul 72 1385; add 1598 1599; mul 33 1386; add 1600 1601; mul 237 1371; mul
49 1603; add 1602 1604; mul 37 1603; mul 996 1606; add 1605 1607; mul 234 1371; mul 40 1609; mul 996 1610; add 1608
1611; mul 231 1371; mul 40 1613; mul 40 1614; add 1612 1615; mul 228 1371; add 1616 1617; mul 84 1401; sub 1618
1619; mul 72 1405; sub 1620 1621; mul 33 1406; sub 1622 1623; mul 33 1410; sub 1624 1625; mul 202 1369; mul 49 1627;
sub 1626 1628; mul 37 1627; mul 996 1630; sub 1629 1631; mul 199 1369; mul 40 1633; mul 40 1634; sub 1632 1635; mul
197 1369; sub 1636 1637; mul 89 1443; add 1638 1639; mul 85 1450; add 1640 1641; mul 84 1451; add 1642 1643; mul 84
1456; add 1644 1645; mul 80 1468; add 1646 1647; mul 72 1469; add 1648 1649; mul 33 1470; add 1650 1651; mul 33
1475; add 1652 1653; mul 33 1478; add 1654 1655; mul 283 1419; mul 57 1657; add 1656 1658; mul 37 1657; mul 49 1660;
add 1659 1661; mul 37 1660; mul 996 1663; add 1662 1664; mul 279 1419; mul 40 1666; mul 49 1667; add 1665 1668; mul
37 1667; mul 996 1670; add 1669 1671; mul 275 1419; mul 40 1673; mul 40 1674; mul 996 1675; add 1672 1676; mul 272
1419; mul 996 1678; add 1677 1679; mul 225 1419; mul 40 1681; mul 40 1682; mul 40 1683; add 1680 1684; mul 223 1419;
mul 40 1686; add 1685 1687; mul 84 1537; add 1688 1689; mul 72 1548; add 1690 1691; mul 33 1549; add 1692 1693; mul
33 1553; add 1694 1695; mul 33 1556; add 1696 1697; mul 119 1530; mul 49 1699; add 1698 1700; mul 37 1699; mul 996
1702; add 1701 1703; mul 116 1530; mul 40 1705; mul 996 1706; add 1704 1707; mul 113 1530; mul 996 1709; add 1708
1710; mul 110 1530; mul 40 1712; mul 40 1713; add 1711 1714; mul 107 1530; mul 40 1716; add 1715 1717; mul 104 1530;
add 1718 1719; mul 84 1574; add 1720 1721; mul 72 1578; add 1722 1723; mul 33 1579; add 1724 1725; mul 33 1583; add
1726 1727; mul 33 1586; add 1728 1729; mul 56 1495; mul 49 1731; add 1730 1732; mul 37 1731; mul 996 1734; add 1733
1735; mul 52 1495; mul 40 1737; mul 996 1738; add 1736 1739; mul 48 1495; mul 996 1741; add 1740 1742; mul 44 1495;
mul 40 1744; mul 40 1745; add 1743 1746; mul 39 1495; mul 40 1748; add 1747 1749; mul 31 1495; add 1750 1751; mul 32
1752; add 1597 1753; mul 738 1754; sub 1366 1755; mul 551 1168; mul 551 1150; add 1196 1758; mul 1164 1759; mul 429
1760; add 1757 1761; mul 551 1152; mul 1178 1763; mul 1153 1759; mul 551 1186; add 1765 1766; sub 1764 1767; mul 1
1768; sub 1762 1769; mul 1148 1770; sub 1756 1771; constant 0.01904761904761903; mul 40 1773; input p 126; mul 101
1775; add 1774 1776; mul 37 223; add 1777 1778; input p 127; mul 45 1780; add 1779 1781; mul 53 231; add 1782 1783;
mul 57 279; add 1784 1785; input p 128; mul 76 1787; add 1786 1788; mul 141 208; add 1789 1790; mul 85 247; add 1791
1792; add 331 1793; input p 129; mul 527 1795; mul 1794 1796; mul 188 1794; mul 1795 1798; mul 469 1799; mul 453
1800; mul 483 1801; mul 484 1802; mul 475 1801; mul 476 1804; sub 1803 1805; mul 522 1800; mul 508 1807; mul 504
1807; mul 507 1809; add 1808 1810; mul 500 1800; add 1811 1812; mul 453 1813; mul 584 1814; mul 466 1814; mul 503
1816; add 1815 1817; mul 466 1816; mul 502 1819; add 1818 1820; mul 509 1800; mul 429 1822; mul 459 1823; mul 524
1799; mul 439 1822; add 1825 1826; mul 452 1827; sub 1824 1828; mul 418 1822; mul 426 1830; mul 514 1831; sub 1829
1832; mul 453 1833; mul 479 1801; mul 470 1835; mul 472 1836; add 1834 1837; mul 467 1836; mul 166 1839; add 1838
1840; mul 600 1841; mul 467 1842; sub 1821 1843; mul 583 1844; add 1806 1845; neg 1836; mul 166 1847; add 1846 1848;
mul 453 1849; mul 575 1850; mul 573 1851; mul 468 1827; mul 468 1831; mul 512 1854; add 1853 1855; sub 1852 1856;
sub 1797 1857; mul 469 1822; mul 375 1799; mul 417 1860; mul 375 1861; add 1859 1862; mul 418 1863; mul 436 1864;
sub 1858 1865; mul 258 1863; mul 644 1867; add 1866 1868; mul 433 1863; mul 257 1870; sub 1869 1871; mul 418 1861;
mul 426 1873; mul 374 1874; mul 421 1875; mul 443 1799; mul 439 1861; add 1877 1878; mul 374 1879; sub 1876 1880;
mul 359 1860; mul 390 1882; mul 391 1883; mul 381 1882; mul 382 1885; sub 1884 1886; mul 441 1860; mul 416 1888; mul
412 1888; mul 415 1890; add 1889 1891; mul 407 1860; add 1892 1893; mul 359 1894; mul 689 1895; mul 372 1895; mul
411 1897; add 1896 1898; mul 372 1897; mul 410 1900; add 1899 1901; mul 429 1861; mul 365 1903; mul 358 1879; sub
1904 1905; mul 423 1874; sub 1906 1907; mul 359 1908; mul 386 1882; mul 376 1910; mul 378 1911; add 1909 1912; mul
373 1911; mul 166 1914; add 1913 1915; mul 705 1916; mul 373 1917; sub 1902 1918; mul 688 1919; add 1887 1920; neg
1911; mul 166 1922; add 1921 1923; mul 359 1924; mul 680 1925; mul 678 1926; add 1881 1927; add 1857 1928; mul 335
1929; add 1872 1930; sub 1931 1928; mul 188 1796; mul 247 1933; mul 37 1934; mul 746 1935; mul 208 1933; mul 40
1937; mul 746 1938; add 1936 1939; mul 1787 1933; mul 40 1941; mul 37 1942; add 1940 1943; input p 181; mul 37 1945;
mul 746 1946; sub 1944 1947; input p 182; mul 40 1949; mul 746 1950; sub 1948 1951; input p 183; mul 746 1953; sub
1952 1954; input p 184; mul 37 1956; mul 37 1957; sub 1955 1958; input p 185; mul 40 1960; mul 37 1961; sub 1959
1962; input p 186; mul 37 1964; sub 1963 1965; mul 188 1864; mul 35 1967; mul 188 1870; mul 32 1969; add 1968 1970;
mul 252 1971; mul 84 1972; sub 1966 1973; mul 33 1972; mul 746 1975; sub 1974 1976; mul 214 1971; mul 37 1978; mul
746 1979; sub 1977 1980; mul 247 1971; mul 40 1982; mul 746 1983; sub 1981 1984; mul 244 1971; mul 37 1986; mul 37
1987; sub 1985 1988; mul 199 1971; mul 40 1990; mul 40 1991; sub 1989 1992; mul 197 1971; sub 1993 1994; mul 220
1969; mul 84 1996; sub 1995 1997; mul 33 1996; mul 746 1999; sub 1998 2000; mul 217 1969; mul 37 2002; mul 746 2003;
sub 2001 2004; mul 214 1969; mul 37 2006; mul 37 2007; sub 2005 2008; mul 211 1969; mul 40 2010; mul 37 2011; sub
2009 2012; mul 208 1969; mul 40 2014; mul 40 2015; sub 2013 2016; mul 205 1969; sub 2017 2018; mul 188 1929; mul 315
2020; mul 40 2021; add 1933 2022; mul 194 2023; add 2019 2024; mul 4 2021; sub 2026 1967; mul 191 2027; add 2025
2028; mul 196 2021; add 2029 2030; mul 33 2021; sub 2032 1969; mul 189 2033; add 2031 2034; mul 311 2020; mul 89
2036; add 2035 2037; mul 33 2036; mul 84 2039; add 2038 2040; mul 33 2039; mul 746 2042; add 2041 2043; mul 252
2020; mul 37 2045; mul 84 2046; add 2044 2047; mul 33 2046; mul 746 2049; add 2048 2050; mul 304 2020; mul 37 2052;
mul 37 2053; mul 746 2054; add 2051 2055; mul 247 2020; mul 40 2057; mul 37 2058; mul 746 2059; add 2056 2060; mul
297 2020; mul 40 2062; mul 40 2063; mul 746 2064; add 2061 2065; mul 156 2020; mul 746 2067; add 2066 2068; mul 202
2020; mul 37 2070; mul 37 2071; mul 37 2072; add 2069 2073; mul 199 2020; mul 40 2075; mul 40 2076; mul 37 2077; add
2074 2078; mul 197 2020; mul 37 2080; add 2079 2081; mul 84 1934; mul 33 1942; add 2083 2084; mul 279 1933; mul 49
2086; add 2085 2087; mul 37 2086; mul 996 2089; add 2088 2090; mul 231 1933; mul 40 2092; mul 996 2093; add 2091
2094; mul 1780 1933; mul 40 2096; mul 40 2097; add 2095 2098; mul 223 1933; add 2099 2100; mul 84 1945; sub 2101
2102; mul 72 1956; sub 2103 2104; mul 33 1957; sub 2105 2106; mul 33 1961; sub 2107 2108; mul 33 1964; sub 2109
2110; input p 187; mul 49 2112; sub 2111 2113; mul 37 2112; mul 996 2115; sub 2114 2116; input p 188; mul 40 2118;
mul 996 2119; sub 2117 2120; input p 189; mul 996 2122; sub 2121 2123; input p 190; mul 40 2125; mul 40 2126; sub
2124 2127; input p 191; mul 40 2129; sub 2128 2130; input p 192; sub 2131 2132; mul 84 1978; sub 2133 2134; mul 72
1986; sub 2135 2136; mul 33 1987; sub 2137 2138; mul 237 1971; mul 49 2140; sub 2139 2141; mul 37 2140; mul 996
2143; sub 2142 2144; mul 234 1971; mul 40 2146; mul 996 2147; sub 2145 2148; mul 231 1971; mul 40 2150; mul 40 2151;
sub 2149 2152; mul 228 1971; sub 2153 2154; mul 84 2002; sub 2155 2156; mul 72 2006; sub 2157 2158; mul 33 2007; sub
2159 2160; mul 33 2011; sub 2161 2162; mul 202 1969; mul 49 2164; sub 2163 2165; mul 37 2164; mul 996 2167; sub 2166
2168; mul 199 1969; mul 40 2170; mul 40 2171; sub 2169 2172; mul 197 1969; sub 2173 2174; mul 89 2045; add 2175
2176; mul 85 2052; add 2177 2178; mul 84 2053; add 2179 2180; mul 84 2058; add 2181 2182; mul 80 2070; add 2183
2184; mul 72 2071; add 2185 2186; mul 33 2072; add 2187 2188; mul 33 2077; add 2189 2190; mul 33 2080; add 2191
2192; mul 283 2020; mul 57 2194; add 2193 2195; mul 37 2194; mul 49 2197; add 2196 2198; mul 37 2197; mul 996 2200;
add 2199 2201; mul 279 2020; mul 40 2203; mul 49 2204; add 2202 2205; mul 37 2204; mul 996 2207; add 2206 2208; mul
275 2020; mul 40 2210; mul 40 2211; mul 996 2212; add 2209 2213; mul 272 2020; mul 996 2215; add 2214 2216; mul 225
2020; mul 40 2218; mul 40 2219; mul 40 2220; add 2217 2221; mul 223 2020; mul 40 2223; add 2222 2224; mul 32 2225;
add 2082 2226; mul 738 2227; sub 1932 2228; mul 375 412; mul 418 2230; mul 436 2231; mul 258 2230; mul 644 2233; sub
2232 2234; mul 433 2230; mul 257 2236; add 2235 2237; mul 412 439; mul 374 2239; mul 412 418; mul 426 2241; mul 374
2242; mul 421 2243; sub 2240 2244; mul 359 441; mul 689 2246; mul 372 2246; mul 411 2248; add 2247 2249; mul 372
2248; mul 410 2251; add 2250 2252; mul 358 2239; mul 412 429; mul 365 2255; sub 2254 2256; mul 423 2242; add 2257
2258; mul 359 2259; mul 705 2260; mul 373 2261; add 2253 2262; mul 688 2263; mul 359 2264; mul 680 2265; mul 678
2266; sub 2245 2267; mul 335 2268; add 2238 2269; sub 2270 2268; mul 188 2231; mul 35 2272; mul 188 2236; mul 32
2274; add 2273 2275; mul 252 2276; mul 84 2277; mul 33 2277; mul 746 2279; add 2278 2280; mul 214 2276; mul 37 2282;
mul 746 2283; add 2281 2284; mul 247 2276; mul 40 2286; mul 746 2287; add 2285 2288; mul 244 2276; mul 37 2290; mul
37 2291; add 2289 2292; mul 199 2276; mul 40 2294; mul 40 2295; add 2293 2296; mul 197 2276; add 2297 2298; mul 220
2274; mul 84 2300; add 2299 2301; mul 33 2300; mul 746 2303; add 2302 2304; mul 217 2274; mul 37 2306; mul 746 2307;
add 2305 2308; mul 214 2274; mul 37 2310; mul 37 2311; add 2309 2312; mul 211 2274; mul 40 2314; mul 37 2315; add
2313 2316; mul 208 2274; mul 40 2318; mul 40 2319; add 2317 2320; mul 205 2274; add 2321 2322; mul 188 2268; mul 315
2324; mul 40 2325; mul 194 2326; add 2323 2327; mul 4 2325; add 2272 2329; mul 191 2330; add 2328 2331; mul 196
2325; add 2332 2333; mul 33 2325; add 2274 2335; mul 189 2336; add 2334 2337; mul 311 2324; mul 89 2339; add 2338
2340; mul 33 2339; mul 84 2342; add 2341 2343; mul 33 2342; mul 746 2345; add 2344 2346; mul 252 2324; mul 37 2348;
mul 84 2349; add 2347 2350; mul 33 2349; mul 746 2352; add 2351 2353; mul 304 2324; mul 37 2355; mul 37 2356; mul
746 2357; add 2354 2358; mul 247 2324; mul 40 2360; mul 37 2361; mul 746 2362; add 2359 2363; mul 297 2324; mul 40
2365; mul 40 2366; mul 746 2367; add 2364 2368; mul 156 2324; mul 746 2370; add 2369 2371; mul 202 2324; mul 37
2373; mul 37 2374; mul 37 2375; add 2372 2376; mul 199 2324; mul 40 2378; mul 40 2379; mul 37 2380; add 2377 2381;
mul 197 2324; mul 37 2383; add 2382 2384; mul 84 2282; mul 72 2290; add 2386 2387; mul 33 2291; add 2388 2389; mul
237 2276; mul 49 2391; add 2390 2392; mul 37 2391; mul 996 2394; add 2393 2395; mul 234 2276; mul 40 2397; mul 996
2398; add 2396 2399; mul 231 2276; mul 40 2401; mul 40 2402; add 2400 2403; mul 228 2276; add 2404 2405; mul 84
2306; add 2406 2407; mul 72 2310; add 2408 2409; mul 33 2311; add 2410 2411; mul 33 2315; add 2412 2413; mul 202
2274; mul 49 2415; add 2414 2416; mul 37 2415; mul 996 2418; add 2417 2419; mul 199 2274; mul 40 2421; mul 40 2422;
add 2420 2423; mul 197 2274; add 2424 2425; mul 89 2348; add 2426 2427; mul 85 2355; add 2428 2429; mul 84 2356; add
2430 2431; mul 84 2361; add 2432 2433; mul 80 2373; add 2434 2435; mul 72 2374; add 2436 2437; mul 33 2375; add 2438
2439; mul 33 2380; add 2440 2441; mul 33 2383; add 2442 2443; mul 283 2324; mul 57 2445; add 2444 2446; mul 37 2445;
mul 49 2448; add 2447 2449; mul 37 2448; mul 996 2451; add 2450 2452; mul 279 2324; mul 40 2454; mul 49 2455; add
2453 2456; mul 37 2455; mul 996 2458; add 2457 2459; mul 275 2324; mul 40 2461; mul 40 2462; mul 996 2463; add 2460
2464; mul 272 2324; mul 996 2466; add 2465 2467; mul 225 2324; mul 40 2469; mul 40 2470; mul 40 2471; add 2468 2472;
mul 223 2324; mul 40 2474; add 2473 2475; mul 32 2476; add 2385 2477; mul 738 2478; sub 2271 2479; mul 469 504; mul
418 2481; mul 436 2482; mul 439 504; mul 468 2484; mul 418 504; mul 426 2486; mul 468 2487; mul 512 2488; add 2485
2489; mul 453 522; mul 584 2491; mul 466 2491; mul 503 2493; add 2492 2494; mul 466 2493; mul 502 2496; add 2495
2497; mul 452 2484; mul 429 504; mul 459 2500; sub 2499 2501; mul 514 2487; add 2502 2503; mul 453 2504; mul 600
2505; mul 467 2506; add 2498 2507; mul 583 2508; mul 453 2509; mul 575 2510; mul 573 2511; sub 2490 2512; sub 2483
2513; mul 258 2481; mul 644 2515; sub 2514 2516; mul 433 2481; mul 257 2518; add 2517 2519; mul 335 2513; add 2520
2521; mul 188 2482; mul 35 2523; mul 188 2518; mul 32 2525; add 2524 2526; mul 252 2527; mul 84 2528; mul 33 2528;
mul 746 2530; add 2529 2531; mul 214 2527; mul 37 2533; mul 746 2534; add 2532 2535; mul 247 2527; mul 40 2537; mul
746 2538; add 2536 2539; mul 244 2527; mul 37 2541; mul 37 2542; add 2540 2543; mul 199 2527; mul 40 2545; mul 40
2546; add 2544 2547; mul 197 2527; add 2548 2549; mul 220 2525; mul 84 2551; add 2550 2552; mul 33 2551; mul 746
2554; add 2553 2555; mul 217 2525; mul 37 2557; mul 746 2558; add 2556 2559; mul 214 2525; mul 37 2561; mul 37 2562;
add 2560 2563; mul 211 2525; mul 40 2565; mul 37 2566; add 2564 2567; mul 208 2525; mul 40 2569; mul 40 2570; add
2568 2571; mul 205 2525; add 2572 2573; mul 188 2513; mul 315 2575; mul 40 2576; mul 194 2577; add 2574 2578; mul 4
2576; add 2523 2580; mul 191 2581; add 2579 2582; mul 196 2576; add 2583 2584; mul 33 2576; add 2525 2586; mul 189
2587; add 2585 2588; mul 311 2575; mul 89 2590; add 2589 2591; mul 33 2590; mul 84 2593; add 2592 2594; mul 33 2593;
mul 746 2596; add 2595 2597; mul 252 2575; mul 37 2599; mul 84 2600; add 2598 2601; mul 33 2600; mul 746 2603; add
2602 2604; mul 304 2575; mul 37 2606; mul 37 2607; mul 746 2608; add 2605 2609; mul 247 2575; mul 40 2611; mul 37
2612; mul 746 2613; add 2610 2614; mul 297 2575; mul 40 2616; mul 40 2617; mul 746 2618; add 2615 2619; mul 156
2575; mul 746 2621; add 2620 2622; mul 202 2575; mul 37 2624; mul 37 2625; mul 37 2626; add 2623 2627; mul 199 2575;
mul 40 2629; mul 40 2630; mul 37 2631; add 2628 2632; mul 197 2575; mul 37 2634; add 2633 2635; mul 84 2533; mul 72
2541; add 2637 2638; mul 33 2542; add 2639 2640; mul 237 2527; mul 49 2642; add 2641 2643; mul 37 2642; mul 996
2645; add 2644 2646; mul 234 2527; mul 40 2648; mul 996 2649; add 2647 2650; mul 231 2527; mul 40 2652; mul 40 2653;
add 2651 2654; mul 228 2527; add 2655 2656; mul 84 2557; add 2657 2658; mul 72 2561; add 2659 2660; mul 33 2562; add
2661 2662; mul 33 2566; add 2663 2664; mul 202 2525; mul 49 2666; add 2665 2667; mul 37 2666; mul 996 2669; add 2668
2670; mul 199 2525; mul 40 2672; mul 40 2673; add 2671 2674; mul 197 2525; add 2675 2676; mul 89 2599; add 2677
2678; mul 85 2606; add 2679 2680; mul 84 2607; add 2681 2682; mul 84 2612; add 2683 2684; mul 80 2624; add 2685
2686; mul 72 2625; add 2687 2688; mul 33 2626; add 2689 2690; mul 33 2631; add 2691 2692; mul 33 2634; add 2693
2694; mul 283 2575; mul 57 2696; add 2695 2697; mul 37 2696; mul 49 2699; add 2698 2700; mul 37 2699; mul 996 2702;
add 2701 2703; mul 279 2575; mul 40 2705; mul 49 2706; add 2704 2707; mul 37 2706; mul 996 2709; add 2708 2710; mul
275 2575; mul 40 2712; mul 40 2713; mul 996 2714; add 2711 2715; mul 272 2575; mul 996 2717; add 2716 2718; mul 225
2575; mul 40 2720; mul 40 2721; mul 40 2722; add 2719 2723; mul 223 2575; mul 40 2725; add 2724 2726; mul 32 2727;
add 2636 2728; mul 738 2729; sub 2522 2730; mul 160 166; input p 114; mul 2732 2733; mul 869 2734; mul 155 165; mul
160 2736; add 2735 2737; mul 159 2736; mul 869 2739; add 2738 2740; mul 168 172; mul 869 2742; add 2741 2743; mul
165 172; mul 173 2745; add 2744 2746; mul 551 2747; where 865 2748; mul 35 148; mul 551 2750; add 2749 2751; mul 184
555; neg 2753; where 154 2754; add 2752 2755; mul 150 555; sub 2756 2757; mul 1196 2747; neg 2759; where 865 2760;
mul 1196 2750; sub 2761 2762; mul 184 1202; where 154 2764; add 2763 2765; mul 150 1202; add 2766 2767; input p 117;
mul 40 2769; input p 118; mul 97 2771; add 2770 2772; input p 119; mul 101 2774; add 2773 2775; mul 37 93; add 2776
2777; input p 120; mul 41 2779; add 2778 2780; input p 121; mul 45 2782; add 2781 2783; input p 122; mul 49 2785;
add 2784 2786; mul 53 110; add 2787 2788; input p 123; mul 57 2790; add 2789 2791; mul 39 72; add 2792 2793; input p
124; mul 76 2795; add 2794 2796; mul 52 80; add 2797 2798; input p 125; mul 84 2800; add 2799 2801; mul 67 141; add
2802 2803; mul 85 140; add 2804 2805; mul 1795 2806; neg 2807; mul 543 647; mul 538 555; sub 2809 2810; constant
-2.0; mul 1166 1171; le 1162 1163; le 1163 1162; add 2814 2815; div 12 2816; mul 2814 2817; mul 2813 2818; mul 2812
2819; add 2811 2820; mul 543 1284; mul 538 1202; add 2822 2823; mul 1166 1759; mul 2818 2825; mul 2812 2826; sub
2824 2827; constant 0.8; mul 30 2806; mul 527 1798; sub 2830 2831; mul 1795 2832; mul 1795 2833; mul 2829 2834;
constant -2.5714285714285743; mul 89 920; mul 2836 2837; constant 2.057142857142858; mul 85 920; mul 2839 2840; add
2838 2841; constant -0.8571428571428583; mul 141 920; mul 2843 2844; add 2842 2845; constant -3.428571428571427; mul
80 920; mul 2847 2848; add 2846 2849; constant 0.11428571428571443; mul 76 920; mul 2851 2852; add 2850 2853;
constant -0.057142857142856635; mul 68 920; mul 2855 2856; add 2854 2857; input p 193; mul 33 920; mul 197 2860; mul
2859 2861; add 2858 2862; constant 2.438095238095238; mul 57 920; mul 2864 2865; add 2863 2866; constant
0.6571428571428567; mul 53 920; mul 2868 2869; add 2867 2870; input p 194; mul 49 920; mul 2872 2873; sub 2871 2874;
constant 0.11428571428571413; mul 45 920; mul 2876 2877; add 2875 2878; mul 37 920; mul 228 2880; mul 2859 2881; add
2879 2882; constant -0.019047619047619094; mul 101 920; mul 2884 2885; add 2883 2886; mul 40 920; mul 223 2888; mul
2859 2889; add 2887 2890; constant 12.34285714285715; mul 89 880; mul 2892 2893; sub 2891 2894; constant
-7.714285714285722; mul 85 880; mul 2896 2897; sub 2895 2898; mul 80 880; mul 2839 2900; sub 2899 2901; constant
-1.7142857142857166; mul 76 880; mul 2903 2904; sub 2902 2905; constant 0.9142857142857138; mul 68 880; mul 2907
2908; sub 2906 2909; mul 33 880; mul 205 2911; mul 2859 2912; sub 2910 2913; constant -1.1428571428571423; mul 57
880; mul 2915 2916; sub 2914 2917; constant 0.05714285714285722; mul 53 880; mul 2919 2920; sub 2918 2921; mul 45
880; mul 2855 2923; sub 2922 2924; mul 37 880; mul 197 2926; mul 2859 2927; sub 2925 2928; mul 89 1530; mul 2836
2930; mul 85 1530; mul 2839 2932; add 2931 2933; mul 141 1530; mul 2843 2935; add 2934 2936; mul 80 1530; mul 2847
2938; add 2937 2939; mul 76 1530; mul 2851 2941; add 2940 2942; mul 68 1530; mul 2855 2944; add 2943 2945; mul 33
1530; mul 197 2947; mul 2859 2948; add 2946 2949; mul 57 1530; mul 2864 2951; add 2950 2952; mul 53 1530; mul 2868
2954; add 2953 2955; mul 49 1530; mul 2872 2957; sub 2956 2958; mul 45 1530; mul 2876 2960; add 2959 2961; mul 37
1530; mul 228 2963; mul 2859 2964; add 2962 2965; mul 101 1530; mul 2884 2967; add 2966 2968; mul 40 1530; mul 223
2970; mul 2859 2971; add 2969 2972; mul 89 1495; mul 2892 2974; add 2973 2975; mul 85 1495; mul 2896 2977; add 2976
2978; mul 80 1495; mul 2839 2980; add 2979 2981; mul 76 1495; mul 2903 2983; add 2982 2984; mul 68 1495; mul 2907
2986; add 2985 2987; mul 33 1495; mul 205 2989; mul 2859 2990; add 2988 2991; mul 57 1495; mul 2915 2993; add 2992
2994; mul 53 1495; mul 2919 2996; add 2995 2997; mul 45 1495; mul 2855 2999; add 2998 3000; mul 37 1495; mul 197
3002; mul 2859 3003; add 3001 3004; input p 195; mul 85 3006; mul 2843 3007; mul 141 3006; mul 2907 3009; add 3008
3010; mul 80 3006; mul 2919 3012; add 3011 3013; constant -0.11428571428571327; mul 76 3006; mul 3015 3016; add 3014
3017; constant 0.2190476190476189; mul 57 3006; mul 3019 3020; add 3018 3021; mul 53 3006; mul 2876 3023; add 3022
3024; constant -0.05714285714285729; mul 45 3006; mul 3026 3027; add 3025 3028; mul 37 3006; mul 223 3030; mul 2859
3031; add 3029 3032; constant 0.007256235827664418; mul 101 3006; mul 3034 3035; add 3033 3036; mul 40 3006; mul
1773 3038; mul 2859 3039; add 3037 3040; neg 3041; constant -129.60000000000008; mul 2837 3043; constant
230.40000000000006; mul 2840 3045; add 3044 3046; constant 28.799999999999958; mul 2844 3048; add 3047 3049;
constant -36.00000000000001; mul 84 920; mul 3051 3052; mul 2872 3053; add 3050 3054; constant -151.20000000000002;
mul 2848 3056; add 3055 3057; constant -57.59999999999995; mul 2852 3059; add 3058 3060; constant 72.0; mul 72 920;
mul 3062 3063; mul 2872 3064; add 3061 3065; constant -22.62857142857143; mul 2856 3067; add 3066 3068; constant
28.79999999999999; mul 64 920; mul 3070 3071; mul 2872 3072; add 3069 3073; constant -18.000000000000004; mul 2860
3075; mul 2859 3076; add 3074 3077; constant 35.20000000000001; mul 2865 3079; add 3078 3080; constant
21.59999999999998; mul 2869 3082; add 3081 3083; constant -30.000000000000007; mul 2873 3085; mul 2872 3086; add
3084 3087; constant 13.714285714285717; mul 2877 3089; add 3088 3090; constant -14.399999999999991; mul 41 920; mul
3092 3093; mul 2872 3094; add 3091 3095; mul 531 2880; mul 2859 3097; add 3096 3098; constant 0.4571428571428564;
mul 2885 3100; add 3099 3101; constant -2.3999999999999995; mul 97 920; mul 3103 3104; mul 2872 3105; add 3102 3106;
input p 196; constant -0.9999999999999998; mul 920 3109; mul 3108 3110; add 3107 3111; constant 259.2000000000001;
mul 2893 3113; sub 3112 3114; constant -388.80000000000024; mul 2897 3116; sub 3115 3117; mul 2900 3045; sub 3118
3119; constant 57.599999999999916; mul 2904 3121; sub 3120 3122; constant -72.00000000000001; mul 72 880; mul 3124
3125; mul 2872 3126; sub 3123 3127; constant 45.25714285714287; mul 2908 3129; sub 3128 3130; constant
-57.60000000000001; mul 64 880; mul 3132 3133; mul 2872 3134; sub 3131 3135; constant 36.000000000000014; mul 2911
3137; mul 2859 3138; sub 3136 3139; constant -50.400000000000006; mul 2916 3141; sub 3140 3142; constant
-28.799999999999976; mul 2920 3144; sub 3143 3145; constant 36.0; mul 49 880; mul 3147 3148; mul 2872 3149; sub 3146
3150; mul 2923 3067; sub 3151 3152; mul 41 880; mul 3070 3154; mul 2872 3155; sub 3153 3156; mul 2926 3075; mul 2859
3158; sub 3157 3159; mul 2930 3043; mul 2932 3045; add 3161 3162; mul 2935 3048; add 3163 3164; mul 84 1530; mul
3051 3166; mul 2872 3167; add 3165 3168; mul 2938 3056; add 3169 3170; mul 2941 3059; add 3171 3172; mul 72 1530;
mul 3062 3174; mul 2872 3175; add 3173 3176; mul 2944 3067; add 3177 3178; mul 64 1530; mul 3070 3180; mul 2872
3181; add 3179 3182; mul 2947 3075; mul 2859 3184; add 3183 3185; mul 2951 3079; add 3186 3187; mul 2954 3082; add
3188 3189; mul 2957 3085; mul 2872 3191; add 3190 3192; mul 2960 3089; add 3193 3194; mul 41 1530; mul 3092 3196;
mul 2872 3197; add 3195 3198; mul 531 2963; mul 2859 3200; add 3199 3201; mul 2967 3100; add 3202 3203; mul 97 1530;
mul 3103 3205; mul 2872 3206; add 3204 3207; mul 1530 3109; mul 3108 3209; add 3208 3210; mul 2974 3113; add 3211
3212; mul 2977 3116; add 3213 3214; mul 2980 3045; add 3215 3216; mul 2983 3121; add 3217 3218; mul 72 1495; mul
3124 3220; mul 2872 3221; add 3219 3222; mul 2986 3129; add 3223 3224; mul 64 1495; mul 3132 3226; mul 2872 3227;
add 3225 3228; mul 2989 3137; mul 2859 3230; add 3229 3231; mul 2993 3141; add 3232 3233; mul 2996 3144; add 3234
3235; mul 49 1495; mul 3147 3237; mul 2872 3238; add 3236 3239; mul 2999 3067; add 3240 3241; mul 41 1495; mul 3070
3243; mul 2872 3244; add 3242 3245; mul 3002 3075; mul 2859 3247; add 3246 3248; mul 3007 3048; mul 3009 3129; add
3250 3251; constant -28.800000000000004; mul 84 3006; mul 3253 3254; mul 2872 3255; add 3252 3256; mul 3012 3144;
add 3257 3258; constant -45.25714285714286; mul 3016 3260; add 3259 3261; mul 72 3006; mul 3070 3263; mul 2872 3264;
add 3262 3265; constant 7.199999999999994; mul 3020 3267; add 3266 3268; mul 3023 3089; add 3269 3270; constant
-7.199999999999996; mul 49 3006; mul 3272 3273; mul 2872 3274; add 3271 3275; constant 1.3714285714285692; mul 3027
3277; add 3276 3278; constant -4.799999999999999; mul 41 3006; mul 3280 3281; mul 2872 3282; add 3279 3283; constant
1.3714285714285714; mul 3035 3285; add 3284 3286; constant -1.3714285714285723; mul 97 3006; mul 3288 3289; mul 2872
3290; add 3287 3291; constant 2.400000000000001; mul 3038 3293; mul 2859 3294; add 3292 3295; neg 3296; constant
-0.12857142857142845; mul 89 743; mul 3298 3299; constant 0.12857142857142853; mul 85 743; mul 3301 3302; add 3300
3303; constant -0.04285714285714284; mul 141 743; mul 3305 3306; add 3304 3307; constant 0.010714285714285735; mul
80 743; mul 3309 3310; add 3308 3311; constant -0.0006802721088435403; mul 68 743; mul 3313 3314; add 3312 3315;
constant 0.028571428571428567; mul 57 743; mul 3317 3318; add 3316 3319; constant -0.010714285714285721; mul 53 743;
mul 3321 3322; add 3320 3323; constant 0.0027210884353741486; mul 45 743; mul 3325 3326; add 3324 3327; constant
-0.0004787100025195255; mul 101 743; mul 3329 3330; add 3328 3331; constant 1.0285714285714285; mul 89 741; mul 3333
3334; add 3332 3335; constant -0.38571428571428534; mul 85 741; mul 3337 3338; add 3336 3339; mul 80 741; mul 3301
3341; add 3340 3342; constant -0.08571428571428567; mul 76 741; mul 3344 3345; add 3343 3346; constant
0.029931972789115628; mul 68 741; mul 3348 3349; add 3347 3350; constant 0.0035714285714285787; mul 57 741; mul 3352
3353; add 3351 3354; mul 45 741; mul 3313 3356; add 3355 3357; constant 0.2571428571428571; mul 312 792; mul 3359
3360; add 3358 3361; mul 308 792; mul 3298 3363; add 3362 3364; constant 0.06428571428571427; mul 305 792; mul 3366
3367; add 3365 3368; mul 301 792; mul 3305 3370; add 3369 3371; constant 0.014965986394557814; mul 298 792; mul 3373
3374; add 3372 3375; mul 292 792; mul 3352 3377; add 3376 3378; mul 289 792; mul 3313 3380; add 3379 3381; constant
0.007142857142857142; mul 284 792; mul 3383 3384; add 3382 3385; constant -0.003571428571428574; mul 280 792; mul
3387 3388; add 3386 3389; constant 0.0013605442176870743; mul 276 792; mul 3391 3392; add 3390 3393; mul 269 792;
mul 3329 3395; add 3394 3396; constant 8.118473726939319e-05; mul 264 792; mul 3398 3399; add 3397 3400; mul 89
1371; mul 3298 3402; mul 85 1371; mul 3301 3404; add 3403 3405; mul 141 1371; mul 3305 3407; add 3406 3408; mul 80
1371; mul 3309 3410; add 3409 3411; mul 68 1371; mul 3313 3413; add 3412 3414; mul 57 1371; mul 3317 3416; add 3415
3417; mul 53 1371; mul 3321 3419; add 3418 3420; mul 45 1371; mul 3325 3422; add 3421 3423; mul 101 1371; mul 3329
3425; add 3424 3426; mul 89 1369; mul 3333 3428; sub 3427 3429; mul 85 1369; mul 3337 3431; sub 3430 3432; mul 80
1369; mul 3301 3434; sub 3433 3435; mul 76 1369; mul 3344 3437; sub 3436 3438; mul 68 1369; mul 3348 3440; sub 3439
3441; mul 57 1369; mul 3352 3443; sub 3442 3444; mul 45 1369; mul 3313 3446; sub 3445 3447; mul 312 1419; mul 3359
3449; add 3448 3450; mul 308 1419; mul 3298 3452; add 3451 3453; mul 305 1419; mul 3366 3455; add 3454 3456; mul 301
1419; mul 3305 3458; add 3457 3459; mul 298 1419; mul 3373 3461; add 3460 3462; mul 292 1419; mul 3352 3464; add
3463 3465; mul 289 1419; mul 3313 3467; add 3466 3468; mul 284 1419; mul 3383 3470; add 3469 3471; mul 280 1419; mul
3387 3473; add 3472 3474; mul 276 1419; mul 3391 3476; add 3475 3477; mul 269 1419; mul 3329 3479; add 3478 3480;
mul 264 1419; mul 3398 3482; add 3481 3483; mul 85 1933; mul 3305 3485; mul 141 1933; mul 3348 3487; add 3486 3488;
constant -0.0013605442176870806; mul 76 1933; mul 3490 3491; add 3489 3492; mul 57 1933; mul 3387 3494; add 3493
3495; mul 53 1933; mul 3325 3497; add 3496 3498; constant -0.0014361300075585765; mul 45 1933; mul 3500 3501; add
3499 3502; constant 0.00032473894907757275; mul 101 1933; mul 3504 3505; add 3503 3506; mul 89 1971; mul 3298 3508;
sub 3507 3509; mul 85 1971; mul 3301 3511; sub 3510 3512; mul 141 1971; mul 3305 3514; sub 3513 3515; mul 80 1971;
mul 3309 3517; sub 3516 3518; mul 68 1971; mul 3313 3520; sub 3519 3521; mul 57 1971; mul 3317 3523; sub 3522 3524;
mul 53 1971; mul 3321 3526; sub 3525 3527; mul 45 1971; mul 3325 3529; sub 3528 3530; mul 101 1971; mul 3329 3532;
sub 3531 3533; mul 89 1969; mul 3333 3535; sub 3534 3536; mul 85 1969; mul 3337 3538; sub 3537 3539; mul 80 1969;
mul 3301 3541; sub 3540 3542; mul 76 1969; mul 3344 3544; sub 3543 3545; mul 68 1969; mul 3348 3547; sub 3546 3548;
mul 57 1969; mul 3352 3550; sub 3549 3551; mul 45 1969; mul 3313 3553; sub 3552 3554; mul 312 2020; mul 3359 3556;
add 3555 3557; mul 308 2020; mul 3298 3559; add 3558 3560; mul 305 2020; mul 3366 3562; add 3561 3563; mul 301 2020;
mul 3305 3565; add 3564 3566; mul 298 2020; mul 3373 3568; add 3567 3569; mul 292 2020; mul 3352 3571; add 3570
3572; mul 289 2020; mul 3313 3574; add 3573 3575; mul 284 2020; mul 3383 3577; add 3576 3578; mul 280 2020; mul 3387
3580; add 3579 3581; mul 276 2020; mul 3391 3583; add 3582 3584; mul 269 2020; mul 3329 3586; add 3585 3587; mul 264
2020; mul 3398 3589; add 3588 3590; mul 89 2276; mul 3298 3592; mul 85 2276; mul 3301 3594; add 3593 3595; mul 141
2276; mul 3305 3597; add 3596 3598; mul 80 2276; mul 3309 3600; add 3599 3601; mul 68 2276; mul 3313 3603; add 3602
3604; mul 57 2276; mul 3317 3606; add 3605 3607; mul 53 2276; mul 3321 3609; add 3608 3610; mul 45 2276; mul 3325
3612; add 3611 3613; mul 101 2276; mul 3329 3615; add 3614 3616; mul 89 2274; mul 3333 3618; add 3617 3619; mul 85
2274; mul 3337 3621; add 3620 3622; mul 80 2274; mul 3301 3624; add 3623 3625; mul 76 2274; mul 3344 3627; add 3626
3628; mul 68 2274; mul 3348 3630; add 3629 3631; mul 57 2274; mul 3352 3633; add 3632 3634; mul 45 2274; mul 3313
3636; add 3635 3637; mul 312 2324; mul 3359 3639; add 3638 3640; mul 308 2324; mul 3298 3642; add 3641 3643; mul 305
2324; mul 3366 3645; add 3644 3646; mul 301 2324; mul 3305 3648; add 3647 3649; mul 298 2324; mul 3373 3651; add
3650 3652; mul 292 2324; mul 3352 3654; add 3653 3655; mul 289 2324; mul 3313 3657; add 3656 3658; mul 284 2324; mul
3383 3660; add 3659 3661; mul 280 2324; mul 3387 3663; add 3662 3664; mul 276 2324; mul 3391 3666; add 3665 3667;
mul 269 2324; mul 3329 3669; add 3668 3670; mul 264 2324; mul 3398 3672; add 3671 3673; mul 89 2527; mul 3298 3675;
mul 85 2527; mul 3301 3677; add 3676 3678; mul 141 2527; mul 3305 3680; add 3679 3681; mul 80 2527; mul 3309 3683;
add 3682 3684; mul 68 2527; mul 3313 3686; add 3685 3687; mul 57 2527; mul 3317 3689; add 3688 3690; mul 53 2527;
mul 3321 3692; add 3691 3693; mul 45 2527; mul 3325 3695; add 3694 3696; mul 101 2527; mul 3329 3698; add 3697 3699;
mul 89 2525; mul 3333 3701; add 3700 3702; mul 85 2525; mul 3337 3704; add 3703 3705; mul 80 2525; mul 3301 3707;
add 3706 3708; mul 76 2525; mul 3344 3710; add 3709 3711; mul 68 2525; mul 3348 3713; add 3712 3714; mul 57 2525;
mul 3352 3716; add 3715 3717; mul 45 2525; mul 3313 3719; add 3718 3720; mul 312 2575; mul 3359 3722; add 3721 3723;
mul 308 2575; mul 3298 3725; add 3724 3726; mul 305 2575; mul 3366 3728; add 3727 3729; mul 301 2575; mul 3305 3731;
add 3730 3732; mul 298 2575; mul 3373 3734; add 3733 3735; mul 292 2575; mul 3352 3737; add 3736 3738; mul 289 2575;
mul 3313 3740; add 3739 3741; mul 284 2575; mul 3383 3743; add 3742 3744; mul 280 2575; mul 3387 3746; add 3745
3747; mul 276 2575; mul 3391 3749; add 3748 3750; mul 269 2575; mul 3329 3752; add 3751 3753; mul 264 2575; mul 3398
3755; add 3754 3756; input p 197; mul 3053 3758; mul 3064 3758; add 3759 3760; mul 3072 3758; add 3761 3762; input p
198; input p 199; mul 2861 3765; mul 3764 3766; add 3763 3767; mul 3076 3758; mul 3764 3769; add 3768 3770; mul 2873
3765; sub 3771 3772; mul 3086 3758; add 3773 3774; mul 3094 3758; add 3775 3776; mul 2881 3765; mul 3764 3778; add
3777 3779; mul 3097 3758; mul 3764 3781; add 3780 3782; mul 3105 3758; add 3783 3784; mul 2889 3765; mul 3764 3786;
add 3785 3787; mul 3110 3758; mul 2859 3789; add 3788 3790; mul 2872 3789; mul 3764 3792; add 3791 3793; add 3110
3794; mul 3126 3758; sub 3795 3796; mul 3134 3758; sub 3797 3798; mul 2912 3765; mul 3764 3800; sub 3799 3801; mul
3138 3758; mul 3764 3803; sub 3802 3804; mul 3149 3758; sub 3805 3806; mul 3155 3758; sub 3807 3808; mul 2927 3765;
mul 3764 3810; sub 3809 3811; mul 3158 3758; mul 3764 3813; sub 3812 3814; mul 3167 3758; mul 3175 3758; add 3816
3817; mul 3181 3758; add 3818 3819; mul 2948 3765; mul 3764 3821; add 3820 3822; mul 3184 3758; mul 3764 3824; add
3823 3825; mul 2957 3765; sub 3826 3827; mul 3191 3758; add 3828 3829; mul 3197 3758; add 3830 3831; mul 2964 3765;
mul 3764 3833; add 3832 3834; mul 3200 3758; mul 3764 3836; add 3835 3837; mul 3206 3758; add 3838 3839; mul 2971
3765; mul 3764 3841; add 3840 3842; mul 3209 3758; mul 2859 3844; add 3843 3845; mul 2872 3844; mul 3764 3847; add
3846 3848; add 3209 3849; mul 3221 3758; add 3850 3851; mul 3227 3758; add 3852 3853; mul 2990 3765; mul 3764 3855;
add 3854 3856; mul 3230 3758; mul 3764 3858; add 3857 3859; mul 3238 3758; add 3860 3861; mul 3244 3758; add 3862
3863; mul 3003 3765; mul 3764 3865; add 3864 3866; mul 3247 3758; mul 3764 3868; add 3867 3869; mul 3255 3758; mul
3264 3758; add 3871 3872; mul 3274 3758; add 3873 3874; mul 3282 3758; add 3875 3876; mul 3031 3765; mul 3764 3878;
add 3877 3879; mul 3290 3758; add 3880 3881; mul 3039 3765; mul 3764 3883; add 3882 3884; mul 3294 3758; mul 3764
3886; add 3885 3887; neg 3888; mul 433 653; mul 544 555; sub 3890 3891; mul 254 741; add 3892 3893; mul 148 880; sub
3894 3895; mul 33 1143; add 3896 3897; mul 544 1202; mul 433 1290; add 3899 3900; mul 254 1369; sub 3901 3902; mul
148 1495; add 3903 3904; mul 33 1752; add 3905 3906; mul 33 2225; mul 254 1969; sub 3908 3909; mul 254 2274; mul 33
2476; add 3911 3912; mul 254 2525; mul 33 2727; add 3914 3915; mul 544 551; mul 148 866; add 3917 3918; mul 418 653;
add 3919 3920; mul 254 739; add 3921 3922; mul 4 1143; add 3923 3924; mul 418 1290; mul 544 1196; mul 148 1481; add
3927 3928; sub 3926 3929; mul 254 1367; add 3930 3931; mul 4 1752; add 3932 3933; mul 4 2225; mul 254 1967; sub 3935
3936; mul 254 2272; mul 4 2476; add 3938 3939; mul 254 2523; mul 4 2727; add 3941 3942; mul 33 804; mul 33 1431; mul
33 2033; mul 33 2336; mul 33 2587; mul 33 798; mul 4 804; add 3949 3950; mul 33 1425; mul 4 1431; add 3952 3953; mul
33 2027; mul 4 2033; add 3955 3956; mul 33 2330; mul 4 2336; add 3958 3959; mul 33 2581; mul 4 2587; add 3961 3962;
mul 4 798; mul 4 1425; mul 4 2027; mul 4 2330; mul 4 2581; mul 33 794; mul 40 804; add 3969 3970; mul 33 1421; mul
40 1431; add 3972 3973; mul 33 2023; mul 40 2033; add 3975 3976; mul 33 2326; mul 40 2336; add 3978 3979; mul 33
2577; mul 40 2587; add 3981 3982; mul 4 794; mul 40 798; add 3984 3985; mul 4 1421; mul 40 1425; add 3987 3988; mul
4 2023; mul 40 2027; add 3990 3991; mul 4 2326; mul 40 2330; add 3993 3994; mul 4 2577; mul 40 2581; add 3996 3997;
mul 40 794; mul 40 1421; mul 40 2023; mul 40 2326; mul 40 2577; mul 452 570; mul 450 4004; mul 459 570; mul 447
4006; add 4005 4007; mul 447 628; add 4008 4009; mul 468 604; mul 510 570; add 4011 4012; mul 166 459; mul 626 4014;
add 4013 4015; mul 450 4016; sub 4010 4017; mul 358 675; mul 354 4019; sub 4018 4020; mul 365 675; mul 351 4022; add
4021 4023; mul 351 733; add 4024 4025; mul 374 709; mul 419 675; add 4027 4028; mul 166 365; mul 731 4030; add 4029
4031; mul 354 4032; add 4026 4033; mul 349 4034; mul 450 4006; input p 115; mul 426 551; mul 4037 4038; mul 447
4004; add 4039 4040; sub 4036 4041; mul 450 628; add 4042 4043; mul 447 4016; add 4044 4045; mul 351 4019; sub 4046
4047; mul 354 4022; sub 4048 4049; mul 354 733; sub 4050 4051; mul 351 4032; add 4052 4053; mul 349 4054; mul 4
4055; mul 349 426; mul 515 568; mul 356 4037; mul 551 4059; sub 4058 4060; mul 424 673; add 4061 4062; mul 4057
4063; mul 349 356; mul 4054 4065; add 4064 4066; mul 349 350; mul 4034 4068; add 4067 4069; mul 346 4070; sub 4056
4071; mul 166 347; div 12 4073; mul 4072 4074; add 4035 4075; mul 4 4076; mul 4 4077; mul 425 425; mul 349 4063; mul
4079 4080; mul 347 4070; add 4081 4082; mul 166 346; div 12 4084; mul 4083 4085; mul 4 4086; mul 4 4087; sub 4078
4088; mul 447 1279; mul 452 1276; mul 450 4091; mul 459 1276; mul 447 4093; add 4092 4094; sub 4090 4095; mul 468
1243; mul 510 1276; sub 4097 4098; mul 1273 4014; add 4099 4100; mul 450 4101; sub 4096 4102; mul 358 1308; mul 354
4104; add 4103 4105; mul 365 1308; mul 351 4107; sub 4106 4108; mul 351 1362; add 4109 4110; mul 374 1337; mul 419
1308; sub 4112 4113; mul 1360 4030; add 4114 4115; mul 354 4116; add 4111 4117; mul 349 4118; mul 426 1196; mul 4037
4120; mul 447 4091; add 4121 4122; mul 450 4093; sub 4123 4124; mul 450 1279; add 4125 4126; mul 447 4101; add 4127
4128; mul 351 4104; add 4129 4130; mul 354 4107; add 4131 4132; mul 354 1362; sub 4133 4134; mul 351 4116; add 4135
4136; mul 349 4137; mul 4 4138; mul 1196 4059; mul 515 1252; sub 4140 4141; mul 424 1306; sub 4142 4143; mul 4057
4144; mul 4065 4137; add 4145 4146; mul 4068 4118; add 4147 4148; mul 346 4149; sub 4139 4150; mul 4074 4151; add
4119 4152; mul 4 4153; mul 4 4154; mul 349 4144; mul 4079 4156; mul 347 4149; add 4157 4158; mul 4085 4159; mul 4
4160; mul 4 4161; sub 4155 4162; mul 515 1830; mul 424 1873; add 4164 4165; mul 349 4166; mul 4079 4167; mul 4057
4166; mul 452 1854; mul 447 4170; mul 459 1854; mul 450 4172; sub 4171 4173; mul 450 1857; add 4174 4175; mul 468
1823; mul 510 1854; sub 4177 4178; mul 1851 4014; add 4179 4180; mul 447 4181; add 4176 4182; mul 358 1875; mul 351
4184; add 4183 4185; mul 365 1875; mul 354 4187; add 4186 4188; mul 354 1928; sub 4189 4190; mul 374 1903; mul 419
1875; sub 4192 4193; mul 1926 4030; add 4194 4195; mul 351 4196; add 4191 4197; mul 4065 4198; sub 4169 4199; mul
447 1857; mul 450 4170; mul 447 4172; add 4202 4203; sub 4201 4204; mul 450 4181; sub 4205 4206; mul 354 4184; add
4207 4208; mul 351 4187; sub 4209 4210; mul 351 1928; add 4211 4212; mul 354 4196; add 4213 4214; mul 4068 4215; sub
4200 4216; mul 347 4217; add 4168 4218; mul 4085 4219; mul 4 4220; mul 4 4221; mul 349 4215; mul 349 4198; mul 4
4224; mul 346 4217; add 4225 4226; mul 4074 4227; add 4223 4228; mul 4 4229; mul 4 4230; add 4222 4231; mul 365
2243; mul 351 4233; mul 358 2243; mul 354 4235; sub 4234 4236; mul 351 2268; add 4237 4238; mul 419 2243; mul 374
2255; sub 4240 4241; mul 2266 4030; sub 4242 4243; mul 354 4244; add 4239 4245; mul 349 4246; mul 351 4244; mul 351
4235; mul 354 4233; add 4249 4250; mul 354 2268; add 4251 4252; sub 4248 4253; mul 349 4254; mul 4 4255; mul 424
2241; mul 4057 4257; mul 4065 4254; add 4258 4259; mul 4068 4246; add 4260 4261; mul 346 4262; sub 4256 4263; mul
4074 4264; add 4247 4265; mul 4 4266; mul 4 4267; mul 349 4257; mul 4079 4269; mul 347 4262; add 4270 4271; mul 4085
4272; mul 4 4273; mul 4 4274; sub 4268 4275; mul 452 2488; mul 450 4277; mul 459 2488; mul 447 4279; add 4278 4280;
mul 447 2513; add 4281 4282; mul 510 2488; mul 468 2500; sub 4284 4285; mul 2511 4014; sub 4286 4287; mul 450 4288;
sub 4283 4289; mul 349 4290; mul 450 4279; mul 447 4277; sub 4292 4293; mul 450 2513; add 4294 4295; mul 447 4288;
add 4296 4297; mul 349 4298; mul 4 4299; mul 515 2486; mul 4057 4301; mul 4065 4298; add 4302 4303; mul 4068 4290;
add 4304 4305; mul 346 4306; sub 4300 4307; mul 4074 4308; add 4291 4309; mul 4 4310; mul 4 4311; mul 349 4301; mul
4079 4313; mul 347 4306; add 4314 4315; mul 4085 4316; mul 4 4317; mul 4 4318; sub 4312 4319; mul 180 881; neg 4321;
where 154 4322; mul 180 1496; where 154 4324; mul 866 2745; where 865 4326; mul 165 881; mul 172 880; add 4328 4329;
mul 159 4330; neg 4331; where 154 4332; add 4327 4333; mul 1481 2745; neg 4335; where 865 4336; mul 165 1496; mul
172 1495; add 4338 4339; mul 159 4340; where 154 4341; add 4337 4342; mul 172 870; where 865 4344; mul 160 881; neg
4346; where 154 4347; add 4345 4348; mul 172 1484; neg 4350; where 865 4351; mul 160 1496; where 154 4353; add 4352
4354; mul 165 876; where 865 4356; mul 161 880; neg 4358; where 154 4359; add 4357 4360; mul 165 1490; neg 4362;
where 865 4363; mul 161 1495; where 154 4365; add 4364 4366; mul 870 2732; where 865 4368; mul 1484 2732; neg 4370;
where 865 4371; input c 0; input c 2; mul 388 4374; add 4373 4375; input c 3; mul 481 4377; add 4376 4378; mul 1152
1186; add 4379 4380; mul 1150 1168; sub 4381 4382; input p 2; input c 1; add 4384 4385; constant 0.0; max 4386 4387;
mul 429 4388; sub 4383 4389; mul 430 443; mul 518 524; add 4391 4392; sub 548 4393; sub 4390 4394; input p 99; input
p 100; input z 0; mul 4397 4398; input p 101; input z 1; mul 4400 4401; add 4399 4402; input p 102; input z 2; mul
4404 4405; add 4403 4406; input p 103; input z 3; mul 4408 4409; add 4407 4410; sub 4396 4411; input p 104; abs 429;
mul 4413 4414; mul 429 4415; sub 4412 4416; add 4395 4417; input p 105; input x 11; sub 1 4420; mul 4419 4421; input
p 106; input x 12; sub 1 4424; mul 4423 4425; add 4422 4426; sub 4418 4427; mul 13 429; input p 110; mul 418 4430;
add 4429 4431; mul 429 4432; mul 5 418; mul 418 4434; add 4433 4435; mul 8 4436; mul 16 4437; sub 4428 4438; mul 11
4439; mul 30 2750; mul 30 2747; where 865 4442; add 4441 4443; mul 437 527; sub 4444 4445; mul 35 544; add 4446
4447; mul 427 443; mul 516 524; add 4449 4450; add 4448 4451; sub 1168 4452; mul 426 4059; add 4453 4454; input p
116; mul 4411 4456; sub 4455 4457; mul 7 4437; sub 4458 4459; mul 24 4460; sub 4440 4461; mul 27 4462; mul 27 4463;
mul 24 166; mul 4464 4465; mul 27 4460; sub 4466 4467; mul 7 4468; mul 16 4469; mul 11 4464; mul 18 4471; sub 4470
4472; mul 27 4439; mul 19 4464; sub 4474 4475; mul 7 4476; mul 7 4477; add 4473 4478; mul 7 551; mul 16 28; sub 4480
4481; mul 4436 4482; add 4479 4483; mul 19 4460; mul 24 4439; sub 4485 4486; mul 27 4487; mul 27 4488; mul 11 4489;
sub 4467 4490; mul 18 4491; mul 4465 4489; sub 4493 4474; mul 7 4494; mul 16 4495; add 4492 4496; mul 19 4489; mul 7
4498; mul 7 4499; sub 4497 4500; mul 16 551; mul 7 1196; sub 4502 4503; mul 4436 4504; add 4501 4505; neg 4498; mul
8 4482; mul 429 4508; mul 429 4509; mul 8 4469; mul 16 166; mul 8 4471; mul 4512 4513; sub 4511 4514; mul 28 4437;
sub 4515 4516; mul 1 4517; add 4510 4518; mul 8 4504; mul 429 4520; mul 429 4521; mul 8 4491; mul 4512 4523; mul 8
4495; add 4524 4525; mul 551 4437; add 4526 4527; mul 1 4528; add 4522 4529; mul 22 4468; add 4527 4531; mul 9 4476;
add 4532 4533; mul 8 4477; add 4534 4535; mul 1 4536; mul 418 4509; mul 166 4538; add 4537 4539; mul 4 4517; add
4540 4541; mul 22 4494; mul 1196 4437; sub 4543 4544; mul 9 4498; sub 4545 4546; mul 8 4499; sub 4547 4548; mul 1
4549; mul 418 4521; mul 166 4551; add 4550 4552; mul 4 4528; add 4553 4554; mul 4 4536; mul 418 4508; mul 418 4557;
add 4556 4558; mul 4 4549; mul 418 4520; mul 418 4561; add 4560 4562; input p 200; mul 356 4038; mul 4564 4565; sub
558 4566; mul 356 4120; mul 4564 4568; add 1204 4569; mul 259 4565; neg 4571; mul 259 4568; neg 551; neg 398; neg
491; neg 401; neg 494; neg 405; neg 498; le 4387 4386; le 4386 4387; add 4581 4582; div 12 4583; mul 4581 4584; mul
28 429; mul 4585 4586; neg 4587; mul 429 551; mul 4585 4589; mul 4414 4586; neg 4591; mul 4414 4589; mul 551 4411;
mul 1196 4411; neg 4595; le 12 4398; mul 418 4456; add 429 4598; lt 4387 4599; and 4597 4600; constant -1.0; le 4398
4602; lt 4599 4387; and 4603 4604; or 4601 4605; not 4606; input p 135; mul 418 4608; where 4607 4609; le 12 4401;
and 4600 4611; le 4401 4602; and 4604 4613; or 4612 4614; not 4615; input p 136; mul 418 4617; where 4616 4618; le
12 4405; and 4600 4620; le 4405 4602; and 4604 4622; or 4621 4623; not 4624; input p 137; mul 418 4626; where 4625
4627; le 12 4409; and 4600 4629; le 4409 4602; and 4604 4631; or 4630 4632; not 4633; input p 138; mul 418 4635;
where 4634 4636; mul 350 4032; mul 350 4019; mul 356 4022; add 4639 4640; mul 356 733; add 4641 4642; sub 4638 4643;
mul 350 4104; mul 356 4107; add 4645 4646; mul 356 1362; sub 4647 4648; mul 350 4116; add 4649 4650; mul 350 4184;
mul 356 4187; add 4652 4653; mul 356 1928; sub 4654 4655; mul 350 4196; add 4656 4657; mul 350 4244; mul 350 4235;
mul 356 4233; add 4660 4661; mul 356 2268; add 4662 4663; sub 4659 4664; mul 350 4022; mul 356 4019; sub 4666 4667;
mul 350 733; add 4668 4669; mul 356 4032; add 4670 4671; mul 356 4104; mul 350 4107; sub 4673 4674; mul 350 1362;
add 4675 4676; mul 356 4116; add 4677 4678; mul 356 4184; mul 350 4187; sub 4680 4681; mul 350 1928; add 4682 4683;
mul 356 4196; add 4684 4685; mul 350 4233; mul 356 4235; sub 4687 4688; mul 350 2268; add 4689 4690; mul 356 4244;
add 4691 4692; neg 4032; neg 4116; neg 4196; neg 4244; mul 359 374; mul 713 4698; mul 359 412; mul 696 4700; add
4699 4701; mul 359 396; mul 635 4703; add 4702 4704; mul 359 370; mul 729 4706; add 4705 4707; neg 4708; mul 1327
4700; mul 1342 4698; sub 4710 4711; mul 1213 4703; add 4712 4713; mul 1358 4706; sub 4714 4715; mul 1894 4700; mul
1908 4698; sub 4717 4718; mul 1860 4703; add 4719 4720; mul 1924 4706; sub 4721 4722; mul 2264 4706; mul 2259 4698;
mul 441 4700; add 4725 4726; sub 4724 4727; mul 380 715; mul 380 1344; neg 4730; mul 380 1910; neg 4732; mul 384
682; mul 384 1318; neg 4735; mul 384 1885; neg 4737; mul 393 681; mul 388 4739; neg 4740; mul 393 1315; mul 388
4742; mul 393 1882; mul 388 4744; mul 384 684; neg 4746; mul 384 1316; mul 384 1883; mul 412 635; mul 398 4750; mul
412 1213; mul 398 4752; neg 4753; mul 412 1860; mul 398 4755; neg 4756; mul 401 4750; mul 401 4752; neg 4759; mul
401 4755; neg 4761; mul 405 4750; mul 405 4752; neg 4764; mul 405 4755; neg 4766; mul 412 692; mul 412 1323; neg
4769; mul 412 1890; neg 4771; mul 350 4004; mul 356 4006; add 4773 4774; mul 356 628; add 4775 4776; mul 350 4016;
sub 4777 4778; mul 356 1279; mul 350 4091; mul 356 4093; add 4781 4782; sub 4780 4783; mul 350 4101; sub 4784 4785;
mul 356 1857; mul 350 4170; mul 356 4172; add 4788 4789; sub 4787 4790; mul 350 4181; sub 4791 4792; mul 350 4277;
mul 356 4279; add 4794 4795; mul 356 2513; add 4796 4797; mul 350 4288; sub 4798 4799; mul 350 4006; mul 356 4004;
sub 4801 4802; mul 350 628; add 4803 4804; mul 356 4016; add 4805 4806; mul 356 4091; mul 350 4093; sub 4808 4809;
mul 350 1279; add 4810 4811; mul 356 4101; add 4812 4813; mul 356 4170; mul 350 4172; sub 4815 4816; mul 350 1857;
add 4817 4818; mul 356 4181; add 4819 4820; mul 350 4279; mul 356 4277; sub 4822 4823; mul 350 2513; add 4824 4825;
mul 356 4288; add 4826 4827; mul 453 468; mul 608 4829; mul 453 504; mul 591 4831; add 4830 4832; mul 453 489; mul
560 4834; add 4833 4835; mul 453 464; mul 624 4837; add 4836 4838; neg 4839; mul 1233 4831; mul 1255 4829; sub 4841
4842; mul 1206 4834; add 4843 4844; mul 1271 4837; sub 4845 4846; mul 1813 4831; mul 1833 4829; sub 4848 4849; mul
1800 4834; add 4850 4851; mul 1849 4837; sub 4852 4853; mul 2509 4837; mul 2504 4829; mul 522 4831; add 4856 4857;
sub 4855 4858; mul 474 610; mul 474 1257; neg 4861; mul 474 1835; neg 4863; mul 477 577; mul 477 1224; neg 4866; mul
477 1804; neg 4868; mul 486 576; mul 481 4870; neg 4871; mul 486 1221; mul 481 4873; mul 486 1801; mul 481 4875; mul
477 579; neg 4877; mul 477 1222; mul 477 1802; mul 504 560; mul 491 4881; mul 504 1206; mul 491 4883; neg 4884; mul
504 1800; mul 491 4886; neg 4887; mul 494 4881; mul 494 4883; neg 4890; mul 494 4886; neg 4892; mul 498 4881; mul
498 4883; neg 4895; mul 498 4886; neg 4897; mul 504 587; mul 504 1229; neg 4900; mul 504 1809; neg 4902; mul 551
4456; sub 4904 28; mul 4398 4905; mul 1196 4456; sub 551 4907; mul 4398 4908; mul 4401 4905; mul 4401 4908; mul 4405
4905; mul 4405 4908; mul 4409 4905; mul 4409 4908; mul 4599 4608; mul 4608 4916; neg 4917; where 4607 4918; mul 4599
4617; mul 4617 4920; neg 4921; where 4616 4922; mul 4599 4626; mul 4626 4924; neg 4925; where 4625 4926; mul 4599
4635; mul 4635 4928; neg 4929; where 4634 4930; mul 28 4421; neg 4932; mul 551 4421; mul 28 4425; neg 4935; mul 551
4425; mul 29 1193; neg 4938; mul 29 1770; store by_k 75 1195; store by_k 225 1772; store by_k 300 2229; store by_k
375 2480; store by_k 450 2731; store by_k 525 2480; store by_k 600 2731; store by_k 675 2480; store by_k 750 2731;
store by_k 76 2758; store by_k 226 2768; store by_k 301 2808; store by_k 77 2821; store by_k 227 2828; store by_k
302 2835; store by_k 78 2929; store by_k 228 3005; store by_k 303 3042; store by_k 79 3160; store by_k 229 3249;
store by_k 304 3297; store by_k 80 3401; store by_k 230 3484; store by_k 305 3591; store by_k 380 3674; store by_k
455 3757; store by_k 530 3674; store by_k 605 3757; store by_k 680 3674; store by_k 755 3757; store by_k 81 3815;
store by_k 231 3870; store by_k 306 3889; store by_k 82 3898; store by_k 232 3907; store by_k 307 3910; store by_k
382 3913; store by_k 457 3916; store by_k 532 3913; store by_k 607 3916; store by_k 682 3913; store by_k 757 3916;
store by_k 83 3925; store by_k 233 3934; store by_k 308 3937; store by_k 383 3940; store by_k 458 3943; store by_k
533 3940; store by_k 608 3943; store by_k 683 3940; store by_k 758 3943; store by_k 84 3944; store by_k 234 3945;
store by_k 309 3946; store by_k 384 3947; store by_k 459 3948; store by_k 534 3947; store by_k 609 3948; store by_k
684 3947; store by_k 759 3948; store by_k 85 3951; store by_k 235 3954; store by_k 310 3957; store by_k 385 3960;
store by_k 460 3963; store by_k 535 3960; store by_k 610 3963; store by_k 685 3960; store by_k 760 3963; store by_k
86 3964; store by_k 236 3965; store by_k 311 3966; store by_k 386 3967; store by_k 461 3968; store by_k 536 3967;
store by_k 611 3968; store by_k 686 3967; store by_k 761 3968; store by_k 87 3971; store by_k 237 3974; store by_k
312 3977; store by_k 387 3980; store by_k 462 3983; store by_k 537 3980; store by_k 612 3983; store by_k 687 3980;
store by_k 762 3983; store by_k 88 3986; store by_k 238 3989; store by_k 313 3992; store by_k 388 3995; store by_k
463 3998; store by_k 538 3995; store by_k 613 3998; store by_k 688 3995; store by_k 763 3998; store by_k 89 3999;
store by_k 239 4000; store by_k 314 4001; store by_k 389 4002; store by_k 464 4003; store by_k 539 4002; store by_k
614 4003; store by_k 689 4002; store by_k 764 4003; store by_k 90 4089; store by_k 240 4163; store by_k 315 4232;
store by_k 390 4276; store by_k 465 4320; store by_k 540 4276; store by_k 615 4320; store by_k 690 4276; store by_k
765 4320; store by_k 91 4323; store by_k 241 4325; store by_k 92 4334; store by_k 242 4343; store by_k 93 4349;
store by_k 243 4355; store by_k 94 4361; store by_k 244 4367; store by_k 95 4369; store by_k 245 4372; store by_k 96
4484; store by_k 246 4506; store by_k 97 4468; store by_k 247 4494; store by_k 98 4476; store by_k 248 4507; store
by_k 99 4519; store by_k 249 4530; store by_k 100 4542; store by_k 250 4555; store by_k 101 4559; store by_k 251
4563; store by_k 102 4567; store by_k 252 4570; store by_k 327 1799; store by_k 103 4572; store by_k 253 4573; store
by_k 104 28; store by_k 254 4574; store by_k 405 4575; store by_k 480 4576; store by_k 556 4577; store by_k 631
4578; store by_k 707 4579; store by_k 782 4580; store by_k 108 4588; store by_k 258 4590; store by_k 109 4592; store
by_k 259 4593; store by_k 110 4594; store by_k 260 4596; store by_k 1010 4610; store by_k 1085 4619; store by_k 1160
4628; store by_k 1235 4637; store by_k 111 4644; store by_k 261 4651; store by_k 336 4658; store by_k 411 4665;
store by_k 561 4665; store by_k 711 4665; store by_k 112 4672; store by_k 262 4679; store by_k 337 4686; store by_k
412 4693; store by_k 562 4693; store by_k 712 4693; store by_k 113 4694; store by_k 263 4695; store by_k 338 4696;
store by_k 413 4697; store by_k 563 4697; store by_k 713 4697; store by_k 114 733; store by_k 264 1362; store by_k
339 1928; store by_k 414 2268; store by_k 564 2268; store by_k 714 2268; store by_k 115 4709; store by_k 265 4716;
store by_k 340 4723; store by_k 415 4728; store by_k 565 4728; store by_k 715 4728; store by_k 116 4729; store by_k
266 4731; store by_k 341 4733; store by_k 117 4734; store by_k 267 4736; store by_k 342 4738; store by_k 118 4741;
store by_k 268 4743; store by_k 343 4745; store by_k 119 4747; store by_k 269 4748; store by_k 344 4749; store by_k
120 4751; store by_k 270 4754; store by_k 345 4757; store by_k 121 4758; store by_k 271 4760; store by_k 346 4762;
store by_k 122 4763; store by_k 272 4765; store by_k 347 4767; store by_k 123 4768; store by_k 273 4770; store by_k
348 4772; store by_k 124 4779; store by_k 274 4786; store by_k 349 4793; store by_k 499 4800; store by_k 649 4800;
store by_k 799 4800; store by_k 125 4807; store by_k 275 4814; store by_k 350 4821; store by_k 500 4828; store by_k
650 4828; store by_k 800 4828; store by_k 126 4016; store by_k 276 4101; store by_k 351 4181; store by_k 501 4288;
store by_k 651 4288; store by_k 801 4288; store by_k 127 628; store by_k 277 1279; store by_k 352 1857; store by_k
502 2513; store by_k 652 2513; store by_k 802 2513; store by_k 128 4840; store by_k 278 4847; store by_k 353 4854;
store by_k 503 4859; store by_k 653 4859; store by_k 803 4859; store by_k 129 4860; store by_k 279 4862; store by_k
354 4864; store by_k 130 4865; store by_k 280 4867; store by_k 355 4869; store by_k 131 4872; store by_k 281 4874;
store by_k 356 4876; store by_k 132 4878; store by_k 282 4879; store by_k 357 4880; store by_k 133 4882; store by_k
283 4885; store by_k 358 4888; store by_k 134 4889; store by_k 284 4891; store by_k 359 4893; store by_k 135 4894;
store by_k 285 4896; store by_k 360 4898; store by_k 136 4899; store by_k 286 4901; store by_k 361 4903; store by_k
137 4906; store by_k 287 4909; store by_k 138 4910; store by_k 288 4911; store by_k 139 4912; store by_k 289 4913;
store by_k 140 4914; store by_k 290 4915; store by_k 1041 4919; store by_k 1117 4923; store by_k 1193 4927; store
by_k 1269 4931; store by_k 145 4933; store by_k 295 4934; store by_k 146 4936; store by_k 296 4937; store by_k 897
4421; store by_k 973 4425; store by_k 149 4939; store by_k 299 4940
    """,
)
