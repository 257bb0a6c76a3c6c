"""Waves in layers thin, thick, hard, soft and incompressible, against propagators of Airy's functions in 60 digits.

An in-plane wave is :math:`\\varphi = f(\\zeta)\\cos\\xi x` with :math:`f''''-2f''+f=0`, :math:`\\zeta=\\xi z`; its
displacements and tractions follow from f and three derivatives, which are passed on through a layer in closed form.
"""

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.media.layered.across import across_added, across_inside, climbed_across

XI_H = (1e-12, 1e-8, 1e-4, 1e-2, 0.3, 0.999, 1.001, 2.0, 5.0, 20.0, 100.0, 700.0)
POISSON = (0.0, 0.2, 0.3, 0.45, 0.4999, 0.4999999, 0.5)
CONTRASTS = (-6, -3, -1, 0, 1, 3, 6)
CORNERS = 100
PRECISION = 1e-14


def corners():
    """Yield stacks, their bases and a wave number: thickest layers from 1e-12 to 700 over it."""
    rng = np.random.default_rng(39)
    for _ in range(CORNERS):
        layers = []
        for _ in range(rng.integers(1, 4)):
            solid = wk.Elastic(1e9 * 10.0 ** rng.choice(CONTRASTS), float(rng.choice(POISSON)))
            layers.append(wk.Layer(solid, float(10.0 ** rng.choice((-3, -1, 0, 1)))))
        base = wk.Elastic(1e9, float(rng.choice((0.0, 0.3, 0.5)))) if rng.random() < 0.6 else wk.Rigid()
        yield tuple(layers), base, float(rng.choice(XI_H)) / max(layer.thickness for layer in layers)


def inputs(layers, base, xi):
    """Return shear moduli, Poisson's ratios, and thicknesses over the wave, from the base."""
    below = [] if isinstance(base, wk.Rigid) else [base.shear, base.poisson]
    return [mp.mpf(part) for part in below] + [
        mp.mpf(part)
        for layer in reversed(layers)
        for part in (layer.solid.shear, layer.solid.poisson, mp.mpf(layer.thickness) * mp.mpf(xi))
    ]


def across_reference(numbers):
    """Return the compliance across the wave, of displacements times xi and tractions."""
    moved, loaded = mp.mpf(0), mp.mpf(1)
    if len(numbers) % 3:
        moved, numbers = 1 / numbers[0], numbers[2:]
    for i in range(0, len(numbers), 3):
        shear, _, x = numbers[i : i + 3]
        moved, loaded = (
            mp.cosh(x) * moved + mp.sinh(x) * loaded / shear,
            mp.cosh(x) * loaded + mp.sinh(x) * shear * moved,
        )
    return moved / loaded


@pytest.fixture(autouse=True)
def _digits():
    with mp.workdps(60):
        yield


def test_a_wave_across_keeps_all_digits():
    for layers, base, xi in corners():
        found = climbed_across(layers, base, np.array([xi]))[0][0]
        reference = across_reference(inputs(layers, base, xi))
        assert abs(mp.mpf(float(found)) / reference - 1) < PRECISION, (layers, base, xi)


def test_a_wave_across_keeps_its_digits_at_depth():
    mp.mp.dps = 700  # the differences below lose up to 600 of them
    rng = np.random.default_rng(3)
    for _ in range(CORNERS):
        own, x = 10.0 ** rng.uniform(-6, 6), 10.0 ** rng.uniform(-12, 2.4)  # exp(-2 x) is a number
        start = x * rng.choice((0.0, 1e-6, 0.3, 0.9, 1.0))
        left, whole, stiff = mp.mpf(x) - mp.mpf(start), mp.mpf(x), mp.mpf(own)
        top = mp.cosh(whole) + stiff * mp.sinh(whole)
        moved = (stiff * mp.cosh(left) + mp.sinh(left)) / top
        loaded = (mp.cosh(left) + stiff * mp.sinh(left)) / top
        fade = mp.exp(-mp.mpf(start))
        # exp(-start) has the condition number start: the rounding of a depth is multiplied by it
        allowed = PRECISION * max(1.0, x)
        for found, references in (
            (across_inside(own, x, start), (moved, loaded)),
            (across_added(own, x, start), (moved - fade, loaded - fade)),
        ):
            for part, reference in zip(found, references, strict=True):
                # only what a layer adds may vanish, on the surface
                assert abs(mp.mpf(float(part)) - reference) <= allowed * abs(reference), (own, x, start)
