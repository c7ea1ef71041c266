#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/workbench.h"

class QFileDialog;

namespace halbench::app {

/// The window's file dialogs, for the panels; each carries a small STOP.
FileChooser fileDialogs(Workbench& bench);

/// Prepares such a dialog: question, suggested name, STOP.
void dressFileDialog(QFileDialog& dialog, const FileQuestion& question, bool isSaving, Workbench& bench);

} // namespace halbench::app
