r"""
Where a pressed body yields first
=================================

Below a smooth ball yielding begins half a contact radius down. Below one whose surface is wavy, it begins under the
crests: there the pressure is higher, and reaches less deep. `SurfaceContact` knows the pressure of every pixel, and the
stresses below are the sum of what the pixels make, each in closed form.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# A ball, smooth and wavy
# -----------------------

steel = wk.Elastic(young=210e9, poisson=0.3, strength=1.2e9)
pair = wk.HalfSpace.between(steel, steel)
PIXELS, SIDE, RADIUS = 128, 0.6e-3, 10e-3
x = (np.arange(PIXELS) + 0.5) / PIXELS * SIDE
ball = -((x[:, None] - SIDE / 2) ** 2 + (x - SIDE / 2) ** 2) / (2.0 * RADIUS)
waves = 0.3e-6 * np.cos(2.0 * np.pi * (x - SIDE / 2) / 75e-6)
contacts = {
    name: wk.SurfaceContact(wk.Topography(heights, [SIDE, SIDE]), pair, wk.Force(100.0)).solve()
    for name, heights in (("smooth", ball), ("wavy", ball + waves))
}
for name, contact in contacts.items():
    spot = contact.greatest_stress()
    print(f"{name}: {spot.value / 1e6:.0f} MPa at a depth of {spot.z * 1e6:.1f} um; {contact.validity[-1].statement}")

# %%
# Hertz's ball is met: 0.620 times his greatest pressure, 0.481 contact radii down.

hertz = wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), pair), wk.Force(100.0)).solve()
smooth = contacts["smooth"].greatest_stress()
print(f"depth over contact radius: {smooth.z / hertz.radius:.3f}")
assert np.isclose(smooth.z / hertz.radius, 0.481, atol=2e-3)

# %%
# On a plane across the waves
# ---------------------------

depths = np.linspace(2e-6, 0.25e-3, 60)
figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.4), layout="constrained", sharey=True)
for axis, (name, contact) in zip(axes, contacts.items(), strict=True):
    below = contact.stresses_on_plane(depths, x=SIDE / 2)
    filled = axis.contourf(below.y * 1e6, below.z * 1e6, below.von_mises / 1e6, levels=12)
    axis.set(title=name, xlabel="y [µm]")
    figure.colorbar(filled, label="von Mises stress [MPa]")
axes[0].set_ylabel("depth [µm]")
axes[0].invert_yaxis()
plt.show()

# %%
# The ball slides
# ---------------
# The tractions of a contact that slides are friction times pressure. With them the greatest stress rises and comes
# nearer to the surface.

pressed = contacts["smooth"].surface_load
slid = wk.SurfaceLoad(pressed.pressure, pressed.lengths, 0.2 * pressed.pressure)
sliding = wk.MapStress(slid, steel).solve()
print(f"sliding: {sliding.von_mises / 1e6:.0f} MPa at a depth of {sliding.z * 1e6:.1f} um")
assert sliding.von_mises > smooth.value
draw(sliding)
