# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Puts the bolt library's data files into keyblock_files.
file(GLOB bolt_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/resources/bolts/*.json)
set(bolt_texts ${CMAKE_BINARY_DIR}/generated/bolt_library_texts.cpp)
add_custom_command(
  OUTPUT ${bolt_texts}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${CMAKE_SOURCE_DIR}/resources/bolts -DOUTPUT=${bolt_texts}
          -P ${CMAKE_CURRENT_LIST_DIR}/embed_texts.cmake
  DEPENDS ${bolt_files} ${CMAKE_CURRENT_LIST_DIR}/embed_texts.cmake
  VERBATIM)
target_sources(keyblock_files PRIVATE ${bolt_texts})
