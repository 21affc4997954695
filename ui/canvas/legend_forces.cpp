// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/legend_forces.h"

#include "ui/canvas/call_out.h"
#include "ui/canvas/view_theme.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/picture/ticks.h"
#include "ui/view/screen_sizes.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double forceTitleRow = 22.0, forceRow = 19.0, noteRow = 15.0;  // [px]
constexpr int noteSize = 11;  // font size [px]

struct ForceTexts {
    Q_DECLARE_TR_FUNCTIONS(Legend)
};

QString nameOf(ContactKind kind) {
    switch (kind) {
        case ContactKind::Locked: return ForceTexts::tr("Locked");
        case ContactKind::Sliding: return ForceTexts::tr("Sliding");
        case ContactKind::Bonded: return ForceTexts::tr("Bonded");
        case ContactKind::Pulled: return ForceTexts::tr("Bonded, in tension");
    }
    return {};
}

/// Breaks the text between words into lines not longer than `width`.
QStringList broken(const QString& note, double width) {
    const QFontMetricsF metrics(screenFont(noteSize));
    QStringList lines{QString()};
    for (const QString& word : note.split(' ')) {
        const QString longer = lines.last().isEmpty() ? word : lines.last() + ' ' + word;
        if (lines.last().isEmpty() || metrics.horizontalAdvance(longer) <= width) lines.last() = longer;
        else lines << word;
    }
    return lines;
}

QString beginning(QString note) {
    if (!note.isEmpty()) note[0] = note[0].toUpper();
    return note;
}

/// Notes below the entry. The text does not name the colour of compression crosses: it is the text colour of the theme,
/// which is not always dark.
QStringList notesOf(const ArrowField& field, double width) {
    const bool isCross = !field.marks.empty() && field.marks.front().shape != ArrowShape::Arrow;
    QStringList notes;
    if (isCross) notes += broken(ForceTexts::tr("Compression; tension in red"), width);
    else for (const std::string& note : field.notes) notes += broken(beginning(qt(note)), width);
    const QString largest =
        ForceTexts::tr("Largest in this frame: %1 %2").arg(qt(numberText(field.largest)), qt(field.unit));
    return notes + broken(largest, width);
}

QStringList notesOf(const ContactField& field, double width) {
    QStringList notes = broken(ForceTexts::tr("Largest in this frame: %1 %2 (out-of-plane thickness %3 m)")
                                   .arg(qt(numberText(field.largest)), qt(field.unit), qt(numberText(field.thickness))),
                               width);
    if (field.scale.largest > field.scale.longest) notes += broken(ForceTexts::tr("Longer lines are clipped"), width);
    for (const std::string& note : field.notes) notes += broken(beginning(qt(note)), width);
    return notes;
}

void paintTitle(QPainter& painter, const Theme& theme, const QString& title, const QString& unit, const QPointF& at,
                double width) {
    painter.setFont(screenFont(11));
    painter.setPen(theme.text2);
    painter.drawText(QRectF(at, QSizeF(width, 16.0)), Qt::AlignVCenter | Qt::AlignRight, unit);
    painter.setFont(screenFont(12, true));
    painter.setPen(theme.text);
    painter.drawText(QRectF(at, QSizeF(width - 40.0, 16.0)), Qt::AlignVCenter, title);
}

void paintNotes(QPainter& painter, const Theme& theme, const QStringList& notes, const QPointF& at, double width) {
    painter.setFont(screenFont(noteSize));
    painter.setPen(theme.text2);
    QRectF line(at, QSizeF(width, noteRow));
    for (const QString& note : notes) {
        painter.drawText(line, Qt::AlignVCenter, note);
        line.translate(0.0, noteRow);
    }
}

void paintLine(QPainter& painter, const QColor& colour, double width, const QPointF& from, const QPointF& to) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
}

void paintContact(QPainter& painter, const Theme& theme, ContactKind kind, const QPointF& from, double length,
                  double width) {
    const QPointF to = from + QPointF(length, 0.0), gap(0.35 * length, 0.0);
    const QColor bearing = qtColour((theme.dark ? slateDark : slate).back());
    switch (kind) {
        case ContactKind::Locked: return paintLine(painter, bearing, width, from, to);
        case ContactKind::Sliding:
            paintLine(painter, theme.markInk, width + 1.2, from, to);
            return paintLine(painter, theme.slipping, width, from, to);
        case ContactKind::Bonded:
            paintLine(painter, bearing, width, from, to);
            return paintLine(painter, bearing, width + 2.0, 0.5 * (from + to), 0.5 * (from + to) + QPointF(0.01, 0.0));
        case ContactKind::Pulled:
            paintLine(painter, theme.error, width, from, from + gap);
            return paintLine(painter, theme.error, width, to - gap, to);
    }
}

