// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables are a contract with scripts outside: their headers are compared
// letter by letter, their rows by meaning.
#include "solver/results/tables.h"

#include "solver/results/csv.h"
#include "tests/solver/results/sample_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace keyblock {
namespace {

std::vector<std::string> lines(TableKind kind, const TableFilter& filter = {}) {
    const Scene scene = test::sampleScene();
    const Results results = test::sampleResults();
    std::ostringstream out;
    writeTable(kind, MemoryRun(scene, results), filter, out);
    std::istringstream in(out.str());
    std::vector<std::string> result;
    for (std::string line; std::getline(in, line);)
        result.push_back(line);
    return result;
}

TableFilter filterOf(const std::optional<std::string>& stage, const std::optional<std::string>& bolt,
                     const std::optional<std::string>& at) {
    const TableFilterReading reading = readTableFilter(test::sampleScene(), stage, bolt, at);
    EXPECT_TRUE(reading.filter) << reading.problem;
    return reading.filter.value_or(TableFilter{});
}

TEST(Tables, HaveTheHeadersOfTheContract) {
    EXPECT_EQ(lines(TableKind::History)[0], "stage,time_s,crown_ux_m,crown_uy_m,opening_m,joint_force_N");
    EXPECT_EQ(lines(TableKind::Events)[0],
              "stage,time_s,step,kind,bolt,node,element,block,x_m,y_m,axial_force_N,shear_force_N,anchor_force_N,"
              "slip_m");
    EXPECT_EQ(lines(TableKind::Bolts)[0],
              "stage,time_s,bolt,node,s_m,x_m,y_m,block,anchor,state,axial_force_N,shear_force_N,moment_Nm,"
              "anchor_force_N,slip_m,bond_strength_N,bond_residual_N");
    EXPECT_EQ(lines(TableKind::Blocks)[0],
              "stage,time_s,block,x_m,y_m,ux_m,uy_m,rotation_rad,sxx_Pa,syy_Pa,sxy_Pa,vx_m_per_s,vy_m_per_s,area_m2,"
              "weight_N,displacement_m,speed_m_per_s,sigma1_compressive_Pa,sigma3_compressive_Pa");
    EXPECT_EQ(lines(TableKind::Contacts)[0],
              "stage,time_s,block_a,block_b,joint_material,x_m,y_m,state,normal_force_N,shear_force_N,penetration_m,"
              "slip_m,nx,ny");
    EXPECT_EQ(lines(TableKind::Energy)[0],
              "stage,time_s,kinetic_J,strain_J,contact_J,bolt_J,friction_J,plastic_J,released_J,damped_J,external_J,"
              "balance_error");
    EXPECT_EQ(lines(TableKind::Forces)[0], "stage,time_s,block,source,name,x_m,y_m,fx_N,fy_N,moment_Nm");
    EXPECT_EQ(lines(TableKind::Design)[0],
              "stage,time_s,bolt,type,status,peak_axial_force_N,peak_axial_at_m,peak_axial_stage,peak_axial_time_s,"
              "peak_shear_force_N,peak_shear_at_m,peak_moment_Nm,peak_moment_at_m,yield_force_N,yield_use,steel_use,"
              "shear_use,bond_use,plate_use,governs,axial_force_N,shear_force_N,moment_Nm,plate_normal_force_N,"
              "plate_shear_force_N,bonded_length_m,debonded_length_m,debonded_share,elastic_J,plastic_J,bond_J,"
              "energy_J,carries,carried_weight_N,carrying_force_N,since_event,since_bolt,since_block,since_stage,"
              "since_time_s");
}

TEST(Tables, ForcesAreListedBlockByBlockWithBothEndsOfContactsAndBonds) {
    const auto forces = lines(TableKind::Forces, filterOf({}, {}, "pull:1"));
    const std::string rest = "pull,1,";
    ASSERT_EQ(forces.size(), 1U + 11U);
    EXPECT_EQ(forces[1], rest + "left,weight,,0.55000000000000004,0.5,0,-26487,0");
    EXPECT_TRUE(forces[2].starts_with(rest + "left,contact,b2,1,0.25,")) << forces[2];
    EXPECT_TRUE(forces[3].starts_with(rest + "left,bolt,\"B, \"\"1\"\"\",")) << forces[3];
    EXPECT_EQ(forces[4], rest + "left,support,,0.5,0,0,30000,0.25");
    EXPECT_EQ(forces[5], rest + "left,glue,b2,1,0.5,8,4,3");
    EXPECT_TRUE(forces[6].starts_with(rest + "b2,weight,")) << forces[6];
    EXPECT_TRUE(forces[10].starts_with(rest + "b2,glue,left,1,0.5,-8,-4,")) << forces[10];
    EXPECT_TRUE(forces[11].starts_with(rest + "b2,inertia,,")) << forces[11];
}

/// Of the step, not of where it ended: each block by its own arm.
TEST(Tables, ForcesOfContactsInMotionAreThoseOfTheStep) {
    const auto forces = lines(TableKind::Forces);
    EXPECT_TRUE(forces[2].starts_with("shake: hard,2,left,contact,b2,1,0.25,45,-54,12.5")) << forces[2];
    const auto other = std::find_if(forces.begin(), forces.end(), [](const std::string& line) {
        return line.starts_with("shake: hard,2,b2,contact,left,1,0.25,-45,54,-0.1");
    });
    EXPECT_NE(other, forces.end());
}

TEST(Tables, LeaveTheStrengthOfABondOutThatHasNone) {
    const auto bolts = lines(TableKind::Bolts);
    ASSERT_EQ(bolts.size(), 4U);
    EXPECT_TRUE(bolts[1].ends_with(",25000,0")) << bolts[1];
    EXPECT_TRUE(bolts[2].ends_with(",,")) << bolts[2];  // an artificial node
    EXPECT_TRUE(lines(TableKind::Contacts)[1].ends_with(",0.59999999999999998,-0.80000000000000004"));
}

TEST(Tables, QuoteNamesAndLeaveOutWhatDoesNotApply) {
    const auto events = lines(TableKind::Events);
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[1],
              "pull,0.29999999999999999,3,debonding,\"B, \"\"1\"\"\",1,,b2,1.1000000000000001,0.5,33333.333333333336,"
              "-1e-300,24560,0.00029");
    EXPECT_EQ(events[2], "pull,0.29999999999999999,3,joint-open,,,,left|b2,1,0.5,0,0,0,0");
}

