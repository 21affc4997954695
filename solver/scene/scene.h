// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document: one scene as plain values. Every field of a scene file is here
// with its unit and default; nothing is computed. Objects refer to each other by
// name, never by pointer, so a scene can be copied, compared, kept for undo and
// passed to a worker thread.
//
// Angles are in degrees, as the user types them; all other values are in SI units.
#pragma once

#include "geometry/point.h"
#include "geometry/shape/tunnel_profile.h"
#include "solver/scene/anchor_laws.h"
#include "solver/scene/bolt_quantities.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace keyblock {

enum class Plane { Stress, Strain };
enum class Integration { Shi, BackwardEuler, Newmark, GeneralizedAlpha };
enum class Iteration { Convex, OpenClose };
enum class ContactMethod { Penalty, AugmentedLagrangian };
enum class Preset { Sketch, Draft, Engineering, Reference };

/// Rayleigh damping of dynamic stages. A body of mass M and velocity v is subject to the damping force `mass`·M·v. In
/// blocks and bolt shanks, the damping stress is `stiffness` times the elastic stiffness times the strain rate.
struct Damping {
    double mass = 0.0;  // [1/s]
    double stiffness = 0.0;  // [s]

    bool operator==(const Damping&) const = default;
};

/// Settings of the whole analysis. Those that are null are determined by the preset (solver/scene/preset).
struct Analysis {
    Plane plane = Plane::Strain;
    double thickness = 1.0;  // [m]
    Point gravity{0.0, 0.0};  // [m/s²]
    Integration integration = Integration::Shi;  // of dynamic stages that do not set their own
    double rhoInf = 0.8;  // generalised-α: spectral radius at infinite frequency; of stages that do not set their own
    Damping damping;
    Iteration iteration = Iteration::Convex;  // method that determines the contact states
    Preset preset = Preset::Engineering;
    std::optional<ContactMethod> contact;  // method that prevents penetration
    std::optional<double> penaltyRatio;  // contact stiffness = ratio · E · thickness
    double shearRatio = 0.4;  // ratio of shear to normal contact stiffness
    std::optional<double> tolerance;  // iteration tolerance: unbalanced force relative to the acting forces
    std::optional<int> maxPasses;  // iterations of a step before the time step or increment is reduced
    std::optional<double> sleepTolerance;  // unbalanced force on a sleeping block over its weight; 0: no block sleeps
    std::optional<double> timeStepFactor;  // times automatic time steps
    std::optional<double> divisionsFactor;  // times the fineness of automatic divisions of bolts
    bool modelEverything = false;  // model parts that do not affect the results as well

    bool operator==(const Analysis&) const = default;
};

struct Material {
    double density = 0.0;  // [kg/m³]
    double youngsModulus = 0.0;  // [Pa]
    double poissonsRatio = 0.0;

    bool operator==(const Material&) const = default;
};

/// Strength and stiffness of block faces.
struct JointMaterial {
    double frictionAngle = 30.0;  // [°]
    double cohesion = 0.0;  // [Pa]
    double tensileStrength = 0.0;  // [Pa]
    std::optional<double> residualFrictionAngle{};  // [°] after the first slip; null: unchanged
    std::optional<double> normalStiffness{}, shearStiffness{};  // [Pa/m]; null: from the analysis settings
    std::optional<double> crushingStrength{};  // [Pa] bearing pressure under a bolt; null: no limit

    bool operator==(const JointMaterial&) const = default;
};

/// In-plane stress sxx, syy, sxy [Pa]; tension is positive.
using Stress = std::array<double, 3>;

/// Gradient of stress with elevation [Pa/m].
struct StressGradient {
    double sxx = 0.0, syy = 0.0, sxy = 0.0;

    bool operator==(const StressGradient&) const = default;
};

/// In-situ stress before excavation. At elevation y it is (sxx, syy, sxy) + `gradientY`·(y − `referenceY`).
struct InSituStress {
    double sxx = 0.0, syy = 0.0, sxy = 0.0;  // [Pa]
    StressGradient gradientY;
    double referenceY = 0.0;  // [m]

    bool operator==(const InSituStress&) const = default;
};

/// Division of a block into cells that are glued together, so that the stress can vary within the block.
struct CellSettings {
    double size = 0.0;  // approximate cell size [m]

