// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/problems/problem_rows.h"

#include "ui/document/document.h"
#include "ui/edit/edits.h"
#include "ui/edit/locate.h"
#include "ui/edit/scene_objects.h"
#include "ui/look/display.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/value_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <map>

namespace keyblock {

namespace {

constexpr std::size_t mostNotes = 200;  // notes of each kind that are listed

struct RowTexts {
    Q_DECLARE_TR_FUNCTIONS(Problems)
};

QString withCapital(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

/// The name of the part of the scene that a pointer belongs to.
QString roomOf(const std::string& pointer) {
    const QString key = QString::fromStdString(pointer).section('/', 1, 1);
    static const std::map<QString, const char*> rooms{
        {"materials", QT_TRANSLATE_NOOP("Problems", "materials")},
        {"joint_materials", QT_TRANSLATE_NOOP("Problems", "materials")},
        {"bolts", QT_TRANSLATE_NOOP("Problems", "support")},
        {"bolt_patterns", QT_TRANSLATE_NOOP("Problems", "support")},
        {"bolt_types", QT_TRANSLATE_NOOP("Problems", "support")},
        {"stages", QT_TRANSLATE_NOOP("Problems", "stages")},
        {"monitors", QT_TRANSLATE_NOOP("Problems", "results")},
        {"quantities", QT_TRANSLATE_NOOP("Problems", "results")},
        {"supports", QT_TRANSLATE_NOOP("Problems", "supports")},
        {"in_situ_stress", QT_TRANSLATE_NOOP("Problems", "loads")},
        {"analysis", QT_TRANSLATE_NOOP("Problems", "settings")},
        {"output", QT_TRANSLATE_NOOP("Problems", "settings")},
        {"limits", QT_TRANSLATE_NOOP("Problems", "settings")},
        {"safety", QT_TRANSLATE_NOOP("Problems", "settings")},
        {"cutting", QT_TRANSLATE_NOOP("Problems", "cut")},
        {"joints", QT_TRANSLATE_NOOP("Problems", "geometry")},
        {"joint_sets", QT_TRANSLATE_NOOP("Problems", "geometry")},
        {"domain", QT_TRANSLATE_NOOP("Problems", "geometry")},
        {"tunnels", QT_TRANSLATE_NOOP("Problems", "geometry")},
        {"blocks", QT_TRANSLATE_NOOP("Problems", "geometry")},
        {"regions", QT_TRANSLATE_NOOP("Problems", "geometry")},
        {"voronoi", QT_TRANSLATE_NOOP("Problems", "geometry")},
    };
    const auto found = rooms.find(key);
    return found == rooms.end() ? RowTexts::tr("whole scene") : RowTexts::tr(found->second);
}

class Rows {
public:
    Rows(const Document& document, const Display& display, bool reportIsOpen)
        : checked_(document.checked()), scene_(*checked_.scene), display_(display), reportIsOpen_(reportIsOpen) {}

    std::vector<ProblemRow> all() {
        for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Note})
            for (const Problem& problem : checked_.problems)
                if (problem.severity == severity) rows_.push_back(rowOf(problem));
        if (checked_.cut && needsCut(scene_)) {
            addSlivers();
            addReport();
        }
        return std::move(rows_);
    }

private:
    QString placeText(const Point& p) const {
        return QString("%1, %2").arg(numberText(p.x(), "m", display_, 4), numberText(p.y(), "m", display_, 4));
    }

    QString where(const std::optional<Box>& box, const QString& room) const {
        if (!box) return room;
        return QString::fromUtf8("%1 · %2").arg(placeText(0.5 * (box->min + box->max)), room);
    }

    std::optional<Box> boxAt(const std::string& pointer) {
        if (const auto value = valueAt(scene_, pointer))
            if (const auto* point = std::get_if<Point>(&*value); point && point->allFinite())
                return Box{*point, *point};
        if (pointer.empty()) return std::nullopt;
        if (objects_.empty())
            for (const SceneObject& object : objectsOf(scene_)) objects_.emplace(object.pointer, boxOf(object));
        const auto found = objects_.find(objectPointer(scene_, pointer));
        return found == objects_.end() ? std::nullopt : found->second;
    }

    ProblemRow rowOf(const Problem& problem) {
        ProblemRow row;
        row.sign = problem.severity == Severity::Error     ? ProblemRow::Sign::Error
                   : problem.severity == Severity::Warning ? ProblemRow::Sign::Warning : ProblemRow::Sign::Note;
        const std::string object = objectPointer(scene_, problem.pointer);
        const QString title = object.empty() ? QString() : QString::fromStdString(titleAt(scene_, object));
        const QString message = QString::fromStdString(problem.message);
        row.title = title.isEmpty() ? withCapital(message) : withCapital(title) + ": " + message;
        row.detail = QString::fromStdString(problem.remedy);
        row.pointer = QString::fromStdString(problem.pointer);
        row.box = boxAt(problem.pointer);
        row.where = where(row.box, roomOf(problem.pointer));
        row.remedy = remedyFor(scene_, problem);
        row.link = row.remedy ? row.remedy->text : problem.pointer.empty() ? QString() : RowTexts::tr("Show");
        return row;
    }