template <class Field>
QStringList notesOf(const Field& field, double width, ForceNotes notes) {
    return notes == ForceNotes::Shown ? notesOf(field, width) : QStringList();
}

double notesHeight(const QStringList& notes) { return noteRow * static_cast<double>(notes.size()); }

}  // namespace

double legendArrowsHeight(const ArrowField& field, double width, ForceNotes notes) {
    return forceTitleRow + forceRow + notesHeight(notesOf(field, width, notes));
}

void paintLegendArrows(QPainter& painter, const Theme& theme, const ArrowField& field, const QPointF& at, double width,
                       ForceNotes notes) {
    paintTitle(painter, theme, qt(field.title), qt(field.unit), at, width);
    double shown = roundHalvable(0.45 * std::max(field.largest, 1e-300));
    if (shown > field.largest) shown *= 0.5;
    const double length = shown * arrowScale(field) * pixelsPerMm;
    const QPointF from = at + QPointF(2.0, forceTitleRow + 0.5 * forceRow - 2.0), to = from + QPointF(length, 0.0);
    paintLine(painter, theme.markInk, 1.3, from, to);
    if (!field.marks.empty() && field.marks.front().shape == ArrowShape::Arrow)
        for (const double side : {-1.0, 1.0}) paintLine(painter, theme.markInk, 1.3, to, to + QPointF(-5.0, 2.3 * side));
    painter.setFont(screenFont(noteSize));
    painter.setPen(theme.text);
    painter.drawText(QRectF(to.x() + 10.0, at.y() + forceTitleRow - 2.0, width, forceRow), Qt::AlignVCenter,
                     qt(numberText(shown)) + ' ' + qt(field.unit));
    paintNotes(painter, theme, notesOf(field, width, notes), at + QPointF(0.0, forceTitleRow + forceRow), width);
}

double legendContactsHeight(const ContactField& field, double width, ForceNotes notes) {
    const auto kinds = static_cast<double>((field.scale.kinds.size() + 1) / 2);
    return forceTitleRow + (field.scale.longest > 0.0 ? forceRow * (1.0 + kinds) : 0.0) +
           notesHeight(notesOf(field, width, notes));
}

void paintLegendContacts(QPainter& painter, const Theme& theme, const ContactField& field, double scale,
                         const QPointF& at, double width, ForceNotes notes) {
    paintTitle(painter, theme, ForceTexts::tr("Contact force"), qt(field.unit), at, width);
    QPointF below = at + QPointF(0.0, forceTitleRow - 2.0);
    if (field.scale.longest > 0.0) {
        const double longest = longestContactLine(field.scale.spacing * scale / pixelsPerMm);
        const auto sample = [&](ContactKind kind, double force, const QPointF& corner, const QString& label) {
            const double length = pixelsPerMm * contactLength(field.scale, force, longest);
            paintContact(painter, theme, kind, corner + QPointF(4.0, 0.5 * forceRow), length,
                         pixelsPerMm * contactWidth(field.scale, force, longest));
            painter.setFont(screenFont(noteSize));
            painter.setPen(theme.text);
            painter.drawText(QRectF(corner.x() + length + 12.0, corner.y(), width, forceRow), Qt::AlignVCenter, label);
        };
        const double column = 0.5 * width;
        for (const double part : {1.0, 0.25})
            sample(ContactKind::Locked, part * field.scale.longest, below + QPointF(part < 1.0 ? column : 0.0, 0.0),
                   qt(numberText(part * field.scale.longest)) + ' ' + qt(field.unit));
        for (std::size_t i = 0; i < field.scale.kinds.size(); ++i)
            sample(field.scale.kinds[i], 0.5 * field.scale.longest,
                   below + QPointF(i % 2 ? column : 0.0, forceRow * static_cast<double>(1 + i / 2)),
                   nameOf(field.scale.kinds[i]));
        below.ry() += forceRow * static_cast<double>(1 + (field.scale.kinds.size() + 1) / 2);
    }
    paintNotes(painter, theme, notesOf(field, width, notes), below + QPointF(0.0, 2.0), width);
}

}  // namespace keyblock
