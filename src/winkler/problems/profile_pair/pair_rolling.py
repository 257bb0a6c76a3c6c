r"""Two bodies of given profiles that roll over each other with friction: a wheel on a rail, a ball in its groove.

`ProfilePair` finds the patches; on each of them the bodies slip by what their motion as rigid bodies leaves, as far as
friction does not bear it (`winkler.problems.profile_pair.rolled_patch`).  Friction on an inclined patch lifts or lowers
the upper body, so that under a given force the pressures follow from the balance of both,

.. math:: F_z = \sum \int (p\,n_z - \tau_t\,t_z)\,\mathrm dA .
"""

from __future__ import annotations

import dataclasses
from typing import Annotated, ClassVar, cast

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import FallingFriction, Rolled, greatest_coefficient
from winkler.loading.loads import Force
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.pressed_shape.notes import PIXELS_ON_LAYERS, graded_notes
from winkler.problems.profile_pair.creepages import Drift
from winkler.problems.profile_pair.notes import placed_notes, yield_of_patches
from winkler.problems.profile_pair.pressed_pair import PlacedPair, pressed_pair
from winkler.problems.profile_pair.profile_pair import ProfilePair
from winkler.problems.profile_pair.rolled_patch import RolledPatch, rolled_patches
from winkler.problems.rolling.speed import idle_speed_notes, refuse_rest
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.surface_friction.notes import UNCOUPLED_LAYERS
from winkler.problems.surface_rolling.notes import named
from winkler.problems.surface_rolling.small_creep import small_creep_note
from winkler.values.checks.number_checks import Finite, NonNegative, between
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing, standing_left, standing_of
from winkler.values.value import value, words

MOST_TRIALS = 20
FORCE_TOLERANCE = 1e-5
"""Part of the vertical force to which pressures and friction balance it."""
LEAST_BORNE = 0.2
"""Part of the pressures that the vertical force is at least: else friction carries the upper body."""
FEWEST_PIXELS = 16
"""Along a side, of the grids with which results are compared."""
COARSER, LEFT = (0.5, 0.625), 2.0
"""Parts of the pixels of these grids, and the error over the greatest change from them: 1.9 of forty random barrels."""
FASTEST_DRIFT = 0.5
"""Largest lateral drift [-]."""


