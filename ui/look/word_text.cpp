// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/word_text.h"

#include <QCoreApplication>
#include <QHash>

namespace keyblock {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(WordText)
};

}  // namespace

QString wordText(std::string_view word) {
    static const QHash<QString, QString> texts{
        {"cw", Texts::tr("clockwise")},
        {"ccw", Texts::tr("counter-clockwise")},
        {"d-shape", Texts::tr("D-shape")},
        {"shi", Texts::tr("Shi")},
        {"newmark", Texts::tr("Newmark")},
        {"backward-euler", Texts::tr("backward Euler")},
        {"generalized-alpha", Texts::tr("generalised α")},
        {"open-close", Texts::tr("open–close")},
        {"augmented-lagrangian", Texts::tr("augmented Lagrangian")},
        {"peak-residual", Texts::tr("peak and residual")},
        {"bolt-lost", Texts::tr("bolt lost")},
        {"held", Texts::tr("fixed")}};
    const QString key = QString::fromUtf8(word.data(), static_cast<int>(word.size()));
    return texts.value(key, key);
}

}  // namespace keyblock
