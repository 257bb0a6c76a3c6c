"""Sliders, numbers and pieces of studies that several calculators share."""

from __future__ import annotations

from winkler.calculators.calculator import AnswerNumber, Slider

__all__ = [
    "ALIKE", "BALL", "COEFFICIENT", "FORCE", "FRICTION", "POISSON", "PRESSED", "RADIUS", "SHARE", "YOUNG",
    "contact_radius", "metres",
]  # fmt: skip

RADIUS = Slider("curvature_radius", "R", "radius of the ball", "mm", 1.0, 1000.0, 10.0)
FORCE = Slider("force", "F_N", "normal force", "N", 1.0, 1000.0, 100.0)
YOUNG = Slider("young", "E", "Young's modulus of both bodies", "GPa", 10.0, 1000.0, 210.0)
POISSON = Slider("poisson", "ν", "Poisson's ratio of both bodies", "", 0.0, 0.5, 0.3, False)
COEFFICIENT = Slider("coefficient", "μ", "coefficient of friction", "", 0.01, 1.0, 0.3)
SHARE = Slider("share", "F_x/μF_N", "part of the force at which all slides", "", 0.01, 0.99, 0.6, False)


def metres(name: str, symbol: str, words: str, path: str, unit: str = "um") -> AnswerNumber:
    """Return a length that is found."""
    return AnswerNumber(name, symbol, words, unit, "m", path)


def contact_radius(path: str = "radius") -> AnswerNumber:
    """Return the contact radius."""
    return metres("radius", "a", "contact radius", path)


BALL = """
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = {curvature_radius} }
"""
ALIKE = """
[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = {young}, poisson = {poisson} }
second = { kind = "elastic", young = {young}, poisson = {poisson} }
"""
PRESSED = """
[problem.load]
kind = "force"
force = {force}
"""
FRICTION = """
[problem.law]
kind = "coulomb"
coefficient = {coefficient}
"""
