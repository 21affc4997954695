// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Labels show names from scenes, runs and file systems. Qt takes a text that looks like
// markup for rich text unless the label says otherwise, so that a name could hide
// itself, look like a message of the program, or load an image.
#pragma once

#include <QObject>

namespace keyblock {

/// An event filter for the application: labels that do not say which format their text has show it as plain text.
class PlainLabels : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace keyblock
