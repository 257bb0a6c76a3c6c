"""A contact that friction heats: temperatures of both surfaces and fluxes of heat, pixel by pixel."""

from __future__ import annotations

from winkler.numerics.types import Array
from winkler.problems.surface_friction.tangential import SurfaceTangentialSolution
from winkler.problems.surface_rolling.state import SurfaceRollingState
from winkler.values.value import value, words


@value
class SurfaceHeatState:
    """A contact that friction heats.

    Temperatures are above the level from which those of the bodies far away are counted.

    Parameters
    ----------
    heat_rate : float
        Q [W], the heat of friction per time.
    first_share : float
        Part of it that goes into the first body [-].
    exchanged_heat_rate : float
        What flows besides from the second body into the first because their bulk temperatures differ [W].
    max_temperature : float
        The greatest temperature within the contact [K].
    x, y : float
        Its place [m].
    mean_temperature : float
        Mean temperature over the contact [K].
    mismatch : float
        Greatest difference that is left between the two surfaces within the contact [K].
    grid_error : float
        Relative change of the greatest rise from pixels of twice the size [-].
    pressure : ndarray, (nx, ny)
        p [Pa]; where it is positive the bodies touch.
    flux, first_flux : ndarray, (nx, ny)
        Heat of friction, and what flows into the first body [W/m^2].
    first_temperature, second_temperature : ndarray, (nx, ny)
        Temperatures of both surfaces [K], within the contact and around it.
    rolled : SurfaceRollingState, optional
        The contact, where it rolls.
    march : SurfaceTangentialSolution, optional
        The path of the contact, where it frets.
    """

    __words__ = words(
        mean_temperature=(r"\bar T", "K", "mean temperature of the contact"),
        x=("x", "m", "place of the greatest temperature along the motion"),
        y=("y", "m", "place of the greatest temperature across the motion"),
        mismatch=("", "K", "greatest difference between the temperatures of the two surfaces in the contact"),
        grid_error=("", "", "change of the greatest rise of temperature from pixels of twice the size"),
        flux=("q", "W/m^2", "heat of friction per time and area"),
        first_flux=("q_1", "W/m^2", "heat into the first body per time and area"),
        first_temperature=("T_1", "K", "temperature of the first surface"),
        second_temperature=("T_2", "K", "temperature of the second surface"),
        rolled=("", None, "contact that rolls"),
        march=("", None, "path of a contact that frets"),
    )

    heat_rate: float
    first_share: float
    exchanged_heat_rate: float
    max_temperature: float
    x: float
    y: float
    mean_temperature: float
    mismatch: float
    grid_error: float
    pressure: Array
    flux: Array
    first_flux: Array
    first_temperature: Array
    second_temperature: Array
    rolled: SurfaceRollingState | None = None
    march: SurfaceTangentialSolution | None = None
