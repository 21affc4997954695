// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields show, accept and reset values as expected, and every field of every sample
// reads back its own value.
#include "tests/ui/panels/form_bench.h"

#include "solver/scene/pointer.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/value_text.h"
#include "ui/panels/properties/property_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QToolButton>
#include <QWheelEvent>

#include <cmath>

namespace keyblock {
namespace {

QString problemOf(FormRowWidget& row) {
    for (const QLabel* label : row.findChildren<QLabel*>())
        if (label->property("role") == "problem" && label->isVisible()) return label->text();
    return {};
}

TEST(FieldForm, TypedValueIsOneUndoStep) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    const Scene before = *bench.document.scene();
    bench.choose({"/joint_sets/0"});
    bench.type("spacing", "1.25");
    EXPECT_EQ(bench.document.scene()->jointSets[0].spacing, 1.25);
    EXPECT_EQ(bench.document.undo().count(), 1);
    EXPECT_EQ(bench.document.undo().undoText().toStdString(), "Set spacing of " + before.jointSets[0].name);
    bench.document.undo().undo();
    EXPECT_EQ(*bench.document.scene(), before);
}

TEST(FieldForm, ExpressionsUnitsAndDecimalCommasAreAccepted) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/joint_sets/0"});
    bench.type("spacing", "=5/2+0.1");
    EXPECT_NEAR(bench.document.scene()->jointSets[0].spacing, 2.6, 1e-15);
    bench.type("spacing", "900mm");
    EXPECT_EQ(bench.document.scene()->jointSets[0].spacing, 0.9);
    bench.type("spacing", "1,75");
    EXPECT_EQ(bench.document.scene()->jointSets[0].spacing, 1.75);
    EXPECT_EQ(bench.line("spacing")->text(), "1.75");
}

TEST(FieldForm, NumbersAreShownAndTypedInDisplayUnits) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    const std::string material = bench.document.scene()->materials[0].first;
    bench.choose({"/materials/" + material});
    bench.type("youngs_modulus", "47.3");
    EXPECT_EQ(bench.document.scene()->materials[0].second.youngsModulus, 47.3e9);
    bench.type("youngs_modulus", "60 GPa");
    EXPECT_EQ(bench.document.scene()->materials[0].second.youngsModulus, 60e9);
    bench.display.setSystem(UnitSystem::Si);
    bench.form.refresh();
    bench.type("youngs_modulus", "5.5e10");
    EXPECT_EQ(bench.document.scene()->materials[0].second.youngsModulus, 5.5e10);
    EXPECT_EQ(Display::number(-0.0), "0");
    EXPECT_EQ(Display::number(1000.0, 3), "1\u2009000");
    EXPECT_EQ(Display::number(-195312.0, 4), "\u2212195\u2009300");
    EXPECT_EQ(Display::number(2.5e7, 3), "2.5e7");
}

TEST(FieldForm, ArrowOpensTheTypeOfABolt) {
    NEED_SCREEN();
    FormBench bench(sampleScene("rebar-20"));
    bench.choose({"/bolts/0"});
    QString asked;
    QObject::connect(&bench.form, &FieldForm::targetAsked, &bench.form, [&](const QString& pointer) { asked = pointer; });
    auto* arrow = bench.row("type")->findChild<QToolButton*>("target");
    ASSERT_TRUE(arrow && arrow->isVisible());
    QTest::mouseClick(arrow, Qt::LeftButton);
    EXPECT_EQ(asked.toStdString(), "/bolt_types/" + bench.document.scene()->bolts[0].type);
    EXPECT_FALSE(bench.row("plate")->findChild<QToolButton*>("target")->isVisible()) << "the field names no object";
}

TEST(FieldForm, NumericalSettingsAreClosedAtFirst) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({""});
    EXPECT_TRUE(bench.row("analysis/gravity")->isVisible());
    EXPECT_FALSE(bench.row("analysis/penalty_ratio")->isVisible());
    EXPECT_FALSE(bench.row("analysis/rho_inf") && bench.row("analysis/rho_inf")->isVisible());
    bench.form.setFilter("penalty");
    settle();  // the rows before are deleted
    EXPECT_TRUE(bench.row("analysis/penalty_ratio")->isVisible());
}

