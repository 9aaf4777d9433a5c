"""Plots as SVG for a page: points and lines, bars, stacks, and maps of numbers. Colours are classes of style.css."""

import html
import math
from math import ceil, floor, inf, isfinite, log10, nan

WIDTH, HEIGHT = 620, 400
LEFT, RIGHT, TOP, BOTTOM = 80, 26, 14, 52
BAND = 34  # of an axis for what is below its floor
NAME_WIDTH = 50  # of the name of a line across


def escaped(text):
    return html.escape(text, quote=False)


def svg_text(x, y, written, anchor="middle", kind=None):
    shown = f'class="{kind}" ' if kind else ""
    return f'<text {shown}text-anchor="{anchor}" x="{x:.1f}" y="{y:.1f}">{written}</text>\n'


def svg_rectangle(kind, x, y, width, height, more="/>"):
    return f'<rect class="{kind}" x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}"{more}'


def svg_number(value):
    size = abs(value)
    if size == 0 or 1e-3 <= size < 1e6:
        return f"{value:.6g}"
    power = floor(log10(size) + 1e-9)
    lead = value / 10.0**power
    return (f"{lead:.3g}×" if abs(lead - 1) > 1e-6 else "") + f'10<tspan dy="-5" font-size="10">{power}</tspan>'


def round_to_125(x, up):
    """The largest of 1, 2, 5 times a power of ten that is at most x, or the smallest that is at least x."""
    power = 10.0 ** floor(log10(x) + 1e-9)
    lead = x / power
    if up:
        return power * next(step for step in (1, 2, 5, 10) if lead <= step + 1e-9 or step == 10)
    return power * (5 if lead >= 5 else 2 if lead >= 2 else 1)


class Axis:
    """label: with its unit. floor: what is below is drawn in a band of its own at the low end; 0: there is no band."""

    def __init__(self, label, logarithmic=False, floor=0):
        self.label, self.logarithmic, self.floor = label, logarithmic, floor
        self.low, self.high = inf, -inf

    def widen(self, value):
        if isfinite(value) and value >= self.floor and (not self.logarithmic or value > 0):
            self.low, self.high = min(self.low, value), max(self.high, value)

    def step(self):
        return round_to_125((self.high - self.low) / 10, True)

    def round_ends(self):
        """Outward: to 1, 2 or 5 times a power of ten, to powers of ten where there are many, or to round numbers."""
        if self.floor > 0:
            self.low, self.high = self.floor, max(self.high, self.floor)
        if not self.low <= self.high:
            self.low = self.high = 1
        if not self.logarithmic:
            self.high = self.high if self.high > self.low else self.low + 1
            self.high = self.step() * ceil(self.high / self.step() - 1e-9)
            return
        if self.high / self.low > 1000:
            self.low, self.high = 10.0 ** floor(log10(self.low)), 10.0 ** ceil(log10(self.high))
        else:
            self.low, self.high = round_to_125(self.low, False), round_to_125(self.high, True)
        self.high = self.high if self.high > self.low else 10 * self.low

    def lay(self, start, end):
        """From one pixel to another."""
        band = math.copysign(BAND, end - start) if self.floor > 0 else 0
        self.start, self.end, self.below = start + band, end, start + band / 2

    def place(self, value):
        """The pixel of a value."""
        if value < self.floor:
            return self.below
        low, high, at = (log10(x) if self.logarithmic else x for x in (self.low, self.high, value))
        return self.start + (self.end - self.start) * (at - low) / (high - low)

    def ticks(self):
        if self.logarithmic:
            first, last = floor(log10(self.low) + 1e-9), ceil(log10(self.high) - 1e-9)
            fine = self.high / self.low < 6
            leads = [1] if last - first > 3 else [1, 2, 3, 4, 5, 6, 8] if fine else [1, 2, 5]
            decades = range(first, last + 1, 2 if last - first > 8 else 1)
            values = [lead * 10.0**decade for decade in decades for lead in leads]
        else:
            values = [self.step() * (ceil(self.low / self.step() - 1e-9) + i) for i in range(64)]
        return [
            value
            for value in values
            if self.low * (1 - 1e-9) - 1e-12 <= value <= self.high * (1 + 1e-9)
            and (self.floor == 0 or value > self.floor * 1.01)
        ]


