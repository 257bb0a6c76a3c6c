"""Every kind in other units: all lengths, moduli, times, temperatures and currents times some factors of their own.

An answer must then be what its dimension says. Factors that are powers of two round nothing, so that what differs shows
an absolute length, force or modulus in a solver; but searches that double an absolute start could hide from them.
Factors that are powers of ten find these, and round anew: what an iteration leaves is then another number of the same
size.
"""

from __future__ import annotations

import contextlib
import dataclasses
from typing import Any, NamedTuple

import numpy as np
import pytest
from change_of_units import Units
from example_answers import LASTING, example_problem, lasting_slow, solved

import winkler as wk
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.points import Solved
from winkler.study.language.catalogue import CATALOGUE, kinds
from winkler.values.errors import WinklerError
from winkler.values.validity import Assumption
from winkler.values.vocabulary import word

PROBLEMS = tuple(CATALOGUE["problem"])
PARTS = tuple(name for name in kinds() if name not in PROBLEMS)

BINARY = Units(2.0**-30, 2.0**-20, 2.0**5, 2.0**3, 2.0**-6)
DECIMAL = Units(1e3, 1e6, 7.0, 3.0, 0.2)
OTHERS = [Units(2.0**-30, 2.0**20, 2.0**5, 2.0**3, 2.0**-6), Units(2.0**10, 2.0**-20), Units(1e-9, 1e-6)]
"""With `DECIMAL` each corner of what is small and large, soft and stiff, once; one diagonal by powers of two.

A power of a length times a power of a modulus with a limit of its own is passed in one of two opposite corners."""

SAME = 1e-11
"""Of the greatest number in an answer: what powers of two may change; they change nothing but roots and powers."""
CLOSE = 1e-9
"""What powers of ten may change."""
REDUCED = 1e-7
"""The same where the springs are reduced from contacts of a map, each of which has a tolerance of 1e-6."""


class Rounded(NamedTuple):
    """How far rounding moves an answer, where that is farther than `CLOSE`.

    Parameters
    ----------
    tolerance
        Of the greatest number in the answer; infinite where the answer is itself nothing but rounding.
    why
        The reason.
    beside
        Name of another answer of the same unit, of whose greatest number the tolerance is a part.
    """

    tolerance: float
    why: str
    beside: str = ""


