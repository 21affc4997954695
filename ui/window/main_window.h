// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The main window: creates and places the widgets of all parts, and connects the
// commands.
#pragma once

#include <QMainWindow>

#include <memory>

namespace keyblock {

class Canvas;
class Commands;
class Display;
class Document;
class DrawingFeed;
class Journal;
class Layouts;
class RecentFiles;
class RunArea;
class Selection;
class StartPage;
class StudyRoom;
class Themes;
class Visibility;
class WorkflowBar;
enum class UnsavedEdits;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Themes& themes);
    ~MainWindow() override;

    /// Opens a scene, a run with its scene, or the import of a drawing. Errors are shown to the user.
    void openPath(const QString& path);

    /// Opens `path` at start-up; shows the start page if empty.
    void begin(const QString& path);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void openPath(const QString& path, UnsavedEdits edits);
    void placeBars();
    void placeFileRooms();
    void placeCanvas();
    void placeStudies();
    void arrange();
    void showTitle();
    void showStates();

    Themes& themes_;
    Display* display_;
    Commands* commands_;
    Document* document_;
    Journal* journal_;
    Selection* selection_;
    Visibility* visibility_;
    RecentFiles* recent_ = nullptr;
    StartPage* start_ = nullptr;
    Layouts* layouts_ = nullptr;
    WorkflowBar* workflow_;
    Canvas* canvas_;
    DrawingFeed* drawing_;
    RunArea* runs_;
    StudyRoom* studies_ = nullptr;
};

}  // namespace keyblock
