"""The numbers of a case on coated or depth-graded bodies, from its [problem] alone, by `layered_solution`."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from case_solutions import si
from layered_solution import Press, Profile, Sheet, Stack

BRACKET = 2.0
"""Contact radii at a given depth lie within this factor of Hertz's."""


def number(given: str | float) -> float:
    return float(si(given))


def solid(table: dict[str, Any]) -> tuple[float, float] | None:
    return (number(table["young"]), float(table["poisson"])) if table["kind"] == "elastic" else None


def profile(table: dict[str, Any], medium: dict[str, Any]) -> Stack | Profile:
    """The body below the surface."""
    other = solid(medium.get("second", {"kind": "rigid"}))
    if medium["kind"] == "coated_half_space":
        sheets = [
            Sheet(number(layer["solid"]["young"]), float(layer["solid"]["poisson"]), number(layer["thickness"]))
            for layer in medium["layers"]
        ]
        return Stack(tuple(sheets), solid(medium["on"]), other)
    grading = medium["grading"]
    assert grading["kind"] == "exponential_grading"
    return Profile(
        number(grading["surface_young"]),
        number(grading["deep_young"]),
        number(grading["depth_scale"]),
        float(grading["poisson"]),
        other,
    )


class ReferenceSolution:
    """The contacts of one case: one for every load."""

    def __init__(self, problem: dict[str, Any], *, careful: bool = False) -> None:
        self.body = problem["bed"]["profile"]
        self.stack = profile(self.body, problem["bed"]["medium"])
        self.load = problem["load"]
        given = self.load[self.load["kind"]]
        self.given = [number(item) for item in (given if isinstance(given, list) else [given])]
        self.many = isinstance(given, list)
        self.careful = careful

    @cached_property
    def widest(self) -> float:
        """An upper bound of the contact radii, in lengths of the body."""
        if self.load["kind"] == "radius":
            widest = max(self.given)
        elif self.body["kind"] == "flat_punch":
            widest = number(self.body["radius"])
        else:
            widest = BRACKET * np.sqrt(number(self.body["curvature_radius"]) * max(self.given))
        return float(widest / self.stack.length)

    def press(self, radius: float) -> Press:
        """More terms for wide contacts, which feel the layer as a boundary layer at their edge."""
        sharp = isinstance(self.stack, Stack)
        # a smooth grading affects arbitrarily short waves, a layer up to a few times 1/thickness
        reach, least = (22.0, 14) if sharp else (120.0, 30)
        extra = 1.4 if self.careful else 1.0
        terms = int(extra * (least + 2.6 * radius / self.stack.length))
        count = int(extra * (180 + 1.6 * reach * self.widest))
        return Press(self.stack, radius, terms=terms, count=count, reach=reach)

    def plane(self, x: np.ndarray) -> np.ndarray:
        """The homogeneous transform of the body."""
        if self.body["kind"] == "paraboloid":
            return x**2 / number(self.body["curvature_radius"])
        if self.body["kind"] == "cone":
            return 0.5 * np.pi * x / np.tan(number(self.body["half_angle"]))
        assert self.body["kind"] == "flat_punch"
        return np.zeros_like(x)

    @cached_property
    def contacts(self) -> list[tuple[Press, float, np.ndarray]]:
        """Press, depth and pressure of every load."""
        found = []
        for given in self.given:
            if self.body["kind"] == "flat_punch":
                assert self.load["kind"] == "depth"
                press = self.press(number(self.body["radius"]))
                found.append((press, given, given * press.flat))
                continue
            radius = given if self.load["kind"] == "radius" else self._radius(given)
            press = self.press(radius)
            found.append((press, *press.closed(self.plane)))
        return found

    def _radius(self, depth: float) -> float:
        from scipy.optimize import brentq

        assert self.load["kind"] == "depth"
        middle = np.sqrt(number(self.body["curvature_radius"]) * depth)  # Hertz
        return brentq(
            lambda a: self.press(a).closed(self.plane)[0] / depth - 1.0, middle / BRACKET, middle * BRACKET, xtol=1e-15
        )

    def quantity(self, expectation: dict[str, Any]) -> np.ndarray:
        """The numbers that an entry of [[expect]] requests, SI."""
        name = expectation["quantity"]
        found = []
        for press, depth, load in self.contacts:
            if "r" in expectation:
                found.append(getattr(press, name)(load, number(expectation["r"])))
            elif name in ("force", "energy"):
                found.append(getattr(press, name)(load))
            else:
                found.append({"depth": depth, "radius": press.a, "stiffness": press.stiffness}[name])
        return np.array(found)
