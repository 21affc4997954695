// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/bolt_choice.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <algorithm>

namespace keyblock {

namespace {

/// Index of the bolt or pattern with this name; −1 if there is none.
template <typename Things>
int rowOf(const Things& things, const std::string& name) {
    const auto found = std::ranges::find_if(things, [&](const auto& thing) { return thing.name == name; });
    return found == things.end() ? -1 : static_cast<int>(found - things.begin());
}

/// The pattern of a bolt with a name such as `P1.3`; empty for a single bolt.
std::string patternOf(const Scene& scene, const Bolt& bolt) {
    const std::size_t dot = bolt.name.rfind('.');
    if (dot == std::string::npos) return {};
    const std::string name = bolt.name.substr(0, dot);
    return rowOf(scene.boltPatterns, name) < 0 ? std::string() : name;
}

/// Index of the bolt that a pointer such as `/bolts/3` refers to; −1 for other pointers.
int boltAt(const Scene& scene, const QString& pointer) {
    bool isNumber = false;
    const int row = pointer.startsWith("/bolts/") ? pointer.section('/', 2, 2).toInt(&isNumber) : -1;
    return isNumber && row >= 0 && static_cast<std::size_t>(row) < scene.bolts.size() ? row : -1;
}

}  // namespace

BoltChoice::BoltChoice(const Document& document, Selection& selection, const TimeCursor& cursor, QObject* parent)
    : QObject(parent), document_(document), selection_(selection), cursor_(cursor) {
    connect(&selection, &Selection::changed, this, &BoltChoice::follow);
    connect(&cursor, &TimeCursor::runChanged, this, [this] {
        bolt_ = selectedRow();
        Q_EMIT changed();
    });
}

/// Index of the first selected bolt among the bolts of the run; −1: none.
int BoltChoice::selectedRow() const {
    if (!cursor_.run()) return -1;
    const Scene& drawn = *document_.scene();
    for (const QString& pointer : selection_.pointers())
        if (const int row = boltAt(drawn, pointer); row >= 0)
            return rowOf(cursor_.run()->scene().bolts, drawn.bolts[row].name);
    return -1;
}

/// Pointer to the bolt or its pattern in the document; empty if the document has neither.
QString BoltChoice::pointerTo(int bolt) const {
    const Scene &ran = cursor_.run()->scene(), &drawn = *document_.scene();
    const Bolt& chosen = ran.bolts[bolt];
    const std::string pattern = patternOf(ran, chosen);
    const int row = pattern.empty() ? rowOf(drawn.bolts, chosen.name) : rowOf(drawn.boltPatterns, pattern);
    if (row < 0) return {};
    return (pattern.empty() ? QStringLiteral("/bolts/%1") : QStringLiteral("/bolt_patterns/%1")).arg(row);
}

void BoltChoice::follow() {
    if (choosing_) return;
    const int row = selectedRow();
    if (row == bolt_) return;
    bolt_ = row;
    Q_EMIT changed();
}

void BoltChoice::choose(int bolt) {
    if (!cursor_.run() || bolt >= static_cast<int>(cursor_.run()->scene().bolts.size())) return;
    bolt_ = std::max(bolt, -1);
    const QString pointer = bolt_ >= 0 ? pointerTo(bolt_) : QString();
    choosing_ = true;
    selection_.set(pointer.isEmpty() ? QStringList() : QStringList{pointer});
    choosing_ = false;
    Q_EMIT changed();
}

}  // namespace keyblock
