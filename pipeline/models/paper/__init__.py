"""The paper's model to the letter (§4.2): `rbf-paper`.

    m q̈ = −c(q) q − d(q) z + Σ_k g_k(q) u_k      (eqs. 37 to 40; u_k = v_k², or v_k if linear)
    ż = (q̇ − z)/T_z                              (eq. 37: friction follows the velocity with a lag)
    c, d, g_k = Σ_i θ_i φ_i(q)                    with M weights each
    φ_i(q) = exp(−(q − ξ_i)²/(2 σ²)),  σ = σ_n Δξ (eqs. 38 and 39; centres ξ_i equidistant over the training data)

Eq. 37 prints ½ g v². Because g = ½ ∂C/∂q holds the ½ already (eqs. 33 and 40), the factor stands once here. Eq. 35
prints the Gaussian without the minus sign that a bell needs; eq. 38 has it.

**Estimation.** For a given T_z all (2 + K) M weights follow from linear least squares on the measured acceleration,
by a QR factorisation in blocks of rows and a pseudo-inverse. T_z is found by descent along the gradient of the
projected cost in ln T_z (variable projection, Golub & Pereyra 1973, doi:10.1137/0710036). The file of the model holds
T_z, cost, rank and condition number of each accepted step. The friction state starts anew, z = q̇, in every gap-free
segment.

**Known limits.** The Gaussians vanish outside the training data, so no force restores the joint there. A fit of
accelerations does not see that a small error of force near the barrier sends a free run into the wrong well.

- `model`: the model, its estimation, its free run by Runge-Kutta steps on the generated rates, and its file.
- `estimation`: the descent on T_z, and the weights by recursive least squares over a stream of samples (§4.1), for
  studies.
"""
