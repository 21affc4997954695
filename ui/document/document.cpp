// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.h"

#include "solver/files/json/json_tree.h"
#include "solver/files/kept_files.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/scene/scene_rescue.h"
#include "ui/document/background.h"
#include "ui/document/lazy_scene.h"
#include "ui/edit/edit.h"
#include "ui/edit/locate.h"
#include "ui/edit/settle.h"

#include <QFile>
#include <QFileInfo>
#include <QUndoStack>

#include <algorithm>
#include <cassert>

namespace keyblock {

namespace {

constexpr std::size_t mostNotes = 3;  // notes on other changes that are shown after an edit

QByteArray contentOf(const QString& path) {
    if (!QFileInfo(path).isFile()) return {};  // opening a named pipe would wait for its writer
    QFile file(path);
    return QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly) && file.size() <= qint64(longestJson)
               ? file.readAll()
               : QByteArray();
}

SceneRescue rescued(const QString& path, const QByteArray& content) {
    const std::string name = path.toStdString();
    return rescueSceneText({content.constData(), static_cast<std::size_t>(content.size())}, name,
                           std::filesystem::path(name).parent_path());
}

}  // namespace

/// The only kind of undo step: it holds the scenes before and after the change.
class SceneStep : public QUndoCommand {
public:
    using Late = std::shared_ptr<const LazyScene>;

    SceneStep(Document& document, const QString& text, Late before, Late after, PointerChange pointers = {})
        : QUndoCommand(text), document_(document), before_(std::move(before)), after_(std::move(after)),
          pointers_(std::move(pointers)) {}
    void undo() override { take(*after_, *before_, pointers_.reversed()); }
    void redo() override { take(*before_, *after_, pointers_); }

private:
    /// If a recovered scene cannot be read, no empty scene is shown in its place: the current scene stays and is marked
    /// as unsaved.
    void take(const LazyScene& from, const LazyScene& to, const PointerChange& pointers) {
        if (document_.isRestoring_) return;
        if (to.get()) return document_.take(from.get() ? *from.get() : *document_.scene_, to.get(), pointers);
        document_.undo_->resetClean();
        Q_EMIT document_.reported(
            Document::tr("The scene stored with the step “%1” cannot be read from the journal. The current scene is "
                         "unchanged.")
                .arg(text()),
            true);
    }

    Document& document_;
    Late before_, after_;
    PointerChange pointers_;
};

Document::Document(QObject* parent)
    : QObject(parent), undo_(new QUndoStack(this)), checking_(new Background(this)),
      scene_(std::make_shared<const Scene>()), checked_(std::make_shared<const Checked>(Checked{scene_, {}, {}, {}})) {
    connect(undo_, &QUndoStack::cleanChanged, this, &Document::fileChanged);
}

Document::~Document() {
    undo_->disconnect();  // the undo stack clears itself after this document is destroyed
}

const std::shared_ptr<const Scene>& Document::scene() const { return preview_ ? preview_ : scene_; }

bool Document::apply(const QString& step, Edit edit) {
    if (!edit.done()) {
        endPreview();
        Q_EMIT reported(QString::fromStdString(edit.refusal), true);
        return false;
    }
    apply(step, std::move(edit.scene), std::move(edit.pointers));
    QStringList sentences;
    for (std::size_t i = 0; i < std::min(edit.notes.size(), mostNotes); ++i)
        sentences << QString::fromStdString(edit.notes[i]);
    if (!sentences.isEmpty()) Q_EMIT reported(sentences.join(' '), false);
    return true;
}

void Document::apply(const QString& step, Scene after, PointerChange pointers) {
    settle(after);
    const bool previewed = preview_ != nullptr;
    preview_.reset();
    if (after == *scene_) {
        if (previewed) show();
        return;
    }
    const auto late = [](std::shared_ptr<const Scene> scene) {
        return std::make_shared<const LazyScene>(std::move(scene));
    };
    undo_->push(new SceneStep(*this, step, late(scene_), late(std::make_shared<const Scene>(std::move(after))),
                              std::move(pointers)));
}

void Document::preview(Scene during) {
    settle(during);
    preview_ = std::make_shared<const Scene>(std::move(during));
    show();
}

void Document::endPreview() {
    if (!preview_) return;
    preview_.reset();
    show();
}

bool Document::checkIsCurrent() const { return checked_->scene == scene(); }

QString Document::title() const {
    if (!path_.isEmpty()) return QFileInfo(path_).fileName();
    return name_.isEmpty() ? tr("untitled") : name_;
}

