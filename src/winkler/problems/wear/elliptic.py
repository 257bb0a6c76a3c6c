r"""Wear of an elliptic contact that slides, as long as the worn depth is small beside the approach.

The pressure is then that of the unworn bodies all the time: of homogeneous ones Hertz' ellipse, of others a map of
pixels.  A body in whose axes the contact rests loses

.. math:: h(x,y) = \kappa\,p(x,y)\,s , \qquad V = \kappa F s ,

and the other one in each pass, at the distance t from the middle of the track, what the chord along the sliding makes
of it: the projection of a half-ellipsoid is a parabola,

.. math:: h(t) = \kappa\int p\,\mathrm du = \kappa\,\frac{3F}{4w}\Bigl(1-\frac{t^2}{w^2}\Bigr) , \qquad
          w = \sqrt{a^2\sin^2\theta+b^2\cos^2\theta} .
"""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated, ClassVar, NamedTuple

import numpy as np

from winkler.laws.wear import WearLaw, worn_by
from winkler.loading.loads import Force
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.media.offers import LayerStack, offers
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import WORN
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution, pressed_ellipse
from winkler.problems.pressed_shape.pressed_map import PressedMap
from winkler.problems.wear.validity import DEBRIS
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.ellipse import CurvedBodies
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Advice, Finite, Positive
from winkler.values.checks.place_checks import common_places
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value, words

NODES = 40
DIRECTIONS = 180
"""In which the contour of a map is asked how wide the contact is."""
STEP = 0.5
"""Of the places along a chord of a map, in pixels."""
SMALL_WEAR, LARGE_WEAR = 0.01, 0.1
"""Worn depth over the approach up to which the pressure is as good as that of Hertz, and beyond which it is not."""
ARCHARD = "J. F. Archard, J. Appl. Phys. 24 (1953) 981-988, doi:10.1063/1.1721448"


def _one_positive(load: Force) -> bool:
    return np.ndim(load.force) == 0 and float(load.force) > 0.0


