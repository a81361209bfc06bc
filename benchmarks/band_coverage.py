"""Whether the 90 % bands of curves and facts hold the truth: `python benchmarks/band_coverage.py wells 10`.

`wells N KIND…` draws N double wells of each kind, of any stiffness, damping, noise (1 to 100 µm), and rate from 400 Hz
to 2 kHz. It identifies `rbf` from one log of 8 to 24 s of each. Kinds are three families of plain wells ("quartic",
"asymmetric", "sextic or cosine"), each with excitations of its own, "friction", "relaxation", and "one input", a plain
well with random levels of a single linear input; all by default.

`joints FLEET RUNS` compares `hybrid` and `rbf` with simulated joints. FLEET is a folder of `debist rig fleet`, RUNS
what `debist batch FLEET -o RUNS` made of it. The true restoring force F(q) and slopes ∂C/∂q come from the joint
itself: its coordinates of least energy under a held tip. Where those jump (near q = 0 a beam has two mirrored S
shapes of equal energy) there is no curve. Curves of a joint whose settings give no mass are compared per unit mass.

Facts follow from the true curves as those of the datasheet from the model's. Printed are for each curve the median
error as a share of its largest value, the share of points within the band, and the factor by which the bands would
have to be widened to hold 90 % of them.
"""

import argparse
import json
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import minimize, root

import debist
from debist import open_run
from pipeline.device.device import JOINT
from pipeline.diagnostics.characteristics import Curves, curves_from, device_facts, intervals
from pipeline.diagnostics.datasheet import drawn_ring_downs, simulated_ring_downs
from pipeline.models.base import FreeRun
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.compiled import compiled
from pipeline.rig.fleet import Experiment, draw, moving_mass
from pipeline.rig.joint import membrane_capacitances, potential, rest, tip_displacement
from pipeline.rig.parameters import RigParameters

POINTS, STEP = 33, 5e-5
LEVEL = (5.0, 95.0)
DRAWS = 200
GRID = 401
NUDGE, UNBALANCED = 1e-5, 1e-6
"""Step of the slopes of energy and tip; what may be left of their balance [mJ, mm]."""
JUMP = 5.0
"""Times the usual move of the coordinates between neighbouring places that is a jump."""
UNIT = 1e-9
"""Distance [kg] of a model's mass from 1 kg that says that no mass was given."""
NEAR = 1.5
"""Times its interval within which a stiffness is near it."""
LARGEST_VOLTAGE = 3000.0
RATE = 8000
"""Steps in a second of a simulated double well."""
CURVES = ("F", "d", "dC1_dq", "dC2_dq", "g1")


def true_curves(joint: RigParameters, q: FloatArray) -> dict[str, FloatArray]:
    """F [N] and ∂C/∂q [F/m] along the path of least energy at q [m], by central differences."""
    x = rest(joint, side=-1)
    energy, capacitance, moved = np.empty((len(q), 2)), np.empty((len(q), 2, 2)), np.empty(len(q))
    for i, middle in enumerate(q):
        for j, at in enumerate((middle - STEP, middle + STEP)):
            before, (x, found) = x, held_at(joint, x, at)
            moved[i] = np.abs(x - before).max() if found else np.inf
            energy[i, j] = potential(joint, x, np.zeros(2))
            capacitance[i, j] = membrane_capacitances(joint, x)
    slopes = (capacitance[:, 1] - capacitance[:, 0]) / (2.0 * STEP)
    force = (energy[:, 1] - energy[:, 0]) / (2.0 * STEP)
    smooth = np.where(moved < JUMP * np.median(moved), 1.0, np.nan)
    return {"F": force * smooth, "dC1_dq": slopes[:, 0] * smooth, "dC2_dq": slopes[:, 1] * smooth}


