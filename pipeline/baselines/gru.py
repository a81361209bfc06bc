"""A gated recurrent unit from voltages to displacement: weights, free run, one-step prediction; no torch here."""

from dataclasses import dataclass

import numba
import numpy as np

from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class GruWeights:
    """A GRU of H units with K inputs, an encoder of the initial state and a readout (Cho et al. 2014, arXiv:1406.1078).

    r = σ(W_r u + b_r + V_r h + c_r), z likewise, n = tanh(W_n u + b_n + r∘(V_n h + c_n)), h⁺ = (1 − z)∘n + z∘h,
    h(0) = tanh(E [q, q̇] + e), [q, q̇] = R h + d, all scaled.

    Attributes
    ----------
    input_weights : FloatArray, shape (3H, K)
        W_r, W_z, W_n stacked.
    input_bias : FloatArray, shape (3H,)
    hidden_weights : FloatArray, shape (3H, H)
        V_r, V_z, V_n stacked.
    hidden_bias : FloatArray, shape (3H,)
    encoder : FloatArray, shape (H, 3)
        E and e.
    readout : FloatArray, shape (2, H + 1)
        R and d.
    """

    input_weights: FloatArray
    input_bias: FloatArray
    hidden_weights: FloatArray
    hidden_bias: FloatArray
    encoder: FloatArray
    readout: FloatArray

    @property
    def units(self) -> int:
        """H."""
        return int(self.hidden_weights.shape[1])


@numba.njit(cache=True)
def _step(hidden_weights, hidden_bias, driven, h, fresh):  # type: ignore[no-untyped-def]
    """One update; `driven` is W u + b, shape (3H,); the new state goes to `fresh`."""
    units = h.shape[0]
    for i in range(units):
        reset = driven[i] + hidden_bias[i]
        update = driven[units + i] + hidden_bias[units + i]
        candidate = hidden_bias[2 * units + i]
        for j in range(units):
            reset += hidden_weights[i, j] * h[j]
            update += hidden_weights[units + i, j] * h[j]
            candidate += hidden_weights[2 * units + i, j] * h[j]
        reset = 1.0 / (1.0 + np.exp(-reset))
        update = 1.0 / (1.0 + np.exp(-update))
        fresh[i] = (1.0 - update) * np.tanh(driven[2 * units + i] + reset * candidate) + update * h[i]


@numba.njit(cache=True)
def _hidden_run(hidden_weights, hidden_bias, driven, h0):  # type: ignore[no-untyped-def]
    states = np.empty((driven.shape[0], h0.shape[0]))
    states[0] = h0
    for n in range(1, driven.shape[0]):
        _step(hidden_weights, hidden_bias, driven[n], states[n - 1], states[n])
    return states


def initial_state(weights: GruWeights, state: FloatArray) -> FloatArray:
    """h(0) of scaled [q, q̇], shape (…, 2) → (…, H)."""
    h: FloatArray = np.tanh(state @ weights.encoder[:, :2].T + weights.encoder[:, 2])
    return h


def read_out(weights: GruWeights, h: FloatArray) -> FloatArray:
    """Scaled [q, q̇] of hidden states, shape (…, H) → (…, 2)."""
    values: FloatArray = h @ weights.readout[:, :-1].T + weights.readout[:, -1]
    return values


def gru_run(weights: GruWeights, u: FloatArray, state: FloatArray) -> FloatArray:
    """Scaled [q, q̇] of a free run, shape (N, 2).

    Parameters
    ----------
    weights : GruWeights
        The network.
    u : FloatArray, shape (N, K)
        Scaled inputs; the state at sample n has seen u_1 … u_n.
    state : FloatArray, shape (2,)
        Scaled initial [q, q̇].
        Cost: 3H(H + K) products per sample, about 2 µs for H = 24.
    """
    driven = u @ weights.input_weights.T + weights.input_bias
    states = _hidden_run(weights.hidden_weights, weights.hidden_bias, driven, initial_state(weights, state))
    return read_out(weights, states)


def gru_steps(weights: GruWeights, u: FloatArray, states: FloatArray) -> FloatArray:
    """Scaled change of [q, q̇] over one sample from each measured state, shape (N − 1, 2)."""
    driven = u @ weights.input_weights.T + weights.input_bias
    h = initial_state(weights, states)
    fresh = np.empty_like(h)
    for n in range(len(u) - 1):
        _step(weights.hidden_weights, weights.hidden_bias, driven[n + 1], h[n], fresh[n])
    return read_out(weights, fresh[:-1]) - read_out(weights, h[:-1])
