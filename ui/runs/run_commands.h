// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands for runs and for the time cursor.
#pragma once

namespace keyblock {

class Commands;
class Runs;
class TimeCursor;

void addRunCommands(Commands& commands, Runs& runs);
void addTimeCommands(Commands& commands, TimeCursor& cursor);

}  // namespace keyblock
