// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editors/anchor_strip.h"

#include "solver/scene/lookup.h"
#include "solver/scene/structures.h"
#include "ui/document/document.h"
#include "ui/edit/anchor_edit.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/panels/fields/object_at.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr int stripLine = 56, stripInset = 14, headRoom = 10;
constexpr double realRadius = 3.3, artificialRadius = 2.4, lineAt = 26.0;
constexpr std::size_t mostStripTicks = 6;

QFont smallFont(const QFont& base) {
    QFont font = base;
    font.setPixelSize(11);
    return font;
}

QString metres(double s) { return Display::number(std::round(1000.0 * s) / 1000.0, 4); }

}  // namespace

AnchorLine::AnchorLine(const Themes& themes, QWidget* parent) : QWidget(parent), themes_(themes) {
    setObjectName("anchorLine");
    setAccessibleName(tr("Bonded nodes"));
    setFixedHeight(stripLine);
    setMouseTracking(true);
    connect(&themes, &Themes::changed, this, QOverload<>::of(&QWidget::update));
}

void AnchorLine::present(std::vector<double> nodes, std::vector<bool> real, bool plate, bool editable) {
    if (nodes.size() != nodes_.size() || !editable) from_.reset(), to_.reset();  // a drag in progress used other nodes
    nodes_ = std::move(nodes);
    real_ = std::move(real);
    plate_ = plate;
    editable_ = editable;
    setCursor(editable ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

QPointF AnchorLine::placeOf(std::size_t i) const {
    const double room = width() - 2.0 * stripInset - headRoom;
    return {stripInset + room * nodes_[i] / nodes_.back(), lineAt};
}

std::size_t AnchorLine::nodeAt(const QPointF& pixel) const {
    const auto nearest = std::ranges::min_element(nodes_, {}, [&](const double& node) {
        return std::abs(placeOf(static_cast<std::size_t>(&node - nodes_.data())).x() - pixel.x());
    });
    return nearest - nodes_.begin();
}

bool AnchorLine::shownReal(std::size_t i) const {
    if (!from_) return real_[i];
    const auto [first, last] = std::minmax(*from_, *to_);
    return i >= first && i <= last ? !real_[*from_] : real_[i];
}

void AnchorLine::paintTicks(QPainter& painter) const {
    std::vector<std::size_t> ends;  // ends of the intervals with bonded nodes
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const bool begins = shownReal(i) && (i == 0 || !shownReal(i - 1));
        const bool stops = shownReal(i) && (i + 1 == nodes_.size() || !shownReal(i + 1));
        if (begins || stops) ends.push_back(i);
    }
    if (ends.size() > mostStripTicks) ends = {ends.front(), ends.back()};
    painter.setPen(themes_.current().text2);
    double free = 0.0;
    for (const std::size_t i : ends) {
        const QString text = metres(nodes_[i]);
        const double width = QFontMetricsF(painter.font()).horizontalAdvance(text);
        const double left = std::clamp(placeOf(i).x() - 0.5 * width, 2.0, this->width() - width - 2.0);
        if (left < free) continue;
        painter.drawText(QPointF(left, lineAt + 20.0), text);
        free = left + width + 6.0;
    }
}

void AnchorLine::paintEvent(QPaintEvent*) {
    if (nodes_.size() < 2) return;
    const Theme& t = themes_.current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(smallFont(font()));
    painter.setPen(t.text2);
    painter.drawText(QPointF(stripInset - 4.0, 12.0), tr("far end"));
    const QString head = tr("head");
    painter.drawText(QPointF(width() - stripInset - QFontMetricsF(painter.font()).horizontalAdvance(head), 12.0), head);
    painter.setPen(QPen(t.text2, 2.0));
    painter.drawLine(placeOf(0), placeOf(nodes_.size() - 1) + QPointF(headRoom - 2.0, 0.0));
    for (const bool real : {false, true})
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (shownReal(i) != real) continue;
            painter.setPen(QPen(real ? t.panel : t.markInk, 1.2));
            painter.setBrush(real ? t.markInk : t.panel);
            const double radius = real ? realRadius + 0.6 : artificialRadius;
            painter.drawEllipse(placeOf(i), radius, radius);
        }
    if (plate_)
        painter.fillRect(QRectF(placeOf(nodes_.size() - 1).x() + headRoom - 4.0, lineAt - 6.5, 4.4, 13.0), t.markInk);
    paintTicks(painter);
}

void AnchorLine::mousePressEvent(QMouseEvent* event) {
    if (!editable_ || nodes_.size() < 2 || event->button() != Qt::LeftButton) return;
    from_ = to_ = nodeAt(event->localPos());
    update();
}

void AnchorLine::mouseMoveEvent(QMouseEvent* event) {
    if (!from_) return;
    to_ = nodeAt(event->localPos());
    update();
}

void AnchorLine::mouseReleaseEvent(QMouseEvent* event) {
    if (!from_ || event->button() != Qt::LeftButton) return;
    const auto [first, last] = std::minmax(*from_, *to_);
    const bool real = !real_[*from_];
    from_.reset();
    to_.reset();
    Q_EMIT painted(first, last, real);
}

bool AnchorLine::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || nodes_.size() < 2) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const std::size_t node = nodeAt(help->pos());
    QString text =
        tr("Node %1 at %2 m: %3").arg(node).arg(metres(nodes_[node]), real_[node] ? tr("bonded") : tr("intermediate"));
    if (editable_) text += tr(". Click to toggle this node, or drag to toggle several.");
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

