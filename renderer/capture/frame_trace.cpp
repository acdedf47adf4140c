#include "renderer/capture/frame_trace.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

using nlohmann::ordered_json;

constexpr int kProcess = 1, kCpu = 1, kGpu = 2, kServing = 3;

constexpr const char* kLayout =
    "Begins and durations are measured. A frame's GPU times arrive with a later frame: the last "
    "frames have none.";

/// Nanoseconds, so that ends and beginnings that should be equal are.
int64_t nanoseconds(double ms) { return std::isfinite(ms) && ms > 0 ? std::llround(ms * 1e6) : 0; }

// Names come from hosts and may be no UTF-8.
std::string dump(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

class Writer {
public:
    explicit Writer(std::string& events) : events_(events) {}

    void complete(int track, const std::string& name, const char* category, int64_t begin,
                  int64_t end, const std::string& arguments = "{}") {
        const ordered_json event = {{"ph", "X"},
                                    {"name", name},
                                    {"cat", category},
                                    {"pid", kProcess},
                                    {"tid", track},
                                    {"ts", double(begin) / 1000},
                                    {"dur", double(end - begin) / 1000}};
        std::string text = dump(event);
        text.back() = ',';
        events_ += ",\n" + text + "\"args\":" + arguments + '}';
    }
    void counter(const char* name, int64_t time, uint64_t value) {
        add({{"ph", "C"},
             {"name", name},
             {"pid", kProcess},
             {"ts", double(time) / 1000},
             {"args", {{"value", value}}}});
    }
    void metadata(const char* name, int track, const char* value) {
        add({{"ph", "M"},
             {"name", name},
             {"pid", kProcess},
             {"tid", track},
             {"args", {{"name", value}}}});
    }

private:
    void add(const ordered_json& event) { events_ += ",\n" + dump(event); }
    std::string& events_;
};

std::string passArguments(const PassReport& pass) {
    return dump({{"draws", pass.draws},
                 {"triangles", pass.triangles},
                 {"gl_calls", pass.glCalls},
                 {"state_changes", pass.stateChanges}});
}

std::string frameArguments(const FrameReport& report, const FrameTiming& timing) {
    ordered_json arguments = {{"frame", report.frameNumber},
                              {"instances", report.instances},
                              {"visible", report.visible},
                              {"lights_visible", report.lightsVisible},
                              {"uploaded_bytes", report.uploadedBytes},
                              {"waits", report.waits}};
    if (timing.warmUp) arguments["warm_up"] = true;
    return dump(arguments);
}

}  // namespace

FrameTrace::Known* FrameTrace::known(uint64_t number) {
    Known& frame = recent_[number % recent_.size()];
    return frame.number == number ? &frame : nullptr;
}

void FrameTrace::add(const FrameReport& report, const FrameTiming& timing) {
    Writer writer(events_);
    const std::string name = "frame " + std::to_string(report.frameNumber);
    const int64_t begin = std::max(nanoseconds(timing.beginMs), cpuEnd_);
    const int64_t buildEnd = begin + nanoseconds(report.cpuBuildMs);
    ++frames_;
    recent_[report.frameNumber % recent_.size()] = {report.frameNumber, begin, buildEnd, false, {}};

    Known* executed = known(report.executedFrame);
    if (executed && executed->executed) executed = nullptr;  // that was told before
    const bool serves = executed && report.executedFrame != report.frameNumber;
    Execution execute;
    if (executed)
        execute = execution(report, *executed, serves ? kServing : kCpu,
                            serves ? servingEnd_ : buildEnd);
    cpuEnd_ = std::max({begin + nanoseconds(timing.wallMs), buildEnd, serves ? 0 : execute.end});
    // What holds others comes before them.
    writer.complete(kCpu, name, "frame", begin, cpuEnd_, frameArguments(report, timing));
    writer.complete(kCpu, "build", "stage", begin, buildEnd);
    events_ += execute.events;
    if (serves) servingEnd_ = execute.end;
    addGpu(report);
    writer.counter("draws", begin, report.draws);
    writer.counter("triangles", begin, report.triangles);
    writer.counter("GL calls", begin, report.glCalls);
    writer.counter("allocations", begin, timing.allocations);
}

FrameTrace::Execution FrameTrace::execution(const FrameReport& report, Known& frame, int track,
                                            int64_t earliest) {
    frame.executed = true;
    frame.executeBegin = std::max(frame.begin + nanoseconds(report.cpuExecuteBeginMs), earliest);
    int64_t end = frame.executeBegin;
    std::string passes;
    Writer writer(passes);
    for (const PassReport& pass : report.passes) {
        frame.passes.emplace_back(pass.name, passArguments(pass));
        const int64_t begin = std::max(frame.executeBegin + nanoseconds(pass.cpuBeginMs), end);
        end = begin + nanoseconds(pass.cpuMs);
        writer.complete(track, pass.name, "pass", begin, end, frame.passes.back().second);
    }
    end = std::max(end, frame.executeBegin + nanoseconds(report.cpuExecuteMs));
    Execution result{end, {}};
    Writer(result.events)
        .complete(track, "execute", "stage", frame.executeBegin, end,
                  dump({{"frame", *frame.number},
                        {"gl_calls", report.glCalls},
                        {"state_changes", report.stateChanges}}));
    result.events += passes;
    return result;
}

void FrameTrace::addGpu(const FrameReport& report) {
    const Known* frame = known(report.gpuFrame);
    if (!frame || !frame->executed || lastOnGpu_ == report.gpuFrame) return;
    std::string passes;
    Writer writer(passes);
    int64_t begin = 0, end = gpuEnd_;
    for (size_t i = 0; i < report.passes.size(); ++i) {
        const PassReport& pass = report.passes[i];
        if (!(pass.gpuMs > 0)) continue;
        const int64_t passBegin = std::max(frame->executeBegin + nanoseconds(pass.gpuBeginMs), end);
        if (passes.empty()) begin = passBegin;
        end = passBegin + nanoseconds(pass.gpuMs);
        const bool same = i < frame->passes.size() && frame->passes[i].first == pass.name;
        writer.complete(kGpu, pass.name, "pass", passBegin, end,
                        same ? frame->passes[i].second : "{}");
    }
    if (passes.empty()) return;
    Writer(events_).complete(kGpu, "frame " + std::to_string(report.gpuFrame), "frame", begin, end,
                             dump({{"frame", report.gpuFrame}}));
    events_ += passes;
    gpuEnd_ = end;
    lastOnGpu_ = report.gpuFrame;
}

std::string FrameTrace::json(std::string_view device, std::string_view version) const {
    std::string head;
    Writer writer(head);
    writer.metadata("process_name", 0, "rushlight");
    writer.metadata("thread_name", kCpu, "CPU");
    writer.metadata("thread_name", kGpu, "GPU");
    if (servingEnd_ > 0) writer.metadata("thread_name", kServing, "Serving thread");
    ordered_json about = {{"gl_renderer", std::string(device)},
                          {"gl_version", std::string(version)},
                          {"frames", frames_},
                          {"layout", kLayout}};
    if (!error_.empty()) about["error"] = error_;
    return "{\"displayTimeUnit\": \"ms\",\n\"otherData\": " + dump(about) +
           ",\n\"traceEvents\": [" + head.substr(1) + events_ + "\n]}\n";
}

}  // namespace rushlight
