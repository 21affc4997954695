// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A form over one or several objects of the scene, generated from the field table.
// Every edit in it is one undo step. The form follows all changes of the scene,
// including those made elsewhere.
#pragma once

#include "ui/panels/form_rows.h"
#include "ui/panels/value_editor.h"

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

    /// The objects that the form shows; invalid pointers are left out.
    void setObjects(std::vector<std::string> pointers);
    const std::vector<std::string>& objects() const { return pointers_; }
    bool hasRows() const { return !rows_.empty(); }

    void setFilter(const QString& text);

    /// Puts the cursor in the field of that path (`spacing`, `until/unbalanced`); false if it is not shown.
    bool focusField(const QString& path);

    /// Shows the scene as it is now, without waiting for the next round of events.
    void refresh();

Q_SIGNALS:
    void rowFocused(const keyblock::FormRow& row);
    void targetAsked(const QString& pointer);  // the object named in a field

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
    std::shared_ptr<const Scene> shown_;  // kept alive while rows refer to it
    QString filter_;
    QSet<QString> toggled_;  // groups not in their initial state
    QStringList shape_;  // headings and rows as shown
    QWidget* content_ = nullptr;
    std::vector<FormHeading*> headings_;
    std::vector<QWidget*> bodies_;  // one for each heading
    std::vector<FormRowWidget*> rows_;
    QTimer* later_;
};

}  // namespace keyblock
