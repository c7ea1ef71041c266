#pragma once

#include "app/documents/axis_model_file.h"
#include "app/procedures/identify/axes_identification.h"
#include "app/wizards/excitation_panel.h"

#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QFormLayout;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

class ResultWords;

/// Identification of a device with several axes step by step, by the entry of its actuator's row: a form from
/// the entry's table of constants, the run, the result with its intervals. It saves the same file as the
/// batch program (resources/help/identification.md section 7). Thread: GUI.
class AxesIdentifyPanel : public ExcitationPanel {
    Q_OBJECT
public:
    explicit AxesIdentifyPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void identified(const halbench::app::AxisModelFile& model); ///< that loops can be tuned with
    void tuneRequested();

protected:
    void refreshWords() override;
    void onFileChooser() override;
    void makePlan() override;
    void start() override;

private:
    QWidget* buildForm();
    QPushButton* buildSaving();
    void refreshForm();
    Result<IdentifyConfig> config() const;
    void finish(const ResultHeader& header, const Result<IdentifyOutcome>& outcome);
    void showResult();

    QWidget* m_form = nullptr;
    QFormLayout* m_rows = nullptr;
    QComboBox* m_axis = nullptr;
    struct Constant {
        std::string symbol;
        widgets::OptionalNumberEdit* edit;
    };
    std::vector<Constant> m_constants;         ///< of the actuator whose form it is
    std::string m_model;                       ///< likewise
    std::optional<AxesIdentifyResult> m_found; ///< what is shown, refused or not
    ResultHeader m_header;                     ///< of the same
    ResultWords* m_words = nullptr;
    QPushButton* m_save = nullptr;
};

} // namespace halbench::app
