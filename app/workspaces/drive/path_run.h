#pragma once

#include "app/procedures/excite/table_reference.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"

#include <QObject>

#include <utility>
#include <vector>

namespace halbench::app {

class PathForm;

/// The path of several axes or table of poses of a form: its file is read, it is judged against the device
/// and started.
class PathRun : public QObject {
    Q_OBJECT

public:
    PathRun(Workbench& bench, PathForm& form, QObject* parent = nullptr);
    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

    /// Errors: of the form, of the axes of the device, of the windows (a table).
    Result<void> start();

    /// What starting would do, before it is done.
    struct Outlook {
        QString text;
        bool isWrong = false; ///< beyond a limit, or none of this device
    };
    Outlook outlook() const;

private:
    void chooseTable();
    Result<std::vector<devices::AxisSpec>> movedAxes(const MoveReference& reference) const;
    std::vector<TableAxisLimits> limitsOf(const std::vector<devices::AxisSpec>& axes) const;

    Workbench& m_bench;
    PathForm& m_form;
    FileChooser m_chooser;
    FileQueue m_files;
};

} // namespace halbench::app
