// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document of the window: one scene by value, its undo stack, its file, and the
// results of the check. An undo step keeps the scenes before and after, so that
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

/// A scene with the name of the step that led to it.
struct RestoredStep {
    QString name;  // empty for the first
    std::shared_ptr<const LazyScene> scene;
};

/// Contents of a file with errors.
struct PartReading {
    QString path;
    QByteArray text;  // of the file
    std::vector<Problem> problems;  // by line
    std::size_t leftOut = 0;  // number of incomplete objects
    bool isOpen = false;  // the document has the readable part; else it is unchanged
};

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// Never null; the scene shown now, including a preview.
    const std::shared_ptr<const Scene>& scene() const;

    /// Adds an undo step called `step`; `pointers` maps earlier pointers to the new ones. An edit that changes nothing
    /// adds no step. Ends a preview.
    void apply(const QString& step, Scene after, PointerChange pointers = {});

    /// The same for an edit that may be refused; reports why, or what else changed. False: refused.
    bool apply(const QString& step, Edit edit);

    /// Shows and checks a scene during a drag, without a step; `endPreview` returns to the document.
    void preview(Scene during);
    void endPreview();
    bool isPreviewing() const { return preview_ != nullptr; }

    /// The document without a preview.
    const std::shared_ptr<const Scene>& committed() const { return scene_; }

    QUndoStack& undo() { return *undo_; }

    /// The newest finished check; it belongs to an older scene while a newer one is being checked.
    const Checked& checked() const { return *checked_; }
    bool checkIsCurrent() const;

    const QString& path() const { return path_; }  // empty: never saved
    QString title() const;  // name of the file, or `untitled`
    bool isModified() const;

    /// Replaces everything by a scene that is not in a file yet. `isWork`: it counts as modified, as after an import.
    void startNew(Scene scene, const QString& name = {}, bool isWork = false);

    /// Replaces everything by a document with its undo steps: `index` is the current one, `saved` the one in the file.
    /// The other scenes are read when undo or redo reaches them.
    /// \pre `steps` is not empty and both are valid indices; every scene can be read.
    void restore(const std::vector<RestoredStep>& steps, std::size_t index, std::optional<std::size_t> saved,
                 const QString& path, const QString& name);

    /// Opens a file. Returns the errors if it cannot be opened, and leaves the document unchanged; warnings of a scene
    /// that opens come with the check.
    std::vector<Problem> open(const QString& path);

    /// Opens the readable part of a file with errors as a new document without a file, so that saving does not overwrite
    /// the original; emits `readInPart`, also if nothing can be read. False: the document is unchanged.
    bool openPart(const QString& path);

    /// Writes the file atomically. \throws CannotWrite
    void save(const QString& path);

    /// The saved file is gone, so the document counts as modified.
    void fileIsGone();

Q_SIGNALS:
    void changed();  // the scene
    void moved(const keyblock::WhereNow& now);  // after a step or its undo: maps earlier pointers
    void reported(const QString& text, bool warns);  // a message about an edit
    void checkedChanged();
    void fileChanged();  // path, title, or whether modified
    void replaced();  // with another document
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
