// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/axis_choice.h"

#include "ui/picture/charts/history_series.h"
#include "ui/look/plain_text.h"

#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>

namespace keyblock {

namespace {

QComboBox* addBox(QWidget& row, const char* name, const QString& title) {
    auto* box = new QComboBox(&row);
    box->setObjectName(name);
    box->setAccessibleName(title);
    box->setToolTip(asTip(title));
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->completer()->setCompletionMode(QCompleter::PopupCompletion);
    box->completer()->setFilterMode(Qt::MatchContains);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(15);
    // Typed text that is not a name is reset to the current choice.
    QObject::connect(box->lineEdit(), &QLineEdit::editingFinished, box,
                     [box] { box->setEditText(box->itemText(box->currentIndex())); });
    row.layout()->addWidget(box);
    return box;
}

/// The name as it is shown, for example "B1 · axial force" for B1.axial_force.
QString shownName(const std::string& name) {
    QString shown = QString::fromStdString(name);
    const int dot = shown.lastIndexOf('.');
    if (dot > 0) shown = shown.left(dot) + QString::fromUtf8(" · ") + shown.mid(dot + 1).replace('_', ' ');
    return shown;
}

void fill(QComboBox& box, const std::vector<Series>& all, const QString& first) {
    const QSignalBlocker quiet(&box);
    const QString before = box.currentData().toString();
    box.clear();
    if (!first.isEmpty()) box.addItem(first, QString());
    for (const Series& series : all) box.addItem(shownName(series.name), QString::fromStdString(series.name));
    box.setCurrentIndex(std::max(0, box.findData(before)));
}

}  // namespace

AxisChoice::AxisChoice(QWidget* parent) : QWidget(parent) {
    setObjectName("axisChoice");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    y_ = addBox(*this, "curveY", tr("Quantity on the y axis"));
    row->addWidget(new QLabel(tr("against"), this));
    x_ = addBox(*this, "curveX", tr("Quantity on the x axis"));
    for (QComboBox* box : {y_, x_}) connect(box, QOverload<int>::of(&QComboBox::activated), this, &AxisChoice::chosen);
}

void AxisChoice::offer(const RunSource& run) {
    const std::vector<Series> all = allSeries(run);
    fill(*y_, all, {});
    fill(*x_, all, tr("time"));
}

std::string AxisChoice::y() const { return y_->currentData().toString().toStdString(); }
std::string AxisChoice::x() const { return x_->currentData().toString().toStdString(); }

}  // namespace keyblock
