"""Every limit of the checks with its reason; measured ranges are those of twenty honest pairs of logs (docs)."""

from pipeline.device_parameters import NOMINAL

MOST_DELAY = 2.5
"""Sample intervals between an input and the answer of q. Drives, probes, sensors and the creep of the membranes shift
it by up to 1.3 intervals in honest logs; two recorders that start one after the other by far more."""

NOTED_DELAY = 1.4
"""The same from which on it is shown as remarkable."""

ABRUPT = 0.63
"""Change of an input's rate over the change of the input itself, both over 25 ms of its averages, above which its delay
is judged. On 9 joints triangles and half-sines up to 2 Hz have at most 0.5, excitations of the rig 0.87 and more."""

TURN, WRAPPED = 0.7, (0.9, 1.1)
"""Share of the range of an angle that it runs through within three samples where it wraps, and that range in turns: one
that is kept within a turn jumps from end to end."""

MOST_CORRELATED = 0.999
"""Correlation of the two inputs, as they act, from which on they are one."""

SIGN_CERTAINTY = 4.0
"""Standard errors by which a push must differ from zero before its sign is judged."""

HARDLY = 0.8
"""Of the RMS acceleration of a log: an input that surely pushes by less hardly moves the device. Of 51 inputs whose
push 60 honest logs leave unsure none is below 0.9; of 188 inputs of another log 150 are."""

MOST_MISFIT = 1.6
"""Residual of one log under the weights of another over its own. Same joint: up to 1.2, of 80 two at 1.7 and 1.8."""

SURELY_MISFIT = 2.0
"""From here on it is another joint, of which the least had 2.05; in between the check asks to look."""

MOST_COST, SURE_COST = 1.1, 1.3
"""What weights in common leave of two logs over what their own leave: up to the first they are of one joint, whatever
the misfit, beyond the second they are not. Of 64 honest pairs one is beyond 1.3, with a misfit of 1.2; a log that
mostly rests has had a misfit of 2.4 at 1.2. Of 37 pairs of two joints three are below 1.1."""

ALIKE = 1.5
"""Factor between the largest voltages of two logs up to which they can be of one device for sure or not: a joint driven
at 35 % of the voltage, or by one side only, has had 2.4 to 5.7 times the misfit of its training log."""

GAIN_OF_ALL, GAIN_OF_ONE = (0.032, 3.0), (0.08, 4.0)
"""Least deviation, and standard errors, from which the gain of a log's inputs is off: of all of them together, or of
one. Of 45 honest pairs with any excitation one is off by more; of as many with probes 10 % off, 28 are."""

WRONG_GAIN = 0.25
"""Deviation from which on a log's voltages are refused: forces go with their square."""

GAIN_OF_OTHER = 1.6
"""Factor from which on, to either side, the gain of a device that is no joint is shown. What such an input does depends
on hidden states, so on the excitation: of 93 honest pairs of 31 simulated devices, 18 are surely off by 4 to 44 %. A
gain of 2 reads as 1.76 to 2.36, one of 10 as 7.4 to 12.3."""

OTHER_LEVEL, BIAS = 0.005, 0.04
"""Share of an input's largest magnitude by which its levels at rest may differ between logs, and from which on the
drive itself may have been biased. Rests of 13 joints differ by less than 0.3 V at 3 kV; 0.5 % is 1 % of the force."""

OTHER_ZERO, SURE_ZERO, WRONG_ZERO = 0.025, 2.5, 0.05
"""Standard deviations of q, and standard errors, from which the zero of q is off; from where it is refused. Of honest
pairs of logs of 13 joints it is off by up to 0.015; refused only where four standard errors are sure of it too."""

OF_LAG = 2.0
"""Times a lag that some log of the device shows, up to which an input that acts late is explained by it."""

SURE_INTERVAL = 0.6
"""Sample intervals that a log's own step must be shorter than for that: with fewer samples under a bump, the weak form
itself is off. Of one device at 1 kHz and 160 Hz the ratio was 7, at 200 Hz and more below 0.5."""

MOST_UNEXPLAINED = 0.3
"""Share of the accelerations that a log's own weights may leave for that: where hidden states leave more (multisines
leave 0.33 of a link chain's), two excitations of one joint have had a misfit of 3.6."""