def held_at(joint: RigParameters, x: FloatArray, at: float) -> tuple[FloatArray, bool]:
    """Coordinates of least energy with the tip at `at` [m], from `x` on, and whether they are found.

    The minimiser finds the valley, but stops short of its floor or gives up; what is left is solved for.
    """
    none = np.zeros(2)

    def energy_of(x: FloatArray) -> float:
        return 1e3 * potential(joint, x, none)

    def off(x: FloatArray) -> float:
        return 1e3 * (tip_displacement(joint, x) - at)

    found = minimize(energy_of, x, method="SLSQP", constraints={"type": "eq", "fun": off})

    def unbalanced(z: FloatArray) -> FloatArray:
        beside = [z[:-1] + step for step in np.vstack([NUDGE * np.eye(len(x)), -NUDGE * np.eye(len(x))])]
        energy = np.array([potential(joint, x, none) for x in beside]).reshape(2, -1)
        tip = np.array([tip_displacement(joint, x) for x in beside]).reshape(2, -1)
        balance = (energy[0] - energy[1] - z[-1] * (tip[0] - tip[1])) / (2.0 * NUDGE)
        return np.append(1e3 * balance, 1e3 * (tip_displacement(joint, z[:-1]) - at))

    solved = root(unbalanced, np.append(found.x, 0.0), tol=1e-12)
    balanced = np.abs(solved.fun).max() < UNBALANCED
    return (solved.x[:-1], True) if balanced else (found.x, False)


def joint_of(path: Path) -> RigParameters:
    """The joint that a truth was drawn from."""
    truth = json.loads(path.read_text(encoding="utf-8"))
    return draw(Experiment(**truth["experiment"]), np.random.default_rng(truth["seed"]))[0]


@dataclass(frozen=True)
class Well:
    """ẍ = −k a p(x/a) − (d + D (x/a)²) ẋ − f z − h e + c₁ v₁² − c₂ v₂², per unit mass.

    p is of x, x², x³, x⁵ and sin πx. z is a state of Dahl, and ė = ẋ − r e. Wells are at about ± a [m].
    """

    k: float
    a: float
    potential: tuple[float, float, float, float, float]
    damping: float
    growth: float
    gains: tuple[float, float]
    friction: float
    spring: float
    rate: float

    @property
    def period(self) -> float:
        """Period [s] of small vibrations about a well."""
        return float(2.0 * np.pi / np.sqrt(2.0 * self.k))

    @property
    def numbers(self) -> FloatArray:
        """Numbers of the equation in the order of the fields."""
        loose = (self.damping, self.growth, *self.gains, self.friction, self.spring, self.rate)
        return np.array((self.k, self.a, *self.potential, *loose))

    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Displacement without voltages, whatever `v`."""
        every = round(RATE * (t[1] - t[0]))
        none = np.zeros(2 * every * (len(t) - 1) + 1)
        q = _moved(none, none, 1.0 / RATE, self.numbers, np.array([q0, qdot0]))[::every]
        return FreeRun(t, q, np.zeros_like(q), np.zeros_like(q), "ok", None)

    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Planted F, d and slopes at q [m]."""
        x, one = q / self.a, np.ones_like(q)
        force = self.k * self.a * np.array([_shape(each, np.array(self.potential)) for each in x])
        slopes = {"dC1_dq": 2.0 * self.gains[0] * one, "dC2_dq": -2.0 * self.gains[1] * one}
        return {"F": force, "d": self.damping + self.growth * x * x} | slopes


@compiled
def _shape(x: float, p: FloatArray) -> float:
    """Force of a double well over k a."""
    return float(p[0] * x + p[1] * x * x + p[2] * x**3 + p[3] * x**5 + p[4] * np.sin(np.pi * x))


POTENTIALS = {
    "quartic": (-1.0, 0.0, 1.0, 0.0, 0.0),
    "asymmetric": (-1.0, 0.4, 1.0, 0.0, 0.0),
    "sextic": (-0.5, 0.0, 0.0, 0.5, 0.0),
    "cosine": (-0.23, 0.0, 0.23, 0.0, -0.49),
}
"""Forces with wells at about ±1, and a slope of about 2 there."""

EXCITATIONS = ("pulses", "steps", "holds", "both")
FAMILIES = {
    "quartic": (("quartic",), ("pulses",)),
    "asymmetric": (("asymmetric",), ("holds", "steps")),
    "sextic or cosine": (("sextic", "cosine"), ("both",)),
}
"""Potentials and excitations of the plain wells."""

SINGLE = "one input"
"""Kind with one linear input u = v₁² − v₂², of equal gains."""
KINDS = (*FAMILIES, "friction", "relaxation", SINGLE)
PLAIN = "plain"
STAYS = "one well"
"""Kind of a device whose log never passes the barrier."""


