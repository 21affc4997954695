// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How something fails that finds no equilibrium: which blocks go, whether they
// fall, slide or topple, and on which joints.
#pragma once

#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// How a block of a size goes (centroid to farthest corner) [m]: it topples where the centre of its rotation is nearer
/// than twice its size; else it falls where it moves within 10° of plumb, down; else it slides.
/// \param down direction in which bodies are pulled, any length; zero: nothing falls.
Movement movementOf(const Point& displacement, double rotation, double size, const Point& down);

struct MovingBlock {
    int block = -1;  // row of the frames
    Movement movement = Movement::Slides;
    Point displacement{0.0, 0.0};  // of the centroid [m]
    double rotation = 0.0;  // [rad]
};

/// Contacts of two blocks taken together.
struct MovingJoint {
    int blockA = -1, blockB = -1;  // rows of the frames
    int jointMaterial = -1;  // as in `ContactFrame`
    Point position{0.0, 0.0};  // where it moves most [m]
    double slip = 0.0;  // largest, without sign [m]
    double opening = 0.0;  // largest [m]
};

struct FailureMode {
    std::vector<MovingBlock> blocks;  // that move by a tenth of the largest movement or more, largest first
    std::vector<MovingJoint> joints;  // the same
};

/// Joints along which blocks of `rows` touched others in the first frame, with their relative movement until the later
/// one of the same stage; block a is the one of `rows`. Corners that touch alone are not a joint.
std::vector<MovingJoint> jointsAround(const Frame& before, const Frame& after, const std::vector<int>& rows);

/// What moved from one frame to a later one of the same stage. \param down as of `movementOf`.
FailureMode failureMode(const Frame& before, const Frame& after, const Point& down);

}  // namespace keyblock
