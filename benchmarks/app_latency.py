"""How long the app takes from a slider's move to redrawn pictures, measured inside a real browser.

    python benchmarks/app_latency.py [path of the browser]

Starts the app, opens it, moves sliders of an elastic contact 20 times by the keyboard, and takes the time from the
key to the moment when every picture has been drawn again, also those below the window, and the page painted.  The
target is a median below 200 ms.
"""

from __future__ import annotations

import shutil
import statistics
import subprocess
import sys
import urllib.error
import urllib.request
from socket import socket
from time import monotonic, sleep

from playwright.sync_api import sync_playwright

CHANGES = 20
TARGET = 200.0
SLIDERS = ("problem.load.force", "problem.bed.profile.curvature_radius")

WATCH = """() => {
  const plots = [...document.querySelectorAll('[data-picture]')], frame = window.requestAnimationFrame;
  let began = 0, waiting = new Set(), drawing = false;
  window.requestAnimationFrame = call => frame(time => { drawing = true; call(time); drawing = false; });
  const drawn = () => setTimeout(() => { window.took = performance.now() - began; });
  for (const plot of plots) {
    let held = plot.data;
    Object.defineProperty(plot, 'data', { get: () => held, set: next => {
      held = next;
      if (waiting.delete(plot) && waiting.size === 0) { drawing ? drawn() : frame(drawn); }
    } });
  }
  document.addEventListener('keydown', () => {
    [began, window.took, waiting] = [performance.now(), 0, new Set(plots)];
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


def measured(port: int, browser: str) -> list[float]:
    """Return the milliseconds of every change."""
    took = []
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=browser, args=["--no-sandbox"])
        page = chromium.new_page(viewport={"width": 1400, "height": 950})
        page.goto(f"http://127.0.0.1:{port}/")
        page.locator('.answer-side[data-state="done"]').wait_for(timeout=60_000)
        page.wait_for_timeout(2000)
        print(f"{page.evaluate(WATCH)} pictures", end="; ", flush=True)
        for change in range(CHANGES):
            slider = page.locator(f'[data-slide="{SLIDERS[change % len(SLIDERS)]}"] [tabindex="0"]').first
            slider.focus()
            page.keyboard.press("ArrowRight" if change % 5 else "PageUp")
            page.wait_for_function("() => window.took > 0", timeout=20_000)
            took.append(float(page.evaluate("() => window.took")))
            page.wait_for_timeout(150)
        chromium.close()
    return took


def main() -> int:
    """Measure, print, and state by the exit code whether the target was met."""
    browser = sys.argv[1] if len(sys.argv) > 1 else shutil.which("chromium") or shutil.which("google-chrome")
    if not browser:
        raise SystemExit("no browser was found; give the path of one")
    port = free_port()
    app = begun(port)
    try:
        took = measured(port, browser)
    finally:
        app.terminate()
        app.wait(10.0)
    middle = statistics.median(took)
    print(f"{len(took)} changes: median {middle:.0f} ms, fastest {min(took):.0f} ms, slowest {max(took):.0f} ms")
    return 0 if middle < TARGET else 1


if __name__ == "__main__":
    raise SystemExit(main())
