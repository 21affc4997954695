// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/tick_labels.h"

#include <algorithm>

namespace keyblock {

std::vector<TickLabel> tickLabels(const LegendBar& bar, const TickRoom& room) {
    const std::vector<double>& values = bar.ticks.values;
    const auto zero = std::find(values.begin(), values.end(), 0.0);
    const std::size_t kept = zero == values.end() ? 0 : static_cast<std::size_t>(zero - values.begin());
    for (std::size_t each = 1;; ++each) {
        std::vector<TickLabel> labels;
        double free = -1e9;
        bool fits = true;
        for (std::size_t i = kept % each; i < values.size(); i += each) {
            const std::string text = numberText(values[i], bar.ticks.decimals);
            const double half = 0.5 * room.widthOf(text);
            const double place = room.from + (room.to - room.from) * bar.shareOf(values[i]);
            const double middle = std::clamp(place, half, std::max(half, room.width - half));
            fits = fits && middle - half >= free;
            free = middle + half + room.gap;
            labels.push_back({place, middle, text});
        }
        if (fits || each >= values.size()) return labels;
    }
}

}  // namespace keyblock
