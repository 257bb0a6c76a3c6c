"""Lines that stick on bodies graded with depth: independent numbers, layers, limits, energy, pull-off, ghosts."""

from __future__ import annotations

import numpy as np
import pytest
from graded_ghost import Ghost
from slip_of_gradings import SlippingOnGrading

import winkler as wk

NU = 0.3
YOUNG = 1.0 - NU**2
"""E* = 1 of the surface under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)
LAW = wk.ShortRange(0.05)


def young(contrast):
    return lambda z: YOUNG * (contrast + (1.0 - contrast) * np.exp(-z))


def graded(contrast, scale=1.0):
    grading = wk.ExponentialGrading(YOUNG, contrast * YOUNG, depth_scale=scale, poisson=NU)
    return wk.LayeredLineFoundation(CYLINDER, wk.DepthGradedHalfSpace(grading))


def layered(contrast, count):
    edges = 14.0 * np.linspace(0.0, 1.0, count + 1) ** 2
    middles = 0.5 * (edges[1:] + edges[:-1])
    layers = [
        wk.Layer(wk.Elastic(float(young(contrast)(z)), NU), float(h))
        for z, h in zip(middles, np.diff(edges), strict=True)
    ]
    return wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace(layers, wk.Elastic(contrast * YOUNG, NU)))


def stuck(bed, load):
    return wk.LineAdhesion(bed, LAW, load).solve()


def released(contrast, a, load, count=160):
    """Return the stress intensity at the edges of a strip under a load, by Cauchy's equation of the first kind.

    The kernel's jump times the pressure is integrated in closed form, mode by mode.
    """
    jump, rest = SlippingOnGrading(young(contrast), NU, 25.0, a, 0.5 * a, 20).normal
    angle, order = np.pi * (np.arange(count) + 0.5) / count, np.arange(1, count)
    s, turned = a * np.cos(angle), np.pi * order / count
    far = a * np.cos(turned)[:, None] - s
    waves = np.cos(np.outer(order, angle))
    signs = (np.pi - 2.0 * turned)[:, None] - 4.0 * (np.sin(np.outer(turned, order)) / order) @ waves
    rows = (1.0 / far + np.sign(far) * rest(np.abs(far))) * np.pi / count + jump * signs / count
    g = np.linalg.solve(
        np.vstack([rows, np.full((1, count), np.pi / count)]), np.append(0.5 * np.pi * a * np.cos(turned), load)
    )
    return -(np.mean(g) + 2.0 / count * np.sum(waves @ g)) * np.sqrt(np.pi / a)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("contrast", "a"), [(0.1, 0.3), (0.1, 3.0), (0.1, 10.0), (10.0, 0.3), (10.0, 3.0)])
def test_the_edge_releases_the_work_of_adhesion_by_another_derivation(contrast, a):
    """Not a wide strip on a stiff depth, whose edges 960 places of the equation do not resolve."""
    contact = stuck(graded(contrast), wk.HalfWidth(a))
    finest = 320 if contrast * a <= 3.0 else 960
    coarse, fine = (released(contrast, a, contact.force_per_length, count) for count in (finest // 2, finest))
    assert 0.5 * fine**2 == pytest.approx(LAW.work, rel=2e-4 + 2.0 * abs(fine / coarse - 1.0))
    assert abs(fine / coarse - 1.0) < 3e-3
    assert contact.energy_release_rate == pytest.approx(LAW.work, rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("contrast", "close"), [(0.1, 1e-5), (10.0, 1e-3)])
def test_edges_of_punches_are_those_of_many_layers(contrast, close):
    """Of twice as many layers the error is a fourth."""
    one = np.array([3.0])
    for name in ("edge_share", "edge_share_slope"):
        coarse, fine, ours = (
            getattr(bed, name)(one)[0] for bed in (layered(contrast, 20), layered(contrast, 40), graded(contrast))
        )
        assert ours == pytest.approx((4.0 * fine - coarse) / 3.0, rel=close if name == "edge_share" else 3.0 * close)


def test_a_body_that_does_not_change_sticks_as_a_half_plane():
    plain = stuck(wk.LineFoundation(CYLINDER, wk.HalfSpace(wk.Elastic(YOUNG, NU))), wk.HalfWidth(0.8))
    ours = stuck(graded(1.0), wk.HalfWidth(0.8))
    for name in ("force_per_length", "edge_load", "stress_intensity", "energy_release_rate"):
        assert getattr(ours, name) == pytest.approx(getattr(plain, name), rel=1e-8), name
    x = np.array([0.1, 0.5, 0.82, 1.5])
    np.testing.assert_allclose(ours.pressure(x), plain.pressure(x), atol=1e-8)
    np.testing.assert_allclose(ours.separation(x), plain.separation(x), atol=1e-8)


@pytest.mark.slow
def test_the_depth_is_felt_and_decides_under_a_thin_grading():
    """The load goes to that on the deep body as the grading gets thin, though the stress intensity is its surface's."""
    soft, other = (stuck(graded(contrast), wk.HalfWidth(3.0)).edge_load for contrast in (0.1, 0.5))
    assert abs(soft) < 0.6 * abs(other)
    deep = stuck(wk.LineFoundation(CYLINDER, wk.HalfSpace(wk.Elastic(10.0 * YOUNG, NU))), wk.HalfWidth(1.0))
    missed = [
        abs(stuck(graded(10.0, scale), wk.HalfWidth(1.0)).force_per_length / deep.force_per_length - 1.0)
        for scale in (0.08, 0.04, 0.02)
    ]
    assert missed[2] < 0.7 * missed[1] < 0.5 * missed[0]
    assert missed[2] < 0.1


