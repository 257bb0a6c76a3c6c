r"""The surface of a half-space on a grid, by its displacements: the tractions that hold them, and back.

Minimising an energy over displacements takes the inverse of `SurfaceGrid`.  A periodic surface has it wave by wave,
:math:`p = \tfrac12 E^* |q| u`, its mean at rest.  A free one is laid on a torus of twice its lengths on which the
distance of two pixels of the map is that in the plane: where nothing bears beyond the map, displacements inside of it
are those of Love.  Here E* and the first pixel length are one.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.numerics.pixels.integrals import from_corners, love
from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.threads import cores
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

SINGLE_THREAD_PIXELS = 2**14
"""Pixels below which a second thread costs more than it brings."""
PERIODIC_COPIES, FREE_COPIES = 48, 100
"""Arrays of double digits of the size of the map that are alive at once at most while it is brought to rest; of a map
that stands alone most of them lie on the torus of twice its lengths."""


def attracted_bytes(shape: tuple[int, ...], periodic: bool) -> int:
    """Return the memory [byte] that an attracted map of this shape takes at most while it is solved."""
    return 8 * shape[0] * shape[1] * (PERIODIC_COPIES if periodic else FREE_COPIES)


class ElasticSurface(NamedTuple):
    """A surface and its stiffness, wave by wave.

    Parameters
    ----------
    shape
        (nx, ny) of the map.
    torus
        Pixels of the torus, those of the map if it is periodic.
    periodic
        Whether the map is repeated without end; its mean displacement is then zero.
    stiffness, compliance
        Of each wave; compliance of the mean of a periodic map is zero.
    single_stiffness, single_compliance
        The same in single digits, for steps.
    workers
        Threads.
    """

    shape: tuple[int, int]
    torus: tuple[int, int]
    periodic: bool
    stiffness: Array
    compliance: Array
    single_stiffness: Array
    single_compliance: Array
    workers: int

    @classmethod
    def of(
        cls, shape: tuple[int, int], aspect: float, *, periodic: bool, layers: SurfaceBelow | None = None
    ) -> ElasticSurface:
        """Return the surface of a map whose pixels are 1 by `aspect`, on layers if there are some.

        Raises
        ------
        OutsideValidity
            If a periodic map lies on layers that an even pressure compresses, or the pixels are too coarse for them.
        """
        return _made(shape, aspect, periodic, layers)

    @property
    def area(self) -> tuple[slice, slice]:
        """The part of the torus that is the map."""
        return slice(0, self.shape[0]), slice(0, self.shape[1])

    def bedded(self, springs: float) -> Array:
        """Return the compliance of each wave, in single digits, of a surface that stands on springs."""
        return np.asarray(1.0 / (self.single_stiffness + np.float32(springs)))

    def applied(self, factor: Array, numbers: Array) -> Array:
        """Return numbers on the torus with every wave times a factor."""
        import scipy.fft

        waves = scipy.fft.rfft2(numbers, workers=self.workers)
        waves *= factor
        return np.asarray(scipy.fft.irfft2(waves, s=self.torus, workers=self.workers, overwrite_x=True))

    def tractions(self, displacement: Array) -> Array:
        """Return p over E* on the torus that holds displacements, in their digits."""
        single = displacement.dtype == np.float32
        return self.applied(self.single_stiffness if single else self.stiffness, displacement)

    def displaced(self, traction: Array) -> Array:
        """Return displacements on the torus under tractions over E*."""
        single = traction.dtype == np.float32
        return self.applied(self.single_compliance if single else self.compliance, traction)


@functools.lru_cache(maxsize=4)
def _made(shape: tuple[int, int], aspect: float, periodic: bool, layers: SurfaceBelow | None) -> ElasticSurface:
    import scipy.fft

    if layers and periodic and layers.mean > 0.0:
        raise OutsideValidity(
            "an even pressure compresses layers on a rigid base, which attracted periodic maps do not follow; give a "
            "map that stands alone, or an elastic base"
        )

    if periodic:
        torus = shape
        qx = 2.0 * np.pi * scipy.fft.fftfreq(shape[0])[:, None]
        qy = 2.0 * np.pi * scipy.fft.rfftfreq(shape[1], aspect)[None, :]
        wave = np.hypot(qx, qy)
        stiffness = 0.5 * wave
        if layers:
            wave[0, 0] = 1.0
            stiffness = stiffness / layers.whole(wave)
        compliance = np.divide(1.0, stiffness, out=np.zeros_like(stiffness), where=stiffness > 0.0)
    else:
        torus = 2 * scipy.fft.next_fast_len(shape[0], True), 2 * scipy.fft.next_fast_len(shape[1], True)
        corner = torus[0] // 2 + 1, torus[1] // 2 + 1
        quarter = from_corners(love, corner, (1.0, aspect)) / np.pi
        quarter = quarter + layers.pixels(corner, (1.0, aspect)) if layers else quarter
        i, j = (np.minimum(np.arange(n), n - np.arange(n)) for n in torus)
        compliance = scipy.fft.rfft2(quarter[np.ix_(i, j)]).real
        if float(np.min(compliance)) <= 0.0:
            raise OutsideValidity("the pixels are too coarse for the layers below; use finer ones")
        stiffness = 1.0 / compliance
    workers = cores() if torus[0] * torus[1] > SINGLE_THREAD_PIXELS else 1
    single = stiffness.astype(np.float32), compliance.astype(np.float32)
    return ElasticSurface(shape, torus, periodic, stiffness, compliance, *single, workers)
