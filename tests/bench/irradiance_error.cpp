// How far irradiance probes are off the path-traced truth on the surfaces that a camera sees:
//     irradiance_error SCENE PROBES ENVIRONMENT EYE_X EYE_Y EYE_Z
#include "engine/assets/gltf.h"
#include "engine/jobs/tbb_jobs.h"
#include "renderer/capture/image_files.h"
#include "renderer/raytrace/path_tracer.h"
#include "renderer/scene_bridge/ray_bridge.h"
#include "sandbox/tool/probes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace rushlight {
namespace {

constexpr uint32_t kPoints = 500, kPaths = 512;

struct Point {
    RayHit hit;
    float truth = 0, probes = 0;
};

float luminance(const vec3& c) { return glm::dot(c, vec3(0.2126f, 0.7152f, 0.0722f)); }

/// Irradiance over pi, without suns and punctual lights as the probes have it.
float gather(const PathTracer& tracer, const RayHit& hit, const vec3& normal, uint32_t seed) {
    vec3 sum(0);
    const vec3 origin = offsetOrigin(hit.position, normal);
    for (uint32_t i = 0; i < kPaths; ++i) {
        RayRandom random(uint64_t(seed) << 32 | i);
        const vec3 d = fibonacciDirection(i, 2 * kPaths, 0);
        const vec3 up = glm::dot(d, normal) < 0 ? -d : d;
        sum += tracer.radiance(origin, up, INFINITY, 0, random) * (2 * glm::dot(up, normal));
    }
    return luminance(sum) / float(kPaths);
}

int run(char** arguments) {
    const auto jobs = createTbbJobs(0);
    assets::LoadOptions load;
    load.jobs = jobs.get();
    const auto model = assets::loadModel(arguments[1], load);
    const auto volume = tool::readProbes(arguments[2]);
    const auto picture = loadPicture(arguments[3]);
    if (!model || !volume || !picture) return std::fprintf(stderr, "a file cannot be read\n"), 3;
    const auto renderer = *Renderer::create({});
    const auto bridge = *SceneBridge::create(*renderer, *model);
    const auto scene = *makeRayScene(*bridge, *jobs);
    std::vector<vec3> pixels;
    for (size_t i = 0; i < picture->pixelCount(); ++i)
        pixels.push_back(
            {picture->rgba[i * 4], picture->rgba[i * 4 + 1], picture->rgba[i * 4 + 2]});
    BakeLighting lighting;
    lighting.environment = {"environment", picture->width, picture->height, pixels};
    const BakeLight light = *BakeLight::create(lighting, *jobs);
    const BrdfTable table = makeBrdfTable(*jobs);
    const PathTracer tracer(*scene, light, table, 32);
    const vec3 eye(std::atof(arguments[4]), std::atof(arguments[5]), std::atof(arguments[6]));
    std::vector<Point> points(kPoints);
    std::erase_if(points, [&, i = 0u](Point& p) mutable {
        return !scene->intersect({eye, fibonacciDirection(i++, kPoints, 0.3f)}, p.hit);
    });
    jobs->forRanges(uint32_t(points.size()), 1, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            Point& p = points[i];
            const vec3 n = p.hit.front ? p.hit.geometricNormal : -p.hit.geometricNormal;
            p.truth = gather(tracer, p.hit, n, i);
            p.probes = luminance(vec3(sampleIrradiance(*volume, p.hit.position, n)));
        }
    });
    double truth = 0, probes = 0, apart = 0;
    std::vector<float> errors;
    for (const Point& p : points) {
        errors.push_back(std::abs(p.probes / std::max(p.truth, 1e-6f) - 1));
        truth += double(p.truth);
        probes += double(p.probes);
        apart += double(std::abs(p.probes - p.truth));
    }
    uint32_t filled = 0;
    for (uint32_t i = 0; i < volume->grid.count(); ++i) filled += volume->probe(i).weight < 0.5f;
    std::printf("%u of %u probes are within something\n", filled, volume->grid.count());
    std::printf("%zu points: mean %.5f by paths, %.5f by probes; mean error %.1f %% of the mean\n",
                points.size(), truth / double(points.size()), probes / double(points.size()),
                100 * apart / truth);
    std::ranges::sort(errors);
    std::printf("relative error of a point: median %.0f %%, 3 of 4 under %.0f %%\n",
                double(100 * errors[errors.size() / 2]),
                double(100 * errors[errors.size() * 3 / 4]));
    return 0;
}

}  // namespace
}  // namespace rushlight

int main(int count, char** arguments) {
    if (count == 7) return rushlight::run(arguments);
    std::fprintf(stderr, "irradiance_error SCENE PROBES ENVIRONMENT EYE_X EYE_Y EYE_Z\n");
    return 2;
}
