#include "app/workspaces/document_files.h"

#include "app/batch/output_file.h"

namespace halbench::app {

void saveDocument(QWidget* asking, const FileChooser& chooser, const FileQuestion& question, FileQueue& files,
                  std::function<JsonValue()> document,
                  std::function<void(const QString& path, const Result<void>& written)> then) {
    const QString path = chooser.save ? chooser.save(asking, question) : QString();
    if (path.isEmpty()) {
        return;
    }
    files.run(
        [path = path.toStdString(), document = std::move(document)]() -> Result<void> {
            const auto text = toJsonText(document());
            return text ? writeFile(path, *text) : failure(text.error());
        },
        [path, then = std::move(then)](const Result<void>& written) { then(path, written); });
}

} // namespace halbench::app
