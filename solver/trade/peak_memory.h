// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Peak memory of this process since a moment, where the system reports it (Linux).
#pragma once

namespace keyblock {

/// Forgets the peak so far. Without effect where the system does not allow it; the peak is then that of the process.
void resetPeakMemory();

/// Peak resident memory [bytes]; 0 if it is unknown.
double peakMemory();

}  // namespace keyblock
