r"""The bed of a line contact on layers: a two-dimensional profile on a coated half-plane or a strip on a rigid base.

The layers are isotropic or transversely isotropic, bonded or sliding, or a body is graded with depth: only their
responses count.

The uppermost layer's half-plane carries :math:`E^*w(a)` as it does without layers; what the others add is the
correction :math:`\beta` of `winkler.numerics.transforms.strip_equation`, with which

.. math:: P(a) = E^*\,(w(a) + \beta_0) , \qquad
          \frac{\mathrm dP}{\mathrm da} = E^*\,\frac{w'(a) - \frac2a\sum n^2\beta_n}{\sum\pi_n} ;

:math:`\pi` are the modes of a flat punch that bears a load of one: as the strip widens by da it adds a flat punch whose
edge is as steep as the pressure falls there.  A traction moves the surface along as a pressure sinks it, with the
response to shear along the wave for that to pressures.
"""

from __future__ import annotations

import functools
from typing import Annotated, ClassVar, NamedTuple, cast

import numpy as np

from winkler.checks.number_checks import Advice
from winkler.errors import OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.foundation.strip_waves import smooth_modes, transforms
from winkler.media.layered.coated import CoatedHalfSpace, SlidingFilm, StackedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.layered.depth_response import GradedBody
from winkler.media.layered.plane_interior import PlaneLayers, PlaneMedium
from winkler.media.layered.stack import Layered
from winkler.media.layered.wave_constants import Body, Wave
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.numerics.caching import cached_by_value
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.surfaces.strip_elements import by_hats
from winkler.numerics.transforms import strip_punches
from winkler.numerics.transforms.cosine_transform import WaveResponse, faded
from winkler.numerics.transforms.layered_strips import LayeredStrips
from winkler.numerics.transforms.strip_equation import StripResponse, Waves, octaves, strip_responses, waves
from winkler.numerics.transforms.strip_modes import (
    along_surface,
    bessel_rows,
    lowered,
    potential_of_modes,
    pressure_of_modes,
    signs,
)
from winkler.numerics.types import Array, Curve
from winkler.profiles.profile import Profile
from winkler.values import value

__all__ = ["Carried", "LayeredLineFoundation"]

