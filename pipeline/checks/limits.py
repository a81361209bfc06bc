"""Every limit of the checks, with its reason; measured ranges are those of twenty honest pairs of logs (docs)."""

MOST_DELAY = 2.5
"""Sample intervals between an input and the answer of q. Drives, probes, sensors and the creep of the membranes shift
it by up to 1.3 intervals in honest logs; two recorders that start one after the other by far more."""

SIGN_CERTAINTY = 4.0
"""Standard errors by which a push must differ from zero before its sign is judged."""

MOST_MISFIT = 1.6
"""Residual of one log under the weights of another over its own. Same joint: up to 1.2; another joint: from 2 on."""

MOST_RATIO = 30.0
"""Factor to either side of the drawing's ring-down and coupling: half way, in powers of ten, to the 1,000 of a wrong
prefix. A joint built n times as large rings n times slower and couples as strongly (capacitance grows as length)."""

UNSTATED_RATIO = 1000.0
"""The same factor for the coupling where no mass is stated and that of the drawing is taken."""

NOTED_RATIO = 5.0
"""Factor beyond which the same numbers are shown as remarkable."""

DRAWN_RING_DOWN = 2.8
"""Hz, of the joint as drawn (parameter set `nominal`) in its wells without voltage."""

DRAWN_COUPLING = 8.5e-9
"""N/V², half the slope of a membrane's capacitance over q, of the joint as drawn."""

LEAST_PER_PERIOD = 8.0
"""Uniform samples in a period of the ring-down: with fewer, the accelerations between them are not seen."""

MOST_RESOLUTION = 0.01
"""Step of the converter, in ranges of q: beyond, velocities come in steps of a few per cent."""

DRAWN_MASS = 0.04
"""kg, moving mass of the joint as drawn."""
