"""The equations of each kind of model, as kernels that are translated into other languages."""
