r"""Heat through a rough joint: through the spots that touch, and through what fills the gap between them.

On a spot the interface holds back :math:`1/h_i`, in the gap u a layer of conductivity :math:`\lambda_g` as thick as
:math:`u+M`, with M for the jumps of temperature at walls of a rarefied gas.  Heat then spreads in both bodies,

.. math:: r\,q+\frac{1}{2\pi}\left(\frac1{\lambda_1}+\frac1{\lambda_2}\right)\int\frac{q}{|\mathbf r-\mathbf r'|}\,
          \mathrm dA' = \Delta T ;

platings change the response to the heat flux (`winkler.media.conduction.spot_resistances`).
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.loading.path import numbers_of
from winkler.materials.conducting_body import resistivity_of, surface_of
from winkler.media.conduction.conductors import HeatConductors
from winkler.media.conduction.spot_resistances import plated_surface
from winkler.numerics.films.joint_flux import JointFlux, joint_flux
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.pressed_maps.seal_states import gap_of
from winkler.problems.pressed_maps.second_points import measured
from winkler.problems.rough.map_conductors import plating_notes, refuse_bodies
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.values.checks.number_checks import NonNegative
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

YOVANOVICH = "M. M. Yovanovich, IEEE Trans. Compon. Packag. Technol. 28 (2005) 182-206, doi:10.1109/TCAPT.2005.848483"


@value
class ThermalJoint(PerLoad[Q]):
    """Heat flow through the contact spots and the gap of a height map pressed against a flat.

    Parameters
    ----------
    contact : SurfaceContact
        The mechanical contact.
    conductors : HeatConductors
        Thermal conductors of the bodies, thick and plated or not, and the resistance of their interface.
    gap_conductivity : float, optional
        Conductivity of the medium in the gap [W/(m K)]: 0.026 for air, 0.6 for water, 0 (the default) for a vacuum.
    jump_distance : float, optional
        Temperature jump distance of rarefied gas [m], sum over both walls: about 0.4 um for air at 1 bar on metals.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type, a number is negative, or an empty gap has a jump distance.
    OutsideValidity
        If a body is a rod, or a plating is thinner than 1e-7 of the map.

    References
    ----------
    M. M. Yovanovich, IEEE Trans. Compon. Packag. Technol. 28 (2005) 182-206, doi:10.1109/TCAPT.2005.848483;
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038

    Examples
    --------
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.rough.random_rough import random_topography
    >>> from winkler.profiles.rough.spectrum import SelfAffine
    >>> rough = random_topography(SelfAffine(0.8, 1e-6, 1e-3, 6e-5), (64, 64), [1e-3, 1e-3], seed=1)
    >>> contact = SurfaceContact(rough, HalfSpace.between(Elastic(70e9, 0.3), Elastic(70e9, 0.3)), Force(3.0))
    >>> aluminium = HeatConductors(ThermalConductor(200.0, 8e-5), ThermalConductor(200.0, 8e-5))
    >>> joint = ThermalJoint(contact, aluminium, gap_conductivity=0.026).solve()
    >>> bool(joint.gap_conductance > 0.0), bool(joint.conductance > joint.spot_conductance)
    (True, True)
    """

    __words__ = words(
        contact=("", None, "how the surface is pressed"),
        gap_conductivity=(r"\lambda_g", "W/(m K)", "conductivity of what fills the gap; 0 of a vacuum"),
        jump_distance=("M", "m", "by how much rarefied gas widens the gap"),
    )

    contact: SurfaceContact[Q]
    conductors: HeatConductors
    gap_conductivity: NonNegative = 0.0
    jump_distance: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("yovanovich_2005", "barber_2003", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.CONDUCTION, Assumption.STEADY}

    def __post_init__(self) -> None:
        if self.jump_distance > 0.0 and self.gap_conductivity == 0.0:
            raise InvalidInput(
                f"ThermalJoint: a jump distance of {self.jump_distance:g} m is of a gas, and the gap is empty; give "
                "its gap_conductivity, or leave jump_distance out."
            )
        refuse_bodies("ThermalJoint", self.conductors, float(np.max(self.contact.topography.lengths)))

    @property
    def _spreading(self) -> float:
        return sum(resistivity_of(surface_of(body)) for body in (self.conductors.first, self.conductors.second))

    def passing(self, state: SurfaceState) -> JointFlux:
        """Return the heat flux of every pixel per kelvin [W/(m^2 K)].

        Raises
        ------
        NotConverged
            If the iteration does not converge.
        OutsideValidity
            If the pixels are too coarse for the platings.
        """
        rough, between = self.contact.topography, self.conductors.interface.area_resistance
        gap = gap_of(state.pressure, state.separation)
        thick = gap + self.jump_distance
        open_gap = thick / self.gap_conductivity if self.gap_conductivity > 0.0 else np.full(gap.shape, np.inf)
        resistance = np.where(state.pressure > 0.0, between, open_gap)
        if rough.periodic and not np.any(resistance > 0.0):
            return JointFlux(np.full(gap.shape, np.inf), np.inf, 0.0)
        layers = plated_surface(self.conductors.first, self.conductors.second)
        return joint_flux(resistance, rough.pixel, self._spreading, periodic=rough.periodic, layers=layers)

    def solve(self) -> ThermalJointSolution[Q]:
        """Return the conductance under every load.

        Raises
        ------
        NotConverged
            If a contact, or the heat through it, is not solved to its tolerance.
        OutsideValidity
            If the pixels are too coarse for the platings.
        """

        def parted(state: SurfaceState) -> tuple[float, float, float]:
            try:
                found = self.passing(state)
            except NotConverged as error:
                raise NotConverged(f"ThermalJoint: under the force {state.force:.6g} N, {error}") from None
            except OutsideValidity as error:
                raise OutsideValidity(f"ThermalJoint: of the platings, {error}") from None
            touching = state.pressure > 0.0
            parts = float(np.sum(found.flux[touching])), float(np.sum(found.flux[~touching]))
            if not np.isfinite(found.whole):  # a closed periodic map without an interface holds nothing back
                return found.whole, found.whole, 0.0
            share = parts[1] / sum(parts)
            return found.whole, (1.0 - share) * found.whole, share * found.whole

        contact, rows = measured(self.contact, parted)
        shape = numbers_of(self.contact.load).shape
        columns: list[Q] = [shaped(np.array(column).reshape(shape)) for column in zip(*rows, strict=True)]
        return ThermalJointSolution(
            self, contact, contact.depth, contact.force, contact.area, contact.mean_gap, *columns
        )  # fmt: skip


@value
class ThermalJointSolution(PerLoad[Q]):
    """The solution of a `ThermalJoint`; quantities have the shape of the load.

    Parameters
    ----------
    problem : ThermalJoint
        The problem that was solved.
    contact : SurfaceContactSolution
        The contact, with its maps under the last load.
    depth, force, area, mean_gap : float or ndarray
        As in `SurfaceContactSolution` [m], [N], [m^2], [m].
    conductance : float or ndarray
        Heat rate per drop of temperature [W/K].  For a periodic map: of one period, without the temperature drop of the
        same bodies in perfect contact. It is infinite for full contact without an interface.
    spot_conductance, gap_conductance : float or ndarray
        Conductance of the contact spots, and of the gap [W/K].
    """

    __words__ = words(
        contact=("", None, "the contact by boundary elements"),
        conductance=(r"\Lambda", "W/K", "heat rate over temperature drop"),
        resistance=("R", "K/W", "temperature drop over heat rate"),
    )

    problem: ThermalJoint[Q]
    contact: SurfaceContactSolution[Q]
    depth: Q
    force: Q
    area: Q
    mean_gap: Q
    conductance: Q
    spot_conductance: Q
    gap_conductance: Q

    @property
    def resistance(self) -> Q:
        """Drop of temperature over heat rate [K/W]."""
        return shaped(1.0 / np.asarray(self.conductance))

    @property
    def joint_conductance(self) -> Q:
        """Conductance per area of the map [W/(m^2 K)]."""
        return shaped(np.asarray(self.conductance) / self.problem.contact.topography.area)

    def flux(self) -> Array:
        """Return the heat flux per kelvin under the last load [W/(m^2 K)], (nx, ny)."""
        return self.problem.passing(self.contact.last).flux

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, the spots on its grid, the gap, steady heat."""
        stated = self.problem
        blurred = float(np.max(np.asarray(self.contact.area_error) / np.asarray(self.area)))
        through = float(np.max(np.asarray(self.gap_conductance) / np.asarray(self.conductance)))
        filled = (
            f"The medium in the gap conducts heat with {stated.gap_conductivity:.3g} W/(m K) over the width of the gap"
            + (
                f" plus a temperature jump distance of {stated.jump_distance:.3g} m"
                if stated.jump_distance > 0.0
                else ""
            )
            + f". This medium carries up to {through:.0%} of the heat. Radiation across the gap is neglected."
            if stated.gap_conductivity > 0.0
            else "No heat passes through the gap; radiation is neglected."
        )
        return (
            *self.contact.validity,
            *plating_notes(stated.conductors, stated.contact.medium, stated.contact.topography),
            Note(
                Assumption.CONDUCTION,
                Standing.APPROXIMATE if blurred > 0.05 else Standing.ASYMPTOTIC,
                f"{filled} The contact area consists of whole pixels: the conductance of a single round spot "
                f"has a relative error of about {blurred:.1g}.",
                YOVANOVICH,
            ),
            Note(
                Assumption.STEADY,
                Standing.ASYMPTOTIC,
                "Heat conduction is assumed to be steady, between thick bodies with constant properties. No heat "
                "leaves through other surfaces.",
                "H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd edition, Oxford 1959",
            ),
        )
