"""From arrays to a model: clean, identify, simulate, judge and draw, without any file of debist's."""

# --8<-- [start:signals]
import sys

import matplotlib.pyplot as plt
import numpy as np

import debist

run = debist.open_run(sys.argv[1] if len(sys.argv) > 1 else "runs/demo")
signals = run.log(run.logs[0])[["t_s", "q_m", "v1_V", "v2_V"]]  # or pandas.read_csv(…), or single arrays
print(signals.describe().round(4))
# --8<-- [end:signals]

# --8<-- [start:identify]
model = debist.identify(signals, mass=0.0405, parameters="nominal", model="hybrid")
print(model)
print(list(model.describe())[:6])
# --8<-- [end:identify]

# --8<-- [start:score]
unseen = run.log(run.logs[-1])
scores = model.score(unseen)  # as in the report
print(scores[["signal", "fit_percent", "nrmse", "rmse", "unit", "status"]])
ax = model.plot(unseen.t_s, unseen.q_m, unseen.v1_V, unseen.v2_V)
ax.figure.savefig("from_arrays.svg")
# --8<-- [end:score]

# --8<-- [start:simulate]
t = np.arange(0.0, 3.0, 0.01)
v1 = np.where((t > 0.5) & (t < 1.5), 2500.0, 0.0)
free = model.simulate(t, np.column_stack([v1, 0.0 * t]), float(signals.q_m[0]))
print(free.attrs, free.tail(1))
free.plot("t_s", "q_m")
# --8<-- [end:simulate]

# --8<-- [start:curves]
curves = model.curves(np.linspace(signals.q_m.min(), signals.q_m.max(), 101))
curves.plot("q_m", "F_N")
plt.close("all")
# --8<-- [end:curves]

# --8<-- [start:save]
model.save("model.h5")
again = debist.Model.load("model.h5")
print(again, again.export("json", "exported"))
# --8<-- [end:save]

# --8<-- [start:mistake]
try:
    model.simulate(t, np.zeros((50, 2)), 0.01)
except debist.DebistError as error:
    print(error)  # v1 has 50 samples, but t has 300
# --8<-- [end:mistake]
