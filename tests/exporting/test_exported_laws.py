"""What is exported agrees with winkler's own solvers, and says so where it is compiled."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from exported_laws import BALL, GEL, GLASS, PROBLEMS, RUBBER, STEEL, built, python, ran

from winkler.exporting.choose import law_of
from winkler.exporting.export import TARGETS, export, write_export
from winkler.foundation.foundation import Foundation
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.loads import Depth, Force, Shift
from winkler.loading.path import Path
from winkler.materials.elastic import Elastic
from winkler.materials.layered import Layer
from winkler.materials.spring_and_dashpot import StandardSolid
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.friction.tangential import Tangential
from winkler.problems.method import Method
from winkler.problems.normal.indentation import Indentation
from winkler.problems.particles.contacts import Contacts
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.profiles.flat import FlatPunch
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.values.errors import InvalidInput


def law(problem, count=32, tolerance=1e-6):
    return law_of(problem, tolerance=tolerance, count=count)


@pytest.mark.few(1)
@pytest.mark.parametrize("name", PROBLEMS)
def test_a_compiled_law_agrees_with_the_trace_it_holds(tmp_path, name):
    write_export(export(PROBLEMS[name], "c", name=name, count=8), tmp_path)
    code, text = ran(built(tmp_path, name))
    assert code == 0
    assert re.match(rf"{name}: \d+ steps agree with winkler to [\de.+-]+\n", text)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", ["sheared", "powder"])
def test_in_single_precision_a_law_states_how_far_it_is_off(tmp_path, name):
    exported = export(PROBLEMS[name], "c", name=name, count=8, precision="float")
    stated = float(re.search(r"off by up to ([\d.e+-]+) of its", exported.text)[1])
    code = re.sub(r"/\*.*?\*/", "", exported.text, flags=re.DOTALL)
    assert "double" not in code
    write_export(exported, tmp_path)
    code, text = ran(built(tmp_path, name))
    assert code == 0, text
    assert 1e-8 < float(text.split()[-1]) < 3.0 * stated < 1e-4


@pytest.mark.slow
def test_a_law_of_a_coated_body_has_no_shear_stiffness_and_is_standard_c(tmp_path):
    """Its table of one ratio is empty, and arrays without elements are an extension of some compilers."""
    coated = CoatedHalfSpace([Layer(Elastic(600e9, 0.2), 1e-5)], on=Elastic(210e9, 0.3))
    write_export(export(Indentation(Foundation(Paraboloid(5e-3), coated), Force(1.0)), "c", tolerance=1e-3), tmp_path)
    code, text = ran(built(tmp_path, "contact", ("-O0", "-pedantic-errors")))
    assert code == 0, text


def test_a_wrong_law_fails_its_own_test(tmp_path):
    (path,) = write_export(export(PROBLEMS["ball"], "c", name="ball"), tmp_path)
    text = path.read_text()
    wrong = text.replace("math", "math").replace("ball_shear[1] = {\n    0.8", "ball_shear[1] = {\n    0.7")
    assert wrong != text
    path.write_text(wrong)
    code, text = ran(built(tmp_path, "ball"))
    assert code == 1
    assert "shear_stiffness" in text


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", ["sheared", "beads", "powder"])
def test_the_same_file_is_cpp(tmp_path, name):
    write_export(export(PROBLEMS[name], "c", name=name, count=8), tmp_path)
    assert ran(built(tmp_path, name, language="c++"))[0] == 0


@pytest.mark.few(1, slow=4)
@pytest.mark.parametrize("name", PROBLEMS)
def test_the_python_file_agrees_away_from_winkler(tmp_path, name):
    write_export(export(PROBLEMS[name], "python", name=name, count=8), tmp_path)
    code, text = python(tmp_path / f"{name}.py")
    assert code == 0, text


def test_a_ball_is_hertz_to_the_last_digits():
    depth = np.array([1e-9, 3e-8, 2e-7, 3.3e-7])
    force, stiffness, energy, shear = law(PROBLEMS["ball"]).trace(depth[:, np.newaxis]).T
    hertz = 4.0 / 3.0 * STEEL.modulus * np.sqrt(1e-3) * depth**1.5
    np.testing.assert_allclose(force, hertz, rtol=1e-13)
    np.testing.assert_allclose(stiffness, 1.5 * hertz / depth, rtol=1e-13)
    np.testing.assert_allclose(energy, 0.4 * hertz * depth, rtol=1e-13)
    np.testing.assert_allclose(shear / stiffness, STEEL.shear_modulus / STEEL.modulus, rtol=1e-13)


@pytest.mark.few(1)
@pytest.mark.parametrize("power", [4.0, 1.3])
def test_the_stiffness_of_a_table_never_falls_and_its_energy_is_the_integral(power):
    """On a coating, where the force is no power of the depth."""
    from winkler.materials.layered import Layer
    from winkler.media.layered.coated import CoatedHalfSpace

    coat = CoatedHalfSpace([Layer(Elastic(5e9, 0.3), thickness=5e-6)], on=Elastic(200e9, 0.3))
    bed = Foundation(PowerLaw(exponent=power, coefficient=1e-6 / (1e-5) ** power), coat)
    own = law(Indentation(bed, Depth(1e-6)), tolerance=1e-4)
    assert [one.name for one in own.answer] == ["force", "stiffness", "energy"]  # no single ratio on a layer
    depth = np.linspace(0.0, 1e-6, 4001)
    force, stiffness, energy = own.trace(depth[:, np.newaxis]).T
    assert np.all(np.diff(stiffness) >= -1e-12 * stiffness[-1])
    true = Indentation(bed, Depth(depth[1::80])).solve()
    np.testing.assert_allclose(force[1::80], true.force, rtol=0.0, atol=1.2e-4 * force[-1])
    trapezoids = np.concatenate([[0.0], np.cumsum(0.5 * (force[1:] + force[:-1]) * np.diff(depth))])
    np.testing.assert_allclose(energy, trapezoids, rtol=0.0, atol=1e-6 * energy[-1])


def test_balls_do_what_contacts_do():
    rng = np.random.default_rng(5)
    beads = PROBLEMS["beads"]
    depth, moves = rng.uniform(-0.5e-6, 2e-6, 50), rng.normal(scale=3e-7, size=(50, 2))
    turns = rng.normal(scale=1e-3, size=(50, 3))
    found = law(beads).trace(np.column_stack([depth, moves, turns]))
    _, trace = beads.along(depth[None], motion=moves[None], twist=turns[None, :, 0], roll=turns[None, :, 1:])
    columns = [trace.force, trace.shear_force, trace.torque, trace.rolling_moment]
    expected = np.column_stack([column[0] for column in columns])
    np.testing.assert_allclose(found[:, :6], expected, rtol=1e-12, atol=1e-14 * np.max(expected))
    np.testing.assert_allclose(found[:, 7], trace.stored_energy[0], rtol=1e-12)
    np.testing.assert_allclose(found[:, 8], trace.dissipation[0], rtol=1e-12)


def test_friction_does_what_the_march_of_springs_does():
    rng = np.random.default_rng(6)
    depth = np.concatenate([[1e-6], rng.uniform(0.3e-6, 1e-6, 40)])
    shift = np.concatenate([[[0.0, 0.0]], np.cumsum(rng.normal(scale=1e-7, size=(40, 2)), axis=0)])
    path = Path(np.arange(41.0), Depth(depth), Shift(shift))
    found = law(Tangential(BALL, Coulomb(0.3), path), count=50).trace(
        np.column_stack([depth, np.diff(shift, axis=0, prepend=shift[:1])])
    )
    march = Tangential(BALL, Coulomb(0.3), path, Method.SPRINGS, count=50).solve()
    np.testing.assert_allclose(found[:, 0], march.force, rtol=1e-12)
    np.testing.assert_allclose(found[:, 2:4], march.shear_force, rtol=0.0, atol=1e-10 * np.max(march.shear_force))
    np.testing.assert_allclose(found[:, 6], march.dissipation, rtol=1e-9, atol=1e-12 * march.dissipation[-1])


def test_adhesion_with_hysteresis_is_that_of_the_cycle():
    """The other solver follows the equilibria of any profile; this one has springs of a ball."""
    path = np.array([2e-6, 10e-6, 5e-6, -5e-6, -20e-6, 3e-6, -3e-6])
    problem = AdhesiveCycle(RUBBER, ShortRange(work_closing=0.02, work_opening=0.05), Depth(path))
    cycle = problem.solve()
    force, radius, _, _, lost = law(problem).trace(path[:, np.newaxis]).T
    np.testing.assert_allclose(force, cycle.force, rtol=1e-12, atol=1e-14 * np.max(force))
    np.testing.assert_allclose(radius, cycle.radius, rtol=1e-12)
    np.testing.assert_allclose(lost, cycle.dissipation, rtol=1e-11)


def test_pull_off_is_that_of_johnson_kendall_and_roberts():
    problem = AdhesiveCycle(RUBBER, ShortRange(0.05), Depth([10e-6, -1e-5]))
    depth = np.linspace(10e-6, -8e-6, 2001)
    force = law(problem).trace(depth[:, np.newaxis])[:, 0]
    assert np.min(force) == pytest.approx(-1.5 * np.pi * 0.05 * 1e-3, rel=1e-5)


def test_attraction_of_long_range_pulls_with_two_pi_r_w_while_the_bodies_touch():
    depth = np.array([-1e-8, 0.0, 1e-12, 1e-9, 2e-8, 3e-8])
    force, stiffness, energy = law(PROBLEMS["pulled"]).trace(depth[:, np.newaxis]).T
    pressed = np.maximum(depth, 0.0)
    hertz = 4.0 / 3.0 * STEEL.modulus * np.sqrt(1e-3) * pressed**1.5
    pull = np.where(depth > 0.0, 2.0 * np.pi * 1e-3 * 0.05, 0.0)
    np.testing.assert_allclose(force, hertz - pull, rtol=1e-12)
    np.testing.assert_allclose(energy, 0.4 * hertz * pressed - pull * pressed, rtol=1e-12)
    np.testing.assert_allclose(stiffness[2:], 1.5 * hertz[2:] / depth[2:], rtol=1e-12)


def test_a_particle_is_the_one_of_the_solver():
    path = np.array([50e-6, 40e-6, 0.0, -1e-6, 60e-6, 58e-6])
    powder = PROBLEMS["powder"]
    solved = ElasticPlasticParticle(1e-3, powder.solid, Depth(path), work_opening=0.1, work_closing=0.05).solve()
    found = law(powder).trace(path[:, np.newaxis])
    columns = solved.force, solved.radius, solved.residual_depth, solved.energy, solved.dissipation
    np.testing.assert_allclose(found, np.column_stack(columns), rtol=1e-12, atol=1e-18)


def test_a_viscoelastic_contact_is_that_of_the_solver():
    path = Path([0.0, 1.0, 1.0, 1.5, 3.0], Depth([0.0, 1e-4, 0.8e-4, 0.0, 0.5e-4]))
    problem = ViscoelasticIndentation(GEL, path, count=40)
    solved = problem.solve()
    motion = np.column_stack([solved.depth, np.diff(solved.time, prepend=0.0)])
    found = law(problem, count=40).trace(motion)
    columns = solved.force, solved.radius, solved.work, solved.stored_energy, solved.dissipation
    np.testing.assert_allclose(found[:, :5], np.column_stack(columns), rtol=1e-12, atol=1e-20)


@pytest.mark.parametrize("name", ["sheared", "beads", "powder", "sticky"])
def test_no_cycle_creates_energy(name):
    """What is lost never falls, over long random histories with tiny and huge steps."""
    own = law(PROBLEMS[name], count=6)
    rng = np.random.default_rng(9)
    scale = 10.0 ** rng.uniform(-6.0, 0.5, (400, 1))
    motions = scale * rng.choice(own.trial, 400)
    motions[:, 0] = np.minimum(rng.choice(own.trial[:, 0], 400), np.max(own.trial[:, 0]))
    answers = own.trace(motions)
    assert np.all(np.isfinite(answers))
    lost = answers[:, [one.name for one in own.answer].index("dissipation")]
    assert np.all(np.diff(lost) >= -1e-12 * lost[-1])
    assert lost[-1] > 0.0


@pytest.mark.parametrize("name", PROBLEMS)
def test_beyond_the_greatest_depth_nothing_is_said(name):
    own = law(PROBLEMS[name], count=6)
    motion = np.zeros((1, len(own.motion)))
    motion[0, 0] = 1.0
    assert np.all(np.isnan(own.trace(motion)))


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("name", PROBLEMS)
def test_the_heading_states_units_and_validity(name):
    text = export(PROBLEMS[name], "c", name=name, count=6).text
    heading = text[: text.index("*/")]
    for words in ("SI units throughout", "What goes in", "- depth [m]", "- force [N]", "How far it holds", "Made for"):
        assert words in heading


def test_what_is_no_law_is_refused_with_those_that_are():
    with pytest.raises(InvalidInput, match=r"^export: StaticKinetic is no contact law .* one of: Indentation .*"):
        export(StaticKinetic(0.5, 0.3), "c")


def test_mistakes_are_refused_in_one_sentence():
    ball = PROBLEMS["ball"]
    with pytest.raises(InvalidInput, match=r"^export: there is no target 'pyton'.*python"):
        export(ball, "pyton")
    with pytest.raises(InvalidInput, match=r"no precision 'float' for fmu; give double"):
        export(ball, "fmu", precision="float")
    with pytest.raises(InvalidInput, match=r"'for' is a word of C"):
        export(ball, "c", name="for")
    for name in ("Ball", "2ball", "a b", "a" * 40):
        with pytest.raises(InvalidInput, match=r"cannot begin the names of functions"):
            export(ball, "c", name=name)
    with pytest.raises(InvalidInput, match=r"the deepest load presses 0 m deep"):
        export(Indentation(BALL, Force(0.0)), "c")
    mixed = Contacts.apart(GLASS, curvature_radius=[1e-3, 2e-3], coefficient=0.3, reach=2e-6)
    with pytest.raises(InvalidInput, match=r"the contacts differ in curvature_radius"):
        export(mixed, "c")
    moved = PROBLEMS["beads"].moved([1e-6], motion=[[1e-7, 0.0]])
    with pytest.raises(InvalidInput, match=r"moved already"):
        export(moved, "c")
    far = AdhesiveCycle(RUBBER, Dugdale(0.05, 1e6), Depth([1e-6, 0.0]))
    with pytest.raises(InvalidInput, match=r"give ShortRange"):
        export(far, "c")
    sharp = AdhesiveCycle(
        Foundation(PowerLaw(exponent=4.0, coefficient=1e9), GLASS), ShortRange(0.05), Depth([1e-6, 0.0])
    )
    flat = AdhesiveCycle(Foundation(FlatPunch(1e-4), GLASS), ShortRange(0.05), Depth([1e-7, 0.0]))
    for other in (sharp, flat):
        with pytest.raises(InvalidInput, match=r"a ball on a homogeneous half-space.*give a Paraboloid on a HalfSpace"):
            export(other, "c")
    with pytest.raises(InvalidInput, match=r"a str is no exported law"):
        write_export("law", "folder")
    assert set(TARGETS) >= {"c", "python"}


@pytest.mark.parametrize("name", PROBLEMS)
def test_a_step_that_is_no_number_spoils_nothing(name):
    """Issue 38, item 7: a standard solid was not-a-number for ever after one infinite duration."""
    law = law_of(PROBLEMS[name], tolerance=1e-3, count=4)
    for k, part in enumerate(law.motion):
        for number in (np.nan, np.inf, -np.inf):
            motions = np.insert(law.trial[:12], 6, law.trial[6], axis=0)
            motions[6, k] = number
            with np.errstate(all="ignore"):
                answers = law.trace(motions)
            assert np.all(np.isfinite(answers[7:])), (part.name, number)


@pytest.mark.parametrize("duration", [1e4, 1e30, 1e300, math.inf])
def test_after_a_hold_without_end_a_standard_solid_is_relaxed(duration):
    """F = 4/3 E* sqrt(R) d^(3/2) with the relaxed modulus, E* = 4 G of an incompressible solid, with 400 springs."""
    solid = StandardSolid(relaxed_shear=1e6, shear=1e6, relaxation_time=0.1)
    bed = Foundation(Paraboloid(1e-2), ViscoelasticHalfSpace(solid))
    law = law_of(ViscoelasticIndentation(bed, Path([0.0, 1.0], Depth([0.0, 1e-4]))), tolerance=1e-6, count=400)
    answers = law.trace(np.array([[1e-4, 0.0], [1e-4, duration], [0.5e-4, 1.0], [1e-4, duration]]))
    relaxed = 4.0 / 3.0 * 4e6 * math.sqrt(1e-2) * 1e-4**1.5
    np.testing.assert_allclose(answers[[0, 1, 3], 0], [2.0 * relaxed, relaxed, relaxed], rtol=1e-3)
    assert np.all(np.isfinite(answers))
