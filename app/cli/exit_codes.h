// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exit codes of the program; scripts and schedulers rely on these numbers.
#pragma once

namespace keyblock::cli {

enum ExitCode : int {
    Done = 0,  // also after a collapse or bolt failure, which is a result
    Missed = 1,  // a verification check failed
    Usage = 2,
    Invalid = 3,  // invalid scene or file
    NumericalFailure = 4,  // results so far are kept
    LimitReached = 5,
    NotWritten = 6,  // e.g. disk full or no permission
    DoesNotStand = 8,  // the scene is not stable; only with --fail-on-collapse
    Internal = 70,
    Interrupted = 75,  // Ctrl+C or SIGTERM; results so far are kept
};

}  // namespace keyblock::cli
