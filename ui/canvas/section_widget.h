// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The section on the card inside a window: ui/view in the widget that VTK brings
// for Qt. Takes no mouse and no keys; the canvas above has them.
#pragma once

#include "ui/view/section_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>

class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace keyblock {

class SectionWidget : public QVTKOpenGLNativeWidget {
    Q_OBJECT

public:
    explicit SectionWidget(QWidget* parent);
    ~SectionWidget() override;

    SectionView& view() { return view_; }
    /// Paints the card anew; the camera looks at `centre` [m].
    void render(const Point& centre, double pixelsPerMetre, const SectionPicture* picture);

private:
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    SectionView view_;
};

}  // namespace keyblock
