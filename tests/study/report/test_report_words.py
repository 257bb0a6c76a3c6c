"""Formulas as MathML, inputs in words and with units, figures of families."""

from __future__ import annotations

import importlib
import pkgutil
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest
from study_samples import SAMPLES, pressed

import winkler as wk
from winkler.study import chapters
from winkler.study.batch.run import run
from winkler.study.chapters.answer import Equation
from winkler.study.language.reading import read_study
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.study.report.describe import content_label, in_words, inputs, values_text
from winkler.study.report.figure import svg_element
from winkler.study.report.figures import answers_over
from winkler.study.report.markup import safe, table, with_fixed_units
from winkler.study.report.mathml import formula, inline, symbol
from winkler.values.errors import InvalidInput

STUDIES = Path(__file__).resolve().parents[3] / "examples" / "studies"

FORMULAS = [
    item
    for module in pkgutil.iter_modules(chapters.__path__)
    for item in vars(importlib.import_module(f"{chapters.__name__}.{module.name}")).values()
    if isinstance(item, Equation)
]


def test_every_formula_of_the_report_is_well_formed():
    counts = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "munder": 2, "munderover": 3}
    for item in dict.fromkeys(FORMULAS):
        root = ElementTree.fromstring(formula(item.latex))
        assert root.tag == "math", item.says
        for element in root.iter():
            if element.tag in counts:
                assert len(element) == counts[element.tag], (item.says, ElementTree.tostring(element))


def test_every_symbol_of_the_glossary_is_understood(entries):
    symbols = [entry.symbol for entry in entries.values()]
    assert [text for text in symbols if symbol(text) != inline(text)] == []


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"E^*", "<msup><mi>E</mi><mo>∗</mo></msup>"),
        (r"\sigma_{vM}", "<msub><mi>σ</mi><mtext>vM</mtext></msub>"),
        (r"f''", "<msup><mi>f</mi><mrow><mo>′</mo><mo>′</mo></mrow></msup>"),
        (r"x_i^2", "<msubsup><mi>x</mi><mi>i</mi><mn>2</mn></msubsup>"),
        (r"\frac{1}{2.5}", "<mfrac><mn>1</mn><mn>2.5</mn></mfrac>"),
        (r"\sqrt{x-1}", "<msqrt><mrow><mi>x</mi><mo>−</mo><mn>1</mn></mrow></msqrt>"),
        (r"a < b", "<mi>a</mi><mo>&lt;</mo><mi>b</mi>"),
        (r"\left[a\right]", "<mrow><mo>[</mo><mi>a</mi><mo>]</mo></mrow>"),
        (r"\mathrm{d}x", '<mi mathvariant="normal">d</mi><mi>x</mi>'),
        (r"\sum_i^n", "<munderover><mo>∑</mo><mi>i</mi><mi>n</mi></munderover>"),
        (r"\Delta x", "<mi>Δ</mi><mi>x</mi>"),
    ],
)
def test_latex_becomes_mathml(latex, expected):
    assert inline(latex) == f"<math>{expected}</math>"


@pytest.mark.parametrize("latex", [r"\foo", r"\frac{1}", "{a", "a}", "x__y", r"\left(a", "a_", r"\mathrm x", "a & b"])
def test_what_is_not_understood_is_refused(latex):
    with pytest.raises(InvalidInput, match="formula: .* is not understood"):
        inline(latex)


def test_a_name_that_is_no_formula_is_shown_as_it_is():
    assert symbol("k__1<") == "<i>k__1&lt;</i>"
    assert symbol("") == ""


def test_inputs_are_listed_part_by_part():
    found = inputs(SAMPLES["one load"])
    assert [(row.group, row.name, row.text) for row in found] == [
        ("profile: paraboloid", "curvature radius", "10 mm"),
        ("body below (z > 0): elastic", "Young's modulus", "210 GPa"),
        ("body below (z > 0): elastic", "Poisson's ratio", "0.3"),
        ("body below (z > 0): elastic", "strength", "700 MPa"),
        ("body above (z < 0): elastic", "Young's modulus", "210 GPa"),
        ("body above (z < 0): elastic", "Poisson's ratio", "0.3"),
        ("load: force", "force", "20 N"),
    ]


def test_inputs_of_every_kind_of_content():
    def message(problem, **sweep):
        return {row.name: row.text for row in inputs(Study("x", problem, **sweep))}

    assert message(pressed(wk.AreaFunction([24.5, 2e-6, 3e-9])))["coefficients"] == "24.5, 2 µm, 3·10⁻⁹ m^1.5"
    found = message(pressed(wk.Formula("r**2/(2*R)", R=1e-2)))
    assert found["expression"] == "r**2/(2*R)"
    assert found["constants"] == "R = 0.01"
    assert message(pressed(wk.PowerLaw(1e3, 3.0)))["coefficient"] == "1000 m⁻²"
    assert message(pressed(load=wk.Force(np.geomspace(1.0, 1e3, 20))))["force"] == "20 values from 1 N to 1 kN"
    rigid = inputs(Study("x", pressed(medium=wk.HalfSpace(wk.Elastic(1e9, 0.3)))))
    assert ("body above (z < 0): rigid", "nothing to give") in [(row.group, row.text) for row in rigid]
    both = inputs(Study("x", pressed(wk.Paraboloid(1e-2) + wk.Wavy(1e-8, 1e-3))))
    assert [row.group for row in both][:3] == ["parts 1: paraboloid", "parts 2: wavy", "parts 2: wavy"]
    swept = message(pressed(), sweep=(Axis("problem.bed.profile", (wk.Cone(1.5), wk.FlatPunch(1e-3))),))
    assert swept["profile"] == "varied: cone (half angle = 85.9437°), flat punch (radius = 1 mm)"


