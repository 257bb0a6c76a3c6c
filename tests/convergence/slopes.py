"""The order of a method, fitted to its errors."""

from __future__ import annotations

import numpy as np


def order(sizes, errors) -> float:
    """Return p of error ~ size^-p by least squares in logarithms."""
    sizes, errors = np.asarray(sizes, dtype=float), np.asarray(errors, dtype=float)
    assert np.all(errors > 0.0), "an error of zero has no order"
    return -float(np.polyfit(np.log(sizes), np.log(errors), 1)[0])
