"""Files that functions and commands of the package write: whole, or as they were before, alone and together."""

from __future__ import annotations

import ast
import errno
import io
import os
import re
import signal
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

import winkler as wk
from winkler.exporting.export import ExportedLaw
from winkler.exporting.many.contact_array import ContactArray
from winkler.io import whole_file
from winkler.io.array_file import write_arrays
from winkler.io.wear_states import write_wear
from winkler.io.whole_file import write_whole
from winkler.study.batch.outcome import Provenance
from winkler.study.report import writing

BED = wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace(wk.Elastic(1e9, 0.3)))
CONTACT = wk.Indentation(BED, wk.Depth([1e-6, 2e-6])).solve()
LAW = wk.ContactLaw(BED, 1e-6, 1e-2).solve()
BEADS = wk.Contacts.apart(BED.medium, curvature_radius=1e-3, coefficient=0.3, reach=2e-6, count=8)
INDENTER = wk.CalibratedIndenter(wk.CalibratedArea([24.5, 1e-6]))
FIELDS = wk.restore(wk.Indentation(BED, wk.Depth(1e-6)).solve(), np.linspace(0.0, 1e-4, 3), np.linspace(0.0, 1e-4, 3))
SET = ExportedLaw("ball", "c", "a ball", (("ball.h", "#if 1\n"), ("ball.c", "int main;\n"), ("ball.bin", b"\0")), 0)
WORN = wk.SlidingWear(BED, wk.Archard(1e-13), wk.Force(1.0), np.array([0.0, 1.0]), count=20)
MADE = Provenance("0", "", "1970-01-01T00:00:00+00:00", 1.0, ())
WAVES = np.add.outer(np.sin(np.arange(8) * np.pi / 4), np.sin(np.arange(8) * np.pi / 4))
ROUGH = wk.Topography(1e-7 * WAVES, [1e-4, 1e-4], periodic=True)
JOINT = wk.SurfaceContact(ROUGH, BED.medium, wk.Force([1e-3, 1e-2])).solve()

WRITERS = {
    "write_contacts": lambda path: wk.write_contacts(BEADS, path),
    "write_export": lambda path: wk.write_export(SET, path.parent),
    "write_indenter": lambda path: wk.write_indenter(INDENTER, path),
    "write_law": lambda path: wk.write_law(LAW, path.with_suffix(".csv")),
    "write_surface_interaction": lambda path: wk.write_surface_interaction(
        JOINT, path.with_suffix(".inp"), program="abaqus"
    ),
    "write_trace": lambda path: wk.write_trace(CONTACT, path.with_suffix(".csv")),
    "write_vtk": lambda path: wk.write_vtk(FIELDS, path.with_suffix(".vtk")),
    "ContactArray.save": lambda path: ContactArray(BEADS, 3).save(path),
    "write_arrays": lambda path: write_arrays(path, {"depth": np.zeros(3)}),
    "write_wear": lambda path: write_wear(list(WORN.steps()), path),
}
"""Each writes beside the path that it is given."""


def full(*_):
    raise OSError(errno.ENOSPC, "No space left on device")


