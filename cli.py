"""The command `debist` of a checkout: `python cli.py`."""

from pipeline.commands.app import app, debist

__all__ = ["app", "debist"]

if __name__ == "__main__":
    app(prog_name="debist")
