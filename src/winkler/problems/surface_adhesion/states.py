"""An attracted height map at one displacement, and its jumps."""

from __future__ import annotations

from winkler.numerics.types import Array, PerLoad, Q
from winkler.values.value import value, words


@value
class SurfaceJump:
    """Surfaces that ran together or apart by themselves, between two displacements close to each other.

    Parameters
    ----------
    depth : float
        d [m] after the jump.
    force_before, force_after : float
        F_N [N], compression positive.
    area_before, area_after : float
        Of what touches [m^2].
    loss : float
        Energy that is lost [J].
    closing : bool
        Whether the surfaces came closer: a snap-in; otherwise a part of them, or all, has come off.
    """

    __words__ = words(
        force_before=("F_1", "N", "force before a jump"),
        force_after=("F_2", "N", "force after a jump"),
        area_before=("A_1", "m^2", "area of what touched before a jump"),
        area_after=("A_2", "m^2", "area of what touches after a jump"),
        closing=("", None, "whether surfaces ran together in a jump"),
    )

    depth: float
    force_before: float
    force_after: float
    area_before: float
    area_after: float
    loss: float
    closing: bool


@value
class MapAdhesion(PerLoad[Q]):
    """An attracted height map at a displacement, or at those of its path.

    Parameters
    ----------
    depth : float or ndarray, (steps,)
        d [m], as of `SurfaceContact`; negative while the undeformed surfaces are apart.
    force : float or ndarray, (steps,)
        F_N [N], negative where the machine pulls; for a periodic map on one period.
    area : float or ndarray, (steps,)
        Of what touches [m^2], pixels counted and the excess along its edge taken off: on the wall, or nearer than the
        spacing at which surfaces repel each other.
    area_error : float or ndarray, (steps,)
        Estimated error of the area that the grid leaves [m^2].
    attracted_area : float or ndarray, (steps,)
        Of pixels that attract each other by more than a hundredth of the strength, and do not touch [m^2].
    energy : float or ndarray, (steps,)
        Of bodies and surfaces [J]; zero far apart.
    path_work : float or ndarray, (steps,)
        What the machine has spent since bodies were far apart [J].
    dissipation : float or ndarray, (steps,)
        Lost in jumps since the first displacement [J].
    mean_gap : float or ndarray, (steps,)
        Mean distance of the surfaces over the map [m].
    residual : float or ndarray, (steps,)
        Greatest traction out of balance over the greatest traction.
    energy_misfit : float or ndarray, (steps,)
        What the balance of energies lacks since the first displacement, over the greatest energy.
    """

    __words__ = words(
        attracted_area=("A_a", "m^2", "area of what attracts each other and does not touch"),
        energy=("U", "J", "energy of bodies and surfaces, zero far apart"),
        path_work=("W", "J", "what the machine has spent"),
        residual=("", "", "greatest traction out of balance over the greatest traction"),
        energy_misfit=("", "", "what the balance of energies lacks, over the greatest energy"),
    )

    depth: Q
    force: Q
    area: Q
    area_error: Q
    attracted_area: Q
    energy: Q
    path_work: Q
    dissipation: Q
    mean_gap: Q
    residual: Q
    energy_misfit: Q


@value
class SurfaceAdhesionState(MapAdhesion[float]):
    """An attracted height map at one displacement; its numbers are those of `MapAdhesion`.

    Parameters
    ----------
    pressure : ndarray, (nx, ny)
        p [Pa] in every pixel, tension negative.
    separation : ndarray, (nx, ny)
        Distance of the surfaces [m].
    jumps : tuple of SurfaceJump
        Those since the displacement before.
    """

    pressure: Array
    separation: Array
    jumps: tuple[SurfaceJump, ...]
