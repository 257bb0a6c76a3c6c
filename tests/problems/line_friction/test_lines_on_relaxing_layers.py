"""Sheared lines on layers that relax each by a law of its own: limits, one law, hereditary sums of inverted waves."""

from __future__ import annotations

import numpy as np
import pytest
from test_relaxing_lines import LOAD, MU, even_kernel, own_march

import winkler as wk
from problems.layer_waves import base, crossed
from winkler.problems.line_friction.path import LinePath

NUMBERS = ("half_width", "stick_half_width", "slip_shift", "dissipation_per_length")
PART = np.array([0.0, 0.6, 0.2, -0.5])


def film(tau, base=1.0, thickness=0.01, poisson=0.3):
    """A film whose modulus of shear falls from .25 to .05, of which the base has a part."""
    solid = wk.StandardSolid(0.05, 0.2, tau, poisson=poisson)
    return wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid, thickness)], wk.Elastic(base, 0.3))


def sheared(medium, time=None, force=LOAD, part=PART, **more):
    bed = wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium)
    more = more if time is None else more | {"time": time}
    return wk.LineTangential(bed, wk.Coulomb(MU), LinePath(force, part * MU * LOAD, **more)).solve()


@pytest.mark.parametrize(("tau", "limit"), [(1e7, "glassy"), pytest.param(1e-4, "relaxed", marks=pytest.mark.slow)])
def test_fast_and_slow_they_are_the_elastic_layers(tau, limit):
    """The first load comes at once: a relaxed contact is narrower there, and only there."""
    ours, true = sheared(film(tau), np.arange(4.0)), sheared(getattr(film(tau), limit))
    for name in NUMBERS:
        mine, its = getattr(ours, name)[1:], getattr(true, name)[1:]
        assert mine == pytest.approx(its, abs=3e-3 * np.max(np.abs(its))), name


@pytest.mark.slow
def test_where_all_solids_are_one_they_are_half_planes_of_it():
    """The half-plane has one creep and one compliance: another memory, other pressures, other places."""
    solid = wk.StandardSolid(0.05, 0.2, 0.7, poisson=0.3)
    layers = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid, 0.01)], solid)
    time = np.array([0.0, 0.5, 1.1, 2.0])
    force = LOAD * np.array([1.0, 1.1, 0.9, 1.2])
    plane = wk.LineFoundation(wk.Paraboloid(1.0), wk.ViscoelasticHalfSpace(solid))
    peak = LOAD / float(sheared(layers, time, force).half_width[0])
    path = {"bulk_stress": 0.3 * MU * peak * np.array([0.0, 0.0, 1.0, -0.5])}
    ours = sheared(layers, time, force, **path)
    true = wk.LineTangential(plane, wk.Coulomb(MU), LinePath(force, PART * MU * LOAD, time=time, **path)).solve()
    for name in (*NUMBERS, "stick_middle"):
        mine, its = getattr(ours, name), getattr(true, name)
        assert mine == pytest.approx(its, abs=5e-3 * np.max(np.abs(true.half_width if "stick" in name else its))), name


def compliance(solid, thickness, on, xi, s):
    """C_L xi of a film at rates ``(S, m)``, by matrix exponentials, which do not know of rates."""
    across, found = crossed(solid.poisson, xi * thickness), []
    for rate in s:
        turned = rate * solid.relaxation_time
        shear = solid.relaxed_shear + solid.shear * turned / (1.0 + turned)
        scale = np.array([1.0, 1.0, shear, shear])[:, None]
        fields = scale * (across @ (np.broadcast_to(base(on), (xi.size, 4, 2)) / scale))
        found.append(-(fields[:, :2] @ np.linalg.inv(fields[:, 2:]))[:, 0, 0])
    return np.array(found)


def inverted(answer, ages, terms=14):
    """Talbot's sum for what is answered after ages, from answers over s ``(S, ...)``; of age zero at a great rate."""
    found = []
    for age in ages:
        if age == 0.0:
            found.append(np.real(answer(np.array([1e9 + 0j])))[0])
            continue
        angle = np.pi * (np.arange(1, terms) / terms)
        cot = 1.0 / np.tan(angle)
        s = 0.4 * terms / age * np.append(1.0 + 0j, angle * (cot + 1j))
        weights = np.append(0.5 + 0j, 1.0 + 1j * (angle + (angle * cot - 1.0) * cot)) * np.exp(s * age)
        values = answer(s)
        found.append(0.4 / age * np.tensordot(weights / s, values, 1).real)
    return np.array(found)


