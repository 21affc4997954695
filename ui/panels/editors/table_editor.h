// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Editors for values with several parts: corners, curves, lists of texts, and names
// with check boxes.
#pragma once

#include "ui/panels/editors/value_editor.h"
#include "ui/panels/fields/value_text.h"

#include <QStringList>

class QVBoxLayout;

namespace keyblock {

class CellTable;
class TableChart;

/// Edits lists of points, pairs (with a chart) or strings, and maps from names to strings.
class TableEditor : public ValueEditor {
    Q_OBJECT

public:
    TableEditor(const FormRow& row, const FormContext& context, QWidget* parent);
    void present(const FormRow& row) override;
    bool isWide() const override { return true; }
    bool tellsUnit() const override { return true; }
    void setRefused(bool refused) override { refused_ = refused; }

private:
    void enter();
    QStringList headings() const;
    std::vector<QStringList> textsOf(const FieldValue& value) const;
    Typed<FieldValue> read(const std::vector<QStringList>& rows) const;
    Typed<FieldValue> readPairs(const std::vector<QStringList>& rows) const;
    std::string_view unit(int column) const;

    FormContext context_;
    FormRow row_;
    CellTable* table_;
    TableChart* chart_ = nullptr;
    std::vector<QStringList> shown_;
    bool refused_ = false;
};

/// Edits a list of names of other objects, with one check box per object.
class NamesEditor : public ValueEditor {
    Q_OBJECT

public:
    NamesEditor(const FormContext& context, QWidget* parent);
    void present(const FormRow& row) override;
    bool isWide() const override { return true; }
    void setRefused(bool) override {}

private:
    void addTick(const QString& name, bool missing);
    void addNothing();
    void enter(const QString& name, bool ticked);

    FormContext context_;
    FormRow row_;
    QVBoxLayout* ticks_;
    std::vector<std::string> names_;  // one per check box, in the same order
    std::size_t known_ = std::string::npos;  // the first `known_` names exist in the scene; npos: nothing is shown yet
};

}  // namespace keyblock
