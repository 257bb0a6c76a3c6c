"""Every kind of problem declares what it assumes, states the result of its check, and flags what violates it."""

import dataclasses
import math

import mpmath
import numpy as np
import pytest
from example_answers import example_problem, solved

import winkler as wk
from winkler.problems.assumptions.coupling import dundurs, stuck_stiffening
from winkler.problems.assumptions.film import film_strain
from winkler.problems.assumptions.inertia import wave_loss
from winkler.study.language.catalogue import CATALOGUE
from winkler.values.validity import Assumption, Note, Standing, worst

KINDS = sorted(CATALOGUE["problem"])
STEEL = wk.Elastic(210e9, 0.3)
RUBBER = wk.Elastic(1e6, 0.5)
LIKE = wk.HalfSpace.between(STEEL, STEEL)
COULOMB = wk.Coulomb(0.3)


def result(kind):
    """The solution of the example of a kind, once for all tests of a worker."""
    return solved(example_problem(kind))


def find(notes, assumption) -> Note:
    found = [note for note in notes if note.assumption is assumption]
    assert found, f"no note on: {assumption.value}"
    return max(found, key=lambda note: list(Standing).index(note.standing))


def test_every_public_problem_declares_and_every_public_solution_states():
    public = {name: getattr(wk, name) for name in wk.__all__}
    problems = {name: cls for name, cls in public.items() if isinstance(cls, type) and hasattr(cls, "solve")}
    assert [name for name, cls in problems.items() if not getattr(cls, "assumptions", None)] == []
    assert [name for name, cls in public.items() if name.endswith("Solution") and not hasattr(cls, "validity")] == []


def test_every_assumption_is_declared_by_a_problem_or_belongs_to_fits():
    declared = frozenset().union(*(line.cls.assumptions for line in CATALOGUE["problem"].values()))
    assert declared | {Assumption.CURVE} == set(Assumption)


# ---- for every assumption that is checked, a case that violates it --------------------------------------------------


def pressed(profile, medium, depth):
    return wk.Indentation(wk.Foundation(profile, medium), wk.Depth(depth)).solve().validity


def beyond_the_reach():
    return pressed(wk.Measured(np.linspace(0.0, 1e-3, 6), 0.5 * np.linspace(0.0, 1e-3, 6) ** 2), LIKE, 1e-5)


def conforming():
    """A ball with one per cent clearance, as wide in contact as 0.6 of itself."""
    return pressed(wk.BallInSocket(10e-3, 10.1e-3), wk.HalfSpace.between(RUBBER), 4e-5)


def film_pressed_through():
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e3, 0.45), 1e-6)], on=wk.Rigid())
    return pressed(wk.Paraboloid(100e-6), film, 1.2e-6)


def steep():
    return pressed(wk.Cone(math.radians(30.0)), LIKE, 1e-6)


def yielding():
    weak = wk.Elastic(210e9, 0.3, strength=300e6)
    bed = wk.Foundation(wk.Paraboloid(0.01), wk.HalfSpace.between(weak, weak))
    return wk.Indentation(bed, wk.Force(1e4)).solve().validity


def longer_than_known():
    """A solid given between 1 ms and 1 s, that is to relax for a day."""
    solid = wk.PowerLawSolid(shear=1e3, time_scale=1.0, exponent=0.2, shortest=1e-3, longest=1.0)
    bed = wk.Foundation(wk.Paraboloid(1e-2), wk.ViscoelasticHalfSpace(solid))
    return wk.RelaxationTest(bed, depth=1e-6, time=np.array([0.1, 86400.0])).solve().validity


def touching_twice():
    return pressed(wk.Paraboloid(1.0) + wk.Wavy(1e-5, 1e-3), LIKE, 2e-6)


def dmt_on_rubber():
    """The number of the issue: a soft ball of 1 mm, for which DMT gives 56 and JKR 89 micrometres."""
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace.between(RUBBER))
    return wk.AdhesiveIndentation(bed, wk.DerjaguinMullerToporov(0.05), wk.Force(0.0)).solve().validity


def jkr_on_a_hard_tip():
    bed = wk.Foundation(wk.Paraboloid(20e-9), wk.HalfSpace.between(wk.Elastic(70e9, 0.2)))
    return wk.AdhesiveIndentation(bed, wk.ShortRange(0.1), wk.Force(0.0)).solve().validity


def hardly_any_friction():
    bed = wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace.between(STEEL))
    path = wk.Path([0.0, 1.0, 2.0], wk.Depth([0.0, 1e-6, 1e-6]), wk.Shift([0.0, 0.0, 1e-9]))
    return wk.Tangential(bed, wk.Coulomb(0.05), path).solve().validity


def uncalibrated():
    bed = wk.Foundation(wk.Paraboloid(1e-2), LIKE)
    rolled = wk.Rolling(bed, COULOMB, wk.Creepage(longitudinal=1e-4), wk.Force(10.0), calibration=wk.Uncalibrated())
    return rolled.solve().validity


