// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A widget filled with the drawing of a section.
#pragma once

#include "ui/picture/section/section.h"

#include <QWidget>

#include <optional>

namespace keyblock {

class Themes;

class PicturePane : public QWidget {
    Q_OBJECT

public:
    explicit PicturePane(const Themes& themes, QWidget* parent = nullptr);

    /// Shows the drawing `picture` or, if there is none, the message `otherwise`.
    void show(std::optional<SectionPicture> picture, const QString& otherwise);

    QSize sizeHint() const override { return {520, 320}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Themes& themes_;
    std::optional<SectionPicture> picture_;
    QString otherwise_;
};

}  // namespace keyblock
