"""Models from trajectories: RBF curves, friction, least squares, observer homotopy, and how far to trust them."""
