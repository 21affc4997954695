// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section in the window: VTK below, and above it a transparent sheet for
// everything in pixels and in text. It pans and zooms; all other mouse input belongs
// to the tools. Shows a plain panel if the display has no OpenGL.
#pragma once

#include "ui/canvas/canvas_map.h"
#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/highlighted_block.h"
#include "ui/canvas/legend_panel.h"
#include "ui/picture/pick.h"
#include "ui/view/view_colours.h"

#include <QString>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QTimer;

namespace keyblock {

class CanvasSheet;
class SectionWidget;
class Themes;

class Canvas : public QWidget {
    Q_OBJECT

public:
    explicit Canvas(const Themes& themes, QWidget* parent = nullptr);
    ~Canvas() override;

    /// Null: empty, with a hint in the middle. The first picture after that is fitted, and a fitted view is fitted
    /// again if a legend appears; other pictures keep the view.
    void show(std::shared_ptr<const SectionPicture> picture);
    using QWidget::show;
    const std::shared_ptr<const SectionPicture>& picture() const { return picture_; }

    /// Neither is owned; remove a tool or overlay before it is deleted.
    void setTool(CanvasTool* tool);
    CanvasTool* tool() const { return tool_; }
    void addOverlay(const CanvasOverlay* overlay);
    void removeOverlay(const CanvasOverlay* overlay);

    /// Plain rock with lighter joints while drawing; coloured results otherwise.
    void setDrawing(bool drawing);
    void setSelectedBolts(const std::vector<int>& bolts);  // rows of the scene's bolts
    /// Off: a neighbouring canvas has one that applies to both.
    void setLegend(bool legend);
    void setHighlighted(const std::optional<HighlightedBlock>& highlighted);
    /// Position of the hint: in the middle, or at the bottom if a drawing is visible behind it.
    void setHint(const QString& title, const QString& text, bool aside = false);

    /// What `fit` shows while there is no picture.
    void setExtent(const std::optional<Box>& extent) { extent_ = extent; }

    const CanvasMap& map() const { return map_; }
    /// Zooms to tunnels and bolts, or to the whole model if they are fitted already.
    void fit();
    /// Kept when the canvas is resized, until the user pans or zooms; so is a fitted view.
    void zoomTo(const Box& box);
    void zoomBy(double factor, const QPointF& pixel);
    void panBy(const QPointF& pixels);
    /// Copies the camera of another canvas.
    void lookAs(const CanvasMap& other);

    /// Zooms to the next box drawn with the left button.
    void startZoomBox();
    /// True if there was one to cancel.
    bool endZoomBox();

    /// The object drawn under a pixel of the canvas.
    std::optional<Pick> pickAt(const QPointF& pixel) const;

    /// Paints tool and overlays again, not the section.
    void refresh();

    QSize minimumSizeHint() const override { return {220, 120}; }

Q_SIGNALS:
    void hovered(const keyblock::Point& place, bool inside);
    void viewChanged();
    /// Space was pressed and released without a drag.
    void spaceTapped();
    /// The bar of a quantity in the legend was clicked; the point is to the left of it, on the screen.
    void legendClicked(keyblock::LegendPart part, const QPoint& global);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    friend class CanvasSheet;
    void layOut();
    bool growFitted();
    void sceneChanged();  // of shapes, colours or style
    void mapChanged();
    void schedule();
    void renderOwed();
    void renderNow();
    void showCursor(const std::optional<QPointF>& pixel = std::nullopt);
    bool startsPan(const QMouseEvent& event) const;
    CanvasEvent eventOf(const QMouseEvent& event) const;
    QRectF room() const;

    const Themes& themes_;
    SectionWidget* section_ = nullptr;  // null: no OpenGL
    QWidget* withoutGl_ = nullptr;
    CanvasSheet* sheet_;
    QTimer* timer_;
    std::shared_ptr<const SectionPicture> picture_;
    mutable std::unique_ptr<PickIndex> index_;  // of the picture, computed on demand
    CanvasMap map_;
    ViewStyle style_;
    std::optional<HighlightedBlock> highlighted_;
    CanvasTool* tool_ = nullptr;
    std::vector<const CanvasOverlay*> overlays_;
    QString hintTitle_, hintText_;
    bool hintAside_ = false, hasLegend_ = true;
    bool shapesChanged_ = true;
    std::optional<Box> extent_;
    std::optional<Box> kept_;  // fitted box, kept when the size changes until the user pans or zooms
    bool fitsAlone_ = false;  // the kept box was not chosen by the user
    bool spaceDown_ = false, spacePanned_ = false;
    std::optional<QPointF> panFrom_;
    Qt::MouseButtons held_ = Qt::NoButton;  // whose release is passed to the tool
    bool boxWanted_ = false;
    std::optional<QPointF> boxFrom_, boxTo_;
};

}  // namespace keyblock
