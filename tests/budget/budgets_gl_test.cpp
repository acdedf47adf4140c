#include "tests/budget/budgets.h"
#include "tests/support/gl/test_context.h"

#include <gtest/gtest.h>

#include <fstream>

namespace rushlight {
namespace {

class Budgets : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(context.valid()) << "no EGL surfaceless context";
        std::ifstream file(budgetPath());
        ASSERT_TRUE(file) << budgetPath();
        all = nlohmann::ordered_json::parse(file);
    }
    std::vector<std::string> compare(const BudgetScene& scene, void (*change)(FrameInput&)) {
        const auto measured = measureBudget(scene, TestContext::load, change);
        EXPECT_TRUE(measured) << measured.error().text();
        return measured ? differences(all.at(scene.name), *measured) : std::vector<std::string>{};
    }
    TestContext context;
    nlohmann::ordered_json all;
};

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST_F(Budgets, AreKept) {
    ASSERT_EQ(all.size(), budgetScenes().size());
    for (const BudgetScene& scene : budgetScenes())
        EXPECT_EQ(joined(compare(scene, nullptr)), "")
            << scene.name
            << ": if that is wanted, `cmake --build build/release --target update_budgets`";
}

// Each of these costs one thing more, and none may go unnoticed.
TEST_F(Budgets, NoticeAPlantedPass) {
    const auto plant = [](FrameInput& input) { input.settings.debugView = DebugView::bounds; };
    EXPECT_NE(joined(compare(budgetScenes()[0], plant)).find("bounds"), std::string::npos);
}

TEST_F(Budgets, NoticeAPlantedBind) {
    // One flipped winding more is one pipeline more in the passes that draw it.
    const auto plant = [](FrameInput& input) {
        static std::vector<Instance> instances;
        instances.assign(input.instances.begin(), input.instances.end());
        instances[instances.size() / 2].worldFromLocal[0] *= -1.0f;
        input.instances = instances;
    };
    EXPECT_NE(joined(compare(budgetScenes()[0], plant)).find("state_changes"), std::string::npos);
}

TEST_F(Budgets, NoticeAPlantedDraw) {
    const auto plant = [](FrameInput& input) {
        static std::vector<Instance> instances;
        instances.assign(input.instances.begin(), input.instances.end());
        instances.push_back(instances[0]);
        input.instances = instances;
    };
    EXPECT_NE(joined(compare(budgetScenes()[1], plant)), "");
}

}  // namespace
}  // namespace rushlight
