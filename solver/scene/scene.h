// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document: one scene as plain values. Everything a scene file can say
// is here with its unit and its default; nothing here is computed. Objects
// refer to each other by name, never by pointer, so a scene can be copied,
// compared, kept for undo and handed to a worker.
//
// Angles are in degrees, as the user types them; everything else is SI.
#pragma once

#include "geometry/point.h"
#include "geometry/tunnel_profile.h"
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

/// Rayleigh damping of dynamic stages: forces mass·M·v, and stiffness·K·(rate of strain) of blocks and bolts.
struct Damping {
    double mass = 0.0;  // [1/s]
    double stiffness = 0.0;  // [s]

    bool operator==(const Damping&) const = default;
};

/// Settings of the whole analysis.
struct Analysis {
    Plane plane = Plane::Strain;
    double thickness = 1.0;  // [m]
    Point gravity{0.0, 0.0};  // [m/s²]
    Integration integration = Integration::Shi;  // dynamic stages that name none
    double rhoInf = 0.8;  // generalized-alpha: share of very stiff motion that a step keeps; stages that give none
    Damping damping;
    Iteration iteration = Iteration::Convex;  // how the states of contacts are found
    ContactMethod contact = ContactMethod::Penalty;  // how contacts are kept closed
    double penaltyRatio = 40.0;  // contact spring = ratio · E · thickness
    double shearRatio = 0.4;  // shear over normal contact stiffness
    double tolerance = 1e-4;  // pass tolerance: unbalanced force over the forces at play
    int maxPasses = 40;  // passes of one step before it is cut

    bool operator==(const Analysis&) const = default;
};

struct Material {
    double density = 0.0;  // [kg/m³]
    double youngsModulus = 0.0;  // [Pa]
    double poissonsRatio = 0.0;

    bool operator==(const Material&) const = default;
};

/// Strength of the faces of blocks.
struct JointMaterial {
    double frictionAngle = 30.0;  // [°]
    double cohesion = 0.0;  // [Pa]
    double tensileStrength = 0.0;  // [Pa]
    std::optional<double> residualFrictionAngle{};  // after the first slip [°]; none: as before
    std::optional<double> normalStiffness{}, shearStiffness{};  // [Pa/m]; none: from the analysis
    std::optional<double> crushingStrength{};  // [Pa] under a bolt that presses across its hole; null: no limit

    bool operator==(const JointMaterial&) const = default;
};

/// Stress in the plane: sxx, syy, sxy [Pa], tension positive.
using Stress = std::array<double, 3>;

/// Change of a stress per metre upwards [Pa/m].
struct StressGradient {
    double sxx = 0.0, syy = 0.0, sxy = 0.0;

    bool operator==(const StressGradient&) const = default;
};

/// Stress in the rock before excavation: at height y it is the given one plus
/// `gradientY`·(y − referenceY).
struct InSituStress {
    double sxx = 0.0, syy = 0.0, sxy = 0.0;  // [Pa]
    StressGradient gradientY;
    double referenceY = 0.0;  // [m]

    bool operator==(const InSituStress&) const = default;
};

/// Cuts a block into cells joined by glue, so that its stress may vary within it.
struct CellSettings {
    double size = 0.0;  // of a cell, about [m]

    bool operator==(const CellSettings&) const = default;
};

/// Joint materials that no scene lists, in addition to the indices of those that it does.
inline constexpr int builtInJoint = -1;  // where the scene has none
inline constexpr int intactJoint = -2;  // rock that only a tunnel's outline parts: neither slips nor opens

enum class BoundarySide { Left, Right, Bottom, Top, All };

/// Where the face on an edge of a cut block comes from.
struct CutFace {
    int joint = builtInJoint;  // index into the scene's joint materials, or one of the above
    int source = -1;  // the joint that it lies on, or joints.size() + the joint set; −1: neither
    std::optional<BoundarySide> side;  // of the domain, on its boundary

    bool operator==(const CutFace&) const = default;
};

