// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section in a window: ui/view renders into an off-screen OpenGL buffer, and the
// pixels are painted on the widget like any other image. With an OpenGL widget, the
// GPU would compose the whole window whenever a label changes, which without a GPU
// takes more time than the section itself. Takes no mouse and key input; the canvas
// above it does.
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
    /// Called before each painting to render pending changes, so that the marks above use the same camera.
    std::function<void()> beforePaint;
    /// Renders again; the camera looks at `centre` [m].
    void render(const Point& centre, double pixelsPerMetre, const SectionPicture* picture);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void readPixels(const QSize& size);

    QOffscreenSurface surface_;
    QOpenGLContext context_;  // must outlive VTK's objects in it
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    SectionView view_;
    QImage image_;
};

}  // namespace keyblock
