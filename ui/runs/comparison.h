// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A second run, of this scene or another, for comparison with the run shown. It has its
// own time cursor, which follows the time of the first. Outside a comparison, only this
// object exists.
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

    /// Reads the run store in the background, then shows its run next to the first.
    void begin(const QString& store);
    void end();
    bool isOn() const;

    TimeCursor& first() const { return first_; }
    TimeCursor& second() const { return *second_; }
    /// Path of the second run's store; empty if there is no second run.
    QString store() const;

Q_SIGNALS:
    void changed();  // a different second run, or none
    void failed(const QString& message);

private:
    void follow();

    TimeCursor& first_;
    TimeCursor* second_;
    Background opening_;
    int asked_ = 0;  // number of requests, to recognise a comparison that was closed while it was being opened
};

/// Title of a run from the path of its store, e.g. "Run 2 · drift-bolted" for drift-bolted-2.kbrun.
QString runTitle(const QString& store);

}  // namespace keyblock
