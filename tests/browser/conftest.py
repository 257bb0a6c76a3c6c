"""The app in a process of its own, and a real browser that looks at it; no request may leave this machine."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
import warnings
from pathlib import Path

import pytest

from winkler.web.form.link import code_of

SHOTS = os.environ.get("WINKLER_SCREENSHOTS", "")
"""Folder for screenshots, to be looked at; none are taken without it."""


ASKED = "() => document.querySelector('.answer-side')?.dataset.asked ?? '0'"
"""How many requests the page has sent: the state itself may be busy for less than it takes to look at it."""
OVER = """width => [...document.querySelectorAll('.study-side *, .answer-side *')].filter(one => {
  const { right, width: across } = one.getBoundingClientRect();
  if (!across || right <= width + 1) return false;
  for (let outer = one.parentElement; outer; outer = outer.parentElement)
    if (getComputedStyle(outer).overflowX !== 'visible' && outer.getBoundingClientRect().right <= width + 1)
      return false;
  return true;
}).slice(0, 3).map(one => `${one.tagName} ${one.className}`)"""
"""Elements that reach over the edge of the window, but for those that scroll by themselves."""


def free_port():
    """Return a port that nobody uses."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def served(*options, port=None, crashes=False):
    """Start the app, and give where it is; one that crashes is killed in the end."""
    port = port or free_port()
    words = [sys.executable, "-m", "winkler", "app", "--port", str(port), "--no-browser", *options]
    plain = {name: content for name, content in os.environ.items() if not name.startswith("PYTEST")}
    uploads = tempfile.TemporaryDirectory()
    plain["TMPDIR"] = uploads.name
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=plain)
    address = f"http://127.0.0.1:{port}"
    for _ in range(300):
        try:
            urllib.request.urlopen(address, timeout=5.0).close()
            break
        except (urllib.error.URLError, OSError):
            assert process.poll() is None, process.stderr.read()
            time.sleep(0.2)
    yield address
    if crashes:
        process.kill()
        process.communicate(timeout=30.0)
        uploads.cleanup()
        return
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30.0)
    assert process.returncode in (0, 130), err
    assert address in out
    assert "Traceback" not in err, err
    with uploads:
        assert not list(Path(uploads.name).glob("winkler-*"))


@pytest.fixture(scope="session")
def app():
    """The app, and where it is."""
    with served() as address:
        yield address


@pytest.fixture
def impatient(browser):
    """A page of an app that lets a study take five seconds."""
    with served("--time-limit", "5") as address:
        page = AppPage(browser, address)
        yield page
        page.context.close()


@pytest.fixture(scope="session")
def browser():
    """A browser without a window."""
    from playwright.sync_api import sync_playwright

    path = shutil.which("chromium") or shutil.which("google-chrome")
    assert path, "the tests in a browser need chromium on the path"
    with sync_playwright() as playwright:
        running = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
        yield running
        running.close()


