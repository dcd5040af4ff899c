"""A porcelain vase: a turned mesh with texture coordinates, and its painting in 16 shades of cobalt."""
import math

from lathe import smooth_profile, tidy, turn
from png import png_bytes

SEGMENTS = 20
OUTSIDE = [(0, 0), (0.40, 0), (0.43, 0.05), (0.46, 0.16), (0.66, 0.52), (0.74, 0.94), (0.60, 1.32),
           (0.34, 1.62), (0.25, 1.82), (0.29, 2.0), (0.42, 2.12)]
INSIDE = [(0.38, 2.13), (0.24, 1.97), (0.20, 1.8), (0, 1.6)]


def vase_obj():
    body = smooth_profile(OUTSIDE[1:], 2)
    profile = [OUTSIDE[0]] + body + INSIDE
    rings, triangles = turn(profile, SEGMENTS)

    length = [0.0]  # v follows the profile's length, from the foot's edge to the lip
    for (r0, y0), (r1, y1) in zip(body, body[1:]):
        length.append(length[-1] + math.hypot(r1 - r0, y1 - y0))
    along = [0.0] + [s / length[-1] for s in length] + [1.0] * len(INSIDE)

    lines = ["# A vase; made by tools/scenes/generate.py"]
    first = []
    count = 1
    for ring in rings:
        first.append(count)
        count += len(ring)
        lines += ["v {:g} {:g} {:g}".format(*p) for p in ring]
    for v in along:
        lines += ["vt {:g} {:g}".format(tidy(j / SEGMENTS), tidy(v)) for j in range(SEGMENTS + 1)]

    def corner(c):
        ring, j = c
        return "{}/{}".format(first[ring] + j % len(rings[ring]), ring * (SEGMENTS + 1) + j + 1)
    lines += ["f " + " ".join(map(corner, t)) for t in triangles]
    return "\n".join(lines) + "\n", len(triangles)


def ink(u, v):
    """How blue the porcelain is at (u, v), u around, v from foot (0) to lip (1)."""
    def band(at, half):
        return abs(v - at) < half
    if band(0.02, 0.02) or band(0.085, 0.008) or band(0.97, 0.03):
        return 0.95
    if 0.10 < v < 0.24:  # pointed leaves around the foot
        x = (u * 16) % 1 - 0.5
        top = (v - 0.10) / 0.14
        inner = abs(x) < 0.36 * (1 - top) ** 0.7
        return 0.85 if abs(x) < 0.46 * (1 - top) ** 0.7 and not inner else 0.25 if inner else 0.0
    if band(0.262, 0.006) or band(0.638, 0.006):
        return 0.9
    if 0.27 < v < 0.63:  # five blossoms and a vine between them
        x, y = ((u * 5) % 1 - 0.5) / 5 * 4.4, (v - 0.45) * 2.75
        r, a = math.hypot(x, y), math.atan2(y, x)
        petals = 0.27 + 0.085 * math.cos(8 * a)
        if r < 0.07:
            return 0.95
        if r < 0.095:
            return 0.0
        if r < petals:
            return 0.9 if r > petals - 0.035 else 0.35 + 0.45 * (1 - r / petals)
        # the vine swings from blossom to blossom, with leaves on it
        s = (u * 5 + 0.5) % 1
        vine = 0.45 + 0.13 * math.sin(2 * math.pi * (u * 5 + 0.25)) * (1 if int(u * 5 + 0.5) % 2 else -1)
        if abs(v - vine) < 0.008 and 0.12 < s < 0.88:
            return 0.8
        for at, up in ((0.28, 1), (0.5, -1), (0.72, 1)):
            lx, ly = (s - at) * 0.88, (v - vine - up * 0.03) * 2.75
            if (lx / 0.05) ** 2 + (ly / 0.075) ** 2 < 1:
                return 0.7
        return 0.0
    if 0.66 < v < 0.74:  # waves on the shoulder
        x = u * 20
        for k in range(3):
            if abs(v - 0.675 - 0.022 * k - 0.009 * math.sin(2 * math.pi * (x + 0.33 * k))) < 0.0045:
                return 0.8
        return 0.0
    if band(0.76, 0.006) or band(0.9, 0.006):
        return 0.9
    if 0.77 < v < 0.89:  # a lattice on the neck
        a, b = (u * 18 + (v - 0.77) * 25) % 1, (u * 18 - (v - 0.77) * 25) % 1
        return 0.75 if min(a, b) < 0.16 else 0.0
    return 0.0


def vase_png(width=256, height=192, samples=3):
    white, blue = (240, 240, 232), (22, 44, 130)
    palette = [tuple(round(w + (b - w) * i / 15) for w, b in zip(white, blue)) for i in range(16)]
    rows = []
    for y in range(height):
        row = []
        for x in range(width):
            total = sum(ink((x + (i + 0.5) / samples) / width, 1 - (y + (j + 0.5) / samples) / height)
                        for i in range(samples) for j in range(samples))
            row.append(round(total / samples ** 2 * 15))
        rows.append(row)
    return png_bytes(palette, rows, 4)
