"""The figures of a run of gjk-bench as tables of text and as a page: report.py RUN.csv PAGE.html [SCENES.csv]

RUN.csv has rows of family, query, method, measure, at and value, SCENES.csv the figures of scene-bench. The page is one
HTML file that needs nothing else.
"""

import math
import pathlib
import sys
from math import exp, isfinite, isnan, log, nan

from plot import Axis, Plot, Point, Series, draw_bars, draw_map, draw_points, draw_stacks, escaped

ERROR_FLOOR = 1e-4  # errors below this, in LSB, are drawn in the band of 0
ITERATIONS_MAX = 24


def number(text):
    try:
        return float(text)
    except ValueError:
        return nan


def divide(a, b):
    return a / b if b else nan


def refuse(message):
    print(message, file=sys.stderr)
    sys.exit(2)


class Table:
    """The rows of a run. families, queries, methods, series: their names, in the order in which they first occur."""

    HEADER = "family,query,method,measure,at,value"

    def __init__(self, name):
        self.rows = {}
        self.families, self.queries, self.methods, self.series = names = {}, {}, {}, {}
        lines = pathlib.Path(name).read_text().splitlines()
        if lines[:1] != [self.HEADER] or len(lines) == 1:
            refuse(f"{name}: expected {self.HEADER}")
        for line in lines[1:]:
            if line.count(",") < 5:
                refuse(f"{name}: expected six fields: {line}")
            *key, at, text = line.split(",", 5)
            self.rows.setdefault(tuple(key), []).append((at, text))
            for of, value in zip(names, [*key[:3], text if key[3] == "series" else ""]):
                if value:
                    of[value] = None
        self.own = next(iter(self.methods))  # all others are compared with it

    def text(self, *key):
        """Of family, query, method and measure, any of which may be empty: the first row's."""
        return self.rows[key][0][1] if key in self.rows else ""

    def get(self, *key):
        return number(self.text(*key))

    def ratio(self, family, query, method, measure):
        """In parts of the first method's."""
        return divide(self.get(family, query, method, measure), self.get(family, query, self.own, measure))

    def histogram(self, query, method, measure, families=None):
        """The sums of a measure by its `at`."""
        sums = {}
        for family in families or self.families:
            for at, text in self.rows.get((family, query, method, measure), ()):
                sums[int(at)] = sums.get(int(at), 0) + number(text)
        return sums

    def mean(self, family, query, method, measure):
        """Of a measure that was counted by its `at`."""
        counts = self.histogram(query, method, measure, [family])
        return divide(sum(at * count for at, count in counts.items()), sum(counts.values()))

    def asked(self, query, method=None):
        """The families whose pairs a method, or any, was asked about."""
        return [family for family in self.families if (family, query, method or self.own, "pairs") in self.rows]

    def series_of(self, method):
        """The number of its series, and the place of the method in it."""
        at, name = self.rows["", "", method, "series"][0]
        return list(self.series).index(name), int(at or 0)

    def stopped(self, series):
        """Are there several settings of a method that stops early? Such a method decides nothing until it is sure."""
        return sum(self.text("", "", method, "series") == series for method in self.methods) > 1

    def whole(self):
        """The methods that are asked for whole answers, each with the number of its series."""
        return {
            method: self.series_of(method)[0]
            for method in self.methods
            if not self.stopped(self.text("", "", method, "series"))
        }


# The columns of the table of a family and a query, which has a row for each method: heading, format, measure, and how
# it is found.
COLUMNS = (
    ("ns", "%.0f", "time", Table.get),
    ("x gjk", "%.2f", "time", Table.ratio),
    ("instructions", "%.0f", "instructions", Table.get),
    ("iterations", "%.1f", "iterations", Table.mean),
    ("wrong", "%.0f", "wrong", Table.get),
    ("undecided", "%.0f", "undecided", Table.get),
    ("failed", "%.0f", "failed", Table.get),
    ("apart", "%.0f", "says_apart", Table.get),
    ("too small", "%.0f", "too_small", Table.get),
    ("too large", "%.0f", "too_large", Table.get),
    ("contacts", "%.2f", "contacts", Table.get),
    ("mean error", "%.3g", "error_mean", Table.get),
    ("largest error", "%.3g", "error_most", Table.get),
)


