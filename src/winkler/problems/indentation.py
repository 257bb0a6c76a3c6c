r"""Normal contact without friction or adhesion: a bed pressed by a force, to a depth, or to a contact radius.

The springs at :math:`|x|<a` are compressed by :math:`d-g(x)`, the last one just touches, :math:`g(a)=d`, and

.. math:: F = k(a)\,d - \int_0^a k'(x)\,g(x)\,\mathrm dx, \qquad \frac{\mathrm dF}{\mathrm dd} = k(a), \qquad
          U = \tfrac12\int_0^a k'(x)\,(d-g(x))^2\,\mathrm dx .

At a vertical rim the contact is pinned: d then grows beyond g(a).
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.bed import Bed, Pressed
from winkler.loading import Depth, Force, Load, Radius
from winkler.numerics import abel
from winkler.numerics.roots import invert
from winkler.numerics.types import Array, Quantity
from winkler.problems import disc
from winkler.problems.trust import indentation_notes
from winkler.validity import Note
from winkler.values import value

__all__ = ["Indentation", "IndentationSolution"]


@value
class Indentation:
    """A body pressed into another one.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium) or PlaneFoundation(plane_profile, medium).
    load : Force, Depth or Radius
        What is prescribed; its value may be an array, the answers then have its shape.

    References
    ----------
    I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57, doi:10.1016/0020-7225(65)90019-4

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(Elastic(210e9, 0.3)))
    >>> contact = Indentation(bed, Force(100.0)).solve()
    >>> round(contact.radius * 1e6, 4)  # (3 F R / (4 E*))^(1/3) in micrometres
    148.1204
    """

    bed: Bed
    load: Load

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "galin_1946", "sneddon_1965", "popov_2013")

    def solve(self) -> IndentationSolution:
        """Return depth, force and contact radius.

        Returns
        -------
        IndentationSolution

        Raises
        ------
        OutsideValidity
            If the load is tensile, leads beyond the reach of the profile, or opens a contact that is no disc; the
            message names the indices of an array.
        """
        match self.load:
            case Depth(depth):
                given, asked = depth, "depth"
            case Force(force):
                given, asked = force, "force"
            case Radius(radius):
                given, asked = radius, "radius"
            case _:
                raise InvalidInput(
                    f"Indentation: the load is a {type(self.load).__name__}; give Force, Depth or Radius."
                )
        target = np.atleast_1d(np.asarray(given, dtype=float))
        flat = target.ravel()
        if asked == "radius":
            depth_, radius_ = _at_radius(self.bed, flat)
        elif asked == "depth":
            depth_, radius_ = _at_depth(self.bed, flat)
        else:
            depth_, radius_ = _at_force(self.bed, flat)
        load = flat if asked == "force" else self.bed.stiffness(radius_) * depth_ - self.bed.gap_load(radius_)
        if asked == "depth":
            load = np.where(radius_ > 0.0, load, 0.0)

        def shaped(answer: Array) -> Quantity:
            return float(answer[0]) if np.ndim(given) == 0 else answer.reshape(np.shape(given))

        return IndentationSolution(self, shaped(depth_), shaped(load), shaped(radius_))


@value
class IndentationSolution:
    """The answer to an `Indentation`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : Indentation
        What was asked.
    depth : float or ndarray
        d [m].
    force : float or ndarray
        F_N [N], compression positive.
    radius : float or ndarray
        a [m], zero where there is no contact.
    """

    problem: Indentation
    depth: Quantity
    force: Quantity
    radius: Quantity

    @property
    def stiffness(self) -> Quantity:
        """dF/dd = k(a) [N/m]."""
        return self._shaped(self.problem.bed.stiffness(np.asarray(self.radius)))

    @property
    def mean_pressure(self) -> Quantity:
        """F / (pi a^2) [Pa]; zero without contact."""
        area = np.pi * np.asarray(self.radius) ** 2
        return self._shaped(np.where(area > 0.0, self.force / np.where(area > 0.0, area, 1.0), 0.0))

    @property
    def energy(self) -> Quantity:
        """Elastic energy U [J], the work that was needed to press the bodies together."""
        bed = self.problem.bed
        depth, radius = np.ravel(self.depth), np.ravel(self.radius)
        edges = [b for b, _ in bed.kinks]
        work = [
            float(abel.integral(lambda x, d=d: bed.normal_stiffness(x) * (d - bed.gap(x)) ** 2, edges, np.array(a)))
            for d, a in zip(depth, radius, strict=True)
        ]
        return self._shaped(np.reshape(work, np.shape(self.depth)))

    def line_load(self, x: Array) -> Array:
        """Load of the springs per length.

        Parameters
        ----------
        x : ndarray
            Places on the line [m], either side of the axis.

        Returns
        -------
        ndarray
            q(x) = c_N(x) (d - g(x)) [N/m], zero outside the contact.
        """
        pressed = self.pressed
        x = np.abs(np.asarray(x, dtype=float))
        inside = x <= pressed.radius
        bed = self.problem.bed
        place = np.where(inside, x, 0.0)
        return np.where(inside, bed.normal_stiffness(place) * pressed.value(place), 0.0)

    @property
    def pressed(self) -> Pressed:
        """The displacement of the springs, from which the fields are restored; of one load, not of an array."""
        if np.ndim(self.depth) != 0:
            raise InvalidInput(
                f"This solution holds {np.size(self.depth)} loads; pick one with solution.at(index) before asking for "
                "its line load or fields."
            )
        return Pressed(self.problem.bed, float(self.depth), float(self.radius))

    def at(self, index: int | tuple[int, ...]) -> IndentationSolution:
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
        try:
            depth, force, radius = (
                float(np.asarray(answer)[index]) for answer in (self.depth, self.force, self.radius)
            )
        except (IndexError, TypeError):
            raise InvalidInput(
                f"solution.at: there is no load {index!r} in an answer of shape {np.shape(self.depth)}."
            ) from None
        load: Load
        match self.problem.load:
            case Depth():
                load = Depth(depth)
            case Force():
                load = Force(force)
            case _:
                load = Radius(radius)
        return IndentationSolution(Indentation(self.problem.bed, load), depth, force, radius)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes, size of the body, onset of yield."""
        return indentation_notes(self.problem.bed, np.ravel(self.depth), np.ravel(self.force), np.ravel(self.radius))

    def _shaped(self, answer: Array) -> Quantity:
        return float(answer) if np.ndim(self.depth) == 0 else answer


