// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window for exporting figures, tables and animations of the run shown, with a
// preview. It is a separate window that can stay open while the user works.
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

    /// Adopts the current view and shows the window with the option `what` selected.
    void open(ExportWhat what);
    /// Call this when frames have been added to the run. Updates the preview if the window is open.
    void refresh();

private:
    QWidget* makeResult();
    void showState();
    void preview();
    void showPreview(const QImage& image, const QString& message);
    void copy();
    void choosePlace();
    QString askPlace();
    bool mayReplace(const ExportOrder& order);

    std::function<Exportable()> shown_;
    const Themes& themes_;
    Exportable now_;
    std::size_t frames_ = 0;  // number of frames of the run at the last preview
    ExportJob* job_;
    Background *painting_, *copying_;
    ExportForm* form_;
    QLabel *picture_, *message_;
    QProgressBar* progress_;
    QPushButton *copy_, *export_, *stop_;
    QImage image_;
};

}  // namespace keyblock
