"""What uses the results of the stages and changes none: studies, folds, plots, exports, inspection, design."""
