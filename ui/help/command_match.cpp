// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/command_match.h"

#include <QStringList>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int wordBegins = 100, within = 60, scattered = 30;

bool beginsWord(const QString& name, int place) { return place == 0 || !name[place - 1].isLetterOrNumber(); }

/// Finds the letters in the given order, possibly with others in between. The fewer gaps, the better the match.
int matchOfLetters(const QString& word, const QString& name) {
    int place = -1, jumps = 0;
    for (const QChar letter : word) {
        const int next = name.indexOf(letter, place + 1);
        if (next < 0) return -1;
        if (next != place + 1) ++jumps;
        place = next;
    }
    return std::max(1, scattered - 6 * jumps);
}

int matchOfWord(const QString& word, const QString& name) {
    int best = -1;
    for (int at = name.indexOf(word); at >= 0; at = name.indexOf(word, at + 1))
        best = std::max(best, beginsWord(name, at) ? wordBegins - std::min(at, 30) : within - std::min(at, 30));
    return best >= 0 ? best : matchOfLetters(word, name);
}

}  // namespace

int matchOf(const QString& typed, const QString& name) {
    const QString lower = name.toLower();
    int sum = 0;
    for (const QString& word : typed.toLower().split(' ', Qt::SkipEmptyParts)) {
        const int match = matchOfWord(word, lower);
        if (match < 0) return -1;
        sum += match;
    }
    return sum;
}

}  // namespace keyblock
