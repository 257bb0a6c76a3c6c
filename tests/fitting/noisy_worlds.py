"""Worlds of measured curves: closed forms of contacts, and disturbances of machines, written without the package.

A disturbance is stated in parts of the white noise: slow noise by its root mean square, a drift, a tilt and a drag by
half their range.  Their signs and sizes differ from curve to curve.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np
from relaxing_curves import FIRST, model, power_law_force
from synthetic import hertz_on_spring, jkr, noise, there_and_back

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.laws.adhesion import ShortRange
from winkler.materials.fractional import PowerLawSolid
from winkler.problems.adhesion.indentation import AdhesiveIndentation

YOUNG, SPRING, RADIUS, ORIGIN, BASE = 1e4, 0.05, 5e-6, 2e-6, 1e-10
MODULUS = YOUNG / 0.75
PATH = "bed.medium.first.young"
LINE = {"contact_point": ORIGIN, "baseline": BASE}


def coloured(random, count, exponent):
    """Noise of unit variance with the power spectrum f^-exponent down to one period in eight times the length."""
    size = 8 * count
    frequency = np.fft.rfftfreq(size)
    frequency[0] = frequency[1]
    shape = frequency ** (-0.5 * exponent)
    drawn = np.fft.irfft(shape * np.fft.rfft(random.standard_normal(size)), size)[:count]
    return drawn / np.sqrt(np.mean(shape[1:] ** 2))


@dataclasses.dataclass(frozen=True)
class World:
    """A kind of curve: true forces over positions, what disturbs them, and what is fitted.

    `walk` is the random walk's step, `memory` the correlation of neighbours; all in parts of `level` [N].
    """

    force: Callable
    model: Callable
    truth: dict[str, float]
    position: np.ndarray
    inward: np.ndarray
    level: float = 3e-11
    stiffness: float = np.inf
    flicker: float = 0.0
    walk: float = 0.0
    memory: float = 0.0
    drift: float = 0.0
    tilt: float = 0.0
    drag: float = 0.0
    time: np.ndarray | None = None
    direction: np.ndarray | None = None

    def curve(self, seed: int) -> ForceCurve:
        random, count = np.random.default_rng(seed), self.position.size
        along = np.linspace(-1.0, 1.0, count)
        place = (self.position - self.position.mean()) / (0.5 * np.ptp(self.position))
        disturbed = noise(random, count, self.memory)
        disturbed += self.flicker * coloured(random, count, 1.0) if self.flicker else 0.0
        disturbed += self.walk * np.cumsum(random.standard_normal(count))
        signs = random.uniform(0.5, 1.5, 3) * random.choice([-1.0, 1.0], 3)
        disturbed += self.drift * signs[0] * along + self.tilt * signs[1] * place
        disturbed += self.drag * abs(signs[2]) * np.where(self.inward, 1.0, -1.0)
        force = self.force(self.position, self.inward) + BASE + self.level * disturbed
        more = {} if self.direction is None else {"direction": self.direction}
        return ForceCurve(
            self.position + ORIGIN,
            force,
            self.stiffness,
            time=self.time if self.time is not None else [],
            name=f"seed {seed}",
            **more,
        )


def bed(profile, young=3e4):
    return wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(young, 0.5)))


def indented(profile):
    return wk.Indentation(bed(profile), wk.Depth(0.0))


def worlds(count: int) -> dict[str, World]:
    """The worlds, of curves with `count` points."""
    once = np.linspace(-1e-6, 1e-6, count)
    into = np.ones(count, dtype=bool)
    twice, inward = there_and_back(-1e-6, 1e-6, count // 2)
    elastic = {PATH: YOUNG, **LINE}

    def ball(position, _):
        return hertz_on_spring(position, MODULUS, RADIUS, SPRING)

    def cone(position, _):
        return 2.0 / np.pi * MODULUS * np.tan(1.2) * np.maximum(position, 0.0) ** 2

    def sticky(position, inward):
        return jkr(position, inward, MODULUS, RADIUS, 1e-4, SPRING)

    def pressed(position, _):  # a load curve of a self-similar tip: F = C h^2
        return 2.0 / np.pi * 70e9 / 0.9 * np.tan(1.2287) * np.maximum(position, 0.0) ** 2

    time = np.linspace(-0.5, 2.5, count)
    held = 1e-6 * np.minimum(time, 1.0)

    def relaxed(_, __):
        return power_law_force(time, 1.0, 1e-6, 500.0, 0.2, held=True)

    def hertz():
        return indented(wk.Paraboloid(RADIUS))

    def pyramid():
        return indented(wk.Cone(1.2))

    def glass():
        return wk.Indentation(
            wk.Foundation(wk.Cone(1.2287), wk.HalfSpace.between(wk.Elastic(50e9, np.sqrt(0.1)))), wk.Depth(0.0)
        )

    def jkr_model():
        return AdhesiveIndentation(bed(wk.Paraboloid(RADIUS)), ShortRange(1e-3), wk.Depth(0.0))

    def gel():
        return model(PowerLawSolid(2e3, 1.0, 0.45, shortest=1e-3, longest=20.0))

    on_spring = World(ball, hertz, elastic, once, into, stiffness=SPRING)
    both = dataclasses.replace(on_spring, position=twice, inward=inward)
    deep = np.linspace(-0.2e-6, 1e-6, count)
    return {
        "ball, white": on_spring,
        "ball, 1/f": dataclasses.replace(on_spring, flicker=1.0 / 3.0),
        "ball, random walk": dataclasses.replace(on_spring, walk=0.03),
        "ball, drift": dataclasses.replace(both, flicker=1.0 / 3.0, drift=2.0),
        "ball, tilt": dataclasses.replace(on_spring, flicker=1.0 / 3.0, tilt=1.0),
        "ball, drag": dataclasses.replace(both, drag=2.0, flicker=1.0 / 3.0),
        "ball, memory": dataclasses.replace(both, memory=0.9),
        "cone in liquid": World(
            cone, pyramid, elastic, twice, inward, flicker=1.0 / 3.0, drift=1.0, tilt=1.0, drag=2.0
        ),
        "power-law creep": World(
            relaxed,
            gel,
            {f"{FIRST}shear": 500.0, f"{FIRST}exponent": 0.2, "contact_point": ORIGIN, "baseline": BASE},
            held,
            time < 1.0,
            level=2e-11,
            flicker=1.0 / 3.0,
            time=time + 0.5,
            direction=np.where(time <= 1.0, 1.0, 0.0),
        ),
        "JKR": dataclasses.replace(
            both, force=sticky, model=jkr_model, truth={**elastic, "law.work": 1e-4}, flicker=1.0 / 3.0
        ),
        "nanoindentation": World(
            pressed, glass, {PATH: 70e9, **LINE}, deep, into, level=2e-5, walk=0.02, flicker=1.0 / 3.0
        ),
        "everything": dataclasses.replace(both, flicker=1.0 / 3.0, walk=0.01, drift=1.0, tilt=1.0, drag=1.0),
    }
