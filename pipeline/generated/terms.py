"""Terms of the models of which each run has as many as it needs: see the functions of the same names.

Written by ``python -m pipeline.equations.write`` from `pipeline.equations`; not edited.
"""

# fmt: off
# ruff: noqa

from ..codegen.graph import Graph

STOP_OPERATOR = Graph(
    {'z': 1, 'play': 1, 'travel': 1},
    {'value': 1, 'slopes': 3},
    """
constant 1.0; constant -1.0; input z 0; input play 0; input travel 0; div 0 4; mul 3 5; add 2 6; max 1 7; min 0 8;
abs 7; lt 10 0; where 11 0; where 11 5; mul 5 6; neg 14; where 11 15; store value 0 9; store slopes 0 12; store
slopes 1 13; store slopes 2 16
    """,
)

POWERS = Graph(
    {'x': 1},
    {'value': 4, 'slopes': 4},
    """
constant 1.0; input x 0; mul 1 1; mul 1 2; constant 0.0; constant 2.0; mul 1 5; mul 1 6; add 2 7; store value 0 0;
store value 1 1; store value 2 2; store value 3 3; store slopes 0 4; store slopes 1 0; store slopes 2 6; store
slopes 3 8
    """,
)

TURNING_ARM = Graph(
    {'x': 1, 'arm': 2},
    {'value': 4, 'slopes': 4},
    """
constant 1.0; input arm 0; input arm 1; input x 0; mul 2 3; add 1 4; sin 5; cos 5; mul 3 3; mul 3 8; constant -1.0;
max 10 3; min 0 11; sub 3 12; constant 0.1; div 0 14; mul 13 15; mul 16 16; mul 16 17; add 9 18; constant 0.0; mul 2
7; mul 2 6; neg 22; constant 2.0; mul 3 24; mul 3 25; add 8 26; mul 16 24; constant 10.0; le 11 0; le 0 11; add 30
31; div 0 32; mul 30 33; le 10 3; le 3 10; add 35 36; div 0 37; mul 35 38; mul 34 39; sub 0 40; mul 29 41; mul 28
42; mul 16 43; mul 17 42; add 44 45; add 27 46; store value 0 0; store value 1 6; store value 2 7; store value 3 19;
store slopes 0 20; store slopes 1 21; store slopes 2 23; store slopes 3 47
    """,
)

CLIPPED = Graph(
    {'x': 1, 'low': 1, 'high': 1},
    {'value': 1, 'slopes': 1},
    """
input high 0; input low 0; input x 0; max 1 2; min 0 3; le 3 0; le 0 3; add 5 6; constant 1.0; div 8 7; mul 5 9; le
1 2; le 2 1; add 11 12; div 8 13; mul 11 14; mul 10 15; store value 0 4; store slopes 0 16
    """,
)

CONFINED_FORCE = Graph(
    {'x': 1, 'force': 1, 'at_ends': 2, 'low': 1, 'high': 1},
    {'value': 1, 'slopes': 4},
    """
input x 0; input low 0; lt 0 1; input force 0; input at_ends 0; constant 0.0; neg 4; max 5 6; constant 0.15;
constant 1.0; div 9 8; mul 7 10; sub 1 0; mul 11 12; add 4 13; max 3 14; where 2 15; not 2; input high 0; lt 18 0;
input at_ends 1; max 5 20; mul 10 21; sub 0 18; mul 22 23; sub 20 24; min 3 25; where 19 26; not 19; where 28 3; add
27 29; where 17 30; add 16 31; le 25 3; le 3 25; add 33 34; div 9 35; mul 33 36; mul 22 37; neg 38; where 17 39;
where 19 40; le 3 14; le 14 3; add 42 43; div 9 44; mul 42 45; mul 11 46; neg 47; where 2 48; add 41 49; where 17 9;
where 28 51; mul 34 36; where 17 53; where 19 54; add 52 55; mul 43 45; where 2 57; add 56 58; le 5 6; le 6 5; add
60 61; div 9 62; mul 60 63; constant 6.666666666666667; mul 12 46; mul 65 66; mul 64 67; sub 46 68; where 2 69; le 5
20; le 20 5; add 71 72; div 9 73; mul 71 74; mul 23 37; mul 65 76; mul 75 77; sub 37 78; where 17 79; where 19 80;
store value 0 32; store slopes 0 50; store slopes 1 59; store slopes 2 70; store slopes 3 81
    """,
)

