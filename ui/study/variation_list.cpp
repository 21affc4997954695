// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/variation_list.h"

#include "solver/scene/pointer.h"
#include "ui/edit/names.h"
#include "ui/look/plain_text.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/study/study_draft.h"
#include "ui/study/study_problems.h"
#include "ui/study/variation.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QTreeWidget>
#include <QVariant>
#include <QVBoxLayout>

#include <array>

namespace keyblock {

namespace {

constexpr int leastListWidth = 280, widestList = 440, listHeight = 190, kindLabelWidth = 150;  // [px]

/// Fields of a parameter with values of this kind, below the choice of the kind.
std::vector<std::string> parameterFields(ValueChoice choice) {
    std::vector<std::string> fields{"name", "path"};
    if (choice == ValueChoice::List) fields.push_back("values");
    else if (choice == ValueChoice::Range)
        for (const char* field : {"range/from", "range/to", "range/count"}) fields.emplace_back(field);
    else
        for (const char* field : {"distribution/mean", "distribution/deviation", "distribution/least",
                                  "distribution/peak", "distribution/most"})
            fields.emplace_back(field);
    fields.push_back("also");
    return fields;
}

const std::vector<std::string> faultFields{
    "name", "kind", "bolts", "probability", "share", "where", "offset_deviation", "angle_deviation"};

bool isParameter(const std::string& pointer) { return pointer.rfind("/parameters/", 0) == 0; }

std::size_t numberIn(const std::string& pointer) { return std::stoul(pointer.substr(pointer.rfind('/') + 1)); }

QString labelFor(const std::string& field) {
    if (field == "path") return VariationList::tr("Field of the scene");
    if (field == "also") return VariationList::tr("Further fields");
    if (field == "distribution/least") return VariationList::tr("Smallest value");
    if (field == "distribution/most") return VariationList::tr("Largest value");
    if (field == "distribution/deviation") return VariationList::tr("Standard deviation");
    return {};
}

/// The unit of the numbers of a parameter: that of the field of the scene, as in its file.
QString unitFor(const Field* varied, const std::string& pointer) {
    const bool isCount = pointer.ends_with("/count");
    return varied && !isCount ? qt(varied->unit).section(", or ", 0, 0) : QString();
}

}  // namespace

VariationList::VariationList(StudyDraft& draft, const Themes& themes, QWidget* parent)
    : QWidget(parent), draft_(draft), themes_(themes), list_(new QTreeWidget(this)),
      add_(new QPushButton(tr("Add"), this)), remove_(new QPushButton(tr("Remove"), this)), kind_(new QComboBox(this)),
      kindRow_(new QWidget(this)), detail_(new QWidget(this)), rows_(new QVBoxLayout), empty_(new QLabel(this)),
      problem_(new QLabel(this)) {
    setObjectName("variationList");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(20);
    row->addWidget(makeList(), 2);
    row->addWidget(makeDetail(), 3);
    connect(list_, &QTreeWidget::currentItemChanged, this, &VariationList::showDetail);
    connect(kind_, qOverload<int>(&QComboBox::activated), this, &VariationList::chooseKind);
    connect(remove_, &QPushButton::clicked, this, &VariationList::remove);
}

QWidget* VariationList::makeList() {
    auto* side = new QWidget(this);
    side->setMinimumWidth(leastListWidth);
    side->setMaximumWidth(widestList);
    list_->setObjectName("study.variations");
    list_->setAccessibleName(tr("What varies"));
    list_->setHeaderLabels({tr("Name"), tr("Values")});
    list_->setRootIsDecorated(false);
    list_->setFixedHeight(listHeight);
    list_->setProperty("framed", true);
    list_->header()->setStretchLastSection(true);
    list_->header()->resizeSection(0, 130);
    auto* menu = new QMenu(add_);
    menu->addAction(tr("Field of the scene"), this, [this] { add("parameter"); });
    menu->addSeparator();
    menu->addAction(tr("Missing bolts"), this, [this] { add("missing"); });
    menu->addAction(tr("Lost bond"), this, [this] { add("bond-lost"); });
    menu->addAction(tr("Misplaced bolts"), this, [this] { add("misplaced"); });
    add_->setMenu(menu);
    add_->setProperty("menu", true);
    add_->setObjectName("study.add");
    add_->setAccessibleName(tr("Add a value that varies"));
    remove_->setObjectName("study.remove");
    remove_->setAccessibleName(tr("Remove the selected value"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(list_);
    column->addLayout(buttons);
    column->addStretch(1);
    return side;
}

QWidget* VariationList::makeDetail() {
    empty_->setText(tr("Right-click a field in Properties and choose “Vary in a study…”, or choose Add."));
    empty_->setObjectName("hint");
    empty_->setWordWrap(true);
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText);
    problem_->setObjectName("study.variationProblem");
    auto* label = new QLabel(tr("Values"), kindRow_);
    label->setFixedWidth(kindLabelWidth);
    kind_->addItems(valueChoices());
    kind_->setObjectName("study.values");
    kind_->setAccessibleName(tr("How the values are given"));
    auto* line = new QHBoxLayout(kindRow_);
    line->setContentsMargins(0, 2, 0, 2);
    line->setSpacing(8);
    line->addWidget(label);
    line->addWidget(kind_);
    line->addStretch(1);
    rows_->setContentsMargins(0, 0, 0, 0);
    rows_->setSpacing(0);
    auto* column = new QVBoxLayout(detail_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(empty_);
    column->addWidget(kindRow_);
    column->addLayout(rows_);
    column->addWidget(problem_);
    column->addStretch(1);
    return detail_;
}

std::string VariationList::selected() const {
    const QTreeWidgetItem* item = list_->currentItem();
    return item ? item->data(0, Qt::UserRole).toString().toStdString() : std::string();
}

void VariationList::fill() {
    const Study& study = draft_.study();
    const auto reading = draft_.checked();
    const std::string before = selected();
    const QSignalBlocker quiet(list_);
    list_->clear();
    const auto list = [&](const std::string& pointer, const QString& name, const QString& values) {
        auto* item = new QTreeWidgetItem(list_, {name, values});
        item->setData(0, Qt::UserRole, qt(pointer));
        item->setToolTip(0, asTip(name));
        item->setToolTip(1, asTip(values));
        if (reading)
            if (const FieldProblems found = problemsAt(reading->problems, pointer, true); !found.text.isEmpty()) {
                const Theme& theme = themes_.current();
                item->setIcon(
                    0, found.isError ? themes_.icon("error", theme.error) : themes_.icon("warning", theme.warning));
                item->setToolTip(0, asTip(found.text));
            }
        if (pointer == before) list_->setCurrentItem(item);
    };
    for (std::size_t i = 0; i < study.parameters.size(); ++i) {
        const StudyParameter& one = study.parameters[i];
        list(under("/parameters", i), qt(one.name.empty() ? one.path : one.name), valuesText(one));
    }
    for (std::size_t i = 0; i < study.faults.size(); ++i)
        list(under("/faults", i), qt(study.faults[i].name), faultText(study.faults[i]));
    if (!list_->currentItem() && list_->topLevelItemCount() > 0) list_->setCurrentItem(list_->topLevelItem(0));
    showDetail();
}

bool VariationList::reveal(const std::string& pointer) {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        const std::string own = list_->topLevelItem(i)->data(0, Qt::UserRole).toString().toStdString();
        if (!isWithin(pointer, own)) continue;
        list_->setCurrentItem(list_->topLevelItem(i));
        for (StudyRow* row : fields_)
            if (row->pointer() == pointer) row->takeFocus();
        return true;
    }
    return false;
}

/// Makes the rows again where other fields are shown than before.
void VariationList::buildRows() {
    const std::string pointer = selected();
    const Study& study = draft_.study();
    std::vector<std::string> fields;
    if (isParameter(pointer)) fields = parameterFields(choiceOf(study.parameters[numberIn(pointer)]));
    else if (!pointer.empty()) fields = faultFields;
    QString shape = qt(pointer);
    for (const std::string& field : fields) shape += ' ' + qt(field);
    if (shape == shape_) return;
    shape_ = shape;
    for (StudyRow* row : fields_) {
        row->hide();
        row->deleteLater();
    }
    fields_.clear();
    for (const std::string& field : fields) {
        const std::string at = pointer + '/' + field;
        const auto place = placeAt(study, at);
        if (!place) continue;
        auto* row = new StudyRow(at, *place, labelFor(field), detail_);
        connect(row, &StudyRow::entered, this, &VariationList::entered);
        rows_->addWidget(row);
        fields_.push_back(row);
    }
}

void VariationList::showDetail() {
    const std::string pointer = selected();
    const Study& study = draft_.study();
    remove_->setEnabled(!pointer.empty());
    empty_->setVisible(pointer.empty());
    kindRow_->setVisible(isParameter(pointer));
    if (isParameter(pointer)) kind_->setCurrentIndex(static_cast<int>(choiceOf(study.parameters[numberIn(pointer)])));
    buildRows();
    const auto reading = draft_.checked();
    const std::vector<Problem> none;
    const std::vector<Problem>& problems = reading ? reading->problems : none;
    const Field* varied = isParameter(pointer) ? fieldAtPath(study.parameters[numberIn(pointer)].path) : nullptr;
    for (StudyRow* row : fields_) {
        if (isParameter(pointer)) row->setUnit(unitFor(varied, row->pointer()));
        row->present(study);
        const FieldProblems found = problemsAt(problems, row->pointer(), true);
        row->setProblems(found.text, found.isError);
    }
    FieldProblems whole = problemsAt(problems, pointer);
    if (whole.text.isEmpty()) whole = problemsAt(problems, pointer + "/distribution");
    problem_->setVisible(!pointer.empty() && !whole.text.isEmpty());
    problem_->setText(whole.text);
    problem_->setProperty("role", whole.isError ? "problem" : "warning");
    problem_->style()->unpolish(problem_);
    problem_->style()->polish(problem_);
}

void VariationList::add(const QString& what) {
    Study study = draft_.study();
    std::vector<std::string> taken;
    for (const StudyParameter& one : study.parameters) taken.push_back(one.name);
    for (const StudyFault& one : study.faults) taken.push_back(one.name);
    std::string made;
    if (what == "parameter") {
        StudyParameter parameter;
        parameter.name = freeName("value ", taken);
        study.parameters.push_back(parameter);
        made = under("/parameters", study.parameters.size() - 1);
    } else {
        static const std::array words{QStringLiteral("missing"), QStringLiteral("bond-lost"),
                                      QStringLiteral("misplaced")};
        StudyFault fault;
        const auto kind = std::find(words.begin(), words.end(), what) - words.begin();
        fault.kind = static_cast<FaultKind>(kind);
        fault.name = freeName(what.toStdString() + " ", taken);
        fault.probability = 0.05;
        if (fault.kind == FaultKind::BondLost) fault.share = {0.1, 0.5};
        if (fault.kind == FaultKind::Misplaced) fault.offsetDeviation = 0.05;
        study.faults.push_back(fault);
        made = under("/faults", study.faults.size() - 1);
    }
    draft_.change(std::move(study));
    reveal(made + (what == "parameter" ? "/path" : "/probability"));
}

void VariationList::remove() {
    const std::string pointer = selected();
    if (pointer.empty()) return;
    Study study = draft_.study();
    const auto index = static_cast<std::ptrdiff_t>(numberIn(pointer));
    if (isParameter(pointer)) study.parameters.erase(study.parameters.begin() + index);
    else study.faults.erase(study.faults.begin() + index);
    draft_.change(std::move(study));
}

void VariationList::chooseKind(int choice) {
    const std::string pointer = selected();
    if (!isParameter(pointer)) return;
    Study study = draft_.study();
    choose(study.parameters[numberIn(pointer)], static_cast<ValueChoice>(choice));
    draft_.change(std::move(study));
}

}  // namespace keyblock
