// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/screen_sizes.h"

#include <algorithm>

namespace keyblock {

double shankWidth(const SectionPicture& picture, double scale) {
    std::vector<double> spacing = boltSpacing(picture, scale, onTheScreen);
    if (spacing.empty()) return shankOnScreen;
    const auto middle = spacing.begin() + static_cast<std::ptrdiff_t>(spacing.size() / 2);
    std::nth_element(spacing.begin(), middle, spacing.end());
    return std::clamp(0.4 * *middle, 1.0, shankOnScreen);
}

}  // namespace keyblock
