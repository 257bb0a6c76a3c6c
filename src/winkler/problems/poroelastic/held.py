r"""An indenter held at a constant depth on a poroelastic half-space: the force relaxes as the liquid flows out.

At first the liquid cannot leave, and the body is incompressible; at last the network bears the force alone.  The time
is that of diffusion across the contact, :math:`a^2/D`, so that it depends on the depth; that of a viscoelastic body
does not.
"""

from __future__ import annotations

from typing import ClassVar

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.poroelastic.relaxation_table import GREATEST_POISSON, relaxed_share
from winkler.profiles.conical import Cone
from winkler.profiles.flat import FlatPunch
from winkler.profiles.power import Paraboloid
from winkler.profiles.sphere import Sphere
from winkler.values.checks.number_checks import Positive, PositiveRow
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

HeldProfile = Paraboloid | Sphere | Cone | FlatPunch


@value
class PoroelasticRelaxation:
    """Force relaxation of a poroelastic body at constant depth.

    Parameters
    ----------
    profile : Paraboloid, Sphere, Cone or FlatPunch
        The indenter: rigid, without friction, impermeable.
    shear : float
        G [Pa], positive, of the network and of the body as a whole.
    poisson : float
        nu [-] of the drained network, 0 to 0.49.
    diffusivity : float
        D [m^2/s], positive: 2 G (1 - nu)/(1 - 2 nu) times permeability over viscosity.
    depth : float
        d [m], positive.
    time : ndarray, (steps,)
        Time since loading [s], positive.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    References
    ----------
    Y. Hu, X. Zhao, J. J. Vlassak, Z. Suo, Appl. Phys. Lett. 96 (2010) 121904, doi:10.1063/1.3370354
    Y. Lai, Y. Hu, Soft Matter 13 (2017) 852-861

    Examples
    --------
    >>> import numpy as np
    >>> gel = PoroelasticRelaxation(FlatPunch(1e-3), 1e3, 0.25, 1e-9, depth=1e-4, time=[1e-6, 1e12])
    >>> np.round(gel.solve().force * 1e6)  # 8 G a d at first, 8 G a d / (2 (1 - nu)) at last
    array([800., 533.])
    """

    __words__ = words(
        diffusivity=("D", "m^2/s", "effective diffusivity of the liquid in the network"),
        poisson=(r"\nu", "", "Poisson's ratio of the drained network"),
    )

    profile: HeldProfile
    shear: Positive
    poisson: float
    diffusivity: Positive
    depth: Positive
    time: PositiveRow

    references: ClassVar[tuple[str, ...]] = ("hu_zhao_vlassak_suo_2010", "lai_hu_2017", "mcnamee_gibson_1960")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING

    def __post_init__(self) -> None:
        if not 0.0 <= self.poisson <= GREATEST_POISSON:
            raise InvalidInput(
                f"PoroelasticRelaxation: poisson is {self.poisson!r}; give that of the drained network, from 0 to "
                f"{GREATEST_POISSON}: an incompressible network holds its liquid."
            )

    def solve(self) -> PoroelasticSolution:
        """Return the decrease of the force with time.

        Returns
        -------
        PoroelasticSolution
        """
        contact = held_contact(self.profile, self.depth, self.shear)
        first, radius = float(contact.force), float(contact.radius)
        last = first / (2.0 * (1.0 - self.poisson))
        share = relaxed_share(shape_of(self.profile), self.diffusivity * self.time / radius**2, self.poisson)
        return PoroelasticSolution(self, last + (first - last) * share, radius, first, last)


@value
class PoroelasticSolution:
    """The solution of a `PoroelasticRelaxation`.

    Parameters
    ----------
    problem : PoroelasticRelaxation
        The problem that was solved.
    force : ndarray, (steps,)
        F_N [N].
    radius : float
        a [m], assumed constant.
    first_force, last_force : float
        F_N [N] immediately after loading, and after the liquid has stopped flowing.
    """

    __words__ = words(
        first_force=("F_0", "N", "force at once, before the liquid flows"),
        last_force=(r"F_\infty", "N", "force when the liquid is at rest"),
        relaxation_time=("a^2/D", "s", "time of diffusion across the contact"),
    )

    problem: PoroelasticRelaxation
    force: Array
    radius: float
    first_force: float
    last_force: float

    @property
    def time(self) -> Array:
        """Time since loading [s], as prescribed."""
        return self.problem.time

    @property
    def relaxation_time(self) -> float:
        """a^2 / D [s]."""
        return self.radius**2 / self.problem.diffusivity

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        contact = held_contact(problem.profile, problem.depth, problem.shear)
        grows = not isinstance(problem.profile, FlatPunch)
        error = "0.03" if grows else "0.01"
        growth = "The contact radius is assumed constant, though it grows a little. " if grows else ""
        share = Note(
            Assumption.RESPONSE,
            Standing.APPROXIMATE,
            f"Biot's theory of an impermeable indenter on a freely draining body. {growth}The relaxing part of "
            f"the force has an error of {error} of the whole relaxing part.",
            "dual integral equations; Lai and Hu",
        )
        return (*contact.validity, share)


def held_contact(profile: HeldProfile, depth: float, shear: float) -> IndentationSolution:
    """Return the contact at first, of an incompressible body with a shear modulus [Pa]."""
    medium = HalfSpace.between(Elastic(3.0 * shear, 0.5))
    return Indentation(Foundation(profile, medium), Depth(depth)).solve()


def shape_of(profile: HeldProfile) -> str:
    """Return the shape by which the force relaxes."""
    return "flat" if isinstance(profile, FlatPunch) else "cone" if isinstance(profile, Cone) else "ball"
