r"""Onset of yield below Hertz's ellipse, at rest or sliding in any direction.

All stresses grow with :math:`p_0\propto F^{1/3}`: with the greatest von Mises stress :math:`k\,p_0` of each body, its
strength Y and the ellipse a, b of the force one, yielding begins at

.. math:: F = \Big(\frac{2\pi ab\,Y}{3k}\Big)^3 .

On layers pressures are those of pixels, stresses in each layer follow from waves in all directions
(`winkler.media.layered.map_interior`), and the force is sought at which the greatest one is the strength.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import ClassVar

from winkler.laws.friction import Coulomb, Overcome
from winkler.loading.loads import Force
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.coated import CoatedHalfSpace, SlidingFilm, StackedHalfSpace
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution
from winkler.problems.normal.elliptic_fields import traction_of
from winkler.problems.normal.onset.ellipse_in_layers import coarse_layers
from winkler.problems.normal.onset.elliptic_layers import onsets_in_layers
from winkler.problems.normal.onset.part_onset import EllipticPartOnset, onset_note
from winkler.problems.normal.strong_parts import strong_parts
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.ellipse import CurvedBodies
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

FRICTIONLESS = Coulomb(0.0)


@value
class EllipticYieldOnset:
    """The force at which an elliptic contact begins to yield, with or without sliding.

    Parameters
    ----------
    bodies : CurvedBodies or CurvedPair
        R_x and R_y, or the radii of each body.
    medium : HalfSpace, CoatedHalfSpace, SlidingFilm or StackedHalfSpace
        Both bodies; at least one part has a strength.
    friction : Coulomb, optional
        Coulomb's law of a contact that slides everywhere, with the traction mu p on each body; no friction by default.
    angle : float, optional
        Direction of the traction on each body in its own axes, from x towards y [rad]; along x by default. The
        tangential axes of the second body are opposite to those of the first.

    Raises
    ------
    InvalidInput
        If no body has a strength, or the medium is not isotropic.
    OutsideValidity
        If there is friction on a layer that slides on the material below.

    References
    ----------
    A. Sackfield, D. A. Hills, J. Strain Anal. 18 (1983) 107-110, doi:10.1243/03093247V182107

    Examples
    --------
    A bearing ball in its groove: the force, and how deep it begins to yield.

    >>> from winkler.materials.elastic import Elastic
    >>> steel = Elastic(208e9, 0.3, strength=1.2e9)
    >>> onset = EllipticYieldOnset(CurvedBodies(3.77e-3, 124e-3), HalfSpace.between(steel, steel)).solve()
    >>> round(onset.force, 1), round(onset.z * 1e6, 2)  # N, micrometres
    (766.1, 97.79)
    """

    __words__ = words(
        friction=("", None, "law of friction of a contact that slides everywhere"),
        angle=(r"\theta", "rad", "direction of the traction on the surface, from x towards y"),
    )

    bodies: CurvedBodies | CurvedPair
    medium: HalfSpace | CoatedHalfSpace | SlidingFilm | StackedHalfSpace
    friction: Overcome = FRICTIONLESS
    angle: float = 0.0

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.UNCOUPLED}

    def __post_init__(self) -> None:
        if not math.isfinite(self.angle):
            raise InvalidInput(f"EllipticYieldOnset: the angle is {self.angle!r}; give one in radians.")
        if not isinstance(self.medium, HalfSpace) and self.friction.coefficient != 0.0:
            _ = self.medium.along_modulus  # refuses layers that slide
        if not strong_parts(self.medium):
            raise InvalidInput(
                "EllipticYieldOnset: no body has a strength; give Elastic(young, poisson, strength=...)."
            )

    def solve(self) -> EllipticYieldOnsetSolution:
        """Return the force at the onset of yield, and the position of the onset.

        Raises
        ------
        InvalidInput
            If the curvatures are so different that the contact is a line.
        OutsideValidity, NotConverged
            If the pressures on layers, or the force, are not found.
        """
        error = 0.0
        if isinstance(self.medium, HalfSpace):
            rows = self._in_half_spaces()
        else:
            traction = traction_of(self.friction.coefficient, self.angle)
            rows, error = onsets_in_layers(self.bodies.together, self.medium, traction)
        first = min(rows, key=lambda row: row.force)
        pressed = self._pressed(first.force)
        return EllipticYieldOnsetSolution(self, first.force, pressed, first.x, first.y, first.z, rows, error)

    def _in_half_spaces(self) -> tuple[EllipticPartOnset, ...]:
        unit = self._pressed(1.0)
        rows = []
        for number, part in enumerate(strong_parts(self.medium), 1):
            place = unit.greatest_stress(self.friction.coefficient, self.angle, below=part.first)
            grown = part.solid.strength / place.value
            x, y, z = (grown * along for along in (place.x, place.y, place.z))
            rows.append(EllipticPartOnset(number, part.name, grown**3, x, y, z if part.first else -z))
        return tuple(rows)

    def _pressed(self, force: float) -> EllipticSolution[float]:
        return EllipticIndentation(self.bodies, self.medium, Force(force)).solve()


@value
class EllipticYieldOnsetSolution:
    """The solution of `EllipticYieldOnset`.

    Parameters
    ----------
    problem : EllipticYieldOnset
        The problem that was solved.
    force : float
        [N] when yielding begins.
    contact : EllipticSolution
        The contact under this force.
    x, y, z : float
        Position of the onset [m] in the axes of the body; z is negative (also -0.0) in the second body.
    onsets : tuple of EllipticPartOnset
        The onset of yield of each body, layer and base with a strength, in order from the uppermost layer of the first
        body down.
    grid_error : float
        Relative error of these forces, estimated with half as many pixels along a side; zero for the closed form.
    """

    __words__ = words(
        onsets=("", None, "onset of yield of each body, layer and base"),
        contact=("", None, "the contact when yielding begins"),
        x=("x", "m", "place along the surface"),
    )

    problem: EllipticYieldOnset
    force: float
    contact: EllipticSolution[float]
    x: float
    y: float
    z: float
    onsets: tuple[EllipticPartOnset, ...]
    grid_error: float

    @property
    def depth(self) -> float:
        """d [m] when yielding begins."""
        return float(self.contact.depth)

    @property
    def peak_pressure(self) -> float:
        """p_0 [Pa] when yielding begins."""
        return float(self.contact.peak_pressure)

    @property
    def longitudinal_semi_axis(self) -> float:
        """Semi-axis a [m] along x when yielding begins."""
        return float(self.contact.longitudinal_semi_axis)

    @property
    def lateral_semi_axis(self) -> float:
        """Semi-axis b [m] along y when yielding begins."""
        return float(self.contact.lateral_semi_axis)

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        medium, fading = self.problem.medium, []
        if not isinstance(medium, HalfSpace):
            thickness = medium.layers[0].thickness
            grown = [(one.force / self.force) ** (1.0 / 3.0) for one in self.onsets]
            widest = max(self.longitudinal_semi_axis, self.lateral_semi_axis)
            fading = [
                one.name
                for one, growth in zip(self.onsets, grown, strict=True)
                if math.copysign(1.0, one.z) > 0.0 and coarse_layers(thickness, growth * widest)
            ]
        criterion = onset_note([(one.name, one.force) for one in self.onsets], "N", fading=fading)
        others = (note for note in self.contact.validity if note.assumption is not Assumption.ELASTIC)
        rubbed = sliding_note(self.problem.medium, self.problem.friction.coefficient)
        if self.problem.friction.coefficient == 0.0 and self.problem.angle != 0.0:
            rubbed = replace(rubbed, statement=f"{rubbed.statement} The angle of friction has no effect.")
        if not isinstance(medium, HalfSpace):
            criterion = replace(
                criterion,
                standing=max(criterion.standing, Standing.ASYMPTOTIC, key=list(Standing).index),
                statement=f"{criterion.statement} Two grids leave an error of up to "
                f"{100.0 * self.grid_error:.1g} per cent in these forces.",
            )
        return (*others, rubbed, criterion)
