// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For tests that advance a model without anybody who follows its events.
#pragma once

#include "solver/engine/stage/dynamics.h"

namespace keyblock::test {

struct SilentObserver : StepObserver {
    void beforeEvent(const State&, double) override {}
    long event(Event, const State&, double) override { return 0; }
    void afterEvent(const State&, double) override {}
};

}  // namespace keyblock::test
