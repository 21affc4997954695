# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by the build: writes OUTPUT, a source file that holds the text of every
# FOLDER/*.json, for solver/files/scene/bolt_library_texts.h.
file(GLOB files ${FOLDER}/*.json)
list(SORT files)
set(texts "")
foreach(path IN LISTS files)
  file(READ ${path} text)
  string(APPEND texts "    R\"json(${text})json\",\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by solver/files/scene/embed_texts.cmake.
#include \"solver/files/scene/bolt_library_texts.h\"

#include <array>

namespace keyblock {

std::span<const std::string_view> boltLibraryTexts() {
    static constexpr auto texts = std::to_array<std::string_view>({
${texts}    });
    return texts;
}

}  // namespace keyblock
")
