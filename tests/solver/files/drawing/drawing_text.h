// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes small drawings for tests, pair by pair, as CAD programs do.
#pragma once

#include "geometry/point.h"
#include "solver/scene/number_text.h"

#include <string>
#include <vector>

namespace keyblock::test {

class DrawingText {
public:
    DrawingText& pair(int code, const std::string& value) {
        text_ += (code < 10 ? "  " : code < 100 ? " " : "") + std::to_string(code) + '\n' + value + '\n';
        return *this;
    }
    DrawingText& pair(int code, double value) { return pair(code, shortest(value)); }
    DrawingText& pair(int code, int value) { return pair(code, std::to_string(value)); }
    DrawingText& section(const std::string& name) { return pair(0, "SECTION").pair(2, name); }
    DrawingText& end() { return pair(0, "ENDSEC"); }
    DrawingText& units(int code) { return section("HEADER").pair(9, "$INSUNITS").pair(70, code).end(); }

    DrawingText& entity(const std::string& kind, const std::string& layer) {
        return pair(0, kind).pair(5, std::to_string(100 + handle_++)).pair(100, "AcDbEntity").pair(8, layer);
    }
    DrawingText& at(int code, const Point& p) { return pair(code, p.x()).pair(code + 10, p.y()); }
    DrawingText& line(const std::string& layer, const Point& a, const Point& b) {
        return entity("LINE", layer).at(10, a).pair(30, 0.0).at(11, b).pair(31, 0.0);
    }
    DrawingText& arc(const std::string& layer, const Point& center, double radius, double from, double to) {
        return entity("ARC", layer).at(10, center).pair(40, radius).pair(50, from).pair(51, to);
    }
    DrawingText& polyline(const std::string& layer, const std::vector<Point>& points, bool closed = true,
                          const std::vector<double>& bulges = {}) {
        entity("LWPOLYLINE", layer).pair(90, static_cast<int>(points.size())).pair(70, closed ? 1 : 0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            at(10, points[i]);
            if (!bulges.empty()) pair(42, bulges[i]);
        }
        return *this;
    }
    std::string text() const { return text_ + "  0\nEOF\n"; }

private:
    std::string text_;
    int handle_ = 0;
};

}  // namespace keyblock::test
