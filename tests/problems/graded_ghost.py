"""A body graded with depth that belongs to no family of media."""

from __future__ import annotations

import dataclasses

import winkler as wk


def delegated(name):
    return property(lambda self: getattr(self.of, name))


@dataclasses.dataclass(frozen=True)
class Ghost:
    """A grading that belongs to no family."""

    of: wk.DepthGradedHalfSpace
    second, thickness, modulus, along_modulus = (
        delegated(name) for name in ("second", "thickness", "modulus", "along_modulus")
    )
    response, along_response, coupling_response = (
        delegated(name) for name in ("response", "along_response", "coupling_response")
    )
