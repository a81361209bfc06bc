"""Kernels of the full-order joint.

Inputs: `qm`, `qm_dot`, `qm_ddot` shape (4,) Ritz coordinates [1/m, 1/m², 1/m³, m] and their rates; `z` shape (3,)
Maxwell strains and friction state; `v_squared` shape (2,) [V²]; `force` shape (1,) [N]; `p` shape (41,) parameters
in the order of `pipeline.device.parameters.VECTOR_NAMES`. The arguments after them are outputs.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from ..codegen.graph import Graph
from ..codegen.numba_writer import kernel
from ..numerics.compiled import compiled
from ..numerics.arrays import FloatArray

STATICS = Graph(
    {'qm': 4, 'v_squared': 2, 'p': 41},
    {'gradient': 4, 'hessian': 16, 'energy': 1},
    """
input p 0; input qm 0; mul 0 1; constant 2.0; mul 2 3; constant 1.3333333333333333; constant 0.5; mul 0 6; input p
29; sub 8 0; input qm 3; constant 2.2857142857142856; input qm 2; mul 0 12; mul 0 13; mul 0 14; mul 15 15; mul 11
16; constant 4.0; input qm 1; mul 0 19; mul 0 20; mul 15 21; mul 18 22; add 17 23; constant 1.8; mul 21 21; mul 25
26; add 24 27; constant 3.2; mul 2 15; mul 29 30; add 28 31; constant 3.0; mul 2 21; mul 33 34; add 32 35; mul 2 2;
mul 5 37; add 36 38; mul 7 39; sub 10 40; sub 9 41; input p 27; input p 28; sub 43 44; constant 1.0; mul 21 33; add
4 47; mul 15 18; add 48 49; mul 50 50; add 46 51; sqrt 52; div 46 53; mul 45 54; add 42 55; input p 26; mul 50 54;
mul 57 58; add 56 59; mul 3 60; constant 8.854e-12; input p 32; mul 62 63; input p 36; mul 64 65; input p 35; mul 66
67; input p 34; mul 68 69; input p 33; div 46 71; mul 70 72; constant -0.5; input v_squared 1; mul 74 75; mul 73 76;
input p 31; div 46 78; mul 77 79; mul 45 58; mul 54 57; input p 30; sub 82 83; sub 81 84; add 2 21; add 15 86; mul 0
87; sub 85 88; mul 89 89; mul 60 60; add 90 91; sqrt 92; mul 3 93; div 46 94; mul 80 95; mul 61 96; input p 14; sub
98 0; sub 99 41; input p 12; input p 13; sub 101 102; mul 54 103; add 100 104; input p 11; mul 58 106; sub 105 107;
mul 3 108; input p 17; mul 62 110; input p 21; mul 111 112; input p 20; mul 113 114; input p 19; mul 115 116; input
p 18; div 46 118; mul 117 119; input v_squared 0; mul 74 121; mul 120 122; input p 16; div 46 124; mul 123 125; mul
54 106; input p 15; sub 127 128; mul 58 103; add 129 130; sub 131 88; mul 132 132; mul 108 108; add 133 134; sqrt
135; mul 3 136; div 46 137; mul 126 138; mul 109 139; add 97 140; mul 7 141; mul 5 142; mul 4 143; mul 33 142; mul
21 145; add 144 146; mul 29 142; mul 15 148; add 147 149; mul 3 89; mul 96 151; mul 3 132; mul 139 153; add 152 154;
mul 0 155; sub 150 156; mul 57 97; mul 45 152; add 158 159; mul 106 140; sub 160 161; mul 103 154; add 162 163; mul
54 164; mul 3 50; mul 54 82; mul 152 167; mul 54 55; mul 97 169; sub 168 170; mul 54 104; mul 140 172; sub 171 173;
mul 54 58; mul 164 175; sub 174 176; mul 54 127; mul 154 178; sub 177 179; mul 3 53; div 46 181; mul 180 182; mul
166 183; add 165 184; mul 3 185; add 157 186; mul 0 187; mul 79 93; mul 3 189; mul 63 69; mul 71 191; input p 37;
mul 192 193; constant 6.0; div 46 195; mul 194 196; mul 190 197; div 46 189; mul 3 199; mul 199 200; mul 197 201;
sub 198 202; mul 79 203; mul 95 204; mul 61 205; mul 125 136; mul 3 207; mul 110 116; mul 118 209; input p 22; mul
210 211; mul 196 212; mul 208 213; div 46 207; mul 3 215; mul 215 216; mul 213 217; sub 214 218; mul 125 219; mul
138 220; mul 109 221; add 206 222; mul 7 223; mul 5 224; mul 4 225; mul 33 224; mul 21 227; add 226 228; mul 29 224;
mul 15 230; add 229 231; mul 151 205; mul 153 221; add 233 234; mul 0 235; sub 232 236; mul 57 206; mul 45 233; add
238 239; mul 106 222; sub 240 241; mul 103 234; add 242 243; mul 54 244; mul 167 233; mul 169 206; sub 246 247; mul
172 222; sub 248 249; mul 175 244; sub 250 251; mul 178 234; sub 252 253; mul 182 254; mul 166 255; add 245 256; mul
3 257; add 237 258; mul 0 259; add 188 260; input p 6; input p 7; mul 262 263; mul 7 264; mul 5 265; mul 4 266; mul
33 265; mul 21 268; add 267 269; mul 29 265; mul 15 271; add 270 272; mul 0 273; sub 261 274; mul 2 37; constant
5.333333333333333; input p 2; input p 3; mul 6 279; div 46 0; mul 280 281; mul 278 282; mul 277 283; mul 276 284;
mul 2 284; mul 37 286; add 285 287; mul 2 286; mul 4 289; add 288 290; constant 36.0; mul 283 292; mul 21 293; mul
37 294; add 291 295; mul 2 294; mul 4 297; add 296 298; constant 51.2; mul 283 300; mul 15 301; mul 37 302; add 299
303; mul 2 302; mul 4 305; add 304 306; constant -5.333333333333333; input p 8; mul 0 309; mul 308 310; mul 283 311;
mul 37 312; add 307 313; mul 2 312; mul 4 315; add 314 316; constant 93.60000000000001; mul 283 318; mul 21 319; mul
21 320; mul 4 321; add 317 322; constant 272.0; mul 283 324; mul 15 325; mul 21 326; mul 4 327; add 323 328;
constant -24.0; mul 310 330; mul 283 331; mul 21 332; mul 4 333; add 329 334; constant 201.14285714285714; mul 283
336; mul 15 337; mul 15 338; mul 4 339; add 335 340; constant -32.0; mul 310 342; mul 283 343; mul 15 344; mul 4
345; add 341 346; mul 310 310; mul 5 348; add 18 349; mul 283 350; mul 4 351; add 347 352; constant 108.0; mul 283
354; mul 21 355; mul 21 356; mul 21 357; add 353 358; constant 473.1428571428571; mul 283 360; mul 15 361; mul 21
362; mul 21 363; add 359 364; constant -36.0; mul 310 366; mul 283 367; mul 21 368; mul 21 369; add 365 370;
constant 696.0; mul 283 372; mul 15 373; mul 15 374; mul 21 375; add 371 376; constant -96.0; mul 310 378; mul 283
379; mul 15 380; mul 21 381; add 377 382; constant 12.0; mul 33 348; add 384 385; mul 283 386; mul 21 387; add 383
388; constant 341.3333333333333; mul 283 390; mul 15 391; mul 15 392; mul 15 393; add 389 394; constant -64.0; mul
310 396; mul 283 397; mul 15 398; mul 15 399; add 395 400; constant 16.0; mul 29 348; add 402 403; mul 283 404; mul
15 405; add 401 406; constant -4.0; mul 310 408; mul 283 409; add 407 410; mul 0 411; add 275 412; mul 2 145; mul 3
21; mul 25 142; mul 415 416; add 414 417; mul 18 142; mul 15 419; add 418 420; sub 421 156; mul 33 185; add 422 423;
mul 0 424; mul 0 425; mul 2 227; mul 25 224; mul 415 428; add 427 429; mul 18 224; mul 15 431; add 430 432; sub 433
236; mul 33 257; add 434 435; mul 0 436; mul 0 437; add 426 438; mul 2 268; mul 25 265; mul 415 441; add 440 442;
mul 18 265; mul 15 444; add 443 445; mul 0 446; mul 0 447; sub 439 448; mul 276 293; mul 21 37; mul 319 451; add 450
452; mul 37 320; add 453 454; mul 37 326; add 455 456; mul 37 332; add 457 458; mul 21 34; mul 355 460; add 459 461;
mul 34 356; add 462 463; mul 2 357; add 464 465; mul 34 362; add 466 467; mul 2 363; add 468 469; mul 34 368; add
470 471; mul 2 369; add 472 473; mul 2 375; add 474 475; mul 2 381; add 476 477; mul 2 387; add 478 479; mul 21 26;
constant 46.285714285714285; mul 283 482; mul 481 483; add 480 484; mul 21 483; mul 26 486; add 485 487; mul 21 486;
mul 415 489; add 488 490; constant 270.0; mul 283 492; mul 15 493; mul 26 494; add 491 495; mul 21 494; mul 415 497;
add 496 498; constant -18.0; mul 310 500; mul 283 501; mul 26 502; add 499 503; mul 21 502; mul 415 505; add 504
506; constant 592.0; mul 283 508; mul 15 509; mul 15 510; mul 415 511; add 507 512; constant -72.0; mul 310 514; mul
283 515; mul 15 516; mul 415 517; add 513 518; mul 25 348; add 384 520; mul 283 521; mul 415 522; add 519 523;
constant 576.0; mul 283 525; mul 15 526; mul 15 527; mul 15 528; add 524 529; mul 15 381; add 530 531; mul 18 348;
add 292 533; mul 283 534; mul 15 535; add 532 536; constant -6.0; mul 310 538; mul 283 539; add 537 540; mul 0 541;
mul 0 542; add 449 543; mul 2 148; mul 21 419; add 545 546; mul 3 15; mul 11 142; mul 548 549; add 547 550; sub 551
156; mul 18 185; add 552 553; mul 0 554; mul 0 555; mul 0 556; mul 2 230; mul 21 431; add 558 559; mul 11 224; mul
548 561; add 560 562; sub 563 236; mul 18 257; add 564 565; mul 0 566; mul 0 567; mul 0 568; add 557 569; mul 2 271;
mul 21 444; add 571 572; mul 11 265; mul 548 574; add 573 575; mul 0 576; mul 0 577; mul 0 578; sub 570 579; mul 276
301; mul 325 451; add 581 582; mul 15 37; mul 337 584; add 583 585; mul 37 338; add 586 587; mul 37 344; add 588
589; mul 361 460; add 590 591; mul 15 34; mul 373 593; add 592 594; mul 34 374; add 595 596; mul 34 380; add 597
598; mul 15 30; mul 391 600; add 599 601; mul 30 392; add 602 603; mul 2 393; add 604 605; mul 30 398; add 606 607;
mul 2 399; add 608 609; mul 2 405; add 610 611; mul 481 493; add 612 613; mul 15 26; mul 509 615; add 614 616; mul
26 510; add 617 618; mul 26 516; add 619 620; mul 15 22; mul 526 622; add 621 623; mul 22 527; add 624 625; mul 21
528; add 626 627; mul 22 380; add 628 629; add 382 630; mul 21 535; add 631 632; mul 15 16; constant
209.45454545454547; mul 283 635; mul 634 636; add 633 637; mul 15 636; mul 16 639; add 638 640; mul 15 639; mul 548
642; add 641 643; constant -42.666666666666664; mul 310 645; mul 283 646; mul 16 647; add 644 648; mul 15 647; mul
548 650; add 649 651; constant 28.8; mul 11 348; add 653 654; mul 283 655; mul 548 656; add 652 657; constant -8.0;
mul 310 659; mul 283 660; add 658 661; mul 0 662; mul 0 663; mul 0 664; add 580 665; add 141 223; sub 264 667; mul 3
10; input p 1; mul 282 670; mul 669 671; add 668 672; mul 0 3; mul 143 674; mul 0 15; mul 29 676; mul 0 21; mul 33
678; add 677 679; mul 0 4; mul 5 681; add 680 682; mul 7 683; mul 166 674; mul 182 685; mul 169 686; sub 684 687;
mul 54 674; mul 175 686; sub 689 690; mul 57 691; add 688 692; mul 3 693; mul 96 694; mul 95 96; mul 45 691; mul 167
686; add 697 698; mul 0 0; sub 699 700; mul 151 701; mul 61 693; add 702 703; mul 95 704; mul 3 705; mul 696 706;
mul 61 707; sub 695 708; mul 172 686; sub 684 710; mul 106 691; sub 711 712; mul 3 713; mul 139 714; mul 138 139;
mul 103 691; mul 178 686; sub 717 718; sub 719 700; mul 153 720; mul 109 713; add 721 722; mul 138 723; mul 3 724;
mul 716 725; mul 109 726; sub 715 727; add 709 728; mul 7 729; mul 5 730; mul 4 731; add 675 732; mul 33 730; mul 21
734; add 733 735; mul 29 730; mul 15 737; add 736 738; mul 3 701; mul 96 740; mul 151 707; sub 741 742; mul 3 720;
mul 139 744; mul 153 726; sub 745 746; add 743 747; mul 0 748; sub 739 749; mul 57 709; mul 45 743; add 751 752; mul
106 728; sub 753 754; mul 103 747; add 755 756; mul 54 757; mul 54 165; mul 686 759; sub 758 760; mul 0 18; mul 183
762; mul 167 743; mul 54 698; mul 54 167; mul 686 766; add 765 767; mul 152 768; sub 764 769; mul 169 709; mul 54
687; mul 54 169; mul 686 773; add 772 774; mul 97 775; sub 771 776; sub 770 777; mul 172 728; mul 54 710; mul 54
172; mul 686 781; add 780 782; mul 140 783; sub 779 784; sub 778 785; mul 54 691; mul 54 175; mul 686 788; sub 787
789; mul 164 790; mul 175 757; add 791 792; sub 786 793; mul 178 747; mul 54 718; mul 54 178; mul 686 797; add 796
798; mul 154 799; sub 795 800; sub 794 801; mul 182 802; mul 182 183; mul 3 686; mul 804 805; sub 803 806; mul 166
807; add 763 808; add 761 809; mul 3 810; add 750 811; mul 0 812; mul 225 674; mul 205 694; mul 79 705; mul 3 816;
mul 197 817; mul 201 816; mul 199 819; mul 199 201; mul 816 821; add 820 822; mul 197 823; add 818 824; mul 79 825;
mul 95 826; mul 95 205; mul 706 828; sub 827 829; mul 61 830; add 815 831; mul 221 714; mul 125 724; mul 3 834; mul
213 835; mul 217 834; mul 215 837; mul 215 217; mul 834 839; add 838 840; mul 213 841; add 836 842; mul 125 843; mul
138 844; mul 138 221; mul 725 846; sub 845 847; mul 109 848; add 833 849; add 832 850; mul 7 851; mul 5 852; mul 4
853; add 814 854; mul 33 852; mul 21 856; add 855 857; mul 29 852; mul 15 859; add 858 860; mul 205 740; mul 151
830; add 862 863; mul 221 744; mul 153 848; add 865 866; add 864 867; mul 0 868; sub 861 869; mul 57 832; mul 45
864; add 871 872; mul 106 850; sub 873 874; mul 103 867; add 875 876; mul 54 877; mul 54 245; mul 686 879; sub 878
880; mul 255 762; mul 167 864; mul 233 768; sub 883 884; mul 169 832; mul 206 775; sub 886 887; sub 885 888; mul 172
850; mul 222 783; sub 890 891; sub 889 892; mul 244 790; mul 175 877; add 894 895; sub 893 896; mul 178 867; mul 234
799; sub 898 899; sub 897 900; mul 182 901; mul 182 255; mul 805 903; sub 902 904; mul 166 905; add 882 906; add 881
907; mul 3 908; add 870 909; mul 0 910; add 813 911; mul 266 674; mul 0 913; sub 912 914; mul 2 681; mul 0 37; add
916 917; mul 284 918; mul 286 681; mul 0 284; mul 37 921; add 920 922; add 919 923; mul 289 674; mul 0 286; mul 2
921; add 926 927; mul 4 928; add 925 929; add 924 930; mul 294 681; add 931 932; mul 297 674; mul 0 294; mul 4 935;
add 934 936; add 933 937; mul 302 681; add 938 939; mul 305 674; mul 0 302; mul 4 942; add 941 943; add 940 944; mul
312 681; add 945 946; mul 315 674; mul 0 312; mul 4 949; add 948 950; add 947 951; mul 321 674; add 952 953; mul 327
674; add 954 955; mul 333 674; add 956 957; mul 339 674; add 958 959; mul 345 674; add 960 961; mul 351 674; add 962
963; mul 0 964; add 915 965; mul 15 700; mul 18 967; mul 415 700; mul 25 969; add 968 970; mul 2 700; mul 33 972;
add 971 973; mul 7 974; mul 33 700; mul 166 976; mul 182 977; mul 169 978; sub 975 979; mul 54 976; mul 175 978; sub
981 982; mul 57 983; add 980 984; mul 3 985; mul 96 986; mul 45 983; mul 167 978; add 988 989; mul 0 700; sub 990
991; mul 151 992; mul 61 985; add 993 994; mul 95 995; mul 3 996; mul 696 997; mul 61 998; sub 987 999; mul 172 978;
sub 975 1001; mul 106 983; sub 1002 1003; mul 3 1004; mul 139 1005; mul 103 983; mul 178 978; sub 1007 1008; sub
1009 991; mul 153 1010; mul 109 1004; add 1011 1012; mul 138 1013; mul 3 1014; mul 716 1015; mul 109 1016; sub 1006
1017; add 1000 1018; mul 7 1019; mul 5 1020; mul 4 1021; mul 145 700; mul 33 1020; mul 21 1024; add 1023 1025; add
1022 1026; mul 29 1020; mul 15 1028; add 1027 1029; mul 3 992; mul 96 1031; mul 151 998; sub 1032 1033; mul 3 1010;
mul 139 1035; mul 153 1016; sub 1036 1037; add 1034 1038; mul 0 1039; sub 1030 1040; mul 57 1000; mul 45 1034; add
1042 1043; mul 106 1018; sub 1044 1045; mul 103 1038; add 1046 1047; mul 54 1048; mul 759 978; sub 1049 1050; mul
195 700; mul 183 1052; mul 167 1034; mul 54 989; mul 766 978; add 1055 1056; mul 152 1057; sub 1054 1058; mul 169
1000; mul 54 979; mul 773 978; add 1061 1062; mul 97 1063; sub 1060 1064; sub 1059 1065; mul 172 1018; mul 54 1001;
mul 781 978; add 1068 1069; mul 140 1070; sub 1067 1071; sub 1066 1072; mul 54 983; mul 788 978; sub 1074 1075; mul
164 1076; mul 175 1048; add 1077 1078; sub 1073 1079; mul 178 1038; mul 54 1008; mul 797 978; add 1082 1083; mul 154
1084; sub 1081 1085; sub 1080 1086; mul 182 1087; mul 3 978; mul 804 1089; sub 1088 1090; mul 166 1091; add 1053
1092; add 1051 1093; mul 3 1094; add 1041 1095; mul 0 1096; mul 205 986; mul 79 996; mul 3 1099; mul 197 1100; mul
201 1099; mul 199 1102; mul 821 1099; add 1103 1104; mul 197 1105; add 1101 1106; mul 79 1107; mul 95 1108; mul 828
997; sub 1109 1110; mul 61 1111; add 1098 1112; mul 221 1005; mul 125 1014; mul 3 1115; mul 213 1116; mul 217 1115;
mul 215 1118; mul 839 1115; add 1119 1120; mul 213 1121; add 1117 1122; mul 125 1123; mul 138 1124; mul 846 1015;
sub 1125 1126; mul 109 1127; add 1114 1128; add 1113 1129; mul 7 1130; mul 5 1131; mul 4 1132; mul 227 700; mul 33
1131; mul 21 1135; add 1134 1136; add 1133 1137; mul 29 1131; mul 15 1139; add 1138 1140; mul 205 1031; mul 151
1111; add 1142 1143; mul 221 1035; mul 153 1127; add 1145 1146; add 1144 1147; mul 0 1148; sub 1141 1149; mul 57
1113; mul 45 1144; add 1151 1152; mul 106 1129; sub 1153 1154; mul 103 1147; add 1155 1156; mul 54 1157; mul 879
978; sub 1158 1159; mul 255 1052; mul 167 1144; mul 233 1057; sub 1162 1163; mul 169 1113; mul 206 1063; sub 1165
1166; sub 1164 1167; mul 172 1129; mul 222 1070; sub 1169 1170; sub 1168 1171; mul 244 1076; mul 175 1157; add 1173
1174; sub 1172 1175; mul 178 1147; mul 234 1084; sub 1177 1178; sub 1176 1179; mul 182 1180; mul 903 1089; sub 1181
1182; mul 166 1183; add 1161 1184; add 1160 1185; mul 3 1186; add 1150 1187; mul 0 1188; add 1097 1189; mul 268 700;
mul 0 1191; sub 1190 1192; mul 293 700; mul 37 1194; mul 2 1194; mul 4 1196; add 1195 1197; mul 320 700; mul 319
700; mul 21 1200; add 1199 1201; mul 4 1202; add 1198 1203; mul 326 700; mul 4 1205; add 1204 1206; mul 332 700; mul
4 1208; add 1207 1209; mul 357 700; mul 356 700; mul 355 700; mul 21 1213; add 1212 1214; mul 21 1215; add 1211
1216; add 1210 1217; mul 363 700; mul 362 700; mul 21 1220; add 1219 1221; add 1218 1222; mul 369 700; mul 368 700;
mul 21 1225; add 1224 1226; add 1223 1227; mul 375 700; add 1228 1229; mul 381 700; add 1230 1231; mul 387 700; add
1232 1233; mul 0 1234; add 1193 1235; mul 548 991; mul 11 1237; mul 21 991; mul 18 1239; add 1238 1240; mul 2 991;
mul 29 1242; add 1241 1243; mul 7 1244; mul 18 991; mul 166 1246; mul 182 1247; mul 169 1248; sub 1245 1249; mul 54
1246; mul 175 1248; sub 1251 1252; mul 57 1253; add 1250 1254; mul 3 1255; mul 96 1256; mul 45 1253; mul 167 1248;
add 1258 1259; mul 0 991; sub 1260 1261; mul 151 1262; mul 61 1255; add 1263 1264; mul 95 1265; mul 3 1266; mul 696
1267; mul 61 1268; sub 1257 1269; mul 172 1248; sub 1245 1271; mul 106 1253; sub 1272 1273; mul 3 1274; mul 139
1275; mul 103 1253; mul 178 1248; sub 1277 1278; sub 1279 1261; mul 153 1280; mul 109 1274; add 1281 1282; mul 138
1283; mul 3 1284; mul 716 1285; mul 109 1286; sub 1276 1287; add 1270 1288; mul 7 1289; mul 5 1290; mul 4 1291; mul
33 1290; mul 21 1293; add 1292 1294; mul 148 991; mul 29 1290; mul 15 1297; add 1296 1298; add 1295 1299; mul 3
1262; mul 96 1301; mul 151 1268; sub 1302 1303; mul 3 1280; mul 139 1305; mul 153 1286; sub 1306 1307; add 1304
1308; mul 0 1309; sub 1300 1310; mul 57 1270; mul 45 1304; add 1312 1313; mul 106 1288; sub 1314 1315; mul 103 1308;
add 1316 1317; mul 54 1318; mul 759 1248; sub 1319 1320; constant 8.0; mul 991 1322; mul 183 1323; mul 167 1304; mul
54 1259; mul 766 1248; add 1326 1327; mul 152 1328; sub 1325 1329; mul 169 1270; mul 54 1249; mul 773 1248; add 1332
1333; mul 97 1334; sub 1331 1335; sub 1330 1336; mul 172 1288; mul 54 1271; mul 781 1248; add 1339 1340; mul 140
1341; sub 1338 1342; sub 1337 1343; mul 54 1253; mul 788 1248; sub 1345 1346; mul 164 1347; mul 175 1318; add 1348
1349; sub 1344 1350; mul 178 1308; mul 54 1278; mul 797 1248; add 1353 1354; mul 154 1355; sub 1352 1356; sub 1351
1357; mul 182 1358; mul 3 1248; mul 804 1360; sub 1359 1361; mul 166 1362; add 1324 1363; add 1321 1364; mul 3 1365;
add 1311 1366; mul 0 1367; mul 205 1256; mul 79 1266; mul 3 1370; mul 197 1371; mul 201 1370; mul 199 1373; mul 821
1370; add 1374 1375; mul 197 1376; add 1372 1377; mul 79 1378; mul 95 1379; mul 828 1267; sub 1380 1381; mul 61
1382; add 1369 1383; mul 221 1275; mul 125 1284; mul 3 1386; mul 213 1387; mul 217 1386; mul 215 1389; mul 839 1386;
add 1390 1391; mul 213 1392; add 1388 1393; mul 125 1394; mul 138 1395; mul 846 1285; sub 1396 1397; mul 109 1398;
add 1385 1399; add 1384 1400; mul 7 1401; mul 5 1402; mul 4 1403; mul 33 1402; mul 21 1405; add 1404 1406; mul 230
991; mul 29 1402; mul 15 1409; add 1408 1410; add 1407 1411; mul 205 1301; mul 151 1382; add 1413 1414; mul 221
1305; mul 153 1398; add 1416 1417; add 1415 1418; mul 0 1419; sub 1412 1420; mul 57 1384; mul 45 1415; add 1422
1423; mul 106 1400; sub 1424 1425; mul 103 1418; add 1426 1427; mul 54 1428; mul 879 1248; sub 1429 1430; mul 255
1323; mul 167 1415; mul 233 1328; sub 1433 1434; mul 169 1384; mul 206 1334; sub 1436 1437; sub 1435 1438; mul 172
1400; mul 222 1341; sub 1440 1441; sub 1439 1442; mul 244 1347; mul 175 1428; add 1444 1445; sub 1443 1446; mul 178
1418; mul 234 1355; sub 1448 1449; sub 1447 1450; mul 182 1451; mul 903 1360; sub 1452 1453; mul 166 1454; add 1432
1455; add 1431 1456; mul 3 1457; add 1421 1458; mul 0 1459; add 1368 1460; mul 271 991; mul 0 1462; sub 1461 1463;
mul 301 991; mul 37 1465; mul 2 1465; mul 4 1467; add 1466 1468; mul 325 991; mul 21 1470; mul 4 1471; add 1469
1472; mul 338 991; mul 337 991; mul 15 1475; add 1474 1476; mul 4 1477; add 1473 1478; mul 344 991; mul 4 1480; add
1479 1481; mul 361 991; mul 21 1483; mul 21 1484; add 1482 1485; mul 374 991; mul 373 991; mul 15 1488; add 1487
1489; mul 21 1490; add 1486 1491; mul 380 991; mul 21 1493; add 1492 1494; mul 393 991; mul 392 991; mul 391 991;
mul 15 1498; add 1497 1499; mul 15 1500; add 1496 1501; add 1495 1502; mul 399 991; mul 398 991; mul 15 1505; add
1504 1506; add 1503 1507; mul 405 991; add 1508 1509; mul 0 1510; add 1464 1511; constant -2.0; mul 96 1513; div 46
93; mul 60 1515; neg 1516; mul 3 1517; mul 696 1518; mul 61 1519; sub 1514 1520; mul 139 1513; div 46 136; mul 108
1523; neg 1524; mul 3 1525; mul 716 1526; mul 109 1527; sub 1522 1528; add 1521 1529; mul 7 1530; mul 5 1531; mul 4
1532; mul 33 1531; mul 21 1534; add 1533 1535; mul 29 1531; mul 15 1537; add 1536 1538; mul 151 1519; mul 153 1527;
add 1540 1541; mul 0 1542; add 1539 1543; mul 57 1521; mul 45 1540; sub 1545 1546; mul 106 1529; sub 1547 1548; mul
103 1541; sub 1549 1550; mul 54 1551; mul 178 1541; mul 167 1540; mul 169 1521; add 1554 1555; mul 172 1529; add
1556 1557; mul 175 1551; add 1558 1559; sub 1553 1560; mul 182 1561; mul 166 1562; add 1552 1563; mul 3 1564; add
1544 1565; mul 0 1566; mul 205 1513; mul 79 1516; neg 1569; mul 3 1570; mul 197 1571; mul 201 1569; mul 199 1573;
mul 821 1569; add 1574 1575; mul 197 1576; sub 1572 1577; mul 79 1578; mul 95 1579; mul 828 1518; sub 1580 1581; mul
61 1582; add 1568 1583; mul 221 1513; mul 125 1524; neg 1586; mul 3 1587; mul 213 1588; mul 217 1586; mul 215 1590;
mul 839 1586; add 1591 1592; mul 213 1593; sub 1589 1594; mul 125 1595; mul 138 1596; mul 846 1526; sub 1597 1598;
mul 109 1599; add 1585 1600; add 1584 1601; mul 7 1602; mul 5 1603; mul 4 1604; mul 33 1603; mul 21 1606; add 1605
1607; mul 29 1603; mul 15 1609; add 1608 1610; mul 151 1582; mul 153 1599; add 1612 1613; mul 0 1614; sub 1611 1615;
mul 57 1584; mul 45 1612; add 1617 1618; mul 106 1601; sub 1619 1620; mul 103 1613; add 1621 1622; mul 54 1623; mul
167 1612; mul 169 1584; sub 1625 1626; mul 172 1601; sub 1627 1628; mul 175 1623; sub 1629 1630; mul 178 1613; sub
1631 1632; mul 182 1633; mul 166 1634; add 1624 1635; mul 3 1636; add 1616 1637; mul 0 1638; add 1567 1639; mul 2
1024; mul 3 700; mul 416 1642; mul 25 1020; mul 415 1644; add 1643 1645; add 1641 1646; mul 18 1020; mul 15 1648;
add 1647 1649; sub 1650 1040; mul 33 1094; add 1651 1652; mul 0 1653; mul 0 1654; mul 2 1135; mul 428 1642; mul 25
1131; mul 415 1658; add 1657 1659; add 1656 1660; mul 18 1131; mul 15 1662; add 1661 1663; sub 1664 1149; mul 33
1186; add 1665 1666; mul 0 1667; mul 0 1668; add 1655 1669; mul 441 1642; mul 0 1671; mul 0 1672; sub 1670 1673; mul
37 700; mul 319 1675; mul 37 1200; add 1676 1677; mul 21 972; mul 34 700; add 1679 1680; mul 355 1681; add 1678
1682; mul 356 972; mul 34 1213; add 1684 1685; add 1683 1686; mul 2 1215; add 1687 1688; mul 362 972; add 1689 1690;
mul 2 1220; add 1691 1692; mul 368 972; add 1693 1694; mul 2 1225; add 1695 1696; mul 21 969; mul 26 700; add 1698
1699; mul 483 1700; add 1697 1701; mul 486 969; mul 483 700; mul 26 1704; add 1703 1705; add 1702 1706; mul 489
1642; mul 486 700; mul 21 1704; add 1709 1710; mul 415 1711; add 1708 1712; add 1707 1713; mul 494 969; add 1714
1715; mul 497 1642; mul 494 700; mul 415 1718; add 1717 1719; add 1716 1720; mul 502 969; add 1721 1722; mul 505
1642; mul 502 700; mul 415 1725; add 1724 1726; add 1723 1727; mul 511 1642; add 1728 1729; mul 517 1642; add 1730
1731; mul 522 1642; add 1732 1733; mul 0 1734; mul 0 1735; add 1674 1736; mul 2 1293; mul 25 1290; mul 415 1739; add
1738 1740; mul 419 991; mul 18 1290; mul 15 1743; add 1742 1744; add 1741 1745; sub 1746 1310; mul 33 1365; add 1747
1748; mul 0 1749; mul 0 1750; mul 2 1405; mul 25 1402; mul 415 1753; add 1752 1754; mul 431 991; mul 18 1402; mul 15
1757; add 1756 1758; add 1755 1759; sub 1760 1420; mul 33 1457; add 1761 1762; mul 0 1763; mul 0 1764; add 1751
1765; mul 444 991; mul 0 1767; mul 0 1768; sub 1766 1769; mul 37 1470; mul 34 1483; add 1771 1772; mul 2 1484; add
1773 1774; mul 2 1490; add 1775 1776; mul 2 1493; add 1777 1778; mul 493 991; mul 26 1780; add 1779 1781; mul 21
1780; mul 415 1783; add 1782 1784; mul 510 991; mul 509 991; mul 15 1787; add 1786 1788; mul 415 1789; add 1785
1790; mul 516 991; mul 415 1792; add 1791 1793; mul 528 991; mul 527 991; mul 526 991; mul 15 1797; add 1796 1798;
mul 15 1799; add 1795 1800; add 1794 1801; mul 381 991; mul 15 1493; add 1803 1804; add 1802 1805; mul 535 991; add
1806 1807; mul 0 1808; mul 0 1809; add 1770 1810; mul 2 1534; mul 25 1531; mul 415 1813; add 1812 1814; mul 18 1531;
mul 15 1816; add 1815 1817; add 1543 1818; mul 33 1564; add 1819 1820; mul 0 1821; mul 0 1822; mul 2 1606; mul 25
1603; mul 415 1825; add 1824 1826; mul 18 1603; mul 15 1828; add 1827 1829; sub 1830 1615; mul 33 1636; add 1831
1832; mul 0 1833; mul 0 1834; add 1823 1835; mul 2 1297; mul 21 1743; add 1837 1838; mul 3 991; mul 549 1840; mul 11
1290; mul 548 1842; add 1841 1843; add 1839 1844; sub 1845 1310; mul 18 1365; add 1846 1847; mul 0 1848; mul 0 1849;
mul 0 1850; mul 2 1409; mul 21 1757; add 1852 1853; mul 561 1840; mul 11 1402; mul 548 1856; add 1855 1857; add 1854
1858; sub 1859 1420; mul 18 1457; add 1860 1861; mul 0 1862; mul 0 1863; mul 0 1864; add 1851 1865; mul 574 1840;
mul 0 1867; mul 0 1868; mul 0 1869; sub 1866 1870; mul 37 991; mul 337 1872; mul 37 1475; add 1873 1874; mul 34 991;
mul 373 1876; add 1875 1877; mul 34 1488; add 1878 1879; mul 15 1242; mul 30 991; add 1881 1882; mul 391 1883; add
1880 1884; mul 392 1242; mul 30 1498; add 1886 1887; add 1885 1888; mul 2 1500; add 1889 1890; mul 398 1242; add
1891 1892; mul 2 1505; add 1893 1894; mul 26 991; mul 509 1896; add 1895 1897; mul 26 1787; add 1898 1899; mul 15
1239; mul 22 991; add 1901 1902; mul 526 1903; add 1900 1904; mul 527 1239; mul 22 1797; add 1906 1907; add 1905
1908; mul 21 1799; add 1909 1910; mul 380 1239; add 1911 1912; add 1494 1913; mul 15 1237; mul 16 991; add 1915
1916; mul 636 1917; add 1914 1918; mul 639 1237; mul 636 991; mul 16 1921; add 1920 1922; add 1919 1923; mul 642
1840; mul 639 991; mul 15 1921; add 1926 1927; mul 548 1928; add 1925 1929; add 1924 1930; mul 647 1237; add 1931
1932; mul 650 1840; mul 647 991; mul 548 1935; add 1934 1936; add 1933 1937; mul 656 1840; add 1938 1939; mul 0
1940; mul 0 1941; mul 0 1942; add 1871 1943; mul 2 1537; mul 21 1816; add 1945 1946; mul 11 1531; mul 548 1948; add
1947 1949; add 1543 1950; mul 18 1564; add 1951 1952; mul 0 1953; mul 0 1954; mul 0 1955; mul 2 1609; mul 21 1828;
add 1957 1958; mul 11 1603; mul 548 1960; add 1959 1961; sub 1962 1615; mul 18 1636; add 1963 1964; mul 0 1965; mul
0 1966; mul 0 1967; add 1956 1968; mul 3 671; add 1530 1602; sub 1970 1971; mul 15 660; add 348 1973; mul 16 655;
add 1974 1975; mul 634 646; add 1976 1977; mul 15 634; mul 635 1979; add 1978 1980; mul 21 539; add 1981 1982; mul
22 534; add 1983 1984; mul 379 622; add 1985 1986; mul 15 622; mul 525 1988; add 1987 1989; mul 26 521; add 1990
1991; mul 515 615; add 1992 1993; mul 15 615; mul 508 1995; add 1994 1996; mul 481 501; add 1997 1998; mul 15 481;
mul 492 2000; add 1999 2001; mul 21 481; mul 482 2003; add 2002 2004; mul 2 409; add 2005 2006; mul 30 404; add 2007
2008; mul 397 600; add 2009 2010; mul 15 600; mul 390 2012; add 2011 2013; mul 34 386; add 2014 2015; mul 379 593;
add 2016 2017; mul 15 593; mul 372 2019; add 2018 2020; mul 367 460; add 2021 2022; mul 15 460; mul 360 2024; add
2023 2025; mul 21 460; mul 354 2027; add 2026 2028; mul 37 350; add 2029 2030; mul 343 584; add 2031 2032; mul 15
584; mul 336 2034; add 2033 2035; mul 331 451; add 2036 2037; mul 15 451; mul 324 2039; add 2038 2040; mul 21 451;
mul 318 2042; add 2041 2043; mul 276 311; add 2044 2045; mul 15 276; mul 300 2047; add 2046 2048; mul 21 276; mul
292 2050; add 2049 2051; mul 2 276; mul 277 2053; add 2052 2054; mul 278 2055; mul 10 10; mul 670 2057; add 2056
2058; mul 282 2059; mul 41 264; add 2060 2061; mul 207 207; add 216 2063; sub 2064 33; mul 213 2065; add 2062 2066;
mul 189 189; add 200 2068; sub 2069 33; mul 197 2070; add 2067 2071; mul 120 207; mul 121 2073; mul 73 189; mul 75
2075; add 2074 2076; mul 6 2077; sub 2072 2078; store gradient 0 413; store gradient 1 544; store gradient 2 666;
store gradient 3 673; store hessian 0 966; store hessian 4 1236; store hessian 8 1512; store hessian 12 1640; store
hessian 1 1236; store hessian 5 1737; store hessian 9 1811; store hessian 13 1836; store hessian 2 1512; store
hessian 6 1811; store hessian 10 1944; store hessian 14 1969; store hessian 3 1640; store hessian 7 1836; store
hessian 11 1969; store hessian 15 1972; store energy 0 2079
    """,
)

STATIC_SENSITIVITY = Graph(
    {'qm': 4, 'v_squared': 2, 'p': 41},
    {'gradient_p': 164},
    """
