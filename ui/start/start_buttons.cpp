// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/start_buttons.h"

#include "ui/document/recent_files.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/start/samples.h"

#include <QFileInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QStyle>
#include <QTextLayout>

#include <cmath>

namespace keyblock {

namespace {

constexpr int arrowSide = 24, inset = 12, tipWidth = 360;  // [px]

QFont sized(const QFont& base, int pixels, bool bold = false) {
    QFont font = base;
    font.setPixelSize(pixels);
    if (bold) font.setWeight(QFont::DemiBold);
    return font;
}

/// Draws one line of text, elided if it is too long. Returns its width.
int line(QPainter& painter, const QRect& place, const QString& words, const QFont& font, const QColor& colour,
         Qt::Alignment edge = Qt::AlignLeft) {
    painter.setFont(font);
    painter.setPen(colour);
    const QString shown = painter.fontMetrics().elidedText(words, Qt::ElideRight, place.width());
    painter.drawText(place, int(edge | Qt::AlignVCenter), shown);
    return painter.fontMetrics().horizontalAdvance(shown);
}

/// Draws text on two lines: the first is broken between words, and the second has the rest.
void twoLines(QPainter& painter, const QRect& first, const QString& words, const QFont& font, const QColor& colour) {
    QTextLayout layout(words, font);
    layout.beginLayout();
    QTextLine top = layout.createLine();
    top.setLineWidth(first.width());
    layout.endLayout();
    line(painter, first, words.left(top.textLength()).trimmed(), font, colour);
    line(painter, first.translated(0, first.height()), words.mid(top.textLength()).trimmed(), font, colour);
}

QString counts(int blocks, int bolts) {
    const QString first = blocks == 1 ? SampleCard::tr("1 block") : SampleCard::tr("%1 blocks").arg(blocks);
    if (bolts == 0) return first;
    return first + QString::fromUtf8(" · ") + (bolts == 1 ? SampleCard::tr("1 bolt") : SampleCard::tr("%1 bolts").arg(bolts));
}

QString factsOf(const Sample& sample) {
    const QString all = counts(sample.blocks, sample.bolts);
    if (sample.seconds <= 0.0) return all;
    return all + QString::fromUtf8(" · ") + SampleCard::tr("runs in %1").arg(durationText(sample.seconds));
}

}  // namespace

QString whenText(const QDateTime& when, const QDateTime& now) {
    if (!when.isValid()) return {};
    const QLocale english(QLocale::English);
    const qint64 days = when.date().daysTo(now.date());
    if (days == 0) return SampleCard::tr("today %1").arg(when.toString("hh:mm"));
    if (days == 1) return SampleCard::tr("yesterday");
    return english.toString(when.date(), when.date().year() == now.date().year() ? "d MMM" : "d MMM yyyy");
}

QString durationText(double seconds) {
    if (seconds < 9.95) return SampleCard::tr("%1 s").arg(QString::number(seconds, 'f', 1));
    if (seconds < 99.5) return SampleCard::tr("%1 s").arg(QString::number(seconds, 'f', 0));
    return SampleCard::tr("%1 min").arg(QString::number(seconds / 60.0, 'f', 0));
}

SampleCard::SampleCard(const Sample& sample, const Themes& themes, QWidget* parent)
    : QAbstractButton(parent), themes_(themes), line_(sample.shows), facts_(factsOf(sample)) {
    setObjectName("sample." + sample.name);
    setText(sample.title);
    setAccessibleName(sample.title);
    setAccessibleDescription(sample.shows);
    setToolTip(QStringLiteral("<table width='%1'><tr><td><p>%2</p><p>%3</p></td></tr></table>")
                   .arg(QString::number(tipWidth), sample.shows.toHtmlEscaped(),
                        tr("Opens a copy. The run time on this computer may differ.").toHtmlEscaped()));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setFixedHeight(height);
    setCursor(Qt::PointingHandCursor);
}

void SampleCard::setPicture(const QImage& image) {
    image_ = image;
    update();
}

void SampleCard::paintEvent(QPaintEvent*) {
    const Theme& t = themes_.current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isOn = hasFocus() || underMouse();
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.fillPath(frame, t.panel);
    painter.setClipPath(frame);
    painter.fillRect(0, 0, width(), picture, t.canvas);
    if (!image_.isNull()) {
        const QSize size = image_.size() / image_.devicePixelRatio();
        painter.drawImage(QPoint((width() - size.width()) / 2, 0), image_);
    }
    painter.fillRect(0, picture, width(), 1, t.separator);
    painter.setClipping(false);
    painter.setPen(QPen(isOn ? t.accent : t.border, isOn ? 2 : 1));
    painter.drawPath(frame);
    const int inner = width() - 2 * inset;
    line(painter, {inset, picture + 10, inner, 18}, text(), sized(font(), 13, true), t.text);
    twoLines(painter, {inset, picture + 29, inner, 16}, line_, sized(font(), 12), t.text2);
    const int copy = isOn ? line(painter, {inset, picture + 70, inner, 16}, tr("Open copy"), sized(font(), 12, true),
                                 t.accent, Qt::AlignRight)
                          : 0;
    line(painter, {inset, picture + 70, inner - copy - 8, 16}, facts_, sized(font(), 11), t.text2);
}

RecentRow::RecentRow(const RecentFile& file, const Themes& themes, QWidget* parent)
    : QAbstractButton(parent), themes_(themes), name_(QFileInfo(file.path).fileName()), time_(whenText(file.opened)),
      exists_(QFileInfo::exists(file.path)) {
    setObjectName("recent." + name_);
    setText(file.path);
    setAccessibleName(name_);
    setAccessibleDescription(file.path);
    setToolTip(asTip(file.path));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setFixedHeight(height);
    setCursor(Qt::PointingHandCursor);
}

void RecentRow::setPicture(const QImage& image, const SceneFacts& facts) {
    image_ = image;
    facts_ = facts;
    known_ = true;
    setAccessibleDescription(factsText());
    update();
}

void RecentRow::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter) click();
    else QAbstractButton::keyPressEvent(event);
}

