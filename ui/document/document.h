// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document of the window: one scene by value, its undo stack, its file, and the
// results of the check. An undo step keeps the scenes before and after it, so that
// every edit is a function from scene to scene and needs no class of its own.
#pragma once

#include "ui/document/checked.h"
#include "ui/edit/pointer_change.h"

#include <QByteArray>
#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

class QUndoStack;

namespace keyblock {

class Background;
class LazyScene;
struct Edit;

/// A scene of a restored undo stack, with the name of the undo step that produced it.
struct RestoredStep {
    QString name;  // empty for the first scene
    std::shared_ptr<const LazyScene> scene;
};

/// Result of reading as much as possible from a file with errors.
struct PartReading {
    QString path;
    QByteArray text;  // contents of the file
    std::vector<Problem> problems;  // in the order of their lines
    std::size_t leftOut = 0;  // number of incomplete objects
    bool isOpen = false;  // the document now shows the readable part; otherwise it is unchanged
};

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// The scene shown now, which may be a preview; never null.
    const std::shared_ptr<const Scene>& scene() const;

    /// Adds an undo step called `step`, and ends any preview. An edit that changes nothing adds no step.
    /// \param pointers maps pointers that were valid before the step to the corresponding pointers after it
    void apply(const QString& step, Scene after, PointerChange pointers = {});

    /// Applies an edit and reports its notes. If the edit was refused, reports the reason instead and returns false.
    bool apply(const QString& step, Edit edit);

    /// Shows and checks a scene during a drag, without adding an undo step. `endPreview` shows the scene of the
    /// document again.
    void preview(Scene during);
    void endPreview();
    bool isPreviewing() const { return preview_ != nullptr; }

    /// The scene of the document, even while a preview is shown; never null.
    const std::shared_ptr<const Scene>& committed() const { return scene_; }

    QUndoStack& undo() { return *undo_; }

    /// The latest finished check. It belongs to an older scene while a newer one is being checked.
    const Checked& checked() const { return *checked_; }
    bool checkIsCurrent() const;

    const QString& path() const { return path_; }  // empty: never saved
    QString title() const;  // file name, or `untitled`
    bool isModified() const;

    /// Replaces the document with a scene that is not in a file yet.
    /// \param isWork true: the scene counts as modified, e.g. after an import
    void startNew(Scene scene, const QString& name = {}, bool isWork = false);

    /// Replaces the document with a restored one, including its undo steps. Only the current scene is read at once; the
    /// others are read when undo or redo reaches them.
    /// \param index index of the current step
    /// \param saved index of the step that is in the file; null: none
    /// \pre `steps` is not empty, both indices are valid, and every scene can be read.
    void restore(const std::vector<RestoredStep>& steps, std::size_t index, std::optional<std::size_t> saved,
                 const QString& path, const QString& name);

    /// Opens a file. If this fails, returns the errors and leaves the document unchanged. If it succeeds, warnings
    /// about the scene are reported by the check.
    std::vector<Problem> open(const QString& path);

    /// Opens the readable part of a file with errors as a new document without a file, so that saving does not
    /// overwrite the original. Emits `readInPart` in any case. Returns false and leaves the document unchanged if
    /// nothing can be read.
    bool openPart(const QString& path);

    /// Writes the file atomically. \throws CannotWrite
    void save(const QString& path);

    /// Call this if the file no longer exists; the document then counts as modified.
    void fileIsGone();

Q_SIGNALS:
    void changed();  // the scene changed
    void moved(const keyblock::WhereNow& now);  // after a step or its undo; maps earlier pointers to the new ones
    void reported(const QString& text, bool warns);  // a message about an edit
    void checkedChanged();
    void fileChanged();  // the path, the title, or whether the document is modified
    void replaced();  // a different document is open
    void readInPart(const keyblock::PartReading& reading);

private:
    friend class SceneStep;
    void setScene(std::shared_ptr<const Scene> scene);
    void take(const Scene& from, const std::shared_ptr<const Scene>& to, const PointerChange& pointers);
    void start(Scene scene, const QString& path, const QString& name);
    void show();

    QUndoStack* undo_;
    Background* checking_;
    std::shared_ptr<const Scene> scene_, preview_;
    std::shared_ptr<const Checked> checked_;
    QString path_, name_;
    bool isRestoring_ = false;
};

}  // namespace keyblock
