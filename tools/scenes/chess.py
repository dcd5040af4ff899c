"""Chess pieces: turned meshes in a GLB whose nodes place them, and a lone pawn as a text glTF.

The GLB uses what readers get wrong: nested nodes with rotation, scale and a mirroring matrix, interleaved
vertices, indices of 8 and 16 bits, one mesh under several nodes, a texture inside the file.
"""
import base64
import json
import math
import struct

from lathe import profile_normals, smooth_profile, tidy, turn
from png import checker

SEGMENTS = 20
PAWN = [(0, 0), (0.36, 0), (0.38, 0.07), (0.34, 0.15), (0.24, 0.24), (0.15, 0.48), (0.14, 0.62), (0.25, 0.68),
        (0.14, 0.74), (0.21, 0.84), (0.215, 0.94), (0.13, 1.06), (0, 1.09)]
BISHOP = [(0, 0), (0.40, 0), (0.42, 0.08), (0.37, 0.18), (0.25, 0.28), (0.15, 0.70), (0.15, 0.90), (0.28, 0.96),
          (0.15, 1.02), (0.24, 1.16), (0.22, 1.32), (0.08, 1.50), (0.09, 1.57), (0, 1.62)]
QUEEN = [(0, 0), (0.45, 0), (0.47, 0.09), (0.41, 0.20), (0.27, 0.32), (0.17, 0.85), (0.16, 1.20), (0.31, 1.27),
         (0.17, 1.34), (0.22, 1.52), (0.33, 1.74), (0.26, 1.80), (0.10, 1.81), (0.11, 1.92), (0, 1.96)]


def turned(points):
    """Vertices (position, normal) and triangles of one piece."""
    profile = smooth_profile(points, 1)
    normals = profile_normals(profile)
    normals[0], normals[1], normals[-1] = (0, -1), (0.7071, -0.7071), (0, 1)
    rings, triangles = turn(profile, SEGMENTS)
    vertices, first = [], []
    for ring, (radial, up) in zip(rings, normals):
        first.append(len(vertices))
        for j, p in enumerate(ring):
            a = 2 * math.pi * j / SEGMENTS
            n = (radial * math.sin(a), up, radial * math.cos(a)) if len(ring) > 1 else (0, up, 0)
            vertices.append(p + tuple(map(tidy, n)))
    index = [first[i] + j % len(rings[i]) for t in triangles for i, j in t]
    return vertices, index


def floats(rows):
    return b"".join(struct.pack(f"<{len(r)}f", *r) for r in rows)


class Document:
    """Collects one binary buffer and the glTF that describes it."""

    def __init__(self):
        self.binary = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": "raylab tools/scenes/generate.py"},
                     "bufferViews": [], "accessors": [], "meshes": []}

    def view(self, data, **more):
        self.binary += bytes(-len(self.binary) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary),
                                         "byteLength": len(data), **more})
        self.binary += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, **fields):
        self.json["accessors"].append(fields)
        return len(self.json["accessors"]) - 1

    def mesh(self, name, vertices, index, material=None, uv=False, colours=False):
        """vertices: rows of position, normal and perhaps uv or an RGB colour, interleaved in one view."""
        small = len(vertices) < 256
        stride = 4 * len(vertices[0])
        data = self.view(floats(vertices), byteStride=stride)
        low = [min(v[k] for v in vertices) for k in range(3)]
        high = [max(v[k] for v in vertices) for k in range(3)]
        common = {"bufferView": data, "componentType": 5126, "count": len(vertices)}
        attributes = {"POSITION": self.accessor(**common, type="VEC3", min=low, max=high),
                      "NORMAL": self.accessor(**common, type="VEC3", byteOffset=12)}
        if uv:
            attributes["TEXCOORD_0"] = self.accessor(**common, type="VEC2", byteOffset=24)
        if colours:
            attributes["COLOR_0"] = self.accessor(**common, type="VEC3", byteOffset=24)
        indices = self.view(struct.pack(f"<{len(index)}{'B' if small else 'H'}", *index))
        primitive = {"attributes": attributes, "indices": self.accessor(
            bufferView=indices, componentType=5121 if small else 5123, count=len(index), type="SCALAR")}
        if material is not None:
            primitive["material"] = material
        self.json["meshes"].append({"name": name, "primitives": [primitive]})
        return len(self.json["meshes"]) - 1

    def text(self):
        return json.dumps(self.json, separators=(",", ":")).encode()

    def glb(self):
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = self.text()
        text += b" " * (-len(text) % 4)
        binary = bytes(self.binary) + bytes(-len(self.binary) % 4)
        chunks = (struct.pack("<II", len(text), 0x4E4F534A) + text +
                  struct.pack("<II", len(binary), 0x004E4942) + binary)
        return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def box(low, high):
    """A box with flat faces: 24 vertices."""
    vertices, index = [], []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            normal = [0.0, 0.0, 0.0]
            normal[axis] = 2.0 * side - 1
            start = len(vertices)
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p = [0.0, 0.0, 0.0]
                p[axis] = (low, high)[side][axis]
                p[u] = (low, high)[du][u]
                p[v] = (low, high)[dv][v]
                vertices.append(tuple(p) + tuple(normal))
            order = (0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2)
            index += [start + k for k in order]
    return vertices, index


