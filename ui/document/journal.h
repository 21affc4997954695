// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Follows a document and keeps its edits in a journal, so that a crash loses no
// work. A document without edits has no journal, and one that is closed or replaced
// deliberately leaves none.
#pragma once

#include <QObject>
#include <QString>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace keyblock {

class Document;
class JournalFile;
class LazyScene;

/// The folder of journals: in the program's data folder of the user.
QString journalFolder();

class Journal : public QObject {
    Q_OBJECT

public:
    explicit Journal(Document& document, const QString& folder = journalFolder(), QObject* parent = nullptr);
    /// Writes pending edits; the journal stays unless `close` was called.
    ~Journal() override;

    /// Removes the journal because the document was saved or discarded.
    void close();
    /// Waits until all edits are written; false if the disk has not accepted all of them yet.
    bool flush();

    /// Continues a journal that was not closed; `restore` makes its steps those of the document.
    void goOn(std::string lines, std::vector<std::shared_ptr<const LazyScene>> states,
              const std::function<void()>& restore);
    /// Calls back when all edits up to now are on the disk or the journal is closed; at once if they are.
    void onceKept(std::function<void()> done);
    /// The file; empty while there is none.
    QString path() const;

Q_SIGNALS:
    void failed(const QString& why);  // edits cannot be written
    void mended();  // edits are written again, including those in between

private:
    bool open();
    void begin();
    void tellKept();
    void tell(const QString& why);
    void follow(int index);
    void followFile();

    Document& document_;
    QString folder_;
    std::unique_ptr<JournalFile> file_;
    std::vector<std::shared_ptr<const LazyScene>> states_;  // by index of the undo stack
    std::size_t taken_ = 0;  // of these, those taken over from another journal
    bool isTaking_ = false;
    int index_ = 0, saved_ = 0;
    QString savedAs_;
    bool broken_ = false;
    std::function<void()> kept_;  // callback; none: nothing is waiting
};

}  // namespace keyblock
