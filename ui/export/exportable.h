// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The current view of a run, from which an export starts.
#pragma once

#include "geometry/polygon.h"
#include "solver/results/run_source.h"
#include "ui/picture/scale_choice.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace keyblock {

struct Exportable {
    std::shared_ptr<const RunSource> run;  // null: no run
    std::filesystem::path store;
    std::optional<std::size_t> frame;  // none: the last frame
    std::string quantity;  // block quantity by its name in figures; empty: the default of the figure
    int bolt = -1;  // index among the bolts of the scene; −1: no particular bolt
    double factor = 1.0;  // scale factor of displacements
    ScaleChoices scales{};  // colour scales
    std::string boltQuantity{};  // bolt quantity by its name in figures; empty: the default of the figure
    std::optional<Box> view{};  // part of the section on the screen [m]
};

}  // namespace keyblock
