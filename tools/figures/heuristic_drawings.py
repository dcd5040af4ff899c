"""Drawings of lab 04's surface area heuristic: costs of cuts, computed."""
import math
import random

from drawing import BLUE, Drawing, GREEN, PALE, PURPLE, RED


def packs(n):
    return -(-n // 8)


def kd_cost(target):
    """The cost of a cut at every place along one axis of a cell, of 80 triangles' boxes."""
    numbers = random.Random(3)
    length, width, step, empty = 16.0, 6.0, 2.0, 0.9
    boxes = []
    for centre, spread, count in ((3.0, 0.9, 58), (11.5, 1.8, 22)):
        for _ in range(count):
            middle, half = numbers.gauss(centre, spread), numbers.uniform(0.1, 0.7)
            boxes.append((max(0.6, middle - half), min(15.2, middle + half)))
    n = len(boxes)
    area = length * width * 2 + width * width
    places = sorted({p for box in boxes for p in box})

    def cost(plane):
        below = sum(1 for low, _ in boxes if low < plane)
        above = sum(1 for _, high in boxes if high > plane)
        part = [width * width + 2 * width * x for x in (plane, length - plane)]
        whole = step + (part[0] * packs(below) + part[1] * packs(above)) / area
        return whole * (empty if below == 0 or above == 0 else 1)

    best = min(places, key=cost)
    d = Drawing(760, 430)
    left, w, top, height = 70, 640, 210, 170
    high = max(cost(p) for p in places) + 0.4

    def x_of(x):
        return left + x / length * w

    def y_of(c):
        return top + height - c / high * height

    d.text(left, 20, f"{n} triangles of a cell, as far as they reach along x", "start", bold=True)
    bars = ""
    for k, (a, b) in enumerate(sorted(boxes)):
        bars += f"M{x_of(a):.1f} {32 + 1.8 * k:.1f}H{x_of(b):.1f}"
    d.path(bars, BLUE, 1.2)
    d.text(left, 200, "cost of a ray through the cell, if it is cut here", "start", bold=True)
    for c in range(0, math.ceil(high), 2):
        d.line(left, y_of(c), left + w, y_of(c), "#dddddd", 1)
        d.text(left - 8, y_of(c) + 5, c, "end", size=12)
    d.line(left, y_of(packs(n)), left + w, y_of(packs(n)), GREEN, 1.5, "6 4")
    d.text(x_of(7.5), y_of(packs(n)) - 6, f"a leaf: {packs(n)} packs", size=13, colour=GREEN)
    points, ends = [], [0.0] + places + [length]
    for a, b in zip(ends, ends[1:]):
        points += [(x, cost(x)) for x in (a + 1e-9, b - 1e-9)]
    bends = [points[0]] + [q for p, q, r in zip(points, points[1:], points[2:])
                           if abs(p[1] + (r[1] - p[1]) * (q[0] - p[0]) / (r[0] - p[0]) - q[1])
                           > 1e-3] + [points[-1]]
    d.path("M" + "L".join(f"{x_of(x):.1f} {y_of(c):.1f}" for x, c in bends), RED, 1.8)
    for k in range(1, 32):
        x = k * length / 32
        d.circle(x_of(x), y_of(cost(x)), 2.6, "white", RED)
    d.line(x_of(best), 28, x_of(best), top + height, PURPLE, 1.5, "4 3")
    d.text(x_of(best) + 6, top + height - 8, f"the least: {cost(best):.2f}", "start", size=13,
           colour=PURPLE)
    d.line(left, top + height, left + w, top + height)
    for x in range(0, 17, 4):
        d.text(x_of(x), top + height + 18, x, size=12)
    d.text(left + w / 2, top + height + 38, "x; circles: the 31 planes that try_bins() considers",
           size=13)
    d.save(target)


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


DRAWINGS = {"kd_cost": kd_cost, "sah_slices": sah_slices}
