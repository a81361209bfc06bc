"""Identified models and runs in the forms that other tools read."""
