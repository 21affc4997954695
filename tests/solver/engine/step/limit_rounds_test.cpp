// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounds of friction limits on a joint whose answer is known.
#include "solver/engine/step/limit_rounds.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

/// One joint whose push, and so its limit, answers to the limit that it was given by a straight line of slope `slope`.
class Answering {
public:
    explicit Answering(double slope) : slope_(slope) {
        problem_.blocks = 1;
        problem_.links.resize(2);
        for (Link& link : problem_.links) link.a = 0, link.law.kind = LawKind::Gap, link.law.stiffness = 1.0;
        problem_.links[0].ga[0] = 1.0;
        problem_.links[1].law.kind = LawKind::Capped;
        problem_.limitPairs = {{1, 0, 1.0}};
    }

    double limit() const { return problem_.links[1].law.limit; }

    /// A round: what the forces allow is 10 + slope·limit.
    void round(LimitRounds& rounds) {
        Eigen::VectorXd d = Eigen::VectorXd::Zero(6);
        d[0] = -(10.0 + slope_ * limit());
        rounds.correct(problem_, d);
        rounds.mix(problem_);
    }

private:
    double slope_;
    StepProblem problem_;
};

/// Plain rounds go off where the slope is over one; mixed ones find 10 / (1 − slope), a straight line's exactly.
TEST(LimitRounds, FindTheLimitThatAnswersToItself) {
    for (const double slope : {-3.0, -1.0, -0.9, 0.5, 0.9}) {
        Answering joint(slope);
        LimitRounds rounds;
        for (int i = 0; i < 6; ++i) joint.round(rounds);
        EXPECT_NEAR(joint.limit(), 10.0 / (1.0 - slope), 1e-9) << slope;
    }
}

/// The first rounds are plain: what they settle is as it would be without mixing.
TEST(LimitRounds, BeginPlainly) {
    Answering joint(-0.5);
    LimitRounds rounds;
    double limit = 0.0;
    for (int i = 0; i < 3; ++i) {
        joint.round(rounds);
        limit = 10.0 - 0.5 * limit;
        EXPECT_EQ(joint.limit(), limit) << i;
    }
}

}  // namespace
}  // namespace keyblock
