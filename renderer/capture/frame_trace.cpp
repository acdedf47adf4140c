#include "renderer/capture/frame_trace.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rushlight {
namespace {

using nlohmann::ordered_json;

constexpr int kProcess = 1, kCpu = 1, kGpu = 2;

constexpr const char* kLayout =
    "Durations are measured; passes follow one another without gaps from the start of what holds them. GPU times are those "
    "of the newest frame that was finished when the frame was submitted.";

/// Nanoseconds, so that ends and beginnings that should be equal are.
int64_t nanoseconds(double ms) { return std::isfinite(ms) && ms > 0 ? std::llround(ms * 1e6) : 0; }

struct Span {
    int64_t begin = 0, end = 0;
};

// Names come from hosts and may be no UTF-8.
std::string dump(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

class Writer {
public:
    explicit Writer(std::string& events) : events_(events) {}

    void complete(int track, const std::string& name, const char* category, Span span,
                  ordered_json arguments) {
        add({{"ph", "X"},
             {"name", name},
             {"cat", category},
             {"pid", kProcess},
             {"tid", track},
             {"ts", double(span.begin) / 1000},
             {"dur", double(span.end - span.begin) / 1000},
             {"args", std::move(arguments)}});
    }
    void counter(const char* name, int64_t time, uint64_t value) {
        add({{"ph", "C"},
             {"name", name},
             {"pid", kProcess},
             {"ts", double(time) / 1000},
             {"args", {{"value", value}}}});
    }
    void metadata(const char* name, int track, const char* value) {
        add({{"ph", "M"}, {"name", name}, {"pid", kProcess}, {"tid", track}, {"args", {{"name", value}}}});
    }

private:
    void add(const ordered_json& event) { events_ += ",\n" + dump(event); }
    std::string& events_;
};

ordered_json passArguments(const PassReport& pass) {
    return {{"draws", pass.draws},
            {"triangles", pass.triangles},
            {"gl_calls", pass.glCalls},
            {"state_changes", pass.stateChanges}};
}

double sumOf(const FrameReport& report, double PassReport::* time) {
    double sum = 0;
    for (const PassReport& pass : report.passes) sum += pass.*time;
    return sum;
}

// Sums are rounded, not durations, so that the passes end where their sum does.
void addPasses(Writer& writer, int track, const FrameReport& report, double PassReport::* time,
               int64_t begin) {
    double sum = 0;
    for (const PassReport& pass : report.passes) {
        const double duration = pass.*time;
        const Span span{begin + nanoseconds(sum), begin + nanoseconds(sum + duration)};
        sum += duration;
        if (track == kGpu && duration <= 0) continue;
        writer.complete(track, pass.name, "pass", span, passArguments(pass));
    }
}

ordered_json frameArguments(const FrameReport& report, const FrameTiming& timing) {
    ordered_json arguments = {{"frame", report.frameNumber},
                              {"instances", report.instances},
                              {"visible", report.visible},
                              {"lights_visible", report.lightsVisible},
                              {"uploaded_bytes", report.uploadedBytes},
                              {"waits", report.waits}};
    if (report.executedFrame != report.frameNumber)
        arguments["executed_frame"] = report.executedFrame;
    if (timing.warmUp) arguments["warm_up"] = true;
    return arguments;
}

}  // namespace

void FrameTrace::add(const FrameReport& report, const FrameTiming& timing) {
    Writer writer(events_);
    const std::string name = "frame " + std::to_string(report.frameNumber);
    const double cpuPasses = sumOf(report, &PassReport::cpuMs);
    const Span build{std::max(nanoseconds(timing.beginMs), cpuEnd_),
                     std::max(nanoseconds(timing.beginMs), cpuEnd_) + nanoseconds(report.cpuBuildMs)};
    const Span execute{build.end,
                       build.end + nanoseconds(std::max(report.cpuExecuteMs, cpuPasses))};
    const Span frame{build.begin,
                     std::max(build.begin + nanoseconds(timing.wallMs), execute.end)};
    writer.complete(kCpu, name, "frame", frame, frameArguments(report, timing));
    writer.complete(kCpu, "build", "stage", build, ordered_json::object());
    writer.complete(kCpu, "execute", "stage", execute,
                    {{"gl_calls", report.glCalls}, {"state_changes", report.stateChanges}});
    addPasses(writer, kCpu, report, &PassReport::cpuMs, execute.begin);
    cpuEnd_ = frame.end;

    if (const double gpuPasses = sumOf(report, &PassReport::gpuMs); gpuPasses > 0) {
        const int64_t begin = std::max(execute.begin, gpuEnd_);
        gpuEnd_ = begin + nanoseconds(gpuPasses);
        writer.complete(kGpu, name, "frame", {begin, gpuEnd_}, {{"frame", report.frameNumber}});
        addPasses(writer, kGpu, report, &PassReport::gpuMs, begin);
    }

    writer.counter("draws", frame.begin, report.draws);
    writer.counter("triangles", frame.begin, report.triangles);
    writer.counter("GL calls", frame.begin, report.glCalls);
    writer.counter("allocations", frame.begin, timing.allocations);
    ++frames_;
}

std::string FrameTrace::json(std::string_view device, std::string_view version) const {
    std::string head;
    Writer writer(head);
    writer.metadata("process_name", 0, "rushlight");
    writer.metadata("thread_name", kCpu, "CPU");
    writer.metadata("thread_name", kGpu, "GPU");
    ordered_json about = {{"gl_renderer", std::string(device)},
                          {"gl_version", std::string(version)},
                          {"frames", frames_},
                          {"layout", kLayout}};
    if (!error_.empty()) about["error"] = error_;
    return "{\"displayTimeUnit\": \"ms\",\n\"otherData\": " + dump(about) +
           ",\n\"traceEvents\": [" + head.substr(1) + events_ + "\n]}\n";
}

}  // namespace rushlight
