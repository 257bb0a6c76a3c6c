"""Arrays of other libraries than numpy, by the Python array API: the same code computes on a graphics card.

The functions of `numpy` that the height maps need are those of the standard; `array-api-compat` gives those of other
libraries the same names.  scipy transforms numpy's arrays on all cores, other libraries transform their own.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from types import ModuleType
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput


def namespace_of(numbers: Any) -> Any:
    """Return the functions of the library that an array belongs to.

    Raises
    ------
    InvalidInput
        If it is not numpy's, and array-api-compat is not installed.
    """
    return np if isinstance(numbers, np.ndarray) else _compat().array_namespace(numbers)


def library_of(arrays: ModuleType) -> Any:
    """Return the functions of a library, numpy, cupy or torch for instance, by the names of the array API.

    Raises
    ------
    InvalidInput
        If it is not numpy, and array-api-compat is not installed.
    """
    return np if arrays is np else namespace_of(arrays.asarray([0.0]))


def _compat() -> Any:
    try:
        import array_api_compat
    except ImportError:
        raise InvalidInput(
            'arrays of another library than numpy need array-api-compat: pip install "winkler[cards]".'
        ) from None
    return array_api_compat


def to_numpy(numbers: Any) -> Array:
    """Return an array of any library as one of numpy, without a copy where none is needed."""
    if isinstance(numbers, np.ndarray):
        return numbers
    here = numbers if "cpu" in str(numbers.device).lower() else _compat().to_device(numbers, "cpu")
    return here if isinstance(here, np.ndarray) else np.from_dlpack(here)


def given(numbers: Any) -> bool:
    """Return whether there is anything in an array; in the place of one that is optional stands an empty tuple."""
    return not isinstance(numbers, tuple) and math.prod(numbers.shape) > 0


def cast(numbers: Any, digits: Any) -> Any:
    """Return numbers in other digits, themselves if they have them."""
    if isinstance(numbers, np.ndarray):
        return numbers.astype(digits, copy=False)
    xp = namespace_of(numbers)
    return xp.astype(numbers, getattr(xp, digits.name) if isinstance(digits, np.dtype) else digits, copy=False)


def dot(one: Any, other: Any) -> float:
    """Return the sum of the products of two arrays of one shape; of complex numbers, of both of their parts."""
    if isinstance(one, np.ndarray):
        return float(np.vdot(one, other).real)
    xp = namespace_of(one)
    return complex(xp.vecdot(xp.reshape(one, (-1,)), xp.reshape(other, (-1,)))).real


def real_waves(numbers: Any, padded: Sequence[int], workers: int) -> Any:
    """Return the transform over the last two axes, padded with zeros; rows of zeros alone are not transformed."""
    if isinstance(numbers, np.ndarray):
        import scipy.fft

        rows = scipy.fft.rfft(numbers, padded[1], axis=-1, workers=workers)
        return scipy.fft.fft(rows, padded[0], axis=-2, workers=workers, overwrite_x=True)
    xp = namespace_of(numbers)
    return xp.fft.fft(xp.fft.rfft(numbers, n=padded[1], axis=-1), n=padded[0], axis=-2)


def waves_back(waves: Any, padded: Sequence[int], shape: Sequence[int], workers: int) -> Any:
    """Return the numbers of this shape, of those that have this transform, which is overwritten."""
    if isinstance(waves, np.ndarray):
        import scipy.fft

        back = scipy.fft.ifft(waves, axis=-2, overwrite_x=True, workers=workers)[..., : shape[0], :]
        return scipy.fft.irfft(back, padded[1], axis=-1, workers=workers)[..., : shape[1]]
    xp = namespace_of(waves)
    back = xp.fft.ifft(waves, axis=-2)[..., : shape[0], :]
    return xp.fft.irfft(back, n=padded[1], axis=-1)[..., : shape[1]]
