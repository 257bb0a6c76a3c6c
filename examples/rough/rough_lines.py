r"""
A rough square and a rough ball
===============================

No surface is known, only its power spectrum. Independent springs under random heights with the spectrum
:math:`C_1 = \pi q C` tell how stiff such surfaces are as a rule, and how far single ones lie apart; under a ball the
same roughness makes the first contact softer, and is pressed flat later on.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

steel = wk.HalfSpace.between(wk.Elastic(young=210e9, poisson=0.3), wk.Elastic(young=210e9, poisson=0.3))
blasted = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=10e-6)

# %%
# A square millimetre
# -------------------
# All loads follow from one sort of the heights of a line, so fifty lines cost nothing.

forces = np.geomspace(0.1, 1000.0, 40)
square = wk.RoughContact(blasted, steel, side=1e-3, load=wk.Force(forces), realisations=50).solve()

# %%
# A rough ball
# ------------
# The same roughness on a ball of 50 mm, beside the smooth one.

ball = wk.Foundation(wk.Paraboloid(curvature_radius=50e-3), steel)
rough = wk.RoughIndentation(blasted, ball, length=4e-3, load=wk.Force(forces), realisations=50).solve()
smooth = wk.Indentation(ball, wk.Force(forces)).solve()

figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 4.0), layout="constrained", sharey=True)
left.fill_between(forces, *(square.stiffness_band / 1e6), alpha=0.3, label="eight squares of ten")
left.loglog(forces, square.stiffness / 1e6, label="median")
left.loglog(forces[:20], 8.0 * (forces[:20] / forces[5]) ** (1.0 / 1.8), "k--", label="$F^{1/(1+H)}$")
left.set(xlabel="force [N]", ylabel="stiffness [N/µm]", title="a rough square")
right.fill_between(forces, *(rough.stiffness_band / 1e6), alpha=0.3, label="eight rough balls of ten")
right.loglog(forces, rough.stiffness / 1e6, label="median")
right.loglog(forces, smooth.stiffness / 1e6, "k--", label="smooth ball")
right.set(xlabel="force [N]", title="a rough ball")
for axes in (left, right):
    axes.legend(frameon=False)
plt.show()

for force, ratio in zip(forces[::13], (rough.stiffness / smooth.stiffness)[::13], strict=True):
    print(f"{force:7.1f} N: the rough ball is {ratio:.2f} times as stiff as the smooth one")
