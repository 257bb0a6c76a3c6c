"""The stresses beside an answer: greatest pressure, von Mises' and shear stress with their depths, load of yield.

One search serves all contacts whose stresses are known: springs of round contacts, also where an edge adheres, Hertz's
ellipse, strips, height maps, rollers, and patches of profiles with their tractions, bodies
that relax, and metals that have yielded, whose greatest von Mises stress is the strength.  Strips of bodies
that relax follow from their own pressures.  Not built: worn bodies, whose pressure is known at single places alone,
attraction of a range, whose springs do not end at the rim, and strips that pull at their edges; `unknown_because` says
why.  Only the modules of the contact at hand are loaded.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import PressedSprings, StretchedSprings
from winkler.media.halfspace import HalfSpace
from winkler.media.interior import tensor
from winkler.media.offers import LayerStack, offers
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.strong_parts import StrongPart, solid_parts, strong_parts
from winkler.study.batch.points import SolvedPoint
from winkler.study.chapters.contents import answer_of
from winkler.study.report.headline.shown_contact import medium_of, stressed_contact
from winkler.values.errors import OutsideValidity, WinklerError
from winkler.values.readable import with_unit

SAME_WIDTH = 1e-6
"""Relative difference up to which half-widths, or forces, are the same."""
LOADED = {"force", "force_per_length", "mean_pressure"}
"""Numbers of a contact under load, whose stresses are stated, or why they are not."""
NODES = 401
"""Places between which the pressure of a strip is linear, closer together at its edges."""
RADII = 201
"""Distances from the axis among which the greatest pressure of bodies that relax is sought."""
FRICTIONLESS = "without friction"
BESIDE, BELOW = np.linspace(-1.3, 1.3, 14), np.geomspace(0.02, 2.5, 20)
"""Places across strips and below them, in half-widths, from which the greatest stress is climbed to."""
MOST_PIXELS = 256 * 256
"""Larger maps take seconds: their stresses are sought only if a strength was given, for which they are known."""
ROUND = ("Paraboloid", "Sphere", "NoneType")
"""Profiles whose elastic stress is a power of the load; ellipses have none of their own."""


class Deep(NamedTuple):
    """A greatest stress [Pa], how far below the surface it is [m], and in which of several bodies or layers."""

    value: float
    depth: float
    body: str = ""


Search = Callable[[StrongPart, tensor.Measure], Deep]


class ElasticState(NamedTuple):
    """The stresses of an answer.

    Parameters
    ----------
    peak_pressure
        [Pa]; infinite at a sharp edge or apex.
    von_mises
        Greatest von Mises stress [Pa], outside a tenth of the contact radius around a sharp place.
    depth
        How far below the surface [m]; not a number where that is not known.
    body
        In which body or layer.
    sharp
        Why the stress is infinite somewhere; empty where it is not.
    strength
        Of that body [Pa]; infinite where none was given.
    yield_load
        Load at which that body yields; not a number where it is not known.
    unit
        Of the load: N, or N/m of a strip.
    under
        Which contact it is, or with which tractions.
    shears
        Greatest shear stress of all bodies, and that along the surface; empty where they are not known.
    load
        Load of the contact [N, N/m]; not a number where the load of yield is not known.
    """

    peak_pressure: float
    von_mises: float
    depth: float
    body: str
    sharp: str
    strength: float
    yield_load: float
    unit: str
    under: str = FRICTIONLESS
    shears: tuple[Deep, ...] = ()
    load: float = math.nan

    @property
    def share(self) -> float:
        """The greatest von Mises stress over the strength; zero where none was given."""
        return self.von_mises / self.strength

    @property
    def margin(self) -> float:
        """The load of yield over that of the contact; where it is not known, the strength over the stress."""
        if not math.isnan(self.yield_load):
            return self.yield_load / self.load if self.load > 0.0 else math.inf
        return 1.0 / self.share if self.share > 0.0 else math.inf

    def place(self, digits: int = 2) -> str:
        """Return where the greatest von Mises stress is, for a sentence."""
        if math.isnan(self.depth):
            return self.body
        deep = f"{with_unit(self.depth, 'm', digits)} below the surface" if self.depth else "at the surface"
        return f"{deep}, {self.body}"


@functools.lru_cache(maxsize=2)  # headline, summary and cards ask for one point
def elastic_state(point: SolvedPoint) -> ElasticState | None:
    """Return the stresses of the contact that a point holds; None where there is none, or they are not known.

    Parameters
    ----------
    point
        A solved point.
    """
    try:
        contact = stressed_contact(point)
        problem = getattr(contact, "problem", point.problem)
        if isinstance(getattr(contact, "pressed", None), PressedSprings):
            return _round(contact)
        for form in (_yielded, _ellipse, _strips, _strip, _roller):
            if (found := form(contact, problem)) is not None:
                return found
        return _map(point) or _relaxing(point) or _pressed_strip(point)
    except WinklerError:  # the contact is sound, its stresses are not known
        return None


def _state(
    parts: tuple[StrongPart, ...], find: Search, peak: float, unit: str, under: str = FRICTIONLESS
) -> tuple[StrongPart, ElasticState]:
    """Return the part nearest to its strength, of parts without one the most stressed, and the stresses."""
    found = [(part, find(part, tensor.von_mises)) for part in parts]
    part, (stress, depth, _) = max(found, key=lambda one: (one[1].value / _strength(one[0]), one[1].value))
    shears = []
    for measure in tensor.KINDS[1:]:
        try:
            most = max(((find(one, measure), one.name) for one in parts), key=lambda one: one[0].value)
            shears.append(most[0]._replace(body=most[1] if len(parts) > 1 else ""))
        except WinklerError:  # of an ellipse or of layers some kinds are not known
            break
    strength = _strength(part)
    return part, ElasticState(peak, stress, depth, part.name, "", strength, math.nan, unit, under, tuple(shears))


def _strength(part: StrongPart) -> float:
    """Return the strength of a part [Pa]; infinite of solids that have none, as those that relax."""
    return float(getattr(part.solid, "strength", math.inf))


def _round(contact: Any) -> ElasticState | None:
    from winkler.problems.normal.greatest_stress import greatest_stress

    pressed = contact.pressed
    parts = solid_parts(pressed.bed.medium)
    if type(pressed) not in (PressedSprings, StretchedSprings) or not parts or pressed.radius <= 0.0:
        return None
    sharp = {part: greatest_stress(pressed, _alike(parts, part, pressed)).sharp for part in parts}

    def find(part: StrongPart, measure: tensor.Measure) -> Deep:
        place = greatest_stress(pressed, _alike(parts, part, pressed), measure=measure)
        return Deep(place.value, place.z)

    sticks = not isinstance(contact, IndentationSolution)
    inside = pressed.radius * np.linspace(0.0, 1.0, RADII, endpoint=False)
    peak = float(np.max(pressed.bed.medium.pressure(pressed, inside) if sticks else contact.peak_pressure))
    part, state = _state(parts, find, peak, "N", f"with adhesion, {FRICTIONLESS}" if sticks else FRICTIONLESS)
    asked = part.solid.strength < math.inf and not sticks
    onset = _onset(pressed.bed, part, sharp[part]) if asked else math.nan
    shears = () if any(sharp.values()) else state.shears
    load = float(np.max(contact.force))
    return state._replace(sharp=sharp[part], yield_load=onset, shears=shears, load=load)


def _alike(parts: tuple[StrongPart, ...], part: StrongPart, pressed: PressedSprings) -> StrongPart:
    """Return the first part with the same stresses: in half-spaces they depend on Poisson's ratio alone."""
    if not isinstance(pressed.bed.medium, HalfSpace):
        return part
    return next(one for one in parts if one.solid.poisson == part.solid.poisson)


