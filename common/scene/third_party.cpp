// The single-header libraries that read meshes, compiled once.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include "common/scene/tinygltf.h"
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
