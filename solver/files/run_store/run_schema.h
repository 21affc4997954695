// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run store's tables. Writer and reader share this list and nothing else. Each row
// of a result has a checksum over the columns of its list below, in that order; a frame
// has one for its numbers and one for its BLOBs, which are read later.
#pragma once

namespace keyblock::run_schema {

/// SQLite application id of a run store: "KBRN".
inline constexpr int applicationId = 0x4B42524E;

/// Version of the store; increases with every change that an older program would misread.
inline constexpr int version = 13;

inline constexpr const char* tables = R"(
CREATE TABLE about (key TEXT PRIMARY KEY, value TEXT NOT NULL, checksum INTEGER);
CREATE TABLE columns (payload TEXT, position INTEGER, name TEXT, unit TEXT, meaning TEXT,
    PRIMARY KEY (payload, position));
CREATE TABLE stages (stage INTEGER PRIMARY KEY, name TEXT, kind TEXT,
    outcome TEXT, time REAL, steps INTEGER, message TEXT, blocks BLOB,
    passes INTEGER, step_cuts INTEGER, energy_cuts INTEGER, factorizations INTEGER,
    full_factorizations INTEGER, ranks INTEGER, solves INTEGER, products INTEGER, sweeps INTEGER,
    max_penetration_ratio REAL, max_residual REAL, balance_error REAL, health_steps INTEGER,
    unstable BLOB, farthest BLOB, loose BLOB, worst_block INTEGER, worst_share REAL, worst_force REAL,
    awake INTEGER, movable INTEGER, events INTEGER, history_rows INTEGER, frames INTEGER, checksum INTEGER);
CREATE TABLE events (event INTEGER PRIMARY KEY, stage INTEGER, time REAL, step INTEGER, kind TEXT,
    bolt INTEGER, node INTEGER, element INTEGER, block INTEGER, other_block INTEGER, x REAL, y REAL,
    axial_force REAL, shear_force REAL, anchor_force REAL, slip REAL, history_row INTEGER, cause INTEGER,
    checksum INTEGER);
CREATE TABLE history (row INTEGER PRIMARY KEY, stage INTEGER, time REAL, step INTEGER, "values" BLOB,
    checksum INTEGER);
CREATE TABLE frames (frame INTEGER PRIMARY KEY, stage INTEGER, time REAL, step INTEGER, events INTEGER,
    kinetic REAL, strain REAL, contact REAL, bolt REAL, friction REAL, plastic REAL, released REAL, damped REAL,
    external REAL, balance_error REAL, checksum INTEGER, payload_checksum INTEGER,
    blocks BLOB, corners BLOB, contacts BLOB, nodes BLOB, bolts BLOB,
    weights BLOB, inertia BLOB, contact_forces BLOB, node_forces BLOB, other_forces BLOB,
    bolt_extremes BLOB, block_extremes BLOB);
CREATE TABLE checkpoint (key INTEGER PRIMARY KEY CHECK (key = 1), build TEXT NOT NULL, hash TEXT NOT NULL,
    state BLOB NOT NULL);
)";

inline constexpr const char* aboutColumns = "key, value";
inline constexpr const char* stageColumns =
    "stage, name, kind, outcome, time, steps, message, blocks, passes, step_cuts, energy_cuts, factorizations, "
    "full_factorizations, ranks, solves, products, sweeps, max_penetration_ratio, max_residual, balance_error, "
    "health_steps, unstable, farthest, loose, worst_block, worst_share, worst_force, awake, movable, events, "
    "history_rows, frames";
inline constexpr const char* eventColumns =
    "event, stage, time, step, kind, bolt, node, element, block, other_block, x, y, axial_force, shear_force, "
    "anchor_force, slip, history_row, cause";
inline constexpr const char* historyColumns = "row, stage, time, step, \"values\"";
inline constexpr const char* headColumns =
    "frame, stage, time, step, events, kinetic, strain, contact, bolt, friction, plastic, released, damped, external, "
    "balance_error";
inline constexpr const char* payloadColumns =
    "blocks, corners, contacts, nodes, bolts, weights, inertia, contact_forces, node_forces, other_forces, "
    "bolt_extremes, block_extremes";

/// Description of the store for authors of other programs that read it.
inline constexpr const char* layout =
    "Every BLOB holds little-endian IEEE 754 doubles, row after row. Table columns lists the values of a row by "
    "payload: blocks, corners, contacts, nodes, bolts, weights, inertia, contact_forces, node_forces, other_forces, "
    "bolt_extremes and block_extremes of a frame; history of a history row; mechanism for stages.blocks and "
    "stages.loose, unstable for stages.unstable and stages.farthest. Row n of bolts and of bolt_extremes is the "
    "scene's bolt n; row n of blocks and of block_extremes is the n-th block that is solved: the blocks of the scene, "
    "with cells in place of blocks that are cut into cells, then plates modelled as blocks. Stages, blocks, bolts, "
    "nodes, elements and rows of history count from 0; -1 marks an index that does not apply. events.history_row names "
    "the row just before an event, events.cause the number of the event, from 0, whose release triggered it. "
    "frames.events counts the events up to a frame; frames just before and just after a failure may have the same "
    "time. A stage without an outcome never ended. Table checkpoint is internal: the state from which an unfinished "
    "run can be resumed, by the same build only. SI units; times are within the stage. Row key scene of table about is "
    "the scene as JSON with its records inside, scene_hash its SHA-256. checksum guards the other columns of its row "
    "(of a frame, those without BLOBs; payload_checksum those with BLOBs): the hash XXH3 (64 bits).";

}  // namespace keyblock::run_schema
