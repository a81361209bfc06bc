"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from pipeline.codegen.graph import Graph

PREPARE = Graph(
    {'k': 108},
    {'p': 226},
    """
input k 46; input k 47; constant 1.0; input k 9; sub 3 2; input k 44; input k 56; input k 50; input k 51; input k
53; input k 48; input k 52; input k 54; input k 49; input k 45; input k 107; input k 0; div 2 16; mul 15 17;
constant 0.5; constant -2.0; input k 2; mul 20 21; input k 62; input k 1; constant -6.000000000000002; constant
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
constant 3.0; input k 25; mul 164 165; input k 26; constant 2.0; mul 167 168; input k 27; mul 168 170; input k 28;
input k 29; input k 30; constant 4.0; input k 10; mul 175 176; input k 11; mul 164 178; input k 12; mul 164 180;
input k 13; mul 168 182; input k 14; mul 168 184; input k 15; mul 168 186; input k 16; input k 17; input k 18; input
k 19; constant -6.0; input k 55; input k 72; input k 67; input k 69; input k 68; input k 70; sub 198 16; input k 35;
mul 175 200; input k 36; mul 164 202; input k 37; mul 164 204; input k 38; mul 168 206; input k 39; mul 168 208;
input k 40; input k 41; mul 164 210; mul 168 211; input k 42; mul 175 214; input k 43; mul 164 216; input k 71; div
2 218; input k 73; input k 74; input k 75; input k 76; mul 19 223; constant 0.7142857142857143; sub 223 225; mul 224
226; input k 77; input k 78; input k 79; input k 61; mul 19 231; sub 231 225; mul 232 233; input k 80; input k 86;
input k 82; input k 81; input k 83; input k 84; sub 240 16; input k 85; div 2 242; input k 87; input k 88; input k
89; input k 90; mul 19 247; sub 247 225; mul 248 249; input k 91; input k 92; input k 93; input k 94; input k 57;
input k 95; input k 96; input k 97; input k 98; input k 63; input k 64; input k 65; mul 262 262; input k 103; input
k 104; mul 3 168; mul 168 172; input k 31; mul 164 268; input k 32; mul 168 270; input k 33; mul 164 188; mul 168
189; input k 20; mul 175 275; input k 21; mul 164 277; input k 22; mul 168 279; input k 23; mul 6 193; input k 66;
constant 0.8000000000000002; constant 2.400000000000001; mul 30 285; add 284 286; constant 0.01904761904761903; mul
35 288; add 287 289; constant -1.3714285714285723; mul 42 291; constant 1.3714285714285714; mul 29 293; constant
0.007256235827664418; mul 34 295; add 294 296; constant -4.799999999999999; mul 42 298; constant 1.3714285714285692;
mul 29 300; constant -0.05714285714285729; mul 34 302; add 301 303; constant -7.199999999999996; mul 42 305;
constant 7.199999999999994; mul 29 307; constant 0.2190476190476189; mul 34 309; add 308 310; constant
-45.25714285714286; mul 29 312; constant -0.11428571428571327; mul 34 314; add 313 315; constant
-28.800000000000004; mul 42 317; mul 168 174; mul 168 272; input k 34; mul 164 321; mul 168 190; mul 164 191; mul
164 281; input k 24; mul 175 326; constant 0.8; mul 21 328; input k 58; input k 59; input k 60; input k 105; input k
106; input k 99; div 2 335; input k 100; div 2 337; input k 101; div 2 339; input k 102; div 2 341; mul 17 38; mul
37 343; mul 17 67; mul 118 343; mul 17 37; add 264 265; mul 104 343; mul 17 113; mul 192 343; add 350 351; mul 21
352; mul 17 192; mul 175 343; add 354 355; mul 21 356; mul 38 357; add 353 358; mul 17 359; mul 39 357; mul 40 357;
mul 37 39; mul 39 118; mul 39 104; mul 39 192; mul 21 366; mul 39 175; mul 21 368; mul 38 369; add 367 370; mul 17
371; mul 39 369; mul 40 369; mul 283 336; mul 283 338; mul 283 340; mul 283 342; mul 37 40; mul 40 118; mul 40 104;
mul 40 175; mul 21 382; mul 39 383; mul 40 192; mul 21 385; mul 38 383; add 386 387; mul 17 388; mul 40 383; add 329
390; neg 330; neg 331; neg 332; neg 333; neg 334; mul 256 283; mul 257 283; mul 258 283; mul 259 283; mul 17 18; mul
27 168; mul 168 262; store p 0 0; store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p 6 7;
store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p 11 12; store p 12 13; store p 13 14; store p 14 18;
store p 15 22; store p 16 23; store p 17 17; store p 18 24; store p 19 37; store p 20 38; store p 21 39; store p 22
40; store p 23 43; store p 24 48; store p 25 50; store p 26 55; store p 27 60; store p 28 67; store p 29 69; store p
30 74; store p 31 76; store p 32 81; store p 33 86; store p 34 91; store p 35 96; store p 36 102; store p 37 104;
store p 38 106; store p 39 111; store p 40 118; store p 41 120; store p 42 125; store p 43 129; store p 44 134;
store p 45 139; store p 46 141; store p 47 146; store p 48 151; store p 49 153; store p 50 158; store p 51 163;
store p 52 166; store p 53 169; store p 54 171; store p 55 172; store p 56 173; store p 57 174; store p 58 177;
store p 59 179; store p 60 181; store p 61 183; store p 62 185; store p 63 187; store p 64 188; store p 65 189;
store p 66 190; store p 67 191; store p 68 21; store p 69 201; store p 70 203; store p 71 205; store p 72 207; store
p 73 209; store p 74 210; store p 75 211; store p 76 193; store p 77 199; store p 78 16; store p 79 202; store p 80
208; store p 81 212; store p 82 213; store p 83 215; store p 84 217; store p 85 204; store p 86 216; store p 87 197;
store p 88 195; store p 89 219; store p 90 196; store p 91 194; store p 92 220; store p 93 221; store p 94 222;
store p 95 223; store p 96 227; store p 97 228; store p 98 229; store p 99 230; store p 100 231; store p 101 234;
store p 102 235; store p 103 241; store p 104 237; store p 105 238; store p 106 243; store p 107 239; store p 108
236; store p 109 244; store p 110 245; store p 111 246; store p 112 247; store p 113 250; store p 114 251; store p
115 252; store p 116 253; store p 117 254; store p 118 255; store p 119 256; store p 120 257; store p 121 258; store
p 122 259; store p 123 260; store p 124 261; store p 125 263; store p 126 264; store p 127 265; store p 128 266;
store p 129 167; store p 130 267; store p 131 269; store p 132 271; store p 133 272; store p 134 178; store p 135
184; store p 136 273; store p 137 274; store p 138 276; store p 139 278; store p 140 280; store p 141 281; store p
142 282; store p 143 283; store p 144 290; store p 145 292; store p 146 297; store p 147 299; store p 148 304; store
p 149 306; store p 150 311; store p 151 316; store p 152 318; store p 153 170; store p 154 319; store p 155 270;
store p 156 320; store p 157 322; store p 158 180; store p 159 323; store p 160 324; store p 161 277; store p 162
325; store p 163 327; store p 164 165; store p 165 268; store p 166 321; store p 167 329; store p 168 330; store p
169 331; store p 170 332; store p 171 333; store p 172 334; store p 173 336; store p 174 338; store p 175 340; store
p 176 342; store p 177 344; store p 178 343; store p 179 345; store p 180 346; store p 181 347; store p 182 348;
store p 183 349; store p 184 360; store p 185 361; store p 186 362; store p 187 363; store p 188 364; store p 189
365; store p 190 372; store p 191 373; store p 192 374; store p 193 375; store p 194 376; store p 195 377; store p
196 378; store p 197 379; store p 198 380; store p 199 381; store p 200 384; store p 201 389; store p 202 391; store
p 203 392; store p 204 393; store p 205 394; store p 206 395; store p 207 396; store p 208 397; store p 209 398;
store p 210 399; store p 211 400; store p 212 401; store p 213 28; store p 214 27; store p 215 99; store p 216 29;
store p 217 402; store p 218 34; store p 219 232; store p 220 233; store p 221 403; store p 222 224; store p 223
226; store p 224 248; store p 225 249
    """,
)

