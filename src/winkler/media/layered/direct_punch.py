r"""Depth and force of a smooth profile on layers at given contact radii, from one flat punch for each radius.

The equations are those of `winkler.media.layered.flat_punch`, without tables of all radii: a fit asks for few radii of
many media.
"""

from __future__ import annotations

import itertools

import numpy as np

from winkler.media.layered.coated import LayeredMedium
from winkler.numerics.integrals.quadrature import panel_nodes
from winkler.numerics.transforms.cosine_transform import in_own_lengths
from winkler.numerics.transforms.punch_tables import punch_at
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile

NODE_COUNTS = (8, 12, 16, 24, 32)
SETTLED = 1e-7


def nodes_for(medium: LayeredMedium, widest: float) -> int:
    """Return how many nodes on a panel give punches up to a radius [m] to 1e-7."""
    own, unit = in_own_lengths(medium.response)
    last = punch_at(own, widest / unit, NODE_COUNTS[0])
    for count, more in itertools.pairwise(NODE_COUNTS):
        finer = punch_at(own, widest / unit, more)
        if all(abs(old / new - 1.0) <= SETTLED for old, new in zip(last[:2], finer[:2], strict=True)):
            return count
        last = finer
    return NODE_COUNTS[-1]


def depth_and_force(
    medium: LayeredMedium, profile: Profile, radii: Array, count: int = NODE_COUNTS[0]
) -> tuple[Array, Array]:
    """Return d(a) [m] and F(a) [N] of contacts without adhesion.

    Parameters
    ----------
    medium : LayeredMedium
    profile : Profile
        Without kinks up to the widest contact.
    radii : ndarray, (m,)
        Contact radii, positive [m].
    count : int, optional
        Nodes on a panel, from `nodes_for`; few unless given.
    """
    own, unit = in_own_lengths(medium.response)
    transform = profile.gap(radii)
    depth, force = np.empty(radii.size), np.empty(radii.size)
    for place, a in enumerate((radii / unit).tolist()):
        area, edge, phi, moment, panels = punch_at(own, a, count)
        x, weights = panel_nodes(a * panels, count)
        h = profile.gap(unit * x)
        depth[place] = (transform[place] - (weights * h) @ moment.ravel() / a) / edge
        force[place] = a * area * depth[place] - (weights * h) @ phi.ravel()
    return depth, 2.0 * medium.modulus * unit * force
