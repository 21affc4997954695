// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One table for each struct of a checkpoint that contains indices, counts or lists,
// with a row for each of them. A struct whose table lacks one does not compile. Rows
// of a struct are checked before the structs inside it, so that a row may use what the
// rows of its owner have checked. All other numbers only have to be finite.
#include "solver/run/checkpoint_check.h"

#include "solver/run/members.h"

#include <boost/container/flat_set.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>

namespace keyblock {
namespace {

struct Facts {
    const Model& model;
    const Scene& scene;
    const Checkpoint& whole;
};

/// A member of a struct, its name, and a function of facts and owner that is true if its value is usable.
template <typename Owner, typename Member, typename Holds>
struct Row {
    std::string_view name;
    Member Owner::*member;
    Holds holds;
};

template <typename Owner, typename Member, typename Holds>
constexpr auto row(std::string_view name, Member Owner::*member, Holds holds) {
    return Row<Owner, Member, Holds>{name, member, holds};
}

/// An index from `first` up to, but not including, `end(facts, owner)`.
template <typename Owner, typename Member, typename End>
constexpr auto index(std::string_view name, Member Owner::*member, long first, End end) {
    return row(name, member, [=](const Facts& facts, const Owner& owner) {
        return owner.*member >= first && owner.*member < static_cast<long>(end(facts, owner));
    });
}

/// A number of steps, iterations or results, far below the largest number, so that counting on does not overflow.
template <typename Owner, typename Member>
constexpr auto count(std::string_view name, Member Owner::*member, long least = 0) {
    constexpr long most = 1L << (sizeof(Member) < sizeof(long) ? 30 : 60);
    return row(name, member, [=](const Facts&, const Owner& owner) {
        return static_cast<long>(owner.*member) >= least && static_cast<long>(owner.*member) <= most;
    });
}

/// A list of `size(facts, owner)` values.
template <typename Owner, typename Member, typename Size>
constexpr auto length(std::string_view name, Member Owner::*member, Size size) {
    return row(name, member, [=](const Facts& facts, const Owner& owner) {
        return (owner.*member).size() == static_cast<std::size_t>(size(facts, owner));
    });
}

/// The same, or an empty list.
template <typename Owner, typename Member, typename Size>
constexpr auto lengthOrNone(std::string_view name, Member Owner::*member, Size size) {
    return row(name, member, [=](const Facts& facts, const Owner& owner) {
        return (owner.*member).empty() || (owner.*member).size() == static_cast<std::size_t>(size(facts, owner));
    });
}

/// A list of any length whose values satisfy `holds(facts, owner, value)`.
template <typename Owner, typename Member, typename Holds>
constexpr auto each(std::string_view name, Member Owner::*member, Holds holds) {
    return row(name, member, [=](const Facts& facts, const Owner& owner) {
        return std::all_of((owner.*member).begin(), (owner.*member).end(),
                           [&](const auto& value) { return holds(facts, owner, value); });
    });
}

/// A number of steps in `SweepsFirst`.
constexpr auto steps(std::string_view name, int SweepsFirst::*member) {
    return row(name, member, [=](const Facts&, const SweepsFirst& first) {
        return first.*member >= 0 && first.*member <= SweepsFirst::most;
    });
}

/// A list that is checked with the struct that owns it, or whose length does not matter.
template <typename Owner, typename Member>
constexpr auto list(std::string_view name, Member Owner::*member) {
    return row(name, member, [](const Facts&, const Owner&) { return true; });
}

bool isBelow(long value, std::size_t end) { return value >= 0 && value < static_cast<long>(end); }

constexpr auto blocks = [](const Facts& f, const auto&) { return f.model.blocks.size(); };
constexpr auto bolts = [](const Facts& f, const auto&) { return f.model.bolts.size(); };
constexpr auto stages = [](const Facts& f, const auto&) { return f.scene.stages.size(); };
constexpr auto openings = [](const Facts& f, const auto&) { return f.model.openings; };
constexpr auto unknowns = [](const Facts& f, const auto&) { return 6 * f.model.blocks.size() + 3 * f.model.nodes; };
constexpr auto anyIndex = [](const Facts&, const auto&) { return 1L << 30; };
constexpr auto isBlock = [](const Facts& f, const auto&, int block) { return isBelow(block, f.model.blocks.size()); };
constexpr auto arePairs = [](const Facts& f, const auto&, const std::pair<int, int>& pair) {
    return isBelow(pair.first, f.model.blocks.size()) && isBelow(pair.second, f.model.blocks.size());
};
constexpr auto isFlag = [](char flag) { return flag == 0 || flag == 1; };

/// True if the outline of the block turns at this corner; edges between such corners begin there.
bool turnsAt(const Model& model, int block, int corner) {
    return isBelow(block, model.blocks.size()) &&
           std::binary_search(model.blocks[block].turns.begin(), model.blocks[block].turns.end(), corner);
}

bool isEdgeOf(const Model& model, int block, int edge) {
    return isBelow(block, model.blocks.size()) && isBelow(edge, model.blocks[block].shape.size());
}

bool areBlocksOf(const Model& model, const std::vector<BlockMotion>& motions) {
    return std::ranges::equal(motions, model.blocks, [](const BlockMotion& motion, const BlockModel& block) {
        return motion.corners.size() == block.shape.size();
    });
}

bool areBoltsOf(const Model& model, const std::vector<BoltMotion>& motions) {
    return std::ranges::equal(motions, model.bolts, [](const BoltMotion& motion, const BoltModel& bolt) {
        return motion.nodes.size() == bolt.s.size() && motion.elements.size() == bolt.elements.size() &&
               motion.slots.size() >= bolt.slots.size() && motion.leftSlot.size() == motion.slots.size();
    });
}

double durationOf(const Stage& stage) { return stage.kind == StageKind::Static ? 1.0 : stage.duration; }

/// Rows of a struct; none for structs that contain no index, count or list.
template <typename T>
inline constexpr auto rows = std::tuple<>{};

template <>
inline constexpr auto rows<BlockRest> = std::tuple{count("quietSteps", &BlockRest::quietSteps)};

template <>
inline constexpr auto rows<BlockMotion> = std::tuple{list("corners", &BlockMotion::corners)};

template <>
inline constexpr auto rows<BondedFace> = std::tuple{index("toward", &BondedFace::toward, -1, anyIndex),
                                                    list("other", &BondedFace::other)};

template <>
inline constexpr auto rows<Contact> = std::tuple{
    index("blockA", &Contact::blockA, 0, blocks),
    row("corner", &Contact::corner,
        [](const Facts& f, const Contact& c) { return turnsAt(f.model, c.blockA, c.corner); }),
    row("blockB", &Contact::blockB,
        [](const Facts& f, const Contact& c) {
            return isBelow(c.blockB, f.model.blocks.size()) && c.blockB != c.blockA;
        }),
    row("edge", &Contact::edge, [](const Facts& f, const Contact& c) { return turnsAt(f.model, c.blockB, c.edge); }),
    index("joint", &Contact::joint, 0, [](const Facts& f, const Contact&) { return f.model.joints.size(); }),
    index("opening", &Contact::opening, -1, openings),
    row("face", &Contact::face, [](const Facts& f, const Contact& c) {
        const std::array<int, 4>& other = c.face.other;
        return c.face.toward < 0 || (isEdgeOf(f.model, c.blockA, c.face.toward) &&
                                     turnsAt(f.model, other[0], other[1]) && turnsAt(f.model, other[2], other[3]));
    })};

template <>
inline constexpr auto rows<BackboneState> = std::tuple{
    row("accumulated", &BackboneState::accumulated,
        [](const Facts&, const BackboneState& s) { return s.accumulated >= 0.0; })};

template <>
inline constexpr auto rows<BoltNode> = std::tuple{index("slot", &BoltNode::slot, -1, anyIndex)};

template <>
inline constexpr auto rows<Slot> = std::tuple{index("block", &Slot::block, 0, blocks)};

template <>
inline constexpr auto rows<BoltMotion> = std::tuple{
    each("nodes", &BoltMotion::nodes,
         [](const Facts&, const BoltMotion& bolt, const BoltNode& node) {
             return node.slot == -1 || isBelow(node.slot, bolt.slots.size());
         }),
    list("elements", &BoltMotion::elements), list("slots", &BoltMotion::slots),
    each("leftSlot", &BoltMotion::leftSlot, [](const Facts&, const BoltMotion&, char left) { return isFlag(left); })};

template <>
inline constexpr auto rows<State> = std::tuple{
    row("blocks", &State::blocks, [](const Facts& f, const State& s) { return areBlocksOf(f.model, s.blocks); }),
    list("contacts", &State::contacts),
    lengthOrNone("supports", &State::supports, [](const Facts& f, const State&) { return f.model.supports.size(); }),
    length("glue", &State::glue, [](const Facts& f, const State&) { return f.model.glue.size(); }),
    row("bolts", &State::bolts, [](const Facts& f, const State& s) { return areBoltsOf(f.model, s.bolts); }),
    lengthOrNone("openings", &State::openings, openings),
    lengthOrNone("acceleration", &State::acceleration, unknowns),
    count("step", &State::step)};

template <>
inline constexpr auto rows<Limit> = std::tuple{index("owner", &Limit::owner, -1, anyIndex),
                                               index("part", &Limit::part, -1, anyIndex)};

template <>
inline constexpr auto rows<PassedLimit> = std::tuple{count("cause", &PassedLimit::cause, -1)};

template <>
inline constexpr auto rows<LoadResponse> = std::tuple{lengthOrNone("moved", &LoadResponse::moved, unknowns)};

template <>
inline constexpr auto rows<IncrementProgress> = std::tuple{
    count("solves", &IncrementProgress::solves), lengthOrNone("fallsFrom", &IncrementProgress::fallsFrom, blocks),
    list("passed", &IncrementProgress::passed), count("lastRelease", &IncrementProgress::lastRelease, -1)};

template <>
inline constexpr auto rows<SweepsFirst> = std::tuple{
    steps("left", &SweepsFirst::left), steps("after", &SweepsFirst::after), steps("pause", &SweepsFirst::pause),
    steps("nextPause", &SweepsFirst::nextPause)};

template <>
inline constexpr auto rows<DynamicPace> = std::tuple{count("afterCut", &DynamicPace::afterCut),
                                                     count("equalSteps", &DynamicPace::equalSteps)};

template <>
inline constexpr auto rows<PointForce> = std::tuple{index("block", &PointForce::block, 0, blocks)};

template <>
inline constexpr auto rows<EdgePressure> = std::tuple{
    index("block", &EdgePressure::block, 0, blocks),
    row("edge", &EdgePressure::edge,
        [](const Facts& f, const EdgePressure& p) { return isEdgeOf(f.model, p.block, p.edge); })};

template <>
inline constexpr auto rows<PrescribedMotion> = std::tuple{index("block", &PrescribedMotion::block, 0, blocks)};

template <>
inline constexpr auto rows<WallForce> = std::tuple{
    index("block", &WallForce::block, -1, blocks), index("bolt", &WallForce::bolt, -1, bolts),
    row("node", &WallForce::node, [](const Facts& f, const WallForce& wall) {
        return wall.block >= 0 ||
               (isBelow(wall.bolt, f.model.bolts.size()) && isBelow(wall.node, f.model.bolts[wall.bolt].s.size()));
    })};

template <>
inline constexpr auto rows<Dashpot> = std::tuple{index("block", &Dashpot::block, 0, blocks)};

template <>
inline constexpr auto rows<Loads> = std::tuple{list("forces", &Loads::forces), list("pressures", &Loads::pressures),
                                               list("motions", &Loads::motions), list("walls", &Loads::walls),
                                               list("dashpots", &Loads::dashpots)};

template <>
inline constexpr auto rows<LoadPoint> = std::tuple{
    list("forces", &LoadPoint::forces), list("pressures", &LoadPoint::pressures), list("motions", &LoadPoint::motions),
    list("walls", &LoadPoint::walls), lengthOrNone("openings", &LoadPoint::openings, openings)};

template <>
inline constexpr auto rows<LoadSource> = std::tuple{index("stage", &LoadSource::stage, 0, stages),
                                                    count("row", &LoadSource::row)};

/// Loads that the sources name, with a value at the start of the stage for each.
bool haveSources(const Facts& f, const std::vector<LoadSource>& sources, std::size_t rowsOfLoads, std::size_t values,
                 bool ofMotions) {
    return sources.size() == rowsOfLoads && values == rowsOfLoads &&
           std::all_of(sources.begin(), sources.end(), [&](const LoadSource& source) {
               if (!isBelow(source.stage, f.scene.stages.size())) return false;
               const Stage& stage = f.scene.stages[source.stage];
               return isBelow(source.row, ofMotions ? stage.motions.size() : stage.loads.size());
           });
}

template <>
inline constexpr auto rows<LoadMemory> = std::tuple{
    row("stage", &LoadMemory::stage,
        [](const Facts& f, const LoadMemory& m) {
            return f.whole.begun ? m.stage == f.whole.stage : m.stage >= -1 && m.stage < f.whole.stage;
        }),
    row("start", &LoadMemory::start,
        [](const Facts& f, const LoadMemory& m) {
            const bool dilates = f.whole.begun && !f.scene.stages[m.stage].dilations.empty();
            return !dilates || static_cast<int>(m.start.openings.size()) == f.model.openings;
        }),
    row("forceSources", &LoadMemory::forceSources,
        [](const Facts& f, const LoadMemory& m) {
            return haveSources(f, m.forceSources, m.loads.forces.size(), m.start.forces.size(), false);
        }),
    row("pressureSources", &LoadMemory::pressureSources,
        [](const Facts& f, const LoadMemory& m) {
            return haveSources(f, m.pressureSources, m.loads.pressures.size(), m.start.pressures.size(), false);
        }),
    row("motionSources", &LoadMemory::motionSources,
        [](const Facts& f, const LoadMemory& m) {
            return haveSources(f, m.motionSources, m.loads.motions.size(), m.start.motions.size(), true);
        }),
    row("wallStages", &LoadMemory::wallStages,
        [](const Facts& f, const LoadMemory& m) {
            const long end = static_cast<long>(f.scene.stages.size());
            return m.wallStages.size() == m.loads.walls.size() && m.start.walls.size() == m.loads.walls.size() &&
                   std::ranges::all_of(m.wallStages, [&](int stage) { return stage >= -1 && stage < end; });
        }),
    lengthOrNone("zero", &LoadMemory::zero, blocks)};

template <>
inline constexpr auto rows<Reference> = std::tuple{
    length("centroids", &Reference::centroids, blocks), length("angles", &Reference::angles, blocks),
    length("monitorPoints", &Reference::monitorPoints,
           [](const Facts& f, const Reference&) { return 2 * f.scene.monitors.size(); })};

template <>
inline constexpr auto rows<WatchMemory> = std::tuple{
    row("closed", &WatchMemory::closed,
        [](const Facts& f, const WatchMemory& m) {
            const auto fits = [&](const ClosedJoint& joint) {
                return arePairs(f, m, joint.blocks) && arePairs(f, m, joint.bodies);
            };
            const auto after = [](const ClosedJoint& a, const ClosedJoint& b) { return !(a.blocks < b.blocks); };
            return std::ranges::all_of(m.closed, fits) && std::ranges::adjacent_find(m.closed, after) == m.closed.end();
        }),
    each("slipped", &WatchMemory::slipped, arePairs), each("opened", &WatchMemory::opened, arePairs),
    row("inhabited", &WatchMemory::inhabited, [](const Facts& f, const WatchMemory& m) {
        return m.inhabited.size() == f.model.bolts.size() &&
               std::ranges::all_of(m.inhabited, [](const auto& slots) { return std::ranges::all_of(slots, isFlag); });
    })};

template <>
inline constexpr auto rows<BlockPositions> = std::tuple{lengthOrNone("centroids", &BlockPositions::centroids, blocks)};

template <>
inline constexpr auto rows<StageStart> = std::tuple{row("blocks", &StageStart::blocks,
                                                        [](const Facts& f, const StageStart& start) {
                                                            return (start.blocks.empty() && !f.whole.begun) ||
                                                                   areBlocksOf(f.model, start.blocks);
                                                        }),
                                                    each("joined", &StageStart::joined, arePairs)};

template <>
inline constexpr auto rows<StepWork> = std::tuple{count("factorizations", &StepWork::factorizations),
                                                  count("fullFactorizations", &StepWork::fullFactorizations),
                                                  count("ranks", &StepWork::ranks),
                                                  count("solves", &StepWork::solves),
                                                  count("products", &StepWork::products),
                                                  count("sweeps", &StepWork::sweeps)};

template <>
inline constexpr auto rows<WorstBalance> = std::tuple{index("block", &WorstBalance::block, -1, blocks)};

template <>
inline constexpr auto rows<Health> = std::tuple{
    count("steps", &Health::steps),           count("passes", &Health::passes), count("stepCuts", &Health::stepCuts),
    count("energyCuts", &Health::energyCuts), count("awake", &Health::awake),   count("movable", &Health::movable)};

template <>
inline constexpr auto rows<FrameClock> = std::tuple{count("keptStep", &FrameClock::keptStep, -1),
                                                    index("keptStage", &FrameClock::keptStage, -1, stages)};

template <>
inline constexpr auto rows<KeptAt> = std::tuple{index("stage", &KeptAt::stage, -1, stages)};

template <>
inline constexpr auto rows<EventFrames> = std::tuple{length("shown", &EventFrames::shown, bolts),
                                                     count("kept", &EventFrames::kept)};

template <>
inline constexpr auto rows<Written> = std::tuple{
    count("events", &Written::events), count("historyRows", &Written::historyRows), count("frames", &Written::frames)};

template <>
inline constexpr auto rows<BoltPeak> = std::tuple{index("stage", &BoltPeak::stage, -1, stages)};

template <>
inline constexpr auto rows<BlockPeak> = std::tuple{index("stage", &BlockPeak::stage, -1, stages)};

template <>
inline constexpr auto rows<UnstableBlock> = std::tuple{index("block", &UnstableBlock::block, -1, blocks)};

template <>
inline constexpr auto rows<StageResult> = std::tuple{
    index("stage", &StageResult::stage, 0, stages), count("steps", &StageResult::steps),
    each("blocks", &StageResult::blocks, isBlock), list("unstable", &StageResult::unstable),
    each("loose", &StageResult::loose, isBlock)};

template <>
inline constexpr auto rows<Checkpoint> = std::tuple{
    index("stage", &Checkpoint::stage, 0, stages),
    row("time", &Checkpoint::time,
        [](const Facts& f, const Checkpoint& c) {
            return !c.begun || (c.time >= 0.0 && c.time < durationOf(f.scene.stages[c.stage]));
        }),
    count("increment", &Checkpoint::increment),
    row("firstStep", &Checkpoint::firstStep,
        [](const Facts&, const Checkpoint& c) { return c.firstStep >= 0 && c.firstStep <= c.state.step; }),
    count("passes", &Checkpoint::passes, -(1L << 60)),
    row("resultsKept", &Checkpoint::resultsKept,
        [](const Facts&, const Checkpoint& c) { return c.resultsKept <= c.results.size(); }),
    length("extremes", &Checkpoint::extremes, bolts),
    length("blockExtremes", &Checkpoint::blockExtremes, blocks),
    row("results", &Checkpoint::results,
        [](const Facts&, const Checkpoint& c) { return static_cast<long>(c.results.size()) <= c.stage; })};

// Whether a member of this type has to have a row.
template <typename T>
inline constexpr bool isCounted = std::is_integral_v<T> && !std::is_same_v<T, bool>;
template <typename... T>
inline constexpr bool isCounted<std::vector<T...>> = true;
template <typename... T>
inline constexpr bool isCounted<boost::container::flat_set<T...>> = true;
template <typename T, std::size_t n>
inline constexpr bool isCounted<std::array<T, n>> = std::is_integral_v<T>;

template <typename... Member>
constexpr int countedIn(const std::tuple<Member...>*) {
    return (0 + ... + (isCounted<std::remove_cvref_t<Member>> ? 1 : 0));
}

template <typename... Owner, typename... Member, typename... Holds>
constexpr int countedIn(const std::tuple<Row<Owner, Member, Holds>...>*) {
    return (0 + ... + (isCounted<Member> ? 1 : 0));
}

template <typename T>
inline constexpr bool isComplete =
    countedIn(static_cast<const decltype(membersOf(std::declval<const T&>()))*>(nullptr)) == countedIn(&rows<T>);

/// Walks through all values of a checkpoint. A function returns false at the first value that does not fit.
class Check {
public:
    explicit Check(const Facts& facts) : facts_(facts) {}