TEST(FieldForm, LongNamesDoNotHideTheFields) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.boltPatterns[0].name = "Systematic roof bolting, chainage 1+240 to 1+310, second round & relaxation";
    for (Stage& stage : scene.stages) stage.install.clear();
    FormBench bench(scene);
    bench.choose({"/stages/1"});
    FormRowWidget* name = bench.row("name");
    ASSERT_TRUE(name && bench.row("install"));
    EXPECT_LE(bench.form.minimumSizeHint().width(), 300);
    for (FormRowWidget* row : bench.form.findChildren<FormRowWidget*>())
        EXPECT_LE(row->mapTo(&bench.form, QPoint(row->width(), 0)).x(), bench.form.width())
            << row->objectName().toStdString();
    const auto ticks = bench.row("install")->findChildren<QCheckBox*>();
    ASSERT_FALSE(ticks.empty());
    EXPECT_EQ(ticks[0]->toolTip().toStdString(), scene.boltPatterns[0].name);
    EXPECT_LT(ticks[0]->text().size(), static_cast<int>(scene.boltPatterns[0].name.size()));
}

TEST(FieldForm, StressInputAndOutputFollowTheSignConvention) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.inSituStress = InSituStress{};
    FormBench bench(scene);
    const auto stress = [&] { return bench.document.scene()->inSituStress->sxx; };
    const auto label = [&] { return bench.row("sxx")->findChild<QLabel*>()->text().toStdString(); };
    bench.display.setCompressionPositive(true);
    bench.choose({"/in_situ_stress"});
    EXPECT_EQ(label(), "σxx (compression +)");
    bench.type("sxx", "5");
    EXPECT_EQ(stress(), -5e6);
    EXPECT_EQ(bench.line("sxx")->text(), "5");
    bench.type("sxx", "0");
    EXPECT_FALSE(std::signbit(stress()));
    bench.document.undo().undo();
    bench.form.refresh();
    EXPECT_EQ(stress(), -5e6);
    EXPECT_EQ(bench.line("sxx")->text(), "5");
    bench.line("sxx")->setFocus();
    bench.line("sxx")->selectAll();
    QApplication::clipboard()->setText("7.5 MPa");
    QTest::keyClick(bench.line("sxx"), Qt::Key_V, Qt::ControlModifier);
    QTest::keyClick(bench.line("sxx"), Qt::Key_Return);
    QCoreApplication::processEvents();
    EXPECT_EQ(stress(), -7.5e6);
    bench.display.setCompressionPositive(false);
    bench.form.refresh();
    EXPECT_EQ(label(), "σxx (tension +)");
    EXPECT_EQ(bench.line("sxx")->text().toStdString(), "−7.5");
    bench.type("sxx", "5");
    EXPECT_EQ(stress(), 5e6);
    bench.display.setCompressionPositive(true);
}

TEST(PropertyPanel, HeaderFollowsTheSignConvention) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.inSituStress = InSituStress{};
    scene.inSituStress->sxx = scene.inSituStress->syy = -5e6;
    FormBench bench(scene);
    bench.display.setCompressionPositive(true);
    Selection selection;
    PropertyPanel panel(bench.context, selection);
    selection.set({"/in_situ_stress"});
    QCoreApplication::processEvents();
    const auto detail = [&] { return panel.findChild<QLabel*>("propertyDetail")->text().toStdString(); };
    EXPECT_EQ(detail(), "5 / 5 MPa");
    bench.display.setCompressionPositive(false);
    EXPECT_EQ(detail(), "−5 / −5 MPa");
    bench.display.setCompressionPositive(true);
}

