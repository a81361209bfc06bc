"""Instruments of a log, measured by a fitted model: Rao's score test, then Gauss–Newton steps.

A fitted model, coupled to a log by an observer, leaves a residual r that is small and nearly linear in three unknowns.
These are δ, corrections of this log's readings; c, corrections that all logs need alike; and η, deviations of the
fitted parameters in units of their posterior. The logs i that the model was fitted to, and the log itself, leave

    rᵢ + Jᵢ c + Aᵢ η = eᵢ,    r + J (δ + c) + A η = e.

Least squares with the prior η ~ N(0, 1) give δ. J are derivatives of the residual by corrections, and A = (∂r/∂θ) S
those by parameters with the posterior covariance S Sᵀ. So δ is the difference of two readings: a model that errs alike
on all logs gives them no different instruments.

The derivatives at δ = 0 give the score test (Rao 1948, doi:10.1017/S0305004100023987; as a monitor of systems
Benveniste, Basseville and Moustakides 1987, doi:10.1109/TAC.1987.1104683). Far from zero a single step falls short, so
steps are repeated until they are small.

Errors e are serially correlated and partly the model's own. The standard error of δ is what groups of them in a row
show (jackknife, `pipeline.fitting.posterior.robust_spread`). The spread of several training logs among themselves is
added. Exchanged inputs and a mirrored q are discrete, so each is tried.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Literal, Protocol, runtime_checkable

import numpy as np
import scipy.linalg
from scipy.special import ndtr, stdtrit

from ..fitting.descent import ObservedProblem, Prior
from ..fitting.posterior import GROUPS, robust_spread, whiteness
from ..numerics.arrays import FloatArray
from ..numerics.metrics import rms
from ..signals.log import MOST_SAMPLES, Corrections, Log, corrected, exchanged, mirrored, within
from ..signals.noise import noise_std

SIGNIFICANCE = 4.0
"""Standard errors beyond which an error counts: one false alarm in 16,000 quantities of normal errors."""

LIMITS = {"gain": 5e-3, "zero_q": 5e-4, "gain_q": 5e-3, "delay": 0.05, "clock": 3e-3}
"""Errors below these are of no practical interest, and one-sided differences take them as steps. High-voltage probes
and lasers are calibrated to 0.5 %; a good laser is linear to 0.05 % of its range (here: the range of q); a twentieth of
the sample interval is less than the filter before the sampler leaves uncertain; a clock 0.3 % off is defective."""

FARTHEST = 150.0
"""Limits beyond which no correction goes: inputs off by 75 %, a delay of eight sample intervals."""

STEPS = 10
STILL = 0.1
"""Gauss–Newton steps at most, and the standard errors below which a step is the last."""

EXPLAINED = 1.0 / 3.0
"""Share of the residual below which exchanged inputs or a mirrored q explain it."""

Exchange = Literal["none", "inputs", "sign", "both"]
Status = Literal["measured", "not measured", "another device"]


@runtime_checkable
class ObservedModel(Protocol):
    """A fitted model that an observer couples to logs."""

    @property
    def theta(self) -> FloatArray:
        """Parameters, shape (P,)."""

    @property
    def spread(self) -> FloatArray:
        """Factor S of their posterior covariance S Sᵀ, shape (P, R)."""

    @property
    def coupling(self) -> float:
        """Observer gain at which a sample stands nearly alone, in the unit that the problem takes."""

    def observed(self, parts: Sequence[Log]) -> ObservedProblem:
        """The model coupled to the parts of a log."""


@dataclass(frozen=True)
class Linearised:
    """A log near its present corrections: r of shape (N,), J of shape (N, K) per limit, and A of shape (N, R)."""

    residual: FloatArray
    by_corrections: FloatArray
    by_parameters: FloatArray


@dataclass(frozen=True)
class Reading:
    """Instruments of one log.

    Attributes
    ----------
    status : {"measured", "not measured", "another device"}
        Not measured where no run follows the log, where the steps do not converge, or where no quantity is known to
        within `SIGNIFICANCE` limits. Nor where a training log leaves another residual than the others.
    exchange : {"none", "inputs", "sign", "both"}
        What had to be exchanged first.
    corrections : Corrections
        What makes the readings true.
    estimate, standard_error : FloatArray, shape (K,)
        Errors of the readings, in the order of `quantities`: reading over truth minus 1 for gains and the clock,
        reading minus truth for the zero. A positive delay is that of the recorded inputs. NaN where not measured.
    residual_ratio : float
        What no instrument explains over the same of the training logs, noise taken off.
    unlike : float
        How sure that ratio is not 1: beyond 1 or −1, surely.
    """

    status: Status
    exchange: Exchange
    corrections: Corrections
    estimate: FloatArray
    standard_error: FloatArray
    residual_ratio: float
    unlike: float


def quantities(parts: Sequence[Log]) -> dict[str, float]:
    """Limits of practical interest [1, m, rad or s] by error that is measured, for a log's range of q and interval."""
    scales = {
        "zero_q": float(np.ptp(np.concatenate([part.known_q for part in parts]))),
        "delay": parts[0].interval,
    }
    return {f"gain_v{k}": LIMITS["gain"] for k in range(1, parts[0].v.shape[1] + 1)} | {
        name: limit * scales.get(name, 1.0) for name, limit in LIMITS.items() if name != "gain"
    }


