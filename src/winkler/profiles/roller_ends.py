r"""Ends of rollers: by how much the radius of a cylindrical roller is smaller at a distance x from its middle.

.. math:: z_\mathrm{crown} = \frac{(|x|-s)^2}{2R_c} , \qquad
          z_\mathrm{log} = K_1 A\ln\frac1{1-\left(1-\mathrm e^{-z_m/(K_1A)}\right)
          \left(\frac{|x|-s}{\ell-s}\right)^2} , \qquad A = \frac P{\pi E^*} ,

beyond a straight part from -s to s of a roller from -l to l; the drop of Lundberg, K_1 = 1, s = 0 and an unbounded z_m,
is the displacement under an even force P per length, farther from the ends than some half-widths of the contact.
"""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.number_checks import NonNegative, Number, Positive, PositiveOrInfinite
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@value
class SharpEnds:
    """A straight roller with sharp edges, where the pressure is infinite."""

    def drop(self, x: Array, half_length: float, modulus: float) -> Array:
        """Return the decrease of the radius at x [m]: zero."""
        return np.zeros(np.shape(x))

    def marks(self, half_length: float) -> tuple[float, ...]:
        """Return the positions [m] of corners of the generator: none."""
        return ()

    def refuse(self, half_length: float) -> None:
        """Check the dimensions; all are allowed."""


@value
class CrownedEnds:
    """A crown: an arc of a large radius, over the whole roller or beyond a straight part in the middle.

    Parameters
    ----------
    crown_radius : float
        R_c [m] of the arc along the roller, approximated by a parabola.
    straight_length : float, optional
        Length of the straight part in the middle [m], tangent to the arcs.
    """

    __words__ = words(
        crown_radius=("R_c", "m", "radius of the arc along the roller"),
        straight_length=("2s", "m", "length of the straight part in the middle of the roller"),
    )

    crown_radius: Positive
    straight_length: NonNegative = 0.0

    def drop(self, x: Array, half_length: float, modulus: float) -> Array:
        """Return the decrease of the radius at x [m]."""
        beyond = np.maximum(np.abs(x) - 0.5 * self.straight_length, 0.0)
        return np.asarray(beyond**2 / (2.0 * self.crown_radius))

    def marks(self, half_length: float) -> tuple[float, ...]:
        """Return the places [m] where the arcs begin."""
        s = 0.5 * self.straight_length
        return (-s, s) if s > 0.0 else ()

    def refuse(self, half_length: float) -> None:
        """Raise an error if the straight part leaves no length for the arcs."""
        if self.straight_length >= 2.0 * half_length:
            raise InvalidInput(
                f"RollerContact: the straight part of {self.straight_length:.6g} m covers the whole roller of "
                f"{2.0 * half_length:.6g} m; give SharpEnds, or a shorter part."
            )


@value
class RoundedEnds:
    """A straight roller with rounded edges.

    Parameters
    ----------
    edge_radius : float
        Radius of the edges [m], less than half of the length. The arc is approximated by a parabola, which is accurate
        where the bodies touch.
    """

    edge_radius: Positive

    def drop(self, x: Array, half_length: float, modulus: float) -> Array:
        """Return the decrease of the radius at x [m]."""
        beyond = np.maximum(np.abs(x) - (half_length - self.edge_radius), 0.0)
        return np.asarray(beyond**2 / (2.0 * self.edge_radius))

    def marks(self, half_length: float) -> tuple[float, ...]:
        """Return the places [m] where the edges begin."""
        return (self.edge_radius - half_length, half_length - self.edge_radius)

    def refuse(self, half_length: float) -> None:
        """Raise an error if the edges leave no straight part."""
        if self.edge_radius >= half_length:
            raise InvalidInput(
                f"RollerContact: edges rounded with {self.edge_radius:.6g} m leave nothing of a roller of "
                f"{2.0 * half_length:.6g} m; give a smaller edge_radius, or CrownedEnds."
            )


@value
class LogarithmicEnds:
    """A logarithmic crown after Lundberg, with the parameters of Fujiwara and Kawase.

    Parameters
    ----------
    design_force_per_length : float
        P [N/m] of the load for which the crown is designed, its force over the length. With K_1 = 1 the pressure is
        uniform along the roller, except for a rise near the ends.
    load_factor : float, optional
        K_1 [-]: the drop over that of Lundberg; use a larger value for rollers that may tilt.
    crowned_share : float, optional
        K_2 [-]: crowned fraction of the length; the middle is straight.
    edge_drop : float, optional
        z_m [m]: drop at the ends; unbounded (the default) after Lundberg.

    References
    ----------
    G. Lundberg, Forsch. Ing.-Wes. 10 (1939) 201-211, doi:10.1007/BF02584950; H. Fujiwara, T. Kawase, NTN Tech. Rev. 75
    (2007) 140-148
    """

    __words__ = words(
        design_force_per_length=("P", "N/m", "force per length for which the crown is made"),
        load_factor=("K_1", "", "drop of the crown over that of Lundberg"),
        crowned_share=("K_2", "", "crowned part of the length of the roller"),
        edge_drop=("z_m", "m", "drop of the crown at the ends of the roller"),
    )

    design_force_per_length: Positive
    load_factor: Positive = 1.0
    crowned_share: Annotated[float, Number("give a number above 0 and up to 1", 0.0, 1.0, excluded=(0.0,))] = 1.0
    edge_drop: PositiveOrInfinite = math.inf

    def drop(self, x: Array, half_length: float, modulus: float) -> Array:
        """Return the decrease of the radius at x [m]; infinite at the ends for an unbounded crown."""
        straight = (1.0 - self.crowned_share) * half_length
        share = np.maximum(np.abs(x) - straight, 0.0) / (half_length - straight)
        scale = self.load_factor * self.design_force_per_length / (math.pi * modulus)
        inside = 1.0 + math.expm1(-self.edge_drop / scale) * share**2
        safe = np.where(inside > 0.0, inside, 1.0)
        return np.where(inside > 0.0, -scale * np.log(safe), self.edge_drop)

    def marks(self, half_length: float) -> tuple[float, ...]:
        """Return the places [m] where the crown begins."""
        s = (1.0 - self.crowned_share) * half_length
        return (-s, s) if s > 0.0 else ()

    def refuse(self, half_length: float) -> None:
        """Check the dimensions; all are allowed."""


RollerEnds: TypeAlias = SharpEnds | CrownedEnds | RoundedEnds | LogarithmicEnds
"""Ends of a roller."""
