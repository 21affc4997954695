// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Documentation generated from the field table of studies. Both texts are stored in
// resources/, and a test compares them with the table.
#pragma once

#include <string>

namespace keyblock {

/// The JSON Schema (draft 2020-12) of a study file: resources/schema/keyblock-study.schema.json.
std::string studySchema();

/// The reference page of the study file in Markdown: resources/help/study.md.
std::string studyReferencePage();

}  // namespace keyblock
