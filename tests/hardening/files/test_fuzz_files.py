"""Whatever lies in a measured file: a value, or one sentence of a `WinklerError`; never another error, never a hang."""

from __future__ import annotations

import zipfile

import numpy as np
import pytest
from fuzz_readers import BED, READERS, TABLES
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import winkler as wk
from winkler.io.wear_states import write_wear
from winkler.values.errors import WinklerError

QUICK = settings(max_examples=25, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))

CELLS = st.one_of(
    st.floats().map(repr),
    st.sampled_from(
        ["", "nan", "-inf", "1e999", "1,5", "0x10", "--", "1_000", "ß", "9" * 400, "# c", "\t", "radius", "[m]"]
    ),
    st.text(max_size=6),
)


@st.composite
def spoilt(draw, text: str) -> bytes:
    """Return a table with cells, lines, separators or bytes changed."""
    lines = text.split("\n")
    for _ in range(draw(st.integers(1, 4))):
        place = draw(st.integers(0, len(lines) - 1))
        what = draw(st.sampled_from(["cell", "cell", "cell", "line", "take", "twice", "separator", "swap"]))
        cells = lines[place].split(",")
        if what == "cell":
            cells[draw(st.integers(0, len(cells) - 1))] = draw(CELLS)
            lines[place] = ",".join(cells)
        elif what == "line":
            lines.insert(place, draw(st.text(max_size=30)))
        elif what == "take" and len(lines) > 1:
            del lines[place]
        elif what == "twice":
            lines.insert(place, lines[place])
        elif what == "separator":
            lines[place] = draw(st.sampled_from([";", "\t", " ", ",,", "|"])).join(cells)
        else:
            lines[place] = ",".join(reversed(cells))
    content = draw(st.sampled_from(["\n", "\r\n", "\r"])).join(lines).encode("utf-8", "surrogatepass")
    if draw(st.integers(0, 4)) == 0:
        place = draw(st.integers(0, len(content)))
        content = content[:place] + draw(st.binary(max_size=4)) + content[place:]
    return content


def read_or_refused(read, path, content: bytes) -> None:
    path.write_bytes(content)
    try:
        read(path)
    except WinklerError as error:
        sentence = str(error)
        assert sentence.rstrip().endswith((".", ")")), sentence
        assert "Traceback" not in sentence


@pytest.mark.parametrize("name", TABLES)
def test_the_table_itself_is_read(name, tmp_path):
    read, text = READERS[name]
    (tmp_path / "table.csv").write_text(text)
    read(tmp_path / "table.csv")


@pytest.mark.few(3, slow=3)
@pytest.mark.parametrize("name", TABLES)
@QUICK
@given(data=st.data())
def test_a_spoilt_table(name, data, tmp_path_factory):
    read, text = READERS[name]
    read_or_refused(read, tmp_path_factory.getbasetemp() / "table.csv", data.draw(spoilt(text)))


SUFFIXES = [".csv", ".txt", ".npz", ".jpk-force", ".h5", ""]


@pytest.mark.few(8, slow=8)
@pytest.mark.parametrize("name", READERS)
@settings(QUICK, max_examples=25)
@given(
    content=st.binary(max_size=300),
    suffix=st.sampled_from(SUFFIXES),
    start=st.sampled_from([b"", b"PK\x03\x04", b"\x93NUMPY"]),
)
def test_any_bytes(name, content, suffix, start, tmp_path_factory):
    read_or_refused(READERS[name][0], tmp_path_factory.getbasetemp() / f"any{suffix}", start + content)


@pytest.mark.parametrize("name", ["contacts", "wear"])
def test_an_archive_that_was_cut_or_holds_something_else(name, tmp_path):
    read = READERS[name][0]
    path = tmp_path / "states.npz"
    np.savez(path, anything=np.arange(3.0), words=np.array(["a"]))
    whole = path.read_bytes()
    for length in (0, 1, 10, len(whole) // 2, len(whole) - 1):
        read_or_refused(read, path, whole[:length])
    read_or_refused(read, path, whole)
    np.savez(path, objects=np.array([{"a": 1}], dtype=object))  # pickles inside are never loaded
    read_or_refused(read, path, path.read_bytes())
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(
            "version.npy",
            b"\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999,), }\n",
        )
    read_or_refused(read, path, path.read_bytes())


def test_a_folder_a_missing_file_and_no_path(tmp_path):
    for read, _ in READERS.values():
        for given_ in (tmp_path, tmp_path / "none.csv", tmp_path / "no" / "none.csv", "\x00", 3.0, None, b"a.csv", ""):
            with pytest.raises(WinklerError):
                read(given_)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Files that winkler itself wrote: contacts between their steps, and states of wear."""
    folder = tmp_path_factory.mktemp("whole")
    contacts = wk.Contacts.apart(
        wk.HalfSpace(wk.Elastic(70e9, 0.22)), curvature_radius=np.full(3, 1e-3), coefficient=0.3, reach=1e-6, count=4
    )
    wk.write_contacts(contacts.moved(np.full(3, 5e-7), motion=np.full((3, 2), 1e-7)), folder / "contacts.npz")
    wear = wk.SlidingWear(BED, wk.Archard(1e-13), wk.Force(10.0), np.array([0.0, 1.0, 10.0]), count=20)
    write_wear(list(wear.steps()), folder / "wear.npz")
    return folder


WRONG = {
    "text": np.array(["a", "b", "c"]),
    "complex": np.array([1j, 2.0]),
    "nothing": np.zeros(0),
    "one number": np.array(1.0),
    "nan": np.full(3, np.nan),
    "infinite": np.full(3, np.inf),
    "negative": np.full(3, -1.0),
    "too many axes": np.zeros((1, 2, 3, 4)),
    "huge numbers": np.full(3, 1e308),
    "dates": np.array(["2024-01-01"], dtype="datetime64[D]"),
}


@pytest.mark.few(8, slow=2)
@pytest.mark.parametrize("wrong", WRONG)
@pytest.mark.parametrize("name", ["contacts", "wear"])
def test_an_archive_with_one_wrong_array(name, wrong, whole, tmp_path):
    with np.load(whole / f"{name}.npz") as stored:
        content = dict(stored)
    for word in content:
        np.savez(tmp_path / "spoilt.npz", **{**content, word: WRONG[wrong]})
        read_or_refused(READERS[name][0], tmp_path / "spoilt.npz", (tmp_path / "spoilt.npz").read_bytes())
