// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Three passes over the frames: the first finds the ranges, the second finds the
// common settings and the space they need, and the third paints the pictures one at a
// time. Only one frame is in memory.
#include "ui/figure/animation.h"

#include "solver/results/csv.h"
#include "solver/results/result_names.h"
#include "ui/figure/film_line.h"
#include "ui/figure/map_painter.h"
#include "ui/figure/mark_painter.h"
#include "ui/figure/paper.h"
#include "ui/figure/section_figure.h"
#include "ui/figure/section_layout.h"
#include "ui/figure/sheet.h"
#include "ui/picture/section/section_film.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <regex>
#include <set>

namespace keyblock {

namespace {

constexpr double filmLineGap = 2.5;  // [mm] gap below the section and the column

std::vector<std::size_t> framesOf(const RunSource& run, const TableFilter& filter) {
    std::vector<std::size_t> frames;
    for (std::size_t i = 0; i < run.frames().size(); ++i)
        if (!filter.stage || run.frames()[i].stage == *filter.stage) frames.push_back(i);
    if (!frames.empty()) return frames;
    throw CannotDraw(filter.stage ? "stage '" + stageName(run.scene(), *filter.stage) +
                                        "' has no frames yet, so there is nothing to animate"
                                  : "the run has no frames yet, so there is nothing to animate");
}

/// Refuses arrows: they are scaled to the largest arrow of their frame, so frames could not be compared.
SectionRequest colouredRequestOf(const RunSource& run, const FigureRequest& request) {
    SectionRequest section = sectionRequestOf(run, request);
    for (auto& [quantity, scale] : section.scales)
        if (scale.of == ScaleOf::ThisFrame) scale.of = ScaleOf::AllFrames;  // frames of an animation must be comparable
    if (section.arrows)
        throw CannotDraw("an animation shows colours, not '" + *request.quantity + "'; choose another quantity");
    return section;
}

}  // namespace

class Animation::Painter {
public:
    Painter(const RunSource& run, const FigureRequest& request)
        : run_(run), request_(request), frames_(framesOf(run, request.filter)),
          film_(run, colouredRequestOf(run, request), frames_), last_(film_.picture(frames_.size() - 1)),
          line_(run, frames_, last_.events), layout_(sharedLayout()) {
        const Sheet sheet = sheetOf(last_, frames_.back());
        const double around = sheet.heightAround(0.0) - sheet.top();
        height_ = std::ceil(layout_.map().min.y() + layout_.height() + filmLineGap + filmLineHeight + around);
    }

    const std::vector<std::size_t>& frames() const { return frames_; }

    /// The picture of a frame on its own sheet, which is not finished yet.
    std::unique_ptr<Paper> painted(std::size_t index) const {
        const SectionPicture picture = film_.picture(index);
        auto paper = emptyPaper();
        Ink ink(paper->painter());
        sheetOf(picture, frames_[index]).draw(ink, height_, footOf(run_, request_, frames_[index], height_));
        layout_.draw(ink, picture, run_.scene());
        const Point below(paper_theme::margin, layout_.map().min.y() + layout_.height() + filmLineGap);
        line_.draw(ink, below, sheetOf(picture, frames_[index]).inner(), index);
        return paper;
    }

    std::unique_ptr<Paper> emptyPaper() const {
        return std::make_unique<Paper>(PaperFormat::Png, request_.width, height_, request_.dpi, last_.title);
    }

private:
    Sheet sheetOf(const SectionPicture& picture, std::size_t frame) const {
        const std::string& title = request_.title.empty() ? picture.title : request_.title;
        return {request_.width, title, picture.subtitle, warningsOf(run_, frame, picture.notFinite)};
    }

    /// A layout with space for the longest title, all kinds of marks and the last list of events, which is the longest.
    SectionLayout sharedLayout() const {
        const auto layoutFrom = [&](double top, const std::optional<std::vector<MarkKind>>& kinds) {
            return SectionLayout(last_, run_.scene(), request_.width, top, sheetOf(last_, frames_.back()).inner(), kinds);
        };
        double top = sheetOf(last_, frames_.back()).top();
        const Box map = layoutFrom(top, {}).map();
        std::set<MarkKind> found;
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            const SectionPicture picture = film_.picture(i);
            top = std::max(top, sheetOf(picture, frames_[i]).top());
            for (const MarkKind kind : MapPainter(picture, map).kinds()) found.insert(kind);
        }
        std::vector<MarkKind> kinds;
        std::copy_if(keyOrder.begin(), keyOrder.end(), std::back_inserter(kinds),
                     [&](MarkKind kind) { return found.contains(kind); });
        return layoutFrom(top, kinds);
    }

    const RunSource& run_;
    FigureRequest request_;
    std::vector<std::size_t> frames_;
    SectionFilm film_;
    SectionPicture last_;
    FilmLine line_;
    SectionLayout layout_;
    double height_ = 0.0;  // [mm]
};

Animation::Animation(const RunSource& run, const FigureRequest& request)
    : painter_(std::make_unique<Painter>(run, request)) {}

Animation::~Animation() = default;

std::size_t Animation::size() const { return painter_->frames().size(); }
std::size_t Animation::frame(std::size_t picture) const { return painter_->frames()[picture]; }
int Animation::columns() const { return painter_->emptyPaper()->image().width(); }
int Animation::rows() const { return painter_->emptyPaper()->image().height(); }

std::string Animation::png(std::size_t picture) const { return painter_->painted(picture)->finish(); }

std::string Animation::pixels(std::size_t picture) const {
    const auto paper = painter_->painted(picture);
    paper->painter().end();
    const QImage& image = paper->image();
    std::string bytes;
    bytes.reserve(image.sizeInBytes());
    for (int row = 0; row < image.height(); ++row)
        bytes.append(reinterpret_cast<const char*>(image.constScanLine(row)),
                     4 * static_cast<std::size_t>(image.width()));
    return bytes;
}

std::string pictureName(std::size_t picture) {
    std::string number = std::to_string(picture + 1);
    number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
    return "frame-" + number + ".png";
}

bool isOfPictures(const std::string& name) {
    static const std::regex picture("frame-[0-9]{4,}\\.png");
    return name == "frames.csv" || std::regex_match(name, picture);
}

void writePictureList(const RunSource& run, const Animation& animation, std::ostream& out) {
    CsvWriter csv(out);
    csv.text("file").text("stage").text("time_s").text("step").endRow();
    for (std::size_t i = 0; i < animation.size(); ++i) {
        const FrameHead& head = run.frames()[animation.frame(i)];
        csv.text(pictureName(i)).text(stageName(run.scene(), head.stage)).number(head.time).integer(head.step);
        csv.endRow();
    }
}

}  // namespace keyblock
