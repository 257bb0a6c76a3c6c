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

from winkler.numerics.transforms.cosine_transform import ScaledResponse, WaveResponse, in_own_lengths
from winkler.values.value import value


@value
class OddResponse(ScaledResponse):
    """A response whose tables are those of odd functions.

    Parameters
    ----------
    response : WaveResponse
        The response itself, whose unit of length is this one's.
    """

    unit: float = 1.0

    @property
    def own(self) -> tuple[OddResponse, float]:
        """The same in its own unit of length, and the unit [m]."""
        own, unit = in_own_lengths(self.response)
        return OddResponse(own), unit


def parity(response: WaveResponse) -> tuple[WaveResponse, float]:
    """Return the response of the kernel, and the sign of the sum in it: 1 for even functions, -1 for odd ones."""
    return (response.response, -1.0) if isinstance(response, OddResponse) else (response, 1.0)
