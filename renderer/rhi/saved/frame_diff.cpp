#include "renderer/rhi/saved/frame_diff.h"

#include "engine/core/quoted.h"
#include "renderer/rhi/commands/command_fields.h"

#include <algorithm>
#include <charconv>

namespace rushlight {
namespace {

template <class Field>
std::string valueText(const Field& field) {
    if constexpr (std::is_array_v<Field>) {
        return quoted(field);
    } else if constexpr (std::is_same_v<Field, Format>) {
        return toText(field);
    } else if constexpr (std::is_same_v<Field, LoadOp>) {
        return field == LoadOp::keep ? "keep" : field == LoadOp::clear ? "clear" : "discard";
    } else if constexpr (isHandle<Field>) {
        return std::to_string(field.value);
    } else if constexpr (std::is_floating_point_v<Field>) {
        char text[32];
        return std::string(text, std::to_chars(text, text + sizeof text, field).ptr);
    } else {
        return std::to_string(field);
    }
}

/// A command as text to compare and to show: its fields by name.
struct Step {
    const char* command = "";
    std::string pass;
    std::vector<std::pair<std::string, std::string>> fields;
    std::vector<BufferRange> reads;  ///< of the data block
};

/// All commands of a frame.
class Steps {
public:
    explicit Steps(const SavedFrame& frame) : frame_(frame) {
        visitCommands(frame.commands, [&](const auto& command) { add(command); });
    }
    std::vector<Step> list;

private:
    template <class Command>
    void add(const Command& command) {
        if constexpr (std::is_same_v<Command, BeginPass>) pass_ = command.name;
        Step& step = list.emplace_back();
        step.command = toText(Command::kType);
        step.pass = pass_;
        visitFields(command, [&]<class Field>(const char* name, const Field& field) {
            std::string text = valueText(field);
            if constexpr (isHandle<Field>)
                if (const auto known = frame_.describe(field); known) text += label(*known);
            step.fields.emplace_back(name, std::move(text));
        });
        if constexpr (requires { command.range; }) addRead(step, command.range);
        if constexpr (std::is_same_v<Command, MultiDrawIndexed>) addRead(step, command.commands);
        if constexpr (std::is_same_v<Command, EndPass>) pass_.clear();
    }
    template <class Desc>
    static std::string label(const Desc& desc) {
        if constexpr (requires { desc.label; })
            return std::string(1, ' ') += quoted(desc.label);
        else
            return {};
    }
    static void addRead(Step& step, const BufferRange& range) {
        if (!range.buffer && range.size) step.reads.push_back(range);
    }

    const SavedFrame& frame_;
    std::string pass_;
};

std::string place(const Step& step, size_t index) {
    std::string text = "command " + std::to_string(index + 1) + " " + step.command;
    if (!step.pass.empty()) text += " in pass '" + step.pass + "'";
    return text;
}

class Diff {
public:
    Diff(const SavedFrame& a, const SavedFrame& b) : a_(a), b_(b), stepsA_(a), stepsB_(b) {}

    std::vector<std::string> lines;

    void run() {
        compareTargets();
        compareCommands();
        compareData();
        compareLists("texture", a_.textures, b_.textures);
        compareLists("buffer", a_.buffers, b_.buffers);
        compareLists("pipeline", a_.pipelines, b_.pipelines);
        if (a_.samplers != b_.samplers) lines.push_back("the samplers differ");
    }

private:
    template <class A, class B>
    void differ(const std::string& what, const A& a, const B& b) {
        lines.push_back(what + ": " + a + " | " + b);
    }
    void compareTargets() {
        const auto text = [](const FrameTarget& t) {
            return std::to_string(t.width) + "x" + std::to_string(t.height) +
                   (t.topRowFirst ? " from the top" : "");
        };
        if (text(a_.target) != text(b_.target))
            differ("frame target", text(a_.target), text(b_.target));
    }

    void compareCommands() {
        const auto& a = stepsA_.list;
        const auto& b = stepsB_.list;
        const size_t both = std::min(a.size(), b.size());
        for (size_t i = 0; i < both; ++i) {
            if (std::string_view(a[i].command) != b[i].command)
                return differ(place(a[i], i), a[i].command, place(b[i], i));
            const auto [fieldA, fieldB] = std::ranges::mismatch(a[i].fields, b[i].fields);
            if (fieldA != a[i].fields.end())
                return differ(place(a[i], i) + ", " + fieldA->first, fieldA->second,
                              fieldB->second);
        }
        if (a.size() != b.size())
            differ("number of commands", std::to_string(a.size()), std::to_string(b.size()));
    }