    bool fits(const PlainNumber auto& number) {
        using Number = std::remove_cvref_t<decltype(number)>;
        if constexpr (std::is_floating_point_v<Number>) return isFinite(std::isfinite(number));
        else return true;  // an index has its row, and the reader accepts only known flags and enumerators
    }
    bool fits(const FixedMatrix auto& matrix) { return isFinite(matrix.allFinite()); }
    bool fits(const std::string&) { return true; }
    template <typename T>
    bool fits(const std::vector<T>& values) {
        return allFit(values);
    }
    template <typename T>
    bool fits(const boost::container::flat_set<T>& values) {
        return allFit(values);
    }
    template <typename T, std::size_t n>
    bool fits(const std::array<T, n>& values) {
        return allFit(values);
    }
    template <typename A, typename B>
    bool fits(const std::pair<A, B>& pair) {
        return fits(pair.first) && fits(pair.second);
    }
    template <typename T>
    bool fits(const std::optional<T>& value) {
        return !value || fits(*value);
    }
    template <typename T>
    requires std::is_aggregate_v<T>
    bool fits(const T& value) {
        static_assert(isComplete<T>, "every index, count and list needs its row in the table of its struct");
        const auto holds = [&](const auto& one) {
            if (!one.holds(facts_, value)) misfit_ = one.name;
            return misfit_.empty();
        };
        return std::apply([&](const auto&... one) { return (holds(one) && ...); }, rows<T>) &&
               std::apply([&](const auto&... member) { return (fits(member) && ...); }, membersOf(value));
    }

    const std::string& misfit() const { return misfit_; }

private:
    bool allFit(const auto& values) {
        return std::all_of(values.begin(), values.end(), [this](const auto& value) { return fits(value); });
    }
    bool isFinite(bool finite) {
        if (!finite) misfit_ = "number that is not finite";
        return finite;
    }

    const Facts& facts_;
    std::string misfit_;
};

}  // namespace

std::optional<std::string> misfitOf(const Checkpoint& checkpoint, const Model& model, const Scene& scene) {
    const Facts facts{model, scene, checkpoint};
    Check check(facts);
    if (check.fits(checkpoint)) return {};
    return check.misfit();
}

}  // namespace keyblock
