"""What the identified models are compared with: SINDy and NARX."""
