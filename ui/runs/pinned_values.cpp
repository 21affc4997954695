// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/pinned_values.h"

#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QElapsedTimer>

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

constexpr int readingTime = 250;  // [ms] of reading frames, after which incomplete curves are shown

bool areAlike(const LiveRun& a, const LiveRun& b) {
    return a.blockNames() == b.blockNames() && a.scene().bolts == b.scene().bolts;
}

}  // namespace

Pins::Pins(const TimeCursor& cursor, QObject* parent) : QObject(parent), cursor_(cursor) {
    connect(&cursor, &TimeCursor::runChanged, this, &Pins::runChanged);
    connect(&cursor, &TimeCursor::runGrew, this, &Pins::read);
}

Pins::~Pins() = default;

std::vector<Pin> Pins::pins() const {
    std::vector<Pin> pins;
    for (const auto& track : tracks_) pins.push_back(track->pin());
    return pins;
}

int Pins::add(Pin pin) {
    const auto taken = [&](int number) {
        return std::any_of(tracks_.begin(), tracks_.end(), [&](const auto& t) { return t->pin().number == number; });
    };
    pin.number = 1;
    while (taken(pin.number)) ++pin.number;
    tracks_.push_back(std::make_shared<const PinTrack>(pin));
    Q_EMIT changed();
    read();
    return pin.number;
}

void Pins::remove(int number) {
    if (std::erase_if(tracks_, [&](const auto& track) { return track->pin().number == number; }) > 0) Q_EMIT changed();
}

void Pins::clear() {
    if (tracks_.empty()) return;
    tracks_.clear();
    Q_EMIT changed();
}

/// Pins are kept when another run of the same blocks and bolts is shown.
void Pins::runChanged() {
    const auto before = std::exchange(run_, cursor_.run());
    if (tracks_.empty()) return;
    if (!run_ || !before || !areAlike(*before, *run_)) return clear();
    for (auto& track : tracks_) track = std::make_shared<const PinTrack>(track->pin());
    Q_EMIT grew();
    read();
}

std::size_t Pins::framesRead() const {
    std::size_t least = run_ ? run_->frames().size() : 0;
    for (const auto& track : tracks_) least = std::min(least, track->frames());
    return least;
}

bool Pins::isComplete() const { return !run_ || framesRead() == run_->frames().size(); }

void Pins::read() {
    if (tracks_.empty() || reading_ || isComplete()) return;
    reading_ = true;
    reader_.ask([this, run = run_, tracks = tracks_, from = framesRead(),
                 to = run_->frames().size()]() -> Background::Result {
        try {
            std::vector<std::shared_ptr<PinTrack>> grown;
            for (const auto& track : tracks) grown.push_back(std::make_shared<PinTrack>(*track));
            QElapsedTimer clock;
            clock.start();
            for (std::size_t i = from; i < to && (i == from || clock.elapsed() < readingTime); ++i) {
                const std::shared_ptr<const Frame> frame = run->sharedFrame(i);
                for (const auto& track : grown)
                    if (track->frames() == i) track->add(*frame);
            }
            return [this, run, done = std::vector<std::shared_ptr<const PinTrack>>(grown.begin(), grown.end())] {
                reading_ = false;
                if (run == run_) take(done);
                read();
            };
        } catch (const std::exception& error) {
            return [this, text = QString::fromStdString(error.what())] {
                reading_ = false;
                Q_EMIT failed(text);
            };
        }
    });
}

void Pins::take(const std::vector<std::shared_ptr<const PinTrack>>& grown) {
    for (const auto& track : grown)
        for (auto& known : tracks_)
            if (known->pin() == track->pin() && known->frames() < track->frames()) known = track;
    Q_EMIT grew();
}

}  // namespace keyblock
