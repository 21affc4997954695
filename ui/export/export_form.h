// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options of an export: content, quantities, format and size. The form shows the
// rows that apply to the chosen content and makes the export order from them.
#pragma once

#include "ui/export/export_job.h"
#include "ui/export/exportable.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace keyblock {

class ExportForm : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Section, Bolt, Curves, Events, Numbers, Film, Everything };

    explicit ExportForm(QWidget* parent);

    /// Adapts the options to the contents of the run, and selects the quantities and the bolt that the window shows.
    void take(const Exportable& now);
    void choose(ExportWhat what);

    Kind kind() const;
    /// The export that the form describes. Its output path is not set.
    ExportOrder order() const;
    /// Extension of the file to write; empty: the export writes a folder.
    QString ending() const;
    /// Suggested path, without an extension.
    QString suggested() const;

Q_SIGNALS:
    void changed();

private:
    QComboBox* addCombo(const QString& label, const QString& name, const char* id);
    void addRows();
    void fillBlocks();
    void fillBolts();
    void fillExtents();
    void fillFormats();
    void allowArrows(bool allowed);
    void showFields();
    QString note() const;
    FigureRequest request() const;
    void setSize(FigureRequest& request) const;
    void setMoment(FigureRequest& request) const;

    Exportable now_;
    QFormLayout* form_;
    QComboBox *kind_, *blocks_, *bolts_, *extent_, *bolt_, *table_, *format_, *width_, *pixels_, *dpi_;
    QLineEdit* title_;
    QSpinBox* perSecond_;
    QCheckBox* data_;
    QLabel* note_;
};

}  // namespace keyblock
