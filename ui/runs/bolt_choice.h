// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The selected bolt of the run. Results have every bolt, including those of patterns;
// the document selects single bolts, and patterns as a whole. So a bolt of a pattern is
// chosen here, and the document selects its pattern. Bolts are matched by name, as the
// document may have been edited since the run.
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

    /// Row among the bolts of the run shown; −1: no particular one.
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
