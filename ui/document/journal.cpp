// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/journal.h"

#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"
#include "ui/document/document.h"
#include "ui/document/journal_file.h"
#include "ui/document/lazy_scene.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QStandardPaths>
#include <QUndoStack>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace keyblock {

namespace {

/// A name not used by another window or earlier in this one.
QString newJournalPath(const QString& folder) {
    static int count = 0;
    const QString time = QDateTime::currentDateTimeUtc().toString("yyyyMMdd-hhmmss-zzz");
    return QStringLiteral("%1/%2-%3-%4.journal").arg(folder, time).arg(QCoreApplication::applicationPid()).arg(++count);
}

}  // namespace

QString journalFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/journals";
}

Journal::Journal(Document& document, const QString& folder, QObject* parent)
    : QObject(parent), document_(document), folder_(folder) {
    close();
    connect(&document, &Document::replaced, this, &Journal::close);
    connect(&document.undo(), &QUndoStack::indexChanged, this, &Journal::follow);
    connect(&document, &Document::fileChanged, this, &Journal::followFile);
}

Journal::~Journal() = default;

void Journal::close() {
    if (kept_) std::exchange(kept_, nullptr)();
    if (file_) file_->remove();
    file_.reset();
    broken_ = false;
    states_ = {std::make_shared<const LazyScene>(document_.committed())};
    taken_ = 0;
    index_ = 0;
    saved_ = document_.undo().cleanIndex();
    savedAs_ = document_.path();
}

bool Journal::flush() { return file_ && file_->flush(); }

void Journal::goOn(std::string lines, std::vector<std::shared_ptr<const LazyScene>> states,
                   const std::function<void()>& restore) {
    isTaking_ = true;
    restore();
    isTaking_ = false;
    states_ = std::move(states);
    index_ = document_.undo().index();
    saved_ = document_.undo().cleanIndex();
    savedAs_ = document_.path();
    if (!open()) return;
    taken_ = states_.size();
    file_->begin(std::move(lines));
    if (broken_) tell({});
}

void Journal::onceKept(std::function<void()> done) {
    kept_ = std::move(done);
    tellKept();
}

void Journal::tellKept() {
    if (kept_ && flush()) std::exchange(kept_, nullptr)();
}

QString Journal::path() const { return file_ ? QString::fromStdString(file_->path().string()) : QString(); }

bool Journal::open() {
    try {
        const std::filesystem::path folder = folder_.toStdString();
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error) throw CannotWrite(cannotWriteText(folder, error.value()));
        file_ = std::make_unique<JournalFile>(newJournalPath(folder_).toStdString(), [this](const std::string& why) {
            QMetaObject::invokeMethod(this, [this, why] { tell(QString::fromStdString(why)); }, Qt::QueuedConnection);
        });
    } catch (const CannotWrite& error) {
        tell(QString::fromUtf8(error.what()));
    }
    return file_ != nullptr;
}

/// If the file cannot be created now, the next edit tries again and then also writes the edits before it.
void Journal::begin() {
    if (file_ || !open()) return;
    file_->begin(savedAs_.toStdString(), document_.title().toStdString(), states_.front()->get(), saved_ == 0);
    for (std::size_t i = 1; i < states_.size(); ++i)
        file_->step(i, document_.undo().text(static_cast<int>(i) - 1).toStdString(), states_[i - 1]->get(),
                    states_[i]->get());
    if (saved_ > 0) file_->saved(static_cast<std::size_t>(saved_), savedAs_.toStdString());
    if (broken_) tell({});
}

/// Reports a change of the error state. \param why reason of the error; empty if the journal can be written again.
void Journal::tell(const QString& why) {
    if (broken_ == !why.isEmpty()) return;
    broken_ = !why.isEmpty();
    if (broken_) return Q_EMIT failed(why);
    Q_EMIT mended();
    tellKept();
}

void Journal::follow(int index) {
    if (isTaking_) return;
    const std::shared_ptr<const Scene>& now = document_.committed();
    const std::size_t at = index;
    const bool isKnown = at < states_.size() && states_[at]->known() == now;
    if (isKnown && index == index_) return;
    if (!isKnown && (at == 0 || at > states_.size())) return;  // another document, which sends its own signal
    begin();
    index_ = index;
    if (isKnown) {
        if (file_) file_->move(at);
        return;
    }
    states_.resize(at);
    states_.push_back(std::make_shared<const LazyScene>(now));
    const QString name = document_.undo().text(index - 1);
    if (file_) file_->step(at, name.toStdString(), at <= taken_ ? nullptr : states_[at - 1]->get(), now);
    taken_ = std::min(taken_, at);
}

void Journal::followFile() {
    const int saved = document_.undo().cleanIndex();
    if (saved == saved_ && document_.path() == savedAs_) return;
    saved_ = saved;
    savedAs_ = document_.path();
    const auto at = saved < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(saved));
    if (file_) file_->saved(at, savedAs_.toStdString());
}

}  // namespace keyblock
