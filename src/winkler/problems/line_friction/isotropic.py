"""On which bodies the slip of line contacts is known."""

from __future__ import annotations

from winkler.errors import InvalidInput
from winkler.foundation.line import LineFoundation
from winkler.media.halfspace import HalfSpace

__all__ = ["refuse_unless_isotropic"]


def refuse_unless_isotropic(owner: str, bed: LineFoundation) -> None:
    """Refuse bodies that deform along the surface in another manner than across it.

    Parameters
    ----------
    owner : str
        Name of the problem.
    bed : LineFoundation

    Raises
    ------
    InvalidInput
        If the medium is no `HalfSpace`.
    """
    if not isinstance(bed.medium, HalfSpace):
        raise InvalidInput(
            f"{owner}: the medium is a {type(bed.medium).__name__}; slip of line contacts is known on homogeneous, "
            "isotropic bodies only, which are as stiff along the surface as across it; another ratio of the two is not "
            "built in: give a HalfSpace."
        )
