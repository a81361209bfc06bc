"""Units at the edges, and quantities for readers."""
