// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A label on one line that gives way to its neighbours: what has no room ends in
// dots and stands in the tooltip.
#pragma once

#include <QLabel>

namespace keyblock {

class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent);

    /// As wide as its text, up to so many pixels, instead of what neighbours leave.
    void setMost(int pixels);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    bool fits() const;

    int most_ = -1;  // [px]; none: what there is
};

}  // namespace keyblock
