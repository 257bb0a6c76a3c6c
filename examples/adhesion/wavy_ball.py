"""
A wavy ball sticks better: Guduru's staircase
=============================================

A ball with concentric waves on it comes off in many small jumps, one for each wave, and each of them loses energy. So a
rough surface can hold more firmly than a smooth one: the force is higher, and so is the work of taking it apart.
Guduru found it in theory and, with Bull, in gelatine.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import Depth, Elastic, Foundation, HalfSpace, Paraboloid, Radius, Wavy
from winkler.laws.adhesion import ShortRange
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.adhesion.indentation import AdhesiveIndentation

RADIUS, WORK = 0.23, 8.0  # gelatine is soft and sticky
gelatine = HalfSpace.between(Elastic(young=28e3, poisson=0.5))
law = ShortRange(WORK)
smooth = Paraboloid(curvature_radius=RADIUS)
wavy = smooth + Wavy(amplitude=0.12e-3, wavelength=6e-3)

# %%
# Both balls, pressed in and pulled off
# -------------------------------------

top = 7e-3
path = np.concatenate([np.linspace(-1e-3, top, 1500), np.linspace(top, -5e-3, 3000)])
touches = {}
for name, body in (("smooth", smooth), ("wavy", wavy)):
    touch = AdhesiveCycle(Foundation(body, gelatine), law, Depth(path)).solve()
    touches[name] = touch
    print(
        f"{name:7s} {len(touch.jumps):3d} jumps, pull-off {touch.force.min():8.3f} N, "
        f"lost in the cycle {touch.dissipation[-1] * 1e3:7.3f} mJ"
    )
assert len(touches["smooth"].jumps) == 2
assert len(touches["wavy"].jumps) > 10
assert touches["wavy"].force.min() < touches["smooth"].force.min()
assert touches["wavy"].dissipation[-1] > touches["smooth"].dissipation[-1]

# %%
# The staircase
# -------------
# Grey: all states of equilibrium, explicit in the contact radius. Loading and unloading take different steps.

radius = np.linspace(0.3e-3, 1.02 * touches["wavy"].radius.max(), 4000)
states = AdhesiveIndentation(Foundation(wavy, gelatine), law, Radius(radius)).solve()

figure, (forces, radii) = plt.subplots(1, 2, figsize=(11.0, 4.4), layout="constrained")
forces.plot(states.depth * 1e3, states.force, color="0.8", linewidth=0.8, label="equilibrium of the wavy ball")
forces.plot(touches["smooth"].depth * 1e3, touches["smooth"].force, color="C0", label="smooth")
forces.plot(touches["wavy"].depth * 1e3, touches["wavy"].force, color="C1", label="wavy")
forces.set(xlabel="depth d [mm]", ylabel="force F [N]", xlim=(-5, 7.2), ylim=(1.15 * touches["wavy"].force.min(), 12))
forces.legend(frameon=False, loc="upper left")
radii.plot(states.depth * 1e3, radius * 1e3, color="0.8", linewidth=0.8)
for name, colour in (("smooth", "C0"), ("wavy", "C1")):
    radii.plot(touches[name].depth * 1e3, touches[name].radius * 1e3, color=colour)
radii.set(xlabel="depth d [mm]", ylabel="contact radius a [mm]", xlim=(-5, 7.2))
plt.show()

# %%
# What each step costs
# --------------------

figure, axes = plt.subplots(figsize=(7.0, 3.6), layout="constrained")
for advancing, name in ((True, "closing"), (False, "opening")):
    chosen = [jump for jump in touches["wavy"].jumps if (jump.after.radius > jump.before.radius) == advancing]
    axes.plot(
        [jump.before.radius * 1e3 for jump in chosen],
        [jump.loss * 1e3 for jump in chosen],
        "o-",
        label=name,
        linewidth=0.8,
    )
axes.set(xlabel="contact radius before the jump [mm]", ylabel="energy lost [mJ]", ylim=(0, None))
axes.legend(frameon=False)
plt.show()

# %%
# Is it one disc?
# ---------------
# Between the edge and the next wave the surfaces must not meet; the solution checks that of its widest contact.

for note in touches["wavy"].validity:
    print(note)
