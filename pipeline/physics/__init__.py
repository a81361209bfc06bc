"""The analytical model of the bistable joint (section 3 of the paper); pure: parameters and arrays in, arrays out."""
