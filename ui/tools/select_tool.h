// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects objects by clicks and selection boxes, moves them and their handles with
// snapping, and inserts and deletes corners. All other tools return to this one.
#pragma once

#include "ui/edit/handles.h"
#include "ui/tools/tool.h"


namespace keyblock {

class SelectTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    QString id() const override { return "select"; }
    QString title() const override { return tr("Select"); }
    QString prompt() const override { return {}; }

    void end() override;
    void refresh() override { doing_ = Doing::Nothing, hover_.clear(), hot_.reset(); }
    void press(const Pointed& at) override;
    void move(const Pointed& at) override;
    void release(const Pointed& at) override;
    void doubleClick(const Pointed& at) override;
    void leave() override;
    bool back() override;
    bool key(QKeyEvent& event) override;
    void fillMenu(QMenu& menu, const Pointed& at) override;

    bool wantsPlaces() const override { return false; }
    bool snaps() const override { return doing_ == Doing::Moves || doing_ == Doing::Shapes; }
    std::optional<Point> previous() const override;
    std::vector<std::string> unsnapped() const override;
    void paint(QPainter& painter, const CanvasMap& map) const override;
    QCursor cursor() const override;

    /// Deletes the selected objects, or the corner under the mouse.
    void removeSelected();

private:
    enum class Doing { Nothing, Presses, Moves, Shapes, Boxes };

    std::vector<std::string> selected() const;
    std::vector<Handle> handles() const;  // handles of the selected object, if only one is selected
    std::optional<std::size_t> handleAt(const QPointF& pixel) const;
    QString objectAt(const Point& place) const;
    void choose(const QString& pointer, Qt::KeyboardModifiers modifiers);
    void chooseBox(const Pointed& at);
    void beginDrag();
    void drag(const Pointed& at);
    Edit dragged(const Point& place) const;
    QString titleOf(const std::vector<std::string>& pointers) const;
    QString stepName() const;
    void nudge(const Point& way);

    Doing doing_ = Doing::Nothing;
    Pointed pressed_;
    Point grab_{0.0, 0.0};  // point that is being dragged [m]
    QPointF boxEnd_;
    Point mouse_{0.0, 0.0};  // [m]
    std::optional<std::size_t> hot_;  // handle under the mouse or being dragged
    std::string shaped_;  // pointer to the object whose handle is being dragged
    QString hover_;  // pointer to the object under the mouse
    bool single_ = false;  // if no drag follows the press, only the object under the mouse is selected
};

}  // namespace keyblock
