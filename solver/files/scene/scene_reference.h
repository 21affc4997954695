// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the field table says, for other programs and for people. Both texts are
// kept in resources/ and compared with the table by a test.
#pragma once

#include <string>

namespace keyblock {

/// The JSON Schema (draft 2020-12) of a scene file: resources/schema/keyblock-scene.schema.json.
std::string sceneSchema();

/// The reference page of the scene file, Markdown: resources/help/scene.md.
std::string sceneReferencePage();

}  // namespace keyblock
