"""A strip that has begun to roll: the state after so many elements, and what is assumed of the grid."""

from __future__ import annotations

import numpy as np

from winkler.numerics.surfaces.strip_grid import StripStep
from winkler.numerics.types import Array
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

ELEMENTS = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Stick and slip are computed with boundary elements and Coulomb's law. With 80 elements on the half-width the "
    "steady creepage differs from Carter's by at most 0.2 %. This holds for shear forces of 10 to 90 % of mu P; "
    "outside this range the difference is 0.6 %. With twice as many elements the errors are half as large. Yield is "
    "evaluated for the steady state.",
    "compared with Carter's closed form; J. J. Kalker, J. Appl. Mech. 37 (1970) 677-688",
)
ELEMENTS_ON_LAYERS = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Stick and slip are computed with boundary elements, Coulomb's law and the shear response of the layers. With 80 "
    "elements on the half-width the steady creepage differs from that of `LineRolling` by at most 0.4 %. This holds "
    "for shear forces of 10 to 90 % of mu P; outside this range the difference is 0.6 %. With twice as many elements "
    "the errors are half as large. Yield is evaluated for full sliding.",
    "compared with singular integral equations of the steady state; J. J. Kalker, J. Appl. Mech. 37 (1970) 677-688",
)
DRAGGED = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "The pressure displaces the surfaces tangentially, because the bodies or their layers are dissimilar. The "
    "solution includes this displacement. At the start the whole normal load is assumed to have been applied in "
    "one step. The contact does not approach the solution `steady`, which neglects this displacement.",
    "R. H. Bentall, K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404; compared with CONTACT",
)


@value
class LineRollingState:
    """A contact that has rolled so far.

    Parameters
    ----------
    distance, longitudinal_creepage, shear_force_per_length, stick_share : float
        As in `LineRollingStartSolution`.
    x : ndarray, (n,)
        Places of the nodes [m], the leading edge at +a.
    traction : ndarray, (n,)
        q on the first body along the direction of rolling [Pa].
    """

    __words__ = words(stick_share=("c/a", "", "part of the width that sticks"))

    distance: float
    longitudinal_creepage: float
    shear_force_per_length: float
    stick_share: float
    x: Array
    traction: Array


def rolled_state(distance: float, step: StripStep, apart: float, modulus: float, x: Array) -> LineRollingState:
    """Return the state after a step, its elements `apart` [m] from each other."""
    return LineRollingState(
        distance=distance,
        longitudinal_creepage=step.shift / apart,
        shear_force_per_length=modulus * apart * float(np.sum(step.traction)),
        stick_share=float(np.mean(step.slips == 0)),
        x=x,
        traction=modulus * step.traction,
    )
