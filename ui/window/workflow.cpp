// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/workflow.h"

#include <string_view>

namespace keyblock {

namespace {

struct Row {
    std::string_view key;
    WorkStep step;
};

// Pointers not listed here belong to the geometry.
constexpr std::array stepRows{
    Row{"materials", WorkStep::Materials},     Row{"joint_materials", WorkStep::Materials},
    Row{"in_situ_stress", WorkStep::Materials}, Row{"bolts", WorkStep::Support},
    Row{"bolt_types", WorkStep::Support},      Row{"bolt_patterns", WorkStep::Support},
    Row{"stages", WorkStep::Stages},           Row{"analysis", WorkStep::Stages},
    Row{"monitors", WorkStep::Stages},         Row{"quantities", WorkStep::Stages},
    Row{"output", WorkStep::Stages},           Row{"limits", WorkStep::Stages},
    Row{"safety", WorkStep::Stages},
};

WorkState& at(WorkStates& states, WorkStep step) { return states[static_cast<std::size_t>(step)]; }

WorkState doneIf(bool there) { return there ? WorkState::Done : WorkState::NotYet; }

}  // namespace

WorkStep stepOf(const std::string& pointer) {
    const std::size_t end = pointer.find('/', 1);
    const std::string_view key = pointer.empty() ? std::string_view{} : std::string_view(pointer).substr(1, end - 1);
    for (const Row& row : stepRows)
        if (row.key == key) return row.step;
    return WorkStep::Geometry;
}

WorkStates workStates(const Scene& scene, std::span<const Problem> problems) {
    WorkStates states{};
    at(states, WorkStep::Geometry) = doneIf(scene.domain || !scene.blocks.empty());
    at(states, WorkStep::Materials) = doneIf(!scene.materials.empty());
    const bool supported = !scene.bolts.empty() || !scene.boltPatterns.empty();
    at(states, WorkStep::Support) = supported ? WorkState::Done : WorkState::Nothing;  // bolts are optional
    at(states, WorkStep::Stages) = doneIf(!scene.stages.empty());
    for (const Problem& problem : problems) {
        WorkState& state = at(states, stepOf(problem.pointer));
        if (problem.severity == Severity::Error) state = WorkState::Error;
        if (problem.severity == Severity::Warning && state != WorkState::Error) state = WorkState::Warning;
    }
    return states;
}

}  // namespace keyblock
