"""Ctrl-C in a terminal, which reaches all processes of the app, while a page starts again: one line, no traceback."""

from __future__ import annotations

import contextlib
import os
import re
import signal
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request

import pytest

from conftest import AppPage, free_port

pytestmark = pytest.mark.browser


def test_ctrl_c_after_a_reload(browser, tmp_path):
    address = f"http://127.0.0.1:{(port := free_port())}"
    words = [sys.executable, "-m", "winkler", "app", "--port", str(port), "--no-browser"]
    plain = {name: content for name, content in os.environ.items() if not name.startswith("PYTEST")}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    process = subprocess.Popen(words, **pipes, start_new_session=True, env=plain | {"TMPDIR": str(tmp_path)})
    assert address in process.stdout.readline()

    def asked(query):
        where = f"{address}/_nicegui_ws/socket.io/?EIO=4&transport=polling{query}"
        request = urllib.request.Request(where, headers={"Origin": address})
        return urllib.request.urlopen(request, timeout=60).read().decode()

    for _ in range(150):
        try:
            opening = asked("")
            break
        except urllib.error.URLError:
            time.sleep(0.2)
    waiting = re.search(r'"sid":"([^"]+)"', opening)[1]

    def left_open():
        with contextlib.suppress(OSError):
            asked(f"&sid={waiting}")

    threading.Thread(target=left_open, daemon=True).start()  # as a page has it whose socket was not yet opened
    app_page = AppPage(browser, address)
    app_page.page.reload(wait_until="load")
    time.sleep(0.2)  # its process is being started
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=30.0)
    app_page.context.close()
    assert "Error" not in err, err
    assert "Traceback" not in err, err
