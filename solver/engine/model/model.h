// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What never changes while a scene is run but for the strengths of joints that a
// stage sets: masses, stiffnesses, borehole slots and meshes of bolts, made once
// from the document (setup/make_model). Coordinates are relative to `origin`, so
// that a scene far from (0, 0) loses no digits.
#pragma once

#include "solver/engine/laws/backbone.h"
#include "solver/engine/laws/beam.h"
#include "solver/engine/vector6.h"
#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

/// A block as it was at the start. Strains live in the block's own turning frame.
struct BlockModel {
    std::string name;
    std::vector<Point> shape;  // corners from the centroid, counter-clockwise [m]
    Point centroid{0.0, 0.0};  // [m]
    double area = 0.0;  // [m²]
    double size = 0.0;  // √area [m]
    double mass = 0.0;  // [kg] of the whole thickness
    Matrix6 massMatrix = Matrix6::Zero();  // consistent, order u, v, r, εx, εy, γ
    Eigen::Matrix3d elasticity = Eigen::Matrix3d::Zero();  // stress over strain [Pa]
    double youngsModulus = 0.0;  // [Pa]
    Stress initialStress{};  // [Pa]
    int jointMaterial = -1;  // row of Model::joints
    std::vector<int> faceJoints;  // the same for the face on each edge; empty: all have that one
    std::vector<int> faceOpenings;  // row of `State::openings` of the joint or set that the face is on, −1: none;
                                    // empty: nothing dilates by such a name
    std::vector<std::optional<BoundarySide>> faceSides;  // of the domain; empty: not cut, or no side lets waves out
    int rock = -1;  // the scene's block that it is, or is a cell of; of a plate, the one that it lies against
    bool cell = false;
    int plateOf = -1;  // bolt whose plate it is
    std::vector<char> inner;  // a row per edge: glued to other cells from end to end; empty: none
    std::vector<int> turns;  // corners at which the outline turns, or its joint material changes: no other is a corner
                             // to a contact
    bool fixed = false;
};

struct JointModel {
    double tanPhi = 0.0;
    double cohesion = 0.0, tensileStrength = 0.0;  // [Pa]
    double tanResidual = 0.0;  // after the first slip; tanPhi where nothing is lost
    std::optional<double> normalStiffness, shearStiffness;  // [Pa/m]
    std::optional<double> crushingStrength;  // [Pa] under a bolt
};

/// Elastic bond along an edge that two cells share (theory, "Sub-blocks").
struct GlueModel {
    int a = -1, b = -1;  // blocks
    Point placeA{0.0, 0.0}, placeB{0.0, 0.0};  // the edge's middle in either frame at the start, from the centroid [m]
    Point along{1.0, 0.0};  // the edge with `a` on its left, at the start
    double length = 0.0;  // [m]
    double normal = 0.0, shear = 0.0;  // springs at the middle [N/m]
    double turn = 0.0;  // spring between the two sides' directions [N m/rad]
};

/// A point fixed in x, y or both by a spring.
struct PointSupport {
    int block = -1;
    Point place{0.0, 0.0};  // from the centroid, in the block's frame at the start [m]
    bool x = false, y = false;
    double stiffness = 0.0;  // [N/m]
    Point preload{0.0, 0.0};  // force on the block where it has not moved: of the in-situ stress [N]
};

/// Borehole segment in one block: two points fixed in it (paper, §3.2.2).
struct Slot {
    int block = -1;
    Point p2{0.0, 0.0}, p3{0.0, 0.0};  // in the block's frame at the start, from its centroid [m]
    double s2 = 0.0, s3 = 0.0;  // the same along the bolt [m]
};

using Interval = std::pair<double, double>;  // from and to along the unstrained bolt [m]

/// What ties a node to the rock along the bolt, before its tributary length is known.
struct AnchorModel {
    bool real = false;
    bool canFail = false;  // otherwise elastic without limit
    Per per = Per::Node;
    double stiffness = 0.0, residual = 0.0;  // [N/m, N] or per metre
    std::optional<double> strength;
    double tanPhi = 0.0;  // times the normal spring's force, added to strength and residual
    bool restick = true;
    bool boltLost = false;  // this anchor's failure loses the whole bolt
    bool curveEnds = false;  // nothing past the curve's last slip
    std::optional<Backbone> curve;  // of a force–slip curve, or of a bond that softens
    std::optional<Backbone> dynamicCurve;  // where the dynamic factor changes it
    int entry = -1;  // row of BoltModel::intervals
};

struct BoltElement {
    double length = 0.0;  // [m]
    bool shears = false;  // crosses or touches a joint
};

