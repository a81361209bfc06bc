"""The laws of the joint, each written once, symbolically; developers only."""
