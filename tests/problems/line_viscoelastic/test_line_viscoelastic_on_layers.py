"""Line contacts of layers that relax in proportion, against the waves of a film by matrix exponentials.

Growing strips: collocation after Erdogan and Gupta, and creep by an inverse of Laplace's transform.  Shrinking strips:
boundary elements that step through time.
"""

from __future__ import annotations

import functools

import mpmath as mp
import numpy as np
import pytest
from relaxing_half_plane import RelaxingHalfPlane
from scipy.linalg import expm, null_space

import winkler as wk

RUBBER = wk.StandardSolid(relaxed_shear=0.2, shear=0.8, relaxation_time=0.5)
FILM, NU_FILM, NU_BASE = 2.0, 0.4, 0.3
OWN = FILM / (1.0 - NU_FILM**2)
"""E* of a film of the thickness 1, at first."""


def bed_of(contrast, profile=None, thickness=1.0):
    """A film on a base whose modulus is so many times greater, both five times softer after all time."""
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(FILM, NU_FILM), thickness)], on=wk.Elastic(contrast * FILM, NU_BASE))
    medium = wk.RelaxingInProportion(film, RUBBER, shear=1.0)
    return wk.LayeredLineFoundation(profile or wk.Paraboloid(1.0), medium)


def solved(bed, path, **options):
    return wk.LineViscoelasticIndentation(bed, path, **options).solve()


@functools.cache
def excess(contrast, thickness, last=25.0, step=0.05):
    """Wave numbers, weights, and the compliance of the film over that of its half-plane, less one."""
    node, weight = np.polynomial.legendre.leggauss(6)
    edges = np.append(0.0, np.geomspace(1e-4, last, int(14.0 / step))) / thickness
    k = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (node + 1.0)).ravel()
    weights = (0.5 * np.diff(edges)[:, None] * weight).ravel()

    def rates(young, poisson):
        """d/dx of (U, W, tau, sigma), x = k z, tractions over k."""
        shear = 0.5 * young / (1.0 + poisson)
        lame = 2.0 * shear * poisson / (1.0 - 2.0 * poisson)
        a = np.array([[0.0, 1.0, 1.0 / shear, 0.0], [-lame, 0.0, 0.0, 1.0], [0.0] * 4, [0.0, 0.0, -1.0, 0.0]])
        a[1] /= lame + 2.0 * shear
        a[2] = lame * a[1] + np.array([lame + 2.0 * shear, 0.0, 0.0, 0.0])
        return a

    deep = rates(contrast * FILM, NU_BASE) + np.eye(4)
    base, film = null_space(deep @ deep, rcond=1e-7), rates(FILM, NU_FILM)
    found = []
    for one in k.tolist():
        states = expm(-film * one * thickness) @ base
        found.append(-0.5 * (states[:2] @ np.linalg.inv(states[2:]))[1, 1] * OWN - 1.0)
    return k, weights, np.array(found)


def collocated(contrast, half_width, thickness, count=120):
    """Load over E* and R of a cylinder on the film, after Erdogan and Gupta: zeros of U_n and of T_(n+1)."""
    k, weights, more = excess(contrast, thickness)
    angle = np.pi * np.arange(1, count + 1) / (count + 1)
    s, shares = half_width * np.cos(angle), half_width * np.pi * np.sin(angle) ** 2 / (count + 1)
    x = half_width * np.cos(np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1))
    sines, cosines = np.sin(np.outer(x, k)), np.cos(np.outer(x, k))
    smooth = (sines * more * weights) @ np.cos(np.outer(k, s)) - (cosines * more * weights) @ np.sin(np.outer(k, s))
    kernel = (1.0 / (x[:, None] - s) + smooth) * shares
    return float(shares @ np.linalg.lstsq(kernel, 0.5 * np.pi * x, rcond=None)[0])


