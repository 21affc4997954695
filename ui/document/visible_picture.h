// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawing without hidden objects: bolts and patterns, blocks, and the traces of
// joints and joint sets.
#pragma once

#include "ui/document/checked.h"

#include <memory>

namespace keyblock {

class Visibility;

/// The drawing from `checked` without the hidden objects; null if there is no drawing. If nothing is hidden, this is
/// `checked.picture` itself, not a copy.
std::shared_ptr<const SectionPicture> visiblePicture(const Checked& checked, const Visibility& visibility);

}  // namespace keyblock
