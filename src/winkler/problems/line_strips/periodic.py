r"""Wavy half-planes: strips of contact side by side at one pitch, up to full contact.

For a wave :math:`h\,(1-\cos 2\pi x/\lambda)` under the nominal pressure :math:`\bar p = P/\lambda` (Westergaard 1939)

.. math:: \bar p = p^*\sin^2\frac{\pi a}\lambda , \qquad p^* = \frac{\pi E^*h}\lambda , \qquad
          p(x) = \frac{2\bar p\cos(\pi x/\lambda)}{\sin^2(\pi a/\lambda)}
                 \sqrt{\sin^2\frac{\pi a}\lambda-\sin^2\frac{\pi x}\lambda} ,

and beyond :math:`p^*` all is in contact, :math:`p = \bar p + p^*\cos(2\pi x/\lambda)`.  Other profiles that repeat are
solved by the same change of variable (`winkler.foundation.periodic`).  On layers the waves of the pitch alone are felt:
what the layers add is a sum over them.
"""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.foundation.periodic import PeriodicBed, as_high, from_line, to_line, unrolled
from winkler.loading.loads import HalfWidth, LineForce, NominalPressure
from winkler.numerics.types import Array, ArrayLike, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.half_width import borne_at_most, refuse_unless_strips, under_force
from winkler.problems.line.peak_pressure import peak_pressure, rim_load
from winkler.problems.line.pressing_load import OfWidth, given_by, pressing
from winkler.problems.line.stress import Strip
from winkler.problems.line.strip import Stressed
from winkler.problems.line_strips.periodic_notes import closing_load, periodic_notes
from winkler.problems.one_load import one_of, single
from winkler.values.checks.number_checks import Positive
from winkler.values.checks.place_checks import finite_places
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

ROUNDING = 2e-6
"""Part over u by which half-widths may exceed what is known of a profile with sharp valleys."""


