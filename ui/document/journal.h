// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Follows a document and keeps its edits in a journal, so that a program that ends
// without being asked costs no work. A document without edits has none, and one
// that is closed or replaced on purpose leaves none.
#pragma once

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace keyblock {

class Document;
class JournalFile;
struct Scene;

/// Where journals lie: in the program's data folder of this person.
QString journalFolder();

class Journal : public QObject {
    Q_OBJECT

public:
    explicit Journal(Document& document, const QString& folder = journalFolder(), QObject* parent = nullptr);
    /// Writes what waits; the journal stays unless `close` was called.
    ~Journal() override;

    /// Removes the journal, because the document is saved or given up.
    void close();
    /// Waits until all edits are written.
    void flush();
    /// The file; empty while there is none.
    QString path() const;

Q_SIGNALS:
    void failed(const QString& why);  // edits are no longer kept
    void mended();  // they are kept again, those in between too

private:
    void begin();
    void tell(const QString& why);
    void follow(int index);
    void followFile();

    Document& document_;
    QString folder_;
    std::unique_ptr<JournalFile> file_;
    std::vector<std::shared_ptr<const Scene>> states_;  // by index of the undo stack
    int index_ = 0, saved_ = 0;
    QString savedAs_;
    bool broken_ = false;
};

}  // namespace keyblock
