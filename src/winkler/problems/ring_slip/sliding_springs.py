"""How the springs slide of a contact that is pressed and pushed at the same time: alike, or as rings of a coating."""

from __future__ import annotations

import math

from winkler.foundation.bed import Bed
from winkler.problems.method import Method
from winkler.problems.normal.stiffness_ratio import alike, common_ratio, stiffness_ratios
from winkler.problems.ring_slip.push_bound import layers_of_rings
from winkler.problems.ring_slip.ring_table import RingTable, ring_table

ONE_RATIO = (
    "under a changing normal load slip is followed where that ratio is the same everywhere, on homogeneous and "
    "power-law media, and on bonded layers and gradings in depth under a body of revolution: give such a bed{remedy}"
)


def sliding_springs(
    owner: str, bed: Bed, coefficient: float, radius: float, method: Method = Method.AUTO
) -> tuple[float, RingTable | None]:
    """Return c_T / c_N if all springs up to a radius [m] have one, or one and the rings of a coating.

    Parameters
    ----------
    owner : str
        Kind of problem, for messages.
    bed : Bed
    coefficient : float
        mu [-]; if it is infinite rings are known on each medium of which k_x is.
    radius : float
        Of the widest contact [m].
    method : Method, optional
        EXACT for one ratio alone, RINGS for rings alone.

    Raises
    ------
    OutsideValidity
        If the springs are neither alike nor rings of a coating, or the tangential stiffness is not known.
    """
    if method is Method.EXACT:
        other = f"give the method {Method.RINGS}" if layers_of_rings(bed) is not None else "give another medium"
        return common_ratio(owner, bed, radius, f"the method {method} needs one ratio: {other}"), None
    if method is not Method.RINGS and alike(stiffness_ratios(bed, radius)):
        return common_ratio(owner, bed, radius, ""), None
    if math.isinf(coefficient) or layers_of_rings(bed) is not None:
        return 1.0, ring_table(owner, bed, coefficient, radius)
    remedy = ", Coulomb(inf) if nothing slides"
    if owner == "Impact":
        remedy += ", or a lateral and angular velocity of zero"
    return common_ratio(owner, bed, radius, ONE_RATIO.format(remedy=remedy)), None