    bool operator==(const CellSettings&) const = default;
};

/// Special values of a joint-material index, for faces without a material from the scene's list.
inline constexpr int builtInJoint = -1;  // if the scene defines no joint material
inline constexpr int intactJoint = -2;  // intact rock across a tunnel outline or a split: neither slips nor opens

enum class BoundarySide { Left, Right, Bottom, Top, All };

/// Origin and joint material of the face on one edge of a cut block.
struct CutFace {
    int joint = builtInJoint;  // index into the scene's joint materials, `builtInJoint` or `intactJoint`
    int source = -1;  // index of its joint, or joints.size() + index of its joint set; −1: neither
    std::optional<BoundarySide> side;  // side of the domain; null: not on the domain's boundary

    bool operator==(const CutFace&) const = default;
};

struct Block {
    std::string name;  // empty: displayed as b1, b2, … by position in the list
    std::vector<Point> points;  // corners [m], clockwise or counter-clockwise
    std::string material;
    std::optional<std::string> jointMaterial;
    Stress initialStress{0.0, 0.0, 0.0};  // [Pa]
    std::optional<CellSettings> subBlocks;  // null: not divided, uniform stress
    bool inOpening = false;  // in a tunnel open from the start: no in-situ stress; set by `cutScene`
    // Set by `cutScene` for the blocks that it cuts; not stored in files.
    std::vector<CutFace> faces{};  // one per edge, counter-clockwise; empty: block not made by `cutScene`
    std::vector<int> tunnels{};  // indices of the scene's tunnels that contain the block

    bool operator==(const Block&) const = default;
};

/// The domain of the section: a polygon whose interior is cut into blocks.
struct SceneDomain {
    std::vector<Point> boundary;  // corners [m], clockwise or counter-clockwise
    std::string material;
    std::optional<std::string> jointMaterial;  // of the boundary, and default of the joints; null: first of the scene

    bool operator==(const SceneDomain&) const = default;
};

/// Tolerance and minimum block size of the cut. If a value is null, the cut derives it from the size of the domain or
/// the mean size of the blocks.
struct Cutting {
    std::optional<double> tolerance;  // [m]; points and lines closer than this are joined
    std::optional<double> minArea;  // [m²]; smaller blocks are merged with a neighbour; 0: none are merged
    std::optional<double> minWidth;  // [m]; narrower blocks are merged with a neighbour; 0: none are merged

    bool operator==(const Cutting&) const = default;
};

/// A single joint along a polyline.
struct SceneJoint {
    std::string name;
    std::vector<Point> points;  // [m]
    std::optional<std::string> jointMaterial;  // null: the domain's

    bool operator==(const SceneJoint&) const = default;
};

/// A joint set; geometry/shape/joint_set.h generates its traces.
struct SceneJointSet {
    std::string name;
    double dip = 0.0;  // [°] counter-clockwise from +x
    double dipDeviation = 0.0;  // [°]
    double spacing = 0.0;  // [m]
    double spacingDeviation = 0.0;  // [m]
    std::optional<double> traceLength;  // [m]; null: through-going
    double traceLengthDeviation = 0.0;  // [m]
    double bridge = 0.0;  // [m]
    double bridgeDeviation = 0.0;  // [m]
    std::optional<double> stagger = 0.0;  // offset between lines, as a fraction of trace length + bridge; null: random
    Point origin{0.0, 0.0};  // [m]
    int seed = 1;
    std::optional<std::string> jointMaterial;  // null: the domain's
    std::optional<std::string> region;  // null: the whole domain

    bool operator==(const SceneJointSet&) const = default;
};

enum class ProfileKind { Circle, DShape, Horseshoe, Arched, Polygon };

/// A tunnel, defined by the dimensions of its profile or by a polygon.
struct SceneTunnel {
    std::string name;
    ProfileKind profile = ProfileKind::Circle;
    Point center{0.0, 0.0};  // of the bounding box [m]; not used for a polygon
    double diameter = 0.0;  // [m]
    double width = 0.0, height = 0.0;  // [m]
    double wallHeight = 0.0, rise = 0.0;  // [m]
    std::vector<Point> points;  // [m]

    bool operator==(const SceneTunnel&) const = default;
};

