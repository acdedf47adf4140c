#pragma once

#include "engine/core/log.h"
#include "renderer/rhi/device.h"

namespace rushlight {

struct GlDeviceDesc {
    void* (*load)(const char* name) = nullptr;  ///< address of a GL function of the current context
    LogSink log = {};
    std::string cacheDirectory = {};   ///< program binaries; empty: none are kept
    std::string shaderDirectory = {};  ///< empty: the shaders compiled in
    uint32_t framesInFlight = 2;       ///< 1 to 3
    bool debugOutput = false;          ///< collect GL debug messages
};

/// A device in the context that is current, which must be current at every later call.
/// ErrorKind::noContext when it is not OpenGL 4.5 or lacks a function that is needed (named).
Result<std::unique_ptr<Device>> createGlDevice(const GlDeviceDesc& desc);

}  // namespace rushlight
