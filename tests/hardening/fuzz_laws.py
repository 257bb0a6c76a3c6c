"""What holds of every solution: signs, sizes, friction's limit, no energy from nowhere.

One name stands for one thing in all of winkler (`winkler.values.vocabulary`), so a law is written once, in terms of
names, and is held against every answer that has them.  Numbers are compared to `ROUNDING` of the largest of their kind.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from winkler.values.errors import WinklerError

ROUNDING = 1e-6
LAWS: dict[str, Callable[[Mapping[str, Any], Any], bool]] = {}
"""Sentence -> whether it holds for the numbers of a problem."""
NEEDED: dict[str, tuple[str, ...]] = {}
"""Sentence -> the names that an answer must have for it."""

ENDLESS = ("machine_stiffness", "resistance", "conductance", "coefficient", "interface_conductance")
"""What may be infinite: without a contact, without a film."""
NOT_NEGATIVE = (
    *("radius", "stick_radius", "area", "longitudinal_semi_axis", "lateral_semi_axis", "worn_depth", "worn_volume"),
    *("first_volume", "second_volume", "time", "duration", "distance", "resistance", "conductance"),
    *("loss_per_cycle", "loss_per_distance", "loss_stiffness", "storage_stiffness", "damping", "loss_factor", "rise"),
    *("kinetic_energy", "crack_speed", "uncertainty", "misfit", "film_resistance", "bulk_resistance", "constriction"),
    *("first_constriction", "second_constriction", "mean_gap", "area_error", "shear_stiffness", "peak_pressure"),
    *("first_max_temperature", "second_max_temperature", "first_mean_temperature", "second_mean_temperature"),
    *("torque_limit", "residual_depth", "holm_radius", "shakedown_force", "penetration", "equivalent_radius"),
)
NEVER_FALLING = ("time", "distance", "cycles", "cycle", "dissipation", "friction_loss", "bulk_loss", "worn_volume")
SHARES = ("stick_share", "saturation", "first_share", "shares", "restitution")
FINITE = (
    "force",
    "depth",
    "radius",
    "energy",
    "stored_energy",
    "dissipation",
    "shear_force",
    "torque",
    "area",
    "shift",
)
FRICTION = ("Coulomb", "StaticKinetic", "LinearSlipWeakening", "ExponentialSlipWeakening", "FallingFriction")
"""Laws by which friction bears at most its greatest coefficient times the force."""

STICKY = ("law", "work_opening")
"""Fields of a problem that may hold forces of adhesion."""


def law(sentence: str, *names: str):
    """Enter a law that needs certain names."""

    def enter(holds):
        LAWS[sentence], NEEDED[sentence] = holds, names
        return holds

    return enter


def numbers_of(answer: Any) -> dict[str, Any]:
    """Return all properties of a solution, by name; what it refuses to compute is left out."""
    found = {field.name: getattr(answer, field.name) for field in dataclasses.fields(answer)}
    for name in dir(type(answer)):
        if name[0] != "_" and isinstance(getattr(type(answer), name), property | functools.cached_property):
            try:
                found[name] = getattr(answer, name)
            except WinklerError as error:
                found[f"{name} refused"] = str(error)
    return found


def numbers(content: Any) -> np.ndarray | None:
    """Return numbers as a row; None of what is no number."""
    if isinstance(content, bool) or not isinstance(content, int | float | np.ndarray):
        return None
    row = np.atleast_1d(np.asarray(content))
    return row if row.dtype.kind in "iuf" else None


def broken(answer: Any, problem: Any = None) -> list[str]:
    """Return the laws that do not hold of an answer."""
    return broken_by(numbers_of(answer), answer.problem if problem is None else problem)


def broken_by(content: Mapping[str, Any], problem: Any) -> list[str]:
    """Return the laws that do not hold for the numbers of a problem."""
    with np.errstate(all="ignore"):
        return [
            sentence
            for sentence, holds in LAWS.items()
            if all(numbers(content.get(name)) is not None for name in NEEDED[sentence]) and not holds(content, problem)
        ]


def size(*rows: Any) -> float:
    """Return the largest size of finite numbers."""
    flat = np.concatenate([np.abs(np.ravel(row)) for row in rows]) if rows else np.zeros(1)
    flat = flat[np.isfinite(flat)]
    return float(flat.max()) if flat.size else 0.0


def not_below(row: Any, low: Any, scale: float = 0.0) -> bool:
    """Return whether numbers are at least as large, but for rounding; what is undefined is."""
    row, low = np.asarray(row, dtype=float), np.asarray(low, dtype=float)
    return bool(np.all((row - low >= -ROUNDING * max(scale, size(row))) | np.isnan(row) | np.isinf(row)))


@law("no number is undefined")
def _defined(content: Mapping[str, Any], problem: Any) -> bool:
    rows = [numbers(inside) for name, inside in content.items() if not _may_be_none(name, content)]
    return not any(row is not None and np.isnan(row).any() for row in rows)


def _may_be_none(name: str, content: Mapping[str, Any]) -> bool:
    """Return whether a number may be undefined: what is left of a body that never left."""
    return name.endswith("restitution") or "refused" in name


@law("what is pressed, moved and stored is finite")
def _finite(content: Mapping[str, Any], problem: Any) -> bool:
    rows = [numbers(content.get(name)) for name in FINITE]
    return not any(row is not None and np.isinf(row).any() for row in rows)


@law("lengths, losses and resistances are not negative")
def _signs(content: Mapping[str, Any], problem: Any) -> bool:
    rows = [numbers(content.get(name)) for name in NOT_NEGATIVE]
    return all(row is None or not_below(row, 0.0) for row in rows)


@law("time, distances, losses and wear never fall")
def _rising(content: Mapping[str, Any], problem: Any) -> bool:
    rows = [(name, numbers(content.get(name))) for name in NEVER_FALLING]
    velocity = numbers(getattr(problem, "velocity", None))
    if velocity is not None and velocity.ndim == 1:  # blows of their own, in any order, not points of a path
        order = np.argsort(velocity, kind="stable")
        rows = [(name, row[order] if row is not None and row.shape == velocity.shape else row) for name, row in rows]
    energy = size(
        *(row for name in ("energy", "stored_energy", "work") if (row := numbers(content.get(name))) is not None)
    )
    return all(
        row is None
        or row.ndim > 1
        or not_below(np.diff(row), 0.0, max(size(row), energy if name.endswith(("loss", "dissipation")) else 0.0))
        for name, row in rows
    )


@law("shares and restitution lie between nothing and all")
def _shares(content: Mapping[str, Any], problem: Any) -> bool:
    rows = [numbers(content.get(name)) for name in SHARES]
    return all(row is None or (not_below(row, 0.0) and not_below(1.0 + ROUNDING, row)) for row in rows)


@law("the contact is not wider than the profile is known", "radius")
def _within_profile(content: Mapping[str, Any], problem: Any) -> bool:
    bed = getattr(problem, "bed", getattr(getattr(problem, "motion", None), "bed", None))
    profile = getattr(bed, "profile", None)
    ends = [getattr(profile, name, math.inf) for name in ("reach", "rim")]
    return not_below(min(end for end in ends if isinstance(end, float)) * (1.0 + ROUNDING), content["radius"])


@law("what sticks is part of the contact", "radius", "stick_radius")
def _stick(content: Mapping[str, Any], problem: Any) -> bool:
    return not_below(content["radius"], content["stick_radius"])


@law("bodies that do not stick only push", "force")
def _pushing(content: Mapping[str, Any], problem: Any) -> bool:
    sticky = any(_is_sticky(getattr(problem, name, None)) for name in STICKY)
    return sticky or not_below(content["force"], 0.0)


def _is_sticky(part: Any) -> bool:
    return part is not None and type(part).__name__ not in (*FRICTION, "WiedemannFranz")


@law("friction carries at most its coefficient times the force", "force", "shear_force")
def _friction(content: Mapping[str, Any], problem: Any) -> bool:
    friction = getattr(problem, "law", getattr(problem, "friction", None))
    if type(friction).__name__ not in FRICTION:
        return True
    most = max(
        getattr(friction, field.name) for field in dataclasses.fields(friction) if field.name.endswith("coefficient")
    )
    shear, force = np.asarray(content["shear_force"]), np.asarray(content["force"])
    if shear.ndim == 2:
        shear = np.linalg.norm(shear, axis=1)
    return not math.isfinite(most) or not_below(most * np.abs(force), np.abs(shear), most * size(force))


@law("a contact that widens stores at most half of force times depth", "force", "depth", "energy", "mean_pressure")
def _half_the_work(content: Mapping[str, Any], problem: Any) -> bool:
    if not _rises(problem):
        return True
    half = 0.5 * np.asarray(content["force"]) * np.asarray(content["depth"])
    return not_below(content["energy"], 0.0) and not_below(half, content["energy"])


@law("a contact that widens is at least as stiff as its chord", "force", "depth", "stiffness", "mean_pressure")
def _chord(content: Mapping[str, Any], problem: Any) -> bool:
    depth = np.maximum(np.asarray(content["depth"]), 0.0)
    return not _rises(problem) or not_below(np.asarray(content["stiffness"]) * depth, content["force"])


def _rises(problem: Any) -> bool:
    """Return whether a shape is known to touch at its axis first, so that depths count from there."""
    return bool(getattr(getattr(getattr(problem, "bed", None), "profile", None), "rising", False))


@law("what is stored is not negative", "stored_energy")
def _stored(content: Mapping[str, Any], problem: Any) -> bool:
    energies = [row for name in ("dissipation", "work") if (row := numbers(content.get(name))) is not None]
    return not_below(content["stored_energy"], 0.0, size(content["stored_energy"], *energies))


@law("nothing is lost or stored that nobody put in", "stored_energy", "dissipation", "force", "depth")
def _budget(content: Mapping[str, Any], problem: Any) -> bool:
    if "kinetic_energy" in content:  # checked by its balance
        return True
    pairs = [(np.asarray(content["force"]), np.asarray(content["depth"]))]
    pairs += [
        (np.asarray(content[effort]), np.asarray(content[distance]))
        for effort, distance in (("shear_force", "shift"), ("torque", "angle"))
        if effort in content and distance in content
    ]
    most = sum(_work_at_most(effort, distance) for effort, distance in pairs)
    return not_below(most * (1.0 + ROUNDING), np.asarray(content["stored_energy"]) + np.asarray(content["dissipation"]))


def _work_at_most(effort: np.ndarray, distance: np.ndarray) -> float:
    """Return the work of the largest effort along the whole path."""
    distance = np.diff(np.atleast_1d(distance), axis=0, prepend=0.0 * np.atleast_1d(distance)[:1])
    effort, distance = (np.linalg.norm(row, axis=1) if row.ndim == 2 else np.abs(row) for row in (effort, distance))
    return size(effort) * float(np.sum(distance))


@law("an impact keeps its energy", "balance", "kinetic_energy", "energy")
def _balance(content: Mapping[str, Any], problem: Any) -> bool:
    put_in = np.asarray(content["kinetic_energy"]).max()
    missing = np.abs(np.asarray(content["balance"]) - 1.0) * put_in
    return bool(np.all(missing <= 1e-4 * max(put_in, size(content["energy"]))))


@law("the hottest place is not colder than the mean", "first_max_temperature", "first_mean_temperature")
def _hot(content: Mapping[str, Any], problem: Any) -> bool:
    return not_below(content["first_max_temperature"], content["first_mean_temperature"])


@law("conductance is one over resistance", "resistance", "conductance")
def _ohm(content: Mapping[str, Any], problem: Any) -> bool:
    product = np.asarray(content["resistance"]) * np.asarray(content["conductance"])
    return bool(np.all((np.abs(product - 1.0) < ROUNDING) | np.isnan(product)))


@law("bounds stand on both sides", "least_stiffness", "greatest_stiffness")
def _bounds(content: Mapping[str, Any], problem: Any) -> bool:
    low, high = np.asarray(content["least_stiffness"]), np.asarray(content["greatest_stiffness"])
    middle = np.asarray(content.get("smooth_stiffness", low))
    return not_below(middle, low) and not_below(high, middle)


@law("a rough contact covers at most its square", "area")
def _covered(content: Mapping[str, Any], problem: Any) -> bool:
    side = getattr(problem, "side", math.inf)
    return not_below(side**2 * (1.0 + ROUNDING), content["area"])


@law("sliding and rolling cost work", "coefficient")
def _costs(content: Mapping[str, Any], problem: Any) -> bool:
    return not_below(content["coefficient"], 0.0)


@law("every remark is a sentence of one line")
def _remarks(content: Mapping[str, Any], problem: Any) -> bool:
    sentences = [getattr(note, "statement", note) for note in content.get("validity", ())]
    return all(line.strip() and "\n" not in line and not {"nan", "(nan"} & set(line.split()) for line in sentences)
