"""Which pulse switches the joint? Free runs under pulses that no log holds, from low to high voltage."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import debist

run = debist.open_run(sys.argv[1] if len(sys.argv) > 1 else "runs/demo")
model, log = run.model(), run.log(run.logs[0])
well = float(log.q_m.iloc[0])  # the joint rests here at the start of its log
side = "v1" if log.v1_V[log.q_m * well < 0].mean() > log.v2_V[log.q_m * well < 0].mean() else "v2"

t = np.arange(0.0, 3.0, 0.01)
shape = 0.5 * (np.tanh((t - 0.5) / 0.01) - np.tanh((t - 1.5) / 0.01))
fig, ax = plt.subplots(figsize=(8, 3.2), layout="constrained")
for peak in np.linspace(0.5, 1.0, 6) * float(log[["v1_V", "v2_V"]].max().max()):
    voltages = {"v1": 0.0 * t, "v2": 0.0 * t} | {side: peak * shape}
    free = model.simulate(t, **voltages, q0=well)
    ax.plot(t, 1e3 * free.q_m, label=f"{1e-3 * peak:.2f} kV")
    print(f"{1e-3 * peak:.2f} kV: {'switches' if free.q_m.iloc[-1] * well < 0 else 'stays'}")
ax.axvspan(0.5, 1.5, color="0.93", zorder=0)
ax.set(xlabel="t in s", ylabel="q in mm", title=f"{run.name}: one-second pulses on {side}")
ax.legend(ncols=1, loc="center left", bbox_to_anchor=(1.0, 0.5))
fig.savefig("switching_pulse.svg")
