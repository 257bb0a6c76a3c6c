"""Waves in layers thin, thick, hard, soft and incompressible, against propagators of Airy's functions in 60 digits.

An in-plane wave is :math:`\\varphi = f(\\zeta)\\cos\\xi x` with :math:`f''''-2f''+f=0`, :math:`\\zeta=\\xi z`; its
displacements and tractions follow from f and three derivatives, which are passed on through a layer in closed form.
"""

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.media.layered.across import across_added, across_inside
from winkler.media.layered.pair_response import Mode, PairResponse
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import Wave, constants_of

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


def states(jet, shear, nu):
    """Return displacements times xi and tractions of f and its derivatives; both in columns."""
    moved = [
        [(nu * jet[0, j] + (1 - nu) * jet[2, j]) / (2 * shear) for j in (0, 1)],
        [((1 - nu) * jet[3, j] - (2 - nu) * jet[1, j]) / (2 * shear) for j in (0, 1)],
    ]
    return mp.matrix([*moved, [jet[1, j] for j in (0, 1)], [-jet[0, j] for j in (0, 1)]])


def jets(state, shear, nu):
    """Return f and its derivatives of such states."""
    rows = [[], [], [], []]
    for j in (0, 1):
        f, slope = -state[3, j], state[2, j]
        rows[0].append(f)
        rows[1].append(slope)
        rows[2].append((2 * shear * state[0, j] - nu * f) / (1 - nu))
        rows[3].append((2 * shear * state[1, j] + (2 - nu) * slope) / (1 - nu))
    return mp.matrix(rows)


def risen(jet, x):
    """Return f and its derivatives x above: f = (a + b t) cosh t + (c + d t) sinh t, at t = -x."""
    columns = []
    for j in (0, 1):
        b = (jet[3, j] - jet[1, j]) / 2
        four = jet[0, j], b, jet[1, j] - b, (jet[2, j] - jet[0, j]) / 2
        column = []
        for _ in range(4):
            a, b, c, d = four
            column.append((a - b * x) * mp.cosh(x) - (c - d * x) * mp.sinh(x))
            four = b + c, d, a + d, b
        columns.append(column)
    return mp.matrix(columns).T


def references(numbers):
    """Return the compliances times xi / 2 of a stack at its surface, by part."""
    below = len(numbers) % 3
    in_plane, across = mp.matrix([[0, 0], [0, 0], [1, 0], [0, 1]]), (mp.mpf(0), mp.mpf(1))
    if below:
        in_plane, across = states(mp.matrix([[1, 0], [-1, 1], [1, -2], [-1, 3]]), *numbers[:2]), (1 / numbers[0], 1)
    for i in range(below, len(numbers), 3):
        shear, nu, x = numbers[i : i + 3]
        in_plane = states(risen(jets(in_plane, shear, nu), x), shear, nu)
        moved, loaded = across
        c, s = mp.cosh(x), mp.sinh(x)
        across = c * moved + s * loaded / shear, c * loaded + s * shear * moved
    u, w, t, n = ([in_plane[i, 0], in_plane[i, 1]] for i in range(4))
    whole = 2 * (t[0] * n[1] - t[1] * n[0])
    return {
        Wave.NORMAL: -(w[1] * t[0] - w[0] * t[1]) / whole,
        Wave.ALONG: -(u[0] * n[1] - u[1] * n[0]) / whole,
        Wave.COUPLING: (u[1] * t[0] - u[0] * t[1]) / whole,
        Wave.ACROSS: across[0] / across[1] / 2,
    }


def digits_for(numbers):
    """Return 60 digits and those that growing exponentials cost."""
    return 60 + int(2 * sum(numbers[len(numbers) % 3 + 2 :: 3]))


def condition(numbers, part):
    """Return by how much relative errors of the input are multiplied, summed over moduli, ratios and thicknesses."""
    step, whole = mp.mpf(10) ** -30, references(numbers)[part]
    found = mp.mpf(0)
    for i, number in enumerate(numbers):
        moved = [*numbers[:i], number * (1 - step), *numbers[i + 1 :]]
        found += abs(references(moved)[part] - whole) / (step * abs(whole))
    return found


