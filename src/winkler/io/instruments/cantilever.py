"""From the deflection of a cantilever, in N, m or V, to its force."""

from __future__ import annotations

from winkler.io.instruments.instrument_test import measures
from winkler.values.errors import InvalidInput
from winkler.values.units import scale


def force_factor(
    unit: str, spring: float | None, sensitivity: float | None, origin: str, path: object
) -> tuple[float, tuple[str, ...]]:
    """Return what makes a force [N] of a deflection in N, m or V, and the facts that were used.

    Parameters
    ----------
    unit : str
        Of the deflection.
    spring, sensitivity : float, optional
        Spring constant [N/m] and deflection per volt [m/V], where they are known.
    origin : str
        Where the sensitivity comes from, for the facts.
    path
        The file, for messages.

    Raises
    ------
    InvalidInput
        If one of them is needed and not known.
    """
    if spring is None:
        raise InvalidInput(f"{path}: it states no spring constant, from which the depth follows; give spring_constant.")
    if measures(unit, "N"):
        return scale(unit, "N"), ()
    if measures(unit, "m"):
        return spring * scale(unit, "m"), ()
    if not measures(unit, "V") or sensitivity is None:
        raise InvalidInput(
            f"{path}: the deflection is in {unit} and no sensitivity is stated; give sensitivity in m/V, or export the "
            "curve with a calibrated deflection."
        )
    return spring * sensitivity * scale(unit, "V"), (f"sensitivity {sensitivity:g} m/V {origin}",)
