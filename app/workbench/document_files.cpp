#include "app/workbench/document_files.h"

#include "app/documents/text/output_file.h"
#include "widgets/figure/figure_view.h"

#include <QCoreApplication>

namespace halbench::app {

namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::DocumentFiles)
};

void savePictureAs(QWidget* asking, const FileChooser& chooser, const FileQuestion& question,
                   FileQueue& files, const widgets::PictureSaving& taken,
                   std::function<void(const Error& error)> refused) {
    const QString path = chooser.save ? chooser.save(asking, question) : QString();
    if (path.isEmpty()) {
        return;
    }
    files.run(taken(path), [refused = std::move(refused)](const Result<void>& saved) {
        if (!saved) {
            refused(saved.error());
        }
    });
}

} // namespace

void saveDocument(QWidget* asking, const FileChooser& chooser, const FileQuestion& question, FileQueue& files,
                  std::function<JsonValue()> document,
                  std::function<void(const QString& path, const Result<void>& written)> then) {
    saveText(
        asking, chooser, question, files,
        [document = std::move(document)](const std::string&) { return toJsonText(document()); },
        std::move(then));
}

void saveText(QWidget* asking, const FileChooser& chooser, const FileQuestion& question, FileQueue& files,
              std::function<Result<std::string>(const std::string& path)> text,
              std::function<void(const QString& path, const Result<void>& written)> then) {
    const QString path = chooser.save ? chooser.save(asking, question) : QString();
    if (path.isEmpty()) {
        return;
    }
    files.run(
        [path = path.toStdString(), text = std::move(text)]() -> Result<void> {
            const auto content = text(path);
            return content ? writeFile(path, *content) : failure(content.error());
        },
        [path, then = std::move(then)](const Result<void>& written) { then(path, written); });
}

void savePicture(QWidget* asking, const FileChooser& chooser, const QString& suggestedName, FileQueue& files,
                 const widgets::PictureSaving& taken, std::function<void(const Error& error)> refused) {
    savePictureAs(asking, chooser,
                  {Words::tr("Save picture"), suggestedName, Words::tr("Picture (*.svg *.pdf *.png)")}, files,
                  taken, std::move(refused));
}

void savePicture(QWidget* asking, const FileChooser& chooser, const QString& suggestedName, FileQueue& files,
                 const widgets::FigureView& view, std::function<void(const Error& error)> refused) {
    const QString kinds =
        Words::tr("Picture (*.svg *.pdf *.png)") + QStringLiteral(";;") + Words::tr("Plotted data (*.csv)");
    savePictureAs(asking, chooser, {Words::tr("Save picture"), suggestedName, kinds}, files, view.taken(),
                  std::move(refused));
}

} // namespace halbench::app
