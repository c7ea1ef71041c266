#include "app/workspaces/tune/measured_overlay.h"

#include "app/workspaces/tune/tune_session.h"
#include "widgets/controls/message_bar.h"

#include <QEvent>

#include <algorithm>
#include <utility>

namespace halbench::app {

MeasuredOverlay::MeasuredOverlay(const TuneSession& session, QWidget* parent)
    : QPushButton(parent), m_session(session) {
    hide();
    connect(this, &QPushButton::clicked, this, &MeasuredOverlay::choose);
    refreshTexts();
}

void MeasuredOverlay::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    setVisible(bool(m_chooser.open));
}

/// Chooses a response, or takes away the one that is drawn.
void MeasuredOverlay::choose() {
    if (m_plant) {
        forget();
        Q_EMIT changed();
        return;
    }
    const QString path = m_chooser.open(this, {tr("Open a measured response"), {}, tr("Response (*.json)")});
    if (path.isEmpty()) {
        return;
    }
    m_files.run([path = path.toStdString()] { return readFrequencyFile(path); },
                [this](const Result<FrequencyFile>& file) {
                    if (file) {
                        use(file->plant);
                    } else {
                        Q_EMIT failed(file.error());
                    }
                });
}

void MeasuredOverlay::use(const MeasuredPlant& plant) {
    // That it can be drawn for the present gains is seen before it is taken.
    const auto& sketch = m_session.sketch();
    const control::PidGains gains = sketch ? sketch->law.gains : control::PidGains{};
    const auto measured = measuredLoop(plant, gains, m_session.conditions().timing);
    if (!measured) {
        Q_EMIT failed(measured.error());
        return;
    }
    const auto coherent = std::count(measured->isUsed.begin(), measured->isUsed.end(), true);
    m_plant = plant;
    refreshTexts();
    Q_EMIT used({widgets::Severity::Information,
                 tr("Measured response shown in the open loop, with the proposed gains."),
                 tr("%1 of %2 frequencies are coherent; the others are hollow.")
                     .arg(coherent)
                     .arg(measured->isUsed.size()),
                 {}});
    Q_EMIT changed();
}

void MeasuredOverlay::forget() {
    m_plant.reset();
    refreshTexts();
}

std::optional<MeasuredLoop> MeasuredOverlay::loop() const {
    const auto& sketch = m_session.sketch();
    if (!m_plant || !sketch) {
        return std::nullopt;
    }
    const auto measured = measuredLoop(*m_plant, sketch->law.gains, m_session.conditions().timing);
    return measured ? std::optional(*measured) : std::nullopt;
}

void MeasuredOverlay::refreshTexts() {
    setText(m_plant ? tr("Remove the response") : tr("Measured response\u2026"));
    setAccessibleName(text());
    setToolTip(m_plant ? tr("Show only predictions in the open loop")
                       : tr("Show the response measured with identify --frequency in the open "
                            "loop, with the proposed gains (no motor model)"));
}

void MeasuredOverlay::changeEvent(QEvent* event) {
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshTexts();
    }
}

} // namespace halbench::app
