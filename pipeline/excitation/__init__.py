"""Voltage sequences that tell as much as possible about a joint."""
