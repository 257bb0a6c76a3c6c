"""Harder worlds: all disturbances with a hold, a blunt tip in liquid, a bonded film, a triggered curve, and creep.

Forms of Sneddon and of Lee and Radok, and an integral equation of the film, written without the package.  The 1/f noise
of the first three is shaped over the length of the curve, as many programs do it: its mean is zero.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable

import numpy as np
from noisy_worlds import BASE, LINE, MODULUS, ORIGIN, PATH, RADIUS, SPRING, YOUNG, World, coloured, indented
from relaxing_curves import FIRST, TRUE, model, ramp_and_hold
from synthetic import hertz_on_spring, there_and_back

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.materials.spring_and_dashpot import StandardSolid

FILM = 2e-6
THIRD = 1.0 / 3.0


def periodic(random, count, exponent):
    """Noise f^-exponent of unit variance over its own length, without a mean."""
    frequency = np.fft.rfftfreq(count)
    frequency[0] = np.inf
    drawn = np.fft.irfft(frequency ** (-0.5 * exponent) * np.fft.rfft(random.standard_normal(count)), count)
    return drawn / np.std(drawn)


@dataclasses.dataclass(frozen=True)
class Machine(World):
    """A world with times; `slow` draws the 1/f noise of an even clock, which is read at the times of the points.

    A curve ends where its force first exceeds `trigger` [N].
    """

    slow: Callable = periodic
    trigger: float = np.inf

    def curve(self, seed: int) -> ForceCurve:
        random, count = np.random.default_rng(seed), self.position.size
        clock = (count - 1) * self.time / self.time[-1]
        place = (self.position - self.position.mean()) / (0.5 * np.ptp(self.position))
        disturbed = random.standard_normal(count)
        disturbed += np.interp(clock, np.arange(count), self.flicker * self.slow(random, count, 1.0))
        disturbed += np.interp(clock, np.arange(count), self.walk * np.cumsum(random.standard_normal(count)))
        signs = random.uniform(0.5, 1.5, 3) * random.choice([-1.0, 1.0], 3)
        disturbed += self.drift * signs[0] * np.linspace(-1.0, 1.0, count)[np.rint(clock).astype(int)]
        disturbed += self.tilt * signs[1] * place + self.drag * abs(signs[2]) * self.direction
        force = self.force(self.position, self.inward) + BASE + self.level * disturbed
        last = int(np.argmax(force > self.trigger)) + 1 if np.any(force > self.trigger) else count
        found = ForceCurve(
            self.position + ORIGIN, force, self.stiffness, time=self.time, direction=self.direction, name=f"seed {seed}"
        )
        return found.chosen(np.arange(last))


@dataclasses.dataclass(frozen=True)
class Creep:
    """A force that grows and is held; 1/f noise and a drift of the position, in parts of its white noise."""

    truth: dict[str, float]
    count: int
    flicker: float = THIRD
    drift: float = 1.0

    def model(self):
        return model(StandardSolid(1e3, 1e3, 5.0), wk.Force)

    def curve(self, seed: int) -> ForceCurve:
        clean, random = ramp_and_hold(seed, tilt=0.0, count=self.count), np.random.default_rng(seed + 1_000_000)
        slow = self.flicker * coloured(random, self.count, 1.0)
        slow += self.drift * random.uniform(-1.5, 1.5) * np.linspace(-1.0, 1.0, self.count)
        return dataclasses.replace(clean, position=clean.position + 2e-9 * slow)


def blunt_cone(position, modulus, radius, half_angle):
    """A parabolic apex that goes over into a cone with a common tangent, pressed in by a depth: Sneddon's integrals."""
    slope = 1.0 / np.tan(half_angle)
    blend = radius * slope
    a = np.concatenate([np.linspace(0.0, blend, 4001)[:-1], np.geomspace(blend, 200.0 * blend, 20001)])
    b = np.minimum(a, blend)
    root, angle = np.sqrt(a**2 - b**2), np.arccos(np.divide(b, a, out=np.ones_like(a), where=a > 0.0))
    depth = a * ((a - root) / radius + slope * angle)
    cubic = (2.0 * a**3 - (2.0 * a**2 + b**2) * root) / (3.0 * radius)
    force = 2.0 * modulus * (cubic + 0.5 * slope * (a**2 * angle + b * root))
    assert depth[-1] > position.max()
    return np.interp(np.maximum(position, 0.0), depth, force)


