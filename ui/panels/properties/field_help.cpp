// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/properties/field_help.h"

#include "ui/look/display.h"
#include "ui/look/field_text.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/value_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace keyblock {

namespace {

struct HelpTexts {
    Q_DECLARE_TR_FUNCTIONS(FieldHelp)
};

QString numberWithUnit(const QString& number, const QString& symbol) {
    return symbol.isEmpty() || symbol == QString::fromUtf8("°") ? number + symbol : number + ' ' + symbol;
}

QString rangeWords(const Range& range, std::string_view unit, const Display& display) {
    const bool below = std::isfinite(range.least) && std::abs(range.least) < 1e9;
    const bool above = std::isfinite(range.most) && std::abs(range.most) < 1e9;
    const auto number = [&](double x) { return numberText(x, unit, display); };
    const QString symbol = unit.empty() ? QString() : display.shown(unit).symbol;
    if (below && above)
        return numberWithUnit(QString::fromUtf8("%1 … %2").arg(number(range.least), number(range.most)), symbol);
    if (below) return numberWithUnit((range.leastExcluded ? "> " : QString::fromUtf8("≥ ")) + number(range.least), symbol);
    if (above) return numberWithUnit((range.mostExcluded ? "< " : QString::fromUtf8("≤ ")) + number(range.most), symbol);
    return {};
}

QString fallbackText(const FormRow& row, std::string_view unit, const FormContext& context) {
    if (!std::holds_alternative<std::monostate>(row.fallback))
        return summaryOf(row.fallback, *row.field, unit, context.display);
    if (!row.field->nullText.empty()) return shownText(row.field->nullText);
    const QString automatic = automaticText(row, context);
    return automatic.isEmpty() ? summaryOf(row.fallback, *row.field, unit, context.display)
                               : HelpTexts::tr("automatic (%1)").arg(automatic);
}

}  // namespace

QString plainHelp(std::string_view help) {
    QString text = fromUtf8(help);
    text.remove('`');
    text.replace(QRegularExpression("\\b[Nn]ull: "), HelpTexts::tr("automatic: "));
    text.replace("; automatic: ", HelpTexts::tr("; automatic: "));
    return text;
}

QString outOfRange(const FormRow& row, const FieldValue& value, const FormContext& context) {
    const std::string_view unit = unitOf(row.at, *row.field);
    const auto* number = std::get_if<double>(&value);
    const auto* place = std::get_if<BoltPlace>(&value);
    if (place && place->head) return {};
    if (!number && !place) return {};
    const double held = number ? *number : place->s;
    if (contains(row.field->range, held)) return {};
    return HelpTexts::tr("%1 is out of range. Allowed: %2")
        .arg(numberText(held, unit, context.display), rangeWords(row.field->range, unit, context.display));
}

FieldHelp helpOf(const FormRow& row, const FormContext& context) {
    FieldHelp help;
    help.name = labelOf(*row.field);
    const std::string_view unit = unitOf(row.at, *row.field);
    const bool number = row.field->kind == FieldKind::Number || row.field->kind == FieldKind::Integer;
    QStringList parts;
    if (number || row.field->kind == FieldKind::Place) parts << rangeWords(row.field->range, unit, context.display);
    if (row.resettable) {
        const QString text = fallbackText(row, unit, context);
        if (!text.isEmpty()) parts << HelpTexts::tr("default: %1").arg(text);
    }
    parts.removeAll(QString());
    help.numbers = parts.join(QString::fromUtf8(" · "));
    help.text = plainHelp(row.field->help);
    if (!row.field->source.empty()) help.text += ' ' + HelpTexts::tr("Source: %1.").arg(fromUtf8(row.field->source));
    return help;
}

}  // namespace keyblock
