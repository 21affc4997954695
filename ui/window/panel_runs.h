// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panels know no runs and runs no panels: here the tree lists the runs of the
// scene, and the census waits while one goes on.
#pragma once

namespace keyblock {

class Runs;
struct Panels;

void showRunsIn(const Panels& panels, Runs& runs);

}  // namespace keyblock
