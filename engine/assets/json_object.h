#pragma once

#include "engine/assets/input_error.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace rushlight::assets {

using Json = nlohmann::json;

enum class Need : uint8_t { optional, required };

/// A JSON object of a glTF file with the name that messages give it. Every method checks one
/// property and throws InputError when it breaks the rule; an absent optional property passes.
class JsonObject {
public:
    JsonObject(const Json& json, std::string what);

    const std::string& what() const { return what_; }
    const Json& json() const { return json_; }
    bool has(const char* key) const { return json_.contains(key); }
    [[noreturn]] void wrong(const std::string& problem) const { refuse(what_ + ": " + problem); }

    void text(const char* key, Need need = Need::optional) const;
    void boolean(const char* key) const;
    void oneOf(const char* key, std::initializer_list<std::string_view> allowed,
               Need need = Need::optional) const;
    void oneOf(const char* key, std::initializer_list<int64_t> allowed,
               Need need = Need::optional) const;

    int64_t integer(const char* key, int64_t low, int64_t high, Need need,
                    int64_t fallback = 0) const;
    double number(const char* key, double low, double high, Need need = Need::optional,
                  double fallback = 0) const;

    /// An index below `count`; -1 when absent.
    int64_t index(const char* key, size_t count, Need need = Need::optional) const;
    /// Distinct indices below `count`; not empty when present.
    void indices(const char* key, size_t count, Need need = Need::optional) const;
    /// Numbers of the range; `size` 0 allows any length but none.
    void numbers(const char* key, size_t size, double low, double high) const;

    /// The array, or null. InputError when it is no array or empty.
    const Json* array(const char* key, Need need = Need::optional) const;
    /// The object, or null.
    const Json* object(const char* key, Need need = Need::optional) const;

private:
    const Json* find(const char* key, Need need) const;

    const Json& json_;
    std::string what_;
};

/// The name of element `i` of an array: "mesh 3 'roof'".
std::string nameOf(const char* kind, size_t i, const Json& json);

}  // namespace rushlight::assets
