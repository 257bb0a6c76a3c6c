r"""Plane waves in a transversely isotropic solid whose axis is the depth: what decays, and how a layer is crossed.

With :math:`x=\xi z`, displacements :math:`u_r=U J_1, u_z=W J_0` and tractions over :math:`\xi`,
:math:`\tau=\xi T J_1, \sigma_z=\xi S J_0`,

.. math:: U' = W + \frac{T}{C_{44}},\quad W' = -nU + \frac{S}{C_{33}},\quad T' = cU + nS,\quad S' = -T,\qquad
          n = \frac{C_{13}}{C_{33}},\quad c = C_{11}-\frac{C_{13}^2}{C_{33}} .

The exponents :math:`\pm s_1, \pm s_2` are real or a complex pair; they enter by :math:`p=s_1+s_2` and
:math:`q=s_1s_2=\sqrt{C_{11}/C_{33}}` alone,

.. math:: C_{33}C_{44}\,p^2 = (\sqrt{C_{11}C_{33}}-C_{13})(\sqrt{C_{11}C_{33}}+C_{13}+2C_{44}) .

Tractions that decay downward obey :math:`(T,S)'=-L\,(T,S)` with :math:`L=((p,-q),(1,0))`, and move the surface by
:math:`Y_0=\frac1c((-p,q-n),(q-n,-pq))`.  :math:`e^{-Lx}` is an entire function of :math:`(p^2-4q)/4`: equal exponents,
as those of an isotropic solid, are no special case.  n, c and :math:`1/C_{33}` stay finite where an isotropic solid
does not change its volume.
"""

from __future__ import annotations

import cmath
import enum
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.media.layered.blocks import Four
from winkler.numerics.types import ComplexArray
from winkler.values.errors import OutsideValidity

Body = TransverselyIsotropic | Elastic | Rigid
"""What carries the layers, or presses on them."""


class IsotropicAt(NamedTuple):
    """An isotropic solid with a shear modulus for each wave [Pa] ``(m,)``: one that relaxes, at Laplace's s."""

    shear: Any
    poisson: float


SERIES_TERMS = 10
"""Terms of the series of cosh and sinh up to an argument of one."""


class Wave(enum.Enum):
    """What moves, and what pulls."""

    NORMAL = enum.auto()
    """The normal displacement under a pressure."""
    ALONG = enum.auto()
    """That along a wave under shear along it."""
    COUPLING = enum.auto()
    """The normal displacement under shear along a wave, and that along it under a pressure."""
    ACROSS = enum.auto()
    """That in the plane of the surface, across a wave, under shear across it."""


class WaveConstants(NamedTuple):
    """A solid, in units of its C44, `shear`: one number, or one for each wave of a solid `IsotropicAt`.

    `lateral` is n, `axial` C44/C33, `plane` c/C44, `twist` C66/C44; `total` and `product` are p and q, `split` is
    (p^2 - 4 q)/4.
    """

    shear: float
    lateral: float
    axial: float
    plane: float
    twist: float
    total: float
    product: float
    split: float

    @property
    def steepest(self) -> float:
        """The greatest of the moduli of both exponents."""
        return max(abs(0.5 * self.total + cmath.sqrt(self.split)), 1.0)

    @property
    def slowest(self) -> float:
        """How fast waves die out with the depth, on a path of wave numbers that is turned by 15 degrees, too."""
        root = cmath.sqrt(self.split)
        if root.imag:
            return 0.5 * self.total - math.tan(math.pi / 12.0) * root.imag
        return self.product / (0.5 * self.total + root.real)

    @property
    def impedance(self) -> tuple[float, float]:
        """sqrt(C44 C66) [Pa] of waves across, and sqrt(C66 / C44), by which depths count more than isotropic ones."""
        steep = math.sqrt(self.twist)
        return self.shear * steep, steep

    @property
    def half_space(self) -> Four:
        """C44 Y0."""
        p, q, n, c = self.total, self.product, self.lateral, self.plane
        return tuple(np.array(entry) for entry in (-p / c, (q - n) / c, (q - n) / c, -p * q / c))  # type: ignore[return-value]

    @property
    def rising_half_space(self) -> Four:
        """The same of the fields that decay upward."""
        a, b, c, d = self.half_space
        return -a, b, c, -d

    def decay(self, x: ComplexArray) -> Four:
        """Return exp(-L x): tractions x below those of 1 that decay downward."""
        half = 0.5 * self.total
        if self.split == 0.0:  # as of isotropic solids: one exponent, twice
            even = np.exp(-(self.product / half) * x)
            odd = even * x
            return even - half * odd, self.product * odd, -odd, even + half * odd
        single = cmath.sqrt(self.split)
        # the functions are even in the root: of both signs the one whose exponentials do not grow along a turned path
        root = np.where(np.real(single * x) < 0.0, -single, single)
        slow = np.exp(-(self.product / (half + root)) * x)
        even = 0.5 * slow * (1.0 + np.exp(-2.0 * root * x))
        odd = slow * (-np.expm1(-2.0 * root * x) / (2.0 * root))
        if not np.iscomplexobj(x):
            even, odd = np.real(even), np.real(odd)
        return even - half * odd, self.product * odd, -odd, even + half * odd

    def propagator(self, x: ComplexArray) -> tuple[Four, Four, Four, Four]:
        """Return exp(-x A) in blocks, displacements first: what lies x above displacements and tractions of 1.

        By series, for x times the steepest exponent up to one.
        """
        n, e, c = self.lateral, self.axial, self.plane
        a = np.array([[0.0, 1.0, 1.0, 0.0], [-n, 0.0, 0.0, e], [c, 0.0, 0.0, n], [0.0, 0.0, -1.0, 0.0]])
        square = a @ a
        trace, determinant = c - 2.0 * n, self.product**2
        first, last = 0.0, 1.0  # (A^2)^k = first A^2 + last
        power: ComplexArray = np.ones_like(x)
        even, odd = [np.zeros_like(x), np.zeros_like(x)], [np.zeros_like(x), np.zeros_like(x)]
        for k in range(SERIES_TERMS):
            for part, share in enumerate((last, first)):
                even[part] = even[part] + share * power / math.factorial(2 * k)
                odd[part] = odd[part] + share * power * x / math.factorial(2 * k + 1)
            first, last = trace * first + last, -determinant * first
            power = power * x * x
        parts = ((even[0], np.eye(4)), (even[1], square), (-odd[0], a), (-odd[1], a @ square))

        def block(row: int, column: int) -> Four:
            entries = []
            for i, j in ((row, column), (row, column + 1), (row + 1, column), (row + 1, column + 1)):
                terms = [factor * float(matrix[i, j]) for factor, matrix in parts if matrix[i, j] != 0.0]
                entries.append(sum(terms, np.zeros_like(x)))
            return entries[0], entries[1], entries[2], entries[3]

        return block(0, 0), block(0, 2), block(2, 0), block(2, 2)


