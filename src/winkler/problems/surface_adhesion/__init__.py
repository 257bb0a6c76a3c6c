"""Adhesion of height maps: approach and retraction with snap-in, pull-off and the energy they cost."""
