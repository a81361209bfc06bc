"""A polynomial NARX: `narx`."""
