"""How values show themselves: a call if small, else a block of a few lines, and a table in notebooks."""

from __future__ import annotations

import math
from html.parser import HTMLParser
from xml.etree import ElementTree

import numpy as np
import pytest

import winkler as wk
from winkler.values.value import value

STEEL = wk.Elastic(young=210e9, poisson=0.3)
BED = wk.Foundation(wk.Paraboloid(0.01), wk.HalfSpace.between(STEEL, STEEL))
MODULUS = 210e9 / (1 - 0.3**2) / 2


def hertz(force: float) -> float:
    """Return the depth of a paraboloid of the radius 0.01 m on steel."""
    return (0.75 * force / MODULUS / 0.1) ** (2 / 3)


@value
class Labelled:
    """Numbers with a text of the reader's."""

    problem: object
    name: str
    depth: object


@pytest.fixture(scope="module")
def many():
    return wk.Indentation(BED, wk.Force(np.linspace(0.1, 100.0, 1000))).solve()


@pytest.mark.parametrize(
    "small",
    [
        wk.Sphere(0.01),
        wk.Elastic(1e9, 0.3),
        BED,
        wk.Indentation(wk.Foundation(wk.Sphere(0.01), wk.HalfSpace(STEEL)), wk.Force(100.0)),
        wk.Paraboloid(1.0) + wk.Cone(1.0),
        wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-6)], on=wk.Rigid()),
        wk.AreaFunction([24.5, 1e-7]),
        wk.Depth([1.0, 2.0]),
    ],
)
def test_a_small_value_is_the_call_that_makes_it(small):
    assert (
        eval(repr(small), {"inf": math.inf, "array": np.array}, {name: getattr(wk, name) for name in wk.__all__})
        == small
    )


def test_an_answer_of_a_thousand_loads_takes_a_few_lines(many):
    assert repr(many).splitlines() == [
        "IndentationSolution",
        "  problem  Indentation(bed=Foundation(...), load=Force(force=(1000,) 0.1 ... 100 N))",
        f"  depth    (1000,) {hertz(0.1):.5g} ... {hertz(100.0):.5g} m",
        "  force    (1000,) 0.1 ... 100 N",
        f"  radius   (1000,) {np.sqrt(0.01 * hertz(0.1)):.5g} ... {np.sqrt(0.01 * hertz(100.0)):.5g} m",
    ]


def test_nothing_is_longer_than_ten_lines():
    path = wk.Path.oscillation(force=100.0, amplitude=0.5e-6, cycles=20)
    march = wk.Tangential(BED, wk.Coulomb(0.3), path).solve()
    position = np.linspace(-1e-6, 1e-6, 200)
    force = wk.Indentation(BED, wk.Depth(position)).solve().force
    found = wk.fit(
        wk.ForceCurve(position, force + 1e-6 * np.sin(1e3 * np.arange(200.0))),
        wk.Indentation(BED, wk.Depth(0.0)),
        free=["bed.medium.first.young"],
    )
    shown = [
        march,
        march.states[3],
        march.problem,
        path,
        found,
        found.curve,
        wk.restore(march.states[3], [0.0]),
    ]
    for one in (*shown, wk.Measured(np.linspace(0.0, 1.0, 99), np.linspace(0.0, 1.0, 99))):
        lines = repr(one).splitlines()
        assert len(lines) <= 10, one
        assert len(repr(one)) <= 1000, one
    assert repr(march).splitlines()[1].startswith("  problem ")
    assert repr(march).splitlines()[-1] == "  and stored_energy, dissipation, stick_radius, states"
    assert repr(found).splitlines()[1].startswith("  bed.medium.first.young  2.1e+11 +- ")
    assert "<td" in found._repr_html_()
    assert "210 GPa ± " in found._repr_html_()


def test_arrays_are_shape_and_range():
    odd = Labelled(None, "x", np.array([[math.nan, 2e-6], [math.inf, -1e-6]]))
    assert repr(odd).splitlines()[-1] == "  depth    (2, 2) -1e-06 ... 2e-06 m"
    assert repr(Labelled(None, "x", np.array([]))).splitlines()[-1] == "  depth    [] m"
    assert repr(Labelled(None, "x", np.full(9, math.nan))).splitlines()[-1] == "  depth    (9,) no finite numbers"
    assert repr(Labelled(None, "x", np.array([-0.0, 1.0]))).splitlines()[-1] == "  depth    [0 1] m"
    assert repr(Labelled(None, "x", -0.0)).splitlines()[-1] == "  depth    0 m"
    assert repr(Labelled(None, "x", np.arange(9) > 2)).splitlines()[-1] == "  depth    (9,) 6 true"
    assert repr(Labelled(None, "x", (wk.Sphere(1.0),) * 9)).splitlines()[-1] == "  depth    9 x Sphere"
    assert len(repr(Labelled(None, "x" * 10_000, 1.0))) < 300


class Balance(HTMLParser):
    """What a browser reads: texts, and whether each tag is closed."""

    def __init__(self):
        super().__init__()
        self.open, self.texts = [], []

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def test_a_notebook_gets_a_table_with_handy_units_and_the_notes(many):
    one = many.at(-1)
    page = Balance()
    page.feed(one._repr_html_())
    assert page.open == []
    assert page.texts[:1] == ["IndentationSolution"]
    assert page.texts[page.texts.index("depth") + 1] == f"{1e6 * hertz(100.0):.4g} µm"
    assert page.texts[page.texts.index("radius") + 1] == f"{1e6 * np.sqrt(0.01 * hertz(100.0)):.4g} µm"
    assert page.texts[-len(one.validity) :] == [f"{note.standing.value}: {note.statement}" for note in one.validity]
    assert f"(1000,) {1e6 * hertz(0.1):.5g} ... {1e6 * hertz(100.0):.5g} µm" in many._repr_html_()
    table = ElementTree.fromstring(f"<div>{BED._repr_html_()}</div>")
    assert [cell.text for cell in table.iter("th")] == ["profile", "medium"]


def test_a_table_escapes_what_the_reader_wrote():
    text = Labelled(None, "<script>alert(1)</script>", 1.0)._repr_html_()
    assert "<script" not in text
    assert "&lt;script&gt;" in text


def test_a_note_that_cannot_be_made_is_stated():
    curve = wk.ForceCurve(np.linspace(0.0, 1.0, 9), np.linspace(0.0, 1.0, 9), name="</table>")
    assert "</table>" not in curve._repr_html_().removesuffix("</table>")
