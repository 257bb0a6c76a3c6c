r"""Comparison of several models of one curve.

Every model is fitted; Akaike's and Schwarz' criteria weigh the likelihood L of the residuals under white and slow noise
(`winkler.fitting.noise`) against the number p of free parameters,

.. math:: \mathrm{AIC} = -2\ln L + 2p, \qquad \mathrm{BIC} = -2\ln L + p\ln n_\mathrm{eff} .

The number of independent points is that of the likeliest model, the same for all.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.outcome import AnyFit
from winkler.fitting.validity import Model
from winkler.numerics.types import Array, Quantity
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values import value, words

__all__ = ["AnyFit", "Comparison", "compare", "ranked"]


@value
class Comparison:
    """Models of one curve, the best by Akaike's criterion first.

    Parameters
    ----------
    models : tuple of str, (m,)
        Their names.
    fits : tuple of Fit, ViscoelasticFit or CreepFit, (m,)
        Their fits.
    effective_count : float
        Number of independent points of the curve.
    aic, bic : ndarray, (m,)
        Akaike's and Schwarz' criterion [-]; only differences mean something.
    refused : tuple of str
        Models that could not be fitted, with their reasons.
    """

    __words__ = words(
        models=("", None, "names of the models, the best first"),
        fits=("", None, "their fits"),
        aic=("AIC", "", "Akaike's criterion"),
        bic=("BIC", "", "Schwarz' criterion"),
        refused=("", None, "models that could not be fitted, with the reason"),
    )

    models: tuple[str, ...]
    fits: tuple[AnyFit, ...]
    effective_count: float
    aic: Array
    bic: Array
    refused: tuple[str, ...]

    @property
    def evidence(self) -> Array:
        """How many times likelier the best model is than each, exp(difference of AIC / 2) ``(m,)``."""
        return np.asarray(np.exp(np.minimum(0.5 * (self.aic - self.aic[0]), 700.0)))

    @property
    def best(self) -> AnyFit:
        """The fit of the best model."""
        return self.fits[0]


def compare(
    curve: ForceCurve,
    models: Mapping[str, tuple[Model | ViscoelasticIndentation, Any]],
    *,
    noise: Quantity = 0.0,
    time_limit: float = math.inf,
) -> Comparison:
    """Fit several models to a curve, and rank them by Akaike's criterion.

    Parameters
    ----------
    curve : ForceCurve
    models : mapping of str to (model, free)
        Name, model and free parameters as for `fit`.
    noise : float or ndarray, optional
        As in `fit`.
    time_limit : float, optional
        The longest that the fit of one model may take [s].

    Returns
    -------
    Comparison

    Raises
    ------
    InvalidInput
        If the curve is refused, or no model is given.
    OutsideValidity
        If no model can be fitted.
    """
    if not models:
        raise InvalidInput("compare: no model is given; give {name: (model, free), ...}.")
    fits: dict[str, AnyFit] = {}
    refused = []
    for name, (model, free) in models.items():
        try:
            fits[name] = fit(curve, model, free=free, noise=noise, time_limit=time_limit)
        except (OutsideValidity, NotConverged) as error:
            refused.append(f"{name}: {error}")
    if not fits:
        raise OutsideValidity(f"compare: no model can be fitted; {' '.join(refused)}")
    return ranked(fits, refused)


def ranked(fits: Mapping[str, AnyFit], refused: Sequence[str] = ()) -> Comparison:
    """Return the comparison of models of one curve that were fitted already; `refused` as in `Comparison`."""
    independent = max(fits.values(), key=lambda result: result.log_likelihood).effective_count
    aic = {name: result.aic for name, result in fits.items()}
    bic = {name: value + (math.log(independent) - 2.0) * len(fits[name].names) for name, value in aic.items()}
    order = sorted(fits, key=lambda name: aic[name])
    return Comparison(
        tuple(order),
        tuple(fits[name] for name in order),
        independent,
        np.array([aic[name] for name in order]),
        np.array([bic[name] for name in order]),
        tuple(refused),
    )
