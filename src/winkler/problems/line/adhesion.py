r"""A line contact that sticks: attraction without range, at the edges of the strip (JKR for lines), or with one.

.. math:: P(a) = E^* w(a) - \sqrt{2\pi a E^*\gamma} , \qquad p(x) = p_w(x) - \sqrt{\frac{2E^*\gamma a}{\pi(a^2-x^2)}} ,

the pressure of the profile less that of a flat punch that is pulled.  For a cylinder :math:`E^* w = \pi E^* a^2/(4R)`,
and under a dead load the strip comes apart at

.. math:: a_c = \Big(\frac{2R^2\gamma}{\pi E^*}\Big)^{1/3} , \qquad
          P_c = -\tfrac34\,\big(4\pi E^*\gamma^2R\big)^{1/3} .

On layers E* is that of the uppermost one, w the load profile of the bed, and the edges of a pulled flat punch are s
times as steep as on half-planes: :math:`P(a) = E^*w(a) - \sqrt{2\pi aE^*\gamma}/s(a)`.
"""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.adhesion import Dugdale
from winkler.loading.loads import HalfWidth, LineForce
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.adhesion.branches_beyond import branches_beyond
from winkler.problems.adhesion.edge_states import margin
from winkler.problems.adhesion.stability import Branch
from winkler.problems.adhesion.widest_contact import widest
from winkler.problems.assumptions.declared import ADHESIVE
from winkler.problems.line.adhesion_notes import adhesion_notes
from winkler.problems.line.cohesive import CohesiveLineStates
from winkler.problems.line.equilibria import FIXED_GRIPS, LineLaw, line_states
from winkler.problems.line.half_width import refuse_beyond
from winkler.problems.line.layered_strip import OnLayers
from winkler.problems.line.pressing_load import OfWidth
from winkler.problems.line.stress import Strip
from winkler.problems.line.strip import OfStrip
from winkler.problems.one_load import one_of, single
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class LineAdhesion(PerLoad[Q]):
    """Adhesive contact of a cylinder, wedge or other two-dimensional body with a half-plane or layers, in plane strain.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies, homogeneous or layered.
    law : ShortRange or Dugdale
        Law of attraction between the surfaces; with hysteresis, the work of opening is used.
    load : LineForce or HalfWidth
        A force per length is a dead load; the value may be an array, the results then have its shape.

    References
    ----------
    M. Barquins, J. Adhesion 26 (1988) 1-12, doi:10.1080/00218468808071271;
    M. K. Chaudhury, T. Weaver, C. Y. Hui, E. J. Kramer, J. Appl. Phys. 80 (1996) 30-37, doi:10.1063/1.362819;
    J. M. Baney, C.-Y. Hui, J. Adhes. Sci. Technol. 11 (1997) 393-406, doi:10.1163/156856197X00778

    Examples
    --------
    A rubber roller of 5 mm radius that touches a plate under no load.

    >>> from winkler.laws.adhesion import ShortRange
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = LineFoundation(Paraboloid(5e-3), HalfSpace.between(Elastic(1e6, 0.5)))
    >>> contact = LineAdhesion(bed, ShortRange(0.05), LineForce(0.0)).solve()
    >>> round(contact.half_width * 1e6, 3)  # (32 R^2 gamma / (pi E*))^(1/3) in micrometres
    212.157
    >>> round(contact.pull_off_force_per_length, 4)  # N/m
    -4.454
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        load=("", None, "what is prescribed: a force per length or a half-width"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    law: LineLaw
    load: LineForce[Q] | HalfWidth[Q]

    references: ClassVar[tuple[str, ...]] = ("barquins_1988", "chaudhury_1996", "baney_hui_1997")
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE

    def solve(self) -> LineAdhesionSolution[Q]:
        """Return force per length, half-width, and whether the state is stable under a dead load.

        If several half-widths are stable, the largest is returned; it remains after strong pressing.

        Raises
        ------
        OutsideValidity
            If a load is below the pull-off force (the message names it) or beyond the reach of the profile. If the
            profile is too sharp or too wavy for a stable contact.
        """
        states = line_states(self.bed, self.law)
        given = self.load.half_width if isinstance(self.load, HalfWidth) else self.load.force_per_length
        flat = np.atleast_1d(np.asarray(given, dtype=float)).ravel()
        stable = np.ones(flat.shape, dtype=bool)
        if isinstance(self.load, HalfWidth):
            refuse_beyond(self.bed, flat)
            force, half_width, stable = states.depth(flat), flat.copy(), _is_stable(self, flat)
        else:
            force = flat
            half_width = widest(states, FIXED_GRIPS, flat, "force per length", "N/m", "half-width")
        shape = np.shape(given)
        held = stable.reshape(shape) if shape else bool(stable[0])
        kind = LayeredLineAdhesionSolution if isinstance(self.bed, LayeredLineFoundation) else LineAdhesionSolution
        return kind(self, shaped(force, shape), shaped(half_width, shape), held)


def _is_stable(problem: LineAdhesion, half_width: Array) -> Array:
    states, rim = line_states(problem.bed, problem.law), problem.bed.rim
    stable = half_width == rim
    inner = (half_width > 0.0) & (half_width < rim)
    if inner.any():
        stable[inner] = margin(states, FIXED_GRIPS, half_width[inner]) >= 0.0
    return np.asarray(stable)


@value
class LineAdhesionSolution(OfStrip, OfWidth[Q]):
    """The solution of a `LineAdhesion`; force, half-width and what follows from them have the shape of the load.

    Parameters
    ----------
    problem : LineAdhesion
        The problem that was solved.
    force_per_length : float or ndarray
        P [N/m], compression positive.
    half_width : float or ndarray
        a [m].
    stable : bool or ndarray
        Whether the state is stable under a dead load.
    """

    __words__ = words(
        edge_load=("Q", "N/m", "load per length at the edges in addition to that of the profile, negative in tension"),
    )

    problem: LineAdhesion[Q]
    force_per_length: Q
    half_width: Q
    stable: bool | Array

    per_load: ClassVar[str] = "half_width"

    @property
    def edge_load(self) -> Q:
        """Load per length of the edges beyond that of the profile [N/m], negative if they are in tension: P - E* w(a),
        with w of the foundation.
        """
        return shaped(self.problem.bed.medium.modulus * self._edge_lengths(), np.shape(self.half_width))

    @property
    def stress_intensity(self) -> Q:
        """K_I [Pa m^(1/2)] of the tension at the edges: sqrt(2 E* gamma) for free edges, less at a rim.

        Zero under a law with a range.

        Raises
        ------
        OutsideValidity
            On bodies graded by a power of the depth, whose edge tension has another singularity.
        """
        if isinstance(self.problem.bed, PowerLawLineFoundation):
            raise OutsideValidity(
                "LineAdhesionSolution: on a GradedHalfSpace the tension at the edges grows like the power (k - 1)/2 of "
                "the distance, which no stress intensity states; use energy_release_rate or edge_load."
            )
        if isinstance(self.problem.law, Dugdale):
            return shaped(np.zeros(np.shape(self.half_width)))
        return self._intensity

    @property
    def _intensity(self) -> Q:
        """K_I of half-planes that release the same energy [Pa m^(1/2)]."""
        a, bed = np.ravel(self.half_width), self.problem.bed
        pull = np.maximum(-bed.medium.modulus * bed.edge_share(a) * self._edge_lengths(), 0.0)
        return shaped(pull / np.sqrt(np.pi * np.where(a > 0.0, a, np.inf)), np.shape(self.half_width))

    @property
    def energy_release_rate(self) -> Q:
        """G = K_I^2 / (2 E*) [J/m^2]: the work of adhesion where the edges are free."""
        if isinstance(self.problem.law, Dugdale):
            return shaped(np.full(np.shape(self.half_width), self.problem.law.work))
        return shaped(np.asarray(self._intensity) ** 2 / (2.0 * self.problem.bed.medium.modulus))

    @property
    def outer_half_width(self) -> Q:
        """Half-width up to the end of the attraction [m]; without range it is the half-width of the contact."""
        if not isinstance(self.problem.law, Dugdale):
            return self.half_width
        zone = CohesiveLineStates(self.problem.bed, self.problem.law).zone(np.ravel(self.half_width))
        return shaped(zone.outer, np.shape(self.half_width))

    @property
    def pull_off_force_per_length(self) -> float:
        """The least force per length [N/m] under which a contact is stable."""
        return float(line_states(self.problem.bed, self.problem.law).depth(np.array([self.pull_off_half_width]))[0])

    @property
    def pull_off_half_width(self) -> float:
        """The half-width [m] at which the contact separates under a dead load."""
        states = line_states(self.problem.bed, self.problem.law)
        branches: tuple[Branch, ...] = branches_beyond(states, FIXED_GRIPS, 0.0)
        starts = np.array([branch.start for branch in branches])
        return float(starts[np.argmin(states.depth(starts))])

    def at(self, index: int | tuple[int, ...]) -> LineAdhesionSolution[float]:
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
        force, a, stable = one_of(index, self.force_per_length, self.half_width, self.stable)
        load = HalfWidth(a) if isinstance(self.problem.load, HalfWidth) else LineForce(force)
        kind: type[LineAdhesionSolution[Any]] = type(self)
        return kind(LineAdhesion(self.problem.bed, self.problem.law, load), force, a, bool(stable))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: range of the attraction, slopes, overlap, other stable states, yield."""
        problem = self.problem
        widest = int(np.argmax(self.half_width))
        shape = np.shape(self.half_width)
        one = self.at(tuple(map(int, np.unravel_index(widest, shape)))) if shape else self
        forces = np.ravel(self.force_per_length) if isinstance(problem.load, LineForce) else np.zeros(0)
        return adhesion_notes(one._bed, problem.bed, problem.law, one._strip("notes"), one.separation, forces)

    def _edge_lengths(self) -> Array:
        """Return what the edges bear over E* [m], without rounding where they are free."""
        bed, a = self.problem.bed, np.ravel(self.half_width).astype(float)
        if isinstance(self.problem.law, Dugdale):
            span = CohesiveLineStates(bed, self.problem.law).zone(a).span
            return np.asarray(bed.zone_load(a, span, self.problem.law.strength) - bed.load_profile(a))
        free = -np.sqrt(2.0 * np.pi * a * self.problem.law.work / bed.medium.modulus) / bed.edge_share(a)
        if not np.isfinite(bed.rim):
            return free
        held = np.ravel(self.force_per_length) / bed.medium.modulus - bed.load_profile(a)
        return np.where(a >= bed.rim, held, free)

    def _strip(self, requested: str) -> Strip:
        single(self.force_per_length, requested)
        ranged = isinstance(self.problem.law, Dugdale)
        return Strip(float(self.half_width), 0.0 if ranged else float(self._edge_lengths()[0]))

    @property
    def _bed(self) -> Any:
        bed, law = self.problem.bed, self.problem.law
        if not isinstance(law, Dugdale):
            return bed
        a, outer = float(self.half_width), float(np.asarray(self.outer_half_width))
        return bed.zoned(law.strength, a, outer)


@value
class LayeredLineAdhesionSolution(OnLayers[Q], LineAdhesionSolution[Q]):
    """The solution of a `LineAdhesion` on layers; every quantity has the shape of the load.

    On a rigid base it has a `depth`; `layer_stresses` compares the layers under an attraction with a range.
    """
