// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the screen shows of a run, so that an export begins with the same.
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
    std::shared_ptr<const RunSource> run;  // null: there is none
    std::filesystem::path store;
    std::optional<std::size_t> frame;  // null: the last
    std::string quantity;  // of blocks or over them, as figures name it; empty: their own choice
    int bolt = -1;  // row of the scene's bolts; −1: none in particular
    double factor = 1.0;  // on displacements
    ScaleChoices scales{};  // of the colours
    std::string boltQuantity{};  // as figures name it; empty: their own choice
    std::optional<Box> view{};  // of the section on the screen [m]
};

}  // namespace keyblock
