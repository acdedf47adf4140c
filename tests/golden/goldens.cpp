#include "tests/golden/goldens.h"

#include <vector>

namespace rushlight {
namespace {

constexpr const char* kContent = RUSHLIGHT_SOURCE "/content/";

Golden passOfTestCard(const char* name, DebugView show) {
    Golden golden{name, "testcard/testcard.gltf", "", {}};
    golden.view.settings.debugView = show;
    return golden;
}

Golden frame(const char* name, const char* scene, const char* environment, const char* camera) {
    Golden golden{name, scene, environment, {}};
    golden.view.camera = camera;
    golden.view.width = 640;
    golden.view.height = 360;
    // The noise of dithering would be most of the file; it has a test of its own.
    golden.view.settings.dither = false;
    return golden;
}

std::vector<Golden> makeGoldens() {
    const char* dusk = "square/dusk.hdr";
    return {frame("testcard", "testcard/testcard.gltf", "", "card"),
            frame("testcard_dusk", "testcard/testcard.gltf", dusk, "card"),
            frame("square", "square/square.gltf", dusk, "square"),
            passOfTestCard("testcard_basecolor", DebugView::baseColor),
            passOfTestCard("testcard_normal", DebugView::normal),
            passOfTestCard("testcard_depth", DebugView::depth),
            passOfTestCard("testcard_shadow", DebugView::shadow)};
}

}  // namespace

std::span<const Golden> goldens() {
    static const std::vector<Golden> all = makeGoldens();
    return all;
}

Result<golden::Frame> renderGolden(const Golden& golden, golden::Offscreen& offscreen) {
    const std::string environment = *golden.environment ? kContent + std::string(golden.environment)
                                                        : std::string();
    return offscreen.renderScene(kContent + std::string(golden.scene), golden.view, environment);
}

golden::Near nearGolden(const Golden& golden) {
    return golden::near(std::string(golden.name) + ".png", golden::flip(0.004), golden::psnr(47));
}

}  // namespace rushlight
