#!/usr/bin/env python3
"""Makes the meshes, textures and the sky of scenes/; needs Python's standard library only.

    python3 tools/scenes/generate.py            write the files
    python3 tools/scenes/generate.py --check    fail if a committed file differs from what would be written
"""
import os
import pathlib
import sys

import chess
import dusk
import menger
import shelf
import vase
from png import checker

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"


def floor_obj(half, repeats):
    """A square of floor at y = 0 facing up, its texture repeated."""
    corners = ((-1, 1), (1, 1), (1, -1), (-1, -1))
    lines = ["# A floor; made by tools/scenes/generate.py"]
    lines += [f"v {half * x:g} 0 {half * z:g}" for x, z in corners]
    lines += [f"vt {repeats * (x + 1) / 2:g} {repeats * (1 - z) / 2:g}" for x, z in corners]
    lines += ["f 1/1 2/2 3/3", "f 1/1 3/3 4/4"]
    return "\n".join(lines) + "\n"


def files():
    vase_text, _ = vase.vase_obj()
    return {
        "meshes/floor.obj": floor_obj(16, 16).encode(),
        "meshes/vase.obj": vase_text.encode(),
        "meshes/menger.obj": menger.menger_obj().encode(),
        "meshes/chess.glb": chess.chess_glb(),
        "meshes/pawn.gltf": chess.pawn_gltf(),
        "meshes/shelf.glb": shelf.shelf_glb(),
        "textures/checker.png": checker(64, (214, 178, 62), (150, 28, 26)),
        "textures/vase.png": vase.vase_png(),
        "textures/dusk.hdr": dusk.dusk_hdr(),
    }


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        print(__doc__)
        return 2
    different = 0
    for name, data in files().items():
        path = SCENES / name
        same = path.exists() and path.read_bytes() == data
        different += not same
        if not check and not same:
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary = path.with_suffix(path.suffix + ".tmp")
            temporary.write_bytes(data)
            os.replace(temporary, path)
        print(f"{'same' if same else 'differs' if check else 'written':8} {len(data):8} bytes  {name}")
    return 1 if check and different else 0


if __name__ == "__main__":
    sys.exit(main())
