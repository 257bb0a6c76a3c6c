"""Files of calibrated indenters, in TOML, all numbers SI; tables of cross-sections over the contact depth; and the
area functions that Hysitron's programs save, names and numbers in turn, in powers of nm.

A table becomes the coefficients of an area function: so many, and from so shallow a depth on, that the area is that of
the table within one per cent.
"""

from __future__ import annotations

import math
import os
import tomllib
from pathlib import Path
from typing import Any

import numpy as np

from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.io.foreign import in_file, sentence_of
from winkler.io.tables.table import Column, read_table
from winkler.io.tables.table_lines import table_head
from winkler.io.text_file import lines_of
from winkler.io.whole_file import write_whole_text
from winkler.materials.elastic import Elastic
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

KIND = "calibrated_indenter"
DEPTH = Column("contact depth", ("contact depth", "contact_depth", "depth", "hc", "h_c", "h", "d"), "m", "nm")
AREA = Column("area", ("area", "projected area", "contact area", "a", "ac", "a_c", "ap", "a_p"), "m^2", "nm^2")
MOST_TERMS, FEWEST_ROWS = 9, 20
LARGEST_ERROR = 0.01
"""Greatest relative difference between the area function and the table."""
SHALLOWEST = (0.01, 0.02, 0.05, 0.1, 0.2, 0.3)
"""Parts of the greatest depth from which on the area function may hold."""
HYSITRON = "Hysitron Area Function Coefficients"
NANOMETRE = 1e-9
NEEDED = ("area", "frame_compliance", "young", "poisson")
ALLOWED = (*NEEDED, "kind", "shallowest", "deepest", "covariance", "shape_factor", "made_from")


def write_indenter(indenter: CalibratedIndenter, path: str | os.PathLike[str], *, made_from: str = "") -> None:
    """Write a calibrated indenter.

    Parameters
    ----------
    indenter : CalibratedIndenter
    path : str or path
        Path of the file; an existing file is replaced.
    made_from : str, optional
        A line of text that states its origin.
    """
    write_whole_text(Path(path), indenter_text(indenter, made_from=made_from))


def indenter_text(indenter: CalibratedIndenter, *, made_from: str = "") -> str:
    """Return what `write_indenter` writes."""
    import tomli_w

    area = indenter.area
    content: dict[str, Any] = {
        "kind": KIND,
        **({"made_from": made_from} if made_from else {}),
        "area": list(area.coefficients),
        "shallowest": area.shallowest,
        **({"deepest": area.deepest} if math.isfinite(area.deepest) else {}),
        "frame_compliance": indenter.frame_compliance,
        **({"covariance": np.asarray(indenter.covariance).tolist()} if indenter.calibrated else {}),
        "young": indenter.solid.young,
        "poisson": indenter.solid.poisson,
        "shape_factor": indenter.shape_factor,
    }
    return tomli_w.dumps(content)


def read_area(path: str | os.PathLike[str], header: str = "") -> CalibratedArea:
    """Read the cross-sections of a tip from a table with the columns contact depth (h) and area (a).

    Parameters
    ----------
    path : str or path
        The file, with units in its header as in ``depth [nm], area [nm^2]``; or an area function of Hysitron, which
        does not state between which depths it was calibrated.
    header : str, optional
        That line, where the file has none.

    Returns
    -------
    CalibratedArea
        Its coefficients have both signs in general; it holds between its depths within one per cent.

    Raises
    ------
    InvalidInput
        If the file is no such table, or no area function of nine terms is within one per cent of it.
    """
    with sentence_of(path, "no area of a tip can be read from it", "give a table of contact depth and area"):
        lines = [] if header else table_head(path, "a table of contact depth and area")
        if lines and lines[0].startswith(HYSITRON):
            return _hysitron_area(lines, path)
        try:
            table = read_table(path, (DEPTH, AREA), stated=header)
        except InvalidInput as error:
            if header:
                raise
            key = f"give [indenter] with area = '{Path(path).name}' and header = \"depth [nm], area [nm^2]\""
            raise error.reworded(lambda one: f"{one.rstrip('.')}; or {key}.") from None
    depth, area = table.values.T
    with in_file(str(path)):
        return _fitted_area(depth[area > 0.0], area[area > 0.0])


