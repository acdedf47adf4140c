#include "sandbox/viewer/viewer.h"

#include "sandbox/viewer/viewer_app.h"

#include <cstdio>

namespace rushlight {
namespace {

int report(const std::string& program, const Error& error) {
    const char* hint = error.kind == ErrorKind::noContext
                           ? " Without a display use 'rushlight capture', which needs none."
                           : "";
    std::fprintf(stderr, "%s: error: %s%s\n", program.c_str(), error.text().c_str(), hint);
    switch (error.kind) {
        case ErrorKind::wrongUse: return 2;
        case ErrorKind::badInput: return 3;
        case ErrorKind::noContext: return 4;
    }
    return 3;
}

}  // namespace

int runViewer(const ViewerOptions& options, ViewerGame* game) {
    ViewerApp app(options, game);
    if (auto opened = app.open(); !opened) return report(options.program, opened.error());
    if (auto ran = app.run(); !ran) return report(options.program, ran.error());
    return 0;
}

}  // namespace rushlight
