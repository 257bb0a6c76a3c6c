r"""
Layers that slide, and a laminate
=================================

A layer that is not bonded to what lies below it slides there, if it is lubricated, swollen or only laid on. A layered
crystal is a hundred times softer against shear between its sheets than against stretching them. Both change how stiff
a contact is, and both are layers of a `StackedHalfSpace`.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# Bonded, or sliding
# ------------------
# A stiff layer on a soft base carries a narrow contact like a plate. Where it slides, the base does not hold its lower
# face back. Where both have the same modulus, what is left is the effect of the cut alone.

a = np.geomspace(0.02, 10.0, 40)  # in thicknesses of the layer
base = wk.Elastic(young=1.0, poisson=0.3)
left_figure, axes = plt.subplots(figsize=(5.8, 4.0), layout="constrained")
for contrast in (0.1, 1.0, 10.0):
    solid = wk.Elastic(young=contrast, poisson=0.3)
    bonded, slides = (
        wk.StackedHalfSpace([wk.StackLayer(solid, 1.0, bonded=held)], on=base).punch_stiffness(a)
        for held in (True, False)
    )
    ratio = slides / bonded
    axes.semilogx(a, ratio, label=f"layer / base = {contrast:g}")
    assert np.all(ratio < 1.0)
    widest = a[np.argmin(ratio)]
    print(f"layer / base = {contrast:g}: at least {np.min(ratio):.3f} of the stiffness, at a / h = {widest:.2g}")
axes.set(
    xlabel="contact radius / thickness", ylabel="stiffness, sliding / bonded", xlim=(a[0], a[-1]), ylim=(0.8, 1.02)
)
axes.legend(frameon=False)

# %%
# A flake of graphite on glass
# ----------------------------
# Five constants describe graphite. Taken for an isotropic solid with the same contact modulus, the flake has the right
# stiffness in narrow contacts only: waves in it reach far down, since it hardly resists shear between its sheets.

graphite = wk.TransverselyIsotropic(c11=1060e9, c12=180e9, c13=15e9, c33=36.5e9, c44=4.5e9)
glass = wk.Elastic(young=70e9, poisson=0.2)
flake = wk.StackedHalfSpace([wk.StackLayer(graphite, 1e-6)], on=glass)
alike = wk.Elastic(young=flake.modulus * (1 - 0.2**2), poisson=0.2)
isotropic = wk.StackedHalfSpace([wk.StackLayer(alike, 1e-6)], on=glass)
narrow = np.geomspace(0.02e-6, 10e-6, 40)
flake_figure, axes = plt.subplots(figsize=(5.8, 4.0), layout="constrained")
for medium, name in ((flake, "graphite"), (isotropic, "isotropic, the same contact modulus")):
    axes.semilogx(narrow * 1e6, medium.punch_stiffness(narrow) / (2 * medium.modulus * narrow), label=name)
axes.set(xlabel="contact radius (µm)", ylabel="stiffness / that of a thick flake", xlim=(0.02, 10))
axes.legend(frameon=False)
assert np.isclose(flake.modulus, isotropic.modulus)

# %%
# Under a ball
# ------------
# Pressed by a ball on a layer that slides: no shear passes the interface, where the stress from bending is greatest.

layer = wk.Elastic(young=10.0, poisson=0.3)
stress_figure, axes = plt.subplots(figsize=(5.8, 4.0), layout="constrained")
z = np.concatenate([np.linspace(0.05, 1.0, 16), np.linspace(1.0 + 1e-9, 2.0, 12)])
for held in (True, False):
    stack = wk.StackedHalfSpace([wk.StackLayer(layer, 1.0, bonded=held)], on=base)
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(5.0), stack), wk.Radius(0.5)).solve()
    inside = wk.restore(contact, np.full(z.shape, 0.0), z)
    axes.plot(inside.radial_stress / contact.mean_pressure, z, label="bonded" if held else "sliding")
axes.axhline(1.0, color="0.7", linewidth=1)
axes.set(xlabel="radial stress on the axis / mean pressure", ylabel="depth / thickness", ylim=(2, 0))
axes.legend(frameon=False)
plt.show()
