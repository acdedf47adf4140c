#include "engine/assets/json_object.h"

#include <cmath>
#include <set>

namespace rushlight::assets {

JsonObject::JsonObject(const Json& json, std::string what) : json_(json), what_(std::move(what)) {
    if (!json.is_object()) wrong("it is not a JSON object.");
    if (const Json* extensions = object("extensions"))
        for (const auto& [name, extension] : extensions->items())
            if (!extension.is_object()) wrong("its extension " + name + " is not an object.");
    text("name");
}

const Json* JsonObject::find(const char* key, Need need) const {
    const auto it = json_.find(key);
    if (it != json_.end()) return &*it;
    if (need == Need::required) wrong(std::string("it has no ") + key + ", which is required.");
    return nullptr;
}

void JsonObject::text(const char* key, Need need) const {
    const Json* value = find(key, need);
    if (value && !value->is_string()) wrong(std::string("its ") + key + " is not a string.");
}

void JsonObject::boolean(const char* key) const {
    const Json* value = find(key, Need::optional);
    if (value && !value->is_boolean())
        wrong(std::string("its ") + key + " is neither true nor false.");
}

void JsonObject::oneOf(const char* key, std::initializer_list<std::string_view> allowed,
                       Need need) const {
    text(key, need);
    const Json* value = find(key, need);
    if (!value) return;
    for (std::string_view one : allowed)
        if (value->get_ref<const std::string&>() == one) return;
    wrong(std::string("its ") + key + " is '" + value->get<std::string>() +
          "', which glTF 2.0 does not know.");
}

void JsonObject::oneOf(const char* key, std::initializer_list<int64_t> allowed, Need need) const {
    const Json* value = find(key, need);
    if (!value) return;
    for (int64_t one : allowed)
        if (value->is_number_integer() && *value == one) return;
    wrong(std::string("its ") + key + " is " + value->dump() + ", which glTF 2.0 does not know.");
}

int64_t JsonObject::integer(const char* key, int64_t low, int64_t high, Need need,
                            int64_t fallback) const {
    const Json* value = find(key, need);
    if (!value) return fallback;
    if (!value->is_number_integer()) wrong(std::string("its ") + key + " is not an integer.");
    const bool huge = value->is_number_unsigned() && value->get<uint64_t>() > uint64_t(INT64_MAX);
    const int64_t number = huge ? INT64_MAX : value->get<int64_t>();
    if (huge || number < low || number > high)
        wrong(std::string("its ") + key + " is " + value->dump() + ", which is not from " +
              std::to_string(low) + " to " + std::to_string(high) + ".");
    return number;
}

double JsonObject::number(const char* key, double low, double high, Need need,
                          double fallback) const {
    const Json* value = find(key, need);
    if (!value) return fallback;
    if (!value->is_number()) wrong(std::string("its ") + key + " is not a number.");
    const double number = value->get<double>();
    if (!(number >= low && number <= high) || !std::isfinite(float(number)))
        wrong(std::string("its ") + key + " is " + value->dump() + ", which is out of range.");
    return number;
}

int64_t JsonObject::index(const char* key, size_t count, Need need) const {
    const Json* value = find(key, need);
    if (!value) return -1;
    const int64_t i = integer(key, 0, INT32_MAX, need);
    if (uint64_t(i) >= count)
        wrong(std::string("its ") + key + " is " + std::to_string(i) + " but there are only " +
              std::to_string(count) + ".");
    return i;
}

void JsonObject::indices(const char* key, size_t count, Need need) const {
    const Json* values = array(key, need);
    if (!values) return;
    std::set<int64_t> seen;
    for (const Json& value : *values) {
        if (!value.is_number_unsigned() || value.get<uint64_t>() >= count)
            wrong(std::string("its ") + key + " contain " + value.dump() + " but there are only " +
                  std::to_string(count) + ".");
        if (!seen.insert(value.get<int64_t>()).second)
            wrong(std::string("its ") + key + " contain " + value.dump() + " twice.");
    }
}

void JsonObject::numbers(const char* key, size_t size, double low, double high) const {
    const Json* values = array(key);
    if (!values) return;
    if (size != 0 && values->size() != size)
        wrong(std::string("its ") + key + " has " + std::to_string(values->size()) +
              " elements instead of " + std::to_string(size) + ".");
    for (const Json& value : *values) {
        const double number = value.is_number() ? value.get<double>() : NAN;
        if (!(number >= low && number <= high) || !std::isfinite(float(number)))
            wrong(std::string("its ") + key + " contains " + value.dump() +
                  ", which is out of range.");
    }
}

const Json* JsonObject::array(const char* key, Need need) const {
    const Json* value = find(key, need);
    if (!value) return nullptr;
    if (!value->is_array()) wrong(std::string("its ") + key + " is not an array.");
    if (value->empty()) wrong(std::string("its ") + key + " is an empty array.");
    return value;
}

const Json* JsonObject::object(const char* key, Need need) const {
    const Json* value = find(key, need);
    if (value && !value->is_object()) wrong(std::string("its ") + key + " is not an object.");
    return value;
}

std::string nameOf(const char* kind, size_t i, const Json& json) {
    const bool named = json.is_object() && json.contains("name") && json["name"].is_string();
    return numbered(kind, i, named ? json["name"].get<std::string>() : std::string());
}

}  // namespace rushlight::assets
