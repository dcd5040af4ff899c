#!/usr/bin/env python3
"""Makes every figure of the handouts again: from renders of raylab, or drawn.

    python3 tools/figures/figures.py                       # all, with build/cpu/app/raylab
    python3 tools/figures/figures.py --only lanes error    # some of them
    python3 tools/figures/figures.py --program build/mine/app/raylab

Needs the program (`./raylab render 01 cornell` builds it) and Pillow (`pip install pillow`), which
reduces pictures to 256 colours: noise does not compress, and a handout should load at once.
The pictures of mistakes are renders of wrong programs, built one after the other in build/figures.
What the files *_drawings.py draw needs no program: they compute it themselves.
Every function below is one figure: its scene, samples and seed stand in the caption too.
"""
import argparse
import array
import csv
import json
import math
import pathlib
import shutil
import subprocess
import tempfile

from PIL import Image

import box_drawings
import heuristic_drawings
import kd_drawings
import scan_drawings
import walk_drawings
import wavefront_drawings
from plot import COLOURS, INK, Plot, save_beside

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAB01, LAB02, LAB03, LAB04 = FOLDERS = [
    ROOT / "labs" / lab / "figures"
    for lab in ("01_recursive", "02_iterative", "03_wavefront", "04_accel")]


class Raylab:
    def __init__(self, program, scratch, build):
        self.program, self.scratch, self.build = program, scratch, build

    def render(self, lab, scene, name, *options):
        """Renders into the scratch folder; returns the image's path."""
        output = self.scratch / name
        subprocess.run([self.program, "render", lab, scene, "-q", "-o", output, *map(str, options)],
                       check=True, cwd=ROOT)
        return output

    def picture(self, lab, scene, target, *options):
        """A picture of the handout: rendered, then reduced to 256 colours."""
        reduce(self.render(lab, scene, target.name, *options), target)

    def snapshot(self, name, iterations):
        stem, ending = name.split(".")
        return self.scratch / f"{stem}_{iterations:04}.{ending}"

    def ledger(self, scene, *options, lab="02"):
        stats = self.scratch / "stats.json"
        self.render(lab, scene, "ledger.pfm", "--stats", stats, *options)
        return json.loads(stats.read_text())


def reduce(png, target):
    target.parent.mkdir(exist_ok=True)
    picture = Image.open(png).convert("RGB")
    picture.quantize(256, method=Image.Quantize.MEDIANCUT).save(target, optimize=True)


