// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Documentation generated from the field table, for other programs and for users.
// Both texts are stored in resources/, and a test compares them with the table.
#pragma once

#include "solver/scene/field.h"

#include <string>
#include <string_view>

namespace keyblock {

/// The JSON Schema (draft 2020-12) of a file whose table is `root`.
std::string schemaOf(const Structure& root, std::string_view title);

/// Reference page in Markdown of the tables from `root`: a section for each, after the text `head`.
std::string referencePageOf(const Structure& root, std::string_view head);

/// The JSON Schema (draft 2020-12) of a scene file: resources/schema/keyblock-scene.schema.json.
std::string sceneSchema();

/// The reference page of the scene file in Markdown: resources/help/scene.md.
std::string sceneReferencePage();

}  // namespace keyblock
