r"""Whether pressure and traction act on each other: Dundurs' second constant against the coefficient of friction.

Bodies that are elastically dissimilar (:math:`\beta\ne0`) are drawn along the surface by the pressure itself.  While
they are pressed together, friction resists that: what sticks and what slips then depends on :math:`\beta/\mu`, and full
sticking makes a flat punch stiffer by :math:`\mathrm{artanh}(\beta)/\beta` (Mossakovskii, Spence).  While they slide,
the traction changes the pressure by terms of the order :math:`\beta\mu`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.materials.elastic import Elastic, Rigid, Solid
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.halfspace import HalfSpace
from winkler.media.medium import Medium
from winkler.media.offers import LayerStack, PlaneMedium, PowerOfDepth, offers
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.values.validity import Assumption, Note, Standing, standing_of

NEGLIGIBLE_COUPLING = 1e-12
"""Dundurs' constant [-] that is rounding."""
SMALL_COUPLING, LARGE_COUPLING = 0.1, 1.0
"""beta/mu, or beta mu, up to which the theory without coupling is the limit, and from which on it is none."""
VERDICTS = {
    Standing.ASYMPTOTIC: "The shear tractions use up only a small part of the friction",
    Standing.APPROXIMATE: "The boundaries of stick and slip zones have errors of the order of beta/mu",
    Standing.OUTSIDE: (
        "The shear tractions use up the friction over most of the contact before the bodies are sheared"
    ),
}
FLOWING_MODULUS_RATIO = 1e-6
"""Of the glassy modulus, what stands for that of a solid that flows."""
SPENCE = (
    "D. A. Spence, J. Elast. 5 (1975) 297-319, doi:10.1007/BF00126993; K. L. Johnson, Contact Mechanics, Cambridge "
    "1985, sec. 5.4, doi:10.1017/CBO9781139171731"
)
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 7.1, doi:10.1017/CBO9781139171731"


def mismatch(medium: Medium) -> float:
    """Return Dundurs' second constant beta [-] of the two surfaces; nan where the medium has none.

    Of viscoelastic bodies the greater of its values right after a step and after all time; of layers and gradings that
    of the solid at the surface and the other body.
    """
    if isinstance(medium, RelaxingInProportion):
        medium = medium.medium
    if isinstance(medium, HalfSpace):
        return medium.mismatch
    if offers(medium, PowerOfDepth):
        return float(getattr(medium, "mismatch", math.nan))
    if offers(medium, PlaneMedium):
        surfaces = medium.response.first.top, medium.second
        return dundurs(*surfaces) if all(isinstance(body, Solid) for body in surfaces) else math.nan  # type: ignore[arg-type]
    if isinstance(medium, ViscoelasticHalfSpace):
        pairs = ([_elastic(body, early) for body in (medium.first, medium.second)] for early in (True, False))
        return max((dundurs(*pair) for pair in pairs), key=abs)
    return math.nan


def dundurs(first: Solid, second: Solid) -> float:
    """Return Dundurs' second constant beta [-] of two bodies, not both rigid."""
    elastic = [body for body in (first, second) if isinstance(body, Elastic)]
    return HalfSpace(first, second).mismatch if elastic else 0.0


def _elastic(body: ViscoelasticSolid | Solid, early: bool) -> Solid:
    """Return a body as it is right after a step, or after all time; one that flows is almost without stiffness."""
    if not isinstance(body, ViscoelasticSolid):
        return body
    series = body.series
    if early and not math.isfinite(series.glassy):
        return Rigid()  # a dashpot alongside
    glassy = series.relaxed + float(np.sum(series.moduli)) or series.viscosity
    shear = glassy if early else max(series.relaxed, FLOWING_MODULUS_RATIO * glassy)
    return Elastic(2.0 * (1.0 + body.poisson) * shear, body.poisson)


def coefficient_of(law: object) -> float:
    """Return the coefficient of friction that holds before anything slips [-]; nan for a law of one's own."""
    match law:
        case Coulomb(coefficient):
            return coefficient
        case StaticKinetic(static):
            return static
        case _:
            return math.nan