@pytest.mark.few(1)
@pytest.mark.parametrize("contrast", [0.1, 10.0])
@pytest.mark.parametrize("ratio", [0.3, 3.0, pytest.param(10.0, marks=pytest.mark.slow)])
def test_a_growing_strip_is_the_elastic_one_of_the_load_that_crept(contrast, ratio):
    """P = P_1 t: the load that crept has the transform P_1 / (s^2 phi(s))."""
    a, thickness = 0.03, 0.03 / ratio
    level = OWN * collocated(contrast, a, thickness)
    path = wk.LineForcePath([0.0, 0.4, 1.0], np.array([0.0, 0.4, 1.0]) * level)
    found = solved(bed_of(contrast, thickness=thickness), path, count=8)
    for time, width in zip(found.time[1:], found.half_width[1:], strict=True):
        with mp.workdps(20):
            crept = mp.invertlaplace(
                lambda s: level / (s**2 * (mp.mpf("0.2") + mp.mpf("0.8") * s / (s + 2))), time, method="talbot"
            )
        assert OWN * collocated(contrast, width, thickness) == pytest.approx(float(crept), rel=1e-7)


class RelaxingFilm(RelaxingHalfPlane):
    """The same elements on the film: the kernel of the half-plane and what waves add."""

    def __init__(self, contrast, thickness, end, count):
        # 1/E* of the standard solid: 1 / (0.2 + 0.8 exp(-t / 0.5)) in Laplace space
        creep = 1.0 / OWN, (1.0 / 0.2 - 1.0) / OWN, 0.5 / 0.2
        super().__init__(lambda x: 0.5 * x**2, end, count, creep)
        k, weights, more = excess(contrast, thickness)
        waves = np.cos(np.outer(self.x, k))
        both = 2.0 * waves * (weights * more / k) @ waves.T - 2.0 * np.cos(k * end) @ (weights * more / k)
        self.kernel = self.kernel + 2.0 / np.pi * self.width * both


HISTORY = [0.0, 1.0, 2.0, 2.5, 3.5], [0.0, 1.0, 1.0, 0.25, 1.3]


@pytest.mark.parametrize(
    ("contrast", "ratio"),
    [
        *(pytest.param(*case, marks=pytest.mark.slow) for case in ((0.1, 0.3), (10.0, 3.0))),
        *(pytest.param(*case, marks=pytest.mark.long) for case in ((0.1, 3.0), (10.0, 10.0))),
    ],
)
def test_a_history_agrees_with_boundary_elements_that_step_through_time(contrast, ratio):
    thickness = 0.04 / ratio
    level = 0.3 * OWN * collocated(contrast, 0.04, thickness)
    times, forces = HISTORY[0], level * np.array(HISTORY[1])
    contact = solved(bed_of(contrast, thickness=thickness), wk.LineForcePath(times, forces, count=10))
    body, errors = RelaxingFilm(contrast, thickness, 1.05 * contact.half_width.max(), 120), []
    finer = wk.LineForcePath(times, forces, count=80)
    for index in range(1, finer.moments.size):
        elements = body.step(finer.across[index], finer.moments[index] - finer.moments[index - 1])
        if index % 8 == 0:
            state = contact.at(index // 8)
            strips, inside = state.pressure(body.x), body.x < 0.95 * state.half_width
            if np.count_nonzero(inside) > 20:
                errors.append(np.max(np.abs(elements - strips)[inside]) / strips.max())
            assert abs(np.count_nonzero(elements) * body.width - state.half_width) < 1.2 * body.width
    assert len(errors) > 30
    assert max(errors) < 6e-3
    assert np.mean(errors) < 1.5e-3


IN_AND_OUT = wk.LineForcePath([0.0, 1.0, 1.5], [0.0, 1e-3, 0.3e-3])


@pytest.mark.slow
def test_equal_layers_are_the_half_plane_and_under_a_thin_film_the_base_decides():
    """With pressure, approach and work, also while the strip shrinks."""
    plain = wk.LineFoundation(wk.Paraboloid(1.0), wk.ViscoelasticHalfSpace(RUBBER))
    alike = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.0 * 1.5, 0.5), 0.02)], on=wk.Elastic(2.0 * 1.5, 0.5))
    layers = wk.LayeredLineFoundation(wk.Paraboloid(1.0), wk.RelaxingInProportion(alike, RUBBER, shear=1.0))
    one, other = (solved(bed, IN_AND_OUT, count=40) for bed in (plain, layers))
    for name in ("half_width", "crept_load", "peak_pressure"):
        assert getattr(other, name) == pytest.approx(getattr(one, name), rel=1e-9)
    assert other.approach(3.0) == pytest.approx(one.approach(3.0), rel=1e-4)
    assert other.work_per_length(3.0) == pytest.approx(one.work_per_length(3.0), rel=1e-4)
    thin, thinner = (solved(bed_of(10.0, thickness=h), IN_AND_OUT, count=40) for h in (2e-3, 1e-3))
    base = wk.RelaxingInProportion(wk.HalfSpace(wk.Elastic(10.0 * FILM, NU_BASE)), RUBBER, shear=1.0)
    with pytest.raises(wk.InvalidInput, match="LineFoundation"):
        wk.LineFoundation(wk.Paraboloid(1.0), base)
    modulus = 10.0 * FILM / (1.0 - NU_BASE**2)
    wide = np.sqrt(4.0 * thin.crept_load[1] * OWN / modulus / np.pi)
    errors = [each.half_width[1] / wide - 1.0 for each in (thin, thinner)]
    assert 0.0 < errors[1] < errors[0]