input qm 0; input p 0; mul 0 1; mul 2 2; mul 2 3; constant 5.333333333333333; input p 2; constant 0.5; input p 3;
mul 7 8; constant 1.0; div 10 1; mul 9 11; mul 6 12; mul 5 13; mul 4 14; mul 2 14; mul 3 16; add 15 17; constant
2.0; mul 2 19; mul 2 16; mul 20 21; add 18 22; input qm 1; mul 1 24; mul 1 25; constant 36.0; mul 13 27; mul 26 28;
mul 3 29; add 23 30; mul 2 29; mul 20 32; add 31 33; input qm 2; mul 1 35; mul 1 36; mul 1 37; constant 51.2; mul 13
39; mul 38 40; mul 3 41; add 34 42; mul 2 41; mul 20 44; add 43 45; constant -5.333333333333333; input p 8; mul 1
48; mul 47 49; mul 13 50; mul 3 51; add 46 52; mul 2 51; mul 20 54; add 53 55; constant 93.60000000000001; mul 13
57; mul 26 58; mul 26 59; mul 20 60; add 56 61; constant 272.0; mul 13 63; mul 38 64; mul 26 65; mul 20 66; add 62
67; constant -24.0; mul 49 69; mul 13 70; mul 26 71; mul 20 72; add 68 73; constant 201.14285714285714; mul 13 75;
mul 38 76; mul 38 77; mul 20 78; add 74 79; constant -32.0; mul 49 81; mul 13 82; mul 38 83; mul 20 84; add 80 85;
constant 4.0; constant 1.3333333333333333; mul 49 49; mul 88 89; add 87 90; mul 13 91; mul 20 92; add 86 93;
constant 108.0; mul 13 95; mul 26 96; mul 26 97; mul 26 98; add 94 99; constant 473.1428571428571; mul 13 101; mul
38 102; mul 26 103; mul 26 104; add 100 105; constant -36.0; mul 49 107; mul 13 108; mul 26 109; mul 26 110; add 106
111; constant 696.0; mul 13 113; mul 38 114; mul 38 115; mul 26 116; add 112 117; constant -96.0; mul 49 119; mul 13
120; mul 38 121; mul 26 122; add 118 123; constant 12.0; constant 3.0; mul 89 126; add 125 127; mul 13 128; mul 26
129; add 124 130; constant 341.3333333333333; mul 13 132; mul 38 133; mul 38 134; mul 38 135; add 131 136; constant
-64.0; mul 49 138; mul 13 139; mul 38 140; mul 38 141; add 137 142; constant 16.0; constant 3.2; mul 89 145; add 144
146; mul 13 147; mul 38 148; add 143 149; constant -4.0; mul 49 151; mul 13 152; add 150 153; mul 1 13; mul 151 155;
mul 19 49; mul 1 38; mul 13 158; mul 145 159; mul 157 160; add 156 161; mul 38 158; mul 13 163; mul 138 164; add 162
165; mul 1 26; mul 13 167; mul 126 168; mul 157 169; add 166 170; mul 38 167; mul 13 172; mul 119 173; add 171 174;
mul 26 167; mul 13 176; mul 107 177; add 175 178; mul 1 20; mul 13 180; mul 88 181; mul 157 182; add 179 183; mul 38
180; mul 13 185; mul 81 186; add 184 187; mul 26 180; mul 13 189; mul 69 190; add 188 191; mul 2 180; mul 1 3; add
193 194; mul 13 195; mul 47 196; add 192 197; mul 48 198; add 154 199; mul 1 148; mul 1 141; add 201 202; mul 140
158; add 203 204; mul 1 135; add 205 206; mul 134 158; add 207 208; mul 133 163; add 209 210; mul 121 167; add 211
212; mul 115 167; add 213 214; mul 114 172; add 215 216; mul 102 176; add 217 218; mul 83 180; add 219 220; mul 77
180; add 221 222; mul 76 185; add 223 224; mul 64 189; add 225 226; mul 40 195; add 227 228; mul 37 229; add 200
230; mul 1 229; mul 36 232; add 231 233; mul 1 232; mul 35 235; add 234 236; mul 1 129; mul 1 122; add 238 239; mul
1 116; add 240 241; mul 1 110; add 242 243; mul 109 167; add 244 245; mul 1 104; add 246 247; mul 103 167; add 248
249; mul 1 98; add 250 251; mul 97 167; add 252 253; mul 96 176; add 254 255; mul 71 180; add 256 257; mul 65 180;
add 258 259; mul 59 180; add 260 261; mul 58 189; add 262 263; mul 28 195; add 264 265; mul 25 266; add 237 267; mul
1 266; mul 24 269; add 268 270; mul 11 12; mul 1 152; mul 147 158; add 273 274; mul 139 163; add 275 276; mul 38
163; mul 132 278; add 277 279; mul 128 167; add 280 281; mul 120 172; add 282 283; mul 38 172; mul 113 285; add 284
286; mul 108 176; add 287 288; mul 38 176; mul 101 290; add 289 291; mul 26 176; mul 95 293; add 292 294; mul 91
180; add 295 296; mul 82 185; add 297 298; mul 38 185; mul 75 300; add 299 301; mul 70 189; add 302 303; mul 38 189;
mul 63 305; add 304 306; mul 26 189; mul 57 308; add 307 309; mul 50 195; add 310 311; mul 38 195; mul 39 313; add
312 314; mul 26 195; mul 27 316; add 315 317; mul 2 195; mul 1 4; add 319 320; mul 5 321; add 318 322; mul 6 323;
mul 272 324; sub 271 325; mul 1 92; mul 19 327; mul 1 84; mul 19 329; add 328 330; mul 1 78; mul 19 332; add 331
333; mul 1 72; mul 19 335; add 334 336; mul 1 66; mul 19 338; add 337 339; mul 1 60; mul 19 341; add 340 342; mul 51
180; add 343 344; mul 1 54; mul 19 346; add 345 347; mul 1 51; mul 20 349; add 348 350; mul 41 180; add 351 352; mul
1 44; mul 19 354; add 353 355; mul 1 41; mul 20 357; add 356 358; mul 29 180; add 359 360; mul 1 32; mul 19 362; add
361 363; mul 1 29; mul 20 365; add 364 366; mul 16 180; add 367 368; mul 1 21; mul 19 370; add 369 371; mul 14 195;
add 372 373; mul 1 14; mul 3 375; add 374 376; mul 1 16; mul 2 375; add 378 379; mul 20 380; add 377 381; mul 0 382;
add 326 383; mul 1 7; input p 6; input p 7; mul 386 387; mul 385 388; mul 88 389; mul 20 390; mul 126 389; mul 26
392; add 391 393; mul 145 389; mul 38 395; add 394 396; sub 384 397; mul 1 395; mul 37 399; sub 398 400; mul 1 399;
mul 36 402; sub 401 403; mul 1 402; mul 35 405; sub 404 406; mul 1 392; mul 25 408; sub 407 409; mul 1 408; mul 24
411; sub 410 412; mul 145 158; mul 126 167; add 414 415; mul 88 180; add 416 417; mul 388 418; mul 7 419; sub 413
420; mul 1 390; neg 422; mul 19 423; mul 0 424; add 421 425; input p 29; sub 427 1; input qm 3; constant
2.2857142857142856; mul 38 38; mul 430 431; mul 26 38; mul 87 433; add 432 434; constant 1.8; mul 26 26; mul 436
437; add 435 438; mul 2 38; mul 145 440; add 439 441; mul 2 26; mul 126 443; add 442 444; mul 3 88; add 445 446; mul
385 447; sub 429 448; sub 428 449; input p 27; input p 28; sub 451 452; mul 26 126; add 20 454; mul 38 87; add 455
456; mul 457 457; add 10 458; sqrt 459; div 10 460; mul 453 461; add 450 462; input p 26; mul 457 461; mul 464 465;
add 463 466; mul 19 467; mul 453 465; mul 461 464; input p 30; sub 470 471; sub 469 472; add 2 26; add 38 474; mul 1
475; sub 473 476; mul 477 477; mul 467 467; add 478 479; sqrt 480; input p 31; div 10 482; mul 481 483; mul 19 484;
input p 32; input p 34; mul 486 487; input p 33; mul 488 489; input p 37; mul 490 491; constant 6.0; div 10 493; mul
492 494; mul 485 495; div 10 484; mul 19 497; mul 497 498; mul 495 499; sub 496 500; mul 483 501; mul 19 481; div 10
503; mul 502 504; mul 468 505; input p 14; sub 507 1; sub 508 449; input p 12; input p 13; sub 510 511; mul 461 512;
add 509 513; input p 11; mul 465 515; sub 514 516; mul 19 517; mul 461 515; input p 15; sub 519 520; mul 465 512;
add 521 522; sub 523 476; mul 524 524; mul 517 517; add 525 526; sqrt 527; input p 16; div 10 529; mul 528 530; mul
19 531; input p 17; input p 19; mul 533 534; input p 18; mul 535 536; input p 22; mul 537 538; mul 494 539; mul 532
540; div 10 531; mul 19 542; mul 542 543; mul 540 544; sub 541 545; mul 530 546; mul 19 528; div 10 548; mul 547
549; mul 518 550; add 506 551; mul 385 552; mul 88 553; mul 20 554; mul 126 553; mul 26 556; add 555 557; mul 145
553; mul 38 559; add 558 560; mul 19 477; mul 505 562; mul 19 524; mul 550 564; add 563 565; mul 1 566; sub 561 567;
mul 464 506; mul 453 563; add 569 570; mul 515 551; sub 571 572; mul 512 565; add 573 574; mul 461 575; mul 19 457;
mul 461 470; mul 563 578; mul 461 462; mul 506 580; sub 579 581; mul 461 513; mul 551 583; sub 582 584; mul 461 465;
mul 575 586; sub 585 587; mul 461 519; mul 565 589; sub 588 590; mul 19 460; div 10 592; mul 591 593; mul 577 594;
add 576 595; mul 19 596; add 568 597; add 426 598; sub 599 567; mul 549 550; mul 1 19; mul 461 602; mul 577 602; mul
593 604; mul 586 605; sub 603 606; mul 512 607; mul 589 605; sub 608 609; mul 1 1; sub 610 611; mul 564 612; mul 385
418; mul 583 605; mul 515 607; add 615 616; sub 614 617; mul 518 618; add 613 619; mul 601 620; neg 621; mul 19 622;
mul 542 544; mul 549 620; mul 530 625; mul 540 626; mul 624 627; mul 542 627; mul 544 629; add 628 630; mul 19 627;
add 631 632; mul 530 633; add 623 634; mul 549 635; mul 518 636; mul 550 618; mul 19 638; add 637 639; sub 600 640;
mul 550 612; mul 19 642; mul 564 636; add 643 644; mul 578 605; mul 453 607; add 646 647; sub 648 611; mul 505 649;
mul 19 650; mul 504 505; mul 562 649; mul 464 607; mul 580 605; sub 654 655; add 614 656; mul 468 657; add 653 658;
mul 652 659; neg 660; mul 19 661; mul 497 499; mul 504 659; mul 483 664; mul 495 665; mul 663 666; mul 497 666; mul
499 668; add 667 669; mul 19 666; add 670 671; mul 483 672; add 662 673; mul 504 674; mul 562 675; add 651 676; add
645 677; mul 475 678; sub 641 679; mul 1 556; mul 1 678; sub 681 682; mul 594 602; mul 19 684; mul 512 645; mul 575
605; mul 461 687; sub 686 688; mul 515 640; sub 689 690; mul 453 677; add 691 692; mul 468 675; mul 505 657; mul 19
695; add 694 696; mul 464 697; add 693 698; mul 461 699; add 685 700; mul 593 594; mul 604 702; neg 703; mul 19 704;
mul 461 589; mul 565 605; mul 706 707; add 705 708; mul 461 586; mul 687 710; add 709 711; mul 461 583; mul 551 605;
mul 713 714; add 712 715; mul 461 580; mul 506 605; mul 717 718; add 716 719; mul 461 578; mul 563 605; mul 721 722;
sub 720 723; mul 461 576; mul 602 725; sub 724 726; mul 461 707; sub 645 728; mul 589 729; sub 727 730; mul 461 714;
sub 640 732; mul 583 733; sub 731 734; mul 461 722; sub 736 677; mul 578 737; sub 735 738; mul 586 699; sub 739 740;
mul 461 718; sub 697 742; mul 580 743; sub 741 744; mul 593 745; mul 577 746; add 701 747; mul 126 748; add 683 749;
add 640 697; mul 385 751; mul 126 752; mul 2 753; add 750 754; mul 19 26; mul 436 752; mul 756 757; add 755 758; mul
87 752; mul 38 760; add 759 761; mul 25 762; add 680 763; mul 1 762; mul 24 765; add 764 766; mul 1 559; sub 768
682; mul 87 748; add 769 770; mul 145 752; mul 2 772; add 771 773; mul 26 760; add 774 775; mul 19 38; mul 430 752;
mul 777 778; add 776 779; mul 37 780; add 767 781; mul 1 780; mul 36 783; add 782 784; mul 1 783; mul 35 786; add
785 787; sub 788 697; mul 418 552; mul 447 751; add 790 791; mul 7 792; add 789 793; mul 19 748; sub 795 682; mul 88
752; mul 20 797; add 796 798; mul 26 753; add 799 800; mul 38 772; add 801 802; mul 1 554; mul 19 804; add 803 805;
mul 0 806; add 794 807; constant 8.854e-12; mul 486 809; input p 36; mul 810 811; input p 35; mul 812 813; mul 487
814; div 10 489; mul 815 816; constant -0.5; input v_squared 1; mul 818 819; mul 817 820; mul 483 821; mul 504 822;
mul 468 823; mul 533 809; input p 21; mul 825 826; input p 20; mul 827 828; mul 534 829; div 10 536; mul 830 831;
input v_squared 0; mul 818 833; mul 832 834; mul 530 835; mul 549 836; mul 518 837; add 824 838; mul 385 839; mul 88
840; mul 20 841; mul 126 840; mul 26 843; add 842 844; mul 145 840; mul 38 846; add 845 847; mul 562 823; mul 564
837; add 849 850; mul 1 851; sub 848 852; mul 464 824; mul 453 849; add 854 855; mul 515 838; sub 856 857; mul 512
850; add 858 859; mul 461 860; mul 578 849; mul 580 824; sub 862 863; mul 583 838; sub 864 865; mul 586 860; sub 866
867; mul 589 850; sub 868 869; mul 593 870; mul 577 871; add 861 872; mul 19 873; add 853 874; add 808 875; sub 876
852; mul 618 837; mul 19 878; mul 549 837; mul 620 880; div 10 528; mul 881 882; mul 518 883; sub 879 884; sub 877
885; mul 612 837; mul 19 887; mul 564 883; sub 888 889; mul 649 823; mul 19 891; mul 504 823; mul 659 893; div 10
481; mul 894 895; mul 562 896; sub 892 897; add 890 898; mul 475 899; sub 886 900; mul 1 843; mul 1 899; sub 902
903; mul 602 871; mul 19 905; mul 512 890; mul 605 860; mul 461 908; sub 907 909; mul 515 885; sub 910 911; mul 453
898; add 912 913; mul 657 823; mul 19 915; mul 468 896; sub 916 917; mul 464 918; add 914 919; mul 461 920; add 906
921; mul 593 871; mul 604 923; neg 924; mul 19 925; mul 605 850; mul 706 927; add 926 928; mul 710 908; add 929 930;
mul 605 838; mul 713 932; add 931 933; mul 605 824; mul 717 935; add 934 936; mul 605 849; mul 721 938; sub 937 939;
mul 461 861; mul 602 941; sub 940 942; mul 461 927; sub 890 944; mul 589 945; sub 943 946; mul 461 932; sub 885 948;
mul 583 949; sub 947 950; mul 461 938; sub 952 898; mul 578 953; sub 951 954; mul 586 920; sub 955 956; mul 461 935;
sub 918 958; mul 580 959; sub 957 960; mul 593 961; mul 577 962; add 922 963; mul 126 964; add 904 965; add 885 918;
mul 385 967; mul 126 968; mul 2 969; add 966 970; mul 436 968; mul 756 972; add 971 973; mul 87 968; mul 38 975; add
974 976; mul 25 977; add 901 978; mul 1 977; mul 24 980; add 979 981; mul 1 846; sub 983 903; mul 87 964; add 984
985; mul 145 968; mul 2 987; add 986 988; mul 26 975; add 989 990; mul 430 968; mul 777 992; add 991 993; mul 37
994; add 982 995; mul 1 994; mul 36 997; add 996 998; mul 1 997; mul 35 1000; add 999 1001; sub 1002 918; mul 418
839; mul 447 967; add 1004 1005; mul 7 1006; add 1003 1007; mul 19 964; sub 1009 903; mul 88 968; mul 20 1011; add
1010 1012; mul 26 969; add 1013 1014; mul 38 987; add 1015 1016; mul 1 841; mul 19 1018; add 1017 1019; mul 0 1020;
add 1008 1021; mul 4 28; mul 3 26; mul 58 1024; add 1023 1025; mul 3 59; add 1026 1027; mul 3 65; add 1028 1029; mul
3 71; add 1030 1031; mul 26 443; mul 96 1033; add 1032 1034; mul 97 443; add 1035 1036; mul 2 98; add 1037 1038; mul
103 443; add 1039 1040; mul 2 104; add 1041 1042; mul 109 443; add 1043 1044; mul 2 110; add 1045 1046; mul 2 116;
add 1047 1048; mul 2 122; add 1049 1050; mul 2 129; add 1051 1052; mul 26 437; constant 46.285714285714285; mul 13
1055; mul 1054 1056; add 1053 1057; mul 26 1056; mul 437 1059; add 1058 1060; mul 26 1059; mul 756 1062; add 1061
1063; constant 270.0; mul 13 1065; mul 38 1066; mul 437 1067; add 1064 1068; mul 26 1067; mul 756 1070; add 1069
1071; constant -18.0; mul 49 1073; mul 13 1074; mul 437 1075; add 1072 1076; mul 26 1075; mul 756 1078; add 1077
1079; constant 592.0; mul 13 1081; mul 38 1082; mul 38 1083; mul 756 1084; add 1080 1085; constant -72.0; mul 49
1087; mul 13 1088; mul 38 1089; mul 756 1090; add 1086 1091; mul 89 436; add 125 1093; mul 13 1094; mul 756 1095;
add 1092 1096; constant 576.0; mul 13 1098; mul 38 1099; mul 38 1100; mul 38 1101; add 1097 1102; mul 38 122; add
1103 1104; mul 87 89; add 27 1106; mul 13 1107; mul 38 1108; add 1105 1109; constant -6.0; mul 49 1111; mul 13 1112;
add 1110 1113; mul 1 1114; mul 19 1115; mul 2 392; mul 389 436; mul 756 1118; add 1117 1119; mul 87 389; mul 38
1121; add 1120 1122; mul 1 1123; sub 1116 1124; sub 1125 1124; mul 2 556; mul 436 553; mul 756 1128; add 1127 1129;
mul 87 553; mul 38 1131; add 1130 1132; sub 1133 567; mul 126 596; add 1134 1135; mul 1 1136; add 1126 1137; add
1137 1138; mul 2 843; mul 436 840; mul 756 1141; add 1140 1142; mul 87 840; mul 38 1144; add 1143 1145; sub 1146
852; mul 126 873; add 1147 1148; mul 1 1149; add 1139 1150; add 1150 1151; mul 13 611; mul 1111 1153; mul 38 611;
mul 13 1155; mul 87 1156; mul 157 1157; add 1154 1158; mul 38 1155; mul 13 1160; mul 119 1161; add 1159 1162; mul
611 756; mul 13 1164; mul 436 1165; mul 157 1166; add 1163 1167; mul 38 1164; mul 13 1169; mul 1087 1170; add 1168
1171; mul 26 1164; mul 437 611; add 1173 1174; mul 13 1175; mul 1073 1176; add 1172 1177; mul 2 611; mul 13 1179;
mul 126 1180; mul 157 1181; add 1178 1182; mul 38 1179; mul 13 1184; mul 119 1185; add 1183 1186; mul 443 611; mul
26 1179; add 1188 1189; mul 13 1190; mul 107 1191; add 1187 1192; mul 3 611; mul 13 1194; mul 69 1195; add 1193
1196; mul 48 1197; add 1152 1198; mul 611 1108; mul 122 611; add 1200 1201; mul 121 1155; add 1202 1203; mul 611
1101; add 1204 1205; mul 1100 1155; add 1206 1207; mul 1099 1160; add 1208 1209; mul 1089 1164; add 1210 1211; mul
1083 1164; add 1212 1213; mul 1082 1169; add 1214 1215; mul 1066 1175; add 1216 1217; mul 121 1179; add 1218 1219;
mul 115 1179; add 1220 1221; mul 114 1184; add 1222 1223; mul 102 1190; add 1224 1225; mul 64 1194; add 1226 1227;
mul 37 1228; add 1199 1229; mul 1 1228; mul 36 1231; add 1230 1232; mul 1 1231; mul 35 1234; add 1233 1235; mul 611
1095; mul 19 1237; mul 611 1090; mul 19 1239; add 1238 1240; mul 611 1084; mul 19 1242; add 1241 1243; mul 1075
1164; add 1244 1245; mul 611 1078; mul 19 1247; add 1246 1248; mul 611 1075; mul 756 1250; add 1249 1251; mul 1067
1164; add 1252 1253; mul 611 1070; mul 19 1255; add 1254 1256; mul 611 1067; mul 756 1258; add 1257 1259; mul 1059
1164; add 1260 1261; mul 611 1062; mul 19 1263; add 1262 1264; mul 1056 1175; add 1265 1266; mul 611 1056; mul 437
1268; add 1267 1269; mul 611 1059; mul 26 1268; add 1271 1272; mul 756 1273; add 1270 1274; mul 109 611; mul 2 1276;
add 1275 1277; mul 103 611; mul 2 1279; add 1278 1280; mul 96 611; mul 443 1282; add 1281 1283; mul 97 611; mul 26
1282; add 1285 1286; mul 2 1287; add 1284 1288; mul 58 611; mul 3 1290; add 1289 1291; mul 109 1179; add 1292 1293;
mul 103 1179; add 1294 1295; mul 97 1179; add 1296 1297; mul 96 1190; add 1298 1299; mul 58 1194; add 1300 1301; mul
25 1302; add 1236 1303; mul 1 1302; mul 24 1305; add 1304 1306; mul 611 1112; mul 1107 1155; add 1308 1309; mul 120
1160; add 1310 1311; mul 38 1160; mul 1098 1313; add 1312 1314; mul 1094 1164; add 1315 1316; mul 1088 1169; add
1317 1318; mul 38 1169; mul 1081 1320; add 1319 1321; mul 1074 1175; add 1322 1323; mul 38 1175; mul 1065 1325; add
1324 1326; mul 26 1175; mul 611 1054; add 1328 1329; mul 1055 1330; add 1327 1331; mul 128 1179; add 1332 1333; mul
120 1184; add 1334 1335; mul 38 1184; mul 113 1337; add 1336 1338; mul 108 1190; add 1339 1340; mul 38 1190; mul 101
1342; add 1341 1343; mul 611 1033; mul 26 1190; add 1345 1346; mul 95 1347; add 1344 1348; mul 70 1194; add 1349
1350; mul 38 1194; mul 63 1352; add 1351 1353; mul 611 1024; mul 26 1194; add 1355 1356; mul 57 1357; add 1354 1358;
mul 4 611; mul 27 1360; add 1359 1361; mul 6 1362; mul 272 1363; sub 1307 1364; mul 129 611; add 1201 1366; mul 116
611; add 1367 1368; mul 110 611; add 1369 1370; mul 26 1276; add 1371 1372; mul 104 611; add 1373 1374; mul 26 1279;
add 1375 1376; mul 98 611; add 1377 1378; mul 26 1287; add 1379 1380; mul 71 611; mul 20 1382; add 1381 1383; mul 65
611; mul 20 1385; add 1384 1386; mul 59 611; mul 26 1290; add 1388 1389; mul 20 1390; add 1387 1391; mul 28 611; mul
3 1393; add 1392 1394; mul 2 1393; mul 20 1396; add 1395 1397; mul 0 1398; add 1365 1399; mul 611 1121; mul 37 1401;
sub 1400 1402; mul 1 1401; mul 36 1404; sub 1403 1405; mul 1 1404; mul 35 1407; sub 1406 1408; mul 611 1118; neg
1410; mul 19 1411; mul 25 1412; add 1409 1413; mul 1 1412; mul 24 1415; add 1414 1416; mul 87 1155; mul 436 1164;
add 1418 1419; mul 126 1179; add 1420 1421; mul 388 1422; mul 7 1423; sub 1417 1424; mul 392 611; mul 0 1426; sub
1425 1427; mul 566 611; sub 1428 1429; mul 126 611; mul 461 1431; mul 577 1431; mul 593 1433; mul 586 1434; sub 1432
1435; mul 512 1436; mul 589 1434; sub 1437 1438; mul 1 611; sub 1439 1440; mul 564 1441; mul 385 1422; mul 583 1434;
mul 515 1436; add 1444 1445; sub 1443 1446; mul 518 1447; add 1442 1448; mul 601 1449; neg 1450; mul 19 1451; mul
549 1449; mul 530 1453; mul 540 1454; mul 624 1455; mul 542 1455; mul 544 1457; add 1456 1458; mul 19 1455; add 1459
1460; mul 530 1461; add 1452 1462; mul 549 1463; mul 518 1464; mul 550 1447; mul 19 1466; add 1465 1467; sub 1430
1468; mul 550 1441; mul 19 1470; mul 564 1464; add 1471 1472; mul 578 1434; mul 453 1436; add 1474 1475; sub 1476
1440; mul 505 1477; mul 19 1478; mul 562 1477; mul 464 1436; mul 580 1434; sub 1481 1482; add 1443 1483; mul 468
1484; add 1480 1485; mul 652 1486; neg 1487; mul 19 1488; mul 504 1486; mul 483 1490; mul 495 1491; mul 663 1492;
mul 497 1492; mul 499 1494; add 1493 1495; mul 19 1492; add 1496 1497; mul 483 1498; add 1489 1499; mul 504 1500;
mul 562 1501; add 1479 1502; add 1473 1503; mul 475 1504; sub 1469 1505; mul 611 1128; mul 19 1507; mul 1 1504; sub
1508 1509; mul 594 1431; mul 19 1511; mul 512 1473; mul 575 1434; mul 461 1514; sub 1513 1515; mul 515 1468; sub
1516 1517; mul 453 1503; add 1518 1519; mul 468 1501; mul 505 1484; mul 19 1522; add 1521 1523; mul 464 1524; add
1520 1525; mul 461 1526; add 1512 1527; mul 702 1433; neg 1529; mul 19 1530; mul 565 1434; mul 706 1532; add 1531
1533; mul 710 1514; add 1534 1535; mul 551 1434; mul 713 1537; add 1536 1538; mul 506 1434; mul 717 1540; add 1539
1541; mul 563 1434; mul 721 1543; sub 1542 1544; mul 725 1431; sub 1545 1546; mul 461 1532; sub 1473 1548; mul 589
1549; sub 1547 1550; mul 461 1537; sub 1468 1552; mul 583 1553; sub 1551 1554; mul 461 1543; sub 1556 1503; mul 578
1557; sub 1555 1558; mul 586 1526; sub 1559 1560; mul 461 1540; sub 1524 1562; mul 580 1563; sub 1561 1564; mul 593
1565; mul 577 1566; add 1528 1567; mul 126 1568; add 1510 1569; add 1468 1524; mul 385 1571; mul 126 1572; mul 2
1573; add 1570 1574; mul 436 1572; mul 756 1576; add 1575 1577; mul 87 1572; mul 38 1579; add 1578 1580; mul 25
1581; add 1506 1582; mul 1 1581; mul 24 1584; add 1583 1585; mul 611 1131; sub 1587 1509; mul 87 1568; add 1588
1589; mul 145 1572; mul 2 1591; add 1590 1592; mul 26 1579; add 1593 1594; mul 430 1572; mul 777 1596; add 1595
1597; mul 37 1598; add 1586 1599; mul 1 1598; mul 36 1601; add 1600 1602; mul 1 1601; mul 35 1604; add 1603 1605;
sub 1606 1524; mul 552 1422; mul 447 1571; add 1608 1609; mul 7 1610; add 1607 1611; mul 556 611; sub 1613 1509; mul
19 1568; add 1614 1615; mul 88 1572; mul 20 1617; add 1616 1618; mul 26 1573; add 1619 1620; mul 38 1591; add 1621
1622; mul 0 1623; add 1612 1624; mul 611 851; sub 1625 1626; mul 837 1447; mul 19 1628; mul 880 1449; mul 882 1630;
mul 518 1631; sub 1629 1632; sub 1627 1633; mul 837 1441; mul 19 1635; mul 564 1631; sub 1636 1637; mul 823 1477;
mul 19 1639; mul 893 1486; mul 895 1641; mul 562 1642; sub 1640 1643; add 1638 1644; mul 475 1645; sub 1634 1646;
mul 611 1141; mul 19 1648; mul 1 1645; sub 1649 1650; mul 871 1431; mul 19 1652; mul 512 1638; mul 860 1434; mul 461
1655; sub 1654 1656; mul 515 1633; sub 1657 1658; mul 453 1644; add 1659 1660; mul 823 1484; mul 19 1662; mul 468
1642; sub 1663 1664; mul 464 1665; add 1661 1666; mul 461 1667; add 1653 1668; mul 923 1433; neg 1670; mul 19 1671;
mul 850 1434; mul 706 1673; add 1672 1674; mul 710 1655; add 1675 1676; mul 838 1434; mul 713 1678; add 1677 1679;
mul 824 1434; mul 717 1681; add 1680 1682; mul 849 1434; mul 721 1684; sub 1683 1685; mul 941 1431; sub 1686 1687;
mul 461 1673; sub 1638 1689; mul 589 1690; sub 1688 1691; mul 461 1678; sub 1633 1693; mul 583 1694; sub 1692 1695;
mul 461 1684; sub 1697 1644; mul 578 1698; sub 1696 1699; mul 586 1667; sub 1700 1701; mul 461 1681; sub 1665 1703;
mul 580 1704; sub 1702 1705; mul 593 1706; mul 577 1707; add 1669 1708; mul 126 1709; add 1651 1710; add 1633 1665;
mul 385 1712; mul 126 1713; mul 2 1714; add 1711 1715; mul 436 1713; mul 756 1717; add 1716 1718; mul 87 1713; mul
38 1720; add 1719 1721; mul 25 1722; add 1647 1723; mul 1 1722; mul 24 1725; add 1724 1726; mul 611 1144; sub 1728
1650; mul 87 1709; add 1729 1730; mul 145 1713; mul 2 1732; add 1731 1733; mul 26 1720; add 1734 1735; mul 430 1713;
mul 777 1737; add 1736 1738; mul 37 1739; add 1727 1740; mul 1 1739; mul 36 1742; add 1741 1743; mul 1 1742; mul 35
1745; add 1744 1746; sub 1747 1665; mul 839 1422; mul 447 1712; add 1749 1750; mul 7 1751; add 1748 1752; mul 611
843; sub 1754 1650; mul 19 1709; add 1755 1756; mul 88 1713; mul 20 1758; add 1757 1759; mul 26 1714; add 1760 1761;
mul 38 1732; add 1762 1763; mul 0 1764; add 1753 1765; mul 4 40; mul 64 1024; add 1767 1768; mul 3 38; mul 76 1770;
add 1769 1771; mul 3 77; add 1772 1773; mul 3 83; add 1774 1775; mul 102 1033; add 1776 1777; mul 38 443; mul 114
1779; add 1778 1780; mul 115 443; add 1781 1782; mul 121 443; add 1783 1784; mul 38 440; mul 133 1786; add 1785
1787; mul 134 440; add 1788 1789; mul 2 135; add 1790 1791; mul 140 440; add 1792 1793; mul 2 141; add 1794 1795;
mul 2 148; add 1796 1797; mul 1054 1066; add 1798 1799; mul 38 437; mul 1082 1801; add 1800 1802; mul 437 1083; add
1803 1804; mul 437 1089; add 1805 1806; mul 38 433; mul 1099 1808; add 1807 1809; mul 433 1100; add 1810 1811; mul
26 1101; add 1812 1813; mul 121 433; add 1814 1815; add 123 1816; mul 26 1108; add 1817 1818; mul 38 431; constant
209.45454545454547; mul 13 1821; mul 1820 1822; add 1819 1823; mul 38 1822; mul 431 1825; add 1824 1826; mul 38
1825; mul 777 1828; add 1827 1829; constant -42.666666666666664; mul 49 1831; mul 13 1832; mul 431 1833; add 1830
1834; mul 38 1833; mul 777 1836; add 1835 1837; constant 28.8; mul 89 430; add 1839 1840; mul 13 1841; mul 777 1842;
add 1838 1843; constant -8.0; mul 49 1845; mul 13 1846; add 1844 1847; mul 1 1848; mul 1 1849; mul 19 1850; mul 611
1848; add 1851 1852; mul 2 395; mul 26 1121; add 1854 1855; mul 389 430; mul 777 1857; add 1856 1858; mul 1 1859;
mul 1 1860; sub 1853 1861; sub 1862 1861; mul 611 1859; sub 1863 1864; mul 2 559; mul 26 1131; add 1866 1867; mul
430 553; mul 777 1869; add 1868 1870; sub 1871 567; mul 87 596; add 1872 1873; mul 1 1874; mul 1 1875; add 1865
1876; add 1876 1877; mul 611 1874; add 1878 1879; mul 2 846; mul 26 1144; add 1881 1882; mul 430 840; mul 777 1884;
add 1883 1885; sub 1886 852; mul 87 873; add 1887 1888; mul 1 1889; mul 1 1890; add 1880 1891; add 1891 1892; mul
611 1889; add 1893 1894; mul 13 1440; mul 1845 1896; mul 777 1440; mul 13 1898; mul 430 1899; mul 157 1900; add 1897
1901; mul 38 1898; mul 431 1440; add 1903 1904; mul 13 1905; mul 1831 1906; add 1902 1907; mul 26 1440; mul 13 1909;
mul 87 1910; mul 157 1911; add 1908 1912; mul 433 1440; mul 38 1909; add 1914 1915; mul 13 1916; mul 119 1917; add
1913 1918; mul 437 1440; mul 13 1920; mul 1087 1921; add 1919 1922; mul 2 1440; mul 13 1924; mul 145 1925; mul 157
1926; add 1923 1927; mul 440 1440; mul 38 1924; add 1929 1930; mul 13 1931; mul 138 1932; add 1928 1933; mul 443
1440; mul 13 1935; mul 119 1936; add 1934 1937; mul 3 1440; mul 13 1939; mul 81 1940; add 1938 1941; mul 48 1942;
add 1895 1943; mul 1440 1842; mul 19 1945; mul 1833 1898; add 1946 1947; mul 1440 1836; mul 19 1949; add 1948 1950;
mul 1440 1833; mul 777 1952; add 1951 1953; mul 1825 1898; add 1954 1955; mul 1440 1828; mul 19 1957; add 1956 1958;
mul 1822 1905; add 1959 1960; mul 1440 1822; mul 431 1962; add 1961 1963; mul 1440 1825; mul 38 1962; add 1965 1966;
mul 777 1967; add 1964 1968; mul 121 1440; mul 26 1970; add 1969 1971; mul 1099 1440; mul 433 1973; add 1972 1974;
mul 1100 1440; mul 38 1973; add 1976 1977; mul 26 1978; add 1975 1979; mul 1082 1440; mul 437 1981; add 1980 1982;
mul 140 1440; mul 2 1984; add 1983 1985; mul 133 1440; mul 440 1987; add 1986 1988; mul 134 1440; mul 38 1987; add
1990 1991; mul 2 1992; add 1989 1993; mul 114 1440; mul 443 1995; add 1994 1996; mul 76 1440; mul 3 1998; add 1997
1999; mul 121 1909; add 2000 2001; mul 1100 1909; add 2002 2003; mul 1099 1916; add 2004 2005; mul 1082 1920; add
2006 2007; mul 140 1924; add 2008 2009; mul 134 1924; add 2010 2011; mul 133 1931; add 2012 2013; mul 114 1935; add
2014 2015; mul 76 1939; add 2016 2017; mul 37 2018; add 1944 2019; mul 1 2018; mul 36 2021; add 2020 2022; mul 1
2021; mul 35 2024; add 2023 2025; mul 1108 1440; mul 122 1440; add 2027 2028; mul 38 1970; add 2029 2030; mul 1101
1440; add 2031 2032; mul 38 1978; add 2033 2034; mul 1089 1440; mul 756 2036; add 2035 2037; mul 1083 1440; mul 38
1981; add 2039 2040; mul 756 2041; add 2038 2042; mul 1066 1440; mul 437 2044; add 2043 2045; mul 2 1970; add 2046
2047; mul 115 1440; mul 38 1995; add 2049 2050; mul 2 2051; add 2048 2052; mul 102 1440; mul 443 2054; add 2053
2055; mul 64 1440; mul 3 2057; add 2056 2058; mul 26 2044; mul 756 2060; add 2059 2061; mul 26 2054; mul 2 2063; add
2062 2064; mul 25 2065; add 2026 2066; mul 1 2065; mul 24 2068; add 2067 2069; mul 1440 1846; mul 1841 1898; add
2071 2072; mul 1832 1905; add 2073 2074; mul 38 1905; mul 1440 1820; add 2076 2077; mul 1821 2078; add 2075 2079;
mul 1107 1909; add 2080 2081; mul 120 1916; add 2082 2083; mul 1440 1808; mul 38 1916; add 2085 2086; mul 1098 2087;
add 2084 2088; mul 1088 1920; add 2089 2090; mul 1440 1801; mul 38 1920; add 2092 2093; mul 1081 2094; add 2091
2095; mul 1054 1440; mul 1065 2097; add 2096 2098; mul 147 1924; add 2099 2100; mul 139 1931; add 2101 2102; mul
1440 1786; mul 38 1931; add 2104 2105; mul 132 2106; add 2103 2107; mul 120 1935; add 2108 2109; mul 1440 1779; mul
38 1935; add 2111 2112; mul 113 2113; add 2110 2114; mul 1033 1440; mul 101 2116; add 2115 2117; mul 82 1939; add
2118 2119; mul 1440 1770; mul 38 1939; add 2121 2122; mul 75 2123; add 2120 2124; mul 1024 1440; mul 63 2126; add
2125 2127; mul 4 1440; mul 39 2129; add 2128 2130; mul 6 2131; mul 272 2132; sub 2070 2133; mul 148 1440; mul 141
1440; add 2135 2136; mul 38 1984; add 2137 2138; mul 135 1440; add 2139 2140; mul 38 1992; add 2141 2142; add 1971
2143; mul 26 2051; add 2144 2145; mul 83 1440; mul 20 2147; add 2146 2148; mul 77 1440; mul 38 1998; add 2150 2151;
mul 20 2152; add 2149 2153; mul 40 1440; mul 3 2155; add 2154 2156; mul 26 2063; add 2157 2158; mul 26 2057; mul 20
2160; add 2159 2161; mul 2 2155; mul 20 2163; add 2162 2164; mul 0 2165; add 2134 2166; mul 1440 1857; neg 2168; mul
19 2169; mul 37 2170; add 2167 2171; mul 1 2170; mul 36 2173; add 2172 2174; mul 1 2173; mul 35 2176; add 2175 2177;
mul 1121 1440; mul 25 2179; sub 2178 2180; mul 1 2179; mul 24 2182; sub 2181 2183; mul 430 1898; mul 87 1909; add
2185 2186; mul 145 1924; add 2187 2188; mul 388 2189; mul 7 2190; sub 2184 2191; mul 395 1440; mul 0 2193; sub 2192
2194; mul 566 1440; sub 2195 2196; mul 87 1440; mul 461 2198; mul 577 2198; mul 593 2200; mul 586 2201; sub 2199
2202; mul 512 2203; mul 589 2201; sub 2204 2205; mul 1 1440; sub 2206 2207; mul 564 2208; mul 385 2189; mul 583
2201; mul 515 2203; add 2211 2212; sub 2210 2213; mul 518 2214; add 2209 2215; mul 601 2216; neg 2217; mul 19 2218;
mul 549 2216; mul 530 2220; mul 540 2221; mul 624 2222; mul 542 2222; mul 544 2224; add 2223 2225; mul 19 2222; add
2226 2227; mul 530 2228; add 2219 2229; mul 549 2230; mul 518 2231; mul 550 2214; mul 19 2233; add 2232 2234; sub
2197 2235; mul 550 2208; mul 19 2237; mul 564 2231; add 2238 2239; mul 578 2201; mul 453 2203; add 2241 2242; sub
2243 2207; mul 505 2244; mul 19 2245; mul 562 2244; mul 464 2203; mul 580 2201; sub 2248 2249; add 2210 2250; mul
468 2251; add 2247 2252; mul 652 2253; neg 2254; mul 19 2255; mul 504 2253; mul 483 2257; mul 495 2258; mul 663
2259; mul 497 2259; mul 499 2261; add 2260 2262; mul 19 2259; add 2263 2264; mul 483 2265; add 2256 2266; mul 504
2267; mul 562 2268; add 2246 2269; add 2240 2270; mul 475 2271; sub 2236 2272; mul 1131 1440; mul 1 2271; sub 2274
2275; mul 594 2198; mul 19 2277; mul 512 2240; mul 575 2201; mul 461 2280; sub 2279 2281; mul 515 2235; sub 2282
2283; mul 453 2270; add 2284 2285; mul 468 2268; mul 505 2251; mul 19 2288; add 2287 2289; mul 464 2290; add 2286
2291; mul 461 2292; add 2278 2293; mul 702 2200; neg 2295; mul 19 2296; mul 565 2201; mul 706 2298; add 2297 2299;
mul 710 2280; add 2300 2301; mul 551 2201; mul 713 2303; add 2302 2304; mul 506 2201; mul 717 2306; add 2305 2307;
mul 563 2201; mul 721 2309; sub 2308 2310; mul 725 2198; sub 2311 2312; mul 461 2298; sub 2240 2314; mul 589 2315;
sub 2313 2316; mul 461 2303; sub 2235 2318; mul 583 2319; sub 2317 2320; mul 461 2309; sub 2322 2270; mul 578 2323;
sub 2321 2324; mul 586 2292; sub 2325 2326; mul 461 2306; sub 2290 2328; mul 580 2329; sub 2327 2330; mul 593 2331;
mul 577 2332; add 2294 2333; mul 126 2334; add 2276 2335; add 2235 2290; mul 385 2337; mul 126 2338; mul 2 2339; add
2336 2340; mul 436 2338; mul 756 2342; add 2341 2343; mul 87 2338; mul 38 2345; add 2344 2346; mul 25 2347; add 2273
2348; mul 1 2347; mul 24 2350; add 2349 2351; mul 1440 1869; mul 19 2353; sub 2354 2275; mul 87 2334; add 2355 2356;
mul 145 2338; mul 2 2358; add 2357 2359; mul 26 2345; add 2360 2361; mul 430 2338; mul 777 2363; add 2362 2364; mul
37 2365; add 2352 2366; mul 1 2365; mul 36 2368; add 2367 2369; mul 1 2368; mul 35 2371; add 2370 2372; sub 2373
2290; mul 552 2189; mul 447 2337; add 2375 2376; mul 7 2377; add 2374 2378; mul 559 1440; sub 2380 2275; mul 19
2334; add 2381 2382; mul 88 2338; mul 20 2384; add 2383 2385; mul 26 2339; add 2386 2387; mul 38 2358; add 2388
2389; mul 0 2390; add 2379 2391; mul 851 1440; sub 2392 2393; mul 837 2214; mul 19 2395; mul 880 2216; mul 882 2397;
mul 518 2398; sub 2396 2399; sub 2394 2400; mul 837 2208; mul 19 2402; mul 564 2398; sub 2403 2404; mul 823 2244;
mul 19 2406; mul 893 2253; mul 895 2408; mul 562 2409; sub 2407 2410; add 2405 2411; mul 475 2412; sub 2401 2413;
mul 1144 1440; mul 1 2412; sub 2415 2416; mul 871 2198; mul 19 2418; mul 512 2405; mul 860 2201; mul 461 2421; sub
2420 2422; mul 515 2400; sub 2423 2424; mul 453 2411; add 2425 2426; mul 823 2251; mul 19 2428; mul 468 2409; sub
2429 2430; mul 464 2431; add 2427 2432; mul 461 2433; add 2419 2434; mul 923 2200; neg 2436; mul 19 2437; mul 850
2201; mul 706 2439; add 2438 2440; mul 710 2421; add 2441 2442; mul 838 2201; mul 713 2444; add 2443 2445; mul 824
2201; mul 717 2447; add 2446 2448; mul 849 2201; mul 721 2450; sub 2449 2451; mul 941 2198; sub 2452 2453; mul 461
2439; sub 2405 2455; mul 589 2456; sub 2454 2457; mul 461 2444; sub 2400 2459; mul 583 2460; sub 2458 2461; mul 461
2450; sub 2463 2411; mul 578 2464; sub 2462 2465; mul 586 2433; sub 2466 2467; mul 461 2447; sub 2431 2469; mul 580
2470; sub 2468 2471; mul 593 2472; mul 577 2473; add 2435 2474; mul 126 2475; add 2417 2476; add 2400 2431; mul 385
2478; mul 126 2479; mul 2 2480; add 2477 2481; mul 436 2479; mul 756 2483; add 2482 2484; mul 87 2479; mul 38 2486;
add 2485 2487; mul 25 2488; add 2414 2489; mul 1 2488; mul 24 2491; add 2490 2492; mul 1440 1884; mul 19 2494; sub
2495 2416; mul 87 2475; add 2496 2497; mul 145 2479; mul 2 2499; add 2498 2500; mul 26 2486; add 2501 2502; mul 430
2479; mul 777 2504; add 2503 2505; mul 37 2506; add 2493 2507; mul 1 2506; mul 36 2509; add 2508 2510; mul 1 2509;
mul 35 2512; add 2511 2513; sub 2514 2431; mul 839 2189; mul 447 2478; add 2516 2517; mul 7 2518; add 2515 2519; mul
846 1440; sub 2521 2416; mul 19 2475; add 2522 2523; mul 88 2479; mul 20 2525; add 2524 2526; mul 26 2480; add 2527
2528; mul 38 2499; add 2529 2530; mul 0 2531; add 2520 2532; mul 518 601; mul 19 2534; mul 517 882; mul 530 2536;
mul 540 2537; neg 2538; mul 19 2539; mul 624 2538; mul 542 2538; mul 544 2542; add 2541 2543; sub 2540 2544; mul 530
2545; add 2535 2546; mul 549 2547; mul 564 2548; mul 512 2549; mul 518 2548; neg 550; mul 19 2552; add 2551 2553;
mul 515 2554; sub 2550 2555; mul 468 652; mul 19 2557; mul 467 895; mul 483 2559; mul 495 2560; neg 2561; mul 19
2562; mul 663 2561; mul 497 2561; mul 499 2565; add 2564 2566; sub 2563 2567; mul 483 2568; add 2558 2569; mul 504
2570; mul 562 2571; mul 453 2572; add 2556 2573; mul 468 2571; neg 505; mul 19 2576; add 2575 2577; mul 464 2578;
add 2574 2579; mul 461 2580; mul 578 2572; mul 589 2549; mul 583 2554; add 2583 2584; sub 2582 2585; mul 586 2580;
sub 2586 2587; mul 580 2578; sub 2588 2589; mul 593 2590; mul 577 2591; add 2581 2592; mul 126 2593; add 2549 2572;
mul 1 2595; sub 2594 2596; add 2554 2578; mul 385 2598; mul 126 2599; mul 2 2600; add 2597 2601; mul 436 2599; mul
756 2603; add 2602 2604; mul 87 2599; mul 38 2606; add 2605 2607; mul 25 2608; input p 1; mul 19 429; mul 2610 2611;
mul 272 2612; add 2554 2613; mul 475 2595; add 2614 2615; sub 2609 2616; mul 1 2608; mul 24 2618; add 2617 2619; mul
87 2593; sub 2621 2596; mul 145 2599; mul 2 2623; add 2622 2624; mul 26 2606; add 2625 2626; mul 430 2599; mul 777
2628; add 2627 2629; mul 37 2630; add 2620 2631; mul 1 2630; mul 36 2633; add 2632 2634; mul 1 2633; mul 35 2636;
add 2635 2637; sub 2638 2578; mul 447 2598; mul 7 2640; add 2639 2641; mul 19 2593; sub 2643 2596; mul 88 2599; mul
20 2645; add 2644 2646; mul 26 2600; add 2647 2648; mul 38 2623; add 2649 2650; mul 0 2651; add 2642 2652; mul 518
880; mul 882 2654; mul 518 2655; neg 837; mul 19 2657; add 2656 2658; sub 2653 2659; mul 564 2655; mul 468 893; mul
895 2662; mul 562 2663; add 2661 2664; mul 475 2665; sub 2660 2666; mul 512 2661; mul 515 2659; sub 2668 2669; mul
453 2664; add 2670 2671; mul 468 2663; neg 823; mul 19 2674; add 2673 2675; mul 464 2676; add 2672 2677; mul 461
2678; mul 578 2664; mul 589 2661; mul 583 2659; add 2681 2682; sub 2680 2683; mul 586 2678; sub 2684 2685; mul 580
2676; sub 2686 2687; mul 593 2688; mul 577 2689; add 2679 2690; mul 126 2691; mul 1 2665; sub 2692 2693; add 2659
2676; mul 385 2695; mul 126 2696; mul 2 2697; add 2694 2698; mul 436 2696; mul 756 2700; add 2699 2701; mul 87 2696;
mul 38 2703; add 2702 2704; mul 25 2705; add 2667 2706; mul 1 2705; mul 24 2708; add 2707 2709; mul 87 2691; sub
2711 2693; mul 145 2696; mul 2 2713; add 2712 2714; mul 26 2703; add 2715 2716; mul 430 2696; mul 777 2718; add 2717
2719; mul 37 2720; add 2710 2721; mul 1 2720; mul 36 2723; add 2722 2724; mul 1 2723; mul 35 2726; add 2725 2727;
sub 2728 2676; mul 447 2695; mul 7 2730; add 2729 2731; mul 19 2691; sub 2733 2693; mul 88 2696; mul 20 2735; add
2734 2736; mul 26 2697; add 2737 2738; mul 38 2713; add 2739 2740; mul 0 2741; add 2732 2742; constant 0.0; mul 12
2611; mul 12 323; mul 12 1362; mul 12 2131; mul 11 324; mul 7 2749; mul 11 1363; mul 7 2751; mul 11 2132; mul 7
2753; mul 11 2612; mul 7 2755; mul 387 614; neg 2757; mul 387 1443; neg 2759; mul 387 2210; neg 2761; mul 386 614;
neg 2763; mul 386 1443; neg 2765; mul 386 2210; neg 2767; mul 1 198; mul 1 1197; mul 1 1942; mul 461 729; mul 551
607; sub 2772 2773; mul 465 640; sub 2774 2775; mul 607 838; sub 2776 2777; mul 461 945; add 2778 2779; mul 465 885;
sub 2780 2781; mul 461 1549; mul 551 1436; sub 2783 2784; mul 465 1468; sub 2785 2786; mul 838 1436; sub 2787 2788;
mul 461 1690; add 2789 2790; mul 465 1633; sub 2791 2792; mul 461 2315; mul 551 2203; sub 2794 2795; mul 465 2235;
sub 2796 2797; mul 838 2203; sub 2798 2799; mul 461 2456; add 2800 2801; mul 465 2400; sub 2802 2803; mul 461 2549;
mul 465 2554; sub 2805 2806; mul 461 2661; add 2807 2808; mul 465 2659; sub 2809 2810; mul 565 607; mul 465 645; add
2812 2813; mul 461 733; add 2814 2815; mul 607 850; mul 465 890; add 2817 2818; mul 461 949; add 2819 2820; add 2816
2821; mul 565 1436; mul 465 1473; add 2823 2824; mul 461 1553; add 2825 2826; mul 850 1436; mul 465 1638; add 2828
2829; mul 461 1694; add 2830 2831; add 2827 2832; mul 565 2203; mul 465 2240; add 2834 2835; mul 461 2319; add 2836
2837; mul 850 2203; mul 465 2405; add 2839 2840; mul 461 2460; add 2841 2842; add 2838 2843; mul 465 2549; mul 461
2554; add 2845 2846; mul 465 2661; mul 461 2659; add 2848 2849; add 2847 2850; neg 2822; neg 2833; neg 2844; neg
2851; add 640 885; add 1468 1633; add 2235 2400; add 2554 2659; add 645 890; neg 2860; add 1473 1638; neg 2862; add
2240 2405; neg 2864; add 2549 2661; neg 2866; mul 530 547; mul 625 2868; mul 530 531; mul 633 2870; add 2869 2871;
mul 530 836; mul 625 2873; add 2872 2874; neg 2875; mul 1453 2868; mul 1461 2870; add 2877 2878; mul 1453 2873; add
2879 2880; neg 2881; mul 2220 2868; mul 2228 2870; add 2883 2884; mul 2220 2873; add 2885 2886; neg 2887; mul 2536
2868; mul 2545 2870; sub 2889 2890; mul 2536 2873; add 2891 2892; constant 0.16666666666666666; mul 532 626; mul 544
626; sub 2895 2896; mul 2894 2897; mul 538 2898; mul 536 2899; mul 534 2900; mul 626 834; mul 831 2902; mul 534
2903; mul 828 2904; mul 826 2905; mul 809 2906; add 2901 2907; mul 532 1454; mul 544 1454; sub 2909 2910; mul 2894
2911; mul 538 2912; mul 536 2913; mul 534 2914; mul 834 1454; mul 831 2916; mul 534 2917; mul 828 2918; mul 826
2919; mul 809 2920; add 2915 2921; mul 532 2221; mul 544 2221; sub 2923 2924; mul 2894 2925; mul 538 2926; mul 536
2927; mul 534 2928; mul 834 2221; mul 831 2930; mul 534 2931; mul 828 2932; mul 826 2933; mul 809 2934; add 2929
2935; mul 544 2537; mul 532 2537; sub 2937 2938; mul 2894 2939; mul 538 2940; mul 536 2941; mul 534 2942; mul 834
2537; mul 831 2944; mul 534 2945; mul 828 2946; mul 826 2947; mul 809 2948; sub 2943 2949; mul 535 2899; mul 831
832; mul 2902 2952; sub 2951 2953; mul 535 2913; mul 2916 2952; sub 2955 2956; mul 535 2927; mul 2930 2952; sub 2958
2959; mul 535 2941; mul 2944 2952; add 2961 2962; mul 533 2900; mul 829 2903; add 2964 2965; mul 533 2914; mul 829
2917; add 2967 2968; mul 533 2928; mul 829 2931; add 2970 2971; mul 533 2942; mul 829 2945; sub 2973 2974; mul 827
2904; mul 827 2918; mul 827 2932; mul 827 2946; neg 2979; mul 825 2905; mul 825 2919; mul 825 2933; mul 825 2947;
neg 2984; mul 537 2898; mul 537 2912; mul 537 2926; mul 537 2940; mul 506 607; mul 461 737; add 2990 2991; mul 465
697; add 2992 2993; mul 607 824; add 2994 2995; mul 461 953; add 2996 2997; mul 465 918; add 2998 2999; mul 506
1436; mul 461 1557; add 3001 3002; mul 465 1524; add 3003 3004; mul 824 1436; add 3005 3006; mul 461 1698; add 3007
3008; mul 465 1665; add 3009 3010; mul 506 2203; mul 461 2323; add 3012 3013; mul 465 2290; add 3014 3015; mul 824
2203; add 3016 3017; mul 461 2464; add 3018 3019; mul 465 2431; add 3020 3021; mul 465 2578; mul 461 2572; sub 3023
3024; mul 461 2664; sub 3025 3026; mul 465 2676; add 3027 3028; mul 563 607; mul 465 677; add 3030 3031; mul 461
743; add 3032 3033; mul 607 849; mul 465 898; add 3035 3036; mul 461 959; add 3037 3038; add 3034 3039; mul 563
1436; mul 465 1503; add 3041 3042; mul 461 1563; add 3043 3044; mul 849 1436; mul 465 1644; add 3046 3047; mul 461
1704; add 3048 3049; add 3045 3050; mul 563 2203; mul 465 2270; add 3052 3053; mul 461 2329; add 3054 3055; mul 849
2203; mul 465 2411; add 3057 3058; mul 461 2470; add 3059 3060; add 3056 3061; mul 465 2572; mul 461 2578; add 3063
3064; mul 465 2664; mul 461 2676; add 3066 3067; add 3065 3068; neg 3040; neg 3051; neg 3062; neg 3069; add 697 918;
add 1524 1665; add 2290 2431; add 2578 2676; add 677 898; add 1503 1644; add 2270 2411; add 2572 2664; mul 483 502;
mul 664 3082; mul 483 484; mul 672 3084; add 3083 3085; mul 483 822; mul 664 3087; add 3086 3088; neg 3089; mul 1490
3082; mul 1498 3084; add 3091 3092; mul 1490 3087; add 3093 3094; neg 3095; mul 2257 3082; mul 2265 3084; add 3097
3098; mul 2257 3087; add 3099 3100; neg 3101; mul 2559 3082; mul 2568 3084; sub 3103 3104; mul 2559 3087; add 3105
3106; mul 485 665; mul 499 665; sub 3108 3109; mul 2894 3110; mul 491 3111; mul 489 3112; mul 487 3113; mul 665 820;
mul 816 3115; mul 487 3116; mul 813 3117; mul 811 3118; mul 809 3119; add 3114 3120; mul 485 1491; mul 499 1491; sub
3122 3123; mul 2894 3124; mul 491 3125; mul 489 3126; mul 487 3127; mul 820 1491; mul 816 3129; mul 487 3130; mul
813 3131; mul 811 3132; mul 809 3133; add 3128 3134; mul 485 2258; mul 499 2258; sub 3136 3137; mul 2894 3138; mul
491 3139; mul 489 3140; mul 487 3141; mul 820 2258; mul 816 3143; mul 487 3144; mul 813 3145; mul 811 3146; mul 809
3147; add 3142 3148; mul 499 2560; mul 485 2560; sub 3150 3151; mul 2894 3152; mul 491 3153; mul 489 3154; mul 487
3155; mul 820 2560; mul 816 3157; mul 487 3158; mul 813 3159; mul 811 3160; mul 809 3161; sub 3156 3162; mul 488
3112; mul 816 817; mul 3115 3165; sub 3164 3166; mul 488 3126; mul 3129 3165; sub 3168 3169; mul 488 3140; mul 3143
3165; sub 3171 3172; mul 488 3154; mul 3157 3165; add 3174 3175; mul 486 3113; mul 814 3116; add 3177 3178; mul 486
3127; mul 814 3130; add 3180 3181; mul 486 3141; mul 814 3144; add 3183 3184; mul 486 3155; mul 814 3158; sub 3186
3187; mul 812 3117; mul 812 3131; mul 812 3145; mul 812 3159; neg 3192; mul 810 3118; mul 810 3132; mul 810 3146;
mul 810 3160; neg 3197; mul 490 3111; mul 490 3125; mul 490 3139; mul 490 3153; store gradient_p 0 1022; store
gradient_p 41 1766; store gradient_p 82 2533; store gradient_p 123 2743; store gradient_p 1 2744; store gradient_p
42 2744; store gradient_p 83 2744; store gradient_p 124 2745; store gradient_p 2 2746; store gradient_p 43 2747;
store gradient_p 84 2748; store gradient_p 125 2744; store gradient_p 3 2750; store gradient_p 44 2752; store
gradient_p 85 2754; store gradient_p 126 2756; store gradient_p 4 2744; store gradient_p 45 2744; store gradient_p
86 2744; store gradient_p 127 2744; store gradient_p 5 2744; store gradient_p 46 2744; store gradient_p 87 2744;
store gradient_p 128 2744; store gradient_p 6 2758; store gradient_p 47 2760; store gradient_p 88 2762; store
gradient_p 129 387; store gradient_p 7 2764; store gradient_p 48 2766; store gradient_p 89 2768; store gradient_p
130 386; store gradient_p 8 2769; store gradient_p 49 2770; store gradient_p 90 2771; store gradient_p 131 2744;
store gradient_p 9 2744; store gradient_p 50 2744; store gradient_p 91 2744; store gradient_p 132 2744; store
gradient_p 10 2744; store gradient_p 51 2744; store gradient_p 92 2744; store gradient_p 133 2744; store gradient_p
11 2782; store gradient_p 52 2793; store gradient_p 93 2804; store gradient_p 134 2811; store gradient_p 12 2822;
store gradient_p 53 2833; store gradient_p 94 2844; store gradient_p 135 2851; store gradient_p 13 2852; store
gradient_p 54 2853; store gradient_p 95 2854; store gradient_p 136 2855; store gradient_p 14 2856; store gradient_p
55 2857; store gradient_p 96 2858; store gradient_p 137 2859; store gradient_p 15 2861; store gradient_p 56 2863;
store gradient_p 97 2865; store gradient_p 138 2867; store gradient_p 16 2876; store gradient_p 57 2882; store
gradient_p 98 2888; store gradient_p 139 2893; store gradient_p 17 2908; store gradient_p 58 2922; store gradient_p
99 2936; store gradient_p 140 2950; store gradient_p 18 2954; store gradient_p 59 2957; store gradient_p 100 2960;
store gradient_p 141 2963; store gradient_p 19 2966; store gradient_p 60 2969; store gradient_p 101 2972; store
gradient_p 142 2975; store gradient_p 20 2976; store gradient_p 61 2977; store gradient_p 102 2978; store gradient_p
143 2980; store gradient_p 21 2981; store gradient_p 62 2982; store gradient_p 103 2983; store gradient_p 144 2985;
store gradient_p 22 2986; store gradient_p 63 2987; store gradient_p 104 2988; store gradient_p 145 2989; store
gradient_p 23 2744; store gradient_p 64 2744; store gradient_p 105 2744; store gradient_p 146 2744; store gradient_p
24 2744; store gradient_p 65 2744; store gradient_p 106 2744; store gradient_p 147 2744; store gradient_p 25 2744;
store gradient_p 66 2744; store gradient_p 107 2744; store gradient_p 148 2744; store gradient_p 26 3000; store
gradient_p 67 3011; store gradient_p 108 3022; store gradient_p 149 3029; store gradient_p 27 3040; store gradient_p
68 3051; store gradient_p 109 3062; store gradient_p 150 3069; store gradient_p 28 3070; store gradient_p 69 3071;
store gradient_p 110 3072; store gradient_p 151 3073; store gradient_p 29 3074; store gradient_p 70 3075; store
gradient_p 111 3076; store gradient_p 152 3077; store gradient_p 30 3078; store gradient_p 71 3079; store gradient_p
112 3080; store gradient_p 153 3081; store gradient_p 31 3090; store gradient_p 72 3096; store gradient_p 113 3102;
store gradient_p 154 3107; store gradient_p 32 3121; store gradient_p 73 3135; store gradient_p 114 3149; store
gradient_p 155 3163; store gradient_p 33 3167; store gradient_p 74 3170; store gradient_p 115 3173; store gradient_p
156 3176; store gradient_p 34 3179; store gradient_p 75 3182; store gradient_p 116 3185; store gradient_p 157 3188;
store gradient_p 35 3189; store gradient_p 76 3190; store gradient_p 117 3191; store gradient_p 158 3193; store
gradient_p 36 3194; store gradient_p 77 3195; store gradient_p 118 3196; store gradient_p 159 3198; store gradient_p
37 3199; store gradient_p 78 3200; store gradient_p 119 3201; store gradient_p 160 3202; store gradient_p 38 2744;
store gradient_p 79 2744; store gradient_p 120 2744; store gradient_p 161 2744; store gradient_p 39 2744; store
gradient_p 80 2744; store gradient_p 121 2744; store gradient_p 162 2744; store gradient_p 40 2744; store gradient_p
81 2744; store gradient_p 122 2744; store gradient_p 163 2744
    """,
)

TIP = Graph(
    {'qm': 4, 'p': 41},
    {'values': 5, 'jacobian': 20},
    """
