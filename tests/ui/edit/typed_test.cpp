// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Typed texts in tables: their values, and the messages for invalid ones.
#include "ui/edit/typed_number.h"
#include "ui/edit/typed_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace keyblock;

struct Good {
    const char* text;
    const char* unit;
    double value;
};

TEST(TypedNumber, ReadsNumbersUnitsAndExpressions) {
    const Good table[] = {
        {"12.5", "m", 12.5}, {"12,5", "m", 12.5}, {" −3 ", "m", -3.0}, {"+4", "", 4.0}, {".5", "m", 0.5},
        {",5", "m", 0.5}, {"5.", "m", 5.0}, {"1e3", "N", 1000.0}, {"1e-3", "m", 0.001}, {"2.5E+2", "m", 250.0},
        {"12 500", "N", 12500.0}, {"12\u2009500", "N", 12500.0},
        {"300mm", "m", 0.3}, {"25 mm", "m", 0.025}, {"250 cm", "m", 2.5}, {"1 ft", "m", 0.3048}, {"10in", "m", 0.254},
        {"2 m", "mm", 2000.0}, {"5kN", "N", 5000.0}, {"5000 N", "kN", 5.0}, {"60 GPa", "Pa", 60e9},
        {"60e9Pa", "GPa", 60.0}, {"1 psi", "Pa", 6894.757293168361}, {"2700 kg/m3", "kg/m³", 2700.0},
        {"2.7 t/m³", "kg/m³", 2700.0}, {"2,7 g/cm^3", "kg/m³", 2700.0}, {"20 MPa/m", "Pa/m", 20e6},
        {"1 g", "m/s²", 9.80665}, {"45°", "°", 45.0}, {"45", "°", 45.0}, {"3.141592653589793 rad", "°", 180.0},
        {"10 mm/s", "m/s", 0.01}, {"8 kN/m", "N/m per m", 0.0}, {"50 %", "", 0.5}, {"2 min", "s", 120.0},
        {"2", "s, or pseudo-time of a static stage", 2.0}, {"5 ms", "s, or pseudo-time of a static stage", 0.005},
        {"=5/2+0.1", "m", 2.6}, {"5/2+0.1", "m", 2.6}, {"=2m + 300mm", "m", 2.3}, {"= (2+3) cm", "m", 0.05},
        {"2*(1+1)", "", 4.0}, {"=sqrt(2)*sqrt(2)", "", 2.0000000000000004}, {"=2*sin(30)", "", 1.0},
        {"=max(1, 5mm)", "m", 1.0}, {"-2-3", "m", -5.0}, {"2^3", "", 8.0}, {"=1e-3*2", "m", 0.002}, {"=pi", "", 3.141592653589793},
        {"3 kip", "kN", 13.3446648457815}, {"5×2", "", 10.0}, {"=1/4 m", "m", 0.25},
    };
    for (const Good& row : table) {
        const TypedNumber typed = typedNumber(row.text, row.unit);
        if (std::string(row.unit) == "N/m per m") {  // a stiffness is not a stiffness per metre
            EXPECT_FALSE(typed.value) << row.text;
            continue;
        }
        ASSERT_TRUE(typed.value) << row.text << ": " << typed.problem;
        EXPECT_NEAR(*typed.value, row.value, 1e-15 * std::abs(row.value) * 4) << row.text;
    }
}

TEST(TypedNumber, ReportsErrors) {
    const std::pair<const char*, const char*> table[] = {
        {"", "Enter a number"}, {"   ", "Enter a number"}, {"=", "Enter a number"}, {"abc", "is not a valid number"},
        {"1.2.3", "is not a valid number"}, {"1.234,5", "is not a valid number"},
        {"5 kN", "wrong kind of unit. Enter a length"}, {"5 qq", "is not a known unit"}, {"5 m/", "incomplete"},
        {"=5/0", "no finite value"}, {"=(2+3", "not closed"}, {"=2+3)", "bracket too many"}, {"=2+", "incomplete"},
        {"=2,5+1", "use a decimal point"}, {"=foo(2)", "is not a known name"}, {"5 > 3", "is not"},
        {"=a=5", "is not allowed in"}, {"=sqrt(-1)", "no finite value"}, {"1e999", "not a valid number"}, {"--", ""},
        {"5 5", ""}, {"=\"a\"", "is not allowed in"}, {"=2 ? 3", "is not allowed in"}, {"m", "is not a valid number"},
        {"=1;2", "is not allowed in"}, {"\xff\xfe", ""}, {"=sin()", ""}, {"=1e400", "not a valid number"},
        {"nan", "is not a valid number"}, {"inf", "is not a valid number"}, {"0x10", ""}};
    for (const auto& [text, said] : table) {
        const TypedNumber typed = typedNumber(text, "m");
        EXPECT_FALSE(typed.value) << text << " gave " << typed.value.value_or(0.0);
        EXPECT_NE(typed.problem.find(said), std::string::npos) << text << " gave: " << typed.problem;
        EXPECT_FALSE(typed.problem.empty()) << text;
    }
}