BENT = Graph(
    {'drive': 1, 'bend': 1},
    {'value': 1, 'slopes': 2},
    """
input drive 0; input bend 0; exp 1; mul 0 2; constant 1.0; sub 2 4; abs 0; min 6 4; mul 5 7; add 4 8; div 4 9; mul 3
10; mul 2 10; mul 10 11; le 6 4; le 4 6; add 14 15; div 4 16; mul 14 17; sign 0; mul 18 19; mul 5 20; mul 13 21; sub
12 22; mul 2 7; mul 13 24; sub 11 25; store value 0 11; store slopes 0 23; store slopes 1 26
    """,
)

PAST_ZONE = Graph(
    {'drive': 1, 'zone': 1},
    {'value': 1, 'slopes': 2},
    """
constant 0.5; input drive 0; input zone 0; sub 1 2; mul 3 3; constant 0.0001; add 4 5; sqrt 6; add 3 7; mul 0 8; add
1 2; mul 10 10; add 5 11; sqrt 12; sub 13 10; mul 0 14; sub 9 15; constant 1.0; div 17 7; mul 3 18; add 17 19; mul 0
20; div 17 13; mul 10 22; constant -1.0; add 23 24; mul 0 25; sub 21 26; sub 24 19; mul 0 28; sub 29 26; store value
0 16; store slopes 0 27; store slopes 1 30
    """,
)

BELL = Graph(
    {'inside': 1, 'centre': 1, 'bend': 1},
    {'value': 1, 'slopes': 1, 'curvature': 1},
    """
constant -0.5; input bend 0; constant 2.0; mul 1 2; input inside 0; input centre 0; sub 4 5; mul 3 6; mul 6 7; mul 0
8; exp 9; mul 7 10; neg 11; mul 3 10; mul 7 11; sub 13 14; neg 15; store value 0 10; store slopes 0 12; store
curvature 0 16
    """,
)

ACCELERATION = Graph(
    {'p': 1, 'curves': 2, 'push': 1, 'arm': 1, 'arc': 1, 'drag': 1},
    {'value': 1, 'slopes': 7},
    """
input curves 0; input curves 1; input drag 0; input p 0; abs 3; mul 2 4; add 1 5; mul 3 6; sub 0 7; input arc 0;
input arm 0; mul 9 10; mul 3 11; mul 3 12; sub 8 13; input push 0; add 14 15; constant 1.0; mul 10 11; add 17 18;
div 17 19; mul 16 20; mul 12 20; mul 3 20; mul 11 23; add 22 24; mul 6 20; add 25 26; sign 3; mul 2 23; mul 28 29;
add 27 30; neg 31; neg 23; mul 20 21; mul 11 34; mul 10 34; mul 9 36; add 35 37; mul 3 23; mul 9 39; add 38 40; neg
41; mul 10 36; mul 10 39; add 43 44; neg 45; mul 4 23; neg 47; store value 0 21; store slopes 0 32; store slopes 1
20; store slopes 2 33; store slopes 3 20; store slopes 4 42; store slopes 5 46; store slopes 6 48
    """,
)

ELEMENT = Graph(
    {'coupling': 1, 'p': 1, 'rate': 1, 'load': 1},
    {'value': 1, 'slopes': 4},
    """
input coupling 0; input p 0; mul 0 1; input rate 0; input load 0; mul 3 4; sub 2 5; neg 4; neg 3; store value 0 6;
store slopes 0 1; store slopes 1 0; store slopes 2 7; store slopes 3 8
    """,
)

DAHL_MOVE = Graph(
    {'state': 1, 'travel': 1, 'length': 1},
    {'value': 1, 'slopes': 3},
    """
constant 0.0; input travel 0; le 0 1; constant 1.0; where 2 3; not 2; constant -1.0; where 5 6; add 4 7; input state
0; sub 9 8; mul 1 8; input length 0; div 3 12; mul 11 13; neg 14; exp 15; mul 10 16; add 8 17; mul 13 17; mul 8 19;
neg 20; mul 13 14; mul 17 22; store value 0 18; store slopes 0 16; store slopes 1 21; store slopes 2 23
    """,
)

