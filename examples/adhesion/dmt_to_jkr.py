r"""
From DMT to JKR
===============

How far do surfaces attract each other? If that is little against how far the attraction stretches them, JKR holds and a
ball comes off at :math:`-\tfrac32\pi wR`; if it is much, DMT, at :math:`-2\pi wR`. Tabor's parameter decides which, and
Maugis' equations connect both.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import Elastic, Foundation, HalfSpace, Paraboloid
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.loading.loads import Force
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.model_choice import which_model
from winkler.problems.adhesion.pull_off import PullOff
from winkler.problems.adhesion.tabor import maugis_parameter

RADIUS, WORK = 1e-6, 0.05
polymer = HalfSpace.between(Elastic(young=2e9, poisson=0.4))
bed = Foundation(Paraboloid(curvature_radius=RADIUS), polymer)
pull = np.pi * WORK * RADIUS

# %%
# The pull-off
# ------------

strengths = np.geomspace(0.2e6, 2000e6, 40)
parameters = np.array(
    [maugis_parameter(curvature_radius=RADIUS, modulus=polymer.modulus, work=WORK, strength=s) for s in strengths]
)
forces = np.array([PullOff(bed, Dugdale(WORK, s)).solve().force for s in strengths]) / pull

figure, (limits, radii) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
limits.semilogx(parameters, forces, color="C0", label="Maugis")
limits.axhline(-2.0, color="0.6", linestyle="--")
limits.axhline(-1.5, color="0.6", linestyle="--")
limits.text(parameters[0], -1.98, "DMT")
limits.text(parameters[-1], -1.52, "JKR", ha="right", va="top")
limits.set(xlabel=r"Maugis' parameter $\lambda$", ylabel=r"pull-off force / $\pi w R$", ylim=(-2.05, -1.4))
assert np.isclose(forces[0], -2.0, atol=5e-3)
assert np.isclose(forces[-1], -1.5, atol=2e-3)

# %%
# Contact radius against force
# ----------------------------

load = np.linspace(-1.45, 4.0, 200) * pull
for strength, colour in ((2e6, "C1"), (30e6, "C2"), (300e6, "C3")):
    law = Dugdale(WORK, strength)
    least = PullOff(bed, law).solve().force
    given = np.linspace(0.9999 * least, 4.0 * pull, 200)
    contact = AdhesiveIndentation(bed, law, Force(given)).solve()
    number = maugis_parameter(curvature_radius=RADIUS, modulus=polymer.modulus, work=WORK, strength=strength)
    radii.plot(given / pull, contact.radius * 1e9, color=colour, label=rf"$\lambda$ = {number:.2g}")
    limits.plot(number, least / pull, "o", color=colour)
jkr = AdhesiveIndentation(bed, ShortRange(WORK), Force(load)).solve()
radii.plot(load / pull, jkr.radius * 1e9, "k--", linewidth=0.9, label="JKR")
radii.set(xlabel=r"force / $\pi w R$", ylabel="contact radius a [nm]", ylim=(0, None))
radii.legend(frameon=False)
plt.show()

# %%
# Which one to take?
# ------------------
# Forces between molecules act over some 0.3 nm. `which_model` computes what each model would be wrong by, recommends
# the simplest that is good enough, and gives its reasons.

law = Dugdale(work=WORK, strength=WORK / 0.3e-9)
chosen = []
for name, young in (("polymer", 2e9), ("diamond", 1140e9)):
    found = which_model(Foundation(Paraboloid(20e-9), HalfSpace.between(Elastic(young, 0.3))), law)
    print(f"\nA tip of 20 nm on {name}: {found.model}")
    chosen.append(found.model)
    for note in found.notes:
        print(" ", note)
assert chosen == ["Maugis", "DMT"]
