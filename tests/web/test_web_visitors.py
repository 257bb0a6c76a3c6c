"""Who gets a page of the app, and a process with it: the app in this process, with workers that only count."""

from __future__ import annotations

import contextlib
import errno
import multiprocessing
import re
import time
import uuid

import nicegui
import pytest
from nicegui import Client, core, ui
from starlette.testclient import TestClient, WebSocketDisconnect

from winkler.web.page import assembly
from winkler.web.page import visitors as visitors_module
from winkler.web.page.visitors import Visitors
from winkler.web.session import solver
from winkler.web.session.security import origin_of
from winkler.web.session.solver import Worker
from winkler.web.session.standby import Standby

HOME = "http://127.0.0.1:8765"
MOST = 3
LARGEST = 200_000
LEFT = 0.1
"""So long a page waits for a browser that has gone [s]."""


class Workers:
    """Counts workers in place of starting them."""

    def __init__(self):
        self.alive, self.ends = [], []

    def started(self):
        mine, theirs = multiprocessing.Pipe()
        self.ends.append(theirs)
        worker = Worker(self._Process(self.alive), mine)
        self.alive.append(worker.process)
        return worker

    class _Process:
        def __init__(self, alive):
            self.alive = alive

        def kill(self):
            self.alive.remove(self)

        def is_alive(self):
            return self in self.alive

        def join(self, timeout):
            pass


@pytest.fixture(scope="module")
def workers():
    return Workers()


@pytest.fixture(scope="module")
def browser(workers, tmp_path_factory):
    """What sends requests to the app."""
    folder = tmp_path_factory.mktemp("uploads")
    visitors = Visitors(60.0, MOST, folder, Standby())
    # the app of this process may have run already: tests of this file need not follow each other
    core.app.middleware_stack = None
    core.app.user_middleware[:] = [each for each in core.app.user_middleware if each.cls is not assembly.Security]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(assembly, "LARGEST", LARGEST)
        assembly.assemble(visitors, (HOME, origin_of("http://localhost:8765")))
    core.app.config.add_run_config(
        reload=False, title="winkler", viewport="", favicon=None, dark=False, language=None,
        binding_refresh_interval=None, reconnect_timeout=LEFT, message_history_length=1000, tailwind=False, unocss=None,
        prod_js=True, show_welcome_message=False, markdown=False,
    )  # fmt: skip
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(solver, "started", workers.started)
        patch.setattr(visitors_module, "REST", 1e6)  # workers are counted here; those in reserve below
        with TestClient(core.app, base_url=HOME) as client:
            client.folder, client.visitors = folder, visitors
            yield client
        assert workers.alive == []  # when the app ends
        assert list(folder.iterdir()) == []


@contextlib.contextmanager
def opened(browser, tab=None, origin=HOME, client=None):
    """Open a page as a browser does, up to the handshake, or connect one again; give the socket."""
    client = client or re.search(r"client_id': '([\w-]+)'", browser.get("/").text)[1]
    words = {
        "EIO": 4, "transport": "websocket", "client_id": client, "tab_id": tab or uuid.uuid4(), "old_tab_id": "",
        "document_id": uuid.uuid4(), "next_message_id": 0, "implicit_handshake": "true",
    }  # fmt: skip
    path = "ws://127.0.0.1:8765/_nicegui_ws/socket.io/?" + "&".join(f"{name}={word}" for name, word in words.items())
    with browser.websocket_connect(path, headers={"origin": origin, "upgrade": "websocket"}) as socket:
        assert socket.receive_text().startswith("0{")
        socket.send_text("40")
        wait_for_text(socket, "40{")
        socket.client = client
        yield socket
        socket.close()
        until(lambda: not (client in Client.instances and Client.instances[client].has_socket_connection))


def wait_for_text(socket, text):
    """Wait for a message that has some text."""
    for _ in range(20):
        message = socket.receive_text()
        if text in message:
            return message
    raise AssertionError(f"no {text}")


def until(condition):
    """Wait for something that comes soon."""
    end = time.monotonic() + 20.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_a_plain_request_starts_no_worker_and_makes_no_folder(browser, workers):
    for _ in range(12):
        assert browser.get("/").status_code == 200
    assert workers.ends == []
    assert list(browser.folder.iterdir()) == []