@functools.cache
def film_curve(widest: float, nodes: int = 24) -> tuple[np.ndarray, np.ndarray]:
    """Depth in h^2/R, and force in E* h^3/R, of a paraboloid on a bonded incompressible film of thickness h.

    The kernel of a bonded layer (Hayes and others, J. Biomech. 5 (1972) 541, doi:10.1016/0021-9290(72)90010-3) makes
    the conditions of mixed type an integral equation of the second kind on the contact radius a,
    phi(t) - 1/pi int_0^a [k(t-s) + k(t+s)] phi(s) ds = d - t^2/R, F = 2 E* int_0^a phi dt, phi(a) = 0.
    """
    wave, measure = np.polynomial.legendre.leggauss(400)
    wave, measure = 20.0 * (wave + 1.0), 20.0 * measure
    hard = (2.0 * np.sinh(2.0 * wave) - 4.0 * wave) / (2.0 * np.cosh(2.0 * wave) + 4.0 * wave**2 + 2.0)

    def k(x):
        return np.tensordot(np.cos(x[..., None] * wave), measure * (1.0 - hard), 1)

    at, weight = np.polynomial.legendre.leggauss(nodes)
    radii = np.linspace(0.0, widest, 41)[1:]
    depths, loads = [0.0], [0.0]
    for a in radii:
        t, w = 0.5 * a * (at + 1.0), 0.5 * a * weight
        matrix = np.eye(nodes) - (k(t[:, None] - t) + k(t[:, None] + t)) * w / np.pi
        one, square = np.linalg.solve(matrix, np.stack([np.ones(nodes), t**2], axis=1)).T
        edge = (k(a - t) + k(a + t)) * w / np.pi
        depth = (a**2 + edge @ square) / (1.0 + edge @ one)
        depths.append(depth)
        loads.append(2.0 * float(w @ (depth * one - square)))
    return np.array(depths), np.array(loads)


def on_a_film(position, modulus, radius, thickness):
    """F at depths of a paraboloid on a film bonded to a rigid base; between computed radii by cubic splines."""
    from scipy.interpolate import CubicSpline

    depths, loads = film_curve(2.0)
    course = CubicSpline(np.sqrt(depths), loads)
    reduced = np.maximum(position, 0.0) * radius / thickness**2
    assert reduced.max() < depths[-1]
    return modulus * thickness**3 / radius * course(np.sqrt(reduced))


def harder_worlds(count: int) -> dict[str, World | Creep]:
    """The worlds, of curves with about `count` points."""
    twice, inward = there_and_back(-1e-6, 1e-6, count // 2)
    there, elastic = np.where(inward, 1.0, -1.0), {PATH: YOUNG, **LINE}
    even = np.arange(twice.size) * 1e-3
    part = 2 * count // 5
    out = np.concatenate([np.linspace(-1e-6, 1e-6, part), np.full(part // 2, 1e-6), np.linspace(1e-6, -1e-6, part)])
    held = np.repeat([1.0, 0.0, -1.0], [part, part // 2, part])
    paces = np.where(np.arange(count) < count // 3, 4.0, 1.0) * np.random.default_rng(0).gamma(4.0, 0.25, count)
    unevenly = np.cumsum(paces) - paces[0]
    short = -0.25e-6 + 1.35e-6 * unevenly / unevenly[-1]

    def ball(position, _):
        return hertz_on_spring(position, MODULUS, RADIUS, SPRING)

    def blunt(position, _):
        return blunt_cone(position, MODULUS, 1e-7, 1.2)

    def coated(position, _):
        return on_a_film(position, MODULUS, RADIUS, FILM)

    def hertz():
        return indented(wk.Paraboloid(RADIUS))

    def rounded():
        return indented(wk.RoundedCone(1e-7, 1.2))

    def film():
        medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(3e4, 0.5), FILM)], on=wk.Rigid())
        return wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Depth(0.0))

    young = {"bed.medium.layers[0].solid.young": YOUNG, **LINE}
    relaxed, shear, time = TRUE["creep"]
    solid = {f"{FIRST}relaxed_shear": relaxed, f"{FIRST}shear": shear, f"{FIRST}relaxation_time": time}
    everything = {"flicker": THIRD, "drift": 1.0, "tilt": 1.0, "drag": 1.0}
    return {
        "everything, held": Machine(
            ball, hertz, elastic, out, held > 0.0, stiffness=SPRING, walk=0.01, **everything,
            time=np.arange(out.size) * 1e-3, direction=held,
        ),
        "blunt tip in liquid": Machine(
            blunt, rounded, elastic, twice, inward, **{**everything, "drag": 3.0}, time=even, direction=there
        ),
        "bonded film": Machine(coated, film, young, twice, inward, **everything, time=even, direction=there),
        "triggered, uneven": Machine(
            ball, hertz, elastic, short, np.ones(count, dtype=bool), stiffness=SPRING, **{**everything, "drag": 0.0},
            time=unevenly * 1e-3, direction=np.ones(count), slow=coloured,
            trigger=float(ball(np.array([1e-6]), 0)[0]),
        ),
        "creep with drift": Creep({**solid, "contact_point": 4e-7, "baseline": 5e-11}, count),
    }  # fmt: skip
