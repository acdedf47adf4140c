#include "tests/layering/layering.h"

#include "tests/layering/source_text.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace rushlight {
namespace {

namespace fs = std::filesystem;

/// What a folder's files may include of the project. The longest folder that fits a file decides.
struct Layer {
    std::string_view folder;
    std::vector<std::string_view> allowed;
};

/// Rooms of the renderer and what else of it their files may include; `interop` is shaders/interop.
/// One way: a room may know those above it.
const std::vector<Layer>& layers() {
    static const std::vector<Layer> table = {
        {"engine/core/", {"engine/core/"}},
        {"engine/", {"engine/"}},
        {"shaders/", {"interop/", "engine/core/"}},
        {"renderer/rhi/", {"engine/core/", "shaders/interop/", "interop/", "renderer/rhi/"}},
        {"renderer/frame/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/frame/", "renderer/rhi/"}},
        {"renderer/geometry/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/geometry/", "renderer/frame/",
          "renderer/rhi/"}},
        {"renderer/materials/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/materials/", "renderer/frame/",
          "renderer/rhi/"}},
        {"renderer/lighting/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/lighting/", "renderer/frame/",
          "renderer/geometry/", "renderer/rhi/"}},
        {"renderer/resources/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/resources/", "renderer/frame/",
          "renderer/geometry/", "renderer/lighting/", "renderer/materials/", "renderer/rhi/"}},
        {"renderer/lighting/clusters/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/lighting/clusters/",
          "renderer/frame/", "renderer/geometry/", "renderer/lighting/", "renderer/resources/",
          "renderer/rhi/"}},
        {"renderer/visibility/occlusion/", {"engine/core/", "renderer/visibility/occlusion/"}},
        {"renderer/visibility/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/visibility/", "renderer/frame/",
          "renderer/geometry/", "renderer/materials/", "renderer/resources/", "renderer/rhi/"}},
        {"renderer/shadows/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/shadows/", "renderer/frame/",
          "renderer/geometry/", "renderer/lighting/", "renderer/materials/", "renderer/resources/",
          "renderer/rhi/", "renderer/visibility/"}},
        {"renderer/plan/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/plan/", "renderer/frame/",
          "renderer/rhi/"}},
        {"renderer/passes/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/passes/", "renderer/frame/",
          "renderer/geometry/", "renderer/lighting/", "renderer/materials/", "renderer/plan/",
          "renderer/resources/", "renderer/rhi/", "renderer/shadows/", "renderer/visibility/"}},
        {"renderer/replay/", {"engine/core/", "renderer/replay/", "renderer/rhi/"}},
        {"renderer/pipeline/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/pipeline/", "renderer/frame/",
          "renderer/geometry/", "renderer/lighting/", "renderer/materials/", "renderer/passes/",
          "renderer/plan/", "renderer/replay/", "renderer/resources/", "renderer/rhi/",
          "renderer/shadows/", "renderer/visibility/"}},
        {"renderer/context/", {"engine/core/", "renderer/context/"}},
        {"renderer/backend/gl/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/backend/gl/", "renderer/rhi/"}},
        {"renderer/backend/null/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/backend/null/",
          "renderer/rhi/"}},
        {"renderer/raytrace/",
         {"engine/core/", "shaders/interop/", "interop/", "renderer/raytrace/", "renderer/frame/",
          "renderer/geometry/", "renderer/lighting/", "renderer/materials/"}},
        {"renderer/answers/", {"engine/core/", "shaders/interop/", "interop/", "renderer/"}},
        {"renderer/capture/", {"engine/core/", "shaders/interop/", "interop/", "renderer/"}},
        {"renderer/testing/", {"engine/core/", "engine/assets/", "renderer/"}},
        {"renderer/scene_bridge/", {"engine/", "renderer/", "shaders/interop/", "interop/"}},
        {"renderer/renderer.", {"engine/core/", "renderer/"}},
        {"sandbox/", {"engine/", "renderer/", "sandbox/", "content/", "shaders/interop/"}},
        {"content/", {"engine/", "renderer/", "content/", "shaders/interop/"}},
        {"tests/",
         {"engine/", "renderer/", "sandbox/", "content/", "tests/", "shaders/", "interop/"}},
    };
    return table;
}

constexpr std::string_view kGlFolders[] = {"renderer/backend/gl/", "renderer/context/", "tests/"};
constexpr std::string_view kGlfwFolders[] = {"renderer/context/", "sandbox/viewer/", "tests/"};
constexpr std::string_view kGlHeaders[] = {"GL/",  "EGL/",   "GLES2/", "GLES3/",
                                           "KHR/", "epoxy/", "glad/",  "imgui_impl_opengl"};

template <class Prefixes>
bool startsWithAny(std::string_view text, const Prefixes& prefixes) {
    return std::ranges::any_of(prefixes, [&](std::string_view p) { return text.starts_with(p); });
}

