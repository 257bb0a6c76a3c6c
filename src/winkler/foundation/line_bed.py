"""What the beds of line contacts share: a two-dimensional profile, and the loads that it bears on its bodies."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

import numpy as np

from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.media.layered.wave_constants import Body, Wave, constants_of, half_space_compliance
from winkler.numerics.surfaces.strip_elements import element_compliance, hats, linear_slope
from winkler.numerics.surfaces.strip_grid import strip_compliance
from winkler.numerics.transforms.grid_transforms import GridTransforms
from winkler.numerics.transforms.strips.strip_transforms import StripTransforms
from winkler.numerics.types import Array
from winkler.profiles.area import AreaFunction
from winkler.profiles.profile import Profile
from winkler.values.checks.number_checks import NonNegative, Positive
from winkler.values.errors import InvalidInput
from winkler.values.validity import Note
from winkler.values.value import value, words

if TYPE_CHECKING:  # numerics of layers are loaded with layers
    from winkler.media.layered.plane_interior import PlaneWaves
    from winkler.media.offers import LayerStack

SIMILAR = 1e-12
"""Dundurs' constant [-] below which bodies are similar."""
PLACES_BESIDE = 513
"""Places at which the slope of the distance beside a strip is added up."""


NODES, WEIGHTS = np.polynomial.legendre.leggauss(6)


class PressedPair(Protocol):
    """The bodies of a line contact."""

    @property
    def modulus(self) -> float:
        """E* of both surfaces [Pa]."""

    @property
    def along_modulus(self) -> float:
        """m_L of both surfaces [Pa], of shear along the strip's width; refused where shear does not reach the base."""


@value
class Zone:
    """A constant attraction beside one strip.

    Parameters
    ----------
    strength : float
        The stress sigma_0 [Pa].
    contact, outer : float
        a and c [m].
    """

    __words__ = words(
        strength=(r"\sigma_0", "Pa", "stress with which the surfaces attract each other"),
        contact=("a", "m", "half-width of the contact"),
        outer=("c", "m", "where the attraction ends"),
    )

    strength: Positive
    contact: NonNegative
    outer: Positive

    @property
    def span(self) -> float:
        """l = sqrt(c^2 - a^2) [m]."""
        return math.sqrt((self.outer - self.contact) * (self.outer + self.contact))


