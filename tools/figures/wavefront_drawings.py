"""Drawings of lab 03's pool, lists and launches, computed as the kernels compute them."""
from drawing import BLUE, Drawing, GOLD, GREEN, GREY, INK, PALE, RED

def exclusive_scan(numbers):
    return [sum(numbers[:i]) for i in range(len(numbers))]


# --- the pool ------------------------------------------------------------------------------------

def sectors(stride, lanes=32, bytes_each=4, sector=32):
    """Sectors of memory that a warp touches when lane i reads the word at i * stride."""
    return len({(lane * stride + byte) // sector for lane in range(lanes)
                for byte in range(bytes_each)})


def pool_layout(target):
    """Structure of arrays against array of structures, for one field of neighbouring slots."""
    d = Drawing(760, 330)
    fields = (("pixel", BLUE), ("bounce", GOLD), ("bsdf_pdf", GREEN))
    lanes, left, word = 8, 130, 66

    def threads(y, text):
        d.text(left - 12, y + 4, text, "end", size=13)
        for lane in range(lanes):
            d.node(left + (lane + 0.5) * word, y, lane, radius=11, size=12)

    d.text(16, 24, "Structure of arrays: an array for each field, a slot in each array", "start",
           bold=True)
    threads(48, "threads")
    for row, (name, colour) in enumerate(fields):
        y = 84 + 30 * row
        d.text(left - 12, y + 17, name, "end", size=13)
        d.cells(left, y, [f"slot {k}" for k in range(lanes)], word, 24, PALE[colour], 12)
    for lane in range(lanes):
        x = left + (lane + 0.5) * word
        d.arrow(x, 60, x, 82)
    d.text(16, 192, "A warp's 32 reads of one 4-byte field touch "
           f"{sectors(4)} sectors of 32 bytes.", "start", size=13)

    d.text(16, 228, "Array of structures: all fields of a slot side by side", "start", bold=True)
    threads(252, "threads")
    for lane in range(lanes):
        x = left + lane * word
        for k, (_, colour) in enumerate(fields):
            d.box(x + k * word / 5, 286, word / 5, 24, PALE[colour])
        d.box(x + 3 * word / 5, 286, 2 * word / 5, 24, GREY)
        d.text(x + 4 * word / 5, 302, "...", size=12)
        d.arrow(x + word / 2, 264, x + word / 10, 284)
    d.text(left - 12, 302, "paths", "end", size=13)
    # 130 bytes, rounded up so that each path begins at a multiple of four.
    d.text(left + lanes * word + 8, 296, f"{sectors(132)} sectors,", "start", size=13)
    d.text(left + lanes * word + 8, 312, "a path each", "start", size=13)
    d.save(target)


def compaction(target):
    """The example of compact.h: what the pool, the list and the three arrays of a scan hold."""
    live, slots = [3, 7, 2, 9, 4], 10
    alive = {3, 2, 9}
    flags = [int(slot in alive) for slot in live]
    places = exclusive_scan(flags)
    kept = [slot for slot in live if slot in alive]
    d = Drawing(760, 392)
    left, w = 190, 48

    def name(y, words, what):
        d.text(left - 16, y + 12, words, "end", bold=True)
        d.text(left - 16, y + 28, what, "end", size=12, colour="#555")

    fills = [PALE[GREEN] if s in alive else PALE[RED] if s in live else GREY for s in range(slots)]
    d.text(left, 24, "slot", "end", size=12)
    for s in range(slots):
        d.text(left + (s + 0.5) * w, 24, s, size=12)
    d.cells(left, 32, [int(s in alive) for s in range(slots)], w, 34, fills)
    name(32, "pool", "alive[slot]")
    for k, (words, fill) in enumerate((("alive", PALE[GREEN]), ("ended in this bounce", PALE[RED]),
                                       ("ended before", GREY))):
        d.box(left + (0, 84, 260)[k], 78, 14, 14, fill)
        d.text(left + (0, 84, 260)[k] + 20, 90, words, "start", size=12)

    own = [PALE[GREEN] if s in alive else PALE[RED] for s in live]
    rows = ((118, "list before", "slots, n = 5", live), (180, "flags", "alive[list[i]]", flags),
            (242, "places", "exclusive scan", places))
    for y, words, what, values in rows:
        d.cells(left, y, values, w, 34, own)
        name(y, words, what)
    for y in (152, 214):
        for k in range(5):
            d.arrow(left + (k + 0.5) * w, y, left + (k + 0.5) * w, y + 26)
    d.cells(left, 338, kept, w, 34, PALE[GREEN])
    name(338, "list after", "slots, n = 3")
    for k in range(5):
        if flags[k]:
            d.arrow(left + (k + 0.5) * w, 276, left + (places[k] + 0.5) * w, 336, GREEN, 2)
    x = left + 5 * w + 24
    d.text(x, 140, "thread i works for the i-th slot", "start", size=13)
    d.text(x, 202, "1: keep this slot", "start", size=13)
    d.text(x, 264, "how many are kept before i", "start", size=13)
    d.text(x, 312, "where the flag is 1: after[place] = before[i]", "start", size=13, colour=GREEN)
    d.text(x, 360, f"{places[-1] + flags[-1]} are kept: last place + last flag", "start", size=13)
    d.save(target)