@value
class ProfilePairRolling:
    """Steady rolling of two bodies with given profiles, with friction.

    Parameters
    ----------
    pair : ProfilePair
        The bodies, their position, load and rolled radius. The force is the vertical resultant of pressures and
        friction.  Layers must be bonded; a graded body needs a finite modulus at its surface.
    friction : Coulomb or FallingFriction
        A positive, finite coefficient, or one that decreases with the slip velocity.
    lateral_drift : float, optional
        Displacement of the upper body towards +y per rolling distance [-].
    yaw_rate, roll_rate : float, optional
        Yaw and roll of the pair per distance rolled [rad/m], about the zero of its profile.
    tolerance : float, optional
        Maximum `misfit` of a patch that counts as solved.
    speed : float, optional
        Rolling speed [m/s], for friction that decreases with the slip velocity (creepage times speed).

    Raises
    ------
    InvalidInput
        If a number is out of range, or friction falls and no speed is given.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9;
    E. A. H. Vollebregt, Vehicle Syst. Dyn. 52 (2014) suppl. 267-283

    Examples
    --------
    A ball that is braked by 0.1 %:

    >>> import numpy as np
    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.sections.cross_profile import CrossProfile
    >>> y = np.linspace(-2e-3, 2e-3, 41)
    >>> flat, ball = CrossProfile(y, 0.0 * y), CrossProfile(y, 10e-3 - np.sqrt(10e-3**2 - y**2))
    >>> steel = HalfSpace.between(Elastic(210e9, 0.3), Elastic(210e9, 0.3))
    >>> pair = ProfilePair(flat, ball, steel, Force(100.0), second_radius=10e-3, rolled_radius=10.01e-3, pixels=48)
    >>> rolls = ProfilePairRolling(pair, Coulomb(0.3)).solve()
    >>> round(float(rolls.saturation[0]), 2)
    0.38
    """

    __words__ = words(
        pair=("", None, "two bodies of given profiles and how they stand"),
        lateral_drift=("", "", "how far the upper body moves across per distance rolled"),
        yaw_rate=("", "rad/m", "turn of the upper body about the vertical per distance rolled"),
        roll_rate=("", "rad/m", "turn of the upper body about the direction along per distance rolled"),
        speed=("V", "m/s", "speed of rolling"),
    )

    pair: ProfilePair
    friction: Rolled
    lateral_drift: Annotated[float, between(-FASTEST_DRIFT, FASTEST_DRIFT)] = 0.0
    yaw_rate: Finite = 0.0
    roll_rate: Finite = 0.0
    tolerance: Annotated[float, between(1e-12, 1e-2)] = 1e-7
    speed: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("kalker_1990", "polonsky_keer_1999", "shackleton_iwnicki_2008")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.UNCOUPLED, Assumption.SLIP, Assumption.STEADY}

    def __post_init__(self) -> None:
        refuse_rest("ProfilePairRolling", self.friction, self.speed)
        compliance_of(self.pair.medium)  # refuses bodies whose tractions are not known

    def solve(self) -> ProfilePairRollingSolution:
        """Return the patches with their creep forces, and the sums of these.

        Raises
        ------
        InvalidInput, OutsideValidity
            As `ProfilePair.solve`. Also if a contact reaches the end of a profile, friction carries the vertical load
            of the upper body, or friction falls too steeply with the slip velocity.
        NotConverged
            If the pressures, stick and slip, or the balance of both are not found.
        """
        pair, wanted = self.pair, float(self.pair.load.force) if isinstance(self.pair.load, Force) else 0.0
        for _ in range(MOST_TRIALS):
            placed, rolled, misfit = self._rolled(pair)
            borne = sum(each.z_force for each in rolled)
            if not wanted or abs(borne / wanted - 1.0) <= FORCE_TOLERANCE:
                return self._solution(pair, placed, rolled, misfit)
            pressed = float(placed.windows.force[1])
            if borne < LEAST_BORNE * pressed:
                raise OutsideValidity(
                    f"ProfilePairRolling: of {pressed:.6g} N that press the upper body up, friction carries "
                    f"{pressed - borne:.6g} N, almost all; give less friction, or other creepages."
                )
            pair = dataclasses.replace(pair, load=Force(pressed * wanted / borne))
        raise NotConverged(
            f"ProfilePairRolling: pressures and friction do not balance {wanted:.6g} N within {MOST_TRIALS} trials; "
            "the patches change with the load: give another load or lateral position."
        )

    def _rolled(self, pair: ProfilePair) -> tuple[PlacedPair, list[RolledPatch], float]:
        placed = pressed_pair(pair)
        if any(region.reaches_end() for region in placed.windows.regions):
            raise OutsideValidity(
                "ProfilePairRolling: the contact is cut by the end of a profile, or by the steep part where its height "
                "is not known, and what rolls beyond is not known either; give a longer profile, or another lateral "
                "position."
            )
        drift = Drift(self.lateral_drift, self.yaw_rate, self.roll_rate)
        radius = pair.rolled_radius or pair.second_radius
        patches = rolled_patches(placed, pair.medium, self.friction, radius, drift, self.tolerance, self.speed)
        return placed, *patches

    def _solution(
        self, pair: ProfilePair, placed: PlacedPair, rolled: list[RolledPatch], misfit: float
    ) -> ProfilePairRollingSolution:
        fewer = COARSER[0] * pair.pixels >= FEWEST_PIXELS
        counts = [round(part * pair.pixels if fewer else pair.pixels / part) for part in COARSER]
        others = [_sums(self._rolled(dataclasses.replace(pair, pixels=count))[1]) for count in counts]
        most = greatest_coefficient(self.friction) * sum(each.patch.force for each in rolled)
        forces = _sums(rolled)
        return ProfilePairRollingSolution(
            problem=self,
            depth=placed.windows.drop,
            height=float(placed.down.place[2]),
            x_force=float(forces[0]),
            y_force=float(forces[1]),
            z_force=float(forces[2]),
            loss_per_distance=sum(each.loss_per_distance for each in rolled),
            peak_pressure=max(each.patch.peak_pressure for each in rolled),
            grid_error=LEFT * float(np.max(np.abs(forces - others))) / most,
            misfit=misfit,
            windows=len(placed.windows.regions),
            patches=tuple(sorted(rolled, key=lambda each: -each.patch.force)),
        )


