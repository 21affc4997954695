// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A single-line label that leaves space for its neighbours: text that does not fit is
// shortened with an ellipsis and shown in full in the tooltip.
#pragma once

#include <QLabel>

namespace keyblock {

class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent);

    /// Makes the label as wide as its text, but at most `pixels`, instead of filling the space left by its neighbours.
    void setMost(int pixels);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    bool fits() const;

    int most_ = -1;  // maximum width [px]; −1: the space available
};

}  // namespace keyblock