MOST_TOGETHER = 0.5
"""Share of the accelerations that weights in common may leave of either log of a device that is no joint. A log of one
tone determines weights of its own badly: of one simulated film with lag and creep the misfit was up to 58, and this
share 0.23 to 0.44. A mass seven times as large leaves 0.8 where the law is that of the device."""

SURE_LENGTH = 1000.0
"""Sample intervals (10 s) that both logs must last before they are of two devices. Of twenty pairs of logs of one
joint, cut to their first 6 s, two had 2.4 and 2.7 (sixty bumps determine fourteen weights there); cut to 10 s the most
was 1.7."""

MOST_RATIO = 30.0
"""Factor to either side of the drawing's ring-down and coupling: half way, in powers of ten, to the 1,000 of a wrong
prefix. A joint built n times as large rings n times slower and couples as strongly (capacitance grows as length)."""

UNSTATED_RATIO = 1e5
"""The same factor for the coupling where no mass is stated and that of the drawing is taken: a joint of 1 mm and 100 V
is 1,800 times off; kV read as V make 10⁶."""

OTHER_CLOCK = 1.0
"""Sample intervals by which q may answer later or earlier than in the first log: of 64 honest inputs of four joints,
each in a pair of logs, the delays differ by up to 0.6."""

MOST_SIDES, NOTED_SIDES = 10.0, 2.5
"""Factor between the couplings of the two sides that stops, and that is shown. Membranes are cut from one film: 0.65 to
1.4 in 66 logs of 15 joints. The square of a wrong probe ratio is in it, 4 for twice the voltage."""

MOST_OF_FIELD = 1.02
"""Share of the field limit from which on a log is above it: noise and probes make 1.01 of a command of 1."""

FILMS, FIELDS = (1e-6, 3e-3), (1e6, 1e9)
"""Thickness of elastomer films [m], spun or as the thickest tape, and the fields [V/m] that such films stand."""

REST_LEVEL = 0.02
"""Share of an input's largest magnitude above which the level at which it rests is shown."""

OTHER_LAW = 0.7
"""Times what the weak form leaves of the accelerations, below which the other law of the inputs is shown."""

OTHER_LAW_OF_ONE_SIGN = 0.93
"""The same for inputs of one sign, between whose laws only pulses of several heights tell. Declared rightly, logs of
16 devices have 0.99 to 1.5; joints declared "linear" have 0.64 to 0.92 in two of three, P1 to P3 0.73 to 0.89."""

SEVERAL_HEIGHTS = 0.1
"""Standard deviation of the square of an input that a line through the input leaves, over that of the square, from
which on its laws can be told apart. Inputs of one height have up to 0.07, of several mostly 0.11 and more."""

DRAWN_RING_DOWN = 2.8
"""Hz, of the joint as drawn (parameter set `nominal`) in its wells without voltage."""

DRAWN_COUPLING = 8.5e-9
"""N/V², half the slope of a membrane's capacitance over q, of the joint as drawn."""

UNDRIVEN_SNAPS = 2
"""Crossings of the barrier without any input from which on a row says so: the logs of P1 to P3 have none, and 2 to 7
where one of their voltages is left out."""

UNDRIVEN_STARTS, MOST_PLACES = 2, 3
"""Starts from rest without a change of an input, over all logs, from which on they are reported, and how many places.
No log of 16 prototypes has one; P1 to P3 have 2 to 5 in each log where one of their voltages is left out."""

LEAST_PER_PERIOD = 8.0
"""Uniform samples in a period of the ring-down: with fewer, the accelerations between them are not seen."""

MOST_RESOLUTION = 0.01
"""Step of the converter, in ranges of q: beyond, velocities come in steps of a few per cent."""

LENGTH_ERRORS = ((5.0, 2.24), (10.0, 1.48), (20.0, 0.83), (37.5, 0.39))
"""Length of a training log [s], and median error of `hybrid` on another log after it [% of the range]: simulated joints
of three physics (docs/measured/hybrid.md)."""

DRAWN_MASS = NOMINAL.m
"""kg, moving mass of the joint as drawn."""
