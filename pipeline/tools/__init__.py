"""Uses of the stages' results, which they do not change: studies, folds, plots, exports, inspection, design."""