AnchorStrip::AnchorStrip(const FormContext& context, QWidget* parent)
    : QWidget(parent), context_(context), line_(new AnchorLine(context.themes, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(2);
    auto* heading = new QWidget(this);
    heading->setObjectName("formHeading");
    heading->setAttribute(Qt::WA_StyledBackground);
    heading->setFixedHeight(26);
    auto* row = new QHBoxLayout(heading);
    row->setContentsMargins(12, 0, 12, 0);
    auto* title = new QLabel(tr("Bonded nodes"), heading);
    title->setProperty("role", "title");
    count_ = new QLabel(heading);
    count_->setObjectName("anchorCount");
    count_->setProperty("role", "unit");
    row->addWidget(title, 1);
    row->addWidget(count_);
    hint_ = new QLabel(this);
    hint_->setProperty("role", "hint");
    hint_->setWordWrap(true);
    hint_->setContentsMargins(12, 0, 12, 0);
    column->addWidget(heading);
    column->addWidget(line_);
    column->addWidget(hint_);
    hide();
    connect(&context.document, &Document::changed, this, &AnchorStrip::refresh);
    connect(&context.document, &Document::checkedChanged, this, &AnchorStrip::refresh);
    connect(line_, &AnchorLine::painted, this, &AnchorStrip::apply);
}

void AnchorStrip::setObject(const std::string& pointer) {
    pointer_ = pointer;
    refresh();
}

/// Positions of the nodes: as laid out by the check if it belongs to this scene, otherwise evenly spaced.
std::vector<double> AnchorStrip::nodesNow(int pattern, std::size_t bolt, double length,
                                          std::optional<int> divisions) const {
    const Checked& checked = context_.document.checked();
    if (!divisions && context_.document.checkIsCurrent() && checked.picture)
        for (const auto& shape : checked.picture->bolts) {
            const Scene& solved = checked.cut ? checked.cut->scene : *checked.scene;
            const bool known = shape.bolt >= 0 && static_cast<std::size_t>(shape.bolt) < solved.bolts.size();
            if (!known || shape.s.size() < 2) continue;
            const bool same = pattern >= 0 ? solved.bolts[shape.bolt].pattern == pattern
                                           : shape.bolt == static_cast<int>(bolt);
            if (same) return shape.s;
        }
    return evenNodes(length, divisions);
}

void AnchorStrip::refresh() {
    const Scene& scene = *context_.document.scene();
    const auto at = objectAt(scene, pointer_);
    const bool isBolt = at && at->structure == &tableOf<Bolt>();
    const bool isPattern = at && at->structure == &tableOf<ScenePattern>();
    setVisible(isBolt || isPattern);
    if (!isBolt && !isPattern) return;
    const auto* bolt = isBolt ? static_cast<const Bolt*>(at->object) : nullptr;
    const auto* pattern = isPattern ? static_cast<const ScenePattern*>(at->object) : nullptr;
    const BoltType* type = boltTypeNamed(scene, bolt ? bolt->type : pattern->type);
    const double length = bolt ? lengthOf(*bolt) : pattern->length;
    const bool sound = type && std::isfinite(length) && length > 0.0;
    line_->setVisible(sound);
    if (!sound) return hint_->setText(tr("Give the bolt a type and a length first."));
    const std::size_t index = bolt ? static_cast<std::size_t>(bolt - scene.bolts.data()) : 0;
    const int patternIndex = pattern ? static_cast<int>(pattern - scene.boltPatterns.data()) : -1;
    const std::optional<int> divisions = bolt ? bolt->divisions : pattern->divisions;
    std::vector<double> nodes = nodesNow(patternIndex, index, length, divisions);
    const auto& anchors = bolt && bolt->anchors ? *bolt->anchors : type->anchors;
    std::vector<bool> real = realNodes(anchors, nodes);
    const auto count = std::ranges::count(real, true);
    const auto rest = static_cast<std::ptrdiff_t>(real.size()) - count;
    count_->setText(tr("%1 bonded · %2 intermediate").arg(count).arg(rest));
    const PlateKind plate = bolt ? bolt->plate : pattern->plate;
    line_->present(std::move(nodes), std::move(real), plate != PlateKind::None, bolt != nullptr);
    hint_->setText(
        pattern ? tr("Set by the bolt type. Only bolts that are not in a pattern can have their own bonded nodes.")
        : bolt->anchors
            ? tr("Set for this bolt. Click a node to toggle it, or drag along the bolt to toggle several.")
            : tr("Set by the bolt type. Click a node to toggle it, or drag along the bolt to toggle several."));
}

void AnchorStrip::apply(std::size_t first, std::size_t last, bool real) {
    Scene after = *context_.document.scene();
    const auto at = objectAt(after, pointer_);
    if (!at || at->structure != &tableOf<Bolt>()) return;
    const std::size_t index = static_cast<const Bolt*>(at->object) - after.bolts.data();
    Bolt& bolt = after.bolts[index];
    const BoltType* type = boltTypeNamed(after, bolt.type);
    if (!type) return;
    const Anchor otherwise = type->anchors.empty() ? Anchor{} : type->anchors.front();
    bolt.anchors =
        withNodes(bolt.anchors ? *bolt.anchors : type->anchors, line_->nodes(), first, last, real, otherwise);
    const QString name = QString::fromStdString(bolt.name);
    const QString step = real ? tr("Set nodes of %1 to bonded") : tr("Set nodes of %1 to unbonded");
    context_.document.apply(step.arg(name), std::move(after));
}

}  // namespace keyblock
