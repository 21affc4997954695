// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/nested_dissection.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <tuple>

namespace keyblock {
namespace {

constexpr std::size_t smallestPart = 100;  // so many bodies are not divided further

enum class Half : char { None, First, Second };

class Dissection {
public:
    Dissection(std::span<const Eigen::Vector2d> places, std::span<const std::pair<int, int>> pairs)
        : places_(places), first_(places.size() + 1, 0), half_(places.size(), Half::None), groups_(places.size(), 0) {
        for (const auto& [a, b] : pairs)
            if (a != b) ++first_[a + 1], ++first_[b + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        neighbours_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (const auto& [a, b] : pairs)
            if (a != b) neighbours_[next[a]++] = b, neighbours_[next[b]++] = a;
    }

    std::vector<int> groups() && {
        std::vector<int> all(places_.size());
        std::iota(all.begin(), all.end(), 0);
        divide(std::move(all));
        return std::move(groups_);
    }

private:
    using Bodies = std::vector<int>;

    void divide(Bodies part) {
        if (part.size() <= smallestPart) return number(part);
        Bodies other = part;
        halve(part, 0);
        Bodies border = shorterBorder(part);
        halve(other, 1);
        if (Bodies across = shorterBorder(other); across.size() < border.size()) {
            border = std::move(across);
            part = std::move(other);
        } else {
            mark(part);
        }
        for (const int body : border) half_[body] = Half::None;
        Bodies first = in(part, Half::First), second = in(part, Half::Second);
        divide(std::move(first));
        divide(std::move(second));
        number(border);
    }

    /// Sorts the part along an axis and divides it in the middle.
    void halve(Bodies& part, int axis) {
        const auto key = [&](int body) { return std::tuple(places_[body][axis], places_[body][1 - axis], body); };
        std::ranges::sort(part, {}, key);
        mark(part);
    }

    /// Marks the halves of a sorted part. Other parts may keep their marks, because no body is connected with them.
    void mark(const Bodies& part) {
        for (std::size_t i = 0; i < part.size(); ++i) half_[part[i]] = 2 * i < part.size() ? Half::First : Half::Second;
    }

    /// The bodies of one half that are connected to the other, of the half in which there are fewer.
    Bodies shorterBorder(const Bodies& part) const {
        Bodies first, second;
        for (const int body : part) {
            const Half other = half_[body] == Half::First ? Half::Second : Half::First;
            const bool isAtBorder = std::any_of(neighbours_.begin() + static_cast<std::ptrdiff_t>(first_[body]),
                                                neighbours_.begin() + static_cast<std::ptrdiff_t>(first_[body + 1]),
                                                [&](int neighbour) { return half_[neighbour] == other; });
            if (isAtBorder) (other == Half::Second ? first : second).push_back(body);
        }
        return first.size() <= second.size() ? first : second;
    }

    Bodies in(const Bodies& part, Half half) const {
        Bodies bodies;
        std::ranges::copy_if(part, std::back_inserter(bodies), [&](int body) { return half_[body] == half; });
        return bodies;
    }

    void number(const Bodies& group) {
        if (group.empty()) return;
        for (const int body : group) groups_[body] = count_;
        ++count_;
    }

    std::span<const Eigen::Vector2d> places_;
    std::vector<std::size_t> first_;  // per body: its first neighbour; at last the number of all
    Bodies neighbours_;
    std::vector<Half> half_;  // per body; None on a border
    std::vector<int> groups_;
    int count_ = 0;
};

}  // namespace

std::vector<int> nestedDissection(std::span<const Eigen::Vector2d> places, std::span<const std::pair<int, int>> pairs) {
    return Dissection(places, pairs).groups();
}

}  // namespace keyblock
