"""What the identified models are compared with: SINDy, NARX, a gated recurrent unit."""