input p 0; input qm 0; mul 0 1; input qm 1; mul 0 3; mul 0 4; add 2 5; input qm 2; mul 0 7; mul 0 8; mul 0 9; add 6
10; mul 0 11; constant 2.0; mul 2 13; constant 3.0; mul 5 15; add 14 16; constant 4.0; mul 10 18; add 17 19; atan
20; input qm 3; constant 0.5; mul 0 23; constant 2.2857142857142856; mul 10 10; mul 25 26; mul 5 10; mul 18 28; add
27 29; constant 1.8; mul 5 5; mul 31 32; add 30 33; constant 3.2; mul 2 10; mul 35 36; add 34 37; mul 2 5; mul 15
39; add 38 40; constant 1.3333333333333333; mul 2 2; mul 42 43; add 41 44; mul 24 45; sub 22 46; input p 11;
constant 1.0; mul 20 20; add 49 50; sqrt 51; div 49 52; mul 48 53; input p 15; sub 54 55; input p 12; input p 13;
sub 57 58; mul 20 53; mul 59 60; add 56 61; sub 62 12; mul 63 63; input p 14; sub 65 0; sub 66 47; mul 53 59; add 67
68; mul 48 60; sub 69 70; mul 71 71; add 64 72; sqrt 73; input p 16; div 49 75; mul 74 76; input p 27; input p 28;
sub 78 79; mul 60 80; input p 26; mul 53 82; input p 30; sub 83 84; sub 81 85; sub 86 12; mul 87 87; input p 29; sub
89 0; sub 90 47; mul 53 80; add 91 92; mul 60 82; add 93 94; mul 95 95; add 88 96; sqrt 97; input p 31; div 49 99;
mul 98 100; mul 0 0; mul 0 13; div 49 51; mul 103 104; mul 0 10; mul 35 106; mul 0 5; mul 15 108; add 107 109; mul 0
14; mul 42 111; add 110 112; mul 24 113; neg 114; mul 13 63; mul 53 103; mul 53 60; mul 13 20; mul 103 119; mul 13
52; div 49 121; mul 120 122; mul 118 123; sub 117 124; mul 59 125; mul 53 54; mul 123 127; sub 126 128; sub 129 102;
mul 116 130; mul 13 71; mul 53 68; mul 123 133; sub 114 134; mul 48 125; sub 135 136; mul 132 137; add 131 138; mul
13 74; div 49 140; mul 139 141; mul 76 142; mul 13 87; mul 80 125; mul 53 83; mul 123 146; add 145 147; sub 148 102;
mul 144 149; mul 13 95; mul 53 92; mul 123 152; sub 114 153; mul 82 125; add 154 155; mul 151 156; add 150 157; mul
13 98; div 49 159; mul 158 160; mul 100 161; mul 0 102; mul 15 102; mul 104 164; mul 10 102; mul 18 166; mul 5 13;
mul 102 168; mul 31 169; add 167 170; mul 2 102; mul 15 172; add 171 173; mul 24 174; neg 175; mul 53 164; mul 119
164; mul 122 178; mul 118 179; sub 177 180; mul 59 181; mul 127 179; sub 182 183; sub 184 163; mul 116 185; mul 133
179; sub 175 187; mul 48 181; sub 188 189; mul 132 190; add 186 191; mul 141 192; mul 76 193; mul 80 181; mul 146
179; add 195 196; sub 197 163; mul 144 198; mul 152 179; sub 175 200; mul 82 181; add 201 202; mul 151 203; add 199
204; mul 160 205; mul 100 206; mul 0 163; mul 18 163; mul 104 209; mul 10 13; mul 163 211; mul 25 212; mul 5 163;
mul 18 214; add 213 215; mul 2 163; mul 35 217; add 216 218; mul 24 219; neg 220; mul 53 209; mul 119 209; mul 122
223; mul 118 224; sub 222 225; mul 59 226; mul 127 224; sub 227 228; sub 229 208; mul 116 230; mul 133 224; sub 220
232; mul 48 226; sub 233 234; mul 132 235; add 231 236; mul 141 237; mul 76 238; mul 80 226; mul 146 224; add 240
241; sub 242 208; mul 144 243; mul 152 224; sub 220 245; mul 82 226; add 246 247; mul 151 248; add 244 249; mul 160
250; mul 100 251; constant 0.0; div 49 74; mul 71 254; mul 76 255; neg 256; div 49 98; mul 95 258; mul 100 259; neg
260; store values 0 12; store values 1 21; store values 2 47; store values 3 77; store values 4 101; store jacobian
0 102; store jacobian 4 105; store jacobian 8 115; store jacobian 12 143; store jacobian 16 162; store jacobian 1
163; store jacobian 5 165; store jacobian 9 176; store jacobian 13 194; store jacobian 17 207; store jacobian 2 208;
store jacobian 6 210; store jacobian 10 221; store jacobian 14 239; store jacobian 18 252; store jacobian 3 253;
store jacobian 7 253; store jacobian 11 49; store jacobian 15 257; store jacobian 19 261
    """,
)

CAPACITANCE = Graph(
    {'qm': 4, 'p': 41},
    {'values': 2, 'jacobian': 8},
    """
