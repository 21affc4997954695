// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas.h"

#include "ui/canvas/canvas_sheet.h"
#include "ui/canvas/display_check.h"
#include "ui/canvas/legend_panel.h"
#include "ui/canvas/section_widget.h"
#include "ui/canvas/view_theme.h"
#include "ui/canvas/without_gl.h"
#include "ui/look/theme.h"

#include <QPainter>
#include <QResizeEvent>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double rimOfRoom = 12.0;  // margin of a fitted view [px]
constexpr double stepOfFitted = 0.08;  // smallest growth of a fitted view, as a fraction of its extent
constexpr double reachOfPick = 6.0;  // [px]

}  // namespace

Canvas::Canvas(const Themes& themes, QWidget* parent)
    : QWidget(parent), themes_(themes), sheet_(new CanvasSheet(*this)), timer_(new QTimer(this)) {
    setObjectName("canvas");
    setAccessibleName(tr("Section"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setHint(tr("Nothing has been drawn yet"), tr("Open a scene, or draw an outline."));
    if (const auto& missing = missingOpenGl()) withoutGl_ = makeWithoutGlPanel(*missing, this);
    else section_ = new SectionWidget(this);
    if (section_) section_->beforePaint = [this] { renderOwed(); };
    sheet_->raise();
    sheet_->setVisible(section_ != nullptr);
    timer_->setSingleShot(true);
    timer_->setInterval(0);
    connect(timer_, &QTimer::timeout, this, &Canvas::renderNow);
    connect(&themes_, &Themes::changed, this, &Canvas::sceneChanged);
}

Canvas::~Canvas() = default;

void Canvas::show(std::shared_ptr<const SectionPicture> picture) {
    const bool isFirst = picture && !picture_;
    const QRectF before = room();
    picture_ = std::move(picture);
    index_.reset();
    if (isFirst) kept_ = picture_->window;
    fitsAlone_ = fitsAlone_ || isFirst;
    const bool grew = growFitted();
    if (isFirst || grew || (kept_ && room() != before)) {  // a legend reduces the room of the fitted view
        layOut();
        Q_EMIT viewChanged();
    }
    sceneChanged();
}

/// A view that was fitted automatically grows in steps with the picture, so that the legend does not hide parts that
/// move away. \return true if it grew.
bool Canvas::growFitted() {
    if (!picture_ || !kept_ || !fitsAlone_) return false;
    const Box &shown = picture_->window, &kept = *kept_;
    if ((shown.min.array() >= kept.min.array()).all() && (shown.max.array() <= kept.max.array()).all()) return false;
    const Point low = shown.min.cwiseMin(kept.min), high = shown.max.cwiseMax(kept.max);
    const Point step = stepOfFitted * (high - low);
    kept_ = Box{(shown.min.array() < kept.min.array()).select(low - step, kept.min),
                (shown.max.array() > kept.max.array()).select(high + step, kept.max)};
    return true;
}

void Canvas::setTool(CanvasTool* tool) {
    tool_ = tool;
    held_ = Qt::NoButton;
    showCursor();
    refresh();
}

void Canvas::addOverlay(const CanvasOverlay* overlay) {
    overlays_.push_back(overlay);
    refresh();
}

void Canvas::removeOverlay(const CanvasOverlay* overlay) {
    std::erase(overlays_, overlay);
    refresh();
}

void Canvas::setDrawing(bool drawing) {
    style_.drawing = drawing;
    sceneChanged();
}

void Canvas::setSelectedBolts(const std::vector<int>& bolts) {
    if (bolts == style_.selectedBolts) return;
    style_.selectedBolts = bolts;
    sceneChanged();
}

void Canvas::setLegend(bool legend) {
    hasLegend_ = legend;
    layOut();
    sheet_->forget();
    refresh();
}

void Canvas::setHighlighted(const std::optional<HighlightedBlock>& highlighted) {
    if (highlighted == highlighted_) return;
    highlighted_ = highlighted;
    sheet_->forget();
    refresh();
}

void Canvas::setHint(const QString& title, const QString& text, bool aside) {
    hintTitle_ = title;
    hintText_ = text;
    hintAside_ = aside;
    sheet_->forget();
    refresh();
}

QRectF Canvas::room() const {
    const bool explains = picture_ && hasLegend_ && !style_.drawing &&
                          (picture_->blockLegend || picture_->boltLegend || picture_->activity);
    const QMarginsF legend = explains ? legendRoom(themes_.current(), {*picture_, nullptr, {}}, size()) : QMarginsF();
    return QRectF(rect()).marginsRemoved(legend).adjusted(rimOfRoom, rimOfRoom, -rimOfRoom, -rimOfRoom);
}

void Canvas::fit() {
    if (!picture_ && extent_) zoomTo(*extent_);
    if (!picture_) return;
    CanvasMap about = map_;
    about.show(picture_->window, room());
    const double off = (about.centre() - map_.centre()).norm() * map_.pixelsPerMetre();
    const bool isSeen = off < 1.0 && std::abs(about.pixelsPerMetre() / map_.pixelsPerMetre() - 1.0) < 1e-3;
    zoomTo(isSeen ? picture_->model : picture_->window);
    fitsAlone_ = true;
}

void Canvas::zoomTo(const Box& box) {
    kept_ = box;
    fitsAlone_ = false;
    map_.show(box, room());
    mapChanged();
}

void Canvas::zoomBy(double factor, const QPointF& pixel) {
    kept_.reset();
    map_.zoomBy(factor, pixel);
    mapChanged();
}

void Canvas::panBy(const QPointF& pixels) {
    kept_.reset();
    map_.panBy(pixels);
    mapChanged();
}

void Canvas::lookAs(const CanvasMap& other) {
    if (map_.centre() == other.centre() && map_.pixelsPerMetre() == other.pixelsPerMetre()) return;
    kept_.reset();
    map_.lookAs(other);
    mapChanged();
}

std::optional<Pick> Canvas::pickAt(const QPointF& pixel) const {
    if (!picture_) return std::nullopt;
    if (!index_) index_ = std::make_unique<PickIndex>(picture_);
    return index_->at(map_.toPlace(pixel), reachOfPick / map_.pixelsPerMetre());
}

void Canvas::refresh() { sheet_->update(); }

void Canvas::layOut() {
    if (section_) section_->setGeometry(rect());
    if (withoutGl_) withoutGl_->setGeometry(rect());
    sheet_->setGeometry(rect());
    map_.resize(size());
    if (kept_ && width() > 2 * rimOfRoom && height() > 2 * rimOfRoom) map_.show(*kept_, room());
}

void Canvas::sceneChanged() {
    shapesChanged_ = true;
    sheet_->forget();
    schedule();
}

void Canvas::mapChanged() {
    sheet_->forget();
    schedule();
    Q_EMIT viewChanged();
}

/// The section is rendered after other widgets have been painted, so that the window is not busy with both at once; what
/// is painted over it follows.
void Canvas::schedule() {
    if (!section_) sheet_->update();
    else if (!timer_->isActive()) timer_->start();
}

/// Applies pending changes before painting.
void Canvas::renderOwed() {
    if (!timer_->isActive()) return;
    timer_->stop();
    renderNow();
}

/// Applies all changes since the last call at once, so that ten wheel steps need only one redraw.
void Canvas::renderNow() {
    if (!section_ || !isVisible()) return;
    const ViewColours colours = viewColoursOf(themes_.current(), style_.drawing);
    if (shapesChanged_) {
        style_.pixelRatio = devicePixelRatioF();
        if (picture_) section_->view().show(*picture_, colours, style_);
        else section_->view().clear(colours);
        shapesChanged_ = false;
    }
    section_->render(map_.centre(), map_.pixelsPerMetre(), picture_.get());
    sheet_->update();
}

bool Canvas::event(QEvent* event) {
    if (event->type() == QEvent::Show || event->type() == QEvent::ScreenChangeInternal) sceneChanged();
    // Otherwise a shortcut of the window would take Space before it could start a pan.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space &&
        static_cast<QKeyEvent*>(event)->modifiers() == Qt::NoModifier)
        event->accept();
    return QWidget::event(event);
}

void Canvas::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) sceneChanged();
}

void Canvas::resizeEvent(QResizeEvent*) {
    layOut();
    mapChanged();
}

void Canvas::paintEvent(QPaintEvent*) {
    QPainter(this).fillRect(rect(), themes_.current().canvas);
}

}  // namespace keyblock
