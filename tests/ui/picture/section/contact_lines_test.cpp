// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact forces as lines: their direction, their scale, and which are omitted if there
// are many.
#include "ui/picture/section/contact_lines.h"

#include "tests/ui/bricks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

using namespace test;

ContactFrame contactAt(const Point& place, double normalForce, ContactState state = ContactState::Locked) {
    ContactFrame contact;
    contact.blockA = 1;
    contact.blockB = 0;
    contact.position = place;
    contact.normal = {0.0, 1.0};
    contact.normalForce = normalForce;
    contact.state = state;
    return contact;
}

const Box everything{{-100.0, -100.0}, {100.0, 100.0}};

std::vector<Point> placesOf(const Frame& frame) {
    std::vector<Point> places;
    for (const ContactFrame& contact : frame.contacts) places.push_back(contact.position);
    return places;
}

TEST(ContactLines, FollowTheResultantOfNormalAndShear) {
    ContactFrame contact = contactAt({1.0, 2.0}, 4e3, ContactState::Sliding);
    contact.shearForce = 3e3;
    const ContactLine line = contactLine(contact);
    EXPECT_EQ(line.kind, ContactKind::Sliding);
    EXPECT_NEAR((line.force - Point(3.0, 4.0)).norm(), 0.0, 1e-12);  // kN, block a is pushed up and to the right
}

TEST(ContactLines, ABondInTensionIsItsOwnKind) {
    EXPECT_EQ(contactLine(contactAt({0, 0}, 1.0, ContactState::Bonded)).kind, ContactKind::Bonded);
    EXPECT_EQ(contactLine(contactAt({0, 0}, -1.0, ContactState::Bonded)).kind, ContactKind::Pulled);
}

TEST(ContactLines, TheLongestLineCoversAllButTheLargestForces) {
    EXPECT_EQ(longestOf({}), 0.0);
    EXPECT_EQ(longestOf({3.0}), 5.0);  // a round number
    std::vector<double> sizes(1000, 4.0);
    sizes.push_back(40.0);  // carries 1 % of the sum
    EXPECT_EQ(longestOf(sizes), 5.0);
    EXPECT_EQ(longestOf({4.0, 4.0, 40.0}), 50.0);
}

TEST(ContactLines, AllFramesShareTheScale) {
    Frame first, second;
    first.contacts = {contactAt({0, 0}, 5e3), contactAt({0, 0}, 0.0, ContactState::Open)};
    second.contacts = {contactAt({0, 0}, 20e3, ContactState::Sliding)};
    ContactScale scale;
    std::vector<double> sizes;
    widen(scale, first, sizes);
    widen(scale, second, sizes);
    EXPECT_EQ(scale.largest, 20.0);
    EXPECT_EQ(sizes, (std::vector<double>{5.0, 20.0}));
    EXPECT_EQ(scale.kinds, (std::vector<ContactKind>{ContactKind::Locked, ContactKind::Sliding}));
}

TEST(ContactLines, LargestForcesAreDrawnLastAndOpenContactsOmitted) {
    Frame frame;
    frame.contacts = {contactAt({0, 0}, 9e3), contactAt({1, 0}, 2e3), contactAt({2, 0}, 0.0, ContactState::Open),
                      contactAt({500, 0}, 3e3)};
    const ContactField field =
        seenWithin(contactField({10.0, 9.0, 50.0, {ContactKind::Locked}}, frame, placesOf(frame)), everything);
    ASSERT_EQ(field.lines.size(), 2u);
    EXPECT_EQ(field.lines[0].force, Point(0.0, 2.0));
    EXPECT_EQ(field.lines[1].force, Point(0.0, 9.0));
    EXPECT_EQ(field.largest, 9.0);
    EXPECT_EQ(field.notes.back(), "all 2 contacts in view drawn");
}

TEST(ContactLines, InvisiblySmallForcesAreOmittedWithANote) {
    Frame frame;
    frame.contacts = {contactAt({0, 0}, 9e3), contactAt({1, 0}, 50.0)};
    const ContactField field = seenWithin(contactField({10.0, 9.0, 50.0, {}}, frame, placesOf(frame)), everything);
    ASSERT_EQ(field.lines.size(), 1u);
    EXPECT_EQ(field.notes.back(), "1 of 2 contacts in view drawn: forces below 0.1 kN omitted");
}

/// 200 m · 200 m of blocks of 1 m: squares of √(40 000/1500) = 5.2 m, rounded up to 5.2 m: 40 from −20 to 19.
TEST(ContactLines, AmongManyTheLargestOfEachSquareIsKept) {
    Frame frame;
    for (int x = -100; x < 100; ++x)
        for (int y = -100; y < 100; ++y)
            frame.contacts.push_back(contactAt({x + 0.5, y + 0.5}, x == -97 && y == -97 ? 9e3 : 1e3));
    const ContactField field = seenWithin(contactField({10.0, 9.0, 1.0, {}}, frame, placesOf(frame)), everything);
    EXPECT_EQ(field.lines.size(), 1600u);
    EXPECT_EQ(field.lines.back().place, Point(-96.5, -96.5));
    EXPECT_EQ(field.notes.back(), "1600 of 40\u2009000 contacts in view drawn: only the largest of each 5.2 m square");
}

TEST(ContactLines, AreDrawnAtTheirBlocks) {
    BricksRun bricks;
    bricks.results.frames[1].contacts = {contactAt({0.0, 1.01}, 9e3)};  // at a corner of the brick that was lifted
    const MemoryRun run(bricks.scene, bricks.results);
    SectionRequest request;
    request.frame = 1;
    request.contacts = true;
    request.factor = 20.0;
    request.whole = true;
    const SectionPicture picture = sectionPicture(run, request);
    ASSERT_TRUE(picture.contacts);
    ASSERT_EQ(picture.contacts->lines.size(), 1u);
    EXPECT_NEAR((picture.contacts->lines[0].place - Point(0.0, 1.2)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(picture.contacts->scale.spacing, std::sqrt((4.0 + 2.0 + 1.0) / 3.0), 1e-12);
    EXPECT_EQ(picture.contacts->scale.longest, 10.0);
    request.contacts = false;
    EXPECT_FALSE(sectionPicture(run, request).contacts);
}

}  // namespace
}  // namespace keyblock
