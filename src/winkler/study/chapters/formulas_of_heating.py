"""The formulas behind the answers for frictional heating."""

from __future__ import annotations

from winkler.study.chapters.formula import Formula

__all__ = ["FRETTED", "RUBBED_WARM", "WARMING"]

FLUX = Formula("Friction turns into heat where the bodies press", r"q(r) = \mu\,p(r)\,v, \quad Q = \mu\,F_N\,v")
AT_REST = Formula(
    "On a body that rests against the contact, temperature follows the flux as the surface follows the pressure",
    r"T(r) = \frac{1}{\pi\lambda}\int_0^r \frac{q_1(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x, \quad "
    r"q_1(x) = 2\int_x^a \frac{q(r)\,r}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)
MOVING = Formula(
    "On a body that moves at the speed V the same sum goes over all directions, each with a line load of its own",
    r"T(x,y) = \frac{1}{2\pi\lambda}\int_{-\pi/2}^{\pi/2} "
    r"\left[q_1(s)-\int_s^a q_1(t)\,\frac{b}{2}\,D\left(\frac{b}{2}(t-s)\right)\,\mathrm{d}t\right]\,\mathrm{d}\theta",
)
LAG = Formula(
    "with the direction θ and the kernel",
    r"b = \frac{V}{\kappa}\,\cos\theta, \quad s = x\,\cos\theta+y\,\sin\theta, \quad D(z) = e^{-z}(I_0(z)-I_1(z))",
)
SHARE = Formula(
    "The bodies share the heat; T₁ and T₂ are what each would have of all of it, their greatest or their mean",
    r"\alpha = \frac{T_2}{T_1+T_2}, \quad \mathrm{Pe} = \frac{V\,a}{2\kappa}",
)
GROWN = Formula(
    "From the beginning on, waves of temperature have grown to a part that depends on their wave number k alone",
    r"T_k(t) = T_k(\infty)\,\mathrm{erf}\left(k\sqrt{\kappa t}\right)",
)
CYCLE = Formula(
    "In every cycle the surfaces turn so much into heat, f times a second",
    r"w(r) = \oint \tau\,\mathrm{d}s, \quad q(r) = f\,w(r), \quad Q = f\,W",
)
TOGETHER = Formula(
    "Both bodies rest against it and take the heat in proportion to their conductivities",
    r"T(r) = \frac{1}{\pi(\lambda_1+\lambda_2)}\int_0^r \frac{q_1(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x, \quad "
    r"q_1(x) = 2\int_x^a \frac{q(r)\,r}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)

RUBBED_WARM = (FLUX, AT_REST, MOVING, LAG, SHARE)
"""Of steady sliding, after the pressure is known."""
WARMING = (FLUX, AT_REST, GROWN, SHARE)
"""Of sliding that begins."""
FRETTED = (CYCLE, TOGETHER)
"""Of a motion that is repeated, after its tractions are known."""
