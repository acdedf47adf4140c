#pragma once
// A current OpenGL 4.5 core context with no window and no surface, for tests.

#include "tests/support/temporary_directory.h"

namespace rushlight {

class TestContext {
public:
    TestContext();  ///< with GL_KHR_debug output
    ~TestContext();
    TestContext(const TestContext&) = delete;
    TestContext& operator=(const TestContext&) = delete;

    bool valid() const { return context_ != nullptr; }
    static void* load(const char* name);

private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace rushlight
