// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions that write and read a row are next to each other and follow the order
// of its columns. A store may come from any source, so every index is checked before
// it is used.
#include "solver/files/run_store/frame_payload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 12> words{"blocks",        "corners", "contacts", "nodes",
                                                 "bolts",         "weights", "inertia",  "contact_forces",
                                                 "node_forces",   "other_forces", "bolt_extremes", "block_extremes"};

constexpr std::array<PayloadColumn, 12> blockColumns{{{"x", "m", "centroid"},
                                                      {"y", "m", "centroid"},
                                                      {"ux", "m", "displacement of the centroid"},
                                                      {"uy", "m", "displacement of the centroid"},
                                                      {"rotation", "rad", "counter-clockwise"},
                                                      {"sxx", "Pa", "stress in global axes, tension positive"},
                                                      {"syy", "Pa", "stress in global axes, tension positive"},
                                                      {"sxy", "Pa", "stress in global axes"},
                                                      {"vx", "m/s", "velocity of the centroid"},
                                                      {"vy", "m/s", "velocity of the centroid"},
                                                      {"area", "m2", ""},
                                                      {"weight", "N", ""}}};

constexpr std::array<PayloadColumn, 3> cornerColumns{{{"block", "", "index of the block, from 0"},
                                                      {"x", "m", "corner, in order round the block"},
                                                      {"y", "m", "corner, in order round the block"}}};

constexpr std::array<PayloadColumn, 12> contactColumns{
    {{"block_a", "", "index of the block with the corner"},
     {"block_b", "", "index of the block with the edge"},
     {"joint_material", "", "index into the scene's joint materials; -1: the built-in one"},
     {"x", "m", "position of the contact"},
     {"y", "m", "position of the contact"},
     {"state", "", "0 open, 1 sliding, 2 locked, 3 bonded"},
     {"normal_force", "N", "compression positive"},
     {"shear_force", "N", ""},
     {"penetration", "m", "positive when the corner is inside"},
     {"slip", "m", ""},
     {"nx", "", "unit vector in which compression pushes block a, outward from block b"},
     {"ny", "", "likewise; the force on block a is normal_force (nx, ny) + shear_force (ny, -nx), on block b the "
                "opposite"}}};

constexpr std::array<PayloadColumn, 15> nodeColumns{
    {{"bolt", "", "index of the bolt, from 0"},
     {"s", "m", "distance from the far end, unstrained"},
     {"x", "m", "position of the node"},
     {"y", "m", "position of the node"},
     {"block", "", "index of the block that contains it; -1: in a gap, on a joint or outside"},
     {"real", "", "1 bonded node (real anchor), 0 intermediate node (artificial anchor)"},
     {"state", "", "0 bonded, 1 slipping, 2 failed (gone), 3 free"},
     {"axial_force", "N", "of the element that starts here, tension positive; at the last node the plate's normal"},
     {"shear_force", "N", "of the element that starts here; at the last node the plate's shear"},
     {"moment", "N m", "at the node"},
     {"anchor_force", "N", "positive when the rock drags the bolt towards its head"},
     {"slip", "m", "displacement of the rock minus that of the bolt, along the axis"},
     {"ruptured", "", "1 when the element that starts here is broken"},
     {"bond_strength", "N", "at which the bond fails in its present embedment and clamping; 0: no bond, or no limit"},
     {"bond_residual", "N", "that remains once the bond slides; 0: none"}}};

constexpr std::array<PayloadColumn, 5> boltColumns{
    {{"plate_holds", "", "1 or 0"},
     {"lost", "", "1 when the whole bolt is lost"},
     {"elastic", "J", "stored in shank, anchors and plate, over the model's thickness"},
     {"plastic", "J", "dissipated since the start by steel, hinges and crushed rock"},
     {"bond", "J", "dissipated since the start by sliding anchors and failing bonds"}}};

constexpr std::array<PayloadColumn, 2> weightColumns{
    {{"fx", "N", "row n: block n; the part of gravity and of body and ground accelerations that acts"},
     {"fy", "N", "likewise"}}};

constexpr std::array<PayloadColumn, 3> inertiaColumns{
    {{"fx", "N", "row n: block n; -m a over the frame's step; no rows at rest"},
     {"fy", "N", "likewise"},
     {"moment", "N m", "likewise, about the centroid, counter-clockwise positive"}}};

