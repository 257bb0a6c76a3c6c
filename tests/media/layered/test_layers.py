"""The compliance of a stack: against the closed form of one layer and against all modes of all layers at once."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.materials.elastic import Elastic, Rigid
from winkler.materials.layered import Layer
from winkler.media.layered.pair_response import Mode, PairResponse
from winkler.media.layered.stack import StackBody

WAVES = np.array([1e-7, 1e-4, 3e-3, 0.05, 0.39, 0.41, 0.99, 1.01, 2.5, 7.0])


def one_layer(xi: float, young: float, poisson: float, base: float, base_poisson: float) -> float:
    """1 + M of one layer of thickness 1 on a half-space (theory 8.2), in 40 digits."""
    with mp.workdps(40):
        x, young, poisson, base, base_poisson = (mp.mpf(v) for v in (xi, young, poisson, base, base_poisson))
        al = young / (1 + poisson) / (base / (1 + base_poisson))
        g1, g3 = 3 - 4 * poisson, 3 - 4 * base_poisson
        a, b, e = (al * g3 - g1) / (1 + al * g3), (al - 1) / (al + g1), mp.exp(-2 * x)
        return float((1 + 4 * b * x * e - a * b * e**2) / (1 - (a + b + 4 * b * x**2) * e + a * b * e**2))


def all_modes(xi: float, layers: list[tuple[float, float, float]], base: tuple[float, float] | None) -> float:
    """C(xi): four waves in each layer, two in the base, every condition in one matrix, in 60 digits."""
    with mp.workdps(60):
        xi = mp.mpf(xi)

        def modes(young: float, poisson: float, z: mp.mpf) -> mp.matrix:
            nu, shear = mp.mpf(poisson), mp.mpf(young) / (2 * (1 + mp.mpf(poisson)))
            kappa, x = 3 - 4 * nu, xi * z
            columns = []
            for s in (1, -1):  # e^{-s x}; the stresses by Hooke's law from the displacements
                fade = mp.exp(-s * x)
                # displacements, their derivatives by x, and the dilatation over (1 - 2 nu), finite at nu = 1/2
                for u, w, du, dw, swell in (
                    (1, s, -s, -1, 0),
                    (x, s * x + kappa, 1 - s * x, s - s * (s * x + kappa), -2 * s),
                ):
                    loads = [shear * xi * (du - w), 2 * shear * xi * (dw + nu * swell)]
                    columns.append([part * fade for part in (u, w, *loads)])
            return mp.matrix(columns).T

        size = 4 * len(layers) + (2 if base else 0)
        matrix, right = mp.zeros(size), mp.zeros(size, 1)
        row = 0
        first = modes(layers[0][0], layers[0][1], mp.mpf(0))
        matrix[0:2, 0:4] = first[2:4, 0:4]
        right[1] = -1
        row = 2
        for i, (young, nu, h) in enumerate(layers):
            lower = modes(young, nu, mp.mpf(h))
            if i + 1 < len(layers):
                upper, count = modes(layers[i + 1][0], layers[i + 1][1], mp.mpf(0)), 4
            elif base:
                upper, count = modes(base[0], base[1], mp.mpf(0)), 2
            else:
                upper, count = None, 2
            for k in range(4 if upper is not None else 2):
                for j in range(4):
                    matrix[row + k, 4 * i + j] = lower[k, j]
                if upper is not None:
                    for j in range(count):
                        matrix[row + k, 4 * i + 4 + j] = -upper[k, j]
            row += 4 if upper is not None else 2
        solution = mp.lu_solve(matrix, right)
        return float(mp.fsum(first[1, j] * solution[j] for j in range(4)))


CASES = [
    (10.0, 0.3, 1.0, 0.3),
    (0.1, 0.5, 1.0, 0.3),
    (1e-4, 0.5, 1.0, 0.2),
    (1e4, 0.1, 1.0, 0.5),
    (2.0, -0.5, 3.0, 0.0),
]


@pytest.mark.parametrize(("young", "poisson", "base", "base_poisson"), CASES)
def test_one_layer(young, poisson, base, base_poisson):
    response = PairResponse(Mode.NORMAL, StackBody((Layer(Elastic(young, poisson), 1.0),), Elastic(base, base_poisson)))
    want = np.array([one_layer(xi, young, poisson, base, base_poisson) for xi in WAVES]) - 1.0
    np.testing.assert_allclose(response.excess(WAVES), want, rtol=0, atol=3e-14 * (1.0 + np.abs(want).max()))


@pytest.mark.parametrize(("young", "poisson", "base", "base_poisson"), CASES)
def test_cut_into_equal_layers_it_is_the_same(young, poisson, base, base_poisson):
    solid, below = Elastic(young, poisson), Elastic(base, base_poisson)
    whole = PairResponse(Mode.NORMAL, StackBody((Layer(solid, 1.0),), below)).excess(WAVES)
    layers = tuple(Layer(solid, h) for h in (0.3, 1e-5, 0.2, 0.49999))
    parts = PairResponse(Mode.NORMAL, StackBody(layers, below)).excess(WAVES)
    np.testing.assert_allclose(parts, whole, rtol=0, atol=1e-13 * (1.0 + np.abs(whole).max()))


STACKS = [
    ([(200.0, 0.2, 0.3), (3.0, 0.45, 1.1), (70.0, 0.33, 0.05)], (10.0, 0.25)),
    ([(1.0, 0.5, 0.7), (1e4, 0.3, 0.01), (1.0, 0.5, 2.0)], None),
    ([(1e-2, 0.4, 0.1), (1e2, 0.0, 5.0)], (1e-2, 0.5)),
]


@pytest.mark.parametrize(("layers", "base"), STACKS)
@pytest.mark.parametrize("xi", [1e-3, 0.2, 1.7, 9.0])
def test_three_layers_against_all_modes_at_once(layers, base, xi):
    stack = tuple(Layer(Elastic(young, nu), h) for young, nu, h in layers)
    response = PairResponse(Mode.NORMAL, StackBody(stack, Elastic(*base) if base else Rigid()))
    compliance = 2.0 / (response.modulus * xi) * (1.0 + response.excess(np.array([xi]))[0])
    assert compliance == pytest.approx(all_modes(xi, layers, base), rel=2e-11)


def test_a_stack_of_one_solid_is_a_half_space():
    solid = Elastic(3.0, 0.37)
    layers = tuple(Layer(solid, h) for h in (0.1, 1.0, 1e-4))
    for mode in (Mode.NORMAL, Mode.TANGENTIAL):
        assert np.max(np.abs(PairResponse(mode, StackBody(layers, solid)).excess(WAVES))) < 2e-15


def test_complex_wave_numbers_continue_the_real_ones():
    """Cauchy: the derivative along the imaginary direction is i times that along the real one."""
    layers = Layer(Elastic(20.0, 0.3), 1.0), Layer(Elastic(1.0, 0.5), 0.2)
    response = PairResponse(Mode.NORMAL, StackBody(layers, Elastic(5.0, 0.3)))
    xi, h = np.array([0.3, 0.8, 2.0]), 1e-5
    real = (response.excess(xi + h) - response.excess(xi - h)) / (2 * h)
    imaginary = (response.excess(xi + 1j * h) - response.excess(xi - 1j * h)) / (2j * h)
    np.testing.assert_allclose(imaginary, real, rtol=1e-7)


def test_an_elastic_counterpart_adds_its_own_compliance():
    layers, on = (Layer(Elastic(10.0, 0.3), 1.0),), Elastic(1.0, 0.3)
    alone, pair = (PairResponse(Mode.NORMAL, StackBody(layers, on), body) for body in (Rigid(), Elastic(4.0, 0.2)))
    xi = WAVES
    added = 2.0 / (pair.modulus * xi) * (1 + pair.excess(xi)) - 2.0 / (alone.modulus * xi) * (1 + alone.excess(xi))
    np.testing.assert_allclose(added, 2.0 * (1 - 0.2**2) / 4.0 / xi, rtol=1e-9)


# ------------------------------------------------------------------------------------------------------- bad input

ONE = Layer(Elastic(1.0, 0.3), 1.0)
SIX = np.arange(1.0, 7.0)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: wk.CoatedHalfSpace(ONE, on=Rigid()), "give a list of Layer"),
        (lambda: wk.CoatedHalfSpace([ONE, None], on=Rigid()), r"layers\[1\] is a NoneType; give a list of Layer"),
        (lambda: wk.CoatedHalfSpace([ONE], on=None), "on is a NoneType; give Elastic"),
        (lambda: wk.CoatedHalfSpace([ONE], on=wk.PowerLawGraded(1.0, 1.0, 0.2, 0.3)), "on is a PowerLawGraded"),
        (lambda: Layer(wk.PowerLawGraded(1.0, 1.0, 0.2, 0.3), 1.0), "solid is a PowerLawGraded; give Elastic"),
        (lambda: Layer(wk.TransverselyIsotropic(10.0, 4.0, 3.5, 12.0, 3.0), 1.0), "solid is a TransverselyIsotropic"),
        (lambda: Layer("steel", 1.0), "solid is a str; give Elastic"),
        (lambda: Layer(Elastic(1.0, 0.3), None), "thickness is None; it must be a positive, finite number in m"),
        (lambda: Layer(Elastic(1.0, 0.3), 0.0), "leave a layer without thickness out"),
        (lambda: Layer(Elastic(1.0, 0.6), 1.0), "poisson is 0.6"),
        (
            lambda: wk.TabulatedGrading([0.0, 1.0, 1.0], SIX[:3], [0.3] * 3),
            "depths does not rise from index 1 .*: begin with 0, sort the table",
        ),
        (lambda: wk.TabulatedGrading([0.1, 1.0], [1.0, 2.0], [0.3] * 2), "begin with 0"),
        (
            lambda: wk.TabulatedGrading([0.0, math.inf], [1.0, 2.0], [0.3] * 2),
            "depths is inf at index 1; .*: begin with 0",
        ),
        (
            lambda: wk.TabulatedGrading([0.0, 1.0], [1.0, math.nan], [0.3] * 2),
            "youngs is .*; give a row of at least 2 positive, finite numbers in Pa",
        ),
        (
            lambda: wk.TabulatedGrading([0.0, 1.0], [1.0, 2.0], [0.3, math.nan]),
            "poissons is .*; give a row of at least 2 numbers above -1 and at most 0.5",
        ),
        (lambda: wk.TabulatedGrading([0.0], [1.0], [0.3]), "depths has 1 number; give a row of at least 2"),
        (
            lambda: wk.TabulatedGrading([[0.0, 1.0]], [[1.0, 2.0]], [[0.3, 0.3]]),
            r"depths has the shape \(1, 2\); give a row",
        ),
        (lambda: wk.ExponentialGrading(1.0, 2.0, 0.0, 0.3), "depth_scale is 0.0; it must be a positive"),
        (lambda: wk.ExponentialGrading(1.0, True, 1.0, 0.3), "deep_young is True"),
        (lambda: wk.SigmoidalGrading(1.0, 2.0, 1.0, -1.0, 0.3), "transition_width is -1.0"),
        (lambda: wk.DepthGradedHalfSpace(None), "grading is a NoneType; give a grading: ExponentialGrading"),
        (lambda: wk.DepthGradedHalfSpace(wk.ExponentialGrading(1.0, 2.0, 1.0, 0.3), tolerance=math.nan), "tolerance"),
        (lambda: wk.MeasuredBed(SIX, SIX[::-1], SIX), "stiffnesses does not rise from index 0"),
        (lambda: wk.MeasuredBed(SIX, SIX, SIX[:5]), "depths has 5 numbers; give a row of at least 6"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(make, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence) as caught:
        make()
    assert "\n" not in str(caught.value)
    assert str(caught.value).endswith(".")