def tabulate(t, family, query, none):
    """The headings of the columns that have any value, and a row for each method, all as text."""
    methods = [method for method in t.methods if isfinite(t.get(family, query, method, "pairs"))]
    columns = []
    for heading, form, measure, get in COLUMNS:
        values = [get(t, family, query, method, measure) for method in methods]
        if any(map(isfinite, values)):
            columns.append([heading] + [form % value if isfinite(value) else none for value in values])
    rows = list(zip(*columns))
    return rows[0], list(zip(methods, rows[1:]))


class Standing:
    """A method over all families of a query that it was asked about; NAN: none."""

    def __init__(self, t, query, method):
        families = t.asked(query, method)

        def values(measure):
            return [t.get(family, query, method, measure) for family in families]

        pairs = values("pairs")
        self.logs = [log(t.ratio(family, query, method, "time")) for family in families]
        self.pairs, self.wrong = sum(pairs), sum(values("wrong"))
        self.undecided, self.outside = sum(values("undecided")), sum(values("outside"))
        self.time = geometric_mean(self.logs)
        self.share = divide(self.wrong, self.pairs)
        self.mean = divide(sum(map(math.prod, zip(pairs, values("error_mean")))), self.pairs)
        self.most = max((error for error in values("error_most") if isfinite(error)), default=nan)


def geometric_mean(logs):
    return exp(divide(sum(logs), len(logs)))


# The tables in plain text.


def text_tables(t):
    for family in t.families:
        for query in t.queries:
            if family in t.asked(query):
                headings, rows = tabulate(t, family, query, "-")
                print(f"\n{family}, {query}: {t.text(family, '', '', 'what')}")
                widths = [max(len(heading), 8) + 2 for heading in headings]
                for name, cells in [("", headings)] + rows:
                    print(f"{name:22}" + "".join(f"{cell:>{width}}" for cell, width in zip(cells, widths)))
    for query in t.queries:
        print(f"\nall families, {query}")
        print(f"{'':22}{'x gjk':>8}{'pairs':>9}{'wrong':>7}{'undecided':>11}{'most error':>12}{'outside':>9}")
        for method in t.methods:
            s = Standing(t, query, method)
            if s.pairs > 0:
                values = ("%8.2f", s.time), ("%9.0f", s.pairs), ("%7.0f", s.wrong), ("%11.0f", s.undecided)
                values += ("%12.3g", s.most), ("%9.0f", s.outside)
                shown = (form % value if isfinite(value) else "-".rjust(len(form % 0)) for form, value in values)
                print(f"{method:22}" + "".join(shown))
    print("""
x gjk: time against gjk cold (all families: geometric mean). Errors in LSB of 2^-16 unit, against the exact
real distance or depth. outside: true distances outside of bounds that were called proven. Depths are wrong when
more than 1 LSB and more than 1 % too small or too large, when the method failed or says that they are apart.""")


# The page opens with one chart and one table of all methods over all families.


def opening(t):
    queries = ("intersect", "distance", "depth")
    standings = {method: [Standing(t, query, method) for query in queries] for method in t.whole()}
    standings = {method: s for method, s in standings.items() if any(of.pairs for of in s)}
    series = []
    for method, s in standings.items():
        time = geometric_mean([value for of in s for value in of.logs])
        share = 100 * sum(of.wrong for of in s) / sum(of.pairs for of in s)
        series.append(Series(method, t.series_of(method)[0], False, [Point(time, share, label=method)]))
    least = min((point.y for s in series for point in s.points if point.y > 0), default=10)
    x = Axis("time a question, in parts of gjk's", True)
    y = Axis("wrong answers, %", True, 10.0 ** math.floor(math.log10(least)))
    y.widen(100)
    chart = draw_points(Plot("wrong answers against time", x, y, series, kind="opening"), letter=8.5, height=18)
    rows = ""
    for method, (touch, apart, deep) in standings.items():
        own = ' class="own"' if method == t.own else ""
        cells = [method, ratio_cell(touch.time), share_cell(touch.share)]
        cells += [ratio_cell(apart.time), share_cell(apart.share), error_cell(apart.mean), error_cell(apart.most)]
        cells += [ratio_cell(deep.time), share_cell(deep.share), error_cell(deep.most)]
        rows += f"<tr{own}>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>\n"
    return f"""<p>Each method over all families that it was asked about, easy and hard alike: how often it is wrong,
and what a question costs it. Left is faster, down is right.</p>
{chart}<div class="wide opening"><table>
<tr><th></th><th colspan="2">do they touch?</th><th colspan="4">how far apart?</th><th colspan="3">how deep?</th></tr>
<tr><th>method</th><th>time</th><th>wrong</th><th>time</th><th>wrong</th><th>mean error</th><th>largest</th>\
<th>time</th><th>wrong</th><th>largest error</th></tr>
{rows}</table></div>
<p class="note">Time: geometric mean over the families, in parts of that of gjk without a cache. Wrong: touching for
apart or the reverse; of a depth, more than 1 LSB and more than 1 % off, or none. Errors in LSB, 2<sup>-16</sup> unit;
a pair wrongly taken for touching counts with its whole gap.</p>
"""