constexpr std::array<PayloadColumn, 4> contactForceColumns{
    {{"fx", "N", "row n: contact n; force on block a over the frame's step; no rows at rest: see contacts"},
     {"fy", "N", "likewise; the opposite acts on block b"},
     {"moment_a", "N m", "on block a, about its centroid"},
     {"moment_b", "N m", "on block b, about its centroid"}}};

constexpr std::array<PayloadColumn, 2> nodeForceColumns{
    {{"fx", "N", "row n: node n; force of the anchored point on the block that contains it, at the node"},
     {"fy", "N", "likewise"}}};

constexpr std::array<PayloadColumn, 8> otherForceColumns{
    {{"block", "", "index of the block on which the force acts"},
     {"source", "", "0 weight, 1 contact, 2 bolt, 3 support, 4 load, 5 wall, 6 glue, 7 dashpot, 8 inertia"},
     {"other", "", "index of the block on the other side of a contact or of glue, or of the bolt; -1: none"},
     {"x", "m", "point at which it acts"},
     {"y", "m", "point at which it acts"},
     {"fx", "N", "on the block; glue: the opposite force and couple act on block other"},
     {"fy", "N", "likewise"},
     {"moment", "N m", "of force and couple about the block's centroid, counter-clockwise positive"}}};

constexpr std::array<PayloadColumn, 28> boltExtremeColumns{
    {{"axial_force", "N", "largest of the run so far, with its sign; tension positive"},
     {"axial_force_s", "m", "its distance from the far end"},
     {"axial_force_stage", "", "stage of that value; -1: never above zero"},
     {"axial_force_time", "s", "time of that value, within the stage"},
     {"shear_force", "N", "likewise"},
     {"shear_force_s", "m", "likewise"},
     {"shear_force_stage", "", "stage of that value; -1: never above zero"},
     {"shear_force_time", "s", "time of that value, within the stage"},
     {"moment", "N m", "likewise"},
     {"moment_s", "m", "likewise"},
     {"moment_stage", "", "stage of that value; -1: never above zero"},
     {"moment_time", "s", "time of that value, within the stage"},
     {"steel_use", "", "largest share of the steel's strength, by axial force and moment; -1: none"},
     {"steel_use_s", "m", "its distance from the far end"},
     {"steel_use_stage", "", "stage of that value; -1: never above zero"},
     {"steel_use_time", "s", "time of that value, within the stage"},
     {"shear_use", "", "largest share of the shear strength; -1: none"},
     {"shear_use_s", "m", "likewise"},
     {"shear_use_stage", "", "stage of that value; -1: never above zero"},
     {"shear_use_time", "s", "time of that value, within the stage"},
     {"bond_use", "", "largest share of a bond's strength; -1: none"},
     {"bond_use_s", "m", "likewise"},
     {"bond_use_stage", "", "stage of that value; -1: never above zero"},
     {"bond_use_time", "s", "time of that value, within the stage"},
     {"plate_use", "", "largest share of the face plate's strength; -1: none"},
     {"plate_use_s", "m", "likewise"},
     {"plate_use_stage", "", "stage of that value; -1: never above zero"},
     {"plate_use_time", "s", "time of that value, within the stage"}}};

constexpr std::array<PayloadColumn, 12> blockExtremeColumns{
    {{"displacement", "m", "largest of the run so far, since the start or the last zero_displacements"},
     {"displacement_stage", "", "stage of that value; -1: none yet"},
     {"displacement_time", "s", "time of that value, within the stage"},
     {"velocity", "m/s", "largest of the run so far"},
     {"velocity_stage", "", "likewise"},
     {"velocity_time", "s", "likewise"},
     {"sigma1", "Pa", "largest major principal stress of the run so far, compression positive"},
     {"sigma1_stage", "", "likewise"},
     {"sigma1_time", "s", "likewise"},
     {"sigma3", "Pa", "smallest minor principal stress of the run so far, compression positive"},
     {"sigma3_stage", "", "likewise"},
     {"sigma3_time", "s", "likewise"}}};

/// Reads values from a row and records whether any of them was not a valid index.
class RowReader {
public:
    explicit RowReader(std::span<const double> row) : row_(row) {}

    double number() { return row_[at_++]; }
    Point point() {
        const double x = number();
        return {x, number()};
    }
    int index(int first, std::size_t end) {
        const double value = number();
        const bool fits = value >= first && value < static_cast<double>(end) && value == std::floor(value);
        good_ = good_ && fits;
        return fits ? static_cast<int>(value) : first;
    }
    bool flag() { return index(0, 2) == 1; }
    bool good() const { return good_; }

private:
    std::span<const double> row_;
    std::size_t at_ = 0;
    bool good_ = true;
};