def _hysitron_area(lines: list[str], path: str | os.PathLike[str]) -> CalibratedArea:
    """Return the coefficients of an area function, each a line below its name; A and h are in powers of nm there."""
    stated = dict(zip(map(str.strip, lines), map(str.strip, lines[1:]), strict=False))
    words = [stated[f"C{term}"] for term in range(MOST_TERMS) if f"C{term}" in stated]
    offset = stated.get("B", "0")
    try:
        numbers, constant = [float(word) for word in words], float(offset)
    except ValueError:
        raise InvalidInput(f"{path}: its coefficients are {', '.join(words)}, B {offset}; give numbers.") from None
    if not numbers or constant != 0.0:
        raise InvalidInput(f"{path}: it states {len(numbers)} coefficients and B {offset}; give C0 and on, without B.")
    powers = 2.0 ** (1.0 - np.arange(len(numbers)))
    with in_file(str(path)):
        return CalibratedArea(tuple((np.array(numbers) * NANOMETRE ** (2.0 - powers)).tolist()))


def _fitted_area(depth: Array, area: Array) -> CalibratedArea:
    order = np.argsort(depth, kind="stable")
    h, a = depth[order], area[order]
    if h.size < FEWEST_ROWS or h[0] < 0.0:
        raise InvalidInput(f"the table has {h.size} depths with an area; give {FEWEST_ROWS} or more, from zero on.")
    deepest = float(h[-1])
    for share in SHALLOWEST:
        chosen = h >= share * deepest
        if np.count_nonzero(chosen) < FEWEST_ROWS:
            break
        x, sizes = h[chosen] / deepest, a[chosen]
        for terms in range(1, MOST_TERMS + 1):
            powers = 2.0 ** (1.0 - np.arange(terms))
            basis = x[:, None] ** powers / sizes[:, None]
            found = np.linalg.lstsq(basis, np.ones(x.size))[0]
            if float(np.abs(basis @ found - 1.0).max()) <= LARGEST_ERROR:
                coefficients = tuple((found / deepest**powers).tolist())
                return CalibratedArea(coefficients, float(h[chosen][0]), deepest)
    raise InvalidInput(
        f"no area function of {MOST_TERMS} terms is within {LARGEST_ERROR:.0%} of the table beyond "
        f"{SHALLOWEST[-1] * deepest:.3g} m; smooth its areas, or leave out depths at which they jump."
    )


def read_indenter(path: str | os.PathLike[str]) -> CalibratedIndenter:
    """Read a calibrated indenter.

    Parameters
    ----------
    path : str or path
        A file that `write_indenter` or a calibration study wrote.

    Raises
    ------
    InvalidInput
        If the file does not exist, is not such a file, or contains a number that is not allowed.
    """
    with sentence_of(path, "no calibrated indenter can be read from it", "calibrate one with `winkler fit`"):
        raw = tomllib.loads("\n".join(lines_of(path, "a calibrated indenter as a calibration writes it")))
    file = Path(path)
    if raw.get("kind") != KIND:
        raise InvalidInput(f"{file.name}: kind is {raw.get('kind')!r}; a calibrated indenter has kind = '{KIND}'.")
    unknown = [key for key in raw if key not in ALLOWED]
    missing = [key for key in NEEDED if key not in raw]
    if unknown or missing:
        reason = f"the key '{unknown[0]}' is unknown" if unknown else f"the key '{missing[0]}' is missing"
        raise InvalidInput(f"{file.name}: {reason}; give {', '.join(ALLOWED)}.")
    try:
        area = CalibratedArea(
            tuple(float(c) for c in raw["area"]), float(raw.get("shallowest", 0.0)), float(raw.get("deepest", math.inf))
        )
        covariance = np.array(raw["covariance"], dtype=float) if "covariance" in raw else np.zeros((0, 0))
        solid = Elastic(float(raw["young"]), float(raw["poisson"]))
        return CalibratedIndenter(
            area, float(raw["frame_compliance"]), covariance, solid, float(raw.get("shape_factor", 1.0))
        )
    except (TypeError, ValueError, InvalidInput) as error:
        raise InvalidInput(f"{file.name}: {error}") from None
