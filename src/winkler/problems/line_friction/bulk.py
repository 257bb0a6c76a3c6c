r"""A bulk stress beside a line contact that slips in part: how far closed forms reach (Nowell and Hills).

The bulk stress strains the surface of the first body by :math:`\varepsilon = (1-\nu_1^2)\sigma_B/E_1` against that of
the second.  Where the surfaces stick the traction undoes that: it is :math:`\mu` times the pressure less that of a
contact under the load :math:`\gamma` whose profile is tilted by :math:`\alpha=\varepsilon/\mu`.  A tilted cylinder
is one that is shifted, by

.. math:: e = \alpha R = \lambda\,\frac{P-\gamma}{E^*} , \qquad
          \lambda = R\,\frac{\sigma_B}Q\,\frac{E^*(1-\nu_1^2)}{E_1} ,

for similar bodies :math:`e = \sigma_B a/(4\mu p_0)`.  All of that holds under a steady normal force and while each
earlier contact lies within the next: beyond it an edge slips against the shear force.  From the first moment on it does
not if :math:`|\lambda|\,\mathrm dP\le E^*\,\mathrm da`, for similar bodies :math:`|\sigma_B|\le 4|Q|/(\pi a)`.  Every
other path is marched along on boundary elements (`winkler.problems.line_friction.element_row`).
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.problems.line.half_width import under_force
from winkler.problems.line_friction.path import LinePath
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing

NOWELL_HILLS = "D. Nowell, D. A. Hills, Int. J. Mech. Sci. 29 (1987) 355-365, doi:10.1016/0020-7403(87)90117-2"
ROUNDING = 1e-12


def refuse_bulk(bed: LineBed, path: LinePath) -> None:
    """Refuse a bulk stress in a rigid body.

    Raises
    ------
    InvalidInput
    """
    if np.any(path.bulk_stress) and bed.strain_per_stress == 0.0:
        raise InvalidInput(
            "LineTangential: the first body is rigid and carries no bulk stress; give the elastic body first, or "
            "layers on an elastic one."
        )


def has_closed_form(bed: LineBed, path: LinePath) -> bool:
    """Return whether the strips of Nowell and Hills hold along all of a path, as they do without a bulk stress."""
    if not np.any(path.bulk_stress):
        return bed.sheared_as_pressed
    if not bed.hertzian or not path.in_phase:
        return False
    forces, shears = path.across, path.along
    first = max(int(np.flatnonzero(shears)[0]) - 1, 0)
    load = float(forces[first]) / bed.medium.modulus
    return not np.any(forces[first:] != forces[first]) and _share(bed, lean_of(bed, path), load) <= 1.0 + ROUNDING


def lean_of(bed: LineBed, path: LinePath) -> float:
    """Return lambda, the shift of an earlier contact over the load per length over E* that it lacks [-]."""
    if not np.any(path.bulk_stress) or not bed.hertzian:
        return 0.0
    return bed.hertz_radius * path.bulk_per_shear * bed.medium.along_modulus * bed.strain_per_stress


def _share(bed: LineBed, lean: float, load: float) -> float:
    """Return the bulk stress over the one at which an edge of a cylinder slips back, under a load over E* [m]."""
    return abs(lean) * load / (0.5 * float(under_force(bed, np.array([load]))[0])) if load > 0.0 else 0.0


def bulk_note(lean: float, half_width: float, load: float) -> Note:
    """Return how near the bulk stress is to the one at which an edge slips back.

    Parameters
    ----------
    lean : float
        Of `lean_of` [-].
    half_width, load : float
        a [m], P/E* [m].
    """
    share = abs(lean) * load / (0.5 * half_width)
    text = (
        "The bulk stress displaces the stick zone, which remains inside the contact. An edge begins to slip "
        f"against the shear force at a higher bulk stress; the present one is {share:.3g} of it."
    )
    return Note(Assumption.SLIP, Standing.EXACT, text, NOWELL_HILLS)
