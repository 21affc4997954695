// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points that the user has pinned on the section, with their values over the run. Pins
// belong to the view, not to the scene. Each frame is read once, in the background;
// without pins no frames are read.
#pragma once

#include "ui/document/background.h"
#include "ui/picture/charts/pins.h"

#include <QObject>

#include <memory>
#include <string>
#include <vector>

namespace keyblock {

class LiveRun;
class TimeCursor;

class Pins : public QObject {
    Q_OBJECT

public:
    explicit Pins(const TimeCursor& cursor, QObject* parent = nullptr);
    ~Pins() override;

    /// Values of the pins, in the order in which the points were pinned.
    const std::vector<std::shared_ptr<const PinTrack>>& tracks() const { return tracks_; }
    std::vector<Pin> pins() const;

    /// Adds a pin with the smallest unused number, and returns this number.
    int add(Pin pin);
    void remove(int number);
    void clear();
    /// True if the values cover all frames of the run.
    bool isComplete() const;

Q_SIGNALS:
    void changed();  // pins were added or removed
    void grew();  // more values were read
    void failed(const QString& message);  // a frame could not be read

private:
    void runChanged();
    void read();
    void take(const std::vector<std::shared_ptr<const PinTrack>>& grown);
    std::size_t framesRead() const;

    const TimeCursor& cursor_;
    std::vector<std::shared_ptr<const PinTrack>> tracks_;
    std::shared_ptr<const LiveRun> run_;
    bool reading_ = false;
    Background reader_;
};

}  // namespace keyblock