def stuck_stiffening(beta: float) -> float:
    """Return by which part a flat punch that sticks is stiffer than one without friction [-].

    Parameters
    ----------
    beta : float
        Dundurs' second constant [-], between -1/2 and 1/2.

    Examples
    --------
    A rigid punch on a body with Poisson's ratio 0: ln(3 - 4 nu) (1 - nu)/(1 - 2 nu) - 1.

    >>> round(stuck_stiffening(0.5), 4)
    0.0986
    """
    return math.atanh(beta) / beta - 1.0 if abs(beta) > 1e-4 else beta * beta / 3.0


def sticking_note(medium: Medium, coefficient: float) -> Note:
    """Return whether what sticks and slips may be computed as if pressing drew nothing along the surface.

    Parameters
    ----------
    medium : Medium
    coefficient : float
        Coefficient of friction mu [-]; infinity where nothing slips, nan if the law has none.
    """
    beta = mismatch(medium)
    note = _without_number(medium, beta, coefficient)
    if note is not None:
        return note
    ratio = abs(beta) / coefficient
    stiffer = 100.0 * stuck_stiffening(beta)
    fact = (
        f"The bodies are elastically dissimilar: Dundurs' beta is {beta:.3g}, {ratio:.3g} of the coefficient of "
        "friction. Normal loading alone causes shear tractions, which are neglected. Full stick makes the "
        f"contact {stiffer:.2g} % stiffer. The pressure is affected more: in an incremental solution the depth "
        "differed by 2 % and the peak pressure by 23 to 30 %"
    )
    standing = standing_of(ratio, SMALL_COUPLING, LARGE_COUPLING)
    return Note(Assumption.UNCOUPLED, standing, f"{fact}. {VERDICTS[standing]}.", SPENCE)


def solved_together_note(medium: Medium, coefficient: float, error: str) -> Note:
    """Return the note where pressures and tractions of dissimilar bodies are found together.

    Parameters
    ----------
    medium : Medium
    coefficient : float
        Coefficient of friction mu [-].
    error : str
        What remains inexact, a sentence.
    """
    beta = mismatch(medium)
    if not isinstance(medium, HalfSpace) or abs(beta) <= NEGLIGIBLE_COUPLING:
        return sticking_note(medium, coefficient)
    return Note(
        Assumption.UNCOUPLED,
        Standing.ASYMPTOTIC,
        f"The bodies are elastically dissimilar (Dundurs' beta = {beta:.3g}). Pressures displace the surface "
        f"tangentially, and tractions displace it normally; both effects are included. {error}",
        SPENCE,
    )


def sliding_note(medium: Medium, coefficient: float) -> Note:
    """Return whether the pressure may be computed as if there were no traction of sliding; parameters as above."""
    beta = mismatch(medium)
    note = _without_number(medium, beta, coefficient)
    if note is not None:
        return note
    product = abs(beta) * coefficient
    return Note(
        Assumption.UNCOUPLED,
        standing_of(product, SMALL_COUPLING, LARGE_COUPLING),
        f"The bodies are elastically dissimilar (Dundurs' beta = {beta:.3g}). Sliding changes the pressure by "
        f"terms of the order of beta times the coefficient of friction, {product:.2g}. These terms are neglected.",
        JOHNSON,
    )


def _without_number(medium: Medium, beta: float, coefficient: float) -> Note | None:
    """Return the note where there is nothing to compare; None where beta and the coefficient are numbers."""
    if coefficient == 0.0:
        return Note(Assumption.UNCOUPLED, Standing.EXACT, "There is no friction.", "the problem")
    if abs(beta) < NEGLIGIBLE_COUPLING:
        below = ""
        if offers(medium, PlaneMedium):
            below = f", as far as the {'outermost layer' if offers(medium, LayerStack) else 'surface itself'} goes"
        return Note(
            Assumption.UNCOUPLED,
            Standing.ASYMPTOTIC if offers(medium, PlaneMedium) else Standing.EXACT,
            "The surfaces are elastically similar (Dundurs' beta = 0): pressure causes no tangential "
            f"displacement, and traction no normal displacement{below}.",
            SPENCE,
        )
    if math.isnan(beta) or math.isnan(coefficient):
        what = (
            f"{type(medium).__name__} has no Dundurs' constant"
            if math.isnan(beta)
            else f"Dundurs' beta is {beta:.3g}, and this law of friction has no coefficient to compare it with"
        )
        return Note(
            Assumption.UNCOUPLED,
            Standing.APPROXIMATE,
            f"{what}. Coupling of pressure and traction is neglected; the error is not known.",
            SPENCE,
        )
    return None
