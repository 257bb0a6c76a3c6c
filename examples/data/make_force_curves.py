"""Make gel_bead.csv, sticky_bead.csv and the batches gel/ and one_gel/: force curves with scatter of a measurement.

The curves are not real ones.  What they should give is known, so that what comes out of winkler can be checked: a
bead of 5 micrometres curvature radius, rigid, on a spring of 0.05 N/m.  gel_bead.csv is pressed into an incompressible
gel of E = 4 kPa; sticky_bead.csv into rubber of E = 40 kPa with a work of adhesion of 0.2 mJ/m^2, in and out; gel/
holds twelve curves at twelve places of a gel whose modulus scatters about 4 kPa, one_gel/ four curves of different
depths and scatter on one gel of 4 kPa.  The force scatters by 20 pN (normally
distributed, seeded, so that the files are the same every time).  The forces follow from the closed forms of Hertz and
of Johnson, Kendall and Roberts, written out here, not from winkler.

Run it in the folder where the files are wanted:  python make_force_curves.py
"""

from pathlib import Path

import numpy as np

BEAD = 5e-6
SPRING = 0.05
POISSON = 0.5
SCATTER = 20e-12
BASELINE = 35e-12
FIRST_TOUCH = 2.4e-6
SEED = 1971

HEADER = """\
# NOT a real measurement: made by examples/data/make_force_curves.py from a known contact, with seeded scatter.
# {what}
k (N/m) {spring}
piezo [nm], force [nN]
"""


def hertz(position: np.ndarray, young: float) -> np.ndarray:
    """Return the force at positions D = d + F/k from first touch [N], by bisection for the depth d."""
    factor = 4.0 / 3.0 * young / (1.0 - POISSON**2) * np.sqrt(BEAD)
    low, high = np.zeros_like(position), np.maximum(position, 0.0)
    for _ in range(100):
        middle = 0.5 * (low + high)
        over = middle + factor * middle**1.5 / SPRING > position
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    return factor * (0.5 * (low + high)) ** 1.5


def jkr(position: np.ndarray, inward: np.ndarray, young: float, work: float) -> np.ndarray:
    """Return the force of a sticky bead [N]: it jumps in at first touch, and comes off where the spring pulls it."""
    modulus = young / (1.0 - POISSON**2)
    radius = np.geomspace(1e-8, BEAD, 200_001)
    depth = radius**2 / BEAD - np.sqrt(2.0 * np.pi * radius * work / modulus)
    force = 4.0 * modulus * radius**3 / (3.0 * BEAD) - np.sqrt(8.0 * np.pi * radius**3 * work * modulus)
    place = depth + force / SPRING
    last = int(np.argmin(place))
    held = np.where(inward, position >= 0.0, position >= place[last])
    return np.where(held, np.interp(position, place[last:], force[last:]), 0.0)


def write(path: Path, what: str, position: np.ndarray, force: np.ndarray) -> None:
    """Write a curve as a table."""
    rows = (f"{1e9 * x:.2f}, {1e9 * f:.4f}\n" for x, f in zip(position, force, strict=True))
    path.write_text(HEADER.format(what=what, spring=SPRING) + "".join(rows), encoding="utf-8")


if __name__ == "__main__":
    random = np.random.default_rng(SEED)
    rise = np.linspace(-1.4e-6, 1.0e-6, 300)
    scatter = BASELINE + SCATTER * random.standard_normal(rise.size)
    write(Path("gel_bead.csv"), "Gel, E = 4 kPa, nu = 0.5.", rise + FIRST_TOUCH, hertz(rise, 4e3) + scatter)
    there_and_back = np.concatenate([rise, rise[::-1]])
    inward = np.repeat([True, False], rise.size)
    scatter = BASELINE + SCATTER * random.standard_normal(inward.size)
    force = jkr(there_and_back, inward, 40e3, 0.2e-3) + scatter
    what = "Rubber, E = 40 kPa, nu = 0.5, work of adhesion 0.2 mJ/m^2."
    write(Path("sticky_bead.csv"), what, there_and_back + FIRST_TOUCH, force)
    Path("gel").mkdir(exist_ok=True)
    for number in range(12):
        young = 4e3 * np.exp(0.25 * random.standard_normal())
        scatter = BASELINE + SCATTER * random.standard_normal(rise.size)
        where = Path("gel") / f"place{number + 1}.csv"
        write(where, f"Gel, E = {1e-3 * young:.3f} kPa, nu = 0.5.", rise + FIRST_TOUCH, hertz(rise, young) + scatter)
    Path("one_gel").mkdir(exist_ok=True)
    for number, (top, level) in enumerate(((0.3e-6, 1.0), (0.5e-6, 2.0), (0.8e-6, 1.0), (1.0e-6, 4.0))):
        along = np.linspace(-0.6e-6, top, 150)
        scatter = BASELINE + level * SCATTER * random.standard_normal(along.size)
        place = along + FIRST_TOUCH + 0.1e-6 * number
        write(
            Path("one_gel") / f"depth{number + 1}.csv", "Gel, E = 4 kPa, nu = 0.5.", place, hertz(along, 4e3) + scatter
        )
    print("Written gel_bead.csv, sticky_bead.csv, gel/ and one_gel/")
