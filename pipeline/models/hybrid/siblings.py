"""Prior of a joint's deviations from other joints of one drawing."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

import numpy as np

from ...device.parameters import JointParameters
from ...errors import CorruptArtifactError, DataRefusedError, InputError
from ...fitting.population import (
    Information,
    NormalPopulation,
    Oddity,
    estimate_population,
    log_evidence,
    oddity,
    without_each,
)
from ...numerics.arrays import FloatArray
from ..model_file import JointSet, ModelFile, Sizes, Table, Unit, column_of, read_part, tree_of
from .identify import NOISE_INFLATION
from .model import HybridModel
from .parameters import DEVIATIONS, NAMES, PRIOR_STD
from .start import prior_root

FEWEST = 5
"""Joints from which a population is learnt."""

SUREST = 1e6
"""Largest precision that a log is trusted with, in units of the prior's: no population is as narrow as its root says,
and sums with larger numbers lose what other directions say."""

_WORDS = {
    "C0": "capacitance", "Y": "modulus", "Y_MW": "relaxing modulus", "E": "beam modulus", "eta": "beam loss",
    "eta_v": "membrane viscosity", "b": "mount distance b", "a": "mount distance a", "e_x": "mount offset e_x",
    "e_z": "mount offset e_z",
}  # fmt: skip
"""Names of quantities that are letters in the equations."""


_SUSPECTS = ("length", "voltage", "E", "Y", "C0", "Y_MW", "weight", "laser offset", "delay", "charging time", "probe 1",
             "probe 2")  # fmt: skip
"""Quantities, of either side where they have one, of which a joint is called odd: those of films, beam and
instruments that a workshop or a rig gets wrong. The others compensate each other and would only hide these."""


class SiblingsFile(ModelFile):
    """The file of a prior from other joints."""

    sizes: ClassVar[Sizes] = {"P": (1, 5000)}
    parameters: JointSet
    deviations: str
    """Names of the deviations."""
    prior_std: Annotated[FloatArray, Table("P"), Unit("SI")]
    """Prior standard deviations of the deviations or of their logarithms."""
    mean: Annotated[FloatArray, Table("P", -300.0, 300.0)]
    """Mean of the deviations, in prior standard deviations."""
    covariance: Annotated[FloatArray, Table("P P", -1e6, 1e6)]
    """Covariance of the deviations of one more joint, in prior standard deviations."""


def column(path: str) -> tuple[str, str]:
    """Unit and meaning of an entry of the file."""
    return column_of(f"siblings/{path}", {}, {"siblings": SiblingsFile})


@dataclass(frozen=True)
class Odd:
    """An odd joint: its name, the quantity, and its deviation from the expectation by the others (`Learnt.unit`)."""

    name: str
    quantity: str
    size: float
    error: float
    unit: str


@dataclass(frozen=True)
class LearntQuantity:
    """Prediction of one deviation: mean and spread for the next joint, and that spread over the prior's."""

    name: str
    mean: float
    spread: float
    unit: str
    share: float


@dataclass(frozen=True)
class Learnt:
    """Population of joints, learnt from other joints.

    Attributes
    ----------
    population : NormalPopulation
        Of the deviations, in prior standard deviations.
    quantities : tuple of LearntQuantity
        The best known first.
    odd : tuple of Odd
        Odd joints; of usual ones at most `pipeline.fitting.population.FALSE_ALARMS` are called so.
    gains : dict of str to float
        For each joint the log-evidence [nats] of its logs under the others' prior, less that under the usual prior.
    """

    population: NormalPopulation
    quantities: tuple[LearntQuantity, ...]
    odd: tuple[Odd, ...]
    gains: dict[str, float]


def usual_prior() -> NormalPopulation:
    """The prior of a joint without other joints."""
    root = prior_root(0)
    return NormalPopulation(np.zeros(len(NAMES)), np.asarray(np.linalg.inv(root.T @ root), dtype=np.float64))


def information_of(model: HybridModel) -> Information:
    """Information of the training logs on the deviations of a joint that was identified alone.

    The corrections are integrated out. The fit takes its noise to be `NOISE_INFLATION` times the RMS of the residual,
    its posterior √τ times that, for the autocorrelation time τ. In units of the prior a direction of precision λ in the
    posterior had λ τ / `NOISE_INFLATION`² in the fit, and its pull to zero is undone by that. It is at most doubled,
    because fits end before they have converged in directions of which logs show little.
    """
    count = len(NAMES)
    own = prior_root(0)
    tau = float(model.diagnostics["integrated_correlation_time"])
    # shares of the prior's variance that the logs leave are 1 / (1 + λ)
    shares, directions = np.linalg.eigh(own @ (model.spread @ model.spread.T)[:count, :count] @ own.T)
    shares = np.clip(shares, np.finfo(float).eps, 1.0)
    precision = np.minimum(1.0 / shares - 1.0, SUREST)
    pulled = np.minimum(NOISE_INFLATION**2 / (tau * np.maximum(precision, np.finfo(float).eps)), 1.0)
    best = directions.T @ (own @ model.theta[:count]) * (1.0 + pulled)
    turned = own.T @ directions
    return Information((turned * precision) @ turned.T, turned @ (precision * best))


