"""The loads at which bodies begin to yield, in the files and the page of a study: each under its name."""

import csv
import io

import h5netcdf

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.study import Study
from winkler.study.report.archive import archive_files
from winkler.study.report.report import page


def onsets(second_strength):
    pair = wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=1e9), wk.Elastic(210e9, 0.3, strength=second_strength))
    return run(Study("pair", wk.YieldOnset(wk.Foundation(wk.Paraboloid(1e-2), pair))))


def test_rows_are_named_in_every_file():
    outcome = onsets(2e9)
    files = archive_files(outcome)
    rows = list(csv.DictReader(io.StringIO(files["onsets.csv"].decode("utf-8"))))
    assert [row["name"] for row in rows] == ["first body", "second body"]
    assert float(rows[1]["force [N]"]) / float(rows[0]["force [N]"]) > 7.99
    with h5netcdf.File(io.BytesIO(files["results.nc"]), "r") as data:
        assert [one.decode("utf-8") for one in data["onsets_name"][...]] == ["first body", "second body"]
        assert "units" not in data["onsets_name"].attrs
    html = page(outcome, ())
    table = html[html.index("<h3>Where each body begins to yield</h3>") :]
    table = table[: table.index("</table>")]
    assert table.count("<tr") == 3
    assert "<td>first body</td>" in table
    assert "<td>second body</td>" in table
    assert "why" not in table  # both yield


def test_what_does_not_yield_says_why():
    """A ball that would need a contact wider than itself; `why` then is a column."""
    ball = wk.Sphere(1e-2)
    pair = wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=1e9), wk.Elastic(210e9, 0.3, strength=9e11))
    outcome = run(Study("pair", wk.YieldOnset(wk.Foundation(ball, pair))))
    row = list(csv.DictReader(io.StringIO(archive_files(outcome)["onsets.csv"].decode("utf-8"))))[1]
    assert row["force [N]"] == "inf"
    assert "does not yield" in row["why"] or "below the strength" in row["why"]
    assert row["why"][:40] in page(outcome, ())
