"""Drawings of lab 04's KD-tree, in two dimensions: one small tree, its ropes, and its walks.

Tree, ropes and walks are computed as labs/04_accel/kd does it.
"""
from drawing import BLUE, Drawing, GOLD, GREEN, INK, PALE, RED

SIZE = (8, 6)  # of the root's cell
NO_ROPE = -1
FACES = ("left", "right", "below", "above")


class Node:
    def __init__(self, low, high):
        self.low, self.high, self.name = low, high, ""
        self.axis, self.at, self.children, self.rope = None, None, (), []


def build_tree():
    """Nodes in the order of the builder: two children side by side, the lower subtree first."""
    nodes = [Node((0, 0), SIZE)]

    def cut(node, plan):
        if isinstance(plan, str):
            nodes[node].name = plan
            return
        axis, at, lower, upper = plan
        n = nodes[node]
        n.axis, n.at, n.children = axis, at, (len(nodes), len(nodes) + 1)
        for side in range(2):
            low, high = list(n.low), list(n.high)
            (high if side == 0 else low)[axis] = at
            nodes.append(Node(tuple(low), tuple(high)))
        cut(n.children[0], lower)
        cut(n.children[1], upper)

    cut(0, (0, 4, (1, 3, "A", (0, 2, "B", "C")), (1, 2, "D", (1, 4, "E", "F"))))
    lay_ropes(nodes)
    return nodes


def lay_ropes(nodes):
    def pushed_down(rope, face, node):
        while rope != NO_ROPE and nodes[rope].children:
            axis, at = nodes[rope].axis, nodes[rope].at
            if axis == face // 2:
                rope = nodes[rope].children[1 - face % 2]
            elif at <= node.low[axis]:
                rope = nodes[rope].children[1]
            elif at >= node.high[axis]:
                rope = nodes[rope].children[0]
            else:
                break
        return rope

    def lay(at, ropes):
        node = nodes[at]
        node.rope = [pushed_down(ropes[face], face, node) for face in range(4)]
        if not node.children:
            return
        for side, other in ((0, 1), (1, 0)):
            below = list(node.rope)
            below[2 * node.axis + other] = node.children[other]
            lay(node.children[side], below)

    lay(0, [NO_ROPE] * 4)


class Ray:
    o, d = (-0.5, 1.0), (1.0, 0.5)

    def t(self, axis, plane):
        return (plane - self.o[axis]) / self.d[axis]

    def inside(self, low, high):
        return (max([0] + [self.t(k, low[k]) for k in range(2)]),
                min(self.t(k, high[k]) for k in range(2)))

    def at(self, t):
        return tuple(o + t * d for o, d in zip(self.o, self.d))


def walk_stack(nodes, ray):
    visited, later, at = [], [], 0
    begin, end = ray.inside(nodes[0].low, nodes[0].high)
    while True:
        visited.append(at)
        node = nodes[at]
        if node.children:
            t = ray.t(node.axis, node.at)
            if t <= begin:
                at = node.children[1]
                continue
            at = node.children[0]
            if t < end:
                later.append((node.children[1], end))
                end = t
            continue
        if not later:
            return visited
        begin = end
        at, end = later.pop()


def walk_ropes(nodes, ray):
    visited, at = [], 0
    t, _ = ray.inside(nodes[0].low, nodes[0].high)
    while at != NO_ROPE:
        while True:
            visited.append(at)
            node = nodes[at]
            if not node.children:
                break
            at = node.children[ray.t(node.axis, node.at) <= t]
        t, axis = min((ray.t(k, node.high[k]), k) for k in range(2))
        at = node.rope[2 * axis + 1]
    return visited


def walk_restart(nodes, ray, push_down):
    visited, root = [], 0
    begin, rest_end = ray.inside(nodes[0].low, nodes[0].high)
    while True:
        at, end, only = root, rest_end, push_down
        while True:
            visited.append(at)
            node = nodes[at]
            if not node.children:
                break
            t = ray.t(node.axis, node.at)
            if t <= begin:
                at = node.children[1]
            else:
                at = node.children[0]
                only = only and t >= rest_end
                end = min(end, t)
            if only:
                root = at
        if end >= rest_end:
            return visited
        begin = end


# --- pictures ------------------------------------------------------------------------------------

def place(x, y, left, top, scale):
    return left + x * scale, top + (SIZE[1] - y) * scale


def draw_cells(d, nodes, left, top, scale, fills, name_below=False):
    for node in nodes:
        if node.children:
            continue
        x, y = place(node.low[0], node.high[1], left, top, scale)
        d.box(x, y, (node.high[0] - node.low[0]) * scale, (node.high[1] - node.low[1]) * scale,
              fills.get(node.name, "white"))
        if name_below:
            x, y = place(node.high[0], node.low[1], left, top, scale)
            d.text(x - 9, y - 9, node.name, "end", bold=True, size=15)
        else:
            d.text(x + 9, y + 18, node.name, "start", bold=True, size=15)


