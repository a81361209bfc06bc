"""Mathematics without joints or logs: arrays, linear algebra, total variation, error measures."""
