#pragma once
// One function per way of making a context; each returns it current. The Error's message is a
// sentence with the reason of the library that refused.

#include "renderer/context/context.h"

namespace rushlight {

Result<std::unique_ptr<Context>> createEglContext(ContextKind, const ContextOptions&);
Result<std::unique_ptr<Context>> createOsmesaContext(const ContextOptions&);
Result<std::unique_ptr<Context>> createHiddenWindowContext(const ContextOptions&);

}  // namespace rushlight
