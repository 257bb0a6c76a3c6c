r"""The common base of media whose springs all relax by the same function of time.

Its equivalent profile g does not change in time.  What the springs of the elastic medium alike would bear, and how far
they are pressed in, then give the fields: pressure and stresses are those of the elastic medium whose springs are
displaced by :math:`b(x,t)=\int\varphi(t-t')\,\partial u(x,t')/\partial t'\,\mathrm dt'`, displacements those of the
elastic medium whose springs are displaced by u itself, also where they recover outside the contact: every transform is
linear, and the same at all times.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Protocol

import numpy as np

from winkler.media.medium import Displacement, Medium, PunchFacts
from winkler.media.offers import PlaneMedium, offers
from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array, ComplexArray
from winkler.profiles.profile import Profile
from winkler.values.checks.contract import offered
from winkler.values.errors import OutsideValidity

if TYPE_CHECKING:  # layers are loaded with media that have some
    from winkler.media.layered.wave_constants import Wave
    from winkler.media.offers import PairWaves
    from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries

LEE = "E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020"


def relaxes(medium: object) -> bool:
    """Return whether a medium relaxes, by whatever law: it has no single value of its moduli, and says so."""
    return hasattr(medium, "timeless")


@offered("one that relaxes, such as ViscoelasticHalfSpace(first, second)")
class RelaxingMedium(Protocol):
    """An elastic medium times a function of time: whoever has these members is asked as such, of whatever class."""

    in_proportion: ClassVar[bool] = True
    """Whether all parts relax alike, so that g does not change; layers with laws of their own do not."""

    @property
    def elastic(self) -> Medium:
        """The medium as if it were elastic."""
        raise NotImplementedError

    @property
    def bodies(self) -> Any:
        """What names the solids of the bodies: the medium itself, unless it is made of another one."""
        return self

    @property
    def relaxation(self) -> RelaxationSeries:
        """By what the elastic medium is multiplied after a step of depth."""
        raise NotImplementedError

    @property
    def creep(self) -> CreepSeries:
        """By what its compliance is multiplied after a step of force."""
        raise NotImplementedError

    @property
    def span(self) -> tuple[float, float]:
        """From which time on and up to which the series are the solids [s]."""
        raise NotImplementedError

    def waves(self, part: Wave, xi: Array, s: ComplexArray) -> ComplexArray:
        """What both surfaces answer to waves at Laplace's s: compliance times xi / 2 [1/Pa].

        Parameters
        ----------
        part : Wave
            What moves, and what pulls; of `Wave.COUPLING` the first body less the second.
        xi : ndarray
            Wave numbers, real and positive [1/m]; infinite for the shortest waves.
        s : ndarray
            Rates [1/s], not negative or imaginary, broadcast with xi; infinite for a sudden step of solids.

        Raises
        ------
        OutsideValidity
            If the medium does not know this part.
        """
        raise NotImplementedError

    def timeless(self) -> OutsideValidity:
        """Return the error of a call that requests a single value."""
        return OutsideValidity(
            f"{type(self).__name__}: its stiffness changes in time, so no single value exists; use "
            "ViscoelasticIndentation(bed, path), with friction Tangential or Torsion, whose path has cycles, on lines "
            "LineViscoelasticIndentation(bed, path) or LineTangential, on height maps SurfaceTangential, or an elastic "
            "medium."
        )

    def elastic_parts(self, displacement: Displacement) -> tuple[Displacement, ...]:
        """Return what elastic springs would bear the same; refuse springs without memory."""
        borne = getattr(displacement, "borne", None)
        if not isinstance(borne, tuple):
            raise self.timeless()
        return borne

    def gap(self, profile: Profile, x: Array) -> Array:
        """g(x) [m], at all times."""
        return self.elastic.gap(profile, x)

    def gap_slope(self, profile: Profile, x: Array) -> Array:
        """g'(x) [-]."""
        return self.elastic.gap_slope(profile, x)

    def kinks(self, profile: Profile) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` of every place where g is not smooth."""
        return self.elastic.kinks(profile)

    def punch_facts(self, radius: float) -> PunchFacts:
        """What is known of all flat punches up to this radius [m]."""
        return self.elastic.punch_facts(radius)

    def _changing(self, *_: Any, **__: Any) -> Any:
        """There is none that would hold at all times."""
        raise self.timeless()

    gap_load = punch_stiffness = punch_pressure = _changing  # type: ignore[misc]
    normal_stiffness = normal_stiffness_slope = tangential_stiffness = _changing  # type: ignore[misc]

    def pressure(self, displacement: Displacement, r: Array) -> Array:
        """p(r) [Pa] of springs with a history."""
        parts = [self.elastic.pressure(part, r) for part in self.elastic_parts(displacement)]
        return np.asarray(sum(parts, np.zeros(np.shape(r))))

    def displacement(self, displacement: Displacement, r: Array) -> Array:
        """The displacement of the surface [m], inside and outside the contact, sum over both bodies."""
        return self.elastic.displacement(displacement, r)

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z >= 0 into it."""
        raise NotImplementedError


class RelaxingLayers(RelaxingMedium, Protocol):
    """Layers that relax, as of `PlaneMedium`: what does not change in time; there are no moduli at all times."""

    described: ClassVar[str]
    """What notes call it, the beginning of a sentence."""

    @property
    def response(self) -> PairWaves:
        """Of the elastic layers to a pressure: a wave over the shortest ones; refuse other bodies."""
        if not offers(self.bodies, PlaneMedium):
            raise OutsideValidity(
                f"{type(self).__name__}: line contacts do not support the layers of a "
                f"{type(self.bodies).__name__}; give layers or a DepthGradedHalfSpace, or a homogeneous body as "
                "LineFoundation(profile, ViscoelasticHalfSpace(solid))."
            )
        return self.bodies.response

    modulus = along_modulus = property(RelaxingMedium._changing)  # type: ignore[misc]
    along_response = coupling_response = property(RelaxingMedium._changing)  # type: ignore[misc]
