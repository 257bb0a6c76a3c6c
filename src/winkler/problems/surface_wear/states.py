"""A height map that has worn, at one distance slid or over many: what is written down, and whence its march goes on."""

from __future__ import annotations

from winkler.numerics.types import Array, PerLoad, Q
from winkler.values.value import value, words


@value
class MapWear(PerLoad[Q]):
    """A height map that has worn, at a distance slid or at many.

    Parameters
    ----------
    distance : float or ndarray, (steps,)
        Slid so far s [m].
    depth : float or ndarray, (steps,)
        d [m] since the highest point of the unworn map touched, elastic approach and wear together.
    force : float or ndarray, (steps,)
        F_N [N]; for a periodic map on one period.
    area, area_error : float or ndarray, (steps,)
        Of the contact, and the error that the grid leaves [m^2].
    peak_pressure : float or ndarray, (steps,)
        Greatest pressure of a pixel [Pa].
    mean_gap : float or ndarray, (steps,)
        Mean distance of the surfaces over the map [m].
    rms_height, skewness, kurtosis : float or ndarray, (steps,)
        Sq [m], Ssk and Sku [-] of the worn map, with only its mean taken off; zero of a flat one.
    worn_depth : float or ndarray, (steps,)
        Greatest worn depth [m].
    worn_volume : float or ndarray, (steps,)
        V [m^3].
    load_distance : float or ndarray, (steps,)
        Integral of the force over the distance [N m].
    imbalance : float or ndarray, (steps,)
        Difference of V and rate times `load_distance`, over the latter; zero before sliding.
    penetration, misfit : float or ndarray, (steps,)
        As in `winkler.problems.rough.surface_states.SurfaceState`, of the last contact that was solved.
    """

    __words__ = words(
        distance=("s", "m", "distance slid"),
        depth=("d", "m", "approach since the highest point touched, wear included"),
        peak_pressure=(r"p_\mathrm{max}", "Pa", "greatest pressure of a pixel"),
        rms_height=("Sq", "m", "root mean square of the heights about their mean"),
        skewness=("Ssk", "", "mean cube of the heights over that of their root mean square"),
        kurtosis=("Sku", "", "mean fourth power of the heights over that of their root mean square"),
        worn_depth=(r"h_\mathrm{max}", "m", "greatest worn depth"),
        worn_volume=("V", "m^3", "what the map has lost"),
        imbalance=(
            r"\epsilon_V", "", "difference of the worn volume and rate times force times distance, over the latter"
        ),
        misfit=("", "", "pressure times gap that is left, over force times depth"),
    )  # fmt: skip

    distance: Q
    depth: Q
    force: Q
    area: Q
    area_error: Q
    peak_pressure: Q
    mean_gap: Q
    rms_height: Q
    skewness: Q
    kurtosis: Q
    worn_depth: Q
    worn_volume: Q
    load_distance: Q
    imbalance: Q
    penetration: Q
    misfit: Q


@value
class SurfaceWearState(MapWear[float]):
    """A height map that has worn, at one distance slid; its numbers are those of `MapWear`.

    Parameters
    ----------
    jump : float
        How far the next step of the march would go [m].
    worn : ndarray, (nx, ny)
        What every pixel has lost [m].
    pressure : ndarray, (nx, ny)
        p [Pa].
    separation : ndarray, (nx, ny)
        Distance of the surfaces [m].
    """

    __words__ = words(
        jump=(r"\Delta s", "m", "how far the next step would go"),
        worn=("h", "m", "what the map has lost"),
    )

    jump: float
    worn: Array
    pressure: Array
    separation: Array
