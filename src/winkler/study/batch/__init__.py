"""Solving the points of a study or the curves of a fit: one after the other, in parallel, resumed after a stop."""
