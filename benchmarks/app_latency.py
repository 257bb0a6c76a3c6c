"""How long the app takes from a slider's move to new numbers and to redrawn pictures, measured inside a real browser.

    python benchmarks/app_latency.py [path of the browser]

Starts the app, opens every kind of the first chapter and four others, moves a slider of each 12 times by the keyboard,
and takes the time from the key to the first new number at the head of the answer, and to the moment when every picture
has been drawn again, also those below the window, and the page painted.  Of two kinds with temperatures it also takes
the time from the choice of the kind to its first numbers.  Prints one table with the load of the machine, and the
processor time of a change, which other programs lengthen less.  The target is a median below 150 ms to all pictures of
each kind of the first chapter.
"""

from __future__ import annotations

import math
import os
import shutil
import statistics
import subprocess
import sys
import urllib.error
import urllib.request
from pathlib import Path
from socket import socket
from time import monotonic, sleep
from typing import Any, NamedTuple

from playwright.sync_api import sync_playwright

CHANGES = 12
TARGET = 150.0
FIRST_CHAPTER = (
    "indentation",
    "yield_onset",
    "elliptic_indentation",
    "elliptic_yield_onset",
    "nearly_round_indentation",
)
OTHERS = ("line_indentation", "adhesive_indentation", "tangential", "viscoelastic_indentation")
TEMPERATURES = ("friction_heating", "joule_heating")
KINDS = (*FIRST_CHAPTER, *OTHERS, *TEMPERATURES)

SLIDER = "problem.bed.profile.curvature_radius"
SLIDERS: dict[str, str] = {
    "elliptic_indentation": "problem.load.force",
    "elliptic_yield_onset": "problem.bodies.longitudinal_curvature_radius",
    "nearly_round_indentation": "problem.load.depth",
}
"""Kind -> the slider that is moved, where it is another one."""
HELD = "before => document.querySelector('.head').innerHTML !== before"

