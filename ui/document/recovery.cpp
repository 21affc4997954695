// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery.h"

#include "solver/files/scene/scene_rescue.h"
#include "ui/document/document.h"
#include "ui/document/journal_text.h"
#include "ui/document/lazy_scene.h"
#include "ui/edit/settle.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <optional>

namespace keyblock {

namespace {

constexpr qint64 secondsToBegin = 10;  // an empty journal younger than this may still be written
constexpr std::size_t fewSteps = 32;  // steps between two cached texts

/// A journal that is not in use, locked while it is read.
class Held {
public:
    explicit Held(const QString& path) : file_(::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC)) {
        isFree_ = file_ >= 0 && (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK);
    }
    ~Held() {
        if (file_ >= 0) ::close(file_);
    }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;

    bool isFree() const { return isFree_; }

private:
    int file_;
    bool isFree_;
};

/// Content of a saved file; none if it cannot be read completely at the moment, which does not mean that it is damaged.
std::optional<QByteArray> savedContent(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QByteArray content = file.readAll();
    return content.size() == file.size() ? std::optional(content) : std::nullopt;
}

Journalled read(const QByteArray& content, std::optional<std::size_t> mostChanges = {}) {
    return readJournal({content.constData(), static_cast<std::size_t>(content.size())}, mostChanges);
}

bool isWorthwhile(const Journalled& journal) {
    const bool isInFile = journal.saved == journal.index &&
                          (journal.path.empty() || QFileInfo::exists(QString::fromStdString(journal.path)));
    return journal.changes > 0 && !isInFile;
}

void putAside(const QString& journal) { QFile::rename(journal, journal + ".damaged"); }

Abandoned abandonedOf(const QFileInfo& file, const Journalled& journal) {
    Abandoned abandoned;
    abandoned.journal = file.filePath();
    abandoned.path = QString::fromStdString(journal.path);
    abandoned.title = abandoned.path.isEmpty() ? QString::fromStdString(journal.name)
                                               : QFileInfo(abandoned.path).fileName();
    abandoned.changes = journal.changes;
    abandoned.lastStep = QString::fromStdString(journal.steps[journal.index].name);
    abandoned.last = file.lastModified();
    abandoned.damage = QString::fromStdString(journal.damage);
    return abandoned;
}

/// The scenes of a journal, each built from the text of an earlier one.
class JournalledScenes {
public:
    explicit JournalledScenes(const Journalled& journal) : steps_(journal.steps), path_(journal.path) {}

    /// Null if this program cannot read it.
    std::shared_ptr<const Scene> scene(std::size_t step) {
        SceneRescue rescue = rescueSceneText(text(step), path_, std::filesystem::path(path_).parent_path());
        if (!rescue.scene) return nullptr;
        settle(*rescue.scene);
        return std::make_shared<const Scene>(std::move(*rescue.scene));
    }

private:
    std::string text(std::size_t step) {
        auto from = kept_.upper_bound(step);
        const bool isFirst = from == kept_.begin();
        if (!isFirst) --from;
        std::size_t at = isFirst ? 0 : from->first;
        std::string text = isFirst ? textAfter(steps_.front(), {}) : from->second;
        while (at < step) {
            text = textAfter(steps_[++at], text);
            if (at % fewSteps == 0) kept_.emplace(at, text);
        }
        return text;
    }

    std::vector<JournalStep> steps_;
    std::string path_;
    std::map<std::size_t, std::string> kept_;  // cached texts after some of the steps
};

/// The steps of a journal; empty if the current scene cannot be read. If it can, so can all others, because the same
/// program wrote them.
std::vector<RestoredStep> stepsOf(const Journalled& journal) {
    if (journal.steps.empty()) return {};
    const auto scenes = std::make_shared<JournalledScenes>(journal);
    std::shared_ptr<const Scene> stood = scenes->scene(journal.index);
    if (!stood) return {};
    std::vector<RestoredStep> steps;
    for (std::size_t i = 0; i < journal.steps.size(); ++i)
        steps.push_back({QString::fromStdString(journal.steps[i].name), std::make_shared<const LazyScene>([scenes, i] {
                             return scenes->scene(i);
                         })});
    steps[journal.index].scene = std::make_shared<const LazyScene>(std::move(stood));
    return steps;
}

}  // namespace

std::vector<Abandoned> abandonedJournals(const QString& folder, QStringList* unusable) {
    std::vector<Abandoned> found;
    for (const QFileInfo& file : QDir(folder).entryInfoList({"*.journal"}, QDir::Files, QDir::Time)) {
        const Held held(file.filePath());
        const bool isAboutToBegin =
            file.size() == 0 && file.lastModified().secsTo(QDateTime::currentDateTime()) < secondsToBegin;
        if (!held.isFree() || isAboutToBegin) continue;
        const std::optional<QByteArray> content = savedContent(file.filePath());
        if (!content) {
            if (unusable) *unusable << file.filePath();
            continue;
        }
        const Journalled journal = read(*content);
        if (journal.steps.empty() && !journal.damage.empty()) {
            putAside(file.filePath());
            if (unusable) *unusable << file.filePath() + ".damaged";
        } else if (!isWorthwhile(journal) && journal.damage.empty()) {
            QFile::remove(file.filePath());
        } else {
            found.push_back(abandonedOf(file, journal));
        }
    }
    return found;
}

QString recover(const Abandoned& abandoned, Recover what, Document& document, Journal& journal) {
    const Held held(abandoned.journal);
    if (!held.isFree())
        return Document::tr("%1 is being recovered in another window, or its journal no longer exists.")
            .arg(abandoned.title);
    const bool withoutLast = what == Recover::WithoutLastCommand && abandoned.changes > 0;
    const std::optional<QByteArray> content = savedContent(abandoned.journal);
    if (!content) return Document::tr("The journal of %1 cannot be read.").arg(abandoned.title);
    const Journalled journalled = read(*content, withoutLast ? std::optional(abandoned.changes - 1) : std::nullopt);
    const std::vector<RestoredStep> steps = stepsOf(journalled);
    if (steps.empty()) return Document::tr("The journal of %1 cannot be read.").arg(abandoned.title);
    std::vector<std::shared_ptr<const LazyScene>> states;
    for (const RestoredStep& step : steps) states.push_back(step.scene);
    journal.goOn(content->left(static_cast<int>(journalled.size)).toStdString(), std::move(states), [&] {
        document.restore(steps, journalled.index, journalled.saved, QString::fromStdString(journalled.path),
                         QString::fromStdString(journalled.name));
    });
    journal.onceKept([old = abandoned.journal, isDamaged = !journalled.damage.empty()] {
        if (isDamaged) putAside(old);
        else QFile::remove(old);
    });
    return {};
}

void giveUp(const Abandoned& abandoned) {
    const Held held(abandoned.journal);
    if (held.isFree()) QFile::remove(abandoned.journal);
}

}  // namespace keyblock
