// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/display.h"

#include <QSettings>

#include <array>
#include <cmath>

namespace keyblock {

namespace {

struct UnitRow {
    std::string_view si;
    const char* symbol;
    double factor;
};

// Lengths of a section stay in metres: they are drawn and typed in metres.
constexpr std::array engineering{
    UnitRow{Display::modulusUnit, "GPa", 1e-9},
    UnitRow{"Pa", "MPa", 1e-6},          UnitRow{"Pa/m", "MPa/m", 1e-6},    UnitRow{"N", "kN", 1e-3},
    UnitRow{"N/m", "kN/m", 1e-3},        UnitRow{"N m", "kN m", 1e-3},      UnitRow{"N·m", "kN m", 1e-3},
    UnitRow{"J", "kJ", 1e-3},            UnitRow{"N/m per m", "MN/m²", 1e-6},  UnitRow{"N/m³", "kN/m³", 1e-3},
};

constexpr double plainBelow = 1e6;  // larger numbers have powers of ten

}  // namespace

Display::Display(QObject* parent)
    : QObject(parent),
      system_(QSettings().value("display/si", false).toBool() ? UnitSystem::Si : UnitSystem::Engineering),
      compressionPositive_(QSettings().value("display/compressionPositive", true).toBool()) {}

void Display::setSystem(UnitSystem system) {
    if (system == system_) return;
    system_ = system;
    QSettings().setValue("display/si", system == UnitSystem::Si);
    Q_EMIT changed();
}

void Display::setCompressionPositive(bool positive) {
    if (positive == compressionPositive_) return;
    compressionPositive_ = positive;
    QSettings().setValue("display/compressionPositive", positive);
    Q_EMIT changed();
}

ShownUnit Display::shown(std::string_view siUnit) const {
    if (system_ == UnitSystem::Engineering)
        for (const UnitRow& row : engineering)
            if (row.si == siUnit) return {QString::fromUtf8(row.symbol), row.factor};
    if (siUnit == modulusUnit) return {QStringLiteral("Pa"), 1.0};
    return {QString::fromUtf8(siUnit.data(), static_cast<int>(siUnit.size())), 1.0};
}

QString Display::summary() const {
    const QString units = system_ == UnitSystem::Si ? tr("m · N · Pa") : tr("mm · kN · MPa");
    return units + QString::fromUtf8(" · ") + (compressionPositive_ ? tr("compression +") : tr("tension +"));
}

QString Display::number(double shown, int digits) {
    if (!std::isfinite(shown)) return QString::fromUtf8("–");
    QString text = QString::number(shown == 0.0 ? 0.0 : shown, 'g', digits);  // zero has no sign
    const bool isWhole = std::abs(shown) >= 1.0 && std::abs(shown) < plainBelow;
    if (isWhole && text.contains('e')) text = QString::number(text.toDouble(), 'f', 0);  // 1000, not 1e3
    const int exponent = text.indexOf('e');
    if (exponent < 0) {
        const int point = text.indexOf('.');
        const int first = text.startsWith('-') ? 1 : 0;
        for (int at = (point < 0 ? text.size() : point) - 3; at > first; at -= 3)
            text.insert(at, QChar(0x2009));
    }
    if (exponent >= 0) {  // 1e-5, not 1e-05
        int at = exponent + 1;
        if (text[at] == '+') text.remove(at, 1);
        else ++at;
        while (at + 1 < text.size() && text[at] == '0') text.remove(at, 1);
    }
    return text.replace('-', QChar(0x2212));
}

}  // namespace keyblock
