// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures, tables and animations of the run that is shown, with a preview as they
// will be printed. A window of its own that may stay open while working.
#pragma once

#include "ui/export/export_job.h"
#include "ui/export/exportable.h"

#include <QImage>
#include <QWidget>

#include <functional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace keyblock {

class Background;
class ExportForm;
class Themes;

class ExportWindow : public QWidget {
    Q_OBJECT

public:
    ExportWindow(std::function<Exportable()> shown, const Themes& themes, QWidget* parent);
    ~ExportWindow() override;

    /// Takes what is on the screen now, and shows the window with a kind chosen.
    void open(ExportWhat what);
    /// The run has more frames than before: an open window previews it again.
    void refresh();

private:
    QWidget* makeResult();
    void showState();
    void preview();
    void showPreview(const QImage& image, const QString& message);
    void copy();
    void choosePlace();
    QString askPlace();

    std::function<Exportable()> shown_;
    const Themes& themes_;
    Exportable now_;
    std::size_t frames_ = 0;  // of the run that is previewed
    ExportJob* job_;
    Background *painting_, *copying_;
    ExportForm* form_;
    QLabel *picture_, *message_;
    QProgressBar* progress_;
    QPushButton *copy_, *export_, *stop_;
    QImage image_;
};

}  // namespace keyblock
