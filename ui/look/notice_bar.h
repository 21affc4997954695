// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A message over the top of the canvas that the user may answer: it stays as long as
// necessary and does not block the work.
#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace keyblock {

class Themes;

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    struct Answer {
        QString text;
        std::function<void()> run;
    };

    /// `over` is the widget whose top it covers.
    NoticeBar(const Themes& themes, QWidget* over);

    /// Shows a new message; each answer closes the bar.
    void say(const QString& text, const std::vector<Answer>& answers);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
    void addLink(const Answer& answer);

    const Themes& themes_;
    QLabel *icon_, *text_;
    QHBoxLayout* row_;
    std::vector<QWidget*> links_;
};

}  // namespace keyblock
