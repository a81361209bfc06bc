"""Exact derivatives of the condensed joint's rates.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from ..codegen.graph import Graph

PREPARE = Graph(
    {'k': 114},
    {'p': 276},
    """
input k 46; input k 47; constant 1.0; input k 9; sub 3 2; input k 44; input k 56; input k 50; input k 51; input k
53; input k 48; input k 52; input k 54; input k 49; input k 45; input k 113; input k 0; div 2 16; mul 15 17;
constant 0.5; constant -0.5; input k 2; mul 20 21; input k 7; mul 23 23; mul 22 24; constant 4.0; input k 6; mul 15
23; add 27 28; mul 29 29; mul 26 30; constant -12.0; mul 29 32; add 31 33; constant 12.0; add 34 35; div 2 35; mul
36 37; input k 8; mul 39 39; constant 0.8; div 2 41; mul 40 42; add 38 43; div 2 44; mul 25 45; input k 62; input k
1; constant -6.000000000000002; constant -18.000000000000004; input k 5; mul 51 51; input k 4; mul 52 53; mul 50 54;
add 49 55; constant -0.09999999999999992; input k 3; mul 52 58; mul 57 59; add 56 60; constant 28.80000000000001;
mul 51 53; mul 62 63; constant -22.628571428571426; mul 53 65; constant -0.0571428571428573; mul 58 67; add 66 68;
constant 36.0; mul 63 70; constant -28.799999999999997; mul 53 72; constant 0.05714285714285805; mul 58 74; add 73
75; constant -50.400000000000006; mul 53 77; constant -1.1428571428571421; mul 58 79; add 78 80; constant
12.000000000000004; constant 36.000000000000014; mul 54 83; add 82 84; constant 1.1999999999999995; mul 59 86; add
85 87; constant -57.60000000000002; mul 63 89; constant 45.25714285714285; mul 53 91; constant 0.9142857142857148;
mul 58 93; add 92 94; constant -72.00000000000001; mul 63 96; constant 57.59999999999996; mul 53 98; constant
-1.7142857142857146; mul 58 100; add 99 101; constant 230.40000000000006; mul 53 103; constant 2.057142857142853;
mul 58 105; add 104 106; constant -388.80000000000024; mul 53 108; constant -7.71428571428571; mul 58 110; add 109
111; constant 259.2000000000001; mul 53 113; constant 12.342857142857142; mul 58 115; add 114 116; constant
-0.9999999999999998; mul 51 118; mul 51 52; mul 53 120; mul 118 121; add 119 122; constant -0.03333333333333334; mul
59 124; constant -2.399999999999998; mul 63 126; constant 0.45714285714285574; mul 53 128; constant
-0.019047619047619042; mul 58 130; add 129 131; constant 4.000000000000001; mul 35 54; add 133 134; constant
0.13333333333333333; mul 59 136; add 135 137; constant -14.400000000000006; mul 63 139; constant 13.714285714285712;
mul 53 141; constant 0.11428571428571417; mul 58 143; add 142 144; constant -30.000000000000007; mul 63 146; mul 51
58; sub 147 148; constant 21.599999999999998; mul 53 150; constant 0.6571428571428561; mul 58 152; add 151 153;
constant 35.20000000000001; mul 53 155; constant 2.438095238095238; mul 58 157; add 156 158; constant 72.0; mul 63
160; constant -57.599999999999994; mul 53 162; constant 0.1142857142857161; mul 58 164; add 163 165; constant
-151.20000000000002; mul 53 167; constant -3.428571428571426; mul 58 169; add 168 170; constant -36.00000000000001;
mul 63 172; constant 28.79999999999998; mul 53 174; constant -0.8571428571428573; mul 58 176; add 175 177; constant
-129.60000000000008; mul 53 179; constant -2.57142857142857; mul 58 181; add 180 182; constant 3.0; input k 25; mul
184 185; input k 26; constant 2.0; mul 187 188; input k 27; mul 188 190; input k 28; input k 29; input k 30; input k
10; mul 26 195; input k 11; mul 184 197; input k 12; mul 184 199; input k 13; mul 188 201; input k 14; mul 188 203;
input k 15; mul 188 205; input k 16; input k 17; input k 18; input k 19; constant -6.0; input k 55; input k 72;
input k 67; input k 69; input k 68; input k 70; sub 217 16; input k 35; mul 26 219; input k 36; mul 184 221; input k
37; mul 184 223; input k 38; mul 188 225; input k 39; mul 188 227; input k 40; input k 41; mul 184 229; mul 188 230;
input k 42; mul 26 233; input k 43; mul 184 235; input k 71; div 2 237; input k 73; input k 74; input k 111; input k
75; input k 76; mul 19 243; constant 0.7142857142857143; sub 243 245; mul 244 246; input k 77; input k 78; input k
79; input k 61; mul 19 251; sub 251 245; mul 252 253; input k 80; input k 86; input k 82; input k 81; input k 83;
input k 84; sub 260 16; input k 85; div 2 262; input k 87; input k 88; input k 89; input k 90; mul 19 267; sub 267
245; mul 268 269; input k 91; input k 92; input k 93; input k 94; input k 57; input k 95; input k 96; input k 97;
input k 98; constant 0.7745966692414834; constant 0.2777777777777778; input k 99; mul 281 282; input k 100; mul 281
284; constant -0.7745966692414834; input k 63; input k 64; input k 65; mul 289 289; input k 107; input k 108; mul 3
188; mul 188 192; input k 31; mul 184 295; input k 32; mul 188 297; input k 33; mul 184 207; mul 188 208; input k
20; mul 26 302; input k 21; mul 184 304; input k 22; mul 188 306; input k 23; mul 6 212; input k 66; constant
-0.22063166795407502; mul 16 311; constant 0.4444444444444444; mul 282 313; constant 0.16666666666666669; mul 16
315; mul 284 313; constant 0.5539650012874084; mul 16 318; constant 2.4; mul 54 320; add 41 321; constant
0.019047619047619053; mul 59 323; add 322 324; constant -1.3714285714285719; mul 63 326; constant 1.371428571428571;
mul 53 328; constant 0.007256235827664402; mul 58 330; add 329 331; constant -4.799999999999996; mul 63 333;
constant 1.3714285714285672; mul 53 335; constant -0.05714285714285713; mul 58 337; add 336 338; constant
-7.200000000000003; mul 63 340; constant 7.199999999999999; mul 53 342; constant 0.2190476190476187; mul 58 344; add
343 345; constant -45.25714285714285; mul 53 347; constant -0.1142857142857146; mul 58 349; add 348 350; constant
-28.80000000000001; mul 63 352; mul 188 194; mul 188 299; input k 34; mul 184 356; mul 188 209; mul 184 210; mul 184
308; input k 24; mul 26 361; mul 21 41; mul 16 136; constant -0.16666666666666669; mul 16 365; input k 58; input k
59; input k 60; input k 109; input k 110; input k 112; input k 101; div 2 373; input k 102; div 2 375; input k 103;
div 2 377; input k 104; div 2 379; input k 105; div 2 381; input k 106; div 2 383; mul 17 27; mul 61 385; mul 17 88;
mul 138 385; mul 17 61; add 291 292; mul 125 385; mul 17 35; mul 211 385; add 392 393; mul 21 394; mul 17 211; mul
26 385; add 396 397; mul 21 398; mul 27 399; add 395 400; mul 17 401; mul 23 399; mul 39 399; mul 280 382; mul 280
384; mul 286 382; mul 286 384; mul 23 61; mul 23 138; mul 23 125; mul 23 211; mul 21 412; mul 23 26; mul 21 414; mul
27 415; add 413 416; mul 17 417; mul 23 415; mul 39 415; mul 310 374; mul 310 376; mul 310 378; mul 310 380; mul 312
382; mul 312 384; mul 316 382; mul 316 384; mul 319 382; mul 319 384; mul 39 61; mul 39 138; mul 39 125; mul 26 39;
mul 21 434; mul 23 435; mul 39 211; mul 21 437; mul 27 435; add 438 439; mul 17 440; mul 39 435; add 363 442; mul
364 382; mul 364 384; mul 366 382; mul 366 384; neg 367; neg 368; neg 369; neg 370; neg 371; neg 372; mul 276 310;
mul 277 310; mul 278 310; mul 279 310; mul 283 312; constant 0.21516574145596762; mul 282 459; mul 283 364; mul 285
312; mul 284 459; mul 285 364; mul 314 316; mul 314 366; mul 316 317; mul 317 366; mul 283 319; constant
-0.21516574145596762; mul 282 470; mul 285 319; mul 284 470; mul 17 18; mul 51 188; mul 45 46; mul 29 188; mul 23
188; mul 39 188; mul 188 289; store p 0 0; store p 1 3; store p 2 4; store p 3 1; store p 4 5; store p 5 6; store p
6 7; store p 7 8; store p 8 9; store p 9 10; store p 10 11; store p 11 12; store p 12 13; store p 13 14; store p 14
18; store p 15 46; store p 16 47; store p 17 17; store p 18 48; store p 19 61; store p 20 27; store p 21 23; store p
22 39; store p 23 64; store p 24 69; store p 25 71; store p 26 76; store p 27 81; store p 28 88; store p 29 90;
store p 30 95; store p 31 97; store p 32 102; store p 33 107; store p 34 112; store p 35 117; store p 36 123; store
p 37 125; store p 38 127; store p 39 132; store p 40 138; store p 41 140; store p 42 145; store p 43 149; store p 44
154; store p 45 159; store p 46 161; store p 47 166; store p 48 171; store p 49 173; store p 50 178; store p 51 183;
store p 52 186; store p 53 189; store p 54 191; store p 55 192; store p 56 193; store p 57 194; store p 58 196;
store p 59 198; store p 60 200; store p 61 202; store p 62 204; store p 63 206; store p 64 207; store p 65 208;
store p 66 209; store p 67 210; store p 68 21; store p 69 220; store p 70 222; store p 71 224; store p 72 226; store
p 73 228; store p 74 229; store p 75 230; store p 76 212; store p 77 218; store p 78 16; store p 79 221; store p 80
227; store p 81 231; store p 82 232; store p 83 234; store p 84 236; store p 85 223; store p 86 235; store p 87 216;
store p 88 214; store p 89 238; store p 90 215; store p 91 213; store p 92 239; store p 93 240; store p 94 241;
store p 95 242; store p 96 243; store p 97 247; store p 98 248; store p 99 249; store p 100 250; store p 101 251;
store p 102 254; store p 103 255; store p 104 261; store p 105 257; store p 106 258; store p 107 263; store p 108
259; store p 109 256; store p 110 264; store p 111 265; store p 112 266; store p 113 267; store p 114 270; store p
115 271; store p 116 272; store p 117 273; store p 118 274; store p 119 275; store p 120 276; store p 121 277; store
p 122 278; store p 123 279; store p 124 283; store p 125 285; store p 126 287; store p 127 288; store p 128 290;
store p 129 291; store p 130 292; store p 131 293; store p 132 187; store p 133 294; store p 134 296; store p 135
298; store p 136 299; store p 137 197; store p 138 203; store p 139 300; store p 140 301; store p 141 303; store p
142 305; store p 143 307; store p 144 308; store p 145 309; store p 146 310; store p 147 312; store p 148 314; store
p 149 316; store p 150 317; store p 151 319; store p 152 325; store p 153 327; store p 154 332; store p 155 334;
store p 156 339; store p 157 341; store p 158 346; store p 159 351; store p 160 353; store p 161 190; store p 162
354; store p 163 297; store p 164 355; store p 165 357; store p 166 199; store p 167 358; store p 168 359; store p
169 304; store p 170 360; store p 171 362; store p 172 185; store p 173 295; store p 174 356; store p 175 363; store
p 176 364; store p 177 366; store p 178 367; store p 179 368; store p 180 369; store p 181 370; store p 182 371;
store p 183 372; store p 184 374; store p 185 376; store p 186 378; store p 187 380; store p 188 382; store p 189
384; store p 190 386; store p 191 385; store p 192 387; store p 193 388; store p 194 389; store p 195 390; store p
196 391; store p 197 402; store p 198 403; store p 199 404; store p 200 405; store p 201 406; store p 202 407; store
p 203 408; store p 204 409; store p 205 410; store p 206 411; store p 207 418; store p 208 419; store p 209 420;
store p 210 421; store p 211 422; store p 212 423; store p 213 424; store p 214 425; store p 215 426; store p 216
427; store p 217 428; store p 218 429; store p 219 430; store p 220 431; store p 221 432; store p 222 433; store p
223 436; store p 224 441; store p 225 443; store p 226 444; store p 227 445; store p 228 446; store p 229 447; store
p 230 448; store p 231 449; store p 232 450; store p 233 451; store p 234 452; store p 235 453; store p 236 454;
store p 237 455; store p 238 456; store p 239 457; store p 240 458; store p 241 460; store p 242 461; store p 243
462; store p 244 463; store p 245 464; store p 246 465; store p 247 466; store p 248 467; store p 249 468; store p
250 469; store p 251 471; store p 252 472; store p 253 473; store p 254 474; store p 255 24; store p 256 45; store p
257 52; store p 258 51; store p 259 120; store p 260 53; store p 261 475; store p 262 58; store p 263 476; store p
264 477; store p 265 15; store p 266 478; store p 267 22; store p 268 479; store p 269 252; store p 270 253; store p
271 480; store p 272 244; store p 273 246; store p 274 268; store p 275 269
    """,
)

JACOBIAN = Graph(
    {'x': 15, 'u': 2, 'c': 13, 'z': 10, 'c_q': 13, 'p': 276},
    {'f': 25, 'a': 625, 'b': 50, 'by_c': 325},
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
520; input p 94; input x 14; mul 522 523; sub 2 524; mul 521 525; input p 95; mul 93 527; input p 96; input p 97;
mul 512 530; add 529 531; mul 512 532; add 2 533; mul 528 534; sub 526 535; mul 485 536; input p 98; input x 6; mul
538 539; input p 99; input x 8; mul 541 542; add 540 543; input p 100; input x 10; mul 545 546; add 544 547;
constant -0.5; mul 498 549; mul 498 550; mul 498 551; mul 485 552; input p 101; input p 102; mul 512 555; add 554
556; mul 512 557; add 2 558; mul 553 559; mul 548 560; add 537 561; input p 103; mul 560 563; mul 560 564; sub 480
483; mul 491 566; add 486 489; mul 484 568; sub 567 569; mul 500 570; mul 17 571; mul 130 572; mul 491 500; mul 0
574; sub 573 575; mul 0 431; constant 3.3333333333333335; add 294 298; mul 578 579; sub 2 580; mul 461 581; mul 440
582; add 37 583; mul 130 584; add 577 585; constant 1.25; add 314 318; mul 587 588; sub 2 589; mul 472 590; mul 440
591; add 53 592; mul 395 593; add 586 594; mul 501 595; add 576 596; mul 565 597; add 562 598; mul 501 599; input p
104; add 477 601; input p 105; mul 24 603; add 602 604; input p 106; mul 38 606; add 605 607; input p 107; mul 38
603; mul 24 606; input p 108; sub 611 612; sub 610 613; sub 614 29; mul 615 615; mul 608 608; add 616 617; sqrt 618;
mul 609 619; sqrt 620; div 2 621; mul 622 622; mul 609 623; mul 608 624; input p 109; mul 503 620; mul 503 623; mul
623 628; sub 627 629; mul 626 630; sub 620 511; max 510 632; min 509 633; input p 110; input p 111; mul 634 636; add
635 637; mul 634 638; add 2 639; mul 631 640; mul 525 641; input p 112; mul 97 643; input p 113; input p 114; mul
632 646; add 645 647; mul 632 648; add 2 649; mul 644 650; sub 642 651; mul 609 652; input p 115; input x 7; mul 654
655; input p 116; input x 9; mul 657 658; add 656 659; input p 117; input x 11; mul 661 662; add 660 663; mul 549
622; mul 622 665; mul 622 666; mul 609 667; mul 555 632; add 554 669; mul 632 670; add 2 671; mul 668 672; mul 664
673; add 653 674; input p 118; mul 673 676; mul 673 677; add 604 607; mul 615 679; sub 611 610; mul 608 681; add 680
682; mul 624 683; mul 17 684; mul 130 685; mul 615 624; mul 0 687; sub 686 688; mul 595 625; add 689 690; mul 678
691; add 675 692; mul 625 693; add 600 694; sub 432 695; mul 431 696; sub 409 697; mul 574 599; mul 687 693; add 699
700; sub 698 701; sub 143 702; input p 119; input p 120; input z 0; mul 705 706; input p 121; input z 1; mul 708
709; add 707 710; input p 122; input z 2; mul 712 713; add 711 714; input p 123; input z 3; mul 716 717; add 715
718; constant 0.7745966692414834; input p 124; input z 4; mul 721 722; mul 720 723; add 719 724; input p 125; input
z 5; mul 726 727; mul 720 728; add 725 729; constant -0.7745966692414834; input z 8; mul 721 732; mul 731 733; add
730 734; input z 9; mul 726 736; mul 731 737; add 735 738; sub 704 739; input p 126; abs 0; mul 741 742; mul 0 743;
input p 127; mul 0 745; mul 0 0; input p 128; add 747 748; sqrt 749; div 2 750; mul 746 751; add 744 752; sub 740
753; add 703 754; input p 129; input x 12; sub 29 757; mul 756 758; input p 130; input x 13; sub 29 761; mul 760
762; add 759 763; sub 755 764; mul 0 62; mul 28 130; add 766 767; mul 47 395; add 768 769; mul 0 770; mul 0 28; mul
31 130; add 772 773; mul 34 395; add 774 775; mul 130 776; add 771 777; mul 0 47; mul 34 130; add 779 780; mul 51
395; add 781 782; mul 395 783; add 778 784; mul 17 130; mul 130 786; mul 23 787; input p 131; mul 9 789; mul 9 790;
mul 8 16; mul 10 792; mul 792 793; add 791 794; mul 3 795; mul 38 796; sub 25 797; mul 788 798; add 785 799; mul 67
800; mul 24 796; add 39 802; mul 788 803; sub 801 804; mul 22 805; sub 765 806; mul 90 807; mul 81 89; mul 150 265;
input p 132; mul 285 811; input p 133; mul 304 813; add 812 814; mul 324 331; add 815 816; input p 134; mul 328 818;
add 817 819; input p 135; mul 332 821; add 820 822; input p 136; mul 336 824; add 823 825; mul 339 826; input p 137;
mul 342 828; mul 345 352; add 829 830; input p 138; mul 349 832; add 831 833; input p 139; mul 353 835; add 834 836;
input p 140; mul 357 838; add 837 839; mul 361 372; add 840 841; input p 141; mul 365 843; add 842 844; input p 142;
mul 369 846; add 845 847; input p 143; mul 373 849; add 848 850; input p 144; mul 339 852; add 851 853; add 827 854;
mul 581 855; add 810 856; mul 145 857; mul 584 696; sub 858 859; mul 150 405; add 860 861; mul 572 599; mul 685 693;
add 863 864; add 862 865; sub 134 866; input p 145; mul 38 868; mul 17 869; add 867 870; input p 146; mul 707 872;
mul 710 872; add 873 874; mul 714 872; add 875 876; mul 718 872; add 877 878; input p 147; mul 723 880; add 879 881;
mul 728 880; add 882 883; input p 148; input z 6; mul 885 886; input p 149; mul 887 888; add 884 889; input p 150;
input z 7; mul 891 892; mul 888 893; add 890 894; input p 151; mul 733 896; add 895 897; mul 737 896; add 898 899;
sub 871 900; mul 41 800; mul 26 804; sub 902 903; mul 22 904; mul 19 796; mul 787 906; sub 905 907; sub 901 908; mul
809 909; sub 808 910; mul 86 89; input p 152; mul 35 913; input p 153; mul 214 915; add 914 916; input p 154; mul
218 918; add 917 919; mul 155 210; add 920 921; input p 155; mul 158 923; add 922 924; input p 156; mul 162 926; add
925 927; input p 157; mul 166 929; add 928 930; mul 170 227; add 931 932; input p 158; mul 174 934; add 933 935; mul
157 189; add 936 937; input p 159; mul 193 939; add 938 940; mul 169 197; add 941 942; input p 160; mul 201 944; add
943 945; mul 184 258; add 946 947; mul 202 257; add 948 949; mul 153 265; add 950 951; input p 161; mul 285 953; mul
304 331; add 954 955; input p 162; mul 324 957; add 956 958; input p 163; mul 328 960; add 959 961; input p 164; mul
332 963; add 962 964; input p 165; mul 336 966; add 965 967; mul 339 968; input p 166; mul 342 970; mul 345 832; add
971 972; mul 349 360; add 973 974; mul 353 368; add 975 976; input p 167; mul 357 978; add 977 979; input p 168; mul
361 981; add 980 982; input p 169; mul 365 984; add 983 985; mul 369 849; add 986 987; input p 170; mul 373 989; add
988 990; input p 171; mul 339 992; add 991 993; add 969 994; constant 3.0; mul 336 996; input p 172; mul 342 998;
mul 345 811; add 999 1000; mul 349 953; add 1001 1002; mul 327 353; add 1003 1004; mul 331 357; add 1005 1006; mul
335 361; add 1007 1008; input p 173; mul 365 1010; add 1009 1011; mul 369 960; add 1012 1013; mul 373 824; add 1014
1015; input p 174; mul 339 1017; add 1016 1018; mul 997 1019; add 995 1020; mul 590 1021; add 952 1022; mul 145
1023; mul 593 696; sub 1024 1025; input p 175; mul 395 1027; mul 153 405; add 1028 1029; add 1026 1030; input p 176;
mul 723 1032; mul 728 1032; add 1033 1034; input p 177; mul 887 1036; add 1035 1037; mul 893 1036; add 1038 1039;
mul 733 1032; add 1040 1041; mul 737 1032; add 1042 1043; add 1031 1044; mul 53 800; mul 22 1046; add 1045 1047; mul
912 1048; sub 911 1049; mul 56 70; mul 79 79; sub 1051 1052; mul 89 1053; mul 909 1054; mul 807 809; sub 1055 1056;
mul 59 70; mul 76 79; sub 1058 1059; mul 89 1060; mul 1048 1061; add 1057 1062; mul 807 912; mul 909 1061; sub 1064
1065; mul 45 70; mul 76 76; sub 1067 1068; mul 89 1069; mul 1048 1070; sub 1066 1071; mul 560 597; input p 178; mul
539 1074; sub 1073 1075; mul 673 691; mul 655 1074; sub 1077 1078; input p 179; mul 542 1080; sub 1073 1081; mul 658
1080; sub 1077 1083; input p 180; mul 546 1085; sub 1073 1086; mul 662 1085; sub 1077 1088; input p 181; mul 758
1090; input p 182; mul 762 1092; input p 183; sub 2 523; mul 1094 1095; le 2 706; mul 130 872; add 0 1098; lt 140
1099; and 1097 1100; constant -1.0; le 706 1102; lt 1099 140; and 1103 1104; or 1101 1105; not 1106; input p 184;
mul 1099 1108; where 1107 1109; le 2 709; and 1100 1111; le 709 1102; and 1104 1113; or 1112 1114; not 1115; input p
185; mul 1099 1117; where 1116 1118; le 2 713; and 1100 1120; le 713 1102; and 1104 1122; or 1121 1123; not 1124;
input p 186; mul 1099 1126; where 1125 1127; le 2 717; and 1100 1129; le 717 1102; and 1104 1131; or 1130 1132; not
1133; input p 187; mul 1099 1135; where 1134 1136; le 2 722; mul 0 720; mul 130 880; add 1139 1140; mul 395 1032;
add 1141 1142; lt 140 1143; and 1138 1144; le 722 1102; lt 1143 140; and 1146 1147; or 1145 1148; not 1149; input p
188; mul 1143 1151; where 1150 1152; le 2 727; and 1144 1154; le 727 1102; and 1147 1156; or 1155 1157; not 1158;
input p 189; mul 1143 1160; where 1159 1161; le 2 886; mul 130 888; mul 395 1036; add 1164 1165; lt 140 1166; and
1163 1167; le 886 1102; lt 1166 140; and 1169 1170; or 1168 1171; not 1172; mul 1151 1166; where 1173 1174; le 2
892; and 1167 1176; le 892 1102; and 1170 1178; or 1177 1179; not 1180; mul 1160 1166; where 1181 1182; le 2 732;
mul 0 731; mul 130 896; add 1185 1186; add 1142 1187; lt 140 1188; and 1184 1189; le 732 1102; lt 1188 140; and 1191
1192; or 1190 1193; not 1194; mul 1151 1188; where 1195 1196; le 2 736; and 1189 1198; le 736 1102; and 1192 1200;
or 1199 1201; not 1202; mul 1160 1188; where 1203 1204; mul 41 503; mul 28 1206; mul 22 1207; mul 56 1208; mul 53
503; mul 47 1210; mul 22 1211; mul 45 1212; add 1209 1213; mul 28 53; mul 41 47; add 1215 1216; mul 22 1217; mul 59
1218; add 1219 1219; sub 1214 1220; mul 89 1221; mul 89 90; mul 67 503; mul 62 1224; mul 22 1225; mul 61 1226; mul
70 1221; add 1227 1228; mul 41 62; mul 28 67; add 1230 1231; mul 22 1232; mul 81 1233; mul 56 1233; mul 76 1212; add
1235 1236; mul 79 1218; mul 47 67; mul 53 62; add 1239 1240; mul 22 1241; mul 59 1242; add 1238 1243; sub 1237 1244;
mul 76 1245; add 1234 1246; sub 1229 1247; mul 86 1242; mul 59 1233; mul 76 1218; add 1250 1251; mul 79 1208; mul 45
1242; add 1253 1254; sub 1252 1255; mul 79 1256; add 1249 1257; add 1248 1258; mul 1223 1259; sub 1222 1260; mul 807
1261; mul 100 106; mul 102 1263; mul 100 114; sub 1264 1265; mul 100 118; mul 100 1267; sub 1266 1268; input p 190;
input p 191; mul 35 1271; mul 157 1272; add 1270 1273; mul 35 1272; mul 161 1275; add 1274 1276; mul 155 503; mul
1271 1278; mul 165 1279; add 1277 1280; mul 35 1279; mul 169 1282; add 1281 1283; mul 155 1279; mul 166 1271; add
1285 1286; mul 173 1287; add 1284 1288; input p 192; add 1289 1290; mul 35 144; mul 180 1292; add 1291 1293; mul 35
1292; mul 184 1295; add 1294 1296; mul 144 155; mul 148 1271; add 1298 1299; mul 188 1300; add 1297 1301; mul 35
1300; mul 192 1303; add 1302 1304; mul 155 1300; mul 189 1271; add 1306 1307; mul 196 1308; add 1305 1309; mul 148
503; mul 144 1311; mul 155 1312; mul 201 1271; add 1313 1314; mul 200 1315; add 1310 1316; mul 148 1312; mul 144
201; add 1318 1319; mul 205 1320; add 1317 1321; input p 193; mul 224 1272; add 1323 1324; mul 227 1275; add 1325
1326; mul 230 1279; add 1327 1328; mul 233 1282; add 1329 1330; mul 236 1287; add 1331 1332; input p 194; add 1333
1334; mul 157 1292; add 1335 1336; mul 161 1295; add 1337 1338; mul 245 1300; add 1339 1340; mul 248 1303; add 1341
1342; mul 251 1308; add 1343 1344; mul 254 1312; add 1345 1346; mul 35 1312; mul 257 1348; add 1347 1349; mul 196
1315; add 1350 1351; mul 263 1320; add 1352 1353; mul 147 1354; add 1322 1355; mul 284 503; le 271 269; le 269 271;
add 1358 1359; div 2 1360; mul 1358 1361; le 270 148; le 148 270; add 1363 1364; div 2 1365; mul 1363 1366; mul 144
1367; mul 1362 1368; constant 2.857142857142857; mul 275 503; le 140 274; le 274 140; add 1372 1373; div 2 1374; mul
1372 1375; mul 1369 1376; mul 1371 1377; mul 279 503; le 140 278; le 278 140; add 1380 1381; div 2 1382; mul 1380
1383; mul 1369 1384; mul 1379 1385; add 1378 1386; mul 1370 1387; sub 1369 1388; mul 1357 1389; mul 268 1390; mul
303 1389; mul 287 1392; add 1391 1393; mul 323 1389; mul 307 1395; add 1394 1396; mul 339 1397; mul 284 1390; mul
285 1389; add 1399 1400; mul 341 1401; mul 303 1390; mul 344 1403; add 1402 1404; mul 323 1390; mul 348 1406; add
1405 1407; mul 303 1392; mul 352 1409; add 1408 1410; mul 323 1392; mul 356 1412; add 1411 1413; mul 323 1395; mul
360 1415; add 1414 1416; add 1398 1417; mul 383 1418; sub 1377 1385; mul 380 1420; mul 379 1421; sub 1419 1422; add
1356 1423; mul 145 1424; mul 144 1425; mul 410 1401; mul 412 1403; add 1427 1428; mul 415 1406; add 1429 1430; mul
418 1409; add 1431 1432; mul 421 1412; add 1433 1434; mul 383 1435; mul 429 1421; sub 1436 1437; add 62 1438; mul
696 1439; mul 484 503; add 63 67; add 64 1442; add 66 1443; mul 104 1444; mul 429 1389; mul 284 1435; add 1446 1447;
mul 443 1401; mul 418 1403; add 1449 1450; mul 447 1406; add 1451 1452; mul 450 1409; add 1453 1454; mul 453 1412;
add 1455 1456; mul 303 1457; add 1448 1458; mul 464 1401; mul 447 1403; add 1460 1461; mul 427 1409; add 1462 1463;
mul 323 1464; add 1459 1465; mul 441 1466; mul 440 1467; add 1445 1468; mul 1441 1469; mul 491 503; sub 1470 1471;
mul 495 503; div 2 1473; mul 1472 1474; mul 485 1475; mul 503 1476; mul 498 503; mul 497 503; div 2 1479; mul 1476
1480; mul 499 1481; mul 1478 1482; neg 1483; mul 503 1484; mul 499 1485; mul 505 1483; sub 1486 1487; sub 1477 1488;
mul 502 1489; mul 520 1490; le 513 509; le 509 513; add 1492 1493; div 2 1494; mul 1492 1495; le 510 512; le 512
510; add 1497 1498; div 2 1499; mul 1497 1500; mul 1476 1501; mul 1496 1502; mul 516 1503; mul 514 1504; mul 518
1503; add 1505 1506; mul 508 1507; add 1491 1508; mul 525 1509; mul 530 1476; mul 512 1511; mul 532 1476; add 1512
1513; mul 528 1514; sub 1510 1515; mul 485 1516; mul 555 1476; mul 512 1518; mul 557 1476; add 1519 1520; mul 553
1521; mul 551 1481; mul 498 1523; mul 552 1481; add 1524 1525; mul 498 1526; mul 498 552; mul 1481 1528; add 1527
1529; mul 485 1530; mul 559 1531; sub 1522 1532; mul 548 1533; add 1517 1534; mul 563 1533; mul 560 1536; mul 564
1533; add 1537 1538; mul 597 1539; mul 485 1483; mul 491 1541; add 500 1542; mul 0 1543; mul 568 1469; add 566 1545;
mul 500 1546; mul 570 1541; add 1547 1548; mul 17 1549; mul 130 1550; sub 1544 1551; mul 500 1469; mul 484 1541; sub
1553 1554; mul 595 1555; mul 0 1439; mul 581 1457; mul 440 1558; add 28 1559; mul 130 1560; add 1557 1561; mul 590
1464; mul 440 1563; add 47 1564; mul 395 1565; add 1562 1566; mul 501 1567; add 1556 1568; add 1552 1569; mul 565
1570; add 1540 1571; add 1535 1572; mul 501 1573; mul 599 1555; add 1574 1575; mul 503 608; mul 1469 1577; mul 503
615; sub 1578 1579; mul 503 619; div 2 1581; mul 1580 1582; mul 609 1583; mul 503 1584; mul 503 622; mul 503 621;
div 2 1587; mul 1584 1588; mul 623 1589; mul 1586 1590; neg 1591; mul 503 1592; mul 623 1593; mul 628 1591; sub 1594
1595; sub 1585 1596; mul 626 1597; mul 640 1598; le 633 509; le 509 633; add 1600 1601; div 2 1602; mul 1600 1603;
le 510 632; le 632 510; add 1605 1606; div 2 1607; mul 1605 1608; mul 1584 1609; mul 1604 1610; mul 636 1611; mul
634 1612; mul 638 1611; add 1613 1614; mul 631 1615; add 1599 1616; mul 525 1617; mul 646 1584; mul 632 1619; mul
648 1584; add 1620 1621; mul 644 1622; sub 1618 1623; mul 609 1624; mul 555 1584; mul 632 1626; mul 670 1584; add
1627 1628; mul 668 1629; mul 666 1589; mul 622 1631; mul 667 1589; add 1632 1633; mul 622 1634; mul 622 667; mul
1589 1636; add 1635 1637; mul 609 1638; mul 672 1639; sub 1630 1640; mul 664 1641; add 1625 1642; mul 676 1641; mul
673 1644; mul 677 1641; add 1645 1646; mul 691 1647; mul 681 1469; sub 1649 679; mul 624 1650; mul 609 1591; mul 683
1652; sub 1651 1653; mul 17 1654; mul 130 1655; mul 615 1652; add 624 1657; mul 0 1658; add 1656 1659; mul 624 1469;
mul 608 1652; sub 1661 1662; mul 595 1663; mul 625 1567; add 1664 1665; add 1660 1666; mul 678 1667; add 1648 1668;
add 1643 1669; mul 625 1670; mul 693 1663; add 1671 1672; add 1576 1673; mul 431 1674; sub 1440 1675; sub 1426 1676;
mul 574 1573; mul 599 1543; sub 1678 1679; mul 687 1670; mul 693 1658; sub 1681 1682; add 1680 1683; sub 1677 1684;
sub 1269 1685; input p 195; sub 1686 1687; mul 62 800; mul 22 1689; sub 1688 1690; mul 90 1691; add 1262 1692; mul
89 1245; mul 89 809; mul 1259 1695; sub 1694 1696; mul 909 1697; mul 150 1354; mul 811 1390; mul 813 1392; add 1700
1701; mul 331 1395; add 1702 1703; mul 339 1704; mul 828 1401; mul 352 1403; add 1706 1707; mul 832 1406; add 1708
1709; mul 835 1409; add 1710 1711; mul 838 1412; add 1712 1713; mul 372 1415; add 1714 1715; add 1705 1716; mul 581
1717; add 1699 1718; mul 145 1719; mul 696 1560; mul 584 1674; sub 1721 1722; sub 1720 1723; mul 572 1573; mul 599
1550; sub 1725 1726; mul 685 1670; mul 693 1655; add 1728 1729; add 1727 1730; add 1724 1731; sub 1267 1732; mul 28
800; mul 22 1734; sub 1733 1735; mul 809 1736; add 1698 1737; sub 1693 1738; mul 89 1256; mul 89 912; mul 1259 1741;
sub 1740 1742; mul 1048 1743; input p 196; mul 923 1272; add 1745 1746; mul 926 1275; add 1747 1748; mul 929 1279;
add 1749 1750; mul 227 1282; add 1751 1752; mul 934 1287; add 1753 1754; mul 157 1300; add 1755 1756; mul 939 1303;
add 1757 1758; mul 169 1308; add 1759 1760; mul 944 1312; add 1761 1762; mul 184 1348; add 1763 1764; mul 257 1315;
add 1765 1766; mul 153 1354; add 1767 1768; mul 953 1390; mul 331 1392; add 1770 1771; mul 957 1395; add 1772 1773;
mul 339 1774; mul 970 1401; mul 832 1403; add 1776 1777; mul 360 1406; add 1778 1779; mul 368 1409; add 1780 1781;
mul 978 1412; add 1782 1783; mul 981 1415; add 1784 1785; add 1775 1786; mul 998 1401; mul 811 1403; add 1788 1789;
mul 953 1406; add 1790 1791; mul 327 1409; add 1792 1793; mul 331 1412; add 1794 1795; mul 335 1415; add 1796 1797;
mul 997 1798; add 1787 1799; mul 590 1800; add 1769 1801; mul 145 1802; mul 696 1565; mul 593 1674; sub 1804 1805;
sub 1803 1806; mul 47 800; mul 22 1808; add 1807 1809; mul 912 1810; add 1744 1811; sub 1739 1812; input c_q 0; mul
90 1814; le 140 139; le 139 140; add 1816 1817; div 2 1818; mul 1816 1819; mul 0 90; mul 1820 1821; input c_q 1; mul
1822 1823; sub 1815 1824; mul 90 93; input c_q 2; mul 1826 1827; add 1825 1828; mul 90 97; input c_q 3; mul 1830
1831; add 1829 1832; mul 90 100; add 809 1834; input c_q 4; mul 1835 1836; sub 1833 1837; mul 102 1835; input c_q 5;
mul 1839 1840; add 1838 1841; mul 93 1835; input c_q 6; mul 1843 1844; sub 1842 1845; mul 97 1835; input c_q 7; mul
1847 1848; sub 1846 1849; le 128 127; le 127 128; add 1851 1852; div 2 1853; mul 1851 1854; mul 132 1835; mul 1855
1856; input c_q 8; mul 1857 1858; add 1850 1859; mul 90 102; input c_q 9; mul 1861 1862; add 1860 1863; mul 102
1861; mul 104 1865; input c_q 10; mul 1866 1867; sub 1864 1868; mul 93 1861; input c_q 11; mul 1870 1871; add 1869
1872; mul 97 1861; input c_q 12; mul 1874 1875; add 1873 1876; add 1813 1877; mul 56 1226; mul 70 1212; add 1879
1880; mul 79 1242; add 1882 1882; sub 1881 1883; mul 89 1884; mul 89 1054; mul 1259 1886; sub 1885 1887; mul 909
1888; mul 1054 1736; add 1889 1890; mul 807 1697; mul 809 1691; add 1892 1893; sub 1891 1894; mul 59 1226; mul 70
1218; add 1896 1897; mul 76 1242; mul 79 1233; add 1899 1900; sub 1898 1901; mul 89 1902; mul 89 1061; mul 1259
1904; sub 1903 1905; mul 1048 1906; mul 1061 1810; add 1907 1908; add 1895 1909; mul 0 809; mul 1820 1911; mul 1823
1912; mul 809 1814; sub 1913 1914; mul 93 809; mul 1827 1916; sub 1915 1917; mul 97 809; mul 1831 1919; sub 1918
1920; mul 100 809; add 1054 1922; mul 1836 1923; add 1921 1924; mul 102 1923; mul 1840 1926; sub 1925 1927; mul 93
1923; mul 1844 1929; add 1928 1930; mul 97 1923; mul 1848 1932; add 1931 1933; mul 132 1923; mul 1855 1935; mul 1858
1936; sub 1934 1937; mul 102 809; mul 1862 1939; sub 1938 1940; mul 102 1939; mul 104 1942; mul 1867 1943; add 1941
1944; mul 93 1939; mul 1871 1946; sub 1945 1947; mul 97 1939; mul 1875 1949; sub 1948 1950; add 1910 1951; mul 807
1743; mul 912 1691; add 1953 1954; mul 909 1906; mul 1061 1736; add 1956 1957; sub 1955 1958; mul 45 1226; mul 70
1208; add 1960 1961; mul 76 1233; add 1963 1963; sub 1962 1964; mul 89 1965; mul 89 1070; mul 1259 1967; sub 1966
1968; mul 1048 1969; mul 1070 1810; add 1970 1971; sub 1959 1972; mul 912 1814; mul 0 912; mul 1820 1975; mul 1823
1976; sub 1974 1977; mul 93 912; mul 1827 1979; add 1978 1980; mul 97 912; mul 1831 1982; add 1981 1983; mul 100
912; add 1061 1985; mul 1836 1986; sub 1984 1987; mul 102 1986; mul 1840 1989; add 1988 1990; mul 93 1986; mul 1844
1992; sub 1991 1993; mul 97 1986; mul 1848 1995; sub 1994 1996; mul 132 1986; mul 1855 1998; mul 1858 1999; add 1997
2000; mul 102 912; mul 1862 2002; add 2001 2003; mul 102 2002; mul 104 2005; mul 1867 2006; sub 2004 2007; mul 93
2002; mul 1871 2009; add 2008 2010; mul 97 2002; mul 1875 2012; add 2011 2013; add 1973 2014; mul 597 1533; mul 560
1570; add 2016 2017; mul 691 1641; mul 673 1667; add 2019 2020; mul 100 129; mul 100 2022; add 141 2023; input p
197; mul 431 501; sub 2026 574; mul 565 2027; mul 501 2028; mul 431 625; sub 2030 687; mul 678 2031; mul 625 2032;
add 2029 2033; mul 431 2034; add 2025 2035; mul 574 2028; mul 687 2032; add 2037 2038; sub 2036 2039; add 2024 2040;
sign 0; mul 741 2042; mul 0 2043; add 743 2044; mul 745 751; mul 751 752; mul 0 751; mul 2047 2048; sub 2046 2049;
add 2045 2050; add 2041 2051; add 766 770; add 767 2053; add 769 2054; mul 67 2055; mul 22 2056; add 2052 2057; mul
90 2058; mul 584 2034; input p 198; add 2060 2061; mul 572 2028; mul 685 2032; add 2063 2064; add 2062 2065; sub
2022 2066; mul 41 2055; mul 22 2068; sub 2067 2069; mul 809 2070; add 2059 2071; mul 593 2034; input p 199; add 2073
2074; mul 53 2055; mul 22 2076; add 2075 2077; mul 912 2078; add 2072 2079; neg 2080; mul 1054 2070; mul 809 2058;
add 2082 2083; mul 1061 2078; add 2084 2085; mul 912 2058; mul 1061 2070; add 2087 2088; mul 1070 2078; add 2089
2090; neg 2091; mul 560 2027; mul 673 2031; where 1107 1108; where 1116 1117; where 1125 1126; where 1134 1135;
input p 200; where 1150 2099; input p 201; where 1159 2101; input p 202; where 1195 2103; input p 203; where 1203
2105; mul 26 503; div 2 14; mul 11 2108; mul 9 2109; mul 9 24; mul 5 9; mul 2111 2112; sub 2110 2113; mul 17 2114;
mul 9 9; mul 2112 2116; mul 16 2117; mul 16 17; mul 14 2112; mul 8 2109; add 2120 2121; mul 2119 2122; add 2118
2123; mul 24 2124; sub 2115 2125; mul 23 2126; mul 2107 2127; mul 9 38; mul 2112 2129; sub 9 2130; mul 17 2131; mul
38 2124; sub 2132 2133; mul 23 2134; add 31 2135; mul 1206 2136; add 2128 2137; mul 22 2138; mul 18 2124; mul 17
2140; mul 19 2124; add 2141 2142; sub 2139 2143; mul 56 2144; mul 34 1210; mul 22 2146; mul 45 2147; add 2145 2148;
mul 53 2136; mul 34 41; add 2150 2151; mul 22 2152; mul 59 2153; add 2154 2154; sub 2149 2155; mul 89 2156; mul 28
1224; mul 22 2158; mul 61 2159; mul 70 2156; add 2160 2161; mul 28 41; mul 67 2136; add 2163 2164; add 2127 2165;
mul 22 2166; mul 81 2167; mul 56 2167; mul 76 2147; add 2169 2170; mul 79 2153; mul 34 67; add 1215 2173; mul 22
2174; mul 59 2175; add 2172 2176; sub 2171 2177; mul 76 2178; add 2168 2179; sub 2162 2180; mul 86 2175; mul 59
2167; mul 76 2153; add 2183 2184; mul 79 2144; mul 45 2175; add 2186 2187; sub 2185 2188; mul 79 2189; add 2182
2190; add 2181 2191; mul 1223 2192; sub 2157 2193; mul 807 2194; sub 114 107; add 1267 2196; input p 204; mul 35
150; mul 157 2199; add 2198 2200; mul 35 2199; mul 161 2202; add 2201 2203; mul 150 1278; mul 165 2205; add 2204
2206; mul 35 2205; mul 169 2208; add 2207 2209; mul 155 2205; mul 150 166; add 2211 2212; mul 173 2213; add 2210
2214; mul 148 150; mul 188 2216; add 2215 2217; mul 35 2216; mul 192 2219; add 2218 2220; mul 155 2216; mul 150 189;
add 2222 2223; mul 196 2224; add 2221 2225; mul 150 201; mul 200 2227; add 2226 2228; input p 205; mul 224 2199; add
2230 2231; mul 227 2202; add 2232 2233; mul 230 2205; add 2234 2235; mul 233 2208; add 2236 2237; mul 236 2213; add
2238 2239; mul 245 2216; add 2240 2241; mul 248 2219; add 2242 2243; mul 251 2224; add 2244 2245; mul 196 2227; add
2246 2247; mul 147 2248; add 2229 2249; le 290 288; le 288 290; add 2251 2252; div 2 2253; mul 2251 2254; le 289 3;
le 3 289; add 2256 2257; div 2 2258; mul 2256 2259; mul 2255 2260; constant 1.6666666666666667; mul 294 503; le 140
293; le 293 140; add 2264 2265; div 2 2266; mul 2264 2267; mul 2261 2268; mul 2263 2269; mul 298 503; le 140 297; le
297 140; add 2272 2273; div 2 2274; mul 2272 2275; mul 2261 2276; mul 2271 2277; add 2270 2278; mul 2262 2279; sub
2261 2280; mul 284 2281; mul 287 2282; mul 303 503; mul 2281 2284; mul 327 2285; add 2283 2286; mul 323 2281; mul
331 2288; add 2287 2289; mul 339 2290; mul 285 2281; mul 344 2292; mul 303 2282; mul 304 2281; add 2294 2295; mul
352 2296; add 2293 2297; mul 323 2282; mul 356 2299; add 2298 2300; mul 303 2285; mul 328 2281; add 2302 2303; mul
364 2304; add 2301 2305; mul 323 2285; mul 368 2307; add 2306 2308; mul 323 2288; mul 372 2310; add 2309 2311; add
2291 2312; mul 383 2313; add 2250 2314; mul 145 2315; mul 144 2316; mul 412 2292; mul 418 2296; add 2318 2319; mul
421 2299; add 2320 2321; mul 424 2304; add 2322 2323; mul 427 2307; add 2324 2325; mul 383 2326; add 28 2327; mul
696 2328; mul 482 2114; mul 479 2131; add 2330 2331; mul 1471 2332; add 32 37; add 30 2334; add 36 2335; mul 104
2336; mul 284 2326; mul 461 2281; mul 418 2292; mul 450 2296; add 2340 2341; mul 453 2299; add 2342 2343; mul 456
2304; add 2344 2345; mul 459 2307; add 2346 2347; mul 303 2348; add 2339 2349; add 2338 2350; mul 447 2292; mul 427
2296; add 2352 2353; mul 470 2304; add 2354 2355; mul 323 2356; add 2351 2357; mul 441 2358; mul 440 2359; add 2337
2360; mul 479 2114; add 2361 2362; mul 482 2131; sub 2363 2364; mul 1441 2365; add 2333 2366; mul 1474 2367; mul 485
2368; mul 503 2369; mul 1480 2369; mul 499 2371; mul 1478 2372; neg 2373; mul 503 2374; mul 499 2375; mul 505 2373;
sub 2376 2377; sub 2370 2378; mul 502 2379; mul 520 2380; mul 1501 2369; mul 1496 2382; mul 516 2383; mul 514 2384;
mul 518 2383; add 2385 2386; mul 508 2387; add 2381 2388; mul 525 2389; mul 530 2369; mul 512 2391; mul 532 2369;
add 2392 2393; mul 528 2394; sub 2390 2395; mul 485 2396; mul 555 2369; mul 512 2398; mul 557 2369; add 2399 2400;
mul 553 2401; mul 551 2371; mul 498 2403; mul 552 2371; add 2404 2405; mul 498 2406; mul 1528 2371; add 2407 2408;
mul 485 2409; mul 559 2410; sub 2402 2411; mul 548 2412; add 2397 2413; mul 563 2412; mul 560 2415; mul 564 2412;
add 2416 2417; mul 597 2418; mul 566 2332; sub 2362 2364; mul 491 2421; add 2420 2422; mul 568 2365; mul 484 2332;
add 2424 2425; sub 2423 2426; mul 500 2427; mul 485 2373; mul 570 2429; sub 2428 2430; mul 17 2431; mul 571 2124;
sub 2432 2433; mul 130 2434; mul 500 2332; mul 491 2429; sub 2436 2437; mul 0 2438; sub 2435 2439; mul 500 2365; mul
484 2429; sub 2441 2442; mul 595 2443; mul 0 2328; mul 581 2348; sub 2269 2277; mul 578 2447; mul 461 2448; sub 2446
2449; mul 440 2450; add 31 2451; mul 130 2452; add 2445 2453; mul 590 2356; mul 440 2455; add 34 2456; mul 395 2457;
add 2454 2458; mul 501 2459; add 2444 2460; add 2440 2461; mul 565 2462; add 2419 2463; add 2414 2464; mul 501 2465;
mul 599 2443; add 2466 2467; mul 603 2131; mul 606 2114; sub 2469 2470; mul 1579 2471; mul 603 2114; add 2361 2473;
mul 606 2131; add 2474 2475; mul 1577 2476; add 2472 2477; mul 1582 2478; mul 609 2479; mul 503 2480; mul 1588 2480;
mul 623 2482; mul 1586 2483; neg 2484; mul 503 2485; mul 623 2486; mul 628 2484; sub 2487 2488; sub 2481 2489; mul
626 2490; mul 640 2491; mul 1609 2480; mul 1604 2493; mul 636 2494; mul 634 2495; mul 638 2494; add 2496 2497; mul
631 2498; add 2492 2499; mul 525 2500; mul 646 2480; mul 632 2502; mul 648 2480; add 2503 2504; mul 644 2505; sub
2501 2506; mul 609 2507; mul 555 2480; mul 632 2509; mul 670 2480; add 2510 2511; mul 668 2512; mul 666 2482; mul
622 2514; mul 667 2482; add 2515 2516; mul 622 2517; mul 1636 2482; add 2518 2519; mul 609 2520; mul 672 2521; sub
2513 2522; mul 664 2523; add 2508 2524; mul 676 2523; mul 673 2526; mul 677 2523; add 2527 2528; mul 691 2529; mul
679 2471; add 2473 2475; mul 615 2532; add 2531 2533; mul 681 2476; sub 2470 2469; mul 608 2536; add 2535 2537; add
2534 2538; mul 624 2539; mul 609 2484; mul 683 2541; sub 2540 2542; mul 17 2543; mul 684 2124; sub 2544 2545; mul
130 2546; mul 624 2471; mul 615 2541; sub 2548 2549; mul 0 2550; sub 2547 2551; mul 624 2476; mul 608 2541; sub 2553
2554; mul 595 2555; mul 625 2459; add 2556 2557; add 2552 2558; mul 678 2559; add 2530 2560; add 2525 2561; mul 625
2562; mul 693 2555; add 2563 2564; add 2468 2565; mul 431 2566; sub 2329 2567; sub 2317 2568; mul 574 2465; mul 599
2438; add 2570 2571; mul 687 2562; mul 693 2550; add 2573 2574; add 2572 2575; sub 2569 2576; sub 2197 2577; mul 796
2131; mul 16 2112; mul 16 792; mul 2122 2581; sub 2580 2582; mul 10 2583; mul 792 2584; mul 793 2583; add 2585 2586;
mul 791 2112; mul 9 2588; mul 9 791; mul 2112 2590; add 2589 2591; sub 2587 2592; mul 3 2593; add 795 2594; mul 38
2595; add 2579 2596; sub 2126 2597; mul 788 2598; mul 130 2124; mul 130 2600; mul 23 2601; mul 798 2602; sub 2599
2603; mul 67 2604; add 1734 2605; mul 796 2114; mul 24 2595; add 2607 2608; add 2134 2609; mul 788 2610; mul 803
2602; sub 2611 2612; sub 2606 2613; mul 22 2614; sub 2578 2615; mul 90 2616; add 2195 2617; mul 89 2178; mul 1695
2192; sub 2619 2620; mul 909 2621; mul 868 2131; mul 17 2623; mul 869 2124; sub 2624 2625; mul 150 2248; mul 813
2282; mul 818 2285; add 2628 2629; mul 821 2288; add 2630 2631; mul 339 2632; mul 352 2292; mul 835 2296; add 2634
2635; mul 838 2299; add 2636 2637; mul 843 2304; add 2638 2639; mul 846 2307; add 2640 2641; mul 849 2310; add 2642
2643; add 2633 2644; mul 581 2645; mul 855 2448; sub 2646 2647; add 2627 2648; mul 145 2649; mul 696 2452; mul 584
2566; sub 2651 2652; sub 2650 2653; mul 572 2465; mul 599 2434; add 2655 2656; mul 685 2562; mul 693 2546; add 2658
2659; add 2657 2660; add 2654 2661; add 118 2662; sub 2626 2663; mul 800 2136; mul 41 2604; add 2665 2666; mul 804
2127; mul 26 2613; add 2668 2669; sub 2667 2670; mul 22 2671; mul 19 2595; mul 796 2140; sub 2673 2674; mul 787
2675; mul 906 2601; sub 2676 2677; sub 2672 2678; sub 2664 2679; mul 809 2680; add 2622 2681; sub 2618 2682; mul 89
2189; mul 1741 2192; sub 2684 2685; mul 1048 2686; input p 206; mul 923 2199; add 2688 2689; mul 926 2202; add 2690
2691; mul 929 2205; add 2692 2693; mul 227 2208; add 2694 2695; mul 934 2213; add 2696 2697; mul 157 2216; add 2698
2699; mul 939 2219; add 2700 2701; mul 169 2224; add 2702 2703; mul 257 2227; add 2704 2705; mul 153 2248; add 2706
2707; mul 331 2282; mul 960 2285; add 2709 2710; mul 963 2288; add 2711 2712; mul 339 2713; mul 832 2292; mul 368
2296; add 2715 2716; mul 978 2299; add 2717 2718; mul 984 2304; add 2719 2720; mul 849 2307; add 2721 2722; mul 989
2310; add 2723 2724; add 2714 2725; mul 811 2292; mul 327 2296; add 2727 2728; mul 331 2299; add 2729 2730; mul 1010
2304; add 2731 2732; mul 960 2307; add 2733 2734; mul 824 2310; add 2735 2736; mul 997 2737; add 2726 2738; mul 590
2739; add 2708 2740; mul 145 2741; mul 696 2457; mul 593 2566; sub 2743 2744; sub 2742 2745; mul 34 800; mul 53
2604; add 2747 2748; mul 22 2749; add 2746 2750; mul 912 2751; add 2687 2752; sub 2683 2753; mul 56 2159; mul 70
2147; add 2755 2756; mul 79 2175; add 2758 2758; sub 2757 2759; mul 89 2760; mul 1886 2192; sub 2761 2762; mul 909
2763; mul 1054 2680; add 2764 2765; mul 807 2621; mul 809 2616; add 2767 2768; sub 2766 2769; mul 59 2159; mul 70
2153; add 2771 2772; mul 76 2175; mul 79 2167; add 2774 2775; sub 2773 2776; mul 89 2777; mul 1904 2192; sub 2778
2779; mul 1048 2780; mul 1061 2751; add 2781 2782; add 2770 2783; mul 807 2686; mul 912 2616; add 2785 2786; mul 909
2780; mul 1061 2680; add 2788 2789; sub 2787 2790; mul 45 2159; mul 70 2144; add 2792 2793; mul 76 2167; add 2795
2795; sub 2794 2796; mul 89 2797; mul 1967 2192; sub 2798 2799; mul 1048 2800; mul 1070 2751; add 2801 2802; sub
2791 2803; mul 597 2412; mul 560 2462; add 2805 2806; mul 691 2523; mul 673 2559; add 2808 2809; input p 207; mul
501 584; add 572 2812; mul 565 2813; mul 501 2814; mul 584 625; add 685 2816; mul 678 2817; mul 625 2818; add 2815
2819; mul 431 2820; add 2811 2821; mul 574 2814; mul 687 2818; add 2823 2824; sub 2822 2825; sub 2022 2826; add 773
776; add 772 2828; add 775 2829; mul 503 786; mul 23 2831; mul 798 2832; add 2830 2833; mul 67 2834; mul 803 2832;
sub 2835 2836; mul 22 2837; sub 2827 2838; mul 90 2839; mul 584 2820; input p 208; add 2841 2842; mul 572 2814; mul
685 2818; add 2844 2845; add 2843 2846; add 129 2847; mul 41 2834; mul 26 2836; sub 2849 2850; mul 22 2851; mul 906
2831; sub 2852 2853; add 2848 2854; mul 809 2855; add 2840 2856; mul 593 2820; input p 209; add 2858 2859; mul 53
2834; mul 22 2861; add 2860 2862; mul 912 2863; sub 2857 2864; mul 1061 2863; mul 1054 2855; mul 809 2839; add 2867
2868; sub 2866 2869; mul 912 2839; mul 1061 2855; add 2871 2872; mul 1070 2863; sub 2873 2874; mul 560 2813; mul 673
2817; input p 210; where 1107 2878; input p 211; where 1116 2880; input p 212; where 1125 2882; input p 213; where
1134 2884; input p 214; where 1150 2886; input p 215; where 1159 2888; input p 216; where 1173 2890; input p 217;
where 1181 2892; input p 218; where 1195 2894; input p 219; where 1203 2896; mul 34 1206; mul 22 2898; mul 56 2899;
mul 51 1210; mul 22 2901; mul 45 2902; add 2900 2903; mul 34 53; mul 41 51; add 2905 2906; mul 22 2907; mul 59 2908;
add 2909 2909; sub 2904 2910; mul 89 2911; mul 47 1224; mul 22 2913; mul 61 2914; mul 70 2911; add 2915 2916; add
1216 2173; mul 22 2918; mul 81 2919; mul 56 2919; mul 76 2902; add 2921 2922; mul 79 2908; mul 51 67; mul 47 53; add
2925 2926; mul 22 2927; mul 59 2928; add 2924 2929; sub 2923 2930; mul 76 2931; add 2920 2932; sub 2917 2933; mul 86
2928; mul 59 2919; mul 76 2908; add 2936 2937; mul 79 2899; mul 45 2928; add 2939 2940; sub 2938 2941; mul 79 2942;
add 2935 2943; add 2934 2944; mul 1223 2945; sub 2912 2946; mul 807 2947; input p 220; add 154 155; mul 157 2950;
add 2949 2951; mul 35 2950; add 158 2953; mul 161 2954; add 2952 2955; mul 153 1278; mul 165 2957; add 2956 2958;
mul 35 2957; add 166 2960; mul 169 2961; add 2959 2962; mul 155 2957; mul 153 166; add 2964 2965; mul 173 2966; add
2963 2967; mul 148 180; add 2968 2969; mul 181 503; mul 184 2971; add 2970 2972; mul 148 153; mul 188 2974; add 2973
2975; mul 35 2974; add 189 2977; mul 192 2978; add 2976 2979; mul 155 2974; mul 153 189; add 2981 2982; mul 196
2983; add 2980 2984; mul 153 201; mul 200 2986; add 2985 2987; mul 35 503; mul 213 2989; add 210 2990; mul 35 2989;
add 214 2992; mul 217 2993; add 2991 2994; input p 221; add 2995 2996; mul 224 2950; add 2997 2998; mul 227 2954;
add 2999 3000; mul 230 2957; add 3001 3002; mul 233 2961; add 3003 3004; mul 236 2966; add 3005 3006; mul 148 157;
add 3007 3008; mul 161 2971; add 3009 3010; mul 245 2974; add 3011 3012; mul 248 2978; add 3013 3014; mul 251 2983;
add 3015 3016; mul 201 257; add 3017 3018; mul 196 2986; add 3019 3020; mul 147 3021; add 2988 3022; le 310 308; le
308 310; add 3024 3025; div 2 3026; mul 3024 3027; le 309 35; le 35 309; add 3029 3030; div 2 3031; mul 3029 3032;
mul 3028 3033; constant 0.625; mul 314 503; le 140 313; le 313 140; add 3037 3038; div 2 3039; mul 3037 3040; mul
3034 3041; mul 3036 3042; mul 318 503; le 140 317; le 317 140; add 3045 3046; div 2 3047; mul 3045 3048; mul 3034
3049; mul 3044 3050; add 3043 3051; mul 3035 3052; sub 3034 3053; mul 284 3054; mul 307 3055; mul 303 3054; mul 331
3057; add 3056 3058; mul 323 503; mul 3054 3060; mul 335 3061; add 3059 3062; mul 339 3063; mul 323 3061; mul 336
3054; add 3065 3066; mul 338 3067; add 3064 3068; mul 285 3054; mul 348 3070; mul 304 3054; mul 356 3072; add 3071
3073; mul 323 3055; mul 324 3054; add 3075 3076; mul 360 3077; add 3074 3078; mul 328 3054; mul 368 3080; add 3079
3081; mul 323 3057; mul 332 3054; add 3083 3084; mul 372 3085; add 3082 3086; mul 376 3067; add 3087 3088; add 3069
3089; mul 383 3090; add 3023 3091; mul 145 3092; mul 144 3093; mul 415 3070; mul 421 3072; add 3095 3096; mul 427
3080; add 3097 3098; mul 383 3099; add 47 3100; mul 696 3101; add 52 53; add 50 3103; mul 104 3104; mul 284 3099;
mul 447 3070; mul 453 3072; add 3107 3108; mul 459 3080; add 3109 3110; mul 303 3111; add 3106 3112; mul 472 3054;
add 3113 3114; mul 441 3115; mul 440 3116; add 3105 3117; mul 1441 3118; mul 1474 3119; mul 485 3120; mul 503 3121;
mul 1480 3121; mul 499 3123; mul 1478 3124; neg 3125; mul 503 3126; mul 499 3127; mul 505 3125; sub 3128 3129; sub
3122 3130; mul 502 3131; mul 520 3132; mul 1501 3121; mul 1496 3134; mul 516 3135; mul 514 3136; mul 518 3135; add
3137 3138; mul 508 3139; add 3133 3140; mul 525 3141; mul 530 3121; mul 512 3143; mul 532 3121; add 3144 3145; mul
528 3146; sub 3142 3147; mul 485 3148; mul 555 3121; mul 512 3150; mul 557 3121; add 3151 3152; mul 553 3153; mul
551 3123; mul 498 3155; mul 552 3123; add 3156 3157; mul 498 3158; mul 1528 3123; add 3159 3160; mul 485 3161; mul
559 3162; sub 3154 3163; mul 548 3164; add 3149 3165; mul 563 3164; mul 560 3167; mul 564 3164; add 3168 3169; mul
597 3170; mul 485 3125; mul 491 3172; mul 0 3173; mul 568 3118; mul 500 3175; mul 570 3172; add 3176 3177; mul 17
3178; mul 130 3179; sub 3174 3180; mul 500 3118; mul 484 3172; sub 3182 3183; mul 595 3184; mul 0 3101; mul 581
3111; mul 440 3187; add 34 3188; mul 130 3189; add 3186 3190; sub 3042 3050; mul 587 3192; mul 472 3193; mul 440
3194; sub 51 3195; mul 395 3196; add 3191 3197; mul 501 3198; add 3185 3199; add 3181 3200; mul 565 3201; add 3171
3202; add 3166 3203; mul 501 3204; mul 599 3184; add 3205 3206; mul 1577 3118; mul 1582 3208; mul 609 3209; mul 503
3210; mul 1588 3210; mul 623 3212; mul 1586 3213; neg 3214; mul 503 3215; mul 623 3216; mul 628 3214; sub 3217 3218;
sub 3211 3219; mul 626 3220; mul 640 3221; mul 1609 3210; mul 1604 3223; mul 636 3224; mul 634 3225; mul 638 3224;
add 3226 3227; mul 631 3228; add 3222 3229; mul 525 3230; mul 646 3210; mul 632 3232; mul 648 3210; add 3233 3234;
mul 644 3235; sub 3231 3236; mul 609 3237; mul 555 3210; mul 632 3239; mul 670 3210; add 3240 3241; mul 668 3242;
mul 666 3212; mul 622 3244; mul 667 3212; add 3245 3246; mul 622 3247; mul 1636 3212; add 3248 3249; mul 609 3250;
mul 672 3251; sub 3243 3252; mul 664 3253; add 3238 3254; mul 676 3253; mul 673 3256; mul 677 3253; add 3257 3258;
mul 691 3259; mul 681 3118; mul 624 3261; mul 609 3214; mul 683 3263; sub 3262 3264; mul 17 3265; mul 130 3266; mul
615 3263; mul 0 3268; add 3267 3269; mul 624 3118; mul 608 3263; sub 3271 3272; mul 595 3273; mul 625 3198; add 3274
3275; add 3270 3276; mul 678 3277; add 3260 3278; add 3255 3279; mul 625 3280; mul 693 3273; add 3281 3282; add 3207
3283; mul 431 3284; sub 3102 3285; sub 3094 3286; mul 574 3204; mul 599 3173; sub 3288 3289; mul 687 3280; mul 693
3268; sub 3291 3292; add 3290 3293; sub 3287 3294; add 1809 3295; mul 90 3296; sub 2948 3297; mul 89 2931; mul 1695
2945; sub 3299 3300; mul 909 3301; mul 150 3021; mul 331 3055; mul 821 3057; add 3304 3305; mul 824 3061; add 3306
3307; mul 339 3308; mul 826 3067; add 3309 3310; mul 832 3070; mul 838 3072; add 3312 3313; mul 372 3077; add 3314
3315; mul 846 3080; add 3316 3317; mul 849 3085; add 3318 3319; mul 852 3067; add 3320 3321; add 3311 3322; mul 581
3323; add 3303 3324; mul 145 3325; mul 696 3189; mul 584 3284; sub 3327 3328; sub 3326 3329; mul 572 3204; mul 599
3179; sub 3331 3332; mul 685 3280; mul 693 3266; add 3334 3335; add 3333 3336; add 3330 3337; mul 22 2747; add 3338
3339; mul 809 3340; sub 3302 3341; sub 3298 3342; mul 89 2942; mul 1741 2945; sub 3344 3345; mul 1048 3346; mul 915
2989; add 913 3348; mul 918 2993; add 3349 3350; input p 222; add 3351 3352; mul 923 2950; add 3353 3354; mul 926
2954; add 3355 3356; mul 929 2957; add 3357 3358; mul 227 2961; add 3359 3360; mul 934 2966; add 3361 3362; mul 157
2974; add 3363 3364; mul 939 2978; add 3365 3366; mul 169 2983; add 3367 3368; mul 184 201; add 3369 3370; mul 257
2986; add 3371 3372; mul 153 3021; add 3373 3374; mul 957 3055; mul 963 3057; add 3376 3377; mul 966 3061; add 3378
3379; mul 339 3380; mul 968 3067; add 3381 3382; mul 360 3070; mul 978 3072; add 3384 3385; mul 981 3077; add 3386
3387; mul 849 3080; add 3388 3389; mul 989 3085; add 3390 3391; mul 992 3067; add 3392 3393; add 3383 3394; mul 996
3061; mul 1019 3396; mul 953 3070; mul 331 3072; add 3398 3399; mul 335 3077; add 3400 3401; mul 960 3080; add 3402
3403; mul 824 3085; add 3404 3405; mul 1017 3067; add 3406 3407; mul 997 3408; add 3397 3409; add 3395 3410; mul 590
3411; mul 1021 3193; sub 3412 3413; add 3375 3414; mul 145 3415; mul 696 3196; mul 593 3284; sub 3417 3418; sub 3416
3419; mul 51 800; mul 22 3421; add 3420 3422; mul 912 3423; add 3347 3424; sub 3343 3425; mul 56 2914; mul 70 2902;
add 3427 3428; mul 79 2928; add 3430 3430; sub 3429 3431; mul 89 3432; mul 1886 2945; sub 3433 3434; mul 909 3435;
mul 1054 3340; sub 3436 3437; mul 807 3301; mul 809 3296; sub 3439 3440; sub 3438 3441; mul 59 2914; mul 70 2908;
add 3443 3444; mul 76 2928; mul 79 2919; add 3446 3447; sub 3445 3448; mul 89 3449; mul 1904 2945; sub 3450 3451;
mul 1048 3452; mul 1061 3423; add 3453 3454; add 3442 3455; mul 807 3346; mul 912 3296; sub 3457 3458; mul 909 3452;
mul 1061 3340; sub 3460 3461; sub 3459 3462; mul 45 2914; mul 70 2899; add 3464 3465; mul 76 2919; add 3467 3467;
sub 3466 3468; mul 89 3469; mul 1967 2945; sub 3470 3471; mul 1048 3472; mul 1070 3423; add 3473 3474; sub 3463
3475; mul 597 3164; mul 560 3201; add 3477 3478; mul 691 3253; mul 673 3277; add 3480 3481; mul 501 593; mul 565
3483; mul 501 3484; mul 593 625; mul 678 3486; mul 625 3487; add 3485 3488; mul 584 3489; input p 223; add 3490
3491; mul 572 3484; mul 685 3487; add 3493 3494; add 3492 3495; add 782 783; add 781 3497; mul 41 3498; mul 22 3499;
add 3496 3500; mul 809 3501; input p 224; mul 431 3489; add 3503 3504; mul 574 3484; mul 687 3487; add 3506 3507;
sub 3505 3508; mul 67 3498; mul 22 3510; add 3509 3511; mul 90 3512; sub 3502 3513; mul 593 3489; input p 225; add
3515 3516; mul 53 3498; mul 22 3518; add 3517 3519; mul 912 3520; sub 3514 3521; mul 809 3512; mul 1054 3501; sub
3523 3524; mul 1061 3520; add 3525 3526; mul 1061 3501; mul 912 3512; sub 3528 3529; mul 1070 3520; sub 3530 3531;
mul 560 3483; mul 673 3486; input p 226; where 1150 3535; input p 227; where 1159 3537; input p 228; where 1173
3539; input p 229; where 1181 3541; where 1195 3535; where 1203 3537; mul 538 560; mul 501 3545; mul 584 3546; mul
572 3545; add 3547 3548; mul 809 3549; mul 431 3546; mul 574 3545; sub 3551 3552; mul 90 3553; sub 3550 3554; mul
593 3546; mul 912 3556; sub 3555 3557; mul 809 3553; mul 1054 3549; sub 3559 3560; mul 1061 3556; add 3561 3562; mul
1061 3549; mul 912 3553; sub 3564 3565; mul 1070 3556; sub 3566 3567; input p 230; mul 654 673; mul 625 3570; mul
584 3571; mul 685 3570; add 3572 3573; mul 809 3574; mul 431 3571; mul 687 3570; sub 3576 3577; mul 90 3578; sub
3575 3579; mul 593 3571; mul 912 3581; sub 3580 3582; mul 809 3578; mul 1054 3574; sub 3584 3585; mul 1061 3581; add
3586 3587; mul 1061 3574; mul 912 3578; sub 3589 3590; mul 1070 3581; sub 3591 3592; mul 541 560; mul 501 3594; mul
584 3595; mul 572 3594; add 3596 3597; mul 809 3598; mul 431 3595; mul 574 3594; sub 3600 3601; mul 90 3602; sub
3599 3603; mul 593 3595; mul 912 3605; sub 3604 3606; mul 809 3602; mul 1054 3598; sub 3608 3609; mul 1061 3605; add
3610 3611; mul 1061 3598; mul 912 3602; sub 3613 3614; mul 1070 3605; sub 3615 3616; input p 231; mul 657 673; mul
625 3619; mul 584 3620; mul 685 3619; add 3621 3622; mul 809 3623; mul 431 3620; mul 687 3619; sub 3625 3626; mul 90
3627; sub 3624 3628; mul 593 3620; mul 912 3630; sub 3629 3631; mul 809 3627; mul 1054 3623; sub 3633 3634; mul 1061
3630; add 3635 3636; mul 1061 3623; mul 912 3627; sub 3638 3639; mul 1070 3630; sub 3640 3641; mul 545 560; mul 501
3643; mul 584 3644; mul 572 3643; add 3645 3646; mul 809 3647; mul 431 3644; mul 574 3643; sub 3649 3650; mul 90
3651; sub 3648 3652; mul 593 3644; mul 912 3654; sub 3653 3655; mul 809 3651; mul 1054 3647; sub 3657 3658; mul 1061
3654; add 3659 3660; mul 1061 3647; mul 912 3651; sub 3662 3663; mul 1070 3654; sub 3664 3665; input p 232; mul 661
673; mul 625 3668; mul 584 3669; mul 685 3668; add 3670 3671; mul 809 3672; mul 431 3669; mul 687 3668; sub 3674
3675; mul 90 3676; sub 3673 3677; mul 593 3669; mul 912 3679; sub 3678 3680; mul 809 3676; mul 1054 3672; sub 3682
3683; mul 1061 3679; add 3684 3685; mul 1061 3672; mul 912 3676; sub 3687 3688; mul 1070 3679; sub 3689 3690; mul 90
756; mul 756 809; neg 3693; mul 756 912; input p 233; mul 90 760; mul 760 809; neg 3698; mul 760 912; input p 234;
mul 521 522; mul 485 3702; mul 501 3703; mul 522 641; mul 609 3705; mul 625 3706; add 3704 3707; mul 593 3708; mul
912 3709; mul 574 3703; mul 687 3706; add 3711 3712; mul 431 3708; sub 3713 3714; mul 90 3715; mul 584 3708; mul 572
3703; mul 685 3706; add 3718 3719; add 3717 3720; mul 809 3721; add 3716 3722; sub 3710 3723; mul 1054 3721; mul 809
3715; add 3725 3726; mul 1061 3709; sub 3727 3728; mul 1070 3709; mul 912 3715; mul 1061 3721; add 3731 3732; sub
3730 3733; input p 235; input p 236; mul 809 3736; mul 90 705; sub 3737 3738; mul 705 809; mul 1054 3736; sub 3740
3741; mul 1061 3736; mul 705 912; sub 3743 3744; input p 237; mul 809 3746; mul 90 708; sub 3747 3748; mul 708 809;
mul 1054 3746; sub 3750 3751; mul 1061 3746; mul 708 912; sub 3753 3754; input p 238; mul 809 3756; mul 90 712; sub
3757 3758; mul 712 809; mul 1054 3756; sub 3760 3761; mul 1061 3756; mul 712 912; sub 3763 3764; input p 239; mul
809 3766; mul 90 716; sub 3767 3768; mul 716 809; mul 1054 3766; sub 3770 3771; mul 1061 3766; mul 716 912; sub 3773
3774; input p 240; mul 809 3776; input p 241; mul 90 3778; sub 3777 3779; input p 242; mul 912 3781; sub 3780 3782;
mul 809 3778; mul 1054 3776; sub 3784 3785; mul 1061 3781; add 3786 3787; mul 1061 3776; mul 912 3778; sub 3789
3790; mul 1070 3781; sub 3791 3792; input p 243; mul 809 3794; input p 244; mul 90 3796; sub 3795 3797; input p 245;
mul 912 3799; sub 3798 3800; mul 809 3796; mul 1054 3794; sub 3802 3803; mul 1061 3799; add 3804 3805; mul 1061
3794; mul 912 3796; sub 3807 3808; mul 1070 3799; sub 3809 3810; input p 246; mul 809 3812; input p 247; mul 912
3814; sub 3813 3815; mul 1061 3814; mul 1054 3812; sub 3817 3818; mul 1061 3812; mul 1070 3814; sub 3820 3821; input
p 248; mul 809 3823; input p 249; mul 912 3825; sub 3824 3826; mul 1061 3825; mul 1054 3823; sub 3828 3829; mul 1061
3823; mul 1070 3825; sub 3831 3832; input p 250; mul 809 3834; input p 251; mul 90 3836; sub 3835 3837; sub 3838
3782; mul 809 3836; mul 1054 3834; sub 3840 3841; add 3787 3842; mul 1061 3834; mul 912 3836; sub 3844 3845; sub
3846 3792; input p 252; mul 809 3848; input p 253; mul 90 3850; sub 3849 3851; sub 3852 3800; mul 809 3850; mul 1054
3848; sub 3854 3855; add 3805 3856; mul 1061 3848; mul 912 3850; sub 3858 3859; sub 3860 3810; mul 102 109; add 92
3862; mul 100 121; sub 3863 3864; mul 527 534; mul 485 3866; mul 574 3867; mul 501 3867; mul 431 3869; sub 3868
3870; sub 3865 3871; mul 90 3872; mul 584 3869; mul 572 3867; add 3874 3875; add 121 3876; mul 809 3877; sub 3873
3878; mul 593 3869; mul 912 3880; add 3879 3881; mul 1054 3877; mul 809 3872; sub 3883 3884; mul 1061 3880; sub 3885
3886; mul 912 3872; mul 1061 3877; sub 3888 3889; mul 1070 3880; add 3890 3891; mul 102 112; add 96 3893; mul 100
124; sub 3894 3895; mul 643 650; mul 609 3897; mul 687 3898; mul 625 3898; mul 431 3900; sub 3899 3901; sub 3896
3902; mul 90 3903; mul 584 3900; mul 685 3898; add 3905 3906; add 124 3907; mul 809 3908; sub 3904 3909; mul 593
3900; mul 912 3911; add 3910 3912; mul 1054 3908; mul 809 3903; sub 3914 3915; mul 1061 3911; sub 3916 3917; mul 912
3903; mul 1061 3908; sub 3919 3920; mul 1070 3911; add 3921 3922; neg 809; neg 1822; neg 1976; neg 1916; neg 1919;
neg 1835; neg 1986; neg 1926; neg 1843; neg 1992; neg 1847; neg 1995; neg 1936; neg 1939; neg 1866; neg 2006; neg
1946; neg 1949; store f 0 0; store f 1 1050; store f 2 130; store f 3 1063; store f 4 395; store f 5 1072; store f 6
1076; store f 7 1079; store f 8 1082; store f 9 1084; store f 10 1087; store f 11 1089; store f 12 1091; store f 13
1093; store f 14 1096; store f 15 1110; store f 16 1119; store f 17 1128; store f 18 1137; store f 19 1153; store f
20 1162; store f 21 1175; store f 22 1183; store f 23 1197; store f 24 1205; store a 25 1878; store a 75 1952; store
a 125 2015; store a 150 2018; store a 175 2021; store a 200 2018; store a 225 2021; store a 250 2018; store a 275
2021; store a 300 1090; store a 325 1092; store a 1 2; store a 26 2081; store a 76 2086; store a 126 2092; store a
151 2093; store a 176 2094; store a 201 2093; store a 226 2094; store a 251 2093; store a 276 2094; store a 376
2095; store a 401 2096; store a 426 2097; store a 451 2098; store a 476 2100; store a 501 2102; store a 576 2104;
store a 601 2106; store a 27 2754; store a 77 2784; store a 127 2804; store a 152 2807; store a 177 2810; store a
202 2807; store a 227 2810; store a 252 2807; store a 277 2810; store a 28 2865; store a 53 2; store a 78 2870;
store a 128 2875; store a 153 2876; store a 178 2877; store a 203 2876; store a 228 2877; store a 253 2876; store a
278 2877; store a 378 2879; store a 403 2881; store a 428 2883; store a 453 2885; store a 478 2887; store a 503
2889; store a 528 2891; store a 553 2893; store a 578 2895; store a 603 2897; store a 29 3426; store a 79 3456;
store a 129 3476; store a 154 3479; store a 179 3482; store a 204 3479; store a 229 3482; store a 254 3479; store a
279 3482; store a 30 3522; store a 80 3527; store a 105 2; store a 130 3532; store a 155 3533; store a 180 3534;
store a 205 3533; store a 230 3534; store a 255 3533; store a 280 3534; store a 480 3536; store a 505 3538; store a
530 3540; store a 555 3542; store a 580 3543; store a 605 3544; store a 31 3558; store a 81 3563; store a 131 3568;
store a 156 3569; store a 32 3583; store a 82 3588; store a 132 3593; store a 182 3569; store a 33 3607; store a 83
3612; store a 133 3617; store a 208 3618; store a 34 3632; store a 84 3637; store a 134 3642; store a 234 3618;
store a 35 3656; store a 85 3661; store a 135 3666; store a 260 3667; store a 36 3681; store a 86 3686; store a 136
3691; store a 286 3667; store a 37 3692; store a 87 3694; store a 137 3695; store a 312 3696; store a 38 3697; store
a 88 3699; store a 138 3700; store a 338 3701; store a 39 3724; store a 89 3729; store a 139 3734; store a 364 3735;
store a 40 3739; store a 90 3742; store a 140 3745; store a 41 3749; store a 91 3752; store a 141 3755; store a 42
3759; store a 92 3762; store a 142 3765; store a 43 3769; store a 93 3772; store a 143 3775; store a 44 3783; store
a 94 3788; store a 144 3793; store a 45 3801; store a 95 3806; store a 145 3811; store a 46 3816; store a 96 3819;
store a 146 3822; store a 47 3827; store a 97 3830; store a 147 3833; store a 48 3839; store a 98 3843; store a 148
3847; store a 49 3853; store a 99 3857; store a 149 3861; store b 2 3882; store b 6 3887; store b 10 3892; store b 3
3913; store b 7 3918; store b 11 3923; store by_c 13 90; store by_c 39 3924; store by_c 65 912; store by_c 14 3925;
store by_c 40 1912; store by_c 66 3926; store by_c 15 1826; store by_c 41 3927; store by_c 67 1979; store by_c 16
1830; store by_c 42 3928; store by_c 68 1982; store by_c 17 3929; store by_c 43 1923; store by_c 69 3930; store by_c
18 1839; store by_c 44 3931; store by_c 70 1989; store by_c 19 3932; store by_c 45 1929; store by_c 71 3933; store
by_c 20 3934; store by_c 46 1932; store by_c 72 3935; store by_c 21 1857; store by_c 47 3936; store by_c 73 1999;
store by_c 22 1861; store by_c 48 3937; store by_c 74 2002; store by_c 23 3938; store by_c 49 1943; store by_c 75
3939; store by_c 24 1870; store by_c 50 3940; store by_c 76 2009; store by_c 25 1874; store by_c 51 3941; store by_c
77 2012
    """,
)