READY = "count => window.numbers > 0 && (count === 0 || window.took > 0)"
WATCH = """() => {
  const plots = [...document.querySelectorAll('[data-picture]')], frame = window.frame ??= window.requestAnimationFrame;
  new MutationObserver(() => { window.numbers ||= performance.now() - window.began; })
    .observe(document.querySelector('.head'), { childList: true, subtree: true, characterData: true });
  let waiting = new Set(), drawing = false;
  window.requestAnimationFrame = call => frame(time => { drawing = true; call(time); drawing = false; });
  const seen = plot => { const b = plot.getBoundingClientRect(); return b.bottom > 0 && b.top < innerHeight; };
  const drawn = last => setTimeout(() => {
    window.insight ||= performance.now() - window.began;
    if (last) window.took = performance.now() - window.began;
  });
  for (const plot of plots) {
    let held = plot.data;
    Object.defineProperty(plot, 'data', { get: () => held, set: next => {
      held = next;
      if (!waiting.delete(plot)) return;
      const last = waiting.size === 0;
      if (last || ![...waiting].some(seen)) {
        const done = () => drawn(last);
        drawing ? done() : frame(done);
      }
    } });
  }
  document.addEventListener('keydown', () => {
    [window.began, window.took, window.insight, window.numbers, waiting] = [performance.now(), 0, 0, 0, new Set(plots)];
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


def processor(pid: int) -> dict[int, float]:
    """Return the processor times of a process and its descendants so far [ms]; none where the system has no /proc."""
    parents, times = {}, {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        own = int(stat.parent.name)
        parents[own], times[own] = int(fields[1]), int(fields[11]) + int(fields[12])
    family = {pid}
    while more := {one for one, parent in parents.items() if parent in family} - family:
        family |= more
    return {one: times[one] * 1e3 / os.sysconf("SC_CLK_TCK") for one in family if one in times}


def per_change(before: dict[int, float], after: dict[int, float]) -> float:
    """Return the processor time of one change [ms]; processes that have ended meanwhile are left out."""
    return sum(spent - before.get(one, 0.0) for one, spent in after.items()) / CHANGES


class Latency(NamedTuple):
    """Of every change [ms]: to numbers, to the pictures in sight and to all; and the mean processor times [ms].

    `first` is the time from the choice of the kind to its first numbers [s].
    """

    numbers: list[float]
    seen: list[float]
    pictures: list[float]
    count: int
    app: float
    browser: float
    first: float


def measured(page: Any, kind: str, app: int) -> Latency:
    """Return what the changes of one kind of problem took."""
    first = math.nan
    if kind != KINDS[0]:
        page.locator('[data-choice="problem"]').first.click()
        head, begun = page.locator(".head").inner_html(), monotonic()
        page.get_by_role("option", name=kind.replace("_", " "), exact=True).click()
        page.wait_for_function(HELD, arg=head, timeout=90_000)
        first = monotonic() - begun
    page.locator('.answer-side[data-state="done"]').wait_for(timeout=90_000)
    page.wait_for_timeout(1500)
    count = page.evaluate(WATCH)
    slider = page.locator(f'[data-slide="{SLIDERS.get(kind, SLIDER)}"] [tabindex="0"]').first
    numbers, seen, pictures = [], [], []
    before, all_before = processor(app), processor(os.getpid())
    for change in range(CHANGES):
        slider.focus()
        page.keyboard.press("ArrowRight" if change % 5 else "PageUp")
        page.wait_for_function(READY, arg=count, timeout=30_000)
        for name, times in (("numbers", numbers), ("insight", seen), ("took", pictures)):
            times.append(float(page.evaluate(f"() => window.{name} || NaN")))
        page.wait_for_timeout(150)
    spent, both = per_change(before, processor(app)), per_change(all_before, processor(os.getpid()))
    return Latency(numbers, seen, pictures, count, spent, both - spent, first)


def main() -> int:
    """Measure, print, and state by the exit code whether the target was met."""
    path = sys.argv[1] if len(sys.argv) > 1 else shutil.which("chromium") or shutil.which("google-chrome")
    if not path:
        raise SystemExit("no browser was found; give the path of one")
    port, medians = free_port(), {}
    began = monotonic()
    app = begun(port)
    print(f"the server answers {monotonic() - began:.1f} s after the command")
    print(
        "medians [ms]; processor time of one change [ms]: of the app with its worker, of the browser with this program"
    )
    print(f"{'kind':26s} pictures  numbers  those in sight  all pictures  app  browser  load  first numbers [s]")
    try:
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
            for number, kind in enumerate(KINDS):
                page, opened = browser.new_page(viewport={"width": 1400, "height": 950}), monotonic()
                page.goto(f"http://127.0.0.1:{port}/")
                page.locator("[data-picture] .main-svg").first.wait_for(timeout=90_000)
                if number < 2:
                    print(f"first pictures of {'a second page' if number else 'the first page'}: "
                          f"{monotonic() - (opened if number else began):.1f} s")  # fmt: skip
                page.locator('.answer-side[data-state="done"]').wait_for(timeout=90_000)
                took = measured(page, kind, app.pid)
                page.close()
                medians[kind] = statistics.median(took.pictures)
                numbers, seen = statistics.median(took.numbers), statistics.median(took.seen)
                print(
                    f"{kind:26s} {took.count:8d}  {numbers:7.0f}  {seen:14.0f}  {medians[kind]:12.0f}  "
                    f"{took.app:3.0f}  {took.browser:7.0f}  {os.getloadavg()[0]:4.1f}  {took.first:.1f}",
                    flush=True,
                )
            browser.close()
    finally:
        app.terminate()
        app.wait(10.0)
    return 0 if all(medians[kind] < TARGET for kind in FIRST_CHAPTER) else 1


if __name__ == "__main__":
    raise SystemExit(main())
