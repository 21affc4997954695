// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The current view of a run, the starting point of an export.
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
    std::shared_ptr<const RunSource> run;  // null: none
    std::filesystem::path store;
    std::optional<std::size_t> frame;  // null: the last
    std::string quantity;  // of blocks or over them, by its name in figures; empty: the default of the figure
    int bolt = -1;  // row of the scene's bolts; −1: no particular one
    double factor = 1.0;  // scale factor of displacements
    ScaleChoices scales{};  // of the colours
    std::string boltQuantity{};  // by its name in figures; empty: the default of the figure
    std::optional<Box> view{};  // of the section on the screen [m]
};

}  // namespace keyblock