def test_a_foreign_socket_gets_nothing(browser, workers):
    for origin in ("http://evil.example", "http://127.0.0.1:3000", "null"):
        with pytest.raises(WebSocketDisconnect) as end, opened(browser, origin=origin):
            pass
        assert end.value.code == 1008
    assert workers.ends == []


def test_pages_are_counted_and_end(browser, workers):
    with contextlib.ExitStack() as pages:
        for number in range(1, MOST + 1):
            socket = pages.enter_context(opened(browser))
            wait_for_text(socket, "Contact mechanics")
            assert len(workers.alive) == number
            assert len(list(browser.folder.iterdir())) == number
        with opened(browser) as beyond:
            page_text = wait_for_text(beyond, "pages of the app are open")
            assert (
                f"{MOST} pages of the app are open, each with a process of its own, and no more are allowed"
                in page_text
            )
            assert "Contact mechanics" not in page_text
        assert len(workers.alive) == MOST
    until(lambda: not workers.alive and not list(browser.folder.iterdir()))  # folders go right after their processes


@pytest.mark.slow
def test_a_page_that_was_left_gives_its_place(browser, workers, monkeypatch):
    monkeypatch.setattr(core.app.config, "reconnect_timeout", 60.0)
    with contextlib.ExitStack() as pages:
        with opened(browser, tab="first") as first:
            wait_for_text(first, "Contact mechanics")
            mine = workers.alive[0]
        for _ in range(MOST - 1):
            wait_for_text(pages.enter_context(opened(browser)), "Contact mechanics")
        assert mine in workers.alive  # it may come back
        wait_for_text(pages.enter_context(opened(browser)), "Contact mechanics")
        assert mine not in workers.alive
        with opened(browser, tab="first", client=first.client) as back:
            wait_for_text(back, "history.go(0)")  # it is loaded again
        assert len(workers.alive) == MOST
        monkeypatch.setattr(core.app.config, "reconnect_timeout", LEFT)
    until(lambda: not workers.alive)


def test_a_tab_that_is_reloaded_has_one_worker(browser, workers, monkeypatch):
    monkeypatch.setattr(core.app.config, "reconnect_timeout", 60.0)
    for _ in range(3):
        with opened(browser, tab="one") as page:
            wait_for_text(page, "Contact mechanics")
            assert len(workers.alive) == 1
    monkeypatch.setattr(core.app.config, "reconnect_timeout", LEFT)
    with opened(browser, tab="one") as page:
        wait_for_text(page, "Contact mechanics")
    until(lambda: not workers.alive)


def test_no_process_can_be_started(browser, workers, monkeypatch):
    def refused():
        raise BlockingIOError(errno.EAGAIN, "Resource temporarily unavailable")

    monkeypatch.setattr(solver, "started", refused)
    with opened(browser) as page:
        wait_for_text(page, "gets no folder or no process (resource temporarily unavailable); close other programs")
    assert list(browser.folder.iterdir()) == []


def page_of(browser, socket):
    return browser.visitors._open[Client.instances[socket.client]].page


def test_a_process_that_ends_or_cannot_be_started_again(browser, workers, monkeypatch):
    def refused():
        raise BlockingIOError(errno.EAGAIN, "Resource temporarily unavailable")

    with opened(browser) as socket:
        wait_for_text(socket, "Contact mechanics")
        page = page_of(browser, socket)
        workers.ends[-1].close()
        wait_for_text(socket, "The process of this page ended before it was ready. Change the study to try again.")
        assert workers.alive == []
        with monkeypatch.context() as patch:
            patch.setattr(solver, "started", refused)
            for request, why in ((page.stopping.stop, "Stopped. No process"), (page.solve, "No process")):
                browser.portal.call(request)
                wait_for_text(socket, f"{why} can be started (resource temporarily unavailable); close other programs")
            assert not page.solver.starting
        browser.portal.call(page.solve)
        assert len(workers.alive) == 1
        assert workers.ends[-1].recv().number == page.solver.number
        workers.ends[-1].send((0, None))
        until(lambda: page.solver.ready)
        workers.ends[-1].close()
        wait_for_text(
            socket, "The process of this page ended, perhaps for want of memory; ask for less. Change the study"
        )
    until(lambda: not browser.visitors._open)


