# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by the build: writes OUTPUT, a source file that tells one hash of all FILES,
# for solver/files/run_store/build_id.h.
set(hashes "")
foreach(path IN LISTS FILES)
  file(SHA256 ${path} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 hash "${hashes}")
string(SUBSTRING ${hash} 0 40 id)
file(WRITE ${OUTPUT} "// Made by solver/files/run_store/hash_files.cmake.
#include \"solver/files/run_store/build_id.h\"

namespace keyblock {

std::string_view buildId() { return \"${id}\"; }

}  // namespace keyblock
")