    void compareData() {
        const auto a = a_.commands.data(), b = b_.commands.data();
        const size_t at = size_t(std::ranges::mismatch(a, b).in1 - a.begin());
        if (at == a.size() && at == b.size()) return;
        std::string line = "data block: differs from byte " + std::to_string(at) + " on";
        if (a.size() != b.size())
            line += ", " + std::to_string(a.size()) + " | " + std::to_string(b.size()) + " bytes";
        const auto& steps = stepsA_.list;
        for (size_t i = 0; i < steps.size(); ++i)
            for (const BufferRange& range : steps[i].reads)
                if (at >= range.offset && at < range.offset + range.size) {
                    lines.push_back(line + "; first read by " + place(steps[i], i));
                    return;
                }
        lines.push_back(line);
    }

    template <class T>
    void compareLists(const char* what, const std::vector<T>& a, const std::vector<T>& b) {
        if (a.size() != b.size())
            differ(std::string("number of ") + what + "s", std::to_string(a.size()),
                   std::to_string(b.size()));
        for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
            place_ = std::string(what) + " " + std::to_string(i + 1) + " " + quoted(a[i].label);
            if (a[i].label != b[i].label)
                differ(place_, a[i].label, b[i].label);
            else
                compare(a[i], b[i]);
        }
    }

    bool same(uint32_t a, uint32_t b) const {
        if (!a || !b) return !a && !b;
        return a_.blobs.hash(a) == b_.blobs.hash(b);
    }
    void compare(const SavedTexture& a, const SavedTexture& b) {
        const auto shape = [](const TextureDesc& d) {
            return std::string(toText(d.format)) + " " + std::to_string(d.width) + "x" +
                   std::to_string(d.height) + ", " + std::to_string(d.layers) + " layers, " +
                   std::to_string(d.mipLevels) + " mip levels, kind " + std::to_string(int(d.kind));
        };
        if (shape(a.desc) != shape(b.desc)) return differ(place_, shape(a.desc), shape(b.desc));
        for (size_t i = 0; i < a.contents.size(); ++i)
            if (!same(a.contents[i], b.contents[i])) {
                lines.push_back(place_ + ": its contents differ in layer " +
                                std::to_string(i % a.desc.layers) + " of mip level " +
                                std::to_string(i / a.desc.layers));
                return;
            }
    }
    void compare(const SavedBuffer& a, const SavedBuffer& b) {
        if (a.size != b.size || a.usage != b.usage)
            return differ(place_, std::to_string(a.size) + " bytes", std::to_string(b.size));
        if (same(a.contents, b.contents)) return;
        const auto bytesA = a_.blobs.bytes(a.contents), bytesB = b_.blobs.bytes(b.contents);
        const auto at = std::ranges::mismatch(bytesA, bytesB).in1 - bytesA.begin();
        lines.push_back(place_ + ": its contents differ from byte " + std::to_string(at) + " on");
    }
    void compare(const SavedPipeline& a, const SavedPipeline& b) {
        const auto state = [](const SavedPipeline& p) {
            const PipelineDesc& d = p.desc;
            const int values[] = {int(d.layout),    d.movingInstances, int(d.cull),  d.depthClamp,
                                  int(d.depthTest), d.depthWrite,      int(d.blend), d.lines};
            std::string text = p.vertexShader + " " + p.fragmentShader + " state";
            for (const int value : values) (text += ' ') += std::to_string(value);
            return text + " " + valueText(d.depthBias) + " " + valueText(d.depthBiasSlope);
        };
        if (state(a) != state(b)) differ(place_, state(a), state(b));
        compareSources(a.vertexShader, a.vertexSource, b.vertexSource);
        compareSources(a.fragmentShader, a.fragmentSource, b.fragmentSource);
    }
    void compareSources(const std::string& name, uint32_t a, uint32_t b) {
        if (same(a, b)) return;
        if (!a || !b) {
            lines.push_back(place_ + ": only one has the source of " + name);
            return;
        }
        const auto bytesA = a_.blobs.bytes(a), bytesB = b_.blobs.bytes(b);
        const auto end = std::ranges::mismatch(bytesA, bytesB).in1;
        const auto line = std::count(bytesA.begin(), end, std::byte('\n')) + 1;
        lines.push_back(place_ + ": the source of " + name + " differs from line " +
                        std::to_string(line) + " on");
    }

    const SavedFrame& a_;
    const SavedFrame& b_;
    Steps stepsA_, stepsB_;
    std::string place_;
};

}  // namespace

std::vector<std::string> diffFrames(const SavedFrame& a, const SavedFrame& b) {
    Diff diff(a, b);
    diff.run();
    return std::move(diff.lines);
}

}  // namespace rushlight
