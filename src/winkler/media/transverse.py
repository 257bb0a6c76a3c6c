r"""Transversely isotropic half-spaces whose axis is the surface normal: the same springs with other moduli.

.. math:: E^*_{TI} = \frac{2\sqrt{C_{44}}\,(C_{11}C_{33}-C_{13}^2)}
          {\sqrt{C_{11}}\sqrt{(\sqrt{C_{11}C_{33}}-C_{13})(C_{13}+2C_{44}+\sqrt{C_{11}C_{33}})}} , \qquad
          \frac{2}{G^*_{TI}} = \frac{\sqrt{C_{33}/C_{11}}}{E^*_{TI}} + \frac{1}{2\sqrt{C_{44}C_{66}}}
"""

from __future__ import annotations

from winkler.materials.elastic import RIGID, Rigid
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.layered.solid_field import solid_field
from winkler.media.layered.wave_constants import Body
from winkler.media.medium import Displacement, exact_response, rigid_body
from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
from winkler.values.value import value


@value
class TransverselyIsotropicHalfSpace(HomogeneousMedium):
    """Two half-spaces, at least one of them transversely isotropic about the surface normal.

    Parameters
    ----------
    first : TransverselyIsotropic, Elastic or Rigid
        The body below, z > 0.
    second : TransverselyIsotropic, Elastic or Rigid, optional
        The body above; rigid by default.

    Raises
    ------
    InvalidInput
        If both bodies are rigid.

    References
    ----------
    H. A. Elliott, Proc. Camb. Phil. Soc. 45 (1949) 621-630, doi:10.1017/S0305004100025305
    """

    first: Body
    second: Body = RIGID

    def __post_init__(self) -> None:
        self._refuse_rigid("elastic")

    @classmethod
    def between(cls, first: Body, second: Body = RIGID) -> TransverselyIsotropicHalfSpace:
        """Return the medium between two bodies; the second is rigid by default."""
        return cls(first, second)

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements inside the first body (`below`) or the second, at depths z >= 0 into it."""
        body = self.first if below else self.second
        if isinstance(body, Rigid):
            raise rigid_body(below)
        return solid_field(displacement, r, z, modulus=self.modulus, solid=body)

    notes = exact_response(
        "Frictionless contact of homogeneous half-spaces, transversely isotropic about the surface normal. "
        "Pressure and depth follow from the isotropic solution with the effective modulus.",
        "H. A. Elliott, Proc. Camb. Phil. Soc. 45 (1949) 621, doi:10.1017/S0305004100025305",
    )
    """The assumptions."""