class Point:
    """tail: where a thin line from the point ends, on the y axis; NAN: none. label: written beside the point."""

    def __init__(self, x, y, tail=nan, title=None, label=""):
        self.x, self.y, self.tail, self.title, self.label = x, y, tail, title, label


class Series:
    """style: the number of a colour and a mark. line: points are joined. Points that are not numbers are left out."""

    def __init__(self, name, style, line, points=()):
        self.name, self.style, self.line = name, style, line
        self.points = [point for point in points if isfinite(point.x) and isfinite(point.y)]


class Plot:
    """series: what is drawn, the first on top. mark: a dashed line across at this y, with its name."""

    def __init__(self, title, x, y, series, mark=nan, mark_name="", kind="plot"):
        self.title, self.x, self.y, self.series, self.kind = title, x, y, series, kind
        self.mark, self.mark_name = mark, mark_name
        for point in self.points():
            x.widen(point.x)
            y.widen(point.y)
            y.widen(point.tail)
        y.widen(mark)

    def points(self):
        return [point for series in self.series for point in series.points]

    def lay(self):
        self.x.lay(LEFT, WIDTH - RIGHT)
        self.y.lay(HEIGHT - BOTTOM, TOP)

    def at(self, point):
        return self.x.place(point.x), self.y.place(point.y)


class Labels:
    """Places labels near what they name: of many places around it the one that hides least of what is taken."""

    def __init__(self):
        self.taken = []

    def take(self, left, top, width, height, weight):
        self.taken.append((left, top, width, height, weight))

    def cost(self, left, top, width, height):
        inside = left >= LEFT and top >= TOP and left + width <= WIDTH - RIGHT and top + height <= HEIGHT - BOTTOM
        sum = 0 if inside else 1e6
        for other_left, other_top, other_width, other_height, weight in self.taken:
            shared_x = min(left + width + 3, other_left + other_width) - max(left - 3, other_left)
            shared_y = min(top + height + 3, other_top + other_height) - max(top - 3, other_top)
            if shared_x > 0 and shared_y > 0:
                sum += weight * shared_x * shared_y
        return sum

    def place(self, x, y, width, height, nearest):
        """nearest: from the anchor to the middle of the label. Returns its left and top."""

        def price(place):
            return self.cost(place[0], place[1], width, height) + place[2] * 4

        places = []
        for ring in range(12):
            distance = nearest + 10 * ring
            for i in range(24):
                angle = 2 * math.pi * i / 24
                left = x + (distance + width / 2 - height / 2) * math.cos(angle) - width / 2
                places.append((left, y - distance * math.sin(angle) - height / 2, distance))
        left, top, _ = min(places, key=price)
        self.take(left, top, width, height, 20)
        return left, top


def figure(kind, title, width, height, drawn, legend=""):
    title = escaped(title)
    return (
        f'<figure class="{kind}">\n<figcaption>{title}</figcaption>\n'
        f'<svg viewBox="0 0 {width} {height}" role="img" aria-label="{title}">\n{drawn}</svg>\n{legend}</figure>\n'
    )


def x_axis(axis):
    drawn = ""
    for value in axis.ticks():
        x = axis.place(value)
        drawn += f'<path class="grid" d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
        drawn += svg_text(x, HEIGHT - BOTTOM + 18, svg_number(value))
    return drawn + x_label(axis)


def x_label(axis):
    return svg_text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10, escaped(axis.label))


