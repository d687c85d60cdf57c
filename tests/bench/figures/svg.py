"""Draws plots as SVG: a page with panels, each with its own scales. Equal tables make equal files."""

import html
import math

GREY, LIGHT, DARK = "#666666", "#e4e4e4", "#222222"


def number(value):
    """A coordinate, to a tenth of a pixel."""
    return f"{value:.1f}".rstrip("0").rstrip(".")


def text_width(text, size):
    """About how wide a text is in pixels; common fonts are narrower."""
    return 0.6 * size * len(text)


class Log:
    """A logarithmic scale from values to pixels."""

    def __init__(self, low, high, begin, end):
        self.low, self.high, self.begin, self.end = low, high, begin, end

    def __call__(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.begin + share * (self.end - self.begin)


def decades(values):
    """The powers of ten around the values."""
    return 10.0 ** math.floor(math.log10(min(values))), 10.0 ** math.ceil(math.log10(max(values)))


def powers(scale):
    """The powers of ten of a scale that begins and ends with one."""
    return [10.0 ** k for k in range(round(math.log10(scale.low)), round(math.log10(scale.high)) + 1)]


class Page:
    def __init__(self, width, height):
        self.size = (width, height)
        self.parts = []

    def line(self, x1, y1, x2, y2, colour=GREY, width=1.0):
        ends = " ".join(f'{name}="{number(value)}"' for name, value in zip(("x1", "y1", "x2", "y2"), (x1, y1, x2, y2)))
        self.parts.append(f'<line {ends} stroke="{colour}" stroke-width="{number(width)}"/>')

    def text(self, x, y, text, size=11, anchor="start", colour=DARK, turn=0):
        more = f' transform="rotate({turn} {number(x)} {number(y)})"' if turn else ""
        self.parts.append(f'<text x="{number(x)}" y="{number(y)}" font-size="{size}" text-anchor="{anchor}" fill="{colour}"{more}>'
                          f"{html.escape(text)}</text>")

    def mark(self, shape, x, y, colour, size=4.0, full=True):
        """A circle, square, diamond, triangle up or down, cross, plus or bar, centred at the point."""
        fill = colour if full else "white"
        if shape == "circle":
            self.parts.append(f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(size)}" fill="{fill}" stroke="{colour}"/>')
            return
        ways = {
            "square": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
            "diamond": [(0, -1.2), (1.2, 0), (0, 1.2), (-1.2, 0)],
            "up": [(0, -1.2), (1.1, 0.9), (-1.1, 0.9)],
            "down": [(0, 1.2), (1.1, -0.9), (-1.1, -0.9)],
        }
        if shape in ways:
            points = " ".join(f"{number(x + size * dx)},{number(y + size * dy)}" for dx, dy in ways[shape])
            self.parts.append(f'<polygon points="{points}" fill="{fill}" stroke="{colour}"/>')
            return
        strokes = {"cross": [(-1, -1, 1, 1), (-1, 1, 1, -1)], "plus": [(-1.2, 0, 1.2, 0), (0, -1.2, 0, 1.2)], "bar": [(-1.2, 0, 1.2, 0)],
                   "star": [(0, 0, 0, 1.3), (0, 0, -1.1, -0.7), (0, 0, 1.1, -0.7)]}
        for x1, y1, x2, y2 in strokes[shape]:
            self.line(x + size * x1, y + size * y1, x + size * x2, y + size * y2, colour, 0.375 * size)

    def legend(self, entries, x, y):
        """entries: (shape, colour, full, label); a line holds as many as fit on the page."""
        left = x
        for shape, colour, full, label in entries:
            right = left + 10 + text_width(label, 12)
            if right > self.size[0]:
                left, right, y = x, right - left + x, y + 20
            self.mark(shape, left, y - 4, colour, 4, full)
            self.text(left + 10, y, label, 12)
            left = right + 20

    def write(self):
        width, height = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{number(width)}" height="{number(height)}" '
                f'viewBox="0 0 {number(width)} {number(height)}" font-family="DejaVu Sans, Verdana, sans-serif">')
        return "\n".join([head, '<rect width="100%" height="100%" fill="white"/>', *self.parts, "</svg>", ""])
