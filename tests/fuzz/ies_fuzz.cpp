// Any bytes as an IES file: parsing must end in a profile that can be drawn or an Error, never in a
// crash.
//     cmake --preset fuzz && cmake --build build/fuzz --target ies_fuzz
//     build/fuzz/bin/ies_fuzz -max_total_time=60 CORPUS_FOLDER
#include "engine/assets/ies.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const auto profile = rushlight::assets::parseIes("fuzz.ies",
                                                     {reinterpret_cast<const char*>(data), size});
    if (!profile) return profile.error().message.empty() ? -1 : 0;
    if (profile->candela.size() !=
            profile->verticalAngles.size() * profile->horizontalAngles.size() ||
        !std::isfinite(rushlight::assets::luminousFlux(*profile)))
        __builtin_trap();
    return 0;
}
