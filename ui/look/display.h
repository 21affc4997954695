// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How numbers are displayed: the unit system and the sign convention of stresses. The
// document always uses SI units and tension positive.
#pragma once

#include "ui/picture/section/shown_numbers.h"

#include <QObject>
#include <QString>

#include <string_view>

namespace keyblock {

struct ShownUnit {
    QString symbol;
    double factor = 1.0;  // displayed value = factor · SI value
};

enum class UnitSystem { Engineering, Si };  // engineering units (mm, kN, MPa), or SI base units

class Display : public QObject {
    Q_OBJECT

public:
    explicit Display(QObject* parent = nullptr);

    UnitSystem system() const { return system_; }
    void setSystem(UnitSystem system);
    bool compressionPositive() const { return compressionPositive_; }
    void setCompressionPositive(bool positive);

    /// Unit of elastic moduli in the field table. Moduli are displayed in GPa if stresses are displayed in MPa.
    static constexpr std::string_view modulusUnit = "Pa (modulus)";

    /// The display unit for `siUnit`, which is written as in the field table; `siUnit` itself if there is no other
    /// display unit.
    ShownUnit shown(std::string_view siUnit) const;

    /// Unit system and sign convention for sections and charts.
    ShownNumbers numbers() const { return {system_ == UnitSystem::Si, !compressionPositive_}; }

    /// Text for the status bar: `mm · kN · MPa · compression +`.
    QString summary() const;

    /// Text of a number that is already in the display unit. It has at most `digits` significant digits, a true minus
    /// sign and thin spaces between thousands; `–` if the number is not finite.
    static QString number(double shown, int digits = 4);

Q_SIGNALS:
    void changed();

private:
    UnitSystem system_;
    bool compressionPositive_;
};

}  // namespace keyblock
