"""Curves of bodies that relax, from closed forms: Lee and Radok while the contact grows, Ting while it shrinks."""

from __future__ import annotations

import numpy as np
from scipy.special import beta, betainc

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.loading.path import Path
from winkler.materials.fractional import PowerLawSolid
from winkler.materials.spring_and_dashpot import StandardSolid
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation

BEAD = 5e-6
FIRST = "bed.medium.first."
FREE = {
    "creep": (f"{FIRST}relaxed_shear", f"{FIRST}shear", f"{FIRST}relaxation_time"),
    "relaxation": (f"{FIRST}shear", f"{FIRST}exponent", "contact_point", "baseline"),
    "loop": (f"{FIRST}shear", f"{FIRST}exponent", "contact_point", "baseline"),
}
TRUE = {
    "creep": (300.0, 700.0, 0.8),
    "relaxation": (500.0, 0.2, 4e-7, 3e-11),
    "loop": (500.0, 0.2, 4e-7, 3e-11),
}


def bed(solid):
    return wk.Foundation(wk.Paraboloid(BEAD), ViscoelasticHalfSpace(solid))


def model(solid, load=wk.Depth):
    """The model of a fit; its path is only a placeholder."""
    return ViscoelasticIndentation(bed(solid), Path([0.0], load(0.0)))


def start(kind):
    """A model that is far off the truth."""
    if kind == "creep":
        return model(StandardSolid(1e3, 1e3, 5.0), wk.Force)
    return model(PowerLawSolid(2e3, 1.0, 0.45, shortest=1e-3, longest=20.0))


def power_law_force(time, turn, speed, shear, exponent, *, held):
    """Force of a bead on an incompressible power-law body, G = shear t^-exponent: in at a steady speed until `turn`,
    and then held or drawn out as fast; what was pressed before t_1 still bears."""
    ahead = 1.0 if held else 2.0 ** (1.0 / (1.0 - exponent))
    before = np.where(time <= turn, time, turn if held else time - ahead * (time - turn))
    part = np.clip(before / np.where(time > 0.0, time, 1.0), 0.0, 1.0)
    factor = 8.0 * shear * np.sqrt(BEAD) * speed**1.5 * beta(1.5, 1.0 - exponent)
    return factor * np.maximum(time, 0.0) ** (1.5 - exponent) * betainc(1.5, 1.0 - exponent, part)


def loop(seed, *, noise=2e-11, count=301, held=False):
    """In and out, or in and held, at 1 um/s to 1 um, half a second of free travel before."""
    time = np.linspace(-0.5, 2.5, count)
    path = 1e-6 * np.where(time < 1.0, time, 1.0 if held else 2.0 - time)
    direction = np.where(time <= 1.0, 1.0, 0.0 if held else -1.0)
    force = power_law_force(time, 1.0, 1e-6, 500.0, 0.2, held=held) + 3e-11
    force += noise * np.random.default_rng(seed).standard_normal(count)
    return ForceCurve(path + 4e-7, force, time=time + 0.5, direction=direction, name=f"seed {seed}")


def creep(seed, *, noise=3e-9, count=301, load=1e-9):
    """A bead on a standard solid under a force that was put on at once."""
    relaxed, shear, time_ = TRUE["creep"]
    time = np.linspace(0.0, 8.0, count)
    slow = time_ * (relaxed + shear) / relaxed
    compliance = (1.0 - shear / (relaxed + shear) * np.exp(-time / slow)) / (4.0 * relaxed)
    depth = (0.75 * load / np.sqrt(BEAD) * compliance) ** (2.0 / 3.0)
    depth += noise * np.random.default_rng(seed).standard_normal(count)
    return ForceCurve(depth, np.full(count, load), time=time, direction=np.zeros(count), name=f"seed {seed}")


def ramp_and_hold(seed, *, offset=5e-11, tilt=2e-5, noise=1e-11, scatter=2e-9, count=1200, load=1e-9):
    """A bead on a standard solid: a second of free travel, a force that grows evenly for a second, and seven held.

    While the contact does not shrink, d^(3/2) = 3/(4 sqrt(R)) int C(t-s) dF(s) (Lee and Radok); of a ramp the integral
    of C(t) = 1/(4 G) (1 - G_1/(G + G_1) exp(-t/theta)) is elementary.
    """
    relaxed, shear, time_ = TRUE["creep"]
    slow, time = time_ * (relaxed + shear) / relaxed, np.linspace(-1.0, 8.0, count)

    def ramp(t):
        t = np.maximum(t, 0.0)
        return load / (4.0 * relaxed) * (t - shear / (relaxed + shear) * slow * (1.0 - np.exp(-t / slow)))

    depth = (0.75 / np.sqrt(BEAD) * (ramp(time) - ramp(time - 1.0))) ** (2.0 / 3.0)
    random = np.random.default_rng(seed)
    along = np.where(time < 0.0, 1e-6 * time, depth)
    force = load * np.clip(time, 0.0, 1.0) + offset + tilt * along + noise * random.standard_normal(count)
    position = along + 4e-7 + scatter * random.standard_normal(count)
    return ForceCurve(position, force, time=time + 1.0, direction=np.where(time <= 1.0, 1.0, 0.0), name=f"seed {seed}")


def curve(kind, seed, **more):
    """A curve of one of the three kinds."""
    match kind:
        case "creep":
            return creep(seed, **more)
        case "relaxation":
            return loop(seed, held=True, **more)
        case _:
            return loop(seed, **more)
