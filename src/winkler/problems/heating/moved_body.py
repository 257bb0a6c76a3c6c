"""A body, plated or not, that moves past 1 W of heat: its temperature per watt, of a source and of a band."""

from __future__ import annotations

import functools

from winkler.materials.conducting_body import Plated, layers_of, parts_of, surface_of
from winkler.materials.conductor import ThermalConductor
from winkler.numerics.fields.band_source import BandSource
from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.fields.layer_echo import Stack
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.fields.stacked_band import StackedBand
from winkler.numerics.fields.stacked_source import StackedSource
from winkler.numerics.fields.thick_body import Source, ThickBand, ThickBody
from winkler.values.errors import OutsideValidity

HeatBody = ThermalConductor | Plated
"""A thick body of one conductor, or a plated one."""


def top(body: HeatBody) -> ThermalConductor:
    """Return the conductor at the surface of a body that conducts heat."""
    conductor = surface_of(body)
    assert isinstance(conductor, ThermalConductor)
    return conductor


def _numbers(body: HeatBody) -> tuple[float, float]:
    conductor = top(body)
    return conductor.conductivity, conductor.diffusivity


def _parts(body: HeatBody) -> list[ThermalConductor]:
    return [part for part in parts_of(body) if isinstance(part, ThermalConductor)]


def diffusivities(body: HeatBody) -> list[float]:
    """Return the diffusivities in a body [m^2/s]; the least has the highest Peclet number."""
    return [part.diffusivity for part in _parts(body)]


def _stack(body: HeatBody) -> Stack | None:
    """Return the layers of a body, from the surface down; None if all of it conducts alike."""
    parts = _parts(body)
    if len(set(parts)) == 1:
        return None
    conductivities, diffusivities = zip(*((part.conductivity, part.diffusivity) for part in parts), strict=True)
    return Stack(conductivities, diffusivities, tuple(thickness for _, thickness in layers_of(body)[0]))


@functools.lru_cache(maxsize=256)
def moved_body(source: Source, body: HeatBody, speed: float, direction: float) -> ThickBody | StackedSource:
    """Return a body that moves at `speed` [m/s] and at an angle `direction` [rad] to x past a source of 1 W.

    Raises
    ------
    OutsideValidity
        If the body is plated, and the source one of pixels.
    """
    stack = _stack(body)
    if stack is None:
        return ThickBody(source, *_numbers(body), speed, direction)
    if not isinstance(source, LineSource | EllipticSource):
        raise OutsideValidity(
            "FrictionHeating: plated conductors are not implemented for an ellipse on layers or graded bodies; "
            "give thick conductors, or a homogeneous medium."
        )
    return StackedSource(source, stack, speed, direction)


def warmed(source: Source, body: HeatBody, speed: float, direction: float) -> tuple[float, float]:
    """Return the greatest and the mean temperature [K/W] of a body that moves past a source of 1 W."""
    if isinstance(source, LineSource):  # alike to all sides
        speed, direction = abs(speed), 0.0
    moved = moved_body(source, body, speed, direction)
    return moved.peak.height, moved.mean


def moved_under_band(source: BandSource, body: HeatBody, speed: float) -> ThickBand | StackedBand:
    """Return a body that moves at `speed` [m/s] past a band of 1 W per length."""
    stack = _stack(body)
    return ThickBand(source, *_numbers(body), speed) if stack is None else StackedBand(source, stack, speed)