@value
class PeriodicIndentation(PerLoad[Q]):
    """A wavy body, or one of many equal ridges, pressed on a half-plane or on layers, in plane strain.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        The profile from a crest, x = 0, to the valley at half of the pitch, and the bodies.
    pitch : float
        Distance of the crests [m], positive.
    load : NominalPressure, LineForce or HalfWidth
        The mean pressure over the whole surface, or the force per length or half-width of each strip. For an array the
        results have its shape.

    Raises
    ------
    InvalidInput
        If the profile is not known up to half of the pitch, has a rim, or is elsewhere as high as at x = 0.

    References
    ----------
    H. M. Westergaard, J. Appl. Mech. 6 (1939) A49-A53;
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 13.2, doi:10.1017/CBO9781139171731

    Examples
    --------
    Waves of 1 um amplitude and 1 mm length, pressed until half of the surface touches.

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.wavy import Wavy
    >>> steel = Elastic(210e9, 0.3)
    >>> bed = LineFoundation(Wavy(1e-6, 1e-3), HalfSpace.between(steel, steel))
    >>> half = PeriodicIndentation(bed, 1e-3, HalfWidth(0.25e-3)).solve()
    >>> round(half.nominal_pressure / half.closure_pressure, 12)
    0.5
    """

    __words__ = words(
        bed=("", None, "profile and bodies of each strip"),
        load=("", None, "what is prescribed: a nominal pressure, a force per length or a half-width"),
    )

    bed: LineFoundation | LayeredLineFoundation
    pitch: Positive
    load: NominalPressure[Q] | LineForce[Q] | HalfWidth[Q]

    references: ClassVar[tuple[str, ...]] = ("westergaard_1939", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        if min(self.bed.reach, self.bed.rim) < 0.5 * self.pitch:
            raise InvalidInput(
                f"PeriodicIndentation: the profile ends at {min(self.bed.reach, self.bed.rim):.6g} m, before the "
                f"valley at half of the pitch ({0.5 * self.pitch:.6g} m); give a smaller pitch, or a profile that is "
                "known up to the valley."
            )
        rival = as_high(self.bed.profile, self.pitch)
        if rival is not None:
            raise InvalidInput(
                f"PeriodicIndentation: the profile is as high at {rival:.6g} m as at the crest, x = 0; give the pitch "
                "of the crests that touch first, with the highest of them at x = 0."
            )

    @property
    def _line(self) -> LineBed:
        """The bed of a single strip over u."""
        return self.bed.repeated(unrolled(self.bed.profile, self.pitch), self.pitch)

    def solve(self) -> PeriodicSolution[Q]:
        """Return nominal pressure and half-width.

        Raises
        ------
        OutsideValidity
            If the load is tensile, or a half-width is beyond half of the pitch, or the bodies touch in more strips than
            crests.
        """
        line, modulus = self._line, self.bed.medium.modulus
        flat = pressing("PeriodicIndentation", self.load)
        closing = closing_load(PeriodicBed(line, self.pitch))
        if isinstance(self.load, HalfWidth):
            if np.any(flat > 0.5 * self.pitch):
                raise OutsideValidity(
                    f"half-width {float(np.max(flat)):.6g} m is more than half of the pitch ({0.5 * self.pitch:.6g} m),"
                    " at which all is in contact; give a smaller one, or a nominal pressure."
                )
            half_width, mapped = flat.copy(), to_line(flat, self.pitch)
            if np.any(mapped > (1.0 + ROUNDING) * line.reach):
                raise OutsideValidity(
                    f"half-width {float(np.max(flat)):.6g} m would press the valleys all but flat, which are sharp; "
                    f"give at most {float(from_line(np.array(line.reach), self.pitch)):.6g} m."
                )
            mapped = np.minimum(mapped, line.reach)
            force = modulus * line.load_profile(mapped)
            force = np.where(mapped >= line.rim, modulus * closing, force)
        else:
            force = flat * (self.pitch if isinstance(self.load, NominalPressure) else 1.0)
            most = np.inf if np.isfinite(line.rim) else borne_at_most(line)
            if np.any(force > modulus * most):
                raise OutsideValidity(
                    f"A nominal pressure of {float(np.max(force)) / self.pitch:.6g} Pa would press the valleys all but "
                    "flat, which are sharp and never close; give at most "
                    f"{modulus * most / self.pitch:.6g} Pa, or a profile with rounded valleys."
                )
            closed = force >= modulus * closing
            mapped = np.where(closed, line.rim, under_force(line, np.where(closed, 0.0, force / modulus)))
            if np.any(parted := ~closed & (mapped >= line.rim)):
                raise OutsideValidity(
                    f"Under a nominal pressure of {float(np.max(force[parted])) / self.pitch:.6g} Pa the bodies touch "
                    f"in more strips than crests; give at least {modulus * closing / self.pitch:.6g} Pa, at which all "
                    "is in contact, or a smoother profile."
                )
            half_width = from_line(mapped, self.pitch)
        refuse_unless_strips(line, mapped[mapped < line.rim], np.inf)
        shape = np.shape(given_by(self.load))
        return PeriodicSolution(self, shaped(force, shape), shaped(half_width, shape))


@value
class PeriodicSolution(Stressed, OfWidth[Q]):
    """The solution of a `PeriodicIndentation`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : PeriodicIndentation
        The problem that was solved.
    force_per_length : float or ndarray
        P [N/m] of each strip, compression positive.
    half_width : float or ndarray
        a [m] of each strip; half of the pitch at full contact.
    """

    __words__ = words(
        contact_share=("2a/\\lambda", "", "share of the surface that is in contact"),
    )

    problem: PeriodicIndentation[Q]
    force_per_length: Q
    half_width: Q

    per_load: ClassVar[str] = "half_width"

    @property
    def nominal_pressure(self) -> Q:
        """P / pitch [Pa]."""
        return shaped(np.asarray(self.force_per_length) / self.problem.pitch)

    @property
    def contact_share(self) -> Q:
        """2 a / pitch [-]."""
        return shaped(2.0 * np.asarray(self.half_width) / self.problem.pitch)

    @property
    def peak_pressure(self) -> Q:
        """The maximum pressure [Pa]; infinite at a sharp crest or kink, zero without contact."""
        strips = [self._strip_of(float(p), float(a)) for p, a in self._pairs()]
        return shaped(np.array([peak_pressure(self._bed, strip) for strip in strips]), np.shape(self.half_width))

    @property
    def closure_pressure(self) -> float:
        """Nominal pressure [Pa] at full contact; infinite if the valleys are sharp."""
        return float(self._bed.medium.modulus * closing_load(self._bed) / self.problem.pitch)

    def separation(self, x: ArrayLike) -> Array:
        """Return the distance of the deformed surfaces under one load [m], zero inside of the strips.

        Parameters
        ----------
        x : array_like
            Positions on the surface [m].

        Raises
        ------
        InvalidInput
            If the solution has more than one load.
        """
        a, _ = self._strip("separation")
        pitch, line = self.problem.pitch, self._bed.line
        x = finite_places("PeriodicSolution.separation", "x", x)
        if 2.0 * a >= pitch:
            return np.zeros(x.shape)
        u = to_line(np.abs(x - pitch * np.round(x / pitch)), pitch)
        return line.separation(u, float(to_line(np.array(a), pitch)), 0.0)

    def at(self, index: int | tuple[int, ...]) -> PeriodicSolution[float]:
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
        force, a = one_of(index, self.force_per_length, self.half_width)
        kind: type[Any] = type(self.problem.load)
        load = kind(float(np.asarray(given_by(self.problem.load))[index]))
        return PeriodicSolution(PeriodicIndentation(self.problem.bed, self.problem.pitch, load), force, a)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes, whether each crest has one strip, yield."""
        pairs = self._pairs()
        widest = max(pairs, key=lambda pair: pair[0])
        return periodic_notes(self._bed, self.problem.bed, self._strip_of(*widest))

    def _pairs(self) -> list[tuple[float, float]]:
        forces, widths = np.ravel(self.force_per_length), np.ravel(self.half_width)
        return [(float(p), float(a)) for p, a in zip(forces, widths, strict=True)]

    @property
    def _bed(self) -> PeriodicBed:
        return PeriodicBed(self.problem._line, self.problem.pitch)

    def _strip_of(self, force: float, half_width: float) -> Strip:
        line = self._bed.line
        closed = 2.0 * half_width >= self.problem.pitch
        return Strip(half_width, rim_load(line, force, line.rim) if closed else 0.0)

    def _strip(self, requested: str) -> Strip:
        return self._strip_of(single(self.force_per_length, requested), float(self.half_width))
