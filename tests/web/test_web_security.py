"""Which requests the app answers, and what stands in the headers of its responses."""

from __future__ import annotations

import asyncio
import re

import pytest

from winkler.values.errors import InvalidInput
from winkler.web.session.security import Security, origin_of

ORIGINS = ("http://127.0.0.1:8765", "http://localhost:8765", "https://lab.example.org")
HOME = {"host": "127.0.0.1:8765", "origin": ORIGINS[0]}
TOO_LARGE = 413


class Exchange:
    """One request to a small app behind the checks, and what came back."""

    def __init__(self, method="GET", headers=None, body=(), page=b"", mimetype=b"text/html; charset=utf-8"):
        self.reached, self.read, self.sent = False, 0, []
        self.body, self.page, self.mimetype = list(body), page, mimetype
        pairs = headers.items() if isinstance(headers, dict) else headers or [("host", "127.0.0.1:8765")]
        raw = [(name.encode(), value.encode()) for name, value in pairs]
        scope = {"type": "http", "method": method, "path": "/", "headers": raw}
        if method == "WEBSOCKET":
            scope = {"type": "websocket", "path": "/", "headers": raw}
        checked = Security(self.app, origins=ORIGINS, largest=1000)
        asyncio.run(checked(scope, self.receive, self.send))

    async def receive(self):
        part = self.body.pop(0) if self.body else b""
        self.read += len(part)
        return {"type": "http.request", "body": part, "more_body": bool(self.body)}

    async def send(self, message):
        self.sent.append(message)

    async def app(self, scope, receive, send):
        self.reached = True
        while (await receive()).get("more_body"):
            pass
        headers = [(b"Content-Type", self.mimetype), (b"Content-Length", b"%d" % len(self.page))]
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        await send({"type": "http.response.body", "body": self.page[:3], "more_body": True})
        await send({"type": "http.response.body", "body": self.page[3:]})

    @property
    def status(self):
        return self.sent[0]["status"]

    @property
    def headers(self):
        return {name.decode(): value.decode() for name, value in self.sent[0]["headers"]}

    @property
    def text(self):
        return b"".join(message.get("body", b"") for message in self.sent[1:])


@pytest.mark.parametrize("host", ["127.0.0.1:8765", "LOCALHOST:8765", "lab.example.org", "lab.example.org:443"])
def test_the_app_answers_at_its_addresses(host):
    assert Exchange(headers={"host": host}).status == 200


@pytest.mark.parametrize(
    "hosts",
    [
        ["evil.example"],  # a name that was made to point at this machine
        ["evil.example:8765"],
        ["127.0.0.1"],
        ["127.0.0.1:80"],
        ["127.0.0.1:8765.evil.example"],
        ["127.0.0.1:8765@evil.example"],
        ["lab.example.org:80"],
        [""],
        [],
        ["127.0.0.1:8765", "evil.example"],
    ],
)
@pytest.mark.parametrize("method", ["GET", "WEBSOCKET"])
def test_other_hosts_are_refused(hosts, method):
    headers = [("origin", ORIGINS[0]), *(("host", host) for host in hosts)]
    exchange = Exchange(method, headers)
    assert not exchange.reached
    if method == "GET":
        assert exchange.status == 403
        assert exchange.text == b"This app is opened at http://127.0.0.1:8765; --address names others.\n"
    else:
        assert exchange.sent == [{"type": "websocket.close", "code": 1008, "reason": ""}]


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "http://127.0.0.1:3000", "https://127.0.0.1:8765", "null", "", None]
)
@pytest.mark.parametrize("method", ["WEBSOCKET", "POST", "PUT", "DELETE", "OPTIONS"])
def test_sockets_and_uploads_of_other_sites_are_refused(origin, method):
    headers = {"host": "127.0.0.1:8765"} | ({} if origin is None else {"origin": origin})
    exchange = Exchange(method, headers, body=[b"1" * 10] * (method != "WEBSOCKET"))
    assert not exchange.reached
    assert exchange.read == 0
    assert exchange.sent[0].get("code", exchange.sent[0].get("status")) in (1008, 403)
    assert Exchange(method, {"host": "127.0.0.1:8765", "origin": ORIGINS[0]}).reached


