// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures, tables and animations of the run shown, with a print preview. A window of
// its own that may stay open while working.
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

    /// Reads the current view, and shows the window with a kind chosen.
    void open(ExportWhat what);
    /// The run has more frames than before: an open window updates its preview.
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
    std::size_t frames_ = 0;  // frames of the previewed run
    ExportJob* job_;
    Background *painting_, *copying_;
    ExportForm* form_;
    QLabel *picture_, *message_;
    QProgressBar* progress_;
    QPushButton *copy_, *export_, *stop_;
    QImage image_;
};

}  // namespace keyblock
