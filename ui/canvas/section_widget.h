// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section in a window: ui/view draws into a buffer of its own by OpenGL, and the
// pixels are put on the widget as any other picture. A widget that is itself OpenGL
// would have the whole window put together by the card each time a label changes,
// which without a card takes more time than the section does. Takes no mouse and no
// keys; the canvas above has them.
#pragma once

#include "ui/view/section_view.h"

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QWidget>
#include <vtkNew.h>

#include <functional>

class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace keyblock {

class SectionWidget : public QWidget {
    Q_OBJECT

public:
    /// \pre the display has OpenGL: `missingOpenGl()` is empty.
    explicit SectionWidget(QWidget* parent);
    ~SectionWidget() override;

    SectionView& view() { return view_; }
    /// Called before each painting, so that what is owed can be rendered: marks above are then of the same camera.
    std::function<void()> beforePaint;
    /// Paints anew; the camera looks at `centre` [m].
    void render(const Point& centre, double pixelsPerMetre, const SectionPicture* picture);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void readPixels(const QSize& size);

    QOffscreenSurface surface_;
    QOpenGLContext context_;  // outlives what VTK keeps in it
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    SectionView view_;
    QImage image_;
};

}  // namespace keyblock
