"""Punches with rounded edges, and paraboloids that were cut off or worn."""

from __future__ import annotations

from winkler.profiles.check import positive
from winkler.profiles.pieces import PowerPieces, Term
from winkler.values import value

__all__ = ["CappedParaboloid", "RoundedPunch", "TruncatedParaboloid"]


@value
class RoundedPunch(PowerPieces):
    """A flat punch with a rounded edge: f = 0 up to b, then (r - b)^2 / (2 R).

    Parameters
    ----------
    flat_radius : float
        b [m], positive.
    edge_radius : float
        R [m], of the rounding, positive.

    References
    ----------
    M. Ciavarella, D. A. Hills, G. Monno, Proc. Inst. Mech. Eng. C 212 (1998) 319-327, doi:10.1243/0954406981521231
    """

    flat_radius: float
    edge_radius: float

    def __post_init__(self) -> None:
        positive(self, "flat_radius")
        positive(self, "edge_radius")

    @property
    def terms(self) -> tuple[Term, ...]:
        """(r - b) / R beyond the flat."""
        b, big = self.flat_radius, self.edge_radius
        return ((b, 1, 1.0 / big), (b, 0, -b / big))

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The end of the flat, where the slope is continuous."""
        return ((self.flat_radius, 0.0),)


@value
class TruncatedParaboloid(PowerPieces):
    """A paraboloid with its tip cut off: f = 0 up to b, then (r^2 - b^2) / (2 R).

    Parameters
    ----------
    curvature_radius : float
        R [m], positive.
    flat_radius : float
        b [m], positive.
    """

    curvature_radius: float
    flat_radius: float

    def __post_init__(self) -> None:
        positive(self, "curvature_radius")
        positive(self, "flat_radius")

    @property
    def terms(self) -> tuple[Term, ...]:
        """r / R beyond the flat."""
        return ((self.flat_radius, 1, 1.0 / self.curvature_radius),)


@value
class CappedParaboloid(PowerPieces):
    """A paraboloid whose tip has another curvature: worn flatter, or ground sharper.

    Parameters
    ----------
    curvature_radius : float
        R [m], beyond the cap.
    cap_curvature_radius : float
        R1 [m], within the cap.
    cap_radius : float
        b [m], where the cap ends; the heights meet there, the slopes do not.
    """

    curvature_radius: float
    cap_curvature_radius: float
    cap_radius: float

    def __post_init__(self) -> None:
        positive(self, "curvature_radius")
        positive(self, "cap_curvature_radius")
        positive(self, "cap_radius")

    @property
    def terms(self) -> tuple[Term, ...]:
        """r / R1 within the cap, r / R beyond."""
        cap = 1.0 / self.cap_curvature_radius
        return ((0.0, 1, cap), (self.cap_radius, 1, 1.0 / self.curvature_radius - cap))
