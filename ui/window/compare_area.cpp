// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/compare_area.h"

#include "ui/canvas/canvas.h"
#include "ui/canvas/canvas_caption.h"
#include "ui/docks/curves.h"
#include "ui/look/commands.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/comparison.h"
#include "ui/runs/live_run.h"
#include "ui/runs/runs.h"
#include "ui/runs/section_feed.h"
#include "ui/runs/time_cursor.h"
#include "ui/runs/view_settings.h"

#include <QAction>
#include <QBoxLayout>
#include <QFileDialog>
#include <QFileInfo>
#include <QTimer>

#include <algorithm>

namespace keyblock {

struct CompareArea::Second {
    Second(const CompareNeeds& needs)
        : choice(needs.document, needs.selection, needs.comparison.second()),
          feed(choice, needs.comparison.second(), needs.settings, needs.display), canvas(new Canvas(needs.themes)),
          caption(new CanvasCaption(*canvas, needs.themes, true)),
          firstCaption(new CanvasCaption(needs.canvas, needs.themes, false)) {
        canvas->setObjectName("secondCanvas");
        canvas->setAccessibleName(CompareArea::tr("Section of the second run"));
        canvas->setDrawing(false);
        canvas->setLegend(false);  // the legend of the first canvas applies to both
    }
    ~Second() {
        delete firstCaption;
        delete canvas;
    }
    Second(const Second&) = delete;
    Second& operator=(const Second&) = delete;

    BoltChoice choice;
    SectionFeed feed;
    Canvas* canvas;
    CanvasCaption *caption, *firstCaption;
};

CompareArea::CompareArea(const CompareNeeds& needs, QObject* parent) : QObject(parent), needs_(needs) {
    QAction* action = needs.commands.add(
        {"run.compare", tr("Compare runs"), "Results", "compare",
         tr("Shows a second run next to this one, with the same view and time. Use the command again to close the "
            "comparison."),
         {QKeySequence("Shift+C")}, true},
        [this] { beginOrEnd(); });
    const auto enable = [this, action] {
        action->setChecked(needs_.comparison.isOn());
        action->setEnabled(needs_.feed.showsResults() || needs_.comparison.isOn());
    };
    connect(&needs.comparison, &Comparison::changed, this, [this, enable] {
        show();
        enable();
    });
    connect(&needs.feed, &SectionFeed::modeChanged, this, [this, enable] {
        show();
        enable();
    });
    connect(&needs.runs, &Runs::shownChanged, this, &CompareArea::show);
    enable();
}

CompareArea::~CompareArea() = default;

void CompareArea::place(QBoxLayout& besideCanvas, Curves& curves, Curves& energies) {
    row_ = &besideCanvas;
    curves_ = &curves;
    energies_ = &energies;
}

/// Ends the comparison, or begins one with the newest other run that can be read. If there is no such run, the user
/// chooses a file.
void CompareArea::beginOrEnd() {
    needs_.commands.action("run.compare")->setChecked(needs_.comparison.isOn());
    if (needs_.comparison.isOn()) return needs_.comparison.end();
    const QString shown = needs_.runs.shown();
    for (const RunEntry& entry : needs_.runs.entries())
        if (entry.path != shown && entry.summary && !entry.goesOn) return needs_.comparison.begin(entry.path);
    const QString path = QFileDialog::getOpenFileName(&needs_.window, tr("Choose a run to compare"),
                                                      QFileInfo(shown).absolutePath(), tr("Runs (*.kbrun)"));
    if (!path.isEmpty()) needs_.comparison.begin(path);
}

/// Shows the results of both runs as long as both are open.
void CompareArea::show() {
    const bool on = needs_.comparison.isOn() && needs_.feed.showsResults() && row_;
    if (!on) return end();
    if (!second_) showSecond();
    const auto first = needs_.comparison.first().run(), second = needs_.comparison.second().run();
    const QString title = runTitle(needs_.comparison.store());
    second_->caption->setText(title);
    second_->firstCaption->setText(runTitle(needs_.runs.shown()));
    needs_.feed.shareRanges(second, true);
    second_->feed.shareRanges(first, false);
    for (Curves* curves : {curves_, energies_}) curves->setOther(second, title);
}

void CompareArea::showSecond() {
    second_ = std::make_unique<Second>(needs_);
    Canvas& canvas = *second_->canvas;
    row_->addWidget(&canvas, 1);
    connect(second_->caption, &CanvasCaption::closed, &needs_.comparison, &Comparison::end,
            Qt::QueuedConnection);  // queued, because this deletes the caption
    connect(&second_->feed, &SectionFeed::pictureChanged, &canvas, [this, &canvas] {
        const bool isFirst = !canvas.picture();
        canvas.show(second_->feed.picture());
        if (isFirst) fitBoth();
        canvas.lookAs(needs_.canvas.map());
    });
    const auto select = [this, &canvas] {
        const int bolt = second_->choice.bolt();
        canvas.setSelectedBolts(bolt >= 0 ? std::vector<int>{bolt} : std::vector<int>{});
    };
    connect(&second_->choice, &BoltChoice::changed, &canvas, select);
    connect(&needs_.canvas, &Canvas::viewChanged, &canvas, [this, &canvas] { canvas.lookAs(needs_.canvas.map()); });
    connect(&canvas, &Canvas::viewChanged, &needs_.canvas, [this, &canvas] {
        if (canvas.picture()) needs_.canvas.lookAs(canvas.map());
    });
    connect(&canvas, &Canvas::spaceTapped, &needs_.canvas, &Canvas::spaceTapped);
    canvas.QWidget::show();
    select();
}

/// Fits both canvases to the common extent of both runs. Deferred until the canvases have their sizes.
void CompareArea::fitBoth() {
    QTimer::singleShot(0, this, [this] {
        const auto &first = needs_.canvas.picture(), &second = second_ ? second_->canvas->picture() : first;
        if (!first || !second) return;
        needs_.canvas.zoomTo({first->window.min.cwiseMin(second->window.min),
                              first->window.max.cwiseMax(second->window.max)});
    });
}

void CompareArea::end() {
    if (!second_) return;
    second_.reset();
    fitBoth();
    needs_.feed.shareRanges(nullptr, true);
    for (Curves* curves : {curves_, energies_}) curves->setOther(nullptr, {});
}

}  // namespace keyblock
