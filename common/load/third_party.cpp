// The single-header libraries that read meshes, compiled once.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#define TINYGLTF_IMPLEMENTATION
#include "common/load/tinygltf.h"
