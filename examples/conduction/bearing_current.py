r"""
Currents through bearings
=========================

Currents of electric drives flow through the rolling elements of bearings where the film of lubricant breaks down. How
much resistance do the contacts have? A ball touches its raceway on an ellipse, a roller along a strip.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.special import ellipk

import winkler as wk
from winkler.plot import draw

# %%
# A ball: Holm's ellipse
# ----------------------
# The constriction of an ellipse is that of the disc of the same stiffness (Barber), so `Constriction` takes an
# `EllipticFoundation`. With the larger semi-axis :math:`\alpha` and :math:`m=1-\beta^2/\alpha^2` it is Holm's
# :math:`R = \frac{\rho_1+\rho_2}{2\pi\alpha}K(m)`; a thin film of oxide counts by the area :math:`\pi\alpha\beta`.

steel, conductor = wk.Elastic(young=208e9, poisson=0.3), wk.ElectricalConductor(resistivity=0.22e-6)
pair = wk.ElectricalConductors(conductor, conductor, film=wk.SurfaceFilm(area_resistance=1e-12))
medium = wk.HalfSpace.between(steel, steel)
bodies = wk.CurvedBodies(longitudinal_curvature_radius=3.4e-3, lateral_curvature_radius=90e-3)
ball = wk.Constriction(wk.Indentation(wk.EllipticFoundation(bodies, medium), wk.Force(100.0)), pair).solve()
pressed = wk.EllipticIndentation(bodies, medium, wk.Force(100.0)).solve()
short, long = sorted((pressed.longitudinal_semi_axis, pressed.lateral_semi_axis))
holm = 0.44e-6 / (2.0 * np.pi * long) * ellipk(1.0 - (short / long) ** 2)
print(f"ellipse {short * 1e6:.0f} by {long * 1e6:.0f} um: {ball.resistance * 1e3:.3f} mOhm")
assert np.isclose(ball.constriction, holm, rtol=0.01)  # the film spreads the current a little
assert np.isclose(ball.film_resistance, 1e-12 / (np.pi * short * long), rtol=0.01)

# %%
# A roller: per length, and between stated points
# -----------------------------------------------
# Current that converges on an endless strip costs more and more with the distance: there is no resistance without the
# depths of the points between which it is counted, here the half of the roller and of the ring.

roller = wk.LineFoundation(wk.Paraboloid(curvature_radius=4.2e-3), medium)
loads = wk.LineForce(np.geomspace(1e3, 200e3, 7))
strip = wk.LineConstriction(wk.LineIndentation(roller, loads), pair, first_depth=5e-3, second_depth=4e-3).solve()
for force, width, resistance in zip(loads.force_per_length, strip.half_width, strip.resistance_per_length, strict=True):
    print(f"{force / 1e3:6.1f} N/mm on {2e6 * width:6.1f} um: {resistance / 10e-3 * 1e6:5.1f} uOhm over 10 mm")
assert np.allclose(
    strip.first_constriction_per_length, 0.22e-6 / np.pi * np.log(2.0 * 5e-3 / strip.half_width), rtol=1e-3
)

draw(strip)
plt.show()