@functools.lru_cache(maxsize=64)
def _onset(bed: Any, part: StrongPart, sharp: str) -> float:
    """Return the force at which the part nearest to its strength yields [N]; not a number where that is not known."""
    from winkler.problems.normal.yielding import YieldOnset, onset_of_part

    try:
        return 0.0 if sharp else onset_of_part(YieldOnset(bed), 1, part).force
    except WinklerError:
        return math.nan


def _yielded(solution: Any, problem: Any) -> ElasticState | None:
    """Return what holds of metals that are pressed beyond their first yield, and below it the elastic stress."""
    load = next((name for name in ("force", "force_per_length") if hasattr(solution, name)), "")
    onset, parts = getattr(problem, "yield_force", math.nan), strong_parts(medium_of(solution))
    if not (load and parts and isinstance(onset, float) and hasattr(solution, "residual_depth")):
        return None
    greatest = float(np.max(getattr(solution, load)))
    unit, power = ("N", 1.0 / 3.0) if load == "force" else ("N/m", 0.5)
    part, times = min(parts, key=lambda one: one.solid.strength), greatest / onset if onset > 0.0 else math.inf
    if times < 1.0 and type(getattr(problem.bed, "profile", None)).__name__ not in ROUND:
        return None  # only below balls, ellipses and cylinders the stress is a power of the load
    strength, hardens = part.solid.strength, hasattr(part.solid, "flow_stress")
    under = FRICTIONLESS
    if times >= 1.0:
        under = f"where it yields{' and hardens: this or more' * hardens}; residual stresses are not computed"
    stress = min(times**power, 1.0) * strength
    return ElasticState(math.nan, stress, math.nan, part.name, "", strength, onset, unit, under, (), greatest)


