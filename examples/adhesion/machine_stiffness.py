r"""
The machine decides when it comes off
=====================================

Weights tear a sticky ball off at :math:`-\tfrac32\pi wR`, stiff grips at :math:`-\tfrac56\pi wR`: the contact is the
same, the machine is not. The cantilever of a force microscope lies between. And a softer cantilever loses more energy
in the jump, because its own spring snaps back.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import Depth, Elastic, Foundation, HalfSpace, Paraboloid
from winkler.laws.adhesion import ShortRange
from winkler.problems.adhesion.cycle import AdhesiveCycle

RADIUS, WORK = 2e-6, 0.04
gel = HalfSpace.between(Elastic(young=0.5e6, poisson=0.5))
bed = Foundation(Paraboloid(curvature_radius=RADIUS), gel)
law = ShortRange(WORK)
pull = np.pi * WORK * RADIUS

# %%
# Three cantilevers
# -----------------
# The far end of the cantilever moves by 3 µm in and far enough out to tear it off.

figure, (curves, limits) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
for stiffness, colour in ((0.1, "C0"), (1.0, "C1"), (np.inf, "C2")):
    far = 3e-6 + 2.0 * pull / stiffness
    path = np.concatenate([np.linspace(-far, 3e-6, 1500), np.linspace(3e-6, -far, 3000)])
    touch = AdhesiveCycle(bed, law, Depth(path), stiffness).solve()
    name = "stiff grips" if np.isinf(stiffness) else f"{stiffness} N/m"
    curves.plot(touch.position * 1e6, touch.force / pull, color=colour, label=name)
    snap, tear = touch.jumps
    print(f"{name:12s} pull-off {tear.before.force / pull:.4f} pi w R, lost there {tear.loss * 1e15:.3f} fJ")
curves.set(xlabel="position of the far end D [µm]", ylabel=r"force F / $\pi w R$", xlim=(-5, 3.2), ylim=(-1.8, 2.0))
curves.legend(frameon=False)

# %%
# From dead weights to stiff grips
# --------------------------------

stiffness = np.geomspace(1e-3, 1e3, 60)
tears = []
for k in stiffness:
    far = 20 * (WORK**2 * RADIUS / gel.modulus**2) ** (1 / 3) + 2.0 * pull / k
    tears.append(AdhesiveCycle(bed, law, Depth([far, -far]), k).solve().jumps[-1])
force = np.array([jump.before.force for jump in tears]) / pull
limits.semilogx(stiffness, force, color="C3")
for level, name in ((-1.5, "dead weight, -3/2"), (-5 / 6, "stiff grips, -5/6")):
    limits.axhline(level, color="0.6", linestyle="--")
    limits.text(1e-3, level + 0.02, name)
limits.set(xlabel=r"stiffness of the machine $k_m$ [N/m]", ylabel=r"pull-off force / $\pi w R$", ylim=(-1.6, -0.7))
plt.show()
assert np.isclose(force[0], -1.5, atol=2e-3)
assert np.isclose(force[-1], -5 / 6, atol=2e-3)
assert np.all(np.diff(force) > 0.0)
