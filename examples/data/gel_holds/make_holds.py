"""Make narrow.csv and wide.csv: the force on flat punches held on a wet gel, with scatter.

The holds are not real ones.  What they should give is known: two impermeable punches of 0.5 mm and 1 mm radius, pressed
0.1 mm into a gel with G = 5 kPa, whose network has Poisson's ratio 0.3 and whose liquid diffuses with 1e-9 m^2/s.  The
force falls from 8 G a d to 1/1.4 of it by the formula of Y. Lai and Y. Hu, Soft Matter 13 (2017) 852-861, written out
here.  It scatters by 0.5 % (normally distributed, seeded).

Run it in the folder where the files are wanted:  python make_holds.py
"""

from pathlib import Path

import numpy as np

SHEAR, POISSON, DIFFUSIVITY, DEPTH = 5e3, 0.3, 1e-9, 1e-4
RADII = {"narrow": 0.5e-3, "wide": 1e-3}
SCATTER, SEED = 5e-3, 2017

HEADER = """\
# NOT a real measurement: made by examples/data/gel_holds/make_holds.py from a formula of Lai and Hu, with scatter.
# Gel with G = 5 kPa, nu = 0.3, D = 1e-9 m^2/s; flat punch of {radius:g} mm radius, 0.1 mm deep.
time [s], force [mN]
"""


def share(tau: np.ndarray) -> np.ndarray:
    """Return the part of the force that still has to relax, of a flat punch."""
    return (
        0.242 * np.exp(-3.13 * tau)
        + 0.536 * np.exp(-1.71 * np.sqrt(tau))
        - 0.043 * np.exp(-12.8 * np.cbrt(tau))
        + 0.266 * np.exp(-0.892 * tau**0.25)
    )


if __name__ == "__main__":
    random = np.random.default_rng(SEED)
    for name, radius in RADII.items():
        time = np.geomspace(1.0, 2e4, 80)
        first = 8.0 * SHEAR * radius * DEPTH
        last = first / (2.0 * (1.0 - POISSON))
        force = last + (first - last) * share(DIFFUSIVITY * time / radius**2)
        force *= 1.0 + SCATTER * random.standard_normal(time.size)
        rows = (f"{t:.4g}, {1e3 * f:.5g}\n" for t, f in zip(time, force, strict=True))
        file = Path(f"{name}.csv")
        file.write_text(HEADER.format(radius=1e3 * radius) + "".join(rows), encoding="utf-8")
        print(f"Written {file}")
