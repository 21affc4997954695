// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The groups of a DXF file sorted into what they describe: header, layers, blocks
// and entities, each entity with its line, so that every one can be accounted for.
#pragma once

#include "geometry/point.h"
#include "solver/files/drawing/dxf_groups.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct DxfEntity {
    std::string kind;  // LINE
    std::string layer;  // UTF-8
    std::string handle;
    int line = 0;  // where it begins
    bool paper = false;  // on a sheet, not in the model
    bool invisible = false;
    std::span<const DxfGroup> groups;  // after the one that begins it
    std::vector<DxfEntity> parts;  // vertices of a POLYLINE
};

struct DxfBlock {
    std::string name;
    Point base{0.0, 0.0};
    std::vector<DxfEntity> entities;
    int line = 0;
};

struct DxfContent {
    int units = 0;  // $INSUNITS; 0: none
    std::map<std::string, bool> hidden;  // layers by name in lower case; whether frozen or off
    std::map<std::string, DxfBlock> blocks;  // by name in lower case
    std::vector<DxfEntity> entities;
    std::string codePage;  // of names that are no UTF-8; empty: not said
    std::vector<Problem> problems;
};

/// Sorts groups, to which the result refers.
DxfContent sortDxf(const DxfGroups& groups);

/// ASCII letters in lower case: names of layers and blocks do not heed it.
std::string lowerCase(std::string_view text);

/// The first value of a code; empty where there is none.
std::string_view valueOf(const DxfEntity& entity, int code);

/// The same as a number, or `otherwise`.
double realOf(const DxfEntity& entity, int code, double otherwise);
int integerOf(const DxfEntity& entity, int code, int otherwise);

}  // namespace keyblock
