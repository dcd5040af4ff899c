"""Drawings of lab 04's walks through boxes, which follow the rules of the labs' own walks."""
from drawing import BLUE, Drawing, GOLD, GREEN, GREY, INK, PALE, PURPLE, RED

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
            was_met = line[walked[k - 1]][0] in CROSSED
            d.arrow(x - 36, y + 108, x - 18, y + 108, INK if was_met else RED)
        if name in CHILDREN:
            d.node(x, y + 108, name, PALE[BLUE] if met else "white")
        else:
            d.leaf(x, y + 108, name, PALE[GOLD] if met else "white")
    d.text(left, y + 146, "white: missed, so the walk follows the skip link (red)", "start",
           size=12)
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
    d = Drawing(760, 480)
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


DRAWINGS = {"skip_links": skip_links, "parent_pointers": parent_pointers, "trail": trail,
            "wide_node": wide_node}
