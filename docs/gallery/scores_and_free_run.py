"""How well do the models follow a log they have not seen? Scores as a table, free runs as curves."""

import sys

import matplotlib.pyplot as plt

import debist

run = debist.open_run(sys.argv[1] if len(sys.argv) > 1 else "runs/demo")
scores = run.scores()
log = run.logs[-1]
of_q = scores[(scores.log == log) & (scores.signal == "q")]
print((100 * of_q.set_index("model").nrmse).round(2).rename("NRMSE of q in %"))

fig, ax = plt.subplots(figsize=(8, 3.2), layout="constrained")
measured = run.log(log)
ax.plot(measured.t_s, 1e3 * measured.q_m, color="0.75", linewidth=3, label="measured")
for model in run.models[:2]:
    free = run.simulate(model, log)
    ax.plot(free.t_s, 1e3 * free.q_m, linewidth=1, label=model)
ax.set(xlabel="t in s", ylabel="q in mm", title=f"{run.name}: free runs over {log}")
ax.legend(ncols=3, loc="upper right")
fig.savefig("scores_and_free_run.svg")