def ratio_cell(value):
    return f"{value:.2f}" if isfinite(value) else "–"


def share_cell(share):
    if isnan(share):
        return "–"
    digits = 0 if share == 0 or share >= 0.0995 else 1 if share >= 0.00995 else 2
    return f"{100 * share:.{digits}f} %"


def error_cell(error):
    """To two digits."""
    if isnan(error):
        return "–"
    if error < 100:
        return "&lt; 0.001" if error < 0.001 else f"{error:.2g}"
    unit = 10 ** (math.floor(math.log10(error)) - 1)
    return f"{unit * round(error / unit):,.0f}"


# Its plots.


def against_time(t, family, query, measure, tail, y_label, floor):
    """A measure against the time, a point for each method. tail: the measure at which a line from the point ends."""
    of_pairs = measure == "wrong"
    series = []
    for style, name in enumerate(t.series):
        stopped = t.stopped(name)
        points = []
        for method in t.methods:
            if t.text("", "", method, "series") == name and not (of_pairs and stopped):
                share = divide(100, t.get(family, query, method, "pairs")) if of_pairs else 1
                value = share * t.get(family, query, method, measure)
                end = t.get(family, query, method, tail) if tail else nan
                label = str(t.series_of(method)[1]) if stopped else ""
                points.append(Point(t.get(family, query, method, "time"), value, end, method, label))
        series.append(Series(name, style, stopped, points))
    mark, mark_name = {"distance": (0.5, "½ LSB"), "contacts": (2, "2 LSB")}.get(query, (1, "1 LSB"))
    axes = Axis("time per query, ns", True), Axis(y_label, True, floor)
    return draw_points(Plot(f"{family}: {query}", *axes, series, nan if of_pairs else mark, mark_name))


def wrong_what(query):
    return "answers" if query in ("depth", "contacts") else "decisions"


def wrong_plots(t, query):
    """The families in which any method is wrong."""
    label = f"wrong {wrong_what(query)}, % of the pairs"
    return "".join(
        against_time(t, family, query, "wrong", None, label, 0.01)
        for family in t.families
        if any(t.get(family, query, method, "wrong") > 0 for method in t.methods)
    )


def error_plots(t, query):
    label = "error, LSB: largest (mark) to mean (line's end)"
    return "".join(
        against_time(t, family, query, "error_most", "error_mean", label, ERROR_FLOOR) for family in t.asked(query)
    )


def vertex_plot(t, query, measure, y_label):
    """A measure against the number of vertices of each shape, over the families of hulls."""
    hulls = [family for family in t.families if "hulls-" in family]
    series = []
    for method, style in t.whole().items():
        points = [Point(t.get(f, "", "", "vertices"), t.get(f, query, method, measure)) for f in hulls]
        series.append(Series(method, style, True, points))
    plot = Plot(f"hulls: {query}", Axis("vertices of each hull", True), Axis(y_label, True), series)
    return draw_points(plot) if plot.points() else ""


def iterations_plot(t, query):
    """How many queries take how many iterations, all families together."""
    series = []
    for method, style in t.whole().items():
        counts = {}
        for at, count in sorted(t.histogram(query, method, "iterations").items()):
            counts[min(at, ITERATIONS_MAX)] = counts.get(min(at, ITERATIONS_MAX), 0) + count
        if counts:
            total = sum(counts.values())
            points = [Point(at, 100 * count / total) for at, count in counts.items() if count > 0]
            series.append(Series(method, style, False, points))
    axes = Axis(f"iterations ({ITERATIONS_MAX} stands for more as well)"), Axis("queries, %")
    return draw_bars(Plot(f"all families: {query}", *axes, series)) if series else ""


def map_cell(wrong, undecided):
    """A share of wrong or undecided answers as it is written: in percent, at least 1."""
    if wrong > 0 or undecided == 0:
        return wrong, "%.0f" % (1 if 0 < wrong < 0.01 else 100 * wrong)
    return wrong, "?%.0f" % (100 * undecided) if undecided > 0 else ""


