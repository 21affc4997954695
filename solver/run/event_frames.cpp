// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/event_frames.h"

#include "solver/run/bolt_readings.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double shortly = 1e-3;  // fraction of the interval between frames: microseconds in a rockburst
constexpr double peakShare = 2e-3;  // relative difference up to which forces look the same
constexpr double farAbove = 0.05;
constexpr long fewestPlanned = 40;

double axialForce(const Model& model, const State& state, std::size_t bolt) {
    const BoltMotion& motion = state.bolts[bolt];
    return acts(motion) ? std::abs(boltExtreme(model.bolts[bolt], motion, BoltQuantity::AxialForce)) : 0.0;
}

bool exceeds(const Model& model, const State& state, const EventFrames& frames, double share) {
    for (std::size_t b = 0; b < frames.shown.size(); ++b)
        if (axialForce(model, state, b) > (1.0 + share) * frames.shown[b]) return true;
    return false;
}

}  // namespace

bool callsForFrames(const Event& event) { return event.bolt >= 0 && !isMinor(event.kind); }

bool isSeenAfterwards(const Event& event) { return event.kind == EventKind::PulledOut; }

bool exceedsShown(const Model& model, const State& state, const EventFrames& frames) {
    return exceeds(model, state, frames, peakShare);
}

bool isFarAboveShown(const Model& model, const State& state, const EventFrames& frames) {
    return exceeds(model, state, frames, farAbove);
}

bool passedPeak(const Model& model, const State& before, const State& after, const EventFrames& frames) {
    for (std::size_t b = 0; b < frames.shown.size(); ++b) {
        const double peak = axialForce(model, before, b);
        if (peak > (1.0 + peakShare) * frames.shown[b] && peak > axialForce(model, after, b)) return true;
    }
    return false;
}

void noteShown(const Model& model, const State& state, EventFrames& frames) {
    frames.shown.resize(state.bolts.size(), 0.0);
    for (std::size_t b = 0; b < frames.shown.size(); ++b)
        frames.shown[b] = std::max(frames.shown[b], axialForce(model, state, b));
}

bool mayKeep(const EventFrames& frames, long planned) { return frames.kept < std::max(planned, fewestPlanned); }

bool isShortlyAfter(const KeptAt& kept, const KeptAt& now, double interval) {
    return kept.stage == now.stage && now.time - kept.time <= shortly * interval;
}

}  // namespace keyblock