def test_no_thread_can_be_started(browser, workers, monkeypatch):
    def refused(self):
        raise RuntimeError("can't start new thread")

    with opened(browser) as socket:
        wait_for_text(socket, "Contact mechanics")
        page = page_of(browser, socket)
        with monkeypatch.context() as patch:
            patch.setattr(solver.threading.Thread, "start", refused)
            browser.portal.call(page.stopping.stop)
        wait_for_text(socket, "Stopped. No process can be started (can't start new thread); close other programs")
        assert workers.alive == []


def test_an_unexpected_error_is_shown(browser):
    def boom():
        raise KeyError("<b>boom</b>")

    def click(client):
        with client:
            button = ui.button("boom", on_click=boom)
        client.handle_event({"id": button.id, "listener_id": next(iter(button._event_listeners)), "args": []})

    with opened(browser) as socket:
        wait_for_text(socket, "Contact mechanics")
        browser.portal.call(click, Client.instances[socket.client])
        wait_for_text(socket, "winkler made a mistake (KeyError: '<b>boom</b>'); report it with this study.")


def upload_address(message):
    return re.search(r'"url": ?"(/_nicegui/client/[\w-]+/upload/\d+)","max', message)[1]


def test_uploads(browser, workers):
    with opened(browser) as page:
        address = upload_address(wait_for_text(page, "Contact mechanics"))
        file = {"file": ("mine.toml", b"title = 1", "text/plain")}
        assert browser.post(address, files=file).status_code == 403
        for origin in ("http://evil.example", "null", "http://127.0.0.1:80"):
            assert browser.post(address, files=file, headers={"origin": origin}).status_code == 403
        home = {"origin": HOME}
        stated = home | {"content-length": str(LARGEST + 20_000)}
        assert browser.post(address, content=b"1", headers=stated).status_code == 413
        endless = (b"1" * 10_000 for _ in range(30))
        kind = home | {"content-type": "multipart/form-data; boundary=x"}
        assert browser.post(address, content=endless, headers=kind).status_code == 413
        assert browser.post(address, files=file, headers=home).status_code == 200
    until(lambda: not workers.alive)
    assert browser.post(address, files=file, headers=home).status_code == 404


@pytest.mark.parametrize(
    "path",
    ["/nothing", "/index.html", "/docs", "/openapi.json", "/_nicegui/nothing", "/_nicegui_ws/nothing",
     f"/_nicegui/{nicegui.__version__}/static/nothing", "/_nicegui/client/1/upload/1",
     "/%2e%2e/etc/passwd", "/x//y", "/~/x"],
)  # fmt: skip
def test_unknown_paths(path, browser):
    answer = browser.get(path)
    assert answer.status_code == 404
    assert answer.headers["content-type"].startswith("text/plain")
    assert "script" not in answer.text
    assert answer.headers["content-security-policy"].startswith("default-src 'none'; ")


def test_a_worker_in_reserve_is_taken_once_and_replaced_if_it_died(monkeypatch):
    workers = Workers()
    monkeypatch.setattr(solver, "started", workers.started)
    standby = Standby()
    standby.prepare()
    standby.prepare()
    (waiting,) = workers.alive
    assert standby.take().process is waiting
    assert standby.take().process is not waiting  # a new one, as none waits
    assert len(workers.alive) == 2

    standby.prepare()
    died = workers.alive[-1]
    died.kill()
    assert standby.take().process not in (waiting, died)
    standby.prepare()
    standby.close()
    standby.close()
    assert len(workers.alive) == 3  # those that were taken


def test_a_worker_in_reserve_that_cannot_be_started_is_reported_to_the_page_that_takes_it(monkeypatch):
    def refuse():
        raise OSError(errno.EAGAIN, "no process")

    monkeypatch.setattr(solver, "started", refuse)
    standby = Standby()
    standby.prepare()
    with pytest.raises(OSError, match="no process"):
        standby.take()
