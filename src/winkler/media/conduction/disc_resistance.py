r"""Two conducting bodies that meet in a disc: their resistance to a current or to heat.

The equations of conduction are those of a flat punch, :math:`E^* \to 2/(\rho_1+\rho_2)`: voltage for displacement,
current for force.  A disc of radius a between half-spaces has Holm's resistance :math:`(\rho_1+\rho_2)/(4a)`; a plating
is a layered medium with the response, where several lie on each other layer by layer from below,

.. math:: 1+M(\xi) = \frac{\rho_1 m_1+\rho_2 m_2}{\rho_1+\rho_2}, \qquad
          m = \frac{1+\kappa e^{-2\xi h}}{1-\kappa e^{-2\xi h}}, \quad
          \kappa = \frac{\rho_{on}-\rho}{\rho_{on}+\rho};

a rod constricts less (`winkler.numerics.fields.flux_tube`), and a film spreads the current
(`winkler.numerics.fields.filmed_disc`).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from winkler.materials.conducting_body import (
    ConductingBody,
    Plated,
    Rod,
    bulk_of,
    layers_of,
    parts_of,
    resistivity_of,
    surface_of,
)
from winkler.numerics.fields.filmed_disc import spreading
from winkler.numerics.fields.flux_tube import LARGEST_RADIUS_RATIO, relief
from winkler.numerics.integrals.quadrature import panel_nodes
from winkler.numerics.transforms import fredholm
from winkler.numerics.transforms.kernel_matrix import kernel_matrix
from winkler.numerics.transforms.punch_tables import punch_at
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

HOLM = "R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1"
BARBER = (
    "J. R. Barber, Bounds on the electrical resistance between contacting elastic rough bodies, Proc. R. Soc. A 459 "
    "(2003) 53-66, doi:10.1098/rspa.2002.1038"
)
OWN_SOLUTION = "own solution of the integral equation along the line of springs"
PLATED = (
    "The platings are layers bonded without resistance. Between different platings the voltage (or temperature) varies "
    "across the spot. The stated value is the mean weighted with the current (or heat flux)."
)
RODS_ALIKE = "The sides of both rods are insulated, and the contact is a disc of uniform voltage"
RODS = (
    "Each body is computed with a uniform voltage over the contact. If the voltages differ, the sum is too low by less "
    "than 8 % of the constriction resistance; for narrow contacts the error vanishes"
)
FILM_ADDED = (
    "The resistance of the film is added to the constriction resistance of a clean contact. The film also spreads the "
    "current, which adds up to 8 % of the constriction resistance."
)
SPREAD_BY_FILM = (
    "The constriction resistance includes the spreading of the current by the film: up to 8.1 % more than Holm's value."
)

NODES = 16
"""On each panel of the line on which the shares of both bodies are found."""
PLACES, PLACES_PER_FOLD = 8, 8
"""Radii at which shares are found, and more for each factor of e between the radii."""


class Resistances(NamedTuple):
    """Parts of a resistance, in series [ohm or K/W]; infinite where the bodies do not touch."""

    first: Array
    """Constriction in the first body."""
    second: Array
    """Constriction in the second body."""
    film: Array
    """Of the film: area resistance over area."""
    bulk_first: float
    """Of the length of a rod."""
    bulk_second: float
    middle: Array
    """What of the voltage over both constrictions falls in the first body on the axis of the spot [-]."""
    edge: Array
    """The same at the edge of the spot; between bodies that are not plated, or alike, it is the mean."""

    @property
    def bulk(self) -> float:
        """Of both rods."""
        return self.bulk_first + self.bulk_second

    @property
    def whole(self) -> Array:
        """All parts."""
        return self.first + self.second + self.film + self.bulk


@value
class PlatedResponse:
    """The response of two bodies, plated or not, to a flux: 1 + M(xi).

    Parameters
    ----------
    first, second : ElectricalConductor, ThermalConductor or Plated
    """

    first: ConductingBody
    second: ConductingBody

    @property
    def _platings(self) -> list[Plated]:
        return [body for body in (self.first, self.second) if isinstance(body, Plated)]

    @property
    def length(self) -> float:
        """Thickness of the thinner plating [m]."""
        return min(body.thickness for body in self._platings)

    smooth = length
    """The same [m]."""

    @property
    def span(self) -> float:
        """Length [m] beyond which the platings no longer matter."""
        contrast, deepest = 1.0, 0.0
        for body in self._platings:
            layers, base = layers_of(body)
            each = [resistivity_of(conductor) for conductor in (*(one for one, _ in layers), base)]
            contrast = max(contrast, max(each) / min(each))
            deepest = max(deepest, sum(thickness for _, thickness in layers))
        return contrast * deepest

    precision = 3e-15
    """Rounding of M."""
    compressed = math.inf
    """Limit of (1 + M) / xi for long waves: the bodies have no end."""

    def _summed(self, part: Callable[[Any, Any, Any], Any], xi: ComplexArray) -> ComplexArray:
        """Return what echoes of both bodies make, each by its share of the resistivity."""
        first, second = (resistivity_of(surface_of(body)) for body in (self.first, self.second))
        own, other = (part(*_echo(body, xi)) for body in (self.first, self.second))
        return np.asarray((first * own + second * other) / (first + second))

    def whole(self, xi: Array) -> Array:
        """1 + M(xi) [-] at wave numbers (m,) [1/m]."""
        return self._summed(lambda _, less, more: more / less, xi)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        return self._summed(lambda echo, less, _: 2.0 * echo / less, xi)


def _echo(body: ConductingBody, xi: ComplexArray) -> tuple[Any, Any, Any]:
    """Return what comes back from below the outermost plating, at wave numbers xi [1/m], and one less and plus it.

    Nothing comes back from below a bare body.  Long waves come back from a much worse conductor almost whole, and
    turned round from a much better one: both sums are built of parts that do not cancel.
    """
    layers, base = layers_of(body)
    under: Any = resistivity_of(base)
    echo: Any = np.zeros(np.shape(xi))
    less: Any = np.ones(np.shape(xi))
    more: Any = less
    for conductor, thickness in reversed(layers):
        rho = resistivity_of(conductor)
        contrast, faded = (under - rho) / (under + rho), np.expm1(-2.0 * xi * thickness)
        echo = contrast * np.exp(-2.0 * xi * thickness)
        less = 2.0 * rho / (under + rho) - contrast * faded
        more = 2.0 * under / (under + rho) + contrast * faded
        under = rho * more / less
    return echo, less, more


def _uniform(body: ConductingBody) -> bool:
    """Return whether a body has one resistivity down to its base."""
    return len({resistivity_of(part) for part in parts_of(body)}) == 1


def _shares(first: ConductingBody, second: ConductingBody, a: float) -> tuple[float, float, float]:
    r"""Return the first body's share of the voltage over a spot: its mean over the current, on the axis, at the edge.

    The springs of both bodies together have the current phi; those of one alone the displacement
    :math:`\varrho_1(\varphi+K_1\varphi)`, whose T2 is the voltage over that body.

    Parameters
    ----------
    first, second : ElectricalConductor, ThermalConductor or Plated
        One of them plated.
    a : float
        Radius [m].
    """
    rho = [resistivity_of(surface_of(body)) for body in (first, second)]
    *_, phi, _, panels = punch_at(PlatedResponse(first, second), a, NODES)
    flow = phi.ravel()
    x, w = panel_nodes(a * panels, NODES)
    own = flow
    if isinstance(first, Plated) and not _uniform(first):
        own = flow + kernel_matrix(PlatedResponse(first, first), a, panels.size - 2, NODES) @ flow
    own = rho[0] / sum(rho) * own
    fit = np.polynomial.legendre.Legendre.fit
    middle = float(fit(x[:NODES], own[:NODES], NODES - 1)(0.0))
    last = float(fit(x[-NODES:], own[-NODES:], NODES - 1)(a))
    edge = last + 2.0 / math.pi * float(w @ ((own - last) / np.sqrt((a - x) * (a + x))))
    return float((w * flow) @ own) / float(w @ flow), middle, edge


def _all_shares(first: ConductingBody, second: ConductingBody, a: Array) -> Array:
    """Return `_shares` of many radii ``(3, m)``: of more than a series in ln(a) needs, by that series."""
    low, high = math.log(float(np.min(a))), math.log(float(np.max(a)))
    count = math.ceil(PLACES + PLACES_PER_FOLD * (high - low))
    if a.size <= count:
        return np.array([_shares(first, second, one) for one in a.tolist()]).T
    cheb = np.polynomial.chebyshev
    s = cheb.chebpts1(count)
    found = [_shares(first, second, one) for one in np.exp(0.5 * (low + high + (high - low) * s)).tolist()]
    series = np.linalg.solve(cheb.chebvander(s, count - 1), np.array(found))
    return np.asarray(cheb.chebval((2.0 * np.log(a) - low - high) / (high - low or 1.0), series))


def _relieved(body: ConductingBody, radius: Array) -> Array:
    if not isinstance(body, Rod):
        return np.ones(radius.shape)
    if np.max(radius, initial=0.0) > LARGEST_RADIUS_RATIO * body.radius:
        raise OutsideValidity(
            f"The contact, of radius {float(np.max(radius)):.4g} m, is nearly as wide as the rod, of radius "
            f"{body.radius:.4g} m; it must stay below {LARGEST_RADIUS_RATIO:g} of that: press less, or give a thicker "
            "rod."
        )
    return relief(radius / body.radius)


def disc_resistances(
    first: ConductingBody, second: ConductingBody, area_resistance: float, radius: Array
) -> Resistances:
    """Return the resistance to a current through a disc.

    Parameters
    ----------
    first, second : ElectricalConductor, ThermalConductor, Plated or Rod
        The bodies.
    area_resistance : float
        Of a film between them [ohm m^2 or m^2 K/W].
    radius : ndarray, (m,)
        a [m].

    Returns
    -------
    Resistances
        Each `(m,)`.

    Raises
    ------
    OutsideValidity
        If the contact is nearly as wide as a rod.
    """
    touching = radius > 0.0
    a = np.where(touching, radius, 1.0)
    rho = [resistivity_of(surface_of(body)) for body in (first, second)]
    filmed = bool(area_resistance) and _bare(first, second)
    spread = spreading(2.0 * area_resistance / (sum(rho) * a)) if filmed else np.ones(a.shape)
    parts = [r / (4.0 * a) * spread for r in rho]
    shares = np.broadcast_to(rho[0] / sum(rho), (3, a.size))
    if not (_uniform(first) and _uniform(second)):
        whole = sum(rho) / (4.0 * np.where(touching, fredholm.area(PlatedResponse(first, second), radius), 1.0))
        if first != second and touching.any():
            shares = shares.copy()
            shares[:, touching] = _all_shares(first, second, radius[touching])
        parts = [whole * shares[0], whole * (1.0 - shares[0])]
    relieved = [_relieved(body, radius) for body in (first, second)]
    parts = [part * less for part, less in zip(parts, relieved, strict=True)]
    _, middle, edge = shares * relieved[0] / (shares * relieved[0] + (1.0 - shares) * relieved[1])
    film = np.where(touching, area_resistance / (np.pi * a**2), 0.0)
    apart = [np.where(touching, part, np.inf) for part in parts]
    return Resistances(apart[0], apart[1], film, bulk_of(first), bulk_of(second), middle, edge)


def _bare(first: ConductingBody, second: ConductingBody) -> bool:
    return not any(isinstance(body, Plated | Rod) for body in (first, second))


def conduction_notes(first: ConductingBody, second: ConductingBody, area_resistance: float) -> tuple[Note, ...]:
    """Return what must be stated about the bodies and the film."""
    rods = [isinstance(body, Rod) for body in (first, second)]
    said: list[tuple[Standing, str, str]] = []
    if not any(rods):
        said.append((Standing.EXACT, "Steady conduction through one round contact; nothing passes outside it.", HOLM))
    if any(isinstance(body, Plated) for body in (first, second)):
        said.append((Standing.EXACT, PLATED, OWN_SOLUTION))
    if any(rods):
        alike = all(rods) and first == second
        said.append((Standing.EXACT, RODS_ALIKE, OWN_SOLUTION) if alike else (Standing.ASYMPTOTIC, RODS, OWN_SOLUTION))
    if area_resistance:
        bare = _bare(first, second)
        standing, text = (Standing.EXACT, SPREAD_BY_FILM) if bare else (Standing.APPROXIMATE, FILM_ADDED)
        said.append((standing, text, OWN_SOLUTION))
    return tuple(Note(Assumption.CONDUCTION, *each) for each in said)
