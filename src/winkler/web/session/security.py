"""Checks of requests to the app, and headers of its responses.

A browser lets a page of any site send requests to this machine.  Three headers that a page cannot forge identify such
requests: ``Host`` has the name under which the app was addressed (a foreign name that was made to point at this
machine, DNS rebinding, stands there), ``Origin`` the site whose page opens a socket or uploads, ``Sec-Fetch-Site``
whether a picture, a frame or a script is requested by another site.  Bodies are refused for their stated length before
they are read, and for their real one while they are.
"""

from __future__ import annotations

import re
import secrets
from collections.abc import Awaitable, Callable, MutableMapping
from typing import Any
from urllib.parse import urlsplit

from winkler.values.errors import InvalidInput

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

PORTS = {"http": 80, "https": 443}
"""Ports that a browser leaves out of an address."""
HEADERS = (
    (b"x-content-type-options", b"nosniff"),
    (b"x-frame-options", b"DENY"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
)
NOTHING = "default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
"""Content security policy of what is not a page of the app."""


def origin_of(address: str) -> str:
    """Return scheme, host and port of an address, as a browser writes them into ``Origin``.

    Raises
    ------
    InvalidInput
        If the address has anything else, or lacks scheme or host.

    Examples
    --------
    >>> origin_of("https://Lab.example.org:443/"), origin_of("http://localhost:9000")
    ('https://lab.example.org', 'http://localhost:9000')
    """
    try:
        parts = urlsplit(address)
        scheme, host, port = parts.scheme, parts.hostname or "", parts.port
        whole = f"{scheme}://{parts.netloc}".lower() == address.lower().removesuffix("/")
    except ValueError:
        scheme, host, port, whole = "", "", None, False
    if scheme not in PORTS or not whole or not re.fullmatch(r"[a-z0-9._-]+|[0-9a-f:]+", host) or "@" in address:
        raise InvalidInput(
            f"--address {address!r} is not the address of a page; give scheme, host and port as the browser shows "
            "them and nothing behind: https://lab.example.org or http://localhost:9000."
        )
    name = f"[{host}]" if ":" in host else host
    return f"{scheme}://{name}" if port in (None, PORTS[scheme]) else f"{scheme}://{name}:{port}"


class Security:
    """Middleware (ASGI) that refuses requests of other sites and bodies that are too large, and adds headers.

    Parameters
    ----------
    app
        The app behind the checks.
    origins
        Addresses at which the app may be opened, as `origin_of` returns them; the first one is named in refusals.
    largest
        Greatest length of a body [bytes].
    """

    def __init__(self, app: App, *, origins: tuple[str, ...], largest: int) -> None:
        self.app, self.origins, self.largest = app, frozenset(origins), largest
        self.address = origins[0]
        self.hosts = frozenset(host for origin in origins for host in _hosts(origin))

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse a request, or pass it to the app."""
        if scope["type"] == "http":
            await self._http(scope, receive, send)
        elif scope["type"] == "websocket" and self._foreign(scope):
            await receive()
            await send({"type": "websocket.close", "code": 1008, "reason": ""})
        else:
            await self.app(scope, receive, send)

    def _foreign(self, scope: Scope) -> str:
        """Return why a request is refused: one sentence, empty if it is accepted."""
        hosts, origins = _values(scope, b"host"), _values(scope, b"origin")
        if len(hosts) != 1 or hosts[0] not in self.hosts:
            return f"This app is opened at {self.address}; --address names others."
        changes = scope["type"] == "websocket" or scope["method"] not in ("GET", "HEAD")
        if len(origins) > 1 or not self.origins.issuperset(origins) or (changes and not origins):
            return f"This request does not come from a page of {self.address}."
        site, mode, goal = (_values(scope, name) for name in (b"sec-fetch-site", b"sec-fetch-mode", b"sec-fetch-dest"))
        opened = mode == ["navigate"] and goal == ["document"]
        if not opened and any(one not in ("same-origin", "none") for one in site):
            return f"This request comes from another site than {self.address}."
        return ""

    async def _http(self, scope: Scope, receive: Receive, send: Send) -> None:
        why = self._foreign(scope)
        if why:
            await _say(send, 403, why)
            return
        response = _ResponseWithHeaders(send, self._policy)
        body = _Body(receive, self.largest)
        try:
            if any(not one.isdigit() or int(one) > self.largest for one in _values(scope, b"content-length")):
                raise _TooLarge
            await self.app(scope, body.receive, response.send)
        except _TooLarge:
            if response.begun:
                raise
            await _say(send, 413, f"At most {self.largest / 1e6:.0f} MB are accepted at once.")

    def _policy(self, nonce: str) -> str:
        """Return the content security policy of a page.

        NiceGUI evaluates what the server sends it, and Vue compiles templates: without ``unsafe-eval`` the page stays
        empty.  Styles are set by the elements themselves.  Scripts within the page are known by a number used once, so
        that none is run that came in as text.
        """
        sockets = " ".join(f"ws{origin.removeprefix('http')}" for origin in sorted(self.origins))
        return (
            f"default-src 'none'; script-src 'self' 'nonce-{nonce}' 'unsafe-eval'; style-src 'self' 'unsafe-inline'; "
            f"img-src 'self' data:; font-src 'self'; connect-src 'self' {sockets}; base-uri 'none'; "
            "form-action 'none'; frame-ancestors 'none'"
        )


class _TooLarge(Exception):
    """A body is longer than allowed."""


class _Body:
    """A body that is counted while it is read."""

    def __init__(self, receive: Receive, largest: int) -> None:
        self._receive, self._left = receive, largest

    async def receive(self) -> MutableMapping[str, Any]:
        message = await self._receive()
        self._left -= len(message.get("body", b""))
        if self._left < 0:
            raise _TooLarge
        return message


class _ResponseWithHeaders:
    """A response that gets headers; the scripts in a page get the nonce that identifies them."""

    def __init__(self, send: Send, policy: Callable[[str], str]) -> None:
        self._send, self._policy = send, policy
        self._page: tuple[MutableMapping[str, Any], bytearray] | None = None
        self.begun = False

    async def send(self, message: MutableMapping[str, Any]) -> None:
        if message["type"] == "http.response.start":
            self.begun = True
            headers = [(name.lower(), value) for name, value in message.get("headers", [])]
            if any(name == b"content-type" and value.startswith(b"text/html") for name, value in headers):
                self._page = (message, bytearray())  # until its text is complete
                return
            message = _with(message, NOTHING)
        elif message["type"] == "http.response.body" and self._page:
            start, text = self._page
            text += message.get("body", b"")
            if message.get("more_body"):
                return
            nonce = secrets.token_urlsafe(16)
            page = re.sub(rb"<script(?=[\s>])", b'<script nonce="%s"' % nonce.encode(), bytes(text))
            await self._send(_with(start, self._policy(nonce), len(page)))
            message = {"type": "http.response.body", "body": page}
        await self._send(message)


def _with(start: MutableMapping[str, Any], policy: str, length: int | None = None) -> MutableMapping[str, Any]:
    """Return the start of a response with the headers of this module instead of its own."""
    ours = [*HEADERS, (b"content-security-policy", policy.encode())]
    if length is not None:
        ours.append((b"content-length", b"%d" % length))
    names = {name for name, _ in ours}
    kept = [(name, value) for name, value in start.get("headers", []) if name.lower() not in names]
    return {**start, "headers": [*kept, *ours]}


def _values(scope: Scope, name: bytes) -> list[str]:
    """Return all values of a header, in small letters."""
    return [value.decode("latin-1").strip().lower() for key, value in scope["headers"] if key.lower() == name]


def _hosts(origin: str) -> tuple[str, ...]:
    """Return what may stand in ``Host`` for an address."""
    scheme, _, host = origin.partition("://")
    return (host,) if re.search(r":\d+$", host) else (host, f"{host}:{PORTS[scheme]}")


async def _say(send: Send, status: int, sentence: str) -> None:
    """Answer with a page of one sentence, in plain text."""
    start = {"type": "http.response.start", "status": status, "headers": [(b"content-type", b"text/plain")]}
    text = f"{sentence}\n".encode()
    await send(_with(start, NOTHING, len(text)))
    await send({"type": "http.response.body", "body": text})
