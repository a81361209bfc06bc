"""NARX: `narx`, a polynomial difference equation at the sample interval of the log, as a black box to compare with.

    δ_{n+1} − δ_n = Σ_p c_p θ_p(q_n, δ_n, …, δ_{n−L+1}, u_{n+1}, u_n, …),   δ_n = q_n − q_{n−1}

Written in increments δ the equation spans the same polynomials as q_{n+1} = f(q_n, q_{n−1}, …, u_{n+1}, u_n, …), and
is well conditioned where neighbouring samples are nearly equal. A free run uses its own past displacements.

**Estimation.** Terms are picked by forward selection, the FROLS of the NARMAX literature (Chen, Billings & Luo 1989,
doi:10.1080/00207178908953472), as scikit-learn's `orthogonal_mp_gram`. Degree, number of lags and number of terms are
the simplest within one standard error of the least error of free runs on held-out blocks.

- `equation`: structure, free run, and the fit.
- `model`: the model behind the common interface, and its file.
"""
