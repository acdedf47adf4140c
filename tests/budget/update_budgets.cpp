// Says how the budgets would change; with --write, changes them.

#include "tests/budget/budgets.h"
#include "tests/support/gl/test_context.h"

#include <cstdio>
#include <cstring>
#include <fstream>

int main(int count, char** arguments) {
    using namespace rushlight;
    const bool write = count == 2 && std::strcmp(arguments[1], "--write") == 0;
    if (count > 1 && !write) {
        std::fputs("usage: budget_update [--write]\n", stderr);
        return 2;
    }
    TestContext context;
    if (!context.valid()) {
        std::fputs("budget_update: error: no EGL surfaceless context.\n", stderr);
        return 4;
    }
    std::ifstream file(budgetPath());
    const auto old = file ? nlohmann::ordered_json::parse(file) : nlohmann::ordered_json::object();
    nlohmann::ordered_json all;
    for (const BudgetScene& scene : budgetScenes()) {
        const auto measured = measureBudget(scene, TestContext::load);
        if (!measured) {
            std::fprintf(stderr, "budget_update: error: %s\n", measured.error().text().c_str());
            return 3;
        }
        all[scene.name] = *measured;
        const auto lines = differences(old.value(scene.name, nlohmann::ordered_json::object()),
                                       *measured);
        std::printf("%s: %s\n", scene.name, lines.empty() ? "the same" : "changes");
        for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
    }
    if (write) std::ofstream(budgetPath()) << all.dump(1) << "\n";
    return 0;
}