STOP_FORCE = Graph(
    {'x': 1, 'p': 1, 'stops': 4},
    {'value': 1, 'slopes': 6},
    """
input stops 2; constant 0.5; input stops 0; input x 0; sub 2 3; mul 4 4; constant 0.0001; add 5 6; sqrt 7; add 4 8;
mul 1 9; input stops 1; sub 3 11; mul 12 12; add 6 13; sqrt 14; add 12 15; mul 1 16; sub 10 17; mul 0 18; input
stops 3; constant 1.0; div 21 8; mul 4 22; add 21 23; mul 1 24; div 21 15; mul 12 26; add 21 27; mul 1 28; add 25
29; mul 20 30; input p 0; mul 31 32; sub 19 33; constant 2.0; mul 12 35; mul 26 27; mul 20 32; mul 1 38; mul 37 39;
mul 15 35; div 21 41; mul 40 42; mul 36 43; mul 26 39; sub 44 45; mul 0 1; sub 46 47; mul 42 47; mul 36 49; sub 48
50; mul 4 35; mul 22 23; mul 39 53; mul 8 35; div 21 55; mul 54 56; mul 52 57; mul 22 39; sub 58 59; add 47 60; mul
47 56; mul 52 62; add 61 63; sub 51 64; neg 31; neg 51; mul 30 32; neg 68; store value 0 34; store slopes 0 65;
store slopes 1 66; store slopes 2 64; store slopes 3 67; store slopes 4 18; store slopes 5 69
    """,
)

DAHL_RATE = Graph(
    {'p': 1, 'state': 1, 'length': 1},
    {'rate': 1},
    """
input p 0; abs 0; input state 0; mul 1 2; sub 0 3; input length 0; constant 1.0; div 6 5; mul 4 7; store rate 0 8
    """,
)

GAUSSIAN = Graph(
    {'square': 1},
    {'found': 1},
    """
constant -0.5; input square 0; mul 0 1; exp 2; store found 0 3
    """,
)

BELL_SHAPE = Graph(
    {'q': 1, 'basis': 3},
    {'shape': 3},
    """
constant -0.5; input q 0; input basis 0; sub 1 2; input basis 2; constant 1.0; div 5 4; mul 3 6; mul 7 7; mul 0 8;
exp 9; constant 2.0; mul 7 11; mul 0 10; mul 12 13; mul 6 14; mul 6 12; mul 0 16; mul 10 17; mul 0 18; mul 12 19;
mul 6 13; mul 11 21; add 20 22; mul 6 23; store shape 0 10; store shape 1 15; store shape 2 24
    """,
)

FIRST_BELL = Graph(
    {'q': 1, 'basis': 3},
    {'bell': 4},
    """
input q 0; input basis 0; sub 0 1; input basis 2; constant 1.0; div 4 3; mul 2 5; constant -0.5; mul 6 6; mul 7 8;
exp 9; input basis 1; mul 5 11; constant 2.0; mul 6 13; sub 12 14; mul 12 15; mul 7 16; exp 17; mul 12 13; mul 12
19; mul 7 20; exp 21; store bell 0 6; store bell 1 10; store bell 2 18; store bell 3 22
    """,
)

NEXT_BELL = Graph(
    {'bell': 4, 'basis': 3},
    {'slope': 1, 'next': 4},
    """
input bell 0; input basis 2; constant 1.0; div 2 1; mul 0 3; input bell 1; mul 4 5; neg 6; input basis 1; mul 3 8;
sub 0 9; input bell 2; mul 5 11; input bell 3; mul 11 13; store slope 0 7; store next 0 10; store next 1 12; store
next 2 14; store next 3 13
    """,
)

LAGGED_RATES = Graph(
    {'q': 1, 'q_dot': 1, 'z': 1, 'curves': 2, 'push': 1, 'lag': 1},
    {'rates': 2},
    """
input push 0; input curves 0; input q 0; mul 1 2; sub 0 3; input curves 1; input z 0; mul 5 6; sub 4 7; input q_dot
0; sub 9 6; input lag 0; constant 1.0; div 12 11; mul 10 13; store rates 0 8; store rates 1 14
    """,
)

POLYNOMIAL_VARIABLES = Graph(
    {'q': 1, 'q_dot': 1, 'scales': 3},
    {'variables': 3},
    """
input q 0; input scales 0; constant 1.0; div 2 1; mul 0 3; input q_dot 0; input scales 1; div 2 6; mul 5 7; input
scales 2; div 2 9; mul 5 10; tanh 11; store variables 0 4; store variables 1 8; store variables 2 12
    """,
)