WIDEST = 1024.0
"""Greatest half-width over the thickness of the uppermost layer."""
PAIRS_PER_CHUNK = 1_000_000
KERNEL_TOLERANCE = 1e-12
"""Error of what the layers add to the displacement of an element, over its greatest value."""
SUMMED = 2e-15
"""Rounding of a sum of waves, over the sum of their sizes."""
MOST_KEPT = 4096
"""Half-widths whose modes are kept of one bed."""
MOST_EXAMINED = 16
"""Half-widths of many whose contacts are examined for tension and overlap."""
PLACES_BESIDE = np.geomspace(1e-3, 1.0, 25)[:-1]
"""Where the distance beside a strip is examined, between its edge and the farthest place."""


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
        The gap f between the undeformed bodies, as of `LineFoundation`.
    medium : CoatedHalfSpace, StackedHalfSpace, SlidingFilm, DepthGradedHalfSpace or PlaneMedium
        Layers, each bonded to what lies below it or sliding there, on a half-plane or a rigid base, or a body graded
        with depth; against a homogeneous body.

    References
    ----------
    P. Meijers, Appl. Sci. Res. 18 (1968) 353-383, doi:10.1007/BF00382359;
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 5.8, doi:10.1017/CBO9781139171731
    """

    profile: Profile
    medium: Annotated[
        CoatedHalfSpace | StackedHalfSpace | SlidingFilm | DepthGradedHalfSpace | PlaneMedium,
        Advice("homogeneous bodies go into a LineFoundation"),
    ]

    search_step: ClassVar[float] = 1.5
    punches_push: ClassVar[bool] = False

    def __post_init__(self) -> None:
        _ = self.half_plane

    @property
    def half_plane(self) -> LineFoundation:
        """The same profile on a half-plane of the uppermost layer."""
        return LineFoundation(self.profile, TransverselyIsotropicHalfSpace(self.layered_body.top, self.medium.second))

    @property
    def layered_body(self) -> Layered:
        """The layered body, as what it answers to waves."""
        return cast(PlaneMedium, self.medium).response.first

    @property
    def layered(self) -> PlaneLayers:
        """The medium, if it has layers.

        Raises
        ------
        OutsideValidity
            If it is a grading, in which stresses are not known.
        """
        if isinstance(self.layered_body, GradedBody):
            raise OutsideValidity(
                "Stresses below a line contact are known in layers and homogeneous bodies; in the place of the grading "
                "give a CoatedHalfSpace of layers that follow it."
            )
        return cast(PlaneLayers, self.medium)

    def refuse_dragged(self, friction: float) -> None:
        """Refuse friction [-] where a layer slides on what lies below it."""
        if friction != 0.0:
            _ = self.medium.along_modulus

    @property
    def surfaces(self) -> tuple[Body, Body]:
        """The solid of the uppermost layer, and the second body."""
        return self.layered_body.top, self.medium.second

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
        half_width = np.asarray(half_width, dtype=float)
        result = self.half_plane.load_profile(half_width)
        touching = half_width > 0.0
        if touching.any():
            result[touching] += _responses(self, half_width[touching]).closing[:, 0]
        return result

    def load_profile_slope(self, half_width: Array) -> Array:
        """Return its derivative by the half-width [-]."""
        half_width = np.asarray(half_width, dtype=float)
        result = self.half_plane.load_profile_slope(half_width)
        touching = half_width > 0.0
        if touching.any():
            found = _responses(self, half_width[touching])
            order = np.arange(found.closing.shape[1])
            inner = 2.0 / half_width[touching] * (found.closing @ order**2)
            result[touching] = (result[touching] - inner) / np.sum(found.punch, axis=1)
        return result

    def carried(self, half_width: float, rim_load: float) -> Carried:
        """Return the pressure of a strip, as modes.

        Parameters
        ----------
        half_width : float
            a [m], positive.
        rim_load : float
            As of `pressure`.
        """
        return _carried(self, half_width, rim_load)

    def pressure(self, x: Array, half_width: float, rim_load: float) -> Array:
        """Return the pressure [Pa], as of `LineFoundation.pressure`."""
        carried = self.carried(half_width, rim_load)
        found = self.medium.modulus * pressure_of_modes(carried.modes, half_width, x, carried.edge)
        if carried.own is None:
            found = found + self.half_plane.pressure(x, half_width, 0.0)
        return np.asarray(found)

    def mean_pressures(self, edges: Array, half_width: float, rim_load: float) -> Array:
        """Return the mean pressure [Pa] between places, as of `LineBed.mean_pressures`."""
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
        """Return how far tractions move the middles of elements along, as of `LineBed.shear_compliance`."""
        far = 0.5 * (edges[1:] + edges[:-1])[:, None] - edges
        unit = float(edges[-1])
        found = waves(self.medium.along_response, int(octaves(self.medium.along_response, np.array([unit]))[0]))
        turns = fit_panels(lambda t: _turns(found, unit * t) / unit, np.array([0.0, 2.0]), KERNEL_TOLERANCE)
        lifted = np.sign(far) * turns(np.abs(far) / unit)
        added = -2.0 / np.pi * self.along_share * np.diff(lifted, axis=1)
        return LineBed.shear_compliance(self, edges) + added

    def hat_compliance(self, count: int, spacing: float, reference: float) -> Array:
        """Return the displacement [m] by a hat of tractions, as of `LineBed.hat_compliance`."""
        response, away = self.medium.along_response, spacing * np.arange(count + 1.0)
        _ = self.medium.coupling_response  # what rolls on a grading would need it, and is refused
        found = waves(response, int(octaves(response, away[-1:])[0]))
        evened = np.sinc(found.k * spacing / (2.0 * np.pi)) ** 2  # the transform of a hat, over its area
        near = faded(response, reference) - float(np.sum(found.weights * (1.0 - evened)))
        step = max(1, PAIRS_PER_CHUNK // found.k.size)
        half = [np.sin(0.5 * np.outer(away[i : i + step], found.k)) for i in range(0, away.size, step)]
        felt = near - np.concatenate([part**2 @ (2.0 * found.weights * evened) for part in half])
        plain = LineBed.hat_compliance(self, count, spacing, reference)
        return np.asarray(plain + 2.0 / np.pi * self.along_share * spacing * felt)

    def slopes(self, part: Wave, nodes: Array, x: Array) -> Array:
        """Return slopes of the surfaces by tractions straight between nodes, as of `LineBed.slopes`."""
        names = {Wave.NORMAL: "response", Wave.ALONG: "along_response", Wave.COUPLING: "coupling_response"}
        response: WaveResponse = getattr(self.medium, names[part])  # a layer that slides refuses some
        far = x[:, None] - nodes
        _ = self.medium.coupling_response  # as in `hat_compliance`
        octave = int(octaves(response, np.array([0.5 * float(np.max(np.abs(far)))]))[0])
        unit = response.length * 2.0**octave
        if part is Wave.COUPLING:
            lifted = unit * _bends(response, octave)(np.abs(far) / unit)
        else:
            share = self.along_share if part is Wave.ALONG else 1.0
            lifted = -share * unit * np.sign(far) * _twists(response, octave)(np.abs(far) / unit)
        return LineBed.slopes(self, part, nodes, x) + 2.0 / np.pi * by_hats(lifted, nodes)

    def drawn(self, x: Array, half_width: float) -> Array:
        """Return how far the pressure moves the first surface beyond the second [m], as of `LineBed.drawn`."""
        response = self.medium.coupling_response
        found = waves(response, int(octaves(response, np.array([max(half_width, float(np.max(np.abs(x))))]))[0]))
        weights = -2.0 / np.pi * found.weights * self.transform(found.k, self.carried(half_width, 0.0))
        return LineBed.drawn(self, x, half_width) + np.sin(np.multiply.outer(x, found.k)) @ weights

    def stuck_compliance(self, half_width: float, unit: float) -> float:
        """Return the displacement of a strip that sticks, as of `LineBed.stuck_compliance`."""
        response, one = self.medium.along_response, np.array([half_width])
        found = waves(response, int(octaves(response, one)[0]))
        punch = strip_responses(response, one, lambda a, k: np.zeros((a.size, k.size)), np.zeros(1)).punch[0]
        rows = bessel_rows(found.k * half_width, punch.size)
        felt = float(((punch * signs(punch.size)) @ rows * rows[0] - 1.0) @ found.weights)
        felt += float((np.sum(punch) / (np.pi * found.shorter * half_width) - 1.0) @ found.shares)
        return LineBed.stuck_compliance(self, half_width, unit) + 2.0 / np.pi * self.along_share * felt

    def punch_edges(self, half_width: Array) -> tuple[Array, Array]:
        """Return how steep flat punches are that press and that push, as of `LineBed.punch_edges`."""
        self._refuse_worn_grading()
        pressed, pushed = (
            strip_punches.edge(of, half_width) for of in (self.medium.response, self.medium.along_response)
        )
        return pressed, pushed

    def _refuse_worn_grading(self) -> None:
        if isinstance(self.layered_body, GradedBody):
            raise OutsideValidity(
                "Lines wear on layers and on homogeneous bodies; flat punches of all widths on a grading, whose waves "
                "fall slowly, are not built in: give a CoatedHalfSpace of layers that follow it."
            )

    def grid_transforms(self, nodes: Array) -> LayeredStrips:
        """Return the transforms of worn contacts between nodes [m]."""
        self._refuse_worn_grading()
        return LayeredStrips(nodes, self.medium.response)

    def shear_transforms(self, nodes: Array) -> LayeredStrips:
        """Return the same of tractions along the strip's width."""
        self._refuse_worn_grading()
        return LayeredStrips(nodes, self.medium.along_response)

    def opening(self, x: Array, half_width: float) -> Array:
        """Return the slope h'(x) [-] of the distance of the surfaces at x > a, by small differences."""
        step = 1e-4 * half_width
        beyond, before = (self.separation(place, half_width, 0.0) for place in (x + step, np.maximum(x - step, 0.0)))
        return np.asarray((beyond - before) / (2.0 * step))

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
        """Return the potential F [Pa] and F' [Pa/m] of the half-plane below the surface, as of `LineFoundation`."""
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
        _responses(self, chosen)  # at once, not one by one
        return np.asarray(chosen)

    def gaps(self, half_width: float, end: float) -> tuple[Array, Array]:
        """Return places beside a strip up to `end` [m], and the distance of the surfaces there [m]."""
        x = half_width + (end - half_width) * PLACES_BESIDE
        return x, self.separation(x, half_width, 0.0)

    def transform(self, k: Array, carried: Carried) -> Array:
        """Return the cosine transform of a pressure over E* [m] at wave numbers k [1/m]."""
        rows = bessel_rows(k * carried.half_width, carried.modes.size)
        found = (carried.modes * signs(carried.modes.size)) @ rows
        if carried.own is None:
            found = found + transforms(self.half_plane, np.array([carried.half_width]), k)[0]
        return np.asarray(found)

    def sunk(self, x: Array, carried: Carried) -> Array:
        """Return by how much less the layers below let the surface sink at places x >= a [m] than at the edge."""
        response = self.medium.response
        extent = np.array([0.5 * (float(np.max(x)) + carried.half_width)])
        found = waves(response, int(octaves(response, extent)[0]))
        weights = 2.0 / np.pi * found.weights * self.transform(found.k, carried)
        at_edge = float(np.cos(found.k * carried.half_width) @ weights)
        step = max(1, PAIRS_PER_CHUNK // found.k.size)
        parts = [np.cos(np.outer(x[i : i + step], found.k)) @ weights for i in range(0, x.size, step)]
        return np.asarray(at_edge - np.concatenate(parts))


def _turns(found: Waves, x: Array) -> Array:
    """Return the integral of M (sin kx - kx) / k^2 by k [m], twice integrated from the middle."""
    step, flat = max(1, PAIRS_PER_CHUNK // found.k.size), x.ravel()
    rows = [np.sin(np.outer(flat[i : i + step], found.k)) @ (found.weights / found.k) for i in range(0, x.size, step)]
    return np.concatenate(rows).reshape(x.shape) - x * float(np.sum(found.weights) + np.sum(found.shares))


@cached_by_value(64)
def _twists(response: WaveResponse, octave: int) -> Panels:
    """Return the integral of M (sin kx - kx) / k^2 by k as of x, both over the greatest half-width of the octave."""
    found, unit = waves(response, octave), response.length * 2.0**octave
    return _panels(lambda t: _turns(found, unit * t) / unit, found)


@cached_by_value(64)
def _bends(response: WaveResponse, octave: int) -> Panels:
    """Return the same of M (1 - cos kx) / k^2."""
    found, unit = waves(response, octave), response.length * 2.0**octave

    def bent(t: Array) -> Array:
        flat, step = unit * t.ravel(), max(1, PAIRS_PER_CHUNK // found.k.size)
        half = [np.sin(0.5 * np.outer(flat[i : i + step], found.k)) for i in range(0, flat.size, step)]
        return np.concatenate([part**2 @ (2.0 * found.weights / found.k) for part in half]).reshape(t.shape) / unit

    return _panels(bent, found)


def _panels(function: Curve, found: Waves) -> Panels:
    """Return a sum of these waves from 0 to 2 as panels, no more precise than its rounding."""
    greatest = float(np.max(np.abs(function(np.array([1.0, 2.0])))))
    rounding = SUMMED * float(np.sum(np.abs(found.weights)))
    return fit_panels(function, np.array([0.0, 2.0]), max(KERNEL_TOLERANCE * max(1.0, greatest), rounding))


@functools.lru_cache(maxsize=16)
def _kept(bed: LayeredLineFoundation) -> dict[float, tuple[Array, Array]]:
    """Return the responses of the last half-widths; it fills itself."""
    return {}


def _responses(bed: LayeredLineFoundation, half_width: Array) -> StripResponse:
    """Return what the layers add under strips of these half-widths; those solved before are kept."""
    kept, places = _kept(bed), half_width.tolist()
    missing = np.array(sorted({a for a in places if a not in kept}))
    if missing.size:
        if len(kept) > MOST_KEPT:
            kept.clear()
            missing = np.unique(half_width)
        response, top = bed.medium.response, bed.layered_body.unit[1]
        if response.smooth == response.length and missing[-1] > WIDEST * top:
            raise OutsideValidity(
                f"LayeredLineFoundation: a strip of the half-width {missing[-1]:.6g} m is more than {WIDEST:.0f} times "
                f"as wide as the uppermost layer is thick ({top:.6g} m); press less, or leave so thin a layer out."
            )
        plain = bed.half_plane
        slopes = plain.load_profile_slope(missing)
        solved = strip_responses(bed.medium.response, missing, lambda a, k: transforms(plain, a, k), slopes)
        kept.update(zip(missing.tolist(), zip(solved.closing, solved.punch, strict=True), strict=True))
    rows = [kept[a] for a in places]
    result = StripResponse(*np.zeros((2, len(rows), max(closing.size for closing, _ in rows))))
    for place, (closing, punch) in enumerate(rows):
        result.closing[place, : closing.size], result.punch[place, : punch.size] = closing, punch
    return result


@functools.lru_cache(maxsize=256)
def _carried(bed: LayeredLineFoundation, half_width: float, rim_load: float) -> Carried:
    one = np.array([half_width])
    found = _responses(bed, one)
    own = smooth_modes(bed.half_plane, one)
    added = found.closing[0] + rim_load * found.punch[0]
    return Carried(half_width, None if own is None else own[0], added, rim_load * float(np.sum(found.punch[0])))
