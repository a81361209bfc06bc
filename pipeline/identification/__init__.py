"""Models from trajectories: RBF curves, friction, least squares, observer homotopy, and what the data excite."""
