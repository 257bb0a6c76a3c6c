r"""Contact depth, area, modulus and hardness of many peaks at once, and their standard uncertainties by source.

.. math:: h = h_m - C_f F, \quad \frac1S = \frac1{S_m} - C_f, \quad h_c = h - \epsilon\frac FS, \quad
          E_r = \frac{\sqrt\pi\,S}{2\beta\sqrt{A(h_c)}}, \quad H = \frac F{A(h_c)}, \quad
          \frac1{E_r} = \frac{1-\nu^2}E + \frac{1-\nu_i^2}{E_i} .

The uncertainty follows the GUM: each source moves the inputs, the outputs are differentiated, and the squares are
added.

References
----------
JCGM 100:2008, Evaluation of measurement data - Guide to the expression of uncertainty in measurement,
doi:10.59161/JCGM100-2008E
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

STEP = 1e-6


class Peaks(NamedTuple):
    """Force [N], depth [m], compliance [m/N] and epsilon [-] of n peaks; depth and compliance contain the frame."""

    force: Array
    depth: Array
    compliance: Array
    intercept: Array


class Readings(NamedTuple):
    """Contact depth [m], area [m^2], reduced modulus, modulus of the sample and hardness [Pa], ``(n,)`` each."""

    contact_depth: Array
    area: Array
    modulus: Array
    young: Array
    hardness: Array


def area_of(coefficients: Sequence[float] | Array, height: Array) -> Array:
    """Return A [m^2] of an area function at heights [m], which may be arrays."""
    positive = np.maximum(height, 0.0)
    return np.asarray(sum(c * positive ** (2.0 ** (1 - n)) for n, c in enumerate(coefficients)))


def readings_of(peaks: Peaks, numbers: Array, indenter: CalibratedIndenter, poisson: float) -> Readings:
    """Return the readings of peaks with the frame compliance and area coefficients `numbers` ``(1 + m,)``.

    Raises
    ------
    OutsideValidity
        If a contact depth, an area or a stiffness is not positive, or the sample is stiffer than the tip allows.
    """
    compliance = peaks.compliance - numbers[0]
    depth = peaks.depth - numbers[0] * peaks.force
    contact = depth - peaks.intercept * peaks.force * compliance
    area = area_of(numbers[1:], contact)
    for name, content, unit in (
        ("compliance of the contact", compliance, "m/N"),
        ("contact depth", contact, "m"),
        ("area at the contact depth", area, "m^2"),
    ):
        if not np.all(content > 0.0):
            raise OutsideValidity(
                f"nanoindentation: the {name} is {float(np.min(content)):.3g} {unit}; it must be positive: check frame "
                "compliance, contact point and area function."
            )
    modulus = 0.5 * np.sqrt(np.pi / area) / (indenter.shape_factor * compliance)
    tip = (1.0 - indenter.solid.poisson**2) / indenter.solid.young
    sample = 1.0 / modulus - tip
    if not np.all(sample > 0.0):
        raise OutsideValidity(
            f"nanoindentation: the reduced modulus {float(np.max(modulus)):.4g} Pa leaves nothing for the sample; "
            "check frame compliance and area function."
        )
    return Readings(contact, area, modulus, (1.0 - poisson**2) / sample, peaks.force / area)


def moved_by(
    peaks: Peaks,
    indenter: CalibratedIndenter,
    poisson: float,
    *,
    depth: Array | float = 0.0,
    compliance: Array | float = 0.0,
    intercept: Array | float = 0.0,
    force: Array | float = 0.0,
    numbers: Array | float = 0.0,
) -> Readings:
    """Return the change of the readings by one standard uncertainty of a source, which moves the inputs together."""
    base = indenter.numbers

    def at(sign: float) -> Readings:
        part = sign * STEP
        moved = Peaks(
            peaks.force + part * np.asarray(force),
            peaks.depth + part * np.asarray(depth),
            peaks.compliance + part * np.asarray(compliance),
            peaks.intercept + part * np.asarray(intercept),
        )
        return readings_of(moved, base + part * np.asarray(numbers), indenter, poisson)

    ahead, behind = at(1.0), at(-1.0)
    return Readings(*((one - other) / (2.0 * STEP) for one, other in zip(ahead, behind, strict=True)))


def factors_of(covariance: Array) -> Array:
    """Return L with L L^T = V of covariances ``(..., k, k)``: each column moves the inputs by one independent part."""
    spread = np.sqrt(np.maximum(np.diagonal(covariance, axis1=-2, axis2=-1), 0.0))
    unit = np.where(spread > 0.0, spread, 1.0)
    values, vectors = np.linalg.eigh(covariance / (unit[..., :, None] * unit[..., None, :]))
    return np.asarray(unit[..., :, None] * vectors * np.sqrt(np.maximum(values, 0.0))[..., None, :])