/// Part of the section to which joint sets or Voronoi cells can be confined.
struct SceneRegion {
    std::string name;
    std::vector<Point> points;  // corners [m], clockwise or counter-clockwise

    bool operator==(const SceneRegion&) const = default;
};

/// Voronoi cells that fill a region.
struct SceneVoronoi {
    double size = 0.0;  // approximate cell size [m]
    int seed = 1;
    std::optional<std::string> region;  // null: the whole domain
    std::optional<std::string> jointMaterial;  // null: the domain's

    bool operator==(const SceneVoronoi&) const = default;
};

enum class Fix { All, X, Y, XY };

/// A support of one of three kinds. `blockAt` fixes a whole block (`fix` is All). `point` fixes one point of a block
/// (`fix` is X, Y or XY). `boundary` fixes every block that has a face on a side of the domain: the whole block if
/// `fix` is All, otherwise only the corners of these faces.
struct Support {
    std::optional<Point> blockAt;  // [m]
    std::optional<Point> point;  // [m]
    std::optional<BoundarySide> boundary;
    Fix fix = Fix::All;

    bool operator==(const Support&) const = default;
};

/// Piecewise-linear table of (x, y) pairs, usually (time, value). In a static stage, time is pseudo-time from 0 to 1.
using Table = std::vector<std::pair<double, double>>;

enum class Rotation { Held, Free };

/// Prescribed displacement [m] of a block's centroid along `axis`, measured from the start of the run or from the last
/// stage with `zero_displacements`.
struct Motion {
    Point blockAt{0.0, 0.0};  // [m]
    Point axis{1.0, 0.0};  // of any length except zero
    Table table;  // (time, displacement [m])
    Rotation rotation = Rotation::Held;

    bool operator==(const Motion&) const = default;
};

/// Force or pressure on blocks, located by exactly one of `blockAt`, `point` and `along`.
struct Load {
    std::optional<Point> blockAt;  // [m]; force on the block around this point, at its centroid or at `at`
    std::optional<Point> at;  // [m]; only with `blockAt`
    std::optional<Point> point;  // [m]; force at this point, on the block that contains it
    std::optional<std::array<Point, 2>> along;  // [m]; pressure on the block edges along this line
    Point force{0.0, 0.0};  // [N], total over the thickness
    double pressure = 0.0;  // [Pa]; positive: pushes against the edges
    Table table;  // (time, factor); empty: 1 throughout

    bool operator==(const Load&) const = default;
};

struct InitialVelocity {
    Point blockAt{0.0, 0.0};  // [m]
    Point velocity{0.0, 0.0};  // [m/s]
    double spin = 0.0;  // [rad/s]

    bool operator==(const InitialVelocity&) const = default;
};

/// The value amplitude · sin(2π·frequency·t + phase) at time t [s] of a stage.
struct Sine {
    double amplitude = 0.0;  // before multiplication by `Acceleration::factor`
    double frequency = 1.0;  // [Hz]
    double phase = 0.0;  // [rad]

    bool operator==(const Sine&) const = default;
};

/// Acceleration along `axis`: a record, a sine or a constant value, multiplied by `factor`. Time starts at 0 in each
/// dynamic stage. Static stages accept only a constant value, which is applied in proportion to pseudo-time.
struct Acceleration {
    std::string file;  // record file as named in the scene; empty: the record is part of the scene
    Table record;  // (time [s], value), interpolated linearly; zero before the first row and after the last
    std::optional<Sine> sine;
    std::optional<double> value;  // constant; reached at the end of a static stage
    Point axis{1.0, 0.0};  // of any length except zero
    double factor = 1.0;  // [m/s²] per unit of the record, the sine or the value

    bool operator==(const Acceleration&) const = default;
};

/// New strength of a joint material; null values leave the strength unchanged.
struct StrengthChange {
    std::string jointMaterial;
    std::optional<double> frictionAngle;  // [°]
    std::optional<double> cohesion;  // [Pa]
    std::optional<double> tensileStrength;  // [Pa]
    std::optional<double> residualFrictionAngle{};  // [°] after the first slip

    bool operator==(const StrengthChange&) const = default;
};

