"""
A ball dents a plate
====================

A hard ball is pressed into mild steel, let go and pressed again.  Beyond 0.5 N the plate yields; unloading and
reloading are elastic on the dent, up to the greatest load so far.
"""

import winkler as wk
from winkler.plot import draw

mild_steel = wk.Elastic(young=210e9, poisson=0.3, strength=300e6)
ball = wk.Elastic(young=210e9, poisson=0.3)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=5e-3), wk.HalfSpace(mild_steel, ball))
pressed = wk.PlasticIndentation(bed, wk.Force([100.0, 0.0, 100.0, 150.0, 0.0])).solve()

print(f"yields from {pressed.yield_force:.2f} N on; the dent is {pressed.residual_depth[-1] * 1e6:.2f} um deep")
print(f"mean pressure under 150 N: {pressed.mean_pressure[3] / mild_steel.strength:.2f} times the strength")
print(f"lost: {pressed.dissipation[-1] / pressed.work[3]:.0%} of the work")
draw(pressed)

# %%
# The dent is a profile like any other: what is pressed, pulled, sheared or heated on it is another problem on its bed.

again = wk.Indentation(pressed.dented, wk.Force(100.0)).solve()
back = pressed.depth[2] - pressed.residual_depth[2]
print(f"100 N press by {again.depth * 1e6:.2f} um on the last dent, by {back * 1e6:.2f} um on the first")

# %%
# Turned round: the load that leaves a dent of one micrometre, and the strength that a dent of a known load tells.

limit = wk.DentLimit(bed, residual_depth=1e-6).solve()
print(f"{limit.force:.1f} N leave a dent 1 um deep")
plate = wk.Foundation(wk.Paraboloid(curvature_radius=5e-3), wk.HalfSpace(ball, ball))
found = wk.StrengthFromDent(plate, wk.Force(150.0), wk.Radius(0.24e-3), dent_error=3e-6).solve()
print(f"a dent of 0.24 mm after 150 N: {found.strength / 1e6:.0f} +- {found.strength_error / 1e6:.0f} MPa")
