"""Master curves: sweeps, the problem, and its formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind

__all__ = ["MASTER_CURVES"]

SPECTRUM = Equation(
    "All sweeps are those of one spectrum of relaxation times, whose moduli are positive and change smoothly from one "
    "time to the next",
    r"G'(\omega) = G_\infty + \sum_i G_i\,\frac{(\omega\tau_i)^2}{1+(\omega\tau_i)^2}, \quad "
    r"G''(\omega) = \sum_i G_i\,\frac{\omega\tau_i}{1+(\omega\tau_i)^2}, \quad "
    r"G(t) = G_\infty + \sum_i G_i\,e^{-t/\tau_i}",
)
SHIFTED = Equation(
    "Temperature multiplies all times by one factor and, if it is sought, all moduli by another",
    r"G(\omega;T) = b_T\,G(\omega\,a_T)",
)
SUPERPOSED = Equation(
    "Shifts, spectrum, its smoothness and the relative scatter are those of the greatest evidence; the shifts have the "
    "covariance C",
    r"-2\ln P = \sum_j \frac{r_j^2}{\sigma^2} + \lambda\sum_i\left(\ln\frac{G_{i-1}G_{i+1}}{G_i^2}\right)^2",
)
LAWS = Equation(
    "The laws of Williams, Landel and Ferry and of Arrhenius, which is the former with the second constant T₀, "
    "are fitted to "
    "the shifts by generalised least squares",
    r"\log_{10} a_T = -\frac{c_1(T-T_0)}{c_2+T-T_0}, \quad \ln a_T = \frac{Q}{R}\left(\frac{1}{T}-\frac{1}{T_0}\right)",
)

COLD, WARM = "280 K", "300 K"
SWEEPS: dict[str, Any] = {
    "kind": "dynamic_sweeps",
    "temperature": [COLD] * 5 + [WARM] * 5,
    "angular_frequency": ["0.1 rad/s", "1 rad/s", "10 rad/s", "100 rad/s", "1000 rad/s"] * 2,
    "storage_shear": [
        *("1.33 MPa", "1.71 MPa", "2.46 MPa", "3.29 MPa", "3.74 MPa"),
        *("1.1 MPa", "1.3 MPa", "1.66 MPa", "2.42 MPa", "3.26 MPa"),
    ],
    "loss_shear": [
        *("0.27 MPa", "0.5 MPa", "0.67 MPa", "0.53 MPa", "0.24 MPa"),
        *("0.1 MPa", "0.25 MPa", "0.48 MPa", "0.67 MPa", "0.54 MPa"),
    ],
}

MASTER_CURVES = Chapter(
    "bodies that relax",
    kinds={
        "sweeps": {
            "dynamic_sweeps": kind(
                "winkler.materials.sweeps:DynamicSweeps",
                reader="winkler.io.tables.sweeps_table:read_dynamic_sweeps",
                problem="master_curve",
                **{name: content for name, content in SWEEPS.items() if name != "kind"},
            ),
            "relaxation_sweeps": kind(
                "winkler.materials.sweeps:RelaxationSweeps",
                reader="winkler.io.tables.sweeps_table:read_relaxation_sweeps",
                problem="master_curve",
                temperature=[COLD] * 5 + [WARM] * 5,
                time=["1 ms", "10 ms", "0.1 s", "1 s", "10 s"] * 2,
                shear=[
                    *("3.6 MPa", "3.1 MPa", "2.2 MPa", "1.55 MPa", "1.25 MPa"),
                    *("3.1 MPa", "2.2 MPa", "1.55 MPa", "1.25 MPa", "1.1 MPa"),
                ],
            ),
        }
    },
    answers={
        "master_curve": answer(
            "winkler.problems.master_curves.master_curve:MasterCurve",
            headline=("first_constant", "second_constant", "activation_energy"),
            sweeps=SWEEPS,
            reference_temperature=WARM,
            picture=Caption(
                "master_curve",
                "The master curve",
                "Sweeps shifted to the reference temperature, shift factors with both laws, residuals, and the "
                "spectrum.",
            ),
            curves=(("temperature", "shift_factor"), ("relaxation_times", "shears")),
            pictured=PicturedContact.NONE,
            formulas=(SPECTRUM, SHIFTED, SUPERPOSED, LAWS),
        ),
    },
)
