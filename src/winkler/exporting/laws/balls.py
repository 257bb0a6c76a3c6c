"""A contact of two balls with friction, twist and rolling, as `Contacts` has it, as a law for other programs."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.exporting.step_law import LawTable, StatePart, StepLaw, StepNumber
from winkler.numerics.types import Array
from winkler.problems.particles.ball_step import step_ball
from winkler.problems.particles.contacts import Contacts
from winkler.values.errors import InvalidInput

BALL_MOTION = (
    StepNumber("depth", "m", "d at the end of the step, not positive without contact"),
    StepNumber("motion_x", "m", "by which the bodies move along the surface in the step", True),
    StepNumber("motion_y", "m", "the same across", True),
    StepNumber("twist", "rad", "by which they turn about the normal in the step", True),
    StepNumber("roll_x", "rad", "by which they roll over each other in the step", True),
    StepNumber("roll_y", "rad", "the same across", True),
)
BALL_ANSWER = (
    StepNumber("force", "N", "normal force, compression positive"),
    StepNumber("shear_x", "N", "shear force that moves the bodies along the motion"),
    StepNumber("shear_y", "N", "the same across"),
    StepNumber("torque", "N m", "moment that holds up the twist"),
    StepNumber("rolling_x", "N m", "moment that holds up the rolling"),
    StepNumber("rolling_y", "N m", "the same across"),
    StepNumber("radius", "m", "contact radius"),
    StepNumber("stored_energy", "J", "of shear, twist and rolling"),
    StepNumber("dissipation", "J", "heat since the beginning; never falls"),
)
STEPS, SEED = 60, 20260724


def ball_law(contacts: Contacts, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of contacts that are all alike.

    Raises
    ------
    InvalidInput
        If they differ, or one of them has been moved already.
    """
    words = ("modulus", "torsional_modulus", "curvature_radius", "coefficient", "rolling_arm", "reach", "shear_modulus")
    for word in words:
        if np.unique(getattr(contacts, word)).size != 1:
            raise InvalidInput(
                f"export: the contacts differ in {word}; a law is exported for one kind of contact, so export Contacts "
                "of one pair."
            )
    if np.any(contacts.displaced != 0.0) or np.any(contacts.dissipation != 0.0) or np.any(contacts.depth > 0.0):
        raise InvalidInput("export: the contacts have been moved already; export Contacts.apart(...).")
    law = ball_rows(contacts)[0]
    count = contacts.displaced.shape[1]
    first = 0.25 * float(contacts.reach[0]) / count**2
    begins = f"Friction begins at a depth of {first:.2g} m, where the first spring touches; more bring it nearer to 0."
    tables = (LawTable("law", LAW_MEANING, law),)
    state = (
        StatePart("displaced", "springs along the surface [m], from the axis to the edge", np.zeros((count, 2))),
        StatePart("twisted", "elastic part of the twist [rad]", np.zeros(1)),
        StatePart("rolled", "elastic part of the rolling [rad]", np.zeros(2)),
        StatePart("past", "depth before the step [m], heat so far [J]", np.zeros(2)),
    )
    return StepLaw(
        "Two balls: Hertz' force, friction by springs that stick and slip, twist and rolling",
        step_ball,
        tables,
        state,
        BALL_MOTION,
        BALL_ANSWER,
        (begins, *(str(note) for note in dataclasses.replace(contacts, depth=contacts.reach).validity)),
        inputs,
        _trial(law),
    )


LAW_MEANING = (
    "E* [Pa], G_t [Pa], R [m], mu, rolling arm [m], greatest depth [m], distance of the springs [m], tangential "
    "stiffness of one [N/m], how far a slipping spring is displaced over its compression"
)


def ball_rows(contacts: Contacts) -> Array:
    """Return the numbers of the law of each contact, ``(contacts, 9)``, as `step_ball` takes them."""
    count = contacts.displaced.shape[1]
    words = ("modulus", "torsional_modulus", "curvature_radius", "coefficient", "rolling_arm", "reach")
    slope = contacts.coefficient * contacts.modulus / contacts.shear_modulus
    columns = [getattr(contacts, word) for word in words]
    return np.column_stack([*columns, contacts.spacing(count), contacts.single(count), slope])


def _trial(law: Array) -> Array:
    """Return motions that stick, slip, part and touch again."""
    rng = np.random.default_rng(SEED)
    reach, radius = law[5], law[2]
    depth = reach * np.clip(0.5 + 0.6 * np.cumsum(rng.normal(scale=0.25, size=STEPS)), -0.2, 1.0)
    sliding = 0.5 * max(law[3], 0.1) * reach
    turning = sliding / np.sqrt(radius * reach)
    moves = rng.normal(scale=sliding, size=(STEPS, 2))
    return np.column_stack([depth, moves, rng.normal(scale=turning, size=(STEPS, 3))])