BY_CONSTANTS = Graph(
    {'x': 15, 'u': 2, 'c': 13, 'z': 10, 'p': 276},
    {'by_k': 2850},
    """
constant 0.5539650012874084; input p 125; input z 9; mul 1 2; input p 9; input p 4; input x 0; input p 10; mul 6 7;
input x 2; input p 8; mul 9 10; add 8 11; input x 4; input p 11; mul 13 14; add 12 15; mul 16 16; mul 5 17; add 4
18; input p 13; input p 5; constant 1.0; input p 1; mul 9 23; mul 9 24; add 22 25; sqrt 26; div 22 27; input p 2;
mul 9 29; mul 9 30; add 22 31; sqrt 32; mul 27 33; div 22 34; mul 28 35; mul 28 33; mul 36 37; mul 21 38; input p 6;
mul 6 40; input p 7; mul 9 42; add 41 43; mul 10 13; add 44 45; mul 9 28; mul 36 47; mul 21 48; add 46 49; input p
12; mul 6 51; mul 9 40; add 52 53; mul 7 13; add 54 55; mul 50 56; add 39 57; mul 5 58; add 20 59; mul 19 60; mul 16
50; mul 5 62; mul 16 56; mul 5 64; mul 63 65; sub 61 66; input p 0; input p 3; mul 36 69; mul 36 70; add 68 71; mul
39 39; mul 50 50; add 73 74; mul 5 75; add 72 76; mul 19 77; mul 63 63; sub 78 79; mul 56 56; add 22 81; mul 5 82;
mul 80 83; mul 60 67; sub 84 85; mul 60 63; mul 65 77; sub 87 88; mul 65 89; add 86 90; div 22 91; mul 67 92; mul 3
93; mul 0 94; constant 0.13333333333333333; mul 89 92; mul 3 97; mul 96 98; input p 124; input z 8; mul 100 101; mul
97 102; mul 96 103; add 99 104; constant -0.16666666666666669; input p 150; input z 7; mul 107 108; mul 97 109; mul
106 110; add 105 111; input p 148; input z 6; mul 113 114; mul 97 115; mul 106 116; add 112 117; input z 5; mul 1
119; mul 97 120; mul 96 121; add 118 122; input z 4; mul 100 124; mul 97 125; mul 96 126; add 123 127; sub 95 128;
mul 93 102; mul 0 130; add 129 131; constant 0.16666666666666669; mul 93 109; mul 133 134; add 132 135; mul 93 115;
mul 133 137; add 136 138; constant -0.22063166795407502; mul 93 120; mul 140 141; add 139 142; mul 93 125; mul 140
144; add 143 145; input p 107; input p 105; mul 47 148; input p 106; mul 37 150; input p 108; sub 151 152; sub 149
153; sub 154 6; mul 155 155; constant 0.5; mul 6 56; mul 9 46; add 158 159; mul 13 16; add 160 161; mul 157 162;
input p 78; constant 0.25; constant 0.5249999999999999; constant -0.5249999999999999; input p 17; mul 6 168; max 167
169; min 166 170; constant 0.0; constant 0.35; sub 171 173; max 172 174; mul 175 175; constant -0.35; sub 177 171;
max 172 178; mul 179 179; sub 176 180; div 22 173; mul 181 182; sub 171 183; mul 184 184; mul 184 185; input p 69;
mul 186 187; constant 0.8999999999999999; constant -0.8999999999999999; max 190 9; min 189 191; constant 0.6; sub
192 193; max 172 194; mul 195 195; constant -0.6; sub 197 192; max 172 198; mul 199 199; sub 196 200; div 22 193;
mul 201 202; sub 192 203; mul 185 204; input p 70; mul 205 206; add 188 207; constant 2.4000000000000004; constant
-2.4000000000000004; max 210 13; min 209 211; constant 1.6; sub 212 213; max 172 214; mul 215 215; constant -1.6;
sub 217 212; max 172 218; mul 219 219; sub 216 220; div 22 213; mul 221 222; sub 212 223; mul 185 224; input p 71;
mul 225 226; add 208 227; mul 184 204; mul 204 229; input p 72; mul 230 231; add 228 232; mul 224 229; input p 73;
mul 234 235; add 233 236; mul 204 204; mul 204 238; input p 74; mul 239 240; add 237 241; mul 224 238; input p 75;
mul 243 244; add 242 245; mul 184 246; input p 79; mul 186 248; mul 205 231; add 249 250; input p 80; mul 225 252;
add 251 253; input p 81; mul 230 255; add 254 256; input p 82; mul 234 258; add 257 259; input p 83; mul 239 261;
add 260 262; input p 84; mul 243 264; add 263 265; mul 204 266; add 247 267; input p 85; mul 186 269; mul 205 252;
add 270 271; mul 230 244; add 272 273; input p 86; mul 239 275; add 274 276; mul 224 277; add 268 278; mul 165 279;
mul 164 280; add 163 281; input p 104; add 282 283; mul 37 148; add 284 285; mul 47 150; add 286 287; mul 288 288;
add 156 289; sqrt 290; mul 147 291; sqrt 292; div 22 293; mul 294 294; mul 147 295; input x 1; constant
5.714285714285714; add 175 179; mul 298 299; sub 22 300; mul 246 301; add 56 302; mul 297 303; input x 3; constant
3.3333333333333335; add 195 199; mul 306 307; sub 22 308; mul 266 309; mul 164 310; add 46 311; mul 305 312; add 304
313; input x 5; constant 1.25; add 215 219; mul 316 317; sub 22 318; mul 277 319; mul 164 320; add 16 321; mul 315
322; add 314 323; constant -0.5; mul 294 325; mul 294 326; mul 294 327; mul 147 328; constant 1.4; sub 292 330;
input p 101; input p 102; mul 331 333; add 332 334; mul 331 335; add 22 336; mul 329 337; input p 118; mul 338 339;
mul 338 340; add 285 287; mul 155 342; sub 151 149; mul 288 344; add 343 345; mul 296 346; mul 36 347; mul 93 348;
mul 80 92; mul 155 296; mul 350 351; add 349 352; mul 288 296; mul 97 322; mul 93 312; sub 355 356; mul 303 350; add
357 358; mul 354 359; sub 353 360; mul 341 361; mul 324 362; input p 94; input x 14; mul 364 365; sub 22 366; input
p 109; constant 2.0; mul 292 369; mul 295 369; mul 295 371; sub 370 372; mul 368 373; constant 0.3; constant -0.3;
max 376 331; min 375 377; input p 110; input p 111; mul 378 380; add 379 381; mul 378 382; add 22 383; mul 374 384;
mul 367 385; input u 1; input p 112; mul 387 388; input p 113; input p 114; mul 331 391; add 390 392; mul 331 393;
add 22 394; mul 389 395; sub 386 396; mul 147 397; input p 115; input x 7; mul 399 400; input p 116; input x 9; mul
402 403; add 401 404; input p 117; input x 11; mul 406 407; add 405 408; mul 338 409; add 398 410; mul 305 348; mul
297 351; sub 412 413; mul 324 354; add 414 415; mul 341 416; add 411 417; mul 359 418; sub 363 419; mul 296 420; mul
93 418; mul 305 362; add 422 423; mul 36 424; mul 296 425; mul 344 426; add 421 427; mul 288 369; mul 291 369; div
22 430; mul 361 416; mul 340 432; mul 338 432; mul 339 434; add 433 435; mul 361 409; add 436 437; mul 329 438; mul
335 439; mul 331 439; mul 333 441; add 440 442; mul 147 361; mul 389 444; mul 393 445; sub 443 446; mul 331 445; mul
391 448; sub 447 449; le 376 331; le 331 376; add 451 452; div 22 453; mul 451 454; le 377 375; le 375 377; add 456
457; div 22 458; mul 456 459; mul 367 444; mul 374 461; mul 382 462; mul 378 462; mul 380 464; add 463 465; mul 460
466; mul 455 467; add 450 468; mul 293 369; div 22 470; mul 294 328; mul 337 438; mul 147 473; mul 472 474; mul 294
474; mul 328 476; add 475 477; mul 294 476; mul 327 479; add 478 480; mul 294 369; mul 288 420; mul 350 418; mul 297
362; sub 484 485; mul 155 486; add 483 487; mul 346 425; add 488 489; mul 147 490; mul 384 461; mul 368 492; mul 371
493; sub 491 494; mul 295 493; neg 496; mul 369 497; add 495 498; mul 482 499; mul 295 500; add 481 501; mul 471
502; sub 469 503; mul 369 493; add 504 505; mul 147 506; mul 431 507; mul 429 508; add 428 509; sub 146 510; input p
76; input p 77; add 282 513; input p 87; mul 37 515; add 514 516; input p 88; mul 47 518; sub 517 519; input p 89;
mul 37 518; input p 90; sub 522 523; mul 47 515; add 524 525; sub 526 6; mul 527 527; mul 520 520; add 528 529; sqrt
530; mul 521 531; sqrt 532; div 22 533; mul 534 534; mul 521 535; mul 520 536; input p 91; mul 369 532; mul 369 535;
mul 535 540; sub 539 541; mul 538 542; sub 532 330; max 376 544; min 375 545; input p 92; input p 93; mul 546 548;
add 547 549; mul 546 550; add 22 551; mul 543 552; mul 367 553; input u 0; input p 95; mul 555 556; input p 96;
input p 97; mul 544 559; add 558 560; mul 544 561; add 22 562; mul 557 563; sub 554 564; mul 521 565; input p 98;
input x 6; mul 567 568; input p 99; input x 8; mul 570 571; add 569 572; input p 100; input x 10; mul 574 575; add
573 576; mul 325 534; mul 534 578; mul 534 579; mul 521 580; mul 333 544; add 332 582; mul 544 583; add 22 584; mul
581 585; mul 577 586; add 566 587; input p 103; mul 586 589; mul 586 590; sub 516 519; mul 527 592; add 522 525; mul
520 594; sub 593 595; mul 536 596; mul 36 597; mul 305 598; mul 527 536; mul 297 600; sub 599 601; mul 324 537; add
602 603; mul 591 604; add 588 605; mul 537 606; mul 354 418; add 607 608; sub 512 609; mul 97 610; mul 354 362; mul
93 598; mul 350 600; add 613 614; mul 359 537; sub 615 616; mul 591 617; mul 537 618; add 612 619; mul 315 620; add
611 621; mul 320 622; add 511 623; mul 305 620; mul 93 610; sub 625 626; mul 310 627; add 624 628; mul 324 618; mul
359 606; sub 630 631; mul 536 632; mul 93 606; mul 305 618; add 634 635; mul 36 636; mul 536 637; mul 594 638; sub
633 639; mul 369 520; mul 369 531; div 22 642; mul 604 617; mul 590 644; mul 586 644; mul 589 646; add 645 647; mul
577 617; add 648 649; mul 581 650; mul 583 651; mul 544 651; mul 333 653; add 652 654; mul 521 617; mul 557 656; mul
561 657; sub 655 658; mul 544 657; mul 559 660; sub 659 661; le 376 544; le 544 376; add 663 664; div 22 665; mul
663 666; le 545 375; le 375 545; add 668 669; div 22 670; mul 668 671; mul 367 656; mul 543 673; mul 550 674; mul
546 674; mul 548 676; add 675 677; mul 672 678; mul 667 679; add 662 680; mul 369 533; div 22 682; mul 534 580; mul
585 650; mul 521 685; mul 684 686; mul 534 686; mul 580 688; add 687 689; mul 534 688; mul 579 691; add 690 692; mul
369 534; mul 520 632; mul 350 606; mul 297 618; sub 696 697; mul 527 698; add 695 699; mul 596 637; add 700 701; mul
521 702; mul 552 673; mul 538 704; mul 540 705; sub 703 706; mul 535 705; neg 708; mul 369 709; add 707 710; mul 694
711; mul 535 712; add 693 713; mul 683 714; sub 681 715; mul 369 705; add 716 717; mul 521 718; mul 643 719; mul 641
720; add 640 721; add 510 722; mul 280 723; add 629 724; mul 168 169; le 167 169; le 169 167; add 727 728; div 22
729; mul 727 730; le 170 166; le 166 170; add 732 733; div 22 734; mul 732 735; mul 164 723; mul 165 737; mul 246
738; mul 164 627; mul 309 740; mul 204 738; add 741 742; mul 258 743; mul 350 610; mul 297 620; add 745 746; mul 301
747; mul 184 738; add 748 749; mul 235 750; add 744 751; mul 224 752; mul 164 622; mul 319 754; mul 224 738; add 755
756; mul 244 757; mul 255 743; add 758 759; mul 231 750; add 760 761; mul 204 762; add 753 763; mul 204 764; add 739
765; mul 269 757; mul 248 743; add 767 768; mul 187 750; add 769 770; mul 185 771; add 766 772; mul 184 369; mul 252
743; mul 226 750; add 775 776; mul 224 777; mul 252 757; mul 231 743; add 779 780; mul 206 750; add 781 782; mul 204
783; add 778 784; mul 184 771; add 785 786; mul 774 787; add 773 788; le 172 178; le 178 172; add 790 791; div 22
792; mul 790 793; mul 179 369; constant 2.857142857142857; mul 789 796; mul 795 797; mul 246 747; mul 298 799; sub
798 800; mul 794 801; sub 789 802; le 172 174; le 174 172; add 804 805; div 22 806; mul 804 807; mul 175 369; mul
797 809; add 800 810; mul 808 811; sub 803 812; mul 736 813; mul 731 814; mul 726 815; sub 725 816; sub 817 722;
input p 18; input p 19; input p 20; mul 169 821; input p 21; mul 9 823; add 822 824; input p 22; mul 13 826; add 825
827; mul 820 828; input p 23; mul 13 828; mul 830 831; add 829 832; input p 24; mul 13 831; mul 834 835; add 833
836; input p 25; mul 828 828; mul 838 839; add 837 840; input p 26; mul 13 839; mul 842 843; add 841 844; input p
27; mul 828 839; mul 846 847; add 845 848; input p 28; mul 169 850; add 849 851; input p 29; mul 13 169; mul 853
854; add 852 855; input p 30; mul 13 854; mul 857 858; add 856 859; input p 31; mul 169 828; mul 861 862; add 860
863; input p 32; mul 13 862; mul 865 866; add 864 867; input p 33; mul 828 862; mul 869 870; add 868 871; input p
34; mul 169 169; mul 828 874; mul 873 875; add 872 876; input p 35; mul 169 874; mul 878 879; add 877 880; input p
36; input p 37; mul 13 883; add 882 884; input p 38; mul 13 13; mul 886 887; add 885 888; input p 39; mul 13 887;
mul 890 891; add 889 892; input p 40; mul 828 894; add 893 895; input p 41; mul 831 897; add 896 898; input p 42;
mul 835 900; add 899 901; input p 43; mul 839 903; add 902 904; input p 44; mul 843 906; add 905 907; input p 45;
mul 847 909; add 908 910; mul 169 820; add 911 912; mul 830 854; add 913 914; mul 834 858; add 915 916; input p 46;
mul 862 918; add 917 919; input p 47; mul 866 921; add 920 922; input p 48; mul 870 924; add 923 925; input p 49;
mul 874 927; add 926 928; input p 50; mul 13 874; mul 930 931; add 929 932; mul 869 875; add 933 934; input p 51;
mul 879 936; add 935 937; mul 821 938; add 881 939; input p 52; mul 185 941; input p 53; mul 229 943; add 942 944;
input p 54; mul 184 224; mul 946 947; add 945 948; input p 55; mul 238 950; add 949 951; input p 56; mul 204 224;
mul 953 954; add 952 955; input p 57; mul 224 224; mul 957 958; add 956 959; mul 224 958; mul 960 961; input p 58;
mul 186 963; input p 59; mul 205 965; add 964 966; input p 60; mul 225 968; add 967 969; input p 61; mul 230 971;
add 970 972; input p 62; mul 234 974; add 973 975; input p 63; mul 224 947; mul 977 978; add 976 979; input p 64;
mul 239 981; add 980 982; input p 65; mul 243 984; add 983 985; input p 66; mul 224 954; mul 987 988; add 986 989;
input p 67; mul 961 991; add 990 992; add 962 993; mul 301 994; add 940 995; mul 819 996; input p 68; constant 12.0;
mul 168 297; mul 999 1000; constant -6.0; mul 821 1000; mul 305 823; add 1003 1004; mul 315 826; add 1005 1006; mul
1002 1007; add 1001 1008; mul 998 1009; mul 1000 1002; constant 4.0; mul 1007 1012; add 1011 1013; mul 998 1014; mul
821 1015; add 1010 1016; add 997 1017; mul 168 1018; mul 168 1019; mul 350 1020; add 818 1021; mul 168 1000; mul 93
823; mul 97 826; sub 1024 1025; mul 168 350; mul 821 1027; sub 1026 1028; mul 998 1029; mul 1002 1030; mul 1012
1030; mul 998 1027; mul 1002 1033; sub 1032 1034; mul 821 1035; add 1031 1036; mul 999 1033; sub 1037 1038; mul 1023
1039; sub 1022 1040; input p 137; mul 93 819; mul 309 1043; mul 1042 1044; input p 172; constant 3.0; mul 958 1047;
mul 97 819; mul 319 1049; mul 1048 1050; mul 1046 1051; input p 166; mul 1050 1053; add 1052 1054; sub 1045 1055;
mul 819 1027; mul 301 1057; mul 963 1058; sub 1056 1059; mul 185 1060; mul 961 1044; mul 953 1062; input p 162; mul
961 1050; mul 1064 1065; sub 1063 1066; mul 987 1044; mul 957 1051; input p 168; mul 1050 1070; add 1069 1071; sub
1068 1072; mul 977 1058; sub 1073 1074; mul 224 1075; add 1067 1076; mul 961 1058; mul 946 1078; sub 1077 1079; mul
224 1080; add 1061 1081; input p 133; mul 1062 1083; mul 953 1065; sub 1084 1085; input p 140; mul 1044 1087; mul
953 1051; input p 167; mul 1050 1090; add 1089 1091; sub 1088 1092; mul 974 1058; sub 1093 1094; mul 224 1095; add
1086 1096; input p 139; mul 1044 1098; mul 950 1051; mul 984 1050; add 1100 1101; sub 1099 1102; mul 971 1058; sub
1103 1104; mul 204 1105; add 1097 1106; mul 943 1078; sub 1107 1108; mul 204 1109; add 1082 1110; input p 132; mul
1062 1112; input p 161; mul 1065 1114; sub 1113 1115; input p 138; mul 1044 1117; mul 1051 1114; mul 977 1050; add
1119 1120; sub 1118 1121; mul 968 1058; sub 1122 1123; mul 224 1124; add 1116 1125; mul 971 1044; mul 1051 1112; mul
1050 1117; add 1128 1129; sub 1127 1130; mul 965 1058; sub 1131 1132; mul 204 1133; add 1126 1134; mul 184 1060; add
1135 1136; mul 941 1078; sub 1137 1138; mul 774 1139; add 1111 1140; mul 994 1057; mul 298 1142; mul 796 1141; mul
795 1144; add 1143 1145; mul 794 1146; sub 1141 1147; mul 809 1144; sub 1143 1149; mul 808 1150; add 1148 1151; mul
736 1152; mul 731 1153; mul 726 1154; sub 1041 1155; mul 823 1043; mul 826 1049; sub 1157 1158; mul 821 1057; sub
1159 1160; mul 936 1161; mul 874 1162; mul 169 369; mul 930 1049; mul 828 1165; mul 1164 1166; mul 857 1049; mul 13
1168; mul 1164 1169; add 1167 1170; input p 160; mul 1049 1172; mul 1164 1173; add 1171 1174; mul 842 1049; mul 828
1176; mul 828 1177; add 1175 1178; input p 159; mul 1049 1180; mul 13 1181; mul 828 1182; add 1179 1183; mul 830
1049; mul 828 1185; add 1184 1186; sub 1163 1187; mul 169 1162; mul 1164 1189; add 1188 1190; mul 869 1161; mul 828
1192; mul 1164 1193; add 1191 1194; mul 930 1161; mul 13 1196; mul 1164 1197; add 1195 1198; mul 927 1161; mul 1164
1200; add 1199 1201; mul 924 1161; mul 828 1203; mul 828 1204; add 1202 1205; mul 921 1161; mul 13 1207; mul 828
1208; add 1206 1209; mul 918 1161; mul 828 1211; add 1210 1212; mul 834 1161; mul 13 1214; mul 13 1215; add 1213
1216; mul 830 1161; mul 13 1218; add 1217 1219; mul 820 1161; add 1220 1221; mul 878 1057; mul 874 1223; sub 1222
1224; mul 169 1223; mul 1164 1226; sub 1225 1227; mul 873 1057; mul 828 1229; mul 1164 1230; sub 1228 1231; mul 869
1057; mul 828 1233; mul 828 1234; sub 1232 1235; mul 865 1057; mul 13 1237; mul 828 1238; sub 1236 1239; mul 861
1057; mul 828 1241; sub 1240 1242; mul 857 1057; mul 13 1244; mul 13 1245; sub 1243 1246; mul 853 1057; mul 13 1248;
sub 1247 1249; mul 850 1057; sub 1250 1251; mul 874 1192; mul 874 1165; mul 862 1176; add 1254 1255; mul 169 1177;
add 1256 1257; mul 169 1182; add 1258 1259; mul 169 1185; add 1260 1261; input p 158; mul 1049 1263; mul 839 1264;
add 1262 1265; mul 369 828; mul 828 1264; mul 1267 1268; add 1266 1269; mul 900 1049; mul 13 1271; mul 1267 1272;
add 1270 1273; input p 157; mul 1049 1275; mul 1267 1276; add 1274 1277; input p 156; mul 1049 1279; mul 13 1280;
mul 13 1281; add 1278 1282; input p 155; mul 1049 1284; mul 13 1285; add 1283 1286; mul 883 1049; add 1287 1288; sub
1253 1289; mul 862 1203; add 1290 1291; mul 169 1204; add 1292 1293; mul 169 1208; add 1294 1295; mul 169 1211; add
1296 1297; mul 909 1161; mul 839 1299; add 1298 1300; mul 828 1299; mul 1267 1302; add 1301 1303; mul 906 1161; mul
13 1305; mul 1267 1306; add 1304 1307; mul 903 1161; mul 1267 1309; add 1308 1310; mul 900 1161; mul 13 1312; mul 13
1313; add 1311 1314; mul 897 1161; mul 13 1316; add 1315 1317; mul 894 1161; add 1318 1319; mul 874 1229; sub 1320
1321; mul 862 1233; sub 1322 1323; mul 169 1234; sub 1324 1325; mul 169 1238; sub 1326 1327; mul 169 1241; sub 1328
1329; mul 846 1057; mul 839 1331; sub 1330 1332; mul 828 1331; mul 1267 1334; sub 1333 1335; mul 842 1057; mul 13
1337; mul 1267 1338; sub 1336 1339; mul 838 1057; mul 1267 1341; sub 1340 1342; mul 834 1057; mul 13 1344; mul 13
1345; sub 1343 1346; mul 830 1057; mul 13 1348; sub 1347 1349; mul 820 1057; sub 1350 1351; mul 821 1352; add 1252
1353; mul 726 1354; sub 1156 1355; input p 254; input c 4; input p 14; mul 6 1359; sub 9 1360; input c 5; mul 1361
1362; sub 1358 1363; input c 6; mul 555 1365; add 1364 1366; input c 7; mul 387 1368; add 1367 1369; input c 8;
input p 15; max 1371 1372; mul 297 1359; sub 305 1374; mul 1373 1375; sub 1370 1376; mul 350 1377; mul 350 1359; add
93 1379; mul 1373 1380; mul 297 1381; add 1378 1382; mul 1362 1380; input c 9; input c 10; mul 157 1386; mul 1361
1387; sub 1385 1388; input c 11; mul 555 1390; add 1389 1391; input c 12; mul 387 1393; add 1392 1394; mul 350 1395;
add 1384 1396; mul 350 1361; mul 1387 1398; sub 1397 1399; mul 6 1400; add 1383 1401; mul 1357 1402; add 1356 1403;
mul 63 83; mul 60 65; sub 1405 1406; mul 92 1407; mul 3 1408; mul 96 1409; mul 102 1408; mul 96 1411; add 1410 1412;
mul 109 1408; mul 106 1414; add 1413 1415; mul 115 1408; mul 106 1417; add 1416 1418; mul 120 1408; mul 96 1420; add
1419 1421; mul 125 1408; mul 96 1423; add 1422 1424; mul 19 83; mul 65 65; sub 1426 1427; mul 92 1428; mul 3 1429;
mul 0 1430; sub 1425 1431; mul 102 1429; mul 0 1433; sub 1432 1434; mul 109 1429; mul 133 1436; sub 1435 1437; mul
115 1429; mul 133 1439; sub 1438 1440; mul 120 1429; mul 140 1442; sub 1441 1443; mul 125 1429; mul 140 1445; sub
1444 1446; mul 348 1429; mul 93 351; add 1448 1449; mul 312 1429; mul 322 1408; sub 1451 1452; mul 93 303; sub 1453
1454; mul 354 1455; add 1450 1456; mul 147 1457; mul 389 1458; mul 393 1459; mul 416 1457; mul 340 1461; mul 338
1461; mul 339 1463; add 1462 1464; mul 409 1457; add 1465 1466; mul 329 1467; mul 335 1468; mul 331 1468; mul 333
1470; add 1469 1471; sub 1460 1472; mul 331 1459; mul 391 1474; add 1473 1475; mul 367 1458; mul 374 1477; mul 382
1478; mul 378 1478; mul 380 1480; add 1479 1481; mul 460 1482; mul 455 1483; sub 1476 1484; mul 337 1467; mul 147
1486; mul 472 1487; mul 294 1487; mul 328 1489; add 1488 1490; mul 294 1489; mul 327 1492; add 1491 1493; mul 341
1457; mul 297 1495; sub 1496 422; mul 155 1497; mul 418 1455; mul 324 1495; add 1499 1500; mul 288 1501; sub 1498
1502; mul 418 1429; mul 305 1495; add 1504 1505; mul 36 1506; mul 346 1507; sub 1503 1508; mul 147 1509; mul 384
1477; mul 368 1511; mul 371 1512; add 1510 1513; mul 295 1512; mul 369 1515; add 1514 1516; mul 482 1517; mul 295
1518; sub 1494 1519; mul 471 1520; add 1485 1521; neg 1512; mul 369 1523; add 1522 1524; mul 147 1525; mul 431 1526;
mul 429 1527; mul 296 1501; mul 296 1507; mul 344 1530; add 1529 1531; sub 1528 1532; sub 1447 1533; mul 610 1408;
mul 354 1495; mul 598 1429; mul 93 600; add 1537 1538; mul 537 1455; add 1539 1540; mul 591 1541; mul 537 1542; add
1536 1543; mul 315 1544; add 1535 1545; mul 320 1546; sub 1534 1547; mul 610 1429; mul 305 1544; sub 1549 1550; mul
310 1551; add 1548 1552; mul 606 1429; mul 305 1542; add 1554 1555; mul 36 1556; mul 536 1557; mul 594 1558; mul 606
1455; mul 324 1542; add 1560 1561; mul 536 1562; sub 1559 1563; mul 521 1541; mul 557 1565; mul 561 1566; mul 604
1541; mul 590 1568; mul 586 1568; mul 589 1570; add 1569 1571; mul 577 1541; add 1572 1573; mul 581 1574; mul 583
1575; mul 544 1575; mul 333 1577; add 1576 1578; sub 1567 1579; mul 544 1566; mul 559 1581; add 1580 1582; mul 367
1565; mul 543 1584; mul 550 1585; mul 546 1585; mul 548 1587; add 1586 1588; mul 672 1589; mul 667 1590; sub 1583
1591; mul 585 1574; mul 521 1593; mul 684 1594; mul 534 1594; mul 580 1596; add 1595 1597; mul 534 1596; mul 579
1599; add 1598 1600; mul 297 1542; sub 1602 634; mul 527 1603; mul 520 1562; sub 1604 1605; mul 596 1557; sub 1606
1607; mul 521 1608; mul 552 1584; mul 538 1610; mul 540 1611; add 1609 1612; mul 535 1611; mul 369 1614; add 1613
1615; mul 694 1616; mul 535 1617; sub 1601 1618; mul 683 1619; add 1592 1620; neg 1611; mul 369 1622; add 1621 1623;
mul 521 1624; mul 643 1625; mul 641 1626; add 1564 1627; add 1533 1628; mul 280 1629; add 1553 1630; mul 164 1629;
mul 165 1632; mul 246 1633; mul 164 1551; mul 309 1635; mul 204 1633; add 1636 1637; mul 258 1638; mul 184 1633; mul
297 1544; add 626 1641; mul 301 1642; sub 1640 1643; mul 235 1644; add 1639 1645; mul 224 1646; mul 224 1633; mul
164 1546; mul 319 1649; sub 1648 1650; mul 244 1651; mul 255 1638; add 1652 1653; mul 231 1644; add 1654 1655; mul
204 1656; add 1647 1657; mul 204 1658; add 1634 1659; mul 269 1651; mul 248 1638; add 1661 1662; mul 187 1644; add
1663 1664; mul 185 1665; add 1660 1666; mul 252 1638; mul 226 1644; add 1668 1669; mul 224 1670; mul 252 1651; mul
231 1638; add 1672 1673; mul 206 1644; add 1674 1675; mul 204 1676; add 1671 1677; mul 184 1665; add 1678 1679; mul
774 1680; add 1667 1681; mul 246 1642; mul 298 1683; mul 796 1682; mul 795 1685; add 1684 1686; mul 794 1687; sub
1682 1688; mul 809 1685; sub 1684 1690; mul 808 1691; add 1689 1692; mul 736 1693; mul 731 1694; mul 726 1695; sub
1631 1696; sub 1697 1628; mul 93 1020; sub 1698 1699; mul 826 1408; mul 823 1429; sub 1701 1702; mul 93 168; mul 821
1704; add 1703 1705; mul 998 1706; mul 1002 1707; mul 1012 1707; mul 998 1704; mul 1002 1710; add 1709 1711; mul 821
1712; add 1708 1713; mul 999 1710; add 1714 1715; mul 1023 1716; sub 1700 1717; mul 819 1408; mul 319 1719; mul 1048
1720; mul 1046 1721; mul 1053 1720; add 1722 1723; mul 819 1429; mul 309 1725; mul 1042 1726; sub 1724 1727; mul 819
1704; mul 301 1729; mul 963 1730; add 1728 1731; mul 185 1732; mul 961 1720; mul 1064 1734; mul 961 1726; mul 953
1736; sub 1735 1737; mul 957 1721; mul 1070 1720; add 1739 1740; mul 987 1726; sub 1741 1742; mul 977 1730; add 1743
1744; mul 224 1745; add 1738 1746; mul 961 1730; mul 946 1748; add 1747 1749; mul 224 1750; add 1733 1751; mul 953
1734; mul 1083 1736; sub 1753 1754; mul 953 1721; mul 1090 1720; add 1756 1757; mul 1087 1726; sub 1758 1759; mul
974 1730; add 1760 1761; mul 224 1762; add 1755 1763; mul 950 1721; mul 984 1720; add 1765 1766; mul 1098 1726; sub
1767 1768; mul 971 1730; add 1769 1770; mul 204 1771; add 1764 1772; mul 943 1748; add 1773 1774; mul 204 1775; add
1752 1776; mul 1114 1734; mul 1112 1736; sub 1778 1779; mul 1114 1721; mul 977 1720; add 1781 1782; mul 1117 1726;
sub 1783 1784; mul 968 1730; add 1785 1786; mul 224 1787; add 1780 1788; mul 1112 1721; mul 1117 1720; add 1790
1791; mul 971 1726; sub 1792 1793; mul 965 1730; add 1794 1795; mul 204 1796; add 1789 1797; mul 184 1732; add 1798
1799; mul 941 1748; add 1800 1801; mul 774 1802; add 1777 1803; mul 796 1804; mul 795 1805; mul 994 1729; mul 298
1807; sub 1806 1808; mul 794 1809; sub 1804 1810; mul 809 1805; add 1808 1812; mul 808 1813; sub 1811 1814; mul 736
1815; mul 731 1816; mul 726 1817; sub 1718 1818; mul 930 1719; mul 828 1820; mul 1164 1821; mul 857 1719; mul 13
1823; mul 1164 1824; add 1822 1825; mul 1172 1719; mul 1164 1827; add 1826 1828; mul 842 1719; mul 828 1830; mul 828
1831; add 1829 1832; mul 1180 1719; mul 13 1834; mul 828 1835; add 1833 1836; mul 830 1719; mul 828 1838; add 1837
1839; mul 826 1719; mul 823 1725; sub 1841 1842; mul 821 1729; add 1843 1844; mul 936 1845; mul 874 1846; add 1840
1847; mul 169 1846; mul 1164 1849; add 1848 1850; mul 869 1845; mul 828 1852; mul 1164 1853; add 1851 1854; mul 930
1845; mul 13 1856; mul 1164 1857; add 1855 1858; mul 927 1845; mul 1164 1860; add 1859 1861; mul 924 1845; mul 828
1863; mul 828 1864; add 1862 1865; mul 921 1845; mul 13 1867; mul 828 1868; add 1866 1869; mul 918 1845; mul 828
1871; add 1870 1872; mul 834 1845; mul 13 1874; mul 13 1875; add 1873 1876; mul 830 1845; mul 13 1878; add 1877
1879; mul 820 1845; add 1880 1881; mul 878 1729; mul 874 1883; add 1882 1884; mul 169 1883; mul 1164 1886; add 1885
1887; mul 873 1729; mul 828 1889; mul 1164 1890; add 1888 1891; mul 869 1729; mul 828 1893; mul 828 1894; add 1892
1895; mul 865 1729; mul 13 1897; mul 828 1898; add 1896 1899; mul 861 1729; mul 828 1901; add 1900 1902; mul 857
1729; mul 13 1904; mul 13 1905; add 1903 1906; mul 853 1729; mul 13 1908; add 1907 1909; mul 850 1729; add 1910
1911; mul 874 1820; mul 862 1830; add 1913 1914; mul 169 1831; add 1915 1916; mul 169 1835; add 1917 1918; mul 169
1838; add 1919 1920; mul 1263 1719; mul 839 1922; add 1921 1923; mul 828 1922; mul 1267 1925; add 1924 1926; mul 900
1719; mul 13 1928; mul 1267 1929; add 1927 1930; mul 1275 1719; mul 1267 1932; add 1931 1933; mul 1279 1719; mul 13
1935; mul 13 1936; add 1934 1937; mul 1284 1719; mul 13 1939; add 1938 1940; mul 883 1719; add 1941 1942; mul 874
1852; add 1943 1944; mul 862 1863; add 1945 1946; mul 169 1864; add 1947 1948; mul 169 1868; add 1949 1950; mul 169
1871; add 1951 1952; mul 909 1845; mul 839 1954; add 1953 1955; mul 828 1954; mul 1267 1957; add 1956 1958; mul 906
1845; mul 13 1960; mul 1267 1961; add 1959 1962; mul 903 1845; mul 1267 1964; add 1963 1965; mul 900 1845; mul 13
1967; mul 13 1968; add 1966 1969; mul 897 1845; mul 13 1971; add 1970 1972; mul 894 1845; add 1973 1974; mul 874
1889; add 1975 1976; mul 862 1893; add 1977 1978; mul 169 1894; add 1979 1980; mul 169 1898; add 1981 1982; mul 169
1901; add 1983 1984; mul 846 1729; mul 839 1986; add 1985 1987; mul 828 1986; mul 1267 1989; add 1988 1990; mul 842
1729; mul 13 1992; mul 1267 1993; add 1991 1994; mul 838 1729; mul 1267 1996; add 1995 1997; mul 834 1729; mul 13
1999; mul 13 2000; add 1998 2001; mul 830 1729; mul 13 2003; add 2002 2004; mul 820 1729; add 2005 2006; mul 821
2007; add 1912 2008; mul 726 2009; sub 1819 2010; mul 93 1377; mul 93 1359; add 1429 2013; mul 1373 2014; mul 297
2015; add 2012 2016; mul 93 1361; mul 1387 2018; mul 1362 2014; mul 93 1395; add 2020 2021; sub 2019 2022; mul 6
2023; sub 2017 2024; mul 1357 2025; sub 2011 2026; mul 0 1409; mul 77 83; mul 60 60; sub 2029 2030; mul 92 2031; mul
3 2032; mul 96 2033; mul 102 2032; mul 96 2035; add 2034 2036; mul 109 2032; mul 106 2038; add 2037 2039; mul 115
2032; mul 106 2041; add 2040 2042; mul 120 2032; mul 96 2044; add 2043 2045; mul 125 2032; mul 96 2047; add 2046
2048; sub 2028 2049; mul 0 1411; add 2050 2051; mul 133 1414; add 2052 2053; mul 133 1417; add 2054 2055; mul 140
1420; add 2056 2057; mul 140 1423; add 2058 2059; mul 348 1408; mul 97 351; add 2061 2062; mul 322 2032; mul 312
1408; sub 2064 2065; mul 97 303; add 2066 2067; mul 354 2068; sub 2063 2069; mul 341 2070; mul 324 2071; mul 418
2068; sub 2072 2073; mul 296 2074; mul 418 1408; mul 305 2071; add 2076 2077; mul 36 2078; mul 296 2079; mul 344
2080; add 2075 2081; mul 416 2070; mul 340 2083; mul 338 2083; mul 339 2085; add 2084 2086; mul 409 2070; add 2087
2088; mul 329 2089; mul 335 2090; mul 331 2090; mul 333 2092; add 2091 2093; mul 147 2070; mul 389 2095; mul 393
2096; sub 2094 2097; mul 331 2096; mul 391 2099; sub 2098 2100; mul 367 2095; mul 374 2102; mul 382 2103; mul 378
2103; mul 380 2105; add 2104 2106; mul 460 2107; mul 455 2108; add 2101 2109; mul 337 2089; mul 147 2111; mul 472
2112; mul 294 2112; mul 328 2114; add 2113 2115; mul 294 2114; mul 327 2117; add 2116 2118; mul 288 2074; mul 97
418; mul 297 2071; sub 2121 2122; mul 155 2123; add 2120 2124; mul 346 2079; add 2125 2126; mul 147 2127; mul 384
2102; mul 368 2129; mul 371 2130; sub 2128 2131; mul 295 2130; neg 2133; mul 369 2134; add 2132 2135; mul 482 2136;
mul 295 2137; add 2119 2138; mul 471 2139; sub 2110 2140; mul 369 2130; add 2141 2142; mul 147 2143; mul 431 2144;
mul 429 2145; add 2082 2146; sub 2060 2147; mul 610 2032; mul 354 2071; mul 598 1408; mul 97 600; add 2151 2152; mul
537 2068; sub 2153 2154; mul 591 2155; mul 537 2156; add 2150 2157; mul 315 2158; add 2149 2159; mul 320 2160; add
2148 2161; mul 305 2158; sub 2163 1535; mul 310 2164; add 2162 2165; mul 324 2156; mul 606 2068; sub 2167 2168; mul
536 2169; mul 606 1408; mul 305 2156; add 2171 2172; mul 36 2173; mul 536 2174; mul 594 2175; sub 2170 2176; mul 604
2155; mul 590 2178; mul 586 2178; mul 589 2180; add 2179 2181; mul 577 2155; add 2182 2183; mul 581 2184; mul 583
2185; mul 544 2185; mul 333 2187; add 2186 2188; mul 521 2155; mul 557 2190; mul 561 2191; sub 2189 2192; mul 544
2191; mul 559 2194; sub 2193 2195; mul 367 2190; mul 543 2197; mul 550 2198; mul 546 2198; mul 548 2200; add 2199
2201; mul 672 2202; mul 667 2203; add 2196 2204; mul 585 2184; mul 521 2206; mul 684 2207; mul 534 2207; mul 580
2209; add 2208 2210; mul 534 2209; mul 579 2212; add 2211 2213; mul 520 2169; mul 97 606; mul 297 2156; sub 2216
2217; mul 527 2218; add 2215 2219; mul 596 2174; add 2220 2221; mul 521 2222; mul 552 2197; mul 538 2224; mul 540
2225; sub 2223 2226; mul 535 2225; neg 2228; mul 369 2229; add 2227 2230; mul 694 2231; mul 535 2232; add 2214 2233;
mul 683 2234; sub 2205 2235; mul 369 2225; add 2236 2237; mul 521 2238; mul 643 2239; mul 641 2240; add 2177 2241;
add 2147 2242; mul 280 2243; add 2166 2244; mul 164 2243; mul 165 2246; mul 246 2247; mul 164 2164; mul 309 2249;
mul 204 2247; add 2250 2251; mul 258 2252; mul 297 2158; add 611 2254; mul 301 2255; mul 184 2247; add 2256 2257;
mul 235 2258; add 2253 2259; mul 224 2260; mul 164 2160; mul 319 2262; mul 224 2247; add 2263 2264; mul 244 2265;
mul 255 2252; add 2266 2267; mul 231 2258; add 2268 2269; mul 204 2270; add 2261 2271; mul 204 2272; add 2248 2273;
mul 269 2265; mul 248 2252; add 2275 2276; mul 187 2258; add 2277 2278; mul 185 2279; add 2274 2280; mul 252 2252;
mul 226 2258; add 2282 2283; mul 224 2284; mul 252 2265; mul 231 2252; add 2286 2287; mul 206 2258; add 2288 2289;
mul 204 2290; add 2285 2291; mul 184 2279; add 2292 2293; mul 774 2294; add 2281 2295; mul 796 2296; mul 795 2297;
mul 246 2255; mul 298 2299; sub 2298 2300; mul 794 2301; sub 2296 2302; mul 809 2297; add 2300 2304; mul 808 2305;
sub 2303 2306; mul 736 2307; mul 731 2308; mul 726 2309; sub 2245 2310; sub 2311 2242; mul 97 1020; add 2312 2313;
mul 823 1408; mul 826 2032; sub 2315 2316; mul 97 168; mul 821 2318; sub 2317 2319; mul 998 2320; mul 1002 2321; mul
1012 2321; mul 998 2318; mul 1002 2324; sub 2323 2325; mul 821 2326; add 2322 2327; mul 999 2324; sub 2328 2329; mul
1023 2330; sub 2314 2331; mul 309 1719; mul 1042 2333; mul 819 2032; mul 319 2335; mul 1048 2336; mul 1046 2337; mul
1053 2336; add 2338 2339; sub 2334 2340; mul 819 2318; mul 301 2342; mul 963 2343; sub 2341 2344; mul 185 2345; mul
961 2333; mul 953 2347; mul 961 2336; mul 1064 2349; sub 2348 2350; mul 987 2333; mul 957 2337; mul 1070 2336; add
2353 2354; sub 2352 2355; mul 977 2343; sub 2356 2357; mul 224 2358; add 2351 2359; mul 961 2343; mul 946 2361; sub
2360 2362; mul 224 2363; add 2346 2364; mul 1083 2347; mul 953 2349; sub 2366 2367; mul 1087 2333; mul 953 2337; mul
1090 2336; add 2370 2371; sub 2369 2372; mul 974 2343; sub 2373 2374; mul 224 2375; add 2368 2376; mul 1098 2333;
mul 950 2337; mul 984 2336; add 2379 2380; sub 2378 2381; mul 971 2343; sub 2382 2383; mul 204 2384; add 2377 2385;
mul 943 2361; sub 2386 2387; mul 204 2388; add 2365 2389; mul 1112 2347; mul 1114 2349; sub 2391 2392; mul 1117
2333; mul 1114 2337; mul 977 2336; add 2395 2396; sub 2394 2397; mul 968 2343; sub 2398 2399; mul 224 2400; add 2393
2401; mul 971 2333; mul 1112 2337; mul 1117 2336; add 2404 2405; sub 2403 2406; mul 965 2343; sub 2407 2408; mul 204
2409; add 2402 2410; mul 184 2345; add 2411 2412; mul 941 2361; sub 2413 2414; mul 774 2415; add 2390 2416; mul 994
2342; mul 298 2418; mul 796 2417; mul 795 2420; add 2419 2421; mul 794 2422; sub 2417 2423; mul 809 2420; sub 2419
2425; mul 808 2426; add 2424 2427; mul 736 2428; mul 731 2429; mul 726 2430; sub 2332 2431; mul 823 1719; mul 826
2335; sub 2433 2434; mul 821 2342; sub 2435 2436; mul 936 2437; mul 874 2438; mul 930 2335; mul 828 2440; mul 1164
2441; mul 857 2335; mul 13 2443; mul 1164 2444; add 2442 2445; mul 1172 2335; mul 1164 2447; add 2446 2448; mul 842
2335; mul 828 2450; mul 828 2451; add 2449 2452; mul 1180 2335; mul 13 2454; mul 828 2455; add 2453 2456; mul 830
2335; mul 828 2458; add 2457 2459; sub 2439 2460; mul 169 2438; mul 1164 2462; add 2461 2463; mul 869 2437; mul 828
2465; mul 1164 2466; add 2464 2467; mul 930 2437; mul 13 2469; mul 1164 2470; add 2468 2471; mul 927 2437; mul 1164
2473; add 2472 2474; mul 924 2437; mul 828 2476; mul 828 2477; add 2475 2478; mul 921 2437; mul 13 2480; mul 828
2481; add 2479 2482; mul 918 2437; mul 828 2484; add 2483 2485; mul 834 2437; mul 13 2487; mul 13 2488; add 2486
2489; mul 830 2437; mul 13 2491; add 2490 2492; mul 820 2437; add 2493 2494; mul 878 2342; mul 874 2496; sub 2495
2497; mul 169 2496; mul 1164 2499; sub 2498 2500; mul 873 2342; mul 828 2502; mul 1164 2503; sub 2501 2504; mul 869
2342; mul 828 2506; mul 828 2507; sub 2505 2508; mul 865 2342; mul 13 2510; mul 828 2511; sub 2509 2512; mul 861
2342; mul 828 2514; sub 2513 2515; mul 857 2342; mul 13 2517; mul 13 2518; sub 2516 2519; mul 853 2342; mul 13 2521;
sub 2520 2522; mul 850 2342; sub 2523 2524; mul 874 2465; mul 874 2440; mul 862 2450; add 2527 2528; mul 169 2451;
add 2529 2530; mul 169 2455; add 2531 2532; mul 169 2458; add 2533 2534; mul 1263 2335; mul 839 2536; add 2535 2537;
mul 828 2536; mul 1267 2539; add 2538 2540; mul 900 2335; mul 13 2542; mul 1267 2543; add 2541 2544; mul 1275 2335;
mul 1267 2546; add 2545 2547; mul 1279 2335; mul 13 2549; mul 13 2550; add 2548 2551; mul 1284 2335; mul 13 2553;
add 2552 2554; mul 883 2335; add 2555 2556; sub 2526 2557; mul 862 2476; add 2558 2559; mul 169 2477; add 2560 2561;
mul 169 2481; add 2562 2563; mul 169 2484; add 2564 2565; mul 909 2437; mul 839 2567; add 2566 2568; mul 828 2567;
mul 1267 2570; add 2569 2571; mul 906 2437; mul 13 2573; mul 1267 2574; add 2572 2575; mul 903 2437; mul 1267 2577;
add 2576 2578; mul 900 2437; mul 13 2580; mul 13 2581; add 2579 2582; mul 897 2437; mul 13 2584; add 2583 2585; mul
894 2437; add 2586 2587; mul 874 2502; sub 2588 2589; mul 862 2506; sub 2590 2591; mul 169 2507; sub 2592 2593; mul
169 2511; sub 2594 2595; mul 169 2514; sub 2596 2597; mul 846 2342; mul 839 2599; sub 2598 2600; mul 828 2599; mul
1267 2602; sub 2601 2603; mul 842 2342; mul 13 2605; mul 1267 2606; sub 2604 2607; mul 838 2342; mul 1267 2609; sub
2608 2610; mul 834 2342; mul 13 2612; mul 13 2613; sub 2611 2614; mul 830 2342; mul 13 2616; sub 2615 2617; mul 820
2342; sub 2618 2619; mul 821 2620; add 2525 2621; mul 726 2622; sub 2432 2623; mul 97 1377; mul 97 1359; add 1408
2626; mul 1373 2627; mul 297 2628; add 2625 2629; mul 1362 2627; mul 97 1395; add 2631 2632; mul 97 1361; mul 1387
2634; sub 2633 2635; mul 6 2636; add 2630 2637; mul 1357 2638; add 2624 2639; mul 537 586; mul 315 2641; mul 320
2642; mul 305 2641; mul 310 2644; add 2643 2645; mul 324 586; mul 536 2647; mul 305 586; mul 36 2649; mul 536 2650;
mul 594 2651; sub 2648 2652; mul 581 604; mul 583 2654; mul 544 2654; mul 333 2656; add 2655 2657; mul 585 604; mul
521 2659; mul 684 2660; mul 534 2660; mul 580 2662; add 2661 2663; mul 534 2662; mul 579 2665; add 2664 2666; mul
520 2647; mul 297 586; mul 527 2669; sub 2668 2670; mul 596 2650; add 2671 2672; mul 521 2673; mul 694 2674; mul 535
2675; add 2667 2676; mul 683 2677; sub 2658 2678; mul 521 2679; mul 643 2680; mul 641 2681; add 2653 2682; mul 280
2683; add 2646 2684; mul 164 2683; mul 165 2686; mul 246 2687; mul 164 2644; mul 309 2689; mul 204 2687; add 2690
2691; mul 258 2692; mul 297 2641; mul 301 2694; mul 184 2687; add 2695 2696; mul 235 2697; add 2693 2698; mul 224
2699; mul 164 2642; mul 319 2701; mul 224 2687; add 2702 2703; mul 244 2704; mul 255 2692; add 2705 2706; mul 231
2697; add 2707 2708; mul 204 2709; add 2700 2710; mul 204 2711; add 2688 2712; mul 269 2704; mul 248 2692; add 2714
2715; mul 187 2697; add 2716 2717; mul 185 2718; add 2713 2719; mul 252 2692; mul 226 2697; add 2721 2722; mul 224
2723; mul 252 2704; mul 231 2692; add 2725 2726; mul 206 2697; add 2727 2728; mul 204 2729; add 2724 2730; mul 184
2718; add 2731 2732; mul 774 2733; add 2720 2734; mul 796 2735; mul 795 2736; mul 246 2694; mul 298 2738; sub 2737
2739; mul 794 2740; sub 2735 2741; mul 809 2736; add 2739 2743; mul 808 2744; sub 2742 2745; mul 736 2746; mul 731
2747; mul 726 2748; sub 2685 2749; sub 2750 2683; mul 338 354; mul 315 2752; mul 320 2753; mul 324 338; mul 296
2755; mul 305 338; mul 36 2757; mul 296 2758; mul 344 2759; add 2756 2760; mul 329 416; mul 335 2762; mul 331 2762;
mul 333 2764; add 2763 2765; mul 337 416; mul 147 2767; mul 472 2768; mul 294 2768; mul 328 2770; add 2769 2771; mul
294 2770; mul 327 2773; add 2772 2774; mul 288 2755; mul 297 338; mul 155 2777; sub 2776 2778; mul 346 2758; add
2779 2780; mul 147 2781; mul 482 2782; mul 295 2783; add 2775 2784; mul 471 2785; sub 2766 2786; mul 147 2787; mul
431 2788; mul 429 2789; add 2761 2790; sub 2754 2791; mul 305 2752; mul 310 2793; add 2792 2794; mul 280 2791; add
2795 2796; mul 164 2791; mul 165 2798; mul 246 2799; mul 164 2793; mul 309 2801; mul 204 2799; add 2802 2803; mul
258 2804; mul 297 2752; mul 301 2806; mul 184 2799; add 2807 2808; mul 235 2809; add 2805 2810; mul 224 2811; mul
164 2753; mul 319 2813; mul 224 2799; add 2814 2815; mul 244 2816; mul 255 2804; add 2817 2818; mul 231 2809; add
2819 2820; mul 204 2821; add 2812 2822; mul 204 2823; add 2800 2824; mul 269 2816; mul 248 2804; add 2826 2827; mul
187 2809; add 2828 2829; mul 185 2830; add 2825 2831; mul 252 2804; mul 226 2809; add 2833 2834; mul 224 2835; mul
252 2816; mul 231 2804; add 2837 2838; mul 206 2809; add 2839 2840; mul 204 2841; add 2836 2842; mul 184 2830; add
2843 2844; mul 774 2845; add 2832 2846; mul 796 2847; mul 795 2848; mul 246 2806; mul 298 2850; sub 2849 2851; mul
794 2852; sub 2847 2853; mul 809 2848; add 2851 2855; mul 808 2856; sub 2854 2857; mul 736 2858; mul 731 2859; mul
726 2860; sub 2797 2861; le 22 124; constant 0.7745966692414834; mul 297 2864; input p 147; mul 305 2866; add 2865
2867; input p 176; mul 315 2869; add 2868 2870; lt 172 2871; and 2863 2872; constant -1.0; le 124 2874; lt 2871 172;
and 2875 2876; or 2873 2877; not 2878; input p 188; mul 315 2880; mul 96 2881; mul 305 2880; mul 140 2883; add 2882
2884; where 2879 2885; le 22 119; and 2872 2887; le 119 2874; and 2876 2889; or 2888 2890; not 2891; input p 189;
mul 315 2893; mul 96 2894; mul 305 2893; mul 140 2896; add 2895 2897; where 2892 2898; le 22 114; input p 149; mul
305 2901; input p 177; mul 315 2903; add 2902 2904; lt 172 2905; and 2900 2906; le 114 2874; lt 2905 172; and 2908
2909; or 2907 2910; not 2911; mul 106 2881; mul 133 2883; add 2913 2914; where 2912 2915; le 22 108; and 2906 2917;
le 108 2874; and 2909 2919; or 2918 2920; not 2921; mul 106 2894; mul 133 2896; add 2923 2924; where 2922 2925; le
22 101; constant -0.7745966692414834; mul 297 2928; input p 151; mul 305 2930; add 2929 2931; add 2870 2932; lt 172
2933; and 2927 2934; le 101 2874; lt 2933 172; and 2936 2937; or 2935 2938; not 2939; mul 0 2883; add 2882 2941;
where 2940 2942; le 22 2; and 2934 2944; le 2 2874; and 2937 2946; or 2945 2947; not 2948; mul 0 2896; add 2895
2950; where 2949 2951; mul 823 938; mul 185 1112; mul 229 1083; add 2954 2955; mul 947 953; add 2956 2957; input p
134; mul 238 2959; add 2958 2960; input p 135; mul 954 2962; add 2961 2963; input p 136; mul 958 2965; add 2964
2966; mul 961 2967; mul 186 1042; mul 205 971; add 2969 2970; mul 225 1117; add 2971 2972; mul 230 1098; add 2973
2974; mul 234 1087; add 2975 2976; mul 978 987; add 2977 2978; input p 141; mul 239 2980; add 2979 2981; input p
142; mul 243 2983; add 2982 2984; input p 143; mul 988 2986; add 2985 2987; input p 144; mul 961 2989; add 2988
2990; add 2968 2991; mul 309 2992; add 2953 2993; mul 93 2994; input p 152; mul 13 2996; input p 153; mul 887 2998;
add 2997 2999; input p 154; mul 891 3001; add 3000 3002; mul 828 883; add 3003 3004; mul 831 1284; add 3005 3006;
mul 835 1279; add 3007 3008; mul 839 1275; add 3009 3010; mul 843 900; add 3011 3012; mul 847 1263; add 3013 3014;
mul 830 862; add 3015 3016; mul 866 1180; add 3017 3018; mul 842 870; add 3019 3020; mul 874 1172; add 3021 3022;
mul 857 931; add 3023 3024; mul 875 930; add 3025 3026; mul 826 938; add 3027 3028; mul 185 1114; mul 229 953; add
3030 3031; mul 947 1064; add 3032 3033; input p 163; mul 238 3035; add 3034 3036; input p 164; mul 954 3038; add
3037 3039; input p 165; mul 958 3041; add 3040 3042; mul 961 3043; mul 186 1053; mul 205 1117; add 3045 3046; mul
225 977; add 3047 3048; mul 230 984; add 3049 3050; mul 234 1090; add 3051 3052; mul 978 1070; add 3053 3054; input
p 169; mul 239 3056; add 3055 3057; mul 243 2986; add 3058 3059; input p 170; mul 988 3061; add 3060 3062; input p
171; mul 961 3064; add 3063 3065; add 3044 3066; mul 186 1046; mul 205 1112; add 3068 3069; mul 225 1114; add 3070
3071; mul 230 950; add 3072 3073; mul 234 953; add 3074 3075; mul 957 978; add 3076 3077; input p 173; mul 239 3079;
add 3078 3080; mul 243 3035; add 3081 3082; mul 988 2965; add 3083 3084; input p 174; mul 961 3086; add 3085 3087;
mul 1048 3088; add 3067 3089; mul 319 3090; add 3029 3091; mul 97 3092; sub 2995 3093; mul 996 1027; sub 3094 3095;
mul 1408 3092; mul 1429 2994; sub 3097 3098; mul 996 1704; add 3099 3100; mul 1408 2994; mul 2032 3092; sub 3102
3103; mul 996 2318; sub 3104 3105; mul 1014 1029; constant 0.8; mul 97 315; mul 3108 3109; sub 3107 3110; mul 1009
1027; sub 3111 3112; input p 255; input p 256; mul 1375 1380; le 1371 1372; le 1372 1371; add 3117 3118; div 22
3119; mul 3117 3120; mul 3116 3121; mul 3115 3122; mul 3114 3123; mul 325 3124; add 3113 3125; mul 315 1408; mul
3108 3127; mul 1014 1706; add 3128 3129; mul 1009 1704; add 3130 3131; mul 1375 2014; mul 3121 3133; mul 3115 3134;
mul 3114 3135; mul 325 3136; sub 3132 3137; mul 1014 2320; mul 315 2032; mul 3108 3140; sub 3139 3141; mul 1009
2318; sub 3142 3143; mul 1375 2627; mul 3121 3145; mul 3115 3146; mul 3114 3147; mul 325 3148; add 3144 3149;
constant -2.57142857142857; mul 879 1161; mul 3151 3152; constant -0.8571428571428573; mul 875 1049; mul 3154 3155;
constant 0.9142857142857148; mul 931 1049; mul 3157 3158; add 3156 3159; constant 0.05714285714285805; mul 870 1049;
mul 3161 3162; add 3160 3163; constant -0.1142857142857146; mul 866 1049; mul 3165 3166; add 3164 3167; constant
0.2190476190476187; mul 847 1049; mul 3169 3170; add 3168 3171; constant 0.11428571428571417; mul 843 1049; mul 3173
3174; add 3172 3175; constant -0.05714285714285713; mul 835 1049; mul 3177 3178; add 3176 3179; input p 257;
constant -0.03333333333333334; mul 828 1049; mul 3182 3183; mul 3181 3184; add 3180 3185; constant
0.007256235827664402; mul 891 1049; mul 3187 3188; add 3186 3189; constant 0.019047619047619053; mul 13 1049; mul
3191 3192; mul 3181 3193; add 3190 3194; sub 3153 3195; constant 2.057142857142853; mul 875 1161; mul 3197 3198; add
3196 3199; mul 931 1161; mul 3154 3201; add 3200 3202; constant -3.428571428571426; mul 870 1161; mul 3204 3205; add
3203 3206; constant 0.1142857142857161; mul 866 1161; mul 3208 3209; add 3207 3210; constant -0.0571428571428573;
mul 858 1161; mul 3212 3213; add 3211 3214; constant -0.09999999999999992; mul 169 1161; mul 3216 3217; mul 3181
3218; add 3215 3219; constant 2.438095238095238; mul 847 1161; mul 3221 3222; add 3220 3223; constant
0.6571428571428561; mul 843 1161; mul 3225 3226; add 3224 3227; input p 258; mul 839 1161; mul 3229 3230; sub 3228
3231; mul 835 1161; mul 3173 3233; add 3232 3234; mul 828 1161; mul 96 3236; mul 3181 3237; add 3235 3238; constant
-0.019047619047619042; mul 891 1161; mul 3240 3241; add 3239 3242; mul 13 1161; mul 3182 3244; mul 3181 3245; add
3243 3246; constant 12.342857142857142; mul 879 1057; mul 3248 3249; sub 3247 3250; constant -7.71428571428571; mul
875 1057; mul 3252 3253; sub 3251 3254; mul 870 1057; mul 3197 3256; sub 3255 3257; constant -1.7142857142857146;
mul 866 1057; mul 3259 3260; sub 3258 3261; mul 858 1057; mul 3157 3263; sub 3262 3264; constant 1.1999999999999995;
mul 169 1057; mul 3266 3267; mul 3181 3268; sub 3265 3269; constant -1.1428571428571421; mul 847 1057; mul 3271
3272; sub 3270 3273; mul 843 1057; mul 3161 3275; sub 3274 3276; mul 835 1057; mul 3212 3278; sub 3277 3279; mul 828
1057; mul 3216 3281; mul 3181 3282; sub 3280 3283; mul 875 1719; mul 3154 3285; mul 931 1719; mul 3157 3287; add
3286 3288; mul 870 1719; mul 3161 3290; add 3289 3291; mul 866 1719; mul 3165 3293; add 3292 3294; mul 847 1719; mul
3169 3296; add 3295 3297; mul 843 1719; mul 3173 3299; add 3298 3300; mul 835 1719; mul 3177 3302; add 3301 3303;
mul 828 1719; mul 3182 3305; mul 3181 3306; add 3304 3307; mul 891 1719; mul 3187 3309; add 3308 3310; mul 13 1719;
mul 3191 3312; mul 3181 3313; add 3311 3314; mul 879 1845; mul 3151 3316; add 3315 3317; mul 875 1845; mul 3197
3319; add 3318 3320; mul 931 1845; mul 3154 3322; add 3321 3323; mul 870 1845; mul 3204 3325; add 3324 3326; mul 866
1845; mul 3208 3328; add 3327 3329; mul 858 1845; mul 3212 3331; add 3330 3332; mul 169 1845; mul 3216 3334; mul
3181 3335; add 3333 3336; mul 847 1845; mul 3221 3338; add 3337 3339; mul 843 1845; mul 3225 3341; add 3340 3342;
mul 839 1845; mul 3229 3344; sub 3343 3345; mul 835 1845; mul 3173 3347; add 3346 3348; mul 828 1845; mul 96 3350;
mul 3181 3351; add 3349 3352; mul 891 1845; mul 3240 3354; add 3353 3355; mul 13 1845; mul 3182 3357; mul 3181 3358;
add 3356 3359; mul 879 1729; mul 3248 3361; add 3360 3362; mul 875 1729; mul 3252 3364; add 3363 3365; mul 870 1729;
mul 3197 3367; add 3366 3368; mul 866 1729; mul 3259 3370; add 3369 3371; mul 858 1729; mul 3157 3373; add 3372
3374; mul 169 1729; mul 3266 3376; mul 3181 3377; add 3375 3378; mul 847 1729; mul 3271 3380; add 3379 3381; mul 843
1729; mul 3161 3383; add 3382 3384; mul 835 1729; mul 3212 3386; add 3385 3387; mul 828 1729; mul 3216 3389; mul
3181 3390; add 3388 3391; mul 879 2437; mul 3151 3393; mul 875 2335; mul 3154 3395; mul 931 2335; mul 3157 3397; add
3396 3398; mul 870 2335; mul 3161 3400; add 3399 3401; mul 866 2335; mul 3165 3403; add 3402 3404; mul 847 2335; mul
3169 3406; add 3405 3407; mul 843 2335; mul 3173 3409; add 3408 3410; mul 835 2335; mul 3177 3412; add 3411 3413;
mul 828 2335; mul 3182 3415; mul 3181 3416; add 3414 3417; mul 891 2335; mul 3187 3419; add 3418 3420; mul 13 2335;
mul 3191 3422; mul 3181 3423; add 3421 3424; sub 3394 3425; mul 875 2437; mul 3197 3427; add 3426 3428; mul 931
2437; mul 3154 3430; add 3429 3431; mul 870 2437; mul 3204 3433; add 3432 3434; mul 866 2437; mul 3208 3436; add
3435 3437; mul 858 2437; mul 3212 3439; add 3438 3440; mul 169 2437; mul 3216 3442; mul 3181 3443; add 3441 3444;
mul 847 2437; mul 3221 3446; add 3445 3447; mul 843 2437; mul 3225 3449; add 3448 3450; mul 839 2437; mul 3229 3452;
sub 3451 3453; mul 835 2437; mul 3173 3455; add 3454 3456; mul 828 2437; mul 96 3458; mul 3181 3459; add 3457 3460;
mul 891 2437; mul 3240 3462; add 3461 3463; mul 13 2437; mul 3182 3465; mul 3181 3466; add 3464 3467; mul 879 2342;
mul 3248 3469; sub 3468 3470; mul 875 2342; mul 3252 3472; sub 3471 3473; mul 870 2342; mul 3197 3475; sub 3474
3476; mul 866 2342; mul 3259 3478; sub 3477 3479; mul 858 2342; mul 3157 3481; sub 3480 3482; mul 169 2342; mul 3266
3484; mul 3181 3485; sub 3483 3486; mul 847 2342; mul 3271 3488; sub 3487 3489; mul 843 2342; mul 3161 3491; sub
3490 3492; mul 835 2342; mul 3212 3494; sub 3493 3495; mul 828 2342; mul 3216 3497; mul 3181 3498; sub 3496 3499;
constant -129.60000000000008; mul 3152 3501; constant 28.79999999999998; mul 3155 3503; constant 45.25714285714285;
mul 3158 3505; add 3504 3506; constant -28.80000000000001; mul 874 1049; mul 3508 3509; mul 3229 3510; add 3507
3511; constant -28.799999999999997; mul 3162 3513; add 3512 3514; constant -45.25714285714285; mul 3166 3516; add
3515 3517; constant 28.80000000000001; mul 862 1049; mul 3519 3520; mul 3229 3521; add 3518 3522; constant
7.199999999999999; mul 3170 3524; add 3523 3525; constant 13.714285714285712; mul 3174 3527; add 3526 3528; constant
-7.200000000000003; mul 839 1049; mul 3530 3531; mul 3229 3532; add 3529 3533; constant 1.3714285714285672; mul 3178
3535; add 3534 3536; constant -4.799999999999996; mul 831 1049; mul 3538 3539; mul 3229 3540; add 3537 3541;
constant 1.371428571428571; mul 3188 3543; add 3542 3544; constant -1.3714285714285719; mul 887 1049; mul 3546 3547;
mul 3229 3548; add 3545 3549; constant 2.4; mul 3192 3551; mul 3181 3552; add 3550 3553; sub 3502 3554; constant
230.40000000000006; mul 3198 3556; add 3555 3557; mul 3201 3503; add 3558 3559; constant -36.00000000000001; mul 874
1161; mul 3561 3562; mul 3229 3563; add 3560 3564; constant -151.20000000000002; mul 3205 3566; add 3565 3567;
constant -57.599999999999994; mul 3209 3569; add 3568 3570; constant 72.0; mul 862 1161; mul 3572 3573; mul 3229
3574; add 3571 3575; constant -22.628571428571426; mul 3213 3577; add 3576 3578; mul 854 1161; mul 3519 3580; mul
3229 3581; add 3579 3582; constant -18.000000000000004; mul 3217 3584; mul 3181 3585; add 3583 3586; constant
35.20000000000001; mul 3222 3588; add 3587 3589; constant 21.599999999999998; mul 3226 3591; add 3590 3592; constant
-30.000000000000007; mul 3230 3594; mul 3229 3595; add 3593 3596; mul 3233 3527; add 3597 3598; constant
-14.400000000000006; mul 831 1161; mul 3600 3601; mul 3229 3602; add 3599 3603; mul 999 3236; mul 3181 3605; add
3604 3606; constant 0.45714285714285574; mul 3241 3608; add 3607 3609; constant -2.399999999999998; mul 887 1161;
mul 3611 3612; mul 3229 3613; add 3610 3614; input p 259; constant -0.9999999999999998; mul 1161 3617; mul 3616
3618; add 3615 3619; constant 259.2000000000001; mul 3249 3621; sub 3620 3622; constant -388.80000000000024; mul
3253 3624; sub 3623 3625; mul 3256 3556; sub 3626 3627; constant 57.59999999999996; mul 3260 3629; sub 3628 3630;
constant -72.00000000000001; mul 862 1057; mul 3632 3633; mul 3229 3634; sub 3631 3635; mul 3263 3505; sub 3636
3637; constant -57.60000000000002; mul 854 1057; mul 3639 3640; mul 3229 3641; sub 3638 3642; constant
36.000000000000014; mul 3267 3644; mul 3181 3645; sub 3643 3646; constant -50.400000000000006; mul 3272 3648; sub
3647 3649; mul 3275 3513; sub 3650 3651; constant 36.0; mul 839 1057; mul 3653 3654; mul 3229 3655; sub 3652 3656;
mul 3278 3577; sub 3657 3658; mul 831 1057; mul 3519 3660; mul 3229 3661; sub 3659 3662; mul 3281 3584; mul 3181
3664; sub 3663 3665; mul 3285 3503; mul 3287 3505; add 3667 3668; mul 874 1719; mul 3508 3670; mul 3229 3671; add
3669 3672; mul 3290 3513; add 3673 3674; mul 3293 3516; add 3675 3676; mul 862 1719; mul 3519 3678; mul 3229 3679;
add 3677 3680; mul 3296 3524; add 3681 3682; mul 3299 3527; add 3683 3684; mul 839 1719; mul 3530 3686; mul 3229
3687; add 3685 3688; mul 3302 3535; add 3689 3690; mul 831 1719; mul 3538 3692; mul 3229 3693; add 3691 3694; mul
3309 3543; add 3695 3696; mul 887 1719; mul 3546 3698; mul 3229 3699; add 3697 3700; mul 3312 3551; mul 3181 3702;
add 3701 3703; mul 3316 3501; add 3704 3705; mul 3319 3556; add 3706 3707; mul 3322 3503; add 3708 3709; mul 874
1845; mul 3561 3711; mul 3229 3712; add 3710 3713; mul 3325 3566; add 3714 3715; mul 3328 3569; add 3716 3717; mul
862 1845; mul 3572 3719; mul 3229 3720; add 3718 3721; mul 3331 3577; add 3722 3723; mul 854 1845; mul 3519 3725;
mul 3229 3726; add 3724 3727; mul 3334 3584; mul 3181 3729; add 3728 3730; mul 3338 3588; add 3731 3732; mul 3341
3591; add 3733 3734; mul 3344 3594; mul 3229 3736; add 3735 3737; mul 3347 3527; add 3738 3739; mul 831 1845; mul
3600 3741; mul 3229 3742; add 3740 3743; mul 999 3350; mul 3181 3745; add 3744 3746; mul 3354 3608; add 3747 3748;
mul 887 1845; mul 3611 3750; mul 3229 3751; add 3749 3752; mul 1845 3617; mul 3616 3754; add 3753 3755; mul 3361
3621; add 3756 3757; mul 3364 3624; add 3758 3759; mul 3367 3556; add 3760 3761; mul 3370 3629; add 3762 3763; mul
862 1729; mul 3632 3765; mul 3229 3766; add 3764 3767; mul 3373 3505; add 3768 3769; mul 854 1729; mul 3639 3771;
mul 3229 3772; add 3770 3773; mul 3376 3644; mul 3181 3775; add 3774 3776; mul 3380 3648; add 3777 3778; mul 3383
3513; add 3779 3780; mul 839 1729; mul 3653 3782; mul 3229 3783; add 3781 3784; mul 3386 3577; add 3785 3786; mul
831 1729; mul 3519 3788; mul 3229 3789; add 3787 3790; mul 3389 3584; mul 3181 3792; add 3791 3793; mul 3393 3501;
mul 3395 3503; mul 3397 3505; add 3796 3797; mul 874 2335; mul 3508 3799; mul 3229 3800; add 3798 3801; mul 3400
3513; add 3802 3803; mul 3403 3516; add 3804 3805; mul 862 2335; mul 3519 3807; mul 3229 3808; add 3806 3809; mul
3406 3524; add 3810 3811; mul 3409 3527; add 3812 3813; mul 839 2335; mul 3530 3815; mul 3229 3816; add 3814 3817;
mul 3412 3535; add 3818 3819; mul 831 2335; mul 3538 3821; mul 3229 3822; add 3820 3823; mul 3419 3543; add 3824
3825; mul 887 2335; mul 3546 3827; mul 3229 3828; add 3826 3829; mul 3422 3551; mul 3181 3831; add 3830 3832; sub
3795 3833; mul 3427 3556; add 3834 3835; mul 3430 3503; add 3836 3837; mul 874 2437; mul 3561 3839; mul 3229 3840;
add 3838 3841; mul 3433 3566; add 3842 3843; mul 3436 3569; add 3844 3845; mul 862 2437; mul 3572 3847; mul 3229
3848; add 3846 3849; mul 3439 3577; add 3850 3851; mul 854 2437; mul 3519 3853; mul 3229 3854; add 3852 3855; mul
3442 3584; mul 3181 3857; add 3856 3858; mul 3446 3588; add 3859 3860; mul 3449 3591; add 3861 3862; mul 3452 3594;
mul 3229 3864; add 3863 3865; mul 3455 3527; add 3866 3867; mul 831 2437; mul 3600 3869; mul 3229 3870; add 3868
3871; mul 999 3458; mul 3181 3873; add 3872 3874; mul 3462 3608; add 3875 3876; mul 887 2437; mul 3611 3878; mul
3229 3879; add 3877 3880; mul 2437 3617; mul 3616 3882; add 3881 3883; mul 3469 3621; sub 3884 3885; mul 3472 3624;
sub 3886 3887; mul 3475 3556; sub 3888 3889; mul 3478 3629; sub 3890 3891; mul 862 2342; mul 3632 3893; mul 3229
3894; sub 3892 3895; mul 3481 3505; sub 3896 3897; mul 854 2342; mul 3639 3899; mul 3229 3900; sub 3898 3901; mul
3484 3644; mul 3181 3903; sub 3902 3904; mul 3488 3648; sub 3905 3906; mul 3491 3513; sub 3907 3908; mul 839 2342;
mul 3653 3910; mul 3229 3911; sub 3909 3912; mul 3494 3577; sub 3913 3914; mul 831 2342; mul 3519 3916; mul 3229
3917; sub 3915 3918; mul 3497 3584; mul 3181 3920; sub 3919 3921; input p 260; mul 3563 3923; mul 3510 3923; mul
3521 3923; add 3925 3926; mul 3532 3923; add 3927 3928; mul 3540 3923; add 3929 3930; input p 261; input p 262; mul
3184 3933; mul 3932 3934; add 3931 3935; mul 3548 3923; add 3936 3937; mul 3193 3933; mul 3932 3939; add 3938 3940;
mul 3552 3923; mul 3932 3942; add 3941 3943; sub 3924 3944; mul 3574 3923; add 3945 3946; mul 3581 3923; add 3947
3948; mul 3218 3933; mul 3932 3950; add 3949 3951; mul 3585 3923; mul 3932 3953; add 3952 3954; mul 3230 3933; sub
3955 3956; mul 3595 3923; add 3957 3958; mul 3602 3923; add 3959 3960; mul 3237 3933; mul 3932 3962; add 3961 3963;
mul 3605 3923; mul 3932 3965; add 3964 3966; mul 3613 3923; add 3967 3968; mul 3245 3933; mul 3932 3970; add 3969
3971; mul 3618 3923; mul 3181 3973; add 3972 3974; mul 3229 3973; mul 3932 3976; add 3975 3977; add 3618 3978; mul
3634 3923; sub 3979 3980; mul 3641 3923; sub 3981 3982; mul 3268 3933; mul 3932 3984; sub 3983 3985; mul 3645 3923;
mul 3932 3987; sub 3986 3988; mul 3655 3923; sub 3989 3990; mul 3661 3923; sub 3991 3992; mul 3282 3933; mul 3932
3994; sub 3993 3995; mul 3664 3923; mul 3932 3997; sub 3996 3998; mul 3671 3923; mul 3679 3923; add 4000 4001; mul
3687 3923; add 4002 4003; mul 3693 3923; add 4004 4005; mul 3306 3933; mul 3932 4007; add 4006 4008; mul 3699 3923;
add 4009 4010; mul 3313 3933; mul 3932 4012; add 4011 4013; mul 3702 3923; mul 3932 4015; add 4014 4016; mul 3712
3923; add 4017 4018; mul 3720 3923; add 4019 4020; mul 3726 3923; add 4021 4022; mul 3335 3933; mul 3932 4024; add
4023 4025; mul 3729 3923; mul 3932 4027; add 4026 4028; mul 3344 3933; sub 4029 4030; mul 3736 3923; add 4031 4032;
mul 3742 3923; add 4033 4034; mul 3351 3933; mul 3932 4036; add 4035 4037; mul 3745 3923; mul 3932 4039; add 4038
4040; mul 3751 3923; add 4041 4042; mul 3358 3933; mul 3932 4044; add 4043 4045; mul 3754 3923; mul 3181 4047; add
4046 4048; mul 3229 4047; mul 3932 4050; add 4049 4051; add 3754 4052; mul 3766 3923; add 4053 4054; mul 3772 3923;
add 4055 4056; mul 3377 3933; mul 3932 4058; add 4057 4059; mul 3775 3923; mul 3932 4061; add 4060 4062; mul 3783
3923; add 4063 4064; mul 3789 3923; add 4065 4066; mul 3390 3933; mul 3932 4068; add 4067 4069; mul 3792 3923; mul
3932 4071; add 4070 4072; mul 3840 3923; mul 3800 3923; mul 3808 3923; add 4075 4076; mul 3816 3923; add 4077 4078;
mul 3822 3923; add 4079 4080; mul 3416 3933; mul 3932 4082; add 4081 4083; mul 3828 3923; add 4084 4085; mul 3423
3933; mul 3932 4087; add 4086 4088; mul 3831 3923; mul 3932 4090; add 4089 4091; sub 4074 4092; mul 3848 3923; add
4093 4094; mul 3854 3923; add 4095 4096; mul 3443 3933; mul 3932 4098; add 4097 4099; mul 3857 3923; mul 3932 4101;
add 4100 4102; mul 3452 3933; sub 4103 4104; mul 3864 3923; add 4105 4106; mul 3870 3923; add 4107 4108; mul 3459
3933; mul 3932 4110; add 4109 4111; mul 3873 3923; mul 3932 4113; add 4112 4114; mul 3879 3923; add 4115 4116; mul
3466 3933; mul 3932 4118; add 4117 4119; mul 3882 3923; mul 3181 4121; add 4120 4122; mul 3229 4121; mul 3932 4124;
add 4123 4125; add 3882 4126; mul 3894 3923; sub 4127 4128; mul 3900 3923; sub 4129 4130; mul 3485 3933; mul 3932
4132; sub 4131 4133; mul 3903 3923; mul 3932 4135; sub 4134 4136; mul 3911 3923; sub 4137 4138; mul 3917 3923; sub
4139 4140; mul 3498 3933; mul 3932 4142; sub 4141 4143; mul 3920 3923; mul 3932 4145; sub 4144 4146; mul 1000 1035;
mul 1015 1027; sub 4148 4149; mul 938 1057; sub 4150 4151; mul 169 1352; add 4152 4153; input p 263; mul 3122 4155;
input p 264; constant 0.3333333333333333; mul 4156 4158; mul 4157 4159; sub 4156 4160; add 4154 4161; mul 1015 1704;
mul 1000 1712; add 4163 4164; mul 938 1729; add 4165 4166; mul 169 2007; add 4167 4168; mul 3134 4155; mul 4158
4170; mul 4157 4171; sub 4172 4170; add 4169 4173; mul 1000 2326; mul 1015 2318; sub 4175 4176; mul 938 2342; sub
4177 4178; mul 169 2620; add 4179 4180; mul 3146 4155; mul 4158 4182; mul 4157 4183; sub 4182 4184; add 4181 4185;
mul 93 1015; mul 938 1043; add 4187 4188; mul 305 1035; add 4189 4190; mul 9 1352; add 4191 4192; input p 265; mul
4161 4194; add 4193 4195; input p 266; input p 267; mul 3123 4198; mul 4197 4199; add 4196 4200; mul 305 1712; mul
1015 1429; mul 938 1725; add 4203 4204; sub 4202 4205; mul 9 2007; add 4206 4207; mul 4173 4194; add 4208 4209; mul
3135 4198; mul 4197 4211; sub 4210 4212; mul 1015 1408; mul 938 1719; add 4214 4215; mul 305 2326; add 4216 4217;
mul 9 2620; add 4218 4219; mul 4185 4194; add 4220 4221; mul 3147 4198; mul 4197 4223; add 4222 4224; mul 315 1035;
mul 97 1015; mul 938 1049; add 4227 4228; sub 4226 4229; mul 13 1352; add 4230 4231; input p 268; mul 316 4156; mul
4233 4234; sub 4232 4235; mul 315 1712; add 4216 4237; mul 13 2007; add 4238 4239; mul 316 4170; mul 4233 4241; add
4240 4242; mul 315 2326; mul 1015 2032; mul 938 2335; add 4245 4246; sub 4244 4247; mul 13 2620; add 4248 4249; mul
316 4182; mul 4233 4251; sub 4250 4252; mul 27 35; mul 36 305; mul 305 4255; mul 21 4256; mul 5 350; mul 5 93; mul
39 4259; sub 4258 4260; mul 4257 4261; mul 37 4262; mul 93 4256; mul 70 4264; sub 4263 4265; mul 50 4259; mul 5 97;
mul 16 4268; sub 4267 4269; mul 56 4258; sub 4270 4271; mul 4257 4272; mul 47 4273; sub 4266 4274; mul 9 4275; mul
4254 4276; mul 4254 4277; mul 28 4276; mul 28 4279; mul 369 4280; add 4278 4281; mul 35 36; mul 347 424; input p
145; mul 47 4285; mul 93 4286; sub 4284 4287; mul 597 636; add 4288 4289; mul 4283 4290; mul 33 4291; mul 28 28; mul
35 4290; mul 4293 4294; add 4292 4295; mul 28 47; mul 155 426; mul 150 4298; mul 36 93; mul 4285 4300; mul 288 426;
mul 148 4302; add 4301 4303; sub 4299 4304; mul 150 510; add 4305 4306; mul 296 486; mul 342 426; add 4308 4309; mul
155 369; mul 508 4311; add 4310 4312; mul 148 4313; add 4307 4314; mul 520 638; mul 515 4316; sub 4315 4317; mul 527
638; mul 518 4319; sub 4318 4320; mul 518 722; sub 4321 4322; mul 536 698; mul 592 638; add 4324 4325; mul 369 527;
mul 720 4327; add 4326 4328; mul 515 4329; add 4323 4330; mul 4297 4331; add 4296 4332; mul 28 37; mul 150 4302; mul
148 4298; add 4335 4336; mul 148 510; add 4337 4338; mul 150 4313; sub 4339 4340; mul 518 4316; sub 4341 4342; mul
515 4319; add 4343 4344; mul 515 722; add 4345 4346; mul 518 4329; add 4347 4348; mul 4334 4349; add 4333 4350; mul
27 369; div 22 4352; mul 4351 4353; mul 9 4354; mul 9 4355; sub 4282 4356; mul 28 4349; mul 27 4291; sub 4358 4359;
mul 33 369; div 22 4361; mul 4360 4362; mul 9 4363; mul 9 4364; add 4357 4365; input p 131; mul 28 4367; mul 28
4368; mul 29 4254; mul 4254 4370; add 4369 4371; mul 9 4372; mul 4262 4373; mul 819 3092; mul 322 610; sub 4375
4376; input p 175; mul 315 4378; mul 826 1015; add 4379 4380; add 4377 4381; mul 125 2869; mul 120 2869; add 4383
4384; mul 115 2903; add 4385 4386; mul 109 2903; add 4387 4388; mul 102 2869; add 4389 4390; mul 3 2869; add 4391
4392; add 4382 4393; mul 51 297; mul 40 305; add 4395 4396; mul 7 315; add 4397 4398; mul 297 4399; mul 40 297; mul
42 305; add 4401 4402; mul 10 315; add 4403 4404; mul 305 4405; add 4400 4406; mul 7 297; mul 10 305; add 4408 4409;
mul 14 315; add 4410 4411; mul 315 4412; add 4407 4413; mul 47 4373; sub 38 4415; mul 4257 4416; add 4414 4417; mul
16 4418; mul 5 4419; add 4394 4420; mul 92 97; mul 4421 4422; mul 819 2994; mul 312 610; sub 4424 4425; mul 823
1015; add 4426 4427; mul 598 606; mul 348 418; add 4429 4430; add 4428 4431; sub 1377 4432; mul 36 4286; add 4433
4434; input p 120; input z 0; mul 4436 4437; input p 146; mul 4438 4439; input p 121; input z 1; mul 4441 4442; mul
4439 4443; add 4440 4444; input p 122; input z 2; mul 4446 4447; mul 4439 4448; add 4445 4449; input p 123; input z
3; mul 4451 4452; mul 4439 4453; add 4450 4454; mul 125 2866; add 4455 4456; mul 120 2866; add 4457 4458; mul 115
2901; add 4459 4460; mul 109 2901; add 4461 4462; mul 102 2930; add 4463 4464; mul 3 2930; add 4465 4466; sub 4435
4467; mul 50 4418; mul 37 4373; add 48 4470; mul 4257 4471; mul 39 4472; sub 4469 4473; mul 5 4474; mul 70 4373; mul
4256 4476; sub 4475 4477; sub 4468 4478; mul 92 93; mul 4479 4480; add 4423 4481; input c 0; input c 2; mul 555
4484; add 4483 4485; input c 3; mul 387 4487; add 4486 4488; mul 1361 1395; add 4489 4490; mul 1359 1377; sub 4491
4492; input p 16; input c 1; add 4494 4495; max 4496 172; mul 297 4497; sub 4493 4498; mul 303 610; sub 1019 4500;
mul 600 606; mul 351 418; add 4502 4503; sub 4501 4504; sub 4499 4505; input p 119; add 4438 4443; add 4448 4508;
add 4453 4509; mul 125 2864; add 4510 4511; mul 120 2864; add 4512 4513; mul 102 2928; add 4514 4515; mul 3 2928;
add 4516 4517; sub 4507 4518; input p 126; abs 297; mul 4520 4521; mul 297 4522; input p 127; mul 297 4524; mul 297
297; input p 128; add 4526 4527; sqrt 4528; div 22 4529; mul 4525 4530; add 4523 4531; sub 4519 4532; add 4506 4533;
input p 129; input x 12; sub 6 4536; mul 4535 4537; input p 130; input x 13; sub 6 4540; mul 4539 4541; add 4538
4542; sub 4534 4543; mul 56 4418; sub 4545 4472; mul 5 4546; sub 4544 4547; mul 92 350; mul 4548 4549; sub 4482
4550; mul 65 4551; mul 63 4552; mul 60 4551; mul 19 4554; sub 4553 4555; mul 5 4556; mul 4259 4472; sub 4557 4558;
mul 92 4421; mul 63 4560; mul 92 4479; mul 19 4562; add 4561 4563; mul 67 4551; add 4564 4565; mul 5 4566; sub 4559
4567; mul 39 369; mul 65 4560; mul 65 4552; sub 4570 4571; mul 83 4551; mul 19 4573; add 4572 4574; mul 92 4548; mul
19 4576; add 4575 4577; mul 5 4578; mul 4569 4579; add 4568 4580; mul 21 4581; add 4273 4582; mul 36 4583; add 4374
4584; mul 28 4585; mul 35 4254; mul 4276 4370; mul 29 4277; add 4588 4589; mul 4587 4590; mul 4261 4471; mul 21
4592; mul 93 4476; sub 4593 4594; mul 4272 4416; mul 21 4596; add 4595 4597; mul 305 4598; mul 305 4599; mul 4259
4418; mul 56 4557; add 4601 4602; mul 56 4567; sub 4603 4604; mul 65 4562; mul 60 4552; add 4606 4607; mul 63 4573;
sub 4608 4609; mul 63 4576; sub 4610 4611; mul 5 4612; mul 16 4613; add 4605 4614; mul 65 4554; mul 60 4560; sub
4616 4617; sub 4618 4609; sub 4619 4611; mul 5 4620; mul 16 4621; add 4615 4622; mul 50 369; mul 4579 4624; add 4623
4625; mul 21 4626; add 4262 4627; mul 47 4628; add 4600 4629; mul 37 4583; add 4630 4631; mul 70 4578; add 4632
4633; mul 36 4578; mul 4264 4373; sub 4635 4636; mul 69 4637; add 4634 4638; mul 4283 4639; add 4591 4640; mul 27
4641; sub 4586 4642; mul 4362 4643; mul 9 4644; mul 9 4645; add 4366 4646; mul 35 4590; mul 28 4369; mul 4276 4649;
sub 4648 4650; mul 4279 4369; sub 4651 4652; mul 36 4628; mul 4273 4373; sub 4654 4655; mul 4297 4656; sub 4653
4657; mul 4334 4585; sub 4658 4659; mul 33 4641; sub 4660 4661; mul 35 4639; mul 4293 4663; sub 4662 4664; mul 4353
4665; mul 9 4666; mul 9 4667; add 4647 4668; mul 1429 4256; mul 70 4670; mul 5 1429; mul 39 4672; sub 4673 4259; mul
4257 4674; mul 37 4675; add 4671 4676; mul 5 1408; mul 16 4678; mul 50 4672; sub 4679 4680; mul 56 4259; add 4681
4682; mul 4257 4683; mul 47 4684; sub 4677 4685; mul 9 4686; mul 4254 4687; mul 4254 4688; mul 28 4687; mul 28 4690;
mul 369 4691; add 4689 4692; mul 1429 4286; mul 347 1506; sub 4694 4695; mul 597 1556; sub 4696 4697; mul 4283 4698;
mul 33 4699; mul 35 4698; mul 4293 4701; add 4700 4702; mul 36 1429; mul 4285 4704; mul 288 1530; mul 148 4706; add
4705 4707; mul 155 1530; mul 150 4709; sub 4708 4710; mul 150 1533; add 4711 4712; mul 296 1497; mul 342 1530; sub
4714 4715; mul 1527 4311; add 4716 4717; mul 148 4718; add 4713 4719; mul 520 1558; mul 515 4721; add 4720 4722; mul
527 1558; mul 518 4724; add 4723 4725; mul 518 1628; sub 4726 4727; mul 536 1603; mul 592 1558; sub 4729 4730; mul
1626 4327; add 4731 4732; mul 515 4733; add 4728 4734; mul 4297 4735; add 4703 4736; mul 148 1533; mul 150 4706; mul
148 4709; add 4739 4740; sub 4738 4741; mul 150 4718; sub 4742 4743; mul 518 4721; add 4744 4745; mul 515 4724; sub
4746 4747; mul 515 1628; add 4748 4749; mul 518 4733; add 4750 4751; mul 4334 4752; add 4737 4753; mul 4353 4754;
mul 9 4755; mul 9 4756; sub 4693 4757; mul 28 4752; mul 27 4699; sub 4759 4760; mul 4362 4761; mul 9 4762; mul 9
4763; add 4758 4764; mul 4373 4675; mul 4472 4672; mul 4480 4548; mul 92 1408; mul 4421 4769; sub 4768 4770; mul 92
1429; mul 4479 4772; sub 4771 4773; mul 65 4774; mul 63 4775; add 4570 4577; sub 4776 4777; mul 60 4774; mul 19
4779; sub 4778 4780; mul 5 4781; add 4767 4782; mul 67 4774; mul 5 4784; sub 4783 4785; mul 83 4774; mul 19 4787;
mul 65 4775; sub 4788 4789; mul 5 4790; mul 4569 4791; add 4786 4792; mul 21 4793; add 4684 4794; mul 36 4795; add
4766 4796; mul 28 4797; mul 4370 4687; mul 29 4688; add 4799 4800; mul 4587 4801; mul 1429 4476; mul 4471 4674; mul
21 4804; add 4803 4805; mul 4416 4683; mul 21 4807; add 4806 4808; mul 305 4809; mul 305 4810; mul 56 4782; mul 4418
4672; sub 4812 4813; mul 56 4785; sub 4814 4815; mul 60 4775; mul 63 4787; sub 4817 4818; mul 5 4819; mul 16 4820;
add 4816 4821; mul 83 4560; mul 65 4576; add 4823 4824; mul 65 4779; add 4825 4826; sub 4827 4818; mul 5 4828; mul
16 4829; add 4822 4830; mul 4624 4791; add 4831 4832; mul 21 4833; add 4675 4834; mul 47 4835; add 4811 4836; mul 37
4795; add 4837 4838; mul 70 4790; add 4839 4840; mul 4373 4670; mul 36 4790; add 4842 4843; mul 69 4844; add 4841
4845; mul 4283 4846; add 4802 4847; mul 27 4848; sub 4798 4849; mul 4362 4850; mul 9 4851; mul 9 4852; add 4765
4853; mul 35 4801; mul 4649 4687; sub 4855 4856; mul 4369 4690; sub 4857 4858; mul 36 4835; mul 4373 4684; sub 4860
4861; mul 4297 4862; sub 4859 4863; mul 4334 4797; sub 4864 4865; mul 33 4848; sub 4866 4867; mul 35 4846; mul 4293
4869; sub 4868 4870; mul 4353 4871; mul 9 4872; mul 9 4873; add 4854 4874; mul 39 4678; sub 4268 4876; mul 4257
4877; mul 37 4878; mul 1408 4256; mul 70 4880; sub 4879 4881; mul 50 4678; mul 5 2032; mul 16 4884; sub 4883 4885;
mul 56 4268; sub 4886 4887; mul 4257 4888; mul 47 4889; sub 4882 4890; mul 9 4891; mul 4254 4892; mul 4254 4893; mul
28 4892; mul 28 4895; mul 369 4896; add 4894 4897; mul 347 2078; mul 1408 4286; sub 4899 4900; mul 597 2173; add
4901 4902; mul 4283 4903; mul 33 4904; mul 35 4903; mul 4293 4906; add 4905 4907; mul 155 2080; mul 150 4909; mul 36
1408; mul 4285 4911; mul 288 2080; mul 148 4913; add 4912 4914; sub 4910 4915; mul 150 2147; add 4916 4917; mul 296
2123; mul 342 2080; add 4919 4920; mul 2145 4311; add 4921 4922; mul 148 4923; add 4918 4924; mul 520 2175; mul 515
4926; sub 4925 4927; mul 527 2175; mul 518 4929; sub 4928 4930; mul 518 2242; sub 4931 4932; mul 536 2218; mul 592
2175; add 4934 4935; mul 2240 4327; add 4936 4937; mul 515 4938; add 4933 4939; mul 4297 4940; add 4908 4941; mul
150 4913; mul 148 4909; add 4943 4944; mul 148 2147; add 4945 4946; mul 150 4923; sub 4947 4948; mul 518 4926; sub
4949 4950; mul 515 4929; add 4951 4952; mul 515 2242; add 4953 4954; mul 518 4938; add 4955 4956; mul 4334 4957; add
4942 4958; mul 4353 4959; mul 9 4960; mul 9 4961; sub 4898 4962; mul 28 4957; mul 27 4904; sub 4964 4965; mul 4362
4966; mul 9 4967; mul 9 4968; add 4963 4969; mul 4373 4878; add 4611 4617; mul 92 2032; mul 4421 4973; mul 4479
4769; add 4974 4975; mul 4422 4548; sub 4976 4977; mul 65 4978; mul 63 4979; add 4972 4980; mul 60 4978; mul 19
4982; sub 4981 4983; mul 5 4984; mul 4472 4678; sub 4985 4986; add 4606 4617; mul 67 4978; sub 4988 4989; mul 5
4990; add 4987 4991; mul 83 4978; mul 19 4993; mul 65 4979; add 4825 4995; sub 4994 4996; mul 5 4997; mul 4569 4998;
add 4992 4999; mul 21 5000; add 4889 5001; mul 36 5002; add 4971 5003; mul 28 5004; mul 4370 4892; mul 29 4893; add
5006 5007; mul 4587 5008; mul 4471 4877; mul 21 5010; mul 1408 4476; sub 5011 5012; mul 4416 4888; mul 21 5014; add
5013 5015; mul 305 5016; mul 305 5017; mul 4418 4678; mul 56 4985; add 5019 5020; mul 56 4991; add 5021 5022; mul 60
4576; mul 83 4562; sub 5024 5025; mul 60 4979; add 5026 5027; mul 63 4993; sub 5028 5029; mul 5 5030; mul 16 5031;
add 5023 5032; mul 65 4982; sub 5034 5029; mul 5 5035; mul 16 5036; add 5033 5037; mul 4624 4998; add 5038 5039; mul
21 5040; add 4878 5041; mul 47 5042; add 5018 5043; mul 37 5002; add 5044 5045; mul 70 4997; add 5046 5047; mul 36
4997; mul 4373 4880; sub 5049 5050; mul 69 5051; add 5048 5052; mul 4283 5053; add 5009 5054; mul 27 5055; sub 5005
5056; mul 4362 5057; mul 9 5058; mul 9 5059; add 4970 5060; mul 35 5008; mul 4649 4892; sub 5062 5063; mul 4369
4895; sub 5064 5065; mul 36 5042; mul 4373 4889; sub 5067 5068; mul 4297 5069; sub 5066 5070; mul 4334 5004; sub
5071 5072; mul 33 5055; sub 5073 5074; mul 35 5053; mul 4293 5076; sub 5075 5077; mul 4353 5078; mul 9 5079; mul 9
5080; add 5061 5081; mul 527 2651; mul 515 5083; mul 520 2651; mul 518 5085; sub 5084 5086; mul 515 2683; add 5087
5088; mul 592 2651; mul 536 2669; sub 5090 5091; mul 2681 4327; add 5092 5093; mul 518 5094; add 5089 5095; mul 28
5096; mul 597 2649; mul 4283 5098; mul 27 5099; sub 5097 5100; mul 4362 5101; mul 9 5102; mul 9 5103; mul 33 5099;
mul 35 5098; mul 4293 5106; add 5105 5107; mul 515 5094; mul 515 5085; mul 518 5083; add 5110 5111; mul 518 2683;
add 5112 5113; sub 5109 5114; mul 4297 5115; add 5108 5116; mul 4334 5096; add 5117 5118; mul 4353 5119; mul 9 5120;
mul 9 5121; sub 5104 5122; mul 288 2759; mul 150 5124; mul 155 2759; mul 148 5126; add 5125 5127; mul 148 2791; add
5128 5129; mul 342 2759; mul 296 2777; sub 5131 5132; mul 2789 4311; add 5133 5134; mul 150 5135; sub 5130 5136; mul
28 5137; mul 347 2757; mul 4283 5139; mul 27 5140; sub 5138 5141; mul 4362 5142; mul 9 5143; mul 9 5144; mul 33
5140; mul 35 5139; mul 4293 5147; add 5146 5148; mul 150 5126; mul 148 5124; sub 5150 5151; mul 150 2791; add 5152
5153; mul 148 5135; add 5154 5155; mul 4297 5156; add 5149 5157; mul 4334 5137; add 5158 5159; mul 4353 5160; mul 9
5161; mul 9 5162; sub 5145 5163; mul 186 1058; mul 1012 5165; neg 5166; mul 186 1730; mul 1012 5168; mul 186 2343;
mul 1012 5170; neg 5171; mul 186 1044; mul 205 1058; mul 1047 5174; sub 5173 5175; mul 205 1730; mul 1047 5177; mul
186 1726; sub 5178 5179; mul 186 2333; mul 205 2343; mul 1047 5182; sub 5181 5183; mul 186 1050; mul 225 1058; mul
1047 5186; add 5185 5187; neg 5188; mul 186 1720; mul 225 1730; mul 1047 5191; add 5190 5192; mul 186 2336; mul 225
2343; mul 1047 5195; add 5194 5196; neg 5197; mul 205 1044; mul 369 5199; mul 230 1058; neg 5201; mul 369 5202; add
5200 5203; mul 205 1726; neg 5205; mul 369 5206; mul 230 1730; mul 369 5208; add 5207 5209; mul 205 2333; mul 369
5211; mul 230 2343; neg 5213; mul 369 5214; add 5212 5215; mul 225 1044; mul 205 1050; sub 5217 5218; mul 234 1058;
neg 5220; mul 369 5221; add 5219 5222; mul 205 1720; mul 225 1726; sub 5224 5225; mul 234 1730; mul 369 5227; add
5226 5228; mul 225 2333; mul 205 2336; sub 5230 5231; mul 234 2343; neg 5233; mul 369 5234; add 5232 5235; mul 225
1050; neg 5237; mul 369 5238; mul 978 1058; neg 5240; mul 369 5241; add 5239 5242; mul 225 1720; mul 369 5244; mul
978 1730; mul 369 5246; add 5245 5247; mul 225 2336; neg 5249; mul 369 5250; mul 978 2343; neg 5252; mul 369 5253;
add 5251 5254; mul 230 1044; mul 1047 5256; mul 239 1058; sub 5257 5258; mul 239 1730; mul 230 1726; mul 1047 5261;
sub 5260 5262; mul 230 2333; mul 1047 5264; mul 239 2343; sub 5265 5266; mul 234 1044; mul 369 5268; mul 230 1050;
sub 5269 5270; mul 243 1058; sub 5271 5272; mul 230 1720; mul 234 1726; neg 5275; mul 369 5276; add 5274 5277; mul
243 1730; add 5278 5279; mul 234 2333; mul 369 5281; mul 230 2336; sub 5282 5283; mul 243 2343; sub 5284 5285; mul
234 1050; neg 5287; mul 369 5288; mul 978 1044; add 5289 5290; mul 988 1058; sub 5291 5292; mul 234 1720; mul 369
5294; mul 978 1726; sub 5295 5296; mul 988 1730; add 5297 5298; mul 234 2336; neg 5300; mul 369 5301; mul 978 2333;
add 5302 5303; mul 988 2343; sub 5304 5305; mul 978 1050; mul 1047 5307; add 1078 5308; neg 5309; mul 978 1720; mul
1047 5311; add 1748 5312; mul 978 2336; mul 1047 5314; add 2361 5315; neg 5316; mul 239 1044; mul 1012 5318; mul 239
1726; mul 1012 5320; neg 5321; mul 239 2333; mul 1012 5323; mul 243 1044; mul 1047 5325; mul 239 1050; sub 5326
5327; mul 239 1720; mul 243 1726; mul 1047 5330; sub 5329 5331; mul 243 2333; mul 1047 5333; mul 239 2336; sub 5334
5335; mul 243 1050; neg 5337; mul 369 5338; mul 988 1044; mul 369 5340; add 5339 5341; mul 243 1720; mul 369 5343;
mul 988 1726; neg 5345; mul 369 5346; add 5344 5347; mul 243 2336; neg 5349; mul 369 5350; mul 988 2333; mul 369
5352; add 5351 5353; mul 988 1050; mul 1047 5355; sub 1062 5356; mul 988 1720; mul 1047 5358; sub 5359 1736; mul 988
2336; mul 1047 5361; sub 2347 5362; mul 1012 1065; neg 5364; mul 1012 1734; mul 1012 2349; neg 5367; mul 186 1051;
mul 185 1078; mul 1047 5370; add 5369 5371; neg 5372; mul 186 1721; mul 185 1748; mul 1047 5375; add 5374 5376; mul
186 2337; mul 185 2361; mul 1047 5379; add 5378 5380; neg 5381; mul 185 1062; mul 205 1051; sub 5383 5384; mul 229
1078; neg 5386; mul 369 5387; add 5385 5388; mul 205 1721; mul 185 1736; sub 5390 5391; mul 229 1748; mul 369 5393;
add 5392 5394; mul 185 2347; mul 205 2337; sub 5396 5397; mul 229 2361; neg 5399; mul 369 5400; add 5398 5401; mul
947 1078; neg 5403; mul 369 5404; mul 225 1051; mul 185 1065; add 5406 5407; sub 5405 5408; mul 225 1721; mul 185
1734; add 5410 5411; mul 947 1748; mul 369 5413; add 5412 5414; mul 947 2361; neg 5416; mul 369 5417; mul 225 2337;
mul 185 2349; add 5419 5420; sub 5418 5421; mul 229 1062; mul 369 5423; mul 230 1051; sub 5424 5425; mul 238 1078;
sub 5426 5427; mul 230 1721; mul 229 1736; neg 5430; mul 369 5431; add 5429 5432; mul 238 1748; add 5433 5434; mul
229 2347; mul 369 5436; mul 230 2337; sub 5437 5438; mul 238 2361; sub 5439 5440; mul 947 1062; mul 234 1051; mul
229 1065; add 5443 5444; sub 5442 5445; mul 954 1078; sub 5446 5447; mul 234 1721; mul 229 1734; add 5449 5450; mul
947 1736; sub 5451 5452; mul 954 1748; add 5453 5454; mul 947 2347; mul 234 2337; mul 229 2349; add 5457 5458; sub
5456 5459; mul 954 2361; sub 5460 5461; mul 947 1065; neg 5463; mul 369 5464; mul 978 1051; sub 5465 5466; mul 958
1078; sub 5467 5468; mul 978 1721; mul 947 1734; mul 369 5471; add 5470 5472; mul 958 1748; add 5473 5474; mul 947
2349; neg 5476; mul 369 5477; mul 978 2337; sub 5478 5479; mul 958 2361; sub 5480 5481; mul 238 1062; mul 1047 5483;
mul 239 1051; sub 5484 5485; mul 239 1721; mul 238 1736; mul 1047 5488; sub 5487 5489; mul 238 2347; mul 1047 5491;
mul 239 2337; sub 5492 5493; mul 954 1062; mul 369 5495; mul 243 1051; mul 238 1065; add 5497 5498; sub 5496 5499;
mul 243 1721; mul 238 1734; add 5501 5502; mul 954 1736; neg 5504; mul 369 5505; add 5503 5506; mul 954 2347; mul
369 5508; mul 243 2337; mul 238 2349; add 5510 5511; sub 5509 5512; mul 954 1065; neg 5514; mul 369 5515; mul 988
1051; sub 5516 5517; mul 958 1062; add 5518 5519; mul 988 1721; mul 954 1734; mul 369 5522; add 5521 5523; mul 958
1736; sub 5524 5525; mul 954 2349; neg 5527; mul 369 5528; mul 988 2337; sub 5529 5530; mul 958 2347; add 5531 5532;
mul 961 1051; mul 958 1065; mul 1047 5535; add 5534 5536; neg 5537; mul 961 1721; mul 958 1734; mul 1047 5540; add
5539 5541; mul 961 2337; mul 958 2349; mul 1047 5544; add 5543 5545; neg 5546; mul 186 750; mul 1012 5548; mul 186
1644; mul 1012 5550; mul 186 2258; mul 1012 5552; mul 186 2697; mul 1012 5554; mul 186 2809; mul 1012 5556; mul 186
743; mul 205 750; mul 1047 5559; add 5558 5560; mul 186 1638; mul 205 1644; mul 1047 5563; add 5562 5564; mul 186
2252; mul 205 2258; mul 1047 5567; add 5566 5568; mul 186 2692; mul 205 2697; mul 1047 5571; add 5570 5572; mul 186
2804; mul 205 2809; mul 1047 5575; add 5574 5576; mul 186 757; mul 225 750; mul 1047 5579; add 5578 5580; mul 186
1651; mul 225 1644; mul 1047 5583; add 5582 5584; mul 186 2265; mul 225 2258; mul 1047 5587; add 5586 5588; mul 186
2704; mul 225 2697; mul 1047 5591; add 5590 5592; mul 186 2816; mul 225 2809; mul 1047 5595; add 5594 5596; mul 205
743; mul 369 5598; mul 230 750; mul 369 5600; add 5599 5601; mul 205 1638; mul 369 5603; mul 230 1644; mul 369 5605;
add 5604 5606; mul 205 2252; mul 369 5608; mul 230 2258; mul 369 5610; add 5609 5611; mul 205 2692; mul 369 5613;
mul 230 2697; mul 369 5615; add 5614 5616; mul 205 2804; mul 369 5618; mul 230 2809; mul 369 5620; add 5619 5621;
mul 205 757; mul 225 743; add 5623 5624; mul 234 750; mul 369 5626; add 5625 5627; mul 205 1651; mul 225 1638; add
5629 5630; mul 234 1644; mul 369 5632; add 5631 5633; mul 205 2265; mul 225 2252; add 5635 5636; mul 234 2258; mul
369 5638; add 5637 5639; mul 205 2704; mul 225 2692; add 5641 5642; mul 234 2697; mul 369 5644; add 5643 5645; mul
205 2816; mul 225 2804; add 5647 5648; mul 234 2809; mul 369 5650; add 5649 5651; mul 230 743; mul 1047 5653; mul
239 750; add 5654 5655; mul 230 1638; mul 1047 5657; mul 239 1644; add 5658 5659; mul 230 2252; mul 1047 5661; mul
239 2258; add 5662 5663; mul 230 2692; mul 1047 5665; mul 239 2697; add 5666 5667; mul 230 2804; mul 1047 5669; mul
239 2809; add 5670 5671; mul 230 757; mul 234 743; mul 369 5674; add 5673 5675; mul 243 750; add 5676 5677; mul 230
1651; mul 234 1638; mul 369 5680; add 5679 5681; mul 243 1644; add 5682 5683; mul 230 2265; mul 234 2252; mul 369
5686; add 5685 5687; mul 243 2258; add 5688 5689; mul 230 2704; mul 234 2692; mul 369 5692; add 5691 5693; mul 243
2697; add 5694 5695; mul 230 2816; mul 234 2804; mul 369 5698; add 5697 5699; mul 243 2809; add 5700 5701; mul 239
743; mul 1012 5703; mul 239 1638; mul 1012 5705; mul 239 2252; mul 1012 5707; mul 239 2692; mul 1012 5709; mul 239
2804; mul 1012 5711; mul 239 757; mul 243 743; mul 1047 5714; add 5713 5715; mul 239 1651; mul 243 1638; mul 1047
5718; add 5717 5719; mul 239 2265; mul 243 2252; mul 1047 5722; add 5721 5723; mul 239 2704; mul 243 2692; mul 1047
5726; add 5725 5727; mul 239 2816; mul 243 2804; mul 1047 5730; add 5729 5731; mul 93 4474; mul 97 4419; sub 5733
5734; mul 350 4546; sub 5735 5736; mul 77 4560; mul 63 4562; add 5738 5739; mul 89 4551; add 5740 5741; mul 64 5742;
add 5737 5743; mul 63 4554; mul 77 4552; sub 5745 5746; mul 64 5747; add 5744 5748; mul 58 4556; add 5749 5750; mul
58 4566; sub 5751 5752; mul 80 4551; mul 82 5754; add 5753 5755; mul 62 4612; add 5756 5757; mul 62 4620; add 5758
5759; mul 77 4573; mul 60 4562; mul 60 4554; add 5762 5763; sub 5761 5764; mul 77 4576; add 5765 5766; mul 17 5767;
add 5760 5768; mul 75 4578; add 5769 5770; mul 1408 4419; mul 1429 4474; sub 5772 5773; mul 93 4546; add 5774 5775;
mul 89 4774; sub 5777 4988; mul 64 5778; add 5776 5779; sub 4611 4606; mul 77 4775; sub 5781 5782; mul 63 4779; add
5783 5784; mul 64 5785; add 5780 5786; mul 58 4781; add 5787 5788; mul 58 4784; sub 5789 5790; mul 80 4774; add 4564
5792; mul 82 5793; add 5791 5794; mul 62 4819; add 5795 5796; mul 62 4828; add 5797 5798; sub 5025 5024; mul 60
4779; sub 5800 5801; mul 77 4787; add 5802 5803; mul 17 5804; add 5799 5805; mul 75 4790; add 5806 5807; mul 1408
4474; mul 2032 4419; sub 5809 5810; mul 97 4546; sub 5811 5812; mul 89 4978; mul 64 5814; add 5813 5815; sub 5762
5766; mul 77 4979; sub 5817 5818; mul 63 4982; add 5819 5820; mul 64 5821; add 5816 5822; mul 58 4984; add 5823
5824; mul 58 4990; add 5825 5826; mul 80 4978; sub 5828 5740; mul 82 5829; add 5827 5830; mul 62 5030; add 5831
5832; mul 62 5035; add 5833 5834; mul 77 4993; mul 60 4982; sub 5836 5837; mul 17 5838; add 5835 5839; mul 75 4997;
add 5840 5841; sub 4556 4566; sub 4781 4784; add 4984 4990; mul 36 4637; mul 36 4844; mul 36 5051; mul 297 4272; mul
297 5849; mul 157 723; mul 6 5851; add 747 5852; mul 6 5853; add 5850 5854; mul 5 5742; mul 16 5856; mul 4258 4418;
sub 5857 5858; mul 5 5747; mul 16 5860; add 5859 5861; mul 50 4557; add 5862 5863; mul 50 4567; sub 5864 5865; mul
56 369; mul 5 5754; mul 5867 5868; add 5866 5869; mul 6 5870; add 5855 5871; mul 297 4683; mul 297 5873; mul 157
1629; mul 6 5875; sub 5876 1642; mul 6 5877; add 5874 5878; mul 5 5778; mul 16 5880; add 4601 5881; mul 5 5785; mul
16 5883; add 5882 5884; mul 50 4782; add 5885 5886; mul 50 4785; sub 5887 5888; mul 5 5793; mul 5867 5890; add 5889
5891; mul 6 5892; add 5879 5893; mul 297 4888; mul 297 5895; mul 157 2243; mul 6 5897; add 2255 5898; mul 6 5899;
add 5896 5900; mul 5 5814; mul 16 5902; mul 4268 4418; sub 5903 5904; mul 5 5821; mul 16 5906; add 5905 5907; mul 50
4985; add 5908 5909; mul 50 4991; add 5910 5911; mul 5 5829; mul 5867 5913; add 5912 5914; mul 6 5915; add 5901
5916; mul 157 2683; mul 6 5918; add 2694 5919; mul 6 5920; mul 157 2791; mul 6 5922; add 2806 5923; mul 6 5924; mul
305 4272; mul 297 5926; mul 305 5849; add 5927 5928; mul 9 5851; add 627 5930; mul 6 5931; add 5929 5932; mul 9
5853; add 5933 5934; mul 9 5870; add 5935 5936; mul 6 4626; add 5937 5938; mul 305 4683; mul 297 5940; mul 305 5873;
add 5941 5942; mul 9 5875; add 1551 5944; mul 6 5945; add 5943 5946; mul 9 5877; add 5947 5948; mul 9 5892; add 5949
5950; mul 6 4833; add 5951 5952; mul 305 4888; mul 297 5954; mul 305 5895; add 5955 5956; mul 9 5897; add 2164 5958;
mul 6 5959; add 5957 5960; mul 9 5899; add 5961 5962; mul 9 5915; add 5963 5964; mul 6 5040; add 5965 5966; mul 9
5918; add 2644 5968; mul 6 5969; mul 9 5920; add 5970 5971; mul 9 5922; add 2793 5973; mul 6 5974; mul 9 5924; add
5975 5976; mul 305 5926; mul 9 5931; add 5978 5979; mul 9 4626; add 5980 5981; mul 305 5940; mul 9 5945; add 5983
5984; mul 9 4833; add 5985 5986; mul 305 5954; mul 9 5959; add 5988 5989; mul 9 5040; add 5990 5991; mul 9 5969; mul
9 5974; mul 315 4272; mul 297 5995; mul 315 5849; add 5996 5997; mul 13 5851; add 622 5999; mul 6 6000; add 5998
6001; mul 13 5853; add 6002 6003; mul 13 5870; add 6004 6005; mul 56 5856; sub 6007 5904; mul 56 5860; add 6008
6009; mul 50 4613; add 6010 6011; mul 50 4621; add 6012 6013; mul 16 369; mul 5 5767; mul 6015 6016; add 6014 6017;
mul 6 6018; add 6006 6019; mul 315 4683; mul 297 6021; mul 315 5873; add 6022 6023; mul 13 5875; sub 6025 1546; mul
6 6026; add 6024 6027; mul 13 5877; add 6028 6029; mul 13 5892; add 6030 6031; mul 56 5880; add 5019 6033; mul 56
5883; add 6034 6035; mul 50 4820; add 6036 6037; mul 50 4829; add 6038 6039; mul 5 5804; mul 6015 6041; add 6040
6042; mul 6 6043; add 6032 6044; mul 315 4888; mul 297 6046; mul 315 5895; add 6047 6048; mul 13 5897; add 2160
6050; mul 6 6051; add 6049 6052; mul 13 5899; add 6053 6054; mul 13 5915; add 6055 6056; mul 56 5902; mul 4418 4884;
sub 6058 6059; mul 56 5906; add 6060 6061; mul 50 5031; add 6062 6063; mul 50 5036; add 6064 6065; mul 5 5838; mul
6015 6067; add 6066 6068; mul 6 6069; add 6057 6070; mul 13 5918; add 2642 6072; mul 6 6073; mul 13 5920; add 6074
6075; mul 13 5922; add 2753 6077; mul 6 6078; mul 13 5924; add 6079 6080; mul 305 5995; mul 315 5926; add 6082 6083;
mul 9 6000; add 6084 6085; mul 13 5931; add 6086 6087; mul 9 6018; add 6088 6089; mul 13 4626; add 6090 6091; mul
305 6021; mul 315 5940; add 6093 6094; mul 9 6026; add 6095 6096; mul 13 5945; add 6097 6098; mul 9 6043; add 6099
6100; mul 13 4833; add 6101 6102; mul 305 6046; mul 315 5954; add 6104 6105; mul 9 6051; add 6106 6107; mul 13 5959;
add 6108 6109; mul 9 6069; add 6110 6111; mul 13 5040; add 6112 6113; mul 9 6073; mul 13 5969; add 6115 6116; mul 9
6078; mul 13 5974; add 6118 6119; mul 315 5995; mul 13 6000; add 6121 6122; mul 13 6018; add 6123 6124; mul 315
6021; mul 13 6026; add 6126 6127; mul 13 6043; add 6128 6129; mul 315 6046; mul 13 6051; add 6131 6132; mul 13 6069;
add 6133 6134; mul 13 6073; mul 13 6078; mul 47 4300; mul 21 6138; sub 359 6139; mul 47 4704; mul 21 6141; add 1455
6142; mul 47 4911; mul 21 6144; sub 2068 6145; mul 4256 4592; mul 512 6138; sub 6147 6148; mul 4256 4596; add 6149
6150; mul 48 4626; add 6151 6152; mul 38 4581; add 6153 6154; mul 512 6141; mul 4256 4804; add 6156 6157; mul 4256
4807; add 6158 6159; mul 48 4833; add 6160 6161; mul 38 4793; add 6162 6163; mul 4256 5010; mul 512 6144; sub 6165
6166; mul 4256 5014; add 6167 6168; mul 48 5040; add 6169 6170; mul 38 5000; add 6171 6172; neg 93; neg 568; neg
400; neg 571; neg 403; neg 575; neg 407; input p 269; mul 331 441; mul 6181 6182; add 441 6183; input p 270; mul
6182 6185; mul 157 6186; add 6184 6187; add 653 6188; mul 544 653; mul 6181 6190; add 6189 6191; mul 6185 6190; mul
157 6193; add 6192 6194; mul 331 1470; mul 6181 6196; add 1470 6197; mul 6185 6196; mul 157 6199; add 6198 6200; add
1577 6201; mul 544 1577; mul 6181 6203; add 6202 6204; mul 6185 6203; mul 157 6206; add 6205 6207; neg 6208; mul 331
2092; mul 6181 6210; add 2092 6211; mul 6185 6210; mul 157 6213; add 6212 6214; add 2187 6215; mul 544 2187; mul
6181 6217; add 6216 6218; mul 6185 6217; mul 157 6220; add 6219 6221; mul 544 2656; mul 6181 6223; add 2656 6224;
mul 6185 6223; mul 157 6226; add 6225 6227; mul 331 2764; mul 6181 6229; add 2764 6230; mul 6185 6229; mul 157 6232;
add 6231 6233; le 172 4496; le 4496 172; add 6235 6236; div 22 6237; mul 6235 6238; mul 297 350; mul 6239 6240; neg
6241; mul 93 297; mul 6239 6243; mul 97 297; mul 6239 6245; neg 6246; mul 4521 6240; neg 6248; mul 4521 6243; mul
4521 6245; neg 6251; mul 350 4530; mul 297 6253; neg 6254; mul 93 4530; mul 297 6256; mul 97 4530; mul 297 6258; neg
6259; input p 271; mul 4530 4531; mul 350 6262; mul 369 4529; div 22 6264; mul 6263 6265; mul 6261 6266; mul 93
6262; mul 6265 6268; mul 6261 6269; neg 6270; mul 97 6262; mul 6265 6272; mul 6261 6273; mul 93 4453; mul 93 4448;
add 6275 6276; mul 93 4443; add 6277 6278; mul 93 4438; add 6279 6280; mul 1429 4453; mul 1429 4448; add 6282 6283;
mul 1429 4443; add 6284 6285; mul 1429 4438; add 6286 6287; neg 6288; mul 1408 4453; mul 1408 4448; add 6290 6291;
mul 1408 4443; add 6292 6293; mul 1408 4438; add 6294 6295; le 22 4437; mul 305 4439; add 297 6298; lt 172 6299; and
6297 6300; le 4437 2874; lt 6299 172; and 6302 6303; or 6301 6304; not 6305; input p 184; mul 305 6307; where 6306
6308; le 22 4442; and 6300 6310; le 4442 2874; and 6303 6312; or 6311 6313; not 6314; input p 185; mul 305 6316;
where 6315 6317; le 22 4447; and 6300 6319; le 4447 2874; and 6303 6321; or 6320 6322; not 6323; input p 186; mul
305 6325; where 6324 6326; le 22 4452; and 6300 6328; le 4452 2874; and 6303 6330; or 6329 6331; not 6332; input p
187; mul 305 6334; where 6333 6335; mul 37 4329; mul 37 4316; mul 47 4319; add 6338 6339; mul 47 722; add 6340 6341;
sub 6337 6342; mul 37 4721; mul 47 4724; add 6344 6345; mul 47 1628; sub 6346 6347; mul 37 4733; add 6348 6349; mul
37 4938; mul 37 4926; mul 47 4929; add 6352 6353; mul 47 2242; add 6354 6355; sub 6351 6356; mul 37 5094; mul 37
5085; mul 47 5083; add 6359 6360; mul 47 2683; add 6361 6362; sub 6358 6363; mul 37 4319; mul 47 4316; sub 6365
6366; mul 37 722; add 6367 6368; mul 47 4329; add 6369 6370; mul 47 4721; mul 37 4724; sub 6372 6373; mul 37 1628;
add 6374 6375; mul 47 4733; add 6376 6377; mul 37 4929; mul 47 4926; sub 6379 6380; mul 37 2242; add 6381 6382; mul
47 4938; add 6383 6384; mul 37 5083; mul 47 5085; sub 6386 6387; mul 37 2683; add 6388 6389; mul 47 5094; add 6390
6391; neg 4329; neg 4733; neg 4938; neg 5094; mul 521 536; mul 702 6397; mul 521 581; mul 685 6399; add 6398 6400;
mul 521 566; mul 617 6402; add 6401 6403; mul 521 532; mul 718 6405; add 6404 6406; neg 6407; mul 1593 6399; mul
1608 6397; sub 6409 6410; mul 1541 6402; add 6411 6412; mul 1624 6405; sub 6413 6414; mul 2222 6397; mul 2206 6399;
add 6416 6417; mul 2155 6402; add 6418 6419; mul 2238 6405; add 6420 6421; neg 6422; mul 2673 6397; mul 2659 6399;
add 6424 6425; mul 2679 6405; add 6426 6427; neg 6428; mul 542 704; mul 542 1610; neg 6431; mul 542 2224; neg 1587;
mul 546 676; mul 546 1587; neg 6436; mul 546 2200; mul 563 656; mul 555 6439; neg 6440; mul 563 1565; mul 555 6442;
mul 563 2190; mul 555 6444; neg 6445; input p 272; mul 544 660; mul 6447 6448; add 660 6449; input p 273; mul 6448
6451; mul 157 6452; add 6450 6453; neg 6454; mul 544 1581; mul 6447 6456; add 1581 6457; mul 6451 6456; mul 157
6459; add 6458 6460; mul 544 2194; mul 6447 6462; add 2194 6463; mul 6451 6462; mul 157 6465; add 6464 6466; neg
6467; mul 586 617; mul 568 6469; mul 586 1541; mul 568 6471; neg 6472; mul 586 2155; mul 568 6474; mul 571 6469; mul
571 6471; neg 6477; mul 571 6474; mul 575 6469; mul 575 6471; neg 6481; mul 575 6474; mul 586 646; mul 586 1570; neg
6485; mul 586 2180; mul 37 4302; mul 47 4298; add 6488 6489; mul 47 510; add 6490 6491; mul 37 4313; sub 6492 6493;
mul 47 1533; mul 37 4706; mul 47 4709; add 6496 6497; sub 6495 6498; mul 37 4718; sub 6499 6500; mul 37 4913; mul 47
4909; add 6502 6503; mul 47 2147; add 6504 6505; mul 37 4923; sub 6506 6507; mul 37 5124; mul 47 5126; add 6509
6510; mul 47 2791; add 6511 6512; mul 37 5135; sub 6513 6514; mul 37 4298; mul 47 4302; sub 6516 6517; mul 37 510;
add 6518 6519; mul 47 4313; add 6520 6521; mul 47 4706; mul 37 4709; sub 6523 6524; mul 37 1533; add 6525 6526; mul
47 4718; add 6527 6528; mul 37 4909; mul 47 4913; sub 6530 6531; mul 37 2147; add 6532 6533; mul 47 4923; add 6534
6535; mul 37 5126; mul 47 5124; sub 6537 6538; mul 37 2791; add 6539 6540; mul 47 5135; add 6541 6542; mul 147 296;
mul 490 6544; mul 147 329; mul 473 6546; add 6545 6547; mul 147 398; mul 361 6549; add 6548 6550; mul 147 292; mul
506 6552; add 6551 6553; neg 6554; mul 1486 6546; mul 1509 6544; sub 6556 6557; mul 1457 6549; add 6558 6559; mul
1525 6552; sub 6560 6561; mul 2127 6544; mul 2111 6546; add 6563 6564; mul 2070 6549; add 6565 6566; mul 2143 6552;
add 6567 6568; neg 6569; mul 2781 6544; mul 2767 6546; add 6571 6572; mul 2787 6552; add 6573 6574; neg 6575; mul
373 492; mul 373 1511; neg 6578; mul 373 2129; neg 1480; mul 378 464; mul 378 1480; neg 6583; mul 378 2105; mul 395
444; mul 387 6586; neg 6587; mul 395 1458; mul 387 6589; mul 395 2095; mul 387 6591; neg 6592; input p 274; mul 331
448; mul 6594 6595; add 448 6596; input p 275; mul 6595 6598; mul 157 6599; add 6597 6600; neg 6601; mul 331 1474;
mul 6594 6603; add 1474 6604; mul 6598 6603; mul 157 6606; add 6605 6607; mul 331 2099; mul 6594 6609; add 2099
6610; mul 6598 6609; mul 157 6612; add 6611 6613; neg 6614; mul 338 361; mul 400 6616; mul 338 1457; mul 400 6618;
neg 6619; mul 338 2070; mul 400 6621; mul 403 6616; mul 403 6618; neg 6624; mul 403 6621; mul 407 6616; mul 407
6618; neg 6628; mul 407 6621; mul 338 434; mul 338 1463; neg 6632; mul 338 2085; mul 93 4439; sub 6635 350; mul 4437
6636; mul 1429 4439; sub 93 6638; mul 4437 6639; mul 1408 4439; sub 6641 97; mul 4437 6642; mul 4442 6636; mul 4442
6639; mul 4442 6642; mul 4447 6636; mul 4447 6639; mul 4447 6642; mul 4452 6636; mul 4452 6639; mul 4452 6642;
constant 0.4444444444444444; mul 93 2901; mul 97 2903; sub 6654 6655; mul 114 6656; mul 6653 6657; constant
0.2777777777777778; mul 93 2930; mul 97 2869; sub 6660 6661; mul 350 2928; sub 6662 6663; mul 101 6664; mul 6659
6665; add 6658 6666; mul 93 2866; sub 6668 6661; mul 350 2864; sub 6669 6670; mul 124 6671; mul 6659 6672; add 6667
6673; mul 1408 2903; mul 1429 2901; sub 6675 6676; mul 114 6677; mul 6653 6678; mul 1408 2869; mul 1429 2930; sub
6680 6681; mul 93 2928; add 6682 6683; mul 101 6684; mul 6659 6685; add 6679 6686; mul 1429 2866; sub 6680 6688; mul
93 2864; add 6689 6690; mul 124 6691; mul 6659 6692; add 6687 6693; mul 1408 2901; mul 2032 2903; sub 6695 6696; mul
114 6697; mul 6653 6698; mul 1408 2930; mul 2032 2869; sub 6700 6701; mul 97 2928; sub 6702 6703; mul 101 6704; mul
6659 6705; add 6699 6706; mul 1408 2866; sub 6708 6701; mul 97 2864; sub 6709 6710; mul 124 6711; mul 6659 6712; add
6707 6713; mul 108 6656; mul 6653 6715; mul 2 6664; mul 6659 6717; add 6716 6718; mul 119 6671; mul 6659 6720; add
6719 6721; mul 108 6677; mul 6653 6723; mul 2 6684; mul 6659 6725; add 6724 6726; mul 119 6691; mul 6659 6728; add
6727 6729; mul 108 6697; mul 6653 6731; mul 2 6704; mul 6659 6733; add 6732 6734; mul 119 6711; mul 6659 6736; add
6735 6737; mul 6299 6307; mul 6307 6739; neg 6740; where 6306 6741; mul 6299 6316; mul 6316 6743; neg 6744; where
6315 6745; mul 6299 6325; mul 6325 6747; neg 6748; where 6324 6749; mul 6299 6334; mul 6334 6751; neg 6752; where
6333 6753; mul 2871 2880; mul 2880 6755; neg 6756; where 2879 6757; mul 2880 2905; mul 2880 6759; neg 6760; where
2912 6761; mul 2880 2933; mul 2880 6763; neg 6764; where 2940 6765; mul 2871 2893; mul 2893 6767; neg 6768; where
2892 6769; mul 2893 2905; mul 2893 6771; neg 6772; where 2922 6773; mul 2893 2933; mul 2893 6775; neg 6776; where
2949 6777; mul 350 4537; neg 6779; mul 93 4537; mul 97 4537; neg 6782; mul 350 4541; neg 6784; mul 93 4541; mul 97
4541; neg 6787; mul 385 444; mul 365 6789; mul 553 656; mul 365 6791; add 6790 6792; neg 6793; mul 385 1458; mul 365
6795; mul 553 1565; mul 365 6797; add 6796 6798; mul 385 2095; mul 365 6800; mul 553 2190; mul 365 6802; add 6801
6803; neg 6804; sub 22 365; mul 823 4161; mul 168 1402; sub 6807 6808; mul 823 4173; mul 168 2025; add 6810 6811;
mul 823 4185; mul 168 2638; sub 6813 6814; store by_k 114 1404; store by_k 342 2027; store by_k 570 2640; store by_k
684 2751; store by_k 798 2862; store by_k 912 2751; store by_k 1026 2862; store by_k 1140 2751; store by_k 1254
2862; store by_k 2166 2886; store by_k 2280 2899; store by_k 2394 2916; store by_k 2508 2926; store by_k 2622 2943;
store by_k 2736 2952; store by_k 115 3096; store by_k 343 3101; store by_k 571 3106; store by_k 116 3126; store by_k
344 3138; store by_k 572 3150; store by_k 117 3284; store by_k 345 3392; store by_k 573 3500; store by_k 118 3666;
store by_k 346 3794; store by_k 574 3922; store by_k 119 3999; store by_k 347 4073; store by_k 575 4147; store by_k
120 4162; store by_k 348 4174; store by_k 576 4186; store by_k 121 4201; store by_k 349 4213; store by_k 577 4225;
store by_k 122 4236; store by_k 350 4243; store by_k 578 4253; store by_k 123 4669; store by_k 351 4875; store by_k
579 5082; store by_k 693 5123; store by_k 807 5164; store by_k 921 5123; store by_k 1035 5164; store by_k 1149 5123;
store by_k 1263 5164; store by_k 124 5167; store by_k 352 5169; store by_k 580 5172; store by_k 125 5176; store by_k
353 5180; store by_k 581 5184; store by_k 126 5189; store by_k 354 5193; store by_k 582 5198; store by_k 127 5204;
store by_k 355 5210; store by_k 583 5216; store by_k 128 5223; store by_k 356 5229; store by_k 584 5236; store by_k
129 5243; store by_k 357 5248; store by_k 585 5255; store by_k 130 5259; store by_k 358 5263; store by_k 586 5267;
store by_k 131 5273; store by_k 359 5280; store by_k 587 5286; store by_k 132 5293; store by_k 360 5299; store by_k
588 5306; store by_k 133 5310; store by_k 361 5313; store by_k 589 5317; store by_k 134 5319; store by_k 362 5322;
store by_k 590 5324; store by_k 135 5328; store by_k 363 5332; store by_k 591 5336; store by_k 136 5342; store by_k
364 5348; store by_k 592 5354; store by_k 137 5357; store by_k 365 5360; store by_k 593 5363; store by_k 138 5365;
store by_k 366 5366; store by_k 594 5368; store by_k 139 5373; store by_k 367 5377; store by_k 595 5382; store by_k
140 5389; store by_k 368 5395; store by_k 596 5402; store by_k 141 5409; store by_k 369 5415; store by_k 597 5422;
store by_k 142 5428; store by_k 370 5435; store by_k 598 5441; store by_k 143 5448; store by_k 371 5455; store by_k
599 5462; store by_k 144 5469; store by_k 372 5475; store by_k 600 5482; store by_k 145 5486; store by_k 373 5490;
store by_k 601 5494; store by_k 146 5500; store by_k 374 5507; store by_k 602 5513; store by_k 147 5520; store by_k
375 5526; store by_k 603 5533; store by_k 148 5538; store by_k 376 5542; store by_k 604 5547; store by_k 149 5549;
store by_k 377 5551; store by_k 605 5553; store by_k 719 5555; store by_k 833 5557; store by_k 947 5555; store by_k
1061 5557; store by_k 1175 5555; store by_k 1289 5557; store by_k 150 5561; store by_k 378 5565; store by_k 606
5569; store by_k 720 5573; store by_k 834 5577; store by_k 948 5573; store by_k 1062 5577; store by_k 1176 5573;
store by_k 1290 5577; store by_k 151 5581; store by_k 379 5585; store by_k 607 5589; store by_k 721 5593; store by_k
835 5597; store by_k 949 5593; store by_k 1063 5597; store by_k 1177 5593; store by_k 1291 5597; store by_k 152
5602; store by_k 380 5607; store by_k 608 5612; store by_k 722 5617; store by_k 836 5622; store by_k 950 5617; store
by_k 1064 5622; store by_k 1178 5617; store by_k 1292 5622; store by_k 153 5628; store by_k 381 5634; store by_k 609
5640; store by_k 723 5646; store by_k 837 5652; store by_k 951 5646; store by_k 1065 5652; store by_k 1179 5646;
store by_k 1293 5652; store by_k 154 5656; store by_k 382 5660; store by_k 610 5664; store by_k 724 5668; store by_k
838 5672; store by_k 952 5668; store by_k 1066 5672; store by_k 1180 5668; store by_k 1294 5672; store by_k 155
5678; store by_k 383 5684; store by_k 611 5690; store by_k 725 5696; store by_k 839 5702; store by_k 953 5696; store
by_k 1067 5702; store by_k 1181 5696; store by_k 1295 5702; store by_k 156 5704; store by_k 384 5706; store by_k 612
5708; store by_k 726 5710; store by_k 840 5712; store by_k 954 5710; store by_k 1068 5712; store by_k 1182 5710;
store by_k 1296 5712; store by_k 157 5716; store by_k 385 5720; store by_k 613 5724; store by_k 727 5728; store by_k
841 5732; store by_k 955 5728; store by_k 1069 5732; store by_k 1183 5728; store by_k 1297 5732; store by_k 158
5771; store by_k 386 5808; store by_k 614 5842; store by_k 159 5843; store by_k 387 5844; store by_k 615 5845; store
by_k 160 4578; store by_k 388 4790; store by_k 616 4997; store by_k 161 5846; store by_k 389 5847; store by_k 617
5848; store by_k 162 5767; store by_k 390 5804; store by_k 618 5838; store by_k 163 5872; store by_k 391 5894; store
by_k 619 5917; store by_k 733 5921; store by_k 847 5925; store by_k 961 5921; store by_k 1075 5925; store by_k 1189
5921; store by_k 1303 5925; store by_k 164 5939; store by_k 392 5953; store by_k 620 5967; store by_k 734 5972;
store by_k 848 5977; store by_k 962 5972; store by_k 1076 5977; store by_k 1190 5972; store by_k 1304 5977; store
by_k 165 5982; store by_k 393 5987; store by_k 621 5992; store by_k 735 5993; store by_k 849 5994; store by_k 963
5993; store by_k 1077 5994; store by_k 1191 5993; store by_k 1305 5994; store by_k 166 6020; store by_k 394 6045;
store by_k 622 6071; store by_k 736 6076; store by_k 850 6081; store by_k 964 6076; store by_k 1078 6081; store by_k
1192 6076; store by_k 1306 6081; store by_k 167 6092; store by_k 395 6103; store by_k 623 6114; store by_k 737 6117;
store by_k 851 6120; store by_k 965 6117; store by_k 1079 6120; store by_k 1193 6117; store by_k 1307 6120; store
by_k 168 6125; store by_k 396 6130; store by_k 624 6135; store by_k 738 6136; store by_k 852 6137; store by_k 966
6136; store by_k 1080 6137; store by_k 1194 6136; store by_k 1308 6137; store by_k 169 6140; store by_k 397 6143;
store by_k 625 6146; store by_k 170 6155; store by_k 398 6164; store by_k 626 6173; store by_k 171 350; store by_k
399 6174; store by_k 627 97; store by_k 742 6175; store by_k 856 6176; store by_k 971 6177; store by_k 1085 6178;
store by_k 1200 6179; store by_k 1314 6180; store by_k 175 6195; store by_k 403 6209; store by_k 631 6222; store
by_k 745 6228; store by_k 859 6234; store by_k 973 6228; store by_k 1087 6234; store by_k 1201 6228; store by_k 1315
6234; store by_k 176 6242; store by_k 404 6244; store by_k 632 6247; store by_k 177 6249; store by_k 405 6250; store
by_k 633 6252; store by_k 178 6255; store by_k 406 6257; store by_k 634 6260; store by_k 179 6267; store by_k 407
6271; store by_k 635 6274; store by_k 180 6281; store by_k 408 6289; store by_k 636 6296; store by_k 1776 6309;
store by_k 1890 6318; store by_k 2004 6327; store by_k 2118 6336; store by_k 181 6343; store by_k 409 6350; store
by_k 637 6357; store by_k 751 6364; store by_k 979 6364; store by_k 1207 6364; store by_k 182 6371; store by_k 410
6378; store by_k 638 6385; store by_k 752 6392; store by_k 980 6392; store by_k 1208 6392; store by_k 183 6393;
store by_k 411 6394; store by_k 639 6395; store by_k 753 6396; store by_k 981 6396; store by_k 1209 6396; store by_k
184 722; store by_k 412 1628; store by_k 640 2242; store by_k 754 2683; store by_k 982 2683; store by_k 1210 2683;
store by_k 185 6408; store by_k 413 6415; store by_k 641 6423; store by_k 755 6429; store by_k 983 6429; store by_k
1211 6429; store by_k 186 6430; store by_k 414 6432; store by_k 642 6433; store by_k 187 676; store by_k 415 6434;
store by_k 643 2200; store by_k 188 6435; store by_k 416 6437; store by_k 644 6438; store by_k 189 6441; store by_k
417 6443; store by_k 645 6446; store by_k 190 6455; store by_k 418 6461; store by_k 646 6468; store by_k 191 6470;
store by_k 419 6473; store by_k 647 6475; store by_k 192 6476; store by_k 420 6478; store by_k 648 6479; store by_k
193 6480; store by_k 421 6482; store by_k 649 6483; store by_k 194 6484; store by_k 422 6486; store by_k 650 6487;
store by_k 195 6494; store by_k 423 6501; store by_k 651 6508; store by_k 879 6515; store by_k 1107 6515; store by_k
1335 6515; store by_k 196 6522; store by_k 424 6529; store by_k 652 6536; store by_k 880 6543; store by_k 1108 6543;
store by_k 1336 6543; store by_k 197 4313; store by_k 425 4718; store by_k 653 4923; store by_k 881 5135; store by_k
1109 5135; store by_k 1337 5135; store by_k 198 510; store by_k 426 1533; store by_k 654 2147; store by_k 882 2791;
store by_k 1110 2791; store by_k 1338 2791; store by_k 199 6555; store by_k 427 6562; store by_k 655 6570; store
by_k 883 6576; store by_k 1111 6576; store by_k 1339 6576; store by_k 200 6577; store by_k 428 6579; store by_k 656
6580; store by_k 201 464; store by_k 429 6581; store by_k 657 2105; store by_k 202 6582; store by_k 430 6584; store
by_k 658 6585; store by_k 203 6588; store by_k 431 6590; store by_k 659 6593; store by_k 204 6602; store by_k 432
6608; store by_k 660 6615; store by_k 205 6617; store by_k 433 6620; store by_k 661 6622; store by_k 206 6623; store
by_k 434 6625; store by_k 662 6626; store by_k 207 6627; store by_k 435 6629; store by_k 663 6630; store by_k 208
6631; store by_k 436 6633; store by_k 664 6634; store by_k 209 6637; store by_k 437 6640; store by_k 665 6643; store
by_k 210 6644; store by_k 438 6645; store by_k 666 6646; store by_k 211 6647; store by_k 439 6648; store by_k 667
6649; store by_k 212 6650; store by_k 440 6651; store by_k 668 6652; store by_k 213 6674; store by_k 441 6694; store
by_k 669 6714; store by_k 214 6722; store by_k 442 6730; store by_k 670 6738; store by_k 1811 6742; store by_k 1926
6746; store by_k 2041 6750; store by_k 2156 6754; store by_k 2271 6758; store by_k 2499 6762; store by_k 2727 6766;
store by_k 2386 6770; store by_k 2614 6774; store by_k 2842 6778; store by_k 221 6780; store by_k 449 6781; store
by_k 677 6783; store by_k 222 6785; store by_k 450 6786; store by_k 678 6788; store by_k 1477 4537; store by_k 1592
4541; store by_k 225 6794; store by_k 453 6799; store by_k 681 6805; store by_k 1708 6806; store by_k 227 6809;
store by_k 455 6812; store by_k 683 6815
    """,
)
