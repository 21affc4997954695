// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A problem of the parameters of a shape, as text for the user. The scene check adds
// the location in the file, since the geometry library does not know files.
#pragma once

#include <string>

namespace keyblock {

struct ShapeProblem {
    std::string field;  // key of the parameter in the scene file
    std::string message;  // what is wrong
    std::string remedy;  // what to do
};

}  // namespace keyblock
