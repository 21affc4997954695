// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_window.h"

#include "solver/files/read_error.h"
#include "solver/files/text_file.h"
#include "ui/look/qt_text.h"
#include "ui/look/question.h"

#include <QComboBox>
#include <QDate>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QStyle>
#include <QUrl>
#include <QVariant>
#include <QVBoxLayout>

namespace keyblock {

namespace {

constexpr std::uint64_t mostTemplateBytes = std::uint64_t{1} << 20;
constexpr int wholeProgress = 1000;
constexpr const char *projectKey = "report/project", *authorKey = "report/author", *formatKey = "report/format";

QString headingOf(const TemplateSection& section) {
    return qt(section.heading.empty() ? rowOf(section.content).heading : std::string_view(section.heading));
}

/// Shows a hint while the line is empty, in the colour of hints.
void showHint(QLineEdit& line, const QString& hint) {
    line.setPlaceholderText(hint);
    const auto colour = [&line] {
        line.setProperty("empty", line.text().isEmpty());
        line.style()->unpolish(&line);
        line.style()->polish(&line);
    };
    QObject::connect(&line, &QLineEdit::textChanged, &line, colour);
    colour();
}

}  // namespace

ReportWindow::ReportWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), message_(new QLabel(this)), templateProblem_(new QLabel(this)),
      sections_(new QListWidget(this)), progress_(new QProgressBar(this)), up_(new QPushButton(tr("Up"), this)),
      down_(new QPushButton(tr("Down"), this)), create_(new QPushButton(tr("Create report"), this)),
      stop_(new QPushButton(tr("Stop"), this)), show_(new QPushButton(tr("Open"), this)), job_(new ReportJob(this)) {
    setObjectName("reportWindow");
    setWindowTitle(tr("Report"));
    auto* row = new QHBoxLayout;
    row->setSpacing(20);
    row->addWidget(makeForm(), 3);
    row->addWidget(makeSections(), 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addLayout(row, 1);
    column->addWidget(progress_);
    column->addWidget(makeFoot());
    resize(860, 470);
    connect(job_, &ReportJob::advanced, this, [this](const QString& what, double done) {
        progress_->setValue(static_cast<int>(done * wholeProgress));
        message_->setText(what);
    });
    connect(job_, &ReportJob::ended, this, &ReportWindow::end);
    showState();
}

ReportWindow::~ReportWindow() = default;

QLineEdit* ReportWindow::addLine(QFormLayout& form, const QString& label, const char* name, const QString& hint) {
    auto* line = new QLineEdit(this);
    line->setObjectName(name);
    line->setAccessibleName(label);
    showHint(*line, hint);
    form.addRow(label, line);
    return line;
}

QLineEdit* ReportWindow::addFile(QFormLayout& form, const QString& label, const char* name, const QString& hint,
                                 void (ReportWindow::*browse)(), QWidget* below) {
    auto* line = new QLineEdit(this);
    line->setObjectName(name);
    line->setAccessibleName(label);
    showHint(*line, hint);
    auto* button = new QPushButton(tr("Choose…"), this);
    button->setAccessibleName(tr("Choose a file: %1").arg(label));
    connect(button, &QPushButton::clicked, this, browse);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(line, 1);
    row->addWidget(button);
    auto* column = new QVBoxLayout;  // a hidden row of the form would leave its spacing
    column->setSpacing(4);
    column->addLayout(row);
    if (below) column->addWidget(below);
    form.addRow(label, column);
    return line;
}

QWidget* ReportWindow::makeForm() {
    auto* side = new QWidget(this);
    auto* form = new QFormLayout(side);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(8);
    format_ = new QComboBox(this);
    format_->setObjectName("report.format");
    format_->setAccessibleName(tr("Format"));
    format_->addItem(tr("PDF, A4 pages"), "pdf");
    format_->addItem(tr("HTML, one file"), "html");
    form->addRow(tr("Format"), format_);
    project_ = addLine(*form, tr("Project"), "report.project", tr("left out if empty"));
    author_ = addLine(*form, tr("Author"), "report.author", tr("left out if empty"));
    date_ = addLine(*form, tr("Date"), "report.date", tr("left out if empty"));
    templateProblem_->setWordWrap(true);
    templateProblem_->setTextFormat(Qt::PlainText);
    templateProblem_->setProperty("role", "problem");
    templateProblem_->setObjectName("report.templateProblem");
    template_ = addFile(*form, tr("Template"), "report.template", tr("all sections"), &ReportWindow::browseTemplate,
                        templateProblem_);
    logo_ = addFile(*form, tr("Logo"), "report.logo", tr("none"), &ReportWindow::browseLogo);
    out_ = addFile(*form, tr("File"), "report.out", {}, &ReportWindow::browseOut);
    connect(format_, qOverload<int>(&QComboBox::activated), this, &ReportWindow::followFormat);
    connect(template_, &QLineEdit::editingFinished, this, &ReportWindow::takeTemplate);
    connect(out_, &QLineEdit::textChanged, this, &ReportWindow::showState);
    return side;
}

QWidget* ReportWindow::makeSections() {
    auto* side = new QWidget(this);
    auto* title = new QLabel(tr("Sections"), side);
    title->setProperty("role", "title");
    sections_->setObjectName("report.sections");
    sections_->setAccessibleName(tr("Sections of the report"));
    sections_->setProperty("framed", true);
    sections_->setDragDropMode(QAbstractItemView::InternalMove);
    up_->setObjectName("report.up");
    up_->setAccessibleName(tr("Move the section up"));
    down_->setObjectName("report.down");
    down_->setAccessibleName(tr("Move the section down"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(up_);
    buttons->addWidget(down_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(title);
    column->addWidget(sections_, 1);
    column->addLayout(buttons);
    connect(up_, &QPushButton::clicked, this, [this] { moveSection(-1); });
    connect(down_, &QPushButton::clicked, this, [this] { moveSection(1); });
    connect(sections_, &QListWidget::itemChanged, this, &ReportWindow::showState);
    connect(sections_, &QListWidget::currentRowChanged, this, &ReportWindow::showState);
    return side;
}

QWidget* ReportWindow::makeFoot() {
    auto* foot = new QWidget(this);
    progress_->setTextVisible(false);
    progress_->setRange(0, wholeProgress);
    progress_->setAccessibleName(tr("Progress of the report"));
    message_->setWordWrap(true);
    message_->setTextFormat(Qt::PlainText);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->setObjectName("report.message");
    create_->setProperty("primary", true);
    create_->setObjectName("report.create");
    stop_->setObjectName("report.stop");
    show_->setObjectName("report.show");
    show_->hide();
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(message_, 1);
    for (QPushButton* button : {show_, stop_, create_}) {
        button->setAccessibleName(button->text());
        row->addWidget(button);
    }
    connect(create_, &QPushButton::clicked, this, &ReportWindow::create);
    connect(stop_, &QPushButton::clicked, this, [this] { job_->stop(); });
    connect(show_, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(out_->text())); });
    return foot;
}

void ReportWindow::open(const Reportable& subject) {
    const bool isOther = subject.source != subject_.source;
    if (isOther && !job_->isBusy()) {
        const bool isOtherKind = subject_.source.empty() || subject.kind != subject_.kind;
        subject_ = subject;
        const QSettings settings;
        format_->setCurrentIndex(std::max(0, format_->findData(settings.value(formatKey, "pdf"))));
        if (project_->text().isEmpty()) project_->setText(settings.value(projectKey).toString());
        if (author_->text().isEmpty()) author_->setText(settings.value(authorKey).toString());
        if (date_->text().isEmpty()) date_->setText(QDate::currentDate().toString(Qt::ISODate));
        out_->setText(qt(subject.suggested.string()) + '.' + format_->currentData().toString());
        if (isOtherKind) takeTemplate();
        message_->clear();
        show_->hide();
    }
    setWindowTitle(subject_.kind == ReportKind::Run
                       ? tr("Report of %1").arg(qt(subject_.source.filename().string()))
                       : tr("Report of the study %1").arg(qt(subject_.source.filename().string())));
    showState();
    show();
    raise();
    activateWindow();
}

void ReportWindow::browseTemplate() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Choose a template"), QFileInfo(out_->text()).path(),
                                                      tr("Texts (*.txt);;All files (*)"));
    if (path.isEmpty()) return;
    template_->setText(path);
    takeTemplate();
}

