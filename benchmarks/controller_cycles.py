"""Instructions of an exported controller on Cortex-M processors, in double and in single precision.

`debist export RUN --to controller -o FOLDER`, then `python benchmarks/controller_cycles.py FOLDER`. Needs
``arm-none-eabi-gcc`` with newlib and ``qemu-arm`` (on Debian: gcc-arm-none-eabi, libnewlib-arm-none-eabi, qemu-user).
Each controller is compiled for the processor and run by qemu's user mode, an instruction at a time; the log of a run
has a line for each. Readings swing from the left well to the right one. Printed are the instructions of a step, the
bytes of code with constants, of the state and of the stack. Cycles are not counted: caches and flash decide them.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

CORES = {
    "Cortex-M4F": ("-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16"),
    "Cortex-M7": ("-mcpu=cortex-m7", "-mfpu=fpv5-d16"),
}
PRECISIONS = {"double": (), "single": ("-DDEBIST_CONTROLLER_SINGLE",)}
FEW, MANY = 2, 8  # steps of the two runs whose difference counts
MAIN = """
#include "controller.h"
static double state[1000];
static debist_controller_real v[2];
static const debist_controller_real shares[8] = {0, 0.02F, 0.1F, 0.25F, 0.45F, 0.7F, 0.9F, 1};
void _start(void)
{
    const debist_controller_real left = (debist_controller_real)LEFT, right = (debist_controller_real)RIGHT;
    debist_controller_init(state, left);
    for (int i = 0; i < STEPS; i++) debist_controller_step(state, left + shares[i] * (right - left), right, v);
    register int number __asm__("r7") = 1, code __asm__("r0") = !(v[0] + v[1] > 0);
    __asm__ volatile("svc 0" : : "r"(number), "r"(code));
    for (;;) ;
}
"""


def compiled(folder: Path, scratch: Path, steps: int, flags: list[str]) -> Path:
    """A program of some steps without an operating system's help."""
    header = (folder / "controller.h").read_text(encoding="utf-8")
    left, right = (re.search(rf"{side} (-?[\d.]+)", header)[1] for side in ("left", "right"))  # type: ignore[index]
    main, program = scratch / "main.c", scratch / f"steps-{steps}"
    main.write_text(MAIN, encoding="utf-8")
    given = [f"-DSTEPS={steps}", f"-DLEFT=({left}e-3)", f"-DRIGHT=({right}e-3)", f"-I{folder}", "-nostartfiles"]
    given += ["-Wl,-Ttext-segment=0x10000", str(main), str(folder / "controller.c"), "-o", str(program), "-lm"]
    subprocess.run(["arm-none-eabi-gcc", *flags, *given], check=True, cwd=scratch)
    return program


def instructions(program: Path) -> int:
    """Lines of the log of a run, one for each instruction; Thumb-2 code runs on any processor of the family."""
    log = program.with_suffix(".log")
    run = ["qemu-arm", "-cpu", "max", "-singlestep", "-d", "nochain,exec", "-D", str(log), str(program)]
    subprocess.run(run, check=True)
    with log.open("rb") as lines:
        count = sum(1 for _ in lines)
    log.unlink()
    return count


def main() -> None:
    folder = Path(sys.argv[1]).resolve()
    print(
        "| processor | precision | instructions a step | code, bytes | state, bytes | stack, bytes |\n"
        + 6 * "|---"
        + "|"
    )
    for core, chosen in CORES.items():
        for precision, more in PRECISIONS.items():
            flags = ["-O2", "-std=c99", "-mthumb", "-mfloat-abi=hard", *chosen, *more]
            with tempfile.TemporaryDirectory() as name:
                scratch = Path(name)
                few, many = (instructions(compiled(folder, scratch, steps, flags)) for steps in (FEW, MANY))
                source = str(folder / "controller.c")
                subprocess.run(["arm-none-eabi-gcc", *flags, "-fstack-usage", "-c", source], check=True, cwd=scratch)
                size = subprocess.run(
                    ["arm-none-eabi-size", "controller.o"], check=True, cwd=scratch, capture_output=True, text=True
                )
                frames = {line.split("\t")[0].rsplit(":", 1)[1]: int(line.split("\t")[1])
                          for line in (scratch / "controller.su").read_text().splitlines()}  # fmt: skip
            own = ("debist_controller_step", "control")
            stack = sum(frames.get(each, 0) for each in own) + max(v for each, v in frames.items() if each not in own)
            state = re.search(r"return (\d+) \* sizeof", Path(source).read_text(encoding="utf-8"))
            assert state is not None
            bytes_of_state = int(state[1]) * (4 if more else 8)
            print(
                f"| {core} | {precision} | {(many - few) / (MANY - FEW):,.0f} | {int(size.stdout.split()[6]):,} "
                f"| {bytes_of_state:,} | {stack:,} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