JACOBIAN = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'c_q': 13, 'p': 226},
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
520; input p 94; mul 93 522; input p 95; input p 96; mul 512 525; add 524 526; mul 512 527; add 2 528; mul 523 529;
sub 521 530; mul 485 531; input p 97; input x 6; mul 533 534; input p 98; input x 8; mul 536 537; add 535 538; input
p 99; input x 10; mul 540 541; add 539 542; constant -0.5; mul 498 544; mul 498 545; mul 498 546; mul 485 547; input
p 100; input p 101; mul 512 550; add 549 551; mul 512 552; add 2 553; mul 548 554; mul 543 555; add 532 556; input p
102; mul 555 558; mul 555 559; sub 480 483; mul 491 561; add 486 489; mul 484 563; sub 562 564; mul 500 565; mul 17
566; mul 130 567; mul 491 500; mul 0 569; sub 568 570; mul 0 431; constant 3.3333333333333335; add 294 298; mul 573
574; sub 2 575; mul 461 576; mul 440 577; add 37 578; mul 130 579; add 572 580; constant 1.25; add 314 318; mul 582
583; sub 2 584; mul 472 585; mul 440 586; add 53 587; mul 395 588; add 581 589; mul 501 590; add 571 591; mul 560
592; add 557 593; mul 501 594; input p 103; add 477 596; input p 104; mul 24 598; add 597 599; input p 105; mul 38
601; add 600 602; input p 106; mul 38 598; mul 24 601; input p 107; sub 606 607; sub 605 608; sub 609 29; mul 610
610; mul 603 603; add 611 612; sqrt 613; mul 604 614; sqrt 615; div 2 616; mul 617 617; mul 604 618; mul 603 619;
input p 108; mul 503 615; mul 503 618; mul 618 623; sub 622 624; mul 621 625; sub 615 511; max 510 627; min 509 628;
input p 109; input p 110; mul 629 631; add 630 632; mul 629 633; add 2 634; mul 626 635; input p 111; mul 97 637;
input p 112; input p 113; mul 627 640; add 639 641; mul 627 642; add 2 643; mul 638 644; sub 636 645; mul 604 646;
input p 114; input x 7; mul 648 649; input p 115; input x 9; mul 651 652; add 650 653; input p 116; input x 11; mul
655 656; add 654 657; mul 544 617; mul 617 659; mul 617 660; mul 604 661; mul 550 627; add 549 663; mul 627 664; add
2 665; mul 662 666; mul 658 667; add 647 668; input p 117; mul 667 670; mul 667 671; add 599 602; mul 610 673; sub
606 605; mul 603 675; add 674 676; mul 619 677; mul 17 678; mul 130 679; mul 610 619; mul 0 681; sub 680 682; mul
590 620; add 683 684; mul 672 685; add 669 686; mul 620 687; add 595 688; sub 432 689; mul 431 690; sub 409 691; mul
569 594; mul 681 687; add 693 694; sub 692 695; sub 143 696; input p 118; input p 119; input z 0; mul 699 700; input
p 120; input z 1; mul 702 703; add 701 704; input p 121; input z 2; mul 706 707; add 705 708; input p 122; input z
3; mul 710 711; add 709 712; sub 698 713; input p 123; abs 0; mul 715 716; mul 0 717; input p 124; mul 0 719; mul 0
0; input p 125; add 721 722; sqrt 723; div 2 724; mul 720 725; add 718 726; sub 714 727; add 697 728; input p 126;
input x 12; sub 29 731; mul 730 732; input p 127; input x 13; sub 29 735; mul 734 736; add 733 737; sub 729 738; mul
0 62; mul 28 130; add 740 741; mul 47 395; add 742 743; mul 0 744; mul 0 28; mul 31 130; add 746 747; mul 34 395;
add 748 749; mul 130 750; add 745 751; mul 0 47; mul 34 130; add 753 754; mul 51 395; add 755 756; mul 395 757; add
752 758; mul 17 130; mul 130 760; mul 23 761; input p 128; mul 9 763; mul 9 764; mul 8 16; mul 10 766; mul 766 767;
add 765 768; mul 3 769; mul 38 770; sub 25 771; mul 762 772; add 759 773; mul 67 774; mul 24 770; add 39 776; mul
762 777; sub 775 778; mul 22 779; sub 739 780; mul 90 781; mul 81 89; mul 150 265; input p 129; mul 285 785; input p
130; mul 304 787; add 786 788; mul 324 331; add 789 790; input p 131; mul 328 792; add 791 793; input p 132; mul 332
795; add 794 796; input p 133; mul 336 798; add 797 799; mul 339 800; input p 134; mul 342 802; mul 345 352; add 803
804; input p 135; mul 349 806; add 805 807; input p 136; mul 353 809; add 808 810; input p 137; mul 357 812; add 811
813; mul 361 372; add 814 815; input p 138; mul 365 817; add 816 818; input p 139; mul 369 820; add 819 821; input p
140; mul 373 823; add 822 824; input p 141; mul 339 826; add 825 827; add 801 828; mul 576 829; add 784 830; mul 145
831; mul 579 690; sub 832 833; mul 150 405; add 834 835; mul 567 594; mul 679 687; add 837 838; add 836 839; sub 134
840; input p 142; mul 38 842; mul 17 843; add 841 844; input p 143; mul 713 846; sub 845 847; mul 41 774; mul 26
778; sub 849 850; mul 22 851; mul 19 770; mul 761 853; sub 852 854; sub 848 855; mul 783 856; sub 782 857; mul 86
89; input p 144; mul 35 860; input p 145; mul 214 862; add 861 863; input p 146; mul 218 865; add 864 866; mul 155
210; add 867 868; input p 147; mul 158 870; add 869 871; input p 148; mul 162 873; add 872 874; input p 149; mul 166
876; add 875 877; mul 170 227; add 878 879; input p 150; mul 174 881; add 880 882; mul 157 189; add 883 884; input p
151; mul 193 886; add 885 887; mul 169 197; add 888 889; input p 152; mul 201 891; add 890 892; mul 184 258; add 893
894; mul 202 257; add 895 896; mul 153 265; add 897 898; input p 153; mul 285 900; mul 304 331; add 901 902; input p
154; mul 324 904; add 903 905; input p 155; mul 328 907; add 906 908; input p 156; mul 332 910; add 909 911; input p
157; mul 336 913; add 912 914; mul 339 915; input p 158; mul 342 917; mul 345 806; add 918 919; mul 349 360; add 920
921; mul 353 368; add 922 923; input p 159; mul 357 925; add 924 926; input p 160; mul 361 928; add 927 929; input p
161; mul 365 931; add 930 932; mul 369 823; add 933 934; input p 162; mul 373 936; add 935 937; input p 163; mul 339
939; add 938 940; add 916 941; constant 3.0; mul 336 943; input p 164; mul 342 945; mul 345 785; add 946 947; mul
349 900; add 948 949; mul 327 353; add 950 951; mul 331 357; add 952 953; mul 335 361; add 954 955; input p 165; mul
365 957; add 956 958; mul 369 907; add 959 960; mul 373 798; add 961 962; input p 166; mul 339 964; add 963 965; mul
944 966; add 942 967; mul 585 968; add 899 969; mul 145 970; mul 588 690; sub 971 972; input p 167; mul 395 974; mul
153 405; add 975 976; add 973 977; mul 53 774; mul 22 979; add 978 980; mul 859 981; sub 858 982; mul 56 70; mul 79
79; sub 984 985; mul 89 986; mul 856 987; mul 781 783; sub 988 989; mul 59 70; mul 76 79; sub 991 992; mul 89 993;
mul 981 994; add 990 995; mul 781 859; mul 856 994; sub 997 998; mul 45 70; mul 76 76; sub 1000 1001; mul 89 1002;
mul 981 1003; sub 999 1004; mul 555 592; input p 168; mul 534 1007; sub 1006 1008; mul 667 685; mul 649 1007; sub
1010 1011; input p 169; mul 537 1013; sub 1006 1014; mul 652 1013; sub 1010 1016; input p 170; mul 541 1018; sub
1006 1019; mul 656 1018; sub 1010 1021; input p 171; mul 732 1023; input p 172; mul 736 1025; le 2 700; mul 130 846;
add 0 1028; lt 140 1029; and 1027 1030; constant -1.0; le 700 1032; lt 1029 140; and 1033 1034; or 1031 1035; not
1036; input p 173; mul 1029 1038; where 1037 1039; le 2 703; and 1030 1041; le 703 1032; and 1034 1043; or 1042
1044; not 1045; input p 174; mul 1029 1047; where 1046 1048; le 2 707; and 1030 1050; le 707 1032; and 1034 1052; or
1051 1053; not 1054; input p 175; mul 1029 1056; where 1055 1057; le 2 711; and 1030 1059; le 711 1032; and 1034
1061; or 1060 1062; not 1063; input p 176; mul 1029 1065; where 1064 1066; mul 41 503; mul 28 1068; mul 22 1069; mul
56 1070; mul 53 503; mul 47 1072; mul 22 1073; mul 45 1074; add 1071 1075; mul 28 53; mul 41 47; add 1077 1078; mul
22 1079; mul 59 1080; add 1081 1081; sub 1076 1082; mul 89 1083; mul 89 90; mul 67 503; mul 62 1086; mul 22 1087;
mul 61 1088; mul 70 1083; add 1089 1090; mul 41 62; mul 28 67; add 1092 1093; mul 22 1094; mul 81 1095; mul 56 1095;
mul 76 1074; add 1097 1098; mul 79 1080; mul 47 67; mul 53 62; add 1101 1102; mul 22 1103; mul 59 1104; add 1100
1105; sub 1099 1106; mul 76 1107; add 1096 1108; sub 1091 1109; mul 86 1104; mul 59 1095; mul 76 1080; add 1112
1113; mul 79 1070; mul 45 1104; add 1115 1116; sub 1114 1117; mul 79 1118; add 1111 1119; add 1110 1120; mul 1085
1121; sub 1084 1122; mul 781 1123; mul 100 106; mul 102 1125; mul 100 114; sub 1126 1127; mul 100 118; mul 100 1129;
sub 1128 1130; input p 177; input p 178; mul 35 1133; mul 157 1134; add 1132 1135; mul 35 1134; mul 161 1137; add
1136 1138; mul 155 503; mul 1133 1140; mul 165 1141; add 1139 1142; mul 35 1141; mul 169 1144; add 1143 1145; mul
155 1141; mul 166 1133; add 1147 1148; mul 173 1149; add 1146 1150; input p 179; add 1151 1152; mul 35 144; mul 180
1154; add 1153 1155; mul 35 1154; mul 184 1157; add 1156 1158; mul 144 155; mul 148 1133; add 1160 1161; mul 188
1162; add 1159 1163; mul 35 1162; mul 192 1165; add 1164 1166; mul 155 1162; mul 189 1133; add 1168 1169; mul 196
1170; add 1167 1171; mul 148 503; mul 144 1173; mul 155 1174; mul 201 1133; add 1175 1176; mul 200 1177; add 1172
1178; mul 148 1174; mul 144 201; add 1180 1181; mul 205 1182; add 1179 1183; input p 180; mul 224 1134; add 1185
1186; mul 227 1137; add 1187 1188; mul 230 1141; add 1189 1190; mul 233 1144; add 1191 1192; mul 236 1149; add 1193
1194; input p 181; add 1195 1196; mul 157 1154; add 1197 1198; mul 161 1157; add 1199 1200; mul 245 1162; add 1201
1202; mul 248 1165; add 1203 1204; mul 251 1170; add 1205 1206; mul 254 1174; add 1207 1208; mul 35 1174; mul 257
1210; add 1209 1211; mul 196 1177; add 1212 1213; mul 263 1182; add 1214 1215; mul 147 1216; add 1184 1217; mul 284
503; le 271 269; le 269 271; add 1220 1221; div 2 1222; mul 1220 1223; le 270 148; le 148 270; add 1225 1226; div 2
1227; mul 1225 1228; mul 144 1229; mul 1224 1230; constant 2.857142857142857; mul 275 503; le 140 274; le 274 140;
add 1234 1235; div 2 1236; mul 1234 1237; mul 1231 1238; mul 1233 1239; mul 279 503; le 140 278; le 278 140; add
1242 1243; div 2 1244; mul 1242 1245; mul 1231 1246; mul 1241 1247; add 1240 1248; mul 1232 1249; sub 1231 1250; mul
1219 1251; mul 268 1252; mul 303 1251; mul 287 1254; add 1253 1255; mul 323 1251; mul 307 1257; add 1256 1258; mul
339 1259; mul 284 1252; mul 285 1251; add 1261 1262; mul 341 1263; mul 303 1252; mul 344 1265; add 1264 1266; mul
323 1252; mul 348 1268; add 1267 1269; mul 303 1254; mul 352 1271; add 1270 1272; mul 323 1254; mul 356 1274; add
1273 1275; mul 323 1257; mul 360 1277; add 1276 1278; add 1260 1279; mul 383 1280; sub 1239 1247; mul 380 1282; mul
379 1283; sub 1281 1284; add 1218 1285; mul 145 1286; mul 144 1287; mul 410 1263; mul 412 1265; add 1289 1290; mul
415 1268; add 1291 1292; mul 418 1271; add 1293 1294; mul 421 1274; add 1295 1296; mul 383 1297; mul 429 1283; sub
1298 1299; add 62 1300; mul 690 1301; mul 484 503; add 63 67; add 64 1304; add 66 1305; mul 104 1306; mul 429 1251;
mul 284 1297; add 1308 1309; mul 443 1263; mul 418 1265; add 1311 1312; mul 447 1268; add 1313 1314; mul 450 1271;
add 1315 1316; mul 453 1274; add 1317 1318; mul 303 1319; add 1310 1320; mul 464 1263; mul 447 1265; add 1322 1323;
mul 427 1271; add 1324 1325; mul 323 1326; add 1321 1327; mul 441 1328; mul 440 1329; add 1307 1330; mul 1303 1331;
mul 491 503; sub 1332 1333; mul 495 503; div 2 1335; mul 1334 1336; mul 485 1337; mul 503 1338; mul 498 503; mul 497
503; div 2 1341; mul 1338 1342; mul 499 1343; mul 1340 1344; neg 1345; mul 503 1346; mul 499 1347; mul 505 1345; sub
1348 1349; sub 1339 1350; mul 502 1351; mul 520 1352; le 513 509; le 509 513; add 1354 1355; div 2 1356; mul 1354
1357; le 510 512; le 512 510; add 1359 1360; div 2 1361; mul 1359 1362; mul 1338 1363; mul 1358 1364; mul 516 1365;
mul 514 1366; mul 518 1365; add 1367 1368; mul 508 1369; add 1353 1370; mul 525 1338; mul 512 1372; mul 527 1338;
add 1373 1374; mul 523 1375; sub 1371 1376; mul 485 1377; mul 550 1338; mul 512 1379; mul 552 1338; add 1380 1381;
mul 548 1382; mul 546 1343; mul 498 1384; mul 547 1343; add 1385 1386; mul 498 1387; mul 498 547; mul 1343 1389; add
1388 1390; mul 485 1391; mul 554 1392; sub 1383 1393; mul 543 1394; add 1378 1395; mul 558 1394; mul 555 1397; mul
559 1394; add 1398 1399; mul 592 1400; mul 485 1345; mul 491 1402; add 500 1403; mul 0 1404; mul 563 1331; add 561
1406; mul 500 1407; mul 565 1402; add 1408 1409; mul 17 1410; mul 130 1411; sub 1405 1412; mul 500 1331; mul 484
1402; sub 1414 1415; mul 590 1416; mul 0 1301; mul 576 1319; mul 440 1419; add 28 1420; mul 130 1421; add 1418 1422;
mul 585 1326; mul 440 1424; add 47 1425; mul 395 1426; add 1423 1427; mul 501 1428; add 1417 1429; add 1413 1430;
mul 560 1431; add 1401 1432; add 1396 1433; mul 501 1434; mul 594 1416; add 1435 1436; mul 503 603; mul 1331 1438;
mul 503 610; sub 1439 1440; mul 503 614; div 2 1442; mul 1441 1443; mul 604 1444; mul 503 1445; mul 503 617; mul 503
616; div 2 1448; mul 1445 1449; mul 618 1450; mul 1447 1451; neg 1452; mul 503 1453; mul 618 1454; mul 623 1452; sub
1455 1456; sub 1446 1457; mul 621 1458; mul 635 1459; le 628 509; le 509 628; add 1461 1462; div 2 1463; mul 1461
1464; le 510 627; le 627 510; add 1466 1467; div 2 1468; mul 1466 1469; mul 1445 1470; mul 1465 1471; mul 631 1472;
mul 629 1473; mul 633 1472; add 1474 1475; mul 626 1476; add 1460 1477; mul 640 1445; mul 627 1479; mul 642 1445;
add 1480 1481; mul 638 1482; sub 1478 1483; mul 604 1484; mul 550 1445; mul 627 1486; mul 664 1445; add 1487 1488;
mul 662 1489; mul 660 1450; mul 617 1491; mul 661 1450; add 1492 1493; mul 617 1494; mul 617 661; mul 1450 1496; add
1495 1497; mul 604 1498; mul 666 1499; sub 1490 1500; mul 658 1501; add 1485 1502; mul 670 1501; mul 667 1504; mul
671 1501; add 1505 1506; mul 685 1507; mul 675 1331; sub 1509 673; mul 619 1510; mul 604 1452; mul 677 1512; sub
1511 1513; mul 17 1514; mul 130 1515; mul 610 1512; add 619 1517; mul 0 1518; add 1516 1519; mul 619 1331; mul 603
1512; sub 1521 1522; mul 590 1523; mul 620 1428; add 1524 1525; add 1520 1526; mul 672 1527; add 1508 1528; add 1503
1529; mul 620 1530; mul 687 1523; add 1531 1532; add 1437 1533; mul 431 1534; sub 1302 1535; sub 1288 1536; mul 569
1434; mul 594 1404; sub 1538 1539; mul 681 1530; mul 687 1518; sub 1541 1542; add 1540 1543; sub 1537 1544; sub 1131
1545; input p 182; sub 1546 1547; mul 62 774; mul 22 1549; sub 1548 1550; mul 90 1551; add 1124 1552; mul 89 1107;
mul 89 783; mul 1121 1555; sub 1554 1556; mul 856 1557; mul 150 1216; mul 785 1252; mul 787 1254; add 1560 1561; mul
331 1257; add 1562 1563; mul 339 1564; mul 802 1263; mul 352 1265; add 1566 1567; mul 806 1268; add 1568 1569; mul
809 1271; add 1570 1571; mul 812 1274; add 1572 1573; mul 372 1277; add 1574 1575; add 1565 1576; mul 576 1577; add
1559 1578; mul 145 1579; mul 690 1421; mul 579 1534; sub 1581 1582; sub 1580 1583; mul 567 1434; mul 594 1411; sub
1585 1586; mul 679 1530; mul 687 1515; add 1588 1589; add 1587 1590; add 1584 1591; sub 1129 1592; mul 28 774; mul
22 1594; sub 1593 1595; mul 783 1596; add 1558 1597; sub 1553 1598; mul 89 1118; mul 89 859; mul 1121 1601; sub 1600
1602; mul 981 1603; input p 183; mul 870 1134; add 1605 1606; mul 873 1137; add 1607 1608; mul 876 1141; add 1609
1610; mul 227 1144; add 1611 1612; mul 881 1149; add 1613 1614; mul 157 1162; add 1615 1616; mul 886 1165; add 1617
1618; mul 169 1170; add 1619 1620; mul 891 1174; add 1621 1622; mul 184 1210; add 1623 1624; mul 257 1177; add 1625
1626; mul 153 1216; add 1627 1628; mul 900 1252; mul 331 1254; add 1630 1631; mul 904 1257; add 1632 1633; mul 339
1634; mul 917 1263; mul 806 1265; add 1636 1637; mul 360 1268; add 1638 1639; mul 368 1271; add 1640 1641; mul 925
1274; add 1642 1643; mul 928 1277; add 1644 1645; add 1635 1646; mul 945 1263; mul 785 1265; add 1648 1649; mul 900
1268; add 1650 1651; mul 327 1271; add 1652 1653; mul 331 1274; add 1654 1655; mul 335 1277; add 1656 1657; mul 944
1658; add 1647 1659; mul 585 1660; add 1629 1661; mul 145 1662; mul 690 1426; mul 588 1534; sub 1664 1665; sub 1663
1666; mul 47 774; mul 22 1668; add 1667 1669; mul 859 1670; add 1604 1671; sub 1599 1672; input c_q 0; mul 90 1674;
le 140 139; le 139 140; add 1676 1677; div 2 1678; mul 1676 1679; mul 0 90; mul 1680 1681; input c_q 1; mul 1682
1683; sub 1675 1684; mul 90 93; input c_q 2; mul 1686 1687; add 1685 1688; mul 90 97; input c_q 3; mul 1690 1691;
add 1689 1692; mul 90 100; add 783 1694; input c_q 4; mul 1695 1696; sub 1693 1697; mul 102 1695; input c_q 5; mul
1699 1700; add 1698 1701; mul 93 1695; input c_q 6; mul 1703 1704; sub 1702 1705; mul 97 1695; input c_q 7; mul 1707
1708; sub 1706 1709; le 128 127; le 127 128; add 1711 1712; div 2 1713; mul 1711 1714; mul 132 1695; mul 1715 1716;
input c_q 8; mul 1717 1718; add 1710 1719; mul 90 102; input c_q 9; mul 1721 1722; add 1720 1723; mul 102 1721; mul
104 1725; input c_q 10; mul 1726 1727; sub 1724 1728; mul 93 1721; input c_q 11; mul 1730 1731; add 1729 1732; mul
97 1721; input c_q 12; mul 1734 1735; add 1733 1736; add 1673 1737; mul 56 1088; mul 70 1074; add 1739 1740; mul 79
1104; add 1742 1742; sub 1741 1743; mul 89 1744; mul 89 987; mul 1121 1746; sub 1745 1747; mul 856 1748; mul 987
1596; add 1749 1750; mul 781 1557; mul 783 1551; add 1752 1753; sub 1751 1754; mul 59 1088; mul 70 1080; add 1756
1757; mul 76 1104; mul 79 1095; add 1759 1760; sub 1758 1761; mul 89 1762; mul 89 994; mul 1121 1764; sub 1763 1765;
mul 981 1766; mul 994 1670; add 1767 1768; add 1755 1769; mul 0 783; mul 1680 1771; mul 1683 1772; mul 783 1674; sub
1773 1774; mul 93 783; mul 1687 1776; sub 1775 1777; mul 97 783; mul 1691 1779; sub 1778 1780; mul 100 783; add 987
1782; mul 1696 1783; add 1781 1784; mul 102 1783; mul 1700 1786; sub 1785 1787; mul 93 1783; mul 1704 1789; add 1788
1790; mul 97 1783; mul 1708 1792; add 1791 1793; mul 132 1783; mul 1715 1795; mul 1718 1796; sub 1794 1797; mul 102
783; mul 1722 1799; sub 1798 1800; mul 102 1799; mul 104 1802; mul 1727 1803; add 1801 1804; mul 93 1799; mul 1731
1806; sub 1805 1807; mul 97 1799; mul 1735 1809; sub 1808 1810; add 1770 1811; mul 781 1603; mul 859 1551; add 1813
1814; mul 856 1766; mul 994 1596; add 1816 1817; sub 1815 1818; mul 45 1088; mul 70 1070; add 1820 1821; mul 76
1095; add 1823 1823; sub 1822 1824; mul 89 1825; mul 89 1003; mul 1121 1827; sub 1826 1828; mul 981 1829; mul 1003
1670; add 1830 1831; sub 1819 1832; mul 859 1674; mul 0 859; mul 1680 1835; mul 1683 1836; sub 1834 1837; mul 93
859; mul 1687 1839; add 1838 1840; mul 97 859; mul 1691 1842; add 1841 1843; mul 100 859; add 994 1845; mul 1696
1846; sub 1844 1847; mul 102 1846; mul 1700 1849; add 1848 1850; mul 93 1846; mul 1704 1852; sub 1851 1853; mul 97
1846; mul 1708 1855; sub 1854 1856; mul 132 1846; mul 1715 1858; mul 1718 1859; add 1857 1860; mul 102 859; mul 1722
1862; add 1861 1863; mul 102 1862; mul 104 1865; mul 1727 1866; sub 1864 1867; mul 93 1862; mul 1731 1869; add 1868
1870; mul 97 1862; mul 1735 1872; add 1871 1873; add 1833 1874; mul 592 1394; mul 555 1431; add 1876 1877; mul 685
1501; mul 667 1527; add 1879 1880; mul 100 129; mul 100 1882; add 141 1883; input p 184; mul 431 501; sub 1886 569;
mul 560 1887; mul 501 1888; mul 431 620; sub 1890 681; mul 672 1891; mul 620 1892; add 1889 1893; mul 431 1894; add
1885 1895; mul 569 1888; mul 681 1892; add 1897 1898; sub 1896 1899; add 1884 1900; sign 0; mul 715 1902; mul 0
1903; add 717 1904; mul 719 725; mul 725 726; mul 0 725; mul 1907 1908; sub 1906 1909; add 1905 1910; add 1901 1911;
add 740 744; add 741 1913; add 743 1914; mul 67 1915; mul 22 1916; add 1912 1917; mul 90 1918; mul 579 1894; input p
185; add 1920 1921; mul 567 1888; mul 679 1892; add 1923 1924; add 1922 1925; sub 1882 1926; mul 41 1915; mul 22
1928; sub 1927 1929; mul 783 1930; add 1919 1931; mul 588 1894; input p 186; add 1933 1934; mul 53 1915; mul 22
1936; add 1935 1937; mul 859 1938; add 1932 1939; neg 1940; mul 987 1930; mul 783 1918; add 1942 1943; mul 994 1938;
add 1944 1945; mul 859 1918; mul 994 1930; add 1947 1948; mul 1003 1938; add 1949 1950; neg 1951; mul 555 1887; mul
667 1891; where 1037 1038; where 1046 1047; where 1055 1056; where 1064 1065; mul 26 503; div 2 14; mul 11 1960; mul
9 1961; mul 9 24; mul 5 9; mul 1963 1964; sub 1962 1965; mul 17 1966; mul 9 9; mul 1964 1968; mul 16 1969; mul 16
17; mul 14 1964; mul 8 1961; add 1972 1973; mul 1971 1974; add 1970 1975; mul 24 1976; sub 1967 1977; mul 23 1978;
mul 1959 1979; mul 9 38; mul 1964 1981; sub 9 1982; mul 17 1983; mul 38 1976; sub 1984 1985; mul 23 1986; add 31
1987; mul 1068 1988; add 1980 1989; mul 22 1990; mul 18 1976; mul 17 1992; mul 19 1976; add 1993 1994; sub 1991
1995; mul 56 1996; mul 34 1072; mul 22 1998; mul 45 1999; add 1997 2000; mul 53 1988; mul 34 41; add 2002 2003; mul
22 2004; mul 59 2005; add 2006 2006; sub 2001 2007; mul 89 2008; mul 28 1086; mul 22 2010; mul 61 2011; mul 70 2008;
add 2012 2013; mul 28 41; mul 67 1988; add 2015 2016; add 1979 2017; mul 22 2018; mul 81 2019; mul 56 2019; mul 76
1999; add 2021 2022; mul 79 2005; mul 34 67; add 1077 2025; mul 22 2026; mul 59 2027; add 2024 2028; sub 2023 2029;
mul 76 2030; add 2020 2031; sub 2014 2032; mul 86 2027; mul 59 2019; mul 76 2005; add 2035 2036; mul 79 1996; mul 45
2027; add 2038 2039; sub 2037 2040; mul 79 2041; add 2034 2042; add 2033 2043; mul 1085 2044; sub 2009 2045; mul 781
2046; sub 114 107; add 1129 2048; input p 187; mul 35 150; mul 157 2051; add 2050 2052; mul 35 2051; mul 161 2054;
add 2053 2055; mul 150 1140; mul 165 2057; add 2056 2058; mul 35 2057; mul 169 2060; add 2059 2061; mul 155 2057;
mul 150 166; add 2063 2064; mul 173 2065; add 2062 2066; mul 148 150; mul 188 2068; add 2067 2069; mul 35 2068; mul
192 2071; add 2070 2072; mul 155 2068; mul 150 189; add 2074 2075; mul 196 2076; add 2073 2077; mul 150 201; mul 200
2079; add 2078 2080; input p 188; mul 224 2051; add 2082 2083; mul 227 2054; add 2084 2085; mul 230 2057; add 2086
2087; mul 233 2060; add 2088 2089; mul 236 2065; add 2090 2091; mul 245 2068; add 2092 2093; mul 248 2071; add 2094
2095; mul 251 2076; add 2096 2097; mul 196 2079; add 2098 2099; mul 147 2100; add 2081 2101; le 290 288; le 288 290;
add 2103 2104; div 2 2105; mul 2103 2106; le 289 3; le 3 289; add 2108 2109; div 2 2110; mul 2108 2111; mul 2107
2112; constant 1.6666666666666667; mul 294 503; le 140 293; le 293 140; add 2116 2117; div 2 2118; mul 2116 2119;
mul 2113 2120; mul 2115 2121; mul 298 503; le 140 297; le 297 140; add 2124 2125; div 2 2126; mul 2124 2127; mul
2113 2128; mul 2123 2129; add 2122 2130; mul 2114 2131; sub 2113 2132; mul 284 2133; mul 287 2134; mul 303 503; mul
2133 2136; mul 327 2137; add 2135 2138; mul 323 2133; mul 331 2140; add 2139 2141; mul 339 2142; mul 285 2133; mul
344 2144; mul 303 2134; mul 304 2133; add 2146 2147; mul 352 2148; add 2145 2149; mul 323 2134; mul 356 2151; add
2150 2152; mul 303 2137; mul 328 2133; add 2154 2155; mul 364 2156; add 2153 2157; mul 323 2137; mul 368 2159; add
2158 2160; mul 323 2140; mul 372 2162; add 2161 2163; add 2143 2164; mul 383 2165; add 2102 2166; mul 145 2167; mul
144 2168; mul 412 2144; mul 418 2148; add 2170 2171; mul 421 2151; add 2172 2173; mul 424 2156; add 2174 2175; mul
427 2159; add 2176 2177; mul 383 2178; add 28 2179; mul 690 2180; mul 482 1966; mul 479 1983; add 2182 2183; mul
1333 2184; add 32 37; add 30 2186; add 36 2187; mul 104 2188; mul 284 2178; mul 461 2133; mul 418 2144; mul 450
2148; add 2192 2193; mul 453 2151; add 2194 2195; mul 456 2156; add 2196 2197; mul 459 2159; add 2198 2199; mul 303
2200; add 2191 2201; add 2190 2202; mul 447 2144; mul 427 2148; add 2204 2205; mul 470 2156; add 2206 2207; mul 323
2208; add 2203 2209; mul 441 2210; mul 440 2211; add 2189 2212; mul 479 1966; add 2213 2214; mul 482 1983; sub 2215
2216; mul 1303 2217; add 2185 2218; mul 1336 2219; mul 485 2220; mul 503 2221; mul 1342 2221; mul 499 2223; mul 1340
2224; neg 2225; mul 503 2226; mul 499 2227; mul 505 2225; sub 2228 2229; sub 2222 2230; mul 502 2231; mul 520 2232;
mul 1363 2221; mul 1358 2234; mul 516 2235; mul 514 2236; mul 518 2235; add 2237 2238; mul 508 2239; add 2233 2240;
mul 525 2221; mul 512 2242; mul 527 2221; add 2243 2244; mul 523 2245; sub 2241 2246; mul 485 2247; mul 550 2221;
mul 512 2249; mul 552 2221; add 2250 2251; mul 548 2252; mul 546 2223; mul 498 2254; mul 547 2223; add 2255 2256;
mul 498 2257; mul 1389 2223; add 2258 2259; mul 485 2260; mul 554 2261; sub 2253 2262; mul 543 2263; add 2248 2264;
mul 558 2263; mul 555 2266; mul 559 2263; add 2267 2268; mul 592 2269; mul 561 2184; sub 2214 2216; mul 491 2272;
add 2271 2273; mul 563 2217; mul 484 2184; add 2275 2276; sub 2274 2277; mul 500 2278; mul 485 2225; mul 565 2280;
sub 2279 2281; mul 17 2282; mul 566 1976; sub 2283 2284; mul 130 2285; mul 500 2184; mul 491 2280; sub 2287 2288;
mul 0 2289; sub 2286 2290; mul 500 2217; mul 484 2280; sub 2292 2293; mul 590 2294; mul 0 2180; mul 576 2200; sub
2121 2129; mul 573 2298; mul 461 2299; sub 2297 2300; mul 440 2301; add 31 2302; mul 130 2303; add 2296 2304; mul
585 2208; mul 440 2306; add 34 2307; mul 395 2308; add 2305 2309; mul 501 2310; add 2295 2311; add 2291 2312; mul
560 2313; add 2270 2314; add 2265 2315; mul 501 2316; mul 594 2294; add 2317 2318; mul 598 1983; mul 601 1966; sub
2320 2321; mul 1440 2322; mul 598 1966; add 2213 2324; mul 601 1983; add 2325 2326; mul 1438 2327; add 2323 2328;
mul 1443 2329; mul 604 2330; mul 503 2331; mul 1449 2331; mul 618 2333; mul 1447 2334; neg 2335; mul 503 2336; mul
618 2337; mul 623 2335; sub 2338 2339; sub 2332 2340; mul 621 2341; mul 635 2342; mul 1470 2331; mul 1465 2344; mul
631 2345; mul 629 2346; mul 633 2345; add 2347 2348; mul 626 2349; add 2343 2350; mul 640 2331; mul 627 2352; mul
642 2331; add 2353 2354; mul 638 2355; sub 2351 2356; mul 604 2357; mul 550 2331; mul 627 2359; mul 664 2331; add
2360 2361; mul 662 2362; mul 660 2333; mul 617 2364; mul 661 2333; add 2365 2366; mul 617 2367; mul 1496 2333; add
2368 2369; mul 604 2370; mul 666 2371; sub 2363 2372; mul 658 2373; add 2358 2374; mul 670 2373; mul 667 2376; mul
671 2373; add 2377 2378; mul 685 2379; mul 673 2322; add 2324 2326; mul 610 2382; add 2381 2383; mul 675 2327; sub
2321 2320; mul 603 2386; add 2385 2387; add 2384 2388; mul 619 2389; mul 604 2335; mul 677 2391; sub 2390 2392; mul
17 2393; mul 678 1976; sub 2394 2395; mul 130 2396; mul 619 2322; mul 610 2391; sub 2398 2399; mul 0 2400; sub 2397
2401; mul 619 2327; mul 603 2391; sub 2403 2404; mul 590 2405; mul 620 2310; add 2406 2407; add 2402 2408; mul 672
2409; add 2380 2410; add 2375 2411; mul 620 2412; mul 687 2405; add 2413 2414; add 2319 2415; mul 431 2416; sub 2181
2417; sub 2169 2418; mul 569 2316; mul 594 2289; add 2420 2421; mul 681 2412; mul 687 2400; add 2423 2424; add 2422
2425; sub 2419 2426; sub 2049 2427; mul 770 1983; mul 16 1964; mul 16 766; mul 1974 2431; sub 2430 2432; mul 10
2433; mul 766 2434; mul 767 2433; add 2435 2436; mul 765 1964; mul 9 2438; mul 9 765; mul 1964 2440; add 2439 2441;
sub 2437 2442; mul 3 2443; add 769 2444; mul 38 2445; add 2429 2446; sub 1978 2447; mul 762 2448; mul 130 1976; mul
130 2450; mul 23 2451; mul 772 2452; sub 2449 2453; mul 67 2454; add 1594 2455; mul 770 1966; mul 24 2445; add 2457
2458; add 1986 2459; mul 762 2460; mul 777 2452; sub 2461 2462; sub 2456 2463; mul 22 2464; sub 2428 2465; mul 90
2466; add 2047 2467; mul 89 2030; mul 1555 2044; sub 2469 2470; mul 856 2471; mul 842 1983; mul 17 2473; mul 843
1976; sub 2474 2475; mul 150 2100; mul 787 2134; mul 792 2137; add 2478 2479; mul 795 2140; add 2480 2481; mul 339
2482; mul 352 2144; mul 809 2148; add 2484 2485; mul 812 2151; add 2486 2487; mul 817 2156; add 2488 2489; mul 820
2159; add 2490 2491; mul 823 2162; add 2492 2493; add 2483 2494; mul 576 2495; mul 829 2299; sub 2496 2497; add 2477
2498; mul 145 2499; mul 690 2303; mul 579 2416; sub 2501 2502; sub 2500 2503; mul 567 2316; mul 594 2285; add 2505
2506; mul 679 2412; mul 687 2396; add 2508 2509; add 2507 2510; add 2504 2511; add 118 2512; sub 2476 2513; mul 774
1988; mul 41 2454; add 2515 2516; mul 778 1979; mul 26 2463; add 2518 2519; sub 2517 2520; mul 22 2521; mul 19 2445;
mul 770 1992; sub 2523 2524; mul 761 2525; mul 853 2451; sub 2526 2527; sub 2522 2528; sub 2514 2529; mul 783 2530;
add 2472 2531; sub 2468 2532; mul 89 2041; mul 1601 2044; sub 2534 2535; mul 981 2536; input p 189; mul 870 2051;
add 2538 2539; mul 873 2054; add 2540 2541; mul 876 2057; add 2542 2543; mul 227 2060; add 2544 2545; mul 881 2065;
add 2546 2547; mul 157 2068; add 2548 2549; mul 886 2071; add 2550 2551; mul 169 2076; add 2552 2553; mul 257 2079;
add 2554 2555; mul 153 2100; add 2556 2557; mul 331 2134; mul 907 2137; add 2559 2560; mul 910 2140; add 2561 2562;
mul 339 2563; mul 806 2144; mul 368 2148; add 2565 2566; mul 925 2151; add 2567 2568; mul 931 2156; add 2569 2570;
mul 823 2159; add 2571 2572; mul 936 2162; add 2573 2574; add 2564 2575; mul 785 2144; mul 327 2148; add 2577 2578;
mul 331 2151; add 2579 2580; mul 957 2156; add 2581 2582; mul 907 2159; add 2583 2584; mul 798 2162; add 2585 2586;
mul 944 2587; add 2576 2588; mul 585 2589; add 2558 2590; mul 145 2591; mul 690 2308; mul 588 2416; sub 2593 2594;
sub 2592 2595; mul 34 774; mul 53 2454; add 2597 2598; mul 22 2599; add 2596 2600; mul 859 2601; add 2537 2602; sub
2533 2603; mul 56 2011; mul 70 1999; add 2605 2606; mul 79 2027; add 2608 2608; sub 2607 2609; mul 89 2610; mul 1746
2044; sub 2611 2612; mul 856 2613; mul 987 2530; add 2614 2615; mul 781 2471; mul 783 2466; add 2617 2618; sub 2616
2619; mul 59 2011; mul 70 2005; add 2621 2622; mul 76 2027; mul 79 2019; add 2624 2625; sub 2623 2626; mul 89 2627;
mul 1764 2044; sub 2628 2629; mul 981 2630; mul 994 2601; add 2631 2632; add 2620 2633; mul 781 2536; mul 859 2466;
add 2635 2636; mul 856 2630; mul 994 2530; add 2638 2639; sub 2637 2640; mul 45 2011; mul 70 1996; add 2642 2643;
mul 76 2019; add 2645 2645; sub 2644 2646; mul 89 2647; mul 1827 2044; sub 2648 2649; mul 981 2650; mul 1003 2601;
add 2651 2652; sub 2641 2653; mul 592 2263; mul 555 2313; add 2655 2656; mul 685 2373; mul 667 2409; add 2658 2659;
input p 190; mul 501 579; add 567 2662; mul 560 2663; mul 501 2664; mul 579 620; add 679 2666; mul 672 2667; mul 620
2668; add 2665 2669; mul 431 2670; add 2661 2671; mul 569 2664; mul 681 2668; add 2673 2674; sub 2672 2675; sub 1882
2676; add 747 750; add 746 2678; add 749 2679; mul 503 760; mul 23 2681; mul 772 2682; add 2680 2683; mul 67 2684;
mul 777 2682; sub 2685 2686; mul 22 2687; sub 2677 2688; mul 90 2689; mul 579 2670; input p 191; add 2691 2692; mul
567 2664; mul 679 2668; add 2694 2695; add 2693 2696; add 129 2697; mul 41 2684; mul 26 2686; sub 2699 2700; mul 22
2701; mul 853 2681; sub 2702 2703; add 2698 2704; mul 783 2705; add 2690 2706; mul 588 2670; input p 192; add 2708
2709; mul 53 2684; mul 22 2711; add 2710 2712; mul 859 2713; sub 2707 2714; mul 994 2713; mul 987 2705; mul 783
2689; add 2717 2718; sub 2716 2719; mul 859 2689; mul 994 2705; add 2721 2722; mul 1003 2713; sub 2723 2724; mul 555
2663; mul 667 2667; input p 193; where 1037 2728; input p 194; where 1046 2730; input p 195; where 1055 2732; input
p 196; where 1064 2734; mul 34 1068; mul 22 2736; mul 56 2737; mul 51 1072; mul 22 2739; mul 45 2740; add 2738 2741;
mul 34 53; mul 41 51; add 2743 2744; mul 22 2745; mul 59 2746; add 2747 2747; sub 2742 2748; mul 89 2749; mul 47
1086; mul 22 2751; mul 61 2752; mul 70 2749; add 2753 2754; add 1078 2025; mul 22 2756; mul 81 2757; mul 56 2757;
mul 76 2740; add 2759 2760; mul 79 2746; mul 51 67; mul 47 53; add 2763 2764; mul 22 2765; mul 59 2766; add 2762
2767; sub 2761 2768; mul 76 2769; add 2758 2770; sub 2755 2771; mul 86 2766; mul 59 2757; mul 76 2746; add 2774
2775; mul 79 2737; mul 45 2766; add 2777 2778; sub 2776 2779; mul 79 2780; add 2773 2781; add 2772 2782; mul 1085
2783; sub 2750 2784; mul 781 2785; input p 197; add 154 155; mul 157 2788; add 2787 2789; mul 35 2788; add 158 2791;
mul 161 2792; add 2790 2793; mul 153 1140; mul 165 2795; add 2794 2796; mul 35 2795; add 166 2798; mul 169 2799; add
2797 2800; mul 155 2795; mul 153 166; add 2802 2803; mul 173 2804; add 2801 2805; mul 148 180; add 2806 2807; mul
181 503; mul 184 2809; add 2808 2810; mul 148 153; mul 188 2812; add 2811 2813; mul 35 2812; add 189 2815; mul 192
2816; add 2814 2817; mul 155 2812; mul 153 189; add 2819 2820; mul 196 2821; add 2818 2822; mul 153 201; mul 200
2824; add 2823 2825; mul 35 503; mul 213 2827; add 210 2828; mul 35 2827; add 214 2830; mul 217 2831; add 2829 2832;
input p 198; add 2833 2834; mul 224 2788; add 2835 2836; mul 227 2792; add 2837 2838; mul 230 2795; add 2839 2840;
mul 233 2799; add 2841 2842; mul 236 2804; add 2843 2844; mul 148 157; add 2845 2846; mul 161 2809; add 2847 2848;
mul 245 2812; add 2849 2850; mul 248 2816; add 2851 2852; mul 251 2821; add 2853 2854; mul 201 257; add 2855 2856;
mul 196 2824; add 2857 2858; mul 147 2859; add 2826 2860; le 310 308; le 308 310; add 2862 2863; div 2 2864; mul
2862 2865; le 309 35; le 35 309; add 2867 2868; div 2 2869; mul 2867 2870; mul 2866 2871; constant 0.625; mul 314
503; le 140 313; le 313 140; add 2875 2876; div 2 2877; mul 2875 2878; mul 2872 2879; mul 2874 2880; mul 318 503; le
140 317; le 317 140; add 2883 2884; div 2 2885; mul 2883 2886; mul 2872 2887; mul 2882 2888; add 2881 2889; mul 2873
2890; sub 2872 2891; mul 284 2892; mul 307 2893; mul 303 2892; mul 331 2895; add 2894 2896; mul 323 503; mul 2892
2898; mul 335 2899; add 2897 2900; mul 339 2901; mul 323 2899; mul 336 2892; add 2903 2904; mul 338 2905; add 2902
2906; mul 285 2892; mul 348 2908; mul 304 2892; mul 356 2910; add 2909 2911; mul 323 2893; mul 324 2892; add 2913
2914; mul 360 2915; add 2912 2916; mul 328 2892; mul 368 2918; add 2917 2919; mul 323 2895; mul 332 2892; add 2921
2922; mul 372 2923; add 2920 2924; mul 376 2905; add 2925 2926; add 2907 2927; mul 383 2928; add 2861 2929; mul 145
2930; mul 144 2931; mul 415 2908; mul 421 2910; add 2933 2934; mul 427 2918; add 2935 2936; mul 383 2937; add 47
2938; mul 690 2939; add 52 53; add 50 2941; mul 104 2942; mul 284 2937; mul 447 2908; mul 453 2910; add 2945 2946;
mul 459 2918; add 2947 2948; mul 303 2949; add 2944 2950; mul 472 2892; add 2951 2952; mul 441 2953; mul 440 2954;
add 2943 2955; mul 1303 2956; mul 1336 2957; mul 485 2958; mul 503 2959; mul 1342 2959; mul 499 2961; mul 1340 2962;
neg 2963; mul 503 2964; mul 499 2965; mul 505 2963; sub 2966 2967; sub 2960 2968; mul 502 2969; mul 520 2970; mul
1363 2959; mul 1358 2972; mul 516 2973; mul 514 2974; mul 518 2973; add 2975 2976; mul 508 2977; add 2971 2978; mul
525 2959; mul 512 2980; mul 527 2959; add 2981 2982; mul 523 2983; sub 2979 2984; mul 485 2985; mul 550 2959; mul
512 2987; mul 552 2959; add 2988 2989; mul 548 2990; mul 546 2961; mul 498 2992; mul 547 2961; add 2993 2994; mul
498 2995; mul 1389 2961; add 2996 2997; mul 485 2998; mul 554 2999; sub 2991 3000; mul 543 3001; add 2986 3002; mul
558 3001; mul 555 3004; mul 559 3001; add 3005 3006; mul 592 3007; mul 485 2963; mul 491 3009; mul 0 3010; mul 563
2956; mul 500 3012; mul 565 3009; add 3013 3014; mul 17 3015; mul 130 3016; sub 3011 3017; mul 500 2956; mul 484
3009; sub 3019 3020; mul 590 3021; mul 0 2939; mul 576 2949; mul 440 3024; add 34 3025; mul 130 3026; add 3023 3027;
sub 2880 2888; mul 582 3029; mul 472 3030; mul 440 3031; sub 51 3032; mul 395 3033; add 3028 3034; mul 501 3035; add
3022 3036; add 3018 3037; mul 560 3038; add 3008 3039; add 3003 3040; mul 501 3041; mul 594 3021; add 3042 3043; mul
1438 2956; mul 1443 3045; mul 604 3046; mul 503 3047; mul 1449 3047; mul 618 3049; mul 1447 3050; neg 3051; mul 503
3052; mul 618 3053; mul 623 3051; sub 3054 3055; sub 3048 3056; mul 621 3057; mul 635 3058; mul 1470 3047; mul 1465
3060; mul 631 3061; mul 629 3062; mul 633 3061; add 3063 3064; mul 626 3065; add 3059 3066; mul 640 3047; mul 627
3068; mul 642 3047; add 3069 3070; mul 638 3071; sub 3067 3072; mul 604 3073; mul 550 3047; mul 627 3075; mul 664
3047; add 3076 3077; mul 662 3078; mul 660 3049; mul 617 3080; mul 661 3049; add 3081 3082; mul 617 3083; mul 1496
3049; add 3084 3085; mul 604 3086; mul 666 3087; sub 3079 3088; mul 658 3089; add 3074 3090; mul 670 3089; mul 667
3092; mul 671 3089; add 3093 3094; mul 685 3095; mul 675 2956; mul 619 3097; mul 604 3051; mul 677 3099; sub 3098
3100; mul 17 3101; mul 130 3102; mul 610 3099; mul 0 3104; add 3103 3105; mul 619 2956; mul 603 3099; sub 3107 3108;
mul 590 3109; mul 620 3035; add 3110 3111; add 3106 3112; mul 672 3113; add 3096 3114; add 3091 3115; mul 620 3116;
mul 687 3109; add 3117 3118; add 3044 3119; mul 431 3120; sub 2940 3121; sub 2932 3122; mul 569 3041; mul 594 3010;
sub 3124 3125; mul 681 3116; mul 687 3104; sub 3127 3128; add 3126 3129; sub 3123 3130; add 1669 3131; mul 90 3132;
sub 2786 3133; mul 89 2769; mul 1555 2783; sub 3135 3136; mul 856 3137; mul 150 2859; mul 331 2893; mul 795 2895;
add 3140 3141; mul 798 2899; add 3142 3143; mul 339 3144; mul 800 2905; add 3145 3146; mul 806 2908; mul 812 2910;
add 3148 3149; mul 372 2915; add 3150 3151; mul 820 2918; add 3152 3153; mul 823 2923; add 3154 3155; mul 826 2905;
add 3156 3157; add 3147 3158; mul 576 3159; add 3139 3160; mul 145 3161; mul 690 3026; mul 579 3120; sub 3163 3164;
sub 3162 3165; mul 567 3041; mul 594 3016; sub 3167 3168; mul 679 3116; mul 687 3102; add 3170 3171; add 3169 3172;
add 3166 3173; mul 22 2597; add 3174 3175; mul 783 3176; sub 3138 3177; sub 3134 3178; mul 89 2780; mul 1601 2783;
sub 3180 3181; mul 981 3182; mul 862 2827; add 860 3184; mul 865 2831; add 3185 3186; input p 199; add 3187 3188;
mul 870 2788; add 3189 3190; mul 873 2792; add 3191 3192; mul 876 2795; add 3193 3194; mul 227 2799; add 3195 3196;
mul 881 2804; add 3197 3198; mul 157 2812; add 3199 3200; mul 886 2816; add 3201 3202; mul 169 2821; add 3203 3204;
mul 184 201; add 3205 3206; mul 257 2824; add 3207 3208; mul 153 2859; add 3209 3210; mul 904 2893; mul 910 2895;
add 3212 3213; mul 913 2899; add 3214 3215; mul 339 3216; mul 915 2905; add 3217 3218; mul 360 2908; mul 925 2910;
add 3220 3221; mul 928 2915; add 3222 3223; mul 823 2918; add 3224 3225; mul 936 2923; add 3226 3227; mul 939 2905;
add 3228 3229; add 3219 3230; mul 943 2899; mul 966 3232; mul 900 2908; mul 331 2910; add 3234 3235; mul 335 2915;
add 3236 3237; mul 907 2918; add 3238 3239; mul 798 2923; add 3240 3241; mul 964 2905; add 3242 3243; mul 944 3244;
add 3233 3245; add 3231 3246; mul 585 3247; mul 968 3030; sub 3248 3249; add 3211 3250; mul 145 3251; mul 690 3033;
mul 588 3120; sub 3253 3254; sub 3252 3255; mul 51 774; mul 22 3257; add 3256 3258; mul 859 3259; add 3183 3260; sub
3179 3261; mul 56 2752; mul 70 2740; add 3263 3264; mul 79 2766; add 3266 3266; sub 3265 3267; mul 89 3268; mul 1746
2783; sub 3269 3270; mul 856 3271; mul 987 3176; sub 3272 3273; mul 781 3137; mul 783 3132; sub 3275 3276; sub 3274
3277; mul 59 2752; mul 70 2746; add 3279 3280; mul 76 2766; mul 79 2757; add 3282 3283; sub 3281 3284; mul 89 3285;
mul 1764 2783; sub 3286 3287; mul 981 3288; mul 994 3259; add 3289 3290; add 3278 3291; mul 781 3182; mul 859 3132;
sub 3293 3294; mul 856 3288; mul 994 3176; sub 3296 3297; sub 3295 3298; mul 45 2752; mul 70 2737; add 3300 3301;
mul 76 2757; add 3303 3303; sub 3302 3304; mul 89 3305; mul 1827 2783; sub 3306 3307; mul 981 3308; mul 1003 3259;
add 3309 3310; sub 3299 3311; mul 592 3001; mul 555 3038; add 3313 3314; mul 685 3089; mul 667 3113; add 3316 3317;
mul 501 588; mul 560 3319; mul 501 3320; mul 588 620; mul 672 3322; mul 620 3323; add 3321 3324; mul 579 3325; input
p 200; add 3326 3327; mul 567 3320; mul 679 3323; add 3329 3330; add 3328 3331; add 756 757; add 755 3333; mul 41
3334; mul 22 3335; add 3332 3336; mul 783 3337; input p 201; mul 431 3325; add 3339 3340; mul 569 3320; mul 681
3323; add 3342 3343; sub 3341 3344; mul 67 3334; mul 22 3346; add 3345 3347; mul 90 3348; sub 3338 3349; mul 588
3325; input p 202; add 3351 3352; mul 53 3334; mul 22 3354; add 3353 3355; mul 859 3356; sub 3350 3357; mul 783
3348; mul 987 3337; sub 3359 3360; mul 994 3356; add 3361 3362; mul 994 3337; mul 859 3348; sub 3364 3365; mul 1003
3356; sub 3366 3367; mul 555 3319; mul 667 3322; mul 533 555; mul 501 3371; mul 579 3372; mul 567 3371; add 3373
3374; mul 783 3375; mul 431 3372; mul 569 3371; sub 3377 3378; mul 90 3379; sub 3376 3380; mul 588 3372; mul 859
3382; sub 3381 3383; mul 783 3379; mul 987 3375; sub 3385 3386; mul 994 3382; add 3387 3388; mul 994 3375; mul 859
3379; sub 3390 3391; mul 1003 3382; sub 3392 3393; input p 203; mul 648 667; mul 620 3396; mul 579 3397; mul 679
3396; add 3398 3399; mul 783 3400; mul 431 3397; mul 681 3396; sub 3402 3403; mul 90 3404; sub 3401 3405; mul 588
3397; mul 859 3407; sub 3406 3408; mul 783 3404; mul 987 3400; sub 3410 3411; mul 994 3407; add 3412 3413; mul 994
3400; mul 859 3404; sub 3415 3416; mul 1003 3407; sub 3417 3418; mul 536 555; mul 501 3420; mul 579 3421; mul 567
3420; add 3422 3423; mul 783 3424; mul 431 3421; mul 569 3420; sub 3426 3427; mul 90 3428; sub 3425 3429; mul 588
3421; mul 859 3431; sub 3430 3432; mul 783 3428; mul 987 3424; sub 3434 3435; mul 994 3431; add 3436 3437; mul 994
3424; mul 859 3428; sub 3439 3440; mul 1003 3431; sub 3441 3442; input p 204; mul 651 667; mul 620 3445; mul 579
3446; mul 679 3445; add 3447 3448; mul 783 3449; mul 431 3446; mul 681 3445; sub 3451 3452; mul 90 3453; sub 3450
3454; mul 588 3446; mul 859 3456; sub 3455 3457; mul 783 3453; mul 987 3449; sub 3459 3460; mul 994 3456; add 3461
3462; mul 994 3449; mul 859 3453; sub 3464 3465; mul 1003 3456; sub 3466 3467; mul 540 555; mul 501 3469; mul 579
3470; mul 567 3469; add 3471 3472; mul 783 3473; mul 431 3470; mul 569 3469; sub 3475 3476; mul 90 3477; sub 3474
3478; mul 588 3470; mul 859 3480; sub 3479 3481; mul 783 3477; mul 987 3473; sub 3483 3484; mul 994 3480; add 3485
3486; mul 994 3473; mul 859 3477; sub 3488 3489; mul 1003 3480; sub 3490 3491; input p 205; mul 655 667; mul 620
3494; mul 579 3495; mul 679 3494; add 3496 3497; mul 783 3498; mul 431 3495; mul 681 3494; sub 3500 3501; mul 90
3502; sub 3499 3503; mul 588 3495; mul 859 3505; sub 3504 3506; mul 783 3502; mul 987 3498; sub 3508 3509; mul 994
3505; add 3510 3511; mul 994 3498; mul 859 3502; sub 3513 3514; mul 1003 3505; sub 3515 3516; mul 90 730; mul 730
783; neg 3519; mul 730 859; input p 206; mul 90 734; mul 734 783; neg 3524; mul 734 859; input p 207; input p 208;
mul 783 3528; mul 90 699; sub 3529 3530; mul 699 783; mul 987 3528; sub 3532 3533; mul 994 3528; mul 699 859; sub
3535 3536; input p 209; mul 783 3538; mul 90 702; sub 3539 3540; mul 702 783; mul 987 3538; sub 3542 3543; mul 994
3538; mul 702 859; sub 3545 3546; input p 210; mul 783 3548; mul 90 706; sub 3549 3550; mul 706 783; mul 987 3548;
sub 3552 3553; mul 994 3548; mul 706 859; sub 3555 3556; input p 211; mul 783 3558; mul 90 710; sub 3559 3560; mul
710 783; mul 987 3558; sub 3562 3563; mul 994 3558; mul 710 859; sub 3565 3566; mul 102 109; add 92 3568; mul 100
121; sub 3569 3570; mul 522 529; mul 485 3572; mul 569 3573; mul 501 3573; mul 431 3575; sub 3574 3576; sub 3571
3577; mul 90 3578; mul 579 3575; mul 567 3573; add 3580 3581; add 121 3582; mul 783 3583; sub 3579 3584; mul 588
3575; mul 859 3586; add 3585 3587; mul 987 3583; mul 783 3578; sub 3589 3590; mul 994 3586; sub 3591 3592; mul 859
3578; mul 994 3583; sub 3594 3595; mul 1003 3586; add 3596 3597; mul 102 112; add 96 3599; mul 100 124; sub 3600
3601; mul 637 644; mul 604 3603; mul 681 3604; mul 620 3604; mul 431 3606; sub 3605 3607; sub 3602 3608; mul 90
3609; mul 579 3606; mul 679 3604; add 3611 3612; add 124 3613; mul 783 3614; sub 3610 3615; mul 588 3606; mul 859
3617; add 3616 3618; mul 987 3614; mul 783 3609; sub 3620 3621; mul 994 3617; sub 3622 3623; mul 859 3609; mul 994
3614; sub 3625 3626; mul 1003 3617; add 3627 3628; neg 783; neg 1682; neg 1836; neg 1776; neg 1779; neg 1695; neg
1846; neg 1786; neg 1703; neg 1852; neg 1707; neg 1855; neg 1796; neg 1799; neg 1726; neg 1866; neg 1806; neg 1809;
store f 0 0; store f 1 983; store f 2 130; store f 3 996; store f 4 395; store f 5 1005; store f 6 1009; store f 7
1012; store f 8 1015; store f 9 1017; store f 10 1020; store f 11 1022; store f 12 1024; store f 13 1026; store f 14
1040; store f 15 1049; store f 16 1058; store f 17 1067; store a 18 1738; store a 54 1812; store a 90 1875; store a
108 1878; store a 126 1881; store a 144 1878; store a 162 1881; store a 180 1878; store a 198 1881; store a 216
1023; store a 234 1025; store a 1 2; store a 19 1941; store a 55 1946; store a 91 1952; store a 109 1953; store a
127 1954; store a 145 1953; store a 163 1954; store a 181 1953; store a 199 1954; store a 253 1955; store a 271
1956; store a 289 1957; store a 307 1958; store a 20 2604; store a 56 2634; store a 92 2654; store a 110 2657; store
a 128 2660; store a 146 2657; store a 164 2660; store a 182 2657; store a 200 2660; store a 21 2715; store a 39 2;
store a 57 2720; store a 93 2725; store a 111 2726; store a 129 2727; store a 147 2726; store a 165 2727; store a
183 2726; store a 201 2727; store a 255 2729; store a 273 2731; store a 291 2733; store a 309 2735; store a 22 3262;
store a 58 3292; store a 94 3312; store a 112 3315; store a 130 3318; store a 148 3315; store a 166 3318; store a
184 3315; store a 202 3318; store a 23 3358; store a 59 3363; store a 77 2; store a 95 3368; store a 113 3369; store
a 131 3370; store a 149 3369; store a 167 3370; store a 185 3369; store a 203 3370; store a 24 3384; store a 60
3389; store a 96 3394; store a 114 3395; store a 25 3409; store a 61 3414; store a 97 3419; store a 133 3395; store
a 26 3433; store a 62 3438; store a 98 3443; store a 152 3444; store a 27 3458; store a 63 3463; store a 99 3468;
store a 171 3444; store a 28 3482; store a 64 3487; store a 100 3492; store a 190 3493; store a 29 3507; store a 65
3512; store a 101 3517; store a 209 3493; store a 30 3518; store a 66 3520; store a 102 3521; store a 228 3522;
store a 31 3523; store a 67 3525; store a 103 3526; store a 247 3527; store a 32 3531; store a 68 3534; store a 104
3537; store a 33 3541; store a 69 3544; store a 105 3547; store a 34 3551; store a 70 3554; store a 106 3557; store
a 35 3561; store a 71 3564; store a 107 3567; store b 2 3588; store b 6 3593; store b 10 3598; store b 3 3619; store
b 7 3624; store b 11 3629; store by_c 13 90; store by_c 39 3630; store by_c 65 859; store by_c 14 3631; store by_c
40 1772; store by_c 66 3632; store by_c 15 1686; store by_c 41 3633; store by_c 67 1839; store by_c 16 1690; store
by_c 42 3634; store by_c 68 1842; store by_c 17 3635; store by_c 43 1783; store by_c 69 3636; store by_c 18 1699;
store by_c 44 3637; store by_c 70 1849; store by_c 19 3638; store by_c 45 1789; store by_c 71 3639; store by_c 20
3640; store by_c 46 1792; store by_c 72 3641; store by_c 21 1717; store by_c 47 3642; store by_c 73 1859; store by_c
22 1721; store by_c 48 3643; store by_c 74 1862; store by_c 23 3644; store by_c 49 1803; store by_c 75 3645; store
by_c 24 1730; store by_c 50 3646; store by_c 76 1869; store by_c 25 1734; store by_c 51 3647; store by_c 77 1872
    """,
)

BY_CONSTANTS = Graph(
    {'x': 14, 'u': 2, 'c': 13, 'z': 4, 'p': 226},
    {'by_k': 1944},
    """
