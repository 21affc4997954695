// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places bolts along part of a tunnel wall: the user picks both ends of that part, and
// sees a preview of the bolts at their spacing until they are placed.
#pragma once

#include "ui/edit/wall_at.h"
#include "ui/tools/pattern_fit.h"
#include "ui/tools/tool.h"

namespace keyblock {

class PatternTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "pattern"; }
    QString title() const override { return tr("Bolt pattern"); }
    QString prompt() const override;
    QString detail() const override;
    std::vector<ToolField> fields() override;
    QString commitText() const override;

    void begin() override;
    void end() override { from_.reset(), to_.reset(), hover_.reset(); }
    void refresh() override;
    void press(const Pointed& at) override;
    void move(const Pointed& at) override;
    void leave() override { hover_.reset(), layOut(); }
    bool enter() override;
    bool back() override;
    bool undoPoint() override { return back(); }
    std::optional<Point> previous() const override;
    bool accepts(const Snap& snap) const override;
    void paint(QPainter& painter, const CanvasMap& map) const override;

private:
    const SceneTunnel& tunnel() const;  // \pre from_
    std::optional<WallPlace> runEnd() const { return to_ ? to_ : hover_; }
    void layOut();
    void changedOptions();

    PatternFit fit() const { return static_cast<PatternFit>(fit_); }

    ScenePattern pattern_;
    PatternPlaces given_;  // values set by the user, not yet fitted to the wall
    int fit_ = static_cast<int>(PatternFit::Centred);
    double count_ = 6.0;  // number of bolts from end to end
    bool wayChosen_ = false;  // the user chose the direction; otherwise the shorter way is used
    std::optional<WallPlace> from_, to_, hover_;
    std::vector<ObjectLine> bolts_;
    double run_ = 0.0;  // [m]
};

}  // namespace keyblock
