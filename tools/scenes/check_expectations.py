#!/usr/bin/env python3
"""Derives every closed form of scenes/*.json a second way, by quadrature, and compares.

    python3 tools/scenes/check_expectations.py [FOLDER]

For each scene a function below returns, for each entry of "expect", a pair: the closed form, and
the same number found without it. Both must agree with each other to 1e-8 (or to the bound given in
a third place) and the first with the file to 1e-9.
"""
import json
import math
import pathlib
import sys

from quadrature import Film, cross, dot, integrate, length, normalize, subtract

PI = math.pi


# --- formulas ------------------------------------------------------------------------------------

def lambert_irradiance(p, corners, radiance):
    """Irradiance at p of a floor (normal +y) from a polygon wholly above it: Lambert 1760."""
    v = [normalize(subtract(c, p)) for c in corners]
    total = 0.0
    for a, b in zip(v, v[1:] + v[:1]):
        edge = cross(a, b)
        total += math.atan2(length(edge), dot(a, b)) * normalize(edge)[1]
    return abs(total) * radiance / 2


def area_irradiance(p, x0, x1, z0, z1, y, radiance, n=16):
    """The same for a horizontal rectangle, straight from the definition: L cos cos / d^2 over the area."""
    def sample(x, z):
        d2 = (x - p[0]) ** 2 + (y - p[1]) ** 2 + (z - p[2]) ** 2
        return ((y - p[1]) / d2) ** 2
    return radiance * integrate(lambda z: integrate(lambda x: sample(x, z), x0, x1, n), z0, z1, n)


def fresnel(cos_i, ior):
    """Unpolarised reflectance of a dielectric, ior inside over outside."""
    sin2_t = (1 - cos_i * cos_i) / (ior * ior)
    if sin2_t >= 1:
        return 1.0
    cos_t = math.sqrt(1 - sin2_t)
    rs = (cos_i - ior * cos_t) / (cos_i + ior * cos_t)
    rp = (ior * cos_i - cos_t) / (ior * cos_i + cos_t)
    return (rs * rs + rp * rp) / 2


# --- scenes --------------------------------------------------------------------------------------

def furnace(scene):
    material = scene["materials"]["furnace"]
    depth = scene["render"]["max_depth"]
    closed, summed = [], []
    for a, e in zip(material["reflectance"], material["emission"]):
        closed.append(e * (1 - a ** depth) / (1 - a))
        summed.append(math.fsum(e * a ** k for k in range(depth)))
    return [(closed, summed)]


def even_sky(scene):
    """A white surface in even light has its radiance, a grey one alone under a sky its albedo."""
    (material,) = scene["materials"].values()
    lobe = integrate(lambda cos_t: 2 * cos_t, 0, 1, 16)  # cos / pi over the hemisphere
    return [(material["reflectance"], [a * lobe for a in material["reflectance"]])]


def point_in_sphere(scene):
    a = scene["materials"]["wall"]["reflectance"][0]
    surfaces = scene["render"]["max_depth"] - 1  # the light is the last vertex of a path
    return [(a / (1 - a), math.fsum(a ** k for k in range(1, surfaces + 1)))]


def chord_furnace(scene):
    film = Film(scene)
    a = scene["materials"]["wall"]["reflectance"][0]
    r = scene["shapes"][0]["radius"]
    p = scene["lights"][0]["position"][0]
    bounces = scene["render"]["max_depth"] - 2

    def g(cos_t):  # irradiance / pi at angle t from -x, for I = pi r^2
        return r * r * (r + p * cos_t) / (r * r + p * p + 2 * r * p * cos_t) ** 1.5

    def bounced(cos_t):
        """The mean of g over where cosine-weighted directions end: at 2 r cos(normal) along them."""
        sin_t = math.sqrt(max(0.0, 1 - cos_t * cos_t))
        ring = [math.cos(2 * PI * (j + 0.5) / 64) for j in range(64)]

        def cone(angle):
            s, c = math.sin(angle), math.cos(angle)  # c: cosine to the normal
            return 2 * s * c / 64 * math.fsum(g(cos_t - 2 * c * (c * cos_t + s * k * sin_t)) for k in ring)
        return integrate(cone, 0, PI / 2, 40)

    def cos_t(x, y):
        return -film.direction(x, y)[0]
    closed = film.mean(lambda x, y: a * (g(cos_t(x, y)) + a / (1 - a)), n=16)
    series = math.fsum(a ** k for k in range(1, bounces + 1))
    return [(closed, film.mean(lambda x, y: a * (g(cos_t(x, y)) + series * bounced(cos_t(x, y))), n=5))]


