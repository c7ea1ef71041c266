#include "app/window/file_dialogs.h"

#include "widgets/controls/stop_button.h"

#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QStandardPaths>

#include <memory>

namespace halbench::app {
namespace {

/// "Model (*.json)" -> "json"
QString firstSuffix(const QString& filter) {
    return filter.section(QStringLiteral("*."), 1, 1).section(QLatin1Char(' '), 0, 0).section(')', 0, 0);
}

/// Of the recordings until a file was chosen; where the program was started says nothing to a window.
QString firstFolder(Workbench& bench) {
    const QString recordings = bench.recording().folder();
    return QDir(recordings).exists() ? recordings
                                     : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

QString ask(QWidget* parent, const FileQuestion& question, bool isSaving, Workbench& bench, QString& folder) {
    QFileDialog dialog(parent);
    dialog.setDirectory(folder.isEmpty() ? firstFolder(bench) : folder);
    dressFileDialog(dialog, question, isSaving, bench);
    if (dialog.exec() != QDialog::Accepted) {
        return {};
    }
    folder = dialog.directory().absolutePath();
    return dialog.selectedFiles().value(0);
}

} // namespace

void dressFileDialog(QFileDialog& dialog, const FileQuestion& question, bool isSaving, Workbench& bench) {
    dialog.setOption(QFileDialog::DontUseNativeDialog); // a native one has no place for STOP
    dialog.setWindowTitle(question.title);
    dialog.setNameFilter(question.filter);
    dialog.setAcceptMode(isSaving ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog.setFileMode(isSaving ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    if (isSaving) {
        dialog.setDefaultSuffix(firstSuffix(question.filter));
        dialog.selectFile(question.suggestedName);
        QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                         [&dialog](const QString& filter) { dialog.setDefaultSuffix(firstSuffix(filter)); });
    }
    auto* stop = new widgets::StopButton(widgets::StopButton::Variant::Compact, &dialog);
    QObject::connect(stop, &widgets::StopButton::stopRequested, &bench,
                     [&bench] { bench.session().stopActuator(); });
    if (auto* grid = qobject_cast<QGridLayout*>(dialog.layout())) {
        grid->addWidget(stop, grid->rowCount(), 0, 1, grid->columnCount(), Qt::AlignRight);
    }
}

FileChooser fileDialogs(Workbench& bench) {
    const auto folder = std::make_shared<QString>(); // of the last file that was chosen
    return {[&bench, folder](QWidget* parent, const FileQuestion& question) {
                return ask(parent, question, true, bench, *folder);
            },
            [&bench, folder](QWidget* parent, const FileQuestion& question) {
                return ask(parent, question, false, bench, *folder);
            }};
}

} // namespace halbench::app
