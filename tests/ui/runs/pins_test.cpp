// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pins read the frames of their run once, in the background, and give the values of a
// monitor at the same point.
#include "ui/look/display.h"
#include "ui/runs/pinned_values.h"

#include "tests/scratch_folder.h"
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"
#include "tests/wait_for.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/picture/section/section.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/comparison.h"
#include "ui/runs/section_feed.h"
#include "ui/runs/time_cursor.h"
#include "ui/runs/view_settings.h"

#include <QAbstractEventDispatcher>

namespace keyblock {
namespace {

class PinsTest : public ::testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }
    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    test::ScratchFolder folder_;
};

/// At the monitor of the sample, on the sliding block.
Pin pinOf(const LiveRun& run, std::string_view quantity) {
    SectionRequest request;
    request.frame = 0;
    const auto picture = std::make_shared<const SectionPicture>(sectionPicture(run, request));
    const Point place = *run.scene().monitors.front().point;
    const auto pick = PickIndex(picture).at(place, 0.01);
    EXPECT_TRUE(pick);
    return pinAt(*picture, *pick, place, findQuantity(blockQuantities(), quantity), nullptr);
}

TEST_F(PinsTest, APinGivesTheValuesOfAMonitorAtTheSamePoint) {
    TimeCursor cursor;
    Pins pins(cursor);
    const auto run = test::slidingRun(path("a.kbrun"), 0.5);
    cursor.setRun(run, false);
    EXPECT_TRUE(pins.isComplete());  // without pins nothing is read
    EXPECT_EQ(pins.add(pinOf(*run, "ux")), 1);
    EXPECT_EQ(pins.add(pinOf(*run, "uy")), 2);
    ASSERT_TRUE(waitFor([&] { return pins.isComplete(); }));
    const std::vector<double>& values = pins.tracks()[0]->values();
    ASSERT_EQ(values.size(), run->frames().size());
    for (std::size_t i = 0; i < values.size(); ++i)
        for (const HistoryRow& row : run->history()) {
            const bool isSame = row.stage == run->frames()[i].stage && row.step == run->frames()[i].step;
            if (isSame) {
                EXPECT_NEAR(values[i], 1e3 * row.values[0], 1e-3) << i;
            }
        }
    EXPECT_GT(values.back(), 100.0);  // mm
    pins.remove(1);
    EXPECT_EQ(pins.add(pinOf(*run, "vx")), 1);  // the number is free again
    EXPECT_EQ(pins.pins().front().number, 2);
}

TEST_F(PinsTest, PinsStayForARunOfTheSameBlocksAndAreRemovedWithTheRun) {
    TimeCursor cursor;
    Pins pins(cursor);
    const auto run = test::slidingRun(path("a.kbrun"), 0.2);
    cursor.setRun(run, false);
    pins.add(pinOf(*run, "ux"));
    ASSERT_TRUE(waitFor([&] { return pins.isComplete(); }));
    const double before = pins.tracks()[0]->values().back();
    cursor.setRun(test::slidingRun(path("b.kbrun"), 0.4), false);
    ASSERT_EQ(pins.tracks().size(), 1u);
    ASSERT_TRUE(waitFor([&] { return pins.isComplete(); }));
    EXPECT_GT(pins.tracks()[0]->values().back(), 3.0 * before);
    cursor.setRun(nullptr, false);
    EXPECT_TRUE(pins.tracks().empty());
}

TEST_F(PinsTest, ADeletedStoreIsReported) {
    TimeCursor cursor;
    Pins pins(cursor);
    QString message;
    QObject::connect(&pins, &Pins::failed, &pins, [&](const QString& text) { message = text; });
    auto run = test::slidingRun(path("a.kbrun"), 0.2);
    const Pin pin = pinOf(*run, "ux");
    run = LiveRun::opened(path("a.kbrun"));
    std::filesystem::resize_file(path("a.kbrun"), 5000);
    cursor.setRun(run, false);
    pins.add(pin);
    EXPECT_TRUE(waitFor([&] { return !message.isEmpty() || pins.isComplete(); }));
}

TEST_F(PinsTest, ASecondRunFollowsTheFirstByTime) {
    TimeCursor cursor;
    Comparison comparison(cursor);
    test::slidingRun(path("long-2.kbrun"), 0.4);
    const QString store = QString::fromStdString(path("long-2.kbrun").string());
    EXPECT_EQ(runTitle(store), QString::fromUtf8("Run 2 · long"));
    EXPECT_EQ(runTitle("/a/drift.kbrun"), "drift");
    QString message;
    QObject::connect(&comparison, &Comparison::failed, &comparison, [&](const QString& text) { message = text; });
    cursor.setRun(test::slidingRun(path("short.kbrun"), 0.2), false);
    comparison.begin("/nowhere/none.kbrun");
    ASSERT_TRUE(waitFor([&] { return !message.isEmpty(); }));
    EXPECT_FALSE(comparison.isOn());
    comparison.begin(store);
    ASSERT_TRUE(waitFor([&] { return comparison.isOn(); }));
    EXPECT_EQ(comparison.store(), store);
    cursor.goTo(StageTime{0, 0.08});
    EXPECT_DOUBLE_EQ(comparison.second().head().time, 0.08);
    EXPECT_NE(comparison.second().frame(), cursor.frame());
    cursor.home();
    EXPECT_EQ(comparison.second().frame(), 0u);
    comparison.end();
    EXPECT_FALSE(comparison.isOn());
    settle();
    comparison.begin(store);
    ASSERT_TRUE(test::waitFor([] { return QCoreApplication::eventDispatcher()->hasPendingEvents(); }));
    cursor.setRun(nullptr, false);  // the document is replaced once the run is read, before it is shown
    message.clear();
    comparison.begin("/nowhere/none.kbrun");  // its failure is reported after the run
    ASSERT_TRUE(waitFor([&] { return !message.isEmpty(); }));
    EXPECT_FALSE(comparison.isOn());
}

TEST_F(PinsTest, TwoRunsHaveOneRangeOfColours) {
    Selection selection;
    ViewSettings settings;
    ViewChoice choice;
    choice.blocks = findQuantity(blockQuantities(), "displacement");
    settings.choose(choice);
    TimeCursor first, second;
    Document document;
    BoltChoice bolts(document, selection, first);
    Display display;
    SectionFeed a(bolts, first, settings, display), b(bolts, second, settings, display);
    const auto slow = test::slidingRun(path("a.kbrun"), 0.2), fast = test::slidingRun(path("b.kbrun"), 0.6);
    first.setRun(slow, false);
    second.setRun(fast, false);
    const auto rangeOf = [](const SectionFeed& feed) {
        return feed.picture() && feed.picture()->blockLegend ? feed.picture()->blockLegend->range : ValueRange{0.0, 0.0};
    };
    // Ranges of a first frame are corrected once all frames are read: wait for the final ones.
    ASSERT_TRUE(waitFor([&] { return rangeOf(a).high > 0.0 && rangeOf(b).high > rangeOf(a).high; }));
    a.shareRanges(fast, true);
    b.shareRanges(slow, false);
    ASSERT_TRUE(waitFor([&] { return rangeOf(a).high > 0.0 && rangeOf(a) == rangeOf(b); }));
    a.shareRanges(nullptr, true);
    ASSERT_TRUE(waitFor([&] { return rangeOf(a).high > 0.0 && rangeOf(a).high < rangeOf(b).high; }));
}

}  // namespace
}  // namespace keyblock
