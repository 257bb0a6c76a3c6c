r"""
Pyramids as tips: sharp, blunt, and on films
============================================

Tips of AFM cantilevers and of nanoindenters are pyramids. What does it cost to take one for a cone, what does a blunt
apex change, and what happens on a thin film?

A sharp, regular pyramid on a thick elastic body is self-similar: :math:`F = C\,E^*\tan\theta\,d^2`, with the angle
:math:`\theta` between axis and face. The constant, 0.7376 of four faces and 0.8824 of three, was computed by boundary
elements; the springs under the cone with that constant have the force of the pyramid at every depth.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

HERE = Path(__file__).resolve().parent if "__file__" in globals() else Path.cwd()
FACE = np.radians(35.0)
YOUNG, START = "bed.medium.first.young", 1e3


def bed(tip, young=START):
    """A tip over a gel."""
    return wk.Foundation(tip, wk.HalfSpace.between(wk.Elastic(young, 0.5)))


# %%
# One curve, three tips
# ---------------------
# The curve was made with the constant of another program and a modulus of 4 kPa. The cone of equal cross-section, and
# a cone with the half-angle of the faces, fit as well, with other moduli: the residuals do not tell.

curve = wk.read_curve(HERE.parent / "data" / "gel_pyramid.csv").approach
tips = {
    "pyramid": wk.Pyramid(sides=4, face_angle=FACE),
    "cone, equal area": wk.Cone(np.arctan(np.sqrt(4.0 / np.pi) * np.tan(FACE))),
    "cone, same angle": wk.Cone(FACE),
}
for name, tip in tips.items():
    found = wk.fit(curve, wk.Indentation(bed(tip), wk.Depth(0.0)), free=[YOUNG, "contact_point", "baseline"])
    low, high = found.value(YOUNG) - 1.96 * found.error(YOUNG), found.value(YOUNG) + 1.96 * found.error(YOUNG)
    print(f"{name:17s} E = {found.value(YOUNG):.0f} Pa, 95 %: {low:.0f} to {high:.0f} Pa")
    if name == "pyramid":
        assert low < 4000.0 < high

# %%
# A blunt apex
# ------------
# With a radius of 40 nm at apex and edges the tip is a paraboloid first; far above, the force is that of the sharp
# pyramid whose apex would lie :math:`R/(2\tan^2\theta)` deeper.

depth = np.geomspace(2e-9, 1e-6, 120)
blunt = wk.Indentation(bed(wk.RoundedPyramid(4, FACE, 40e-9), 4e3), wk.Depth(depth)).solve()
sharp = wk.Indentation(bed(tips["pyramid"], 4e3), wk.Depth(depth)).solve()
ball = wk.Indentation(bed(wk.Paraboloid(40e-9), 4e3), wk.Depth(depth)).solve()

# %%
# On a film
# ---------
# Over a layer a pyramid and the cone that stands for it differ. By how much was computed by boundary elements, too, and
# the validity of a contact or a fit states it.

film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(4e3, 0.5), 0.5e-6)], on=wk.Rigid())
thin = wk.Indentation(wk.Foundation(tips["pyramid"], film), wk.Depth(0.3e-6)).solve()
for note in thin.validity:
    if "differs from that of the pyramid" in note.statement:
        print(note.statement)

figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.8), layout="constrained")
left.loglog(depth * 1e9, blunt.force * 1e12, "k", label="blunt pyramid, 40 nm")
left.loglog(depth * 1e9, sharp.force * 1e12, "C0--", label="sharp pyramid")
left.loglog(depth * 1e9, ball.force * 1e12, "C1:", label="paraboloid, 40 nm")
left.set(xlabel="depth [nm]", ylabel="force [pN]", title="four faces, 35° to the axis, E = 4 kPa")
left.legend(frameon=False)
wide = np.geomspace(0.1, 10.0, 100)
for sides, color in ((4, "C0"), (3, "C3")):
    for contrast, style in ((np.inf, "-"), (10.0, "--"), (0.1, ":")):
        error = [100.0 * wk.pyramid_layer_error(sides, a, contrast, 0.3) for a in wide]
        base = "rigid base" if np.isinf(contrast) else f"base {contrast:g} times as stiff"
        right.semilogx(wide, error, style, color=color, label=f"{sides} faces, {base}")
right.axhline(0.0, color="0.7", linewidth=0.8)
right.set(
    xlabel="contact radius over thickness", ylabel="error of the force [%]", title="pyramid on a bonded layer, ν = 0.3"
)
right.set_ylim(-27.0, 18.0)
right.legend(frameon=False, fontsize=8, loc="lower left")
plt.show()
