// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connects the probe on the canvas with the pins, the run and the scene, and adds the
// probe command.
#pragma once

#include "ui/picture/section/pick.h"

#include <QObject>

#include <functional>

namespace keyblock {

class Canvas;
class Commands;
class Document;
class Pins;
class Probe;
class SectionFeed;
class Themes;
class TimeCursor;
class ViewSettings;

struct ProbeNeeds {
    Canvas& canvas;
    Commands& commands;
    Document& document;
    const Themes& themes;
    const TimeCursor& cursor;
    const SectionFeed& feed;
    const ViewSettings& settings;
    Pins& pins;
};

class ProbeBinding : public QObject {
    Q_OBJECT

public:
    /// Adds the probe command. \param tell shows a message to the user.
    ProbeBinding(const ProbeNeeds& needs, std::function<void(const QString&)> tell, QObject* parent);

    /// Ends the probe. To be called when another tool is chosen or results are no longer shown.
    void end();

    /// Pins a point of the section, so that the Curves dock shows its values over time.
    void pin(const Pick& pick, const Point& place);

private:
    void keep(int number);

    ProbeNeeds needs_;
    std::function<void(const QString&)> tell_;
    Probe* probe_;
};

}  // namespace keyblock
