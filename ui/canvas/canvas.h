// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section in the window: VTK below, and above it a transparent sheet for what
// stands in pixels and in words. It pans and zooms; all else that a mouse can do
// is the business of tools. Shows a plain panel where the display has no OpenGL.
#pragma once

#include "ui/canvas/canvas_map.h"
#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/culprit.h"
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

    /// Null: nothing is there, and a hint stands in the middle. The first picture after that is fitted, and what was
    /// fitted is fitted again next to a legend that appears; other pictures are shown where the view is.
    void show(std::shared_ptr<const SectionPicture> picture);
    using QWidget::show;
    const std::shared_ptr<const SectionPicture>& picture() const { return picture_; }

    /// Neither is owned; a tool or overlay must be taken out before it goes.
    void setTool(CanvasTool* tool);
    CanvasTool* tool() const { return tool_; }
    void addOverlay(const CanvasOverlay* overlay);
    void removeOverlay(const CanvasOverlay* overlay);

    /// Plain rock with lighter joints while a person draws; coloured results otherwise.
    void setDrawing(bool drawing);
    void setSelectedBolts(const std::vector<int>& bolts);  // rows of the scene's bolts
    /// Off: another canvas beside has one that counts for both.
    void setLegend(bool legend);
    void setCulprit(const std::optional<Culprit>& culprit);
    /// Where nothing is shown: in the middle, or aside at the foot where a drawing is to be seen behind it.
    void setHint(const QString& title, const QString& text, bool aside = false);

    /// What `fit` shows while there is no picture.
    void setExtent(const std::optional<Box>& extent) { extent_ = extent; }

    const CanvasMap& map() const { return map_; }
    /// What the picture is about (round tunnels and bolts); all of the model where that is seen already.
    void fit();
    /// Stays so when the canvas gets another size, until somebody pans or zooms; so does what was fitted.
    void zoomTo(const Box& box);
    void zoomBy(double factor, const QPointF& pixel);
    void panBy(const QPointF& pixels);
    /// The same camera as another canvas has.
    void lookAs(const CanvasMap& other);

    /// The next box that is drawn with the left button is shown as large as there is room.
    void startZoomBox();
    /// Whether there was one to let go.
    bool endZoomBox();

    /// What lies under a pixel of the canvas, as drawn.
    std::optional<Pick> pickAt(const QPointF& pixel) const;

    /// Paints tool and overlays again, not the section.
    void refresh();

    QSize minimumSizeHint() const override { return {220, 120}; }

Q_SIGNALS:
    void hovered(const keyblock::Point& place, bool inside);
    void viewChanged();
    /// Space was pressed and let go without a drag.
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
    mutable std::unique_ptr<PickIndex> index_;  // of the picture, once asked
    CanvasMap map_;
    ViewStyle style_;
    std::optional<Culprit> culprit_;
    CanvasTool* tool_ = nullptr;
    std::vector<const CanvasOverlay*> overlays_;
    QString hintTitle_, hintText_;
    bool hintAside_ = false, hasLegend_ = true;
    bool shapesChanged_ = true;
    std::optional<Box> extent_;
    std::optional<Box> kept_;  // what was fitted and stays in sight when the size changes, until somebody pans or zooms
    bool fitsAlone_ = false;  // what is kept was not chosen by the user
    bool spaceDown_ = false, spacePanned_ = false;
    std::optional<QPointF> panFrom_;
    Qt::MouseButtons held_ = Qt::NoButton;  // whose release the tool is to hear of
    bool boxWanted_ = false;
    std::optional<QPointF> boxFrom_, boxTo_;
};

}  // namespace keyblock
