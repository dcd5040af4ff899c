"""Drawings of lab 04's boxes: what they are, and how kernels build a tree of them."""
from drawing import BLUE, Drawing, GOLD, GREEN, INK, PALE, PURPLE, RED


# --- space or triangles --------------------------------------------------------------------------

def kd_or_boxes(target):
    """Four triangles in two cells, and in two boxes."""
    triangles = [((0.6, 0.8), (2.2, 0.5), (1.4, 2.4)), ((1.0, 3.0), (3.2, 2.6), (2.0, 4.4)),
                 ((2.6, 0.6), (5.8, 1.4), (3.9, 2.7)), ((5.2, 2.6), (7.2, 3.4), (5.8, 4.5))]
    d = Drawing(760, 290)
    scale, top = 42, 60

    def place(x, y, left):
        return left + x * scale, top + (5 - y) * scale

    def draw(left):
        for k, corners in enumerate(triangles):
            points = [place(*p, left) for p in corners]
            d.path("M" + "L".join(f"{x:g} {y:g}" for x, y in points) + "z", fill=PALE[BLUE])
            x, y = (sum(c) / 3 for c in zip(*points))
            d.text(x, y + 5, k, bold=True)

    left = 20
    d.text(left, 24, "KD-tree: space is cut", "start", bold=True)
    plane = 4.6
    cells = [[k for k, t in enumerate(triangles) if min(x for x, _ in t) < plane],
             [k for k, t in enumerate(triangles) if max(x for x, _ in t) > plane]]
    d.box(left, top, 8 * scale, 5 * scale)
    draw(left)
    d.line(*place(plane, 0, left), *place(plane, 5, left), RED, 2.5)
    for side, numbers in enumerate(cells):
        d.text(left + (2 + 4 * side) * scale, 50, "cell: " + " ".join(map(str, numbers)), size=13,
               colour=RED)

    left = 404
    d.text(left, 24, "Boxes: the triangles are parted", "start", bold=True)
    draw(left)
    for numbers, colour in (((0, 1), GREEN), ((2, 3), PURPLE)):
        points = [p for k in numbers for p in triangles[k]]
        x0, y0 = (min(c) for c in zip(*points))
        x1, y1 = (max(c) for c in zip(*points))
        x, y = place(x0, y1, left)
        d.box(x, y, (x1 - x0) * scale, (y1 - y0) * scale, "none", colour)
        d.text(x + (x1 - x0) * scale / 2 + (0 if numbers[0] == 0 else 20), 50,
               "box: " + " ".join(map(str, numbers)), size=13, colour=colour)
    d.save(target)


# --- along the Morton curve ----------------------------------------------------------------------

def morton(x, y, bits):
    code = 0
    for k in reversed(range(bits)):
        code = code << 2 | (x >> k & 1) << 1 | y >> k & 1
    return code


def morton_order(target):
    """The curve in two dimensions, three bits each; x first, as in lbvh/morton.h."""
    d = Drawing(760, 390)
    left, top, w, bits = 70, 24, 40, 3
    n = 1 << bits
    order = sorted(((x, y) for x in range(n) for y in range(n)), key=lambda p: morton(*p, bits))

    def middle(x, y):
        return left + (x + 0.5) * w, top + (n - 1 - y + 0.5) * w

    for x in range(n):
        for y in range(n):
            quarter = morton(x, y, bits) >> 2 * bits - 2
            d.box(left + x * w, top + (n - 1 - y) * w, w, w,
                  [PALE[BLUE], PALE[GREEN], PALE[GOLD], PALE[RED]][quarter], "#bbbbbb")
    points = [middle(*p) for p in order]
    d.path("M" + "L".join(f"{x:g} {y:g}" for x, y in points), INK, 2)
    for x in range(n):
        d.text(left + (x + 0.5) * w, top + n * w + 18, f"{x:03b}", size=12)
        d.text(left - 8, middle(0, x)[1] + 4, f"{x:03b}", "end", size=12)
    d.text(left + n * w / 2, top + n * w + 38, "x", bold=True)
    d.text(left - 46, top + n * w / 2, "y", bold=True)
    chosen = (5, 3)
    x, y = middle(*chosen)
    d.circle(x, y, 7, RED, RED)
    tx = left + n * w + 36
    d.text(tx, 46, f"The cell x = {chosen[0]:03b}, y = {chosen[1]:03b}", "start", bold=True)
    d.text(tx, 70, "bits in turns:  x2 y2 x1 y1 x0 y0", "start")
    code = f"{morton(*chosen, bits):06b}"
    for k, bit in enumerate(code):
        d.box(tx + 36 * k, 84, 36, 30, PALE[BLUE] if k % 2 == 0 else PALE[GOLD])
        d.text(tx + 36 * k + 18, 104, bit, bold=True)
    d.text(tx, 136, f"= {morton(*chosen, bits)}: {morton(*chosen, bits)} cells come before it",
           "start")
    for k, (words, fill) in enumerate((("codes 00....: the lower left quarter", BLUE),
                                       ("codes 01....: the upper left", GREEN),
                                       ("codes 10....: the lower right", GOLD),
                                       ("codes 11....: the upper right", RED))):
        d.box(tx, 170 + 26 * k, 16, 16, PALE[fill])
        d.text(tx + 26, 183 + 26 * k, words, "start", size=13)
    d.text(tx, 300, "The first bit halves the scene in x, the second", "start", size=13)
    d.text(tx, 318, "halves each half in y: sorting by code sorts", "start", size=13)
    d.text(tx, 336, "the cells into a tree.", "start", size=13)
    d.save(target)


