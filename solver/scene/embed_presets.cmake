# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by the build: writes OUTPUT, a source file that holds FOLDER/NAME.json for each
# of NAMES (separated by commas), for solver/scene/preset_data.h.
string(REPLACE "," ";" names "${NAMES}")
set(rows "")
foreach(name IN LISTS names)
  file(READ ${FOLDER}/${name}.json text)
  string(JSON help GET "${text}" help)
  string(JSON warning GET "${text}" warning)
  string(JSON count LENGTH "${text}" settings)
  math(EXPR last "${count} - 1")
  set(settings "")
  foreach(i RANGE ${last})
    string(JSON key MEMBER "${text}" settings ${i})
    string(JSON value GET "${text}" settings ${key})
    string(JSON type TYPE "${text}" settings ${key})
    if(type STREQUAL "STRING")
      string(APPEND settings "{\"${key}\", std::string(\"${value}\")}, ")
    else()
      string(APPEND settings "{\"${key}\", double(${value})}, ")
    endif()
  endforeach()
  string(APPEND rows "        {R\"(${help})\", R\"(${warning})\", {${settings}}},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by solver/scene/embed_presets.cmake.
#include \"solver/scene/preset_data.h\"

namespace keyblock {

const std::vector<PresetData>& presetData() {
    static const std::vector<PresetData> data{
${rows}    };
    return data;
}

}  // namespace keyblock
")
