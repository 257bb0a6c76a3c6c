r"""Rebound of a ball from a Kelvin-Voigt solid by the force law that many particle codes take [1]_ [2]_.

.. math:: F = \tfrac43E^*\sqrt R\,d^{3/2} + 2\eta^*\sqrt{Rd}\,\dot d ,

right while the contact grows, too weak on the return: springs let go one by one and are not pulled.  The law is cut
off where it would pull.

References
----------
.. [1] G. Kuwabara, K. Kono, Restitution coefficient in a collision between two spheres, Jpn. J. Appl. Phys. 26 (1987)
   1230-1233, doi:10.1143/JJAP.26.1230.
.. [2] N. V. Brilliantov, F. Spahn, J.-M. Hertzsch, T. Poeschel, Model for collisions in granular gases, Phys. Rev. E
   53 (1996) 5382-5392, doi:10.1103/PhysRevE.53.5382.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array


def kuwabara_kono_restitution(time_ratio: float) -> float:
    """Return the velocity of parting over that of approach.

    Parameters
    ----------
    time_ratio : float
        eta*/E* over T0 = (m^2/(E*^2 R v))^(1/5) [-], positive.
    """
    from scipy.integrate import solve_ivp

    def motion(_: float, state: Array) -> list[float]:
        depth = max(float(state[0]), 0.0)
        return [state[1], -4.0 / 3.0 * depth**1.5 - 2.0 * time_ratio * math.sqrt(depth) * state[1]]

    def lost(_: float, state: Array) -> float:
        """Zero where the law begins to pull: it is (4/3) d + 2 tau d' but for a factor."""
        return float(state[0] + 1.5 * time_ratio * state[1])

    lost.terminal = True  # type: ignore[attr-defined]
    lost.direction = -1.0  # type: ignore[attr-defined]
    longest = 10.0 * (1.0 + time_ratio)
    solution = solve_ivp(motion, (0.0, longest), [0.0, 1.0], method="DOP853", rtol=1e-12, atol=1e-15, events=lost)
    return float(-np.asarray(solution.y)[1, -1])