def drawn_well(kind: str, rng: np.random.Generator) -> tuple[Well, str]:
    """A double well of a kind, and its excitation."""
    usual = EXCITATIONS if kind != SINGLE else ("levels",)
    potentials, excitations = FAMILIES.get(kind, (tuple(POTENTIALS), usual))
    potential = POTENTIALS[str(rng.choice(potentials))]
    k, a = 10.0 ** rng.uniform(1.8, 2.95), 10.0 ** rng.uniform(-2.5, -1.7)
    damping = 2.0 * 10.0 ** rng.uniform(-1.5, -0.4) * np.sqrt(2.0 * k)
    largest = k * a * max(abs(_shape(x, np.array(potential))) for x in np.linspace(-1.0, 1.0, GRID))
    friction = largest * rng.uniform(0.03, 0.15) * (kind == "friction")
    spring = 2.0 * k * rng.uniform(0.1, 0.3) * (kind == "relaxation")
    rate = np.sqrt(2.0 * k) * 10.0 ** rng.uniform(-1.2, 0.0)
    first, second = largest * rng.uniform(1.3, 3.0, 2) / LARGEST_VOLTAGE**2
    growth = damping * rng.choice([0.0, 0.5])
    second = first if kind == SINGLE else second
    return Well(k, a, potential, damping, growth, (first, second), friction, spring, rate), str(rng.choice(excitations))


