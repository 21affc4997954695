// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How numbers are shown: the unit system and the sign convention of stress. The
// document always uses SI and tension positive.
#pragma once

#include "ui/picture/shown_numbers.h"

#include <QObject>
#include <QString>

#include <string_view>

namespace keyblock {

struct ShownUnit {
    QString symbol;
    double factor = 1.0;  // shown = factor · SI
};

enum class UnitSystem { Engineering, Si };  // practical units (mm, kN, MPa), or SI base units

class Display : public QObject {
    Q_OBJECT

public:
    explicit Display(QObject* parent = nullptr);

    UnitSystem system() const { return system_; }
    void setSystem(UnitSystem system);
    bool compressionPositive() const { return compressionPositive_; }
    void setCompressionPositive(bool positive);

    /// The unit of an elastic modulus, which is shown in GPa where stresses are in MPa.
    static constexpr std::string_view modulusUnit = "Pa (modulus)";

    /// The display unit for an SI unit as written in the field table; the same unit if there is no other.
    ShownUnit shown(std::string_view siUnit) const;

    /// The same for pictures and charts.
    ShownNumbers numbers() const { return {system_ == UnitSystem::Si, !compressionPositive_}; }

    /// `mm · kN · MPa · compression +`, for the status bar.
    QString summary() const;

    /// A number already in the unit shown, with at most `digits` significant digits, a true minus sign and thin spaces
    /// between thousands; `–` for NaN.
    static QString number(double shown, int digits = 4);

Q_SIGNALS:
    void changed();

private:
    UnitSystem system_;
    bool compressionPositive_;
};

}  // namespace keyblock
