"""
A roller dents its track
========================

A hard roller is pressed into a track of steel, let go and pressed again.  Beyond the load of first yield a dent stays;
unloading and reloading are elastic on it, up to the greatest load so far.
"""

import numpy as np

import winkler as wk
from winkler.plot import draw

track = wk.Elastic(young=210e9, poisson=0.3, strength=600e6)
bed = wk.LineFoundation(wk.Paraboloid(curvature_radius=20e-3), wk.HalfSpace(track, wk.Elastic(210e9, 0.3)))
path = wk.LineForce(np.array([2e6, 0.0, 2e6, 4e6, 0.0]))
pressed = wk.LinePlasticIndentation(bed, path).solve()

print(
    f"yields from {pressed.yield_force / 1e6:.3f} kN/mm on; the dent is {pressed.residual_depth[-1] * 1e6:.1f} um deep"
)
print(f"mean pressure under 4 kN/mm: {pressed.mean_pressure[3] / track.strength:.2f} times the strength")
print(f"lost: {pressed.dissipation[-1]:.1f} J/m")
assert pressed.half_width[2] == pressed.half_width[0]
draw(pressed)
