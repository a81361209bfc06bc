"""Estimation that several models share: arrays and problems in, estimates out.

    minimise over θ   |r(θ)|²/(2 s²) + ½ |R θ − ρ|²

r is the error of the simulated displacement at all samples of the training logs, s the noise level, which is
estimated beside θ, and R θ = ρ the Gaussian prior (`descent.Prior`).

A free run of a bistable joint has no useful gradient: one passage near the barrier decides all that follows. So an
observer couples the simulation to the measurement, ẋ = p + 2λ (x_m − x), ṗ = … + λ² (x_m − x). With a large gain λ
the problem is nearly convex. `homotopy` fits along falling gains, each from the result before, down to λ = 0, the
free run.

- `descent`: Levenberg-Marquardt steps (Marquardt 1963, doi:10.1137/0111030), one or several dampings at a time.
- `homotopy`: the levels of the observer, and the checks that a level has not lost its log.
- `posterior`: whiteness of the residual, covariance of θ, repeatable draws, and the bands of the curves.
- `regression`: radial basis functions and regressor of the paper (eqs. 34 to 40), least squares by pseudo-inverse.
- `information`: of a motion on the weights, visits per basis centre, and the share of another log outside the data.
- `excitation`: what a log excites, and findings for the report.
- `population`: normal distribution of a parameter vector over many devices.
"""
