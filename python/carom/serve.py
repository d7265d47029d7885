"""A server of the page for ``carom play``, at this machine's own address."""

from __future__ import annotations

import contextlib
import gzip
import sys
import threading
import webbrowser
from collections.abc import Mapping
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from carom.errors import InputError

HOST = "127.0.0.1"
# The usual port. A browser keeps progress and settings separately for each address, so a new port
# at each start would lose them. The number has no other common use.
PORT = 8737

# Seconds that an idle connection may keep others waiting, where each has no thread of its own.
PATIENCE = 0.2

# Types of the files beside the page.
TYPES = {
    ".js": "text/javascript; charset=utf-8",
    ".png": "image/png",
    ".webmanifest": "application/manifest+json",
}


class PageServer(ThreadingHTTPServer):
    """Serves one page, to this machine only.

    Args:
        page: The HTML.
        port: The port; 0 chooses a free one.
        beside: The files beside the page by name, such as its icons.
        kept: Whether a browser may keep the page for use without a network.

    Raises:
        InputError: The port cannot be used.
    """

    daemon_threads = True

    def __init__(
        self,
        page: str,
        port: int = 0,
        *,
        beside: Mapping[str, bytes] | None = None,
        kept: bool = False,
    ) -> None:
        self.beside = dict(beside or {})
        self.cache_control = "no-cache" if kept else "no-store"
        self.plain = page.encode()
        self.packed = gzip.compress(self.plain, compresslevel=6)
        try:
            super().__init__((HOST, port), _Handler)
        except OSError as error:
            raise InputError(
                "system",
                "--port",
                f"{port} cannot be used ({error.strerror})",
                "choose another, or leave the option out for a free one",
            ) from None

    def process_request(self, request: Any, client_address: Any) -> None:
        """Answer in a thread of its own, or here if the system refuses one."""
        try:
            super().process_request(request, client_address)
        except RuntimeError:
            # The next request waits for the end of this connection.
            request.settimeout(PATIENCE)
            self.process_request_thread(request, client_address)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Ignore a browser that closes the connection early, for example on a reload."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)

    @property
    def hosts(self) -> set[str]:
        """What a browser may call this server: nothing that a stranger's domain can lead here."""
        names = ("127.0.0.1", "[::1]", "localhost")
        # Browsers omit port 80.
        without = set(names) if self.server_port == 80 else set()
        return without | {f"{name}:{self.server_port}" for name in names}

    @property
    def address(self) -> str:
        """The address to open in a browser."""
        return f"http://{HOST}:{self.server_port}/"


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    protocol_version = "HTTP/1.1"
    server_version = "carom"

    def do_HEAD(self) -> None:
        self.do_GET()

    def do_GET(self) -> None:
        if not self._is_called_here():
            self.send_error(HTTPStatus.FORBIDDEN, f"The page is only at {self.server.address}")
            return
        name = self.path.partition("?")[0].removeprefix("/")
        if name in self.server.beside:
            self._send_beside(name)
            return
        if name != "":
            self.send_error(HTTPStatus.NOT_FOUND, "The only page is /")
            return
        packed = "gzip" in self.headers.get("Accept-Encoding", "")
        body = self.server.packed if packed else self.server.plain
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.send_header("Content-Length", str(len(body)))
        if packed:
            self.send_header("Content-Encoding", "gzip")
        self.send_header("Vary", "Accept-Encoding")
        # The next `carom play` may serve another shot at the same port.
        self.send_header("Cache-Control", self.server.cache_control)
        self.send_header("X-Content-Type-Options", "nosniff")
        self.end_headers()
        self._write(body)

    def _is_called_here(self) -> bool:
        """Whether the browser's page is of this machine.

        A domain of a stranger may resolve to this address, and its page then read ours (DNS
        rebinding). The browser still names that domain.
        """
        hosts = self.headers.get_all("Host", [])
        return len(hosts) == 1 and hosts[0].strip().lower() in self.server.hosts

    def _send_beside(self, name: str) -> None:
        body = self.server.beside[name]
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", TYPES[Path(name).suffix])
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Cache-Control", "no-cache")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.end_headers()
        self._write(body)

    def _write(self, body: bytes) -> None:
        """Write the body, unless only the headers are asked for."""
        if self.command != "HEAD":
            self.wfile.write(body)

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 -- the base class's name
        """Print nothing to the terminal."""


def serve(
    page: str,
    *,
    port: int | None = None,
    browser: bool = True,
    beside: Mapping[str, bytes] | None = None,
    kept: bool = False,
) -> None:
    """Serve ``page`` until Ctrl-C, and open it in the browser.

    Args:
        page: The HTML.
        port: The port; 0 chooses a free one; None takes the usual one, or a free one if that is
            in use.
        browser: Whether to open a browser.
        beside: The files beside the page by name, such as its icons.
        kept: Whether a browser may keep the page for use without a network.

    Raises:
        InputError: The port cannot be used.
    """
    with _server(page, port, beside=beside, kept=kept) as server:
        sys.stderr.write(f"carom: {server.address} (Ctrl-C ends)\n")
        sys.stderr.flush()
        if browser:
            # In a thread, because some browsers return only when they are closed. Where the system
            # refuses one, the address on stderr must do.
            with contextlib.suppress(RuntimeError):
                threading.Thread(target=webbrowser.open, args=[server.address], daemon=True).start()
        with contextlib.suppress(KeyboardInterrupt):
            server.serve_forever()


def _server(
    page: str, port: int | None, *, beside: Mapping[str, bytes] | None, kept: bool
) -> PageServer:
    if port is not None:
        return PageServer(page, port, beside=beside, kept=kept)
    try:
        return PageServer(page, PORT, beside=beside, kept=kept)
    except InputError:
        return PageServer(page, beside=beside, kept=kept)
