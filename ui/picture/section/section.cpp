// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/section.h"

#include "solver/results/result_names.h"
#include "solver/scene/shapes.h"
#include "solver/scene/solved_blocks.h"
#include "ui/picture/captions.h"
#include "ui/picture/chart.h"
#include "ui/picture/not_finite.h"
#include "ui/picture/section/deformed.h"
#include "ui/picture/section/faces.h"
#include "ui/picture/section/section_ranges.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {

namespace {

constexpr double margin = 0.3;  // margin around tunnels and bolts, relative to their extent
constexpr double rim = 0.05;  // margin around a whole model, relative to its extent
constexpr double noValue = 1e-4;  // fraction of the legend's range; smaller values are round-off
constexpr double nearlyAll = 0.6;  // if the view covers more than this fraction of the model, all of it is shown

Box united(const Box& a, const Box& b) { return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)}; }
double areaOf(const Box& box) { return (box.max - box.min).prod(); }
template <typename Row>
double shownValue(const FrameQuantity<Row>& quantity, const Row& row) {
    return quantity.value(row) * quantity.display.factor;
}

bool areTouching(const Box& a, const Box& b) {
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

class SectionBuilder {
public:
    SectionBuilder(const RunSource& run, const SectionRequest& request)
        : run_(run), scene_(run.scene()), request_(request), solved_(solvedBlocks(scene_)),
          before_(cornersBefore(solved_)) {
        if (request.frame) frame_ = run.frame(*request.frame);
        present_.assign(before_.size(), 1);
        for (std::size_t b = 0; b < frame_.blocks.size(); ++b)
            present_[b] = frame_.blocks[b].area > 0.0 && canBeDrawn(frame_.blocks[b]);
    }

    SectionPicture build() {
        picture_.factor = request_.factor;
        picture_.title = titleOf(run_, request_.frame);
        picture_.subtitle = subtitleOf(scene_, request_.factor);
        if (request_.frame) {
            picture_.notFinite = notFiniteText(frame_);
            const SectionLegends legends =
                withNow(request_.legends ? *request_.legends : sectionLegends(run_, request_), request_, frame_);
            picture_.blockLegend = legends.blocks;
            picture_.boltLegend = legends.bolts;
            contactScale_ = legends.contacts;
            events_ = eventsUntil(run_.events(), run_.frames()[*request_.frame]);
            picture_.events = eventList(run_, events_, request_.mostEvents);
        }
        addBlocks();
        addFaces();
        for (const SceneTunnel& tunnel : scene_.tunnels)
            picture_.openings.push_back(outline(tunnelProfile(shapeOf(tunnel))));
        addArrows();
        addBolts();
        chooseRibbon();
        placeEvents();
        chooseWindow();
        addContacts();
        return std::move(picture_);
    }

private:
    std::vector<Point> drawnCorners(std::size_t block) const {
        if (!request_.frame) return before_[block];
        return deformed(before_[block], frame_.blocks[block].points, request_.factor);
    }

    void addBlocks() {
        drawn_.resize(before_.size());
        for (std::size_t b = 0; b < before_.size(); ++b) {
            if (!present_[b]) continue;
            drawn_[b] = drawnCorners(b);
            BlockShape shape{static_cast<int>(b), solved_.blocks[b].name, drawn_[b], before_[b], {}, 0.0};
            for (std::size_t i = 0; i < drawn_[b].size(); ++i)
                shape.displaced = std::max(shape.displaced, (drawn_[b][i] - before_[b][i]).norm());
            if (picture_.blockLegend)
                if (const double value = shownValue(*request_.blocks, frame_.blocks[b]); canBeShown(value))
                    shape.value = value;
            picture_.blocks.push_back(std::move(shape));
        }
        addActivity();
    }

    void addActivity() {
        if (!request_.activity || !request_.frame) return;
        const std::vector<char> fixed = fixedBlocks(scene_, solved_);
        const FrameHead info = run_.frames()[*request_.frame];
        const bool inMotion = scene_.stages[info.stage].kind == StageKind::Dynamic && info.time > 0.0;
        ActivityCounts counts;
        counts.removed = static_cast<int>(std::count(present_.begin(), present_.end(), 0));
        for (BlockShape& shape : picture_.blocks) {
            shape.activity = activityOf(frame_.blocks[shape.block], fixed[shape.block] != 0, inMotion);
            ++(*shape.activity == BlockActivity::Active   ? counts.active
               : *shape.activity == BlockActivity::Asleep ? counts.asleep
                                                          : counts.fixed);
        }
        picture_.activity = counts;
    }

    void addFaces() {
        for (const FacePiece& piece : facePieces(scene_, solved_, before_, present_)) {
            if (piece.kind == FaceKind::Joint) continue;
            const auto& corners = drawn_[piece.block];
            const Point& a = corners[piece.edge];
            const Point along = corners[static_cast<std::size_t>(piece.edge + 1) % corners.size()] - a;
            const LineShape line{a + piece.from * along, a + piece.to * along};
            if (piece.kind == FaceKind::Wall) picture_.walls.push_back(line);
            else if (piece.kind == FaceKind::Border) picture_.borders.push_back(line);
            else picture_.seams.push_back(line);
        }
    }

    void addArrows() {
        if (!request_.arrows || !request_.frame) return;
        std::vector<Point> places(drawn_.size(), Point(0.0, 0.0));
        for (std::size_t b = 0; b < drawn_.size(); ++b)
            if (present_[b]) places[b] = moments(drawn_[b]).centroid;
        picture_.arrows = arrowField(*request_.arrows, frame_, places);
    }

    void addContacts() {
        if (!contactScale_) return;
        std::vector<Point> places;
        for (const ContactFrame& contact : frame_.contacts) {
            const std::size_t a = contact.blockA;
            const bool moves = a < drawn_.size() && drawn_[a].size() == frame_.blocks[a].points.size();
            places.push_back(moves ? carriedAlong(contact.position, frame_.blocks[a].points, drawn_[a])
                                   : contact.position);
        }
        picture_.contacts = contactField(*contactScale_, frame_, places);
        if (!request_.everyContact) picture_.contacts = seenWithin(*picture_.contacts, picture_.window);
        picture_.contacts->thickness = scene_.analysis.thickness;
    }

    void addBolts() {
        for (std::size_t b = 0; b < scene_.bolts.size(); ++b) {
            const Bolt& bolt = scene_.bolts[b];
            BoltShape shape;
            shape.bolt = static_cast<int>(b);
            shape.name = bolt.name;
            if (!request_.frame) {
                shape.nodes = {bolt.farEnd, bolt.head};
                shape.s = {0.0, (bolt.head - bolt.farEnd).norm()};
                shape.broken = {0};
            } else if (!frame_.bolts[b].nodes.empty() && canBeDrawn(frame_.bolts[b])) {
                fillBolt(bolt, frame_.bolts[b], shape);
            } else {
                continue;
            }
            picture_.bolts.push_back(std::move(shape));
        }
    }

    void fillBolt(const Bolt& bolt, const BoltFrame& frame, BoltShape& shape) const {
        shape.nodes = deformedNodes(bolt, frame, request_.factor);
        for (const BoltNodeFrame& node : frame.nodes) shape.s.push_back(node.s);
        for (std::size_t e = 0; e + 1 < frame.nodes.size(); ++e) {
            shape.broken.push_back(frame.nodes[e].ruptured || frame.lost);
            if (picture_.boltLegend) shape.values.push_back(shownValue(*request_.bolts, frame.nodes[e]));
        }
        if (!std::ranges::all_of(shape.values, canBeShown)) shape.values.clear();
        shape.marks = marksOf(bolt, shape.bolt, frame, shape.nodes, events_);
    }

    /// Places the force diagram at the requested bolt, or else at the bolt with the largest value. There is none if all
    /// values are negligible compared with the range of the legend.
    void chooseRibbon() {
        if (!picture_.boltLegend) return;
        double largest = noValue * picture_.boltLegend->range.high;
        for (std::size_t i = 0; i < picture_.bolts.size(); ++i) {
            const BoltShape& shape = picture_.bolts[i];
            if (request_.ribbon && *request_.ribbon != shape.bolt) continue;
            for (std::size_t e = 0; e < shape.values.size(); ++e)
                if (std::abs(shape.values[e]) > largest) {
                    largest = std::abs(shape.values[e]);
                    picture_.ribbon = Ribbon{i, e, 0.0, {}, {}, {}};
                }
        }
        if (!picture_.ribbon) return;
        largest = std::max(largest, request_.ribbonScale);
        addLimit(*picture_.ribbon, largest);
        picture_.ribbon->scale = std::max(largest, picture_.ribbon->limit.value_or(0.0));
    }

    /// Adds the lowest limit that the values have not exceeded, even if it is far above them.
    void addLimit(Ribbon& ribbon, double largest) const {
        const BoltShape& shape = picture_.bolts[ribbon.shape];
        const std::size_t bolt = shape.bolt;
        const auto take = [&](const std::string& name, const std::vector<double>& limits) {
            const double limit = *std::max_element(limits.begin(), limits.end());
            if (ribbon.limit || limit < largest * (1.0 - noValue)) return;
            ribbon.limit = limit;
            ribbon.limits = limits;
            ribbon.limitName = name;
        };
        for (const auto& [limit, name] : limitsOf(scene_, scene_.bolts[bolt], *request_.bolts))
            take(name, std::vector<double>(shape.values.size(), limit));
        if (rowOf(*request_.bolts).quantity != BoltQuantity::AnchorForce) return;
        std::vector<double> peaks;
        for (std::size_t e = 0; e < shape.values.size(); ++e)
            peaks.push_back(frame_.bolts[bolt].nodes[e].bondStrength * request_.bolts->display.factor);
        take("peak", peaks);
    }

    /// Places each event where its node or block is drawn in this frame.
    void placeEvents() {
        for (EventEntry& entry : picture_.events.entries) {
            for (const BlockShape& shape : picture_.blocks)
                if (entry.bolt < 0 && entry.block == shape.block) entry.place = moments(shape.outline).centroid;
            for (const BoltShape& shape : picture_.bolts) {
                if (shape.bolt != entry.bolt) continue;
                const int at = entry.node >= 0 ? entry.node : entry.element;
                if (entry.kind == EventKind::PlateLoss || entry.kind == EventKind::BoltLoss)
                    entry.place = shape.nodes.back();
                else if (at >= 0 && static_cast<std::size_t>(at) < shape.nodes.size())
                    entry.place = shape.nodes[at];
            }
        }
    }

    void chooseWindow() {
        if (before_.empty()) return;
        Box model = boxOf(before_.front());
        for (const auto& corners : before_) model = united(model, boxOf(corners));
        Box drawn = model;
        for (const BlockShape& shape : picture_.blocks) drawn = united(drawn, boxOf(shape.outline));
        for (const BoltShape& shape : picture_.bolts) drawn = united(drawn, boxOf(shape.nodes));
        const bool anyLeft = std::any_of(picture_.blocks.begin(), picture_.blocks.end(), [&](const BlockShape& shape) {
            return areTouching(boxOf(shape.outline), model);
        });
        // Blocks that were thrown far away do not enlarge the view, as long as a block is left within the model's
        // initial extent.
        const bool flung = anyLeft && areaOf(drawn) > 6.0 * areaOf(model);
        picture_.model = flung ? model : drawn;
        picture_.window = request_.whole ? withRim(picture_.model) : around(picture_.model);
        if (request_.window) picture_.window = *request_.window;
    }

    Box around(const Box& model) const {
        std::optional<Box> box;
        const auto add = [&](const Box& more) { box = box ? united(*box, more) : more; };
        for (const SceneTunnel& tunnel : scene_.tunnels) add(boxOf(outline(tunnelProfile(shapeOf(tunnel)))));
        for (const BoltShape& shape : picture_.bolts) add(boxOf(shape.nodes));
        if (!box) return withRim(model);
        const Box wide = grown(*box, margin * (box->max - box->min).maxCoeff());
        const Box shown{wide.min.cwiseMax(model.min), wide.max.cwiseMin(model.max)};
        const bool empty = (shown.max.array() <= shown.min.array()).any();
        return empty || areaOf(shown) > nearlyAll * areaOf(model) ? withRim(model) : shown;
    }

    /// Adds a margin for the names and face plates at the ends of bolts.
    static Box withRim(const Box& model) { return grown(model, rim * (model.max - model.min).maxCoeff()); }

    const RunSource& run_;
    const Scene& scene_;
    const SectionRequest& request_;
    SolvedBlocks solved_;
    std::vector<std::vector<Point>> before_, drawn_;
    std::vector<char> present_;
    Frame frame_;
    std::vector<Event> events_;
    std::optional<ContactScale> contactScale_;
    SectionPicture picture_;
};

}  // namespace

SectionPicture sectionPicture(const RunSource& run, const SectionRequest& request) {
    assert(!request.frame || *request.frame < run.frames().size());
    return SectionBuilder(run, request).build();
}

}  // namespace keyblock
