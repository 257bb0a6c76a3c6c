"""What is typed, what sliders make of it, and what an upload may be called."""

from __future__ import annotations

import errno
import pathlib

import pytest

from winkler.values.errors import InvalidInput
from winkler.web.form.sliders import STEPS, span_of
from winkler.web.form.typed import field_text, typed
from winkler.web.session.upload_folder import LARGEST, MOST_BYTES, UploadFolder, files_in, plain_name


@pytest.mark.parametrize(
    ("text", "takes", "content"),
    [
        ("10 mm", "quantity [m]", "10 mm"),
        ("10", "quantity [m]", "10"),
        ("0.3", "number", 0.3),
        ("200", "whole number", 200),
        ("2.5", "whole number", 2.5),
        ("infinite", 'number or "infinite"', "infinite"),
        ("true", "true or false", True),
        ("0", "text", "0"),
        ("1 N, 2 N", "quantity [N], list or range", ["1 N", "2 N"]),
        ("1 N", "list of quantity [N]", ["1 N"]),
        ("0.1, 0.2", "list of number", [0.1, 0.2]),
        ("1,000 N", "quantity [N], list or range", "1,000 N"),
        ("1,5 N", "list of quantity [N]", ["1,5 N"]),
        ("1,000", "number, list or range", "1,000"),
        ("1,2,3", "list of number", [1, 2, 3]),
        ('{ R = "10 mm", n = 2 }', "table of named quantities", {"R": "10 mm", "n": 2}),
        ("[[0.1, 0.2], [0.3, 0.4]]", "list of lists of numbers", [[0.1, 0.2], [0.3, 0.4]]),
        ("{ from = ", "quantity [N], list or range", "{ from ="),
    ],
)
def test_typed(text, takes, content):
    found = typed(text, takes)
    assert found == content
    assert type(found) is type(content)


@pytest.mark.parametrize("content", ["10 mm", 0.3, 200, ["1 N", "2 N"], {"from": "0 N", "to": "1 N", "count": 3}])
def test_what_is_shown_can_be_typed(content):
    takes = "number" if isinstance(content, int | float) else "quantity [N], list or range"
    assert typed(field_text(content), takes) == content


def test_a_slider_goes_a_decade_to_either_side():
    span, place = span_of("force", "100 N")
    assert place == 0
    assert span.text(-STEPS) == "10 N"
    assert span.text(STEPS) == "1000 N"
    assert span.text(STEPS / 2) == "316.2 N"
    assert span.place(10.0) == -STEPS
    assert all(span.place(span.number(step)) == step for step in range(-STEPS, STEPS + 1))


def test_a_slider_of_poissons_ratio_stays_within_it():
    span, place = span_of("poisson", "0.3")
    assert span.number(-STEPS) == 0.0
    assert span.number(STEPS) == 0.49
    assert span.number(place) == pytest.approx(0.3, abs=0.49 / STEPS)


@pytest.mark.parametrize("text", ["", "0 N", "many", "nan N", "1 N, 2 N", "1e999 N"])
def test_no_slider_without_a_number(text):
    assert span_of("force", text) is None


@pytest.mark.parametrize(
    ("name", "plain"),
    [
        ("tip.csv", "tip.csv"),
        ("../../etc/passwd", "passwd"),
        ("..\\..\\boot.ini", "boot.ini"),
        ("/etc/shadow", "shadow"),
        ("...", "file"),
        (".hidden", "hidden"),
        ("a\x00b\n.csv", "a_b_.csv"),
        ("ü" * 5 + ".csv", "csv"),
        ("x" * 300 + ".csv", "x" * 96 + ".csv"),
    ],
)
def test_names_of_uploads(name, plain):
    assert plain_name(name) == plain


@pytest.fixture
def folder():
    uploads = UploadFolder()
    yield uploads
    uploads.close()
    assert not uploads.folder.exists()


def test_an_upload_lies_in_its_folder(folder):
    assert folder.keep("../tip.csv", b"1 2") == "tip.csv"
    assert folder.names == ("tip.csv",)
    assert (folder.folder / "tip.csv").read_bytes() == b"1 2"
    folder.check({"problem": {"bed": {"profile": {"kind": "measured", "file": "tip.csv"}}}})


def test_uploads_are_limited(folder):
    with pytest.raises(InvalidInput, match="20 MB are accepted"):
        folder.keep("large.csv", b"0" * (LARGEST + 1))
    with pytest.raises(InvalidInput, match="is empty"):
        folder.keep("none.csv", b"")
    for number in range(50):
        folder.keep(f"{number}.csv", b"1")
    folder.keep("7.csv", b"again")
    with pytest.raises(InvalidInput, match="50 files already"):
        folder.keep("one_more.csv", b"1")


def test_all_uploads_of_a_page_have_a_limit(folder):
    for number in range(MOST_BYTES // LARGEST):
        folder.keep(f"{number}.csv", bytes(LARGEST))
    with pytest.raises(InvalidInput, match=r"^'more\.csv': .* more than 100 MB, .*; reload the page"):
        folder.keep("more.csv", b"1")
    folder.keep("0.csv", b"1")  # in place of the first
    folder.keep("more.csv", b"1")
    assert sum(path.stat().st_size for path in folder.folder.iterdir()) == MOST_BYTES - LARGEST + 2


def test_an_upload_that_cannot_be_written_is_one_sentence(folder, monkeypatch):
    def full(self, content):
        self.touch()
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(pathlib.Path, "write_bytes", full)
    with pytest.raises(InvalidInput, match=r"^'tip\.csv' cannot be stored \(no space left on device\); free space"):
        folder.keep("tip.csv", b"1 2")
    assert folder.names == ()


@pytest.mark.parametrize(
    "name", ["../../etc/passwd", "/etc/passwd", "sub/tip.csv", "..", "tip.csv/../../x", "other.csv"]
)
def test_no_other_file_is_read(folder, name):
    folder.keep("tip.csv", b"1 2")
    table = {"problem": {"path": {"steps": [{"kind": "follow", "path": {"kind": "path", "file": name}}]}}}
    assert files_in(table) == [("problem.path.steps[0].path.file", name)]
    with pytest.raises(InvalidInput, match=r"problem\.path\.steps\[0\]\.path\.file is .*uploaded files only"):
        folder.check(table)
