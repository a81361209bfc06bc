"""Pure numerics: arrays in, arrays and frozen results out; no files, no tables, no printing."""