def _ellipse(solution: Any, problem: Any) -> ElasticState | None:
    axes = [getattr(solution, name, None) for name in ("longitudinal_semi_axis", "lateral_semi_axis", "peak_pressure")]
    medium = getattr(problem, "medium", None)
    if any(axis is None or np.size(axis) != 1 for axis in axes) or not isinstance(medium, HalfSpace):
        return None
    from winkler.problems.normal.elliptic_fields import greatest_below_ellipse

    first, second, peak = (float(axis) for axis in axes)  # type: ignore[arg-type]

    def find(part: StrongPart, measure: tensor.Measure) -> Deep:
        spot = greatest_below_ellipse(measure.__name__, first, second / first, peak, part.solid.poisson, (0.0, 0.0))
        return Deep(spot.value, spot.z)

    _, state = _state(solid_parts(medium), find, peak, "N")
    force = 2.0 / 3.0 * math.pi * first * second * peak
    return state._replace(yield_load=force / state.share**3 if state.share else math.nan, load=force)


def _strip(solution: Any, problem: Any) -> ElasticState | None:
    half_width, force = (getattr(solution, name, None) for name in ("half_width", "force_per_length"))
    if half_width is None:  # an ellipse, which has no bed on layers
        return None
    bed: Any = getattr(problem, "bed", None)
    if not hasattr(bed, "hertzian") or not isinstance(bed.medium, HalfSpace):
        return None
    from winkler.loading.loads import HalfWidth, LineForce
    from winkler.problems.line.indentation import LineIndentation
    from winkler.problems.line.peak_pressure import rim_load
    from winkler.problems.line.stress import LineContact

    widths = np.ravel(half_width)
    forces = widths if force is None else np.resize(force, widths.shape)
    widest = int(np.argmax(forces))
    width = float(widths[widest])
    given = HalfWidth(width) if force is None else LineForce(float(forces[widest]))
    elastic = LineIndentation(bed, given).solve()
    if not width > 0.0 or not math.isclose(float(elastic.half_width), width, rel_tol=SAME_WIDTH):
        return None
    peak = float(elastic.peak_pressure)
    if math.isinf(peak):
        return None
    edge = rim_load(bed, float(elastic.force_per_length), width)
    find = _below_strip(lambda one: LineContact(bed, width, edge, one.solid.poisson, 0.0))
    _, state = _state(solid_parts(bed.medium), find, peak, "N/m")
    similar = bed.hertzian and state.share > 0.0  # all cylinders are similar
    load = float(elastic.force_per_length)
    return state._replace(yield_load=load / state.share**2 if similar else math.nan, load=load)