class AppPage:
    """One page of the app, as a person uses it."""

    def __init__(self, browser, address, width=1400, height=950, scale=1):
        self.left_machine, self.mistakes = [], []  # requests to elsewhere; exceptions, and what the policy forbids
        size = {"width": width, "height": height}
        self.context = browser.new_context(viewport=size, device_scale_factor=scale, accept_downloads=True)
        self.context.set_default_timeout(90_000)  # the machine may be busy with other tests
        self.page = self.context.new_page()
        self.page.route("**/*", self._only_here(address))
        self.page.on("pageerror", lambda error: self.mistakes.append(str(error)))
        self.page.on("console", self._overheard)
        self.page.goto(address)
        self.settled()

    def _overheard(self, message):
        if "Content Security Policy" in message.text:
            self.mistakes.append(message.text)

    def _only_here(self, address):
        def decide(route):
            if route.request.url.startswith((address, "data:", "blob:")):
                route.continue_()
            else:
                self.left_machine.append(route.request.url)
                route.abort()

        return decide

    def settled(self, state="done"):
        """Wait until an answer is complete, or refused."""
        self.page.locator(f'.answer-side[data-state="{state}"]').wait_for(timeout=90_000)
        self.note()

    def note(self):
        """Note how much was requested so far, before the next thing is done."""
        self.asked = self.page.evaluate(ASKED)

    def busy(self):
        """Wait until something was requested since it was noted, typed or chosen; it may have been answered already."""
        self.page.wait_for_function(f"before => ({ASKED})() !== before", arg=self.asked, timeout=60_000)

    def show(self, text):
        """Show another study by its address; wait for its numbers, also for those below the pictures."""
        both = """before => {
          const [head, tail] = ['.head', '.tail'].map(name => document.querySelector(name).innerHTML);
          const wrong = document.querySelector('.answer-side').dataset.state === 'wrong';
          return wrong || (head !== before && tail !== '' && head.includes(tail));
        }"""
        before = self.page.locator(".head").inner_html()
        self.page.evaluate("code => { location.hash = `study=${code}`; }", code_of(text))
        self.page.wait_for_function(both, arg=before, timeout=90_000)

    def answered(self, before):
        """Wait until other numbers stand on the page, and below their pictures too, which come after them."""
        both = """before => {
          const [head, tail] = ['.head', '.tail'].map(name => document.querySelector(name).innerHTML);
          return head !== before && tail !== '' && head.includes(tail);
        }"""
        self.page.wait_for_function(both, arg=before, timeout=90_000)

    def choose(self, path, name):
        """Choose a kind at a place of the form."""
        self.pick(path, name.replace("_", " "))

    def pick(self, path, words):
        """Open the list at a place of the form, and take an option; a list that closed again is opened once more."""
        from playwright.sync_api import TimeoutError as TookTooLong

        option = self.page.get_by_role("option", name=words, exact=True)
        opener = self.page.locator(f'[data-choice="{path}"]').first
        opener.click()
        try:
            option.wait_for(timeout=20_000)
        except TookTooLong:
            assert self.page.locator(".q-menu").count() == 0, f"the list at {path} is open without {words!r}"
            warnings.warn(f"the list at {path} had closed again, which happened once in some thousand", stacklevel=2)
            opener.click()
        self.note()
        option.click()

    def type(self, path, text):
        """Write into a field."""
        self.note()
        self.page.locator(f'input[data-path="{path}"]').fill(text)

    def overflow(self):
        """Return what reaches over the edge of the window."""
        wide = self.page.evaluate("document.documentElement.scrollWidth > innerWidth")
        return ["the page"] * wide + self.page.evaluate(OVER, self.page.viewport_size["width"])

    def card(self, name):
        """Return what the large number under a name says."""
        return self.page.locator(".head .card", has_text=name).locator(".value").inner_text()

    def taken(self, what):
        """Take a file along, and return its content."""
        with self.page.expect_download(timeout=60_000) as promise:
            self.page.locator(f'[data-export="{what}"]').click()
        self.note()  # a file is a request, too
        return Path(promise.value.path()).read_bytes()

    def shot(self, name):
        """Keep a picture of the whole page, if somebody wants to look at it."""
        if SHOTS:
            self.page.screenshot(path=Path(SHOTS) / f"{name}.png", full_page=True)


@pytest.fixture(scope="session")
def app_page(browser, app):
    """A page that is open all the time: nobody starts anew for every problem."""
    page = AppPage(browser, app)
    yield page
    assert page.left_machine == []
    assert page.mistakes == []
    page.context.close()


@pytest.fixture
def fresh(browser, app):
    """Return what opens a page of its own."""
    opened = []

    def open_page(**size):
        opened.append(AppPage(browser, app, **size))
        return opened[-1]

    yield open_page
    for page in opened:
        assert page.left_machine == []
        assert page.mistakes == []
        page.context.close()
