#include "sandbox/viewer/input_script.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace rushlight {
namespace {

constexpr uint32_t kMaxFrame = 10'000'000;

constexpr std::array kNamedKeys{
    std::pair{"escape", Key::escape}, std::pair{"tab", Key::tab},
    std::pair{"enter", Key::enter},   std::pair{"space", Key::space},
    std::pair{"shift", Key::shift},   std::pair{"backspace", Key::backspace},
    std::pair{"left", Key::left},     std::pair{"right", Key::right},
    std::pair{"up", Key::up},         std::pair{"down", Key::down}};

}  // namespace

const char* const kWalkDemo =
    "0 press w\n"
    "0 turn 90 2 0\n"
    "120 turn 120 -4 0\n"
    "150 tap e\n"
    "240 press shift\n"
    "300 turn 90 5 0.3\n"
    "360 release shift\n"
    "420 turn 60 -3 -0.4\n"
    "480 release w\n"
    "480 turn 120 6 0\n";

Key keyNamed(std::string_view name) {
    if (name.size() == 1) {
        if (name[0] >= 'a' && name[0] <= 'z') return keyOffset(Key::a, name[0] - 'a');
        if (name[0] >= '0' && name[0] <= '9') return keyOffset(Key::digit0, name[0] - '0');
    }
    if (name.size() > 1 && name[0] == 'f') {
        int number = 0;
        const char* end = name.data() + name.size();
        const auto [rest, error] = std::from_chars(name.data() + 1, end, number);
        if (error == std::errc() && rest == end && number >= 1 && number <= 12)
            return keyOffset(Key::f1, number - 1);
    }
    for (const auto& [text, key] : kNamedKeys)
        if (name == text) return key;
    return Key::none;
}

Result<InputScript::Event> InputScript::parseLine(const std::string& object,
                                                  std::string_view line) {
    std::istringstream words{std::string(line)};
    Event event;
    std::string command;
    int64_t frame = -1;
    if (!(words >> frame >> command) || frame < 0 || frame > kMaxFrame)
        return fail(object, "A line is 'FRAME COMMAND ARGUMENTS' with a frame from 0 to " +
                                std::to_string(kMaxFrame) + ".");
    event.frame = uint32_t(frame);
    bool complete = true;
    if (command == "press" || command == "release" || command == "tap") {
        std::string key;
        words >> key;
        event.key = keyNamed(key);
        event.action = command == "press"     ? Action::press
                       : command == "release" ? Action::release
                                              : Action::tap;
        if (event.key == Key::none) return fail(object, "'" + key + "' is no key.");
    } else if (command == "look" || command == "turn") {
        event.action = Action::move;
        if (command == "turn") complete = bool(words >> event.frames);
        complete = complete && (words >> event.amount.x >> event.amount.y) && event.frames > 0 &&
                   event.frames <= kMaxFrame;
    } else if (command == "scroll") {
        event.action = Action::scroll;
        complete = bool(words >> event.amount.x);
    } else {
        return fail(object, "'" + command +
                                "' is no command; there are press, release, tap, look, turn and "
                                "scroll.");
    }
    std::string surplus;
    if (!complete || words >> surplus)
        return fail(object, "The arguments of '" + command + "' are wrong; see sandbox --help.");
    return event;
}

Result<InputScript> InputScript::parse(const std::string& name, std::string_view text) {
    InputScript script;
    uint32_t number = 0;
    while (!text.empty()) {
        const size_t length = std::min(text.find('\n'), text.size());
        const std::string_view whole = text.substr(0, length);
        const std::string_view line = whole.substr(0, whole.find('#'));
        text.remove_prefix(std::min(length + 1, text.size()));
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        const std::string object = name + ":" + std::to_string(number);
        auto event = parseLine(object, line);
        if (!event) return tl::unexpected(event.error());
        if (!script.events_.empty() && event->frame < script.events_.back().frame)
            return fail(object, "Frames must not decrease: " + std::to_string(event->frame) +
                                    " follows " + std::to_string(script.events_.back().frame) +
                                    ".");
        script.lastFrame_ = std::max(script.lastFrame_, event->frame + event->frames - 1);
        script.events_.push_back(*event);
    }
    return script;
}

Result<InputScript> InputScript::load(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return fail(path, "The script cannot be opened for reading.");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return parse(path, text);
}

void InputScript::play(uint32_t frame, InputState& input) {
    if (frame == 0) input.mouseMovedTo(mouse_);
    for (const Event& event : events_) {
        if (event.frame > frame) break;
        if (event.action == Action::move && frame - event.frame < event.frames) {
            mouse_ += event.amount;
            input.mouseMovedTo(mouse_);
        }
        if (event.frame != frame) continue;
        if (event.action == Action::scroll) input.scrolled(event.amount.x);
        if (event.action == Action::press || event.action == Action::tap)
            input.key(event.key, true);
        if (event.action == Action::release || event.action == Action::tap)
            input.key(event.key, false);
    }
}

}  // namespace rushlight
