// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data that do not change during a run, except for joint strengths set by a stage:
// masses, stiffnesses, borehole slots and bolt meshes. They are created once from the
// document (setup/make_model). Coordinates are relative to `origin`, so that a scene far
// from (0, 0) does not lose precision.
#pragma once

#include "solver/engine/laws/backbone.h"
#include "solver/engine/laws/beam.h"
#include "solver/engine/vector6.h"
#include "solver/scene/preset.h"
#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

/// A block or a cell of a block in its initial state. Strains refer to the block's own rotating frame.
struct BlockModel {
    std::string name;
    std::vector<Point> shape;  // corners relative to the centroid, counter-clockwise [m]
    Point centroid{0.0, 0.0};  // [m]
    double area = 0.0;  // [m²]
    double size = 0.0;  // √area [m]
    double mass = 0.0;  // over the full thickness [kg]
    Matrix6 massMatrix = Matrix6::Zero();  // consistent mass matrix, order u, v, r, εx, εy, γ
    Eigen::Matrix3d elasticity = Eigen::Matrix3d::Zero();  // stress per strain [Pa]
    Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero();  // its inverse [1/Pa]
    double youngsModulus = 0.0;  // [Pa]
    Stress initialStress{};  // [Pa]
    int jointMaterial = -1;  // index into Model::joints
    std::vector<int> faceJoints;  // index into Model::joints per edge; empty: `jointMaterial` for all edges
    std::vector<int> faceOpenings;  // per edge: index into `State::openings` of its joint or joint set, −1: none;
                                    // empty: no named joint dilates
    std::vector<std::optional<BoundarySide>> faceSides;  // domain side per edge; empty: no domain or viscous side
    int rock = -1;  // block of the scene to which it belongs; for a face plate, the block against which it lies
    bool cell = false;  // a cell of a block that is divided into sub-blocks
    int plateOf = -1;  // bolt whose face plate it is; −1: not a plate
    std::vector<char> inner;  // per edge: true if glued to other cells over its full length; empty: none
    std::vector<int> turns;  // corners at which the outline changes direction or joint material; only these count as
                             // corners in contacts
    bool fixed = false;
    bool asleep = false;  // at rest and held in its place, in the model of a part of a scene (sleep/scene_part) only
};

struct JointModel {
    double tanPhi = 0.0;
    double cohesion = 0.0, tensileStrength = 0.0;  // [Pa]
    double tanResidual = 0.0;  // tangent of the friction angle after the first slip; tanPhi if nothing is lost
    std::optional<double> normalStiffness, shearStiffness;  // [Pa/m]
    std::optional<double> crushingStrength;  // of the rock or grout under a bolt [Pa]
};

/// Elastic bond along an edge shared by two cells (theory, "Sub-blocks").
struct GlueModel {
    int a = -1, b = -1;  // the two cells, as indices into Model::blocks
    Point placeA{0.0, 0.0}, placeB{0.0, 0.0};  // initial position of the edge's midpoint relative to each centroid [m]
    Point along{1.0, 0.0};  // initial unit direction of the edge, with cell `a` on its left
    double length = 0.0;  // [m]
    double normal = 0.0, shear = 0.0;  // stiffness of the springs at the midpoint [N/m]
    double turn = 0.0;  // stiffness of the rotational spring between the two sides [N m/rad]
};

/// A point fixed in x, y or both by a spring.
struct PointSupport {
    int block = -1;
    Point place{0.0, 0.0};  // position relative to the centroid, in the block's initial frame [m]
    bool x = false, y = false;  // fixed directions
    double stiffness = 0.0;  // [N/m]
    Point preload{0.0, 0.0};  // force on the block at zero displacement, from the in-situ stress [N]
};

/// Borehole segment in one block, given by two points fixed in the block (paper, §3.2.2).
struct Slot {
    int block = -1;
    Point p2{0.0, 0.0}, p3{0.0, 0.0};  // end points relative to the centroid, in the block's initial frame [m]
    double s2 = 0.0, s3 = 0.0;  // distances of the end points along the bolt [m]

    bool operator==(const Slot&) const = default;
};

using Interval = std::pair<double, double>;  // start and end along the unstrained bolt [m]

/// Connection of a bolt node to the rock in the direction of the bolt. Stiffness and strength are per node or per metre
/// of embedded length.
struct AnchorModel {
    bool real = false;  // the node is anchored
    bool canFail = false;  // if false, elastic with unlimited strength
    Per per = Per::Node;
    double stiffness = 0.0, residual = 0.0;  // [N/m, N], or the same per metre
    std::optional<double> strength;  // [N], or per metre; none: no bond strength
    double tanPhi = 0.0;  // friction: times the force of the normal spring, added to strength and residual
    bool restick = true;
    bool boltLost = false;  // the whole bolt is lost if this anchor fails
    bool curveEnds = false;  // no force beyond the last slip of the curve
    std::optional<Backbone> curve;  // of a force–slip curve or a softening bond
    std::optional<Backbone> dynamicCurve;  // curve in dynamic stages, if the dynamic factor is not 1
    int entry = -1;  // index into BoltModel::intervals
};

struct BoltElement {
    double length = 0.0;  // [m]
    bool shears = false;  // crosses or touches a joint and can deform in shear
};

/// Ratios of dynamic to static strength for the parts of a bolt.
struct StrengthFactors {
    double bond = 1.0, steel = 1.0, plate = 1.0;

