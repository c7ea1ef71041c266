#pragma once

#include "app/documents/axis_loop_documents.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "widgets/controls/message_bar.h"

#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QToolButton;

namespace halbench::app {

/// Buttons that save the gains of all axes to a file and open those of one, the file that `halbench tune`
/// writes for a device with several axes. Without a file chooser they are hidden. Thread: GUI.
class AxisGainFiles : public QWidget {
    Q_OBJECT
public:
    /// `document`: of the gains as they are when Save is pressed.
    explicit AxisGainFiles(std::function<Result<JsonValue>()> document, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser);
    void setUsable(bool canOpen, bool canSave);
    /// What is told of a file that was opened and had no gains for the axes `missing`.
    static widgets::Message openedMessage(const QString& path, const std::vector<std::string>& missing);

Q_SIGNALS:
    void opened(const QString& path, const halbench::app::AxisGainsFile& gains);
    void saved(const QString& path);
    void failed(const halbench::Error& error);

protected:
    void changeEvent(QEvent* event) override;

private:
    void open();
    void save();
    void refreshWords();

    std::function<Result<JsonValue>()> m_document;
    FileChooser m_chooser;
    FileQueue m_files;
    QToolButton* m_save;
    QToolButton* m_open;
};

} // namespace halbench::app