TEST(FieldForm, StressOfSeveralBlocksFollowsTheSignConvention) {
    NEED_SCREEN();
    Scene two = sampleScene("rebar-20");
    ASSERT_EQ(two.blocks.size(), 2u);
    FormBench blocks(two);
    blocks.display.setCompressionPositive(true);
    blocks.choose({"/blocks/0", "/blocks/1"});
    blocks.type("initial_stress", "1, 2, 0");
    for (const Block& block : blocks.document.scene()->blocks) EXPECT_EQ(block.initialStress, (Stress{-1e6, -2e6, 0.0}));
    EXPECT_EQ(blocks.line("initial_stress")->text(), "1, 2, 0");
}

TEST(FieldForm, ValueOutOfRangeIsRefusedAndStaysInTheField) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    const Scene before = *bench.document.scene();
    bench.choose({"/joint_sets/0"});
    bench.type("spacing", "-2");
    EXPECT_EQ(*bench.document.scene(), before);
    EXPECT_EQ(bench.line("spacing")->text(), "-2");
    EXPECT_TRUE(bench.line("spacing")->property("invalid").toBool());
    EXPECT_TRUE(problemOf(*bench.row("spacing")).contains("out of range"))
        << problemOf(*bench.row("spacing")).toStdString();
    bench.type("spacing", "wide");
    EXPECT_FALSE(problemOf(*bench.row("spacing")).isEmpty());
    QTest::keyClick(bench.line("spacing"), Qt::Key_Escape);
    EXPECT_TRUE(problemOf(*bench.row("spacing")).isEmpty());
    EXPECT_EQ(bench.document.undo().count(), 0);
}

TEST(FieldForm, CommandUsesTextBeingTyped) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    Commands commands(bench.themes);
    double seen = 0.0;
    QAction* save = commands.add({"save", "Save", {}, {}, {}},
                                 [&] { seen = bench.document.scene()->jointSets[0].spacing; });
    bench.choose({"/joint_sets/0"});
    QLineEdit* spacing = bench.line("spacing");
    spacing->setFocus();
    spacing->selectAll();
    QTest::keyClicks(spacing, "7");
    save->trigger();
    EXPECT_EQ(seen, 7.0);
    EXPECT_TRUE(spacing->hasFocus());
    EXPECT_EQ(bench.document.undo().count(), 1);
}

TEST(FieldForm, WheelScrollsPastAComboBox) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/tunnels/0"});
    auto* profile = bench.row("profile")->editor().findChild<QComboBox*>();
    ASSERT_TRUE(profile);
    EXPECT_EQ(profile->focusPolicy() & Qt::WheelFocus & ~Qt::StrongFocus, 0) << "the wheel must not give it the focus";
    QWheelEvent wheel({5, 5}, profile->mapToGlobal({5, 5}), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(profile, &wheel);
    EXPECT_EQ(bench.document.undo().count(), 0);
}

TEST(FieldForm, TickingByKeysKeepsTheFocus) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/stages/0"});
    auto* tick = bench.row("install")->editor().findChild<QCheckBox*>();
    ASSERT_TRUE(tick);
    tick->setFocus();
    QTest::keyClick(tick, Qt::Key_Space);
    QCoreApplication::processEvents();
    EXPECT_EQ(bench.document.undo().count(), 1);
    EXPECT_TRUE(qobject_cast<QCheckBox*>(QApplication::focusWidget()));
}

TEST(FieldForm, SeveralObjectsShowMixedValuesAndAreSetTogether) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/joint_sets/0", "/joint_sets/1"});
    ASSERT_TRUE(bench.line("dip"));
    EXPECT_TRUE(bench.line("dip")->text().isEmpty());
    EXPECT_EQ(bench.line("dip")->placeholderText(), "mixed");
    EXPECT_TRUE(bench.line("dip")->font().italic());
    EXPECT_FALSE(bench.row("name"));
    bench.type("dip", "40");
    EXPECT_EQ(bench.document.scene()->jointSets[0].dip, 40.0);
    EXPECT_EQ(bench.document.scene()->jointSets[1].dip, 40.0);
    EXPECT_EQ(bench.document.undo().count(), 1);
    EXPECT_EQ(bench.document.undo().undoText(), "Set dip of 2 joint sets");
}

