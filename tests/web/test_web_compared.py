"""Answer A against answer B: what differs between the studies, and by how much the numbers do."""

from __future__ import annotations

import html
import re

import pytest
import tomli_w

from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.study.report.tables import answer_section
from winkler.web.form import form
from winkler.web.form.front_examples import first_table
from winkler.web.pictures.chart import chart
from winkler.web.pictures.comparison import comparison, numbers_of
from winkler.web.pictures.replies import NamedNumber


def solved(**changes):
    table = first_table()
    for path, content in changes.items():
        form.put(table, path.replace("__", "."), content)
    text = tomli_w.dumps(table)
    return text, numbers_of(run(parse_study(text)))


def rows_of(page):
    """Return name -> cells of a table."""
    body = page.partition("</thead>")[2]
    rows = [re.findall(r"<td.*?>(.*?)</td>", row) for row in re.findall(r"<tr>(.*?)</tr>", body)]
    return {row[0]: [html.unescape(one) for one in row[2:]] for row in rows if row}


def test_eight_times_the_force_by_hertz():
    """Depth grows with the power 2/3 of the force, radius and peak pressure with 1/3, energy with 5/3."""
    paraboloid = {"kind": "paraboloid", "curvature_radius": "10 mm"}
    a, b = (solved(problem__bed__profile=paraboloid, problem__load__force=force) for force in ("1 N", "8 N"))
    page = comparison(a, b)
    assert "From A to B: load › force 1 N → 8 N." in page
    rows = rows_of(page)
    assert rows["force"] == ["1 N", "8 N", "7 N", "8"]
    assert {name: rows[name][-1] for name in ("depth", "contact radius", "peak pressure", "energy")} == {
        "depth": "4", "contact radius": "2", "peak pressure": "2", "energy": "32",
    }  # fmt: skip
    assert comparison(a, a).startswith("<p>Both studies are the same.</p>")


def test_other_bodies_and_nothing_in_common():
    a = (solved()[0], (NamedNumber("depth", "d", "m", 0.0), NamedNumber("<b>", "", "", 1.0)))
    b = (solved(problem__bed__medium__second={"kind": "rigid"})[0], (NamedNumber("depth", "d", "m", 5e-23),))
    page = comparison(a, b)
    assert "medium › second elastic → rigid; medium › second › Young&#x27;s modulus 210 GPa → not given" in page
    assert rows_of(page) == {"depth": ["0 m", "5·10⁻²³ m", "5·10⁻²³ m", "—"]}
    assert "no number in common" in comparison(a, (b[0], ()))


def test_small_numbers_of_a_table_stand_in_powers_of_ten():
    table = first_table()
    form.put(table, "problem.load.force", ["1 pN", "1 N", "10 N", "100 N"])
    page = answer_section(run(parse_study(tomli_w.dumps(table))))
    assert not re.search(r"\de[-+]?\d", re.sub(r"<[^>]*>", " ", page))
    assert "1·10⁻¹²" in page


@pytest.mark.parametrize("axis", ["x", "y"])
def test_a_picture_says_its_units_beside_the_mouse(axis):
    from winkler.plot import method

    contact = run(parse_study(tomli_w.dumps(first_table()))).points[0].solution
    drawn = chart(method.force(contact))
    units = {"x": "µm", "y": "N"}
    assert f"%{{{axis}:.4~g}} {units[axis]}" in drawn["data"][0]["hovertemplate"]
    assert drawn["layout"]["meta"][axis] == {"x": 1e-6, "y": 1.0}[axis]
