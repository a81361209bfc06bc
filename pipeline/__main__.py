"""`python -m debist` where it is installed, `python -m pipeline` in a checkout."""

from .commands.app import app

app(prog_name="debist")
