#pragma once

#include "app/batch/json_value.h"
#include "app/workspaces/file_chooser.h"
#include "app/workspaces/file_queue.h"

#include <functional>

namespace halbench::widgets {
class FigureView;
}

namespace halbench::app {

/// Asks for a file and writes the document to it off the GUI thread; `then` gets the path and the outcome on
/// the GUI thread. Nothing happens when the user wants no file.
void saveDocument(QWidget* asking, const FileChooser& chooser, const FileQuestion& question, FileQueue& files,
                  std::function<JsonValue()> document,
                  std::function<void(const QString& path, const Result<void>& written)> then);

/// Asks for a file and writes what the view shows to it, off the GUI thread; `refused` gets what went wrong.
void savePicture(QWidget* asking, const FileChooser& chooser, const QString& suggestedName, FileQueue& files,
                 const widgets::FigureView& view, std::function<void(const Error& error)> refused);

} // namespace halbench::app
