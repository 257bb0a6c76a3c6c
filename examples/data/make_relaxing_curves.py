"""Make cell_loop.csv, gel_creep.csv and gel_relaxation.csv: bodies that relax, with the scatter of a measurement.

The curves are not real ones.  What they should give is known, so that what comes out of winkler can be checked: a rigid
bead of 5 micrometres curvature radius.  cell_loop.csv is pressed into a cell that relaxes as t^-0.2, with a shear
modulus of 500 Pa after one second, at steady speed in and out; gel_creep.csv stands under a force of 1 nN on a gel
with shear moduli of 300 Pa at last and 1000 Pa at first, whose relaxation takes 0.8 s.  Both bodies are incompressible.
The force scatters by 5 pN, the depth of the creep by 2 nm (normally distributed, seeded, so that the files are the same
every time).  gel_relaxation.csv is what a rheometer would tell of a gel with the moduli of `SPECTRUM`, one per cent of
scatter in each.  The numbers follow from closed forms (Lee and Radok, Ting), written out here, not from winkler.

Run it in the folder where the files are wanted:  python make_relaxing_curves.py
"""

from pathlib import Path

import numpy as np
from scipy.special import beta, betainc

BEAD = 5e-6
SEED = 1960
SPECTRUM = {0.1: 500.0, 2.0: 600.0, 40.0: 450.0}
"""Relaxation times [s] and shear moduli [Pa] of the third file, beside 1.15 kPa that stay."""

HEADER = """\
# NOT a real measurement: made by examples/data/make_relaxing_curves.py from a known contact, with seeded scatter.
# {what}
depth [nm], force [nN], time [s]
"""


def loop(time: np.ndarray, turn: float, speed: float, shear: float, exponent: float) -> np.ndarray:
    """Return the force of a bead that is pressed into a power-law cell and drawn out at the same speed [N].

    On the return only what was pressed before t_1 still bears (Ting 1966).
    """
    before = np.where(time <= turn, time, time - 2.0 ** (1.0 / (1.0 - exponent)) * (time - turn))
    part = np.clip(before / np.where(time > 0.0, time, 1.0), 0.0, 1.0)
    factor = 2.0 * (4.0 * shear) * np.sqrt(BEAD) * speed**1.5 * beta(1.5, 1.0 - exponent)
    return factor * np.maximum(time, 0.0) ** (1.5 - exponent) * betainc(1.5, 1.0 - exponent, part)


def creep(time: np.ndarray, force: float, relaxed: float, shear: float, relaxation_time: float) -> np.ndarray:
    """Return the depth of a bead under a force that was put on at once [m]."""
    slow = relaxation_time * (relaxed + shear) / relaxed
    compliance = (1.0 - shear / (relaxed + shear) * np.exp(-time / slow)) / (4.0 * relaxed)
    return (0.75 * force / np.sqrt(BEAD) * compliance) ** (2.0 / 3.0)


def write(path: Path, what: str, depth: np.ndarray, force: np.ndarray, time: np.ndarray) -> None:
    """Write a curve as a table."""
    rows = (f"{1e9 * d:.3f}, {1e9 * f:.5f}, {t:.6f}\n" for d, f, t in zip(depth, force, time, strict=True))
    path.write_text(HEADER.format(what=what) + "".join(rows), encoding="utf-8")


if __name__ == "__main__":
    random = np.random.default_rng(SEED)
    time = np.linspace(-0.5, 2.5, 601)
    depth = 1e-6 * np.where(time < 1.0, time, 2.0 - time)
    force = loop(time, 1.0, 1e-6, 500.0, 0.2) + 20e-12 + 5e-12 * random.standard_normal(time.size)
    write(Path("cell_loop.csv"), "Cell, G = 500 Pa (t / 1 s)^-0.2, nu = 0.5.", depth + 400e-9, force, time + 0.5)
    time = np.linspace(0.0, 10.0, 501)
    depth = creep(time, 1e-9, 300.0, 700.0, 0.8) + 2e-9 * random.standard_normal(time.size)
    what = "Gel, G = 300 Pa + 700 Pa exp(-t / 0.8 s), nu = 0.5, under 1 nN."
    write(Path("gel_creep.csv"), what, depth, np.full(time.size, 1e-9), time)
    time = np.geomspace(0.01, 300.0, 28)
    shear = 1150.0 + sum(modulus * np.exp(-time / tau) for tau, modulus in SPECTRUM.items())
    shear *= 1.0 + 0.01 * random.standard_normal(time.size)
    rows = (f"{t:.4g}, {1e-3 * g:.4g}\n" for t, g in zip(time, shear, strict=True))
    head = (
        HEADER.splitlines()[0]
        + "\n# Gel, G = 1.15 kPa and three terms, after a step of shear.\ntime [s], shear [kPa]\n"
    )
    Path("gel_relaxation.csv").write_text(head + "".join(rows), encoding="utf-8")
    print("Written cell_loop.csv, gel_creep.csv and gel_relaxation.csv")
