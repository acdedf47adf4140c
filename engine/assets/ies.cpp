#include "engine/assets/ies.h"

#include "engine/assets/gltf/gltf_file.h"
#include "engine/assets/ies_planes.h"
#include "engine/assets/input_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rushlight::assets {
namespace {

constexpr uint64_t kMaxBytes = 8u << 20;
constexpr double kMaxAngles = 2048;
constexpr double kMaxValues = 1u << 20;

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v' || c == ',';
}

/// Lines at the head of the file, then numbers that lines may break anywhere.
class IesText {
public:
    explicit IesText(std::string_view text) : left_(text) {}

    bool atEnd() const { return left_.empty(); }
    std::string_view line() {
        const size_t end = std::min(left_.find('\n'), left_.size());
        std::string_view found = left_.substr(0, end);
        left_.remove_prefix(std::min(end + 1, left_.size()));
        while (!found.empty() && isBlank(found.back())) found.remove_suffix(1);
        while (!found.empty() && isBlank(found.front())) found.remove_prefix(1);
        return found;
    }
    double number(const char* what) {
        const std::string_view word = next();
        if (word.empty()) refuse(std::string("the file ends before its ") + what + ".");
        double value = 0;
        const char* begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
        const char* end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error != std::errc() || stop != end || !std::isfinite(value))
            refuse("'" + std::string(word.substr(0, 40)) + "' stands where its " + what +
                   " is expected, which is no number.");
        return value;
    }
    /// A whole one within limits.
    size_t count(const char* what, double least, double most) {
        const double value = number(what);
        if (value != std::floor(value) || value < least || value > most)
            refuse(std::string("its ") + what + " is " + std::to_string(value) +
                   "; whole numbers from " + std::to_string(int64_t(least)) + " to " +
                   std::to_string(int64_t(most)) + " are possible.");
        return size_t(value);
    }
    /// What follows the last number; files of the time end with control-Z.
    std::string_view rest() {
        std::string_view word = next();
        return word == "\x1a" ? std::string_view() : word;
    }

private:
    std::string_view next() {
        while (!left_.empty() && isBlank(left_.front())) left_.remove_prefix(1);
        size_t end = 0;
        while (end < left_.size() && !isBlank(left_[end])) ++end;
        const std::string_view word = left_.substr(0, end);
        left_.remove_prefix(end);
        return word;
    }

    std::string_view left_;
};

/// What stands after "TILT=". Keywords and, in 1986, free text come before it.
std::string_view findTilt(IesText& text) {
    while (!text.atEnd()) {
        const std::string_view line = text.line();
        if (line.substr(0, 5) == "TILT=") return line.substr(5);
    }
    refuse("it has no line that begins with TILT=: this is no IESNA LM-63 file.");
}

void skipTilt(IesText& text, std::string_view tilt) {
    if (tilt == "NONE") return;
    if (tilt != "INCLUDE")
        refuse("its TILT is '" + std::string(tilt.substr(0, 60)) +
               "'; NONE and INCLUDE can be read, other files cannot be referred to.");
    text.count("lamp-to-luminaire geometry", 1, 3);
    const size_t angles = text.count("number of tilt angles", 0, kMaxAngles);
    for (size_t i = 0; i < 2 * angles; ++i) text.number("tilt factors");
}

std::vector<float> readAngles(IesText& text, size_t count, const char* what, double least,
                              double most) {
    std::vector<float> angles;
    for (size_t i = 0; i < count; ++i) {
        const double angle = text.number(what);
        if (angle < least || angle > most || (i > 0 && float(angle) <= angles.back()))
            refuse(std::string("among its ") + what + " is " + std::to_string(angle) +
                   "; they must increase within " + std::to_string(int(least)) + " and " +
                   std::to_string(int(most)) + " degrees.");
        angles.push_back(float(angle));
    }
    return angles;
}

void checkHorizontal(const std::vector<float>& angles) {
    const float first = angles.front(), last = angles.back();
    if (first == 0 && (last == 0 || last == 90 || last == 180 || last == 360)) return;
    if (first == 90 && last == 270) return;
    refuse("its horizontal angles reach from " + std::to_string(first) + " to " +
           std::to_string(last) +
           " degrees; type C has 0 alone, 0 to 90, 0 to 180, 0 to 360 or 90 to 270.");
}

// LM-63-2002, of both kinds of angles of types A and B.
void checkReach(const std::vector<float>& angles, const char* what) {
    if ((angles.front() == -90 || angles.front() == 0) && angles.back() == 90) return;
    refuse("its " + std::string(what) + " reach from " + std::to_string(angles.front()) + " to " +
           std::to_string(angles.back()) + " degrees; types A and B have -90 to 90 or 0 to 90.");
}