QString RecentRow::factsText() const {
    if (!exists_) return tr("file not found");
    if (!known_) return {};
    if (!facts_.isThere) return tr("cannot be read as a scene");
    const QString all = counts(facts_.blocks, facts_.bolts);
    const QString dot = QString::fromUtf8(" · ");
    if (facts_.errors > 0) return all + dot + (facts_.errors == 1 ? tr("1 error") : tr("%1 errors").arg(facts_.errors));
    if (facts_.warnings > 0)
        return all + dot + (facts_.warnings == 1 ? tr("1 warning") : tr("%1 warnings").arg(facts_.warnings));
    return all;
}

void RecentRow::paintEvent(QPaintEvent*) {
    const Theme& t = themes_.current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (hasFocus() || underMouse()) painter.fillRect(rect(), t.accentSoft);
    if (hasFocus()) painter.fillRect(0, 0, 2, height, t.accent);
    const QRect thumb(arrowSide, (height - thumbHeight) / 2, thumbWidth, thumbHeight);
    painter.fillRect(thumb, t.canvas);
    if (!image_.isNull()) painter.drawImage(thumb.topLeft(), image_);
    painter.setPen(t.border);
    painter.drawRect(thumb.adjusted(0, 0, -1, -1));
    const int left = thumb.right() + 13, inner = width() - arrowSide - left;
    const int right = line(painter, {left, 0, inner, height}, time_, sized(font(), 12), t.text2, Qt::AlignRight);
    const QRect name(left, 14, inner - right - 30, 18);
    const int used = line(painter, name, name_, sized(font(), 12, true), exists_ ? t.text : t.text3);
    line(painter, {left, 32, inner - right - 8, 16}, factsText(), sized(font(), 12), t.text2);
    if (!known_ && exists_) return;
    const bool isBad = !exists_ || !facts_.isThere || facts_.errors > 0;
    const QString icon = isBad ? "error" : facts_.warnings > 0 ? "warning" : "ok";
    const QColor colour = isBad ? t.error : facts_.warnings > 0 ? t.warning : t.ok;
    themes_.icon(icon, colour).paint(&painter, QRect(left + used + 6, 16, 14, 14));
}

}  // namespace keyblock
