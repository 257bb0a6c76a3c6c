"""Creep, relaxation and a loop as microscopes wrote them: read with all segments, and fitted to what is left over."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from relaxing_curves import FIRST, model

import winkler as wk
from winkler.fitting.fit import fit
from winkler.io.curves import read_curve
from winkler.materials.fractional import PowerLawSolid
from winkler.materials.viscoelastic import Prony

ROWS = [f"{FIRST}{field}" for field in ("relaxed_shear", "shears", "relaxation_times")]
IN = ["contact_point", "baseline"]


@pytest.fixture(scope="module")
def measured():
    pytest.importorskip("afmformats")

    def read(folder, name):
        return read_curve(folder / "force_curves" / name)

    return read


@pytest.mark.slow
def test_creep_of_a_polymer_gel(measured, shared_data):
    """The free points give 0.43 nN, and the modulus does not depend on when it is subtracted; a bead's first touch is
    sharper than this one, and the flags say that.  Above a tenth of the force alone it was 413 Pa with 1.04 nN.
    """
    curve = measured(shared_data, "fmt-jpk-cc_pr14-polymergel-2021.06.30.jpk-force")
    assert [(int(part.direction[0]), part.count) for part in curve.parts] == [(1, 3000), (0, 3000), (-1, 3000)]
    curve = curve.chosen(curve.direction >= 0.0)
    curve = curve.chosen(np.r_[2600:6000:2])
    gel = model(Prony(1e2, [1e3] * 2, [0.1, 1.0]), wk.Force)
    found = fit(curve, gel, free=[*ROWS, *IN])
    free = np.mean(curve.force[:50])
    assert abs(found.value("baseline") - free) < 4.0 * found.error("baseline") + 2e-11
    assert found.value("contact_point") == pytest.approx(-27.3e-6, abs=0.1e-6)
    assert "misfit" in {flag.name for flag in found.flags}
    flat = dataclasses.replace(curve, force=curve.force - free)
    known = fit(flat, gel, free=[*ROWS, "contact_point"])
    modulus = f"{FIRST}relaxed_shear"
    assert known.value(modulus) == pytest.approx(found.value(modulus), rel=0.02)
    held = curve.direction == 0.0
    # nearly elastic: with a fixed branch above the gel's own modulus nothing would be left for the relaxed one
    elastic = fit(curve, model(Prony(1e2, [1.0], [1e4]), wk.Force), free=[ROWS[0], *IN])
    assert np.std(elastic.residuals[held]) > 4.0 * np.std(found.residuals[held])


def test_relaxation_of_cells(measured, shared_data):
    """The force falls by two thirds within 30 s, nearly as one exponential; the rest of the shape is not a bead's."""
    curve = measured(shared_data, "fmt-jpk-sr_cell1-0008.jpk-force")
    curve = curve.chosen((curve.direction >= 0.0) & (curve.time >= 1.0))
    curve = curve.chosen(np.r_[0 : curve.count : 4])
    found = fit(curve, model(Prony(1e2, [1e3], [1.0])), free=[*ROWS, *IN])
    held = curve.direction == 0.0
    assert np.std(found.residuals) < 0.035 * np.ptp(curve.force)
    assert np.std(found.residuals[held & (curve.time > 3.0)]) < 0.02 * np.ptp(curve.force)
    solid = found.model.bed.medium.first
    assert 1.5 < float(solid.relaxation_times[0]) < 6.0
    assert 0.2 < solid.relaxed_shear / float(solid.relaxation(1e-3)) < 0.5
    # the curve begins in contact, and says so
    assert {"no_baseline", "memory"} <= {flag.name for flag in found.flags}


@pytest.mark.slow
def test_a_loop_as_a_power_law(measured, shared_data):
    """A weak power law through a liquid that drags; what sticks during unloading is not explained, and is flagged."""
    curve = measured(shared_data, "fmt-jpk-fd_spot3-0192.jpk-force")
    far = model(PowerLawSolid(1e3, 1.0, 0.2, shortest=1e-4, longest=20.0))
    found = fit(curve, far, free=[f"{FIRST}shear", f"{FIRST}exponent", *IN, "tilt", "drag"])
    assert found.scatter == pytest.approx(41e-12, rel=0.1)
    assert found.scatter < 0.012 * np.ptp(curve.force)
    assert 0.02 < found.value(f"{FIRST}exponent") < 0.12
    assert found.value("drag") * 5e-6 == pytest.approx(47e-12, rel=0.3)  # N at 5 um/s
    assert "misfit" in {flag.name for flag in found.flags}
    plain = fit(curve, far, free=[f"{FIRST}shear", f"{FIRST}exponent", *IN])
    assert "drag" in {flag.name for flag in plain.flags}
