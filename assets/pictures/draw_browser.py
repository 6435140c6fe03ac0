#!/usr/bin/env python3
"""The pictures of the page in a browser: draw_browser.py PROGRAM RUN FOLDER.

RUN is the folder of a run of the demo, which one picture walks through.
"""

import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests/support"))
from web_driver import Browser  # noqa: E402

PROGRAM, RUN, FOLDER = (Path(argument).resolve() for argument in sys.argv[1:])


class Page:
    """The page of a server of its own."""

    def __init__(self, shown, width, height):
        self.work = tempfile.TemporaryDirectory(prefix="quicksand_pages_")
        self.server = subprocess.Popen([PROGRAM, "serve", shown, "--port", "0"], cwd=self.work.name,
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.browser = Browser(width, height)
        self.browser.open(self.server.stdout.readline().strip())
        self.browser.wait("window.quicksand && quicksand.frame() && quicksand.state()?.loaded")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.close()
        self.server.send_signal(signal.SIGINT)
        self.server.wait(timeout=20)
        self.work.cleanup()

    def command(self, name, **values):
        self.browser.run("window.answer = null; quicksand.connection.command(arguments[0], arguments[1])"
                         ".then(() => window.answer = 'done', (e) => window.answer = e.message)", name, values)
        answer = self.browser.wait("window.answer", seconds=120, what=name)
        assert answer == "done", f"{name}: {answer}"

    def picture(self, name):
        time.sleep(1)  # until the last frame is painted
        self.browser.screenshot(FOLDER / name)


def main():
    # Less than a second after the intruder has reached the floor.
    with Page("collapse", 1280, 800) as page:
        page.command("pace", steps_per_frame=100)
        page.command("run", time=7.9)
        x, y = page.browser.run(
            "const {picture} = quicksand, {disks} = quicksand.frame(), k = 3 * 500;"
            "const r = picture.canvas.getBoundingClientRect(), p = picture.camera().to_pixel([disks[k], disks[k + 1]]);"
            "return [r.left + p[0], r.top + p[1]]")
        page.browser.mouse("mouseMoved", x, y)
        page.browser.wait("!document.getElementById('tooltip').hidden")
        page.picture("browser.png")
        page.command("view", theme="dark", colour="pressure", forces=True)
        page.browser.mouse("mouseMoved", 5, 5)
        page.browser.resize(390, 844)
        page.browser.wait("innerWidth === 390")
        page.browser.run("for (const part of ['d_view', 'd_parameters']) document.getElementById(part).open = false")
        page.picture("browser_phone.png")
    with Page(RUN, 1100, 640) as page:
        page.command("show", time=6.7)
        page.picture("browser_timeline.png")


main()
