r"""The same kernel for what is odd in x: a twist, whose springs are displaced by :math:`\varphi x`.

Of the kernel of a response only the sum changes its sign, :math:`K(x,t) = \frac12[C(x-t) - C(x+t)]`, and the equation

.. math:: \theta(x) + \int_0^a K(x,t)\,\theta(t)\,\mathrm dt = x

takes the place of that of a flat punch.  Its tables (`winkler.numerics.transforms.punch_tables`) hold the even function
:math:`\theta/x` where those of a punch hold :math:`\varphi`, :math:`\frac3{a^3}\int_0^a x\,\theta\,\mathrm dx` where
they hold the mean of :math:`\varphi`, and :math:`\theta(a;a)/a` at the edge; the traction of a rigid twist is

.. math:: \tau_1(r;a) = \frac{4G_t}\pi\,\frac{r\,\sigma(r;a)}{\sqrt{a^2-r^2}}

with :math:`\sigma` made of :math:`\theta/x` as that of a punch is made of :math:`\varphi`.
"""

from __future__ import annotations

from winkler.numerics.transforms.cosine_transform import WaveResponse, in_own_lengths
from winkler.numerics.types import ComplexArray
from winkler.values.value import value


@value
class OddResponse:
    """A response whose tables are those of odd functions.

    Parameters
    ----------
    even : WaveResponse
        The response itself.
    """

    even: WaveResponse

    @property
    def own(self) -> tuple[OddResponse, float]:
        """The same in its own unit of length, and the unit [m]."""
        own, unit = in_own_lengths(self.even)
        return OddResponse(own), unit

    @property
    def length(self) -> float:
        """M decays like exp(-2 xi length) [m]."""
        return self.even.length

    @property
    def smooth(self) -> float:
        """C is smooth on this length [m]."""
        return self.even.smooth

    @property
    def span(self) -> float:
        """M is a power series in xi below the inverse of this length [m]."""
        return self.even.span

    @property
    def precision(self) -> float:
        """Error of M."""
        return self.even.precision

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-]."""
        return self.even.excess(xi)


def parity(response: WaveResponse) -> tuple[WaveResponse, float]:
    """Return the response of the kernel, and the sign of the sum in it: 1 for even functions, -1 for odd ones."""
    return (response.even, -1.0) if isinstance(response, OddResponse) else (response, 1.0)
