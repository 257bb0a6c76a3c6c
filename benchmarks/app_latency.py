"""How long the app takes from a slider's move to new numbers and to redrawn pictures, measured inside a real browser.

    python benchmarks/app_latency.py [path of the browser]

Starts the app, opens six kinds of problems, moves a slider of each 12 times by the keyboard, and takes the time from
the key to the first new number at the head of the answer, and to the moment when every picture has been drawn again,
also those below the window, and the page painted.  Prints one table with the load of the machine.  The target is a
median below 200 ms to all pictures of the first kind.
"""

from __future__ import annotations

import os
import shutil
import statistics
import subprocess
import sys
import urllib.error
import urllib.request
from socket import socket
from time import monotonic, sleep
from typing import Any

from playwright.sync_api import sync_playwright

CHANGES = 12
TARGET = 200.0
KINDS = (
    "indentation",
    "line_indentation",
    "elliptic_indentation",
    "adhesive_indentation",
    "tangential",
    "viscoelastic_indentation",
)

SLIDER = "problem.bed.profile.curvature_radius"
SLIDERS: dict[str, str] = {"elliptic_indentation": "problem.load.force"}
"""Kind -> the slider that is moved, where it is another one."""

READY = "count => window.numbers > 0 && (count === 0 || window.took > 0)"
WATCH = """() => {
  const plots = [...document.querySelectorAll('[data-picture]')], frame = window.frame ??= window.requestAnimationFrame;
  new MutationObserver(() => { window.numbers ||= performance.now() - window.began; })
    .observe(document.querySelector('.head'), { childList: true, subtree: true, characterData: true });
  let waiting = new Set(), drawing = false;
  window.requestAnimationFrame = call => frame(time => { drawing = true; call(time); drawing = false; });
  const drawn = () => setTimeout(() => { window.took = performance.now() - window.began; });
  for (const plot of plots) {
    let held = plot.data;
    Object.defineProperty(plot, 'data', { get: () => held, set: next => {
      held = next;
      if (waiting.delete(plot) && waiting.size === 0) { drawing ? drawn() : frame(drawn); }
    } });
  }
  document.addEventListener('keydown', () => {
    [window.began, window.took, window.numbers, waiting] = [performance.now(), 0, 0, new Set(plots)];
  }, true);
  return plots.length;
}"""
"""Redrawing gives a picture another object of data; after the frame in which that happens, or the next, it is shown."""


def free_port() -> int:
    """Return a port that nobody listens to."""
    with socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def begun(port: int) -> subprocess.Popen[bytes]:
    """Start the app, and wait until it responds."""
    words = [sys.executable, "-m", "winkler", "app", "--port", str(port), "--no-browser"]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    end = monotonic() + 60.0
    while monotonic() < end:
        try:
            urllib.request.urlopen(f"http://127.0.0.1:{port}/", timeout=2.0).close()
            return process
        except (urllib.error.URLError, OSError):
            sleep(0.2)
    process.terminate()
    raise SystemExit("the app did not start within a minute")


def measured(page: Any, kind: str) -> tuple[list[float], list[float], int]:
    """Return the milliseconds of every change to numbers and to pictures, and how many pictures there are."""
    if kind != KINDS[0]:
        page.locator('[data-choice="problem"]').first.click()
        page.get_by_role("option", name=kind.replace("_", " "), exact=True).click()
        page.locator('.answer-side[data-state="busy"]').wait_for(timeout=20_000)
    page.locator('.answer-side[data-state="done"]').wait_for(timeout=90_000)
    page.wait_for_timeout(1500)
    count = page.evaluate(WATCH)
    slider = page.locator(f'[data-slide="{SLIDERS.get(kind, SLIDER)}"] [tabindex="0"]').first
    numbers, pictures = [], []
    for change in range(CHANGES):
        slider.focus()
        page.keyboard.press("ArrowRight" if change % 5 else "PageUp")
        page.wait_for_function(READY, arg=count, timeout=30_000)
        numbers.append(float(page.evaluate("() => window.numbers")))
        pictures.append(float(page.evaluate("() => window.took || NaN")))
        page.wait_for_timeout(150)
    return numbers, pictures, count


def main() -> int:
    """Measure, print, and state by the exit code whether the target was met."""
    path = sys.argv[1] if len(sys.argv) > 1 else shutil.which("chromium") or shutil.which("google-chrome")
    if not path:
        raise SystemExit("no browser was found; give the path of one")
    port, medians = free_port(), []
    app = begun(port)
    print(f"{'kind':26s} pictures  numbers: median, slowest [ms]  all pictures: median, slowest [ms]  load")
    try:
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
            for kind in KINDS:
                page = browser.new_page(viewport={"width": 1400, "height": 950})
                page.goto(f"http://127.0.0.1:{port}/")
                page.locator('.answer-side[data-state="done"]').wait_for(timeout=90_000)
                numbers, pictures, count = measured(page, kind)
                page.close()
                medians.append(statistics.median(pictures))
                print(
                    f"{kind:26s} {count:8d}  {statistics.median(numbers):15.0f}, {max(numbers):7.0f}       "
                    f"{medians[-1]:19.0f}, {max(pictures):7.0f}       {os.getloadavg()[0]:.1f} of {os.cpu_count()}",
                    flush=True,
                )
            browser.close()
    finally:
        app.terminate()
        app.wait(10.0)
    return 0 if medians[0] < TARGET else 1


if __name__ == "__main__":
    raise SystemExit(main())
