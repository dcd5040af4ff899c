"""Drawings of lab 04's hierarchies of boxes: how they are built and how rays walk through them."""
import random

from drawing import BLUE, Drawing, GOLD, GREEN, GREY, INK, PALE, PURPLE, RED


def packs(triangles):
    return -(-triangles // 8)


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
    order = {"left": (1, 0), "right": (2, 3), "root": ("right", "left")}  # who arrives first, second
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


# --- the heuristic over slices -------------------------------------------------------------------

def half_area(box):
    (x0, y0), (x1, y1) = box
    w, h, depth = x1 - x0, y1 - y0, 1  # one deep
    return w * h + h * depth + depth * w


def around(boxes):
    return (tuple(min(b[0][k] for b in boxes) for k in range(2)),
            tuple(max(b[1][k] for b in boxes) for k in range(2)))


def sah_slices(target):
    """48 triangles' boxes in 8 slices of the box of their centres, and the cost of the 7 planes."""
    numbers = random.Random(11)
    boxes = []
    for centre, spread, count in ((2.2, 0.8, 22), (5.4, 1.0, 16), (10.2, 0.9, 10)):
        for _ in range(count):
            x, y = numbers.gauss(centre, spread), numbers.uniform(0.5, 4.5)
            w, h = numbers.uniform(0.1, 0.5), numbers.uniform(0.1, 0.5)
            boxes.append(((x - w, y - h), (x + w, y + h)))
    bins = 8
    centres = [(b[0][0] + b[1][0]) / 2 for b in boxes]
    low, high = min(centres), max(centres)
    of = [min(bins - 1, int((c - low) / (high - low) * bins)) for c in centres]
    counts = [of.count(k) for k in range(bins)]
    sides = {k: ([b for b, s in zip(boxes, of) if s < k], [b for b, s in zip(boxes, of) if s >= k])
             for k in range(1, bins)}
    cost = {k: sum(half_area(around(s)) * packs(len(s)) for s in sides[k]) for k in sides}
    best = min(cost, key=cost.get)
    d = Drawing(760, 440)
    left, scale, top = 84, 51, 30
    x_min = min(b[0][0] for b in boxes) - 0.1

    def x_of(x):
        return left + (x - x_min) * scale

    def draw(box, fill, stroke):
        (x0, y0), (x1, y1) = box
        d.box(round(x_of(x0), 1), round(top + (5 - y1) * 36, 1), round((x1 - x0) * scale, 1),
              round((y1 - y0) * 36, 1), fill, stroke)

    for k, side in enumerate(sides[best]):
        draw(around(side), (PALE[GREEN], PALE[PURPLE])[k], (GREEN, PURPLE)[k])
    for box in boxes:
        draw(box, "white", "#666666")
    edge = [low + (high - low) * k / bins for k in range(bins + 1)]
    bottom = top + 5 * 36 + 10
    for k, x in enumerate(edge):
        d.line(x_of(x), top - 10, x_of(x), bottom + 26, RED if k == best else "#999999",
               2.5 if k == best else 1, "" if k == best else "3 3")
    for k in range(bins):
        d.text((x_of(edge[k]) + x_of(edge[k + 1])) / 2, bottom + 20, counts[k], size=13)
    d.text(left - 14, bottom + 20, "centres", "end", size=12)
    base, height = 410, 130
    most = max(cost.values())
    for k, c in cost.items():
        h = c / most * height
        d.box(x_of(edge[k]) - 16, base - h, 32, h, PALE[RED] if k == best else PALE[BLUE])
        d.text(x_of(edge[k]), base - h - 6, f"{c:.0f}", size=13, bold=k == best)
        d.text(x_of(edge[k]), base + 18, f"plane {k}", size=12)
    d.text(left - 14, base - 4, "cost", "end", size=12)
    d.save(target)
    return best, [len(s) for s in sides[best]], [packs(len(s)) for s in sides[best]], cost


# --- walks ---------------------------------------------------------------------------------------

# A small tree: inner nodes are numbers, leaves are letters. Which boxes the ray of the drawings
# crosses, and which child it wants first, is said here; the walks follow from it.
CHILDREN = {0: (1, 4), 1: ("a", 2), 2: ("b", 3), 3: ("c", "d"), 4: ("e", 5), 5: ("f", "g")}
PLACES = {0: (300, 40), 1: (180, 100), 4: (440, 100), "a": (110, 160), 2: (230, 160),
          "e": (390, 160), 5: (500, 160), "b": (180, 220), 3: (280, 220), "f": (470, 220),
          "g": (540, 220), "c": (240, 280), "d": (320, 280)}
CROSSED = {1, 2, 3, "b", "d", 4, "e"}
PARENT = {child: node for node, pair in CHILDREN.items() for child in pair}


def draw_tree(d, dx=0, dy=0, crossed=CROSSED):
    for node, pair in CHILDREN.items():
        for child in pair:
            (x0, y0), (x1, y1) = PLACES[node], PLACES[child]
            met = child in crossed
            d.line(x0 + dx, y0 + dy, x1 + dx, y1 + dy, INK if met else "#aaaaaa",
                   2.4 if met else 1.2, "" if met else "4 4")
    for name, (x, y) in PLACES.items():
        met = name == 0 or name in crossed
        if name in CHILDREN:
            d.node(x + dx, y + dy, name, PALE[BLUE] if met else "white")
        else:
            d.leaf(x + dx, y + dy, name, PALE[GOLD] if met else "white")


def skip_line():
    """As lay_skip_links(): (name, skip) depth first; the root is not among them."""
    line = []

    def append(name):
        self = len(line)
        line.append([name, 0])
        for child in CHILDREN.get(name, ()):
            append(child)
        line[self][1] = len(line)

    for child in CHILDREN[0]:
        append(child)
    return line


def skip_links(target):
    line = skip_line()
    walked, at = [], 0
    while at < len(line):
        walked.append(at)
        at = at + 1 if line[at][0] in CROSSED else line[at][1]
    d = Drawing(760, 560)
    draw_tree(d, 60)
    d.text(20, 24, "bold: the boxes that the ray crosses", "start", size=13)
    left, w, y = 20, 54, 400
    for k, (name, skip) in enumerate(line):
        inner = name in CHILDREN
        met = name in CROSSED
        x = left + k * w
        d.box(x, y, w - 6, 30, (PALE[BLUE] if inner else PALE[GOLD]) if met else "white")
        d.text(x + (w - 6) / 2, y + 20, name, bold=met)
        d.text(x + (w - 6) / 2, y + 46, k, size=12)
        if inner:
            x1, reach = left + skip * w + 12, skip - k
            d.path(f"M{x + 34} {y - 2}C{x + 34} {y - 16 - 9 * reach} {x1} {y - 16 - 9 * reach} "
                   f"{x1} {y - 2}", RED, 1.8, "5 4", True)
    x = left + len(line) * w
    d.text(x + 12, y + 20, "end", "start", size=13)
    d.text(left, 324, "the line, depth first; dashed: skip, where it leads past the next", "start",
           size=13)
    d.text(left, y + 78, f"The walk reads {len(walked)} of {len(line)} boxes:", "start", bold=True)
    for k, at in enumerate(walked):
        name = line[at][0]
        x = left + 20 + 52 * k
        met = name in CROSSED
        if k:
            d.arrow(x - 36, y + 108, x - 18, y + 108, INK if line[walked[k - 1]][0] in CROSSED else RED)
        if name in CHILDREN:
            d.node(x, y + 108, name, PALE[BLUE] if met else "white")
        else:
            d.leaf(x, y + 108, name, PALE[GOLD] if met else "white")
    d.text(left, y + 146, "white: missed, so the walk follows the skip link (red)", "start", size=12)
    d.save(target)
    return len(walked)


def parent_walk():
    """The nodes that walk_bvh_parent() reads, and from where it comes; near is the left child."""
    visits, node, came = [], 0, None
    while node is not None:
        visits.append((node, came))
        near, far = CHILDREN[node]
        wanted = near if came is None else far if came == near else None
        if wanted == near and near not in CROSSED:
            wanted = far
        if wanted is not None and wanted not in CROSSED:
            wanted = None
        if wanted is None:
            node, came = PARENT.get(node), node
        elif wanted in CHILDREN:
            node, came = wanted, None
        else:
            came = wanted
    return visits


def stack_walk():
    visits, stack = [], [0]
    while stack:
        node = stack.pop()
        if node not in CHILDREN:
            continue
        visits.append(node)
        stack += [c for c in reversed(CHILDREN[node]) if c in CROSSED]
    return visits


def parent_pointers(target):
    visits = parent_walk()
    d = Drawing(760, 456)
    draw_tree(d, 60)
    d.text(20, 24, "bold: the boxes that the ray crosses;", "start", size=13)
    d.text(20, 42, "near is left", "start", size=13)
    left, y = 20, 356
    d.text(left, y - 14, f"The walk reads a node {len(visits)} times; with a stack it would be "
           f"{len(stack_walk())}:", "start", bold=True)
    words = {}
    for k, (node, came) in enumerate(visits):
        x, row = left + 26 + 60 * (k % 12), y + 30 + 86 * (k // 12)
        colour = BLUE if came is None else GREEN if came == CHILDREN[node][0] else PURPLE
        d.node(x, row, node, PALE[colour])
        d.text(x, row + 34, "above" if came is None else f"from {came}", size=12)
        if k % 12 and k:
            d.arrow(x - 44, row, x - 16, row)
        words.setdefault(node, []).append(k)
    row = y + 30 + 86 * (-(-len(visits) // 12) - 1) + 62
    for k, (text, colour) in enumerate((("from above: the near child", BLUE),
                                        ("back from the near child: the far one", GREEN),
                                        ("back from the far child: up", PURPLE))):
        x = left + (0, 210, 480)[k]
        d.box(x, row, 14, 14, PALE[colour])
        d.text(x + 20, row + 12, text, "start", size=12)
    d.save(target)
    return len(visits), len(stack_walk())


def trail(target):
    """The trail's bits while the walk is at a node, and where it goes on."""
    crossed = {1, 2, 3, 4, "b", "d", "e"}
    at = 3
    path = [0, 1, 2, 3]
    bits = []
    for node in path:
        near, far = CHILDREN[node]
        bits.append(int(near in crossed and far in crossed and (node == at or far not in path)))
    d = Drawing(760, 330)
    draw_tree(d, 20, crossed=crossed)
    # The leaf b was visited before node 3: on the level of node 2 nothing waits any more.
    for level, (node, bit) in enumerate(zip(path, bits)):
        y = PLACES[node][1]
        d.line(580, y, 612, y, "#aaaaaa", 1, "3 3")
        d.box(620, y - 15, 32, 30, PALE[RED] if bit else "white")
        d.text(636, y + 5, bit, bold=True)
        d.text(662, y + 5, f"node {node}", "start", size=13)
    d.text(580, 16, "the other child waits?", "start", size=12)
    d.circle(PLACES[at][0] + 20, PLACES[at][1], 20, "none", RED)
    d.text(PLACES[at][0] + 48, PLACES[at][1] - 4, "the walk is here", "start", size=12, colour=RED)
    word = "".join(map(str, bits))
    d.text(580, 262, f"trail = {word}", "start", bold=True)
    up = len(word) - 1 - word.rindex("1")
    d.text(580, 284, f"last bit 1 is {up} levels up:", "start", size=12)
    d.text(580, 300, f"climb to node {path[-1 - up]}, clear it,", "start", size=12)
    d.text(580, 316, "go to its other child, node 4", "start", size=12)
    d.save(target)
    return word


# --- the wide node -------------------------------------------------------------------------------

FIELDS = [("origin", 12, BLUE), ("step", 4, BLUE), ("inner", 1, GOLD), ("leaf", 1, GOLD),
          ("unused", 2, None), ("first child", 4, GREEN), ("first pack", 4, GREEN),
          ("parent", 4, GREEN), ("faces: 8 boxes of 6, ten bits each", 64, RED),
          ("order: 8 octants of 8 slots", 32, PURPLE)]


def wide_node(target):
    """Seven binary nodes become one with eight children, of 128 bytes."""
    assert sum(size for _, size, _ in FIELDS) == 128
    d = Drawing(760, 400)
    inner = {"r": (190, 44), "p": (100, 98), "q": (290, 98), "s": (60, 152), "t": (140, 152),
             "u": (250, 152), "v": (330, 152)}
    edges = [("r", "p"), ("r", "q"), ("p", "s"), ("p", "t"), ("q", "u"), ("q", "v")]
    d.box(24, 18, 348, 162, "#f4f8fc", BLUE, "6 4", 12)
    for a, b in edges:
        d.line(*inner[a], *inner[b])
    slots = []
    for name in "stuv":
        x, y = inner[name]
        for side in (-1, 1):
            slots.append((x + side * 20, 222))
            d.line(x, y, x + side * 20, 210)
    for x, y in inner.values():
        d.node(x, y, "", PALE[BLUE], 11)
    leaves = {1, 4, 6}
    for k, (x, y) in enumerate(slots):
        (d.leaf if k in leaves else d.node)(x, y, k, PALE[GOLD] if k in leaves else "white",
                                            *((24, 22) if k in leaves else (12,)))
    d.text(198, 258, "seven binary nodes: three waits from top to bottom", size=13)
    left, w = 420, 40
    d.text(left, 36, "one wide node, one wait", "start", bold=True)
    d.cells(left, 50, list(range(8)), w, 34,
            [PALE[GOLD] if k in leaves else "white" for k in range(8)])
    for word, y, bits in (("inner", 116, [int(k not in leaves) for k in range(8)]),
                          ("leaf", 154, [int(k in leaves) for k in range(8)])):
        d.cells(left, y, bits, w, 28)
        d.text(left - 8, y + 19, word, "end", size=13)
    places = {k: sum(1 for j in range(k) if j in leaves) for k in leaves}
    d.text(left, 208, "slot 4 is a leaf; before it the bits of leaf count "
           f"{places[4]}:", "start", size=13)
    d.text(left, 226, f"its pack is number first_pack + {places[4]}", "start", size=13)
    left, y, scale = 24, 300, 712 / 128
    d.text(left, y - 12, "128 bytes, two cache lines", "start", bold=True)
    byte = 0
    for name, size, colour in FIELDS:
        x = left + byte * scale
        d.box(x, y, size * scale, 36, PALE[colour] if colour else GREY)
        if size >= 12:
            d.text(x + size * scale / 2, y + 23, name, size=12)
        byte += size
    small = [("step 4", 14), ("inner 1, leaf 1, unused 2", 18), ("first child 4", 22),
             ("first pack 4", 26), ("parent 4", 30)]
    for k, (words, at) in enumerate(small):
        x, tx = left + at * scale, left + 70 + 150 * k - (40 if k == 0 else 0)
        d.line(x, y + 36, tx, y + 62, "#888888", 1)
        d.text(tx, y + 76, words, size=12)
    d.save(target)


DRAWINGS = {"kd_or_boxes": kd_or_boxes, "morton_order": morton_order, "karras": karras,
            "refit": refit, "sah_slices": sah_slices, "skip_links": skip_links,
            "parent_pointers": parent_pointers, "trail": trail, "wide_node": wide_node}
