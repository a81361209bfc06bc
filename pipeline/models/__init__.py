"""Models of the joint: a folder for each, one interface for all (`base.DynamicModel`).

So the same code simulates and scores every model. `model_type` has how a model is fitted, read and exported, `choose`
which model a device gets, and `model_file` what its file holds. `polynomial_dynamics` is the right-hand side of SINDy
and NARX.
"""
