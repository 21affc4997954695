// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dock with the model summary: what a run would model and why, with the
// estimated time and memory.
#pragma once

#include "solver/run/model_summary.h"

#include <QWidget>

#include <atomic>
#include <memory>

class QGridLayout;
class QLabel;
class QPushButton;
class QTimer;

namespace keyblock {

class Background;
class Commands;
class Document;
class Themes;

class ModelSummaryPanel : public QWidget {
    Q_OBJECT

public:
    ModelSummaryPanel(Document& document, const Commands& commands, const Themes& themes, QWidget* parent = nullptr);
    ~ModelSummaryPanel() override;

    /// Nothing is counted during a run: the estimate would be wrong and would slow the run down.
    void setBusy(bool busy);

    /// The newest summary; null while it is being counted or if it cannot be made.
    const std::shared_ptr<const ModelSummary>& summary() const { return summary_; }

Q_SIGNALS:
    void taken();

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void askLater();
    void ask();
    void cancel();
    void present();
    void tell(const QString& why);
    QWidget* makeCosts();
    void placeCosts();
    void makeRunButton();
    void addWhy(int row, const QString& why);
    void addRow(int row, const QStringList& texts, const char* role, bool bold);

    Document& document_;
    const Commands& commands_;
    const Themes& themes_;
    Background* counting_;
    std::shared_ptr<std::atomic<bool>> stop_;  // of the newest request; null: none is open
    QTimer* calm_;
    std::shared_ptr<const ModelSummary> summary_;
    bool busy_ = false;
    bool narrow_ = false;  // no room for the reasons, which are in tooltips
    bool low_ = false;  // no room for the range of the estimate, which is in a tooltip
    QWidget* costs_ = nullptr;
    QWidget* table_ = nullptr;
    QWidget* page_;
    QGridLayout* grid_ = nullptr;
    QLabel *timeName_, *time_, *range_, *memoryName_, *memory_, *state_;
    QPushButton* run_;
};

}  // namespace keyblock
