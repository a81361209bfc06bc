"""The data-driven joint: `rbf`, identified from logs alone.

In the displacement x, scaled so that ±1 spans the training data, and its velocity p, with K inputs u:

    ẋ = p
    μ(x) ṗ = F(x) − (d(x) + κ |p|) p − ½ μ'(x) p²
             + Σ_k g_k(x) u_k − Σ_l h_l(x) e_l + Σ_lk β_lk'(x) u_k w_l − Σ_j f_j s_j + stops
    ẇ_l = h_l(x) p − r_l(x) e_l,   e_l = w_l − Σ_k β_lk(x) u_k
    ds_j = (dx − |dx| s_j)/δ_j

F is the restoring force: a cubic that confines, and Gaussians (eq. 38). d is the damping, κ a fluid's drag, g_k the
effect of an input (eq. 33), w_l a relaxing element (a Maxwell branch, or a hidden shape of the beam that inputs pull
at), s_j a state of Dahl friction, and μ(x) the inertia of a tip on an arc. A structure (`structure.JointStructure`)
says which terms a joint has. Every coupling h_l stands in both equations, so no element creates energy.

**Estimation.** A convex fit of the acceleration gives the start. Then θ minimises the error of simulated displacement
along falling observer gains, down to the free run (`pipeline.fitting.homotopy`), with exact sensitivities of the
discrete scheme. Candidates of structure are fitted on a part of the training logs and judged on the rest. A bistable
joint has one structure, and the prior of a population of simulated joints.

- `model`: the identified model, its curves, draws, forces and file.
- `identify`: the whole identification, and the structure of a bistable joint by evidence.
- `structure`: terms, scales, and the path of the inputs. `candidates`: structures that are offered.
- `structure_search`: the choice among them on held-out data.
- `parameter_layout`: order of θ, and its way into the coefficients of the equation.
- `dynamics`: the numbers of the equation, the basis of its curves, and the equation.
- `observed_run`: a run of it, with observer and sensitivities.
- `problem`: residuals and Jacobians over the training logs, and the effort of a fit.
- `start`: the convex fit. `prior`: smoothness, symmetry, population, and curves that were measured on a test stand.
"""
