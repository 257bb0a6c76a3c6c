r"""
The rubber cover of a roller
============================

A printing roller is a steel core with a rubber cover. How far must it be pressed in for a given width of the nip, and
what does a thinner cover change? And what stresses the bond between rubber and steel? The cover is a strip bonded to a
rigid base, in plane strain; a thin one follows its base, and Johnson (1985, section 5.8) gives what it tends to: the
depth :math:`a^2/(2R)` if the rubber can be compressed, a third of that if it has to flow sideways.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Load, width and depth of the nip
# --------------------------------
# Two rollers of 60 mm and 120 mm radius; 5 mm of rubber on one of them. Steel is rigid against it.

RADIUS = 1.0 / (1.0 / 60e-3 + 1.0 / 120e-3)
rubber = wk.Elastic(young=4e6, poisson=0.49)


def cover(thickness, poisson=0.49):
    """Return the nip with a cover of this thickness."""
    layer = wk.Layer(wk.Elastic(4e6, poisson), thickness)
    return wk.LayeredLineFoundation(wk.Paraboloid(RADIUS), wk.CoatedHalfSpace([layer], on=wk.Rigid()))


loads = np.geomspace(0.1e3, 20e3, 25)
nip = wk.LineIndentation(cover(5e-3), wk.LineForce(loads)).solve()
print("force per length [N/mm]   width [mm]   depth [um]   greatest pressure [MPa]")
for index in range(0, loads.size, 6):
    one = nip.at(index)
    print(
        f"{one.force_per_length * 1e-3:23.2f} {2 * one.half_width * 1e3:12.2f} {one.depth * 1e6:12.1f} "
        f"{one.peak_pressure * 1e-6:25.3f}"
    )
assert np.all(np.diff(nip.depth) > 0.0)

draw(nip)

# %%
# Thinner covers
# --------------
# Depth over :math:`a^2/(2R)`, from a half-plane, where it would grow without bound, to the thin strip.

ratios = np.geomspace(0.5, 50.0, 13)
figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
for poisson, color in ((0.3, "C0"), (0.45, "C2"), (0.49, "C1"), (0.5, "C3")):
    widths = 2e-3 * ratios
    depths = wk.LineIndentation(cover(2e-3, poisson), wk.HalfWidth(widths)).solve().depth
    axes.semilogx(ratios, depths / (widths**2 / (2.0 * RADIUS)), color, label=rf"$\nu = {poisson}$")
axes.axhline(1.0, color="0.6", linestyle=":")
axes.axhline(1.0 / 3.0, color="0.6", linestyle=":")
axes.set(xlabel="half-width / thickness, $a/h$ [-]", ylabel=r"depth / ($a^2/2R$) [-]", title="strip on a rigid base")
axes.legend(frameon=False)
plt.show()

# %%
# The bond
# --------
# The shear stress between rubber and steel is greatest beside the middle; it is what peels a cover off.

one = wk.LineIndentation(cover(5e-3), wk.LineForce(10e3)).solve()
(worst,) = one.layer_stresses()
print(
    f"\nshear on the bond: {worst.interface_shear * 1e-6:.3f} MPa at {worst.interface_x * 1e3:.2f} mm from the middle"
)
print(f"that is {worst.interface_shear / one.peak_pressure:.3f} of the greatest pressure")
