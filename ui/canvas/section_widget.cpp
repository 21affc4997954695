// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/section_widget.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace keyblock {

SectionWidget::SectionWidget(QWidget* parent) : QVTKOpenGLNativeWidget(parent), view_(*renderer_) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setEnableHiDPI(true);
    window_->SetMultiSamples(0);
    window_->AddRenderer(renderer_);
    setRenderWindow(window_.Get());
}

SectionWidget::~SectionWidget() = default;

void SectionWidget::render(const Point& centre, double pixelsPerMetre, const SectionPicture* picture) {
    const double ratio = devicePixelRatioF();
    view_.look(centre, 1.0 / (pixelsPerMetre * ratio), Point(width(), height()) * ratio, picture);
    window_->Render();
}

}  // namespace keyblock
