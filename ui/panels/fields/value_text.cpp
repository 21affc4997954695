// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/fields/value_text.h"

#include "ui/edit/typed_number.h"
#include "ui/look/display.h"
#include "ui/look/field_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace keyblock {

namespace {

struct ValueTexts {
    Q_DECLARE_TR_FUNCTIONS(ValueText)
};

/// Removes the round-off of a multiplication, so that 736.8 kN/m means exactly 736800 N/m.
double withoutRoundOff(double value) {
    return std::isfinite(value) ? QString::number(value, 'g', 15).toDouble() : value;
}

double fromShown(double shown, double factor) {
    return factor == 1.0 ? shown : withoutRoundOff(shown * (1.0 / factor));
}

/// −1 for a stress if compression is shown as positive, otherwise 1.
double signOf(const Field& field, const Display& display) {
    return field.isStress && display.compressionPositive() ? -1.0 : 1.0;
}

bool isOneOf(const QString& text, const QStringList& list) { return list.contains(text, Qt::CaseInsensitive); }

bool asksForNull(const QString& text) {
    return text.isEmpty() || isOneOf(text, {"auto", "automatic", "null", "none", ValueTexts::tr("automatic")});
}

QString pointText(const Point& point, std::string_view unit, const Display& display, bool exact) {
    const auto one = [&](double x) {
        return exact ? exactNumberText(x, unit, display) : numberText(x, unit, display);
    };
    return one(point.x()) + ", " + one(point.y());
}

QString axisText(const Point& axis, const Display& display, bool exact) {
    if (axis == Point(1.0, 0.0)) return "x";
    if (axis == Point(0.0, 1.0)) return "y";
    return pointText(axis, {}, display, exact);
}

/// Reads numbers separated by semicolons or commas; surrounding brackets are ignored.
Typed<std::vector<double>> readNumbers(QString text, int count, std::string_view unit, const Display& display) {
    text = text.trimmed();
    if ((text.startsWith('(') && text.endsWith(')')) || (text.startsWith('[') && text.endsWith(']')))
        text = text.mid(1, text.size() - 2);
    const QStringList parts = text.split(text.contains(';') ? ';' : ',');
    const QString example = count == 2 ? "2.5, 0.25" : "1, 2, 3";
    if (parts.size() != count)
        return {{}, ValueTexts::tr("Enter %1 numbers, e.g. %2; with decimal commas, separate the numbers with "
                                   "semicolons")
                        .arg(count).arg(example)};
    std::vector<double> numbers;
    for (const QString& part : parts) {
        const Typed<double> number = readNumber(part, unit, display);
        if (!number.value) return {{}, number.problem};
        numbers.push_back(*number.value);
    }
    return {numbers, {}};
}

Typed<FieldValue> readPoint(const QString& text, std::string_view unit, const Display& display) {
    const auto numbers = readNumbers(text, 2, unit, display);
    if (!numbers.value) return {{}, numbers.problem};
    return {FieldValue(Point((*numbers.value)[0], (*numbers.value)[1])), {}};
}

/// The typed value times `sign`; zero never gets a sign.
double withSign(double sign, double typed) { return typed == 0.0 ? 0.0 : sign * typed; }

Typed<FieldValue> readTriple(const QString& text, double sign, std::string_view unit, const Display& display) {
    const auto numbers = readNumbers(text, 3, unit, display);
    if (!numbers.value) return {{}, numbers.problem};
    Stress stress{};
    for (std::size_t i = 0; i < stress.size(); ++i) stress[i] = withSign(sign, (*numbers.value)[i]);
    return {FieldValue(stress), {}};
}

Typed<FieldValue> readAxis(const QString& text, const Display& display) {
    if (text.compare("x", Qt::CaseInsensitive) == 0) return {FieldValue(Point(1.0, 0.0)), {}};
    if (text.compare("y", Qt::CaseInsensitive) == 0) return {FieldValue(Point(0.0, 1.0)), {}};
    auto typed = readPoint(text, {}, display);
    if (!typed.value) typed.problem = ValueTexts::tr("Enter x, y, or a direction as two numbers, e.g. 1, 0.5");
    return typed;
}

Typed<FieldValue> readPlace(const QString& text, std::string_view unit, const Display& display) {
    if (isOneOf(text, {"head", ValueTexts::tr("head")})) return {FieldValue(BoltPlace{true, 0.0}), {}};
    const Typed<double> number = readNumber(text, unit, display);
    if (!number.value) return {{}, number.problem};
    return {FieldValue(BoltPlace{false, *number.value}), {}};
}

Typed<FieldValue> readInteger(const QString& text, std::string_view unit, const Display& display) {
    const Typed<double> number = readNumber(text, unit, display);
    if (!number.value) return {{}, number.problem};
    if (*number.value != std::floor(*number.value) || std::abs(*number.value) > 2147483647.0)
        return {{}, ValueTexts::tr("Enter a whole number")};
    return {FieldValue(*number.value), {}};
}

}  // namespace

