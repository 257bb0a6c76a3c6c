r"""Waves across their direction, in the plane of the surface (SH waves): how a layer, and a stack, is crossed.

With the impedance :math:`Z=\sqrt{C_{44}C_{66}}` of a solid and :math:`x=\xi z\sqrt{C_{66}/C_{44}}`, displacement times
:math:`\xi` and traction follow from :math:`V'=Q/Z,\ Q'=ZV`.  A half-space has the compliance :math:`V/Q=1/Z`.  A layer
makes of the compliance Y below it

.. math:: Y^\uparrow = \frac1Z\,\frac{ZY+\tanh x}{1+ZY\tanh x} ,

a quotient of sums of positive terms: nothing cancels in layers thin or thick, hard or soft.  So are the states at
depth, written with :math:`e^{-x}` alone.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.materials.elastic import Rigid
from winkler.media.layered.climb import AnyLayer
from winkler.media.layered.faces import LEAST_WAVE
from winkler.media.layered.wave_constants import Body, constants_of
from winkler.numerics.types import Array, ComplexArray

SMALL = 0.05
"""Wave number times thickness below which 1 - tanh(x)/x is summed as a series."""


class AcrossState(NamedTuple):
    """At one depth per traction of 1: displacement times xi, over the compliance of the solid, and traction."""

    moved: Array
    loaded: Array


def across_above(below: ComplexArray, stiff: Array | float, fall: ComplexArray) -> ComplexArray:
    """Return the compliance at the upper face of a layer [1/Pa].

    Parameters
    ----------
    below : ndarray
        That of what it lies on [1/Pa].
    stiff : ndarray or float
        Impedance of its solid [Pa].
    fall : ndarray
        tanh x of its thickness.
    """
    own = below * stiff
    return (own + fall) / ((1.0 + own * fall) * stiff)


def climbed_across(layers: tuple[AnyLayer, ...], on: Body, xi: ComplexArray) -> list[ComplexArray]:
    """Return the compliances [1/Pa] at the surface of a stack and at the lower face of each layer, from the top.

    Parameters
    ----------
    layers : tuple of Layer or StackLayer
        From the top; what slides bears no shear below it.
    on : Elastic, TransverselyIsotropic or Rigid
        What carries them.
    xi : ndarray, (m,)
        Wave numbers [1/m].
    """
    if not all(layer.bonded for layer in layers):
        xi = np.where(xi == 0.0, LEAST_WAVE, xi)
    rungs = [np.full(xi.shape, 0.0 if isinstance(on, Rigid) else 1.0 / constants_of(on).impedance[0], dtype=xi.dtype)]
    for layer in reversed(layers):
        stiff, steep = constants_of(layer.solid).impedance
        fall = np.tanh(xi * (layer.thickness * steep))
        rungs.append(across_above(rungs[-1], stiff, fall) if layer.bonded else 1.0 / (stiff * fall))
    return rungs[::-1]


def across_inside(own: Array, x: Array, start: Array) -> AcrossState:
    """Return the state in a layer per traction of 1 on its upper face.

    Parameters
    ----------
    own : ndarray
        Compliance of what it lies on, times its impedance.
    x, start : ndarray
        Of its thickness, and of the depth of the place below its upper face.
    """
    back, fall = np.exp(-2.0 * (x - start)), -np.expm1(-2.0 * (x - start))
    share = np.exp(-start) / _whole(own, x)
    return AcrossState((own * (1.0 + back) + fall) * share, (1.0 + back + own * fall) * share)


def across_added(own: Array, x: Array, start: Array) -> AcrossState:
    """Return by how much that state is more than that of a half-space of the same solid."""
    share = (own - 1.0) * np.exp(-start) / _whole(own, x)
    back = np.exp(-2.0 * (x - start))
    return AcrossState(back * (1.0 + np.exp(-2.0 * start)) * share, back * np.expm1(-2.0 * start) * share)


def _whole(own: Array, x: Array) -> Array:
    """Return 2 (cosh x + own sinh x) exp(-x)."""
    return np.asarray(1.0 + np.exp(-2.0 * x) - own * np.expm1(-2.0 * x))


def less_than_one(x: ComplexArray) -> ComplexArray:
    """Return 1 - tanh(x)/x, by a series of small x."""
    square, small = x * x, np.abs(x) < SMALL
    series = square * (1 / 3 - square * (2 / 15 - square * (17 / 315 - square * (62 / 2835 - square * 1382 / 155925))))
    safe = np.where(small, 1.0, x)
    return np.where(small, series, 1.0 - np.tanh(safe) / safe)
