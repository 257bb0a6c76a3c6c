r"""
What does it cost to violate an assumption?
===========================================

Every answer of winkler says what it assumes, and compares each assumption with a number. This page shows four of them:
what is lost, and where the answer begins to be called *approximate* and then *outside*. The whole list is in the
manual's page on validity.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.problems.assumptions.coupling import dundurs, stuck_stiffening
from winkler.problems.assumptions.inertia import wave_loss


def standing(notes, assumption):
    """Return the standing of what an answer says of an assumption."""
    return next(note.standing for note in notes if note.assumption is assumption)


# %%
# Range of attraction
# -------------------
# A ball of R = 1 um, with a constant attraction up to 0.3 nm (Maugis). JKR takes the range as nothing, DMT as so long
# that it deforms nothing. From Tabor's parameter of 0.1 to 5 neither is right.

RANGE, RADIUS, WORK = 0.3e-9, 1e-6, 0.05
tabor = np.geomspace(0.02, 30.0, 25)
moduli = np.sqrt(RADIUS * WORK**2 / (tabor * RANGE) ** 3)
true = []
for modulus in moduli:
    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(wk.Elastic(0.75 * modulus, 0.5)))
    true.append(-wk.PullOff(bed, wk.Dugdale(WORK, WORK / RANGE)).solve().force)
unit = np.pi * RADIUS * WORK
jkr, dmt = 1.5 * unit / np.array(true), 2.0 * unit / np.array(true)

# %%
# A film on something rigid
# -------------------------
# A gel of 5 um on glass under a bead of the same radius. Who fits Hertz' formula for a thick body finds a modulus that
# is too high by the ratio of the forces; from half the thickness on linear elasticity itself is no longer the theory.

gel, thickness = wk.Elastic(1e3, 0.49), 5e-6
film = wk.CoatedHalfSpace([wk.Layer(gel, thickness)], on=wk.Rigid())
share = np.linspace(0.01, 0.6, 25)
bead = wk.Paraboloid(5e-6)
on_glass = wk.Indentation(wk.Foundation(bead, film), wk.Depth(share * thickness)).solve()
thick = wk.Indentation(wk.Foundation(bead, wk.HalfSpace.between(gel)), wk.Depth(share * thickness)).solve()

# %%
# Friction between unlike bodies
# ------------------------------
# A rigid punch that sticks to a body of Poisson's ratio nu is stiffer than one without friction.

poisson = np.linspace(0.0, 0.5, 26)
stiffer = np.array([stuck_stiffening(dundurs(wk.Elastic(1.0, nu), wk.Rigid())) for nu in poisson])

# %%
# Waves of an impact
# ------------------
# A steel ball of 10 mm radius; Hunter's share of the energy that waves take away.

velocity = np.geomspace(1e-3, 1e3, 25)
steel = wk.Elastic(210e9, 0.3)
mass = 7850.0 * 4.0 / 3.0 * np.pi * 1e-6
modulus = wk.HalfSpace.between(steel, steel).modulus
lost = np.array([wave_loss(modulus=modulus, mass=mass, size=10e-3, velocity=v) for v in velocity])

# %%
# The four together
# -----------------
# White is asymptotic, light grey approximate, dark grey outside.

figure, ((a, b), (c, d)) = plt.subplots(2, 2, figsize=(10.0, 7.4), layout="constrained")
a.semilogx(tabor, jkr, label="JKR")
a.semilogx(tabor, dmt, label="DMT")
a.axhline(1.0, color="0.5", linewidth=0.8)
a.axvline(0.5, color="0.5", linestyle=":", linewidth=0.8)
a.text(0.6, 1.06, "JKR is outside to the left,\nDMT to the right", fontsize=9)
a.set(xlabel="Tabor parameter", ylabel="pull-off force / Maugis'", title="range of attraction")
a.legend(frameon=False)

b.axvspan(0.1, 0.5, color="0.92")
b.axvspan(0.5, 0.6, color="0.8")
b.plot(share, on_glass.force / thick.force, color="C2")
b.set(xlabel="depth / thickness", ylabel="force / force on a thick body", title="film of gel on glass", xlim=(0.0, 0.6))

c.plot(poisson, 100.0 * stiffer, color="C3")
c.set(xlabel="Poisson's ratio", ylabel="stiffer by [%]", title="a rigid punch that sticks", xlim=(0.0, 0.5))
c.set_ylim(bottom=0.0)

d.axhspan(2.0, 30.0, color="0.92")
d.axhspan(30.0, 100.0, color="0.8")
d.loglog(velocity, 100.0 * lost, color="C4")
d.set(xlabel="velocity [m/s]", ylabel="energy lost to waves [%]", title="steel ball of 10 mm", ylim=(1e-2, 100.0))
plt.show()

# %%
# Check and trust
# ---------------
# The limits of Maugis' theory are JKR and DMT; a punch that sticks to a body of Poisson's ratio zero is ln 3 times as
# stiff (Mossakovskii); and answers flag what is violated.

assert abs(jkr[-1] - 1.0) < 0.02
assert abs(dmt[0] - 1.0) < 0.03
assert np.isclose(stiffer[0], np.log(3.0) - 1.0)
notes = wk.Indentation(wk.Foundation(bead, film), wk.Depth(0.6 * thickness)).solve().validity
assert standing(notes, wk.Assumption.FILM) is wk.Standing.OUTSIDE
for note in notes:
    print(f"{note.assumption.value:42s} {note.standing.value}")
