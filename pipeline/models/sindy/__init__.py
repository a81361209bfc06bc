"""SINDy: `sindy` and `sindy-default`, a sparse polynomial equation (Brunton et al. 2016, doi:10.1073/pnas.1517384113).

    q̈ = Σ_p c_p θ_p(q, q̇, z, u),   ż_i = (x_i − z_i)/T_i

θ_p are monomials of scaled variables, z_i lags of velocity or inputs, u_k = v_k² or v_k. Most coefficients c_p are
zero.

**Estimation.** `sindy-default` is pysindy as it comes: default library, optimiser and differentiation. `sindy` uses
pysindy's library and its estimator STLSQ in weak form: both sides are multiplied by test functions and integrated, so
no second derivative of the measurement enters (Messenger & Bortz 2021, doi:10.1137/20M1343166). Library and threshold
are those with the least error of free runs on held-out blocks of the training logs, within a time limit. The chosen
equation is then fitted to all training data.

- `model`: both models, their printed equations and their file.
- `fit`: the choice by held-out free runs, and pysindy's defaults.
- `weak_form`: rows of the weak form for every candidate term and every held-out block.

`pipeline.models.polynomial_dynamics` simulates the equation.
"""