def as_fast_as_sound():
    bed = wk.Foundation(wk.Sphere(1e-2), LIKE)
    mass = 7850.0 * 4.0 / 3.0 * math.pi * 1e-6
    return wk.Impact(bed, wk.Coulomb(0.0), mass=mass, velocity=1000.0).solve().validity


def a_single_pixel():
    heights = np.zeros((32, 32))
    heights[16, 16] = 1e-6
    return wk.SurfaceContact(wk.Topography(heights, (1e-3, 1e-3)), LIKE, wk.Force(1e-3)).solve().validity


def narrower_than_the_free_path():
    silver = wk.ElectricalConductor(1.6e-8)
    bed = wk.Foundation(wk.Sphere(10e-9), LIKE)
    pair = wk.ElectricalConductors(silver, silver)
    return wk.Constriction(wk.Indentation(bed, wk.Force(1e-9)), pair, mean_free_path=53e-9).solve().validity


def hotter_than_any_solid():
    steel = wk.ThermalConductor(45.0, 12e-6)
    bed, pair = wk.Foundation(wk.Sphere(1e-2), LIKE), wk.HeatConductors(steel, steel)
    return wk.FrictionHeating(wk.Indentation(bed, wk.Force(1e3)), COULOMB, pair, first_speed=300.0).solve().validity


def energy_from_nowhere():
    """The result of a march that summed up a loss by differences: more than was put in."""
    found = result("viscoelastic_indentation")
    return dataclasses.replace(found, dissipation=found.dissipation - 2e-3 * np.max(found.work)).validity


def area_of_a_line():
    return solved(dataclasses.replace(example_problem("rough_contact"), load=wk.Force(1e3))).validity


VIOLATED = {
    Assumption.SHAPE: beyond_the_reach,
    Assumption.HALF_SPACE: conforming,
    Assumption.FILM: film_pressed_through,
    Assumption.SMALL_SLOPES: steep,
    Assumption.ELASTIC: yielding,
    Assumption.KNOWN_TIMES: longer_than_known,
    Assumption.SINGLE_CONTACT: touching_twice,
    Assumption.ADHESION: dmt_on_rubber,
    Assumption.UNCOUPLED: hardly_any_friction,
    Assumption.CALIBRATION: uncalibrated,
    Assumption.INERTIA: as_fast_as_sound,
    Assumption.RESOLUTION: a_single_pixel,
    Assumption.ENERGY: energy_from_nowhere,
    Assumption.CONTINUUM: narrower_than_the_free_path,
    Assumption.TEMPERATURE: hotter_than_any_solid,
    Assumption.ROUGHNESS: area_of_a_line,
}


def test_no_checked_assumption_is_without_a_case():
    assert set(VIOLATED) == {assumption for assumption in Assumption if assumption.checked}


@pytest.mark.parametrize("assumption", VIOLATED, ids=lambda assumption: assumption.name)
def test_what_violates_it_is_flagged_or_refused(assumption):
    try:
        notes = VIOLATED[assumption]()
    except wk.OutsideValidity:
        assert assumption in {Assumption.SHAPE, Assumption.SINGLE_CONTACT}
        return
    assert find(notes, assumption).standing is Standing.OUTSIDE


# ---- the numbers of the checks, against what is not ours -----------------------------------------------------------


def test_a_contact_is_flagged_for_the_assumption_that_it_violates_alone():
    """A narrow, like, elastic contact violates nothing."""
    notes = pressed(wk.Paraboloid(1e-2), LIKE, 1e-8)
    assert worst(notes) is Standing.ASYMPTOTIC
    flat = pressed(wk.FlatPunch(1e-3), LIKE, 1e-8)
    assert find(flat, Assumption.SMALL_SLOPES).standing is Standing.EXACT


def test_jkr_on_a_hard_tip_of_20_nm():
    assert find(jkr_on_a_hard_tip(), Assumption.ADHESION).standing is Standing.OUTSIDE


@pytest.mark.parametrize("poisson", [0.0, 0.1, 0.3, 0.45, 0.499])
def test_sticking_makes_a_rigid_punch_stiffer_as_mossakovskii_found(poisson):
    """F = 2 G a d ln(3 - 4 nu) / (1 - 2 nu) against 2 a E* d without friction."""
    with mpmath.workdps(30):
        nu = mpmath.mpf(poisson)
        exact = (1 - nu) * mpmath.log(3 - 4 * nu) / (1 - 2 * nu) - 1
    assert stuck_stiffening(dundurs(wk.Elastic(1.0, poisson), wk.Rigid())) == pytest.approx(float(exact), rel=1e-9)


def test_sticking_changes_the_depth_of_a_rigid_ball_on_steel_by_two_per_cent():
    """Another program, in increments: 2 %."""
    beta = dundurs(STEEL, wk.Rigid())
    assert beta == pytest.approx(0.2857, abs=1e-4)
    assert 1.0 - (1.0 + stuck_stiffening(beta)) ** (-2.0 / 3.0) == pytest.approx(0.02, abs=2e-3)


