#include "app/window/file_dialogs.h"

#include "widgets/controls/stop_button.h"

#include <QFileDialog>
#include <QGridLayout>

namespace halbench::app {
namespace {

/// "Model (*.json)" -> "json"
QString firstSuffix(const QString& filter) {
    return filter.section(QStringLiteral("*."), 1, 1).section(QLatin1Char(' '), 0, 0).section(')', 0, 0);
}

QString ask(QWidget* parent, const FileQuestion& question, bool isSaving, Workbench& bench) {
    QFileDialog dialog(parent);
    dressFileDialog(dialog, question, isSaving, bench);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
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
    return {[&bench](QWidget* parent, const FileQuestion& question) {
                return ask(parent, question, true, bench);
            },
            [&bench](QWidget* parent, const FileQuestion& question) {
                return ask(parent, question, false, bench);
            }};
}

} // namespace halbench::app