@pytest.fixture(autouse=True)
def _digits():
    with mp.workdps(60):
        yield


@pytest.mark.slow
def test_waves_keep_all_digits():
    """All parts, at the surface of a hundred stacks.

    The coupling alone may be ill-conditioned: it goes with 1 - 2 nu, of both signs in a stack.
    """
    for layers, base, xi in corners():
        numbers = inputs(layers, base, xi)
        mp.mp.dps = digits_for(numbers)
        wanted, body = references(numbers), StackBody(layers, base)
        for part in Wave:
            found = mp.mpf(float(body.waves(part, np.array([xi]))[0]))
            if abs(wanted[part]) < mp.mpf(10) ** -50 * wanted[Wave.ALONG]:
                # incompressible solids do not couple: what is left is rounding of both others
                assert abs(found) <= PRECISION * mp.sqrt(wanted[Wave.NORMAL] * wanted[Wave.ALONG])
                continue
            error = abs(found / wanted[part] - 1)
            if part is Wave.COUPLING and error > PRECISION:
                error /= condition(numbers, part) * 2.0**-52 / PRECISION
            assert error <= PRECISION, (part, layers, base, xi)


def test_a_pair_is_the_sum_of_both_bodies():
    second = wk.Elastic(3e8, 0.2)
    own = {Wave.NORMAL: mp.mpf(1 - 0.2) / (2 * mp.mpf(second.shear)), Wave.ACROSS: 1 / (2 * mp.mpf(second.shear))}
    own[Wave.ALONG] = own[Wave.NORMAL]
    for layers, base, xi in list(corners())[:6]:
        numbers = inputs(layers, base, xi)
        mp.mp.dps = digits_for(numbers)
        wanted, medium = references(numbers), wk.CoatedHalfSpace(layers, base, second)
        for mode in (Mode.NORMAL, Mode.ALONG, Mode.ACROSS, Mode.TANGENTIAL):
            response = medium.responding(mode)
            compliance = sum(weight * (wanted[part] + own[part]) for part, weight in mode.value)
            found = float(response.whole(np.array([xi]))[0]) / mp.mpf(response.modulus)
            assert abs(found / compliance - 1) < PRECISION


def test_one_body_is_the_same_value_as_a_coating_and_as_a_stack():
    layer, base = wk.Layer(wk.Elastic(2e9, 0.3), 1e-3), wk.Elastic(5e9, 0.2)
    stack = wk.StackedHalfSpace([layer], on=base)
    for mode in Mode:
        coating = wk.CoatedHalfSpace([layer], on=base).responding(mode)
        assert isinstance(coating, PairResponse)
        assert coating == stack.responding(mode)


def test_without_layers_a_stack_is_a_half_space():
    solid, xi = wk.Elastic(3e9, 0.3), np.array([0.1, 3.0])
    layered = StackBody((wk.Layer(solid, 1.0),), solid)
    for part in Wave:
        np.testing.assert_allclose(StackBody((), solid).waves(part, xi), layered.waves(part, xi), rtol=2e-14)


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


def test_decay_is_finite_on_a_turned_path_where_exponents_are_complex():
    """The regression of issue 39: inf times zero from (p^2 - 4 q) / 4 < 0 and 800 of xi h on; by mpmath there."""
    constants = constants_of(wk.TransverselyIsotropic(c11=1.2, c12=0.3, c13=0.5, c33=1.5, c44=0.6))
    assert constants.split < 0.0
    x = np.array([1.0, 30.0, 800.0, 1e5]) * np.exp(1j * np.pi / 12.0)
    found = np.array(constants.decay(x))
    assert np.all(np.isfinite(found))
    with mp.workdps(40):
        matrix = mp.matrix([[constants.total, -constants.product], [1.0, 0.0]])
        for place in (0, 1):
            expected = mp.expm(-matrix * mp.mpc(x[place]))
            np.testing.assert_allclose(
                found[:, place], [complex(expected[i, j]) for i in (0, 1) for j in (0, 1)], rtol=1e-12
            )
    assert np.max(np.abs(found[:, 2:])) < 1e-200
