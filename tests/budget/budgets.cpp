#include "tests/budget/budgets.h"

#include "renderer/testing/scene_frames.h"
#include "tests/bench/bench_world.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/scenes/random_scene.h"

namespace rushlight {
namespace {

using Change = void (*)(FrameInput&);
constexpr uint32_t kFrames = 12;  // the last ones are warm
constexpr uint32_t kWidth = 320, kHeight = 180;

uint64_t allocationsOfLastFrame = 0;

Result<void> renderInto(Renderer& renderer, const FrameInput& input, CapturedImage& image) {
    const auto ticket = renderer.renderOffscreen(input, kWidth, kHeight, CaptureKind::display);
    if (!ticket) return tl::unexpected(ticket.error());
    renderer.takeCapture(*ticket, true, image);
    return {};
}

/// Calls `frame(i)` for each of the frames and counts the last one's allocations.
template <class Frame>
Result<FrameReport> countLast(Renderer& renderer, Frame&& frame) {
    for (uint32_t i = 0; i < kFrames; ++i) {
        const uint64_t before = allocationsOnThisThread();
        if (auto rendered = frame(i); !rendered) return tl::unexpected(rendered.error());
        allocationsOfLastFrame = allocationsOnThisThread() - before;
    }
    return renderer.report();
}

Result<std::unique_ptr<Renderer>> makeRenderer(GlLoadFunction load) {
    RendererDesc desc;
    desc.loadGl = load;
    desc.validateCommands = true;
    return Renderer::create(desc);
}

Result<FrameReport> contentScene(GlLoadFunction load, Change change, const char* scene,
                                 const char* camera) {
    auto renderer = makeRenderer(load);
    if (!renderer) return tl::unexpected(renderer.error());
    const std::string content = RUSHLIGHT_SOURCE "/content/";
    auto frames = SceneFrames::open(**renderer, content + scene, "");
    if (!frames) return tl::unexpected(frames.error());
    CapturedImage image;
    return countLast(**renderer, [&](uint32_t) -> Result<void> {
        FrameInput input;
        if (auto filled = (*frames)->fill({camera, kWidth, kHeight, {}}, input); !filled)
            return filled;
        if (change) change(input);
        return renderInto(**renderer, input, image);
    });
}

Result<FrameReport> randomScene(GlLoadFunction load, Change change, uint64_t seed) {
    auto renderer = makeRenderer(load);
    if (!renderer) return tl::unexpected(renderer.error());
    RandomScene scene(**renderer, seed);
    CapturedImage image;
    return countLast(**renderer, [&](uint32_t i) {
        FrameInput input = scene.frame(i % 3);
        if (change) change(input);
        return renderInto(**renderer, input, image);
    });
}

Result<FrameReport> plain(GlLoadFunction load, Change change, uint32_t movingPercent) {
    BenchWorld::Desc desc;
    desc.loadGl = load;
    desc.movingPercent = movingPercent;
    desc.change = change;
    BenchWorld world(desc);
    return countLast(world.renderer(), [&](uint32_t) -> Result<void> {
        world.frame();
        return {};
    });
}

}  // namespace

const std::vector<BudgetScene>& budgetScenes() {
    static const std::vector<BudgetScene> scenes = {
        {"testcard",
         [](auto load, auto change) {
             return contentScene(load, change, "testcard/testcard.gltf", "card");
         }},
        {"square",
         [](auto load, auto change) {
             return contentScene(load, change, "square/square.gltf", "square");
         }},
        {"random", [](auto load, auto change) { return randomScene(load, change, 5); }},
        {"3000 unique", [](auto load, auto change) { return plain(load, change, 0); }},
        {"3000 unique, 300 moving", [](auto load, auto change) { return plain(load, change, 10); }},
    };
    return scenes;
}

nlohmann::ordered_json countersOf(const FrameReport& r, uint64_t allocations) {
    nlohmann::ordered_json json = {{"visible", r.visible},
                                   {"draws", r.draws},
                                   {"triangles", r.triangles},
                                   {"gl_calls", r.glCalls},
                                   {"state_changes", r.stateChanges},
                                   {"uploaded_bytes", r.uploadedBytes},
                                   {"allocations", allocations}};
    for (const PassReport& pass : r.passes)
        json["passes"][pass.name] = {{"draws", pass.draws}, {"triangles", pass.triangles}};
    return json;
}

Result<nlohmann::ordered_json> measureBudget(const BudgetScene& scene, GlLoadFunction load,
                                             Change change) {
    const auto report = scene.render(load, change);
    if (!report) return tl::unexpected(report.error());
    return countersOf(*report, allocationsOfLastFrame);
}

std::vector<std::string> differences(const nlohmann::ordered_json& budget,
                                     const nlohmann::ordered_json& measured) {
    std::vector<std::string> lines;
    const auto was = budget.flatten(), is = measured.flatten();
    for (const auto& [key, value] : was.items())
        if (!is.contains(key))
            lines.push_back(key + ": " + value.dump() + ", now missing");
        else if (is[key] != value)
            lines.push_back(key + ": " + value.dump() + ", now " + is[key].dump());
    for (const auto& [key, value] : is.items())
        if (!was.contains(key)) lines.push_back(key + ": new, " + value.dump());
    return lines;
}

std::string budgetPath() { return RUSHLIGHT_SOURCE "/tests/budget/budgets.json"; }

}  // namespace rushlight