void ReportWindow::browseLogo() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Choose a logo"), QFileInfo(out_->text()).path(),
                                                      tr("Pictures (*.png *.jpg *.jpeg *.svg)"));
    if (!path.isEmpty()) logo_->setText(path);
}

/// Whether a file is replaced is asked when the report is created, for typed paths too.
void ReportWindow::browseOut() {
    const QString ending = format_->currentData().toString();
    QString path = QFileDialog::getSaveFileName(this, tr("File of the report"), out_->text(), "*." + ending, nullptr,
                                                QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty()) return;
    if (!path.endsWith('.' + ending)) path += '.' + ending;
    out_->setText(path);
}

/// Shows the sections of the chosen template; without one all that a report can have.
void ReportWindow::takeTemplate() {
    QString problem;
    given_ = defaultTemplate(subject_.kind);
    const QString path = template_->text().trimmed();
    if (!path.isEmpty()) try {
            const TemplateReading reading = readTemplate(
                readTextFile(path.toStdString(), {mostTemplateBytes, "choose a text file", "shorten its texts"}));
            if (reading.layout) given_ = *reading.layout;
            else problem = qt(reading.problem);
            for (const TemplateSection& section : given_.sections)
                if (!appliesTo(rowOf(section.content), subject_.kind))
                    problem =
                        tr("The section “%1” does not apply to this report; clear its box.").arg(headingOf(section));
        } catch (const CannotRead& error) {
            problem = QString::fromUtf8(error.what());
        }
    templateProblem_->setText(problem);
    templateProblem_->setVisible(!problem.isEmpty());
    const QString logo = qt(given_.logo);
    logo_->setText(logo.isEmpty() ? QString() : QDir::cleanPath(QFileInfo(path).dir().absoluteFilePath(logo)));
    rows_ = given_.sections;
    for (const TemplateSection& one : defaultTemplate(subject_.kind).sections) {
        const bool isThere = std::any_of(rows_.begin(), rows_.end(),
                                         [&](const TemplateSection& row) { return row.content == one.content; });
        if (!isThere) rows_.push_back(one);
    }
    showSections();
}

