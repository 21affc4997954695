// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Input above the fields of the in-situ stress: depth and K0, or principal stresses and
// their direction. The fields are filled in from this input as one edit.
#pragma once

#include "ui/panels/editors/value_editor.h"
#include "ui/panels/fields/form_rows.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace keyblock {

class StressStrip : public QWidget {
    Q_OBJECT

public:
    StressStrip(const FormContext& context, QWidget* parent);

    /// Shows the strip if `pointer` refers to the in-situ stress; otherwise hides it.
    void setObject(const std::string& pointer);

private:
    enum class Way { Depth, Principal };

    /// An input field for a number in display units.
    struct Field {
        QLineEdit* editor;
        QLabel* name;
        const char* unit;  // SI unit
        Way way;
    };

    void addField(Way way, const char* id, const char* unit);
    void fill();
    void nameFields();
    void showWay();
    void apply();
    std::optional<double> valueOf(std::size_t field);
    void setValue(std::size_t field, double value);

    FormContext context_;
    QComboBox* way_;
    QFormLayout* form_;
    std::vector<Field> fields_;
    QLabel* problem_;
};

}  // namespace keyblock
