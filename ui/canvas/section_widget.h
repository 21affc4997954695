// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section in a window: ui/view renders into an off-screen OpenGL buffer, and its
// pixels are painted on the widget like any other image. With an OpenGL widget, the GPU
// would compose the whole window whenever a label changes, which takes more time than
// the section itself if there is no GPU. The widget takes no mouse or key input; the
// canvas above it does.
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
    /// Called before each painting to render pending changes, so that the marks painted on top use the same camera.
    std::function<void()> beforePaint;
    /// Renders the section with the view centred on `centre` [m]. \param picture the picture shown, or null.
    void render(const Point& centre, double pixelsPerMetre, const SectionPicture* picture);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void readPixels(const QSize& size);

    QOffscreenSurface surface_;
    QOpenGLContext context_;  // must outlive the VTK objects created in it
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    SectionView view_;
    QImage image_;
};

}  // namespace keyblock
