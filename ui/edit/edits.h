// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Includes the headers of the common edits.
#pragma once

#include "ui/edit/drawn.h"
#include "ui/edit/edit.h"
#include "ui/edit/names.h"
#include "ui/edit/place.h"
#include "ui/edit/remove.h"
#include "ui/edit/settle.h"
#include "ui/edit/defaults.h"
#include "ui/edit/values.h"
