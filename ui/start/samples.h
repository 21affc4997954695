// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The samples built into the program: their descriptions and measured run times
// (resources/gallery/measure.py).
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
    bool isVerification = false;  // all its expected values have a source other than this program, and close tolerances
    int blocks = 0, bolts = 0;
    double seconds = 0.0;  // measured run time; 0: not measured
};

/// All samples: a few instructive ones, then drifts, bolts and blocks, each by name.
std::vector<Sample> gallerySamples();

/// Folder of the records that samples refer to; created on the first call.
QString sampleRecordFolder();

/// The sample as a scene with its records included; none if it cannot be read.
std::optional<Scene> sampleScene(const Sample& sample);

}  // namespace keyblock
