// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines that occur exactly once in each text are matched: the largest set that
// is in the same order in both texts. The ranges between two matches are
// compared in the same way.
#include "ui/document/text_changes.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace keyblock {

namespace {

constexpr int deepest = 8;  // recursion levels
constexpr std::size_t joinedBelow = 32;  // changes with fewer bytes between them are merged

bool isWithinLetter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Length of the common beginning, in bytes, without cutting a UTF-8 character.
std::size_t commonBegin(std::string_view a, std::string_view b) {
    const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    std::size_t same = differ.first - a.begin();
    while (same > 0 && ((same < a.size() && isWithinLetter(a[same])) || (same < b.size() && isWithinLetter(b[same]))))
        --same;
    return same;
}

std::size_t commonEnd(std::string_view a, std::string_view b) {
    const auto differ = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    std::size_t same = differ.first - a.rbegin();
    while (same > 0 && isWithinLetter(a[a.size() - same])) --same;
    return same;
}

/// A text split into lines, each with its line end.
struct Lines {
    explicit Lines(std::string_view whole) : text(whole) {
        for (std::size_t at = 0; at < text.size();) {
            starts.push_back(at);
            const std::size_t end = text.find('\n', at);
            at = end == std::string_view::npos ? text.size() : end + 1;
        }
        starts.push_back(text.size());
    }
    std::size_t count() const { return starts.size() - 1; }
    std::string_view operator[](std::size_t line) const { return between(line, line + 1); }
    std::string_view between(std::size_t first, std::size_t end) const {
        return text.substr(starts[first], starts[end] - starts[first]);
    }

    std::string_view text;
    std::vector<std::size_t> starts;  // start of each line, and end of the last line
};

/// A range of lines in each text; `aEnd` and `bEnd` are one past the last line.
struct Stretch {
    std::size_t a = 0, aEnd = 0, b = 0, bEnd = 0;
};

using Meeting = std::pair<std::size_t, std::size_t>;  // index of a matched line in each text

/// The longest subset that is in the same order in both texts. \pre `all` increases in the first text.
std::vector<Meeting> inOrder(const std::vector<Meeting>& all) {
    std::vector<std::size_t> tails, before(all.size());  // last element of the best sequence of each length
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto at = std::ranges::lower_bound(tails, all[i].second, {}, [&](std::size_t t) { return all[t].second; });
        before[i] = at == tails.begin() ? i : *(at - 1);
        if (at == tails.end()) tails.push_back(i);
        else *at = i;
    }
    std::vector<Meeting> kept(tails.size());
    std::size_t i = tails.empty() ? 0 : tails.back();
    for (std::size_t n = kept.size(); n-- > 0; i = before[i]) kept[n] = all[i];
    return kept;
}

class Comparison {
public:
    Comparison(std::string_view before, std::string_view after) : a_(before), b_(after) {}

    std::vector<TextChange> changes() {
        compare({0, a_.count(), 0, b_.count()}, 0);
        std::vector<TextChange> changes;
        for (const Place& place : places_)
            changes.push_back({place.from, place.removed, std::string(b_.text.substr(place.to, place.added))});
        return changes;
    }

private:
    struct Place {
        std::size_t from = 0, removed = 0, to = 0, added = 0;  // byte ranges in the old and in the new text
    };

    void compare(Stretch s, int depth) {
        while (s.a < s.aEnd && s.b < s.bEnd && a_[s.a] == b_[s.b]) ++s.a, ++s.b;
        while (s.a < s.aEnd && s.b < s.bEnd && a_[s.aEnd - 1] == b_[s.bEnd - 1]) --s.aEnd, --s.bEnd;
        if (s.a == s.aEnd && s.b == s.bEnd) return;
        const bool looksCloser = s.aEnd - s.a > 1 && s.bEnd - s.b > 1 && depth < deepest;
        const std::vector<Meeting> meetings = looksCloser ? meetingsIn(s) : std::vector<Meeting>();
        if (meetings.empty()) return add(s);
        for (const auto& [a, b] : meetings) {
            compare({s.a, a, s.b, b}, depth + 1);
            s.a = a + 1, s.b = b + 1;
        }
        compare(s, depth + 1);
    }

    std::vector<Meeting> meetingsIn(const Stretch& s) const {
        struct Seen {
            int inA = 0, inB = 0;
            std::size_t b = 0;
        };
        std::unordered_map<std::string_view, Seen> seen;
        seen.reserve(s.aEnd - s.a);
        for (std::size_t a = s.a; a < s.aEnd; ++a) ++seen[a_[a]].inA;
        for (std::size_t b = s.b; b < s.bEnd; ++b)
            if (const auto found = seen.find(b_[b]); found != seen.end()) ++found->second.inB, found->second.b = b;
        std::vector<Meeting> meetings;
        for (std::size_t a = s.a; a < s.aEnd; ++a)
            if (const Seen& line = seen[a_[a]]; line.inA == 1 && line.inB == 1) meetings.emplace_back(a, line.b);
        return inOrder(meetings);
    }

    void add(const Stretch& s) {
        const std::string_view before = a_.between(s.a, s.aEnd), after = b_.between(s.b, s.bEnd);
        const std::size_t begin = commonBegin(before, after);
        const std::size_t end = commonEnd(before.substr(begin), after.substr(begin));
        const Place place{a_.starts[s.a] + begin, before.size() - begin - end, b_.starts[s.b] + begin,
                          after.size() - begin - end};
        if (!places_.empty() && place.from - (places_.back().from + places_.back().removed) < joinedBelow) {
            Place& last = places_.back();
            last.removed = place.from + place.removed - last.from;
            last.added = place.to + place.added - last.to;
        } else {
            places_.push_back(place);
        }
    }

    Lines a_, b_;
    std::vector<Place> places_;
};

}  // namespace

std::vector<TextChange> textChanges(std::string_view before, std::string_view after) {
    return Comparison(before, after).changes();
}

bool areWithin(const std::vector<TextChange>& changes, std::size_t length) {
    std::size_t at = 0;
    for (const TextChange& change : changes) {
        if (change.begin < at || change.begin > length || change.removed > length - change.begin) return false;
        at = change.begin + change.removed;
    }
    return true;
}

std::string changed(std::string_view before, const std::vector<TextChange>& changes) {
    std::string after;
    std::size_t at = 0;
    for (const TextChange& change : changes) {
        after.append(before.substr(at, change.begin - at)).append(change.text);
        at = change.begin + change.removed;
    }
    return after.append(before.substr(at));
}

}  // namespace keyblock
