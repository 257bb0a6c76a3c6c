r"""Conversion of the memories of a pressed spring into those of a free one, and back.

A spring bears :math:`q=M_\infty u+\eta\dot u+\sum_i S_i`, :math:`\dot S_i=-S_i/\tau_i+M_i\dot u`, while it is pressed.
Left alone it recovers, :math:`u=\sum_k w_k e^{-r_k t}`, with the rates of
`winkler.numerics.springs.exponential_sums.zeros`.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.springs.exponential_sums import RelaxationSeries, zeros
from winkler.numerics.types import Array
from winkler.values.value import value

Law = tuple[float, float, Array, Array, Array, Array, Array, Array, Array]


@value
class Recovery:
    """The conversion of the memories of a pressed spring into those of a free one, and back.

    Parameters
    ----------
    rates : ndarray, (k,)
        r_k [1/s] of free recovery.
    from_displacement : ndarray, (k,)
        What a displacement gives to each w_k [-].
    from_memory : ndarray, (k, m)
        What each S_i gives to it [1/Pa].
    to_memory : ndarray, (m, k)
        What each w_k gives to the S_i [Pa].
    """

    rates: Array
    from_displacement: Array
    from_memory: Array
    to_memory: Array

    @classmethod
    def of(cls, series: RelaxationSeries) -> Recovery:
        """Return the recovery of springs with this relaxation."""
        rates, residues = zeros(series)
        lead = 1.0 - rates[:, None] * series.times
        weights = series.times / lead
        displaced = residues * (series.viscosity + weights @ series.moduli)
        back = -series.moduli[:, None] * (rates[:, None] * weights).T
        return cls(rates, displaced, -residues[:, None] * weights, back)

    def law(self, series: RelaxationSeries) -> Law:
        """Return what the kernels of `winkler.numerics.springs.relaxing_springs` need.

        The last of it is what the modes of free recovery store, each by the square of its w_k: modes of different
        rates share no energy.
        """
        own = self.to_memory**2 / series.moduli[:, None]
        stored = 0.5 * (series.relaxed + np.sum(own, axis=0))
        recovering = (self.rates, self.from_displacement, self.from_memory, self.to_memory, stored)
        arrays = (np.array(part, dtype=float, order="C") for part in (series.moduli, series.times, *recovering))
        return series.relaxed, series.viscosity, *arrays  # type: ignore[return-value]
