// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The selected bolt of the run. Results contain every bolt, including those of
// patterns, whereas the document can select a pattern only as a whole. Selecting a bolt
// of a pattern here therefore selects its pattern in the document. Bolts are matched by
// name, because the document may have been edited since the run.
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

    /// Index of the selected bolt among the bolts of the run shown; −1: no single bolt is selected.
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
