// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures, tables and films of the run that is shown, with a preview as they will be
// printed. A window of its own that may stay open while working.
#pragma once

#include "ui/export/export_job.h"

#include <QImage>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

class QComboBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace keyblock {

class Background;
class Themes;

/// What is on the screen and can be taken along.
struct Exportable {
    std::shared_ptr<const RunSource> run;  // null: there is none
    std::filesystem::path store;
    std::optional<std::size_t> frame;  // null: the last
    std::string quantity;  // of blocks or over them, as figures name it; empty: their own choice
    int bolt = -1;  // row of the scene's bolts; −1: none in particular
    double factor = 1.0;  // on displacements
    ScaleChoices scales{};  // of the colours
};

class ExportWindow : public QWidget {
    Q_OBJECT

public:
    ExportWindow(std::function<Exportable()> shown, const Themes& themes, QWidget* parent);
    ~ExportWindow() override;

    /// Takes what is on the screen now, and shows the window with a kind chosen.
    void open(ExportWhat what);

private:
    enum class Kind { Section, Bolt, Curves, Events, Numbers, Film, Everything };

    QWidget* makeForm();
    QWidget* makeResult();
    QComboBox* makeCombo(const QString& name, const char* id);
    void fillQuantities();
    void showFields();
    void preview();
    void showPreview(const QImage& image, const QString& message);
    void copy();
    void choosePlace();
    Kind kind() const;
    FigureRequest request() const;
    ExportOrder order() const;
    QString suggested() const;

    std::function<Exportable()> shown_;
    const Themes& themes_;
    Exportable now_;
    ExportJob* job_;
    Background *painting_, *copying_;
    QFormLayout* form_ = nullptr;
    QComboBox *kind_, *quantity_, *bolt_, *table_, *format_, *width_, *dpi_;
    QSpinBox* perSecond_;
    QLabel *picture_, *message_;
    QProgressBar* progress_;
    QPushButton *copy_, *export_, *stop_;
    QImage image_;
};

}  // namespace keyblock
