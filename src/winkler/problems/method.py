"""How a contact that slips is followed, where more than one way leads there."""

from __future__ import annotations

from enum import StrEnum

__all__ = ["Method"]


class Method(StrEnum):
    """How stick and slip are followed: the most exact way unless one is named."""

    AUTO = "auto"
    """Rings where the medium knows its own shear kernel, springs by gap where they are exact, else springs."""
    EXACT = "exact"
    """Springs of one gap as one: exact where tangential and normal stiffness have one ratio."""
    RINGS = "rings"
    """Rings that bear their own pressure times the coefficient, with the kernels of layers and gradings."""
    SPRINGS = "springs"
    """Springs one by one: any law, any medium, paths in the plane; layers within the stated error only."""
