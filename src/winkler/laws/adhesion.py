r"""Laws of adhesion: the work of adhesion and the range of the attraction.

Every law has the work of adhesion :math:`w`, the energy per area that parting takes.  They differ in how far the
attraction reaches: not at all (`ShortRange`, the limit of Johnson, Kendall and Roberts), with a constant stress
:math:`\sigma_0` up to the distance :math:`w/\sigma_0` (`Dugdale`, used by Maugis), or so far that it does not deform
the bodies (`DerjaguinMullerToporov`).
"""

from __future__ import annotations

from typing import Annotated

from winkler.values.checks.number_checks import NON_NEGATIVE, POSITIVE, Advice, Positive, checked
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

NOT_STATED = float("nan")
"""Marks a work of adhesion that was left out; recognised by identity, so that no other nan passes."""


NO_ATTRACTION_ADVICE = Advice("for bodies that do not attract each other use Indentation")


@value
class ShortRange:
    """Attraction of vanishing range: the edge of the contact is a crack tip (JKR).

    Give `work`, or both works if separation needs more energy than closing returns.

    Parameters
    ----------
    work : float
        Work of adhesion [J/m^2], positive; with hysteresis the same as `work_opening`.
    work_closing : float, optional
        What an advancing edge gains per area [J/m^2], zero or positive, not more than `work_opening`.
    work_opening : float, optional
        What a receding edge costs per area [J/m^2], positive.

    Raises
    ------
    InvalidInput
        If a work is negative, none or only one of a pair is given, or they contradict each other.

    References
    ----------
    K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301-313, doi:10.1098/rspa.1971.0141

    Examples
    --------
    >>> ShortRange(0.1) == ShortRange(work_closing=0.1, work_opening=0.1)
    True
    """

    work: float = NOT_STATED
    work_closing: float = NOT_STATED
    work_opening: float = NOT_STATED

    def __post_init__(self) -> None:
        opening = self.work if self.work_opening is NOT_STATED else self.work_opening
        whole = opening if self.work is NOT_STATED else self.work
        closing = self.work_closing
        if opening is NOT_STATED:
            raise InvalidInput(
                f"ShortRange: {'no work' if closing is NOT_STATED else 'work_closing alone'} was given; give work, or "
                "work_closing and work_opening."
            )
        if closing is NOT_STATED:
            closing = whole
        for name, number in (("work", whole), ("work_opening", opening)):
            checked(POSITIVE, "ShortRange", name, number, "J/m^2", NO_ATTRACTION_ADVICE.text)
        checked(NON_NEGATIVE, "ShortRange", "work_closing", closing, "J/m^2")
        if whole != opening:
            raise InvalidInput(
                f"ShortRange: work is {whole!r} J/m^2 but work_opening {opening!r}; work is that of "
                "opening: leave one of them out, or make them equal."
            )
        if closing > opening:
            raise InvalidInput(
                f"ShortRange: work_closing ({closing!r} J/m^2) exceeds work_opening ({opening!r}), so that every cycle "
                "would give energy away; closing returns at most the work of opening."
            )
        for word, number in (("work", opening), ("work_closing", closing), ("work_opening", opening)):
            object.__setattr__(self, word, float(number))


@value
class Dugdale:
    """Attraction by a constant stress up to a distance of work / strength (Maugis).

    Parameters
    ----------
    work : float
        Work of adhesion [J/m^2], positive.
    strength : float
        The stress sigma_0 that attracts the surfaces [Pa], positive.

    Raises
    ------
    InvalidInput
        If a number is not positive and finite.

    References
    ----------
    D. Maugis, J. Colloid Interface Sci. 150 (1992) 243-269, doi:10.1016/0021-9797(92)90285-T

    Examples
    --------
    >>> Dugdale(work=0.05, strength=100e6).range
    5e-10
    """

    __words__ = words(strength=(r"\sigma_0", "Pa", "stress with which the surfaces attract each other"))

    work: Annotated[Positive, NO_ATTRACTION_ADVICE]
    strength: Annotated[Positive, NO_ATTRACTION_ADVICE]

    @property
    def range(self) -> float:
        """The range of the attraction, work / strength [m]."""
        return self.work / self.strength


@value
class DerjaguinMullerToporov:
    """Attraction of long range that does not deform the bodies: it only adds to the force (DMT).

    Parameters
    ----------
    work : float
        Work of adhesion [J/m^2], positive.

    Raises
    ------
    InvalidInput
        If the work is not positive and finite.

    References
    ----------
    B. V. Derjaguin, V. M. Muller, Yu. P. Toporov, J. Colloid Interface Sci. 53 (1975) 314-326,
    doi:10.1016/0021-9797(75)90018-1
    """

    work: Annotated[Positive, NO_ATTRACTION_ADVICE]


AdhesionLaw = ShortRange | Dugdale | DerjaguinMullerToporov
"""What may attract the surfaces."""
