"""The run folder, and the only code that touches artifacts: schemas, files, manifest, hashes, lock, recipes."""