/// Equilibrium criteria of a static stage, and the maximum number of steps of the search for equilibrium.
struct Until {
    std::optional<double> unbalanced;  // unbalanced force / reference force; null: `automaticUnbalanced`
    std::optional<double> body;  // unbalanced force on a block / its own weight; null: 1e-3
    std::optional<double> move = 0.1;  // largest displacement of a block in the stage / its size; null: no limit
    std::optional<double> smallest;  // [m²]; smaller blocks do not decide stability; null: 0.01
    std::optional<int> maxSteps;  // pseudo-steps of the search; null: limited by `RunLimits::iterations` only

    bool operator==(const Until&) const = default;
};

/// Prescribed opening, for example due to swelling or a wedge that is driven in. It applies to the faces on a joint or
/// joint set, or to all contacts of a joint material.
struct Dilation {
    std::string joint;  // name of a joint, joint set or joint material, looked up in this order
    double rate = 0.0;  // [m/s]; in a static stage, the opening over the whole stage [m]
    int source = -1;  // `CutFace::source` of the joint or set, set by `cutScene`; −1: a joint material

    bool operator==(const Dilation&) const = default;
};

enum class StageKind { Static, Dynamic };
enum class OnCollapse { End, Dynamic };

struct Stage {
    std::string name;
    StageKind kind = StageKind::Static;
    std::vector<Motion> motions;
    std::vector<Load> loads;
    std::vector<Dilation> dilations;
    std::vector<StrengthChange> set;  // strength changes at the start of the stage; they remain in later stages
    std::vector<std::string> excavate;  // names of tunnels and blocks excavated at the start of the stage
    std::vector<std::string> install, remove;  // bolts and patterns installed or removed at the start of the stage
    bool zeroDisplacements = false;
    bool continueAfterCollapse = true;  // key `continue`
    // Static stages; `relaxation` also applies to dynamic ones.
    Until until;
    std::optional<int> increments;  // equal increments of pseudo-time 0 … 1; null: chosen by the program
    std::optional<double> relaxation;  // fraction of the wall forces released by the end of the stage; null: all
    OnCollapse onCollapse = OnCollapse::End;  // what follows a collapse
    double collapseDuration = 1.0;  // [s]; duration of the motion that follows a collapse
    // Dynamic stages.
    double duration = 0.0;  // [s]
    std::optional<double> timeStep;  // longest time step [s]; null: chosen by the program
    std::optional<Integration> integration;  // null: that of the analysis
    std::optional<double> rhoInf;  // null: that of the analysis
    std::vector<InitialVelocity> initialVelocities;
    std::vector<std::string> viscousBoundaries;  // sides that absorb outgoing waves: left, right, bottom, top, all
    std::optional<Acceleration> baseAcceleration;  // acceleration of the ground, which all supports follow
    // Static and dynamic stages.
    std::optional<Acceleration> bodyAcceleration;  // body force per unit mass, in addition to gravity
    bool followsCollapse = false;  // runs only if the previous stage collapsed; set by `withCollapseStages`

    bool operator==(const Stage&) const = default;
};

enum class BoltClass { CMC, CFC, DMC, DFC };
enum class Bending { None, Elastic, ElasticPlastic };
enum class Per { Node, Length };
enum class AfterCurve { Last, Zero };
enum class OnFailure { None, BoltLost };
enum class RuptureRule { Independent, Interaction };

/// Position along a bolt: either a distance from its far end, or the head.
struct BoltPlace {
    bool head = false;
    double s = 0.0;  // [m] from the far end; not used if `head`

    bool operator==(const BoltPlace& other) const { return head == other.head && (head || s == other.s); }
};

/// One entry of a bolt's anchor table: selects nodes that are bonded to the rock and gives their bond law.
struct Anchor {
    std::optional<BoltPlace> at;  // selects the node nearest to this position; null: the nodes from `from` to `to`
    BoltPlace from;
    BoltPlace to{true, 0.0};
    Per per = Per::Length;  // entries with `at` are always per node
    AnchorLaw law = AnchorLaw::Elastic;
    double stiffness = 0.0;  // [N/m] per node, or [N/m per m] per unit length
    std::optional<double> strength;  // [N] per node, or [N/m] per unit length; null: unlimited (elastic)
    double residual = 0.0;  // [N] or [N/m]; peak–residual law only
    double softeningSlip = 0.0;  // [m] from peak to residual strength; peak–residual law only; 0: brittle
    double frictionAngle = 0.0;  // [°]; strength and residual increase by its tangent times the normal spring force
    bool restick = true;
    Table curve;  // (slip [m], force [N] or [N/m]), starting at the origin
    AfterCurve after = AfterCurve::Last;
    OnFailure onFailure = OnFailure::None;

