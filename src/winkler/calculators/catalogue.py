"""The twelve calculators: one for each class of problem."""

from __future__ import annotations

from winkler.calculators.calculator import Calculator
from winkler.calculators.pressed import PRESSED_ONES
from winkler.calculators.rubbed import RUBBED_ONES

__all__ = ["CALCULATORS", "calculator"]

ORDER = (
    "normal", "graded", "viscoelastic", "adhesion", "roughness", "tangential", "torsion", "damping", "rolling",
    "heating", "conduction", "wear",
)  # fmt: skip
CALCULATORS: tuple[Calculator, ...] = tuple(
    sorted((*PRESSED_ONES, *RUBBED_ONES), key=lambda one: ORDER.index(one.name))
)


def calculator(name: str) -> Calculator:
    """Return the calculator of a name."""
    return CALCULATORS[ORDER.index(name)]
