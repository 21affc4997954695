// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/bolt_strip.h"

#include "solver/results/bolt_use.h"
#include "solver/results/result_names.h"
#include "ui/canvas/screen_marks.h"
#include "ui/docks/chart_view.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/picture/section/shown_numbers.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

constexpr int bandRoom = 46;  // [px] height of the band above the curves
constexpr double zoneTop = 16.0, zoneHeight = 26.0;  // [px] within the band
constexpr int leastBetween = 150;  // [ms] between two redraws during a run
constexpr std::size_t manyMarks = 24;
constexpr std::size_t mostRead = 240;  // frames read from a stored run, evenly spaced
constexpr ChartLayout strip{15.0, 15.0, 1.2, true};

struct PanelChoice {
    const char* text;
    std::vector<BoltQuantity> quantities;  // none: all
};

const std::vector<PanelChoice>& panelChoices() {
    static const std::vector<PanelChoice> all{
        {QT_TRANSLATE_NOOP("keyblock::BoltStrip", "N · bond · slip"),
         {BoltQuantity::AxialForce, BoltQuantity::AnchorForce, BoltQuantity::Slip}},
        {QT_TRANSLATE_NOOP("keyblock::BoltStrip", "N · Q · M"),
         {BoltQuantity::AxialForce, BoltQuantity::ShearForce, BoltQuantity::Moment}},
        {QT_TRANSLATE_NOOP("keyblock::BoltStrip", "all"), {}}};
    return all;
}

/// Shortens the title so that it fits next to the panel.
void shorten(ChartPanel& panel) {
    if (!panel.bolts) return;
    const std::size_t unit = panel.title.rfind(" (");
    panel.title = std::string(rowOf(*panel.bolts).brief) + (unit == std::string::npos ? "" : panel.title.substr(unit));
}

}  // namespace

struct BoltStrip::Past {
    std::shared_ptr<const LiveRun> run;
    BoltReach reach;
    bool read = false;
    int held = -1;  // the most loaded bolt, unless another is selected
    bool ofAll = false;  // true if the reach covers the whole run

    /// Reads frames of a stored run, but only once; stops if the result is no longer wanted.
    void readStored(std::size_t count, const std::atomic<bool>& stop) {
        if (std::exchange(read, true)) return;
        const std::size_t some = std::min(count, mostRead);
        for (std::size_t i = 0; i < some && !stop; ++i)
            reach.add(run->frame(some == 1 ? 0 : i * (count - 1) / (some - 1)));
    }
};

BoltStrip::BoltStrip(const Themes& themes, const Display& display, TimeCursor& cursor, BoltChoice& choice,
                     QWidget* parent)
    : QWidget(parent), themes_(themes), display_(display), cursor_(cursor), choice_(choice), view_(new ChartView(themes, this)),
      more_(new QToolButton(this)) {
    setObjectName("boltStrip");
    setAccessibleName(tr("Bolt diagram"));
    more_->setObjectName("stripMore");
    more_->setAccessibleName(tr("Choose bolt and quantities"));
    more_->setToolTip(more_->accessibleName());
    more_->setPopupMode(QToolButton::InstantPopup);
    more_->setFixedSize(24, 22);
    auto* menu = new QMenu(more_);
    more_->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, bandRoom, 0, 2);
    column->addWidget(view_, 1);
    view_->setRoom(strip);
    const auto showIcon = [this] {
        more_->setIcon(themes_.icon("more"));
        update();
    };
    showIcon();
    connect(&themes, &Themes::changed, this, showIcon);
    connect(view_, &ChartView::redrawn, this, QOverload<>::of(&QWidget::update));
    connect(&display, &Display::changed, this, &BoltStrip::make);
    connect(&cursor, &TimeCursor::runChanged, this, &BoltStrip::runChanged);
    connect(&cursor, &TimeCursor::moved, this, &BoltStrip::make);
    later_.setSingleShot(true);
    connect(&later_, &QTimer::timeout, this, &BoltStrip::make);
    connect(&choice, &BoltChoice::changed, this, &BoltStrip::make);
    runChanged();
}

BoltStrip::~BoltStrip() = default;

void BoltStrip::showEvent(QShowEvent*) { make(); }

void BoltStrip::resizeEvent(QResizeEvent*) { more_->move(width() - more_->width() - 8, 2); }

QString BoltStrip::title() const {
    if (!shown_) return {};
    const QString text =
        QStringLiteral("%1 · %2 · %3 m").arg(shown_->name, shown_->type, Display::number(shown_->chart.length, 3));
    return shown_->use.isEmpty() ? text : text + QStringLiteral(" · ") + shown_->use;
}