def _sums(patches: list[RolledPatch]) -> Array:
    """Return the forces on the upper body, along, across and up [N]."""
    return np.asarray(np.sum([[each.x_force, each.y_force, each.z_force] for each in patches], axis=0))


@value
class ProfilePairRollingSolution:
    """The solution of `ProfilePairRolling`; arrays have one value per patch, the highest load first.

    Parameters
    ----------
    problem : ProfilePairRolling
        The problem that was solved.
    depth : float
        Vertical displacement of the upper body since first touch, downwards positive [m].
    height : float
        Height of z = 0 of the upper profile above z = 0 of the lower one [m].
    x_force, y_force, z_force : float
        Resultant of pressures and friction of all patches on the upper body: longitudinal, lateral and upward [N].
    loss_per_distance : float
        Energy dissipated by friction per distance rolled [J/m]; multiplied by the speed it is the power.
    peak_pressure : float
        The maximum [Pa].
    grid_error : float
        Twice the maximum change of a force with half and five eighths of the pixels along a side (below 32 pixels, with
        correspondingly more), over the maximum friction. Two numbers of pixels are used because one change may be small
        by chance.
    misfit : float
        Residual of the law of friction, over the energy dissipated in full sliding.
    windows : int
        Number of separate grids; contacts on different grids are computed independently.
    patches : tuple of RolledPatch
        Where the bodies touch, with maps of pressure, traction and slip.
    """

    __words__ = words(
        depth=("d", "m", "how far the upper body has gone down since first touch"),
        height=("z", "m", "height of the upper profile's zero over that of the lower one"),
        **{name: RolledPatch.__words__[name] for name in ("x_force", "y_force", "z_force", "moment", "stick_share")},
        grid_error=("", "", "error of forces by what changes from fewer pixels, over the friction"),
        misfit=("", "", "what the solver left of the law of friction, over what friction would lose all slipping"),
        windows=("", None, "number of grids of elements"),
        patches=("", None, "contact patches, the one with the highest load first"),
        place=("y", "m", "middle of the pressure of a patch, across"),
        angle=(r"\alpha", "rad", "contact angle of a patch"),
        force=("F_N", "N", "force that presses a patch"),
    )

    problem: ProfilePairRolling
    depth: float
    height: float
    x_force: float
    y_force: float
    z_force: float
    loss_per_distance: float
    peak_pressure: float
    grid_error: float
    misfit: float
    windows: int
    patches: tuple[RolledPatch, ...]

    def _row(self, name: str) -> Array:
        return np.array([getattr(each, name) for each in self.patches])

    @property
    def place(self) -> Array:
        """Lateral positions of the centres of the patches [m], ``(patches,)``."""
        return np.array([each.patch.y for each in self.patches])

    @property
    def angle(self) -> Array:
        """Contact angles [rad], ``(patches,)``."""
        return np.array([each.patch.angle for each in self.patches])

    @property
    def force(self) -> Array:
        """Forces that press the patches [N], ``(patches,)``."""
        return np.array([each.patch.force for each in self.patches])

    @property
    def longitudinal_creepage(self) -> Array:
        """xi [-] at the middles, ``(patches,)``."""
        return np.array([float(each.creepage.longitudinal) for each in self.patches])

    @property
    def lateral_creepage(self) -> Array:
        """eta [-] at the middles, ``(patches,)``."""
        return np.array([float(each.creepage.lateral) for each in self.patches])

    @property
    def spin_creepage(self) -> Array:
        """phi [1/m] at the middles, ``(patches,)``."""
        return np.array([float(each.creepage.spin) for each in self.patches])

    @property
    def longitudinal_force(self) -> Array:
        """Force on the lower body along x [N], ``(patches,)``."""
        return self._row("longitudinal_force")

    @property
    def lateral_force(self) -> Array:
        """Force on the lower body along the arc, towards +y [N], ``(patches,)``."""
        return self._row("lateral_force")

    @property
    def moment(self) -> Array:
        """Moments about the normals [N m], ``(patches,)``."""
        return self._row("moment")

    @property
    def saturation(self) -> Array:
        """Creep forces over mu F_N [-], ``(patches,)``; mu is that of slow slip if friction falls."""
        return self._row("saturation")

    @property
    def stick_share(self) -> Array:
        """Parts of the patches that do not slip [-], ``(patches,)``."""
        return self._row("stick_share")

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: pixels, conformity, friction, creepages, yield."""
        stated = self.problem
        notes = pair_rolling_notes(
            stated.pair.medium, stated.friction, self.patches, self.windows, self.grid_error, self.misfit
        )
        return (*notes, *idle_speed_notes(stated.friction, stated.speed))


KALKER = "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9"
PIXELS_ON_HALF_SPACES = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Contact of homogeneous, linear elastic half-spaces; pressure and traction of every pixel displace all "
    "other pixels of its grid.",
    KALKER,
)
FINE, COARSE = 0.01, 0.1
"""Change of forces from half as many pixels up to which results count as fine, and as coarse."""


def pair_rolling_notes(
    medium: MappedMedium,
    friction: Coulomb | FallingFriction,
    patches: tuple[RolledPatch, ...],
    windows: int,
    grid_error: float,
    misfit: float,
) -> tuple[Note, ...]:
    """Return what was assumed of two profiles that roll, and what grid and solver leave.

    Parameters
    ----------
    medium
        Both bodies.
    friction
        Law of friction.
    patches
        The one that bears most first.
    windows
        Number of grids.
    grid_error, misfit
        As in `ProfilePairRollingSolution`.
    """
    homogeneous = isinstance(medium, HomogeneousMedium)
    greatest = max(patch.greatest_rigid_slip for patch in patches)
    return (
        *((PIXELS_ON_HALF_SPACES,) if homogeneous else (PIXELS_ON_LAYERS, *graded_notes(medium))),
        Note(
            Assumption.SLIP,
            standing_left(misfit, Standing.ASYMPTOTIC),
            f"Kalker's exact theory of rolling, with {named(friction)} in each pixel. The residual of the law of "
            f"friction is {misfit:.1g} of the energy dissipated at full sliding. The rigid slip follows the rolling "
            "radii of both bodies across the patch.",
            KALKER,
        ),
        Note(
            Assumption.STEADY,
            Standing.ASYMPTOTIC,
            "Steady rolling is assumed: creepages and loads have been constant over a distance of several "
            "contact lengths.",
            KALKER,
        ),
        small_creep_note(greatest),
        sticking_note(cast(Medium, medium), greatest_coefficient(friction)) if homogeneous else UNCOUPLED_LAYERS,
        Note(
            Assumption.RESOLUTION,
            standing_of(grid_error, FINE, COARSE),
            f"Forces have an error of up to {100.0 * grid_error:.2g} per cent of the maximum friction force, "
            "twice the change from other grids. The profiles are splines through their points.",
            "comparison of three grids",
            grid_error,
        ),
        *placed_notes(medium, tuple(each.patch for each in patches), False, windows),
        *yield_of_patches(medium, [each.surface_load for each in patches], len(patches) > windows),
    )
