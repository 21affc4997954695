// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/reading_report.h"

#include "ui/document/document.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"

#include <QFileInfo>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSplitter>
#include <QTextBlock>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace keyblock {

namespace {

constexpr int mostText = 4 << 20;  // [bytes] longer texts are truncated

QString titleOf(const PartReading& reading) {
    const QString file = QFileInfo(reading.path).fileName();
    const QString errors = reading.problems.size() == 1
                               ? ReadingReport::tr("1 problem")
                               : ReadingReport::tr("%1 problems").arg(reading.problems.size());
    if (!reading.isOpen) return ReadingReport::tr("%1 was not opened: %2.").arg(file, errors);
    const QString out = reading.leftOut == 1 ? ReadingReport::tr("1 object skipped")
                                             : ReadingReport::tr("%1 objects skipped").arg(reading.leftOut);
    return ReadingReport::tr("%1 was only partially opened, as a new scene: %2, %3. The file itself is unchanged.")
        .arg(file, errors, out);
}

}  // namespace

ReadingReport::ReadingReport(const Themes& themes, QWidget* parent)
    : QWidget(parent), themes_(themes), title_(new QLabel(this)), problems_(new QTreeWidget(this)),
      text_(new QPlainTextEdit(this)) {
    setObjectName("readingReport");
    title_->setObjectName("reportTitle");
    title_->setWordWrap(true);
    problems_->setObjectName("reading.problems");
    problems_->setAccessibleName(tr("Problems in the file"));
    problems_->setHeaderLabels({tr("Line"), tr("Problem"), tr("Remedy")});
    problems_->setRootIsDecorated(false);
    text_->setObjectName("reading.text");
    text_->setAccessibleName(tr("Text of the file"));
    text_->setReadOnly(true);
    text_->setLineWrapMode(QPlainTextEdit::NoWrap);
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(12);
    text_->setFont(fixed);
    auto* split = new QSplitter(this);
    split->addWidget(problems_);
    split->addWidget(text_);
    split->setSizes({600, 500});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->addWidget(title_);
    column->addWidget(split, 1);
    connect(problems_, &QTreeWidget::currentItemChanged, this,
            [this](QTreeWidgetItem* item) { goTo(item ? item->data(0, Qt::UserRole).toInt() : 0); });
}

void ReadingReport::show(const PartReading& reading) {
    title_->setText(titleOf(reading));
    text_->setPlainText(QString::fromUtf8(reading.text.left(mostText)));
    problems_->clear();
    for (const Problem& problem : reading.problems) {
        const QString line = problem.line > 0 ? QString::number(problem.line) : QString();
        auto* item = new QTreeWidgetItem(problems_, {line, QString::fromStdString(problem.message),
                                                     QString::fromStdString(problem.remedy)});
        item->setData(0, Qt::UserRole, problem.line);
        item->setToolTip(1, asTip(item->text(1) + '\n' + QString::fromStdString(problem.pointer)));
        item->setToolTip(2, asTip(item->text(2)));
        const bool isError = problem.severity == Severity::Error;
        item->setIcon(0, themes_.icon(isError ? "error" : "warning",
                                      isError ? themes_.current().error : themes_.current().warning));
    }
    problems_->header()->resizeSection(0, 70);
    problems_->header()->resizeSection(1, 320);
    if (problems_->topLevelItemCount() > 0) problems_->setCurrentItem(problems_->topLevelItem(0));
}

void ReadingReport::goTo(int line) {
    const QTextBlock block = text_->document()->findBlockByNumber(line - 1);
    QList<QTextEdit::ExtraSelection> marks;
    if (line > 0 && block.isValid()) {
        const QTextCursor cursor(block);
        text_->setTextCursor(cursor);
        text_->centerCursor();
        QTextEdit::ExtraSelection mark;
        mark.cursor = cursor;
        mark.format.setBackground(themes_.current().errorSoft);
        mark.format.setProperty(QTextFormat::FullWidthSelection, true);
        marks << mark;
    }
    text_->setExtraSelections(marks);
}

}  // namespace keyblock