def glass_furnace(scene):
    """1, less the paths that are cut off: a Markov chain over the surfaces they meet."""
    depth = scene["render"]["max_depth"]

    def cut_off(b, ior, bubble):  # share of paths with impact parameter b still inside at the end
        r_out = fresnel(math.sqrt(1 - b * b), ior)
        sin_in = b / (ior * bubble) if bubble else 2.0
        r_in = fresnel(math.sqrt(1 - sin_in ** 2), 1 / ior) if sin_in < 1 else None
        inward, outward, inside = 1 - r_out, 0.0, 0.0
        for _ in range(depth - 1):
            if r_in is None:
                inward *= r_out
            else:
                inward, outward, inside = (outward * r_out, inward * r_in + inside * (1 - r_in),
                                           inward * (1 - r_in) + inside * r_in)
        return inward + outward + inside

    rays = 4000
    worst = max(math.fsum(cut_off(math.sqrt((i + 0.5) / rays), ior, bubble) for i in range(rays)) / rays
                for ior, bubble in ((1.5, 0), (1.5, 0.6), (2.4, 0)))
    return [(1.0, 1 - worst, 2e-6)]


def glass_pane(scene):
    film = Film(scene)
    tilt = math.radians(scene["shapes"][1]["transform"]["rotate"][0]["angle_deg"])
    entries = []
    for entry, normal in zip(scene["expect"], ((0, 0, 1), (math.sin(tilt), 0, math.cos(tilt)))):
        def closed(x, y):
            r = fresnel(-dot(film.direction(x, y), normal), 1.5)
            return (1 - r) / (1 + r)

        def summed(x, y):  # through both sides, and 2 k reflections between them
            r = fresnel(-dot(film.direction(x, y), normal), 1.5)
            return (1 - r) ** 2 * math.fsum(r ** (2 * k) for k in range(11))
        entries.append((film.mean(closed, entry["region"], 8), film.mean(summed, entry["region"], 8)))
    return entries


def soft_shadow(scene):
    film = Film(scene)
    light = scene["shapes"][1]["vertices"]
    radiance = scene["materials"]["light"]["emission"][0]
    height, cover = light[0][1], scene["shapes"][2]["vertices"][0][1]

    def open_sky(x, y):
        return lambert_irradiance(film.on_floor(x, y), light, radiance) / PI

    def seen(x, y):  # the light left of the cover's shadow, by area
        p = film.on_floor(x, y)
        edge = p[0] * (1 - height / cover)
        return area_irradiance(p, -0.5, max(-0.5, min(0.5, edge)), -0.5, 0.5, height, radiance, 10) / PI

    def kinks(y):  # where the shadow's edge enters and leaves the light, x = -0.5 and 0.5 on the floor
        left, right = film.on_floor(0, y)[0], film.on_floor(film.width, y)[0]
        return [film.width * (x - left) / (right - left) for x in (-0.5, 0.5)]

    colour = scene["materials"]["floor"]["reflectance"]
    entries = []
    for entry, factor in zip(scene["expect"], (0.5, 0.5, 1.0)):
        region = entry.get("region")
        closed = factor * film.mean(open_sky, region, 14)
        other = film.mean(seen, region, 14, kinks)
        entries.append(([c * closed for c in colour], [c * other for c in colour]))
    return entries


def polygon_light(scene):
    film = Film(scene)
    light = scene["shapes"][1]["vertices"]
    return [(film.mean(lambda x, y: lambert_irradiance(film.on_floor(x, y), light, 1), n=6),
             film.mean(lambda x, y: area_irradiance(film.on_floor(x, y), -0.5, 0.5, -0.5, 0.5, 1, 1), n=3))]


def first_bounce(scene):
    light = scene["shapes"][1]["vertices"]
    p = scene["camera"]["look_at"]
    return [(lambert_irradiance(p, light, 1), area_irradiance(p, -0.5, 0.5, -0.5, 0.5, 1, 1))]


def form_factor(scene):
    root = math.sqrt(2)
    closed = 2 / PI * (math.log(math.sqrt(4 / 3)) + 2 * root * math.atan(1 / root) - 2 * math.atan(1))
    film = Film(scene)

    def pixel(x, y):
        p = (x / film.width - 0.5, 0, y / film.height - 0.5)
        return area_irradiance(p, -0.5, 0.5, -0.5, 0.5, 1, 1, 10) / PI
    return [(closed, film.mean(pixel, n=10))]


