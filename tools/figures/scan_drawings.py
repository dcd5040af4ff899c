"""Drawings of lab 03's scans, computed as the kernels compute them."""
from drawing import BLUE, Drawing, GOLD, GREEN, GREY, PALE, RED
from wavefront_drawings import exclusive_scan

NUMBERS = [3, 1, 7, 0, 4, 1, 6, 3]


def scan_naive(target):
    """Hillis and Steele, on the numbers moved on by one place: the kernels of scan_naive()."""
    d = Drawing(760, 330)
    left, w, rows = 200, 52, [NUMBERS, [0] + NUMBERS[:-1]]
    distances = [1, 2, 4]
    for distance in distances:
        x = rows[-1]
        rows.append([x[i] if i < distance else x[i - distance] + x[i] for i in range(len(x))])
    assert rows[-1] == exclusive_scan(NUMBERS)
    names = ["in", "moved on by one"] + [f"distance {n}" for n in distances]
    for row, values in enumerate(rows):
        y = 20 + 62 * row
        fill = [PALE[GREEN] if row == 4 or (row > 1 and i < 2 * distances[row - 2])
                else "white" for i in range(8)] if row else GREY
        d.cells(left, y, values, w, 30, fill)
        d.text(left - 14, y + 20, names[row], "end", bold=row > 1, size=14)
        if row > 1:
            distance = distances[row - 2]
            for i in range(8):
                x = left + (i + 0.5) * w
                d.arrow(x, y - 32, x, y - 2, "#888888")
                if i >= distance:
                    d.arrow(x - distance * w, y - 32, x - 3, y - 2, BLUE)
        elif row == 1:
            for i in range(1, 8):
                d.arrow(left + (i - 0.5) * w, y - 32, left + (i + 0.5) * w, y - 2, "#888888")
    additions = sum(8 - n for n in distances)
    d.text(left + 8 * w + 16, 40, "8 numbers", "start", size=13)
    d.text(left + 8 * w + 16, 164, f"{additions} additions", "start", size=13)
    d.text(left + 8 * w + 16, 182, "in 3 rounds", "start", size=13)
    d.text(left + 8 * w + 16, 288, "green: final", "start", size=13)
    d.save(target)
    return additions


def scan_efficient(target):
    """Blelloch's tree, in place: up with strides 1, 2, 4, and down with 4, 2, 1."""
    d = Drawing(760, 490)
    left, w, step = 190, 52, 58
    tree, rows, additions = list(NUMBERS), [("the numbers", list(NUMBERS), [], None)], 0
    for stride in (1, 2, 4):
        changed = list(range(2 * stride - 1, 8, 2 * stride))
        for i in changed:
            tree[i] += tree[i - stride]
            additions += 1
        rows.append((f"up, stride {stride}", list(tree), changed, stride))
    total, tree[7] = tree[7], 0
    rows.append(("the root is cleared", list(tree), [7], None))
    for stride in (4, 2, 1):
        changed = []
        for i in range(2 * stride - 1, 8, 2 * stride):
            tree[i - stride], tree[i] = tree[i], tree[i] + tree[i - stride]
            additions += 1
            changed += [i - stride, i]
        rows.append((f"down, stride {stride}", list(tree), changed, -stride))
    assert tree == exclusive_scan(NUMBERS) and total == sum(NUMBERS)
    for row, (name, values, changed, stride) in enumerate(rows):
        y = 20 + step * row
        colour = BLUE if row < 4 else RED if row == 4 else GREEN
        d.cells(left, y, values, w, 28,
                [PALE[colour] if i in changed else "white" for i in range(8)])
        d.text(left - 14, y + 19, name, "end", bold=True)
        if stride is None:
            continue
        for i in range(2 * abs(stride) - 1, 8, 2 * abs(stride)):
            x, from_x = left + (i + 0.5) * w, left + (i - abs(stride) + 0.5) * w
            d.arrow(from_x, y - step + 29, x - 4, y - 2, colour)
            d.arrow(x, y - step + 29, x, y - 2, colour)
            if stride < 0:
                d.arrow(x, y - step + 29, from_x + 4, y - 2, colour, dash="4 3")
    x = left + 8 * w + 16
    d.text(x, 97, "right += left", "start", size=13)
    d.text(x, 271, f"sum of all: {total}", "start", size=13)
    d.text(x, 325, "dashed: moved", "start", size=13)
    d.text(x, 343, "solid: added", "start", size=13)
    d.text(x, 446, f"{additions} additions", "start", size=13)
    d.save(target)
    return additions


def lookback(target):
    """What one warp sees on the board of tiles, and what it adds up."""
    sums, complete, tile = [5, 3, 4, 2, 6, 1, 4, 7], {0, 1, 3}, 6
    unknown = {7}
    before, looked = 0, []
    for seen in range(tile - 1, -1, -1):
        looked.append(seen)
        before += sum(sums[:seen + 1]) if seen in complete else sums[seen]
        if seen in complete:
            break
    assert before == sum(sums[:tile])
    d = Drawing(760, 300)
    left, w = 150, 74
    for k in range(8):
        x = left + k * w
        d.text(x + w / 2, 26, f"tile {k}", size=13, bold=k == tile)
        fill = PALE[GREEN] if k in complete else GREY if k in unknown else PALE[GOLD]
        d.box(x, 36, w - 6, 46, fill)
        if k in unknown:
            d.text(x + (w - 6) / 2, 64, "nothing", size=13)
            continue
        d.text(x + (w - 6) / 2, 55, "up to it" if k in complete else "its own", size=12)
        d.text(x + (w - 6) / 2, 74, sum(sums[:k + 1]) if k in complete else sums[k], bold=True)
    d.text(left - 14, 56, "the board:", "end", bold=True)
    d.text(left - 14, 74, "a word a tile", "end", size=12)
    for lane in range(tile):
        x = left + (tile - 1 - lane) * w + (w - 6) / 2
        used = tile - 1 - lane in looked
        d.node(x, 130, lane, PALE[BLUE] if used else GREY)
        d.arrow(x, 114, x, 85, BLUE if used else "#999999", dash="" if used else "3 3")
    d.text(left - 14, 128, "lanes of tile 6's", "end", size=13, bold=True)
    d.text(left - 14, 144, "first warp look", "end", size=12)
    x = left + (tile - 1 - len(looked) + 1) * w
    d.path(f"M{left + tile * w - 8} 156v10H{x + 2}v-10", BLUE)
    terms = [sums[s] if s not in complete else sum(sums[:s + 1]) for s in looked]
    d.text((x + left + tile * w) / 2, 188, " + ".join(map(str, terms)) + f" = {before}",
           colour=BLUE, bold=True, size=15)
    d.text(x - 12, 182, "in tile 3's sum already:", "end", size=12)
    d.text(x - 12, 198, "not added", "end", size=12)
    d.text(left, 232, f"Before tile 6 stands {before}; with its own {sums[tile]} it knows the sum "
           f"up to itself and publishes {before + sums[tile]}.", "start", size=13)
    for k, (words, fill) in enumerate((("nothing yet", GREY), ("the tile's own sum", PALE[GOLD]),
                                       ("the sum of all up to the tile", PALE[GREEN]))):
        x = left + (0, 116, 290)[k]
        d.box(x, 258, 14, 14, fill)
        d.text(x + 20, 270, words, "start", size=12)
    d.save(target)


DRAWINGS = {"scan_naive": scan_naive, "scan_efficient": scan_efficient, "lookback": lookback}
