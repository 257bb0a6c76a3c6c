"""Worlds of nanoindentations, written without the package: a blunt pyramid, a soft frame, drift, creep, slow noise.

Under the force F the contact depth follows from F = H A(h_c); the contact has S = 2 E_r sqrt(A/pi), and unloads as
(h - h_f)^m with the depth h = h_c + eps F/S at the peak.  The machine reads h + C_f F + drift + noise.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.fitting.curves.curve import ForceCurve

DIAMOND_COMPLIANCE = (1.0 - 0.07**2) / 1141e9
INTERCEPT, EXPONENT = 0.75, 1.5
IN, HELD, OUT = 1.0, 0.0, -1.0


def coloured(random, count, exponent=1.0):
    """Noise of unit variance with the spectrum f^-exponent, down to one period in eight times the length."""
    size = 8 * count
    frequency = np.fft.rfftfreq(size)
    frequency[0] = frequency[1]
    shape = frequency ** (-0.5 * exponent)
    drawn = np.fft.irfft(shape * np.fft.rfft(random.standard_normal(size)), size)[:count]
    return drawn / np.sqrt(np.mean(shape[1:] ** 2))


@dataclasses.dataclass(frozen=True)
class Sample:
    young: float = 72e9
    poisson: float = 0.17
    hardness: float = 9.3e9
    size: float = 0.0
    power: float = 0.5

    def hardness_at(self, height):
        """H (1 + l/h_c)^p: p = 1/2 of an indentation size effect, p = -1/2 of a blunt apex that touches elastically."""
        return self.hardness * (1.0 + self.size / np.maximum(height, 1e-15)) ** self.power

    @property
    def modulus(self):
        return 1.0 / ((1.0 - self.poisson**2) / self.young + DIAMOND_COMPLIANCE)


SILICA, SAPPHIRE, STEEL = Sample(), Sample(410e9, 0.24, 28e9), Sample(210e9, 0.3, 3.5e9)


@dataclasses.dataclass(frozen=True)
class Machine:
    """Area A = C0 h^2 + C1 h [m^2], frame compliance [m/N], noise of depth [m] and force [N], drift [m/s]."""

    coefficients: tuple[float, ...] = (24.5, 1.1e-6)
    compliance: float = 0.4e-6
    depth_noise: float = 0.2e-9
    slow_share: float = 1.0 / 3.0
    force_noise: float = 0.3e-6
    drift: float = 0.05e-9
    rate: float = 20.0

    def area(self, height):
        return sum(c * np.asarray(height) ** (2.0 ** (1 - n)) for n, c in enumerate(self.coefficients))

    def contact_depth(self, force, sample):
        """h_c where F = H(h_c) A(h_c)."""
        low, high = np.zeros_like(force), np.full_like(force, 1e-3)
        for _ in range(80):
            middle = 0.5 * (low + high)
            below = sample.hardness_at(middle) * self.area(middle) < force
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        return 0.5 * (low + high)


@dataclasses.dataclass(frozen=True)
class Truth:
    force: np.ndarray
    depth: np.ndarray
    contact_depth: np.ndarray
    area: np.ndarray
    stiffness: np.ndarray
    hardness: np.ndarray


def indentation(machine, sample, seed, *, peak=10e-3, levels=5, leg=10.0, hold=10.0, creep=0.02, low_hold=60.0,
                origin=300e-9, free=5.0, unload_to=0.3, peaks=()):  # fmt: skip
    """Return a curve with `levels` unloadings of growing peaks, and the true numbers at the end of each hold.

    `peaks` [N] are given in place of the greatest and their number.
    """
    random, rate = np.random.default_rng(seed), machine.rate
    if not len(peaks):
        peaks = peak * np.linspace(0.0, 1.0, levels + 1)[1:] ** 2 if levels > 1 else np.array([peak])

    def contact(force):
        return machine.contact_depth(np.maximum(force, 0.0), sample)

    def total(height, force):
        stiffness = 2.0 * sample.modulus * np.sqrt(machine.area(height) / np.pi)
        return height + INTERCEPT * np.divide(force, stiffness, out=np.zeros_like(stiffness), where=stiffness > 0.0)

    ticks = np.arange(int(free * rate))
    depth, force, direction = [-60e-9 * (1.0 - ticks / ticks.size)], [np.zeros(ticks.size)], [np.full(ticks.size, IN)]
    truth, start, rows = (0.0, 0.0, 0.0), 0.0, []
    for number, top in enumerate(peaks):
        up = np.linspace(start, top, int(leg * rate))[1:]
        tip, before, width = truth
        virgin, back = contact(up), before - width * (1.0 - (up / max(start / unload_to, 1e-30)) ** (1 / EXPONENT))
        outer = total(virgin, up)
        path = np.where((outer > back) | (before == 0.0), outer, back) if number else outer
        depth.append(path), force.append(up), direction.append(np.full(up.size, IN))
        ticks = np.arange(1, int(hold * rate) + 1) / rate
        held = contact(np.full(ticks.size, top)) * (1.0 + creep * np.log1p(ticks) / np.log1p(hold))
        depth.append(total(held, top + np.zeros(held.size)))
        force.append(np.full(ticks.size, top)), direction.append(np.full(ticks.size, HELD))
        tip = float(held[-1])
        area = float(machine.area(tip))
        stiffness = 2.0 * sample.modulus * np.sqrt(area / np.pi)
        deepest = tip + INTERCEPT * top / stiffness
        width = EXPONENT * top / stiffness
        last = number == len(peaks) - 1
        floor = 0.1 if last else unload_to
        down = top * np.linspace(1.0, floor, int(leg * rate))[1:]
        depth.append(deepest - width * (1.0 - (down / top) ** (1.0 / EXPONENT)))
        force.append(down), direction.append(np.full(down.size, OUT))
        rows.append((top, deepest, tip, area, stiffness, top / area))
        truth, start = (tip, deepest, width), floor * top
    if low_hold:
        count = int(low_hold * rate)
        depth.append(np.full(count, depth[-1][-1])), force.append(np.full(count, start))
        direction.append(np.full(count, HELD))
        down = start * np.linspace(1.0, 0.0, int(2.0 * rate))[1:]
        depth.append(deepest - width * (1.0 - (down / peaks[-1]) ** (1.0 / EXPONENT)))
        force.append(down), direction.append(np.full(down.size, OUT))
    depth, force = np.concatenate(depth), np.concatenate(force)
    time = np.arange(depth.size) / rate
    drift = machine.drift * random.uniform(0.5, 1.5) * random.choice([-1.0, 1.0])
    position = depth + machine.compliance * force + origin + drift * time
    position = position + machine.depth_noise * random.standard_normal(depth.size)
    position = position + machine.depth_noise * machine.slow_share * coloured(random, depth.size)
    noisy = force + machine.force_noise * random.standard_normal(depth.size)
    curve = ForceCurve(position, noisy, time=time, direction=np.concatenate(direction), name=f"seed {seed}")
    return curve, Truth(*np.array(rows).T)
