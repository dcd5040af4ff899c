"""Surfaces of revolution: a profile of (radius, height) points turned about the y axis.

Numbers are rounded to 1e-5, so that a last-bit difference between maths libraries cannot change a file.
"""
import math


def tidy(x):
    return round(x, 5) + 0.0  # + 0.0: no minus zero


def smooth_profile(points, steps):
    """A Catmull-Rom curve through the points; a point given twice stays sharp."""
    curve = []
    for i in range(len(points) - 1):
        p0, p1, p2, p3 = (points[max(0, min(len(points) - 1, i + k))] for k in (-1, 0, 1, 2))
        if p1 == p2:
            continue
        for s in range(steps):
            t = s / steps
            curve.append(tuple(
                0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                       (3 * b - a - 3 * c + d) * t ** 3) for a, b, c, d in zip(p0, p1, p2, p3)))
    curve.append(points[-1])
    return [(max(0.0, r), y) for r, y in curve]


def turn(profile, segments):
    """Rings of positions (one for a point on the axis) and triangles of (ring, segment) corners.

    A corner's segment runs from 0 to `segments`, so that a texture may close on itself; its position is
    rings[ring][segment % len]. Profiles run from the bottom up on the outside: triangles face out.
    """
    rings = []
    for r, y in profile:
        if r < 1e-9:
            rings.append([(0.0, tidy(y), 0.0)])
        else:
            rings.append([(tidy(r * math.sin(2 * math.pi * j / segments)), tidy(y),
                           tidy(r * math.cos(2 * math.pi * j / segments))) for j in range(segments)])
    triangles = []
    for i in range(len(rings) - 1):
        for j in range(segments):
            a, b, c, d = (i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)
            if len(rings[i]) > 1:
                triangles.append((a, b, c))
            if len(rings[i + 1]) > 1:
                triangles.append((a, c, d))
    return rings, triangles


def profile_normals(profile):
    """The outward normal (radial, up) at each point of a profile: across the mean of its neighbours."""
    normals = []
    for i in range(len(profile)):
        (r0, y0), (r1, y1) = profile[max(0, i - 1)], profile[min(len(profile) - 1, i + 1)]
        size = math.hypot(r1 - r0, y1 - y0)
        normals.append(((y1 - y0) / size, -(r1 - r0) / size))
    return normals