QString numberText(double value, std::string_view unit, const Display& display, int digits) {
    return Display::number(value * display.shown(unit).factor, digits);
}

QString exactNumberText(double value, std::string_view unit, const Display& display) {
    const double factor = display.shown(unit).factor;
    for (int digits = 6; digits < 18; ++digits) {
        const QString text = QString::number(value * factor, 'g', digits);
        if (fromShown(text.toDouble(), factor) == value) return Display::number(text.toDouble(), digits);
    }
    return Display::number(value * factor, 17);
}

Typed<double> readNumber(const QString& text, std::string_view unit, const Display& display) {
    const ShownUnit shown = display.shown(unit);
    const TypedNumber typed = typedNumber(text.toStdString(), shown.symbol.toStdString());
    if (!typed.value) return {{}, QString::fromStdString(typed.problem)};
    return {fromShown(*typed.value, shown.factor), {}};
}

QString valueText(const FieldValue& value, const Field& field, std::string_view unit, const Display& display,
                  bool exact) {
    const double sign = signOf(field, display);
    const auto number = [&](double x) {
        return exact ? exactNumberText(sign * x, unit, display) : numberText(sign * x, unit, display);
    };
    if (const auto* text = std::get_if<std::string>(&value)) return QString::fromStdString(*text);
    if (const auto* x = std::get_if<double>(&value)) return number(*x);
    if (const auto* place = std::get_if<BoltPlace>(&value)) return place->head ? ValueTexts::tr("head") : number(place->s);
    if (const auto* point = std::get_if<Point>(&value))
        return field.kind == FieldKind::Axis ? axisText(*point, display, exact)
                                             : pointText(*point, unit, display, exact);
    if (const auto* stress = std::get_if<Stress>(&value))
        return QStringList{number((*stress)[0]), number((*stress)[1]), number((*stress)[2])}.join(", ");
    return {};
}

Typed<FieldValue> readValue(const QString& typedText, const Field& field, std::string_view unit,
                            const Display& display) {
    const QString text = typedText.trimmed();
    if (field.nullable && asksForNull(text)) return {FieldValue(), {}};
    switch (field.kind) {
        case FieldKind::Text:
        case FieldKind::Word: return {FieldValue(text.toStdString()), {}};
        case FieldKind::Integer: return readInteger(text, unit, display);
        case FieldKind::Vector: return readPoint(text, unit, display);
        case FieldKind::Axis: return readAxis(text, display);
        case FieldKind::Triple: return readTriple(text, signOf(field, display), unit, display);
        case FieldKind::Place: return readPlace(text, unit, display);
        default: break;
    }
    const Typed<double> number = readNumber(text, unit, display);
    if (!number.value) return {{}, number.problem};
    return {FieldValue(withSign(signOf(field, display), *number.value)), {}};
}

QString summaryOf(const FieldValue& value, const Field& field, std::string_view unit, const Display& display) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? ValueTexts::tr("yes") : ValueTexts::tr("no");
    if (const auto* points = std::get_if<std::vector<Point>>(&value))
        return points->size() == 1 ? ValueTexts::tr("1 point") : ValueTexts::tr("%1 points").arg(points->size());
    if (const auto* table = std::get_if<Table>(&value))
        return table->size() == 1 ? ValueTexts::tr("1 row") : ValueTexts::tr("%1 rows").arg(table->size());
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) {
        QStringList list;
        for (const std::string& text : *texts) list << QString::fromStdString(text);
        return list.join(", ");
    }
    if (std::holds_alternative<std::monostate>(value)) return ValueTexts::tr("automatic");
    if (const auto* word = std::get_if<std::string>(&value); word && field.kind == FieldKind::Word)
        return choiceText(field, *word);
    const QString text = valueText(value, field, unit, display);
    const QString symbol = display.shown(unit).symbol;
    return symbol.isEmpty() || unit.empty() || text.isEmpty() ? text : text + ' ' + symbol;
}

}  // namespace keyblock
