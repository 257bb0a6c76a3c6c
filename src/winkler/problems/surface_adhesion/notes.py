"""How far the adhesion of a height map can be trusted: grid, law, balance, jumps, border, slopes."""

from __future__ import annotations

import math

from winkler.laws.adhesion import ShortRange
from winkler.media.mapped import MappedMedium
from winkler.numerics.attracted.attraction import RoundedStep
from winkler.problems.rough.mapped_medium import medium_notes
from winkler.problems.rough.surface_notes import surface_notes
from winkler.problems.surface_adhesion.law_on_grid import AttractionOnGrid, RangedLaw
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing, standing_left

__all__ = ["surface_adhesion_notes"]

REY = "V. Rey, G. Anciaux, J.-F. Molinari, Comput. Mech. 60 (2017) 69-81, doi:10.1007/s00466-017-1392-5"
TABOR = "D. Tabor, J. Colloid Interface Sci. 58 (1977) 2-13, doi:10.1016/0021-9797(77)90366-6"
BALANCE = "work of the machine, change of the energy and losses in jumps, added up"


def surface_adhesion_notes(
    rough: Topography,
    medium: MappedMedium,
    law: RangedLaw,
    on_grid: AttractionOnGrid,
    tabor: float,
    residual: float,
    energy_misfit: float,
    count: int,
) -> tuple[Note, ...]:
    """Return what was assumed of an attracted map, and what the solver left.

    Parameters
    ----------
    rough : Topography
        The map.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    law : RangedLaw
        As it was stated.
    on_grid : AttractionOnGrid
        As it was solved.
    tabor : float
        Tabor's parameter of a ball as curved as the map.
    residual, energy_misfit : float
        Greatest ones of all displacements.
    count : int
        Of jumps.
    """
    mapped = surface_notes(rough, math.inf, 0.0, 0.0, 0.0)
    number = "is flat" if math.isinf(tabor) else f"has a Tabor number of {tabor:.3g}"
    if isinstance(law, ShortRange):
        stated = (
            f"In place of an attraction without range one that fades exponentially over {on_grid.range:.3g} m, the "
            f"shortest that the grid resolves; with it the map {number}, and forces near those without range are off "
            "by some per cent below 5; pull_off_without_range() extrapolates the pull-off force."
        )
    elif isinstance(on_grid.law, RoundedStep):
        stated = (
            f"The constant stress ends over {2.0 * on_grid.law.half_width:.3g} of its range instead of at once, so "
            f"that the grid does not pin it; the map {number}."
        )
    else:
        stated = f"Gaps are taken between flat parts of the surfaces (Derjaguin); the map {number}."
    return (
        *(note for note in medium_notes(medium, rough, math.inf, 0.0, 0.0, 0.0) if note not in mapped[2:]),
        Note(
            Assumption.RESOLUTION,
            standing_left(residual, Standing.ASYMPTOTIC),
            f"The zone of attraction beside an edge spans {on_grid.span:.3g} pixels; the pull-off force of a ball is "
            "then within about a per cent, in small jumps from pixel to pixel. Tractions are out of balance by at "
            f"most {residual:.1g} of the greatest.",
            REY,
        ),
        Note(Assumption.ADHESION, Standing.APPROXIMATE, stated, TABOR),
        Note(
            Assumption.EQUILIBRIUM,
            Standing.APPROXIMATE if energy_misfit > 0.01 else Standing.ASYMPTOTIC,
            f"The surfaces move slowly, in {count} jumps at once, in which all that the energy falls by is lost; the "
            f"balance of energies lacks {energy_misfit:.1g} of the greatest energy. Jumps of single pixels are part of "
            "this.",
            BALANCE,
        ),
        *mapped[3:],
    )
