// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A message at the top of the canvas to which the user may respond. It stays until it
// is closed and does not block other work.
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

    /// \param over the widget whose upper edge the bar covers.
    NoticeBar(const Themes& themes, QWidget* over);

    /// Shows a message in place of the previous one, with a button for each answer and a Close button. A click on an
    /// answer closes the bar and calls `Answer::run`.
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
