#pragma once

#include "app/procedures/relay/relay_procedure.h"
#include "app/wizards/excitation_panel.h"

class QPushButton;

namespace halbench::widgets {
class FigureView;
} // namespace halbench::widgets

namespace halbench::app {

class RelayForm;
class ResultWords;
class WordsAndPictures;

/// The relay experiment step by step: what will move, the swing, the ultimate gain with its interval. It
/// drives the same runRelay() as the batch program and saves the same file (resources/help/identification.md
/// section 9). Thread: GUI.
class RelayPanel : public ExcitationPanel {
    Q_OBJECT
public:
    explicit RelayPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void useRequested(double ultimateGain_A_per_rad, double ultimatePeriod_s); ///< by Ziegler and Nichols

protected:
    void refreshWords() override;
    void onFileChooser() override;
    void makePlan() override;
    void start() override;

private:
    QWidget* buildResult();
    QPushButton* buildSaving();
    void replan();
    void finish(const ResultHeader& header, const Result<RelayResult>& result);
    void showResult();

    std::vector<double> m_asked; ///< what the plan is of: making one takes a tenth of a second
    std::optional<RelayConfig> m_config;
    Result<RelayPlan> m_plan;
    std::optional<RelayResult> m_found; ///< what is shown, refused or not
    ResultHeader m_header;              ///< of the same

    RelayForm* m_form = nullptr;
    ResultWords* m_words = nullptr;
    widgets::FigureView* m_record = nullptr;
    WordsAndPictures* m_both = nullptr;
    QPushButton* m_save = nullptr;
};

} // namespace halbench::app
