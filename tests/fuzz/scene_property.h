// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must hold of the scene reader whatever bytes it is given. The fuzzer
// looks for bytes that break it; the suite runs those it has kept.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// Reading ends with a scene or with errors that say what to do; a scene that is accepted is written and read back the
/// same, and a model can be made of it. \return what does not hold; empty where all does.
std::string brokenSceneProperty(std::string_view bytes);

}  // namespace keyblock
