// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/view_settings.h"

namespace keyblock {

ViewSettings::ViewSettings(QObject* parent) : QObject(parent) {
    choice_.blocks = findQuantity(blockQuantities(), "sigma1");
    choice_.bolts = findQuantity(BoltQuantity::AxialForce);
}

void ViewSettings::choose(const ViewChoice& choice) {
    if (choice == choice_) return;
    choice_ = choice;
    Q_EMIT changed();
}

}  // namespace keyblock
