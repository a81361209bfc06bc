"""Identification of the hybrid joint: parameter set → calibrated joint by observer homotopy → RBF corrections."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple

import numpy as np

from ...device.parameters import NOMINAL, JointParameters
from ...errors import DataRefusedError, InputError
from ...fitting.descent import ParallelDescent, Prior
from ...fitting.homotopy import Callbacks, HomotopyFit, Level, Schedule, fit_homotopy
from ...fitting.population import NormalPopulation
from ...fitting.posterior import posterior_factor, robust_spread, whiteness
from ...fitting.regression import basis_centres, basis_width
from ...numerics.arrays import FloatArray
from ...numerics.metrics import rms
from ...signals.log import MOST_SAMPLES, Log, operating_range, within
from ..free_runs import scale_on
from ..model_type import ModelType, Training, fitted_samples
from . import parameters as condensed_parameters
from .kernels import CURVES
from .log_reading import SAME, Similarity
from .model import HybridModel
from .problem import DEVIATION_COUNT, POLES, CondensedJoint, CondensedProblem
from .start import mass_factor, prior_root, shift_of, similar_joint, theta_places

TUBE_MARGIN = 4.0
"""Times the 90 % quantile of errors on the training logs that tubes of other logs need: of fifty simulated joints of
three physics."""

COUPLED, FREE = POLES[:2], POLES[2:]
"""Poles at which every sample stands alone, and those from there to the free run."""

WHOLE = (POLES[2], 0.0, 0.0)
"""Poles on whole logs. The free run comes twice: the first one may bring runs back that had lost their log."""

CORRECTED = POLES[1:]
"""Poles with corrections: they, too, are first fitted while every sample stands alone."""

FIRST_STEPS = 12
STEPS = 3
LAST_STEPS = 20
"""Steps of the descent: while each sample stands alone, at each level from there on, and at the last on whole logs."""

COMPARED_POLE = POLES[2]
"""Observer pole [1/s] at which corrections are judged on held-out data: a free run there is decided by single pulses
that end near the separatrix, held like this it is decided by all of them."""

HARMFUL_RATIO = 1.5
"""Factor by which corrections must raise the held-out error to be left out: their prior is proper, and three quarters
of a log show less of them than the whole. Simulated joints with rises of 4 to 22 % were predicted better, or equally
well. Other joints are set aside by the same factor, on held-out data or on the fitted data: the last seconds of a short
log show little."""

NOISE_INFLATION = 3.0
"""Noise is taken as this multiple of the residual's RMS: about ten samples in a row err together."""

UNCORRECTED_ERROR = 2e-4
"""Share of the operating range: equations that leave a smaller free-run error need no correction. Of nine simulated
joints that left more seven were predicted better with corrections than without."""

LOST_ERROR = 0.02
"""Share of the operating range: a fit to whole logs that leaves more in free run has lost them, and a second one starts
from the set. Simulated joints leave 0.01 to 0.1 %."""

BASIS_FUNCTIONS = 6
SMOOTHING = 0.8
"""M and σ_n of the corrections (eqs. 38, 39)."""

OPEN = (0, 1)
"""Corrections that bands leave open where none acts: those of the restoring force and of the damping along q, which the
equations simplify more than the capacitances. With none the bands of 40 simulated joints held 84 to 96 % of the true
curves, with these 88 to 98 %, with all nine 95 to 100 %."""

_NO_FIT = "no simulation follows the training logs even when held near them; check q, the voltages and their units"

ALONE = "equations_alone"
WITH_RBF = "equations_with_rbf"
"""Names in the ablation of the equations without and with corrections."""