class InstrumentTest:
    """Instruments of logs by one model.

    Parameters
    ----------
    model : ObservedModel
        The fitted model.
    training : sequence of sequence of Log
        The parts of each training log.

    Notes
    -----
    Cost of a log with K quantities: one Jacobian and K runs for each step; two steps are usual.
    """

    def __init__(self, model: ObservedModel, training: Sequence[Sequence[Log]]) -> None:
        self._model = model
        self._logs = [within(parts, MOST_SAMPLES) for parts in training]
        self.quantities = quantities([part for parts in training for part in parts])
        self._limits = np.array([*self.quantities.values()])
        self._training = [self._linearised(parts, np.zeros(len(self._limits))) for parts in self._logs]

    @cached_property
    def of_training(self) -> list[Reading]:
        """Errors of each of several training logs, compared with the others.

        The model was fitted to all of them, so unlike residuals show its own errors, which then hide the instruments.
        """
        return [
            self._reading(
                log, self._training[:number] + self._training[number + 1 :], np.zeros(len(self._limits)), fitted=True
            )
            for number, log in enumerate(self._logs)
        ]

    @cached_property
    def _between(self) -> FloatArray:
        """Standard deviation [limits] of a log's corrections that no errors within the log show, shape (K,).

        A model errs otherwise under other inputs, so honest logs read differently. The variance between logs is the
        variance among the training logs, less their standard errors (the method of moments of DerSimonian and Laird
        1986, doi:10.1016/0197-2456(86)90046-2). Of n logs each was compared with the mean of the others, a new one is
        compared with that of all: factors 1 − 1/n and 1 + 1/n.
        """
        count = len(self._logs)
        measured = [reading for reading in self.of_training if reading.status == "measured"] if count > 1 else []
        if not measured:
            return np.zeros(len(self._limits))
        excess = [reading.estimate**2 - reading.standard_error**2 for reading in measured]
        variance = np.maximum(np.mean(excess, axis=0), 0.0) * (1.0 - 1.0 / count)
        return np.asarray(np.sqrt(variance * (1.0 + 1.0 / count)) / self._limits)

    def of(self, parts: Sequence[Log]) -> Reading:
        """Errors of the parts of another log, compared with the training logs."""
        return self._reading(within(parts, MOST_SAMPLES), self._training, self._between)

    def _reading(
        self, parts: Sequence[Log], others: Sequence[Linearised | None], between: FloatArray, *, fitted: bool = False
    ) -> Reading:
        """Errors of a log.

        Parameters
        ----------
        parts : sequence of Log
            The log.
        others : sequence of Linearised or None
            The logs that it is compared with.
        between : FloatArray, shape (K,)
            Standard deviation [limits] of its corrections beside what its own errors show.
        fitted : bool
            The model was fitted to it, so it is of no other device.
        """
        exchange, parts = self._as_trained(parts)
        reference = [each for each in others if each is not None]
        delta = np.zeros(len(self._limits))
        log = self._linearised(parts, delta)
        for _ in range(STEPS):
            if log is None or not reference:
                return self._not_measured(exchange)
            fit = _fitted(reference, log)
            delta = np.clip(delta + fit.step, -FARTHEST, FARTHEST)
            if np.all(np.abs(fit.step) < STILL * fit.error):
                break
            log = self._linearised(parts, delta)
        alike = fit.size <= 1.0 or (abs(fit.unlike) if fitted else fit.unlike) <= 1.0
        astray = np.any(np.abs(delta) >= FARTHEST) or np.any(np.abs(fit.step) > fit.error)
        errors = np.hypot(between, np.sqrt(np.sum(fit.spread()[: len(delta)] ** 2, axis=1)))
        unknown = np.all(errors > SIGNIFICANCE)  # no quantity is known to some limits: the model errs, as it shows
        if (alike and (astray or unknown)) or (fitted and not alike):
            return self._not_measured(exchange)
        ahead, behind = (self._errors(delta + side * errors) for side in (1.0, -1.0))
        return Reading(
            status="measured" if alike else "another device",
            exchange=exchange,
            corrections=_corrections(delta * self._limits),
            estimate=self._errors(delta),
            standard_error=0.5 * np.abs(ahead - behind),
            residual_ratio=fit.residual_ratio,
            unlike=fit.unlike,
        )

    def _not_measured(self, exchange: Exchange) -> Reading:
        nothing = np.full(len(self._limits), np.nan)
        return Reading(
            status="not measured",
            exchange=exchange,
            corrections=_corrections(0.0 * self._limits),
            estimate=nothing,
            standard_error=nothing,
            residual_ratio=np.nan,
            unlike=np.nan,
        )

    def _errors(self, delta: FloatArray) -> FloatArray:
        by = _corrections(delta * self._limits)
        gains = (1.0 / gain - 1.0 for gain in by.gains)
        return np.array([*gains, -by.zero / by.gain_q, 1.0 / by.gain_q - 1.0, -by.delay, 1.0 / by.clock - 1.0])

    def _as_trained(self, parts: Sequence[Log]) -> tuple[Exchange, Sequence[Log]]:
        """The exchange of channels that makes the log like the training logs, and the log after that exchange."""
        trials: dict[Exchange, Sequence[Log]] = {"none": parts, "sign": [mirrored(each) for each in parts]}
        if parts[0].v.shape[1] > 1:
            trials["inputs"] = [exchanged(each) for each in parts]
            trials["both"] = [exchanged(each) for each in trials["sign"]]
        residuals = {name: self._residual(trial, np.zeros(len(self._limits))) for name, trial in trials.items()}
        left = {name: np.inf if residual is None else rms(residual) for name, residual in residuals.items()}
        best = min(left, key=lambda name: left[name])
        chosen = best if left[best] < EXPLAINED * left["none"] else "none"
        return chosen, trials[chosen]

    def _linearised(self, parts: Sequence[Log], delta: FloatArray) -> Linearised | None:
        """A log near δ [limits]; None where a run fails."""
        moved = [self._residual(parts, delta + unit) for unit in np.eye(len(delta))]
        if any(run is None for run in moved):
            return None
        problem, gain, scale = self._problem(parts, delta)
        residual, by_theta = (scale * each for each in problem.jacobian(self._model.theta, gain))
        by_parameters = by_theta @ self._model.spread
        finite = np.isfinite(residual).all() and np.isfinite(by_parameters).all()
        return Linearised(residual, (np.array(moved) - residual).T, by_parameters) if finite else None

    def _residual(self, parts: Sequence[Log], delta: FloatArray) -> FloatArray | None:
        problem, gain, scale = self._problem(parts, delta)
        residual = problem.residual(self._model.theta, gain)
        return None if residual is None else scale * residual

    def _problem(self, parts: Sequence[Log], delta: FloatArray) -> tuple[ObservedProblem, float, float]:
        """The corrected log with the model, the observer gain, and the factor from its residuals to those of the raw q.

        The gain is by the log's own clock, as samples are compared from some of its time constants after a gap on. The
        noise is that of the raw reading: else a gain of zero would leave nothing of a linear device.
        """
        by = _corrections(delta * self._limits)
        problem = self._model.observed([corrected(part, by) for part in parts])
        return problem, self._model.coupling / by.clock, 1.0 / by.gain_q


