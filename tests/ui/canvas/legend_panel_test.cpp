// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which parts of the legend are shown on a low canvas.
#include "ui/canvas/legend_panel.h"

#include "tests/ui/bricks.h"
#include "tests/ui/screen/screen.h"
#include "ui/look/theme.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

ArrowField arrowsWithNotes() {
    ArrowField arrows;
    arrows.title = "Displacement";
    arrows.unit = "mm";
    arrows.notes = {"since the start of the run"};
    arrows.marks.resize(1);
    arrows.largest = 2.0;
    return arrows;
}

ContactField contactsWithNotes() {
    ContactField contacts;
    contacts.scale = {10.0, 25.0, 1.0, {ContactKind::Locked, ContactKind::Sliding, ContactKind::Bonded}};
    contacts.notes = {"all 40 contacts in view drawn", "resultant of normal and shear force; open contacts have none"};
    return contacts;
}

TEST(LegendPanel, LeavesOutNotesOfForcesBeforeTheBoltScaleAndTheKey) {
    NEED_SCREEN();
    const Themes themes;
    const Theme& theme = themes.current();
    SectionPicture picture = test::BricksRun().picture(1);
    picture.arrows = arrowsWithNotes();
    const ContactField contacts = contactsWithNotes();
    const LegendContent content{picture, &contacts, {MarkKind::Bonded}};
    const auto heightOn = [&](double canvas) { return legendRect(theme, content, {800.0, canvas}).height(); };
    const double whole = heightOn(2000.0), withoutNotes = heightOn(whole);
    EXPECT_LT(withoutNotes, whole);
    EXPECT_EQ(heightOn(withoutNotes + 20.0), withoutNotes);  // every entry fits
    for (double height = 320.0; height < whole; height += 10.0) {
        const QRectF bolts = legendPartRect(theme, content, {800.0, height}, LegendPart::Bolts);
        EXPECT_FALSE(bolts.isEmpty()) << height;
        EXPECT_LE(heightOn(height), height - 20.0);
    }
}

}  // namespace
}  // namespace keyblock
