// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A second run, of this scene or another, for comparison with the one shown: its own
// cursor follows the first by time. Without a second run only this object exists.
#pragma once

#include "ui/document/background.h"

#include <QObject>
#include <QString>

#include <memory>

namespace keyblock {

class LiveRun;
class TimeCursor;

class Comparison : public QObject {
    Q_OBJECT

public:
    explicit Comparison(TimeCursor& first, QObject* parent = nullptr);
    ~Comparison() override;

    /// Reads the store in the background and shows its run next to the first.
    void begin(const QString& store);
    void end();
    bool isOn() const;

    TimeCursor& first() const { return first_; }
    TimeCursor& second() const { return *second_; }
    /// Path of the second run's store; empty: none.
    QString store() const;

Q_SIGNALS:
    void changed();  // another second run, or none
    void failed(const QString& message);

private:
    void follow();

    TimeCursor& first_;
    TimeCursor* second_;
    Background opening_;
    int asked_ = 0;  // so that a comparison that was closed meanwhile does not start
};

/// "Run 2 · drift-bolted" for drift-bolted-2.kbrun.
QString runTitle(const QString& store);

}  // namespace keyblock
