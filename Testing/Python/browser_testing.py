# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages in a headless Chromium, as on a phone; Debian: chromium-driver python3-selenium."""

import contextlib
import pathlib
import shutil
import unittest


@contextlib.contextmanager
def open_phone():
    """A browser with a touch screen of 390 x 844 pixels. Skips the test where there is none."""
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
    except ImportError:
        raise unittest.SkipTest("there is no selenium") from None
    driver = shutil.which("chromedriver")
    if driver is None:
        raise unittest.SkipTest("there is no chromedriver")
    options = webdriver.ChromeOptions()
    for argument in "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage":
        options.add_argument(argument)
    options.add_experimental_option("mobileEmulation", {
        "deviceMetrics": {"width": 390, "height": 844, "pixelRatio": 1.0, "touch": True}})
    browser = webdriver.Chrome(service=Service(driver), options=options)
    try:
        yield browser
    finally:
        browser.quit()


def find_faults(browser, path):
    """What is wrong with a page: pictures that are not shown, and a width that needs scrolling."""
    browser.get(pathlib.Path(path).as_uri())
    return browser.execute_script("""
        const faults = [...document.images].filter(each => each.complete && !each.naturalWidth)
            .map(each => "no picture " + each.getAttribute("src"));
        const width = document.documentElement.scrollWidth;
        if (width > window.innerWidth || window.innerWidth > 390)
            faults.push(`${width} pixels wide in a window of ${window.innerWidth}`);
        return faults""")
