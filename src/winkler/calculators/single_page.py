"""The page of the calculators: one file with style, script and kernels inside, which asks nobody for anything."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from winkler.calculators.calculator import Calculator
from winkler.calculators.catalogue import CALCULATORS

__all__ = ["APP", "HERE", "calculator_page", "described", "joined_script", "module_text"]

HERE = Path(__file__).parent / "page"
APP = "http://127.0.0.1:8765"
"""Where `winkler app` is, unless another address is given."""
IMPORTS = re.compile(r"^import .*;\n", re.MULTILINE)
EXPORTS = re.compile(r"^export (?=async|class|const|function)", re.MULTILINE)


def joined_script(names: Iterable[str]) -> str:
    """Return modules as one script without imports, in an order in which each stands behind those it needs."""
    texts = [(HERE / f"{name}.js").read_text(encoding="utf-8") for name in names]
    return "\n".join(EXPORTS.sub("", IMPORTS.sub("", text)) for text in texts)


def module_text() -> str:
    """Return the kernels as text."""
    return base64.b64encode((HERE / "calculators.wasm").read_bytes()).decode("ascii")


def described(one: Calculator) -> dict[str, Any]:
    """Return what the page must know of a calculator."""
    sliders = [{**slider._asdict(), "factor": factor} for slider, factor in zip(one.sliders, one.factors, strict=True)]
    numbers = [{**number._asdict(), "factor": number.factor} for number in one.numbers]
    kept = {
        key: getattr(one, key)
        for key in ("name", "title", "question", "kind", "across", "up", "valid", "page", "study")
    }
    return {**kept, "sliders": sliders, "numbers": numbers}


def calculator_page(manual: str = "") -> str:
    """Return the page.

    Parameters
    ----------
    manual : str, optional
        Address of the manual, ending with ``/``; the folder of the page unless given.
    """
    try:
        made_by = version("winkler")
    except PackageNotFoundError:
        made_by = ""
    calculators = [{**described(one), "page": manual + one.page} for one in CALCULATORS]
    data = json.dumps({"calculators": calculators, "module": module_text(), "app": APP}, ensure_ascii=False)
    style = "".join((HERE / f"{name}.css").read_text(encoding="utf-8") for name in ("calculators", "page"))
    parts = {
        "VERSION": made_by,
        "MANUAL": manual,
        "STYLE": style,
        "SCRIPT": joined_script(("reading", "chart", "calculators", "page")),
        "DATA": data.replace("</", "<\\/"),
    }
    frame = (HERE / "page.html").read_text(encoding="utf-8")
    return re.sub("|".join(parts), lambda found: parts[found.group()], frame)
