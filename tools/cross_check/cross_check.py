#!/usr/bin/env python3
"""Compare raylab with Mitsuba 3, which shares no code with it.

    python3 -m venv build/cross_check
    build/cross_check/bin/pip install mitsuba numpy
    build/cross_check/bin/python tools/cross_check/cross_check.py --raylab build/cpu/app/raylab

renders every scene of plan.py several times with both, each time with other random numbers, and asks
whether the means differ by more than the spread of the replicates allows: over the whole image and
in each tile. Exit code 1 if they do for any scene. The variant llvm_ad_rgb is several times faster
than scalar_rgb and wants LLVM 16 or newer (DRJIT_LIBLLVM_PATH names its library).

That it can fail: `--scale-albedo white 1.05 cornell` gives raylab alone a scene with one albedo
5 % higher.
"""
import argparse
import json
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import agreement
import picture
import plan


def read_pfm(path):
    with open(path, "rb") as file:
        assert file.readline() == b"PF\n"
        width, height = map(int, file.readline().split())
        assert float(file.readline()) < 0  # little endian
        data = np.frombuffer(file.read(), "<f4")
    return data.reshape(height, width, 3)[::-1].astype(float)  # rows are stored bottom first


def render_raylab(raylab, scene, folder, options, seeds):
    images = []
    for seed in seeds:
        out = folder / "raylab.pfm"
        subprocess.run([raylab, "render", "02", scene, *options, "--seed", str(seed), "-q", "-o", out],
                       check=True)
        images.append(read_pfm(out))
    return np.array(images)


def render_mitsuba(xml, spp, seeds):
    import mitsuba as mi

    scene = mi.load_file(str(xml))
    return np.array([np.array(mi.render(scene, spp=spp, seed=seed), float) for seed in seeds])


def check(name, arguments, folder):
    _, _, width, height, spp = plan.SCENES[name]
    spp *= arguments.effort
    folder = folder / name
    folder.mkdir(parents=True, exist_ok=True)
    options = ["--width", str(width), "--height", str(height), "--spp", str(spp)]
    # Seeds of its own for each scene: with common ones chance would favour the same pixels in all.
    first = arguments.first_seed + 1000 * list(plan.SCENES).index(name)
    seeds = range(first, first + arguments.replicates)

    scene = plan.scene_file(name, folder)
    subprocess.run([arguments.raylab, "export", scene, "--mitsuba", "-q", "-o", folder / "mitsuba",
                    *options], check=True)
    ours_scene = plan.scene_file(name, folder, arguments.scale_albedo)
    start = time.perf_counter()
    ours = render_raylab(arguments.raylab, ours_scene, folder, options, seeds)
    middle = time.perf_counter()
    theirs = render_mitsuba(folder / "mitsuba" / "scene.xml", spp, seeds)
    end = time.perf_counter()

    result, z = agreement.compare(ours, theirs)
    result |= {"scene": name, "width": width, "height": height, "spp": spp,
               "replicates": arguments.replicates, "seconds_raylab": middle - start,
               "seconds_mitsuba": end - middle}
    picture.side_by_side(folder / "compare.png", ours.mean(axis=0), theirs.mean(axis=0), z)
    np.savez_compressed(folder / "images.npz", raylab=ours.astype("f4"), mitsuba=theirs.astype("f4"))
    (folder / "result.json").write_text(json.dumps(result, indent=1) + "\n")
    return result


HEADER = ("| scene | film | spp | mean raylab | mean Mitsuba | difference | z | worst of r, g, b "
          "| worst tile | chi^2 / tiles | p |\n|---|---|---|---|---|---|---|---|---|---|---|")


def row(r):
    return (f"| {r['scene']} | {r['width']}x{r['height']} | {r['replicates']} x {r['spp']} "
            f"| {np.mean(r['mean_raylab']):.6g} | {np.mean(r['mean_other']):.6g} "
            f"| {100 * r['relative_difference']:+.4f} % ± {100 * r['relative_standard_error']:.4f} "
            f"| {r['z']:+.2f} | {max(r['z_rgb'], key=abs):+.2f} | {r['largest_tile_z']:+.2f} "
            f"| {r['chi_square']:.0f} / {r['tiles']} | {r['p']:.2g} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", help=f"of {', '.join(plan.SCENES)}; default: all")
    parser.add_argument("--raylab", default="./raylab", help="the program")
    parser.add_argument("--variant", default="scalar_rgb", help="of Mitsuba (default scalar_rgb)")
    parser.add_argument("--replicates", type=int, default=16)
    parser.add_argument("--first-seed", type=int, default=1, help="fresh random numbers")
    parser.add_argument("--effort", type=int, default=1, help="factor on the plan's spp")
    parser.add_argument("--scale-albedo", nargs=2, metavar=("MATERIAL", "FACTOR"),
                        help="plant this error on raylab's side")
    parser.add_argument("-o", "--output", type=Path, default=Path("out/cross_check"))
    arguments = parser.parse_args()
    if arguments.scale_albedo:
        material, factor = arguments.scale_albedo
        arguments.scale_albedo = (material, float(factor))

    import mitsuba as mi
    mi.set_variant(arguments.variant)
    mi.set_log_level(mi.LogLevel.Error)
    print(f"Mitsuba {mi.__version__}, {arguments.variant}\n\n{HEADER}", flush=True)
    failed = []
    for name in arguments.scenes or plan.SCENES:
        result = check(name, arguments, arguments.output)
        print(row(result), flush=True)
        if agreement.disagree(result):
            failed.append(name)
    print(f"\n{'disagree: ' + ', '.join(failed) if failed else 'all agree'}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
