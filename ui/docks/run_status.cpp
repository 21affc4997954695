// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/run_status.h"

#include "solver/results/run_source.h"
#include "ui/look/action_button.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/runs/run_session.h"
#include "ui/runs/runs.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include <cmath>

namespace keyblock {

/// Shows two texts on the left, the fraction and the remaining time on the right, and a bar below them. When the run is
/// over, it shows the outcome.
class RunStatus::Progress : public QWidget {
public:
    Progress(const Themes& themes, const Runs& runs, QWidget* parent) : QWidget(parent), themes_(themes), runs_(runs) {
        setObjectName("runProgress");
        setAccessibleName(RunStatus::tr("Run progress"));
        setFixedHeight(34);
        setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    }

    QSize sizeHint() const override { return {330, 34}; }
    QSize minimumSizeHint() const override { return {60, 34}; }

protected:
    void paintEvent(QPaintEvent*) override {
        const RunSession* session = runs_.session();
        if (!session) return;
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        if (session->isOver()) return paintEnding(painter, *session);
        const Theme& theme = themes_.current();
        QString right = QStringLiteral("%1 %").arg(static_cast<int>(std::floor(100.0 * session->fraction())));
        QString left;
        // shown instead of stage and step, because it changes while the bar does not
        const QString search = session->searchText();
        if (session->state() == RunSession::State::Paused) left = RunStatus::tr("paused");
        else if (session->state() == RunSession::State::Stopping) left = RunStatus::tr("stopping…");
        else if (const auto seconds = session->secondsLeft(); seconds && search.isEmpty()) left = leftText(*seconds);
        double x = width();
        x = write(painter, left, false, theme.text2, x) - (left.isEmpty() ? 0.0 : 8.0);
        x = write(painter, right, true, theme.text, x) - 12.0;
        QFont font = painter.font();
        font.setPixelSize(12);
        font.setWeight(QFont::DemiBold);
        painter.setFont(font);
        painter.setPen(theme.text);
        const QString stage = painter.fontMetrics().elidedText(
            search.isEmpty() ? session->stageText() : search, Qt::ElideRight, int(x));
        painter.drawText(QRectF(0.0, 6.0, x, 16.0), Qt::AlignVCenter | Qt::AlignLeft, stage);
        const double at = painter.fontMetrics().horizontalAdvance(stage) + 8.0;
        font.setPixelSize(11);
        font.setWeight(QFont::Normal);
        painter.setFont(font);
        painter.setPen(theme.text2);
        const QString step = RunStatus::tr("step %1").arg(Display::number(static_cast<double>(session->steps()), 9));
        if (search.isEmpty() && at + painter.fontMetrics().horizontalAdvance(step) < x)
            painter.drawText(QRectF(at, 6.0, x - at, 16.0), Qt::AlignVCenter | Qt::AlignLeft, step);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.separator);
        painter.drawRoundedRect(QRectF(0.0, 26.0, width(), 3.0), 1.5, 1.5);
        painter.setBrush(theme.accent);
        painter.drawRoundedRect(QRectF(0.0, 26.0, width() * session->fraction(), 3.0), 1.5, 1.5);
    }

private:
    /// Paints text that ends at `end`. \return where it begins.
    double write(QPainter& painter, const QString& text, bool bold, const QColor& colour, double end) const {
        QFont font = painter.font();
        font.setPixelSize(bold ? 12 : 11);
        font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
        painter.setFont(font);
        painter.setPen(colour);
        const double wide = painter.fontMetrics().horizontalAdvance(text);
        painter.drawText(QRectF(end - wide - 1.0, 6.0, wide + 1.0, 16.0), Qt::AlignVCenter | Qt::AlignRight, text);
        return end - wide;
    }

    void paintEnding(QPainter& painter, const RunSession& session) const {
        const Theme& theme = themes_.current();
        const bool good = !session.failed() && session.outcome() && endedAsPlanned(*session.outcome()) &&
                          !session.isUnstable();
        const char* icon = session.failed() ? "error" : good ? "ok" : "warning";
        const QColor colour = session.failed() ? theme.error : good ? theme.ok : theme.warning;
        QFont font = painter.font();
        font.setPixelSize(12);
        painter.setFont(font);
        const QString text = painter.fontMetrics().elidedText(session.message(), Qt::ElideRight, width() - 24);
        const int wide = painter.fontMetrics().horizontalAdvance(text);
        themes_.icon(icon, colour).paint(&painter, QRect(width() - wide - 24, 9, 16, 16));
        painter.setPen(theme.text);
        painter.drawText(QRectF(width() - wide - 2, 0.0, wide + 2, height()), Qt::AlignVCenter | Qt::AlignRight, text);
    }

    const Themes& themes_;
    const Runs& runs_;
};

RunStatus::RunStatus(const Themes& themes, Commands& commands, Runs& runs, QWidget* parent)
    : QWidget(parent), themes_(themes), commands_(commands), runs_(runs), progress_(new Progress(themes, runs, this)),
      start_(framedButton("run.start", [this] { return withKeys(tr("Run"), "run.start"); })),
      pause_(framedButton("run.pause", [this] { return isPaused() ? tr("Continue") : tr("Pause"); })),
      step_(framedButton("run.step", {})),
      stop_(framedButton("run.stop", [this] { return withKeys(tr("Stop"), "run.stop"); })) {
    setObjectName("runStatus");
    setAccessibleName(tr("Run"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 12, 0);
    row->setSpacing(6);
    row->addWidget(progress_);
    row->addSpacing(6);
    step_->setToolButtonStyle(Qt::ToolButtonIconOnly);
    for (QToolButton* button : {start_, pause_, step_, stop_}) row->addWidget(button);
    connect(&runs, &Runs::sessionChanged, this, &RunStatus::refresh);
    connect(&runs, &Runs::advanced, progress_, QOverload<>::of(&QWidget::update));
    connect(&themes, &Themes::changed, this, &RunStatus::refresh);
    refresh();
}

QToolButton* RunStatus::framedButton(const char* command, std::function<QString()> text) {
    QToolButton* button = buttonOf(*commands_.action(command), this, std::move(text));
    button->setObjectName(QString::fromUtf8(command) + "Button");
    button->setFixedHeight(26);
    button->setProperty("framed", true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    return button;
}

QString RunStatus::withKeys(const QString& text, const char* command) const {
    const QString keys = keysOf(*commands_.action(command));
    return keys.isEmpty() ? text : text + QStringLiteral("  ") + keys;
}

bool RunStatus::isPaused() const { return runs_.isRunning() && runs_.session()->state() == RunSession::State::Paused; }

void RunStatus::refresh() {
    const bool running = runs_.isRunning();
    progress_->setVisible(runs_.session() != nullptr);
    progress_->setToolTip(runs_.session() && runs_.session()->isOver() ? asTip(runs_.session()->message()) : QString());
    start_->setVisible(!running);
    for (QToolButton* button : {pause_, step_, stop_}) button->setVisible(running);
    const Theme& theme = themes_.current();
    start_->setIcon(themes_.icon("play", theme.ok));
    pause_->setIcon(themes_.icon(isPaused() ? "play" : "pause", theme.text));
    step_->setIcon(themes_.icon("step"));
    stop_->setIcon(themes_.icon("stop", theme.error));
    progress_->update();
}

}  // namespace keyblock
