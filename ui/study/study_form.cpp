// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_form.h"

#include "solver/study/case_plan.h"
#include "solver/study/study_fields.h"
#include "ui/look/elided_label.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/study/study_draft.h"
#include "ui/study/study_problems.h"
#include "ui/study/variation_list.h"

#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QVariant>
#include <QVBoxLayout>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int widestForm = 980, problemRows = 5, problemRowHeight = 26;  // [px]

}  // namespace

StudyForm::StudyForm(StudyDraft& draft, const Themes& themes, QWidget* parent)
    : QScrollArea(parent), draft_(draft), page_(new QWidget(this)), column_(new QVBoxLayout(page_)),
      scene_(new ElidedLabel(page_)), sceneNote_(new QLabel(page_)), count_(new QLabel(page_)),
      problemTitle_(new QLabel(page_)), variations_(new VariationList(draft, themes, page_)),
      problems_(new QListWidget(page_)) {
    setObjectName("studyForm");
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    page_->setObjectName("studyFormPage");
    page_->setMaximumWidth(widestForm);
    column_->setContentsMargins(16, 8, 16, 16);
    column_->setSpacing(2);
    problemTitle_->setProperty("role", "title");
    problems_->setObjectName("study.problems");
    problems_->setAccessibleName(tr("Problems of the study"));
    problems_->setProperty("framed", true);
    column_->addWidget(problemTitle_);
    column_->addWidget(problems_);
    addTitle(tr("Scene"));
    scene_->setObjectName("study.scene");
    column_->addWidget(scene_);
    sceneNote_->setWordWrap(true);
    sceneNote_->setProperty("role", "warning");
    sceneNote_->setObjectName("study.sceneNote");
    column_->addWidget(sceneNote_);
    addRow("/title");
    addTitle(tr("What varies"));
    column_->addWidget(variations_);
    addTitle(tr("Cases"));
    addRow("/plan/kind", tr("Plan"));
    addRow("/plan/cases", tr("Number of cases"));
    addRow("/plan/seed", tr("Random seed"));
    count_->setProperty("role", "detail");
    count_->setObjectName("study.count");
    column_->addWidget(count_);
    addTitle(tr("Results"));
    addRow("/quantities", tr("Quantities of interest"), tr("one on each line; empty: those of the scene"));
    addRow("/fails", tr("A case fails if"), tr("e.g. max key.u > 0.05 or lost bolt; empty: no case is judged"));
    addRow("/safety", tr("Factor of safety"));
    addRow("/keep", tr("Frames that are kept"));
    column_->addStretch(1);
    setWidget(page_);
    connect(variations_, &VariationList::entered, this, &StudyForm::enter);
    connect(&draft, &StudyDraft::changed, this, &StudyForm::fill);
    connect(&draft, &StudyDraft::checkedChanged, this, &StudyForm::fill);
    connect(&themes, &Themes::changed, this, &StudyForm::fill);
    connect(problems_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { reveal(item->data(Qt::UserRole).toString().toStdString()); });
    connect(problems_, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem* item) { reveal(item->data(Qt::UserRole).toString().toStdString()); });
    fill();
}

void StudyForm::addTitle(const QString& text) {
    auto* title = new QLabel(text, page_);
    title->setObjectName("listTitle");
    title->setContentsMargins(0, 14, 0, 4);
    column_->addWidget(title);
}

void StudyForm::addRow(const std::string& pointer, const QString& label, const QString& hint) {
    static const Study defaults;
    auto* row = new StudyRow(pointer, *placeAt(defaults, pointer), label, page_);
    if (!hint.isEmpty()) row->setHint(hint);
    connect(row, &StudyRow::entered, this, &StudyForm::enter);
    column_->addWidget(row);
    rows_.push_back(row);
}

void StudyForm::enter(const std::string& pointer, const FieldValue& value) {
    Study study = draft_.study();
    if (!placeAt(study, pointer)) return;
    setValue(study, pointer, value);
    draft_.change(std::move(study));
}

void StudyForm::fill() {
    if (!draft_.isOpen()) return;
    const Study& study = draft_.study();
    scene_->setText(draft_.scenePath().isEmpty() ? tr("no scene") : draft_.scenePath());
    sceneNote_->setText(tr("The scene has unsaved edits. The study uses them once the scene is saved."));
    sceneNote_->setVisible(draft_.sceneIsUnsaved());
    const auto reading = draft_.checked();
    const std::vector<Problem> none;
    for (StudyRow* row : rows_) {
        row->present(study);
        const FieldProblems found = problemsAt(reading ? reading->problems : none, row->pointer(), true);
        row->setProblems(found.text, found.isError);
    }
    const bool factorial = study.plan.kind == PlanKind::FullFactorial;
    count_->setVisible(factorial);
    if (factorial) count_->setText(tr("%1 combinations").arg(QLocale::c().toString(qlonglong(combinationsOf(study)))));
    variations_->fill();
    showProblems();
}

/// Lists all problems at the top: some belong to no field, or to one that is out of sight.
void StudyForm::showProblems() {
    problems_->clear();
    const auto reading = draft_.checked();
    if (reading)
        for (const Problem& problem : reading->problems) {
            if (problem.severity == Severity::Note) continue;
            auto* item = new QListWidgetItem(sentenceOf(problem), problems_);
            item->setData(Qt::UserRole, qt(problem.pointer));
            item->setToolTip(qt(oneLine(problem)).toHtmlEscaped());
        }
    const int rows = problems_->count();
    problems_->setVisible(rows > 0);
    problems_->setFixedHeight(std::min(rows, problemRows) * problemRowHeight + 4);
    const int errors = reading ? errorsIn(reading->problems) : 0;
    problemTitle_->setVisible(rows > 0);
    problemTitle_->setText(errors == 0   ? tr("Warnings")
                           : errors == 1 ? tr("1 error to correct")
                                         : tr("%1 errors to correct").arg(errors));
}

void StudyForm::reveal(const std::string& pointer) {
    if (variations_->reveal(pointer)) return ensureWidgetVisible(variations_);
    for (StudyRow* row : rows_)
        if (row->pointer() == pointer) {
            ensureWidgetVisible(row);
            row->takeFocus();
        }
}

}  // namespace keyblock
