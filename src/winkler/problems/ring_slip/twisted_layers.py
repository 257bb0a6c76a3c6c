"""What is assumed of layers and gradings under a twist: what holds a layer that slides, and how exact tables are."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import TwistBound
from winkler.media.offers import GradedInDepth, LayerStack, offers
from winkler.values.validity import Assumption, Note, Standing


def twisted_layer_notes(bed: Bed, radius: float, bound: TwistBound) -> Iterator[Note]:
    """Yield what is assumed of the medium under a twist; nothing of bonded layers and of homogeneous bodies.

    Parameters
    ----------
    bed : Bed
        Elastic.
    radius : float
        Of the widest contact of a path [m].
    bound : TwistBound
        What its springs bear.
    """
    medium = bed.medium
    if offers(medium, LayerStack):
        slides = [number for number, layer in enumerate(medium.stack, 1) if not layer.bonded]
        if slides:
            yield Note(
                Assumption.RESPONSE,
                Standing.ASYMPTOTIC,
                f"Layer {slides[0]} slides without friction on its base. The torque twists the layers above this "
                "interface only; they are assumed fixed far from the contact. Let the layers be fixed at a "
                "radius R, much greater than thickness and contact radius. Computed angles without slip are then "
                "too large by a fraction below (a/R)^2. Layers that are not fixed rotate with the contact.",
                "u_theta = M_z / (4 pi r sum of G h) in a sheet",
            )
    if offers(medium, GradedInDepth) and radius > 0.0:
        known = float(medium.punch_torsional_stiffness(np.array(radius)))
        miss = abs(8.0 * medium.torsional_modulus * bound.inertia(radius) / known - 1.0)
        yield Note(
            Assumption.RESOLUTION,
            Standing.ASYMPTOTIC,
            "The kernels of a graded body contain a logarithm, which polynomials approximate. The torsional "
            f"stiffness of the springs differs from that of a flat punch by a fraction of {miss:.1e}. The error "
            "of the maximum torque is about the same fraction.",
            "stiffness of the springs against that of flat punches",
        )
