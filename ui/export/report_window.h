// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window for reports of a run or a study: title block, format, template, sections and
// their order, logo and file. It is a separate window that can stay open while the user
// works.
#pragma once

#include "ui/export/report_job.h"
#include "ui/report/report_template.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace keyblock {

/// Results of which a report can be made.
struct Reportable {
    std::filesystem::path source;  // run store, or folder of a sweep; empty: nothing
    ReportKind kind = ReportKind::Run;
    std::filesystem::path suggested;  // path of the report without extension
};

class ReportWindow : public QWidget {
    Q_OBJECT

public:
    explicit ReportWindow(QWidget* parent);
    ~ReportWindow() override;

    /// Shows the window for these results.
    void open(const Reportable& subject);

private:
    QWidget* makeForm();
    QWidget* makeSections();
    QWidget* makeFoot();
    QLineEdit* addLine(QFormLayout& form, const QString& label, const char* name, const QString& hint);
    QLineEdit* addFile(QFormLayout& form, const QString& label, const char* name, const QString& hint,
                       void (ReportWindow::*browse)(), QWidget* below = nullptr);
    void browseTemplate();
    void browseLogo();
    void browseOut();
    void takeTemplate();
    void showSections();
    void moveSection(int by);
    void followFormat();
    void showState();
    ReportTemplate layout() const;
    QString templatePath() const;
    bool mayReplace(const QStringList& files);
    void create();
    void end(const QString& message, bool isError, bool isWritten);

    Reportable subject_;
    ReportTemplate given_;  // of the template file, or of reports without one
    std::vector<TemplateSection> rows_;  // sections in the order of the list
    QComboBox* format_;
    QLineEdit *project_, *author_, *date_, *template_, *logo_, *out_;
    QLabel *message_, *templateProblem_;
    QListWidget* sections_;
    QProgressBar* progress_;
    QPushButton *up_, *down_, *create_, *stop_, *show_;
    ReportJob* job_;
};

}  // namespace keyblock
