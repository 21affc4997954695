// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which bolt of the run is looked at. Results count every bolt, those of patterns too;
// the document selects bolts that stand there one by one, and patterns as a whole. So
// a bolt of a pattern is chosen here, and its pattern is what the document selects.
// Between the two stand names, as the document may have been edited since the run.
#pragma once

#include <QObject>

namespace keyblock {

class Document;
class Selection;
class TimeCursor;

class BoltChoice : public QObject {
    Q_OBJECT

public:
    BoltChoice(const Document& document, Selection& selection, const TimeCursor& cursor, QObject* parent = nullptr);

    /// Row among the bolts of the run that is shown; −1: none in particular.
    int bolt() const { return bolt_; }
    void choose(int bolt);

Q_SIGNALS:
    void changed();

private:
    void follow();
    int selectedRow() const;
    QString pointerTo(int bolt) const;

    const Document& document_;
    Selection& selection_;
    const TimeCursor& cursor_;
    int bolt_ = -1;
    bool choosing_ = false;
};

}  // namespace keyblock