def _below_strip(contact_of: Callable[[StrongPart], Any]) -> Search:
    """Return the search below a strip of plane strain."""
    from winkler.problems.line.greatest_stress import greatest, in_strip

    def find(part: StrongPart, measure: tensor.Measure) -> Deep:
        place = greatest(contact_of(part), in_strip(measure))
        return Deep(place.value, abs(place.z))

    return find


def _strips(solution: Any, problem: Any) -> ElasticState | None:
    """Return the stresses below the most pressed of the strips of a profile, or below each of the strips of a wave."""
    if not (hasattr(solution, "strip_peaks") or hasattr(solution, "closure_pressure")):
        return None
    peak = float(solution.peak_pressure)
    if math.isinf(peak):
        return None
    if hasattr(solution, "edges"):
        low, high = map(float, np.reshape(solution.edges, (-1, 2))[int(np.argmax(solution.strip_peaks))])
    else:
        low, high = -solution.half_width, solution.half_width
    under = "below the most pressed strip, without friction" if hasattr(solution, "edges") else FRICTIONLESS
    find = _below_places(low, high, lambda part, x, z: solution.stresses(x, z if part.first else -z))
    return _state(solid_parts(medium_of(solution)), find, peak, "N/m", under)[1]


def _pressed_strip(point: SolvedPoint) -> ElasticState | None:
    """Return the stresses below a strip of bodies that relax, by its own pressure, under the greatest force."""
    forces = np.array([np.max(getattr(one, "force_per_length", 0.0)) for one in point.each])
    found = point.each[int(np.flatnonzero(forces >= (1.0 - SAME_WIDTH) * np.max(forces))[-1])]
    half, parts = float(np.max(getattr(found, "half_width", 0.0))), _plain_parts(medium_of(found))
    if not (half > 0.0 and parts and callable(getattr(found, "pressure", None))) or answer_of(point.problem).unstressed:
        return None
    from winkler.numerics.surfaces.strip_elements import linear_potential
    from winkler.problems.line.stress import fields_of

    low, high = float(getattr(found, "trailing_edge", -half)), float(getattr(found, "leading_edge", half))
    nodes = 0.5 * (low + high) - 0.5 * (high - low) * np.cos(np.linspace(0.0, np.pi, NODES))
    pressure = np.concatenate([[0.0], found.pressure(nodes[1:-1]), [0.0]])
    if not np.all(np.isfinite(pressure) & (pressure >= 0.0)):  # an edge pulls, or is sharp
        return None

    def stress(part: StrongPart, x: Array, z: Array) -> Any:
        return fields_of(x, z, np.array(linear_potential(nodes, pressure, x, z)), part.solid.poisson)

    when = getattr(found, "time", None)
    under = FRICTIONLESS if when is None else f"{FRICTIONLESS}, after {with_unit(float(np.max(when)), 's')}"
    return _state(parts, _below_places(low, high, stress), float(np.max(pressure)), "N/m", under)[1]


def _below_places(low: float, high: float, stresses: Callable[[StrongPart, Array, Array], Any]) -> Search:
    """Return the search among places below a strip between two edges."""
    from winkler.numerics.equations.highest import highest
    from winkler.problems.line.greatest_stress import in_strip

    half = 0.5 * (high - low)

    def find(part: StrongPart, measure: tensor.Measure) -> Deep:
        top = highest(lambda x, z: in_strip(measure)(stresses(part, x, z)), [low + half * (1.0 + BESIDE), half * BELOW])
        return Deep(top.value, top.place[1])

    return find