def test_values_are_stated_with_one_unit_where_it_suits():
    assert values_text(np.linspace(1e-6, 5e-6, 9), "m") == "9 values from 1 to 5 µm"
    assert values_text(np.geomspace(1e-9, 1e-3, 9), "m") == "9 values from 1 nm to 1 mm"
    assert values_text(np.array([1.0, 2.0]), "N") == "1 N, 2 N"
    assert values_text(0.3, "") == "0.3"


def test_a_study_in_words_for_every_sample():
    for study in SAMPLES.values():
        words = in_words(study)
        assert words.endswith(".")
        assert "  " not in words
        assert "{" not in words
    question = "The load at which each body begins to yield, with or without sliding, and which body is the first."
    assert question in in_words(SAMPLES["onset of yield"])
    assert "The equivalent plane profile g(x) is given directly: a power law" in in_words(SAMPLES["plane profile"])
    assert "The shape is a sum (paraboloid (curvature radius = 10 mm) + wavy" in in_words(SAMPLES["sum"])


def test_labels_of_what_is_no_number():
    assert content_label(wk.Sphere(1e-2)) == "sphere (curvature radius = 10 mm)"
    assert content_label(2.5) == "2.5"


def test_markup_escapes_and_keeps_numbers_with_their_units():
    assert safe("<&>") == "&lt;&amp;&gt;"
    assert with_fixed_units("a force of 20 N, 3 values") == "a force of 20\u00a0N, 3 values"
    assert table([], ["<tr></tr>"]).count("<thead>") == 0


ANSWERS_OVER_FORCE = ("depth", "radius", "stiffness", "mean_pressure", "peak_pressure", "energy")


def curves(study):
    return {one.name: one for one in answers_over(run(study))}


@pytest.mark.slow
def test_answers_over_two_keys_are_one_curve_each():
    shown = curves(SAMPLES["two keys"])
    assert list(shown) == [f"answer_{name}" for name in ANSWERS_OVER_FORCE]
    axes = shown["answer_depth"].picture.axes[0]
    assert [line.get_label() for line in axes.lines] == ["curvature radius = 5 mm", "curvature radius = 10 mm"]
    modulus = 210e9 / (2 * (1 - 0.3**2))
    force, depth = axes.lines[1].get_data()
    np.testing.assert_allclose(depth, 1e6 * np.cbrt(9 * force**2 / (16 * modulus**2 * 10e-3)), rtol=1e-12)
    assert axes.get_ylabel() == "depth $d$ [µm]"


@pytest.mark.slow
def test_the_longest_axis_is_the_abscissa():
    axes = curves(
        Study(
            "x",
            pressed(),
            sweep=(Axis("problem.bed.profile.curvature_radius", (1e-3, 1e-2)), SAMPLES["two keys"].sweep[0]),
        )
    )
    assert axes["answer_depth"].title == "Depth over force"


@pytest.mark.slow
def test_many_loads_are_curves_over_the_depth():
    shown = curves(SAMPLES["many loads, varied"])
    assert shown["answer_force"].title == "Force over depth"
    assert len(shown["answer_force"].picture.axes[0].lines) == 2


def test_shapes_become_bars():
    axes = curves(SAMPLES["shapes"])["answer_depth"].picture.axes[0]
    names = [label.get_text() for label in axes.get_yticklabels()]
    assert names == [
        "paraboloid (curvature radius = 10 mm)",
        "cone (half angle = 85.9437°)",
        "flat punch (radius = 1 mm)",
    ]


@pytest.mark.slow
def test_too_many_curves_are_cut_and_say_so():
    study = Study(
        "x",
        pressed(),
        sweep=(
            Axis("problem.load.force", tuple(np.linspace(1.0, 9.0, 5))),
            Axis("problem.bed.profile.curvature_radius", tuple(np.linspace(1e-3, 9e-3, 5))),
            Axis("problem.bed.medium.first.young", tuple(np.linspace(1e9, 9e9, 5))),
        ),
    )
    shown = curves(study)["answer_depth"]
    assert "The first 24 of 25 curves are shown." in shown.sentence
    assert len(shown.picture.axes[0].lines) == 24


def test_one_point_has_no_curves():
    assert curves(SAMPLES["one load"]) == {}


def test_a_figure_for_a_page_is_one_element():
    shown = curves(SAMPLES["shapes"])["answer_depth"]
    text = svg_element(shown, "Depth")
    root = ElementTree.fromstring(text)
    assert root.attrib["aria-label"] == "Depth"
    assert "width" not in root.attrib
    ids = [element.attrib["id"] for element in root.iter() if "id" in element.attrib]
    assert ids
    assert all(name.startswith("answer-depth-") for name in ids)


def test_what_was_not_given_is_not_mentioned():
    """A map without tractions along y, as a name in a file: no empty name or bracket is left in the sentence."""
    sentence = in_words(read_study(STUDIES / "rough" / "pressure_map.toml"))
    assert "x traction = 48 values" in sentence
    assert "y traction" not in sentence
    assert ", )" not in in_words(read_study(STUDIES / "rough" / "rough_surface.toml"))
