// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts a scene with a domain into one that contains only blocks. Joint sets,
// tunnels, Voronoi cells and bolt patterns are converted into blocks and bolts of the
// same kind as those that a scene lists one by one, so that all later code treats them
// alike. It is done once before a scene is checked, run or its results are read.
#pragma once

#include "geometry/cut/cut.h"
#include "solver/scene/scene.h"

#include <atomic>
#include <string>
#include <vector>

namespace keyblock {

/// Result of cutting a scene.
struct SceneCut {
    /// The scene after the cut. The cut blocks are appended to the scene's own blocks, and the bolts of patterns to its
    /// own bolts. The domain, joints, joint sets and Voronoi cells are removed. Tunnels and patterns remain, since
    /// blocks and bolts refer to them. Cut blocks are in the order of `Cut::blocks` and have no names, so that
    /// `displayName` gives `b` followed by their number among all blocks.
    Scene scene;
    int blocks = 0;  // number of blocks from the cut, without those in open tunnels
    int vertices = 0;  // number of distinct vertices of these blocks
    int edges = 0;  // number of edges of these blocks; an edge between two blocks counts twice
    double area = 0.0;  // total area of these blocks [m²]
    int open = 0;  // number of blocks omitted in tunnels that are open from the start
    int split = 0;  // number of cuts through intact rock that divide blocks around an opening
    double tolerance = 0.0, minArea = 0.0, minWidth = 0.0;  // limits used in the cut [m], [m²], [m]
    std::vector<CutNote> notes;  // sorted by kind, place, source, other, measure
    std::vector<std::string> sources;  // names of the sources in `notes`, by index
};

/// True if the scene has a domain, or bolt patterns that have not been laid out.
bool needsCut(const Scene& scene);

/// Cuts the domain and lays out the bolt patterns; a scene that needs neither is returned unchanged. The result does
/// not depend on the order of joints, joint sets and tunnels, except where their traces coincide: there, the trace that
/// comes first in `tracesOf` determines the joint material of the face.
/// \param stop if this becomes true, the cut ends early and its result must not be used; null: the cut is not stopped
/// \pre the scene has been checked and has no errors.
SceneCut cutScene(const Scene& scene, const std::atomic<bool>* stop = nullptr);

/// Name of a kind of note, e.g. `trimmed end`.
std::string_view wordOf(CutNoteKind kind);

/// Text of the note on one line, without its position in the section.
std::string noteText(const SceneCut& cut, const CutNote& note);

}  // namespace keyblock
