"""From an identified joint to control: linear models, pulses, switching map, observer, controller."""
