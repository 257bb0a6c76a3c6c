r"""A profile written as a formula of r, with exact derivatives.

The text is read by `winkler.numerics.equations.expression`: no code in it is ever executed.  Powers among its addends
have the closed-form transform :math:`g = \sum_i \kappa_{p_i} c_i x^{p_i}`; the rest is transformed by quadrature of
its slope, with

.. math:: \int_0^x g = x\,g(x) - \int_0^x \frac{r^2 f'(r)}{\sqrt{x^2-r^2}}\,dr ,

so that the cancellation in a height such as :math:`R-\sqrt{R^2-r^2}` spoils nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike

from winkler.numerics.equations.expression import Expression
from winkler.numerics.equations.taylor import power_sum
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.profiles.formula_parts import (
    CORNER_OFFSETS,
    ROUNDING_RATIO,
    constants_of,
    last_finite,
    law_of,
    powers_of,
    pure,
    rest_of,
    sides_of,
    start_of,
    stretched,
)
from winkler.profiles.profile import Kinks, Shape
from winkler.values.checks.number_checks import Advice, PositiveOrInfinite
from winkler.values.errors import InvalidInput
from winkler.values.value import value

LARGEST_TRIED_RADIUS = 1.0
"""How far a formula without a reach is tried out [m]."""


@value
class Formula(Shape):
    """A body of revolution defined by a formula of r.

    Parameters
    ----------
    expression : str
        The height f(r) [m] in terms of ``r`` [m] and of named constants: ``"r**2/(2*R)"``.  Allowed are numbers,
        ``+ - * / **``, brackets, pi, e, and sqrt exp log sin cos tan arcsin arccos arctan sinh cosh tanh.
    reach : float, optional
        Radius up to which the formula holds [m]; infinite by default.
    corners : tuple of float, optional
        Radii where the slope jumps [m], as that of ``sqrt((r - b)**2)`` does at b; ascending after construction.
    constants : mapping or tuple of (name, number), optional
        The constants in SI units; ``Formula("r**2/(2*R)", R=10e-3)`` is the same.  Named ones come first, so that
        ``dataclasses.replace(formula, R=5e-3)`` changes one.

    Raises
    ------
    InvalidInput
        If the text is not a valid formula. If the height is not zero at r = 0, is negative, or is not finite somewhere
        within the reach.

    Examples
    --------
    >>> import numpy as np
    >>> tip = Formula("R - sqrt(R**2 - r**2)", reach=10e-3, R=10e-3)
    >>> bool(np.isclose(tip.gap(np.array([1e-3]))[0], 1e-3 * np.arctanh(0.1), rtol=1e-13))
    True
    """

    expression: Annotated[str, Advice("a formula such as 'r**2/(2*R)'")]
    constants: tuple[tuple[str, float], ...] = ()
    reach: PositiveOrInfinite = math.inf
    corners: tuple[float, ...] = ()

    def __init__(
        self,
        expression: str,
        reach: float = math.inf,
        *,
        corners: ArrayLike = (),
        constants: Mapping[str, float] | Iterable[tuple[str, float]] = (),
        **named: float,
    ) -> None:
        if "kinks" in named:
            raise InvalidInput("Formula: radii where the slope jumps are given as corners=(...), not as kinks.")
        object.__setattr__(self, "expression", expression)
        object.__setattr__(self, "constants", constants_of("Formula", constants, named))
        object.__setattr__(self, "reach", reach)
        object.__setattr__(self, "corners", corners)
        self.__post_init__()

    def __post_init__(self) -> None:
        for corner in self.corners:
            if not 0.0 < corner < self.reach:
                raise InvalidInput(f"Formula: the corner {corner!r} must be a radius in m between 0 and the reach.")
        object.__setattr__(self, "corners", tuple(sorted({float(corner) for corner in self.corners})))
        start_of(self._law)
        self._try_out()
        _ = self.kinks

    def _try_out(self) -> None:
        """Refuse a height that is not finite, negative, or zero everywhere."""
        end = LARGEST_TRIED_RADIUS if self.reach == math.inf else self.reach
        trial = np.unique(np.concatenate([np.geomspace(1e-12 * end, end, 481), np.linspace(0.0, end, 257)[1:]]))
        height = self._law.taylor(trial)[0] - start_of(self._law)
        bad = np.flatnonzero(~np.isfinite(height))
        if bad.size:
            last = last_finite(self._law, trial[max(bad[0] - 1, 0)], trial[bad[0]])
            raise InvalidInput(
                f"Formula: the height of '{self.expression}' is not a finite number beyond r = {last:.6g} m; state how "
                f"far it holds, as reach={last:.6g} or less."
            )
        noise = ROUNDING_RATIO * self._law.magnitude(trial)
        (below,) = np.nonzero(height < -noise)
        if below.size:
            raise InvalidInput(
                f"Formula: the height of '{self.expression}' is negative, {height[below[0]]:.3g} m at "
                f"r = {trial[below[0]]:.4g} m, where the bodies would touch before r = 0; check the sign, end it "
                "before by reach=..., or write both bodies into one formula."
            )
        if not np.any(height > noise):
            raise InvalidInput(f"Formula: the height of '{self.expression}' is zero everywhere; give one that rises.")

    @property
    def _law(self) -> Expression:
        return law_of(self.expression, self.constants)

    @property
    def kinks(self) -> Kinks:
        """``(radius, jump of the slope)`` at every stated corner."""
        sides = sides_of(self._law, self.corners)
        return tuple((corner, jump) for corner, (_, jump) in zip(self.corners, sides, strict=True))

    @property
    def rising(self) -> bool:
        """Known of a sum of powers with positive coefficients."""
        return pure(self._law) and all(c > 0.0 for c, _ in self._law.powers)

    def _refuse(self, what: str, r: Array, bad: Array) -> None:
        if np.any(bad):
            first = np.min(r[bad])
            raise InvalidInput(
                f"Formula: the {what} of '{self.expression}' is not a finite number at r = {first:.6g} m; end the "
                f"formula before by reach=..., or state a kink there by corners=({first:.6g},)."
            )

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        r = np.asarray(r, dtype=float)
        height = self._law.taylor(r)[0]
        self._refuse("height", r, ~np.isfinite(height))
        return height - start_of(self._law)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]; at a corner, the value just below it."""
        r = np.asarray(r, dtype=float)
        return power_sum(powers_of(self._law), r)[1] + self._slope_of_rest(r)

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]; at a corner, the value just below it."""
        r = np.asarray(r, dtype=float)
        return power_sum(powers_of(self._law), r)[2] + self._curvature_of_rest(r)

    def _slope_of_rest(self, r: Array) -> Array:
        slope = rest_of(self._law, r)[1]
        for corner, (below, _) in zip(self.corners, sides_of(self._law, self.corners), strict=True):
            slope = np.where(r == corner, below, slope)
        self._refuse("slope", r, np.isnan(slope))
        return slope

    def _curvature_of_rest(self, r: Array) -> Array:
        curvature = rest_of(self._law, np.where(np.isin(r, self.corners), (1.0 - CORNER_OFFSETS[-1]) * r, r))[2]
        self._refuse("curvature", r, np.isnan(curvature))
        return curvature

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        x = np.asarray(x, dtype=float)
        powers = power_sum(stretched(self._law), x)[0]
        return powers if pure(self._law) else powers + abel.gap(self._slope_of_rest, self.corners, x, powers)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        x = np.asarray(x, dtype=float)
        powers = power_sum(stretched(self._law), x)[1]
        if pure(self._law):
            return powers
        return powers + abel.gap_slope(self._slope_of_rest, self._curvature_of_rest, self.kinks, x, powers)

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        x = np.asarray(x, dtype=float)
        powers = power_sum(tuple((c / (p + 1.0), p + 1.0) for c, p in stretched(self._law)), x)[0]
        if pure(self._law):
            return powers
        inner = np.where(x > 0.0, x, 1.0)
        first = x * abel.gap(self._slope_of_rest, self.corners, x, powers / inner)
        second = abel.gap(lambda r: r * r * self._slope_of_rest(r), self.corners, x, powers * inner)
        return np.asarray(powers + first - second / inner)
