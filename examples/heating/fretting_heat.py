r"""
Does fretting heat the contact?
===============================

A connector that vibrates, a wire against its guide: the contact is rubbed to and fro by micrometres, a hundred times a
second. In partial slip only a ring slides, and the heat is released there. ``FrettingHeat`` takes the traction and the
slip of a ``Tangential`` march, sums what each place loses in a cycle, and states how warm both surfaces get.
``SurfaceFrictionHeating`` does so for a contact of any outline, on pixels.
"""

import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# A steel ball of 10 mm under 100 N, pushed to and fro by a micrometre. Two cycles are enough: the second one is
# repeated for ever.

elastic, steel = wk.Elastic(young=210e9, poisson=0.3), wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=10e-3), wk.HalfSpace.between(elastic, elastic))
friction, pair = wk.Coulomb(0.5), wk.HeatConductors(steel, steel)


def fretted(amplitude, frequency):
    path = wk.Path.oscillation(force=100.0, amplitude=amplitude, cycles=2, count=60)
    return wk.FrettingHeat(wk.Tangential(bed, friction, path), frequency, pair).solve()


warm = fretted(1e-6, 100.0)
print(f"{warm.loss_per_cycle * 1e6:.2f} uJ in a cycle, {warm.heat_rate * 1e3:.3f} mW")
print(f"mean temperature of the ring up to {warm.max_temperature * 1e3:.1f} mK")
draw(warm)

# %%
# Small amplitudes are harmless
# -----------------------------
# The loss of a cycle grows with the cube of the amplitude while the contact sticks in the middle. Once all of it
# slides the power is that of sliding at the mean speed, four amplitudes per cycle, and the temperature becomes
# noticeable at some ten micrometres only.

for amplitude in (0.3e-6, 1e-6, 3e-6, 30e-6):
    found = fretted(amplitude, 100.0)
    print(f"{amplitude * 1e6:5.1f} um: {found.heat_rate * 1e3:9.4f} mW, up to {found.max_temperature:.2e} K")

# %%
# Contacts of any outline
# -----------------------
# Wear has ground a flat onto the ball. On its height map ``SurfaceTangential`` finds where the surfaces slip, and
# ``SurfaceFrictionHeating`` how warm they get. The worn contact is wider: it slips less, and gets less warm.

side, pixels = 0.5e-3, 64
ball = wk.SampledProfile([side, side], wk.Paraboloid(curvature_radius=10e-3), (pixels, pixels))
flat = wk.Topography(np.minimum(ball.heights, np.max(ball.heights) - 0.8e-6), [side, side])
path = wk.Path.oscillation(force=100.0, amplitude=1e-6, cycles=2, count=16)
for name, surface in (("new", ball), ("worn", flat)):
    pushed = wk.SurfaceTangential(surface, bed.medium, friction, path)
    mapped = wk.SurfaceFrictionHeating(pushed, pair, frequency=100.0).solve()
    print(f"{name}: {mapped.heat_rate * 1e3:.3f} mW, up to {mapped.max_temperature * 1e3:.1f} mK")
    if name == "new":  # rings neglect that slip differs along and across the motion, by Poisson's ratio; pixels do not
        assert np.isclose(mapped.heat_rate, warm.heat_rate, rtol=0.01)
        assert np.isclose(mapped.max_temperature, warm.max_temperature, rtol=0.1)
draw(mapped)

# %%
# Check
# -----
# Far beyond sliding the answer tends to that of slow sliding, :math:`T=\mu vE^*d/2(\lambda_1+\lambda_2)`.

far = fretted(300e-6, 1.0)
contact = wk.Indentation(bed, wk.Force(100.0)).solve()
slider = 0.5 * (4 * 300e-6 * 1.0) * bed.medium.modulus * contact.depth / (2.0 * 90.0)
assert np.isclose(far.max_temperature, slider, rtol=0.02)
swing = wk.FrictionDamping(bed, friction, wk.Force(100.0), wk.Shift(1e-6)).solve()
assert np.isclose(warm.loss_per_cycle, swing.loss_per_cycle, rtol=1e-9)
