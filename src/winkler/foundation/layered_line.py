r"""The bed of a line contact on layers: a two-dimensional profile on a coated half-plane or a strip on a rigid base.

The layers are isotropic or transversely isotropic, bonded or sliding, or a body is graded with depth: only their
responses count.

The uppermost layer's half-plane carries :math:`E^*w(a)` as it does without layers; what the others add is the
correction :math:`\beta` of `winkler.numerics.transforms.strips.strip_equation`, with which

.. math:: P(a) = E^*\,(w(a) + \beta_0) , \qquad
          \frac{\mathrm dP}{\mathrm da} = E^*\,\frac{w'(a) - \frac2a\sum n^2\beta_n}{\sum\pi_n} ;

:math:`\pi` are the modes of a flat punch that bears a load of one: as the strip widens by da it adds a flat punch whose
edge is as steep as the pressure falls there.  A traction moves the surface along as a pressure sinks it, with the
response to shear along the wave for that to pressures.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Annotated, ClassVar, NamedTuple, cast

import numpy as np

from winkler.foundation.line import LineFoundation, ZonedBed
from winkler.foundation.line_bed import LineBed, Zone
from winkler.foundation.periodic import from_line
from winkler.foundation.strip_kernels import bends, risen, twists
from winkler.foundation.strip_sums import added_responses, added_sums, edge_fall
from winkler.foundation.strip_waves import punches, smooth_modes, transforms
from winkler.media.layered.coated import CoatedHalfSpace, SlidingFilm, StackedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.layered.depth_response import GradedBody
from winkler.media.layered.plane_interior import PlaneWaves, plane_waves
from winkler.media.layered.stack import Layered
from winkler.media.layered.wave_constants import Body, Wave
from winkler.media.offers import LayerStack, PlaneMedium
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.media.relaxing.poroelastic import PoroelasticFilm
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.numerics.chunks import chunks, wave_sums
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.surfaces.strip_elements import by_hats
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, WaveResponse, faded, has_tail, in_own_lengths
from winkler.numerics.transforms.strips import strip_punches
from winkler.numerics.transforms.strips.layered_strips import LayeredStrips
from winkler.numerics.transforms.strips.strip_equation import (
    MOST_MODES,
    TAIL,
    TAIL_AT_EDGE,
    TAIL_IN_LOAD,
    VANISHED,
    StripResponse,
    Strips,
    Waves,
    octaves,
    punch_edges,
    settled_strips,
    strip_responses,
    waves,
)
from winkler.numerics.transforms.strips.strip_harmonics import far_harmonics, harmonic_rows, harmonics, resolves
from winkler.numerics.transforms.strips.strip_modes import (
    along_surface,
    bessel_rows,
    lowered,
    potential_of_modes,
    pressure_of_modes,
    signs,
)
from winkler.numerics.types import Array
from winkler.profiles.conical import power_of
from winkler.profiles.profile import Profile
from winkler.values.checks.number_checks import Advice, Positive
from winkler.values.errors import OutsideValidity
from winkler.values.value import value

RelaxingKinds = RelaxingInProportion | ViscoelasticCoatedHalfSpace | PoroelasticFilm
MOST_HARMONICS, FIRST_MODES, LONGEST = 4000, 24, 1e-6
"""Waves of periodic strips that are felt, modes to begin with, and the wave number of an even load over the lengths."""
LEAST_NODES = 12
"""Flat punches that stand for the attraction beside a strip, at the fewest."""
VALLEY = 3e-3
"""Part over u that is left out before a sharp valley on gradings."""
STEP = 1e-4
"""Of differences, over the length that is changed."""
MOST_EXAMINED = 16
"""Half-widths of many whose contacts are examined for tension and overlap."""
PLACES_BESIDE = np.geomspace(1e-3, 1.0, 25)[:-1]
"""Where the distance beside a strip is examined, between its edge and the farthest place."""


class EndedZones(NamedTuple):
    """Strips beside which a constant stress attracts.

    Parameters
    ----------
    gap
        Distance of the surfaces where the attraction ends [m].
    load
        Load per length over E* [m].
    edge
        Its derivative by the half-width while the end stays [-].
    closing
        By how much a flat punch as wide brings the surfaces closer at the end, over its load over E* [-].
    """

    gap: Array
    load: Array
    edge: Array
    closing: Array


class Carried(NamedTuple):
    """The pressure of one strip: that of the half-plane under the profile, and the modes beside it.

    Parameters
    ----------
    half_width
        a [m].
    own
        Modes of the half-plane's pressure, loads over E* [m]; None where it has none (a tip or a kink).
    added
        Modes of what the layers and a rim add [m].
    edge
        Load of the flat punch with the same edge [m]; zero where the contact closes smoothly.
    """

    half_width: float
    own: Array | None
    added: Array
    edge: float

    @property
    def modes(self) -> Array:
        """All modes: without `own` those of the addition [m]."""
        if self.own is None:
            return self.added
        whole = np.zeros(max(self.own.size, self.added.size))
        whole[: self.own.size] = self.own
        whole[: self.added.size] += self.added
        return whole


@value
class LayeredLineFoundation(LineBed):
    """A cylindrical body under a two-dimensional profile, endless along y, on a layered body; in plane strain.

    Parameters
    ----------
    profile : Profile
        The gap f between the undeformed bodies, as in `LineFoundation`.
    medium : CoatedHalfSpace, StackedHalfSpace, SlidingFilm, DepthGradedHalfSpace or PlaneMedium
        Layers (each bonded to the material below or sliding on it) on a half-plane or a rigid base, or a body graded
        with depth; against a homogeneous body. For viscoelastic problems: RelaxingInProportion,
        ViscoelasticCoatedHalfSpace or PoroelasticFilm.

    References
    ----------
    P. Meijers, Appl. Sci. Res. 18 (1968) 353-383, doi:10.1007/BF00382359;
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 5.8, doi:10.1017/CBO9781139171731
    """

    profile: Profile
    medium: Annotated[
        CoatedHalfSpace | StackedHalfSpace | SlidingFilm | DepthGradedHalfSpace | RelaxingKinds | PlaneMedium,
        Advice("homogeneous bodies go into a LineFoundation"),
    ]

    search_step: ClassVar[float] = 1.5
    punches_push: ClassVar[bool] = False

    def __post_init__(self) -> None:
        LineBed.__post_init__(self)
        _ = self.half_plane

    @property
    def half_plane(self) -> LineFoundation:
        """The same profile on a half-plane of the uppermost layer."""
        pair = cast(PlaneMedium, self.medium).response
        return LineFoundation(self.profile, TransverselyIsotropicHalfSpace(pair.first.top, pair.second))

    @property
    def layered_body(self) -> Layered:
        """The layered body, as what it answers to waves."""
        body: Layered = self.medium.response.first
        return body

    @property
    def layered(self) -> LayerStack:
        """The medium, if it has layers.

        Raises
        ------
        OutsideValidity
            If it is a grading, in which stresses are not known.
        """
        self.refuse_grading(
            "Stresses below a line contact are known in layers and homogeneous bodies; in the place of the grading"
        )
        return cast(LayerStack, self.medium)

    def refuse_grading(self, why: str) -> None:
        """Refuse a grading with what is offered in its place after a reason."""
        if isinstance(self.layered_body, GradedBody):
            raise OutsideValidity(f"{why} give a CoatedHalfSpace of layers that follow it.")

    def _refuse_sticking_grading(self) -> None:
        self.refuse_grading(
            "A constant attraction beside a line (Dugdale) is known on layers and homogeneous bodies; on a grading, "
            "whose waves fall slowly, it is not built in: give ShortRange, or for the grading"
        )

    def own_modes(self, half_width: Array) -> Array | None:
        """Return the modes of the half-planes' pressures ``(a, n)``, as in `smooth_modes`."""
        return smooth_modes(self.half_plane, half_width)

    def own_transforms(self, half_width: Array, k: Array) -> Array:
        """Return the transforms of the half-planes' pressures over E* [m] at wave numbers k [1/m] ``(a, k)``."""
        return transforms(self.half_plane, half_width, k)

    def repeated(self, profile: Profile, pitch: float) -> PeriodicLayers:
        """Return the bed of strips at a pitch [m], as in `LineFoundation.repeated`."""
        return PeriodicLayers(profile, self.medium, pitch)

    @property
    def alike(self) -> tuple[object, ...]:
        """What beds have in common whose strips press alike, but for the modulus; under powers at one a/h."""
        own, unit = in_own_lengths(self.medium.response)
        exponent = power_of(self.profile)[1]
        return (exponent, own) if exponent else (self.profile, own, unit)

    def solved(self, half_width: Array) -> StripResponse:
        """Return what the layers add under strips [m]."""
        slopes = self.half_plane.load_profile_slope(half_width)
        return strip_responses(self.medium.response, half_width, self.own_transforms, slopes)

    def waves_below(self, half_width: float, rim_load: float, farthest: float) -> PlaneWaves:
        """Return the pressure of a strip as waves, for places up to a distance [m] from the middle."""
        carried = self.carried(half_width, rim_load)

        def transform(k: Array) -> Array:
            return np.asarray(self.medium.modulus * self.transform(k, carried))

        return plane_waves(self.layered, half_width, farthest, transform)

    def refuse_dragged(self, friction: float) -> None:
        """Refuse friction [-] where a layer slides on what lies below it."""
        if friction != 0.0:
            _ = self.medium.along_modulus

    @property
    def surfaces(self) -> tuple[Body, Body]:
        """The solid of the uppermost layer, and the second body."""
        return self.layered_body.top, cast(PlaneMedium, self.medium).second

    @property
    def similar(self) -> bool:
        """False: where the surfaces are alike, what lies below one of them is not."""
        return False

    @property
    def strained(self) -> Body:
        """What carries the layers, which a bulk stress strains together with them."""
        return self.layered_body.on

    @property
    def trial(self) -> float:
        """Half of the thickness of the uppermost layer, or of the depth over which a grading changes [m]."""
        return 0.5 * self.layered_body.unit[1]

    @property
    def single(self) -> bool:
        """False: a stack may bulge beside the strip, or part from the body in its middle."""
        return False

    def load_profile(self, half_width: Array) -> Array:
        """Return the load per length over E* of the uppermost layer [m]."""
        own = self.half_plane.load_profile(half_width)
        return _touching(half_width, own, lambda a, own: own + added_sums(self, a)[0])

    def load_profile_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [-]."""

        def widened(a: Array, own: Array) -> Array:
            _, fall, steep = added_sums(self, a)
            return np.asarray((own - fall) / steep)

        return _touching(half_width, self.half_plane.load_profile_slope(half_width), widened)

    def edge_share(self, half_width: Array) -> Array:
        """Return the tension at the edges of a flat punch, as in `LineBed.edge_share`."""
        ones, response = np.ones(np.shape(half_width)), self.medium.response
        if has_tail(response):
            return _touching(half_width, ones, lambda a, _: punch_edges(response, a)[0])
        return _touching(half_width, ones, lambda a, _: added_sums(self, a)[2])

    def edge_share_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [1/m].

        A punch that widens adds a pressure whose singularity is that of the derivative of 1/sqrt(a^2 - x^2): of the
        half-plane's, -k J_1(ka), the layers take away what closes at the edge.
        """
        from scipy.special import j1

        def widened(a: Array, _: Array) -> Array:
            if has_tail(self.medium.response):
                return punch_edges(self.medium.response, a)[1]
            punch = added_responses(self, a).punch
            none = np.zeros(a.size)  # the waves of no grading, which alone ask for slopes
            added = strip_responses(self.medium.response, a, lambda a, k: -k * j1(a[:, None] * k), none)
            return np.asarray(edge_fall(punch, a) - np.sum(punch, axis=1) ** 2 * added.closing[:, 0])

        return _touching(half_width, np.zeros(np.shape(half_width)), widened)

    def zoned(self, strength: float, half_width: float, outer: float) -> ZonedLayers:
        """Return the bed with the attraction beside a strip, as in `LineBed.zoned`."""
        return ZonedLayers(self.profile, self.medium, strength, half_width, outer)

    def zone_gap(self, half_width: Array, span: Array, strength: float) -> tuple[Array, Array]:
        """Return the distance where an attraction ends, as in `LineBed.zone_gap`; the slope is that of half-planes."""
        return _zones(self, half_width, span, strength).gap, self.half_plane.zone_gap(half_width, span, strength)[1]

    def zone_load(self, half_width: Array, span: Array, strength: float) -> Array:
        """Return the load per length over E* of strip and attraction, as in `LineBed.zone_load`."""
        return _zones(self, half_width, span, strength).load

    def zone_load_slope(self, half_width: Array, span: Array, strength: float) -> Array:
        """Return its derivative by the half-width, as in `LineBed.zone_load_slope`; to about 1e-8.

        As a strip widens beside an attraction that ends at c it adds a flat punch, which brings the surfaces at c
        closer.  Where c lies close to the edge that cancels against the longer attraction: differences are taken
        at one l.
        """
        result = np.empty(half_width.shape)
        for own, near in ((half_width > span, True), (half_width <= span, False)):
            a, reach = half_width[own], span[own]
            if a.size == 0:
                continue
            farther, nearer = (_zones(self, a, reach * (1.0 + step), strength) for step in (STEP, -STEP))
            ratio = (farther.load - nearer.load) / (farther.gap - nearer.gap)
            if near:
                wider, narrower = (_zones(self, a * (1.0 + step), reach, strength) for step in (STEP, -STEP))
                rise = (wider.load - narrower.load) - ratio * (wider.gap - narrower.gap)
                result[own] = rise / (2.0 * STEP * a)
            else:
                edge, closing = 0.5 * (farther.edge + nearer.edge), 0.5 * (farther.closing + nearer.closing)
                result[own] = edge * (1.0 + ratio * closing)
        return result

    def carried(self, half_width: float, rim_load: float) -> Carried:
        """Return the pressure of a strip, as modes.

        Parameters
        ----------
        half_width : float
            a [m], positive.
        rim_load : float
            As in `pressure`.
        """
        return _carried(self, half_width, rim_load)

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure [Pa], as in `LineFoundation.pressure`."""
        carried = self.carried(half_width, rim_load)
        found = self.medium.modulus * pressure_of_modes(carried.modes, half_width, x, carried.edge)
        if carried.own is None:
            found = found + self.half_plane.pressure(x, half_width, 0.0)
        return np.asarray(found)

    def mean_pressures(self, edges: Array, half_width: float, rim_load: float) -> Array:
        """Return the mean pressure [Pa] between places, as in `LineBed.mean_pressures`."""
        carried = self.carried(half_width, rim_load)
        if carried.own is None:
            return LineBed.mean_pressures(self, edges, half_width, rim_load)
        angle = np.arcsin(np.minimum(edges / half_width, 1.0))
        order = 2.0 * np.arange(1, carried.modes.size)
        borne = carried.modes[0] * angle + (signs(order.size + 1)[1:] * carried.modes[1:] / order) @ np.sin(
            np.outer(order, angle)
        )
        return np.asarray(self.medium.modulus / np.pi * np.diff(borne) / np.diff(edges))

    def shear_compliance(self, edges: Array) -> Array:
        """Return how far tractions move the middles of elements along, as in `LineBed.shear_compliance`."""
        far = 0.5 * (edges[1:] + edges[:-1])[:, None] - edges
        octave = int(octaves(self.medium.along_response, edges[-1:])[0])
        unit = self.medium.along_response.smooth * 2.0**octave
        lifted = unit / edges[-1] * np.sign(far) * twists(self.medium.along_response, octave)(np.abs(far) / unit)
        added = -2.0 / np.pi * self.along_share * np.diff(lifted, axis=1)
        return np.asarray(LineBed.shear_compliance(self, edges) + added)

    def hat_compliance(self, count: int, spacing: float, reference: float) -> Array:
        """Return the displacement [m] by a hat of tractions, as in `LineBed.hat_compliance`."""
        response, away = self.medium.along_response, spacing * np.arange(count + 1.0)
        found = _felt(response, away[-1])
        evened = np.sinc(found.k * spacing / (2.0 * np.pi)) ** 2  # the transform of a hat, over its area
        near = faded(response, reference) - float(np.sum(found.weights * (1.0 - evened)) + np.sum(found.shares))
        felt = near - wave_sums(risen, away, found.k, found.weights * evened)
        felt[0] += found.shares @ (2.0 / (found.shorter * spacing) ** 2)  # of shorter waves, by the mean of that
        plain = LineBed.hat_compliance(self, count, spacing, reference)
        return np.asarray(plain + 2.0 / np.pi * self.along_share * spacing * felt)

    def slopes(self, part: Wave, nodes: Array, x: Array) -> Array:
        """Return slopes of the surfaces by tractions straight between nodes, as in `LineBed.slopes`."""
        names = {Wave.NORMAL: "response", Wave.ALONG: "along_response", Wave.COUPLING: "coupling_response"}
        response: WaveResponse = getattr(self.medium, names[part])  # a layer that slides refuses some
        far = x[:, None] - nodes
        octave = int(octaves(response, np.array([0.5 * float(np.max(np.abs(far)))]))[0])
        unit = response.smooth * 2.0**octave
        if part is Wave.COUPLING:
            lifted = unit * bends(response, octave)(np.abs(far) / unit)
        else:
            share = self.along_share if part is Wave.ALONG else 1.0
            lifted = -share * unit * np.sign(far) * twists(response, octave)(np.abs(far) / unit)
        return LineBed.slopes(self, part, nodes, x) + 2.0 / np.pi * by_hats(lifted, nodes)

    def drawn(self, x: Array, half_width: float) -> Array:
        """Return how far the pressure moves the first surface beyond the second [m], as in `LineBed.drawn`."""
        response = self.medium.coupling_response
        found = _felt(response, max(half_width, float(np.max(np.abs(x)))))
        weights = -2.0 / np.pi * found.weights * self.transform(found.k, self.carried(half_width, 0.0))
        return LineBed.drawn(self, x, half_width) + np.sin(np.multiply.outer(x, found.k)) @ weights

    def stuck_compliance(self, half_width: float, unit: float) -> float:
        """Return the displacement of a strip that sticks, as in `LineBed.stuck_compliance`."""
        response, one = self.medium.along_response, np.array([half_width])
        found = _felt(response, half_width)
        punch = strip_responses(response, one, lambda a, k: np.zeros((a.size, k.size)), np.zeros(1)).punch[0]
        rows = bessel_rows(found.k * half_width, punch.size)
        felt = float(((punch * signs(punch.size)) @ rows * rows[0] - 1.0) @ found.weights)
        felt += float((np.sum(punch) / (np.pi * found.shorter * half_width) - 1.0) @ found.shares)
        return LineBed.stuck_compliance(self, half_width, unit) + 2.0 / np.pi * self.along_share * felt

    def punch_edges(self, half_width: Array) -> tuple[Array, Array]:
        """Return how steep flat punches are that press and that push, as in `LineBed.punch_edges`."""
        pressed, pushed = (
            strip_punches.edge(of, half_width) for of in (self.medium.response, self.medium.along_response)
        )
        return pressed, pushed

    def grid_transforms(self, nodes: Array) -> LayeredStrips:
        """Return the transforms of worn contacts between nodes [m]."""
        return LayeredStrips(nodes, self.medium.response)

    def shear_transforms(self, nodes: Array) -> LayeredStrips:
        """Return the same of tractions along the strip's width."""
        return LayeredStrips(nodes, self.medium.along_response)

    def separation(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the distance of the surfaces [m] at places x >= 0, zero inside."""
        if half_width == 0.0:
            return np.asarray(self.profile.height(x))
        carried = self.carried(half_width, rim_load)
        flat = np.ravel(np.asarray(x, dtype=float))
        outside = flat > half_width
        away = flat[outside]
        found = np.zeros(flat.size)
        if away.size:
            moved = lowered(carried.modes, half_width, away) + self.sunk(away, carried)
            if carried.own is None:
                part = self.half_plane.separation(away, half_width, 0.0)
            else:
                part = self.profile.height(away) - self.profile.height(np.array([half_width]))
            found[outside] = part - moved
        return found.reshape(np.shape(x))

    def surface_potential(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return F(x) [Pa] of the half-plane on the surface itself, at x >= 0: its imaginary part is -p."""
        carried = self.carried(half_width, rim_load)
        along = self.medium.modulus * along_surface(carried.modes, half_width, x, carried.edge)
        if carried.own is None:
            along = along + self.half_plane.surface_potential(x, half_width, 0.0).real
        return np.asarray(along - 1j * self.pressure(x, half_width, rim_load))

    def potential(self, x: Array, z: Array, half_width: float, rim_load: float) -> tuple[Array, Array]:
        """Return the potential F [Pa] and F' [Pa/m] of the half-plane below the surface, as in `LineFoundation`."""
        carried = self.carried(half_width, rim_load)
        whole, slope = potential_of_modes(carried.modes, half_width, x + 1j * z)
        whole, slope = self.medium.modulus * whole, self.medium.modulus * slope
        if carried.own is None:
            own = self.half_plane.potential(x, z, half_width, 0.0)
            whole, slope = whole + own[0], slope + own[1]
        return whole, slope

    def examined(self, half_width: Array) -> Array:
        """Return up to 16 of many half-widths, ascending [m], the first and the last among them."""
        chosen = half_width[np.unique(np.linspace(0.0, half_width.size - 1.0, MOST_EXAMINED).round().astype(int))]
        added_responses(self, chosen)  # at once, not one by one
        return np.asarray(chosen)

    def gaps(self, half_width: float, end: float) -> tuple[Array, Array]:
        """Return places beside a strip up to `end` [m], and the distance of the surfaces there [m]."""
        x = half_width + (end - half_width) * PLACES_BESIDE
        return x, self.separation(x, half_width, 0.0)

    def mode_transforms(self, half_width: float, count: int, k: Array) -> Array:
        """Return the cosine transforms of so many modes that each bear one, at wave numbers k [1/m] ``(n, k)``."""
        return np.asarray(signs(count)[:, None] * bessel_rows(k * half_width, count))

    def transform(self, k: Array, carried: Carried) -> Array:
        """Return the cosine transform of a pressure over E* [m] at wave numbers k [1/m]."""
        found = carried.modes @ self.mode_transforms(carried.half_width, carried.modes.size, k)
        if carried.own is None:
            found = found + self.own_transforms(np.array([carried.half_width]), k)[0]
        return np.asarray(found)

    def sunk(self, x: Array, carried: Carried) -> Array:
        """Return by how much less the layers below let the surface sink at places x >= a [m] than at the edge."""
        response = self.medium.response
        found = _felt(response, 0.5 * (float(np.max(x)) + carried.half_width))
        weights = 2.0 / np.pi * found.weights * self.transform(found.k, carried)
        at_edge = float(np.cos(found.k * carried.half_width) @ weights)
        return at_edge - wave_sums(np.cos, x, found.k, weights)


@value
class PeriodicLayers(LayeredLineFoundation):
    r"""Strips at one pitch on layers, over the u of `winkler.foundation.periodic`.

    The half-plane of the uppermost layer carries the pressure over u of a single strip.  The layers feel the waves
    :math:`k_m = 2\pi m/\lambda` alone: sums over them stand for the integrals of a single strip, and
    :math:`B_n(m)` of `winkler.numerics.transforms.strips.strip_harmonics` for :math:`(-1)^nJ_{2n}(ka)`.  Of a flat
    punch it is half of :math:`P_m(y)+P_{m-1}(y)`, Legendre's polynomials at :math:`y = 1-2(\pi a/\lambda)^2`.

    Parameters
    ----------
    pitch : float
        lambda [m].
    """

    pitch: Positive

    @property
    def reach(self) -> float:
        """As `LineBed.reach`; on gradings no closer to a sharp valley than a smooth profile is told from it."""
        known = self.profile.reach
        sharp = math.isfinite(known) and has_tail(self.medium.response)
        return min(known, (1.0 - VALLEY) * self.pitch / math.pi) if sharp else known

    def _phase(self, place: float) -> float:
        """Return pi x / lambda of a place over u [m]."""
        return math.pi / self.pitch * float(from_line(np.array(place), self.pitch))

    def felt(self, phase: float, across: float, count: int) -> Waves:
        """Return the waves of the pitch, and M / m, as in `strip_harmonics.harmonics`."""
        response = self.medium.response
        if has_tail(response):
            return harmonics(response, self.pitch, phase, across, count)
        most = math.ceil(0.5 * DECAY_SPAN * self.pitch / (math.pi * response.length))
        if most > MOST_HARMONICS:
            raise OutsideValidity(
                f"A pitch of {self.pitch:.6g} m is too long for an uppermost layer whose response fades over "
                f"{response.length:.6g} m: {most} waves would be felt, {MOST_HARMONICS} at most; give a thicker layer."
            )
        number = np.arange(1.0, most + 1.0)
        k = 2.0 * math.pi / self.pitch * number
        return Waves(k, response.excess(k) / number, np.zeros(0), np.zeros(0))

    def own_transforms(self, half_width: Array, k: Array) -> Array:
        """Return the transforms of the half-planes' pressures over E* [m] at the waves ``(a, m)``."""
        modes, number = self.own_modes(half_width), np.round(0.5 * self.pitch / math.pi * k)
        if modes is not None:
            used = 1 + int(np.max(np.nonzero(np.any(modes != 0.0, axis=0))[0], initial=0))
            phases = map(self._phase, half_width.tolist())
            return np.stack([m[:used] @ harmonic_rows(p, used, number) for m, p in zip(modes, phases, strict=True)])
        if has_tail(self.medium.response):
            raise OutsideValidity(
                "PeriodicIndentation: strips under a profile with a tip, a kink or a fractional power are not resolved "
                "on a grading, whose waves fall slowly; give a smooth profile, or a CoatedHalfSpace of layers that "
                "follow it."
            )
        found = np.empty((half_width.size, k.size))
        for row, a in zip(found, half_width.tolist(), strict=True):
            widths, loads = punches(self.half_plane, a, float(k[-1]))
            level = 1.0 - 2.0 * (math.pi / self.pitch * widths) ** 2
            before, now = np.ones(widths.size), level
            for m in range(k.size):
                row[m] = 0.5 * float(loads @ (before + now))
                before, now = now, ((2.0 * m + 3.0) * level * now - (m + 1.0) * before) / (m + 2.0)
        return found

    def _equation(self, half_width: Array, count: int) -> tuple[Array, Array]:
        """Return A and the right-hand side of `strip_equation`, sums in the place of integrals."""
        coupled, pressed = np.empty((half_width.size, count, count)), np.empty((half_width.size, count))
        slopes = self.half_plane.load_profile_slope(half_width)
        for place, a in enumerate(half_width.tolist()):
            phase = self._phase(a)
            found = self.felt(phase, phase, count)
            rows = harmonic_rows(phase, count, np.round(0.5 * self.pitch / math.pi * found.k))
            weighted = rows * found.weights
            coupled[place] = weighted @ rows.T
            pressed[place] = weighted @ self.own_transforms(half_width[place : place + 1], found.k)[0]
            if found.shorter.size:
                sides, closing = far_harmonics(phase, count, 0.5 * self.pitch / math.pi * found.shorter)
                for side, end in zip(sides, closing, strict=True):
                    coupled[place] += (side * found.shares) @ side.T
                    pressed[place] += (side * found.shares) @ (slopes[place] * self.pitch * end)
        return coupled, pressed

    @property
    def alike(self) -> tuple[object, ...]:
        """As in `LayeredLineFoundation`, with the pitch."""
        return (self.profile, self.pitch, *in_own_lengths(self.medium.response))

    def solved(self, half_width: Array) -> StripResponse:
        """Return what the layers add under strips [m]."""
        response, first_wave = self.medium.response, np.array([2.0 * math.pi / self.pitch])
        octave = max(0.0, float(np.log2(np.max(half_width) / response.smooth)))
        most, falling = MOST_MODES, (TAIL_IN_LOAD * response.precision, TAIL_AT_EDGE)
        if not has_tail(response):
            most, falling = self.felt(1.0, 1.0, 0).k.size + 1 + TAIL, (0.0, 0.0)  # no wave has more modes
        borne = np.abs(self.own_transforms(half_width, first_wave)[:, 0])
        strips = Strips(from_line(half_width, self.pitch), borne, lambda count: self._equation(half_width, count))
        first = min(FIRST_MODES + 8 * math.ceil(octave), most)
        return settled_strips(strips, first, VANISHED * 2.0 ** (0.5 * octave), most, falling)

    def mode_transforms(self, half_width: float, count: int, k: Array) -> Array:
        """Return the transforms of so many modes that each bear one, at the waves `felt`."""
        return harmonic_rows(self._phase(half_width), count, np.round(0.5 * self.pitch / math.pi * k))

    def gaps(self, half_width: float, end: float) -> tuple[Array, Array]:
        """As `LayeredLineFoundation.gaps`; the edge alone where M falls like 1 / xi and strips all but touch."""
        if has_tail(self.medium.response) and not resolves(0.5 * math.pi - self._phase(half_width)):
            return np.array([half_width]), np.zeros(1)
        return LayeredLineFoundation.gaps(self, half_width, end)

    def sunk(self, x: Array, carried: Carried) -> Array:
        """Return by how much less the layers below let the surface sink at places u >= a [m] than at the edge."""
        at_edge, places = (from_line(np.asarray(u), self.pitch) for u in (carried.half_width, x))
        phase, across = (math.pi / self.pitch * float(np.max(place)) for place in (at_edge, places))
        found = self.felt(phase, across, 0)
        weights = 2.0 / np.pi * found.weights * self.transform(found.k, carried)
        return np.asarray(np.cos(found.k * at_edge) @ weights - wave_sums(np.cos, places, found.k, weights))

    def waves_below(self, half_width: float, rim_load: float, farthest: float) -> PlaneWaves:
        """Return the pressure of all strips as waves; an even load of `rim_load` E* per strip beside them.

        The even part of the load is the wave that is long against all depths.
        """
        found, carried = self.felt(self._phase(half_width), 0.5 * math.pi, 0), self.carried(half_width, 0.0)
        level = 2.0 / self.pitch * self.medium.modulus
        load = float(self.load_profile(np.array([half_width]))[0]) + rim_load
        k = np.append(LONGEST / max(self.medium.response.span, self.pitch), found.k)
        return PlaneWaves(k, level * np.append(0.5 * load, self.transform(found.k, carried)))


@value
class ZonedLayers(Zone, LayeredLineFoundation):
    """A line contact on layers, and the attraction beside one strip of it."""

    def __post_init__(self) -> None:
        LayeredLineFoundation.__post_init__(self)
        self._refuse_sticking_grading()

    @property
    def half_plane(self) -> ZonedBed:
        """The same on a half-plane of the uppermost layer."""
        plain = LayeredLineFoundation(self.profile, self.medium).half_plane
        return plain.zoned(self.strength, self.contact, self.outer)

    @property
    def alike(self) -> tuple[object, ...]:
        """Itself: the attraction is no part of the modulus."""
        return (self,)

    def own_modes(self, half_width: Array) -> None:
        """None: the stress beside the strip is no mode of its pressure."""

    def own_transforms(self, half_width: Array, k: Array) -> Array:
        """Return the transform of the half-plane's pressure and of the attraction."""
        widths, loads = self.half_plane.beside(self.contact)
        pulled = _of_punches(widths[None, :], loads[None, :], k)
        return LayeredLineFoundation.own_transforms(self, half_width, k) + pulled

    def beside(self, half_width: float) -> tuple[Array, Array]:
        """Return half-widths [m] of flat punches beside the strip, and their loads over E* [m]."""
        return self.half_plane.beside(half_width)


def _felt(response: WaveResponse, extent: float) -> Waves:
    """Return the waves that places and half-widths up to an extent [m] feel."""
    return waves(response, int(octaves(response, np.array([extent]))[0]))


def _of_punches(widths: Array, loads: Array, k: Array) -> Array:
    """Return the transforms of flat punches that bear loads ``(a, n)`` [m] at wave numbers ``(a, k)``."""
    from scipy.special import j0

    parts = chunks(widths.shape[0], widths.shape[1] * k.size)
    return np.concatenate([np.einsum("akn,an->ak", j0(widths[i, None, :] * k[:, None]), loads[i]) for i in parts])


def _zones(bed: LayeredLineFoundation, half_width: Array, span: Array, strength: float) -> EndedZones:
    """Return strips beside which a stress [Pa] attracts over the spans l [m]."""
    bed._refuse_sticking_grading()
    response, plain, outer = bed.medium.response, bed.half_plane, np.hypot(half_width, span)
    ends = dict(zip(half_width.tolist(), span.tolist(), strict=True))
    node, weight = gauss_legendre(
        LEAST_NODES + math.ceil(0.5 * DECAY_SPAN / response.length * float(np.max(span, initial=0.0)))
    )

    def pressed(a: Array, k: Array) -> Array:
        reach = np.array([ends[one] for one in a.tolist()])[:, None]
        widths = np.sqrt(a[:, None] ** 2 + reach**2 * (1.0 - node**2))
        pulled = _of_punches(widths, -2.0 * strength / bed.medium.modulus * reach * weight, k)
        touching = a > 0.0
        pulled[touching] += bed.own_transforms(a[touching], k)
        return pulled

    gap, load = plain.zone_gap(half_width, span, strength)[0], plain.zone_load(half_width, span, strength)
    edge = plain.load_profile_slope(half_width) + 2.0 * strength / bed.medium.modulus * half_width / span
    closing, added = np.zeros(half_width.size), np.zeros((2, half_width.size, 1))
    (strips,) = np.nonzero(half_width > 0.0)
    if strips.size:
        found = strip_responses(response, half_width[strips], pressed, np.zeros(strips.size))
        added = np.zeros((2, half_width.size, found.closing.shape[1]))
        added[:, strips] = found
        load = load + added[0, :, 0]
        edge[strips] = (edge[strips] - edge_fall(found.closing, half_width[strips])) / np.sum(found.punch, axis=1)
        for i in strips:
            gap[i] -= lowered(added[0, i], float(half_width[i]), outer[i : i + 1])[0]
            closing[i] += lowered(added[1, i], float(half_width[i]), outer[i : i + 1])[0]
    groups = octaves(response, 0.5 * (half_width + outer))
    for octave in np.unique(groups):
        (own,) = np.nonzero(groups == octave)
        wave, a = waves(response, int(octave)), half_width[own]
        rows = bessel_rows(a[:, None] * wave.k, added.shape[2])
        modes = np.einsum("man,nak->mak", added[:, own] * signs(added.shape[2]), rows)
        apart = 2.0 / np.pi * wave.weights * (np.cos(a[:, None] * wave.k) - np.cos(outer[own, None] * wave.k))
        gap[own] -= np.sum(apart * (modes[0] + pressed(a, wave.k)), axis=1)
        closing[own] += np.sum(apart * modes[1], axis=1)
    return EndedZones(gap, load, edge, closing)


def _touching(half_width: Array, alone: Array, found: Callable[[Array, Array], Array]) -> Array:
    """Return `alone`, and where strips have a width [m] what is found of that and of `alone`."""
    there, result = half_width > 0.0, np.array(alone)
    if there.any():
        result[there] = found(half_width[there], result[there])
    return result


@functools.lru_cache(maxsize=256)
def _carried(bed: LayeredLineFoundation, half_width: float, rim_load: float) -> Carried:
    one = np.array([half_width])
    found = added_responses(bed, one)
    own = bed.own_modes(one)
    added = found.closing[0] + rim_load * found.punch[0]
    return Carried(half_width, None if own is None else own[0], added, rim_load * float(np.sum(found.punch[0])))
