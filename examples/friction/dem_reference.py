"""
Reference traces for a discrete element code
============================================

What a code that moves a hundred thousand grains does at every contact can be checked against exact answers: a ball that
is pressed in, one that is sheared to and fro, one that strikes obliquely, and a grain of powder that yields. Each is
written to a file that says all conventions in words, so that signs and effective moduli need not be guessed.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

RADIUS = 1e-3
FRICTION = 0.3
glass = wk.HalfSpace.between(wk.Elastic(young=70e9, poisson=0.22), wk.Elastic(young=70e9, poisson=0.22))
bed = wk.Foundation(wk.Paraboloid(curvature_radius=RADIUS), glass)
holder = tempfile.TemporaryDirectory()  # put your own folder here
folder = Path(holder.name)

# %%
# Four traces
# -----------
# The first three are exact within their theory, and have no grid. The fourth is an engineering law; before it yields,
# its adhesion is that of Johnson, Kendall and Roberts.

depth = 1e-6
full = FRICTION * depth * glass.modulus / glass.shear_modulus  # the shift at which all slides
shift = np.concatenate([np.linspace(0, 0.8, 21), np.linspace(0.8, -0.8, 41), np.linspace(-0.8, 0.8, 41)]) * full
mass = 2500.0 * 4.0 / 3.0 * np.pi * RADIUS**3

traces = {
    "normal_loading": wk.Indentation(bed, wk.Depth(np.linspace(0.0, depth, 51))).solve(),
    "mindlin_loop": wk.Tangential(
        bed, wk.Coulomb(FRICTION), wk.Path(np.arange(float(shift.size)), wk.Depth(depth), wk.Shift(shift))
    ).solve(),
    "oblique_impact": wk.Impact(
        bed,
        wk.Coulomb(FRICTION),
        mass=mass,
        velocity=0.1,
        lateral_velocity=0.08,
        inertia=0.4 * mass * RADIUS**2,
        lever=RADIUS,
    ).solve(),
    "powder_grain": wk.ElasticPlasticParticle(
        2e-6,
        wk.Elastic(young=1e9, poisson=0.3, strength=20e6),
        wk.Depth(np.concatenate([np.linspace(0.0, 100e-9, 101), np.linspace(100e-9, 20e-9, 401)])),
        work_opening=0.1,
    ).solve(),
}
for name, solution in traces.items():
    for ending in (".csv", ".yaml"):
        wk.write_trace(solution, folder / f"{name}{ending}")
print((folder / "mindlin_loop.csv").read_text(encoding="utf-8")[:1500])

# %%
# A hundred contacts with one memory each
# ---------------------------------------
# The same loop for a hundred contacts at once, by rows of 32 springs, as a code would do it step by step. None of them
# creates energy, whatever its history; what is lost is the heat of each contact.

many = 100
contacts = wk.Contacts.apart(glass, curvature_radius=np.full(many, RADIUS), coefficient=FRICTION, reach=depth)
contacts = contacts.moved(np.full(many, depth))
scale = np.linspace(0.1, 1.2, many)
motion = np.zeros((many, shift.size, 2))
motion[:, :, 0] = scale[:, np.newaxis] * np.diff(shift, prepend=0.0)
contacts, trace = contacts.along(np.full((many, shift.size), depth), motion=motion)

loop = traces["mindlin_loop"]
like = int(np.argmin(np.abs(scale - 1.0)))
print(f"heat of the loop        {loop.dissipation[-1]:.4e} J by the exact solver")
print(f"of the contact like it  {contacts.dissipation[like]:.4e} J by its springs")
assert np.all(np.diff(trace.dissipation, axis=1) >= 0.0)

# %%
# A thousand balls that strike
# ----------------------------
# The tangential velocity after an oblique impact, from nearly straight to glancing ones: those of Maw, Barber and
# Fawcett, where slow sliding is turned back and fast sliding is not.

sliding = np.zeros((1000, 2))
sliding[:, 0] = np.linspace(0.0, 7.0, 1000) * FRICTION * 0.1 * glass.modulus / glass.shear_modulus
thrown = wk.BallImpacts(glass, RADIUS, FRICTION, mass, 3.5 / mass, 0.1, sliding).solve()
print(f"energy is conserved to  {np.max(np.abs(thrown.balance - 1.0)):.1e}")

# %%
# In pictures
# -----------

figure, axes = plt.subplots(2, 2, figsize=(9.0, 7.0), layout="constrained")
axes[0, 0].plot(loop.shift * 1e6, loop.shear_force, label="exact")
mine = trace.shear_force[like, ::4, 0]
axes[0, 0].plot(np.cumsum(motion[like, :, 0])[::4] * 1e6, mine, "o", fillstyle="none", label="one of a hundred")
axes[0, 0].set(xlabel="shift [µm]", ylabel="shear force [N]", title="sheared to and fro")
axes[0, 0].legend(frameon=False)

struck = traces["oblique_impact"]
axes[0, 1].plot(struck.time * 1e6, struck.force * FRICTION, "--", label="friction times normal force")
axes[0, 1].plot(struck.time * 1e6, struck.shear_force, label="shear force")
axes[0, 1].set(xlabel="time [µs]", ylabel="force [N]", title="an oblique impact")
axes[0, 1].legend(frameon=False)

grain = traces["powder_grain"]
axes[1, 0].plot(grain.depth * 1e9, grain.force * 1e6)
axes[1, 0].axhline(0.0, color="0.7", linewidth=0.8)
axes[1, 0].set(xlabel="depth [nm]", ylabel="force [µN]", title="a grain that yields, and sticks")

axes[1, 1].plot(sliding[:, 0], thrown.sliding_velocity[:, 0])
axes[1, 1].axhline(0.0, color="0.7", linewidth=0.8)
axes[1, 1].set(xlabel="sliding before [m/s]", ylabel="sliding after [m/s]", title="a thousand impacts")
