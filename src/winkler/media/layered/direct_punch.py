r"""Depth and force of a smooth profile on layers at given contact radii, from one flat punch for each radius.

:math:`g(a)\,\varphi(a;a) = h(a) - \int\rho h\,\mathrm dx` and
:math:`\int k'g\,\mathrm dx = 2E^*\int\varphi h\,\mathrm dx` as in `winkler.media.layered.flat_punch`, but without tables of all radii: a fit asks for few radii of many media.
"""

from __future__ import annotations

import numpy as np

from winkler.media.layered.coated import LayeredMedium
from winkler.numerics.transforms.cosine_transform import in_own_lengths
from winkler.numerics.transforms.kernel_matrix import panel_nodes
from winkler.numerics.transforms.punch_tables import punch_at
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile

__all__ = ["depth_and_force"]

FEW_NODES, MANY_NODES = 8, 24
"""Nodes on a panel of a punch; many where few change the widest one."""
SETTLED = 1e-8


def depth_and_force(medium: LayeredMedium, profile: Profile, radii: Array) -> tuple[Array, Array]:
    """Return d(a) [m] and F(a) [N] of contacts without adhesion, to about 1e-8.

    Parameters
    ----------
    medium : LayeredMedium
    profile : Profile
        Without kinks up to the widest contact.
    radii : ndarray, (m,)
        Contact radii, positive [m].

    Raises
    ------
    NotConverged
        If the kernel of the stack does not settle.
    """
    own, unit = in_own_lengths(medium.response)
    widest = float(radii.max()) / unit
    few, many = (np.array(punch_at(own, widest, count)[:2]) for count in (FEW_NODES, MANY_NODES))
    count = FEW_NODES if np.all(np.abs(few - many) <= SETTLED * np.abs(many)) else MANY_NODES
    transform = profile.gap(radii)
    depth, force = np.empty(radii.size), np.empty(radii.size)
    for place, a in enumerate((radii / unit).tolist()):
        area, edge, phi, moment, panels = punch_at(own, a, count)
        x, weights = panel_nodes(a * panels, count)
        h = profile.gap(unit * x)
        depth[place] = (transform[place] - (weights * h) @ moment.ravel() / a) / edge
        force[place] = a * area * depth[place] - (weights * h) @ phi.ravel()
    return depth, 2.0 * medium.modulus * unit * force
