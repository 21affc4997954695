// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A single-line label that shrinks in favour of its neighbours: text that does not
// fit is elided and shown in the tooltip.
#pragma once

#include <QLabel>

namespace keyblock {

class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent);

    /// As wide as its text, up to so many pixels, instead of the space left by neighbours.
    void setMost(int pixels);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    bool fits() const;

    int most_ = -1;  // [px]; none: the space available
};

}  // namespace keyblock
