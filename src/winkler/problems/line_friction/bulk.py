r"""A bulk stress beside a line contact that slips in part (Nowell and Hills).

The bulk stress strains the surface of the first body by :math:`\varepsilon = (1-\nu_1^2)\sigma_B/E_1` against that of
the second.  Where the surfaces stick the traction undoes that: it is :math:`\mu` times the pressure less that of a
contact under the load :math:`\gamma` whose profile is tilted by :math:`\alpha=\varepsilon/\mu`.  A tilted cylinder
is one that is shifted, by

.. math:: e = \alpha R = \lambda\,\frac{P-\gamma}{E^*} , \qquad
          \lambda = R\,\frac{\sigma_B}Q\,\frac{E^*(1-\nu_1^2)}{E_1} ,

for similar bodies :math:`e = \sigma_B a/(4\mu p_0)`.  All of that holds while each earlier contact lies within the
next: beyond it an edge slips against the shear force.  From the first moment on it does not if
:math:`|\lambda|\,\mathrm dP\le E^*\,\mathrm da`, for similar bodies :math:`|\sigma_B|\le 4|Q|/(\pi a)`.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_friction.strips import EarlierStrip
from winkler.profiles.power import Paraboloid
from winkler.validity import Assumption, Note, Standing

__all__ = ["bulk_note", "lean_of", "refuse_bulk", "refuse_faint", "refuse_unless_nested"]

NOWELL_HILLS = "D. Nowell, D. A. Hills, Int. J. Mech. Sci. 29 (1987) 355-365, doi:10.1016/0020-7403(87)90117-2"
ROUNDING = 1e-12


def refuse_bulk(bed: LineFoundation, path: LinePath) -> None:
    """Refuse what a bulk stress may not go with.

    Raises
    ------
    InvalidInput
        If the profile is no `Paraboloid`, the first body is rigid, or the normal force changes while there is shear.
    """
    if path.bulk_stress == 0.0:
        return
    if not isinstance(bed.profile, Paraboloid):
        raise InvalidInput(
            f"LineTangential: the profile is a {type(bed.profile).__name__}; the effect of a bulk stress is known "
            "for a cylinder: give a Paraboloid, or no bulk stress."
        )
    if not isinstance(_strained(bed), Elastic):
        raise InvalidInput(
            "LineTangential: the first body is rigid and bears no bulk stress; give the elastic body first."
        )
    forces, shears = path.across, path.along
    first = max(int(np.flatnonzero(shears)[0]) - 1, 0)
    if np.any(forces[first:] != forces[first]):
        raise InvalidInput(
            "LineTangential: the normal force changes after the first shear; beside a bulk stress it must stay: give "
            "one force per length, or no bulk stress."
        )


def refuse_faint(path: LinePath, most: float) -> None:
    """Refuse a bulk stress beside a shear force that is lost in what friction bears at most [N/m]: both edges slip.

    Raises
    ------
    OutsideValidity
    """
    greatest = float(np.max(np.abs(path.along)))
    if path.bulk_stress != 0.0 and greatest <= ROUNDING * most:
        raise OutsideValidity(
            f"LineTangential: beside a shear force of {greatest:.6g} N/m, where friction bears {most:.6g} N/m, the "
            f"bulk stress of {path.bulk_stress:.6g} Pa makes an edge slip back; give a greater shear force, or no bulk "
            "stress."
        )


def lean_of(bed: LineFoundation, path: LinePath) -> float:
    """Return lambda, the shift of an earlier contact over the load per length over E* that it lacks [-]."""
    body = _strained(bed)
    if path.bulk_stress == 0.0 or not isinstance(bed.profile, Paraboloid) or not isinstance(body, Elastic):
        return 0.0
    strain = bed.medium.modulus * (1.0 - body.poisson**2) / body.young
    return bed.profile.curvature_radius * path.bulk_per_shear * strain


def refuse_unless_nested(index: int, strips: tuple[EarlierStrip, ...], shear: float, bulk: float) -> None:
    """Refuse earlier contacts that reach beyond the next one: an edge of them slips against the shear force."""
    a = strips[-1].half_width
    for inner, outer in zip(strips, strips[1:], strict=False):
        if abs(inner.middle - outer.middle) > outer.half_width - inner.half_width + ROUNDING * a:
            raise OutsideValidity(
                f"LineTangential: at index {index} of the path the bulk stress of {bulk:.6g} Pa would shift what "
                f"sticks beyond an edge, which slips back instead; beside a shear force of {shear:.6g} N/m give at "
                f"most {abs(bulk) * _most(strips[-1], inner, outer):.6g} Pa."
            )


def _most(contact: EarlierStrip, inner: EarlierStrip, outer: EarlierStrip) -> float:
    """Return by which factor a bulk stress must be smaller for no edge ever to slip back."""
    lean = abs((inner.middle - outer.middle) / (outer.load - inner.load))
    return 0.5 * contact.half_width / (lean * contact.load)


def bulk_note(lean: float, half_width: float, load: float) -> Note:
    """Return whether the bulk stress makes an edge slip back at first.

    Parameters
    ----------
    lean : float
        Of `lean_of` [-].
    half_width, load : float
        a [m], P/E* [m].
    """
    share = abs(lean) * load / (0.5 * half_width)
    if share <= 1.0 + ROUNDING:
        text = (
            "The bulk stress shifts what sticks, which stays inside of the contact; it is "
            f"{share:.3g} of the one at which an edge begins to slip against the shear force."
        )
        return Note(Assumption.SLIP, Standing.EXACT, text, NOWELL_HILLS)
    text = (
        f"The bulk stress is {share:.3g} of the one at which an edge slips against the shear force while both are "
        "small; what sticks at the points of the path lies inside of the contact, but keeps a trace of that slip, "
        "which is left out (of a thousandth of the slip at 1.13, against boundary elements)."
    )
    return Note(Assumption.SLIP, Standing.APPROXIMATE, text, NOWELL_HILLS)


def _strained(bed: LineFoundation) -> object:
    return bed.medium.first if isinstance(bed.medium, HalfSpace) else None
