// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/typed_point.h"

#include "geometry/angle.h"
#include "solver/scene/lookup.h"
#include "solver/scene/units.h"
#include "ui/edit/typed_number.h"

#include <vector>

namespace keyblock {
namespace {

/// The parts of a text between separators outside brackets.
std::vector<std::string_view> partsBetween(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    int depth = 0;
    std::size_t from = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')') --depth;
        if (text[i] != separator || depth != 0) continue;
        parts.push_back(text.substr(from, i - from));
        from = i + 1;
    }
    parts.push_back(text.substr(from));
    return parts;
}

TypedPoint checkedPoint(const Point& place) {
    if (isUsable(place)) return {place, {}};
    return {{}, "The point is too far away: coordinates must be within 1e9 m of the origin."};
}

/// Reads lengths and converts them to metres.
class PointReader {
public:
    PointReader(const TypingContext& context, std::string_view unit) : context_(context), unit_(unit) {}

    TypedPoint read(std::string_view text) const {
        if (text.empty()) return {{}, "Enter the coordinates of a point."};
        const bool relative = text.starts_with("@");
        if (relative) text.remove_prefix(1);
        if (text.find('<') != std::string_view::npos) return polar(text, relative);
        const bool semicolon = text.find(';') != std::string_view::npos;
        const std::vector<std::string_view> parts = partsBetween(text, semicolon ? ';' : ',');
        if (parts.size() == 2) return pair(parts[0], parts[1], relative);
        if (parts.size() == 1 && !relative) return towardsMouse(parts[0]);
        if (parts.size() == 1) return {{}, "Enter two coordinates, as in @2,0, or a length and an angle, as in @3<45."};
        return {{}, "A point has two coordinates, not " + std::to_string(parts.size()) +
                        ". With decimal commas, enter 1,5;2,5."};
    }

private:
    std::optional<double> length(std::string_view text, std::string& problem) const {
        const TypedNumber number = typedNumber(text, unit_);
        problem = number.problem;
        const std::optional<Unit> from = readUnit(unit_);
        if (!number.value || !from) return number.value;
        return converted(*number.value, *from, *readUnit("m"));
    }

    TypedPoint pair(std::string_view x, std::string_view y, bool relative) const {
        std::string problem;
        const auto first = length(x, problem);
        if (!first) return {{}, "x: " + problem};
        const auto second = length(y, problem);
        if (!second) return {{}, "y: " + problem};
        if (!relative) return checkedPoint({*first, *second});
        if (!context_.previous) return {{}, noPrevious()};
        return checkedPoint(*context_.previous + Point(*first, *second));
    }

    TypedPoint polar(std::string_view text, bool relative) const {
        const std::vector<std::string_view> parts = partsBetween(text, '<');
        if (parts.size() != 2) return {{}, "Enter a length and an angle, as in @3<45."};
        if (!relative) return {{}, "Start with @ for a position relative to the last point: @" + std::string(text) + "."};
        if (!context_.previous) return {{}, noPrevious()};
        std::string problem;
        const auto distance = length(parts[0], problem);
        if (!distance) return {{}, "length: " + problem};
        const TypedNumber angle = typedNumber(parts[1], "°");
        if (!angle.value) return {{}, "angle: " + angle.problem};
        return checkedPoint(*context_.previous + *distance * directionOf(*angle.value));
    }

    TypedPoint towardsMouse(std::string_view text) const {
        std::string problem;
        const auto distance = length(text, problem);
        if (!distance) return {{}, problem};
        if (!context_.previous) return {{}, "Enter x and y, as in 12.5,3: there is no previous point yet."};
        const Point way = context_.mouse - *context_.previous;
        if (!(way.norm() > 0.0)) return {{}, "Move the mouse in the direction of the next point, or enter x and y."};
        return checkedPoint(*context_.previous + *distance * way.normalized());
    }

    static std::string noPrevious() { return "There is no previous point yet. Enter x and y, as in 12.5,3."; }

    const TypingContext& context_;
    std::string_view unit_;
};

}  // namespace

TypedPoint typedPoint(std::string_view text, const TypingContext& context, std::string_view unit) {
    const std::string plain = plainNumberText(text);
    return PointReader(context, unit).read(plain);
}

}  // namespace keyblock