    bool operator==(const Anchor&) const = default;
};

/// Face plate between the head node of a bolt and the rock. If a strength is null, it is unlimited.
struct Plate {
    double normalStiffness = 1e9;  // [N/m]
    double shearStiffness = 1e8;  // [N/m]
    std::optional<double> normalStrength;  // [N]
    std::optional<double> shearStrength;  // [N]
    double width = 0.15;  // [m]
    double thickness = 0.01;  // [m]
    double youngsModulus = 215.8e9;  // [Pa]
    double poissonsRatio = 0.25;
    double density = 7850.0;  // [kg/m³]

    bool operator==(const Plate&) const = default;
};

/// A bolt type in which all values inherited through `like` have been filled in.
struct BoltType {
    std::string name;
    bool builtIn = false;  // from the bolt library, so not written with the scene
    std::string like;  // name of the type it is derived from; empty: none
    BoltClass boltClass = BoltClass::CMC;
    std::string source;
    double diameter = 0.02;  // [m]
    std::optional<double> area;  // [m²]; null: solid bar of this diameter
    std::optional<double> secondMoment;  // [m⁴]; null: from diameter and area
    std::optional<double> plasticModulus;  // [m³]; null: from diameter and area
    double density = 7850.0;  // [kg/m³]
    double shearModulus = 80e9;  // [Pa]
    double shearCoefficient = 4.0 / 3.0;
    std::optional<double> youngsModulus;  // [Pa]; null: slope of the first segment of `steel`
    Table steel;  // (strain, stress [Pa]), starting at the origin; empty: linear, without rupture
    std::optional<double> tensileStrength;  // [Pa]; null: the largest stress of `steel`
    double shearStrengthRatio = 0.6;  // ratio of shear to tensile strength
    RuptureRule ruptureRule = RuptureRule::Independent;
    Bending bending = Bending::ElasticPlastic;
    std::optional<double> normalStiffness;  // across the bolt, [N/m] per node or [N/m per m]; null: chosen, per length
    Per normalPer = Per::Node;
    std::vector<Anchor> anchors;
    Plate plate;
    double dynamicFactor = 1.0;  // ratio of dynamic to static strength of the bond
    double steelDynamicFactor = 1.0;  // the same ratio for the steel, in tension, shear and bending
    double plateDynamicFactor = 1.0;  // the same ratio for the face plate
    std::map<std::string, std::string> sources;  // field name → source of its value

    bool operator==(const BoltType&) const = default;
};

enum class PlateKind { None, Spring, Block };

struct Bolt {
    std::string name;
    std::string type;
    Point farEnd{0.0, 0.0};  // [m]
    Point head{0.0, 0.0};  // [m]
    std::optional<int> divisions;  // number of elements; null: chosen by the program
    PlateKind plate = PlateKind::Spring;
    std::optional<double> spacingOutOfPlane;  // [m]; null: thickness of the analysis
    double pretension = 0.0;  // [N] to which the head is tensioned against the plate at installation
    std::optional<std::vector<Anchor>> anchors;  // null: anchors of the type
    std::optional<double> dynamicFactor, steelDynamicFactor, plateDynamicFactor;  // null: of the type
    int pattern = -1;  // index of the bolt pattern from which `cutScene` made the bolt; −1: none; not stored in files

    bool operator==(const Bolt&) const = default;
};

/// Bolts at equal spacing along the wall of a tunnel, laid out by geometry/shape/bolt_pattern.h. The bolts of a pattern
/// named P are called P.1, P.2, …
struct ScenePattern {
    std::string name;
    std::string type;
    std::string tunnel;
    Point from{0.0, 0.0}, to{0.0, 0.0};  // the pattern starts and ends at the wall points nearest to these [m]
    Way way = Way::CounterClockwise;
    double spacing = 0.0;  // along the wall [m]
    double offset = 0.0;  // of the first bolt from the start, along the wall [m]
    double length = 0.0;  // of each bolt [m]
    double angleFromWall = 90.0;  // [°]
    std::optional<int> divisions;  // number of elements per bolt; null: chosen by the program
    PlateKind plate = PlateKind::Spring;
    std::optional<double> spacingOutOfPlane;  // [m]; null: thickness of the analysis
    double pretension = 0.0;  // [N]

