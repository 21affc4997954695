// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Follows a document and keeps its edits in a journal, so that a program that ends
// without being asked costs no work. A document without edits has none, and one
// that is closed or replaced on purpose leaves none.
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
class LateScene;

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
    /// Waits until all edits are written; false where the disk did not take all of them yet.
    bool flush();

    /// Keeps on with the lines of a journal that nobody closed, whose steps `restore` makes the document's.
    void goOn(std::string lines, std::vector<std::shared_ptr<const LateScene>> states,
              const std::function<void()>& restore);
    /// Calls once every edit until now is on the disk, or the journal is closed; now where they are.
    void onceKept(std::function<void()> done);
    /// The file; empty while there is none.
    QString path() const;

Q_SIGNALS:
    void failed(const QString& why);  // edits are no longer kept
    void mended();  // they are kept again, those in between too

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
    std::vector<std::shared_ptr<const LateScene>> states_;  // by index of the undo stack
    std::size_t taken_ = 0;  // of these, those that the file has from another's lines
    bool isTaking_ = false;
    int index_ = 0, saved_ = 0;
    QString savedAs_;
    bool broken_ = false;
    std::function<void()> kept_;  // whom to tell; none: nobody waits
};

}  // namespace keyblock
