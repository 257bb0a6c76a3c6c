"""What a worn contact is after some cycles or some distance: what is written down, and from which the march goes on."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.numerics.types import Array, Quantity
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.march import WearMoment
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

DEFAULT_STATES = 41
"""How many states are returned if only the end is given."""
QUOTED = 5
"""So many numbers of a row are repeated in a sentence about it."""


class WornState:
    """What is known of any worn contact, from its bed, and what the bodies have lost at the nodes of a grid."""

    __words__ = words(
        moment=("", None, "from where the march goes on"),
        nodes=("", "m", "distances from the middle"),
        edge=("a", "m", "where the contact ends"),
        removed=("V", None, "what both bodies have lost, per length of a line contact"),
    )

    bed: Any
    elapsed: float
    jump: float
    first_worn: Array
    second_worn: Array
    pressure: Array

    @property
    def nodes(self) -> Array:
        """Distances from the middle [m], ``(n,)``."""
        raise NotImplementedError

    @property
    def edge(self) -> float:
        """Where the contact ends [m]."""
        raise NotImplementedError

    @property
    def mean_pressure(self) -> float:
        """Force over area of contact [Pa]; zero without contact."""
        raise NotImplementedError

    @property
    def _load(self) -> float:
        """Force [N], or that per length [N/m]."""
        raise NotImplementedError

    def _stiffness(self, medium: object) -> float:
        """Return how stiff a medium is under a contact as wide as this one, in units of its own."""
        raise NotImplementedError

    @property
    def moment(self) -> WearMoment:
        """From where the march goes on."""
        return WearMoment(self.elapsed, self.jump, np.array(self.nodes), np.stack([self.first_worn, self.second_worn]))

    @property
    def worn(self) -> Array:
        """What both bodies have lost at the nodes [m], ``(n,)``."""
        return np.asarray(self.first_worn + self.second_worn)

    @property
    def height(self) -> Array:
        """Height of the worn profile at the nodes [m], above the apex before wear, ``(n,)``."""
        return np.asarray(wear_grid(self.bed, self.nodes).height(self.nodes) + self.worn)

    @property
    def worn_depth(self) -> float:
        """Greatest worn depth, of both bodies together [m]."""
        return float(np.max(self.worn))

    @property
    def removed(self) -> float:
        """What both bodies have lost [m^3]; per length of a line contact [m^2]."""
        return self._removed(self.worn)

    def _removed(self, worn: Array) -> float:
        return float(wear_grid(self.bed, self.nodes).transforms.areas @ worn)


@value
class WearState(WornState):
    """A contact that has worn by sliding.

    Parameters
    ----------
    bed : Foundation
        The springs before wear.
    elapsed : float
        How far wear has come: cycles, or distance slid [m].
    jump : float
        How far the next jump of the march would go, as `elapsed`.
    radii : ndarray, (n,)
        r [m] of the nodes, from the axis on.
    first_worn, second_worn : ndarray, (n,)
        What the first and the second body have lost there [m].
    depth, force, radius : float
        d [m], F_N [N], a [m].
    pressure : ndarray, (n,)
        p [Pa], the mean over a ring about each node.
    """

    __words__ = words(
        moment=("", None, "from where the march goes on"),
        radii=("r_i", "m", "distances from the axis"),
        nodes=("r_i", "m", "distances from the axis"),
        edge=("a", "m", "contact radius"),
        removed=("V", "m^3", "what both bodies have lost"),
    )

    bed: Foundation
    elapsed: float
    jump: float
    radii: Array
    first_worn: Array
    second_worn: Array
    depth: float
    force: float
    radius: float
    pressure: Array

    @property
    def nodes(self) -> Array:
        """As `radii`."""
        return self.radii

    @property
    def edge(self) -> float:
        """As `radius`."""
        return self.radius

    @property
    def _load(self) -> float:
        return self.force

    def _stiffness(self, medium: Any) -> float:
        return float(medium.punch_stiffness(np.array([self.radius]))[0])

    @property
    def mean_pressure(self) -> float:
        """F / (pi a^2) [Pa]; zero without contact."""
        return self.force / (np.pi * self.radius**2) if self.radius > 0.0 else 0.0

    @property
    def worn_volume(self) -> float:
        """What both bodies have lost [m^3]."""
        return self._removed(self.worn)

    @property
    def first_volume(self) -> float:
        """What the first body has lost [m^3]."""
        return self._removed(self.first_worn)

    @property
    def second_volume(self) -> float:
        """What the second body has lost [m^3]."""
        return self._removed(self.second_worn)


@value
class FrettingState(WearState):
    """A contact that has worn by fretting.

    Parameters
    ----------
    shift, shear_force : float
        Amplitudes of the shift [m] and of the shear force [N].
    stick_radius : float
        c [m]: nothing slips inside; a if nothing slips at all, zero if everything does.
    slip : ndarray, (n,)
        Amplitude of the slip at the nodes [m].
    loss_per_cycle : float
        Dissipated energy per cycle [J].
    """

    __words__ = words(
        shift=("U", "m", "amplitude of the shift"),
        shear_force=("F_x", "N", "amplitude of the shear force"),
        slip=("s", "m", "amplitude of the slip"),
    )

    shift: float
    shear_force: float
    stick_radius: float
    slip: Array
    loss_per_cycle: float


def goals_of(owner: str, word: str, unit: str, requested: Quantity) -> Array:
    """Return where states are returned, rising, zero or more.

    One number stands for the end and `DEFAULT_STATES` states up to it, closer at the beginning where wear is fastest.

    Raises
    ------
    InvalidInput
        If the numbers are negative, not finite, do not rise, or end at zero.
    """
    numbers = np.asarray(requested)
    sound = numbers.dtype.kind in "fiu" and numbers.size > 0 and numbers.ndim <= 1
    row = np.ravel(numbers) if sound else np.zeros(1)
    more = ", ..." if row.size > QUOTED else ""
    text = f"[{', '.join(f'{each:g}' for each in row[:QUOTED])}{more}]" if sound and numbers.ndim else repr(requested)
    if not (np.all(np.isfinite(row)) and row[0] >= 0.0 and row[-1] > 0.0 and np.all(np.diff(row) > 0.0)):
        raise InvalidInput(
            f"{owner}: {word} is {text}; give one positive number{unit}, or a row of numbers that rise from zero or "
            "more: where the contact is returned."
        )
    if numbers.ndim == 0:
        return np.asarray(float(numbers) * np.linspace(0.0, 1.0, DEFAULT_STATES) ** 2)
    return np.asarray(numbers, dtype=float)
