// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/drawing/closed_outlines.h"

#include <algorithm>

namespace keyblock {

namespace {

class Joiner {
public:
    Joiner(std::span<const DrawnLine> lines, double tolerance)
        : lines_(lines), tolerance_(tolerance), used_(lines.size()) {}

    ClosedOutlines join() {
        ClosedOutlines found;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (used_[i]) continue;
            used_[i] = true;
            if (lines_[i].closed) {
                found.outlines.push_back({lines_[i].points, {i}});
                continue;
            }
            ClosedOutline chain{lines_[i].points, {i}};
            while (!isClosed(chain) && extend(chain)) {
            }
            if (isClosed(chain)) {
                chain.points.pop_back();
                found.outlines.push_back(std::move(chain));
            } else {
                for (const std::size_t line : chain.lines) used_[line] = line == i;
                found.open.push_back(i);
            }
        }
        return found;
    }

private:
    bool meet(const Point& a, const Point& b) const { return (a - b).norm() <= tolerance_; }
    bool isClosed(const ClosedOutline& chain) const {
        return chain.points.size() > 3 && meet(chain.points.front(), chain.points.back());
    }

    bool extend(ClosedOutline& chain) {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (used_[i] || lines_[i].closed) continue;
            std::vector<Point> next = lines_[i].points;
            if (!meet(chain.points.back(), next.front())) std::reverse(next.begin(), next.end());
            if (!meet(chain.points.back(), next.front())) continue;
            chain.points.insert(chain.points.end(), next.begin() + 1, next.end());
            chain.lines.push_back(i);
            used_[i] = true;
            return true;
        }
        return false;
    }

    std::span<const DrawnLine> lines_;
    double tolerance_;
    std::vector<char> used_;
};

}  // namespace

ClosedOutlines closeOutlines(std::span<const DrawnLine> lines, double tolerance) {
    return Joiner(lines, tolerance).join();
}

}  // namespace keyblock
