"""The only code that touches artifacts: schemas, atomic files, Parquet, HDF5, hashes, manifest, lock."""