def gap_map(t, title, x_label, query, families=None):
    """Wrong answers by the gap at which the pairs were placed, or by the depth that they have."""
    gaps = sorted(t.histogram(query, t.own, "gap_pairs", families))
    rows = []
    for method in t.methods:
        pairs, wrong, undecided = (
            t.histogram(query, method, measure, families) for measure in ("gap_pairs", "gap_wrong", "gap_undecided")
        )
        if pairs:
            shares = [[divide(of.get(gap, 0), pairs.get(gap, 0)) for of in (wrong, undecided)] for gap in gaps]
            rows.append((method, [map_cell(*share) for share in shares]))
    return draw_map(title, x_label, gaps, rows) if rows else ""


def gap_maps(t):
    label = "gap that the pair was placed at, LSB (below 0: overlap)"
    return "".join(
        gap_map(t, f"{family}: {query}", label, query, [family]) for family in t.families for query in t.queries
        if query != "depth"
    )


def cost_plots(t):
    drawn = "".join(vertex_plot(t, query, "time", "time per query, ns") for query in t.queries)
    return drawn + "".join(vertex_plot(t, query, "instructions", "instructions per query") for query in t.queries)


# Its sections.


def section(heading, text, plots):
    return f'<h2>{heading}</h2>\n<p>{text}</p>\n<div class="plots">\n{plots}</div>\n'


MARKS = """Each method a mark, at its largest error; a thin line leads from there to its mean error. Errors below
10<sup>-4</sup> LSB, and 0, lie in the grey band. """
ERRORS = {
    "distance": """Numbers at gjk stopped early: the iterations, or the error in LSB, that it was allowed. A pair
that a method takes for touching counts with its whole gap.""",
    "depth": """Against the real least depth. Where a method gives no answer, or says apart, the whole depth counts.
gjk rounds up to the next LSB, so that a move by the depth parts the shapes: its error is up to 1
LSB by contract. Depths of pairs that are not proven least in exact integers are those of a facet
that the certificate names, while the reference in double knows of none that is lower by more than
the rounding.""",
    "contacts": "Of the deepest contact of a manifold of four points at most, against the real least depth.",
}
WRONG = {
    "answers": """The families in which any method is wrong; 0 lies in the grey band. Wrong: failed; says that the
shapes are apart; more than 1 LSB and more than 1 % too small or too large. The tables tell them apart.""",
    "decisions": """The families in which any method decides wrongly; 0 lies in the grey band. gjk stopped early decides
nothing that it has not proven: see the tables for what it leaves undecided.""",
}


def about(t):
    """What was measured, and how."""
    items = "".join(f"<li>{escaped(text)}</li>\n" for _, text in t.rows.get(("", "", "", "about"), ()))
    families = ""
    for family in t.families:
        exact = t.get(family, "", "", "exact")
        proven = f" ({exact:.0f} depths proven in exact integers)" if isfinite(exact) else ""
        families += f"<dt>{family}</dt><dd>{escaped(t.text(family, '', '', 'what'))}{proven}</dd>\n"
    return f"<h2>What was measured</h2>\n<ul>\n{items}</ul>\n<dl>\n{families}</dl>\n"


def html_table(t, family, query):
    headings, rows = tabulate(t, family, query, "–")
    head = "".join(f"<th>{heading}</th>" for heading in ("method", *headings))
    body = "".join(f"<tr><td>{escaped(m)}</td>{''.join(f'<td>{c}</td>' for c in cells)}</tr>\n" for m, cells in rows)
    table = f'<div class="wide"><table>\n<tr>{head}</tr>\n{body}</table></div>'
    return f"<div><h3>{family}: {query}</h3>\n{table}\n</div>\n"


