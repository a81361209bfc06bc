"""debist in a checkout: the public names of the package `pipeline`, which is called `debist` where it is installed."""

from pipeline import __all__, __dir__, __getattr__, __version__, main  # noqa: F401 - passed on when they are used

if __name__ == "__main__":  # python -m debist
    main()