TEST(TypedNumber, AcceptsAnyBytes) {
    unsigned state = 12345;
    const std::string alphabet = "0123456789.,+-*/^()=@<; eEmkNPa°\"\x01\xc2\xb2_'%";
    for (int run = 0; run < 20000; ++run) {
        std::string text;
        for (int i = 0; i < run % 12; ++i) {
            state = state * 1664525u + 1013904223u;
            text += alphabet[(state >> 16) % alphabet.size()];
        }
        const TypedNumber typed = typedNumber(text, "m");
        EXPECT_NE(typed.value.has_value(), !typed.problem.empty()) << text;
        EXPECT_TRUE(std::isfinite(typed.value.value_or(0.0))) << text;
    }
}

struct GoodPoint {
    const char* text;
    Point place;
};

TEST(TypedPoint, ReadsAbsoluteRelativeAndPolarCoordinates) {
    const TypingContext context{Point(1.0, 1.0), Point(4.0, 5.0)};
    const GoodPoint table[] = {
        {"12.5,3", {12.5, 3.0}}, {"12,5;3,25", {12.5, 3.25}}, {"-2, 0", {-2.0, 0.0}}, {"@2,0", {3.0, 1.0}},
        {"@ -1 , 300mm", {0.0, 1.3}}, {"@3<90", {1.0, 4.0}}, {"@2,5<0", {3.5, 1.0}}, {"5", {4.0, 5.0}},
        {"2,5;0", {2.5, 0.0}}, {"=5/2+0.1, max(1,2)", {2.6, 2.0}}, {"@2ft<180", {1.0 - 0.6096, 1.0}}, {"10 m", {7.0, 9.0}},
        {"−1,−2", {-1.0, -2.0}}};
    for (const GoodPoint& row : table) {
        const TypedPoint typed = typedPoint(row.text, context);
        ASSERT_TRUE(typed.place) << row.text << ": " << typed.problem;
        EXPECT_NEAR((*typed.place - row.place).norm(), 0.0, 1e-12) << row.text;
    }
    EXPECT_NEAR((*typedPoint("250,100", context, "mm").place - Point(0.25, 0.1)).norm(), 0.0, 1e-15);
}

TEST(TypedPoint, ReportsErrors) {
    const TypingContext nothing{std::nullopt, Point(4.0, 5.0)};
    const TypingContext onMouse{Point(4.0, 5.0), Point(4.0, 5.0)};
    const auto said = [](const char* text, const TypingContext& context) { return typedPoint(text, context).problem; };
    EXPECT_NE(said("@2,0", nothing).find("no previous point yet"), std::string::npos);
    EXPECT_NE(said("@2<30", nothing).find("no previous point yet"), std::string::npos);
    EXPECT_NE(said("3<45", onMouse).find("@3<45"), std::string::npos);
    EXPECT_NE(said("5", nothing).find("x and y"), std::string::npos);
    EXPECT_NE(said("5", onMouse).find("Move the mouse"), std::string::npos);
    EXPECT_NE(said("1,2,3", onMouse).find("not 3"), std::string::npos);
    EXPECT_NE(said("@5", onMouse).find("two coordinates"), std::string::npos);
    EXPECT_NE(said("a,2", onMouse).find("x: "), std::string::npos);
    EXPECT_NE(said("1,2 kN", onMouse).find("y: "), std::string::npos);
    EXPECT_NE(said("2e9,0", onMouse).find("too far"), std::string::npos);
    EXPECT_NE(said("@1<2<3", onMouse).find("angle"), std::string::npos);
    EXPECT_NE(said("", onMouse).find("coordinates"), std::string::npos);
    EXPECT_FALSE(typedPoint("1,", onMouse).place);
    EXPECT_FALSE(typedPoint(",", onMouse).place);
}

}  // namespace
