// Timelines that the tool writes of frames it draws.
#include "tests/support/run_tool.h"
#include "tests/support/temporary_directory.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <map>

namespace rushlight {
namespace {

using nlohmann::json;

constexpr const char* kScene = RUSHLIGHT_SOURCE "/content/testcard/testcard.gltf --size 64x36 ";
constexpr int kCpu = 1, kGpu = 2;

class TraceCli : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder.path() + "/" + name; }
    json read(const std::string& name) const { return json::parse(std::ifstream(path(name))); }
    Ended run(const std::string& arguments) const { return runTool(folder.path(), arguments); }
    static std::vector<json> events(const json& trace, const char* category, int track) {
        std::vector<json> found;
        for (const json& event : trace["traceEvents"])
            if (event["ph"] == "X" && event["cat"] == category && event["tid"] == track)
                found.push_back(event);
        return found;
    }
    TemporaryDirectory folder;
};

TEST_F(TraceCli, TheLastFrameIsThatOfTheStatistics) {
    const Ended ended = run(std::string("capture ") + kScene + "-o " + path("a.png") +
                            " --warmup 2 --stats " + path("stats.json") + " --trace " +
                            path("trace.json"));
    ASSERT_EQ(ended.code, 0) << ended.errors;
    const json trace = read("trace.json"), stats = read("stats.json");
    const auto frames = events(trace, "frame", kCpu);
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_TRUE(frames[1]["args"].contains("warm_up"));
    EXPECT_FALSE(frames[2]["args"].contains("warm_up"));
    EXPECT_EQ(trace["otherData"]["gl_renderer"], stats["gl_renderer"]);
    std::map<int, std::vector<json>> last;
    for (const int track : {kCpu, kGpu}) {
        const auto drawn = events(trace, "frame", track);
        ASSERT_FALSE(drawn.empty());
        // The GPU's times are told with the frame after.
        EXPECT_EQ(drawn.back()["args"]["frame"], frames[track == kGpu ? 1 : 2]["args"]["frame"]);
        for (const json& pass : events(trace, "pass", track))
            if (pass["ts"].get<double>() >= drawn.back()["ts"].get<double>())
                last[track].push_back(pass);
    }
    const json& passes = stats["passes"];
    ASSERT_EQ(last[kCpu].size(), passes.size());
    double gpu = 0;
    for (size_t i = 0; i < passes.size(); ++i) {
        const json& pass = last[kCpu][i];
        EXPECT_EQ(pass["name"], passes[i]["name"]);
        EXPECT_EQ(pass["args"]["draws"], passes[i]["draws"]);
        EXPECT_EQ(pass["args"]["triangles"], passes[i]["triangles"]);
        EXPECT_NEAR(pass["dur"].get<double>(), passes[i]["cpu_ms"].get<double>() * 1000, 2e-3);
    }
    for (const json& pass : last[kGpu]) gpu += pass["dur"].get<double>() / 1000;
    EXPECT_NEAR(gpu, stats["frame"]["gpu_ms"].get<double>(), 1e-5);
    EXPECT_GT(gpu, 0);
}

TEST_F(TraceCli, TheGpuDrawsAFrameWhileItsFrameLasts) {
    const Ended ended = run(std::string("bench ") + kScene + "--frames 8 --trace " +
                            path("trace.json"));
    ASSERT_EQ(ended.code, 0) << ended.errors;
    const json trace = read("trace.json");
    std::map<uint64_t, json> frames;
    for (const json& frame : events(trace, "frame", kCpu)) frames[frame["args"]["frame"]] = frame;
    const auto drawn = events(trace, "frame", kGpu);
    ASSERT_GE(drawn.size(), 6u);
    constexpr double kClocks = 500;  // microseconds, by which their comparison may be wrong
    for (const json& gpu : drawn) {
        const json& frame = frames.at(gpu["args"]["frame"]);
        const double begin = frame["ts"], end = begin + frame["dur"].get<double>();
        EXPECT_GE(gpu["ts"].get<double>(), begin - kClocks) << gpu;
        EXPECT_LE(gpu["ts"].get<double>() + gpu["dur"].get<double>(), end + kClocks) << gpu;
    }
    const auto passes = events(trace, "pass", kGpu);
    double gaps = 0;
    for (size_t i = 1; i < passes.size(); ++i)
        gaps += passes[i]["ts"].get<double>() - passes[i - 1]["ts"].get<double>() -
                passes[i - 1]["dur"].get<double>();
    EXPECT_GT(gaps, 0) << "begins are measured";
}

TEST_F(TraceCli, ABenchAndASequenceHaveAllTheirFrames) {
    Ended ended = run(std::string("bench ") + kScene + "--warmup 1 --frames 3 --trace " +
                      path("bench.json"));
    ASSERT_EQ(ended.code, 0) << ended.errors;
    EXPECT_EQ(events(read("bench.json"), "frame", kCpu).size(), 4u);
    ended = run(std::string("capture ") + kScene + "--frames 0-4 -o " + path("f_%d.png") +
                " --trace " + path("sequence.json"));
    ASSERT_EQ(ended.code, 0) << ended.errors;
    EXPECT_EQ(events(read("sequence.json"), "frame", kCpu).size(), 5u);
}

TEST_F(TraceCli, AfterAnErrorTheFramesUntilThenAreThere) {
    const Ended ended = run(std::string("capture ") + kScene +
                            "-o /dev/null/a.png --warmup 1 --trace " + path("trace.json"));
    EXPECT_EQ(ended.code, 3) << ended.errors;
    const json trace = read("trace.json");
    EXPECT_EQ(events(trace, "frame", kCpu).size(), 2u);
    EXPECT_NE(trace["otherData"]["error"].get<std::string>().find("/dev/null"), std::string::npos);
}

}  // namespace
}  // namespace rushlight