def page(t, scenes):
    style = (pathlib.Path(__file__).parent / "style.css").read_text()
    body = opening(t) + about(t)
    for query, text in ERRORS.items():
        body += section(f"Error against time: {query}", MARKS + text, error_plots(t, query))
    for query in t.queries:
        what = wrong_what(query)
        body += section(f"Wrong {what} against time: {query}", WRONG[what], wrong_plots(t, query))
    body += section(
        "Wrong decisions against the gap",
        "Percent of the pairs of each gap that a method decides wrongly; ?n: percent that it leaves open, having "
        "been told to stop.",
        gap_maps(t),
    )
    body += section(
        "Wrong answers against the depth",
        "Percent of the pairs that overlap by so much whose depth a method gets wrong, over all families of depths.",
        gap_map(t, "all families: depth", "true depth, LSB: at most, and more than the one before", "depth"),
    )
    body += section(
        "Iterations",
        "How many iterations (support scans of both shapes) the queries took.",
        "".join(iterations_plot(t, query) for query in t.queries),
    )
    body += section(
        "Cost against the number of vertices", "Every method scans all vertices for a support point.", cost_plots(t)
    )
    if scenes:
        body += scene_sections(scenes)
    tables = "".join(html_table(t, f, query) for f in t.families for query in t.queries if f in t.asked(query))
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>gjk: time against error</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
{style}</style></head>
<body>
<h1>gjk: time against error</h1>
{body}<h2>All numbers</h2>
<p>x gjk: time against that of gjk cold. Errors in LSB (2<sup>-16</sup> unit) against the exact real distance or
depth.</p>
<div class="tables">
{tables}</div>
</body></html>
"""


# What the tick of a scene costs, and what saves it.

SCENE_LINES = (
    ("gjk whole tick ns", "gjk: whole tick, exact answers", 0),
    ("gjk broad phase ns", "gjk: posing and broad phase", 4),
    ("gjk posing ns", "gjk: posing alone", 11),
    ("all pairs ns", "boxes of all pairs", 7),
    ("Bullet ns", "Bullet btDbvtBroadphase", 6),
    ("FCL ns", "FCL DynamicAABBTree", 9),
)
SCENE_SHARES = (
    ("% resting", "neither side moved", 10),
    ("% motion", "moved less than was proven", 0),
    ("% boxes", "boxes or spheres apart", 1),
    ("% direction", "last direction still separates", 4),
    ("% warm", "queried, warm", 6),
    ("% cold", "queried, cold", 7),
)


def read_scenes(name):
    """A list of rows, each a dictionary by column; numbers, but for the scene's name."""
    header, *lines = [line.split(",") for line in pathlib.Path(name).read_text().splitlines()] or [[]]
    if header[:1] != ["scene"] or not lines or any(len(line) != len(header) for line in lines):
        refuse(f"{name}: expected the figures of scene-bench")
    return [{"scene": line[0], **dict(zip(header[1:], map(number, line[1:])))} for line in lines]


def scene_lines(name, rows):
    rows = [row for row in rows if row["percent moving"] == 5]
    series = [
        Series(shown, style, True, [Point(row["bodies"], row.get(column, nan) / 1000) for row in rows])
        for column, shown, style in SCENE_LINES
    ]
    axes = Axis("bodies", True), Axis("CPU time per tick, µs", True)
    return draw_points(Plot(f"{name}: 5 % of the bodies moving", *axes, series))


def scene_shares(name, rows):
    rows = [row for row in rows if row["bodies"] == 10000 and row["gjk pairs"] > 0]
    series = [
        Series(shown, style, False, [Point(at, row[column]) for at, row in enumerate(rows)])
        for column, shown, style in SCENE_SHARES
    ]
    names = [f"{row['percent moving']:.0f} % ({row['gjk pairs']:.0f})" for row in rows]
    axes = Axis("bodies moving (pairs whose boxes met)"), Axis("pairs, %")
    return draw_stacks(Plot(f"{name}: 10000 bodies", *axes, series), names) if rows else ""


def scene_sections(scenes):
    names = dict.fromkeys(row["scene"] for row in scenes)

    def plots(draw):
        return "".join(draw(name, [row for row in scenes if row["scene"] == name]) for name in names)

    return section(
        "Scenes: cost of a tick",
        "CPU time, medians over repetitions of 10 ticks; all methods replay the same motion in one process. gjk "
        "poses the bodies that moved and takes their boxes, which Bullet, FCL and the test of all pairs get ready "
        "made: posing alone is a line of its own. Only the whole tick answers, exactly, which bodies touch; "
        "everything else stops at the boxes. FCL finds all pairs anew in each tick; gjk and Bullet keep them.",
        plots(scene_lines),
    ) + section(
        "Scenes: what becomes of the pairs",
        "The pairs whose enlarged boxes met, by what settled them in a tick, cheapest first; only the last two kinds "
        "take a query. Under each bar the share of bodies that move, and how many pairs there were.",
        plots(scene_shares),
    )


def main():
    if len(sys.argv) not in (3, 4):
        refuse("usage: report.py RUN.csv PAGE.html [SCENES.csv]")
    t = Table(sys.argv[1])
    scenes = read_scenes(sys.argv[3]) if len(sys.argv) > 3 else None
    text_tables(t)
    pathlib.Path(sys.argv[2]).write_text(page(t, scenes))


main()
