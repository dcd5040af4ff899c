"""Which scenes are compared, how large, and what is changed in them for both renderers alike."""
import json
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


# Changes to a scene file, each for something Mitsuba 3 does not have.
def phong_as_diffuse(scene):
    for material in scene["materials"].values():
        if material["kind"] == "phong":
            material["kind"] = "diffuse"
            material.pop("specular", None)
            material.pop("exponent", None)


def exact_fresnel(scene):
    for material in scene["materials"].values():
        material.pop("fresnel", None)


def flat_normals(scene):
    for shape in scene["shapes"]:
        if shape["kind"] == "mesh":
            shape["smooth"] = False


def look_down(scene):
    """No sky in view: a sky's edges are steps here and ramps in Mitsuba, and no noise hides it."""
    scene["camera"] |= {"position": [0.4, 3.5, 6], "look_at": [0, 0.6, 0]}


def thick_panes(scene):
    """100 times as thick and all 1024 times as large: the scene's own panes are no thicker than the
    step that Mitsuba takes off a surface, 9e-5 (1 + the largest coordinate)."""
    scene["camera"]["position"] = [1024 * x for x in scene["camera"]["position"]]
    for shape in scene["shapes"]:
        if shape["kind"] == "box":
            shape["low"][2], shape["high"][2] = -0.005, 0.005
        for key in ("low", "high"):
            if key in shape:
                shape[key] = [1024 * x for x in shape[key]]
        if "vertices" in shape:
            shape["vertices"] = [[1024 * x for x in v] for v in shape["vertices"]]


def path_integrator(scene):
    scene["render"]["integrator"] = "path"


# name: scene file, changes, film width and height, samples a pixel of each of the replicates.
SCENES = {
    "cornell": ("scenes/cornell.json", [], 96, 96, 64),
    "cornell_peers": ("scenes/cornell_peers.json", [], 96, 96, 64),
    "cornell_spheres": ("scenes/cornell_spheres.json", [], 64, 64, 128),
    "hdr_environment": ("scenes/hdr_environment.json", [], 128, 80, 64),
    "hdr_environment_down": ("scenes/hdr_environment.json", [look_down], 128, 80, 64),
    "microfacets": ("scenes/microfacets.json", [phong_as_diffuse], 128, 96, 64),
    "glass_sky": ("tools/cross_check/scenes/glass_sky.json", [], 128, 80, 64),
    "glass_furnace": ("scenes/glass_furnace.json", [exact_fresnel], 64, 40, 16),
    "glass_pane": ("scenes/glass_pane.json", [], 64, 64, 64),
    "glass_pane_thick": ("scenes/glass_pane.json", [thick_panes], 64, 64, 64),
    "rough_glass": ("tools/cross_check/scenes/rough_glass.json", [], 128, 64, 64),
    "beckmann": ("tools/cross_check/scenes/beckmann.json", [], 128, 64, 64),
    "ggx": ("tools/cross_check/scenes/ggx.json", [], 128, 64, 64),
    "ggx_furnace": ("scenes/ggx_furnace.json", [], 16, 16, 256),
    "thin_lens": ("scenes/thin_lens.json", [], 64, 64, 64),
    "depth_of_field": ("scenes/depth_of_field.json", [phong_as_diffuse], 128, 80, 32),
    "textured_mesh": ("scenes/textured_mesh.json", [phong_as_diffuse], 96, 96, 16),
    "textured_mesh_flat": ("scenes/textured_mesh.json", [phong_as_diffuse, flat_normals], 96, 96, 16),
    "gltf_object": ("scenes/gltf_object.json", [], 112, 80, 16),
    "gltf_object_flat": ("scenes/gltf_object.json", [flat_normals], 112, 80, 16),
    "fractal": ("scenes/fractal.json", [], 96, 96, 16),
    "whitted_path": ("scenes/whitted.json", [phong_as_diffuse, path_integrator], 128, 96, 32),
    "soft_shadow": ("scenes/soft_shadow.json", [], 64, 64, 64),
    "polygon_light": ("scenes/polygon_light.json", [], 16, 16, 256),
    "sphere_light": ("scenes/sphere_light.json", [], 128, 96, 64),
    "form_factor": ("scenes/form_factor.json", [], 64, 64, 64),
    "point_in_sphere": ("scenes/point_in_sphere.json", [], 16, 16, 16),
    "white_furnace": ("scenes/white_furnace.json", [], 16, 16, 64),
}


def scene_file(name, folder, scale_albedo=None):
    """Writes the scene, changed, into `folder`. scale_albedo: (material, factor), a planted error."""
    path, changes, *_ = SCENES[name]
    scene = json.loads((ROOT / path).read_text())
    for change in changes:
        change(scene)
    scene.pop("expect", None)
    if scale_albedo:
        material, factor = scale_albedo
        scene["materials"][material]["reflectance"] = [
            factor * c for c in scene["materials"][material]["reflectance"]]
    base = (ROOT / path).parent

    def absolute(node):
        for key, value in (node.items() if isinstance(node, dict) else enumerate(node)):
            if key in ("file", "reflectance_texture"):
                node[key] = str((base / value).resolve())
            elif isinstance(value, (dict, list)):
                absolute(value)

    absolute(scene)
    file = folder / f"{name}.json"
    file.write_text(json.dumps(scene, indent=1))
    return file
