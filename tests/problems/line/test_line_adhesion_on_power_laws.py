"""Lines that stick on power laws: energy of dense elements, closed forms, the half-plane, what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk

RADIUS, WORK = 5e-3, 0.05
LAW = wk.ShortRange(WORK)


def bed(k, profile=None):
    solid = wk.PowerLawGraded(young=1e6, depth_scale=1.0, exponent=k, poisson=0.3)
    return wk.PowerLawLineFoundation(profile or wk.Paraboloid(RADIUS), wk.GradedHalfSpace(solid))


def pressed(medium, a, depth, count=400):
    """Return energy and load per length of a parabola at a half-width and a depth, by even elements on |x|^-k."""
    k = medium.exponent
    level = math.cos(0.5 * math.pi * k) / (math.pi * medium.modulus)
    level *= math.sqrt(math.pi) * math.gamma(0.5 * k) / math.gamma(0.5 * (1.0 + k))
    edges = -a * np.cos(np.pi * np.arange(count + 1) / count)
    x = 0.5 * (edges[1:] + edges[:-1])
    far = x[:, None] - edges
    summed = np.sign(far) * np.abs(far) ** (1.0 - k) / (1.0 - k)
    sunk = depth - x * x / (2.0 * RADIUS)
    load = np.linalg.solve(-level * np.diff(summed, axis=1), sunk) * np.diff(edges)
    return 0.5 * float(load @ sunk), float(np.sum(load))


@pytest.mark.parametrize("k", [0.2, 0.5, 0.7])
def test_the_edges_release_the_work_of_adhesion(k):
    """What elements store at one depth falls by the work of adhesion per area that comes apart."""
    contact = bed(k)
    stuck = wk.LineAdhesion(contact, LAW, wk.LineForce(0.3)).solve()
    a = float(stuck.half_width)
    depth = float(contact.depth(np.array(a), np.array(stuck.edge_load / contact.medium.modulus)))
    (more, _), (less, _), (_, load) = (pressed(contact.medium, a * share, depth) for share in (1.001, 0.999, 1.0))
    assert (more - less) / (2.0 * 0.002 * a) == pytest.approx(WORK, rel=1e-4)
    assert load == pytest.approx(0.3, rel=1e-4)
    assert stuck.energy_release_rate == pytest.approx(WORK, rel=1e-12)


@pytest.mark.parametrize("k", [-0.3, 0.2, 0.6])
def test_a_cylinder_comes_off_as_its_closed_form_says(k):
    """P = A a^(2+k) - B a^((1+k)/2) is least where (2+k) A a^(2+k) = (1+k)/2 B a^((1+k)/2)."""
    contact, modulus = bed(k), bed(k).medium.modulus
    grows = modulus * float(contact.load_profile(np.ones(1))[0])
    gammas = math.gamma(1.0 + 0.5 * k) / math.gamma(0.5 + 0.5 * k)
    pulls = math.sqrt(2.0 * WORK * modulus) / gammas  # 4 gamma K a / k, of the flat punch's stiffness K
    a = (0.5 * (1.0 + k) * pulls / ((2.0 + k) * grows)) ** (2.0 / (3.0 + k))
    stuck = wk.LineAdhesion(contact, LAW, wk.LineForce(0.0)).solve()
    assert stuck.pull_off_half_width == pytest.approx(a, rel=1e-9)
    force = grows * a ** (2.0 + k) - pulls * a ** (0.5 * (1.0 + k))
    assert stuck.pull_off_force_per_length == pytest.approx(force, rel=1e-12)
    with pytest.raises(wk.OutsideValidity, match="pull-off"):
        wk.LineAdhesion(contact, LAW, wk.LineForce(1.01 * force)).solve()


def test_a_half_plane_is_the_limit():
    plain = wk.LineFoundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(1e6, 0.3)))
    one, other = (wk.LineAdhesion(each, LAW, wk.LineForce(1.0)).solve() for each in (bed(0.0), plain))
    assert one.half_width == pytest.approx(other.half_width, rel=1e-12)
    assert one.pull_off_force_per_length == pytest.approx(other.pull_off_force_per_length, rel=1e-12)
    x = np.array([1.1, 2.0, 5.0]) * one.half_width
    np.testing.assert_allclose(one.separation(x), other.separation(x), rtol=1e-9)
    near = wk.LineAdhesion(bed(1e-6), LAW, wk.LineForce(1.0)).solve()
    assert near.half_width == pytest.approx(other.half_width, rel=1e-4)


@pytest.mark.parametrize("k", [-0.3, 0.5])
def test_beside_a_pulled_strip_the_surfaces_part_as_they_do_under_its_pressure(k):
    """The slope of the surface by the pressure of `pressure` itself, with s = a sin(t): its edges pull without end."""
    stuck = wk.LineAdhesion(bed(k), LAW, wk.LineForce(0.3)).solve()
    a, medium = float(stuck.half_width), bed(k).medium
    level = math.cos(0.5 * math.pi * k) / (math.pi * medium.modulus)
    level *= math.sqrt(math.pi) * 2.0 * math.gamma(1.0 + 0.5 * k) / math.gamma(0.5 * (1.0 + k))
    node, weight = np.polynomial.legendre.leggauss(4000)
    angle = 0.5 * np.pi * (1.0 - (0.5 * (1.0 - node)) ** 3)  # gathered at the edge
    share = 0.5 * np.pi * 1.5 * (0.5 * (1.0 - node)) ** 2 * weight
    s, step = np.minimum(a * np.sin(angle), a * (1.0 - 1e-15)), a * np.cos(angle) * share
    pressure = stuck.pressure(s) * step

    def risen(x):
        """By how much less than at 1.05 a the surface is lowered at x."""
        one, other = ((at - s) ** -k + (at + s) ** -k for at in (1.05 * a, x))
        return level / k * float(pressure @ (one - other))

    for x in (1.5 * a, 3.0 * a):
        apart = stuck.separation(np.array([1.05 * a, x]))
        body = (x * x - (1.05 * a) ** 2) / (2.0 * RADIUS)
        assert apart[1] - apart[0] == pytest.approx(body - risen(x), rel=1e-5)


def test_what_power_laws_do_not_tell():
    stuck = wk.LineAdhesion(bed(0.5), LAW, wk.LineForce(0.3)).solve()
    with pytest.raises(wk.OutsideValidity, match="energy_release_rate"):
        _ = stuck.stress_intensity
    with pytest.raises(wk.OutsideValidity, match="ShortRange"):
        wk.LineAdhesion(bed(0.5), wk.Dugdale(WORK, 1e5), wk.LineForce(0.3)).solve()
    assert not any("half-planes" in note.statement for note in stuck.validity)
    assert any("power of the depth" in note.statement for note in stuck.validity)
