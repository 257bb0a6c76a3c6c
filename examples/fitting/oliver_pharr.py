"""
Hardness and modulus from an unloading curve
============================================

Oliver and Pharr read modulus and hardness from the slope with which a nanoindenter comes out. The tip may be anything
that winkler knows as a profile, or the calibrated area function of a blunt Berkovich tip, of which the area at the
contact depth is all that is needed.

The test is played by closed forms: two partial unloadings, a hold at the peak that creeps, the last unloading with the
exponent 3/2. So its modulus is known, and the reading can be checked.
"""

import math

import numpy as np

import winkler as wk
from winkler.plot import draw

diamond = wk.Elastic(young=1141e9, poisson=0.07)
tip = wk.CalibratedArea((24.5, 0.4e-6), shallowest=50e-9, deepest=1e-6)

# %%
# The test: three loadings to 10 mN, the last one held for 10 s
# -------------------------------------------------------------

peak, deepest, final = 10e-3, 330e-9, 180e-9
ramp = np.linspace(0.0, 1.0, 300)
forces, depths = [], []
for low, high in ((0.0, 0.3), (0.03, 0.6), (0.06, 1.0)):
    part = low + (high - low) * ramp
    most = np.maximum(part, 10.0 * low)  # below the peak before, the unloading is gone back
    forces += [part]
    depths += [320e-9 * np.sqrt(most) * (0.55 + 0.45 * (part / np.maximum(most, 1e-9)) ** (2.0 / 3.0))]
    if high < 1.0:
        part = high * (1.0 - 0.9 * ramp[1:])
        forces += [part]
        depths += [320e-9 * math.sqrt(high) * (0.55 + 0.45 * (part / high) ** (2.0 / 3.0))]
forces += [np.ones(300), 1.0 - ramp[1:]]
depths += [deepest - 10e-9 * np.exp(-ramp / 0.2), final + (deepest - final) * (1.0 - ramp[1:]) ** (2.0 / 3.0)]
force, depth = peak * np.concatenate(forces), np.concatenate(depths)
noisy = force + 1e-3 * peak * np.random.default_rng(2).standard_normal(force.size)
frame = 2e6  # its compliance is 0.5 nm/mN
curve = wk.ForceCurve(depth + force / frame, noisy, frame, time=np.linspace(0.0, 60.0, force.size), name="fused silica")

# %%
# Its segments are found
# ----------------------
#
# Nothing in the curve says where it was held. Where segments are found wrongly, ``curve.with_segments`` states them.

for segment in curve.segments:
    print(f"{segment.kind.value:18s} points {segment.first:4d} to {segment.last:4d}")

# %%
# The reading
# -----------

found = wk.OliverPharr(curve, tip).solve()
stiffness = 1.5 * peak / (deepest - final)
contact = deepest - 0.75 * peak / stiffness
truth = 0.5 * math.sqrt(math.pi / tip.area(contact)) * stiffness
young = wk.sample_young(found.modulus, 0.17, diamond)
share = found.standard_errors[5] / found.modulus
print(
    f"peak {found.force * 1e3:.2f} mN at {found.depth * 1e9:.1f} nm, contact depth {found.contact_depth * 1e9:.1f} nm"
)
print(f"reduced modulus {found.modulus * 1e-9:.2f} GPa (standard error {share:.2%}), true {truth * 1e-9:.2f}")
print(
    f"Young's modulus {young * 1e-9:.2f} GPa, hardness {found.hardness * 1e-9:.2f} GPa, exponent {found.exponent:.3f}"
)
assert abs(found.modulus / truth - 1.0) < 0.02

# %%
# How far it can be trusted
# -------------------------

for note in found.validity:
    print(f"{note.standing.value}: {note.statement}")

draw(found)
