// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names in a scene are free text, so a quantity cannot simply be split at every
// space or dot. The words before the name are fixed, and the longest known name
// that matches the rest is used.
#include "solver/scene/quantity_text.h"

#include <algorithm>
#include <utility>

namespace keyblock {

namespace {

/// A first word, and what follows it.
struct FirstWord {
    std::string_view word;
    QuantityKind kind;
    bool takesEvent = false, takesSubject = false;
};

constexpr std::array firstWords{FirstWord{"max", QuantityKind::Max, false, true},
                                FirstWord{"min", QuantityKind::Min, false, true},
                                FirstWord{"last", QuantityKind::Last, false, true},
                                FirstWord{"first", QuantityKind::First, true, true},
                                FirstWord{"count", QuantityKind::Count, true, false},
                                FirstWord{"order", QuantityKind::Order, true, false},
                                FirstWord{"energy_error", QuantityKind::EnergyError},
                                FirstWord{"factor_of_safety", QuantityKind::FactorOfSafety},
                                FirstWord{"stands", QuantityKind::Stands}};
constexpr std::array<std::string_view, 3> pointParts{"ux", "uy", "u"};  // by `Subject::component`

std::string_view withoutSpaces(std::string_view text) {
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Removes the first word of `text` and returns it.
std::string_view takeWord(std::string_view& text) {
    const auto end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text = withoutSpaces(text.substr(end));
    return word;
}

template <typename Range, typename Name>
std::string listed(const Range& range, Name name) {
    std::string text;
    for (const auto& item : range) {
        text += text.empty() ? "" : ", ";
        text += name(item);
    }
    return text.empty() ? "none" : text;
}

/// Keys of the rows of a table, separated by commas.
template <typename Rows>
std::string listedKeys(const Rows& rows) {
    return listed(rows, [](const auto& row) { return std::string(row.key); });
}

template <typename Rows>
int indexOfKey(const Rows& rows, std::string_view key) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.key == key; });
    return found == rows.end() ? -1 : static_cast<int>(found - rows.begin());
}

template <typename Named>
int indexNamed(const std::vector<Named>& items, std::string_view name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Named& item) { return item.name == name; });
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

struct SubjectReading {
    std::optional<Subject> subject;
    std::string problem;
};

SubjectReading wholeMonitor(int monitor, const Scene& scene) {
    const std::string& name = scene.monitors[monitor].name;
    if (monitorValueCount(scene.monitors[monitor]) > 1)
        return {{},
                "monitor '" + name + "' is a point: write '" + name + ".ux', '" + name + ".uy' or '" + name + ".u'"};
    return {Subject{.monitor = monitor}, ""};
}

SubjectReading monitorPart(int monitor, std::string_view part, const Scene& scene) {
    const std::string& name = scene.monitors[monitor].name;
    if (monitorValueCount(scene.monitors[monitor]) == 1)
        return {{}, "monitor '" + name + "' has one value: omit '." + std::string(part) + "'"};
    const auto found = std::find(pointParts.begin(), pointParts.end(), part);
    if (found == pointParts.end())
        return {{}, "monitor '" + name + "' has no '" + std::string(part) + "': write '.ux', '.uy' or '.u'"};
    return {Subject{.monitor = monitor, .component = static_cast<int>(found - pointParts.begin())}, ""};
}

SubjectReading boltPart(int bolt, std::string_view part, const Scene& scene) {
    const int quantity = indexOfKey(boltQuantityRows, part);
    if (quantity < 0)
        return {{}, "bolt '" + scene.bolts[bolt].name + "' has no quantity '" + std::string(part) + "': write one of " +
                        listedKeys(boltQuantityRows)};
    return {Subject{.bolt = bolt, .boltQuantity = static_cast<BoltQuantity>(quantity)}, ""};
}

SubjectReading unknownSubject(std::string_view name, const Scene& scene) {
    const auto nameOf = [](const auto& item) { return item.name; };
    return {{}, "'" + std::string(name) + "' is not the name of a monitor (monitors: " + listed(scene.monitors, nameOf) +
                    ") or of a bolt with a quantity, as in 'BOLT.axial_force' (bolts: " + listed(scene.bolts, nameOf) +
                    ")"};
}

SubjectReading readSubject(std::string_view text, const Scene& scene) {
    if (const int monitor = indexNamed(scene.monitors, text); monitor >= 0)
        return wholeMonitor(monitor, scene);
    const auto dot = text.rfind('.');
    if (dot == std::string_view::npos)
        return unknownSubject(text, scene);
    const std::string_view name = text.substr(0, dot);
    const std::string_view part = text.substr(dot + 1);
    const int monitor = indexNamed(scene.monitors, name);
    const int bolt = indexNamed(scene.bolts, name);
    if (bolt >= 0 && (monitor < 0 || indexOfKey(boltQuantityRows, part) >= 0))
        return boltPart(bolt, part, scene);
    if (monitor >= 0)
        return monitorPart(monitor, part, scene);
    return unknownSubject(text, scene);
}

}  // namespace

int monitorValueCount(const Monitor& monitor) { return monitor.point ? 2 : 1; }

QuantityReading readQuantity(std::string_view text, const Scene& scene) {
    std::string_view rest = withoutSpaces(text);
    const std::string_view word = takeWord(rest);
    const auto first = std::find_if(firstWords.begin(), firstWords.end(),
                                    [&](const FirstWord& entry) { return entry.word == word; });
    if (first == firstWords.end())
        return {{},
                "a quantity starts with max, min, last, first, count or order, or is energy_error, factor_of_safety or "
                "stands; it does not start with '" +
                    std::string(word) + "'"};

    Quantity quantity{.kind = first->kind};
    if (first->takesEvent) {
        const std::string_view kind = takeWord(rest);
        quantity.eventKind = indexOfKey(eventKinds, kind);
        if (quantity.eventKind < 0)
            return {{}, "'" + std::string(kind) + "' is not a kind of event: write one of " + listedKeys(eventKinds)};
    }
    if (!first->takesSubject) {
        if (!rest.empty()) return {{}, "'" + std::string(word) + "' takes no '" + std::string(rest) + "': omit it"};
        return {quantity, ""};
    }
    const SubjectReading subject = readSubject(rest, scene);
    if (!subject.subject)
        return {{}, subject.problem};
    if (quantity.kind == QuantityKind::First && subject.subject->monitor < 0)
        return {{}, "'first' takes a monitor, not a bolt: add a monitor of '" + std::string(rest) + "' and use its name"};
    quantity.subject = *subject.subject;
    return {quantity, ""};
}

}  // namespace keyblock
