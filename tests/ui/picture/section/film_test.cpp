// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings that must not jump from one picture of an animation to the next.
#include "tests/ui/bricks.h"
#include "ui/picture/section/section_film.h"

#include <gtest/gtest.h>

#include <memory>

namespace keyblock {
namespace {

class Film : public ::testing::Test {
protected:
    Film() : source(run.scene, run.results) {
        request.blocks = findQuantity(blockQuantities(), "sigma1");
        request.bolts = findQuantity(boltQuantities(), "axial_force");
        std::vector<std::size_t> frames;
        for (std::size_t i = 0; i < source.frames().size(); ++i) frames.push_back(i);
        film = std::make_unique<SectionFilm>(source, request, frames);
    }
    test::BricksRun run;
    MemoryRun source;
    SectionRequest request;
    std::unique_ptr<SectionFilm> film;
};

TEST_F(Film, FramesShareWindowRangesAndScale) {
    ASSERT_GE(film->size(), 2U);
    const SectionPicture last = film->picture(film->size() - 1);
    for (std::size_t i = 0; i < film->size(); ++i) {
        const SectionPicture picture = film->picture(i);
        EXPECT_EQ(picture.window.min, last.window.min);
        EXPECT_EQ(picture.window.max, last.window.max);
        EXPECT_EQ(picture.blockLegend->range.low, last.blockLegend->range.low);
        EXPECT_EQ(picture.blockLegend->range.high, last.blockLegend->range.high);
        EXPECT_EQ(picture.boltLegend->range.high, last.boltLegend->range.high);
        ASSERT_TRUE(last.ribbon);
        if (picture.ribbon) {
            EXPECT_EQ(picture.ribbon->scale, last.ribbon->scale);
        }
    }
}

TEST_F(Film, FramesShareTheScaleOfContacts) {
    for (std::size_t i : {0u, 1u}) {
        ContactFrame contact;
        contact.position = {1.0, 1.0};
        contact.normal = {0.0, 1.0};
        contact.state = ContactState::Locked;
        contact.normalForce = i == 0 ? 1e3 : 9e3;
        run.results.frames[i].contacts = {contact};
    }
    request.contacts = true;
    const SectionFilm shown(source, request, {0, 1});
    EXPECT_EQ(shown.picture(0).contacts->scale.longest, 10.0);
    EXPECT_EQ(shown.picture(0).contacts->largest, 1.0);
    EXPECT_EQ(shown.picture(1).contacts->scale.longest, 10.0);
}

TEST_F(Film, AFrameEqualsASinglePicture) {
    for (std::size_t i = 0; i < film->size(); ++i) {
        request.frame = i;
        const SectionPicture alone = sectionPicture(source, request), picture = film->picture(i);
        EXPECT_EQ(picture.title, alone.title);
        ASSERT_EQ(picture.blocks.size(), alone.blocks.size());
        for (std::size_t b = 0; b < alone.blocks.size(); ++b) {
            EXPECT_EQ(picture.blocks[b].outline, alone.blocks[b].outline);
            EXPECT_EQ(picture.blocks[b].value, alone.blocks[b].value);
        }
        EXPECT_EQ(picture.blockLegend->notes, alone.blockLegend->notes);
        EXPECT_LE(picture.window.min.x(), alone.window.min.x());
        EXPECT_GE(picture.window.max.y(), alone.window.max.y());
    }
}

TEST_F(Film, EventsKeepTheirNumber) {
    const SectionPicture last = film->picture(film->size() - 1);
    std::size_t before = 0;
    for (std::size_t i = 0; i < film->size(); ++i) {
        const SectionPicture picture = film->picture(i);
        EXPECT_GE(picture.events.entries.size(), before);
        before = picture.events.entries.size();
        for (const EventEntry& entry : picture.events.entries) {
            const EventEntry& same = last.events.entries.at(static_cast<std::size_t>(entry.number - 1));
            EXPECT_EQ(entry.subject, same.subject);
            EXPECT_EQ(entry.kind, same.kind);
            EXPECT_LE(entry.count, same.count);
        }
    }
}

}  // namespace
}  // namespace keyblock
