// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random sections. What makes one degenerate is what people draw and what sets of
// joints give: lines twice, nearly twice, through one point, ends on the border.
#include "tests/geometry/cut/cut_property.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace keyblock {
namespace {

class SectionMaker {
public:
    explicit SectionMaker(std::uint64_t seed) : random_(seed) {}

    CutInput make(bool degenerate) {
        size_ = std::pow(10.0, uniform(-2.0, 3.0));
        offset_ = random_() % 5 == 0 ? Point(1e6, -2e6) : Point(0.0, 0.0);
        makeDomains();
        const int count = static_cast<int>(50.0 * std::pow(40.0, uniform(0.0, 1.0)));
        length_ = 3.0 * size_ / std::sqrt(static_cast<double>(count));
        while (static_cast<int>(input_.traces.size()) < count)
            if (degenerate && !input_.traces.empty() && random_() % 3 == 0) addDegenerate();
            else addTrace(place(), uniform(0.0, 2.0 * std::numbers::pi), length_ * uniform(0.3, 1.7));
        if (random_() % 4 == 0) input_.settings.minArea = input_.settings.minWidth = 0.0;
        return input_;
    }

private:
    double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
    Point place() { return offset_ + size_ * Point(uniform(-0.6, 0.6), uniform(-0.6, 0.6)); }
    const CutTrace& anyTrace() { return input_.traces[random_() % input_.traces.size()]; }
    int anySource() { return static_cast<int>(random_() % 5); }

    void addOutline(int id, std::vector<Point> outline) {
        for (Point& p : outline) p = offset_ + size_ * p;
        input_.domains.push_back({id, std::move(outline)});
    }

    void makeDomains() {
        switch (random_() % 4) {
            case 0: return addOutline(3, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
            case 1: return addOutline(3, {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.1}, {0.1, 0.1}, {0.1, 0.5}, {-0.5, 0.5}});
            case 2:
                addOutline(7, {{-0.5, -0.5}, {0.0, -0.5}, {0.0, 0.5}, {-0.5, 0.5}});
                return addOutline(3, {{0.0, -0.3}, {0.5, -0.5}, {0.5, 0.5}, {0.0, 0.3}});
            default: break;
        }
        std::vector<Point> star;
        const int corners = 5 + static_cast<int>(random_() % 20);
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            star.push_back(uniform(0.25, 0.5) * Point(std::cos(angle), std::sin(angle)));
        }
        addOutline(3, star);
    }

    void addBetween(const Point& a, const Point& b) { input_.traces.push_back({a, b, anySource()}); }
    void addTrace(const Point& middle, double angle, double length) {
        const Point half = 0.5 * length * Point(std::cos(angle), std::sin(angle));
        addBetween(middle - half, middle + half);
    }
    Point on(const CutTrace& trace, double share) { return trace.from + share * (trace.to - trace.from); }
    Point on(const CutDomain& domain) {
        const std::size_t i = random_() % domain.outline.size();
        const Point &a = domain.outline[i], &b = domain.outline[(i + 1) % domain.outline.size()];
        return random_() % 3 == 0 ? a : Point(a + uniform(0.0, 1.0) * (b - a));
    }

    void addDegenerate() {
        const CutTrace one = anyTrace(), two = anyTrace();
        const Point way = one.to - one.from, side = turnLeft(way).normalized();
        const CutDomain& domain = input_.domains[random_() % input_.domains.size()];
        switch (random_() % 11) {
            case 0: return addBetween(one.from, one.to);  // twice
            case 1: return addBetween(on(one, 0.3), on(one, 1.4));  // along itself
            case 2: return addBetween(on(one, -0.2) + 1e-8 * size_ * side, on(one, 0.7) + 1e-8 * size_ * side);
            case 3: {  // a hair turned
                const Point centre = on(one, uniform(0.0, 1.0));
                const auto turned = [&](const Point& p) { return Point(p + 1e-9 * turnLeft(p - centre)); };
                return addBetween(turned(one.from), turned(one.to));
            }
            case 4: {  // through where two cross, or would
                const double det = cross(way, two.to - two.from);
                const double share = det == 0.0 ? 0.5 : cross(two.from - one.from, two.to - two.from) / det;
                return addTrace(on(one, std::clamp(share, 0.0, 1.0)), uniform(0.0, 3.0), length_);
            }
            case 5: return addBetween(place(), on(domain));  // ends on the border
            case 6: {  // through a corner of the domain or across the border
                const Point p = on(domain);
                return addTrace(p, uniform(0.0, 3.0), length_);
            }
            case 7: return addBetween(one.from, one.from);
            case 8: return addBetween(on(one, uniform(0.0, 1.0)), place());  // T
            case 9: {  // T, nearly
                const Point end = on(one, uniform(0.0, 1.0)) + uniform(-3e-6, 3e-6) * size_ * side;
                return addBetween(end, place());
            }
            default: {  // along the border
                const std::size_t i = random_() % domain.outline.size();
                const Point &a = domain.outline[i], &b = domain.outline[(i + 1) % domain.outline.size()];
                return addBetween(a + uniform(-0.2, 0.5) * (b - a), a + uniform(0.5, 1.2) * (b - a));
            }
        }
    }

    std::mt19937_64 random_;
    double size_ = 1.0, length_ = 1.0;  // [m]
    Point offset_{0.0, 0.0};  // [m]
    CutInput input_;
};

/// Numbers out of bytes; zeros when they are used up.
class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    bool left() const { return at_ < bytes_.size(); }
    int next() { return left() ? bytes_[at_++] : 0; }

private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

/// A coordinate on a lattice of 16 lines; the other four bits put it a hair beside, or far away.
double coordinate(int byte) {
    static constexpr double beside[16] = {0.0,   0.0,    0.0,   1e-16, -1e-16, 1e-14, -1e-12, 1e-9,
                                          -1e-9, 1.3e-6, -8e-7, 1e-4,  -1e-3,  0.37,  1.0 / 3, 5.0};
    return 0.125 * (byte % 16) - 0.9375 + beside[byte / 16];
}

}  // namespace

CutInput randomSection(std::uint64_t seed) { return SectionMaker(seed).make(seed % 2 == 1); }

CutInput sectionOfBytes(std::span<const std::uint8_t> given) {
    Bytes bytes(given);
    CutInput input;
    const int form = bytes.next();
    const Point offset = form & 1 ? Point(1e6, 1e6) : Point(0.0, 0.0);
    const double scale = form & 2 ? 1e-3 : 1.0;
    const auto point = [&] {
        const double x = coordinate(bytes.next()), y = coordinate(bytes.next());
        return Point(offset + scale * Point(x, y));
    };
    std::vector<Point> outline;
    const int corners = 3 + form / 4 % 8;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners, radius = 0.1 + bytes.next() / 280.0;
        outline.push_back(offset + scale * radius * Point(std::cos(angle), std::sin(angle)));
    }
    input.domains.push_back({1, outline});
    if (form & 32) input.settings.tolerance = scale * 1e-3;
    if (form & 64) input.settings.minArea = 0.0;
    if (form & 128) input.settings.minWidth = 0.0;
    while (bytes.left() && input.traces.size() < 200) {
        const int kind = bytes.next();
        const Point from = kind & 1 && !input.traces.empty() ? input.traces.back().to : point();
        input.traces.push_back({from, point(), kind / 2 % 8});
    }
    return input;
}

}  // namespace keyblock
