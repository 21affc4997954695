// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/contact_lines.h"

#include "solver/results/frame_quantities.h"
#include "solver/scene/units.h"
#include "ui/picture/section/shown_numbers.h"
#include "ui/picture/ticks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace keyblock {

namespace {

constexpr double shownForce = perSi(namedUnit("kN"));
constexpr double forcesOutside = 0.02;  // share of the sum of all forces carried by forces off the scale
constexpr double leastLine = 0.01;  // fraction of the longest line; shorter lines are omitted
constexpr std::size_t manyLines = 2000;  // lines in view; if there are more, they are thinned out
constexpr double squares = 1500.0;  // to thin out the lines, the view is divided into about this many squares

constexpr double longestOfBlock = 1.2;  // length of the longest line relative to the block size on paper
constexpr double shortestScale = 2.6, longestScale = 8.0, thinnest = 0.12;  // [mm]

bool bears(const ContactFrame& contact) { return contact.state != ContactState::Open; }

ContactKind contactKindOf(const ContactFrame& contact) {
    switch (contact.state) {
        case ContactState::Sliding: return ContactKind::Sliding;
        case ContactState::Bonded: return contact.normalForce < 0.0 ? ContactKind::Pulled : ContactKind::Bonded;
        default: return ContactKind::Locked;
    }
}

/// The largest force in each square, in the order of the squares.
std::vector<ContactLine> largestOfEach(const std::vector<ContactLine>& lines, double side) {
    std::map<std::pair<long, long>, std::size_t> kept;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Point cell = (lines[i].place / side).array().floor();
        const auto [at, isNew] = kept.try_emplace({std::lround(cell.x()), std::lround(cell.y())}, i);
        if (!isNew && lines[i].force.norm() > lines[at->second].force.norm()) at->second = i;
    }
    std::vector<ContactLine> largest;
    for (const auto& [cell, index] : kept) largest.push_back(lines[index]);
    return largest;
}

/// Rounds up to two digits.
double twoDigits(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::ceil(value / unit * (1.0 - 1e-9)) * unit;
}

/// Thins out the lines if there are many, and adds a note on how many are drawn.
void thinOut(ContactField& field, const Box& window) {
    const std::size_t all = field.lines.size();
    const double smallest = leastLine * field.scale.longest;
    std::erase_if(field.lines, [&](const ContactLine& line) { return line.force.norm() < smallest; });
    std::string which = "forces below " + numberText(smallest) + " " + field.unit + " omitted";
    if (field.lines.size() > manyLines) {
        const double side = twoDigits(std::sqrt((window.max - window.min).prod() / squares));
        field.lines = largestOfEach(field.lines, side);
        which = "only the largest of each " + lengthText(side, {}) + " square";
    }
    const std::string total = numberText(static_cast<double>(all), 0), drawn = numberText(static_cast<double>(field.lines.size()), 0);
    const bool isWhole = field.lines.size() == all;
    field.notes.push_back(isWhole ? "all " + total + " contacts in view drawn"
                                  : drawn + " of " + total + " contacts in view drawn: " + which);
}

}  // namespace

ContactLine contactLine(const ContactFrame& contact) {
    return {contactKindOf(contact), contact.position, shownForce * forceOnA(contact)};
}

void widen(ContactScale& scale, const Frame& frame, std::vector<double>& sizes) {
    for (const ContactFrame& contact : frame.contacts) {
        if (!bears(contact)) continue;
        const ContactLine line = contactLine(contact);
        const double size = line.force.norm();
        if (size == 0.0 || !canBeShown(size)) continue;
        sizes.push_back(size);
        scale.largest = std::max(scale.largest, size);
        const auto at = std::lower_bound(scale.kinds.begin(), scale.kinds.end(), line.kind);
        if (at == scale.kinds.end() || *at != line.kind) scale.kinds.insert(at, line.kind);
    }
}

double longestOf(std::vector<double> sizes) {
    std::sort(sizes.begin(), sizes.end());
    double sum = 0.0, until = 0.0;
    for (const double size : sizes) sum += size;
    for (const double size : sizes)
        if ((until += size) >= (1.0 - forcesOutside) * sum) return size > 0.0 ? roundHalvable(size) : 0.0;
    return 0.0;
}

double longestContactLine(double block) { return std::clamp(longestOfBlock * block, shortestScale, longestScale); }

double contactLength(const ContactScale& scale, double force, double longest) {
    return scale.longest > 0.0 ? longest * std::min(1.0, force / scale.longest) : 0.0;
}

double contactWidth(const ContactScale& scale, double force, double longest) {
    return thinnest + (0.2 + 0.05 * longest) * (longest > 0.0 ? contactLength(scale, force, longest) / longest : 0.0);
}

ContactField contactField(const ContactScale& scale, const Frame& frame, const std::vector<Point>& places) {
    ContactField field;
    field.scale = scale;
    for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
        if (!bears(frame.contacts[i])) continue;
        ContactLine line = contactLine(frame.contacts[i]);
        line.place = places[i];
        if (line.force.norm() == 0.0 || !canBeShown(line.force.norm()) || !canBeShown(line.place.norm())) continue;
        field.largest = std::max(field.largest, line.force.norm());
        field.lines.push_back(line);
    }
    std::stable_sort(field.lines.begin(), field.lines.end(), [](const ContactLine& a, const ContactLine& b) {
        return a.force.squaredNorm() < b.force.squaredNorm();
    });
    return field;
}

ContactField seenWithin(const ContactField& field, const Box& window) {
    ContactField seen = field;
    std::erase_if(seen.lines, [&](const ContactLine& line) { return !meets({line.place, line.place}, window); });
    seen.notes = {"resultant of normal and shear force; open contacts have none"};
    thinOut(seen, window);
    std::stable_sort(seen.lines.begin(), seen.lines.end(), [](const ContactLine& a, const ContactLine& b) {
        return a.force.squaredNorm() < b.force.squaredNorm();
    });
    return seen;
}

}  // namespace keyblock
