"""A shelf of samples in one GLB: what glTF's materials become, and the ways of a file to place things.

Vertex colours, a metal, a plastic, glass, a lamp with a strength, a fence that alpha cuts out, a poster whose texture
is moved and mirrored, instances, a skin, a morph target and a point light.
"""
import math
import struct

from chess import Document, box, floats, turned
from png import png_bytes

BALL = [(math.sin(math.pi * i / 12) / 2 if 0 < i < 12 else 0, 0.5 - math.cos(math.pi * i / 12) / 2) for i in range(13)]
BALL = [(round(r, 6), round(y, 6)) for r, y in BALL]


def pbr(colour, metallic, roughness, **more):
    return {"pbrMetallicRoughness": {"baseColorFactor": [*colour, 1], "metallicFactor": metallic,
                                     "roughnessFactor": roughness}, **more}


def fence_png():
    """Slats with round tops, the rest without alpha."""
    def there(x, y):
        x = x % 16 - 7.5
        return abs(x) < 5 and (y > 10 or x * x + (y - 10) ** 2 < 25) or 24 <= y < 29
    rows = [[0 if there(x, y) else 1 for x in range(64)] for y in range(48)]
    return png_bytes([(150, 96, 52), (150, 96, 52)], rows, 1, [255, 0])


def poster_png():
    """An arrow that shows each turn and mirror image."""
    def colour(x, y):
        if 6 <= x < 26 and abs(y - 16) < 3 or x >= 18 and abs(y - 16) < 28 - x:
            return 0
        return 1 if y < 16 else 2
    return png_bytes([(235, 60, 40), (240, 225, 180), (120, 160, 190)],
                     [[colour(x, y) for x in range(32)] for y in range(32)], 2)


def panel(width, height, uv):
    """An upright panel facing +z, its foot at y = 0."""
    corners = ((-0.5, 0), (0.5, 0), (0.5, 1), (-0.5, 1))
    return [(x * width, y * height, 0.0, 0, 0, 1, (x + 0.5) * uv, 1.0 - y) for x, y in corners], [0, 1, 2, 0, 2, 3]


def skinned_flag(doc, material):
    """Four bands of cloth; each row of vertices hangs on the pole, the end of the flag on the second joint."""
    rows = 5
    vertices = [(i / (rows - 1), y, 0.0, 0, 0, 1) for i in range(rows) for y in (0.0, 0.6)]
    index = []
    for i in range(rows - 1):
        a = 2 * i
        index += [a, a + 2, a + 1, a + 1, a + 2, a + 3]
    mesh = doc.mesh("flag", vertices, index, material)
    weights = [(1 - i / (rows - 1), i / (rows - 1), 0, 0) for i in range(rows) for _ in range(2)]
    attributes = doc.json["meshes"][mesh]["primitives"][0]["attributes"]
    attributes["JOINTS_0"] = doc.accessor(bufferView=doc.view(struct.pack("<4B", 0, 1, 0, 0) * (2 * rows)),
                                          componentType=5121, count=2 * rows, type="VEC4")
    attributes["WEIGHTS_0"] = doc.accessor(bufferView=doc.view(floats(weights)), componentType=5126, count=2 * rows,
                                           type="VEC4")
    return mesh


def morphed_block(doc, material):
    """A block whose top its target pulls to a roof."""
    vertices, index = box((-0.4, 0, -0.4), (0.4, 0.5, 0.4))
    mesh = doc.mesh("roof", vertices, index, material)
    pull = [(-v[0] if v[1] > 0 else 0.0, 0.5 if v[1] > 0 else 0.0, 0.0) for v in vertices]
    target = doc.accessor(bufferView=doc.view(floats(pull)), componentType=5126, count=len(pull), type="VEC3")
    doc.json["meshes"][mesh]["primitives"][0]["targets"] = [{"POSITION": target}]
    doc.json["meshes"][mesh]["weights"] = [0.75]
    return mesh


