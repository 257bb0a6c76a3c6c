"""In which of two bodies depths lie, for fields that are known in one of them at a time."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput


def in_first_body(depth: Array, owner: str) -> bool:
    """Return whether depths [m] lie in the first body; otherwise in the second.

    The surface belongs to the body that the other depths lie in; alone, 0.0 is that of the first body, and -0.0 that of
    the second.

    Parameters
    ----------
    depth : ndarray
        Positive in the first body, negative in the second.
    owner : str
        Of the stresses, for the refusal.

    Raises
    ------
    InvalidInput
        If they lie in both bodies.
    """
    above = bool(np.any(depth < 0.0))
    if above and np.any(depth > 0.0):
        raise InvalidInput(f"{owner}: the depths z lie in both bodies; request one after the other.")
    on_second = depth.size > 0 and bool(np.all((depth == 0.0) & np.signbit(depth)))
    return not (above or on_second)