@pytest.mark.long
def test_the_pressure_bears_the_force_and_converges_with_the_square_of_the_count():
    bed = bed_of(0.1, thickness=0.01)
    states = [solved(bed, IN_AND_OUT, count=count).at(-1) for count in (25, 50, 200)]
    angle = np.pi * (np.arange(400) + 0.5) / 400
    for state in states:
        x = state.half_width * np.cos(angle)
        borne = np.pi / 400 * state.half_width * np.sum(state.pressure(x) * np.sin(angle))
        assert borne == pytest.approx(0.3e-3, rel=2e-4)
    middle = np.array([float(state.pressure(0.0)) for state in states])
    errors = np.abs(middle[:2] / middle[2] - 1.0)
    assert errors[1] < 0.4 * errors[0] < 2e-3


def test_notes_speak_of_layers_and_what_does_not_fit_is_refused():
    found = solved(bed_of(10.0, thickness=0.01), IN_AND_OUT, count=20)
    notes = [note.statement for note in found.validity]
    assert any(note.startswith("Layers, or bodies graded with depth, that relax in proportion,") for note in notes)
    assert not any("half-planes" in note for note in notes)
    assert any("no overlap outside of the widest elastic contact" in note for note in notes)
    with pytest.raises(wk.OutsideValidity, match="its stiffness changes in time"):
        wk.LineIndentation(bed_of(10.0), wk.LineForce(1e-3)).solve()
    soil = wk.RelaxingInProportion(
        wk.GradedHalfSpace.between(wk.PowerLawGraded(1e6, 1.0, 0.3, poisson=0.3)), RUBBER, shear=1.0
    )
    with pytest.raises(wk.OutsideValidity, match="line contacts do not support the layers"):
        wk.LayeredLineFoundation(wk.Paraboloid(1.0), soil)


def test_gradings_that_relax_are_refused_and_layers_named():
    """They were accepted, and three solves of three points gave no answer in a minute."""
    grading = wk.DepthGradedHalfSpace(wk.ExponentialGrading(1.0, 3.0, depth_scale=1e-3, poisson=0.3))
    bed = wk.LayeredLineFoundation(wk.Paraboloid(1.0), wk.RelaxingInProportion(grading, RUBBER, shear=1.0))
    with pytest.raises(wk.OutsideValidity, match="in the place of the grading give a CoatedHalfSpace of layers"):
        wk.LineViscoelasticIndentation(bed, IN_AND_OUT)
