"""A curve of a file with its place on the sample, or the reason why it cannot be read."""

from __future__ import annotations

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.io.continuous_loading import StatedResults
from winkler.values import value

__all__ = ["PlacedCurve", "UnreadCurve"]


@value
class PlacedCurve:
    """A force curve, and where on the sample it was taken.

    Parameters
    ----------
    curve : ForceCurve
    x, y : float
        Place on the sample [m]; nan where the file does not state it.
    continuous : ContinuousStiffness, optional
        The stiffness that was measured during the loading; None where the file has no such column.
    stated : StatedResults, optional
        Modulus and hardness that the instrument computed itself; None where the file has no such column.
    """

    curve: ForceCurve
    x: float
    y: float
    continuous: ContinuousStiffness | None = None
    stated: StatedResults | None = None


@value
class UnreadCurve:
    """A curve that could not be read, and why.

    Parameters
    ----------
    name : str
        The file; within a map also the number of the curve.
    reason : str
        One sentence.
    """

    name: str
    reason: str
