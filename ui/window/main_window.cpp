// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/window/file_commands.h"
#include "ui/window/menus.h"

#include <QCloseEvent>
#include <QLabel>
#include <QMenuBar>
#include <QStatusBar>

namespace keyblock {

MainWindow::MainWindow(Themes& themes)
    : themes_(themes), display_(new Display(this)), commands_(new Commands(themes, this)),
      document_(new Document(this)), selection_(new Selection(this)) {
    setObjectName("studio");
    resize(1600, 1000);
    addFileCommands(*commands_, *document_, *this);
    addEditCommands(*commands_, *document_);
    addViewCommands(*commands_, themes_, *display_);
    placeDocks();
    makeMenus();
    connect(document_, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(document_, &Document::replaced, selection_, &Selection::clear);
    auto* units = new QLabel(display_->summary(), this);
    statusBar()->addPermanentWidget(units);
    connect(display_, &Display::changed, units, [this, units] { units->setText(display_->summary()); });
    showTitle();
}

MainWindow::~MainWindow() = default;

void MainWindow::openPath(const QString& path) { openDocument(*document_, path, *this); }

void MainWindow::closeEvent(QCloseEvent* event) { event->setAccepted(mayDiscard(*document_, *this)); }

void MainWindow::placeDocks() { setCentralWidget(new QWidget(this)); }

void MainWindow::makeMenus() { fillMenus(*menuBar(), *commands_); }

void MainWindow::showTitle() {
    setWindowTitle(document_->title() + QStringLiteral("[*] – Keyblock Studio"));
    setWindowModified(document_->isModified());
}

}  // namespace keyblock
