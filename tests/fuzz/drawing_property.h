// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must hold of the import of drawings and lists whatever bytes it is given.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// The bytes are read as a drawing and as a list. An import ends with a scene or with errors that say what to do; with
/// a scene, every entity of the drawing is accounted for. \return what does not hold; empty where all does.
std::string brokenDrawingProperty(std::string_view bytes);

}  // namespace keyblock
