"""Every law of the joint once, in CasADi, and what writes `pipeline.generated` from them; for developers only."""
