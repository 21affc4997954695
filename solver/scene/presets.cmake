# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Puts the data files of the presets into keyblock_scene, in the order of `presetWords`.
set(preset_names sketch draft engineering reference)
set(preset_files)
foreach(name ${preset_names})
  list(APPEND preset_files ${CMAKE_SOURCE_DIR}/resources/presets/${name}.json)
endforeach()
list(JOIN preset_names "," joined_names)
set(preset_data ${CMAKE_BINARY_DIR}/generated/preset_data.cpp)
add_custom_command(
  OUTPUT ${preset_data}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${CMAKE_SOURCE_DIR}/resources/presets -DNAMES=${joined_names} -DOUTPUT=${preset_data}
          -P ${CMAKE_CURRENT_LIST_DIR}/embed_presets.cmake
  DEPENDS ${preset_files} ${CMAKE_CURRENT_LIST_DIR}/embed_presets.cmake
  VERBATIM)
target_sources(keyblock_scene PRIVATE ${preset_data})
