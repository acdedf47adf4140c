#pragma once

#include <string_view>

namespace rushlight {

/// The parts of index.html, from renderer/capture/page.
struct PageParts {
    std::string_view html, style;
    std::string_view scripts[3];  ///< one after the other, in one scope
};
PageParts breakdownPageParts();

}  // namespace rushlight
