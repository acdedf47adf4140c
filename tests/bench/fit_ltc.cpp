// Writes renderer/lighting/ltc_table.cpp to standard output: `build/release/bin/fit_ltc >
// renderer/lighting/ltc_table.cpp`.
#include "engine/jobs/tbb_jobs.h"
#include "interop/ltc.h"
#include "renderer/lighting/ltc_fit.h"

#include <cstdio>

int main() {
    constexpr uint32_t kSize = RL_LTC_TABLE_SIZE;
    const auto jobs = rushlight::createTbbJobs(2);
    const std::vector<rushlight::vec4> table = rushlight::fitLtcTable(*jobs, kSize);
    std::puts(
        "// Written by fit_ltc (tests/bench/fit_ltc.cpp): inverse matrices of linearly transformed "
        "cosines\n"
        "// that were fitted to the specular lobe of shaders/interop/brdf.h. Rows of roughness, "
        "columns of\n"
        "// sqrt(1 - n.v), both from 0 to 1; an element is what interop::applyLtc takes.\n"
        "#include \"renderer/lighting/ltc_table.h\"\n\n"
        "namespace rushlight {\n\n"
        "// clang-format off\n"
        "const std::array<vec4, RL_LTC_TABLE_SIZE * RL_LTC_TABLE_SIZE> kLtcTable = {{");
    for (size_t i = 0; i < table.size(); ++i) {
        const rushlight::vec4& m = table[i];
        std::printf("%s{%.6ef, %.6ef, %.6ef, %.6ef},%s", i % 2 ? " " : "    ", double(m.x),
                    double(m.y), double(m.z), double(m.w), i % 2 ? "\n" : "");
    }
    std::puts("}};\n// clang-format on\n\n}  // namespace rushlight");
}
