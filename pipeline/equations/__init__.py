"""Every equation of the joint once, in CasADi, and the writer of `pipeline.generated`; for developers only."""
