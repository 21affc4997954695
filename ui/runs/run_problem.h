// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why a document cannot be run now, in words for the user.
#pragma once

#include "solver/scene/problem.h"

#include <QString>

#include <vector>

namespace keyblock {

class Document;

/// The first error with what to do about it; empty: there is none.
QString firstError(const std::vector<Problem>& problems);

/// Why runs of the document's scene cannot start; empty: they can.
QString runProblem(const Document& document);

}  // namespace keyblock