constant 0.5249999999999999; constant -0.5249999999999999; input x 0; input p 17; mul 2 3; max 1 4; min 0 5;
constant 0.0; constant 0.35; sub 6 8; max 7 9; mul 10 10; constant -0.35; sub 12 6; max 7 13; mul 14 14; sub 11 15;
constant 1.0; div 17 8; mul 16 18; sub 6 19; mul 20 20; mul 20 21; input p 85; mul 22 23; constant
0.8999999999999999; constant -0.8999999999999999; input x 2; max 26 27; min 25 28; constant 0.6; sub 29 30; max 7
31; mul 32 32; constant -0.6; sub 34 29; max 7 35; mul 36 36; sub 33 37; div 17 30; mul 38 39; sub 29 40; mul 21 41;
input p 80; mul 42 43; add 24 44; mul 20 41; mul 41 46; input p 75; mul 47 48; add 45 49; mul 41 41; mul 41 51;
input p 86; mul 52 53; add 50 54; constant 1.25; constant 2.4000000000000004; constant -2.4000000000000004; input x
4; max 58 59; min 57 60; constant 1.6; sub 61 62; max 7 63; constant -1.6; sub 65 61; max 7 66; add 64 67; mul 56
68; sub 17 69; mul 55 70; input p 76; input p 77; constant 0.5; input p 12; mul 2 75; input p 6; mul 27 77; add 76
78; input p 10; mul 59 80; add 79 81; mul 2 82; mul 2 77; input p 7; mul 27 85; add 84 86; input p 8; mul 59 88; add
87 89; mul 27 90; add 83 91; mul 2 80; mul 27 88; add 93 94; input p 11; mul 59 96; add 95 97; mul 59 98; add 92 99;
mul 74 100; input p 78; constant 0.25; input p 69; mul 22 104; input p 70; mul 42 106; add 105 107; mul 64 64; mul
67 67; sub 109 110; div 17 62; mul 111 112; sub 61 113; mul 21 114; input p 71; mul 115 116; add 108 117; input p
72; mul 47 119; add 118 120; mul 46 114; input p 73; mul 122 123; add 121 124; input p 74; mul 52 126; add 125 127;
mul 51 114; mul 48 129; add 128 130; mul 20 131; input p 79; mul 22 133; mul 42 119; add 134 135; mul 43 115; add
136 137; input p 81; mul 47 139; add 138 140; input p 82; mul 122 142; add 141 143; input p 83; mul 52 145; add 144
146; input p 84; mul 129 148; add 147 149; mul 41 150; add 132 151; mul 55 114; add 152 153; mul 103 154; mul 102
155; add 101 156; add 73 157; input p 1; mul 27 159; mul 27 160; add 17 161; sqrt 162; div 17 163; input p 2; mul 27
165; mul 27 166; add 17 167; sqrt 168; mul 164 169; input p 87; mul 170 171; add 158 172; mul 27 164; input p 88;
mul 174 175; sub 173 176; input p 89; mul 170 175; input p 90; sub 179 180; mul 171 174; add 181 182; sub 183 2; mul
184 184; mul 177 177; add 185 186; sqrt 187; mul 178 188; sqrt 189; div 17 190; mul 191 191; mul 178 192; mul 177
193; input p 91; constant 2.0; mul 189 196; mul 192 196; mul 192 198; sub 197 199; mul 195 200; constant 0.3;
constant -0.3; constant 1.4; sub 189 204; max 203 205; min 202 206; input p 92; input p 93; mul 207 209; add 208
210; mul 207 211; add 17 212; mul 201 213; input u 0; input p 94; mul 215 216; input p 95; input p 96; mul 205 219;
add 218 220; mul 205 221; add 17 222; mul 217 223; sub 214 224; mul 178 225; input p 97; input x 6; mul 227 228;
input p 98; input x 8; mul 230 231; add 229 232; input p 99; input x 10; mul 234 235; add 233 236; constant -0.5;
mul 191 238; mul 191 239; mul 191 240; mul 178 241; input p 100; input p 101; mul 205 244; add 243 245; mul 205 246;
add 17 247; mul 242 248; mul 237 249; add 226 250; input p 102; mul 249 252; mul 249 253; input x 3; mul 163 169;
div 17 256; mul 164 257; sub 172 176; mul 184 259; add 179 182; mul 177 261; sub 260 262; mul 193 263; mul 258 264;
mul 255 265; input x 1; mul 184 193; mul 267 268; sub 266 269; constant 5.714285714285714; add 10 14; mul 271 272;
sub 17 273; mul 131 274; add 82 275; mul 267 276; constant 3.3333333333333335; add 32 36; mul 278 279; sub 17 280;
mul 150 281; mul 102 282; add 90 283; mul 255 284; add 277 285; input x 5; mul 71 102; add 98 288; mul 287 289; add
286 290; mul 194 291; add 270 292; mul 254 293; add 251 294; mul 194 295; input p 103; add 157 297; input p 104; mul
170 299; add 298 300; input p 105; mul 174 302; add 301 303; input p 106; mul 174 299; mul 170 302; input p 107; sub
307 308; sub 306 309; sub 310 2; mul 311 311; mul 304 304; add 312 313; sqrt 314; mul 305 315; sqrt 316; div 17 317;
mul 318 318; mul 305 319; mul 304 320; input p 108; mul 196 316; mul 196 319; mul 319 324; sub 323 325; mul 322 326;
sub 316 204; max 203 328; min 202 329; input p 109; input p 110; mul 330 332; add 331 333; mul 330 334; add 17 335;
mul 327 336; input u 1; input p 111; mul 338 339; input p 112; input p 113; mul 328 342; add 341 343; mul 328 344;
add 17 345; mul 340 346; sub 337 347; mul 305 348; input p 114; input x 7; mul 350 351; input p 115; input x 9; mul
353 354; add 352 355; input p 116; input x 11; mul 357 358; add 356 359; mul 238 318; mul 318 361; mul 318 362; mul
305 363; mul 244 328; add 243 365; mul 328 366; add 17 367; mul 364 368; mul 360 369; add 349 370; input p 117; mul
369 372; mul 369 373; add 300 303; mul 311 375; sub 307 306; mul 304 377; add 376 378; mul 320 379; mul 258 380; mul
255 381; mul 311 320; mul 267 383; sub 382 384; mul 291 321; add 385 386; mul 374 387; add 371 388; mul 321 389; add
296 390; sub 72 391; input p 4; input p 5; mul 174 258; mul 394 395; add 90 396; mul 98 397; mul 393 398; input p
13; mul 170 258; mul 394 401; mul 82 397; add 402 403; mul 393 404; add 400 405; mul 399 406; input p 0; input p 3;
mul 258 409; mul 258 410; add 408 411; mul 402 402; mul 397 397; add 413 414; mul 393 415; add 412 416; mul 82 98;
mul 393 418; mul 417 419; sub 407 420; input p 9; mul 98 98; mul 393 423; add 422 424; mul 417 425; mul 399 399; sub
426 427; mul 82 82; add 17 429; mul 393 430; mul 428 431; mul 406 425; mul 399 419; sub 433 434; mul 406 435; sub
432 436; mul 419 421; add 437 438; div 17 439; mul 421 440; mul 392 441; mul 435 440; mul 381 443; mul 428 440; mul
383 445; add 444 446; mul 289 441; mul 284 443; sub 448 449; mul 276 445; add 450 451; mul 321 452; sub 447 453; mul
374 454; mul 321 455; mul 265 443; mul 268 445; add 457 458; mul 194 452; sub 459 460; mul 254 461; mul 194 462; add
456 463; mul 287 464; add 442 465; mul 71 466; mul 291 455; mul 389 452; sub 468 469; mul 320 470; mul 389 443; mul
255 455; add 472 473; mul 258 474; mul 320 475; mul 377 476; add 471 477; mul 196 304; mul 196 315; div 17 480; mul
387 454; mul 373 482; mul 369 482; mul 372 484; add 483 485; mul 360 454; add 486 487; mul 364 488; mul 366 489; mul
328 489; mul 244 491; add 490 492; mul 305 454; mul 340 494; mul 344 495; sub 493 496; mul 328 495; mul 342 498; sub
497 499; le 203 328; le 328 203; add 501 502; div 17 503; mul 501 504; le 329 202; le 202 329; add 506 507; div 17
508; mul 506 509; mul 327 494; mul 334 511; mul 330 511; mul 332 513; add 512 514; mul 510 515; mul 505 516; add 500
517; mul 196 317; div 17 519; mul 318 363; mul 368 488; mul 305 522; mul 521 523; mul 318 523; mul 363 525; add 524
526; mul 318 525; mul 362 528; add 527 529; mul 196 318; mul 304 470; mul 389 445; mul 267 455; sub 533 534; mul 311
535; add 532 536; mul 379 475; add 537 538; mul 305 539; mul 336 494; mul 322 541; mul 324 542; sub 540 543; mul 319
542; neg 545; mul 196 546; add 544 547; mul 531 548; mul 319 549; add 530 550; mul 520 551; sub 518 552; mul 196
542; add 553 554; mul 305 555; mul 481 556; mul 479 557; add 478 558; sub 467 559; mul 255 464; mul 392 443; sub 561
562; mul 282 563; add 560 564; mul 291 462; mul 295 452; sub 566 567; mul 193 568; mul 295 443; mul 255 462; add 570
571; mul 258 572; mul 193 573; mul 261 574; sub 569 575; mul 177 196; mul 188 196; div 17 578; mul 293 461; mul 253
580; mul 249 580; mul 252 582; add 581 583; mul 237 461; add 584 585; mul 242 586; mul 246 587; mul 205 587; mul 244
589; add 588 590; mul 178 461; mul 217 592; mul 221 593; sub 591 594; mul 205 593; mul 219 596; sub 595 597; le 203
205; le 205 203; add 599 600; div 17 601; mul 599 602; le 206 202; le 202 206; add 604 605; div 17 606; mul 604 607;
mul 201 592; mul 211 609; mul 207 609; mul 209 611; add 610 612; mul 608 613; mul 603 614; add 598 615; mul 190 196;
div 17 617; mul 191 241; mul 248 586; mul 178 620; mul 619 621; mul 191 621; mul 241 623; add 622 624; mul 191 623;
mul 240 626; add 625 627; mul 191 196; mul 177 568; mul 295 445; mul 267 462; sub 631 632; mul 184 633; add 630 634;
mul 263 573; add 635 636; mul 178 637; mul 213 592; mul 195 639; mul 198 640; sub 638 641; mul 192 640; neg 643; mul
196 644; add 642 645; mul 629 646; mul 192 647; add 628 648; mul 618 649; sub 616 650; mul 196 640; add 651 652; mul
178 653; mul 579 654; mul 577 655; add 576 656; add 559 657; mul 155 658; add 565 659; mul 3 4; le 1 4; le 4 1; add
662 663; div 17 664; mul 662 665; le 5 0; le 0 5; add 667 668; div 17 669; mul 667 670; mul 102 658; mul 103 672;
mul 131 673; mul 102 563; mul 281 675; mul 41 673; add 676 677; mul 142 678; mul 392 445; mul 267 464; add 680 681;
mul 274 682; mul 20 673; add 683 684; mul 123 685; add 679 686; mul 114 687; mul 102 466; mul 70 689; mul 114 673;
add 690 691; mul 48 692; mul 139 678; add 693 694; mul 119 685; add 695 696; mul 41 697; add 688 698; mul 41 699;
add 674 700; mul 23 692; mul 133 678; add 702 703; mul 104 685; add 704 705; mul 21 706; add 701 707; mul 20 196;
mul 43 678; mul 116 685; add 710 711; mul 114 712; mul 43 692; mul 119 678; add 714 715; mul 106 685; add 716 717;
mul 41 718; add 713 719; mul 20 706; add 720 721; mul 709 722; add 708 723; le 7 13; le 13 7; add 725 726; div 17
727; mul 725 728; mul 14 196; constant 2.857142857142857; mul 724 731; mul 730 732; mul 131 682; mul 271 734; sub
733 735; mul 729 736; sub 724 737; le 7 9; le 9 7; add 739 740; div 17 741; mul 739 742; mul 10 196; mul 732 744;
add 735 745; mul 743 746; sub 738 747; mul 671 748; mul 666 749; mul 661 750; sub 660 751; sub 752 657; input p 18;
input p 19; input p 20; mul 4 756; input p 21; mul 27 758; add 757 759; input p 22; mul 59 761; add 760 762; mul 755
763; input p 23; mul 59 763; mul 765 766; add 764 767; input p 24; mul 59 766; mul 769 770; add 768 771; input p 25;
mul 763 763; mul 773 774; add 772 775; input p 26; mul 59 774; mul 777 778; add 776 779; input p 27; mul 763 774;
mul 781 782; add 780 783; input p 28; mul 4 785; add 784 786; input p 29; mul 4 59; mul 788 789; add 787 790; input
p 30; mul 59 789; mul 792 793; add 791 794; input p 31; mul 4 763; mul 796 797; add 795 798; input p 32; mul 59 797;
mul 800 801; add 799 802; input p 33; mul 763 797; mul 804 805; add 803 806; input p 34; mul 4 4; mul 763 809; mul
808 810; add 807 811; input p 35; mul 4 809; mul 813 814; add 812 815; input p 36; input p 37; mul 59 818; add 817
819; input p 38; mul 59 59; mul 821 822; add 820 823; input p 39; mul 59 822; mul 825 826; add 824 827; input p 40;
mul 763 829; add 828 830; input p 41; mul 766 832; add 831 833; input p 42; mul 770 835; add 834 836; input p 43;
mul 774 838; add 837 839; input p 44; mul 778 841; add 840 842; input p 45; mul 782 844; add 843 845; mul 4 755; add
846 847; mul 765 789; add 848 849; mul 769 793; add 850 851; input p 46; mul 797 853; add 852 854; input p 47; mul
801 856; add 855 857; input p 48; mul 805 859; add 858 860; input p 49; mul 809 862; add 861 863; input p 50; mul 59
809; mul 865 866; add 864 867; mul 804 810; add 868 869; input p 51; mul 814 871; add 870 872; mul 756 873; add 816
874; input p 52; mul 21 876; input p 53; mul 46 878; add 877 879; input p 54; mul 20 114; mul 881 882; add 880 883;
input p 55; mul 51 885; add 884 886; input p 56; mul 41 114; mul 888 889; add 887 890; input p 57; mul 114 114; mul
892 893; add 891 894; mul 114 893; mul 895 896; input p 58; mul 22 898; input p 59; mul 42 900; add 899 901; input p
60; mul 115 903; add 902 904; input p 61; mul 47 906; add 905 907; input p 62; mul 122 909; add 908 910; input p 63;
mul 114 882; mul 912 913; add 911 914; input p 64; mul 52 916; add 915 917; input p 65; mul 129 919; add 918 920;
input p 66; mul 114 889; mul 922 923; add 921 924; input p 67; mul 896 926; add 925 927; add 897 928; mul 274 929;
add 875 930; mul 754 931; input p 68; constant 12.0; mul 3 267; mul 934 935; constant -6.0; mul 756 935; mul 255
758; add 938 939; mul 287 761; add 940 941; mul 937 942; add 936 943; mul 933 944; mul 935 937; constant 4.0; mul
942 947; add 946 948; mul 933 949; mul 756 950; add 945 951; add 932 952; mul 3 953; mul 3 954; mul 445 955; add 753
956; mul 3 935; mul 443 758; mul 441 761; sub 959 960; mul 3 445; mul 756 962; sub 961 963; mul 933 964; mul 937
965; mul 947 965; mul 933 962; mul 937 968; sub 967 969; mul 756 970; add 966 971; mul 934 968; sub 972 973; mul 958
974; sub 957 975; input p 134; mul 443 754; mul 281 978; mul 977 979; input p 164; constant 3.0; mul 893 982; mul
441 754; mul 70 984; mul 983 985; mul 981 986; input p 158; mul 985 988; add 987 989; sub 980 990; mul 754 962; mul
274 992; mul 898 993; sub 991 994; mul 21 995; mul 896 979; mul 888 997; input p 154; mul 896 985; mul 999 1000; sub
998 1001; mul 922 979; mul 892 986; input p 160; mul 985 1005; add 1004 1006; sub 1003 1007; mul 912 993; sub 1008
1009; mul 114 1010; add 1002 1011; mul 896 993; mul 881 1013; sub 1012 1014; mul 114 1015; add 996 1016; input p
130; mul 997 1018; mul 888 1000; sub 1019 1020; input p 137; mul 979 1022; mul 888 986; input p 159; mul 985 1025;
add 1024 1026; sub 1023 1027; mul 909 993; sub 1028 1029; mul 114 1030; add 1021 1031; input p 136; mul 979 1033;
mul 885 986; mul 919 985; add 1035 1036; sub 1034 1037; mul 906 993; sub 1038 1039; mul 41 1040; add 1032 1041; mul
878 1013; sub 1042 1043; mul 41 1044; add 1017 1045; input p 129; mul 997 1047; input p 153; mul 1000 1049; sub 1048
1050; input p 135; mul 979 1052; mul 986 1049; mul 912 985; add 1054 1055; sub 1053 1056; mul 903 993; sub 1057
1058; mul 114 1059; add 1051 1060; mul 906 979; mul 986 1047; mul 985 1052; add 1063 1064; sub 1062 1065; mul 900
993; sub 1066 1067; mul 41 1068; add 1061 1069; mul 20 995; add 1070 1071; mul 876 1013; sub 1072 1073; mul 709
1074; add 1046 1075; mul 929 992; mul 271 1077; mul 731 1076; mul 730 1079; add 1078 1080; mul 729 1081; sub 1076
1082; mul 744 1079; sub 1078 1084; mul 743 1085; add 1083 1086; mul 671 1087; mul 666 1088; mul 661 1089; sub 976
1090; mul 758 978; mul 761 984; sub 1092 1093; mul 756 992; sub 1094 1095; mul 871 1096; mul 809 1097; mul 4 196;
mul 865 984; mul 763 1100; mul 1099 1101; mul 792 984; mul 59 1103; mul 1099 1104; add 1102 1105; input p 152; mul
984 1107; mul 1099 1108; add 1106 1109; mul 777 984; mul 763 1111; mul 763 1112; add 1110 1113; input p 151; mul 984
1115; mul 59 1116; mul 763 1117; add 1114 1118; mul 765 984; mul 763 1120; add 1119 1121; sub 1098 1122; mul 4 1097;
mul 1099 1124; add 1123 1125; mul 804 1096; mul 763 1127; mul 1099 1128; add 1126 1129; mul 865 1096; mul 59 1131;
mul 1099 1132; add 1130 1133; mul 862 1096; mul 1099 1135; add 1134 1136; mul 859 1096; mul 763 1138; mul 763 1139;
add 1137 1140; mul 856 1096; mul 59 1142; mul 763 1143; add 1141 1144; mul 853 1096; mul 763 1146; add 1145 1147;
mul 769 1096; mul 59 1149; mul 59 1150; add 1148 1151; mul 765 1096; mul 59 1153; add 1152 1154; mul 755 1096; add
1155 1156; mul 813 992; mul 809 1158; sub 1157 1159; mul 4 1158; mul 1099 1161; sub 1160 1162; mul 808 992; mul 763
1164; mul 1099 1165; sub 1163 1166; mul 804 992; mul 763 1168; mul 763 1169; sub 1167 1170; mul 800 992; mul 59
1172; mul 763 1173; sub 1171 1174; mul 796 992; mul 763 1176; sub 1175 1177; mul 792 992; mul 59 1179; mul 59 1180;
sub 1178 1181; mul 788 992; mul 59 1183; sub 1182 1184; mul 785 992; sub 1185 1186; mul 809 1127; mul 809 1100; mul
797 1111; add 1189 1190; mul 4 1112; add 1191 1192; mul 4 1117; add 1193 1194; mul 4 1120; add 1195 1196; input p
150; mul 984 1198; mul 774 1199; add 1197 1200; mul 196 763; mul 763 1199; mul 1202 1203; add 1201 1204; mul 835
984; mul 59 1206; mul 1202 1207; add 1205 1208; input p 149; mul 984 1210; mul 1202 1211; add 1209 1212; input p
148; mul 984 1214; mul 59 1215; mul 59 1216; add 1213 1217; input p 147; mul 984 1219; mul 59 1220; add 1218 1221;
mul 818 984; add 1222 1223; sub 1188 1224; mul 797 1138; add 1225 1226; mul 4 1139; add 1227 1228; mul 4 1143; add
1229 1230; mul 4 1146; add 1231 1232; mul 844 1096; mul 774 1234; add 1233 1235; mul 763 1234; mul 1202 1237; add
1236 1238; mul 841 1096; mul 59 1240; mul 1202 1241; add 1239 1242; mul 838 1096; mul 1202 1244; add 1243 1245; mul
835 1096; mul 59 1247; mul 59 1248; add 1246 1249; mul 832 1096; mul 59 1251; add 1250 1252; mul 829 1096; add 1253
1254; mul 809 1164; sub 1255 1256; mul 797 1168; sub 1257 1258; mul 4 1169; sub 1259 1260; mul 4 1173; sub 1261
1262; mul 4 1176; sub 1263 1264; mul 781 992; mul 774 1266; sub 1265 1267; mul 763 1266; mul 1202 1269; sub 1268
1270; mul 777 992; mul 59 1272; mul 1202 1273; sub 1271 1274; mul 773 992; mul 1202 1276; sub 1275 1277; mul 769
992; mul 59 1279; mul 59 1280; sub 1278 1281; mul 765 992; mul 59 1283; sub 1282 1284; mul 755 992; sub 1285 1286;
mul 756 1287; add 1187 1288; mul 661 1289; sub 1091 1290; input p 212; input c 4; input p 14; mul 2 1294; sub 27
1295; input c 5; mul 1296 1297; sub 1293 1298; input c 6; mul 215 1300; add 1299 1301; input c 7; mul 338 1303; add
1302 1304; input c 8; input p 15; max 1306 1307; mul 267 1294; sub 255 1309; mul 1308 1310; sub 1305 1311; mul 445
1312; mul 445 1294; add 443 1314; mul 1308 1315; mul 267 1316; add 1313 1317; mul 1297 1315; input c 9; input c 10;
mul 74 1321; mul 1296 1322; sub 1320 1323; input c 11; mul 215 1325; add 1324 1326; input c 12; mul 338 1328; add
1327 1329; mul 445 1330; add 1319 1331; mul 445 1296; mul 1322 1333; sub 1332 1334; mul 2 1335; add 1318 1336; mul
1292 1337; add 1291 1338; mul 425 431; mul 419 419; sub 1340 1341; mul 440 1342; mul 392 1343; mul 381 1343; mul 383
443; add 1345 1346; mul 284 1343; mul 399 431; mul 406 419; sub 1349 1350; mul 440 1351; mul 289 1352; sub 1348
1353; mul 276 443; sub 1354 1355; mul 321 1356; add 1347 1357; mul 374 1358; mul 321 1359; mul 265 1343; mul 268
443; add 1361 1362; mul 194 1356; add 1363 1364; mul 254 1365; mul 194 1366; add 1360 1367; mul 255 1368; sub 1344
1369; mul 282 1370; mul 305 1358; mul 340 1372; mul 344 1373; mul 387 1358; mul 373 1375; mul 369 1375; mul 372
1377; add 1376 1378; mul 360 1358; add 1379 1380; mul 364 1381; mul 366 1382; mul 328 1382; mul 244 1384; add 1383
1385; sub 1374 1386; mul 328 1373; mul 342 1388; add 1387 1389; mul 327 1372; mul 334 1391; mul 330 1391; mul 332
1393; add 1392 1394; mul 510 1395; mul 505 1396; sub 1390 1397; mul 368 1381; mul 305 1399; mul 521 1400; mul 318
1400; mul 363 1402; add 1401 1403; mul 318 1402; mul 362 1405; add 1404 1406; mul 267 1359; sub 1408 472; mul 311
1409; mul 389 1356; mul 291 1359; add 1411 1412; mul 304 1413; sub 1410 1414; mul 389 1343; mul 255 1359; add 1416
1417; mul 258 1418; mul 379 1419; sub 1415 1420; mul 305 1421; mul 336 1372; mul 322 1423; mul 324 1424; add 1422
1425; mul 319 1424; mul 196 1427; add 1426 1428; mul 531 1429; mul 319 1430; sub 1407 1431; mul 520 1432; add 1398
1433; neg 1424; mul 196 1435; add 1434 1436; mul 305 1437; mul 481 1438; mul 479 1439; mul 320 1413; mul 320 1419;
mul 377 1442; add 1441 1443; sub 1440 1444; mul 392 1352; mul 287 1368; add 1446 1447; mul 71 1448; add 1445 1449;
sub 1371 1450; mul 295 1343; mul 255 1366; add 1452 1453; mul 258 1454; mul 193 1455; mul 261 1456; mul 295 1356;
mul 291 1366; add 1458 1459; mul 193 1460; sub 1457 1461; mul 178 1365; mul 217 1463; mul 221 1464; mul 293 1365;
mul 253 1466; mul 249 1466; mul 252 1468; add 1467 1469; mul 237 1365; add 1470 1471; mul 242 1472; mul 246 1473;
mul 205 1473; mul 244 1475; add 1474 1476; sub 1465 1477; mul 205 1464; mul 219 1479; add 1478 1480; mul 201 1463;
mul 211 1482; mul 207 1482; mul 209 1484; add 1483 1485; mul 608 1486; mul 603 1487; sub 1481 1488; mul 248 1472;
mul 178 1490; mul 619 1491; mul 191 1491; mul 241 1493; add 1492 1494; mul 191 1493; mul 240 1496; add 1495 1497;
mul 267 1366; sub 1499 570; mul 184 1500; mul 177 1460; sub 1501 1502; mul 263 1455; sub 1503 1504; mul 178 1505;
mul 213 1463; mul 195 1507; mul 198 1508; add 1506 1509; mul 192 1508; mul 196 1511; add 1510 1512; mul 629 1513;
mul 192 1514; sub 1498 1515; mul 618 1516; add 1489 1517; neg 1508; mul 196 1519; add 1518 1520; mul 178 1521; mul
579 1522; mul 577 1523; add 1462 1524; add 1445 1525; mul 155 1526; add 1451 1527; mul 102 1526; mul 103 1529; mul
131 1530; mul 102 1370; mul 281 1532; mul 41 1530; add 1533 1534; mul 142 1535; mul 20 1530; mul 267 1368; add 562
1538; mul 274 1539; sub 1537 1540; mul 123 1541; add 1536 1542; mul 114 1543; mul 114 1530; mul 102 1448; mul 70
1546; sub 1545 1547; mul 48 1548; mul 139 1535; add 1549 1550; mul 119 1541; add 1551 1552; mul 41 1553; add 1544
1554; mul 41 1555; add 1531 1556; mul 23 1548; mul 133 1535; add 1558 1559; mul 104 1541; add 1560 1561; mul 21
1562; add 1557 1563; mul 43 1535; mul 116 1541; add 1565 1566; mul 114 1567; mul 43 1548; mul 119 1535; add 1569
1570; mul 106 1541; add 1571 1572; mul 41 1573; add 1568 1574; mul 20 1562; add 1575 1576; mul 709 1577; add 1564
1578; mul 131 1539; mul 271 1580; mul 731 1579; mul 730 1582; add 1581 1583; mul 729 1584; sub 1579 1585; mul 744
1582; sub 1581 1587; mul 743 1588; add 1586 1589; mul 671 1590; mul 666 1591; mul 661 1592; sub 1528 1593; sub 1594
1525; mul 443 955; sub 1595 1596; mul 761 1352; mul 758 1343; sub 1598 1599; mul 3 443; mul 756 1601; add 1600 1602;
mul 933 1603; mul 937 1604; mul 947 1604; mul 933 1601; mul 937 1607; add 1606 1608; mul 756 1609; add 1605 1610;
mul 934 1607; add 1611 1612; mul 958 1613; sub 1597 1614; mul 754 1352; mul 70 1616; mul 983 1617; mul 981 1618; mul
988 1617; add 1619 1620; mul 754 1343; mul 281 1622; mul 977 1623; sub 1621 1624; mul 754 1601; mul 274 1626; mul
898 1627; add 1625 1628; mul 21 1629; mul 896 1617; mul 999 1631; mul 896 1623; mul 888 1633; sub 1632 1634; mul 892
1618; mul 1005 1617; add 1636 1637; mul 922 1623; sub 1638 1639; mul 912 1627; add 1640 1641; mul 114 1642; add 1635
1643; mul 896 1627; mul 881 1645; add 1644 1646; mul 114 1647; add 1630 1648; mul 888 1631; mul 1018 1633; sub 1650
1651; mul 888 1618; mul 1025 1617; add 1653 1654; mul 1022 1623; sub 1655 1656; mul 909 1627; add 1657 1658; mul 114
1659; add 1652 1660; mul 885 1618; mul 919 1617; add 1662 1663; mul 1033 1623; sub 1664 1665; mul 906 1627; add 1666
1667; mul 41 1668; add 1661 1669; mul 878 1645; add 1670 1671; mul 41 1672; add 1649 1673; mul 1049 1631; mul 1047
1633; sub 1675 1676; mul 1049 1618; mul 912 1617; add 1678 1679; mul 1052 1623; sub 1680 1681; mul 903 1627; add
1682 1683; mul 114 1684; add 1677 1685; mul 1047 1618; mul 1052 1617; add 1687 1688; mul 906 1623; sub 1689 1690;
mul 900 1627; add 1691 1692; mul 41 1693; add 1686 1694; mul 20 1629; add 1695 1696; mul 876 1645; add 1697 1698;
mul 709 1699; add 1674 1700; mul 731 1701; mul 730 1702; mul 929 1626; mul 271 1704; sub 1703 1705; mul 729 1706;
sub 1701 1707; mul 744 1702; add 1705 1709; mul 743 1710; sub 1708 1711; mul 671 1712; mul 666 1713; mul 661 1714;
sub 1615 1715; mul 865 1616; mul 763 1717; mul 1099 1718; mul 792 1616; mul 59 1720; mul 1099 1721; add 1719 1722;
mul 1107 1616; mul 1099 1724; add 1723 1725; mul 777 1616; mul 763 1727; mul 763 1728; add 1726 1729; mul 1115 1616;
mul 59 1731; mul 763 1732; add 1730 1733; mul 765 1616; mul 763 1735; add 1734 1736; mul 761 1616; mul 758 1622; sub
1738 1739; mul 756 1626; add 1740 1741; mul 871 1742; mul 809 1743; add 1737 1744; mul 4 1743; mul 1099 1746; add
1745 1747; mul 804 1742; mul 763 1749; mul 1099 1750; add 1748 1751; mul 865 1742; mul 59 1753; mul 1099 1754; add
1752 1755; mul 862 1742; mul 1099 1757; add 1756 1758; mul 859 1742; mul 763 1760; mul 763 1761; add 1759 1762; mul
856 1742; mul 59 1764; mul 763 1765; add 1763 1766; mul 853 1742; mul 763 1768; add 1767 1769; mul 769 1742; mul 59
1771; mul 59 1772; add 1770 1773; mul 765 1742; mul 59 1775; add 1774 1776; mul 755 1742; add 1777 1778; mul 813
1626; mul 809 1780; add 1779 1781; mul 4 1780; mul 1099 1783; add 1782 1784; mul 808 1626; mul 763 1786; mul 1099
1787; add 1785 1788; mul 804 1626; mul 763 1790; mul 763 1791; add 1789 1792; mul 800 1626; mul 59 1794; mul 763
1795; add 1793 1796; mul 796 1626; mul 763 1798; add 1797 1799; mul 792 1626; mul 59 1801; mul 59 1802; add 1800
1803; mul 788 1626; mul 59 1805; add 1804 1806; mul 785 1626; add 1807 1808; mul 809 1717; mul 797 1727; add 1810
1811; mul 4 1728; add 1812 1813; mul 4 1732; add 1814 1815; mul 4 1735; add 1816 1817; mul 1198 1616; mul 774 1819;
add 1818 1820; mul 763 1819; mul 1202 1822; add 1821 1823; mul 835 1616; mul 59 1825; mul 1202 1826; add 1824 1827;
mul 1210 1616; mul 1202 1829; add 1828 1830; mul 1214 1616; mul 59 1832; mul 59 1833; add 1831 1834; mul 1219 1616;
mul 59 1836; add 1835 1837; mul 818 1616; add 1838 1839; mul 809 1749; add 1840 1841; mul 797 1760; add 1842 1843;
mul 4 1761; add 1844 1845; mul 4 1765; add 1846 1847; mul 4 1768; add 1848 1849; mul 844 1742; mul 774 1851; add
1850 1852; mul 763 1851; mul 1202 1854; add 1853 1855; mul 841 1742; mul 59 1857; mul 1202 1858; add 1856 1859; mul
838 1742; mul 1202 1861; add 1860 1862; mul 835 1742; mul 59 1864; mul 59 1865; add 1863 1866; mul 832 1742; mul 59
1868; add 1867 1869; mul 829 1742; add 1870 1871; mul 809 1786; add 1872 1873; mul 797 1790; add 1874 1875; mul 4
1791; add 1876 1877; mul 4 1795; add 1878 1879; mul 4 1798; add 1880 1881; mul 781 1626; mul 774 1883; add 1882
1884; mul 763 1883; mul 1202 1886; add 1885 1887; mul 777 1626; mul 59 1889; mul 1202 1890; add 1888 1891; mul 773
1626; mul 1202 1893; add 1892 1894; mul 769 1626; mul 59 1896; mul 59 1897; add 1895 1898; mul 765 1626; mul 59
1900; add 1899 1901; mul 755 1626; add 1902 1903; mul 756 1904; add 1809 1905; mul 661 1906; sub 1716 1907; mul 443
1312; mul 443 1294; add 1343 1910; mul 1308 1911; mul 267 1912; add 1909 1913; mul 443 1296; mul 1322 1915; mul 1297
1911; mul 443 1330; add 1917 1918; sub 1916 1919; mul 2 1920; sub 1914 1921; mul 1292 1922; sub 1908 1923; mul 417
431; mul 406 406; sub 1925 1926; mul 440 1927; mul 392 1928; mul 381 1352; mul 383 441; add 1930 1931; mul 289 1928;
mul 284 1352; sub 1933 1934; mul 276 441; add 1935 1936; mul 321 1937; sub 1932 1938; mul 374 1939; mul 321 1940;
mul 265 1352; mul 268 441; add 1942 1943; mul 194 1937; sub 1944 1945; mul 254 1946; mul 194 1947; add 1941 1948;
mul 287 1949; add 1929 1950; mul 71 1951; mul 291 1940; mul 389 1937; sub 1953 1954; mul 320 1955; mul 389 1352; mul
255 1940; add 1957 1958; mul 258 1959; mul 320 1960; mul 377 1961; add 1956 1962; mul 387 1939; mul 373 1964; mul
369 1964; mul 372 1966; add 1965 1967; mul 360 1939; add 1968 1969; mul 364 1970; mul 366 1971; mul 328 1971; mul
244 1973; add 1972 1974; mul 305 1939; mul 340 1976; mul 344 1977; sub 1975 1978; mul 328 1977; mul 342 1980; sub
1979 1981; mul 327 1976; mul 334 1983; mul 330 1983; mul 332 1985; add 1984 1986; mul 510 1987; mul 505 1988; add
1982 1989; mul 368 1970; mul 305 1991; mul 521 1992; mul 318 1992; mul 363 1994; add 1993 1995; mul 318 1994; mul
362 1997; add 1996 1998; mul 304 1955; mul 389 441; mul 267 1940; sub 2001 2002; mul 311 2003; add 2000 2004; mul
379 1960; add 2005 2006; mul 305 2007; mul 336 1976; mul 322 2009; mul 324 2010; sub 2008 2011; mul 319 2010; neg
2013; mul 196 2014; add 2012 2015; mul 531 2016; mul 319 2017; add 1999 2018; mul 520 2019; sub 1990 2020; mul 196
2010; add 2021 2022; mul 305 2023; mul 481 2024; mul 479 2025; add 1963 2026; sub 1952 2027; mul 255 1949; sub 2029
1446; mul 282 2030; add 2028 2031; mul 291 1947; mul 295 1937; sub 2033 2034; mul 193 2035; mul 295 1352; mul 255
1947; add 2037 2038; mul 258 2039; mul 193 2040; mul 261 2041; sub 2036 2042; mul 293 1946; mul 253 2044; mul 249
2044; mul 252 2046; add 2045 2047; mul 237 1946; add 2048 2049; mul 242 2050; mul 246 2051; mul 205 2051; mul 244
2053; add 2052 2054; mul 178 1946; mul 217 2056; mul 221 2057; sub 2055 2058; mul 205 2057; mul 219 2060; sub 2059
2061; mul 201 2056; mul 211 2063; mul 207 2063; mul 209 2065; add 2064 2066; mul 608 2067; mul 603 2068; add 2062
2069; mul 248 2050; mul 178 2071; mul 619 2072; mul 191 2072; mul 241 2074; add 2073 2075; mul 191 2074; mul 240
2077; add 2076 2078; mul 177 2035; mul 295 441; mul 267 1947; sub 2081 2082; mul 184 2083; add 2080 2084; mul 263
2040; add 2085 2086; mul 178 2087; mul 213 2056; mul 195 2089; mul 198 2090; sub 2088 2091; mul 192 2090; neg 2093;
mul 196 2094; add 2092 2095; mul 629 2096; mul 192 2097; add 2079 2098; mul 618 2099; sub 2070 2100; mul 196 2090;
add 2101 2102; mul 178 2103; mul 579 2104; mul 577 2105; add 2043 2106; add 2027 2107; mul 155 2108; add 2032 2109;
mul 102 2108; mul 103 2111; mul 131 2112; mul 102 2030; mul 281 2114; mul 41 2112; add 2115 2116; mul 142 2117; mul
267 1949; add 442 2119; mul 274 2120; mul 20 2112; add 2121 2122; mul 123 2123; add 2118 2124; mul 114 2125; mul 102
1951; mul 70 2127; mul 114 2112; add 2128 2129; mul 48 2130; mul 139 2117; add 2131 2132; mul 119 2123; add 2133
2134; mul 41 2135; add 2126 2136; mul 41 2137; add 2113 2138; mul 23 2130; mul 133 2117; add 2140 2141; mul 104
2123; add 2142 2143; mul 21 2144; add 2139 2145; mul 43 2117; mul 116 2123; add 2147 2148; mul 114 2149; mul 43
2130; mul 119 2117; add 2151 2152; mul 106 2123; add 2153 2154; mul 41 2155; add 2150 2156; mul 20 2144; add 2157
2158; mul 709 2159; add 2146 2160; mul 731 2161; mul 730 2162; mul 131 2120; mul 271 2164; sub 2163 2165; mul 729
2166; sub 2161 2167; mul 744 2162; add 2165 2169; mul 743 2170; sub 2168 2171; mul 671 2172; mul 666 2173; mul 661
2174; sub 2110 2175; sub 2176 2107; mul 441 955; add 2177 2178; mul 758 1352; mul 761 1928; sub 2180 2181; mul 3
441; mul 756 2183; sub 2182 2184; mul 933 2185; mul 937 2186; mul 947 2186; mul 933 2183; mul 937 2189; sub 2188
2190; mul 756 2191; add 2187 2192; mul 934 2189; sub 2193 2194; mul 958 2195; sub 2179 2196; mul 281 1616; mul 977
2198; mul 754 1928; mul 70 2200; mul 983 2201; mul 981 2202; mul 988 2201; add 2203 2204; sub 2199 2205; mul 754
2183; mul 274 2207; mul 898 2208; sub 2206 2209; mul 21 2210; mul 896 2198; mul 888 2212; mul 896 2201; mul 999
2214; sub 2213 2215; mul 922 2198; mul 892 2202; mul 1005 2201; add 2218 2219; sub 2217 2220; mul 912 2208; sub 2221
2222; mul 114 2223; add 2216 2224; mul 896 2208; mul 881 2226; sub 2225 2227; mul 114 2228; add 2211 2229; mul 1018
2212; mul 888 2214; sub 2231 2232; mul 1022 2198; mul 888 2202; mul 1025 2201; add 2235 2236; sub 2234 2237; mul 909
2208; sub 2238 2239; mul 114 2240; add 2233 2241; mul 1033 2198; mul 885 2202; mul 919 2201; add 2244 2245; sub 2243
2246; mul 906 2208; sub 2247 2248; mul 41 2249; add 2242 2250; mul 878 2226; sub 2251 2252; mul 41 2253; add 2230
2254; mul 1047 2212; mul 1049 2214; sub 2256 2257; mul 1052 2198; mul 1049 2202; mul 912 2201; add 2260 2261; sub
2259 2262; mul 903 2208; sub 2263 2264; mul 114 2265; add 2258 2266; mul 906 2198; mul 1047 2202; mul 1052 2201; add
2269 2270; sub 2268 2271; mul 900 2208; sub 2272 2273; mul 41 2274; add 2267 2275; mul 20 2210; add 2276 2277; mul
876 2226; sub 2278 2279; mul 709 2280; add 2255 2281; mul 929 2207; mul 271 2283; mul 731 2282; mul 730 2285; add
2284 2286; mul 729 2287; sub 2282 2288; mul 744 2285; sub 2284 2290; mul 743 2291; add 2289 2292; mul 671 2293; mul
666 2294; mul 661 2295; sub 2197 2296; mul 758 1616; mul 761 2200; sub 2298 2299; mul 756 2207; sub 2300 2301; mul
871 2302; mul 809 2303; mul 865 2200; mul 763 2305; mul 1099 2306; mul 792 2200; mul 59 2308; mul 1099 2309; add
2307 2310; mul 1107 2200; mul 1099 2312; add 2311 2313; mul 777 2200; mul 763 2315; mul 763 2316; add 2314 2317; mul
1115 2200; mul 59 2319; mul 763 2320; add 2318 2321; mul 765 2200; mul 763 2323; add 2322 2324; sub 2304 2325; mul 4
2303; mul 1099 2327; add 2326 2328; mul 804 2302; mul 763 2330; mul 1099 2331; add 2329 2332; mul 865 2302; mul 59
2334; mul 1099 2335; add 2333 2336; mul 862 2302; mul 1099 2338; add 2337 2339; mul 859 2302; mul 763 2341; mul 763
2342; add 2340 2343; mul 856 2302; mul 59 2345; mul 763 2346; add 2344 2347; mul 853 2302; mul 763 2349; add 2348
2350; mul 769 2302; mul 59 2352; mul 59 2353; add 2351 2354; mul 765 2302; mul 59 2356; add 2355 2357; mul 755 2302;
add 2358 2359; mul 813 2207; mul 809 2361; sub 2360 2362; mul 4 2361; mul 1099 2364; sub 2363 2365; mul 808 2207;
mul 763 2367; mul 1099 2368; sub 2366 2369; mul 804 2207; mul 763 2371; mul 763 2372; sub 2370 2373; mul 800 2207;
mul 59 2375; mul 763 2376; sub 2374 2377; mul 796 2207; mul 763 2379; sub 2378 2380; mul 792 2207; mul 59 2382; mul
59 2383; sub 2381 2384; mul 788 2207; mul 59 2386; sub 2385 2387; mul 785 2207; sub 2388 2389; mul 809 2330; mul 809
2305; mul 797 2315; add 2392 2393; mul 4 2316; add 2394 2395; mul 4 2320; add 2396 2397; mul 4 2323; add 2398 2399;
mul 1198 2200; mul 774 2401; add 2400 2402; mul 763 2401; mul 1202 2404; add 2403 2405; mul 835 2200; mul 59 2407;
mul 1202 2408; add 2406 2409; mul 1210 2200; mul 1202 2411; add 2410 2412; mul 1214 2200; mul 59 2414; mul 59 2415;
add 2413 2416; mul 1219 2200; mul 59 2418; add 2417 2419; mul 818 2200; add 2420 2421; sub 2391 2422; mul 797 2341;
add 2423 2424; mul 4 2342; add 2425 2426; mul 4 2346; add 2427 2428; mul 4 2349; add 2429 2430; mul 844 2302; mul
774 2432; add 2431 2433; mul 763 2432; mul 1202 2435; add 2434 2436; mul 841 2302; mul 59 2438; mul 1202 2439; add
2437 2440; mul 838 2302; mul 1202 2442; add 2441 2443; mul 835 2302; mul 59 2445; mul 59 2446; add 2444 2447; mul
832 2302; mul 59 2449; add 2448 2450; mul 829 2302; add 2451 2452; mul 809 2367; sub 2453 2454; mul 797 2371; sub
2455 2456; mul 4 2372; sub 2457 2458; mul 4 2376; sub 2459 2460; mul 4 2379; sub 2461 2462; mul 781 2207; mul 774
2464; sub 2463 2465; mul 763 2464; mul 1202 2467; sub 2466 2468; mul 777 2207; mul 59 2470; mul 1202 2471; sub 2469
2472; mul 773 2207; mul 1202 2474; sub 2473 2475; mul 769 2207; mul 59 2477; mul 59 2478; sub 2476 2479; mul 765
2207; mul 59 2481; sub 2480 2482; mul 755 2207; sub 2483 2484; mul 756 2485; add 2390 2486; mul 661 2487; sub 2297
2488; mul 441 1312; mul 441 1294; add 1352 2491; mul 1308 2492; mul 267 2493; add 2490 2494; mul 1297 2492; mul 441
1330; add 2496 2497; mul 441 1296; mul 1322 2499; sub 2498 2500; mul 2 2501; add 2495 2502; mul 1292 2503; add 2489
2504; mul 194 249; mul 287 2506; mul 71 2507; mul 255 2506; mul 282 2509; add 2508 2510; mul 249 291; mul 193 2512;
mul 249 255; mul 258 2514; mul 193 2515; mul 261 2516; sub 2513 2517; mul 242 293; mul 246 2519; mul 205 2519; mul
244 2521; add 2520 2522; mul 248 293; mul 178 2524; mul 619 2525; mul 191 2525; mul 241 2527; add 2526 2528; mul 191
2527; mul 240 2530; add 2529 2531; mul 177 2512; mul 249 267; mul 184 2534; sub 2533 2535; mul 263 2515; add 2536
2537; mul 178 2538; mul 629 2539; mul 192 2540; add 2532 2541; mul 618 2542; sub 2523 2543; mul 178 2544; mul 579
2545; mul 577 2546; add 2518 2547; mul 155 2548; add 2511 2549; mul 102 2548; mul 103 2551; mul 131 2552; mul 102
2509; mul 281 2554; mul 41 2552; add 2555 2556; mul 142 2557; mul 267 2506; mul 274 2559; mul 20 2552; add 2560
2561; mul 123 2562; add 2558 2563; mul 114 2564; mul 102 2507; mul 70 2566; mul 114 2552; add 2567 2568; mul 48
2569; mul 139 2557; add 2570 2571; mul 119 2562; add 2572 2573; mul 41 2574; add 2565 2575; mul 41 2576; add 2553
2577; mul 23 2569; mul 133 2557; add 2579 2580; mul 104 2562; add 2581 2582; mul 21 2583; add 2578 2584; mul 43
2557; mul 116 2562; add 2586 2587; mul 114 2588; mul 43 2569; mul 119 2557; add 2590 2591; mul 106 2562; add 2592
2593; mul 41 2594; add 2589 2595; mul 20 2583; add 2596 2597; mul 709 2598; add 2585 2599; mul 731 2600; mul 730
2601; mul 131 2559; mul 271 2603; sub 2602 2604; mul 729 2605; sub 2600 2606; mul 744 2601; add 2604 2608; mul 743
2609; sub 2607 2610; mul 671 2611; mul 666 2612; mul 661 2613; sub 2550 2614; sub 2615 2548; mul 321 369; mul 287
2617; mul 71 2618; mul 291 369; mul 320 2620; mul 255 369; mul 258 2622; mul 320 2623; mul 377 2624; add 2621 2625;
mul 364 387; mul 366 2627; mul 328 2627; mul 244 2629; add 2628 2630; mul 368 387; mul 305 2632; mul 521 2633; mul
318 2633; mul 363 2635; add 2634 2636; mul 318 2635; mul 362 2638; add 2637 2639; mul 304 2620; mul 267 369; mul 311
2642; sub 2641 2643; mul 379 2623; add 2644 2645; mul 305 2646; mul 531 2647; mul 319 2648; add 2640 2649; mul 520
2650; sub 2631 2651; mul 305 2652; mul 481 2653; mul 479 2654; add 2626 2655; sub 2619 2656; mul 255 2617; mul 282
2658; add 2657 2659; mul 155 2656; add 2660 2661; mul 102 2656; mul 103 2663; mul 131 2664; mul 102 2658; mul 281
2666; mul 41 2664; add 2667 2668; mul 142 2669; mul 267 2617; mul 274 2671; mul 20 2664; add 2672 2673; mul 123
2674; add 2670 2675; mul 114 2676; mul 102 2618; mul 70 2678; mul 114 2664; add 2679 2680; mul 48 2681; mul 139
2669; add 2682 2683; mul 119 2674; add 2684 2685; mul 41 2686; add 2677 2687; mul 41 2688; add 2665 2689; mul 23
2681; mul 133 2669; add 2691 2692; mul 104 2674; add 2693 2694; mul 21 2695; add 2690 2696; mul 43 2669; mul 116
2674; add 2698 2699; mul 114 2700; mul 43 2681; mul 119 2669; add 2702 2703; mul 106 2674; add 2704 2705; mul 41
2706; add 2701 2707; mul 20 2695; add 2708 2709; mul 709 2710; add 2697 2711; mul 731 2712; mul 730 2713; mul 131
2671; mul 271 2715; sub 2714 2716; mul 729 2717; sub 2712 2718; mul 744 2713; add 2716 2720; mul 743 2721; sub 2719
2722; mul 671 2723; mul 666 2724; mul 661 2725; sub 2662 2726; mul 758 873; mul 21 1047; mul 46 1018; add 2729 2730;
mul 882 888; add 2731 2732; input p 131; mul 51 2734; add 2733 2735; input p 132; mul 889 2737; add 2736 2738; input
p 133; mul 893 2740; add 2739 2741; mul 896 2742; mul 22 977; mul 42 906; add 2744 2745; mul 115 1052; add 2746
2747; mul 47 1033; add 2748 2749; mul 122 1022; add 2750 2751; mul 913 922; add 2752 2753; input p 138; mul 52 2755;
add 2754 2756; input p 139; mul 129 2758; add 2757 2759; input p 140; mul 923 2761; add 2760 2762; input p 141; mul
896 2764; add 2763 2765; add 2743 2766; mul 281 2767; add 2728 2768; mul 443 2769; input p 144; mul 59 2771; input p
145; mul 822 2773; add 2772 2774; input p 146; mul 826 2776; add 2775 2777; mul 763 818; add 2778 2779; mul 766
1219; add 2780 2781; mul 770 1214; add 2782 2783; mul 774 1210; add 2784 2785; mul 778 835; add 2786 2787; mul 782
1198; add 2788 2789; mul 765 797; add 2790 2791; mul 801 1115; add 2792 2793; mul 777 805; add 2794 2795; mul 809
1107; add 2796 2797; mul 792 866; add 2798 2799; mul 810 865; add 2800 2801; mul 761 873; add 2802 2803; mul 21
1049; mul 46 888; add 2805 2806; mul 882 999; add 2807 2808; input p 155; mul 51 2810; add 2809 2811; input p 156;
mul 889 2813; add 2812 2814; input p 157; mul 893 2816; add 2815 2817; mul 896 2818; mul 22 988; mul 42 1052; add
2820 2821; mul 115 912; add 2822 2823; mul 47 919; add 2824 2825; mul 122 1025; add 2826 2827; mul 913 1005; add
2828 2829; input p 161; mul 52 2831; add 2830 2832; mul 129 2761; add 2833 2834; input p 162; mul 923 2836; add 2835
2837; input p 163; mul 896 2839; add 2838 2840; add 2819 2841; mul 22 981; mul 42 1047; add 2843 2844; mul 115 1049;
add 2845 2846; mul 47 885; add 2847 2848; mul 122 888; add 2849 2850; mul 892 913; add 2851 2852; input p 165; mul
52 2854; add 2853 2855; mul 129 2810; add 2856 2857; mul 923 2740; add 2858 2859; input p 166; mul 896 2861; add
2860 2862; mul 983 2863; add 2842 2864; mul 70 2865; add 2804 2866; mul 441 2867; sub 2770 2868; mul 931 962; sub
2869 2870; mul 1352 2867; mul 1343 2769; sub 2872 2873; mul 931 1601; add 2874 2875; mul 1352 2769; mul 1928 2867;
sub 2877 2878; mul 931 2183; sub 2879 2880; mul 949 964; constant 0.8; mul 287 441; mul 2883 2884; sub 2882 2885;
mul 944 962; sub 2886 2887; constant -2.0; mul 1310 1315; le 1306 1307; le 1307 1306; add 2891 2892; div 17 2893;
mul 2891 2894; mul 2890 2895; mul 2889 2896; add 2888 2897; mul 287 1352; mul 2883 2899; mul 949 1603; add 2900
2901; mul 944 1601; add 2902 2903; mul 1310 1911; mul 2895 2905; mul 2889 2906; sub 2904 2907; mul 949 2185; mul 287
1928; mul 2883 2910; sub 2909 2911; mul 944 2183; sub 2912 2913; mul 1310 2492; mul 2895 2915; mul 2889 2916; add
2914 2917; constant -2.5714285714285743; mul 814 1096; mul 2919 2920; constant -0.8571428571428583; mul 810 984; mul
2922 2923; constant 0.9142857142857138; mul 866 984; mul 2925 2926; add 2924 2927; constant 0.05714285714285722; mul
805 984; mul 2929 2930; add 2928 2931; constant -0.11428571428571327; mul 801 984; mul 2933 2934; add 2932 2935;
constant 0.2190476190476189; mul 782 984; mul 2937 2938; add 2936 2939; constant 0.11428571428571413; mul 778 984;
mul 2941 2942; add 2940 2943; constant -0.05714285714285729; mul 770 984; mul 2945 2946; add 2944 2947; input p 213;
constant -0.033333333333333326; mul 763 984; mul 2950 2951; mul 2949 2952; add 2948 2953; constant
0.007256235827664418; mul 826 984; mul 2955 2956; add 2954 2957; constant 0.01904761904761903; mul 59 984; mul 2959
2960; mul 2949 2961; add 2958 2962; sub 2921 2963; constant 2.057142857142858; mul 810 1096; mul 2965 2966; add 2964
2967; mul 866 1096; mul 2922 2969; add 2968 2970; constant -3.428571428571427; mul 805 1096; mul 2972 2973; add 2971
2974; constant 0.11428571428571443; mul 801 1096; mul 2976 2977; add 2975 2978; constant -0.057142857142856635; mul
793 1096; mul 2980 2981; add 2979 2982; constant -0.09999999999999995; mul 4 1096; mul 2984 2985; mul 2949 2986; add
2983 2987; constant 2.438095238095238; mul 782 1096; mul 2989 2990; add 2988 2991; constant 0.6571428571428567; mul
778 1096; mul 2993 2994; add 2992 2995; input p 214; mul 774 1096; mul 2997 2998; sub 2996 2999; mul 770 1096; mul
2941 3001; add 3000 3002; constant 0.13333333333333333; mul 763 1096; mul 3004 3005; mul 2949 3006; add 3003 3007;
constant -0.019047619047619094; mul 826 1096; mul 3009 3010; add 3008 3011; mul 59 1096; mul 2950 3013; mul 2949
3014; add 3012 3015; constant 12.34285714285715; mul 814 992; mul 3017 3018; sub 3016 3019; constant
-7.714285714285722; mul 810 992; mul 3021 3022; sub 3020 3023; mul 805 992; mul 2965 3025; sub 3024 3026; constant
-1.7142857142857166; mul 801 992; mul 3028 3029; sub 3027 3030; mul 793 992; mul 2925 3032; sub 3031 3033; constant
1.2; mul 4 992; mul 3035 3036; mul 2949 3037; sub 3034 3038; constant -1.1428571428571423; mul 782 992; mul 3040
3041; sub 3039 3042; mul 778 992; mul 2929 3044; sub 3043 3045; mul 770 992; mul 2980 3047; sub 3046 3048; mul 763
992; mul 2984 3050; mul 2949 3051; sub 3049 3052; mul 810 1616; mul 2922 3054; mul 866 1616; mul 2925 3056; add 3055
3057; mul 805 1616; mul 2929 3059; add 3058 3060; mul 801 1616; mul 2933 3062; add 3061 3063; mul 782 1616; mul 2937
3065; add 3064 3066; mul 778 1616; mul 2941 3068; add 3067 3069; mul 770 1616; mul 2945 3071; add 3070 3072; mul 763
1616; mul 2950 3074; mul 2949 3075; add 3073 3076; mul 826 1616; mul 2955 3078; add 3077 3079; mul 59 1616; mul 2959
3081; mul 2949 3082; add 3080 3083; mul 814 1742; mul 2919 3085; add 3084 3086; mul 810 1742; mul 2965 3088; add
3087 3089; mul 866 1742; mul 2922 3091; add 3090 3092; mul 805 1742; mul 2972 3094; add 3093 3095; mul 801 1742; mul
2976 3097; add 3096 3098; mul 793 1742; mul 2980 3100; add 3099 3101; mul 4 1742; mul 2984 3103; mul 2949 3104; add
3102 3105; mul 782 1742; mul 2989 3107; add 3106 3108; mul 778 1742; mul 2993 3110; add 3109 3111; mul 774 1742; mul
2997 3113; sub 3112 3114; mul 770 1742; mul 2941 3116; add 3115 3117; mul 763 1742; mul 3004 3119; mul 2949 3120;
add 3118 3121; mul 826 1742; mul 3009 3123; add 3122 3124; mul 59 1742; mul 2950 3126; mul 2949 3127; add 3125 3128;
mul 814 1626; mul 3017 3130; add 3129 3131; mul 810 1626; mul 3021 3133; add 3132 3134; mul 805 1626; mul 2965 3136;
add 3135 3137; mul 801 1626; mul 3028 3139; add 3138 3140; mul 793 1626; mul 2925 3142; add 3141 3143; mul 4 1626;
mul 3035 3145; mul 2949 3146; add 3144 3147; mul 782 1626; mul 3040 3149; add 3148 3150; mul 778 1626; mul 2929
3152; add 3151 3153; mul 770 1626; mul 2980 3155; add 3154 3156; mul 763 1626; mul 2984 3158; mul 2949 3159; add
3157 3160; mul 814 2302; mul 2919 3162; mul 810 2200; mul 2922 3164; mul 866 2200; mul 2925 3166; add 3165 3167; mul
805 2200; mul 2929 3169; add 3168 3170; mul 801 2200; mul 2933 3172; add 3171 3173; mul 782 2200; mul 2937 3175; add
3174 3176; mul 778 2200; mul 2941 3178; add 3177 3179; mul 770 2200; mul 2945 3181; add 3180 3182; mul 763 2200; mul
2950 3184; mul 2949 3185; add 3183 3186; mul 826 2200; mul 2955 3188; add 3187 3189; mul 59 2200; mul 2959 3191; mul
2949 3192; add 3190 3193; sub 3163 3194; mul 810 2302; mul 2965 3196; add 3195 3197; mul 866 2302; mul 2922 3199;
add 3198 3200; mul 805 2302; mul 2972 3202; add 3201 3203; mul 801 2302; mul 2976 3205; add 3204 3206; mul 793 2302;
mul 2980 3208; add 3207 3209; mul 4 2302; mul 2984 3211; mul 2949 3212; add 3210 3213; mul 782 2302; mul 2989 3215;
add 3214 3216; mul 778 2302; mul 2993 3218; add 3217 3219; mul 774 2302; mul 2997 3221; sub 3220 3222; mul 770 2302;
mul 2941 3224; add 3223 3225; mul 763 2302; mul 3004 3227; mul 2949 3228; add 3226 3229; mul 826 2302; mul 3009
3231; add 3230 3232; mul 59 2302; mul 2950 3234; mul 2949 3235; add 3233 3236; mul 814 2207; mul 3017 3238; sub 3237
3239; mul 810 2207; mul 3021 3241; sub 3240 3242; mul 805 2207; mul 2965 3244; sub 3243 3245; mul 801 2207; mul 3028
3247; sub 3246 3248; mul 793 2207; mul 2925 3250; sub 3249 3251; mul 4 2207; mul 3035 3253; mul 2949 3254; sub 3252
3255; mul 782 2207; mul 3040 3257; sub 3256 3258; mul 778 2207; mul 2929 3260; sub 3259 3261; mul 770 2207; mul 2980
3263; sub 3262 3264; mul 763 2207; mul 2984 3266; mul 2949 3267; sub 3265 3268; constant -129.60000000000008; mul
2920 3270; constant 28.799999999999958; mul 2923 3272; constant 45.25714285714287; mul 2926 3274; add 3273 3275;
constant -28.800000000000004; mul 809 984; mul 3277 3278; mul 2997 3279; add 3276 3280; constant
-28.799999999999976; mul 2930 3282; add 3281 3283; constant -45.25714285714286; mul 2934 3285; add 3284 3286;
constant 28.79999999999999; mul 797 984; mul 3288 3289; mul 2997 3290; add 3287 3291; constant 7.199999999999994;
mul 2938 3293; add 3292 3294; constant 13.714285714285717; mul 2942 3296; add 3295 3297; constant
-7.199999999999996; mul 774 984; mul 3299 3300; mul 2997 3301; add 3298 3302; constant 1.3714285714285692; mul 2946
3304; add 3303 3305; constant -4.799999999999999; mul 766 984; mul 3307 3308; mul 2997 3309; add 3306 3310; constant
1.3714285714285714; mul 2956 3312; add 3311 3313; constant -1.3714285714285723; mul 822 984; mul 3315 3316; mul 2997
3317; add 3314 3318; constant 2.400000000000001; mul 2960 3320; mul 2949 3321; add 3319 3322; sub 3271 3323;
constant 230.40000000000006; mul 2966 3325; add 3324 3326; mul 2969 3272; add 3327 3328; constant
-36.00000000000001; mul 809 1096; mul 3330 3331; mul 2997 3332; add 3329 3333; constant -151.20000000000002; mul
2973 3335; add 3334 3336; constant -57.59999999999995; mul 2977 3338; add 3337 3339; constant 72.0; mul 797 1096;
mul 3341 3342; mul 2997 3343; add 3340 3344; constant -22.62857142857143; mul 2981 3346; add 3345 3347; mul 789
1096; mul 3288 3349; mul 2997 3350; add 3348 3351; constant -18.000000000000004; mul 2985 3353; mul 2949 3354; add
3352 3355; constant 35.20000000000001; mul 2990 3357; add 3356 3358; constant 21.59999999999998; mul 2994 3360; add
3359 3361; constant -30.000000000000007; mul 2998 3363; mul 2997 3364; add 3362 3365; mul 3001 3296; add 3366 3367;
constant -14.399999999999991; mul 766 1096; mul 3369 3370; mul 2997 3371; add 3368 3372; mul 934 3005; mul 2949
3374; add 3373 3375; constant 0.4571428571428564; mul 3010 3377; add 3376 3378; constant -2.3999999999999995; mul
822 1096; mul 3380 3381; mul 2997 3382; add 3379 3383; input p 215; constant -0.9999999999999998; mul 1096 3386; mul
3385 3387; add 3384 3388; constant 259.2000000000001; mul 3018 3390; sub 3389 3391; constant -388.80000000000024;
mul 3022 3393; sub 3392 3394; mul 3025 3325; sub 3395 3396; constant 57.599999999999916; mul 3029 3398; sub 3397
3399; constant -72.00000000000001; mul 797 992; mul 3401 3402; mul 2997 3403; sub 3400 3404; mul 3032 3274; sub 3405
3406; constant -57.60000000000001; mul 789 992; mul 3408 3409; mul 2997 3410; sub 3407 3411; constant
36.000000000000014; mul 3036 3413; mul 2949 3414; sub 3412 3415; constant -50.400000000000006; mul 3041 3417; sub
3416 3418; mul 3044 3282; sub 3419 3420; constant 36.0; mul 774 992; mul 3422 3423; mul 2997 3424; sub 3421 3425;
mul 3047 3346; sub 3426 3427; mul 766 992; mul 3288 3429; mul 2997 3430; sub 3428 3431; mul 3050 3353; mul 2949
3433; sub 3432 3434; mul 3054 3272; mul 3056 3274; add 3436 3437; mul 809 1616; mul 3277 3439; mul 2997 3440; add
3438 3441; mul 3059 3282; add 3442 3443; mul 3062 3285; add 3444 3445; mul 797 1616; mul 3288 3447; mul 2997 3448;
add 3446 3449; mul 3065 3293; add 3450 3451; mul 3068 3296; add 3452 3453; mul 774 1616; mul 3299 3455; mul 2997
3456; add 3454 3457; mul 3071 3304; add 3458 3459; mul 766 1616; mul 3307 3461; mul 2997 3462; add 3460 3463; mul
3078 3312; add 3464 3465; mul 822 1616; mul 3315 3467; mul 2997 3468; add 3466 3469; mul 3081 3320; mul 2949 3471;
add 3470 3472; mul 3085 3270; add 3473 3474; mul 3088 3325; add 3475 3476; mul 3091 3272; add 3477 3478; mul 809
1742; mul 3330 3480; mul 2997 3481; add 3479 3482; mul 3094 3335; add 3483 3484; mul 3097 3338; add 3485 3486; mul
797 1742; mul 3341 3488; mul 2997 3489; add 3487 3490; mul 3100 3346; add 3491 3492; mul 789 1742; mul 3288 3494;
mul 2997 3495; add 3493 3496; mul 3103 3353; mul 2949 3498; add 3497 3499; mul 3107 3357; add 3500 3501; mul 3110
3360; add 3502 3503; mul 3113 3363; mul 2997 3505; add 3504 3506; mul 3116 3296; add 3507 3508; mul 766 1742; mul
3369 3510; mul 2997 3511; add 3509 3512; mul 934 3119; mul 2949 3514; add 3513 3515; mul 3123 3377; add 3516 3517;
mul 822 1742; mul 3380 3519; mul 2997 3520; add 3518 3521; mul 1742 3386; mul 3385 3523; add 3522 3524; mul 3130
3390; add 3525 3526; mul 3133 3393; add 3527 3528; mul 3136 3325; add 3529 3530; mul 3139 3398; add 3531 3532; mul
797 1626; mul 3401 3534; mul 2997 3535; add 3533 3536; mul 3142 3274; add 3537 3538; mul 789 1626; mul 3408 3540;
mul 2997 3541; add 3539 3542; mul 3145 3413; mul 2949 3544; add 3543 3545; mul 3149 3417; add 3546 3547; mul 3152
3282; add 3548 3549; mul 774 1626; mul 3422 3551; mul 2997 3552; add 3550 3553; mul 3155 3346; add 3554 3555; mul
766 1626; mul 3288 3557; mul 2997 3558; add 3556 3559; mul 3158 3353; mul 2949 3561; add 3560 3562; mul 3162 3270;
mul 3164 3272; mul 3166 3274; add 3565 3566; mul 809 2200; mul 3277 3568; mul 2997 3569; add 3567 3570; mul 3169
3282; add 3571 3572; mul 3172 3285; add 3573 3574; mul 797 2200; mul 3288 3576; mul 2997 3577; add 3575 3578; mul
3175 3293; add 3579 3580; mul 3178 3296; add 3581 3582; mul 774 2200; mul 3299 3584; mul 2997 3585; add 3583 3586;
mul 3181 3304; add 3587 3588; mul 766 2200; mul 3307 3590; mul 2997 3591; add 3589 3592; mul 3188 3312; add 3593
3594; mul 822 2200; mul 3315 3596; mul 2997 3597; add 3595 3598; mul 3191 3320; mul 2949 3600; add 3599 3601; sub
3564 3602; mul 3196 3325; add 3603 3604; mul 3199 3272; add 3605 3606; mul 809 2302; mul 3330 3608; mul 2997 3609;
add 3607 3610; mul 3202 3335; add 3611 3612; mul 3205 3338; add 3613 3614; mul 797 2302; mul 3341 3616; mul 2997
3617; add 3615 3618; mul 3208 3346; add 3619 3620; mul 789 2302; mul 3288 3622; mul 2997 3623; add 3621 3624; mul
3211 3353; mul 2949 3626; add 3625 3627; mul 3215 3357; add 3628 3629; mul 3218 3360; add 3630 3631; mul 3221 3363;
mul 2997 3633; add 3632 3634; mul 3224 3296; add 3635 3636; mul 766 2302; mul 3369 3638; mul 2997 3639; add 3637
3640; mul 934 3227; mul 2949 3642; add 3641 3643; mul 3231 3377; add 3644 3645; mul 822 2302; mul 3380 3647; mul
2997 3648; add 3646 3649; mul 2302 3386; mul 3385 3651; add 3650 3652; mul 3238 3390; sub 3653 3654; mul 3241 3393;
sub 3655 3656; mul 3244 3325; sub 3657 3658; mul 3247 3398; sub 3659 3660; mul 797 2207; mul 3401 3662; mul 2997
3663; sub 3661 3664; mul 3250 3274; sub 3665 3666; mul 789 2207; mul 3408 3668; mul 2997 3669; sub 3667 3670; mul
3253 3413; mul 2949 3672; sub 3671 3673; mul 3257 3417; sub 3674 3675; mul 3260 3282; sub 3676 3677; mul 774 2207;
mul 3422 3679; mul 2997 3680; sub 3678 3681; mul 3263 3346; sub 3682 3683; mul 766 2207; mul 3288 3685; mul 2997
3686; sub 3684 3687; mul 3266 3353; mul 2949 3689; sub 3688 3690; input p 216; mul 3332 3692; mul 3279 3692; mul
3290 3692; add 3694 3695; mul 3301 3692; add 3696 3697; mul 3309 3692; add 3698 3699; input p 217; input p 218; mul
2952 3702; mul 3701 3703; add 3700 3704; mul 3317 3692; add 3705 3706; mul 2961 3702; mul 3701 3708; add 3707 3709;
mul 3321 3692; mul 3701 3711; add 3710 3712; sub 3693 3713; mul 3343 3692; add 3714 3715; mul 3350 3692; add 3716
3717; mul 2986 3702; mul 3701 3719; add 3718 3720; mul 3354 3692; mul 3701 3722; add 3721 3723; mul 2998 3702; sub
3724 3725; mul 3364 3692; add 3726 3727; mul 3371 3692; add 3728 3729; mul 3006 3702; mul 3701 3731; add 3730 3732;
mul 3374 3692; mul 3701 3734; add 3733 3735; mul 3382 3692; add 3736 3737; mul 3014 3702; mul 3701 3739; add 3738
3740; mul 3387 3692; mul 2949 3742; add 3741 3743; mul 2997 3742; mul 3701 3745; add 3744 3746; add 3387 3747; mul
3403 3692; sub 3748 3749; mul 3410 3692; sub 3750 3751; mul 3037 3702; mul 3701 3753; sub 3752 3754; mul 3414 3692;
mul 3701 3756; sub 3755 3757; mul 3424 3692; sub 3758 3759; mul 3430 3692; sub 3760 3761; mul 3051 3702; mul 3701
3763; sub 3762 3764; mul 3433 3692; mul 3701 3766; sub 3765 3767; mul 3440 3692; mul 3448 3692; add 3769 3770; mul
3456 3692; add 3771 3772; mul 3462 3692; add 3773 3774; mul 3075 3702; mul 3701 3776; add 3775 3777; mul 3468 3692;
add 3778 3779; mul 3082 3702; mul 3701 3781; add 3780 3782; mul 3471 3692; mul 3701 3784; add 3783 3785; mul 3481
3692; add 3786 3787; mul 3489 3692; add 3788 3789; mul 3495 3692; add 3790 3791; mul 3104 3702; mul 3701 3793; add
3792 3794; mul 3498 3692; mul 3701 3796; add 3795 3797; mul 3113 3702; sub 3798 3799; mul 3505 3692; add 3800 3801;
mul 3511 3692; add 3802 3803; mul 3120 3702; mul 3701 3805; add 3804 3806; mul 3514 3692; mul 3701 3808; add 3807
3809; mul 3520 3692; add 3810 3811; mul 3127 3702; mul 3701 3813; add 3812 3814; mul 3523 3692; mul 2949 3816; add
3815 3817; mul 2997 3816; mul 3701 3819; add 3818 3820; add 3523 3821; mul 3535 3692; add 3822 3823; mul 3541 3692;
add 3824 3825; mul 3146 3702; mul 3701 3827; add 3826 3828; mul 3544 3692; mul 3701 3830; add 3829 3831; mul 3552
3692; add 3832 3833; mul 3558 3692; add 3834 3835; mul 3159 3702; mul 3701 3837; add 3836 3838; mul 3561 3692; mul
3701 3840; add 3839 3841; mul 3609 3692; mul 3569 3692; mul 3577 3692; add 3844 3845; mul 3585 3692; add 3846 3847;
mul 3591 3692; add 3848 3849; mul 3185 3702; mul 3701 3851; add 3850 3852; mul 3597 3692; add 3853 3854; mul 3192
3702; mul 3701 3856; add 3855 3857; mul 3600 3692; mul 3701 3859; add 3858 3860; sub 3843 3861; mul 3617 3692; add
3862 3863; mul 3623 3692; add 3864 3865; mul 3212 3702; mul 3701 3867; add 3866 3868; mul 3626 3692; mul 3701 3870;
add 3869 3871; mul 3221 3702; sub 3872 3873; mul 3633 3692; add 3874 3875; mul 3639 3692; add 3876 3877; mul 3228
3702; mul 3701 3879; add 3878 3880; mul 3642 3692; mul 3701 3882; add 3881 3883; mul 3648 3692; add 3884 3885; mul
3235 3702; mul 3701 3887; add 3886 3888; mul 3651 3692; mul 2949 3890; add 3889 3891; mul 2997 3890; mul 3701 3893;
add 3892 3894; add 3651 3895; mul 3663 3692; sub 3896 3897; mul 3669 3692; sub 3898 3899; mul 3254 3702; mul 3701
3901; sub 3900 3902; mul 3672 3692; mul 3701 3904; sub 3903 3905; mul 3680 3692; sub 3906 3907; mul 3686 3692; sub
3908 3909; mul 3267 3702; mul 3701 3911; sub 3910 3912; mul 3689 3692; mul 3701 3914; sub 3913 3915; mul 935 970;
mul 950 962; sub 3917 3918; mul 873 992; sub 3919 3920; mul 4 1287; add 3921 3922; mul 950 1601; mul 935 1609; add
3924 3925; mul 873 1626; add 3926 3927; mul 4 1904; add 3928 3929; mul 935 2191; mul 950 2183; sub 3931 3932; mul
873 2207; sub 3933 3934; mul 4 2485; add 3935 3936; mul 443 950; mul 873 978; add 3938 3939; mul 255 970; add 3940
3941; mul 27 1287; add 3942 3943; mul 255 1609; mul 950 1343; mul 873 1622; add 3946 3947; sub 3945 3948; mul 27
1904; add 3949 3950; mul 950 1352; mul 873 1616; add 3952 3953; mul 255 2191; add 3954 3955; mul 27 2485; add 3956
3957; mul 287 970; mul 441 950; mul 873 984; add 3960 3961; sub 3959 3962; mul 59 1287; add 3963 3964; mul 287 1609;
add 3954 3966; mul 59 1904; add 3967 3968; mul 287 2191; mul 950 1928; mul 873 2200; add 3971 3972; sub 3970 3973;
mul 59 2485; add 3974 3975; mul 163 257; mul 255 258; mul 255 3978; mul 394 3979; mul 393 445; mul 393 443; mul 402
3982; sub 3981 3983; mul 3980 3984; mul 170 3985; mul 443 3979; mul 410 3987; sub 3986 3988; mul 397 3982; mul 393
441; mul 98 3991; sub 3990 3992; mul 82 3981; sub 3993 3994; mul 3980 3995; mul 174 3996; sub 3989 3997; mul 27
3998; mul 3977 3999; mul 3977 4000; mul 164 3999; mul 164 4002; mul 196 4003; add 4001 4004; mul 257 258; mul 380
474; input p 142; mul 174 4008; mul 443 4009; sub 4007 4010; mul 264 572; add 4011 4012; mul 4006 4013; mul 169
4014; mul 164 164; mul 257 4013; mul 4016 4017; add 4015 4018; mul 164 174; mul 311 476; mul 302 4021; mul 258 443;
mul 4008 4023; mul 304 476; mul 299 4025; add 4024 4026; sub 4022 4027; mul 302 559; add 4028 4029; mul 320 535; mul
375 476; add 4031 4032; mul 196 311; mul 557 4034; add 4033 4035; mul 299 4036; add 4030 4037; mul 177 574; mul 171
4039; sub 4038 4040; mul 184 574; mul 175 4042; sub 4041 4043; mul 175 657; sub 4044 4045; mul 193 633; mul 259 574;
add 4047 4048; mul 184 196; mul 655 4050; add 4049 4051; mul 171 4052; add 4046 4053; mul 4020 4054; add 4019 4055;
mul 164 170; mul 302 4025; mul 299 4021; add 4058 4059; mul 299 559; add 4060 4061; mul 302 4036; sub 4062 4063; mul
175 4039; sub 4064 4065; mul 171 4042; add 4066 4067; mul 171 657; add 4068 4069; mul 175 4052; add 4070 4071; mul
4057 4072; add 4056 4073; mul 163 196; div 17 4075; mul 4074 4076; mul 27 4077; mul 27 4078; sub 4005 4079; mul 164
4072; mul 163 4014; sub 4081 4082; mul 169 196; div 17 4084; mul 4083 4085; mul 27 4086; mul 27 4087; add 4080 4088;
input p 128; mul 164 4090; mul 164 4091; mul 165 3977; mul 3977 4093; add 4092 4094; mul 27 4095; mul 3985 4096; mul
754 2867; mul 289 392; sub 4098 4099; input p 167; mul 287 4101; mul 761 950; add 4102 4103; add 4100 4104; mul 75
267; mul 77 255; add 4106 4107; mul 80 287; add 4108 4109; mul 267 4110; mul 77 267; mul 85 255; add 4112 4113; mul
88 287; add 4114 4115; mul 255 4116; add 4111 4117; mul 80 267; mul 88 255; add 4119 4120; mul 96 287; add 4121
4122; mul 287 4123; add 4118 4124; mul 174 4096; sub 401 4126; mul 3980 4127; add 4125 4128; mul 98 4129; mul 393
4130; add 4105 4131; mul 440 441; mul 4132 4133; mul 754 2769; mul 284 392; sub 4135 4136; mul 758 950; add 4137
4138; mul 265 295; mul 381 389; add 4140 4141; add 4139 4142; sub 1312 4143; mul 258 4009; add 4144 4145; input p
119; input z 0; mul 4147 4148; input p 120; input z 1; mul 4150 4151; add 4149 4152; input p 121; input z 2; mul
4154 4155; add 4153 4156; input p 122; input z 3; mul 4158 4159; add 4157 4160; input p 143; mul 4161 4162; sub 4146
4163; mul 397 4129; mul 170 4096; add 395 4166; mul 3980 4167; mul 402 4168; sub 4165 4169; mul 393 4170; mul 410
4096; mul 3979 4172; sub 4171 4173; sub 4164 4174; mul 440 443; mul 4175 4176; add 4134 4177; input c 0; input c 2;
mul 215 4180; add 4179 4181; input c 3; mul 338 4183; add 4182 4184; mul 1296 1330; add 4185 4186; mul 1294 1312;
sub 4187 4188; input p 16; input c 1; add 4190 4191; max 4192 7; mul 267 4193; sub 4189 4194; mul 276 392; sub 954
4196; mul 268 295; mul 383 389; add 4198 4199; sub 4197 4200; sub 4195 4201; input p 118; sub 4203 4161; input p
123; abs 267; mul 4205 4206; mul 267 4207; input p 124; mul 267 4209; mul 267 267; input p 125; add 4211 4212; sqrt
4213; div 17 4214; mul 4210 4215; add 4208 4216; sub 4204 4217; add 4202 4218; input p 126; input x 12; sub 2 4221;
mul 4220 4222; input p 127; input x 13; sub 2 4225; mul 4224 4226; add 4223 4227; sub 4219 4228; mul 82 4129; sub
4230 4168; mul 393 4231; sub 4229 4232; mul 440 445; mul 4233 4234; sub 4178 4235; mul 419 4236; mul 399 4237; mul
406 4236; mul 425 4239; sub 4238 4240; mul 393 4241; mul 3982 4168; sub 4242 4243; mul 440 4132; mul 399 4245; mul
440 4175; mul 425 4247; add 4246 4248; mul 435 4236; add 4249 4250; mul 393 4251; sub 4244 4252; mul 196 402; mul
419 4245; mul 419 4237; sub 4255 4256; mul 431 4236; mul 425 4258; add 4257 4259; mul 440 4233; mul 425 4261; add
4260 4262; mul 393 4263; mul 4254 4264; add 4253 4265; mul 394 4266; add 3996 4267; mul 258 4268; add 4097 4269; mul
164 4270; mul 257 3977; mul 3999 4093; mul 165 4000; add 4273 4274; mul 4272 4275; mul 3984 4167; mul 394 4277; mul
443 4172; sub 4278 4279; mul 3995 4127; mul 394 4281; add 4280 4282; mul 255 4283; mul 255 4284; mul 3982 4129; mul
82 4242; add 4286 4287; mul 82 4252; sub 4288 4289; mul 419 4247; mul 406 4237; add 4291 4292; mul 399 4258; sub
4293 4294; mul 399 4261; sub 4295 4296; mul 393 4297; mul 98 4298; add 4290 4299; mul 419 4239; mul 406 4245; sub
4301 4302; sub 4303 4294; sub 4304 4296; mul 393 4305; mul 98 4306; add 4300 4307; mul 196 397; mul 4264 4309; add
4308 4310; mul 394 4311; add 3985 4312; mul 174 4313; add 4285 4314; mul 170 4268; add 4315 4316; mul 410 4263; add
4317 4318; mul 258 4263; mul 3987 4096; sub 4320 4321; mul 409 4322; add 4319 4323; mul 4006 4324; add 4276 4325;
mul 163 4326; sub 4271 4327; mul 4085 4328; mul 27 4329; mul 27 4330; add 4089 4331; mul 257 4275; mul 164 4092; mul
3999 4334; sub 4333 4335; mul 4002 4092; sub 4336 4337; mul 258 4313; mul 3996 4096; sub 4339 4340; mul 4020 4341;
sub 4338 4342; mul 4057 4270; sub 4343 4344; mul 169 4326; sub 4345 4346; mul 257 4324; mul 4016 4348; sub 4347
4349; mul 4076 4350; mul 27 4351; mul 27 4352; add 4332 4353; mul 1343 3979; mul 410 4355; mul 393 1343; mul 402
4357; sub 4358 3982; mul 3980 4359; mul 170 4360; add 4356 4361; mul 393 1352; mul 98 4363; mul 397 4357; sub 4364
4365; mul 82 3982; add 4366 4367; mul 3980 4368; mul 174 4369; sub 4362 4370; mul 27 4371; mul 3977 4372; mul 3977
4373; mul 164 4372; mul 164 4375; mul 196 4376; add 4374 4377; mul 1343 4009; mul 380 1418; sub 4379 4380; mul 264
1454; sub 4381 4382; mul 4006 4383; mul 169 4384; mul 257 4383; mul 4016 4386; add 4385 4387; mul 258 1343; mul 4008
4389; mul 304 1442; mul 299 4391; add 4390 4392; mul 311 1442; mul 302 4394; sub 4393 4395; mul 302 1445; add 4396
4397; mul 320 1409; mul 375 1442; sub 4399 4400; mul 1439 4034; add 4401 4402; mul 299 4403; add 4398 4404; mul 177
1456; mul 171 4406; add 4405 4407; mul 184 1456; mul 175 4409; add 4408 4410; mul 175 1525; sub 4411 4412; mul 193
1500; mul 259 1456; sub 4414 4415; mul 1523 4050; add 4416 4417; mul 171 4418; add 4413 4419; mul 4020 4420; add
4388 4421; mul 299 1445; mul 302 4391; mul 299 4394; add 4424 4425; sub 4423 4426; mul 302 4403; sub 4427 4428; mul
175 4406; add 4429 4430; mul 171 4409; sub 4431 4432; mul 171 1525; add 4433 4434; mul 175 4418; add 4435 4436; mul
4057 4437; add 4422 4438; mul 4076 4439; mul 27 4440; mul 27 4441; sub 4378 4442; mul 164 4437; mul 163 4384; sub
4444 4445; mul 4085 4446; mul 27 4447; mul 27 4448; add 4443 4449; mul 4096 4360; mul 4168 4357; mul 4176 4233; mul
440 1352; mul 4132 4454; sub 4453 4455; mul 440 1343; mul 4175 4457; sub 4456 4458; mul 419 4459; mul 399 4460; add
4255 4262; sub 4461 4462; mul 406 4459; mul 425 4464; sub 4463 4465; mul 393 4466; add 4452 4467; mul 435 4459; mul
393 4469; sub 4468 4470; mul 431 4459; mul 425 4472; mul 419 4460; sub 4473 4474; mul 393 4475; mul 4254 4476; add
4471 4477; mul 394 4478; add 4369 4479; mul 258 4480; add 4451 4481; mul 164 4482; mul 4093 4372; mul 165 4373; add
4484 4485; mul 4272 4486; mul 1343 4172; mul 4167 4359; mul 394 4489; add 4488 4490; mul 4127 4368; mul 394 4492;
add 4491 4493; mul 255 4494; mul 255 4495; mul 82 4467; mul 4129 4357; sub 4497 4498; mul 82 4470; sub 4499 4500;
mul 406 4460; mul 399 4472; sub 4502 4503; mul 393 4504; mul 98 4505; add 4501 4506; mul 431 4245; mul 419 4261; add
4508 4509; mul 419 4464; add 4510 4511; sub 4512 4503; mul 393 4513; mul 98 4514; add 4507 4515; mul 4309 4476; add
4516 4517; mul 394 4518; add 4360 4519; mul 174 4520; add 4496 4521; mul 170 4480; add 4522 4523; mul 410 4475; add
4524 4525; mul 4096 4355; mul 258 4475; add 4527 4528; mul 409 4529; add 4526 4530; mul 4006 4531; add 4487 4532;
mul 163 4533; sub 4483 4534; mul 4085 4535; mul 27 4536; mul 27 4537; add 4450 4538; mul 257 4486; mul 4334 4372;
sub 4540 4541; mul 4092 4375; sub 4542 4543; mul 258 4520; mul 4096 4369; sub 4545 4546; mul 4020 4547; sub 4544
4548; mul 4057 4482; sub 4549 4550; mul 169 4533; sub 4551 4552; mul 257 4531; mul 4016 4554; sub 4553 4555; mul
4076 4556; mul 27 4557; mul 27 4558; add 4539 4559; mul 402 4363; sub 3991 4561; mul 3980 4562; mul 170 4563; mul
1352 3979; mul 410 4565; sub 4564 4566; mul 397 4363; mul 393 1928; mul 98 4569; sub 4568 4570; mul 82 3991; sub
4571 4572; mul 3980 4573; mul 174 4574; sub 4567 4575; mul 27 4576; mul 3977 4577; mul 3977 4578; mul 164 4577; mul
164 4580; mul 196 4581; add 4579 4582; mul 380 1959; mul 1352 4009; sub 4584 4585; mul 264 2039; add 4586 4587; mul
4006 4588; mul 169 4589; mul 257 4588; mul 4016 4591; add 4590 4592; mul 311 1961; mul 302 4594; mul 258 1352; mul
4008 4596; mul 304 1961; mul 299 4598; add 4597 4599; sub 4595 4600; mul 302 2027; add 4601 4602; mul 320 2003; mul
375 1961; add 4604 4605; mul 2025 4034; add 4606 4607; mul 299 4608; add 4603 4609; mul 177 2041; mul 171 4611; sub
4610 4612; mul 184 2041; mul 175 4614; sub 4613 4615; mul 175 2107; sub 4616 4617; mul 193 2083; mul 259 2041; add
4619 4620; mul 2105 4050; add 4621 4622; mul 171 4623; add 4618 4624; mul 4020 4625; add 4593 4626; mul 302 4598;
mul 299 4594; add 4628 4629; mul 299 2027; add 4630 4631; mul 302 4608; sub 4632 4633; mul 175 4611; sub 4634 4635;
mul 171 4614; add 4636 4637; mul 171 2107; add 4638 4639; mul 175 4623; add 4640 4641; mul 4057 4642; add 4627 4643;
mul 4076 4644; mul 27 4645; mul 27 4646; sub 4583 4647; mul 164 4642; mul 163 4589; sub 4649 4650; mul 4085 4651;
mul 27 4652; mul 27 4653; add 4648 4654; mul 4096 4563; add 4296 4302; mul 440 1928; mul 4132 4658; mul 4175 4454;
add 4659 4660; mul 4133 4233; sub 4661 4662; mul 419 4663; mul 399 4664; add 4657 4665; mul 406 4663; mul 425 4667;
sub 4666 4668; mul 393 4669; mul 4168 4363; sub 4670 4671; add 4291 4302; mul 435 4663; sub 4673 4674; mul 393 4675;
add 4672 4676; mul 431 4663; mul 425 4678; mul 419 4664; add 4510 4680; sub 4679 4681; mul 393 4682; mul 4254 4683;
add 4677 4684; mul 394 4685; add 4574 4686; mul 258 4687; add 4656 4688; mul 164 4689; mul 4093 4577; mul 165 4578;
add 4691 4692; mul 4272 4693; mul 4167 4562; mul 394 4695; mul 1352 4172; sub 4696 4697; mul 4127 4573; mul 394
4699; add 4698 4700; mul 255 4701; mul 255 4702; mul 4129 4363; mul 82 4670; add 4704 4705; mul 82 4676; add 4706
4707; mul 406 4261; mul 431 4247; sub 4709 4710; mul 406 4664; add 4711 4712; mul 399 4678; sub 4713 4714; mul 393
4715; mul 98 4716; add 4708 4717; mul 419 4667; sub 4719 4714; mul 393 4720; mul 98 4721; add 4718 4722; mul 4309
4683; add 4723 4724; mul 394 4725; add 4563 4726; mul 174 4727; add 4703 4728; mul 170 4687; add 4729 4730; mul 410
4682; add 4731 4732; mul 258 4682; mul 4096 4565; sub 4734 4735; mul 409 4736; add 4733 4737; mul 4006 4738; add
4694 4739; mul 163 4740; sub 4690 4741; mul 4085 4742; mul 27 4743; mul 27 4744; add 4655 4745; mul 257 4693; mul
4334 4577; sub 4747 4748; mul 4092 4580; sub 4749 4750; mul 258 4727; mul 4096 4574; sub 4752 4753; mul 4020 4754;
sub 4751 4755; mul 4057 4689; sub 4756 4757; mul 169 4740; sub 4758 4759; mul 257 4738; mul 4016 4761; sub 4760
4762; mul 4076 4763; mul 27 4764; mul 27 4765; add 4746 4766; mul 184 2516; mul 171 4768; mul 177 2516; mul 175
4770; sub 4769 4771; mul 171 2548; add 4772 4773; mul 259 2516; mul 193 2534; sub 4775 4776; mul 2546 4050; add 4777
4778; mul 175 4779; add 4774 4780; mul 164 4781; mul 264 2514; mul 4006 4783; mul 163 4784; sub 4782 4785; mul 4085
4786; mul 27 4787; mul 27 4788; mul 169 4784; mul 257 4783; mul 4016 4791; add 4790 4792; mul 171 4779; mul 171
4770; mul 175 4768; add 4795 4796; mul 175 2548; add 4797 4798; sub 4794 4799; mul 4020 4800; add 4793 4801; mul
4057 4781; add 4802 4803; mul 4076 4804; mul 27 4805; mul 27 4806; sub 4789 4807; mul 304 2624; mul 302 4809; mul
311 2624; mul 299 4811; add 4810 4812; mul 299 2656; add 4813 4814; mul 375 2624; mul 320 2642; sub 4816 4817; mul
2654 4034; add 4818 4819; mul 302 4820; sub 4815 4821; mul 164 4822; mul 380 2622; mul 4006 4824; mul 163 4825; sub
4823 4826; mul 4085 4827; mul 27 4828; mul 27 4829; mul 169 4825; mul 257 4824; mul 4016 4832; add 4831 4833; mul
302 4811; mul 299 4809; sub 4835 4836; mul 302 2656; add 4837 4838; mul 299 4820; add 4839 4840; mul 4020 4841; add
4834 4842; mul 4057 4822; add 4843 4844; mul 4076 4845; mul 27 4846; mul 27 4847; sub 4830 4848; mul 22 993; mul 947
4850; neg 4851; mul 22 1627; mul 947 4853; mul 22 2208; mul 947 4855; neg 4856; mul 22 979; mul 42 993; mul 982
4859; sub 4858 4860; mul 42 1627; mul 982 4862; mul 22 1623; sub 4863 4864; mul 22 2198; mul 42 2208; mul 982 4867;
sub 4866 4868; mul 22 985; mul 115 993; mul 982 4871; add 4870 4872; neg 4873; mul 22 1617; mul 115 1627; mul 982
4876; add 4875 4877; mul 22 2201; mul 115 2208; mul 982 4880; add 4879 4881; neg 4882; mul 42 979; mul 196 4884; mul
47 993; neg 4886; mul 196 4887; add 4885 4888; mul 42 1623; neg 4890; mul 196 4891; mul 47 1627; mul 196 4893; add
4892 4894; mul 42 2198; mul 196 4896; mul 47 2208; neg 4898; mul 196 4899; add 4897 4900; mul 115 979; mul 42 985;
sub 4902 4903; mul 122 993; neg 4905; mul 196 4906; add 4904 4907; mul 42 1617; mul 115 1623; sub 4909 4910; mul 122
1627; mul 196 4912; add 4911 4913; mul 115 2198; mul 42 2201; sub 4915 4916; mul 122 2208; neg 4918; mul 196 4919;
add 4917 4920; mul 115 985; neg 4922; mul 196 4923; mul 913 993; neg 4925; mul 196 4926; add 4924 4927; mul 115
1617; mul 196 4929; mul 913 1627; mul 196 4931; add 4930 4932; mul 115 2201; neg 4934; mul 196 4935; mul 913 2208;
neg 4937; mul 196 4938; add 4936 4939; mul 47 979; mul 982 4941; mul 52 993; sub 4942 4943; mul 52 1627; mul 47
1623; mul 982 4946; sub 4945 4947; mul 47 2198; mul 982 4949; mul 52 2208; sub 4950 4951; mul 122 979; mul 196 4953;
mul 47 985; sub 4954 4955; mul 129 993; sub 4956 4957; mul 47 1617; mul 122 1623; neg 4960; mul 196 4961; add 4959
4962; mul 129 1627; add 4963 4964; mul 122 2198; mul 196 4966; mul 47 2201; sub 4967 4968; mul 129 2208; sub 4969
4970; mul 122 985; neg 4972; mul 196 4973; mul 913 979; add 4974 4975; mul 923 993; sub 4976 4977; mul 122 1617; mul
196 4979; mul 913 1623; sub 4980 4981; mul 923 1627; add 4982 4983; mul 122 2201; neg 4985; mul 196 4986; mul 913
2198; add 4987 4988; mul 923 2208; sub 4989 4990; mul 913 985; mul 982 4992; add 1013 4993; neg 4994; mul 913 1617;
mul 982 4996; add 1645 4997; mul 913 2201; mul 982 4999; add 2226 5000; neg 5001; mul 52 979; mul 947 5003; mul 52
1623; mul 947 5005; neg 5006; mul 52 2198; mul 947 5008; mul 129 979; mul 982 5010; mul 52 985; sub 5011 5012; mul
52 1617; mul 129 1623; mul 982 5015; sub 5014 5016; mul 129 2198; mul 982 5018; mul 52 2201; sub 5019 5020; mul 129
985; neg 5022; mul 196 5023; mul 923 979; mul 196 5025; add 5024 5026; mul 129 1617; mul 196 5028; mul 923 1623; neg
5030; mul 196 5031; add 5029 5032; mul 129 2201; neg 5034; mul 196 5035; mul 923 2198; mul 196 5037; add 5036 5038;
mul 923 985; mul 982 5040; sub 997 5041; mul 923 1617; mul 982 5043; sub 5044 1633; mul 923 2201; mul 982 5046; sub
2212 5047; mul 947 1000; neg 5049; mul 947 1631; mul 947 2214; neg 5052; mul 22 986; mul 21 1013; mul 982 5055; add
5054 5056; neg 5057; mul 22 1618; mul 21 1645; mul 982 5060; add 5059 5061; mul 22 2202; mul 21 2226; mul 982 5064;
add 5063 5065; neg 5066; mul 21 997; mul 42 986; sub 5068 5069; mul 46 1013; neg 5071; mul 196 5072; add 5070 5073;
mul 42 1618; mul 21 1633; sub 5075 5076; mul 46 1645; mul 196 5078; add 5077 5079; mul 21 2212; mul 42 2202; sub
5081 5082; mul 46 2226; neg 5084; mul 196 5085; add 5083 5086; mul 882 1013; neg 5088; mul 196 5089; mul 115 986;
mul 21 1000; add 5091 5092; sub 5090 5093; mul 115 1618; mul 21 1631; add 5095 5096; mul 882 1645; mul 196 5098; add
5097 5099; mul 882 2226; neg 5101; mul 196 5102; mul 115 2202; mul 21 2214; add 5104 5105; sub 5103 5106; mul 46
997; mul 196 5108; mul 47 986; sub 5109 5110; mul 51 1013; sub 5111 5112; mul 47 1618; mul 46 1633; neg 5115; mul
196 5116; add 5114 5117; mul 51 1645; add 5118 5119; mul 46 2212; mul 196 5121; mul 47 2202; sub 5122 5123; mul 51
2226; sub 5124 5125; mul 882 997; mul 122 986; mul 46 1000; add 5128 5129; sub 5127 5130; mul 889 1013; sub 5131
5132; mul 122 1618; mul 46 1631; add 5134 5135; mul 882 1633; sub 5136 5137; mul 889 1645; add 5138 5139; mul 882
2212; mul 122 2202; mul 46 2214; add 5142 5143; sub 5141 5144; mul 889 2226; sub 5145 5146; mul 882 1000; neg 5148;
mul 196 5149; mul 913 986; sub 5150 5151; mul 893 1013; sub 5152 5153; mul 913 1618; mul 882 1631; mul 196 5156; add
5155 5157; mul 893 1645; add 5158 5159; mul 882 2214; neg 5161; mul 196 5162; mul 913 2202; sub 5163 5164; mul 893
2226; sub 5165 5166; mul 51 997; mul 982 5168; mul 52 986; sub 5169 5170; mul 52 1618; mul 51 1633; mul 982 5173;
sub 5172 5174; mul 51 2212; mul 982 5176; mul 52 2202; sub 5177 5178; mul 889 997; mul 196 5180; mul 129 986; mul 51
1000; add 5182 5183; sub 5181 5184; mul 129 1618; mul 51 1631; add 5186 5187; mul 889 1633; neg 5189; mul 196 5190;
add 5188 5191; mul 889 2212; mul 196 5193; mul 129 2202; mul 51 2214; add 5195 5196; sub 5194 5197; mul 889 1000;
neg 5199; mul 196 5200; mul 923 986; sub 5201 5202; mul 893 997; add 5203 5204; mul 923 1618; mul 889 1631; mul 196
5207; add 5206 5208; mul 893 1633; sub 5209 5210; mul 889 2214; neg 5212; mul 196 5213; mul 923 2202; sub 5214 5215;
mul 893 2212; add 5216 5217; mul 896 986; mul 893 1000; mul 982 5220; add 5219 5221; neg 5222; mul 896 1618; mul 893
1631; mul 982 5225; add 5224 5226; mul 896 2202; mul 893 2214; mul 982 5229; add 5228 5230; neg 5231; mul 22 685;
mul 947 5233; mul 22 1541; mul 947 5235; mul 22 2123; mul 947 5237; mul 22 2562; mul 947 5239; mul 22 2674; mul 947
5241; mul 22 678; mul 42 685; mul 982 5244; add 5243 5245; mul 22 1535; mul 42 1541; mul 982 5248; add 5247 5249;
mul 22 2117; mul 42 2123; mul 982 5252; add 5251 5253; mul 22 2557; mul 42 2562; mul 982 5256; add 5255 5257; mul 22
2669; mul 42 2674; mul 982 5260; add 5259 5261; mul 22 692; mul 115 685; mul 982 5264; add 5263 5265; mul 22 1548;
mul 115 1541; mul 982 5268; add 5267 5269; mul 22 2130; mul 115 2123; mul 982 5272; add 5271 5273; mul 22 2569; mul
115 2562; mul 982 5276; add 5275 5277; mul 22 2681; mul 115 2674; mul 982 5280; add 5279 5281; mul 42 678; mul 196
5283; mul 47 685; mul 196 5285; add 5284 5286; mul 42 1535; mul 196 5288; mul 47 1541; mul 196 5290; add 5289 5291;
mul 42 2117; mul 196 5293; mul 47 2123; mul 196 5295; add 5294 5296; mul 42 2557; mul 196 5298; mul 47 2562; mul 196
5300; add 5299 5301; mul 42 2669; mul 196 5303; mul 47 2674; mul 196 5305; add 5304 5306; mul 42 692; mul 115 678;
add 5308 5309; mul 122 685; mul 196 5311; add 5310 5312; mul 42 1548; mul 115 1535; add 5314 5315; mul 122 1541; mul
196 5317; add 5316 5318; mul 42 2130; mul 115 2117; add 5320 5321; mul 122 2123; mul 196 5323; add 5322 5324; mul 42
2569; mul 115 2557; add 5326 5327; mul 122 2562; mul 196 5329; add 5328 5330; mul 42 2681; mul 115 2669; add 5332
5333; mul 122 2674; mul 196 5335; add 5334 5336; mul 47 678; mul 982 5338; mul 52 685; add 5339 5340; mul 47 1535;
mul 982 5342; mul 52 1541; add 5343 5344; mul 47 2117; mul 982 5346; mul 52 2123; add 5347 5348; mul 47 2557; mul
982 5350; mul 52 2562; add 5351 5352; mul 47 2669; mul 982 5354; mul 52 2674; add 5355 5356; mul 47 692; mul 122
678; mul 196 5359; add 5358 5360; mul 129 685; add 5361 5362; mul 47 1548; mul 122 1535; mul 196 5365; add 5364
5366; mul 129 1541; add 5367 5368; mul 47 2130; mul 122 2117; mul 196 5371; add 5370 5372; mul 129 2123; add 5373
5374; mul 47 2569; mul 122 2557; mul 196 5377; add 5376 5378; mul 129 2562; add 5379 5380; mul 47 2681; mul 122
2669; mul 196 5383; add 5382 5384; mul 129 2674; add 5385 5386; mul 52 678; mul 947 5388; mul 52 1535; mul 947 5390;
mul 52 2117; mul 947 5392; mul 52 2557; mul 947 5394; mul 52 2669; mul 947 5396; mul 52 692; mul 129 678; mul 982
5399; add 5398 5400; mul 52 1548; mul 129 1535; mul 982 5403; add 5402 5404; mul 52 2130; mul 129 2117; mul 982
5407; add 5406 5408; mul 52 2569; mul 129 2557; mul 982 5411; add 5410 5412; mul 52 2681; mul 129 2669; mul 982
5415; add 5414 5416; mul 443 4170; mul 441 4130; sub 5418 5419; mul 445 4231; sub 5420 5421; mul 417 4245; mul 399
4247; add 5423 5424; mul 421 4236; add 5425 5426; mul 418 5427; add 5422 5428; mul 399 4239; mul 417 4237; sub 5430
5431; mul 418 5432; add 5429 5433; mul 404 4241; add 5434 5435; mul 404 4251; sub 5436 5437; mul 428 4236; mul 430
5439; add 5438 5440; mul 398 4297; add 5441 5442; mul 398 4305; add 5443 5444; mul 417 4258; mul 406 4247; mul 406
4239; add 5447 5448; sub 5446 5449; mul 417 4261; add 5450 5451; mul 423 5452; add 5445 5453; mul 415 4263; add 5454
5455; mul 1352 4130; mul 1343 4170; sub 5457 5458; mul 443 4231; add 5459 5460; mul 421 4459; sub 5462 4673; mul 418
5463; add 5461 5464; sub 4296 4291; mul 417 4460; sub 5466 5467; mul 399 4464; add 5468 5469; mul 418 5470; add 5465
5471; mul 404 4466; add 5472 5473; mul 404 4469; sub 5474 5475; mul 428 4459; add 4249 5477; mul 430 5478; add 5476
5479; mul 398 4504; add 5480 5481; mul 398 4513; add 5482 5483; sub 4710 4709; mul 406 4464; sub 5485 5486; mul 417
4472; add 5487 5488; mul 423 5489; add 5484 5490; mul 415 4475; add 5491 5492; mul 1352 4170; mul 1928 4130; sub
5494 5495; mul 441 4231; sub 5496 5497; mul 421 4663; mul 418 5499; add 5498 5500; sub 5447 5451; mul 417 4664; sub
5502 5503; mul 399 4667; add 5504 5505; mul 418 5506; add 5501 5507; mul 404 4669; add 5508 5509; mul 404 4675; add
5510 5511; mul 428 4663; sub 5513 5425; mul 430 5514; add 5512 5515; mul 398 4715; add 5516 5517; mul 398 4720; add
5518 5519; mul 417 4678; mul 406 4667; sub 5521 5522; mul 423 5523; add 5520 5524; mul 415 4682; add 5525 5526; sub
4241 4251; sub 4466 4469; add 4669 4675; mul 258 4322; mul 258 4529; mul 258 4736; mul 267 3995; mul 267 5534; mul
74 658; mul 2 5536; add 682 5537; mul 2 5538; add 5535 5539; mul 393 5427; mul 98 5541; mul 3981 4129; sub 5542
5543; mul 393 5432; mul 98 5545; add 5544 5546; mul 397 4242; add 5547 5548; mul 397 4252; sub 5549 5550; mul 82
196; mul 393 5439; mul 5552 5553; add 5551 5554; mul 2 5555; add 5540 5556; mul 267 4368; mul 267 5558; mul 74 1526;
mul 2 5560; sub 5561 1539; mul 2 5562; add 5559 5563; mul 393 5463; mul 98 5565; add 4286 5566; mul 393 5470; mul 98
5568; add 5567 5569; mul 397 4467; add 5570 5571; mul 397 4470; sub 5572 5573; mul 393 5478; mul 5552 5575; add 5574
5576; mul 2 5577; add 5564 5578; mul 267 4573; mul 267 5580; mul 74 2108; mul 2 5582; add 2120 5583; mul 2 5584; add
5581 5585; mul 393 5499; mul 98 5587; mul 3991 4129; sub 5588 5589; mul 393 5506; mul 98 5591; add 5590 5592; mul
397 4670; add 5593 5594; mul 397 4676; add 5595 5596; mul 393 5514; mul 5552 5598; add 5597 5599; mul 2 5600; add
5586 5601; mul 74 2548; mul 2 5603; add 2559 5604; mul 2 5605; mul 74 2656; mul 2 5607; add 2671 5608; mul 2 5609;
mul 255 3995; mul 267 5611; mul 255 5534; add 5612 5613; mul 27 5536; add 563 5615; mul 2 5616; add 5614 5617; mul
27 5538; add 5618 5619; mul 27 5555; add 5620 5621; mul 2 4311; add 5622 5623; mul 255 4368; mul 267 5625; mul 255
5558; add 5626 5627; mul 27 5560; add 1370 5629; mul 2 5630; add 5628 5631; mul 27 5562; add 5632 5633; mul 27 5577;
add 5634 5635; mul 2 4518; add 5636 5637; mul 255 4573; mul 267 5639; mul 255 5580; add 5640 5641; mul 27 5582; add
2030 5643; mul 2 5644; add 5642 5645; mul 27 5584; add 5646 5647; mul 27 5600; add 5648 5649; mul 2 4725; add 5650
5651; mul 27 5603; add 2509 5653; mul 2 5654; mul 27 5605; add 5655 5656; mul 27 5607; add 2658 5658; mul 2 5659;
mul 27 5609; add 5660 5661; mul 255 5611; mul 27 5616; add 5663 5664; mul 27 4311; add 5665 5666; mul 255 5625; mul
27 5630; add 5668 5669; mul 27 4518; add 5670 5671; mul 255 5639; mul 27 5644; add 5673 5674; mul 27 4725; add 5675
5676; mul 27 5654; mul 27 5659; mul 287 3995; mul 267 5680; mul 287 5534; add 5681 5682; mul 59 5536; add 466 5684;
mul 2 5685; add 5683 5686; mul 59 5538; add 5687 5688; mul 59 5555; add 5689 5690; mul 82 5541; sub 5692 5589; mul
82 5545; add 5693 5694; mul 397 4298; add 5695 5696; mul 397 4306; add 5697 5698; mul 98 196; mul 393 5452; mul 5700
5701; add 5699 5702; mul 2 5703; add 5691 5704; mul 287 4368; mul 267 5706; mul 287 5558; add 5707 5708; mul 59
5560; sub 5710 1448; mul 2 5711; add 5709 5712; mul 59 5562; add 5713 5714; mul 59 5577; add 5715 5716; mul 82 5565;
add 4704 5718; mul 82 5568; add 5719 5720; mul 397 4505; add 5721 5722; mul 397 4514; add 5723 5724; mul 393 5489;
mul 5700 5726; add 5725 5727; mul 2 5728; add 5717 5729; mul 287 4573; mul 267 5731; mul 287 5580; add 5732 5733;
mul 59 5582; add 1951 5735; mul 2 5736; add 5734 5737; mul 59 5584; add 5738 5739; mul 59 5600; add 5740 5741; mul
82 5587; mul 4129 4569; sub 5743 5744; mul 82 5591; add 5745 5746; mul 397 4716; add 5747 5748; mul 397 4721; add
5749 5750; mul 393 5523; mul 5700 5752; add 5751 5753; mul 2 5754; add 5742 5755; mul 59 5603; add 2507 5757; mul 2
5758; mul 59 5605; add 5759 5760; mul 59 5607; add 2618 5762; mul 2 5763; mul 59 5609; add 5764 5765; mul 255 5680;
mul 287 5611; add 5767 5768; mul 27 5685; add 5769 5770; mul 59 5616; add 5771 5772; mul 27 5703; add 5773 5774; mul
59 4311; add 5775 5776; mul 255 5706; mul 287 5625; add 5778 5779; mul 27 5711; add 5780 5781; mul 59 5630; add 5782
5783; mul 27 5728; add 5784 5785; mul 59 4518; add 5786 5787; mul 255 5731; mul 287 5639; add 5789 5790; mul 27
5736; add 5791 5792; mul 59 5644; add 5793 5794; mul 27 5754; add 5795 5796; mul 59 4725; add 5797 5798; mul 27
5758; mul 59 5654; add 5800 5801; mul 27 5763; mul 59 5659; add 5803 5804; mul 287 5680; mul 59 5685; add 5806 5807;
mul 59 5703; add 5808 5809; mul 287 5706; mul 59 5711; add 5811 5812; mul 59 5728; add 5813 5814; mul 287 5731; mul
59 5736; add 5816 5817; mul 59 5754; add 5818 5819; mul 59 5758; mul 59 5763; mul 174 4023; mul 394 5823; sub 452
5824; mul 174 4389; mul 394 5826; add 1356 5827; mul 174 4596; mul 394 5829; sub 1937 5830; mul 3979 4277; mul 72
5823; sub 5832 5833; mul 3979 4281; add 5834 5835; mul 395 4311; add 5836 5837; mul 401 4266; add 5838 5839; mul 72
5826; mul 3979 4489; add 5841 5842; mul 3979 4492; add 5843 5844; mul 395 4518; add 5845 5846; mul 401 4478; add
5847 5848; mul 3979 4695; mul 72 5829; sub 5850 5851; mul 3979 4699; add 5852 5853; mul 395 4725; add 5854 5855; mul
401 4685; add 5856 5857; neg 443; neg 228; neg 351; neg 231; neg 354; neg 235; neg 358; input p 219; mul 328 491;
mul 5866 5867; add 491 5868; input p 220; mul 5867 5870; mul 74 5871; add 5869 5872; add 589 5873; mul 205 589; mul
5866 5875; add 5874 5876; mul 5870 5875; mul 74 5878; add 5877 5879; mul 328 1384; mul 5866 5881; add 1384 5882; mul
5870 5881; mul 74 5884; add 5883 5885; add 1475 5886; mul 205 1475; mul 5866 5888; add 5887 5889; mul 5870 5888; mul
74 5891; add 5890 5892; neg 5893; mul 328 1973; mul 5866 5895; add 1973 5896; mul 5870 5895; mul 74 5898; add 5897
5899; add 2053 5900; mul 205 2053; mul 5866 5902; add 5901 5903; mul 5870 5902; mul 74 5905; add 5904 5906; mul 205
2521; mul 5866 5908; add 2521 5909; mul 5870 5908; mul 74 5911; add 5910 5912; mul 328 2629; mul 5866 5914; add 2629
5915; mul 5870 5914; mul 74 5917; add 5916 5918; le 7 4192; le 4192 7; add 5920 5921; div 17 5922; mul 5920 5923;
mul 267 445; mul 5924 5925; neg 5926; mul 267 443; mul 5924 5928; mul 267 441; mul 5924 5930; neg 5931; mul 4206
5925; neg 5933; mul 4206 5928; mul 4206 5930; neg 5936; mul 445 4215; mul 267 5938; neg 5939; mul 443 4215; mul 267
5941; mul 441 4215; mul 267 5943; neg 5944; input p 221; mul 4215 4216; mul 445 5947; mul 196 4214; div 17 5949; mul
5948 5950; mul 5946 5951; mul 443 5947; mul 5950 5953; mul 5946 5954; neg 5955; mul 441 5947; mul 5950 5957; mul
5946 5958; mul 443 4161; mul 1343 4161; neg 5961; mul 1352 4161; le 17 4148; mul 255 4162; add 267 5965; lt 7 5966;
and 5964 5967; constant -1.0; le 4148 5969; lt 5966 7; and 5970 5971; or 5968 5972; not 5973; input p 173; mul 255
5975; where 5974 5976; le 17 4151; and 5967 5978; le 4151 5969; and 5971 5980; or 5979 5981; not 5982; input p 174;
mul 255 5984; where 5983 5985; le 17 4155; and 5967 5987; le 4155 5969; and 5971 5989; or 5988 5990; not 5991; input
p 175; mul 255 5993; where 5992 5994; le 17 4159; and 5967 5996; le 4159 5969; and 5971 5998; or 5997 5999; not
6000; input p 176; mul 255 6002; where 6001 6003; mul 170 4052; mul 170 4039; mul 174 4042; add 6006 6007; mul 174
657; add 6008 6009; sub 6005 6010; mul 170 4406; mul 174 4409; add 6012 6013; mul 174 1525; sub 6014 6015; mul 170
4418; add 6016 6017; mul 170 4623; mul 170 4611; mul 174 4614; add 6020 6021; mul 174 2107; add 6022 6023; sub 6019
6024; mul 170 4779; mul 170 4770; mul 174 4768; add 6027 6028; mul 174 2548; add 6029 6030; sub 6026 6031; mul 170
4042; mul 174 4039; sub 6033 6034; mul 170 657; add 6035 6036; mul 174 4052; add 6037 6038; mul 174 4406; mul 170
4409; sub 6040 6041; mul 170 1525; add 6042 6043; mul 174 4418; add 6044 6045; mul 170 4614; mul 174 4611; sub 6047
6048; mul 170 2107; add 6049 6050; mul 174 4623; add 6051 6052; mul 170 4768; mul 174 4770; sub 6054 6055; mul 170
2548; add 6056 6057; mul 174 4779; add 6058 6059; neg 4052; neg 4418; neg 4623; neg 4779; mul 178 193; mul 637 6065;
mul 178 242; mul 620 6067; add 6066 6068; mul 178 226; mul 461 6070; add 6069 6071; mul 178 189; mul 653 6073; add
6072 6074; neg 6075; mul 1490 6067; mul 1505 6065; sub 6077 6078; mul 1365 6070; add 6079 6080; mul 1521 6073; sub
6081 6082; mul 2087 6065; mul 2071 6067; add 6084 6085; mul 1946 6070; add 6086 6087; mul 2103 6073; add 6088 6089;
neg 6090; mul 2538 6065; mul 2524 6067; add 6092 6093; mul 2544 6073; add 6094 6095; neg 6096; mul 200 639; mul 200
1507; neg 6099; mul 200 2089; neg 1484; mul 207 611; mul 207 1484; neg 6104; mul 207 2065; mul 223 592; mul 215
6107; neg 6108; mul 223 1463; mul 215 6110; mul 223 2056; mul 215 6112; neg 6113; input p 222; mul 205 596; mul 6115
6116; add 596 6117; input p 223; mul 6116 6119; mul 74 6120; add 6118 6121; neg 6122; mul 205 1479; mul 6115 6124;
add 1479 6125; mul 6119 6124; mul 74 6127; add 6126 6128; mul 205 2060; mul 6115 6130; add 2060 6131; mul 6119 6130;
mul 74 6133; add 6132 6134; neg 6135; mul 249 461; mul 228 6137; mul 249 1365; mul 228 6139; neg 6140; mul 249 1946;
mul 228 6142; mul 231 6137; mul 231 6139; neg 6145; mul 231 6142; mul 235 6137; mul 235 6139; neg 6149; mul 235
6142; mul 249 582; mul 249 1468; neg 6153; mul 249 2046; mul 170 4025; mul 174 4021; add 6156 6157; mul 174 559; add
6158 6159; mul 170 4036; sub 6160 6161; mul 174 1445; mul 170 4391; mul 174 4394; add 6164 6165; sub 6163 6166; mul
170 4403; sub 6167 6168; mul 170 4598; mul 174 4594; add 6170 6171; mul 174 2027; add 6172 6173; mul 170 4608; sub
6174 6175; mul 170 4809; mul 174 4811; add 6177 6178; mul 174 2656; add 6179 6180; mul 170 4820; sub 6181 6182; mul
170 4021; mul 174 4025; sub 6184 6185; mul 170 559; add 6186 6187; mul 174 4036; add 6188 6189; mul 174 4391; mul
170 4394; sub 6191 6192; mul 170 1445; add 6193 6194; mul 174 4403; add 6195 6196; mul 170 4594; mul 174 4598; sub
6198 6199; mul 170 2027; add 6200 6201; mul 174 4608; add 6202 6203; mul 170 4811; mul 174 4809; sub 6205 6206; mul
170 2656; add 6207 6208; mul 174 4820; add 6209 6210; mul 305 320; mul 539 6212; mul 305 364; mul 522 6214; add 6213
6215; mul 305 349; mul 454 6217; add 6216 6218; mul 305 316; mul 555 6220; add 6219 6221; neg 6222; mul 1399 6214;
mul 1421 6212; sub 6224 6225; mul 1358 6217; add 6226 6227; mul 1437 6220; sub 6228 6229; mul 2007 6212; mul 1991
6214; add 6231 6232; mul 1939 6217; add 6233 6234; mul 2023 6220; add 6235 6236; neg 6237; mul 2646 6212; mul 2632
6214; add 6239 6240; mul 2652 6220; add 6241 6242; neg 6243; mul 326 541; mul 326 1423; neg 6246; mul 326 2009; neg
1393; mul 330 513; mul 330 1393; neg 6251; mul 330 1985; mul 346 494; mul 338 6254; neg 6255; mul 346 1372; mul 338
6257; mul 346 1976; mul 338 6259; neg 6260; input p 224; mul 328 498; mul 6262 6263; add 498 6264; input p 225; mul
6263 6266; mul 74 6267; add 6265 6268; neg 6269; mul 328 1388; mul 6262 6271; add 1388 6272; mul 6266 6271; mul 74
6274; add 6273 6275; mul 328 1980; mul 6262 6277; add 1980 6278; mul 6266 6277; mul 74 6280; add 6279 6281; neg
6282; mul 369 454; mul 351 6284; mul 369 1358; mul 351 6286; neg 6287; mul 369 1939; mul 351 6289; mul 354 6284; mul
354 6286; neg 6292; mul 354 6289; mul 358 6284; mul 358 6286; neg 6296; mul 358 6289; mul 369 484; mul 369 1377; neg
6300; mul 369 1966; mul 443 4162; sub 6303 445; mul 4148 6304; mul 1343 4162; sub 443 6306; mul 4148 6307; mul 1352
4162; sub 6309 441; mul 4148 6310; mul 4151 6304; mul 4151 6307; mul 4151 6310; mul 4155 6304; mul 4155 6307; mul
4155 6310; mul 4159 6304; mul 4159 6307; mul 4159 6310; mul 5966 5975; mul 5975 6321; neg 6322; where 5974 6323; mul
5966 5984; mul 5984 6325; neg 6326; where 5983 6327; mul 5966 5993; mul 5993 6329; neg 6330; where 5992 6331; mul
5966 6002; mul 6002 6333; neg 6334; where 6001 6335; mul 445 4222; neg 6337; mul 443 4222; mul 441 4222; neg 6340;
mul 445 4226; neg 6342; mul 443 4226; mul 441 4226; neg 6345; mul 3 1337; neg 6347; mul 3 1922; mul 3 2503; neg
6350; store by_k 108 1339; store by_k 324 1924; store by_k 540 2505; store by_k 648 2616; store by_k 756 2727; store
by_k 864 2616; store by_k 972 2727; store by_k 1080 2616; store by_k 1188 2727; store by_k 109 2871; store by_k 325
2876; store by_k 541 2881; store by_k 110 2898; store by_k 326 2908; store by_k 542 2918; store by_k 111 3053; store
by_k 327 3161; store by_k 543 3269; store by_k 112 3435; store by_k 328 3563; store by_k 544 3691; store by_k 113
3768; store by_k 329 3842; store by_k 545 3916; store by_k 114 3923; store by_k 330 3930; store by_k 546 3937; store
by_k 115 3944; store by_k 331 3951; store by_k 547 3958; store by_k 116 3965; store by_k 332 3969; store by_k 548
3976; store by_k 117 4354; store by_k 333 4560; store by_k 549 4767; store by_k 657 4808; store by_k 765 4849; store
by_k 873 4808; store by_k 981 4849; store by_k 1089 4808; store by_k 1197 4849; store by_k 118 4852; store by_k 334
4854; store by_k 550 4857; store by_k 119 4861; store by_k 335 4865; store by_k 551 4869; store by_k 120 4874; store
by_k 336 4878; store by_k 552 4883; store by_k 121 4889; store by_k 337 4895; store by_k 553 4901; store by_k 122
4908; store by_k 338 4914; store by_k 554 4921; store by_k 123 4928; store by_k 339 4933; store by_k 555 4940; store
by_k 124 4944; store by_k 340 4948; store by_k 556 4952; store by_k 125 4958; store by_k 341 4965; store by_k 557
4971; store by_k 126 4978; store by_k 342 4984; store by_k 558 4991; store by_k 127 4995; store by_k 343 4998; store
by_k 559 5002; store by_k 128 5004; store by_k 344 5007; store by_k 560 5009; store by_k 129 5013; store by_k 345
5017; store by_k 561 5021; store by_k 130 5027; store by_k 346 5033; store by_k 562 5039; store by_k 131 5042; store
by_k 347 5045; store by_k 563 5048; store by_k 132 5050; store by_k 348 5051; store by_k 564 5053; store by_k 133
5058; store by_k 349 5062; store by_k 565 5067; store by_k 134 5074; store by_k 350 5080; store by_k 566 5087; store
by_k 135 5094; store by_k 351 5100; store by_k 567 5107; store by_k 136 5113; store by_k 352 5120; store by_k 568
5126; store by_k 137 5133; store by_k 353 5140; store by_k 569 5147; store by_k 138 5154; store by_k 354 5160; store
by_k 570 5167; store by_k 139 5171; store by_k 355 5175; store by_k 571 5179; store by_k 140 5185; store by_k 356
5192; store by_k 572 5198; store by_k 141 5205; store by_k 357 5211; store by_k 573 5218; store by_k 142 5223; store
by_k 358 5227; store by_k 574 5232; store by_k 143 5234; store by_k 359 5236; store by_k 575 5238; store by_k 683
5240; store by_k 791 5242; store by_k 899 5240; store by_k 1007 5242; store by_k 1115 5240; store by_k 1223 5242;
store by_k 144 5246; store by_k 360 5250; store by_k 576 5254; store by_k 684 5258; store by_k 792 5262; store by_k
900 5258; store by_k 1008 5262; store by_k 1116 5258; store by_k 1224 5262; store by_k 145 5266; store by_k 361
5270; store by_k 577 5274; store by_k 685 5278; store by_k 793 5282; store by_k 901 5278; store by_k 1009 5282;
store by_k 1117 5278; store by_k 1225 5282; store by_k 146 5287; store by_k 362 5292; store by_k 578 5297; store
by_k 686 5302; store by_k 794 5307; store by_k 902 5302; store by_k 1010 5307; store by_k 1118 5302; store by_k 1226
5307; store by_k 147 5313; store by_k 363 5319; store by_k 579 5325; store by_k 687 5331; store by_k 795 5337; store
by_k 903 5331; store by_k 1011 5337; store by_k 1119 5331; store by_k 1227 5337; store by_k 148 5341; store by_k 364
5345; store by_k 580 5349; store by_k 688 5353; store by_k 796 5357; store by_k 904 5353; store by_k 1012 5357;
store by_k 1120 5353; store by_k 1228 5357; store by_k 149 5363; store by_k 365 5369; store by_k 581 5375; store
by_k 689 5381; store by_k 797 5387; store by_k 905 5381; store by_k 1013 5387; store by_k 1121 5381; store by_k 1229
5387; store by_k 150 5389; store by_k 366 5391; store by_k 582 5393; store by_k 690 5395; store by_k 798 5397; store
by_k 906 5395; store by_k 1014 5397; store by_k 1122 5395; store by_k 1230 5397; store by_k 151 5401; store by_k 367
5405; store by_k 583 5409; store by_k 691 5413; store by_k 799 5417; store by_k 907 5413; store by_k 1015 5417;
store by_k 1123 5413; store by_k 1231 5417; store by_k 152 5456; store by_k 368 5493; store by_k 584 5527; store
by_k 153 5528; store by_k 369 5529; store by_k 585 5530; store by_k 154 4263; store by_k 370 4475; store by_k 586
4682; store by_k 155 5531; store by_k 371 5532; store by_k 587 5533; store by_k 156 5452; store by_k 372 5489; store
by_k 588 5523; store by_k 157 5557; store by_k 373 5579; store by_k 589 5602; store by_k 697 5606; store by_k 805
5610; store by_k 913 5606; store by_k 1021 5610; store by_k 1129 5606; store by_k 1237 5610; store by_k 158 5624;
store by_k 374 5638; store by_k 590 5652; store by_k 698 5657; store by_k 806 5662; store by_k 914 5657; store by_k
1022 5662; store by_k 1130 5657; store by_k 1238 5662; store by_k 159 5667; store by_k 375 5672; store by_k 591
5677; store by_k 699 5678; store by_k 807 5679; store by_k 915 5678; store by_k 1023 5679; store by_k 1131 5678;
store by_k 1239 5679; store by_k 160 5705; store by_k 376 5730; store by_k 592 5756; store by_k 700 5761; store by_k
808 5766; store by_k 916 5761; store by_k 1024 5766; store by_k 1132 5761; store by_k 1240 5766; store by_k 161
5777; store by_k 377 5788; store by_k 593 5799; store by_k 701 5802; store by_k 809 5805; store by_k 917 5802; store
by_k 1025 5805; store by_k 1133 5802; store by_k 1241 5805; store by_k 162 5810; store by_k 378 5815; store by_k 594
5820; store by_k 702 5821; store by_k 810 5822; store by_k 918 5821; store by_k 1026 5822; store by_k 1134 5821;
store by_k 1242 5822; store by_k 163 5825; store by_k 379 5828; store by_k 595 5831; store by_k 164 5840; store by_k
380 5849; store by_k 596 5858; store by_k 165 445; store by_k 381 5859; store by_k 597 441; store by_k 706 5860;
store by_k 814 5861; store by_k 923 5862; store by_k 1031 5863; store by_k 1140 5864; store by_k 1248 5865; store
by_k 169 5880; store by_k 385 5894; store by_k 601 5907; store by_k 709 5913; store by_k 817 5919; store by_k 925
5913; store by_k 1033 5919; store by_k 1141 5913; store by_k 1249 5919; store by_k 170 5927; store by_k 386 5929;
store by_k 602 5932; store by_k 171 5934; store by_k 387 5935; store by_k 603 5937; store by_k 172 5940; store by_k
388 5942; store by_k 604 5945; store by_k 173 5952; store by_k 389 5956; store by_k 605 5959; store by_k 174 5960;
store by_k 390 5962; store by_k 606 5963; store by_k 1578 5977; store by_k 1686 5986; store by_k 1794 5995; store
by_k 1902 6004; store by_k 175 6011; store by_k 391 6018; store by_k 607 6025; store by_k 715 6032; store by_k 931
6032; store by_k 1147 6032; store by_k 176 6039; store by_k 392 6046; store by_k 608 6053; store by_k 716 6060;
store by_k 932 6060; store by_k 1148 6060; store by_k 177 6061; store by_k 393 6062; store by_k 609 6063; store by_k
717 6064; store by_k 933 6064; store by_k 1149 6064; store by_k 178 657; store by_k 394 1525; store by_k 610 2107;
store by_k 718 2548; store by_k 934 2548; store by_k 1150 2548; store by_k 179 6076; store by_k 395 6083; store by_k
611 6091; store by_k 719 6097; store by_k 935 6097; store by_k 1151 6097; store by_k 180 6098; store by_k 396 6100;
store by_k 612 6101; store by_k 181 611; store by_k 397 6102; store by_k 613 2065; store by_k 182 6103; store by_k
398 6105; store by_k 614 6106; store by_k 183 6109; store by_k 399 6111; store by_k 615 6114; store by_k 184 6123;
store by_k 400 6129; store by_k 616 6136; store by_k 185 6138; store by_k 401 6141; store by_k 617 6143; store by_k
186 6144; store by_k 402 6146; store by_k 618 6147; store by_k 187 6148; store by_k 403 6150; store by_k 619 6151;
store by_k 188 6152; store by_k 404 6154; store by_k 620 6155; store by_k 189 6162; store by_k 405 6169; store by_k
621 6176; store by_k 837 6183; store by_k 1053 6183; store by_k 1269 6183; store by_k 190 6190; store by_k 406 6197;
store by_k 622 6204; store by_k 838 6211; store by_k 1054 6211; store by_k 1270 6211; store by_k 191 4036; store
by_k 407 4403; store by_k 623 4608; store by_k 839 4820; store by_k 1055 4820; store by_k 1271 4820; store by_k 192
559; store by_k 408 1445; store by_k 624 2027; store by_k 840 2656; store by_k 1056 2656; store by_k 1272 2656;
store by_k 193 6223; store by_k 409 6230; store by_k 625 6238; store by_k 841 6244; store by_k 1057 6244; store by_k
1273 6244; store by_k 194 6245; store by_k 410 6247; store by_k 626 6248; store by_k 195 513; store by_k 411 6249;
store by_k 627 1985; store by_k 196 6250; store by_k 412 6252; store by_k 628 6253; store by_k 197 6256; store by_k
413 6258; store by_k 629 6261; store by_k 198 6270; store by_k 414 6276; store by_k 630 6283; store by_k 199 6285;
store by_k 415 6288; store by_k 631 6290; store by_k 200 6291; store by_k 416 6293; store by_k 632 6294; store by_k
201 6295; store by_k 417 6297; store by_k 633 6298; store by_k 202 6299; store by_k 418 6301; store by_k 634 6302;
store by_k 203 6305; store by_k 419 6308; store by_k 635 6311; store by_k 204 6312; store by_k 420 6313; store by_k
636 6314; store by_k 205 6315; store by_k 421 6316; store by_k 637 6317; store by_k 206 6318; store by_k 422 6319;
store by_k 638 6320; store by_k 1611 6324; store by_k 1720 6328; store by_k 1829 6332; store by_k 1938 6336; store
by_k 211 6338; store by_k 427 6339; store by_k 643 6341; store by_k 212 6343; store by_k 428 6344; store by_k 644
6346; store by_k 1401 4222; store by_k 1510 4226; store by_k 215 6348; store by_k 431 6349; store by_k 647 6351
    """,
)
