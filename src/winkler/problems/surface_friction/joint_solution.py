"""The solution of a joint: stiffnesses over the normal force, loops over the amplitude, and how far springs are off."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.types import Array, Quantity, shaped
from winkler.problems.last_cycle import loss_factor
from winkler.problems.rough.surface_contact import SurfaceContactSolution
from winkler.problems.surface_friction.joint_loops import loops_of_stiffness
from winkler.problems.surface_friction.tangential import SurfaceTangentialSolution
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["JointStiffnessSolution"]

BARBER = "J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038"
JAEGER = (
    "M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6; G. Masing, "
    "Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332-335"
)


@value
class JointStiffnessSolution:
    """The solution of a `JointStiffness`; what depends on the normal force has its shape.

    Parameters
    ----------
    problem : JointStiffness
        The problem that was solved.
    contact : SurfaceContactSolution
        The contacts under the normal forces, with the maps of the last one.
    force, nominal_pressure, depth, area : float or ndarray
        F_N [N], that over the area of the map [Pa], d [m] and the area of contact [m^2].
    stiffness, stiffness_x, stiffness_y : float or ndarray
        K_z, K_x, K_y [N/m]: of the contact moved as a whole, without slip.
    disc_stiffness : float or ndarray
        Along the surface [N/m], of the disc that is as stiff across: Mindlin's ratio times K_z.
    share, shear_amplitude : ndarray, (amplitudes,)
        Amplitudes of the shear force along x under the last normal force, over what friction bears and in N.
    shift_amplitude, loss_per_cycle : ndarray, (amplitudes,)
        Of the loops by boundary elements with friction [m], [J].
    spring_shift, spring_loss : ndarray, (amplitudes,)
        Of the same loops from the stiffnesses alone [m], [J].
    spring_forces, spring_stiffnesses : ndarray, (contacts,)
        Normal forces F' [N] up to the last one and K_x [N/m] under them: what the springs know.
    loop : SurfaceTangentialSolution
        The path of all loops by boundary elements.
    """

    __words__ = words(
        contact=("", None, "the contacts under the normal forces"),
        stiffness=("K_z", "N/m", "stiffness across the surface"),
        share=("F_x/(\\mu F_N)", "", "amplitude of the shear force over what friction bears"),
        spring_forces=("F'", "N", "normal forces up to the last one"),
        spring_stiffnesses=("K_x(F')", "N/m", "stiffness along x under lesser normal forces"),
        shift_error=("", "", "greatest difference of a shift from boundary elements, over the greatest shift"),
        loss_error=("", "", "greatest difference of a loss from boundary elements, over the greatest loss"),
        loop=("", None, "the loops by boundary elements"),
    )

    problem: Any
    contact: SurfaceContactSolution
    force: Quantity
    nominal_pressure: Quantity
    depth: Quantity
    area: Quantity
    stiffness: Quantity
    stiffness_x: Quantity
    stiffness_y: Quantity
    disc_stiffness: Quantity
    share: Array
    shear_amplitude: Array
    shift_amplitude: Array
    loss_per_cycle: Array
    spring_shift: Array
    spring_loss: Array
    spring_forces: Array
    spring_stiffnesses: Array
    loop: SurfaceTangentialSolution

    def _over(self, numbers: Quantity, other: Quantity) -> Quantity:
        return shaped(np.asarray(numbers) / np.asarray(other))

    @property
    def ratio_x(self) -> Quantity:
        """K_x / K_z [-]."""
        return self._over(self.stiffness_x, self.stiffness)

    @property
    def ratio_y(self) -> Quantity:
        """K_y / K_z [-]."""
        return self._over(self.stiffness_y, self.stiffness)

    @property
    def disc_ratio(self) -> Quantity:
        """The same ratio of a disc [-]: 2 (1 - nu) / (2 - nu) of bodies alike."""
        return self._over(self.disc_stiffness, self.stiffness)

    @property
    def areal_stiffness(self) -> Quantity:
        """K_z over the area of the map [Pa/m]."""
        return self._over(self.stiffness, self.problem.topography.area)

    @property
    def areal_stiffness_x(self) -> Quantity:
        """K_x over the area of the map [Pa/m]."""
        return self._over(self.stiffness_x, self.problem.topography.area)

    @property
    def areal_stiffness_y(self) -> Quantity:
        """K_y over the area of the map [Pa/m]."""
        return self._over(self.stiffness_y, self.problem.topography.area)

    @property
    def secant_stiffness(self) -> Array:
        """Amplitude of the shear force over that of the shift [N/m], ``(amplitudes,)``."""
        return np.asarray(self.shear_amplitude / self.shift_amplitude)

    @property
    def loss_factor(self) -> Array:
        """Loss per cycle over pi times the amplitudes of shift and shear force [-], ``(amplitudes,)``."""
        return np.asarray(loss_factor(self.loss_per_cycle, self.shift_amplitude, self.shear_amplitude))

    def slip_loop(self, amplitude: int = -1, count: int = 60) -> tuple[Array, Array]:
        """Return shift [m] and shear force [N] of the closed loop of one amplitude by springs, ``(2 count,)``."""
        friction, most = self.problem.law.coefficient, float(self.share[amplitude])
        half = np.linspace(0.0, most, count)
        moved = loops_of_stiffness(self.spring_forces, self.spring_stiffnesses, friction, half[1:]).shift
        u = np.concatenate(([0.0], moved))
        force, shift = friction * float(self.spring_forces[-1]) * (most - 2.0 * half), u[-1] - 2.0 * u
        return np.concatenate((shift, -shift)), np.concatenate((force, -force))

    @property
    def shift_error(self) -> float:
        """Greatest difference of a shift by springs from boundary elements, over the greatest shift [-]."""
        return _difference(self.shift_amplitude, self.spring_shift)

    @property
    def loss_error(self) -> float:
        """Greatest difference of a loss by springs from boundary elements, over the greatest loss [-]."""
        return _difference(self.loss_per_cycle, self.spring_loss)

    @property
    def validity(self) -> tuple[Note, ...]:
        """What stiffnesses and loops leave out, and how far springs and discs are off; the notes of the loops."""
        finite = np.isfinite(np.asarray(self.stiffness))
        ratios = np.stack(
            [np.ravel(np.asarray(part)[finite]) for part in (self.ratio_x, self.ratio_y, self.disc_ratio)]
        )
        off = float(np.max(np.abs(ratios[:2] / ratios[2] - 1.0), initial=0.0))
        return (
            Note(
                Assumption.SLIP,
                Standing.ASYMPTOTIC,
                "Stiffnesses are those of the contact moved as a whole without slip or turning, in which pressures and "
                "tractions do not act on each other: of the first, small motion. Along the surface they differ by up "
                f"to {_per_cent(off)} % from those of the disc that is as stiff across.",
                BARBER,
            ),
            Note(
                Assumption.SLIP,
                Standing.APPROXIMATE,
                "Springs take what slips to leave the contact of a lesser force. Here their shifts are up to "
                f"{_per_cent(self.shift_error)} % of the greatest one off boundary elements with friction, their "
                f"losses up to {_per_cent(self.loss_error)} % of the greatest one.",
                JAEGER,
            ),
            *self.loop.validity,
        )


def _difference(elements: Array, springs: Array) -> float:
    return float(np.max(np.abs(springs - elements)) / np.max(np.abs(elements)))


def _per_cent(error: float) -> str:
    return f"{100.0 * error:.2g}"
