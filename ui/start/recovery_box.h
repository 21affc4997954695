// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports that a document was not closed properly, and offers to recover it.
#pragma once

#include "ui/document/recovery.h"

#include <QFrame>

namespace keyblock {

class Themes;

class RecoveryBox : public QFrame {
    Q_OBJECT

public:
    RecoveryBox(const Abandoned& abandoned, const Themes& themes, QWidget* parent = nullptr);

Q_SIGNALS:
    void recoverWanted(const keyblock::Abandoned& abandoned, keyblock::Recover what);
    void giveUpWanted(const keyblock::Abandoned& abandoned);

private:
    QWidget* makeLinks();

    Abandoned abandoned_;
};

}  // namespace keyblock
