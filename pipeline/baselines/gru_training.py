"""Training of the GRU by back-propagation through time, with PyTorch, an optional extra."""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.baselines.gru import GruWeights, gru_run
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray

UNITS = 24
ITERATIONS = 1200
WINDOW = 300  # samples; 3 s at 10 ms, a switch and its ring-down
BATCH = 32
LEARNING_RATE = 5e-3
CHECK_EVERY = 50
CLIP = 1.0  # largest norm of the gradient: a bistable map has exploding ones at its barrier


@dataclass(frozen=True)
class GruSeries:
    """A gap-free stretch, scaled: inputs (N, K) and states [q, q̇] (N, 2)."""

    u: FloatArray
    states: FloatArray


@dataclass(frozen=True)
class GruTraining:
    """The trained network and how training went.

    Attributes
    ----------
    weights : GruWeights
        Those with the lowest held-out error.
    iterations : int
        Gradient steps made.
    best_iteration : int
        The step that `weights` are from.
    held_out_error : float
        RMS of scaled q in free runs over the held-out series.
    seconds : float
        Processor time.
    status : {"completed", "time limit"}
        What ended it.
    """

    weights: GruWeights
    iterations: int
    best_iteration: int
    held_out_error: float
    seconds: float
    status: str


def train_gru(
    training: Sequence[GruSeries],
    held_out: Sequence[GruSeries],
    *,
    units: int = UNITS,
    iterations: int = ITERATIONS,
    time_limit: float = np.inf,
    rng: np.random.Generator,
) -> GruTraining:
    """Minimise the squared error of [q, q̇] in free runs over random windows; keep the best on held-out series.

    Parameters
    ----------
    training, held_out : sequence of GruSeries
        What gradients are taken on, and what decides which weights are kept.
    units : int
        Hidden units H.
    iterations : int
        Gradient steps; Adam, cosine-annealed.
    time_limit : float
        Processor time [s] after which training stops with status "time limit".
    rng : numpy.random.Generator
        Initial weights and windows.

    Raises
    ------
    InputError
        PyTorch is not installed, or no stretch is longer than a window.
    """
    torch = _torch()
    window = min(WINDOW, max(len(s.u) for s in training) - 1)
    long = [s for s in training if len(s.u) > window]
    if window < 10 or not held_out:
        raise InputError("the training stretches are too short for a GRU; give longer logs")
    network = _network(torch, units, training[0].u.shape[1], rng)
    parameters = [*network[0].parameters(), *network[1:]]
    optimizer = torch.optim.Adam(parameters, lr=LEARNING_RATE)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, iterations, eta_min=LEARNING_RATE / 50)
    best, best_error, best_iteration = _weights(*network), np.inf, 0
    begun, done, status = time.process_time(), 0, "completed"
    while done < iterations and status == "completed":
        loss = _loss(torch, *network, _batch(long, window, rng))
        optimizer.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(parameters, CLIP)
        optimizer.step()
        schedule.step()
        done += 1
        if done % CHECK_EVERY == 0 or done == iterations:
            error = _error(_weights(*network), held_out)
            if error < best_error:
                best, best_error, best_iteration = _weights(*network), error, done
            if time.process_time() - begun > time_limit:
                status = "time limit"
    return GruTraining(best, done, best_iteration, best_error, time.process_time() - begun, status)


def _torch() -> Any:
    try:
        import torch
    except ImportError:
        raise InputError("the GRU needs PyTorch, an optional extra: pip install 'debist[gru]'") from None
    return torch


def _network(torch: Any, units: int, inputs: int, rng: np.random.Generator) -> tuple[Any, Any, Any]:
    """The recurrent layer, the encoder and the readout.

    Weights are uniform within ±1/sqrt(H); the update gate starts open at σ(3.5), so that a state is held for about
    30 samples.
    """
    gru = torch.nn.GRU(inputs, units)
    bound = 1.0 / np.sqrt(units)

    def uniform(*shape: int) -> Any:
        return torch.tensor(rng.uniform(-bound, bound, shape), dtype=torch.float32)

    with torch.no_grad():
        for parameter in gru.parameters():
            parameter.copy_(uniform(*parameter.shape))
        gru.bias_ih_l0[units : 2 * units] += 3.5
    return gru, uniform(units, 3).requires_grad_(), uniform(2, units + 1).requires_grad_()


def _weights(gru: Any, encoder: Any, readout: Any) -> GruWeights:
    tensors = (gru.weight_ih_l0, gru.bias_ih_l0, gru.weight_hh_l0, gru.bias_hh_l0, encoder, readout)
    return GruWeights(*(x.detach().numpy().astype(np.float64) for x in tensors))


def _batch(series: Sequence[GruSeries], window: int, rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    lengths = np.array([len(s.u) - window for s in series], dtype=np.float64)
    picks = rng.choice(len(series), size=BATCH, p=lengths / lengths.sum())
    starts = [int(rng.integers(len(series[i].u) - window)) for i in picks]
    rows = [(series[i], slice(k, k + window + 1)) for i, k in zip(picks, starts, strict=True)]
    return np.stack([s.u[r] for s, r in rows], axis=1), np.stack([s.states[r] for s, r in rows], axis=1)


def _loss(torch: Any, gru: Any, encoder: Any, readout: Any, batch: tuple[FloatArray, FloatArray]) -> Any:
    """Mean squared error over windows (T + 1, B, ·), the readout of the encoded first state included."""
    u, states = (torch.tensor(x, dtype=torch.float32) for x in batch)
    start = torch.tanh(states[:1] @ encoder[:, :2].T + encoder[:, 2])
    path, _ = gru(u[1:], start)
    calculated = torch.cat([start, path]) @ readout[:, :-1].T + readout[:, -1]
    return torch.mean((calculated - states) ** 2)


def _error(weights: GruWeights, held_out: Sequence[GruSeries]) -> float:
    squares = [np.square(gru_run(weights, s.u, s.states[0])[:, 0] - s.states[:, 0]) for s in held_out]
    return float(np.sqrt(np.mean(np.concatenate(squares))))