TEST(FieldForm, FieldsThatDoNotApplyAreNotShown) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/tunnels/0"});
    EXPECT_TRUE(bench.row("width"));
    EXPECT_FALSE(bench.row("diameter"));
}

TEST(FieldForm, ChangedFieldsHaveAResetArrow) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/joint_sets/0"});
    bench.type("seed", "99");
    auto* reset = bench.row("seed")->findChild<QWidget*>("reset");
    ASSERT_TRUE(reset && reset->isVisible());
    QTest::mouseClick(reset, Qt::LeftButton);
    EXPECT_EQ(bench.document.scene()->jointSets[0].seed, SceneJointSet{}.seed);
    QCoreApplication::processEvents();
    EXPECT_FALSE(reset->isVisible());
}

TEST(FieldForm, RenamingUpdatesReferences) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    const std::string old = bench.document.scene()->materials[0].first;
    Selection selection;
    selection.follow(bench.document);
    selection.set({QString::fromStdString("/materials/" + old)});
    bench.choose({"/materials/" + old});
    bench.type("name", "gneiss");
    EXPECT_EQ(bench.document.scene()->materials[0].first, "gneiss");
    EXPECT_EQ(bench.document.scene()->domain->material, "gneiss");
    EXPECT_EQ(selection.pointers(), QStringList{"/materials/gneiss"});
}

TEST(FieldForm, EmptyFieldMeansAutomaticIfAllowed) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/bolt_patterns/0"});
    bench.type("divisions", "40");
    EXPECT_EQ(bench.document.scene()->boltPatterns[0].divisions, 40);
    bench.type("divisions", "auto");
    EXPECT_FALSE(bench.document.scene()->boltPatterns[0].divisions);
    EXPECT_TRUE(bench.line("spacing_out_of_plane")->placeholderText().startsWith("auto ("));
}

TEST(FieldForm, EmptyFieldShowsWhatARunUses) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/stages/0"});
    EXPECT_EQ(bench.line("until/max_steps")->placeholderText().toStdString(), "auto (20\u2009000)");
    EXPECT_EQ(bench.line("until/smallest")->placeholderText().toStdString(), "auto (0.01)");
    EXPECT_EQ(bench.line("until/move")->placeholderText().toStdString(), "no limit");
    bench.choose({"/joint_sets/0"});
    EXPECT_EQ(bench.line("trace_length")->placeholderText().toStdString(), "through-going");
    auto* region = bench.row("region")->editor().findChild<QComboBox*>();
    ASSERT_TRUE(region);
    EXPECT_EQ(region->itemText(0).toStdString(), "whole domain");
}

TEST(FieldForm, ChoicesAreShownInWordsForPeople) {
    NEED_SCREEN();
    FormBench bench(sampleScene("drift-bolted"));
    bench.choose({"/tunnels/0"});
    auto* profile = bench.row("profile")->editor().findChild<QComboBox*>();
    ASSERT_TRUE(profile);
    EXPECT_EQ(profile->currentText(), "D-shape");
    bench.choose({"/bolt_patterns/0"});
    auto* way = bench.row("way")->editor().findChild<QComboBox*>();
    ASSERT_TRUE(way);
    EXPECT_EQ(way->currentText(), "counter-clockwise");
}

/// All objects of a scene that a form can show, including items of nested lists.
void collect(const Structure& structure, const void* object, const std::string& pointer,
             std::vector<std::string>& all) {
    all.push_back(pointer);
    for (const Field& field : structure.fields) {
        if (!hasChildren(field) || field.children.isNull(object)) continue;
        for (std::size_t i = 0; i < field.children.count(object); ++i) {
            std::string place = under(pointer, field.key);
            if (field.kind == FieldKind::List) place = under(place, i);
            if (field.kind == FieldKind::Map) place = under(place, field.children.name(object, i));
            collect(field.children.structure(), field.children.item(object, i), place, all);
        }
    }
}

