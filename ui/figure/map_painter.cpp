// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/map_painter.h"

#include "geometry/segment.h"
#include "ui/figure/column.h"
#include "ui/figure/contact_painter.h"
#include "ui/figure/mark_painter.h"
#include "ui/picture/section/clip_to_box.h"
#include "ui/picture/section/detail.h"
#include "ui/picture/section/shown_numbers.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double shank = 0.7, casing = 1.15;  // [mm]
constexpr double dashShare = 0.4;  // width of the dashes on a bar in compression, relative to that of the bar
constexpr DetailSizes onThePaper{.shank = shank, .betweenMarks = 1.45, .moved = 1.0, .scaleForArtificial = 3.0,
                                 .spacingForMarks = 1.7, .spacingForPlates = 2.6, .boltForMarks = 5.0};  // [mm]
constexpr double leastSpacingForNames = 3.0;  // [mm] names of closer bolts are beyond the far end or omitted
constexpr std::size_t manyAnchors = 12;

Point flipped(const Point& direction) { return {direction.x(), -direction.y()}; }

}  // namespace

MapPainter::MapPainter(const SectionPicture& picture, const Box& frame)
    : picture_(picture), frame_(frame), window_(picture.window), placement_(grown(frame, -0.6)) {
    const Point size = (frame.max - frame.min), extent = (window_.max - window_.min).cwiseMax(1e-9);
    scale_ = (size.array() / extent.array()).minCoeff();
    const Point middle = 0.5 * (window_.min + window_.max);
    window_ = boxAbout(middle, size / scale_);
    spacing_ = boltSpacing(picture, scale_, onThePaper);
    for (std::size_t i = 0; i < picture.bolts.size(); ++i)
        marks_.push_back(marksToDraw(picture.bolts[i], spacing_[i], scale_, onThePaper));
}

Point MapPainter::onPaper(const Point& p) const {
    const Point offset = scale_ * (p - window_.min);
    return {frame_.min.x() + offset.x(), frame_.max.y() - offset.y()};
}

std::vector<Point> MapPainter::onPaper(const std::vector<Point>& points) const {
    std::vector<Point> placed;
    placed.reserve(points.size());
    for (const Point& point : points) placed.push_back(onPaper(point));
    return placed;
}

void MapPainter::drawLines(Ink& ink, const std::vector<LineShape>& lines, const Stroke& stroke) const {
    for (const LineShape& line : lines)
        if (const auto part = clippedToBox(line.from, line.to, window_))
            ink.line(onPaper(part->first), onPaper(part->second), stroke);
}

void MapPainter::drawBlock(Ink& ink, const BlockShape& block, const Stroke& outline) const {
    const std::vector<Point> shown = clippedToBox(block.outline, window_);
    if (shown.empty()) return;
    const Colour fill = block.value ? picture_.blockLegend->colourOf(*block.value) : rock;
    ink.polygon(onPaper(shown), fill, outline);
}

void MapPainter::drawBlocks(Ink& ink) const {
    for (const BlockShape& block : picture_.blocks) drawBlock(ink, block, {jointLine, joint});
    drawLines(ink, picture_.seams, {seamLine, seam});
    drawLines(ink, picture_.borders, {jointLine, black});
    drawLines(ink, picture_.walls, {wall, black});
    for (const BlockShape* block : movedBlocks(picture_, scale_, onThePaper)) {
        const std::vector<Point> before = clippedToBox(block->before, window_);
        if (!before.empty()) ink.polygon(onPaper(before), {}, Stroke{0.17, black, {0.8, 0.6}});
    }
    for (const BlockShape* block : movedBlocks(picture_, scale_, onThePaper)) drawBlock(ink, *block, {wall, black});
}

void MapPainter::drawArrows(Ink& ink) const {
    if (!picture_.arrows) return;
    const double scale = arrowScale(*picture_.arrows);
    for (const ArrowMark& mark : picture_.arrows->marks) {
        const Point at = onPaper(mark.place), length = scale * flipped(mark.value);
        const double back = mark.shape == ArrowShape::Arrow ? 0.0 : 0.5;
        const Point from = at - back * length, to = from + length;
        if (meets({from, from}, frame_) && meets({to, to}, frame_)) drawArrow(ink, mark.shape, at, length);
    }
}

double MapPainter::longestContact() const {
    if (!picture_.contacts) return 0.0;
    return longestContactLine(picture_.contacts->scale.spacing * scale_);
}

