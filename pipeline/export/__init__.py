"""The identified model for other tools."""
