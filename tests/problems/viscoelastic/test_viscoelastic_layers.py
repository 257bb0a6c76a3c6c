"""Coatings that has its own relaxation function: against elastic stacks, Ting, and an own march on rings."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import ellipe, ellipk, j0, j1

import winkler as wk
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.materials.layered import Layer
from winkler.materials.relaxing_layer import ViscoelasticLayer
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.material_tests import CreepTest, RelaxationTest
from winkler.problems.viscoelastic.oscillation import HarmonicIndentation
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

BALL = wk.Paraboloid(1.0)
FILM = StandardSolid(relaxed_shear=1.0, shear=4.0, relaxation_time=1.0, poisson=0.4)
BASE = wk.Elastic(young=6.0, poisson=0.25)
COATED = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(FILM, 0.05)], on=BASE)
IN_AND_OUT = Path([0.0, *np.linspace(0.05, 1.0, 20), *np.linspace(1.05, 1.8, 16)],
                  Depth([0.0, *np.linspace(5e-4, 1e-2, 20), *np.linspace(9.5e-3, 2e-3, 16)]))  # fmt: skip


def bed(medium, shape=BALL):
    return wk.Foundation(shape, medium)


@pytest.mark.slow
def test_before_and_after_all_relaxation_the_stack_is_elastic():
    """The elastic stacks are solved by Fredholm equations, the relaxing one by cells."""
    for load, held in ((Depth(1e-2), Depth([1e-2, 1e-2])), (Force(0.02), Force([0.02, 0.02]))):
        found = ViscoelasticIndentation(bed(COATED), Path([0.0, 1e7], held), count=200).solve()
        for at, stack in ((0, COATED.glassy), (1, COATED.relaxed)):
            elastic = wk.Indentation(bed(stack), load).solve()
            for name in ("depth", "force", "radius"):
                assert getattr(found, name)[at] == pytest.approx(getattr(elastic, name), rel=1e-4), (load, name)


def test_layers_of_the_solid_of_the_base_are_the_half_space_of_ting():
    """Also while the contact shrinks, and with an elastic second body."""
    steel = wk.Elastic(40.0, 0.3)
    alike = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(FILM, 0.03), ViscoelasticLayer(FILM, 0.1)], FILM, steel)
    found = ViscoelasticIndentation(bed(alike), IN_AND_OUT, count=160).solve()
    known = ViscoelasticIndentation(bed(ViscoelasticHalfSpace(FILM, steel)), IN_AND_OUT, count=2000).solve()
    assert np.max(np.abs(found.force - known.force)) < 1e-4 * np.max(known.force)
    assert np.max(np.abs(found.radius - known.radius)) < 3e-4 * np.max(known.radius)
    for name in ("work", "dissipation", "stored_energy"):
        assert np.max(np.abs(getattr(found, name) - getattr(known, name))) < 1e-4 * np.max(known.work)
    moment, known_moment = (list(each.problem.steps())[30] for each in (found, known))
    r = np.linspace(0.0, 0.95, 12) * known_moment.radius
    assert moment.pressure(r) == pytest.approx(known_moment.pressure(r), rel=5e-3)
    with pytest.raises(OutsideValidity, match="the pressure is restored alone"):
        _ = moment.pressed


@pytest.mark.slow
def test_a_film_on_a_rigid_base_relaxes_in_proportion():
    film = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(FILM, 0.05)], on=wk.Rigid())
    elastic = wk.CoatedHalfSpace([Layer(wk.Elastic(2.0 * 1.4, 0.4), 0.05)], on=wk.Rigid())
    alike = RelaxingInProportion(elastic, FILM, shear=1.0)
    times = np.array([0.03, 1.0, 20.0])
    for test, load in ((CreepTest, 0.02), (RelaxationTest, 1e-2)):
        found, known = (test(bed(medium), load, times).solve() for medium in (film, alike))
        for name, close in (("depth", 1e-4), ("force", 1e-4), ("radius", 2e-3)):  # a cell is 5e-3 of the radius
            assert getattr(found, name) == pytest.approx(getattr(known, name), rel=close)
    shaken, known = (HarmonicIndentation(bed(m), Depth(1e-2), [0.1, 1.0, 10.0]).solve() for m in (film, alike))
    assert shaken.storage_stiffness == pytest.approx(known.storage_stiffness, rel=3e-6)
    assert shaken.loss_stiffness == pytest.approx(known.loss_stiffness, rel=3e-6)


def test_a_thin_compressible_film_is_a_winkler_foundation():
    """F = pi R M(t) d^2 / h with the uniaxial modulus M, but for an edge that counts like (h / a)^2, here 6e-4."""
    solid, h, d = StandardSolid(1.0, 4.0, 1.0, poisson=0.2), 1e-3, 1e-4
    film = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(solid, h)], on=wk.Elastic(1e6, 0.2))
    times = np.array([1e-3, 0.5, 3.0, 50.0])
    found = RelaxationTest(bed(film), d, times).solve()
    uniaxial = 2.0 * (1.0 - 0.2) / (1.0 - 0.4) * (1.0 + 4.0 * np.exp(-times))
    assert found.force == pytest.approx(np.pi * uniaxial * d**2 / h, rel=1e-3)
    assert found.radius == pytest.approx(np.sqrt(2.0 * d), rel=0.02)
    assert found.force / found.force[0] == pytest.approx(uniaxial / uniaxial[0], rel=1e-3)


def waves(shear, k, h):
    """Return k times the compliance of a layer on a half-space, after Burmister, at complex shear moduli of the layer.

    S. J. O'Sullivan, R. B. King, J. Tribol. 110 (1988) 235-240, doi:10.1115/1.3261591.
    """
    nu, own = FILM.poisson, BASE.poisson
    ratio = shear / BASE.shear
    first = 1.0 - 4.0 * (1.0 - nu) / (1.0 + ratio * (3.0 - 4.0 * own))
    second = (ratio - 1.0) / (ratio + 3.0 - 4.0 * nu)
    fade, x = np.exp(-2.0 * k * h), k * h
    above = 1.0 + 4.0 * x * second * fade - first * second * fade**2
    below = 1.0 - (first + second + 4.0 * second * x**2) * fade + first * second * fade**2
    return (1.0 - nu) / shear * above / below


def crept(function, t, count=18):
    """Return what has the Laplace transform function(s) / s at a time t > 0, by Talbot's contour."""
    angle = (np.arange(count) + 0.5) * np.pi / count
    turn = 1.0 / np.tan(0.6407 * angle)
    s = 2.0 * count / t * (0.5017 * angle * turn - 0.6122 + 0.2645j * angle)
    slope = 2.0 * count / t * (0.5017 * turn - 0.5017 * 0.6407 * angle / np.sin(0.6407 * angle) ** 2 + 0.2645j)
    return sum(np.imag(np.exp(z * t) * function(z) / z * dz) for z, dz in zip(s, slope, strict=True)) / count


