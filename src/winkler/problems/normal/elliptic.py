r"""Bodies of two curvatures pressed together: Hertz's elliptic contact in closed form, and by pixels on layers.

With the larger semi-axis :math:`\alpha`, the smaller :math:`\beta`, :math:`m=1-\beta^2/\alpha^2`, and
:math:`\alpha\propto F^{1/3}` of `winkler.profiles.ellipse.CurvedBodies`,

.. math:: d = \frac{3F}{2\pi E^*\alpha}R_F(0,1-m,1) , \qquad \frac{\mathrm dF}{\mathrm dd} = \frac{3F}{2d} , \qquad
          p = p_0\sqrt{1-\frac{x^2}{a^2}-\frac{y^2}{b^2}} , \quad p_0 = \frac{3F}{2\pi ab} .

The force grows as that of a ball of the radius :math:`R_\mathrm{eq} = 9F^2/(16E^{*2}d^3)`: what needs no more
than force, depth and stiffness runs on its springs, `winkler.foundation.elliptic`.  On layers and gradings the contact
is nearly an ellipse, and its pressure another one: both follow from `winkler.problems.pressed_shape.pressed_map`.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated, ClassVar, cast

import numpy as np

from winkler.foundation.elliptic import EllipticFoundation
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.interior.peak import StressSpot
from winkler.media.mapped import MappedMedium, layers_of
from winkler.media.medium import Medium
from winkler.numerics.caching import cached_by_value
from winkler.numerics.types import Array, ArrayLike, PerLoad, Q, like
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal import elliptic_fields as inside
from winkler.problems.normal.elliptic_fields import EllipticFields
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.map_yield import map_yield_notes
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.validity import steepness_note
from winkler.problems.normal.yield_of_pressure import ellipse_yield_notes
from winkler.problems.one_load import picked, single
from winkler.problems.pressed_shape.notes import pixel_notes
from winkler.problems.pressed_shape.pressed_map import PIXELS, PressedMap, edge_error, grid_error, pressed_levels
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.which_body import in_first_body
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.ellipse import CurvedBodies
from winkler.profiles.power import Paraboloid
from winkler.values.checks.number_checks import Advice
from winkler.values.checks.place_checks import common_places
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

ELLIPSE = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Homogeneous, linear elastic half-spaces: under normal load Hertz's ellipse is exact for bodies with two "
    "curvatures each.",
    "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 4.2, doi:10.1017/CBO9781139171731",
)
OF_THE_DISTANCE = "This is the slope of the gap between the bodies. Give a CurvedPair for the slopes of each body."
AXES = (0.0, 0.5 * math.pi)
"""Directions of the semi-axes [rad]."""
EDGE_ERROR = ("", "", "relative error of area, stiffness and edge of the contact that pixels leave")
BENT = 30.0
"""1 + M of waves as long as the contact, above which layers bend over it: by depth their pressures hardly converge."""
MOST_FORCES, MET = 12, 1e-6
"""Forces that are tried in the place of such a depth, and its error over itself."""
CONFORMING = "M. Ciavarella, P. Decuzzi, Int. J. Solids Struct. 38 (2001) 4507, doi:10.1016/S0020-7683(00)00289-4"


@value
class EllipticIndentation(PerLoad[Q]):
    """Frictionless contact of two bodies with two curvatures each.

    Parameters
    ----------
    bodies : CurvedBodies or CurvedPair
        1/R_x is the sum of the curvatures of both bodies along x, 1/R_y the same along y.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, SlidingFilm, StackedHalfSpace, \
