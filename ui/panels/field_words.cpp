// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/field_words.h"

#include <QCoreApplication>
#include <QHash>

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(FieldWords)
};

/// Labels that cannot be derived from the key.
const QHash<QString, QString>& ownLabels() {
    static const QHash<QString, QString> labels{
        {"youngs_modulus", Texts::tr("Young's modulus")}, {"poissons_ratio", Texts::tr("Poisson's ratio")},
        {"rho_inf", QString::fromUtf8("ρ∞")}, {"sxx", QString::fromUtf8("σxx")}, {"syy", QString::fromUtf8("σyy")},
        {"sxy", QString::fromUtf8("σxy")}, {"block_at", Texts::tr("Point in block")},
        {"reference_y", Texts::tr("Reference elevation")}, {"gradient_y", Texts::tr("Gradient with elevation")},
        {"far_end", Texts::tr("Far end")}, {"sub_blocks", Texts::tr("Cells")},
        {"in_situ_stress", Texts::tr("In-situ stress")}, {"unbalanced", Texts::tr("Unbalanced force")},
        {"body", Texts::tr("Unbalanced force of a block")},
        {"set", Texts::tr("Strength changes")}, {"fix", Texts::tr("Fixity")}, {"way", Texts::tr("Direction")},
        {"max_steps", Texts::tr("Max. steps")}, {"max_passes", Texts::tr("Max. iterations")},
        {"like", Texts::tr("Derived from")}, {"dynamic_factor", Texts::tr("Bond")},
        {"steel_dynamic_factor", Texts::tr("Steel")}, {"plate_dynamic_factor", Texts::tr("Plate")},
        {"softening_slip", Texts::tr("Softening slip")}, {"min_area", Texts::tr("Min. area")},
        {"min_width", Texts::tr("Min. width")}, {"continue", Texts::tr("Continue after collapse")},
        {"offset", Texts::tr("Offset of first bolt")}, {"tunnel", Texts::tr("Along wall of")},
        {"trace_length_deviation", Texts::tr("Length deviation")}, {"until", Texts::tr("Stop criteria")},
        {"move", Texts::tr("Max. movement")}, {"smallest", Texts::tr("Min. block area")},
        {"every", Texts::tr("Frame interval")}, {"spin", Texts::tr("Angular velocity")},
        {"restick", Texts::tr("Re-stick")}, {"second_moment", Texts::tr("Second moment of area")},
        {"per", Texts::tr("Values per")}, {"normal_per", Texts::tr("Stiffness per")},
        {"spacing_out_of_plane", Texts::tr("Out-of-plane spacing")}};
    return labels;
}

struct Heading {
    const char* structure;
    const char* title;
    std::vector<std::string_view> keys;
};

/// Groups of long structures; keys that are in no group appear under the title of the structure.
const std::vector<Heading>& headings() {
    static const std::vector<Heading> list{
        {"bolt pattern", QT_TRANSLATE_NOOP("FieldWords", "Bolt"),
         {"type", "length", "angle_from_wall", "divisions", "plate", "pretension"}},
        {"scene", QT_TRANSLATE_NOOP("FieldWords", "Quantities of interest"), {"quantities"}},
        {"joint set", QT_TRANSLATE_NOOP("FieldWords", "Traces"),
         {"trace_length", "trace_length_deviation", "bridge", "bridge_deviation", "stagger"}},
        {"stage", QT_TRANSLATE_NOOP("FieldWords", "Excavation and support"),
         {"excavate", "relaxation", "install", "remove"}},
        {"bolt type", QT_TRANSLATE_NOOP("FieldWords", "Steel"),
         {"diameter", "area", "second_moment", "plastic_modulus", "density", "shear_modulus", "shear_coefficient",
          "youngs_modulus", "steel", "tensile_strength", "shear_strength_ratio", "rupture_rule", "bending"}},
        {"bolt type", QT_TRANSLATE_NOOP("FieldWords", "Dynamic / static strength"),
         {"dynamic_factor", "steel_dynamic_factor", "plate_dynamic_factor"}},
        {"bolt", QT_TRANSLATE_NOOP("FieldWords", "Dynamic / static strength"),
         {"dynamic_factor", "steel_dynamic_factor", "plate_dynamic_factor"}},
        {"bolt type", QT_TRANSLATE_NOOP("FieldWords", "Grout across the bolt"), {"normal_stiffness", "normal_per"}},
        {"bolt type", QT_TRANSLATE_NOOP("FieldWords", "Sources"), {"sources"}},
        {"joint material", QT_TRANSLATE_NOOP("FieldWords", "Stiffness"),
         {"normal_stiffness", "shear_stiffness", "crushing_strength"}},
    };
    return list;
}

constexpr std::array numericalKeys{"penalty_ratio", "shear_ratio", "tolerance", "max_passes",
                                   "iteration",     "contact",     "rho_inf",   "integration"};