    bool operator==(const ScenePattern&) const = default;
};

/// Records the displacement of a point, the opening between two points, or a quantity of a bolt.
struct Monitor {
    std::string name;
    std::optional<Point> point;  // [m]; records two values: displacements ux, uy [m]
    std::optional<std::array<Point, 2>> between;  // [m]; records the increase of their distance along `axis` [m]
    Point axis{1.0, 0.0};
    std::optional<std::string> bolt;  // name of the bolt; records one value
    BoltQuantity quantity = BoltQuantity::AxialForce;
    std::optional<double> at;  // [m] from the far end
    std::optional<double> atFromHead;  // [m] from the head
    std::optional<double> atFraction;  // 0 … 1 from the far end

    bool operator==(const Monitor&) const = default;
};

struct Output {
    std::optional<int> frames;  // number of frames over the whole run; null: at most `defaultFrames`
    std::optional<double> every;  // interval between frames, time [s] or pseudo-time; overrides `frames`

    bool operator==(const Output&) const = default;
};

/// Maximum number of frames over the whole run if the scene does not set one.
inline constexpr int defaultFrames = 200;

/// Limits at which a run or stage ends before it is complete.
struct RunLimits {
    std::optional<double> wallTime;  // wall-clock time [s]; null: no limit
    std::optional<int> steps;  // accepted steps over all stages; null: no limit
    std::optional<int> iterations;  // pseudo-steps since the last event or accepted increment; null: 20,000
    double energy = 0.05;  // largest energy-balance error of a dynamic stage / largest term of the balance

    bool operator==(const RunLimits&) const = default;
};

/// Which strengths are divided by the factor of safety: joint strengths, bolt anchor strengths, or both.
enum class Reduce { Joints, Bonds, Both };

/// Treatment of bolts while strengths are reduced. Mobilised: bolts are modelled as in an ordinary run. Frozen: they
/// are replaced by dead loads equal to their forces in the run with unreduced strengths.
enum class BoltForces { Mobilised, Frozen };

/// Settings of the search for a factor of safety; ordinary runs ignore them.
struct Safety {
    Reduce reduce = Reduce::Joints;
    double tolerance = 0.01;  // largest difference between the stable and the failing factor at the end of the search
    BoltForces boltForces = BoltForces::Mobilised;

    bool operator==(const Safety&) const = default;
};

struct Expected {
    std::string quantity;  // written as in `Scene::quantities`
    double value = 0.0;  // in SI units
    double tolerance = 0.01;  // relative; absolute if `value` is 0
    std::string source;  // source of the number, as text for the user

    bool operator==(const Expected&) const = default;
};

struct About {
    std::string shows;
    std::string source;
    std::string category;
    std::vector<Expected> expected;

    bool operator==(const About&) const = default;
};

/// A whole scene. Named entries are stored as lists, so they keep the order of the file.
struct Scene {
    std::string title;
    About about;
    Analysis analysis;
    std::vector<std::pair<std::string, Material>> materials;
    std::vector<std::pair<std::string, JointMaterial>> jointMaterials;
    std::optional<SceneDomain> domain;
    Cutting cutting;
    std::vector<SceneJoint> joints;
    std::vector<SceneJointSet> jointSets;
    std::optional<SceneVoronoi> voronoi;
    std::vector<SceneRegion> regions;
    std::vector<SceneTunnel> tunnels;
    std::vector<Block> blocks;
    std::vector<Support> supports;
    std::optional<InSituStress> inSituStress;
    std::vector<BoltType> boltTypes;  // the scene's own types and the built-in ones that its bolts use
    std::vector<Bolt> bolts;
    std::vector<ScenePattern> boltPatterns;
    std::vector<Stage> stages;
    std::vector<Monitor> monitors;
    std::vector<std::string> quantities;
    Safety safety;
    Output output;
    RunLimits limits;

    bool operator==(const Scene&) const = default;
};

/// Joint material of all block faces in a scene without joint materials.
inline const JointMaterial builtInJointMaterial{};

}  // namespace keyblock
