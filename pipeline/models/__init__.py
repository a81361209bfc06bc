"""Every model behind one interface (`base.DynamicModel`), so that all are simulated and scored by the same code."""
