// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/checkpoint_bytes.h"

#include "solver/files/program_version.h"
#include "solver/files/value_bytes.h"

#include <elf.h>
#include <link.h>

#include <cstring>

namespace keyblock {

namespace {

constexpr std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// The build id in one segment of notes, as hexadecimal digits.
std::string idInNotes(std::string_view notes) {
    constexpr const char* digits = "0123456789abcdef";
    ElfW(Nhdr) head;
    while (notes.size() >= sizeof head) {
        std::memcpy(&head, notes.data(), sizeof head);
        const std::size_t start = sizeof head + padded(head.n_namesz);
        const std::size_t end = start + padded(head.n_descsz);
        if (end > notes.size())
            return {};
        if (head.n_type == NT_GNU_BUILD_ID && notes.substr(sizeof head, 3) == "GNU") {
            std::string id;
            for (const char c : notes.substr(start, head.n_descsz))
                id += {digits[static_cast<unsigned char>(c) >> 4], digits[static_cast<unsigned char>(c) & 15]};
            return id;
        }
        notes.remove_prefix(end);
    }
    return {};
}

/// Of the first object that the loader lists: the program itself.
int readBuildId(dl_phdr_info* object, std::size_t, void* id) {
    for (int i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr)& segment = object->dlpi_phdr[i];
        if (segment.p_type != PT_NOTE)
            continue;
        const auto* start = reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr);
        const std::string found = idInNotes({start, segment.p_memsz});
        if (!found.empty())
            *static_cast<std::string*>(id) = found;
    }
    return 1;
}

}  // namespace

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
    std::string id;
    dl_iterate_phdr(readBuildId, &id);
    return std::string(programVersion()) + " " + id;
}

}  // namespace keyblock
