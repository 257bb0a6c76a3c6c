r"""Heat through a contact: the same constriction as for a current, with temperature for voltage.

:math:`Q = 4\lambda_h a\,\Delta T` with :math:`1/\lambda_h = 1/\lambda_1+1/\lambda_2` for a round contact, and
:math:`Q = \frac{2\lambda_h}{E^*}\frac{\mathrm dF}{\mathrm dd}\Delta T` for a contact of any shape between homogeneous
elastic bodies: steady conduction, nothing lost around the contact.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.materials.conducting_body import parts_of
from winkler.materials.conductor import ThermalConductor
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import CONDUCTING
from winkler.problems.conduction.disc import conducting_disc
from winkler.problems.conduction.solution import ConductingSolution
from winkler.problems.normal.indentation import Indentation
from winkler.values.checks.number_checks import Finite
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words


@value
class ThermalConstriction(PerLoad[Q]):
    """Heat flow between two bodies of different temperature pressed together.

    Parameters
    ----------
    contact : Indentation
        The mechanical contact, on a Foundation, PlaneFoundation, EllipticFoundation, or MeasuredBed (a contact of any
        shape). For an array of loads the results have its shape.
    conductors : HeatConductors
        Thermal conductors of the bodies, and the resistance of their interface.
    temperature_drop : float
        Temperature of the first body far away less that of the second [K].

    Raises
    ------
    InvalidInput
        If an argument has the wrong type.

    References
    ----------
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Radius
    >>> from winkler.materials.conductor import ThermalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(Elastic(210e9, 0.3)))
    >>> steel = ThermalConductor(conductivity=45.0)
    >>> pressed, pair = Indentation(bed, Radius(1e-4)), HeatConductors(steel, steel)
    >>> joint = ThermalConstriction(pressed, pair, temperature_drop=10.0).solve()
    >>> round(joint.heat_rate, 6)  # 4 lambda_h a dT
    0.09
    """

    __words__ = words(contact=("", None, "how the bodies are pressed together"))

    contact: Indentation[Q]
    conductors: HeatConductors
    temperature_drop: Finite

    references: ClassVar[tuple[str, ...]] = ("barber_2003", "holm_1967", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = CONDUCTING | {Assumption.STEADY}
    needs_round: ClassVar[str] = ""

    def solve(self) -> ThermalConstrictionSolution[Q]:
        """Return the heat rate and its resistances.

        Returns
        -------
        ThermalConstrictionSolution

        Raises
        ------
        OutsideValidity
            As for `winkler.problems.conduction.constriction.Constriction.solve`.
        """
        contact, parts = conducting_disc(self.contact, self.conductors)
        heat = self.temperature_drop / parts.whole
        shape = np.shape(contact.radius)
        return ThermalConstrictionSolution(
            self,
            contact,
            resistance=shaped(parts.whole, shape),
            constriction=shaped(parts.first + parts.second, shape),
            interface_resistance=shaped(parts.film, shape),
            bulk_resistance=parts.bulk,
            heat_rate=shaped(heat, shape),
            first_drop=shaped(_drop(heat, parts.first, parts.bulk_first), shape),
            second_drop=shaped(_drop(heat, parts.second, parts.bulk_second), shape),
        )


def _drop(heat: Array, constriction: Array, bulk: float) -> Array:
    """Return the drop of temperature in one body; none where no heat flows."""
    flowing = heat != 0.0
    return np.where(flowing, heat * (np.where(flowing, constriction, 0.0) + bulk), 0.0)


@value
class ThermalConstrictionSolution(ConductingSolution["ThermalConstrictionSolution[float]", Q]):
    """The solution of a `ThermalConstriction`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : ThermalConstriction
        The problem that was solved.
    contact : IndentationSolution
        The contact, of the shape of the load.
    resistance : float or ndarray
        Temperature drop over heat rate [K/W], all parts in series; infinite without contact.
    constriction : float or ndarray
        Constriction resistance of both bodies [K/W].
    interface_resistance : float or ndarray
        1 / (h pi a^2) [K/W].
    bulk_resistance : float
        Resistance of the lengths of rods [K/W]; zero without rods.
    heat_rate : float or ndarray
        Q [W], from the first body to the second.
    first_drop, second_drop : float or ndarray
        Temperature drop within each body [K].
    """

    __words__ = words(
        resistance=("R", "K/W", "temperature drop over heat rate"),
        conductance=(r"\Lambda", "W/K", "heat rate over temperature drop"),
        constriction=("R_c", "K/W", "part that the narrow contact makes"),
        bulk_resistance=("R_b", "K/W", "part that the length of rods makes"),
        heat_rate=("Q", "W", "heat per time, from the first body to the second"),
    )

    problem: ThermalConstriction[Q]
    constriction: Q
    interface_resistance: Q
    bulk_resistance: float
    heat_rate: Q
    first_drop: Q
    second_drop: Q

    @property
    def conductance(self) -> Q:
        """Heat rate per drop of temperature [W/K]; zero without contact."""
        return shaped(1.0 / np.asarray(self.resistance))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the heat rate can be trusted."""
        bodies = self.problem.conductors.first, self.problem.conductors.second
        rates = [part.diffusivity for body in bodies for part in parts_of(body) if isinstance(part, ThermalConductor)]
        settling = 10.0 * float(np.max(self.radius, initial=0.0)) ** 2 / min(rates)
        known = f"{settling:.3g} s" if max(rates) < math.inf else "an unknown time"
        steady = Note(
            Assumption.STEADY,
            Standing.ASYMPTOTIC,
            f"Steady state is assumed. The steady state is reached within 9 % after {known}, ten times the squared "
            "contact radius over the diffusivity. Transients are not included.",
            "H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd edition, Oxford 1959",
        )
        return (*self._disc_notes, steady)
