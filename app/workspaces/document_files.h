#pragma once

#include "app/batch/json_value.h"
#include "app/workspaces/file_chooser.h"
#include "app/workspaces/file_queue.h"

#include <functional>

namespace halbench::app {

/// Asks for a file and writes the document to it off the GUI thread; `then` gets the path and the outcome on
/// the GUI thread. Nothing happens when the user wants no file.
void saveDocument(QWidget* asking, const FileChooser& chooser, const FileQuestion& question, FileQueue& files,
                  std::function<JsonValue()> document,
                  std::function<void(const QString& path, const Result<void>& written)> then);

} // namespace halbench::app
