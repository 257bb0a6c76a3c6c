"""Make rubber_sweeps.csv: storage and loss of a rubber at nine temperatures, with scatter, from a closed formula.

A fractional Zener solid, whose times follow the law of Williams, Landel and Ferry with the constants of polyisobutylene
(J. D. Ferry, Viscoelastic Properties of Polymers, 3rd edition, Wiley 1980, table 11-II).
"""

from pathlib import Path

import numpy as np

RELAXED, SHEAR, TIME, EXPONENT = 0.5e6, 400e6, 2e-8, 0.55
REFERENCE, FIRST, SECOND = 298.15, 8.61, 200.4
SCATTER = 0.02

rng = np.random.default_rng(19)
celsius = np.repeat(np.arange(-60.0, 21.0, 10.0), 13)
frequency = np.tile(np.geomspace(0.1, 50.0, 13), 9)
above = celsius + 273.15 - REFERENCE
shift = 10.0 ** (-FIRST * above / (SECOND + above))
turns = (2j * np.pi * frequency * shift * TIME) ** EXPONENT
modulus = RELAXED + SHEAR * turns / (1.0 + turns)
storage = modulus.real * np.exp(SCATTER * rng.standard_normal(frequency.size))
loss = modulus.imag * np.exp(SCATTER * rng.standard_normal(frequency.size))
rows = np.column_stack([celsius, frequency, storage / 1e6, loss / 1e6])
np.savetxt(
    Path(__file__).with_name("rubber_sweeps.csv"),
    rows,
    fmt=("%.1f", "%.5g", "%.5g", "%.5g"),
    delimiter=",",
    header="temperature [degC], frequency [Hz], storage [MPa], loss [MPa]",
    comments="",
)
