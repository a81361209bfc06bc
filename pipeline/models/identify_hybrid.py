"""Identification of the hybrid joint: parameter set → calibrated joint by observer homotopy → RBF corrections."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pipeline.errors import DataRefusedError, InputError
from pipeline.identification.homotopy import HomotopyFit, Level, Prior, fit_homotopy
from pipeline.identification.parallel_descent import ParallelDescent
from pipeline.identification.rbf import basis_centres, basis_width
from pipeline.identification.residuals import whiteness
from pipeline.joint import condensed_parameters
from pipeline.joint.condensed_problem import DEVIATIONS, Body, BodyProblem
from pipeline.joint.parameters import JointParameters
from pipeline.joint.similarity import SAME, Similarity
from pipeline.models.hybrid import HybridModel
from pipeline.models.identify_rbf import posterior_factor
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.kept import Keep, kept_under, make_anew
from pipeline.signals.record import Record

TIED, FREE = (30.0,), (8.0, 2.0, 0.0)
"""Observer poles [1/s] in turn: from above the joint's 18 1/s, where each sample stands alone, to the free run."""

CORRECTED = (3.0, 0.0)
"""The same once the corrections have joined a joint that follows the log already."""

TIED_STEPS, STEPS, LAST_STEPS, CORRECTED_STEPS, JUDGED_STEPS = 10, 3, 8, 5, 3
"""Steps of the descent: tied, at each level between, in free run, there with corrections, where these are judged."""

PARTS = {"body": "equations_alone", "corrected": "equations_with_rbf"}
"""What the ablation calls them."""

UNKNOWN = 2.0
"""Factor on the prior widths of what a parameter set states, where none of the device is given."""

UNKNOWN_WEIGHT = 6.0
"""The same of the weight over the inertia: a device of another size stands under the same gravity."""

DESIGNED = ("log E", "log eta", "log eta_v", "log Y", "log C0", "log Y_MW", "b", "e_z", "a", "e_x", "laser offset")
"""What a parameter set states, and where the laser has its zero."""

JUDGE = 8.0
"""Observer pole [1/s] at which the held-out part is compared: a free run there is decided by single pulses that end
near the separatrix, held like this it is decided by all of them."""

HARM = 1.5
"""Factor by which corrections must raise the held-out error to be left out: their prior is proper, and three quarters
of a log show less of them than the whole. Simulated joints with rises of 4 to 22 % were predicted better, or equally
well."""

INNER = 0.75
"""Share of each training log on which the joint with and without corrections is fitted, to be compared on the rest."""

NOISE_INFLATION = 3.0
"""Noise is taken as this multiple of the residual's RMS: about ten samples in a row err together."""


ENOUGH = 1e-3
"""Share of the operating range: a body that leaves a smaller free-run error needs no correction."""


def identify_hybrid(
    records: Sequence[Record],
    parameters: JointParameters,
    *,
    similarity: Similarity = SAME,
    widening: FloatArray | None = None,
    basis_functions: int = 6,
    smoothing: float = 0.8,
    keep: Keep = make_anew,
) -> HybridModel:
    """Identify the hybrid joint from whole training logs with two voltages.

    Parameters
    ----------
    records : sequence of Record
        Training logs, each from rest; gaps and outliers masked.
    parameters : JointParameters
        The parameter set: the prior mean.
    similarity : Similarity
        The device in units of the set's joint.
    widening : FloatArray, shape (DEVIATIONS,), optional
        Factors on the prior widths of the deviations.
    basis_functions, smoothing : int, float
        M and σ_n of the corrections (eqs. 38, 39). They are left out where they clearly raise the error on the
        held-out last quarter of the logs.
    keep : callable
        Keeps each level that is finished.

    Raises
    ------
    InputError
        No data, or a log without two voltages.
    DataRefusedError
        No simulation follows the logs even when it is tied to them.

    Notes
    -----
    Cost: 24 Jacobians of 58 runs, nine more where levels are put in, and 30 of 130 runs with corrections; eight runs of
    37.5 s take 9 to 20 ms.
    """
    if not records:
        raise InputError("there is no training data; name at least one training log with valid samples")
    if any(record.v.shape[1] != 2 for record in records):
        raise InputError("hybrid: the joint has two membranes; give the channels v1 and v2, or take another model")
    search = _Search(tuple(similarity.set_record(record) for record in records), widening, keep)
    largest = max(float(np.abs(record.drive).max()) for record in search.records)
    plain = Body(parameters, np.zeros(3), 0, largest, condensed_parameters.static_slope_ratio(parameters))
    # Most of the way is gone while every sample stands alone: what is not settled there ends in another minimum.
    tied = search.fit(plain, plain.start(), TIED, last=TIED_STEPS)
    fit = search.fit(plain, tied.theta, FREE, insertions=3)
    if not fit.levels:
        raise DataRefusedError("no simulation follows the training logs even when tied to them; check q and its unit")
    judged: dict[str, Any] = {}
    chosen, final = plain, fit
    follows = fit.levels[-1].rms < 1e3 * ENOUGH * float(np.diff(search.operating_range)[0])
    if fit.reached_free_run and basis_functions and not follows:
        # What the equations can explain, they have explained by now: it is what extrapolates.
        body = search.corrected(plain, basis_functions, smoothing)
        judged = search.ablation(plain, body, fit.theta, similarity.length)
        if judged["inner_corrected_m"] < HARM * judged["inner_body_m"]:
            trial = search.fit(body, _extended(body, fit.theta), CORRECTED, last=CORRECTED_STEPS)
            if trial.reached_free_run and trial.levels[-1].rms < fit.levels[-1].rms:
                chosen, final = body, trial
    levels = (*tied.levels, *fit.levels, *(final.levels if chosen.centres else ()))
    return HybridModel(
        _of_device(chosen, similarity),
        final.theta,
        posterior_factor(final, search.prior(len(final.theta))),
        _report(levels, final, similarity) | judged,
    )