void MapPainter::drawContacts(Ink& ink) const {
    if (!picture_.contacts) return;
    const ContactPainter contacts(picture_.contacts->scale, longestContact());
    for (const ContactLine& line : picture_.contacts->lines)
        if (const Point at = onPaper(line.place); meets({at, at}, frame_))
            contacts.draw(ink, line.kind, at, flipped(line.force), frame_);
}

void MapPainter::drawShank(Ink& ink, std::size_t index) const {
    const BoltShape& bolt = picture_.bolts[index];
    const std::vector<Point> nodes = onPaper(bolt.nodes);
    const double width = std::min(shank, 0.5 * spacing_[index]);
    ink.polyline(nodes, {width * casing / shank, white});
    const auto isDashed = [&](std::size_t e) {
        return !bolt.values.empty() && picture_.boltLegend->isDashed(bolt.values[e]);
    };
    for (std::size_t e = 0; e + 1 < nodes.size();) {
        const Colour colour = bolt.values.empty() ? black : picture_.boltLegend->colourOf(std::abs(bolt.values[e]));
        std::vector<Point> run{nodes[e]};
        const bool broken = bolt.broken[e];
        const std::size_t first = e;
        const auto alike = [&](std::size_t next) {
            return static_cast<bool>(bolt.broken[next]) == broken && isDashed(next) == isDashed(first) &&
                   (bolt.values.empty() || picture_.boltLegend->colourOf(std::abs(bolt.values[next])) == colour);
        };
        for (; e + 1 < nodes.size() && (e == first || alike(e)); ++e) run.push_back(nodes[e + 1]);
        if (broken) {
            ink.polyline(run, {0.15, softText, {0.6, 0.5}});
            continue;
        }
        ink.polyline(run, {width, colour});
        if (isDashed(first)) ink.polyline(run, {dashShare * width, white, {0.7, 0.7}});
    }
}

void MapPainter::drawMarks(Ink& ink, std::size_t index) const {
    const auto& marks = marks_[index];
    const auto real = std::count_if(marks.begin(), marks.end(), [](const Mark& m) { return !isArtificial(m.kind); });
    for (const Mark& mark : marks)
        drawMark(ink, mark.kind, onPaper(mark.place), flipped(mark.along),
                 static_cast<std::size_t>(real) > manyAnchors);
}

void MapPainter::drawLeader(Ink& ink, const Point& from, const Box& label) const {
    const Point to = 0.5 * (label.min + label.max);
    const auto inside = clippedToBox(from, to, label);
    const Point end = inside ? inside->first : to;
    ink.line(from, end, {0.6, white});
    ink.line(from, end, {leader, black});
}

void MapPainter::drawScaleBar(Ink& ink) {
    const double width = frame_.max.x() - frame_.min.x();
    const double length = roundHalvable(0.12 * width / scale_);
    const bool metres = length >= 0.5;
    const std::string unit = metres ? " m" : " mm";
    const double shown = metres ? length : 1e3 * length, bar = length * scale_;
    const auto label = [&](double share) { return numberText(shown * share); };
    const Point size(bar + 3.4 + textWidth(label(1.0) + unit, text_style::label), 6.6);
    const Point low = frame_.min + 0.5 * size + Point(1.2, 1.2), high = frame_.max - 0.5 * size - Point(1.2, 1.2);
    const std::vector<Point> corners{{low.x(), high.y()}, high, low, {high.x(), low.y()}};
    const auto placed = placement_.place(size, corners);
    const Box box = placed.value_or(boxAbout(corners.front(), size));
    if (!placed) placement_.keepOff(box);
    ink.box(box, white, Stroke{0.13, black});
    const Point at = box.min + Point(1.7, 4.1);
    for (int i = 0; i < 4; ++i)
        ink.box({at + Point(0.25 * i * bar, 0.0), at + Point(0.25 * (i + 1) * bar, 1.0)}, i % 2 ? white : black,
                Stroke{0.13, black});
    ink.text(at + Point(0.0, -1.0), "0", text_style::label, Align::Centre);
    ink.text(at + Point(0.5 * bar, -1.0), label(0.5), text_style::label, Align::Centre);
    const double half = 0.5 * textWidth(label(1.0), text_style::label);
    ink.text(at + Point(bar - half, -1.0), label(1.0) + unit, text_style::label);
}

