"""Drawings of boxes, arrows and words as SVG, with the standard library only.

Every drawing has a white background of its own, so that it can be read on a dark page too.
"""
import html

from plot import COLOURS, INK

RED, BLUE, GREEN, GOLD, PURPLE = COLOURS
PALE = {RED: "#f6d5d1", BLUE: "#cfe3f3", GREEN: "#cfe9d8", GOLD: "#f4e6bd", PURPLE: "#ded6ec"}
GREY = "#e8e8e8"


class Drawing:
    """x grows to the right and y down, both in pixels."""

    def __init__(self, width, height):
        self.width, self.height, self.parts, self.heads = width, height, [], set()

    def box(self, x, y, width, height, fill="white", stroke=INK, dash="", radius=0):
        self.parts.append(
            f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" fill="{fill}"'
            + f' stroke="{stroke}"' + (f' stroke-dasharray="{dash}"' if dash else "")
            + (f' rx="{radius}"' if radius else "") + "/>")

    def circle(self, x, y, radius, fill="white", stroke=INK):
        self.parts.append(f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" fill="{fill}" '
                          f'stroke="{stroke}"/>')

    def text(self, x, y, words, anchor="middle", colour=INK, size=14, bold=False, mono=False):
        """y is the line on which the words stand."""
        self.parts.append(
            f'<text x="{x:g}" y="{y:g}"'
            + (f' text-anchor="{anchor}"' if anchor != "middle" else "")
            + (f' fill="{colour}"' if colour != INK else "")
            + (f' font-size="{size}"' if size != 14 else "")
            + (' font-weight="bold"' if bold else "")
            + (' font-family="monospace"' if mono else "") + f">{html.escape(str(words))}</text>")

    def path(self, d, colour=INK, width=1.5, dash="", arrow=False, fill="none"):
        if arrow:
            self.heads.add(colour)
        self.parts.append(
            f'<path d="{d}" fill="{fill}" stroke="{colour}" stroke-width="{width}"'
            + (f' stroke-dasharray="{dash}"' if dash else "")
            + (f' marker-end="url(#head{colour[1:]})"' if arrow else "") + "/>")

    def line(self, x1, y1, x2, y2, colour=INK, width=1.5, dash="", arrow=False):
        self.path(f"M{x1:g} {y1:g}L{x2:g} {y2:g}", colour, width, dash, arrow)

    def arrow(self, x1, y1, x2, y2, colour=INK, width=1.5, dash=""):
        self.line(x1, y1, x2, y2, colour, width, dash, True)

    def cells(self, x, y, values, width=34, height=28, fills=None, size=14, mono=False):
        """A row of boxes with a value in each; fills: a colour for each, or one for all."""
        for k, value in enumerate(values):
            fill = fills[k] if isinstance(fills, list) else fills or "white"
            self.box(x + k * width, y, width, height, fill)
            if value != "":
                self.text(x + (k + 0.5) * width, y + height / 2 + size * 0.36, value, size=size,
                          mono=mono)

    def node(self, x, y, words, fill="white", radius=15, size=13):
        self.circle(x, y, radius, fill)
        self.text(x, y + size * 0.36, words, size=size)

    def leaf(self, x, y, words, fill="white", width=28, height=24, size=13):
        self.box(x - width / 2, y - height / 2, width, height, fill)
        self.text(x, y + size * 0.36, words, size=size)

    def save(self, path):
        heads = "".join(
            f'<marker id="head{colour[1:]}" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" '
            f'markerHeight="8" markerUnits="userSpaceOnUse" orient="auto">'
            f'<path d="M0 0L10 5L0 10z" fill="{colour}"/></marker>'
            for colour in sorted(self.heads))
        w, h = self.width, self.height
        path.write_text("\n".join(
            [f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" '
             f'viewBox="0 0 {w} {h}" font-family="sans-serif" font-size="14" text-anchor="middle" '
             f'fill="{INK}">',
             f'<rect width="{w}" height="{h}" fill="white"/>']
            + ([f"<defs>{heads}</defs>"] if heads else []) + self.parts + ["</svg>"]) + "\n")
