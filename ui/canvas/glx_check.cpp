// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In a separate file because the X headers define macros with common names.
#include "ui/canvas/glx_check.h"

#include <GL/glx.h>
#include <X11/Xlib.h>

namespace keyblock {

namespace {

int ignoreError(Display*, XErrorEvent*) { return 0; }

bool canDraw(Display* display) {
    int event = 0, error = 0;
    if (!glXQueryExtension(display, &error, &event)) return false;
    const int wanted[]{GLX_X_RENDERABLE, True, GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT, GLX_RENDER_TYPE, GLX_RGBA_BIT,
                       GLX_DOUBLEBUFFER, True, None};
    int count = 0;
    GLXFBConfig* found = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
    if (!found) return false;
    bool direct = false;
    if (count > 0)
        if (GLXContext context = glXCreateNewContext(display, found[0], GLX_RGBA_TYPE, nullptr, True)) {
            direct = glXIsDirect(display, context);
            glXDestroyContext(display, context);
        }
    XFree(found);
    XSync(display, False);
    return direct;
}

}  // namespace

bool glxWorks() {
    Display* display = XOpenDisplay(nullptr);
    if (!display) return false;
    const XErrorHandler before = XSetErrorHandler(ignoreError);
    const bool works = canDraw(display);
    XSync(display, False);
    XSetErrorHandler(before);
    XCloseDisplay(display);
    return works;
}

}  // namespace keyblock
