// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a checkpoint holds comes back bit for bit, whatever members it has: every
// number in it is given a value of its own, found the same way as it is written.
#include "solver/files/run_store/value_bytes.h"

#include "solver/files/run_store/checkpoint_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keyblock {
namespace {

enum class Colour { Red, Green };

}  // namespace

template <>
inline constexpr int enumeratorCount<Colour> = 2;

namespace {

struct Inner {
    double x = 0.0;
    std::optional<int> n;
};

struct Outer {
    Inner inner;
    std::vector<Inner> list;
    std::array<double, 3> three{};
    Eigen::Vector2d point{0.0, 0.0};
    std::string text;
    boost::container::flat_set<std::pair<int, int>> pairs;
    Colour colour = Colour::Red;
    bool flag = false;
    long count = 0;
};

static_assert(memberCount<Inner> == 2);
static_assert(memberCount<Outer> == 9);
static_assert(std::is_same_v<decltype(membersOf(std::declval<const Inner&>())),
                             std::tuple<const double&, const std::optional<int>&>>);

/// Gives every number below a value a count of its own, and every container two entries.
class Filler {
public:
    void fill(Arithmetic auto& number) { number = static_cast<std::remove_reference_t<decltype(number)>>(++count_); }
    void fill(bool& flag) { flag = ++count_ > 0; }
    void fill(Enumeration auto& value) { value = static_cast<std::remove_reference_t<decltype(value)>>(++count_ % 2); }
    void fill(char& letter) { letter = static_cast<char>(++count_ % 100); }
    void fill(FixedMatrix auto& matrix) {
        for (double* value = matrix.data(); value != matrix.data() + matrix.size(); ++value) fill(*value);
    }
    void fill(std::string& text) { text = "text " + std::to_string(++count_); }
    template <typename T>
    void fill(std::vector<T>& values) {
        values.resize(2);
        for (T& value : values) fill(value);
    }
    template <typename T>
    void fill(boost::container::flat_set<T>& values) {
        T first, second;
        fill(first);
        fill(second);
        values = {first, second};
    }
    template <typename T, std::size_t n>
    void fill(std::array<T, n>& values) {
        for (T& value : values) fill(value);
    }
    template <typename A, typename B>
    void fill(std::pair<A, B>& pair) {
        fill(pair.first);
        fill(pair.second);
    }
    template <typename T>
    void fill(std::optional<T>& value) { fill(value.emplace()); }
    template <typename T>
        requires std::is_aggregate_v<T>
    void fill(T& value) {
        std::apply([this](auto&... member) { (fill(member), ...); }, membersOf(value));
    }

    int count() const { return count_; }

private:
    int count_ = 0;
};

TEST(ValueBytes, EveryMemberOfACheckpointComesBack) {
    Checkpoint checkpoint;
    Filler filler;
    filler.fill(checkpoint);
    EXPECT_GT(filler.count(), 300);
    const std::string bytes = bytesOf(checkpoint);
    const std::optional<Checkpoint> back = checkpointOf(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(bytesOf(*back), bytes);
    EXPECT_EQ(back->state.blocks, checkpoint.state.blocks);
    EXPECT_EQ(back->state.contacts, checkpoint.state.contacts);
    EXPECT_EQ(back->state.bolts[1].nodes, checkpoint.state.bolts[1].nodes);
    EXPECT_EQ(back->results, checkpoint.results);
    EXPECT_EQ(back->watch.slipped, checkpoint.watch.slipped);
    EXPECT_NE(bytes, bytesOf(Checkpoint{}));
}

TEST(ValueBytes, NumbersOutOfTheOrdinarySurvive) {
    Outer value;
    value.inner.x = -0.0;
    value.three = {std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::quiet_NaN()};
    value.text = std::string("a\0b", 3);
    value.pairs = {{1, 2}, {-3, 4}};
    value.colour = Colour::Green;
    value.count = std::numeric_limits<long>::min();
    value.list = {{1.0, 5}, {2.0, std::nullopt}};
    ValueWriter writer;
    writer.put(value);
    Outer back;
    ValueReader reader(writer.bytes());
    reader.get(back);
    ASSERT_TRUE(reader.whole());
    EXPECT_TRUE(std::signbit(back.inner.x));
    EXPECT_EQ(back.three[0], value.three[0]);
    EXPECT_EQ(back.three[1], value.three[1]);
    EXPECT_TRUE(std::isnan(back.three[2]));
    EXPECT_EQ(back.text, value.text);
    EXPECT_EQ(back.pairs, value.pairs);
    EXPECT_EQ(back.colour, value.colour);
    EXPECT_EQ(back.count, value.count);
    EXPECT_EQ(back.list[0].n, 5);
    EXPECT_FALSE(back.list[1].n);
}

TEST(ValueBytes, TooFewOrTooManyAreRefused) {
    const std::string bytes = bytesOf(Checkpoint{});
    EXPECT_TRUE(checkpointOf(bytes));
    EXPECT_FALSE(checkpointOf(bytes + "x"));
    for (std::size_t size = 0; size < bytes.size(); size += 7) EXPECT_FALSE(checkpointOf(bytes.substr(0, size)));
    std::string huge(8, '\xFF');  // a container of more entries than there are bytes
    std::vector<double> values;
    ValueReader reader(huge);
    reader.get(values);
    EXPECT_FALSE(reader.whole());
}

template <typename T>
bool isRead(const std::string& bytes) {
    T value{};
    ValueReader reader(bytes);
    reader.get(value);
    return reader.whole();
}

TEST(ValueBytes, FlagsAndEnumeratorsOutOfRangeAreRefused) {
    EXPECT_TRUE(isRead<bool>(std::string(1, '\1')));
    EXPECT_FALSE(isRead<bool>(std::string(1, '\2')));
    EXPECT_FALSE(isRead<std::optional<double>>(std::string("\3", 1) + std::string(8, '\0')));
    EXPECT_TRUE(isRead<Colour>(std::string("\1\0\0\0", 4)));
    EXPECT_FALSE(isRead<Colour>(std::string("\2\0\0\0", 4)));
    EXPECT_FALSE(isRead<Colour>(std::string(4, '\xFF')));
}

/// A count of values that are not there takes no memory for them.
TEST(ValueBytes, AListGrowsAsItsValuesAreRead) {
    std::string bytes(8 + 100, '\0');
    const std::uint64_t many = 100;  // as many as there are bytes; each value takes hundreds of bytes
    std::memcpy(bytes.data(), &many, sizeof many);
    std::vector<std::array<double, 50>> values;
    ValueReader reader(bytes);
    reader.get(values);
    EXPECT_FALSE(reader.whole());
    EXPECT_LE(values.size(), 2u);
}

TEST(ValueBytes, TheBuildHasAName) {
    EXPECT_GE(buildName().size(), 20u) << buildName();
    EXPECT_EQ(buildName(), buildName());
}

}  // namespace
}  // namespace keyblock
