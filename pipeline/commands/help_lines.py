"""Help of command groups: the commands in the order of the work, each with its whole first line."""

from typing import Any

from typer.core import TyperGroup

ORDER = (
    "demo", "init", "inspect", "check", "run",
    "ingest", "differentiate", "identify", "validate", "compare", "report",
    "show", "plot", "status", "verify", "repair", "sign", "diff",
    "batch", "study", "export", "paper", "control", "rig", "physics",
)  # fmt: skip


class WholeLines(TyperGroup):
    """A command group whose help cuts no line."""

    def list_commands(self, ctx: Any) -> list[str]:
        """The commands in the order of the work; those that it does not name come last, as they were added."""
        names = super().list_commands(ctx)
        return sorted(names, key=lambda name: ORDER.index(name) if name in ORDER else len(ORDER))

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the name of each command and the first line of its help, wrapped to the terminal."""
        commands = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        rows = [(name, _first_line(command.help or "")) for name, command in commands if command and not command.hidden]
        if rows:
            with formatter.section("Commands"):
                formatter.write_dl(rows)


def _first_line(text: str) -> str:
    return " ".join(text.strip().partition("\n\n")[0].split()).removesuffix(".")
