"""Loads: a prescribed force, depth or radius; along the surface a shift, shear force, angle or torque.

A line contact takes a force per length, a half-width or a mean pressure, a wavy surface a nominal pressure, and along
the surface a shear force per length; a roller may be tilted, or find its tilt under a moment.

A load's value may be an array; the result then has its shape.  Taken apart by ``match``.  How loads change with time is
a `winkler.loading.path.Path`.
"""

from __future__ import annotations

from typing import Annotated

from winkler.numerics.types import PerLoad, Q
from winkler.values.checks.number_checks import (
    FINITE_QUANTITY,
    NON_NEGATIVE_QUANTITY,
    Finite,
    between,
)
from winkler.values.value import value, words


@value
class Force(PerLoad[Q]):
    """A prescribed normal force.

    Parameters
    ----------
    force : float or ndarray
        [N], compression positive.
    """

    force: Annotated[Q, FINITE_QUANTITY]


@value
class Depth(PerLoad[Q]):
    """A prescribed indentation depth: how far the bodies have approached since first touch.

    Parameters
    ----------
    depth : float or ndarray
        [m], approach positive; below zero the bodies are apart.
    """

    depth: Annotated[Q, FINITE_QUANTITY]


@value
class Radius(PerLoad[Q]):
    """A prescribed contact radius.

    Parameters
    ----------
    radius : float or ndarray
        [m], not negative.
    """

    __words__ = words(radius=("a", "m", "prescribed radius of the contact"))

    radius: Annotated[Q, NON_NEGATIVE_QUANTITY]


@value
class LineForce(PerLoad[Q]):
    """A prescribed normal force per length of a line contact.

    Parameters
    ----------
    force_per_length : float or ndarray
        P [N/m], compression positive.
    """

    force_per_length: Annotated[Q, FINITE_QUANTITY]


@value
class LineShearForce(PerLoad[Q]):
    """A prescribed tangential force per length of a line contact, perpendicular to the line.

    Parameters
    ----------
    shear_force_per_length : float or ndarray
        Q [N/m].
    """

    shear_force_per_length: Annotated[Q, FINITE_QUANTITY]


@value
class HalfWidth(PerLoad[Q]):
    """A prescribed half-width of a line contact.

    Parameters
    ----------
    half_width : float or ndarray
        a [m], not negative.
    """

    half_width: Annotated[Q, NON_NEGATIVE_QUANTITY]


@value
class MeanPressure(PerLoad[Q]):
    """A prescribed mean pressure of a line contact, over its whole width.

    Parameters
    ----------
    mean_pressure : float or ndarray
        p_m = P/(2 a) [Pa], not negative.
    """

    mean_pressure: Annotated[Q, NON_NEGATIVE_QUANTITY]


@value
class Tilt:
    """A prescribed tilt of a roller on its raceway, or of a section on a half-plane.

    Parameters
    ----------
    tilt : float
        [rad], positive where it presses the end at positive x; between -1.5 and 1.5, and small for the theory to hold.
    """

    __words__ = words(tilt=(r"\theta", "rad", "tilt of the body"))

    tilt: Annotated[float, between(-1.5, 1.5)]


@value
class Moment:
    """A prescribed moment of the pressure about the middle of a roller; the roller tilts until this moment is reached.

    Parameters
    ----------
    moment : float
        [N m], positive if the end at positive x carries more; zero for a self-aligning roller.
    """

    moment: Finite


@value
class LineOfAction:
    """Position of the force per length on a section; the body tilts until its moment is balanced.

    Parameters
    ----------
    place : float
        [m] along the surface.
    """

    __words__ = words(place=("x_P", "m", "where the force acts"))

    place: Finite


@value
class NominalPressure(PerLoad[Q]):
    """A prescribed mean pressure over the whole wavy surface, both inside and outside the contact.

    Parameters
    ----------
    nominal_pressure : float or ndarray
        P/pitch [Pa], not negative.
    """

    nominal_pressure: Annotated[Q, NON_NEGATIVE_QUANTITY]


@value
class Shift(PerLoad[Q]):
    """A prescribed relative tangential displacement of the bodies.

    Parameters
    ----------
    shift : float or ndarray
        u_x [m]; on a path in the plane one row ``(u_x, u_y)`` for every point.
    """

    shift: Annotated[Q, FINITE_QUANTITY]


@value
class ShearForce(PerLoad[Q]):
    """A prescribed tangential force.

    Parameters
    ----------
    shear_force : float or ndarray
        F_x [N]; on a path in the plane one row ``(F_x, F_y)`` for every point.
    """

    shear_force: Annotated[Q, FINITE_QUANTITY]


@value
class Angle(PerLoad[Q]):
    """A prescribed relative rotation of the bodies about the contact axis.

    Parameters
    ----------
    angle : float or ndarray
        phi [rad].
    """

    angle: Annotated[Q, FINITE_QUANTITY]


@value
class Torque(PerLoad[Q]):
    """A prescribed torque about the axis of the contact.

    Parameters
    ----------
    torque : float or ndarray
        M_z [N m].
    """

    torque: Annotated[Q, FINITE_QUANTITY]


Load = Force | Depth | Radius
"""What may be prescribed."""
Normal = Depth | Force
"""What may be prescribed across the surface, along a path."""
Lateral = Shift | ShearForce | Angle | Torque
"""What may be prescribed along the surface."""