def identify_hybrid(
    records: Sequence[Log],
    parameters: JointParameters,
    *,
    similarity: Similarity = SAME,
    corrections: Literal["auto", "none", "always"] = "auto",
    siblings: NormalPopulation | None = None,
    rotation: FloatArray | None = None,
) -> HybridModel:
    """Identify the hybrid joint from whole training logs with two voltages.

    The first three quarters of every log are fitted first, without and, where that leaves more than
    `UNCORRECTED_ERROR`, with corrections; their errors on the rest decide about the corrections. The fit to whole logs
    goes on from there, and starts anew where it loses them.

    Parameters
    ----------
    records : sequence of Log
        Training logs, each from rest; gaps and outliers masked.
    parameters : JointParameters
        The parameter set: the prior mean.
    similarity : Similarity
        The device in units of the set's joint.
    corrections : {"auto", "none", "always"}
        Fit of corrections: kept as above, never, or always.
    siblings : NormalPopulation, optional
        The prior of the deviations, where joints of the same drawing are known (`pipeline.models.hybrid.siblings`). It
        is set aside where errors on the first parts of the logs, or on the rest, are `HARMFUL_RATIO` times as large
        with it.
    rotation : FloatArray, shape (K, 2), optional
        q [m] and φ [rad] at rest, by which a measured angle was made the displacement of the logs.

    Returns
    -------
    HybridModel
        With the one fitted to the first three quarters as `early`.

    Raises
    ------
    InputError
        No data, or a log without two voltages.
    DataRefusedError
        No simulation follows the logs even when an observer holds it near them.

    Notes
    -----
    Cost: 27 Jacobians on three quarters of the logs, 13 more with corrections, and 24 on whole ones (43 more where it
    starts anew), each with two batches of eight runs. On 37.5 s a Jacobian takes 40 to 65 ms, 65 to 105 with
    corrections; eight runs 5 to 9 ms.
    """
    operating_range(records)
    if any(record.v.shape[1] != 2 for record in records):
        raise InputError("hybrid: the joint has two membranes; give the channels v1 and v2, or take another model")
    plain = CondensedJoint(
        parameters,
        basis=np.zeros(3),
        centres=0,
        largest_voltage=0.0,
        slope_ratio=condensed_parameters.static_slope_ratio(parameters),
        rotation=np.empty((0, 2)) if rotation is None else rotation,
    )
    scaled = tuple(within([similarity.in_reference_units(plain.reading(record)) for record in records], MOST_SAMPLES))
    search, levels, fits, decision = _first_fits(_Search(scaled, siblings), plain, corrections)
    errors = {name: search.held_out(joint, fit.theta) for name, (joint, fit) in fits.items()}
    # Corrections that were fitted stay, unless they harm on held-out data.
    most = np.inf if corrections == "always" else HARMFUL_RATIO * errors[ALONE].coupled
    early, fitted = _whole_fit(search, fits, corrected=WITH_RBF in errors and errors[WITH_RBF].coupled < most)
    if not search.follows(fitted.fit, LOST_ERROR):
        fitted = min(fitted, search.anew(fits[ALONE].joint), key=lambda fitted: _free_error(fitted.fit))
    joint, fit = fitted
    if not fit.levels:
        raise DataRefusedError(_NO_FIT)
    nothing = np.zeros((len(early.fit.theta), 0))
    problem = CondensedProblem(joint, search.records)
    problem.hold_lost(fit.theta, 0.0)
    report = _report((*levels, *fit.levels), fit, similarity)
    model = HybridModel.of(
        _of_device(joint, similarity),
        fit.theta,
        posterior_factor(fit, search.prior(len(fit.theta))),
        search.spread(joint, fit, range(CURVES)),
        # For the curves, corrections of force and damping are free even where the model has none.
        None if joint.centres else search.spread(replace(joint, centres=BASIS_FUNCTIONS), fit, OPEN),
        diagnostics=report
        | {"held_share": problem.held_share}
        | {"ablation": {name: error.free for name, error in errors.items()}}
        | decision,
        early=HybridModel.of(_of_device(early.joint, similarity), early.fit.theta, nothing, nothing),
    )
    return replace(model, tube=scale_on(records, model, report["training_rms_m"], TUBE_MARGIN))


class _Fitted(NamedTuple):
    """A structure and its fit."""

    joint: CondensedJoint
    fit: HomotopyFit