struct Block {
    std::string name;  // empty: b1, b2, … by order
    std::vector<Point> points;  // [m], in either direction
    std::string material;
    std::optional<std::string> jointMaterial;
    Stress initialStress{0.0, 0.0, 0.0};  // [Pa]
    std::optional<CellSettings> subBlocks;  // null: one block with one stress
    bool inOpening = false;  // wholly in a tunnel that no stage excavates: no stress in situ; `cutScene` says it, no file
    // of blocks that `cutScene` made; no file says it
    std::vector<CutFace> faces{};  // a row per edge, counter-clockwise; empty: not cut
    std::vector<int> tunnels{};  // the scene's that it lies in

    bool operator==(const Block&) const = default;
};

/// The region that is cut into blocks.
struct SceneDomain {
    std::vector<Point> boundary;  // [m], in either direction
    std::string material;
    std::optional<std::string> jointMaterial;  // of its boundary, and of joints that name none; null: as of a block

    bool operator==(const SceneDomain&) const = default;
};

/// Limits of the cut; null: relative to the domain's size.
struct Cutting {
    std::optional<double> tolerance;  // what is closer than this meets [m]
    std::optional<double> minArea;  // smaller blocks join a neighbour [m²]; 0: none
    std::optional<double> minWidth;  // narrower ones do [m]; 0: none

    bool operator==(const Cutting&) const = default;
};

/// One joint along a line of points.
struct SceneJoint {
    std::string name;
    std::vector<Point> points;  // [m]
    std::optional<std::string> jointMaterial;  // null: the domain's

    bool operator==(const SceneJoint&) const = default;
};

/// Traces of a joint set, as geometry/joint_set.h draws them.
struct SceneJointSet {
    std::string name;
    double dip = 0.0;  // [°] counter-clockwise from +x
    double dipDeviation = 0.0;  // [°]
    double spacing = 0.0;  // [m]
    double spacingDeviation = 0.0;  // [m]
    std::optional<double> traceLength;  // [m]; null: right through
    double traceLengthDeviation = 0.0;  // [m]
    double bridge = 0.0;  // [m]
    double bridgeDeviation = 0.0;  // [m]
    std::optional<double> stagger = 0.0;  // null: at random
    Point origin{0.0, 0.0};  // [m]
    int seed = 1;
    std::optional<std::string> jointMaterial;  // null: the domain's
    std::optional<std::string> region;  // null: the whole domain

    bool operator==(const SceneJointSet&) const = default;
};

enum class ProfileKind { Circle, DShape, Horseshoe, Arched, Polygon };

/// A tunnel by the few numbers of its profile.
struct SceneTunnel {
    std::string name;
    ProfileKind profile = ProfileKind::Circle;
    Point center{0.0, 0.0};  // of the bounding box [m]; not of a polygon
    double diameter = 0.0;  // [m]
    double width = 0.0, height = 0.0;  // [m]
    double wallHeight = 0.0, rise = 0.0;  // [m]
    std::vector<Point> points;  // [m]

    bool operator==(const SceneTunnel&) const = default;
};

/// A part of the section that joint sets and Voronoi cells refer to.
struct SceneRegion {
    std::string name;
    std::vector<Point> points;  // [m], in either direction

    bool operator==(const SceneRegion&) const = default;
};

/// Voronoi cells over a region.
struct SceneVoronoi {
    double size = 0.0;  // of a cell, about [m]
    int seed = 1;
    std::optional<std::string> region;  // null: the whole domain
    std::optional<std::string> jointMaterial;  // null: the domain's

    bool operator==(const SceneVoronoi&) const = default;
};

enum class Fix { All, X, Y, XY };

/// Holds a whole block (`blockAt`, fix all), one point of a block (`point`, fix x, y or xy), or what lies on a side of
/// the domain: whole blocks (fix all) or the corners of their faces there.
struct Support {
    std::optional<Point> blockAt;  // [m]
    std::optional<Point> point;  // [m]
    std::optional<BoundarySide> boundary;
    Fix fix = Fix::All;

    bool operator==(const Support&) const = default;
};

/// Piecewise-linear table of (time, value); time is pseudo-time 0 … 1 in a static stage.
using Table = std::vector<std::pair<double, double>>;

enum class Rotation { Held, Free };

/// Prescribes the displacement of a block's centroid along `axis`, counted from the start of the run or the last
/// `zero_displacements` [m].
struct Motion {
    Point blockAt{0.0, 0.0};  // [m]
    Point axis{1.0, 0.0};  // any length but zero
    Table table;  // (time, displacement [m])
    Rotation rotation = Rotation::Held;