def sphere_light(scene):
    film = Film(scene)
    lamp = scene["shapes"][0]
    r, centre = lamp["radius"], lamp["center"]
    radiance = scene["materials"]["lamp"]["emission"][0]

    def closed(x, y):
        return radiance * r * r * centre[1] / length(subtract(film.on_floor(x, y), centre)) ** 3

    def cone(x, y):  # integral of L cos over the cone of directions that the sphere fills, over pi
        p = film.on_floor(x, y)
        to = subtract(centre, p)
        d = length(to)
        tilt_cos = to[1] / d
        tilt_sin = math.sqrt(1 - tilt_cos ** 2)
        cos_max = math.sqrt(1 - (r / d) ** 2)
        ring = [math.cos(2 * PI * (j + 0.5) / 8) for j in range(8)]

        def over(c):
            s = math.sqrt(1 - c * c)
            return math.fsum(max(0.0, tilt_cos * c + tilt_sin * s * k) for k in ring) / 8
        return radiance * 2 * integrate(over, cos_max, 1, 8)

    colour = scene["materials"]["floor"]["reflectance"]
    region = scene["expect"][0]["region"]
    a, b = film.mean(closed, region, 12), film.mean(cone, region, 12)
    middle = [film.direction(x, y) for x in (60, 68) for y in (44, 52)]  # the lamp fills the square
    inside = all(length(cross(subtract(centre, film.position), d)) < 0.9 * r for d in middle)
    return [([c * a for c in colour], [c * b for c in colour]), (radiance, radiance if inside else 0.0)]


def thin_lens(scene):
    camera = scene["camera"]
    film = Film(scene)
    aperture, focus = camera["lens_radius"], camera["focus_distance"]
    side = 2 * scene["shapes"][0]["vertices"][1][0]
    z = -scene["shapes"][0]["vertices"][0][2]
    radiance = scene["materials"]["emitter"]["emission"][0]
    blur = 1 - z / focus

    flat = radiance * side ** 2 / (PI * aperture ** 2 * blur ** 2)
    energy = radiance * (side / z) ** 2 / (2 * film.half_width * 2 * film.half_height)

    # The square as seen from points of the lens, on a grid: which part of each film row is bright.
    n = 600
    lens = [(aperture * (2 * (i + 0.5) / n - 1), aperture * (2 * (j + 0.5) / n - 1))
            for i in range(n) for j in range(n)]
    lens = [(x, y) for x, y in lens if x * x + y * y < aperture ** 2]

    def overlap(l, half, a, b):  # of [a, b] on the film with the square, along one axis
        low, high = ((s * side / 2 - l * blur) / z / half for s in (-1, 1))
        return max(0.0, min(high, b) - max(low, a))

    def mean(x0, x1):  # over a centred square of the film, in units of its half
        return radiance * math.fsum(overlap(x, film.half_width, x0, x1) * overlap(y, film.half_height, x0, x1)
                                    for x, y in lens) / len(lens) / (x1 - x0) ** 2
    flat_half = scene["expect"][0]["region"][2] / film.width * 2 - 1
    return [(flat, mean(-flat_half, flat_half), 2e-4), (energy, mean(-1, 1))]


def ggx_furnace(scene):
    film = Film(scene)

    def shadowed(cos_t):  # Lambda of Smith's G for alpha = 1
        return (1 / cos_t - 1) / 2

    def albedo(mu):  # D G / (4 mu c) times c over the hemisphere, D = 1 / pi whatever the half vector
        return integrate(lambda c: 2 * PI * c / (PI * 4 * mu * c * (1 + shadowed(mu) + shadowed(c))), 0, 1, 40)
    return [(1 - math.log(2), film.mean(lambda x, y: albedo(-film.direction(x, y)[2]), n=4), 3e-5)]


SCENES = {
    "white_furnace": furnace, "furnace_box": furnace, "furnace_deep": furnace,
    "no_ray_ends": furnace, "all_end_at_once": even_sky, "tiny_image": even_sky,
    "point_in_sphere": point_in_sphere, "chord_furnace": chord_furnace,
    "glass_furnace": glass_furnace, "glass_pane": glass_pane, "soft_shadow": soft_shadow,
    "polygon_light": polygon_light, "first_bounce": first_bounce, "form_factor": form_factor, "sphere_light": sphere_light,
    "thin_lens": thin_lens, "ggx_furnace": ggx_furnace,
}


def rgb(value):
    return list(value) if isinstance(value, (list, tuple)) else [value] * 3


def close(a, b, tolerance):
    return all(abs(x - y) <= tolerance * abs(x) for x, y in zip(a, b))


def main():
    root = pathlib.Path(__file__).resolve().parents[2] / "scenes"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else root
    failed = 0
    for path in sorted(folder.glob("*.json")):
        scene = json.loads(path.read_text())
        if "shapes" not in scene or ("expect" not in scene and path.stem not in SCENES):
            continue
        found = SCENES[path.stem](scene)
        assert len(found) == len(scene["expect"]), path.stem
        for entry, (closed, other, *bound) in zip(scene["expect"], found):
            closed, other, stated = rgb(closed), rgb(other), rgb(entry["value"])
            agrees = close(closed, other, bound[0] if bound else 1e-8)
            right = close(closed, stated, 1e-9)
            failed += not (agrees and right)
            print(f"{path.stem:16} {'ok' if agrees and right else 'WRONG'}  file {stated}  "
                  f"closed form {closed}  quadrature {other}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