void BoltStrip::runChanged() {
    past_.reset();
    showNothing(tr("Run the scene, then select a bolt to see its forces along the bar."));
    make();
}

void BoltStrip::showNothing(const QString& why) {
    shown_.reset();
    view_->clear(why);
    update();
    Q_EMIT titleChanged();
}

void BoltStrip::fillMenu(QMenu& menu) {
    menu.clear();
    for (std::size_t i = 0; i < panelChoices().size(); ++i) {
        QAction* action = menu.addAction(tr(panelChoices()[i].text), this, [this, i] {
            panels_ = i;
            make();
        });
        action->setCheckable(true);
        action->setChecked(i == panels_);
    }
    if (!cursor_.run()) return;
    menu.addSeparator();
    const Scene& scene = cursor_.run()->scene();
    const int wanted = choice_.bolt();
    QAction* most = menu.addAction(tr("Most loaded bolt"), this, [this] { choice_.choose(-1); });
    most->setCheckable(true);
    most->setChecked(wanted < 0);
    constexpr std::size_t mostListed = 40;
    for (std::size_t b = 0; b < std::min(scene.bolts.size(), mostListed); ++b) {
        QAction* action = menu.addAction(asMenuText(QString::fromStdString(boltName(scene, static_cast<int>(b)))), this,
                                         [this, b] { choice_.choose(static_cast<int>(b)); });
        action->setCheckable(true);
        action->setChecked(static_cast<int>(b) == wanted);
    }
}

/// Recreates axes and curves. During a run it is called more often than the diagram needs to be redrawn, so calls are
/// delayed and combined.
void BoltStrip::make() {
    if (cursor_.isLive() && made_.isValid() && made_.elapsed() < leastBetween) {
        if (!later_.isActive()) later_.start(leastBetween - static_cast<int>(made_.elapsed()));
        return;
    }
    made_.start();
    if (!isVisible() || !cursor_.hasMoment() || cursor_.run()->scene().bolts.empty()) {
        if (cursor_.run() && cursor_.run()->scene().bolts.empty()) view_->clear(tr("The scene has no bolts."));
        return;
    }
    const std::vector<BoltQuantity> wantedPanels = panelChoices()[panels_].quantities;
    const std::size_t stored = cursor_.goesOn() ? 0 : cursor_.run()->frames().size();
    painting_.ask([this, moment = cursor_.moment(), run = cursor_.run(), past = past_, wanted = choice_.bolt(),
                   wantedPanels, stored, numbers = display_.numbers()]() -> Background::Result {
        try {
            const auto frame = moment->sharedFrame();
            const bool isSame = past && past->run == run;
            int held = isSame ? past->held : -1;
            if (stored == 0) held = mostLoadedBolt(*frame, held);
            else if (!isSame || !past->ofAll) held = mostLoadedBolt(run->frame(stored - 1));
            const int bolt = wanted >= 0 ? wanted : held;
            if (bolt < 0 || frame->bolts[bolt].nodes.size() < 2)
                return [this] { showNothing(tr("The bolt is not installed at this time.")); };
            std::shared_ptr<Past> known = past;
            if (!known || known->run != run || known->reach.bolt() != bolt)
                known = std::make_shared<Past>(Past{run, BoltReach(bolt)});
            known->held = held;
            known->ofAll = stored > 0;
            if (stored > 0) known->readStored(stored, painting_.ends());
            known->reach.add(*frame);
            auto shown = std::make_shared<Shown>();
            shown->chart = boltChart(*moment, 0, known->reach);
            std::erase_if(shown->chart.chart.panels, [&](const ChartPanel& panel) {
                return !wantedPanels.empty() &&
                       std::ranges::none_of(wantedPanels, [&](BoltQuantity of) { return panel.bolts == of; });
            });
            showAs(shown->chart.chart, numbers);
            for (ChartPanel& panel : shown->chart.chart.panels) shorten(panel);
            shown->chart.chart.xTitle.clear();
            for (const BoltNodeFrame& node : frame->bolts[bolt].nodes)
                shown->blocks.emplace_back(node.s, blockName(moment->blockNames(), node.block));
            shown->name = QString::fromStdString(boltName(moment->scene(), bolt));
            shown->type = QString::fromStdString(moment->scene().bolts[bolt].type);
            if (const std::size_t row = bolt; row < frame->extremes.size())
                shown->use = QString::fromStdString(useText(boltUse(bolt, frame->extremes[row])));
            return [this, shown, known] {
                if (cursor_.run() != known->run) return;
                past_ = known;
                take(shown);
            };
        } catch (const std::exception& error) {
            return [this, text = QString::fromStdString(error.what())] { showNothing(text); };
        }
    });
}

