"""Files of calibrated indenters: area function, frame compliance and their covariance, in TOML, all numbers SI."""

from __future__ import annotations

import math
import os
import tomllib
from pathlib import Path
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.io.foreign import sentence_of
from winkler.io.text_file import lines_of
from winkler.io.whole_file import write_whole_text
from winkler.materials.elastic import Elastic

__all__ = ["indenter_text", "read_indenter", "write_indenter"]

KIND = "calibrated_indenter"
NEEDED = ("area", "frame_compliance", "young", "poisson")
ALLOWED = (*NEEDED, "kind", "shallowest", "deepest", "covariance", "shape_factor", "made_from")


def write_indenter(indenter: CalibratedIndenter, path: str | os.PathLike[str], *, made_from: str = "") -> None:
    """Write a calibrated indenter.

    Parameters
    ----------
    indenter : CalibratedIndenter
    path : str or path
        Of the file; one that is there is replaced.
    made_from : str, optional
        A line that says where it comes from.
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


def read_indenter(path: str | os.PathLike[str]) -> CalibratedIndenter:
    """Read a calibrated indenter.

    Parameters
    ----------
    path : str or path
        A file that `write_indenter` or a calibration study wrote.

    Raises
    ------
    InvalidInput
        If the file does not exist, is no such file, or a number is not allowed.
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
