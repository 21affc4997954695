// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The model summary dock: what a run would model and why, with the estimated run time
// and memory.
#pragma once

#include "solver/run/model_summary.h"
#include "solver/trade/trade_point.h"

#include <QWidget>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;
class QTimer;

namespace keyblock {

class Background;
class Commands;
class Document;
class Themes;

/// A trade that was measured in the window, and its scene.
struct MeasuredTrade {
    std::shared_ptr<const Scene> scene;
    std::vector<std::string> quantities;
    std::vector<TradePoint> points;
};

class ModelSummaryPanel : public QWidget {
    Q_OBJECT

public:
    ModelSummaryPanel(Document& document, const Commands& commands, const Themes& themes, QWidget* parent = nullptr);
    ~ModelSummaryPanel() override;

    /// Pauses the computation of the summary during a run. The estimate would be inaccurate then, and computing it
    /// would slow the run down.
    void setBusy(bool busy);

    /// What could be left out next is then quoted from this trade, for as long as the document has the same scene. A
    /// trade that the command line left next to the scene's file is found without this.
    void setTrade(MeasuredTrade trade);
    /// The latest trade; null if there was none.
    const std::shared_ptr<const MeasuredTrade>& trade() const { return trade_; }

    /// The latest summary; null while it is being computed, or if it cannot be computed.
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
    void chooseCosts();
    void makeRunButton();
    void addWhy(int row, const QString& why);
    void addRow(int row, const QStringList& texts, const char* role, bool bold);

    Document& document_;
    const Commands& commands_;
    const Themes& themes_;
    Background* counting_;
    std::shared_ptr<std::atomic<bool>> stop_;  // stop flag of the latest request; null: no request is in progress
    QTimer* calm_;
    std::shared_ptr<const ModelSummary> summary_;
    std::shared_ptr<const MeasuredTrade> trade_;
    bool busy_ = false;
    bool narrow_ = false;  // too narrow for the reasons, which are then in tooltips
    int heightOfCosts_ = 0;  // [px] that the costs need one below the other
    bool low_ = false;  // too low for the range of the estimate, which is then in a tooltip
    QWidget* costs_ = nullptr;
    QWidget* table_ = nullptr;
    QWidget* page_;
    QGridLayout* grid_ = nullptr;
    QLabel *timeName_, *time_, *range_, *memoryName_, *memory_, *state_;
    QPushButton* run_;
};

}  // namespace keyblock
