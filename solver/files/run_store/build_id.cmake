# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Names the mechanics that a program holds: the same for every program that is linked from the same libraries, so that
# the command line goes on with a run of the window, and another one once a line of the mechanics has changed.
set(mechanics keyblock_geometry keyblock_scene keyblock_results keyblock_engine keyblock_run)
file(GLOB_RECURSE files_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/solver/files/*.cpp ${CMAKE_SOURCE_DIR}/solver/files/*.h)
set(hashed ${files_sources})
foreach(library ${mechanics})
  list(APPEND hashed $<TARGET_FILE:${library}>)
endforeach()
set(build_id ${CMAKE_BINARY_DIR}/generated/build_id.cpp)
add_custom_command(
  OUTPUT ${build_id}
  COMMAND ${CMAKE_COMMAND} "-DFILES=${hashed}" -DOUTPUT=${build_id} -P ${CMAKE_CURRENT_LIST_DIR}/hash_files.cmake
  DEPENDS ${mechanics} ${hashed} ${CMAKE_CURRENT_LIST_DIR}/hash_files.cmake
  VERBATIM)
target_sources(keyblock_files PRIVATE ${build_id})
