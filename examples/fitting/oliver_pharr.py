"""
Hardness and modulus from an unloading curve
============================================

Oliver and Pharr read modulus and hardness from the slope with which a nanoindenter comes out. The tip may be anything
that winkler knows as a profile, here the calibrated area function of a blunt Berkovich tip.

The unloading is computed for an elastic body, fused silica, so that the reading can be judged: how far is the modulus
off because the tip is neither a cone nor a paraboloid?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.fitting.contact_reading import sample_young
from winkler.fitting.curve import ForceCurve
from winkler.fitting.oliver_pharr import OliverPharr

silica, diamond = wk.Elastic(young=72e9, poisson=0.17), wk.Elastic(young=1141e9, poisson=0.07)
tip = wk.AreaFunction((24.5, 0.4e-6))
bed = wk.Foundation(tip, wk.HalfSpace.between(silica, diamond))

# %%
# The unloading, with a scatter of a thousandth, over a frame of 0.5 nm/mN
# --------------------------------------------------------------------------

depth = np.linspace(300e-9, 2e-9, 800)
force = wk.Indentation(bed, wk.Depth(depth)).solve().force
noisy = force + 1e-3 * force[0] * np.random.default_rng(2).standard_normal(force.size)
frame = 2e6
curve = ForceCurve(depth + force / frame, noisy, machine_stiffness=frame, name="fused silica")

# %%
# The reading
# -----------

found = OliverPharr(curve, tip).solve()
young = sample_young(found.modulus, silica.poisson, diamond)
share = found.standard_errors[5] / found.modulus
print(f"stiffness {found.stiffness * 1e-3:.2f} kN/m, contact depth {found.contact_depth * 1e9:.1f} nm")
print(
    f"reduced modulus {found.modulus * 1e-9:.2f} GPa (standard error {share:.2%}), true {bed.medium.modulus * 1e-9:.2f}"
)
print(
    f"Young's modulus {young * 1e-9:.2f} GPa, hardness {found.hardness * 1e-9:.2f} GPa, exponent {found.exponent:.3f}"
)
assert abs(found.modulus / bed.medium.modulus - 1.0) < 0.02

figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
axes.plot(curve.depth(0.0) * 1e9, curve.force * 1e3, ".", color="0.6", markersize=3, label="unloading")
along = np.linspace(found.final_depth, found.depth, 200)
power = ((along - found.final_depth) / (found.depth - found.final_depth)) ** found.exponent
axes.plot(along * 1e9, found.force * power * 1e3, "C0", label="power law")
touch = found.depth - found.force / found.stiffness
axes.plot([touch * 1e9, found.depth * 1e9], [0.0, found.force * 1e3], "C1--", label="stiffness S")
axes.axvline(found.contact_depth * 1e9, color="C2", linewidth=0.8, label="contact depth")
axes.set(xlabel="depth [nm]", ylabel="force [mN]")
axes.legend(frameon=False)
plt.show()