def shelf_glb():
    doc = Document()
    images = [doc.view(fence_png()), doc.view(poster_png())]
    doc.json["images"] = [{"bufferView": view, "mimeType": "image/png"} for view in images]
    doc.json["samplers"] = [{"wrapS": 10497, "wrapT": 33071}, {"wrapS": 33648, "wrapT": 33648}]
    doc.json["textures"] = [{"source": 0, "sampler": 0}, {"source": 1, "sampler": 1}]
    doc.json["extensionsUsed"] = ["KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_emissive_strength",
                                  "KHR_texture_transform", "EXT_mesh_gpu_instancing", "KHR_lights_punctual"]
    poster = {"index": 1, "extensions": {"KHR_texture_transform": {
        "offset": [0.25, 0.125], "rotation": 0.5, "scale": [3, 2]}}}
    doc.json["materials"] = [
        {"name": "painted", **pbr((1, 1, 1), 0, 1)},
        {"name": "copper", **pbr((0.955, 0.638, 0.538), 1, 0.35)},
        {"name": "plastic", **pbr((0.05, 0.25, 0.6), 0, 0.3)},
        {"name": "glass", **pbr((1, 1, 1), 0, 0, extensions={
            "KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.45}})},
        {"name": "lamp", **pbr((0, 0, 0), 0, 1, emissiveFactor=[1, 0.8, 0.5], extensions={
            "KHR_materials_emissive_strength": {"emissiveStrength": 6}})},
        {"name": "fence", "alphaMode": "MASK", "doubleSided": True, "pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0}, "metallicFactor": 0}},
        {"name": "poster", "pbrMetallicRoughness": {"baseColorTexture": poster, "metallicFactor": 0}},
        {"name": "cloth", "doubleSided": True, **pbr((0.7, 0.08, 0.1), 0, 1)},
    ]
    painted, copper, plastic, glass, lamp, fence, poster, cloth = range(8)
    ball, triangles = turned(BALL)
    coloured = [v + (round(0.5 + v[3] / 2, 6), round(0.5 + v[4] / 2, 6), round(0.5 + v[5] / 2, 6)) for v in ball]
    meshes = [doc.mesh("coloured ball", coloured, triangles, painted, colours=True)]
    meshes += [doc.mesh(name, ball, triangles, m) for name, m in
               (("copper ball", copper), ("plastic ball", plastic), ("glass ball", glass))]
    cube = doc.mesh("lamps", *box((-0.1, -0.1, -0.1), (0.1, 0.1, 0.1)), lamp)
    slats = doc.mesh("fence", *panel(4, 0.75, 2), fence, uv=True)
    wall = doc.mesh("poster", *panel(1.6, 1.2, 1), poster, uv=True)
    flag, roof = skinned_flag(doc, cloth), morphed_block(doc, painted)
    places = doc.accessor(bufferView=doc.view(floats([(-1.6, 0, 0), (0, 0, 0), (1.6, 0, 0)])), componentType=5126,
                          count=3, type="VEC3")
    half = round(math.sin(math.radians(35)), 6), round(math.cos(math.radians(35)), 6)
    doc.json["nodes"] = [
        *({"name": doc.json["meshes"][m]["name"], "mesh": m, "translation": [1.2 * i - 1.8, 0, 0.4]}
          for i, m in enumerate(meshes)),
        {"name": "lamps", "mesh": cube, "translation": [0, 2.4, 0.3],
         "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}}},
        {"name": "fence", "mesh": slats, "translation": [0, 0, 1.5]},
        {"name": "poster", "mesh": wall, "translation": [-0.9, 0.2, -1]},
        {"name": "flag", "mesh": flag, "skin": 0},
        {"name": "pole", "translation": [0.6, 1, -0.9], "children": [9]},
        {"name": "tip", "rotation": [0, half[0], 0, half[1]]},
        {"name": "roof", "mesh": roof, "translation": [1.5, 0, -0.7]},
        {"name": "bulb", "translation": [-2.5, 2, 2.5], "extensions": {"KHR_lights_punctual": {"light": 0}}},
    ]
    doc.json["skins"] = [{"joints": [8, 9]}]
    doc.json["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "point", "color": [0.6, 0.75, 1], "intensity": 8}]}}
    doc.json["scenes"] = [{"nodes": [0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 11]}]
    doc.json["scene"] = 0
    return doc.glb()
