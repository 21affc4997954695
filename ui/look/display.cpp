// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/display.h"

#include "solver/scene/units.h"

#include <QSettings>

#include <cmath>
#include <optional>

namespace keyblock {

namespace {

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

ShownUnit practicalUnit(std::string_view symbol) {
    const std::optional<Unit> unit = readUnit(symbol);
    return {textOf(symbol), unit ? perSi(*unit) : 1.0};
}

constexpr double plainBelow = 1e6;  // larger numbers are written with powers of ten

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
    const bool practical = system_ == UnitSystem::Engineering;
    if (siUnit == modulusUnit) return practical ? practicalUnit("GPa") : ShownUnit{QStringLiteral("Pa"), 1.0};
    if (practical)
        for (const PracticalUnit& row : practicalUnits())
            if (row.si == siUnit && row.use != UnitUse::Pictures) return practicalUnit(row.practical);
    return {textOf(siUnit), 1.0};
}

QString Display::summary() const {
    const QString units = system_ == UnitSystem::Si ? tr("m · N · Pa") : tr("mm · kN · MPa");
    return units + QString::fromUtf8(" · ") + (compressionPositive_ ? tr("compression +") : tr("tension +"));
}

QString Display::number(double shown, int digits) {
    if (!std::isfinite(shown)) return QString::fromUtf8("–");
    QString text = QString::number(shown == 0.0 ? 0.0 : shown, 'g', digits);  // zero is shown without a sign
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
