// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A choice that the wheel does not change while a person scrolls past it: a wheel
// gives Qt's own the focus first, and turns it then.
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