def chess_glb():
    doc = Document()
    image = doc.view(checker(64, (226, 205, 170), (70, 44, 32)))
    colours = {"ivory": (0.78, 0.70, 0.54), "ebony": (0.055, 0.045, 0.045), "wood": (0.20, 0.085, 0.04)}
    doc.json["materials"] = [{"name": n, "pbrMetallicRoughness": {"baseColorFactor": [*c, 1], "metallicFactor": 0}}
                             for n, c in colours.items()]
    doc.json["materials"].append({"name": "squares", "pbrMetallicRoughness": {
        "baseColorTexture": {"index": 0}, "metallicFactor": 0}})
    doc.json["images"] = [{"bufferView": image, "mimeType": "image/png"}]
    doc.json["textures"] = [{"source": 0}]

    ivory, ebony, wood, squares = range(4)
    board = doc.mesh("board", [(-2.5, 0, -2.5, 0, 1, 0, 0, 0), (2.5, 0, -2.5, 0, 1, 0, 2.5, 0),
                               (2.5, 0, 2.5, 0, 1, 0, 2.5, 2.5), (-2.5, 0, 2.5, 0, 1, 0, 0, 2.5)],
                     [0, 2, 1, 0, 3, 2], squares, uv=True)
    frame = doc.mesh("frame", *box((-2.7, -0.25, -2.7), (2.7, -0.01, 2.7)), wood)
    pawn = doc.mesh("pawn", *turned(PAWN), ivory)
    dark_pawn = doc.mesh("dark pawn", *turned(PAWN), ebony)
    bishop = doc.mesh("bishop", *turned(BISHOP), ivory)
    queen = doc.mesh("queen", *turned(QUEEN), ebony)

    turn30 = [0, round(math.sin(math.radians(-14)), 6), 0, round(math.cos(math.radians(-14)), 6)]
    fallen = [0, 0, round(math.sin(math.radians(-50.2)), 6), round(math.cos(math.radians(-50.2)), 6)]
    doc.json["nodes"] = [
        {"name": "table", "rotation": turn30, "children": [1, 2, 3, 8]},
        {"name": "board", "mesh": board},
        {"name": "frame", "mesh": frame},
        {"name": "white", "children": [4, 5, 6, 7]},
        {"name": "pawn", "mesh": pawn, "translation": [-1, 0, 2]},
        {"name": "pawn", "mesh": pawn, "translation": [0, 0, 1]},
        {"name": "bishop", "mesh": bishop, "translation": [-2, 0, 0]},
        {"name": "tall bishop, mirrored", "mesh": bishop,
         "matrix": [-1, 0, 0, 0, 0, 1.1, 0, 0, 0, 0, 1, 0, -1, 0, -1, 1]},
        {"name": "black", "translation": [1, 0, -1], "children": [9, 10]},
        {"name": "queen", "mesh": queen, "scale": [1.05, 1.05, 1.05]},
        {"name": "fallen pawn", "mesh": dark_pawn, "translation": [0.75, 0.33, 2.2], "rotation": fallen},
    ]
    doc.json["scenes"] = [{"nodes": [0]}]
    doc.json["scene"] = 0
    return doc.glb()


def pawn_gltf():
    doc = Document()
    pawn = doc.mesh("pawn", *turned(PAWN))
    uri = "data:application/octet-stream;base64," + base64.b64encode(bytes(doc.binary)).decode()
    doc.json["buffers"] = [{"byteLength": len(doc.binary), "uri": uri}]
    doc.json["nodes"] = [{"name": "pawn", "mesh": pawn}]
    doc.json["scenes"] = [{"nodes": [0]}]
    doc.json["scene"] = 0
    return doc.text() + b"\n"