DepthGradedHalfSpace or GradedHalfSpace
        Both bodies: on homogeneous ones Hertz's ellipse, on others a map of pixels.
    load : Force or Depth
        The prescribed quantity, not negative. For an array the results have its shape.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 4.2, doi:10.1017/CBO9781139171731

    Examples
    --------
    Crossed cylinders of 10 mm and 20 mm radius, made of steel.

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> steel = Elastic(210e9, 0.3)
    >>> crossed = EllipticIndentation(CurvedBodies(20e-3, 10e-3), HalfSpace.between(steel, steel), Force(100.0)).solve()
    >>> round(crossed.longitudinal_semi_axis * 1e6, 3), round(crossed.lateral_semi_axis * 1e6, 3)  # micrometres
    (262.064, 165.256)
    >>> round(crossed.equivalent_radius * 1e3, 4)
    14.4262
    """

    bodies: CurvedBodies | CurvedPair
    medium: Annotated[MappedMedium, Advice("neither Hertz's ellipse nor the boundary elements apply to another")]
    load: Force[Q] | Depth[Q]

    references: ClassVar[tuple[str, ...]] = ("hertz_1882", "johnson_1985", "popov_hess_2015", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    @property
    def equivalent_radius(self) -> float:
        """R_eq [m] of the ball with the same force-depth curve, for homogeneous bodies."""
        return self.bodies.equivalent_radius

    @property
    def bed(self) -> EllipticFoundation:
        """The spring foundation with the same force-depth curve; shear forces act along x.

        Raises
        ------
        InvalidInput
            If the bodies are not homogeneous.
        """
        return EllipticFoundation(self.bodies.together, self.medium)  # type: ignore[arg-type]

    def solve(self) -> EllipticSolution[Q]:
        """Return force, depth and contact.

        Raises
        ------
        OutsideValidity
            If a force is tensile, or pixels are too coarse for an incompressible layer.
        InvalidInput
            If the curvatures are so different that the contact is a line.
        NotConverged
            If the pressures of the pixels are not found.
        """
        if isinstance(self.load, Force) and np.any(np.asarray(self.load.force) < 0.0):
            raise OutsideValidity(
                f"EllipticIndentation: force {float(np.min(self.load.force)):.6g} N is tensile; without adhesion "
                "bodies can only be pressed together: give a force of zero or more."
            )
        if not isinstance(self.medium, HomogeneousMedium):
            return self._by_pixels()
        a, b = self.bodies.semi_axes(self.medium.modulus, 1.0)
        unit = float(np.cbrt(9.0 / (16.0 * self.equivalent_radius * self.medium.modulus**2)))
        if isinstance(self.load, Force):
            force = np.asarray(self.load.force, dtype=float)
            depth = unit * np.cbrt(force) ** 2
        else:
            depth = np.asarray(self.load.depth, dtype=float)
            force = (np.maximum(depth, 0.0) / unit) ** 1.5
        grown = np.cbrt(force)
        stiffness = 2.0 * self.medium.modulus * np.sqrt(self.equivalent_radius * np.maximum(depth, 0.0))
        area = math.pi * a * b * grown**2
        pressure = 1.5 * force / np.where(area > 0.0, area, 1.0)
        columns = (depth, force, a * grown, b * grown, stiffness, area, pressure, 0.0 * force, 0.0 * force)
        prescribed: Q = self.load.force if isinstance(self.load, Force) else self.load.depth
        return EllipticSolution(self, *(like(column, prescribed) for column in columns))

    def _by_pixels(self) -> EllipticSolution[Q]:
        """Return the solution on layers, gradings and power laws, load by load."""
        by_force = isinstance(self.load, Force)
        loads = numbers_of(self.load)
        rows = np.zeros((9, loads.size))
        for row, load in zip(rows.T, loads.ravel().tolist(), strict=True):
            row[1 if by_force else 0] = load
            if load <= 0.0:
                continue
            coarse, fine = pressed_ellipse(self.bodies.together, self.medium, Force(load) if by_force else Depth(load))
            row[:] = (
                fine.depth, fine.force, *fine.contour(AXES), fine.stiffness, fine.area, fine.peak_pressure,
                grid_error(coarse, fine), edge_error(coarse, fine, AXES),
            )  # fmt: skip
        prescribed: Q = self.load.force if isinstance(self.load, Force) else self.load.depth
        return EllipticSolution(self, *(like(column, prescribed) for column in rows))


@cached_by_value(8)
def pressed_ellipse(
    bodies: CurvedBodies, medium: MappedMedium, load: Force | Depth, pixels: int = PIXELS
) -> tuple[PressedMap, PressedMap]:
    """Return the bodies pressed by pixels under one positive load, on a coarse grid and on a fine one.

    Parameters
    ----------
    bodies : CurvedBodies
    medium : CoatedHalfSpace, SlidingFilm, StackedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
    load : Force or Depth
    pixels : int
        Along each side of the fine grid.

    Raises
    ------
    OutsideValidity, NotConverged
        As in `EllipticIndentation.solve`.
    """
    radii = bodies.longitudinal_curvature_radius, bodies.lateral_curvature_radius

    def gap(x: Array, y: Array) -> Array:
        return np.asarray(0.5 * (x**2 / radii[0] + y**2 / radii[1]))

    hertz = EllipticIndentation(bodies, HalfSpace(Elastic(medium.modulus, 0.0)), load).solve()  # a first guess
    start = float(hertz.longitudinal_semi_axis), float(hertz.lateral_semi_axis)
    stretch, below = start[0] / start[1], layers_of(medium)
    if isinstance(load, Force) or below is None or float(below.whole(np.array([1.0 / max(start)]))[0]) < BENT:
        return pressed_levels("EllipticIndentation", gap, medium, load, start, pixels=pixels)
    ball = Indentation(Foundation(Paraboloid(bodies.equivalent_radius), cast(Medium, medium)), load).solve()
    radius, force = float(ball.radius), float(ball.force)
    start = radius * math.sqrt(stretch), radius / math.sqrt(stretch)
    for _ in range(MOST_FORCES):
        coarse, fine = pressed_levels("EllipticIndentation", gap, medium, Force(force), start, pixels=pixels)
        if abs(fine.depth / float(load.depth) - 1.0) < MET:
            return coarse, fine
        force += fine.stiffness * (float(load.depth) - fine.depth)
    raise NotConverged(
        f"EllipticIndentation: no force is found at which the depth is {float(load.depth):.6g} m; give a force instead."
    )


@value
class EllipticSolution(PerLoad[Q]):
    """The solution of an `EllipticIndentation`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : EllipticIndentation
        The problem that was solved.
    depth : float or ndarray
        d [m].
    force : float or ndarray
        F_N [N], compression positive.
    longitudinal_semi_axis, lateral_semi_axis : float or ndarray
        Semi-axes of the contact, a [m] along x and b [m] along y; zero without contact.
    stiffness : float or ndarray
        dF/dd [N/m].
    area : float or ndarray
        Of the contact [m^2].
    peak_pressure : float or ndarray
        p_0 [Pa], the maximum; zero without contact.
    grid_error : float or ndarray
        Relative change of depth, force and maximum pressure compared with half as many pixels along a side; zero for
        the closed form.
    edge_error : float or ndarray
        Relative error of area, stiffness and semi-axes due to the pixels; zero for the closed form.
    """

    __words__ = words(
        longitudinal_semi_axis=("a", "m", "semi-axis of the contact along x"),
        lateral_semi_axis=("b", "m", "semi-axis of the contact along y"),
        edge_error=EDGE_ERROR,
    )

    problem: EllipticIndentation[Q]
    depth: Q
    force: Q
    longitudinal_semi_axis: Q
    lateral_semi_axis: Q
    stiffness: Q
    area: Q
    peak_pressure: Q
    grid_error: Q
    edge_error: Q

    per_load: ClassVar[str] = "depth"

    @property
    def equivalent_radius(self) -> float:
        """R_eq [m] of the ball with the same force-depth curve, if the bodies are homogeneous."""
        return self.problem.equivalent_radius

    def pressure(self, x: ArrayLike, y: ArrayLike) -> Array:
        """Return the pressure under one load [Pa], zero outside of the contact.

        Parameters
        ----------
        x, y : array_like
            Positions on the surface [m], of shapes that broadcast.

        Raises
        ------
        InvalidInput
            If the solution has more than one load, a place is not finite, or the shapes do not broadcast.
        """
        single(self.depth, "pressure")
        along, across = common_places("EllipticSolution", x=x, y=y)
        if self.force == 0.0:
            return np.zeros(along.shape)
        problem = self.problem
        if not isinstance(problem.medium, HomogeneousMedium):
            load = Force(float(self.force)) if isinstance(problem.load, Force) else Depth(float(self.depth))
            return pressed_ellipse(problem.bodies.together, problem.medium, load)[1].pressure_at(along, across)
        squared = (along / self.longitudinal_semi_axis) ** 2 + (across / self.lateral_semi_axis) ** 2
        return np.asarray(self.peak_pressure * np.sqrt(np.maximum(1.0 - squared, 0.0)))

    @property
    def surface_load(self) -> SurfaceLoad:
        """The pressures of pixels under the greatest load."""
        return _pressed_map(self).load()

    def stresses(
        self, x: ArrayLike, y: ArrayLike, z: ArrayLike, friction: float = 0.0, angle: float = 0.0
    ) -> EllipticFields:
        """Return stresses and displacements inside one body under one load, at rest or in full sliding.

        Parameters
        ----------
        x, y : array_like
            Positions along the surface [m].
        z : array_like
            Depths [m]: not negative in the first body, negative in the second, of which -0.0 is the surface.
            All in one of them.
        friction : float
            mu [-] for full sliding: the traction on the body is mu p.
        angle : float
            Direction of the traction on the body, from x towards y [rad]; the traction on the other body is opposite.

        Raises
        ------
        InvalidInput
            If the solution has more than one load, a place is not finite, or the depths lie in both bodies.
        OutsideValidity
            If there is no contact, or the body is rigid or not isotropic.

        References
        ----------
        A. Sackfield, D. A. Hills, J. Strain Anal. 18 (1983) 107-110, doi:10.1243/03093247V182107
        """
        semi_axes, peak = self._pressed("stresses")
        along, across, depth = common_places("EllipticSolution", x=x, y=y, z=z)
        below = in_first_body(depth, "EllipticSolution")
        places = along, across, np.abs(depth)
        solid = inside.solid_below(self.problem.medium, below)
        fields = inside.below_ellipse(places, semi_axes, peak, solid, inside.traction_of(friction, angle))
        return fields if below else dataclasses.replace(fields, z=-fields.z)

    def greatest_stress(
        self, friction: float = 0.0, angle: float = 0.0, *, measure: str = "von_mises", below: bool = True
    ) -> StressSpot:
        """Return the maximum stress of a kind [Pa] under one load, and its place x, y, z [m] in the axes of the body.

        Parameters
        ----------
        friction, angle : float
            As in `stresses`.
        measure : {'von_mises', 'max_shear', 'orthogonal_shear', 'longitudinal_shear', 'lateral_shear'}
            Measure of stress. Half the difference of the extreme principal stresses is the maximum shear; orthogonal
            shear acts in planes parallel to the surface in any direction, along x, or along y.
        below : bool
            Whether to search in the first body; otherwise the second is searched.

        Raises
        ------
        InvalidInput, OutsideValidity
            As in `stresses`; also for another measure.
        """
        (a, _), peak = self._pressed("stresses")
        poisson = inside.solid_below(self.problem.medium, below).poisson
        slenderness, traction = self.problem.bodies.slenderness, inside.traction_of(friction, angle)
        return inside.greatest_below_ellipse(measure, a, slenderness, peak, poisson, traction)

    def _pressed(self, requested: str) -> tuple[tuple[float, float], float]:
        single(self.depth, requested)
        if self.force == 0.0:
            raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
        return (float(self.longitudinal_semi_axis), float(self.lateral_semi_axis)), float(self.peak_pressure)

    def at(self, index: int | tuple[int, ...]) -> EllipticSolution[float]:
        """Return the solution of one load of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such load.
        """
        _, depth, force, _ = picked(self.problem.load, index, self.depth, self.force, self.depth)
        load = Force(force) if isinstance(self.problem.load, Force) else Depth(depth)
        return EllipticIndentation(self.problem.bodies, self.problem.medium, load).solve()

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes, onset of yield."""
        axes = float(np.max(self.longitudinal_semi_axis)), float(np.max(self.lateral_semi_axis))
        medium, slopes = self.problem.medium, _slopes_note(self.problem.bodies, axes)
        if not isinstance(medium, HomogeneousMedium):
            errors = float(np.max(self.grid_error)), float(np.max(self.edge_error))
            return (*pixel_notes(medium, *errors), slopes, *pressed_yield_notes(self))
        return (
            *(note for note in medium.notes if note.standing is not Standing.EXACT),  # of a round contact
            ELLIPSE,
            slopes,
            *ellipse_yield_notes(medium, (self.longitudinal_semi_axis, self.lateral_semi_axis), self.force),
        )


