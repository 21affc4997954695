// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/properties/selection_title.h"

#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/object_at.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cassert>
#include <utility>

namespace keyblock {

namespace {

struct TitleTexts {
    Q_DECLARE_TR_FUNCTIONS(SelectionTitle)
};

using Counts = std::vector<std::pair<const Structure*, int>>;  // in order of first appearance

Counts countsOf(const Scene& scene, const std::vector<std::string>& pointers) {
    Counts counts;
    for (const std::string& pointer : pointers) {
        const auto at = objectAt(scene, pointer);
        if (!at) continue;
        const auto known = std::ranges::find(counts, at->structure, &Counts::value_type::first);
        if (known == counts.end()) counts.emplace_back(at->structure, 1);
        else ++known->second;
    }
    return counts;
}

}  // namespace

SelectionTitle selectionTitle(const Scene& scene, const std::vector<std::string>& pointers) {
    assert(pointers.size() >= 2);
    const Counts counts = countsOf(scene, pointers);
    if (counts.size() == 1)
        return {countedOf(*counts.front().first, counts.front().second), TitleTexts::tr("Edits apply to all of them")};
    int all = 0;
    QStringList kinds;
    for (const auto& [structure, count] : counts) {
        all += count;
        kinds << countedOf(*structure, count);
    }
    return {TitleTexts::tr("%1 objects").arg(all), kinds.join(", ")};
}

}  // namespace keyblock
