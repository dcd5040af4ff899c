"""A small line plot as SVG, with the standard library only."""
import html
import math

COLOURS = ["#c0392b", "#1f6fb2", "#2e8b57", "#b8860b", "#6b4c9a"]
INK, GRID = "#333", "#ddd"


class Plot:
    """x and y: (first, last) of the axis. log: both axes are logarithmic."""

    def __init__(self, title, x_label, y_label, x, y, log=False, width=560, height=340):
        self.x, self.y, self.log = x, y, log
        self.left, self.right, self.top, self.bottom = 64, width - 150, 40, height - 52
        self.width, self.height = width, height
        self.parts = [f'<rect width="{width}" height="{height}" fill="white"/>']
        middle = (self.left + self.right) / 2
        self.text(middle, 22, title, "middle", size=14)
        self.text(middle, height - 14, x_label, "middle")
        across = (self.top + self.bottom) / 2
        self.parts.append(f'<g transform="rotate(-90 16 {across})">')
        self.text(16, across, y_label, "middle")
        self.parts.append("</g>")

    def place(self, x, y):
        def part(value, ends):
            if self.log:
                value, ends = math.log(value), [math.log(end) for end in ends]
            return (value - ends[0]) / (ends[1] - ends[0])
        return (self.left + part(x, self.x) * (self.right - self.left),
                self.bottom - part(y, self.y) * (self.bottom - self.top))

    def text(self, x, y, words, anchor="start", colour=INK, size=12):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}" '
                          f'font-size="{size}">{html.escape(words)}</text>')

    def line(self, a, b, colour=GRID, dash=""):
        (x1, y1), (x2, y2) = self.place(*a), self.place(*b)
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
                          f'stroke="{colour}" stroke-dasharray="{dash}"/>')

    def ticks(self, xs, ys, x_format="{:g}", y_format="{:g}"):
        for x in xs:
            self.line((x, self.y[0]), (x, self.y[1]))
            self.text(self.place(x, self.y[0])[0], self.bottom + 17, x_format.format(x), "middle")
        for y in ys:
            self.line((self.x[0], y), (self.x[1], y))
            self.text(self.left - 7, self.place(self.x[0], y)[1] + 4, y_format.format(y), "end")

    def curve(self, points, name, colour, dots=True, dash="", dy=0):
        """points: (x, y) pairs; the name, if any, stands beside the last, dy pixels lower."""
        places = [self.place(x, y) for x, y in points]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" '
                          f'stroke-width="2" stroke-dasharray="{dash}"/>')
        if dots:
            self.parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>'
                           for x, y in places]
        if name:
            self.text(places[-1][0] + 8, places[-1][1] + 4 + dy, name, colour=colour)

    def names(self, ends, gap=14):
        """ends: (last point, name, colour) of curves; names at the right edge, moved apart."""
        low = self.top
        for point, name, colour in sorted(ends, key=lambda end: -end[0][1]):
            x, y = self.place(*point)
            low = max(low, y)
            self.parts.append(f'<path d="M{x + 4:.1f} {y:.1f} L{self.right + 6:.1f} {low:.1f}" '
                              f'stroke="{colour}" stroke-opacity="0.4"/>')
            self.text(self.right + 9, low + 4, name, colour=colour)
            low += gap

    def save(self, path):
        save_beside(path, [self])


def save_beside(path, plots):
    """One picture of several plots, from left to right."""
    width, height = sum(plot.width for plot in plots), max(plot.height for plot in plots)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12" fill="{INK}">']
    x = 0
    for plot in plots:
        parts += [f'<g transform="translate({x} 0)">' if x else "<g>", *plot.parts, "</g>"]
        x += plot.width
    path.write_text("\n".join(parts + ["</svg>"]) + "\n")
