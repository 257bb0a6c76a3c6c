"""Files that other libraries read: what leads to other files is refused, and what they may allocate has a limit."""

from __future__ import annotations

import sys
import threading

import numpy as np
import pytest

import winkler as wk
from winkler.io.memory import limited_memory
from winkler.values.errors import InvalidInput
from winkler.values.limits import READING_BYTES

linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has the limit")
COUNT = 50


def outside(folder, manner):
    """Write a curve as afmformats does, whose heights lie in another file."""
    h5py = pytest.importorskip("h5py")
    heights = np.linspace(0.0, -1e-6, COUNT)
    (folder / "secret.bin").write_bytes(heights.tobytes())
    with h5py.File(folder / "secret.h5", "w") as made:
        made["heights"] = heights
    with h5py.File(folder / "curve.h5", "w") as made:
        made.attrs.update({"software": "afmformats", "software version": "0.18.7"})
        curve = made.create_group("0")
        curve.attrs.update({"imaging mode": "force-distance", "spring constant": 1.0, "sensitivity": 1e-8})
        curve["force"], curve["segment"] = np.linspace(0.0, 1e-9, COUNT), np.zeros(COUNT, "u1")
        name = "height (measured)"
        if manner == "raw":
            curve.create_dataset(name, (COUNT,), "f8", external=[(str(folder / "secret.bin"), 0, 8 * COUNT)])
        elif manner == "virtual":
            layout = h5py.VirtualLayout((COUNT,), "f8")
            layout[:] = h5py.VirtualSource(str(folder / "secret.h5"), "heights", (COUNT,))
            curve.create_virtual_dataset(name, layout)
        elif manner == "link":
            curve[name] = h5py.ExternalLink(str(folder / "secret.h5"), "heights")
        else:
            curve[name] = heights
    return folder / "curve.h5"


@pytest.mark.parametrize("manner", ["raw", "virtual", "link", "inside"])
def test_data_in_another_file_is_not_read(manner, tmp_path):
    pytest.importorskip("afmformats")
    path = outside(tmp_path, manner)
    if manner == "inside":
        assert len(wk.read_curve(path).force) == COUNT
        return
    with pytest.raises(InvalidInput, match=r"'0/height \(measured\)' lies in another file; save it"):
        wk.read_curve(path)
    pytest.importorskip("SurfaceTopography")
    path.rename(tmp_path / "map.datx")
    with pytest.raises(InvalidInput, match=r"'0/height \(measured\)' lies in another file; save it"):
        wk.read_topography(tmp_path / "map.datx")


@linux
def test_a_library_that_unpacks_without_end_is_stopped(tmp_path, monkeypatch):
    module = pytest.importorskip("SurfaceTopography.IO")
    (tmp_path / "map.sur").write_bytes(b"DIGITAL SURF")
    monkeypatch.setattr(module, "open_topography", lambda path: np.empty(10**8))
    monkeypatch.setattr("winkler.io.memory.READING_BYTES", 4 * 10**8)
    with pytest.raises(
        InvalidInput, match=r"map\.sur: to read it takes more memory than .* the 400 MB that a file may"
    ):
        wk.read_topography(tmp_path / "map.sur")
    assert np.empty(10**8).nbytes == 8 * 10**8  # it is over: nothing is limited any more


def test_what_may_be_allocated_is_what_the_manual_says(root):
    page = (root / "docs" / "exchange.md").read_text(encoding="utf-8")
    assert f"allocate to read it (Linux) | {READING_BYTES // 10**6} MB |" in page


@linux
def test_the_limit_is_shared_by_threads_and_restored():
    import resource

    def now():
        return resource.getrlimit(resource.RLIMIT_AS)

    before = now()
    go, come = threading.Event(), threading.Event()

    def other():
        with limited_memory("other"):
            come.set()
            go.wait(20.0)

    thread = threading.Thread(target=other)
    with limited_memory("one"), limited_memory("one"):
        during = now()
        thread.start()
        come.wait(20.0)
    assert before[1] == during[1]
    assert now() == during != before
    go.set()
    thread.join()
    assert now() == before
    with pytest.raises(ValueError, match="boom"), limited_memory("one"):
        raise ValueError("boom")
    assert now() == before


@linux
def test_a_lower_limit_of_the_system_stays(monkeypatch):
    import resource

    requested = []
    monkeypatch.setattr(resource, "getrlimit", lambda which: (10**6, 10**9))
    monkeypatch.setattr(resource, "setrlimit", lambda *words: requested.append(words))
    with limited_memory("one"):
        pass
    assert requested == []
