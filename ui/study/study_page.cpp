// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_page.h"

#include "ui/look/action_button.h"
#include "ui/look/commands.h"
#include "ui/look/elided_label.h"
#include "ui/look/theme.h"
#include "ui/study/study_draft.h"
#include "ui/study/study_form.h"
#include "ui/study/study_results.h"
#include "ui/study/sweep_session.h"

#include <QButtonGroup>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVariant>
#include <QVBoxLayout>

#include <cmath>

namespace keyblock {

namespace {

constexpr int widestEmptyText = 520;  // [px]
enum Side { EmptySide, SetupSide, ResultsSide };

/// "1 min 20 s left".
QString leftText(double seconds) {
    const long whole = std::lround(std::max(1.0, seconds));
    if (whole < 60) return StudyPage::tr("%1 s left").arg(whole);
    if (whole < 3600) return StudyPage::tr("%1 min %2 s left").arg(whole / 60).arg(whole % 60);
    return StudyPage::tr("%1 h %2 min left").arg(whole / 3600).arg(whole % 3600 / 60);
}

}  // namespace

StudyPage::StudyPage(StudyDraft& draft, SweepSession& session, const Commands& commands, const Themes& themes,
                     QWidget* parent)
    : QWidget(parent), draft_(draft), session_(session), save_(*commands.action("study.save")),
      title_(new ElidedLabel(this)), progressText_(new QLabel(this)), notice_(new QLabel(this)),
      setup_(new QPushButton(tr("Setup"), this)), show_(new QPushButton(tr("Results"), this)),
      progress_(new QProgressBar(this)), progressRow_(new QWidget(this)), stack_(new QStackedWidget(this)),
      form_(new StudyForm(draft, themes, this)), results_(new StudyResults(session, themes, this)) {
    setObjectName("studyPage");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Studies"));
    setFocusPolicy(Qt::ClickFocus);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    progress_->setAccessibleName(tr("Progress of the study"));
    progressText_->setProperty("role", "detail");
    progressText_->setObjectName("study.progress");
    notice_->setObjectName("study.notice");
    notice_->setWordWrap(true);
    notice_->setTextFormat(Qt::PlainText);
    notice_->setProperty("role", "problem");
    notice_->setContentsMargins(16, 4, 16, 4);
    notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* line = new QHBoxLayout(progressRow_);
    line->setContentsMargins(16, 4, 16, 4);
    line->addWidget(progress_, 1);
    line->addWidget(progressText_);
    stack_->addWidget(makeEmpty(commands));
    stack_->addWidget(form_);
    stack_->addWidget(results_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeRecovery());
    column->addWidget(makeHeader(commands));
    column->addWidget(progressRow_);
    column->addWidget(notice_);
    column->addWidget(stack_, 1);
    connect(setup_, &QPushButton::clicked, this, &StudyPage::showSetup);
    connect(show_, &QPushButton::clicked, this, &StudyPage::showResults);
    connect(&draft, &StudyDraft::changed, this, &StudyPage::fill);
    connect(&draft, &StudyDraft::replaced, this, &StudyPage::showSetup);
    connect(&session, &SweepSession::changed, this, &StudyPage::fill);
    fill();
}

QPushButton* StudyPage::button(const Commands& commands, const char* id, const QString& text) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(QString("button.") + id);
    made->setAccessibleName(QString(text).remove(QStringLiteral("…")));
    follow(*made, *commands.action(id));
    return made;
}

QWidget* StudyPage::makeHeader(const Commands& commands) {
    header_ = new QWidget(this);
    header_->setObjectName("panelHeader");
    header_->setAttribute(Qt::WA_StyledBackground);
    title_->setObjectName("study.title");
    title_->setProperty("role", "title");
    auto* sides = new QButtonGroup(this);
    for (QPushButton* side : {setup_, show_}) {
        side->setCheckable(true);
        side->setProperty("pill", true);
        side->setAccessibleName(side->text());
        sides->addButton(side);
    }
    setup_->setObjectName("study.setup");
    show_->setObjectName("study.show");
    run_ = button(commands, "study.run", tr("Run"));
    run_->setProperty("primary", true);
    stop_ = button(commands, "study.stop", tr("Stop"));
    auto* row = new QHBoxLayout(header_);
    row->setContentsMargins(16, 6, 12, 6);
    row->setSpacing(6);
    row->addWidget(title_, 1);
    row->addWidget(setup_);
    row->addWidget(show_);
    row->addSpacing(10);
    row->addWidget(button(commands, "study.open", tr("Open…")));
    row->addWidget(button(commands, "study.save", tr("Save")));
    row->addWidget(button(commands, "study.report", tr("Report…")));
    row->addWidget(run_);
    row->addWidget(stop_);
    return header_;
}