void packBlocks(const Frame& frame, std::vector<double>& out) {
    for (const BlockState& b : frame.blocks)
        out.insert(out.end(), {b.centroid.x(), b.centroid.y(), b.displacement.x(), b.displacement.y(), b.rotation,
                               b.stress[0], b.stress[1], b.stress[2], b.velocity.x(), b.velocity.y(), b.area,
                               b.weight});
}

bool unpackBlock(RowReader& row, const Scene&, Frame& frame) {
    BlockState b;
    b.centroid = row.point();
    b.displacement = row.point();
    b.rotation = row.number();
    for (double& component : b.stress)
        component = row.number();
    b.velocity = row.point();
    b.area = row.number();
    b.weight = row.number();
    frame.blocks.push_back(b);
    return row.good();
}

void packCorners(const Frame& frame, std::vector<double>& out) {
    for (std::size_t block = 0; block < frame.blocks.size(); ++block)
        for (const Point& corner : frame.blocks[block].points)
            out.insert(out.end(), {static_cast<double>(block), corner.x(), corner.y()});
}

bool unpackCorner(RowReader& row, const Scene&, Frame& frame) {
    const std::size_t block = row.index(0, frame.blocks.size());
    if (row.good())
        frame.blocks[block].points.push_back(row.point());
    return row.good();
}

void packContacts(const Frame& frame, std::vector<double>& out) {
    for (const ContactFrame& c : frame.contacts)
        out.insert(out.end(), {static_cast<double>(c.blockA), static_cast<double>(c.blockB),
                               static_cast<double>(c.jointMaterial), c.position.x(), c.position.y(),
                               static_cast<double>(c.state), c.normalForce, c.shearForce, c.penetration, c.slip,
                               c.normal.x(), c.normal.y()});
}

bool unpackContact(RowReader& row, const Scene& scene, Frame& frame) {
    ContactFrame c;
    c.blockA = row.index(-1, frame.blocks.size());
    c.blockB = row.index(-1, frame.blocks.size());
    c.jointMaterial = row.index(intactJoint, scene.jointMaterials.size());
    c.position = row.point();
    c.state = static_cast<ContactState>(row.index(0, 4));
    c.normalForce = row.number();
    c.shearForce = row.number();
    c.penetration = row.number();
    c.slip = row.number();
    c.normal = row.point();
    frame.contacts.push_back(c);
    return row.good();
}

void packNodes(const Frame& frame, std::vector<double>& out) {
    for (std::size_t bolt = 0; bolt < frame.bolts.size(); ++bolt)
        for (const BoltNodeFrame& n : frame.bolts[bolt].nodes)
            out.insert(out.end(), {static_cast<double>(bolt), n.s, n.position.x(), n.position.y(),
                                   static_cast<double>(n.block), n.real ? 1.0 : 0.0, static_cast<double>(n.state),
                                   n.axialForce, n.shearForce, n.moment, n.anchorForce, n.slip,
                                   n.ruptured ? 1.0 : 0.0, n.bondStrength, n.bondResidual});
}

bool unpackNode(RowReader& row, const Scene&, Frame& frame) {
    const std::size_t bolt = row.index(0, frame.bolts.size());
    BoltNodeFrame n;
    n.s = row.number();
    n.position = row.point();
    n.block = row.index(-1, frame.blocks.size());
    n.real = row.flag();
    n.state = static_cast<NodeState>(row.index(0, 4));
    n.axialForce = row.number();
    n.shearForce = row.number();
    n.moment = row.number();
    n.anchorForce = row.number();
    n.slip = row.number();
    n.ruptured = row.flag();
    n.bondStrength = row.number();
    n.bondResidual = row.number();
    if (row.good())
        frame.bolts[bolt].nodes.push_back(n);
    return row.good();
}

void packBolts(const Frame& frame, std::vector<double>& out) {
    for (const BoltFrame& bolt : frame.bolts)
        out.insert(out.end(), {bolt.plateHolds ? 1.0 : 0.0, bolt.lost ? 1.0 : 0.0, bolt.elasticEnergy,
                               bolt.plasticEnergy, bolt.bondEnergy});
}

