"""A strip that has begun to roll: the state after so many elements, and what is assumed of the grid."""

from __future__ import annotations

import numpy as np

from winkler.numerics.surfaces.strip_grid import StripStep
from winkler.numerics.types import Array
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

__all__ = ["DRAGGED", "ELEMENTS", "ELEMENTS_ON_LAYERS", "LineRollingState", "rolled_state"]

ELEMENTS = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Boundary elements with Coulomb friction. With 80 elements on half of the contact the steady creepage has an "
    "error of up to 0.2 % of Carter's. This holds from a tenth to nine tenths of the force of sliding; beyond, it is "
    "0.6 %. The error halves with twice as many; yielding is that of the steady state.",
    "compared with Carter's closed form; J. J. Kalker, J. Appl. Mech. 37 (1970) 677-688",
)
ELEMENTS_ON_LAYERS = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Boundary elements with Coulomb friction and the response of the layers to shear. With 80 elements on half of "
    "the contact the steady creepage differs by up to 0.4 % from that of `LineRolling`. This holds from a tenth to "
    "nine tenths of the force of sliding; beyond, it is 0.6 %. The error halves with twice as many; the stresses of "
    "yielding are those of a contact that slides.",
    "compared with singular integral equations of the steady state; J. J. Kalker, J. Appl. Mech. 37 (1970) 677-688",
)
DRAGGED = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "The pressure displaces the surfaces tangentially, since the bodies or their layers are dissimilar. This is "
    "included; at rest as if all of the load had come in one step. They do not come to the state that `steady` "
    "states, in which it does not.",
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
