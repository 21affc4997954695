// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A combo box that ignores the mouse wheel unless it has the focus, so that scrolling
// past it does not change its value. Qt's own combo box takes the focus on a wheel
// event and then changes its value.
#pragma once

#include <QComboBox>
#include <QWheelEvent>

namespace keyblock {

class CalmBox : public QComboBox {
    Q_OBJECT

public:
    explicit CalmBox(QWidget* parent) : QComboBox(parent) { setFocusPolicy(Qt::StrongFocus); }

protected:
    void wheelEvent(QWheelEvent* event) override { hasFocus() ? QComboBox::wheelEvent(event) : event->ignore(); }
};

}  // namespace keyblock
