"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 83},
    {'p': 193},
    """
input k 23; input k 21; input k 26; input k 27; input k 29; input k 24; input k 28; input k 30; input k 25; input k
22; constant 1.0; input k 82; input k 0; div 10 12; mul 11 13; constant -2.0; input k 2; mul 15 16; input k 37;
input k 1; constant -6.000000000000002; constant -18.000000000000004; input k 6; mul 22 22; input k 4; mul 23 24;
mul 21 25; add 20 26; constant -0.09999999999999995; input k 3; mul 23 29; mul 28 30; add 27 31; input k 7; input k
8; constant 28.79999999999999; mul 22 24; mul 35 36; constant -22.62857142857143; mul 24 38; constant
-0.057142857142856635; mul 29 40; add 39 41; constant 36.0; mul 36 43; constant -28.799999999999976; mul 24 45;
constant 0.05714285714285722; mul 29 47; add 46 48; constant -50.400000000000006; mul 24 50; constant
-1.1428571428571423; mul 29 52; add 51 53; constant 12.000000000000004; constant 36.000000000000014; mul 25 56; add
55 57; constant 1.2; mul 30 59; add 58 60; constant -57.60000000000001; mul 36 62; constant 45.25714285714287; mul
24 64; constant 0.9142857142857138; mul 29 66; add 65 67; constant -72.00000000000001; mul 36 69; constant
57.599999999999916; mul 24 71; constant -1.7142857142857166; mul 29 73; add 72 74; constant 230.40000000000006; mul
24 76; constant 2.057142857142858; mul 29 78; add 77 79; constant -388.80000000000024; mul 24 81; constant
-7.714285714285722; mul 29 83; add 82 84; constant 259.2000000000001; mul 24 86; constant 12.34285714285715; mul 29
88; add 87 89; constant -0.9999999999999998; mul 22 91; mul 22 23; mul 24 93; mul 91 94; add 92 95; constant
-0.033333333333333326; mul 30 97; constant -2.3999999999999995; mul 36 99; constant 0.4571428571428564; mul 24 101;
constant -0.019047619047619094; mul 29 103; add 102 104; constant 4.000000000000001; constant 12.0; mul 25 107; add
106 108; constant 0.13333333333333333; mul 30 110; add 109 111; constant -14.399999999999991; mul 36 113; constant
13.714285714285717; mul 24 115; constant 0.11428571428571413; mul 29 117; add 116 118; constant -30.000000000000007;
mul 36 120; mul 22 29; sub 121 122; constant 21.59999999999998; mul 24 124; constant 0.6571428571428567; mul 29 126;
add 125 127; constant 35.20000000000001; mul 24 129; constant 2.438095238095238; mul 29 131; add 130 132; constant
72.0; mul 36 134; constant -57.59999999999995; mul 24 136; constant 0.11428571428571443; mul 29 138; add 137 139;
constant -151.20000000000002; mul 24 141; constant -3.428571428571427; mul 29 143; add 142 144; constant
-36.00000000000001; mul 36 146; constant 28.799999999999958; mul 24 148; constant -0.8571428571428583; mul 29 150;
add 149 151; constant -129.60000000000008; mul 24 153; constant -2.5714285714285743; mul 29 155; add 154 156; input
k 19; constant 2.0; input k 18; input k 17; input k 16; input k 31; input k 47; input k 42; input k 15; sub 166 10;
input k 44; input k 43; input k 45; sub 170 12; constant 8.118473726939319e-05; input k 5; mul 172 173; constant
-0.0004787100025195255; mul 173 175; constant 0.0013605442176870743; mul 173 177; constant -0.003571428571428574;
mul 173 179; constant 0.007142857142857142; mul 173 181; constant -0.0006802721088435403; mul 173 183; constant
0.0035714285714285787; mul 173 185; constant 0.014965986394557814; mul 173 187; constant -0.04285714285714284; mul
173 189; constant 0.06428571428571427; mul 173 191; constant -0.12857142857142845; mul 173 193; constant
0.2571428571428571; mul 173 195; input k 9; input k 10; input k 12; input k 11; input k 13; input k 14; input k 46;
div 10 203; input k 48; input k 49; input k 50; input k 51; input k 52; input k 53; input k 54; input k 55; constant
0.029931972789115628; mul 173 213; constant -0.08571428571428567; mul 173 215; constant 0.12857142857142853; mul 173
217; constant -0.38571428571428534; mul 173 219; constant 1.0285714285714285; mul 173 221; constant
0.0027210884353741486; mul 173 223; constant -0.010714285714285721; mul 173 225; constant 0.028571428571428567; mul
173 227; constant 0.010714285714285735; mul 173 229; input k 61; input k 57; input k 56; input k 58; input k 59; sub
235 12; input k 60; div 10 237; input k 62; input k 63; input k 64; input k 65; input k 66; input k 67; input k 68;
input k 69; constant -6.0; constant 4.0; input k 33; input k 70; input k 71; input k 72; input k 73; input k 38;
input k 39; input k 40; mul 256 256; input k 78; input k 79; input k 20; input k 32; mul 163 261; input k 41;
constant 0.8000000000000002; constant 2.400000000000001; mul 25 265; add 264 266; constant 0.01904761904761903; mul
30 268; add 267 269; constant -1.3714285714285723; mul 36 271; constant 1.3714285714285714; mul 24 273; constant
0.007256235827664418; mul 29 275; add 274 276; constant -4.799999999999999; mul 36 278; constant 1.3714285714285692;
mul 24 280; constant -0.05714285714285729; mul 29 282; add 281 283; constant -7.199999999999996; mul 36 285;
constant 7.199999999999994; mul 24 287; constant 0.2190476190476189; mul 29 289; add 288 290; constant
-45.25714285714286; mul 24 292; constant -0.11428571428571327; mul 29 294; add 293 295; constant
-28.800000000000004; mul 36 297; constant 0.00032473894907757275; mul 173 299; constant -0.0014361300075585765; mul
173 301; constant -0.0013605442176870806; mul 173 303; constant 0.8; mul 16 305; input k 34; input k 35; input k 36;
input k 80; input k 81; input k 74; div 10 312; input k 75; div 10 314; input k 76; div 10 316; input k 77; div 10
318; mul 13 33; mul 32 320; mul 13 61; mul 112 320; mul 13 32; mul 28 320; mul 13 59; mul 110 320; mul 13 28; mul 13
197; mul 13 198; mul 13 199; add 258 259; mul 98 320; mul 97 320; mul 13 107; mul 247 320; add 335 336; mul 16 337;
mul 13 247; mul 248 320; add 339 340; mul 16 341; mul 33 342; add 338 343; mul 34 342; mul 32 34; mul 34 112; mul 28
34; mul 34 110; mul 34 98; mul 34 97; mul 34 247; mul 16 352; mul 34 248; mul 16 354; mul 33 355; add 353 356; mul
34 355; mul 263 313; mul 263 315; mul 263 317; mul 263 319; neg 307; neg 308; neg 309; neg 310; neg 311; mul 250
263; mul 251 263; mul 252 263; mul 253 263; mul 13 14; mul 22 159; mul 159 256; store p 0 0; store p 1 1; store p 2
2; store p 3 3; store p 4 4; store p 5 5; store p 6 6; store p 7 7; store p 8 8; store p 9 9; store p 10 14; store p
11 17; store p 12 18; store p 13 13; store p 14 19; store p 15 32; store p 16 33; store p 17 34; store p 18 37;
store p 19 42; store p 20 44; store p 21 49; store p 22 54; store p 23 61; store p 24 63; store p 25 68; store p 26
70; store p 27 75; store p 28 80; store p 29 85; store p 30 90; store p 31 96; store p 32 98; store p 33 100; store
p 34 105; store p 35 112; store p 36 114; store p 37 119; store p 38 123; store p 39 128; store p 40 133; store p 41
135; store p 42 140; store p 43 145; store p 44 147; store p 45 152; store p 46 157; store p 47 158; store p 48 160;
store p 49 161; store p 50 162; store p 51 12; store p 52 197; store p 53 198; store p 54 199; store p 55 184; store
p 56 186; store p 57 214; store p 58 216; store p 59 218; store p 60 220; store p 61 222; store p 62 176; store p 63
224; store p 64 226; store p 65 228; store p 66 230; store p 67 190; store p 68 194; store p 69 163; store p 70 171;
store p 71 174; store p 72 178; store p 73 180; store p 74 182; store p 75 188; store p 76 192; store p 77 196;
store p 78 200; store p 79 201; store p 80 202; store p 81 167; store p 82 166; store p 83 169; store p 84 165;
store p 85 204; store p 86 168; store p 87 164; store p 88 205; store p 89 206; store p 90 207; store p 91 208;
store p 92 209; store p 93 210; store p 94 211; store p 95 212; store p 96 236; store p 97 232; store p 98 233;
store p 99 238; store p 100 234; store p 101 231; store p 102 239; store p 103 240; store p 104 241; store p 105
242; store p 106 243; store p 107 244; store p 108 245; store p 109 246; store p 110 16; store p 111 249; store p
112 250; store p 113 251; store p 114 252; store p 115 253; store p 116 254; store p 117 255; store p 118 257; store
p 119 258; store p 120 259; store p 121 260; store p 122 262; store p 123 263; store p 124 270; store p 125 272;
store p 126 277; store p 127 279; store p 128 284; store p 129 286; store p 130 291; store p 131 296; store p 132
298; store p 133 300; store p 134 302; store p 135 304; store p 136 306; store p 137 307; store p 138 308; store p
139 309; store p 140 310; store p 141 311; store p 142 313; store p 143 315; store p 144 317; store p 145 319; store
p 146 321; store p 147 320; store p 148 322; store p 149 323; store p 150 324; store p 151 325; store p 152 326;
store p 153 327; store p 154 328; store p 155 329; store p 156 330; store p 157 331; store p 158 332; store p 159
333; store p 160 334; store p 161 344; store p 162 345; store p 163 346; store p 164 347; store p 165 348; store p
166 349; store p 167 350; store p 168 351; store p 169 357; store p 170 358; store p 171 359; store p 172 360; store
p 173 361; store p 174 362; store p 175 363; store p 176 364; store p 177 365; store p 178 366; store p 179 367;
store p 180 368; store p 181 369; store p 182 370; store p 183 371; store p 184 372; store p 185 23; store p 186 22;
store p 187 93; store p 188 24; store p 189 373; store p 190 29; store p 191 261; store p 192 374
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 193},
    {'f': 18, 'a': 324, 'b': 36, 'by_c': 234},
    """