void readAllAngles(IesText& text, IesPlanes planes, size_t verticals, size_t horizontals,
                   LightProfile& profile) {
    const bool isC = planes == IesPlanes::c;
    profile.verticalAngles = readAngles(text, verticals, "vertical angles", isC ? 0 : -90,
                                        isC ? 180 : 90);
    profile.horizontalAngles = readAngles(text, horizontals, "horizontal angles", isC ? 0 : -90,
                                          isC ? 360 : 90);
    if (isC) return checkHorizontal(profile.horizontalAngles);
    checkReach(profile.verticalAngles, "vertical angles");
    checkReach(profile.horizontalAngles, "horizontal angles");
}

LightProfile parse(std::string_view name, std::string_view bytes) {
    if (bytes.size() > kMaxBytes)
        refuse("it has " + std::to_string(bytes.size()) + " bytes; the limit is " +
               std::to_string(kMaxBytes) + ".");
    IesText text(bytes);
    skipTilt(text, findTilt(text));
    LightProfile profile;
    profile.name = name;
    text.number("number of lamps");
    text.number("lumens per lamp");
    double scale = text.number("candela multiplier");
    const size_t verticals = text.count("number of vertical angles", 2, kMaxAngles);
    const size_t horizontals = text.count("number of horizontal angles", 1, kMaxAngles);
    if (double(verticals) * double(horizontals) > kMaxValues)
        refuse("it has " + std::to_string(verticals) + " by " + std::to_string(horizontals) +
               " values of candela; the limit is " + std::to_string(int(kMaxValues)) + ".");
    const IesPlanes planes{int(text.count("photometric type", 1, 3))};
    text.count("units type", 1, 2);
    for (const char* size : {"luminous width", "luminous length", "luminous height"})
        text.number(size);
    scale *= text.number("ballast factor");
    text.number("ballast-lamp photometric factor");
    text.number("input watts");
    if (!(scale > 0) || !std::isfinite(scale))
        refuse("its candela multiplier times its ballast factor is " + std::to_string(scale) +
               "; it must be over 0.");
    readAllAngles(text, planes, verticals, horizontals, profile);
    for (size_t i = 0; i < verticals * horizontals; ++i) {
        const double candela = text.number("values of candela") * scale;
        if (!(candela >= 0) || candela > 1e12)
            refuse("a value of candela is " + std::to_string(candela) +
                   "; 0 to 1e12 are possible.");
        profile.candela.push_back(float(candela));
        profile.largestCandela = std::max(profile.largestCandela, float(candela));
    }
    if (!(profile.largestCandela > 0)) refuse("all its values of candela are 0.");
    if (const std::string_view rest = text.rest(); !rest.empty())
        refuse("'" + std::string(rest.substr(0, 40)) + "' follows its last value of candela.");
    return asTypeC(profile, planes);
}

}  // namespace

Result<LightProfile> parseIes(std::string_view name, std::string_view text) {
    try {
        return parse(name, text);
    } catch (const InputError& error) {
        return fail(std::string(name), error.message);
    }
}

Result<LightProfile> loadIes(const std::filesystem::path& path) {
    try {
        const Bytes bytes = readFile(path, kMaxBytes);
        return parseIes(path.filename().string(),
                        {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const InputError& error) {
        return fail(path.string(), error.message);
    }
}

bool hasTiltFactors(std::string_view text) {
    IesText lines(text);
    return findTilt(lines) == "INCLUDE";
}

// Candela is linear between the angles: over a cell, its mean at the corners with the exact solid
// angle of each half.
double luminousFlux(const LightProfile& profile) {
    const std::vector<float>&v = profile.verticalAngles, &h = profile.horizontalAngles;
    const auto radians = [](float angle) { return double(angle) * double(kPi) / 180; };
    // Of a strip between two vertical angles of one horizontal one: integral of candela times sine.
    const auto meridian = [&](size_t row) {
        double sum = 0;
        for (size_t i = 1; i < v.size(); ++i) {
            const double a = radians(v[i - 1]), b = radians(v[i]);
            const double low = double(profile.candela[row * v.size() + i - 1]);
            const double slope = (double(profile.candela[row * v.size() + i]) - low) / (b - a);
            sum += low * (std::cos(a) - std::cos(b)) +
                   slope * (std::sin(b) - std::sin(a) - (b - a) * std::cos(b));
        }
        return sum;
    };
    if (h.size() == 1) return meridian(0) * 2 * double(kPi);
    double sum = 0;
    for (size_t i = 1; i < h.size(); ++i)
        sum += (meridian(i - 1) + meridian(i)) / 2 * (radians(h[i]) - radians(h[i - 1]));
    return sum * 360 / double(h.back() - h.front());
}

}  // namespace rushlight::assets
