"""Pictures of pages: dots of several series on one axis, or fields of a map. Plain SVG, for light and dark."""

import math

from page import digits

WIDTH, LEFT, RIGHT, ROW = 560, 160, 24, 30
STYLE = """
  text { font: 14px "Helvetica Neue", Arial, sans-serif; fill: #222 } .axis { stroke: #ccc } .title { font-weight: bold }
  .s0 { fill: #0b5fa5 } .s1 { fill: #c2410c } .s2 { fill: #2f7d32 } .s3 { fill: #7b3fa0 } rect.paper { fill: #fff }
  @media (prefers-color-scheme: dark) {
    text { fill: #ddd } .axis { stroke: #555 } rect.paper { fill: #161b22 }
    .s0 { fill: #5aa9f0 } .s1 { fill: #ff8a50 } .s2 { fill: #74c476 } .s3 { fill: #c792ea }
  }
"""


def ticks(low, high, log):
    """Places of the labels of an axis that covers an interval."""
    if log:
        return [10.0**n for n in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)]
    step = next(m * 10.0**n for n in range(-4, 6) for m in (1, 2, 5) if (high - low) / (m * 10.0**n) <= 6)
    return [step * n for n in range(math.floor(low / step), math.ceil(high / step) + 1)]


def mark(series, x, y):
    """A mark that also differs by its shape."""
    shapes = (
        f'<circle class="s0" cx="{x:.1f}" cy="{y:.1f}" r="6"/>',
        f'<rect class="s1" x="{x - 5.5:.1f}" y="{y - 5.5:.1f}" width="11" height="11"/>',
        f'<path class="s2" d="M{x:.1f} {y - 8:.1f}l8 8-8 8-8-8z"/>',
        f'<path class="s3" d="M{x:.1f} {y - 7:.1f}l7 12h-14z"/>',
    )
    return shapes[series]


def dots(title, rows, series, log=False):
    """A chart of series, name → values of all rows; None is left out. The title names the quantity with its unit."""
    values = [value for of in series.values() for value in of if value is not None]
    places = ticks(min(values) if log else min(0, *values), max(values), log)
    scale = math.log10 if log else float
    first, last = scale(places[0]), scale(places[-1])
    # Names of the series, in as many lines as they need.
    legend, x_of, line = [], 10, 0
    for k, name in enumerate(series if len(series) > 1 else ()):
        width = 36 + 7.4 * len(name)
        if x_of + width > WIDTH:
            x_of, line = 10, line + 1
        legend.append(f'{mark(k, x_of + 8, 42 + 22 * line)}<text x="{x_of + 20}" y="{47 + 22 * line}">{name}</text>')
        x_of += width
    top = 36 + 22 * (line + 1 if legend else 0)
    bottom = top + ROW * len(rows)

    def x(value):
        return LEFT + (WIDTH - LEFT - RIGHT) * (scale(value) - first) / (last - first)

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {bottom + 28}" role="img">',
        f"<title>{title}</title><style>{STYLE}</style>",
        f'<rect class="paper" width="{WIDTH}" height="{bottom + 28}"/>',
        f'<text class="title" x="10" y="20">{title}</text>',
        *legend,
    ]
    for place in places:
        parts.append(f'<path class="axis" d="M{x(place):.1f} {top}V{bottom}"/>')
        parts.append(f'<text x="{x(place):.1f}" y="{bottom + 18}" text-anchor="middle">{digits(f"{place:.6g}")}</text>')
    for n, row in enumerate(rows):
        y = top + ROW * (n + 0.5)
        parts.append(f'<text x="{LEFT - 12}" y="{y + 5:.1f}" text-anchor="end">{row}</text>')
        parts += [mark(k, x(of[n]), y) for k, of in enumerate(series.values()) if of[n] is not None]
    return "\n".join([*parts, "</svg>\n"])


def fields(title, columns, panels, series):
    """A map: panels, name → rows, name → fields, each the name of one of the series or None; columns are their heads."""
    left, width, height = 96, (WIDTH - 96 - 10) / len(columns), 30
    parts, top = [], 36
    for k, head in enumerate(columns):
        parts.append(f'<text x="{left + (k + 0.5) * width:.1f}" y="{top + 12}" text-anchor="middle">{head}</text>')
    top += 18
    for panel, rows in panels.items():
        parts.append(f'<text x="10" y="{top + 20}" class="title">{panel}</text>')
        top += 28
        for name, of in rows.items():
            parts.append(f'<text x="{left - 10}" y="{top + 20}" text-anchor="end">{name}</text>')
            for k, field in enumerate(of):
                if field is None:
                    continue
                x = left + k * width
                colour = list(series).index(field)
                parts.append(f'<rect class="s{colour}" fill-opacity="0.3" x="{x + 2:.1f}" y="{top + 2}" width="{width - 4:.1f}" height="{height - 4}"/>')
                parts.append(f'<text x="{x + width / 2:.1f}" y="{top + 20}" text-anchor="middle">{series[field]}</text>')
            top += height
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {top + 10}" role="img">',
            f"<title>{title}</title><style>{STYLE}</style>",
            f'<rect class="paper" width="{WIDTH}" height="{top + 10}"/>',
            f'<text class="title" x="10" y="20">{title}</text>',
            *parts,
            "</svg>\n",
        ]
    )