    void addSlivers() {
        const Slivers slivers = sliversOf(scene_, *checked_.cut);
        if (slivers.count == 0) return;
        ProblemRow row;
        row.sign = ProblemRow::Sign::Warning;
        row.title = slivers.count == 1 ? RowTexts::tr("1 sliver not merged")
                                       : RowTexts::tr("%1 slivers not merged").arg(slivers.count);
        row.detail = RowTexts::tr("Narrower than %1 or very small; total area %2. Slivers slow down every step. "
                               "With the default limits, they would be merged.")
                         .arg(measure(slivers.width, "m"), measure(slivers.area, "m²"));
        row.box = slivers.box;
        row.where = where(row.box, RowTexts::tr("cut"));
        row.remedy = mergeSlivers(slivers);
        row.link = row.remedy->text;
        rows_.push_back(std::move(row));
    }

    QString measure(double value, std::string_view unit) const {
        return numberText(value, unit, display_, 3) + ' ' + display_.shown(unit).symbol;
    }

    /// The number of notes of each kind, such as `4 merged traces, 2 trimmed ends`.
    QString counts(const std::map<CutNoteKind, int>& kinds) const {
        QStringList parts;
        for (const auto& [kind, count] : kinds) {
            const QString word = fromUtf8(wordOf(kind));
            parts << QString("%1 %2%3").arg(count).arg(word, count == 1 ? "" : "s");
        }
        return parts.isEmpty() ? RowTexts::tr("Nothing merged, trimmed or dropped") : withCapital(parts.join(", "));
    }

    void addReport() {
        const SceneCut& cut = *checked_.cut;
        std::map<CutNoteKind, int> kinds;
        for (const CutNote& note : cut.notes) ++kinds[note.kind];
        ProblemRow row;
        row.sign = ProblemRow::Sign::Report;
        row.title = cut.blocks == 1 ? RowTexts::tr("Cut report: 1 block")
                                   : RowTexts::tr("Cut report: %1 blocks").arg(Display::number(cut.blocks, 12));
        if (cut.open > 0)
            row.title += RowTexts::tr("; %1 more omitted in tunnels that are open from the start").arg(cut.open);
        row.detail = counts(kinds);
        row.where = RowTexts::tr("whole section");
        if (!kinds.empty()) row.link = reportIsOpen_ ? RowTexts::tr("Hide report") : RowTexts::tr("Show report");
        row.opensReport = !kinds.empty();
        rows_.push_back(row);
        if (!reportIsOpen_) return;
        std::map<CutNoteKind, std::size_t> listed;
        for (const CutNote& note : cut.notes)
            if (++listed[note.kind] <= mostNotes) rows_.push_back(rowOf(note));
    }

    ProblemRow rowOf(const CutNote& note) const {
        ProblemRow row;
        row.depth = 1;
        row.title = withCapital(fromUtf8(wordOf(note.kind)));
        row.detail = withCapital(QString::fromStdString(noteText(*checked_.cut, note)));
        row.pointer = pointerOfSource(note.source);
        if (note.place.allFinite()) row.box = Box{note.place, note.place};
        row.where = where(row.box, RowTexts::tr("cut"));
        row.link = RowTexts::tr("Show");
        return row;
    }

    /// The cut numbers its sources with the joints first, then the joint sets.
    QString pointerOfSource(int source) const {
        const int joints = static_cast<int>(scene_.joints.size()), sets = static_cast<int>(scene_.jointSets.size());
        if (source >= 0 && source < joints) return QString("/joints/%1").arg(source);
        if (source >= joints && source < joints + sets) return QString("/joint_sets/%1").arg(source - joints);
        return {};
    }

    const Checked& checked_;
    const Scene& scene_;
    const Display& display_;
    const bool reportIsOpen_;
    std::map<std::string, std::optional<Box>> objects_;
    std::vector<ProblemRow> rows_;
};

}  // namespace

std::vector<ProblemRow> problemRows(const Document& document, const Display& display, bool reportIsOpen) {
    return Rows(document, display, reportIsOpen).all();
}

int urgentCount(const std::vector<ProblemRow>& rows) {
    return static_cast<int>(std::ranges::count_if(rows, [](const ProblemRow& row) {
        return row.sign == ProblemRow::Sign::Error || row.sign == ProblemRow::Sign::Warning;
    }));
}

}  // namespace keyblock
