// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section in the window: the rendering by VTK, and above it a transparent sheet for
// text and everything else with a size in pixels. The canvas pans and zooms; all other
// mouse input is passed to the tools. If the display has no OpenGL, a plain panel is
// shown instead.
#pragma once

#include "ui/canvas/canvas_map.h"
#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/highlighted_block.h"
#include "ui/canvas/legend_panel.h"
#include "ui/picture/section/pick.h"
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

    /// Shows a picture; null: an empty canvas with the hint. The view is fitted to the first picture. Until the user
    /// pans or zooms, it is adjusted when a legend appears and when parts of the picture move out of view.
    void show(std::shared_ptr<const SectionPicture> picture);
    using QWidget::show;
    const std::shared_ptr<const SectionPicture>& picture() const { return picture_; }

    /// Tools and overlays are not owned; remove them before they are deleted.
    void setTool(CanvasTool* tool);
    CanvasTool* tool() const { return tool_; }
    void addOverlay(const CanvasOverlay* overlay);
    void removeOverlay(const CanvasOverlay* overlay);

    /// Sets the style. True: plain rock with lighter joints, for drawing. False: coloured results.
    void setDrawing(bool drawing);
    void setSelectedBolts(const std::vector<int>& bolts);  // indices of bolts in the scene
    /// Shows or hides the legend. Hide it if the legend of a neighbouring canvas applies to both.
    void setLegend(bool legend);
    /// Outlines a block and shows its call-out; null: none.
    void setHighlighted(const std::optional<HighlightedBlock>& highlighted);
    /// Sets the hint that is shown on an empty canvas.
    /// \param aside true: at the bottom, so that it does not cover a drawing; false: in the middle.
    void setHint(const QString& title, const QString& text, bool aside = false);

    /// Sets the area that `fit` shows while there is no picture.
    void setExtent(const std::optional<Box>& extent) { extent_ = extent; }

    const CanvasMap& map() const { return map_; }
    /// Zooms to the tunnels and bolts or, if the view shows them already, to the whole model.
    void fit();
    /// Zooms to a box. Like a fitted view, the box stays in view when the canvas is resized, until the user pans or
    /// zooms.
    void zoomTo(const Box& box);
    void zoomBy(double factor, const QPointF& pixel);
    void panBy(const QPointF& pixels);
    /// Sets the same centre and scale as another canvas.
    void lookAs(const CanvasMap& other);

    /// Lets the user draw a box with the left button, and zooms to it.
    void startZoomBox();
    /// Cancels the zoom box; returns true if there was one to cancel.
    bool endZoomBox();

    /// The object drawn at a pixel of the canvas; null if there is none.
    std::optional<Pick> pickAt(const QPointF& pixel) const;

    /// Repaints the tool and the overlays, but not the section.
    void refresh();

    QSize minimumSizeHint() const override { return {220, 120}; }

Q_SIGNALS:
    void hovered(const keyblock::Point& place, bool inside);
    void viewChanged();
    /// Emitted when Space is pressed and released without dragging.
    void spaceTapped();
    /// Emitted when the colour bar of a quantity in the legend is clicked. \param global a point to the left of the
    /// legend, in screen coordinates.
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
    void sceneChanged();  // shapes, colours or style have changed
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
    mutable std::unique_ptr<PickIndex> index_;  // of the current picture, built on demand
    CanvasMap map_;
    ViewStyle style_;
    std::optional<HighlightedBlock> highlighted_;
    CanvasTool* tool_ = nullptr;
    std::vector<const CanvasOverlay*> overlays_;
    QString hintTitle_, hintText_;
    bool hintAside_ = false, hasLegend_ = true;
    bool shapesChanged_ = true;
    std::optional<Box> extent_;
    std::optional<Box> kept_;  // box shown, kept on resizing until the user pans or zooms
    bool fitsAlone_ = false;  // the kept box is that of a fitted view, not one chosen by the user
    bool spaceDown_ = false, spacePanned_ = false;
    std::optional<QPointF> panFrom_;
    Qt::MouseButtons held_ = Qt::NoButton;  // buttons whose release is passed to the tool
    bool boxWanted_ = false;
    std::optional<QPointF> boxFrom_, boxTo_;
};

}  // namespace keyblock