# --- materials, launches, shared memory ----------------------------------------------------------

KINDS = [("diffuse", BLUE), ("mirror", GOLD), ("glass", GREEN)]  # kinds 0, 1, 2; 7: nothing was hit


def material_queues(target):
    """Three stable splits sort the list by kind; queues are filled by atomics instead."""
    kinds = [0, 2, 0, 1, 7, 0, 2, 1]
    colours = {k: PALE[colour] for k, (_, colour) in enumerate(KINDS)} | {7: GREY}
    d = Drawing(760, 462)
    left, w = 190, 50
    rows = [("the list", list(range(8)))]
    for bit in range(3):
        before = rows[-1][1]
        rows.append((f"split by bit {bit}", [s for s in before if not kinds[s] >> bit & 1]
                     + [s for s in before if kinds[s] >> bit & 1]))
    assert rows[-1][1] == sorted(range(8), key=lambda s: kinds[s])
    d.text(16, 24, "--sort on: the list, sorted by three stable splits", "start", bold=True)
    for row, (name, slots) in enumerate(rows):
        y = 36 + 52 * row
        d.cells(left, y, [f"{s}" for s in slots], w, 28, [colours[kinds[s]] for s in slots])
        d.text(left - 14, y + 19, name, "end")
        if row:
            before = rows[row - 1][1]
            for place, slot in enumerate(slots):
                set_bit = kinds[slot] >> (row - 1) & 1
                d.arrow(left + (before.index(slot) + 0.5) * w, y - 23,
                        left + (place + 0.5) * w, y - 2, RED if set_bit else "#888888")
    d.text(left + 8 * w + 14, 108, "red: the bit is set", "start", size=12, colour=RED)
    for k, (words, fill) in enumerate([(f"{name} = {kind}, binary {kind:03b}", colours[kind])
                                       for kind, (name, _) in enumerate(KINDS)]
                                      + [("no hit = 7, binary 111", colours[7])]):
        x = 16 + 182 * k
        d.box(x, 240, 14, 14, fill)
        d.text(x + 20, 252, words, "start", size=12)
    d.text(16, 294, "--sort queues: a queue and a kernel for each kind", "start", bold=True)
    d.text(left, 446, "places in a queue are taken by atomicAdd, in any order", "start", size=12)
    for kind, (name, _) in enumerate(KINDS):
        y = 308 + 42 * kind
        queue = [s for s in range(8) if kinds[s] == kind]
        d.cells(left, y, queue, w, 28, colours[kind])
        d.text(left - 14, y + 19, f"{name}: size {len(queue)}", "end")
        d.arrow(left + len(queue) * w + 8, y + 14, left + 4 * w + 20, y + 14)
        d.text(left + 4 * w + 30, y + 19, f"shade_kernel, compiled for {name} alone", "start",
               size=13)
    d.save(target)


def batches(target):
    """The lecture's example: 10 blocks in groups of 4, then 4 blocks."""
    d = Drawing(760, 200)
    in_flight, left, w = 4, 230, 62
    for blocks, y, name in ((10, 30, "iteration 1: 10 blocks"), (4, 150, "iteration 2: 4 blocks")):
        groups = -(-blocks // in_flight)
        d.text(left - 16, y + 14, name, "end", bold=True)
        d.text(left - 16, y + 30, f"{groups} batch" + ("es" if groups > 1 else ""), "end", size=13)
        for b in range(groups * in_flight):
            x, row = left + b % in_flight * w, b // in_flight
            there = b < blocks
            d.box(x, y + row * 32, w - 6, 26, PALE[BLUE] if there else "white",
                  INK if there else "#999999", "" if there else "3 3")
            if there:
                d.text(x + (w - 6) / 2, y + row * 32 + 18, f"block {b}", size=12)
    d.text(left + 4 * w + 16, 94 + 18, "two of four places stand idle", "start", size=13)
    d.text(left, 20, "the device holds 4 blocks at a time", "start", size=12)
    d.save(target)


def shared_copies(target):
    """Task3_5.CopiesCostOccupancy: one multiprocessor, without and with a copy for each block."""
    threads, shared, block, copy = 2048, 100, 128, 20
    d = Drawing(760, 214)
    d.text(16, 24, f"A multiprocessor for {threads} threads with {shared} KiB of shared memory, "
           f"blocks of {block} threads", "start", bold=True)
    for k, (name, fit) in enumerate((("geometry in global memory", threads // block),
                                     (f"a copy of {copy} KiB in each block",
                                      min(threads // block, shared // copy)))):
        y = 44 + 84 * k
        d.text(224, y + 26, name, "end", size=13)
        d.text(224, y + 46, f"{fit} blocks, {fit * block} threads", "end", bold=True)
        for b in range(threads // block):
            x = 240 + b * 31
            there = b < fit
            d.box(x, y, 27, 60, PALE[BLUE] if there else "white", INK if there else "#aaaaaa",
                  "" if there else "3 3")
            if there and k:
                d.box(x + 3, y + 32, 21, 24, PALE[GOLD])
                d.text(x + 13.5, y + 49, copy, size=12)
    d.save(target)


DRAWINGS = {"pool_layout": pool_layout, "compaction": compaction,
            "material_queues": material_queues, "batches": batches, "shared_copies": shared_copies}
