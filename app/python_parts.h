// The Python that other renderers run, put into the program by the build (python_parts.cpp.in).
#pragma once

namespace raylab::app {

extern const char* const export_blender_py; // what follows the scene's data in scene.py
extern const char* const run_mitsuba_py;    // renders one image of a scene.xml

} // namespace raylab::app
