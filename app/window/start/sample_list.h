#pragma once

#include "app/workbench/file_queue.h"

#include <QWidget>

namespace halbench::app {

class StartList;

/// Sample recordings that come with the program, and the tour of the window: a newcomer begins with them.
class SampleList : public QWidget {
    Q_OBJECT

public:
    explicit SampleList(QWidget* parent);

Q_SIGNALS:
    void recordingChosen(const QString& path); ///< of the copy
    void tourRequested();

private:
    void open(const QString& file);

    StartList* m_list = nullptr;
    FileQueue m_files;
};

} // namespace halbench::app
