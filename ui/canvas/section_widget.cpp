// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/section_widget.h"

#include "ui/canvas/display_check.h"

#include <QOpenGLFunctions>
#include <QPainter>
#include <QPaintEvent>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <utility>

namespace keyblock {

namespace {

// From OpenGL 1.2; missing in Qt's headers for OpenGL ES.
constexpr GLenum blueFirst = 0x80E1, wordsOfFourBytes = 0x8367;

}  // namespace

SectionWidget::SectionWidget(QWidget* parent) : QWidget(parent), view_(*renderer_) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::NoFocus);
    context_.setFormat(sectionFormat());
    context_.create();
    surface_.setFormat(context_.format());
    surface_.create();
    context_.makeCurrent(&surface_);
    window_->SetIsCurrent(true);
    window_->SetSupportsOpenGL(1);
    window_->SetOwnContext(0);
    window_->SetMapped(1);
    window_->SetMultiSamples(0);
    window_->SetFrameBlitModeToNoBlit();
    window_->OpenGLInit();
    window_->AddRenderer(renderer_);
}

SectionWidget::~SectionWidget() {
    context_.makeCurrent(&surface_);
    window_->Finalize();
}

void SectionWidget::render(const Point& centre, double pixelsPerMetre, const SectionPicture* picture) {
    const double ratio = devicePixelRatioF();
    const QSize size = (QSizeF(this->size()) * ratio).toSize();
    if (size.isEmpty() || !context_.makeCurrent(&surface_)) return;
    window_->SetSize(size.width(), size.height());
    view_.look(centre, 1.0 / (pixelsPerMetre * ratio), Point(width(), height()) * ratio, picture);
    // VTK expects this; otherwise pieces of the same line would clip each other.
    context_.functions()->glDepthFunc(GL_LEQUAL);
    window_->Render();
    readPixels(size);
    image_.setDevicePixelRatio(ratio);
    update();
}

void SectionWidget::readPixels(const QSize& size) {
    if (image_.size() != size) image_ = QImage(size, QImage::Format_RGB32);
    vtkOpenGLFramebufferObject& shown = *window_->GetDisplayFramebuffer();
    window_->GetState()->PushReadFramebufferBinding();
    shown.Bind(GL_READ_FRAMEBUFFER);
    shown.ActivateReadBuffer(0);
    context_.functions()->glReadPixels(0, 0, size.width(), size.height(), blueFirst, wordsOfFourBytes, image_.bits());
    window_->GetState()->PopReadFramebufferBinding();
    image_ = std::move(image_).mirrored();  // OpenGL counts rows from the bottom
}

void SectionWidget::paintEvent(QPaintEvent* event) {
    if (beforePaint) beforePaint();
    QPainter painter(this);
    painter.setClipRect(event->rect());
    painter.drawImage(0, 0, image_);
}

}  // namespace keyblock