LAG = Graph(
    {'value': 1, 'lagged': 1, 'lag': 1},
    {'rate': 1},
    """
input value 0; input lagged 0; sub 0 1; input lag 0; constant 1.0; div 4 3; mul 2 5; store rate 0 6
    """,
)

CUBICS = Graph(
    {'pieces': 28, 's': 1},
    {'curves': 7, 'slopes': 7},
    """
input pieces 21; input s 0; mul 0 1; input pieces 14; add 2 3; mul 1 4; input pieces 7; add 5 6; mul 1 7; input
pieces 0; add 8 9; input pieces 22; mul 1 11; input pieces 15; add 12 13; mul 1 14; input pieces 8; add 15 16; mul 1
17; input pieces 1; add 18 19; input pieces 23; mul 1 21; input pieces 16; add 22 23; mul 1 24; input pieces 9; add
25 26; mul 1 27; input pieces 2; add 28 29; input pieces 24; mul 1 31; input pieces 17; add 32 33; mul 1 34; input
pieces 10; add 35 36; mul 1 37; input pieces 3; add 38 39; input pieces 25; mul 1 41; input pieces 18; add 42 43;
mul 1 44; input pieces 11; add 45 46; mul 1 47; input pieces 4; add 48 49; input pieces 26; mul 1 51; input pieces
19; add 52 53; mul 1 54; input pieces 12; add 55 56; mul 1 57; input pieces 5; add 58 59; input pieces 27; mul 1 61;
input pieces 20; add 62 63; mul 1 64; input pieces 13; add 65 66; mul 1 67; input pieces 6; add 68 69; add 2 4; mul
1 71; add 7 72; add 12 14; mul 1 74; add 17 75; add 22 24; mul 1 77; add 27 78; add 32 34; mul 1 80; add 37 81; add
42 44; mul 1 83; add 47 84; add 52 54; mul 1 86; add 57 87; add 62 64; mul 1 89; add 67 90; store curves 0 10; store
curves 1 20; store curves 2 30; store curves 3 40; store curves 4 50; store curves 5 60; store curves 6 70; store
slopes 0 73; store slopes 1 76; store slopes 2 79; store slopes 3 82; store slopes 4 85; store slopes 5 88; store
slopes 6 91
    """,
)

REDUCED_MOTION = Graph(
    {'pieces': 28, 's': 1, 'q_dot': 1, 'e': 2, 'v_squared': 2, 'load': 1, 'gain': 2, 'rate': 2},
    {'rates': 3},
    """
input load 0; constant 0.5; input s 0; input pieces 26; mul 2 3; input pieces 19; add 4 5; add 4 6; mul 2 7; mul 2
6; input pieces 12; add 9 10; add 8 11; input v_squared 0; mul 12 13; input pieces 27; mul 2 15; input pieces 20;
add 16 17; add 16 18; mul 2 19; mul 2 18; input pieces 13; add 21 22; add 20 23; input v_squared 1; mul 24 25; add
14 26; mul 1 27; add 0 28; input gain 0; input pieces 24; mul 2 31; input pieces 17; add 32 33; add 32 34; mul 2 35;
mul 2 34; input pieces 10; add 37 38; add 36 39; mul 30 40; input e 0; mul 41 42; input gain 1; input pieces 25; mul
2 45; input pieces 18; add 46 47; add 46 48; mul 2 49; mul 2 48; input pieces 11; add 51 52; add 50 53; mul 44 54;
input e 1; mul 55 56; add 43 57; sub 29 58; input pieces 22; mul 2 60; input pieces 15; add 61 62; mul 2 63; input
pieces 8; add 64 65; mul 2 66; input pieces 1; add 67 68; input q_dot 0; mul 69 70; input pieces 23; mul 2 72; input
pieces 16; add 73 74; mul 2 75; input pieces 9; add 76 77; mul 2 78; input pieces 2; add 79 80; add 71 81; input
pieces 21; mul 2 83; input pieces 14; add 84 85; add 84 86; mul 2 87; mul 2 86; input pieces 7; add 89 90; add 88
91; mul 1 92; mul 70 70; mul 93 94; add 82 95; sub 59 96; mul 2 91; input pieces 0; add 98 99; constant 1.0; div 101
100; mul 97 102; mul 40 70; input rate 0; mul 42 105; sub 104 106; mul 54 70; input rate 1; mul 56 109; sub 108 110;
store rates 0 103; store rates 1 107; store rates 2 111
    """,
)