constant 8.854e-12; input p 17; mul 0 1; input p 21; mul 2 3; input p 20; mul 4 5; input p 19; mul 6 7; input p 18;
constant 1.0; div 10 9; mul 8 11; input p 11; input qm 0; input p 0; mul 14 15; constant 2.0; mul 16 17; constant
3.0; input qm 1; mul 15 20; mul 15 21; mul 19 22; add 18 23; constant 4.0; input qm 2; mul 15 26; mul 15 27; mul 15
28; mul 25 29; add 24 30; mul 31 31; add 10 32; sqrt 33; div 10 34; mul 13 35; input p 15; sub 36 37; input p 12;
input p 13; sub 39 40; mul 31 35; mul 41 42; add 38 43; add 16 22; add 29 45; mul 15 46; sub 44 47; mul 48 48; input
p 14; sub 50 15; input qm 3; constant 0.5; mul 15 53; constant 2.2857142857142856; mul 29 29; mul 55 56; mul 22 29;
mul 25 58; add 57 59; constant 1.8; mul 22 22; mul 61 62; add 60 63; constant 3.2; mul 16 29; mul 65 66; add 64 67;
mul 16 22; mul 19 69; add 68 70; constant 1.3333333333333333; mul 16 16; mul 72 73; add 71 74; mul 54 75; sub 52 76;
sub 51 77; mul 35 41; add 78 79; mul 13 42; sub 80 81; mul 82 82; add 49 83; sqrt 84; input p 16; div 10 86; mul 85
87; mul 12 88; input p 32; mul 0 90; input p 36; mul 91 92; input p 35; mul 93 94; input p 34; mul 95 96; input p
33; div 10 98; mul 97 99; input p 27; input p 28; sub 101 102; mul 42 103; input p 26; mul 35 105; input p 30; sub
106 107; sub 104 108; sub 109 47; mul 110 110; input p 29; sub 112 15; sub 113 77; mul 35 103; add 114 115; mul 42
105; add 116 117; mul 118 118; add 111 119; sqrt 120; input p 31; div 10 122; mul 121 123; mul 100 124; mul 17 48;
mul 15 17; mul 35 127; mul 35 42; mul 17 31; mul 127 130; mul 17 34; div 10 132; mul 131 133; mul 129 134; sub 128
135; mul 41 136; mul 35 36; mul 134 138; sub 137 139; mul 15 15; sub 140 141; mul 126 142; mul 17 82; mul 15 29; mul
65 145; mul 15 22; mul 19 147; add 146 148; mul 15 18; mul 72 150; add 149 151; mul 54 152; mul 35 79; mul 134 154;
sub 153 155; mul 13 136; sub 156 157; mul 144 158; add 143 159; mul 17 85; div 10 161; mul 160 162; mul 87 163; mul
12 164; mul 17 110; mul 103 136; mul 35 106; mul 134 168; add 167 169; sub 170 141; mul 166 171; mul 17 118; mul 35
115; mul 134 174; sub 153 175; mul 105 136; add 176 177; mul 173 178; add 172 179; mul 17 121; div 10 181; mul 180
182; mul 123 183; mul 100 184; mul 19 141; mul 35 186; mul 130 186; mul 133 188; mul 129 189; sub 187 190; mul 41
191; mul 138 189; sub 192 193; mul 15 141; sub 194 195; mul 126 196; mul 29 141; mul 25 198; mul 17 22; mul 141 200;
mul 61 201; add 199 202; mul 16 141; mul 19 204; add 203 205; mul 54 206; mul 154 189; sub 207 208; mul 13 191; sub
209 210; mul 144 211; add 197 212; mul 162 213; mul 87 214; mul 12 215; mul 103 191; mul 168 189; add 217 218; sub
219 195; mul 166 220; mul 174 189; sub 207 222; mul 105 191; add 223 224; mul 173 225; add 221 226; mul 182 227; mul
123 228; mul 100 229; mul 25 195; mul 35 231; mul 130 231; mul 133 233; mul 129 234; sub 232 235; mul 41 236; mul
138 234; sub 237 238; mul 15 195; sub 239 240; mul 126 241; mul 17 29; mul 195 243; mul 55 244; mul 22 195; mul 25
246; add 245 247; mul 16 195; mul 65 249; add 248 250; mul 54 251; mul 154 234; sub 252 253; mul 13 236; sub 254
255; mul 144 256; add 242 257; mul 162 258; mul 87 259; mul 12 260; mul 103 236; mul 168 234; add 262 263; sub 264
240; mul 166 265; mul 174 234; sub 252 267; mul 105 236; add 268 269; mul 173 270; add 266 271; mul 182 272; mul 123
273; mul 100 274; div 10 85; mul 82 276; mul 87 277; mul 12 278; neg 279; div 10 121; mul 118 281; mul 123 282; mul
100 283; neg 284; store values 0 89; store values 1 125; store jacobian 0 165; store jacobian 4 185; store jacobian
1 216; store jacobian 5 230; store jacobian 2 261; store jacobian 6 275; store jacobian 3 280; store jacobian 7 285
    """,
)

DISSIPATION = Graph(
    {'qm': 4, 'p': 41},
    {'damping': 16, 'coupling': 12, 'thickness_jacobian': 8},
    """
input p 0; input qm 0; mul 0 1; constant 2.0; mul 2 3; constant 1.3333333333333333; constant 0.5; mul 0 6; input p
29; sub 8 0; input qm 3; constant 2.2857142857142856; input qm 2; mul 0 12; mul 0 13; mul 0 14; mul 15 15; mul 11
16; constant 4.0; input qm 1; mul 0 19; mul 0 20; mul 15 21; mul 18 22; add 17 23; constant 1.8; mul 21 21; mul 25
26; add 24 27; constant 3.2; mul 2 15; mul 29 30; add 28 31; constant 3.0; mul 2 21; mul 33 34; add 32 35; mul 2 2;
mul 5 37; add 36 38; mul 7 39; sub 10 40; sub 9 41; input p 27; input p 28; sub 43 44; constant 1.0; mul 21 33; add
4 47; mul 15 18; add 48 49; mul 50 50; add 46 51; sqrt 52; div 46 53; mul 45 54; add 42 55; input p 26; mul 50 54;
mul 57 58; add 56 59; mul 3 60; mul 45 58; mul 54 57; input p 30; sub 63 64; sub 62 65; add 2 21; add 15 67; mul 0
68; sub 66 69; mul 70 70; mul 60 60; add 71 72; sqrt 73; input p 31; div 46 75; mul 74 76; sqrt 77; div 46 78; mul
79 79; input p 32; input p 34; mul 81 82; input p 33; mul 83 84; mul 6 85; input p 40; mul 86 87; mul 3 70; mul 0 3;
mul 54 90; mul 54 58; mul 3 50; mul 90 93; mul 3 53; div 46 95; mul 94 96; mul 92 97; sub 91 98; mul 45 99; mul 54
63; mul 97 101; add 100 102; mul 0 0; sub 103 104; mul 89 105; mul 57 99; mul 54 55; mul 97 108; mul 0 15; mul 29
110; mul 0 21; mul 33 112; add 111 113; mul 0 4; mul 5 115; add 114 116; mul 7 117; sub 109 118; sub 107 119; mul 61
120; add 106 121; mul 3 74; div 46 123; mul 122 124; mul 76 125; mul 3 78; div 46 127; mul 126 128; mul 80 129; mul
3 130; mul 88 131; mul 80 132; mul 128 133; mul 76 134; mul 124 135; mul 61 136; input p 14; sub 138 0; sub 139 41;
input p 12; input p 13; sub 141 142; mul 54 143; add 140 144; input p 11; mul 58 146; sub 145 147; mul 3 148; mul 54
146; input p 15; sub 150 151; mul 58 143; add 152 153; sub 154 69; mul 155 155; mul 148 148; add 156 157; sqrt 158;
input p 16; div 46 160; mul 159 161; sqrt 162; div 46 163; mul 164 164; input p 17; input p 19; mul 166 167; input p
18; mul 168 169; mul 6 170; input p 25; mul 171 172; mul 3 155; mul 99 143; mul 54 150; mul 97 176; sub 175 177; sub
178 104; mul 174 179; mul 54 144; mul 97 181; sub 182 118; mul 99 146; add 183 184; mul 149 185; sub 180 186; mul 3
159; div 46 188; mul 187 189; mul 161 190; mul 3 163; div 46 192; mul 191 193; mul 165 194; mul 3 195; mul 173 196;
mul 165 197; mul 193 198; mul 161 199; mul 189 200; mul 149 201; add 137 202; mul 7 203; mul 5 204; mul 4 205; mul
33 204; mul 21 207; add 206 208; mul 29 204; mul 15 210; add 209 211; mul 89 136; mul 174 201; add 213 214; mul 0
215; sub 212 216; mul 101 213; mul 108 137; sub 218 219; mul 181 202; sub 220 221; mul 176 214; sub 222 223; mul 57
137; mul 45 213; add 225 226; mul 146 202; sub 227 228; mul 143 214; add 229 230; mul 92 231; sub 224 232; mul 96
233; mul 93 234; mul 54 231; add 235 236; mul 3 237; add 217 238; mul 0 239; input p 5; mul 3 241; input p 2; mul
242 243; mul 6 244; div 46 0; mul 245 246; mul 18 247; mul 90 248; mul 0 249; add 240 250; mul 33 104; mul 54 252;
mul 93 252; mul 96 254; mul 92 255; sub 253 256; mul 45 257; mul 101 255; add 258 259; mul 0 104; sub 260 261; mul
89 262; mul 57 257; mul 108 255; mul 15 104; mul 18 266; mul 3 21; mul 104 268; mul 25 269; add 267 270; mul 2 104;
mul 33 272; add 271 273; mul 7 274; sub 265 275; sub 264 276; mul 61 277; add 263 278; mul 124 279; mul 76 280; mul
128 281; mul 80 282; mul 3 283; mul 88 284; mul 80 285; mul 128 286; mul 76 287; mul 124 288; mul 61 289; mul 143
257; mul 176 255; sub 291 292; sub 293 261; mul 174 294; mul 181 255; sub 296 275; mul 146 257; add 297 298; mul 149
299; sub 295 300; mul 189 301; mul 161 302; mul 193 303; mul 165 304; mul 3 305; mul 173 306; mul 165 307; mul 193
308; mul 161 309; mul 189 310; mul 149 311; add 290 312; mul 7 313; mul 5 314; mul 4 315; mul 33 314; mul 21 317;
add 316 318; mul 29 314; mul 15 320; add 319 321; mul 89 289; mul 174 311; add 323 324; mul 0 325; sub 322 326; mul
101 323; mul 108 290; sub 328 329; mul 181 312; sub 330 331; mul 176 324; sub 332 333; mul 57 290; mul 45 323; add
335 336; mul 146 312; sub 337 338; mul 143 324; add 339 340; mul 92 341; sub 334 342; mul 96 343; mul 93 344; mul 54
341; add 345 346; mul 3 347; add 327 348; mul 0 349; constant 12.0; mul 247 351; mul 104 352; mul 0 353; add 350
354; mul 18 261; mul 54 356; mul 93 356; mul 96 358; mul 92 359; sub 357 360; mul 45 361; mul 101 359; add 362 363;
mul 0 261; sub 364 365; mul 89 366; mul 57 361; mul 108 359; mul 3 15; mul 261 370; mul 11 371; mul 21 261; mul 18
373; add 372 374; mul 2 261; mul 29 376; add 375 377; mul 7 378; sub 369 379; sub 368 380; mul 61 381; add 367 382;
mul 124 383; mul 76 384; mul 128 385; mul 80 386; mul 3 387; mul 88 388; mul 80 389; mul 128 390; mul 76 391; mul
124 392; mul 61 393; mul 143 361; mul 176 359; sub 395 396; sub 397 365; mul 174 398; mul 181 359; sub 400 379; mul
146 361; add 401 402; mul 149 403; sub 399 404; mul 189 405; mul 161 406; mul 193 407; mul 165 408; mul 3 409; mul
173 410; mul 165 411; mul 193 412; mul 161 413; mul 189 414; mul 149 415; add 394 416; mul 7 417; mul 5 418; mul 4
419; mul 33 418; mul 21 421; add 420 422; mul 29 418; mul 15 424; add 423 425; mul 89 393; mul 174 415; add 427 428;
mul 0 429; sub 426 430; mul 101 427; mul 108 394; sub 432 433; mul 181 416; sub 434 435; mul 176 428; sub 436 437;
mul 57 394; mul 45 427; add 439 440; mul 146 416; sub 441 442; mul 143 428; add 443 444; mul 92 445; sub 438 446;
mul 96 447; mul 93 448; mul 54 445; add 449 450; mul 3 451; add 431 452; mul 0 453; constant 16.0; mul 247 455; mul
261 456; mul 0 457; add 454 458; div 46 74; mul 60 460; mul 76 461; mul 128 462; mul 80 463; neg 464; mul 3 465; mul
88 466; mul 80 467; mul 128 468; mul 76 469; mul 124 470; mul 61 471; div 46 159; mul 148 473; mul 161 474; mul 193
475; mul 165 476; neg 477; mul 3 478; mul 173 479; mul 165 480; mul 193 481; mul 161 482; mul 189 483; mul 149 484;
add 472 485; mul 7 486; mul 5 487; mul 4 488; mul 33 487; mul 21 490; add 489 491; mul 29 487; mul 15 493; add 492
494; mul 89 471; mul 174 484; add 496 497; mul 0 498; sub 495 499; mul 101 496; mul 108 472; sub 501 502; mul 181
485; sub 503 504; mul 176 497; sub 505 506; mul 57 472; mul 45 496; add 508 509; mul 146 485; sub 510 511; mul 143
497; add 512 513; mul 92 514; sub 507 515; mul 96 516; mul 93 517; mul 54 514; add 518 519; mul 3 520; add 500 521;
mul 0 522; mul 2 317; mul 25 314; mul 268 525; add 524 526; mul 18 314; mul 15 528; add 527 529; sub 530 326; mul 33
347; add 531 532; mul 0 533; mul 0 534; mul 3 104; mul 352 536; mul 0 537; mul 0 538; add 535 539; mul 2 421; mul 25
418; mul 268 542; add 541 543; mul 18 418; mul 15 545; add 544 546; sub 547 430; mul 33 451; add 548 549; mul 0 550;
mul 0 551; constant 36.0; mul 247 553; mul 261 554; mul 0 555; mul 0 556; add 552 557; mul 2 490; mul 25 487; mul
268 560; add 559 561; mul 18 487; mul 15 563; add 562 564; sub 565 499; mul 33 520; add 566 567; mul 0 568; mul 0
569; mul 2 424; mul 21 545; add 571 572; mul 11 418; mul 370 574; add 573 575; sub 576 430; mul 18 451; add 577 578;
mul 0 579; mul 0 580; mul 0 581; constant 28.8; mul 247 583; mul 3 261; mul 584 585; mul 0 586; mul 0 587; mul 0
588; add 582 589; mul 2 493; mul 21 563; add 591 592; mul 11 487; mul 370 594; add 593 595; sub 596 499; mul 18 520;
add 597 598; mul 0 599; mul 0 600; mul 0 601; neg 486; input p 23; mul 170 604; sub 118 182; sub 606 184; mul 149
607; add 180 608; mul 189 609; mul 161 610; mul 193 611; mul 165 612; mul 605 613; neg 614; sub 275 296; sub 616
298; mul 149 617; add 295 618; mul 189 619; mul 161 620; mul 193 621; mul 165 622; mul 605 623; neg 624; sub 379
400; sub 626 402; mul 149 627; add 399 628; mul 189 629; mul 161 630; mul 193 631; mul 165 632; mul 605 633; neg
634; mul 477 605; input p 38; mul 85 637; sub 118 109; add 107 639; mul 61 640; add 106 641; mul 124 642; mul 76
643; mul 128 644; mul 80 645; mul 638 646; neg 647; sub 275 265; add 264 649; mul 61 650; add 263 651; mul 124 652;
mul 76 653; mul 128 654; mul 80 655; mul 638 656; neg 657; sub 379 369; add 368 659; mul 61 660; add 367 661; mul
124 662; mul 76 663; mul 128 664; mul 80 665; mul 638 666; neg 667; mul 464 638; input p 9; mul 104 670; mul 261
670; mul 365 670; constant 0.0; neg 613; neg 646; neg 623; neg 656; neg 633; neg 666; store damping 0 251; store
damping 4 355; store damping 8 459; store damping 12 523; store damping 1 355; store damping 5 540; store damping 9
558; store damping 13 570; store damping 2 459; store damping 6 558; store damping 10 590; store damping 14 602;
store damping 3 523; store damping 7 570; store damping 11 602; store damping 15 603; store coupling 0 615; store
coupling 3 625; store coupling 6 635; store coupling 9 636; store coupling 1 648; store coupling 4 658; store
coupling 7 668; store coupling 10 669; store coupling 2 671; store coupling 5 672; store coupling 8 673; store
coupling 11 674; store thickness_jacobian 0 675; store thickness_jacobian 4 676; store thickness_jacobian 1 677;
store thickness_jacobian 5 678; store thickness_jacobian 2 679; store thickness_jacobian 6 680; store
thickness_jacobian 3 477; store thickness_jacobian 7 464
    """,
)

DYNAMICS = Graph(
    {'qm': 4, 'qm_dot': 4, 'z': 3, 'v_squared': 2, 'force': 1, 'p': 41},
    {'mass': 16, 'tau': 4, 'z_dot': 3},
    """
input p 0; constant 0.2; input p 1; mul 0 0; mul 0 3; mul 2 4; constant 0.5; input p 4; mul 6 7; mul 5 8; mul 1 9;
constant 2.0; mul 0 11; mul 10 12; constant 1.3333333333333333; input p 2; mul 0 15; mul 8 16; mul 14 17; mul 12 18;
add 13 19; mul 0 20; input qm 0; mul 0 22; mul 11 23; mul 0 6; input p 6; mul 6 26; constant 3.2; input qm 2; mul 0
29; mul 0 30; mul 0 31; mul 0 32; mul 28 33; constant 3.0; input qm 1; mul 0 36; mul 0 37; mul 0 38; mul 35 39; add
34 40; mul 0 24; mul 14 42; add 41 43; mul 25 44; neg 45; mul 11 46; mul 27 47; mul 25 48; mul 14 49; mul 24 50; mul
35 49; mul 38 52; add 51 53; mul 28 49; mul 32 55; add 54 56; mul 0 57; sub 21 58; mul 3 11; mul 27 60; mul 0 61;
mul 0 62; add 59 63; constant 0.3333333333333333; mul 9 65; mul 3 66; mul 17 35; mul 3 68; add 67 69; mul 0 70;
constant 4.0; mul 3 32; mul 72 73; constant 1.8; mul 11 38; mul 3 76; mul 75 77; add 74 78; mul 3 23; mul 35 80; add
79 81; mul 25 82; neg 83; mul 11 84; mul 27 85; mul 25 86; mul 14 87; mul 24 88; mul 35 87; mul 38 90; add 89 91;
mul 28 87; mul 32 93; add 92 94; mul 0 95; sub 71 96; mul 4 11; mul 27 98; mul 0 99; mul 0 100; add 97 101; constant
0.2857142857142857; mul 9 103; mul 4 104; mul 17 28; mul 4 106; add 105 107; mul 0 108; constant 2.2857142857142856;
mul 11 32; mul 4 111; mul 110 112; mul 4 38; mul 72 114; add 113 115; mul 4 23; mul 28 117; add 116 118; mul 25 119;
neg 120; mul 11 121; mul 27 122; mul 25 123; mul 14 124; mul 24 125; mul 35 124; mul 38 127; add 126 128; mul 28
124; mul 32 130; add 129 131; mul 0 132; sub 109 133; mul 0 4; mul 11 135; mul 27 136; mul 0 137; mul 0 138; add 134
139; mul 25 26; mul 14 141; mul 24 142; mul 35 141; mul 38 144; add 143 145; mul 28 141; mul 32 147; add 146 148;
mul 0 149; neg 150; constant 0.14285714285714285; mul 9 152; mul 60 153; mul 17 75; mul 60 155; add 154 156; mul 0
157; mul 0 158; mul 23 90; mul 75 87; mul 76 161; add 160 162; mul 72 87; mul 32 164; add 163 165; mul 0 166; mul 0
167; sub 159 168; mul 0 101; add 169 170; constant 0.25; mul 9 172; mul 4 173; mul 17 72; mul 4 175; add 174 176;
mul 0 177; mul 0 178; mul 23 127; mul 75 124; mul 76 181; add 180 182; mul 72 124; mul 32 184; add 183 185; mul 0
186; mul 0 187; sub 179 188; mul 0 139; add 189 190; mul 23 144; mul 75 141; mul 76 193; add 192 194; mul 72 141;
mul 32 196; add 195 197; mul 0 198; mul 0 199; neg 200; constant 0.1111111111111111; mul 9 202; mul 98 203; mul 17
110; mul 98 205; add 204 206; mul 0 207; mul 0 208; mul 0 209; mul 23 130; mul 38 184; add 211 212; mul 110 124; mul
111 214; add 213 215; mul 0 216; mul 0 217; mul 0 218; sub 210 219; mul 0 190; add 220 221; mul 23 147; mul 38 196;
add 223 224; mul 110 141; mul 111 226; add 225 227; mul 0 228; mul 0 229; mul 0 230; neg 231; input p 29; sub 233 0;
input qm 3; mul 32 32; mul 110 236; mul 32 38; mul 72 238; add 237 239; mul 38 38; mul 75 241; add 240 242; mul 23
32; mul 28 244; add 243 245; mul 23 38; mul 35 247; add 246 248; mul 23 23; mul 14 250; add 249 251; mul 25 252; sub
235 253; sub 234 254; input p 27; input p 28; sub 256 257; constant 1.0; mul 35 38; add 24 260; mul 32 72; add 261
262; mul 263 263; add 259 264; sqrt 265; div 259 266; mul 258 267; add 255 268; input p 26; mul 263 267; mul 270
271; add 269 272; mul 11 273; constant 8.854e-12; input p 32; mul 275 276; input p 36; mul 277 278; input p 35; mul
279 280; input p 34; mul 281 282; input p 33; div 259 284; mul 283 285; constant -0.5; input v_squared 1; mul 287
288; mul 286 289; input p 31; div 259 291; mul 290 292; mul 258 271; mul 267 270; input p 30; sub 295 296; sub 294
297; add 23 38; add 32 299; mul 0 300; sub 298 301; mul 302 302; mul 273 273; add 303 304; sqrt 305; mul 11 306; div
259 307; mul 293 308; mul 274 309; input p 14; sub 311 0; sub 312 254; input p 12; input p 13; sub 314 315; mul 267
316; add 313 317; input p 11; mul 271 319; sub 318 320; mul 11 321; input p 17; mul 275 323; input p 21; mul 324
325; input p 20; mul 326 327; input p 19; mul 328 329; input p 18; div 259 331; mul 330 332; input v_squared 0; mul
287 334; mul 333 335; input p 16; div 259 337; mul 336 338; mul 267 319; input p 15; sub 340 341; mul 271 316; add
342 343; sub 344 301; mul 345 345; mul 321 321; add 346 347; sqrt 348; mul 11 349; div 259 350; mul 339 351; mul 322
352; add 310 353; mul 25 354; mul 14 355; mul 24 356; mul 35 355; mul 38 358; add 357 359; mul 28 355; mul 32 361;
add 360 362; mul 11 302; mul 309 364; mul 11 345; mul 352 366; add 365 367; mul 0 368; sub 363 369; mul 270 310; mul
258 365; add 371 372; mul 319 353; sub 373 374; mul 316 367; add 375 376; mul 267 377; mul 11 263; mul 267 295; mul
365 380; mul 267 268; mul 310 382; sub 381 383; mul 267 317; mul 353 385; sub 384 386; mul 267 271; mul 377 388; sub
387 389; mul 267 340; mul 367 391; sub 390 392; mul 11 266; div 259 394; mul 393 395; mul 379 396; add 378 397; mul
11 398; add 370 399; mul 0 400; mul 292 306; mul 11 402; mul 276 282; mul 284 404; input p 37; mul 405 406; constant
6.0; div 259 408; mul 407 409; mul 403 410; div 259 402; mul 11 412; mul 412 413; mul 410 414; sub 411 415; mul 292
416; mul 308 417; mul 274 418; mul 338 349; mul 11 420; mul 323 329; mul 331 422; input p 22; mul 423 424; mul 409
425; mul 421 426; div 259 420; mul 11 428; mul 428 429; mul 426 430; sub 427 431; mul 338 432; mul 351 433; mul 322
434; add 419 435; mul 25 436; mul 14 437; mul 24 438; mul 35 437; mul 38 440; add 439 441; mul 28 437; mul 32 443;
add 442 444; mul 364 418; mul 366 434; add 446 447; mul 0 448; sub 445 449; mul 270 419; mul 258 446; add 451 452;
mul 319 435; sub 453 454; mul 316 447; add 455 456; mul 267 457; mul 380 446; mul 382 419; sub 459 460; mul 385 435;
sub 461 462; mul 388 457; sub 463 464; mul 391 447; sub 465 466; mul 395 467; mul 379 468; add 458 469; mul 11 470;
add 450 471; mul 0 472; add 401 473; input p 7; mul 26 475; mul 25 476; mul 14 477; mul 24 478; mul 35 477; mul 38
480; add 479 481; mul 28 477; mul 32 483; add 482 484; mul 0 485; sub 474 486; mul 23 250; constant
5.333333333333333; input p 3; mul 6 490; div 259 0; mul 491 492; mul 15 493; mul 489 494; mul 488 495; mul 23 495;
mul 250 497; add 496 498; mul 23 497; mul 24 500; add 499 501; constant 36.0; mul 494 503; mul 38 504; mul 250 505;
add 502 506; mul 23 505; mul 24 508; add 507 509; constant 51.2; mul 494 511; mul 32 512; mul 250 513; add 510 514;
mul 23 513; mul 24 516; add 515 517; constant -5.333333333333333; input p 8; mul 0 520; mul 519 521; mul 494 522;
mul 250 523; add 518 524; mul 23 523; mul 24 526; add 525 527; constant 93.60000000000001; mul 494 529; mul 38 530;
mul 38 531; mul 24 532; add 528 533; constant 272.0; mul 494 535; mul 32 536; mul 38 537; mul 24 538; add 534 539;
constant -24.0; mul 521 541; mul 494 542; mul 38 543; mul 24 544; add 540 545; constant 201.14285714285714; mul 494
547; mul 32 548; mul 32 549; mul 24 550; add 546 551; constant -32.0; mul 521 553; mul 494 554; mul 32 555; mul 24
556; add 552 557; mul 521 521; mul 14 559; add 72 560; mul 494 561; mul 24 562; add 558 563; constant 108.0; mul 494
565; mul 38 566; mul 38 567; mul 38 568; add 564 569; constant 473.1428571428571; mul 494 571; mul 32 572; mul 38
573; mul 38 574; add 570 575; constant -36.0; mul 521 577; mul 494 578; mul 38 579; mul 38 580; add 576 581;
constant 696.0; mul 494 583; mul 32 584; mul 32 585; mul 38 586; add 582 587; constant -96.0; mul 521 589; mul 494
590; mul 32 591; mul 38 592; add 588 593; constant 12.0; mul 35 559; add 595 596; mul 494 597; mul 38 598; add 594
599; constant 341.3333333333333; mul 494 601; mul 32 602; mul 32 603; mul 32 604; add 600 605; constant -64.0; mul
521 607; mul 494 608; mul 32 609; mul 32 610; add 606 611; constant 16.0; mul 28 559; add 613 614; mul 494 615; mul
32 616; add 612 617; constant -4.0; mul 521 619; mul 494 620; add 618 621; mul 0 622; add 487 623; input qm_dot 3;
input qm_dot 2; mul 0 626; mul 0 627; mul 0 628; mul 111 629; mul 110 630; input qm_dot 1; mul 0 632; mul 0 633; mul
32 634; mul 38 629; add 635 636; mul 72 637; add 631 638; mul 76 634; mul 75 640; add 639 641; input qm_dot 0; mul 0
643; mul 32 644; mul 23 629; add 645 646; mul 28 647; add 642 648; mul 38 644; mul 23 634; add 650 651; mul 35 652;
add 649 653; mul 24 644; mul 14 655; add 654 656; mul 25 657; sub 625 658; mul 11 659; mul 27 660; mul 25 661; mul
14 662; mul 11 644; mul 663 664; mul 11 629; mul 629 666; mul 110 667; constant 8.0; mul 629 634; mul 669 670; add
668 671; mul 11 634; mul 634 673; mul 75 674; add 672 675; constant 6.4; mul 629 644; mul 677 678; add 676 679; mul
634 644; mul 408 681; add 680 682; mul 644 664; mul 14 684; add 683 685; mul 25 686; neg 687; mul 11 688; mul 27
689; mul 25 690; mul 14 691; mul 24 692; add 665 693; mul 35 662; mul 634 695; mul 35 691; mul 38 697; add 696 698;
add 694 699; mul 28 662; mul 629 701; mul 28 691; mul 32 703; add 702 704; add 700 705; mul 0 706; mul 644 663; neg
708; mul 11 709; sub 710 696; sub 711 702; mul 0 712; add 707 713; sub 624 714; sqrt 402; div 259 716; mul 717 717;
mul 35 634; add 664 719; mul 72 629; add 720 721; mul 267 722; mul 379 722; mul 395 724; mul 388 725; sub 723 726;
mul 258 727; mul 380 725; add 728 729; add 634 644; add 629 731; mul 0 732; sub 730 733; mul 364 734; mul 270 727;
mul 382 725; add 659 737; sub 736 738; mul 274 739; add 735 740; mul 308 741; mul 292 742; mul 11 716; div 259 744;
mul 743 745; mul 718 746; mul 11 747; mul 6 405; input p 40; mul 749 750; mul 748 751; mul 718 752; mul 745 753; mul
292 754; mul 308 755; mul 274 756; sqrt 420; div 259 758; mul 759 759; mul 316 727; mul 391 725; sub 761 762; sub
763 733; mul 366 764; mul 385 725; add 659 766; mul 319 727; add 767 768; mul 322 769; sub 765 770; mul 351 771; mul
338 772; mul 11 758; div 259 774; mul 773 775; mul 760 776; mul 11 777; mul 6 423; input p 25; mul 779 780; mul 778
781; mul 760 782; mul 775 783; mul 338 784; mul 351 785; mul 322 786; add 757 787; mul 25 788; mul 14 789; mul 24
790; mul 35 789; mul 38 792; add 791 793; mul 28 789; mul 32 795; add 794 796; mul 364 756; mul 366 786; add 798
799; mul 0 800; sub 797 801; mul 380 798; mul 382 757; sub 803 804; mul 385 787; sub 805 806; mul 391 799; sub 807
808; mul 270 757; mul 258 798; add 810 811; mul 319 787; sub 812 813; mul 316 799; add 814 815; mul 388 816; sub 809
817; mul 395 818; mul 379 819; mul 267 816; add 820 821; mul 11 822; add 802 823; mul 0 824; input p 5; mul 11 826;
mul 15 827; mul 6 828; mul 492 829; mul 72 830; mul 664 831; mul 595 830; mul 634 833; add 832 834; mul 613 830; mul
629 836; add 835 837; mul 0 838; add 825 839; add 715 840; input p 9; mul 3 842; input z 2; mul 843 844; input p 23;
mul 423 846; mul 12 267; mul 12 379; mul 395 849; mul 388 850; sub 848 851; mul 316 852; mul 391 850; sub 853 854;
sub 855 3; mul 366 856; mul 385 850; sub 45 858; mul 319 852; sub 859 860; mul 322 861; add 857 862; mul 351 863;
mul 338 864; mul 775 865; mul 760 866; mul 847 867; input z 0; mul 868 869; input p 38; mul 405 871; mul 258 852;
mul 380 850; add 873 874; sub 875 3; mul 364 876; mul 382 850; sub 45 878; mul 270 852; add 879 880; mul 274 881;
add 877 882; mul 308 883; mul 292 884; mul 745 885; mul 718 886; mul 872 887; input z 1; mul 888 889; add 870 890;
sub 845 891; add 841 892; input force 0; mul 3 894; sub 893 895; neg 896; mul 23 358; mul 75 355; mul 76 899; add
898 900; mul 72 355; mul 32 902; add 901 903; sub 904 369; mul 35 398; add 905 906; mul 0 907; mul 0 908; mul 23
440; mul 75 437; mul 76 911; add 910 912; mul 72 437; mul 32 914; add 913 915; sub 916 449; mul 35 470; add 917 918;
mul 0 919; mul 0 920; add 909 921; mul 23 480; mul 75 477; mul 76 924; add 923 925; mul 72 477; mul 32 927; add 926
928; mul 0 929; mul 0 930; sub 922 931; mul 488 504; mul 38 250; mul 530 934; add 933 935; mul 250 531; add 936 937;
mul 250 537; add 938 939; mul 250 543; add 940 941; mul 38 247; mul 566 943; add 942 944; mul 247 567; add 945 946;
mul 23 568; add 947 948; mul 247 573; add 949 950; mul 23 574; add 951 952; mul 247 579; add 953 954; mul 23 580;
add 955 956; mul 23 586; add 957 958; mul 23 592; add 959 960; mul 23 598; add 961 962; mul 38 241; constant
46.285714285714285; mul 494 965; mul 964 966; add 963 967; mul 38 966; mul 241 969; add 968 970; mul 38 969; mul 76
972; add 971 973; constant 270.0; mul 494 975; mul 32 976; mul 241 977; add 974 978; mul 38 977; mul 76 980; add 979
981; constant -18.0; mul 521 983; mul 494 984; mul 241 985; add 982 986; mul 38 985; mul 76 988; add 987 989;
constant 592.0; mul 494 991; mul 32 992; mul 32 993; mul 76 994; add 990 995; constant -72.0; mul 521 997; mul 494
998; mul 32 999; mul 76 1000; add 996 1001; mul 75 559; add 595 1003; mul 494 1004; mul 76 1005; add 1002 1006;
constant 576.0; mul 494 1008; mul 32 1009; mul 32 1010; mul 32 1011; add 1007 1012; mul 32 592; add 1013 1014; mul
72 559; add 503 1016; mul 494 1017; mul 32 1018; add 1015 1019; constant -6.0; mul 521 1021; mul 494 1022; add 1020
1023; mul 0 1024; mul 0 1025; add 932 1026; mul 644 695; mul 23 697; add 1028 1029; mul 75 662; mul 673 1031; mul 75
691; mul 76 1033; add 1032 1034; add 1030 1035; mul 72 662; mul 629 1037; mul 72 691; mul 32 1039; add 1038 1040;
add 1036 1041; mul 0 1042; mul 0 1043; mul 634 1031; neg 1045; mul 11 1046; sub 1047 1028; sub 1048 1038; mul 0
1049; mul 0 1050; add 1044 1051; sub 1027 1052; mul 23 792; mul 75 789; mul 76 1055; add 1054 1056; mul 72 789; mul
32 1058; add 1057 1059; sub 1060 801; mul 35 822; add 1061 1062; mul 0 1063; mul 0 1064; mul 644 833; mul 673 833;
add 1066 1067; mul 503 830; mul 629 1069; add 1068 1070; mul 0 1071; mul 0 1072; add 1065 1073; add 1053 1074; mul 4
842; mul 844 1076; mul 3 35; mul 267 1078; mul 379 1078; mul 395 1080; mul 388 1081; sub 1079 1082; mul 316 1083;
mul 391 1081; sub 1084 1085; sub 1086 4; mul 366 1087; mul 385 1081; sub 83 1089; mul 319 1083; sub 1090 1091; mul
322 1092; add 1088 1093; mul 351 1094; mul 338 1095; mul 775 1096; mul 760 1097; mul 847 1098; mul 869 1099; mul 258
1083; mul 380 1081; add 1101 1102; sub 1103 4; mul 364 1104; mul 382 1081; sub 83 1106; mul 270 1083; add 1107 1108;
mul 274 1109; add 1105 1110; mul 308 1111; mul 292 1112; mul 745 1113; mul 718 1114; mul 872 1115; mul 889 1116; add
1100 1117; sub 1077 1118; add 1075 1119; mul 4 894; sub 1120 1121; neg 1122; mul 23 361; mul 38 902; add 1124 1125;
mul 110 355; mul 111 1127; add 1126 1128; sub 1129 369; mul 72 398; add 1130 1131; mul 0 1132; mul 0 1133; mul 0
1134; mul 23 443; mul 38 914; add 1136 1137; mul 110 437; mul 111 1139; add 1138 1140; sub 1141 449; mul 72 470; add
1142 1143; mul 0 1144; mul 0 1145; mul 0 1146; add 1135 1147; mul 23 483; mul 38 927; add 1149 1150; mul 110 477;
mul 111 1152; add 1151 1153; mul 0 1154; mul 0 1155; mul 0 1156; sub 1148 1157; mul 488 512; mul 536 934; add 1159
1160; mul 32 250; mul 548 1162; add 1161 1163; mul 250 549; add 1164 1165; mul 250 555; add 1166 1167; mul 572 943;
add 1168 1169; mul 32 247; mul 584 1171; add 1170 1172; mul 247 585; add 1173 1174; mul 247 591; add 1175 1176; mul
32 244; mul 602 1178; add 1177 1179; mul 244 603; add 1180 1181; mul 23 604; add 1182 1183; mul 244 609; add 1184
1185; mul 23 610; add 1186 1187; mul 23 616; add 1188 1189; mul 964 976; add 1190 1191; mul 32 241; mul 992 1193;
add 1192 1194; mul 241 993; add 1195 1196; mul 241 999; add 1197 1198; mul 32 238; mul 1009 1200; add 1199 1201; mul
238 1010; add 1202 1203; mul 38 1011; add 1204 1205; mul 238 591; add 1206 1207; add 593 1208; mul 38 1018; add 1209
1210; mul 32 236; constant 209.45454545454547; mul 494 1213; mul 1212 1214; add 1211 1215; mul 32 1214; mul 236
1217; add 1216 1218; mul 32 1217; mul 111 1220; add 1219 1221; constant -42.666666666666664; mul 521 1223; mul 494
1224; mul 236 1225; add 1222 1226; mul 32 1225; mul 111 1228; add 1227 1229; constant 28.8; mul 110 559; add 1231
1232; mul 494 1233; mul 111 1234; add 1230 1235; constant -8.0; mul 521 1237; mul 494 1238; add 1236 1239; mul 0
1240; mul 0 1241; mul 0 1242; add 1158 1243; mul 644 701; mul 23 703; add 1245 1246; mul 634 1037; mul 38 1039; add
1248 1249; add 1247 1250; mul 110 662; mul 666 1252; mul 110 691; mul 111 1254; add 1253 1255; add 1251 1256; mul 0
1257; mul 0 1258; mul 0 1259; mul 629 1252; neg 1261; mul 11 1262; add 1245 1248; sub 1263 1264; mul 0 1265; mul 0
1266; mul 0 1267; add 1260 1268; sub 1244 1269; mul 23 795; mul 38 1058; add 1271 1272; mul 110 789; mul 111 1274;
add 1273 1275; sub 1276 801; mul 72 822; add 1277 1278; mul 0 1279; mul 0 1280; mul 0 1281; mul 644 836; mul 634
1069; add 1283 1284; mul 830 1231; mul 666 1286; add 1285 1287; mul 0 1288; mul 0 1289; mul 0 1290; add 1282 1291;
add 1270 1292; mul 135 842; mul 844 1294; mul 4 72; mul 267 1296; mul 379 1296; mul 395 1298; mul 388 1299; sub 1297
1300; mul 316 1301; mul 391 1299; sub 1302 1303; sub 1304 135; mul 366 1305; mul 385 1299; sub 120 1307; mul 319
1301; sub 1308 1309; mul 322 1310; add 1306 1311; mul 351 1312; mul 338 1313; mul 775 1314; mul 760 1315; mul 847
1316; mul 869 1317; mul 258 1301; mul 380 1299; add 1319 1320; sub 1321 135; mul 364 1322; mul 382 1299; sub 120
1324; mul 270 1301; add 1325 1326; mul 274 1327; add 1323 1328; mul 308 1329; mul 292 1330; mul 745 1331; mul 718
1332; mul 872 1333; mul 889 1334; add 1318 1335; sub 1295 1336; add 1293 1337; mul 135 894; sub 1338 1339; neg 1340;
add 354 436; sub 476 1342; mul 11 235; mul 2 493; mul 1344 1345; add 1343 1346; add 690 1347; sub 1348 788; div 259
349; mul 321 1350; mul 338 1351; mul 775 1352; mul 760 1353; mul 847 1354; mul 869 1355; div 259 306; mul 273 1357;
mul 292 1358; mul 745 1359; mul 718 1360; mul 872 1361; mul 889 1362; add 1356 1363; add 1349 1364; neg 1365; input
p 24; div 259 1367; mul 846 1368; mul 869 1369; add 777 1370; neg 1371; input p 39; div 259 1373; mul 871 1374; mul
889 1375; add 747 1376; neg 1377; abs 733; mul 844 1379; sub 733 1380; input p 10; div 259 1382; mul 1381 1383;
store mass 0 64; store mass 4 102; store mass 8 140; store mass 12 151; store mass 1 102; store mass 5 171; store
mass 9 191; store mass 13 201; store mass 2 140; store mass 6 191; store mass 10 222; store mass 14 232; store mass
3 151; store mass 7 201; store mass 11 232; store mass 15 26; store tau 0 897; store tau 1 1123; store tau 2 1341;
store tau 3 1366; store z_dot 0 1372; store z_dot 1 1378; store z_dot 2 1384
    """,
)

MOTION = Graph(
    {'x': 11, 'v_squared': 2, 'force': 1, 'p': 41},
    {'mass': 16, 'right': 11},
    """
