"""What a run reveals of its logs, instruments and models, as findings; one module writes their sentences."""