def _slopes_note(bodies: CurvedBodies | CurvedPair, axes: tuple[float, float]) -> Note:
    """Return what the slopes within an ellipse mean; those of each body count, which the radii together do not tell."""
    steep = steepness_note(bodies.steepest_slope(*axes))
    if isinstance(bodies, CurvedPair):
        return steep
    ball = max(axes) / min(bodies.longitudinal_curvature_radius, bodies.lateral_curvature_radius)
    if steep.standing is not Standing.ASYMPTOTIC or steepness_note(ball).standing is Standing.ASYMPTOTIC:
        return dataclasses.replace(steep, statement=f"{steep.statement} {OF_THE_DISTANCE}")
    return Note(
        Assumption.SMALL_SLOPES,
        Standing.APPROXIMATE,
        f"The steepest slope of the gap within the contact is {bodies.steepest_slope(*axes):.3g}, which is small. "
        f"For a ball in a groove the slope of the bodies would be up to {ball:.3g}. Such a contact would be "
        "narrower by about a quarter of the square of this slope. Give a CurvedPair for the slopes of each body.",
        CONFORMING,
    )


def _pressed_map(contact: EllipticSolution[Q]) -> PressedMap:
    """Return the contact under its greatest load, by pixels."""
    problem, force = contact.problem, float(np.max(contact.force))
    if force == 0.0:
        raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
    load = Force(force) if isinstance(problem.load, Force) else Depth(float(np.max(contact.depth)))
    return pressed_ellipse(problem.bodies.together, problem.medium, load)[1]


def pressed_yield_notes(contact: EllipticSolution[Q], traction: tuple[float, float] = (0.0, 0.0)) -> tuple[Note, ...]:
    """Return whether bodies pressed by pixels stay elastic under the greatest load.

    Parameters
    ----------
    contact : EllipticSolution
        On layers, gradings or power laws.
    traction : tuple of float, optional
        Along x and y over the pressure [-], of a contact that slides.
    """
    medium = contact.problem.medium
    if not strong_parts(medium) or not np.any(contact.force):
        return ()
    return map_yield_notes(medium, _pressed_map(contact).load(traction))
