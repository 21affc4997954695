// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The samples that come within the program: what each says of itself, and how long
// it was measured to run (resources/gallery/measure.py).
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <optional>
#include <vector>

namespace keyblock {

struct Sample {
    QString name;  // of its file, without .json
    QString path;  // of the file within the program
    QString title, shows, category;
    bool isDynamic = false;
    bool isVerification = false;  // all its expected values have a source other than this program, and are met closely
    int blocks = 0, bolts = 0;
    double seconds = 0.0;  // that it was measured to run; 0: not measured
};

/// All samples: a few that show most, then drifts, bolts and blocks, each by name.
std::vector<Sample> gallerySamples();

/// Where the records that samples name lie as files; made on the first call.
QString sampleRecordFolder();

/// The sample as a scene of its own, with its records inside; nothing where it cannot be read.
std::optional<Scene> sampleScene(const Sample& sample);

}  // namespace keyblock