QWidget* StudyPage::makeEmpty(const Commands& commands) {
    auto* empty = new QWidget(this);
    auto* title = new QLabel(tr("No study is open"), empty);
    title->setObjectName("sectionTitle");
    auto* text = new QLabel(
        tr("A study runs the scene many times with different values: friction angles from a "
           "distribution, other seeds of joint sets, bolts that are missing. It gives the spread of "
           "each result and the probability of failure.\n\nRight-click a field in Properties and "
           "choose “Vary in a study…”, or open a study file."),
        empty);
    text->setObjectName("hint");
    text->setWordWrap(true);
    text->setFixedWidth(widestEmptyText);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(button(commands, "study.new", tr("New study")));
    buttons->addWidget(button(commands, "study.open", tr("Open study…")));
    buttons->addStretch(1);
    auto* column = new QVBoxLayout;
    column->setSpacing(12);
    column->addStretch(2);
    column->addWidget(title);
    column->addWidget(text);
    column->addLayout(buttons);
    column->addStretch(3);
    auto* row = new QHBoxLayout(empty);
    row->addStretch(1);
    row->addLayout(column);
    row->addStretch(1);
    return empty;
}

QWidget* StudyPage::makeRecovery() {
    auto* box = new QFrame(this);
    box->setObjectName("recoveryBox");
    recovery_ = box;
    recoveryText_ = new QLabel(box);
    recoveryText_->setWordWrap(true);
    recoveryText_->setTextFormat(Qt::PlainText);
    auto* row = new QHBoxLayout(box);
    row->addWidget(recoveryText_, 1);
    for (const bool recovers : {true, false}) {
        auto* answer = new QPushButton(recovers ? tr("Recover") : tr("Discard"), box);
        answer->setObjectName(recovers ? "study.recover" : "study.discard");
        answer->setAccessibleName(answer->text());
        row->addWidget(answer);
        connect(answer, &QPushButton::clicked, this, [this, recovers] { Q_EMIT recoveryAnswered(recovers); });
    }
    box->hide();
    return box;
}

void StudyPage::offerRecovery(const QString& what) {
    recoveryText_->setText(tr("%1 was not saved before the program ended.").arg(what));
    recovery_->setVisible(!what.isEmpty());
}

/// While this page has the focus, the key that saves the scene saves the study.
bool StudyPage::event(QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || !draft_.isOpen() ||
        !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Save))
        return QWidget::event(event);
    event->accept();
    return true;
}

void StudyPage::keyPressEvent(QKeyEvent* event) {
    if (draft_.isOpen() && event->matches(QKeySequence::Save)) return save_.trigger();
    QWidget::keyPressEvent(event);
}

void StudyPage::setNotice(const QString& text) {
    noticeText_ = text;
    fill();
}

void StudyPage::showSetup() {
    stack_->setCurrentIndex(draft_.isOpen() ? SetupSide : EmptySide);
    fill();
}

void StudyPage::showResults() {
    if (draft_.isOpen()) stack_->setCurrentIndex(ResultsSide);
    fill();
}

void StudyPage::fill() {
    const bool isOpen = draft_.isOpen();
    if (!isOpen) stack_->setCurrentIndex(EmptySide);
    else if (stack_->currentIndex() == EmptySide) stack_->setCurrentIndex(SetupSide);
    header_->setVisible(isOpen);
    setup_->setChecked(stack_->currentIndex() == SetupSide);
    show_->setChecked(stack_->currentIndex() == ResultsSide);
    title_->setText(draft_.title() + (draft_.isModified() ? QStringLiteral(" *") : QString()));
    title_->setToolTip(draft_.path());
    run_->setVisible(!session_.isRunning());
    stop_->setVisible(session_.isRunning());
    const QString notice = session_.problem().isEmpty() ? noticeText_ : session_.problem();
    notice_->setText(notice);
    notice_->setVisible(isOpen && !notice.isEmpty());
    showProgress();
}

void StudyPage::showProgress() {
    const bool isShown = draft_.isOpen() && (session_.isRunning() || session_.isReading() || session_.opened());
    progressRow_->setVisible(isShown);
    if (!isShown) return;
    const long all = std::max(1L, session_.cases()), done = session_.finished();
    progress_->setRange(0, session_.isReading() ? 0 : 1000);
    progress_->setValue(static_cast<int>(1000.0 * static_cast<double>(done) / static_cast<double>(all)));
    QString text = tr("%1 of %2 cases").arg(done).arg(session_.cases());
    if (session_.isReading()) text = tr("Preparing…");
    else if (session_.isStopping()) text += tr(" · stopping");
    else if (const auto left = session_.secondsLeft()) text += " · " + leftText(*left);
    else if (!session_.isRunning() && done < session_.cases()) text += tr(" · stopped");
    progressText_->setText(text);
}

}  // namespace keyblock
