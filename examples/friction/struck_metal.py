"""
A ball strikes metal
====================

A steel ball of 10 mm falls on plates of three strengths.  Up to the velocity at which a plate yields it comes back with
all of its velocity; beyond, what the dent has taken is lost.
"""

import numpy as np

import winkler as wk
from winkler.plot import draw

BALL = wk.Elastic(young=210e9, poisson=0.3)
MASS, RADIUS = 4.1e-3, 5e-3
velocity = np.geomspace(5e-3, 5.0, 40)


def bed(strength):
    """The ball on a plate of this strength."""
    plate = wk.Elastic(young=210e9, poisson=0.3, strength=strength)
    return wk.Foundation(wk.Paraboloid(curvature_radius=RADIUS), wk.HalfSpace(plate, BALL))


struck = {strength: wk.PlasticImpact(bed(strength), MASS, velocity).solve() for strength in (300e6, 800e6, 2e9)}
for strength, solution in struck.items():
    at = np.interp([0.1, 1.0], velocity, solution.restitution)
    print(
        f"{strength / 1e6:5.0f} MPa: yields from {solution.yield_velocity * 1e3:7.2f} mm/s on; "
        f"e = {at[0]:.3f} at 0.1 m/s, {at[1]:.3f} at 1 m/s"
    )
draw(struck[800e6])

# %%
# One blow of them: the force over the depth, and the dent.  The ball that falls there again, not faster, meets the dent
# and finds it elastic.

blow = wk.PlasticImpact(bed(800e6), MASS, 1.0).solve()
print(f"{blow.greatest_force:.0f} N for {blow.duration * 1e6:.1f} us, a dent {blow.residual_depth * 1e6:.2f} um deep")
again = wk.Indentation(blow.dented, wk.Force((1.0 - 1e-9) * blow.greatest_force)).solve()
print(f"pressed back to {blow.greatest_force:.0f} N it stores {again.energy / blow.energy:.3f} of what it gave back")
draw(blow)
