// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Properties panel at the right of the window: the fields of the selection, with
// the help on the focused field at the bottom. Without a selection: the settings of
// the scene.
#pragma once

#include "ui/panels/form_rows.h"
#include "ui/panels/value_editor.h"

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

    /// Puts the cursor in a field of the selection; false if it is not shown.
    bool focusField(const QString& path);

    /// The same by the pointer of the field, in any object shown.
    void focusPointer(const QString& pointer);

    FieldForm& form() const { return *form_; }

    /// Places a widget above the fields.
    void addAbove(QWidget* widget);
    /// Title and second line instead of those of the selection; without a selection no fields are shown then.
    /// Empty: none.
    void setSubject(const QString& title, const QString& detail);

Q_SIGNALS:
    void libraryAsked(const QString& type);  // the type is built in, not part of the scene

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
    QStringList pinned_;  // the objects shown
    FilterLine* filter_;
    QScrollArea* scroll_;
    FieldForm* form_;
    AnchorStrip* strip_;
    StressStrip* stress_;
    QVBoxLayout* page_ = nullptr;
    QString subject_, subjectDetail_;
};

}  // namespace keyblock