@dataclass(frozen=True)
class _Search:
    """Training logs in the units of the set's joint, factors on the prior widths, and what keeps finished levels."""

    records: tuple[Record, ...]
    widening: FloatArray | None
    keep: Keep

    def prior(self, count: int) -> Prior:
        """Independent deviations and weights about the set."""
        widths = np.ones(count)
        if self.widening is not None:
            widths[:DEVIATIONS] = self.widening
        return Prior(np.diag(1.0 / widths), np.zeros(count))

    def fit(
        self, body: Body, start: FloatArray, poles: Sequence[float], *, last: int = LAST_STEPS, insertions: int = 0
    ) -> HomotopyFit:
        """The joint fitted at the poles in turn."""
        name = f"{body.centres} centres, {sum(len(r.t) for r in self.records)} samples, from {poles[0]:g}"
        return fit_homotopy(
            BodyProblem(body, self.records), start, self.prior(len(start)), gains=poles, iterations=STEPS,
            last_iterations=last, noise_inflation=NOISE_INFLATION, insertions=insertions, descent=ParallelDescent,
            keep=kept_under(self.keep, name),
        )  # fmt: skip

    @property
    def operating_range(self) -> tuple[float, float]:
        """Smallest and largest displacement [m]."""
        valid = [record.q[record.valid] for record in self.records]
        return min(float(q.min()) for q in valid), max(float(q.max()) for q in valid)

    def corrected(self, plain: Body, basis_functions: int, smoothing: float) -> Body:
        """The same joint with an RBF basis over the operating range."""
        low, high = self.operating_range
        centres = basis_centres(low, high, basis_functions)
        basis = np.array([low, centres[1] - centres[0], basis_width(centres, smoothing)])
        return replace(plain, basis=basis, centres=basis_functions)

    def ablation(self, plain: Body, corrected: Body, theta: FloatArray, length: float) -> dict[str, Any]:
        """Errors with and without corrections over the last quarters of what is fitted before them.

        ``inner_…_m`` [m] is the mean error held at `JUDGE`; ``ablation`` the RMS error in free run, a share of the
        operating range. A run that fails is infinitely wrong.
        """
        found: dict[str, Any] = {"ablation": {}}
        low, high = self.operating_range
        early = replace(self, records=tuple(record.part(0, round(INNER * len(record.t))) for record in self.records))
        for name, body in (("body", plain), ("corrected", corrected)):
            fit = early.fit(body, _extended(body, theta), (JUDGE,), last=JUDGED_STEPS)
            problem = BodyProblem(body, self.records, INNER)
            held, free = (problem.held_out(fit.theta, pole) for pole in (JUDGE, 0.0))
            found[f"inner_{name}_m"] = _finite(1e-3 * length * float(np.mean(np.abs(held))))
            found["ablation"][PARTS[name]] = _finite(1e-3 * float(np.sqrt(np.mean(free**2))) / (high - low))
        return found


def unknown_device() -> FloatArray:
    """Factors on the prior widths where no parameter set of the device is given, shape (DEVIATIONS,)."""
    factors = {**dict.fromkeys(DESIGNED, UNKNOWN), "log weight": UNKNOWN_WEIGHT}
    names = (entry.name.split(".")[-1] for entry in condensed_parameters.DEVIATIONS)
    return np.array([factors.get(name, 1.0) for name in names])


def _finite(error: float) -> float:
    return error if np.isfinite(error) else float("inf")


def _of_device(body: Body, similarity: Similarity) -> Body:
    """The joint of the set's size as the device's."""
    return replace(
        body,
        basis=similarity.length * body.basis,
        largest_voltage=similarity.voltage * body.largest_voltage,
        similarity=similarity,
    )


def _extended(body: Body, theta: FloatArray) -> FloatArray:
    """θ of the joint, with corrections of zero."""
    return np.concatenate([theta, np.zeros(len(body.start()) - len(theta))])


def _report(levels: Sequence[Level], final: HomotopyFit, similarity: Similarity) -> dict[str, Any]:
    metre = 1e-3 * similarity.length
    return {
        "levels": {
            "observer_pole_1_per_s": np.array([level.gain for level in levels]) / similarity.time,
            "iterations": np.array([level.iterations for level in levels]),
            "rms_m": metre * np.array([level.rms for level in levels]),
        },
        "corrected": len(final.theta) > DEVIATIONS,
        "training_rms_m": metre * float(np.sqrt(np.mean(final.residual**2))),
        **vars(whiteness(final.residual)),
    }