ERROR = Rounded(np.inf, "an error that is left, itself of the size of rounding or of a solver's tolerance")
PLACE = Rounded(1e-7, "a stress is level where it is greatest, which leaves the place half of its digits")
CLIMB = Rounded(1e-4, "the climb to the greatest stress, which is level there, finds its place to 1e-4 of the depth")
STEPS = Rounded(1e-5, "the march has a tolerance of 1e-3: the end of a step is where rounding lets a node touch")
PRESSED = Rounded(1e-7, "each contact has a tolerance of 1e-6")
WORN = Rounded(1e-6, "each of many contacts, one after the other, has a tolerance of 1e-6")
SPRING = Rounded(1e-2, "at moments that an adaptive march of tolerance 1e-3 picks, with 100 springs")
LEAST = Rounded(1e-5, "a sum of squares is level where it is least, which leaves the place half of its digits")
ROUNDED: dict[tuple[str, str], Rounded] = {
    **{
        ("FrictionLoopsSolution", name): LEAST
        for name in (
            *("coefficient", "coefficient_error", "contact_stiffness", "contact_stiffness_error"),
            *("series_compliance", "series_compliance_error", "contact_stroke"),
        )
    },
    **{
        ("MeasuredConstrictionSolution", name): LEAST._replace(beside=name)  # powers of two round radii of power laws
        for name in (
            *("resistivity", "resistivity_error", "film", "film_error", "series", "series_error"),
            "freedom",
        )
    },
    ("SpotClusterSolution", "uncertainty"): ERROR,
    ("OscillatingRollingSolution", "shift_per_cycle"): ERROR,
    **{("EllipticYieldOnsetSolution", name): PLACE for name in "xyz"},
    **{("YieldOnsetSolution", name): PLACE._replace(beside=name) for name in "rz"},  # powers of two round logarithms
    ("SurfaceAdhesionSolution", "residual"): ERROR,
    ("SurfaceAdhesionSolution", "energy_misfit"): Rounded(
        1e-3, "a small difference of energies", beside="energy_misfit"
    ),
    **{
        ("SurfaceAdhesionSolution", name): Rounded(1e-4, "tractions are balanced to 1e-6 of the greatest")
        for name in ("force", "energy", "path_work", "dissipation", "mean_gap", "pull_off_force")
    },
    ("SurfaceContactSolution", "penetration"): ERROR,
    ("SurfaceContactSolution", "misfit"): ERROR,
    ("SealSolution", "imbalance"): ERROR,
    **{
        ("ReducedFrictionSolution", name): Rounded(
            1e-8, "the contacts of the map are solved to 1e-6, in steps of single digits"
        )
        for name in ("spring_shift_x", "spring_shift_y")
    },
    **{("SurfaceWearSolution", name): ERROR for name in ("imbalance", "penetration", "misfit")},
    **{("SurfaceWearSolution", name): WORN for name in ("area", "peak_pressure", "mean_pressure", "worn_depth")},
    ("LineProfileSolution", "strip_error"): ERROR,
    ("LineProfileSolution", "line_of_action"): Rounded(1e-13, "zero of an even section", beside="contact_length"),
    **{
        ("SurfaceTangentialSolution", name): ERROR
        for name in ("shift_y", "shear_force_y", "torque", "penetration", "misfit")
    },
    **{
        ("SurfaceTangentialSolution", name): Rounded(1e-4, "stick and slip have a tolerance of 1e-8 of the energy")
        for name in ("shear_force_x", "stored_energy", "dissipation")
    },
    **{
        ("ReducedFrictionSolution", name): Rounded(
            1e-4, "small differences of shifts, after splines of logarithms", beside=name
        )
        for name in ("shift_error", "loss_error")
    },
    **{
        ("JointStiffnessSolution", name): Rounded(1e-3, "stick and slip have a tolerance of 1e-8 of the energy")
        for name in ("loss_per_cycle", "loss_factor")
    },
    **{
        ("JointStiffnessSolution", name): Rounded(1e-4, "small differences of shifts and losses", beside=name)
        for name in ("shift_error", "loss_error")
    },
    **{("SurfaceRollingSolution", name): ERROR for name in ("lateral_force", "moment", "misfit")},
    **{
        ("SurfaceRollingSolution", name): Rounded(1e-3, "stick and slip have a tolerance of 1e-7 of the loss")
        for name in ("longitudinal_force", "shear_force", "saturation", "loss_per_distance", "stick_share")
    },
    **{
        ("SurfaceRollingStartSolution", name): ERROR
        for name in ("lateral_creepage", "lateral_force", "moment", "misfit")
    },
    **{
        ("SurfaceRollingStartSolution", name): Rounded(1e-3, "stick and slip have a tolerance of 1e-8 of the energy")
        for name in ("longitudinal_creepage", "longitudinal_force", "stick_share")
    },
    ("SurfaceFrictionHeatingSolution", "mismatch"): ERROR,
    **{
        ("SurfaceFrictionHeatingSolution", name): Rounded(1e-3, "stick and slip have a tolerance of 1e-7 of the loss")
        for name in ("heat_rate", "creep_power", "max_temperature", "mean_temperature", "grid_error", "swing")
    },
    **{
        ("HeldContactsSolution", name): Rounded(1e-7, "least squares whose derivatives are quotients of differences")
        for name in ("shear_error", "poisson_error", "diffusivity", "diffusivity_error", "scatter")
    },
    **{
        ("MasterCurveSolution", name): Rounded(1e-7, "the evidence is flat at its maximum, where its search ends")
        for name in (
            *("shift_factor", "shift_error", "relaxed_shear", "relaxed_shear_error", "freedom"),
            *("first_constant", "second_constant", "activation_energy", "shears", "scatter"),
        )
    },
    ("ReductionSolution", "misfit"): Rounded(1e-6, "it is checked by contacts of a tolerance of 1e-6"),
    ("ReductionSolution", "force"): Rounded(1e-8, "each contact has a tolerance of 1e-6"),
    ("ProfilePairSolution", "grid_error"): ERROR,
    **{("ProfilePairRollingSolution", name): ERROR for name in ("grid_error", "misfit")},
    **{
        ("ProfilePairRollingSolution", name): Rounded(1e-4, "stick and slip have a tolerance of 1e-7 of the loss")
        for name in (
            *("x_force", "y_force", "z_force", "loss_per_distance", "longitudinal_force", "lateral_force", "moment"),
            *("saturation", "stick_share", "depth", "height", "peak_pressure", "force", "place", "angle"),
            *("longitudinal_creepage", "lateral_creepage", "spin_creepage"),
        )
    },
    **{("MapStressSolution", name): CLIMB for name in "xy"},
    **{
        ("ProfilePairSolution", name): PRESSED
        for name in ("peak_pressure", "height", "lateral_force", "place", "angle")
    },
    **{("ThermalJointSolution", name): PRESSED for name in ("spot_conductance", "gap_conductance")},
    **{("SlidingSolution", name): STEPS for name in ("depth", "radius", "worn_depth", "mean_pressure")},
    **{("LineSlidingSolution", name): STEPS for name in ("half_width", "worn_depth", "mean_pressure")},
    **{
        ("ViscoelasticImpactSolution", name): SPRING
        for name in ("time", "depth", "velocity", "force", "radius", "duration", "dissipation")
    },
}
"""Answers that follow rounding farther, with the number."""

