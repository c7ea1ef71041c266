#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workspaces/tune/axes/axis_loops.h"

#include <QPushButton>

#include <map>
#include <string>

namespace halbench::app {

/// Opens the frequency response that `halbench identify --frequency` wrote for a device with several axes.
/// Hidden without a file chooser. Thread: GUI.
class AxisResponseButton : public QPushButton {
    Q_OBJECT
public:
    /// `loops`: whose model decides what fits; they outlive the button.
    explicit AxisResponseButton(const AxisLoops& loops, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser);

Q_SIGNALS:
    void opened(const std::map<std::string, halbench::app::MeasuredPlant>& plants); ///< those of the axes
    void failed(const halbench::Error& error);

protected:
    void changeEvent(QEvent* event) override;

private:
    void open();
    void refreshWords();

    const AxisLoops& m_loops;
    FileChooser m_chooser;
    FileQueue m_files;
};

} // namespace halbench::app