std::string readText(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

class Checker {
public:
    explicit Checker(const fs::path& root) : root_(root) {
        for (const char* folder :
             {"engine", "renderer", "shaders", "sandbox", "tests", "content"}) {
            if (!fs::exists(root / folder)) continue;
            for (const auto& entry : fs::recursive_directory_iterator(root / folder))
                if (entry.is_regular_file()) sort(entry.path());
        }
        if (fs::exists(root / "CMakeLists.txt")) sort(root / "CMakeLists.txt");
    }

    std::vector<std::string> run() {
        for (const auto& [name, text] : sources_) checkSource(name, text);
        checkBuildLists();
        checkShaderList();
        std::ranges::sort(violations_);
        return violations_;
    }

private:
    void sort(const fs::path& path) {
        const std::string name = path.lexically_relative(root_).generic_string();
        const std::string extension = path.extension();
        if (extension == ".h" || extension == ".cpp") sources_[name] = readText(path);
        if (extension == ".cmake" || path.filename() == "CMakeLists.txt")
            lists_[name] = readText(path);
        if (name.starts_with("shaders/") && extension != ".cmake" && extension != ".txt" &&
            extension != ".md")
            shaders_.insert(name.substr(8));
    }

    void report(const std::string& file, const std::string& what) {
        violations_.push_back(file + ": " + what);
    }

    void checkSource(const std::string& name, const std::string& text) {
        const Layer* layer = nullptr;
        for (const Layer& candidate : layers())
            if (name.starts_with(candidate.folder) &&
                (!layer || candidate.folder.size() > layer->folder.size()))
                layer = &candidate;
        if (!layer) return report(name, "is in no room of the layering table.");
        const bool gl = startsWithAny(name, kGlFolders), glfw = startsWithAny(name, kGlfwFolders);
        bool seesScene = false, seesFrame = false;
        for (const Include& include : includesOf(text)) {
            const std::string& path = include.path;
            const bool ofProject = startsWithAny(
                path, std::initializer_list<std::string_view>{"engine/", "renderer/", "sandbox/",
                                                              "tests/", "shaders/", "content/"});
            if ((ofProject || include.quoted) && !startsWithAny(path, layer->allowed))
                report(name, "includes " + path + ", which files of " + std::string(layer->folder) +
                                 " must not.");
            if (!gl && startsWithAny(path, kGlHeaders))
                report(name, "includes the GL header " + path + ".");
            if (!glfw && path.starts_with("GLFW/"))
                report(name, "includes the window header " + path + ".");
            seesScene |= path.starts_with("engine/scene/");
            seesFrame |= path.starts_with("renderer/frame/");
        }
        if (seesScene && seesFrame && !name.starts_with("renderer/scene_bridge/") &&
            !name.starts_with("tests/"))
            report(name, "sees both engine/scene and renderer/frame; only the bridge may.");
        // The state cache turns it off; nothing may turn it on (see validate_commands.cpp).
        if (!name.starts_with("tests/") && name != "renderer/backend/gl/gl_state.cpp" &&
            codeOf(text).find("GL_FRAMEBUFFER_SRGB") != std::string::npos)
            report(name, "names GL_FRAMEBUFFER_SRGB; pictures are encoded by shaders.");
        if (gl) return;
        if (const std::string used = glIdentifierIn(codeOf(text)); !used.empty())
            report(name, "names " + used + " of OpenGL.");
    }

    bool isIncluded(const std::string& script) const {
        const std::string file = fs::path(script).filename();
        for (const auto& [name, text] : lists_) {
            const std::string code = cmakeCodeOf(text);
            for (size_t at = code.find("include("); at != code.npos;
                 at = code.find("include(", at + 1))
                if (code.substr(at, code.find(')', at) - at).ends_with(file)) return true;
        }
        return false;
    }

    void checkBuildLists() {
        std::set<std::string> listed;
        for (const auto& [name, text] : lists_) {
            const fs::path folder = fs::path(name).parent_path();
            // A script that is run with -P lists no sources and may look for files.
            const bool builds = fs::path(name).filename() == "CMakeLists.txt" || isIncluded(name);
            if (builds && cmakeCodeOf(text).find("file(GLOB") != std::string::npos)
                report(name, "finds files with file(GLOB); list them.");
            for (std::string word : cmakeWords(text, ".cpp")) {
                fs::path base = folder;
                for (const std::string_view variable :
                     {"${PROJECT_SOURCE_DIR}/", "${CMAKE_CURRENT_SOURCE_DIR}/"})
                    if (word.starts_with(variable)) {
                        word.erase(0, variable.size());
                        if (variable.starts_with("${PROJECT")) base.clear();
                    }
                listed.insert((base / word).lexically_normal().generic_string());
            }
        }
        for (const auto& [name, text] : sources_)
            if (name.ends_with(".cpp") && !listed.contains(name))
                report(name, "is in no CMake list: nothing builds it.");
    }

    void checkShaderList() {
        const std::string file = "shaders/files.cmake";
        std::set<std::string> listed;
        for (const char* ending : {".glsl", ".vert", ".frag", ".comp", ".h"})
            for (const std::string& word : cmakeWords(lists_[file], ending)) listed.insert(word);
        for (const std::string& shader : shaders_)
            if (!listed.contains(shader)) report("shaders/" + shader, "is not in " + file + ".");
        for (const std::string& shader : listed)
            if (!shaders_.contains(shader))
                report(file, "lists " + shader + ", which does not exist.");
    }

    fs::path root_;
    std::map<std::string, std::string> sources_, lists_;  ///< by path from the root
    std::set<std::string> shaders_;                       ///< by path from shaders/
    std::vector<std::string> violations_;
};

}  // namespace

std::vector<std::string> findLayeringViolations(const fs::path& root) {
    return Checker(root).run();
}

}  // namespace rushlight