    bool operator==(const Motion&) const = default;
};

/// A force on a block; exactly one of `blockAt`, `point`, `along` says where.
struct Load {
    std::optional<Point> blockAt;  // force at the centroid, or at `at`
    std::optional<Point> at;  // [m], with `blockAt` only
    std::optional<Point> point;  // force at this point of the block that holds it
    std::optional<std::array<Point, 2>> along;  // pressure on the edges along this line
    Point force{0.0, 0.0};  // [N], total over the thickness
    double pressure = 0.0;  // [Pa], positive presses on the block
    Table table;  // (time, factor); empty: 1 throughout

    bool operator==(const Load&) const = default;
};

struct InitialVelocity {
    Point blockAt{0.0, 0.0};  // [m]
    Point velocity{0.0, 0.0};  // [m/s]
    double spin = 0.0;  // [rad/s]

    bool operator==(const InitialVelocity&) const = default;
};

/// amplitude · sin(2π·frequency·t + phase)
struct Sine {
    double amplitude = 0.0;  // of what `Acceleration::factor` multiplies
    double frequency = 1.0;  // [Hz]
    double phase = 0.0;  // [rad]

    bool operator==(const Sine&) const = default;
};

/// An acceleration along `axis`: a record or a sine over the seconds of a dynamic stage, or a constant value, times
/// `factor`. A static stage takes a constant one only and puts it on in proportion to pseudo-time.
struct Acceleration {
    std::string file;  // where the record was read from, as the scene names it; empty: it is in the scene
    Table record;  // (time [s], value); nothing before its first and after its last row, straight lines between
    std::optional<Sine> sine;
    std::optional<double> value;  // constant; at the end of a static stage
    Point axis{1.0, 0.0};  // any length but zero
    double factor = 1.0;  // [m/s²] per unit of the record, the sine or the value

    bool operator==(const Acceleration&) const = default;
};

/// New strength of a joint material; what is null stays as it is.
struct StrengthChange {
    std::string jointMaterial;
    std::optional<double> frictionAngle;  // [°]
    std::optional<double> cohesion;  // [Pa]
    std::optional<double> tensileStrength;  // [Pa]
    std::optional<double> residualFrictionAngle{};  // [°] from the first slip on

    bool operator==(const StrengthChange&) const = default;
};

/// When a static stage is at equilibrium, and when it gives up looking for it.
struct Until {
    std::optional<double> unbalanced;  // unbalanced force over reference force; null: 1e-4, or the pass tolerance if less
    std::optional<double> body;  // of its own weight, unbalanced on a block; null: 1e-3
    std::optional<double> move = 0.1;  // of its size, how far a block may have gone in a stage; null: any way
    std::optional<double> smallest;  // [m²] blocks under it do not decide; null: 0.01
    std::optional<int> maxSteps;  // pseudo-steps of a search; null: `RunLimits::iterations` alone

    bool operator==(const Until&) const = default;
};

/// Opens what lies on a joint or a joint set, or every contact of a joint material, as a joint that swells or a wedge
/// that is driven in.
struct Dilation {
    std::string joint;  // name of a joint, else of a joint set, else of a joint material
    double rate = 0.0;  // [m/s], or [m] over a static stage
    int source = -1;  // `CutFace::source` of the joint or set, by `cutScene`; −1: a joint material; no file says it

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
    std::vector<StrengthChange> set;  // at the start of the stage, for this and all later ones
    std::vector<std::string> excavate;  // names of blocks that go at the start of the stage
    std::vector<std::string> install, remove;  // names of bolts that come or go at the start of the stage
    bool zeroDisplacements = false;
    bool continueAfterCollapse = true;  // "continue"
    // static
    Until until;
    std::optional<int> increments;  // over pseudo-time 0 … 1; null: chosen by the program
    std::optional<double> relaxation;  // share of the walls' forces released by the end; null: 1 of what it excavates
    OnCollapse onCollapse = OnCollapse::End;  // what a collapse is followed by
    double collapseDuration = 1.0;  // [s] of the motion that follows it
    // dynamic
    double duration = 0.0;  // [s]
    std::optional<double> timeStep;  // [s]; null: chosen by the program
    std::optional<Integration> integration;  // null: that of the analysis
    std::optional<double> rhoInf;  // null: that of the analysis
    std::vector<InitialVelocity> initialVelocities;
    std::vector<std::string> viscousBoundaries;  // left, right, bottom, top, all: sides that let waves out
    std::optional<Acceleration> baseAcceleration;  // of the ground, which everything that is held follows
    // static and dynamic
    std::optional<Acceleration> bodyAcceleration;  // force per mass in addition to gravity
    bool followsCollapse = false;  // runs only after a collapse of the stage before, by `withCollapseStages`; no file says it