@pytest.mark.parametrize(
    ("coefficient", "standing"),
    [
        (0.05, Standing.OUTSIDE),
        (0.5, Standing.APPROXIMATE),
        (5.0, Standing.ASYMPTOTIC),
        (50.0, Standing.ASYMPTOTIC),
    ],
)
def test_coupling_is_weighed_against_friction(coefficient, standing):
    """beta/mu = 5.7, 0.57, 0.057, 0.006 of a rigid ball on steel."""
    bed = wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace.between(STEEL))
    path = wk.Path([0.0, 1.0, 2.0], wk.Depth([0.0, 1e-6, 1e-6]), wk.Shift([0.0, 0.0, 1e-9]))
    notes = wk.Tangential(bed, wk.Coulomb(coefficient), path).solve().validity
    assert find(notes, Assumption.UNCOUPLED).standing is standing
    similar = wk.Tangential(wk.Foundation(wk.Paraboloid(1e-2), LIKE), wk.Coulomb(coefficient), path).solve().validity
    assert find(similar, Assumption.UNCOUPLED).standing is Standing.EXACT


FRICTIONAL = [kind for kind in KINDS if Assumption.UNCOUPLED in CATALOGUE["problem"][kind].cls.assumptions]


@pytest.mark.few(12, slow=8)
@pytest.mark.parametrize("kind", FRICTIONAL)
def test_every_frictional_problem_speaks_of_the_coupling(kind):
    """Also of pressing dissimilar bodies together with friction (Spence), which frictionless solutions leave out."""
    note = find(result(kind).validity, Assumption.UNCOUPLED)
    assert "Dundurs" in note.statement or note.statement == "There is no friction."


@pytest.mark.slow
def test_a_film_that_is_pressed_through_and_one_that_hardly_matters():
    """On a rigid base the tip would be inside it; a hard coating on steel goes down with it, and is not compressed."""
    assert find(film_pressed_through(), Assumption.FILM).standing is Standing.OUTSIDE
    cell = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e3, 0.45), 5e-6)], on=wk.Rigid())
    for depth, standing in ((0.4e-6, Standing.ASYMPTOTIC), (1e-6, Standing.APPROXIMATE), (3e-6, Standing.OUTSIDE)):
        assert find(pressed(wk.Paraboloid(5e-6), cell, depth), Assumption.FILM).standing is standing
    nitride = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(450e9, 0.25), 2e-6)], on=STEEL)
    notes = pressed(wk.Paraboloid(1e-2), nitride, 3e-6)  # deeper than it is thick
    assert find(notes, Assumption.FILM).standing is Standing.ASYMPTOTIC


def test_the_strain_of_a_film_on_a_half_space_of_its_own_kind():
    """Of one material the depth of Hertz' contact is all the half-space's: nothing is left for the film."""
    alike = wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-6)], on=STEEL)
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), LIKE), wk.Force(10.0)).solve()
    rigid = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace.between(STEEL)), wk.Force(10.0)).solve()
    assert film_strain(alike, float(rigid.depth), 10.0, float(rigid.radius)) == pytest.approx(0.0, abs=1e-9)
    assert film_strain(alike, float(ball.depth), 10.0, float(ball.radius)) > 0.0  # two such bodies are twice as soft


def test_hunters_loss_of_a_steel_ball():
    """S. C. Hunter 1957: 1.04 (v / c_0)^(3/5), c_0 = 5150 m/s of steel; E* in place of E gives a sixth more."""
    density, young = 7850.0, 208e9
    mass = density * 4.0 / 3.0 * math.pi * 1e-6
    hunter = 1.04 * (1.0 / math.sqrt(young / density)) ** 0.6
    ours = wave_loss(modulus=young, mass=mass, size=1e-2, velocity=1.0)
    assert ours == pytest.approx(hunter, rel=1e-12)
    assert hunter == pytest.approx(1.04 * 5150.0**-0.6, rel=1e-2)


def test_the_slope_counts_up_to_the_very_edge():
    """A paraboloid's slope at the edge is a / R."""
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), LIKE), wk.Radius(1.003e-3)).solve()
    note = find(contact.validity, Assumption.SMALL_SLOPES)
    assert "0.1:" in note.statement
    assert note.standing is Standing.APPROXIMATE


def test_nothing_is_promised_of_slopes_for_incompressible_bodies():
    soft = wk.HalfSpace.between(RUBBER)
    note = find(pressed(wk.Paraboloid(1e-2), soft, 2.5e-3), Assumption.SMALL_SLOPES)
    assert "of its square; for nu = 0.5 only the square remains" in note.statement


def test_a_ball_in_a_socket_knows_its_own_radius():
    """R_eff = 1.01 m would call the same contact 0.006 of the body."""
    wide = find(conforming(), Assumption.HALF_SPACE)
    assert wide.standing is Standing.OUTSIDE
    alike = find(pressed(wk.Sphere(1.01), wk.HalfSpace.between(RUBBER), 4e-5), Assumption.HALF_SPACE)
    assert alike.standing is Standing.ASYMPTOTIC
