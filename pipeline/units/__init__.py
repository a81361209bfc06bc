"""Units at the edges, and quantities as people read them."""