    bool operator==(const Stage&) const = default;
};

enum class BoltClass { CMC, CFC, DMC, DFC };
enum class Bending { None, Elastic, ElasticPlastic };
enum class Per { Node, Length };
enum class AfterCurve { Last, Zero };
enum class OnFailure { None, BoltLost };
enum class RuptureRule { Independent, Interaction };

/// A place along a bolt: metres from its far end, or the head.
struct BoltPlace {
    bool head = false;
    double s = 0.0;  // [m] from the far end, when not `head`

    bool operator==(const BoltPlace& other) const { return head == other.head && (head || s == other.s); }
};

/// One entry of a bolt's anchor table: which nodes are real, and the law that holds them along the bolt.
struct Anchor {
    std::optional<BoltPlace> at;  // the nearest node; else the range [from, to]
    BoltPlace from;
    BoltPlace to{true, 0.0};
    Per per = Per::Length;  // `at` entries are per node
    AnchorLaw law = AnchorLaw::Elastic;
    double stiffness = 0.0;  // [N/m], or [N/m per m] per length
    std::optional<double> strength;  // [N] or [N/m]; null: unlimited (elastic)
    double residual = 0.0;  // [N] or [N/m], peak–residual only
    double softeningSlip = 0.0;  // [m] from the peak to the residual, peak–residual only; 0: brittle
    double frictionAngle = 0.0;  // [°] adds tan of it times the normal spring's force to strength and residual
    bool restick = true;
    Table curve;  // (slip [m], force [N] or [N/m]), from the origin
    AfterCurve after = AfterCurve::Last;
    OnFailure onFailure = OnFailure::None;

    bool operator==(const Anchor&) const = default;
};

/// Face plate between the head node and the rock. Null strength: unlimited.
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

/// A type of bolt with every `like` already followed.
struct BoltType {
    std::string name;
    bool builtIn = false;  // from the library: not written with the scene
    std::string like;  // the type it was derived from; empty: none
    BoltClass boltClass = BoltClass::CMC;
    std::string source;
    double diameter = 0.02;  // [m]
    std::optional<double> area;  // [m²]; null: the full circle
    std::optional<double> secondMoment;  // [m⁴]; null: from diameter and area
    std::optional<double> plasticModulus;  // [m³]; null: from diameter and area
    double density = 7850.0;  // [kg/m³]
    double shearModulus = 80e9;  // [Pa]
    double shearCoefficient = 4.0 / 3.0;
    std::optional<double> youngsModulus;  // [Pa]; null: from the first piece of `steel`
    Table steel;  // (strain, stress [Pa]) from the origin; empty: linear and unbreakable
    std::optional<double> tensileStrength;  // [Pa]; null: the largest stress of `steel`
    double shearStrengthRatio = 0.6;  // of the tensile strength
    RuptureRule ruptureRule = RuptureRule::Independent;
    Bending bending = Bending::ElasticPlastic;
    std::optional<double> normalStiffness;  // [N/m] per node, or [N/m per m]; null: chosen, per length
    Per normalPer = Per::Node;
    std::vector<Anchor> anchors;
    Plate plate;
    double dynamicFactor = 1.0;  // dynamic over static strength of the bond
    double steelDynamicFactor = 1.0;  // and of the steel, in tension, shear and bending
    double plateDynamicFactor = 1.0;  // and of the plate
    std::map<std::string, std::string> sources;  // field name → where its number comes from

    bool operator==(const BoltType&) const = default;
};

enum class PlateKind { None, Spring, Block };

