"""A height map that has worn, at one distance slid: what is written down, and from where its march goes on."""

from __future__ import annotations

from winkler.numerics.types import Array
from winkler.values.value import value, words

__all__ = ["STATE_WORDS", "SurfaceWearState"]

STATE_WORDS = words(
    depth=("d", "m", "approach since the highest point touched, wear included"),
    peak_pressure=(r"p_\mathrm{max}", "Pa", "greatest pressure of a pixel"),
    rms_height=("Sq", "m", "root mean square of the heights about their mean"),
    skewness=("Ssk", "", "mean cube of the heights over that of their root mean square"),
    kurtosis=("Sku", "", "mean fourth power of the heights over that of their root mean square"),
    worn_depth=(r"h_\mathrm{max}", "m", "greatest worn depth"),
    worn_volume=("V", "m^3", "what the map has lost"),
    imbalance=(r"\epsilon_V", "", "difference of the worn volume and rate times force times distance, over the latter"),
    misfit=("", "", "pressure times gap that is left, over force times depth"),
)


@value
class SurfaceWearState:
    """A height map that has worn, at one distance slid.

    Parameters
    ----------
    elapsed : float
        Distance slid s [m].
    jump : float
        How far the next step of the march would go [m].
    depth : float
        d [m] since the highest point of the unworn map touched, elastic approach and wear together.
    force : float
        F_N [N]; of a periodic map on one period.
    area, area_error : float
        Of the contact, and the error that the grid leaves [m^2].
    peak_pressure : float
        Greatest pressure of a pixel [Pa].
    mean_gap : float
        Mean distance of the surfaces over the map [m].
    rms_height, skewness, kurtosis : float
        Sq [m], Ssk and Sku [-] of the worn map, with only its mean taken off; zero of a flat one.
    worn_depth : float
        Greatest worn depth [m].
    worn_volume : float
        V [m^3].
    load_distance : float
        Integral of the force over the distance [N m].
    imbalance : float
        Difference of V and rate times `load_distance`, over the latter; zero before sliding.
    penetration, misfit : float
        As in `winkler.problems.rough.surface_states.SurfaceState`, of the last contact that was solved.
    worn : ndarray, (nx, ny)
        What every pixel has lost [m].
    pressure : ndarray, (nx, ny)
        p [Pa].
    separation : ndarray, (nx, ny)
        Distance of the surfaces [m].
    """

    __words__ = words(
        **STATE_WORDS,
        elapsed=("s", "m", "distance slid"),
        jump=(r"\Delta s", "m", "how far the next step would go"),
        worn=("h", "m", "what the map has lost"),
    )

    elapsed: float
    jump: float
    depth: float
    force: float
    area: float
    area_error: float
    peak_pressure: float
    mean_gap: float
    rms_height: float
    skewness: float
    kurtosis: float
    worn_depth: float
    worn_volume: float
    load_distance: float
    imbalance: float
    penetration: float
    misfit: float
    worn: Array
    pressure: Array
    separation: Array
