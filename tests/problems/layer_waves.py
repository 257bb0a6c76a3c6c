r"""Shear of a stack by another route than the package: matrix exponentials, and least energy on a disc.

The field of a wave follows from Hooke's law and equilibrium, with u_x = U sin(k x), u_z = W cos(k x), crossed layer by
layer.  A disc's tractions are written as tau_0(r) + tau_2(r) exp(2 i theta), or around the axis, by functions whose
Hankel transforms are spherical Bessel functions of the same order; coefficients make the complementary energy least.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import expm
from scipy.special import jv, spherical_jn

NODES = 16
LONGEST = 21.0
"""Largest wave number, over the inverse thickness of the uppermost layer."""


def _plane(poisson):
    """d/d(kz) of (U, W, T, S), tractions over k times the shear modulus, lambda eliminated: nu = 1/2 is allowed."""
    n, m = poisson / (1.0 - poisson), (1.0 - 2.0 * poisson) / (1.0 - poisson)
    return np.array(
        [[0.0, 1.0, 1.0, 0.0], [-n, 0.0, 0.0, 0.5 * m], [2.0 / (1.0 - poisson), 0.0, 0.0, n], [0.0, 0.0, -1.0, 0.0]]
    )


def crossed(poisson, depth):
    """Return what carries (U, W, T, S) from the lower face of a layer to its upper one, `depth` in xi h."""
    return expm(-_plane(poisson) * depth[:, None, None])


def base(on):
    """Two fields (U, W, T, S) at the upper face of a rigid base, or of a half-space: those that decay."""
    if on is None:
        return np.eye(4)[:, 2:]
    image = (_plane(on[1]) - np.eye(4)) @ (_plane(on[1]) - np.eye(4))  # it is the space of what decays
    return image[:, :2] * np.array([1.0, 1.0, on[0], on[0]])[:, None]


def compliances(layers, on, xi):
    """C_L and C_T times xi at wave numbers, of layers (shear, poisson, thickness) on (shear, poisson) or None."""
    fields = np.broadcast_to(base(on), (xi.size, 4, 2))
    around = np.full(xi.size, 0.0 if on is None else 1.0 / on[0])
    for shear, poisson, thickness in reversed(layers):
        scale = np.array([1.0, 1.0, shear, shear])[:, None]
        fields = scale * (crossed(poisson, xi * thickness) @ (fields / scale))
        fields = fields / np.max(np.abs(fields), axis=(1, 2), keepdims=True)
        fall = np.tanh(xi * thickness)
        around = (shear * around + fall) / (1.0 + shear * around * fall) / shear
    along = -(fields[:, :2] @ np.linalg.inv(fields[:, 2:]))[:, 0, 0]
    return along, around


class Stack:
    """The compliances of a stack on a rule of wave numbers."""

    def __init__(self, layers, on, longest_disc):
        thickness = layers[0][2]
        step = min(1.0 / thickness, 6.0 / longest_disc)
        edges = [0.0, *(step * 2.0**-p for p in range(10, 0, -1))]
        edges = np.array([*edges, *np.arange(step, LONGEST / thickness + step, step)])
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        self.xi = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (nodes + 1.0)).ravel()
        self.weights = (0.5 * np.diff(edges)[:, None] * weights).ravel()
        self.along, self.across = compliances(layers, on, self.xi)
        shear, poisson, _ = layers[0]
        self.short = ((1.0 - poisson) / shear, 1.0 / shear)

    def energy(self, values, short, orders, a):
        """Integrals of values(xi) j_m(xi a) j_n(xi a): what the shortest waves add is summed in closed form."""
        j = np.array([spherical_jn(n, self.xi * a) for n in orders])
        whole = (j * self.weights * (values - short)) @ j.T
        return whole + short * np.diag([0.5 * np.pi / (2 * n + 1) / a for n in orders])


def twist_stiffness(stack, a, count=16):
    """k_phi, of complex moduli complex: torque 4 pi lim T/xi, energy pi int C T^2 xi dxi."""
    orders = [2 * i + 1 for i in range(count)]
    matrix = 2.0 * np.pi * stack.energy(stack.across, stack.short[1], orders, a)
    torque = np.zeros(count)
    torque[0] = 4.0 * np.pi * a / 3.0
    return (torque @ np.linalg.solve(matrix, torque)).item()


def shear_stiffness(stack, a, count=16):
    """k_x with tractions tau_0 and tau_2: amplitudes T_0 - T_2 along the wave, T_0 + T_2 across."""
    orders = [2 * i for i in range(count)]
    turned = [2 * i + 2 for i in range(count)]
    every = [2 * i for i in range(count + 1)]
    along = stack.energy(stack.along, stack.short[0], every, a)
    across = stack.energy(stack.across, stack.short[1], every, a)
    zero, two = [n // 2 for n in orders], [n // 2 for n in turned]
    mean, half = along + across, across - along
    matrix = np.pi * np.block([[mean[np.ix_(zero, zero)], half[np.ix_(zero, two)]],
                               [half[np.ix_(two, zero)], mean[np.ix_(two, two)]]])  # fmt: skip
    force = np.zeros(2 * count)
    force[0] = 2.0 * np.pi
    return (force @ np.linalg.solve(matrix, force)).item()


def sliding_disc(stack, pressure, a, c, order, count=10):
    """Partial slip with the stick radius c, of a twist (order 1) or a push (order 0): motion and load over mu.

    Outside of c the traction is the pressure itself (mu = 1); inside a series is added that makes the motion rigid, and
    whose singularity at c vanishes.
    """

    def borne(r):
        # inside of c any traction will do: around the axis a smooth one is odd in r
        s = np.minimum(r / c, 1.0)
        return pressure(r) * (s * (15.0 - 10.0 * s**2 + 3.0 * s**4) / 8.0) ** order

    nodes, weights = np.polynomial.legendre.leggauss(100)
    angle = 0.25 * np.pi * (nodes + 1.0)
    r, area = a * np.sin(angle), 0.25 * np.pi * weights * a * np.cos(angle) * a * np.sin(angle)
    p = borne(r)
    slides = jv(order, np.outer(stack.xi, r)) @ (area * p)
    values = stack.across if order else 0.5 * (stack.along + stack.across)
    short = stack.short[1] if order else 0.5 * sum(stack.short)
    orders = [2 * i + order for i in range(count)]
    matrix = 2.0 * np.pi * stack.energy(values, short, orders, c)
    j = np.array([spherical_jn(n, stack.xi * c) for n in orders])
    # the same energy with what slides: short waves in space, by the line load of the pressure
    x = 0.5 * c * (nodes + 1.0)
    place = np.array([_line_load(borne, value, a, order) for value in x])
    sign = (-1.0) ** np.arange(count)
    rising = np.array([np.polynomial.legendre.Legendre.basis(n)(x / c) for n in orders])
    direct = short * 0.5 * np.pi * sign * ((rising * 0.5 * weights) @ place)
    mixed = 2.0 * np.pi * (direct + (j * stack.weights * (values - short)) @ slides)
    load = np.zeros(count)
    load[0] = 4.0 * np.pi * c / 3.0 if order else 2.0 * np.pi
    moved, forced = np.linalg.solve(matrix, np.column_stack([load, mixed])).T
    motion = float(sign @ forced / (sign @ moved))
    series = motion * moved - forced
    moment = 2.0 * np.pi * float(np.sum(area * p * r**order))
    return motion, moment + float(load @ series)


def _line_load(pressure, x, a, order):
    """q with T(xi) = int q(x) cos or sin(xi x) dx: (2/pi) int_x^a p r^(1-order) x^order / sqrt(r^2 - x^2) dr."""
    nodes, weights = np.polynomial.legendre.leggauss(80)
    y = 0.5 * np.sqrt(a * a - x * x) * (1.0 - np.cos(0.5 * np.pi * (nodes + 1.0)))
    slope = 0.25 * np.pi * np.sqrt(a * a - x * x) * np.sin(0.5 * np.pi * (nodes + 1.0))
    r = np.hypot(x, y)
    return 2.0 / np.pi * float(np.sum(weights * slope * pressure(r) * (x / r) ** order))


def excesses(layers, on, xi):
    """Return M of pressures and of shear along the wave, of layers (shear, poisson, thickness) on (shear, poisson)."""
    fields = np.broadcast_to(base(on), (xi.size, 4, 2))
    for shear, poisson, thickness in reversed(layers):
        scale = np.array([1.0, 1.0, shear, shear])[:, None]
        fields = scale * (crossed(poisson, xi * thickness) @ (fields / scale))
        fields = fields / np.max(np.abs(fields), axis=(1, 2), keepdims=True)
    compliance = -(fields[:, :2] @ np.linalg.inv(fields[:, 2:]))
    shear, poisson, _ = layers[0]
    short = (1.0 - poisson) / shear
    return compliance[:, 1, 1] / short - 1.0, compliance[:, 0, 0] / short - 1.0