TEST(Tables, ShowTheLastFrameByDefault) {
    const auto bolts = lines(TableKind::Bolts);
    ASSERT_EQ(bolts.size(), 4U);
    EXPECT_EQ(bolts[1].substr(0, 14), "shake: hard,2,");
    EXPECT_NE(bolts[1].find(",left,real,slipping,"), std::string::npos);
    EXPECT_NE(bolts[2].find(",,artificial,free,"), std::string::npos);
    EXPECT_EQ(lines(TableKind::Blocks, filterOf({}, {}, "all")).size(), 1U + 8U);
    EXPECT_EQ(lines(TableKind::Energy).size(), 1U + 4U);
}

TEST(Tables, ChooseByStageMomentAndBolt) {
    EXPECT_EQ(lines(TableKind::Blocks, filterOf("pull", {}, {}))[1].substr(0, 12), "pull,1,left,");
    EXPECT_EQ(lines(TableKind::Contacts, filterOf({}, {}, "shake: hard:0.6"))[1].substr(0, 16), "shake: hard,0.5,");
    EXPECT_EQ(lines(TableKind::History, filterOf({}, {}, "pull:0.3")).size(), 1U + 4U);
    EXPECT_EQ(lines(TableKind::History, filterOf({}, {}, "last")).size(), 1U + 1U);
    EXPECT_EQ(lines(TableKind::Events, filterOf({}, "B, \"1\"", {})).size(), 1U + 1U);
    EXPECT_EQ(lines(TableKind::Events, filterOf("shake: hard", {}, {})).size(), 1U);
}

TEST(TableFilter, SaysWhatIsWrong) {
    const auto problem = [](const std::optional<std::string>& stage, const std::optional<std::string>& bolt,
                            const std::optional<std::string>& at) {
        return readTableFilter(test::sampleScene(), stage, bolt, at).problem;
    };
    EXPECT_NE(problem("push", {}, {}).find("pull, shake: hard"), std::string::npos);
    EXPECT_NE(problem({}, "B2", {}).find("there are: B"), std::string::npos);
    EXPECT_NE(problem({}, {}, "first").find("STAGE:TIME"), std::string::npos);
    EXPECT_NE(problem({}, {}, "pull:half").find("STAGE:TIME"), std::string::npos);
    EXPECT_NE(problem("shake: hard", {}, "pull:0.5").find("different stages"), std::string::npos);
}

TEST(Csv, NumbersReadBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3.0, 6.02214076e23, -4.9e-324, 1.7976931348623157e308}) {
        const std::string text = exactText(value);
        double back = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), back);
        EXPECT_EQ(back, value) << text;
    }
}

}  // namespace
}  // namespace keyblock
