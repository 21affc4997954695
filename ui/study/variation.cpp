// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/variation.h"

#include "solver/files/json/json_text.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/scene/overrides.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/study/case_plan.h"
#include "ui/edit/locate.h"
#include "ui/edit/names.h"
#include "ui/edit/pointer_change.h"
#include "ui/edit/values.h"
#include "ui/look/qt_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

constexpr double usualSpread = 0.1;  // standard deviation of a suggestion, as a share of the value

struct Variation {
    Q_DECLARE_TR_FUNCTIONS(Variation)
};

QString numberOf(double value) { return qt(rounded(value)); }

/// The middle and half width of the numbers that a parameter has.
struct Spread {
    double middle = 0.0, half = 1.0;
};

Spread between(double low, double high) {
    return {0.5 * (low + high), low < high ? 0.5 * (high - low) : std::max(0.2 * std::abs(low), 1e-3)};
}

Spread spreadOf(const StudyParameter& parameter) {
    if (parameter.range) return between(parameter.range->from, parameter.range->to);
    if (const auto& d = parameter.distribution) {
        const bool isNormal = d->kind == DistributionKind::Normal || d->kind == DistributionKind::Lognormal;
        if (isNormal && d->mean) return {*d->mean, 2.0 * d->deviation.value_or(usualSpread)};
        if (d->least && d->most) return between(*d->least, *d->most);
        return {};
    }
    std::vector<double> numbers;
    for (const std::string& value : parameter.values)
        if (const JsonReading json = readJson(value); json.root)
            if (const auto* number = std::get_if<double>(&json.root->value)) numbers.push_back(*number);
    if (numbers.empty()) return {};
    const auto [low, high] = std::ranges::minmax(numbers);
    return between(low, high);
}

/// A number with three digits, so that suggestions are easy to read.
double neat(double value) {
    if (value == 0.0) return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    return std::stod(rounded(std::round(value / unit) * unit));
}

StudyDistribution normalAround(double value, const Range& range) {
    StudyDistribution d;
    d.kind = DistributionKind::Normal;
    d.mean = value;
    d.deviation = value == 0.0 ? 1.0 : neat(usualSpread * std::abs(value));
    const double reach = 4.0 * *d.deviation;  // the range of the field matters only if the tails come near it
    if (range.least > value - reach) d.least = range.leastExcluded ? neat(value - 3.0 * *d.deviation) : range.least;
    if (range.most < value + reach) d.most = range.mostExcluded ? neat(value + 3.0 * *d.deviation) : range.most;
    if (d.least && (*d.least < range.least || (range.leastExcluded && *d.least <= range.least)))
        d.least = neat(0.1 * value);
    if (d.most && (*d.most > range.most || (range.mostExcluded && *d.most >= range.most)))
        d.most = neat(value + 0.9 * (range.most - value));
    return d;
}

bool isSeed(const Field& field) { return field.key == "seed" || field.key.ends_with("_seed"); }

void addChoices(StudyParameter& parameter, const Field& field, const FieldValue& value) {
    if (field.kind == FieldKind::Flag) parameter.values = {"false", "true"};
    for (const std::string_view word : field.words) parameter.values.push_back(jsonLine({std::string(word)}));
    if (const auto* text = std::get_if<std::string>(&value); text && parameter.values.empty())
        parameter.values = {jsonLine({*text})};
    if (const auto* number = std::get_if<double>(&value)) parameter.values = {shortest(*number)};
}

/// Whether a name can be part of a path without being taken for a separator.
bool isPlain(const std::string& name) { return !name.empty() && name.find_first_of("./[]~") == std::string::npos; }

/// The last two keys of a path, as in "joint.friction_angle".
std::string shortName(const std::string& path) {
    const std::size_t last = path.rfind('.');
    const std::size_t before = last == std::string::npos || last == 0 ? last : path.rfind('.', last - 1);
    return before == std::string::npos || path.front() == '/' ? path : path.substr(before + 1);
}

void addNumber(QString& text, const char* name, const std::optional<double>& value) {
    if (value) text += ", " + Variation::tr(name) + " " + numberOf(*value);
}

QString boundsText(const StudyDistribution& d) {
    if (d.least && d.most) return ", " + Variation::tr("%1 to %2").arg(numberOf(*d.least), numberOf(*d.most));
    if (d.least) return ", " + Variation::tr("at least %1").arg(numberOf(*d.least));
    return d.most ? ", " + Variation::tr("at most %1").arg(numberOf(*d.most)) : QString();
}

}  // namespace

QStringList valueChoices() {
    return {Variation::tr("List of values"), Variation::tr("Range"),  Variation::tr("Uniform"),
            Variation::tr("Triangular"),     Variation::tr("Normal"), Variation::tr("Lognormal"),
            Variation::tr("Random seed")};
}

ValueChoice choiceOf(const StudyParameter& parameter) {
    if (parameter.range) return ValueChoice::Range;
    if (!parameter.distribution) return ValueChoice::List;
    switch (parameter.distribution->kind) {
        case DistributionKind::Uniform: return ValueChoice::Uniform;
        case DistributionKind::Triangular: return ValueChoice::Triangular;
        case DistributionKind::Normal: return ValueChoice::Normal;
        case DistributionKind::Lognormal: return ValueChoice::Lognormal;
        case DistributionKind::Seed: break;
    }
    return ValueChoice::Seed;
}

