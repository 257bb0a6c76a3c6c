r"""
A master curve from sweeps at several temperatures
==================================================

Storage and loss of a rubber, measured between 0.1 and 50 Hz at nine temperatures, are shifted into one curve over ten
decades.
The shifts have errors, and tell which law of temperature they follow; the solid is then a material at any temperature.
"""

import numpy as np

from winkler import DynamicSweeps, Foundation, MasterCurve, Paraboloid, RelaxationTest, ViscoelasticHalfSpace
from winkler.plot import draw

FIRST, SECOND, REFERENCE = 9.84, 175.4, 273.15
rng = np.random.default_rng(19)
temperature = np.repeat(np.arange(213.15, 294.0, 10.0), 13)
omega = np.tile(2.0 * np.pi * np.geomspace(0.1, 50.0, 13), 9)
above = temperature - REFERENCE
turns = (1j * omega * 10.0 ** (-FIRST * above / (SECOND + above)) * 3e-7) ** 0.55
modulus = 0.5e6 + 400e6 * turns / (1.0 + turns)
scatter = np.exp(0.02 * rng.standard_normal((2, omega.size)))
sweeps = DynamicSweeps(temperature, omega, modulus.real * scatter[0], modulus.imag * scatter[1])

# %%
# Shifts, laws, spectrum
# ----------------------

rubber = MasterCurve(sweeps, REFERENCE).solve()
low, high = rubber.laws.second_interval
print(f"{rubber.verdict}: c2 = {rubber.second_constant:.1f} K, between {low:.1f} K and {high:.1f} K")
assert rubber.verdict == "Williams, Landel and Ferry"
assert low < SECOND < high
figure = draw(rubber)

# %%
# A contact on a cold day
# -----------------------

for celsius in (-20.0, 20.0):
    bed = Foundation(Paraboloid(5e-3), ViscoelasticHalfSpace(rubber.solid_at(273.15 + celsius)))
    force = RelaxationTest(bed, depth=1e-4, time=[1e-3, 1.0]).solve().force
    print(f"{celsius:3.0f} degC: {force[0]:.2f} N after 1 ms, {force[1]:.2f} N after 1 s")
