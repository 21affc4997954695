// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A form for one or several objects of the scene, generated from the field table. Every
// edit in the form is one undo step. The form follows all changes of the scene,
// including those made elsewhere.
#pragma once

#include "ui/panels/editors/value_editor.h"
#include "ui/panels/fields/form_rows.h"

#include <QSet>
#include <QWidget>

#include <functional>
#include <memory>

class QTimer;
class QVBoxLayout;

namespace keyblock {

class FormHeading;
class FormRowWidget;
struct Edit;

class FieldForm : public QWidget {
    Q_OBJECT

public:
    explicit FieldForm(const FormContext& context, QWidget* parent = nullptr);

    /// Sets the objects that the form shows, given by their JSON pointers. Invalid pointers are left out.
    void setObjects(std::vector<std::string> pointers);
    const std::vector<std::string>& objects() const { return pointers_; }
    bool hasRows() const { return !rows_.empty(); }

    void setFilter(const QString& text);

    /// Moves the focus to the field with this path, such as `spacing` or `until/unbalanced`; returns false if the form
    /// does not show the field.
    bool focusField(const QString& path);

    /// Updates the form immediately to show the current scene, without waiting for the event loop.
    void refresh();

Q_SIGNALS:
    void rowFocused(const keyblock::FormRow& row);
    void targetAsked(const QString& pointer);  // pointer to the object named in a field
    void varyAsked(const QStringList& pointers);  // pointers to a field of all objects, to vary it in a study

private:
    void schedule();
    void rebuild(const std::vector<FormGroup>& groups);
    void update(const std::vector<FormGroup>& groups);
    void addGroup(const FormGroup& group);
    void enter(FormRowWidget& widget, const FieldValue& value);
    void reset(const FormRow& row);
    void applyToAll(FormRowWidget* widget, const FormRow& row, const QString& step,
                    const std::function<Edit(Scene, const std::string&)>& edit);
    QString problemsAt(const FormRow& row, bool& error) const;
    QString focusedPath() const;
    bool isOpen(const FormGroup& group) const;
    void showOpen();

    FormContext context_;
    std::vector<std::string> pointers_;
    std::shared_ptr<const Scene> shown_;  // kept alive while the rows refer to it
    QString filter_;
    QSet<QString> toggled_;  // groups that the user has opened or closed, compared with their initial state
    QStringList shape_;  // headings and rows as shown
    QWidget* content_ = nullptr;
    std::vector<FormHeading*> headings_;
    std::vector<QWidget*> bodies_;  // one per heading
    std::vector<FormRowWidget*> rows_;
    QTimer* later_;
};

}  // namespace keyblock