def run_quietly(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def square(pixels):
    return "--width", pixels, "--height", pixels


# --- lab 01 --------------------------------------------------------------------------------------

def whitted(raylab):
    raylab.picture("01", "whitted", LAB01 / "whitted.png", "--spp", 64)


def cornell(raylab):
    raylab.picture("01", "cornell", LAB01 / "cornell.png", "--spp", 256)


def spheres(raylab):
    """Whitted's tracer and the path tracer on one scene."""
    for integrator in ("whitted", "path"):
        raylab.picture("01", "cornell_spheres", LAB01 / f"spheres_{integrator}.png", "--spp", 256,
                       "--integrator", integrator, *square(192))


def lens(raylab):
    raylab.picture("01", "depth_of_field", LAB01 / "depth_of_field.png", "--spp", 64)


def depth(raylab):
    """What one more surface brings; depth 2 is direct light only."""
    for surfaces in range(1, 6):
        raylab.picture("01", "cornell", LAB01 / f"depth_{surfaces}.png", "--spp", 32, "--depth",
                       surfaces, *square(160))


def strategies(raylab):
    """How a lamp is found: by shadow rays, by chance, by both."""
    for strategy in ("bsdf", "light", "mis"):
        raylab.picture("01", "cornell", LAB01 / f"strategy_{strategy}.png", "--spp", 4,
                       "--direct-light", strategy, *square(192))


def hemisphere(_):
    """Uniform and cosine-weighted directions, and what one of them is worth under an even sky."""
    plot = Plot("One sample of the light of an even sky of radiance 1",
                "angle to the normal (degrees)", "estimate / mean", (0, 90), (0, 2.1))
    plot.ticks(range(0, 91, 15), (0, 0.5, 1, 1.5, 2))
    angles = range(0, 91, 2)
    plot.curve([(a, 2 * math.cos(math.radians(a))) for a in angles], "uniform", COLOURS[0],
               dots=False)
    plot.curve([(a, 1) for a in angles], "cosine", COLOURS[1], dots=False)
    plot.save(LAB01 / "hemisphere.svg")


def fresnel(_):
    def exact(cosine, eta):
        sine2 = (1 - cosine * cosine) / (eta * eta)
        if sine2 >= 1:
            return 1
        far = math.sqrt(1 - sine2)
        return (((eta * cosine - far) / (eta * cosine + far)) ** 2
                + ((cosine - eta * far) / (cosine + eta * far)) ** 2) / 2

    def schlick(cosine):
        return 0.04 + 0.96 * (1 - cosine) ** 5

    plot = Plot("Light reflected by glass of index 1.5", "angle to the normal (degrees)",
                "reflected part F", (0, 90), (0, 1.02))
    plot.ticks(range(0, 91, 15), (0, 0.2, 0.4, 0.6, 0.8, 1))
    angles = [a / 4 for a in range(0, 361)]
    cosines = [(a, math.cos(math.radians(a))) for a in angles]
    plot.curve([(a, exact(c, 1 / 1.5)) for a, c in cosines], "from inside", COLOURS[0],
               dots=False, dy=-7)
    plot.curve([(a, exact(c, 1.5)) for a, c in cosines], "from outside", COLOURS[1], dots=False,
               dy=8)
    plot.curve([(a, schlick(c)) for a, c in cosines], "Schlick, outside", COLOURS[2], dots=False,
               dash="5 4", dy=23)
    plot.save(LAB01 / "fresnel.svg")


# Wrong programs, for the handouts' "how they look": file, what is right in it, what is put there,
# and the scene and options that show it.
BOX = ("cornell", "--spp", 16, *square(160))
HALL = ("stadium", "--spp", 4, *square(160))
MISTAKES = {
    LAB01: {
        "acne": ("direct_light.h", "spawn_ray_to(surface, sample.p, sample.error, sample.n)",
                 "Ray{surface.p, sample.wi, sample.distance}", BOX),
        "first_hit": ("intersect.h", "if (hit.is_beaten_by(t, id))", "if (!hit.found())", BOX),
        "twice": ("path.cpp", "scattered.specular ? delta_pdf : scattered.pdf", "delta_pdf", BOX),
        "cosine": ("cosine.h", "return {wi, albedo, wi.z", "return {wi, albedo * wi.z, wi.z", BOX),
    },
    LAB03: {
        "throughput": ("shade.h", "throughput * shadow_ray.light);", "shadow_ray.light);", BOX),
        "branches": ("shade_whitted.h",
                     "surface, reflectance, wo);\n        return next_branch(pool, slot);",
                     "surface, reflectance, wo);\n"
                     "        return end_path(pool, slot, PathEnd::absorbed);",
                     ("whitted", "--spp", 16, *square(160))),
        "tiles": ("scan_efficient.cu",
                  "sums[blockIdx.x] = tree[padded(t)];\n        tree[padded(t)] = 0;",
                  "tree[padded(t)] = 0;\n        sums[blockIdx.x] = tree[padded(t)];",
                  (*BOX, "--scan", "efficient")),
        "copies": ("shared_geometry.h", "move_to_shared(scene.quads, free);",
                   "free = static_cast<unsigned char*>(memory), move_to_shared(scene.quads, free);",
                   ("cornell_spheres", *BOX[1:], "--shared-geometry")),
        "cache": ("first_bounce_cache.h", "if (scene.render.jitter)", "if (false)",
                  ("whitted", "--spp", 16, *square(128), "--first-bounce-cache")),
    },
    LAB04: {
        "one_side": ("kd/build.cpp", "            if (high <= plane.at) {",
                     "            if (low + high < 2 * plane.at) {\n"
                     "                work_[kept++] = reference;\n"
                     "            } else if (low + high >= 2 * plane.at) {\n"
                     "                later_.push_back(reference);\n"
                     "            } else if (high <= plane.at) {",
                     (*HALL, "--accel", "kd", "--walk", "stack")),
        "part_of_face": ("kd/ropes.cpp", "} else if (node.split <= cell.low[axis]) {",
                         "} else if (node.split < cell.high[axis]) {",
                         (*HALL, "--accel", "kd", "--walk", "ropes")),
        "first_hit": ("kd/walk_ropes.h", "        if (visit_leaf(node, query)) return;",
                      "        const float before = query.reach();\n"
                      "        if (visit_leaf(node, query) || query.reach() < before) return;",
                      (*HALL, "--accel", "kd", "--walk", "ropes")),
        "from": ("bvh/walk_parent.h", "        from = -1;\n        if (next >= 0) {",
                 "        if (next >= 0) {", (*HALL, "--accel", "sah", "--walk", "parent")),
    },
}


def mistakes(raylab):
    """Each mistake is built into a copy of its lab, laid over the tree, and rendered."""
    overlay = raylab.scratch / "overlay"
    configure = ["cmake", "-S", ROOT, "-B", raylab.build, "-G", "Ninja"]
    program = Raylab(raylab.build / "app/raylab", raylab.scratch, raylab.build)
    for figures, planted in MISTAKES.items():
        folder = figures.parent
        for name, (file, right, wrong, (scene, *options)) in planted.items():
            shutil.rmtree(overlay, ignore_errors=True)
            shutil.copytree(folder, overlay / "labs" / folder.name)
            copy = overlay / "labs" / folder.name / file
            source = copy.read_text()
            assert source.count(right) == 1, f"{file}: \"{right}\" should stand there once"
            copy.write_text(source.replace(right, wrong))
            run_quietly(*configure, f"-DRAYLAB_OVERLAY={overlay}")
            run_quietly("ninja", "-C", raylab.build, "raylab")
            program.picture(folder.name[:2], scene, figures / f"mistake_{name}.png", *options)
    run_quietly(*configure, "-URAYLAB_OVERLAY")


# --- lab 02 --------------------------------------------------------------------------------------

def progressive(raylab):
    """The lecture's 1, 20 and 250 iterations, out of one run."""
    raylab.render("02", "cornell", "cornell.png", "--spp", 250, "--snapshots", "1,20,250",
                  *square(192))
    for n in (1, 20, 250):
        reduce(raylab.snapshot("cornell.png", n), LAB02 / f"iterations_{n}.png")


def roulette(raylab):
    for on, name in (("true", "on"), ("false", "off")):
        raylab.picture("02", "cornell", LAB02 / f"roulette_{name}.png", "--spp", 16, "--roulette",
                       on, *square(192))


def lanes(raylab):
    """Lanes at work, bounce by bounce, from the ledgers."""
    plot = Plot("Lanes at work, of those that warps hold", "bounce", "share of lanes", (0, 9),
                (0, 1.02))
    plot.ticks(range(10), (0, 0.2, 0.4, 0.6, 0.8, 1), y_format="{:.0%}")
    curves = [("white_furnace", (), -8), ("cornell, no roulette", ("--roulette", "false"), 10),
              ("cornell", (), -2), ("cornell_spheres", (), -8), ("whitted", (), 0)]
    for (name, options, dy), colour in zip(curves, COLOURS):
        bounces = raylab.ledger(name.split(",")[0], "--spp", 4, *options)["bounces"]
        points = [(b, row["lanes_share"]) for b, row in enumerate(bounces[:10]) if row["rays"]]
        plot.curve(points, name, colour, dy=dy)
    plot.save(LAB02 / "lanes.svg")


def error(raylab):
    """Half the mean square of the difference of two seeds is the variance: no reference needed."""
    counts = [2 ** k for k in range(9)]
    plot = Plot("Cornell box: error against iterations", "iterations n",
                "relative error of a pixel", (1, 256), (0.02, 2), log=True)
    plot.ticks(counts, (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2), y_format="{:.0%}")
    for sampler, colour in zip(("independent", "sobol"), COLOURS):
        snapshots = ",".join(map(str, counts))
        for seed in (1, 2):
            raylab.render("02", "cornell", f"{sampler}{seed}.pfm", "--spp", counts[-1], "--seed",
                          seed, "--sampler", sampler, "--snapshots", snapshots, *square(64))
        last = [read_pfm(raylab.scratch / f"{sampler}{seed}.pfm") for seed in (1, 2)]
        means = [(a + b) / 2 for a, b in zip(*last)]
        points = []
        for n in counts:
            one, two = (read_pfm(raylab.snapshot(f"{sampler}{seed}.pfm", n)) for seed in (1, 2))
            squares = [(a - b) ** 2 / 2 / (m * m) for a, b, m in zip(one, two, means) if m > 1e-3]
            points.append((n, math.sqrt(sum(squares) / len(squares))))
        print(sampler, ", ".join(f"{n}: {e:.3f}" for n, e in points))
        plot.curve(points, sampler, colour)
        if sampler == "independent":
            first = points[0][1]
            plot.curve([(n, first / math.sqrt(n)) for n in counts], "1 / sqrt(n)", INK, dots=False,
                       dash="4 4", dy=-15)
    plot.save(LAB02 / "error.svg")


# --- lab 03 --------------------------------------------------------------------------------------

def wavefront_lanes(raylab):
    """The same paths with a thread a pixel, and with a list that is compacted after each bounce."""
    plot = Plot("Lanes at work, of those that warps hold", "bounce", "share of lanes", (0, 9),
                (0, 1.02))
    plot.ticks(range(10), (0, 0.2, 0.4, 0.6, 0.8, 1), y_format="{:.0%}")
    curves = [("03", "03", ("--compact", "on"), -8),
              ("03, --compact 3", "03", ("--compact", "3"), 10), ("02", "02", (), 0)]
    for (name, lab, options, dy), colour in zip(curves, COLOURS):
        bounces = raylab.ledger("cornell", "--spp", 4, *options, lab=lab)["bounces"]
        plot.curve([(b, row["lanes_share"]) for b, row in enumerate(bounces[:10]) if row["rays"]],
                   name, colour, dy=dy)
    plot.save(LAB03 / "lanes.svg")


def jitter(raylab):
    raylab.picture("03", "whitted", LAB03 / "jitter.png", "--spp", 16, *square(128))


# --- lab 04 --------------------------------------------------------------------------------------

def stadium(raylab):
    """A small object in a large hall, through eight boxes a node."""
    raylab.picture("04", "stadium", LAB04 / "stadium.png", "--spp", 64, "--accel", "wide",
                   *square(288))


def scaling(raylab):
    """What building and a ray cost as a mesh grows: every structure and walk, and all triangles."""
    folder = raylab.scratch / "scaling"
    structures = ["embree", "kd_stack", "kd_ropes", "kd_restart", "lbvh_trail", "sah_stack",
                  "sah_skip", "sah_parent", "sah_trail", "wide_stack", "wide_trail", "brute"]
    run_quietly(raylab.program, "bench-rays", "--scaling", "terrain", "--triangles", "100..4000000",
                "--structures", *structures, "--rays", "diffuse1", "--size", "128x128",
                "--builds", "3", "-o", folder)
    with open(folder / "rays.csv", newline="", encoding="utf-8") as table:
        rows = [row for row in csv.DictReader(table) if row["mrays_per_second"]]
    build, trace = {}, {}  # name: (triangles, figure) pairs
    for row in rows:
        name, n = row["structure"], int(row["triangles"])
        trace.setdefault(name, []).append((n, 1000 / float(row["mrays_per_second"])))
        if row["build_seconds"]:
            build.setdefault(name, []).append((n, 1e6 * float(row["build_seconds"]) / n))
    print_scaling(build, trace)

    # A colour for what is built, a line for each of its walks: "sah_skip".
    built = list(dict.fromkeys(name.split("_")[0] for name in trace))
    colours = {name: ([*COLOURS, INK])[built.index(name.split("_")[0])] for name in trace}
    walks = {what: [name for name in trace if name.split("_")[0] == what] for what in built}
    ticks = [10**k for k in range(2, 7)]
    left = Plot("Building", "triangles of a hilly terrain", "microseconds a triangle", (80, 4.5e6),
                (0.06, 1.2), log=True, width=500, height=400)
    left.ticks(ticks, (0.1, 0.2, 0.5, 1), x_format="{:,}")
    right = Plot("A ray after one bounce", "triangles", "nanoseconds", (80, 4.5e6), (40, 1e4),
                 log=True, width=500, height=400)
    right.ticks(ticks, (100, 1000, 10_000), x_format="{:,}", y_format="{:,}")
    trace["brute"] = [(n, t) for n, t in trace["brute"] if t < 1e4]  # soon leaves the picture
    for what in built:
        first = walks[what][0]
        if first in build:
            left.curve(build[first], "", colours[first])
        for name, dash in zip(walks[what], ("", "7 4", "2 3", "9 3 2 3")):
            right.curve(trace[name], "all triangles" if name == "brute" else "", colours[name],
                        dots=not dash, dash=dash)
    left.names([(build[walks[what][0]][-1], what, colours[walks[what][0]])
                for what in built if walks[what][0] in build])
    right.names([(points[-1], name, colours[name])
                 for name, points in trace.items() if name != "brute"])
    save_beside(LAB04 / "scaling.svg", [left, right])


def print_scaling(build, trace):
    """For docs/measurements: time of a ray, and building where a structure has its first walk."""
    counts = [n for n, _ in max(trace.values(), key=len)]
    for title, curves, form in (("a ray, ns", trace, "{:.0f}"),
                                ("building, us a triangle", build, "{:.2f}")):
        print(f"| {title} | " + " | ".join(curves) + " |")
        print("|---" * (len(curves) + 1) + "|")
        for n in counts:
            cells = [form.format(dict(points)[n]) if n in dict(points) else "-"
                     for points in curves.values()]
            print(f"| {n:,} | " + " | ".join(cells) + " |")


# --- drawings ------------------------------------------------------------------------------------

def drawings(_):
    for folder, module in ((LAB03, wavefront_drawings), (LAB03, scan_drawings),
                           (LAB04, heuristic_drawings), (LAB04, kd_drawings),
                           (LAB04, box_drawings), (LAB04, walk_drawings)):
        for name, draw in module.DRAWINGS.items():
            draw(folder / f"{name}.svg")


def read_pfm(path):
    """All channels of a little-endian colour PFM, in the file's order."""
    kind, _size, scale, data = path.read_bytes().split(b"\n", 3)
    assert kind == b"PF" and float(scale) < 0, f"{path}: not a little-endian colour PFM"
    values = array.array("f")
    values.frombytes(data)
    return values


FIGURES = [whitted, cornell, spheres, lens, depth, strategies, hemisphere, fresnel, mistakes,
           progressive, roulette, lanes, error, wavefront_lanes, jitter, stadium, scaling, drawings]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/cpu/app/raylab")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/figures",
                        help="folder in which wrong programs are built (%(default)s)")
    parser.add_argument("--only", nargs="+", choices=[f.__name__ for f in FIGURES])
    options = parser.parse_args()
    if not options.program.is_file():
        parser.error(f"{options.program} is not there: build it, or name another with --program")
    for folder in FOLDERS:
        folder.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        raylab = Raylab(options.program.resolve(), pathlib.Path(scratch),
                        options.build.resolve())
        for figure in FIGURES:
            if not options.only or figure.__name__ in options.only:
                print(figure.__name__, flush=True)
                figure(raylab)


if __name__ == "__main__":
    main()
