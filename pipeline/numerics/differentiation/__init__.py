"""Velocity and acceleration of a record: differentiators behind one signature, their parameter, their noise."""
