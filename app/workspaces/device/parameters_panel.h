#pragma once

#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/device/user_presets.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace halbench::widgets {
class ParameterTable;
}

namespace halbench::app {

/// The parameters of the device: write what was changed as one transaction, presets, saving for good
/// (resources/help/monitor.md, "Parameters"). What the Drive panel commands is not among them.
class ParametersPanel : public QWidget {
    Q_OBJECT

public:
    /// `presetFolder`: of the user's presets.
    explicit ParametersPanel(Workbench& bench, QWidget* parent = nullptr,
                             const QString& presetFolder = userPresetFolder());

Q_SIGNALS:
    void savedInDevice(); ///< its values outlast its power from now on

private:
    QWidget* buildPresets();
    void connectTable();
    void onDevice();
    void showDevice(const devices::Catalogue& catalogue);
    bool isOneByOne(const std::vector<ParameterValue>& values) const;
    void onValues();
    void write(const std::vector<ParameterValue>& changed);
    void saveOnDevice();
    void loadChosen();
    void edit(const QString& title, const Result<Preset>& preset);
    void saveAs();
    void kept(const QString& name, const Result<QString>& path);
    /// Reads the folder elsewhere; `chosen` is shown then, or else what was chosen before.
    void fillPresets(const QString& chosen = {});
    void look();
    void compare(const std::vector<std::string>& names, const std::vector<double>& values);
    void tell(const Error& error);
    void tell(const QString& text, const QString& remedy);

    Workbench& m_bench;
    const QString m_folder;
    FileQueue m_files;
    widgets::ParameterTable* m_table = nullptr;
    QComboBox* m_presets = nullptr;
    QPushButton* m_load = nullptr;
    QLineEdit* m_name = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_saveOnDevice = nullptr;
    std::vector<PresetChoice> m_choices;
    std::vector<std::string> m_shown; ///< names of the parameters in the table
    std::size_t m_next = 0;           ///< to look at, for changes that others made
    bool m_isLooking = false;
    QTimer m_look;
};

} // namespace halbench::app
