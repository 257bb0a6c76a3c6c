r"""By how much storage and loss ask for other shifts than those they have in common: one step of Newton from these.

With a shift d of the loss alone beside the common one, slopes J of its logarithms and the covariance C of all other
numbers, d has the score :math:`S=J^T r/\sigma^2` and the information
:math:`V=J^TJ/\sigma^2-(J^TK/\sigma^2)\,C\,(K^TJ/\sigma^2)`, so that :math:`d=V^{-1}S` with the covariance
:math:`V^{-1}` (C. R. Rao, Math. Proc. Cambridge Philos. Soc. 44 (1948) 50-57, doi:10.1017/S0305004100023987).
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.springs.relaxation_spectrum import SpectrumEstimate
from winkler.numerics.springs.spectrum_response import Measurements, Response, SpectrumLayout, linearised
from winkler.numerics.types import Array

LEAST_INFORMATION = 1e-9
"""Of a difference, in parts of that of its own rows: below it, nothing is known but the common shift."""


def shifts_apart(measured: tuple[Measurements, ...], found: SpectrumEstimate, reference: int) -> tuple[Array, Array]:
    """Return logarithms of the shifts of the loss over those of the storage ``(m,)``, and their standard errors.

    Parameters
    ----------
    measured : tuple of Measurements
        Storage and loss.
    found : SpectrumEstimate
        With shifts that both have in common.
    reference : int
        The temperature whose shifts are zero.

    Returns
    -------
    differences, errors : ndarray, (m,)
        Zero at the reference; nan where a temperature does not tell them apart.
    """
    k, m = found.times.size, found.shifts.size
    layout = SpectrumLayout(k, m, np.ones(k + 1 + 2 * m, dtype=bool))
    numbers = np.concatenate([found.strengths, [found.level], found.shifts, found.factors])
    slopes, residuals = linearised(measured, found.times, layout, numbers)
    loss = next(place for place, one in enumerate(measured) if one.response is Response.LOSS)
    weighted = slopes[loss] / found.scatter[loss] ** 2
    own = slopes[loss][:, k + 1 : k + 1 + m]
    score = (own / found.scatter[loss] ** 2).T @ residuals[loss]
    alone = own.T @ own / found.scatter[loss] ** 2
    shared = own.T @ weighted
    information = alone - shared @ found.covariance @ shared.T
    told = np.diag(information) > LEAST_INFORMATION * np.diag(alone)
    told[reference] = False
    differences, errors = np.full(m, np.nan), np.full(m, np.nan)
    differences[reference] = errors[reference] = 0.0
    inverse = np.linalg.inv(information[np.ix_(told, told)])
    differences[told], errors[told] = inverse @ score[told], np.sqrt(np.diag(inverse))
    return differences, errors