def _corrections(delta: FloatArray) -> Corrections:
    *gains, zero, gain_q, delay, clock = delta.tolist()
    return Corrections(tuple(1.0 + gain for gain in gains), zero, 1.0 + gain_q, delay, 1.0 + clock)


@dataclass(frozen=True)
class _Fitted:
    """Least squares of a log and its reference.

    Attributes
    ----------
    step, error : FloatArray, shape (K,)
        Change of δ [limits], and its standard error if errors were noise.
    size : float
        RMS of the errors of the log, over that which instruments cause at their limits.
    residual_ratio, unlike : float
        See `Reading`.
    spread : callable
        Gives the factor of the covariance of δ, and of all else, as groups of errors show it, shape (P, …).
    """

    step: FloatArray
    error: FloatArray
    size: float
    residual_ratio: float
    unlike: float
    spread: Callable[[], FloatArray]


def _fitted(reference: Sequence[Linearised], log: Linearised) -> _Fitted:
    """δ, c and η of the module's equations.

    The reference logs are fitted by themselves first. What that leaves of them is their noise, and what the log is
    compared with: a log of another device would draw η along and hide in their errors.
    """
    count = log.by_corrections.shape[1]
    residuals = [each.residual for each in reference]
    shared = [np.hstack([each.by_corrections, each.by_parameters]) for each in reference]
    widths = np.append(np.full(count, FARTHEST), np.ones(log.by_parameters.shape[1]))
    _, _, errors_alone, noise_alone = _least_squares(residuals, shared, widths, [None] * len(reference))
    designs = [np.hstack([np.zeros((len(each), count)), each]) for each in shared]
    designs.append(np.hstack([log.by_corrections, log.by_corrections, log.by_parameters]))
    widths = np.append(np.full(count, FARTHEST), widths)
    solution, covariance, errors, noise = _least_squares(
        [*residuals, log.residual], designs, widths, [*noise_alone, None]
    )
    rows = np.split(np.arange(sum(map(len, errors))), np.cumsum([len(error) for error in errors[:-1]]))
    residual_ratio, unlike = _compared(errors_alone, errors[-1])
    # What all instruments cause at their limits, if they err independently: a smaller residual does not matter.
    reach = float(np.sqrt(np.sum(np.mean(log.by_corrections**2, axis=0))))
    return _Fitted(
        step=solution[:count],
        error=np.sqrt(np.diag(covariance[:count, :count])),
        size=rms(errors[-1]) / reach,
        residual_ratio=residual_ratio,
        unlike=unlike,
        spread=partial(
            robust_spread,
            np.concatenate([error / std for error, std in zip(errors, noise, strict=True)]),
            np.concatenate([design / std for design, std in zip(designs, noise, strict=True)]),
            1.0,
            Prior(np.diag(1.0 / widths), np.zeros(len(widths))),
            [group for of_log in rows for group in np.array_split(of_log, GROUPS)],
        ),
    )


