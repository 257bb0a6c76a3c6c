r"""Decorrelation of residuals: :math:`W(D S D^T + B b^2 B^T)W^T = 1`.

With the cosine transform D, the variances S of the noise and the amplitudes b of the disturbances B, a sum of squares
of the result is the generalised one.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.noise.estimate import NoiseEstimate
from winkler.fitting.noise.spectra import transformed
from winkler.numerics.types import Array


class Whitening(NamedTuple):
    """Scales of the cosine transform ``(n,)``, orthonormal directions ``(n, q)``, and their reductions ``(q,)``."""

    scale: Array
    directions: Array
    reductions: Array

    def of(self, columns: Array) -> Array:
        """Return decorrelated columns ``(n,)`` or ``(n, c)``, of unit variance where they are noise."""
        scaled = (transformed(columns).T * self.scale).T
        return np.asarray(scaled - self.directions @ (self.reductions * (self.directions.T @ scaled).T).T)


def whitening_of(noise: NoiseEstimate) -> Whitening:
    """Return the decorrelation of a noise with its disturbances."""
    scale = 1.0 / np.sqrt(noise.spectrum)
    columns = (transformed(noise.courses).T * scale).T * noise.amplitudes
    directions, lengths, _ = np.linalg.svd(columns, full_matrices=False)
    return Whitening(scale, directions, 1.0 - 1.0 / np.sqrt(1.0 + lengths**2))