def rings_on_a_coating(times, depths, radius, count):
    """Return forces and contact radii: rings of constant pressure, all of the past summed up at every step."""
    edges = radius * np.linspace(0.0, 1.0, count + 1)
    r = 0.5 * (edges[1:] + edges[:-1])

    def disc(a):
        """Return what a unit pressure on a disc of radius a moves, over (1 - nu) / G."""
        if a == 0.0:
            return np.zeros(r.size)
        inside = ellipe(np.minimum(r / a, 1.0) ** 2) * a
        q = np.minimum(a / r, 1.0) ** 2
        return 2.0 / np.pi * np.where(r < a, inside, r * (ellipe(q) - (1.0 - q) * ellipk(np.minimum(q, 1.0 - 1e-15))))

    own = np.array([disc(b) - disc(a) for a, b in zip(edges[:-1], edges[1:], strict=True)]).T
    h = COATED.layers[0].thickness
    node, weight = np.polynomial.legendre.leggauss(12)
    panels = np.concatenate([[0.0], np.geomspace(0.01, 2.0, 10) / h, np.arange(3.0, 19.0) / h])
    k = (0.5 * np.diff(panels)[:, None] * (node + 1.0) + panels[:-1, None]).ravel()
    w = (0.5 * np.diff(panels)[:, None] * weight).ravel()
    moments = edges * j1(np.outer(k, edges)) / k[:, None]
    left, right = j0(np.outer(r, k)), np.diff(moments, axis=1)

    def shear(s):
        return 1.0 + 4.0 * s / (1.0 + s)

    def kernel(t):
        creep = (lambda f: f(np.inf)) if t == 0.0 else (lambda f: crept(f, t))
        modulus = (lambda s: 5.0 + 0.0 * k) if t == 0.0 else (lambda s: shear(s) + 0.0 * k)
        homogeneous = creep(lambda s: (1.0 - FILM.poisson) / modulus(s)[0])
        layered = creep(lambda s: waves(modulus(s), k, h) - (1.0 - FILM.poisson) / modulus(s))
        return homogeneous * own + (left * (w * layered)) @ right

    steps = times[1] - times[0]
    kernels = [kernel(lag) for lag in steps * np.arange(times.size)]
    means = [0.5 * (one + other) for one, other in zip(kernels[:-1], kernels[1:], strict=True)]
    changes, pressure, forces, radii = [], np.zeros(count), [], []
    for n, depth in enumerate(depths[1:], 1):
        past = sum((means[n - j - 1] @ change for j, change in enumerate(changes)), np.zeros(count))
        wanted = depth - 0.5 * r**2 - past + means[0] @ pressure
        active = max(1, int(np.count_nonzero(wanted > 0.0)))
        while True:  # rings let go from the edge inwards
            found = np.linalg.solve(means[0][:active, :active], wanted[:active])
            if found[-1] >= 0.0 or active == 1:
                break
            active -= 1
        after = np.zeros(count)
        after[:active] = found
        changes.append(after - pressure)
        pressure = after
        forces.append(np.pi * np.diff(edges**2) @ after)
        radii.append(edges[active])
    return np.array(forces), np.array(radii)


