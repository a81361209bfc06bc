"""Many prototypes: each in a process of its own, then the tables and the page of the fleet."""
