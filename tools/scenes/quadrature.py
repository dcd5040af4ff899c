"""Gauss-Legendre quadrature and the mean of a function over a pinhole camera's pixels.

The pixel filter is a box, so an image's mean over a region is an integral over that piece of film.
"""
import math


def gauss_legendre(n):
    """Nodes and weights on [0, 1], by Newton's method on the Legendre polynomial P_n."""
    rule = []
    for i in range(n):
        x = math.cos(math.pi * (i + 0.75) / (n + 0.5))
        for _ in range(100):
            p, previous = 1.0, 0.0
            for k in range(n):
                p, previous = ((2 * k + 1) * x * p - k * previous) / (k + 1), p
            slope = n * (x * p - previous) / (x * x - 1)
            step = p / slope
            x -= step
            if abs(step) < 1e-16:
                break
        rule.append(((1 - x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return rule


def integrate(f, a, b, n):
    return (b - a) * math.fsum(w * f(a + (b - a) * x) for x, w in gauss_legendre(n))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return math.fsum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def normalize(a):
    s = length(a)
    return tuple(x / s for x in a)


class Film:
    """A scene's pinhole camera: film position in pixels -> unit direction (common/camera)."""

    def __init__(self, scene):
        camera, film = scene["camera"], scene["film"]
        self.width, self.height = film["width"], film["height"]
        self.position = tuple(camera["position"])
        self.forward = normalize(subtract(camera["look_at"], camera["position"]))
        self.right = normalize(cross(self.forward, camera["up"]))
        self.up = cross(self.right, self.forward)
        self.half_height = math.tan(math.radians(camera["vfov_deg"]) / 2)
        self.half_width = self.half_height * self.width / self.height

    def direction(self, x, y):
        sx = (2 * x / self.width - 1) * self.half_width
        sy = (1 - 2 * y / self.height) * self.half_height
        return normalize(tuple(f + sx * r + sy * u
                               for f, r, u in zip(self.forward, self.right, self.up)))

    def on_floor(self, x, y):
        """Where the ray meets the plane y = 0."""
        d = self.direction(x, y)
        assert d[1] < 0, "this part of the film sees the sky"
        t = -self.position[1] / d[1]
        return tuple(p + t * c for p, c in zip(self.position, d))

    def mean(self, f, region=None, n=12, splits=lambda y: ()):
        """Mean of f(x, y) over a region; splits(y) names the x at which f has a kink."""
        x0, y0, x1, y1 = region or (0, 0, self.width, self.height)

        def row(y):
            cuts = [x0] + sorted(x for x in splits(y) if x0 < x < x1) + [x1]
            return math.fsum(integrate(lambda x: f(x, y), a, b, n) for a, b in zip(cuts, cuts[1:]))

        return integrate(row, y0, y1, n) / ((x1 - x0) * (y1 - y0))
