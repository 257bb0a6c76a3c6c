"""Curves with known events, written without the package: closed forms, disturbances of machines, and what happened."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.fitting.curves.curve import ForceCurve

RADIUS, MODULUS = 5e-6, 1.33e4
DEEP, FAR = 1e-6, 2e-6
LEVEL = 3e-11
"""White noise of AFM curves [N]; the greatest force is 1300 times as much."""
RATE = 1000.0
"""Points per second."""


def slow_noise(random, count, exponent=1.0):
    """Noise of unit variance with the power spectrum f^-exponent, down to a period of eight times the length."""
    size = 8 * count
    frequency = np.fft.rfftfreq(size)
    frequency[0] = frequency[1]
    shape = frequency ** (-0.5 * exponent)
    drawn = np.fft.irfft(shape * np.fft.rfft(random.standard_normal(size)), size)[:count]
    return drawn / np.sqrt(np.mean(shape[1:] ** 2))


def motion(count, hold=0):
    """Positions in, held and out, with their directions."""
    leg = np.linspace(-FAR, DEEP, count)
    position = np.concatenate([leg, np.full(hold, DEEP), leg[::-1]])
    return position, np.repeat([1.0, 0.0, -1.0], [count, hold, count])


def hertz(depth):
    """F = 4/3 E* sqrt(R) d^(3/2)."""
    return 4.0 / 3.0 * MODULUS * np.sqrt(RADIUS) * np.maximum(depth, 0.0) ** 1.5


def relaxed(elastic, rate, loss=0.3, time=0.1):
    """A standard solid that has lost a part of its modulus after a time: dq/dt = dF/dt - q/time, F - loss (F - q)."""
    branch, q = np.zeros(elastic.size), 0.0
    fade = np.exp(-1.0 / (rate * time))
    for k in range(1, elastic.size):
        q = fade * q + 0.5 * (1.0 + fade) * (elastic[k] - elastic[k - 1])
        branch[k] = q
    return elastic - loss * (elastic - branch)


@dataclasses.dataclass(frozen=True)
class AfmWorld:
    """A ball on a gel, pressed by a stage that moves evenly; sizes in parts of the white noise unless units are given.

    `jump` is a drop of force while pressed in, `snap` and `pull` the tension of snap-in and pull-off, `ripple` the
    amplitude and `period` [m] of interference, `late` the time [points] by which the force is recorded too late.
    """

    count: int = 600
    hold: int = 0
    slow: float = 0.33
    exponent: float = 1.0
    tilt: float = 0.0
    drift: float = 0.0
    drag: float = 0.0
    jump: float = 0.0
    snap: float = 0.0
    pull: float = 0.0
    ripple: float = 0.0
    period: float = 3e-7
    late: float = 0.0
    relaxing: bool = False
    shrink: float = 1.0

    def curve(self, seed):
        random = np.random.default_rng(seed)
        position, direction = motion(self.count, self.hold)
        total = position.size
        time = np.arange(total) / RATE
        elastic = hertz(position) * self.shrink
        force = np.maximum(relaxed(elastic, RATE), 0.0) if self.relaxing else elastic
        inward = direction > 0.0
        place = int(self.count * random.uniform(0.8, 0.95))
        force = force - LEVEL * self.jump * (np.arange(total) >= place) * (force > 0.0)
        force = force - LEVEL * self.snap * inward * (position > 0.0) * (position < 3e-8)
        sticking = ~inward & (position < 0.0) & (position > -2e-7)
        force = force + sticking * LEVEL * self.pull * position / 2e-7
        if self.late:
            force = np.interp(time - self.late / RATE, time, force)
        phase = 2.0 * np.pi * random.uniform()
        force = force + LEVEL * self.ripple * np.cos(2.0 * np.pi * position / self.period + phase)
        along = np.linspace(-1.0, 1.0, total)
        disturbed = random.standard_normal(total) + self.slow * slow_noise(random, total, self.exponent)
        disturbed += self.tilt * position / DEEP + self.drift * along + self.drag * direction
        return ForceCurve(position, force + LEVEL * disturbed, 0.05, time=time, name=f"seed {seed}"), place


@dataclasses.dataclass(frozen=True)
class IndenterWorld:
    """A nanoindenter that drives the force: h = sqrt(F), stiff unloading, creep, pop-ins as steps of depth.

    `steps` are fractions of the greatest force with their steps of depth, in parts of the greatest depth.
    """

    count: int = 600
    hold: int = 200
    level: float = 5e-4
    slow: float = 0.33
    steps: tuple[tuple[float, float], ...] = ()

    def curve(self, seed):
        random = np.random.default_rng(seed)
        up = np.linspace(0.0, 1.0, self.count)
        depth = np.sqrt(up)
        places = []
        for share, size in self.steps:
            places.append(int(np.searchsorted(up, share)))
            depth[places[-1] :] += size
        creep = 0.01 * np.log1p(np.arange(1, self.hold + 1) / 30.0)
        held = depth[-1] + creep
        down = np.linspace(1.0, 0.0, self.count + 1)[1:]
        out = held[-1] - 0.1 * (1.0 - down ** (2.0 / 3.0))
        depth = np.concatenate([depth, held, out])
        force = np.concatenate([up, np.ones(self.hold), down])
        total = depth.size
        depth = depth + self.level * (random.standard_normal(total) + self.slow * slow_noise(random, total))
        force = force + self.level * random.standard_normal(total)
        return ForceCurve(1e-6 * depth, 1e-3 * force, time=np.arange(total) / RATE, name=f"seed {seed}"), places