void ReportWindow::showSections() {
    const QSignalBlocker quiet(sections_);
    sections_->clear();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        auto* item = new QListWidgetItem(headingOf(rows_[i]), sections_);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled);
        const bool isGiven = i < given_.sections.size() && appliesTo(rowOf(rows_[i].content), subject_.kind);
        item->setCheckState(isGiven ? Qt::Checked : Qt::Unchecked);
        item->setData(Qt::UserRole, static_cast<int>(i));
    }
    showState();
}

void ReportWindow::moveSection(int by) {
    const int row = sections_->currentRow(), to = row + by;
    if (row < 0 || to < 0 || to >= sections_->count()) return;
    sections_->insertItem(to, sections_->takeItem(row));
    sections_->setCurrentRow(to);
}

void ReportWindow::followFormat() {
    const QString ending = format_->currentData().toString();
    const QFileInfo file(out_->text());
    if (!file.fileName().isEmpty()) out_->setText(file.path() + '/' + file.completeBaseName() + '.' + ending);
    showState();
}

/// The template with the chosen sections and logo.
ReportTemplate ReportWindow::layout() const {
    ReportTemplate layout = given_;
    layout.sections.clear();
    for (int i = 0; i < sections_->count(); ++i)
        if (const QListWidgetItem* item = sections_->item(i); item->checkState() == Qt::Checked)
            layout.sections.push_back(rows_[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())]);
    const QString logo = logo_->text().trimmed();
    const QDir folder = QFileInfo(out_->text()).absoluteDir();
    const QString own = qt(given_.logo);
    const bool isOwn = !own.isEmpty() && QDir::cleanPath(QFileInfo(template_->text()).dir().absoluteFilePath(own)) ==
                                             QDir::cleanPath(logo);
    if (isOwn) return layout;
    const bool isNear = QFileInfo(logo).absoluteDir() == folder;
    layout.logo = logo.isEmpty()
                      ? std::string()
                      : (isNear ? QFileInfo(logo).fileName() : QFileInfo(logo).absoluteFilePath()).toStdString();
    return layout;
}

