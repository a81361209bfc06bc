"""The settings of a prototype: a strict TOML file."""
