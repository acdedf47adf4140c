#pragma once
// OpenGL that plays what drivers may do and the one below does not show: its clock says what it is
// told, and names of buffers are given again as soon as they are free. The rest is the driver's.
// One context at a time.

#include <cstdint>

namespace rushlight {

struct PlayedGl {
    /// What the clock says, in nanoseconds, to the query of this number since reset(), from 0.
    static inline uint64_t (*clock)(uint32_t number) = nullptr;
    static inline int64_t now = 0;            ///< what it says where it is asked at once
    static inline uint32_t askedNow = 0;      ///< how often it was
    static inline bool timesAreThere = true;  ///< no: the GPU is not done yet
    static inline uint32_t namesGivenAgain = 0;

    static void reset();
    static void* load(const char* name);
};

}  // namespace rushlight
