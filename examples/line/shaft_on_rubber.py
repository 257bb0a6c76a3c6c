r"""
A shaft on a rubber pad
=======================

A shaft is put on a rubber pad, lies there for a minute, and is lifted. While the strip of contact widens it follows the
load that crept (Lee and Radok 1960),

.. math:: w(a(t)) = \int_0^t C(t-t')\,\frac{\mathrm dP}{\mathrm dt'}\,\mathrm dt' ,

and on the way back each part of the pressure comes to nothing at the edge (Ting 1966). How much wider is the strip on
the way down, and what does a pad lose that is pressed again and again?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# On, and off
# -----------
# A pad with three relaxation times under a shaft of 20 mm radius.

rubber = wk.Prony(1e6, np.full(3, 1e6), np.array([0.1, 2.0, 40.0]))
pad = wk.LineFoundation(wk.Paraboloid(curvature_radius=20e-3), wk.ViscoelasticHalfSpace(rubber))
path = wk.LineForcePath([0.0, 1.0, 61.0, 62.0], [0.0, 500.0, 500.0, 0.0], count=30)
lifted = wk.LineViscoelasticIndentation(pad, path).solve()

# %%
# While it widens, the strip is as wide as under the load that crept on a body of a modulus of one.

crept = lifted.crept_load[1:61]
assert np.allclose(lifted.half_width[1:61], np.sqrt(4 * 20e-3 * crept / np.pi), rtol=1e-12)

draw(lifted)

# %%
# Pressures
# ---------
# At once the pressure is nearly an ellipse. What was pressed first relaxes first, so that the pressure becomes flatter;
# on the way back the strip is wide, and its pressure low.

figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
for index, name in ((15, "on, half of the force"), (60, "held for a minute"), (75, "off, half of the force")):
    state = lifted.at(index)
    x = 1.1 * state.half_width * np.linspace(-1.0, 1.0, 401)
    axes.plot(1e3 * x, 1e-3 * state.pressure(x), label=name)
axes.set(xlabel="x [mm]", ylabel="pressure [kPa]", title="a shaft on rubber")
axes.legend(frameon=False)

# %%
# Again and again
# ---------------
# A pad 50 mm thick on a rigid base. How far shaft and base come together, and what is lost, has a meaning only for a
# body with a base: a half-plane would sink without bound.

base = wk.PlateBase(thickness=50e-3)
figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
for period in (0.1, 1.0, 10.0):
    cycles = wk.LineForcePath([0.0, 0.5 * period, period], [100.0, 500.0, 100.0], cycles=20, count=20)
    shaken = wk.LineViscoelasticIndentation(pad, cycles).solve()
    approach, last = shaken.approach(base), slice(-41, None)
    lost = np.ptp(shaken.work_per_length(base)[[-41, -1]])
    axes.plot(1e3 * approach[last], shaken.force_per_length[last], label=f"{period:g} s, {1e3 * lost:.1f} mJ/m")
axes.set(xlabel="approach [mm]", ylabel="force per length [N/m]", title="the twentieth cycle, and what it loses")
axes.legend(frameon=False)
plt.show()
