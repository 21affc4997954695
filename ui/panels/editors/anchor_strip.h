// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One bolt drawn straight in the property panel, showing which of its nodes are bonded
// and which are intermediate. A click on a node, or a drag along several, toggles
// between the two as one undo step.
#pragma once

#include "ui/panels/editors/value_editor.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace keyblock {

/// The row of nodes in the anchor strip.
class AnchorLine : public QWidget {
    Q_OBJECT

public:
    AnchorLine(const Themes& themes, QWidget* parent);

    void present(std::vector<double> nodes, std::vector<bool> real, bool plate, bool editable);
    const std::vector<double>& nodes() const { return nodes_; }
    const std::vector<bool>& real() const { return real_; }

    /// Position of node `i` [px].
    QPointF placeOf(std::size_t i) const;

Q_SIGNALS:
    void painted(std::size_t first, std::size_t last, bool real);  // makes these nodes bonded (real) or intermediate

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    std::size_t nodeAt(const QPointF& pixel) const;
    bool shownReal(std::size_t i) const;
    void paintTicks(QPainter& painter) const;

    const Themes& themes_;
    std::vector<double> nodes_;
    std::vector<bool> real_;
    bool plate_ = false, editable_ = false;
    std::optional<std::size_t> from_, to_;  // during a drag
};

class AnchorStrip : public QWidget {
    Q_OBJECT

public:
    AnchorStrip(const FormContext& context, QWidget* parent);

    /// Shows the bolt at `pointer`, or the first bolt of the pattern at `pointer`. Hides the strip if `pointer` refers
    /// to any other object.
    void setObject(const std::string& pointer);
    void refresh();
    AnchorLine& line() const { return *line_; }

private:
    void apply(std::size_t first, std::size_t last, bool real);
    std::vector<double> nodesNow(int pattern, std::size_t bolt, double length, std::optional<int> divisions) const;

    FormContext context_;
    std::string pointer_;
    QLabel *count_, *hint_;
    AnchorLine* line_;
};

}  // namespace keyblock
