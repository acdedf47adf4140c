#pragma once

#include "engine/core/result.h"

#include <string>
#include <vector>

namespace rushlight::tool {

/// The command line without the program's name. @FILE stands for the words in a file: apart by
/// white space, "quoted" where they have any; lines that begin with # are comments.
Result<std::vector<std::string>> commandWords(int count, char** arguments);

}  // namespace rushlight::tool
