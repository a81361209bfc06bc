"""Every limit of the checks with its reason; measured ranges are those of honest logs (benchmarks/honest_logs.py)."""

SURE = 4.0
"""Standard errors by which a number must differ from zero before its sign is judged."""

LATE = 2.5
"""Sample intervals from which on q answers its inputs late. Drives, probes, sensors and the creep of the membranes
shift it by up to 1.3 intervals in honest logs; two recorders that start one after the other by far more."""

WRAPPED = 0.7
"""Share of the range of an angle of about one turn that it runs through within three samples where it wraps: one that
is kept within a turn jumps from end to end."""

CORRELATED = 0.999
"""Correlation of the two inputs, as they act, from which on they are one."""

RATIO = 30.0
"""Factor to either side of the coupling of the joint as drawn: half way, in powers of ten, to the 1,000 of a wrong
prefix. A joint built n times as large couples as strongly (capacitance grows as length)."""

UNSTATED_RATIO = 1e5
"""The same where no mass is stated and that of the drawing is taken: a joint of 1 mm and 100 V is 1,800 times off; kV
read as V make 10⁶."""

SIDES = 2.5
"""Factor between the couplings of the two sides that is shown. Membranes are cut from one film: 0.65 to 1.4 in 66 logs
of 15 joints. The square of a wrong probe ratio is in it, 4 for twice the voltage."""

FIELD = 1.02
"""Share of the field limit from which on a log is above it: noise and probes make 1.01 of a command of 1."""

REST_LEVEL = 0.02
"""Share of an input's largest magnitude above which the level at which it rests is shown, and within which it rests."""

OTHER_LAW = 0.9
"""Times what the weak form leaves of the accelerations, below which the other law of the inputs is shown. Declared
rightly, logs of 16 devices have 0.99 to 1.5."""

DRAWN_COUPLING = 8.5e-9
"""N/V², half the slope of a membrane's capacitance over q, of the joint as drawn."""

RESOLUTION = 0.01
"""Step of the converter, in ranges of q: beyond, velocities come in steps of a few per cent."""

DRIFT = 0.02
"""Share of the range of q by which its rests move over a log, from which on that is shown, and by which one creeps."""