def _plain_parts(medium: Any) -> tuple[StrongPart, ...]:
    """Return the homogeneous bodies of a pair, also those that relax: all that stresses below a pressure ask for."""
    if not (hasattr(medium, "first") and hasattr(medium, "second")):
        return ()
    if isinstance(medium, HalfSpace):
        return solid_parts(medium)
    bodies = ((medium.first, "first body", True), (medium.second, "second body", False))
    return tuple(StrongPart(name, body, first) for body, name, first in bodies if hasattr(body, "poisson"))


def _roller(solution: Any, problem: Any) -> ElasticState | None:
    """Return the stresses in the middle of a roller with sharp ends, taken as endless; others are maps."""
    medium, last = getattr(problem, "medium", None), getattr(solution, "last", solution)
    if not (isinstance(medium, HalfSpace) and hasattr(last, "middle_pressure")):
        return None
    if not (last.middle_pressure > 0.0 and math.isinf(last.peak_pressure)):
        return None
    from winkler.foundation.line import LineFoundation
    from winkler.problems.line.stress import LineContact
    from winkler.profiles.power import Paraboloid

    bed = LineFoundation(Paraboloid(problem.radius), medium)
    width = 2.0 * problem.radius * last.middle_pressure / medium.modulus
    find = _below_strip(lambda one: LineContact(bed, width, 0.0, one.solid.poisson, 0.0))
    return _state(solid_parts(medium), find, last.peak_pressure, "N", "in the middle, the sharp ends left aside")[1]


def _map(point: SolvedPoint) -> ElasticState | None:
    """Return the stresses below a height map, or below the most pressed patch of two profiles, with their tractions."""
    found = pressed_map(point)
    if found is None or not (isinstance(found[0], HalfSpace) or offers(found[0], LayerStack)):
        return None
    from winkler.media.interior.map_peak import greatest_below
    from winkler.problems.normal.map_yield import greatest_in_parts

    medium, load, under = found
    if load.pressure.size > MOST_PIXELS and not strong_parts(medium):
        return None
    tractions = "with its tractions" if np.any(load.loads[1:]) else FRICTIONLESS
    said = f"{under}, {tractions}"
    parts = strong_parts(medium) or solid_parts(medium)
    if not isinstance(medium, HalfSpace):
        spots = dict(zip(parts, greatest_in_parts(load, medium, parts), strict=True))

        def in_layers(part: StrongPart, measure: tensor.Measure) -> Deep:
            if measure is not tensor.von_mises:
                raise OutsideValidity("below maps on layers the greatest von Mises stress alone is sought")
            return Deep(spots[part].value, spots[part].z)

        return _state(parts, in_layers, float(np.max(load.pressure)), "N", said)[1]

    @functools.cache
    def on_grid(part: StrongPart) -> dict[tensor.Measure, Deep]:
        field = (load if part.first else load.reversed()).field(part.solid.poisson)
        spots = greatest_below(field, tensor.KINDS, rounds=2, climbed=True).greatest
        return {measure: Deep(spot.value, spot.z) for measure, spot in zip(tensor.KINDS, spots, strict=True)}

    def find(part: StrongPart, measure: tensor.Measure) -> Deep:
        return on_grid(part)[measure]

    return _state(solid_parts(medium), find, float(np.max(load.pressure)), "N", said)[1]


