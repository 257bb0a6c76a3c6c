r"""
Does fretting heat the contact?
===============================

A connector that vibrates, a wire against its guide: the contact is rubbed to and fro by micrometres, a hundred times a
second. In partial slip only a ring slides, and the heat is released there. ``FrettingHeat`` takes the traction and the
slip of a ``Tangential`` march, sums what each place loses in a cycle, and states how warm both surfaces get.
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
# Check
# -----
# Far beyond sliding the answer tends to that of slow sliding, :math:`T=\mu vE^*d/2(\lambda_1+\lambda_2)`.

far = fretted(300e-6, 1.0)
contact = wk.Indentation(bed, wk.Force(100.0)).solve()
slider = 0.5 * (4 * 300e-6 * 1.0) * bed.medium.modulus * contact.depth / (2.0 * 90.0)
assert np.isclose(far.max_temperature, slider, rtol=0.02)
swing = wk.FrictionDamping(bed, friction, wk.Force(100.0), wk.Shift(1e-6)).solve()
assert np.isclose(warm.loss_per_cycle, swing.loss_per_cycle, rtol=1e-9)
