r"""Loops of a joint that is sheared to and fro, from its stiffnesses, and by boundary elements with friction.

Under a steady normal force F the springs take what slips to leave the contact of a lesser force (Ciavarella, Jaeger),
and loops to follow from the first push (Masing):

.. math:: u(F_x) = \mu\int_{F-F_x/\mu}^{F}\frac{\mathrm dF'}{K_x(F')} , \qquad
          W = 4F_xu(F_x) - 8\int_0^{F_x}u\,\mathrm df .
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.laws.friction import Sliding
from winkler.loading.loads import Force, ShearForce
from winkler.loading.path import Path
from winkler.media.mapped import MappedMedium
from winkler.numerics.integrals.quadrature import panel_nodes
from winkler.numerics.types import Array
from winkler.problems.surface_friction.tangential import SurfaceTangential, SurfaceTangentialSolution
from winkler.profiles.rough.topography import Topography

NODES = 16
STEPS_OF_LOOP = 3
"""Up, down and up again: the last two are a closed loop."""


class JointLoops(NamedTuple):
    """Closed loops of several amplitudes.

    Parameters
    ----------
    shift
        Amplitude of the shift [m], (m,).
    loss
        Energy lost in each of them [J], (m,).
    """

    shift: Array
    loss: Array


def loops_of_stiffness(force: Array, stiffness: Array, coefficient: float, shares: Array) -> JointLoops:
    """Return the loops that springs run through.

    Parameters
    ----------
    force, stiffness : ndarray, (n,)
        Rising forces F' [N], the last of them the normal force, and K_x [N/m] of the contacts under them.
    coefficient : float
        mu.
    shares : ndarray, (m,)
        Amplitudes of the shear force over mu F, so small that the least of the forces is not left.
    """
    from scipy.interpolate import PchipInterpolator

    curve = PchipInterpolator(np.log(force), np.log(stiffness))
    most, shift, loss = float(force[-1]), np.empty(shares.size), np.empty(shares.size)
    for i, share in enumerate(shares.tolist()):
        edges = np.log(np.concatenate(([(1.0 - share) * most], force[force > (1.0 - share) * most * (1.0 + 1e-12)])))
        logarithm, weight = panel_nodes(edges, NODES)
        place = np.exp(logarithm)
        softness = weight * place / np.exp(curve(np.log(place)))
        shift[i] = coefficient * float(np.sum(softness))
        # the integral of u from 0 to F_x, by parts: each F' has slipped through F_x - mu (F - F')
        rest = share * most - (most - place)
        loss[i] = coefficient**2 * (4.0 * share * most * float(np.sum(softness)) - 8.0 * float(np.sum(softness * rest)))
    return JointLoops(shift, loss)


def loops_of_elements(
    topography: Topography, medium: MappedMedium, law: Sliding, force: float, shares: Array
) -> tuple[JointLoops, SurfaceTangentialSolution]:
    """Return the loops along x by boundary elements with friction, amplitude after amplitude, and all of their path.

    Raises
    ------
    NotConverged, OutsideValidity
        As `SurfaceTangential.solve`.
    """
    most = law.coefficient * force
    shear = np.concatenate(([0.0], np.outer(shares * most, [1.0, -1.0, 1.0]).ravel()))
    found = SurfaceTangential(topography, medium, law, Path.through(Force(force), ShearForce(shear))).solve()
    first, last = found.shift_x[2::STEPS_OF_LOOP], found.shift_x[3::STEPS_OF_LOOP]
    loss = found.dissipation[3::STEPS_OF_LOOP] - found.dissipation[1::STEPS_OF_LOOP]
    return JointLoops(0.5 * (last - first), loss), found


def loop_difference(elements: Array, springs: Array) -> float:
    """Return the greatest difference of springs from boundary elements, over the greatest number of these [-]."""
    return float(np.max(np.abs(springs - elements)) / np.max(np.abs(elements)))
