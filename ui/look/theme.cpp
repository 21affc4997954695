// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/theme.h"

#include <QApplication>
#include <QFile>
#include <QFont>
#include <QHash>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSettings>
#include <QStyleFactory>
#include <QSvgRenderer>

#include <algorithm>

namespace keyblock {

namespace {

QColor withAlpha(QColor colour, double alpha) {
    colour.setAlphaF(alpha);
    return colour;
}

Theme makeLight() {
    Theme t;
    t.window = "#F3F4F6"; t.panel = "#FFFFFF"; t.header = "#F8F9FA"; t.field = "#FFFFFF";
    t.separator = "#E2E5EA"; t.border = "#CCD1D9";
    t.text = "#1A212C"; t.text2 = "#535D6C"; t.text3 = "#6B7584";
    t.accent = "#4350C4"; t.accentSoft = "#ECEEFB"; t.accentRow = "#DFE3FA"; t.onAccent = "#FFFFFF";
    t.ok = "#1B7F55"; t.warning = "#A96400"; t.warningFill = "#E69F00"; t.warningSoft = "#FFF6E3";
    t.error = "#C2262E"; t.errorSoft = "#FDECEC";
    t.canvas = "#F7F7F5"; t.opening = "#FDFDFC"; t.rock = "#EDEBE6"; t.wall = "#202935";
    t.jointLine = withAlpha("#3F4A57", 0.7); t.jointDrawing = "#66717E"; t.chartGrid = "#ECEEF1";
    t.markInk = "#18202B"; t.markCasing = "#FFFFFF"; t.slipping = "#E69F00"; t.yielded = "#A8338F";
    return t;
}

Theme makeDark() {
    Theme t;
    t.dark = true;
    t.window = "#14171C"; t.panel = "#1B1F26"; t.header = "#20252C"; t.field = "#15191F";
    t.separator = "#2B313A"; t.border = "#3D4551";
    t.text = "#E5E9EF"; t.text2 = "#A7B0BD"; t.text3 = "#7D8897";
    t.accent = "#97A2FF"; t.accentSoft = "#262B4A"; t.accentRow = "#31386A"; t.onAccent = "#11141C";
    t.ok = "#4CC38A"; t.warning = "#F0B64A"; t.warningFill = "#F0B64A"; t.warningSoft = "#33291A";
    t.error = "#FF7A72"; t.errorSoft = "#3A2022";
    t.canvas = "#0F1216"; t.opening = "#15191F"; t.rock = "#2B313A"; t.wall = "#C9D2DD";
    t.jointLine = "#0C0F13"; t.jointDrawing = "#0C0F13"; t.chartGrid = "#262C35";
    t.markInk = "#F1F4F8"; t.markCasing = "#0B0D11"; t.slipping = "#FFC04D"; t.yielded = "#E58BD0";
    return t;
}

QPalette paletteOf(const Theme& t) {
    QPalette p;
    p.setColor(QPalette::Window, t.window);
    p.setColor(QPalette::WindowText, t.text);
    p.setColor(QPalette::Base, t.panel);
    p.setColor(QPalette::AlternateBase, t.header);
    p.setColor(QPalette::Text, t.text);
    p.setColor(QPalette::PlaceholderText, t.text3);
    p.setColor(QPalette::Button, t.panel);
    p.setColor(QPalette::ButtonText, t.text);
    p.setColor(QPalette::ToolTipBase, t.panel);
    p.setColor(QPalette::ToolTipText, t.text);
    p.setColor(QPalette::Highlight, t.accentRow);
    p.setColor(QPalette::HighlightedText, t.text);
    p.setColor(QPalette::Link, t.accent);
    p.setColor(QPalette::Mid, t.border);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, t.text3);
    return p;
}

QHash<QString, QColor> rolesOf(const Theme& t) {
    return {{"window", t.window}, {"panel", t.panel}, {"header", t.header}, {"field", t.field},
            {"separator", t.separator}, {"border", t.border}, {"text", t.text}, {"text2", t.text2},
            {"text3", t.text3}, {"accent", t.accent}, {"accentSoft", t.accentSoft}, {"accentRow", t.accentRow},
            {"onAccent", t.onAccent}, {"ok", t.ok}, {"warning", t.warning}, {"warningFill", t.warningFill},
            {"warningSoft", t.warningSoft}, {"error", t.error}, {"errorSoft", t.errorSoft}, {"canvas", t.canvas}};
}

QByteArray resource(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Replaces long role names first, so that `@text` does not replace the beginning of `@text2`.
QString styleSheetOf(const Theme& theme) {
    QString sheet = QString::fromUtf8(resource(":/look/studio.qss"));
    const QHash<QString, QColor> roles = rolesOf(theme);
    QStringList names = roles.keys();
    std::sort(names.begin(), names.end(), [](const QString& a, const QString& b) { return a.size() > b.size(); });
    sheet.replace("@theme", theme.dark ? "dark" : "light");  // part of the names of icons
    for (const QString& name : names) sheet.replace('@' + name, roles[name].name());
    return sheet;
}

/// Adds the icon at 1, 1.5, 2 and 3 times its size, so that it is sharp on any screen.
void addDrawing(QIcon& icon, const QByteArray& drawing, const QColor& colour, QIcon::Mode mode, QIcon::State state) {
    QByteArray inked = drawing;
    inked.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(inked);
    for (const int size : {16, 18, 24, 32, 36, 48}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        renderer.render(&painter);
        icon.addPixmap(pixmap, mode, state);
    }
}

}  // namespace

const Theme& lightTheme() {
    static const Theme theme = makeLight();
    return theme;
}

const Theme& darkTheme() {
    static const Theme theme = makeDark();
    return theme;
}

Themes::Themes(QObject* parent) : QObject(parent), dark_(QSettings().value("look/dark", false).toBool()) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    apply();
}

const Theme& Themes::current() const { return dark_ ? darkTheme() : lightTheme(); }

void Themes::choose(bool dark) {
    if (dark == dark_) return;
    dark_ = dark;
    QSettings().setValue("look/dark", dark);
    apply();
    Q_EMIT changed();
}

QIcon Themes::icon(const QString& name) const {
    const Theme& t = current();
    QIcon& icon = inked_[name + (dark_ ? "/dark" : "/light")];
    if (!icon.isNull()) return icon;
    const QByteArray drawing = resource(":/icons/" + name + ".svg");
    if (drawing.isEmpty()) return icon;
    addDrawing(icon, drawing, t.text2, QIcon::Normal, QIcon::Off);
    addDrawing(icon, drawing, t.accent, QIcon::Normal, QIcon::On);
    addDrawing(icon, drawing, t.text3, QIcon::Disabled, QIcon::Off);
    addDrawing(icon, drawing, t.text3, QIcon::Disabled, QIcon::On);
    return icon;
}

QIcon Themes::icon(const QString& name, const QColor& colour) const {
    QIcon& icon = inked_[name + colour.name()];
    if (!icon.isNull()) return icon;
    const QByteArray drawing = resource(":/icons/" + name + ".svg");
    if (!drawing.isEmpty()) addDrawing(icon, drawing, colour, QIcon::Normal, QIcon::Off);
    return icon;
}

void Themes::apply() const {
    QFont font("Inter");
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(12);
    QApplication::setFont(font);
    QApplication::setPalette(paletteOf(current()));
    qApp->setStyleSheet(styleSheetOf(current()));
}

}  // namespace keyblock
