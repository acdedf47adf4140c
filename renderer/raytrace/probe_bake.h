#pragma once
// Fills irradiance probes by tracing paths. What a probe holds is all light but that of the suns
// and of point, spot and area lights on the surface that is looked at: light of the sky, of glowing
// surfaces but those that stand for an area light, and of every light after its first bounce. The
// frame adds the rest, with its own shadows. All lights cast shadows here, whatever their
// castsShadow says: it saves a frame shadow maps, and rays none.

#include "engine/core/jobs.h"
#include "engine/core/result.h"
#include "renderer/lighting/irradiance_volume.h"
#include "renderer/raytrace/bake_lighting.h"
#include "renderer/raytrace/ray_scene.h"

#include <memory>

namespace rushlight {

struct BrdfTable;

struct ProbeBakeDesc {
    float spacing = 0;       ///< metres between probes; 0: as fine as kAutoProbes of them are
    uint32_t samples = 256;  ///< rays a probe and pass, 16 to 65,536
    uint32_t bounces = 32;   ///< at most so many; dim paths end earlier, without bias
    Aabb bounds;             ///< to be filled with probes; empty: those of the scene
    /// Told how many probes of how many are done, over all passes, from the thread that bakes.
    void (*progress)(void* user, uint32_t done, uint32_t count) = nullptr;
    void* user = nullptr;
};

inline constexpr uint32_t kAutoProbes = 4096;

/// Probes in the middle of equal cells that fill `bounds`. An Error when that takes more than
/// kMaxProbes.
Result<ProbeGrid> placeProbes(const Aabb& bounds, float spacing);

/// Traces paths first, then twice gathers anew what the probes themselves know of the surfaces
/// around: that keeps the light of all bounces and spreads the noise of each probe's paths over
/// all. The same bytes for any number of threads. An Error when the scene is empty or a value is
/// out of range.
Result<IrradianceVolume> bakeIrradiance(const RayScene& scene, const BakeLighting& lighting,
                                        const ProbeBakeDesc& desc, JobSystem& jobs);

/// Keeps a volume up to date where lights move: a few probes a frame, round and round. Its probes
/// stay where they were put, as the scene's shape is taken to stand still.
class ProbeUpdater {
public:
    /// `scene` and `jobs` must outlive it.
    ProbeUpdater(const RayScene& scene, IrradianceVolume volume, JobSystem& jobs);
    ~ProbeUpdater();

    /// Bakes the next `count` probes under `lighting`; `share` of the new light is taken, the rest
    /// is what was, which evens out the noise of few samples.
    Result<void> update(const BakeLighting& lighting, uint32_t count, uint32_t samples,
                        float share = 1);
    const IrradianceVolume& volume() const { return volume_; }

private:
    const RayScene& scene_;
    JobSystem& jobs_;
    std::unique_ptr<const BrdfTable> table_;
    IrradianceVolume volume_;
    uint32_t next_ = 0;
    uint64_t lightHash_ = 0;     ///< of the last update
    uint64_t updatedSince_ = 0;  ///< probes, under that light
    uint64_t rounds_ = 0;
};

}  // namespace rushlight