def tree(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


class FullDisk:
    """Stands in for a disk that takes so many operations: making, writing and forcing onto the disk are counted."""

    def __init__(self, patch, most):
        self.count, self.most, disk = 0, most, self

        class Counted(io.FileIO):
            def write(self, content):
                disk.counted()
                return super().write(content)

        def opened(path, flags, *mode, plain=os.open, **more):
            if flags & os.O_CREAT:
                disk.counted()
            return plain(path, flags, *mode, **more)

        def file_of(number, mode, buffering):
            return io.BufferedWriter(Counted(number, mode), buffering) if buffering else Counted(number, mode)

        def forced(number, plain=os.fsync):
            disk.counted()
            plain(number)

        patch.setattr(os, "open", opened)
        patch.setattr(os, "fdopen", file_of)
        patch.setattr(os, "fsync", forced)

    def counted(self):
        self.count += 1
        if self.count > self.most:
            full()


def test_the_walk_knows_every_function_that_writes():
    public = {name for name in dir(wk) if name.startswith("write_")}
    assert public <= set(WRITERS)
    assert "save" in dir(ContactArray)


@pytest.mark.parametrize("name", WRITERS)
def test_a_disk_that_is_full_at_any_operation_leaves_what_was_there(name, tmp_path, monkeypatch):
    write, path = WRITERS[name], tmp_path / "contact.npz"
    write(path)
    for older in tmp_path.iterdir():
        older.write_bytes(b"before")
    before, refusals = tree(tmp_path), []
    for most in range(1000):
        with monkeypatch.context() as patch:
            FullDisk(patch, most)
            try:
                write(path)
                break
            except wk.InvalidInput as error:
                refusals.append(str(error))
        assert tree(tmp_path) == before
    assert all("cannot be written (no space left on device); free some space, or" in one for one in refusals)
    assert len(refusals) == most >= 3 * len(before)  # it was made, written and forced onto the disk
    assert tree(tmp_path).keys() == before.keys()
    assert b"before" not in tree(tmp_path).values()


def test_results_on_a_full_disk_leave_what_was_there(tmp_path, monkeypatch):
    files = {"a.csv": b"1" * 9, "figures/b.svg": b"2" * 9}
    with writing.placed(tmp_path / "ball", overwrite=True) as folder:
        writing.write_files(writing.with_provenance(files, MADE), folder)
    before, refusals = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}, []
    for most in range(100):
        with monkeypatch.context() as patch:
            FullDisk(patch, most)
            try:
                with writing.placed(tmp_path / "ball", overwrite=True) as folder:
                    writing.write_files(writing.with_provenance({"a.csv": b"3"}, MADE), folder)
                break
            except wk.InvalidInput as error:
                refusals.append(str(error))
        assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before
    assert len(refusals) == most == 4
    assert all("output: " in one and "or give another folder with --output" in one for one in refusals)
    assert sorted(path.name for path in (tmp_path / "ball").iterdir()) == ["a.csv", "provenance.json"]


def stopped(*_):
    raise KeyboardInterrupt


@pytest.mark.parametrize("place", ["fsync", "replace"])
def test_what_was_there_stays_if_the_writer_is_stopped(place, tmp_path, monkeypatch):
    path = tmp_path / "trace.csv"
    path.write_bytes(b"before")
    with monkeypatch.context() as patch:
        patch.setattr(whole_file.os, place, stopped)
        with pytest.raises(KeyboardInterrupt):
            wk.write_trace(CONTACT, path)
    assert tree(tmp_path) == {"trace.csv": b"before"}


def test_the_file_that_a_link_leads_to_is_replaced(tmp_path):
    (tmp_path / "real.vtk").write_bytes(b"before")
    (tmp_path / "link.vtk").symlink_to(tmp_path / "real.vtk")
    wk.write_vtk(FIELDS, tmp_path / "link.vtk")
    assert (tmp_path / "link.vtk").is_symlink()
    assert (tmp_path / "real.vtk").read_bytes().startswith(b"# vtk")


@pytest.mark.parametrize("name", ["", "none/ball.h", "a\0b", "x" * 300])
def test_a_place_that_cannot_be_used_is_stated(name, tmp_path):
    with pytest.raises(wk.InvalidInput, match="cannot be written") as caught:
        write_whole({tmp_path / "good.h": b"1", tmp_path / name: b"2"})
    assert "free some space" not in str(caught.value)
    assert str(caught.value).count("\n") == 0
    assert tree(tmp_path) == {}


@pytest.mark.skipif(os.name == "nt", reason="there an interrupt cannot be sent to this process alone")
@pytest.mark.parametrize("handler", [signal.default_int_handler, stopped])
def test_an_interrupt_between_two_names_waits_for_the_others(handler, tmp_path, monkeypatch):
    """Files that belong together, by a program of its own that handles signals itself."""
    replace, usual = os.replace, signal.signal(signal.SIGINT, handler)

    def interrupted(part, target):
        replace(part, target)
        os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(whole_file.os, "replace", interrupted)
    try:
        with pytest.raises(KeyboardInterrupt):
            wk.write_export(SET, tmp_path)
    finally:
        signal.signal(signal.SIGINT, usual)
    assert sorted(tree(tmp_path)) == ["ball.bin", "ball.c", "ball.h"]


