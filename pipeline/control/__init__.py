"""Control of an identified joint: linear models, pulses, switching map, observer, controller."""
