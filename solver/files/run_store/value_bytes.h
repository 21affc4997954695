// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact conversion of plain values to bytes and back. Numbers have the machine's own
// representation, so only the build that wrote the bytes may read them. Types for
// which there is no rule here do not compile.
#pragma once

#include "solver/files/run_store/members.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace keyblock {

template <typename T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <typename T>
concept FixedMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T> && T::SizeAtCompileTime > 0;

/// Appends values to a string of bytes.
class ValueWriter {
public:
    void put(const PlainNumber auto& number) { append(&number, sizeof number); }
    void put(const FixedMatrix auto& matrix) { append(matrix.data(), sizeof(double) * matrix.size()); }
    void put(const std::string& text) { putAll(text); }
    template <typename T>
    void put(const std::vector<T>& values) { putAll(values); }
    template <typename T>
    void put(const std::set<T>& values) { putAll(values); }
    template <typename K, typename T>
    void put(const std::map<K, T>& values) { putAll(values); }
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

/// Reads values from bytes in the order in which they were written. If the bytes end too early, `whole()` returns
/// false.
class ValueReader {
public:
    explicit ValueReader(std::string_view bytes) : left_(bytes) {}

    void get(PlainNumber auto& number) { take(&number, sizeof number); }
    void get(FixedMatrix auto& matrix) { take(matrix.data(), sizeof(double) * matrix.size()); }
    void get(std::string& text) { getAll(text); }
    template <typename T>
    void get(std::vector<T>& values) { getAll(values); }
    template <typename T>
    void get(std::set<T>& values) {
        std::vector<T> sorted;
        getAll(sorted);
        values = {sorted.begin(), sorted.end()};
    }
    template <typename K, typename T>
    void get(std::map<K, T>& values) {
        std::vector<std::pair<K, T>> sorted;
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
    void getAll(auto& values) {
        std::uint64_t size = 0;
        get(size);
        good_ = good_ && size <= left_.size();  // every value takes at least one byte
        values.clear();
        if (good_) values.resize(size);
        for (auto& value : values) get(value);
    }

    std::string_view left_;
    bool good_ = true;
};

}  // namespace keyblock
