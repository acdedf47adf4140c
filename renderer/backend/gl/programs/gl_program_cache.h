#pragma once
// Linked programs on disk. A file that is corrupt, or that the driver refuses, is as good as none.

#include "renderer/backend/gl/gl_functions.h"

#include <string>

namespace rushlight {

class GlProgramCache {
public:
    /// An empty directory turns the cache off; so does a driver without program binaries.
    GlProgramCache(const GlFunctions& gl, std::string directory);

    /// Fills `program` from the cache; false when it has to be compiled. `sources` hashes all
    /// sources and defines.
    bool load(GLuint program, uint64_t sources) const;
    void store(GLuint program, uint64_t sources) const;
    bool enabled() const { return !directory_.empty(); }

private:
    std::string path(uint64_t sources) const;

    const GlFunctions& gl_;
    std::string directory_;
    uint64_t driver_ = 0;  ///< hash of vendor, renderer and version
};

}  // namespace rushlight
