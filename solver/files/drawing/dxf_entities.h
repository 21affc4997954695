// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The groups of a DXF file sorted into header, layers, blocks and entities, each
// entity with its line number, so that every entity can be accounted for.
#pragma once

#include "geometry/point.h"
#include "solver/files/drawing/dxf_groups.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct DxfEntity {
    std::string kind;  // e.g. LINE
    std::string layer;  // UTF-8
    std::string handle;
    int line = 0;  // line on which the entity begins
    bool paper = false;  // in paper space instead of model space
    bool invisible = false;
    std::span<const DxfGroup> groups;  // after the group that begins the entity
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
    std::map<std::string, bool> hidden;  // by layer name in lower case: whether the layer is frozen or off
    std::map<std::string, DxfBlock> blocks;  // by name in lower case
    std::vector<DxfEntity> entities;
    std::string codePage;  // encoding of names that are not UTF-8; empty: not given
    std::vector<Problem> problems;
};

/// Sorts groups into the contents of a drawing. The result refers to `groups`, which must outlive it.
DxfContent sortDxf(const DxfGroups& groups);

/// Converts ASCII letters to lower case; used for the names of layers and blocks, which are not case-sensitive.
std::string lowerCase(std::string_view text);

/// Value of the entity's first group with this code; empty if there is none.
std::string_view valueOf(const DxfEntity& entity, int code);

/// Value of the entity's first group with this code, as a number; `otherwise` if there is none.
double realOf(const DxfEntity& entity, int code, double otherwise);
int integerOf(const DxfEntity& entity, int code, int otherwise);

}  // namespace keyblock
