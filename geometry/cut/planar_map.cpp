// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only file that uses CGAL. All segments are inserted at once, which is several times faster than one by one.
// Numbers are evaluated lazily: interval arithmetic is enough in nearly all cases, and only the others are computed
// with exact rational numbers.
#include "geometry/cut/planar_map.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace keyblock {
namespace {

/// Combines the marks of edges that overlap.
struct Together {
    EdgeMark operator()(const EdgeMark& a, const EdgeMark& b) const {
        return {std::min(a.owner, b.owner), inOneOf(a.domains, b.domains)};
    }
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;
using Traits = CGAL::Arr_curve_data_traits_2<SegmentTraits, EdgeMark, Together>;
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_extended_dcel<Traits, int, int, int>>;

double rounded(const CGAL::Interval_nt<false>& interval) { return 0.5 * (interval.inf() + interval.sup()); }

/// The midpoint of the interval that contains the point; if the interval is wider than the precision, the exact point.
Point rounded(const Kernel::Point_2& place, double precision) {
    const auto& x = place.approx().x();
    const auto& y = place.approx().y();
    if (x.sup() - x.inf() <= precision && y.sup() - y.inf() <= precision) return {rounded(x), rounded(y)};
    return {CGAL::to_double(place.exact().x()), CGAL::to_double(place.exact().y())};
}

void insertAll(Arrangement& arrangement, std::span<const MarkedSegment> segments) {
    const auto exact = [](const Point& p) { return Kernel::Point_2(p.x(), p.y()); };
    std::vector<Traits::X_monotone_curve_2> curves;
    curves.reserve(segments.size());
    for (const MarkedSegment& segment : segments)
        curves.emplace_back(SegmentTraits::X_monotone_curve_2(exact(segment.from), exact(segment.to)), segment.mark);
    CGAL::insert(arrangement, curves.begin(), curves.end());
}

void numberAll(Arrangement& arrangement) {
    int vertices = 0, faces = 1, halfEdges = 0;
    for (auto vertex = arrangement.vertices_begin(); vertex != arrangement.vertices_end(); ++vertex)
        vertex->set_data(vertices++);
    for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face)
        face->set_data(face->is_unbounded() ? 0 : faces++);
    for (auto edge = arrangement.edges_begin(); edge != arrangement.edges_end(); ++edge) {
        edge->set_data(halfEdges++);
        edge->twin()->set_data(halfEdges++);
    }
}

}  // namespace

PlanarMap planarMap(std::span<const MarkedSegment> segments, double precision) {
    Arrangement arrangement;
    insertAll(arrangement, segments);
    numberAll(arrangement);
    PlanarMap map;
    map.faces = static_cast<int>(arrangement.number_of_faces());
    map.points.reserve(arrangement.number_of_vertices());
    for (auto vertex = arrangement.vertices_begin(); vertex != arrangement.vertices_end(); ++vertex)
        map.points.push_back(rounded(vertex->point(), precision));
    map.halfEdges.reserve(arrangement.number_of_halfedges());
    map.marks.reserve(arrangement.number_of_edges());
    for (auto edge = arrangement.edges_begin(); edge != arrangement.edges_end(); ++edge) {
        map.marks.push_back(edge->curve().data());
        for (const Arrangement::Halfedge_handle half : {Arrangement::Halfedge_handle(edge), edge->twin()})
            map.halfEdges.push_back({half->next()->data(), half->target()->data(), half->face()->data()});
    }
    return map;
}

}  // namespace keyblock
