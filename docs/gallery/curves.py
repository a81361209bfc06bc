"""What did the model learn? Restoring force and damping with what the data leave open, drawn from the posterior."""

import sys

import matplotlib.pyplot as plt
import numpy as np

import debist

run = debist.open_run(sys.argv[1] if len(sys.argv) > 1 else "runs/demo")
log = run.log(run.logs[0])
q = np.linspace(log.q_m.min(), log.q_m.max(), 121)

fig, axes = plt.subplots(1, 2, figsize=(8, 3.2), layout="constrained")
for name in run.models[:2]:
    model = run.model(name).core
    curves, drawn = model.curves(q), model.curve_ensemble(q, 48)
    for ax, curve, factor in zip(axes, ("F", "d"), (1e3, 1.0), strict=True):
        line = ax.plot(1e3 * q, factor * curves[curve], label=name)[0]
        low, high = factor * np.quantile(drawn[curve], [0.05, 0.95], axis=0)
        ax.fill_between(1e3 * q, low, high, color=line.get_color(), alpha=0.2, linewidth=0)
    crossings = np.flatnonzero(np.diff(np.sign(curves["F"])))
    print(f"{name}: rests or tips over near {', '.join(f'{1e3 * q[i]:.1f}' for i in crossings)} mm")
axes[0].set(xlabel="q in mm", ylabel="F in mN", title="restoring force")
axes[1].set(xlabel="q in mm", ylabel="d in N·s/m", title="damping")
axes[0].axhline(0.0, color="0.7", linewidth=0.8, zorder=0)
axes[0].legend()
fig.savefig("curves.svg")
