r"""What the springs of a sheared contact are at one point of its path, and how far they can be trusted."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings, slipping_springs
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.numerics.types import Array, Quantity
from winkler.problems.friction.sheared_springs import sheared_by_pieces
from winkler.problems.round_march import RoundNormal
from winkler.problems.row import CURVED_STEP_TOLERANCE
from winkler.values.checks.contract import offered
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

RATIO_TOLERANCE = 1e-9
"""Ratios of stiffness that differ by less are equal."""


@offered("a law with a method shear_bound(line_load)")
@runtime_checkable
class OwnLaw(Protocol):
    """The methods of a law of friction of one's own: how much springs bear along the surface.

    It is evaluated once for many steps, and holds for every spring by itself.  Make it a value (frozen, equal by
    content).
    """

    def shear_bound(self, line_load: Array) -> Array:
        """Return the greatest load along the surface [N/m] of springs under a load [N/m]; same shape, not negative."""
        ...


SpringLaw = Coulomb | StaticKinetic | OwnLaw
"""How springs may rub."""


@value
class SpringState(RoundNormal[float]):
    """The springs at one point of the path; its normal contact is that of `RoundNormal`.

    Parameters
    ----------
    bed : Bed
        Profile and medium.
    springs : Springs
        The row.
    shift, shear_force : float or ndarray, (2,)
        u_x [m] and F_x [N]; vectors in the plane.
    stick_radius : float
        Up to where nothing slips [m].
    work, stored_energy, dissipation : float
        Spent by the lateral motion since the beginning, stored in the tangential displacement, and lost since the
        beginning [J].
    displacement : ndarray, (n,) or (n, 2)
        u_t of every spring [m].
    """

    __words__ = words(
        springs=("", None, "springs of the one-dimensional foundation"),
        displacement=("u_t", "m", "displacement of every spring along the surface"),
        work=("W", "J", "what the lateral motion has spent since the beginning"),
    )

    bed: Bed
    springs: Springs
    shift: Quantity
    shear_force: Quantity
    stick_radius: float
    work: float
    stored_energy: float
    dissipation: float
    displacement: Array

    @property
    def pressed(self) -> PressedSprings:
        """The springs' displacement across the surface."""
        return PressedSprings(self.bed, self.depth, self.radius)

    @property
    def sheared(self) -> ShearedSprings:
        """The springs' displacement along the surface, straight between them: fields are restored from it.

        Raises
        ------
        OutsideValidity
            In a layered medium, where tractions are not those of pressed contacts.
        """
        inner = self.springs.gap < self.depth
        edges = np.append(self.springs.gap[inner], self.depth)
        ends = np.append(self.displacement[inner], np.zeros((1, *np.shape(self.shift))), axis=0)
        bed = slipping_springs(self.bed)
        return sheared_by_pieces(bed, self.depth, self.shift, edges, ends[:-1], ends[1:])


IN_PLANE = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "In planar motion every spring slips along its own displacement. The restored traction is not admissible "
    "everywhere. It exceeds mu times the pressure by 5 % after two strokes at a right angle. For circular motion "
    "the excess grows logarithmically at the edge of the stick zone.",
    "measured on a sphere, each stroke or the circle's radius half the shift of gross slip; tests/problems/"
    "friction/test_single_springs.py",
)

DROPPING = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "Each spring that begins to slip drops to its kinetic bound, so the traction jumps at the edge of the stick "
    "zone. Errors of force and energy are of first order in the spring spacing; restored tractions are singular "
    "there. Depth and displacement are assumed to vary linearly between two points. If a prescribed force curves "
    "their path, give more points.",
    "property of the rule; the theory of Cattaneo and Mindlin has one coefficient only",
)
OF_SPRINGS = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "The law of friction limits the load of every spring, not the traction at every point. Both limits are "
    "equivalent only if the bound is proportional to the load.",
    "Coulomb friction is the case in which they are: M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, "
    "doi:10.1016/S0020-7683(97)00154-6",
)


def spring_notes(springs: Springs, law: SpringLaw, *, in_plane: bool) -> tuple[Note, ...]:
    """Return how far a march of springs can be trusted.

    Parameters
    ----------
    springs : Springs
        The row.
    law : Coulomb, StaticKinetic or OwnLaw
        Law of friction.
    in_plane : bool
        Whether the bodies move in more than one direction.
    """
    count = max(springs.gap.size, 1)
    notes = [
        Note(
            Assumption.RESOLUTION,
            Standing.ASYMPTOTIC,
            f"{count} springs: errors of shear force and energies are of second order in their spacing. Under a "
            f"sphere the error of the shear force is below {1.0 / count**2:.1g} of the coefficient times the "
            "normal force. If a prescribed force curves the path between two points, the springs are followed "
            f"within {CURVED_STEP_TOLERANCE:.0e} of the maximum displacement.",
            "compared with the exact solution for one direction, tests/convergence/test_order_springs.py",
        )
    ]
    if isinstance(law, StaticKinetic) and law.static_coefficient > law.kinetic_coefficient:
        notes.append(DROPPING)
    elif not isinstance(law, Coulomb | StaticKinetic):
        notes.append(OF_SPRINGS)
    if in_plane:
        notes.append(IN_PLANE)
    spread = ratio_spread(springs)
    if spread > RATIO_TOLERANCE:
        notes.append(
            Note(
                Assumption.SLIP,
                Standing.APPROXIMATE,
                f"The ratio of tangential to normal stiffness varies between the springs by {100.0 * spread:.2g} "
                "%. A friction bound for every spring is then not a bound for every point of the surface. "
                "Compared with annular elements (method rings), shear forces differed by up to 8 % of the sliding "
                "force on soft coatings, by up to 44 % on hard ones.",
                "tests/problems/friction/test_slip_on_layers.py; the table of docs/chapters/coatings.md",
            )
        )
    return tuple(notes)


def ratio_spread(springs: Springs) -> float:
    """Return by how much the ratio of tangential to normal stiffness differs between springs, in parts of it."""
    ratio = springs.mindlin_ratio
    return float(np.ptp(ratio) / np.max(ratio)) if ratio.size else 0.0
