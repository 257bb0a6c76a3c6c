"""What many contacts went through, and how far that can be trusted."""

from __future__ import annotations

from winkler.numerics.types import Array
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

POPOV = "V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6"
SPRINGS = Note(
    Assumption.RESOLUTION,
    Standing.APPROXIMATE,
    "The shear force is that of n springs in the contact. The relative error of the force is 1/4n^2 at full "
    "sliding, that of the stiffness 1/2n without slip.",
    "sums of midpoints; comparison with the exact solver of one direction",
)
PLANE = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "If the direction of motion changes, the springs follow the vector rule. This rule is not exact even for "
    "tractions along the motion. Its error is of first order in the steps.",
    POPOV,
)
SIMILAR = Note(
    Assumption.UNCOUPLED,
    Standing.ASYMPTOTIC,
    "The bodies are assumed elastically similar: contacts have moduli only, not Dundurs' constant. Tangential "
    "with the same medium states the error of this assumption.",
    POPOV,
)
UNCOUPLED = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Shear, twist and rolling are uncoupled: each may use up the whole friction. Partial slip in twist and in "
    "rolling is neglected. No exact law of their combination is known.",
    POPOV,
)


@value
class ContactTrace:
    """Loads, displacements and forces of many contacts, step by step.

    Parameters
    ----------
    depth : ndarray, (contacts, steps)
        d [m] after every step.
    force : ndarray, (contacts, steps)
        F_N [N].
    shear_force : ndarray, (contacts, steps, 2)
        [N].
    torque : ndarray, (contacts, steps)
        M_z [N m].
    rolling_moment : ndarray, (contacts, steps, 2)
        [N m].
    stored_energy : ndarray, (contacts, steps)
        Of shear, twist and rolling [J].
    dissipation : ndarray, (contacts, steps)
        Dissipated energy since the beginning [J].
    """

    depth: Array
    force: Array
    shear_force: Array
    torque: Array
    rolling_moment: Array
    stored_energy: Array
    dissipation: Array
