"""Opens the site of documentation in a browser, from the disk, narrow and wide, light and dark.

    site_pages.py SCREENS SITE

No text is wider than its window, formulas are drawn, the two colour schemes differ, nothing comes from a network,
and the search finds a page. Screenshots are left in SCREENS.
"""

import sys
from pathlib import Path

from browser import in_browsers
from checks import check

PAGES = [
    "index", "docs/tutorials/raceway", "docs/case-file", "docs/touchdown-drops", "docs/theory/contact",
    "docs/reference/python",
]  # fmt: skip
WIDTHS = (420, 1400)
# Mean of red, green and blue of the page's own background.
BRIGHTNESS = "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).slice(0, 3).reduce((a, b) => a + +b, 0) / 3"
# The text scrolls as a whole only where something in it is wide and does not scroll on its own.
WIDER = "(e => e.scrollWidth - e.clientWidth)(document.querySelector('.content'))"
FLAT = "[...document.querySelectorAll('math')].filter(m => m.getBoundingClientRect().height < 5).length"


def show(tab, width, scheme):
    tab.call("Emulation.setDeviceMetricsOverride", width=width, height=1100, deviceScaleFactor=1, mobile=False)
    tab.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])


def of_disk_alone(name, tab):
    """No request but those for files, and no error of a script."""
    asked = [e["request"]["url"] for e in tab.happened("Network.requestWillBeSent")]
    elsewhere = [url for url in asked if not url.startswith(("file:", "data:"))]
    check(f"{name}: nothing from a network", not elsewhere, elsewhere)
    check(f"{name}: no error of a script", not tab.happened("Runtime.exceptionThrown"))


def look(site, screens):
    def of(browser):
        for name in PAGES:
            tab = browser.open(f"{site.as_uri()}/{name}.html")
            brightness = {}
            for width in WIDTHS:
                for scheme in ("light", "dark"):
                    show(tab, width, scheme)
                    wider = max(tab.js(WIDER), tab.js("document.documentElement.scrollWidth - innerWidth"))
                    check(f"{name} at {width} px, {scheme}: fits its window", wider <= 0, f"{wider} px wider")
                    brightness[scheme] = tab.js(BRIGHTNESS)
                    tab.screenshot(screens / f"site-{name.replace('/', '-')}-{width}-{scheme}.png")
            check(f"{name}: light and dark", brightness["dark"] < 60 and brightness["light"] > 200, brightness)
            check(f"{name}: formulas are drawn", tab.js(FLAT) == 0)
            if "theory" in name:
                check(f"{name}: formulas", tab.js("document.querySelectorAll('math').length") > 20)
            of_disk_alone(name, tab)
        tab = browser.open(f"{site.as_uri()}/search.html?q=restitution")
        tab.wait_for("document.querySelectorAll('#search-results li a').length > 2")
        found = tab.js("[...document.querySelectorAll('#search-results li a')].map(a => a.getAttribute('href')).join(' ')")
        check("search for restitution", "docs/theory/contact.html" in found, found)
        of_disk_alone("search", tab)

    return of


def main():
    screens, site = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    return in_browsers(screens, [("site", look(site, screens))])


if __name__ == "__main__":
    sys.exit(main())
