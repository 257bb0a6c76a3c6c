r"""Where the hardness limits the pressure of a height map: how many pixels, and the area F / H that follows.

If nearly all pixels in contact bear the hardness H, the area is :math:`A = F/H`, whatever the surface and the moduli
(Bowden and Tabor).  What flows needs a place to go: measured areas follow :math:`A/A_0 = W/(1+W)` with
:math:`W = F/(HA_0)` (Pullen and Williamson), so that cut pressures give 1 + W times too much.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing, standing_of

__all__ = ["hardened_share", "hardness_notes"]

PULLEN = "J. Pullen, J. B. P. Williamson, Proc. R. Soc. A 327 (1972) 159-173"
TABOR = "F. P. Bowden, D. Tabor, Proc. R. Soc. A 169 (1939) 391-413"
AT_HARDNESS = 1.0 - 1e-9
"""Part of the hardness from which a pixel bears it."""
NEARLY_ALL, HARDLY_ANY = 0.9, 0.1
FLAT_SHARE = 0.9
"""Of the root mean square height that is left without a paraboloid: less, and the map is a curved body."""
LIGHT_LOAD, HEAVY_LOAD = 0.01, 0.3
"""Force over hardness times the area of the map."""


def hardened_share(pressure: Array, hardness: float) -> float:
    """Return which part of the pixels in contact bears the hardness."""
    touching = int(np.count_nonzero(pressure > 0.0))
    return float(np.count_nonzero(pressure >= AT_HARDNESS * hardness)) / touching if touching else 0.0


def hardness_notes(
    rough: Topography, hardness: float, force: Quantity, area: Quantity, hardened: Quantity
) -> tuple[Note, ...]:
    """Return what the hardness means for the contact; nothing of elastic bodies.

    Parameters
    ----------
    rough
        The map; of one that is curved nothing is said about where the metal goes, which is beside it.
    hardness
        [Pa].
    force, area, hardened
        Of every load [N], [m^2], [-].
    """
    if math.isinf(hardness):
        return ()
    last = int(np.argmax(np.ravel(np.asarray(force))))
    share = float(np.ravel(np.asarray(hardened))[last])
    greatest = float(np.ravel(np.asarray(force))[last])
    mean = greatest / float(np.ravel(np.asarray(area))[last]) / hardness
    if share >= NEARLY_ALL:
        regime = "the plastic limit A = F / H, in which the moduli hardly count"
    elif share <= HARDLY_ANY:
        regime = "elastic for the most part"
    else:
        regime = "between the elastic contact and the plastic limit A = F / H"
    limit = Note(
        Assumption.ELASTIC,
        Standing.APPROXIMATE,
        f"Under the greatest force {share:.0%} of the pixels in contact bear the hardness, and the mean pressure is "
        f"{mean:.0%} of it: {regime}.",
        TABOR,
    )
    if not rough.periodic and rough.detrended(2).rms_height < FLAT_SHARE * rough.rms_height:
        return (limit,)
    heavy = greatest / (hardness * rough.area)
    return (
        limit,
        Note(
            Assumption.ELASTIC,
            standing_of(heavy, LIGHT_LOAD, HEAVY_LOAD),
            f"The force is {heavy:.2g} of hardness times the area of the map. The metal that flows has to go "
            f"somewhere, which makes measured areas smaller than cut pressures do: by about {heavy:.2g} for plastic "
            "contacts.",
            PULLEN,
        ),
    )
