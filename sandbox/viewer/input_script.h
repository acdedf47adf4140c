#pragma once
// A player made of text, for tests and for the demo walk: the same keys at the same frames every
// time.

#include "engine/core/result.h"
#include "engine/input/input.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rushlight {

/// One command a line, `FRAME COMMAND ARGUMENTS`, frames in increasing order, # begins a comment:
///
///     0   press w            hold a key (a-z, 0-9, f1-f12, tab, shift, escape, …)
///     90  release w
///     10  tap tab            press and release
///     20  look 40 -5         mouse movement in pixels, right and down
///     20  turn 60 2.5 0      the same movement in each of the next 60 frames
///     30  scroll 1
class InputScript {
public:
    /// `name` is for messages.
    static Result<InputScript> parse(const std::string& name, std::string_view text);
    static Result<InputScript> load(const std::string& path);

    /// Feeds what happens in this frame; call after InputState::beginFrame(), frames counted from
    /// 0.
    void play(uint32_t frame, InputState& input);
    /// After this frame nothing happens any more.
    uint32_t lastFrame() const { return lastFrame_; }

private:
    enum class Action : uint8_t { press, release, tap, move, scroll };
    struct Event {
        uint32_t frame = 0;
        uint32_t frames = 1;  ///< of a movement
        Action action = Action::tap;
        Key key = Key::none;
        vec2 amount{0};
    };
    static Result<Event> parseLine(const std::string& object, std::string_view line);

    std::vector<Event> events_;
    vec2 mouse_{0};
    uint32_t lastFrame_ = 0;
};

/// Null (Key::none) for a name that is no key.
Key keyNamed(std::string_view name);

/// Once around: what --walk-demo plays.
extern const char* const kWalkDemo;

}  // namespace rushlight
