"""The app as a process: workers come with browsers and end with the app, however it ends, and so do uploads."""

from __future__ import annotations

import base64
import contextlib
import os
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

pytest.importorskip("nicegui")

pytestmark = [pytest.mark.slow, pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="looks at processes")]


def until(condition, seconds=60.0):
    """Wait for something."""
    end = time.monotonic() + seconds
    while not (answer := condition()):
        assert time.monotonic() < end
        time.sleep(0.05)
    return answer


class App:
    """A running app."""

    def __init__(self, folder, *options):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        words = [sys.executable, "-m", "winkler", "app", "--port", str(self.port), "--no-browser", *options]
        plain = {name: content for name, content in os.environ.items() if not name.startswith("PYTEST")}
        self.process = subprocess.Popen(words, env=plain | {"TMPDIR": str(folder)}, stdout=-3, stderr=subprocess.PIPE)
        self.address = f"http://127.0.0.1:{self.port}"
        until(self.answers)

    def answers(self):
        assert self.process.poll() is None, self.process.stderr.read()
        with contextlib.suppress(OSError):
            return self.get().status == 200

    def get(self):
        with urllib.request.urlopen(self.address, timeout=20.0) as response:
            self.page = response.read().decode()
            return response

    def workers(self):
        """Return the processes that solve."""
        own = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text().split()
        return [int(pid) for pid in own if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes()]

    def open(self):
        """Open a page as a browser does, up to the handshake; return the socket."""
        self.get()
        client = re.search(r"client_id': '([\w-]+)'", self.page)[1]
        words = f"EIO=4&transport=websocket&client_id={client}&tab_id={client}&document_id={client}&next_message_id=0"
        pipe = socket.create_connection(("127.0.0.1", self.port), timeout=20.0)
        pipe.sendall(
            f"GET /_nicegui_ws/socket.io/?{words}&implicit_handshake=true HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n"
            f"Origin: {self.address}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
            f"Sec-WebSocket-Key: {base64.b64encode(os.urandom(16)).decode()}\r\n\r\n".encode()
        )
        got = b""
        while b"0{" not in got:
            got += pipe.recv(4096) or pytest.fail(got)
        pipe.sendall(bytes([0x81, 0x82, 0, 0, 0, 0]) + b"40")  # one frame, masked by zeros
        while b"pages of the app are open" not in got and b"Contact mechanics" not in got:
            got += pipe.recv(4096) or pytest.fail(got)
        return pipe

    def end(self, number):
        """Send a signal, and wait for the end; return the status and what was written."""
        self.process.send_signal(number)
        error = self.process.communicate(timeout=60.0)[1].decode()
        return self.process.returncode, error


def gone(pid):
    return not Path(f"/proc/{pid}").exists() or "State:\tZ" in Path(f"/proc/{pid}/status").read_text()


def test_processes_and_folders(tmp_path):
    app = App(tmp_path, "--pages", "2")
    for _ in range(12):
        app.get()
    assert len(app.workers()) <= 1  # it waits for the first page
    pages = [app.open() for _ in range(3)]
    workers = app.workers()
    assert len(workers) in (2, 3)  # of the pages, and one that waits for the next one
    (left,) = tmp_path.glob("winkler-*")
    assert len(list(left.glob("winkler-page-*"))) == 2
    next(left.glob("winkler-page-*")).joinpath("tip.csv").write_text("1 2")
    app.end(signal.SIGKILL)
    until(lambda: all(map(gone, workers)))
    assert left.exists()

    for number, codes in ((signal.SIGINT, (0, 130)), (signal.SIGTERM, (143,))):
        app = App(tmp_path)
        assert not left.exists()
        pages.append(app.open())
        workers = app.workers()
        assert len(workers) in (1, 2)
        (folder,) = tmp_path.glob("winkler-*")
        next(folder.glob("winkler-page-*")).joinpath("tip.csv").write_text("1 2")
        code, error = app.end(number)
        assert code in codes, error
        assert "Traceback" not in error
        until(lambda: all(map(gone, workers)))  # noqa: B023
        assert list(tmp_path.iterdir()) == []
    for pipe in pages:
        pipe.close()
