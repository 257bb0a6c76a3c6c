r"""Comparison of several models of one curve.

Every model is fitted; Akaike's and Schwarz' criteria weigh the likelihood L of the residuals under white and slow noise
(`winkler.fitting.noise`) against the number p of free parameters,

.. math:: \mathrm{AIC} = -2\ln L + 2p, \qquad \mathrm{BIC} = -2\ln L + p\ln n_\mathrm{eff} .

The number of independent points is that of the likeliest model, the same for all.

The rule: a curve excludes a model if both criteria of it exceed those of the best one by `LEAST_DIFFERENCE`, and if the
best one explains the curve (no flag `misfit`).  If none explains it, none is possible, and their likelihoods state only
which one comes nearest.  A model that could not be fitted is not excluded.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.outcome import AnyFit
from winkler.fitting.validity import Model
from winkler.numerics.types import Array, Quantity
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.value import value, words

__all__ = ["LEAST_DIFFERENCE", "AnyFit", "Comparison", "compare", "ranked"]

LEAST_DIFFERENCE = 14.0
"""Difference of both criteria from which on a model is excluded: a thousand to one."""


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
        Akaike's and Schwarz' information criteria [-]; only differences have a meaning.
    refused : tuple of str
        Models that could not be fitted, with the reasons.
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
        """Likelihood ratio of the best model to each model, exp(difference of AIC / 2), ``(m,)``."""
        return np.asarray(np.exp(np.minimum(0.5 * (self.aic - self.aic[0]), 700.0)))

    @property
    def best(self) -> AnyFit:
        """The fit of the best model."""
        return self.fits[0]

    @property
    def explained(self) -> bool:
        """Whether the best model explains the curve: its residuals do not exceed the noise."""
        return all(flag.name != "misfit" for flag in self.best.flags)

    @property
    def possible(self) -> tuple[str, ...]:
        """Models that agree with the curve, the best first; empty if the best one does not explain the curve.

        A model that was not compared may describe the curve equally well.
        """
        if not self.explained:
            return ()
        worse = np.minimum(self.aic - self.aic[0], self.bic - self.bic[0])
        return tuple(name for name, more in zip(self.models, worse.tolist(), strict=True) if more < LEAST_DIFFERENCE)

    @property
    def excluded(self) -> tuple[str, ...]:
        """Models that were fitted and are not possible, the best first."""
        possible = self.possible
        return tuple(name for name in self.models if name not in possible)

    @property
    def unfitted(self) -> tuple[str, ...]:
        """Names of the models that could not be fitted, and are therefore not excluded."""
        return tuple(text.partition(":")[0] for text in self.refused)

    @property
    def decided(self) -> bool:
        """Whether all models were fitted and the curve excludes all but the best one."""
        return len(self.possible) == 1 < len(self.models) and not self.refused

    @property
    def verdict(self) -> str:
        """The conclusion in one sentence, with the names of models that could not be fitted."""
        unfitted = _listed(self.unfitted)
        return self._statement() + (f" Not fitted, and therefore not excluded: {unfitted}." if unfitted else "")

    def _statement(self) -> str:
        possible, excluded = _listed(self.possible), _listed(self.excluded)
        if not self.explained:
            return f"None of the models explains this curve; {self.models[0]} comes nearest."
        if len(self.possible) > 1:
            return f"This curve does not distinguish {possible}{f'; it excludes {excluded}' if excluded else ''}."
        if excluded:
            return f"This curve distinguishes {possible} from {excluded}."
        return f"{possible} is the only model that was fitted."


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
        Time limit of the fit of one model [s].

    Returns
    -------
    Comparison

    Raises
    ------
    InvalidInput
        If the curve is not supported, or no model is given.
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


def _listed(names: tuple[str, ...]) -> str:
    return " and ".join(part for part in (", ".join(names[:-1]), *names[-1:]) if part)