struct Bolt {
    std::string name;
    std::string type;
    Point farEnd{0.0, 0.0};  // [m]
    Point head{0.0, 0.0};  // [m]
    std::optional<int> divisions;  // null: chosen by the program
    PlateKind plate = PlateKind::Spring;
    std::optional<double> spacingOutOfPlane;  // [m]; null: the thickness
    double pretension = 0.0;  // [N] that the plate pulls the head to when the bolt is installed
    std::optional<std::vector<Anchor>> anchors;  // null: those of the type
    std::optional<double> dynamicFactor, steelDynamicFactor, plateDynamicFactor;  // null: those of the type
    int pattern = -1;  // the scene's pattern that `cutScene` made it from; no file says it

    bool operator==(const Bolt&) const = default;
};

/// Bolts at equal lengths along the wall of a tunnel, as geometry/bolt_pattern.h lays them out: P.1, P.2, …
struct ScenePattern {
    std::string name;
    std::string type;
    std::string tunnel;
    Point from{0.0, 0.0}, to{0.0, 0.0};  // nearest places of the wall [m]
    Way way = Way::CounterClockwise;
    double spacing = 0.0;  // along the wall [m]
    double offset = 0.0;  // [m]
    double length = 0.0;  // of a bolt [m]
    double angleFromWall = 90.0;  // [°]
    std::optional<int> divisions;  // null: chosen by the program
    PlateKind plate = PlateKind::Spring;
    std::optional<double> spacingOutOfPlane;  // [m]; null: the thickness
    double pretension = 0.0;  // [N]

    bool operator==(const ScenePattern&) const = default;
};

/// Displacement of a point, opening between two points, or a quantity of a bolt.
struct Monitor {
    std::string name;
    std::optional<Point> point;  // → two values: ux, uy [m]
    std::optional<std::array<Point, 2>> between;  // → second minus first on `axis` [m]
    Point axis{1.0, 0.0};
    std::optional<std::string> bolt;  // → one value
    BoltQuantity quantity = BoltQuantity::AxialForce;
    std::optional<double> at;  // [m] from the far end
    std::optional<double> atFromHead;  // [m]
    std::optional<double> atFraction;  // 0 … 1 from the far end

    bool operator==(const Monitor&) const = default;
};

struct Output {
    std::optional<int> frames;  // over the whole run; null: at most `defaultFrames`
    std::optional<double> every;  // [s] of dynamic time or pseudo-time; overrides `frames`

    bool operator==(const Output&) const = default;
};

/// Frames over the whole run at most, where a scene does not give a number.
inline constexpr int defaultFrames = 200;

/// Where a run ends even if its stages do not.
struct RunLimits {
    std::optional<double> wallTime;  // [s] by the clock on the wall
    std::optional<int> steps;  // accepted ones, over all stages
    std::optional<int> iterations;  // pseudo-steps without an event or an accepted increment; null: 20,000
    double energy = 0.05;  // that a dynamic stage leaves over, of the largest term of the energy balance

    bool operator==(const RunLimits&) const = default;
};

/// What a factor of safety divides: the strength of joints, of the anchors of bolts, or of both.
enum class Reduce { Joints, Bonds, Both };

/// What bolts do while strengths are divided: they are modelled as in a run, or their forces at a factor of 1 act as
/// dead loads in their place.
enum class BoltForces { Mobilised, Frozen };

/// How a factor of safety is looked for; no ordinary run reads it.
struct Safety {
    Reduce reduce = Reduce::Joints;
    double tolerance = 0.01;  // of the factor
    BoltForces boltForces = BoltForces::Mobilised;

    bool operator==(const Safety&) const = default;
};

struct Expected {
    std::string quantity;  // as in `quantities`
    double value = 0.0;  // SI
    double tolerance = 0.01;  // relative; absolute where `value` is 0
    std::string source;  // where the number comes from, for people

    bool operator==(const Expected&) const = default;
};

struct About {
    std::string shows;
    std::string source;
    std::string category;
    std::vector<Expected> expected;

    bool operator==(const About&) const = default;
};

/// A whole scene. Maps and lists keep the file's order where order matters.
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
    std::vector<BoltType> boltTypes;  // the scene's own and the built-in ones that its bolts use; `like` followed
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

/// Friction and strength between blocks whose scene names no joint material at all.
inline const JointMaterial builtInJointMaterial{};

}  // namespace keyblock
