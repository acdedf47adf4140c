// The implementation of the header-only tinygltf, compiled here and nowhere else.
#include <fstream>
#define TINYGLTF_IMPLEMENTATION
#include "engine/assets/gltf/tinygltf_config.h"
