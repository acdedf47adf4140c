// The null backend runs a whole frame: everything that the renderer is linked with is there.
#include "renderer/renderer.h"

int main() {
    const auto renderer = rushlight::Renderer::create({});
    if (!renderer) return 1;
    const auto ticket = (*renderer)->renderOffscreen({}, 16, 16, rushlight::CaptureKind::display);
    return ticket ? 0 : 1;
}
