// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Failure mode of a scene that finds no equilibrium: which blocks move, whether they
// fall, slide or topple, and along which joints.
#pragma once

#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// Classifies the movement of a block. The block topples if its centre of rotation is nearer to its centroid than twice
/// its size. Otherwise, it falls if it moves within 10° of the direction `down`, and slides if it does not.
/// \param size the distance from the centroid to the farthest corner [m].
/// \param down the direction of gravity, of any length; if zero, no block falls.
Movement movementOf(const Point& displacement, double rotation, double size, const Point& down);

struct MovingBlock {
    int block = -1;  // index in the frames
    Movement movement = Movement::Slides;
    Point displacement{0.0, 0.0};  // displacement of the centroid [m]
    double rotation = 0.0;  // [rad]
};

/// Relative movement along the joint between two blocks, from all contacts between them.
struct MovingJoint {
    int blockA = -1, blockB = -1;  // indices in the frames
    int jointMaterial = -1;  // as in `ContactFrame`
    Point position{0.0, 0.0};  // point of largest relative movement [m]
    double slip = 0.0;  // largest slip, without sign [m]
    double opening = 0.0;  // largest opening [m]
};

/// The blocks and joints that moved. Each list is sorted by movement, largest first, and omits items that moved less
/// than a tenth of the largest movement in the list.
struct FailureMode {
    std::vector<MovingBlock> blocks;
    std::vector<MovingJoint> joints;
};

/// Joints along which, in frame `before`, the blocks with the indices `rows` touched blocks that are not in `rows`. The
/// relative movement is that from `before` to `after`, a later frame of the same stage. `blockA` is always in `rows`.
/// Blocks that touch only at a corner form no joint.
std::vector<MovingJoint> jointsAround(const Frame& before, const Frame& after, const std::vector<int>& rows);

/// Blocks and joints that moved between a frame and a later frame of the same stage. \param down as in `movementOf`.
FailureMode failureMode(const Frame& before, const Frame& after, const Point& down);

}  // namespace keyblock