def _end(bed: Bed) -> float:
    return min(bed.reach, bed.rim)


def _flat(bed: Bed) -> float:
    """Return the radius up to which g vanishes: the contact opens with it."""
    places = [b for b, _ in bed.kinks if b < _end(bed)]
    if not places:
        return 0.0
    touching = [b for b, g in zip(places, bed.gap(np.array(places)), strict=True) if g == 0.0]
    return max(touching, default=0.0)


def _at_end(bed: Bed) -> tuple[float, float]:
    """Return depth and force when the contact fills the profile; infinite if it never does."""
    end = _end(bed)
    if not np.isfinite(end):
        return np.inf, np.inf
    place = np.array([end])
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = float(bed.gap(place)[0])
        if not np.isfinite(depth):
            return np.inf, np.inf
        return depth, float((bed.stiffness(place) * depth - bed.gap_load(place))[0])


def _indices(bad: Array) -> str:
    places = np.flatnonzero(bad)
    if bad.size == 1:
        return ""
    return f" at index {', '.join(map(str, places[:5]))}" + (" and more" if places.size > 5 else "")


def _refuse_beyond(bed: Bed, bad: Array, given: Array, word: str, unit: str, most: float) -> None:
    if bad.any():
        raise OutsideValidity(
            f"{word} {given[bad][0]:.6g} {unit}{_indices(bad)} leads beyond the reach of the profile ({bed.reach:.6g} "
            f"m), where nothing is known of it; at most {most:.6g} {unit} can be answered."
        )