def test_behind_a_proxy_the_host_may_be_the_own_one():
    assert Exchange("POST", {"host": "127.0.0.1:8765", "origin": "https://lab.example.org"}).reached


@pytest.mark.parametrize(
    "site, mode, goal, status",
    [
        ("same-origin", "cors", "empty", 200),
        ("none", "navigate", "document", 200),
        ("cross-site", "navigate", "document", 200),  # a link
        ("cross-site", "navigate", "iframe", 403),
        ("cross-site", "no-cors", "image", 403),
        ("same-site", "cors", "empty", 403),  # another port of this machine
        ("cross-site", "no-cors", "script", 403),
    ],
)
def test_what_other_sites_may_request(site, mode, goal, status):
    headers = {"host": "localhost:8765", "sec-fetch-site": site, "sec-fetch-mode": mode, "sec-fetch-dest": goal}
    assert Exchange(headers=headers).status == status


@pytest.mark.parametrize("length", ["1001", "99999999999999999999", "-1", "1e3"])
def test_a_long_body_is_refused_before_it_is_read(length):
    exchange = Exchange("POST", HOME | {"content-length": length}, body=[b"1" * 2000])
    assert (exchange.status, exchange.reached, exchange.read) == (TOO_LARGE, False, 0)


def test_a_body_of_no_stated_length_is_counted():
    assert Exchange("POST", HOME, body=[b"1" * 100] * 10).status == 200
    exchange = Exchange("POST", HOME, body=[b"1" * 100] * 50)
    assert (exchange.status, exchange.read) == (TOO_LARGE, 1100)


def test_headers_of_a_page():
    page = b"<html><script>one()</script><SCRIPT src='/x'></script><scripture></scripture><script\ntype='module'>"
    first, second = Exchange(page=page), Exchange(page=page)
    policy = dict(part.split(" ", 1) for part in first.headers["content-security-policy"].split("; "))
    for name in ("default-src", "base-uri", "form-action", "frame-ancestors"):
        assert policy[name] == "'none'"
    assert policy["script-src"].startswith("'self' 'nonce-")
    assert "'unsafe-inline'" not in policy["script-src"]
    assert policy["connect-src"] == "'self' ws://127.0.0.1:8765 ws://localhost:8765 wss://lab.example.org"
    assert first.headers["x-content-type-options"] == "nosniff"
    assert first.headers["x-frame-options"] == "DENY"
    assert first.headers["referrer-policy"] == "no-referrer"
    assert int(first.headers["content-length"]) == len(first.text)
    numbers = re.findall(rb' nonce="([\w-]+)"', first.text)
    assert len(numbers) == 2
    assert set(numbers) == {re.search(r"'nonce-([\w-]+)'", policy["script-src"])[1].encode()}
    assert first.headers["content-security-policy"] != second.headers["content-security-policy"]


def test_what_is_no_page_may_load_nothing():
    exchange = Exchange(page=b"<script>", mimetype=b"image/svg+xml")
    assert exchange.text == b"<script>"
    assert exchange.headers["content-security-policy"].startswith("default-src 'none'; ")
    assert exchange.headers["x-content-type-options"] == "nosniff"
    refused = Exchange(headers={"host": "evil.example"})
    assert set(exchange.headers) - {"Content-Type", "Content-Length"} <= set(refused.headers)


@pytest.mark.parametrize(
    "address, origin",
    [
        ("http://localhost:9000", "http://localhost:9000"),
        ("HTTPS://Lab.Example.org/", "https://lab.example.org"),
        ("http://[::1]:9000", "http://[::1]:9000"),
        ("http://10.0.0.7:80", "http://10.0.0.7"),
        ("https://10.0.0.7:80", "https://10.0.0.7:80"),
    ],
)
def test_addresses(address, origin):
    assert origin_of(address) == origin


@pytest.mark.parametrize(
    "address",
    ["", "*", "localhost:9000", "http://", "http://a b", "http://a/x", "http://u@a", "ftp://a", "http://a:x", "http://*",
     "http://a:99999", "http://a?b", "http://a#b", "http://[::1", "http://a,b", "http://a;b"],
)  # fmt: skip
def test_what_is_no_address(address):
    with pytest.raises(InvalidInput, match="give scheme, host and port"):
        origin_of(address)
