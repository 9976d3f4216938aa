"""Visits the studio's page in Chromium: visit.py BROWSER FOLDER SHOTS [--hostile].

FOLDER has the page in its folder `page`. Screenshots are written to SHOTS. Fails if the page writes an error to the console. Some hostile
texts and files are opened, too; with `--hostile` all of them, and nothing else.
"""

import base64
import fcntl
import functools
import http.server
import json
import os
import select
import subprocess
import sys
import tempfile
import threading
import time
import urllib.parse
from pathlib import Path

import hostile

# The text of a mechanism that somebody shares.
SHARED = """struct Shared;
link crank; link coupler; link rocker;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, coupler) at (0, 1);
joint c = revolute(coupler, rocker) at (3, 2);
joint d = revolute(rocker, ground) at (3, 0);
motor a;
"""

# How long a page may take on a busy machine, in seconds. There is no graphics hardware either.
PATIENCE = 120


class Browser:
    """Chromium, which is told what to do over two pipes: one JSON text after the other, with a zero byte between."""

    def __init__(self, program, profile):
        from_us, self.to_browser = os.pipe()
        self.from_browser, to_us = os.pipe()

        def connect():
            # The browser reads from 3 and writes to 4. Neither end may be lost while the other is put there.
            ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (from_us, to_us)]
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        flags = (
            "--headless=new --remote-debugging-pipe --no-sandbox --use-gl=angle --use-angle=swiftshader "
            "--enable-unsafe-swiftshader --no-first-run --disable-dev-shm-usage --window-size=1280,800 "
            # Nothing is asked of other hosts: where there is no network, the browser would go on trying.
            "--disable-background-networking --disable-component-update --disable-sync --disable-quic"
        )
        with open(Path(profile, "log"), "w", encoding="utf-8") as log:
            self.process = subprocess.Popen(
                [program, *flags.split(), f"--user-data-dir={profile}", "about:blank"],
                preexec_fn=connect,
                close_fds=False,
                stdout=log,
                stderr=log,
            )
        os.close(from_us)
        os.close(to_us)
        self.waiting = b""
        self.number = 0
        self.events = []

    def hear(self, seconds):
        """The next that the browser says; none if it says nothing for so long."""
        end = time.monotonic() + seconds
        while b"\0" not in self.waiting:
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.from_browser], [], [], left)[0]:
                return None
            read = os.read(self.from_browser, 1 << 20)
            if not read:
                raise SystemExit("error: the browser ends")
            self.waiting += read
        message, self.waiting = self.waiting.split(b"\0", 1)
        return json.loads(message)

    def say(self, method, session=None, **parameters):
        """Tells the browser something, and gives its answer. What happens meanwhile is kept."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        while True:
            heard = self.hear(PATIENCE)
            if heard is None:
                raise SystemExit(f"error: the browser does not answer {method}")
            if heard.get("id") == self.number:
                if "error" in heard:
                    raise SystemExit(f"error: {method}: {heard['error']}")
                return heard["result"]
            self.events.append(heard)


class Visit:
    """One page, in a tab of its own."""

    def __init__(self, browser, address):
        self.browser, self.address = browser, address
        self.target = browser.say("Target.createTarget", url="about:blank")["targetId"]
        attached = browser.say("Target.attachToTarget", targetId=self.target, flatten=True)
        self.session = attached["sessionId"]
        for domain in "Runtime", "Log", "Page":
            self.say(f"{domain}.enable")
        self.begun = time.monotonic()
        self.say("Page.navigate", url=address)

    def say(self, method, **parameters):
        return self.browser.say(method, self.session, **parameters)

    def value(self, expression):
        return self.say("Runtime.evaluate", expression=expression)["result"].get("value")

    def complaints(self):
        """The errors that the page has written to the console."""
        found = []
        for event in self.browser.events:
            if event.get("sessionId") != self.session:
                continue
            what = event["params"]
            if event["method"] == "Runtime.exceptionThrown":
                found.append(what["exceptionDetails"])
            elif event["method"] == "Runtime.consoleAPICalled" and what["type"] in ("error", "assert"):
                found.append(what["args"])
            elif event["method"] == "Log.entryAdded" and what["entry"]["level"] == "error":
                found.append(what["entry"])
        return found

    def until(self, expression, what):
        """Waits until this is so, and gives the seconds since the page was called."""
        while not self.value(expression):
            if self.complaints() or time.monotonic() - self.begun > PATIENCE:
                self.fail(what)
            time.sleep(0.05)
        return time.monotonic() - self.begun

    def until_ready(self):
        return self.until("document.body?.dataset.ready === '1'", "no mechanism is seen")

    def fail(self, what):
        told = self.value("document.querySelector('#told')?.textContent")
        for complaint in self.complaints():
            print(json.dumps(complaint, indent=1)[:4000], file=sys.stderr)
        raise SystemExit(f"error: {self.address[:200]}: {what}; the page tells {told!r}")

    def press(self, key, code, number, control=False):
        key = {"key": key, "code": code, "windowsVirtualKeyCode": number, "modifiers": 2 * control}
        text = {} if control else {"text": key["key"]}
        self.say("Input.dispatchKeyEvent", type="keyDown", **text, **key)
        self.say("Input.dispatchKeyEvent", type="keyUp", **key)

    def choose(self, path):
        """Chooses a file where the page asks for one."""
        root = self.say("DOM.getDocument")["root"]["nodeId"]
        chooser = self.say("DOM.querySelector", nodeId=root, selector="#file")["nodeId"]
        self.say("DOM.setFileInputFiles", nodeId=chooser, files=[str(path)])
        time.sleep(1)

    def shoot(self, path):
        picture = self.say("Page.captureScreenshot", format="png")["data"]
        Path(path).write_bytes(base64.b64decode(picture))

    def end(self, may_complain=False):
        if self.complaints() and not may_complain:
            self.fail("it complains")
        self.browser.say("Target.closeTarget", targetId=self.target)


class Server(http.server.SimpleHTTPRequestHandler):
    """A server of files that does not tell each of them."""

    def log_message(self, *_):
        pass


def visit_all(browser, site, folder, shots):
    # One that has everything: it does not move until somebody says so.
    visit = Visit(browser, f"{site}?file=four_bar.rs")
    seconds = visit.until_ready()
    time.sleep(0.5)
    visit.shoot(shots / "exhibit.png")
    time.sleep(0.5)
    visit.shoot(shots / "still.png")
    visit.press(" ", "Space", 32)
    time.sleep(1)
    visit.shoot(shots / "playing.png")
    visit.end()
    print(f"the page is ready after {seconds:.1f} s")

    for file in sorted(Path(folder, "page/mechanisms").iterdir()):
        visit = Visit(browser, f"{site}?file={file.name}")
        seconds = visit.until_ready()
        visit.shoot(shots / f"{file.stem}.png")
        visit.end()
        print(f"  {file.name} {seconds:.1f} s")

    for name, address in ("nothing", site), ("shared", f"{site}#text={urllib.parse.quote(SHARED)}"):
        visit = Visit(browser, address)
        visit.until_ready()
        visit.shoot(shots / f"{name}.png")
        visit.end()

    # Somebody chooses a mechanism, and then a picture to be traced.
    visit = Visit(browser, site)
    visit.until_ready()
    visit.choose(Path(folder, "page/mechanisms/watt.rs").resolve())
    visit.shoot(shots / "chosen.png")
    visit.choose((shots / "exhibit.png").resolve())
    visit.shoot(shots / "traced.png")
    visit.end()

    # What is not there is told, instead of an empty window.
    visit = Visit(browser, f"{site}?file=nobody.rs")
    told = "document.querySelector('#told')?.textContent"
    while "nobody.rs" not in (visit.value(told) or ""):
        if time.monotonic() - visit.begun > PATIENCE:
            visit.fail("a mechanism that is not there is not told")
        time.sleep(0.05)
    visit.shoot(shots / "missing.png")
    visit.end(may_complain=True)


# The longest time for which the page may not answer, in seconds, on a machine that has nothing else to do; and on a busy one.
PROMPT, LATE = 2, 30

# The hostile texts that are opened each time.
SOME = ("brackets 20000", "semicolons 200000", "digits 200000", "empty links 3000", "scissors 10", "legs 1000", "legs 4294967295")


class Attack:
    """A hostile text or file in a page of its own: how long the page did not answer, and what became of it."""

    def __init__(self, browser, name, address, file=None):
        self.visit, self.name = Visit(browser, address), name
        # The studio is seen, or the page tells why not.
        begun = "(told => told && (told.textContent ? !told.textContent.includes('loading') : !studio.hidden))(document.querySelector('#told'))"
        self.visit.until(begun, "it does not start")
        self.slowest = 0
        if file:
            self.visit.choose(file)

    def value(self, expression):
        begun = time.monotonic()
        value = self.visit.value(expression)
        self.slowest = max(self.slowest, time.monotonic() - begun)
        return value

    def work(self):
        return self.value("document.body.dataset.work ?? ''")

    def told(self):
        return self.value("document.querySelector('#told').textContent")

    def rests(self, seconds):
        """Waits until nothing is done for a while. Returns whether that came about in time."""
        end, since = time.monotonic() + seconds, None
        while time.monotonic() < end:
            since = None if self.work() else since or time.monotonic()
            if since and time.monotonic() - since > 0.6:
                return True
            time.sleep(0.05)
        return False

    def run(self):
        """Returns what became of it, in a word."""
        if self.told():
            return "told"
        if self.rests(2.6):
            return "answered"
        self.visit.press(".", "Period", 190, control=True)
        if not self.rests(LATE):
            self.visit.fail(f"{self.name}: {self.work()!r} cannot be stopped")
        return "stopped"

    def end(self):
        outcome = self.run()
        told = self.told()
        if "broke" in told:
            self.visit.fail(f"{self.name}: the studio broke")
        self.visit.end(may_complain=bool(told))
        if self.slowest > LATE:
            raise SystemExit(f"error: {self.name}: the page does not answer for {self.slowest:.1f} s")
        return outcome


def attack_all(browser, site, folder, is_whole):
    slow, count, outcomes = [], 0, {}

    def attack(name, address, file=None):
        nonlocal count
        one = Attack(browser, name, address, file)
        outcome = one.end()
        count += 1
        outcomes[outcome] = outcomes.get(outcome, 0) + 1
        if one.slowest > PROMPT:
            slow.append(name)
        print(f"  {name}: {outcome}, the page answers within {one.slowest:.2f} s", flush=True)

    for name, text in hostile.texts():
        if is_whole or name in SOME:
            attack(name, f"{site}#text={urllib.parse.quote(text)}")
    for name, content in hostile.files():
        if is_whole or name == "slashes.mech":
            path = Path(folder, name)
            path.write_bytes(content)
            attack(name, site, path)
    for name, written in ("half an escape", "%2"), ("no escape", "%zz"), ("no UTF-8", "%ff%fe"):
        attack(name, f"{site}#text={written}")
    prompt = count - len(slow)
    print(f"hostile: {prompt} of {count} answered or stopped with the page never silent for {PROMPT} s {outcomes} {slow}")


def reload_asks(browser, site):
    """What was typed just before the page is loaded anew is not lost: the browser asks."""
    visit = Visit(browser, site)
    visit.until_ready()
    visit.press("l", "KeyL", 76)
    visit.say("Runtime.evaluate", expression="setTimeout(() => location.reload(), 0)")
    end = time.monotonic() + PATIENCE
    while not any(event["method"] == "Page.javascriptDialogOpening" for event in visit.browser.events):
        if time.monotonic() > end:
            visit.fail("it is loaded anew without a question")
        visit.browser.events.extend(filter(None, [visit.browser.hear(0.2)]))
    visit.say("Page.handleJavaScriptDialog", accept=True)
    visit.end()


def main():
    program, folder, shots, *options = sys.argv[1:]
    is_whole = options == ["--hostile"]
    handler = functools.partial(Server, directory=folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        site = f"http://127.0.0.1:{server.server_port}/page/index.html"
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
            browser = Browser(program, profile)
            try:
                if not is_whole:
                    visit_all(browser, site, folder, Path(shots))
                    reload_asks(browser, site)
                with tempfile.TemporaryDirectory() as files:
                    attack_all(browser, site, files, is_whole)
            finally:
                browser.process.terminate()
                browser.process.wait()
        server.shutdown()


main()