/// Parts of `a, or b`.
std::vector<std::string> alternatives(std::string_view unit) {
    const std::size_t at = unit.find(", or ");
    if (at == std::string_view::npos) return {std::string(unit)};
    return {std::string(unit.substr(0, at)), std::string(unit.substr(at + 5))};
}

std::string wordIn(const Structure& structure, const void* object, std::string_view key) {
    const FieldValue value = valueOf(structure, object, key);
    const auto* text = std::get_if<std::string>(&value);
    return text ? *text : std::string();
}

std::string wordOf(const ObjectAt& at, std::string_view key) { return wordIn(*at.structure, at.object, key); }

/// The time of motions, loads etc. is that of their stage.
bool inStaticStage(const ObjectAt& at) {
    return at.owner && at.ownerStructure->name == "stage" && wordIn(*at.ownerStructure, at.owner, "kind") == "static";
}

bool isGiven(const ObjectAt& at, std::string_view key) {
    return !std::holds_alternative<std::monostate>(valueOf(*at.structure, at.object, key));
}

/// True if the second of two units applies.
bool takesSecond(const ObjectAt& at, const Field& field) {
    if (at.structure->name == "anchor") return !isGiven(at, "at") && wordOf(at, "per") == "length";
    if (at.structure->name == "bolt type")
        return field.key == "normal_stiffness" && wordOf(at, "normal_per") == "length";
    if (at.structure->name == "dilation") return inStaticStage(at);
    return false;
}

QString capitalised(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

}  // namespace

QString fromUtf8(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

QString labelOf(const Field& field) {
    QString key = fromUtf8(field.key);
    const auto own = ownLabels().constFind(key);
    return own != ownLabels().constEnd() ? *own : capitalised(key.replace('_', ' '));
}

QString labelOf(const Field& field, const Display& display) {
    if (!field.isStress) return labelOf(field);
    const QString sign = display.compressionPositive() ? Texts::tr("compression +") : Texts::tr("tension +");
    return QString("%1 (%2)").arg(labelOf(field), sign);
}

QString titleOf(const Structure& structure) { return capitalised(fromUtf8(structure.name)); }

QString countedOf(const Structure& structure, int count) {
    QString name = fromUtf8(structure.name);
    if (count != 1) name = name.endsWith('y') ? name.chopped(1) + "ies" : name.endsWith('s') ? name : name + 's';
    return QString("%1 %2").arg(count).arg(name);
}

QString headingOf(const Structure& structure, const Field& field) {
    for (const Heading& heading : headings())
        if (structure.name == heading.structure && std::ranges::count(heading.keys, field.key))
            return Texts::tr(heading.title);
    const QString numerical = numericalHeading(structure, field);
    return numerical.isEmpty() ? titleOf(structure) : numerical;
}

QString numericalHeading(const Structure& structure, const Field& field) {
    const bool isNumerical = structure.name == "analysis" && std::ranges::count(numericalKeys, field.key);
    return isNumerical ? Texts::tr("Numerical settings") : QString();
}

std::string unitOf(const ObjectAt& at, const Field& field) {
    const auto units = alternatives(field.unit);
    if (field.unit == "Pa" && field.key.ends_with("_modulus")) return std::string(Display::modulusUnit);
    if (units.size() < 2) return units.front();
    if (field.key == "every") return "s";
    std::string second = units[1];
    if (second == "N/m per m" || second == "N/m" || second == "m") return takesSecond(at, field) ? second : units[0];
    return units[0];
}

std::vector<std::string> columnUnits(const ObjectAt& at, const Field& field) {
    if (field.kind != FieldKind::Pairs) return {};
    const std::size_t comma = field.unit.find(", ");
    std::vector<std::string> units{std::string(field.unit.substr(0, comma)),
                                   comma == std::string_view::npos ? "" : std::string(field.unit.substr(comma + 2))};
    if (const std::size_t either = units[1].find(" or "); either != std::string::npos)
        units[1] = takesSecond(at, field) ? units[1].substr(either + 4) : units[1].substr(0, either);
    if (inStaticStage(at)) units[0].clear();  // pseudo-time
    for (std::string& unit : units)
        if (unit == "–") unit.clear();
    return units;
}

QStringList columnTitles(const Structure& structure, const Field& field) {
    if (field.key == "steel") return {Texts::tr("Strain"), Texts::tr("Stress")};
    if (structure.name == "anchor") return {Texts::tr("Slip"), Texts::tr("Force")};
    if (structure.name == "motion") return {Texts::tr("Time"), Texts::tr("Displacement")};
    if (structure.name == "load") return {Texts::tr("Time"), Texts::tr("Factor")};
    return {Texts::tr("Time"), Texts::tr("Value")};
}

}  // namespace keyblock
