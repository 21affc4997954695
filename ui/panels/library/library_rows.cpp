// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/library/library_rows.h"

#include "solver/files/scene/bolt_library.h"
#include "solver/scene/anchor_curve.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/units.h"
#include "ui/look/display.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/value_text.h"
#include "ui/picture/section/shown_numbers.h"

#include <QCoreApplication>

#include <algorithm>

namespace keyblock {

namespace {

struct LibraryTexts {
    Q_DECLARE_TR_FUNCTIONS(Library)
};

QString groupOf(const BoltType& type) {
    switch (type.boltClass) {
        case BoltClass::CMC: return LibraryTexts::tr("Grouted bars");
        case BoltClass::CFC: return LibraryTexts::tr("Friction bolts");
        case BoltClass::DMC: return LibraryTexts::tr("Mechanically anchored bolts");
        case BoltClass::DFC: return LibraryTexts::tr("Yielding bolts");
    }
    return {};
}

QString withUnit(double value, std::string_view unit, const Display& display) {
    return numberText(value, unit, display, 3) + ' ' + display.shown(unit).symbol;
}

/// Diameter, and yield and tensile strength, such as `20 mm · 154 / 198 kN`.
QString detailOf(const BoltType& type, const Display& display) {
    QString text = QString::fromStdString(lengthText(type.diameter, display.numbers()));
    const BoltSteel steel = boltSteel(type);
    if (!steel.yield || !steel.tensile) return text;
    return text + QString::fromUtf8(" · %1 / %2").arg(numberText(*steel.yield, "N", display, 3),
                                                      withUnit(*steel.tensile, "N", display));
}

int usersOf(const Scene& scene, const std::string& name) {
    return static_cast<int>(std::ranges::count(scene.bolts, name, &Bolt::type) +
                            std::ranges::count(scene.boltPatterns, name, &ScenePattern::type));
}

bool entryHolds(const LibraryEntry& entry, const QString& filter) {
    const QString all = QString::fromStdString(entry.type.name + ' ' + entry.type.source) + ' ' + entry.group + ' ' +
                        fromUtf8(boltClassWords[static_cast<std::size_t>(entry.type.boltClass)]);
    return all.contains(filter, Qt::CaseInsensitive);
}

/// Heading of a stretch of the bolt, or of a node, that is bonded. \param number counted from 1.
QString titleOf(const Anchor& anchor, std::size_t number) {
    return (anchor.at ? LibraryTexts::tr("Bonded node %1") : LibraryTexts::tr("Bonded section %1")).arg(number);
}

QString sourceOf(const BoltType& type, const std::string& key) {
    const auto found = type.sources.find(key);
    return found == type.sources.end() ? QString() : QString::fromStdString(found->second);
}

bool isUnconfirmed(const QString& source) { return source.contains("unconfirmed") || source.contains("estimate"); }

class Numbers {
public:
    Numbers(const BoltType& type, const Display& display) : type_(type), display_(display) {}

    std::vector<LibraryNumber> all() {
        add(boltTypeStructure(), &type_, "", {});
        const Field* anchors = findField(boltTypeStructure(), "anchors");
        for (std::size_t i = 0; i < type_.anchors.size(); ++i)
            add(anchors->children.structure(), &type_.anchors[i], "anchors", titleOf(type_.anchors[i], i + 1));
        add(findField(boltTypeStructure(), "plate")->children.structure(), &type_.plate, "plate.", LibraryTexts::tr("Plate"));
        return std::move(rows_);
    }

private:
    void add(const Structure& structure, const void* object, const std::string& prefix, const QString& heading) {
        const ObjectAt at{&structure, object};
        for (const Field& field : structure.fields) {
            const bool isNumberOrWord = field.kind != FieldKind::TextMap && !field.isSentence && field.names.empty();
            const bool shown = field.get && isNumberOrWord && applies(structure, field, object);
            if (!shown) continue;
            const FieldValue value = field.get(object);
            const bool said = !field.nullable || !std::holds_alternative<std::monostate>(value);
            if (!said || (field.nullable && value == FieldValue(Table{}))) continue;
            LibraryNumber row;
            row.heading = heading.isEmpty() ? headingOf(structure, field) : heading;
            row.label = labelOf(field);
            row.value = summaryOf(value, field, unitOf(at, field), display_);
            row.source = sourceOf(type_, prefix == "anchors" ? prefix : prefix + std::string(field.key));
            row.unconfirmed = isUnconfirmed(row.source);
            rows_.push_back(std::move(row));
        }
    }

