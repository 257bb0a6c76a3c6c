r"""Angles of a regular pyramid of N faces, all measured from its axis unless stated otherwise.

- Face angle :math:`\theta`: between axis and face, in the plane through the axis that is perpendicular to the edge of
  the base.  It is half of the angle between opposite faces.
- Edge angle :math:`\theta_e`: between axis and edge, :math:`\tan\theta_e=\tan\theta/\cos(\pi/N)`.
- The angle between face and base plane is :math:`\pi/2-\theta`.

Heights above the apex are :math:`f = \max_i(\mathbf n_i\cdot\mathbf x)/\tan\theta`, with unit vectors
:math:`\mathbf n_i` across the faces.
"""

from __future__ import annotations

import math

__all__ = ["edge_angle_of", "face_angle_of"]


def edge_angle_of(face_angle: float, sides: int) -> float:
    """Return the angle between axis and edge [rad] of a pyramid with this angle between axis and face [rad].

    Examples
    --------
    A cube corner, whose edges are at right angles to each other:

    >>> round(math.degrees(edge_angle_of(math.atan(math.sqrt(0.5)), 3)), 4)
    54.7356
    """
    return math.atan(math.tan(face_angle) / math.cos(math.pi / sides))


def face_angle_of(edge_angle: float, sides: int) -> float:
    """Return the angle between axis and face [rad] of a pyramid with this angle between axis and edge [rad]."""
    return math.atan(math.tan(edge_angle) * math.cos(math.pi / sides))