def pressed_map(point: SolvedPoint) -> tuple[Any, Any, str] | None:
    """Return the bodies, what acts on the first of them, and of which map or patch; None where no map is pressed.

    Parameters
    ----------
    point
        A solved point.
    """
    holders: tuple[Any, ...] = (point.solution, point.each[-1], getattr(point.each[-1], "contact", None))
    for holder in holders:
        patches = getattr(holder, "patches", ())
        if isinstance(patches, tuple) and patches:
            most = max(patches, key=lambda one: float(np.max(one.surface_load.pressure)))
            return getattr(most, "patch", most).medium, most.surface_load, "most pressed patch"
        if worst := max(getattr(holder, "heaviest", ()), key=_load_of, default=None):
            rough = holder.problem.topography
            load = type(holder.surface_load).of_map(
                rough.lengths, worst.pressure, worst.traction, periodic=rough.periodic
            )
            return holder.problem.medium, load, f"on this grid, state {worst.index + 1}"
        if hasattr(holder, "surface_load"):
            medium = medium_of(holder)
            return holder._medium if medium is None else medium, holder.surface_load, "on this grid"
    return None


def _load_of(state: Any) -> float:
    """Return the greatest of p^2 + 3 tau^2 in a pixel [Pa^2], von Mises' of a traction alone."""
    return float(np.max(state.pressure**2 + 3.0 * np.sum(state.traction**2, axis=0)))


def _relaxing(point: SolvedPoint) -> ElasticState | None:
    """Return the stresses of bodies that relax, under the greatest force of a path.

    Pressures decide: stresses below given pressures depend on Poisson's ratio alone, which does not relax.
    """
    solution, problem = point.solution, point.problem
    medium = medium_of(solution)
    if not np.ndim(getattr(solution, "force", 0.0)) or isinstance(medium, HalfSpace):
        return None
    from winkler.problems.normal.greatest_stress import greatest_stress

    index = int(np.argmax(solution.force))
    parts = _plain_parts(medium)
    state: Any = _state_of(problem, solution, index) if parts else None
    if not (hasattr(state, "pressed") and hasattr(state, "pressure")):
        return None
    pressed = state.pressed

    def find(part: StrongPart, measure: tensor.Measure) -> Deep:
        place = greatest_stress(pressed, part, measure=measure)
        if place.sharp:
            raise OutsideValidity(place.sharp)
        return Deep(place.value, place.z)

    peak = float(np.max(state.pressure(np.linspace(0.0, state.radius, RADII, endpoint=False))))
    under = f"{FRICTIONLESS}, at the greatest force, after {with_unit(float(state.time), 's')}"
    return _state(parts, find, peak, "N", under)[1]


def _state_of(problem: Any, solution: Any, index: int) -> Any:
    """Return the state of a march after a number of steps; of a load in one step, that at one of its times."""
    if hasattr(problem, "steps"):
        return next(itertools.islice(problem.steps(), index, None))
    if not (hasattr(solution, "time") and hasattr(problem, "time")):
        return None
    from winkler.loading.loads import Depth, Force
    from winkler.loading.path import Path
    from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation

    load: Any = Force if hasattr(problem, "force") else Depth
    held = load(np.full(2, problem.force if load is Force else problem.depth))
    return list(ViscoelasticIndentation(problem.bed, Path(np.array([0.0, solution.time[index]]), held)).steps())[-1]


def unknown_because(point: SolvedPoint) -> str:
    """Return why the stresses of a contact are not stated, and which kind states them; empty where no load is known.

    The record of the problem names wear, a dent or tension at the edge; else its bodies are the reason.

    Parameters
    ----------
    point
        A solved point whose stresses are not known.
    """
    if not point.answers.keys() & LOADED:
        return ""
    line, medium = "force_per_length" in point.answers, medium_of(stressed_contact(point))
    elastic = "line_indentation" if line else "indentation"
    if reason := answer_of(point.problem).unstressed:
        return reason.format(elastic)
    if _plain_parts(medium) and not isinstance(medium, HalfSpace):
        other = f"{'' if line else 'viscoelastic_indentation or, with one modulus, '}{elastic} states them"
        return f"the pressure depends on the history of the load; {other}"
    if not isinstance(medium, HalfSpace):
        return f"they are not implemented in these bodies; {elastic} states them for homogeneous elastic ones"
    return f"this answer holds no pressure at each place; {elastic} or surface_contact states them"
