// Files that others made. Needs RUSHLIGHT_ASSETS.
#include "engine/assets/gltf.h"
#include "engine/assets/image.h"
#include "engine/jobs/tbb_jobs.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

#include <gtest/gtest.h>

namespace rushlight::assets {
namespace {

namespace fs = std::filesystem;

class AssetsCorpus : public testing::Test {
protected:
    void SetUp() override {
        const char* folder = std::getenv("RUSHLIGHT_ASSETS");
        if (!folder) GTEST_SKIP() << "RUSHLIGHT_ASSETS is not set: there are no files to load.";
        root_ = folder;
        jobs_ = createTbbJobs(2);
        options_.jobs = jobs_.get();
    }

    /// Sorted: the order of a folder is not.
    std::vector<fs::path> files(const char* folder) const {
        std::set<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(root_ / folder)) {
            const auto extension = entry.path().extension();
            if (extension == ".gltf" || extension == ".glb") found.insert(entry.path());
        }
        return {found.begin(), found.end()};
    }

    static void expectConsistent(const Model& model) {
        for (const Geometry& geometry : model.geometries) {
            const size_t count = geometry.positions.size();
            EXPECT_EQ(geometry.normals.size(), count);
            EXPECT_TRUE(geometry.tangents.empty() || geometry.tangents.size() == count);
            EXPECT_TRUE(geometry.skin.empty() || geometry.skin.size() == count);
            EXPECT_EQ(geometry.indices.size() % 3, 0u);
            for (uint32_t index : geometry.indices) ASSERT_LT(index, count);
            for (const vec3& normal : geometry.normals) ASSERT_NEAR(glm::length(normal), 1, 1e-3f);
            for (const vec4& tangent : geometry.tangents) ASSERT_EQ(std::abs(tangent.w), 1);
        }
        for (const Image& image : model.images)
            EXPECT_EQ(image.pixels.size(), size_t(image.width) * image.height * 4) << image.name;
    }

    fs::path root_;
    std::unique_ptr<JobSystem> jobs_;
    LoadOptions options_;
};

TEST_F(AssetsCorpus, ModelsAndScenesLoadUnlessTheyRequireAnExtension) {
    for (const char* folder : {"models", "scenes", "bench", "lights", "kits", "extensions"})
        for (const fs::path& path : files(folder)) {
            SCOPED_TRACE(path.string());
            const Result<Model> model = loadModel(path, options_);
            if (model)
                expectConsistent(*model);
            else
                EXPECT_EQ(model.error().message.rfind("uses ", 0), 0u) << model.error().text();
        }
}

TEST_F(AssetsCorpus, MeshesThatUseTheSameAccessorsShareGeometry) {
    const Result<Model> model = loadModel(root_ / "bench/grid3000.glb", options_);
    ASSERT_TRUE(model.has_value()) << model.error().text();
    EXPECT_EQ(model->meshes.size(), 779u);
    EXPECT_LE(model->geometries.size(), 42u);
    EXPECT_EQ(model->lights.size(), 65u);
}

TEST_F(AssetsCorpus, LoadingTwiceGivesTheSame) {
    const auto path = root_ / "models/DamagedHelmet/glTF-Binary/DamagedHelmet.glb";
    LoadOptions serial;
    const Result<Model> a = loadModel(path, options_), b = loadModel(path, serial);
    ASSERT_TRUE(a.has_value() && b.has_value());
    EXPECT_EQ(a->geometries[0].tangents, b->geometries[0].tangents);
    for (size_t i = 0; i < a->images.size(); ++i)
        EXPECT_EQ(a->images[i].pixels, b->images[i].pixels);
}

TEST_F(AssetsCorpus, InvalidFilesOfTheValidatorAreRefused) {
    size_t invalid = 0, refused = 0, refusedStrictly = 0, valid = 0, accepted = 0;
    LoadOptions strict = options_;
    strict.strict = true;
    for (const fs::path& path : files("conformance/validator")) {
        std::ifstream stream(path.string() + ".report.json");
        if (!stream) continue;
        const auto report = nlohmann::json::parse(stream);
        const bool loads = loadModel(path, options_).has_value();
        if (report["issues"]["numErrors"] == 0) {
            ++valid;
            accepted += loads;
            continue;
        }
        ++invalid;
        refused += !loads;
        refusedStrictly += !loadModel(path, strict).has_value();
    }
    std::cout << "refused " << refused << " (strictly " << refusedStrictly << ") of " << invalid
              << " invalid files; accepted " << accepted << " of " << valid << " valid ones\n";
    EXPECT_GE(refused, 125u);
    EXPECT_GE(refusedStrictly, 138u);
    EXPECT_GE(accepted, 90u);
}

TEST_F(AssetsCorpus, MalformedFilesAreRefusedOrConsistent) {
    size_t refused = 0;
    const std::vector<fs::path> paths = files("malformed");
    for (const fs::path& path : paths) {
        SCOPED_TRACE(path.string());
        const Result<Model> model = loadModel(path, options_);
        if (model) expectConsistent(*model);
        refused += !model.has_value();
    }
    std::cout << "refused " << refused << " of " << paths.size() << " malformed files\n";
    EXPECT_GE(refused, 78u);
}

TEST_F(AssetsCorpus, GeneratedPositiveFilesLoad) {
    for (const fs::path& path : files("conformance/asset-generator/Positive")) {
        const Result<Model> model = loadModel(path, options_);
        if (model) continue;
        const std::string& reason = model.error().message;
        EXPECT_TRUE(reason.rfind("uses KHR_", 0) == 0 ||
                    reason.find("minVersion") != std::string::npos)
            << model.error().text();
    }
}

TEST_F(AssetsCorpus, GeneratedNegativeFilesAreRefused) {
    options_.strict = true;  // a primitive without positions is skipped otherwise, as the
                             // specification advises
    for (const fs::path& path : files("conformance/asset-generator/Negative"))
        EXPECT_FALSE(loadModel(path, options_).has_value()) << path;
}

TEST_F(AssetsCorpus, EnvironmentsLoad) {
    for (const auto& entry : fs::directory_iterator(root_ / "env")) {
        const auto extension = entry.path().extension();
        if (extension != ".hdr" && extension != ".exr") continue;
        const Result<HdrImage> image = loadHdr(entry.path());
        EXPECT_TRUE(image.has_value()) << image.error().text();
    }
}

}  // namespace
}  // namespace rushlight::assets
