"""What the RBF models are compared with: SINDy, NARX, a gated recurrent unit."""
