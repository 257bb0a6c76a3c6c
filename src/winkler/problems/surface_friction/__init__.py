"""Friction on contacts of any shape: stick and slip of height maps along any history, by boundary elements."""
