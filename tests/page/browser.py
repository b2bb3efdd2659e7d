"""browser.py - headless Chromium for tests of pages: opens one, and notes what it says and asks for."""
import json
import os
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--hide-scrollbars", "--no-first-run", "--disable-background-networking"]


PATIENCE = float(os.environ.get("PATIENCE", 600))  # tests/patience.bash


class Browser:
    def __init__(self, width=1280, height=900):
        options = Options()
        for argument in ARGUMENTS + [f"--window-size={width},{height}"]:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service("chromedriver"), options=options)
        self.resize(width, height)

    def resize(self, width, height=900, dark=False):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme]})

    def open(self, path):
        """Waits until the page says that its sections are made."""
        self.driver.get("file://" + path)
        self.until("return document.documentElement.dataset.ready")

    def until(self, script):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            value = self.run(script)
            if value:
                return value
            time.sleep(0.05)
        raise AssertionError(f"it has not come: {script}")

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def said(self):
        """What scripts wrote to the console, and errors."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        """The addresses that the page asked for."""
        sent = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        return [m["params"]["request"]["url"] for m in sent if m["method"] == "Network.requestWillBeSent"]

    def close(self):
        self.driver.quit()
