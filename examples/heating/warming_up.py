r"""
How long does a contact take to warm up?
========================================

A finger that begins to rub, a brake pad that touches: the flux of heat is there at once, the temperature is not. At
first heat only flows inwards, and the temperature grows as the root of time, point by point. Later it also spreads, and
the contact settles, slowly: after the time :math:`a^2/\kappa` a spot has three quarters of its last temperature, and
after ten of them it still lacks a tenth.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# A glass ball of 5 mm is rubbed slowly on a steel plate. Both are at rest as far as heat is concerned: sliding is so
# slow that heat spreads much faster than the contact moves.

glass, steel = wk.Elastic(young=70e9, poisson=0.22), wk.Elastic(young=210e9, poisson=0.3)
bed = wk.Foundation(wk.Sphere(curvature_radius=5e-3), wk.HalfSpace(steel, glass))
plate = wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)
ball = wk.ThermalConductor(conductivity=1.0, diffusivity=0.5e-6)
pair = wk.HeatConductors(first=plate, second=ball)
time = np.geomspace(1e-6, 10.0, 57)
pressed = wk.Indentation(bed, wk.Force(10.0))
start = wk.TransientHeating(pressed, wk.Coulomb(0.5), pair, speed=2e-3, time=time).solve()
settling = start.contact.radius**2 / plate.diffusivity
print(f"{start.heat_rate * 1e3:.1f} mW on a radius of {start.contact.radius * 1e6:.0f} um: in the end")
print(f"{start.stationary_temperature:.3f} K, of which half is reached after")
print(f"{np.interp(0.5 * start.stationary_temperature, start.flash_temperature, time) * 1e3:.2f} ms")
draw(start)

# %%
# Who takes the heat?
# -------------------
# At first the effusivities :math:`\lambda/\sqrt\kappa` decide, in the end the conductivities. The share that makes
# the temperatures of both surfaces agree goes from the one to the other; the solution says that it takes it at every
# time as if it had always been so.

figure, axes = plt.subplots(figsize=(5.6, 3.8), layout="constrained")
axes.semilogx(time / settling, start.first_share, color="C0")
effusivity = [body.conductivity / np.sqrt(body.diffusivity) for body in (plate, ball)]
axes.axhline(effusivity[0] / sum(effusivity), color="0.5", linewidth=0.9, linestyle="--")
axes.axhline(45.0 / 46.0, color="0.5", linewidth=0.9, linestyle=":")
axes.set(xlabel=r"time over $a^2/\kappa$ of the plate [-]", ylabel="part of the heat for the plate [-]")
plt.show()

# %%
# Check
# -----
# With one body alone the early law is that of a plane, :math:`T = 2q\sqrt{\kappa t/\pi}/\lambda`.

alone = wk.TransientHeating(
    pressed, wk.Coulomb(0.5), pair, speed=2e-3, time=[1e-4 * settling], partition=wk.FixedShare(1.0)
).solve()
flux = 0.5 * 2e-3 * wk.restore(alone.contact, 0.0).pressure
assert np.isclose(alone.flash_temperature[0], 2.0 * flux * np.sqrt(12e-6 * 1e-4 * settling / np.pi) / 45.0, rtol=1e-3)
assert np.all(np.diff(start.flash_temperature) > 0.0)
assert effusivity[0] / sum(effusivity) < start.first_share[0] + 1e-3
