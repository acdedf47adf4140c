#pragma once
// OpenGL with one fault: what a renderer's loader gives it in place of the driver's functions. One
// at a time.

#include <cstdint>

namespace rushlight {

enum class GlFault {
    none,
    storage,      ///< of a buffer or texture: out of memory
    mapping,      ///< of a buffer: no address
    compilation,  ///< of a shader
    linking,      ///< of a program
    framebuffer,  ///< the driver supports no such combination of targets
    reset,        ///< the context is lost, from then on
};

struct FaultyGl {
    static inline GlFault fault = GlFault::none;
    static inline uint32_t call = 0;   ///< which call of that kind fails, from 1
    static inline uint32_t calls = 0;  ///< of that kind, so far
    static inline bool draws = true;   ///< no: nothing is rasterised, for speed

    /// Which call is to fail; counts anew.
    static void set(GlFault kind, uint32_t number);
    static void* load(const char* name);
};

}  // namespace rushlight
