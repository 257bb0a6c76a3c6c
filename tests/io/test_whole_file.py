"""Files that functions of the package write: whole, or as they were before."""

from __future__ import annotations

import errno

import numpy as np
import pytest

import winkler as wk
from winkler.io import whole_file

CONTACT = wk.Indentation(
    wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace(wk.Elastic(1e9, 0.3))), wk.Depth([1e-6, 2e-6])
).solve()


def stopped(*_):
    raise KeyboardInterrupt


def full(*_):
    raise OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize(("fault", "error"), [(stopped, KeyboardInterrupt), (full, wk.InvalidInput)])
def test_what_was_there_stays_until_the_new_file_is_whole(fault, error, tmp_path, monkeypatch):
    path = tmp_path / "trace.csv"
    path.write_bytes(b"before")
    with monkeypatch.context() as patch:
        patch.setattr(whole_file.os, "fsync", fault)
        with pytest.raises(error):
            wk.write_trace(CONTACT, path)
    assert [(one.name, one.read_bytes()) for one in tmp_path.iterdir()] == [("trace.csv", b"before")]
    wk.write_trace(CONTACT, path)
    assert [one.name for one in tmp_path.iterdir()] == ["trace.csv"]
    assert path.read_bytes() != b"before"


def test_the_file_that_a_link_leads_to_is_replaced(tmp_path):
    (tmp_path / "real.vtk").write_bytes(b"before")
    (tmp_path / "link.vtk").symlink_to(tmp_path / "real.vtk")
    r = np.linspace(0.0, 1e-4, 3)
    fields = wk.restore(wk.Indentation(CONTACT.problem.bed, wk.Depth(1e-6)).solve(), r, r)
    wk.write_vtk(fields, tmp_path / "link.vtk")
    assert (tmp_path / "link.vtk").is_symlink()
    assert (tmp_path / "real.vtk").read_bytes().startswith(b"# vtk")