def learn(models: Mapping[str, HybridModel]) -> Learnt:
    """Learn the population of joints from identified ones.

    Parameters
    ----------
    models : mapping of str to HybridModel
        By the names of the joints, each identified alone about one parameter set.

    Raises
    ------
    DataRefusedError
        Fewer than `FEWEST`.
    InputError
        They have not one parameter set.
    """
    if len(models) < FEWEST:
        raise DataRefusedError(f"{len(models)} of at least {FEWEST} joints that a prior needs: identify more of them")
    for name, model in models.items():
        if any(getattr(model.joint.similarity, scale) != 1.0 for scale in ("length", "time", "voltage")):
            raise InputError(f"{name}: was scaled by its own logs; give all joints one set, plant.parameters")
    if len({model.joint.parameters for model in models.values()}) > 1:
        raise InputError("the joints have not one parameter set; name the same plant.parameters for all of them")
    prior = usual_prior()
    members = [information_of(model) for model in models.values()]
    whole = estimate_population(members, prior)
    suspects = [i for i, entry in enumerate(DEVIATIONS) if entry.quantity.rpartition(".")[2] in _SUSPECTS]
    others = [*zip(models, members, without_each(members, prior, whole), strict=True)]
    gains = {name: log_evidence(member, rest) - log_evidence(member, prior) for name, member, rest in others}
    tested = ((name, oddity(member, rest, len(members) - 1, suspects)) for name, member, rest in others)
    odd = tuple(_odd(name, outlier) for name, outlier in tested if outlier.odd)
    return Learnt(whole, _quantities(whole, prior), odd, gains)


def _title(entry: int) -> str:
    """Name of a deviation for readers: ``left capacitance``."""
    side, dot, name = DEVIATIONS[entry].quantity.rpartition(".")
    return f"{side}{' ' if dot else ''}{_WORDS.get(name, name)}"


def _odd(name: str, outlier: Oddity) -> Odd:
    deviation = DEVIATIONS[outlier.entry]
    size = outlier.size * deviation.prior_std
    error = outlier.error * deviation.prior_std
    if deviation.logarithm:
        size = np.expm1(size)
        return Odd(name, _title(outlier.entry), 100.0 * size, 100.0 * (1.0 + size) * error, "%")
    return Odd(name, _title(outlier.entry), size, error, deviation.unit)


def _quantities(population: NormalPopulation, prior: NormalPopulation) -> tuple[LearntQuantity, ...]:
    spread, before = (np.sqrt(np.diag(each.covariance)) for each in (population, prior))
    rows = [
        LearntQuantity(
            _title(i),
            float(population.mean[i] * entry.prior_std),
            float(spread[i] * entry.prior_std),
            "logarithm" if entry.logarithm else entry.unit,
            float(spread[i] / before[i]),
        )
        for i, entry in enumerate(DEVIATIONS)
    ]
    return tuple(sorted(rows, key=lambda row: row.share))


def to_tree(learnt: Learnt, parameters: JointParameters, origins: Mapping[str, str]) -> dict[str, Any]:
    """Tree for the file of a prior; `origins` has the content hash of each joint's model."""
    return {
        "parameters": tree_of(parameters),
        "deviations": " | ".join(NAMES),
        "prior_std": PRIOR_STD,
        "mean": learnt.population.mean,
        "covariance": learnt.population.covariance,
        "diagnostics": {"siblings": " | ".join(origins), "models_sha256": " | ".join(origins.values())},
    }


def from_tree(tree: Mapping[str, Any]) -> tuple[JointParameters, NormalPopulation, Sequence[str]]:
    """The parameter set, the population and the names of the joints, from the tree of a file.

    Raises
    ------
    CorruptArtifactError
        An entry is missing, of another kind or shape or beyond its range, or of another version of the program.
    """
    file = read_part(SiblingsFile, tree, "siblings", "fleet learn")
    current = file.deviations == " | ".join(NAMES) and np.array_equal(file.prior_std, PRIOR_STD)
    covariance = file.covariance
    if not (current and np.allclose(covariance, covariance.T) and np.linalg.eigvalsh(covariance).min() > 0.0):
        raise CorruptArtifactError(
            "siblings: of another version of debist, or no covariance; run `debist fleet learn` again"
        )
    names = str(file.diagnostics.get("siblings", "")).split(" | ")
    return file.parameters, NormalPopulation(file.mean, covariance), names
