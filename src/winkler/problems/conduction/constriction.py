r"""Contact resistance: current converges on the spot where two bodies touch.

Barber's analogy makes stiffness and conductance of a contact proportional,

.. math:: \frac1R = \frac{2}{E^*(\rho_1+\rho_2)}\,\frac{\mathrm dF}{\mathrm dd},

for homogeneous elastic bodies of any shape: every spring in contact conducts :math:`2/(\rho_1+\rho_2)` per length, and
the resistance of a line of length 2 a is Holm's :math:`(\rho_1+\rho_2)/(4a)`.  On layered or graded elastic bodies the
springs differ and the analogy ends, but a disc of radius a remains a disc.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.media.conduction.conductors import ElectricalConductors
from winkler.numerics.types import PerLoad, Q, shaped
from winkler.problems.assumptions.declared import CONDUCTING
from winkler.problems.conduction.disc import conducting_disc, mean_free_path_note
from winkler.problems.conduction.solution import ConductingSolution
from winkler.problems.normal.indentation import Indentation
from winkler.values.checks.number_checks import NonNegative
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class Constriction(PerLoad[Q]):
    """Electrical contact resistance of two conductors pressed together.

    Parameters
    ----------
    contact : Indentation
        The mechanical contact, on a Foundation, PlaneFoundation, EllipticFoundation, or MeasuredBed (a contact of any
        shape). For an array of loads the results have its shape.
    conductors : ElectricalConductors
        Conductors of the bodies, and the film between them.
    mean_free_path : float, optional
        Mean free path of the electrons [m], not negative; a note states the resulting error of the resistance. Zero
        (the default) leaves the note out.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type.

    References
    ----------
    R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.conductor import ElectricalConductor
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> silver = Elastic(young=83e9, poisson=0.37)
    >>> bed = Foundation(Paraboloid(2e-3), HalfSpace.between(silver, silver))
    >>> pair = ElectricalConductors(ElectricalConductor(15.9e-9), ElectricalConductor(15.9e-9))
    >>> contact = Constriction(Indentation(bed, Force(1.0)), pair).solve()
    >>> round(contact.resistance * 1e3, 4)  # milliohm
    0.2525
    """

    __words__ = words(contact=("", None, "how the bodies are pressed together"))

    contact: Indentation[Q]
    conductors: ElectricalConductors
    mean_free_path: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("holm_1967", "barber_2003", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = CONDUCTING
    needs_round: ClassVar[str] = ""

    def solve(self) -> ConstrictionSolution[Q]:
        """Return the resistance and its parts.

        Returns
        -------
        ConstrictionSolution

        Raises
        ------
        OutsideValidity
            If the load is tensile, is beyond the reach of the profile, or gives a contact that is not a disc. If the
            contact is nearly as wide as a rod. If there is a film or a plating and the contact area is not known.
        """
        contact, parts = conducting_disc(self.contact, self.conductors)
        shape = np.shape(contact.radius)
        return ConstrictionSolution(
            self,
            contact,
            resistance=shaped(parts.whole, shape),
            first_constriction=shaped(parts.first, shape),
            second_constriction=shaped(parts.second, shape),
            film_resistance=shaped(parts.film, shape),
            bulk_resistance=parts.bulk,
        )


@value
class ConstrictionSolution(ConductingSolution["ConstrictionSolution[float]", Q]):
    """The solution of a `Constriction`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : Constriction
        The problem that was solved.
    contact : IndentationSolution
        The contact, of the shape of the load.
    resistance : float or ndarray
        R [ohm], all parts in series; infinite without contact.
    first_constriction, second_constriction : float or ndarray
        Constriction resistance of each body [ohm].
    film_resistance : float or ndarray
        Area resistance of the film over the area of the contact [ohm].
    bulk_resistance : float
        Resistance of the lengths of rods [ohm]; zero without rods.
    """

    problem: Constriction[Q]
    first_constriction: Q
    second_constriction: Q
    film_resistance: Q
    bulk_resistance: float

    @property
    def conductance(self) -> Q:
        """1 / R [S]; zero without contact."""
        return shaped(1.0 / np.asarray(self.resistance))

    @property
    def constriction(self) -> Q:
        """Constriction resistance of both bodies [ohm]."""
        return shaped(np.asarray(self.first_constriction) + self.second_constriction)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the resistance can be trusted: the analogy, the bodies, the film, mean free path of the electrons."""
        radius = np.asarray(self.radius, dtype=float)
        return (*self._disc_notes, *mean_free_path_note(radius, self.problem.mean_free_path))
