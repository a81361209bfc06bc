"""The run whose identified joint is to be controlled, and what control keeps in the run."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...control.ensemble import Converters
from ...control.plant import ASSUMED_LAG, ControlledJoint, plant_of, wells_and_saddle
from ...device.device import JOINT, device
from ...diagnostics.events import converter_lag
from ...errors import DataRefusedError, InputError
from ...models.hybrid.log_reading import ANGLE_IS_READ
from ...models.hybrid.model import HybridModel
from ...scoring.wells import Wells, wells_of
from ...settings.prototype import Prototype
from ...signals.log import log_of
from ...store import layout
from ...store.atomic import run_lock
from ...store.run_folder import RunFolder, Written
from ...system.names import shell_word
from ...system.worker_pool import OnProgress
from ..engine import Observer, Task, bring_up_to_date
from ..run_contents import WORST, failed_validations, joint_beside, load_run_model, model_artifact

ALGORITHM = "22"
_MISSED = 0.09
_UNSEEN = 2e-3
"""RMS residual on the training logs above which no control is designed on a model: a share of the wells' distance, or
[m] where the logs show no wells."""
DATA_SHEET = 0.36
GIVEN = 0.1
"""Standard deviations of a lag's logarithm: of the one assumed, for converters of 2 to 7 ms, and of one that the user
states."""
_LEAST_SPREAD = 0.02
"""The same for a lag from steps, at least: a step of another height takes another time."""
_ROUNDED = 1.01


@dataclass(frozen=True)
class ControlSettings:
    """Choices of the user.

    Attributes
    ----------
    max_voltage : float or None
        Largest voltage [V]; `ControlRun.limit` if left out.
    lag : float or None
        Time constant of the converters [s]; that of the voltage steps in the training logs if left out.
    slew, average : float or None
        Largest rate of each voltage [V/s] and its largest mean over about 10 s [V]; no limit if left out.
    """

    max_voltage: float | None = None
    lag: float | None = None
    slew: float | None = None
    average: float | None = None


@dataclass(frozen=True)
class ControlRun:
    """A run whose joint is to be controlled.

    Its `rests` are the readings [m] at which the logs show the joint at rest; None where they show no two wells.
    """

    run: RunFolder
    prototype: Prototype
    model: HybridModel
    name: str
    artifact: str
    rests: tuple[float, float] | None = None

    @property
    def plant(self) -> ControlledJoint:
        """The identified joint and the rests that its logs show."""
        return plant_of(self.model, self.rests)

    @property
    def places(self) -> tuple[float, float, float]:
        """Left rest, unstable equilibrium and right rest [m]."""
        left, saddle, right = (equilibrium.q for equilibrium in wells_and_saddle(self.plant))
        return left, saddle, right

    @property
    def origin(self) -> dict[str, str]:
        """The artifact that holds the model, and the hash of its content."""
        return {self.artifact: self.run.record(self.artifact).content_hash}

    @property
    def limit(self) -> float:
        """Largest voltage [V] that was trained and that the film stands."""
        return float(min(self.model.joint.largest_voltage, device(self.prototype).voltage_limit))

    def highest(self, settings: ControlSettings) -> float:
        """Largest voltage [V].

        Raises
        ------
        InputError
            It lies outside the trained range, or above what the film stands.
        """
        wanted = self.limit if settings.max_voltage is None else settings.max_voltage
        if wanted <= 0.0:
            raise InputError(f"--max-voltage {wanted:g} V: give a voltage above 0")
        self.check_voltages("--max-voltage", wanted)
        return min(wanted, self.limit)

    def check_voltages(self, option: str, *voltages: float) -> None:
        """Refuse voltages [V] that were not trained or that the film does not stand; 1 % above passes, as users round.

        Raises
        ------
        InputError
            Names `option` and the limit that is passed.
        """
        trained = self.model.joint.largest_voltage
        for volts in voltages:
            if not 0.0 <= volts <= _ROUNDED * trained:
                raise InputError(f"{option} {volts:g} V: outside the trained range, 0 to {trained:.0f} V")
            if volts > _ROUNDED * self.limit:
                raise InputError(
                    f"{option} {volts:g} V: above the {self.limit:.0f} V that the film stands, field_limit times "
                    "film_thickness in [plant]"
                )

    @property
    def records(self) -> tuple[str, ...]:
        """The artifacts that hold the measured voltages of the training logs."""
        return tuple(layout.record(role, log) for role, log, _ in layout.logs(self.prototype) if role == "train")

    def converters(self, settings: ControlSettings) -> tuple[Converters, str]:
        """The converters as given, measured in the training logs or assumed, and which of these.

        If the logs show the lag of one side only, both sides have it.
        """
        if settings.lag is not None:
            return Converters((settings.lag, settings.lag), GIVEN, highest=self.limit), "given"
        tables = [self.run.read_table(name) for name in self.records]
        left, right = (converter_lag([(table["t"], table[v]) for table in tables]) for v in ("v1", "v2"))
        given = [side for side in (left, right) if side is not None]
        if not given:
            return Converters((ASSUMED_LAG, ASSUMED_LAG), DATA_SHEET, highest=self.limit), "assumed"
        lags = ((left or given[0]).lag, (right or given[0]).lag)
        spread = max(_LEAST_SPREAD, *(side.scatter for side in given))
        counts = " and ".join(str(side.steps if side else 0) for side in (left, right))
        return Converters(lags, spread, highest=self.limit), f"from {counts} voltage steps of the training logs"


def control_run(root: Path) -> ControlRun:
    """The identified joint of a run.

    Raises
    ------
    InputError
        The run holds no identified joint with two membranes.
    DataRefusedError
        Its validation refuses the model.
    """
    run = RunFolder.open(root)
    prototype = run.prototype
    name, artifact = model_artifact(run, prototype, joint_beside(run))
    model = load_run_model(run, prototype, name)
    if not isinstance(model, HybridModel):
        plant = device(prototype)
        advice = "name the model 'hybrid' first in [identify] models"
        if not plant.joint:
            angle = plant.displacement.symbol == "rad" and len(plant.inputs) > 1
            advice = "of a joint measure q itself, not its angle" if angle else "it is for joints with two membranes"
        raise InputError(f"{root}: its model is {name!r}; control needs the joint's equations: {advice}")
    if model.joint.angle:
        raise InputError(f"{root}: {ANGLE_IS_READ.format(name=name, what='controllers', way_out='measure q')}")
    logs = [log_of(run.read_table(layout.kinematics(role, log))) for role, log, _ in layout.logs(prototype)]
    wells = wells_of(logs, plant=JOINT)
    rests = (wells.left, wells.right) if isinstance(wells, Wells) else None
    _refuse_bad_model(run, name, model, _MISSED * (rests[1] - rests[0]) if rests else _UNSEEN)
    return ControlRun(run, prototype, model, name, artifact, rests)


def _refuse_bad_model(run: RunFolder, name: str, model: HybridModel, limit: float) -> None:
    if (missed := float(model.diagnostics.get("training_rms_m", 0.0))) > limit:
        raise DataRefusedError(
            f"{run.root}: the model {name} misses its training data by {1e3 * missed:.1f} mm; control on it would be a "
            f"guess (limit {1e3 * limit:.1f} mm); see `debist show {shell_word(run.root)}`"
        )
    for failed in failed_validations(run, name):
        raise DataRefusedError(
            f"{run.root}: {failed}; control on it would be a guess (limit {100.0 * WORST:.0f} %); see `debist show "
            f"{shell_word(run.root)}`"
        )


def kept_document(
    root: Path,
    title: str,
    settings: Mapping[str, Any],
    observer: Observer,
    work: Callable[[ControlRun, OnProgress], dict[str, Any]],
) -> dict[str, Any]:
    """Result of `work`, kept in the run as ``control/TITLE.json`` until the model or the settings change.

    Parameters
    ----------
    root : Path
        Run folder.
    title : str
        Title of the document.
    settings : mapping
        Settings that decide it beside the model.
    observer : Observer
        Receives what happens.
    work : callable
        Computes the document.
    """
    with run_lock(root):
        joint_run = control_run(root)
        name = layout.control(title)

        def write(run: RunFolder, on_progress: OnProgress) -> dict[str, Written]:
            """Find out and write the document."""
            findings = work(joint_run, on_progress)
            document = json.dumps(findings, indent=1, allow_nan=False, default=lambda value: value.tolist())
            return {name: run.write_text(name, document + "\n", {})}

        task = Task(
            stage="control",
            title=title,
            algorithm=ALGORITHM,
            settings=settings,
            inputs=(joint_run.artifact, *joint_run.records),
            outputs=(name,),
            work=write,
            reports=True,
        )
        bring_up_to_date(joint_run.run, [task], observer)
        return joint_run.run.read_document(name)
