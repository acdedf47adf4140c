#pragma once
// What every subcommand of the tool shares: how it registers, ends and reports an error.

#include "engine/core/result.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace rushlight::tool {

inline constexpr int kSuccess = 0;
inline constexpr int kComparisonFailed = 1;
inline constexpr int kCauseFound = 1;

/// Set by the subcommand that was chosen; run after all options are read. The value is the exit
/// code.
using Action = std::function<Result<int>()>;

/// 2 wrong use, 3 bad input, 4 no context.
int exitCode(ErrorKind kind);

/// `rushlight: error: <object>: <message>` on standard error, always one line.
void printError(const Error& error);
void printWarning(const std::string& message);

void addBake(CLI::App& app, Action& action);
void addBreakdown(CLI::App& app, Action& action);
void addBench(CLI::App& app, Action& action);
void addCapture(CLI::App& app, Action& action);
void addCheck(CLI::App& app, Action& action);
void addCompare(CLI::App& app, Action& action);
void addDiagnose(CLI::App& app, Action& action);
void addDoctor(CLI::App& app, Action& action);
void addExplain(CLI::App& app, Action& action);
void addGoldens(CLI::App& app, Action& action);
void addInfo(CLI::App& app, Action& action);
void addReplay(CLI::App& app, Action& action);
void addView(CLI::App& app, Action& action);

}  // namespace rushlight::tool