/// Where a template that was changed here is saved: next to the report, so that the report can be made again.
QString ReportWindow::templatePath() const {
    const QFileInfo file(out_->text());
    return file.absolutePath() + '/' + file.completeBaseName() + "-template.txt";
}

void ReportWindow::showState() {
    const bool busy = job_->isBusy();
    progress_->setVisible(busy);
    stop_->setVisible(busy);
    create_->setEnabled(!busy && !subject_.source.empty() && !out_->text().trimmed().isEmpty() &&
                        !layout().sections.empty());
    up_->setEnabled(sections_->currentRow() > 0);
    down_->setEnabled(sections_->currentRow() >= 0 && sections_->currentRow() + 1 < sections_->count());
}

bool ReportWindow::mayReplace(const QStringList& files) {
    QStringList there;
    for (const QString& file : files)
        if (QFileInfo::exists(file)) there << QFileInfo(file).fileName();
    if (there.isEmpty()) return true;
    const QString text = there.size() == 1 ? tr("%1 already exists.").arg(there.front())
                                           : tr("%1 already exist.").arg(there.join(tr(" and ")));
    return ask(*this, tr("Report"), text, {}, {{QMessageBox::Cancel, {}}, {QMessageBox::Yes, tr("Replace")}}) ==
           QMessageBox::Yes;
}

void ReportWindow::create() {
    const QString ending = '.' + format_->currentData().toString();
    if (!out_->text().endsWith(ending)) out_->setText(out_->text().trimmed() + ending);
    ReportTask task;
    ReportOrder& order = task.order;
    order.source = subject_.source;
    order.out = QFileInfo(out_->text()).absoluteFilePath().toStdString();
    order.project = project_->text().trimmed().toStdString();
    order.author = author_->text().trimmed().toStdString();
    order.date = date_->text().trimmed().toStdString();
    const ReportTemplate chosen = layout();
    QStringList files{out_->text()};
    if (chosen == given_ && templateProblem_->text().isEmpty()) {
        if (!template_->text().trimmed().isEmpty())
            order.layout = QFileInfo(template_->text().trimmed()).absoluteFilePath().toStdString();
    } else {
        order.layout = templatePath().toStdString();
        task.templateText = templateText(chosen);
        files << templatePath();
    }
    if (!mayReplace(files)) return;
    QSettings settings;
    settings.setValue(projectKey, project_->text());
    settings.setValue(authorKey, author_->text());
    settings.setValue(formatKey, format_->currentData());
    show_->hide();
    message_->setText(tr("Creating…"));
    progress_->setValue(0);
    job_->start(std::move(task));
    showState();
}

void ReportWindow::end(const QString& message, bool isError, bool isWritten) {
    message_->setText(message);
    message_->setProperty("role", isError ? "problem" : "");
    message_->style()->unpolish(message_);
    message_->style()->polish(message_);
    show_->setVisible(isWritten);
    showState();
}

}  // namespace keyblock