bool unpackBolt(RowReader& row, const Scene&, Frame& frame) {
    BoltFrame bolt;
    bolt.plateHolds = row.flag();
    bolt.lost = row.flag();
    bolt.elasticEnergy = row.number();
    bolt.plasticEnergy = row.number();
    bolt.bondEnergy = row.number();
    frame.bolts.push_back(bolt);
    return row.good();
}

void packWeights(const Frame& frame, std::vector<double>& out) {
    for (const BodyForce& f : frame.forces.bodies) out.insert(out.end(), {f.weight.x(), f.weight.y()});
}

bool unpackWeight(RowReader& row, const Scene&, Frame& frame) {
    frame.forces.bodies.emplace_back().weight = row.point();
    return row.good();
}

void packInertia(const Frame& frame, std::vector<double>& out) {
    const auto rests = [](const BodyForce& f) { return f.inertia.isZero(0.0) && f.inertiaMoment == 0.0; };
    if (std::all_of(frame.forces.bodies.begin(), frame.forces.bodies.end(), rests)) return;
    for (const BodyForce& f : frame.forces.bodies)
        out.insert(out.end(), {f.inertia.x(), f.inertia.y(), f.inertiaMoment});
}

/// Reads the inertia forces of the bodies whose weights have been read.
/// \param values three per row
bool unpackInertia(std::span<const double> values, Frame& frame) {
    std::vector<BodyForce>& bodies = frame.forces.bodies;
    if (!values.empty() && values.size() != 3 * bodies.size()) return false;
    for (std::size_t at = 0; at < values.size(); at += 3) {
        bodies[at / 3].inertia = {values[at], values[at + 1]};
        bodies[at / 3].inertiaMoment = values[at + 2];
    }
    return true;
}

void packContactForces(const Frame& frame, std::vector<double>& out) {
    for (const ContactStepForce& f : frame.forces.contacts)
        out.insert(out.end(), {f.force.x(), f.force.y(), f.momentA, f.momentB});
}

bool unpackContactForce(RowReader& row, const Scene&, Frame& frame) {
    ContactStepForce f;
    f.force = row.point();
    f.momentA = row.number();
    f.momentB = row.number();
    frame.forces.contacts.push_back(f);
    return frame.forces.contacts.size() <= frame.contacts.size();
}

void packNodeForces(const Frame& frame, std::vector<double>& out) {
    for (const Point& force : frame.forces.nodes) out.insert(out.end(), {force.x(), force.y()});
}

bool unpackNodeForce(RowReader& row, const Scene&, Frame& frame) {
    frame.forces.nodes.push_back(row.point());
    return row.good();
}

void packOtherForces(const Frame& frame, std::vector<double>& out) {
    for (const BlockForce& f : frame.forces.others)
        out.insert(out.end(), {static_cast<double>(f.block), static_cast<double>(f.source),
                               static_cast<double>(f.other), f.position.x(), f.position.y(), f.force.x(), f.force.y(),
                               f.moment});
}

bool unpackOtherForce(RowReader& row, const Scene& scene, Frame& frame) {
    BlockForce f;
    f.block = row.index(0, frame.blocks.size());
    f.source = static_cast<ForceSource>(row.index(0, 9));
    f.other = row.index(f.source == ForceSource::Glue ? 0 : -1,
                        f.source == ForceSource::Bolt ? scene.bolts.size() : frame.blocks.size());
    f.position = row.point();
    f.force = row.point();
    f.moment = row.number();
    frame.forces.others.push_back(f);
    return row.good();
}

/// The peaks of a row in column order.
constexpr std::array boltPeaks{&BoltExtremes::axialForce, &BoltExtremes::shearForce, &BoltExtremes::moment,
                               &BoltExtremes::steel,      &BoltExtremes::shear,      &BoltExtremes::bond,
                               &BoltExtremes::plate};

void packBoltExtremes(const Frame& frame, std::vector<double>& out) {
    for (const BoltExtremes& bolt : frame.extremes)
        for (const auto peak : boltPeaks) {
            const BoltPeak& p = bolt.*peak;
            out.insert(out.end(), {p.value, p.at, static_cast<double>(p.stage), p.time});
        }
}

bool unpackBoltExtremes(RowReader& row, const Scene& scene, Frame& frame) {
    BoltExtremes bolt;
    for (const auto peak : boltPeaks) {
        BoltPeak& p = bolt.*peak;
        p.value = row.number();
        p.at = row.number();
        p.stage = row.index(-1, scene.stages.size());
        p.time = row.number();
    }
    frame.extremes.push_back(bolt);
    return row.good();
}

