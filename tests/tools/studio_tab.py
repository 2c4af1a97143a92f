"""A tab with the studio: its controls, its text and its parts."""

import json

from checks import check

S = "window.cagelessStudio"


class StudioTab:
    def __init__(self, tab, name):
        self.tab, self.name = tab, name

    def js(self, expression):
        return self.tab.js(expression)

    def check(self, what, good, found=None):
        check(f"{self.name}: {what}", good, found)

    def settled(self):
        """Waits for the geometry of the text that stands there."""
        self.tab.wait_for(f"!!{S} && !!{S}.g && !{S}.busy")

    def judged(self):
        self.tab.wait_for("document.querySelector('[data-part=verdict]').dataset.kind === 'simulated'")

    def slide(self, control, value):
        self.js(
            f"(() => {{ const e = document.querySelector('[data-range={control}]'); e.value = {value};"
            " e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change')); })()"
        )
        self.settled()

    def write(self, control, value):
        self.js(
            f"(() => {{ const e = document.querySelector('[data-number={control}]'); e.value = {value};"
            " e.dispatchEvent(new Event('change')); })()"
        )
        self.settled()

    def type(self, text):
        self.js(
            f"(() => {{ const e = document.querySelector('[data-toml]'); e.value = {json.dumps(text)};"
            " e.dispatchEvent(new Event('input')); })()"
        )
        self.settled()

    def press(self, name):
        # A report has moving balls of its own.
        place = "" if name == "open" else ".studio "
        self.js(f"document.querySelector('{place}[data-{name}]').click()")

    def text(self, part):
        return self.js(f"document.querySelector('[data-part={part}]').textContent")

    def toml(self):
        return self.js("document.querySelector('[data-toml]').value")
