// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two runs side by side: during a comparison a second canvas with the same view appears
// next to the first, captions name the runs, and the charts show the curves of both.
#pragma once

#include <QObject>

#include <memory>

class QBoxLayout;
class QWidget;

namespace keyblock {

class Canvas;
class Commands;
class Comparison;
class Curves;
class Display;
class Document;
class Runs;
class SectionFeed;
class Selection;
class Themes;
class ViewSettings;

struct CompareNeeds {
    QWidget& window;
    const Themes& themes;
    const Display& display;
    Commands& commands;
    Document& document;
    Selection& selection;
    Canvas& canvas;
    Runs& runs;
    Comparison& comparison;
    SectionFeed& feed;
    ViewSettings& settings;
};

class CompareArea : public QObject {
    Q_OBJECT

public:
    /// Adds the command for comparing runs.
    CompareArea(const CompareNeeds& needs, QObject* parent);
    ~CompareArea() override;

    /// Sets the layout in which the second canvas is placed, and the charts that show the curves of both runs.
    void place(QBoxLayout& besideCanvas, Curves& curves, Curves& energies);

private:
    /// Widgets of the second run. They exist only while two runs are shown.
    struct Second;

    void beginOrEnd();
    void show();
    void showSecond();
    void end();
    void fitBoth();

    CompareNeeds needs_;
    QBoxLayout* row_ = nullptr;
    Curves *curves_ = nullptr, *energies_ = nullptr;
    std::unique_ptr<Second> second_;
};

}  // namespace keyblock
