"""How long one step of a slider takes on the page of calculators: numbers, curve and layout, measured inside a browser.

    python benchmarks/calculator_frames.py [path of the browser]

Moves the sliders of each calculator by 200 steps, one at each frame, and takes the time of what the page does in that
frame: kernels, numbers, curve and axes, and the layout of the page, which is asked for at once.  Prints one table with
the load of the machine.  The target is a median below the time of a picture at sixty a second.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path

from pages import table
from playwright.sync_api import sync_playwright

from winkler.calculators.catalogue import CALCULATORS
from winkler.calculators.single_page import calculator_page

STEPS = 200
FRAME = 1e3 / 60.0
"""Time of a picture [ms]."""
MOVE = """async steps => {
  const ranges = [...document.querySelectorAll("[data-slider]")];
  const took = [];
  for (let step = 0; step < steps; step += 1) {
    const range = ranges[step % ranges.length];
    range.value = Math.round(1000 * (0.5 + 0.45 * Math.sin(0.31 * step)));
    range.dispatchEvent(new Event("input"));
    await new Promise(done => requestAnimationFrame(() => {
      document.body.offsetHeight;
      took.push(performance.now() - window.began);
      done();
    }));
  }
  return took;
}"""
BEGIN = """() => {
  const frame = window.requestAnimationFrame;
  window.requestAnimationFrame = call => frame(time => {
    if (window.at !== time) [window.at, window.began] = [time, performance.now()];
    call(time);
  });
}"""
"""The first callback of a frame, which is that of the page, begins its clock; the last one stops it."""


def main() -> int:
    """Measure, print, and state by the exit code whether the target was met."""
    path = sys.argv[1] if len(sys.argv) > 1 else shutil.which("chromium") or shutil.which("google-chrome")
    if not path:
        raise SystemExit("no browser was found; give the path of one")
    rows, slowest = [], 0.0
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        file = Path(folder) / "calculators.html"
        file.write_text(calculator_page(), encoding="utf-8")
        browser = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1300, "height": 900})
        page.add_init_script(f"({BEGIN})()")
        for one in CALCULATORS:
            page.goto(f"{file.as_uri()}?{one.name}#calculator={one.name}")
            page.locator("html[data-ready=yes]").wait_for(state="attached")
            took = sorted(page.evaluate(MOVE, STEPS))
            median = took[STEPS // 2]
            slowest = max(slowest, median)
            late = sum(time > FRAME for time in took)
            rows.append((one.name, f"{median:.2f}", f"{took[95 * STEPS // 100]:.2f}", f"{late} of {STEPS}"))
        browser.close()
    print(table(("Calculator", "Median [ms]", "95 % below [ms]", "Steps over 16.7 ms"), rows))
    print(f"load average {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    return 0 if slowest < FRAME else 1


if __name__ == "__main__":
    raise SystemExit(main())
