// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document of the window: one scene by value, its undo, its file, and what the
// check says of it. A step of undo keeps the scenes before and after; so every edit
// is a function from scene to scene, and none needs a class of its own.
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
class LateScene;
struct Edit;

/// A scene with the name of the step that led to it.
struct RestoredStep {
    QString name;  // of the first empty
    std::shared_ptr<const LateScene> scene;
};

/// What was found in a file that does not open cleanly.
struct PartReading {
    QString path;
    QByteArray text;  // of the file
    std::vector<Problem> problems;  // by line
    std::size_t leftOut = 0;  // objects that lack something they need
    bool isOpen = false;  // the document holds what could be read; else it is as it was
};

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// Never null; what is shown now, a preview included.
    const std::shared_ptr<const Scene>& scene() const;

    /// One step of undo, called `step`; `pointers` say where those of before lead then. An edit that changes nothing
    /// leaves no trace. Ends a preview.
    void apply(const QString& step, Scene after, PointerChange pointers = {});

    /// The same of an edit that may have been refused; tells why, or what else changed. False: refused.
    bool apply(const QString& step, Edit edit);

    /// Shows and checks a scene while a person drags, without a step; `endPreview` goes back to the document.
    void preview(Scene during);
    void endPreview();
    bool isPreviewing() const { return preview_ != nullptr; }

    /// The document without a preview.
    const std::shared_ptr<const Scene>& committed() const { return scene_; }

    QUndoStack& undo() { return *undo_; }

    /// The newest check that is done; of an older scene while a newer one is looked at.
    const Checked& checked() const { return *checked_; }
    bool checkIsCurrent() const;

    const QString& path() const { return path_; }  // empty: never saved
    QString title() const;  // name of the file, or `untitled`
    bool isModified() const;

    /// Replaces everything by a scene that no file holds yet. `isWork`: it counts as edited, as an import does.
    void startNew(Scene scene, const QString& name = {}, bool isWork = false);

    /// Replaces everything by a document with its steps of undo, of which `index` stands and the file holds `saved`. The
    /// other scenes are read when undo or redo comes to them.
    /// \pre `steps` is not empty, both count within it; every scene can be read.
    void restore(const std::vector<RestoredStep>& steps, std::size_t index, std::optional<std::size_t> saved,
                 const QString& path, const QString& name);

    /// Opens a file. What keeps it from being opened comes back, and the document stays as it was; warnings of a scene
    /// that opens come with the check.
    std::vector<Problem> open(const QString& path);

    /// Opens what can be read of a file with errors as a new document without a file, so that saving does not write over
    /// what is left; tells `readInPart`, also where nothing can be read. False: the document stays as it was.
    bool openPart(const QString& path);

    /// Writes the file whole or not at all. \throws CannotWrite
    void save(const QString& path);

    /// What was saved is no longer there, so all of it counts as not saved.
    void fileIsGone();

Q_SIGNALS:
    void changed();  // the scene
    void moved(const keyblock::WhereNow& now);  // after a step, done or undone: what pointers of before mean
    void told(const QString& text, bool warns);  // what a person should know of an edit
    void checkedChanged();
    void fileChanged();  // path, title, or whether modified
    void replaced();  // by another document
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
