// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Access to the members of a plain struct without listing them: the compiler counts
// and binds them. A member added anywhere in the state of a run is therefore written,
// read and checked with the others and cannot be forgotten.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <tuple>
#include <type_traits>

namespace keyblock {

template <typename T>
concept Arithmetic = std::is_arithmetic_v<T>;

template <typename T>
concept Enumeration = std::is_enum_v<T>;

template <typename T>
concept PlainNumber = Arithmetic<T> || Enumeration<T>;

template <typename T>
concept FixedMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T> && T::SizeAtCompileTime != Eigen::Dynamic;

namespace members_detail {

/// A type that converts to any other; used only to check whether an expression compiles.
struct Anything {
    template <typename T>
    operator T() const;  // NOLINT(google-explicit-constructor): conversions without a cast are what is checked
};

template <typename T, typename... Given>
constexpr std::size_t count() {
    if constexpr (requires { T{Given{}..., Anything{}}; }) return count<T, Given..., Anything>();
    else return sizeof...(Given);
}

}  // namespace members_detail

/// Number of members of an aggregate.
template <typename T>
inline constexpr std::size_t memberCount = members_detail::count<std::remove_cv_t<T>>();

// clang-format off
#define KEYBLOCK_MEMBERS(n, ...) \
    if constexpr (memberCount<T> == n) { auto& [__VA_ARGS__] = value; return std::tie(__VA_ARGS__); } else

/// References to all members of `value`, in order. A type with more than 28 members does not compile: group its members
/// in structs, or add a line below.
template <typename T>
    requires std::is_aggregate_v<T>
auto membersOf(T& value) {
    KEYBLOCK_MEMBERS(1, a)
    KEYBLOCK_MEMBERS(2, a, b)
    KEYBLOCK_MEMBERS(3, a, b, c)
    KEYBLOCK_MEMBERS(4, a, b, c, d)
    KEYBLOCK_MEMBERS(5, a, b, c, d, e)
    KEYBLOCK_MEMBERS(6, a, b, c, d, e, f)
    KEYBLOCK_MEMBERS(7, a, b, c, d, e, f, g)
    KEYBLOCK_MEMBERS(8, a, b, c, d, e, f, g, h)
    KEYBLOCK_MEMBERS(9, a, b, c, d, e, f, g, h, i)
    KEYBLOCK_MEMBERS(10, a, b, c, d, e, f, g, h, i, j)
    KEYBLOCK_MEMBERS(11, a, b, c, d, e, f, g, h, i, j, k)
    KEYBLOCK_MEMBERS(12, a, b, c, d, e, f, g, h, i, j, k, l)
    KEYBLOCK_MEMBERS(13, a, b, c, d, e, f, g, h, i, j, k, l, m)
    KEYBLOCK_MEMBERS(14, a, b, c, d, e, f, g, h, i, j, k, l, m, n)
    KEYBLOCK_MEMBERS(15, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o)
    KEYBLOCK_MEMBERS(16, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
    KEYBLOCK_MEMBERS(17, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
    KEYBLOCK_MEMBERS(18, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r)
    KEYBLOCK_MEMBERS(19, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s)
    KEYBLOCK_MEMBERS(20, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t)
    KEYBLOCK_MEMBERS(21, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u)
    KEYBLOCK_MEMBERS(22, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v)
    KEYBLOCK_MEMBERS(23, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w)
    KEYBLOCK_MEMBERS(24, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x)
    KEYBLOCK_MEMBERS(25, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y)
    KEYBLOCK_MEMBERS(26, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z)
    KEYBLOCK_MEMBERS(27, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, aa)
    KEYBLOCK_MEMBERS(28, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, aa, bb)
    static_assert(memberCount<T> < 1, "too many members for membersOf");
}

#undef KEYBLOCK_MEMBERS
// clang-format on

}  // namespace keyblock