bool Document::isModified() const { return !undo_->isClean(); }

void Document::startNew(Scene scene, const QString& name, bool isWork) {
    start(std::move(scene), {}, name);
    if (!isWork) return;
    undo_->resetClean();
    Q_EMIT fileChanged();
}

void Document::restore(const std::vector<RestoredStep>& steps, std::size_t index, std::optional<std::size_t> saved,
                       const QString& path, const QString& name) {
    assert(index < steps.size() && (!saved || *saved < steps.size()));
    undo_->clear();
    path_ = path;
    name_ = name;
    setScene(steps[index].scene->get());
    Q_EMIT replaced();
    {
        const QSignalBlocker quiet(this);  // one signal instead of one for each step
        isRestoring_ = true;
        for (std::size_t i = 1; i < steps.size(); ++i)
            undo_->push(new SceneStep(*this, steps[i].name, steps[i - 1].scene, steps[i].scene));
        if (saved) undo_->setIndex(static_cast<int>(*saved));
        if (saved) undo_->setClean();
        else undo_->resetClean();
        undo_->setIndex(static_cast<int>(index));
        isRestoring_ = false;
    }
    Q_EMIT fileChanged();
}

std::vector<Problem> Document::open(const QString& path) {
    SceneReading reading = readSceneFile(path.toStdString());
    if (reading.scene) {
        start(std::move(*reading.scene), QFileInfo(path).absoluteFilePath(), {});
        return {};
    }
    SceneRescue rescue = rescued(path, contentOf(path));
    if (!rescue.scene || !rescue.isWhole) return reading.problems;
    start(std::move(*rescue.scene), QFileInfo(path).absoluteFilePath(), {});  // the check reports the remaining errors
    return {};
}

bool Document::openPart(const QString& path) {
    PartReading reading{path, contentOf(path), {}, 0, false};
    if (reading.text.isEmpty()) {  // says why it cannot be read
        reading.problems = readSceneFile(path.toStdString()).problems;
        Q_EMIT readInPart(reading);
        return false;
    }
    SceneRescue rescue = rescued(path, reading.text);
    reading.problems = std::move(rescue.problems);
    if (reading.problems.empty()) reading.problems = readSceneFile(path.toStdString()).problems;
    std::ranges::stable_sort(reading.problems, {}, &Problem::line);
    reading.leftOut = rescue.leftOut.size();
    reading.isOpen = rescue.scene.has_value();
    if (rescue.scene)
        startNew(std::move(*rescue.scene), tr("%1 (partial)").arg(QFileInfo(path).completeBaseName()), true);
    Q_EMIT readInPart(reading);
    return reading.isOpen;
}

void Document::save(const QString& path) {
    requireReplaceable(path.toStdString(), {}, Scenes::Replaced);
    writeSceneFile(path.toStdString(), *scene_);
    path_ = QFileInfo(path).absoluteFilePath();
    {
        const QSignalBlocker quiet(this);  // signalled below, together with the path
        undo_->setClean();
    }
    Q_EMIT fileChanged();
}

void Document::fileIsGone() {
    {
        const QSignalBlocker quiet(this);
        undo_->resetClean();
    }
    // also if the document already had unsaved changes, in which case the undo stack sends no signal
    Q_EMIT fileChanged();
}

void Document::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    preview_.reset();
    show();
}

/// A pointer becomes invalid only if its object existed before and no longer exists. Pointers to other objects (such as
/// a bolt of the results) never referred to the scene and are kept.
void Document::take(const Scene& from, const std::shared_ptr<const Scene>& to, const PointerChange& pointers) {
    setScene(to);
    Q_EMIT moved([&](const std::string& pointer) {
        std::optional<std::string> now = pointers.now(pointer);
        if (now && locate(from, pointer) && !locate(*to, *now)) now.reset();
        return now;
    });
}

void Document::start(Scene scene, const QString& path, const QString& name) {
    settle(scene);
    undo_->clear();
    undo_->setClean();  // clear() leaves an empty stack marked as changed
    path_ = path;
    name_ = name;
    setScene(std::make_shared<const Scene>(std::move(scene)));
    Q_EMIT replaced();
    Q_EMIT fileChanged();
}

void Document::show() {
    Q_EMIT changed();
    checking_->ask([this, scene = scene(), ends = &checking_->ends()]() -> Background::Result {
        return [this, checked = checkedOf(scene, ends)] {
            checked_ = checked;
            Q_EMIT checkedChanged();
        };
    });
}

}  // namespace keyblock