def y_axis(axis):
    drawn = ""
    for value in axis.ticks():
        y = axis.place(value)
        drawn += f'<path class="grid" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>'
        drawn += svg_text(LEFT - 8, y + 4.5, svg_number(value), "end")
    if axis.floor > 0:
        drawn += svg_rectangle("band", LEFT, axis.below - BAND / 2, WIDTH - LEFT - RIGHT, BAND)
        drawn += svg_text(LEFT - 8, axis.below + 4.5, "&lt; " + svg_number(axis.floor), "end")
    middle = (TOP + HEIGHT - BOTTOM) / 2
    turned = f'<text text-anchor="middle" transform="translate(15 {middle:.1f}) rotate(-90)">'
    return f"{drawn}{turned}{escaped(axis.label)}</text>\n"


def mark(style, x, y):
    """Circle, square, triangle, diamond, cross, ring, in turn."""
    circle = x - 5, y, "a5 5 0 1 0 10 0a5 5 0 1 0 -10 0"
    shapes = (
        circle,
        (x - 4.5, y - 4.5, "h9v9h-9z"),
        (x, y - 5.5, "l5.5 9.5h-11z"),
        (x, y - 6, "l6 6l-6 6l-6 -6z"),
        (x - 4.5, y - 4.5, "l9 9m0 -9l-9 9"),
        circle,
    )
    start_x, start_y, path = shapes[style % 6]
    kind = "mark open" if style % 6 > 3 else "mark"
    return f'<path class="s{style} {kind}" d="M{start_x:.1f} {start_y:.1f}{path}"/>'


def legend(plot, bars):
    """bars: a swatch for each series instead of its mark."""
    items = ""
    for series in plot.series:
        if series.points:
            line = f'<path class="s{series.style} line" d="M0 8H24"/>' if series.line else ""
            shown = svg_rectangle(f"s{series.style} bar", 6, 2, 12, 12) if bars else mark(series.style, 12, 8)
            items += f'<li><svg viewBox="0 0 24 16" width="24" height="16">{line}{shown}</svg>'
            items += f"{escaped(series.name)}</li>\n"
    return f'<ul class="legend">{items}</ul>\n'


def mark_name_left(plot):
    """Where the name of the line across begins: at the left end, or at the right if a point is in its way."""
    for point in plot.points():
        x, y = plot.at(point)
        if x < LEFT + NAME_WIDTH + 6 and abs(y - plot.y.place(plot.mark) + 8) < 20:
            return WIDTH - RIGHT - NAME_WIDTH
    return LEFT


def draw_labels(plot, letter, height):
    """Beside their points, clear of points and lines and of each other."""
    labels = Labels()
    for series in plot.series:
        before = None
        for point in series.points:
            x, y = plot.at(point)
            labels.take(x - 6, y - 6, 12, 12, 10)
            if series.line and before:
                steps = int(math.dist(before, (x, y)) / 12) + 1
                for share in ((i + 0.5) / steps for i in range(steps)):
                    at_x, at_y = (a + share * (b - a) for a, b in zip(before, (x, y)))
                    labels.take(at_x - 3, at_y - 3, 6, 6, 3)
            before = x, y
    if isfinite(plot.mark):
        labels.take(mark_name_left(plot), plot.y.place(plot.mark) - 18, NAME_WIDTH, 18, 10)
    drawn = ""
    for series in plot.series:
        for point in series.points:
            if point.label:
                width = letter * len(point.label) + 2
                left, top = labels.place(*plot.at(point), width, height, height / 2 + 5)
                place = left + width / 2, top + 0.83 * height
                drawn += svg_text(*place, escaped(point.label), kind=f"s{series.style} label")
    return drawn