/// Dynamic over static strength of the parts of a bolt.
struct StrengthFactors {
    double bond = 1.0, steel = 1.0, plate = 1.0;
};

struct PlateModel {
    bool present = false;
    int block = -1;
    Point place{0.0, 0.0};  // the head's place in that block
    Point along{1.0, 0.0};  // the bolt's axis there, in the block's frame at the start
    double normalStiffness = 0.0, shearStiffness = 0.0;  // [N/m]
    std::optional<double> normalStrength, shearStrength;  // [N]
};

struct BoltModel {
    std::string name;
    std::vector<double> s;  // nodes from the far end [m]
    std::vector<BoltElement> elements;
    std::vector<AnchorModel> anchors;  // a row per node
    std::vector<std::vector<Interval>> intervals;  // that each anchor entry holds and no later one takes
    std::vector<Slot> slots;  // along the bolt
    std::vector<double> joints;  // where slots end inside the bolt [m]
    double dowelLength = 0.0;  // over which a dowel bends, 1/β [m]
    bool shears = true;  // something in the scene may shear it at a joint
    std::vector<int> startBlock;  // a row per node; −1: gap, joint or outside
    Point farEnd{0.0, 0.0}, axis{1.0, 0.0};
    double angle = 0.0;  // [rad]
    double share = 1.0;  // thickness over spacing: bolts in the model's thickness
    BeamSection section;
    std::optional<Backbone> steel;  // none: linear and unbreakable
    std::optional<Backbone> dynamicSteel;  // where the dynamic factor changes it
    double tensileStrength = 0.0;  // N_p [N]; 0: unlimited
    double shearStrength = 0.0;  // Q_p [N]; 0: unlimited
    bool interacts = false;  // tension and shear rupture it together
    bool hinges = false;
    double plasticModulus = 0.0;  // Z [m³]
    StrengthFactors dynamicFactors;  // in dynamic stages
    double pretension = 0.0;  // [N]
    double diameter = 0.0;  // [m]
    bool bends = true;
    double normalStiffness = 0.0;  // [N/m] or [N/m per m]
    Per normalPer = Per::Node;
    PlateModel plate;
    int firstNode = 0;  // index of its node 0 among all nodes
};

struct Model {
    Point origin{0.0, 0.0};  // subtracted from every coordinate of the scene
    double size = 1.0;  // diagonal of the scene [m]
    double tolerance = 1e-9;  // geometric [m]
    double thickness = 1.0;
    Point gravity{0.0, 0.0};
    double stiffest = 1.0;  // largest spring of the scene [N/m]
    std::vector<BlockModel> blocks;  // rows of `solvedBlocks`
    std::vector<int> firstOf;  // row where each block of the scene begins, then where the plates do
    std::vector<GlueModel> glue;
    std::vector<JointModel> joints;  // the scene's, then the built-in one, then intact rock
    int openings = 0;  // rows of `State::openings`: of `joints`, then of joints and sets by their place in the scene
    bool hasSides = false;  // of a domain, by `faceSides`
    std::vector<PointSupport> supports;
    std::vector<BoltModel> bolts;
    int nodes = 0;
    Analysis analysis;
};

/// Corners where they are at the start [m].
std::vector<Point> startCorners(const BlockModel& block);

/// Row of Model::joints of what has no joint material of the scene; the last row is intact rock.
inline int builtInRow(const Model& model) { return static_cast<int>(model.joints.size()) - 2; }
inline int intactRow(const Model& model) { return static_cast<int>(model.joints.size()) - 1; }

/// Joint material of the face on an edge of a block, a row of Model::joints.
inline int jointOfFace(const BlockModel& block, int edge) {
    return block.faceJoints.empty() ? block.jointMaterial : block.faceJoints[static_cast<std::size_t>(edge)];
}

/// True for one block, and for two cells of one.
bool sameRock(const Model& model, int a, int b);

/// Cells of one block count as one: the first row of the block that `row` is or is a cell of.
int wholeOf(const Model& model, int row);

/// One past the last row of the block, or of its cells, that begins at `first`.
int endOfWhole(const Model& model, int first);

/// Area of a block with all its cells [m²], and its square root [m]. \pre `first` as of `wholeOf`.
double wholeArea(const Model& model, int first);
double wholeSize(const Model& model, int first);

/// The row of a block of the scene, or of its first cell, that holds `place` at the start. \pre one does.
int rowHolding(const Model& model, int block, const Point& place);

JointModel jointModel(const JointMaterial& material);

/// The rows of Model::joints for these materials.
std::vector<JointModel> jointRows(const std::vector<std::pair<std::string, JointMaterial>>& materials);

}  // namespace keyblock
