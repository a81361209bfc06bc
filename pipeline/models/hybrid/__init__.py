"""The condensed joint: `hybrid`, the analytical model in slow coordinates with RBF corrections.

The full model (eq. 19) has stiff shape modes of almost no inertia. Here the beam is w(x) = l W(x/l) with

    W = Q h1 + τ h2 + β h3,   h1 = 3ξ² − 2ξ³,   h2 = ξ³ − ξ²,   h3 = ξ²(1 − ξ)²

the polynomials of eq. 13 in other coordinates: Q = q/l is the displacement of the tip, τ its slope, β an interior
shape mode. The motion follows from the energies of section 3:

    M(y) ÿ = −∂U/∂y − ∂R/∂ẏ + ½ Σ_k ∂C_k/∂y u_k − friction(q) + corrections,   y = (q, τ, β)
    ė_ik = λ̇_3,i − r_k e_ik                        Maxwell elements of each membrane (eq. 19)
    z_j ← clip(z_j + Δs_j/δ_j, −1, 1)               stop operators: slip of friction; layers of the beam that yield
    ċ_k = r_k (q − c_k)                             creep
    Ḋ = r_s (1 − D)                                 softening: the modulus of both membranes times 1 − s D

Corrections are sums of Gaussians (eq. 38): force, damping and both electrostatic forces in q, and to second order in
the deviation s = τ − ratio Q from the quasi-static slope. They are gradients and dampers, so the joint stays passive.
`pipeline.equations.condensed_joint` has each equation.

**Estimation.** The device's size, speed and sensitivity are read off its logs (`start`), which scales the parameter
set (`log_reading`). θ holds deviations from the scaled set, in units of their prior widths, and the weights of the
corrections. It minimises the error of the displacement along falling observer gains (`pipeline.fitting.homotopy`),
first without corrections, then with them. Held-out data decide whether corrections stay.

- `model`: the identified model, its curves, draws and file. `identify`: the whole identification.
- `start`: first estimate and prior.
- `log_reading`: a log in the units of the set, of an angle, and the voltages that act: delay, lag, square.
- `parameters`: parameter set and deviations → constants of the kernels.
- `problem`: residuals and Jacobians over the training logs.
- `runs`: free and observed runs. `sensitivity`: their exact derivatives.
- `siblings`: other joints of one drawing, as a prior.
- `statics`: equilibrium at a held tip, and characteristic curves. `kernels`: compiled graphs and tables.
"""
