"""Inputs of a log: where they are known."""

MOST_SAMPLES = 12_000
"""Samples of all logs together that a fit of the joint's equations takes: beyond, every log is cut after as large a
share. It bounds the work, whatever is given: at 10 ms these are 120 s of motion, three logs as the paper's."""

LONGEST_BRIDGE = 10.0
"""Sample intervals without inputs up to which a straight line stands for them."""
UNKNOWN = "inputs_unknown"
"""Key of a record's notes for spans [s] in which the inputs were not recorded for longer."""