KEYS = [0b00001, 0b00010, 0b00100, 0b00101, 0b10011, 0b11000, 0b11001, 0b11110]


def shared_bits(i, j, bits=5):
    if not 0 <= j < len(KEYS):
        return -1
    return bits - (KEYS[i] ^ KEYS[j]).bit_length()


def karras_node(i):
    """First, last, split of inner node i; as karras_node() in lbvh/karras.h, by plain search."""
    step = 1 if shared_bits(i, i + 1) > shared_bits(i, i - 1) else -1
    outside = shared_bits(i, i - step)
    end = i
    while shared_bits(i, end + step) > outside:
        end += step
    first, last = min(i, end), max(i, end)
    common = shared_bits(first, last)
    split = max(k for k in range(first, last) if shared_bits(first, k) > common or k == first)
    return first, last, split


def tree_over(first, last):
    """The ranges of a radix tree, from the top down: what karras_node() must agree with."""
    if first == last:
        return set()
    common = shared_bits(first, last)
    split = max(k for k in range(first, last) if k == first or shared_bits(first, k) > common)
    return {(first, last, split)} | tree_over(first, split) | tree_over(split + 1, last)


def karras(target):
    """Eight sorted codes, and the range and split of each of the seven inner nodes."""
    nodes = [karras_node(i) for i in range(len(KEYS) - 1)]
    assert set(nodes) == tree_over(0, len(KEYS) - 1) and nodes[0][:2] == (0, len(KEYS) - 1)
    depth = {}

    def lay(i, level):
        depth[i] = level
        first, last, split = nodes[i]
        if split != first:
            lay(split, level + 1)
        if split + 1 != last:
            lay(split + 1, level + 1)

    lay(0, 0)
    d = Drawing(760, 360)
    left, w, top, row = 30, 88, 26, 52
    for i, (first, last, split) in enumerate(nodes):
        y = top + row * depth[i]
        x0, x1 = left + first * w, left + (last + 1) * w - 8
        d.box(x0, y, x1 - x0, 38, PALE[BLUE])
        cut = left + (split + 1) * w - 4
        d.line(cut, y, cut, y + 38, RED, 2, "4 3")
        at = left + i * w + (w - 8) / 2
        d.node(at, y + 19, i, "white", 15)
        common = shared_bits(first, last)
        words = f"{KEYS[first]:05b}"[:common] + "..." if common else "nothing"
        goes = 1 if i == first else -1
        d.arrow(at + 16 * goes, y + 19, at + 40 * goes, y + 19)
        d.text(at + w * goes, y + 24, words, size=12)
    y = top + row * 4 + 12
    for k, key in enumerate(KEYS):
        d.box(left + k * w, y, w - 8, 30, PALE[GOLD])
        d.text(left + k * w + (w - 8) / 2, y + 20, f"{key:05b}", mono=True)
        d.text(left + k * w + (w - 8) / 2, y + 48, f"triangle {k}", size=12)
        if k:
            d.text(left + k * w - 4, y + 72, shared_bits(k - 1, k), size=13, bold=True)
    d.text(left, y + 92, "bits that neighbours share", "start", size=12)
    d.save(target)
    return nodes


def refit(target):
    """Four leaves, four threads: who goes on and who ends."""
    d = Drawing(760, 270)
    xs = [90, 210, 330, 450]
    inner = {"left": (150, 140), "right": (390, 140), "root": (270, 50)}
    # Who arrives first, and who second.
    order = {"left": (1, 0), "right": (2, 3), "root": ("right", "left")}
    for k, x in enumerate(xs):
        d.leaf(x, 230, f"thread {k}", PALE[GOLD], 84, 28)
        x1, y1 = inner["left" if k < 2 else "right"]
        second = order["left" if k < 2 else "right"][1] == k
        d.arrow(x, 214, x1 + (-14 if x < x1 else 14), y1 + 24, GREEN if second else RED, 2,
                "" if second else "5 4")
    for name in ("left", "right"):
        x, y = inner[name]
        x1, y1 = inner["root"]
        second = order["root"][1] == name
        d.arrow(x, y - 20, x1 + (-20 if x < x1 else 20), y1 + 22, GREEN if second else RED, 2,
                "" if second else "5 4")
    for name, (x, y) in inner.items():
        d.box(x - 58, y - 20, 116, 42, PALE[BLUE])
        d.text(x, y - 3, "root" if name == "root" else "node", size=13)
        d.text(x, y + 14, "arrived: 0, 1, 2", size=12)
    tx = 530
    d.line(tx, 60, tx + 40, 60, RED, 2, "5 4")
    d.text(tx + 50, 65, "arrives first, reads 0:", "start", size=13)
    d.text(tx + 50, 83, "writes its box and ends", "start", size=13)
    d.line(tx, 130, tx + 40, 130, GREEN, 2)
    d.text(tx + 50, 135, "arrives second, reads 1:", "start", size=13)
    d.text(tx + 50, 153, "both boxes are there, so it", "start", size=13)
    d.text(tx + 50, 171, "takes their union up", "start", size=13)
    d.save(target)


DRAWINGS = {"kd_or_boxes": kd_or_boxes, "morton_order": morton_order, "karras": karras,
            "refit": refit}