OF_NATURE = {Assumption.ADHESION, Assumption.CONTINUUM, Assumption.INERTIA, Assumption.TEMPERATURE}
"""Relative to constants of nature: the reach of attraction, the free path of electrons, gravity, what solids stand."""
NAMED = {
    "named_elastic": "a name stands for numbers in SI units",
    "named_electrical_conductor": "a name stands for numbers in SI units",
    "named_thermal_conductor": "a name stands for numbers in SI units",
    "formula": "its constants have units that only the formula knows",
    "formula_section": "its constants have units that only the formula knows",
}
"""Kinds that cannot be written in other units, and why."""


def specimen(name: str) -> Any:
    """Return the problem of an example study; of a crack that takes its time, a shorter path."""
    problem = example_problem(name)
    if name == "viscoelastic_adhesion":
        return dataclasses.replace(problem, path=wk.Path([0.0, 1.0, 3.0], wk.Depth([5e-6, 1e-6, -3e-6])))
    return problem


def differences(solution: Any, other: Any, units: Units, close: float) -> list[str]:
    """Return in which answers a solution and that in other units differ."""
    owner = type(solution)
    before, after = answers_of(solution), answers_of(other)
    if list(before) != list(after):
        return [f"answers: {sorted(set(before) ^ set(after))}"]
    found = []
    for name, content in before.items():
        expected = np.asarray(content) * units.factor(word(owner, name).unit or "")
        got = np.asarray(after[name])
        limit = close
        rounded = ROUNDED.get((owner.__name__, name), Rounded(0.0, ""))
        if rounded.beside:
            limit = rounded.tolerance
        elif close > SAME:
            limit = max(close, rounded.tolerance)
        if np.isinf(limit):
            continue
        if got.shape != expected.shape:
            found.append(f"{name}: shape {expected.shape}, then {got.shape}")
        elif not np.array_equal(np.isfinite(got), np.isfinite(expected)):
            found.append(f"{name}: finite elsewhere")
        else:
            finite = np.isfinite(expected)
            scale = np.asarray(before[rounded.beside or name]) * units.factor(word(owner, name).unit or "")
            size = float(np.max(np.abs(scale[np.isfinite(scale)]), initial=0.0))
            miss = float(np.max(np.abs(got[finite] - expected[finite]), initial=0.0))
            if miss > limit * size:
                found.append(f"{name}: {miss / size if size else np.inf:.1e}")
    return found


def restored(solution: Any) -> list[Any]:
    """Return fields of the last contact of a solution, on the surface and below it, as far as they are known."""
    contact = Solved((), (), None, solution, ()).each[-1]
    if not hasattr(contact, "pressed") or not contact.radius > 0.0:
        return []
    r = float(contact.radius) * np.array([0.0, 0.3, 0.7, 1.4])
    found = []
    for places in ((r,), (r[:, np.newaxis], 0.5 * r[np.newaxis, 1:])):
        with contextlib.suppress(WinklerError):
            found.append(wk.restore(contact, *places))
    return found


def field_differences(fields: Any, others: Any, units: Units, close: float) -> list[str]:
    """Return which restored fields differ."""
    found = []
    for field in dataclasses.fields(fields):
        content = getattr(fields, field.name)
        if isinstance(content, np.ndarray):
            expected = content * units.factor(word(type(fields), field.name).unit or "")
            size = float(np.max(np.abs(expected[np.isfinite(expected)]), initial=0.0))
            if not np.allclose(getattr(others, field.name), expected, rtol=0.0, atol=close * size, equal_nan=True):
                found.append(field.name)
    return found


