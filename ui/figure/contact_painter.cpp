// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/contact_painter.h"

#include "ui/picture/section/clip_to_box.h"
#include "ui/picture/ticks.h"

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr Colour locked = rgb(0x264A6E);
constexpr double contactRim = 0.2;  // [mm]
constexpr double contactRow = 3.3, contactNoteRow = 2.9;  // [mm]
constexpr std::size_t mostNoteLines = 3, roomOfNote = 2;

std::string nameOf(ContactKind kind) {
    switch (kind) {
        case ContactKind::Locked: return "locked";
        case ContactKind::Sliding: return "sliding";
        case ContactKind::Bonded: return "bonded";
        case ContactKind::Pulled: return "bonded, in tension";
    }
    return {};
}

void drawPart(Ink& ink, const Point& from, const Point& to, const Stroke& stroke, const Box& frame) {
    if (const auto part = clippedToBox(from, to, frame)) ink.line(part->first, part->second, stroke);
}

}  // namespace

double ContactPainter::lengthOf(double force) const { return contactLength(scale_, force, length_); }

double ContactPainter::widthOf(double force) const { return contactWidth(scale_, force, length_); }

void ContactPainter::draw(Ink& ink, ContactKind kind, const Point& at, const Point& force, const Box& frame) const {
    const double size = force.norm(), width = widthOf(size);
    const Point half = 0.5 * lengthOf(size) / size * force;
    switch (kind) {
        case ContactKind::Locked: return drawPart(ink, at - half, at + half, {width, locked}, frame);
        case ContactKind::Sliding:  // a hollow bar
            drawPart(ink, at - half, at + half, {width + contactRim, black}, frame);
            return drawPart(ink, at - half, at + half, {width, slipping}, frame);
        case ContactKind::Bonded:  // with the disc of a bonded anchor
            drawPart(ink, at - half, at + half, {width, locked}, frame);
            return ink.circle(at, 0.5 * width + 0.18, locked, {});
        case ContactKind::Pulled:  // two separated halves
            drawPart(ink, at - half, at - 0.3 * half, {width, error}, frame);
            return drawPart(ink, at + 0.3 * half, at + half, {width, error}, frame);
    }
}

namespace {

/// Draws lines for two forces side by side, and below them a sample of each kind of contact.
void drawSamples(Ink& ink, const ContactField& field, const ContactPainter& contacts, const Point& at, double width) {
    const Box everywhere{{-1e9, -1e9}, {1e9, 1e9}};
    double x = 0.0;
    for (const double force : {field.scale.longest, 0.25 * field.scale.longest}) {
        const double length = contacts.lengthOf(force);
        contacts.draw(ink, ContactKind::Locked, at + Point(x + 0.5 * length + 0.4, 4.8), {force, 0.0}, everywhere);
        const std::string label = numberText(force) + " " + field.unit;
        ink.text(at + Point(x + length + 1.6, 5.5), label, text_style::body);
        x += length + 1.6 + textWidth(label, text_style::body) + 3.0;
    }
    const double sample = 0.6 * field.scale.longest;
    for (std::size_t i = 0; i < field.scale.kinds.size(); ++i) {
        const Point place = at + Point(i % 2 ? 0.45 * width : 0.0, 5.5 + contactRow * static_cast<double>(i / 2 + 1));
        const double length = contacts.lengthOf(sample);
        contacts.draw(ink, field.scale.kinds[i], place + Point(0.5 * length + 0.4, -0.7), {sample, 0.0}, everywhere);
        ink.text(place + Point(length + 1.6, 0.0), nameOf(field.scale.kinds[i]), text_style::body);
    }
}

std::vector<std::string> notesOf(const ContactField& field, double width) {
    std::vector<std::string> notes;
    const auto add = [&](const std::string& note, std::size_t least) {
        const auto lines = wrapped(note, text_style::note, width, mostNoteLines);
        notes.insert(notes.end(), lines.begin(), lines.end());
        for (std::size_t i = lines.size(); i < least; ++i) notes.emplace_back();
    };
    add("out-of-plane thickness " + numberText(field.thickness) + " m; up to " + numberText(field.largest) + " " + field.unit +
        " in this frame, " + numberText(field.scale.largest) + " in the run", roomOfNote);
    if (field.scale.largest > field.scale.longest)
        add("longer lines are clipped to " + numberText(field.scale.longest) + " " + field.unit, 1);
    for (const std::string& note : field.notes) add(note, roomOfNote);
    return notes;
}

}  // namespace

ColumnItem contactItem(const ContactField& field, double length, double width) {
    if (field.scale.longest <= 0.0)
        return {2.0 + contactNoteRow, [](Ink& ink, const Point& at) {
                    ink.text(at + Point(0.0, 2.0), "Contact force", text_style::heading);
                    ink.text(at + Point(0.0, 2.0 + contactNoteRow), "no contact carries a force", text_style::note);
                }};
    const std::vector<std::string> notes = notesOf(field, width);
    const double kinds = 6.1 + contactRow * static_cast<double>((field.scale.kinds.size() + 1) / 2);
    const double height = kinds + contactNoteRow * static_cast<double>(notes.size());
    return {height, [&field, length, width, notes, kinds](Ink& ink, const Point& at) {
                ink.text(at + Point(0.0, 2.0), "Contact force (" + field.unit + ")", text_style::heading);
                drawSamples(ink, field, ContactPainter(field.scale, length), at, width);
                double y = kinds;
                for (const std::string& note : notes) ink.text(at + Point(0.0, y += contactNoteRow), note, text_style::note);
            }};
}

}  // namespace keyblock
