// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scenes are small on purpose: these tests are about the program around them.
#include "tests/cli/command_line_fixture.h"

#include "solver/files/read_error.h"
#include "solver/files/run_store/run_store.h"
#include "tests/wait_for.h"

#include <sstream>

namespace keyblock::test {

namespace {

constexpr const char* pullScene = R"({
  "format": "keyblock-scene", "version": 1, "title": "A joint opens across a bolt",
  "about": { "expected": [ { "quantity": "max dilation", "value": 0.002, "tolerance": 0.01 },
                           { "quantity": "max dilation", "value": 0.004, "tolerance": 0.01 } ] },
  "analysis": { "plane": "stress", "thickness": 1.0, "gravity": [0, 0] },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 60e9, "poissons_ratio": 0.17 } },
  "joint_materials": { "smooth": { "friction_angle": 0, "cohesion": 0, "tensile_strength": 0 } },
  "blocks": [
    { "name": "left",  "points": [[0,0],[1,0],[1,1],[0,1]], "material": "rock", "joint_material": "smooth" },
    { "name": "right", "points": [[1,0],[2,0],[2,1],[1,1]], "material": "rock", "joint_material": "smooth" } ],
  "supports": [ { "block_at": [0.5,0.1], "fix": "all" } ],
  "bolts": [ { "name": "B", "type": "rebar-20-paper", "far_end": [0.75,0.5], "head": [1.25,0.5], "divisions": 15,
               "plate": "none" } ],
  "stages": [ { "name": "pull", "kind": "static", "increments": 10,
                "motions": [ { "block_at": [1.5,0.1], "axis": "x", "table": [[0,0],[1,0.002]] } ] } ],
  "monitors": [ { "name": "dilation", "between": [[0.999,0.2],[1.001,0.2]], "axis": "x" },
                { "name": "joint force", "bolt": "B", "quantity": "axial_force", "at": 0.25 } ],
  "quantities": [ "max joint force", "first debonding joint force" ],
  "output": { "frames": 10 }
}
)";

constexpr const char* endlessScene = R"({
  "format": "keyblock-scene", "version": 1,
  "analysis": { "gravity": [0, -9.81] },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 1e9, "poissons_ratio": 0.2 } },
  "joint_materials": { "joint": { "friction_angle": 30, "cohesion": 0, "tensile_strength": 0 } },
  "blocks": [
    { "name": "floor", "points": [[0,0],[3,0],[3,1],[0,1]], "material": "rock" },
    { "name": "stone", "points": [[1,1],[2,1],[2,2],[1,2]], "material": "rock" } ],
  "supports": [ { "block_at": [0.5,0.5], "fix": "all" } ],
  "stages": [ { "name": "rest", "kind": "dynamic", "duration": 10000, "time_step": 0.001 } ],
  "monitors": [ { "name": "top", "point": [1.5,2] } ],
  "output": { "every": 0.01 }
}
)";

}  // namespace

void CommandLine::putPullScene() const { put("pull.json", pullScene); }

void CommandLine::putEndlessScene() const { put("rest.json", endlessScene); }

bool CommandLine::waitForFrames(const std::string& run, std::size_t frames) const {
    return waitFor([&] {
        try {
            return exists(run) && RunStore(folder() / run).frames().size() > frames;
        } catch (const CannotRead&) {  // it is being created
            return false;
        }
    });
}

std::vector<std::string> CommandLine::lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        result.push_back(line);
    return result;
}

std::string CommandLine::table(const std::string& run, const std::string& name,
                               const std::vector<std::string>& more) const {
    std::vector<std::string> words{"export", run, "--table", name, "--out", "table.csv"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = keyblock(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return content("table.csv");
}

}  // namespace keyblock::test