def draw_tree(d, nodes, places, axes=True):
    for i, node in enumerate(nodes):
        for child in node.children:
            d.line(*places[i], *places[child])
    for i, node in enumerate(nodes):
        x, y = places[i]
        if node.children:
            d.node(x, y, i, PALE[BLUE])
            if axes:
                d.text(x + 20, y - 4, f"{'xy'[node.axis]} = {node.at}", "start", size=12)
        else:
            d.leaf(x, y, f"{i}{node.name}", PALE[GOLD], 34)


TREE = {0: (590, 44), 1: (510, 104), 2: (670, 104), 3: (474, 164), 4: (546, 164), 7: (634, 164),
        8: (706, 164), 5: (520, 224), 6: (574, 224), 9: (680, 224), 10: (734, 224)}


def kd_ropes(target):
    """The ropes of two leaves: to a leaf, to an inner node where the neighbour is cut finer."""
    nodes = build_tree()
    d = Drawing(770, 400)
    left, top, scale = 24, 40, 48
    draw_cells(d, nodes, left, top, scale, {"A": PALE[RED], "C": PALE[GREEN]}, True)
    by_name = {n.name: n for n in nodes if n.name}
    for name, colour in (("A", RED), ("C", GREEN)):
        node = by_name[name]
        middle = [(a + b) / 2 for a, b in zip(node.low, node.high)]
        for face, rope in enumerate(node.rope):
            axis, upper = face // 2, face % 2
            start, end = list(middle), list(middle)
            edge = (node.high if upper else node.low)[axis]
            start[axis] = edge - (0.45 if upper else -0.45)
            end[axis] = edge + (0.5 if upper else -0.5)
            if rope == NO_ROPE:
                end[axis] = edge + (0.3 if upper else -0.3)
            if name == "A" and face == 3:  # beside the arrow of C
                start[0] = end[0] = 1.4
            p, q = place(*start, left, top, scale), place(*end, left, top, scale)
            d.arrow(*p, *q, colour, 2.2, "3 3" if rope == NO_ROPE else "")
            if rope != NO_ROPE:
                words = f"{rope}{nodes[rope].name}"
                d.text(q[0] + (14 if axis == 0 and upper else -14 if axis == 0 else 0),
                       q[1] + (5 if axis == 0 else -6 if upper else 16), words, colour=colour,
                       bold=True)
    d.text(left, 24, "cells; dashed: behind this face the scene ends", "start", size=13)
    draw_tree(d, nodes, TREE)
    d.text(464, 274, "leaf", "start", size=13, bold=True)
    for k, face in enumerate(FACES):
        d.text(540 + 62 * k, 274, face, size=13, bold=True)
    for row, name in enumerate("ABCDEF"):
        y = 294 + 18 * row
        colour = {"A": RED, "C": GREEN}.get(name, INK)
        d.text(464, y, name, "start", size=13, colour=colour)
        for k, rope in enumerate(by_name[name].rope):
            words = "-" if rope == NO_ROPE else f"{rope}{nodes[rope].name}"
            d.text(540 + 62 * k, y, words, size=13, colour=colour)
    d.save(target)


def kd_walks(target):
    """One ray through the tree: the nodes that each walk reads."""
    nodes, ray = build_tree(), Ray()
    walks = [("stack", walk_stack(nodes, ray)), ("ropes", walk_ropes(nodes, ray)),
             ("restart, from the root each time", walk_restart(nodes, ray, False)),
             ("restart, the root moves down", walk_restart(nodes, ray, True))]
    leaves = [[nodes[i].name for i in visited if nodes[i].name] for _, visited in walks]
    assert all(found == leaves[0] for found in leaves)
    d = Drawing(770, 590)
    left, top, scale = 24, 24, 48
    draw_cells(d, nodes, left, top, scale, {name: PALE[GOLD] for name in leaves[0]})
    begin, end = ray.inside(nodes[0].low, nodes[0].high)
    d.arrow(*place(*ray.at(0.05), left, top, scale),
            *place(*ray.at(end + 0.3), left, top, scale), RED, 2.2)
    ts = [begin]
    for node in (n for name in leaves[0] for n in nodes if n.name == name):
        ts.append(ray.inside(node.low, node.high)[1])
    for k, t in enumerate(ts):
        x, y = place(*ray.at(t), left, top, scale)
        d.circle(x, y, 4, RED, RED)
        before = k == 1  # the next point is close by
        d.text(x + (-6 if before else 9), y + (-8 if before else 20), f"t = {t:g}",
               "end" if before else "start", size=12, colour=RED)
    draw_tree(d, nodes, TREE)
    d.text(590, 276, "a ray through " + ", ".join(leaves[0]), size=13)
    for row, (name, visited) in enumerate(walks):
        y = 338 + 66 * row
        d.text(24, y, f"{name}: {len(visited)} nodes", "start", bold=True)
        for k, at in enumerate(visited):
            x = 42 + 44 * k
            if k:
                d.arrow(x - 28, y + 26, x - 18, y + 26)
            if nodes[at].name:
                d.leaf(x, y + 26, f"{at}{nodes[at].name}", PALE[GOLD], 32)
            else:
                d.node(x, y + 26, at, PALE[BLUE], 13)
    d.save(target)
    return {name: len(visited) for name, visited in walks}


DRAWINGS = {"kd_ropes": kd_ropes, "kd_walks": kd_walks}
