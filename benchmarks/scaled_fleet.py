"""Joints of other sizes: the logs of a simulated fleet with every number scaled, and no drawing.

`python benchmarks/scaled_fleet.py FLEET -o SCALED`: FLEET is a folder of `debist rig fleet` (Parquet logs). Each joint
gets one of eight combinations in turn: lengths × 0.4 or 2.2, voltages × 0.35 or 2.5, times × 1.6 or 0.6, which is what
a dynamically similar joint would show. `debist batch SCALED -o RUNS --no-report` identifies them without `[plant]`.
"""

import argparse
import shutil
from itertools import product
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

LENGTHS, VOLTAGES, TIMES = (0.4, 2.2), (0.35, 2.5), (1.6, 0.6)


def scaled_log(source: Path, target: Path, factors: dict[str, float]) -> None:
    """The same log with each column multiplied; units and metadata stay."""
    table = pq.read_table(source)
    for place, field in enumerate(table.schema):
        values = np.asarray(factors[field.name] * table[field.name].to_numpy(), dtype=np.float64)
        table = table.set_column(place, field.with_type(pa.float64()), pa.array(values))
    pq.write_table(table, target)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fleet", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    given = parser.parse_args()
    sizes = list(product(LENGTHS, VOLTAGES, TIMES))
    for number, joint in enumerate(sorted(path.parent.parent for path in given.fleet.glob("*/truth/truth.json"))):
        length, volts, seconds = sizes[number % len(sizes)]
        folder = given.output / joint.name
        (folder / "truth").mkdir(parents=True)
        shutil.copyfile(joint / "truth/truth.json", folder / "truth/truth.json")
        factors = {"time": seconds, "Laser_q": length, "HV1_meas": volts, "HV2_meas": volts}
        for log in joint.glob("*.parquet"):
            scaled_log(log, folder / log.name, factors)
        settings = (joint / f"{joint.name}.toml").read_text(encoding="utf-8").partition("[plant]")[0]
        (folder / f"{joint.name}.toml").write_text(settings, encoding="utf-8")
        print(f"{joint.name}: lengths × {length}, voltages × {volts}, times × {seconds}")


if __name__ == "__main__":
    main()