def _first_fits(
    search: "_Search", joint: CondensedJoint, corrections: str
) -> tuple["_Search", tuple[Level, ...], dict[str, _Fitted], dict[str, Any]]:
    """Fits of the first parts of the logs: the equations alone, with other joints if they help, and with corrections if
    these are asked for or needed.

    Returns
    -------
    search : _Search
        Without the prior of other joints where it is harmful.
    levels : tuple of Level
        Of the equations alone.
    fits : dict of str to _Fitted
        By `ALONE` and `WITH_RBF`, as far as they were fitted.
    decision : dict
        Errors that decided about the prior of other joints; empty without one.
    """
    plain = replace(
        joint,
        basis=search.basis,
        largest_voltage=max(float(np.abs(record.drive).max()) for record in search.records),
    )
    # Most of the convergence happens while the observer is strong: what is not settled there ends in another minimum.
    first = search.early.without_siblings.fit(plain, plain.start(), COUPLED, steps=FIRST_STEPS)
    alone = search.early.fit(plain, first.theta, FREE)
    decision = dict[str, Any]()
    if search.siblings is not None:
        without = search.without_siblings.early.fit(plain, first.theta, FREE)
        errors = [search.held_out(plain, fit.theta).coupled if fit.levels else np.inf for fit in (alone, without)]
        # A file holds no infinite number: 1 is the whole operating range.
        decision = {"siblings_held_out": dict(zip(("with", "without"), np.minimum(errors, 1.0).tolist(), strict=True))}
        frees = [_free_error(fit) for fit in (alone, without)]
        if any(error > HARMFUL_RATIO * other for error, other in (errors, frees)):
            search, alone = search.without_siblings, without
    if not alone.levels:
        raise DataRefusedError(_NO_FIT)
    fits = {ALONE: _Fitted(plain, alone)}
    if corrections == "always" or (corrections == "auto" and not search.follows(alone, UNCORRECTED_ERROR)):
        joint = replace(plain, centres=BASIS_FUNCTIONS)
        fits[WITH_RBF] = _Fitted(joint, search.early.fit(joint, _extended(joint, first.theta), CORRECTED))
    return search, (*first.levels, *alone.levels), fits, decision


def _whole_fit(search: "_Search", fits: dict[str, _Fitted], *, corrected: bool) -> tuple[_Fitted, _Fitted]:
    """A first fit and the fit to whole logs that goes on from it: without corrections where those do not get there."""
    for name in (WITH_RBF, ALONE) if corrected else (ALONE,):
        early = fits[name]
        fit = search.fit(early.joint, early.fit.theta, WHOLE, last=LAST_STEPS)
        if fit.reached_last:
            break
    return early, _Fitted(early.joint, fit)


class _HeldOut(NamedTuple):
    """Errors on held-out data, shares of the operating range: the mean at `COMPARED_POLE`, and the RMS in free run."""

    coupled: float
    free: float


