// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a scene with a domain to one with blocks alone. What the user draws by a
// few numbers (joint sets, tunnels, cells, patterns of bolts) becomes blocks and
// bolts of the same kinds as those that a scene gives one by one, so that everything
// after this treats them alike. It is done once for checking, running or reading.
#pragma once

#include "geometry/cut.h"
#include "solver/scene/scene.h"

#include <atomic>
#include <string>
#include <vector>

namespace keyblock {

/// What became of a scene.
struct SceneCut {
    /// The scene with the cut blocks after its own, and the bolts of patterns after its own; without domain, joints,
    /// joint sets and Voronoi cells. Cut blocks are in the order of geometry/cut.h and have no name of their own, so
    /// they are called b and their place among all blocks. Tunnels and patterns stay, for blocks and bolts to refer to.
    Scene scene;
    int blocks = 0;  // that were cut and are left
    int vertices = 0;  // of these, each place once
    int edges = 0;  // of these, those between two blocks twice
    double area = 0.0;  // of these [m²]
    int open = 0;  // blocks left out, in tunnels that are open from the start
    int split = 0;  // cuts through intact rock, that part blocks round an opening
    double tolerance = 0.0, minArea = 0.0, minWidth = 0.0;  // of the cut [m, m², m]
    std::vector<CutNote> notes;  // by kind, place, source, other, measure
    std::vector<std::string> sources;  // for people, by the sources in `notes`
};

/// False for a scene whose blocks and bolts are all given one by one.
bool needsCut(const Scene& scene);

/// Cuts the domain and lays out the patterns; a scene that needs neither comes back as it is. The result does not
/// depend on the order of joints, sets and tunnels but where their traces coincide: the first has the face.
/// \param stop where it becomes true, the cut ends soon and is not to be used; null: it goes to its end.
/// \pre the scene was checked without errors.
SceneCut cutScene(const Scene& scene, const std::atomic<bool>* stop = nullptr);

/// The word for a kind of note, e.g. `trimmed end`.
std::string_view wordOf(CutNoteKind kind);

/// What the note says, on one line without its place.
std::string noteText(const SceneCut& cut, const CutNote& note);

}  // namespace keyblock
