// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes to a store as someone would make them who wants it to be read: with the
// checksums that belong to the changed rows.
#pragma once

#include "solver/files/run_store/run_schema.h"
#include "solver/files/run_store/sqlite.h"

namespace keyblock::test {

inline void seal(sqlite::Database& database) {
    const std::pair<const char*, const char*> tables[]{{"about", run_schema::aboutColumns},
                                                       {"stages", run_schema::stageColumns},
                                                       {"events", run_schema::eventColumns},
                                                       {"history", run_schema::historyColumns},
                                                       {"frames", run_schema::headColumns}};
    for (const auto& [table, columns] : tables)
        database.run(std::string("UPDATE ") + table + " SET checksum = row_checksum(" + columns + ")");
    database.run(std::string("UPDATE frames SET payload_checksum = row_checksum(") + run_schema::payloadColumns + ")");
}

}  // namespace keyblock::test