KILLED = """
import os, signal, sys
from pathlib import Path
from winkler.io import whole_file
whole_file.os.fsync = lambda number: os.kill(os.getpid(), signal.SIGKILL)
whole_file.write_whole({Path("ball.h"): bytes(100), Path("ball.c"): bytes(100)})
"""


@pytest.mark.skipif(os.name == "nt", reason="processes are killed by signals")
def test_what_killed_writers_left_is_removed_and_what_living_ones_write_is_not(tmp_path):
    (tmp_path / ".other.part").write_bytes(b"of another program")
    subprocess.run([sys.executable, "-c", KILLED], cwd=tmp_path, check=False)
    assert len(tree(tmp_path)) == 3
    with whole_file.written_whole(tmp_path / "living.h") as file:
        file.write(b"half")
        write_whole({tmp_path / "new.h": b"whole"})
        assert len(tree(tmp_path)) == 3
    assert tree(tmp_path) == {".other.part": b"of another program", "living.h": b"half", "new.h": b"whole"}


def test_threads_that_write_one_file_are_all_served(tmp_path):
    """Of six threads with fifteen files each, eighteen writers were refused: their temporary names were one."""
    refused = []

    def written(number):
        for _ in range(15):
            try:
                write_whole({tmp_path / "ball.h": bytes([number]) * 50_000})
            except wk.InvalidInput as error:
                refused.append(str(error))

    threads = [threading.Thread(target=written, args=(number,)) for number in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert refused == []
    content = (tmp_path / "ball.h").read_bytes()
    assert content == content[:1] * 50_000
    assert len(tree(tmp_path)) == 1


WRITING = {
    "calculators/build.py": "a tool of developers",
    "cli/streams.py": "messages into nothing, where stdout is closed",
    "exporting/targets/compilers.py": "sources for a compiler, in a temporary folder",
    "io/curves.py": "one member of an archive at a time, in a temporary folder",
    "io/surfaces/instrument_channels.py": "surfaces packed as SurfaceTopography reads them, deleted afterwards",
    "io/processes/locking.py": "locks, and what the one writer opens",
    "io/software.py": "a digest of the sources, which is made again where it cannot be read",
    "io/whole_file.py": "the one writer",
    "numerics/cache_folders.py": "a private folder",
    "plot/animation.py": "frames of a film, in a temporary folder",
    "study/batch/journal.py": "lines that are only appended, with a checksum each",
    "web/session/upload_folder.py": "uploads, in a private folder",
    "web/session/uploads.py": "that folder",
}
"""Modules that make files, and what they write."""
MAKERS = {"write_text", "write_bytes", "fdopen", "NamedTemporaryFile", "TemporaryDirectory", "mkdtemp", "save", "savez"}


def makes_files(tree: ast.AST) -> bool:
    """Return whether a module opens a file for writing, makes one, or hands its path to a library."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name not in (*MAKERS, "open", "_open"):
            continue
        given = [one.value for one in ast.walk(node) if isinstance(one, ast.Constant)]
        into_memory = any(isinstance(one, ast.Name) and one.id in ("store", "drawn") for one in node.args)
        if name in MAKERS and not into_memory:
            return True
        if name == "open" and any(mode in given for mode in ("w", "wb", "a", "ab", "x", "xb", "r+", "r+b")):
            return True
        if name in ("open", "_open") and "O_CREAT" in ast.unparse(node):
            return True
    return False


def test_nothing_but_the_one_writer_makes_files():
    """A library, or a module, that writes by itself meets a full disk, a kill or a thread in ways of its own."""
    root = Path(wk.__file__).parent
    texts = {path: path.read_text(encoding="utf-8") for path in root.rglob("*.py")}
    named = re.compile("|".join((*MAKERS, "open")))  # without one of these names nothing is made
    found = [path for path, text in texts.items() if named.search(text) and makes_files(ast.parse(text))]
    assert sorted(path.relative_to(root).as_posix() for path in found) == sorted(WRITING)


def test_the_search_for_writers_finds_them():
    for code in ("p.write_text(a)", "p.open('wb')", "np.savez(path, a)", "os.open(p, os.O_RDWR | os.O_CREAT)"):
        assert makes_files(ast.parse(code)), code
    assert not makes_files(ast.parse("p.open('rb')\nnp.savez(store, a)\nopen(p)"))
