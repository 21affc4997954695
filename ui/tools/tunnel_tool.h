// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places a tunnel, defined by a few dimensions, by its centre, or draws it corner by
// corner. Handles change it afterwards.
#pragma once

#include "ui/tools/tool.h"

namespace keyblock {

class TunnelTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "tunnel"; }
    QString title() const override { return tr("Tunnel"); }
    QString prompt() const override;
    QString detail() const override;
    std::vector<ToolField> fields() override;
    QString commitText() const override;

    void begin() override;
    void end() override { corners_.clear(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override { cursor_ = at.place; }
    void leave() override { cursor_.reset(); }
    void doubleClick(const Pointed& at) override;
    bool enter() override;
    bool back() override;
    bool undoPoint() override;
    bool close() override { return isDrawn() && enter(); }
    std::optional<Point> previous() const override;
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    bool isDrawn() const { return tunnel_.profile == ProfileKind::Polygon; }
    SceneTunnel placed(const Point& center) const;
    bool place(const SceneTunnel& tunnel);

    SceneTunnel tunnel_;
    std::vector<Point> corners_;  // corners of a polygonal profile drawn so far
    std::optional<Point> cursor_;
};

}  // namespace keyblock
