#pragma once

#include "app/workbench/document_files.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"
#include "widgets/actuators/actuator_view.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace halbench::app {

/// The row of the registry of views that fits a device; nullptr when none does.
const widgets::ActuatorView* pictureOf(const devices::Catalogue& catalogue);
bool hasPicture(const devices::Catalogue& catalogue);

/// Live picture of the connected actuator: the first row of the registry of views whose signals the device
/// has (resources/help/monitor.md, "Field").
class FieldPanel : public QWidget {
    Q_OBJECT

public:
    explicit FieldPanel(Workbench& bench, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

private:
    void onDevice();
    void choose(const widgets::ActuatorView& view);
    void addTool(QAction* action);
    void onSamples();
    void savePicture();
    widgets::ActuatorValues values() const;

    Workbench& m_bench;
    QHBoxLayout* m_tools = nullptr;
    QPushButton* m_save = nullptr;
    QVBoxLayout* m_place = nullptr;
    const widgets::ActuatorView* m_view = nullptr;
    widgets::ActuatorPicture* m_picture = nullptr;
    QLabel* m_numbers = nullptr;
    QLabel* m_words = nullptr;
    FileChooser m_chooser;
    FileQueue m_files;
};

} // namespace halbench::app
