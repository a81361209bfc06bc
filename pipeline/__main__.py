"""`python -m debist` where it is installed, `python -m pipeline` in a checkout."""

from .commands.app import app

if __name__ == "__main__":
    app(prog_name="debist")
