// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures lengths and angles without changing the scene.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class MeasureTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "measure"; }
    QString title() const override { return tr("Measure"); }
    QString prompt() const override;
    QString detail() const override;
    bool changes() const override { return false; }
    void begin() override { points_.clear(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void leave() override { cursor_.reset(); }
    bool enter() override;
    bool back() override;
    bool undoPoint() override;
    std::optional<Point> previous() const override;
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    std::vector<Point> line() const;

    std::vector<Point> points_;  // points of the current line
    bool ended_ = false;
    std::optional<Point> cursor_;
};

}  // namespace keyblock
