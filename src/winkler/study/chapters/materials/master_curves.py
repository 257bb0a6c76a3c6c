"""Master curves: sweeps, the problem, and its formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind

SPECTRUM = Equation(
    "All sweeps have one spectrum of relaxation times, with positive moduli that change smoothly from one time to "
    "the next",
    r"G'(\omega) = G_\infty + \sum_i G_i\,\frac{(\omega\tau_i)^2}{1+(\omega\tau_i)^2}, \quad "
    r"G''(\omega) = \sum_i G_i\,\frac{\omega\tau_i}{1+(\omega\tau_i)^2}, \quad "
    r"G(t) = G_\infty + \sum_i G_i\,e^{-t/\tau_i}",
)
SHIFTED = Equation(
    "Temperature multiplies all times by one factor and, optionally, all moduli by another",
    r"G(\omega;T) = b_T\,G(\omega\,a_T)",
)
SUPERPOSED = Equation(
    "Shift factors, spectrum, smoothness and scatter maximise the evidence; the shift factors have the covariance C",
    r"-2\ln P = \sum_j \frac{r_j^2}{\sigma^2} + \lambda\sum_i\left(\ln\frac{G_{i-1}G_{i+1}}{G_i^2}\right)^2",
)
LAWS = Equation(
    "The laws of Williams, Landel and Ferry and of Arrhenius, which is the former with the second constant T₀, "
    "are fitted to "
    "the shifts by generalised least squares",
    r"\log_{10} a_T = -\frac{c_1(T-T_0)}{c_2+T-T_0}, \quad \ln a_T = \frac{Q}{R}\left(\frac{1}{T}-\frac{1}{T_0}\right)",
)

WARM = "300 K"
TEMPERATURES = ("280 K", WARM, "320 K", "340 K")
SWEEPS: dict[str, Any] = {
    "kind": "dynamic_sweeps",
    "temperature": [temperature for temperature in TEMPERATURES for _ in range(5)],
    "angular_frequency": ["0.1 rad/s", "1 rad/s", "10 rad/s", "100 rad/s", "1000 rad/s"] * len(TEMPERATURES),
    "storage_shear": [
        *("1.72 MPa", "2.92 MPa", "3.71 MPa", "3.93 MPa", "3.98 MPa"),
        *("1.11 MPa", "1.47 MPa", "2.5 MPa", "3.53 MPa", "3.89 MPa"),
        *("1.04 MPa", "1.15 MPa", "1.61 MPa", "2.76 MPa", "3.65 MPa"),
        *("1.02 MPa", "1.07 MPa", "1.29 MPa", "2.08 MPa", "3.28 MPa"),
    ],
    "loss_shear": [
        *("0.594 MPa", "0.716 MPa", "0.318 MPa", "0.0922 MPa", "0.024 MPa"),
        *("0.142 MPa", "0.449 MPa", "0.764 MPa", "0.449 MPa", "0.142 MPa"),
        *("0.0495 MPa", "0.183 MPa", "0.536 MPa", "0.746 MPa", "0.367 MPa"),
        *("0.024 MPa", "0.0922 MPa", "0.318 MPa", "0.716 MPa", "0.594 MPa"),
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
                temperature=[temperature for temperature in TEMPERATURES for _ in range(5)],
                time=["1 ms", "10 ms", "0.1 s", "1 s", "10 s"] * len(TEMPERATURES),
                shear=[
                    *("3.97 MPa", "3.89 MPa", "3.59 MPa", "2.84 MPa", "1.85 MPa"),
                    *("3.82 MPa", "3.4 MPa", "2.5 MPa", "1.6 MPa", "1.18 MPa"),
                    *("3.52 MPa", "2.71 MPa", "1.75 MPa", "1.23 MPa", "1.06 MPa"),
                    *("3.15 MPa", "2.16 MPa", "1.41 MPa", "1.11 MPa", "1.03 MPa"),
                ],
            ),
        }
    },
    answers={
        "master_curve": answer(
            "winkler.problems.master_curves.master_curve:MasterCurve",
            question="Which master curve do sweeps at several temperatures give?",
            page="experiments/master-curves.md#sweeps-at-several-temperatures",
            en="time temperature superposition wlf shift factor master curve frequency sweep dma temperature williams landel ferry arrhenius glass transition grosch horizontal shift reduced frequency glass transition modulus at reference temperature",
            de="masterkurve zeit-temperatur-verschiebung wlf frequenz dma verschiebungsfaktor glasübergang",
            fr="courbe maîtresse équivalence temps-température wlf facteur de décalage dma transition vitreuse",
            event="of Williams, Landel and Ferry",
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
