#pragma once
// Commands whose bytes come from outside.

#include "engine/core/result.h"
#include "renderer/rhi/commands/command_buffer.h"
#include "renderer/rhi/commands/command_fields.h"

namespace rushlight {

/// Whether `bytes` are whole commands of known types with known enumerations, so that visitCommands
/// and print are safe. What they name is CommandValidator's to check. The Error gives `object` and
/// the number of the command, from 1.
Result<void> checkCommandStream(std::span<const std::byte> bytes, const std::string& object);

/// Appends every command of `from` to `to` after `change(command)`, which may change it, and copies
/// the data block.
template <class Change>
void translateCommands(const CommandBuffer& from, CommandBuffer& to, Change&& change) {
    visitCommands(from, [&](const auto& command) {
        auto copy = command;
        change(copy);
        to.push(copy);
    });
    to.append(from.data());
}

/// `map(handle)` in place of every handle that is not zero.
template <class Command, class Map>
void mapHandles(Command& command, Map&& map) {
    visitFields(command, [&]<class Field>(const char*, Field& field) {
        if constexpr (isHandle<Field>)
            if (field) field = map(field);
    });
}

}  // namespace rushlight
