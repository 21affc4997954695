// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates pictures of results on its own thread: at the time of the time cursor, with
// the view settings, with ranges over all frames of the run. During a run the ranges
// grow with the frames shown.
#pragma once

#include "ui/document/background.h"
#include "ui/picture/section.h"

#include <QObject>

#include <memory>
#include <optional>

namespace keyblock {

class BoltChoice;
class Display;
class LiveRun;
class TimeCursor;
class ViewSettings;

class SectionFeed : public QObject {
    Q_OBJECT

public:
    SectionFeed(const BoltChoice& choice, TimeCursor& cursor, ViewSettings& settings, const Display& display,
                QObject* parent = nullptr);
    ~SectionFeed() override;

    /// Whether results are wanted, if there are any, or the scene as drawn.
    void showResults(bool results);
    bool showsResults() const;

    /// Common ranges for this run and a second one; null: for this one only. One of the two is the leader: steel
    /// limits and round-off are those of its scene.
    void shareRanges(std::shared_ptr<const LiveRun> other, bool leads);

    /// The newest picture of results; null before the first.
    const std::shared_ptr<const SectionPicture>& picture() const { return picture_; }
    /// The frame of that picture.
    const std::shared_ptr<const Frame>& frame() const { return frame_; }

Q_SIGNALS:
    void pictureChanged();
    void modeChanged();  // from results to drawing or back
    void failed(const QString& message);  // a frame could not be read

private:
    struct Ranges;

    void runChanged();
    void runEnded();
    void make();
    void gatherRanges();
    std::shared_ptr<Ranges> emptyRanges() const;
    void takeRanges(std::shared_ptr<Ranges> ranges);
    SectionRequest request() const;
    void put(std::shared_ptr<const SectionPicture> picture, std::shared_ptr<const Frame> frame);

    const BoltChoice& choice_;
    TimeCursor& cursor_;
    ViewSettings& settings_;
    const Display& display_;
    bool results_ = true, showed_ = false, goesOn_ = false;
    std::shared_ptr<Ranges> ranges_;  // of the run and the quantities shown
    std::shared_ptr<const LiveRun> other_;  // run that shares the ranges
    bool leads_ = true;
    std::shared_ptr<const SectionPicture> picture_;
    std::shared_ptr<const Frame> frame_;
    Background painting_, gathering_;
};

}  // namespace keyblock
