r"""
Snap-in and pull-off: the energy of one touch
=============================================

A glass ball touches soft rubber and is pulled off again, held in stiff grips. The moment the surfaces meet, the contact
jumps open; on the return it holds beyond the place where it was made, then jumps shut. The area between the branches
is lost. In units of :math:`(w^5 R^4/E^{*2})^{1/3}` it is 7.0922, whatever the ball and the rubber.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import Depth, Elastic, Foundation, HalfSpace, Paraboloid
from winkler.laws.adhesion import ShortRange
from winkler.loading.loads import Radius
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.adhesion.indentation import AdhesiveIndentation

RADIUS, WORK = 5e-3, 0.05
rubber = HalfSpace.between(Elastic(young=1.5e6, poisson=0.5), Elastic(young=70e9, poisson=0.2))
bed = Foundation(Paraboloid(curvature_radius=RADIUS), rubber)
law = ShortRange(WORK)

# %%
# One touch
# ---------
# The path needs its turning points only; more points draw a smoother curve, and change no number.

path = 1e-6 * np.concatenate([np.linspace(-4, 6, 400), np.linspace(6, -5, 400)])
touch = AdhesiveCycle(bed, law, Depth(path)).solve()
snap_in, pull_off = touch.jumps
unit = (WORK**5 * RADIUS**4 / rubber.modulus**2) ** (1 / 3)
for name, jump in (("snap-in", snap_in), ("pull-off", pull_off)):
    print(
        f"{name:9s} at {jump.before.depth * 1e6:7.3f} um loses {jump.loss * 1e9:.3f} nJ = {jump.loss / unit:.6f} units"
    )
print(f"together {touch.dissipation[-1] / unit:.6f} units; the machine has spent {touch.work[-1] / unit:.6f}")
assert np.isclose(touch.dissipation[-1] / unit, 7.092195972, rtol=1e-9)
assert np.isclose(snap_in.loss / unit, 6.418315112, rtol=1e-9)

# %%
# The curve of equilibrium below it
# ---------------------------------
# Every contact radius has one depth and one force. Grips that hold the depth cannot follow the curve where it bends
# back: the dashed part is never measured.

radius = np.geomspace(2e-6, 1.05 * touch.radius.max(), 500)
states = AdhesiveIndentation(bed, law, Radius(radius)).solve()

figure, (forces, radii) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
forces.plot(states.depth * 1e6, states.force * 1e3, "--", color="0.6", label="equilibrium")
forces.plot(touch.depth[:400] * 1e6, touch.force[:400] * 1e3, color="C0", label="approach")
forces.plot(touch.depth[400:] * 1e6, touch.force[400:] * 1e3, color="C1", label="retraction")
for jump, colour in ((snap_in, "C0"), (pull_off, "C1")):
    forces.plot(jump.before.depth * 1e6, jump.before.force * 1e3, "o", color=colour)
    forces.plot(jump.after.depth * 1e6, jump.after.force * 1e3, "o", color=colour, markerfacecolor="white")
forces.set(xlabel="depth d [µm]", ylabel="force F [mN]", xlim=(-4, 6), ylim=(-1.35, 1.2))
forces.legend(frameon=False)
radii.plot(touch.depth[:400] * 1e6, touch.radius[:400] * 1e6, color="C0")
radii.plot(touch.depth[400:] * 1e6, touch.radius[400:] * 1e6, color="C1")
radii.set(xlabel="depth d [µm]", ylabel="contact radius a [µm]")
plt.show()

# %%
# Where the energy is
# -------------------
# Until the jumps nothing is lost: what the machine spends is stored. Each jump loses a part at once.

figure, axes = plt.subplots(figsize=(7.0, 3.6), layout="constrained")
step = np.arange(path.size)
axes.plot(step, touch.work / unit, label="spent by the machine")
axes.plot(step, touch.energy / unit, label="stored")
axes.plot(step, touch.dissipation / unit, label="lost")
axes.set(xlabel="step of the path", ylabel=r"energy / $(w^5R^4/E^{*2})^{1/3}$", ylim=(-13, 13))
axes.legend(frameon=False)
plt.show()