void BoltStrip::take(std::shared_ptr<const Shown> shown) {
    shown_ = std::move(shown);
    if (shown_->chart.chart.panels.empty()) view_->clear(tr("No forces act on this bolt yet."));
    else view_->show(shown_->chart.chart);
    update();
    Q_EMIT titleChanged();
}

void BoltStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    if (!shown_ || !view_->chart()) return;
    view_->prepare();
    if (!view_->isDrawn()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(view_->x(), view_->y() - bandRoom);
    paintBlocks(painter);
    paintBand(painter);
    paintFronts(painter);
}

/// Names the blocks that the bolt crosses and tints the slipping intervals.
void BoltStrip::paintBlocks(QPainter& painter) const {
    const Theme& theme = themes_.current();
    const double left = view_->xOf(0.0), right = view_->xOf(shown_->chart.length);
    if (right <= left) return;
    painter.fillRect(QRectF(left, zoneTop, right - left, zoneHeight), theme.rock);
    for (const ChartZone& zone : shown_->chart.chart.zones) {
        QColor tint = theme.slipping;
        tint.setAlphaF(0.3);
        painter.fillRect(QRectF(view_->xOf(zone.from), zoneTop, view_->xOf(zone.to) - view_->xOf(zone.from), zoneHeight),
                         tint);
    }
    QFont font = painter.font();
    font.setPixelSize(11);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    std::vector<double> places = shown_->chart.chart.dividers;
    places.insert(places.begin(), 0.0);
    places.push_back(shown_->chart.length);
    painter.setPen(theme.text2);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        std::string name;
        for (const auto& [s, block] : shown_->blocks)
            if (name.empty() && s >= places[i] && s <= places[i + 1]) name = block;
        const double from = view_->xOf(places[i]), to = view_->xOf(places[i + 1]);
        if (name.empty() || to - from < 30.0) continue;
        painter.drawText(QRectF(from + 3.0, 0.0, to - from - 6.0, zoneTop), Qt::AlignCenter,
                         metrics.elidedText(QString::fromStdString(name), Qt::ElideRight, to - from - 6.0));
    }
    painter.setPen(theme.text3);
    painter.drawText(QRectF(0.0, zoneTop, left - 8.0, zoneHeight), Qt::AlignRight | Qt::AlignVCenter, tr("far end"));
    painter.drawText(QRectF(right + 18.0, zoneTop, 60.0, zoneHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("head"));
}

/// Paints the marks of the bolt. Marks that would overlap are left out, except those of failures.
void BoltStrip::paintBand(QPainter& painter) const {
    const double y = zoneTop + 0.5 * zoneHeight, left = view_->xOf(0.0), right = view_->xOf(shown_->chart.length);
    painter.setPen(QPen(themes_.current().text3, 2.0));
    painter.drawLine(QPointF(left, y), QPointF(right, y));
    const MarkTheme theme = screenMarks(themes_.current());
    const double perMetre = (right - left) / std::max(shown_->chart.length, 1e-9);
    const bool small = shown_->chart.band.size() > manyMarks;
    for (const Mark& mark : thinned(shown_->chart.band, (small ? 7.5 : 9.5) / perMetre))
        paintMark(painter, mark.kind, {view_->xOf(mark.s), y}, {1.0, 0.0}, small, theme);
}

/// Paints lines through all curves at the slip fronts and dotted lines at joints.
void BoltStrip::paintFronts(QPainter& painter) const {
    const Theme& theme = themes_.current();
    painter.setPen(QPen(theme.text, 1.2));
    for (const ChartZone& zone : shown_->chart.chart.zones)
        for (const double s : {zone.from, zone.to})
            painter.drawLine(QPointF(view_->xOf(s), zoneTop - 1.0), QPointF(view_->xOf(s), bandRoom));
    QPen dotted(theme.text, 1.2);
    dotted.setDashPattern({1.5, 2.0});
    painter.setPen(dotted);
    for (const double s : shown_->chart.chart.dividers)
        painter.drawLine(QPointF(view_->xOf(s), zoneTop - 1.0), QPointF(view_->xOf(s), bandRoom));
}

}  // namespace keyblock