input p 0; constant 0.2; input p 1; mul 0 0; mul 0 3; mul 2 4; constant 0.5; input p 4; mul 6 7; mul 5 8; mul 1 9;
constant 2.0; mul 0 11; mul 10 12; constant 1.3333333333333333; input p 2; mul 0 15; mul 8 16; mul 14 17; mul 12 18;
add 13 19; mul 0 20; input x 0; mul 0 22; mul 11 23; mul 0 6; input p 6; mul 6 26; constant 3.2; input x 2; mul 0
29; mul 0 30; mul 0 31; mul 0 32; mul 28 33; constant 3.0; input x 1; mul 0 36; mul 0 37; mul 0 38; mul 35 39; add
34 40; mul 0 24; mul 14 42; add 41 43; mul 25 44; neg 45; mul 11 46; mul 27 47; mul 25 48; mul 14 49; mul 24 50; mul
35 49; mul 38 52; add 51 53; mul 28 49; mul 32 55; add 54 56; mul 0 57; sub 21 58; mul 3 11; mul 27 60; mul 0 61;
mul 0 62; add 59 63; constant 0.3333333333333333; mul 9 65; mul 3 66; mul 17 35; mul 3 68; add 67 69; mul 0 70;
constant 4.0; mul 3 32; mul 72 73; constant 1.8; mul 11 38; mul 3 76; mul 75 77; add 74 78; mul 3 23; mul 35 80; add
79 81; mul 25 82; neg 83; mul 11 84; mul 27 85; mul 25 86; mul 14 87; mul 24 88; mul 35 87; mul 38 90; add 89 91;
mul 28 87; mul 32 93; add 92 94; mul 0 95; sub 71 96; mul 4 11; mul 27 98; mul 0 99; mul 0 100; add 97 101; constant
0.2857142857142857; mul 9 103; mul 4 104; mul 17 28; mul 4 106; add 105 107; mul 0 108; constant 2.2857142857142856;
mul 11 32; mul 4 111; mul 110 112; mul 4 38; mul 72 114; add 113 115; mul 4 23; mul 28 117; add 116 118; mul 25 119;
neg 120; mul 11 121; mul 27 122; mul 25 123; mul 14 124; mul 24 125; mul 35 124; mul 38 127; add 126 128; mul 28
124; mul 32 130; add 129 131; mul 0 132; sub 109 133; mul 0 4; mul 11 135; mul 27 136; mul 0 137; mul 0 138; add 134
139; mul 25 26; mul 14 141; mul 24 142; mul 35 141; mul 38 144; add 143 145; mul 28 141; mul 32 147; add 146 148;
mul 0 149; neg 150; constant 0.14285714285714285; mul 9 152; mul 60 153; mul 17 75; mul 60 155; add 154 156; mul 0
157; mul 0 158; mul 23 90; mul 75 87; mul 76 161; add 160 162; mul 72 87; mul 32 164; add 163 165; mul 0 166; mul 0
167; sub 159 168; mul 0 101; add 169 170; constant 0.25; mul 9 172; mul 4 173; mul 17 72; mul 4 175; add 174 176;
mul 0 177; mul 0 178; mul 23 127; mul 75 124; mul 76 181; add 180 182; mul 72 124; mul 32 184; add 183 185; mul 0
186; mul 0 187; sub 179 188; mul 0 139; add 189 190; mul 23 144; mul 75 141; mul 76 193; add 192 194; mul 72 141;
mul 32 196; add 195 197; mul 0 198; mul 0 199; neg 200; constant 0.1111111111111111; mul 9 202; mul 98 203; mul 17
110; mul 98 205; add 204 206; mul 0 207; mul 0 208; mul 0 209; mul 23 130; mul 38 184; add 211 212; mul 110 124; mul
111 214; add 213 215; mul 0 216; mul 0 217; mul 0 218; sub 210 219; mul 0 190; add 220 221; mul 23 147; mul 38 196;
add 223 224; mul 110 141; mul 111 226; add 225 227; mul 0 228; mul 0 229; mul 0 230; neg 231; input x 4; input x 5;
input x 6; input x 7; input p 29; sub 237 0; input x 3; mul 32 32; mul 110 240; mul 32 38; mul 72 242; add 241 243;
mul 38 38; mul 75 245; add 244 246; mul 23 32; mul 28 248; add 247 249; mul 23 38; mul 35 251; add 250 252; mul 23
23; mul 14 254; add 253 255; mul 25 256; sub 239 257; sub 238 258; input p 27; input p 28; sub 260 261; constant
1.0; mul 35 38; add 24 264; mul 32 72; add 265 266; mul 267 267; add 263 268; sqrt 269; div 263 270; mul 262 271;
add 259 272; input p 26; mul 267 271; mul 274 275; add 273 276; mul 11 277; constant 8.854e-12; input p 32; mul 279
280; input p 36; mul 281 282; input p 35; mul 283 284; input p 34; mul 285 286; input p 33; div 263 288; mul 287
289; constant -0.5; input v_squared 1; mul 291 292; mul 290 293; input p 31; div 263 295; mul 294 296; mul 262 275;
mul 271 274; input p 30; sub 299 300; sub 298 301; add 23 38; add 32 303; mul 0 304; sub 302 305; mul 306 306; mul
277 277; add 307 308; sqrt 309; mul 11 310; div 263 311; mul 297 312; mul 278 313; input p 14; sub 315 0; sub 316
258; input p 12; input p 13; sub 318 319; mul 271 320; add 317 321; input p 11; mul 275 323; sub 322 324; mul 11
325; input p 17; mul 279 327; input p 21; mul 328 329; input p 20; mul 330 331; input p 19; mul 332 333; input p 18;
div 263 335; mul 334 336; input v_squared 0; mul 291 338; mul 337 339; input p 16; div 263 341; mul 340 342; mul 271
323; input p 15; sub 344 345; mul 275 320; add 346 347; sub 348 305; mul 349 349; mul 325 325; add 350 351; sqrt
352; mul 11 353; div 263 354; mul 343 355; mul 326 356; add 314 357; mul 25 358; mul 14 359; mul 24 360; mul 35 359;
mul 38 362; add 361 363; mul 28 359; mul 32 365; add 364 366; mul 11 306; mul 313 368; mul 11 349; mul 356 370; add
369 371; mul 0 372; sub 367 373; mul 274 314; mul 262 369; add 375 376; mul 323 357; sub 377 378; mul 320 371; add
379 380; mul 271 381; mul 11 267; mul 271 299; mul 369 384; mul 271 272; mul 314 386; sub 385 387; mul 271 321; mul
357 389; sub 388 390; mul 271 275; mul 381 392; sub 391 393; mul 271 344; mul 371 395; sub 394 396; mul 11 270; div
263 398; mul 397 399; mul 383 400; add 382 401; mul 11 402; add 374 403; mul 0 404; mul 296 310; mul 11 406; mul 280
286; mul 288 408; input p 37; mul 409 410; constant 6.0; div 263 412; mul 411 413; mul 407 414; div 263 406; mul 11
416; mul 416 417; mul 414 418; sub 415 419; mul 296 420; mul 312 421; mul 278 422; mul 342 353; mul 11 424; mul 327
333; mul 335 426; input p 22; mul 427 428; mul 413 429; mul 425 430; div 263 424; mul 11 432; mul 432 433; mul 430
434; sub 431 435; mul 342 436; mul 355 437; mul 326 438; add 423 439; mul 25 440; mul 14 441; mul 24 442; mul 35
441; mul 38 444; add 443 445; mul 28 441; mul 32 447; add 446 448; mul 368 422; mul 370 438; add 450 451; mul 0 452;
sub 449 453; mul 274 423; mul 262 450; add 455 456; mul 323 439; sub 457 458; mul 320 451; add 459 460; mul 271 461;
mul 384 450; mul 386 423; sub 463 464; mul 389 439; sub 465 466; mul 392 461; sub 467 468; mul 395 451; sub 469 470;
mul 399 471; mul 383 472; add 462 473; mul 11 474; add 454 475; mul 0 476; add 405 477; input p 7; mul 26 479; mul
25 480; mul 14 481; mul 24 482; mul 35 481; mul 38 484; add 483 485; mul 28 481; mul 32 487; add 486 488; mul 0 489;
sub 478 490; mul 23 254; constant 5.333333333333333; input p 3; mul 6 494; div 263 0; mul 495 496; mul 15 497; mul
493 498; mul 492 499; mul 23 499; mul 254 501; add 500 502; mul 23 501; mul 24 504; add 503 505; constant 36.0; mul
498 507; mul 38 508; mul 254 509; add 506 510; mul 23 509; mul 24 512; add 511 513; constant 51.2; mul 498 515; mul
32 516; mul 254 517; add 514 518; mul 23 517; mul 24 520; add 519 521; constant -5.333333333333333; input p 8; mul 0
524; mul 523 525; mul 498 526; mul 254 527; add 522 528; mul 23 527; mul 24 530; add 529 531; constant
93.60000000000001; mul 498 533; mul 38 534; mul 38 535; mul 24 536; add 532 537; constant 272.0; mul 498 539; mul 32
540; mul 38 541; mul 24 542; add 538 543; constant -24.0; mul 525 545; mul 498 546; mul 38 547; mul 24 548; add 544
549; constant 201.14285714285714; mul 498 551; mul 32 552; mul 32 553; mul 24 554; add 550 555; constant -32.0; mul
525 557; mul 498 558; mul 32 559; mul 24 560; add 556 561; mul 525 525; mul 14 563; add 72 564; mul 498 565; mul 24
566; add 562 567; constant 108.0; mul 498 569; mul 38 570; mul 38 571; mul 38 572; add 568 573; constant
473.1428571428571; mul 498 575; mul 32 576; mul 38 577; mul 38 578; add 574 579; constant -36.0; mul 525 581; mul
498 582; mul 38 583; mul 38 584; add 580 585; constant 696.0; mul 498 587; mul 32 588; mul 32 589; mul 38 590; add
586 591; constant -96.0; mul 525 593; mul 498 594; mul 32 595; mul 38 596; add 592 597; constant 12.0; mul 35 563;
add 599 600; mul 498 601; mul 38 602; add 598 603; constant 341.3333333333333; mul 498 605; mul 32 606; mul 32 607;
mul 32 608; add 604 609; constant -64.0; mul 525 611; mul 498 612; mul 32 613; mul 32 614; add 610 615; constant
16.0; mul 28 563; add 617 618; mul 498 619; mul 32 620; add 616 621; constant -4.0; mul 525 623; mul 498 624; add
622 625; mul 0 626; add 491 627; mul 0 235; mul 0 629; mul 0 630; mul 111 631; mul 110 632; mul 0 234; mul 0 634;
mul 32 635; mul 38 631; add 636 637; mul 72 638; add 633 639; mul 76 635; mul 75 641; add 640 642; mul 0 233; mul 32
644; mul 23 631; add 645 646; mul 28 647; add 643 648; mul 38 644; mul 23 635; add 650 651; mul 35 652; add 649 653;
mul 24 644; mul 14 655; add 654 656; mul 25 657; sub 236 658; mul 11 659; mul 27 660; mul 25 661; mul 14 662; mul 11
644; mul 663 664; mul 11 631; mul 631 666; mul 110 667; constant 8.0; mul 631 635; mul 669 670; add 668 671; mul 11
635; mul 635 673; mul 75 674; add 672 675; constant 6.4; mul 631 644; mul 677 678; add 676 679; mul 635 644; mul 412
681; add 680 682; mul 644 664; mul 14 684; add 683 685; mul 25 686; neg 687; mul 11 688; mul 27 689; mul 25 690; mul
14 691; mul 24 692; add 665 693; mul 35 662; mul 635 695; mul 35 691; mul 38 697; add 696 698; add 694 699; mul 28
662; mul 631 701; mul 28 691; mul 32 703; add 702 704; add 700 705; mul 0 706; mul 644 663; neg 708; mul 11 709; sub
710 696; sub 711 702; mul 0 712; add 707 713; sub 628 714; sqrt 406; div 263 716; mul 717 717; mul 35 635; add 664
719; mul 72 631; add 720 721; mul 271 722; mul 383 722; mul 399 724; mul 392 725; sub 723 726; mul 262 727; mul 384
725; add 728 729; add 635 644; add 631 731; mul 0 732; sub 730 733; mul 368 734; mul 274 727; mul 386 725; add 659
737; sub 736 738; mul 278 739; add 735 740; mul 312 741; mul 296 742; mul 11 716; div 263 744; mul 743 745; mul 718
746; mul 11 747; mul 6 409; input p 40; mul 749 750; mul 748 751; mul 718 752; mul 745 753; mul 296 754; mul 312
755; mul 278 756; sqrt 424; div 263 758; mul 759 759; mul 320 727; mul 395 725; sub 761 762; sub 763 733; mul 370
764; mul 389 725; add 659 766; mul 323 727; add 767 768; mul 326 769; sub 765 770; mul 355 771; mul 342 772; mul 11
758; div 263 774; mul 773 775; mul 760 776; mul 11 777; mul 6 427; input p 25; mul 779 780; mul 778 781; mul 760
782; mul 775 783; mul 342 784; mul 355 785; mul 326 786; add 757 787; mul 25 788; mul 14 789; mul 24 790; mul 35
789; mul 38 792; add 791 793; mul 28 789; mul 32 795; add 794 796; mul 368 756; mul 370 786; add 798 799; mul 0 800;
sub 797 801; mul 384 798; mul 386 757; sub 803 804; mul 389 787; sub 805 806; mul 395 799; sub 807 808; mul 274 757;
mul 262 798; add 810 811; mul 323 787; sub 812 813; mul 320 799; add 814 815; mul 392 816; sub 809 817; mul 399 818;
mul 383 819; mul 271 816; add 820 821; mul 11 822; add 802 823; mul 0 824; input p 5; mul 11 826; mul 15 827; mul 6
828; mul 496 829; mul 72 830; mul 664 831; mul 599 830; mul 635 833; add 832 834; mul 617 830; mul 631 836; add 835
837; mul 0 838; add 825 839; add 715 840; input p 9; mul 3 842; input x 10; mul 843 844; input p 23; mul 427 846;
mul 12 271; mul 12 383; mul 399 849; mul 392 850; sub 848 851; mul 320 852; mul 395 850; sub 853 854; sub 855 3; mul
370 856; mul 389 850; sub 45 858; mul 323 852; sub 859 860; mul 326 861; add 857 862; mul 355 863; mul 342 864; mul
775 865; mul 760 866; mul 847 867; input x 8; mul 868 869; input p 38; mul 409 871; mul 262 852; mul 384 850; add
873 874; sub 875 3; mul 368 876; mul 386 850; sub 45 878; mul 274 852; add 879 880; mul 278 881; add 877 882; mul
312 883; mul 296 884; mul 745 885; mul 718 886; mul 872 887; input x 9; mul 888 889; add 870 890; sub 845 891; add
841 892; input force 0; mul 3 894; sub 893 895; neg 896; mul 23 362; mul 75 359; mul 76 899; add 898 900; mul 72
359; mul 32 902; add 901 903; sub 904 373; mul 35 402; add 905 906; mul 0 907; mul 0 908; mul 23 444; mul 75 441;
mul 76 911; add 910 912; mul 72 441; mul 32 914; add 913 915; sub 916 453; mul 35 474; add 917 918; mul 0 919; mul 0
920; add 909 921; mul 23 484; mul 75 481; mul 76 924; add 923 925; mul 72 481; mul 32 927; add 926 928; mul 0 929;
mul 0 930; sub 922 931; mul 492 508; mul 38 254; mul 534 934; add 933 935; mul 254 535; add 936 937; mul 254 541;
add 938 939; mul 254 547; add 940 941; mul 38 251; mul 570 943; add 942 944; mul 251 571; add 945 946; mul 23 572;
add 947 948; mul 251 577; add 949 950; mul 23 578; add 951 952; mul 251 583; add 953 954; mul 23 584; add 955 956;
mul 23 590; add 957 958; mul 23 596; add 959 960; mul 23 602; add 961 962; mul 38 245; constant 46.285714285714285;
mul 498 965; mul 964 966; add 963 967; mul 38 966; mul 245 969; add 968 970; mul 38 969; mul 76 972; add 971 973;
constant 270.0; mul 498 975; mul 32 976; mul 245 977; add 974 978; mul 38 977; mul 76 980; add 979 981; constant
-18.0; mul 525 983; mul 498 984; mul 245 985; add 982 986; mul 38 985; mul 76 988; add 987 989; constant 592.0; mul
498 991; mul 32 992; mul 32 993; mul 76 994; add 990 995; constant -72.0; mul 525 997; mul 498 998; mul 32 999; mul
76 1000; add 996 1001; mul 75 563; add 599 1003; mul 498 1004; mul 76 1005; add 1002 1006; constant 576.0; mul 498
1008; mul 32 1009; mul 32 1010; mul 32 1011; add 1007 1012; mul 32 596; add 1013 1014; mul 72 563; add 507 1016; mul
498 1017; mul 32 1018; add 1015 1019; constant -6.0; mul 525 1021; mul 498 1022; add 1020 1023; mul 0 1024; mul 0
1025; add 932 1026; mul 644 695; mul 23 697; add 1028 1029; mul 75 662; mul 673 1031; mul 75 691; mul 76 1033; add
1032 1034; add 1030 1035; mul 72 662; mul 631 1037; mul 72 691; mul 32 1039; add 1038 1040; add 1036 1041; mul 0
1042; mul 0 1043; mul 635 1031; neg 1045; mul 11 1046; sub 1047 1028; sub 1048 1038; mul 0 1049; mul 0 1050; add
1044 1051; sub 1027 1052; mul 23 792; mul 75 789; mul 76 1055; add 1054 1056; mul 72 789; mul 32 1058; add 1057
1059; sub 1060 801; mul 35 822; add 1061 1062; mul 0 1063; mul 0 1064; mul 644 833; mul 673 833; add 1066 1067; mul
507 830; mul 631 1069; add 1068 1070; mul 0 1071; mul 0 1072; add 1065 1073; add 1053 1074; mul 4 842; mul 844 1076;
mul 3 35; mul 271 1078; mul 383 1078; mul 399 1080; mul 392 1081; sub 1079 1082; mul 320 1083; mul 395 1081; sub
1084 1085; sub 1086 4; mul 370 1087; mul 389 1081; sub 83 1089; mul 323 1083; sub 1090 1091; mul 326 1092; add 1088
1093; mul 355 1094; mul 342 1095; mul 775 1096; mul 760 1097; mul 847 1098; mul 869 1099; mul 262 1083; mul 384
1081; add 1101 1102; sub 1103 4; mul 368 1104; mul 386 1081; sub 83 1106; mul 274 1083; add 1107 1108; mul 278 1109;
add 1105 1110; mul 312 1111; mul 296 1112; mul 745 1113; mul 718 1114; mul 872 1115; mul 889 1116; add 1100 1117;
sub 1077 1118; add 1075 1119; mul 4 894; sub 1120 1121; neg 1122; mul 23 365; mul 38 902; add 1124 1125; mul 110
359; mul 111 1127; add 1126 1128; sub 1129 373; mul 72 402; add 1130 1131; mul 0 1132; mul 0 1133; mul 0 1134; mul
23 447; mul 38 914; add 1136 1137; mul 110 441; mul 111 1139; add 1138 1140; sub 1141 453; mul 72 474; add 1142
1143; mul 0 1144; mul 0 1145; mul 0 1146; add 1135 1147; mul 23 487; mul 38 927; add 1149 1150; mul 110 481; mul 111
1152; add 1151 1153; mul 0 1154; mul 0 1155; mul 0 1156; sub 1148 1157; mul 492 516; mul 540 934; add 1159 1160; mul
32 254; mul 552 1162; add 1161 1163; mul 254 553; add 1164 1165; mul 254 559; add 1166 1167; mul 576 943; add 1168
1169; mul 32 251; mul 588 1171; add 1170 1172; mul 251 589; add 1173 1174; mul 251 595; add 1175 1176; mul 32 248;
mul 606 1178; add 1177 1179; mul 248 607; add 1180 1181; mul 23 608; add 1182 1183; mul 248 613; add 1184 1185; mul
23 614; add 1186 1187; mul 23 620; add 1188 1189; mul 964 976; add 1190 1191; mul 32 245; mul 992 1193; add 1192
1194; mul 245 993; add 1195 1196; mul 245 999; add 1197 1198; mul 32 242; mul 1009 1200; add 1199 1201; mul 242
1010; add 1202 1203; mul 38 1011; add 1204 1205; mul 242 595; add 1206 1207; add 597 1208; mul 38 1018; add 1209
1210; mul 32 240; constant 209.45454545454547; mul 498 1213; mul 1212 1214; add 1211 1215; mul 32 1214; mul 240
1217; add 1216 1218; mul 32 1217; mul 111 1220; add 1219 1221; constant -42.666666666666664; mul 525 1223; mul 498
1224; mul 240 1225; add 1222 1226; mul 32 1225; mul 111 1228; add 1227 1229; constant 28.8; mul 110 563; add 1231
1232; mul 498 1233; mul 111 1234; add 1230 1235; constant -8.0; mul 525 1237; mul 498 1238; add 1236 1239; mul 0
1240; mul 0 1241; mul 0 1242; add 1158 1243; mul 644 701; mul 23 703; add 1245 1246; mul 635 1037; mul 38 1039; add
1248 1249; add 1247 1250; mul 110 662; mul 666 1252; mul 110 691; mul 111 1254; add 1253 1255; add 1251 1256; mul 0
1257; mul 0 1258; mul 0 1259; mul 631 1252; neg 1261; mul 11 1262; add 1245 1248; sub 1263 1264; mul 0 1265; mul 0
1266; mul 0 1267; add 1260 1268; sub 1244 1269; mul 23 795; mul 38 1058; add 1271 1272; mul 110 789; mul 111 1274;
add 1273 1275; sub 1276 801; mul 72 822; add 1277 1278; mul 0 1279; mul 0 1280; mul 0 1281; mul 644 836; mul 635
1069; add 1283 1284; mul 830 1231; mul 666 1286; add 1285 1287; mul 0 1288; mul 0 1289; mul 0 1290; add 1282 1291;
add 1270 1292; mul 135 842; mul 844 1294; mul 4 72; mul 271 1296; mul 383 1296; mul 399 1298; mul 392 1299; sub 1297
1300; mul 320 1301; mul 395 1299; sub 1302 1303; sub 1304 135; mul 370 1305; mul 389 1299; sub 120 1307; mul 323
1301; sub 1308 1309; mul 326 1310; add 1306 1311; mul 355 1312; mul 342 1313; mul 775 1314; mul 760 1315; mul 847
1316; mul 869 1317; mul 262 1301; mul 384 1299; add 1319 1320; sub 1321 135; mul 368 1322; mul 386 1299; sub 120
1324; mul 274 1301; add 1325 1326; mul 278 1327; add 1323 1328; mul 312 1329; mul 296 1330; mul 745 1331; mul 718
1332; mul 872 1333; mul 889 1334; add 1318 1335; sub 1295 1336; add 1293 1337; mul 135 894; sub 1338 1339; neg 1340;
add 358 440; sub 480 1342; mul 11 239; mul 2 497; mul 1344 1345; add 1343 1346; add 690 1347; sub 1348 788; div 263
353; mul 325 1350; mul 342 1351; mul 775 1352; mul 760 1353; mul 847 1354; mul 869 1355; div 263 310; mul 277 1357;
mul 296 1358; mul 745 1359; mul 718 1360; mul 872 1361; mul 889 1362; add 1356 1363; add 1349 1364; neg 1365; input
p 24; div 263 1367; mul 846 1368; mul 869 1369; add 777 1370; neg 1371; input p 39; div 263 1373; mul 871 1374; mul
889 1375; add 747 1376; neg 1377; abs 733; mul 844 1379; sub 733 1380; input p 10; div 263 1382; mul 1381 1383;
store mass 0 64; store mass 4 102; store mass 8 140; store mass 12 151; store mass 1 102; store mass 5 171; store
mass 9 191; store mass 13 201; store mass 2 140; store mass 6 191; store mass 10 222; store mass 14 232; store mass
3 151; store mass 7 201; store mass 11 232; store mass 15 26; store right 0 233; store right 1 234; store right 2
235; store right 3 236; store right 4 897; store right 5 1123; store right 6 1341; store right 7 1366; store right 8
1372; store right 9 1378; store right 10 1384
    """,
)

MOTION_SLOPES = Graph(
    {'x': 11, 'v_squared': 2, 'force': 1, 'p': 41, 'a': 4},
    {'slopes': 79},
    """
