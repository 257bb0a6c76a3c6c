"""Bodies that relax in proportion: elastic solutions with hereditary integrals, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.fields.restoration import restore
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.materials.depth_grading import ExponentialGrading
from winkler.materials.elastic import TransverselyIsotropic
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.material_tests import CreepTest, RelaxationTest
from winkler.problems.viscoelastic.oscillation import HarmonicIndentation
from winkler.values.errors import InvalidInput, OutsideValidity

SOLID = StandardSolid(2.0, 3.0, 0.3)
BALL = wk.Paraboloid(1.0)
GRADED = wk.GradedHalfSpace(PowerLawGraded(1.0, 1.0, 0.5, 0.3))
SOFTER = wk.GradedHalfSpace(PowerLawGraded(1.0, 1.0, -0.3, 0.2))
FILM = wk.CoatedHalfSpace([Layer(wk.Elastic(1.0, 0.4), 0.2)], on=wk.Rigid())
PLAIN = wk.HalfSpace(wk.Elastic(1.0, 0.3))
FIBRES = wk.TransverselyIsotropicHalfSpace(TransverselyIsotropic(3.0, 1.0, 0.8, 2.0, 0.7))
MEDIA = {"graded": GRADED, "softer": SOFTER, "film": FILM, "plain": PLAIN, "fibres": FIBRES}


def bed(medium, solid=SOLID, shear=2.0, shape=BALL):
    return wk.Foundation(shape, RelaxingInProportion(medium, solid, shear))


def pressed(given, time, load, **more):
    return ViscoelasticIndentation(given, Path(time, load), **more).solve()


@pytest.mark.parametrize("name", MEDIA)
def test_fast_and_slow_are_elastic(name):
    """Times the glassy modulus over the reference one, and times the relaxed one."""
    elastic = wk.Indentation(wk.Foundation(BALL, MEDIA[name]), Depth(0.01)).solve()
    for duration, factor in ((1e-7, 2.5), (1e7, 1.0)):
        found = pressed(bed(MEDIA[name]), [0.0, duration], Depth([0.0, 0.01]), count=60)
        assert found.radius[1] == pytest.approx(elastic.radius, rel=1e-6)
        assert found.force[1] == pytest.approx(factor * elastic.force, rel=1e-5)


@pytest.mark.parametrize("name", MEDIA)
def test_creep_under_a_constant_force(name):
    """d(t) is the elastic depth under F C(t)."""
    given, t = bed(MEDIA[name]), np.array([0.0, 1.0])
    # a film is costly for every spring
    count, close = (60, 1e-3) if name == "film" else (300, 3e-5)
    found = pressed(given, t, Force(1e-3), count=count, tolerance=1e-6)
    creep = 1.0 - 0.6 * np.exp(-t * 0.4 / 0.3)  # in units of the relaxed solid
    for i in range(2):
        elastic = wk.Indentation(wk.Foundation(BALL, MEDIA[name]), Force(float(1e-3 * creep[i]))).solve()
        assert found.depth[i] == pytest.approx(elastic.depth, rel=close)
        assert found.radius[i] == pytest.approx(elastic.radius, rel=close)


@pytest.mark.slow
def test_a_stiffening_body_creeps():
    medium = wk.DepthGradedHalfSpace(ExponentialGrading(1.0, 3.0, 0.1, 0.3), tolerance=1e-2)
    found = pressed(bed(medium), [0.0, 1e9], Force([1e-3, 1e-3]), count=20)
    elastic = wk.Indentation(wk.Foundation(BALL, medium), Force(1e-3)).solve()
    assert found.depth[1] == pytest.approx(elastic.depth, rel=5e-3)


def test_a_homogeneous_body_is_the_same_in_both_classes():
    """Against ViscoelasticHalfSpace, along a path with unloading, lost touch and a second one."""
    solid = Prony(0.5, [1.0, 0.5], [0.1, 1.0], poisson=0.3)
    one = wk.Foundation(BALL, ViscoelasticHalfSpace(solid))
    two = bed(wk.HalfSpace(wk.Elastic(2.0 * 0.7 * 1.3, 0.3)), solid, 0.7)
    path = [0.0, 0.5, 0.7, 1.0, 1.6], Depth([0.0, 0.02, 0.005, -0.01, 0.025])
    assert pressed(two, *path).force == pytest.approx(pressed(one, *path).force, rel=1e-11)
    (*_, first), (*_, second) = (list(ViscoelasticIndentation(each, Path(*path)).steps()) for each in (one, two))
    r, z = np.array([0.0, 0.05, 0.12, 0.3]), np.array([0.02, 0.1, 0.05, 0.2])
    for fields in (restore(first, r), restore(first, r, z)):
        other = restore(second, r) if hasattr(fields, "pressure") else restore(second, r, z)
        for word in vars(fields):
            if not word.startswith("_"):
                assert getattr(other, word) == pytest.approx(getattr(fields, word), rel=1e-8, abs=1e-15)


def test_closed_tests():
    """Creep, relaxation and oscillation of a Gibson-like soil and of a film: the elastic solution times a function."""
    for medium in (GRADED, FILM):
        given = bed(medium)
        elastic = wk.Indentation(wk.Foundation(BALL, medium), Depth(0.01)).solve()
        relaxed = RelaxationTest(given, 0.01, [0.3]).solve().force[0]
        assert relaxed == pytest.approx(elastic.force * (1.0 + 1.5 * np.exp(-1.0)), rel=1e-12)
        shaken = HarmonicIndentation(given, Depth(0.01), 2.0).solve()
        dynamic = 1.0 + 1.5 * 0.6j / (1.0 + 0.6j)
        assert shaken.storage_stiffness == pytest.approx(elastic.stiffness * dynamic.real, rel=1e-12)
        assert shaken.loss_stiffness == pytest.approx(elastic.stiffness * dynamic.imag, rel=1e-12)
        late = CreepTest(given, elastic.force, [1e9]).solve()
        assert late.depth[0] == pytest.approx(0.01, rel=1e-9)


@pytest.mark.parametrize("name", ["graded", pytest.param("film", marks=pytest.mark.slow)])
def test_fields_of_a_growing_contact(name):
    """Lee and Radok: the pressure is the hereditary integral of the elastic one."""
    medium, solid = MEDIA[name], Maxwell(1.0, 0.4)
    *_, state = ViscoelasticIndentation(bed(medium, solid, 1.0), Path([0.0, 1.0], Depth([0.0, 0.02]))).steps()
    places = np.array([0.0, 0.06])
    nodes, weights = np.polynomial.legendre.leggauss(24)
    # by parts: phi(0) p(1) - Int phi'(1 - s) p(s) ds, s = start + (1 - start) v^2 from where p begins
    found = []
    for r in places:
        touch = wk.Indentation(wk.Foundation(BALL, medium), wk.Radius(max(float(r), 1e-9))).solve().depth / 0.02
        v = 0.5 + 0.5 * nodes
        times = touch + (1.0 - touch) * v**2
        press = [
            float(restore(wk.Indentation(wk.Foundation(BALL, medium), Depth(float(0.02 * s))).solve(), r).pressure)
            for s in (*times, 1.0)
        ]
        fading = np.exp(-(1.0 - times) / 0.4) / 0.4
        found.append(press[-1] - 0.5 * weights @ (fading * np.array(press[:-1]) * 2.0 * (1.0 - touch) * v))
    assert restore(state, places).pressure == pytest.approx(found, rel=3e-5)


def test_the_surface_outside_and_inside_a_film():
    """Sudden and held: the pressure relaxes, the displacement does not."""
    given = bed(FILM)
    elastic = wk.Indentation(wk.Foundation(BALL, FILM), Depth(0.01)).solve()
    *_, state = ViscoelasticIndentation(given, Path([0.0, 0.3], Depth([0.01, 0.01])), count=60).steps()
    r, z = np.array([0.02, 0.15]), np.array([0.05, 0.1])
    now, then = restore(state, r), restore(elastic, r)
    factor = 1.0 + 1.5 * np.exp(-1.0)
    assert now.displacement == pytest.approx(then.displacement, rel=1e-10)
    assert now.gap == pytest.approx(then.gap, rel=1e-9, abs=1e-15)
    assert now.pressure == pytest.approx(factor * then.pressure, rel=1e-4)
    inside, still = restore(state, r, z), restore(elastic, r, z)
    assert inside.axial_stress == pytest.approx(factor * still.axial_stress, rel=1e-3)
    assert inside.axial_displacement == pytest.approx(still.axial_displacement, rel=1e-8)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: RelaxingInProportion(ViscoelasticHalfSpace(SOLID), SOLID, 1.0), "medium is a ViscoelasticHalfSpace"),
        (lambda: RelaxingInProportion(FILM, wk.Elastic(1.0, 0.3), 1.0), "solid is a Elastic"),
        (lambda: RelaxingInProportion(FILM, SOLID, 0.0), "shear is 0.0"),
        (lambda: RelaxingInProportion(FILM, SOLID, True), "shear is True"),
        (lambda: wk.CoatedHalfSpace([Layer(SOLID, 0.1)], on=wk.Rigid()), "ViscoelasticLayer"),
        (
            lambda: ViscoelasticIndentation(wk.Foundation(BALL, FILM), Path([0.0, 1.0], Depth([0.0, 1.0]))),
            "where layers",
        ),
    ],
)
def test_what_is_refused(make, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        make()


def test_springs_of_a_given_profile():
    """A plane profile on soil: the body that belongs to it does not change in time, and the gap closes."""
    given = wk.PlaneFoundation(wk.Paraboloid(1.0), RelaxingInProportion(GRADED, SOLID, 2.0))
    elastic = wk.Indentation(wk.PlaneFoundation(wk.Paraboloid(1.0), GRADED), Depth(0.01)).solve()
    *_, state = ViscoelasticIndentation(given, Path([0.0, 1e7], Depth([0.0, 0.01])), count=100).steps()
    places = np.array([0.05, 0.2])
    assert state.force == pytest.approx(elastic.force, rel=1e-4)
    assert restore(state, places).gap == pytest.approx(restore(elastic, places).gap, abs=1e-9)


def test_what_has_no_single_answer():
    given = bed(GRADED, KelvinVoigt(1.0, 0.1), 1.0)
    with pytest.raises(OutsideValidity, match="changes in time"):
        wk.Indentation(given, Depth(0.01)).solve()
    medium, x = given.medium, np.array([0.1])
    for request in (medium.normal_stiffness, medium.normal_stiffness_slope, medium.tangential_stiffness):
        with pytest.raises(OutsideValidity, match="no single value"):
            request(x)
    with pytest.raises(OutsideValidity, match="no single value"):
        medium.punch_pressure(x, 2.0 * x)
    with pytest.raises(OutsideValidity, match="no single value"):
        medium.gap_load(BALL, x)


def test_what_is_assumed_is_stated():
    found = pressed(bed(FILM), [0.0, 1.0], Depth([0.0, 0.01]), count=50)
    text = " ".join(note.statement for note in found.validity)
    assert "one common relaxation function" in text
    assert "bonded" in text