void MapPainter::drawNumbers(Ink& ink) {
    for (const EventEntry& entry : picture_.events.entries) {
        const Point place = onPaper(entry.place);
        if (!meets({place, place}, frame_)) continue;
        Point first(0.0, -1.0);
        for (const BoltShape& bolt : picture_.bolts)
            if (bolt.bolt == entry.bolt) first = -turnLeft(flipped(alongOf(bolt.nodes)));
        const auto box = placement_.placeRound({3.7, 3.7}, place, first);
        if (!box) continue;
        drawLeader(ink, place, grown(*box, -0.1));
        drawNumber(ink, 0.5 * (box->min + box->max), entry.number, 1.75, {2.1, true});
    }
}

void MapPainter::drawNames(Ink& ink) {
    for (std::size_t i = 0; i < picture_.bolts.size(); ++i) {
        const BoltShape& bolt = picture_.bolts[i];
        const std::string name = elided(bolt.name, text_style::label, 18.0, true);
        const Point size(textWidth(name, text_style::label) + 0.6, 2.7);
        const Point along = flipped(alongOf(bolt.nodes)), across = turnLeft(along);
        std::vector<Point> centres;
        const auto beside = [&](const Point& end, const Point& away) {
            centres.push_back(end + (1.1 + 0.5 * away.cwiseAbs().dot(size)) * away);
        };
        for (const Point& away : {Point(-along), Point(across - along), Point(-across - along), across, Point(-across)})
            beside(onPaper(bolt.nodes.front()), away.normalized());
        beside(onPaper(bolt.nodes.back()), along);
        if (spacing_[i] < leastSpacingForNames) centres.resize(1);
        if (const auto box = placement_.place(size, centres))
            ink.casedText({0.5 * (box->min.x() + box->max.x()), box->max.y() - 0.55}, name, text_style::label,
                          Align::Centre);
    }
}

/// The start of a leader in a block: its centroid, or halfway to a corner if a bolt is at the centroid.
Point MapPainter::footWithin(const std::vector<Point>& outline) const {
    const Point centroid = moments(outline).centroid;
    if (placement_.isFree(boxAbout(centroid, {1.5, 1.5}))) return centroid;
    for (const Point& corner : outline)
        if (const Point place = 0.5 * (centroid + corner); placement_.isFree(boxAbout(place, {1.5, 1.5}))) return place;
    return centroid;
}

/// Writes the displacement of each block whose initial outline is drawn.
void MapPainter::drawMoved(Ink& ink) {
    for (const BlockShape* block : movedBlocks(picture_, scale_, onThePaper)) {
        const std::vector<Point> shown = clippedToBox(block->outline, window_);
        if (shown.empty()) continue;
        const Point centre = footWithin(onPaper(shown));
        const double way = block->displaced / picture_.factor;
        const std::string text = elided(block->name, text_style::label, 18.0, true) + " moved " +
                                 lengthText(way, {});
        const Point size(textWidth(text, text_style::label) + 1.0, 3.2);
        if (const auto box = placement_.placeRound(size, centre, {0.0, -1.0})) {
            drawLeader(ink, centre, *box);
            ink.circle(centre, 0.4, black, {});
            ink.casedText({box->min.x() + 0.5, box->max.y() - 0.9}, text, text_style::label);
        }
    }
}

void MapPainter::draw(Ink& ink) {
    ink.box(frame_, white, {});
    drawBlocks(ink);
    drawArrows(ink);
    drawContacts(ink);
    for (std::size_t i = 0; i < picture_.bolts.size(); ++i) {
        const BoltShape& bolt = picture_.bolts[i];
        drawShank(ink, i);
        placement_.keepOff(onPaper(bolt.nodes.front()), onPaper(bolt.nodes.back()), 0.9);
    }
    for (const LineShape& line : picture_.walls) placement_.keepLabelsOff(onPaper(line.from), onPaper(line.to));
    for (const BlockShape* block : movedBlocks(picture_, scale_, onThePaper))
        for (std::size_t i = 0; i < block->outline.size(); ++i)
            placement_.keepLabelsOff(onPaper(block->outline[i]),
                                     onPaper(block->outline[(i + 1) % block->outline.size()]));
    drawScaleBar(ink);
    drawNames(ink);
    drawRibbon(ink);
    for (std::size_t i = 0; i < picture_.bolts.size(); ++i) drawMarks(ink, i);
    drawNumbers(ink);
    drawMoved(ink);
    ink.box(frame_, {}, Stroke{paper_theme::frame, black});
}

}  // namespace keyblock
