// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Import of a drawing: roles of layers, units, arc tolerance, a list of how each entity
// is imported, and a preview of the scene. It is a separate window that can stay open.
#pragma once

#include "solver/files/drawing/section_import.h"

#include <QImage>
#include <QWidget>

#include <memory>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace keyblock {

class Background;
class PicturePane;
class Themes;
struct ImportAttempt;

class ImportWindow : public QWidget {
    Q_OBJECT

public:
    ImportWindow(const QString& path, const Themes& themes, QWidget* parent);

Q_SIGNALS:
    void imported(const keyblock::Scene& scene, const QString& name);

private:
    QWidget* makeSettings();
    QWidget* makeResult();
    void ask();
    void showAttempt(std::shared_ptr<const ImportAttempt> attempt);
    void showLayers();
    void showAccount();
    void showWords();
    void setRole(const QString& layer, LayerRole role);
    void readSagitta();

    QString path_;
    const Themes& themes_;
    Background* reading_;
    ImportSettings settings_;
    std::shared_ptr<const ImportAttempt> attempt_;
    QComboBox* unit_;
    QLineEdit* sagitta_;
    QTreeWidget *layers_, *account_;
    PicturePane* picture_;
    QLabel* words_;
    QPushButton* import_;
};

}  // namespace keyblock
