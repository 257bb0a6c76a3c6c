r"""Two surfaces on a grid that touch and share heat so that their temperatures agree in every pixel of the contact.

With the temperatures K1 q1 and K2 q2 under the fluxes into either body, q1 + q2 = q, and a second body that is warmer
by D far away,

.. math:: (K_1 + K_2)\,q_1 = K_2\,q + D , \qquad (K_1 + K_2)\,q_2 = K_1\,q - D

where they touch (Blok's condition of continuity).  What is left of the equation is a difference of temperatures.  So
that of the two is solved whose right-hand side is less: no surface is warmer than if its body took all the heat, and
against an insulator the other side is greater than the temperatures by the ratio of the conductivities.  The operator
is not symmetric, as heat goes downstream; generalised minimal residuals take ten to thirty-five steps, preconditioned
by the waves of temperature

.. math:: \hat T = \frac{\hat q}{\lambda\sqrt{\mathbf k^2 + i k_x V/\kappa}} .
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.surfaces.heated_grid import HeatedGrid
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

SOLVED = 1e-9
"""Difference of the temperatures over their size, both in the mean of squares, that the solver leaves."""
MOST_ROUNDS = 20
ROUND = 40
"""Steps of the solver before it starts again."""


class HeatSharing(NamedTuple):
    """Two bodies and where they touch.

    Parameters
    ----------
    first, second
        The bodies.
    touching
        Which pixels touch, (nx, ny).
    """

    first: HeatedGrid
    second: HeatedGrid
    touching: Array

    def fluxes(self, flux: Array, difference: float) -> tuple[Array, Array]:
        """Return what flows into the first and the second body [W/m^2], (nx, ny); zero where nothing touches.

        Parameters
        ----------
        flux
            Heat of friction q [W/m^2], zero where nothing touches.
        difference
            D [K].

        Raises
        ------
        NotConverged
            If the temperatures are not made to agree.
        """
        if float(np.sum(self.first.warmed(flux)[self.touching])) < float(
            np.sum(self.second.warmed(flux)[self.touching])
        ):
            second, first = self._replace(first=self.second, second=self.first).fluxes(flux, -difference)
            return first, second
        from scipy.sparse.linalg import LinearOperator, gmres

        here, shape = self.touching, self.touching.shape
        both = self.first._replace(response=self.first.response + self.second.response)
        rough = self.first.inverse * self.second.inverse / (self.first.inverse + self.second.inverse)

        def spread(part: Array) -> Array:
            whole = np.zeros(shape)
            whole[here] = part
            return whole

        def undone(part: Array) -> Array:
            import scipy.fft

            return np.asarray(scipy.fft.irfft2(rough * scipy.fft.rfft2(spread(part)), s=shape)[here])

        heated = self.second.warmed(flux)[here]
        wanted = heated + difference
        scale = float(np.linalg.norm(heated)) + abs(difference) * float(np.sqrt(heated.size))
        if scale == 0.0:
            return np.zeros(shape), np.zeros(shape)
        size = (heated.size, heated.size)
        equal = float(np.sum(heated)) / (float(np.sum(both.warmed(flux)[here])) or 1.0) * flux[here]
        found, left = gmres(
            LinearOperator(size, matvec=lambda part: both.warmed(spread(part))[here], dtype=np.float64),
            wanted, equal, rtol=0.0, atol=SOLVED * scale, restart=ROUND, maxiter=MOST_ROUNDS,
            M=LinearOperator(size, matvec=undone, dtype=np.float64),
        )  # fmt: skip
        if left:
            raise NotConverged("the temperatures of the two surfaces do not agree where they touch")
        into = spread(found)
        return into, flux - into