void choose(StudyParameter& parameter, ValueChoice choice) {
    if (choice == choiceOf(parameter)) return;
    static constexpr std::array kinds{DistributionKind::Uniform, DistributionKind::Triangular, DistributionKind::Normal,
                                      DistributionKind::Lognormal, DistributionKind::Seed};
    const auto [middle, half] = spreadOf(parameter);
    const double low = neat(middle - half), high = neat(middle + half);
    const std::optional<StudyDistribution> before = parameter.distribution;
    parameter.values.clear();
    parameter.range.reset();
    parameter.distribution.reset();
    if (choice == ValueChoice::List) {
        parameter.values = {shortest(low), shortest(neat(middle)), shortest(high)};
    } else if (choice == ValueChoice::Range) {
        parameter.range = StudyRange{low, high, 5};
    } else {
        StudyDistribution d = before.value_or(StudyDistribution{});
        d.kind = kinds.at(static_cast<std::size_t>(choice) - static_cast<std::size_t>(ValueChoice::Uniform));
        if (!d.mean) d.mean = neat(middle);
        if (!d.deviation) d.deviation = neat(0.5 * half);
        const bool isBounded = d.kind == DistributionKind::Uniform || d.kind == DistributionKind::Triangular;
        if (isBounded && !d.least) d.least = low;
        if (isBounded && !d.most) d.most = high;
        if (d.kind == DistributionKind::Triangular && !d.peak) d.peak = neat(middle);
        parameter.distribution = d;
    }
}

QString valuesText(const StudyParameter& parameter) {
    const QString kind = valueChoices().at(static_cast<int>(choiceOf(parameter))).toLower();
    if (parameter.range)
        return Variation::tr("%1 values from %2 to %3")
            .arg(parameter.range->count)
            .arg(numberOf(parameter.range->from), numberOf(parameter.range->to));
    if (!parameter.distribution) {
        QStringList values;
        for (const std::string& value : parameter.values) values << qt(cellOf(value));
        return values.isEmpty() ? Variation::tr("no values") : values.join(", ");
    }
    const StudyDistribution& d = *parameter.distribution;
    const bool isNormal = d.kind == DistributionKind::Normal || d.kind == DistributionKind::Lognormal;
    QString text = kind;
    if (isNormal) addNumber(text, "mean", d.mean);
    if (isNormal) addNumber(text, "deviation", d.deviation);
    if (d.kind == DistributionKind::Triangular) addNumber(text, "peak", d.peak);
    return d.kind == DistributionKind::Seed ? kind : text + boundsText(d);
}

QString faultText(const StudyFault& fault) {
    static constexpr std::array kinds{QT_TRANSLATE_NOOP("Variation", "missing"),
                                      QT_TRANSLATE_NOOP("Variation", "bond lost"),
                                      QT_TRANSLATE_NOOP("Variation", "misplaced")};
    return Variation::tr("%1, with a probability of %2 %")
        .arg(Variation::tr(kinds.at(static_cast<std::size_t>(fault.kind))), numberOf(100.0 * fault.probability));
}

std::string studyPathOf(const Scene& scene, const std::string& pointer) {
    std::string path, so;
    for (const std::string& part : partsOf(pointer)) {
        so = under(so, part);
        const auto place = locate(scene, so);
        const bool isItem = place && place->entry && place->field->kind == FieldKind::List;
        const std::string name = isItem ? nameAt(scene, so) : part;
        if (isItem && !isPlain(name)) path += "[" + part + "]";
        else if (!isPlain(name)) return pointer;
        else path += (path.empty() ? "" : ".") + name;
    }
    return path;
}

const Field* fieldAtPath(const std::string& path) {
    const Structure* structure = &sceneStructure();
    const std::vector<std::string> keys = keysOfPath(path);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const Field* field = findField(*structure, keys[i]);
        if (!field || i + 1 == keys.size()) return field;
        if (!hasChildren(*field)) return nullptr;
        structure = &field->children.structure();
        if (field->kind != FieldKind::Object && ++i + 1 == keys.size()) return nullptr;  // an item, not a field
    }
    return nullptr;
}

std::optional<StudyParameter> variationOf(const Scene& scene, const std::vector<std::string>& pointers) {
    const auto place = pointers.empty() ? std::nullopt : locate(scene, pointers.front());
    if (!place || !place->field || !place->field->get || place->element || isName(*place->field)) return std::nullopt;
    const Field& field = *place->field;
    const bool isNumber = field.kind == FieldKind::Number || field.kind == FieldKind::Integer;
    const bool isChoice = field.kind == FieldKind::Flag || field.kind == FieldKind::Word ||
                          field.kind == FieldKind::Text;
    if (!isNumber && !isChoice) return std::nullopt;
    StudyParameter parameter;
    parameter.path = studyPathOf(scene, pointers.front());
    parameter.name = shortName(parameter.path);
    for (std::size_t i = 1; i < pointers.size(); ++i) parameter.also.push_back(studyPathOf(scene, pointers[i]));
    const FieldValue value = valueAt(scene, pointers.front()).value_or(FieldValue());
    const auto* number = std::get_if<double>(&value);
    if (field.kind == FieldKind::Integer && isSeed(field)) {
        parameter.distribution = StudyDistribution{};
        parameter.distribution->kind = DistributionKind::Seed;
    } else if (field.kind == FieldKind::Number) {
        parameter.distribution = normalAround(number ? *number : 1.0, field.range);
    } else {
        addChoices(parameter, field, value);
    }
    return parameter;
}

}  // namespace keyblock