@pytest.mark.slow
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_what_the_edge_releases_is_what_the_compliance_loses(contrast):
    """2 G = -(P - P0)^2 C'(a) / 2, with the approach of a place below the grading, from another integral.

    The modes of the punch that is pulled, of which about twenty are summed, leave 3e-3.
    """
    bed, a = graded(contrast), 0.7
    widths = a * (1.0 + 1e-2 * np.array([-2.0, -1.0, 1.0, 2.0]))

    def compliance(one):
        pulled, pressed = stuck(bed, wk.HalfWidth(one)), wk.LineIndentation(bed, wk.HalfWidth(one)).solve()
        apart = pulled.force_per_length - pressed.force_per_length
        return (pulled.approach(30.0) - pressed.approach(30.0)) / apart

    growth = np.array([compliance(float(one)) for one in widths]) @ np.array([1.0, -8.0, 8.0, -1.0]) / (0.12 * a)
    edge = stuck(bed, wk.HalfWidth(a)).edge_load
    assert -0.25 * edge**2 * growth == pytest.approx(LAW.work, rel=5e-3)


@pytest.mark.slow
def test_it_comes_apart_where_the_force_is_least():
    bed = graded(0.1)
    contact = stuck(bed, wk.LineForce(0.1))
    near = stuck(bed, wk.HalfWidth(contact.pull_off_half_width * np.array([0.97, 1.0, 1.03]))).force_per_length
    assert near[1] == pytest.approx(contact.pull_off_force_per_length, rel=1e-9)
    assert np.all(near[[0, 2]] > near[1])
    assert near[2] - near[1] == pytest.approx(near[0] - near[1], rel=0.15)
    assert stuck(bed, wk.HalfWidth(contact.half_width)).force_per_length == pytest.approx(0.1, rel=1e-9)


@pytest.mark.slow
def test_a_grading_of_no_family_sticks_with_the_same_numbers():
    known = graded(10.0)
    ghost = wk.LayeredLineFoundation(CYLINDER, Ghost(known.medium))
    loads = [stuck(bed, wk.HalfWidth(1.0)).force_per_length for bed in (known, ghost)]
    assert loads[0] == loads[1]


@pytest.mark.parametrize("given", [wk.HalfWidth(1.0), wk.HalfWidth(0.0), wk.LineForce(0.1)])
def test_an_attraction_beside_a_line_is_refused_on_gradings(given):
    with pytest.raises(wk.OutsideValidity, match="give ShortRange"):
        wk.LineAdhesion(graded(10.0), wk.Dugdale(0.05, strength=0.3), given).solve()
