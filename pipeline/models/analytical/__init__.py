"""The analytical model (section 3 of the paper): `analytical` and `analytical-calibrated`.

The beam bends as w(x) = q2 x² + q3 x³ + q4 x⁴ (eq. 13) and is compressed by u0, so q_m = [q2, q3, q4, u0]. With e_i
the strain of the Maxwell spring in membrane i the motion is (eq. 19)

    d/dt ∂T/∂q̇_m − ∂T/∂q_m + ∂U/∂q_m + ∂R/∂q̇_m + Σ V Y_MW e_i ∂λ_3,i/∂q_m = ½ Σ ∂C_i/∂q_m v_i² + F ∂q/∂q_m
    ė_i = λ̇_3,i − (Y_MW/η_MW) e_i

and an equilibrium solves ∂U/∂q_m = F ∂q/∂q_m (eq. 15). `pipeline.equations.full_joint` writes only the energies; all
else is derived by automatic differentiation. docs/explanation/analytical-model.md lists corrections to the print.

The reduced model (eqs. 24 to 26) has the tip's displacement alone: the shape follows the static path q_m(q).

**Estimation** (§3.3). `analytical` takes a parameter set as it is. `analytical-calibrated` fits some parameters by
bounded least squares on q over windows of the training logs, each started from the measurement (multiple shooting, H.
G. Bock 1983), with a robust loss and from several starts. Gradients are those of the variational equations.

- `model`: both models behind the common interface.
- `statics`: all equilibria with their stability, and the static path. `bifurcation`: diagrams and switching voltage.
- `full_order`: eqs. 19 to 23 by RODAS4. `reduced_order`: reduction and simulation of eq. 26.
- `windows`: windows of the logs and their errors. `sensitivity`: their derivatives by parameters.
- `calibration`: the calibration, its unknowns, priors, search and covariance.
"""
