"""What a person tries with a finished run: studies, folds, excitation, control, the paper's figures."""
