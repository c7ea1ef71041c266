#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace halbench::app {

struct FileQuestion {
    QString title;
    QString suggestedName;
    QString filter; ///< as QFileDialog writes it: "Model (*.json)"
};

/// How a panel asks for a file: the window's dialogs, a test's fixed path. Nothing below the window opens a
/// dialog itself. Both give an empty path when the user wants none.
struct FileChooser {
    std::function<QString(QWidget* parent, const FileQuestion& question)> save;
    std::function<QString(QWidget* parent, const FileQuestion& question)> open;
};

} // namespace halbench::app
