#pragma once

#include "app/documents/model_file.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"

#include <QWidget>

class QToolButton;

namespace halbench::widgets {
struct Message;
}

namespace halbench::app {

class TuneSession;

/// Buttons that save the proposed gains to a file, as a document or as C code, and open those of one. Without
/// a file chooser they are hidden. Thread: GUI.
class GainFiles : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives it.
    GainFiles(Workbench& bench, const TuneSession& session, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser);
    void setCanSave(bool canSave);

Q_SIGNALS:
    void opened(const halbench::app::LoopLaw& law, const QString& fileName);
    /// After opened(): what was found of their device and timing; or a file was saved.
    void told(const halbench::widgets::Message& message);
    void failed(const halbench::Error& error);

protected:
    void changeEvent(QEvent* event) override;

private:
    void open();
    void take(const QString& path, const Result<GainsFile>& gains);
    void save();
    void refreshTexts();

    Workbench& m_bench;
    const TuneSession& m_session;
    FileChooser m_chooser;
    FileQueue m_files;
    LatestTask m_opening;
    QToolButton* m_save;
    QToolButton* m_open;
};

} // namespace halbench::app