class LineBed:
    """A profile symmetric in x, endless along y, pressed on two bodies; in plane strain."""

    profile: Profile
    medium: PressedPair

    search_step: ClassVar[float] = 32.0
    """Factor between the half-widths that are tried before a search begins."""

    punches_push: ClassVar[bool] = True
    """Whether flat punches nowhere pull, and leave the surface beside them below: no contact whose load grows parts."""

    edges_bear: ClassVar[bool] = True
    """Whether the edges bear what a load has beside that of the profile."""

    sheared_as_pressed: ClassVar[bool] = False
    """Whether tractions move the surfaces along as pressures sink them, but for the factor `along_share`."""

    def __post_init__(self) -> None:
        if isinstance(self.profile, AreaFunction):
            raise InvalidInput(
                f"{type(self).__name__}: an AreaFunction states the round cross-sections of a tip; give the profile of "
                "a cross-section along the strip, such as Paraboloid, RoundedPunch or Measured."
            )

    @property
    def half_plane(self) -> LineBed:
        """The same profile on half-planes of what carries the surface, of which all is known in closed form: itself."""
        return self

    @property
    def hertz_radius(self) -> float:
        """R of a parabolic cylinder on half-planes [m], whose pressure is Hertz's under every load; else infinite."""
        return math.inf

    @property
    def hertzian(self) -> bool:
        """Whether the pressure is Hertz's under every load, so that all contacts are similar."""
        return math.isfinite(self.hertz_radius)

    @property
    def along_share(self) -> float:
        """E* / m_L [-]: over how far a pressure sinks the surfaces, how far a traction moves them along."""
        return self.medium.modulus / self.medium.along_modulus

    @property
    def surfaces(self) -> tuple[Body, Body]:
        """The solids at the surfaces of the first and the second body."""
        medium: Any = self.medium
        return medium.first, medium.second

    @property
    def mismatch(self) -> float:
        """How far a pressure draws the first surface along less the second, over how far it sinks both: beta [-].

        Of short waves, as on half-planes of the solids at the surfaces; Dundurs' second constant if these are
        isotropic.
        """
        first, second = (half_space_compliance(body, Wave.COUPLING) for body in self.surfaces)
        return self.medium.modulus * (first - second)

    @property
    def similar(self) -> bool:
        """Whether pressure and traction do not act on each other."""
        return abs(self.mismatch) <= SIMILAR

    def refuse_dragged(self, friction: float) -> None:
        """Refuse friction [-] where a layer slides on what lies below it: it would be dragged away."""

    @property
    def strained(self) -> Elastic | TransverselyIsotropic | Rigid:
        """The solid of the first body far below the contact, which a bulk stress strains."""
        return self.surfaces[0]

    @property
    def strain_per_stress(self) -> float:
        """Strain of the first surface along x over the bulk stress, in plane strain [1/Pa]; zero if it is rigid."""
        solid = self.strained
        if isinstance(solid, Rigid):
            return 0.0
        constants = constants_of(solid)
        return 1.0 / (constants.plane * constants.shear)

    @property
    def reach(self) -> float:
        """Up to where the profile is known [m]."""
        return self.profile.reach

    @property
    def rim(self) -> float:
        """Where the contact is pinned [m]; infinite if nowhere."""
        return self.profile.rim

    @property
    def size(self) -> float:
        """Radius of the body [m]; infinite if unknown."""
        return self.profile.size

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)``: just above x, w' holds strength / sqrt(a^2 - x^2)."""
        return tuple((b, b * jump) for b, jump in self.profile.kinks)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be stated about the shape."""
        return self.profile.notes

    @property
    def flat(self) -> float:
        """Half-width of the flat middle [m]: the contact opens with it."""
        end, flat = min(self.reach, self.rim), 0.0
        for b in (*(b for b, _ in self.profile.kinks if b < end), end):
            if not np.isfinite(b) or float(self.profile.height(np.array([b]))[0]) != 0.0:
                break
            flat = b
        return flat

    @property
    def trial(self) -> float:
        """Distance of the edge from the flat middle at which a search begins [m]; infinite if the load decides."""
        return np.inf

    @property
    def single(self) -> bool:
        """Whether every contact is known to be one strip."""
        return self.profile.rising

    def slope(self, x: Array) -> Array:
        """f'(x) [-]."""
        return self.profile.slope(x)

    def load_profile(self, half_width: Array) -> Array:
        """Return the load per length over E* [m]."""
        raise NotImplementedError

    def load_profile_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [-]."""
        raise NotImplementedError

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure [Pa]: zero outside, infinite at a rim, a kink and a sharp tip.

        Parameters
        ----------
        x : ndarray
            Places on the surface [m], on either side.
        half_width : float
            a [m].
        rim_load : float
            Load per length over E* that the edge bears beyond `load_profile` [m]: at a rim, or negative where adhesion
            pulls.
        """
        raise NotImplementedError

    def half_width(self, load: Array) -> Array | None:
        """Return the half-widths [m] under loads per length over E* [m], where they are known in closed form."""
        return None

    def mean_pressures(self, edges: Array, half_width: float, rim_load: float) -> Array:
        """Return the mean pressure [Pa] between places, ascending from the middle [m]; zero beyond the strip.

        Parameters
        ----------
        edges : ndarray, (n + 1,)
        half_width, rim_load : float
            As of `pressure`.
        """
        angles = np.arcsin(np.minimum(edges / half_width, 1.0))
        half = 0.5 * np.diff(angles)[:, None]
        angle = 0.5 * (angles[1:] + angles[:-1])[:, None] + half * NODES
        places = half_width * np.sin(angle)
        pressure = self.pressure(places.ravel(), half_width, rim_load).reshape(places.shape)
        borne = np.sum(half * WEIGHTS * np.where(half > 0.0, pressure * np.cos(angle), 0.0), axis=1)
        return np.asarray(half_width * borne / np.diff(edges))

    def shear_compliance(self, edges: Array) -> Array:
        """Return how far tractions of E*, each on one element, move the middles along ``(n, n)``, over the last edge.

        Parameters
        ----------
        edges : ndarray, (n + 1,)
            Ascending, symmetric about the middle [m]; displacements are counted from the distance of the last one.
        """
        return self.along_share * element_compliance(edges / edges[-1])

    def beside(self, half_width: float) -> tuple[Array, Array]:
        """Return half-widths [m] of flat punches beside the strip, and their loads over E* [m]: none."""
        return np.zeros(0), np.zeros(0)

    def edge_share(self, half_width: Array) -> Array:
        """Return the tension at the edges of a flat punch that is pulled, over that on half-planes [-]."""
        return np.ones(np.shape(half_width))

    def edge_share_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [1/m]."""
        return np.zeros(np.shape(half_width))

    def repeated(self, profile: Profile, pitch: float) -> LineBed:
        """Return the bed of strips at a pitch [m] whose profile over u is given (`winkler.foundation.periodic`)."""
        raise NotImplementedError

    def zoned(self, strength: float, half_width: float, outer: float) -> LineBed:
        """Return the bed with an attraction of a constant stress [Pa] beside a strip, up to `outer` [m].

        Its `load_profile` is still that of the profile alone, on half-planes.
        """
        raise NotImplementedError

    def zone_start(self, half_width: Array, reach: float, strength: float) -> Array:
        """Return at least how far an attraction with a range `reach` [m] goes on beside strips, the span l [m]."""
        return self.half_plane.zone_start(half_width, reach, strength)

    def zone_gap(self, half_width: Array, span: Array, strength: float) -> tuple[Array, Array]:
        """Return the distance of the surfaces [m] where a constant attraction beside strips ends, and its slope.

        Parameters
        ----------
        half_width, span : ndarray, (m,)
            a and l = sqrt(c^2 - a^2) [m], the attraction ends at c; the slope is that by l [-].
        strength : float
            sigma_0 [Pa].
        """
        raise NotImplementedError

    def zone_load(self, half_width: Array, span: Array, strength: float) -> Array:
        """Return the load per length over E* of strips with an attraction beside them [m], as of `zone_gap`."""
        raise NotImplementedError

    def zone_load_slope(self, half_width: Array, span: Array, strength: float) -> Array:
        """Return its derivative by the half-width [-], while the distance where the attraction ends stays."""
        raise NotImplementedError

    def hat_compliance(self, count: int, spacing: float, reference: float) -> Array:
        """Return the displacement [m] at nodes 0, 1, ... `count` spacings away from a hat of tractions with the top E*.

        Parameters
        ----------
        count : int
        spacing, reference : float
            Between nodes, and the distance from which displacements are counted [m].
        """
        return self.along_share * spacing * strip_compliance(count, 1.0, reference / spacing)

    def slopes(self, part: Wave, nodes: Array, x: Array) -> Array:
        """Return slopes of the surfaces at places under tractions of E*, each on one node, straight to the next.

        Parameters
        ----------
        part : Wave
            How steeply pressures lower the surfaces (`NORMAL`), or tractions move them along (`ALONG`), each with the
            sign turned; or how pressures stretch the first more than the second, as tractions lift it (`COUPLING`).
        nodes : ndarray, (m,)
            Ascending [m]; the first and the last carry nothing.
        x : ndarray, (k,)
            Places [m], none of them a node.

        Returns
        -------
        ndarray, (k, m - 2)
        """
        if part is Wave.COUPLING:
            return np.asarray(2.0 * self.mismatch * hats(nodes, x))
        share = self.along_share if part is Wave.ALONG else 1.0
        return 2.0 * share * linear_slope(nodes, x)

    def drawn(self, x: Array, half_width: float) -> Array:
        """Return how far the pressure of a contact moves the first surface beyond the second [m], zero in the middle.

        Parameters
        ----------
        x : ndarray
            Places inside or outside of the strip [m].
        half_width : float
            a [m].
        """
        if self.mismatch == 0.0:
            return np.zeros(x.shape)
        ends, where = np.unique(np.append(0.0, np.abs(x)), return_inverse=True)
        borne = np.append(0.0, np.cumsum(self.mean_pressures(ends, half_width, 0.0) * np.diff(ends)))
        return np.asarray(-2.0 * self.mismatch / self.medium.modulus * np.sign(x) * borne[where[1:]].reshape(x.shape))

    def punch_softening(self, half_width: Array) -> Array:
        """Return by how much less a flat punch of E* is displaced if it is wider, per ln(a) [-]."""
        return np.full(np.shape(half_width), 2.0 / math.pi)

    def stuck_compliance(self, half_width: float, unit: float) -> float:
        """Return the displacement of a strip that sticks, over the shear force per length over E* [-].

        Parameters
        ----------
        half_width : float
            a [m].
        unit : float
            The distance from which displacements are counted [m].
        """
        return -2.0 / math.pi * self.along_share * math.log(0.5 * half_width / unit)

    @property
    def layered(self) -> LayerStack:
        """The medium, if it has layers."""
        raise NotImplementedError

    def waves_below(self, half_width: float, rim_load: float, farthest: float) -> PlaneWaves:
        """Return the pressure of a strip as waves that layers feel, for places up to a distance [m]."""
        raise NotImplementedError

    def punch_edges(self, half_width: Array) -> tuple[Array, Array]:
        """Return the loads over E* at the edges of flat punches that bear one: of those that press, and that push.

        Parameters
        ----------
        half_width : ndarray, (m,)
            a [m].
        """
        return np.ones(half_width.shape), np.ones(half_width.shape)

    def grid_transforms(self, nodes: Array) -> GridTransforms:
        """Return the transforms of worn contacts between nodes [m] ``(n,)``."""
        return StripTransforms(nodes)

    def shear_transforms(self, nodes: Array) -> GridTransforms:
        """Return the same of tractions along the strip's width, as of `grid_transforms` if they move surfaces alike."""
        return self.grid_transforms(nodes)

    def opening(self, x: Array, half_width: float) -> Array:
        """Return the slope h'(x) [-] of the distance of the surfaces at x > a, by small differences."""
        step = 1e-4 * half_width
        beyond, before = (self.separation(place, half_width, 0.0) for place in (x + step, np.maximum(x - step, 0.0)))
        return np.asarray((beyond - before) / (2.0 * step))

    def surface_potential(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return F(x) [Pa] of `winkler.numerics.fields.half_plane` on the surface, at x >= 0."""
        raise NotImplementedError

    def potential(self, x: Array, z: Array, half_width: float, rim_load: float) -> tuple[Array, Array]:
        """Return F [Pa] and F' [Pa/m] below the surface, at x >= 0."""
        raise NotImplementedError

    def separation(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the distance of the surfaces [m] at places x >= 0, zero inside."""
        raise NotImplementedError

    def examined(self, half_width: Array) -> Array:
        """Return those of many half-widths, ascending [m], whose contacts are to be examined: all."""
        return half_width

    def gaps(self, half_width: float, end: float) -> tuple[Array, Array]:
        """Return places beside a strip up to `end` [m], and a measure of the distance of the surfaces there."""
        x = np.linspace(half_width, end, PLACES_BESIDE)[1:-1]
        if not half_width < x[0]:
            return x, np.zeros(x.size)
        return x, np.cumsum(self.opening(x, half_width))
