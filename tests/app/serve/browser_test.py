#!/usr/bin/env python3
"""The page in a real browser, from opening it to a server that dies: browser_test.py PROGRAM.

Exit code 77: Chromium or its driver is not installed.
"""

import csv
import json
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
import zlib
import base64
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "support"))
from web_driver import Browser  # noqa: E402

PROGRAM = Path(sys.argv[1]).resolve()
FOLDER = Path(tempfile.mkdtemp(prefix="quicksand_browser_"))


class Server:
    def __init__(self, *options, port=0, shown="collapse", out="out"):
        self.out = out
        self.process = subprocess.Popen(
            [PROGRAM, "serve", shown, "--port", str(port), "--out", out, "--token-file", "token",
             "--record", "by_hand.json", *options],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=FOLDER)
        self.address = self.process.stdout.readline().strip()
        self.port = int(self.address.split(":")[2].split("/")[0])

    def end(self, number=signal.SIGINT):
        self.process.send_signal(number)
        return self.process.wait(timeout=20)


def pixels(png):
    """Width, height and the rows, three bytes a pixel, of a PNG of 8 bits a channel."""
    at, packed, header = 8, b"", None
    while at < len(png):
        size, name = struct.unpack(">I4s", png[at:at + 8])
        data = png[at + 8:at + 8 + size]
        header = struct.unpack(">IIBB", data[:10]) if name == b"IHDR" else header
        packed += data if name == b"IDAT" else b""
        at += size + 12
    width, height, depth, kind = header
    assert depth == 8 and kind in (2, 6), "RGB or RGBA"
    step = 4 if kind == 6 else 3
    raw, stride, rows = zlib.decompress(packed), width * step, []
    before = bytearray(stride)
    for y in range(height):
        form, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        if form == 1:
            for i in range(step, stride):
                row[i] = (row[i] + row[i - step]) & 255
        elif form == 2:
            for i in range(stride):
                row[i] = (row[i] + before[i]) & 255
        elif form == 3:
            for i in range(stride):
                row[i] = (row[i] + ((row[i - step] if i >= step else 0) + before[i]) // 2) & 255
        elif form == 4:
            for i in range(stride):
                a, b, c = row[i - step] if i >= step else 0, before[i], before[i - step] if i >= step else 0
                p = a + b - c
                near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
                row[i] = (row[i] + near) & 255
        before = row
        rows.append(bytes(row) if step == 3 else bytes(x for i, x in enumerate(row) if i % 4 != 3))
    return width, height, rows


def share_alike(a, b, tolerance=8):
    """Of the pixels whose channels all differ by no more."""
    assert a[:2] == b[:2], f"sizes {a[:2]} and {b[:2]}"
    alike = sum(all(abs(p[i + c] - q[i + c]) <= tolerance for c in range(3))
                for p, q in zip(a[2], b[2]) for i in range(0, len(p), 3))
    return alike / (a[0] * a[1])


def command(browser, name, **values):
    """Performed when this returns; its result."""
    browser.run("window.answer = null; quicksand.connection.command(arguments[0], arguments[1])"
                ".then((r) => window.answer = {r}, (e) => window.answer = {e: e.message})", name, values)
    answer = browser.wait("window.answer", what=name)
    assert "e" not in answer, f"{name}: {answer.get('e')}"
    return answer["r"]


def settle(browser):
    """The picture of the last command is drawn."""
    browser.run("window.seen = 0; const step = () => ++window.seen < 12 && requestAnimationFrame(step); step()")
    browser.wait("window.seen >= 12")


def loaded(browser, scene):
    browser.wait(f"quicksand.frame().scene === '{scene}' && quicksand.state().scene === '{scene}'", what=f"scene {scene}")


def opens(browser, server):
    browser.open(server.address)
    loaded(browser, "collapse")
    assert "token" not in browser.run("return location.href"), "the address shows the token"
    assert browser.run("return document.querySelectorAll('label input, label select').length") > 20
    names = browser.run("return [...document.querySelectorAll('button, input, select')].filter((e) =>"
                        "!(e.textContent || e.ariaLabel || e.labels?.length || e.title)).map((e) => e.outerHTML)")
    assert not names, f"controls without a name: {names}"


def chooses_a_scene(browser, server):
    browser.choose("#scene", "heap" if browser.run("return quicksand.state().scenes.includes('heap')") else "chain")
    browser.wait("quicksand.frame().scene !== 'collapse'")
    names = "[...document.querySelectorAll('#phases li')].map((li) => li.textContent.replace(/[0-9].*/, ''))"
    browser.wait(f"JSON.stringify({names}) === JSON.stringify(quicksand.state().phases)", what="the phases of this scene")
    browser.choose("#scene", "collapse")
    loaded(browser, "collapse")


def changes_a_parameter(browser, server):
    field = "#parameters [data-path='contact.friction']"
    browser.type(field, "0.45\t")
    browser.wait("quicksand.state().parameters[0].parameters.find((p) => p.label === 'friction').value === 0.45")
    browser.type(field, "-1\t")
    browser.wait(f"!document.querySelector(\"{field}\").closest('label').querySelector('.problem').hidden",
                 what="the reason of a refusal beside its control")
    browser.type(field, "\ue003\t")
    browser.wait(f"document.querySelector(\"{field}\").closest('label').querySelector('.problem').textContent === 'takes a number'",
                 what="a field that was emptied is no term that the scene leaves out")
    browser.type(field, "0.45\t")
    browser.wait("!document.querySelector('#parameters .refused')")
    before = browser.run("return quicksand.state().last_change")
    assert before == "contact.friction", before
    browser.click("#undo")
    browser.run("document.querySelector('#run').focus()")
    friction = "quicksand.state().parameters[0].parameters.find((p) => p.label === 'friction').value"
    # The second change was from 0.45 to itself.
    for kind in ("keyDown", "keyUp"):
        browser.protocol("Input.dispatchKeyEvent", {"type": kind, "key": "z", "code": "KeyZ", "modifiers": 2, "windowsVirtualKeyCode": 90})
    browser.wait(f"{friction} === 0.3 && document.getElementById('undo').disabled", what="the friction of before")


def runs_and_pauses(browser, server):
    browser.type("#pace", "100\t")
    browser.wait("quicksand.state().steps_per_frame === 100")
    browser.click("#run")
    browser.wait("quicksand.frame().step > 300 && quicksand.frame().running", 30)
    assert browser.run("return document.getElementById('run').textContent") == "Pause"
    browser.click("#run")
    browser.wait("!quicksand.frame().running")
    step = browser.run("return quicksand.frame().step")
    browser.click("#step")
    browser.wait(f"quicksand.frame().step === {step + 1}")
    browser.run("document.getElementById('picture').focus()")
    browser.protocol("Input.dispatchKeyEvent", {"type": "keyDown", "key": "s", "text": "s"})
    browser.wait(f"quicksand.frame().step === {step + 2}", what="a step by the key")


def pixel_of(browser, body):
    """Where a grain is on the page."""
    return browser.run("const {picture} = quicksand, {disks} = quicksand.frame(), k = 3 * arguments[0];"
                       "const r = picture.canvas.getBoundingClientRect(), p = picture.camera().to_pixel([disks[k], disks[k + 1]]);"
                       "return [r.left + p[0], r.top + p[1]]", body)


def hovers(browser, server):
    x, y = pixel_of(browser, 20)
    browser.mouse("mouseMoved", x, y)
    browser.wait("!document.getElementById('tooltip').hidden && document.getElementById('tooltip').textContent.includes('20')")
    assert "normal" in browser.run("return document.getElementById('tooltip').textContent")
    for kind in ("mousePressed", "mouseReleased"):
        browser.mouse(kind, x, y, button="left", clickCount=1)
    browser.wait("quicksand.frame().picked === 20")
    browser.wait("document.getElementById('inspection').textContent.includes('Velocity')")


def pulls(browser, server):
    x, y = pixel_of(browser, 20)
    browser.click("#camera [data-do=pull]")
    browser.mouse("mousePressed", x, y, button="left", clickCount=1)
    browser.mouse("mouseMoved", x + 40, y, button="left", buttons=1)
    browser.wait("quicksand.picture.held && !document.getElementById('arrow').hasAttribute('hidden')")
    browser.mouse("mouseMoved", x + 50, y, button="left", buttons=1)
    time.sleep(0.2)
    browser.mouse("mouseReleased", x + 50, y, button="left")
    browser.wait("!quicksand.picture.held")
    browser.click("#camera [data-do=pull]")
    command(browser, "run", steps=2)


def colours(browser, server):
    browser.choose("#view_fields [data-path=colour]", "speed")
    browser.wait("quicksand.frame().legend.title.startsWith('Speed') && document.getElementById('legend').textContent.includes('Speed')")


def zooms(browser, server):
    before = browser.run("return quicksand.picture.camera().scale")
    browser.mouse("mouseWheel", 800, 300, deltaX=0, deltaY=-300)
    browser.wait(f"quicksand.picture.camera().scale > 1.2 * {before}")
    browser.wait("!quicksand.frame().fitted", what="the window that the server knows")
    browser.mouse("mousePressed", 1200, 300, button="left", clickCount=1)
    browser.mouse("mouseMoved", 1100, 330, button="left", buttons=1)
    browser.mouse("mouseReleased", 1100, 330, button="left")
    browser.click("#camera [data-do=box]")
    browser.wait("quicksand.frame().fitted")


def plots(browser, server):
    browser.wait("quicksand.plots.message.time.length > 1")
    x, y = browser.run("const r = document.querySelector('.plot canvas').getBoundingClientRect(); return [r.left + r.width / 2, r.top + 30]")
    browser.mouse("mouseMoved", x, y)
    browser.wait("[...document.querySelectorAll('.plot output')].some((o) => o.textContent.includes(' at '))", what="a cursor")
    browser.choose(".plot select", "kinetic_energy" if browser.run(
        "return quicksand.plots.message.columns.some((c) => c.name === 'kinetic_energy')") else "bodies")


def downloads(browser, server):
    for name, file in [("state", "state.cbor"), ("csv", "series.csv"), ("png", "picture.png"), ("recording", "recording.json")]:
        browser.run("document.getElementById('d_files').open = true")
        browser.click(f"[data-file={name}]")
        end = time.monotonic() + 15
        arrived, sent = FOLDER / "downloads" / file, FOLDER / "out" / file
        # The browser shows a file while it is still writing it.
        while not arrived.exists() or arrived.read_bytes() != sent.read_bytes():
            assert time.monotonic() < end, f"{file} did not arrive as it was sent"
            time.sleep(0.05)


def complaints(page):
    """Since it was asked last; they are errors."""
    return [entry["message"] for entry in page.messages() if entry["level"] == "SEVERE"]


def compared(browser, window, view, out="out"):
    """The share of pixels that page and program draw alike."""
    command(browser, "view", legend=False, scale_bar=False, numbers=False, detail=False, **view)
    browser.run(f"quicksand.picture.look({window})")
    browser.wait("!quicksand.frame().fitted && !quicksand.picture.looking")
    browser.wait(f"quicksand.frame().theme === '{view['theme']}'")
    browser.wait(f"Boolean(quicksand.frame().force_scale) === {str(view.get('forces', False)).lower()}")
    browser.wait("quicksand.picture.canvas.width === document.getElementById('view').clientWidth", what="the new size")
    settle(browser)
    size = browser.run("return quicksand.picture.size()")
    # Over the packing stands a line with the names of scene and phase, which the page shows elsewhere.
    text = round(9 + size["height"] / 120)
    line = 2 * round(0.7 * text) + text
    command(browser, "snapshot", file="compare.png", width=size["width"], height=size["height"] + line)
    page = browser.run("return quicksand.picture.canvas.toDataURL('image/png')")
    (FOLDER / "page.png").write_bytes(base64.b64decode(page.split(",")[1]))
    ours, theirs = (pixels((FOLDER / name).read_bytes()) for name in (f"{out}/compare.png", "page.png"))
    alike = share_alike((size["width"], size["height"], ours[2][line:]), theirs)
    print(f"    {view['theme']}: {100 * alike:.3f} % of {ours[0]}x{ours[1]} pixels within 8/255")
    return alike


def looks_like_the_program(browser, server):
    browser.resize(900, 560)
    browser.wait("innerWidth === 900")
    worst = min(compared(browser, [2, -1, 24, 14], view) for view in [
        {"colour": "active_bonds", "theme": "light", "bonds": True, "orientation": True},
        {"colour": "pressure", "theme": "dark", "forces": True, "bonds": False}])
    assert worst >= 0.99, f"only {worst:.4f} of the pixels look alike"
    command(browser, "view", legend=True, scale_bar=True, numbers=True, theme="light", forces=False, orientation=False)
    browser.resize(1280, 800)


def shows_shapes(browser, server):
    """A cone among grains, as the program draws it; what one points at is found by its outline."""
    cone = Server(shown="cone", out="out_cone")
    page = Browser()
    try:
        page.open(cone.address)
        page.resize(900, 560)
        page.wait("innerWidth === 900 && window.quicksand && quicksand.frame()")
        command(page, "run", time=8.3)
        page.wait("quicksand.frame().shapes?.length === 1", what="the cone")
        worst = min(compared(page, [6, 2, 18, 12], view, cone.out) for view in [
            {"colour": "active_bonds", "theme": "light", "bonds": True, "orientation": True, "forces": True},
            {"colour": "pressure", "theme": "dark", "bonds": True, "orientation": False, "forces": False}])
        assert worst >= 0.99, f"only {worst:.4f} of the pixels look alike"
        # Close up, no more is filled than is seen.
        for half in (1e-3, 1e-6):
            drawn = page.run("const frame = quicksand.frame(), [{body, parts}] = frame.shapes;"
                             " const {corners} = parts.find((part) => part.corners.length > 2);"
                             " const middle = (i) => frame.disks[3 * body + i] + corners.reduce((sum, c) => sum + c[i], 0) / corners.length;"
                             " const x = middle(0), y = middle(1), half = arguments[0], from = (name) => import(`${location.origin}/${name}.js`);"
                             " return Promise.all([from('drawing'), from('camera')]).then(([{draw}, {Camera}]) =>"
                             " draw(frame, new Camera(frame, [x - half, y - half, x + half, y + half], 400, 300)).segments.count)", half)
            assert 600 <= drawn < 2000, drawn
        # Beyond the disk of its area, but in its parts; and within that disk, but beside them.
        told = page.run("const {frame, picture} = quicksand, {shapes, disks} = frame(), [shape] = shapes, {body, parts} = shape,"
                        " [x, y, r] = disks.subarray(3 * body, 3 * body + 3);"
                        " const far = parts.flatMap((p) => p.corners).reduce((a, b) => Math.hypot(...a) > Math.hypot(...b) ? a : b);"
                        " const size = Math.hypot(...far), {origin, scale} = picture.camera();"
                        " const at = ([dx, dy]) => picture.body_at([origin[0] + scale * (x + dx), origin[1] - scale * (y + dy)]);"
                        " return {body, beyond: size > r, there: at(far), past: at(far.map((c) => c * (size + 3) / size))}")
        assert told["beyond"] and told["there"] == told["body"] != told["past"], told
        page.resize(1280, 800)
        # Its load over its way, and the cursor of the others at the place that is pointed at.
        page.wait("[...document.querySelectorAll('.plot')].at(-1).textContent.includes('depth [d]')"
                  " && quicksand.plots.plots.at(-1).scale?.to > 0.2", what="resistance over depth")
        assert page.run("return quicksand.plots.plots.map((p) => p.over)") == ["time", "time", "depth"]
        x, y = page.run("const r = [...document.querySelectorAll('.plot canvas')].at(-1).getBoundingClientRect();"
                        " return [r.left + 0.7 * r.width, r.top + 30]")
        page.mouse("mouseMoved", x, y)
        page.wait("[...document.querySelectorAll('.plot output')].every((o) => o.textContent.includes(' at '))", what="a cursor")
        depth, reached = page.run("const {message, cursor} = quicksand.plots, i = quicksand.plots.nearest(cursor);"
                                  " return [message.depth[i], quicksand.plots.plots.at(-1).scale.to]")
        assert 0 < depth < reached, (depth, reached)
        page.screenshot(FOLDER / "cone.png")
        page.choose(".plot:last-child .over", "time")
        page.wait("quicksand.plots.plots.at(-1).over === 'time'")
        problems = complaints(page)
        assert not problems, f"the page complained: {problems}"
    finally:
        page.close()
        cone.end()


def fits_a_phone(browser, server):
    browser.resize(390, 844)
    browser.wait("innerWidth === 390 && document.documentElement.scrollWidth <= 390", what="no scrolling sideways")
    browser.resize(1280, 800)


def reloads_in_mid_run(browser, server):
    command(browser, "start")
    browser.wait("quicksand.frame().running")
    step = browser.run("return quicksand.frame().step")
    browser.run("location.reload()")
    browser.wait(f"quicksand.frame().running && quicksand.frame().step > {step}")
    command(browser, "pause")


def two_at_once(browser, server):
    other = Browser(width=800, height=600)
    try:
        other.open(server.address)
        loaded(other, "collapse")
        command(other, "view", colour="coordination")
        browser.wait("quicksand.frame().legend.title === 'Contacts'", what="what the other has chosen")
        command(browser, "run", steps=3)
        step = browser.run("return quicksand.frame().step")
        other.wait(f"quicksand.frame().step >= {step}")
    finally:
        other.close()


def refuses_a_wrong_token(browser, server):
    for address in (server.address[:-4] + "0000", server.address.split("?")[0]):
        try:
            urllib.request.urlopen(address, timeout=5)
            raise AssertionError(f"{address} was admitted")
        except urllib.error.HTTPError as error:
            assert error.code == 401, error.code


def survives_the_server(browser, server):
    problems = complaints(browser)
    assert not problems, f"the page complained: {problems}"
    server.end(signal.SIGKILL)
    browser.wait("!document.getElementById('banner').hidden && document.getElementById('chip').textContent === 'no connection'")
    again = Server(port=server.port)
    browser.wait("document.getElementById('banner').hidden && quicksand.frame().step === 0", 20, "it comes back")
    command(browser, "run", steps=30)
    command(browser, "set", path="contact.friction", value=0.2)
    command(browser, "pace", steps_per_frame=7)
    command(browser, "start")
    browser.wait("quicksand.frame().step > 100")
    assert again.end() == 130
    replay = subprocess.run([PROGRAM, "session", "by_hand.json", "--out", "replay", "--quiet"], cwd=FOLDER,
                            capture_output=True, text=True)
    assert replay.returncode == 0, replay.stderr
    recorded = json.loads((FOLDER / "by_hand.json").read_text())["commands"]
    assert recorded[-1]["command"] == "expect_hash" and {"command": "run", "steps": 30} in recorded


def walks_through_a_run(browser, server):
    two = 'phases=[{"type": "settle", "until_rest": false, "max_time": 0.5}, {"type": "settle", "max_time": 0.1}]'
    ran = subprocess.run([PROGRAM, "run", "chain", "--set", two, "--no-frames", "--out", "run", "--quiet"], cwd=FOLDER)
    assert ran.returncode == 0
    walk = Server(shown="run", out="out_walk")
    page = Browser()
    try:
        page.open(walk.address)
        page.wait("quicksand.frame().timeline && quicksand.timeline.run", what="the timeline")
        last = page.run("return quicksand.frame().timeline.samples") - 1
        place = "const s = document.querySelector('#timeline input[type=range]'); return (s.value - s.min) / (s.max - s.min)"
        assert last > 2 and abs(page.run(place) - 1) < 1e-3
        assert page.run("const {timeline} = quicksand; timeline.phase.dataset.made = ''; timeline.set_run(timeline.run);"
                        "return timeline.phase.value") == "1", "the phase, also where the moments of the run come last"
        names = page.run("return [...document.querySelectorAll('#timeline button, #timeline input, #timeline select')]"
                         ".filter((e) => !(e.textContent || e.ariaLabel || e.labels?.length)).map((e) => e.outerHTML)")
        assert not names, f"controls without a name: {names}"
        page.wait("document.getElementById('computing').hidden", what="no controls that compute")
        page.run("document.querySelector('#timeline input[type=range]').focus()")
        for kind, key in (("keyDown", "Home"), ("keyUp", "Home")):
            page.protocol("Input.dispatchKeyEvent", {"type": kind, "key": key, "code": key, "windowsVirtualKeyCode": 36})
        page.wait("quicksand.frame().timeline.sample === 0", what="the first sample by a key")
        for kind in ("keyDown", "keyUp"):
            page.protocol("Input.dispatchKeyEvent", {"type": kind, "key": "ArrowRight", "code": "ArrowRight", "windowsVirtualKeyCode": 39})
        page.wait("quicksand.frame().timeline.sample === 1", what="a sample on by a key")
        assert page.run("return quicksand.plots.moment === quicksand.frame().time"), "the cursor of the plots"
        with open(FOLDER / "run" / "series.csv") as file:
            grains = [float(row["grains"]) for row in csv.DictReader(file)]
        assert page.run("return [...quicksand.plots.message.grains]") == grains, "quantities of the series"
        x, y, width = page.run("const r = document.querySelector('#timeline canvas').getBoundingClientRect();"
                               "return [r.left, r.top + r.height / 2, r.width]")
        for kind in ("mousePressed", "mouseReleased"):
            page.mouse(kind, x + width / 2, y, button="left", buttons=1, clickCount=1)
        page.wait(f"quicksand.frame().timeline.sample > 1 && quicksand.frame().timeline.sample < {last}", what="a place on the strip")
        page.wait(f"((share) => 0.3 < share && share < 0.7)((() => {{ {place} }})())", what="the slider where the strip was pressed")
        page.screenshot(FOLDER / "timeline.png")
        page.run("[...document.querySelectorAll('#timeline button')].find((b) => b.textContent === 'Play').click()")
        page.wait(f"quicksand.frame().timeline.sample === {last} && !quicksand.frame().timeline.playing", 60, "the end")
        page.run("[...document.querySelectorAll('#timeline button')].at(-1).click()")
        page.wait("!quicksand.frame().timeline && document.getElementById('timeline').hidden", what="what computes on")
        assert page.run("return !document.getElementById('computing').hidden")
        problems = complaints(page)
        assert not problems, f"the page complained: {problems}"
    finally:
        page.close()
        walk.end()


def plays_a_film_by_itself(browser, server):
    """One file, neither a server nor a network."""
    ran = subprocess.run([PROGRAM, "report", "run"], cwd=FOLDER, stdout=subprocess.DEVNULL)
    assert ran.returncode == 0 and 'href="film.html"' in (FOLDER / "run/report.html").read_text()
    page = Browser()
    try:
        page.protocol("Network.enable", {})
        page.protocol("Network.emulateNetworkConditions",
                      {"offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0})
        page.open(f"file://{FOLDER}/run/film.html")
        page.wait("window.quicksand && quicksand.frame()", what="the first frame")
        settle(page)
        drawn = page.run("quicksand.picture.paint(); return quicksand.picture.canvas.toDataURL('image/png')")
        rows = pixels(base64.b64decode(drawn.split(",")[1]))[2]
        assert len({row[i:i + 3] for row in rows for i in range(0, len(row), 3)}) > 5, "an empty picture"
        last = page.run("return quicksand.frame().timeline.samples") - 1
        assert page.run("return quicksand.frame().timeline.sample") == last, "a run is shown as it ended"
        for key in ("End", "Home"):
            page.run("document.querySelector('#timeline input[type=range]').focus()")
            code = {"End": 35, "Home": 36}[key]
            for kind in ("keyDown", "keyUp"):
                page.protocol("Input.dispatchKeyEvent", {"type": kind, "key": key, "code": key, "windowsVirtualKeyCode": code})
            page.wait(f"quicksand.frame().timeline.sample === {last if key == 'End' else 0}", what=key)
        page.run("[...document.querySelectorAll('#timeline button')].find((b) => b.textContent === 'Play').click()")
        page.wait(f"quicksand.frame().timeline.sample === {last} && !quicksand.frame().timeline.playing", 60, "the end")
        problems = complaints(page)
        assert not problems, f"the page complained: {problems}"
    finally:
        page.close()


TESTS = [opens, chooses_a_scene, changes_a_parameter, runs_and_pauses, hovers, pulls, colours, zooms, plots, downloads,
         looks_like_the_program, shows_shapes, fits_a_phone, reloads_in_mid_run, two_at_once, refuses_a_wrong_token,
         walks_through_a_run, plays_a_film_by_itself, survives_the_server]


def main():
    if not shutil.which("chromedriver") or not shutil.which("chromium"):
        print("skipped: there is no chromium with its driver (package chromium-driver)")
        return 77
    server = Server()
    (FOLDER / "downloads").mkdir()
    browser = Browser(downloads=FOLDER / "downloads")
    began = time.monotonic()
    try:
        for test in TESTS:
            start = time.monotonic()
            test(browser, server)
            print(f"{time.monotonic() - start:6.2f} s  {test.__name__.replace('_', ' ')}", flush=True)
        # Since the server was killed; the page may have asked it while it died.
        died = ("ERR_CONNECTION_REFUSED", "ERR_CONNECTION_RESET", "ERR_CONNECTION_CLOSED", "ERR_EMPTY_RESPONSE")
        problems = [problem for problem in complaints(browser) if not any(cause in problem for cause in died)]
        assert not problems, f"the page complained: {problems}"
    except BaseException:
        browser.screenshot(FOLDER / "failure.png")
        print(f"failed; see {FOLDER / 'failure.png'}", file=sys.stderr)
        raise
    finally:
        browser.close()
        if server.process.poll() is None:
            server.end()
    print(f"{time.monotonic() - began:6.2f} s  in all")
    shutil.rmtree(FOLDER)
    return 0


if __name__ == "__main__":
    sys.exit(main())
