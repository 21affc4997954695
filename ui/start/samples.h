// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The samples built into the program, with their descriptions and measured run times
// (resources/gallery/measure.py).
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <optional>
#include <vector>

namespace keyblock {

struct Sample {
    QString name;  // file name without .json
    QString path;  // path of the file within the program's resources
    QString title, shows, category;
    bool isDynamic = false;
    bool isVerification = false;  // expected values all come from other sources and have close tolerances
    int blocks = 0, bolts = 0;
    double seconds = 0.0;  // measured run time [s]; 0: not measured
};

/// All samples: first a few instructive ones, then drifts, bolts and blocks, each group sorted by name.
std::vector<Sample> gallerySamples();

/// Path of the folder with the CSV records that the samples use. Creates the folder if necessary.
QString sampleRecordFolder();

/// The scene of a sample, including the values of its acceleration records; none if the scene cannot be read.
std::optional<Scene> sampleScene(const Sample& sample);

}  // namespace keyblock
