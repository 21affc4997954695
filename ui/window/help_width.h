// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Help shares a tab group with Properties, but its tables need more width. The group is
// widened while help is in front and narrowed again afterwards.
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace keyblock {

class HelpWidth : public QObject {
    Q_OBJECT

public:
    HelpWidth(QMainWindow& window, QDockWidget& help, QDockWidget& properties);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(bool inFront);
    bool sharesPlace() const;
    int wideWidth() const;

    QMainWindow& window_;
    QDockWidget &help_, &properties_;
    int base_;  // width of Properties without help [px]
    bool wide_ = false;
};

}  // namespace keyblock
