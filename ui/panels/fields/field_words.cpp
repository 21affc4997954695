// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/fields/field_words.h"

#include "ui/look/field_text.h"

#include <QCoreApplication>

namespace keyblock {

namespace {

struct WordTexts {
    Q_DECLARE_TR_FUNCTIONS(FieldWords)
};

QString capitalised(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

}  // namespace

QString fromUtf8(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

QString labelOf(const Field& field) {
    return field.label.empty() ? QString::fromStdString(labelText(field)) : shownText(field.label);
}

QString labelOf(const Field& field, const Display& display) {
    if (!field.isStress) return labelOf(field);
    const QString sign = display.compressionPositive() ? WordTexts::tr("compression +") : WordTexts::tr("tension +");
    return QString("%1 (%2)").arg(labelOf(field), sign);
}

QString titleOf(const Structure& structure) { return capitalised(fromUtf8(structure.name)); }

QString countedOf(const Structure& structure, int count) {
    QString name = fromUtf8(structure.name);
    if (count != 1) name = name.endsWith('y') ? name.chopped(1) + "ies" : name.endsWith('s') ? name : name + 's';
    return QString("%1 %2").arg(count).arg(name);
}

QString headingOf(const Structure& structure, const Field& field) {
    return field.heading.empty() ? titleOf(structure) : shownText(field.heading);
}

std::string_view unitOf(const ObjectAt& at, const Field& field) {
    return field.isModulus ? Display::modulusUnit : unitIn(field, at.object, at.owner);
}

std::vector<std::string_view> columnUnits(const ObjectAt& at, const Field& field) {
    std::vector<std::string_view> units;
    for (const PairColumn& column : field.columns) units.push_back(unitIn(field, column, at.object, at.owner));
    return units;
}

QStringList columnTitles(const Field& field) {
    QStringList titles;
    for (const PairColumn& column : field.columns) titles << shownText(column.title);
    return titles;
}

}  // namespace keyblock
