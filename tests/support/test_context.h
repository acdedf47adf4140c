#pragma once
// A current OpenGL 4.5 core context with no window and no surface, for tests.

#include <string>

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

/// A directory of its own that is removed at the end.
class TemporaryDirectory {
public:
    TemporaryDirectory();
    ~TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    const std::string& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const;

private:
    std::string path_;
};

}  // namespace rushlight
