// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/screen_sizes.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

double shankWidth(const SectionPicture& picture, double scale) {
    std::vector<double> spacing = boltSpacing(picture, scale, onTheScreen);
    if (spacing.empty()) return shankOnScreen;
    const auto middle = spacing.begin() + static_cast<std::ptrdiff_t>(spacing.size() / 2);
    std::nth_element(spacing.begin(), middle, spacing.end());
    return std::clamp(0.4 * *middle, 1.0, shankOnScreen);
}

double lineWidth(const SectionPicture& picture, double scale) {
    if (picture.blocks.empty()) return 1.0;
    const double area = (picture.model.max - picture.model.min).prod() / static_cast<double>(picture.blocks.size());
    return std::clamp(std::sqrt(std::max(area, 0.0)) * scale / 14.0, 0.3, 1.0);
}

}  // namespace keyblock
