// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/scale_panel.h"

#include "tests/ui/bricks.h"
#include "tests/ui/screen/screen.h"
#include "ui/runs/view_settings.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QTest>

namespace keyblock {
namespace {

class ScalePanelTest : public ::testing::Test {
protected:
    void open(const ShownNumbers& numbers) {
        SectionPicture picture = test::BricksRun().picture(1);
        showAs(picture, numbers);
        panel = new ScalePanel(*picture.blockLegend, numbers, true, settings, nullptr);
        panel->openAt({400, 100});
    }
    ~ScalePanelTest() override { delete panel; }
    ScaleChoice chosen() const { return scaleOf(settings.choice().scales, "sigma1"); }
    void type(const char* field, const QString& text) {
        auto* edit = panel->findChild<QLineEdit*>(field);
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    ViewSettings settings;
    QPointer<ScalePanel> panel;
};

TEST_F(ScalePanelTest, AppliesEveryChoiceAtOnce) {
    NEED_SCREEN();
    open({});
    panel->findChild<QRadioButton*>("scaleFrame")->click();
    EXPECT_EQ(chosen().of, ScaleOf::ThisFrame);
    panel->findChild<QCheckBox*>("scaleClip")->click();
    EXPECT_TRUE(chosen().clips);
    type("scaleFrom", "0,5");
    type("scaleTo", "=2*4");
    EXPECT_EQ(chosen().of, ScaleOf::Own);
    EXPECT_EQ(chosen().own, (ValueRange{0.5, 8.0}));
    panel->findChild<QPushButton*>("scaleDefaults")->click();
    EXPECT_EQ(chosen(), ScaleChoice{});
}

TEST_F(ScalePanelTest, ReadsNumbersInTheUnitsAndSignsShown) {
    NEED_SCREEN();
    open({.si = true, .tensionPositive = true});
    type("scaleFrom", "-3e6");
    type("scaleTo", "0");
    EXPECT_EQ(chosen().own, (ValueRange{0.0, 3.0}));  // MPa of compression
}

TEST_F(ScalePanelTest, MarksFieldsThatCannotBeRead) {
    NEED_SCREEN();
    open({});
    type("scaleTo", "much");
    EXPECT_TRUE(panel->findChild<QLineEdit*>("scaleTo")->property("invalid").toBool());
    EXPECT_NE(chosen().of, ScaleOf::Own);
}

}  // namespace
}  // namespace keyblock
