"""Captions of the pictures of the method: title and one sentence."""

from __future__ import annotations

CAPTIONS = {
    "shape": (
        "The body in three dimensions",
        "The body is cut open. The contact has a red rim; darker colours mean higher pressure.",
    ),
    "medium": (
        "The medium",
        "The solid over the depth, or the measured curve, and the stiffness of the springs.",
    ),
    "springs": (
        "The equivalent plane profile over its springs",
        "Every spring under g(x) − d is compressed independently; nothing else has to be solved.",
    ),
    "line_load": (
        "The load of the springs",
        "q(x), the compression times the stiffness of the springs; the area below it is the force.",
    ),
    "pressure": ("The pressure", "p(r) of the three-dimensional contact, computed from the springs."),
    "displacement": (
        "The surface",
        "Displacement of the surface inside and outside the contact, and the gap between the surfaces.",
    ),
    "stress": (
        "The stress below the surface",
        "Equivalent stress after von Mises; where it is greatest, yielding begins.",
    ),
    "depths": (
        "Stresses below the contact",
        "Maximum stress of each kind at each depth, without friction.",
    ),
    "force": ("Force over depth", "F(d) from first touch to this load, the point."),
}
"""Picture of the method -> its title, and one sentence."""

ADHESIVE_CAPTIONS = {
    "springs": (
        CAPTIONS["springs"][0],
        "Springs are compressed in the middle and stretched at the edge, where they separate.",
    ),
    "line_load": (
        CAPTIONS["line_load"][0],
        "q(x), the compression times the stiffness of the springs; the area of stretched springs counts negative.",
    ),
    "pressure": (
        CAPTIONS["pressure"][0],
        "p(r) of the three-dimensional contact, computed from the springs; below zero the surfaces pull.",
    ),
    "force": (
        CAPTIONS["force"][0],
        "All states of equilibrium around this one, the point; on the solid part they are stable.",
    ),
}
"""The captions of adhesive contacts that differ."""


def captions_of(*, sticks: bool) -> dict[str, tuple[str, str]]:
    """Return picture of the method -> its title and one sentence, for adhesive contacts or others."""
    return CAPTIONS | (ADHESIVE_CAPTIONS if sticks else {})
