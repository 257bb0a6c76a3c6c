"""Arrays that are not numpy's, and give themselves away only through the array API: what a card's arrays are to us.

They hold numbers of numpy, but no function of numpy takes them, nor may an operator mix them with numpy's arrays.
"""

from __future__ import annotations

import operator
import types

import numpy as np


class Foreign:
    """An array."""

    __array_ufunc__ = None
    device = "card"

    def __init__(self, held):
        assert isinstance(held, (np.ndarray, np.generic))
        self.held = np.asarray(held)

    shape = property(lambda self: self.held.shape)
    dtype = property(lambda self: self.held.dtype)
    ndim = property(lambda self: self.held.ndim)

    def __array__(self, *_, **__):
        raise TypeError("an array of another library was given to numpy")

    def __array_namespace__(self, api_version=None):
        return FOREIGN

    def to_device(self, device, stream=None):
        assert device == "cpu"
        return self.held

    def __getitem__(self, key):
        return Foreign(self.held[opened(key)])

    def __setitem__(self, key, content):
        self.held[opened(key)] = opened(content)

    def __float__(self):
        return float(self.held)

    def __complex__(self):
        return complex(self.held)

    def __int__(self):
        return int(self.held)

    __index__ = __int__

    def __bool__(self):
        return bool(self.held)


def opened(content):
    """Return what is held, of arrays, and of arrays in a tuple or list."""
    if isinstance(content, (tuple, list)):
        return type(content)(opened(one) for one in content)
    assert not isinstance(content, np.ndarray), "an array of numpy among those of another library"
    return content.held if isinstance(content, Foreign) else content


def closed(content):
    """Return arrays of numpy as foreign ones."""
    if isinstance(content, tuple):
        return tuple(closed(one) for one in content)
    return Foreign(content) if isinstance(content, (np.ndarray, np.generic)) else content


def through(function):
    """Return a function of numpy for foreign arrays."""
    return lambda *given, **named: closed(function(*opened(given), **{key: opened(one) for key, one in named.items()}))


for word in ("add", "sub", "mul", "truediv", "pow", "and", "or", "lt", "le", "gt", "ge", "eq", "ne"):
    plain = through(getattr(operator, f"__{word}__"))
    setattr(Foreign, f"__{word}__", plain)
    setattr(Foreign, f"__r{word}__", lambda one, other, plain=plain: plain(other, one))


def in_place(change):
    """Return an operator that changes an array."""

    def changed(self, other):
        self.held = change(self.held, opened(other))
        return self

    return changed


for word in ("iadd", "isub", "imul", "itruediv"):
    setattr(Foreign, f"__{word}__", in_place(getattr(operator, f"__{word}__")))
Foreign.__neg__ = through(operator.neg)
Foreign.__invert__ = through(operator.invert)

STANDARD = (
    "abs", "all", "any", "clip", "concat", "count_nonzero", "max", "maximum", "mean", "min", "nonzero", "reshape",
    "sort", "sum", "vecdot", "where", "zeros_like",
)  # fmt: skip
"""Functions of the standard; those that are missing here, no code for cards may use."""


def on_card(function):
    """Return a function that makes an array, on the card."""

    def made(*given, device="card", **named):
        assert device == "card"
        return closed(function(*given, **named))

    return made


def asarray(content, *, dtype=None, device="card", copy=None):
    """Return an array of the card, also of numpy's numbers."""
    return Foreign(np.array(content.held if isinstance(content, Foreign) else content, dtype=dtype))


FOREIGN = types.SimpleNamespace(
    __name__="foreign",
    **{name: through(getattr(np, name)) for name in STANDARD},
    asarray=asarray,
    zeros=on_card(np.zeros),
    astype=lambda one, dtype, *, copy=True: Foreign(one.held.astype(dtype, copy=copy)),
    float32=np.dtype(np.float32),
    float64=np.dtype(np.float64),
    fft=types.SimpleNamespace(**{name: through(getattr(np.fft, name)) for name in ("rfft", "irfft", "fft", "ifft")}),
)
"""The library."""