def test_against_rings_with_all_of_their_past():
    """Pressed in and taken back; another discretisation, kernels by Talbot from Burmister's formula."""
    times = np.linspace(0.0, 1.8, 37)
    depths = np.interp(times, [0.0, 1.0, 1.8], [0.0, 1e-2, 2e-3])
    force, radius = rings_on_a_coating(times, depths, 0.14, 80)
    found = ViscoelasticIndentation(bed(COATED), Path(times, Depth(depths)), count=160).solve()
    assert np.max(np.abs(found.force[1:] - force)) < 3e-4 * np.max(force)
    assert np.max(np.abs(found.radius[1:] - radius)) < 1.5 * 0.14 / 80


def test_energy_is_lost_in_every_cycle_and_the_account_closes():
    t = np.linspace(0.0, 6.0, 61)
    depths = 5e-3 * (1.0 - np.cos(2.0 * np.pi * t / 3.0))
    found = ViscoelasticIndentation(bed(COATED), Path(t, Depth(depths)), count=100).solve()
    assert np.all(np.diff(found.dissipation) >= -1e-9 * found.work.max())
    assert found.work[30] > 0.1 * found.work.max()
    missing = np.abs(found.work - found.stored_energy - found.dissipation)
    assert np.max(missing) < 2e-4 * found.work.max()
    assert any("Half as many cells" in note.statement for note in found.validity)
    assert all(note.standing.name != "OUTSIDE" for note in found.validity)


def test_what_is_refused():
    layer = ViscoelasticLayer(FILM, 0.1)
    with pytest.raises(InvalidInput, match="none of layers, on and second is viscoelastic"):
        ViscoelasticCoatedHalfSpace([Layer(BASE, 0.1)], on=BASE)
    for solid, why in ((Maxwell(1.0, 1.0), "creeps without limit"), (KelvinVoigt(1.0, 1.0), "infinite modulus")):
        with pytest.raises(InvalidInput, match=why):
            ViscoelasticCoatedHalfSpace([ViscoelasticLayer(solid, 0.1)], on=BASE)
    coated = bed(ViscoelasticCoatedHalfSpace([layer], on=BASE))
    with pytest.raises((InvalidInput, OutsideValidity), match="half-spaces only"):
        wk.SlidingResistance(coated, wk.Depth(1e-3), speed=1.0)
    with pytest.raises(InvalidInput, match="body of revolution"):
        CreepTest(wk.PlaneFoundation(BALL, COATED), 1.0, [1.0])
    rubber = StandardSolid(1.0, 4.0, 1.0, poisson=0.5)
    skin = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(rubber, 1e-7)], on=wk.Rigid())
    with pytest.raises(NotConverged, match="lost in rounding: the contact is too wide against them"):
        RelaxationTest(bed(skin), 1e-2, [1.0]).solve()
    with pytest.raises(InvalidInput, match="at most 2000 cells"):
        ViscoelasticIndentation(bed(COATED), IN_AND_OUT, count=2001)
    with pytest.raises(OutsideValidity, match="change in time"):
        wk.Indentation(bed(COATED), Depth(1e-2)).solve()


def test_a_thin_incompressible_film_carries_like_a_squeezed_fluid():
    """a^2 = 4 R d and F = 2 pi mu a^6 / (32 R h^3) for a bonded film of h << a, from u = - h^3 / (3 mu) laplacian p."""
    h, d = 2e-3, 1e-2
    rubber = StandardSolid(1.0, 4.0, 1.0, poisson=0.5)
    film = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(rubber, h)], on=wk.Rigid())
    times = np.array([1e-3, 30.0])
    found = RelaxationTest(bed(film), d, times).solve()
    shear = 1.0 + 4.0 * np.exp(-times)
    assert found.force == pytest.approx(np.pi * shear * (4.0 * d) ** 3 / (32.0 * h**3), rel=0.1)
    assert found.radius == pytest.approx(np.sqrt(4.0 * d), rel=0.02)
    assert found.force / found.force[0] == pytest.approx(shear / shear[0], rel=1e-3)


def test_a_hard_film_whose_bending_relaxes_loses_touch_inside():
    """The states before it are yielded."""
    hard = ViscoelasticCoatedHalfSpace([ViscoelasticLayer(StandardSolid(1e3, 4e3, 1.0, poisson=0.3), 0.01)], on=BASE)
    t = np.linspace(0.0, 1.5, 16)
    path = Path(t, Depth(5e-3 * (1.0 - np.cos(2.0 * np.pi * t / 3.0))))
    seen = []
    with pytest.raises(OutsideValidity, match="is pulled inside the contact"):
        seen.extend(ViscoelasticIndentation(bed(hard), path, count=60).steps())
    assert len(seen) > 4