    const BoltType& type_;
    const Display& display_;
    std::vector<LibraryNumber> rows_;
};

/// Whether two bonds have the same law, regardless of their positions.
bool sameLaw(Anchor a, const Anchor& b) {
    a.at = b.at;
    a.from = b.from;
    a.to = b.to;
    return a == b;
}

QString lawTitle(const Anchor& anchor) {
    const QString law = fromUtf8(rowOf(anchor.law).title);
    return anchor.at || anchor.per == Per::Node ? LibraryTexts::tr("Bond per node (%1)").arg(law)
        : LibraryTexts::tr("Bond per metre (%1)").arg(law);
}

double farthestSlip(const Anchor& written) {
    const Anchor anchor = withCurve(written);
    if (rowOf(anchor.law).hasPoints) return anchor.curve.empty() ? 0.001 : anchor.curve.back().first;
    const bool limited = anchor.strength && anchor.stiffness > 0.0;
    return limited ? 6.0 * *anchor.strength / anchor.stiffness : 0.002;
}

}  // namespace

std::vector<LibraryEntry> libraryEntries(const Scene& scene, const Display& display, const QString& filter) {
    std::vector<LibraryEntry> entries;
    for (const BoltType& type : scene.boltTypes)
        if (!type.builtIn)
            entries.push_back({type, LibraryTexts::tr("In this scene"), detailOf(type, display), usersOf(scene, type.name)});
    const std::size_t own = entries.size();
    for (const BoltType& type : builtInBoltTypes())
        entries.push_back({type, groupOf(type), detailOf(type, display), usersOf(scene, type.name)});
    std::stable_sort(entries.begin() + static_cast<std::ptrdiff_t>(own), entries.end(),
                     [](const LibraryEntry& a, const LibraryEntry& b) { return a.type.boltClass < b.type.boltClass; });
    if (!filter.isEmpty()) std::erase_if(entries, [&](const LibraryEntry& entry) { return !entryHolds(entry, filter); });
    return entries;
}

std::vector<LibraryNumber> libraryNumbers(const BoltType& type, const Display& display) {
    return Numbers(type, display).all();
}

ShownCurve steelCurve(const BoltType& type, const Display& display) {
    ShownCurve curve{LibraryTexts::tr("Steel"), {}, LibraryTexts::tr("Strain (%)"),
                     LibraryTexts::tr("Stress (%1)").arg(display.shown("Pa").symbol)};
    for (const auto& [strain, stress] : type.steel)
        curve.points.emplace_back(fromSi(strain, namedUnit("%")), stress * display.shown("Pa").factor);
    return curve;
}

Table bondCurve(const Anchor& written, double farthest) {
    const Anchor anchor = withCurve(written);
    const AnchorLawRow& law = rowOf(anchor.law);
    if (law.hasPoints) return anchor.curve;
    if (!law.hasStrength || !anchor.strength || anchor.stiffness <= 0.0)
        return {{0.0, 0.0}, {farthest, anchor.stiffness * farthest}};
    const double peak = *anchor.strength, slip = peak / anchor.stiffness;
    if (law.keepsStrength) return {{0.0, 0.0}, {slip, peak}, {farthest, peak}};
    return {{0.0, 0.0}, {slip, peak}, {slip * 1.0001, anchor.residual}, {farthest, anchor.residual}};
}

std::vector<ShownCurve> bondCurves(const BoltType& type, const Display& display) {
    std::vector<ShownCurve> curves;
    std::vector<Anchor> listed;
    for (const Anchor& anchor : type.anchors) {
        if (std::ranges::any_of(listed, [&](const Anchor& other) { return sameLaw(other, anchor); })) continue;
        listed.push_back(anchor);
        const char* unit = anchor.at || anchor.per == Per::Node ? "N" : "N/m";
        ShownCurve curve{lawTitle(anchor), {}, LibraryTexts::tr("Slip (mm)"),
                         LibraryTexts::tr("Force (%1)").arg(display.shown(unit).symbol)};
        for (const auto& [slip, force] : bondCurve(anchor, farthestSlip(anchor)))
            curve.points.emplace_back(fromSi(slip, namedUnit("mm")), force * display.shown(unit).factor);
        curves.push_back(std::move(curve));
    }
    return curves;
}

}  // namespace keyblock
