// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/references.h"

namespace keyblock {

std::vector<int> rebarOrder(int divisions, int releases) {
    const int last = divisions == 59 ? 30 : 31;  // index of the first node beyond the joint
    const int pairs = releases - 30;
    std::vector<int> order;
    for (int i = 0; i < 30; ++i) {
        order.push_back(29 - i);
        if (i < pairs) order.push_back(last + i);
    }
    return order;
}

}  // namespace keyblock
