r"""
An ellipse that slides along its short or its long axis
=======================================================

A crowned roller, a wheel on a rail, the ball of a bearing in its groove: the contact is an ellipse, and how warm it
gets depends on the direction in which it slides. Slid along the short axis the surface is under the heat for a short
time only, and stays cooler than slid along the long one.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# One direction
# -------------
# A crowned roller, with the radius 8 mm along x and 200 mm across, slides on a disc of steel with 5 m/s, at 30 degrees
# to its short axis x. The roller rests against the contact; the disc moves past it.

steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(steel, steel)
conductor = wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)
pair = wk.HeatConductors(conductor, conductor)
crowned = wk.CurvedBodies(longitudinal_curvature_radius=8e-3, lateral_curvature_radius=200e-3)
law, load = wk.Coulomb(0.1), wk.Force(300.0)
pressed = wk.EllipticIndentation(crowned, medium, load)


def slid(direction, speed=5.0):
    """Return the solution of the disc that moves in a direction [rad]."""
    return wk.FrictionHeating(pressed, law, pair, first_speed=speed, first_direction=direction).solve()


skew = slid(np.radians(30.0))
long, short = skew.contact.lateral_semi_axis, skew.contact.longitudinal_semi_axis
print(f"semi-axes {short * 1e6:.0f} and {long * 1e6:.0f} um, {skew.heat_rate:.0f} W, Pe = {skew.first_peclet:.0f}")
print(f"flash temperature {skew.flash_temperature:.0f} K; {skew.first_share:.0%} of the heat go into the disc")
draw(skew)

# %%
# All directions
# --------------
# A round contact of the same stiffness, `EllipticFoundation`'s, would have one temperature. At high speed
# temperature grows with the root of the length that is passed under the heat.

degrees = np.linspace(0.0, 90.0, 19)
flash = [slid(np.radians(each)).flash_temperature for each in degrees]
rested = [slid(np.radians(each), 0.01).flash_temperature * 500.0 for each in degrees]
equal = wk.Foundation(wk.Paraboloid(crowned.equivalent_radius), medium)
ball = wk.Indentation(equal, load)
round_flash = wk.FrictionHeating(ball, law, pair, first_speed=5.0).solve().flash_temperature
print(f"short axis {flash[0]:.0f} K, long axis {flash[-1]:.0f} K, round contact {round_flash:.0f} K")
assert flash[0] < round_flash < flash[-1]
assert np.ptp(rested) < 0.01 * rested[0]

figure, axes = plt.subplots(figsize=(5.6, 3.6), layout="constrained")
axes.plot(degrees, flash, "C3", label="ellipse")
axes.axhline(round_flash, color="C0", ls="--", label="round contact of the same stiffness")
axes.set(xlabel="direction of sliding from the short axis [degrees]", ylabel="flash temperature [K]", ylim=(0.0, None))
axes.legend(frameon=False)
plt.show()
