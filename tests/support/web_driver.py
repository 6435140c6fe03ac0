"""A browser without a screen, steered over the WebDriver protocol; only the standard library is used."""

import base64
import json
import subprocess
import time
import urllib.request


class Browser:
    """One window of Chromium, through a chromedriver of its own."""

    def __init__(self, width=1280, height=800, dark=False, downloads=None):
        self._driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        for line in self._driver.stdout:
            if "started successfully on port" in line:
                self._root = f"http://127.0.0.1:{line.split()[-1].rstrip('.')}"
                break
        arguments = ["--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--force-device-scale-factor=1", "--no-first-run",
                     "--disable-dev-shm-usage", f"--window-size={width},{height}"]
        if dark:
            arguments.append("--force-dark-mode")
        options = {"args": arguments}
        if downloads:
            options["prefs"] = {"download.default_directory": str(downloads), "download.prompt_for_download": False}
        answer = self._call("POST", "/session", {"capabilities": {"alwaysMatch": {"goog:chromeOptions": options}}})
        self._session = f"/session/{answer['sessionId']}"
        self.resize(width, height)

    def _call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self._root + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=30) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def resize(self, width, height):
        """Of the page inside the window."""
        self.protocol("Emulation.setDeviceMetricsOverride",
                      {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})

    def protocol(self, command, parameters):
        """A command of the DevTools protocol."""
        return self._call("POST", self._session + "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, address):
        self._call("POST", self._session + "/url", {"url": address})

    def run(self, script, *arguments):
        """The value of a script with `return`."""
        return self._call("POST", self._session + "/execute/sync", {"script": script, "args": arguments})

    def wait(self, condition, seconds=15, what=None):
        """Until an expression of the page is true; its value then."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = self.run(f"try {{ return {condition} }} catch {{ return null }}")
            if value:
                return value
            time.sleep(0.05)
        raise AssertionError(f"within {seconds} s it did not come true: {what or condition}")

    def element(self, selector):
        found = self._call("POST", self._session + "/element", {"using": "css selector", "value": selector})
        return next(iter(found.values()))

    def click(self, selector):
        self._call("POST", f"{self._session}/element/{self.element(selector)}/click", {})

    def type(self, selector, text):
        """Instead of what stands there."""
        self.run("const e = document.querySelector(arguments[0]); e.focus(); e.select()", selector)
        element = self.element(selector)
        self._call("POST", f"{self._session}/element/{element}/value", {"text": text})

    def choose(self, selector, value):
        self.run("const s = document.querySelector(arguments[0]); s.value = arguments[1];"
                 "s.dispatchEvent(new Event('change', {bubbles: true}))", selector, value)

    def mouse(self, kind, x, y, **more):
        """mousePressed, mouseMoved, mouseReleased or mouseWheel, in pixels of the page."""
        self.protocol("Input.dispatchMouseEvent", {"type": kind, "x": x, "y": y, **more})

    def screenshot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self._call("GET", self._session + "/screenshot")))

    def messages(self):
        """What the browser has complained about since it was asked last."""
        return self._call("POST", self._session + "/se/log", {"type": "browser"})

    def close(self):
        try:
            self._call("DELETE", self._session)
        finally:
            self._driver.terminate()
            self._driver.wait()
