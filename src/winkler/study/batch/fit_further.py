"""What a study asks beyond the fit of each curve: calibration shares, depths, other models, and a joint fit.

::

    further.shares      of one curve: errors by the calibration
    further.depths      the numbers of the problem over the greatest fitted depth
    further.fits        fits of the other models, by their names
    joint_of_study(...) of all curves: the numbers that they share
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.fitting.compare import AnyFit, Comparison, ranked
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.examined.calibrated import CalibrationShares, calibration_shares
from winkler.fitting.examined.over_depth import DepthSeries, over_depth
from winkler.fitting.fit import fit
from winkler.fitting.outcome import Fit
from winkler.fitting.several.joint import JointFit
from winkler.fitting.several.together import joint_of
from winkler.study.batch.outcome import ResultColumn
from winkler.study.language.fit_study import FitStudy, Free
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity, WinklerError
from winkler.values.value import value
from winkler.values.vocabulary import Word

CONTACT_POINT = "contact_point"


@value
class Further:
    """Further answers of one curve.

    Parameters
    ----------
    shares : tuple of CalibrationShares
        One where the study states errors of the calibration, else none.
    depths : tuple of DepthSeries
        One where the study asks for depths, else none.
    names : tuple of str
        Names of the other models that were fitted.
    fits : tuple of Fit, ViscoelasticFit or CreepFit
        Their fits.
    refused : tuple of str
        What could not be done, with reasons.
    """

    shares: tuple[CalibrationShares, ...] = ()
    depths: tuple[DepthSeries, ...] = ()
    names: tuple[str, ...] = ()
    fits: tuple[AnyFit, ...] = ()
    refused: tuple[str, ...] = ()


NOTHING = Further()


def further_of(study: FitStudy, curve: ForceCurve, found: AnyFit) -> Further:
    """Return the further answers of a curve; what fails is named, and the fit stays.

    Parameters
    ----------
    study : FitStudy
    curve : ForceCurve
        As it was fitted.
    found : Fit, ViscoelasticFit or CreepFit
    """
    shares: tuple[CalibrationShares, ...] = ()
    depths: tuple[DepthSeries, ...] = ()
    refused: list[str] = []
    if study.is_calibrated:
        try:
            shares = (shares_of(study, found),)
        except WinklerError as error:
            refused.append(f"calibration: {error}")
    if study.over_depth and isinstance(found, Fit):
        free = {free.path: free.start_or_bounds for free in study.free}
        try:
            series = over_depth(
                curve,
                study.problem,
                free=free,
                of=study.own_numbers[0].path,
                count=study.over_depth,
                noise=study.noise,
                found=found,
            )
            depths = (series,)
        except WinklerError as error:
            refused.append(f"depths: {error}")
    fits: dict[str, AnyFit] = {}
    for other in study.models:
        free = {one.path: one.start_or_bounds for one in other.free}
        try:
            fits[other.name] = fit(curve, other.problem, free=free, noise=study.noise, time_limit=study.time_limit)
        except (InvalidInput, OutsideValidity, NotConverged) as error:
            refused.append(f"{other.name}: {error}")
    return Further(shares, depths, tuple(fits), tuple(fits.values()), tuple(refused))


def shares_of(study: FitStudy, found: AnyFit) -> CalibrationShares:
    """Return the errors of a fit by the calibration of the study."""
    return calibration_shares(
        found,
        spring_constant_error=study.spring_constant_error,
        sensitivity_error=study.sensitivity_error,
        thermal=study.spring_constant_by == "thermal",
        spring_constant=study.spring_constant,
        frame_compliance=1.0 / study.frame_stiffness,
    )


def compared(study: FitStudy, found: AnyFit, further: Further) -> Comparison:
    """Return the problem of a study and its other models, ranked; those that could not be fitted are named."""
    names = [one.name for one in study.models if one.name not in further.names]
    refused = [text for text in further.refused if text.partition(":")[0] in names]
    return ranked({study.model: found} | dict(zip(further.names, further.fits, strict=True)), refused)


def contact_correlation(study: FitStudy, found: AnyFit) -> float:
    """Return the correlation of the first number of the problem with the contact point; nan if one is not free."""
    names = [free.path for free in study.own_numbers]
    if CONTACT_POINT not in found.names or not names:
        return float("nan")
    return float(found.correlation[found.index(names[0]), found.index(CONTACT_POINT)])


def further_columns(study: FitStudy, fits: Sequence[AnyFit | str], furthers: Sequence[Further]) -> list[ResultColumn]:
    """Return the further columns of the table of curves; a fit is a text where there is none."""
    columns = []

    def add(name: str, word: Word, one: Any, nothing: Any = np.nan) -> None:
        pairs = zip(fits, furthers, strict=True)
        content = [nothing if isinstance(found, str) else one(found, further) for found, further in pairs]
        columns.append(ResultColumn(name, word, np.array(content)))

    if any(free.key == CONTACT_POINT for free in study.free) and study.own_numbers:
        meaning = f"correlation of contact point and {study.own_numbers[0].label}"
        add("contact_point_correlation", Word("", "", meaning), lambda found, _: contact_correlation(study, found))
    for free in study.free if study.is_calibrated else ():
        word = study.word(free.key)
        meaning = f"standard error by the calibration: {word.meaning}"
        add(f"{free.key}_calibration", word._replace(meaning=meaning), _calibration_error(free))
    if study.over_depth:
        said = Word("", None, f"{study.own_numbers[0].label} over the greatest fitted depth")
        add("over_depth", said, lambda _, further: further.depths[0].verdict if further.depths else "", "")
    if study.models:
        said = Word("", None, "models that the curve does not exclude, those that were not fitted in brackets")
        add("models", said, lambda found, further: _remaining(compared(study, found, further)), "")
        for name in (study.model, *(one.name for one in study.models)):
            word = Word("", "", f"Akaike's criterion of '{name}' above that of the best model")
            add(f"aic_{name}", word, _criterion(study, name))
    return columns


def _remaining(comparison: Comparison) -> str:
    names = comparison.possible or ("none explains the curve",)
    return "; ".join([*names, *(f"({name})" for name in comparison.unfitted)])


def _calibration_error(free: Free) -> Any:
    return lambda _, further: further.shares[0].error(free.path) if further.shares else np.nan


def _criterion(study: FitStudy, name: str) -> Any:
    def above(found: AnyFit, further: Further) -> float:
        comparison = compared(study, found, further)
        if name not in comparison.models:
            return float("nan")
        return float(comparison.aic[comparison.models.index(name)] - comparison.aic[0])

    return above


def joint_of_study(study: FitStudy, fits: Sequence[AnyFit]) -> tuple[tuple[JointFit, ...], str]:
    """Return the joint fit of the curves of a study, and why there is none; both empty if none is asked for."""
    if not study.shared:
        return (), ""
    paths = {free.key: free.path for free in study.free}
    try:
        return (joint_of(fits, [paths[key] for key in study.shared], time_limit=study.time_limit),), ""
    except WinklerError as error:
        return (), str(error)


def common_calibration(found: Sequence[AnyFit], furthers: Sequence[Further], name: str) -> float:
    """Return the relative error of a positive number by the calibration that all curves share: the median of all."""
    errors = [
        further.shares[0].error(name) / abs(one.value(name))
        for one, further in zip(found, furthers, strict=True)
        if further.shares
    ]
    return float(np.median(errors)) if errors else 0.0
