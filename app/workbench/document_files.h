#pragma once

#include "app/documents/text/json_value.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "widgets/figure/figure_file.h"

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

/// The same for any text, which may depend on the name that was chosen.
void saveText(QWidget* asking, const FileChooser& chooser, const FileQuestion& question, FileQueue& files,
              std::function<Result<std::string>(const std::string& path)> text,
              std::function<void(const QString& path, const Result<void>& written)> then);

/// Asks for a file and writes the picture to it, off the GUI thread; `refused` gets what went wrong.
/// `taken`: before the question, however long that stays open.
void savePicture(QWidget* asking, const FileChooser& chooser, const QString& suggestedName, FileQueue& files,
                 const widgets::PictureSaving& taken, std::function<void(const Error& error)> refused);
/// The same with the picture that the view shows now.
void savePicture(QWidget* asking, const FileChooser& chooser, const QString& suggestedName, FileQueue& files,
                 const widgets::FigureView& view, std::function<void(const Error& error)> refused);

} // namespace halbench::app
