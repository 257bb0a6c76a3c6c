r"""
A worn tread rolls
==================

The contact of a wheel on a rail is an ellipse only as long as both are new. A tread that has worn hollow bears on both
sides of its middle. Boundary elements roll what is no ellipse, with Coulomb's law in each pixel: material slips, while
the bodies roll by :math:`\Delta x`, by the rigid slip less what its displacement grows meanwhile,

.. math:: s(x) = w\,\Delta x - u(x) + u(x+\Delta x) .
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
LOAD, FRICTION = wk.Force(80e3), wk.Coulomb(0.3)

# %%
# A new wheel
# -----------
# Its radii and those of the rail make an ellipse. Creepages from where nearly all sticks to sliding:

wheel = wk.CurvedBodies(longitudinal_curvature_radius=0.46, lateral_curvature_radius=0.3)
new = wk.SampledProfile([18e-3, 14e-3], wheel, (72, 56))
creepage = wk.Creepage(longitudinal=np.geomspace(1e-4, 6e-3, 10))
pulled = wk.SurfaceRolling(new, steel, LOAD, FRICTION, creepage).solve()
for creep, force, share in zip(pulled.longitudinal_creepage, pulled.saturation, pulled.stick_share, strict=True):
    print(f"creepage {100 * creep:.3f} %: {force:.3f} of the friction, {100 * share:.0f} % sticks")

draw(wk.SurfaceRolling(new, steel, LOAD, FRICTION, wk.Creepage(longitudinal=1e-3, spin=0.2)).solve())

# %%
# A worn one
# ----------
# Ten micrometres were worn off in the middle of the tread, which is now hollow across the rolling.

y = (np.arange(56) - 27.5) * new.pixel[1]
worn = wk.Topography(new.heights - 10e-6 * np.exp(-((y / 2.5e-3) ** 2)), new.lengths)
hollow = wk.SurfaceRolling(worn, steel, LOAD, FRICTION, creepage).solve()
draw(wk.SurfaceRolling(worn, steel, LOAD, FRICTION, wk.Creepage(longitudinal=1e-3, spin=0.2)).solve())

# %%
# It starts
# ---------
# Under half of the friction the new wheel creeps at once, and settles after about two lengths of the contact.

begun = wk.SurfaceRollingStart(new, steel, LOAD, FRICTION, wk.ShearForce(12e3), distance=30e-3).solve()
first, last = 100 * begun.longitudinal_creepage[1], 100 * begun.longitudinal_creepage[-1]
print(f"creepage {first:.3f} % at first, {last:.3f} % then")
draw(begun)

# %%
# Creep curves of both, and simplified theory
# -------------------------------------------
# Simplified theory knows the new one only.

simple = wk.SimplifiedRolling(wheel, steel, FRICTION, creepage, LOAD).solve()
assert np.max(np.abs(simple.saturation - pulled.saturation)) < 0.06
figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
for name, curve, look in (("new", pulled, "o-"), ("worn hollow", hollow, "s-"), ("new, simplified", simple, "--")):
    axes.plot(100 * np.asarray(curve.longitudinal_creepage), curve.saturation, look, label=name)
axes.set(xlabel="creepage [%]", ylabel="creep force over friction", title="creep curves")
axes.legend(frameon=False)
plt.show()
