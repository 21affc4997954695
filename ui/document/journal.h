// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records the edits of a document in a journal, so that a crash loses no work. A
// document without edits has no journal, and none is left behind if the document is
// closed or replaced deliberately.
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

/// The folder of the journals, within the folder for the program's user data.
QString journalFolder();

class Journal : public QObject {
    Q_OBJECT

public:
    explicit Journal(Document& document, const QString& folder = journalFolder(), QObject* parent = nullptr);
    /// Writes pending edits. The journal file stays unless `close` has been called.
    ~Journal() override;

    /// Removes the journal, because the document was saved or its edits were discarded.
    void close();
    /// Waits until all edits are written; returns false if some could not be written to disk.
    bool flush();

    /// Continues a journal that was not closed.
    /// \param lines lines of that journal
    /// \param states scenes of its steps, by index on the undo stack
    /// \param restore restores the undo steps of the journal in the document
    void goOn(std::string lines, std::vector<std::shared_ptr<const LazyScene>> states,
              const std::function<void()>& restore);
    /// Calls `done` once all edits so far are on disk or the journal is closed; immediately if this is already the
    /// case.
    void onceKept(std::function<void()> done);
    /// Path of the journal file; empty if there is none.
    QString path() const;

Q_SIGNALS:
    void failed(const QString& why);  // edits cannot be written to disk
    void mended();  // all edits are written again, including those made meanwhile

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
    std::vector<std::shared_ptr<const LazyScene>> states_;  // by index on the undo stack
    std::size_t taken_ = 0;  // how many of these come from another journal
    bool isTaking_ = false;
    int index_ = 0, saved_ = 0;
    QString savedAs_;
    bool broken_ = false;
    std::function<void()> kept_;  // empty: nothing is waiting
};

}  // namespace keyblock
