// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/checkpoint_bytes.h"

#include "solver/files/run_store/build_id.h"
#include "solver/files/program_version.h"
#include "solver/files/run_store/value_bytes.h"

namespace keyblock {

template <>
inline constexpr int enumeratorCount<LimitKind> = static_cast<int>(LimitKind::PeakFriction) + 1;
template <>
inline constexpr int enumeratorCount<Outcome> = static_cast<int>(Outcome::Undecided) + 1;
template <>
inline constexpr int enumeratorCount<Movement> = static_cast<int>(Movement::Follows) + 1;

std::string bytesOf(const Checkpoint& checkpoint) {
    ValueWriter writer;
    writer.put(checkpoint);
    return writer.bytes();
}

std::optional<Checkpoint> checkpointOf(std::string_view bytes) {
    std::optional<Checkpoint> checkpoint(std::in_place);
    ValueReader reader(bytes);
    reader.get(*checkpoint);
    return reader.whole() ? std::move(checkpoint) : std::nullopt;
}

std::string buildName() {
    return std::string(programVersion()) + " " + std::string(buildId());
}

}  // namespace keyblock
