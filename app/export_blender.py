import sys

import bpy
from mathutils import Matrix


def shader(name, material):
    """Cycles' nodes of one of raylab's materials."""
    result = bpy.data.materials.new(name)
    result.use_nodes = True
    nodes, links = result.node_tree.nodes, result.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    if material["kind"] == "diffuse":
        surface = nodes.new("ShaderNodeBsdfDiffuse")
    elif material["kind"] == "mirror":
        surface = nodes.new("ShaderNodeBsdfGlossy")
    elif material["kind"] == "glass":
        surface = nodes.new("ShaderNodeBsdfGlass")
        surface.inputs["IOR"].default_value = material["ior"]
    surface.inputs["Color"].default_value = (*material["reflectance"], 1)
    surface.inputs["Roughness"].default_value = 0
    if material["kind"] != "diffuse" and bpy.app.version < (4, 0, 0):
        surface.distribution = "SHARP"  # later versions: roughness 0 means it
    light = surface.outputs[0]
    if any(material["emission"]):
        emission = nodes.new("ShaderNodeEmission")
        emission.inputs["Color"].default_value = (*material["emission"], 1)
        emission.inputs["Strength"].default_value = 1
        light = emission.outputs[0]
        if any(material["reflectance"]):
            both = nodes.new("ShaderNodeAddShader")
            links.new(surface.outputs[0], both.inputs[0])
            links.new(emission.outputs[0], both.inputs[1])
            light = both.outputs[0]
    links.new(light, output.inputs["Surface"])
    return result


def add_shapes(scene):
    shaders = {name: shader(name, material) for name, material in SCENE["materials"].items()}
    for i, mesh in enumerate(SCENE["meshes"]):
        data = bpy.data.meshes.new(f"mesh {i}")
        data.from_pydata(mesh["positions"], [], mesh["faces"])
        data.materials.append(shaders[mesh["material"]])
        scene.collection.objects.link(bpy.data.objects.new(f"mesh {i}", data))
    for sphere in SCENE["spheres"]:
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=7, radius=sphere["radius"],
                                              location=sphere["center"])
        data = bpy.context.object.data
        data.polygons.foreach_set("use_smooth", [True] * len(data.polygons))
        data.materials.append(shaders[sphere["material"]])


def add_camera(scene):
    camera = SCENE["camera"]
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.lens_unit = "FOV"
    data.angle = camera["vfov"]
    data.clip_start, data.clip_end = camera["clip"]
    pose = bpy.data.objects.new("camera", data)  # looks along -z, y up
    columns = [camera["right"], camera["up"], [-x for x in camera["forward"]], camera["position"]]
    pose.matrix_world = Matrix([[column[row] for column in columns] for row in range(3)] + [[0, 0, 0, 1]])
    scene.collection.objects.link(pose)
    scene.camera = pose


def settings(scene, spp, seed, threads):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = SCENE["film"]
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = ("FIXED", threads) if threads else ("AUTO", 1)
    scene.render.use_compositing = scene.render.use_sequencer = False
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples, cycles.seed = spp, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.light_sampling_threshold = 0
    cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.film_exposure = 1
    for kind in ("max", "diffuse", "glossy", "transmission", "transparent_max"):
        setattr(cycles, f"{kind}_bounces", SCENE["bounces"])
    scene.world = bpy.data.worlds.new("black")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)


def render(scene, path):
    image = scene.render.image_settings
    image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGB", "32"
    image.exr_codec = "ZIP"
    scene.render.filepath = path
    scene.render.use_file_extension = False
    bpy.ops.render.render(write_still=True)


def main(arguments):
    import argparse
    parser = argparse.ArgumentParser(prog="blender -b --python scene.py --")
    parser.add_argument("--spp", type=int, default=SCENE["spp"], help="samples a pixel")
    parser.add_argument("--seed", type=int, default=SCENE["seed"])
    parser.add_argument("--threads", type=int, default=0, help="0: one a core")
    parser.add_argument("-o", "--output", required=True, help="image.exr, linear radiance")
    options = parser.parse_args(arguments)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    add_shapes(scene)
    add_camera(scene)
    settings(scene, options.spp, options.seed, options.threads)
    render(scene, options.output)


main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
