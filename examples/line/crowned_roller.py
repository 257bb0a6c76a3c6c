r"""
Which crown avoids the edge
===========================

A bearing roller of finite length presses hardest at its ends. If they are sharp the elastic pressure grows there
without bound; if the roller is tilted a little, the end that it leans on is worse still. A crown takes some
micrometres off towards the ends. Too weak, and the edge bears on; too strong, and the middle bears all.

The crown of Lundberg is the displacement that an even force per length :math:`P` would cause,

.. math:: z = -\frac P{\pi E^*}\ln\left(1-\frac{4x^2}{L^2}\right) ,

so that it presses evenly under the load that it was made for.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# One roller, four ends
# ---------------------
# A roller of 5 mm radius and 9.6 mm length on an inner ring of 26 mm radius, under 4 kN: the effective radius is
# 4.2 mm.

RADIUS, LENGTH, LOAD = 4.2e-3, 9.6e-3, 4e3
steel = wk.Elastic(young=208e9, poisson=0.3, strength=1.8e9)
pair = wk.HalfSpace.between(steel, wk.Elastic(208e9, 0.3))
even = LOAD / LENGTH
ends = {
    "sharp": wk.SharpEnds(),
    "rounded edges, 0.5 mm": wk.RoundedEnds(0.5e-3),
    "arc, 0.5 m": wk.CrownedEnds(0.5),
    "logarithmic": wk.LogarithmicEnds(even),
}
rollers = {name: wk.RollerContact(RADIUS, LENGTH, end, pair, wk.Force(LOAD)).solve() for name, end in ends.items()}
hertz = np.sqrt(even * pair.modulus / (np.pi * RADIUS))
for name, roller in rollers.items():
    print(
        f"{name:22} depth {roller.depth * 1e6:5.2f} um, middle {roller.middle_pressure / hertz:.3f} p0, "
        f"greatest {roller.peak_pressure / hertz:.3f} p0"
    )
assert np.isclose(rollers["logarithmic"].middle_pressure, hertz, rtol=0.01)
assert np.isinf(rollers["sharp"].peak_pressure)

figure, axes = plt.subplots(figsize=(7.0, 4.0), layout="constrained")
for name, roller in rollers.items():
    axes.plot(roller.last.x * 1e3, roller.last.pressure_along / hertz, label=name)
axes.axhline(1.0, color="0.6", linewidth=0.8)
axes.set(xlabel="place along the roller [mm]", ylabel="pressure / that of an endless cylinder [-]", ylim=(0.0, 3.0))
axes.legend(frameon=False)
plt.show()

# %%
# The arc presses like Hertz's ellipse as long as its ends do not touch.

ellipse = wk.EllipticIndentation(wk.CurvedBodies(0.5, RADIUS), pair, wk.Force(LOAD)).solve()
print(f"semi-axis along the roller: {ellipse.longitudinal_semi_axis * 1e3:.2f} mm, half of the length 4.8 mm")
arc = rollers["arc, 0.5 m"]
print(f"greatest pressure {arc.peak_pressure / 1e9:.3f} GPa, Hertz {ellipse.peak_pressure / 1e9:.3f} GPa")

# %%
# Tilted
# ------
# Fujiwara and Kawase let the crown drop more, :math:`K_1 > 1`, and keep the middle straight, :math:`K_2 < 1`. Under a
# tilt of 1 mrad:

made = wk.LogarithmicEnds(even, load_factor=2.5, crowned_share=0.6)
tilted = wk.RollerContact(RADIUS, LENGTH, made, pair, wk.Force(LOAD), wk.Tilt(1e-3)).solve()
print(f"\nmoment {tilted.moment:.2f} N m, greatest pressure {tilted.edge_factor:.2f} times that in the middle")
draw(tilted)

# %%
# Over the tilt
# -------------

tilts = np.linspace(0.0, 2e-3, 6)
figure, axes = plt.subplots(figsize=(7.0, 4.0), layout="constrained")
for name, end in {
    "logarithmic": ends["logarithmic"],
    "K1 = 2.5, K2 = 0.6": made,
    "arc, 0.5 m": ends["arc, 0.5 m"],
}.items():
    greatest = [
        wk.RollerContact(RADIUS, LENGTH, end, pair, wk.Force(LOAD), wk.Tilt(float(tilt)), 96).solve().peak_pressure
        for tilt in tilts
    ]
    axes.plot(tilts * 1e3, np.array(greatest) / 1e9, "o-", label=name)
axes.set(xlabel="tilt [mrad]", ylabel="greatest pressure [GPa]")
axes.legend(frameon=False)
plt.show()

# %%
# The notes state how good it is: the error of the grid, the half-space beyond the ends, and an estimate of yield.

for note in tilted.validity:
    print(note)
