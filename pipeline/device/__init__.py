"""The device: units, action of the inputs, mass and limits by the settings; parameter sets of the joint."""
