"""The page outside the browser: from a server, in a file, in a notebook; and without the page."""

from __future__ import annotations

import gzip
import http.client
import json
import re
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from html import unescape
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import carom
import pytest
from carom import PageError, Shot, notebook, page, serve

if TYPE_CHECKING:
    from pathlib import Path

    from conftest import CommandLine

needs_page = pytest.mark.skipif(not page.is_built(), reason="needs the page: run `make page`")
# A minimal page; these tests check what is put into it.
SMALL = f"<!doctype html><title>carom</title>{page.MARKER}</script><p>&amp;</p>"


def document_of(text: str) -> Any:
    """The document of a page, as the page's script reads it."""
    content = text.split(page.MARKER)[1].split("</script>", maxsplit=1)[0]
    return json.loads(content) if content else None


@pytest.fixture
def small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A small page in place of the built one, which may be missing."""
    path = tmp_path / "index.html"
    path.write_text(SMALL)
    monkeypatch.setattr(page, "path", lambda: path)


@pytest.fixture
def missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An installation without the page."""
    monkeypatch.setattr(page, "path", lambda: tmp_path / "nowhere.html")


@needs_page
def test_the_built_page_contains_the_document(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    assert document_of(page.html()) is None
    assert document_of(page.html(shot)) == shot.to_dict()
    trace = shot.simulate()
    assert document_of(page.html(trace)) == trace.to_dict()
    assert "<title>a pot · carom</title>" in page.html(title="a pot")


@needs_page
def test_the_built_page_loads_nothing_from_elsewhere() -> None:
    text = page.html()
    assert not re.search(r"<(script|link|img|iframe)[^>]* (src|href)=[\"'](?!data:)", text)


@pytest.mark.usefixtures("small")
def test_ids_and_titles_with_markup_are_escaped(pot: dict[str, Any]) -> None:
    pot["balls"][1]["id"] = "</script><!--<script>&quot;"
    shot = Shot.from_dict(pot)
    text = page.html(shot, title="</title><b>")
    assert document_of(text) == shot.to_dict()
    assert text.count("</script>") == 1
    assert "<title>&lt;/title&gt;&lt;b&gt; · carom</title>" in text


@pytest.mark.usefixtures("small")
def test_a_notebook_has_the_page_in_a_sandbox(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    for thing in (shot, shot.simulate()):
        text = thing._repr_html_()
        assert text is not None
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', text))
        assert unescape(attributes["srcdoc"]) == page.html(thing)
        # With its parent's origin the page could change the notebook.
        assert "allow-scripts" in attributes["sandbox"]
        assert "same-origin" not in attributes["sandbox"]


@pytest.mark.usefixtures("small")
def test_show_displays_the_viewer_in_a_notebook(
    pot: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    shown: list[str] = []
    display = SimpleNamespace(HTML=str, display=shown.append)
    monkeypatch.setattr(notebook, "_carrier", None)
    shell = SimpleNamespace(kernel=None)
    ipython = SimpleNamespace(get_ipython=lambda: shell, display=display, version_info=(9, 0))
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    Shot.from_dict(pot).simulate().show(height=300)
    Shot.from_dict(pot).show()
    assert ['height="300"' in text for text in shown] == [True, False]
    assert all(text.startswith("<div data-carom-page=") for text in shown)


@pytest.mark.usefixtures("small")
def test_show_serves_the_page_outside_a_notebook(
    pot: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    served: list[str] = []
    monkeypatch.setattr(serve, "serve", lambda text, **_: served.append(text))
    trace = Shot.from_dict(pot).simulate()
    trace.show()
    assert served == [page.html(trace)]


@pytest.mark.usefixtures("missing")
def test_without_the_page_a_notebook_shows_the_picture(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    for thing in (shot, shot.simulate(), carom.Frame("nine-ball")):
        text = thing._repr_html_()
        assert text.startswith('<img src="data:image/png;base64,')
        assert "<script" not in text


@pytest.mark.usefixtures("missing")
def test_without_the_page_the_error_says_how_to_build_it(pot: dict[str, Any]) -> None:
    for ask in (page.html, Shot.from_dict(pot).show, Shot.from_dict(pot).simulate().show):
        with pytest.raises(PageError, match=r"not built .*`make page`.* Node"):
            ask()


@pytest.mark.usefixtures("small")
def test_arguments_of_a_wrong_type_are_refused_by_name(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    wrong: Any = 5
    with pytest.raises(carom.InputError, match=r"^document: found a int; give"):
        page.html(wrong)
    with pytest.raises(carom.InputError, match=r"^title: "):
        page.html(shot, title=wrong)
    for height in (0, -5, 1.5, float("nan"), 10**9, "tall"):
        with pytest.raises(carom.InputError, match=r"^height: .*from 1 to 1000000"):
            page.iframe(shot, height=height)  # type: ignore[arg-type]


def test_the_old_name_of_iframe_still_works() -> None:
    with pytest.warns(FutureWarning, match=r"carom\.page\.frame\(\) is now carom\.page\.iframe"):
        old: Any = page.frame
    assert old is page.iframe


def test_a_file_that_is_not_the_page_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, pot: dict[str, Any]
) -> None:
    path = tmp_path / "index.html"
    path.write_text("<!doctype html>")
    monkeypatch.setattr(page, "path", lambda: path)
    with pytest.raises(PageError, match=r"make page"):
        page.html(Shot.from_dict(pot))


@contextmanager
def served(text: str) -> Iterator[serve.PageServer]:
    with serve.PageServer(text, beside=page.beside()) as server:
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        yield server
        server.shutdown()
        thread.join()


def ask(
    server: serve.PageServer, method: str, path: str, **headers: str
) -> tuple[http.client.HTTPResponse, bytes]:
    connection = http.client.HTTPConnection(serve.HOST, server.server_port, timeout=10)
    connection.request(method, path, headers=headers)
    response = connection.getresponse()
    body = response.read()
    connection.close()
    return response, body


def test_the_server_has_one_page_and_compresses_it_on_request() -> None:
    text = "<p>ω</p>" * 1000
    with served(text) as server:
        plain, body = ask(server, "GET", "/")
        assert plain.status == 200
        assert body.decode() == text
        assert plain.headers["Content-Type"] == "text/html; charset=utf-8"
        assert plain.headers["Cache-Control"] == "no-store"
        packed, body = ask(server, "GET", "/?x", **{"Accept-Encoding": "br, gzip"})
        assert packed.headers["Content-Encoding"] == "gzip"
        assert len(body) < len(text) / 10
        assert gzip.decompress(body).decode() == text
        assert ask(server, "GET", "/etc/passwd")[0].status == 404
        assert ask(server, "GET", "/..")[0].status == 404
        assert ask(server, "POST", "/")[0].status == 501
        # A checker of links asks for the headers alone.
        for path in ("/", "/manifest.webmanifest"):
            whole, _ = ask(server, "GET", path)
            headers, body = ask(server, "HEAD", path)
            assert (headers.status, body) == (200, b"")
            assert headers.headers["Content-Length"] == whole.headers["Content-Length"]


def test_the_server_has_what_makes_the_page_installable() -> None:
    with served("") as server:
        manifest, body = ask(server, "GET", "/manifest.webmanifest")
        assert manifest.headers["Content-Type"] == "application/manifest+json"
        icons = {icon["src"] for icon in json.loads(body)["icons"]}
        assert icons
        for icon in icons:
            picture, body = ask(server, "GET", f"/{icon}")
            assert picture.headers["Content-Type"] == "image/png"
            assert body.startswith(b"\x89PNG")
        worker, body = ask(server, "GET", "/service-worker.js")
        assert worker.headers["Content-Type"].startswith("text/javascript")
        assert b"fetch" in body


def test_a_closed_connection_is_ignored_and_a_bug_is_reported(
    capsys: pytest.CaptureFixture[str],
) -> None:
    def said_after(error: Exception) -> str:
        with serve.PageServer("") as server:
            try:
                raise error
            except type(error):
                server.handle_error(None, (serve.HOST, 1))
        return capsys.readouterr().err

    assert said_after(ConnectionResetError()) == ""
    assert said_after(BrokenPipeError()) == ""
    assert "a wheel came off" in said_after(RuntimeError("a wheel came off"))


def raw(server: serve.PageServer, request: str) -> bytes:
    """The whole answer to a request as it is written; PORT is the server's port."""
    text = request.replace("PORT", str(server.server_port)).replace("\n", "\r\n") + "\r\n\r\n"
    with socket.create_connection((serve.HOST, server.server_port), timeout=10) as browser:
        browser.sendall(text.encode("latin-1"))
        browser.shutdown(socket.SHUT_WR)
        return b"".join(iter(lambda: browser.recv(1 << 16), b""))


@pytest.mark.parametrize("path", ["/", "/manifest.webmanifest"])
@pytest.mark.parametrize(
    "host",
    [
        "",
        "\nHost:",
        "\nHost: strange.example:PORT",
        "\nHost: strange.example",
        "\nHost: 127.0.0.1",
        "\nHost: localhost:1",
        "\nHost: 127.0.0.1:PORT.strange.example",
        "\nHost: 127.0.0.1.strange.example:PORT",
        "\nHost: localhost.:PORT",
        "\nHost: 0.0.0.0:PORT",
        "\nHost: strange.example@127.0.0.1:PORT",
        "\nHost: 127.0.0.1:PORT\nHost: strange.example:PORT",
        "\nHost: strange.example:PORT\nHost: 127.0.0.1:PORT",
        "\nX-Forwarded-Host: 127.0.0.1:PORT\nHost: strange.example:PORT",
    ],
)
def test_a_strange_host_does_not_get_the_page(host: str, path: str) -> None:
    # A domain of a stranger that resolves to 127.0.0.1 read the user's shot (DNS rebinding).
    with served("the shot of the user") as server:
        for version in ("HTTP/1.1", "HTTP/1.0"):
            answer = raw(server, f"GET {path} {version}{host}")
            assert answer.startswith(b"HTTP/1.1 403 The page is only at http://127.0.0.1:")
            assert b"the shot" not in answer
            assert b"icons" not in answer
            head = raw(server, f"HEAD {path} {version}{host}")
            assert head.startswith(b"HTTP/1.1 403 ")
            assert head.endswith(b"\r\n\r\n")
            assert head.count(b"\r\n\r\n") == 1
        absolute = raw(server, f"GET http://127.0.0.1:PORT{path} HTTP/1.1{host}")
        assert absolute.startswith(b"HTTP/1.1 403 ")
        assert b"the shot" not in raw(server, f"GET {path}")


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost", "LocalHost", "[::1]"])
def test_this_machine_gets_the_page_by_each_of_its_names(name: str) -> None:
    with served("the shot of the user") as server:
        answer = raw(server, f"GET / HTTP/1.1\nHost: {name}:PORT")
        assert answer.startswith(b"HTTP/1.1 200 OK")
        assert answer.endswith(b"\r\n\r\nthe shot of the user")
        head = raw(server, f"HEAD / HTTP/1.1\nHost: {name}:PORT")
        assert head.startswith(b"HTTP/1.1 200 OK")
        assert head.endswith(b"\r\n\r\n")


def test_port_80_may_be_omitted_and_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    with serve.PageServer("") as server:
        assert "localhost" not in server.hosts
        monkeypatch.setattr(server, "server_port", 80)
        assert {"localhost", "localhost:80", "[::1]", "127.0.0.1"} < server.hosts


def test_the_server_accepts_this_machine_only() -> None:
    with serve.PageServer("") as server:
        assert server.server_address[0] == "127.0.0.1"


def test_a_port_in_use_is_refused_with_a_remedy() -> None:
    with (
        serve.PageServer("") as server,
        pytest.raises(carom.InputError, match=rf"--port: {server.server_port} .*free one"),
    ):
        serve.PageServer("", server.server_port)


def test_the_usual_port_is_the_same_at_every_start_unless_it_is_in_use(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Seen: each start had another port, so the browser began with an empty progress."""
    with socket.create_server((serve.HOST, 0)) as free:
        port = free.getsockname()[1]
    monkeypatch.setattr(serve, "PORT", port)
    for _ in range(2):
        with serve._server("", None, beside=None, kept=False) as server:
            assert server.server_port == port
            with serve._server("", None, beside=None, kept=False) as other:
                assert other.server_port != port


@pytest.mark.parametrize(("kept", "control"), [(True, "no-cache"), (False, "no-store")])
def test_only_a_page_without_a_shot_may_be_kept(kept: bool, control: str) -> None:
    with serve.PageServer("", kept=kept) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        assert ask(server, "GET", "/")[0].headers["Cache-Control"] == control
        server.shutdown()


@contextmanager
def playing(*arguments: str, stdin: str = "") -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """The port that ``carom play`` prints, and its process."""
    with subprocess.Popen(
        [sys.executable, "-m", "carom", "play", "--no-browser", *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        process.stdin.write(stdin)
        process.stdin.close()
        process.stdin = None
        try:
            line = process.stderr.readline()
            address = re.search(r"http://127\.0\.0\.1:(\d+)/", line)
            assert address, line
            yield address[1], process
        finally:
            process.kill()


def get(port: str) -> str:
    connection = http.client.HTTPConnection("127.0.0.1", int(port), timeout=10)
    connection.request("GET", "/")
    text = connection.getresponse().read().decode()
    connection.close()
    return text


@needs_page
def test_play_serves_a_shot_or_a_trace_and_ends_quietly_on_ctrl_c(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    for thing in (shot, shot.simulate()):
        with playing("-", stdin=thing.to_json()) as (port, process):
            assert document_of(get(port)) == thing.to_dict()
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=10)
            assert (process.returncode, out, err) == (0, "", "")


@needs_page
def test_play_continues_when_a_browser_closes_the_connection() -> None:
    with playing() as (port, process):
        for _ in range(3):
            with socket.create_connection((serve.HOST, int(port)), timeout=10) as browser:
                browser.sendall(b"GET / HTTP/1.1\r\nHost: here\r\n\r\n")
        # The server handles this request after those.
        assert document_of(get(port)) is None
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=10)
        assert (process.returncode, err) == (0, "")


@needs_page
def test_play_without_a_file_serves_the_page_without_a_document() -> None:
    with playing() as (port, _):
        assert document_of(get(port)) is None


@needs_page
def test_play_refuses_bad_input_before_it_serves(run: CommandLine, pot: dict[str, Any]) -> None:
    pot["balls"][1]["position"] = [9.0, 9.0]
    trace = {"format": "carom-trace/1"}
    for text, words in [
        (json.dumps(pot), "balls[1].position"),
        ("{", "JSON"),
        (json.dumps(trace), "shot"),
        ("[]", "object"),
    ]:
        done = run("play", "-", "--no-browser", stdin=text)
        assert (done.returncode, done.stdout) == (2, ""), text
        assert len(done.stderr.splitlines()) == 1
        assert words in done.stderr
    assert run("play", "nowhere.json").returncode == 2
    assert run("play", "--port", "70000").returncode == 2


@needs_page
def test_html_writes_a_page_that_contains_the_trace(
    run: CommandLine, pot: dict[str, Any], tmp_path: Path
) -> None:
    done = run("shot", "-", "--html", "out.html", "--json", stdin=json.dumps(pot))
    assert (done.returncode, done.stderr) == (0, "")
    text = (tmp_path / "out.html").read_text()
    assert document_of(text) == json.loads(done.stdout)
    assert [p.name for p in tmp_path.iterdir()] == ["out.html"]


def test_an_installation_without_the_page_reports_it_and_writes_no_file(tmp_path: Path) -> None:
    program = (
        "import sys, pathlib, carom.page\n"
        "carom.page.path = lambda: pathlib.Path('nowhere.html')\n"
        "from carom.cli import main\n"
        "main()\n"
    )
    shot = tmp_path / "shot.json"
    shot.write_text(carom.break_shot("nine-ball").to_json())
    for arguments in (
        ["play"],
        ["shot", str(shot), "--html", "out.html", "--svg", "out.svg"],
    ):
        done = subprocess.run(
            [sys.executable, "-c", program, *arguments],
            capture_output=True,
            text=True,
            cwd=tmp_path,
            check=False,
        )
        assert (done.returncode, done.stdout) == (2, "")
        assert re.fullmatch(r"carom: the page is not built .*`make page`.*\n", done.stderr)
    assert [p.name for p in tmp_path.iterdir()] == ["shot.json"]
