// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Properties panel at the right of the window: the fields of the selected objects,
// with help on the focused field at the bottom. Shows the settings of the scene if
// nothing is selected.
#pragma once

#include "ui/panels/editors/value_editor.h"
#include "ui/panels/fields/form_rows.h"

#include <QStringList>
#include <QWidget>

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace keyblock {

class AnchorStrip;
class FieldForm;
class FilterLine;
class Selection;
class StressStrip;

class PropertyPanel : public QWidget {
    Q_OBJECT

public:
    PropertyPanel(const FormContext& context, Selection& selection, QWidget* parent = nullptr);

    /// Moves the focus to a field of the selected objects; returns false if the field is not shown.
    bool focusField(const QString& path);

    /// Moves the focus to the field with this JSON pointer, if it belongs to the first object shown.
    void focusPointer(const QString& pointer);

    FieldForm& form() const { return *form_; }

    /// Places a widget above the fields.
    void addAbove(QWidget* widget);
    /// Shows `title` and, below it, `detail` instead of the description of the selection; empty strings restore the
    /// description. As long as a title is set, the panel shows no fields if nothing is selected.
    void setSubject(const QString& title, const QString& detail);

Q_SIGNALS:
    void libraryAsked(const QString& type);  // name of a built-in type, which is not part of the scene
    void varyAsked(const QStringList& pointers);  // pointers to a field of all objects, to vary it in a study

private:
    void follow();
    void goTo(const QString& pointer);
    void present(const QStringList& pointers);
    void showHeader();
    void showFoot();
    void showHelp(const FormRow& row);
    QWidget* makeHeader();
    QWidget* makeFoot();

    FormContext context_;
    Selection& selection_;
    QLabel *title_, *detail_, *helpTitle_, *helpText_;
    QToolButton* pin_;
    QStringList pinned_;  // pointers to the objects shown, which stay the same while the panel is pinned
    FilterLine* filter_;
    QScrollArea* scroll_;
    FieldForm* form_;
    AnchorStrip* strip_;
    StressStrip* stress_;
    QVBoxLayout* page_ = nullptr;
    QString subject_, subjectDetail_;
};

}  // namespace keyblock