def draw_points(plot, letter=8, height=12):
    """letter, height: of the labels."""
    plot.x.round_ends()
    plot.y.round_ends()
    plot.lay()
    drawn = x_axis(plot.x) + y_axis(plot.y)
    if isfinite(plot.mark):
        y = plot.y.place(plot.mark)
        drawn += f'<path class="reference" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>'
        drawn += svg_text(mark_name_left(plot) + 4, y - 5, plot.mark_name, "start", "small")
    for series in reversed(plot.series):
        if series.line:
            points = " ".join("%.1f,%.1f" % plot.at(point) for point in series.points)
            drawn += f'<polyline class="s{series.style} line" points="{points}"/>\n'
        for point in series.points:
            x, y = plot.at(point)
            drawn += f"<g><title>{escaped(point.title or series.name)}: {point.x:.4g}, {point.y:.4g}</title>"
            if isfinite(point.tail):
                end = plot.y.place(point.tail)
                drawn += f'<path class="s{series.style} tail" d="M{x:.1f} {y:.1f}V{end:.1f}m-3 0h6"/>'
            drawn += mark(series.style, x, y) + "</g>\n"
    drawn += draw_labels(plot, letter, height)
    return figure(plot.kind, plot.title, WIDTH, HEIGHT, drawn, "" if plot.kind == "opening" else legend(plot, False))


def draw_bars(plot):
    """Bars from 0, side by side; x are small integers."""
    plot.y.widen(0)
    plot.y.round_ends()
    plot.x.low -= 0.5
    plot.x.high += 0.5
    plot.lay()
    width = 0.8 * (plot.x.place(1) - plot.x.place(0)) / len(plot.series)
    drawn = x_axis(plot.x) + y_axis(plot.y)
    for i, series in enumerate(plot.series):
        for point in series.points:
            x, y = plot.at(point)
            title = f"><title>{escaped(series.name)}, {point.x:g}: {point.y:.3g}</title></rect>\n"
            left = x + width * (i - len(plot.series) / 2)
            drawn += svg_rectangle(f"s{series.style} bar", left, y, width, plot.y.place(0) - y, title)
    return figure(plot.kind, plot.title, WIDTH, HEIGHT, drawn, legend(plot, True))


def draw_stacks(plot, names):
    """Bars of 0 to 100, one for each name: a stack of the points of all series, with the shares that have room."""
    plot.y.widen(0)
    plot.y.widen(100)
    plot.y.round_ends()
    plot.lay()
    drawn = y_axis(plot.y) + x_label(plot.x)
    step = (WIDTH - LEFT - RIGHT) / len(names)
    for k, name in enumerate(names):
        left, below = LEFT + step * (k + 0.15), 0
        for series in plot.series:
            share = series.points[k].y
            top = plot.y.place(below + share)
            height = plot.y.place(below) - top
            title = f"><title>{escaped(series.name)}: {share:.1f} %</title></rect>\n"
            drawn += svg_rectangle(f"s{series.style} bar", left, top, 0.7 * step, height, title)
            if height >= 14:
                drawn += svg_text(left + 0.35 * step, top + height / 2 + 4.5, f"{share:.0f}", kind="onbar")
            below += share
        drawn += svg_text(left + 0.35 * step, HEIGHT - BOTTOM + 18, escaped(name))
    return figure(plot.kind, plot.title, WIDTH, HEIGHT, drawn, legend(plot, True))


def draw_map(title, x_label, columns, rows):
    """A cell for each row and column, the redder the nearer it is to 1: rows of a name and cells.

    A cell is a share of 0 to 1 and the text in it; NAN: there is none.
    """
    left, width, row = 150, 690, 20
    column = (width - left - 4) / len(columns)
    height = 2 + row * len(rows) + 46
    drawn = ""
    for i, (name, cells) in enumerate(rows):
        y = 2 + row * i
        drawn += svg_text(left - 8, y + 14.5, escaped(name), "end", "small")
        for k, (share, shown) in enumerate(cells):
            if isfinite(share):
                place = left + column * k, y, column - 1, row - 1
                drawn += svg_rectangle("cell", *place) + "\n"
                drawn += svg_rectangle("hot", *place, f' fill-opacity="{0.85 * math.sqrt(share):.2f}"/>\n')
                drawn += svg_text(place[0] + (column - 1) / 2, y + 14, shown, kind="tiny")
    for k, name in enumerate(columns):
        drawn += svg_text(left + column * (k + 0.5), height - 30, name, kind="tiny")
    drawn += svg_text((left + width) / 2, height - 8, escaped(x_label))
    return figure("map", title, width, height, drawn)