input x 1; input p 0; input p 1; input p 2; input x 0; mul 3 4; input p 3; input x 2; mul 6 7; add 5 8; input p 4;
input x 4; mul 10 11; add 9 12; mul 13 13; mul 2 14; add 1 15; input p 5; input p 6; mul 4 18; mul 7 10; add 19 20;
input p 7; mul 11 22; add 21 23; mul 24 24; mul 2 25; add 17 26; mul 16 27; mul 13 24; mul 2 29; mul 30 30; sub 28
31; constant 1.0; input p 8; mul 4 34; mul 3 7; add 35 36; mul 11 18; add 37 38; mul 39 39; mul 2 40; add 2 41; mul
32 42; input p 9; mul 13 39; mul 2 45; add 44 46; mul 27 47; mul 24 39; mul 2 49; mul 30 50; sub 48 51; mul 47 52;
sub 43 53; mul 30 47; mul 16 50; sub 55 56; mul 50 57; add 54 58; div 33 59; mul 32 60; input c 0; input c 2; input
u 0; mul 63 64; add 62 65; input c 3; input u 1; mul 67 68; add 66 69; input p 10; mul 4 71; sub 7 72; input c 9;
constant 0.5; input c 10; mul 75 76; mul 73 77; sub 74 78; input c 11; mul 64 80; add 79 81; input c 12; mul 68 83;
add 82 84; mul 73 85; add 70 86; input c 4; input c 5; mul 73 89; sub 88 90; input c 6; mul 64 92; add 91 93; input
c 7; mul 68 95; add 94 96; input c 8; input p 11; max 98 99; input x 3; mul 0 71; sub 101 102; mul 100 103; sub 97
104; mul 71 105; sub 87 106; input p 12; input c 1; add 108 109; constant 0.0; max 110 111; mul 0 112; sub 107 113;
input p 13; input p 14; input p 15; input p 16; mul 4 115; mul 118 119; input p 17; mul 7 121; add 120 122; mul 117
123; input p 18; mul 11 123; mul 125 126; add 124 127; input p 19; mul 11 126; mul 129 130; add 128 131; input p 20;
mul 123 123; mul 133 134; add 132 135; input p 21; mul 11 134; mul 137 138; add 136 139; input p 22; mul 123 134;
mul 141 142; add 140 143; input p 23; mul 119 145; add 144 146; input p 24; mul 11 119; mul 148 149; add 147 150;
input p 25; mul 11 149; mul 152 153; add 151 154; input p 26; mul 119 123; mul 156 157; add 155 158; input p 27; mul
11 157; mul 160 161; add 159 162; input p 28; mul 123 157; mul 164 165; add 163 166; input p 29; mul 119 119; mul
123 169; mul 168 170; add 167 171; input p 30; mul 119 169; mul 173 174; add 172 175; input p 31; input p 32; mul 11
178; add 177 179; input p 33; mul 11 11; mul 181 182; add 180 183; input p 34; mul 11 182; mul 185 186; add 184 187;
input p 35; mul 123 189; add 188 190; input p 36; mul 126 192; add 191 193; input p 37; mul 130 195; add 194 196;
input p 38; mul 134 198; add 197 199; input p 39; mul 138 201; add 200 202; input p 40; mul 142 204; add 203 205;
mul 117 119; add 206 207; mul 125 149; add 208 209; mul 129 153; add 210 211; input p 41; mul 157 213; add 212 214;
input p 42; mul 161 216; add 215 217; input p 43; mul 165 219; add 218 220; input p 44; mul 169 222; add 221 223;
input p 45; mul 11 169; mul 225 226; add 224 227; mul 164 170; add 228 229; input p 46; mul 174 231; add 230 232;
mul 118 233; add 176 234; mul 116 235; abs 119; constant 0.35; lt 237 238; input p 47; constant 0.6; constant -0.6;
max 242 7; min 241 243; mul 244 244; mul 244 245; mul 240 246; constant -0.35; max 248 119; min 238 249; constant
2.0; mul 250 251; input p 48; mul 245 253; mul 252 254; add 247 255; mul 250 250; input p 49; mul 244 258; mul 257
259; add 256 260; mul 250 259; mul 252 262; add 261 263; mul 251 257; input p 50; mul 265 266; mul 252 267; add 264
268; mul 116 269; where 239 270; add 236 271; input p 51; input p 52; mul 119 274; input p 53; mul 7 276; add 275
277; input p 54; mul 11 279; add 278 280; constant -0.09999999999999995; mul 123 282; input p 55; mul 130 284; add
283 285; input p 56; mul 142 287; add 286 288; constant 1.2; mul 119 290; add 289 291; input p 57; mul 153 293; add
292 294; input p 58; mul 161 296; add 295 297; input p 59; mul 165 299; add 298 300; input p 60; mul 170 302; add
301 303; input p 61; mul 174 305; add 304 306; constant -0.033333333333333326; mul 11 308; input p 62; mul 186 310;
add 309 311; constant 0.13333333333333333; mul 123 313; add 312 314; input p 63; mul 130 316; add 315 317; input p
64; mul 138 319; add 318 320; input p 65; mul 142 322; add 321 323; mul 119 282; add 324 325; mul 153 284; add 326
327; input p 66; mul 165 329; add 328 330; input p 67; mul 226 332; add 331 333; mul 170 299; add 334 335; input p
68; mul 174 337; add 336 338; mul 118 339; add 307 340; add 281 341; mul 273 342; input p 69; input p 70; constant
0.009523809523809514; mul 182 346; input p 71; mul 11 186; mul 348 349; add 347 350; mul 126 308; add 351 352; mul
11 130; mul 310 354; add 353 355; constant 0.06666666666666667; mul 134 357; add 356 358; input p 72; mul 11 138;
mul 360 361; add 359 362; input p 73; mul 11 142; mul 364 365; add 363 366; input p 74; mul 123 142; mul 368 369;
add 367 370; mul 157 282; add 371 372; mul 11 161; mul 284 374; add 373 375; mul 123 165; mul 287 377; add 376 378;
mul 169 241; add 379 380; input p 75; mul 11 226; mul 382 383; add 381 384; mul 11 170; mul 332 386; add 385 387;
input p 76; mul 123 170; mul 389 390; add 388 391; mul 123 174; mul 337 393; add 392 394; input p 77; mul 119 174;
mul 396 397; add 395 398; mul 119 281; mul 119 276; input p 78; mul 7 402; add 401 403; input p 79; mul 11 405; add
404 406; mul 7 407; add 400 408; mul 119 279; mul 7 405; add 410 411; input p 80; mul 11 413; add 412 414; mul 11
415; add 409 416; mul 75 417; add 399 418; mul 273 419; add 345 420; input p 81; mul 7 422; mul 7 423; add 33 424;
input p 82; mul 7 426; mul 7 427; add 33 428; sqrt 429; sqrt 425; mul 430 431; div 33 432; mul 425 433; input p 83;
mul 434 435; add 421 436; input p 84; mul 7 431; mul 433 439; mul 438 440; sub 437 441; input p 85; mul 434 438;
input p 86; sub 444 445; mul 435 440; add 446 447; sub 448 4; mul 449 449; mul 442 442; add 450 451; sqrt 452; mul
443 453; sqrt 454; div 33 455; mul 456 456; mul 443 457; mul 442 458; input p 87; mul 251 454; mul 251 457; mul 457
462; sub 461 463; mul 460 464; constant 0.3; constant -0.3; constant 1.4; sub 454 468; max 467 469; min 466 470;
input p 88; input p 89; mul 471 473; add 472 474; mul 471 475; add 33 476; mul 465 477; input p 90; mul 64 479;
input p 91; mul 469 481; add 33 482; mul 480 483; sub 478 484; mul 443 485; input p 92; input x 6; mul 487 488;
input p 93; input x 8; mul 490 491; add 489 492; input p 94; input x 10; mul 494 495; add 493 496; constant -0.5;
mul 456 498; mul 456 499; mul 456 500; mul 443 501; mul 497 502; add 486 503; input p 95; mul 502 505; mul 502 506;
sub 436 441; mul 449 508; add 444 447; mul 442 510; sub 509 511; mul 458 512; div 33 430; mul 433 514; mul 513 515;
mul 101 516; mul 449 458; mul 0 518; sub 517 519; mul 0 115; mul 343 521; mul 121 339; add 407 523; mul 273 524; mul
101 525; add 522 526; mul 459 527; add 520 528; mul 507 529; add 504 530; mul 459 531; input p 96; add 420 533;
input p 97; mul 434 535; add 534 536; input p 98; mul 440 538; add 537 539; input p 99; mul 440 535; mul 434 538;
input p 100; sub 543 544; sub 542 545; sub 546 4; mul 547 547; mul 540 540; add 548 549; sqrt 550; mul 541 551; sqrt
552; div 33 553; mul 554 554; mul 541 555; mul 540 556; input p 101; mul 251 552; mul 251 555; mul 555 560; sub 559
561; mul 558 562; sub 552 468; max 467 564; min 466 565; input p 102; input p 103; mul 566 568; add 567 569; mul 566
570; add 33 571; mul 563 572; input p 104; mul 68 574; input p 105; mul 564 576; add 33 577; mul 575 578; sub 573
579; mul 541 580; input p 106; input x 7; mul 582 583; input p 107; input x 9; mul 585 586; add 584 587; input p
108; input x 11; mul 589 590; add 588 591; mul 498 554; mul 554 593; mul 554 594; mul 541 595; mul 592 596; add 581
597; input p 109; mul 596 599; mul 596 600; add 536 539; mul 547 602; sub 543 542; mul 540 604; add 603 605; mul 556
606; mul 515 607; mul 101 608; mul 547 556; mul 0 610; sub 609 611; mul 527 557; add 612 613; mul 601 614; add 598
615; mul 557 616; add 532 617; sub 344 618; mul 343 619; sub 272 620; input p 110; constant 12.0; mul 521 623;
constant -6.0; mul 118 521; mul 101 121; add 626 627; mul 625 628; add 624 629; mul 622 630; mul 521 625; constant
4.0; mul 628 633; add 632 634; mul 622 635; mul 118 636; add 631 637; add 621 638; mul 115 639; mul 518 531; mul 610
616; add 641 642; sub 640 643; sub 114 644; input p 111; input p 112; input z 0; mul 647 648; input p 113; input z
1; mul 650 651; add 649 652; input p 114; input z 2; mul 654 655; add 653 656; input p 115; input z 3; mul 658 659;
add 657 660; sub 646 661; input p 116; abs 0; mul 663 664; mul 0 665; input p 117; mul 0 667; mul 0 0; input p 118;
add 669 670; sqrt 671; div 33 672; mul 668 673; add 666 674; sub 662 675; add 645 676; input p 119; input x 12; sub
4 679; mul 678 680; input p 120; input x 13; sub 4 683; mul 682 684; add 681 685; sub 677 686; mul 0 34; mul 3 101;
add 688 689; input x 5; mul 18 691; add 690 692; mul 0 693; mul 0 3; mul 6 101; add 695 696; mul 10 691; add 697
698; mul 101 699; add 694 700; mul 0 18; mul 10 101; add 702 703; mul 22 691; add 704 705; mul 691 706; add 701 707;
mul 2 708; mul 39 709; sub 687 710; mul 61 711; mul 52 60; mul 121 233; mul 116 714; abs 7; lt 716 241; mul 244 251;
mul 245 251; input p 121; mul 719 720; mul 718 721; mul 240 250; mul 245 723; add 722 724; mul 244 723; mul 718 726;
add 725 727; mul 253 257; mul 718 729; add 728 730; mul 250 257; mul 258 732; add 731 733; mul 116 734; where 717
735; add 715 736; mul 525 619; sub 737 738; mul 121 636; add 739 740; mul 516 531; mul 608 616; add 742 743; add 741
744; sub 105 745; input p 122; mul 440 747; mul 515 748; add 746 749; input p 123; mul 661 751; sub 750 752; mul 13
709; sub 753 754; mul 713 755; sub 712 756; mul 57 60; input p 124; mul 11 759; input p 125; mul 182 761; add 760
762; input p 126; mul 186 764; add 763 765; mul 123 178; add 766 767; input p 127; mul 126 769; add 768 770; input p
128; mul 130 772; add 771 773; input p 129; mul 134 775; add 774 776; mul 138 195; add 777 778; input p 130; mul 142
780; add 779 781; mul 125 157; add 782 783; input p 131; mul 161 785; add 784 786; mul 137 165; add 787 788; input p
132; mul 169 790; add 789 791; mul 152 226; add 792 793; mul 170 225; add 794 795; mul 116 796; constant
0.01904761904761903; mul 11 798; input p 133; mul 186 800; add 799 801; mul 123 308; add 802 803; input p 134; mul
130 805; add 804 806; mul 138 316; add 807 808; mul 142 364; add 809 810; input p 135; mul 161 812; add 811 813; mul
226 293; add 814 815; mul 170 332; add 816 817; add 415 818; mul 273 819; mul 619 820; sub 797 821; input p 136; mul
691 823; add 822 824; mul 24 709; add 825 826; mul 758 827; sub 757 828; mul 27 42; mul 50 50; sub 830 831; mul 60
832; mul 755 833; mul 711 713; sub 834 835; mul 30 42; mul 47 50; sub 837 838; mul 60 839; mul 827 840; add 836 841;
mul 711 758; mul 755 840; sub 843 844; mul 16 42; mul 47 47; sub 846 847; mul 60 848; mul 827 849; sub 845 850; mul
502 529; input p 137; mul 488 853; sub 852 854; mul 596 614; mul 583 853; sub 856 857; input p 138; mul 491 859; sub
852 860; mul 586 859; sub 856 862; input p 139; mul 495 864; sub 852 865; mul 590 864; sub 856 867; input p 140; mul
680 869; input p 141; mul 684 871; le 33 648; mul 101 751; add 0 874; lt 111 875; and 873 876; constant -1.0; le 648
878; lt 875 111; and 879 880; or 877 881; not 882; input p 142; mul 875 884; where 883 885; le 33 651; and 876 887;
le 651 878; and 880 889; or 888 890; not 891; input p 143; mul 875 893; where 892 894; le 33 655; and 876 896; le
655 878; and 880 898; or 897 899; not 900; input p 144; mul 875 902; where 901 903; le 33 659; and 876 905; le 659
878; and 880 907; or 906 908; not 909; input p 145; mul 875 911; where 910 912; mul 13 251; mul 3 914; mul 2 915;
mul 27 916; mul 24 251; mul 18 918; mul 2 919; mul 16 920; add 917 921; mul 3 24; mul 13 18; add 923 924; mul 2 925;
mul 30 926; add 927 927; sub 922 928; mul 60 929; mul 60 61; mul 39 251; mul 34 932; mul 2 933; mul 32 934; mul 42
929; add 935 936; mul 13 34; mul 3 39; add 938 939; mul 2 940; mul 52 941; mul 27 941; mul 47 920; add 943 944; mul
50 926; mul 18 39; mul 24 34; add 947 948; mul 2 949; mul 30 950; add 946 951; sub 945 952; mul 47 953; add 942 954;
sub 937 955; mul 57 950; mul 30 941; mul 47 926; add 958 959; mul 50 916; mul 16 950; add 961 962; sub 960 963; mul
50 964; add 957 965; add 956 966; mul 931 967; sub 930 968; mul 711 969; mul 71 77; mul 73 971; mul 71 85; sub 972
973; mul 71 89; mul 71 975; sub 974 976; input p 146; input p 147; mul 11 979; mul 125 980; add 978 981; mul 11 980;
mul 129 983; add 982 984; mul 123 251; mul 979 986; mul 133 987; add 985 988; mul 11 987; mul 137 990; add 989 991;
mul 123 987; mul 134 979; add 993 994; mul 141 995; add 992 996; input p 148; add 997 998; mul 11 115; mul 148 1000;
add 999 1001; mul 11 1000; mul 152 1003; add 1002 1004; mul 115 123; mul 119 979; add 1006 1007; mul 156 1008; add
1005 1009; mul 11 1008; mul 160 1011; add 1010 1012; mul 123 1008; mul 157 979; add 1014 1015; mul 164 1016; add
1013 1017; mul 119 251; mul 115 1019; mul 123 1020; mul 169 979; add 1021 1022; mul 168 1023; add 1018 1024; mul 119
1020; mul 115 169; add 1026 1027; mul 173 1028; add 1025 1029; input p 149; mul 192 980; add 1031 1032; mul 195 983;
add 1033 1034; mul 198 987; add 1035 1036; mul 201 990; add 1037 1038; mul 204 995; add 1039 1040; input p 150; add
1041 1042; mul 125 1000; add 1043 1044; mul 129 1003; add 1045 1046; mul 213 1008; add 1047 1048; mul 216 1011; add
1049 1050; mul 219 1016; add 1051 1052; mul 222 1020; add 1053 1054; mul 11 1020; mul 225 1056; add 1055 1057; mul
164 1023; add 1058 1059; mul 231 1028; add 1060 1061; mul 118 1062; add 1030 1063; mul 116 1064; le 249 238; le 238
249; add 1066 1067; div 33 1068; mul 1066 1069; le 248 119; le 119 248; add 1071 1072; div 33 1073; mul 1071 1074;
mul 115 1075; mul 1070 1076; mul 251 1077; mul 254 1078; mul 252 1077; mul 259 1080; add 1079 1081; mul 262 1078;
mul 259 1077; mul 252 1084; add 1083 1085; add 1082 1086; mul 267 1078; mul 251 1080; mul 266 1089; mul 252 1090;
add 1088 1091; add 1087 1092; mul 116 1093; where 239 1094; add 1065 1095; input p 151; mul 284 983; add 1097 1098;
mul 287 995; add 1099 1100; input p 152; add 1101 1102; mul 293 1003; add 1103 1104; mul 296 1011; add 1105 1106;
mul 299 1016; add 1107 1108; mul 302 1023; add 1109 1110; mul 305 1028; add 1111 1112; input p 153; mul 316 983; add
1114 1115; mul 319 990; add 1116 1117; mul 322 995; add 1118 1119; input p 154; add 1120 1121; mul 284 1003; add
1122 1123; mul 329 1016; add 1124 1125; mul 332 1056; add 1126 1127; mul 299 1023; add 1128 1129; mul 337 1028; add
1130 1131; mul 118 1132; add 1113 1133; input p 155; add 1134 1135; mul 273 1136; mul 619 1137; mul 251 442; mul 308
980; mul 11 983; mul 310 1141; add 1140 1142; mul 357 987; add 1143 1144; mul 11 990; mul 360 1146; add 1145 1147;
mul 11 995; mul 364 1149; add 1148 1150; mul 123 995; mul 142 979; add 1152 1153; mul 368 1154; add 1151 1155; mul
282 1008; add 1156 1157; mul 11 1011; mul 284 1159; add 1158 1160; mul 123 1016; mul 165 979; add 1162 1163; mul 287
1164; add 1161 1165; mul 241 1020; add 1166 1167; mul 11 1056; mul 382 1169; add 1168 1170; mul 11 1023; mul 332
1172; add 1171 1173; mul 123 1023; mul 170 979; add 1175 1176; mul 389 1177; add 1174 1178; mul 123 1028; mul 174
979; add 1180 1181; mul 337 1182; add 1179 1183; mul 119 1028; mul 115 174; add 1185 1186; mul 396 1187; add 1184
1188; mul 119 1135; mul 115 281; add 1190 1191; input p 156; mul 7 1193; add 1192 1194; input p 157; mul 11 1196;
add 1195 1197; mul 75 1198; add 1189 1199; mul 273 1200; mul 1139 1201; mul 251 449; sub 1202 1203; mul 251 453; div
33 1205; mul 1204 1206; mul 443 1207; mul 251 1208; mul 251 456; mul 251 455; div 33 1211; mul 1208 1212; mul 457
1213; mul 1210 1214; neg 1215; mul 251 1216; mul 457 1217; mul 462 1215; sub 1218 1219; sub 1209 1220; mul 460 1221;
mul 477 1222; le 470 466; le 466 470; add 1224 1225; div 33 1226; mul 1224 1227; le 467 469; le 469 467; add 1229
1230; div 33 1231; mul 1229 1232; mul 1208 1233; mul 1228 1234; mul 473 1235; mul 471 1236; mul 475 1235; add 1237
1238; mul 465 1239; add 1223 1240; mul 481 1208; mul 480 1242; sub 1241 1243; mul 443 1244; mul 500 1213; mul 456
1246; mul 501 1213; add 1247 1248; mul 456 1249; mul 456 501; mul 1213 1251; add 1250 1252; mul 443 1253; mul 497
1254; sub 1245 1255; mul 443 1215; mul 449 1257; add 458 1258; mul 0 1259; mul 510 1201; add 508 1261; mul 458 1262;
mul 512 1257; add 1263 1264; mul 515 1265; mul 101 1266; sub 1260 1267; mul 458 1201; mul 442 1257; sub 1269 1270;
mul 527 1271; mul 521 1137; mul 121 1132; add 1193 1274; mul 273 1275; mul 101 1276; add 1273 1277; mul 459 1278;
add 1272 1279; add 1268 1280; mul 507 1281; mul 505 1254; mul 502 1283; mul 506 1254; add 1284 1285; mul 529 1286;
sub 1282 1287; add 1256 1288; mul 459 1289; mul 531 1271; add 1290 1291; mul 251 540; mul 1201 1293; mul 251 547;
sub 1294 1295; mul 251 551; div 33 1297; mul 1296 1298; mul 541 1299; mul 251 1300; mul 251 554; mul 251 553; div 33
1303; mul 1300 1304; mul 555 1305; mul 1302 1306; neg 1307; mul 251 1308; mul 555 1309; mul 560 1307; sub 1310 1311;
sub 1301 1312; mul 558 1313; mul 572 1314; le 565 466; le 466 565; add 1316 1317; div 33 1318; mul 1316 1319; le 467
564; le 564 467; add 1321 1322; div 33 1323; mul 1321 1324; mul 1300 1325; mul 1320 1326; mul 568 1327; mul 566
1328; mul 570 1327; add 1329 1330; mul 563 1331; add 1315 1332; mul 576 1300; mul 575 1334; sub 1333 1335; mul 541
1336; mul 594 1305; mul 554 1338; mul 595 1305; add 1339 1340; mul 554 1341; mul 554 595; mul 1305 1343; add 1342
1344; mul 541 1345; mul 592 1346; sub 1337 1347; mul 604 1201; sub 1349 602; mul 556 1350; mul 541 1307; mul 606
1352; sub 1351 1353; mul 515 1354; mul 101 1355; mul 547 1352; add 556 1357; mul 0 1358; add 1356 1359; mul 556
1201; mul 540 1352; sub 1361 1362; mul 527 1363; mul 557 1278; add 1364 1365; add 1360 1366; mul 601 1367; mul 599
1346; mul 596 1369; mul 600 1346; add 1370 1371; mul 614 1372; sub 1368 1373; add 1348 1374; mul 557 1375; mul 616
1363; add 1376 1377; add 1292 1378; mul 343 1379; sub 1138 1380; sub 1096 1381; mul 115 1382; mul 518 1289; mul 531
1259; sub 1384 1385; mul 610 1375; mul 616 1358; sub 1387 1388; add 1386 1389; sub 1383 1390; sub 977 1391; input p
158; sub 1392 1393; mul 34 709; sub 1394 1395; mul 61 1396; add 970 1397; mul 60 953; mul 60 713; mul 967 1400; sub
1399 1401; mul 755 1402; mul 121 1062; mul 116 1404; mul 240 1077; mul 245 1406; mul 244 1406; mul 718 1408; add
1407 1409; mul 253 1080; mul 718 1411; add 1410 1412; mul 257 1077; mul 250 1080; add 1414 1415; mul 258 1416; add
1413 1417; mul 116 1418; where 717 1419; add 1405 1420; mul 619 1276; mul 525 1379; sub 1422 1423; sub 1421 1424;
mul 516 1289; mul 531 1266; sub 1426 1427; mul 608 1375; mul 616 1355; add 1429 1430; add 1428 1431; add 1425 1432;
sub 975 1433; mul 3 709; sub 1434 1435; mul 713 1436; add 1403 1437; sub 1398 1438; mul 60 964; mul 60 758; mul 967
1441; sub 1440 1442; mul 827 1443; input p 159; mul 769 980; add 1445 1446; mul 772 983; add 1447 1448; mul 775 987;
add 1449 1450; mul 195 990; add 1451 1452; mul 780 995; add 1453 1454; mul 125 1008; add 1455 1456; mul 785 1011;
add 1457 1458; mul 137 1016; add 1459 1460; mul 790 1020; add 1461 1462; mul 152 1056; add 1463 1464; mul 225 1023;
add 1465 1466; mul 116 1467; input p 160; mul 805 983; add 1469 1470; mul 316 990; add 1471 1472; mul 364 995; add
1473 1474; mul 812 1011; add 1475 1476; mul 293 1056; add 1477 1478; mul 332 1023; add 1479 1480; add 1196 1481; mul
273 1482; mul 619 1483; mul 820 1379; sub 1484 1485; sub 1468 1486; mul 18 709; add 1487 1488; mul 758 1489; add
1444 1490; sub 1439 1491; input c_q 0; mul 61 1493; le 111 110; le 110 111; add 1495 1496; div 33 1497; mul 1495
1498; mul 0 61; mul 1499 1500; input c_q 1; mul 1501 1502; sub 1494 1503; mul 61 64; input c_q 2; mul 1505 1506; add
1504 1507; mul 61 68; input c_q 3; mul 1509 1510; add 1508 1511; mul 61 71; add 713 1513; input c_q 4; mul 1514
1515; sub 1512 1516; mul 73 1514; input c_q 5; mul 1518 1519; add 1517 1520; mul 64 1514; input c_q 6; mul 1522
1523; sub 1521 1524; mul 68 1514; input c_q 7; mul 1526 1527; sub 1525 1528; le 99 98; le 98 99; add 1530 1531; div
33 1532; mul 1530 1533; mul 103 1514; mul 1534 1535; input c_q 8; mul 1536 1537; add 1529 1538; mul 61 73; input c_q
9; mul 1540 1541; add 1539 1542; mul 73 1540; mul 75 1544; input c_q 10; mul 1545 1546; sub 1543 1547; mul 64 1540;
input c_q 11; mul 1549 1550; add 1548 1551; mul 68 1540; input c_q 12; mul 1553 1554; add 1552 1555; add 1492 1556;
mul 27 934; mul 42 920; add 1558 1559; mul 50 950; add 1561 1561; sub 1560 1562; mul 60 1563; mul 60 833; mul 967
1565; sub 1564 1566; mul 755 1567; mul 833 1436; add 1568 1569; mul 711 1402; mul 713 1396; add 1571 1572; sub 1570
1573; mul 30 934; mul 42 926; add 1575 1576; mul 47 950; mul 50 941; add 1578 1579; sub 1577 1580; mul 60 1581; mul
60 840; mul 967 1583; sub 1582 1584; mul 827 1585; mul 840 1489; add 1586 1587; add 1574 1588; mul 0 713; mul 1499
1590; mul 1502 1591; mul 713 1493; sub 1592 1593; mul 64 713; mul 1506 1595; sub 1594 1596; mul 68 713; mul 1510
1598; sub 1597 1599; mul 71 713; add 833 1601; mul 1515 1602; add 1600 1603; mul 73 1602; mul 1519 1605; sub 1604
1606; mul 64 1602; mul 1523 1608; add 1607 1609; mul 68 1602; mul 1527 1611; add 1610 1612; mul 103 1602; mul 1534
1614; mul 1537 1615; sub 1613 1616; mul 73 713; mul 1541 1618; sub 1617 1619; mul 73 1618; mul 75 1621; mul 1546
1622; add 1620 1623; mul 64 1618; mul 1550 1625; sub 1624 1626; mul 68 1618; mul 1554 1628; sub 1627 1629; add 1589
1630; mul 711 1443; mul 758 1396; add 1632 1633; mul 755 1585; mul 840 1436; add 1635 1636; sub 1634 1637; mul 16
934; mul 42 916; add 1639 1640; mul 47 941; add 1642 1642; sub 1641 1643; mul 60 1644; mul 60 849; mul 967 1646; sub
1645 1647; mul 827 1648; mul 849 1489; add 1649 1650; sub 1638 1651; mul 758 1493; mul 0 758; mul 1499 1654; mul
1502 1655; sub 1653 1656; mul 64 758; mul 1506 1658; add 1657 1659; mul 68 758; mul 1510 1661; add 1660 1662; mul 71
758; add 840 1664; mul 1515 1665; sub 1663 1666; mul 73 1665; mul 1519 1668; add 1667 1669; mul 64 1665; mul 1523
1671; sub 1670 1672; mul 68 1665; mul 1527 1674; sub 1673 1675; mul 103 1665; mul 1534 1677; mul 1537 1678; add 1676
1679; mul 73 758; mul 1541 1681; add 1680 1682; mul 73 1681; mul 75 1684; mul 1546 1685; sub 1683 1686; mul 64 1681;
mul 1550 1688; add 1687 1689; mul 68 1681; mul 1554 1691; add 1690 1692; add 1652 1693; mul 502 1281; mul 529 1254;
sub 1695 1696; mul 596 1367; mul 614 1346; sub 1698 1699; mul 71 100; mul 71 1701; add 112 1702; mul 342 459; sub
1704 518; mul 507 1705; mul 459 1706; mul 342 557; sub 1708 610; mul 601 1709; mul 557 1710; add 1707 1711; mul 343
1712; input p 161; add 1713 1714; mul 115 1715; mul 518 1706; mul 610 1710; add 1717 1718; sub 1716 1719; add 1703
1720; sign 0; mul 663 1722; mul 0 1723; add 665 1724; mul 667 673; mul 673 674; mul 0 673; mul 1727 1728; sub 1726
1729; add 1725 1730; add 1721 1731; add 688 693; add 689 1733; add 692 1734; mul 2 1735; mul 39 1736; add 1732 1737;
mul 61 1738; mul 525 1712; input p 162; add 1740 1741; mul 516 1706; mul 608 1710; add 1743 1744; add 1742 1745; sub
1701 1746; mul 13 1736; sub 1747 1748; mul 713 1749; add 1739 1750; mul 820 1712; mul 24 1736; add 1752 1753; mul
758 1754; add 1751 1755; neg 1756; mul 833 1749; mul 713 1738; add 1758 1759; mul 840 1754; add 1760 1761; mul 758
1738; mul 840 1749; add 1763 1764; mul 849 1754; add 1765 1766; neg 1767; mul 502 1705; mul 596 1709; where 883 884;
where 892 893; where 901 902; where 910 911; mul 6 914; mul 2 1775; mul 27 1776; mul 10 918; mul 2 1778; mul 16
1779; add 1777 1780; mul 6 24; mul 10 13; add 1782 1783; mul 2 1784; mul 30 1785; add 1786 1786; sub 1781 1787; mul
60 1788; mul 3 932; mul 2 1790; mul 32 1791; mul 42 1788; add 1792 1793; mul 3 13; mul 6 39; add 1795 1796; mul 2
1797; mul 52 1798; mul 27 1798; mul 47 1779; add 1800 1801; mul 50 1785; mul 10 39; add 923 1804; mul 2 1805; mul 30
1806; add 1803 1807; sub 1802 1808; mul 47 1809; add 1799 1810; sub 1794 1811; mul 57 1806; mul 30 1798; mul 47
1785; add 1814 1815; mul 50 1776; mul 16 1806; add 1817 1818; sub 1816 1819; mul 50 1820; add 1813 1821; add 1812
1822; mul 931 1823; sub 1789 1824; mul 711 1825; sub 85 78; add 975 1827; input p 163; mul 11 121; mul 125 1830; add
1829 1831; mul 11 1830; mul 129 1833; add 1832 1834; mul 121 986; mul 133 1836; add 1835 1837; mul 11 1836; mul 137
1839; add 1838 1840; mul 123 1836; mul 121 134; add 1842 1843; mul 141 1844; add 1841 1845; mul 119 121; mul 156
1847; add 1846 1848; mul 11 1847; mul 160 1850; add 1849 1851; mul 123 1847; mul 121 157; add 1853 1854; mul 164
1855; add 1852 1856; mul 121 169; mul 168 1858; add 1857 1859; input p 164; mul 192 1830; add 1861 1862; mul 195
1833; add 1863 1864; mul 198 1836; add 1865 1866; mul 201 1839; add 1867 1868; mul 204 1844; add 1869 1870; mul 213
1847; add 1871 1872; mul 216 1850; add 1873 1874; mul 219 1855; add 1875 1876; mul 164 1858; add 1877 1878; mul 118
1879; add 1860 1880; mul 116 1881; le 243 241; le 241 243; add 1883 1884; div 33 1885; mul 1883 1886; le 242 7; le 7
242; add 1888 1889; div 33 1890; mul 1888 1891; mul 1887 1892; mul 245 1893; mul 718 1893; mul 244 1895; add 1894
1896; mul 240 1897; mul 253 1895; mul 252 1899; add 1898 1900; mul 258 1893; mul 257 1902; add 1901 1903; mul 250
1902; mul 252 1905; add 1904 1906; mul 116 1907; where 239 1908; add 1882 1909; input p 165; mul 284 1833; add 1911
1912; mul 287 1844; add 1913 1914; mul 296 1850; add 1915 1916; mul 299 1855; add 1917 1918; mul 302 1858; add 1919
1920; input p 166; mul 316 1833; add 1922 1923; mul 319 1839; add 1924 1925; mul 322 1844; add 1926 1927; mul 329
1855; add 1928 1929; mul 299 1858; add 1930 1931; mul 118 1932; add 1921 1933; add 276 1934; mul 273 1935; mul 619
1936; mul 251 423; mul 433 1938; mul 433 434; mul 427 514; mul 431 1941; div 33 431; mul 423 1943; mul 430 1944; add
1942 1945; mul 1940 1946; sub 1939 1947; mul 438 1948; mul 7 1944; add 431 1950; mul 433 1951; mul 433 440; mul 1946
1953; sub 1952 1954; mul 435 1955; add 1949 1956; mul 1203 1957; mul 308 1830; mul 11 1833; mul 310 1960; add 1959
1961; mul 357 1836; add 1962 1963; mul 11 1839; mul 360 1965; add 1964 1966; mul 11 1844; mul 364 1968; add 1967
1969; mul 123 1844; mul 121 142; add 1971 1972; mul 368 1973; add 1970 1974; mul 282 1847; add 1975 1976; mul 11
1850; mul 284 1978; add 1977 1979; mul 123 1855; mul 121 165; add 1981 1982; mul 287 1983; add 1980 1984; mul 11
1858; mul 332 1986; add 1985 1987; mul 123 1858; mul 121 170; add 1989 1990; mul 389 1991; add 1988 1992; mul 121
174; mul 337 1994; add 1993 1995; add 403 407; add 401 1997; add 406 1998; mul 75 1999; add 1996 2000; mul 273 2001;
mul 435 1948; add 2002 2003; mul 438 1955; sub 2004 2005; mul 1139 2006; add 1958 2007; mul 1206 2008; mul 443 2009;
mul 251 2010; mul 1212 2010; mul 457 2012; mul 1210 2013; neg 2014; mul 251 2015; mul 457 2016; mul 462 2014; sub
2017 2018; sub 2011 2019; mul 460 2020; mul 477 2021; mul 1233 2010; mul 1228 2023; mul 473 2024; mul 471 2025; mul
475 2024; add 2026 2027; mul 465 2028; add 2022 2029; mul 481 2010; mul 480 2031; sub 2030 2032; mul 443 2033; mul
500 2012; mul 456 2035; mul 501 2012; add 2036 2037; mul 456 2038; mul 1251 2012; add 2039 2040; mul 443 2041; mul
497 2042; sub 2034 2043; mul 508 1957; sub 2003 2005; mul 449 2046; add 2045 2047; mul 510 2006; mul 442 1957; add
2049 2050; sub 2048 2051; mul 458 2052; mul 443 2014; mul 512 2054; sub 2053 2055; mul 515 2056; mul 514 514; mul
1941 2058; mul 433 2059; mul 433 515; mul 1946 2061; add 2060 2062; mul 513 2063; sub 2057 2064; mul 101 2065; mul
458 1957; mul 449 2054; sub 2067 2068; mul 0 2069; sub 2066 2070; mul 458 2006; mul 442 2054; sub 2072 2073; mul 527
2074; mul 521 1936; mul 121 1932; add 402 2077; mul 273 2078; mul 101 2079; add 2076 2080; mul 459 2081; add 2075
2082; add 2071 2083; mul 507 2084; mul 505 2042; mul 502 2086; mul 506 2042; add 2087 2088; mul 529 2089; sub 2085
2090; add 2044 2091; mul 459 2092; mul 531 2074; add 2093 2094; mul 535 1955; mul 538 1948; sub 2096 2097; mul 1295
2098; mul 535 1948; add 2002 2100; mul 538 1955; add 2101 2102; mul 1293 2103; add 2099 2104; mul 1298 2105; mul 541
2106; mul 251 2107; mul 1304 2107; mul 555 2109; mul 1302 2110; neg 2111; mul 251 2112; mul 555 2113; mul 560 2111;
sub 2114 2115; sub 2108 2116; mul 558 2117; mul 572 2118; mul 1325 2107; mul 1320 2120; mul 568 2121; mul 566 2122;
mul 570 2121; add 2123 2124; mul 563 2125; add 2119 2126; mul 576 2107; mul 575 2128; sub 2127 2129; mul 541 2130;
mul 594 2109; mul 554 2132; mul 595 2109; add 2133 2134; mul 554 2135; mul 1343 2109; add 2136 2137; mul 541 2138;
mul 592 2139; sub 2131 2140; mul 602 2098; add 2100 2102; mul 547 2143; add 2142 2144; mul 604 2103; sub 2097 2096;
mul 540 2147; add 2146 2148; add 2145 2149; mul 556 2150; mul 541 2111; mul 606 2152; sub 2151 2153; mul 515 2154;
mul 607 2063; sub 2155 2156; mul 101 2157; mul 556 2098; mul 547 2152; sub 2159 2160; mul 0 2161; sub 2158 2162; mul
556 2103; mul 540 2152; sub 2164 2165; mul 527 2166; mul 557 2081; add 2167 2168; add 2163 2169; mul 601 2170; mul
599 2139; mul 596 2172; mul 600 2139; add 2173 2174; mul 614 2175; sub 2171 2176; add 2141 2177; mul 557 2178; mul
616 2166; add 2179 2180; add 2095 2181; mul 343 2182; sub 1937 2183; sub 1910 2184; mul 115 2185; mul 518 2092; mul
531 2069; add 2187 2188; mul 610 2178; mul 616 2161; add 2190 2191; add 2189 2192; sub 2186 2193; sub 1828 2194; sub
2195 1435; mul 61 2196; add 1826 2197; mul 60 1809; mul 1400 1823; sub 2199 2200; mul 755 2201; mul 747 1955; mul
515 2203; mul 748 2063; sub 2204 2205; mul 121 1879; mul 116 2207; mul 251 1893; mul 721 2209; mul 251 1895; mul 720
2211; mul 718 2212; add 2210 2213; mul 723 1895; add 2214 2215; mul 726 2209; mul 723 1893; mul 718 2218; add 2217
2219; add 2216 2220; mul 729 2209; add 2221 2222; mul 116 2223; where 717 2224; add 2208 2225; mul 619 2079; mul 525
2182; sub 2227 2228; sub 2226 2229; mul 516 2092; mul 531 2065; add 2231 2232; mul 608 2178; mul 616 2157; add 2234
2235; add 2233 2236; add 2230 2237; add 89 2238; sub 2206 2239; mul 6 709; sub 2240 2241; mul 713 2242; add 2202
2243; sub 2198 2244; mul 60 1820; mul 1441 1823; sub 2246 2247; mul 827 2248; input p 167; mul 769 1830; add 2250
2251; mul 772 1833; add 2252 2253; mul 775 1836; add 2254 2255; mul 195 1839; add 2256 2257; mul 780 1844; add 2258
2259; mul 125 1847; add 2260 2261; mul 785 1850; add 2262 2263; mul 137 1855; add 2264 2265; mul 225 1858; add 2266
2267; mul 116 2268; input p 168; mul 805 1833; add 2270 2271; mul 316 1839; add 2272 2273; mul 364 1844; add 2274
2275; mul 812 1850; add 2276 2277; mul 332 1858; add 2278 2279; add 405 2280; mul 273 2281; mul 619 2282; mul 820
2182; sub 2283 2284; sub 2269 2285; mul 10 709; add 2286 2287; mul 758 2288; add 2249 2289; sub 2245 2290; mul 27
1791; mul 42 1779; add 2292 2293; mul 50 1806; add 2295 2295; sub 2294 2296; mul 60 2297; mul 1565 1823; sub 2298
2299; mul 755 2300; mul 833 2242; add 2301 2302; mul 711 2201; mul 713 2196; add 2304 2305; sub 2303 2306; mul 30
1791; mul 42 1785; add 2308 2309; mul 47 1806; mul 50 1798; add 2311 2312; sub 2310 2313; mul 60 2314; mul 1583
1823; sub 2315 2316; mul 827 2317; mul 840 2288; add 2318 2319; add 2307 2320; mul 711 2248; mul 758 2196; add 2322
2323; mul 755 2317; mul 840 2242; add 2325 2326; sub 2324 2327; mul 16 1791; mul 42 1776; add 2329 2330; mul 47
1798; add 2332 2332; sub 2331 2333; mul 60 2334; mul 1646 1823; sub 2335 2336; mul 827 2337; mul 849 2288; add 2338
2339; sub 2328 2340; mul 502 2084; mul 529 2042; sub 2342 2343; mul 596 2170; mul 614 2139; sub 2345 2346; mul 459
525; add 516 2348; mul 507 2349; mul 459 2350; mul 525 557; add 608 2352; mul 601 2353; mul 557 2354; add 2351 2355;
mul 343 2356; input p 169; add 2357 2358; mul 115 2359; mul 518 2350; mul 610 2354; add 2361 2362; sub 2360 2363;
sub 1701 2364; add 696 699; add 695 2366; add 698 2367; mul 2 2368; mul 39 2369; sub 2365 2370; mul 61 2371; mul 525
2356; input p 170; add 2373 2374; mul 516 2350; mul 608 2354; add 2376 2377; add 2375 2378; add 100 2379; mul 13
2369; add 2380 2381; mul 713 2382; add 2372 2383; mul 820 2356; mul 24 2369; add 2385 2386; mul 758 2387; sub 2384
2388; mul 840 2387; mul 833 2382; mul 713 2371; add 2391 2392; sub 2390 2393; mul 758 2371; mul 840 2382; add 2395
2396; mul 849 2387; sub 2397 2398; mul 502 2349; mul 596 2353; input p 171; where 883 2402; input p 172; where 892
2404; input p 173; where 901 2406; input p 174; where 910 2408; mul 10 914; mul 2 2410; mul 27 2411; mul 22 918; mul
2 2413; mul 16 2414; add 2412 2415; mul 10 24; mul 13 22; add 2417 2418; mul 2 2419; mul 30 2420; add 2421 2421; sub
2416 2422; mul 60 2423; mul 18 932; mul 2 2425; mul 32 2426; mul 42 2423; add 2427 2428; add 924 1804; mul 2 2430;
mul 52 2431; mul 27 2431; mul 47 2414; add 2433 2434; mul 50 2420; mul 22 39; mul 18 24; add 2437 2438; mul 2 2439;
mul 30 2440; add 2436 2441; sub 2435 2442; mul 47 2443; add 2432 2444; sub 2429 2445; mul 57 2440; mul 30 2431; mul
47 2420; add 2448 2449; mul 50 2411; mul 16 2440; add 2451 2452; sub 2450 2453; mul 50 2454; add 2447 2455; add 2446
2456; mul 931 2457; sub 2424 2458; mul 711 2459; mul 123 125; mul 126 251; mul 129 2462; add 2461 2463; mul 134 137;
add 2464 2465; mul 119 148; add 2466 2467; mul 149 251; mul 152 2469; add 2468 2470; mul 157 160; add 2471 2472; mul
11 251; mul 181 2474; add 178 2475; mul 11 2474; add 182 2477; mul 185 2478; add 2476 2479; mul 123 192; add 2480
2481; mul 195 2462; add 2482 2483; mul 134 201; add 2484 2485; mul 119 125; add 2486 2487; mul 129 2469; add 2488
2489; mul 157 216; add 2490 2491; mul 169 225; add 2492 2493; mul 118 2494; add 2473 2495; mul 116 2496; mul 284
2462; mul 293 2469; add 2498 2499; mul 157 296; add 2500 2501; mul 310 2478; add 308 2503; mul 316 2462; add 2504
2505; mul 134 319; add 2506 2507; mul 284 2469; add 2508 2509; mul 169 332; add 2510 2511; mul 118 2512; add 2502
2513; add 279 2514; mul 273 2515; mul 619 2516; mul 11 2478; add 186 2518; mul 348 2519; add 799 2520; add 803 2521;
mul 11 2462; add 130 2523; mul 310 2524; add 2522 2525; mul 138 251; mul 360 2527; add 2526 2528; add 810 2529; mul
161 251; mul 284 2531; add 2530 2532; mul 226 251; mul 382 2534; add 2533 2535; add 817 2536; add 414 415; add 412
2538; mul 75 2539; add 2537 2540; mul 273 2541; mul 1139 2542; mul 1206 2543; mul 443 2544; mul 251 2545; mul 1212
2545; mul 457 2547; mul 1210 2548; neg 2549; mul 251 2550; mul 457 2551; mul 462 2549; sub 2552 2553; sub 2546 2554;
mul 460 2555; mul 477 2556; mul 1233 2545; mul 1228 2558; mul 473 2559; mul 471 2560; mul 475 2559; add 2561 2562;
mul 465 2563; add 2557 2564; mul 481 2545; mul 480 2566; sub 2565 2567; mul 443 2568; mul 500 2547; mul 456 2570;
mul 501 2547; add 2571 2572; mul 456 2573; mul 1251 2547; add 2574 2575; mul 443 2576; mul 497 2577; sub 2569 2578;
mul 443 2549; mul 449 2580; mul 0 2581; mul 510 2542; mul 458 2583; mul 512 2580; add 2584 2585; mul 515 2586; mul
101 2587; sub 2582 2588; mul 458 2542; mul 442 2580; sub 2590 2591; mul 527 2592; mul 521 2516; mul 121 2512; add
405 2595; mul 273 2596; mul 101 2597; add 2594 2598; mul 459 2599; add 2593 2600; add 2589 2601; mul 507 2602; mul
505 2577; mul 502 2604; mul 506 2577; add 2605 2606; mul 529 2607; sub 2603 2608; add 2579 2609; mul 459 2610; mul
531 2592; add 2611 2612; mul 1293 2542; mul 1298 2614; mul 541 2615; mul 251 2616; mul 1304 2616; mul 555 2618; mul
1302 2619; neg 2620; mul 251 2621; mul 555 2622; mul 560 2620; sub 2623 2624; sub 2617 2625; mul 558 2626; mul 572
2627; mul 1325 2616; mul 1320 2629; mul 568 2630; mul 566 2631; mul 570 2630; add 2632 2633; mul 563 2634; add 2628
2635; mul 576 2616; mul 575 2637; sub 2636 2638; mul 541 2639; mul 594 2618; mul 554 2641; mul 595 2618; add 2642
2643; mul 554 2644; mul 1343 2618; add 2645 2646; mul 541 2647; mul 592 2648; sub 2640 2649; mul 604 2542; mul 556
2651; mul 541 2620; mul 606 2653; sub 2652 2654; mul 515 2655; mul 101 2656; mul 547 2653; mul 0 2658; add 2657
2659; mul 556 2542; mul 540 2653; sub 2661 2662; mul 527 2663; mul 557 2599; add 2664 2665; add 2660 2666; mul 601
2667; mul 599 2648; mul 596 2669; mul 600 2648; add 2670 2671; mul 614 2672; sub 2668 2673; add 2650 2674; mul 557
2675; mul 616 2663; add 2676 2677; add 2613 2678; mul 343 2679; sub 2517 2680; sub 2497 2681; mul 115 2682; mul 518
2610; mul 531 2581; sub 2684 2685; mul 610 2675; mul 616 2658; sub 2687 2688; add 2686 2689; sub 2683 2690; add 1488
2691; mul 61 2692; sub 2460 2693; mul 60 2443; mul 1400 2457; sub 2695 2696; mul 755 2697; mul 121 2494; mul 116
2699; mul 619 2597; mul 525 2679; sub 2701 2702; sub 2700 2703; mul 516 2610; mul 531 2587; sub 2705 2706; mul 608
2675; mul 616 2656; add 2708 2709; add 2707 2710; add 2704 2711; add 2287 2712; mul 713 2713; sub 2698 2714; sub
2694 2715; mul 60 2454; mul 1441 2457; sub 2717 2718; mul 827 2719; mul 761 2474; add 759 2721; mul 764 2478; add
2722 2723; mul 123 769; add 2724 2725; mul 772 2462; add 2726 2727; mul 134 195; add 2728 2729; mul 157 785; add
2730 2731; mul 152 169; add 2732 2733; mul 116 2734; mul 800 2478; add 798 2736; mul 805 2462; add 2737 2738; mul
134 316; add 2739 2740; mul 157 812; add 2741 2742; mul 169 293; add 2743 2744; add 413 2745; mul 273 2746; mul 619
2747; mul 820 2679; sub 2748 2749; sub 2735 2750; mul 22 709; add 2751 2752; mul 758 2753; add 2720 2754; sub 2716
2755; mul 27 2426; mul 42 2414; add 2757 2758; mul 50 2440; add 2760 2760; sub 2759 2761; mul 60 2762; mul 1565
2457; sub 2763 2764; mul 755 2765; mul 833 2713; sub 2766 2767; mul 711 2697; mul 713 2692; sub 2769 2770; sub 2768
2771; mul 30 2426; mul 42 2420; add 2773 2774; mul 47 2440; mul 50 2431; add 2776 2777; sub 2775 2778; mul 60 2779;
mul 1583 2457; sub 2780 2781; mul 827 2782; mul 840 2753; add 2783 2784; add 2772 2785; mul 711 2719; mul 758 2692;
sub 2787 2788; mul 755 2782; mul 840 2713; sub 2790 2791; sub 2789 2792; mul 16 2426; mul 42 2411; add 2794 2795;
mul 47 2431; add 2797 2797; sub 2796 2798; mul 60 2799; mul 1646 2457; sub 2800 2801; mul 827 2802; mul 849 2753;
add 2803 2804; sub 2793 2805; mul 502 2602; mul 529 2577; sub 2807 2808; mul 596 2667; mul 614 2648; sub 2810 2811;
add 705 706; add 704 2813; mul 2 2814; mul 13 2815; mul 713 2816; mul 39 2815; mul 61 2818; sub 2817 2819; mul 24
2815; add 823 2821; mul 758 2822; sub 2820 2823; mul 713 2818; mul 833 2816; sub 2825 2826; mul 840 2822; add 2827
2828; mul 840 2816; mul 758 2818; sub 2830 2831; mul 849 2822; sub 2832 2833; mul 487 502; mul 459 2835; mul 525
2836; mul 516 2835; add 2837 2838; mul 713 2839; mul 343 2836; mul 115 2841; mul 518 2835; sub 2842 2843; mul 61
2844; sub 2840 2845; mul 820 2836; mul 758 2847; sub 2846 2848; mul 713 2844; mul 833 2839; sub 2850 2851; mul 840
2847; add 2852 2853; mul 840 2839; mul 758 2844; sub 2855 2856; mul 849 2847; sub 2857 2858; input p 175; mul 582
596; mul 557 2861; mul 525 2862; mul 608 2861; add 2863 2864; mul 713 2865; mul 343 2862; mul 115 2867; mul 610
2861; sub 2868 2869; mul 61 2870; sub 2866 2871; mul 820 2862; mul 758 2873; sub 2872 2874; mul 713 2870; mul 833
2865; sub 2876 2877; mul 840 2873; add 2878 2879; mul 840 2865; mul 758 2870; sub 2881 2882; mul 849 2873; sub 2883
2884; mul 490 502; mul 459 2886; mul 525 2887; mul 516 2886; add 2888 2889; mul 713 2890; mul 343 2887; mul 115
2892; mul 518 2886; sub 2893 2894; mul 61 2895; sub 2891 2896; mul 820 2887; mul 758 2898; sub 2897 2899; mul 713
2895; mul 833 2890; sub 2901 2902; mul 840 2898; add 2903 2904; mul 840 2890; mul 758 2895; sub 2906 2907; mul 849
2898; sub 2908 2909; input p 176; mul 585 596; mul 557 2912; mul 525 2913; mul 608 2912; add 2914 2915; mul 713
2916; mul 343 2913; mul 115 2918; mul 610 2912; sub 2919 2920; mul 61 2921; sub 2917 2922; mul 820 2913; mul 758
2924; sub 2923 2925; mul 713 2921; mul 833 2916; sub 2927 2928; mul 840 2924; add 2929 2930; mul 840 2916; mul 758
2921; sub 2932 2933; mul 849 2924; sub 2934 2935; mul 494 502; mul 459 2937; mul 525 2938; mul 516 2937; add 2939
2940; mul 713 2941; mul 343 2938; mul 115 2943; mul 518 2937; sub 2944 2945; mul 61 2946; sub 2942 2947; mul 820
2938; mul 758 2949; sub 2948 2950; mul 713 2946; mul 833 2941; sub 2952 2953; mul 840 2949; add 2954 2955; mul 840
2941; mul 758 2946; sub 2957 2958; mul 849 2949; sub 2959 2960; input p 177; mul 589 596; mul 557 2963; mul 525
2964; mul 608 2963; add 2965 2966; mul 713 2967; mul 343 2964; mul 115 2969; mul 610 2963; sub 2970 2971; mul 61
2972; sub 2968 2973; mul 820 2964; mul 758 2975; sub 2974 2976; mul 713 2972; mul 833 2967; sub 2978 2979; mul 840
2975; add 2980 2981; mul 840 2967; mul 758 2972; sub 2983 2984; mul 849 2975; sub 2985 2986; mul 61 678; mul 678
713; neg 2989; mul 678 758; input p 178; mul 61 682; mul 682 713; neg 2994; mul 682 758; input p 179; input p 180;
mul 713 2998; mul 61 647; sub 2999 3000; mul 647 713; mul 833 2998; sub 3002 3003; mul 840 2998; mul 647 758; sub
3005 3006; input p 181; mul 713 3008; mul 61 650; sub 3009 3010; mul 650 713; mul 833 3008; sub 3012 3013; mul 840
3008; mul 650 758; sub 3015 3016; input p 182; mul 713 3018; mul 61 654; sub 3019 3020; mul 654 713; mul 833 3018;
sub 3022 3023; mul 840 3018; mul 654 758; sub 3025 3026; input p 183; mul 713 3028; mul 61 658; sub 3029 3030; mul
658 713; mul 833 3028; sub 3032 3033; mul 840 3028; mul 658 758; sub 3035 3036; mul 73 80; add 63 3038; mul 71 92;
sub 3039 3040; mul 479 483; mul 443 3042; mul 518 3043; mul 459 3043; mul 343 3045; mul 115 3046; sub 3044 3047; sub
3041 3048; mul 61 3049; mul 525 3045; mul 516 3043; add 3051 3052; add 92 3053; mul 713 3054; sub 3050 3055; mul 820
3045; mul 758 3057; add 3056 3058; mul 833 3054; mul 713 3049; sub 3060 3061; mul 840 3057; sub 3062 3063; mul 758
3049; mul 840 3054; sub 3065 3066; mul 849 3057; add 3067 3068; mul 73 83; add 67 3070; mul 71 95; sub 3071 3072;
mul 574 578; mul 541 3074; mul 610 3075; mul 557 3075; mul 343 3077; mul 115 3078; sub 3076 3079; sub 3073 3080; mul
61 3081; mul 525 3077; mul 608 3075; add 3083 3084; add 95 3085; mul 713 3086; sub 3082 3087; mul 820 3077; mul 758
3089; add 3088 3090; mul 833 3086; mul 713 3081; sub 3092 3093; mul 840 3089; sub 3094 3095; mul 758 3081; mul 840
3086; sub 3097 3098; mul 849 3089; add 3099 3100; neg 713; neg 1501; neg 1655; neg 1595; neg 1598; neg 1514; neg
1665; neg 1605; neg 1522; neg 1671; neg 1526; neg 1674; neg 1615; neg 1618; neg 1545; neg 1685; neg 1625; neg 1628;
store f 0 0; store f 1 829; store f 2 101; store f 3 842; store f 4 691; store f 5 851; store f 6 855; store f 7
858; store f 8 861; store f 9 863; store f 10 866; store f 11 868; store f 12 870; store f 13 872; store f 14 886;
store f 15 895; store f 16 904; store f 17 913; store a 18 1557; store a 54 1631; store a 90 1694; store a 108 1697;
store a 126 1700; store a 144 1697; store a 162 1700; store a 180 1697; store a 198 1700; store a 216 869; store a
234 871; store a 1 33; store a 19 1757; store a 55 1762; store a 91 1768; store a 109 1769; store a 127 1770; store
a 145 1769; store a 163 1770; store a 181 1769; store a 199 1770; store a 253 1771; store a 271 1772; store a 289
1773; store a 307 1774; store a 20 2291; store a 56 2321; store a 92 2341; store a 110 2344; store a 128 2347; store
a 146 2344; store a 164 2347; store a 182 2344; store a 200 2347; store a 21 2389; store a 39 33; store a 57 2394;
store a 93 2399; store a 111 2400; store a 129 2401; store a 147 2400; store a 165 2401; store a 183 2400; store a
201 2401; store a 255 2403; store a 273 2405; store a 291 2407; store a 309 2409; store a 22 2756; store a 58 2786;
store a 94 2806; store a 112 2809; store a 130 2812; store a 148 2809; store a 166 2812; store a 184 2809; store a
202 2812; store a 23 2824; store a 59 2829; store a 77 33; store a 95 2834; store a 24 2849; store a 60 2854; store
a 96 2859; store a 114 2860; store a 25 2875; store a 61 2880; store a 97 2885; store a 133 2860; store a 26 2900;
store a 62 2905; store a 98 2910; store a 152 2911; store a 27 2926; store a 63 2931; store a 99 2936; store a 171
2911; store a 28 2951; store a 64 2956; store a 100 2961; store a 190 2962; store a 29 2977; store a 65 2982; store
a 101 2987; store a 209 2962; store a 30 2988; store a 66 2990; store a 102 2991; store a 228 2992; store a 31 2993;
store a 67 2995; store a 103 2996; store a 247 2997; store a 32 3001; store a 68 3004; store a 104 3007; store a 33
3011; store a 69 3014; store a 105 3017; store a 34 3021; store a 70 3024; store a 106 3027; store a 35 3031; store
a 71 3034; store a 107 3037; store b 2 3059; store b 6 3064; store b 10 3069; store b 3 3091; store b 7 3096; store
b 11 3101; store by_c 13 61; store by_c 39 3102; store by_c 65 758; store by_c 14 3103; store by_c 40 1591; store
by_c 66 3104; store by_c 15 1505; store by_c 41 3105; store by_c 67 1658; store by_c 16 1509; store by_c 42 3106;
store by_c 68 1661; store by_c 17 3107; store by_c 43 1602; store by_c 69 3108; store by_c 18 1518; store by_c 44
3109; store by_c 70 1668; store by_c 19 3110; store by_c 45 1608; store by_c 71 3111; store by_c 20 3112; store by_c
46 1611; store by_c 72 3113; store by_c 21 1536; store by_c 47 3114; store by_c 73 1678; store by_c 22 1540; store
by_c 48 3115; store by_c 74 1681; store by_c 23 3116; store by_c 49 1622; store by_c 75 3117; store by_c 24 1549;
store by_c 50 3118; store by_c 76 1688; store by_c 25 1553; store by_c 51 3119; store by_c 77 1691
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'p': 193},
    {'by_k': 1494},
    """
input x 0; input p 13; mul 0 1; input p 54; mul 2 3; input x 2; input p 79; mul 5 6; add 4 7; input x 4; input p 80;
mul 9 10; add 8 11; constant 0.01904761904761903; mul 9 13; mul 9 9; mul 9 15; input p 133; mul 16 17; add 14 18;
input p 16; mul 2 20; input p 17; mul 5 22; add 21 23; constant -0.033333333333333326; mul 24 25; add 19 26; mul 9
24; mul 9 28; input p 134; mul 29 30; add 27 31; mul 24 24; mul 9 33; input p 63; mul 34 35; add 32 36; mul 24 33;
input p 73; mul 38 39; add 37 40; mul 2 24; mul 9 42; input p 135; mul 43 44; add 41 45; mul 2 2; mul 9 47; input p
57; mul 48 49; add 46 50; mul 24 47; input p 67; mul 52 53; add 51 54; add 12 55; input p 69; input p 70; input p
51; constant 0.009523809523809514; mul 15 60; input p 71; mul 9 16; mul 62 63; add 61 64; mul 25 28; add 65 66;
input p 62; mul 9 29; mul 68 69; add 67 70; constant 0.06666666666666667; mul 33 72; add 71 73; input p 72; mul 9
34; mul 75 76; add 74 77; mul 9 38; mul 39 79; add 78 80; input p 74; mul 24 38; mul 82 83; add 81 84; constant
-0.09999999999999995; mul 42 86; add 85 87; input p 55; mul 9 43; mul 89 90; add 88 91; input p 56; mul 24 42; mul
24 94; mul 93 95; add 92 96; constant 0.6; mul 47 98; add 97 99; input p 75; mul 9 48; mul 101 102; add 100 103; mul
9 52; mul 53 105; add 104 106; input p 76; mul 24 52; mul 108 109; add 107 110; input p 68; mul 2 47; mul 24 113;
mul 112 114; add 111 115; input p 77; mul 2 113; mul 117 118; add 116 119; constant 0.5; input p 52; mul 2 122;
input p 53; mul 5 124; add 123 125; mul 3 9; add 126 127; mul 2 128; mul 2 124; input p 78; mul 5 131; add 130 132;
mul 6 9; add 133 134; mul 5 135; add 129 136; mul 9 12; add 137 138; mul 121 139; add 120 140; mul 59 141; add 58
142; constant 1.0; input p 81; mul 5 145; mul 5 146; add 144 147; input p 82; mul 5 149; mul 5 150; add 144 151;
sqrt 152; sqrt 148; mul 153 154; div 144 155; mul 148 156; input p 83; mul 157 158; add 143 159; input p 84; mul 5
154; mul 156 162; mul 161 163; sub 160 164; input p 85; mul 157 161; input p 86; sub 167 168; mul 158 163; add 169
170; sub 171 0; mul 172 172; mul 165 165; add 173 174; sqrt 175; mul 166 176; sqrt 177; div 144 178; mul 179 179;
mul 166 180; mul 165 181; input p 87; constant 2.0; mul 177 184; mul 180 184; mul 180 186; sub 185 187; mul 183 188;
constant 0.3; constant -0.3; constant 1.4; sub 177 192; max 191 193; min 190 194; input p 88; input p 89; mul 195
197; add 196 198; mul 195 199; add 144 200; mul 189 201; input u 0; input p 90; mul 203 204; input p 91; mul 193
206; add 144 207; mul 205 208; sub 202 209; mul 166 210; input p 92; input x 6; mul 212 213; input p 93; input x 8;
mul 215 216; add 214 217; input p 94; input x 10; mul 219 220; add 218 221; constant -0.5; mul 179 223; mul 179 224;
mul 179 225; mul 166 226; mul 222 227; add 211 228; input p 95; mul 227 230; mul 227 231; input x 3; sub 159 164;
mul 172 234; add 167 170; mul 165 236; sub 235 237; mul 181 238; div 144 153; mul 156 240; mul 239 241; mul 233 242;
input x 1; mul 172 181; mul 244 245; sub 243 246; mul 24 86; mul 29 89; add 248 249; mul 38 93; add 250 251;
constant 1.2; mul 2 253; add 252 254; mul 2 9; mul 9 256; mul 49 257; add 255 258; input p 58; mul 43 260; add 259
261; input p 59; mul 94 263; add 262 264; input p 60; mul 52 266; add 265 267; input p 61; mul 113 269; add 268 270;
mul 9 25; mul 16 68; add 272 273; constant 0.13333333333333333; mul 24 275; add 274 276; mul 29 35; add 277 278;
input p 64; mul 34 280; add 279 281; input p 65; mul 38 283; add 282 284; mul 2 86; add 285 286; mul 89 257; add 287
288; input p 66; mul 94 290; add 289 291; mul 48 53; add 292 293; mul 52 263; add 294 295; mul 112 113; add 296 297;
mul 20 298; add 271 299; add 128 300; mul 59 301; mul 1 244; mul 302 303; mul 22 298; add 135 305; mul 59 306; mul
233 307; add 304 308; mul 182 309; add 247 310; mul 232 311; add 229 312; mul 182 313; input p 96; add 142 315;
input p 97; mul 157 317; add 316 318; input p 98; mul 163 320; add 319 321; input p 99; mul 163 317; mul 157 320;
input p 100; sub 325 326; sub 324 327; sub 328 0; mul 329 329; mul 322 322; add 330 331; sqrt 332; mul 323 333; sqrt
334; div 144 335; mul 336 336; mul 323 337; mul 322 338; input p 101; mul 184 334; mul 184 337; mul 337 342; sub 341
343; mul 340 344; sub 334 192; max 191 346; min 190 347; input p 102; input p 103; mul 348 350; add 349 351; mul 348
352; add 144 353; mul 345 354; input u 1; input p 104; mul 356 357; input p 105; mul 346 359; add 144 360; mul 358
361; sub 355 362; mul 323 363; input p 106; input x 7; mul 365 366; input p 107; input x 9; mul 368 369; add 367
370; input p 108; input x 11; mul 372 373; add 371 374; mul 223 336; mul 336 376; mul 336 377; mul 323 378; mul 375
379; add 364 380; input p 109; mul 379 382; mul 379 383; add 318 321; mul 329 385; sub 325 324; mul 322 387; add 386
388; mul 338 389; mul 241 390; mul 233 391; mul 329 338; mul 244 393; sub 392 394; mul 309 339; add 395 396; mul 384
397; add 381 398; mul 339 399; add 314 400; sub 57 401; input p 1; input p 2; mul 0 404; input p 3; mul 5 406; add
405 407; input p 4; mul 9 409; add 408 410; input p 6; mul 0 412; mul 5 409; add 413 414; input p 7; mul 9 416; add
415 417; mul 411 418; mul 403 419; input p 9; input p 8; mul 0 422; mul 5 404; add 423 424; mul 9 412; add 425 426;
mul 411 427; mul 403 428; add 421 429; mul 420 430; input p 0; mul 411 411; mul 403 433; add 432 434; mul 418 427;
mul 403 436; mul 435 437; sub 431 438; input p 5; mul 418 418; mul 403 441; add 440 442; mul 435 443; mul 420 420;
sub 444 445; mul 427 427; mul 403 447; add 403 448; mul 446 449; mul 430 443; mul 420 437; sub 451 452; mul 430 453;
sub 450 454; mul 437 439; add 455 456; div 144 457; mul 439 458; mul 402 459; mul 56 460; mul 446 458; input p 14;
input p 15; mul 24 464; input p 18; mul 28 466; add 465 467; input p 19; mul 29 469; add 468 470; input p 20; mul 33
472; add 471 473; input p 21; mul 34 475; add 474 476; input p 22; mul 38 478; add 477 479; input p 23; mul 2 481;
add 480 482; input p 24; mul 256 484; add 483 485; input p 25; mul 257 487; add 486 488; input p 26; mul 42 490; add
489 491; input p 27; mul 43 493; add 492 494; input p 28; mul 94 496; add 495 497; input p 29; mul 52 499; add 498
500; input p 30; mul 113 502; add 501 503; input p 31; input p 32; mul 9 506; add 505 507; input p 33; mul 15 509;
add 508 510; input p 34; mul 16 512; add 511 513; input p 35; mul 24 515; add 514 516; input p 36; mul 28 518; add
517 519; input p 37; mul 29 521; add 520 522; input p 38; mul 33 524; add 523 525; input p 39; mul 34 527; add 526
528; input p 40; mul 38 530; add 529 531; mul 2 464; add 532 533; mul 256 466; add 534 535; mul 257 469; add 536
537; input p 41; mul 42 539; add 538 540; input p 42; mul 43 542; add 541 543; input p 43; mul 94 545; add 544 546;
input p 44; mul 47 548; add 547 549; input p 45; mul 48 551; add 550 552; mul 52 496; add 553 554; input p 46; mul
113 556; add 555 557; mul 20 558; add 504 559; mul 463 560; abs 2; constant 0.35; lt 562 563; input p 47; constant
-0.6; max 566 5; min 98 567; mul 568 568; mul 568 569; mul 565 570; constant -0.35; max 572 2; min 563 573; mul 184
574; input p 48; mul 569 576; mul 575 577; add 571 578; mul 574 574; input p 49; mul 568 581; mul 580 582; add 579
583; mul 574 582; mul 575 585; add 584 586; mul 184 580; input p 50; mul 588 589; mul 575 590; add 587 591; mul 463
592; where 564 593; add 561 594; mul 302 402; sub 595 596; input p 110; constant 12.0; mul 303 599; constant -6.0;
mul 20 303; mul 22 233; add 602 603; mul 601 604; add 600 605; mul 598 606; mul 303 601; constant 4.0; mul 604 609;
add 608 610; mul 598 611; mul 20 612; add 607 613; add 597 614; mul 1 615; mul 1 616; mul 462 617; add 461 618; mul
453 458; mul 391 620; mul 393 462; add 621 622; mul 56 59; mul 459 624; mul 307 620; sub 625 626; mul 1 462; mul 302
628; add 627 629; mul 339 630; sub 623 631; mul 384 632; mul 309 633; mul 399 630; sub 634 635; mul 338 636; mul 399
620; mul 233 633; add 638 639; mul 241 640; mul 338 641; mul 387 642; add 637 643; mul 184 322; mul 184 333; div 144
646; le 191 346; le 346 191; add 648 649; div 144 650; mul 648 651; le 347 190; le 190 347; add 653 654; div 144
655; mul 653 656; mul 323 632; mul 345 658; mul 352 659; mul 348 659; mul 350 661; add 660 662; mul 657 663; mul 652
664; mul 358 658; mul 359 666; sub 665 667; mul 184 335; div 144 669; mul 336 378; mul 397 632; mul 383 672; mul 379
672; mul 382 674; add 673 675; mul 375 632; add 676 677; mul 323 678; mul 671 679; mul 336 679; mul 378 681; add 680
682; mul 336 681; mul 377 684; add 683 685; mul 184 336; mul 322 636; mul 399 462; mul 244 633; sub 689 690; mul 329
691; add 688 692; mul 389 641; add 693 694; mul 323 695; mul 354 658; mul 340 697; mul 342 698; sub 696 699; mul 337
698; neg 701; mul 184 702; add 700 703; mul 687 704; mul 337 705; add 686 706; mul 670 707; sub 668 708; mul 184
698; add 709 710; mul 323 711; mul 647 712; mul 645 713; add 644 714; sub 619 715; mul 339 633; mul 242 620; mul 245
462; add 718 719; mul 182 630; sub 720 721; mul 232 722; mul 182 723; add 717 724; mul 233 725; mul 402 620; sub 726
727; mul 306 728; add 716 729; mul 1 303; mul 22 620; mul 20 628; sub 732 733; mul 598 734; mul 601 735; mul 609
735; mul 598 628; mul 601 738; sub 737 739; mul 20 740; add 736 741; mul 599 738; sub 742 743; mul 302 725; add 744
745; mul 731 746; sub 730 747; mul 402 628; mul 303 725; add 749 750; mul 301 751; add 748 752; mul 309 723; mul 313
630; sub 754 755; mul 181 756; mul 313 620; mul 233 723; add 758 759; mul 241 760; mul 181 761; mul 236 762; sub 757
763; mul 165 184; mul 176 184; div 144 766; le 191 193; le 193 191; add 768 769; div 144 770; mul 768 771; le 194
190; le 190 194; add 773 774; div 144 775; mul 773 776; mul 166 722; mul 189 778; mul 199 779; mul 195 779; mul 197
781; add 780 782; mul 777 783; mul 772 784; mul 205 778; mul 206 786; sub 785 787; mul 178 184; div 144 789; mul 179
226; mul 311 722; mul 231 792; mul 227 792; mul 230 794; add 793 795; mul 222 722; add 796 797; mul 166 798; mul 791
799; mul 179 799; mul 226 801; add 800 802; mul 179 801; mul 225 804; add 803 805; mul 179 184; mul 165 756; mul 313
462; mul 244 723; sub 809 810; mul 172 811; add 808 812; mul 238 761; add 813 814; mul 166 815; mul 201 778; mul 183
817; mul 186 818; sub 816 819; mul 180 818; neg 821; mul 184 822; add 820 823; mul 807 824; mul 180 825; add 806
826; mul 790 827; sub 788 828; mul 184 818; add 829 830; mul 166 831; mul 767 832; mul 765 833; add 764 834; add 715
835; mul 141 836; add 753 837; sub 838 835; mul 1 2; mul 2 184; mul 59 460; mul 53 842; mul 24 843; mul 841 844; mul
49 842; mul 9 846; mul 841 847; add 845 848; mul 44 842; mul 9 850; mul 24 851; add 849 852; mul 459 463; mul 551
854; mul 24 855; mul 841 856; sub 853 857; mul 487 854; mul 9 859; mul 841 860; sub 858 861; input p 132; mul 854
863; mul 841 864; sub 862 865; mul 475 854; mul 24 867; mul 24 868; sub 866 869; input p 131; mul 854 871; mul 9
872; mul 24 873; sub 870 874; mul 466 854; mul 24 876; sub 875 877; mul 59 728; mul 22 879; mul 59 751; mul 20 881;
add 880 882; mul 112 883; mul 47 884; add 878 885; mul 2 884; mul 841 887; add 886 888; mul 263 883; mul 24 890; mul
841 891; add 889 892; mul 53 883; mul 9 894; mul 841 895; add 893 896; mul 290 883; mul 24 898; mul 24 899; add 897
900; mul 89 883; mul 9 902; mul 9 903; add 901 904; mul 86 883; add 905 906; mul 269 881; mul 47 908; add 907 909;
mul 2 908; mul 841 911; add 910 912; mul 266 881; mul 24 914; mul 841 915; add 913 916; mul 263 881; mul 24 918; mul
24 919; add 917 920; mul 260 881; mul 9 922; mul 24 923; add 921 924; mul 49 881; mul 9 926; mul 9 927; add 925 928;
mul 253 881; add 929 930; mul 59 836; mul 121 932; mul 9 933; add 842 934; mul 3 935; add 931 936; mul 5 933; add
879 938; mul 124 939; add 937 940; mul 128 933; add 941 942; mul 2 933; add 881 944; mul 122 945; add 943 946; mul
117 932; mul 113 948; add 947 949; mul 2 948; mul 47 951; add 950 952; mul 2 951; mul 841 954; add 953 955; mul 112
932; mul 24 957; mul 47 958; add 956 959; mul 2 958; mul 841 961; add 960 962; mul 108 932; mul 24 964; mul 24 965;
mul 841 966; add 963 967; mul 53 932; mul 9 969; mul 24 970; mul 841 971; add 968 972; mul 101 932; mul 9 974; mul 9
975; mul 841 976; add 973 977; mul 98 932; mul 841 979; add 978 980; mul 93 932; mul 24 982; mul 24 983; mul 24 984;
add 981 985; mul 89 932; mul 9 987; mul 9 988; mul 24 989; add 986 990; mul 86 932; mul 24 992; add 991 993; le 572
2; le 2 572; add 995 996; div 144 997; mul 995 998; le 573 563; le 563 573; add 1000 1001; div 144 1002; mul 1000
1003; abs 5; lt 1005 98; mul 463 620; mul 581 1007; mul 580 1008; mul 184 568; mul 1007 1010; mul 576 1011; mul 575
1012; add 1009 1013; mul 568 1011; mul 569 1007; add 1015 1016; mul 565 1017; add 1014 1018; where 1006 1019; mul
463 628; mul 575 1021; mul 589 1022; neg 1023; mul 184 1024; mul 575 1025; where 564 1026; add 1020 1027; mul 590
1021; neg 1029; mul 184 1030; where 564 1031; add 1028 1032; mul 582 1022; neg 1034; where 564 1035; add 1033 1036;
mul 585 1021; neg 1038; mul 184 1039; where 564 1040; add 1037 1041; mul 574 1008; where 1006 1043; mul 582 1021;
neg 1045; where 564 1046; add 1044 1047; mul 575 1048; add 1042 1049; mul 577 1021; neg 1051; mul 184 1052; where
564 1053; add 1050 1054; mul 1004 1055; mul 999 1056; add 994 1057; mul 22 1007; mul 20 1021; sub 1059 1060; mul 556
1061; mul 47 1062; add 1058 1063; mul 2 1062; mul 841 1065; add 1064 1066; mul 496 1061; mul 24 1068; mul 841 1069;
add 1067 1070; mul 551 1061; mul 9 1072; mul 841 1073; add 1071 1074; mul 548 1061; mul 841 1076; add 1075 1077; mul
545 1061; mul 24 1079; mul 24 1080; add 1078 1081; mul 542 1061; mul 9 1083; mul 24 1084; add 1082 1085; mul 539
1061; mul 24 1087; add 1086 1088; mul 469 1061; mul 9 1090; mul 9 1091; add 1089 1092; mul 466 1061; mul 9 1094; add
1093 1095; mul 464 1061; add 1096 1097; mul 502 1021; mul 47 1099; sub 1098 1100; mul 2 1099; mul 841 1102; sub 1101
1103; mul 499 1021; mul 24 1105; mul 841 1106; sub 1104 1107; mul 496 1021; mul 24 1109; mul 24 1110; sub 1108 1111;
mul 493 1021; mul 9 1113; mul 24 1114; sub 1112 1115; mul 490 1021; mul 24 1117; sub 1116 1118; mul 487 1021; mul 9
1120; mul 9 1121; sub 1119 1122; mul 484 1021; mul 9 1124; sub 1123 1125; mul 481 1021; sub 1126 1127; mul 47 843;
mul 2 851; add 1129 1130; mul 39 842; mul 33 1132; add 1131 1133; mul 24 184; mul 24 1132; mul 1135 1136; add 1134
1137; mul 35 842; mul 9 1139; mul 1135 1140; add 1138 1141; mul 30 842; mul 9 1143; mul 9 1144; add 1142 1145; mul
25 842; add 1146 1147; mul 47 855; sub 1148 1149; mul 42 867; sub 1150 1151; mul 2 868; sub 1152 1153; mul 2 873;
sub 1154 1155; mul 2 876; sub 1156 1157; input p 130; mul 854 1159; mul 33 1160; sub 1158 1161; mul 24 1160; mul
1135 1163; sub 1162 1164; mul 521 854; mul 9 1166; mul 1135 1167; sub 1165 1168; input p 129; mul 854 1170; mul 1135
1171; sub 1169 1172; input p 128; mul 854 1174; mul 9 1175; mul 9 1176; sub 1173 1177; input p 127; mul 854 1179;
mul 9 1180; sub 1178 1181; mul 506 854; sub 1182 1183; mul 47 890; add 1184 1185; mul 42 898; add 1186 1187; mul 2
899; add 1188 1189; mul 283 883; mul 33 1191; add 1190 1192; mul 24 1191; mul 1135 1194; add 1193 1195; mul 280 883;
mul 9 1197; mul 1135 1198; add 1196 1199; mul 35 883; mul 9 1201; mul 9 1202; add 1200 1203; mul 275 883; add 1204
1205; mul 47 914; add 1206 1207; mul 42 918; add 1208 1209; mul 2 919; add 1210 1211; mul 2 923; add 1212 1213; mul
93 881; mul 33 1215; add 1214 1216; mul 24 1215; mul 1135 1218; add 1217 1219; mul 89 881; mul 9 1221; mul 9 1222;
add 1220 1223; mul 86 881; add 1224 1225; mul 113 957; add 1226 1227; mul 52 964; add 1228 1229; mul 47 965; add
1230 1231; mul 47 970; add 1232 1233; mul 94 982; add 1234 1235; mul 42 983; add 1236 1237; mul 2 984; add 1238
1239; mul 2 989; add 1240 1241; mul 2 992; add 1242 1243; mul 82 932; mul 38 1245; add 1244 1246; mul 24 1245; mul
33 1248; add 1247 1249; mul 24 1248; mul 1135 1251; add 1250 1252; mul 39 932; mul 9 1254; mul 33 1255; add 1253
1256; mul 24 1255; mul 1135 1258; add 1257 1259; mul 75 932; mul 9 1261; mul 9 1262; mul 1135 1263; add 1260 1264;
mul 72 932; mul 1135 1266; add 1265 1267; mul 68 932; mul 9 1269; mul 9 1270; mul 9 1271; add 1268 1272; mul 25 932;
mul 9 1274; add 1273 1275; mul 47 1068; add 1276 1277; mul 42 1079; add 1278 1279; mul 2 1080; add 1280 1281; mul 2
1084; add 1282 1283; mul 2 1087; add 1284 1285; mul 530 1061; mul 33 1287; add 1286 1288; mul 24 1287; mul 1135
1290; add 1289 1291; mul 527 1061; mul 9 1293; mul 1135 1294; add 1292 1295; mul 524 1061; mul 1135 1297; add 1296
1298; mul 521 1061; mul 9 1300; mul 9 1301; add 1299 1302; mul 518 1061; mul 9 1304; add 1303 1305; mul 515 1061;
add 1306 1307; mul 47 1105; sub 1308 1309; mul 42 1109; sub 1310 1311; mul 2 1110; sub 1312 1313; mul 2 1114; sub
1314 1315; mul 2 1117; sub 1316 1317; mul 478 1021; mul 33 1319; sub 1318 1320; mul 24 1319; mul 1135 1322; sub 1321
1323; mul 475 1021; mul 9 1325; mul 1135 1326; sub 1324 1327; mul 472 1021; mul 1135 1329; sub 1328 1330; mul 469
1021; mul 9 1332; mul 9 1333; sub 1331 1334; mul 466 1021; mul 9 1336; sub 1335 1337; mul 464 1021; sub 1338 1339;
mul 20 1340; add 1128 1341; mul 840 1342; sub 839 1343; input p 184; input c 4; input p 10; mul 0 1347; sub 5 1348;
input c 5; mul 1349 1350; sub 1346 1351; input c 6; mul 203 1353; add 1352 1354; input c 7; mul 356 1356; add 1355
1357; input c 8; input p 11; max 1359 1360; mul 244 1347; sub 233 1362; mul 1361 1363; sub 1358 1364; mul 462 1365;
mul 462 1347; add 620 1367; mul 1361 1368; mul 244 1369; add 1366 1370; mul 1350 1368; input c 9; input c 10; mul
121 1374; mul 1349 1375; sub 1373 1376; input c 11; mul 203 1378; add 1377 1379; input c 12; mul 356 1381; add 1380
1382; mul 462 1383; add 1372 1384; mul 462 1349; mul 1375 1386; sub 1385 1387; mul 0 1388; add 1371 1389; mul 1345
1390; add 1344 1391; mul 443 449; mul 437 437; sub 1393 1394; mul 458 1395; mul 402 1396; mul 391 1396; mul 393 620;
add 1398 1399; mul 307 1396; mul 420 449; mul 430 437; sub 1402 1403; mul 458 1404; mul 624 1405; sub 1401 1406; mul
1 620; mul 302 1408; sub 1407 1409; mul 339 1410; add 1400 1411; mul 384 1412; mul 339 1413; mul 242 1396; mul 245
620; add 1415 1416; mul 182 1410; add 1417 1418; mul 232 1419; mul 182 1420; add 1414 1421; mul 233 1422; sub 1397
1423; mul 306 1424; mul 402 1405; mul 56 1426; mul 617 620; add 1427 1428; mul 323 1412; mul 358 1430; mul 359 1431;
mul 345 1430; mul 352 1433; mul 348 1433; mul 350 1435; add 1434 1436; mul 657 1437; mul 652 1438; sub 1432 1439;
mul 397 1412; mul 383 1441; mul 379 1441; mul 382 1443; add 1442 1444; mul 375 1412; add 1445 1446; mul 323 1447;
mul 671 1448; mul 336 1448; mul 378 1450; add 1449 1451; mul 336 1450; mul 377 1453; add 1452 1454; mul 244 1413;
sub 1456 638; mul 329 1457; mul 399 1410; mul 309 1413; add 1459 1460; mul 322 1461; sub 1458 1462; mul 399 1396;
mul 233 1413; add 1464 1465; mul 241 1466; mul 389 1467; sub 1463 1468; mul 323 1469; mul 354 1430; mul 340 1471;
mul 342 1472; add 1470 1473; mul 337 1472; mul 184 1475; add 1474 1476; mul 687 1477; mul 337 1478; sub 1455 1479;
mul 670 1480; add 1440 1481; neg 1472; mul 184 1483; add 1482 1484; mul 323 1485; mul 647 1486; mul 645 1487; mul
338 1461; mul 338 1467; mul 387 1490; add 1489 1491; sub 1488 1492; add 1429 1493; sub 1425 1494; mul 20 1408; mul
22 1396; sub 1496 1497; mul 598 1498; mul 601 1499; mul 609 1499; mul 598 1408; mul 601 1502; add 1501 1503; mul 20
1504; add 1500 1505; mul 599 1502; add 1506 1507; mul 302 1422; sub 1508 1509; mul 731 1510; sub 1495 1511; mul 402
1408; mul 303 1422; add 1513 1514; mul 301 1515; sub 1512 1516; mul 313 1396; mul 233 1420; add 1518 1519; mul 241
1520; mul 181 1521; mul 236 1522; mul 313 1410; mul 309 1420; add 1524 1525; mul 181 1526; sub 1523 1527; mul 166
1419; mul 205 1529; mul 206 1530; mul 189 1529; mul 199 1532; mul 195 1532; mul 197 1534; add 1533 1535; mul 777
1536; mul 772 1537; sub 1531 1538; mul 311 1419; mul 231 1540; mul 227 1540; mul 230 1542; add 1541 1543; mul 222
1419; add 1544 1545; mul 166 1546; mul 791 1547; mul 179 1547; mul 226 1549; add 1548 1550; mul 179 1549; mul 225
1552; add 1551 1553; mul 244 1420; sub 1555 758; mul 172 1556; mul 165 1526; sub 1557 1558; mul 238 1521; sub 1559
1560; mul 166 1561; mul 201 1529; mul 183 1563; mul 186 1564; add 1562 1565; mul 180 1564; mul 184 1567; add 1566
1568; mul 807 1569; mul 180 1570; sub 1554 1571; mul 790 1572; add 1539 1573; neg 1564; mul 184 1575; add 1574 1576;
mul 166 1577; mul 767 1578; mul 765 1579; add 1528 1580; add 1493 1581; mul 141 1582; add 1517 1583; sub 1584 1581;
mul 463 1405; mul 551 1586; mul 24 1587; mul 841 1588; mul 59 1426; mul 53 1590; mul 24 1591; mul 841 1592; mul 49
1590; mul 9 1594; mul 841 1595; add 1593 1596; mul 44 1590; mul 9 1598; mul 24 1599; add 1597 1600; sub 1589 1601;
mul 487 1586; mul 9 1603; mul 841 1604; add 1602 1605; mul 863 1586; mul 841 1607; add 1606 1608; mul 475 1586; mul
24 1610; mul 24 1611; add 1609 1612; mul 871 1586; mul 9 1614; mul 24 1615; add 1613 1616; mul 466 1586; mul 24
1618; add 1617 1619; mul 59 1424; mul 22 1621; mul 59 1515; mul 20 1623; sub 1622 1624; mul 112 1625; mul 47 1626;
add 1620 1627; mul 2 1626; mul 841 1629; add 1628 1630; mul 263 1625; mul 24 1632; mul 841 1633; add 1631 1634; mul
53 1625; mul 9 1636; mul 841 1637; add 1635 1638; mul 290 1625; mul 24 1640; mul 24 1641; add 1639 1642; mul 89
1625; mul 9 1644; mul 9 1645; add 1643 1646; mul 86 1625; add 1647 1648; mul 269 1623; mul 47 1650; sub 1649 1651;
mul 2 1650; mul 841 1653; sub 1652 1654; mul 266 1623; mul 24 1656; mul 841 1657; sub 1655 1658; mul 263 1623; mul
24 1660; mul 24 1661; sub 1659 1662; mul 260 1623; mul 9 1664; mul 24 1665; sub 1663 1666; mul 49 1623; mul 9 1668;
mul 9 1669; sub 1667 1670; mul 253 1623; sub 1671 1672; mul 59 1582; mul 121 1674; mul 9 1675; sub 1676 1590; mul 3
1677; add 1673 1678; mul 5 1675; add 1621 1680; mul 124 1681; add 1679 1682; mul 128 1675; add 1683 1684; mul 2
1675; sub 1686 1623; mul 122 1687; add 1685 1688; mul 117 1674; mul 113 1690; add 1689 1691; mul 2 1690; mul 47
1693; add 1692 1694; mul 2 1693; mul 841 1696; add 1695 1697; mul 112 1674; mul 24 1699; mul 47 1700; add 1698 1701;
mul 2 1700; mul 841 1703; add 1702 1704; mul 108 1674; mul 24 1706; mul 24 1707; mul 841 1708; add 1705 1709; mul 53
1674; mul 9 1711; mul 24 1712; mul 841 1713; add 1710 1714; mul 101 1674; mul 9 1716; mul 9 1717; mul 841 1718; add
1715 1719; mul 98 1674; mul 841 1721; add 1720 1722; mul 93 1674; mul 24 1724; mul 24 1725; mul 24 1726; add 1723
1727; mul 89 1674; mul 9 1729; mul 9 1730; mul 24 1731; add 1728 1732; mul 86 1674; mul 24 1734; add 1733 1735; mul
463 1396; mul 581 1737; mul 580 1738; mul 1010 1737; mul 576 1740; mul 575 1741; add 1739 1742; mul 568 1740; mul
569 1737; add 1744 1745; mul 565 1746; add 1743 1747; neg 1748; where 1006 1749; mul 463 1408; mul 575 1751; mul 589
1752; mul 184 1753; mul 575 1754; where 564 1755; add 1750 1756; mul 590 1751; mul 184 1758; where 564 1759; add
1757 1760; mul 582 1752; where 564 1762; add 1761 1763; mul 585 1751; mul 184 1765; where 564 1766; add 1764 1767;
mul 574 1738; neg 1769; where 1006 1770; mul 582 1751; where 564 1772; add 1771 1773; mul 575 1774; add 1768 1775;
mul 577 1751; mul 184 1777; where 564 1778; add 1776 1779; mul 1004 1780; mul 999 1781; add 1736 1782; mul 20 1751;
mul 22 1737; sub 1784 1785; mul 556 1786; mul 47 1787; add 1783 1788; mul 2 1787; mul 841 1790; add 1789 1791; mul
496 1786; mul 24 1793; mul 841 1794; add 1792 1795; mul 551 1786; mul 9 1797; mul 841 1798; add 1796 1799; mul 548
1786; mul 841 1801; add 1800 1802; mul 545 1786; mul 24 1804; mul 24 1805; add 1803 1806; mul 542 1786; mul 9 1808;
mul 24 1809; add 1807 1810; mul 539 1786; mul 24 1812; add 1811 1813; mul 469 1786; mul 9 1815; mul 9 1816; add 1814
1817; mul 466 1786; mul 9 1819; add 1818 1820; mul 464 1786; add 1821 1822; mul 502 1751; mul 47 1824; add 1823
1825; mul 2 1824; mul 841 1827; add 1826 1828; mul 499 1751; mul 24 1830; mul 841 1831; add 1829 1832; mul 496 1751;
mul 24 1834; mul 24 1835; add 1833 1836; mul 493 1751; mul 9 1838; mul 24 1839; add 1837 1840; mul 490 1751; mul 24
1842; add 1841 1843; mul 487 1751; mul 9 1845; mul 9 1846; add 1844 1847; mul 484 1751; mul 9 1849; add 1848 1850;
mul 481 1751; add 1851 1852; mul 47 1587; mul 47 1591; mul 2 1599; add 1855 1856; mul 39 1590; mul 33 1858; add 1857
1859; mul 24 1858; mul 1135 1861; add 1860 1862; mul 35 1590; mul 9 1864; mul 1135 1865; add 1863 1866; mul 30 1590;
mul 9 1868; mul 9 1869; add 1867 1870; mul 25 1590; add 1871 1872; sub 1854 1873; mul 42 1610; add 1874 1875; mul 2
1611; add 1876 1877; mul 2 1615; add 1878 1879; mul 2 1618; add 1880 1881; mul 1159 1586; mul 33 1883; add 1882
1884; mul 24 1883; mul 1135 1886; add 1885 1887; mul 521 1586; mul 9 1889; mul 1135 1890; add 1888 1891; mul 1170
1586; mul 1135 1893; add 1892 1894; mul 1174 1586; mul 9 1896; mul 9 1897; add 1895 1898; mul 1179 1586; mul 9 1900;
add 1899 1901; mul 506 1586; add 1902 1903; mul 47 1632; add 1904 1905; mul 42 1640; add 1906 1907; mul 2 1641; add
1908 1909; mul 283 1625; mul 33 1911; add 1910 1912; mul 24 1911; mul 1135 1914; add 1913 1915; mul 280 1625; mul 9
1917; mul 1135 1918; add 1916 1919; mul 35 1625; mul 9 1921; mul 9 1922; add 1920 1923; mul 275 1625; add 1924 1925;
mul 47 1656; sub 1926 1927; mul 42 1660; sub 1928 1929; mul 2 1661; sub 1930 1931; mul 2 1665; sub 1932 1933; mul 93
1623; mul 33 1935; sub 1934 1936; mul 24 1935; mul 1135 1938; sub 1937 1939; mul 89 1623; mul 9 1941; mul 9 1942;
sub 1940 1943; mul 86 1623; sub 1944 1945; mul 113 1699; add 1946 1947; mul 52 1706; add 1948 1949; mul 47 1707; add
1950 1951; mul 47 1712; add 1952 1953; mul 94 1724; add 1954 1955; mul 42 1725; add 1956 1957; mul 2 1726; add 1958
1959; mul 2 1731; add 1960 1961; mul 2 1734; add 1962 1963; mul 82 1674; mul 38 1965; add 1964 1966; mul 24 1965;
mul 33 1968; add 1967 1969; mul 24 1968; mul 1135 1971; add 1970 1972; mul 39 1674; mul 9 1974; mul 33 1975; add
1973 1976; mul 24 1975; mul 1135 1978; add 1977 1979; mul 75 1674; mul 9 1981; mul 9 1982; mul 1135 1983; add 1980
1984; mul 72 1674; mul 1135 1986; add 1985 1987; mul 68 1674; mul 9 1989; mul 9 1990; mul 9 1991; add 1988 1992; mul
25 1674; mul 9 1994; add 1993 1995; mul 47 1793; add 1996 1997; mul 42 1804; add 1998 1999; mul 2 1805; add 2000
2001; mul 2 1809; add 2002 2003; mul 2 1812; add 2004 2005; mul 530 1786; mul 33 2007; add 2006 2008; mul 24 2007;
mul 1135 2010; add 2009 2011; mul 527 1786; mul 9 2013; mul 1135 2014; add 2012 2015; mul 524 1786; mul 1135 2017;
add 2016 2018; mul 521 1786; mul 9 2020; mul 9 2021; add 2019 2022; mul 518 1786; mul 9 2024; add 2023 2025; mul 515
1786; add 2026 2027; mul 47 1830; add 2028 2029; mul 42 1834; add 2030 2031; mul 2 1835; add 2032 2033; mul 2 1839;
add 2034 2035; mul 2 1842; add 2036 2037; mul 478 1751; mul 33 2039; add 2038 2040; mul 24 2039; mul 1135 2042; add
2041 2043; mul 475 1751; mul 9 2045; mul 1135 2046; add 2044 2047; mul 472 1751; mul 1135 2049; add 2048 2050; mul
469 1751; mul 9 2052; mul 9 2053; add 2051 2054; mul 466 1751; mul 9 2056; add 2055 2057; mul 464 1751; add 2058
2059; mul 20 2060; add 1853 2061; mul 840 2062; sub 1585 2063; mul 620 1365; mul 620 1347; add 1396 2066; mul 1361
2067; mul 244 2068; add 2065 2069; mul 620 1349; mul 1375 2071; mul 1350 2067; mul 620 1383; add 2073 2074; sub 2072
2075; mul 0 2076; sub 2070 2077; mul 1345 2078; sub 2064 2079; mul 435 449; mul 430 430; sub 2081 2082; mul 458
2083; mul 402 2084; mul 56 2085; mul 459 617; add 2086 2087; mul 391 1405; mul 393 459; add 2089 2090; mul 624 2084;
mul 307 1405; sub 2092 2093; mul 1 459; mul 302 2095; add 2094 2096; mul 339 2097; sub 2091 2098; mul 384 2099; mul
309 2100; mul 399 2097; sub 2101 2102; mul 338 2103; mul 399 1405; mul 233 2100; add 2105 2106; mul 241 2107; mul
338 2108; mul 387 2109; add 2104 2110; mul 323 2099; mul 345 2112; mul 352 2113; mul 348 2113; mul 350 2115; add
2114 2116; mul 657 2117; mul 652 2118; mul 358 2112; mul 359 2120; sub 2119 2121; mul 397 2099; mul 383 2123; mul
379 2123; mul 382 2125; add 2124 2126; mul 375 2099; add 2127 2128; mul 323 2129; mul 671 2130; mul 336 2130; mul
378 2132; add 2131 2133; mul 336 2132; mul 377 2135; add 2134 2136; mul 322 2103; mul 399 459; mul 244 2100; sub
2139 2140; mul 329 2141; add 2138 2142; mul 389 2108; add 2143 2144; mul 323 2145; mul 354 2112; mul 340 2147; mul
342 2148; sub 2146 2149; mul 337 2148; neg 2151; mul 184 2152; add 2150 2153; mul 687 2154; mul 337 2155; add 2137
2156; mul 670 2157; sub 2122 2158; mul 184 2148; add 2159 2160; mul 323 2161; mul 647 2162; mul 645 2163; add 2111
2164; sub 2088 2165; mul 339 2100; mul 242 1405; mul 245 459; add 2168 2169; mul 182 2097; sub 2170 2171; mul 232
2172; mul 182 2173; add 2167 2174; mul 233 2175; sub 2176 1426; mul 306 2177; add 2166 2178; mul 22 1405; mul 20
2095; sub 2180 2181; mul 598 2182; mul 601 2183; mul 609 2183; mul 598 2095; mul 601 2186; sub 2185 2187; mul 20
2188; add 2184 2189; mul 599 2186; sub 2190 2191; mul 302 2175; add 2192 2193; mul 731 2194; sub 2179 2195; mul 402
2095; mul 303 2175; add 2197 2198; mul 301 2199; add 2196 2200; mul 309 2173; mul 313 2097; sub 2202 2203; mul 181
2204; mul 313 1405; mul 233 2173; add 2206 2207; mul 241 2208; mul 181 2209; mul 236 2210; sub 2205 2211; mul 166
2172; mul 189 2213; mul 199 2214; mul 195 2214; mul 197 2216; add 2215 2217; mul 777 2218; mul 772 2219; mul 205
2213; mul 206 2221; sub 2220 2222; mul 311 2172; mul 231 2224; mul 227 2224; mul 230 2226; add 2225 2227; mul 222
2172; add 2228 2229; mul 166 2230; mul 791 2231; mul 179 2231; mul 226 2233; add 2232 2234; mul 179 2233; mul 225
2236; add 2235 2237; mul 165 2204; mul 313 459; mul 244 2173; sub 2240 2241; mul 172 2242; add 2239 2243; mul 238
2209; add 2244 2245; mul 166 2246; mul 201 2213; mul 183 2248; mul 186 2249; sub 2247 2250; mul 180 2249; neg 2252;
mul 184 2253; add 2251 2254; mul 807 2255; mul 180 2256; add 2238 2257; mul 790 2258; sub 2223 2259; mul 184 2249;
add 2260 2261; mul 166 2262; mul 767 2263; mul 765 2264; add 2212 2265; add 2165 2266; mul 141 2267; add 2201 2268;
sub 2269 2266; mul 59 2085; mul 53 2271; mul 24 2272; mul 841 2273; mul 49 2271; mul 9 2275; mul 841 2276; add 2274
2277; mul 44 2271; mul 9 2279; mul 24 2280; add 2278 2281; mul 463 2084; mul 551 2283; mul 24 2284; mul 841 2285;
sub 2282 2286; mul 487 2283; mul 9 2288; mul 841 2289; sub 2287 2290; mul 863 2283; mul 841 2292; sub 2291 2293; mul
475 2283; mul 24 2295; mul 24 2296; sub 2294 2297; mul 871 2283; mul 9 2299; mul 24 2300; sub 2298 2301; mul 466
2283; mul 24 2303; sub 2302 2304; mul 59 2177; mul 22 2306; mul 59 2199; mul 20 2308; add 2307 2309; mul 112 2310;
mul 47 2311; add 2305 2312; mul 2 2311; mul 841 2314; add 2313 2315; mul 263 2310; mul 24 2317; mul 841 2318; add
2316 2319; mul 53 2310; mul 9 2321; mul 841 2322; add 2320 2323; mul 290 2310; mul 24 2325; mul 24 2326; add 2324
2327; mul 89 2310; mul 9 2329; mul 9 2330; add 2328 2331; mul 86 2310; add 2332 2333; mul 269 2308; mul 47 2335; add
2334 2336; mul 2 2335; mul 841 2338; add 2337 2339; mul 266 2308; mul 24 2341; mul 841 2342; add 2340 2343; mul 263
2308; mul 24 2345; mul 24 2346; add 2344 2347; mul 260 2308; mul 9 2349; mul 24 2350; add 2348 2351; mul 49 2308;
mul 9 2353; mul 9 2354; add 2352 2355; mul 253 2308; add 2356 2357; mul 59 2267; mul 121 2359; mul 9 2360; add 2271
2361; mul 3 2362; add 2358 2363; mul 5 2360; add 2306 2365; mul 124 2366; add 2364 2367; mul 128 2360; add 2368
2369; mul 2 2360; add 2308 2371; mul 122 2372; add 2370 2373; mul 117 2359; mul 113 2375; add 2374 2376; mul 2 2375;
mul 47 2378; add 2377 2379; mul 2 2378; mul 841 2381; add 2380 2382; mul 112 2359; mul 24 2384; mul 47 2385; add
2383 2386; mul 2 2385; mul 841 2388; add 2387 2389; mul 108 2359; mul 24 2391; mul 24 2392; mul 841 2393; add 2390
2394; mul 53 2359; mul 9 2396; mul 24 2397; mul 841 2398; add 2395 2399; mul 101 2359; mul 9 2401; mul 9 2402; mul
841 2403; add 2400 2404; mul 98 2359; mul 841 2406; add 2405 2407; mul 93 2359; mul 24 2409; mul 24 2410; mul 24
2411; add 2408 2412; mul 89 2359; mul 9 2414; mul 9 2415; mul 24 2416; add 2413 2417; mul 86 2359; mul 24 2419; add
2418 2420; mul 581 1586; mul 580 2422; mul 1010 1586; mul 576 2424; mul 575 2425; add 2423 2426; mul 568 2424; mul
569 1586; add 2428 2429; mul 565 2430; add 2427 2431; where 1006 2432; mul 463 2095; mul 575 2434; mul 589 2435; neg
2436; mul 184 2437; mul 575 2438; where 564 2439; add 2433 2440; mul 590 2434; neg 2442; mul 184 2443; where 564
2444; add 2441 2445; mul 582 2435; neg 2447; where 564 2448; add 2446 2449; mul 585 2434; neg 2451; mul 184 2452;
where 564 2453; add 2450 2454; mul 574 2422; where 1006 2456; mul 582 2434; neg 2458; where 564 2459; add 2457 2460;
mul 575 2461; add 2455 2462; mul 577 2434; neg 2464; mul 184 2465; where 564 2466; add 2463 2467; mul 1004 2468; mul
999 2469; add 2421 2470; mul 22 1586; mul 20 2434; sub 2472 2473; mul 556 2474; mul 47 2475; add 2471 2476; mul 2
2475; mul 841 2478; add 2477 2479; mul 496 2474; mul 24 2481; mul 841 2482; add 2480 2483; mul 551 2474; mul 9 2485;
mul 841 2486; add 2484 2487; mul 548 2474; mul 841 2489; add 2488 2490; mul 545 2474; mul 24 2492; mul 24 2493; add
2491 2494; mul 542 2474; mul 9 2496; mul 24 2497; add 2495 2498; mul 539 2474; mul 24 2500; add 2499 2501; mul 469
2474; mul 9 2503; mul 9 2504; add 2502 2505; mul 466 2474; mul 9 2507; add 2506 2508; mul 464 2474; add 2509 2510;
mul 502 2434; mul 47 2512; sub 2511 2513; mul 2 2512; mul 841 2515; sub 2514 2516; mul 499 2434; mul 24 2518; mul
841 2519; sub 2517 2520; mul 496 2434; mul 24 2522; mul 24 2523; sub 2521 2524; mul 493 2434; mul 9 2526; mul 24
2527; sub 2525 2528; mul 490 2434; mul 24 2530; sub 2529 2531; mul 487 2434; mul 9 2533; mul 9 2534; sub 2532 2535;
mul 484 2434; mul 9 2537; sub 2536 2538; mul 481 2434; sub 2539 2540; mul 47 2272; mul 2 2280; add 2542 2543; mul 39
2271; mul 33 2545; add 2544 2546; mul 24 2545; mul 1135 2548; add 2547 2549; mul 35 2271; mul 9 2551; mul 1135 2552;
add 2550 2553; mul 30 2271; mul 9 2555; mul 9 2556; add 2554 2557; mul 25 2271; add 2558 2559; mul 47 2284; sub 2560
2561; mul 42 2295; sub 2562 2563; mul 2 2296; sub 2564 2565; mul 2 2300; sub 2566 2567; mul 2 2303; sub 2568 2569;
mul 1159 2283; mul 33 2571; sub 2570 2572; mul 24 2571; mul 1135 2574; sub 2573 2575; mul 521 2283; mul 9 2577; mul
1135 2578; sub 2576 2579; mul 1170 2283; mul 1135 2581; sub 2580 2582; mul 1174 2283; mul 9 2584; mul 9 2585; sub
2583 2586; mul 1179 2283; mul 9 2588; sub 2587 2589; mul 506 2283; sub 2590 2591; mul 47 2317; add 2592 2593; mul 42
2325; add 2594 2595; mul 2 2326; add 2596 2597; mul 283 2310; mul 33 2599; add 2598 2600; mul 24 2599; mul 1135
2602; add 2601 2603; mul 280 2310; mul 9 2605; mul 1135 2606; add 2604 2607; mul 35 2310; mul 9 2609; mul 9 2610;
add 2608 2611; mul 275 2310; add 2612 2613; mul 47 2341; add 2614 2615; mul 42 2345; add 2616 2617; mul 2 2346; add
2618 2619; mul 2 2350; add 2620 2621; mul 93 2308; mul 33 2623; add 2622 2624; mul 24 2623; mul 1135 2626; add 2625
2627; mul 89 2308; mul 9 2629; mul 9 2630; add 2628 2631; mul 86 2308; add 2632 2633; mul 113 2384; add 2634 2635;
mul 52 2391; add 2636 2637; mul 47 2392; add 2638 2639; mul 47 2397; add 2640 2641; mul 94 2409; add 2642 2643; mul
42 2410; add 2644 2645; mul 2 2411; add 2646 2647; mul 2 2416; add 2648 2649; mul 2 2419; add 2650 2651; mul 82
2359; mul 38 2653; add 2652 2654; mul 24 2653; mul 33 2656; add 2655 2657; mul 24 2656; mul 1135 2659; add 2658
2660; mul 39 2359; mul 9 2662; mul 33 2663; add 2661 2664; mul 24 2663; mul 1135 2666; add 2665 2667; mul 75 2359;
mul 9 2669; mul 9 2670; mul 1135 2671; add 2668 2672; mul 72 2359; mul 1135 2674; add 2673 2675; mul 68 2359; mul 9
2677; mul 9 2678; mul 9 2679; add 2676 2680; mul 25 2359; mul 9 2682; add 2681 2683; mul 47 2481; add 2684 2685; mul
42 2492; add 2686 2687; mul 2 2493; add 2688 2689; mul 2 2497; add 2690 2691; mul 2 2500; add 2692 2693; mul 530
2474; mul 33 2695; add 2694 2696; mul 24 2695; mul 1135 2698; add 2697 2699; mul 527 2474; mul 9 2701; mul 1135
2702; add 2700 2703; mul 524 2474; mul 1135 2705; add 2704 2706; mul 521 2474; mul 9 2708; mul 9 2709; add 2707
2710; mul 518 2474; mul 9 2712; add 2711 2713; mul 515 2474; add 2714 2715; mul 47 2518; sub 2716 2717; mul 42 2522;
sub 2718 2719; mul 2 2523; sub 2720 2721; mul 2 2527; sub 2722 2723; mul 2 2530; sub 2724 2725; mul 478 2434; mul 33
2727; sub 2726 2728; mul 24 2727; mul 1135 2730; sub 2729 2731; mul 475 2434; mul 9 2733; mul 1135 2734; sub 2732
2735; mul 472 2434; mul 1135 2737; sub 2736 2738; mul 469 2434; mul 9 2740; mul 9 2741; sub 2739 2742; mul 466 2434;
mul 9 2744; sub 2743 2745; mul 464 2434; sub 2746 2747; mul 20 2748; add 2541 2749; mul 840 2750; sub 2270 2751; mul
459 1365; mul 459 1347; add 1405 2754; mul 1361 2755; mul 244 2756; add 2753 2757; mul 1350 2755; mul 459 1383; add
2759 2760; mul 459 1349; mul 1375 2762; sub 2761 2763; mul 0 2764; add 2758 2765; mul 1345 2766; add 2752 2767; mul
182 227; mul 233 2769; mul 306 2770; mul 302 2769; mul 731 2772; sub 2771 2773; mul 303 2769; mul 301 2775; add 2774
2776; mul 227 309; mul 181 2778; mul 227 233; mul 241 2780; mul 181 2781; mul 236 2782; sub 2779 2783; mul 166 311;
mul 791 2785; mul 179 2785; mul 226 2787; add 2786 2788; mul 179 2787; mul 225 2790; add 2789 2791; mul 165 2778;
mul 227 244; mul 172 2794; sub 2793 2795; mul 238 2781; add 2796 2797; mul 166 2798; mul 807 2799; mul 180 2800; add
2792 2801; mul 790 2802; mul 166 2803; mul 767 2804; mul 765 2805; sub 2784 2806; mul 141 2807; add 2777 2808; sub
2809 2807; mul 59 2770; mul 22 2811; mul 59 2775; mul 20 2813; add 2812 2814; mul 112 2815; mul 47 2816; mul 2 2816;
mul 841 2818; add 2817 2819; mul 263 2815; mul 24 2821; mul 841 2822; add 2820 2823; mul 53 2815; mul 9 2825; mul
841 2826; add 2824 2827; mul 290 2815; mul 24 2829; mul 24 2830; add 2828 2831; mul 89 2815; mul 9 2833; mul 9 2834;
add 2832 2835; mul 86 2815; add 2836 2837; mul 269 2813; mul 47 2839; add 2838 2840; mul 2 2839; mul 841 2842; add
2841 2843; mul 266 2813; mul 24 2845; mul 841 2846; add 2844 2847; mul 263 2813; mul 24 2849; mul 24 2850; add 2848
2851; mul 260 2813; mul 9 2853; mul 24 2854; add 2852 2855; mul 49 2813; mul 9 2857; mul 9 2858; add 2856 2859; mul
253 2813; add 2860 2861; mul 59 2807; mul 121 2863; mul 9 2864; mul 3 2865; add 2862 2866; mul 5 2864; add 2811
2868; mul 124 2869; add 2867 2870; mul 128 2864; add 2871 2872; mul 2 2864; add 2813 2874; mul 122 2875; add 2873
2876; mul 117 2863; mul 113 2878; add 2877 2879; mul 2 2878; mul 47 2881; add 2880 2882; mul 2 2881; mul 841 2884;
add 2883 2885; mul 112 2863; mul 24 2887; mul 47 2888; add 2886 2889; mul 2 2888; mul 841 2891; add 2890 2892; mul
108 2863; mul 24 2894; mul 24 2895; mul 841 2896; add 2893 2897; mul 53 2863; mul 9 2899; mul 24 2900; mul 841 2901;
add 2898 2902; mul 101 2863; mul 9 2904; mul 9 2905; mul 841 2906; add 2903 2907; mul 98 2863; mul 841 2909; add
2908 2910; mul 93 2863; mul 24 2912; mul 24 2913; mul 24 2914; add 2911 2915; mul 89 2863; mul 9 2917; mul 9 2918;
mul 24 2919; add 2916 2920; mul 86 2863; mul 24 2922; add 2921 2923; mul 47 2821; mul 42 2829; add 2925 2926; mul 2
2830; add 2927 2928; mul 283 2815; mul 33 2930; add 2929 2931; mul 24 2930; mul 1135 2933; add 2932 2934; mul 280
2815; mul 9 2936; mul 1135 2937; add 2935 2938; mul 35 2815; mul 9 2940; mul 9 2941; add 2939 2942; mul 275 2815;
add 2943 2944; mul 47 2845; add 2945 2946; mul 42 2849; add 2947 2948; mul 2 2850; add 2949 2950; mul 2 2854; add
2951 2952; mul 93 2813; mul 33 2954; add 2953 2955; mul 24 2954; mul 1135 2957; add 2956 2958; mul 89 2813; mul 9
2960; mul 9 2961; add 2959 2962; mul 86 2813; add 2963 2964; mul 113 2887; add 2965 2966; mul 52 2894; add 2967
2968; mul 47 2895; add 2969 2970; mul 47 2900; add 2971 2972; mul 94 2912; add 2973 2974; mul 42 2913; add 2975
2976; mul 2 2914; add 2977 2978; mul 2 2919; add 2979 2980; mul 2 2922; add 2981 2982; mul 82 2863; mul 38 2984; add
2983 2985; mul 24 2984; mul 33 2987; add 2986 2988; mul 24 2987; mul 1135 2990; add 2989 2991; mul 39 2863; mul 9
2993; mul 33 2994; add 2992 2995; mul 24 2994; mul 1135 2997; add 2996 2998; mul 75 2863; mul 9 3000; mul 9 3001;
mul 1135 3002; add 2999 3003; mul 72 2863; mul 1135 3005; add 3004 3006; mul 68 2863; mul 9 3008; mul 9 3009; mul 9
3010; add 3007 3011; mul 25 2863; mul 9 3013; add 3012 3014; mul 20 3015; add 2924 3016; mul 840 3017; sub 2810
3018; mul 339 379; mul 233 3020; mul 306 3021; mul 309 379; mul 338 3023; mul 233 379; mul 241 3025; mul 338 3026;
mul 387 3027; add 3024 3028; mul 323 397; mul 671 3030; mul 336 3030; mul 378 3032; add 3031 3033; mul 336 3032; mul
377 3035; add 3034 3036; mul 322 3023; mul 244 379; mul 329 3039; sub 3038 3040; mul 389 3026; add 3041 3042; mul
323 3043; mul 687 3044; mul 337 3045; add 3037 3046; mul 670 3047; mul 323 3048; mul 647 3049; mul 645 3050; sub
3029 3051; sub 3022 3052; mul 302 3020; mul 731 3054; sub 3053 3055; mul 303 3020; mul 301 3057; add 3056 3058; mul
141 3052; add 3059 3060; mul 59 3021; mul 22 3062; mul 59 3057; mul 20 3064; add 3063 3065; mul 112 3066; mul 47
3067; mul 2 3067; mul 841 3069; add 3068 3070; mul 263 3066; mul 24 3072; mul 841 3073; add 3071 3074; mul 53 3066;
mul 9 3076; mul 841 3077; add 3075 3078; mul 290 3066; mul 24 3080; mul 24 3081; add 3079 3082; mul 89 3066; mul 9
3084; mul 9 3085; add 3083 3086; mul 86 3066; add 3087 3088; mul 269 3064; mul 47 3090; add 3089 3091; mul 2 3090;
mul 841 3093; add 3092 3094; mul 266 3064; mul 24 3096; mul 841 3097; add 3095 3098; mul 263 3064; mul 24 3100; mul
24 3101; add 3099 3102; mul 260 3064; mul 9 3104; mul 24 3105; add 3103 3106; mul 49 3064; mul 9 3108; mul 9 3109;
add 3107 3110; mul 253 3064; add 3111 3112; mul 59 3052; mul 121 3114; mul 9 3115; mul 3 3116; add 3113 3117; mul 5
3115; add 3062 3119; mul 124 3120; add 3118 3121; mul 128 3115; add 3122 3123; mul 2 3115; add 3064 3125; mul 122
3126; add 3124 3127; mul 117 3114; mul 113 3129; add 3128 3130; mul 2 3129; mul 47 3132; add 3131 3133; mul 2 3132;
mul 841 3135; add 3134 3136; mul 112 3114; mul 24 3138; mul 47 3139; add 3137 3140; mul 2 3139; mul 841 3142; add
3141 3143; mul 108 3114; mul 24 3145; mul 24 3146; mul 841 3147; add 3144 3148; mul 53 3114; mul 9 3150; mul 24
3151; mul 841 3152; add 3149 3153; mul 101 3114; mul 9 3155; mul 9 3156; mul 841 3157; add 3154 3158; mul 98 3114;
mul 841 3160; add 3159 3161; mul 93 3114; mul 24 3163; mul 24 3164; mul 24 3165; add 3162 3166; mul 89 3114; mul 9
3168; mul 9 3169; mul 24 3170; add 3167 3171; mul 86 3114; mul 24 3173; add 3172 3174; mul 47 3072; mul 42 3080; add
3176 3177; mul 2 3081; add 3178 3179; mul 283 3066; mul 33 3181; add 3180 3182; mul 24 3181; mul 1135 3184; add 3183
3185; mul 280 3066; mul 9 3187; mul 1135 3188; add 3186 3189; mul 35 3066; mul 9 3191; mul 9 3192; add 3190 3193;
mul 275 3066; add 3194 3195; mul 47 3096; add 3196 3197; mul 42 3100; add 3198 3199; mul 2 3101; add 3200 3201; mul
2 3105; add 3202 3203; mul 93 3064; mul 33 3205; add 3204 3206; mul 24 3205; mul 1135 3208; add 3207 3209; mul 89
3064; mul 9 3211; mul 9 3212; add 3210 3213; mul 86 3064; add 3214 3215; mul 113 3138; add 3216 3217; mul 52 3145;
add 3218 3219; mul 47 3146; add 3220 3221; mul 47 3151; add 3222 3223; mul 94 3163; add 3224 3225; mul 42 3164; add
3226 3227; mul 2 3165; add 3228 3229; mul 2 3170; add 3230 3231; mul 2 3173; add 3232 3233; mul 82 3114; mul 38
3235; add 3234 3236; mul 24 3235; mul 33 3238; add 3237 3239; mul 24 3238; mul 1135 3241; add 3240 3242; mul 39
3114; mul 9 3244; mul 33 3245; add 3243 3246; mul 24 3245; mul 1135 3248; add 3247 3249; mul 75 3114; mul 9 3251;
mul 9 3252; mul 1135 3253; add 3250 3254; mul 72 3114; mul 1135 3256; add 3255 3257; mul 68 3114; mul 9 3259; mul 9
3260; mul 9 3261; add 3258 3262; mul 25 3114; mul 9 3264; add 3263 3265; mul 20 3266; add 3175 3267; mul 840 3268;
sub 3061 3269; mul 184 569; input p 121; mul 3271 3272; mul 1010 3273; mul 565 574; mul 569 3275; add 3274 3276; mul
568 3275; mul 1010 3278; add 3277 3279; mul 576 580; mul 1010 3281; add 3280 3282; mul 574 580; mul 581 3284; add
3283 3285; mul 620 3286; where 1006 3287; input p 124; mul 9 3289; input p 125; mul 15 3291; add 3290 3292; input p
126; mul 16 3294; add 3293 3295; mul 24 506; add 3296 3297; mul 28 1179; add 3298 3299; mul 29 1174; add 3300 3301;
mul 33 1170; add 3302 3303; mul 34 521; add 3304 3305; mul 38 1159; add 3306 3307; mul 42 466; add 3308 3309; mul 43
871; add 3310 3311; mul 94 475; add 3312 3313; mul 47 863; add 3314 3315; mul 48 487; add 3316 3317; mul 52 551; add
3318 3319; mul 459 3320; sub 3288 3321; mul 22 558; mul 620 3323; add 3322 3324; mul 592 628; neg 3326; where 564
3327; add 3325 3328; mul 560 628; sub 3329 3330; mul 1405 3320; mul 1396 3286; neg 3333; where 1006 3334; add 3332
3335; mul 1396 3323; sub 3336 3337; mul 592 1408; where 564 3339; add 3338 3340; mul 560 1408; add 3341 3342; mul
1405 3286; where 1006 3344; mul 2084 3320; sub 3345 3346; mul 1405 3323; add 3347 3348; mul 592 2095; neg 3350;
where 564 3351; add 3349 3352; mul 560 2095; sub 3353 3354; mul 611 734; constant 0.8; input x 5; mul 459 3358; mul
3357 3359; sub 3356 3360; mul 606 628; sub 3361 3362; constant -2.0; mul 1363 1368; le 1359 1360; le 1360 1359; add
3366 3367; div 144 3368; mul 3366 3369; mul 3365 3370; mul 3364 3371; add 3363 3372; mul 1405 3358; mul 3357 3374;
mul 611 1498; add 3375 3376; mul 606 1408; add 3377 3378; mul 1363 2067; mul 3370 3380; mul 3364 3381; sub 3379
3382; mul 611 2182; mul 2084 3358; mul 3357 3385; sub 3384 3386; mul 606 2095; sub 3387 3388; mul 1363 2755; mul
3370 3390; mul 3364 3391; add 3389 3392; constant -2.5714285714285743; mul 113 1061; mul 3394 3395; constant
-0.8571428571428583; mul 52 854; mul 3397 3398; constant 0.9142857142857138; mul 48 854; mul 3400 3401; add 3399
3402; constant 0.05714285714285722; mul 94 854; mul 3404 3405; add 3403 3406; constant -0.11428571428571327; mul 43
854; mul 3408 3409; add 3407 3410; constant 0.2190476190476189; mul 38 854; mul 3412 3413; add 3411 3414; constant
0.11428571428571413; mul 34 854; mul 3416 3417; add 3415 3418; constant -0.05714285714285729; mul 29 854; mul 3420
3421; add 3419 3422; input p 185; mul 24 854; mul 25 3425; mul 3424 3426; add 3423 3427; constant
0.007256235827664418; mul 16 854; mul 3429 3430; add 3428 3431; mul 9 854; mul 13 3433; mul 3424 3434; add 3432
3435; sub 3396 3436; constant 2.057142857142858; mul 52 1061; mul 3438 3439; add 3437 3440; mul 48 1061; mul 3397
3442; add 3441 3443; constant -3.428571428571427; mul 94 1061; mul 3445 3446; add 3444 3447; constant
0.11428571428571443; mul 43 1061; mul 3449 3450; add 3448 3451; constant -0.057142857142856635; mul 257 1061; mul
3453 3454; add 3452 3455; mul 2 1061; mul 86 3457; mul 3424 3458; add 3456 3459; constant 2.438095238095238; mul 38
1061; mul 3461 3462; add 3460 3463; constant 0.6571428571428567; mul 34 1061; mul 3465 3466; add 3464 3467; input p
186; mul 33 1061; mul 3469 3470; sub 3468 3471; mul 29 1061; mul 3416 3473; add 3472 3474; mul 24 1061; mul 275
3476; mul 3424 3477; add 3475 3478; constant -0.019047619047619094; mul 16 1061; mul 3480 3481; add 3479 3482; mul 9
1061; mul 25 3484; mul 3424 3485; add 3483 3486; constant 12.34285714285715; mul 113 1021; mul 3488 3489; sub 3487
3490; constant -7.714285714285722; mul 52 1021; mul 3492 3493; sub 3491 3494; mul 94 1021; mul 3438 3496; sub 3495
3497; constant -1.7142857142857166; mul 43 1021; mul 3499 3500; sub 3498 3501; mul 257 1021; mul 3400 3503; sub 3502
3504; mul 2 1021; mul 253 3506; mul 3424 3507; sub 3505 3508; constant -1.1428571428571423; mul 38 1021; mul 3510
3511; sub 3509 3512; mul 34 1021; mul 3404 3514; sub 3513 3515; mul 29 1021; mul 3453 3517; sub 3516 3518; mul 24
1021; mul 86 3520; mul 3424 3521; sub 3519 3522; mul 52 1586; mul 3397 3524; mul 48 1586; mul 3400 3526; add 3525
3527; mul 94 1586; mul 3404 3529; add 3528 3530; mul 43 1586; mul 3408 3532; add 3531 3533; mul 38 1586; mul 3412
3535; add 3534 3536; mul 34 1586; mul 3416 3538; add 3537 3539; mul 29 1586; mul 3420 3541; add 3540 3542; mul 24
1586; mul 25 3544; mul 3424 3545; add 3543 3546; mul 16 1586; mul 3429 3548; add 3547 3549; mul 9 1586; mul 13 3551;
mul 3424 3552; add 3550 3553; mul 113 1786; mul 3394 3555; add 3554 3556; mul 52 1786; mul 3438 3558; add 3557 3559;
mul 48 1786; mul 3397 3561; add 3560 3562; mul 94 1786; mul 3445 3564; add 3563 3565; mul 43 1786; mul 3449 3567;
add 3566 3568; mul 257 1786; mul 3453 3570; add 3569 3571; mul 2 1786; mul 86 3573; mul 3424 3574; add 3572 3575;
mul 38 1786; mul 3461 3577; add 3576 3578; mul 34 1786; mul 3465 3580; add 3579 3581; mul 33 1786; mul 3469 3583;
sub 3582 3584; mul 29 1786; mul 3416 3586; add 3585 3587; mul 24 1786; mul 275 3589; mul 3424 3590; add 3588 3591;
mul 16 1786; mul 3480 3593; add 3592 3594; mul 9 1786; mul 25 3596; mul 3424 3597; add 3595 3598; mul 113 1751; mul
3488 3600; add 3599 3601; mul 52 1751; mul 3492 3603; add 3602 3604; mul 94 1751; mul 3438 3606; add 3605 3607; mul
43 1751; mul 3499 3609; add 3608 3610; mul 257 1751; mul 3400 3612; add 3611 3613; mul 2 1751; mul 253 3615; mul
3424 3616; add 3614 3617; mul 38 1751; mul 3510 3619; add 3618 3620; mul 34 1751; mul 3404 3622; add 3621 3623; mul
29 1751; mul 3453 3625; add 3624 3626; mul 24 1751; mul 86 3628; mul 3424 3629; add 3627 3630; mul 113 2474; mul
3394 3632; mul 52 2283; mul 3397 3634; mul 48 2283; mul 3400 3636; add 3635 3637; mul 94 2283; mul 3404 3639; add
3638 3640; mul 43 2283; mul 3408 3642; add 3641 3643; mul 38 2283; mul 3412 3645; add 3644 3646; mul 34 2283; mul
3416 3648; add 3647 3649; mul 29 2283; mul 3420 3651; add 3650 3652; mul 24 2283; mul 25 3654; mul 3424 3655; add
3653 3656; mul 16 2283; mul 3429 3658; add 3657 3659; mul 9 2283; mul 13 3661; mul 3424 3662; add 3660 3663; sub
3633 3664; mul 52 2474; mul 3438 3666; add 3665 3667; mul 48 2474; mul 3397 3669; add 3668 3670; mul 94 2474; mul
3445 3672; add 3671 3673; mul 43 2474; mul 3449 3675; add 3674 3676; mul 257 2474; mul 3453 3678; add 3677 3679; mul
2 2474; mul 86 3681; mul 3424 3682; add 3680 3683; mul 38 2474; mul 3461 3685; add 3684 3686; mul 34 2474; mul 3465
3688; add 3687 3689; mul 33 2474; mul 3469 3691; sub 3690 3692; mul 29 2474; mul 3416 3694; add 3693 3695; mul 24
2474; mul 275 3697; mul 3424 3698; add 3696 3699; mul 16 2474; mul 3480 3701; add 3700 3702; mul 9 2474; mul 25
3704; mul 3424 3705; add 3703 3706; mul 113 2434; mul 3488 3708; sub 3707 3709; mul 52 2434; mul 3492 3711; sub 3710
3712; mul 94 2434; mul 3438 3714; sub 3713 3715; mul 43 2434; mul 3499 3717; sub 3716 3718; mul 257 2434; mul 3400
3720; sub 3719 3721; mul 2 2434; mul 253 3723; mul 3424 3724; sub 3722 3725; mul 38 2434; mul 3510 3727; sub 3726
3728; mul 34 2434; mul 3404 3730; sub 3729 3731; mul 29 2434; mul 3453 3733; sub 3732 3734; mul 24 2434; mul 86
3736; mul 3424 3737; sub 3735 3738; constant -129.60000000000008; mul 3395 3740; constant 28.799999999999958; mul
3398 3742; constant 45.25714285714287; mul 3401 3744; add 3743 3745; constant -28.800000000000004; mul 47 854; mul
3747 3748; mul 3469 3749; add 3746 3750; constant -28.799999999999976; mul 3405 3752; add 3751 3753; constant
-45.25714285714286; mul 3409 3755; add 3754 3756; constant 28.79999999999999; mul 42 854; mul 3758 3759; mul 3469
3760; add 3757 3761; constant 7.199999999999994; mul 3413 3763; add 3762 3764; constant 13.714285714285717; mul 3417
3766; add 3765 3767; constant -7.199999999999996; mul 33 854; mul 3769 3770; mul 3469 3771; add 3768 3772; constant
1.3714285714285692; mul 3421 3774; add 3773 3775; constant -4.799999999999999; mul 28 854; mul 3777 3778; mul 3469
3779; add 3776 3780; constant 1.3714285714285714; mul 3430 3782; add 3781 3783; constant -1.3714285714285723; mul 15
854; mul 3785 3786; mul 3469 3787; add 3784 3788; constant 2.400000000000001; mul 3433 3790; mul 3424 3791; add 3789
3792; sub 3741 3793; constant 230.40000000000006; mul 3439 3795; add 3794 3796; mul 3442 3742; add 3797 3798;
constant -36.00000000000001; mul 47 1061; mul 3800 3801; mul 3469 3802; add 3799 3803; constant -151.20000000000002;
mul 3446 3805; add 3804 3806; constant -57.59999999999995; mul 3450 3808; add 3807 3809; constant 72.0; mul 42 1061;
mul 3811 3812; mul 3469 3813; add 3810 3814; constant -22.62857142857143; mul 3454 3816; add 3815 3817; mul 256
1061; mul 3758 3819; mul 3469 3820; add 3818 3821; constant -18.000000000000004; mul 3457 3823; mul 3424 3824; add
3822 3825; constant 35.20000000000001; mul 3462 3827; add 3826 3828; constant 21.59999999999998; mul 3466 3830; add
3829 3831; constant -30.000000000000007; mul 3470 3833; mul 3469 3834; add 3832 3835; mul 3473 3766; add 3836 3837;
constant -14.399999999999991; mul 28 1061; mul 3839 3840; mul 3469 3841; add 3838 3842; mul 599 3476; mul 3424 3844;
add 3843 3845; constant 0.4571428571428564; mul 3481 3847; add 3846 3848; constant -2.3999999999999995; mul 15 1061;
mul 3850 3851; mul 3469 3852; add 3849 3853; input p 187; constant -0.9999999999999998; mul 1061 3856; mul 3855
3857; add 3854 3858; constant 259.2000000000001; mul 3489 3860; sub 3859 3861; constant -388.80000000000024; mul
3493 3863; sub 3862 3864; mul 3496 3795; sub 3865 3866; constant 57.599999999999916; mul 3500 3868; sub 3867 3869;
constant -72.00000000000001; mul 42 1021; mul 3871 3872; mul 3469 3873; sub 3870 3874; mul 3503 3744; sub 3875 3876;
constant -57.60000000000001; mul 256 1021; mul 3878 3879; mul 3469 3880; sub 3877 3881; constant 36.000000000000014;
mul 3506 3883; mul 3424 3884; sub 3882 3885; constant -50.400000000000006; mul 3511 3887; sub 3886 3888; mul 3514
3752; sub 3889 3890; constant 36.0; mul 33 1021; mul 3892 3893; mul 3469 3894; sub 3891 3895; mul 3517 3816; sub
3896 3897; mul 28 1021; mul 3758 3899; mul 3469 3900; sub 3898 3901; mul 3520 3823; mul 3424 3903; sub 3902 3904;
mul 3524 3742; mul 3526 3744; add 3906 3907; mul 47 1586; mul 3747 3909; mul 3469 3910; add 3908 3911; mul 3529
3752; add 3912 3913; mul 3532 3755; add 3914 3915; mul 42 1586; mul 3758 3917; mul 3469 3918; add 3916 3919; mul
3535 3763; add 3920 3921; mul 3538 3766; add 3922 3923; mul 33 1586; mul 3769 3925; mul 3469 3926; add 3924 3927;
mul 3541 3774; add 3928 3929; mul 28 1586; mul 3777 3931; mul 3469 3932; add 3930 3933; mul 3548 3782; add 3934
3935; mul 15 1586; mul 3785 3937; mul 3469 3938; add 3936 3939; mul 3551 3790; mul 3424 3941; add 3940 3942; mul
3555 3740; add 3943 3944; mul 3558 3795; add 3945 3946; mul 3561 3742; add 3947 3948; mul 47 1786; mul 3800 3950;
mul 3469 3951; add 3949 3952; mul 3564 3805; add 3953 3954; mul 3567 3808; add 3955 3956; mul 42 1786; mul 3811
3958; mul 3469 3959; add 3957 3960; mul 3570 3816; add 3961 3962; mul 256 1786; mul 3758 3964; mul 3469 3965; add
3963 3966; mul 3573 3823; mul 3424 3968; add 3967 3969; mul 3577 3827; add 3970 3971; mul 3580 3830; add 3972 3973;
mul 3583 3833; mul 3469 3975; add 3974 3976; mul 3586 3766; add 3977 3978; mul 28 1786; mul 3839 3980; mul 3469
3981; add 3979 3982; mul 599 3589; mul 3424 3984; add 3983 3985; mul 3593 3847; add 3986 3987; mul 15 1786; mul 3850
3989; mul 3469 3990; add 3988 3991; mul 1786 3856; mul 3855 3993; add 3992 3994; mul 3600 3860; add 3995 3996; mul
3603 3863; add 3997 3998; mul 3606 3795; add 3999 4000; mul 3609 3868; add 4001 4002; mul 42 1751; mul 3871 4004;
mul 3469 4005; add 4003 4006; mul 3612 3744; add 4007 4008; mul 256 1751; mul 3878 4010; mul 3469 4011; add 4009
4012; mul 3615 3883; mul 3424 4014; add 4013 4015; mul 3619 3887; add 4016 4017; mul 3622 3752; add 4018 4019; mul
33 1751; mul 3892 4021; mul 3469 4022; add 4020 4023; mul 3625 3816; add 4024 4025; mul 28 1751; mul 3758 4027; mul
3469 4028; add 4026 4029; mul 3628 3823; mul 3424 4031; add 4030 4032; mul 3632 3740; mul 3634 3742; mul 3636 3744;
add 4035 4036; mul 47 2283; mul 3747 4038; mul 3469 4039; add 4037 4040; mul 3639 3752; add 4041 4042; mul 3642
3755; add 4043 4044; mul 42 2283; mul 3758 4046; mul 3469 4047; add 4045 4048; mul 3645 3763; add 4049 4050; mul
3648 3766; add 4051 4052; mul 33 2283; mul 3769 4054; mul 3469 4055; add 4053 4056; mul 3651 3774; add 4057 4058;
mul 28 2283; mul 3777 4060; mul 3469 4061; add 4059 4062; mul 3658 3782; add 4063 4064; mul 15 2283; mul 3785 4066;
mul 3469 4067; add 4065 4068; mul 3661 3790; mul 3424 4070; add 4069 4071; sub 4034 4072; mul 3666 3795; add 4073
4074; mul 3669 3742; add 4075 4076; mul 47 2474; mul 3800 4078; mul 3469 4079; add 4077 4080; mul 3672 3805; add
4081 4082; mul 3675 3808; add 4083 4084; mul 42 2474; mul 3811 4086; mul 3469 4087; add 4085 4088; mul 3678 3816;
add 4089 4090; mul 256 2474; mul 3758 4092; mul 3469 4093; add 4091 4094; mul 3681 3823; mul 3424 4096; add 4095
4097; mul 3685 3827; add 4098 4099; mul 3688 3830; add 4100 4101; mul 3691 3833; mul 3469 4103; add 4102 4104; mul
3694 3766; add 4105 4106; mul 28 2474; mul 3839 4108; mul 3469 4109; add 4107 4110; mul 599 3697; mul 3424 4112; add
4111 4113; mul 3701 3847; add 4114 4115; mul 15 2474; mul 3850 4117; mul 3469 4118; add 4116 4119; mul 2474 3856;
mul 3855 4121; add 4120 4122; mul 3708 3860; sub 4123 4124; mul 3711 3863; sub 4125 4126; mul 3714 3795; sub 4127
4128; mul 3717 3868; sub 4129 4130; mul 42 2434; mul 3871 4132; mul 3469 4133; sub 4131 4134; mul 3720 3744; sub
4135 4136; mul 256 2434; mul 3878 4138; mul 3469 4139; sub 4137 4140; mul 3723 3883; mul 3424 4142; sub 4141 4143;
mul 3727 3887; sub 4144 4145; mul 3730 3752; sub 4146 4147; mul 33 2434; mul 3892 4149; mul 3469 4150; sub 4148
4151; mul 3733 3816; sub 4152 4153; mul 28 2434; mul 3758 4155; mul 3469 4156; sub 4154 4157; mul 3736 3823; mul
3424 4159; sub 4158 4160; constant -0.04285714285714284; mul 52 842; mul 4162 4163; constant 0.029931972789115628;
mul 48 842; mul 4165 4166; add 4164 4167; constant -0.0013605442176870806; mul 43 842; mul 4169 4170; add 4168 4171;
constant -0.003571428571428574; mul 38 842; mul 4173 4174; add 4172 4175; constant 0.0027210884353741486; mul 34
842; mul 4177 4178; add 4176 4179; constant -0.0014361300075585765; mul 29 842; mul 4181 4182; add 4180 4183;
constant 0.00032473894907757275; mul 16 842; mul 4185 4186; add 4184 4187; constant -0.12857142857142845; mul 113
883; mul 4189 4190; add 4188 4191; constant 0.12857142857142853; mul 52 883; mul 4193 4194; add 4192 4195; mul 48
883; mul 4162 4197; add 4196 4198; constant 0.010714285714285735; mul 94 883; mul 4200 4201; add 4199 4202; constant
-0.0006802721088435403; mul 257 883; mul 4204 4205; add 4203 4206; constant 0.028571428571428567; mul 38 883; mul
4208 4209; add 4207 4210; constant -0.010714285714285721; mul 34 883; mul 4212 4213; add 4211 4214; mul 29 883; mul
4177 4216; add 4215 4217; constant -0.0004787100025195255; mul 16 883; mul 4219 4220; add 4218 4221; constant
1.0285714285714285; mul 113 881; mul 4223 4224; add 4222 4225; constant -0.38571428571428534; mul 52 881; mul 4227
4228; add 4226 4229; mul 94 881; mul 4193 4231; add 4230 4232; constant -0.08571428571428567; mul 43 881; mul 4234
4235; add 4233 4236; mul 257 881; mul 4165 4238; add 4237 4239; constant 0.0035714285714285787; mul 38 881; mul 4241
4242; add 4240 4243; mul 29 881; mul 4204 4245; add 4244 4246; constant 0.2571428571428571; mul 118 932; mul 4248
4249; add 4247 4250; mul 114 932; mul 4189 4252; add 4251 4253; constant 0.06428571428571427; mul 109 932; mul 4255
4256; add 4254 4257; mul 105 932; mul 4162 4259; add 4258 4260; constant 0.014965986394557814; mul 102 932; mul 4262
4263; add 4261 4264; mul 95 932; mul 4241 4266; add 4265 4267; mul 90 932; mul 4204 4269; add 4268 4270; constant
0.007142857142857142; mul 83 932; mul 4272 4273; add 4271 4274; mul 79 932; mul 4173 4276; add 4275 4277; constant
0.0013605442176870743; mul 76 932; mul 4279 4280; add 4278 4281; mul 69 932; mul 4219 4283; add 4282 4284; constant
8.118473726939319e-05; mul 63 932; mul 4286 4287; add 4285 4288; mul 113 1625; mul 4189 4290; mul 52 1590; mul 4162
4292; mul 48 1590; mul 4165 4294; add 4293 4295; mul 43 1590; mul 4169 4297; add 4296 4298; mul 38 1590; mul 4173
4300; add 4299 4301; mul 34 1590; mul 4177 4303; add 4302 4304; mul 29 1590; mul 4181 4306; add 4305 4307; mul 16
1590; mul 4185 4309; add 4308 4310; sub 4291 4311; mul 52 1625; mul 4193 4313; add 4312 4314; mul 48 1625; mul 4162
4316; add 4315 4317; mul 94 1625; mul 4200 4319; add 4318 4320; mul 257 1625; mul 4204 4322; add 4321 4323; mul 38
1625; mul 4208 4325; add 4324 4326; mul 34 1625; mul 4212 4328; add 4327 4329; mul 29 1625; mul 4177 4331; add 4330
4332; mul 16 1625; mul 4219 4334; add 4333 4335; mul 113 1623; mul 4223 4337; sub 4336 4338; mul 52 1623; mul 4227
4340; sub 4339 4341; mul 94 1623; mul 4193 4343; sub 4342 4344; mul 43 1623; mul 4234 4346; sub 4345 4347; mul 257
1623; mul 4165 4349; sub 4348 4350; mul 38 1623; mul 4241 4352; sub 4351 4353; mul 29 1623; mul 4204 4355; sub 4354
4356; mul 118 1674; mul 4248 4358; add 4357 4359; mul 114 1674; mul 4189 4361; add 4360 4362; mul 109 1674; mul 4255
4364; add 4363 4365; mul 105 1674; mul 4162 4367; add 4366 4368; mul 102 1674; mul 4262 4370; add 4369 4371; mul 95
1674; mul 4241 4373; add 4372 4374; mul 90 1674; mul 4204 4376; add 4375 4377; mul 83 1674; mul 4272 4379; add 4378
4380; mul 79 1674; mul 4173 4382; add 4381 4383; mul 76 1674; mul 4279 4385; add 4384 4386; mul 69 1674; mul 4219
4388; add 4387 4389; mul 63 1674; mul 4286 4391; add 4390 4392; mul 52 2271; mul 4162 4394; mul 48 2271; mul 4165
4396; add 4395 4397; mul 43 2271; mul 4169 4399; add 4398 4400; mul 38 2271; mul 4173 4402; add 4401 4403; mul 34
2271; mul 4177 4405; add 4404 4406; mul 29 2271; mul 4181 4408; add 4407 4409; mul 16 2271; mul 4185 4411; add 4410
4412; mul 113 2310; mul 4189 4414; add 4413 4415; mul 52 2310; mul 4193 4417; add 4416 4418; mul 48 2310; mul 4162
4420; add 4419 4421; mul 94 2310; mul 4200 4423; add 4422 4424; mul 257 2310; mul 4204 4426; add 4425 4427; mul 38
2310; mul 4208 4429; add 4428 4430; mul 34 2310; mul 4212 4432; add 4431 4433; mul 29 2310; mul 4177 4435; add 4434
4436; mul 16 2310; mul 4219 4438; add 4437 4439; mul 113 2308; mul 4223 4441; add 4440 4442; mul 52 2308; mul 4227
4444; add 4443 4445; mul 94 2308; mul 4193 4447; add 4446 4448; mul 43 2308; mul 4234 4450; add 4449 4451; mul 257
2308; mul 4165 4453; add 4452 4454; mul 38 2308; mul 4241 4456; add 4455 4457; mul 29 2308; mul 4204 4459; add 4458
4460; mul 118 2359; mul 4248 4462; add 4461 4463; mul 114 2359; mul 4189 4465; add 4464 4466; mul 109 2359; mul 4255
4468; add 4467 4469; mul 105 2359; mul 4162 4471; add 4470 4472; mul 102 2359; mul 4262 4474; add 4473 4475; mul 95
2359; mul 4241 4477; add 4476 4478; mul 90 2359; mul 4204 4480; add 4479 4481; mul 83 2359; mul 4272 4483; add 4482
4484; mul 79 2359; mul 4173 4486; add 4485 4487; mul 76 2359; mul 4279 4489; add 4488 4490; mul 69 2359; mul 4219
4492; add 4491 4493; mul 63 2359; mul 4286 4495; add 4494 4496; mul 113 2815; mul 4189 4498; mul 52 2815; mul 4193
4500; add 4499 4501; mul 48 2815; mul 4162 4503; add 4502 4504; mul 94 2815; mul 4200 4506; add 4505 4507; mul 257
2815; mul 4204 4509; add 4508 4510; mul 38 2815; mul 4208 4512; add 4511 4513; mul 34 2815; mul 4212 4515; add 4514
4516; mul 29 2815; mul 4177 4518; add 4517 4519; mul 16 2815; mul 4219 4521; add 4520 4522; mul 113 2813; mul 4223
4524; add 4523 4525; mul 52 2813; mul 4227 4527; add 4526 4528; mul 94 2813; mul 4193 4530; add 4529 4531; mul 43
2813; mul 4234 4533; add 4532 4534; mul 257 2813; mul 4165 4536; add 4535 4537; mul 38 2813; mul 4241 4539; add 4538
4540; mul 29 2813; mul 4204 4542; add 4541 4543; mul 118 2863; mul 4248 4545; add 4544 4546; mul 114 2863; mul 4189
4548; add 4547 4549; mul 109 2863; mul 4255 4551; add 4550 4552; mul 105 2863; mul 4162 4554; add 4553 4555; mul 102
2863; mul 4262 4557; add 4556 4558; mul 95 2863; mul 4241 4560; add 4559 4561; mul 90 2863; mul 4204 4563; add 4562
4564; mul 83 2863; mul 4272 4566; add 4565 4567; mul 79 2863; mul 4173 4569; add 4568 4570; mul 76 2863; mul 4279
4572; add 4571 4573; mul 69 2863; mul 4219 4575; add 4574 4576; mul 63 2863; mul 4286 4578; add 4577 4579; mul 113
3066; mul 4189 4581; mul 52 3066; mul 4193 4583; add 4582 4584; mul 48 3066; mul 4162 4586; add 4585 4587; mul 94
3066; mul 4200 4589; add 4588 4590; mul 257 3066; mul 4204 4592; add 4591 4593; mul 38 3066; mul 4208 4595; add 4594
4596; mul 34 3066; mul 4212 4598; add 4597 4599; mul 29 3066; mul 4177 4601; add 4600 4602; mul 16 3066; mul 4219
4604; add 4603 4605; mul 113 3064; mul 4223 4607; add 4606 4608; mul 52 3064; mul 4227 4610; add 4609 4611; mul 94
3064; mul 4193 4613; add 4612 4614; mul 43 3064; mul 4234 4616; add 4615 4617; mul 257 3064; mul 4165 4619; add 4618
4620; mul 38 3064; mul 4241 4622; add 4621 4623; mul 29 3064; mul 4204 4625; add 4624 4626; mul 118 3114; mul 4248
4628; add 4627 4629; mul 114 3114; mul 4189 4631; add 4630 4632; mul 109 3114; mul 4255 4634; add 4633 4635; mul 105
3114; mul 4162 4637; add 4636 4638; mul 102 3114; mul 4262 4640; add 4639 4641; mul 95 3114; mul 4241 4643; add 4642
4644; mul 90 3114; mul 4204 4646; add 4645 4647; mul 83 3114; mul 4272 4649; add 4648 4650; mul 79 3114; mul 4173
4652; add 4651 4653; mul 76 3114; mul 4279 4655; add 4654 4656; mul 69 3114; mul 4219 4658; add 4657 4659; mul 63
3114; mul 4286 4661; add 4660 4662; input p 188; mul 3802 4664; mul 3749 4664; mul 3760 4664; add 4666 4667; mul
3771 4664; add 4668 4669; mul 3779 4664; add 4670 4671; input p 189; input p 190; mul 3426 4674; mul 4673 4675; add
4672 4676; mul 3787 4664; add 4677 4678; mul 3434 4674; mul 4673 4680; add 4679 4681; mul 3791 4664; mul 4673 4683;
add 4682 4684; sub 4665 4685; mul 3813 4664; add 4686 4687; mul 3820 4664; add 4688 4689; mul 3458 4674; mul 4673
4691; add 4690 4692; mul 3824 4664; mul 4673 4694; add 4693 4695; mul 3470 4674; sub 4696 4697; mul 3834 4664; add
4698 4699; mul 3841 4664; add 4700 4701; mul 3477 4674; mul 4673 4703; add 4702 4704; mul 3844 4664; mul 4673 4706;
add 4705 4707; mul 3852 4664; add 4708 4709; mul 3485 4674; mul 4673 4711; add 4710 4712; mul 3857 4664; mul 3424
4714; add 4713 4715; mul 3469 4714; mul 4673 4717; add 4716 4718; add 3857 4719; mul 3873 4664; sub 4720 4721; mul
3880 4664; sub 4722 4723; mul 3507 4674; mul 4673 4725; sub 4724 4726; mul 3884 4664; mul 4673 4728; sub 4727 4729;
mul 3894 4664; sub 4730 4731; mul 3900 4664; sub 4732 4733; mul 3521 4674; mul 4673 4735; sub 4734 4736; mul 3903
4664; mul 4673 4738; sub 4737 4739; mul 3910 4664; mul 3918 4664; add 4741 4742; mul 3926 4664; add 4743 4744; mul
3932 4664; add 4745 4746; mul 3545 4674; mul 4673 4748; add 4747 4749; mul 3938 4664; add 4750 4751; mul 3552 4674;
mul 4673 4753; add 4752 4754; mul 3941 4664; mul 4673 4756; add 4755 4757; mul 3951 4664; add 4758 4759; mul 3959
4664; add 4760 4761; mul 3965 4664; add 4762 4763; mul 3574 4674; mul 4673 4765; add 4764 4766; mul 3968 4664; mul
4673 4768; add 4767 4769; mul 3583 4674; sub 4770 4771; mul 3975 4664; add 4772 4773; mul 3981 4664; add 4774 4775;
mul 3590 4674; mul 4673 4777; add 4776 4778; mul 3984 4664; mul 4673 4780; add 4779 4781; mul 3990 4664; add 4782
4783; mul 3597 4674; mul 4673 4785; add 4784 4786; mul 3993 4664; mul 3424 4788; add 4787 4789; mul 3469 4788; mul
4673 4791; add 4790 4792; add 3993 4793; mul 4005 4664; add 4794 4795; mul 4011 4664; add 4796 4797; mul 3616 4674;
mul 4673 4799; add 4798 4800; mul 4014 4664; mul 4673 4802; add 4801 4803; mul 4022 4664; add 4804 4805; mul 4028
4664; add 4806 4807; mul 3629 4674; mul 4673 4809; add 4808 4810; mul 4031 4664; mul 4673 4812; add 4811 4813; mul
4079 4664; mul 4039 4664; mul 4047 4664; add 4816 4817; mul 4055 4664; add 4818 4819; mul 4061 4664; add 4820 4821;
mul 3655 4674; mul 4673 4823; add 4822 4824; mul 4067 4664; add 4825 4826; mul 3662 4674; mul 4673 4828; add 4827
4829; mul 4070 4664; mul 4673 4831; add 4830 4832; sub 4815 4833; mul 4087 4664; add 4834 4835; mul 4093 4664; add
4836 4837; mul 3682 4674; mul 4673 4839; add 4838 4840; mul 4096 4664; mul 4673 4842; add 4841 4843; mul 3691 4674;
sub 4844 4845; mul 4103 4664; add 4846 4847; mul 4109 4664; add 4848 4849; mul 3698 4674; mul 4673 4851; add 4850
4852; mul 4112 4664; mul 4673 4854; add 4853 4855; mul 4118 4664; add 4856 4857; mul 3705 4674; mul 4673 4859; add
4858 4860; mul 4121 4664; mul 3424 4862; add 4861 4863; mul 3469 4862; mul 4673 4865; add 4864 4866; add 4121 4867;
mul 4133 4664; sub 4868 4869; mul 4139 4664; sub 4870 4871; mul 3724 4674; mul 4673 4873; sub 4872 4874; mul 4142
4664; mul 4673 4876; sub 4875 4877; mul 4150 4664; sub 4878 4879; mul 4156 4664; sub 4880 4881; mul 3737 4674; mul
4673 4883; sub 4882 4884; mul 4159 4664; mul 4673 4886; sub 4885 4887; mul 303 740; mul 612 628; sub 4889 4890; mul
298 881; add 4891 4892; mul 558 1021; sub 4893 4894; mul 2 1340; add 4895 4896; mul 612 1408; mul 303 1504; add 4898
4899; mul 298 1623; sub 4900 4901; mul 558 1751; add 4902 4903; mul 2 2060; add 4904 4905; mul 303 2188; mul 612
2095; sub 4907 4908; mul 298 2308; add 4909 4910; mul 558 2434; sub 4911 4912; mul 2 2748; add 4913 4914; mul 298
2813; mul 2 3015; add 4916 4917; mul 298 3064; mul 2 3266; add 4919 4920; mul 612 620; mul 558 1007; add 4922 4923;
mul 233 740; add 4924 4925; mul 298 879; add 4926 4927; mul 5 1340; add 4928 4929; mul 233 1504; mul 612 1396; mul
558 1737; add 4932 4933; sub 4931 4934; mul 298 1621; add 4935 4936; mul 5 2060; add 4937 4938; mul 612 1405; mul
558 1586; add 4940 4941; mul 233 2188; add 4942 4943; mul 298 2306; add 4944 4945; mul 5 2748; add 4946 4947; mul
298 2811; mul 5 3015; add 4949 4950; mul 298 3062; mul 5 3266; add 4952 4953; mul 2 945; mul 2 1687; mul 2 2372; mul
2 2875; mul 2 3126; mul 2 939; mul 5 945; add 4960 4961; mul 2 1681; mul 5 1687; add 4963 4964; mul 2 2366; mul 5
2372; add 4966 4967; mul 2 2869; mul 5 2875; add 4969 4970; mul 2 3120; mul 5 3126; add 4972 4973; mul 5 939; mul 5
1681; mul 5 2366; mul 5 2869; mul 5 3120; mul 2 935; mul 9 945; add 4980 4981; mul 2 1677; mul 9 1687; add 4983
4984; mul 2 2362; mul 9 2372; add 4986 4987; mul 2 2865; mul 9 2875; add 4989 4990; mul 2 3116; mul 9 3126; add 4992
4993; mul 5 935; mul 9 939; add 4995 4996; mul 5 1677; mul 9 1681; add 4998 4999; mul 5 2362; mul 9 2366; add 5001
5002; mul 5 2865; mul 9 2869; add 5004 5005; mul 5 3116; mul 9 3120; add 5007 5008; mul 9 935; mul 9 1677; mul 9
2362; mul 9 2865; mul 9 3116; mul 322 642; mul 320 5015; mul 329 642; mul 317 5017; add 5016 5018; mul 317 715; add
5019 5020; mul 338 691; mul 385 642; add 5022 5023; mul 184 329; mul 713 5025; add 5024 5026; mul 320 5027; sub 5021
5028; mul 165 762; mul 161 5030; sub 5029 5031; mul 172 762; mul 158 5033; add 5032 5034; mul 158 835; add 5035
5036; mul 181 811; mul 234 762; add 5038 5039; mul 172 184; mul 833 5041; add 5040 5042; mul 161 5043; add 5037
5044; mul 156 5045; mul 320 5017; input p 122; mul 241 620; mul 5048 5049; mul 317 5015; add 5050 5051; sub 5047
5052; mul 320 715; add 5053 5054; mul 317 5027; add 5055 5056; mul 158 5030; sub 5057 5058; mul 161 5033; sub 5059
5060; mul 161 835; sub 5061 5062; mul 158 5043; add 5063 5064; mul 156 5065; mul 5 5066; mul 156 241; mul 390 640;
mul 163 5048; mul 620 5070; sub 5069 5071; mul 239 760; add 5072 5073; mul 5068 5074; mul 156 163; mul 5065 5076;
add 5075 5077; mul 156 157; mul 5045 5079; add 5078 5080; mul 153 5081; sub 5067 5082; mul 154 184; div 144 5084;
mul 5083 5085; add 5046 5086; mul 5 5087; mul 5 5088; mul 240 240; mul 156 5074; mul 5090 5091; mul 154 5081; add
5092 5093; mul 153 184; div 144 5095; mul 5094 5096; mul 5 5097; mul 5 5098; sub 5089 5099; mul 317 1493; mul 322
1490; mul 320 5102; mul 329 1490; mul 317 5104; add 5103 5105; sub 5101 5106; mul 338 1457; mul 385 1490; sub 5108
5109; mul 1487 5025; add 5110 5111; mul 320 5112; sub 5107 5113; mul 165 1522; mul 161 5115; add 5114 5116; mul 172
1522; mul 158 5118; sub 5117 5119; mul 158 1581; add 5120 5121; mul 181 1556; mul 234 1522; sub 5123 5124; mul 1579
5041; add 5125 5126; mul 161 5127; add 5122 5128; mul 156 5129; mul 241 1396; mul 5048 5131; mul 317 5102; add 5132
5133; mul 320 5104; sub 5134 5135; mul 320 1493; add 5136 5137; mul 317 5112; add 5138 5139; mul 158 5115; add 5140
5141; mul 161 5118; add 5142 5143; mul 161 1581; sub 5144 5145; mul 158 5127; add 5146 5147; mul 156 5148; mul 5
5149; mul 1396 5070; mul 390 1466; sub 5151 5152; mul 239 1520; sub 5153 5154; mul 5068 5155; mul 5076 5148; add
5156 5157; mul 5079 5129; add 5158 5159; mul 153 5160; sub 5150 5161; mul 5085 5162; add 5130 5163; mul 5 5164; mul
5 5165; mul 156 5155; mul 5090 5167; mul 154 5160; add 5168 5169; mul 5096 5170; mul 5 5171; mul 5 5172; sub 5166
5173; mul 322 2109; mul 320 5175; mul 329 2109; mul 317 5177; add 5176 5178; mul 317 2165; add 5179 5180; mul 338
2141; mul 385 2109; add 5182 5183; mul 2163 5025; add 5184 5185; mul 320 5186; sub 5181 5187; mul 165 2210; mul 161
5189; sub 5188 5190; mul 172 2210; mul 158 5192; add 5191 5193; mul 158 2266; add 5194 5195; mul 181 2242; mul 234
2210; add 5197 5198; mul 2264 5041; add 5199 5200; mul 161 5201; add 5196 5202; mul 156 5203; mul 320 5177; mul 241
1405; mul 5048 5206; mul 317 5175; add 5207 5208; sub 5205 5209; mul 320 2165; add 5210 5211; mul 317 5186; add 5212
5213; mul 158 5189; sub 5214 5215; mul 161 5192; sub 5216 5217; mul 161 2266; sub 5218 5219; mul 158 5201; add 5220
5221; mul 156 5222; mul 5 5223; mul 390 2107; mul 1405 5070; sub 5225 5226; mul 239 2208; add 5227 5228; mul 5068
5229; mul 5076 5222; add 5230 5231; mul 5079 5203; add 5232 5233; mul 153 5234; sub 5224 5235; mul 5085 5236; add
5204 5237; mul 5 5238; mul 5 5239; mul 156 5229; mul 5090 5241; mul 154 5234; add 5242 5243; mul 5096 5244; mul 5
5245; mul 5 5246; sub 5240 5247; mul 172 2782; mul 158 5249; mul 165 2782; mul 161 5251; sub 5250 5252; mul 158
2807; add 5253 5254; mul 234 2782; mul 181 2794; sub 5256 5257; mul 2805 5041; sub 5258 5259; mul 161 5260; add 5255
5261; mul 156 5262; mul 158 5260; mul 158 5251; mul 161 5249; add 5265 5266; mul 161 2807; add 5267 5268; sub 5264
5269; mul 156 5270; mul 5 5271; mul 239 2780; mul 5068 5273; mul 5076 5270; add 5274 5275; mul 5079 5262; add 5276
5277; mul 153 5278; sub 5272 5279; mul 5085 5280; add 5263 5281; mul 5 5282; mul 5 5283; mul 156 5273; mul 5090
5285; mul 154 5278; add 5286 5287; mul 5096 5288; mul 5 5289; mul 5 5290; sub 5284 5291; mul 322 3027; mul 320 5293;
mul 329 3027; mul 317 5295; add 5294 5296; mul 317 3052; add 5297 5298; mul 385 3027; mul 338 3039; sub 5300 5301;
mul 3050 5025; sub 5302 5303; mul 320 5304; sub 5299 5305; mul 156 5306; mul 320 5295; mul 317 5293; sub 5308 5309;
mul 320 3052; add 5310 5311; mul 317 5304; add 5312 5313; mul 156 5314; mul 5 5315; mul 390 3025; mul 5068 5317; mul
5076 5314; add 5318 5319; mul 5079 5306; add 5320 5321; mul 153 5322; sub 5316 5323; mul 5085 5324; add 5307 5325;
mul 5 5326; mul 5 5327; mul 156 5317; mul 5090 5329; mul 154 5322; add 5330 5331; mul 5096 5332; mul 5 5333; mul 5
5334; sub 5328 5335; mul 588 1022; neg 5337; where 564 5338; mul 588 1752; where 564 5340; mul 588 2435; neg 5342;
where 564 5343; mul 1007 3284; where 1006 5345; mul 574 1022; mul 580 1021; add 5347 5348; mul 568 5349; neg 5350;
where 564 5351; add 5346 5352; mul 1737 3284; neg 5354; where 1006 5355; mul 574 1752; mul 580 1751; add 5357 5358;
mul 568 5359; where 564 5360; add 5356 5361; mul 1586 3284; where 1006 5363; mul 574 2435; mul 580 2434; add 5365
5366; mul 568 5367; neg 5368; where 564 5369; add 5364 5370; mul 580 1011; where 1006 5372; mul 569 1022; neg 5374;
where 564 5375; add 5373 5376; mul 580 1740; neg 5378; where 1006 5379; mul 569 1752; where 564 5381; add 5380 5382;
mul 580 2424; where 1006 5384; mul 569 2435; neg 5386; where 564 5387; add 5385 5388; mul 574 1017; where 1006 5390;
mul 570 1021; neg 5392; where 564 5393; add 5391 5394; mul 574 1746; neg 5396; where 1006 5397; mul 570 1751; where
564 5399; add 5398 5400; mul 574 2430; where 1006 5402; mul 570 2434; neg 5404; where 564 5405; add 5403 5406; mul
1011 3271; where 1006 5408; mul 1740 3271; neg 5410; where 1006 5411; mul 2424 3271; where 1006 5413; mul 244 422;
mul 233 404; add 5415 5416; mul 412 3358; add 5417 5418; mul 244 5419; mul 244 404; mul 233 406; add 5421 5422; mul
409 3358; add 5423 5424; mul 233 5425; add 5420 5426; mul 244 412; mul 233 409; add 5428 5429; mul 416 3358; add
5430 5431; mul 3358 5432; add 5427 5433; mul 411 620; mul 418 459; sub 5435 5436; mul 427 462; sub 5437 5438; mul
5434 5439; mul 463 3320; mul 402 624; sub 5441 5442; input p 136; mul 3358 5444; add 5443 5445; mul 403 5434; mul
418 5447; add 5446 5448; mul 458 5449; mul 435 5450; mul 463 3323; mul 463 3286; where 1006 5453; add 5452 5454; mul
307 402; sub 5455 5456; mul 22 612; add 5457 5458; mul 242 313; mul 391 399; add 5460 5461; add 5459 5462; sub 1365
5463; mul 241 5070; add 5464 5465; input p 112; input z 0; mul 5467 5468; input p 113; input z 1; mul 5470 5471; add
5469 5472; input p 114; input z 2; mul 5474 5475; add 5473 5476; input p 115; input z 3; mul 5478 5479; add 5477
5480; input p 123; mul 5481 5482; sub 5466 5483; mul 411 5447; sub 5484 5485; mul 458 5486; mul 420 5487; add 5451
5488; mul 458 459; mul 5449 5490; mul 458 620; mul 5486 5492; add 5491 5493; input c 0; input c 2; mul 203 5496; add
5495 5497; input c 3; mul 356 5499; add 5498 5500; mul 1349 1383; add 5501 5502; mul 1347 1365; sub 5503 5504; input
p 12; input c 1; add 5506 5507; constant 0.0; max 5508 5509; mul 244 5510; sub 5505 5511; mul 245 313; mul 393 399;
add 5513 5514; sub 616 5515; sub 5512 5516; input p 111; sub 5518 5481; input p 116; abs 244; mul 5520 5521; mul 244
5522; input p 117; mul 244 5524; mul 244 244; input p 118; add 5526 5527; sqrt 5528; div 144 5529; mul 5525 5530;
add 5523 5531; sub 5519 5532; add 5517 5533; input p 119; input x 12; sub 0 5536; mul 5535 5537; input p 120; input
x 13; sub 0 5540; mul 5539 5541; add 5538 5542; sub 5534 5543; mul 427 5447; sub 5544 5545; mul 458 462; mul 5546
5547; sub 5494 5548; mul 439 5549; add 5489 5550; mul 436 5551; add 5440 5552; mul 430 5549; mul 420 5554; mul 437
5549; mul 435 5556; sub 5555 5557; mul 436 5558; add 5553 5559; mul 420 5556; mul 443 5554; sub 5561 5562; mul 428
5563; add 5560 5564; mul 420 5450; mul 443 5487; add 5566 5567; mul 453 5549; add 5568 5569; mul 428 5570; sub 5565
5571; mul 446 5549; add 5572 5573; mul 447 5573; add 5574 5575; mul 437 5487; mul 430 5556; add 5577 5578; mul 449
5549; mul 420 5580; sub 5579 5581; mul 458 5546; mul 420 5583; sub 5582 5584; mul 419 5585; add 5576 5586; mul 437
5554; mul 430 5450; sub 5588 5589; sub 5590 5581; sub 5591 5584; mul 419 5592; add 5587 5593; mul 435 5580; mul 430
5487; mul 430 5554; add 5596 5597; sub 5595 5598; mul 435 5583; add 5599 5600; mul 441 5601; add 5594 5602; mul 437
5450; mul 437 5556; sub 5604 5605; mul 443 5580; add 5606 5607; mul 443 5583; add 5608 5609; mul 433 5610; add 5603
5611; mul 418 1405; mul 411 1396; sub 5613 5614; mul 427 620; add 5615 5616; mul 5434 5617; mul 5492 5546; mul 458
1405; mul 5449 5620; sub 5619 5621; mul 458 1396; mul 5486 5623; sub 5622 5624; mul 439 5625; add 5577 5589; sub
5626 5627; mul 436 5628; add 5618 5629; sub 5584 5577; mul 437 5625; mul 435 5632; sub 5631 5633; mul 430 5625; mul
420 5635; add 5634 5636; mul 436 5637; add 5630 5638; mul 420 5632; add 5604 5609; sub 5640 5641; mul 443 5635; sub
5642 5643; mul 428 5644; add 5639 5645; mul 453 5625; mul 428 5647; sub 5646 5648; mul 446 5625; add 5568 5650; add
5649 5651; mul 447 5651; add 5652 5653; mul 430 5632; mul 449 5625; mul 420 5656; sub 5655 5657; mul 419 5658; add
5654 5659; mul 449 5450; mul 437 5583; add 5661 5662; mul 437 5635; add 5663 5664; sub 5665 5657; mul 419 5666; add
5660 5667; mul 449 5487; mul 430 5583; sub 5669 5670; mul 430 5635; sub 5671 5672; mul 435 5656; add 5673 5674; mul
441 5675; add 5668 5676; mul 443 5656; mul 437 5632; sub 5678 5679; mul 433 5680; add 5677 5681; mul 411 1405; mul
418 2084; sub 5683 5684; mul 427 459; sub 5685 5686; mul 5434 5687; mul 458 2084; mul 5449 5689; mul 5486 5620; add
5690 5691; mul 5490 5546; sub 5692 5693; mul 439 5694; mul 436 5695; add 5688 5696; sub 5596 5600; mul 437 5694; mul
435 5699; sub 5698 5700; mul 430 5694; mul 420 5702; add 5701 5703; mul 436 5704; add 5697 5705; add 5584 5589; mul
420 5699; add 5707 5708; mul 443 5702; sub 5709 5710; mul 428 5711; add 5706 5712; mul 453 5694; sub 5627 5714; mul
428 5715; add 5713 5716; mul 446 5694; sub 5718 5489; add 5717 5719; mul 447 5719; add 5720 5721; sub 5670 5669; mul
430 5699; add 5723 5724; mul 449 5694; mul 420 5726; sub 5725 5727; mul 419 5728; add 5722 5729; mul 437 5702; sub
5731 5727; mul 419 5732; add 5730 5733; mul 435 5726; mul 430 5702; sub 5735 5736; mul 441 5737; add 5734 5738; mul
443 5726; mul 437 5699; add 5663 5741; sub 5740 5742; mul 433 5743; add 5739 5744; sub 5563 5570; sub 5644 5647; add
5711 5715; mul 403 5439; mul 244 5749; mul 244 5750; mul 403 5551; mul 418 5752; mul 462 5447; sub 5753 5754; mul
403 5558; mul 418 5756; add 5755 5757; mul 403 5563; mul 411 5759; add 5758 5760; mul 403 5570; mul 411 5762; sub
5761 5763; mul 184 427; mul 403 5573; mul 5765 5766; add 5764 5767; mul 0 5768; add 5751 5769; mul 403 5617; mul 244
5771; mul 244 5772; mul 620 5447; mul 403 5628; mul 418 5775; add 5774 5776; mul 403 5637; mul 418 5778; add 5777
5779; mul 403 5644; mul 411 5781; add 5780 5782; mul 403 5647; mul 411 5784; sub 5783 5785; mul 403 5651; mul 5765
5787; add 5786 5788; mul 0 5789; add 5773 5790; mul 403 5687; mul 244 5792; mul 244 5793; mul 403 5695; mul 418
5795; mul 459 5447; sub 5796 5797; mul 403 5704; mul 418 5799; add 5798 5800; mul 403 5711; mul 411 5802; add 5801
5803; mul 403 5715; mul 411 5805; add 5804 5806; mul 403 5719; mul 5765 5808; add 5807 5809; mul 0 5810; add 5794
5811; mul 233 5749; mul 244 5813; mul 233 5750; add 5814 5815; mul 5 5768; add 5816 5817; mul 427 5759; add 5774
5819; mul 427 5762; sub 5820 5821; mul 403 5585; mul 418 5823; add 5822 5824; mul 403 5592; mul 418 5826; add 5825
5827; mul 184 411; mul 403 5610; mul 5829 5830; add 5828 5831; mul 0 5832; add 5818 5833; mul 233 5771; mul 244
5835; mul 233 5772; add 5836 5837; mul 5 5789; add 5838 5839; mul 427 5781; mul 1396 5447; sub 5841 5842; mul 427
5784; sub 5843 5844; mul 403 5658; mul 418 5846; add 5845 5847; mul 403 5666; mul 418 5849; add 5848 5850; mul 403
5680; mul 5829 5852; add 5851 5853; mul 0 5854; add 5840 5855; mul 233 5792; mul 244 5857; mul 233 5793; add 5858
5859; mul 5 5810; add 5860 5861; mul 1405 5447; mul 427 5802; add 5863 5864; mul 427 5805; add 5865 5866; mul 403
5728; mul 418 5868; add 5867 5869; mul 403 5732; mul 418 5871; add 5870 5872; mul 403 5743; mul 5829 5874; add 5873
5875; mul 0 5876; add 5862 5877; mul 233 5813; mul 5 5832; add 5879 5880; mul 233 5835; mul 5 5854; add 5882 5883;
mul 233 5857; mul 5 5876; add 5885 5886; mul 3358 5749; mul 244 5888; mul 3358 5750; add 5889 5890; mul 9 5768; add
5891 5892; mul 427 5752; sub 5894 5797; mul 427 5756; add 5895 5896; mul 411 5823; add 5897 5898; mul 411 5826; add
5899 5900; mul 184 418; mul 403 5601; mul 5902 5903; add 5901 5904; mul 0 5905; add 5893 5906; mul 3358 5771; mul
244 5908; mul 3358 5772; add 5909 5910; mul 9 5789; add 5911 5912; mul 427 5775; add 5863 5914; mul 427 5778; add
5915 5916; mul 411 5846; add 5917 5918; mul 411 5849; add 5919 5920; mul 403 5675; mul 5902 5922; add 5921 5923; mul
0 5924; add 5913 5925; mul 3358 5792; mul 244 5927; mul 3358 5793; add 5928 5929; mul 9 5810; add 5930 5931; mul 427
5795; mul 2084 5447; sub 5933 5934; mul 427 5799; add 5935 5936; mul 411 5868; add 5937 5938; mul 411 5871; add 5939
5940; mul 403 5737; mul 5902 5942; add 5941 5943; mul 0 5944; add 5932 5945; mul 233 5888; mul 3358 5813; add 5947
5948; mul 5 5905; add 5949 5950; mul 9 5832; add 5951 5952; mul 233 5908; mul 3358 5835; add 5954 5955; mul 5 5924;
add 5956 5957; mul 9 5854; add 5958 5959; mul 233 5927; mul 3358 5857; add 5961 5962; mul 5 5944; add 5963 5964; mul
9 5876; add 5965 5966; mul 3358 5888; mul 9 5905; add 5968 5969; mul 3358 5908; mul 9 5924; add 5971 5972; mul 3358
5927; mul 9 5944; add 5974 5975; input p 191; mul 163 5049; mul 5977 5978; sub 630 5979; mul 163 5131; mul 5977
5981; add 1410 5982; mul 163 5206; mul 5977 5984; sub 2097 5985; mul 57 5978; neg 5987; mul 57 5981; mul 57 5984;
neg 5990; neg 620; neg 213; neg 366; neg 216; neg 369; neg 220; neg 373; le 5509 5508; le 5508 5509; add 5999 6000;
div 144 6001; mul 5999 6002; mul 244 462; mul 6003 6004; neg 6005; mul 244 620; mul 6003 6007; mul 244 459; mul 6003
6009; neg 6010; mul 5521 6004; neg 6012; mul 5521 6007; mul 5521 6009; neg 6015; mul 462 5530; mul 244 6017; neg
6018; mul 620 5530; mul 244 6020; mul 459 5530; mul 244 6022; neg 6023; input p 192; mul 5530 5531; mul 462 6026;
mul 184 5529; div 144 6028; mul 6027 6029; mul 6025 6030; mul 620 6026; mul 6029 6032; mul 6025 6033; neg 6034; mul
459 6026; mul 6029 6036; mul 6025 6037; mul 620 5481; mul 1396 5481; neg 6040; mul 1405 5481; le 144 5468; mul 233
5482; add 244 6044; lt 5509 6045; and 6043 6046; constant -1.0; le 5468 6048; lt 6045 5509; and 6049 6050; or 6047
6051; not 6052; input p 142; mul 233 6054; where 6053 6055; le 144 5471; and 6046 6057; le 5471 6048; and 6050 6059;
or 6058 6060; not 6061; input p 143; mul 233 6063; where 6062 6064; le 144 5475; and 6046 6066; le 5475 6048; and
6050 6068; or 6067 6069; not 6070; input p 144; mul 233 6072; where 6071 6073; le 144 5479; and 6046 6075; le 5479
6048; and 6050 6077; or 6076 6078; not 6079; input p 145; mul 233 6081; where 6080 6082; mul 157 5043; mul 157 5030;
mul 163 5033; add 6085 6086; mul 163 835; add 6087 6088; sub 6084 6089; mul 157 5115; mul 163 5118; add 6091 6092;
mul 163 1581; sub 6093 6094; mul 157 5127; add 6095 6096; mul 157 5201; mul 157 5189; mul 163 5192; add 6099 6100;
mul 163 2266; add 6101 6102; sub 6098 6103; mul 157 5260; mul 157 5251; mul 163 5249; add 6106 6107; mul 163 2807;
add 6108 6109; sub 6105 6110; mul 157 5033; mul 163 5030; sub 6112 6113; mul 157 835; add 6114 6115; mul 163 5043;
add 6116 6117; mul 163 5115; mul 157 5118; sub 6119 6120; mul 157 1581; add 6121 6122; mul 163 5127; add 6123 6124;
mul 157 5192; mul 163 5189; sub 6126 6127; mul 157 2266; add 6128 6129; mul 163 5201; add 6130 6131; mul 157 5249;
mul 163 5251; sub 6133 6134; mul 157 2807; add 6135 6136; mul 163 5260; add 6137 6138; neg 5043; neg 5127; neg 5201;
neg 5260; mul 166 181; mul 815 6144; mul 166 227; mul 798 6146; add 6145 6147; mul 166 211; mul 722 6149; add 6148
6150; mul 166 177; mul 831 6152; add 6151 6153; neg 6154; mul 1546 6146; mul 1561 6144; sub 6156 6157; mul 1419
6149; add 6158 6159; mul 1577 6152; sub 6160 6161; mul 2246 6144; mul 2230 6146; add 6163 6164; mul 2172 6149; add
6165 6166; mul 2262 6152; add 6167 6168; neg 6169; mul 2803 6152; mul 2798 6144; mul 311 6146; add 6172 6173; sub
6171 6174; mul 188 817; mul 188 1563; neg 6177; mul 188 2248; neg 1534; mul 195 781; mul 195 1534; neg 6182; mul 195
2216; mul 208 778; mul 203 6185; neg 6186; mul 208 1529; mul 203 6188; mul 208 2213; mul 203 6190; neg 6191; mul 193
786; neg 6193; mul 193 1530; mul 193 2221; neg 6196; mul 227 722; mul 213 6198; mul 227 1419; mul 213 6200; neg
6201; mul 227 2172; mul 213 6203; mul 216 6198; mul 216 6200; neg 6206; mul 216 6203; mul 220 6198; mul 220 6200;
neg 6210; mul 220 6203; mul 227 794; mul 227 1542; neg 6214; mul 227 2226; mul 157 5015; mul 163 5017; add 6217
6218; mul 163 715; add 6219 6220; mul 157 5027; sub 6221 6222; mul 163 1493; mul 157 5102; mul 163 5104; add 6225
6226; sub 6224 6227; mul 157 5112; sub 6228 6229; mul 157 5175; mul 163 5177; add 6231 6232; mul 163 2165; add 6233
6234; mul 157 5186; sub 6235 6236; mul 157 5293; mul 163 5295; add 6238 6239; mul 163 3052; add 6240 6241; mul 157
5304; sub 6242 6243; mul 157 5017; mul 163 5015; sub 6245 6246; mul 157 715; add 6247 6248; mul 163 5027; add 6249
6250; mul 163 5102; mul 157 5104; sub 6252 6253; mul 157 1493; add 6254 6255; mul 163 5112; add 6256 6257; mul 157
5177; mul 163 5175; sub 6259 6260; mul 157 2165; add 6261 6262; mul 163 5186; add 6263 6264; mul 157 5295; mul 163
5293; sub 6266 6267; mul 157 3052; add 6268 6269; mul 163 5304; add 6270 6271; mul 323 338; mul 695 6273; mul 323
379; mul 678 6275; add 6274 6276; mul 323 364; mul 632 6278; add 6277 6279; mul 323 334; mul 711 6281; add 6280
6282; neg 6283; mul 1447 6275; mul 1469 6273; sub 6285 6286; mul 1412 6278; add 6287 6288; mul 1485 6281; sub 6289
6290; mul 2145 6273; mul 2129 6275; add 6292 6293; mul 2099 6278; add 6294 6295; mul 2161 6281; add 6296 6297; neg
6298; mul 3048 6281; mul 3043 6273; mul 397 6275; add 6301 6302; sub 6300 6303; mul 344 697; mul 344 1471; neg 6306;
mul 344 2147; neg 1435; mul 348 661; mul 348 1435; neg 6311; mul 348 2115; mul 361 658; mul 356 6314; neg 6315; mul
361 1430; mul 356 6317; mul 361 2112; mul 356 6319; neg 6320; mul 346 666; neg 6322; mul 346 1431; mul 346 2120; neg
6325; mul 379 632; mul 366 6327; mul 379 1412; mul 366 6329; neg 6330; mul 379 2099; mul 366 6332; mul 369 6327; mul
369 6329; neg 6335; mul 369 6332; mul 373 6327; mul 373 6329; neg 6339; mul 373 6332; mul 379 674; mul 379 1443; neg
6343; mul 379 2125; mul 620 5482; sub 6346 462; mul 5468 6347; mul 1396 5482; sub 620 6349; mul 5468 6350; mul 1405
5482; sub 6352 459; mul 5468 6353; mul 5471 6347; mul 5471 6350; mul 5471 6353; mul 5475 6347; mul 5475 6350; mul
5475 6353; mul 5479 6347; mul 5479 6350; mul 5479 6353; mul 6045 6054; mul 6054 6364; neg 6365; where 6053 6366; mul
6045 6063; mul 6063 6368; neg 6369; where 6062 6370; mul 6045 6072; mul 6072 6372; neg 6373; where 6071 6374; mul
6045 6081; mul 6081 6376; neg 6377; where 6080 6378; mul 462 5537; neg 6380; mul 620 5537; mul 459 5537; neg 6383;
mul 462 5541; neg 6385; mul 620 5541; mul 459 5541; neg 6388; mul 1 1390; neg 6390; mul 1 2078; mul 1 2766; neg
6393; store by_k 83 1392; store by_k 249 2080; store by_k 415 2768; store by_k 498 3019; store by_k 581 3270; store
by_k 664 3019; store by_k 747 3270; store by_k 830 3019; store by_k 913 3270; store by_k 84 3331; store by_k 250
3343; store by_k 416 3355; store by_k 85 3373; store by_k 251 3383; store by_k 417 3393; store by_k 86 3523; store
by_k 252 3631; store by_k 418 3739; store by_k 87 3905; store by_k 253 4033; store by_k 419 4161; store by_k 88
4289; store by_k 254 4393; store by_k 420 4497; store by_k 503 4580; store by_k 586 4663; store by_k 669 4580; store
by_k 752 4663; store by_k 835 4580; store by_k 918 4663; store by_k 89 4740; store by_k 255 4814; store by_k 421
4888; store by_k 90 4897; store by_k 256 4906; store by_k 422 4915; store by_k 505 4918; store by_k 588 4921; store
by_k 671 4918; store by_k 754 4921; store by_k 837 4918; store by_k 920 4921; store by_k 91 4930; store by_k 257
4939; store by_k 423 4948; store by_k 506 4951; store by_k 589 4954; store by_k 672 4951; store by_k 755 4954; store
by_k 838 4951; store by_k 921 4954; store by_k 92 4955; store by_k 258 4956; store by_k 424 4957; store by_k 507
4958; store by_k 590 4959; store by_k 673 4958; store by_k 756 4959; store by_k 839 4958; store by_k 922 4959; store
by_k 93 4962; store by_k 259 4965; store by_k 425 4968; store by_k 508 4971; store by_k 591 4974; store by_k 674
4971; store by_k 757 4974; store by_k 840 4971; store by_k 923 4974; store by_k 94 4975; store by_k 260 4976; store
by_k 426 4977; store by_k 509 4978; store by_k 592 4979; store by_k 675 4978; store by_k 758 4979; store by_k 841
4978; store by_k 924 4979; store by_k 95 4982; store by_k 261 4985; store by_k 427 4988; store by_k 510 4991; store
by_k 593 4994; store by_k 676 4991; store by_k 759 4994; store by_k 842 4991; store by_k 925 4994; store by_k 96
4997; store by_k 262 5000; store by_k 428 5003; store by_k 511 5006; store by_k 594 5009; store by_k 677 5006; store
by_k 760 5009; store by_k 843 5006; store by_k 926 5009; store by_k 97 5010; store by_k 263 5011; store by_k 429
5012; store by_k 512 5013; store by_k 595 5014; store by_k 678 5013; store by_k 761 5014; store by_k 844 5013; store
by_k 927 5014; store by_k 98 5100; store by_k 264 5174; store by_k 430 5248; store by_k 513 5292; store by_k 596
5336; store by_k 679 5292; store by_k 762 5336; store by_k 845 5292; store by_k 928 5336; store by_k 99 5339; store
by_k 265 5341; store by_k 431 5344; store by_k 100 5353; store by_k 266 5362; store by_k 432 5371; store by_k 101
5377; store by_k 267 5383; store by_k 433 5389; store by_k 102 5395; store by_k 268 5401; store by_k 434 5407; store
by_k 103 5409; store by_k 269 5412; store by_k 435 5414; store by_k 104 5612; store by_k 270 5682; store by_k 436
5745; store by_k 105 5746; store by_k 271 5747; store by_k 437 5748; store by_k 106 5610; store by_k 272 5680; store
by_k 438 5743; store by_k 107 5601; store by_k 273 5675; store by_k 439 5737; store by_k 108 5770; store by_k 274
5791; store by_k 440 5812; store by_k 109 5834; store by_k 275 5856; store by_k 441 5878; store by_k 110 5881; store
by_k 276 5884; store by_k 442 5887; store by_k 111 5907; store by_k 277 5926; store by_k 443 5946; store by_k 112
5953; store by_k 278 5960; store by_k 444 5967; store by_k 113 5970; store by_k 279 5973; store by_k 445 5976; store
by_k 114 5980; store by_k 280 5983; store by_k 446 5986; store by_k 115 5988; store by_k 281 5989; store by_k 447
5991; store by_k 116 462; store by_k 282 5992; store by_k 448 459; store by_k 532 5993; store by_k 615 5994; store
by_k 699 5995; store by_k 782 5996; store by_k 866 5997; store by_k 949 5998; store by_k 120 6006; store by_k 286
6008; store by_k 452 6011; store by_k 121 6013; store by_k 287 6014; store by_k 453 6016; store by_k 122 6019; store
by_k 288 6021; store by_k 454 6024; store by_k 123 6031; store by_k 289 6035; store by_k 455 6038; store by_k 124
6039; store by_k 290 6041; store by_k 456 6042; store by_k 1203 6056; store by_k 1286 6065; store by_k 1369 6074;
store by_k 1452 6083; store by_k 125 6090; store by_k 291 6097; store by_k 457 6104; store by_k 540 6111; store by_k
706 6111; store by_k 872 6111; store by_k 126 6118; store by_k 292 6125; store by_k 458 6132; store by_k 541 6139;
store by_k 707 6139; store by_k 873 6139; store by_k 127 6140; store by_k 293 6141; store by_k 459 6142; store by_k
542 6143; store by_k 708 6143; store by_k 874 6143; store by_k 128 835; store by_k 294 1581; store by_k 460 2266;
store by_k 543 2807; store by_k 709 2807; store by_k 875 2807; store by_k 129 6155; store by_k 295 6162; store by_k
461 6170; store by_k 544 6175; store by_k 710 6175; store by_k 876 6175; store by_k 130 6176; store by_k 296 6178;
store by_k 462 6179; store by_k 131 781; store by_k 297 6180; store by_k 463 2216; store by_k 132 6181; store by_k
298 6183; store by_k 464 6184; store by_k 133 6187; store by_k 299 6189; store by_k 465 6192; store by_k 134 6194;
store by_k 300 6195; store by_k 466 6197; store by_k 135 6199; store by_k 301 6202; store by_k 467 6204; store by_k
136 6205; store by_k 302 6207; store by_k 468 6208; store by_k 137 6209; store by_k 303 6211; store by_k 469 6212;
store by_k 138 6213; store by_k 304 6215; store by_k 470 6216; store by_k 139 6223; store by_k 305 6230; store by_k
471 6237; store by_k 637 6244; store by_k 803 6244; store by_k 969 6244; store by_k 140 6251; store by_k 306 6258;
store by_k 472 6265; store by_k 638 6272; store by_k 804 6272; store by_k 970 6272; store by_k 141 5027; store by_k
307 5112; store by_k 473 5186; store by_k 639 5304; store by_k 805 5304; store by_k 971 5304; store by_k 142 715;
store by_k 308 1493; store by_k 474 2165; store by_k 640 3052; store by_k 806 3052; store by_k 972 3052; store by_k
143 6284; store by_k 309 6291; store by_k 475 6299; store by_k 641 6304; store by_k 807 6304; store by_k 973 6304;
store by_k 144 6305; store by_k 310 6307; store by_k 476 6308; store by_k 145 661; store by_k 311 6309; store by_k
477 2115; store by_k 146 6310; store by_k 312 6312; store by_k 478 6313; store by_k 147 6316; store by_k 313 6318;
store by_k 479 6321; store by_k 148 6323; store by_k 314 6324; store by_k 480 6326; store by_k 149 6328; store by_k
315 6331; store by_k 481 6333; store by_k 150 6334; store by_k 316 6336; store by_k 482 6337; store by_k 151 6338;
store by_k 317 6340; store by_k 483 6341; store by_k 152 6342; store by_k 318 6344; store by_k 484 6345; store by_k
153 6348; store by_k 319 6351; store by_k 485 6354; store by_k 154 6355; store by_k 320 6356; store by_k 486 6357;
store by_k 155 6358; store by_k 321 6359; store by_k 487 6360; store by_k 156 6361; store by_k 322 6362; store by_k
488 6363; store by_k 1236 6367; store by_k 1320 6371; store by_k 1404 6375; store by_k 1488 6379; store by_k 161
6381; store by_k 327 6382; store by_k 493 6384; store by_k 162 6386; store by_k 328 6387; store by_k 494 6389; store
by_k 1076 5537; store by_k 1160 5541; store by_k 165 6391; store by_k 331 6392; store by_k 497 6394
    """,
)