input p 0; constant 1.3333333333333333; constant 0.5; mul 0 2; input p 29; sub 4 0; input x 3; constant
2.2857142857142856; input x 2; mul 0 8; mul 0 9; mul 0 10; mul 11 11; mul 7 12; constant 4.0; input x 1; mul 0 15;
mul 0 16; mul 11 17; mul 14 18; add 13 19; constant 1.8; mul 17 17; mul 21 22; add 20 23; constant 3.2; input x 0;
mul 0 26; mul 11 27; mul 25 28; add 24 29; constant 3.0; mul 17 27; mul 31 32; add 30 33; mul 27 27; mul 1 35; add
34 36; mul 3 37; sub 6 38; sub 5 39; input p 27; input p 28; sub 41 42; constant 1.0; constant 2.0; mul 27 45; mul
17 31; add 46 47; mul 11 14; add 48 49; mul 50 50; add 44 51; sqrt 52; div 44 53; mul 43 54; add 40 55; input p 26;
mul 50 54; mul 57 58; add 56 59; mul 45 60; constant 8.854e-12; input p 32; mul 62 63; input p 36; mul 64 65; input
p 35; mul 66 67; input p 34; mul 68 69; input p 33; div 44 71; mul 70 72; constant -0.5; input v_squared 1; mul 74
75; mul 73 76; input p 31; div 44 78; mul 77 79; mul 43 58; mul 54 57; input p 30; sub 82 83; sub 81 84; add 17 27;
add 11 86; mul 0 87; sub 85 88; mul 89 89; mul 60 60; add 90 91; sqrt 92; mul 45 93; div 44 94; mul 80 95; mul 61
96; input p 14; sub 98 0; sub 99 39; input p 12; input p 13; sub 101 102; mul 54 103; add 100 104; input p 11; mul
58 106; sub 105 107; mul 45 108; input p 17; mul 62 110; input p 21; mul 111 112; input p 20; mul 113 114; input p
19; mul 115 116; input p 18; div 44 118; mul 117 119; input v_squared 0; mul 74 121; mul 120 122; input p 16; div 44
124; mul 123 125; mul 54 106; input p 15; sub 127 128; mul 58 103; add 129 130; sub 131 88; mul 132 132; mul 108
108; add 133 134; sqrt 135; mul 45 136; div 44 137; mul 126 138; mul 109 139; add 97 140; mul 3 141; mul 1 142; mul
0 45; mul 143 144; mul 0 11; mul 25 146; mul 0 17; mul 31 148; add 147 149; mul 0 46; mul 1 151; add 150 152; mul 3
153; mul 54 55; mul 45 50; mul 144 156; mul 45 53; div 44 158; mul 157 159; mul 155 160; sub 154 161; mul 54 144;
mul 54 58; mul 160 164; sub 163 165; mul 57 166; add 162 167; mul 45 168; mul 96 169; mul 95 96; mul 45 89; mul 43
166; mul 54 82; mul 160 174; add 173 175; mul 0 0; sub 176 177; mul 172 178; mul 61 168; add 179 180; mul 95 181;
mul 45 182; mul 171 183; mul 61 184; sub 170 185; mul 54 104; mul 160 187; sub 154 188; mul 106 166; sub 189 190;
mul 45 191; mul 139 192; mul 138 139; mul 45 132; mul 103 166; mul 54 127; mul 160 197; sub 196 198; sub 199 177;
mul 195 200; mul 109 191; add 201 202; mul 138 203; mul 45 204; mul 194 205; mul 109 206; sub 193 207; add 186 208;
mul 3 209; mul 1 210; mul 46 211; add 145 212; mul 31 210; mul 17 214; add 213 215; mul 25 210; mul 11 217; add 216
218; mul 45 178; mul 96 220; mul 172 184; sub 221 222; mul 45 200; mul 139 224; mul 195 206; sub 225 226; add 223
227; mul 0 228; sub 219 229; mul 57 186; mul 43 223; add 231 232; mul 106 208; sub 233 234; mul 103 227; add 235
236; mul 54 237; mul 57 97; mul 96 172; mul 43 240; add 239 241; mul 106 140; sub 242 243; mul 139 195; mul 103 245;
add 244 246; mul 54 247; mul 54 248; mul 160 249; sub 238 250; mul 174 240; mul 97 155; sub 252 253; mul 140 187;
sub 254 255; mul 164 247; sub 256 257; mul 197 245; sub 258 259; mul 159 260; mul 0 14; mul 261 262; mul 174 223;
mul 54 175; mul 54 174; mul 160 266; add 265 267; mul 240 268; sub 264 269; mul 155 186; mul 54 161; mul 54 155; mul
160 273; add 272 274; mul 97 275; sub 271 276; sub 270 277; mul 187 208; mul 54 188; mul 54 187; mul 160 281; add
280 282; mul 140 283; sub 279 284; sub 278 285; mul 54 166; mul 54 164; mul 160 288; sub 287 289; mul 247 290; mul
164 237; add 291 292; sub 286 293; mul 197 227; mul 54 198; mul 54 197; mul 160 297; add 296 298; mul 245 299; sub
295 300; sub 294 301; mul 159 302; mul 159 261; mul 45 160; mul 304 305; sub 303 306; mul 156 307; add 263 308; add
251 309; mul 45 310; add 230 311; mul 0 312; mul 79 93; mul 45 314; mul 63 69; mul 71 316; input p 37; mul 317 318;
constant 6.0; div 44 320; mul 319 321; mul 315 322; div 44 314; mul 45 324; mul 324 325; mul 322 326; sub 323 327;
mul 79 328; mul 95 329; mul 61 330; mul 125 136; mul 45 332; mul 110 116; mul 118 334; input p 22; mul 335 336; mul
321 337; mul 333 338; div 44 332; mul 45 340; mul 340 341; mul 338 342; sub 339 343; mul 125 344; mul 138 345; mul
109 346; add 331 347; mul 3 348; mul 1 349; mul 144 350; mul 169 330; mul 79 182; mul 45 353; mul 322 354; mul 326
353; mul 324 356; mul 324 326; mul 353 358; add 357 359; mul 322 360; add 355 361; mul 79 362; mul 95 363; mul 95
330; mul 183 365; sub 364 366; mul 61 367; add 352 368; mul 192 346; mul 125 204; mul 45 371; mul 338 372; mul 342
371; mul 340 374; mul 340 342; mul 371 376; add 375 377; mul 338 378; add 373 379; mul 125 380; mul 138 381; mul 138
346; mul 205 383; sub 382 384; mul 109 385; add 370 386; add 369 387; mul 3 388; mul 1 389; mul 46 390; add 351 391;
mul 31 389; mul 17 393; add 392 394; mul 25 389; mul 11 396; add 395 397; mul 220 330; mul 172 367; add 399 400; mul
224 346; mul 195 385; add 402 403; add 401 404; mul 0 405; sub 398 406; mul 57 369; mul 43 401; add 408 409; mul 106
387; sub 410 411; mul 103 404; add 412 413; mul 54 414; mul 57 331; mul 172 330; mul 43 417; add 416 418; mul 106
347; sub 419 420; mul 195 346; mul 103 422; add 421 423; mul 54 424; mul 54 425; mul 160 426; sub 415 427; mul 174
417; mul 155 331; sub 429 430; mul 187 347; sub 431 432; mul 164 424; sub 433 434; mul 197 422; sub 435 436; mul 159
437; mul 262 438; mul 174 401; mul 268 417; sub 440 441; mul 155 369; mul 275 331; sub 443 444; sub 442 445; mul 187
387; mul 283 347; sub 447 448; sub 446 449; mul 290 424; mul 164 414; add 451 452; sub 450 453; mul 197 404; mul 299
422; sub 455 456; sub 454 457; mul 159 458; mul 159 438; mul 305 460; sub 459 461; mul 156 462; add 439 463; add 428
464; mul 45 465; add 407 466; mul 0 467; add 313 468; input p 6; input p 7; mul 470 471; mul 3 472; mul 1 473; mul
144 474; mul 0 475; sub 469 476; constant 5.333333333333333; input p 2; input p 3; mul 2 480; div 44 0; mul 481 482;
mul 479 483; mul 478 484; mul 27 151; mul 0 35; add 486 487; mul 485 488; mul 27 485; mul 151 490; mul 0 485; mul 35
492; add 491 493; add 489 494; mul 27 490; mul 144 496; mul 0 490; mul 27 492; add 498 499; mul 46 500; add 497 501;
add 495 502; constant 36.0; mul 484 504; mul 17 505; mul 151 506; add 503 507; mul 27 506; mul 144 509; mul 0 506;
mul 46 511; add 510 512; add 508 513; constant 51.2; mul 484 515; mul 11 516; mul 151 517; add 514 518; mul 27 517;
mul 144 520; mul 0 517; mul 46 522; add 521 523; add 519 524; constant -5.333333333333333; input p 8; mul 0 527; mul
526 528; mul 484 529; mul 151 530; add 525 531; mul 27 530; mul 144 533; mul 0 530; mul 46 535; add 534 536; add 532
537; constant 93.60000000000001; mul 484 539; mul 17 540; mul 17 541; mul 144 542; add 538 543; constant 272.0; mul
484 545; mul 11 546; mul 17 547; mul 144 548; add 544 549; constant -24.0; mul 528 551; mul 484 552; mul 17 553; mul
144 554; add 550 555; constant 201.14285714285714; mul 484 557; mul 11 558; mul 11 559; mul 144 560; add 556 561;
constant -32.0; mul 528 563; mul 484 564; mul 11 565; mul 144 566; add 562 567; mul 528 528; mul 1 569; add 14 570;
mul 484 571; mul 144 572; add 568 573; mul 0 574; add 477 575; mul 2 470; input a 3; mul 11 45; input a 2; mul 0
580; mul 0 581; mul 0 582; mul 579 583; mul 7 584; input a 1; mul 0 586; mul 0 587; mul 11 588; mul 17 583; add 589
590; mul 14 591; add 585 592; mul 17 45; mul 588 594; mul 21 595; add 593 596; input a 0; mul 0 598; mul 11 599; mul
27 583; add 600 601; mul 25 602; add 597 603; mul 17 599; mul 27 588; add 605 606; mul 31 607; add 604 608; mul 46
599; mul 1 610; add 609 611; mul 3 612; sub 578 613; mul 45 614; mul 577 615; mul 3 616; mul 1 617; mul 144 618; mul
0 583; mul 25 620; mul 0 588; mul 31 622; add 621 623; mul 144 599; mul 1 625; add 624 626; mul 3 627; neg 628; mul
45 629; mul 577 630; mul 3 631; mul 1 632; mul 46 633; add 619 634; mul 31 632; mul 17 636; add 635 637; mul 25 632;
mul 11 639; add 638 640; mul 0 641; input x 4; mul 0 643; mul 45 644; input x 6; mul 0 646; mul 0 647; mul 0 648;
mul 0 649; mul 25 650; input x 5; mul 0 652; mul 0 653; mul 0 654; mul 31 655; add 651 656; mul 144 644; mul 1 658;
add 657 659; mul 3 660; neg 661; mul 45 662; mul 577 663; mul 3 664; mul 1 665; mul 645 666; mul 45 649; mul 649
668; mul 7 669; constant 8.0; mul 649 654; mul 671 672; add 670 673; mul 45 654; mul 654 675; mul 21 676; add 674
677; constant 6.4; mul 644 649; mul 679 680; add 678 681; mul 644 654; mul 320 683; add 682 684; mul 644 645; mul 1
686; add 685 687; mul 3 688; neg 689; mul 45 690; mul 577 691; mul 3 692; mul 1 693; mul 144 694; add 667 695; mul
31 665; mul 654 697; add 696 698; mul 25 665; mul 649 700; add 699 701; mul 0 702; add 642 703; mul 644 666; neg
705; mul 45 706; sub 707 698; sub 708 701; mul 0 709; add 704 710; sub 576 711; sqrt 314; div 44 713; mul 714 714;
mul 31 654; add 645 716; mul 14 649; add 717 718; mul 54 719; mul 156 719; mul 159 721; mul 164 722; sub 720 723;
mul 43 724; mul 174 722; add 725 726; add 644 654; add 649 728; mul 0 729; sub 727 730; mul 172 731; mul 57 724;
input x 7; mul 579 649; mul 7 735; mul 11 654; mul 17 649; add 737 738; mul 14 739; add 736 740; mul 594 654; mul 21
742; add 741 743; mul 11 644; mul 27 649; add 745 746; mul 25 747; add 744 748; mul 17 644; mul 27 654; add 750 751;
mul 31 752; add 749 753; mul 46 644; mul 1 755; add 754 756; mul 3 757; sub 734 758; mul 155 722; add 759 760; sub
733 761; mul 61 762; add 732 763; mul 95 764; mul 79 765; mul 45 713; div 44 767; mul 766 768; mul 715 769; mul 45
770; mul 2 317; input p 40; mul 772 773; mul 771 774; mul 715 775; mul 768 776; mul 79 777; mul 95 778; mul 61 779;
sqrt 332; div 44 781; mul 782 782; mul 103 724; mul 197 722; sub 784 785; sub 786 730; mul 195 787; mul 187 722; add
759 789; mul 106 724; add 790 791; mul 109 792; sub 788 793; mul 138 794; mul 125 795; mul 45 781; div 44 797; mul
796 798; mul 783 799; mul 45 800; mul 2 335; input p 25; mul 802 803; mul 801 804; mul 783 805; mul 798 806; mul 125
807; mul 138 808; mul 109 809; add 780 810; mul 3 811; mul 1 812; mul 144 813; mul 169 779; mul 220 731; mul 262
719; mul 159 817; mul 159 722; mul 305 819; sub 818 820; mul 174 821; mul 268 722; sub 822 823; mul 54 720; mul 160
825; mul 290 722; mul 164 821; add 827 828; add 826 829; mul 43 830; sub 824 831; mul 172 832; add 816 833; mul 169
762; mul 57 830; mul 155 821; mul 275 722; sub 837 838; sub 839 661; add 836 840; mul 61 841; sub 835 842; add 834
843; mul 95 844; mul 95 765; mul 183 846; sub 845 847; mul 79 848; mul 768 849; mul 768 769; mul 353 768; mul 45
852; mul 851 853; sub 850 854; mul 715 855; mul 715 852; mul 714 857; mul 714 715; mul 852 859; add 858 860; mul 769
861; sub 856 862; mul 45 863; mul 774 864; mul 715 865; mul 775 861; sub 866 867; mul 768 868; mul 768 777; mul 853
870; sub 869 871; mul 79 872; mul 95 873; mul 95 779; mul 183 875; sub 874 876; mul 61 877; add 815 878; mul 192
809; mul 224 787; mul 103 830; mul 197 821; mul 299 722; sub 883 884; add 882 885; mul 195 886; sub 881 887; mul 192
792; mul 187 821; mul 283 722; sub 890 891; sub 892 661; mul 106 830; sub 893 894; mul 109 895; add 889 896; sub 888
897; mul 138 898; mul 138 795; mul 205 900; sub 899 901; mul 125 902; mul 798 903; mul 798 799; mul 371 798; mul 45
906; mul 905 907; sub 904 908; mul 783 909; mul 783 906; mul 782 911; mul 782 783; mul 906 913; add 912 914; mul 799
915; sub 910 916; mul 45 917; mul 804 918; mul 783 919; mul 805 915; sub 920 921; mul 798 922; mul 798 807; mul 907
924; sub 923 925; mul 125 926; mul 138 927; mul 138 809; mul 205 929; sub 928 930; mul 109 931; add 880 932; add 879
933; mul 3 934; mul 1 935; mul 46 936; add 814 937; mul 31 935; mul 17 939; add 938 940; mul 25 935; mul 11 942; add
941 943; mul 220 779; mul 172 877; add 945 946; mul 224 809; mul 195 931; add 948 949; add 947 950; mul 0 951; sub
944 952; mul 172 779; mul 174 954; mul 155 780; sub 955 956; mul 187 810; sub 957 958; mul 195 809; mul 197 960; sub
959 961; mul 57 780; mul 43 954; add 963 964; mul 106 810; sub 965 966; mul 103 960; add 967 968; mul 164 969; sub
962 970; mul 159 971; mul 262 972; mul 174 947; mul 268 954; sub 974 975; mul 155 879; mul 275 780; sub 977 978; sub
976 979; mul 187 933; mul 283 810; sub 981 982; sub 980 983; mul 197 950; mul 299 960; sub 985 986; sub 984 987; mul
290 969; mul 57 879; mul 43 947; add 990 991; mul 106 933; sub 992 993; mul 103 950; add 994 995; mul 164 996; add
989 997; sub 988 998; mul 159 999; mul 159 972; mul 305 1001; sub 1000 1002; mul 156 1003; add 973 1004; mul 54 996;
mul 54 969; mul 54 1007; mul 160 1008; sub 1006 1009; add 1005 1010; mul 45 1011; add 953 1012; mul 0 1013; add 712
1014; input x 8; input p 23; mul 335 1017; mul 200 224; mul 54 163; mul 160 1020; mul 160 290; mul 144 262; mul 159
1023; mul 159 160; mul 305 1025; sub 1024 1026; mul 164 1027; add 1022 1028; add 1021 1029; mul 103 1030; mul 197
1027; mul 160 299; sub 1032 1033; add 1031 1034; mul 195 1035; sub 1019 1036; mul 191 192; mul 0 144; mul 1 1039;
mul 3 1040; mul 187 1027; mul 160 283; sub 1042 1043; sub 1041 1044; mul 106 1030; add 1045 1046; mul 109 1047; add
1038 1048; add 1037 1049; mul 138 1050; mul 138 204; mul 205 1052; sub 1051 1053; mul 125 1054; mul 798 1055; mul
798 906; mul 907 1057; sub 1056 1058; mul 783 1059; mul 906 915; sub 1060 1061; mul 1018 1062; mul 1016 1063; input
x 9; input p 38; mul 317 1066; mul 178 220; mul 174 1027; mul 160 268; sub 1069 1070; mul 43 1030; sub 1071 1072;
mul 172 1073; add 1068 1074; mul 168 169; mul 155 1027; mul 160 275; sub 1077 1078; sub 1041 1079; mul 57 1030; sub
1080 1081; mul 61 1082; add 1076 1083; add 1075 1084; mul 95 1085; mul 95 182; mul 183 1087; sub 1086 1088; mul 79
1089; mul 768 1090; mul 768 852; mul 853 1092; sub 1091 1093; mul 715 1094; mul 852 861; sub 1095 1096; mul 1067
1097; mul 1065 1098; add 1064 1099; sub 1015 1100; mul 11 177; mul 14 1102; mul 177 594; mul 21 1104; add 1103 1105;
mul 27 177; mul 31 1107; add 1106 1108; mul 3 1109; mul 31 177; mul 156 1111; mul 159 1112; mul 155 1113; sub 1110
1114; mul 54 1111; mul 164 1113; sub 1116 1117; mul 57 1118; add 1115 1119; mul 45 1120; mul 96 1121; mul 43 1118;
mul 174 1113; add 1123 1124; mul 0 177; sub 1125 1126; mul 172 1127; mul 61 1120; add 1128 1129; mul 95 1130; mul 45
1131; mul 171 1132; mul 61 1133; sub 1122 1134; mul 187 1113; sub 1110 1136; mul 106 1118; sub 1137 1138; mul 45
1139; mul 139 1140; mul 103 1118; mul 197 1113; sub 1142 1143; sub 1144 1126; mul 195 1145; mul 109 1139; add 1146
1147; mul 138 1148; mul 45 1149; mul 194 1150; mul 109 1151; sub 1141 1152; add 1135 1153; mul 3 1154; mul 1 1155;
mul 46 1156; mul 31 142; mul 177 1158; mul 31 1155; mul 17 1160; add 1159 1161; add 1157 1162; mul 25 1155; mul 11
1164; add 1163 1165; mul 45 1127; mul 96 1167; mul 172 1133; sub 1168 1169; mul 45 1145; mul 139 1171; mul 195 1151;
sub 1172 1173; add 1170 1174; mul 0 1175; sub 1166 1176; mul 57 1135; mul 43 1170; add 1178 1179; mul 106 1153; sub
1180 1181; mul 103 1174; add 1182 1183; mul 54 1184; mul 249 1113; sub 1185 1186; mul 177 320; mul 261 1188; mul 174
1170; mul 54 1124; mul 266 1113; add 1191 1192; mul 240 1193; sub 1190 1194; mul 155 1135; mul 54 1114; mul 273
1113; add 1197 1198; mul 97 1199; sub 1196 1200; sub 1195 1201; mul 187 1153; mul 54 1136; mul 281 1113; add 1204
1205; mul 140 1206; sub 1203 1207; sub 1202 1208; mul 54 1118; mul 288 1113; sub 1210 1211; mul 247 1212; mul 164
1184; add 1213 1214; sub 1209 1215; mul 197 1174; mul 54 1143; mul 297 1113; add 1218 1219; mul 245 1220; sub 1217
1221; sub 1216 1222; mul 159 1223; mul 45 1113; mul 304 1225; sub 1224 1226; mul 156 1227; add 1189 1228; add 1187
1229; mul 45 1230; add 1177 1231; mul 0 1232; mul 330 1121; mul 79 1131; mul 45 1235; mul 322 1236; mul 326 1235;
mul 324 1238; mul 358 1235; add 1239 1240; mul 322 1241; add 1237 1242; mul 79 1243; mul 95 1244; mul 365 1132; sub
1245 1246; mul 61 1247; add 1234 1248; mul 346 1140; mul 125 1149; mul 45 1251; mul 338 1252; mul 342 1251; mul 340
1254; mul 376 1251; add 1255 1256; mul 338 1257; add 1253 1258; mul 125 1259; mul 138 1260; mul 383 1150; sub 1261
1262; mul 109 1263; add 1250 1264; add 1249 1265; mul 3 1266; mul 1 1267; mul 46 1268; mul 31 349; mul 177 1270; mul
31 1267; mul 17 1272; add 1271 1273; add 1269 1274; mul 25 1267; mul 11 1276; add 1275 1277; mul 330 1167; mul 172
1247; add 1279 1280; mul 346 1171; mul 195 1263; add 1282 1283; add 1281 1284; mul 0 1285; sub 1278 1286; mul 57
1249; mul 43 1281; add 1288 1289; mul 106 1265; sub 1290 1291; mul 103 1284; add 1292 1293; mul 54 1294; mul 426
1113; sub 1295 1296; mul 438 1188; mul 174 1281; mul 417 1193; sub 1299 1300; mul 155 1249; mul 331 1199; sub 1302
1303; sub 1301 1304; mul 187 1265; mul 347 1206; sub 1306 1307; sub 1305 1308; mul 424 1212; mul 164 1294; add 1310
1311; sub 1309 1312; mul 197 1284; mul 422 1220; sub 1314 1315; sub 1313 1316; mul 159 1317; mul 460 1225; sub 1318
1319; mul 156 1320; add 1298 1321; add 1297 1322; mul 45 1323; add 1287 1324; mul 0 1325; add 1233 1326; mul 31 473;
mul 177 1328; mul 0 1329; sub 1327 1330; mul 177 505; mul 35 1332; mul 27 1332; mul 46 1334; add 1333 1335; mul 177
541; mul 177 540; mul 17 1338; add 1337 1339; mul 46 1340; add 1336 1341; mul 177 547; mul 46 1343; add 1342 1344;
mul 177 553; mul 46 1346; add 1345 1347; constant 108.0; mul 484 1349; mul 17 1350; mul 17 1351; mul 177 1352; mul
177 1351; mul 177 1350; mul 17 1355; add 1354 1356; mul 17 1357; add 1353 1358; add 1348 1359; constant
473.1428571428571; mul 484 1361; mul 11 1362; mul 17 1363; mul 177 1364; mul 177 1363; mul 17 1366; add 1365 1367;
add 1360 1368; constant -36.0; mul 528 1370; mul 484 1371; mul 17 1372; mul 177 1373; mul 177 1372; mul 17 1375; add
1374 1376; add 1369 1377; constant 696.0; mul 484 1379; mul 11 1380; mul 11 1381; mul 177 1382; add 1378 1383;
constant -96.0; mul 528 1385; mul 484 1386; mul 11 1387; mul 177 1388; add 1384 1389; constant 12.0; mul 31 569; add
1391 1392; mul 484 1393; mul 177 1394; add 1390 1395; mul 0 1396; add 1331 1397; mul 177 583; mul 14 1399; mul 45
177; mul 588 1401; mul 21 1402; add 1400 1403; mul 177 599; mul 31 1405; add 1404 1406; mul 3 1407; neg 1408; mul 45
1409; mul 577 1410; mul 3 1411; mul 1 1412; mul 46 1413; mul 31 617; mul 177 1415; mul 31 1412; mul 17 1417; add
1416 1418; add 1414 1419; mul 25 1412; mul 11 1421; add 1420 1422; mul 0 1423; mul 177 649; mul 14 1425; mul 654
1401; mul 21 1427; add 1426 1428; mul 177 644; mul 31 1430; add 1429 1431; mul 3 1432; neg 1433; mul 45 1434; mul
577 1435; mul 3 1436; mul 1 1437; mul 645 1438; mul 31 1437; mul 654 1440; mul 31 693; mul 177 1442; add 1441 1443;
add 1439 1444; mul 25 1437; mul 649 1446; add 1445 1447; mul 0 1448; add 1424 1449; mul 644 1438; neg 1451; mul 45
1452; sub 1453 1441; sub 1454 1447; mul 0 1455; add 1450 1456; sub 1398 1457; mul 779 1121; mul 731 1167; mul 719
1188; mul 159 1461; mul 819 1225; sub 1462 1463; mul 174 1464; mul 722 1193; sub 1465 1466; mul 825 1113; mul 722
1212; mul 164 1464; add 1469 1470; add 1468 1471; mul 43 1472; sub 1467 1473; mul 172 1474; add 1460 1475; mul 762
1121; mul 57 1472; mul 155 1464; mul 722 1199; sub 1479 1480; sub 1481 1433; add 1478 1482; mul 61 1483; sub 1477
1484; add 1476 1485; mul 95 1486; mul 846 1132; sub 1487 1488; mul 79 1489; mul 768 1490; mul 768 1235; mul 45 1492;
mul 851 1493; sub 1491 1494; mul 715 1495; mul 715 1492; mul 714 1497; mul 859 1492; add 1498 1499; mul 769 1500;
sub 1496 1501; mul 45 1502; mul 774 1503; mul 715 1504; mul 775 1500; sub 1505 1506; mul 768 1507; mul 870 1493; sub
1508 1509; mul 79 1510; mul 95 1511; mul 875 1132; sub 1512 1513; mul 61 1514; add 1459 1515; mul 809 1140; mul 787
1171; mul 103 1472; mul 197 1464; mul 722 1220; sub 1520 1521; add 1519 1522; mul 195 1523; sub 1518 1524; mul 792
1140; mul 187 1464; mul 722 1206; sub 1527 1528; sub 1529 1433; mul 106 1472; sub 1530 1531; mul 109 1532; add 1526
1533; sub 1525 1534; mul 138 1535; mul 900 1150; sub 1536 1537; mul 125 1538; mul 798 1539; mul 798 1251; mul 45
1541; mul 905 1542; sub 1540 1543; mul 783 1544; mul 783 1541; mul 782 1546; mul 913 1541; add 1547 1548; mul 799
1549; sub 1545 1550; mul 45 1551; mul 804 1552; mul 783 1553; mul 805 1549; sub 1554 1555; mul 798 1556; mul 924
1542; sub 1557 1558; mul 125 1559; mul 138 1560; mul 929 1150; sub 1561 1562; mul 109 1563; add 1517 1564; add 1516
1565; mul 3 1566; mul 1 1567; mul 46 1568; mul 31 812; mul 177 1570; mul 31 1567; mul 17 1572; add 1571 1573; add
1569 1574; mul 25 1567; mul 11 1576; add 1575 1577; mul 779 1167; mul 172 1514; add 1579 1580; mul 809 1171; mul 195
1563; add 1582 1583; add 1581 1584; mul 0 1585; sub 1578 1586; mul 972 1188; mul 174 1581; mul 954 1193; sub 1589
1590; mul 155 1516; mul 780 1199; sub 1592 1593; sub 1591 1594; mul 187 1565; mul 810 1206; sub 1596 1597; sub 1595
1598; mul 197 1584; mul 960 1220; sub 1600 1601; sub 1599 1602; mul 969 1212; mul 57 1516; mul 43 1581; add 1605
1606; mul 106 1565; sub 1607 1608; mul 103 1584; add 1609 1610; mul 164 1611; add 1604 1612; sub 1603 1613; mul 159
1614; mul 1001 1225; sub 1615 1616; mul 156 1617; add 1588 1618; mul 54 1611; mul 1008 1113; sub 1620 1621; add 1619
1622; mul 45 1623; add 1587 1624; mul 0 1625; add 1458 1626; mul 200 1171; mul 1020 1113; mul 160 1212; mul 144
1188; mul 159 1631; mul 1025 1225; sub 1632 1633; mul 164 1634; add 1630 1635; add 1629 1636; mul 103 1637; mul 197
1634; mul 160 1220; sub 1639 1640; add 1638 1641; mul 195 1642; sub 1628 1643; mul 191 1140; mul 31 1126; mul 3
1646; mul 187 1634; mul 160 1206; sub 1648 1649; sub 1647 1650; mul 106 1637; add 1651 1652; mul 109 1653; add 1645
1654; add 1644 1655; mul 138 1656; mul 1052 1150; sub 1657 1658; mul 125 1659; mul 798 1660; mul 1057 1542; sub 1661
1662; mul 783 1663; mul 906 1549; sub 1664 1665; mul 1018 1666; mul 1016 1667; mul 178 1167; mul 174 1634; mul 160
1193; sub 1670 1671; mul 43 1637; sub 1672 1673; mul 172 1674; add 1669 1675; mul 168 1121; mul 155 1634; mul 160
1199; sub 1678 1679; sub 1647 1680; mul 57 1637; sub 1681 1682; mul 61 1683; add 1677 1684; add 1676 1685; mul 95
1686; mul 1087 1132; sub 1687 1688; mul 79 1689; mul 768 1690; mul 1092 1493; sub 1691 1692; mul 715 1693; mul 852
1500; sub 1694 1695; mul 1067 1696; mul 1065 1697; add 1668 1698; sub 1627 1699; mul 579 1126; mul 7 1701; mul 17
1126; mul 14 1703; add 1702 1704; mul 27 1126; mul 25 1706; add 1705 1707; mul 3 1708; mul 14 1126; mul 156 1710;
mul 159 1711; mul 155 1712; sub 1709 1713; mul 54 1710; mul 164 1712; sub 1715 1716; mul 57 1717; add 1714 1718; mul
45 1719; mul 96 1720; mul 43 1717; mul 174 1712; add 1722 1723; mul 0 1126; sub 1724 1725; mul 172 1726; mul 61
1719; add 1727 1728; mul 95 1729; mul 45 1730; mul 171 1731; mul 61 1732; sub 1721 1733; mul 187 1712; sub 1709
1735; mul 106 1717; sub 1736 1737; mul 45 1738; mul 139 1739; mul 103 1717; mul 197 1712; sub 1741 1742; sub 1743
1725; mul 195 1744; mul 109 1738; add 1745 1746; mul 138 1747; mul 45 1748; mul 194 1749; mul 109 1750; sub 1740
1751; add 1734 1752; mul 3 1753; mul 1 1754; mul 46 1755; mul 31 1754; mul 17 1757; add 1756 1758; mul 25 142; mul
1126 1760; mul 25 1754; mul 11 1762; add 1761 1763; add 1759 1764; mul 45 1726; mul 96 1766; mul 172 1732; sub 1767
1768; mul 45 1744; mul 139 1770; mul 195 1750; sub 1771 1772; add 1769 1773; mul 0 1774; sub 1765 1775; mul 57 1734;
mul 43 1769; add 1777 1778; mul 106 1752; sub 1779 1780; mul 103 1773; add 1781 1782; mul 54 1783; mul 249 1712; sub
1784 1785; mul 671 1126; mul 261 1787; mul 174 1769; mul 54 1723; mul 266 1712; add 1790 1791; mul 240 1792; sub
1789 1793; mul 155 1734; mul 54 1713; mul 273 1712; add 1796 1797; mul 97 1798; sub 1795 1799; sub 1794 1800; mul
187 1752; mul 54 1735; mul 281 1712; add 1803 1804; mul 140 1805; sub 1802 1806; sub 1801 1807; mul 54 1717; mul 288
1712; sub 1809 1810; mul 247 1811; mul 164 1783; add 1812 1813; sub 1808 1814; mul 197 1773; mul 54 1742; mul 297
1712; add 1817 1818; mul 245 1819; sub 1816 1820; sub 1815 1821; mul 159 1822; mul 45 1712; mul 304 1824; sub 1823
1825; mul 156 1826; add 1788 1827; add 1786 1828; mul 45 1829; add 1776 1830; mul 0 1831; mul 330 1720; mul 79 1730;
mul 45 1834; mul 322 1835; mul 326 1834; mul 324 1837; mul 358 1834; add 1838 1839; mul 322 1840; add 1836 1841; mul
79 1842; mul 95 1843; mul 365 1731; sub 1844 1845; mul 61 1846; add 1833 1847; mul 346 1739; mul 125 1748; mul 45
1850; mul 338 1851; mul 342 1850; mul 340 1853; mul 376 1850; add 1854 1855; mul 338 1856; add 1852 1857; mul 125
1858; mul 138 1859; mul 383 1749; sub 1860 1861; mul 109 1862; add 1849 1863; add 1848 1864; mul 3 1865; mul 1 1866;
mul 46 1867; mul 31 1866; mul 17 1869; add 1868 1870; mul 25 349; mul 1126 1872; mul 25 1866; mul 11 1874; add 1873
1875; add 1871 1876; mul 330 1766; mul 172 1846; add 1878 1879; mul 346 1770; mul 195 1862; add 1881 1882; add 1880
1883; mul 0 1884; sub 1877 1885; mul 57 1848; mul 43 1880; add 1887 1888; mul 106 1864; sub 1889 1890; mul 103 1883;
add 1891 1892; mul 54 1893; mul 426 1712; sub 1894 1895; mul 438 1787; mul 174 1880; mul 417 1792; sub 1898 1899;
mul 155 1848; mul 331 1798; sub 1901 1902; sub 1900 1903; mul 187 1864; mul 347 1805; sub 1905 1906; sub 1904 1907;
mul 424 1811; mul 164 1893; add 1909 1910; sub 1908 1911; mul 197 1883; mul 422 1819; sub 1913 1914; sub 1912 1915;
mul 159 1916; mul 460 1824; sub 1917 1918; mul 156 1919; add 1897 1920; add 1896 1921; mul 45 1922; add 1886 1923;
mul 0 1924; add 1832 1925; mul 25 473; mul 1126 1927; mul 0 1928; sub 1926 1929; mul 516 1126; mul 35 1931; mul 27
1931; mul 46 1933; add 1932 1934; mul 546 1126; mul 17 1936; mul 46 1937; add 1935 1938; mul 559 1126; mul 558 1126;
mul 11 1941; add 1940 1942; mul 46 1943; add 1939 1944; mul 565 1126; mul 46 1946; add 1945 1947; mul 1126 1362; mul
17 1949; mul 17 1950; add 1948 1951; mul 1126 1381; mul 1126 1380; mul 11 1954; add 1953 1955; mul 17 1956; add 1952
1957; mul 1126 1387; mul 17 1959; add 1958 1960; constant 341.3333333333333; mul 484 1962; mul 11 1963; mul 11 1964;
mul 1126 1965; mul 1126 1964; mul 1126 1963; mul 11 1968; add 1967 1969; mul 11 1970; add 1966 1971; add 1961 1972;
constant -64.0; mul 528 1974; mul 484 1975; mul 11 1976; mul 1126 1977; mul 1126 1976; mul 11 1979; add 1978 1980;
add 1973 1981; constant 16.0; mul 25 569; add 1983 1984; mul 484 1985; mul 1126 1986; add 1982 1987; mul 0 1988; add
1930 1989; mul 45 1126; mul 583 1991; mul 7 1992; mul 588 1126; mul 14 1994; add 1993 1995; mul 599 1126; mul 25
1997; add 1996 1998; mul 3 1999; neg 2000; mul 45 2001; mul 577 2002; mul 3 2003; mul 1 2004; mul 46 2005; mul 31
2004; mul 17 2007; add 2006 2008; mul 25 617; mul 1126 2010; mul 25 2004; mul 11 2012; add 2011 2013; add 2009 2014;
mul 0 2015; mul 649 1991; mul 7 2017; mul 654 1126; mul 14 2019; add 2018 2020; mul 644 1126; mul 25 2022; add 2021
2023; mul 3 2024; neg 2025; mul 45 2026; mul 577 2027; mul 3 2028; mul 1 2029; mul 645 2030; mul 31 2029; mul 654
2032; add 2031 2033; mul 25 2029; mul 649 2035; mul 25 693; mul 1126 2037; add 2036 2038; add 2034 2039; mul 0 2040;
add 2016 2041; mul 644 2030; neg 2043; mul 45 2044; sub 2045 2033; sub 2046 2036; mul 0 2047; add 2042 2048; sub
1990 2049; mul 779 1720; mul 731 1766; mul 719 1787; mul 159 2053; mul 819 1824; sub 2054 2055; mul 174 2056; mul
722 1792; sub 2057 2058; mul 825 1712; mul 722 1811; mul 164 2056; add 2061 2062; add 2060 2063; mul 43 2064; sub
2059 2065; mul 172 2066; add 2052 2067; mul 762 1720; mul 57 2064; mul 155 2056; mul 722 1798; sub 2071 2072; sub
2073 2025; add 2070 2074; mul 61 2075; sub 2069 2076; add 2068 2077; mul 95 2078; mul 846 1731; sub 2079 2080; mul
79 2081; mul 768 2082; mul 768 1834; mul 45 2084; mul 851 2085; sub 2083 2086; mul 715 2087; mul 715 2084; mul 714
2089; mul 859 2084; add 2090 2091; mul 769 2092; sub 2088 2093; mul 45 2094; mul 774 2095; mul 715 2096; mul 775
2092; sub 2097 2098; mul 768 2099; mul 870 2085; sub 2100 2101; mul 79 2102; mul 95 2103; mul 875 1731; sub 2104
2105; mul 61 2106; add 2051 2107; mul 809 1739; mul 787 1770; mul 103 2064; mul 197 2056; mul 722 1819; sub 2112
2113; add 2111 2114; mul 195 2115; sub 2110 2116; mul 792 1739; mul 187 2056; mul 722 1805; sub 2119 2120; sub 2121
2025; mul 106 2064; sub 2122 2123; mul 109 2124; add 2118 2125; sub 2117 2126; mul 138 2127; mul 900 1749; sub 2128
2129; mul 125 2130; mul 798 2131; mul 798 1850; mul 45 2133; mul 905 2134; sub 2132 2135; mul 783 2136; mul 783
2133; mul 782 2138; mul 913 2133; add 2139 2140; mul 799 2141; sub 2137 2142; mul 45 2143; mul 804 2144; mul 783
2145; mul 805 2141; sub 2146 2147; mul 798 2148; mul 924 2134; sub 2149 2150; mul 125 2151; mul 138 2152; mul 929
1749; sub 2153 2154; mul 109 2155; add 2109 2156; add 2108 2157; mul 3 2158; mul 1 2159; mul 46 2160; mul 31 2159;
mul 17 2162; add 2161 2163; mul 25 812; mul 1126 2165; mul 25 2159; mul 11 2167; add 2166 2168; add 2164 2169; mul
779 1766; mul 172 2106; add 2171 2172; mul 809 1770; mul 195 2155; add 2174 2175; add 2173 2176; mul 0 2177; sub
2170 2178; mul 972 1787; mul 174 2173; mul 954 1792; sub 2181 2182; mul 155 2108; mul 780 1798; sub 2184 2185; sub
2183 2186; mul 187 2157; mul 810 1805; sub 2188 2189; sub 2187 2190; mul 197 2176; mul 960 1819; sub 2192 2193; sub
2191 2194; mul 969 1811; mul 57 2108; mul 43 2173; add 2197 2198; mul 106 2157; sub 2199 2200; mul 103 2176; add
2201 2202; mul 164 2203; add 2196 2204; sub 2195 2205; mul 159 2206; mul 1001 1824; sub 2207 2208; mul 156 2209; add
2180 2210; mul 54 2203; mul 1008 1712; sub 2212 2213; add 2211 2214; mul 45 2215; add 2179 2216; mul 0 2217; add
2050 2218; mul 200 1770; mul 1020 1712; mul 160 1811; mul 144 1787; mul 159 2223; mul 1025 1824; sub 2224 2225; mul
164 2226; add 2222 2227; add 2221 2228; mul 103 2229; mul 197 2226; mul 160 1819; sub 2231 2232; add 2230 2233; mul
195 2234; sub 2220 2235; mul 191 1739; mul 25 1725; mul 3 2238; mul 187 2226; mul 160 1805; sub 2240 2241; sub 2239
2242; mul 106 2229; add 2243 2244; mul 109 2245; add 2237 2246; add 2236 2247; mul 138 2248; mul 1052 1749; sub 2249
2250; mul 125 2251; mul 798 2252; mul 1057 2134; sub 2253 2254; mul 783 2255; mul 906 2141; sub 2256 2257; mul 1018
2258; mul 1016 2259; mul 178 1766; mul 174 2226; mul 160 1792; sub 2262 2263; mul 43 2229; sub 2264 2265; mul 172
2266; add 2261 2267; mul 168 1720; mul 155 2226; mul 160 1798; sub 2270 2271; sub 2239 2272; mul 57 2229; sub 2273
2274; mul 61 2275; add 2269 2276; add 2268 2277; mul 95 2278; mul 1087 1731; sub 2279 2280; mul 79 2281; mul 768
2282; mul 1092 2085; sub 2283 2284; mul 715 2285; mul 852 2092; sub 2286 2287; mul 1067 2288; mul 1065 2289; add
2260 2290; sub 2219 2291; constant -2.0; mul 96 2293; div 44 93; mul 60 2295; neg 2296; mul 45 2297; mul 171 2298;
mul 61 2299; sub 2294 2300; mul 139 2293; div 44 136; mul 108 2303; neg 2304; mul 45 2305; mul 194 2306; mul 109
2307; sub 2302 2308; add 2301 2309; mul 3 2310; mul 1 2311; mul 46 2312; mul 31 2311; mul 17 2314; add 2313 2315;
mul 25 2311; mul 11 2317; add 2316 2318; mul 172 2299; mul 195 2307; add 2320 2321; mul 0 2322; add 2319 2323; mul
57 2301; mul 43 2320; sub 2325 2326; mul 106 2309; sub 2327 2328; mul 103 2321; sub 2329 2330; mul 54 2331; mul 197
2321; mul 174 2320; mul 155 2301; add 2334 2335; mul 187 2309; add 2336 2337; mul 164 2331; add 2338 2339; sub 2333
2340; mul 159 2341; mul 156 2342; add 2332 2343; mul 45 2344; add 2324 2345; mul 0 2346; mul 330 2293; mul 79 2296;
neg 2349; mul 45 2350; mul 322 2351; mul 326 2349; mul 324 2353; mul 358 2349; add 2354 2355; mul 322 2356; sub 2352
2357; mul 79 2358; mul 95 2359; mul 365 2298; sub 2360 2361; mul 61 2362; add 2348 2363; mul 346 2293; mul 125 2304;
neg 2366; mul 45 2367; mul 338 2368; mul 342 2366; mul 340 2370; mul 376 2366; add 2371 2372; mul 338 2373; sub 2369
2374; mul 125 2375; mul 138 2376; mul 383 2306; sub 2377 2378; mul 109 2379; add 2365 2380; add 2364 2381; mul 3
2382; mul 1 2383; mul 46 2384; mul 31 2383; mul 17 2386; add 2385 2387; mul 25 2383; mul 11 2389; add 2388 2390; mul
172 2362; mul 195 2379; add 2392 2393; mul 0 2394; sub 2391 2395; mul 57 2364; mul 43 2392; add 2397 2398; mul 106
2381; sub 2399 2400; mul 103 2393; add 2401 2402; mul 54 2403; mul 174 2392; mul 155 2364; sub 2405 2406; mul 187
2381; sub 2407 2408; mul 164 2403; sub 2409 2410; mul 197 2393; sub 2411 2412; mul 159 2413; mul 156 2414; add 2404
2415; mul 45 2416; add 2396 2417; mul 0 2418; add 2347 2419; mul 779 2293; mul 768 2349; mul 715 2422; mul 714 2423;
mul 859 2422; add 2424 2425; mul 775 2426; mul 769 2426; mul 762 2293; mul 95 2429; mul 846 2298; sub 2430 2431; mul
79 2432; mul 768 2433; neg 2422; mul 45 2435; mul 851 2436; sub 2434 2437; mul 715 2438; add 2428 2439; mul 45 2440;
mul 774 2441; mul 715 2442; add 2427 2443; mul 768 2444; mul 870 2436; sub 2445 2446; mul 79 2447; mul 95 2448; mul
875 2298; sub 2449 2450; mul 61 2451; add 2421 2452; mul 809 2293; mul 798 2366; mul 783 2455; mul 782 2456; mul 913
2455; add 2457 2458; mul 805 2459; mul 799 2459; mul 792 2293; mul 138 2462; mul 900 2306; add 2463 2464; mul 125
2465; mul 798 2466; neg 2455; mul 45 2468; mul 905 2469; add 2467 2470; mul 783 2471; sub 2461 2472; mul 45 2473;
mul 804 2474; mul 783 2475; add 2460 2476; mul 798 2477; mul 924 2469; sub 2478 2479; mul 125 2480; mul 138 2481;
mul 929 2306; sub 2482 2483; mul 109 2484; add 2454 2485; add 2453 2486; mul 3 2487; mul 1 2488; mul 46 2489; mul 31
2488; mul 17 2491; add 2490 2492; mul 25 2488; mul 11 2494; add 2493 2495; mul 172 2451; mul 195 2484; add 2497
2498; mul 0 2499; sub 2496 2500; mul 174 2497; mul 155 2453; sub 2502 2503; mul 187 2486; sub 2504 2505; mul 197
2498; sub 2506 2507; mul 57 2453; mul 43 2497; add 2509 2510; mul 106 2486; sub 2511 2512; mul 103 2498; add 2513
2514; mul 164 2515; sub 2508 2516; mul 159 2517; mul 156 2518; mul 54 2515; add 2519 2520; mul 45 2521; add 2501
2522; mul 0 2523; add 2420 2524; mul 906 2459; mul 191 2293; mul 138 2527; mul 1052 2306; sub 2528 2529; mul 125
2530; mul 798 2531; mul 1057 2469; sub 2532 2533; mul 783 2534; add 2526 2535; mul 1018 2536; mul 1016 2537; mul 852
2426; mul 168 2293; mul 95 2540; mul 1087 2298; sub 2541 2542; mul 79 2543; mul 768 2544; mul 1092 2436; sub 2545
2546; mul 715 2547; add 2539 2548; mul 1067 2549; mul 1065 2550; add 2538 2551; sub 2525 2552; mul 0 1158; mul 27
214; add 2554 2555; mul 21 210; mul 594 2557; add 2556 2558; mul 14 210; mul 11 2560; add 2559 2561; sub 2562 229;
mul 31 310; add 2563 2564; mul 0 2565; mul 0 2566; mul 0 1270; mul 27 393; add 2568 2569; mul 21 389; mul 594 2571;
add 2570 2572; mul 14 389; mul 11 2574; add 2573 2575; sub 2576 406; mul 31 465; add 2577 2578; mul 0 2579; mul 0
2580; add 2567 2581; mul 0 1328; mul 0 2583; mul 0 2584; sub 2582 2585; mul 488 505; mul 17 151; mul 540 2588; add
2587 2589; mul 151 541; add 2590 2591; mul 151 547; add 2592 2593; mul 151 553; add 2594 2595; mul 17 148; mul 1350
2597; add 2596 2598; mul 148 1351; add 2599 2600; mul 0 1352; add 2601 2602; mul 148 1363; add 2603 2604; mul 0
1364; add 2605 2606; mul 148 1372; add 2607 2608; mul 0 1373; add 2609 2610; mul 0 1382; add 2611 2612; mul 0 1388;
add 2613 2614; mul 0 1394; add 2615 2616; mul 0 2617; mul 0 2618; add 2586 2619; mul 0 1415; mul 27 636; add 2621
2622; mul 21 632; mul 594 2624; add 2623 2625; mul 14 632; mul 11 2627; add 2626 2628; mul 0 2629; mul 0 2630; mul
644 697; mul 0 1442; add 2632 2633; mul 21 665; mul 675 2635; add 2634 2636; mul 14 665; mul 649 2638; add 2637
2639; mul 0 2640; mul 0 2641; add 2631 2642; mul 654 2635; neg 2644; mul 45 2645; sub 2646 2632; sub 2647 2639; mul
0 2648; mul 0 2649; add 2643 2650; sub 2620 2651; mul 0 1570; mul 27 939; add 2653 2654; mul 21 935; mul 594 2656;
add 2655 2657; mul 14 935; mul 11 2659; add 2658 2660; sub 2661 952; mul 31 1011; add 2662 2663; mul 0 2664; mul 0
2665; add 2652 2666; mul 224 1145; mul 54 1116; mul 160 2669; mul 290 1113; mul 262 1111; mul 159 2672; mul 159
1113; mul 305 2674; sub 2673 2675; mul 164 2676; add 2671 2677; add 2670 2678; mul 103 2679; mul 197 2676; mul 299
1113; sub 2681 2682; add 2680 2683; mul 195 2684; sub 2668 2685; mul 192 1139; mul 187 2676; mul 283 1113; sub 2688
2689; sub 1647 2690; mul 106 2679; add 2691 2692; mul 109 2693; add 2687 2694; add 2686 2695; mul 138 2696; mul 138
1149; mul 205 2698; sub 2697 2699; mul 125 2700; mul 798 2701; mul 798 1541; mul 907 2703; sub 2702 2704; mul 783
2705; mul 915 1541; sub 2706 2707; mul 1018 2708; mul 1016 2709; mul 220 1127; mul 174 2676; mul 268 1113; sub 2712
2713; mul 43 2679; sub 2714 2715; mul 172 2716; add 2711 2717; mul 169 1120; mul 155 2676; mul 275 1113; sub 2720
2721; sub 1647 2722; mul 57 2679; sub 2723 2724; mul 61 2725; add 2719 2726; add 2718 2727; mul 95 2728; mul 95
1131; mul 183 2730; sub 2729 2731; mul 79 2732; mul 768 2733; mul 768 1492; mul 853 2735; sub 2734 2736; mul 715
2737; mul 861 1492; sub 2738 2739; mul 1067 2740; mul 1065 2741; add 2710 2742; sub 2667 2743; mul 27 1160; mul 21
142; mul 1401 2746; mul 21 1155; mul 594 2748; add 2747 2749; add 2745 2750; mul 14 1155; mul 11 2752; add 2751
2753; sub 2754 1176; mul 31 1230; add 2755 2756; mul 0 2757; mul 0 2758; mul 27 1272; mul 21 349; mul 1401 2761; mul
21 1267; mul 594 2763; add 2762 2764; add 2760 2765; mul 14 1267; mul 11 2767; add 2766 2768; sub 2769 1286; mul 31
1323; add 2770 2771; mul 0 2772; mul 0 2773; add 2759 2774; mul 21 473; mul 1401 2776; mul 0 2777; mul 0 2778; sub
2775 2779; mul 35 177; mul 540 2781; mul 35 1338; add 2782 2783; mul 17 1107; mul 32 177; add 2785 2786; mul 1350
2787; add 2784 2788; mul 1107 1351; mul 32 1355; add 2790 2791; add 2789 2792; mul 27 1357; add 2793 2794; mul 1107
1363; add 2795 2796; mul 27 1366; add 2797 2798; mul 1107 1372; add 2799 2800; mul 27 1375; add 2801 2802; constant
46.285714285714285; mul 484 2804; mul 17 1104; mul 22 177; add 2806 2807; mul 2805 2808; add 2803 2809; mul 17 2805;
mul 1104 2811; mul 177 2805; mul 22 2813; add 2812 2814; add 2810 2815; mul 17 2811; mul 1401 2817; mul 177 2811;
mul 17 2813; add 2819 2820; mul 594 2821; add 2818 2822; add 2816 2823; constant 270.0; mul 484 2825; mul 11 2826;
mul 1104 2827; add 2824 2828; mul 17 2827; mul 1401 2830; mul 177 2827; mul 594 2832; add 2831 2833; add 2829 2834;
constant -18.0; mul 528 2836; mul 484 2837; mul 1104 2838; add 2835 2839; mul 17 2838; mul 1401 2841; mul 177 2838;
mul 594 2843; add 2842 2844; add 2840 2845; constant 592.0; mul 484 2847; mul 11 2848; mul 11 2849; mul 1401 2850;
add 2846 2851; constant -72.0; mul 528 2853; mul 484 2854; mul 11 2855; mul 1401 2856; add 2852 2857; mul 21 569;
add 1391 2859; mul 484 2860; mul 1401 2861; add 2858 2862; mul 0 2863; mul 0 2864; add 2780 2865; mul 27 1417; mul
21 617; mul 1401 2868; mul 21 1412; mul 594 2870; add 2869 2871; add 2867 2872; mul 14 1412; mul 11 2874; add 2873
2875; mul 0 2876; mul 0 2877; mul 644 1440; mul 21 1437; mul 675 2880; mul 21 693; mul 1401 2882; add 2881 2883; add
2879 2884; mul 14 1437; mul 649 2886; add 2885 2887; mul 0 2888; mul 0 2889; add 2878 2890; mul 654 2880; neg 2892;
mul 45 2893; sub 2894 2879; sub 2895 2887; mul 0 2896; mul 0 2897; add 2891 2898; sub 2866 2899; mul 27 1572; mul 21
812; mul 1401 2902; mul 21 1567; mul 594 2904; add 2903 2905; add 2901 2906; mul 14 1567; mul 11 2908; add 2907
2909; sub 2910 1586; mul 31 1623; add 2911 2912; mul 0 2913; mul 0 2914; add 2900 2915; mul 1145 1171; mul 1113
2669; mul 1113 1212; mul 1111 1188; mul 159 2920; mul 1225 2674; sub 2921 2922; mul 164 2923; add 2919 2924; add
2918 2925; mul 103 2926; mul 197 2923; mul 1113 1220; sub 2928 2929; add 2927 2930; mul 195 2931; sub 2917 2932; mul
1139 1140; mul 177 1401; mul 21 2935; mul 3 2936; mul 187 2923; mul 1113 1206; sub 2938 2939; sub 2937 2940; mul 106
2926; add 2941 2942; mul 109 2943; add 2934 2944; add 2933 2945; mul 138 2946; mul 1150 2698; sub 2947 2948; mul 125
2949; mul 798 2950; mul 1542 2703; sub 2951 2952; mul 783 2953; mul 1541 1549; sub 2954 2955; mul 1018 2956; mul
1016 2957; mul 1127 1167; mul 174 2923; mul 1113 1193; sub 2960 2961; mul 43 2926; sub 2962 2963; mul 172 2964; add
2959 2965; mul 1120 1121; mul 155 2923; mul 1113 1199; sub 2968 2969; sub 2937 2970; mul 57 2926; sub 2971 2972; mul
61 2973; add 2967 2974; add 2966 2975; mul 95 2976; mul 1132 2730; sub 2977 2978; mul 79 2979; mul 768 2980; mul
1493 2735; sub 2981 2982; mul 715 2983; mul 1492 1500; sub 2984 2985; mul 1067 2986; mul 1065 2987; add 2958 2988;
sub 2916 2989; mul 27 1757; mul 21 1754; mul 594 2992; add 2991 2993; mul 14 142; mul 1126 2995; mul 14 1754; mul 11
2997; add 2996 2998; add 2994 2999; sub 3000 1775; mul 31 1829; add 3001 3002; mul 0 3003; mul 0 3004; mul 27 1869;
mul 21 1866; mul 594 3007; add 3006 3008; mul 14 349; mul 1126 3010; mul 14 1866; mul 11 3012; add 3011 3013; add
3009 3014; sub 3015 1885; mul 31 1922; add 3016 3017; mul 0 3018; mul 0 3019; add 3005 3020; mul 14 473; mul 1126
3022; mul 0 3023; mul 0 3024; sub 3021 3025; mul 35 1936; mul 32 1949; add 3027 3028; mul 27 1950; add 3029 3030;
mul 27 1956; add 3031 3032; mul 27 1959; add 3033 3034; mul 1126 2826; mul 22 3036; add 3035 3037; mul 17 3036; mul
594 3039; add 3038 3040; mul 1126 2849; mul 1126 2848; mul 11 3043; add 3042 3044; mul 594 3045; add 3041 3046; mul
1126 2855; mul 594 3048; add 3047 3049; constant 576.0; mul 484 3051; mul 11 3052; mul 11 3053; mul 1126 3054; mul
1126 3053; mul 1126 3052; mul 11 3057; add 3056 3058; mul 11 3059; add 3055 3060; add 3050 3061; mul 1126 1388; mul
11 1959; add 3063 3064; add 3062 3065; mul 14 569; add 504 3067; mul 484 3068; mul 1126 3069; add 3066 3070; mul 0
3071; mul 0 3072; add 3026 3073; mul 27 2007; mul 21 2004; mul 594 3076; add 3075 3077; mul 14 617; mul 1126 3079;
mul 14 2004; mul 11 3081; add 3080 3082; add 3078 3083; mul 0 3084; mul 0 3085; mul 644 2032; mul 21 2029; mul 675
3088; add 3087 3089; mul 14 2029; mul 649 3091; mul 14 693; mul 1126 3093; add 3092 3094; add 3090 3095; mul 0 3096;
mul 0 3097; add 3086 3098; mul 654 3088; neg 3100; mul 45 3101; sub 3102 3087; sub 3103 3092; mul 0 3104; mul 0
3105; add 3099 3106; sub 3074 3107; mul 27 2162; mul 21 2159; mul 594 3110; add 3109 3111; mul 14 812; mul 1126
3113; mul 14 2159; mul 11 3115; add 3114 3116; add 3112 3117; sub 3118 2178; mul 31 2215; add 3119 3120; mul 0 3121;
mul 0 3122; add 3108 3123; mul 1145 1770; mul 1712 2669; mul 1113 1811; mul 1111 1787; mul 159 3128; mul 1824 2674;
sub 3129 3130; mul 164 3131; add 3127 3132; add 3126 3133; mul 103 3134; mul 197 3131; mul 1113 1819; sub 3136 3137;
add 3135 3138; mul 195 3139; sub 3125 3140; mul 1139 1739; mul 177 1126; mul 14 3143; mul 3 3144; mul 187 3131; mul
1113 1805; sub 3146 3147; sub 3145 3148; mul 106 3134; add 3149 3150; mul 109 3151; add 3142 3152; add 3141 3153;
mul 138 3154; mul 1749 2698; sub 3155 3156; mul 125 3157; mul 798 3158; mul 2134 2703; sub 3159 3160; mul 783 3161;
mul 1541 2141; sub 3162 3163; mul 1018 3164; mul 1016 3165; mul 1127 1766; mul 174 3131; mul 1113 1792; sub 3168
3169; mul 43 3134; sub 3170 3171; mul 172 3172; add 3167 3173; mul 1120 1720; mul 155 3131; mul 1113 1798; sub 3176
3177; sub 3145 3178; mul 57 3134; sub 3179 3180; mul 61 3181; add 3175 3182; add 3174 3183; mul 95 3184; mul 1731
2730; sub 3185 3186; mul 79 3187; mul 768 3188; mul 2085 2735; sub 3189 3190; mul 715 3191; mul 1492 2092; sub 3192
3193; mul 1067 3194; mul 1065 3195; add 3166 3196; sub 3124 3197; mul 27 2314; mul 21 2311; mul 594 3200; add 3199
3201; mul 14 2311; mul 11 3203; add 3202 3204; add 2323 3205; mul 31 2344; add 3206 3207; mul 0 3208; mul 0 3209;
mul 27 2386; mul 21 2383; mul 594 3212; add 3211 3213; mul 14 2383; mul 11 3215; add 3214 3216; sub 3217 2395; mul
31 2416; add 3218 3219; mul 0 3220; mul 0 3221; add 3210 3222; mul 27 2491; mul 21 2488; mul 594 3225; add 3224
3226; mul 14 2488; mul 11 3228; add 3227 3229; sub 3230 2500; mul 31 2521; add 3231 3232; mul 0 3233; mul 0 3234;
add 3223 3235; mul 1541 2459; mul 1139 2293; mul 138 3238; mul 2306 2698; sub 3239 3240; mul 125 3241; mul 798 3242;
mul 2469 2703; sub 3243 3244; mul 783 3245; add 3237 3246; mul 1018 3247; mul 1016 3248; mul 1492 2426; mul 1120
2293; mul 95 3251; mul 2298 2730; sub 3252 3253; mul 79 3254; mul 768 3255; mul 2436 2735; sub 3256 3257; mul 715
3258; add 3250 3259; mul 1067 3260; mul 1065 3261; add 3249 3262; sub 3236 3263; mul 0 1760; mul 27 217; add 3265
3266; mul 17 2560; add 3267 3268; mul 7 210; mul 579 3270; add 3269 3271; sub 3272 229; mul 14 310; add 3273 3274;
mul 0 3275; mul 0 3276; mul 0 3277; mul 0 1872; mul 27 396; add 3279 3280; mul 17 2574; add 3281 3282; mul 7 389;
mul 579 3284; add 3283 3285; sub 3286 406; mul 14 465; add 3287 3288; mul 0 3289; mul 0 3290; mul 0 3291; add 3278
3292; mul 0 1927; mul 0 3294; mul 0 3295; mul 0 3296; sub 3293 3297; mul 488 516; mul 546 2588; add 3299 3300; mul
11 151; mul 558 3302; add 3301 3303; mul 151 559; add 3304 3305; mul 151 565; add 3306 3307; mul 1362 2597; add 3308
3309; mul 11 148; mul 1380 3311; add 3310 3312; mul 148 1381; add 3313 3314; mul 148 1387; add 3315 3316; mul 11
146; mul 1963 3318; add 3317 3319; mul 146 1964; add 3320 3321; mul 0 1965; add 3322 3323; mul 146 1976; add 3324
3325; mul 0 1977; add 3326 3327; mul 0 1986; add 3328 3329; mul 0 3330; mul 0 3331; mul 0 3332; add 3298 3333; mul 0
2010; mul 27 639; add 3335 3336; mul 17 2627; add 3337 3338; mul 7 632; mul 579 3340; add 3339 3341; mul 0 3342; mul
0 3343; mul 0 3344; mul 644 700; mul 0 2037; add 3346 3347; mul 654 2638; add 3348 3349; mul 7 665; mul 668 3351;
add 3350 3352; mul 0 3353; mul 0 3354; mul 0 3355; add 3345 3356; mul 649 3351; neg 3358; mul 45 3359; add 3346
3349; sub 3360 3361; mul 0 3362; mul 0 3363; mul 0 3364; add 3357 3365; sub 3334 3366; mul 0 2165; mul 27 942; add
3368 3369; mul 17 2659; add 3370 3371; mul 7 935; mul 579 3373; add 3372 3374; sub 3375 952; mul 14 1011; add 3376
3377; mul 0 3378; mul 0 3379; mul 0 3380; add 3367 3381; mul 224 1744; mul 54 1715; mul 160 3384; mul 290 1712; mul
262 1710; mul 159 3387; mul 159 1712; mul 305 3389; sub 3388 3390; mul 164 3391; add 3386 3392; add 3385 3393; mul
103 3394; mul 197 3391; mul 299 1712; sub 3396 3397; add 3395 3398; mul 195 3399; sub 3383 3400; mul 192 1738; mul
187 3391; mul 283 1712; sub 3403 3404; sub 2239 3405; mul 106 3394; add 3406 3407; mul 109 3408; add 3402 3409; add
3401 3410; mul 138 3411; mul 138 1748; mul 205 3413; sub 3412 3414; mul 125 3415; mul 798 3416; mul 798 2133; mul
907 3418; sub 3417 3419; mul 783 3420; mul 915 2133; sub 3421 3422; mul 1018 3423; mul 1016 3424; mul 220 1726; mul
174 3391; mul 268 1712; sub 3427 3428; mul 43 3394; sub 3429 3430; mul 172 3431; add 3426 3432; mul 169 1719; mul
155 3391; mul 275 1712; sub 3435 3436; sub 2239 3437; mul 57 3394; sub 3438 3439; mul 61 3440; add 3434 3441; add
3433 3442; mul 95 3443; mul 95 1730; mul 183 3445; sub 3444 3446; mul 79 3447; mul 768 3448; mul 768 2084; mul 853
3450; sub 3449 3451; mul 715 3452; mul 861 2084; sub 3453 3454; mul 1067 3455; mul 1065 3456; add 3425 3457; sub
3382 3458; mul 27 1164; mul 177 2995; mul 17 2752; add 3461 3462; add 3460 3463; mul 7 1155; mul 579 3465; add 3464
3466; sub 3467 1176; mul 14 1230; add 3468 3469; mul 0 3470; mul 0 3471; mul 0 3472; mul 27 1276; mul 177 3010; mul
17 2767; add 3475 3476; add 3474 3477; mul 7 1267; mul 579 3479; add 3478 3480; sub 3481 1286; mul 14 1323; add 3482
3483; mul 0 3484; mul 0 3485; mul 0 3486; add 3473 3487; mul 177 3022; mul 0 3489; mul 0 3490; mul 0 3491; sub 3488
3492; mul 546 2781; mul 1362 2787; add 3494 3495; mul 11 1107; mul 1380 3497; add 3496 3498; mul 1107 1381; add 3499
3500; mul 1107 1387; add 3501 3502; mul 2808 2826; add 3503 3504; mul 11 1104; mul 2848 3506; add 3505 3507; mul
1104 2849; add 3508 3509; mul 1104 2855; add 3510 3511; mul 11 1102; mul 3052 3513; add 3512 3514; mul 1102 3053;
add 3515 3516; mul 177 3054; add 3517 3518; mul 1102 1387; add 3519 3520; add 1389 3521; mul 177 3069; add 3522
3523; mul 0 3524; mul 0 3525; mul 0 3526; add 3493 3527; mul 27 1421; mul 177 3079; mul 17 2874; add 3530 3531; add
3529 3532; mul 7 1412; mul 579 3534; add 3533 3535; mul 0 3536; mul 0 3537; mul 0 3538; mul 644 1446; mul 654 2886;
mul 177 3093; add 3541 3542; add 3540 3543; mul 7 1437; mul 668 3545; add 3544 3546; mul 0 3547; mul 0 3548; mul 0
3549; add 3539 3550; mul 649 3545; neg 3552; mul 45 3553; add 3540 3541; sub 3554 3555; mul 0 3556; mul 0 3557; mul
0 3558; add 3551 3559; sub 3528 3560; mul 27 1576; mul 177 3113; mul 17 2908; add 3563 3564; add 3562 3565; mul 7
1567; mul 579 3567; add 3566 3568; sub 3569 1586; mul 14 1623; add 3570 3571; mul 0 3572; mul 0 3573; mul 0 3574;
add 3561 3575; mul 1171 1744; mul 1113 3384; mul 1212 1712; mul 1188 1710; mul 159 3580; mul 1225 3389; sub 3581
3582; mul 164 3583; add 3579 3584; add 3578 3585; mul 103 3586; mul 197 3583; mul 1220 1712; sub 3588 3589; add 3587
3590; mul 195 3591; sub 3577 3592; mul 1140 1738; mul 187 3583; mul 1206 1712; sub 3595 3596; sub 3145 3597; mul 106
3586; add 3598 3599; mul 109 3600; add 3594 3601; add 3593 3602; mul 138 3603; mul 1150 3413; sub 3604 3605; mul 125
3606; mul 798 3607; mul 1542 3418; sub 3608 3609; mul 783 3610; mul 1549 2133; sub 3611 3612; mul 1018 3613; mul
1016 3614; mul 1167 1726; mul 174 3583; mul 1193 1712; sub 3617 3618; mul 43 3586; sub 3619 3620; mul 172 3621; add
3616 3622; mul 1121 1719; mul 155 3583; mul 1199 1712; sub 3625 3626; sub 3145 3627; mul 57 3586; sub 3628 3629; mul
61 3630; add 3624 3631; add 3623 3632; mul 95 3633; mul 1132 3445; sub 3634 3635; mul 79 3636; mul 768 3637; mul
1493 3450; sub 3638 3639; mul 715 3640; mul 1500 2084; sub 3641 3642; mul 1067 3643; mul 1065 3644; add 3615 3645;
sub 3576 3646; mul 27 1762; mul 17 2997; add 3648 3649; mul 7 142; mul 1991 3651; mul 7 1754; mul 579 3653; add 3652
3654; add 3650 3655; sub 3656 1775; mul 14 1829; add 3657 3658; mul 0 3659; mul 0 3660; mul 0 3661; mul 27 1874; mul
17 3012; add 3663 3664; mul 7 349; mul 1991 3666; mul 7 1866; mul 579 3668; add 3667 3669; add 3665 3670; sub 3671
1885; mul 14 1922; add 3672 3673; mul 0 3674; mul 0 3675; mul 0 3676; add 3662 3677; mul 7 473; mul 1991 3679; mul 0
3680; mul 0 3681; mul 0 3682; sub 3678 3683; mul 35 1126; mul 558 3685; mul 35 1941; add 3686 3687; mul 32 1126; mul
1380 3689; add 3688 3690; mul 32 1954; add 3691 3692; mul 11 1706; mul 28 1126; add 3694 3695; mul 1963 3696; add
3693 3697; mul 1706 1964; mul 28 1968; add 3699 3700; add 3698 3701; mul 27 1970; add 3702 3703; mul 1706 1976; add
3704 3705; mul 27 1979; add 3706 3707; mul 22 1126; mul 2848 3709; add 3708 3710; mul 22 3043; add 3711 3712; mul 11
1703; mul 18 1126; add 3714 3715; mul 3052 3716; add 3713 3717; mul 1703 3053; mul 18 3057; add 3719 3720; add 3718
3721; mul 17 3059; add 3722 3723; mul 1387 1703; add 3724 3725; add 1960 3726; constant 209.45454545454547; mul 484
3728; mul 11 1701; mul 12 1126; add 3730 3731; mul 3729 3732; add 3727 3733; mul 11 3729; mul 1701 3735; mul 1126
3729; mul 12 3737; add 3736 3738; add 3734 3739; mul 11 3735; mul 1991 3741; mul 1126 3735; mul 11 3737; add 3743
3744; mul 579 3745; add 3742 3746; add 3740 3747; constant -42.666666666666664; mul 528 3749; mul 484 3750; mul 1701
3751; add 3748 3752; mul 11 3751; mul 1991 3754; mul 1126 3751; mul 579 3756; add 3755 3757; add 3753 3758; constant
28.8; mul 7 569; add 3760 3761; mul 484 3762; mul 1991 3763; add 3759 3764; mul 0 3765; mul 0 3766; mul 0 3767; add
3684 3768; mul 27 2012; mul 17 3081; add 3770 3771; mul 7 617; mul 1991 3773; mul 7 2004; mul 579 3775; add 3774
3776; add 3772 3777; mul 0 3778; mul 0 3779; mul 0 3780; mul 644 2035; mul 654 3091; add 3782 3783; mul 7 2029; mul
668 3785; mul 7 693; mul 1991 3787; add 3786 3788; add 3784 3789; mul 0 3790; mul 0 3791; mul 0 3792; add 3781 3793;
mul 649 3785; neg 3795; mul 45 3796; sub 3797 3784; mul 0 3798; mul 0 3799; mul 0 3800; add 3794 3801; sub 3769
3802; mul 27 2167; mul 17 3115; add 3804 3805; mul 7 812; mul 1991 3807; mul 7 2159; mul 579 3809; add 3808 3810;
add 3806 3811; sub 3812 2178; mul 14 2215; add 3813 3814; mul 0 3815; mul 0 3816; mul 0 3817; add 3803 3818; mul
1744 1770; mul 1712 3384; mul 1712 1811; mul 1710 1787; mul 159 3823; mul 1824 3389; sub 3824 3825; mul 164 3826;
add 3822 3827; add 3821 3828; mul 103 3829; mul 197 3826; mul 1712 1819; sub 3831 3832; add 3830 3833; mul 195 3834;
sub 3820 3835; mul 1738 1739; mul 1126 1991; mul 7 3838; mul 3 3839; mul 187 3826; mul 1712 1805; sub 3841 3842; sub
3840 3843; mul 106 3829; add 3844 3845; mul 109 3846; add 3837 3847; add 3836 3848; mul 138 3849; mul 1749 3413; sub
3850 3851; mul 125 3852; mul 798 3853; mul 2134 3418; sub 3854 3855; mul 783 3856; mul 2133 2141; sub 3857 3858; mul
1018 3859; mul 1016 3860; mul 1726 1766; mul 174 3826; mul 1712 1792; sub 3863 3864; mul 43 3829; sub 3865 3866; mul
172 3867; add 3862 3868; mul 1719 1720; mul 155 3826; mul 1712 1798; sub 3871 3872; sub 3840 3873; mul 57 3829; sub
3874 3875; mul 61 3876; add 3870 3877; add 3869 3878; mul 95 3879; mul 1731 3445; sub 3880 3881; mul 79 3882; mul
768 3883; mul 2085 3450; sub 3884 3885; mul 715 3886; mul 2084 2092; sub 3887 3888; mul 1067 3889; mul 1065 3890;
add 3861 3891; sub 3819 3892; mul 27 2317; mul 17 3203; add 3894 3895; mul 7 2311; mul 579 3897; add 3896 3898; add
2323 3899; mul 14 2344; add 3900 3901; mul 0 3902; mul 0 3903; mul 0 3904; mul 27 2389; mul 17 3215; add 3906 3907;
mul 7 2383; mul 579 3909; add 3908 3910; sub 3911 2395; mul 14 2416; add 3912 3913; mul 0 3914; mul 0 3915; mul 0
3916; add 3905 3917; mul 27 2494; mul 17 3228; add 3919 3920; mul 7 2488; mul 579 3922; add 3921 3923; sub 3924
2500; mul 14 2521; add 3925 3926; mul 0 3927; mul 0 3928; mul 0 3929; add 3918 3930; mul 2133 2459; mul 1738 2293;
mul 138 3933; mul 2306 3413; sub 3934 3935; mul 125 3936; mul 798 3937; mul 2469 3418; sub 3938 3939; mul 783 3940;
add 3932 3941; mul 1018 3942; mul 1016 3943; mul 2084 2426; mul 1719 2293; mul 95 3946; mul 2298 3445; sub 3947
3948; mul 79 3949; mul 768 3950; mul 2436 3450; sub 3951 3952; mul 715 3953; add 3945 3954; mul 1067 3955; mul 1065
3956; add 3944 3957; sub 3931 3958; add 209 388; sub 631 3960; sub 3961 934; mul 191 2303; mul 2303 2304; mul 204
3964; sub 3963 3965; mul 125 3966; mul 798 3967; mul 798 2455; mul 907 3969; sub 3968 3970; mul 783 3971; mul 915
2455; sub 3972 3973; mul 1018 3974; mul 1016 3975; mul 168 2295; mul 2295 2296; mul 182 3978; sub 3977 3979; mul 79
3980; mul 768 3981; mul 768 2422; mul 853 3983; sub 3982 3984; mul 715 3985; mul 861 2422; sub 3986 3987; mul 1067
3988; mul 1065 3989; add 3976 3990; add 3962 3991; add 1154 1266; sub 1411 3993; sub 3994 1566; mul 1139 2303; mul
1149 3964; sub 3996 3997; mul 125 3998; mul 798 3999; mul 1542 3969; sub 4000 4001; mul 783 4002; mul 1549 2455; sub
4003 4004; mul 1018 4005; mul 1016 4006; mul 1120 2295; mul 1131 3978; sub 4008 4009; mul 79 4010; mul 768 4011; mul
1493 3983; sub 4012 4013; mul 715 4014; mul 1500 2422; sub 4015 4016; mul 1067 4017; mul 1065 4018; add 4007 4019;
add 3995 4020; add 1753 1865; sub 2003 4022; sub 4023 2158; mul 1738 2303; mul 1748 3964; sub 4025 4026; mul 125
4027; mul 798 4028; mul 2134 3969; sub 4029 4030; mul 783 4031; mul 2141 2455; sub 4032 4033; mul 1018 4034; mul
1016 4035; mul 1719 2295; mul 1730 3978; sub 4037 4038; mul 79 4039; mul 768 4040; mul 2085 3983; sub 4041 4042; mul
715 4043; mul 2092 2422; sub 4044 4045; mul 1067 4046; mul 1065 4047; add 4036 4048; add 4024 4049; input p 1; mul
483 4051; mul 45 4052; add 2310 2382; sub 4053 4054; sub 4055 2487; mul 2455 2459; mul 2304 3964; sub 4058 2303; mul
125 4059; mul 798 4060; mul 2469 3969; sub 4061 4062; mul 783 4063; add 4057 4064; mul 1018 4065; mul 1016 4066; mul
2422 2426; mul 2296 3978; sub 4069 2295; mul 79 4070; mul 768 4071; mul 2436 3983; sub 4072 4073; mul 715 4074; add
4068 4075; mul 1067 4076; mul 1065 4077; add 4067 4078; add 4056 4079; sub 161 154; sub 167 4081; mul 61 4082; add
179 4083; mul 95 4084; mul 79 4085; mul 768 4086; mul 715 4087; mul 45 4088; mul 774 4089; mul 715 4090; mul 768
4091; mul 79 4092; mul 95 4093; mul 61 4094; sub 188 154; add 190 4096; mul 109 4097; sub 201 4098; mul 138 4099;
mul 125 4100; mul 798 4101; mul 783 4102; mul 45 4103; mul 804 4104; mul 783 4105; mul 798 4106; mul 125 4107; mul
138 4108; mul 109 4109; add 4095 4110; mul 3 4111; mul 1 4112; mul 46 4113; mul 31 4112; mul 17 4115; add 4114 4116;
mul 25 4112; mul 11 4118; add 4117 4119; mul 172 4094; mul 195 4109; add 4121 4122; mul 0 4123; sub 4120 4124; mul
174 4121; mul 155 4095; sub 4126 4127; mul 187 4110; sub 4128 4129; mul 197 4122; sub 4130 4131; mul 57 4095; mul 43
4121; add 4133 4134; mul 106 4110; sub 4135 4136; mul 103 4122; add 4137 4138; mul 164 4139; sub 4132 4140; mul 159
4141; mul 156 4142; mul 54 4139; add 4143 4144; mul 45 4145; add 4125 4146; mul 0 4147; input p 5; mul 45 4149; mul
479 4150; mul 2 4151; mul 482 4152; mul 14 4153; mul 144 4154; mul 0 4155; add 4148 4156; neg 154; mul 45 4158; mul
577 4159; mul 3 4160; mul 1 4161; mul 645 4162; mul 45 759; mul 577 4164; mul 3 4165; mul 1 4166; mul 144 4167; add
4163 4168; mul 650 679; mul 320 655; add 4170 4171; mul 0 645; add 658 4173; mul 1 4174; add 4172 4175; mul 3 4176;
neg 4177; mul 45 4178; mul 577 4179; mul 3 4180; mul 1 4181; mul 46 4182; add 4169 4183; mul 31 4161; mul 654 4185;
mul 31 4181; mul 17 4187; add 4186 4188; add 4184 4189; mul 25 4161; mul 649 4191; mul 25 4181; mul 11 4193; add
4192 4194; add 4190 4195; mul 0 4196; mul 0 4167; mul 644 4162; add 4198 4199; neg 4200; mul 45 4201; sub 4202 4186;
sub 4203 4192; mul 0 4204; add 4197 4205; sub 4157 4206; sub 1114 1110; sub 1119 4208; mul 61 4209; add 1128 4210;
mul 95 4211; mul 79 4212; mul 768 4213; mul 715 4214; mul 45 4215; mul 774 4216; mul 715 4217; mul 768 4218; mul 79
4219; mul 95 4220; mul 61 4221; sub 1136 1110; add 1138 4223; mul 109 4224; sub 1146 4225; mul 138 4226; mul 125
4227; mul 798 4228; mul 783 4229; mul 45 4230; mul 804 4231; mul 783 4232; mul 798 4233; mul 125 4234; mul 138 4235;
mul 109 4236; add 4222 4237; mul 3 4238; mul 1 4239; mul 46 4240; mul 31 4239; mul 17 4242; add 4241 4243; mul 25
4239; mul 11 4245; add 4244 4246; mul 172 4221; mul 195 4236; add 4248 4249; mul 0 4250; sub 4247 4251; mul 174
4248; mul 155 4222; sub 4253 4254; mul 187 4237; sub 4255 4256; mul 197 4249; sub 4257 4258; mul 57 4222; mul 43
4248; add 4260 4261; mul 106 4237; sub 4262 4263; mul 103 4249; add 4264 4265; mul 164 4266; sub 4259 4267; mul 159
4268; mul 156 4269; mul 54 4266; add 4270 4271; mul 45 4272; add 4252 4273; mul 0 4274; mul 1391 4153; mul 177 4276;
mul 0 4277; add 4275 4278; neg 1110; mul 45 4280; mul 577 4281; mul 3 4282; mul 1 4283; mul 645 4284; mul 671 1425;
mul 177 675; add 1427 4287; mul 21 4288; add 4286 4289; mul 320 1430; add 4290 4291; mul 3 4292; neg 4293; mul 45
4294; mul 577 4295; mul 3 4296; mul 1 4297; mul 46 4298; add 4285 4299; mul 31 4283; mul 654 4301; mul 31 4166; mul
177 4303; add 4302 4304; mul 31 4297; mul 17 4306; add 4305 4307; add 4300 4308; mul 25 4283; mul 649 4310; mul 25
4297; mul 11 4312; add 4311 4313; add 4309 4314; mul 0 4315; mul 644 4284; neg 4317; mul 45 4318; sub 4319 4305; sub
4320 4311; mul 0 4321; add 4316 4322; sub 4279 4323; sub 1713 1709; sub 1718 4325; mul 61 4326; add 1727 4327; mul
95 4328; mul 79 4329; mul 768 4330; mul 715 4331; mul 45 4332; mul 774 4333; mul 715 4334; mul 768 4335; mul 79
4336; mul 95 4337; mul 61 4338; sub 1735 1709; add 1737 4340; mul 109 4341; sub 1745 4342; mul 138 4343; mul 125
4344; mul 798 4345; mul 783 4346; mul 45 4347; mul 804 4348; mul 783 4349; mul 798 4350; mul 125 4351; mul 138 4352;
mul 109 4353; add 4339 4354; mul 3 4355; mul 1 4356; mul 46 4357; mul 31 4356; mul 17 4359; add 4358 4360; mul 25
4356; mul 11 4362; add 4361 4363; mul 172 4338; mul 195 4353; add 4365 4366; mul 0 4367; sub 4364 4368; mul 174
4365; mul 155 4339; sub 4370 4371; mul 187 4354; sub 4372 4373; mul 197 4366; sub 4374 4375; mul 57 4339; mul 43
4365; add 4377 4378; mul 106 4354; sub 4379 4380; mul 103 4366; add 4381 4382; mul 164 4383; sub 4376 4384; mul 159
4385; mul 156 4386; mul 54 4383; add 4387 4388; mul 45 4389; add 4369 4390; mul 0 4391; mul 1983 4153; mul 1126
4393; mul 0 4394; add 4392 4395; neg 1709; mul 45 4397; mul 577 4398; mul 3 4399; mul 1 4400; mul 645 4401; mul 668
1126; add 2017 4403; mul 7 4404; mul 671 2019; add 4405 4406; mul 679 2022; add 4407 4408; mul 3 4409; neg 4410; mul
45 4411; mul 577 4412; mul 3 4413; mul 1 4414; mul 46 4415; add 4402 4416; mul 31 4400; mul 654 4418; mul 31 4414;
mul 17 4420; add 4419 4421; add 4417 4422; mul 25 4400; mul 649 4424; mul 25 4166; mul 1126 4426; add 4425 4427; mul
25 4414; mul 11 4429; add 4428 4430; add 4423 4431; mul 0 4432; mul 644 4401; neg 4434; mul 45 4435; sub 4436 4419;
sub 4437 4428; mul 0 4438; add 4433 4439; sub 4396 4440; neg 2423; mul 45 4442; mul 774 4443; mul 715 4444; mul 768
4445; mul 79 4446; mul 95 4447; mul 61 4448; neg 2456; mul 45 4450; mul 804 4451; mul 783 4452; mul 798 4453; mul
125 4454; mul 138 4455; mul 109 4456; add 4449 4457; mul 3 4458; mul 1 4459; mul 46 4460; mul 31 4459; mul 17 4462;
add 4461 4463; mul 25 4459; mul 11 4465; add 4464 4466; mul 172 4448; mul 195 4456; add 4468 4469; mul 0 4470; sub
4467 4471; mul 174 4468; mul 155 4449; sub 4473 4474; mul 187 4457; sub 4475 4476; mul 197 4469; sub 4477 4478; mul
57 4449; mul 43 4468; add 4480 4481; mul 106 4457; sub 4482 4483; mul 103 4469; add 4484 4485; mul 164 4486; sub
4479 4487; mul 159 4488; mul 156 4489; mul 54 4486; add 4490 4491; mul 45 4492; add 4472 4493; mul 0 4494; mul 3
470; mul 1 4496; mul 645 4497; mul 31 4496; mul 654 4499; add 4498 4500; mul 25 4496; mul 649 4502; add 4501 4503;
mul 0 4504; mul 644 4497; neg 4506; mul 45 4507; sub 4508 4500; sub 4509 4503; mul 0 4510; add 4505 4511; sub 4495
4512; mul 27 4115; mul 21 4112; mul 594 4515; add 4514 4516; mul 14 4112; mul 11 4518; add 4517 4519; sub 4520 4124;
mul 31 4145; add 4521 4522; mul 0 4523; mul 0 4524; mul 0 4276; mul 0 4526; mul 0 4527; add 4525 4528; mul 644 4185;
mul 0 4303; add 4530 4531; mul 27 4187; add 4532 4533; mul 21 4161; mul 675 4535; mul 21 4181; mul 594 4537; add
4536 4538; add 4534 4539; mul 14 4161; mul 649 4541; mul 14 4181; mul 11 4543; add 4542 4544; add 4540 4545; mul 0
4546; mul 0 4547; mul 654 4535; neg 4549; mul 45 4550; sub 4551 4532; sub 4552 4542; mul 0 4553; mul 0 4554; add
4548 4555; sub 4529 4556; mul 27 4242; mul 21 4239; mul 594 4559; add 4558 4560; mul 14 4239; mul 11 4562; add 4561
4563; sub 4564 4251; mul 31 4272; add 4565 4566; mul 0 4567; mul 0 4568; mul 1401 4276; mul 0 4570; mul 0 4571; add
4569 4572; mul 644 4301; mul 27 4306; add 4574 4575; mul 21 4283; mul 675 4577; mul 21 4166; mul 1401 4579; add 4578
4580; mul 21 4297; mul 594 4582; add 4581 4583; add 4576 4584; mul 14 4283; mul 649 4586; mul 14 4297; mul 11 4588;
add 4587 4589; add 4585 4590; mul 0 4591; mul 0 4592; mul 177 4579; mul 654 4577; add 4594 4595; neg 4596; mul 45
4597; sub 4598 4574; sub 4599 4587; mul 0 4600; mul 0 4601; add 4593 4602; sub 4573 4603; mul 27 4359; mul 21 4356;
mul 594 4606; add 4605 4607; mul 14 4356; mul 11 4609; add 4608 4610; sub 4611 4368; mul 31 4389; add 4612 4613; mul
0 4614; mul 0 4615; mul 504 4153; mul 1126 4617; mul 0 4618; mul 0 4619; add 4616 4620; mul 644 4418; mul 27 4420;
add 4622 4623; mul 21 4400; mul 675 4625; mul 21 4414; mul 594 4627; add 4626 4628; add 4624 4629; mul 14 4400; mul
649 4631; mul 14 4166; mul 1126 4633; add 4632 4634; mul 14 4414; mul 11 4636; add 4635 4637; add 4630 4638; mul 0
4639; mul 0 4640; mul 654 4625; neg 4642; mul 45 4643; sub 4644 4622; sub 4645 4635; mul 0 4646; mul 0 4647; add
4641 4648; sub 4621 4649; mul 27 4462; mul 21 4459; mul 594 4652; add 4651 4653; mul 14 4459; mul 11 4655; add 4654
4656; sub 4657 4471; mul 31 4492; add 4658 4659; mul 0 4660; mul 0 4661; mul 644 4499; mul 21 4496; mul 675 4664;
add 4663 4665; mul 14 4496; mul 649 4667; add 4666 4668; mul 0 4669; mul 0 4670; mul 654 4664; neg 4672; mul 45
4673; sub 4674 4663; sub 4675 4668; mul 0 4676; mul 0 4677; add 4671 4678; sub 4662 4679; mul 27 4118; mul 17 4518;
add 4681 4682; mul 7 4112; mul 579 4684; add 4683 4685; sub 4686 4124; mul 14 4145; add 4687 4688; mul 0 4689; mul 0
4690; mul 0 4691; mul 0 4393; mul 0 4693; mul 0 4694; mul 0 4695; add 4692 4696; mul 644 4191; mul 0 4426; add 4698
4699; mul 27 4193; add 4700 4701; mul 654 4541; mul 17 4543; add 4703 4704; add 4702 4705; mul 7 4161; mul 668 4707;
mul 7 4181; mul 579 4709; add 4708 4710; add 4706 4711; mul 0 4712; mul 0 4713; mul 0 4714; mul 649 4707; neg 4716;
mul 45 4717; add 4700 4703; sub 4718 4719; mul 0 4720; mul 0 4721; mul 0 4722; add 4715 4723; sub 4697 4724; mul 27
4245; mul 17 4562; add 4726 4727; mul 7 4239; mul 579 4729; add 4728 4730; sub 4731 4251; mul 14 4272; add 4732
4733; mul 0 4734; mul 0 4735; mul 0 4736; mul 177 4617; mul 0 4738; mul 0 4739; mul 0 4740; add 4737 4741; mul 644
4310; mul 27 4312; add 4743 4744; mul 654 4586; mul 177 4633; add 4746 4747; mul 17 4588; add 4748 4749; add 4745
4750; mul 7 4283; mul 668 4752; mul 7 4297; mul 579 4754; add 4753 4755; add 4751 4756; mul 0 4757; mul 0 4758; mul
0 4759; mul 649 4752; neg 4761; mul 45 4762; add 4743 4748; sub 4763 4764; mul 0 4765; mul 0 4766; mul 0 4767; add
4760 4768; sub 4742 4769; mul 27 4362; mul 17 4609; add 4771 4772; mul 7 4356; mul 579 4774; add 4773 4775; sub 4776
4368; mul 14 4389; add 4777 4778; mul 0 4779; mul 0 4780; mul 0 4781; mul 3760 4153; mul 1991 4783; mul 0 4784; mul
0 4785; mul 0 4786; add 4782 4787; mul 644 4424; mul 27 4429; add 4789 4790; mul 654 4631; mul 17 4636; add 4792
4793; add 4791 4794; mul 7 4400; mul 668 4796; mul 7 4166; mul 1991 4798; add 4797 4799; mul 7 4414; mul 579 4801;
add 4800 4802; add 4795 4803; mul 0 4804; mul 0 4805; mul 0 4806; mul 1126 4798; mul 649 4796; add 4808 4809; neg
4810; mul 45 4811; add 4789 4792; sub 4812 4813; mul 0 4814; mul 0 4815; mul 0 4816; add 4807 4817; sub 4788 4818;
mul 27 4465; mul 17 4655; add 4820 4821; mul 7 4459; mul 579 4823; add 4822 4824; sub 4825 4471; mul 14 4492; add
4826 4827; mul 0 4828; mul 0 4829; mul 0 4830; mul 644 4502; mul 654 4667; add 4832 4833; mul 7 4496; mul 668 4835;
add 4834 4836; mul 0 4837; mul 0 4838; mul 0 4839; mul 649 4835; neg 4841; mul 45 4842; sub 4843 4834; mul 0 4844;
mul 0 4845; mul 0 4846; add 4840 4847; sub 4831 4848; sub 4180 4111; sub 4296 4238; sub 4413 4355; neg 4458; mul 911
1018; neg 4854; mul 857 1067; neg 4856; input p 9; mul 177 4858; mul 1018 1546; neg 4860; mul 1067 1497; neg 4862;
mul 1126 4858; mul 1018 2138; neg 4865; mul 1067 2089; neg 4867; mul 1725 4858; mul 1018 2456; mul 1067 2423;
constant 0.0; neg 917; neg 1551; neg 2143; neg 2473; neg 863; neg 1502; neg 2094; neg 2440; neg 4103; neg 4230; neg
4347; neg 4088; neg 4215; neg 4332; input x 10; sign 730; mul 177 4888; mul 4887 4889; sub 177 4890; input p 10; div
44 4892; mul 4891 4893; mul 1126 4888; mul 4887 4895; sub 1126 4896; mul 4893 4897; mul 1725 4888; mul 4887 4899;
sub 1725 4900; mul 4893 4901; input p 24; div 44 4903; mul 1017 4904; neg 4905; input p 39; div 44 4907; mul 1066
4908; neg 4909; abs 730; mul 4893 4911; neg 4912; mul 74 120; mul 125 4914; mul 138 4915; mul 109 4916; mul 3 4917;
mul 1 4918; mul 46 4919; mul 31 4918; mul 17 4921; add 4920 4922; mul 25 4918; mul 11 4924; add 4923 4925; mul 195
4916; mul 0 4927; sub 4926 4928; mul 103 4927; mul 106 4917; sub 4930 4931; mul 54 4932; mul 187 4917; mul 164 4932;
add 4934 4935; mul 197 4927; add 4936 4937; mul 159 4938; mul 156 4939; sub 4933 4940; mul 45 4941; add 4929 4942;
mul 0 4943; mul 73 74; mul 79 4945; mul 95 4946; mul 61 4947; mul 3 4948; mul 1 4949; mul 46 4950; mul 31 4949; mul
17 4952; add 4951 4953; mul 25 4949; mul 11 4955; add 4954 4956; mul 172 4947; mul 0 4958; sub 4957 4959; mul 57
4948; mul 43 4958; add 4961 4962; mul 54 4963; mul 174 4958; mul 155 4948; sub 4965 4966; mul 164 4963; sub 4967
4968; mul 159 4969; mul 156 4970; add 4964 4971; mul 45 4972; add 4960 4973; mul 0 4974; mul 27 4921; mul 21 4918;
mul 594 4977; add 4976 4978; mul 14 4918; mul 11 4980; add 4979 4981; sub 4982 4928; mul 31 4941; add 4983 4984; mul
0 4985; mul 0 4986; mul 27 4952; mul 21 4949; mul 594 4989; add 4988 4990; mul 14 4949; mul 11 4992; add 4991 4993;
sub 4994 4959; mul 31 4972; add 4995 4996; mul 0 4997; mul 0 4998; mul 27 4924; mul 17 4980; add 5000 5001; mul 7
4918; mul 579 5003; add 5002 5004; sub 5005 4928; mul 14 4941; add 5006 5007; mul 0 5008; mul 0 5009; mul 0 5010;
mul 27 4955; mul 17 4992; add 5012 5013; mul 7 4949; mul 579 5015; add 5014 5016; sub 5017 4959; mul 14 4972; add
5018 5019; mul 0 5020; mul 0 5021; mul 0 5022; neg 4917; neg 4948; store slopes 0 1101; store slopes 1 1700; store
slopes 2 2292; store slopes 3 2553; store slopes 4 2744; store slopes 5 2990; store slopes 6 3198; store slopes 7
3264; store slopes 8 3459; store slopes 9 3647; store slopes 10 3893; store slopes 11 3959; store slopes 12 3992;
store slopes 13 4021; store slopes 14 4050; store slopes 15 4080; store slopes 16 4207; store slopes 17 4324; store
slopes 18 4441; store slopes 19 4513; store slopes 20 4557; store slopes 21 4604; store slopes 22 4650; store slopes
23 4680; store slopes 24 4725; store slopes 25 4770; store slopes 26 4819; store slopes 27 4849; store slopes 28
4850; store slopes 29 4851; store slopes 30 4852; store slopes 31 4853; store slopes 32 4855; store slopes 33 4857;
store slopes 34 4859; store slopes 35 4861; store slopes 36 4863; store slopes 37 4864; store slopes 38 4866; store
slopes 39 4868; store slopes 40 4869; store slopes 41 4870; store slopes 42 4871; store slopes 43 4872; store slopes
44 4873; store slopes 45 4874; store slopes 46 4875; store slopes 47 4876; store slopes 48 4877; store slopes 49
4878; store slopes 50 4879; store slopes 51 4880; store slopes 52 4872; store slopes 53 4872; store slopes 54 4872;
store slopes 55 4872; store slopes 56 4881; store slopes 57 4882; store slopes 58 4883; store slopes 59 2456; store
slopes 60 4884; store slopes 61 4885; store slopes 62 4886; store slopes 63 2423; store slopes 64 4894; store slopes
65 4898; store slopes 66 4902; store slopes 67 4872; store slopes 68 4906; store slopes 69 4910; store slopes 70
4913; store slopes 71 4944; store slopes 72 4975; store slopes 73 4987; store slopes 74 4999; store slopes 75 5011;
store slopes 76 5023; store slopes 77 5024; store slopes 78 5025
    """,
)


_statics = kernel(STATICS, value='energy')


@compiled(inline='always')
def statics(qm: FloatArray, v_squared: FloatArray, p: FloatArray, gradient: FloatArray, hessian: FloatArray) -> float:
    """U − ½ΣC_i v_i² [J], returned; its gradient (4,) and Hessian (4, 4) in q_m."""
    found: float = _statics((qm, v_squared, p, gradient, hessian))
    return found


_static_sensitivity = kernel(STATIC_SENSITIVITY, value=None)


@compiled(inline='always')
def static_sensitivity(qm: FloatArray, v_squared: FloatArray, p: FloatArray, gradient_p: FloatArray) -> None:
    """Derivative of the static gradient with respect to the parameters, (4, 41)."""
    _static_sensitivity((qm, v_squared, p, gradient_p))


_tip = kernel(TIP, value=None)


@compiled(inline='always')
def tip(qm: FloatArray, p: FloatArray, values: FloatArray, jacobian: FloatArray) -> None:
    """q [m], φ [rad], u_y [m], λ1, λ2 of left and right (5,) and their derivatives in q_m (5, 4)."""
    _tip((qm, p, values, jacobian))


_capacitance = kernel(CAPACITANCE, value=None)


@compiled(inline='always')
def capacitance(qm: FloatArray, p: FloatArray, values: FloatArray, jacobian: FloatArray) -> None:
    """C_1, C_2 [F] (2,) and ∂C_i/∂q_m (2, 4)."""
    _capacitance((qm, p, values, jacobian))


_dissipation = kernel(DISSIPATION, value=None)


@compiled(inline='always')
def dissipation(qm: FloatArray, p: FloatArray, damping: FloatArray, coupling: FloatArray, thickness_jacobian: FloatArray) -> None:
    """Damping matrix D (4, 4), coupling of z to the forces (4, 3), ∂λ_{3,i}/∂q_m (2, 4)."""
    _dissipation((qm, p, damping, coupling, thickness_jacobian))


_dynamics = kernel(DYNAMICS, value=None)


@compiled(inline='always')
def dynamics(qm: FloatArray, qm_dot: FloatArray, z: FloatArray, v_squared: FloatArray, force: FloatArray, p: FloatArray, mass: FloatArray, tau: FloatArray, z_dot: FloatArray) -> None:
    """Mass matrix M (4, 4), right-hand side τ (4,) of M q̈_m = τ, and ż (3,)."""
    _dynamics((qm, qm_dot, z, v_squared, force, p, mass, tau, z_dot))


_motion = kernel(MOTION, value=None)


@compiled(inline='always')
def motion(x: FloatArray, v_squared: FloatArray, force: FloatArray, p: FloatArray, mass: FloatArray, right: FloatArray) -> None:
    """As `dynamics`, of x = [q_m, q̇_m, z] (11,): M, and q̇_m, τ, ż in `right` (11,)."""
    _motion((x, v_squared, force, p, mass, right))


_motion_slopes = kernel(MOTION_SLOPES, value=None)


@compiled(inline='always')
def motion_slopes(x: FloatArray, v_squared: FloatArray, force: FloatArray, p: FloatArray, a: FloatArray, slopes: FloatArray) -> None:
    """Derivatives of r = M q̈_m − τ and ż, q̈_m = `a` (4,): r_q, r_v, r_z, z_q, z_v, z_z, and r_s by v_i² (79,)."""
    _motion_slopes((x, v_squared, force, p, a, slopes))
