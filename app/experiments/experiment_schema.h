#pragma once

#include "app/documents/text/json_value.h"

#include <string>

namespace halbench::app {

/// resources/schemas/experiment.schema.json, made from the table of keys.
JsonValue experimentSchema();

/// The tables of keys in resources/help/command-line.md (Markdown), made from the same table.
std::string experimentKeyTables();

} // namespace halbench::app
