// Timelines as trace events: what a viewer relies on, and that nothing of the report is lost.
#include "renderer/capture/frame_trace.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <random>

namespace rushlight {
namespace {

using nlohmann::json;

constexpr int kCpu = 1, kGpu = 2;
constexpr double kNanosecond = 1e-3;  ///< of the file's microseconds

json parsed(const FrameTrace& trace) { return json::parse(trace.json("device", "4.5")); }

std::vector<json> eventsOf(const json& file, const char* phase, int track = 0) {
    std::vector<json> found;
    for (const json& event : file["traceEvents"])
        if (event["ph"] == phase && (track == 0 || event["tid"] == track)) found.push_back(event);
    return found;
}

int64_t beginOf(const json& event) { return std::llround(event["ts"].get<double>() * 1000); }
int64_t endOf(const json& event) {
    return beginOf(event) + std::llround(event["dur"].get<double>() * 1000);
}

FrameReport randomReport(std::mt19937& random, uint64_t number) {
    static const char* const kNames[] = {"depth",    "gbuffer", "shadow",
                                         "lighting", "bloom",   "tonemap"};
    std::uniform_real_distribution<double> time(0.001, 3);
    FrameReport report;
    report.frameNumber = report.executedFrame = number;
    report.cpuBuildMs = time(random);
    report.cpuExecuteBeginMs = report.cpuBuildMs + 0.5;
    report.cpuExecuteMs = 0.01;
    report.gpuFrame = number;
    double gpuBegin = 1;
    for (const char* name : kNames) {
        PassReport& pass = report.passes.emplace_back();
        pass.name = name;
        pass.draws = uint32_t(random() % 100);
        pass.triangles = random() % 10000;
        pass.glCalls = uint32_t(random() % 500);
        pass.cpuMs = time(random);
        pass.gpuMs = time(random) * 4;
        pass.cpuBeginMs = report.cpuExecuteMs;
        pass.gpuBeginMs = gpuBegin;
        gpuBegin += pass.gpuMs + 0.125;
        report.cpuExecuteMs += pass.cpuMs + 0.0625;
        report.gpuMs += pass.gpuMs;
        report.draws += pass.draws;
        report.triangles += pass.triangles;
        report.glCalls += pass.glCalls;
    }
    return report;
}

/// Frames whose GPU needs longer than the CPU takes to bring the next one.
FrameTrace randomTrace(std::vector<FrameReport>& reports) {
    std::mt19937 random(7);
    FrameTrace trace;
    double now = 0.5;
    for (uint64_t i = 0; i < 20; ++i) {
        const FrameReport& report = reports.emplace_back(randomReport(random, i));
        const double wall = report.cpuExecuteBeginMs + report.cpuExecuteMs + 0.25;
        trace.add(report, {now, wall, i * 3, i < 2});
        now += wall * (i % 5 == 4 ? 0.9 : 1.1);  // a clock that is not quite in step
    }
    return trace;
}

// As a viewer builds its tracks: an event lies in the one that is open, or begins when that has
// ended.
void expectNested(const std::vector<json>& events) {
    std::vector<json> open;
    int64_t last = 0;
    for (const json& event : events) {
        EXPECT_GE(beginOf(event), last) << event;
        last = beginOf(event);
        while (!open.empty() && endOf(open.back()) <= beginOf(event) && event["cat"] != "pass")
            open.pop_back();
        while (!open.empty() && open.back()["cat"] == event["cat"]) {
            EXPECT_LE(endOf(open.back()), beginOf(event)) << event;
            open.pop_back();
        }
        if (!open.empty()) {
            EXPECT_LE(endOf(event), endOf(open.back())) << event << " in " << open.back();
        }
        open.push_back(event);
    }
}

TEST(FrameTrace, EventsNestAndDoNotOverlapOnATrack) {
    std::vector<FrameReport> reports;
    const json file = parsed(randomTrace(reports));
    for (int track : {kCpu, kGpu}) {
        const auto events = eventsOf(file, "X", track);
        ASSERT_GE(events.size(), reports.size() * 7);
        expectNested(events);
    }
}

TEST(FrameTrace, SumsAreThoseOfTheReports) {
    std::vector<FrameReport> reports;
    const json file = parsed(randomTrace(reports));
    for (int track : {kCpu, kGpu}) {
        uint64_t frame = 0;
        double passes[20] = {};
        int events[20] = {};
        uint64_t draws[20] = {}, triangles[20] = {};
        for (const json& event : eventsOf(file, "X", track)) {
            const double ms = event["dur"].get<double>() / 1000;
            if (event["cat"] == "frame") {
                frame = event["args"]["frame"].get<uint64_t>();
                ASSERT_LT(frame, 20u);
                if (track == kGpu) {
                    EXPECT_GE(ms, reports[frame].gpuMs - 6 * kNanosecond / 1000);
                    EXPECT_LE(ms, reports[frame].gpuMs + 5 * 0.125 + 6 * kNanosecond / 1000);
                }
            } else if (event["cat"] == "stage") {
                const bool build = event["name"] == "build";
                EXPECT_NEAR(ms, build ? reports[frame].cpuBuildMs : reports[frame].cpuExecuteMs,
                            kNanosecond / 1000);
            } else {
                passes[frame] += ms;
                ++events[frame];
                draws[frame] += event["args"]["draws"].get<uint64_t>();
                triangles[frame] += event["args"]["triangles"].get<uint64_t>();
            }
        }
        for (size_t i = 0; i < reports.size(); ++i) {
            double expected = 0;
            for (const PassReport& pass : reports[i].passes)
                expected += track == kGpu ? pass.gpuMs : pass.cpuMs;
            EXPECT_NEAR(passes[i], expected, 6 * kNanosecond / 1000) << track << " frame " << i;
            EXPECT_EQ(events[i], 6);
            EXPECT_EQ(draws[i], reports[i].draws);
            EXPECT_EQ(triangles[i], reports[i].triangles);
        }
    }
}

TEST(FrameTrace, EventsBeginWhenTheyBegan) {
    std::mt19937 random(3);
    const FrameReport report = randomReport(random, 0);
    FrameTrace trace;
    trace.add(report, {10, 40, 0, false});
    const json file = parsed(trace);
    const double execute = 10 + report.cpuExecuteBeginMs;
    for (int track : {kCpu, kGpu}) {
        size_t next = 0;
        for (const json& event : eventsOf(file, "X", track)) {
            if (event["cat"] != "pass") continue;
            const PassReport& pass = report.passes.at(next++);
            const double begin = execute + (track == kGpu ? pass.gpuBeginMs : pass.cpuBeginMs);
            EXPECT_EQ(event["name"], pass.name);
            EXPECT_NEAR(event["ts"].get<double>() / 1000, begin, 2 * kNanosecond / 1000) << event;
        }
        EXPECT_EQ(next, report.passes.size());
    }
}

TEST(FrameTrace, GpuTimesAreOnceThereAndWhereTheirFrameWas) {
    std::mt19937 random(5);
    FrameTrace trace;
    std::vector<double> execute;
    for (uint64_t i = 0; i < 6; ++i) {
        FrameReport report = randomReport(random, i);
        report.gpuFrame = i < 2 ? 0 : i - 1 - i % 2;  // some arrive late, one never, some are told
                                                      // twice
        trace.add(report, {double(100 * i), 20, 0, false});
        execute.push_back(double(100 * i) + report.cpuExecuteBeginMs);
    }
    std::vector<uint64_t> frames;
    for (const json& event : eventsOf(parsed(trace), "X", kGpu)) {
        if (event["cat"] != "frame") continue;
        frames.push_back(event["args"]["frame"]);
        EXPECT_NEAR(event["ts"].get<double>() / 1000, execute[frames.back()] + 1, 1e-5);
    }
    EXPECT_EQ(frames, (std::vector<uint64_t>{0, 1, 3}));
}

TEST(FrameTrace, WhatAServingThreadExecutedHasATrackOfItsOwn) {
    constexpr int kServing = 3;
    std::mt19937 random(6);
    FrameTrace trace;
    for (uint64_t i = 0; i < 5; ++i) {
        FrameReport report = randomReport(random, i);
        report.executedFrame = i == 0 ? FrameReport::kNone : i - 1;
        report.cpuExecuteBeginMs = 12;
        trace.add(report, {double(10 * i), report.cpuBuildMs + 0.1, 0, false});
    }
    const json file = parsed(trace);
    const auto events = eventsOf(file, "X", kServing);
    expectNested(events);
    std::vector<uint64_t> frames;
    for (const json& event : events)
        if (event["cat"] == "stage") frames.push_back(event["args"]["frame"]);
    EXPECT_EQ(frames, (std::vector<uint64_t>{0, 1, 2, 3}));
    EXPECT_NEAR(events.front()["ts"].get<double>() / 1000, 12, 1e-5);
    for (const json& event : eventsOf(file, "X", kCpu)) EXPECT_NE(event["cat"], "pass");
    EXPECT_EQ(eventsOf(file, "M").size(), 4u);
}

TEST(FrameTrace, CountersAreThoseOfTheReports) {
    std::vector<FrameReport> reports;
    const json file = parsed(randomTrace(reports));
    std::map<std::string, std::vector<uint64_t>> counters;
    for (const json& event : eventsOf(file, "C"))
        counters[event["name"]].push_back(event["args"]["value"].get<uint64_t>());
    ASSERT_EQ(counters.size(), 4u);
    for (size_t i = 0; i < reports.size(); ++i) {
        EXPECT_EQ(counters["draws"].at(i), reports[i].draws);
        EXPECT_EQ(counters["triangles"].at(i), reports[i].triangles);
        EXPECT_EQ(counters["GL calls"].at(i), reports[i].glCalls);
        EXPECT_EQ(counters["allocations"].at(i), i * 3);
    }
}

TEST(FrameTrace, WithoutFramesItIsValidAndSaysWhy) {
    FrameTrace trace;
    trace.setError("a \"bad\" name \xff");
    const json file = parsed(trace);
    EXPECT_EQ(file["otherData"]["frames"], 0);
    EXPECT_NE(file["otherData"]["error"].get<std::string>().find("\"bad\""), std::string::npos);
    EXPECT_EQ(eventsOf(file, "M").size(), 3u);
    EXPECT_TRUE(eventsOf(file, "X").empty());
}

TEST(FrameTrace, APassWithoutGpuTimeIsNotOnTheGpusTrack) {
    std::mt19937 random(1);
    FrameReport report = randomReport(random, 0);
    for (PassReport& pass : report.passes) pass.gpuMs = 0;
    FrameTrace trace;
    trace.add(report, {0, 1, 0, false});
    const json file = parsed(trace);
    EXPECT_TRUE(eventsOf(file, "X", kGpu).empty());
    EXPECT_EQ(eventsOf(file, "X", kCpu).size(), 3 + report.passes.size());
}

}  // namespace
}  // namespace rushlight
