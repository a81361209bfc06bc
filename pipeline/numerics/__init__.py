"""Mathematics that knows nothing of joints or logs: arrays, linear algebra, total variation, error measures."""