def constants_of(solid: Elastic | TransverselyIsotropic | IsotropicAt) -> WaveConstants:
    """Return what the waves need of a solid."""
    if isinstance(solid, Elastic | IsotropicAt):
        nu = solid.poisson
        return WaveConstants(
            solid.shear, nu / (1.0 - nu), (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)), 2.0 / (1.0 - nu), 1.0, 2.0, 1.0, 0.0
        )
    c11, c13, c33, c44 = solid.c11, solid.c13, solid.c33, solid.c44
    mean, ratio = math.sqrt(c11 * c33), c33 * c44
    product = math.sqrt(c11 / c33)
    total = math.sqrt((mean - c13) * (mean + c13 + 2.0 * c44) / ratio)
    split = 0.25 * (mean + c13) * (mean - c13 - 2.0 * c44) / ratio  # (p^2 - 4 q) / 4 without a difference of squares
    plane = (mean - c13) * (mean + c13) / ratio
    return WaveConstants(c44, c13 / c33, c44 / c33, plane, 0.5 * (c11 - solid.c12) / c44, total, product, split)


def twist_constants(body: Elastic | TransverselyIsotropic | Rigid) -> tuple[float, float]:
    """Return the modulus [Pa] of a twist, and by how much depths count more than distances along the surface.

    For a transversely isotropic body sqrt(C44 C66) and sqrt(C66 / C44).
    """
    if isinstance(body, Rigid):
        raise OutsideValidity("A rigid body is not deformed by a twist; request the other side.")
    return constants_of(body).impedance


def half_space_compliance(body: Body | IsotropicAt, part: Wave) -> float:
    """Return what waves on a half-space answer, times xi / 2 [1/Pa]; zero of a rigid one.

    Of a pressure 1/E*; of shear along a wave 1/m_L, across it 1/m_T = 1 / (2 sqrt(C44 C66)).  One for each wave if the
    solid is `IsotropicAt`.
    """
    if isinstance(body, Rigid):
        return 0.0
    constants = constants_of(body)
    if part is Wave.ACROSS:
        return 0.5 / constants.impedance[0]
    compliance = 0.5 / (constants.plane * constants.shear)
    if part is Wave.COUPLING:
        return compliance * (constants.product - constants.lateral)
    return compliance * constants.total * (constants.product if part is Wave.NORMAL else 1.0)


def in_plane_share(part: Wave, compliance: Four) -> ComplexArray:
    """Return one part of a compliance, displacements times xi per tractions, as that of `half_space_compliance`."""
    along, coupling, _, normal = compliance
    if part is Wave.COUPLING:
        return np.asarray(0.5 * coupling)
    return np.asarray(-0.5 * (normal if part is Wave.NORMAL else along))


def stiffness_scale(solid: Elastic | TransverselyIsotropic) -> tuple[float, float]:
    """Return the least and the greatest of the moduli of a solid that bound lengths [Pa]; G of an isotropic one."""
    constants = constants_of(solid)
    moduli = [1.0] if isinstance(solid, Elastic) else [1.0, 0.5 * constants.plane, constants.twist]
    return constants.shear * min(moduli), constants.shear * max(moduli)
