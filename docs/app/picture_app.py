"""Take the pictures of the app for the manual, in a browser without a window.

::

    python docs/app/picture_app.py [NAME ...]

starts the app on a free port, opens each of `STATES` in Chromium, and writes ``docs/app/NAME.png`` in few colours.
"""

from __future__ import annotations

import contextlib
import io
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import tomli_w
from PIL import Image

from winkler.calculators.single_page import calculator_page
from winkler.study.language.template import whole_text
from winkler.web.form import fit_form, form
from winkler.web.form.front_examples import FRONT_EXAMPLES
from winkler.web.form.link import code_of
from winkler.web.session.upload_folder import SAMPLE_CURVES

HERE = Path(__file__).resolve().parent
COLOURS = 128
PATIENCE = 300_000
"""The longest that a page may take [ms]."""
FORCE = 'input[data-path="problem.load.force"]'


class State(NamedTuple):
    """What a picture shows.

    Parameters
    ----------
    name
        Of its file, without its ending.
    study
        Title of an example of the front page, or a kind whose example is opened; empty for the first page.
    chapter
        The chapter of its problem, if it stands for one.
    width, height
        Of the window [pixel].
    dark
        Whether the system is dark.
    """

    name: str
    study: str = ""
    chapter: str = ""
    width: int = 1280
    height: int = 860
    dark: bool = False


STATES = (
    State("first_page"),
    State("normal_contact", "Coated tool", "normal contact"),
    State("metals", "plastic_indentation", "metals that yield"),
    State("line_contact", "roller_contact", "line contact"),
    State("adhesion", "adhesive_cycle", "adhesion"),
    State("friction", "tangential", "friction and impacts"),
    State("relaxing_bodies", "Rubber ball, held", "bodies that relax"),
    State("current", "Relay contact", "current and heat"),
    State("frictional_heat", "friction_heating", "frictional heat"),
    State("rolling", "Wheel on rail", "rolling"),
    State("wear", "How long does it last?", "wear"),
    State("rough_surfaces", "Rough joint", "measured and rough surfaces"),
    State("seals", "seal", "true areas and seals"),
    State("surface_current", "surface_constriction", "current through surfaces"),
    State("surface_wear", "surface_wear", "wear of surfaces"),
    State("fields", "map_stress", "fields"),
    State("a_against_b", "Ball bearing"),
    State("folder_of_curves", "folder"),
    State("in_your_words", height=430),
    State("dark", "torsion", dark=True),
    State("phone", "AFM bead on a gel", width=390, height=844),
    State("calculators", "calculators"),
)


def text_of(study: str) -> str:
    """Return the text of the study of a state."""
    for example in FRONT_EXAMPLES:
        if study in (example.title, "folder" if example.kind == "fit" else None):
            table = example.table
            if example.kind == "fit":
                form.put(table, fit_form.CURVE, SAMPLE_CURVES)
            return tomli_w.dumps(table)
    return whole_text(study)


@contextlib.contextmanager
def served() -> Iterator[str]:
    """Start the app on a free port, and give its address."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    words = [sys.executable, "-m", "winkler", "app", "--port", str(port), "--no-browser"]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    address = f"http://127.0.0.1:{port}"
    try:
        for _ in range(300):
            with contextlib.suppress(urllib.error.URLError, OSError):
                urllib.request.urlopen(address, timeout=5.0).close()
                break
            time.sleep(0.2)
        yield address
    finally:
        process.terminate()
        process.wait(30.0)


def prepare(page: Any, state: State, address: str) -> None:
    """Bring a page to a state."""
    if state.study == "calculators":
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "calculators.html"
            path.write_text(calculator_page(), encoding="utf-8")
            page.goto(f"{path.as_uri()}#calculator=adhesion")
            page.locator("html[data-ready=yes]").wait_for(state="attached")
        return
    page.goto(f"{address}/#study={code_of(text_of(state.study))}" if state.study else address)
    done = page.locator('.answer-side[data-state="done"]')
    done.wait_for()
    if state.name == "a_against_b":
        page.locator("[data-pin]").click()
        page.locator(FORCE).fill("2 kN")
        page.locator(".compared", has_text="From A to B").wait_for()
        done.wait_for()
        page.evaluate("document.activeElement.blur(); scrollTo(0, 0)")
    if state.name == "in_your_words":
        page.locator('[data-choice="problem"]').click()
        page.get_by_role("searchbox").fill("how hot does my brake get")
        page.locator("[role=option].found", has_text="friction heating").wait_for()
    page.locator(".q-notification").wait_for(state="hidden")
    page.wait_for_timeout(700)  # the last picture is painted


def saved(content: bytes, path: Path) -> int:
    """Write a picture with few colours; return its size [bytes]."""
    picture = Image.open(io.BytesIO(content)).convert("RGB")
    picture.quantize(COLOURS, dither=Image.Dither.NONE).save(path, optimize=True)
    return path.stat().st_size


def main(names: list[str]) -> None:
    """Take the pictures with these names, or all."""
    from playwright.sync_api import sync_playwright

    with served() as address, sync_playwright() as playwright:
        path = shutil.which("chromium") or shutil.which("google-chrome")
        browser = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
        for state in STATES:
            if names and state.name not in names:
                continue
            colours = "dark" if state.dark else "light"
            size = {"width": state.width, "height": state.height}
            context = browser.new_context(viewport=size, color_scheme=colours)
            context.set_default_timeout(PATIENCE)
            page = context.new_page()
            prepare(page, state, address)
            print(f"{state.name}: {saved(page.screenshot(), HERE / f'{state.name}.png') / 1e3:.0f} kB", flush=True)
            context.close()


if __name__ == "__main__":
    main(sys.argv[1:])
