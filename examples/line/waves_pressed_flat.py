r"""
Waves pressed flat
==================

A milled, turned or corrugated surface touches in strips side by side. Under the nominal pressure :math:`\bar p` the
strips of a wave :math:`h\,(1-\cos 2\pi x/\lambda)` are as wide as Westergaard (1939) found,

.. math:: \bar p = p^*\sin^2\frac{\pi a}\lambda , \qquad p^* = \frac{\pi E^*h}\lambda ,

and at :math:`p^*` the surfaces close.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Strips and the gaps between them
# --------------------------------
# Steel on steel, waves of 1 um amplitude, 1 mm long.

AMPLITUDE, PITCH = 1e-6, 1e-3
steel = wk.Elastic(young=210e9, poisson=0.3)
pair = wk.HalfSpace.between(steel, steel)
waves = wk.LineFoundation(wk.Wavy(amplitude=AMPLITUDE, wavelength=PITCH), pair)
half = wk.PeriodicIndentation(waves, PITCH, wk.HalfWidth(PITCH / 4)).solve()
print(f"half of the surface touches at {half.nominal_pressure / 1e6:.1f} MPa, all of it at", end=" ")
print(f"{half.closure_pressure / 1e6:.1f} MPa")
assert np.isclose(half.closure_pressure, np.pi * pair.modulus * AMPLITUDE / PITCH, rtol=1e-12)
assert np.isclose(half.nominal_pressure, 0.5 * half.closure_pressure, rtol=1e-12)

draw(half)

# %%
# Round valleys close, sharp ones do not
# --------------------------------------
# A second, shorter wave makes the crests narrower and the valleys flatter. Ridges of cylinders, as left by a ball-nose
# cutter, meet in sharp valleys, which no pressure closes.

crests = {
    "waves": waves.profile,
    "with a second wave": waves.profile + wk.Wavy(amplitude=0.1 * AMPLITUDE, wavelength=PITCH / 2),
    "ridges of cylinders": wk.Paraboloid(curvature_radius=PITCH**2 / (16 * AMPLITUDE)),
}
pressures = np.linspace(1e6, 450e6, 40)
figure, axes = plt.subplots(layout="constrained")
for name, profile in crests.items():
    bed = wk.LineFoundation(profile, pair)
    pressed = wk.PeriodicIndentation(bed, PITCH, wk.NominalPressure(pressures)).solve()
    axes.plot(pressures / 1e6, 100 * pressed.contact_share, label=name)
    print(f"{name}: closed at {pressed.closure_pressure / 1e6:.0f} MPa")
axes.set(xlabel="nominal pressure [MPa]", ylabel="in contact [%]", xlim=(0, 450), ylim=(0, 105))
axes.legend(frameon=False)
plt.show()
