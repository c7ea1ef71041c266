// A measured frequency response in the Tune panel's open loop.
#include "app/figures/tuning_figures.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/tune_panel.h"
#include "widgets/controls/message_bar.h"

#include <QPushButton>

#include <algorithm>

namespace halbench::app {

/// Chooses one, or takes away the one that is drawn.
void TunePanel::chooseMeasured() {
    if (m_measured) {
        forgetMeasured();
        drawPredictions();
        return;
    }
    const QString path = m_chooser.open(this, {tr("Open a measured response"), {}, tr("Response (*.json)")});
    if (path.isEmpty()) {
        return;
    }
    m_files.run([path = path.toStdString()] { return readFrequencyFile(path); },
                [this](const Result<FrequencyFile>& file) {
                    if (file) {
                        useMeasured(file->plant);
                    } else {
                        showError(file.error());
                    }
                });
}

void TunePanel::useUltimate(double gain_A_per_rad, double period_s) {
    control::DesignTargets targets;
    targets.ultimateGain_A_per_rad = gain_A_per_rad;
    targets.ultimatePeriod_s = period_s;
    m_form->choose("ziegler-nichols", targets);
}

void TunePanel::useMeasured(const MeasuredPlant& plant) {
    // That it can be drawn for the gains of now is seen before it is taken.
    const control::PidGains gains = m_sketch ? m_sketch->law.gains : control::PidGains{};
    const auto loop = measuredLoop(plant, gains, m_conditions.timing);
    if (!loop) {
        showError(loop.error());
        return;
    }
    const auto used = std::count(loop->isUsed.begin(), loop->isUsed.end(), true);
    m_measured = plant;
    refreshMeasuredWords();
    m_message->showMessage(
        {widgets::Severity::Information,
         tr("Measured response shown in the open loop, with the proposed gains."),
         tr("%1 of %2 frequencies are coherent; the others are hollow.").arg(used).arg(loop->isUsed.size()),
         {}});
    drawPredictions();
}

void TunePanel::forgetMeasured() {
    m_measured.reset();
    refreshMeasuredWords();
}

std::optional<MeasuredLoop> TunePanel::drawnMeasurement() const {
    if (!m_measured || !m_sketch) {
        return std::nullopt;
    }
    const auto loop = measuredLoop(*m_measured, m_sketch->law.gains, m_conditions.timing);
    return loop ? std::optional(*loop) : std::nullopt; // of a board with another rate nothing is drawn
}

void TunePanel::refreshMeasuredWords() {
    const QString text = m_measured ? tr("Remove the response") : tr("Measured response\u2026");
    m_measure->setText(text);
    m_measure->setAccessibleName(text);
    m_measure->setToolTip(m_measured ? tr("Show only predictions in the open loop")
                                     : tr("Show the response measured with identify --frequency in the open "
                                          "loop, with the proposed gains (no motor model)"));
}

} // namespace halbench::app