@value
class EllipticWear:
    """Initial sliding wear of two bodies with two curvatures each.

    Parameters
    ----------
    bodies : CurvedBodies or CurvedPair
        R_x and R_y, or the radii of each body; x is the principal direction of the pair.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, SlidingFilm, StackedHalfSpace, \
DepthGradedHalfSpace or GradedHalfSpace
        Both bodies: on homogeneous ones Hertz's ellipse, on others a map of pixels; the first one has the layers.
    wear : Archard, PairWear or OwnWear
        Law of wear.  The first body is the slider, at rest relative to the contact. The second body has the track, and
        wears only under a PairWear.
    load : Force
        The steady normal force, one positive number.
    distance : float
        Sliding distance s [m], summed over both directions.
    angle : float, optional
        Direction of sliding, from x towards y [rad]; along x by default.
    passes : float, optional
        Number of passes of the slider over each point of the track; one by default.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type, or is not positive.

    References
    ----------
    J. F. Archard, J. Appl. Phys. 24 (1953) 981-988, doi:10.1063/1.1721448

    Examples
    --------
    A crowned pin of 10 mm and 40 mm radius slides along its short axis: what 1 m takes off it, and off the track.

    >>> from winkler.laws.wear import Archard, PairWear
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> steel = HalfSpace.between(Elastic(210e9, 0.3), Elastic(210e9, 0.3))
    >>> both = PairWear(Archard(1e-17), Archard(1e-15))
    >>> worn = EllipticWear(CurvedBodies(10e-3, 40e-3), steel, both, Force(100.0), distance=1.0, passes=10.0).solve()
    >>> round(worn.worn_depth * 1e9, 2), round(worn.track_depth * 1e9, 2), round(worn.track_half_width * 1e6, 1)
    (9.09, 2.07, 362.5)
    """

    __words__ = words(
        bodies=("", None, "curvature radii of the bodies along x and y"),
        distance=("s", "m", "distance slid"),
        angle=(r"\theta", "rad", "direction of sliding, from x towards y"),
        passes=("n", "", "how often the slider passes over each place of the track"),
    )

    bodies: CurvedBodies | CurvedPair
    medium: Annotated[MappedMedium, Advice("neither Hertz's ellipse nor the boundary elements apply to another")]
    wear: WearLaw
    load: Annotated[
        Force[float], Condition(_one_positive, "give Force(F) with one positive number, and sweep over several")
    ]
    distance: Positive
    angle: Finite = 0.0
    passes: Positive = 1.0

    references: ClassVar[tuple[str, ...]] = ("archard_1953", "hertz_1882", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = WORN

    def solve(self) -> EllipticWearSolution:
        """Return the wear of both bodies.

        Raises
        ------
        OutsideValidity
            If the distance is shorter than the passes over the length of the contact.
        InvalidInput
            If the curvatures are so different that the contact is a line, or a user-defined law of wear does not
            return worn depths.
        """
        contact = EllipticIndentation(self.bodies, self.medium, self.load).solve()
        pressed = _pressed(contact)
        half_width = pressed.half_width(self.angle)
        needed = self.passes * pressed.length(self.angle)
        if self.distance < needed:
            raise OutsideValidity(
                f"EllipticWear: {self.passes:g} passes over the length of the contact need a distance of "
                f"{needed:.4g} m, and it is {self.distance:.4g} m; give a longer distance or fewer passes."
            )
        pressures, areas = pressed.spread
        first, second = worn_by(self.wear, pressures)
        deepest = worn_by(self.wear, np.array([float(contact.peak_pressure)]))[0]
        return EllipticWearSolution(
            self,
            contact,
            worn_depth=float(deepest[0]) * self.distance,
            worn_volume=float(np.sum(first * areas)) * self.distance,
            track_half_width=half_width,
            track_area=float(np.sum(second * areas)) * self.passes,
        )


class _Ellipse(NamedTuple):
    """Hertz' pressure."""

    a: float
    b: float
    peak: float

    def half_width(self, angle: float) -> float:
        """Return half the width of the contact across a direction [m]."""
        return math.hypot(self.a * math.sin(angle), self.b * math.cos(angle))

    def length(self, angle: float) -> float:
        """Return the length of the contact through its middle along a direction [m]."""
        return 2.0 * self.a * (self.b / self.half_width(angle))

    @property
    def spread(self) -> tuple[Array, Array]:
        """Pressures [Pa], and the areas that bear them [m^2]."""
        node, weight = gauss_legendre(NODES)  # of 0 to 1
        return self.peak * node, 2.0 * math.pi * self.a * self.b * weight * node

    def along(self, t: Array, angle: float) -> tuple[Array, Array]:
        """Return pressures [Pa] along chords at distances t from the middle, a new last axis, and lengths [m]."""
        chord = np.sqrt(np.maximum(1.0 - (t / self.half_width(angle)) ** 2, 0.0))[..., None]
        node, weight = gauss_legendre(NODES)
        cosine = np.cos(0.5 * math.pi * node)  # of the turn whose sine is the place along the chord
        return self.peak * chord * cosine, (0.5 * math.pi * self.length(angle)) * weight * chord * cosine


class _Pixels(NamedTuple):
    """The pressure of a map, whose contact is even about its middle."""

    pressed: PressedMap

    def half_width(self, angle: float) -> float:
        """Return half the width of the contact across a direction [m]."""
        turns = np.linspace(0.0, math.pi, DIRECTIONS, endpoint=False)
        return float(np.max(self.pressed.contour(angle + turns) * np.sin(turns)))

    def length(self, angle: float) -> float:
        """Return the length of the contact through its middle along a direction [m]."""
        return 2.0 * float(self.pressed.contour(angle)[0])

    @property
    def spread(self) -> tuple[Array, Array]:
        """Pressures [Pa], and the areas that bear them [m^2]."""
        pressure = self.pressed.pressure.ravel()
        return pressure, np.full(pressure.shape, math.prod(self.pressed.pixel))

    def along(self, t: Array, angle: float) -> tuple[Array, Array]:
        """Return pressures [Pa] along chords at distances t from the middle, a new last axis, and lengths [m]."""
        x, y = self.pressed.x, self.pressed.y
        step = STEP * min(self.pressed.pixel)
        half = math.ceil(math.hypot(float(x[-1]), float(y[-1])) / step)
        u, across = np.arange(-half, half + 1) * step, t[..., None]
        cosine, sine = math.cos(angle), math.sin(angle)
        return self.pressed.pressure_at(u * cosine - across * sine, u * sine + across * cosine), np.full(u.shape, step)


def _pressed(contact: EllipticSolution) -> _Ellipse | _Pixels:
    """Return the pressure of a contact under one force."""
    problem = contact.problem
    if isinstance(problem.medium, HomogeneousMedium):
        axes = float(contact.longitudinal_semi_axis), float(contact.lateral_semi_axis)
        return _Ellipse(*axes, float(contact.peak_pressure))
    return _Pixels(pressed_ellipse(problem.bodies.together, problem.medium, problem.load)[1])


@value
class EllipticWearSolution:
    """The solution of an `EllipticWear`.

    Parameters
    ----------
    problem : EllipticWear
        The problem that was solved.
    contact : EllipticSolution
        The contact, with nearly constant pressure.
    worn_depth : float
        Maximum worn depth of the slider [m], in the middle of the ellipse.
    worn_volume : float
        Wear volume of the slider [m^3].
    track_half_width : float
        w [m]: half the width of the ellipse across the sliding.
    track_area : float
        Cross-section of the track [m^2].
    """

    __words__ = words(
        contact=("", None, "the contact, whose pressure hardly changes"),
        worn_depth=(r"h_\mathrm{max}", "m", "greatest worn depth of the slider"),
        worn_volume=("V", "m^3", "what the slider has lost"),
    )

    problem: EllipticWear
    contact: EllipticSolution[float]
    worn_depth: float
    worn_volume: float
    track_half_width: float
    track_area: float

    def worn(self, x: ArrayLike, y: ArrayLike) -> Array:
        """Return the worn depth of the slider [m], zero outside of the ellipse.

        Parameters
        ----------
        x, y : array_like
            Positions on the surface [m], of shapes that broadcast.

        Raises
        ------
        InvalidInput
            If a place is not finite, or the shapes do not broadcast.
        """
        return np.asarray(worn_by(self.problem.wear, self.contact.pressure(x, y))[0] * self.problem.distance)

    def track(self, t: ArrayLike) -> Array:
        """Return the depth of the track on the second body after all passes [m], zero outside it.

        Parameters
        ----------
        t : array_like
            Positions across the sliding direction [m], from the middle of the track.

        Raises
        ------
        InvalidInput
            If a place is not finite.
        """
        (across,) = common_places("EllipticWearSolution", t=t)
        pressures, lengths = _pressed(self.contact).along(across, self.problem.angle)
        lost = worn_by(self.problem.wear, pressures)[1]
        return np.asarray(np.sum(lost * lengths, axis=-1) * self.problem.passes)

    @property
    def track_depth(self) -> float:
        """Maximum depth of the track on the second body [m]; zero if this body does not wear."""
        return float(self.track(0.0))

    @property
    def worn_share(self) -> float:
        """Maximum worn depths of both bodies over the approach [-]."""
        return (self.worn_depth + self.track_depth) / float(self.contact.depth)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return (
            *(_slid(note) for note in self.contact.validity),
            sliding_note(self.problem.medium, math.nan),  # type: ignore[arg-type]
            self._wear_note(),
            DEBRIS,
        )

    def _wear_note(self) -> Note:
        medium, share, lost = self.problem.medium, self.worn_share, ""
        whose = "Hertz' pressure" if isinstance(medium, HomogeneousMedium) else "The pressure of the unworn bodies"
        if offers(medium, LayerStack):
            thinned = self.worn_depth / medium.layers[0].thickness
            lost, share = f", and that of the first body {thinned:.2g} of its uppermost layer", max(share, thinned)
        standing = standing_of(share, SMALL_WEAR, LARGE_WEAR)
        why = (
            f"{whose} is used for all wear states. The total worn depth of both bodies at the centre is "
            f"{self.worn_share:.2g} of the approach{lost}"
        )
        effect = (
            "This pressure is no longer valid: give a shorter distance, or use SlidingWear for round bodies."
            if standing is Standing.OUTSIDE
            else (
                "The true maximum pressure is lower by about the same fraction, for slender ellipses by two to "
                "three times this fraction."
            )
        )
        held = " The layers are assumed to stay in place under the friction force." if lost else ""
        return Note(Assumption.WEAR, standing, f"{why}. {effect}{held}", ARCHARD)


def _slid(note: Note) -> Note:
    """Return a note on the contact, that on yield without the friction, which no law of wear states."""
    if note.assumption is not Assumption.ELASTIC or note.standing is Standing.OUTSIDE:
        return note
    beside = f"{note.statement} Friction adds to it; EllipticYieldOnset computes how much."
    return dataclasses.replace(note, standing=Standing.APPROXIMATE, statement=beside)