@dataclass(frozen=True)
class _Search:
    """Training logs in the units of the set's joint, and the prior of other joints."""

    records: tuple[Log, ...]
    siblings: NormalPopulation | None = None

    @property
    def without_siblings(self) -> "_Search":
        """The same about the set: a narrow prior holds a fit near the other joints while its errors are large, so in
        another minimum, where the joint is unlike them. They enter once every sample has been followed alone.
        """
        return replace(self, siblings=None)

    @property
    def early(self) -> "_Search":
        """The first parts of the logs."""
        return replace(self, records=tuple(r.part(0, fitted_samples(len(r.t))) for r in self.records))

    def prior(self, count: int) -> Prior:
        """Prior of the deviations, about the parameter set or the other joints, and of the weights of corrections."""
        root = prior_root((count - DEVIATION_COUNT) // CURVES, siblings=self.siblings)
        mean = np.zeros(DEVIATION_COUNT) if self.siblings is None else self.siblings.mean
        return Prior(root, root @ np.append(mean, np.zeros(count - DEVIATION_COUNT)))

    def fit(
        self,
        joint: CondensedJoint,
        start: FloatArray,
        poles: Sequence[float],
        *,
        steps: int = STEPS,
        last: int = STEPS,
    ) -> HomotopyFit:
        """The joint fitted at the poles in turn."""
        problem = CondensedProblem(joint, self.records)
        return fit_homotopy(
            problem,
            start,
            self.prior(len(start)),
            Schedule(poles, steps, last, noise_inflation=NOISE_INFLATION),
            callbacks=Callbacks(begin=problem.hold_lost),
            descent=ParallelDescent,
        )

    def anew(self, plain: CondensedJoint) -> _Fitted:
        """The equations alone, fitted to the logs from the set."""
        first = self.without_siblings.fit(plain, plain.start(), COUPLED, steps=FIRST_STEPS)
        return _Fitted(plain, self.fit(plain, first.theta, FREE, last=LAST_STEPS))

    def spread(self, joint: CondensedJoint, fit: HomotopyFit, rows: Sequence[int]) -> FloatArray:
        """Factor of the covariance of θ that leaving out parts of the logs shows: deviations and some corrections."""
        problem = CondensedProblem(joint, self.records)
        pole = fit.levels[-1].gain
        theta = _extended(joint, fit.theta)
        problem.hold_lost(theta, pole)
        places = theta_places(joint.centres, rows)
        prior = Prior(prior_root(joint.centres, rows, self.siblings), np.zeros(len(places)))
        residual, jacobian = problem.jacobian(theta, pole)
        factor = robust_spread(residual, jacobian[:, places], fit.noise, prior)
        spread = np.zeros((len(theta), factor.shape[1]))
        spread[places] = factor
        return spread

    def follows(self, fit: HomotopyFit, share: float) -> bool:
        """True if the error of a fit's free run is below a share of the operating range."""
        return _free_error(fit) < 1e3 * share * float(np.ptp(operating_range(self.records)))

    @property
    def basis(self) -> FloatArray:
        """RBF basis of corrections over the operating range, as far on either side of q = 0."""
        low, high = operating_range(self.records)
        reach = max(-low, high)
        centres = basis_centres(-reach, reach, BASIS_FUNCTIONS)
        return np.array([-reach, centres[1] - centres[0], basis_width(centres, SMOOTHING)])

    def held_out(self, joint: CondensedJoint, theta: FloatArray) -> "_HeldOut":
        """Errors behind the first parts of the logs; infinite where a run fails."""
        span = float(np.ptp(operating_range(self.records)))
        problem = CondensedProblem(joint, self.records, fitted_samples)
        coupled, free = (problem.held_out(theta, pole) for pole in (COMPARED_POLE, 0.0))
        errors = (float(np.mean(np.abs(coupled))), rms(free))
        return _HeldOut(*(1e-3 * error / span if np.isfinite(error) else float("inf") for error in errors))


def _free_error(fit: HomotopyFit) -> float:
    """RMS error in free run; infinite if a fit did not get there."""
    return fit.levels[-1].rms if fit.reached_last else float("inf")


def _extended(joint: CondensedJoint, theta: FloatArray) -> FloatArray:
    """θ of the equations alone, with corrections of zero."""
    return np.concatenate([theta, np.zeros(len(joint.start()) - len(theta))])


def _of_device(joint: CondensedJoint, similarity: Similarity) -> CondensedJoint:
    """The joint of the set's size as the device's."""
    return replace(
        joint,
        basis=similarity.length * joint.basis,
        largest_voltage=similarity.voltage * joint.largest_voltage,
        similarity=similarity,
    )


def _report(levels: Sequence[Level], final: HomotopyFit, similarity: Similarity) -> dict[str, Any]:
    metre = 1e-3 * similarity.length
    return {
        "levels": {
            "observer_pole_1_per_s": np.array([level.gain for level in levels]) / similarity.time,
            "iterations": np.array([level.iterations for level in levels]),
            "rms_m": metre * np.array([level.rms for level in levels]),
        },
        "corrected": len(final.theta) > DEVIATION_COUNT,
        "training_rms_m": metre * rms(final.residual),
        **vars(whiteness(final.residual)),
    }


def _fit(training: Training) -> HybridModel:
    plant = training.device
    mass = plant.known_mass
    corrections = training.identify.corrections
    if training.parameters is not None:
        return identify_hybrid(
            training.records,
            training.parameters,
            similarity=Similarity(mass=mass_factor(training.parameters, mass), origin=shift_of(training.records)),
            corrections=corrections,
            siblings=training.siblings,
            rotation=training.rotation,
        )
    if plant.squared and plant.displacement.symbol == "rad" and plant.input_symbols == ("V", "V"):
        raise DataRefusedError(
            "q is an angle; with a parameter set (plant.parameters) the equations of the joint read it"
        )
    if not (plant.squared and plant.displacement.symbol == "m" and len(plant.inputs) == 2):
        raise DataRefusedError("the joint has a displacement and two squared voltages; this device has others")
    similarity = similar_joint(training.records, NOMINAL, mass)
    return identify_hybrid(training.records, NOMINAL, similarity=similarity, corrections=corrections)


HYBRID = ModelType(_fit, HybridModel, "export.hybrid:realise")