bool isLine(FieldKind kind) {
    return kind == FieldKind::Number || kind == FieldKind::Integer || kind == FieldKind::Vector ||
           kind == FieldKind::Axis || kind == FieldKind::Triple || kind == FieldKind::Place || kind == FieldKind::Text;
}

TEST(FieldForm, EveryFieldOfEverySampleReadsBackFromItsOwnText) {
    NEED_SCREEN();
    FormBench bench(Scene{});
    std::size_t fields = 0;
    for (const auto& file : std::filesystem::directory_iterator(KEYBLOCK_SAMPLES_DIR)) {
        if (file.path().extension() != ".json") continue;
        const Scene scene = sampleScene(file.path().stem().string());
        std::vector<std::string> pointers;
        collect(sceneStructure(), &scene, "", pointers);
        for (const std::string& pointer : pointers)
            for (const FormGroup& group : formGroups(scene, {pointer}))
                for (const FormRow& row : group.rows) {
                    if (row.renames || !isLine(row.field->kind)) continue;
                    const std::string_view unit = unitOf(row.at, *row.field);
                    const QString text = valueText(row.value, *row.field, unit, bench.display, true);
                    const auto back = readValue(text, *row.field, unit, bench.display);
                    ++fields;
                    ASSERT_TRUE(back.value) << file.path() << ' ' << row.pointers[0] << " '" << text.toStdString()
                        << "' "
                                            << back.problem.toStdString();
                    const bool bothEmpty = row.field->emptyIsNull && text.isEmpty();
                    EXPECT_TRUE(bothEmpty || *back.value == row.value) << file.path() << ' ' << row.pointers[0] << ' '
                        << text.toStdString();
                }
    }
    EXPECT_GT(fields, 2000u);
}

TEST(FieldForm, EnteringTheShownValueChangesNothing) {
    NEED_SCREEN();
    FormBench bench(sampleScene("burst-dbolt"));
    const Scene before = *bench.document.scene();
    std::vector<std::string> pointers;
    collect(sceneStructure(), &before, "", pointers);
    for (const std::string& pointer : pointers) {
        bench.choose({pointer});
        for (QLineEdit* line : bench.form.findChildren<QLineEdit*>()) {
            if (!line->isVisible()) continue;
            line->setFocus();
            QTest::keyClick(line, Qt::Key_Return);
        }
    }
    EXPECT_EQ(*bench.document.scene(), before);
    EXPECT_EQ(bench.document.undo().count(), 0);
}

struct UnitCase {
    const char* sample;
    const char* pointer;
    const char* path;
    const char* unit;
};

TEST(FieldForm, UnitsAreShownNextToNumbers) {
    NEED_SCREEN();
    const UnitCase cases[] = {
        {"drift-bolted", "/joint_sets/0", "spacing", "m"},
        {"drift-bolted", "/joint_sets/0", "dip", "°"},
        {"drift-bolted", "/materials/granite", "youngs_modulus", "GPa"},
        {"drift-bolted", "/materials/granite", "density", "kg/m³"},
        {"drift-bolted", "/materials/granite", "poissons_ratio", ""},
        {"drift-bolted", "/bolt_patterns/0", "pretension", "kN"},
        {"drift-bolted", "/bolt_patterns/0", "angle_from_wall", "°"},
        {"rebar-stated", "/bolt_types/rebar-20-paper/anchors/0", "stiffness", "kN/m"},
        {"drift-bolted", "/analysis", "gravity", "m/s²"}};
    for (const UnitCase& one : cases) {
        FormBench bench(sampleScene(one.sample));
        bench.choose({one.pointer});
        FormRowWidget* row = bench.row(one.path);
        ASSERT_TRUE(row) << one.pointer << ' ' << one.path;
        QString unit;
        for (const QLabel* label : row->findChildren<QLabel*>())
            if (label->property("role") == "unit") unit = label->text();
        EXPECT_EQ(unit.toStdString(), one.unit) << one.pointer << ' ' << one.path;
    }
}

}  // namespace
}  // namespace keyblock
