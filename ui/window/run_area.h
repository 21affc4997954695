// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything in the window that concerns runs and results: the timeline and the docks
// below the canvas, the bar above it, the progress of the run next to the workflow, and
// the switch between drawing and results on the canvas.
#pragma once

#include "ui/canvas/legend_panel.h"
#include "ui/window/workflow.h"

#include <QObject>

class QBoxLayout;
class QDockWidget;
class QMainWindow;
class QVBoxLayout;

namespace keyblock {

class BlockChoice;
class BoltChoice;
class Canvas;
class Commands;
class CompareArea;
class Comparison;
class Display;
class Document;
class DrawingFeed;
class EventsList;
class HealthStrip;
class Pins;
class ResultCard;
class ResultSelection;
class ProbeBinding;
class RunLog;
class Runs;
class SafetySearch;
class StressRuns;
class TradeRuns;
class SectionFeed;
class Selection;
class Themes;
class TimeCursor;
class RunWarning;
class ViewBar;
class ViewSettings;
class WorkflowBar;

/// The parts of the window that the run area uses.
struct RunAreaParts {
    QMainWindow& window;
    Themes& themes;
    const Display& display;
    Commands& commands;
    Document& document;
    Selection& selection;
    Canvas& canvas;
    DrawingFeed& drawing;
    WorkflowBar& workflow;
};

class RunArea : public QObject {
    Q_OBJECT

public:
    /// Adds the commands for runs and results. The docks and bars are added later, by `place`.
    explicit RunArea(const RunAreaParts& parts);
    ~RunArea() override;

    /// Adds the docks to the bottom of the window, the bars to `aboveCanvas`, and during a comparison a second canvas
    /// to `besideCanvas`.
    void place(QVBoxLayout& aboveCanvas, QBoxLayout& besideCanvas);

    /// Sets the states of the workflow steps Run and Results.
    void addTo(WorkStates& states) const;

    Runs& runs() { return *runs_; }
    TimeCursor& cursor() { return *cursor_; }
    const BoltChoice& choice() const { return *choice_; }
    ViewSettings& settings() { return *settings_; }
    /// Accuracy against time of the scene's settings.
    const TradeRuns& accuracy() const { return *accuracy_; }
    ProbeBinding& probe() { return *probe_; }
    /// Whether the canvas shows results, and not the drawing.
    bool showsResults() const;
    /// Results of the selected bolt or block, for the Properties panel.
    ResultCard& results() { return *results_; }

Q_SIGNALS:
    void statesChanged();
    void modeChanged(bool results);
    void panelAsked(QDockWidget* panel);  // to be shown in front

private:
    void placeDocks(QBoxLayout& besideCanvas);
    void showMode();
    void showPicture();
    void showSelection();
    void openScale(LegendPart part, const QPoint& at);
    void followTabs(WorkStep step);
    void askBlock(int block, const QString& why);
    void nameTabs();
    void tell(const QString& message, bool isError);

    RunAreaParts parts_;
    TimeCursor* cursor_;
    BoltChoice* choice_;
    BlockChoice* blocks_;
    Runs* runs_;
    ViewSettings* settings_;
    SectionFeed* feed_;
    Pins* pins_;
    ResultSelection* picking_;
    ResultCard* results_;
    ProbeBinding* probe_;
    Comparison* comparison_;
    SafetySearch* safety_;
    TradeRuns* accuracy_;
    StressRuns* stress_;
    CompareArea* compare_;
    int asked_ = -1;  // block outlined on request of a dock; −1: none
    ViewBar* bar_ = nullptr;
    RunWarning* warning_ = nullptr;
    HealthStrip* health_ = nullptr;
    EventsList* events_ = nullptr;
    RunLog* log_ = nullptr;
    QDockWidget* eventsDock_ = nullptr;
};

}  // namespace keyblock
