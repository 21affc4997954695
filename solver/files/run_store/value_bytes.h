// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact conversion of plain values to bytes and back. Numbers have the machine's own
// representation, so only the build that wrote the bytes may read them. Types for
// which there is no rule here do not compile.
#pragma once

#include "solver/run/members.h"

#include <boost/container/flat_set.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace keyblock {

/// Number of enumerators of an enumeration that counts from 0. An enumeration without it cannot be read.
template <typename E>
inline constexpr int enumeratorCount = -1;

/// Appends values to a string of bytes.
class ValueWriter {
public:
    void put(const PlainNumber auto& number) { append(&number, sizeof number); }
    void put(const FixedMatrix auto& matrix) { append(matrix.data(), sizeof(double) * matrix.size()); }
    void put(const std::string& text) { putAll(text); }
    template <typename T>
    void put(const std::vector<T>& values) { putAll(values); }
    template <typename T>
    void put(const boost::container::flat_set<T>& values) {
        putAll(values);
    }
    template <typename T, std::size_t n>
    void put(const std::array<T, n>& values) {
        for (const T& value : values) put(value);
    }
    template <typename A, typename B>
    void put(const std::pair<A, B>& pair) {
        put(pair.first);
        put(pair.second);
    }
    template <typename T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }
    template <typename T>
        requires std::is_aggregate_v<T>
    void put(const T& value) {
        std::apply([this](const auto&... member) { (put(member), ...); }, membersOf(value));
    }

    const std::string& bytes() const { return bytes_; }

private:
    void append(const void* from, std::size_t size) { bytes_.append(static_cast<const char*>(from), size); }
    void putAll(const auto& values) {
        put(static_cast<std::uint64_t>(values.size()));
        for (const auto& value : values) put(value);
    }

    std::string bytes_;
};

/// Reads values from bytes in the order in which they were written. If the bytes end too early, or if one of them is not
/// a value of its type, `whole()` returns false. Containers grow while their values are read, so that a wrong count takes
/// no more memory than the bytes that follow it.
class ValueReader {
public:
    explicit ValueReader(std::string_view bytes) : left_(bytes) {}

    void get(Arithmetic auto& number) { take(&number, sizeof number); }
    void get(bool& flag) { flag = code(2) == 1; }
    void get(Enumeration auto& value) {
        using E = std::remove_reference_t<decltype(value)>;
        static_assert(enumeratorCount<E> > 0, "state how many enumerators it has");
        value = static_cast<E>(code<std::underlying_type_t<E>>(enumeratorCount<E>));
    }
    void get(FixedMatrix auto& matrix) { take(matrix.data(), sizeof(double) * matrix.size()); }
    void get(std::string& text) {
        std::uint64_t size = 0;
        get(size);
        good_ = good_ && size <= left_.size();
        text = left_.substr(0, good_ ? size : 0);
        left_.remove_prefix(text.size());
    }
    template <typename T>
    void get(std::vector<T>& values) { getAll(values); }
    template <typename T>
    void get(boost::container::flat_set<T>& values) {
        std::vector<T> sorted;
        getAll(sorted);
        values = {sorted.begin(), sorted.end()};
    }
    template <typename T, std::size_t n>
    void get(std::array<T, n>& values) {
        for (T& value : values) get(value);
    }
    template <typename A, typename B>
    void get(std::pair<A, B>& pair) {
        get(pair.first);
        get(pair.second);
    }
    template <typename T>
    void get(std::optional<T>& value) {
        bool there = false;
        get(there);
        value.reset();
        if (there) get(value.emplace());
    }
    template <typename T>
        requires std::is_aggregate_v<T>
    void get(T& value) {
        std::apply([this](auto&... member) { (get(member), ...); }, membersOf(value));
    }

    /// True if all values were read completely and no bytes are left.
    bool whole() const { return good_ && left_.empty(); }

private:
    void take(void* to, std::size_t size) {
        good_ = good_ && size <= left_.size();
        if (!good_) return;
        std::memcpy(to, left_.data(), size);
        left_.remove_prefix(size);
    }
    /// Reads a number from 0 up to, but not including, `end`; 0 if it is another one.
    template <typename N = unsigned char>
    N code(int end) {
        N number = 0;
        take(&number, sizeof number);
        good_ = good_ && number >= 0 && number < end;
        return good_ ? number : N{0};
    }
    void getAll(auto& values) {
        std::uint64_t size = 0;
        get(size);
        values.clear();
        for (std::uint64_t i = 0; i < size && good_; ++i) get(values.emplace_back());
    }

    std::string_view left_;
    bool good_ = true;
};

}  // namespace keyblock
