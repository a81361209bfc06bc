"""Every model behind one interface (`base.Model`), so that all are simulated and scored by the same code."""