@pytest.mark.slow
@pytest.mark.parametrize(("young", "ratio"), [(6.5, 3.0), (0.065, 1.0), (6.5, 0.3)])
def test_hereditary_sums_over_inverted_waves_agree(young, ratio):
    """A cylinder that has crept to its end is pushed to and fro as fast as the film relaxes; bases 10 and 1/10."""
    width = 0.012
    tau, thickness = 0.2, width / ratio
    medium = film(tau, young, thickness)
    bed = wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium.relaxed)
    load = float(wk.LineIndentation(bed, wk.HalfWidth(width)).solve().force_per_length)
    late = np.arange(25) / 24.0
    shears = 0.7 * MU * load * np.sin(2.0 * np.pi * late)
    path = LinePath(load, np.append(0.0, shears), time=np.append(0.0, 60.0 + late))
    ours = wk.LineTangential(wk.LayeredLineFoundation(wk.Paraboloid(1.0), medium), wk.Coulomb(MU), path).solve()
    assert float(ours.half_width[-1]) == pytest.approx(width, rel=2.5e-3)  # a third of one of 250 cells
    edges = np.linspace(-width, width, 121)
    bound = MU * np.tile(bed.mean_pressures(edges[60:], width, 0.0), 2)
    bound[:60] = bound[:59:-1]
    node, weight = np.polynomial.legendre.leggauss(12)
    panels = np.append(0.0, np.geomspace(1e-3, 21.0, 60)) / thickness
    panels = np.unique(np.concatenate([panels, np.arange(0.0, panels[-1], 6.0 / width)]))
    half = 0.5 * np.diff(panels)[:, None]
    xi, weights = (panels[:-1, None] + half * (1.0 + node)).ravel(), (half * weight).ravel()
    solid, on = medium.layers[0].solid, (young / 2.6, 0.3)
    h = edges[1] - edges[0]
    x = np.abs(0.5 * (edges[1:] + edges[:-1])[:, None] - 0.5 * (edges[1:] + edges[:-1]))
    away = np.arange(120) * h
    places = np.rint(x / h).astype(int)
    waves = (np.cos(np.outer(away, xi)) - 1.0) * (weights / xi * 2.0 / xi * np.sin(0.5 * xi * h)) / np.pi

    def answered(s):
        turned = s * tau
        short = 0.7 / (0.05 + 0.2 * turned / (1.0 + turned))
        rows = (compliance(solid, thickness, on, xi, s) - short[:, None]) @ waves.T
        return rows[:, places] + 0.5 * short[:, None, None] * even_kernel(edges)

    step = late[1]
    table = inverted(answered, 0.5 * step * np.arange(49))
    creep = {round(2.0 * i * 0.5): row for i, row in enumerate(table)}

    _, tractions, slips, lost = own_march(edges, bound, late, shears, lambda t: creep[round(2.0 * t / step)])
    middles = 0.5 * (edges[1:] + edges[:-1])
    inside = np.abs(middles) < 0.95 * width
    for n in (6, 12, 24):
        mine = ours.states[1 + n].traction(middles[inside])
        assert mine == pytest.approx(tractions[n][inside], abs=0.03 * np.max(bound))
        ahead = ours.states[1 + n].slip(middles)
        assert ahead - ahead.mean() == pytest.approx(slips[n] - slips[n].mean(), abs=0.03 * np.ptp(slips[6]))
    assert ours.dissipation_per_length[-1] == pytest.approx(lost, rel=0.02)
    elastic = wk.LineTangential(bed, wk.Coulomb(MU), LinePath(load, shears)).solve()
    assert abs(lost / elastic.dissipation_per_length[-1] - 1.0) > 0.05  # that the film relaxes is felt


@pytest.mark.slow
def test_thin_films_leave_their_base_alone():
    """As h falls, what is lost tends to what the base's half-plane loses; thicker films are felt."""
    alone = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3)))
    path = LinePath(LOAD, PART[:2] * MU * LOAD)
    true = wk.LineTangential(alone, wk.Coulomb(MU), path).solve().dissipation_per_length[-1]
    apart = [
        abs(sheared(film(0.3, thickness=h), np.arange(2.0), part=PART[:2]).dissipation_per_length[-1] / true - 1.0)
        for h in (2e-4, 1e-4)
    ]
    assert 0.02 < apart[1] < 0.7 * apart[0]