def _at_radius(bed: Bed, radius: Array) -> tuple[Array, Array]:
    end = _end(bed)
    depth_end, _ = _at_end(bed)
    bad = radius > end if np.isfinite(depth_end) else radius >= end
    if bad.any():
        wall = "the rim of the body" if bed.rim <= bed.reach else "the reach of the profile"
        raise OutsideValidity(
            f"radius {radius[bad][0]:.6g} m{_indices(bad)} is beyond {wall} ({end:.6g} m); give a smaller one."
        )
    flat = _flat(bed) if depth_end > 0.0 else end
    bad = (radius > 0.0) & (radius <= flat)
    if bad.any():
        raise OutsideValidity(
            f"radius {radius[bad][0]:.6g} m{_indices(bad)} does not tell the load: the body is flat up to {flat:.6g} m "
            "and touches there at once; give a force or a depth."
        )
    depth = bed.gap(radius)
    if not bed.rising:
        for d, a in zip(depth, radius, strict=True):
            disc.refuse_unless_disc(bed, float(d), float(a), end)
    return depth, radius.copy()


def _at_depth(bed: Bed, depth: Array) -> tuple[Array, Array]:
    depth_end, _ = _at_end(bed)
    pinned = depth > depth_end if bed.rim <= bed.reach else np.zeros(depth.shape, dtype=bool)
    _refuse_beyond(bed, (depth > depth_end) & ~pinned, depth, "depth", "m", depth_end)
    radius = np.where(pinned, _end(bed), 0.0)
    free = (depth > 0.0) & ~pinned
    if free.any():
        if bed.rising:
            radius[free] = invert(
                lambda a: (bed.gap(a), bed.gap_slope(a)),
                depth[free],
                lower=_flat(bed),
                upper=_end(bed),
                guess=_guess(bed),
            )
        else:
            radius[free] = [disc.radius_at_depth(bed, float(d), _end(bed), _guess(bed)) for d in depth[free]]
    return depth.copy(), radius


def _at_force(bed: Bed, force: Array) -> tuple[Array, Array]:
    tensile = force < 0.0
    if tensile.any():
        raise OutsideValidity(
            f"force {force[tensile][0]:.6g} N{_indices(tensile)} is tensile; without adhesion bodies can only be "
            "pressed together: give a force of zero or more."
        )
    depth_end, force_end = _at_end(bed)
    pinned = force > force_end if bed.rim <= bed.reach else np.zeros(force.shape, dtype=bool)
    _refuse_beyond(bed, (force > force_end) & ~pinned, force, "force", "N", force_end)
    radius = np.where(pinned, _end(bed), 0.0)
    free = (force > 0.0) & ~pinned

    def force_and_slope(a: Array) -> tuple[Array, Array]:
        stiffness = bed.stiffness(a)
        return stiffness * bed.gap(a) - bed.gap_load(a), stiffness * bed.gap_slope(a)

    if free.any():
        if bed.rising:
            radius[free] = invert(
                force_and_slope, force[free], lower=_flat(bed), upper=_end(bed), guess=_guess(bed)
            )
        else:
            radius[free] = [disc.radius_at_force(bed, float(load), _end(bed), _guess(bed)) for load in force[free]]
    depth = bed.gap(radius)
    if pinned.any():
        rim = np.array([_end(bed)])
        depth[pinned] = depth_end + (force[pinned] - force_end) / bed.stiffness(rim)[0]
    return depth, radius


def _guess(bed: Bed) -> float:
    """Return a radius of the order of the body's lengths, where the search begins."""
    flat, end = _flat(bed), _end(bed)
    if np.isfinite(end):
        return 0.5 * (flat + end)
    if flat > 0.0:
        return 2.0 * flat
    if np.isfinite(bed.size):
        return 0.1 * bed.size
    return min((b for b, _ in bed.kinks), default=1e-3)