    bool operator==(const StrengthFactors&) const = default;
};

struct PlateModel {
    bool present = false;
    int block = -1;
    Point place{0.0, 0.0};  // initial position of the bolt head relative to the block's centroid [m]
    Point along{1.0, 0.0};  // unit vector of the normal spring, in the block's initial frame
    double normalStiffness = 0.0, shearStiffness = 0.0;  // [N/m]
    std::optional<double> normalStrength, shearStrength;  // [N]
};

struct BoltModel {
    std::string name;
    std::vector<double> s;  // distances of the nodes from the far end [m]
    std::vector<BoltElement> elements;
    std::vector<AnchorModel> anchors;  // per node
    std::vector<std::vector<Interval>> intervals;  // intervals of each anchor entry not overridden by a later entry
    std::vector<Slot> slots;  // sorted along the bolt
    std::vector<double> joints;  // positions at which slots end within the bolt [m]
    double dowelLength = 0.0;  // bending length of a dowel, 1/β [m]
    bool shears = true;  // something in the scene may shear the bolt at a joint
    std::vector<int> startBlock;  // per node; −1: in a gap, on a joint or outside the rock
    Point farEnd{0.0, 0.0}, axis{1.0, 0.0};
    double angle = 0.0;  // direction of the axis [rad]
    double share = 1.0;  // model thickness over out-of-plane spacing: number of bolts in the model's thickness
    BeamSection section;
    std::optional<Backbone> steel;  // none: linear with unlimited strength
    std::optional<Backbone> dynamicSteel;  // curve in dynamic stages, if the dynamic factor is not 1
    double tensileStrength = 0.0;  // N_p [N]; 0: unlimited
    double shearStrength = 0.0;  // Q_p [N]; 0: unlimited
    bool interacts = false;  // rupture by combined tension and shear
    bool hinges = false;  // forms plastic hinges
    double plasticModulus = 0.0;  // Z [m³]
    StrengthFactors dynamicFactors;  // strength factors in dynamic stages
    double pretension = 0.0;  // [N]
    double diameter = 0.0;  // [m]
    bool bends = true;  // has bending stiffness
    double normalStiffness = 0.0;  // [N/m], or [N/m per m]
    Per normalPer = Per::Node;
    PlateModel plate;
    int firstNode = 0;  // index of its node 0 among all bolt nodes
};

struct Model {
    Point origin{0.0, 0.0};  // subtracted from all coordinates of the scene
    double size = 1.0;  // diagonal of the scene [m]
    double tolerance = 1e-9;  // geometric tolerance [m]
    double thickness = 1.0;
    Point gravity{0.0, 0.0};
    double stiffest = 1.0;  // largest spring stiffness in the scene [N/m]
    double smallest = 1.0;  // √area of the smallest block in the scene [m]
    std::vector<BlockModel> blocks;  // in the order of `solvedBlocks`
    std::vector<int> firstOf;  // per block of the scene, index of its first entry in `blocks`; then of the face plates
    std::vector<GlueModel> glue;
    std::vector<JointModel> joints;  // those of the scene, then the built-in one, then intact rock
    int openings = 0;  // number of entries of `State::openings`: of `joints`, then of the scene's joints and joint sets
    bool hasSides = false;  // the blocks have `faceSides`
    std::vector<PointSupport> supports;
    std::vector<BoltModel> bolts;
    int nodes = 0;  // number of nodes of all bolts
    Analysis analysis;
    Numerics numerics;
};

/// Initial positions of a block's corners [m].
std::vector<Point> startCorners(const BlockModel& block);

/// Indices into Model::joints. `builtInRow` is the built-in material, used for faces without a joint material in the
/// scene; `intactRow` is intact rock.
inline int builtInRow(const Model& model) { return static_cast<int>(model.joints.size()) - 2; }
inline int intactRow(const Model& model) { return static_cast<int>(model.joints.size()) - 1; }

/// Joint material of the face on an edge of a block, as an index into Model::joints.
inline int jointOfFace(const BlockModel& block, int edge) {
    return block.faceJoints.empty() ? block.jointMaterial : block.faceJoints[edge];
}

/// True if `a` and `b`, indices into Model::blocks, are the same block or two cells of one block.
bool sameRock(const Model& model, int a, int b);

/// Index into Model::blocks of the first cell of the block to which cell `row` belongs; `row` itself if that block is
/// not divided into cells.
/// \param row an index into Model::blocks.
int wholeOf(const Model& model, int row);

/// Index into Model::blocks of the last cell of a block, plus 1.
/// \param first the index of the block's first cell, as returned by `wholeOf`.
int endOfWhole(const Model& model, int first);

/// Area of a block with all its cells [m²], and the square root of that area [m].
/// \param first the index of the block's first cell, as returned by `wholeOf`.
double wholeArea(const Model& model, int first);
double wholeSize(const Model& model, int first);

/// Index into Model::blocks of block `block` of the scene or, if it is divided into cells, of a cell that contains
/// `place` at the start.
/// \pre `place` lies in the block.
int rowHolding(const Model& model, int block, const Point& place);

JointModel jointModel(const JointMaterial& material);

/// Entries of Model::joints: one for each of these materials, in order, then the built-in material, then intact rock.
std::vector<JointModel> jointRows(const std::vector<std::pair<std::string, JointMaterial>>& materials);

}  // namespace keyblock
