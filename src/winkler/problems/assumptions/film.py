r"""How far layers are compressed against their thickness.

Linear elasticity needs strains that are small.  In layers of total thickness h the mean strain is the depth less
what the bodies on either side of them yield, over h.  A half-space yields :math:`0.75\,F/(E^*a)` under the middle of a
Hertzian pressure, a rigid body nothing; on a rigid base under a rigid body the number is d/h.
"""

from __future__ import annotations

from winkler.foundation.bed import Bed
from winkler.media.offers import LayerStack, offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.values.validity import Assumption, Note, Standing, standing_of

SMALL_STRAIN, LARGE_STRAIN = 0.1, 0.5
"""Mean strain [-] up to which linear elasticity describes a layer, and from which on it does not."""
VERDICTS = {
    Standing.ASYMPTOTIC: "small, as linear elasticity assumes",
    Standing.APPROXIMATE: "not small: expect forces with an error of about the same fraction",
    Standing.OUTSIDE: (
        "far from small: use a smaller load or a thicker layer, because linear elasticity does not describe this "
        "contact"
    ),
}
DIMITRIADIS = "E. K. Dimitriadis et al., Biophys. J. 82 (2002) 2798-2810, doi:10.1016/S0006-3495(02)75620-8"
LONG = "R. Long, M. S. Hall, M. Wu, C.-Y. Hui, Biophys. J. 101 (2011) 643-650, doi:10.1016/j.bpj.2011.06.049"


def film_strain(medium: LayerStack, depth: float, force: float, radius: float) -> float:
    """Return the mean compression of the layers over their thickness [-].

    Parameters
    ----------
    medium : LayerStack
    depth, force, radius : float
        d [m], F_N [N] and a [m], positive.
    """
    from winkler.media.layered.wave_constants import (  # not loaded for numbers of other bodies
        Wave,
        half_space_compliance,
    )

    yielding = sum(half_space_compliance(body, Wave.NORMAL) for body in (medium.on, medium.second))
    return max(depth - 0.75 * max(force, 0.0) * yielding / radius, 0.0) / medium.thickness


def film_notes(bed: Bed, depth: float, force: float, radius: float) -> tuple[Note, ...]:
    """Return what the depth means for the layers of a coated body, and what a pyramid misses; else nothing.

    Parameters
    ----------
    bed : Bed
    depth, force, radius : float
        d [m], F_N [N] and a [m] of the deepest contact.
    """
    medium = bed.medium.elastic if offers(bed.medium, RelaxingMedium) else bed.medium
    pyramid: tuple[Note, ...] = ()
    if hasattr(getattr(bed, "profile", None), "sides"):
        from winkler.problems.assumptions.pyramid_film import pyramid_notes  # not loaded for numbers of other bodies

        pyramid = pyramid_notes(bed, medium, radius)
    if not offers(medium, LayerStack) or radius <= 0.0 or depth <= 0.0:
        return pyramid
    return (film_note(depth / medium.thickness, film_strain(medium, depth, force, radius)), *pyramid)


def film_note(depth: float, strain: float) -> Note:
    """Return what the depth and the mean compression of layers over their thickness [-] mean."""
    standing = standing_of(strain, SMALL_STRAIN, LARGE_STRAIN)
    return Note(
        Assumption.FILM,
        standing,
        f"The depth is {depth:.3g} of the thickness of the layers; their mean compression is {strain:.3g} of it: "
        f"{VERDICTS[standing]}.",
        f"{DIMITRIADIS}; {LONG}",
    )