constexpr std::array blockPeaks{&BlockExtremes::displacement, &BlockExtremes::velocity, &BlockExtremes::sigma1,
                                &BlockExtremes::sigma3};

void packBlockExtremes(const Frame& frame, std::vector<double>& out) {
    for (const BlockExtremes& block : frame.blockExtremes)
        for (const auto peak : blockPeaks) {
            const BlockPeak& p = block.*peak;
            out.insert(out.end(), {p.value, static_cast<double>(p.stage), p.time});
        }
}

bool unpackBlockExtremes(RowReader& row, const Scene& scene, Frame& frame) {
    BlockExtremes block;
    for (const auto peak : blockPeaks) {
        BlockPeak& p = block.*peak;
        p.value = row.number();
        p.stage = row.index(-1, scene.stages.size());
        p.time = row.number();
    }
    frame.blockExtremes.push_back(block);
    return row.good();
}

/// True if lists that belong together have the same number of rows, or none, and blocks have the given numbers of corners,
/// or none if they have been excavated.
bool fits(Payload payload, const Scene& scene, std::span<const std::size_t> corners, const Frame& frame) {
    const std::size_t blocks = corners.size();
    switch (payload) {
        case Payload::Blocks: return frame.blocks.size() == blocks;
        case Payload::Corners:
            return std::ranges::equal(frame.blocks, corners, [](const BlockState& b, std::size_t count) {
                return b.points.size() == (b.points.empty() && b.area == 0.0 ? 0 : count);
            });
        case Payload::Bolts: return frame.bolts.size() == scene.bolts.size();
        case Payload::BoltExtremes: return frame.extremes.empty() || frame.extremes.size() == scene.bolts.size();
        case Payload::BlockExtremes: return frame.blockExtremes.empty() || frame.blockExtremes.size() == blocks;
        case Payload::Weights: return frame.forces.bodies.empty() || frame.forces.bodies.size() == blocks;
        case Payload::ContactForces:
            return frame.forces.contacts.empty() || frame.forces.contacts.size() == frame.contacts.size();
        default: return true;
    }
}

using Pack = void (*)(const Frame&, std::vector<double>&);
using UnpackRow = bool (*)(RowReader&, const Scene&, Frame&);

constexpr std::array<Pack, 12> packs{packBlocks,  packCorners, packContacts,      packNodes,      packBolts,
                                     packWeights, packInertia, packContactForces, packNodeForces, packOtherForces,
                                     packBoltExtremes, packBlockExtremes};
constexpr std::array<UnpackRow, 12> unpacks{unpackBlock,  unpackCorner, unpackContact,      unpackNode,      unpackBolt,
                                            unpackWeight, nullptr,      unpackContactForce, unpackNodeForce, unpackOtherForce,
                                            unpackBoltExtremes, unpackBlockExtremes};

}  // namespace

std::span<const std::string_view> payloadWords() { return words; }

std::span<const PayloadColumn> payloadColumns(Payload payload) {
    switch (payload) {
        case Payload::Blocks: return blockColumns;
        case Payload::Corners: return cornerColumns;
        case Payload::Contacts: return contactColumns;
        case Payload::Nodes: return nodeColumns;
        case Payload::Bolts: return boltColumns;
        case Payload::Weights: return weightColumns;
        case Payload::Inertia: return inertiaColumns;
        case Payload::ContactForces: return contactForceColumns;
        case Payload::NodeForces: return nodeForceColumns;
        case Payload::OtherForces: return otherForceColumns;
        case Payload::BoltExtremes: return boltExtremeColumns;
        case Payload::BlockExtremes: return blockExtremeColumns;
    }
    return {};
}

std::vector<double> pack(Payload payload, const Frame& frame) {
    std::vector<double> values;
    packs[static_cast<std::size_t>(payload)](frame, values);
    return values;
}

bool unpack(Payload payload, std::span<const double> values, const Scene& scene, std::span<const std::size_t> corners,
            Frame& frame) {
    const std::size_t width = payloadColumns(payload).size();
    if (values.size() % width != 0)
        return false;
    if (payload == Payload::Inertia)
        return unpackInertia(values, frame);
    for (std::size_t at = 0; at < values.size(); at += width) {
        RowReader row(values.subspan(at, width));
        if (!unpacks[static_cast<std::size_t>(payload)](row, scene, frame))
            return false;
    }
    return fits(payload, scene, corners, frame);
}

}  // namespace keyblock
