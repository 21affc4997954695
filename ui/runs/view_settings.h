// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Display settings of results: quantities of blocks and bolts, force diagram, scale
// factor of displacements, and overlays.
#pragma once

#include "solver/results/frame_quantities.h"
#include "ui/picture/scale_choice.h"
#include "ui/picture/section/arrows.h"

#include <QObject>

#include <optional>

namespace keyblock {

enum class RibbonOf { Nothing, Selected, Largest };  // Selected: the bolt with the largest value if none is selected

struct ViewChoice {
    const FrameQuantity<BlockState>* blocks = nullptr;  // null: plain rock
    const FrameQuantity<BoltNodeFrame>* bolts = nullptr;  // null: plain bolts
    RibbonOf ribbon = RibbonOf::Selected;
    double factor = 1.0;  // scale factor of displacements
    std::optional<ArrowKind> arrows;
    bool contacts = false;  // contact forces drawn as lines
    bool activity = false;  // blocks coloured by what a step models
    bool callOuts = true;  // labels at events
    ScaleChoices scales{};

    bool operator==(const ViewChoice&) const = default;
};

class ViewSettings : public QObject {
    Q_OBJECT

public:
    /// Starts with the default settings: blocks show the principal stress σ₁, and bolts show the axial force N.
    explicit ViewSettings(QObject* parent = nullptr);

    const ViewChoice& choice() const { return choice_; }
    void choose(const ViewChoice& choice);

Q_SIGNALS:
    void changed();

private:
    ViewChoice choice_;
};

}  // namespace keyblock