def _least_squares(
    residuals: Sequence[FloatArray], designs: Sequence[FloatArray], widths: FloatArray, known: Sequence[float | None]
) -> tuple[FloatArray, FloatArray, list[FloatArray], list[float]]:
    """Least squares of r + D x = e over logs with the prior x ~ N(0, widths²), in two passes.

    Where the noise of a log is not known it is first that of r, then that of e. Errors that last for τ samples count
    as noise of √τ times their RMS.

    Parameters
    ----------
    residuals, designs : sequence of FloatArray, shapes (N,) and (N, P)
        r and D of each log.
    widths : FloatArray, shape (P,)
        Standard deviations of the prior.
    known : sequence of float or None
        Noise of each log, in the unit of r.

    Returns
    -------
    solution, covariance : FloatArray, shapes (P,) and (P, P)
    errors : list of FloatArray, shape (N,)
        Of each log.
    noise : list of float
        Of each log.
    """
    noise = [rms(residual) if std is None else std for std, residual in zip(known, residuals, strict=True)]
    for _ in range(2):
        precision = np.diag(widths**-2.0)
        slope = np.zeros(len(widths))
        for residual, design, std in zip(residuals, designs, noise, strict=True):
            precision += design.T @ design / std**2
            slope += design.T @ residual / std**2
        factor = scipy.linalg.cho_factor(precision)
        solution = -scipy.linalg.cho_solve(factor, slope)
        errors = [residual + design @ solution for residual, design in zip(residuals, designs, strict=True)]
        noise = [
            rms(error) * np.sqrt(whiteness(error).integrated_correlation_time) if std is None else std
            for std, error in zip(known, errors, strict=True)
        ]
    return solution, scipy.linalg.cho_solve(factor, np.eye(len(widths))), errors, noise


def _compared(reference: Sequence[FloatArray], error: FloatArray) -> tuple[float, float]:
    """The size of an error over that of the reference, and the confidence that they differ; see `Reading`.

    Welch's t test (1947, doi:10.1093/biomet/34.1-2.28) at `SIGNIFICANCE`, of the logarithms of mean squares of groups:
    errors of a model are large at some places, and groups show their scatter. White noise is subtracted. Its square is
    known to √(2/N) from N samples; mean squares below `SIGNIFICANCE` times the largest such uncertainty are raised to
    that.
    """
    errors = [*reference, error]
    noise = [noise_std(each) ** 2 for each in errors]
    unseen = [white * np.sqrt(2.0 * GROUPS / len(each)) for each, white in zip(errors, noise, strict=True)]
    squares = [
        np.maximum([rms(group) ** 2 - white for group in np.array_split(each, GROUPS)], SIGNIFICANCE * max(unseen))
        for each, white in zip(errors, noise, strict=True)
    ]
    levels = [np.log(each) for each in squares]
    doubts = [(doubt / each) ** 2 for doubt, each in zip(unseen, squares, strict=True)]
    both = ((levels[-1], doubts[-1]), (np.concatenate(levels[:-1]), np.concatenate(doubts[:-1])))
    shares = [(level.var(ddof=1) + doubt.mean()) / level.size for level, doubt in both]
    difference = float(levels[-1].mean() - np.mean(levels[:-1]))
    freedom = sum(shares) ** 2 / sum(
        share**2 / (len(level) - 1) for share, (level, _) in zip(shares, both, strict=True)
    )
    critical = stdtrit(freedom, ndtr(SIGNIFICANCE)) * np.sqrt(sum(shares))
    return float(np.exp(0.5 * difference)), difference / float(critical)
