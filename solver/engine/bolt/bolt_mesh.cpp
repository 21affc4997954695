// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/bolt_mesh.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double growth = 0.2;  // growth of the element length per distance from a refined zone
constexpr double samplesAnElement = 8.0;  // samples of the node density per element
constexpr double mostSamples = 2e5;
constexpr double leastShare = 0.05;  // of the element length: requested nodes this close to another node are left out

/// Longest element allowed at each position.
class ElementSize {
public:
    explicit ElementSize(const MeshRequest& request) : request_(request) {
        for (const FinePlace& place : request.fine) least_ = std::min(least_, place.element);
        least_ = std::min(least_, request.longest);
        const double wanted = elementsBetween(0.0, request.length);
        stretch_ = std::max(1.0, wanted / mostElements);
    }

    double at(double s) const {
        double size = request_.longest;
        for (const FinePlace& place : request_.fine)
            size = std::min(size, place.element + growth * std::max(0.0, std::abs(s - place.s) - place.zone));
        return stretch_ * size;
    }

    /// Number of midpoints at which the node density is sampled.
    int samples(double from, double to) const {
        return static_cast<int>(std::clamp(std::ceil(samplesAnElement * (to - from) / least_ - 1e-6), 8.0, mostSamples));
    }

    /// Number of elements that fit, not rounded.
    double elementsBetween(double from, double to) const {
        const int count = samples(from, to);
        const double width = (to - from) / count;
        double elements = 0.0;
        for (int i = 0; i < count; ++i) elements += width / at(from + (i + 0.5) * width);
        return elements;
    }

private:
    const MeshRequest& request_;
    double least_ = 1e300;
    double stretch_ = 1.0;
};

/// Adds nodes up to `to`. The element lengths are graded and scaled so that a whole number of them fits. Adds nothing
/// if the last node is already at `to`.
void fill(std::vector<double>& nodes, double to, const ElementSize& size, double tolerance) {
    const double from = nodes.back();
    if (to - from <= tolerance) return;
    const double fits = size.elementsBetween(from, to);
    const int count = std::max(1, static_cast<int>(std::ceil(fits - 1e-9)));
    const int samples = size.samples(from, to);
    const double width = (to - from) / samples;
    double passed = 0.0;
    int next = 1;
    for (int i = 0; i < samples && next < count; ++i) {
        const double start = from + i * width, here = width / size.at(start + 0.5 * width);
        for (; next < count && passed + here >= fits * next / count; ++next)
            nodes.push_back(start + width * (fits * next / count - passed) / here);
        passed += here;
    }
    nodes.push_back(to);
}

/// Half the length of the element that spans a joint: no longer than requested, clear of the other joints and within
/// the bolt [m].
double halfElement(const MeshRequest& request, std::size_t joint, double longest) {
    const std::vector<double>& joints = request.joints;
    double room = std::min({longest, 2.0 * joints[joint], 2.0 * (request.length - joints[joint])});
    if (joint > 0) room = std::min(room, joints[joint] - joints[joint - 1]);
    if (joint + 1 < joints.size()) room = std::min(room, joints[joint + 1] - joints[joint]);
    return 0.5 * room;
}

}  // namespace

std::vector<double> equalNodes(double length, int divisions) {
    std::vector<double> nodes;
    for (int i = 0; i <= divisions; ++i) nodes.push_back(length * i / divisions);
    return nodes;
}

std::vector<double> gradedNodes(const MeshRequest& request) {
    const ElementSize size(request);
    const double tolerance = 1e-9 * request.length;
    std::vector<double> nodes{0.0};
    auto wanted = request.nodes.begin();
    const auto fillTo = [&](double to) {
        for (; wanted != request.nodes.end() && *wanted < to; ++wanted) {
            const double least = leastShare * size.at(*wanted);
            if (*wanted - nodes.back() > least && to - *wanted > least) fill(nodes, *wanted, size, tolerance);
        }
        fill(nodes, to, size, tolerance);
    };
    for (std::size_t i = 0; i < request.joints.size(); ++i) {
        const double half = halfElement(request, i, size.at(request.joints[i]));
        fillTo(request.joints[i] - half);
        nodes.push_back(request.joints[i] + half);
    }
    fillTo(request.length);
    nodes.back() = request.length;
    return nodes;
}

}  // namespace keyblock
