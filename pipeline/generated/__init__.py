"""Compiled right-hand sides and Jacobians, written by `pipeline.codegen`; not edited."""