def standings(solution: Any) -> list[tuple[Assumption, str]]:
    """Return what the notes of a solution say of which assumption, but for constants of nature."""
    notes = solution.validity
    return [(note.assumption, note.standing.value) for note in notes if note.assumption not in OF_NATURE]


def assert_same(problem: Any, changes: list[Units]) -> None:
    """Solve a problem, and again in other units."""
    try:
        solution = solved(problem)
    except WinklerError as error:
        for units in changes:
            with pytest.raises(type(error)):
                units.changed(problem).solve()
        return
    close = REDUCED if isinstance(getattr(problem, "bed", None), wk.ReducedBed) else CLOSE
    for units in changes:
        other = units.changed(problem).solve()
        exact = all(np.frexp(factor)[0] == 0.5 for factor in units)
        assert differences(solution, other, units, SAME if exact else close) == [], units
        assert standings(other) == standings(solution), units
        for fields, others in zip(restored(solution), restored(other), strict=True):
            assert field_differences(fields, others, units, close) == [], units


@pytest.mark.parametrize("name", lasting_slow(PROBLEMS))
def test_every_problem_in_other_units(name):
    """Powers of ten find what powers of two find and more, to two digits less; these are among the slow tests."""
    assert_same(specimen(name), [DECIMAL])


def test_a_map_that_frets_in_other_units():
    """The example of its kind rolls."""
    steel, conductor = wk.Elastic(210e9, 0.3), wk.ThermalConductor(45.0, 12e-6)
    ball = wk.SampledProfile([0.5e-3, 0.5e-3], wk.Paraboloid(10e-3), (24, 24))
    path = wk.Path.oscillation(force=100.0, amplitude=1e-6, cycles=2, count=8)
    fretted = wk.SurfaceTangential(ball, wk.HalfSpace(steel, steel), wk.Coulomb(0.5), path)
    pair = wk.HeatConductors(conductor, conductor)
    assert_same(wk.SurfaceFrictionHeating(fretted, pair, frequency=100.0), [DECIMAL, *OTHERS])


@pytest.mark.few(0, slow=12)
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long) if name in LASTING else name for name in PROBLEMS]
)
def test_every_problem_at_all_scales(name):
    """The corners that `test_every_problem_in_other_units` leaves; of examples that take long they are long tests."""
    assert_same(specimen(name), OTHERS)


@pytest.mark.few(0, slow=20)
@pytest.mark.parametrize(
    "units", [pytest.param(DECIMAL, id="ten"), pytest.param(BINARY, marks=pytest.mark.long, id="two")]
)
@pytest.mark.parametrize("name", [name for name in PARTS if name not in NAMED])
def test_every_part_in_other_units(name, units):
    """Powers of two only find what is wrong in the last digits; they are long tests."""
    assert_same(specimen(name), [units])


SHAPES = {"cone": wk.Cone(1.35), "power_law": wk.PowerLaw(1e6, 4.0), "flat_punch": wk.FlatPunch(1e-3)}
"""Bodies without a length of their own, and one whose contact has one radius."""


PLAIN = [
    pytest.param(
        name, shape, marks=pytest.mark.slow if number % 6 == 0 and number // 6 % 3 == place else pytest.mark.long
    )
    for number, name in enumerate(PROBLEMS)
    for place, shape in enumerate(SHAPES)
]
"""One of these bodies for each sixth problem, by turns, is a slow test; the others are long tests."""


@pytest.mark.parametrize(("name", "shape"), PLAIN)
def test_every_problem_of_bodies_without_a_length(name, shape):
    problem = specimen(name)
    bed = getattr(problem, "bed", None)
    if not hasattr(bed, "profile") or "bed" not in {field.name for field in dataclasses.fields(problem)}:
        pytest.skip("it takes no bed with a profile")
    try:
        problem = dataclasses.replace(problem, bed=dataclasses.replace(bed, profile=SHAPES[shape]))
    except WinklerError:
        pytest.skip("it refuses such a body")
    assert_same(problem, [Units(2.0**-30, 2.0**-20) if shape == "cone" else Units(2.0**10, 2.0**20)])


def test_the_change_of_units_is_detected():
    """What is not scaled by its dimension is found."""
    problem = specimen("indentation")
    units = Units(length=1e-3)
    assert differences(problem.solve(), problem.solve(), units, CLOSE)
    assert units.factor("N") == pytest.approx(1e-6)
    assert BINARY.factor("J/(mol K)") == 1.0  # the gas constant
    assert Units(temperature=2.0, current=3.0).factor("V^2/K^2") == pytest.approx(1.0 / 36.0)