@compiled
def _moved(v1: FloatArray, v2: FloatArray, h: float, w: FloatArray, begin: FloatArray) -> FloatArray:
    """Displacements under voltages at every half step, shape (2 N − 1,); w: `Well.numbers`; begin: first x and ẋ."""
    k, a = w[:2]
    damping, growth, first, second, friction, spring, rate = w[7:]
    q, state, slopes = np.empty(len(v1) // 2 + 1), np.array([begin[0], begin[1], 0.0, 0.0]), np.zeros((5, 4))
    for n in range(len(q)):
        q[n] = state[0]
        for stage in range(4):
            part = (0.0, 0.5, 0.5, 1.0)[stage]
            x, p, z, e = state + part * h * slopes[stage]
            at = min(2 * n + int(2.0 * part), len(v1) - 1)
            force = -k * a * _shape(x / a, w[2:7]) - (damping + growth * (x / a) ** 2) * p
            push = first * v1[at] ** 2 - second * v2[at] ** 2
            slopes[stage + 1] = p, force + push - friction * z - spring * e, (p - abs(p) * z) / (0.01 * a), p - rate * e
        state += h / 6.0 * (slopes[1] + 2.0 * slopes[2] + 2.0 * slopes[3] + slopes[4])
    return q


def _voltages(well: Well, excitation: str, count: int, h: float, rng: np.random.Generator) -> FloatArray:
    """Voltages (2, N) with edges of 2 ms: on one side after the other with rests between, or levels of both at once."""
    v, at, side = np.zeros((2, count)), 0.3, 0
    while at < count * h - 1.5 * well.period:
        if excitation == "both":
            width = well.period * rng.uniform(0.5, 3.0)
            each = slice(int(at / h), int((at + width) / h))
            v[:, each] = LARGEST_VOLTAGE * (rng.uniform(0.2, 1.0, 2) * (rng.random(2) < 0.6))[:, None]
            at += width
        elif excitation == "levels":
            width, level = well.period * rng.uniform(0.5, 2.5), rng.uniform(-1.0, 1.0)
            v[int(level < 0.0), int(at / h) : int((at + width) / h)] = LARGEST_VOLTAGE * np.sqrt(abs(level))
            at += width
        else:
            low, high = {"pulses": (0.4, 0.8), "steps": (0.5, 3.5), "holds": (2.0, 6.0)}[excitation]
            width = well.period * rng.uniform(low, high)
            v[side, int(at / h) : int((at + width) / h)] = LARGEST_VOLTAGE * rng.uniform(0.5, 1.0)
            at, side = at + width + well.period * rng.uniform(2.0, 4.0), side ^ (rng.random() < 0.8)
    power = 0.5 if excitation == "levels" else 1.0  # the input has straight edges: the difference of the squares
    return np.array([np.convolve(each ** (1.0 / power), np.ones(16) / 16.0, "same") ** power for each in v])


def well_log(well: Well, excitation: str, rng: np.random.Generator) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Times, noisy displacements and voltages (N, 2) of a raw log of 8 to 24 s."""
    count = RATE * int(rng.integers(8, 25))
    h = 1.0 / RATE
    v = _voltages(well, excitation, count, h, rng)
    v1, v2 = (np.interp(np.arange(2 * count - 1) / 2.0, np.arange(count), each) for each in v)
    kept = slice(None, None, RATE // int(rng.choice([400, 1000, 2000])))
    q = _moved(v1, v2, h, well.numbers, np.array([-well.a, 0.0]))[kept]
    noisy: FloatArray = q + 10.0 ** rng.uniform(-6.0, -4.0) * rng.standard_normal(len(q))
    return np.asarray(h * np.arange(count)[kept], dtype=np.float64), noisy, v[:, kept].T


@dataclass(frozen=True)
class Compared:
    """A model beside the truth.

    Attributes
    ----------
    kind : str
        Kind of device.
    model : model with curves
    q : FloatArray, shape (GRID,)
        Places [m].
    truth : dict of str to FloatArray
        True curves.
    unit : float
        Unit of the model's curves in theirs.
    itself : optional
        The device, which simulates as a model does.
    """

    kind: str
    model: Any
    q: FloatArray
    truth: dict[str, FloatArray]
    unit: float = 1.0
    itself: Any = None


class Tally:
    """Errors, half widths and sizes of curves, and which facts lie within their intervals, by kind of device."""

    def __init__(self) -> None:
        self.errors: dict[str, list[FloatArray]] = defaultdict(list)
        self.halves: dict[str, list[FloatArray]] = defaultdict(list)
        self.sizes: dict[str, list[float]] = defaultdict(list)
        self.facts: dict[str, list[bool]] = defaultdict(list)

    def add(self, device: Compared) -> None:
        """Compare a model's curves and facts with the truth."""
        found, drawn = device.model.curves(device.q), device.model.curve_ensemble(device.q, DRAWS)
        truth = {name: values / device.unit for name, values in device.truth.items()}
        coarse = slice(None, None, GRID // POINTS)
        for name in set(CURVES) & truth.keys() & drawn.keys():
            low, high = np.percentile(drawn[name], LEVEL, axis=0)
            key = f"{device.kind} {name}"
            self.errors[key].append(np.abs(0.5 * (low + high) - truth[name])[coarse])
            self.halves[key].append((0.5 * (high - low))[coarse])
            self.sizes[key].append(float(np.nanmax(np.abs(truth[name]))))
        if "d" in truth:
            apart = np.abs(np.log(np.maximum(found["d"], np.finfo(float).tiny) / truth["d"]))
            self.facts[f"{device.kind} : damping within a factor of two"].append(bool(apart.max() < np.log(2.0)))
        if all(np.isfinite(values).all() for values in truth.values()):
            self._add_facts(device, truth, found, [{name: drawn[name][i] for name in drawn} for i in range(DRAWS)])

    def _add_facts(
        self, device: Compared, truth: dict[str, FloatArray], found: dict[str, FloatArray],
        draws: list[dict[str, FloatArray]],
    ) -> None:  # fmt: skip
        """Which of the true facts lie within their intervals."""
        true, own = (device_facts(_curves(values, device.q), plant=JOINT) for values in (truth, found))
        limits = intervals(own, [device_facts(_curves(row, device.q), plant=JOINT) for row in draws])
        if device.itself:
            curves, true_curves = _curves(found, device.q), _curves(truth, device.q)
            rings = simulated_ring_downs(device.model, own, curves, device.model.input_count)
            drawn = [_curves(row, device.q) for row in draws]
            limits |= intervals(rings, drawn_ring_downs(device.model, rings, curves, drawn, JOINT))
            true |= simulated_ring_downs(device.itself, true, true_curves, 2)
        for name, value in true.items():
            if name in limits and value is not None:
                low, high = limits[name]
                self.facts[f"{device.kind} {name.split('_')[0]}"].append(low <= value <= high)
                if name.startswith("stiffness"):
                    near = abs(value - 0.5 * (low + high)) < NEAR * 0.5 * (high - low)
                    self.facts[f"{device.kind} : stiffness near its interval"].append(near)

    def show(self) -> None:
        """Print the table."""
        print(f"{'':24s}{'devices':>8s}{'median error %':>16s}{'within 90 % band':>18s}{'widen by':>10s}")
        for key in sorted(self.errors):
            error, half = np.array(self.errors[key]), np.array(self.halves[key])
            share, kept = 100.0 * np.nanmedian(error / np.array(self.sizes[key])[:, None]), np.isfinite(error)
            inside, factor = 100.0 * np.mean((error < half)[kept]), np.percentile((error / half)[kept], 90)
            print(f"{key:24s}{len(error):8d}{share:16.2f}{inside:17.0f} %{factor:10.1f}")
        for key, held in sorted(self.facts.items()):
            print(f"{key:24s}{len(held):8d}{'':16s}{100.0 * np.mean(held):17.0f} %")


def _curves(named: dict[str, FloatArray], q: FloatArray) -> Curves:
    return curves_from({"d": np.zeros_like(q)} | {name: named[name] for name in CURVES if name in named}, q)


def joints(fleet: Path, runs: Path) -> Iterator[Compared]:
    """The models of every run of a fleet."""
    for path in sorted(fleet.glob("*/truth/truth.json")):
        name = path.parent.parent.name
        if not (runs / name).is_dir():
            continue
        run, joint = open_run(runs / name), joint_of(path)
        least, most = np.percentile(run.log("train")["q_m"].dropna().to_numpy(), [1.0, 99.0])
        q = np.linspace(least, most, GRID)
        coarse = np.linspace(least, most, POINTS)
        known = true_curves(joint, coarse)
        # A jump leaves no facts, and lines between the points that there are; else a smooth curve has its slopes.
        smooth = all(np.isfinite(values).all() for values in known.values())
        truth = {
            key: CubicSpline(coarse, values)(q) if smooth else np.interp(q, coarse, values)
            for key, values in known.items()
        }
        for model in (run.model(each).core for each in ("hybrid", "rbf") if each in run.models):
            unit = moving_mass(joint) if abs(getattr(model, "mass_kg", 1.0) - 1.0) < UNIT else 1.0
            yield Compared(f"{name.partition('-')[0]} {model.name}", model, q, truth, unit)


def wells(numbers: Sequence[int], kinds: Sequence[str]) -> Iterator[Compared]:
    """Double wells, identified one after the other; the three families are plain ones."""
    for kind in kinds or KINDS:
        for number in numbers:
            rng = np.random.default_rng([*kind.encode(), number])
            well, excitation = drawn_well(kind, rng)
            t, q, v = well_log(well, excitation, rng)
            least, most = np.percentile(q, [1.0, 99.0])
            places = np.linspace(least, most, GRID)
            truth = well.curves(places)
            if kind == SINGLE:
                model = debist.identify(t, q, v[:, 0] ** 2 - v[:, 1] ** 2, model="rbf", inputs="linear").core
                truth = {"F": truth["F"], "d": truth["d"], "g1": 0.5 * truth["dC1_dq"]}
            else:
                model = debist.identify(t, q, v[:, 0], v[:, 1], model="rbf").core
            print(f"{kind} {number}, {excitation} of {t[-1]:.0f} s: {model.describe()['chosen']}", flush=True)
            switched = q.min() < -0.5 * well.a and q.max() > 0.5 * well.a
            group = PLAIN if kind in FAMILIES else kind
            yield Compared(group if switched else STAYS, model, places, truth, itself=well)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("what", choices=["wells", "joints"])
    parser.add_argument("source", nargs="+")
    parser.add_argument("--first", type=int, default=0, help="number of the first well of a kind; each draws another")
    given = parser.parse_args()
    tally = Tally()
    source, *others = given.source
    if given.what == "wells":
        compared = wells(range(given.first, given.first + int(source)), others)
    else:
        compared = joints(Path(source), *map(Path, others))
    for device in compared:
        tally.add(device)
    tally.show()


if __name__ == "__main__":
    main()
